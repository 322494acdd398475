//! What concerns a batch as a whole: counts, strides, connectivity.

use crate::codes::{argument, code, request};
use crate::descriptor::Descriptor;
use crate::element::receiver::OUTPUT_SIZE;
use crate::error::Error;
use crate::evaluation::inputs::{check_request, scale};
use crate::evaluation::pattern::sizes;
use crate::evaluation::sizes::{MOST_ENTRIES, extent, slave_count, spacing};

/// A batch as its host describes it: counts and strides, 0 for the defaults, and which arrays there are.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Form {
    pub(crate) request: u32,
    pub(crate) nslave: i32,
    pub(crate) parameter_count: i32,
    /// From contact to contact, node to node, component to component.
    pub(crate) x_strides: [i64; 3],
    pub(crate) u_strides: [i64; 3],
    pub(crate) f_stride: i64,
    pub(crate) k_stride: i64,
    pub(crate) parameter_stride: i64,
    pub(crate) global_nodes: i64,
    pub(crate) f_scale: f64,
    pub(crate) k_scale: f64,
    pub(crate) has: Present,
}

/// Which arrays of a batch there are.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Present {
    pub(crate) x: bool,
    pub(crate) parameters: bool,
    pub(crate) history: bool,
    pub(crate) slave_row: bool,
    pub(crate) connectivity: bool,
    pub(crate) status: bool,
    pub(crate) f: bool,
    pub(crate) k: bool,
    pub(crate) global_f: bool,
    pub(crate) csr_values: bool,
    pub(crate) csr_map: bool,
    pub(crate) trial: bool,
    pub(crate) output: bool,
    pub(crate) energy: bool,
}

/// A checked batch: what its arrays look like.
#[derive(Clone, Copy)]
pub(crate) struct Shape<'a> {
    pub(crate) element: &'a Descriptor,
    pub(crate) form: Form,
    /// Contacts.
    pub(crate) count: usize,
    /// Nodes of each.
    pub(crate) nodes: usize,
    /// Slave nodes of each.
    pub(crate) nslave: usize,
    /// Parameters of each.
    pub(crate) parameters: usize,
    pub(crate) x: Layout,
    pub(crate) u: Layout,
    /// From contact to contact.
    pub(crate) f_stride: usize,
    pub(crate) k_stride: usize,
    pub(crate) parameter_stride: usize,
    pub(crate) f_scale: f64,
    pub(crate) k_scale: f64,
}

/// Strides of a coordinate array with the defaults filled in, and the entries it has at least.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Layout {
    pub(crate) element: usize,
    pub(crate) node: usize,
    pub(crate) component: usize,
    pub(crate) length: usize,
}

impl<'a> Shape<'a> {
    /// Checks everything but what the arrays hold. `offered`: request bits of the element.
    pub(crate) fn new(
        element: &'a Descriptor,
        offered: u32,
        n: i64,
        form: Form,
    ) -> Result<Self, Error> {
        let count = usize::try_from(n).map_err(|_| Error::new(code::INDEX, argument::BATCH, 0))?;
        check_request(offered, form.request, form.has.history || count == 0)?;
        let nslave = slave_count(element, form.nslave)?;
        let given = usize::try_from(form.parameter_count).unwrap_or(0);
        let mut shape = Self {
            element,
            form,
            count,
            nodes: element.nodes(nslave),
            nslave,
            parameters: given.min(element.parameters.len()),
            x: Layout::default(),
            u: Layout::default(),
            f_stride: 0,
            k_stride: 0,
            parameter_stride: 0,
            f_scale: scale(form.f_scale)?,
            k_scale: scale(form.k_scale)?,
        };
        if count > 0 {
            shape.check_present()?;
            shape.fill_strides()?;
            shape.check_room()?;
        }
        Ok(shape)
    }

    /// True for a bit of the request.
    #[inline(always)]
    pub(crate) fn wants(&self, bit: u32) -> bool {
        self.form.request & bit != 0
    }

    /// Unknowns of each contact.
    pub(crate) fn unknowns(&self) -> usize {
        self.element.unknowns(self.nodes)
    }

    /// Whether the scatter map has a place for every pair of nodes, not for every entry.
    pub(crate) fn by_blocks(&self) -> bool {
        self.wants(request::CSR_BY_BLOCKS)
    }

    /// Places that the scatter map has for each contact.
    pub(crate) fn map_size(&self) -> usize {
        sizes(self.element, self.nslave).places(self.by_blocks())
    }

