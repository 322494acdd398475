//! Where the contact is: origin, size, gap, angle between curves, focal surface.

use super::sweep::{FAMILIES, Sweep, normal, slips, sticks};
use crate::oracle::pair::GapKind;

pub const ORIGIN: Sweep = Sweep {
    name: "origin",
    parameter: "distance from the origin / size",
    range: [1.0, 1e8],
    zero: false,
    series: FAMILIES,
    deform: |scene, value| {
        scene.shift = value;
        Some(())
    },
};

pub const SCALE: Sweep = Sweep {
    name: "scale",
    parameter: "size of everything",
    range: [1e-9, 1e9],
    zero: false,
    series: FAMILIES,
    deform: |scene, value| {
        scene.scale = value;
        Some(())
    },
};

pub const GAP: Sweep = Sweep {
    name: "gap",
    parameter: "penetration / size",
    range: [1.0, 1e-14],
    zero: false,
    series: &[
        normal("PointQuad4"),
        slips("PointQuad4Coulomb"),
        sticks("PointQuad9Coulomb"),
        slips("PointRationalSurface2Coulomb"),
        slips("PointHermiteCoulomb"),
        sticks("HermiteHermiteBeamsCoulomb"),
        slips("Line2Line2EdgesCoulomb"),
        slips("HermiteQuad4OrthotropicAtPoint"),
        slips("Quad4Quad4CoulombAtPoint"),
        sticks("PointLine3Coulomb2d"),
        slips("PointCylinderCoulomb"),
        normal("PointSphereDistance"),
    ],
    deform: |scene, value| {
        // a distance is never negative, and beyond the middle of a body another side is nearer
        let most = if scene.pair.r0 > 0.0 {
            scene.pair.r0
        } else {
            1.0
        };
        scene.gap = -value.min(0.9 * most);
        Some(())
    },
};

pub const TINY_GAP: Sweep = Sweep {
    name: "tiny-gap",
    parameter: "penetration of a flat facet along z",
    range: [1e-14, 1e-300],
    zero: false,
    series: &[
        normal("PointTri3"),
        normal("PointQuad4"),
        slips("PointQuad4Coulomb"),
        sticks("PointQuad4Coulomb"),
        slips("Quad4Quad4CoulombAtPoint"),
        normal("PointPlane"),
    ],
    deform: |scene, value| {
        scene.gap = -value;
        scene.turned = false;
        for node in scene.slave.iter_mut().chain(&mut scene.master) {
            node[2] = 0.0;
        }
        Some(())
    },
};

pub const ANGLE: Sweep = Sweep {
    name: "angle",
    parameter: "angle between two curves [rad]",
    range: [1.5, 1e-14],
    zero: false,
    series: &[
        normal("Line2Line2Beams"),
        sticks("Line2Line2BeamsCoulomb"),
        slips("Line2Line2BeamsCoulomb"),
        slips("Line2Line2EdgesCoulomb"),
        sticks("HermiteHermiteBeamsCoulomb"),
        slips("HermiteHermiteEdgesCoulomb").up_to(1e-8),
        normal("BezierCurve3BezierCurve3Beams"),
    ],
    deform: |scene, value| {
        // curves in planes across z: the angle of their tangents is that of their directions in the plane
        for node in scene.slave.iter_mut().chain(&mut scene.master) {
            node[2] = 0.0;
        }
        scene.cross_at(value);
        scene.start_nearer(value);
        Some(())
    },
};

pub const FOCAL: Sweep = Sweep {
    name: "focal",
    parameter: "distance to the focal surface / radius",
    range: [1.0, 1e-12],
    zero: false,
    series: &[
        normal("PointQuad9"),
        slips("PointQuad9Coulomb"),
        slips("PointRationalSurface2Coulomb"),
        normal("PointHermite"),
        slips("PointHermiteCoulomb"),
        normal("HermiteHermiteBeams"),
        sticks("HermiteHermiteBeamsCoulomb"),
        sticks("PointLine3Coulomb2d"),
        slips("PointCylinderCoulomb"),
        normal("PointSphere"),
        normal("PointCircle"),
    ],
    deform: |scene, value| {
        scene.start_nearer(value);
        scene.bend(5.0);
        let distance = scene.focal_distance()? * (1.0 - value).max(0.02);
        if scene.pair.gap == GapKind::Distance {
            scene.pair.r0 = distance + 0.1;
        }
        scene.gap = distance - scene.pair.r0;
        Some(())
    },
};
