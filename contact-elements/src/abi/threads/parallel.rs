//! Which thread evaluates which contacts, and when.
//!
//! The contacts are cut into rounds, a round into parts, one for each thread. In a round
//!
//! | step | each thread |
//! |---|---|
//! | 1 | marks the nodes of its part; a node belongs to the first part that has it |
//! | 2 | evaluates its part, adds to the shared entries of the part's nodes, writes down what goes to others |
//! | 3 | adds, for its share of the nodes, what the parts wrote down, part after part |
//!
//! A node's entries so receive what its part adds, then what later parts wrote down: the order of the contacts.

use std::sync::OnceLock;
use std::vec::Vec;

use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

use super::journal::{Journal, ROW, Sums, Turn};
use super::owners::Owners;
use crate::abi::batch::{self, Failures};
use crate::abi::batch_check::{Checked, Layout};
use crate::abi::sizes::Fault;
use crate::abi::types::Batch;
use crate::abi::{OUTPUT_SIZE, argument, code, request};
use crate::runtime::Width;

/// A part has at least so many contacts: blocks of the kernels in lanes stay full.
const FEWEST: usize = 16;
/// Rounds of a large batch, for threads whose parts take longer than others.
const ROUNDS: usize = 4;
/// Fewest contacts of a part, where there are several rounds: threads wait for each other three times in a round.
const WORTH_A_ROUND: usize = 2048;
/// Most numbers that a part may have to write down, for every point.
const MOST_WRITTEN: usize = 1 << 22;
/// Numbers that are added by one thread.
const ADDED_ALONE: usize = 1 << 12;

/// The fault of a batch for which the memory ran out half-way.
const NO_MEMORY: Fault = (code::WORKSPACE, argument::WORKSPACE, 0);

/// One thread per processor, kept from the first call on; none where the system refuses them.
fn pool() -> Option<&'static ThreadPool> {
    static POOL: OnceLock<Option<ThreadPool>> = OnceLock::new();
    let made = POOL.get_or_init(|| {
        let processors = std::thread::available_parallelism().map_or(1, usize::from);
        ThreadPoolBuilder::new()
            .num_threads(processors)
            .build()
            .ok()
    });
    made.as_ref()
}

/// Evaluates all contacts by several threads; 0: one per processor.
pub(super) fn all(checked: Checked<'_>, threads: usize) -> Result<Failures, Fault> {
    let width = Width::widest();
    let most = checked.count.div_ceil(FEWEST);
    if threads == 1 || most < 2 {
        return batch::all(checked, width);
    }
    let Some(pool) = pool() else {
        return batch::all(checked, width);
    };
    let threads = match threads {
        0 => pool.current_num_threads(),
        threads => threads,
    };
    // a fault of the caller's workspace is one here too
    checked.workspace()?;
    let round = Round::new(&checked, width, threads.min(most));
    let parts = round.as_ref().and_then(Round::parts);
    match (&round, parts) {
        (Some(round), Some(mut parts)) => pool.install(|| round.all(&mut parts)),
        // no memory: by one thread
        _ => batch::all(checked, width),
    }
}

/// What all threads read.
struct Round<'a> {
    checked: &'a Checked<'a>,
    width: Width,
    /// Of the shared entries, where there are any.
    owners: Option<Owners>,
    /// Parts of a round.
    parts: usize,
    /// Contacts of a part.
    length: usize,
}

/// Contacts that one thread evaluates in a round.
struct Part {
    first: usize,
    count: usize,
    mark: usize,
    workspace: Vec<f64>,
    journal: Journal,
    failures: Failures,
}

// SAFETY: the caller's arrays are there until the call returns; threads write outputs of their own contacts, entries of
// their own nodes and their own parts.
unsafe impl Sync for Round<'_> {}
// SAFETY: the journal points into the caller's map, which is only read.
unsafe impl Send for Part {}
// SAFETY: as above; a part that is shared is only read.
unsafe impl Sync for Part {}

impl<'a> Round<'a> {
    fn new(checked: &'a Checked<'a>, width: Width, parts: usize) -> Option<Self> {
        let batch = checked.batch;
        let adds_f = batch.request & request::RESIDUAL != 0 && !batch.global_f.is_null();
        let adds_k = batch.request & request::TANGENT != 0 && !batch.csr_values.is_null();
        let mut most = checked.count.div_ceil(parts * ROUNDS).max(WORTH_A_ROUND);
        let mut owners = None;
        if adds_f || adds_k {
            let nodes = usize::try_from(batch.global_nodes).ok()?;
            owners = Some(Owners::new(nodes)?);
            let unknowns = checked.unknowns();
            let numbers = if adds_k {
                unknowns * (unknowns + ROW)
            } else {
                unknowns
            };
            most = most.min(MOST_WRITTEN / numbers.max(1)).max(FEWEST);
        }
        // all rounds and parts of one size
        let rounds = checked.count.div_ceil(parts * most);
        let even = checked.count.div_ceil(parts * rounds.max(1));
        Some(Self {
            checked,
            width,
            owners,
            parts,
            length: even.next_multiple_of(FEWEST),
        })
    }

