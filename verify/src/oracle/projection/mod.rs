//! Closest point projection in doubles: minimises `r·r / 2` over the projected parameters.
//!
//! Newton's matrix is the dual derivative of the stationarity conditions `f_i = r·r_,i`.

mod boundary;

use num_dual::Dual64;

use super::geometry::{Feature, Region};
use super::kinematics::{Frame, Nodes};
use super::vector::dot;

/// Result of a projection.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Projection {
    /// A minimum inside the region (or on its boundary).
    Inside(Root),
    /// The minimum over the region lies on its boundary, where `r·r` would fall further outside.
    Outside {
        /// Part of the boundary.
        feature: Feature,
        /// Parameters of the minimum on the boundary.
        z: [f64; 2],
    },
    /// Not a unique minimum: `F` or the metric is singular at these parameters.
    Degenerate {
        /// Where.
        z: [f64; 2],
    },
    /// No stationary point was reached.
    NotConverged,
}

/// A converged projection.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Root {
    /// Parameters, slave's first.
    pub z: [f64; 2],
    /// Inverse of `F_ij = (r·r_,i),_j` there.
    pub inverse: [[f64; 2]; 2],
    /// How well conditioned it is.
    pub conditioning: Conditioning,
    /// Newton iterations used.
    pub iterations: usize,
}

/// How far a projection is from being singular.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Conditioning {
    /// Smallest eigenvalue of `a⁻¹F`: one at zero distance, zero at the centre of curvature.
    pub smallest_eigenvalue: f64,
    /// Cosine of the angle between the tangents (zero for one parameter).
    pub tangent_cosine: f64,
}

/// Smallest eigenvalue of `a⁻¹F`, and smallest squared sine between the tangents, accepted.
const SINGULAR: f64 = 1e-8;
const PARALLEL: f64 = 1e-14;
const MAX_ITERATIONS: usize = 100;

/// The objective and its derivatives at one set of parameters.
struct Local {
    value: f64,
    slope: [f64; 2],
    /// F.
    matrix: [[f64; 2]; 2],
    /// a.
    metric: [[f64; 2]; 2],
}

struct Problem<'f, 'a> {
    frame: &'f Frame<'a>,
    nodes: Nodes<Dual64>,
    region: Region,
    p: usize,
}

/// Projects from the start `z`; only the first `parameters` entries are used.
pub fn project(frame: &Frame<'_>, z: [f64; 2]) -> Projection {
    let p = frame.parameters;
    if p == 0 {
        let conditioning = Conditioning {
            smallest_eigenvalue: 1.0,
            tangent_cosine: 0.0,
        };
        let inverse = [[0.0; 2]; 2];
        return Projection::Inside(Root {
            z: [0.0; 2],
            inverse,
            conditioning,
            iterations: 0,
        });
    }
    let nodes = Nodes::lifted(&frame.nodes);
    let problem = Problem {
        frame,
        nodes,
        region: frame.pair.region(),
        p,
    };
    let mut start = [z[0], if p == 2 { z[1] } else { 0.0 }];
    for _ in 0..3 {
        let found = problem.descend(start);
        match found {
            Projection::Inside(Root { z, .. }) | Projection::Degenerate { z }
                if problem.region.contains(z, p) =>
            {
                return found;
            }
            _ => {}
        }
        match problem.on_boundary(start) {
            Some((feature, z, true)) => return Projection::Outside { feature, z },
            Some((_, z, false)) => {
                let middle = problem.region.middle();
                start = [0, 1].map(|i| z[i] + 0.1 * (middle[i] - z[i]));
            }
            None => return Projection::NotConverged,
        }
    }
    Projection::NotConverged
}

/// A start by search: the sample of a regular grid where `r·r` is least.
pub fn search(frame: &Frame<'_>, window: [[f64; 2]; 2]) -> [f64; 2] {
    const SAMPLES: usize = 9;
    let region = frame.pair.region();
    let (mut best, mut least) = (region.middle(), f64::INFINITY);
    for j in 0..if frame.parameters == 2 { SAMPLES } else { 1 } {
        for i in 0..SAMPLES {
            let at = |k: usize, step: usize| {
                let [low, high] = window[k];
                low + (high - low) * (step as f64 + 0.5) / SAMPLES as f64
            };
            let z = [at(0, i), at(1, j)];
            let r = frame.relative(&frame.nodes, z).position;
            if region.contains(z, frame.parameters) && dot(r, r) < least {
                (best, least) = (z, dot(r, r));
            }
        }
    }
    best
}

impl Problem<'_, '_> {
    fn value(&self, z: [f64; 2]) -> f64 {
        let r = self.frame.relative(&self.frame.nodes, z).position;
        0.5 * dot(r, r)
    }

