//! Which thread evaluates which contacts, and when.
//!
//! The contacts are cut into rounds, and each round into parts, one for each thread. In a round:
//!
//! | step | each thread |
//! |---|---|
//! | 1 | marks the nodes of its part; a node belongs to the first part that has it |
//! | 2 | evaluates its part, adds to the shared entries of the part's nodes, records what goes to others |
//! | 3 | adds, for its share of the nodes, what the parts recorded, part after part |
//!
//! A node's entries thus receive first what its part adds, then what later parts recorded: the order of the contacts.

use std::sync::OnceLock;
use std::vec::Vec;

use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

use super::owners::Owners;
use crate::abi::batch::{Work, evaluate};
use crate::abi::journal::{Journal, ROW, Sums};
use crate::abi::outputs::Pointers;
use crate::abi::ownership::Ownership;
use crate::codes::{argument, code, request};
use crate::error::Error;
use crate::evaluation::batch::run::Failures;
use crate::lanes::Width;

/// Fewest contacts of a part: blocks of the kernels in lanes stay full.
const FEWEST: usize = 16;
/// Number of rounds of a large batch: it helps when some threads take longer than others.
const ROUNDS: usize = 4;
/// Fewest contacts of a part when there are several rounds: threads wait for each other three times in a round.
const WORTH_A_ROUND: usize = 2048;
/// Most numbers that a part may have to record, for every point.
const MOST_WRITTEN: usize = 1 << 22;
/// Numbers that are added by one thread.
const ADDED_ALONE: usize = 1 << 12;

/// The fault of a batch whose memory ran out midway.
const NO_MEMORY: Error = Error::new(code::WORKSPACE, argument::WORKSPACE, 0);

/// One thread per processor, kept from the first call on; `None` if the system refuses them.
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

/// Evaluates all contacts by several threads; 0 means one per processor.
pub(super) fn all(work: &Work<'_>, threads: usize) -> Result<Failures, Error> {
    let width = Width::widest();
    let most = work.shape.count.div_ceil(FEWEST);
    if threads == 1 || most < 2 {
        return work.all(width);
    }
    let Some(pool) = pool() else {
        return work.all(width);
    };
    let threads = match threads {
        0 => pool.current_num_threads(),
        threads => threads,
    };
    // a fault of the caller's workspace is one here too
    work.workspace()?;
    let round = Round::new(work, width, threads.min(most));
    let parts = round.as_ref().and_then(Round::parts);
    match (&round, parts) {
        (Some(round), Some(mut parts)) => pool.install(|| round.all(&mut parts)),
        // no memory: one thread does the work
        _ => work.all(width),
    }
}

/// What all threads read.
struct Round<'a> {
    work: &'a Work<'a>,
    width: Width,
    /// Journal and marks of the shared entries, if there are any.
    owners: Option<Owners>,
    /// Parts of a round.
    parts: usize,
    /// Contacts of a part.
    length: usize,
}

/// Contacts that one thread evaluates in a round.
struct Part<'a> {
    first: usize,
    count: usize,
    mark: usize,
    workspace: Vec<f64>,
    journal: Journal<'a>,
    failures: Failures,
}

// SAFETY: the caller's arrays are there until the call returns; threads write outputs of their own contacts, entries of
// their own nodes and their own parts.
unsafe impl Sync for Round<'_> {}
// SAFETY: the journal points into the caller's map, which is only read.
unsafe impl Send for Part<'_> {}
// SAFETY: as above; a part that is shared is only read.
unsafe impl Sync for Part<'_> {}