    /// Entries of the parameters of all contacts.
    pub(crate) fn parameter_length(&self) -> usize {
        self.count.saturating_sub(1) * self.parameter_stride + self.parameters
    }

    fn check_present(&self) -> Result<(), Error> {
        let has = &self.form.has;
        let wants = |bit: u32| self.wants(bit);
        let scattered = has.global_f || has.csr_values;
        // what is missing, where it is needed
        let missing = [
            (!has.x, argument::X),
            (!has.parameters, argument::PARAMETERS),
            (!has.status, argument::STATUS),
            (
                wants(request::RESIDUAL) && !has.f && !has.global_f,
                argument::F,
            ),
            (
                wants(request::TANGENT) && !has.k && !has.csr_values,
                argument::K,
            ),
            (
                wants(request::HISTORY) && !has.trial,
                argument::HISTORY_TRIAL,
            ),
            (wants(request::OUTPUT) && !has.output, argument::OUTPUT),
            (wants(request::ENERGY) && !has.energy, argument::ENERGY),
            (scattered && !has.connectivity, argument::CONNECTIVITY),
            (has.csr_values && !has.csr_map, argument::CSR),
            (
                self.element.interpolated && !has.slave_row,
                argument::SLAVE_ROW,
            ),
        ];
        if let Some(&(_, name)) = missing.iter().find(|(missing, _)| *missing) {
            return Err(Error::missing(name));
        }
        if wants(request::SYMMETRISE) && has.csr_values && !self.element.symmetric {
            return Err(Error::new(code::REQUEST, argument::REQUEST, 6));
        }
        Ok(())
    }

    fn fill_strides(&mut self) -> Result<(), Error> {
        let (form, unknowns) = (self.form, self.unknowns());
        let refused = |name: i32| Error::new(code::STRIDE, name, 0);
        self.x = self.layout(form.x_strides).ok_or(refused(argument::X))?;
        self.u = self.layout(form.u_strides).ok_or(refused(argument::U))?;
        let own = |stride: i64, least: usize, name: i32| {
            let stride = spacing(stride, least).ok_or(refused(name))?;
            extent(&[(self.count, stride)]).ok_or(refused(name))?;
            Ok::<_, Error>(stride)
        };
        self.f_stride = own(form.f_stride, unknowns, argument::F)?;
        // the stride must keep the matrices apart only if every contact writes its own matrix
        let matrix = unknowns * unknowns;
        self.k_stride = if !self.wants(request::TANGENT) {
            0
        } else if form.has.k {
            own(form.k_stride, matrix, argument::K_STRIDE)?
        } else {
            spacing(form.k_stride, matrix).ok_or(refused(argument::K_STRIDE))?
        };
        if form.parameter_stride != 0 {
            let sets = usize::try_from(form.parameter_count).unwrap_or(0);
            self.parameter_stride = own(form.parameter_stride, sets, argument::PARAMETERS)?;
        }
        Ok(())
    }

    /// The arrays without a stride of their own fit the memory.
    fn check_room(&self) -> Result<(), Error> {
        let mapped = if self.form.has.csr_map {
            self.map_size()
        } else {
            0
        };
        let largest = mapped
            .max(self.element.history())
            .max(self.element.points * OUTPUT_SIZE)
            .max(self.nslave + self.nodes + 1);
        match self.count.checked_mul(largest) {
            Some(entries) if entries <= MOST_ENTRIES => Ok(()),
            _ => Err(Error::new(code::INDEX, argument::BATCH, 0)),
        }
    }

    /// Strides of x or u: all zero stands for dense, node and component stride both zero for dense within a contact.
    /// `None` where they contradict each other.
    fn layout(&self, [element, node, component]: [i64; 3]) -> Option<Layout> {
        let (d, nodes) = (self.element.dimension, self.nodes);
        let gathered = self.form.has.connectivity;
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
            let known = i64::from(i32::MAX).min(self.form.global_nodes.saturating_sub(1));
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

    /// So many of its contacts.
    #[cfg(feature = "threads")]
    pub(crate) fn part(&self, count: usize) -> Self {
        let shorter = |layout: Layout| Layout {
            length: layout.length - (self.count - count) * layout.element,
            ..layout
        };
        Self {
            count,
            x: shorter(self.x),
            u: shorter(self.u),
            ..*self
        }
    }
}
