//! What a run has done, as tables.

use std::sync::atomic::AtomicU64;
use std::sync::atomic::Ordering::Relaxed;

use comfy_table::Table;
use comfy_table::presets::ASCII_MARKDOWN;

use crate::ledger::{CODES, ELEMENTS, FUNCTIONS, LEAST_CODE, Ledger};
use crate::numbers::NUMBERS;
use crate::parent::Summary;

impl Summary {
    /// The sum of a counter over all workers.
    fn sum(&self, counter: impl Fn(&Ledger) -> &AtomicU64) -> u64 {
        let each = self
            .ledgers
            .iter()
            .map(|ledger| counter(ledger).load(Relaxed));
        each.sum()
    }

    /// Calls of each function.
    pub fn calls(&self) -> [u64; FUNCTIONS.len()] {
        std::array::from_fn(|function| self.sum(|ledger| &ledger.calls[function]))
    }

    /// Cases begun.
    pub fn begun(&self) -> u64 {
        self.sum(|ledger| &ledger.begun)
    }

    /// How often an evaluation ended with each documented status.
    pub fn status(&self, status: i32) -> u64 {
        self.sum(|ledger| &ledger.statuses[status as usize])
    }

    /// How often any function returned this code.
    pub fn code(&self, code: i32) -> u64 {
        let at = (code - LEAST_CODE) as usize;
        (0..FUNCTIONS.len())
            .map(|function| self.sum(|ledger| &ledger.codes[function][at]))
            .sum()
    }

    /// Elements that were evaluated, and those that were in contact.
    pub fn elements(&self) -> [usize; 2] {
        let reached = |counter: fn(&Ledger, usize) -> &AtomicU64| {
            let at = |&element: &usize| self.sum(|ledger| counter(ledger, element)) > 0;
            (0..ELEMENTS).filter(at).count()
        };
        [
            reached(|ledger, element| &ledger.evaluated[element]),
            reached(|ledger, element| &ledger.contacts[element]),
        ]
    }

    /// The tables.
    pub fn text(&self) -> String {
        let mut functions = Table::new();
        functions.load_style(ASCII_MARKDOWN);
        functions.set_header(["function", "calls", "codes", "slowest [ms]", "call"]);
        for (function, name) in FUNCTIONS.iter().enumerate() {
            let (time, call) = self.slowest(function);
            functions.add_row([
                name.to_string(),
                self.calls()[function].to_string(),
                self.codes(function),
                format!("{:.3}", time as f64 * 1e-6),
                call.to_string(),
            ]);
        }
        let named = |(number, name): (&i32, &String), counter: &dyn Fn(usize) -> u64| {
            format!("{name} {}", counter(*number as usize))
        };
        let statuses: Vec<String> = NUMBERS
            .statuses
            .iter()
            .map(|entry| named(entry, &|at| self.sum(|ledger| &ledger.statuses[at])))
            .collect();
        let verdicts: Vec<String> = NUMBERS
            .verdicts
            .iter()
            .map(|entry| named(entry, &|at| self.sum(|ledger| &ledger.verdicts[at])))
            .collect();
        let [evaluated, contacts] = self.elements();
        format!(
            "{functions}\n\nstatuses: {}\nverdicts: {}\n\
             elements evaluated: {evaluated}, in contact: {contacts}\n\
             calls with a documented exception: {}\n\
             cases: {}, calls of the library: {}, time: {:.1} s, findings: {}",
            statuses.join(", "),
            verdicts.join(", "),
            self.sum(|ledger| &ledger.exceptions),
            self.begun(),
            self.calls().iter().sum::<u64>(),
            self.time.as_secs_f64(),
            self.findings.len(),
        )
    }

    /// Processor time [ns] and number of the slowest call of a function.
    fn slowest(&self, function: usize) -> (u64, u64) {
        let each = self.ledgers.iter().map(|ledger| {
            let [time, call] = &ledger.slowest[function];
            (time.load(Relaxed), call.load(Relaxed))
        });
        each.max().unwrap_or_default()
    }

    /// Codes of a function with their counts.
    fn codes(&self, function: usize) -> String {
        let mut list = Vec::new();
        for at in 0..CODES {
            let count = self.sum(|ledger| &ledger.codes[function][at]);
            if count > 0 {
                list.push(format!("{}: {count}", at as i32 + LEAST_CODE));
            }
        }
        list.join(", ")
    }
}
