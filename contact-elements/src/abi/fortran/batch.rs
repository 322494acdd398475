//! Many contacts, and the scatter maps of their sums.

use super::super::batch::element_evaluate_batch;
use super::super::csr::{Sparse, csr_blocks, csr_map};
use super::super::describe::Registry;
use super::super::pointers::write;
use super::super::types::Batch;
use super::addresses::{element, refuse, report, value};
use crate::codes::{argument, code};
use crate::error::Error;
use crate::registered::Registered;

/// Bit of `INTO`: results contact by contact.
const INTO_OWN: i32 = 1;
/// Bit of `INTO`: sums into global arrays.
const INTO_GLOBAL: i32 = 2;

/// Addresses of a batch.
#[derive(Clone, Copy, Debug)]
#[allow(missing_docs)]
pub struct BatchAddresses {
    pub n: *const i32,
    pub request: *const i32,
    pub nslave: *const i32,
    pub global_nodes: *const i32,
    pub connectivity: *const i32,
    pub x: *const f64,
    pub ldx: *const i32,
    pub u: *const f64,
    pub ldu: *const i32,
    pub parameters: *const f64,
    pub parameter_count: *const i32,
    pub ldp: *const i32,
    pub history_accepted: *const f64,
    pub history_trial: *mut f64,
    pub slave_row: *const f64,
    pub into: *const i32,
    pub f_scale: *const f64,
    pub k_scale: *const f64,
    pub f: *mut f64,
    pub k: *mut f64,
    pub global_f: *mut f64,
    pub csr_values: *mut f64,
    pub csr_map: *const i64,
    pub output: *mut f64,
    pub energy: *mut f64,
    pub status: *mut i32,
    pub code: *mut i32,
    pub workspace: *mut f64,
    pub workspace_size: *const i32,
}

impl BatchAddresses {
    /// The struct of the C interface and the number of contacts.
    ///
    /// # Safety
    /// Every address is null or valid for the shape that the header gives.
    unsafe fn batch(&self, element: &Registered) -> Result<(i64, Batch), Error> {
        // SAFETY: promised by the caller.
        unsafe {
            let nslave = value(self.nslave, argument::NSLAVE)?;
            let nodes = element.nodes(usize::try_from(nslave).unwrap_or(0)) as i64;
            let global_nodes = i64::from(value(self.global_nodes, argument::CONNECTIVITY)?);
            let gathers = global_nodes != 0;
            if gathers && self.connectivity.is_null() {
                return Err(Error::missing(argument::CONNECTIVITY));
            }
            let x = i64::from(value(self.ldx, argument::X)?);
            let u = i64::from(value(self.ldu, argument::U)?);
            let mut batch = Batch {
                request: value(self.request, argument::REQUEST)? as u32,
                parameter_count: value(self.parameter_count, argument::PARAMETERS)?,
                nslave,
                x: self.x,
                u: self.u,
                parameters: self.parameters,
                history_accepted: self.history_accepted,
                history_trial: self.history_trial,
                status: self.status,
                code: self.code,
                connectivity: if gathers {
                    self.connectivity
                } else {
                    core::ptr::null()
                },
                global_nodes,
                output: self.output,
                energy: self.energy,
                f_scale: value(self.f_scale, argument::SCALE)?,
                k_scale: value(self.k_scale, argument::SCALE)?,
                parameter_element_stride: i64::from(value(self.ldp, argument::PARAMETERS)?),
                slave_row: self.slave_row,
                workspace: self.workspace,
                workspace_size: i64::from(value(self.workspace_size, argument::WORKSPACE)?),
                ..Batch::EMPTY
            };
            if x != 0 {
                (batch.x_node_stride, batch.x_component_stride) = (x, 1);
                batch.x_element_stride = x * nodes;
            }
            if u != 0 {
                (batch.u_node_stride, batch.u_component_stride) = (u, 1);
                batch.u_element_stride = u * nodes;
            }
            self.direct(&mut batch)?;
            Ok((i64::from(value(self.n, argument::BATCH)?), batch))
        }
    }

    /// Where the results go.
    ///
    /// # Safety
    /// As [`BatchAddresses::batch`].
    unsafe fn direct(&self, batch: &mut Batch) -> Result<(), Error> {
        // SAFETY: promised by the caller.
        let into = unsafe { value(self.into, argument::REQUEST)? };
        if into & !(INTO_OWN | INTO_GLOBAL) != 0 {
            return Err(Error::new(code::REQUEST, argument::REQUEST, 0));
        }
        if into & INTO_OWN != 0 {
            (batch.f, batch.k) = (self.f, self.k);
        }
        if into & INTO_GLOBAL != 0 {
            (batch.global_f, batch.csr_values) = (self.global_f, self.csr_values);
            batch.csr_map = self.csr_map;
        }
        Ok(())
    }
}

/// `CTE_F77_BATCH`.
///
/// # Safety
/// Every address is null or valid for the shape that the header gives.
pub unsafe fn batch(
    elements: Registry<'_>,
    index: *const i32,
    addresses: BatchAddresses,
    state: *mut i32,
    result: *mut i32,
) {
    // SAFETY: promised by the caller.
    unsafe {
        let filled = element(elements, index, argument::ELEMENT).and_then(|element| {
            let (n, batch) = addresses.batch(&*element)?;
            Ok((element, n, batch))
        });
        match filled {
            Ok((element, n, mut batch)) => {
                write(result, element_evaluate_batch(element, n, &raw mut batch));
                let failed = i32::try_from(batch.failed).unwrap_or(i32::MAX);
                report(state, [0, failed, batch.error_argument, batch.error_index]);
            }
            Err(fault) => refuse(state, result, fault),
        }
    }
}

/// Addresses of a sparse pattern.
#[derive(Clone, Copy, Debug)]
#[allow(missing_docs)]
pub struct SparseAddresses {
    pub n: *const i32,
    pub nslave: *const i32,
    pub connectivity: *const i32,
    pub rows: *const i32,
    pub row_start: *const i64,
    pub column: *const i32,
    pub map: *mut i64,
}

/// `CTE_F77_CSR_MAP`, and `CTE_F77_CSR_BLOCKS` with `by_blocks`.
///
/// # Safety
/// Every address is null or valid for the shape that the header gives.
pub unsafe fn scatter_map(
    elements: Registry<'_>,
    index: *const i32,
    addresses: SparseAddresses,
    by_blocks: bool,
    result: *mut i32,
) {
    // SAFETY: promised by the caller.
    unsafe {
        let filled = element(elements, index, argument::ELEMENT).and_then(|element| {
            Ok(Sparse {
                element,
                n: i64::from(value(addresses.n, argument::BATCH)?),
                nslave: value(addresses.nslave, argument::NSLAVE)?,
                connectivity: addresses.connectivity,
                rows: i64::from(value(addresses.rows, argument::CSR)?),
                row_start: addresses.row_start,
                column: addresses.column,
            })
        });
        let code = match filled {
            Ok(sparse) if by_blocks => csr_blocks(sparse, addresses.map),
            Ok(sparse) => csr_map(sparse, addresses.map),
            Err(error) => error.code,
        };
        write(result, code);
    }
}
