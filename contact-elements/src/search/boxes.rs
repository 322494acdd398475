//! Branch and bound over boxes of parameters.

use super::closest::{Closest, MOST_BOXES, Verdict};
use super::descent::{Foot, REGULAR, definiteness, descended, dot, least_in_box, square};
use super::enclosure::{Enclosure, size};
use super::interval::{Interval, MOST_OPERATIONS, Scratch};
use super::pair::{Local, Sides};
use super::region::{Box, FAR, Region};
use crate::arithmetic::{abs, sqrt};

/// Boxes that wait.
const WAITING: usize = 256;
/// Boxes narrower than this part of the extent are split no more.
const NARROW: f64 = 1e-9;
/// Squared distances that differ by less than this part are the same.
const SAME: f64 = 1e-10;
/// Feet nearer than this part of the extent are the same.
const NEAR: f64 = 1e-6;
/// Rounding of a distance, relative to the coordinates and tangents that it is made of.
const ROUNDING: f64 = 1e-13;

/// The state of a search.
pub(super) struct Search<'a> {
    sides: &'a Sides<'a>,
    region: Region,
    waiting: [Box; WAITING],
    count: usize,
    /// Squared distance of the best foot, or of the reach.
    best: f64,
    foot: Option<Foot>,
    /// It is held by a side of its box behind which r·r falls: what is found there is the same minimum.
    is_cut: bool,
    /// Another foot as near as the best.
    is_double: bool,
    overflows: bool,
    boxes: u32,
    steps: u32,
}

impl<'a> Search<'a> {
    pub(super) fn new(sides: &'a Sides<'a>, region: Region, reach: f64) -> Self {
        Self {
            sides,
            region,
            waiting: [Box::default(); WAITING],
            count: 0,
            best: if reach > 0.0 { reach * reach } else { f64::MAX },
            foot: None,
            is_cut: false,
            is_double: false,
            overflows: false,
            boxes: 0,
            steps: 0,
        }
    }

    /// Processes boxes until no box is left.
    pub(super) fn run(mut self) -> Closest {
        let mut scratch = [Interval::ZERO; MOST_OPERATIONS];
        let whole = Box {
            lower: self.region.lower,
            upper: self.region.upper,
            is_diagonal: false,
        };
        self.sample(&whole);
        self.push(whole);
        while let Some(next) = self.pop() {
            if self.boxes == MOST_BOXES {
                self.overflows = true;
                break;
            }
            self.boxes += 1;
            self.look(next, &mut scratch);
        }
        self.finish()
    }

    /// A distance to begin with: the least of a few points, and the point to which Newton's method leads from there.
    fn sample(&mut self, whole: &Box) {
        const SHARES: [f64; 4] = [0.08, 0.36, 0.64, 0.92];
        let near = |lower: f64, upper: f64| {
            let (low, high) = match upper - lower >= FAR {
                true => (-4.0, 4.0),
                false => (lower, upper),
            };
            SHARES.map(|share| (low + share * (high - low)).max(lower).min(upper))
        };
        let (mut start, mut least) = ([0.0; 2], f64::MAX);
        for first in near(whole.lower[0], whole.upper[0]) {
            for last in near(whole.lower[1], whole.upper[1]) {
                let last = match self.region.triangle {
                    true => last * (1.0 - first),
                    false => last,
                };
                let square = square(&self.sides.at(&[first, last]).r);
                if square < least {
                    (start, least) = ([first, last], square);
                }
            }
        }
        let (foot, steps) = descended(self.sides, start, whole);
        self.steps += steps;
        if !self.region.triangle || foot.zeta[0] + foot.zeta[1] <= 1.0 {
            (start, least) = match foot.square < least {
                true => (foot.zeta, foot.square),
                false => (start, least),
            };
        }
        // nothing farther than this point is searched; of a small distance its rounding is a large part
        let ends = self.sides.positions(&start).map(|end| sqrt(square(&end)));
        let scale = size(&self.sides.at(&start), self.region.p) + ends[0] + ends[1];
        let reach = sqrt(least) + ROUNDING * scale;
        self.best = self.best.min(reach * reach * (1.0 + SAME));
    }

    fn push(&mut self, next: Box) {
        match self.waiting.get_mut(self.count) {
            Some(place) => {
                *place = next;
                self.count += 1;
            }
            None => self.overflows = true,
        }
    }

    fn pop(&mut self) -> Option<Box> {
        self.count = self.count.checked_sub(1)?;
        self.waiting.get(self.count).copied()
    }

