//! `CTE_SCREEN`: what is left out is open, whatever its projection; everything else is as without.

use contact_elements::runtime::Width;
use contact_elements::{OUTPUT_SIZE, Registered, request};
use contact_library::ELEMENTS;

use crate::contacts::Contacts;
use crate::evaluate::{Form, Outputs, evaluate, forms, raised};

const OPEN: i32 = 0;
const OUTSIDE: i32 = 4;
const CUT_BACK: i32 = 1;

/// What became of the contacts.
#[derive(Default)]
struct Tally {
    left_out: usize,
    /// Number of contacts whose gap is open at the foot.
    could_be: usize,
    evaluated: usize,
}

/// Entries of one contact.
fn own(values: &[f64], size: usize, e: usize) -> &[f64] {
    values.get(e * size..(e + 1) * size).unwrap_or(&[])
}

fn bits(values: &[f64]) -> Vec<u64> {
    values.iter().map(|value| value.to_bits()).collect()
}

/// Points of the master's domain as weights of its nodes.
fn samples(nodes: usize) -> Vec<Vec<f64>> {
    const STEPS: i32 = 16;
    let along = || (0..=STEPS).map(|i| f64::from(i) / f64::from(STEPS));
    let both = || along().flat_map(move |a| along().map(move |b| (a, b)));
    match nodes {
        2 => along().map(|a| vec![1.0 - a, a]).collect(),
        3 => both()
            .filter(|(a, b)| a + b <= 1.0)
            .map(|(a, b)| vec![1.0 - a - b, a, b])
            .collect(),
        4 => both()
            .map(|(a, b)| vec![(1.0 - a) * (1.0 - b), a * (1.0 - b), a * b, (1.0 - a) * b])
            .collect(),
        _ => panic!("no samples for {nodes} nodes"),
    }
}

