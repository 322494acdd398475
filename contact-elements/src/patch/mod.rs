//! Patches: slave points against facets with their common edges and vertices. [eq:transition]
//!
//! Each slave point takes part in one pair: its facet where it projects inside, else the edge or vertex that holds
//! the closest point of the whole patch. The first pass finds the pairs and tries them, the second adds them up, so
//! that a failure leaves everything as it was.
//!
//! | file | question |
//! |---|---|
//! | `checked` | what is a patch, and can it be evaluated |
//! | `boundary` | what are the edges and vertices of a facet |
//! | `values` | which parameters and nodes belong to a facet |
//! | `closest_place` | where is a slave point closest to the patch |
//! | `pseudonormal` | on which side of an edge or vertex is it |
//! | `pair` | which pair does it take part in, and what does that give |
//! | `sums` | where do the sums go |
//! | `run` | both passes |

mod boundary;
pub(crate) mod checked;
mod closest_place;
mod pair;
mod pseudonormal;
pub(crate) mod run;
mod slices;
pub(crate) mod sums;
mod values;

pub use checked::Patch;
pub use slices::{PatchSizes, evaluate_patch};