    /// Drops a box, takes its only minimum, or splits it.
    fn look(&mut self, mut next: Box, scratch: &mut Scratch) {
        if self.region.triangle && !next.is_diagonal && next.lower[0] + next.lower[1] > 1.0 {
            return;
        }
        let known = Enclosure::new(self.sides, &next, self.region.p, scratch);
        if known.least > self.best * (1.0 + SAME) {
            return;
        }
        match self.shrink(&mut next, &known.slopes) {
            Some(false) => return,
            Some(true) => return self.push(next),
            None => {}
        }
        let widths = self.widths(&next);
        let widest = if widths[1] > widths[0] { 1 } else { 0 };
        let is_wide = |i: usize| i < self.region.p && next.upper[i] > next.lower[i];
        let wide = [is_wide(0), is_wide(1) && !next.is_diagonal];
        if known.is_convex(wide) || known.is_point || widths[widest] < NARROW {
            let (foot, steps) = least_in_box(self.sides, &next, self.region.triangle);
            self.steps += steps;
            let is_cut = self.is_cut(&next, &foot);
            return self.take(foot, is_cut);
        }
        let (low, high) = next.halves(widest);
        self.push(low);
        self.push(high);
    }

    /// Where r·r has no stationary point along a parameter: drops the box (false) or leaves the face of the
    /// domain towards which it falls (true).
    fn shrink(&self, next: &mut Box, slopes: &[Interval; 2]) -> Option<bool> {
        let ends = if next.is_diagonal {
            ([0.0; 2], [1.0; 2])
        } else {
            (self.region.lower, self.region.upper)
        };
        for i in (0..2).take(self.region.p) {
            if next.upper[i] <= next.lower[i] || (next.is_diagonal && i == 1) {
                continue;
            }
            if slopes[i].lower > 0.0 {
                if next.lower[i] > ends.0[i] {
                    return Some(false);
                }
                next.keep(i, next.lower[i]);
                return Some(true);
            }
            if slopes[i].upper < 0.0 {
                if self.region.triangle && !next.is_diagonal {
                    if next.upper[0] + next.upper[1] < 1.0 {
                        return Some(false);
                    }
                    return Some(next.move_to_diagonal());
                }
                if next.upper[i] < ends.1[i] {
                    return Some(false);
                }
                next.keep(i, next.upper[i]);
                return Some(true);
            }
        }
        None
    }

    /// Widths relative to the extents; of unbounded parameters their own size.
    fn widths(&self, next: &Box) -> [f64; 2] {
        [0_usize, 1].map(|i| {
            let i = i.min(1);
            let width = (next.upper[i] - next.lower[i]) / self.extent(i);
            if next.is_diagonal && i == 1 {
                0.0
            } else {
                width
            }
        })
    }

    fn extent(&self, i: usize) -> f64 {
        let i = i.min(1);
        let extent = self.region.upper[i] - self.region.lower[i];
        // never zero: the compiler may divide by it before the branch that tests it
        if extent > 0.0 && extent < FAR {
            extent
        } else {
            1.0
        }
    }

    /// Keeps the nearer of two feet.
    fn take(&mut self, foot: Foot, is_cut: bool) {
        let near = |other: &Foot| {
            (0..2)
                .take(self.region.p)
                .all(|i| abs(foot.zeta[i] - other.zeta[i]) <= NEAR * self.extent(i))
        };
        let Some(best) = self.foot else {
            if foot.square <= self.best * (1.0 + SAME) {
                (self.foot, self.is_cut) = (Some(foot), is_cut);
                self.best = foot.square.min(self.best);
            }
            return;
        };
        if foot.square > best.square * (1.0 + SAME) {
            return;
        }
        if foot.square < best.square * (1.0 - SAME) {
            self.is_double = false;
        } else if !is_cut && !self.is_cut && !near(&best) && self.are_apart(&foot, &best) {
            self.is_double = true;
        }
        // of two equally near ones the one that no box cuts off
        let is_kept = if is_cut == self.is_cut {
            foot.square < best.square
        } else {
            self.is_cut
        };
        if is_kept || foot.square < best.square * (1.0 - SAME) {
            (self.foot, self.is_cut) = (Some(foot), is_cut);
        }
        self.best = self.best.min(foot.square);
    }

