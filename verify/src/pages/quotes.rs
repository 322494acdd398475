//! What the pages quote.

use super::declaration::Declarations;
use super::equations::Equations;

/// What the pages quote.
#[derive(Clone, Debug, Default)]
pub struct Quotes {
    /// Declarations by name of the element.
    pub declarations: Declarations,
    /// Equations by tag.
    pub equations: Equations,
}
