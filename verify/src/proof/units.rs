//! Change of units: lengths in millimetres instead of metres, forces as they are. Every parameter is
//! converted by its declared unit, so that a wrong unit is noticed too.

use contact_elements::runtime::Status;
use contact_elements::table::{GeometryPrograms, MasterDescription};
use contact_elements::{OUTPUT_SIZE, Parameter};

use crate::configurations::Configuration;
use crate::oracle::history::FrictionHistory;
use crate::oracle::multiplier::Multipliers;
use crate::oracle::pair::{Measure, Pair, Slave};
use crate::subject::{Answer, Input, Subject, Wanted};
use crate::tolerance::{UNITS, relative_error};

/// Metre to millimetre.
const UNIT: f64 = 1000.0;

/// Largest error of residual and tangent in millimetres against `answer`, the result in metres; or a text on
/// what cannot be converted.
pub(super) fn error(
    subject: &Subject,
    configuration: &Configuration,
    answer: &Answer,
) -> Result<f64, String> {
    let scaled = |values: &[f64]| values.iter().map(|v| v * UNIT).collect::<Vec<f64>>();
    let metres = subject.parameters(&configuration.pair);
    let millimetres = converted(subject, &metres)?;
    let converted = |zeta: [f64; 2]| in_millimetres(subject, zeta, &metres, &millimetres);
    let starts = configuration.start.iter();
    let start = starts
        .map(|&start| converted(start))
        .collect::<Result<Vec<_>, String>>()?;
    let remembered = configuration.friction.iter().map(|history| {
        Ok(FrictionHistory {
            anchor: converted(history.anchor)?,
            slip: history.slip * UNIT,
            ..*history
        })
    });
    let friction = remembered.collect::<Result<Vec<_>, String>>()?;
    let held = match &configuration.pair.multipliers {
        Multipliers::Held(values) => {
            Multipliers::Held(tractions(subject, values, &metres, &millimetres))
        }
        other => other.clone(),
    };
    let unknown = configuration.pair.multipliers.unknowns();
    let multipliers = tractions(subject, unknown, &metres, &millimetres);
    let found = subject.call(
        &Input {
            reference: &scaled(&configuration.reference),
            displacement: &scaled(&configuration.displacement),
            parameters: &millimetres,
            history: &subject.history(&start, &friction, &held),
            slave_row: &subject.slave_row(&configuration.pair),
            multipliers: &multipliers,
        },
        Wanted::BOTH,
    );
    if found.status() != answer.status() {
        return Err(format!("{:?} in millimetres", found.outcome));
    }
    let factor = measure_factor(&configuration.pair) * traction_factor(answer, &found)?;
    let residual: Vec<f64> = answer.residual.iter().map(|v| v * factor).collect();
    let tangent: Vec<f64> = answer.tangent.iter().map(|v| v * factor / UNIT).collect();
    let error = relative_error(&found.residual, &residual);
    Ok(if tangent.is_empty() {
        error
    } else {
        error.max(relative_error(&found.tangent, &tangent))
    })
}

/// Multipliers in millimetres: they have the unit of the law's traction.
fn tractions(subject: &Subject, values: &[f64], metres: &[f64], millimetres: &[f64]) -> Vec<f64> {
    let law = &subject.description.law.law;
    let traction = |gap: f64, parameters: &[f64]| {
        let own = parameters.iter().take(law.inputs.len() - 1);
        let inputs: Vec<f64> = [gap].iter().chain(own).copied().collect();
        let mut outputs = vec![0.0; law.outputs.len()];
        (law.compiled)(&inputs, &mut outputs);
        outputs[0]
    };
    let factor = traction(-UNIT, millimetres) / traction(-1.0, metres);
    values.iter().map(|value| value * factor).collect()
}

/// The parameters in millimetres.
fn converted(subject: &Subject, metres: &[f64]) -> Result<Vec<f64>, String> {
    let parameters = subject.description.descriptor.parameters;
    let value_of = |name: &str| {
        let mut named = parameters.iter().zip(metres);
        named.find_map(|(parameter, &value)| (text(parameter.name) == name).then_some(value))
    };
    let convert = |(parameter, value): (&Parameter, &f64)| {
        let unit = text(parameter.unit);
        match length_power(unit, value_of) {
            Some(power) => Ok(value * UNIT.powf(power)),
            None => Err(format!(
                "the unit `{unit}` of `{}` is no product of powers of force, length, rad and 1",
                text(parameter.name)
            )),
        }
    };
    parameters.iter().zip(metres).map(convert).collect()
}

/// Names and units in a descriptor end with a zero byte.
fn text(name: &str) -> &str {
    name.trim_end_matches('\0')
}