    /// True where a side of the box that is not a side of the domain holds the foot: r·r falls beyond it, by more than
    /// rounding.
    fn is_cut(&self, within: &Box, foot: &Foot) -> bool {
        let local = self.sides.at(&foot.zeta);
        let mut fall = [0_usize, 1].map(|i| -dot(&local.r, &local.b[i.min(1)]));
        let on_diagonal = self.region.triangle && foot.zeta[0] + foot.zeta[1] >= 1.0 - 1e-12;
        if on_diagonal && fall[0] + fall[1] > 0.0 {
            let along = 0.5 * (fall[0] - fall[1]);
            fall = [along, -along];
        }
        let (low, high) = (self.region.lower, self.region.upper);
        (0..2).take(self.region.p).any(|i| {
            let i = i.min(1);
            let rounding = self.rounding(i, &local);
            let below = foot.zeta[i] <= within.lower[i] && within.lower[i] > low[i];
            let above = foot.zeta[i] >= within.upper[i] && within.upper[i] < high[i];
            below && fall[i] < -rounding || above && fall[i] > rounding
        })
    }

    /// What f_i may be at a foot.
    fn rounding(&self, i: usize, local: &Local<f64>) -> f64 {
        1e-12 * sqrt(square(&local.b[i.min(1)])) * size(local, self.region.p)
    }

    /// Two feet are two points of the slave or of the master: not the same one of a closed curve.
    fn are_apart(&self, a: &Foot, b: &Foot) -> bool {
        let size = size(&self.sides.at(&a.zeta), self.region.p);
        let (first, last) = (self.sides.positions(&a.zeta), self.sides.positions(&b.zeta));
        first.iter().zip(last).any(|(first, last)| {
            let difference = [first[0] - last[0], first[1] - last[1], first[2] - last[2]];
            square(&difference) > NEAR * NEAR * size * size
        })
    }

    fn finish(self) -> Closest {
        let mut closest = Closest {
            verdict: Verdict::Beyond,
            zeta: [0.0; 2],
            distance: 0.0,
            feature: 0,
            definiteness: 0.0,
            boxes: self.boxes,
            steps: self.steps,
        };
        if let Some(foot) = self.foot {
            let local = self.sides.at(&foot.zeta);
            closest.zeta = foot.zeta;
            closest.distance = sqrt(foot.square);
            closest.feature = self
                .region
                .feature(&foot.zeta, &self.outward(&foot, &local));
            closest.definiteness = definiteness(&local, self.region.p);
            closest.verdict = if self.is_double {
                Verdict::NotUnique
            } else if closest.feature != 0 {
                Verdict::Boundary
            } else if closest.definiteness > REGULAR {
                Verdict::Inside
            } else {
                Verdict::NotUnique
            };
        }
        if self.overflows {
            closest.verdict = Verdict::Undecided;
        }
        closest
    }

    /// The sides of the domain that hold a foot: r·r falls beyond them, by more than rounding.
    fn outward(&self, foot: &Foot, local: &Local<f64>) -> [f64; 2] {
        let slopes = [0_usize, 1].map(|i| {
            let i = i.min(1);
            dot(&local.r, &local.b[i])
        });
        let rounding = |i: usize| self.rounding(i, local);
        let (low, high) = (self.region.lower, self.region.upper);
        let slack = |i: usize| 1e-12 * self.extent(i);
        let on_low = [0_usize, 1].map(|i| foot.zeta[i.min(1)] <= low[i.min(1)] + slack(i));
        // how strongly the diagonal holds it; at its ends together with the other side
        let pull = match on_low {
            [_, true] => -slopes[0],
            [true, _] => -slopes[1],
            _ => -0.5 * (slopes[0] + slopes[1]),
        };
        let diagonal = self.region.triangle
            && foot.zeta[0] + foot.zeta[1] >= 1.0 - slack(0)
            && pull > rounding(0).max(rounding(1));
        let held = [0_usize, 1].map(|i| {
            let i = i.min(1);
            let slope = slopes[i] + if diagonal { pull } else { 0.0 };
            let below = on_low[i] && slope > rounding(i);
            let above = foot.zeta[i] >= high[i] - slack(i) && slope < -rounding(i);
            let is_projected = i < self.region.p;
            (is_projected && below, is_projected && above)
        });
        let [(low_0, high_0), (low_1, high_1)] = held;
        match (diagonal, low_0, low_1) {
            (false, ..) => [side(low_0, high_0), side(low_1, high_1)],
            // beyond the diagonal, and beyond one of its ends
            (true, true, _) => [-1.0, 2.0],
            (true, _, true) => [2.0, -1.0],
            (true, ..) => [1.0, 1.0],
        }
    }
}

/// −1 below, 1 above, else 0.
fn side(is_below: bool, is_above: bool) -> f64 {
    f64::from(u8::from(is_above)) - f64::from(u8::from(is_below))
}
