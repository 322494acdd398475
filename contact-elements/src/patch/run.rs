//! Both passes over the slave points of a patch.

use super::checked::Checked;
use super::closest_place;
use super::pair::{Answer, Pair};
use super::sums::Sums;
use crate::codes::{argument, request};
use crate::element::receiver::Summary;
use crate::error::Error;
use crate::point::values::Status;

/// Doubles of workspace per slave point: place, side and how its foot is found.
pub(crate) const WORKSPACE: usize = 6;

/// Finds the pair of every slave point and tries it, then adds all of them up.
pub(crate) fn run(
    checked: &Checked<'_>,
    sums: &Sums<'_>,
    memory: &mut [f64],
    bits: u32,
) -> Result<Summary, Error> {
    let reads = request::FREEZE_STATE & bits;
    let mut answer = Answer::new();
    for (slave, kept) in memory.chunks_exact_mut(WORKSPACE).enumerate() {
        let place = closest_place::find(checked, slave)?;
        let pair = match place {
            Some(place) => Pair::new(checked, slave, &place)?,
            None => None,
        };
        let Some(mut pair) = pair else {
            kept.fill(0.0);
            continue;
        };
        let tried = pair.evaluate(checked, &mut answer, reads);
        tried.map_err(|error| of_point(error, slave))?;
        pair.keep(kept);
    }
    add_up(checked, sums, memory, bits)
}

/// The second pass: what every pair gives is added.
fn add_up(
    checked: &Checked<'_>,
    sums: &Sums<'_>,
    memory: &[f64],
    bits: u32,
) -> Result<Summary, Error> {
    let (mut status, mut closed, mut energy) = (Status::Outside, 0, 0.0);
    let mut answer = Answer::new();
    sums.clear();
    for (slave, kept) in memory.chunks_exact(WORKSPACE).enumerate() {
        let Some(mut pair) = Pair::kept(checked, slave, kept)? else {
            sums.report(slave, None, &answer);
            continue;
        };
        let own = match pair.evaluate(checked, &mut answer, bits) {
            Ok(summary) => summary.status,
            Err(error) => error.status.ok_or(of_point(error, slave))?,
        };
        if closed == 0 && (own.is_closed() || status == Status::Outside) {
            status = own;
        }
        if own.is_closed() {
            closed += 1;
            energy += answer.energy;
            sums.add(&pair, &answer);
        }
        sums.report(slave, Some(&pair), &answer);
    }
    sums.energy(energy);
    Ok(Summary { status, closed })
}

/// The error of a pair as one of its slave point.
fn of_point(error: Error, slave: usize) -> Error {
    let argument = match error.status {
        Some(_) => argument::X,
        None => error.argument,
    };
    Error {
        argument,
        index: slave,
        ..error
    }
}
