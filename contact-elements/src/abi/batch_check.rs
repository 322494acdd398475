//! What concerns a batch as a whole: pointers, counts, strides, connectivity.

use super::evaluate::{check_request, scale};
use super::sizes::{Fault, MOST_ENTRIES, extent, slave_count, spacing};
use super::threads::Turn;
use super::types::Batch;
use super::{Descriptor, OUTPUT_SIZE, argument, code, request};

/// A checked batch.
pub(super) struct Checked<'a> {
    pub(super) element: &'a Descriptor,
    pub(super) batch: &'a Batch,
    /// Contacts.
    pub(super) count: usize,
    /// Nodes of each.
    pub(super) nodes: usize,
    /// Slave nodes of each.
    pub(super) nslave: usize,
    pub(super) x: Layout,
    pub(super) u: Layout,
    /// From contact to contact.
    pub(super) f_stride: usize,
    pub(super) k_stride: usize,
    pub(super) parameter_stride: usize,
    pub(super) f_scale: f64,
    pub(super) k_scale: f64,
    pub(super) turn: Turn,
}

/// Strides of a coordinate array with the defaults filled in, and the entries it has at least.
#[derive(Clone, Copy, Default)]
pub(super) struct Layout {
    pub(super) element: usize,
    pub(super) node: usize,
    pub(super) component: usize,
    pub(super) length: usize,
}

impl<'a> Checked<'a> {
    /// Checks everything but the values.
    ///
    /// # Safety
    /// The pointers of the batch are valid for the shapes that the header gives, as long as this lives.
    pub(super) unsafe fn new(
        element: &'a Descriptor,
        n: i64,
        batch: &'a Batch,
    ) -> Result<Self, Fault> {
        let count = usize::try_from(n).map_err(|_| (code::INDEX, argument::BATCH, 0))?;
        check_request(
            element,
            batch.request,
            batch.history_accepted.is_null() && count > 0,
        )?;
        let nslave = slave_count(element, batch.nslave)?;
        let mut checked = Self {
            element,
            batch,
            count,
            nodes: element.nodes(nslave),
            nslave,
            x: Layout::default(),
            u: Layout::default(),
            f_stride: 0,
            k_stride: 0,
            parameter_stride: 0,
            f_scale: scale(batch.f_scale)?,
            k_scale: scale(batch.k_scale)?,
            turn: Turn::FREE,
        };
        if count > 0 {
            checked.check_pointers()?;
            checked.fill_strides()?;
            // SAFETY: promised by the caller.
            unsafe { checked.check_connectivity()? };
        }
        Ok(checked)
    }

    /// Unknowns of each contact.
    pub(super) fn unknowns(&self) -> usize {
        self.element.unknowns(self.nodes)
    }

    /// Places that the scatter map has for each contact.
    pub(super) fn map_size(&self) -> usize {
        if self.batch.request & request::CSR_BY_BLOCKS == 0 {
            self.unknowns() * self.unknowns()
        } else {
            self.nodes * (self.nodes + 1)
        }
    }

    fn check_pointers(&self) -> Result<(), Fault> {
        let batch = self.batch;
        let wants = |bit: u32| batch.request & bit != 0;
        let no_f = batch.f.is_null() && batch.global_f.is_null();
        let no_k = batch.k.is_null() && batch.csr_values.is_null();
        let scattered = !batch.global_f.is_null() || !batch.csr_values.is_null();
        let mapped = !batch.csr_values.is_null();
        let no_history = batch.history_trial.is_null();
        // what is missing, where it is needed
        let missing = [
            (batch.x.is_null(), argument::X),
            (batch.parameters.is_null(), argument::PARAMETERS),
            (batch.status.is_null(), argument::STATUS),
            (wants(request::RESIDUAL) && no_f, argument::F),
            (wants(request::TANGENT) && no_k, argument::K),
            (
                wants(request::HISTORY) && no_history,
                argument::HISTORY_TRIAL,
            ),
            (
                wants(request::OUTPUT) && batch.output.is_null(),
                argument::OUTPUT,
            ),
            (
                wants(request::ENERGY) && batch.energy.is_null(),
                argument::ENERGY,
            ),
            (
                scattered && batch.connectivity.is_null(),
                argument::CONNECTIVITY,
            ),
            (mapped && batch.csr_map.is_null(), argument::CSR),
            (
                self.element.interpolated && batch.slave_row.is_null(),
                argument::SLAVE_ROW,
            ),
        ];
        if let Some(&(_, name)) = missing.iter().find(|(missing, _)| *missing) {
            return Err((code::NULL, name, 0));
        }
        if wants(request::SYMMETRISE) && mapped && !self.element.symmetric {
            return Err((code::REQUEST, argument::REQUEST, 6));
        }
        Ok(())
    }

