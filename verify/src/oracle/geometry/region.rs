//! Where the parameters of a projection may lie, and the names of the boundary's parts.

/// Part of the boundary of a parameter region on which a closest point lies.
///
/// Square `[a,b] x [c,d]`: edge 0 `y = c`, 1 `x = b`, 2 `y = d`, 3 `x = a`; vertex k starts edge k
/// (counter-clockwise). Triangle: edge 0 `y = 0`, 1 `x + y = 1`, 2 `x = 0`, vertices likewise.
/// Curve: vertex 0 at the lower end, 1 at the upper. Curve to curve: ends of either curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Feature {
    /// On edge k of a surface.
    Edge(u8),
    /// On vertex k of a surface, or end k of a curve.
    Vertex(u8),
    /// End k of the slave curve, inside the master curve.
    SlaveEnd(u8),
    /// End k of the master curve, inside the slave curve.
    MasterEnd(u8),
    /// End `.0` of the slave curve and end `.1` of the master curve.
    BothEnds(u8, u8),
}

/// The set of admissible parameters, one or two of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Region {
    /// Bounds of each parameter; `None` for an unbounded or periodic one.
    pub bounds: [Option<[f64; 2]>; 2],
    /// Additionally `z_0 + z_1 <= 1`.
    pub triangle: bool,
}

/// One straight piece of the boundary: `z = corner + s direction`, `s` in `range`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Side {
    /// Point at `s = 0`.
    pub corner: [f64; 2],
    /// Direction of the side.
    pub direction: [f64; 2],
    /// Bounds of `s`; `None` if unbounded.
    pub range: Option<[f64; 2]>,
    /// Direction into the region.
    pub inward: [f64; 2],
    /// Number of the side: for squares and triangles the edge number.
    pub number: u8,
}

/// Parameters may exceed their bounds by this much (relative to the bounds' distance) and still
/// count as inside: a projection that lies on the boundary belongs to the region.
pub const INSIDE_TOLERANCE: f64 = 1e-12;

impl Region {
    /// No bounds at all.
    pub const FREE: Self = Self {
        bounds: [None, None],
        triangle: false,
    };
    /// The triangle `z >= 0, z_0 + z_1 <= 1`.
    pub const TRIANGLE: Self = Self {
        bounds: [Some([0.0, 1.0]), Some([0.0, 1.0])],
        triangle: true,
    };

    /// One parameter in `[low, high]`.
    pub const fn interval(low: f64, high: f64) -> Self {
        Self {
            bounds: [Some([low, high]), None],
            triangle: false,
        }
    }

    /// Two parameters, each in `[low, high]`.
    pub const fn square(low: f64, high: f64) -> Self {
        Self {
            bounds: [Some([low, high]), Some([low, high])],
            triangle: false,
        }
    }

    /// The region of a slave curve's parameter followed by a master's single parameter.
    pub const fn product(slave: Self, master: Self) -> Self {
        Self {
            bounds: [slave.bounds[0], master.bounds[0]],
            triangle: false,
        }
    }

    /// Whether the first `p` parameters lie inside, up to [`INSIDE_TOLERANCE`].
    pub fn contains(&self, z: [f64; 2], p: usize) -> bool {
        let within = (0..p).all(|i| match self.bounds[i] {
            Some([low, high]) => {
                let slack = INSIDE_TOLERANCE * (high - low);
                z[i] >= low - slack && z[i] <= high + slack
            }
            None => z[i].is_finite(),
        });
        within && (!self.triangle || z[0] + z[1] <= 1.0 + INSIDE_TOLERANCE)
    }

    /// A point well inside: the centre, and the origin where unbounded.
    pub fn middle(&self) -> [f64; 2] {
        if self.triangle {
            return [1.0 / 3.0; 2];
        }
        self.bounds
            .map(|b| b.map_or(0.0, |[low, high]| 0.5 * (low + high)))
    }

    /// Length of parameter `i`'s bounds, 2 where unbounded.
    pub fn extent(&self, i: usize) -> f64 {
        self.bounds[i].map_or(2.0, |[low, high]| high - low)
    }

    /// The sides of a region of two parameters; an unbounded region has no sides.
    pub fn sides(&self) -> Vec<Side> {
        if self.triangle {
            let half = [0.5f64.sqrt(); 2];
            let make = |number, corner, direction, inward| Side {
                corner,
                direction,
                range: Some([0.0, 1.0]),
                inward,
                number,
            };
            return vec![
                make(0, [0.0, 0.0], [1.0, 0.0], [0.0, 1.0]),
                make(1, [1.0, 0.0], [-1.0, 1.0], [-half[0], -half[1]]),
                make(2, [0.0, 1.0], [0.0, -1.0], [1.0, 0.0]),
            ];
        }
        let mut sides = Vec::with_capacity(4);
        // (number, fixed axis, end of its bounds); the side runs counter-clockwise
        for (number, axis, end) in [(0, 1, 0), (1, 0, 1), (2, 1, 1), (3, 0, 0)] {
            let Some(bound) = self.bounds[axis] else {
                continue;
            };
            let along = 1 - axis;
            let sense = if number < 2 { 1.0 } else { -1.0 };
            let mut side = Side {
                corner: [0.0; 2],
                direction: [0.0; 2],
                range: None,
                inward: [0.0; 2],
                number,
            };
            side.corner[axis] = bound[end];
            side.inward[axis] = if end == 0 { 1.0 } else { -1.0 };
            side.direction[along] = sense;
            if let Some([low, high]) = self.bounds[along] {
                side.corner[along] = if sense > 0.0 { low } else { high };
                side.range = Some([0.0, high - low]);
            }
            sides.push(side);
        }
        sides
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sides_run_counter_clockwise_round_the_region() {
        for region in [
            Region::square(-1.0, 1.0),
            Region::TRIANGLE,
            Region::square(0.0, 1.0),
        ] {
            let sides = region.sides();
            for (k, side) in sides.iter().enumerate() {
                let next = &sides[(k + 1) % sides.len()];
                let end = side.range.unwrap()[1];
                for i in 0..2 {
                    assert!(
                        (side.corner[i] + end * side.direction[i] - next.corner[i]).abs() < 1e-15
                    );
                }
                let d = side.direction;
                assert!(
                    d[0] * side.inward[1] - d[1] * side.inward[0] > 0.0,
                    "inward is to the left"
                );
            }
        }
    }

    #[test]
    fn the_boundary_belongs_to_the_region() {
        assert!(Region::square(-1.0, 1.0).contains([1.0, -1.0], 2));
        assert!(!Region::square(-1.0, 1.0).contains([1.0 + 1e-9, 0.0], 2));
        assert!(Region::TRIANGLE.contains([0.5, 0.5], 2));
        assert!(!Region::TRIANGLE.contains([0.6, 0.5], 2));
        assert!(Region::FREE.contains([1e9, 0.0], 1));
        assert!(!Region::FREE.contains([f64::NAN, 0.0], 1));
    }
}
