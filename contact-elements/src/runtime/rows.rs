//! Rows of K straight into the host's matrix, several unknowns at a time. [eq:contraction]
//!
//! The same products and sums in the same order as [`contract`](super::contract), so the same bits.

#[cfg(target_arch = "x86_64")]
use super::batch::{Four, Width};
use super::batch::{Quad, Wide};

/// u_k and g_j of the contraction, over all unknowns.
pub(super) struct Factors<'a, const D: usize, const P: usize> {
    pub(super) u: [&'a [f64]; D],
    pub(super) g: [&'a [f64]; P],
}

/// What one node adds to u_k and g_j.
pub(super) struct NodeShare<const D: usize, const P: usize> {
    /// s_B
    pub(super) s: f64,
    /// s_B,j right_j[k]
    pub(super) right: [f64; D],
    /// s_B,i s_ji
    pub(super) turn: [f64; P],
}

/// u_k(B,l) = s_B p_kl + s_B,j right_j[k] n_l and g_j(B,l) = s_B left_j[l] + s_B,i s_ji n_l, node after node.
///
/// Each vector is padded by zeros; what a node writes beyond its own unknowns is overwritten by the next.
#[inline(always)]
pub(super) fn fill<Q: Quad, const D: usize, const P: usize>(
    nodes: impl Iterator<Item = NodeShare<D, P>>,
    n: [f64; 4],
    (p, left): ([[f64; 4]; D], [[f64; 4]; P]),
    (u, g): ([&mut [f64]; D], [&mut [f64]; P]),
) {
    let n = Q::new(n);
    let (p, left) = (p.map(Q::new), left.map(Q::new));
    for (b, node) in nodes.enumerate() {
        let s = Q::same(node.s);
        for k in 0..D {
            let mut value = s * p[k];
            if P > 0 {
                value = value + Q::same(node.right[k]) * n;
            }
            put(value, u[k].get_mut(b * D..).unwrap_or(&mut []));
        }
        for j in 0..P {
            let value = s * left[j] + Q::same(node.turn[j]) * n;
            put(value, g[j].get_mut(b * D..).unwrap_or(&mut []));
        }
    }
}

/// To the first places, as many as there are.
#[inline(always)]
fn put<Q: Quad>(value: Q, to: &mut [f64]) {
    if to.len() >= 4 {
        value.store(to);
        return;
    }
    let mut values = [0.0; 4];
    value.store(&mut values);
    for (to, value) in to.iter_mut().zip(values) {
        *to = value;
    }
}

/// K(A,k) = s_A u_k + n_k s_A,j g_j, all rows, `apart` places from one to the next; `first`: replaces, else adds.
/// False, and nothing done, where the lengths do not belong together or a row is shorter than the lanes.
#[inline(always)]
pub(super) fn write<T: Wide, const D: usize, const P: usize>(
    nodes: impl ExactSizeIterator<Item = (f64, [f64; P])>,
    n: &[f64; D],
    factors: &Factors<'_, D, P>,
    (to, apart): (&mut [f64], usize),
    first: bool,
) -> bool {
    let unknowns = nodes.len() * D;
    let is_long = |row: &[f64]| row.len() >= unknowns;
    let are_long = factors.u.iter().chain(&factors.g).all(|row| is_long(row));
    let has_room = apart >= unknowns && to.len() >= unknowns * apart;
    if !has_room || !are_long || unknowns < T::WIDTH {
        return false;
    }
    let lanes = n.map(T::constant);
    let whole = if first {
        unknowns
    } else {
        unknowns - unknowns % T::WIDTH
    };
    for ((s, ds), rows) in nodes.zip(to.chunks_exact_mut((D * apart).max(1))) {
        let turns = ds.map(T::constant);
        let s_lanes = T::constant(s);
        for column in (0..whole).step_by(T::WIDTH) {
            // the last lanes of a row that is replaced overlap those before
            let column = column.min(unknowns - T::WIDTH);
            // SAFETY: column + WIDTH ≤ unknowns, all of u and g have as many entries, and so has each of the D rows.
            unsafe {
                let along = along(&turns, &factors.g, column);
                for k in 0..D {
                    let mut value = s_lanes * T::load_at(factors.u[k].as_ptr().add(column));
                    if P > 0 {
                        value = value + lanes[k] * along;
                    }
                    let place = rows.as_mut_ptr().add(k * apart + column);
                    if !first {
                        value = T::load_at(place) + value;
                    }
                    value.store_at(place);
                }
            }
        }
        if !first {
            add_rest(s, &ds, n, factors, (rows, apart, whole..unknowns));
        }
    }
    true
}

/// s_A,j g_j from `column` on.
///
/// # Safety
/// All g_j reach as far as the lanes.
#[inline(always)]
unsafe fn along<T: Wide, const P: usize>(turns: &[T; P], g: &[&[f64]; P], column: usize) -> T {
    let mut sum = T::constant(0.0);
    for j in 0..P {
        // SAFETY: promised by the caller.
        let term = turns[j] * unsafe { T::load_at(g[j].as_ptr().add(column)) };
        sum = if j == 0 { term } else { sum + term };
    }
    sum
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
pub(super) struct Contraction<'a, const D: usize, const P: usize> {
    /// s_A
    pub(super) s: &'a [f64],
    /// s_A,j
    pub(super) ds: [&'a [f64]; P],
    pub(super) n: &'a [f64; D],
    pub(super) p: &'a [[f64; D]; D],
    pub(super) right: [&'a [f64; D]; P],
    pub(super) left: [&'a [f64; D]; P],
    /// s_ij
    pub(super) turn: [[f64; P]; P],
    /// w N ∂J/∂x_B per unknown, where the measure moves.
    pub(super) measure: &'a [f64],
}

impl<const D: usize, const P: usize> Contraction<'_, D, P> {
    /// All rows by lanes T; u and g are scratch.
    #[inline(always)]
    fn write<T: Wide>(
        &self,
        (mut u, mut g): ([&mut [f64]; D], [&mut [f64]; P]),
        to: (&mut [f64], usize),
        first: bool,
    ) -> bool {
        let slope = |j: usize, a: usize| self.ds[j].get(a).copied().unwrap_or(0.0);
        let nodes = self.s.iter().enumerate();
        let shares = nodes.clone().map(|(b, &s)| {
            let (mut right, mut turn) = ([0.0; D], [0.0; P]);
            for j in 0..P {
                let slope = slope(j, b);
                for k in 0..D {
                    let term = slope * self.right[j][k];
                    right[k] = if j == 0 { term } else { right[k] + term };
                }
                for i in 0..P {
                    let term = slope * self.turn[i][j];
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
        let nodes = nodes.map(|(a, &s)| (s, core::array::from_fn(|j| slope(j, a))));
        write::<T, D, P>(nodes, self.n, &factors, to, first)
    }

    /// All rows, where the processor has the lanes for it; false where K was not touched.
    #[inline(always)]
    pub(super) fn write_wide(
        &self,
        scratch: ([&mut [f64]; D], [&mut [f64]; P]),
        to: (&mut [f64], usize),
        first: bool,
    ) -> bool {
        #[cfg(target_arch = "x86_64")]
        if Width::widest() >= Width::Four {
            #[target_feature(enable = "avx2")]
            #[inline(never)]
            fn four<const D: usize, const P: usize>(
                contraction: &Contraction<'_, D, P>,
                scratch: ([&mut [f64]; D], [&mut [f64]; P]),
                to: (&mut [f64], usize),
                first: bool,
            ) -> bool {
                contraction.write::<Four>(scratch, to, first)
            }
            // SAFETY: the processor has AVX2.
            return unsafe { four(self, scratch, to, first) };
        }
        false
    }
}

/// A vector as a quadruple.
#[inline(always)]
fn padded<const D: usize>(v: &[f64; D]) -> [f64; 4] {
    core::array::from_fn(|k| v.get(k).copied().unwrap_or(0.0))
}
