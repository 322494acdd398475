//! Tables against the emitted code (bit for bit) and against duals (derivatives).

mod inputs;
mod sliding;

use contact_elements::table::{
    GeometryPrograms, LawPrograms, MasterDescription, SlaveDescription, Table,
    TangentialLawPrograms,
};

use super::Finding;
use crate::interpret::interpret;
use crate::subject::Subject;
use crate::tolerance::{DERIVATIVES, relative_error};
use inputs::{TRIES, derivative, inputs};

/// The geometries of the built-in library and of the subjects, each once.
fn geometries(subjects: &[Subject]) -> Vec<&'static GeometryPrograms> {
    let mut list: Vec<&GeometryPrograms> = contact_elements::geometry::GEOMETRIES.to_vec();
    for subject in subjects {
        let slave = match subject.description.slave {
            SlaveDescription::Projected(geometry)
            | SlaveDescription::Given(geometry)
            | SlaveDescription::Integrated(geometry, _) => Some(geometry),
            SlaveDescription::Point | SlaveDescription::Interpolated => None,
        };
        let master = match subject.description.master {
            MasterDescription::Shape(geometry)
            | MasterDescription::Rigid(geometry)
            | MasterDescription::Distance(geometry) => Some(geometry),
            MasterDescription::Point => None,
        };
        for geometry in slave.into_iter().chain(master) {
            if list.iter().all(|known| known.name != geometry.name) {
                list.push(geometry);
            }
        }
    }
    list
}

/// The laws of the built-in library and of the subjects, each once.
fn laws(subjects: &[Subject]) -> Vec<&'static LawPrograms> {
    let mut list: Vec<&LawPrograms> = contact_elements::laws::LAWS.to_vec();
    for subject in subjects {
        let law = subject.description.law;
        if list.iter().all(|known| known.name != law.name) {
            list.push(law);
        }
    }
    list
}

/// The tangential laws of the subjects, each once.
fn tangential_laws(subjects: &[Subject]) -> Vec<&'static TangentialLawPrograms> {
    let mut list: Vec<&TangentialLawPrograms> = vec![];
    let rolling = subjects.iter().filter_map(|s| s.description.rolling);
    let tangential = subjects.iter().filter_map(|s| s.description.tangential);
    for law in tangential.chain(rolling.map(|own| own.law)) {
        if list.iter().all(|known| known.name != law.name) {
            list.push(law);
        }
    }
    list
}

/// All programs of the built-in library and of the subjects.
pub fn prove(subjects: &[Subject], seed: u64) -> Finding {
    let mut finding = Finding::default();
    for geometry in geometries(subjects) {
        for program in [
            Some(&geometry.values),
            geometry.third.as_ref(),
            geometry.projection.as_ref(),
        ]
        .into_iter()
        .flatten()
        {
            bits(&mut finding, geometry.name, program, seed);
        }
        geometry_derivatives(&mut finding, geometry, seed);
    }
    for law in laws(subjects) {
        for program in [Some(&law.law), Some(&law.active), law.valid.as_ref()]
            .into_iter()
            .flatten()
        {
            bits(&mut finding, law.name, program, seed);
        }
        law_derivatives(&mut finding, law, seed);
    }
    for law in tangential_laws(subjects) {
        bits(&mut finding, law.name, &law.friction, seed);
        if let Some(sliding) = &law.sliding {
            bits(&mut finding, law.name, sliding, seed);
        }
        sliding::derivatives(&mut finding, law, seed);
    }
    for subject in subjects {
        for program in subject.programs() {
            bits(&mut finding, subject.name(), program, seed);
        }
    }
    finding
}

fn bits(finding: &mut Finding, owner: &str, program: &Table, seed: u64) {
    for index in 0..TRIES {
        let inputs = inputs(program, seed, index);
        let table = interpret(program, &inputs, None);
        let mut compiled = vec![f64::NAN; program.outputs.len()];
        (program.compiled)(&inputs, &mut compiled);
        let differs = table
            .iter()
            .zip(&compiled)
            .position(|(a, b)| a.to_bits() != b.to_bits());
        match differs {
            None => finding.pass(),
            Some(output) => finding.fail(format!(
                "{owner}.{}: output {} of the emitted code differs from its table",
                program.name, program.outputs[output].0
            )),
        }
    }
}

/// Number of outputs whose names begin with `prefix_`.
fn count(program: &Table, prefix: &str) -> usize {
    let is_block = |name: &str| {
        name.strip_prefix(prefix).is_some_and(|rest| {
            rest.starts_with('_') && rest[1..].starts_with(|c: char| c.is_ascii_digit())
        })
    };
    program
        .outputs
        .iter()
        .filter(|(name, _)| is_block(name))
        .count()
}

