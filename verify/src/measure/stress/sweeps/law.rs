//! What the laws are given: penalty, traction, coefficient of friction.

use super::sweep::{FAMILIES, Sweep, slipped};

pub const PENALTY: Sweep = Sweep {
    name: "penalty",
    parameter: "penalty",
    range: [1e-6, 1e15],
    zero: false,
    series: FAMILIES,
    deform: |scene, value| {
        scene.set_penalty(value);
        Some(())
    },
};

pub const TRACTION: Sweep = Sweep {
    name: "traction",
    parameter: "traction",
    range: [1.0, 1e-300],
    zero: false,
    series: FAMILIES,
    deform: |scene, value| {
        // tangential stiffnesses below 1e-200 are refused by the status law
        let least = match scene.pair.tangential {
            Some(_) => 1e-190,
            None => 0.0,
        };
        scene.set_penalty(value.max(least) / scene.gap.abs());
        Some(())
    },
};

pub const FRICTION: Sweep = Sweep {
    name: "friction",
    parameter: "coefficient of friction",
    range: [1e-6, 1e3],
    zero: true,
    series: &[
        slipped("PointTri3Coulomb"),
        slipped("PointQuad4Coulomb"),
        slipped("PointQuad9Coulomb"),
        slipped("PointRationalSurface2Coulomb"),
        slipped("PointHermiteCoulomb"),
        slipped("HermiteHermiteBeamsCoulomb"),
        slipped("Line2Line2EdgesCoulomb"),
        slipped("HermiteQuad4OrthotropicAtPoint"),
        slipped("PointQuad4Orthotropic"),
        slipped("Quad4Quad4Coulomb"),
        slipped("PointLine3Coulomb2d"),
        slipped("PointCylinderCoulomb"),
    ],
    deform: |scene, value| {
        // the range of orthotropic laws is open at zero
        let second = 0.6 * value.max(f64::MIN_POSITIVE);
        let first = if scene.is_orthotropic() {
            second / 0.6
        } else {
            value
        };
        scene.set_friction([first, second]);
        Some(())
    },
};
