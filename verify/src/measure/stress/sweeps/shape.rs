//! What the master looks like: aspect, skew, folded and collapsed facets, tangents, weights.

use super::sweep::{Sweep, normal, slips, sticks};
use crate::configurations::flat;
use crate::oracle::geometry::Shape;
use crate::oracle::pair::{Master, Slave};

pub const ASPECT: Sweep = Sweep {
    name: "aspect",
    parameter: "aspect ratio of the facet",
    range: [1.0, 1e6],
    zero: false,
    series: &[
        normal("PointTri3"),
        normal("PointQuad4"),
        slips("PointQuad4Coulomb"),
        sticks("PointQuad9Coulomb"),
        slips("PointBezierSurface2Coulomb"),
        slips("PointRationalSurface2Coulomb").up_to(1e2),
        slips("HermiteQuad4OrthotropicAtPoint"),
        slips("Quad4Quad4CoulombAtPoint"),
    ],
    deform: |scene, value| {
        let Master::Shape(geometry) = &scene.pair.master else {
            return None;
        };
        // the disturbance of the nodes stays as it is: stretched it would be skew
        for (node, flat) in scene.master.iter_mut().zip(flat::nodes(&geometry.shape)) {
            node[0] += (value - 1.0) * flat[0];
        }
        Some(())
    },
};

/// A solve with F loses the square of the sine: half of all digits here.
const SKEW_LIMIT: f64 = 3e-8;

pub const SKEW: Sweep = Sweep {
    name: "skew",
    parameter: "sine of the angle between the sides of the facet",
    range: [1.0, 1e-14],
    zero: false,
    series: &[
        normal("PointTri3").up_to(SKEW_LIMIT),
        normal("PointQuad4").up_to(SKEW_LIMIT),
        slips("PointQuad4Coulomb").up_to(SKEW_LIMIT),
        sticks("PointQuad9Coulomb").up_to(SKEW_LIMIT),
        slips("PointRationalSurface2Coulomb").up_to(SKEW_LIMIT),
        slips("Quad4Quad4CoulombAtPoint").up_to(SKEW_LIMIT),
    ],
    deform: |scene, sine| {
        let cosine = ((1.0 - sine) * (1.0 + sine)).sqrt();
        for [x, y, z] in &mut scene.master {
            // a thin facet is as thin across its plane: height and gap keep their proportion
            (*x, *y, *z) = (*x + cosine * *y, sine * *y, sine * *z);
        }
        scene.gap *= sine;
        scene.start_nearer(sine);
        Some(())
    },
};

pub const FOLD: Sweep = Sweep {
    name: "fold",
    parameter: "corner 3 off the diagonal from 2 to 4 / size",
    range: [1.0, 1e-14],
    zero: false,
    series: &[
        normal("PointQuad4"),
        slips("PointQuad4Coulomb"),
        sticks("PointQuad4Coulomb"),
        slips("Quad4Quad4CoulombAtPoint"),
        slips("HermiteQuad4OrthotropicAtPoint"),
    ],
    deform: |scene, value| {
        let [_, b, c, d] = scene.master.as_mut_slice() else {
            return None;
        };
        *c = [0, 1, 2].map(|i| 0.5 * (b[i] + d[i]) + if i < 2 { value } else { 0.0 });
        // the target goes to the corner, where the sides come to lie on one line
        scene.target = [1.0 - 0.4 * value, 1.0 - 0.4 * value];
        scene.is_projection_data = true;
        scene.gap *= value;
        scene.start_nearer(value);
        Some(())
    },
};

pub const COLLAPSE: Sweep = Sweep {
    name: "collapse",
    parameter: "length of edge 3 / size",
    range: [1.0, 1e-14],
    zero: false,
    series: &[
        normal("PointQuad4"),
        slips("PointQuad4Coulomb"),
        sticks("PointQuad9Coulomb"),
        slips("PointRationalSurface2Coulomb"),
        slips("Quad4Quad4CoulombAtPoint"),
        slips("HermiteQuad4OrthotropicAtPoint"),
    ],
    deform: |scene, value| {
        for node in &mut scene.master {
            // about x = 0.3, so that no coordinate vanishes
            let across = 1.0 - (1.0 - value) * (1.0 + node[1]).clamp(0.0, 2.0) / 2.0;
            *node = [0.3 + across * node[0], node[1], node[2] * across];
        }
        let Master::Shape(geometry) = &scene.pair.master else {
            return None;
        };
        let region = geometry.shape.region();
        let top = region.bounds[1]?[1];
        scene.target[1] = top - 0.2 * value * region.extent(1);
        scene.gap *= value;
        scene.start_nearer(value);
        Some(())
    },
};

pub const TANGENT: Sweep = Sweep {
    name: "tangent",
    parameter: "length of the end tangents / length of the curve",
    range: [1.0, 1e-16],
    zero: true,
    series: &[
        normal("PointHermite"),
        slips("PointHermiteCoulomb"),
        normal("PointHermiteIn2d"),
        normal("HermiteHermiteBeams"),
        sticks("HermiteHermiteBeamsCoulomb"),
        slips("HermiteHermiteEdgesCoulomb"),
        slips("HermiteQuad4OrthotropicAtPoint"),
    ],
    deform: |scene, value| {
        let is_hermite = |geometry: &crate::oracle::geometry::Interpolation| {
            matches!(geometry.shape, Shape::Hermite)
        };
        let slave = match &scene.pair.slave {
            Slave::Curve(geometry) | Slave::Fixed { geometry, .. } => is_hermite(geometry),
            _ => false,
        };
        let master = matches!(&scene.pair.master, Master::Shape(own) if is_hermite(own));
        let sides = [(slave, &mut scene.slave), (master, &mut scene.master)];
        for (_, nodes) in sides.into_iter().filter(|side| side.0) {
            for tangent in nodes.iter_mut().skip(1).step_by(2) {
                *tangent = tangent.map(|c| c * value);
            }
        }
        Some(())
    },
};

pub const WEIGHT: Sweep = Sweep {
    name: "weight",
    parameter: "weight of the middle node, others 0.7 to 1.4",
    range: [1e-6, 1e6],
    zero: false,
    series: &[
        normal("PointRationalCurve2"),
        normal("PointRationalCurve2In2d"),
        normal("PointRationalCurve3"),
        normal("PointRationalSurface2"),
        slips("PointRationalSurface2Coulomb"),
        sticks("PointRationalSurface2Coulomb"),
        normal("RationalCurve2RationalCurve2Beams").up_to(50.0),
        normal("RationalSurface2RationalSurface2"),
    ],
    deform: |scene, value| {
        for weights in scene.weights() {
            let middle = weights.len() / 2;
            *weights.get_mut(middle)? = value;
        }
        // the tip that a heavy node pulls out is as small as its weight is large
        scene.gap /= value.max(1.0);
        scene.pair.r0 /= value.max(1.0);
        Some(())
    },
};
