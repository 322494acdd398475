//! Friction of a state: numbers of the tangential law, and what each contact point remembers, so
//! that it sticks or slips as requested.
//!
//! The anchor is placed relative to the projection that the oracle has found, along a random
//! direction of the tangent plane, at the distance that gives the chosen ratio of trial traction to bound.

use super::margin::LEAST_MARGIN;
use super::random::Stream;
use super::recipe::Freedom;
use super::rolling;
use super::state::{Configuration, Wanted};
use crate::oracle::history::RollingHistory;
use crate::oracle::history::{Accepted, FrictionHistory};
use crate::oracle::kinematics::Frame;
use crate::oracle::pair::{Axis, Tangential};
use crate::oracle::solve::{self, FrictionReport, PointReport, PointStatus, State};
use crate::oracle::tangential::TangentialLaw;
use crate::oracle::tangential::return_map::{Loading, Regime, utilisation};
use crate::oracle::vector::{add, constant, dot, scale};

/// Least slip of a point that slips, in sizes: the direction of shorter ones has too few digits
/// for the tangent.
const LEAST_SLIP: f64 = 2e-2;

/// How a contact point is loaded.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Load {
    /// Contact begins: nothing is remembered.
    Begins,
    /// A slip of this many sizes.
    Length(f64),
    /// Trial traction over its bound.
    Share(f64),
}

/// Fills in law and histories; `None` if they cannot be made so.
pub fn equip(
    configuration: &mut Configuration,
    wanted: Wanted,
    freedom: &Freedom,
    stream: &mut Stream,
) -> Option<()> {
    let Some(mut tangential) = configuration.pair.tangential.take() else {
        return Some(());
    };
    let deepest = deepest(&configuration.points);
    if freedom.law {
        let pressure = deepest.map_or(1.0, |point| -point.force);
        draw(&mut tangential, pressure, configuration.size, stream);
        rolling::draw(&mut tangential, pressure, configuration.size, stream);
    }
    configuration.pair.tangential = Some(tangential);
    configuration.points = solve::reports(&configuration.pair, &configuration.state()).ok()?;
    let slips = match wanted {
        Wanted::Stick => false,
        Wanted::Slip => true,
        Wanted::Closed | Wanted::Open | Wanted::Outside => {
            bounded(configuration) && stream.sign() > 0.0
        }
    };
    let reversed = deepest.is_some() && bounded(configuration) && stream.index(5) == 0;
    configuration.friction = if reversed {
        after_reversal(configuration, slips, stream)?
    } else {
        remembered(configuration, slips, stream)
    };
    rolling::remember(configuration, slips, stream)?;
    configuration.points = solve::reports(&configuration.pair, &configuration.state()).ok()?;
    is_clear(configuration).then_some(())
}

/// The closed point of largest pressure.
fn deepest(points: &[PointReport]) -> Option<PointReport> {
    let closed = points
        .iter()
        .copied()
        .filter(|p| p.status == PointStatus::Closed);
    closed.min_by(|a, b| a.force.total_cmp(&b.force))
}

fn bounded(configuration: &Configuration) -> bool {
    let law = configuration.pair.tangential.as_ref();
    law.is_some_and(|tangential| tangential.law.is_bounded())
}

/// Numbers of a law that lets points of this pressure slip after 2e-2 to 0.1 sizes.
fn draw(tangential: &mut Tangential, pressure: f64, size: f64, stream: &mut Stream) {
    if let Some(Axis::Convected(w)) = &mut tangential.axis {
        let [x, y, _] = stream.direction();
        *w = [2.0 * x, 2.0 * y];
    }
    let reach = |stream: &mut Stream| size * stream.log_uniform(2e-2, 0.1);
    let factor = |stream: &mut Stream| stream.log_uniform(0.05, 1.0);
    match &mut tangential.law {
        TangentialLaw::Stick { eps_t } => *eps_t = factor(stream) * pressure / reach(stream),
        TangentialLaw::Coulomb { eps_t, mu } => {
            *mu = factor(stream);
            *eps_t = *mu * pressure / reach(stream);
        }
        TangentialLaw::Adhesive {
            eps_t,
            mu,
            cohesion,
        } => {
            *mu = factor(stream);
            *cohesion = pressure * factor(stream);
            *eps_t = (*cohesion + *mu * pressure) / reach(stream);
        }
        TangentialLaw::StaticKinetic {
            eps_t,
            mu_s,
            mu_k,
            decay,
        } => {
            *mu_s = factor(stream);
            *mu_k = *mu_s * stream.uniform(0.3, 1.2);
            *decay = size * stream.log_uniform(0.03, 1.0);
            *eps_t = *mu_s * pressure / reach(stream);
        }
        TangentialLaw::Orthotropic { eps_t, mu } => {
            for q in 0..2 {
                mu[q] = factor(stream);
                eps_t[q] = mu[q] * pressure / reach(stream);
            }
        }
        TangentialLaw::Declared(_) => {}
    }
}

