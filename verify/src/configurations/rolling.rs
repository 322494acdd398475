//! Rolling of a state: numbers of the law, directors, and the angles that each contact point remembers, so that
//! either curve sticks or rolls as requested.

use std::f64::consts::TAU;

use super::margin::LEAST_MARGIN;
use super::random::Stream;
use super::state::Configuration;
use crate::oracle::history::RollingHistory;
use crate::oracle::kinematics::{Frame, Nodes};
use crate::oracle::pair::Rolling;
use crate::oracle::pair::Tangential;
use crate::oracle::rolling::reference_share;
use crate::oracle::solve::{self, PointStatus};
use crate::oracle::tangential::TangentialLaw;

/// Least part of a reference direction across the curve, and least turn of a tangent over one unit of its
/// parameter. Below it the angle keeps too few digits.
const LEAST_SHARE: f64 = 0.1;
/// Largest stiffness against the angle, in pressures times sizes. With a stiffer law the rounding of the angle shows in
/// the forces.
const STIFFEST: f64 = 100.0;
/// Largest angle since the anchor: beyond half a turn it counts from the other side.
const LARGEST_ANGLE: f64 = 3.0;

/// Numbers of the law that let a curve roll after 0.02 to 0.6 rad, and directors.
pub(super) fn draw(tangential: &mut Tangential, pressure: f64, size: f64, stream: &mut Stream) {
    let Some(rolling) = &mut tangential.rolling else {
        return;
    };
    for director in rolling.directors.iter_mut().flatten() {
        let length = stream.log_uniform(0.1, 10.0);
        *director = stream.direction().map(|component| length * component);
    }
    let reach = stream.log_uniform(0.02, 0.6);
    let lever = size * stream.log_uniform(0.01, 0.3);
    match &mut rolling.law {
        TangentialLaw::Stick { eps_t } => *eps_t = lever * pressure / reach,
        TangentialLaw::Coulomb { eps_t, mu } => {
            *mu = lever;
            *eps_t = lever * pressure / reach;
        }
        _ => {}
    }
}

/// Anchors and paths of the angles for every point.
pub(super) fn remember(
    configuration: &mut Configuration,
    slips: bool,
    stream: &mut Stream,
) -> Option<()> {
    let tangential = configuration.pair.tangential.clone();
    let Some(rolling) = tangential.and_then(|own| own.rolling) else {
        return Some(());
    };
    let points = solve::reports(&configuration.pair, &configuration.state()).ok()?;
    for (history, point) in configuration.friction.iter_mut().zip(&points) {
        let found = point.friction.and_then(|friction| friction.rolling);
        let Some(found) = found.filter(|_| point.status == PointStatus::Closed) else {
            let any = |stream: &mut Stream| [0; 2].map(|_| stream.uniform(0.0, 1.0));
            history.rolling = RollingHistory {
                anchor: any(stream),
                path: any(stream),
            };
            continue;
        };
        for c in 0..2 {
            let path = match stream.index(3) {
                0 => 0.0,
                _ => stream.log_uniform(1e-3, 1.0),
            };
            let turned = stream.sign() * draw_angle(&rolling, -point.force, path, slips, stream);
            let anchor = found.angle[c] - turned;
            history.rolling.anchor[c] = anchor - TAU * (anchor / TAU).round();
            history.rolling.path[c] = path;
        }
    }
    Some(())
}

/// Angle since the anchor: zero, tiny, close to the bound on either side, or well on one side of it.
fn draw_angle(
    rolling: &Rolling,
    pressure: f64,
    path: f64,
    slips: bool,
    stream: &mut Stream,
) -> f64 {
    let near = stream.log_uniform(1e-9, 1e-3);
    let rolls = match stream.index(4) {
        0 => !slips,
        _ => slips,
    };
    let share = match (rolls, stream.index(8)) {
        (false, 0) => return 0.0,
        (false, 1) => return stream.log_uniform(1e-14, 1e-6),
        (false, 2 | 3) => 1.0 - near,
        (false, _) => stream.uniform(0.05, 0.95),
        (true, 0..=2) => 1.0 + near,
        (true, _) => 1.0 + stream.log_uniform(0.05, 3.0),
    };
    let used = |angle: f64| {
        let moment = rolling.moment(angle.into(), pressure.into(), (0.0, path), None);
        moment.utilisation
    };
    let (mut low, mut high) = (0.0, LARGEST_ANGLE);
    if used(high) < share {
        return share.min(1.0);
    }
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if used(middle) < share {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

/// Every moment is clearly on one side of its bound, and every angle keeps its digits.
pub(super) fn is_clear(configuration: &Configuration) -> bool {
    let tangential = configuration.pair.tangential.as_ref();
    let Some(rolling) = tangential.and_then(|own| own.rolling.as_ref()) else {
        return true;
    };
    configuration.points.iter().enumerate().all(|(q, point)| {
        let Some(found) = point.friction.and_then(|friction| friction.rolling) else {
            return true;
        };
        let frame = Frame::new(
            &configuration.pair,
            q,
            &configuration.reference,
            &configuration.displacement,
        );
        let nodes: &Nodes<f64> = &frame.nodes;
        let shares = reference_share(&frame, nodes, point.zeta, rolling.directors);
        let known = shares.is_some_and(|shares| shares.iter().all(|&share| share >= LEAST_SHARE));
        let distant = |used: &f64| (used - 1.0).abs() >= LEAST_MARGIN;
        let [stiffness, _] = rolling.law.stiffness();
        let soft = stiffness <= STIFFEST * point.force.abs() * configuration.size;
        known
            && soft
            && found.utilisation.iter().all(distant)
            && found
                .turned
                .iter()
                .all(|turned| turned.abs() <= LARGEST_ANGLE)
    })
}
