//! Contact of two curves that acts at some angles only: a factor of the energy that goes from zero to one.
//!
//! With θ between the tangents, `s = sin²θ` and the window from `θ_low` to `θ_high`, the factor is the smooth step
//! `6x⁵ − 15x⁴ + 10x³` of `x = (s − sin²θ_low)/(sin²θ_high − sin²θ_low)`, zero below and one above; at small angles
//! one minus that.

use super::kinematics::{Frame, Nodes, Relative};
use super::number::Base;
use super::pair::{Angle, Slave};
use super::vector::{cross, dot};

impl Angle {
    /// Where `s` lies in the window: 0 at its low end, 1 at its high end.
    pub fn position<D: Base>(&self, s: D) -> D {
        let [low, high] = self.window.map(|angle| angle.sin().powi(2));
        (s - low) * (high - low).recip()
    }

    /// The factor of the energy.
    #[inline]
    pub fn factor<D: Base>(&self, frame: &Frame<'_>, nodes: &Nodes<D>, at: &Relative<D>) -> D {
        let x = self.position(sine_squared(frame, nodes, at));
        let x = if self.small { -x + 1.0 } else { x };
        if x.re() <= 0.0 {
            return D::zero();
        }
        if x.re() >= 1.0 {
            return D::one();
        }
        x * x * x * (x * (x * 6.0 - 15.0) + 10.0)
    }
}

/// sin²θ of the tangents of slave and master at a contact point.
#[inline]
pub fn sine_squared<D: Base>(frame: &Frame<'_>, nodes: &Nodes<D>, at: &Relative<D>) -> D {
    let slave = match frame.pair.slave {
        Slave::Curve(_) => at.tangents[0],
        _ => frame.slave_tangent(&nodes.slave, 0),
    };
    let master = at.tangents[frame.parameters - 1];
    let across = cross(slave, master);
    dot(across, across) / (dot(slave, slave) * dot(master, master))
}

/// The factor of a pair's energy: one without an angle.
#[inline]
pub fn factor<D: Base>(frame: &Frame<'_>, nodes: &Nodes<D>, at: &Relative<D>) -> D {
    let angle = frame.pair.angle.as_ref();
    angle.map_or(D::one(), |angle| angle.factor(frame, nodes, at))
}

#[cfg(test)]
mod tests {
    use num_dual::HyperDual64;

    /// Value, slope and curvature meet at both ends of the window, and the factor rises in between.
    #[test]
    fn the_smooth_step_is_twice_differentiable() {
        let step = |x: f64| {
            let x = HyperDual64::new(x, 1.0, 1.0, 0.0);
            x * x * x * (x * (x * 6.0 - 15.0) + 10.0)
        };
        let close = |found: HyperDual64, value: f64| {
            (found.re - value).abs() + found.eps1.abs() + found.eps1eps2.abs() < 1e-12
        };
        assert!(close(step(0.0), 0.0) && close(step(1.0), 1.0));
        assert!((1..20).all(|k| step(f64::from(k) / 20.0).eps1 > 0.0));
    }
}