/// How to load one point. Where another point slips, this one may stick.
fn draw_load(slips: bool, stream: &mut Stream) -> Load {
    let near = stream.log_uniform(1e-9, 1e-3);
    match (slips, stream.index(8)) {
        (false, 0) => Load::Begins,
        (false, 1) => Load::Length(0.0),
        (false, 2) => Load::Length(stream.log_uniform(1e-14, 1e-6)),
        (false, 3 | 4) => Load::Share(1.0 - near),
        (false, _) => Load::Share(stream.uniform(0.05, 0.95)),
        (true, 0..=2) => Load::Share(1.0 + near),
        (true, _) => Load::Share(1.0 + stream.log_uniform(0.05, 3.0)),
    }
}

/// A history for every point: the deepest is loaded as requested, the others likewise or sticking.
fn remembered(
    configuration: &Configuration,
    slips: bool,
    stream: &mut Stream,
) -> Vec<FrictionHistory> {
    let least = deepest(&configuration.points).map(|point| point.force);
    let mut list = Vec::with_capacity(configuration.points.len());
    for (q, point) in configuration.points.iter().enumerate() {
        let slips = slips && (least == Some(point.force) || stream.sign() > 0.0);
        let history = match point.friction {
            Some(friction) => {
                let load = draw_load(slips, stream);
                let direction = draw_direction(configuration, &friction, stream);
                let path = draw_path(configuration.size, stream);
                anchored(configuration, q, load, direction, path)
            }
            None => forgotten(configuration, q, stream),
        };
        list.push(history);
    }
    list
}

/// Contents of the history of a point that is no longer in contact: it must not matter.
fn forgotten(configuration: &Configuration, q: usize, stream: &mut Stream) -> FrictionHistory {
    let status = [Accepted::Open, Accepted::Stick, Accepted::Slip][stream.index(3)];
    let start = configuration.start[q];
    FrictionHistory {
        status,
        anchor: start.map(|z| z + stream.uniform(-0.1, 0.1)),
        slip: draw_path(configuration.size, stream),
        rolling: RollingHistory::default(),
    }
}

fn draw_path(size: f64, stream: &mut Stream) -> f64 {
    if stream.index(3) == 0 {
        0.0
    } else {
        size * stream.log_uniform(1e-3, 1.0)
    }
}

/// A unit vector of the tangent plane.
fn draw_direction(
    configuration: &Configuration,
    friction: &FrictionReport,
    stream: &mut Stream,
) -> [f64; 3] {
    let [first, second] = friction.axes;
    if configuration.pair.parameters() == 1 {
        return scale(first, stream.sign());
    }
    let angle = stream.uniform(0.0, std::f64::consts::TAU);
    add(scale(first, angle.cos()), scale(second, angle.sin()))
}

