//! A batch by several threads gives the bits of one thread: outputs of every contact, sums into shared arrays, codes.

mod mesh;
#[path = "../../src/random.rs"]
mod random;

use contact_elements::abi::{Batch, element_batch_workspace, element_evaluate_batch, element_evaluate_batch_threads};
use contact_elements::{Registered, OUTPUT_SIZE, argument, code, request};
use contact_threads_test::{Alone, Facets, Interpolated, Lanes, Multiplied};
use mesh::Mesh;

const THREADS: [i32; 5] = [1, 2, 3, 7, 0];
const ALL: u32 =
    request::RESIDUAL | request::TANGENT | request::HISTORY | request::OUTPUT | request::ENERGY;
const UNTOUCHED: f64 = -123.456;

/// How a batch is passed.
#[derive(Clone, Copy, Debug)]
struct Form {
    request: u32,
    /// f and k of every contact.
    dense: bool,
    /// Sums into shared arrays.
    scattered: bool,
    /// By blocks of nodes.
    by_blocks: bool,
    scale: f64,
    /// Distance between matrices of contacts beyond their size.
    spare: usize,
    /// One array for the old and the new history.
    in_place: bool,
}

const FORMS: [Form; 5] = {
    let scattered = Form {
        request: ALL,
        dense: false,
        scattered: true,
        by_blocks: false,
        scale: 1.0,
        spare: 0,
        in_place: false,
    };
    let dense = Form {
        dense: true,
        scattered: false,
        ..scattered
    };
    [
        scattered,
        Form {
            dense: true,
            scale: -0.7,
            spare: 3,
            ..scattered
        },
        Form {
            request: request::RESIDUAL,
            ..scattered
        },
        Form {
            request: request::TANGENT | request::HISTORY,
            in_place: true,
            ..scattered
        },
        Form {
            request: ALL | request::SYMMETRISE,
            ..dense
        },
    ]
};

