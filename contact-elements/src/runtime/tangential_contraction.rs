//! Contraction of normal and tangential contact at once: one row of K is a sum of at most 2 + P rows.
//!
//! ```text
//! row(A,k) = s_A u_k + s_A,i v_ik + n_k b_qA Z_q                             [eq:tangential-contraction]
//! u_k      = s_B p_kl + s_B,j right_j[k] n_l + z_q[k] G_q + p_q[k] Z_q + σ_B δ_kl + n_k N J_(B,l)
//! v_ik     = n_k (s_B left_i[l] + s_B,j s_ij n_l + z_qi G_q) + p_qi[k] Z_q + cross_i s_B δ_kl
//! b_qA     = s_A,ij p_qij ,   z, p of Z and −P
//! ```

use super::contraction::padded;
use super::driver::Receiver;
use super::lanes::Lanes;
use super::tangential::{TangentialCoefficients, TangentialRows};
use super::values::{Coefficients, Rows};

/// A point's share of the tangent, normal and tangential.
#[derive(Clone, Copy, Debug)]
pub struct Shares<'a, const D: usize, const P: usize, const H: usize> {
    /// Normal in the global frame.
    pub n: &'a [f64; D],
    /// Already multiplied by the point's weight.
    pub normal: &'a Coefficients<D, P>,
    /// Already multiplied by the point's weight.
    pub tangential: &'a TangentialCoefficients<D, P, H>,
    /// w ∂J/∂x per unknown, where the measure moves; else empty.
    pub measure: &'a [f64],
    /// N, which multiplies the measure's rows.
    pub traction: f64,
    /// t_q, which multiply them.
    pub t: [f64; P],
    /// False where all s_A,i vanish.
    pub moving: bool,
    /// True where the slave's tangent is an axis.
    pub slave_axis: bool,
    /// True where the rows replace what the receiver holds.
    pub first: bool,
}

/// Gives K to the receiver row by row: normal and tangential contact at once.
///
/// `scratch.columns`: Z_q, u_k and v_ik, four unknowns side by side; `blocks`: the rows of one node.
// a call, not inlined: one copy serves all elements of the same sizes
#[inline(never)]
pub fn contract_sliding<R: Receiver, const D: usize, const P: usize, const H: usize>(
    rows: &Rows<'_, P>,
    shares: &Shares<'_, D, P, H>,
    blocks: [&mut [f64]; D],
    scratch: &mut TangentialRows<'_, H>,
    receiver: &mut R,
) {
    let size = P + D + P * D;
    let (columns, _) = scratch.columns.as_chunks_mut::<4>();
    let mut quads = columns.chunks_exact_mut(size);
    for first in (0..rows.s.len()).step_by(4) {
        let second: [&[f64]; H] = core::array::from_fn(|h| &*scratch.second[h]);
        let nodes = FourNodes::new(first, rows, shares, (&second, scratch.slave));
        let start = D * first;
        let count = D * rows.s.len() - start;
        if let Some(quad) = quads.next() {
            columns_of::<0, D, P, H>(&nodes, shares, start, quad);
        }
        if let (true, Some(quad)) = (count > 4, quads.next()) {
            columns_of::<1, D, P, H>(&nodes, shares, start + 4, quad);
        }
        if let (true, Some(quad)) = (D > 2 && count > 8, quads.next()) {
            columns_of::<2, D, P, H>(&nodes, shares, start + 8, quad);
        }
    }
    let unknowns = rows.s.len() * D;
    let mut blocks = blocks.map(|row| row.as_chunks_mut::<4>().0);
    for (a, &s_a) in rows.s.iter().enumerate() {
        let ds: [f64; P] = core::array::from_fn(|i| entry(rows.ds[i], a));
        let mut bends = [0.0; P];
        for (bend, p) in bends.iter_mut().zip(&shares.tangential.p) {
            for h in 0..H {
                *bend += entry(scratch.second[h], a) * p.bending[h];
            }
        }
        let (columns, _) = scratch.columns.as_chunks::<4>();
        let quads = columns.chunks_exact(size);
        let node = (s_a, &ds, &bends);
        // two curves: a node turns one of the tangents; a slave's node without a projection none
        match (ds[0] != 0.0, P == 2 && ds[P - 1] != 0.0, bends != [0.0; P]) {
            (false, false, false) => node_rows::<0, 0, false, D, P>(node, shares.n, quads, &mut blocks),
            (true, false, false) => node_rows::<0, 1, false, D, P>(node, shares.n, quads, &mut blocks),
            (true, false, true) => node_rows::<0, 1, true, D, P>(node, shares.n, quads, &mut blocks),
            (false, true, false) => node_rows::<1, 2, false, D, P>(node, shares.n, quads, &mut blocks),
            (false, true, true) => node_rows::<1, 2, true, D, P>(node, shares.n, quads, &mut blocks),
            (true, true, false) => node_rows::<0, 2, false, D, P>(node, shares.n, quads, &mut blocks),
            _ => node_rows::<0, 2, true, D, P>(node, shares.n, quads, &mut blocks),
        }
        for (k, row) in blocks.iter().enumerate() {
            let row = row.as_flattened().get(..unknowns).unwrap_or_default();
            receiver.row(a * D + k, row, shares.first);
        }
    }
}

