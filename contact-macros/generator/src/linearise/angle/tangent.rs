//! Tangent of contact weighted by the angle, beyond w (N' δg Δg + N D²g). [eq:angle-tangent]
//!
//! ```text
//! K    = w' N (δg Δq + δq Δg) + W w'' δq Δq + W w' D²q ,   D²q = −2 δc Δc − 2c D²c
//! D²c  = Σ_c [ a_c·D²u_c/|u_c| − T_c⊙A_c − c x_c·x_c ] + x_1⊙x_2
//! D²u_c = δr_,cc⊙δζ^c + r_,ccc δζ^c Δζ^c + r_,cc D²ζ^c
//! ```
//!
//! U_c = Du_c/|u_c|, T_c = τ_c·U_c, A_c = a_c·U_c, x_c = U_c − τ_c T_c, A⊙B = A⊗B + B⊗A. The program gives pairs A, B of A⊙B.

use super::pair::{Bends, NO_CURVATURE, Pair};
use crate::ir::{Program, Scalar, Sheet, Vector};
use crate::linearise::rolling::form::Motion;

const NO_THIRD: &str = "no projected curve has a third derivative";

/// A and B of A⊙B.
type Product<'s> = [Motion<'s>; 2];

/// Number of pairs with `p` projected parameters.
pub const fn pairs(p: usize) -> usize {
    10 + p
}

/// The contact point, N, W, w', w'' → pairs A, B of A⊙B. [eq:angle-tangent]
pub fn tangent_program(bends: &Bends) -> Program {
    let sheet = Sheet::new("angle_tangent");
    write(&sheet, bends);
    sheet.finish()
}

fn write(sheet: &Sheet, bends: &Bends) {
    let pair = Pair::new(sheet, bends, true);
    let weight = Weight {
        slope: sheet.input("weight_slope"),
        energy: sheet.input("energy"),
        curvature: sheet.input("weight_curvature"),
        traction: sheet.input("traction"),
    };
    let lever = pair.by_cosine(weight.energy * weight.slope);
    let turns = [0, 1].map(|c| Turn::new(&pair, c));
    let mut products = vec![main(&pair, &turns, &weight)];
    // −½ c e: A⊙A is 2 A⊗A
    let own = -0.5 * pair.cosine * lever;
    let slave = sheet.term("angle-slave-turn", own, "");
    let master = sheet.term("angle-master-turn", own, "");
    products.extend(stretch(&turns, lever, slave));
    products.extend(turn(&turns, lever, [slave, master]));
    products.extend(second_variation(&pair, lever));
    for (k, [left, right]) in products.iter().enumerate() {
        left.output_lower(sheet, &format!("left_{k}"));
        right.output_lower(sheet, &format!("right_{k}"));
    }
}

/// N, W, w', w''
struct Weight<'s> {
    slope: Scalar<'s>,
    energy: Scalar<'s>,
    curvature: Scalar<'s>,
    traction: Scalar<'s>,
}

/// Forms of the total variation of one unit tangent.
struct Turn<'s> {
    /// T_c
    along: Motion<'s>,
    /// A_c
    across: Motion<'s>,
    /// n·x_c and (n×τ_2)·x_c; the rest of x_1 is A_1 τ_2, x_2 has no more.
    sideways: [Motion<'s>; 2],
}

impl<'s> Turn<'s> {
    fn new(pair: &Pair<'s>, c: usize) -> Self {
        let sheet = pair.sheet;
        let curve = &pair.curves[c];
        // a·Du_c/|u_c|
        let of = |a: Vector<'s>| {
            let mut form = Motion::zero(sheet);
            form.turning[c] = curve.inverse * a;
            form.plus(a.dot(curve.second) * curve.inverse, &curve.shift)
        };
        let along = of(curve.tau);
        let across = of(curve.across);
        let axes = [pair.n, pair.n.cross(pair.curves[1].tau)];
        let sideways = axes.map(|axis| of(axis - axis.dot(curve.tau) * curve.tau));
        Self {
            along,
            across,
            sideways,
        }
    }
}

/// δc ⊙ (−2c w' N δg + 2c² W w'' Δc − W w' Δc), δc = A_1 + A_2 [eq:angle-force] [eq:angle-bend] [eq:angle-square]
fn main<'s>(pair: &Pair<'s>, turns: &[Turn<'s>; 2], weight: &Weight<'s>) -> Product<'s> {
    let sheet = pair.sheet;
    let cosine = turns[0].across.plus(sheet.one(), &turns[1].across);
    let force = pair.by_cosine(weight.traction * weight.slope);
    let bend = pair.by_cosine(weight.energy * weight.curvature);
    let bend = -pair.cosine * bend;
    let square = -(weight.energy * weight.slope);
    let force = sheet.term("angle-force", force, "");
    let bend = sheet.term("angle-bend", bend, "");
    let square = sheet.term("angle-square", square, "");
    let mut right = cosine.scaled(bend + square);
    right.position = right.position + force * pair.n;
    [cosine, right]
}

/// −e A_c⊙T_c, and what of −e c x_1·x_1 lies along τ_2: −e c A_1⊗A_1. [eq:angle-stretch] [eq:angle-slave-turn]
fn stretch<'s>(turns: &[Turn<'s>; 2], lever: Scalar<'s>, own: Scalar<'s>) -> [Product<'s>; 2] {
    let c = lever.sheet().term("angle-stretch", -lever, "");
    let [first, last] = turns;
    [
        [first.across, first.along.scaled(c).plus(own, &first.across)],
        [last.across, last.along.scaled(c)],
    ]
}

