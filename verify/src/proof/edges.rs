//! States where elements tend to fail: boundaries, tiny gaps, degenerate and bad data.

use contact_elements::{Error, Status};

use super::Finding;
use super::coverage::Seen;
use crate::configurations::edge_cases::{EdgeCase, Expected, edge_cases};
use crate::oracle::pair::{Master, Pair, Slave};
use crate::oracle::solve;
use crate::subject::{Answer, Input, Subject, Wanted};
use crate::tolerance::{EDGE, relative_error};

/// Runs every edge case through every exact element of its kind.
pub fn prove(subjects: &[Subject], seen: &mut Seen) -> Finding {
    let mut finding = Finding::default();
    for case in edge_cases() {
        let fitting: Vec<&Subject> = subjects.iter().filter(|s| fits(s, &case.pair)).collect();
        if fitting.is_empty() {
            finding.fail(format!("{}: no element of this kind", case.name));
        }
        for subject in fitting {
            one(&mut finding, seen, subject, &case);
        }
    }
    finding
}

/// Same kind of pair: geometries, gap, law; exact, with a tangent.
pub fn fits(subject: &Subject, pair: &Pair) -> bool {
    let template = &subject.template;
    subject.description.descriptor.tangent
        && !subject.description.tangent_plane
        && template.dimension == pair.dimension
        && template.gap == pair.gap
        && std::mem::discriminant(&template.law) == std::mem::discriminant(&pair.law)
        && tangential_kind(template) == tangential_kind(pair)
        && template.angle.map(|angle| angle.small) == pair.angle.map(|angle| angle.small)
        && slave_kind(&template.slave) == slave_kind(&pair.slave)
        && master_kind(&template.master) == master_kind(&pair.master)
}

fn tangential_kind(pair: &Pair) -> Option<String> {
    let tangential = pair.tangential.as_ref()?;
    let law = std::mem::discriminant(&tangential.law);
    let axis = tangential.axis.map(|axis| std::mem::discriminant(&axis));
    Some(format!("{law:?} {axis:?}"))
}

fn slave_kind(slave: &Slave) -> String {
    match slave {
        Slave::Point => "point".to_string(),
        Slave::Curve(geometry) => format!("curve {:?}", geometry.shape),
        Slave::Fixed {
            geometry,
            points,
            measure,
        } => format!("{:?} {} {measure:?}", geometry.shape, points.len()),
        Slave::Rows { rows, .. } => format!("rows {}", rows.len()),
    }
}

fn master_kind(master: &Master) -> String {
    match master {
        Master::Point => "point".to_string(),
        Master::Shape(geometry) => {
            format!("{:?} {}", geometry.shape, geometry.weights.is_some())
        }
        Master::Parametric { surface, .. } => {
            format!("parametric {:?}", std::mem::discriminant(surface))
        }
        Master::Distance { body, .. } => format!("distance {:?}", std::mem::discriminant(body)),
    }
}

fn one(finding: &mut Finding, seen: &mut Seen, subject: &Subject, case: &EdgeCase) {
    let zeros = vec![0.0; case.positions.len()];
    let answer = subject.call(
        &Input {
            reference: &case.positions,
            displacement: &zeros,
            parameters: &subject.parameters(&case.pair),
            history: &subject.history(&case.start, &case.friction, &subject.template.multipliers),
            slave_row: &subject.slave_row(&case.pair),
            multipliers: &[],
        },
        Wanted::BOTH,
    );
    let what = format!("{} ({})", case.name, subject.name());
    let status = answer.status();
    seen.statuses.extend(status.map(|status| status as i32));
    let fine = match case.expected {
        Expected::Closed => status == Some(Status::Closed),
        Expected::Stick => status == Some(Status::Stick),
        Expected::Slip => status == Some(Status::Slip),
        Expected::Open => status == Some(Status::Open) && answer.is_zero(),
        Expected::OnBoundary(_) => status.is_some_and(|status| {
            status.is_closed() || matches!(status, Status::Open | Status::Outside)
        }),
        Expected::Outside(_) => status == Some(Status::Outside) && answer.is_zero(),
        Expected::Degenerate => {
            let failed = matches!(
                status,
                Some(Status::Degenerate | Status::NotUnique | Status::NotConverged)
            );
            failed && answer.is_untouched()
        }
        Expected::BadInput => {
            let refused = |outcome: Result<_, Error>| outcome.is_err_and(|e| !e.is_cut_back());
            answer.outcome.is_some_and(refused) && answer.is_untouched()
        }
    };
    if !fine {
        finding.fail(format!(
            "{what}: {:?} instead of {:?}",
            answer.outcome, case.expected
        ));
    } else if status.is_some_and(Status::is_closed) {
        compare(finding, case, &answer, &what);
    } else {
        finding.pass();
    }
}

fn compare(finding: &mut Finding, case: &EdgeCase, answer: &Answer, what: &str) {
    let zeros = vec![0.0; case.positions.len()];
    match solve::evaluate(&case.pair, &case.state(&zeros)) {
        Ok(truth) if truth.residual.iter().any(|&value| value != 0.0) => {
            let residual = relative_error(&answer.residual, &truth.residual);
            let tangent = relative_error(&answer.tangent, &truth.tangent);
            finding.compare(what, residual.max(tangent), EDGE);
        }
        // g = 0 to rounding: the oracle may call open what the element calls closed
        Ok(_) => finding.pass(),
        Err(error) => finding.fail(format!("{what}: the oracle gave no answer: {error}")),
    }
}