/// The D rows of one node: s_A u_k + s_A,i v_ik, i from `FIRST` to below `LAST`, and with `BENDS` n_k b_q Z_q.
#[inline(always)]
fn node_rows<const FIRST: usize, const LAST: usize, const BENDS: bool, const D: usize, const P: usize>(
    (s, ds, bends): (f64, &[f64; P], &[f64; P]),
    n: &[f64; D],
    quads: core::slice::ChunksExact<'_, [f64; 4]>,
    blocks: &mut [&mut [[f64; 4]]; D],
) {
    let s = Lanes::splat(s);
    let ds = ds.map(Lanes::splat);
    let bends = bends.map(Lanes::splat);
    let n = n.map(Lanes::splat);
    for (number, quad) in quads.enumerate() {
        let at = |index: usize| quad.get(index).map_or(s, |lanes| Lanes::new(*lanes));
        let mut bend = s;
        if BENDS {
            bend = bends[0].times(at(0));
            for q in 1..P {
                bend = bend.plus(bends[q].times(at(q)));
            }
        }
        for k in 0..D {
            let mut sum = s.times(at(P + k));
            for i in FIRST..LAST.min(P) {
                sum = sum.plus(ds[i].times(at(P + D + D * i + k)));
            }
            if BENDS {
                sum = sum.plus(n[k].times(bend));
            }
            if let Some(row) = blocks[k].get_mut(number) {
                sum.store(row);
            }
        }
    }
}

/// What four nodes bring along: one number each.
struct FourNodes<const P: usize> {
    s: Lanes,
    ds: [Lanes; P],
    /// σ_B
    cross: Lanes,
    /// z_qi s_B,i
    turning: [Lanes; P],
    /// b_qB
    bending: [Lanes; P],
    /// right_j[k] s_B,j
    right: [Lanes; 3],
    /// s_ij s_B,j
    rotation: [Lanes; P],
    /// Row of the slave's tangent.
    slave: Lanes,
}

impl<const P: usize> FourNodes<P> {
    #[inline(always)]
    fn new<const D: usize, const H: usize>(
        first: usize,
        rows: &Rows<'_, P>,
        shares: &Shares<'_, D, P, H>,
        (second, slave): (&[&[f64]; H], &[f64]),
    ) -> Self {
        let none = Lanes::splat(0.0);
        let (c, normal) = (shares.tangential, shares.normal);
        let ds: [Lanes; P] = core::array::from_fn(|i| four(rows.ds[i], first));
        let second: [Lanes; H] = core::array::from_fn(|h| four(second[h], first));
        Self {
            s: four(rows.s, first),
            ds,
            cross: weighted(&ds, &c.cross),
            turning: core::array::from_fn(|q| weighted(&ds, &c.z[q].turning)),
            bending: core::array::from_fn(|q| weighted(&second, &c.p[q].bending)),
            right: core::array::from_fn(|k| match k < D {
                true => weighted(&ds, &core::array::from_fn(|j| normal.right[j][k])),
                false => none,
            }),
            rotation: core::array::from_fn(|i| weighted(&ds, &normal.s[i])),
            slave: match shares.slave_axis {
                true => four(slave, first),
                false => none,
            },
        }
    }
}

