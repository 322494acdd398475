//! One library under test with the memory that it is given, and the choice of what to call.

use std::sync::atomic::Ordering::Relaxed;

use rustix::time::{ClockId, clock_gettime};

use crate::element::Element;
use crate::entropy::Entropy;
use crate::interface::Interface;
use crate::ledger::{Ledger, count};
use crate::memory::Slot;
use crate::traps::Exceptions;
use crate::{batch, describe, evaluate, fortran, histories, patch, project, sparse};

/// Integers behind addresses of one call.
const INTEGERS: usize = 12;

/// What a case ends with: nothing, or what was found.
pub type Checked = Result<(), String>;

/// Memory of each argument.
pub struct Slots {
    /// The struct of a call.
    pub arguments: Slot,
    /// Reference coordinates.
    pub x: Slot,
    /// Displacements.
    pub u: Slot,
    /// Parameters.
    pub parameters: Slot,
    /// Accepted history, outputs as inputs of a transfer.
    pub old: Slot,
    /// Trial history.
    pub new: Slot,
    /// Row of an interpolated slave.
    pub row: Slot,
    /// Residual.
    pub f: Slot,
    /// Tangent.
    pub k: Slot,
    /// Map of unknowns, connectivity.
    pub map: Slot,
    /// Output, text.
    pub output: Slot,
    /// Energy.
    pub energy: Slot,
    /// Workspace.
    pub workspace: Slot,
    /// Statuses of a batch.
    pub status: Slot,
    /// Codes of a batch.
    pub code: Slot,
    /// Scatter map, rows of a sparse matrix.
    pub csr_map: Slot,
    /// Sparse values, columns.
    pub csr_values: Slot,
    /// Global residual.
    pub global_f: Slot,
    /// Results of a projection.
    pub result: Slot,
    /// The struct of a patch.
    pub patch: Slot,
    /// Its connectivity.
    pub connectivity: Slot,
    /// Integers behind addresses.
    pub integers: [Slot; INTEGERS],
}

impl Slots {
    fn new() -> rustix::io::Result<Self> {
        let integers: Vec<Slot> = (0..INTEGERS)
            .map(|_| Slot::new())
            .collect::<Result<_, _>>()?;
        let integers: [Slot; INTEGERS] = integers.try_into().expect("as many");
        Ok(Self {
            arguments: Slot::new()?,
            x: Slot::new()?,
            u: Slot::new()?,
            parameters: Slot::new()?,
            old: Slot::new()?,
            new: Slot::new()?,
            row: Slot::new()?,
            f: Slot::new()?,
            k: Slot::new()?,
            map: Slot::new()?,
            output: Slot::new()?,
            energy: Slot::new()?,
            workspace: Slot::new()?,
            status: Slot::new()?,
            code: Slot::new()?,
            csr_map: Slot::new()?,
            csr_values: Slot::new()?,
            global_f: Slot::new()?,
            result: Slot::new()?,
            patch: Slot::new()?,
            connectivity: Slot::new()?,
            integers,
        })
    }
}

/// A library under test.
pub struct Harness {
    /// Its functions.
    pub interface: Interface,
    /// Its elements.
    pub elements: Vec<Element>,
    /// Those that are called.
    pub selected: Vec<usize>,
    /// Memory that it is given.
    pub slots: Slots,
    /// What was done.
    pub ledger: &'static Ledger,
    /// Whether the inputs of every call are printed.
    pub verbose: bool,
}

impl Harness {
    /// A harness for the elements whose name contains `filter`.
    pub fn new(
        interface: Interface,
        filter: &str,
        ledger: &'static Ledger,
    ) -> Result<Self, String> {
        let elements = Element::all(&interface)?;
        let matches = |&index: &usize| elements[index].name.contains(filter);
        let selected: Vec<usize> = (0..elements.len()).filter(matches).collect();
        if selected.is_empty() {
            return Err(format!("no element's name contains `{filter}`"));
        }
        Ok(Self {
            interface,
            elements,
            selected,
            slots: Slots::new().map_err(|error| format!("no pages: {error}"))?,
            ledger,
            verbose: false,
        })
    }

    /// One of the selected elements.
    pub fn element(&self, entropy: &mut Entropy) -> usize {
        self.selected[entropy.below(self.selected.len())]
    }

    /// One call, or a few that belong together, with all that is asserted of them.
    pub fn case(&mut self, entropy: &mut Entropy) -> Checked {
        match entropy.below(512) {
            0..2 => project::case(self, entropy),
            2..32 => describe::case(self, entropy),
            32..96 => histories::case(self, entropy),
            96..144 => fortran::case(self, entropy),
            144..160 => sparse::case(self, entropy),
            160..256 => batch::case(self, entropy),
            256..260 => patch::case(self, entropy),
            _ => evaluate::case(self, entropy),
        }
    }

    /// Calls the library with traps on, and notes that it did.
    pub fn call<R>(&self, function: usize, call: impl FnOnce() -> R) -> R {
        self.noting(function, Exceptions::Trap, call).0
    }

    /// Calls the library; the exceptions that it raised.
    pub fn noting<R>(
        &self,
        function: usize,
        exceptions: Exceptions,
        call: impl FnOnce() -> R,
    ) -> (R, Option<String>) {
        count(&self.ledger.calls[function]);
        let start = processor_time();
        let result = exceptions.during(call);
        self.ledger.time(function, processor_time() - start);
        result
    }

    /// Prints the inputs of a call that is looked at alone.
    pub fn show(&self, what: &str, inputs: &dyn std::fmt::Debug) {
        if self.verbose {
            println!("{what} {inputs:?}");
        }
    }

    /// The call under way.
    pub fn begin(&self, call: u64) {
        self.ledger.current.store(call + 1, Relaxed);
        count(&self.ledger.begun);
    }
}

/// Processor time of this thread [ns].
fn processor_time() -> u64 {
    let time = clock_gettime(ClockId::ThreadCPUTime);
    time.tv_sec as u64 * 1_000_000_000 + time.tv_nsec as u64
}
