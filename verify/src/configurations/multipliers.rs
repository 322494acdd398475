//! Multipliers of a state: at, above and below the traction of the law alone, on both sides of the gap.

use super::random::Stream;
use super::state::{Configuration, Wanted};
use crate::oracle::multiplier::Multipliers;
use crate::oracle::solve;

/// Draws a multiplier for every contact point; `None` if the gaps cannot be found.
pub fn equip(configuration: &mut Configuration, wanted: Wanted, stream: &mut Stream) -> Option<()> {
    let unknown = match configuration.pair.multipliers {
        Multipliers::None => return Some(()),
        Multipliers::Held(_) => false,
        Multipliers::Unknown(_) => true,
    };
    let opened = wanted.is_closed() && stream.index(3) == 0;
    if opened {
        // a positive gap that the multiplier closes nevertheless
        let deepest = configuration
            .points
            .iter()
            .map(|point| -point.gap)
            .fold(0.0, f64::max);
        configuration.pair.r0 -= deepest * stream.uniform(1.2, 2.0);
    }
    let law = &configuration.pair.law;
    let alone: Vec<f64> = plain(configuration)?
        .into_iter()
        .map(|gap| law.force(gap.into()).re)
        .collect();
    let largest = alone.iter().fold(0.0_f64, |m, force| m.max(force.abs()));
    let kind = Kind {
        wanted,
        unknown,
        opened,
    };
    let values = alone
        .into_iter()
        .map(|force| draw(force, largest, &kind, stream))
        .collect();
    configuration.pair.multipliers = if unknown {
        Multipliers::Unknown(values)
    } else {
        Multipliers::Held(values)
    };
    Some(())
}

/// Gaps of the points, as far as they have one.
fn plain(configuration: &Configuration) -> Option<Vec<f64>> {
    let reports = solve::reports(&configuration.pair, &configuration.state()).ok()?;
    Some(reports.iter().map(|point| point.gap).collect())
}

/// What a multiplier is drawn for.
struct Kind {
    wanted: Wanted,
    /// Whether multipliers are unknowns.
    unknown: bool,
    /// Whether the law alone leaves all points open.
    opened: bool,
}

/// A multiplier for a law that gives `force` alone. It is never positive where it is held. Where it pulls, a fifth of
/// the law's force remains, so that the sum keeps the digits of the gap.
fn draw(force: f64, largest: f64, kind: &Kind, stream: &mut Stream) -> f64 {
    if kind.wanted == Wanted::Open {
        let pulls = kind.unknown && stream.sign() > 0.0;
        return if pulls {
            largest * stream.uniform(0.0, 2.0)
        } else {
            -force.max(0.0) * stream.uniform(0.0, 0.9)
        };
    }
    if kind.opened {
        return -largest * stream.uniform(1.2, 3.0);
    }
    match stream.index(3) {
        0 => 0.0,
        1 if kind.unknown => (-force).max(0.0) * stream.uniform(0.0, 0.8),
        _ => -largest * stream.log_uniform(1e-3, 3.0),
    }
}
