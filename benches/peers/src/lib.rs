//! The built-in elements behind the C signatures of the peer kit (`PEERS_KIT`), as a host would call them.
//!
//! The pairs are declared at the level of geometry, pair and law; nothing here is a formula.

use core::cell::Cell;

use contact_elements::runtime::{Call, Coordinates, Nodes, Receiver, Report, Wanted, Write, fixed};
use contact_library::{Line2Line2Beams, PointQuad4};

/// Dense R and K, row-major.
struct Dense<'a, const U: usize> {
    residual: &'a mut [f64; U],
    tangent: &'a mut [[f64; U]; U],
}

impl<const U: usize> Receiver for Dense<'_, U> {
    fn open(&mut self, _unknowns: usize) {
        *self.residual = [0.0; U];
        *self.tangent = [[0.0; U]; U];
    }

    #[inline(always)]
    fn force(&mut self, (node, component): (usize, usize), value: f64, write: Write) {
        if let Some(entry) = self.residual.get_mut(3 * node + component) {
            *entry = match write {
                Write::Replace => value,
                Write::Add => *entry + value,
            };
        }
    }

    #[inline(always)]
    fn row(&mut self, unknown: usize, row: &[f64], write: Write) {
        if let (Some(to), Some(row)) = (self.tangent.get_mut(unknown), row.first_chunk::<U>()) {
            if write == Write::Replace {
                *to = *row;
            } else {
                for (to, from) in to.iter_mut().zip(row) {
                    *to += from;
                }
            }
        }
    }

    fn multiplier(&mut self, _: (usize, usize), _: f64) {}
    fn coupling(&mut self, _: usize, _: usize, _: f64) {}
    fn clear(&mut self, _: usize) {}
    fn report(&mut self, _point: usize, _report: &Report) {}

    fn energy(&mut self, _energy: f64) {}
}

/// The nodes of an element in one array, three coordinates each.
fn nodes(x: &[f64], count: usize) -> Nodes<'_> {
    Nodes {
        x: Coordinates {
            values: x,
            offset: 0,
            node_stride: 3,
            component_stride: 1,
        },
        u: None,
        connectivity: None,
        count,
    }
}

#[inline(always)]
fn point_quad4(x: &[f64; 15], zeta: &[f64; 2], eps: f64, given: bool, mut dense: Dense<'_, 15>) {
    let history = [1.0, zeta[0], zeta[1]].map(Cell::new);
    let call = Call {
        parameters: &[eps, 0.0, 1.0],
        history: Some(&history),
        slave_row: &[],
        wanted: Wanted {
            residual: true,
            tangent: true,
            freeze: false,
            projection_given: given,
        },
    };
    let outcome =
        fixed::<PointQuad4, _, 3, 2, 3, 5, 1, 16>(&call, &nodes(x, 5), &[false; 5], &mut dense);
    if outcome.is_err() {
        dense.residual[0] = f64::NAN;
    }
}

/// Point against a bilinear facet, projection given.
///
/// # Safety
/// The pointers have the extents of their types and do not overlap.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ours_pts_q4(
    x: &[f64; 15],
    zeta: &[f64; 2],
    eps: f64,
    residual: &mut [f64; 15],
    tangent: &mut [[f64; 15]; 15],
) {
    point_quad4(x, zeta, eps, true, Dense { residual, tangent });
}

/// Point against a bilinear facet, projected from a start.
///
/// # Safety
/// As [`ours_pts_q4`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ours_pts_q4_cpp(
    x: &[f64; 15],
    start: &[f64; 2],
    eps: f64,
    residual: &mut [f64; 15],
    tangent: &mut [[f64; 15]; 15],
) {
    point_quad4(x, start, eps, false, Dense { residual, tangent });
}

/// Two straight beams.
///
/// # Safety
/// As [`ours_pts_q4`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ours_ctc_l2(
    x: &[f64; 12],
    r0: f64,
    eps: f64,
    residual: &mut [f64; 12],
    tangent: &mut [[f64; 12]; 12],
) {
    let call = Call {
        parameters: &[eps, r0],
        history: None,
        slave_row: &[],
        wanted: Wanted {
            residual: true,
            tangent: true,
            freeze: false,
            projection_given: false,
        },
    };
    let mut dense = Dense { residual, tangent };
    let outcome = fixed::<Line2Line2Beams, _, 3, 2, 3, 4, 1, 12>(
        &call,
        &nodes(x, 4),
        &[false; 4],
        &mut dense,
    );
    if outcome.is_err() {
        dense.residual[0] = f64::NAN;
    }
}