fn geometry_derivatives(finding: &mut Finding, geometry: &GeometryPrograms, seed: u64) {
    let program = &geometry.values;
    if geometry.third.is_none() {
        return distance_gradient(finding, geometry, seed);
    }
    let p = program.inputs.len().min(coordinates(program));
    let width = count(program, "n").max(count(program, "rho"));
    for index in 0..TRIES {
        let inputs = inputs(program, seed, index);
        let values = interpret(program, &inputs, None);
        let third = geometry
            .third
            .as_ref()
            .map(|third| interpret(third, &inputs, None));
        let row = |order: usize, number: usize| -> &[f64] {
            let before = [0, 1, 1 + p][order];
            &values[(before + number) * width..(before + number + 1) * width]
        };
        for i in 0..p {
            let slopes = derivative(program, &inputs, i);
            let found = |row: usize| &slopes[row * width..(row + 1) * width];
            let name = geometry.name;
            let first = relative_error(row(1, i), found(0));
            finding.compare(&format!("{name}: first derivative"), first, DERIVATIVES);
            for j in 0..p {
                let second = relative_error(row(2, i + j), found(1 + j));
                finding.compare(&format!("{name}: second derivative"), second, DERIVATIVES);
            }
            for h in 0..p * (p + 1) / 2 {
                let third = third.as_ref().map_or(&[][..], |third| {
                    &third[(h + i) * width..(h + i + 1) * width]
                });
                let error = relative_error(third, found(1 + p + h));
                finding.compare(&format!("{name}: third derivative"), error, DERIVATIVES);
            }
        }
    }
}

/// Number of parameters: from the count of derivative blocks.
fn coordinates(program: &Table) -> usize {
    let width = count(program, "n").max(count(program, "rho"));
    let first = count(program, "d1").max(count(program, "rho_i"));
    first / width.max(1)
}

fn distance_gradient(finding: &mut Finding, geometry: &GeometryPrograms, seed: u64) {
    let program = &geometry.values;
    let d = program.outputs.len() - 2;
    for index in 0..TRIES {
        let mut inputs = inputs(program, seed, index);
        let orientation = inputs.len() - 2;
        inputs[orientation] = 1.0;
        let values = interpret(program, &inputs, None);
        let gradient: Vec<f64> = (0..d).map(|k| derivative(program, &inputs, k)[d]).collect();
        let error = relative_error(&values[..d], &gradient);
        finding.compare(&format!("{}: gradient", geometry.name), error, DERIVATIVES);
    }
}

/// The law acts at these inputs, or at least is defined there.
fn is_defined(law: &LawPrograms, inputs: &[f64]) -> bool {
    match &law.valid {
        Some(valid) => interpret(valid, inputs, None)[0] > 0.0,
        None => interpret(&law.active, inputs, None)[0] > 0.0,
    }
}

fn law_derivatives(finding: &mut Finding, law: &LawPrograms, seed: u64) {
    for index in 0..TRIES {
        let mut inputs = inputs(&law.law, seed, index);
        if !is_defined(law, &inputs) {
            inputs[0] = -inputs[0];
        }
        let values = interpret(&law.law, &inputs, None);
        let slopes = derivative(&law.law, &inputs, 0);
        let slope = relative_error(&values[1..2], &slopes[0..1]);
        finding.compare(&format!("{}: N'", law.name), slope, DERIVATIVES);
        if values.len() > 2 {
            let traction = relative_error(&values[0..1], &slopes[2..3]);
            finding.compare(&format!("{}: N = W'", law.name), traction, DERIVATIVES);
        }
    }
}

#[cfg(test)]
mod tests {
    use num_dual::DualNum;

    use super::*;

    /// A table whose constant is off by one unit in its last place is noticed.
    #[test]
    fn a_wrong_table_is_noticed() {
        use contact_elements::table::Operation;
        let good = contact_elements::geometry::GEOMETRIES[0].values;
        let mut finding = Finding::default();
        bits(&mut finding, "good", &good, 1);
        assert_eq!(finding.failed, 0);
        let changed: Vec<Operation> = good
            .operations
            .iter()
            .map(|operation| match *operation {
                Operation::Constant(value) => {
                    Operation::Constant(f64::from_bits(value.to_bits() + 1))
                }
                other => other,
            })
            .collect();
        let bad = Table {
            operations: Box::leak(changed.into_boxed_slice()),
            ..good
        };
        bits(&mut finding, "bad", &bad, 1);
        assert!(finding.failed > 0);
    }

    /// The duals see a derivative that is off: 2 x against the slope of x².
    #[test]
    fn duals_carry_derivatives() {
        let dual = num_dual::Dual64::new(3.0, 1.0);
        assert_eq!(DualNum::powi(&dual, 2).eps, 6.0);
    }
}