/// e (x_1⊙x_2 − c x_1·x_1 − c x_2·x_2) along n and n×τ_2. [eq:angle-slave-turn] [eq:angle-master-turn]
/// [eq:angle-mutual-turn]
fn turn<'s>(
    turns: &[Turn<'s>; 2],
    lever: Scalar<'s>,
    [slave, master]: [Scalar<'s>; 2],
) -> Vec<Product<'s>> {
    let mutual = lever.sheet().term("angle-mutual-turn", lever, "");
    let products = (0..2).flat_map(|axis| {
        let [first, last] = [0, 1].map(|c| turns[c].sideways[axis]);
        [
            [first, last.scaled(mutual).plus(slave, &first)],
            [last, last.scaled(master)],
        ]
    });
    products.collect()
}

/// e a_c·D²u_c/|u_c|: the part with δζ^c, and the part of D²ζ^c without it.
fn second_variation<'s>(pair: &Pair<'s>, lever: Scalar<'s>) -> Vec<Product<'s>> {
    let sheet = pair.sheet;
    let transport = sheet.term("angle-transport", lever, NO_CURVATURE);
    let third = sheet.term("angle-third", lever, NO_THIRD);
    let shift = sheet.term("angle-shift", lever, NO_CURVATURE);
    let half = sheet.constant(0.5);
    let (mut own, mut force) = (Vec::new(), Vec::new());
    for &c in &pair.projected {
        let curve = &pair.curves[c];
        let mut form = Motion::zero(sheet);
        if !curve.second.vanishes() {
            form.bending[c] = transport * curve.inverse * curve.across;
        }
        let bent = half * (third * curve.bend(curve.third));
        own.push(form.plus(bent, &curve.shift));
        force.push(shift * curve.bend(curve.second));
    }
    // τ^i = m^ij T_j
    let raise = |row: &Vec<Scalar<'s>>| sheet.sum(0..row.len(), |j| row[j] * force[j]);
    let raised: Vec<Scalar> = pair.m.iter().map(raise).collect();
    let moved = projection(pair, &raised);
    let one = sheet.one();
    let mut products = cross(pair, &raised);
    for ((&c, form), moved) in pair.projected.iter().zip(own).zip(moved) {
        products.push([pair.curves[c].shift, form.plus(one, &moved)]);
    }
    products
}

/// −τ^i (δr·Δr_,i + δr_,i·Δr), one pair per axis of space. [eq:cross]
fn cross<'s>(pair: &Pair<'s>, raised: &[Scalar<'s>]) -> Vec<Product<'s>> {
    let sheet = pair.sheet;
    let raised = sheet.terms("cross", raised, NO_CURVATURE);
    let one = sheet.one();
    let axis = |k: usize| {
        let mut left = Motion::zero(sheet);
        left.position.set(k, one);
        let mut right = Motion::zero(sheet);
        for (&c, &raised) in pair.projected.iter().zip(&raised) {
            right.turning[c].set(k, -raised);
        }
        [left, right]
    };
    (0..3).map(axis).collect()
}

/// −τ^i (Q_ik + ½ Y_ijk δζ^j), the forms beside δζ^k. [eq:Q] [eq:Y]
fn projection<'s>(pair: &Pair<'s>, raised: &[Scalar<'s>]) -> Vec<Motion<'s>> {
    let (sheet, p) = (pair.sheet, raised.len());
    let position = sheet.terms("Q-position", raised, NO_CURVATURE);
    let tangent = sheet.terms("Q-tangent", raised, NO_CURVATURE);
    let turning = sheet.terms("Q-turning", raised, NO_CURVATURE);
    let bending = sheet.terms("Q-bending", raised, NO_CURVATURE);
    let second = sheet.terms("Y-second", raised, NO_CURVATURE);
    let third = sheet.terms("Y-third", raised, NO_THIRD);
    let minus = sheet.constant(-1.0);
    let whole = sheet.sum_vectors(3, 0..p, |i| tangent[i] * pair.tangents[i]);
    let form = |k: usize| {
        let own = pair.projected[k];
        let curve = &pair.curves[own];
        let mut form = Motion::zero(sheet);
        form.position = position[k] * curve.second;
        form.turning[own] = whole;
        for (i, &c) in pair.projected.iter().enumerate() {
            form.turning[c] = form.turning[c] + turning[i] * pair.tangents[k];
        }
        if !curve.second.vanishes() {
            form.bending[own] = bending[k] * pair.r;
        }
        for (j, &c) in pair.projected.iter().enumerate() {
            let half = half_of_y(pair, &second, &third, [j, k]);
            form = form.plus(half, &pair.curves[c].shift);
        }
        form.scaled(minus)
    };
    (0..p).map(form).collect()
}

/// ½ τ^i Y_ijk: Y_iii = 3 r_,ii·b_i + r·r_,iii, Y_iij = r_,ii·b_j. [eq:Y-second] [eq:Y-third]
fn half_of_y<'s>(
    pair: &Pair<'s>,
    second: &[Scalar<'s>],
    third: &[Scalar<'s>],
    [j, k]: [usize; 2],
) -> Scalar<'s> {
    let sheet = pair.sheet;
    let half = sheet.constant(0.5);
    let curve = |i: usize| &pair.curves[pair.projected[i]];
    let bent = |i: usize, b: usize| curve(i).second.dot(pair.tangents[b]);
    let mut sum = sheet.sum(0..second.len(), |i| {
        let value = match (i == j, i == k) {
            (true, true) => sheet.constant(3.0) * bent(i, i),
            (true, false) => bent(i, k),
            (false, true) => bent(i, j),
            (false, false) => bent(j, i),
        };
        second[i] * value
    });
    if j == k {
        sum = sum + third[k] * pair.r.dot(curve(k).third);
    }
    half * sum
}
