//! Normal laws as energies `W(g)`; force `N = W'` and stiffness `N' = W''` come from duals.

use std::fmt::Debug;
use std::sync::Arc;

use num_dual::{Dual64, DualNum, HyperDual64};

/// Whether a law acts at a gap.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Activity {
    /// Neither energy nor force.
    Inactive,
    /// Energy and force.
    Active,
    /// The law has no value there.
    Infeasible,
}

/// A normal law that a user declares at run time.
///
/// Without an energy the oracle works from the force: `R = N dg`, `K = d(N dg)`.
pub trait DeclaredLaw: Debug + Send + Sync {
    /// Whether the law acts at the gap `g` (length).
    fn activity(&self, g: f64) -> Activity;
    /// Force `N(g)`, negative where it repels. Called where the law acts.
    fn force<D: DualNum<Primitive = f64> + Copy>(&self, g: D) -> D;
    /// Energy `W(g)` with `W' = N`, if known.
    fn energy<D: DualNum<Primitive = f64> + Copy>(&self, g: D) -> Option<D> {
        let _ = g;
        None
    }
}

/// A [`DeclaredLaw`] behind a pointer.
pub trait LawEvaluator: Debug + Send + Sync {
    /// See [`DeclaredLaw::activity`].
    fn activity_at(&self, g: f64) -> Activity;
    /// See [`DeclaredLaw::force`].
    fn force_dual(&self, g: Dual64) -> Dual64;
    /// See [`DeclaredLaw::energy`].
    fn energy_hyper(&self, g: HyperDual64) -> Option<HyperDual64>;
}

impl<T: DeclaredLaw> LawEvaluator for T {
    fn activity_at(&self, g: f64) -> Activity {
        self.activity(g)
    }
    fn force_dual(&self, g: Dual64) -> Dual64 {
        self.force(g)
    }
    fn energy_hyper(&self, g: HyperDual64) -> Option<HyperDual64> {
        self.energy(g)
    }
}

/// A normal law with its parameters.
#[derive(Debug, Clone)]
pub enum Law {
    /// `N = eps_n g` for `g < 0`.
    Penalty {
        /// Force per length (per length and area where integrated).
        eps_n: f64,
    },
    /// `N = -eps_n (-g)^exponent` for `g < 0`.
    Power {
        /// Force per length to the power `exponent`.
        eps_n: f64,
        /// Greater than one.
        exponent: f64,
    },
    /// `W = -kappa (g - d)² ln(g / d)` for `0 < g < d`; no value for `g <= 0`.
    Barrier {
        /// Force per length.
        kappa: f64,
        /// d: gap at which the barrier begins (length).
        distance: f64,
    },
    /// Anything else.
    Declared(Arc<dyn LawEvaluator>),
}

impl Law {
    /// Whether the law acts at the gap `g`.
    pub fn activity(&self, g: f64) -> Activity {
        match self {
            Self::Penalty { .. } | Self::Power { .. } if g < 0.0 => Activity::Active,
            Self::Penalty { .. } | Self::Power { .. } => Activity::Inactive,
            Self::Barrier { .. } if g <= 0.0 => Activity::Infeasible,
            Self::Barrier { distance, .. } if g < *distance => Activity::Active,
            Self::Barrier { .. } => Activity::Inactive,
            Self::Declared(law) => law.activity_at(g),
        }
    }

    /// Energy where the law acts; `None` for a declared law that knows only its force.
    #[inline]
    pub fn energy(&self, g: HyperDual64) -> Option<HyperDual64> {
        Some(match self {
            Self::Penalty { eps_n } => g * g * (0.5 * eps_n),
            Self::Power { eps_n, exponent } => {
                let order = exponent + 1.0;
                (-g).powf(order) * (eps_n / order)
            }
            Self::Barrier { kappa, distance } => {
                let rest = g - *distance;
                -(rest * rest * (g / *distance).ln()) * *kappa
            }
            Self::Declared(law) => return law.energy_hyper(g),
        })
    }

    /// Force where the law acts, with the derivative along `g`: slope of the energy.
    #[inline]
    pub fn force(&self, g: Dual64) -> Dual64 {
        if let Self::Declared(law) = self {
            return law.force_dual(g);
        }
        match self.energy(HyperDual64::new(g.re, 1.0, 1.0, 0.0)) {
            Some(energy) => Dual64::new(energy.eps1, energy.eps1eps2 * g.eps),
            None => Dual64::new(f64::NAN, f64::NAN),
        }
    }

    /// What makes the parameters unusable, if anything.
    pub fn defect(&self) -> Option<String> {
        match *self {
            Self::Penalty { eps_n } if !eps_n.is_finite() => Some("eps_n is not finite".into()),
            Self::Power { eps_n, exponent }
                if !(eps_n.is_finite() && exponent > 1.0 && exponent.is_finite()) =>
            {
                Some("a power law needs a finite eps_n and an exponent above one".into())
            }
            Self::Barrier { kappa, distance }
                if !(kappa.is_finite() && distance > 0.0 && distance.is_finite()) =>
            {
                Some("a barrier needs a finite kappa and a positive distance".into())
            }
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn force_and_stiffness(law: &Law, g: f64) -> (f64, f64) {
        let n = law.force(Dual64::new(g, 1.0));
        (n.re, n.eps)
    }

    fn close(a: f64, b: f64) -> bool {
        (a - b).abs() <= 1e-14 * (1.0 + b.abs())
    }

    #[test]
    fn forces_are_the_slopes_of_the_energies() {
        let (n, k) = force_and_stiffness(&Law::Penalty { eps_n: 30.0 }, -0.2);
        assert!(close(n, -6.0) && close(k, 30.0));
        let (n, k) = force_and_stiffness(
            &Law::Power {
                eps_n: 2.0,
                exponent: 1.5,
            },
            -0.25,
        );
        assert!(close(n, -2.0 * 0.125) && close(k, 2.0 * 1.5 * 0.5));
        let law = Law::Barrier {
            kappa: 3.0,
            distance: 0.5,
        };
        let (n, k) = force_and_stiffness(&law, 0.2);
        let log = 0.4f64.ln();
        assert!(close(n, -3.0 * (2.0 * -0.3 * log + 0.09 / 0.2)));
        assert!(close(
            k,
            -3.0 * (2.0 * log + 4.0 * -0.3 / 0.2 - 0.09 / 0.04)
        ));
    }

    #[test]
    fn laws_know_where_they_act() {
        assert_eq!(
            Law::Penalty { eps_n: 1.0 }.activity(0.0),
            Activity::Inactive
        );
        let barrier = Law::Barrier {
            kappa: 1.0,
            distance: 0.1,
        };
        assert_eq!(barrier.activity(0.05), Activity::Active);
        assert_eq!(barrier.activity(0.1), Activity::Inactive);
        assert_eq!(barrier.activity(0.0), Activity::Infeasible);
    }
}
