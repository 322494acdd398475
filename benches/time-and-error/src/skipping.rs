//! What is gained by leaving work out.

use contact_bench_elements::PointCylinderByNewton;
use contact_elements::request;
use contact_verify::configurations::Wanted;

use crate::Failure;
use crate::case::{Case, Request};
use crate::instructions::{count, counted};
use crate::iterations::pass;
use crate::report::{Section, number, spread};
use crate::states::Catalogue;
use crate::timing::{Effort, in_turns};

/// What all others are compared with.
const FULL: &str = "full: R and K, projected from a start";

/// A row of the table: what is left out, element, status, request, what it is compared with.
type Row = (&'static str, &'static str, Wanted, Request, &'static str);

const SYMMETRISED: Request = Request {
    tangent: true,
    bits: request::SYMMETRISE,
};
const CYLINDER: &str = "rigid cylinder by Newton's method";
const ROWS: [Row; 18] = [
    (FULL, "PointQuad4", Wanted::Closed, Request::BOTH, FULL),
    (
        "projection given",
        "PointQuad4",
        Wanted::Closed,
        Request::GIVEN,
        FULL,
    ),
    (
        "R alone",
        "PointQuad4",
        Wanted::Closed,
        Request::RESIDUAL,
        FULL,
    ),
    (
        "R alone, element without tangent",
        "PointQuad4Residual",
        Wanted::Closed,
        Request::RESIDUAL,
        FULL,
    ),
    ("open", "PointQuad4", Wanted::Open, Request::BOTH, FULL),
    (
        "outside the facet",
        "PointQuad4",
        Wanted::Outside,
        Request::BOTH,
        FULL,
    ),
    (
        "tangent plane",
        "PointQuad4TangentPlane",
        Wanted::Closed,
        Request::BOTH,
        FULL,
    ),
    (
        "flat facet",
        "PointTri3",
        Wanted::Closed,
        Request::BOTH,
        FULL,
    ),
    (
        "rigid plane",
        "PointPlane",
        Wanted::Closed,
        Request::BOTH,
        FULL,
    ),
    (
        "rigid plane by its distance",
        "PointPlaneDistance",
        Wanted::Closed,
        Request::BOTH,
        FULL,
    ),
    (
        CYLINDER,
        "PointCylinder",
        Wanted::Closed,
        Request::BOTH,
        FULL,
    ),
    (
        "rigid cylinder, projection in closed form",
        "PointCylinder",
        Wanted::Closed,
        Request::BOTH,
        CYLINDER,
    ),
    (
        "rigid cylinder by its distance",
        "PointCylinderDistance",
        Wanted::Closed,
        Request::BOTH,
        CYLINDER,
    ),
    (
        "friction, sticks",
        "PointQuad4Coulomb",
        Wanted::Stick,
        Request::BOTH,
        FULL,
    ),
    (
        "friction, slips",
        "PointQuad4Coulomb",
        Wanted::Slip,
        Request::BOTH,
        FULL,
    ),
    (
        "friction, R alone",
        "PointQuad4Coulomb",
        Wanted::Slip,
        Request::RESIDUAL,
        FULL,
    ),
    (
        "friction, open",
        "PointQuad4Coulomb",
        Wanted::Open,
        Request::BOTH,
        FULL,
    ),
    (
        "K symmetrised on request",
        "PointQuad4",
        Wanted::Closed,
        SYMMETRISED,
        FULL,
    ),
];

/// States whose instructions are counted: the first ones of those that are timed.
const COUNTED: u64 = 10;
/// The option under which [`count_row`] is called.
pub const COUNT: &str = "--count-row";

/// One section.
///
/// # Errors
/// Where a state cannot be made.
pub fn sections(effort: &Effort) -> Result<Vec<Section>, Failure> {
    let all = Catalogue::new()?;
    let groups = ROWS.iter().map(|row| cases(&all, row, effort.states));
    let groups: Vec<Vec<Case>> = groups.collect::<Result<_, _>>()?;
    let both = ROWS.iter().zip(&groups);
    let contenders = both.map(|((name, _, _, request, _), cases)| pass(name, cases, *request));
    let timing = in_turns(contenders.collect(), effort);
    let counts = if effort.instructions {
        Some(instructions()?)
    } else {
        None
    };
    let mut head = vec![
        "variant",
        "element",
        "operations",
        "ns",
        "quartiles",
        "ratio",
    ];
    head.extend(["quartiles of the ratio", "ratio of the least", "to"]);
    if counts.is_some() {
        head.extend(["instructions", "ratio of instructions"]);
    }
    let mut section = Section::new("skipping", "What leaving work out gains", &head);
    for (i, ((name, .., reference), cases)) in ROWS.iter().zip(&groups).enumerate() {
        let case = &cases[0];
        let mut row = vec![name.to_string(), case.name().to_string()];
        row.push(case.descriptor.operations.to_string());
        row.extend(spread(timing.time(name)));
        row.extend(spread(timing.ratio(name, reference)));
        row.push(number(timing.ratio_of_least(name, reference)));
        row.push(if *reference == FULL { "full" } else { CYLINDER }.to_string());
        if let Some(counts) = &counts {
            let reference = ROWS.iter().position(|(name, ..)| name == reference);
            let ratio = counts[i] / counts[reference.unwrap_or(0)];
            row.extend([format!("{:.0}", counts[i]), number(ratio)]);
        }
        section.row(row);
    }
    section.note(&format!(
        "{} random states of each variant, all in turns. Operations: of the point programs, whatever is requested. Half of a symmetric K is not offered: `CTE_SYMMETRISE` is \
         work on top of the full one. Instructions: counted by callgrind on {COUNTED} of the states.",
        effort.states
    ));
    Ok(vec![section])
}

fn cases(all: &Catalogue, row: &Row, states: u64) -> Result<Vec<Case>, Failure> {
    let (name, element, wanted, request, _) = *row;
    let mut cases = all.cases(element, wanted, states)?;
    if name == CYLINDER {
        for case in &mut cases {
            case.descriptor = PointCylinderByNewton::DESCRIPTOR;
        }
    }
    if request.bits == Request::GIVEN.bits {
        cases.iter().map(Case::projected).collect()
    } else {
        Ok(cases)
    }
}

/// Instructions per evaluation of every row.
fn instructions() -> Result<Vec<f64>, Failure> {
    let one = |row: usize| Ok(count(&[COUNT, &row.to_string()])? / COUNTED as f64);
    (0..ROWS.len()).map(one).collect()
}

/// Evaluates the states of a row once, for callgrind.
///
/// # Errors
/// Where there is no such row.
pub fn count_row(row: usize) -> Result<(), Failure> {
    let row = ROWS.get(row).ok_or("no such row")?;
    let cases = cases(&Catalogue::new()?, row, COUNTED)?;
    let mut contender = pass(row.0, &cases, row.3);
    counted(&mut || contender.once());
    Ok(())
}
