//! Contraction of normal and tangential contact at once: one row of K is a sum of at most 3 + P rows.
//!
//! ```text
//! row(A,k) = s_A u_k + n_k s_A,j g_j + π_q(A,k) Z_q + σ_A s_B δ_kl           [eq:tangential-contraction]
//! u_k      = s_B p_kl + s_B,j right_j[k] n_l + z_q[k] G_q + p_q[k] Z_q + σ_B δ_kl + n_k N J_(B,l)
//! g_j      = s_B left_j[l] + s_B,i s_ji n_l + z_qj G_q
//! π_q(A,k) = s_A,i p_qi[k] + s_A,ij p_qij n_k ,   z, p of Z and −P
//! ```

use crate::element::contraction::padded;
use crate::element::receiver::{Receiver, Write};
use crate::element::stage::TangentialRows;
use crate::element::traits::Element;
use crate::lanes::Lanes;
use crate::point::tangential::TangentialCoefficients;
use crate::point::values::{Coefficients, Rows};

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
    /// How the rows reach the outputs.
    pub write: Write,
}

/// Gives K to the receiver row by row: normal and tangential contact at once.
///
/// `scratch.columns`: u_k, s_B δ_kl, g_j and Z_q, four unknowns side by side; `blocks`: the rows of one node.
// a call, not inlined: the kernel around it stays as small as without friction
#[inline(never)]
pub fn contract_sliding<
    E: Element<D, P, H>,
    R: Receiver,
    const D: usize,
    const P: usize,
    const H: usize,
>(
    rows: &Rows<'_, P>,
    shares: &Shares<'_, D, P, H>,
    blocks: [&mut [f64]; D],
    scratch: &mut TangentialRows<'_, H>,
    receiver: &mut R,
) {
    // constants, but for slaves of any discretisation
    let n = match E::SLAVE_NODES {
        0 => rows.s.len(),
        slaves => slaves + E::MASTER_NODES,
    };
    let width = (n * D).next_multiple_of(4);
    let size = 2 * (P + D);
    let columns = core::mem::take(&mut scratch.columns);
    let (Some(s), Some(columns)) = (rows.s.get(..n), columns.get_mut(..size * width)) else {
        return;
    };
    if blocks.iter().any(|row| row.len() != width) {
        return;
    }
    let rows = Nodal {
        s,
        ds: core::array::from_fn(|i| as_long(rows.ds[i], s)),
        second: core::array::from_fn(|h| as_long(scratch.second[h], s)),
        slave: as_long(scratch.slave, s),
    };
    fill::<E, D, P, H>(
        &rows,
        shares,
        columns.as_chunks_mut::<4>().0.chunks_exact_mut(size),
    );
    let mut blocks = blocks.map(|row| row.as_chunks_mut::<4>().0);
    for a in 0..n {
        let quads = columns.as_chunks::<4>().0.chunks_exact(size);
        node_rows::<E, D, P, H>(a, &rows, shares, quads, &mut blocks);
        for (k, row) in blocks.iter().enumerate() {
            if let Some(row) = row.as_flattened().get(..n * D) {
                receiver.row(a * D + k, row, shares.write);
            }
        }
    }
}

/// Rows over the nodes.
struct Nodal<'a, const P: usize, const H: usize> {
    s: &'a [f64],
    ds: [&'a [f64]; P],
    second: [&'a [f64]; H],
    slave: &'a [f64],
}

/// The row over as many nodes as s, which the compiler then sees.
#[inline(always)]
fn as_long<'a>(row: &'a [f64], s: &'a [f64]) -> &'a [f64] {
    row.get(..s.len()).unwrap_or(s)
}

/// True where s_A,ij need not vanish.
fn is_bent<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>() -> bool {
    E::MOVING && E::CURVED.contains(&true)
}

/// All columns, four unknowns after the other.
#[inline(always)]
fn fill<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    rows: &Nodal<'_, P, H>,
    shares: &Shares<'_, D, P, H>,
    mut quads: core::slice::ChunksExactMut<'_, [f64; 4]>,
) {
    for first in (0..rows.s.len()).step_by(4) {
        let nodes = FourNodes::new::<E, D, H>(first, rows, shares);
        let start = D * first;
        let count = D * rows.s.len() - start;
        if let Some(quad) = quads.next() {
            columns_of::<0, E, D, P, H>(&nodes, shares, start, quad);
        }
        if count > 4
            && let Some(quad) = quads.next()
        {
            columns_of::<1, E, D, P, H>(&nodes, shares, start + 4, quad);
        }
        if D > 2
            && count > 8
            && let Some(quad) = quads.next()
        {
            columns_of::<2, E, D, P, H>(&nodes, shares, start + 8, quad);
        }
    }
}

