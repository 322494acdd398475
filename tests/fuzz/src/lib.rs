//! Arbitrary bit patterns through the C interface: what is asserted and how to run it stands in `docs/fuzzing.md`.

pub mod arguments;
pub mod batch;
pub mod check;
pub mod contacts;
pub mod describe;
pub mod element;
pub mod entropy;
pub mod evaluate;
pub mod fortran;
pub mod harness;
pub mod histories;
pub mod interface;
pub mod ledger;
pub mod memory;
pub mod numbers;
pub mod parent;
pub mod plan;
pub mod project;
pub mod report;
pub mod sabotage;
pub mod sparse;
pub mod state;
pub mod traps;
pub mod worker;
