//! The contacts of a batch and their layout.

use crate::element::Element;
use crate::entropy::Entropy;
use crate::evaluate::{initial, plan};
use crate::harness::Harness;
use crate::plan::{Plan, request};
use crate::scatter;
use crate::state::State;

/// Contacts of one element, and how they are passed.
#[derive(Clone, Debug)]
pub struct Contacts {
    /// The first contact; `old`, request, scales, edge and element count for all.
    pub plan: Plan,
    /// As passed to the library.
    pub n: i64,
    /// Values of each.
    pub states: Vec<State>,
    /// Accepted histories of all.
    pub old: Option<Vec<f64>>,
    /// Element, node, component stride of x and u.
    pub strides: [[i64; 3]; 2],
    /// Node numbers, where coordinates are gathered.
    pub connectivity: Option<Vec<i32>>,
    /// As passed to the library.
    pub global_nodes: i64,
    /// As passed to the library.
    pub parameter_stride: i64,
    /// Strides of f and K, as passed to the library.
    pub output_strides: [i64; 2],
    /// Whether f and K are added to a global vector and sparse values.
    pub scattered: bool,
    /// Their places, each in the first [`scatter::PLACES`] values.
    pub map: Vec<i64>,
    /// Whether f and K go to arrays of the contacts.
    pub own: bool,
    /// Whether codes are asked for.
    pub codes: bool,
    /// Number of the pointer that is null.
    pub null: Option<usize>,
}

/// Contacts that the interface accepts, some of them changed in some places.
pub fn contacts(harness: &mut Harness, entropy: &mut Entropy) -> Result<Contacts, String> {
    let mut plan = plan(harness, entropy)?;
    let element = harness.elements[plan.element].clone();
    (plan.map, plan.k_strides, plan.aliased) = (None, [0; 2], false);
    (plan.nnode, plan.symbol, plan.parameter_count) = (0, false, element.info.parameters);
    let count = 1 + entropy.below(4);
    let mut states = vec![plan.state.clone()];
    for _ in 1..count {
        states.push(State::with_slaves(&element, entropy, plan.state.nslave));
    }
    let initial = initial(harness, &element)?;
    let old = plan.old.as_ref().map(|old| {
        let mut all = old.clone();
        (1..count).for_each(|_| all.extend_from_slice(&initial));
        all
    });
    let nodes = plan.state.nodes;
    let gathered = entropy.chance(1, 2);
    let d = element.dimension() as i64;
    let unknowns = element.unknowns(nodes) as i64;
    let pad = entropy.below(3) as i64;
    let mut contacts = Contacts {
        n: count as i64,
        strides: [0; 2].map(|_| strides(d, nodes as i64, count as i64, gathered, entropy)),
        connectivity: gathered.then(|| numbered(count * nodes, entropy)),
        global_nodes: if gathered { (count * nodes) as i64 } else { 0 },
        parameter_stride: i64::from(plan.parameter_count) + pad,
        output_strides: match entropy.below(2) {
            0 => [0; 2],
            _ => [unknowns + pad, unknowns * unknowns + pad],
        },
        scattered: gathered && entropy.chance(1, 2),
        map: vec![],
        own: entropy.chance(3, 4),
        codes: entropy.chance(3, 4),
        null: None,
        plan,
        states,
        old,
    };
    contacts.own |= !contacts.scattered;
    if contacts.scattered && entropy.chance(1, 2) {
        contacts.plan.request |= element.info.requests & request::CSR_BY_BLOCKS;
    }
    for _ in 0..entropy.pick(&[0, 0, 1, 1, 2, 4]) {
        contacts.change(&element, entropy);
    }
    if contacts.scattered {
        contacts.map = scatter::map(&element, &contacts, entropy);
    }
    Ok(contacts)
}

/// Different numbers in any order.
fn numbered(count: usize, entropy: &mut Entropy) -> Vec<i32> {
    let mut list: Vec<i32> = (0..count as i32).collect();
    for i in (1..count).rev() {
        list.swap(i, entropy.below(i + 1));
    }
    list
}

/// Strides that keep everything apart.
fn strides(d: i64, nodes: i64, count: i64, gathered: bool, entropy: &mut Entropy) -> [i64; 3] {
    let pad = entropy.below(3) as i64;
    let all = if gathered { nodes * count } else { count };
    match entropy.below(4) {
        0 => [0; 3],
        1 => [nodes * d + pad, 0, 0],
        2 => [nodes * (d + pad) + pad, d + pad, 1],
        _ if gathered => [0, 1, all + pad],
        _ => [1, all * d, all],
    }
}

