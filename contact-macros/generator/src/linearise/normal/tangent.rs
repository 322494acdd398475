//! Tangent of normal contact: K = N' (n·δr)(n·Δr) + N D²g in covariant closed form. [eq:tangent]
//!
//! With α_i = b_i·δr and β_i = n·δr_,i
//!
//! ```text
//! D²g = −[ α (a⁻¹κm) α + α m β + β m α + L β m β ] + (1/L) Σ_c (c·δr)(c·Δr) ,   m = (a − Lκ)⁻¹
//! ```
//!
//! The program gives the coefficients that the contraction with shape rows needs: `p` multiplies
//! s_A s_B, `right_j` s_A s_B,j (with n on the right), `left_j` s_A,j s_B (with n on the left) and
//! `s` the product s_A,i s_B,j n⊗n.

use crate::ir::{Program, Scalar, Sheet, Symmetric, Vector};
use crate::linearise::shared::basis::{contravariant, orthogonal, sheared};
use crate::linearise::shared::{Kinematics, second_derivatives};
use crate::model::Linearisation;

const ON_TANGENT_PLANE: &str = "linearised on the tangent plane L = 0";
const NO_ROTATION: &str = "the tangents do not rotate with any unknown";

/// Quantities at the projection that the terms share.
struct Point<'a, 's> {
    sheet: &'s Sheet,
    kinematics: &'a Kinematics,
    d: usize,
    p: usize,
    n: Vector<'s>,
    distance: Scalar<'s>,
    /// Orthogonal tangents b_1 and b_2 − t b_1 [eq:orthogonal-basis].
    b: Vec<Vector<'s>>,
    /// t = a_12/a_11; zero for one tangent.
    shear: Scalar<'s>,
    /// Diagonal of the metric in that basis. [eq:metric]
    a: Vec<Scalar<'s>>,
    /// κ_ij = −n·r_,ij in that basis
    kappa: Symmetric<'s>,
    /// m = F⁻¹ (exact) or a⁻¹ (tangent plane) in that basis
    m: Symmetric<'s>,
    traction: Scalar<'s>,
    slope: Scalar<'s>,
}

/// n, L, b_i, r_,ij, N, N' → p, right, left, s.
pub fn tangent_program(kinematics: &Kinematics) -> Program {
    let sheet = Sheet::new("tangent");
    let at = Point::new(&sheet, kinematics);
    let [main, bend, rest] = [main(&at), curvature(&at), complement(&at)];
    let position = Symmetric::new(&sheet, at.d, |kl| main[kl] + bend[kl] + rest[kl]);
    let right = rotational(&at, "13-rotational-right");
    let left = rotational(&at, "13-rotational-left");
    let rotation = quadratic_rotation(&at);

    for (k, l) in (0..at.d).flat_map(|k| (0..at.d).map(move |l| (k, l))) {
        sheet.output(format!("p_{k}_{l}"), position[(k, l)]);
    }
    for (name, vectors) in [("right", &right), ("left", &left)] {
        for (j, vector) in vectors.iter().enumerate() {
            sheet.outputs(&format!("{name}_{j}"), vector);
        }
    }
    for (i, j) in (0..at.p).flat_map(|i| (0..at.p).map(move |j| (i, j))) {
        sheet.output(format!("s_{i}_{j}"), rotation[(i, j)]);
    }
    sheet.finish()
}

impl<'a, 's> Point<'a, 's> {
    fn new(sheet: &'s Sheet, kinematics: &'a Kinematics) -> Self {
        let (d, p) = (kinematics.dimension, kinematics.projected());
        let vectors = |name: &str, count: usize| -> Vec<Vector<'s>> {
            let names = (0..count).map(|i| format!("{name}_{i}"));
            names.map(|name| sheet.input_vector(&name, d)).collect()
        };
        let n = sheet.input_vector("n", d);
        let distance = sheet.input("distance");
        let b = vectors("b", p);
        let second = vectors("r", second_derivatives(p));
        let traction = sheet.input("traction");
        let slope = sheet.input("slope");

        let declared = curvature_tensor(n, &second, kinematics);
        let (b, shear) = orthogonal(sheet, &b);
        let a: Vec<Scalar> = b.iter().map(|b_i| b_i.dot(*b_i)).collect();
        let kappa = sheared(sheet, declared, shear);
        let lever = match kinematics.linearisation {
            Linearisation::Exact => {
                sheet.term("F-curvature", distance, "no curvature along the projection")
            }
            Linearisation::TangentPlane => {
                sheet.left_out("F-curvature", ON_TANGENT_PLANE);
                sheet.zero()
            }
        };
        let m = inverse_of_f(sheet, &a, kappa, lever);
        Self {
            sheet,
            kinematics,
            d,
            p,
            n,
            distance,
            b,
            shear,
            a,
            kappa,
            m,
            traction,
            slope,
        }
    }
}

