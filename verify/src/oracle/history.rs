//! What a contact point remembers of the accepted state.

/// Status of a point in the accepted state.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Accepted {
    /// Not in contact: whatever else is remembered is forgotten.
    Open,
    /// It stuck.
    Stick,
    /// It slipped.
    Slip,
}

/// What a contact point remembers of the accepted state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionHistory {
    /// Status.
    pub status: Accepted,
    /// ζ_st: parameters of the stick anchor, slave's first.
    pub anchor: [f64; 2],
    /// Path slipped so far (length).
    pub slip: f64,
    /// Angles about two curves.
    pub rolling: RollingHistory,
}

/// What the angles remember of the accepted state.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct RollingHistory {
    /// Angles without moment (rad).
    pub anchor: [f64; 2],
    /// Path rolled so far (rad).
    pub path: [f64; 2],
}
