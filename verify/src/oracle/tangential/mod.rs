//! Tangential laws: stiffness of sticking, and bound of the traction, as functions over any number.
//!
//! The traction follows the slip `s = b_i (ζ - ζ_st)^i` since the stick anchor like a spring until
//! it meets its bound; [`return_map`] says what then happens.

pub mod return_map;

use std::fmt::Debug;
use std::sync::Arc;

use num_dual::{Dual64, DualNum};

/// A tangential law that a user declares at run time.
pub trait DeclaredTangential: Debug + Send + Sync {
    /// True if stiffness and bound depend on the axis; otherwise only their first entries count.
    fn orthotropic(&self) -> bool;
    /// Stiffness along each axis, greater than zero (force per length).
    fn stiffness(&self) -> [f64; 2];
    /// Largest traction along each axis at a pressure `-N` and a slip path (length); `None` where
    /// the point always sticks. A negative bound counts as zero.
    fn bound<D: DualNum<Primitive = f64> + Copy>(&self, pressure: D, slip: D) -> Option<[D; 2]>;
}

/// A [`DeclaredTangential`] behind a pointer.
pub trait TangentialEvaluator: Debug + Send + Sync {
    /// See [`DeclaredTangential::orthotropic`].
    fn has_axes(&self) -> bool;
    /// See [`DeclaredTangential::stiffness`].
    fn stiffnesses(&self) -> [f64; 2];
    /// See [`DeclaredTangential::bound`].
    fn bound_dual(&self, pressure: Dual64, slip: Dual64) -> Option<[Dual64; 2]>;
}

impl<T: DeclaredTangential> TangentialEvaluator for T {
    fn has_axes(&self) -> bool {
        self.orthotropic()
    }
    fn stiffnesses(&self) -> [f64; 2] {
        self.stiffness()
    }
    fn bound_dual(&self, pressure: Dual64, slip: Dual64) -> Option<[Dual64; 2]> {
        self.bound(pressure, slip)
    }
}

/// A tangential law with its parameters. Pressure `p = -N`.
#[derive(Debug, Clone)]
pub enum TangentialLaw {
    /// No bound.
    Stick {
        /// Force per length (per length and area where integrated).
        eps_t: f64,
    },
    /// Bound `μ p`.
    Coulomb {
        /// As for `Stick`.
        eps_t: f64,
        /// μ
        mu: f64,
    },
    /// Bound `c + μ p`.
    Adhesive {
        /// As for `Stick`.
        eps_t: f64,
        /// μ
        mu: f64,
        /// c (force; per area where integrated)
        cohesion: f64,
    },
    /// Bound `p (μ_k + (μ_s - μ_k) exp(-slip / decay))`.
    StaticKinetic {
        /// As for `Stick`.
        eps_t: f64,
        /// μ_s
        mu_s: f64,
        /// μ_k
        mu_k: f64,
        /// Slip path over which μ falls (length).
        decay: f64,
    },
    /// Two stiffnesses, and an ellipse of semi-axes `μ_q p`.
    Orthotropic {
        /// As for `Stick`, along each axis.
        eps_t: [f64; 2],
        /// μ along each axis.
        mu: [f64; 2],
    },
    /// Anything else.
    Declared(Arc<dyn TangentialEvaluator>),
}

impl TangentialLaw {
    /// Whether stiffness and bound depend on the axis.
    pub fn orthotropic(&self) -> bool {
        match self {
            Self::Orthotropic { .. } => true,
            Self::Declared(law) => law.has_axes(),
            _ => false,
        }
    }

    /// Whether it can slip at all.
    pub fn is_bounded(&self) -> bool {
        let one = Dual64::from_re(1.0);
        self.bound(one, one).is_some()
    }

    /// Stiffness along each axis; twice the same where they do not matter.
    pub fn stiffness(&self) -> [f64; 2] {
        match self {
            Self::Stick { eps_t }
            | Self::Coulomb { eps_t, .. }
            | Self::Adhesive { eps_t, .. }
            | Self::StaticKinetic { eps_t, .. } => [*eps_t; 2],
            Self::Orthotropic { eps_t, .. } => *eps_t,
            Self::Declared(law) if law.has_axes() => law.stiffnesses(),
            Self::Declared(law) => [law.stiffnesses()[0]; 2],
        }
    }

    /// Largest traction along each axis, never negative; `None` where the point always sticks.
    pub fn bound(&self, pressure: Dual64, slip: Dual64) -> Option<[Dual64; 2]> {
        let bound = match self {
            Self::Stick { .. } => return None,
            Self::Coulomb { mu, .. } => [pressure * *mu; 2],
            Self::Adhesive { mu, cohesion, .. } => [pressure * *mu + *cohesion; 2],
            Self::StaticKinetic {
                mu_s, mu_k, decay, ..
            } => {
                let fallen = (-slip / *decay).exp();
                [pressure * (fallen * (mu_s - mu_k) + *mu_k); 2]
            }
            Self::Orthotropic { mu, .. } => mu.map(|mu| pressure * mu),
            Self::Declared(law) => law.bound_dual(pressure, slip)?,
        };
        let positive = |b: Dual64| {
            if b.re > 0.0 { b } else { Dual64::from_re(0.0) }
        };
        let bound = bound.map(positive);
        Some(if self.orthotropic() {
            bound
        } else {
            [bound[0]; 2]
        })
    }

    /// What makes the parameters unusable, if anything.
    pub(in crate::oracle) fn defect(&self) -> Option<&'static str> {
        let stiff = |e: f64| e.is_finite() && e > 0.0;
        let factor = |v: f64| v.is_finite() && v >= 0.0;
        if !self.stiffness().into_iter().all(stiff) {
            return Some("tangential stiffnesses must be finite and positive");
        }
        let fine = match *self {
            Self::Stick { .. } | Self::Declared(_) => true,
            Self::Coulomb { mu, .. } => factor(mu),
            Self::Adhesive { mu, cohesion, .. } => factor(mu) && factor(cohesion),
            Self::StaticKinetic {
                mu_s, mu_k, decay, ..
            } => factor(mu_s) && factor(mu_k) && stiff(decay),
            Self::Orthotropic { mu, .. } => mu.into_iter().all(factor),
        };
        (!fine).then_some("coefficients of friction must be finite and not negative")
    }
}
