//! Contraction with shape rows: level 2, usable with rows that any discretisation hands in.
//!
//! ```text
//! R_(A,k)       = N s_A n_k                                                            [eq:residual]
//! K_(A,k)(B,l)  = s_A s_B p_kl + s_A s_B,j right_j[k] n_l + n_k s_A,j s_B left_j[l]
//!                 + s_A,i s_B,j s_ij n_k n_l + s_A n_k N J_(B,l)                      [eq:contraction]
//! ```
//!
//! Nodes are loops; per row of K two multiply-adds remain for every entry.

use super::driver::Receiver;
use super::values::Coefficients;

/// Scratch of the contraction: vectors over all unknowns, each at least as long as their number.
#[derive(Debug)]
pub struct Temporaries<'a, const D: usize, const P: usize> {
    /// One per row component k.
    pub u: [&'a mut [f64]; D],
    /// One per projected parameter.
    pub g: [&'a mut [f64]; P],
    /// Σ_j s_A,j g_j of the node at hand.
    pub h: &'a mut [f64],
    /// The row at hand.
    pub row: &'a mut [f64],
}

/// Writes K row by row to the receiver.
///
/// * `s`, `ds` – rows s_A and s_A,j of the nodes.
/// * `n` – normal. * `coefficients` – already multiplied by the point's weight.
/// * `measure` – w N ∂J/∂x_B, where the measure moves, per unknown; empty otherwise.
/// * `moving` – false where all s_A,j vanish (rigid masters).
/// * `first` – true where the rows replace what the receiver holds.
#[inline(always)]
#[allow(clippy::too_many_arguments)]
pub fn contract<R: Receiver, const D: usize, const P: usize>(
    s: &[f64],
    ds: [&[f64]; P],
    n: &[f64; D],
    coefficients: &Coefficients<D, P>,
    measure: &[f64],
    moving: bool,
    first: bool,
    temporaries: &mut Temporaries<'_, D, P>,
    receiver: &mut R,
) {
    let unknowns = s.len() * D;
    for k in 0..D {
        let factors = core::array::from_fn(|j| coefficients.right[j][k]);
        let turn = moving.then_some(&factors);
        factor(
            temporaries.u[k],
            temporaries.h,
            s,
            ds,
            &coefficients.p[k],
            n,
            turn,
        );
        for (u, &m) in temporaries.u[k].iter_mut().zip(measure) {
            *u += n[k] * m;
        }
    }
    if moving {
        for j in 0..P {
            let turn = Some(&coefficients.s[j]);
            factor(
                temporaries.g[j],
                temporaries.h,
                s,
                ds,
                &coefficients.left[j],
                n,
                turn,
            );
        }
    }
    for (a, &s_a) in s.iter().enumerate() {
        if moving {
            combine(temporaries.h, &temporaries.g, ds, a);
        }
        for k in 0..D {
            if moving {
                let pairs = temporaries.u[k].iter().zip(temporaries.h.iter());
                for (row, (&u, &h)) in temporaries.row.iter_mut().zip(pairs) {
                    *row = s_a * u + n[k] * h;
                }
            } else {
                for (row, &u) in temporaries.row.iter_mut().zip(temporaries.u[k].iter()) {
                    *row = s_a * u;
                }
            }
            receiver.row(
                a * D + k,
                temporaries.row.get(..unknowns).unwrap_or(&[]),
                first,
            );
        }
    }
}

/// to(B,l) = s_B v_l + (Σ_j s_B,j turn_j) n_l; `sums`: scratch for the sums of the nodes.
#[inline(always)]
fn factor<const D: usize, const P: usize>(
    to: &mut [f64],
    sums: &mut [f64],
    s: &[f64],
    ds: [&[f64]; P],
    v: &[f64; D],
    n: &[f64; D],
    turn: Option<&[f64; P]>,
) {
    let (blocks, _) = to.as_chunks_mut::<D>();
    let Some(turn) = turn else {
        for (block, &s_b) in blocks.iter_mut().zip(s) {
            for l in 0..D {
                block[l] = s_b * v[l];
            }
        }
        return;
    };
    combine_rows(sums, ds, turn);
    for (block, (&s_b, &sum)) in blocks.iter_mut().zip(s.iter().zip(sums.iter())) {
        for l in 0..D {
            block[l] = s_b * v[l] + sum * n[l];
        }
    }
}

/// sums_B = Σ_j s_B,j turn_j
#[inline(always)]
fn combine_rows<const P: usize>(sums: &mut [f64], ds: [&[f64]; P], turn: &[f64; P]) {
    if P == 1 {
        for (sum, &d) in sums.iter_mut().zip(ds[0]) {
            *sum = d * turn[0];
        }
    } else if P == 2 {
        for (sum, (&d0, &d1)) in sums.iter_mut().zip(ds[0].iter().zip(ds[1])) {
            *sum = d0 * turn[0] + d1 * turn[1];
        }
    }
}

/// h = Σ_j s_A,j g_j
#[inline(always)]
fn combine<const P: usize>(h: &mut [f64], g: &[&mut [f64]; P], ds: [&[f64]; P], a: usize) {
    let factor = |j: usize| ds[j].get(a).copied().unwrap_or(0.0);
    if P == 1 {
        let f = factor(0);
        for (h, &g) in h.iter_mut().zip(g[0].iter()) {
            *h = f * g;
        }
    } else {
        let (f0, f1) = (factor(0), factor(1));
        let pairs = g[0].iter().zip(g[1].iter());
        for (h, (&g0, &g1)) in h.iter_mut().zip(pairs) {
            *h = f0 * g0 + f1 * g1;
        }
    }
}
