//! Rows of K straight into the host's matrix, several unknowns at a time. [eq:contraction]
//!
//! The same products and sums in the same order as [`contract`](crate::element::contraction::contract), so the same bits.

use crate::element::receiver::Write;
use crate::lanes::{Four, Quad, Wide, Width};

/// u_k and g_j of the contraction, over all unknowns.
pub(crate) struct Factors<'a, const D: usize, const P: usize> {
    pub(crate) u: [&'a [f64]; D],
    pub(crate) g: [&'a [f64]; P],
}

/// Contributions of one node to u_k and g_j.
pub(crate) struct NodeShare<const D: usize, const P: usize> {
    /// s_B
    pub(crate) s: f64,
    /// s_B,j right_j[k]
    pub(crate) right: [f64; D],
    /// s_B,i s_ji
    pub(crate) turn: [f64; P],
}

/// True if every row of the factors has at least `unknowns` entries.
#[inline(always)]
fn are_long<const D: usize, const P: usize>(
    u: [&[f64]; D],
    g: [&[f64]; P],
    unknowns: usize,
) -> bool {
    let mut are_long = true;
    for row in u {
        are_long &= row.len() >= unknowns;
    }
    for row in g {
        are_long &= row.len() >= unknowns;
    }
    are_long
}

/// u_k(B,l) = s_B p_kl + s_B,j right_j[k] n_l and g_j(B,l) = s_B left_j[l] + s_B,i s_ji n_l, node after node.
///
/// Each vector is padded by zeros; what a node writes beyond its own unknowns is overwritten by the next.
/// Nothing is done where the rows are too short.
#[inline(always)]
pub(crate) fn fill<Q: Quad, const D: usize, const P: usize>(
    nodes: impl ExactSizeIterator<Item = NodeShare<D, P>>,
    n: [f64; 4],
    (p, left): ([[f64; 4]; D], [[f64; 4]; P]),
    (u, g): ([&mut [f64]; D], [&mut [f64]; P]),
) {
    const { assert!(2 <= D && D <= 4) };
    let last = nodes.len().wrapping_sub(1);
    if !are_long(
        u.each_ref().map(|row| &**row),
        g.each_ref().map(|row| &**row),
        nodes.len() * D,
    ) {
        return;
    }
    let n = Q::new(n);
    let (p, left) = (p.map(Q::new), left.map(Q::new));
    for (b, node) in nodes.enumerate() {
        let s = Q::same(node.s);
        // SAFETY: the rows have D entries for every node; four numbers of a node that is not the last end within those of
        // the next, since D is 2 or more.
        unsafe {
            for k in 0..D {
                let mut value = s * p[k];
                if P > 0 {
                    value = value + Q::same(node.right[k]) * n;
                }
                put::<Q, D>(value, u[k].as_mut_ptr().add(b * D), b == last);
            }
            for j in 0..P {
                let value = s * left[j] + Q::same(node.turn[j]) * n;
                put::<Q, D>(value, g[j].as_mut_ptr().add(b * D), b == last);
            }
        }
    }
}

/// All four numbers, or those of the last node alone.
///
/// # Safety
/// There is room for them.
#[inline(always)]
unsafe fn put<Q: Quad, const D: usize>(value: Q, to: *mut f64, is_last: bool) {
    if is_last {
        let mut values = [0.0; 4];
        value.store(&mut values);
        for (k, &value) in values.iter().enumerate().take(D) {
            // SAFETY: promised by the caller.
            unsafe { *to.add(k) = value };
        }
    } else {
        // SAFETY: promised by the caller.
        unsafe { value.store_at(to) };
    }
}

/// K(A,k) = s_A u_k + n_k s_A,j g_j, all rows, `apart` places from one to the next.
/// False, and nothing done, where the lengths do not belong together or a row is shorter than the lanes.
#[inline(always)]
pub(crate) fn write<T: Wide, const D: usize, const P: usize>(
    nodes: impl ExactSizeIterator<Item = (f64, [f64; P])>,
    n: &[f64; D],
    factors: &Factors<'_, D, P>,
    (to, apart): (&mut [f64], usize),
    how: Write,
) -> bool {
    let unknowns = nodes.len() * D;
    let has_room = apart >= unknowns && to.len() >= unknowns * apart;
    if !has_room || !are_long(factors.u, factors.g, unknowns) || unknowns < T::WIDTH {
        return false;
    }
    let lanes = n.map(T::constant);
    if how == Write::Replace {
        for (a, (s, ds)) in nodes.enumerate() {
            // SAFETY: all of u and g have an entry for every unknown, K a row.
            unsafe {
                let place = to.as_mut_ptr().add(a * D * apart);
                let own = (T::constant(s), ds.map(T::constant));
                write_node::<T, true, D, P>(own, &lanes, factors, (place, apart), unknowns);
            }
        }
        return true;
    }
    let whole = unknowns - unknowns % T::WIDTH;
    for ((s, ds), rows) in nodes.zip(to.chunks_exact_mut((D * apart).max(1))) {
        // SAFETY: as above.
        unsafe {
            let own = (T::constant(s), ds.map(T::constant));
            let place = (rows.as_mut_ptr(), apart);
            write_node::<T, false, D, P>(own, &lanes, factors, place, whole);
        }
        add_rest(s, &ds, n, factors, (rows, apart, whole..unknowns));
    }
    true
}

/// The first `columns` entries of the D rows of a node with s_A, s_A,j, the first of them at `place`. Those that replace
/// may overlap in the last lanes; those that add are whole lanes.
///
/// # Safety
/// There are so many entries in each u_k, g_j and in each of the D rows, and enough of them for the lanes.
#[inline(always)]
unsafe fn write_node<T: Wide, const FIRST: bool, const D: usize, const P: usize>(
    (s, ds): (T, [T; P]),
    n: &[T; D],
    factors: &Factors<'_, D, P>,
    (place, apart): (*mut f64, usize),
    columns: usize,
) {
    for column in (0..columns).step_by(T::WIDTH) {
        let column = if FIRST {
            column.min(columns - T::WIDTH)
        } else {
            column
        };
        // SAFETY: promised by the caller.
        unsafe {
            let mut along = T::constant(0.0);
            for j in 0..P {
                let term = ds[j] * T::load_at(factors.g[j].as_ptr().add(column));
                along = if j == 0 { term } else { along + term };
            }
            for k in 0..D {
                let mut value = s * T::load_at(factors.u[k].as_ptr().add(column));
                if P > 0 {
                    value = value + n[k] * along;
                }
                let place = place.add(k * apart + column);
                if !FIRST {
                    value = T::load_at(place) + value;
                }
                value.store_at(place);
            }
        }
    }
}

/// Adds the entries of the columns that fill no lanes.
#[inline(always)]
fn add_rest<const D: usize, const P: usize>(
    s: f64,
    ds: &[f64; P],
    n: &[f64; D],
    factors: &Factors<'_, D, P>,
    (rows, apart, columns): (&mut [f64], usize, core::ops::Range<usize>),
) {
    let rows = rows.chunks_exact_mut(apart.max(1));
    for ((row, u), n) in rows.zip(factors.u).zip(n) {
        let own = row.get_mut(columns.clone()).unwrap_or_default();
        for (column, entry) in columns.clone().zip(own) {
            let at = |row: &[f64]| row.get(column).copied().unwrap_or(0.0);
            let mut along = 0.0;
            for j in 0..P {
                let term = ds[j] * at(factors.g[j]);
                along = if j == 0 { term } else { along + term };
            }
            let mut value = s * at(u);
            if P > 0 {
                value += n * along;
            }
            *entry += value;
        }
    }
}

/// A contraction as a whole, for kernels that are compiled once for all elements.
pub(crate) struct Contraction<'a, const D: usize, const P: usize> {
    /// s_A
    pub(crate) s: &'a [f64],
    /// s_A,j
    pub(crate) ds: [&'a [f64]; P],
    pub(crate) n: &'a [f64; D],
    pub(crate) p: &'a [[f64; D]; D],
    pub(crate) right: [&'a [f64; D]; P],
    pub(crate) left: [&'a [f64; D]; P],
    /// s_ij
    pub(crate) turn: [[f64; P]; P],
    /// w N ∂J/∂x_B per unknown, where the measure moves.
    pub(crate) measure: &'a [f64],
}

impl<const D: usize, const P: usize> Contraction<'_, D, P> {
    /// All rows by lanes T; u and g are scratch. `count`: number of nodes.
    #[inline(always)]
    fn write<T: Wide>(
        &self,
        count: usize,
        (mut u, mut g): ([&mut [f64]; D], [&mut [f64]; P]),
        to: (&mut [f64], usize),
        how: Write,
    ) -> bool {
        let mut are_rows = self.s.len() == count;
        for row in self.ds {
            are_rows &= row.len() >= count;
        }
        if !are_rows {
            return false;
        }
        // SAFETY: each row has an entry for every node.
        let node = |a: usize| unsafe {
            let slopes: [f64; P] = core::array::from_fn(|j| *self.ds[j].as_ptr().add(a));
            (*self.s.as_ptr().add(a), slopes)
        };
        let shares = (0..count).map(|b| {
            let (s, slopes) = node(b);
            let (mut right, mut turn) = ([0.0; D], [0.0; P]);
            for j in 0..P {
                for k in 0..D {
                    let term = slopes[j] * self.right[j][k];
                    right[k] = if j == 0 { term } else { right[k] + term };
                }
                for i in 0..P {
                    let term = slopes[j] * self.turn[i][j];
                    turn[i] = if j == 0 { term } else { turn[i] + term };
                }
            }
            NodeShare { s, right, turn }
        });
        fill::<T::Quad, D, P>(
            shares,
            padded(self.n),
            (
                core::array::from_fn(|k| padded(&self.p[k])),
                self.left.map(padded),
            ),
            (
                u.each_mut().map(|row| &mut **row),
                g.each_mut().map(|row| &mut **row),
            ),
        );
        for (u, &n) in u.iter_mut().zip(self.n) {
            for (u, &m) in u.iter_mut().zip(self.measure) {
                *u += n * m;
            }
        }
        let factors = Factors {
            u: u.map(|row| &*row),
            g: g.map(|row| &*row),
        };
        write::<T, D, P>((0..count).map(node), self.n, &factors, to, how)
    }

    /// All rows, where the processor has the lanes for it; false where K was not touched.
    #[inline(always)]
    pub(crate) fn write_wide(
        &self,
        scratch: ([&mut [f64]; D], [&mut [f64]; P]),
        to: (&mut [f64], usize),
        how: Write,
    ) -> bool {
        #[cfg(target_arch = "x86_64")]
        if Width::widest() >= Width::Four {
            // compiled for the numbers of nodes that most elements have, and for any
            let kernel = match self.s.len() {
                4 if P > 0 => four::<D, P, 4>,
                5 if P > 0 => four::<D, P, 5>,
                8 if P > 0 => four::<D, P, 8>,
                10 if P > 0 => four::<D, P, 10>,
                _ => four::<D, P, 0>,
            };
            // SAFETY: the processor has AVX2.
            return unsafe { kernel(self, scratch, to, how) };
        }
        false
    }
}

/// All rows of N nodes, of any number where N = 0.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
#[inline(never)]
fn four<const D: usize, const P: usize, const N: usize>(
    contraction: &Contraction<'_, D, P>,
    scratch: ([&mut [f64]; D], [&mut [f64]; P]),
    to: (&mut [f64], usize),
    how: Write,
) -> bool {
    let count = if N == 0 { contraction.s.len() } else { N };
    contraction.write::<Four>(count, scratch, to, how)
}

/// A vector as a quadruple.
#[inline(always)]
fn padded<const D: usize>(v: &[f64; D]) -> [f64; 4] {
    core::array::from_fn(|k| v.get(k).copied().unwrap_or(0.0))
}
