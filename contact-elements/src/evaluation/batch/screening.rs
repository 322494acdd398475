//! Which contacts of a batch are evaluated: all, or with `CTE_SCREEN` those that are not certainly open. The others
//! are settled at once.

use super::run::{Run, ScreenKernel};
use crate::batch::block::ROOM;
use crate::batch::screen::SCREENED;
use crate::codes::request;
use crate::element::receiver::{Receiver, Report};
use crate::point::history::HistoryLayout;
use crate::point::motion::Rolling;
use crate::point::values::Status;

impl Run<'_> {
    /// The numbers of the next contacts that are to be evaluated.
    #[inline]
    pub(crate) fn next_to_evaluate(&mut self, numbers: &mut [usize; ROOM]) -> usize {
        let count = self.shape.count;
        let Some(kernel) = self.screening.kernel else {
            let first = self.screening.next;
            let length = ROOM.min(count - first);
            for (offset, number) in numbers.iter_mut().enumerate().take(length) {
                *number = first + offset;
            }
            self.screening.next = first + length;
            return length;
        };
        let mut found = 0;
        for number in numbers {
            while self.screening.left == 0 {
                if self.screening.next == count {
                    return found;
                }
                self.look_on(kernel);
            }
            let left = &mut self.screening.left;
            *number = self.screening.first + left.trailing_zeros() as usize;
            *left &= *left - 1;
            found += 1;
        }
        found
    }

    /// Looks at further contacts and settles the open ones.
    fn look_on(&mut self, kernel: ScreenKernel) {
        let first = self.screening.next;
        let count = SCREENED.min(self.shape.count - first);
        let mut bounds = [0.0; SCREENED];
        let mut open = kernel(self, (first, count), &mut bounds);
        let all = (u64::MAX >> (64 - count as u32 % 64)) as u32;
        let leaves_nothing = self.leaves_nothing();
        let mut rest = open;
        while rest != 0 {
            let slot = rest.trailing_zeros();
            rest &= rest - 1;
            let number = first + slot as usize;
            let bound = bounds.get(slot as usize).copied().unwrap_or(0.0);
            if leaves_nothing || self.leave(number, bound) {
                self.note(number, Ok(Status::Open));
            } else {
                open &= !(1 << slot);
            }
        }
        self.screening.next = first + count;
        self.screening.first = first;
        self.screening.left = all & !open;
    }

    /// True where an open contact has no outputs but its status: only sums are asked for.
    fn leaves_nothing(&self) -> bool {
        let asks = |bit: u32| self.shape.wants(bit);
        let has = &self.shape.form.has;
        let has_own = asks(request::RESIDUAL) && has.f || asks(request::TANGENT) && has.k;
        !has_own && !asks(request::HISTORY | request::OUTPUT | request::ENERGY)
    }

    /// Outputs of an open contact that was not projected; false, and nothing is written, where its history is refused.
    fn leave(&mut self, number: usize, bound: f64) -> bool {
        let shape = self.shape;
        let element = shape.element;
        let history = self.arrays.history(shape, number);
        let is_reported = shape.wants(request::HISTORY | request::OUTPUT);
        let mut zeta = element.centre;
        if let (Some(history), true) = (history, is_reported) {
            let layout = element.history_layout();
            if layout.check(&element.reach(), &history).is_err() {
                return false;
            }
            for (i, to) in zeta.iter_mut().enumerate().take(element.projected) {
                *to = history.get(HistoryLayout::PROJECTION + i).unwrap_or(*to);
            }
        }
        let mut target = self.outputs.target(number);
        target.open(shape.unknowns());
        if is_reported {
            target.report(0, &report(bound, zeta));
        }
        target.energy(0.0);
        true
    }
}

/// What is known of an open contact that was not projected.
fn report(bound: f64, zeta: [f64; 2]) -> Report {
    Report {
        status: Status::Open,
        feature: 0,
        gap: bound,
        traction: 0.0,
        weight: 0.0,
        zeta,
        normal: [0.0; 3],
        iterations: 0,
        tangential: [0.0; 2],
        tangents: [[0.0; 3]; 2],
        anchor: [0.0; 2],
        path: 0.0,
        multiplier: 0.0,
        rolling: Rolling::default(),
    }
}
