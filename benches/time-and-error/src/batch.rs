//! Calls for single contacts against one call for all of them.

use std::hint::black_box;

use contact_elements::abi::{Batch, element_evaluate_batch};
use contact_elements::{Registered, code, request};
use contact_verify::configurations::Wanted;

use crate::Failure;
use crate::case::{Answer, Case, Request};
use crate::iterations::pass;
use crate::report::{Section, number, spread};
use crate::states::Catalogue;
use crate::timing::{Contender, Effort, in_turns};

const ELEMENTS: [&str; 4] = [
    "PointQuad4",
    "PointQuad9",
    "Line2Line2Beams",
    "PointQuad4Coulomb",
];
/// Contacts of a batch: K of them all stays in the cache.
const CONTACTS: usize = 128;

/// Arrays of a batch.
struct Arrays {
    descriptor: &'static Registered,
    count: usize,
    x: Vec<f64>,
    parameters: Vec<f64>,
    history: Vec<f64>,
    residual: Vec<f64>,
    tangent: Vec<f64>,
    status: Vec<i32>,
}

impl Arrays {
    fn new(cases: &[Case]) -> Self {
        let one = Answer::of(&cases[0]);
        let gather = |of: fn(&Case) -> &Vec<f64>| cases.iter().flat_map(of).copied().collect();
        Self {
            descriptor: cases[0].descriptor,
            count: cases.len(),
            x: gather(|case| &case.x),
            parameters: gather(|case| &case.parameters),
            history: gather(|case| &case.history),
            residual: vec![0.0; cases.len() * one.residual.len()],
            tangent: vec![0.0; cases.len() * one.tangent.len()],
            status: vec![0; cases.len()],
        }
    }

    fn evaluate(&mut self, wanted: Request) -> i32 {
        let mut batch = Batch::EMPTY;
        batch.request = request::RESIDUAL | wanted.bits;
        if wanted.tangent {
            batch.request |= request::TANGENT;
        }
        batch.parameter_count = (self.parameters.len() / self.count) as i32;
        batch.parameter_element_stride = i64::from(batch.parameter_count);
        batch.x = self.x.as_ptr();
        batch.parameters = self.parameters.as_ptr();
        batch.history_accepted = self.history.as_ptr();
        batch.f = self.residual.as_mut_ptr();
        batch.k = self.tangent.as_mut_ptr();
        batch.status = self.status.as_mut_ptr();
        // SAFETY: every array has the length that the interface asks for so many contacts of the element.
        let code =
            unsafe { element_evaluate_batch(self.descriptor, self.count as i64, &mut batch) };
        black_box(&mut *self);
        code
    }
}

/// One section.
///
/// # Errors
/// Where a state cannot be made or a batch differs from the single calls.
pub fn sections(effort: &Effort) -> Result<Vec<Section>, Failure> {
    let all = Catalogue::new()?;
    let mut section = Section::new(
        "batch",
        "One call for many contacts",
        &[
            "element",
            "what",
            "ns, single calls",
            "quartiles",
            "ns, batch",
            "quartiles of the batch",
            "ratio",
            "quartiles of the ratio",
            "ratio of the least",
        ],
    );
    for element in ELEMENTS {
        for (what, wanted, asked) in [
            ("R and K", Wanted::Closed, Request::BOTH),
            ("R and K, projection given", Wanted::Closed, Request::GIVEN),
            ("R", Wanted::Closed, Request::RESIDUAL),
            ("open", Wanted::Open, Request::BOTH),
            ("open, screened", Wanted::Open, Request::SCREENED),
        ] {
            let states = all.cases(element, wanted, effort.states)?;
            if asked.bits & !states[0].descriptor.requests() != 0 {
                continue;
            }
            let states: Vec<Case> = if asked.bits & request::PROJECTION_GIVEN == 0 {
                states
            } else {
                states
                    .iter()
                    .map(Case::projected)
                    .collect::<Result<_, _>>()?
            };
            let cases: Vec<Case> = states.iter().cycle().take(CONTACTS).cloned().collect();
            let mut row = vec![element.to_string(), what.to_string()];
            row.extend(compare(&cases, asked, effort)?);
            section.row(row);
        }
    }
    section.note(&format!(
        "{CONTACTS} contacts, dense R and K of each, one thread. Single calls reuse one K, the batch writes all of them. \
         Screened: the single calls project, the batch need not."
    ));
    Ok(vec![section])
}

fn compare(cases: &[Case], request: Request, effort: &Effort) -> Result<Vec<String>, Failure> {
    let mut arrays = Arrays::new(cases);
    if arrays.evaluate(request) != code::SUCCESS {
        return Err(format!("{}: the batch failed", cases[0].name()).into());
    }
    must_agree(cases, request, &arrays)?;
    let together = Contender::new("batch", cases.len(), || {
        arrays.evaluate(request);
    });
    let timing = in_turns(vec![pass("single", cases, request), together], effort);
    let columns = [
        timing.time("single"),
        timing.time("batch"),
        timing.ratio("batch", "single"),
    ];
    let mut row: Vec<String> = columns.into_iter().flat_map(spread).collect();
    row.push(number(timing.ratio_of_least("batch", "single")));
    Ok(row)
}

/// A batch may round otherwise than a single call, not more.
fn must_agree(cases: &[Case], request: Request, arrays: &Arrays) -> Result<(), Failure> {
    const LIMIT: f64 = 1e-11;
    let mut answer = Answer::of(&cases[0]);
    let n = answer.residual.len();
    for (case, found) in cases.iter().zip(arrays.residual.chunks(n)) {
        case.evaluate(request, &mut answer);
        let largest = |values: &[f64]| values.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
        let both = answer.residual.iter().zip(found);
        let difference = both.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        if difference > LIMIT * largest(&answer.residual) {
            return Err(format!("{}: batch and single call differ", case.name()).into());
        }
    }
    Ok(())
}
