//! From slip to traction: a spring that yields where it meets its bound ([eq:return-map]).
//!
//! Everything is a vector of the tangent plane, not a component along the parameters. Isotropic:
//! `t = e s`, shortened to the bound. Two stiffnesses: components along the axes, returned to the
//! ellipse in the norm of the energy ([eq:ellipse]).

// [eq:…] names an equation of docs/, not an item; the documentation tests follow it
#![allow(rustdoc::broken_intra_doc_links)]

use num_dual::{Dual64, DualNum};

use super::TangentialLaw;
use crate::oracle::vector::{add, dot, norm, scale};

/// What the traction of a point depends on.
#[derive(Debug, Clone, Copy)]
pub struct Loading {
    /// Slip since the anchor (length).
    pub slip: [Dual64; 3],
    /// Unit axes of the tangent plane.
    pub axes: [[Dual64; 3]; 2],
    /// p = -N.
    pub pressure: Dual64,
    /// Path slipped until the accepted state (length).
    pub path: f64,
}

/// Sticks or slips.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Regime {
    /// The spring holds.
    Stick,
    /// The traction is at its bound.
    Slip,
}

/// A traction.
#[derive(Debug, Clone, Copy)]
pub struct Traction {
    /// t (force, or force per length or area).
    pub vector: [Dual64; 3],
    /// Slip that the spring still holds (length).
    pub elastic: [Dual64; 3],
    /// Energy of the spring.
    pub energy: f64,
}

/// Trial traction over its bound: slips where it exceeds one. Zero where nothing pulls; infinite
/// where something pulls against no bound at all.
pub fn utilisation(law: &TangentialLaw, loading: &Loading) -> f64 {
    let plain = loading.plain();
    let [e1, e2] = law.stiffness();
    let Some([b1, b2]) = law.bound(plain.pressure, plain.path()) else {
        return 0.0;
    };
    let share = |pull: f64, bound: f64| if pull == 0.0 { 0.0 } else { pull.abs() / bound };
    if !law.orthotropic() {
        return share(e1 * norm(plain.slip).re, b1.re);
    }
    let [s1, s2] = plain.components();
    share(e1 * s1.re, b1.re).hypot(share(e2 * s2.re, b2.re))
}

/// Traction and its derivative for a known regime.
pub fn traction(law: &TangentialLaw, loading: &Loading, regime: Regime) -> Traction {
    if law.orthotropic() {
        along_axes(law, loading, regime)
    } else {
        isotropic(law, loading, regime)
    }
}

impl Loading {
    /// The same without derivatives: a slip of zero has a length, but no derivative of it.
    fn plain(&self) -> Self {
        let plain = |v: [Dual64; 3]| v.map(|c| Dual64::from_re(c.re));
        Self {
            slip: plain(self.slip),
            axes: self.axes.map(plain),
            pressure: Dual64::from_re(self.pressure.re),
            path: self.path,
        }
    }

    /// Path slipped if the whole slip were lost.
    fn path(&self) -> Dual64 {
        norm(self.slip) + self.path
    }

    /// Slip along the axes.
    fn components(&self) -> [Dual64; 2] {
        self.axes.map(|axis| dot(axis, self.slip))
    }
}

fn isotropic(law: &TangentialLaw, loading: &Loading, regime: Regime) -> Traction {
    let [stiffness, _] = law.stiffness();
    let trial = scale(loading.slip, Dual64::from_re(stiffness));
    let bound = match regime {
        Regime::Stick => None,
        Regime::Slip => law.bound(loading.pressure, loading.path()),
    };
    let vector = match bound {
        None => trial,
        Some([bound, _]) if bound.re == 0.0 => [Dual64::from_re(0.0); 3],
        Some([bound, _]) => scale(trial, bound / norm(trial)),
    };
    Traction {
        vector,
        elastic: scale(vector, Dual64::from_re(stiffness.recip())),
        energy: dot(vector, vector).re / (2.0 * stiffness),
    }
}

fn along_axes(law: &TangentialLaw, loading: &Loading, regime: Regime) -> Traction {
    let stiffness = law.stiffness();
    let slip = loading.components();
    let mut t = [0, 1].map(|q| slip[q] * stiffness[q]);
    if regime == Regime::Slip
        && let Some(bound) = law.bound(loading.pressure, loading.path())
    {
        t = onto_ellipse(t, stiffness, bound);
    }
    let combine = |c: [Dual64; 2]| add(scale(loading.axes[0], c[0]), scale(loading.axes[1], c[1]));
    Traction {
        vector: combine(t),
        elastic: combine([t[0] / stiffness[0], t[1] / stiffness[1]]),
        energy: (0..2)
            .map(|q| t[q].re * t[q].re / (2.0 * stiffness[q]))
            .sum(),
    }
}

/// The point of the ellipse that is closest to `t` in the norm of the energy `Σ t_q² / (2 e_q)`.
fn onto_ellipse(t: [Dual64; 2], stiffness: [f64; 2], bound: [Dual64; 2]) -> [Dual64; 2] {
    // an ellipse without width is an interval, or a point
    if bound[0].re == 0.0 || bound[1].re == 0.0 {
        return [0, 1].map(|q| match bound[q].re {
            b if t[q].re.abs() <= b => t[q],
            0.0 => Dual64::from_re(0.0),
            _ => bound[q] * t[q].re.signum(),
        });
    }
    let square = bound.map(|b| b * b);
    let rate = [0, 1].map(|q| square[q].recip() * stiffness[q]);
    let fastest = rate[0].re.max(rate[1].re);
    let mut gamma = Dual64::from_re(0.0);
    let mut settled = false;
    for _ in 0..NEWTON_STEPS {
        let (mut value, mut slope) = (Dual64::from_re(-1.0), Dual64::from_re(0.0));
        for q in 0..2 {
            let shrunk = (gamma * rate[q] + 1.0).recip();
            let term = t[q] * t[q] / square[q] * shrunk * shrunk;
            value += term;
            slope -= term * shrunk * rate[q] * 2.0;
        }
        let step = value / slope;
        gamma -= step;
        // one more step carries the derivative
        if settled {
            break;
        }
        settled = step.re.abs() * fastest <= 1e-15 * (1.0 + gamma.re * fastest);
    }
    [0, 1].map(|q| t[q] / (gamma * rate[q] + 1.0))
}

/// Newton from zero climbs: by a factor of about 1.5 per step while `t` is far outside.
const NEWTON_STEPS: usize = 1000;
