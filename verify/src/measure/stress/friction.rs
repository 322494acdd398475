//! Tangential traction of one contact point as a function of its slip and pressure, over any number.

use super::kinematics::{Kinematics, Point, Twice};
use crate::oracle::octuple::Octuple;
use crate::oracle::pair::{Axis, Tangential};
use crate::oracle::tangential::TangentialLaw;
use crate::oracle::vector::{add, cross, dot, norm, scale, sub, unit};

/// A traction, and whether it is at its bound.
#[derive(Clone, Copy, Debug)]
pub struct Traction<D> {
    /// A vector of the tangent plane.
    pub vector: [D; 3],
    /// True where the trial traction is beyond the bound.
    pub slips: bool,
}

/// Laws whose bound is a multiple of the pressure: stiffnesses and coefficients along both axes. A law that always
/// sticks has no coefficients.
fn numbers(law: &TangentialLaw) -> Option<([f64; 2], Option<[f64; 2]>)> {
    match *law {
        TangentialLaw::Stick { eps_t } => Some(([eps_t; 2], None)),
        TangentialLaw::Coulomb { eps_t, mu } => Some(([eps_t; 2], Some([mu; 2]))),
        TangentialLaw::Orthotropic { eps_t, mu } => Some((eps_t, Some(mu))),
        _ => None,
    }
}

/// Whether the law is one of those known here.
pub fn is_known(law: &TangentialLaw) -> bool {
    numbers(law).is_some()
}

/// The traction at a slip (length) and a pressure.
pub fn traction<D: Twice>(
    law: &Tangential,
    point: &Point<'_>,
    x: &[[D; 3]],
    k: &Kinematics<D>,
    n: [D; 3],
    slip: [D; 3],
    pressure: D,
) -> Option<Traction<D>> {
    let (stiffness, mu) = numbers(&law.law)?;
    let bound = mu.map(|mu| mu.map(|mu| pressure * mu));
    match law.axis {
        None => Some(isotropic(slip, stiffness[0], bound.map(|bound| bound[0]))),
        Some(axis) => {
            let direction = match axis {
                Axis::Convected(w) => {
                    add(scale(k.b[0], D::from(w[0])), scale(k.b[1], D::from(w[1])))
                }
                Axis::SlaveCurve => point.slave_tangent(x, 0),
            };
            let e1 = unit(sub(direction, scale(n, dot(direction, n))));
            let axes = [e1, cross(n, e1)];
            Some(orthotropic(slip, axes, stiffness, bound))
        }
    }
}

fn isotropic<D: Twice>(slip: [D; 3], stiffness: f64, bound: Option<D>) -> Traction<D> {
    let trial = scale(slip, D::from(stiffness));
    let squares: Octuple = dot(trial.map(D::plain), trial.map(D::plain));
    match bound {
        Some(bound) if squares > bound.plain() * bound.plain() => Traction {
            vector: scale(trial, bound / norm(trial)),
            slips: true,
        },
        _ => Traction {
            vector: trial,
            slips: false,
        },
    }
}

fn orthotropic<D: Twice>(
    slip: [D; 3],
    axes: [[D; 3]; 2],
    stiffness: [f64; 2],
    bound: Option<[D; 2]>,
) -> Traction<D> {
    let trial = [0, 1].map(|q| dot(slip, axes[q]) * stiffness[q]);
    let share = |b: [D; 2]| {
        let part = |q: usize| (trial[q] / b[q]).plain();
        part(0) * part(0) + part(1) * part(1)
    };
    let (t, slips) = match bound {
        Some(bound) if share(bound) > 1.0 => (onto_ellipse(trial, stiffness, bound), true),
        _ => (trial, false),
    };
    Traction {
        vector: add(scale(axes[0], t[0]), scale(axes[1], t[1])),
        slips,
    }
}

/// The point of the ellipse nearest to `t` in the norm of the energy: `t_q / (1 + γ e_q / B_q²)` with the γ
/// that puts it on the ellipse.
fn onto_ellipse<D: Twice>(t: [D; 2], stiffness: [f64; 2], bound: [D; 2]) -> [D; 2] {
    let rate = [0, 1].map(|q| (bound[q] * bound[q]).recip() * stiffness[q]);
    let excess = |gamma: D| {
        let (mut value, mut slope) = (-D::one(), D::zero());
        for q in 0..2 {
            let shrunk = (gamma * rate[q] + 1.0).recip();
            let part = t[q] / bound[q] * shrunk;
            value += part * part;
            slope -= part * part * shrunk * rate[q] * 2.0;
        }
        (value, slope)
    };
    // the value falls and is convex: from below Newton's method climbs to the root without passing it
    let mut gamma = D::zero();
    for _ in 0..STEPS {
        let (value, slope) = excess(gamma);
        let step = value / slope;
        gamma -= step;
        let settled = step.plain() * step.plain() * 1e120 < gamma.plain() * gamma.plain();
        if settled {
            break;
        }
    }
    // the derivatives lag one step behind the value
    let (value, slope) = excess(gamma);
    gamma -= value / slope;
    [0, 1].map(|q| t[q] / (gamma * rate[q] + 1.0))
}

/// Newton's method grows γ by half at least in every step while it is far from the root.
const STEPS: usize = 400;
