//! The minimum over the boundary of a parameter region, by exhaustion: every side, several starts.

use super::{MAX_ITERATIONS, Problem};
use crate::oracle::geometry::Feature;
use crate::oracle::geometry::region::Side;

impl Problem<'_, '_> {
    /// The best point of the boundary: where, and whether it is a minimum over the region.
    pub(super) fn on_boundary(&self, start: [f64; 2]) -> Option<(Feature, [f64; 2], bool)> {
        let mut best: Option<(Feature, [f64; 2])> = None;
        let mut least = f64::INFINITY;
        let mut consider = |feature: Feature, z: [f64; 2]| {
            let value = self.value(z);
            if value < least {
                (best, least) = (Some((feature, z)), value);
            }
        };
        if self.p == 1 {
            for (k, &end) in self.region.bounds[0]?.iter().enumerate() {
                consider(Feature::Vertex(k as u8), [end, 0.0]);
            }
        } else {
            for side in self.region.sides() {
                for (s, z) in self.along(&side, start) {
                    consider(self.name(&side, s), z);
                }
            }
        }
        let (feature, z) = best?;
        Some((feature, z, self.falls_outwards(z)))
    }

    /// Minima along one side of a region of two parameters, from several starts.
    fn along(&self, side: &Side, start: [f64; 2]) -> Vec<(f64, [f64; 2])> {
        let at = |s: f64| [0, 1].map(|i| side.corner[i] + s * side.direction[i]);
        let d = side.direction;
        let foot = ((start[0] - side.corner[0]) * d[0] + (start[1] - side.corner[1]) * d[1])
            / (d[0] * d[0] + d[1] * d[1]);
        let clamp = |s: f64| side.range.map_or(s, |[low, high]| s.clamp(low, high));
        let mut starts = vec![clamp(foot)];
        if let Some([low, high]) = side.range {
            starts.extend([low, 0.5 * (low + high), high]);
        }
        let mut minima = Vec::with_capacity(starts.len());
        for mut s in starts {
            for _ in 0..MAX_ITERATIONS {
                let local = self.local(at(s));
                let project = |m: &[[f64; 2]; 2]| {
                    d[0] * (m[0][0] * d[0] + m[0][1] * d[1])
                        + d[1] * (m[1][0] * d[0] + m[1][1] * d[1])
                };
                let slope = local.slope[0] * d[0] + local.slope[1] * d[1];
                let curvature = project(&local.matrix);
                let metric = project(&local.metric);
                let step = slope
                    / if curvature > 1e-6 * metric {
                        curvature
                    } else {
                        metric
                    };
                let mut t = 1.0;
                while t > 1e-12 && self.value(at(clamp(s - t * step))) > local.value * (1.0 + 1e-14)
                {
                    t *= 0.5;
                }
                let next = clamp(s - t * step);
                let moved = (next - s).abs();
                s = next;
                if moved <= 4.0 * f64::EPSILON * (1.0 + s.abs()) {
                    break;
                }
            }
            minima.push((s, at(s)));
        }
        minima
    }

    /// Name of the point `s` of a side.
    fn name(&self, side: &Side, s: f64) -> Feature {
        let end = side.range.and_then(|[low, high]| {
            let slack = 1e-12 * (high - low);
            if s <= low + slack {
                Some(0)
            } else if s >= high - slack {
                Some(1)
            } else {
                None
            }
        });
        let count = if self.region.triangle { 3 } else { 4 };
        if self.frame.pair.slave_parameters() == 0 {
            return match end {
                Some(end) => Feature::Vertex((side.number + end) % count),
                None => Feature::Edge(side.number),
            };
        }
        // Curve to curve: sides 3 and 1 are the slave's ends, 0 and 2 the master's.
        match (side.number, end) {
            (0 | 2, None) => Feature::MasterEnd(side.number / 2),
            (_, None) => Feature::SlaveEnd(u8::from(side.number == 1)),
            (number, Some(end)) => match (number + end) % 4 {
                0 => Feature::BothEnds(0, 0),
                1 => Feature::BothEnds(1, 0),
                2 => Feature::BothEnds(1, 1),
                _ => Feature::BothEnds(0, 1),
            },
        }
    }

    /// Whether the objective rises from the boundary point `z` into the region, i.e. whether `z`
    /// is a minimum over the region: first-order condition for every side through `z`.
    fn falls_outwards(&self, z: [f64; 2]) -> bool {
        let local = self.local(z);
        let scale = (2.0 * local.value).sqrt();
        let rises = |inward: [f64; 2]| {
            let slope = local.slope[0] * inward[0] + local.slope[1] * inward[1];
            let length = local.metric[0][0].max(local.metric[1][1]).sqrt();
            slope >= -1e-9 * scale * length
        };
        if self.p == 1 {
            let inward = if z[0] < self.region.middle()[0] {
                1.0
            } else {
                -1.0
            };
            return rises([inward, 0.0]);
        }
        self.region.sides().iter().all(|side| {
            let normal = [-side.direction[1], side.direction[0]];
            let off = (z[0] - side.corner[0]) * normal[0] + (z[1] - side.corner[1]) * normal[1];
            off.abs() > 1e-9 || rises(side.inward)
        })
    }
}