/// The history that loads point `q` along a direction.
fn anchored(
    configuration: &Configuration,
    q: usize,
    load: Load,
    direction: [f64; 3],
    path: f64,
) -> FrictionHistory {
    let point = &configuration.points[q];
    let length = match load {
        Load::Begins | Load::Length(0.0) => 0.0,
        Load::Length(sizes) => sizes * configuration.size,
        Load::Share(share) => {
            let found = length_for(configuration, q, share, direction, path);
            if share > 1.0 {
                found.max(LEAST_SLIP * configuration.size)
            } else {
                found
            }
        }
    };
    let frame = Frame::new(
        &configuration.pair,
        q,
        &configuration.reference,
        &configuration.displacement,
    );
    let moved = frame.parameters_of(point.zeta, scale(direction, length));
    FrictionHistory {
        status: match load {
            Load::Begins => Accepted::Open,
            _ if path > 0.0 => Accepted::Slip,
            _ => Accepted::Stick,
        },
        anchor: [0, 1].map(|i| point.zeta[i] - moved[i]),
        slip: path,
        rolling: RollingHistory::default(),
    }
}

/// Length of the slip along a direction at which the trial traction is `share` of its bound.
fn length_for(
    configuration: &Configuration,
    q: usize,
    share: f64,
    direction: [f64; 3],
    path: f64,
) -> f64 {
    let (point, size) = (&configuration.points[q], configuration.size);
    let (Some(tangential), Some(friction)) = (&configuration.pair.tangential, point.friction)
    else {
        return 0.0;
    };
    if !tangential.law.is_bounded() {
        return 0.1 * share * size;
    }
    let used = |length: f64| {
        let loading = Loading {
            slip: constant(scale(direction, length)),
            axes: friction.axes.map(constant),
            pressure: (-point.force).into(),
            path,
        };
        utilisation(&tangential.law, &loading)
    };
    let (mut low, mut high) = (0.0, 1e-9 * size);
    while used(high) < share && high < 1e3 * size {
        high *= 2.0;
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

/// Histories of a state in which all points slipped the other way: the slave then moves on along a
/// direction, less than its way back to the opposite bound or further.
fn after_reversal(
    configuration: &Configuration,
    slips: bool,
    stream: &mut Stream,
) -> Option<Vec<FrictionHistory>> {
    let deepest = deepest(&configuration.points)?;
    let q = configuration.points.iter().position(|p| *p == deepest)?;
    let direction = draw_direction(configuration, &deepest.friction?, stream);
    let reach = length_for(configuration, q, 1.0, direction, 0.0);
    let way = reach
        * if slips {
            stream.uniform(2.3, 4.0)
        } else {
            stream.uniform(0.1, 1.7)
        };
    let mut before = configuration.clone();
    let pair = &configuration.pair;
    for node in (0..pair.slave_nodes()).filter(|&node| pair.slave_is_position(node)) {
        for c in 0..pair.dimension {
            before.displacement[pair.dimension * node + c] -= way * direction[c];
        }
    }
    before.points = solve::reports(pair, &before.state()).ok()?;
    let backwards = scale(direction, -1.0);
    before.friction = (0..before.points.len())
        .map(|q| match before.points[q].friction {
            Some(friction) => {
                let along = friction.axes.map(|axis| dot(axis, backwards));
                let within = add(
                    scale(friction.axes[0], along[0]),
                    scale(friction.axes[1], along[1]),
                );
                anchored(&before, q, Load::Share(2.0), within, 0.0)
            }
            None => forgotten(&before, q, stream),
        })
        .collect();
    let state = State {
        start: configuration.state().start,
        ..before.state()
    };
    let before = solve::reports(pair, &state).ok()?;
    let history = |point: &PointReport| match point.friction {
        Some(friction) => friction.history,
        None => FrictionHistory {
            status: Accepted::Open,
            anchor: [0.0; 2],
            slip: 0.0,
            rolling: RollingHistory::default(),
        },
    };
    (before[q].friction?.regime == Regime::Slip).then(|| before.iter().map(history).collect())
}

/// Every closed point is clearly on one side of its bound, and slips far enough to have a direction.
pub(super) fn is_clear(configuration: &Configuration) -> bool {
    let least = 0.99 * LEAST_SLIP * configuration.size;
    let mut closed = configuration.points.iter().filter_map(|p| p.friction);
    closed.all(|friction| {
        let far = friction.regime == Regime::Stick || friction.distance >= least;
        far && (friction.utilisation - 1.0).abs() >= LEAST_MARGIN
    }) && rolling::is_clear(configuration)
}