    fn local(&self, z: [f64; 2]) -> Local {
        let mut local = Local {
            value: 0.0,
            slope: [0.0; 2],
            matrix: [[0.0; 2]; 2],
            metric: [[0.0; 2]; 2],
        };
        for j in 0..self.p {
            let seed = |i: usize| Dual64::new(z[i], if i == j { 1.0 } else { 0.0 });
            let relative = self.frame.relative(&self.nodes, [seed(0), seed(1)]);
            local.value = 0.5 * dot(relative.position, relative.position).re;
            for i in 0..self.p {
                let f = dot(relative.position, relative.tangents[i]);
                local.slope[i] = f.re;
                local.matrix[i][j] = f.eps;
                local.metric[i][j] = dot(relative.tangents[i], relative.tangents[j]).re;
            }
        }
        local
    }

    /// Damped Newton for a minimum, bounds ignored; refined until steps stop shrinking.
    fn descend(&self, mut z: [f64; 2]) -> Projection {
        let mut previous = f64::INFINITY;
        for iteration in 0..MAX_ITERATIONS {
            let local = self.local(z);
            let newton = solve(&local.matrix, local.slope, self.p);
            let Some(step) = newton.or_else(|| solve(&local.metric, local.slope, self.p)) else {
                return Projection::Degenerate { z };
            };
            let size = (0..self.p)
                .map(|i| step[i].abs() / (1.0 + z[i].abs()))
                .fold(0.0, f64::max);
            if !size.is_finite() {
                return Projection::NotConverged;
            }
            let stagnant = size >= 0.5 * previous && (size < 1e-7 || self.is_noise(&local));
            if size <= 4.0 * f64::EPSILON || stagnant {
                return self.classify(z, &local, newton.is_some(), iteration);
            }
            previous = size;
            z = self.advance(z, step, &local, size);
        }
        Projection::NotConverged
    }

    /// Whether the stationarity conditions hold as well as the rounding of positions allows.
    fn is_noise(&self, local: &Local) -> bool {
        let noise = 16.0 * f64::EPSILON * self.frame.size;
        (0..self.p).all(|i| local.slope[i].abs() <= noise * local.metric[i][i].sqrt())
    }

    /// `z - t step` with the largest t = 1, 1/2, 1/4 ... that does not raise the objective.
    fn advance(&self, z: [f64; 2], step: [f64; 2], local: &Local, size: f64) -> [f64; 2] {
        let longest = (0..self.p)
            .map(|i| step[i].abs() / self.region.extent(i))
            .fold(0.0, f64::max);
        let mut t = if longest > 0.5 { 0.5 / longest } else { 1.0 };
        let at = |t: f64| [z[0] - t * step[0], z[1] - t * step[1]];
        if size < 1e-6 {
            return at(t);
        }
        for _ in 0..40 {
            if self.value(at(t)) <= local.value * (1.0 + 1e-14) {
                break;
            }
            t *= 0.5;
        }
        at(t)
    }

    fn classify(&self, z: [f64; 2], local: &Local, minimum: bool, iterations: usize) -> Projection {
        let (a, f) = (&local.metric, &local.matrix);
        let conditioning = if self.p == 1 {
            Conditioning {
                smallest_eigenvalue: f[0][0] / a[0][0],
                tangent_cosine: 0.0,
            }
        } else {
            let cosine = a[0][1] / (a[0][0] * a[1][1]).sqrt();
            let det = a[0][0] * a[1][1] - a[0][1] * a[1][0];
            let half_trace =
                0.5 * (a[1][1] * f[0][0] - 2.0 * a[0][1] * f[0][1] + a[0][0] * f[1][1]) / det;
            let product = (f[0][0] * f[1][1] - f[0][1] * f[1][0]) / det;
            let root = (half_trace * half_trace - product).max(0.0).sqrt();
            Conditioning {
                smallest_eigenvalue: half_trace - root,
                tangent_cosine: cosine.abs(),
            }
        };
        match invert(f, self.p) {
            Some(inverse) if minimum && conditioning.smallest_eigenvalue > SINGULAR => {
                Projection::Inside(Root {
                    z,
                    inverse,
                    conditioning,
                    iterations,
                })
            }
            _ => Projection::Degenerate { z },
        }
    }
}

/// `m⁻¹ v` for a positive definite `m` of order `p`, otherwise `None`.
fn solve(m: &[[f64; 2]; 2], v: [f64; 2], p: usize) -> Option<[f64; 2]> {
    let inverse = invert(m, p)?;
    let row = |i: usize| inverse[i][0] * v[0] + inverse[i][1] * v[1];
    Some([row(0), row(1)])
}

/// Inverse of a positive definite symmetric matrix of order `p`, padded by zeros.
fn invert(m: &[[f64; 2]; 2], p: usize) -> Option<[[f64; 2]; 2]> {
    if p == 1 {
        return (m[0][0] > 0.0).then(|| [[m[0][0].recip(), 0.0], [0.0; 2]]);
    }
    let det = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    let definite = m[0][0] > 0.0 && m[1][1] > 0.0 && det > PARALLEL * m[0][0] * m[1][1];
    definite.then(|| {
        [
            [m[1][1] / det, -m[0][1] / det],
            [-m[1][0] / det, m[0][0] / det],
        ]
    })
}
