//! A batch in one form of call, with all its outputs.

use contact_elements::abi::{Batch, element_evaluate_batch_in};
use contact_elements::runtime::Width;
use contact_elements::{OUTPUT_SIZE, request};

use crate::contacts::Contacts;

/// What ran raised of invalid, divide by zero and overflow.
#[cfg(target_arch = "x86_64")]
pub fn raised<T>(run: impl FnOnce() -> T) -> (T, u32) {
    const SERIOUS: u32 = 0b1101;
    let mut state = 0u32;
    // SAFETY: stores and loads the state of SSE, of which the flags alone change.
    unsafe {
        std::arch::asm!("stmxcsr [{}]", in(reg) &mut state);
        state &= !0x3f;
        std::arch::asm!("ldmxcsr [{}]", in(reg) &state);
    }
    let result = run();
    // SAFETY: as above.
    unsafe { std::arch::asm!("stmxcsr [{}]", in(reg) &mut state) };
    (result, state & SERIOUS)
}

#[cfg(not(target_arch = "x86_64"))]
pub fn raised<T>(run: impl FnOnce() -> T) -> (T, u32) {
    (run(), 0)
}

/// How a batch is passed.
#[derive(Clone, Copy, Debug)]
pub struct Form {
    pub request: u32,
    pub same_parameters: bool,
    pub displacements: bool,
    /// Node and component strides of x, where it is not shared.
    pub strides: [usize; 2],
    pub scattered: bool,
    /// Scattered by blocks of nodes.
    pub by_blocks: bool,
    pub scale: f64,
}

impl Form {
    /// The request bit of blocks, where the form has them.
    fn blocks(&self) -> u32 {
        if self.by_blocks {
            request::CSR_BY_BLOCKS
        } else {
            0
        }
    }
}

/// All outputs as bits.
pub struct Outputs {
    pub f: Vec<f64>,
    pub k: Vec<f64>,
    pub history: Vec<f64>,
    pub output: Vec<f64>,
    pub energy: Vec<f64>,
    pub status: Vec<i32>,
    pub code: Vec<i32>,
    pub returned: Vec<i32>,
}

const UNTOUCHED: f64 = -123.456;

impl Outputs {
    pub fn values(&self) -> [&Vec<f64>; 5] {
        [&self.f, &self.k, &self.history, &self.output, &self.energy]
    }
}

/// Outputs before a call: sums begin at zero, everything else with a number that no evaluation gives.
fn outputs(contacts: &Contacts, form: Form, rows: usize) -> Outputs {
    let (count, element) = (contacts.count, contacts.element);
    let unknowns = element.dimension * contacts.nodes;
    let (sums, entries, first) = if form.scattered {
        (rows, rows * rows, 0.0)
    } else {
        (unknowns * count, unknowns * unknowns * count, UNTOUCHED)
    };
    Outputs {
        f: vec![first; sums],
        k: vec![first; entries],
        history: vec![UNTOUCHED; element.history() * count],
        output: vec![UNTOUCHED; OUTPUT_SIZE * element.points * count],
        energy: vec![UNTOUCHED; count],
        status: vec![-1; count],
        code: vec![-99; count],
        returned: vec![],
    }
}

/// What every call of a form has in common.
fn batch(contacts: &Contacts, form: Form) -> Batch {
    let (n, d) = (contacts.nodes, contacts.element.dimension);
    let parameters = contacts.element.parameters.len();
    let mut batch = Batch::EMPTY;
    batch.request = form.request | form.blocks();
    batch.parameter_count = parameters as i32;
    batch.parameter_element_stride = if form.same_parameters {
        0
    } else {
        parameters as i64
    };
    (batch.f_scale, batch.k_scale) = (form.scale, form.scale);
    let [node, component] = if form.scattered { [d, 1] } else { form.strides };
    (batch.x_node_stride, batch.x_component_stride) = (node as i64, component as i64);
    batch.x_element_stride = if form.scattered {
        0
    } else {
        (n * node.max(d * component)) as i64
    };
    batch
}