/// The least distance of the slave from the planes that touch the master anywhere in its domain, on the side that the
/// sign says.
fn least_distance(x: &[[f64; 3]], d: usize, sign: f64) -> f64 {
    let (slave, master) = x.split_first().expect("a slave");
    let minus = |a: [f64; 3], b: [f64; 3]| [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    let mut least = f64::INFINITY;
    for weights in samples(master.len()) {
        let sum = |weights: &[f64]| {
            let mut sum = [0.0; 3];
            for (weight, node) in weights.iter().zip(master) {
                for k in 0..3 {
                    sum[k] += weight * node[k];
                }
            }
            sum
        };
        let r = minus(*slave, sum(&weights));
        let normal = if d == 2 {
            let t = minus(master[1], master[0]);
            [-t[1], t[0], 0.0]
        } else {
            let [t1, t2] = match master.len() {
                3 => [[-1.0, 1.0, 0.0, 0.0], [-1.0, 0.0, 1.0, 0.0]],
                _ => {
                    let (a, b) = (weights[1] + weights[2], weights[2] + weights[3]);
                    [[b - 1.0, 1.0 - b, b, -b], [a - 1.0, -a, a, 1.0 - a]]
                }
            }
            .map(|weights| sum(&weights[..master.len()]));
            [
                t1[1] * t2[2] - t1[2] * t2[1],
                t1[2] * t2[0] - t1[0] * t2[2],
                t1[0] * t2[1] - t1[1] * t2[0],
            ]
        };
        let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        least = least.min(sign * dot(r, normal) / dot(normal, normal).sqrt());
    }
    least
}

impl Tally {
    /// One contact with and without screening.
    fn compare(
        &mut self,
        contacts: &Contacts,
        form: Form,
        (plain, screened): (&Outputs, &Outputs),
        e: usize,
    ) {
        let element = contacts.element;
        let output = own(&screened.output, OUTPUT_SIZE * element.points, e);
        let is_left_out = screened.code[e] == 0
            && screened.status[e] == OPEN
            && output.get(6..9).is_some_and(|normal| normal == [0.0; 3]);
        let plain_output = own(&plain.output, OUTPUT_SIZE * element.points, e);
        let is_open = plain.code[e] == 0 && [OPEN, OUTSIDE].contains(&plain.status[e]);
        if is_open && plain_output[1] > 0.0 {
            self.could_be += 1;
        }
        if !is_left_out {
            self.evaluated += 1;
            assert_eq!(plain.code[e], screened.code[e]);
            assert_eq!(plain.status[e], screened.status[e]);
            for (plain, screened) in plain.values().into_iter().zip(screened.values()) {
                let size = plain.len() / contacts.count;
                if !form.scattered {
                    assert_eq!(bits(own(plain, size, e)), bits(own(screened, size, e)));
                }
            }
            return;
        }
        self.left_out += 1;
        assert!(
            is_open || plain.code[e] == CUT_BACK,
            "{form:?} {e}: {}",
            plain.status[e]
        );
        let bound = output[1];
        if plain.code[e] == 0 && plain.status[e] == OPEN {
            assert!(bound <= plain_output[1], "{e}: {bound} {}", plain_output[1]);
        }
        self.check_bound(contacts, form, e, bound);
        let size = element.history();
        let history = own(&screened.history, size, e);
        assert_eq!(history[0], 0.0);
        let old = own(&contacts.history, size, e);
        assert_eq!(history[1..=element.projected], old[1..=element.projected]);
        assert!(
            history[1 + element.projected..]
                .iter()
                .all(|&value| value == 0.0)
        );
        assert_eq!(screened.energy[e], 0.0);
        if !form.scattered {
            let n = element.unknowns(contacts.nodes);
            assert!(own(&screened.f, n, e).iter().all(|&value| value == 0.0));
            let k = own(&screened.k, n * n, e);
            assert!(form.request & request::TANGENT == 0 || k.iter().all(|&value| value == 0.0));
        }
    }

    /// The gap is nowhere below its bound.
    fn check_bound(&self, contacts: &Contacts, form: Form, e: usize, bound: f64) {
        let (element, d) = (contacts.element, contacts.element.dimension);
        let own = |values: &[f64], a: usize, k: usize| {
            let place = e * contacts.nodes + a;
            let node = if form.scattered {
                contacts.connectivity[place] as usize
            } else {
                place
            };
            values[node * d + k]
        };
        let mut x: Vec<[f64; 3]> = vec![[0.0; 3]; contacts.nodes];
        for (a, x) in x.iter_mut().enumerate() {
            for k in 0..d {
                x[k] = own(&contacts.x, a, k) - own(&contacts.x, 0, k);
                if form.displacements {
                    x[k] += own(&contacts.u, a, k) - own(&contacts.u, 0, k);
                }
            }
        }
        let set = if form.same_parameters { 0 } else { e };
        let value = |wanted: &str| {
            let names = element
                .parameters
                .iter()
                .map(|parameter| parameter.name.trim_end_matches('\0'));
            let place = names.enumerate().find(|(_, name)| *name == wanted);
            place.map(|(place, _)| contacts.parameters[set * element.parameters.len() + place])
        };
        let sign = value("orientation").map_or(1.0, f64::signum);
        let least = least_distance(&x, d, sign) - value("r0").unwrap_or(0.0);
        let size = x
            .iter()
            .flatten()
            .fold(0.0f64, |most, value| most.max(value.abs()));
        assert!(bound <= least + 1e-12 * size, "{e}: {bound} {least}");
        assert!(bound >= 0.0, "{bound}");
    }
}

fn check(element: &'static Registered) -> Tally {
    let mut tally = Tally::default();
    let offered = |form: &Form| Form {
        request: form.request & element.requests(),
        ..*form
    };
    let reported = |form: &Form| {
        let never = request::FREEZE_STATE | request::PROJECTION_GIVEN;
        form.request & request::OUTPUT != 0 && form.request & never == 0
    };
    let forms = forms();
    for (round, form) in forms
        .iter()
        .filter(|form| reported(form))
        .map(offered)
        .enumerate()
    {
        for seed in 0..if form.scattered { 2 } else { 4 } {
            let count = if form.scattered { 41 } else { 211 };
            let mut contacts = Contacts::new(element, count, 5000 * round as u64 + seed);
            if form.same_parameters {
                contacts.parameters[0] = 1234.5;
            }
            let rows = if form.scattered { contacts.csr() } else { 0 };
            let screening = Form {
                request: form.request | request::SCREEN,
                ..form
            };
            let width = Width::widest();
            let (plain, flags) = raised(|| evaluate(&contacts, form, rows, width, count));
            // elements without K have no map
            let has_blocks = form.scattered && element.requests() & request::CSR_BY_BLOCKS != 0;
            for by_blocks in [false, true] {
                if by_blocks && !has_blocks {
                    continue;
                }
                let screening = Form {
                    by_blocks,
                    ..screening
                };
                let (screened, more) = raised(|| evaluate(&contacts, screening, rows, width, 37));
                assert_eq!(more & !flags, 0, "exceptions: {form:?} {seed}");
                if form.scattered {
                    assert_eq!(bits(&plain.f), bits(&screened.f));
                    assert_eq!(bits(&plain.k), bits(&screened.k));
                }
                for e in 0..count {
                    tally.compare(&contacts, form, (&plain, &screened), e);
                }
            }
        }
    }
    tally
}

#[test]
fn only_open_contacts_are_left_out() {
    let mut names = vec![];
    for element in ELEMENTS.iter().filter(|element| element.screen.is_some()) {
        let tally = check(element);
        let Tally {
            left_out,
            could_be,
            evaluated,
        } = tally;
        let name = element.name.trim_end_matches('\0');
        println!(
            "{name}: {left_out} left out, {evaluated} evaluated, {could_be} of all open with a gap above zero"
        );
        if Width::widest() >= Width::Four {
            assert!(left_out > 100, "{name}: {left_out} of {could_be}");
        }
        assert!(evaluated > 200, "{name}: {evaluated}");
        names.push(name);
    }
    println!("{names:?}");
    assert!(names.contains(&"PointQuad4") && names.contains(&"PointTri3"));
}

#[test]
fn elements_without_a_screen_or_a_tangent_refuse_the_bit() {
    for element in ELEMENTS {
        assert_eq!(
            element.tangent,
            element.requests() & request::CSR_BY_BLOCKS != 0
        );
        assert_eq!(
            element.screen.is_some(),
            element.requests() & request::SCREEN != 0
        );
    }
}
