//! The polynomial families, each from its defining property rather than from a table.

use crate::oracle::number::Number;

/// Lagrange polynomials: product over the other points of `(t - t_b) / (t_a - t_b)`.
#[inline]
pub(super) fn lagrange<D: Number, const N: usize>(points: [f64; N], t: D) -> [D; N] {
    std::array::from_fn(|a| {
        let factor = |b: usize| (t - points[b]) * (1.0 / (points[a] - points[b]));
        let others = (0..N).filter(|&b| b != a);
        others
            .map(factor)
            .reduce(|product, next| product * next)
            .unwrap_or(D::one())
    })
}

/// Highest Bernstein degree supported.
pub(super) const MAX_DEGREE: usize = 4;

/// Bernstein polynomials by de Casteljau's recursion; entries above `degree` are zero.
#[inline]
pub(super) fn bernstein<D: Number>(degree: usize, t: D) -> [D; MAX_DEGREE + 1] {
    let mut row = [D::zero(); MAX_DEGREE + 1];
    let rest = -t + 1.0;
    row[0] = D::one();
    for level in 1..=degree.min(MAX_DEGREE) {
        let mut carried = D::zero();
        for entry in row.iter_mut().take(level) {
            let old = *entry;
            *entry = old * rest + carried;
            carried = old * t;
        }
        row[level] = carried;
    }
    row
}

/// Area coordinates of the triangle (0,0), (1,0), (0,1): the area of the part opposite to each
/// corner over the area of the whole, by determinants.
#[inline]
pub(super) fn area_coordinates<D: Number>(z: [D; 2]) -> [D; 3] {
    const CORNERS: [[f64; 2]; 3] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    let part = |a: usize| {
        let (p, q) = (CORNERS[(a + 1) % 3], CORNERS[(a + 2) % 3]);
        (-z[0] + p[0]) * (-z[1] + q[1]) - (-z[0] + q[0]) * (-z[1] + p[1])
    };
    [part(0), part(1), part(2)]
}

/// Silvester's polynomial of order `k` for degree `degree` in an area coordinate: vanishes on the
/// lines `l = j / degree`, `j < k`, and is one on `l = k / degree`.
#[inline]
fn silvester<D: Number>(degree: usize, k: usize, l: D) -> D {
    let factor = |j: usize| (l * degree as f64 - j as f64) * (1.0 / (k - j) as f64);
    (0..k)
        .map(factor)
        .reduce(|product, next| product * next)
        .unwrap_or(D::one())
}

/// Quadratic triangle: node `(k_0, k_1, k_2) / 2` in area coordinates has `Π_a P_{k_a}(l_a)`.
#[inline]
pub(super) fn triangle_quadratic<D: Number>(z: [D; 2], out: &mut [D]) {
    const INDICES: [[usize; 3]; 6] = [
        [2, 0, 0],
        [0, 2, 0],
        [0, 0, 2],
        [1, 1, 0],
        [0, 1, 1],
        [1, 0, 1],
    ];
    let l = area_coordinates(z);
    for (entry, k) in out.iter_mut().zip(INDICES) {
        *entry = silvester(2, k[0], l[0]) * silvester(2, k[1], l[1]) * silvester(2, k[2], l[2]);
    }
}

/// Cubic Hermite curve on [-1, 1] as a Bezier curve: the inner control points lie on the end
/// tangents, a third of the parameter length (2/3) away from the ends.
#[inline]
pub(super) fn hermite<D: Number>(t: D) -> [D; 4] {
    let b = bernstein(3, (t + 1.0) * 0.5);
    // a quotient of full precision, not a product with a rounded 2/3: numbers of more digits come here as well
    let third = D::from(2.0) / D::from(3.0);
    let inner = |b: D| b * third;
    [b[0] + b[1], inner(b[1]), b[2] + b[3], -inner(b[2])]
}
