//! Random warped facets of size 2 with a point over each.

use crate::random::Random;

/// Points against bilinear facets.
pub struct States {
    pub count: usize,
    pub x: Vec<f64>,
    /// Status and projection.
    exact: Vec<f64>,
    /// The same, 0.05 off.
    near: Vec<f64>,
}

const CORNERS: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

fn position(nodes: &[[f64; 3]; 4], zeta: [f64; 2]) -> [[f64; 3]; 3] {
    let mut all = [[0.0; 3]; 3];
    for (node, [a, b]) in nodes.iter().zip(CORNERS) {
        let (f, g) = (1.0 + a * zeta[0], 1.0 + b * zeta[1]);
        for k in 0..3 {
            all[0][k] += 0.25 * f * g * node[k];
            all[1][k] += 0.25 * a * g * node[k];
            all[2][k] += 0.25 * f * b * node[k];
        }
    }
    all
}

impl States {
    /// `share` of the points are in contact, the others at most 0.5 away.
    pub fn new(count: usize, share: f64) -> Self {
        let mut random = Random(7);
        let mut states = Self {
            count,
            x: vec![],
            exact: vec![],
            near: vec![],
        };
        for _ in 0..count {
            let nodes = CORNERS.map(|[a, b]| {
                let mut off = || random.within(-0.15, 0.15);
                [a + off(), b + off(), off()]
            });
            let zeta = [random.within(-0.8, 0.8), random.within(-0.8, 0.8)];
            let [x, s, t] = position(&nodes, zeta);
            let n = [
                s[1] * t[2] - s[2] * t[1],
                s[2] * t[0] - s[0] * t[2],
                s[0] * t[1] - s[1] * t[0],
            ];
            let length = n.map(|c| c * c).iter().sum::<f64>().sqrt();
            let gap = if random.within(0.0, 1.0) < share {
                -random.within(0.001, 0.1)
            } else {
                random.within(0.05, 0.5)
            };
            states.x.extend((0..3).map(|k| x[k] + gap * n[k] / length));
            states.x.extend(nodes.iter().flatten());
            states.exact.extend([1.0, zeta[0], zeta[1]]);
            let angle = random.within(0.0, core::f64::consts::TAU);
            let near = [zeta[0] + 0.05 * angle.cos(), zeta[1] + 0.05 * angle.sin()];
            states.near.extend([1.0, near[0], near[1]]);
        }
        states
    }

    /// Histories: the projection itself, or a start.
    pub fn start(&self, given: bool) -> &[f64] {
        if given { &self.exact } else { &self.near }
    }
}
