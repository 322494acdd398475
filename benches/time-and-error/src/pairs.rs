//! The pairs once more, as somebody writes them who leaves derivatives to a tool: shape functions, closest point,
//! energy and residual in any numbers.

use num_dual::DualNum;

/// Numbers with any derivatives.
pub trait Number: DualNum<Primitive = f64> + Copy {}
impl<T: DualNum<Primitive = f64> + Copy> Number for T {}

/// Shape functions of both sides, the master's negative, and their derivatives.
pub struct Rows<D, const N: usize> {
    /// s_A.
    pub s: [D; N],
    /// s_A,i.
    pub ds: [[D; N]; 2],
}

/// A pair of N nodes with two projected parameters.
pub trait Pair<const N: usize>: Copy {
    /// Signed gap or distance.
    const SIGNED: bool;
    /// At any parameters.
    fn rows<D: Number>(z: [D; 2]) -> Rows<D, N>;
    /// s_A,11, s_A,12, s_A,22.
    fn second(z: [f64; 2]) -> [[f64; N]; 3];
}

/// Point on a bilinear facet.
#[derive(Clone, Copy)]
pub struct PointQuad4;
/// Point on a biquadratic facet.
#[derive(Clone, Copy)]
pub struct PointQuad9;
/// Two straight beams.
#[derive(Clone, Copy)]
pub struct Line2Line2Beams;

/// Polynomials of both directions by node.
const BILINEAR: [(usize, usize); 4] = [(0, 0), (1, 0), (1, 1), (0, 1)];
const BIQUADRATIC: [(usize, usize); 9] = [
    (0, 0),
    (1, 0),
    (1, 1),
    (0, 1),
    (2, 0),
    (1, 2),
    (2, 1),
    (0, 2),
    (2, 2),
];

/// Values and first derivatives of the linear polynomials.
fn linear<D: Number>(z: D) -> [[D; 2]; 2] {
    let half = D::from(0.5);
    [[(-z + 1.0) * 0.5, (z + 1.0) * 0.5], [-half, half]]
}

/// Values and first derivatives of the quadratic polynomials at -1, 1, 0.
fn quadratic<D: Number>(z: D) -> [[D; 3]; 2] {
    [
        [z * (z - 1.0) * 0.5, z * (z + 1.0) * 0.5, -z * z + 1.0],
        [z - 0.5, z + 0.5, z * -2.0],
    ]
}

/// Rows of a point (first) and a facet of products of polynomials.
fn product<D: Number, const M: usize, const N: usize>(
    a: [[D; M]; 2],
    b: [[D; M]; 2],
    nodes: &[(usize, usize)],
) -> Rows<D, N> {
    let row = |first: f64, da: usize, db: usize| {
        let mut row = [D::from(first); N];
        for (entry, &(i, j)) in row[1..].iter_mut().zip(nodes) {
            *entry = -(a[da][i] * b[db][j]);
        }
        row
    };
    Rows {
        s: row(1.0, 0, 0),
        ds: [row(0.0, 1, 0), row(0.0, 0, 1)],
    }
}

impl Pair<5> for PointQuad4 {
    const SIGNED: bool = true;

    fn rows<D: Number>(z: [D; 2]) -> Rows<D, 5> {
        product(linear(z[0]), linear(z[1]), &BILINEAR)
    }

    fn second(_: [f64; 2]) -> [[f64; 5]; 3] {
        let mixed = [0.0, -0.25, 0.25, -0.25, 0.25];
        [[0.0; 5], mixed, [0.0; 5]]
    }
}

impl Pair<10> for PointQuad9 {
    const SIGNED: bool = true;

    fn rows<D: Number>(z: [D; 2]) -> Rows<D, 10> {
        product(quadratic(z[0]), quadratic(z[1]), &BIQUADRATIC)
    }

    fn second(z: [f64; 2]) -> [[f64; 10]; 3] {
        let [a, b] = z.map(quadratic);
        let bend = [1.0, 1.0, -2.0];
        let mut rows = [[0.0; 10]; 3];
        for (at, (i, j)) in BIQUADRATIC.into_iter().enumerate() {
            rows[0][at + 1] = -bend[i] * b[0][j];
            rows[1][at + 1] = -a[1][i] * b[1][j];
            rows[2][at + 1] = -a[0][i] * bend[j];
        }
        rows
    }
}

impl Pair<4> for Line2Line2Beams {
    const SIGNED: bool = false;

    fn rows<D: Number>(z: [D; 2]) -> Rows<D, 4> {
        let [a, b] = z.map(linear);
        let zero = D::zero();
        Rows {
            s: [a[0][0], a[0][1], -b[0][0], -b[0][1]],
            ds: [
                [a[1][0], a[1][1], zero, zero],
                [zero, zero, -b[1][0], -b[1][1]],
            ],
        }
    }

    fn second(_: [f64; 2]) -> [[f64; 4]; 3] {
        [[0.0; 4]; 3]
    }
}

