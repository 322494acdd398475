//! What an element is, apart from the kernels that run it.

use crate::codes::request;
use crate::element::traits::Layout;
use crate::point::domain::Domain;
use crate::point::history::{HistoryLayout, Reach};
use crate::point::values::Enforcement;
use crate::table::{MasterDescription, SlaveDescription};

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

/// What an element is: sizes, parameters, sides, domains; nothing of the kernels that run it.
#[derive(Clone, Copy, Debug)]
pub struct Descriptor {
    /// Name, ending with a zero byte.
    pub name: &'static str,
    /// Documentation, ending with a zero byte.
    pub documentation: &'static str,
    /// Space dimension.
    pub dimension: usize,
    /// Slave nodes; 0 if the call gives them.
    pub slave_nodes: usize,
    /// Master nodes; 0 if rigid.
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
    /// Where `angle_low` and `angle_high` stand in the parameters; `None` if the contact acts at any angle.
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
    /// Which nodes are tangent vectors; of interpolated elements only the master nodes are listed.
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
    /// Periods of a rigid master's parameters; 0 if not periodic.
    pub periods: [f64; 2],
    /// Extents of the projected parameters; infinite where a bound is missing.
    pub extents: [f64; 2],
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

    /// How far histories may lead.
    pub(crate) const fn reach(&self) -> Reach {
        Reach {
            centre: self.centre,
            extent: self.extents,
        }
    }

    /// True where the history carries a multiplier.
    pub const fn is_augmented(&self) -> bool {
        matches!(self.enforcement, Enforcement::Augmented)
    }

    /// Multipliers that are unknowns; each has a node, which follows all others.
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
            crate::element::kernel::workspace(n, self.dimension, self.projected, self.friction)
        } else {
            0
        }
    }

    /// Request bits that the element offers, whatever its kernels are.
    pub(crate) fn requests(&self) -> u32 {
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
        bits
    }
}
