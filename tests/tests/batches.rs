//! A batch in lanes gives the bits of one call after the other, whatever the width: results, codes, sums into shared
//! arrays; and nothing of a contact that failed.

use contact_elements::abi::{
    Batch, Descriptor, OUTPUT_SIZE, csr_map, element_evaluate_batch_in, element_history_init,
    request,
};
use contact_elements::elements::{ELEMENTS, Line2Line2Beams, PointQuad4, PointQuad9, PointTri3};
use contact_elements::runtime::Width;

struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.next() >> 11) as f64 / (1u64 << 53) as f64)
    }

    fn one_in(&mut self, n: u64) -> bool {
        self.next().is_multiple_of(n)
    }
}

/// Inputs of some contacts of one element.
struct Contacts {
    element: &'static Descriptor,
    count: usize,
    nodes: usize,
    x: Vec<f64>,
    u: Vec<f64>,
    history: Vec<f64>,
    parameters: Vec<f64>,
    connectivity: Vec<i32>,
    map: Vec<i64>,
}

/// Where the nodes are before they are moved: slave first.
fn layout(element: &Descriptor) -> Vec<[f64; 3]> {
    let flat = |list: &[[f64; 2]]| list.iter().map(|&[x, y]| [x, y, 0.0]).collect();
    let nodes: Vec<[f64; 3]> = match element.name.trim_end_matches('\0') {
        "PointTri3" => flat(&[[0.3, 0.3], [0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]),
        "PointQuad4" => flat(&[
            [0.0, 0.0],
            [-1.0, -1.0],
            [1.0, -1.0],
            [1.0, 1.0],
            [-1.0, 1.0],
        ]),
        "PointQuad9" => flat(&[
            [0.0, 0.0],
            [-1.0, -1.0],
            [1.0, -1.0],
            [1.0, 1.0],
            [-1.0, 1.0],
            [0.0, -1.0],
            [1.0, 0.0],
            [0.0, 1.0],
            [-1.0, 0.0],
            [0.0, 0.0],
        ]),
        "Line2Line2Beams" => vec![
            [-1.0, 0.0, 0.2],
            [1.0, 0.0, 0.2],
            [0.0, -1.0, 0.0],
            [0.0, 1.0, 0.0],
        ],
        name => panic!("no layout of {name}: add one"),
    };
    assert_eq!(nodes.len(), element.nodes(0));
    nodes
}

impl Contacts {
    fn new(element: &'static Descriptor, count: usize, seed: u64) -> Self {
        let mut random = Random(seed);
        let base = layout(element);
        let mut contacts = Self {
            element,
            count,
            nodes: base.len(),
            x: vec![],
            u: vec![],
            history: vec![],
            parameters: vec![],
            connectivity: vec![],
            map: vec![],
        };
        for e in 0..count {
            contacts.add_nodes(&base, &mut random);
            contacts.add_history(&mut random);
            contacts.add_parameters(&mut random);
            // neighbours share their last node with the next contact's second
            let own = (e * (base.len() - 1)) as i32;
            contacts
                .connectivity
                .extend((0..base.len() as i32).map(|a| own + a));
        }
        // coordinates of the shared numbering
        contacts
    }

    fn add_nodes(&mut self, base: &[[f64; 3]], random: &mut Random) {
        let warp = if random.one_in(8) { 0.8 } else { 0.15 };
        let scale = match random.next() % 24 {
            0 => 1e-12,
            1 => 1e25,
            2 => 1e7,
            _ => 1.0,
        };
        let (shift, reach) = (
            random.within(-3.0, 3.0),
            if random.one_in(6) { 4.0 } else { 0.9 },
        );
        let start = self.x.len();
        for (a, node) in base.iter().enumerate() {
            for (k, &value) in node.iter().enumerate() {
                let mut value = value + random.within(-warp, warp);
                if a == 0 && self.element.slave_nodes == 1 {
                    value += match k {
                        2 => random.within(-0.3, 0.2),
                        _ => random.within(-reach, reach),
                    };
                }
                self.x.push(scale * (value + shift));
                self.u.push(scale * random.within(-0.01, 0.01));
            }
        }
        let place = |random: &mut Random| start + (random.next() as usize) % (3 * base.len());
        match random.next() % 40 {
            0 => self.x[place(random)] = f64::NAN,
            1 => self.x[place(random)] = -2e30,
            2 => self.u[place(random)] = f64::INFINITY,
            3 => {
                // two nodes in one place
                let (from, to) = (start + 3, start + 6);
                self.x.copy_within(from..from + 3, to);
                self.u.copy_within(from..from + 3, to);
            }
            4 => self.x[start..].fill(scale * shift),
            _ => {}
        }
    }

    fn add_history(&mut self, random: &mut Random) {
        let mut history = vec![0.0; self.element.history()];
        // SAFETY: the element's own, and a history of its length.
        unsafe { element_history_init(self.element, history.as_mut_ptr()) };
        history[0] = (random.next() % 5) as f64;
        for value in &mut history[1..] {
            if !random.one_in(4) {
                *value = random.within(-0.9, 0.9);
            }
        }
        match random.next() % 50 {
            0 => history[1] = f64::NAN,
            1 => history[1] = 1e20,
            2 => history[0] = f64::NEG_INFINITY,
            3 => history[1] = 1e5,
            _ => {}
        }
        self.history.extend(history);
    }

    fn add_parameters(&mut self, random: &mut Random) {
        let signed = self.element.layout.orientation.is_some();
        let stiffness = if random.one_in(40) {
            -1.0
        } else {
            random.within(1.0, 1e4)
        };
        self.parameters.extend([stiffness, random.within(0.0, 0.4)]);
        if signed {
            self.parameters
                .push(if random.one_in(3) { -1.0 } else { 1.0 });
        }
        assert_eq!(self.parameters.len() % self.element.parameters.len(), 0);
    }

    /// Positions of a dense matrix of all nodes.
    fn csr(&mut self) -> usize {
        let rows = 3 * (self.count * (self.nodes - 1) + 1);
        let start: Vec<i64> = (0..=rows as i64).map(|row| row * rows as i64).collect();
        let columns: Vec<i32> = (0..rows * rows).map(|i| (i % rows) as i32).collect();
        self.map = vec![0; self.count * (3 * self.nodes) * (3 * self.nodes)];
        // SAFETY: all arrays have the extents of the header.
        let code = unsafe {
            csr_map(
                self.element,
                self.count as i64,
                0,
                self.connectivity.as_ptr(),
                rows as i64,
                start.as_ptr(),
                columns.as_ptr(),
                self.map.as_mut_ptr(),
            )
        };
        assert_eq!(code, 0);
        rows
    }
}

/// What ran raised of invalid, divide by zero and overflow.
#[cfg(target_arch = "x86_64")]
fn raised<T>(run: impl FnOnce() -> T) -> (T, u32) {
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
fn raised<T>(run: impl FnOnce() -> T) -> (T, u32) {
    (run(), 0)
}

/// How a batch is handed over.
#[derive(Clone, Copy, Debug)]
struct Form {
    request: u32,
    same_parameters: bool,
    displacements: bool,
    /// Node and component strides of x.
    strides: [usize; 2],
    scattered: bool,
    scale: f64,
}

/// All outputs as bits.
struct Outputs {
    f: Vec<f64>,
    k: Vec<f64>,
    history: Vec<f64>,
    output: Vec<f64>,
    energy: Vec<f64>,
    status: Vec<i32>,
    code: Vec<i32>,
    returned: Vec<i32>,
}

const UNTOUCHED: f64 = -123.456;

impl Outputs {
    fn values(&self) -> [&Vec<f64>; 5] {
        [&self.f, &self.k, &self.history, &self.output, &self.energy]
    }
}

/// Evaluates `length` contacts at a time.
fn evaluate(contacts: &Contacts, form: Form, rows: usize, width: Width, length: usize) -> Outputs {
    let (n, count, element) = (contacts.nodes, contacts.count, contacts.element);
    let (unknowns, points) = (3 * n, contacts.element.points);
    let (sums, entries) = if form.scattered {
        (rows, rows * rows)
    } else {
        (unknowns * count, unknowns * unknowns * count)
    };
    let first = if form.scattered { 0.0 } else { UNTOUCHED };
    let mut out = Outputs {
        f: vec![first; sums],
        k: vec![first; entries],
        history: vec![UNTOUCHED; element.history() * count],
        output: vec![UNTOUCHED; OUTPUT_SIZE * points * count],
        energy: vec![UNTOUCHED; count],
        status: vec![-1; count],
        code: vec![-99; count],
        returned: vec![],
    };
    let [node, component] = form.strides;
    let apart = if form.scattered {
        0
    } else {
        n * node.max(3 * component)
    };
    let strided = spread(contacts, form);
    // SAFETY: null pointers and zeros are defaults.
    let mut batch: Batch = unsafe { std::mem::zeroed() };
    batch.struct_size = size_of::<Batch>() as u32;
    batch.request = form.request;
    batch.parameter_count = element.parameters.len() as i32;
    batch.parameter_element_stride = if form.same_parameters {
        0
    } else {
        element.parameters.len() as i64
    };
    (batch.f_scale, batch.k_scale) = (form.scale, form.scale);
    for at in (0..count).step_by(length) {
        let own = length.min(count - at);
        // SAFETY: offsets within the arrays.
        unsafe {
            batch.x = strided.as_ptr().add(at * apart);
            (batch.x_node_stride, batch.x_component_stride) = (node as i64, component as i64);
            batch.x_element_stride = apart as i64;
            if form.displacements {
                batch.u = contacts
                    .u
                    .as_ptr()
                    .add(if form.scattered { 0 } else { at * unknowns });
            }
            batch.parameters = contacts.parameters.as_ptr();
            if !form.same_parameters {
                batch.parameters = batch.parameters.add(at * element.parameters.len());
            }
            batch.hist_old = contacts.history.as_ptr().add(at * element.history());
            batch.hist_new = out.history.as_mut_ptr().add(at * element.history());
            batch.output = out.output.as_mut_ptr().add(at * OUTPUT_SIZE * points);
            batch.energy = out.energy.as_mut_ptr().add(at);
            batch.status = out.status.as_mut_ptr().add(at);
            batch.code = out.code.as_mut_ptr().add(at);
            if form.scattered {
                batch.connectivity = contacts.connectivity.as_ptr().add(at * n);
                batch.global_nodes = (rows / 3) as i64;
                batch.global_f = out.f.as_mut_ptr();
                batch.csr_values = out.k.as_mut_ptr();
                batch.csr_map = contacts.map.as_ptr().add(at * unknowns * unknowns);
            } else {
                batch.f = out.f.as_mut_ptr().add(at * unknowns);
                batch.k = out.k.as_mut_ptr().add(at * unknowns * unknowns);
            }
            let code = element_evaluate_batch_in(element, own as i64, &mut batch, width);
            out.returned.push(code);
        }
    }
    out
}

/// The positions with the strides of the form, or of all nodes with shared numbers.
fn spread(contacts: &Contacts, form: Form) -> Vec<f64> {
    let [node, component] = form.strides;
    if form.scattered {
        let all = contacts.count * (contacts.nodes - 1) + 1;
        let mut values = contacts.x.clone();
        values.resize(3 * all.max(contacts.count * contacts.nodes), 0.0);
        return values;
    }
    let apart = contacts.nodes * node.max(3 * component);
    let mut values = vec![f64::NAN; contacts.count * apart];
    for (i, &value) in contacts.x.iter().enumerate() {
        let (e, own) = (i / (3 * contacts.nodes), i % (3 * contacts.nodes));
        values[e * apart + (own / 3) * node + (own % 3) * component] = value;
    }
    values
}

fn forms() -> Vec<Form> {
    let all =
        request::RESIDUAL | request::TANGENT | request::HISTORY | request::OUTPUT | request::ENERGY;
    let plain = Form {
        request: all,
        same_parameters: true,
        displacements: false,
        strides: [3, 1],
        scattered: false,
        scale: 0.0,
    };
    vec![
        plain,
        Form {
            same_parameters: false,
            ..plain
        },
        Form {
            displacements: true,
            ..plain
        },
        Form {
            strides: [5, 1],
            ..plain
        },
        Form {
            strides: [1, 10],
            ..plain
        },
        Form {
            request: all | request::PROJECTION_GIVEN,
            ..plain
        },
        Form {
            request: all | request::FREEZE_STATE,
            ..plain
        },
        Form {
            request: all | request::SYMMETRISE,
            ..plain
        },
        Form {
            request: request::RESIDUAL,
            ..plain
        },
        Form {
            request: request::TANGENT | request::PROJECTION_GIVEN,
            displacements: true,
            ..plain
        },
        Form {
            scale: -0.7,
            ..plain
        },
        Form {
            scattered: true,
            ..plain
        },
        Form {
            scattered: true,
            displacements: true,
            scale: 0.3,
            same_parameters: false,
            ..plain
        },
    ]
}

/// Which output differs first, where, and its two values.
fn differing(one: &Outputs, many: &Outputs) -> Option<(&'static str, usize, f64, f64)> {
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

fn widths() -> impl Iterator<Item = Width> {
    [Width::One, Width::Four, Width::Eight]
        .into_iter()
        .filter(|&width| width <= Width::widest())
}

fn check(element: &'static Descriptor) {
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
                for length in [count, 37] {
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
