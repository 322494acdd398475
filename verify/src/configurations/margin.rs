//! How far from the bound a state must be that sticks or slips.

/// Least distance of the utilisation from one: element and oracle must agree on the status.
pub(super) const LEAST_MARGIN: f64 = 2e-10;