/// Power of length in a unit like `force/length^2`, read from left to right; an exponent is a number or the
/// name of a parameter.
fn length_power(unit: &str, value_of: impl Fn(&str) -> Option<f64>) -> Option<f64> {
    let (mut sum, mut sign, mut rest) = (0.0, 1.0, unit);
    loop {
        let end = rest.find(['*', '/']).unwrap_or(rest.len());
        let (factor, tail) = rest.split_at(end);
        let (name, exponent) = factor.split_once('^').unwrap_or((factor, "1"));
        let exponent = exponent.parse().ok().or_else(|| value_of(exponent))?;
        sum += match name {
            "length" => sign * exponent,
            "force" | "rad" | "1" => 0.0,
            _ => return None,
        };
        let Some(operator) = tail.chars().next() else {
            return Some(sum);
        };
        sign = if operator == '/' { -1.0 } else { 1.0 };
        rest = &tail[1..];
    }
}

/// Projected parameters in millimetres. Parameters of shape functions have no unit; those of a rigid
/// geometry are lengths or not, whichever puts its position where it was.
fn in_millimetres(
    subject: &Subject,
    start: [f64; 2],
    metres: &[f64],
    millimetres: &[f64],
) -> Result<[f64; 2], String> {
    let MasterDescription::Rigid(geometry) = subject.description.master else {
        return Ok(start);
    };
    let own = subject.description.layout.geometry;
    let slave = subject.template.slave_parameters();
    let count = subject.template.master_parameters();
    let d = subject.description.descriptor.dimension;
    let at = |start: [f64; 2], parameters: &[f64]| {
        position(
            geometry,
            &start[slave..slave + count],
            &parameters[own..],
            d,
        )
    };
    let expected = at(start, metres).map(|x| x * UNIT);
    for powers in [[0, 0], [0, 1], [1, 0], [1, 1]] {
        let mut scaled = start;
        for (value, power) in scaled[slave..].iter_mut().zip(powers) {
            *value *= UNIT.powi(power);
        }
        if relative_error(&at(scaled, millimetres), &expected) <= UNITS {
            return Ok(scaled);
        }
    }
    Err(format!(
        "the position of `{}` is no length, whatever the units of its coordinates",
        geometry.name
    ))
}

/// ρ(ζ) of a rigid geometry in its own frame, `d` components; its parameters come first in `parameters`.
fn position(geometry: &GeometryPrograms, zeta: &[f64], parameters: &[f64], d: usize) -> [f64; 3] {
    let program = &geometry.values;
    let own = parameters.iter().take(program.inputs.len() - zeta.len());
    let inputs: Vec<f64> = zeta.iter().chain(own).copied().collect();
    let mut outputs = vec![0.0; program.outputs.len()];
    (program.compiled)(&inputs, &mut outputs);
    std::array::from_fn(|k| if k < d { outputs[k] } else { 0.0 })
}

/// The factor of N in millimetres: N is a force, a force per length or a force per area, depending on the units of the law's
/// parameters.
fn traction_factor(answer: &Answer, found: &Answer) -> Result<f64, String> {
    let traction = |answer: &Answer, point: usize| answer.output[point * OUTPUT_SIZE + 2];
    let points = 0..answer.output.len() / OUTPUT_SIZE;
    let load = Status::Closed as i32..=Status::Slip as i32;
    let closed = |&q: &usize| load.contains(&(answer.output[q * OUTPUT_SIZE] as i32));
    let deepest = points
        .filter(closed)
        .max_by(|&a, &b| {
            traction(answer, a)
                .abs()
                .total_cmp(&traction(answer, b).abs())
        })
        .ok_or("no point is closed")?;
    let ratio = traction(found, deepest) / traction(answer, deepest);
    let lengths = -ratio.log(UNIT).round();
    if (0.0..=2.0).contains(&lengths) {
        Ok(UNIT.powf(-lengths))
    } else {
        Err(format!(
            "N is no force, nor one per length or area: in millimetres it is {ratio:e} times as large"
        ))
    }
}

/// The factor of length or area of an integrated slave.
fn measure_factor(pair: &Pair) -> f64 {
    match &pair.slave {
        Slave::Fixed {
            geometry, measure, ..
        } if *measure != Measure::Unit => UNIT.powi(geometry.shape.parameters() as i32),
        _ => 1.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_of_length() {
        let value_of = |name: &str| (name == "m").then_some(1.5);
        let power = |unit| length_power(unit, value_of);
        for (unit, expected) in [
            ("1", 0.0),
            ("rad", 0.0),
            ("force", 0.0),
            ("length", 1.0),
            ("1/length", -1.0),
            ("force/length^2", -2.0),
            ("force/length^m", -1.5),
            ("force/length/length", -2.0),
            ("force*length", 1.0),
            ("length^0.5", 0.5),
        ] {
            assert_eq!(power(unit), Some(expected), "{unit}");
        }
        for unit in ["MPa", "force/mm", "length^n", "", "force/"] {
            assert_eq!(power(unit), None, "{unit}");
        }
    }
}
