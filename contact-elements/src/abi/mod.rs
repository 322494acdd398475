//! The C interface: descriptors, one-element and batch evaluation, messages.
//!
//! Everything that touches a caller's pointer is here. An exported symbol is one line that calls a
//! function of this module with the registry of its library; see `contact_elements.h` for the manual.

mod augment;
mod batch;
mod batch_check;
mod codes;
mod csr;
mod describe;
mod evaluate;
pub mod fortran;
mod messages;
mod outputs;
mod patch;
mod places;
mod project;
mod safe;
mod screen;
mod sides;
mod sizes;
mod target;
mod threads;
mod transfer;
mod types;

pub use augment::{augment, history_augment};
pub use batch::{Run, element_batch_workspace, element_evaluate_batch, element_evaluate_batch_in};
pub use codes::{argument, code, kind, request};
pub use csr::{Sparse, csr_blocks, csr_map};
pub use describe::{
    api, element_check_parameters, element_count, element_find, element_get, element_history_init,
    element_info, element_parameter, element_unknown,
};
pub use evaluate::element_evaluate;
pub use messages::{argument_name, code_message, element_message, status_message};
pub use patch::{Facets, Patch, evaluate_patch, patch_evaluate, patch_info};
pub use project::{Projection, Query, element_project, project};
pub use safe::{Evaluation, Outcome, evaluate};
pub use target::Target;
pub use threads::element_evaluate_batch_threads;
pub use transfer::{history_transfer, transfer};
pub use types::{ApiTable, Arguments, Batch, Info};

use crate::program::{MasterDescription, SlaveDescription};
use crate::runtime::{
    Call, Domain, Enforcement, HistoryLayout, InputError, Layout, Nodes, SCREENED, Summary, Width,
    can_be_anchor, can_be_projection, is_side,
};

/// Version of the interface: major << 16 | minor.
pub const VERSION: u32 = 1 << 16;

/// Doubles of output per contact point.
pub const OUTPUT_SIZE: usize = 23;

/// The compiled kernel of an element.
pub type Kernel = fn(&Call<'_>, &Nodes<'_>, &mut [f64], &mut Target) -> Result<Summary, InputError>;

/// The kernel of an element for many contacts at once.
pub type BatchKernel = fn(&mut Run<'_>, Width);

/// Which contacts of an element are open wherever their projection lies, and lower bounds of their gaps.
pub type ScreenKernel = fn(&Run<'_>, (usize, usize), &mut [f64; SCREENED]) -> u32;

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

impl Parameter {
    /// True for values within the bounds.
    pub(crate) fn allows(&self, value: f64) -> bool {
        if self.closed {
            value >= self.lower && value <= self.upper
        } else {
            value > self.lower && value < self.upper
        }
    }
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
    /// How the normal law holds the bodies apart.
    pub enforcement: Enforcement,
    /// True where it has moments about two curves.
    pub rolling: bool,
    /// Where `angle_low` and `angle_high` stand in the parameters; none: the contact acts at any angle.
    pub angle: Option<usize>,
    /// True for edges of solids, whose side the history keeps.
    pub keeps_side: bool,
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
    /// Slave as declared.
    pub slave: SlaveDescription,
    /// Master as declared.
    pub master: MasterDescription,
    /// Parameter list.
    pub layout: Layout,
    /// Domains of the projected parameters: slave curve first where both are projected.
    pub domains: [Domain; 2],
    /// Periods of a rigid master's parameters; 0: none.
    pub periods: [f64; 2],
    /// Extents of the projected parameters; infinite where a bound is missing.
    pub extents: [f64; 2],
    /// The kernel.
    pub kernel: Kernel,
    /// The kernel in lanes, where the declaration asks for one.
    pub lanes: Option<BatchKernel>,
    /// What tells open contacts without their projection, where something can.
    pub screen: Option<ScreenKernel>,
}

impl Descriptor {
    /// The history of one contact point.
    pub(crate) const fn history_layout(&self) -> HistoryLayout {
        HistoryLayout::new(
            self.projected,
            self.friction,
            self.rolling,
            self.keeps_side,
            self.is_augmented(),
        )
    }

    /// Doubles of history of one contact point.
    pub fn point_history(&self) -> usize {
        self.history_layout().size()
    }

    /// The first entry of a side in a point's history that is none.
    pub(crate) fn impossible_side(&self, history: &[f64]) -> Option<usize> {
        let at = self.history_layout().side_at();
        let normal = history.get(at..).and_then(<[f64]>::first_chunk);
        let is_possible = !self.keeps_side || normal.is_none_or(is_side);
        (!is_possible).then_some(at)
    }

    /// True where the history carries a multiplier.
    pub const fn is_augmented(&self) -> bool {
        matches!(self.enforcement, Enforcement::Augmented)
    }

    /// False for an anchor that lies far outside the domain of parameter `i`.
    pub fn can_be_anchor(&self, i: usize, value: f64) -> bool {
        match (self.centre.get(i), self.extents.get(i)) {
            (Some(centre), Some(extent)) => can_be_anchor(value, *centre, *extent),
            _ => false,
        }
    }

    /// False for a projection that lies far outside the domain of parameter `i`.
    pub(crate) fn can_be_projection(&self, i: usize, value: f64) -> bool {
        match (self.centre.get(i), self.extents.get(i)) {
            (Some(centre), Some(extent)) => can_be_projection(value, *centre, *extent),
            _ => false,
        }
    }

    /// Multipliers that are unknowns, each with a node of its own behind all others.
    pub fn multipliers(&self) -> usize {
        if self.enforcement == Enforcement::Multiplier {
            self.points
        } else {
            0
        }
    }

    /// Unknowns of a call with `n` nodes.
    pub fn unknowns(&self, n: usize) -> usize {
        let multipliers = self.multipliers();
        n.saturating_sub(multipliers) * self.dimension + multipliers
    }

    /// Doubles of history.
    #[inline]
    pub fn history(&self) -> usize {
        self.points * self.point_history()
    }

    /// Node and component of an unknown of a call with `n` nodes.
    pub fn place(&self, n: usize, unknown: usize) -> (usize, usize) {
        let positions = n.saturating_sub(self.multipliers());
        if let Some(multiplier) = unknown.checked_sub(positions * self.dimension) {
            (positions + multiplier, 0)
        } else if self.dimension == 2 {
            (unknown / 2, unknown % 2)
        } else {
            (unknown / 3, unknown % 3)
        }
    }

    /// Nodes of a call with `nslave` interpolated slave nodes: slave, master, multipliers.
    pub fn nodes(&self, nslave: usize) -> usize {
        let slaves = if self.interpolated {
            nslave
        } else {
            self.slave_nodes
        };
        slaves + self.master_nodes + self.multipliers()
    }

    /// Doubles of workspace for `n` nodes.
    pub fn workspace(&self, n: usize) -> usize {
        if self.interpolated {
            let n = n.saturating_sub(self.multipliers());
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
            bits |= request::TANGENT | request::SYMMETRISE | request::CSR_BY_BLOCKS;
        }
        if self.energy {
            bits |= request::ENERGY;
        }
        if self.screen.is_some() {
            bits |= request::SCREEN;
        }
        bits
    }
}
