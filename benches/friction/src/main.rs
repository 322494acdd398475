//! What friction costs: every frictional element beside the frictionless one of the same pair, on the same states,
//! in one process, through the interface that a host uses. Ratios only: the machine's load moves all times.

use std::hint::black_box;
use std::time::Instant;

use contact_elements::{Evaluation, OUTPUT_SIZE, evaluate};
use contact_verify::configurations::{Configuration, Generator, Wanted};
use contact_verify::subject::{self, Subject};

/// Frictionless and frictional element of a pair.
const PAIRS: [(&str, &str); 16] = [
    ("PointTri3", "PointTri3Coulomb"),
    ("PointQuad4", "PointQuad4Coulomb"),
    ("PointQuad4", "PointQuad4Orthotropic"),
    ("PointQuad9", "PointQuad9Coulomb"),
    ("PointBezierSurface2", "PointBezierSurface2Coulomb"),
    ("PointRationalSurface2", "PointRationalSurface2Coulomb"),
    ("PointPlane", "PointPlaneCoulomb"),
    ("PointCylinder", "PointCylinderCoulomb"),
    ("PointTorus", "PointTorusCoulomb"),
    ("PointHermite", "PointHermiteCoulomb"),
    ("Line2Line2Beams", "Line2Line2BeamsCoulomb"),
    ("HermiteHermiteBeams", "HermiteHermiteBeamsCoulomb"),
    ("HermiteQuad4AtPoint", "HermiteQuad4OrthotropicAtPoint"),
    ("Quad4Quad4", "Quad4Quad4Coulomb"),
    ("PointLine3In2d", "PointLine3Coulomb2d"),
    ("PointCircle2d", "PointCircleCoulomb2d"),
];
/// States per status.
const STATES: u64 = 40;
/// Rounds whose median counts.
const ROUNDS: usize = 31;
/// Evaluations of every state per round.
const REPEATS: usize = 40;

/// One state of one element, ready to be evaluated.
struct Case {
    subject: &'static str,
    descriptor: &'static contact_elements::Registered,
    x: Vec<f64>,
    u: Vec<f64>,
    parameters: Vec<f64>,
    history: Vec<f64>,
}

impl Case {
    fn new(subject: &Subject, configuration: &Configuration) -> Self {
        Self {
            subject: subject.name(),
            descriptor: subject.description.descriptor,
            x: configuration.reference.clone(),
            u: configuration.displacement.clone(),
            parameters: subject.parameters(&configuration.pair),
            history: subject.history_of(configuration),
        }
    }

    /// Evaluates R, and K on request; the outputs are kept from the optimiser.
    fn evaluate(&self, residual: &mut [f64], tangent: &mut [f64], output: &mut [f64]) {
        let n = self.x.len();
        let points = self.descriptor.points;
        let outcome = evaluate(
            self.descriptor,
            &mut Evaluation {
                x: &self.x,
                u: &self.u,
                parameters: &self.parameters,
                history: &self.history,
                residual: &mut residual[..n],
                tangent: if tangent.is_empty() {
                    tangent
                } else {
                    &mut tangent[..n * n]
                },
                output: &mut output[..points * OUTPUT_SIZE],
                ..Evaluation::default()
            },
        );
        assert!(outcome.is_ok_and(|summary| summary.closed > 0), "{}", self.subject);
        black_box(outcome);
    }
}

/// Nanoseconds per evaluation of all cases.
fn time(cases: &[Case], with_tangent: bool) -> f64 {
    let mut residual = vec![0.0; 200];
    let mut tangent = vec![0.0; if with_tangent { 40_000 } else { 0 }];
    let mut output = vec![0.0; 40 * OUTPUT_SIZE];
    let start = Instant::now();
    for _ in 0..REPEATS {
        for case in cases {
            case.evaluate(&mut residual, &mut tangent, &mut output);
        }
    }
    start.elapsed().as_secs_f64() * 1e9 / (REPEATS * cases.len()) as f64
}

/// Medians of both and of their ratio, taken in turns.
fn compare(without: &[Case], with: &[Case], tangent: bool) -> [f64; 3] {
    let mut rounds = Vec::new();
    for _ in 0..ROUNDS {
        let (first, last) = (time(without, tangent), time(with, tangent));
        rounds.push([first, last, last / first]);
    }
    std::array::from_fn(|k| {
        let mut column: Vec<f64> = rounds.iter().map(|round| round[k]).collect();
        column.sort_by(f64::total_cmp);
        column[ROUNDS / 2]
    })
}

fn main() {
    let subjects = subject::built_in().expect("the built-in elements");
    let find = |name: &str| {
        let found = subjects.iter().find(|subject| subject.name() == name);
        found.unwrap_or_else(|| panic!("{name} is not a built-in element"))
    };
    println!(
        "| frictional element | status | without, ns | R and K, ns | ratio | R alone, ratio |"
    );
    println!("|---|---|---:|---:|---:|---:|");
    for (without, with) in PAIRS {
        let (without, with) = (find(without), find(with));
        for (wanted, status) in [(Wanted::Stick, "stick"), (Wanted::Slip, "slip")] {
            let generator = Generator::new(with.template.clone(), 1);
            let states: Vec<Configuration> = (0..STATES)
                .filter_map(|index| generator.generate(wanted, index).ok())
                .collect();
            let plain = |configuration: &Configuration| {
                let mut configuration = configuration.clone();
                configuration.pair.tangential = None;
                Case::new(without, &configuration)
            };
            let without: Vec<Case> = states.iter().map(plain).collect();
            let cases: Vec<Case> = states.iter().map(|state| Case::new(with, state)).collect();
            let [before, after, ratio] = compare(&without, &cases, true);
            let [.., residual] = compare(&without, &cases, false);
            println!(
                "| {} | {status} | {before:.0} | {after:.0} | {ratio:.2} | {residual:.2} |",
                with.name()
            );
        }
    }
}
