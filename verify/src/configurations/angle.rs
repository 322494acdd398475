//! Windows of angles of a state: most of them with the angle inside, so that the contact is weighted.

use super::random::Stream;
use super::state::Configuration;
use crate::oracle::angle::sine_squared;
use crate::oracle::kinematics::Frame;
use crate::oracle::pair::Angle;
use crate::oracle::solve::{PointReport, PointStatus};

/// Least sin²θ of a state: smaller angles keep too few digits to judge by.
const LEAST_SQUARE: f64 = 0.01;
/// Least position of a single point in a window: the weight grows with its cube. The deepest of several points needs a
/// larger one, so that no shallow point outweighs it: shallow gaps keep too few digits.
const LEAST_POSITION: [f64; 2] = [0.02, 0.3];
/// Largest change of that position, relative to it, with a relative change of sin²θ: how many times its rounding
/// the weight has.
const STEEPEST: f64 = 10.0;
/// Least share of the widest possible window where the position is near one: w'' is a small difference there.
const WIDE: f64 = 0.3;
/// The state where no point is projected.
const ANY_WINDOW: [f64; 2] = [0.2, 1.2];

/// Draws the window. With `silent` no point gets a weight.
pub(super) fn equip(
    configuration: &mut Configuration,
    silent: bool,
    stream: &mut Stream,
) -> Option<()> {
    let Some(angle) = configuration.pair.angle else {
        return Some(());
    };
    let squares: Vec<(f64, f64)> = configuration
        .points
        .iter()
        .enumerate()
        .filter(|(_, point)| is_projected(point))
        .map(|(q, point)| (point.gap, square_at(configuration, q, point)))
        .collect();
    let deepest = squares.iter().min_by(|a, b| a.0.total_cmp(&b.0));
    let Some(&(_, square)) = deepest else {
        let window = ANY_WINDOW;
        configuration.pair.angle = Some(Angle { window, ..angle });
        return Some(());
    };
    let all = || squares.iter().map(|&(_, square)| square);
    let (least, most) = (all().fold(1.0, f64::min), all().fold(0.0, f64::max));
    let lowest = LEAST_POSITION[usize::from(configuration.points.len() > 1)];
    let (square, position) = match (silent, angle.small) {
        (true, true) => (least, -stream.log_uniform(1e-3, 1.0)),
        (true, false) => (most, -stream.log_uniform(1e-3, 1.0)),
        (false, _) => (square, draw_position(lowest, stream)),
    };
    if position > 0.0 && least < LEAST_SQUARE {
        return None;
    }
    let window = around(square, position, angle.small, stream)?;
    configuration.pair.angle = Some(Angle { window, ..angle });
    Some(())
}

fn is_projected(point: &PointReport) -> bool {
    matches!(point.status, PointStatus::Open | PointStatus::Closed)
}

fn square_at(configuration: &Configuration, q: usize, point: &PointReport) -> f64 {
    let Configuration {
        pair,
        reference,
        displacement,
        ..
    } = configuration;
    let frame = Frame::new(pair, q, reference, displacement);
    let relative = frame.relative(&frame.nodes, point.zeta);
    sine_squared(&frame, &frame.nodes, &relative)
}

/// Where in the window, from no weight to all of it: inside, near either end, beyond the upper one.
fn draw_position(lowest: f64, stream: &mut Stream) -> f64 {
    match stream.index(8) {
        0 => 1.0 + stream.log_uniform(1e-3, 1.0),
        1 => 1.0 - stream.log_uniform(1e-9, 1e-3),
        2 => stream.log_uniform(lowest, 0.4),
        _ => stream.uniform(lowest.max(0.1), 0.95),
    }
}

/// The window in which sin²θ = `square` has the position. Some windows reach to parallel curves or to a right angle.
/// `None` where the window would reach beyond them.
fn around(square: f64, position: f64, small: bool, stream: &mut Stream) -> Option<[f64; 2]> {
    let below = if small { 1.0 - position } else { position };
    let most = match (below > 0.0, below < 1.0) {
        (true, true) => (square / below).min((1.0 - square) / (1.0 - below)),
        (true, false) => square / below,
        (false, _) => (1.0 - square) / (1.0 - below),
    };
    let share = match stream.index(6) {
        0 => 1.0,
        _ if position > 0.9 => stream.uniform(WIDE, 1.0),
        _ => stream.log_uniform(0.05, 0.95),
    };
    let width = most * share;
    let low = (square - below * width).clamp(0.0, 1.0);
    let ends = [low, (low + width).min(1.0)].map(|square| square.sqrt().asin());
    let is_flat = position <= 0.0 || square <= STEEPEST * width * position.min(1.0);
    (is_flat && width > 1e-4).then_some(ends)
}
