//! Angles about two curves, and the moments that follow them ([eq:rolling-angle]).
//!
//! Either curve has a triad at the closest point: its unit tangent, the direction in which the tangent turns
//! (or the director across the curve), and their cross product. The angle is that of the shortest distance,
//! from this curve to the other, in the plane of the last two.

// [eq:…] names an equation of docs/, not an item; the documentation tests follow it
#![allow(rustdoc::broken_intra_doc_links)]

use num_dual::{Dual64, DualNum};

use super::geometry::Interpolation;
use super::kinematics::{Frame, Nodes};
use super::number::Base;
use super::pair::{Master, Rolling, Slave};
use super::tangential::return_map::Regime;
use super::vector::{constant, cross, dot, norm, scale, sub, unit};

/// A moment with its derivative.
#[derive(Debug, Clone, Copy)]
pub struct Moment {
    /// Whether the spring holds.
    pub regime: Regime,
    /// Trial moment over its bound.
    pub utilisation: f64,
    /// Angle since the anchor (rad).
    pub turned: f64,
    /// The moment.
    pub value: Dual64,
    /// Energy of the spring.
    pub energy: f64,
    /// Angle without moment and path, if the state is accepted.
    pub next: (f64, f64),
}

impl Rolling {
    /// The moment at an angle, `frozen` or as it comes.
    pub fn moment(
        &self,
        angle: Dual64,
        pressure: Dual64,
        (anchor, path): (f64, f64),
        frozen: Option<Regime>,
    ) -> Moment {
        let [stiffness, _] = self.law.stiffness();
        let mut turned = angle - anchor;
        turned.re -= std::f64::consts::TAU * (turned.re / std::f64::consts::TAU).round();
        let trial = turned * stiffness;
        let way = if turned.re < 0.0 { -turned } else { turned };
        let bound = self.law.bound(pressure, way + path).map(|[bound, _]| bound);
        let utilisation = match bound {
            None => 0.0,
            _ if trial.re == 0.0 => 0.0,
            Some(bound) => trial.re.abs() / bound.re,
        };
        let natural = if utilisation > 1.0 {
            Regime::Slip
        } else {
            Regime::Stick
        };
        let regime = frozen.unwrap_or(natural);
        let value = match (regime, bound) {
            (Regime::Slip, Some(bound)) => bound * trial.re.signum(),
            _ => trial,
        };
        let elastic = value.re / stiffness;
        let next = match regime {
            Regime::Stick => (anchor, path),
            Regime::Slip => (angle.re - elastic, path + (turned.re - elastic).abs()),
        };
        Moment {
            regime,
            utilisation,
            turned: turned.re,
            value,
            energy: value.re * elastic / 2.0,
            next,
        }
    }
}

/// A curve with its nodes.
type Curve<'a, D> = (&'a Interpolation, &'a [[D; 3]]);

/// The two curves of a pair.
fn curves<'a, D>(frame: &'a Frame<'_>, nodes: &'a Nodes<D>) -> Option<[Curve<'a, D>; 2]> {
    match (&frame.pair.slave, &frame.pair.master) {
        (Slave::Curve(slave), Master::Shape(master)) => {
            Some([(slave, &nodes.slave[..]), (master, &nodes.master[..])])
        }
        _ => None,
    }
}

/// Angles about both curves (rad) at parameters `zeta`; `None` for another pair.
pub fn angles<D: Base>(
    frame: &Frame<'_>,
    nodes: &Nodes<D>,
    zeta: [D; 2],
    directors: Option<[[f64; 3]; 2]>,
) -> Option<[D; 2]>
where
    D::Nested: Base,
{
    let relative = frame.relative(nodes, zeta);
    let curves = curves(frame, nodes)?;
    let angle = |c: usize| {
        let (curve, nodes) = curves[c];
        let (tangent, turning) = derivatives(curve, nodes, zeta[c]);
        let reference = directors.map_or(turning, |given| constant(given[c]));
        let tau = unit(tangent);
        let normal = unit(sub(reference, scale(tau, dot(tau, reference))));
        let binormal = cross(tau, normal);
        // slave minus master: towards the slave
        let away = if c == 0 { -D::one() } else { D::one() };
        let e = scale(relative.position, away);
        direction(dot(e, normal), dot(e, binormal))
    };
    Some([angle(0), angle(1)])
}

/// How well the reference directions are known: the part of a director across the curve relative to the whole, or
/// the turn of a tangent over one unit of its parameter (rad).
pub fn reference_share(
    frame: &Frame<'_>,
    nodes: &Nodes<f64>,
    zeta: [f64; 2],
    directors: Option<[[f64; 3]; 2]>,
) -> Option<[f64; 2]> {
    let curves = curves(frame, nodes)?;
    Some([0, 1].map(|c| {
        let (curve, nodes) = curves[c];
        let (tangent, turning) = derivatives(curve, nodes, zeta[c]);
        let reference = directors.map_or(turning, |given| given[c]);
        let whole = directors.map_or(norm(tangent), |given| norm(given[c]));
        let tau = unit(tangent);
        norm(sub(reference, scale(tau, dot(tau, reference)))) / whole
    }))
}

/// The angle of the point (x, y), with derivatives of arcs near zero only.
fn direction<D: DualNum<Primitive = f64> + Copy>(x: D, y: D) -> D {
    let base = y.re().atan2(x.re());
    let (sine, cosine) = base.sin_cos();
    ((y * cosine - x * sine) / (x * cosine + y * sine)).atan() + base
}

/// First and second derivative of a curve by its parameter.
fn derivatives<D: Base>(curve: &Interpolation, nodes: &[[D; 3]], z: D) -> ([D; 3], [D; 3])
where
    D::Nested: Base,
{
    let lift = |value: D| D::nest(value, D::zero());
    let nodes: Vec<[D::Nested; 3]> = nodes[..curve.shape.nodes()]
        .iter()
        .map(|node| node.map(lift))
        .collect();
    let (_, slopes) = curve.evaluate([D::nest(z, D::one()), lift(D::zero())], &nodes);
    let parts = slopes[0].map(D::parts);
    (parts.map(|part| part.0), parts.map(|part| part.1))
}