/// κ_ij = −n·r_,ij [eq:curvature]; entries that vanish identically stay zero.
fn curvature_tensor<'s>(
    n: Vector<'s>,
    second: &[Vector<'s>],
    kinematics: &Kinematics,
) -> Symmetric<'s> {
    let sheet = n[0].sheet();
    let mut entries = second.iter().zip(&kinematics.curved);
    Symmetric::new(sheet, kinematics.projected(), |_| match entries.next() {
        Some((&r_ij, true)) => -n.dot(r_ij),
        _ => sheet.zero(),
    })
}

/// m = F⁻¹ with F = a − Lκ [eq:F]; a is diagonal, so det F loses nothing to cancellation of a.
fn inverse_of_f<'s>(
    sheet: &'s Sheet,
    a: &[Scalar<'s>],
    kappa: Symmetric<'s>,
    distance: Scalar<'s>,
) -> Symmetric<'s> {
    let one = sheet.one();
    let diagonal: Vec<Scalar> = (0..a.len())
        .map(|i| a[i] - distance * kappa[(i, i)])
        .collect();
    let f = Symmetric::new(sheet, a.len(), |(i, j)| match i == j {
        true => diagonal[i],
        false => -(distance * kappa[(i, j)]),
    });
    f.inverse(one)
}

/// N' (n·δr)(n·Δr) [eq:12-main]
fn main<'s>(at: &Point<'_, 's>) -> Symmetric<'s> {
    let c = at.sheet.term("12-main", at.slope, "");
    Symmetric::new(at.sheet, at.d, |(k, l)| c * (at.n[k] * at.n[l]))
}

/// −N α_i (a⁻¹κm)^ij α_j [eq:13-curvature]
fn curvature<'s>(at: &Point<'_, 's>) -> Symmetric<'s> {
    let c = at.sheet.term(
        "13-curvature",
        -at.traction,
        "no curvature along the projection",
    );
    let tensor = Symmetric::new(at.sheet, at.p, |(i, j)| {
        c / at.a[i] * at.sheet.sum(0..at.p, |k| at.kappa[(i, k)] * at.m[(k, j)])
    });
    tensor.sandwich(at.sheet, &at.b, at.d)
}

/// (N/L) Σ_c c⊗c with Σ_c c⊗c = I − n⊗n − b_i a^ij b_j [eq:complement]; zero in codimension one.
fn complement<'s>(at: &Point<'_, 's>) -> Symmetric<'s> {
    let sheet = at.sheet;
    if at.kinematics.complement() == 0 {
        sheet.left_out("complement", "codimension one: no direction is left over");
        return Symmetric::new(sheet, at.d, |_| sheet.zero());
    }
    let c = sheet.term("complement", at.traction / at.distance, "");
    let one = sheet.one();
    let inverse = Symmetric::new(sheet, at.p, |(i, j)| match i == j {
        true => one / at.a[i],
        false => sheet.zero(),
    });
    let tangential = inverse.sandwich(sheet, &at.b, at.d);
    Symmetric::new(sheet, at.d, |(k, l)| {
        let identity = sheet.constant(if k == l { 1.0 } else { 0.0 });
        c * (identity - at.n[k] * at.n[l] - tangential[(k, l)])
    })
}

/// −N α_i m^ij β_j (right) or −N β_i m^ij α_j (left) [eq:13-rotational-right] [eq:13-rotational-left]:
/// one vector −N m^ij b_i for each moving parameter j.
fn rotational<'s>(at: &Point<'_, 's>, tag: &'static str) -> Vec<Vector<'s>> {
    let c = at.sheet.term(tag, -at.traction, NO_ROTATION);
    let mut vectors: Vec<Vector> = (0..at.p)
        .map(|j| {
            at.sheet
                .sum_vectors(at.d, 0..at.p, |i| c * at.m[(i, j)] * at.b[i])
        })
        .collect();
    if let [first, second] = &mut vectors[..] {
        // s_,2 of the orthogonal basis is s_,2 − t s_,1
        *first = *first - at.shear * *second;
    }
    for (vector, &moving) in vectors.iter_mut().zip(&at.kinematics.moving) {
        if !moving {
            *vector = at.sheet.zeros(at.d);
        }
    }
    vectors
}

/// −N L β_i m^ij β_j [eq:quadratic-rotation]: absent on the tangent plane.
fn quadratic_rotation<'s>(at: &Point<'_, 's>) -> Symmetric<'s> {
    let sheet = at.sheet;
    if at.kinematics.linearisation == Linearisation::TangentPlane {
        sheet.left_out("quadratic-rotation", ON_TANGENT_PLANE);
        return Symmetric::new(sheet, at.p, |_| sheet.zero());
    }
    let c = sheet.term(
        "quadratic-rotation",
        -(at.traction * at.distance),
        NO_ROTATION,
    );
    let tensor = contravariant(sheet, at.m.map(|m| c * m), at.shear);
    let moving = &at.kinematics.moving;
    Symmetric::new(sheet, at.p, |(i, j)| match moving[i] && moving[j] {
        true => tensor[(i, j)],
        false => sheet.zero(),
    })
}
