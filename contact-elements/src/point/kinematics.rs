//! The one relative position vector r = Σ s_A x_A of every pair, with its derivatives. [eq:1-relative]
//!
//! Each function fills the rows s_A, s_A,i of the nodes it owns and gives r, b_i, r_,ij.
//! x: positions relative to a local origin, slave nodes first.

use crate::lanes::Real;
use crate::point::shape::{Rigid, Shape};
use crate::point::values::{Measure, Rows, Vectors};

/// Σ_slave s_A x_A: position of the slave's point; the master nodes are the last `masters`.
#[inline(always)]
pub fn slave_point<const D: usize, T: Real>(x: &[[T; D]], s: &[T], masters: usize) -> [T; D] {
    let mut r = [T::constant(0.0); D];
    let slaves = x.len().saturating_sub(masters);
    for (x, &s) in x.iter().zip(s.iter()).take(slaves) {
        for k in 0..D {
            r[k] = r[k] + s * x[k];
        }
    }
    r
}

/// Master is one node.
#[inline(always)]
pub fn onto_point<const D: usize, T: Real>(
    x: &[[T; D]],
    rows: &mut Rows<'_, 0, T>,
) -> Vectors<D, 0, 0, T> {
    let mut vectors = Vectors {
        r: slave_point(x, rows.s, 1),
        ..Vectors::default()
    };
    if let (Some(x), Some(s)) = (x.last(), rows.s.last_mut()) {
        *s = T::constant(-1.0);
        for k in 0..D {
            vectors.r[k] = vectors.r[k] - x[k];
        }
    }
    vectors
}

/// Master is a curve or surface of N nodes, r = x_slave − Σ N_A(ζ) x_A.
#[inline(always)]
pub fn onto_shape<
    G: Shape<P, H, N>,
    const D: usize,
    const P: usize,
    const H: usize,
    const N: usize,
    T: Real,
>(
    x: &[[T; D]],
    zeta: &[T; P],
    weights: &[T],
    rows: &mut Rows<'_, P, T>,
) -> Vectors<D, P, H, T> {
    let mut vectors = Vectors {
        r: slave_point(x, rows.s, N),
        ..Vectors::default()
    };
    let shape = G::rows(zeta, weights);
    let (Some(x), Some(s)) = (x.last_chunk::<N>(), rows.s.last_chunk_mut::<N>()) else {
        return vectors;
    };
    *s = negated(&shape.n);
    add_position(&mut vectors.r, s, x);
    for i in 0..P {
        let row = negated(&shape.d1[i]);
        vectors.b[i] = combination(&row, x);
        if let Some(ds) = rows.ds[i].last_chunk_mut::<N>() {
            *ds = row;
        }
    }
    for h in 0..H {
        if G::CURVED[h] {
            vectors.second[h] = combination(&negated(&shape.d2[h]), x);
        }
    }
    vectors
}

/// True for a row that a geometry gives as zeros: a constant, so that the compiler leaves the sum out, or
/// one comparison.
#[inline(always)]
fn vanishes<const N: usize>(row: &[f64; N]) -> bool {
    row.iter().all(|&value| value == 0.0)
}

/// −N_A
#[inline(always)]
fn negated<const N: usize, T: Real>(row: &[T; N]) -> [T; N] {
    row.map(|value| -value)
}

/// Σ N_A x_A in two halves, even and odd A: half the latency of one long sum.
#[inline(always)]
fn combination<const D: usize, const N: usize, T: Real>(row: &[T; N], x: &[[T; D]; N]) -> [T; D] {
    let term = |a: usize, k: usize| row[a] * x[a][k];
    let mut sum = [T::constant(0.0); D];
    for k in 0..D {
        sum[k] = term(0, k);
        if N > 1 {
            let (mut even, mut odd) = (sum[k], term(1, k));
            for a in 2..N {
                if a % 2 == 0 {
                    even = even + term(a, k);
                } else {
                    odd = odd + term(a, k);
                }
            }
            sum[k] = even + odd;
        }
    }
    sum
}

/// v += Σ N_A x_A
#[inline(always)]
fn add_position<const D: usize, const N: usize, T: Real>(
    v: &mut [T; D],
    row: &[T; N],
    x: &[[T; D]; N],
) {
    let sum = combination(row, x);
    for k in 0..D {
        v[k] = v[k] + sum[k];
    }
}