impl Contacts {
    fn change(&mut self, element: &Element, entropy: &mut Entropy) {
        const WRONG: [i64; 5] = [-1, i64::MIN, i64::MAX, 1 << 61, -7];
        let which = entropy.below(2);
        match entropy.below(12) {
            0..=3 => {
                let at = entropy.below(self.states.len());
                self.states[at].change(element, entropy);
            }
            4 => self.strides[which][entropy.below(3)] = entropy.pick(&WRONG),
            5 => self.n = entropy.pick(&[0, -1, i64::MIN, i64::MAX]),
            6 => {
                if let Some(list) = &mut self.connectivity {
                    let at = entropy.below(list.len());
                    list[at] = entropy.pick(&[-1, i32::MAX, i32::MIN, list.len() as i32, 0]);
                }
            }
            7 => self.parameter_stride = entropy.pick(&[0, -1, 1 << 61, i64::MIN]),
            8 => self.output_strides[which] = entropy.pick(&WRONG),
            9 => self.null = Some(entropy.below(12)),
            10 => {
                let nslave = self.plan.nslave;
                self.plan.change(element, entropy);
                // not among the fields of a batch
                (self.plan.map, self.plan.nnode, self.plan.k_strides) = (None, 0, [0; 2]);
                if self.plan.null.take().is_some() {
                    self.plan.nslave = nslave;
                }
            }
            _ => {
                if let Some(old) = &mut self.old {
                    crate::state::change_list(old, entropy.chance(1, 8), entropy);
                }
            }
        }
    }

    /// Coordinates in the layout of the strides; wrong strides: dense.
    pub fn laid_out(&self, values: impl Fn(&State) -> &[f64], which: usize, d: usize) -> Vec<f64> {
        let nodes = self.plan.state.nodes;
        let small = |stride: i64| usize::try_from(stride).ok().filter(|s| *s < 1 << 16);
        let [element, node, component] = self.strides[which].map(small);
        // one node: its stride is not used
        let single = nodes == 1 && (self.connectivity.is_none() || self.states.len() == 1);
        let node = node.or(single.then_some(0));
        let (node, component) = match (node, component) {
            (Some(node), Some(component)) if component > 0 => (node, component),
            _ => (d, 1),
        };
        let element = element.filter(|element| *element > 0).unwrap_or(nodes * d);
        let mut list = Vec::new();
        for (e, state) in self.states.iter().enumerate() {
            for (at, &value) in values(state).iter().enumerate() {
                let (a, c) = (at / d, at % d);
                let place = match &self.connectivity {
                    Some(numbers) => {
                        let number = usize::try_from(numbers[e * nodes + a]).unwrap_or(0);
                        number.min(self.states.len() * nodes - 1) * node + c * component
                    }
                    None => e * element + a * node + c * component,
                };
                if place >= list.len() {
                    list.resize(place + 1, f64::from_bits(0x7ff4_0000_0000_0000));
                }
                list[place] = value;
            }
        }
        // the last node of a gathered array may be one that nobody refers to
        if self.connectivity.is_some() {
            let last = (self.states.len() * nodes - 1) * node + (d - 1) * component;
            list.resize(list.len().max(last + 1), 0.0);
        }
        list
    }

    /// The evaluation of contact `e` by itself.
    pub fn alone(&self, element: &Element, e: usize) -> Plan {
        let mut plan = self.plan.clone();
        // in an array with one set for all the last one has overwritten the others
        let set = match self.parameter_stride {
            0 => self.states.len() - 1,
            _ => e,
        };
        plan.state = self.states[e].clone();
        plan.state
            .parameters
            .clone_from(&self.states[set].parameters);
        plan.old = self.old.as_ref().map(|old| {
            let history = element.history();
            old[e * history..(e + 1) * history].to_vec()
        });
        (plan.strides, plan.short, plan.struct_size) = ([0; 2], 0, 0);
        plan
    }

    /// The stride of an output with the default filled in.
    pub fn output_stride(&self, which: usize, least: usize) -> usize {
        let stride = usize::try_from(self.output_strides[which]).unwrap_or(0);
        if (least..1 << 18).contains(&stride) {
            stride
        } else {
            least
        }
    }
}

/// Sets of parameters at their stride, the last one no longer than what is read.
pub fn parameters(contacts: &Contacts) -> Vec<f64> {
    let given = usize::try_from(contacts.plan.parameter_count).unwrap_or(0);
    let stride = usize::try_from(contacts.parameter_stride).unwrap_or(0);
    let stride = if stride < 1 << 16 { stride } else { 0 };
    let mut list = Vec::new();
    for (e, state) in contacts.states.iter().enumerate() {
        let set = &state.parameters[..given.min(state.parameters.len())];
        let end = e * stride + set.len();
        list.resize(end.max(list.len()), f64::from_bits(0x7ff4_0000_0000_0000));
        list[e * stride..end].copy_from_slice(set);
    }
    list
}