    /// Parts with a workspace each.
    fn parts(&self) -> Option<Vec<Part>> {
        let needed = self.checked.element.workspace(self.checked.nodes);
        let mut parts = Vec::new();
        parts.try_reserve_exact(self.parts).ok()?;
        for _ in 0..self.parts {
            let mut workspace = Vec::new();
            workspace.try_reserve_exact(needed).ok()?;
            workspace.resize(needed, 0.0);
            parts.push(Part {
                first: 0,
                count: 0,
                mark: 0,
                workspace,
                journal: Journal::default(),
                failures: Failures::NONE,
            });
        }
        Some(parts)
    }

    /// All rounds.
    fn all(&self, parts: &mut [Part]) -> Result<Failures, Fault> {
        let mut failures = Failures::NONE;
        let (mut first, mut mark) = (0, 0);
        while first < self.checked.count {
            mark += parts.len();
            for (number, part) in parts.iter_mut().enumerate() {
                part.first = first;
                part.count = self.length.min(self.checked.count - first);
                part.mark = mark - number;
                first += part.count;
            }
            self.one(parts);
            for part in parts.iter() {
                if failures.count == 0 && part.failures.count > 0 {
                    failures.argument = part.failures.argument;
                    failures.index = part.first + part.failures.index;
                }
                failures.count += part.failures.count;
            }
            if parts.iter().any(|part| part.journal.is_short) {
                return Err(NO_MEMORY);
            }
        }
        Ok(failures)
    }

    /// One round.
    fn one(&self, parts: &mut [Part]) {
        if let Some(owners) = &self.owners {
            parts
                .par_iter()
                .with_max_len(1)
                .for_each(|part| self.mark(owners, part));
        }
        parts
            .par_iter_mut()
            .with_max_len(1)
            .for_each(|part| self.evaluate(part));
        let written: usize = parts.iter().map(|part| part.journal.length()).sum();
        match written {
            0 => {}
            1..=ADDED_ALONE => self.add(parts, 0, 1),
            _ => (0..parts.len())
                .into_par_iter()
                .with_max_len(1)
                .for_each(|share| self.add(parts, share, parts.len())),
        }
    }

    /// Marks the nodes of a part.
    fn mark(&self, owners: &Owners, part: &Part) {
        let (nodes, list) = (self.checked.nodes, self.checked.batch.connectivity);
        // SAFETY: the connectivity has n · nodes entries, checked against global_nodes.
        unsafe {
            let list =
                core::slice::from_raw_parts(list.add(part.first * nodes), part.count * nodes);
            owners.mark(list, part.mark);
        }
    }

    /// Evaluates the contacts of a part.
    fn evaluate(&self, part: &mut Part) {
        part.journal.clear();
        part.failures = Failures::NONE;
        if part.count == 0 {
            return;
        }
        let mut batch: Batch = *self.checked.batch;
        let mut own: Checked<'_> = self.checked.part((part.first, part.count), &mut batch);
        if let Some(owners) = &self.owners {
            own.turn = Turn::new(&raw mut part.journal, owners.first(), part.mark);
        }
        part.failures = batch::evaluate(own, &mut part.workspace, self.width);
    }

    /// Adds what the parts wrote down, for a share of the nodes.
    fn add(&self, parts: &[Part], share: usize, shares: usize) {
        let sums = Sums {
            global_f: self.checked.batch.global_f,
            csr_values: self.checked.batch.csr_values,
        };
        for part in parts {
            // SAFETY: the parts have been evaluated, and shares have no node in common.
            unsafe { part.journal.add(sums, share, shares) };
        }
    }
}

impl Checked<'_> {
    /// So many of its contacts, from `first` on; `batch` becomes their struct.
    fn part<'b>(&self, (first, count): (usize, usize), batch: &'b mut Batch) -> Checked<'b>
    where
        Self: 'b,
    {
        let (map, history) = (self.map_size(), self.element.history());
        let output = self.element.points * OUTPUT_SIZE;
        batch.x = moved(batch.x, first, self.x.element);
        batch.u = moved(batch.u, first, self.u.element);
        batch.connectivity = moved(batch.connectivity, first, self.nodes);
        batch.parameters = moved(batch.parameters, first, self.parameter_stride);
        batch.history_accepted = moved(batch.history_accepted, first, history);
        batch.slave_row = moved(batch.slave_row, first, self.nslave + 1);
        batch.csr_map = moved(batch.csr_map, first, map);
        batch.history_trial = moved(batch.history_trial, first, history).cast_mut();
        batch.f = moved(batch.f, first, self.f_stride).cast_mut();
        batch.k = moved(batch.k, first, self.k_stride).cast_mut();
        batch.output = moved(batch.output, first, output).cast_mut();
        batch.energy = moved(batch.energy, first, 1).cast_mut();
        batch.status = moved(batch.status, first, 1).cast_mut();
        batch.code = moved(batch.code, first, 1).cast_mut();
        let shorter = |layout: Layout| Layout {
            length: layout.length - (self.count - count) * layout.element,
            ..layout
        };
        Checked {
            batch,
            count,
            x: shorter(self.x),
            u: shorter(self.u),
            ..*self
        }
    }
}

/// The pointer moved to contact `first`, or null. Pointers that the request does not need are not looked at.
fn moved<T>(pointer: *const T, first: usize, apart: usize) -> *const T {
    if pointer.is_null() {
        pointer
    } else {
        pointer.wrapping_add(first.wrapping_mul(apart))
    }
}