/// The D rows of node a.
#[inline(always)]
fn node_rows<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    a: usize,
    rows: &Nodal<'_, P, H>,
    shares: &Shares<'_, D, P, H>,
    quads: core::slice::ChunksExact<'_, [f64; 4]>,
    blocks: &mut [&mut [[f64; 4]]; D],
) {
    let s = entry(rows.s, a);
    // a slave's node without a projection turns no tangent
    if !E::MOVING || !E::TWO_CURVES && a + E::MASTER_NODES < rows.s.len() {
        for (number, quad) in quads.enumerate() {
            for k in 0..D {
                store(blocks[k], number, load(quad, k).scaled(s));
            }
        }
        return;
    }
    let ds: [f64; P] = core::array::from_fn(|i| entry(rows.ds[i], a));
    let (cross, turns) = node_factors::<E, D, P, H>(a, &ds, rows, shares);
    let (s, cross) = (Lanes::splat(s), Lanes::splat(cross));
    let ds = ds.map(Lanes::splat);
    let n = shares.n.map(Lanes::splat);
    let turns = turns.map(|turn| turn.map(Lanes::splat));
    for (number, quad) in quads.enumerate() {
        let mut along = ds[0].times(load(quad, 2 * D));
        for j in 1..P {
            along = along.plus(ds[j].times(load(quad, 2 * D + j)));
        }
        for k in 0..D {
            let mut sum = s.times(load(quad, k)).plus(cross.times(load(quad, D + k)));
            sum = sum.plus(n[k].times(along));
            for q in 0..P {
                sum = sum.plus(turns[q][k].times(load(quad, 2 * D + P + q)));
            }
            store(blocks[k], number, sum);
        }
    }
}

/// σ_A and π_q of node a.
#[inline(always)]
fn node_factors<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    a: usize,
    ds: &[f64; P],
    rows: &Nodal<'_, P, H>,
    shares: &Shares<'_, D, P, H>,
) -> (f64, [[f64; D]; P]) {
    let c = shares.tangential;
    let mut cross = 0.0;
    let mut turns = [[0.0; D]; P];
    for i in 0..P {
        cross += c.cross[i] * ds[i];
    }
    for q in 0..P {
        let mut bend = 0.0;
        for h in 0..H {
            if E::CURVED[h] {
                bend += entry(rows.second[h], a) * c.p[q].bending[h];
            }
        }
        for k in 0..D {
            turns[q][k] = bend * shares.n[k];
            for i in 0..P {
                turns[q][k] += ds[i] * c.p[q].turning[i][k];
            }
        }
    }
    (cross, turns)
}

