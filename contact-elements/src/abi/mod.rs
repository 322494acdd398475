//! The C interface: descriptors, one-element and batch evaluation, messages.
//!
//! Everything that touches a caller's pointer is here. An exported symbol is one line that calls a
//! function of this module with the registry of its library; see `contact_elements.h` for the manual.

mod batch;
mod batch_check;
mod codes;
mod csr;
mod describe;
mod evaluate;
pub mod fortran;
mod messages;
mod safe;
mod sizes;
mod target;
mod transfer;
mod types;

pub use batch::{element_batch_workspace, element_evaluate_batch};
pub use codes::{argument, code, kind, request};
pub use csr::csr_map;
pub use describe::{
    api, element_check_parameters, element_count, element_find, element_get, element_history_init,
    element_info, element_parameter, element_unknown,
};
pub use evaluate::element_evaluate;
pub use messages::{argument_name, code_message, element_message, status_message};
pub use safe::{Evaluation, Outcome, evaluate};
pub use target::Target;
pub use transfer::{history_transfer, transfer};
pub use types::{ApiTable, Arguments, Batch, Info};

use crate::runtime::{Call, InputError, Nodes, Summary};

/// Version of the interface: major << 16 | minor.
pub const VERSION: u32 = 1 << 16;

/// Doubles of output per contact point.
pub const OUTPUT_SIZE: usize = 23;

/// Doubles that rolling adds to the history of a contact point.
pub(crate) const ROLLING_HISTORY: usize = 5;

/// The compiled kernel of an element.
pub type Kernel = fn(&Call<'_>, &Nodes<'_>, &mut [f64], &mut Target) -> Result<Summary, InputError>;

/// One parameter of an element; names end with a zero byte.
#[derive(Clone, Copy, Debug)]
pub struct Parameter {
    /// Name.
    pub name: &'static str,
    /// Unit.
    pub unit: &'static str,
    /// Least value.
    pub lower: f64,
    /// Largest value.
    pub upper: f64,
    /// Whether the bounds themselves are allowed.
    pub closed: bool,
}

/// What the interface knows of an element; `cte_element` of the C header.
#[derive(Clone, Copy, Debug)]
pub struct Descriptor {
    /// Name, ending with a zero byte.
    pub name: &'static str,
    /// Documentation, ending with a zero byte.
    pub documentation: &'static str,
    /// Space dimension.
    pub dimension: usize,
    /// Slave nodes; 0: given in the call.
    pub slave_nodes: usize,
    /// Master nodes; 0: rigid.
    pub master_nodes: usize,
    /// True where the slave row comes in the call.
    pub interpolated: bool,
    /// Contact points.
    pub points: usize,
    /// Projected parameters.
    pub projected: usize,
    /// Parameters.
    pub parameters: &'static [Parameter],
    /// True where the element has a tangential law.
    pub friction: bool,
    /// True where it has moments about two curves.
    pub rolling: bool,
    /// True where K is symmetric.
    pub symmetric: bool,
    /// True where the element offers a tangent.
    pub tangent: bool,
    /// True where the law declares its energy.
    pub energy: bool,
    /// Arithmetic operations of the point programs.
    pub operations: usize,
    /// Hash of the formulation.
    pub formulation: u64,
    /// Which nodes are tangent vectors; of interpolated elements the master nodes only.
    pub vectors: &'static [bool],
    /// Start of the projection.
    pub centre: [f64; 2],
    /// The kernel.
    pub kernel: Kernel,
}

impl Descriptor {
    /// Doubles of history of one contact point: status and projected parameters; with friction the anchor and
    /// the slip path too; with rolling the anchors and paths of both angles and the regime.
    pub fn point_history(&self) -> usize {
        if self.friction {
            2 + 2 * self.projected + if self.rolling { ROLLING_HISTORY } else { 0 }
        } else {
            1 + self.projected
        }
    }

    /// Doubles of history.
    pub fn history(&self) -> usize {
        self.points * self.point_history()
    }

    /// Node and component of an unknown.
    pub fn place(&self, unknown: usize) -> (usize, usize) {
        if self.dimension == 2 {
            (unknown / 2, unknown % 2)
        } else {
            (unknown / 3, unknown % 3)
        }
    }

    /// Nodes of a call with `nslave` interpolated slave nodes.
    pub fn nodes(&self, nslave: usize) -> usize {
        let slaves = if self.interpolated {
            nslave
        } else {
            self.slave_nodes
        };
        slaves + self.master_nodes
    }

    /// Doubles of workspace for `n` nodes.
    pub fn workspace(&self, n: usize) -> usize {
        if self.interpolated {
            crate::runtime::workspace(n, self.dimension, self.projected, self.friction)
        } else {
            0
        }
    }

    /// Request bits that the element offers.
    pub fn requests(&self) -> u32 {
        let mut bits = request::RESIDUAL
            | request::HISTORY
            | request::OUTPUT
            | request::FREEZE_STATE
            | request::PROJECTION_GIVEN;
        if self.tangent {
            bits |= request::TANGENT | request::SYMMETRISE;
        }
        if self.energy {
            bits |= request::ENERGY;
        }
        bits
    }
}
