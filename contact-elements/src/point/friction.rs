//! Tangential laws at one contact point: trial force, bound, return to it. [eq:trial] [eq:return-map]
//! [eq:ellipse]
//!
//! Components along the orthonormal axes of the contact point's frame; where one parameter is projected
//! the second component is zero.

use crate::arithmetic::{abs, sqrt};
use crate::point::values::Status;

/// Stiffness and bound of a tangential law at one pressure and slip. Isotropic laws use entry 0.
#[derive(Clone, Copy, Debug, Default)]
pub struct Friction {
    /// e_q: force per slip while sticking.
    pub stiffness: [f64; 2],
    /// B_q: largest force.
    pub bound: [f64; 2],
    /// ∂B_q/∂p
    pub by_pressure: [f64; 2],
    /// ∂B_q/∂slip
    pub by_slip: [f64; 2],
}

/// Tangential force and its derivatives.
#[derive(Clone, Copy, Debug, Default)]
pub struct Tangential {
    /// t_q
    pub t: [f64; 2],
    /// ∂t_q/∂s_r
    pub c: [[f64; 2]; 2],
    /// ∂t_q/∂p
    pub h: [f64; 2],
    /// Σ t_q²/(2 e_q): stored while sticking.
    pub energy: f64,
    /// Elastic part of the slip, t_q/e_q.
    pub elastic: [f64; 2],
    /// With rolling: t_q and the share of the moments, which multiply δζ̂^q.
    pub force: [f64; 2],
}

/// Tangential law of an element.
pub trait TangentialLaw {
    /// False for [`Frictionless`].
    const ACTIVE: bool;
    /// True for two axes with their own stiffness and bound.
    const ORTHOTROPIC: bool;
    /// False for a law that always sticks.
    const BOUNDED: bool;
    /// Number of parameters.
    const PARAMETERS: usize;
    /// Stiffness, bound and its slopes at a pressure p = −N and a slip path. [eq:bound]
    fn evaluate(pressure: f64, slip: f64, parameters: &[f64]) -> Friction;
    /// Force beyond the bound; γ of the ellipse. [eq:return-map] [eq:ellipse]
    fn slide(s: [f64; 2], friction: &Friction, gamma: f64) -> Tangential;
}

/// No tangential force.
#[derive(Clone, Copy, Debug)]
pub struct Frictionless;

impl TangentialLaw for Frictionless {
    const ACTIVE: bool = false;
    const ORTHOTROPIC: bool = false;
    const BOUNDED: bool = false;
    const PARAMETERS: usize = 0;
    #[inline(always)]
    fn evaluate(_pressure: f64, _slip: f64, _parameters: &[f64]) -> Friction {
        Friction::default()
    }
    #[inline(always)]
    fn slide(_s: [f64; 2], _friction: &Friction, _gamma: f64) -> Tangential {
        Tangential::default()
    }
}

/// Bounds below this part of the trial force count as zero: no square of a quotient of the two overflows.
const LEAST_BOUND: f64 = 1e-150;
/// Least ratio of the axes of an ellipse.
const THINNEST: f64 = 1e-13;
/// Most steps to the ellipse.
const MOST_STEPS: u32 = 60;

/// Computes the force at the slip s since the anchor into `tangential`. `path` is the slip path of the accepted history;
/// `forced` makes the point stick or slip as the history says.
#[inline(always)]
pub fn return_map<L: TangentialLaw>(
    s: [f64; 2],
    (pressure, path): (f64, f64),
    parameters: &[f64],
    forced: Option<Status>,
    tangential: &mut Tangential,
) -> Result<Status, Status> {
    let length = sqrt(s[0] * s[0] + s[1] * s[1]);
    let mut friction = L::evaluate(pressure, path + length, parameters);
    if !is_usable::<L>(&friction) {
        return Err(Status::Law);
    }
    // the ellipse of a single bound that is zero: as thin as the digits allow
    let [first, last] = friction.bound;
    friction.bound = [first.max(THINNEST * last), last.max(THINNEST * first)];
    let e = friction.stiffness;
    let trial = [e[0] * s[0], e[1] * s[1]];
    let held = !L::BOUNDED || length == 0.0 || forced == Some(Status::Stick);
    if !held && !has_room(&trial, &friction.bound) {
        *tangential = Tangential::default();
        return Ok(Status::Slip);
    }
    if !held {
        let ellipse = Ellipse::new(&trial, &friction);
        let beyond = match L::ORTHOTROPIC {
            true => ellipse.is_beyond(),
            false => e[0] * length > friction.bound[0],
        };
        if beyond || forced == Some(Status::Slip) {
            let gamma = match L::ORTHOTROPIC {
                true => ellipse.nearest(beyond),
                false => Some(0.0),
            };
            if let Some(gamma) = gamma {
                *tangential = L::slide(s, &friction, gamma);
                store(tangential, e);
                return Ok(Status::Slip);
            }
            if beyond {
                return Err(Status::NotConverged);
            }
        }
    }
    *tangential = Tangential {
        t: trial,
        c: [[e[0], 0.0], [0.0, e[1]]],
        ..Tangential::default()
    };
    store(tangential, e);
    Ok(Status::Stick)
}