/// What four nodes bring along: one number each.
struct FourNodes<const P: usize> {
    s: Lanes,
    ds: [Lanes; P],
    /// σ_B
    cross: Lanes,
    /// z_qi s_B,i
    turning: [Lanes; P],
    /// s_B,ij p_qij
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
    fn new<E: Element<D, P, H>, const D: usize, const H: usize>(
        first: usize,
        rows: &Nodal<'_, P, H>,
        shares: &Shares<'_, D, P, H>,
    ) -> Self {
        let none = Lanes::splat(0.0);
        let (c, normal) = (shares.tangential, shares.normal);
        let ds: [Lanes; P] = core::array::from_fn(|i| four(rows.ds[i], first));
        let mut nodes = Self {
            s: four(rows.s, first),
            ds,
            cross: weighted(&ds, &c.cross),
            turning: core::array::from_fn(|q| weighted(&ds, &c.z[q].turning)),
            bending: [none; P],
            right: [none; 3],
            rotation: core::array::from_fn(|i| weighted(&ds, &normal.s[i])),
            slave: none,
        };
        for (k, right) in nodes.right.iter_mut().enumerate().take(D) {
            *right = weighted(&ds, &core::array::from_fn(|j| normal.right[j][k]));
        }
        for h in 0..H {
            if E::MOVING && E::CURVED[h] {
                let second = four(rows.second[h], first);
                for (bending, p) in nodes.bending.iter_mut().zip(&c.p) {
                    *bending = bending.plus(second.scaled(p.bending[h]));
                }
            }
        }
        if E::SLAVE_AXIS {
            nodes.slave = four(rows.slave, first);
        }
        nodes
    }
}

/// Four entries of u_k, s_B δ_kl, g_j and Z_q: part `PART` of four nodes, from unknown `start` on.
// long: the sums of the file's head, term by term
#[inline(always)]
fn columns_of<
    const PART: usize,
    E: Element<D, P, H>,
    const D: usize,
    const P: usize,
    const H: usize,
>(
    nodes: &FourNodes<P>,
    shares: &Shares<'_, D, P, H>,
    start: usize,
    quad: &mut [[f64; 4]],
) {
    let (c, normal) = (shares.tangential, shares.normal);
    let spread = |lanes: Lanes| lanes.of_nodes::<D>(PART);
    let vector = |v: &[f64; D]| padded(v, 0).of_components::<D>(PART);
    let unit = |k: usize| vector(&core::array::from_fn(|l| f64::from(u8::from(k == l))));
    let (s, n, cross) = (spread(nodes.s), vector(shares.n), spread(nodes.cross));
    let (mut z, mut g) = ([s; P], [s; P]);
    for q in 0..P {
        z[q] = s
            .times(vector(&c.z[q].position))
            .plus(spread(nodes.turning[q]).times(n));
        g[q] = s.times(vector(&c.g[q].position));
        for i in 0..P {
            g[q] = g[q].plus(spread(nodes.ds[i]).times(vector(&c.g[q].turning[i])));
        }
        if is_bent::<E, D, P, H>() {
            g[q] = g[q].plus(spread(nodes.bending[q]).times(n));
        }
        if E::SLAVE_AXIS {
            g[q] = g[q].plus(spread(nodes.slave).times(vector(&c.g[q].slave)));
        }
    }
    let mut traction = None;
    if E::CURRENT {
        let measure = four(shares.measure, start);
        traction = Some(measure.scaled(shares.traction));
        for q in 0..P {
            g[q] = g[q].plus(measure.scaled(shares.t[q]));
        }
    }
    for k in 0..D {
        let mut u = s
            .times(vector(&normal.p[k]))
            .plus(spread(nodes.right[k]).times(n));
        for q in 0..P {
            u = u.plus(g[q].scaled(c.z[q].position[k]));
            u = u.plus(z[q].scaled(c.p[q].position[k]));
        }
        if let Some(traction) = traction {
            u = u.plus(traction.scaled(shares.n[k]));
        }
        store(quad, k, u.plus(cross.times(unit(k))));
        store(quad, D + k, s.times(unit(k)));
    }
    for j in 0..P {
        let mut along = s.times(vector(&normal.left[j]));
        along = along.plus(spread(nodes.rotation[j]).times(n));
        for q in 0..P {
            along = along.plus(g[q].scaled(c.z[q].turning[j]));
        }
        store(quad, 2 * D + j, along);
        store(quad, 2 * D + P + j, z[j]);
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
fn load(quad: &[[f64; 4]], index: usize) -> Lanes {
    Lanes::new(quad.get(index).copied().unwrap_or_default())
}

#[inline(always)]
fn entry(row: &[f64], index: usize) -> f64 {
    row.get(index).copied().unwrap_or(0.0)
}
