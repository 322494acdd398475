//! Contraction with shape rows: level 2, usable with rows of any discretisation.
//!
//! ```text
//! R_(A,k)       = N s_A n_k                                                            [eq:residual]
//! K_(A,k)(B,l)  = s_A s_B p_kl + s_A s_B,j right_j[k] n_l + n_k s_A,j s_B left_j[l]
//!                 + s_A,i s_B,j s_ij n_k n_l + s_A n_k N J_(B,l)                      [eq:contraction]
//! ```
//!
//! Nodes are loops; for every entry of a row of K two multiply-adds remain.

use crate::element::receiver::{Receiver, Write};
use crate::element::rows::Contraction;
use crate::element::stage::Temporaries;
use crate::lanes::Lanes;
use crate::point::values::Coefficients;

/// Fewest unknowns for which rows are written several at a time, if the receiver allows it.
const FEWEST: usize = 8;

/// What a contraction is made of.
#[derive(Clone, Copy, Debug)]
pub struct NormalContraction<'a, const D: usize, const P: usize> {
    /// Rows s_A of the nodes.
    pub s: &'a [f64],
    /// Rows s_A,j of the nodes.
    pub ds: [&'a [f64]; P],
    /// Normal.
    pub n: &'a [f64; D],
    /// Already multiplied by the point's weight.
    pub coefficients: &'a Coefficients<D, P>,
    /// w N ∂J/∂x_B per unknown, where the measure moves; empty otherwise.
    pub measure: &'a [f64],
    /// False where all s_A,j vanish (rigid masters).
    pub moving: bool,
    /// How the rows reach the outputs.
    pub write: Write,
}

/// Writes K row by row to the receiver.
#[inline(always)]
pub fn contract<R: Receiver, const D: usize, const P: usize>(
    contraction: &NormalContraction<'_, D, P>,
    temporaries: &mut Temporaries<'_, D, P>,
    receiver: &mut R,
) {
    // taken out: an index that runs over fields of the scratch would keep all of it, nodes included, in memory
    let mut u = temporaries.u.each_mut().map(|row| &mut **row);
    let mut g = temporaries.g.each_mut().map(|row| &mut **row);
    if contraction.s.len() * D >= FEWEST
        && let Some(to) = receiver.rows()
        && contraction.write_wide(&mut u, &mut g, to)
    {
        return;
    }
    let (h, row) = (&mut *temporaries.h, &mut *temporaries.row);
    contraction.fill(&mut u, &mut g, row.len());
    contraction.write_rows(&u, &g, h, row, receiver);
}

impl<const D: usize, const P: usize> NormalContraction<'_, D, P> {
    /// All rows at once into `to`, where the processor has the lanes for it; false where nothing was written.
    #[inline(always)]
    fn write_wide(
        &self,
        u: &mut [&mut [f64]; D],
        g: &mut [&mut [f64]; P],
        to: (&mut [f64], usize),
    ) -> bool {
        let u = u.each_mut().map(|row| &mut **row);
        let c = self.coefficients;
        if self.moving {
            let contraction = Contraction {
                s: self.s,
                ds: self.ds,
                n: self.n,
                p: &c.p,
                right: c.right.each_ref(),
                left: c.left.each_ref(),
                turn: c.s,
                measure: self.measure,
            };
            let scratch = (u, g.each_mut().map(|row| &mut **row));
            return contraction.write_wide(scratch, to, self.write);
        }
        let contraction = Contraction {
            s: self.s,
            ds: [],
            n: self.n,
            p: &c.p,
            right: [],
            left: [],
            turn: [],
            measure: self.measure,
        };
        contraction.write_wide((u, []), to, self.write)
    }

    /// u_k and g_j for the first `width` unknowns.
    #[inline(always)]
    fn fill(&self, u: &mut [&mut [f64]; D], g: &mut [&mut [f64]; P], width: usize) {
        let (n, c) = (self.n, self.coefficients);
        for k in 0..D {
            let factors = core::array::from_fn(|j| c.right[j][k]);
            let turn = self.moving.then_some(&factors);
            factor(u[k], width, self.s, self.ds, &c.p[k], n, turn);
            for (u, &m) in u[k].iter_mut().zip(self.measure) {
                *u += n[k] * m;
            }
        }
        if self.moving {
            for j in 0..P {
                let turn = Some(&c.s[j]);
                factor(g[j], width, self.s, self.ds, &c.left[j], n, turn);
            }
        }
    }

    /// K(A,k) = s_A u_k + n_k s_A,j g_j, row by row.
    #[inline(always)]
    fn write_rows<R: Receiver>(
        &self,
        u: &[&mut [f64]; D],
        g: &[&mut [f64]; P],
        h: &mut [f64],
        row: &mut [f64],
        receiver: &mut R,
    ) {
        let unknowns = self.s.len() * D;
        for (a, &s_a) in self.s.iter().enumerate() {
            if self.moving {
                combine(h, g, self.ds, a);
            }
            for k in 0..D {
                if self.moving {
                    let pairs = u[k].iter().zip(h.iter());
                    for (row, (&u, &h)) in row.iter_mut().zip(pairs) {
                        *row = s_a * u + self.n[k] * h;
                    }
                } else {
                    for (row, &u) in row.iter_mut().zip(u[k].iter()) {
                        *row = s_a * u;
                    }
                }
                let row = row.get(..unknowns).unwrap_or(&[]);
                receiver.row(a * D + k, row, self.write);
            }
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
