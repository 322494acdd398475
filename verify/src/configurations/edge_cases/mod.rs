//! States where elements tend to fail, each with what must come out.

mod angles;
mod case;
mod curves;
mod friction;
mod rigid;
mod surfaces;

pub use case::{EdgeCase, Expected};

/// All edge cases.
pub fn edge_cases() -> Vec<EdgeCase> {
    let mut cases = surfaces::edge_cases();
    cases.extend(curves::edge_cases());
    cases.extend(rigid::edge_cases());
    cases.extend(friction::edge_cases());
    cases.extend(angles::edge_cases());
    cases
}