/// Four entries of Z_q, u_k and v_ik: part `PART` of four nodes, from unknown `start` on.
#[inline(always)]
fn columns_of<const PART: usize, const D: usize, const P: usize, const H: usize>(
    nodes: &FourNodes<P>,
    shares: &Shares<'_, D, P, H>,
    start: usize,
    quad: &mut [[f64; 4]],
) {
    let (c, normal) = (shares.tangential, shares.normal);
    let spread = |lanes: Lanes| lanes.of_nodes::<D>(PART);
    let vector = |v: &[f64; D]| padded(v, 0).of_components::<D>(PART);
    let unit = |k: usize| vector(&core::array::from_fn(|l| f64::from(u8::from(k == l))));
    let (n, s) = (vector(shares.n), spread(nodes.s));
    let ds = nodes.ds.map(spread);
    let measure = match shares.measure.is_empty() {
        true => None,
        false => Some(four(shares.measure, start)),
    };
    let mut z = [s; P];
    let mut g = [s; P];
    for q in 0..P {
        z[q] = s.times(vector(&c.z[q].position)).plus(spread(nodes.turning[q]).times(n));
        g[q] = s.times(vector(&c.g[q].position)).plus(spread(nodes.bending[q]).times(n));
        for i in 0..P {
            g[q] = g[q].plus(ds[i].times(vector(&c.g[q].turning[i])));
        }
        if shares.slave_axis {
            g[q] = g[q].plus(spread(nodes.slave).times(vector(&c.g[q].slave)));
        }
        if let Some(measure) = measure {
            g[q] = g[q].plus(Lanes::splat(shares.t[q]).times(measure));
        }
        store(quad, q, z[q]);
    }
    for k in 0..D {
        let mut u = s.times(vector(&normal.p[k])).plus(spread(nodes.right[k]).times(n));
        for q in 0..P {
            u = u.plus(Lanes::splat(c.z[q].position[k]).times(g[q]));
            u = u.plus(Lanes::splat(c.p[q].position[k]).times(z[q]));
        }
        if let Some(measure) = measure {
            u = u.plus(Lanes::splat(shares.n[k] * shares.traction).times(measure));
        }
        u = u.plus(spread(nodes.cross).times(unit(k)));
        store(quad, P + k, u);
    }
    if !shares.moving {
        return;
    }
    for i in 0..P {
        let mut along = s.times(vector(&normal.left[i])).plus(spread(nodes.rotation[i]).times(n));
        for q in 0..P {
            along = along.plus(Lanes::splat(c.z[q].turning[i]).times(g[q]));
        }
        let cross = Lanes::splat(c.cross[i]).times(s);
        for k in 0..D {
            let mut v = Lanes::splat(shares.n[k]).times(along).plus(cross.times(unit(k)));
            for q in 0..P {
                v = v.plus(Lanes::splat(c.p[q].turning[i][k]).times(z[q]));
            }
            store(quad, P + D + D * i + k, v);
        }
    }
}

/// Σ_i factor_i lanes_i
#[inline(always)]
fn weighted<const N: usize>(lanes: &[Lanes; N], factors: &[f64; N]) -> Lanes {
    let mut sum = Lanes::splat(0.0);
    for i in 0..N {
        let term = lanes[i].times(Lanes::splat(factors[i]));
        sum = if i == 0 { term } else { sum.plus(term) };
    }
    sum
}

/// Four entries from `first` on, 0 beyond the last.
#[inline(always)]
fn four(row: &[f64], first: usize) -> Lanes {
    let rest = row.get(first..).unwrap_or_default();
    match rest.first_chunk::<4>() {
        Some(four) => Lanes::new(*four),
        None => padded(rest, 0),
    }
}

#[inline(always)]
fn store(quad: &mut [[f64; 4]], index: usize, value: Lanes) {
    if let Some(four) = quad.get_mut(index) {
        value.store(four);
    }
}

#[inline(always)]
fn entry(row: &[f64], index: usize) -> f64 {
    row.get(index).copied().unwrap_or(0.0)
}
