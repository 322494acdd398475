//! A batch in lanes gives the bits of one call after the other, whatever the width: results, codes, sums into shared
//! arrays; and nothing of a contact that failed. Screened, it leaves open contacts out and nothing else.

mod contacts;
mod evaluate;
mod screen;

use contact_elements::Registered;
use contact_elements::runtime::Width;
use contact_library::{ELEMENTS, Line2Line2Beams, PointQuad4, PointQuad9, PointTri3};
use contacts::Contacts;
use evaluate::{Form, differing, evaluate, forms, raised};

fn widths() -> impl Iterator<Item = Width> {
    [Width::One, Width::Four, Width::Eight]
        .into_iter()
        .filter(|&width| width <= Width::widest())
}

/// Contacts at a time, and whether sums are scattered by blocks of nodes: a place for every entry is what they are
/// compared with.
fn ways(form: Form, count: usize) -> Vec<(usize, bool)> {
    let mut ways = vec![(count, false), (37, false)];
    if form.scattered {
        ways.extend([(1, true), (37, true), (count, true)]);
    }
    ways
}

fn check(element: &'static Registered) {
    let (mut good, mut failed, mut kinds) = (0, 0, [0; 9]);
    for (round, form) in forms().into_iter().enumerate() {
        for seed in 0..if form.scattered { 2 } else { 12 } {
            let count = if form.scattered { 41 } else { 211 };
            let mut contacts = Contacts::new(element, count, 1000 * round as u64 + seed);
            if form.same_parameters {
                contacts.parameters[0] = 1234.5;
            }
            let rows = if form.scattered { contacts.csr() } else { 0 };
            let (one, flags) = raised(|| evaluate(&contacts, form, rows, Width::One, 1));
            for width in widths() {
                for (length, by_blocks) in ways(form, count) {
                    let form = Form { by_blocks, ..form };
                    let (many, more) = raised(|| evaluate(&contacts, form, rows, width, length));
                    assert_eq!(more & !flags, 0, "exceptions: {form:?} {width:?} {seed}");
                    assert_eq!(one.code, many.code, "{form:?} {width:?}");
                    assert_eq!(one.status, many.status, "{form:?} {width:?}");
                    let place = differing(&one, &many);
                    assert!(
                        place.is_none(),
                        "{} {form:?} {width:?} {length} {seed}: {place:?}",
                        element.name.trim_end_matches('\0')
                    );
                    let all_well = one.returned.iter().all(|&code| code == 0);
                    assert_eq!(all_well, many.returned.iter().all(|&code| code == 0));
                }
            }
            for (&code, &status) in one.code.iter().zip(&one.status) {
                if code == 0 {
                    good += 1
                } else {
                    failed += 1
                }
                kinds[status as usize] += 1;
            }
        }
    }
    println!(
        "{}: {good} evaluated, {failed} failed, by status {kinds:?}",
        element.name.trim_end_matches('\0')
    );
    // open, closed and outside come about, and so do failures
    assert!(
        kinds[0] > 300 && kinds[1] > 300 && kinds[4] > 300 && failed > 300,
        "{kinds:?} {failed}"
    );
}

#[test]
fn every_element_in_lanes_is_here() {
    let names: Vec<&str> = ELEMENTS
        .iter()
        .filter(|element| element.lanes.is_some())
        .map(|element| element.name)
        .collect();
    let here = [
        PointTri3::DESCRIPTOR,
        PointQuad4::DESCRIPTOR,
        PointQuad9::DESCRIPTOR,
        Line2Line2Beams::DESCRIPTOR,
    ];
    assert_eq!(names, here.map(|element| element.name));
}

#[test]
fn point_on_tri3() {
    check(PointTri3::DESCRIPTOR);
}

#[test]
fn point_on_quad4() {
    check(PointQuad4::DESCRIPTOR);
}

#[test]
fn point_on_quad9() {
    check(PointQuad9::DESCRIPTOR);
}

#[test]
fn two_straight_beams() {
    check(Line2Line2Beams::DESCRIPTOR);
}