/// Master is a rigid curve or surface, r = x_slave − ρ(ζ). [eq:rigid]
#[inline(always)]
pub fn onto_rigid<G: Rigid<D, P, H>, const D: usize, const P: usize, const H: usize, T: Real>(
    x: &[[T; D]],
    zeta: &[T; P],
    parameters: &[T],
    rows: &mut Rows<'_, P, T>,
) -> Vectors<D, P, H, T> {
    let mut vectors = G::position(zeta, parameters);
    let slave = slave_point(x, rows.s, 0);
    for k in 0..D {
        vectors.r[k] = slave[k] - vectors.r[k];
        for b in &mut vectors.b {
            b[k] = -b[k];
        }
        for second in &mut vectors.second {
            second[k] = -second[k];
        }
    }
    vectors
}

/// Both parameters are projected: r = Σ N_A(ξ_slave) x_A − Σ N_B(ξ_master) x_B, r_,12 = 0. [eq:two-curves]
#[inline(always)]
pub fn curve_to_curve<
    S: Shape<1, 1, NS>,
    M: Shape<1, 1, NM>,
    const D: usize,
    const NS: usize,
    const NM: usize,
    T: Real,
>(
    x: &[[T; D]],
    zeta: &[T; 2],
    (slave_weights, master_weights): (&[T], &[T]),
    rows: &mut Rows<'_, 2, T>,
) -> Vectors<D, 2, 3, T> {
    let mut vectors = Vectors::default();
    let slave = S::rows(&[zeta[0]], slave_weights);
    let master = M::rows(&[zeta[1]], master_weights);
    let (Some(xs), Some(xm)) = (x.first_chunk::<NS>(), x.last_chunk::<NM>()) else {
        return vectors;
    };
    let (n, d1) = (negated(&master.n), negated(&master.d1[0]));
    vectors.r = combination(&slave.n, xs);
    add_position(&mut vectors.r, &n, xm);
    vectors.b = [combination(&slave.d1[0], xs), combination(&d1, xm)];
    if S::CURVED[0] {
        vectors.second[0] = combination(&slave.d2[0], xs);
    }
    if M::CURVED[0] {
        vectors.second[2] = combination(&negated(&master.d2[0]), xm);
    }
    if let Some(s) = rows.s.first_chunk_mut::<NS>() {
        *s = slave.n;
    }
    if let Some(ds) = rows.ds[0].first_chunk_mut::<NS>() {
        *ds = slave.d1[0];
    }
    if let Some(s) = rows.s.last_chunk_mut::<NM>() {
        *s = n;
    }
    if let Some(ds) = rows.ds[1].last_chunk_mut::<NM>() {
        *ds = d1;
    }
    vectors
}

/// Both parameters are projected, the master curve is rigid.
#[inline(always)]
pub fn curve_to_rigid<
    S: Shape<1, 1, NS>,
    M: Rigid<D, 1, 1>,
    const D: usize,
    const NS: usize,
    T: Real,
>(
    x: &[[T; D]],
    zeta: &[T; 2],
    (slave_weights, parameters): (&[T], &[T]),
    rows: &mut Rows<'_, 2, T>,
) -> Vectors<D, 2, 3, T> {
    let mut vectors = Vectors::default();
    let slave = S::rows(&[zeta[0]], slave_weights);
    let master = M::position(&[zeta[1]], parameters);
    let Some(xs) = x.first_chunk::<NS>() else {
        return vectors;
    };
    vectors.r = combination(&slave.n, xs);
    vectors.b[0] = combination(&slave.d1[0], xs);
    if S::CURVED[0] {
        vectors.second[0] = combination(&slave.d2[0], xs);
    }
    for k in 0..D {
        vectors.r[k] = vectors.r[k] - master.r[k];
        vectors.b[1][k] = -master.b[0][k];
        vectors.second[2][k] = -master.second[0][k];
    }
    if let (Some(s), Some(ds)) = (
        rows.s.first_chunk_mut::<NS>(),
        rows.ds[0].first_chunk_mut::<NS>(),
    ) {
        *s = slave.n;
        *ds = slave.d1[0];
    }
    vectors
}

/// r_,ijk of [`onto_shape`]; fills the rows s_A,ij of the master.
#[inline(always)]
pub fn onto_shape_higher<
    G: Shape<P, H, N>,
    const D: usize,
    const P: usize,
    const H: usize,
    const N: usize,
>(
    x: &[[f64; D]],
    zeta: &[f64; P],
    weights: &[f64],
    second: &mut [&mut [f64]; H],
) -> [[f64; D]; 4] {
    let mut third = [[0.0; D]; 4];
    let rows = G::rows(zeta, weights);
    for h in 0..H {
        if let Some(to) = second[h].last_chunk_mut::<N>() {
            *to = negated(&rows.d2[h]);
        }
    }
    if let Some(x) = x.last_chunk::<N>() {
        for (to, row) in third.iter_mut().zip(&G::third(zeta, weights)) {
            if !vanishes(row) {
                *to = combination(&negated(row), x);
            }
        }
    }
    third
}

