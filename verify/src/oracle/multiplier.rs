//! A multiplier λ beside the normal law: what it makes of energy and force.
//!
//! The potential of a point is `(min(λ + N(g), 0)² - λ²) / (2c)` with the stiffness c of the law, a linear
//! spring; λ is a number that is held, or an unknown like the positions.

use num_dual::{Dual64, HyperDual64};

use super::law::{Activity, Law};

/// The multipliers of a pair, one for each contact point; missing ones are zero.
#[derive(Debug, Clone, PartialEq)]
pub enum Multipliers {
    /// The law alone.
    None,
    /// Held fixed.
    Held(Vec<f64>),
    /// Unknowns.
    Unknown(Vec<f64>),
}

impl Multipliers {
    /// The multiplier of point `q`, where there is one.
    pub fn at(&self, q: usize) -> Option<f64> {
        match self {
            Self::None => None,
            Self::Held(values) | Self::Unknown(values) => {
                Some(values.get(q).copied().unwrap_or(0.0))
            }
        }
    }

    /// The values where they are unknowns, else nothing.
    pub fn unknowns(&self) -> &[f64] {
        match self {
            Self::Unknown(values) => values,
            _ => &[],
        }
    }

    /// Whether they are unknowns.
    pub fn are_unknown(&self) -> bool {
        matches!(self, Self::Unknown(_))
    }
}

/// The normal law of a contact point, with its multiplier.
#[derive(Debug, Clone, Copy)]
pub struct Enforced<'a> {
    /// The law.
    pub law: &'a Law,
    /// λ, where there is one.
    pub multiplier: Option<f64>,
}

impl Enforced<'_> {
    /// Whether the point is in contact at the gap `g`.
    pub fn activity(&self, g: f64) -> Activity {
        if self.multiplier.is_none() {
            return self.law.activity(g);
        }
        if self.force(Dual64::from_re(g)).re < 0.0 {
            Activity::Active
        } else {
            Activity::Inactive
        }
    }

    /// N with its derivative.
    pub fn force(&self, g: Dual64) -> Dual64 {
        self.law.force(g) + self.multiplier.unwrap_or(0.0)
    }

    /// Energy in contact, without the constant of the multiplier.
    pub fn energy(&self, g: HyperDual64) -> Option<HyperDual64> {
        match self.multiplier {
            None => self.law.energy(g),
            Some(multiplier) => Some(self.square(g, HyperDual64::from_re(multiplier))),
        }
    }

    /// The potential as a function of gap and multiplier.
    pub fn potential(&self, g: HyperDual64, multiplier: HyperDual64) -> HyperDual64 {
        let constant = multiplier * multiplier / (2.0 * self.stiffness());
        match self.activity(g.re) {
            Activity::Active => self.square(g, multiplier) - constant,
            _ => -constant,
        }
    }

    /// `λ² / (2c)`
    pub fn constant(&self, multiplier: f64) -> f64 {
        multiplier * multiplier / (2.0 * self.stiffness())
    }

    /// `(λ + c g)² / (2c)`
    fn square(&self, g: HyperDual64, multiplier: HyperDual64) -> HyperDual64 {
        let c = self.stiffness();
        let force = g * c + multiplier;
        force * force / (2.0 * c)
    }

    fn stiffness(&self) -> f64 {
        self.law.force(Dual64::new(-1.0, 1.0)).eps
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_potential_is_smooth_where_contact_begins() {
        let law = Law::Penalty { eps_n: 8.0 };
        for gap in [-0.25, 0.125] {
            let at = |multiplier: f64| {
                let law = Enforced {
                    law: &law,
                    multiplier: Some(multiplier),
                };
                let value = law.potential(
                    HyperDual64::from_re(gap),
                    HyperDual64::new(multiplier, 1.0, 1.0, 0.0),
                );
                (law.activity(gap), value.re, value.eps1)
            };
            let (closed, open) = (at(-8.0 * gap - 1e-9), at(-8.0 * gap + 1e-9));
            assert_eq!(closed.0, Activity::Active);
            assert_eq!(open.0, Activity::Inactive);
            assert!((closed.1 - open.1).abs() < 1e-8 && (closed.2 - open.2).abs() < 1e-8);
            assert!((closed.2 - gap).abs() < 1e-14, "the constraint itself");
        }
    }
}