/// Points a batch at the contacts from `at` on; `x` is spread as the form says.
///
/// # Safety
/// `at` is the number of a contact, and the arrays outlive the call of the batch.
unsafe fn point_at(
    batch: &mut Batch,
    at: usize,
    x: &[f64],
    contacts: &Contacts,
    form: Form,
    out: &mut Outputs,
) {
    let (n, element) = (contacts.nodes, contacts.element);
    let (d, points, parameters) = (element.dimension, element.points, element.parameters.len());
    let unknowns = d * n;
    // SAFETY: offsets within the arrays.
    unsafe {
        batch.x = x.as_ptr().add(at * batch.x_element_stride as usize);
        if form.displacements {
            batch.u = contacts
                .u
                .as_ptr()
                .add(if form.scattered { 0 } else { at * unknowns });
        }
        batch.parameters = contacts.parameters.as_ptr();
        if !form.same_parameters {
            batch.parameters = batch.parameters.add(at * parameters);
        }
        batch.history_accepted = contacts.history.as_ptr().add(at * element.history());
        batch.history_trial = out.history.as_mut_ptr().add(at * element.history());
        batch.output = out.output.as_mut_ptr().add(at * OUTPUT_SIZE * points);
        batch.energy = out.energy.as_mut_ptr().add(at);
        batch.status = out.status.as_mut_ptr().add(at);
        batch.code = out.code.as_mut_ptr().add(at);
        if form.scattered {
            batch.connectivity = contacts.connectivity.as_ptr().add(at * n);
            batch.global_nodes = (out.f.len() / d) as i64;
            batch.global_f = out.f.as_mut_ptr();
            batch.csr_values = out.k.as_mut_ptr();
            batch.csr_map = contacts.places(form.by_blocks, at).as_ptr();
        } else {
            batch.f = out.f.as_mut_ptr().add(at * unknowns);
            batch.k = out.k.as_mut_ptr().add(at * unknowns * unknowns);
        }
    }
}

/// Evaluates `length` contacts at a time.
pub fn evaluate(
    contacts: &Contacts,
    form: Form,
    rows: usize,
    width: Width,
    length: usize,
) -> Outputs {
    let (count, element) = (contacts.count, contacts.element);
    let x = spread(contacts, form);
    let mut out = outputs(contacts, form, rows);
    let mut batch = batch(contacts, form);
    for at in (0..count).step_by(length) {
        let own = length.min(count - at) as i64;
        // SAFETY: `at` is below the number of contacts, and all arrays have the extents of the header.
        let code = unsafe {
            point_at(&mut batch, at, &x, contacts, form, &mut out);
            element_evaluate_batch_in(element, own, &mut batch, width)
        };
        out.returned.push(code);
    }
    out
}

/// The positions with the strides of the form, or of all nodes with shared numbers.
fn spread(contacts: &Contacts, form: Form) -> Vec<f64> {
    let ([node, component], d) = (form.strides, contacts.element.dimension);
    if form.scattered {
        let all = contacts.count * (contacts.nodes - 1) + 1;
        let mut values = contacts.x.clone();
        values.resize(d * all.max(contacts.count * contacts.nodes), 0.0);
        return values;
    }
    let apart = contacts.nodes * node.max(d * component);
    let mut values = vec![f64::NAN; contacts.count * apart];
    for (i, &value) in contacts.x.iter().enumerate() {
        let (e, own) = (i / (d * contacts.nodes), i % (d * contacts.nodes));
        values[e * apart + (own / d) * node + (own % d) * component] = value;
    }
    values
}

/// Every way in which lanes read or write.
pub fn forms() -> Vec<Form> {
    let all =
        request::RESIDUAL | request::TANGENT | request::HISTORY | request::OUTPUT | request::ENERGY;
    let plain = Form {
        request: all,
        same_parameters: true,
        displacements: false,
        strides: [3, 1],
        scattered: false,
        by_blocks: false,
        scale: 1.0,
    };
    let requested = |request| Form { request, ..plain };
    let moved = Form {
        displacements: true,
        ..plain
    };
    let own_parameters = Form {
        same_parameters: false,
        ..plain
    };
    let mut forms = vec![plain, own_parameters, moved];
    forms.extend([[5, 1], [1, 10]].map(|strides| Form { strides, ..plain }));
    let bits = [
        request::PROJECTION_GIVEN,
        request::FREEZE_STATE,
        request::SYMMETRISE,
    ];
    forms.extend(bits.map(|bit| requested(all | bit)));
    forms.push(requested(request::RESIDUAL));
    forms.push(Form {
        request: request::TANGENT | request::PROJECTION_GIVEN,
        ..moved
    });
    forms.push(Form {
        scale: -0.7,
        ..plain
    });
    forms.push(Form {
        scattered: true,
        ..plain
    });
    forms.push(Form {
        scattered: true,
        scale: 0.3,
        same_parameters: false,
        ..moved
    });
    forms
}

/// Which output differs first, where, and its two values.
pub fn differing(one: &Outputs, many: &Outputs) -> Option<(&'static str, usize, f64, f64)> {
    let names = ["f", "k", "history", "output", "energy"];
    for (name, (one, many)) in names
        .into_iter()
        .zip(one.values().into_iter().zip(many.values()))
    {
        let pairs = one.iter().zip(many);
        if let Some((place, (&one, &many))) = pairs
            .enumerate()
            .find(|(_, (one, many))| one.to_bits() != many.to_bits())
        {
            return Some((name, place, one, many));
        }
    }
    None
}
