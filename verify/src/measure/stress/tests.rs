use contact_elements::runtime::Status;

use super::errors::{Verdict, call, judge};
use super::report::Summary;
use super::scene::{Case, Load};
use super::sweeps::SWEEPS;
use super::*;
use crate::subject::{self, Answer};

fn named(names: &[&str]) -> Vec<Subject> {
    let mut subjects = subject::built_in().unwrap();
    subjects.retain(|subject| names.contains(&subject.name()));
    assert_eq!(subjects.len(), names.len());
    subjects
}

fn closed() -> (Case, Answer) {
    let subject = &named(&["PointQuad4Coulomb"])[0];
    let mut stream = Stream::new(1, 2, 3);
    let scene = Scene::typical(&subject.template, Load::Utilised(3.0), &mut stream);
    let case = scene.case(&mut stream).unwrap();
    let answer = call(subject, &case);
    assert_eq!(answer.status(), Some(Status::Slip));
    (case, answer)
}

fn verdict(case: &Case, answer: &Answer) -> Verdict {
    judge(case, answer, &mut Stream::new(1, 2, 4))
        .unwrap()
        .verdict
}

fn fails(case: &Case, answer: &Answer, why: &str) {
    match verdict(case, answer) {
        Verdict::Failed(reason) => assert!(reason.contains(why), "{reason}"),
        other => panic!("{why}: {other:?}"),
    }
}

#[test]
fn what_is_wrong_is_noticed() {
    let (case, answer) = closed();
    assert_eq!(verdict(&case, &answer), Verdict::Exact);
    let top = |values: &[f64]| values.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
    let mut off = answer.clone();
    off.residual[4] += 2e-13 * top(&answer.residual);
    fails(&case, &off, "beyond the limit");
    let mut off = answer.clone();
    off.tangent[17] += 2e-13 * top(&answer.tangent);
    fails(&case, &off, "beyond the limit");
    let mut broken = answer.clone();
    broken.energy[0] = f64::NAN;
    fails(&case, &broken, "energy is not finite");
    let mut broken = answer.clone();
    broken.tangent[3] = f64::INFINITY;
    fails(&case, &broken, "tangent is not finite");
}

#[test]
fn another_status_is_noticed() {
    let (case, answer) = closed();
    for status in [
        Status::Stick,
        Status::NotConverged,
        Status::Degenerate,
        Status::Open,
    ] {
        let mut other = answer.clone();
        if let Some(Ok(summary)) = &mut other.outcome {
            summary.status = status;
        }
        let why = if status == Status::Open {
            "but not zero"
        } else {
            "instead of"
        };
        fails(&case, &other, why);
    }
}

#[test]
fn where_the_data_decide_nothing_a_refusal_will_do() {
    let subject = &named(&["PointQuad4"])[0];
    let mut stream = Stream::new(1, 2, 3);
    let mut scene = Scene::typical(&subject.template, Load::Normal, &mut stream);
    scene.gap = 0.0;
    let case = scene.case(&mut stream).unwrap();
    let answer = call(subject, &case);
    assert!(matches!(
        verdict(&case, &answer),
        Verdict::Exact | Verdict::Undecided
    ));
    let mut refused = answer.clone();
    if let Some(Ok(summary)) = &mut refused.outcome {
        summary.status = Status::NotConverged;
    }
    assert_eq!(verdict(&case, &refused), Verdict::Undecided);
}

/// Newton's method once ended a step early here: the solve loses digits, so its convergence is not quadratic.
#[test]
fn nearly_parallel_tangents_are_solved_down_to_rounding() {
    let subject = &named(&["PointQuad4"])[0];
    let skew = SWEEPS.iter().find(|sweep| sweep.name == "skew").unwrap();
    for sine in [1e-3, 1e-4, 2e-5] {
        let mut stream = Stream::new(SEED, 0, 0);
        let mut scene = Scene::typical(&subject.template, Load::Normal, &mut stream);
        (skew.deform)(&mut scene, sine).unwrap();
        scene.start = 1e-2;
        let case = scene.case(&mut stream).unwrap();
        let answer = call(subject, &case);
        assert_eq!(verdict(&case, &answer), Verdict::Exact, "{sine:e}");
    }
}

#[test]
fn every_series_names_an_element_that_can_be_evaluated() {
    let subjects = subject::built_in().unwrap();
    for (sweep, series) in SWEEPS
        .iter()
        .flat_map(|sweep| sweep.series.iter().map(move |s| (sweep, s)))
    {
        let subject = subjects
            .iter()
            .find(|subject| subject.name() == series.element);
        let subject = subject.unwrap_or_else(|| panic!("{}: {}", sweep.name, series.element));
        assert!(truth::is_supported(&subject.template), "{}", series.element);
        assert!(subject.description.descriptor.tangent && !subject.description.tangent_plane);
        assert_eq!(
            subject.description.descriptor.friction,
            series.load != Load::Normal
        );
    }
}

#[test]
fn a_few_states_of_every_sweep_pass() {
    let subjects = named(&[
        "PointQuad4",
        "PointQuad4Coulomb",
        "PointLine3Coulomb2d",
        "PointHermite",
        "Line2Line2Beams",
        "PointRationalCurve2In2d",
    ]);
    let extent = Extent {
        points: 3,
        copies: 1,
    };
    for sweep in SWEEPS {
        let outcome = run(sweep, &subjects, extent, &|| {});
        let summary = Summary::new(&outcome);
        assert!(summary.curves > 0, "{}", sweep.name);
        assert!(
            summary.exact >= summary.curves,
            "{}: too little is judged",
            sweep.name
        );
        assert!(summary.passed(), "{:?}", summary.failures);
    }
}