/// All outputs.
#[derive(PartialEq, Debug)]
struct Outputs {
    numbers: [(&'static str, Vec<u64>); 7],
    status: Vec<i32>,
    codes: Vec<i32>,
    returned: i32,
    failed: i64,
    first: (i32, i32),
}

/// Outputs before the call; sums begin with something that is rounded.
fn blank(mesh: &Mesh, form: Form) -> [(&'static str, Vec<f64>); 7] {
    let n = mesh.count;
    let [own_f, own_k] = own_sizes(mesh, form);
    let rising = |count: usize, by: f64| (0..count).map(|i| by * i as f64).collect();
    [
        ("f", vec![UNTOUCHED; own_f * n]),
        ("k", vec![UNTOUCHED; own_k * n]),
        ("history", mesh.history.clone()),
        (
            "output",
            vec![UNTOUCHED; OUTPUT_SIZE * mesh.element.points * n],
        ),
        ("energy", vec![UNTOUCHED; n]),
        ("global f", rising(mesh.rows, 0.1)),
        ("csr", rising(mesh.columns.len(), 0.3)),
    ]
}

/// Distances between f and k of neighbouring contacts.
fn own_sizes(mesh: &Mesh, form: Form) -> [usize; 2] {
    [mesh.unknowns, mesh.unknowns * mesh.unknowns].map(|size| size + form.spare)
}

/// The batch with its request and inputs.
fn inputs(mesh: &Mesh, form: Form) -> Batch {
    let mut batch = Batch::EMPTY;
    batch.request = form.request;
    if form.by_blocks {
        batch.request |= request::CSR_BY_BLOCKS;
    }
    batch.nslave = mesh.slaves as i32;
    batch.parameter_count = mesh.element.parameters.len() as i32;
    batch.parameter_element_stride = i64::from(batch.parameter_count);
    batch.parameters = mesh.parameters.as_ptr();
    (batch.x, batch.u) = (mesh.x.as_ptr(), mesh.u.as_ptr());
    batch.connectivity = mesh.connectivity.as_ptr();
    batch.global_nodes = (mesh.x.len() / 3) as i64;
    batch.history_accepted = mesh.history.as_ptr();
    batch.slave_row = mesh.slave_rows.as_ptr();
    let map = if form.by_blocks {
        &mesh.blocks
    } else {
        &mesh.map
    };
    if form.scattered {
        batch.csr_map = map.as_ptr();
    }
    (batch.f_scale, batch.k_scale) = (form.scale, form.scale);
    batch
}

/// Evaluates all contacts; `threads` none: by the function without threads.
fn evaluate(mesh: &Mesh, form: Form, threads: Option<i32>) -> Outputs {
    let (element, n) = (mesh.element, mesh.count);
    assert_eq!(element.history() * n, mesh.history.len());
    let mut numbers = blank(mesh, form);
    let [f, k, trial, output, energy, global_f, csr] =
        numbers.each_mut().map(|(_, values)| values.as_mut_ptr());
    let (mut status, mut codes) = (vec![-1; n], vec![-99; n]);
    // SAFETY: the element's own.
    let needed = unsafe { element_batch_workspace(element, mesh.slaves as i32) };
    let mut workspace = vec![0.0; needed as usize];
    let mut batch = inputs(mesh, form);
    if form.in_place {
        batch.history_accepted = trial;
    }
    batch.history_trial = trial;
    if form.dense {
        let [own_f, own_k] = own_sizes(mesh, form);
        (batch.f, batch.k) = (f, k);
        (batch.f_element_stride, batch.k_element_stride) = (own_f as i64, own_k as i64);
    }
    if form.scattered {
        (batch.global_f, batch.csr_values) = (global_f, csr);
    }
    (batch.output, batch.energy) = (output, energy);
    (batch.status, batch.code) = (status.as_mut_ptr(), codes.as_mut_ptr());
    (batch.workspace, batch.workspace_size) = (workspace.as_mut_ptr(), needed);
    // SAFETY: all arrays have the extents of the header.
    let returned = unsafe {
        match threads {
            None => element_evaluate_batch(element, n as i64, &mut batch),
            Some(threads) => element_evaluate_batch_threads(element, n as i64, &mut batch, threads),
        }
    };
    let bits = |values: Vec<f64>| values.into_iter().map(f64::to_bits).collect();
    Outputs {
        numbers: numbers.map(|(name, values)| (name, bits(values))),
        status,
        codes,
        returned,
        failed: batch.failed,
        first: (batch.error_argument, batch.error_index),
    }
}

/// Which output differs first, and where.
fn differing(one: &Outputs, many: &Outputs) -> Option<(&'static str, usize)> {
    for ((name, one), (_, many)) in one.numbers.iter().zip(&many.numbers) {
        if let Some(place) = (0..one.len()).find(|&i| one[i] != many[i]) {
            return Some((name, place));
        }
    }
    let rest = one.status == many.status
        && one.codes == many.codes
        && (one.returned, one.failed, one.first) == (many.returned, many.failed, many.first);
    (!rest).then_some(("status or code", 0))
}

/// A grid in order and shuffled, so that few and that most entries are shared; `counts`: one round and several.
fn check(element: &'static Registered, counts: [usize; 2]) {
    for (count, is_shuffled) in counts.into_iter().flat_map(|n| [(n, false), (n, true)]) {
        let mesh = Mesh::new(element, count, is_shuffled);
        for form in FORMS {
            let one = evaluate(&mesh, form, None);
            let of = |wanted: i32| one.status.iter().filter(|&&own| own == wanted).count();
            assert_eq!(one.returned, code::CUT_BACK);
            let closed = of(1) + of(2) + of(3);
            assert!(one.failed > 1 && of(0) > count / 20 && closed > count / 5);
            let by_threads = THREADS.map(|threads| (Some(threads), false));
            let by_blocks = [None].into_iter().chain(THREADS.map(Some));
            let by_blocks = by_blocks
                .filter(|_| form.scattered)
                .map(|threads| (threads, true));
            for (threads, by_blocks) in by_threads.into_iter().chain(by_blocks) {
                let form = Form { by_blocks, ..form };
                let many = evaluate(&mesh, form, threads);
                let place = differing(&one, &many);
                let name = element.name.trim_end_matches('\0');
                assert!(
                    place.is_none(),
                    "{name}, {count} contacts, shuffled: {is_shuffled}, {threads:?} threads, {form:?}: {place:?}"
                );
            }
        }
    }
}

#[test]
fn in_lanes() {
    check(Lanes::DESCRIPTOR, [230, 5000]);
}

#[test]
fn alone_with_friction() {
    check(Alone::DESCRIPTOR, [100, 2300]);
}

#[test]
fn several_points() {
    check(Facets::DESCRIPTOR, [100, 2300]);
}

#[test]
fn multipliers() {
    check(Multiplied::DESCRIPTOR, [100, 5000]);
}

#[test]
fn with_a_workspace() {
    check(Interpolated::DESCRIPTOR, [100, 2300]);
}

#[test]
fn faults_of_the_batch() {
    let element = Lanes::DESCRIPTOR;
    let mesh = Mesh::new(element, 100, false);
    let refused = evaluate(&mesh, FORMS[0], Some(-1));
    assert_eq!(
        (refused.returned, refused.first.0),
        (code::INDEX, argument::THREADS)
    );
    assert!(refused.status.iter().all(|&status| status == -1));
    // SAFETY: zeros are defaults; no contacts.
    unsafe {
        let mut batch = Batch::EMPTY;
        batch.request = request::RESIDUAL;
        assert_eq!(element_evaluate_batch_threads(element, 0, &mut batch, 2), 0);
        batch.request = 0x4000_0000;
        let found = element_evaluate_batch_threads(element, 0, &mut batch, 2);
        assert_eq!(found, code::REQUEST);
        let null = std::ptr::null_mut();
        assert_eq!(
            element_evaluate_batch_threads(element, 0, null, 2),
            code::NULL
        );
    }
}