    fn fill_strides(&mut self) -> Result<(), Fault> {
        let (batch, unknowns) = (self.batch, self.unknowns());
        let x = [
            batch.x_element_stride,
            batch.x_node_stride,
            batch.x_component_stride,
        ];
        let u = [
            batch.u_element_stride,
            batch.u_node_stride,
            batch.u_component_stride,
        ];
        self.x = self.layout(x).ok_or((code::STRIDE, argument::X, 0))?;
        self.u = self.layout(u).ok_or((code::STRIDE, argument::U, 0))?;
        let own = |stride: i64, least: usize, name: i32| {
            let fault = (code::STRIDE, name, 0);
            let stride = spacing(stride, least).ok_or(fault)?;
            extent(&[(self.count, stride)]).ok_or(fault)?;
            Ok(stride)
        };
        self.f_stride = own(batch.f_element_stride, unknowns, argument::F)?;
        // a matrix of its own for every contact only where there are such matrices
        let matrix = unknowns * unknowns;
        self.k_stride = if batch.request & request::TANGENT == 0 {
            0
        } else if batch.k.is_null() {
            spacing(batch.k_element_stride, matrix).ok_or((code::STRIDE, argument::K_STRIDE, 0))?
        } else {
            own(batch.k_element_stride, matrix, argument::K_STRIDE)?
        };
        let sets = usize::try_from(batch.parameter_count).unwrap_or(0);
        if batch.parameter_element_stride != 0 {
            let stride = batch.parameter_element_stride;
            self.parameter_stride = own(stride, sets, argument::PARAMETERS)?;
        }
        self.check_room()
    }

    /// The arrays without a stride of their own.
    fn check_room(&self) -> Result<(), Fault> {
        let mapped = if self.batch.csr_map.is_null() {
            0
        } else {
            self.map_size()
        };
        let largest = mapped
            .max(self.element.history())
            .max(self.element.points * OUTPUT_SIZE)
            .max(self.nslave + self.nodes + 1);
        match self.count.checked_mul(largest) {
            Some(entries) if entries <= MOST_ENTRIES => Ok(()),
            _ => Err((code::INDEX, argument::BATCH, 0)),
        }
    }

    /// Strides of x or u: all zero stands for dense, node and component stride both zero for dense
    /// within a contact. `None` where they contradict each other.
    fn layout(&self, [element, node, component]: [i64; 3]) -> Option<Layout> {
        let (d, nodes) = (self.element.dimension, self.nodes);
        let gathered = !self.batch.connectivity.is_null();
        let element = usize::try_from(element).ok()?;
        let (node, component, least) = match (
            usize::try_from(node).ok()?,
            usize::try_from(component).ok()?,
        ) {
            (0, 0) => (d, 1, nodes * d),
            (node, component) if component > 0 && (node > 0 || (nodes == 1 && !gathered)) => {
                (node, component, 0)
            }
            _ => return None,
        };
        let (element, last) = if gathered {
            let known = i64::from(i32::MAX).min(self.batch.global_nodes.saturating_sub(1));
            (0, usize::try_from(known).unwrap_or(0))
        } else {
            let element = if element == 0 { least } else { element };
            let apart = element >= least && (element > 0 || self.count == 1);
            (apart.then_some(element)?, nodes - 1)
        };
        let steps = [(self.count - 1, element), (last, node), (d - 1, component)];
        Some(Layout {
            element,
            node,
            component,
            length: extent(&steps)?,
        })
    }

    /// # Safety
    /// The connectivity is null or has n · nnode entries.
    unsafe fn check_connectivity(&self) -> Result<(), Fault> {
        if self.batch.connectivity.is_null() {
            return Ok(());
        }
        let length = self.count * self.nodes;
        // SAFETY: promised by the caller; the length fits the memory.
        let list = unsafe { core::slice::from_raw_parts(self.batch.connectivity, length) };
        for (index, &node) in list.iter().enumerate() {
            if node < 0 || i64::from(node) >= self.batch.global_nodes {
                return Err((code::INDEX, argument::CONNECTIVITY, index));
            }
        }
        Ok(())
    }
}