/// r_,ijk of [`onto_rigid`].
#[inline(always)]
pub fn onto_rigid_higher<G: Rigid<D, P, H>, const D: usize, const P: usize, const H: usize>(
    zeta: &[f64; P],
    parameters: &[f64],
) -> [[f64; D]; 4] {
    G::third(zeta, parameters).map(|vector| vector.map(|value| -value))
}

/// r_,ijk of [`curve_to_curve`]; fills the rows s_A,11 of the slave and s_A,22 of the master.
#[inline(always)]
pub fn curve_to_curve_higher<
    S: Shape<1, 1, NS>,
    M: Shape<1, 1, NM>,
    const D: usize,
    const NS: usize,
    const NM: usize,
>(
    x: &[[f64; D]],
    zeta: &[f64; 2],
    (slave_weights, master_weights): (&[f64], &[f64]),
    second: &mut [&mut [f64]; 3],
) -> [[f64; D]; 4] {
    let mut third = [[0.0; D]; 4];
    let slave = S::rows(&[zeta[0]], slave_weights);
    let master = M::rows(&[zeta[1]], master_weights);
    if let Some(to) = second[0].first_chunk_mut::<NS>() {
        *to = slave.d2[0];
    }
    if let Some(to) = second[2].last_chunk_mut::<NM>() {
        *to = negated(&master.d2[0]);
    }
    if let (Some(xs), Some(xm)) = (x.first_chunk::<NS>(), x.last_chunk::<NM>()) {
        third[0] = combination(&S::third(&[zeta[0]], slave_weights)[0], xs);
        third[3] = combination(&negated(&M::third(&[zeta[1]], master_weights)[0]), xm);
    }
    third
}

/// Fills the rows s_A,111 of the slave and s_A,222 of the master; zero elsewhere on entry.
#[inline(always)]
pub fn curve_to_curve_third<
    S: Shape<1, 1, NS>,
    M: Shape<1, 1, NM>,
    const NS: usize,
    const NM: usize,
>(
    zeta: &[f64; 2],
    rows: &mut [&mut [f64]; 2],
) {
    if let Some(to) = rows[0].first_chunk_mut::<NS>() {
        *to = S::third(&[zeta[0]], &[])[0];
    }
    if let Some(to) = rows[1].last_chunk_mut::<NM>() {
        *to = negated(&M::third(&[zeta[1]], &[])[0]);
    }
}

/// r_,ijk of [`curve_to_rigid`]; fills the row s_A,11 of the slave.
#[inline(always)]
pub fn curve_to_rigid_higher<
    S: Shape<1, 1, NS>,
    M: Rigid<D, 1, 1>,
    const D: usize,
    const NS: usize,
>(
    x: &[[f64; D]],
    zeta: &[f64; 2],
    (slave_weights, parameters): (&[f64], &[f64]),
    second: &mut [&mut [f64]; 3],
) -> [[f64; D]; 4] {
    let mut third = [[0.0; D]; 4];
    let slave = S::rows(&[zeta[0]], slave_weights);
    if let Some(to) = second[0].first_chunk_mut::<NS>() {
        *to = slave.d2[0];
    }
    if let Some(xs) = x.first_chunk::<NS>() {
        third[0] = combination(&S::third(&[zeta[0]], slave_weights)[0], xs);
    }
    third[3] = M::third(&[zeta[1]], parameters)[0].map(|value| -value);
    third
}

/// t_i = Σ N_A,i x_A: tangents of the slave at an integration point.
#[inline(always)]
pub fn slave_tangents<const D: usize, const P: usize, const N: usize>(
    slopes: &[[f64; N]; P],
    x: &[[f64; D]],
) -> [[f64; D]; P] {
    let mut t = [[0.0; D]; P];
    if let Some(x) = x.first_chunk::<N>() {
        for i in 0..P {
            add_position(&mut t[i], &slopes[i], x);
        }
    }
    t
}

/// Σ_i N_A,i w ∂J/∂t_i per unknown of the slave. [eq:measure]
#[inline(always)]
pub fn spread_variation<const D: usize, const P: usize, const N: usize>(
    slopes: &[[f64; N]; P],
    measure: &Measure<D>,
    variation: &mut [f64],
) {
    let (blocks, _) = variation.as_chunks_mut::<D>();
    for (a, block) in blocks.iter_mut().take(N).enumerate() {
        for k in 0..D {
            block[k] = 0.0;
            for i in 0..P {
                block[k] += slopes[i][a] * measure.variation[i][k];
            }
        }
    }
}