impl<'a> Round<'a> {
    fn new(work: &'a Work<'a>, width: Width, parts: usize) -> Option<Self> {
        let (batch, shape) = (work.batch, &work.shape);
        let adds_f = batch.request & request::RESIDUAL != 0 && !batch.global_f.is_null();
        let adds_k = batch.request & request::TANGENT != 0 && !batch.csr_values.is_null();
        let mut most = shape.count.div_ceil(parts * ROUNDS).max(WORTH_A_ROUND);
        let mut owners = None;
        if adds_f || adds_k {
            let nodes = usize::try_from(batch.global_nodes).ok()?;
            owners = Some(Owners::new(nodes)?);
            let unknowns = shape.unknowns();
            let numbers = if adds_k {
                unknowns * (unknowns + ROW)
            } else {
                unknowns
            };
            most = most.min(MOST_WRITTEN / numbers.max(1)).max(FEWEST);
        }
        // all rounds and parts of one size
        let rounds = shape.count.div_ceil(parts * most);
        let even = shape.count.div_ceil(parts * rounds.max(1));
        Some(Self {
            work,
            width,
            owners,
            parts,
            length: even.next_multiple_of(FEWEST),
        })
    }

    /// Parts with a workspace each.
    fn parts(&self) -> Option<Vec<Part<'a>>> {
        let needed = self.work.element.workspace(self.work.shape.nodes);
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
    fn all(&self, parts: &mut [Part<'a>]) -> Result<Failures, Error> {
        let mut failures = Failures::NONE;
        let (mut first, mut mark) = (0, 0);
        while first < self.work.shape.count {
            mark += parts.len();
            for (number, part) in parts.iter_mut().enumerate() {
                part.first = first;
                part.count = self.length.min(self.work.shape.count - first);
                part.mark = mark - number;
                first += part.count;
            }
            self.one(parts);
            for part in parts.iter() {
                if let Some((contact, error)) = part.failures.first {
                    let first = (part.first + contact, error);
                    failures.first.get_or_insert(first);
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
    fn one(&self, parts: &mut [Part<'a>]) {
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

    /// Model nodes of the contacts of a part.
    fn nodes(&self, part: &Part<'_>) -> &'a [i32] {
        let nodes = self.work.shape.nodes;
        let list = self.work.arrays.connectivity.unwrap_or(&[]);
        let own = list.get(part.first * nodes..).unwrap_or_default();
        own.get(..part.count * nodes).unwrap_or_default()
    }

    /// Marks the nodes of a part.
    fn mark(&self, owners: &Owners, part: &Part<'_>) {
        // SAFETY: the connectivity was checked against global_nodes.
        unsafe { owners.mark(self.nodes(part), part.mark) };
    }

    /// Evaluates the contacts of a part.
    fn evaluate(&self, part: &mut Part<'a>) {
        part.journal.clear();
        part.failures = Failures::NONE;
        if part.count == 0 {
            return;
        }
        let work = self.work;
        let shape = work.shape.part(part.count);
        let arrays = work.arrays.part(&work.shape, part.first, part.count);
        let map = work.map.get(part.first * shape.map_size()..);
        let (map, nodes) = (map.unwrap_or_default(), self.nodes(part));
        let ownership = match &self.owners {
            // SAFETY: journal and marks live until the part is done, and nothing else refers to the journal.
            Some(owners) => unsafe {
                Ownership::new(&raw mut part.journal, owners.first(), part.mark)
            },
            None => Ownership::FREE,
        };
        // SAFETY: promised by the caller of the batch.
        let mut outputs =
            unsafe { Pointers::new(&shape, work.batch, part.first, map, nodes, ownership) };
        let memory = &mut part.workspace;
        part.failures = evaluate(
            work.element,
            &shape,
            &arrays,
            &mut outputs,
            memory,
            self.width,
        );
    }

    /// Adds what the parts recorded, for a share of the nodes.
    fn add(&self, parts: &[Part<'_>], share: usize, shares: usize) {
        let sums = Sums {
            global_f: self.work.batch.global_f,
            csr_values: self.work.batch.csr_values,
        };
        for part in parts {
            // SAFETY: the parts have been evaluated, and shares have no node in common.
            unsafe { part.journal.add(sums, share, shares) };
        }
    }
}
