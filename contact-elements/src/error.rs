//! What can go wrong: one error for all calls.

use core::fmt;

use crate::codes::{argument, code};
use crate::element::receiver::InputError;
use crate::messages::{argument_text, code_text};
use crate::point::values::Status;

/// Why a call was refused, or why a state cannot be evaluated. Outputs are unchanged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Error {
    /// Number of the error in [`code`](mod@crate::codes::code); [`code::CUT_BACK`] asks for a smaller step.
    pub code: i32,
    /// Number of the argument that is at fault in [`argument`](mod@crate::codes::argument).
    pub argument: i32,
    /// Entry of the argument: node, parameter, entry of a history, contact of a batch.
    pub index: usize,
    /// Status of the contact point that cannot be evaluated, with [`code::CUT_BACK`].
    pub status: Option<Status>,
}

impl Error {
    /// An argument that cannot be used.
    #[inline(always)]
    pub(crate) const fn new(code: i32, argument: i32, index: usize) -> Self {
        Self {
            code,
            argument,
            index,
            status: None,
        }
    }

    /// An array that is missing or too short.
    #[inline(always)]
    pub(crate) const fn missing(argument: i32) -> Self {
        Self::new(code::NULL, argument, 0)
    }

    /// A contact point that cannot be evaluated.
    #[inline(always)]
    pub(crate) const fn cut_back(status: Status, argument: i32, index: usize) -> Self {
        Self {
            code: code::CUT_BACK,
            argument,
            index,
            status: Some(status),
        }
    }

    /// True where a smaller step may help.
    pub const fn is_cut_back(&self) -> bool {
        self.code == code::CUT_BACK
    }
}

impl From<InputError> for Error {
    #[inline]
    fn from(error: InputError) -> Self {
        let not_finite = |argument: i32, index: usize| Self::new(code::NOT_FINITE, argument, index);
        match error {
            InputError::Position(node) => not_finite(argument::X, node),
            InputError::Displacement(node) => not_finite(argument::U, node),
            InputError::History(entry) => not_finite(argument::HISTORY_ACCEPTED, entry),
            InputError::Impossible(entry) => {
                Self::new(code::HISTORY, argument::HISTORY_ACCEPTED, entry)
            }
            InputError::NoHistory => Self::missing(argument::HISTORY_ACCEPTED),
            InputError::SlaveRow(entry) => not_finite(argument::SLAVE_ROW, entry),
            InputError::Workspace => Self::new(code::WORKSPACE, argument::WORKSPACE, 0),
            InputError::Point(failure) => {
                Self::cut_back(failure.status, argument::X, failure.point)
            }
        }
    }
}

impl fmt::Display for Error {
    /// Argument, entry, what is wrong and what to do.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.argument != argument::NONE {
            let name = argument_text(self.argument).trim_end_matches('\0');
            write!(f, "argument `{name}`, entry {}: ", self.index)?;
        }
        if let Some(status) = self.status {
            write!(f, "{}: ", status_text(status))?;
        }
        f.write_str(code_text(self.code).trim_end_matches('\0'))
    }
}

fn status_text(status: Status) -> &'static str {
    crate::messages::status_text(status as i32).trim_end_matches('\0')
}

impl core::error::Error for Error {}
