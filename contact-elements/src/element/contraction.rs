//! Contraction with shape rows: level 2, usable with rows of any discretisation.
//!
//! ```text
//! R_(A,k)       = N s_A n_k                                                            [eq:residual]
//! K_(A,k)(B,l)  = s_A s_B p_kl + s_A s_B,j right_j[k] n_l + n_k s_A,j s_B left_j[l]
//!                 + s_A,i s_B,j s_ij n_k n_l + s_A n_k N J_(B,l)                      [eq:contraction]
//! ```
//!
//! Nodes are loops; for every entry of a row of K two multiply-adds remain.

use crate::element::receiver::Receiver;
use crate::element::rows::Contraction;
use crate::element::stage::Temporaries;
use crate::lanes::Lanes;
use crate::point::values::Coefficients;

/// Fewest unknowns for which rows are written several at a time, if the receiver allows it.
const FEWEST: usize = 8;

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
    // taken out: an index that runs over fields of the scratch would keep all of it, nodes included, in memory
    let mut u = temporaries.u.each_mut().map(|row| &mut **row);
    let mut g = temporaries.g.each_mut().map(|row| &mut **row);
    let (h, row) = (&mut *temporaries.h, &mut *temporaries.row);
    let unknowns = s.len() * D;
    if unknowns >= FEWEST
        && let Some(to) = receiver.rows()
    {
        let is_written = if moving {
            let contraction = Contraction {
                s,
                ds,
                n,
                p: &coefficients.p,
                right: coefficients.right.each_ref(),
                left: coefficients.left.each_ref(),
                turn: coefficients.s,
                measure,
            };
            let scratch = (
                u.each_mut().map(|row| &mut **row),
                g.each_mut().map(|row| &mut **row),
            );
            contraction.write_wide(scratch, to, first)
        } else {
            let contraction = Contraction {
                s,
                ds: [],
                n,
                p: &coefficients.p,
                right: [],
                left: [],
                turn: [],
                measure,
            };
            contraction.write_wide((u.each_mut().map(|row| &mut **row), []), to, first)
        };
        if is_written {
            return;
        }
    }
    let width = row.len();
    for k in 0..D {
        let factors = core::array::from_fn(|j| coefficients.right[j][k]);
        let turn = moving.then_some(&factors);
        factor(u[k], width, s, ds, &coefficients.p[k], n, turn);
        for (u, &m) in u[k].iter_mut().zip(measure) {
            *u += n[k] * m;
        }
    }
    if moving {
        for j in 0..P {
            let turn = Some(&coefficients.s[j]);
            factor(g[j], width, s, ds, &coefficients.left[j], n, turn);
        }
    }
    for (a, &s_a) in s.iter().enumerate() {
        if moving {
            combine(h, &g, ds, a);
        }
        for k in 0..D {
            if moving {
                let pairs = u[k].iter().zip(h.iter());
                for (row, (&u, &h)) in row.iter_mut().zip(pairs) {
                    *row = s_a * u + n[k] * h;
                }
            } else {
                for (row, &u) in row.iter_mut().zip(u[k].iter()) {
                    *row = s_a * u;
                }
            }
            receiver.row(a * D + k, row.get(..unknowns).unwrap_or(&[]), first);
        }
    }
}

/// to(B,l) = s_B v_l + (Σ_j s_B,j turn_j) n_l for the first `width` unknowns.
#[inline(always)]
fn factor<const D: usize, const P: usize>(
    to: &mut [f64],
    width: usize,
    s: &[f64],
    ds: [&[f64]; P],
    v: &[f64; D],
    n: &[f64; D],
    turn: Option<&[f64; P]>,
) {
    let (v, n) = (padded(v, 0), padded(n, 0));
    let Some(to) = to.get_mut(..width) else {
        return;
    };
    for quad in 0..width.div_ceil(4) {
        // the nodes are taken by fours
        let (first, part) = (4 * (quad / D), quad % D);
        let s_b = padded(s, first).of_nodes::<D>(part);
        let mut value = s_b.times(v.of_components::<D>(part));
        if let Some(turn) = turn {
            let sum = combination(ds.map(|row| padded(row, first)), turn);
            let sum = sum.of_nodes::<D>(part);
            value = value.plus(sum.times(n.of_components::<D>(part)));
        }
        let rest = to.get_mut(4 * quad..).unwrap_or(&mut []);
        if let Some(lanes) = rest.first_chunk_mut::<4>() {
            value.store(lanes);
        } else {
            let mut lanes = [0.0; 4];
            value.store(&mut lanes);
            for (to, value) in rest.iter_mut().zip(lanes) {
                *to = value;
            }
        }
    }
}

/// Σ_j s_B,j turn_j
#[inline(always)]
fn combination<const P: usize>(ds: [Lanes; P], turn: &[f64; P]) -> Lanes {
    let mut sum = Lanes::splat(0.0);
    for j in 0..P {
        let term = ds[j].times(Lanes::splat(turn[j]));
        sum = if j == 0 { term } else { sum.plus(term) };
    }
    sum
}

/// Four entries from `first` on, 0 beyond the last.
#[inline(always)]
pub(crate) fn padded(values: &[f64], first: usize) -> Lanes {
    let at = |l: usize| values.get(first + l).copied().unwrap_or(0.0);
    Lanes::new([at(0), at(1), at(2), at(3)])
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
