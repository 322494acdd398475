//! The states of a long run that had the largest errors. The proof repeats them, so that a short run finds the same
//! largest errors as the long one.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

/// Seed of the long run. State numbers mean nothing for another seed.
pub const SEED: u64 = 20_150;

/// Element, status that the states were built for, and numbers of the states.
const RECORDED: &str = include_str!("../../data/hardest_states.csv");

/// Numbers of states by element and status.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Hardest(BTreeMap<(String, String), BTreeSet<u64>>);

impl Hardest {
    /// The recorded states; no state for a seed other than [`SEED`].
    pub fn of_seed(seed: u64) -> Self {
        if seed == SEED {
            Self::read(RECORDED)
        } else {
            Self::default()
        }
    }

    /// Reads lines `element,status,state state …`; the first line holds the heads of the columns.
    fn read(text: &str) -> Self {
        let mut hardest = Self::default();
        for line in text.lines().skip(1) {
            let mut cells = line.splitn(3, ',');
            let (Some(element), Some(status), Some(states)) =
                (cells.next(), cells.next(), cells.next())
            else {
                continue;
            };
            for state in states.split(' ').filter_map(|state| state.parse().ok()) {
                hardest.add(element, status, state);
            }
        }
        hardest
    }

    /// Adds a state.
    pub fn add(&mut self, element: &str, status: &str, state: u64) {
        let key = (element.to_string(), status.to_string());
        self.0.entry(key).or_default().insert(state);
    }

    /// The states of an element and status from number `first` on.
    pub fn states(&self, element: &str, status: &str, first: u64) -> Vec<u64> {
        let key = (element.to_string(), status.to_string());
        let all = self.0.get(&key).into_iter().flatten();
        all.copied().filter(|&state| state >= first).collect()
    }

    /// The file, as it is read.
    pub fn to_csv(&self) -> String {
        let mut text = String::from("element,status,states\n");
        for ((element, status), states) in &self.0 {
            let states: Vec<String> = states.iter().map(u64::to_string).collect();
            // writing to a string cannot fail
            let _ = writeln!(text, "{element},{status},{}", states.join(" "));
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::subject::built_in;

    #[test]
    fn a_list_is_read_as_it_was_written() {
        let mut hardest = Hardest::default();
        for state in [7, 3970, 12] {
            hardest.add("PointQuad4", "closed", state);
        }
        assert_eq!(Hardest::read(&hardest.to_csv()), hardest);
        assert_eq!(hardest.states("PointQuad4", "closed", 10), [12, 3970]);
        assert!(hardest.states("PointQuad4", "open", 0).is_empty());
    }

    #[test]
    fn every_recorded_element_exists() {
        let subjects = built_in().unwrap_or_else(|unknown| panic!("{unknown}"));
        let recorded = Hardest::of_seed(SEED);
        assert!(!recorded.0.is_empty());
        for (element, _) in recorded.0.keys() {
            assert!(
                subjects.iter().any(|subject| subject.name() == element),
                "{element}"
            );
        }
        assert!(Hardest::of_seed(SEED + 1).0.is_empty());
    }
}
