//! Two beams at an angle, straight or bent, and the two elements that act between them.

use crate::pair::Pair;
use crate::vector::{Vector, turned};

pub const WINDOW: [f64; 2] = [0.1, 0.3];
pub const R0: f64 = 0.5;
pub const HEIGHT: f64 = 0.35;
pub const STIFFNESS: [f64; 2] = [1000.0, 700.0];

/// The element for large angles and the one for small angles.
pub struct Beams {
    pub parts: [Pair; 2],
}

/// What both give together.
pub struct Sum {
    pub energy: f64,
    pub residual: Vec<f64>,
    pub tangent: Vec<f64>,
    /// Energies of either part.
    pub shares: [f64; 2],
}

impl Beams {
    pub fn new(names: [&str; 2]) -> Self {
        let parts = [0, 1].map(|part| {
            let given = [
                ("eps_n", STIFFNESS[part]),
                ("r0", R0),
                ("angle_low", WINDOW[0]),
                ("angle_high", WINDOW[1]),
            ];
            Pair::new(names[part], &given)
        });
        Self { parts }
    }

    pub fn straight() -> Self {
        Self::new([
            "Line2Line2BeamsLargeAngle",
            "Line2Line2LineContactSmallAngle",
        ])
    }

    pub fn curved() -> Self {
        let names = [
            "HermiteHermiteBeamsLargeAngle",
            "HermiteHermiteLineContactSmallAngle",
        ];
        Self::new(names)
    }

    pub fn at(&self, x: &[f64]) -> Sum {
        self.moved(x, &vec![0.0; x.len()])
    }

    pub fn moved(&self, x: &[f64], u: &[f64]) -> Sum {
        let [point, line] = self.parts.each_ref().map(|part| part.moved(x, u));
        let add = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a + b).collect();
        Sum {
            energy: point.energy + line.energy,
            residual: add(&point.residual, &line.residual),
            tangent: add(&point.tangent, &line.tangent),
            shares: [point.energy, line.energy],
        }
    }
}

/// The slave turned by `angle` about the z axis through `pivot`, then the master.
pub fn nodes(slave: &[Vector], master: &[Vector], angle: f64) -> Vec<f64> {
    let axis = [0.0, 0.0, 1.0];
    let slave = slave.iter().map(|&node| turned(node, axis, angle));
    slave.chain(master.iter().copied()).flatten().collect()
}

pub fn straight(angle: f64) -> Vec<f64> {
    let slave = [[-1.1, 0.0, HEIGHT], [0.9, 0.0, HEIGHT]];
    nodes(&slave, &[[-1.2, 0.0, 0.0], [1.3, 0.0, 0.0]], angle)
}

/// Beams bent away from each other, and out of their planes.
pub fn curved(angle: f64) -> Vec<f64> {
    let slave = [
        [-1.0, 0.01, HEIGHT + 0.02],
        [1.0, 0.02, -0.02],
        [0.9, -0.01, HEIGHT + 0.02],
        [1.0, -0.02, 0.03],
    ];
    let master = [
        [-1.2, 0.01, -0.02],
        [1.2, -0.01, 0.03],
        [1.3, 0.01, -0.02],
        [1.3, 0.01, -0.02],
    ];
    nodes(&slave, &master, angle)
}