/// Numbers of a state beside its nodes.
#[derive(Clone, Copy, Debug)]
pub struct Law {
    /// Penalty.
    pub eps_n: f64,
    /// Offset.
    pub r0: f64,
    /// Side of a signed gap.
    pub orientation: f64,
}

fn dot<D: Number>(a: [D; 3], b: [D; 3]) -> D {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn sum<D: Number, const N: usize>(row: &[D; N], x: &[[D; 3]; N]) -> [D; 3] {
    let mut total = [D::zero(); 3];
    for (s, x) in row.iter().zip(x) {
        for (total, x) in total.iter_mut().zip(x) {
            *total += *x * *s;
        }
    }
    total
}

/// The same with plain coefficients: no derivative is multiplied with zeros.
fn plain_sum<D: Number, const N: usize>(row: &[f64; N], x: &[[D; 3]; N]) -> [D; 3] {
    let mut total = [D::zero(); 3];
    for (s, x) in row.iter().zip(x) {
        for (total, x) in total.iter_mut().zip(x) {
            *total += *x * *s;
        }
    }
    total
}

/// One Newton step of f_i = r·r_,i = 0 from `z`: exact to first order in whatever the nodes depend on, and so is the
/// energy to second order, being stationary.
fn step<P: Pair<N>, D: Number, const N: usize>(x: &[[D; 3]; N], z: [f64; 2]) -> [D; 2] {
    let rows = P::rows(z);
    let r = plain_sum(&rows.s, x);
    let b = rows.ds.map(|row| plain_sum(&row, x));
    let plain = |v: [D; 3]| v.map(|v| v.re());
    let nodes = x.map(plain);
    let second = P::second(z).map(|row| plain_sum(&row, &nodes));
    let (r0, b0) = (plain(r), b.map(plain));
    let f = |i: usize, j: usize| dot(b0[i], b0[j]) + dot(r0, second[i + j]);
    let (f11, f12, f22) = (f(0, 0), f(0, 1), f(1, 1));
    let scale = 1.0 / (f11 * f22 - f12 * f12);
    let slope = b.map(|b| dot(r, b));
    [
        (slope[1] * f12 - slope[0] * f22) * scale + z[0],
        (slope[0] * f12 - slope[1] * f11) * scale + z[1],
    ]
}

/// Iterates of Newton's method, the start first.
pub fn iterates<P: Pair<N>, const N: usize>(
    x: &[[f64; 3]; N],
    start: [f64; 2],
    steps: usize,
) -> Vec<[f64; 2]> {
    let next = |z: &[f64; 2]| Some(step::<P, f64, N>(x, *z));
    std::iter::successors(Some(start), next)
        .take(steps + 1)
        .collect()
}

/// Closest point to rounding: after a step this small the next one is below it.
pub fn project<P: Pair<N>, const N: usize>(x: &[[f64; 3]; N], start: [f64; 2]) -> [f64; 2] {
    const SETTLED: f64 = 1e-8;
    const STEPS: usize = 30;
    let mut z = start;
    for _ in 0..STEPS {
        let next = step::<P, f64, N>(x, z);
        let size = (next[0] - z[0]).abs().max((next[1] - z[1]).abs());
        z = next;
        if size < SETTLED {
            break;
        }
    }
    z
}

/// Rows, normal and gap at the projection, which `z` is in plain numbers.
fn contact<P: Pair<N>, D: Number, const N: usize>(
    x: &[[D; 3]; N],
    z: [f64; 2],
    law: &Law,
) -> ([D; N], [D; 3], D) {
    let rows = P::rows(step::<P, D, N>(x, z));
    let r = sum(&rows.s, x);
    let (n, length) = if P::SIGNED {
        let [a, b] = rows.ds.map(|row| sum(&row, x));
        let across = [
            a[1] * b[2] - a[2] * b[1],
            a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0],
        ];
        let scale = dot(across, across).sqrt().recip() * law.orientation;
        let n = across.map(|c| c * scale);
        (n, dot(r, n))
    } else {
        let length = dot(r, r).sqrt();
        let scale = length.recip();
        (r.map(|c| c * scale), length)
    };
    (rows.s, n, length - law.r0)
}

/// ½ ε g².
pub fn energy<P: Pair<N>, D: Number, const N: usize>(x: &[[D; 3]; N], z: [f64; 2], law: &Law) -> D {
    let (_, _, gap) = contact::<P, D, N>(x, z, law);
    gap * gap * (0.5 * law.eps_n)
}

/// N n s_A.
pub fn residual<P: Pair<N>, D: Number, const N: usize>(
    x: &[[D; 3]; N],
    z: [f64; 2],
    law: &Law,
) -> [[D; 3]; N] {
    let (s, n, gap) = contact::<P, D, N>(x, z, law);
    let force = gap * law.eps_n;
    s.map(|s| {
        let share = force * s;
        n.map(|n| n * share)
    })
}
