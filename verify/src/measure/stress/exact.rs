//! Doubles as they are, in octuple precision.

use crate::oracle::octuple::Octuple;

/// Nodes of `dimension` coordinates each.
pub fn nodes(positions: &[f64], dimension: usize) -> Vec<[Octuple; 3]> {
    let node = |v: &[f64]| std::array::from_fn(|c| Octuple::from(v.get(c).copied().unwrap_or(0.0)));
    positions.chunks(dimension).map(node).collect()
}