/// Stiffnesses below this are refused: quotients of two stay within the range of a double.
const SOFTEST: f64 = 1e-200;

/// True if stiffnesses are positive and all values are finite.
#[inline(always)]
fn is_usable<L: TangentialLaw>(friction: &Friction) -> bool {
    let axes = if L::ORTHOTROPIC { 2 } else { 1 };
    let finite = |values: &[f64; 2]| {
        let values = values.iter().take(axes);
        values.fold(true, |all, &value| all & (abs(value) <= f64::MAX))
    };
    let stiff = friction.stiffness.iter().take(axes);
    stiff.fold(true, |all, &e| all & (e >= SOFTEST))
        && finite(&friction.stiffness)
        && finite(&friction.bound)
        && finite(&friction.by_pressure)
        && finite(&friction.by_slip)
}

/// True if every bound is positive and not negligible beside the trial force.
#[inline(always)]
fn has_room(trial: &[f64; 2], bound: &[f64; 2]) -> bool {
    let largest = abs(trial[0]).max(abs(trial[1]));
    bound
        .iter()
        .all(|&bound| bound > 0.0 && bound >= LEAST_BOUND * largest)
}

/// The energy and the elastic slip of a force.
#[inline(always)]
fn store(tangential: &mut Tangential, e: [f64; 2]) {
    for q in 0..2 {
        tangential.elastic[q] = tangential.t[q] / e[q];
        tangential.energy += 0.5 * tangential.t[q] * tangential.elastic[q];
    }
}

/// The trial force as a multiple of the bounds, y_q = t_q/B_q, and the axes of the ellipse, k_1 k_2 = 1.
/// [eq:ellipse]
struct Ellipse {
    y: [f64; 2],
    k: [f64; 2],
}

impl Ellipse {
    #[inline(always)]
    fn new(trial: &[f64; 2], friction: &Friction) -> Self {
        let ratio = sqrt(friction.stiffness[0] / friction.stiffness[1]);
        let first = ratio * (friction.bound[1] / friction.bound[0]);
        Self {
            y: [trial[0] / friction.bound[0], trial[1] / friction.bound[1]].map(abs),
            k: [first, 1.0 / first],
        }
    }

    #[inline(always)]
    fn is_beyond(&self) -> bool {
        let [first, last] = self.y;
        first > 1.0 || last > 1.0 || first * first + last * last > 1.0
    }

    /// γ with Σ (y_q/(1 + γ k_q))² = 1: Newton's method on 1/|z| − 1 from a point on the near side; `None` if it
    /// finds no γ. [eq:ellipse-newton]
    #[inline(never)]
    fn nearest(&self, beyond: bool) -> Option<f64> {
        let Self { y, k } = self;
        let nearest = ((y[0] - 1.0) / k[0]).max((y[1] - 1.0) / k[1]);
        let least = -1.0 / k[0].max(k[1]);
        let mut gamma = if beyond {
            nearest.max(0.0)
        } else {
            nearest.max(0.5 * least)
        };
        for _ in 0..MOST_STEPS {
            let (mut square, mut slope) = (0.0, 0.0);
            for q in 0..2 {
                let shrink = 1.0 / (1.0 + gamma * k[q]);
                let z = y[q] * shrink;
                square += z * z;
                slope += z * z * k[q] * shrink;
            }
            if slope <= 0.0 {
                return None;
            }
            let excess = sqrt(square) - 1.0;
            let next = (gamma + excess * square / slope).max(0.5 * (gamma + least));
            // |z| is known to a few units of its last place: where z·dz/dγ is small, γ is known less closely
            let done = abs(excess) <= 4.0 * f64::EPSILON
                || abs(next - gamma) <= 2.0 * f64::EPSILON * (abs(gamma) + 1.0 / k[0].max(k[1]));
            gamma = next;
            if done {
                return Some(gamma);
            }
        }
        None
    }
}
