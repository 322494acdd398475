//! Patches: facets that share their nodes, slave points near them, the elements that belong together and wrong ones.

use crate::check::PATCH_IN_0_1;
use crate::element::Element;
use crate::entropy::Entropy;
use crate::harness::Harness;
use crate::state::{State, parameter, template};

/// Facet, edge and vertex that belong together; an empty name stands for a missing one.
pub const KINDS: [[&str; 3]; 6] = [
    ["PointQuad4", "PointLine2Oriented", "PointPointOriented"],
    ["PointTri3", "PointLine2Oriented", "PointPointOriented"],
    ["PointQuad9", "PointLine3Oriented", "PointPointOriented"],
    [
        "PointRationalSurface2",
        "PointRationalCurve2Oriented",
        "PointPointOriented",
    ],
    ["PointLine2In2d", "", "PointPointOriented2d"],
    ["PointLine2", "", "PointPoint"],
];

/// Most nodes of all facets, each counted for itself: the matrix fits its memory.
const MOST_NODES: usize = 54;

/// What `cte_patch` says.
#[derive(Clone, Debug)]
pub struct Facets {
    /// Indices of facet, edge and vertex among all elements; `None` for null.
    pub elements: [Option<usize>; 3],
    /// Slave points.
    pub slaves: usize,
    /// Master nodes.
    pub masters: usize,
    /// Facets.
    pub count: usize,
    /// Master nodes of every facet.
    pub connectivity: Vec<i32>,
    /// As passed to the library.
    pub reach: f64,
    /// As passed to the library: slave points, master nodes, facets.
    pub counts: [i32; 3],
    /// `struct_size`; 0: as large as the struct.
    pub struct_size: u32,
    /// What is null: 0 the patch, 1 connectivity.
    pub null: Option<usize>,
}

impl Facets {
    /// A patch of a kind of which the facet is `facet`, and its values.
    pub fn new(harness: &Harness, facet: usize, entropy: &mut Entropy) -> (Self, State) {
        let named = |name: &str| harness.elements.iter().position(|e| e.name == name);
        let element = &harness.elements[facet];
        let kind = KINDS.iter().find(|kind| kind[0] == element.name);
        let [_, edge, vertex] = kind.unwrap_or(&KINDS[0]);
        let most = (MOST_NODES / element.masters().max(1)).clamp(1, 6);
        let count = 1 + entropy.below(most);
        let (connectivity, nodes) = mesh(element, count);
        let slaves = 1 + entropy.below(4);
        let lower = |name: &str, entropy: &mut Entropy| match entropy.below(8) {
            0 => None,
            _ => named(name),
        };
        let facets = Self {
            elements: [Some(facet), lower(edge, entropy), lower(vertex, entropy)],
            slaves,
            masters: nodes.len(),
            count,
            connectivity,
            reach: entropy.pick(&[0.0, 0.0, 0.0, 0.1, 1.0, 100.0]),
            counts: [slaves, nodes.len(), count].map(|number| number as i32),
            struct_size: 0,
            null: None,
        };
        let state = facets.values(element, nodes, entropy);
        (facets, state)
    }

    /// Positions of a folded surface and of points on, beside, above and below it; parameters.
    fn values(&self, element: &Element, nodes: Vec<[f64; 3]>, entropy: &mut Entropy) -> State {
        let d = element.dimension();
        let (noise, lift) = (entropy.pick(&[0.0, 0.0, 0.02, 0.3]), d - 1);
        let slope = entropy.pick(&[0.0, 0.5, -0.5, 1.0, -1.0, 3.0]);
        let mut masters = nodes;
        for node in &mut masters {
            node[lift] += slope * (node[0] - 1.0).max(0.0);
            for value in node.iter_mut().take(d) {
                *value += noise * entropy.between(-1.0, 1.0);
            }
        }
        let mut x = Vec::with_capacity((self.slaves + self.masters) * d);
        for _ in 0..self.slaves {
            let [first, second] = [0; 2].map(|_| masters[entropy.below(masters.len())]);
            let part = entropy.pick(&[0.0, 0.5, 0.5, 0.3, 1.2, 1.0]);
            let height = entropy.pick(&[0.0, 0.1, -0.1, 1e-9, -0.5]);
            let beside = entropy.pick(&[0.0, 0.1, 0.3]);
            for k in 0..d {
                let between = first[k] + part * (second[k] - first[k]);
                let rise = if k == lift { height } else { 0.0 };
                x.push(between + rise + beside * entropy.between(-1.0, 1.0));
            }
        }
        x.extend(masters.iter().flat_map(|node| node.iter().take(d)));
        let moved = entropy.pick(&[0.0, 1e-3, 0.1]);
        let u = x.iter().map(|_| moved * entropy.between(-1.0, 1.0));
        State {
            nslave: self.slaves,
            nodes: self.slaves + self.masters,
            u: u.collect(),
            x,
            parameters: self.parameters(element, entropy),
            row: Vec::new(),
        }
    }

    /// Parameters of the facet; of rational ones the weights are those of the patch's nodes.
    fn parameters(&self, element: &Element, entropy: &mut Entropy) -> Vec<f64> {
        let ranges = &element.parameters;
        let weights = if element.name.contains("Rational") {
            element.masters()
        } else {
            0
        };
        let own = ranges.len().saturating_sub(weights);
        let mut list = Vec::with_capacity(own + self.masters);
        for range in &ranges[..own] {
            let is_radius = range.name == "r0" && entropy.chance(2, 3);
            list.push(if is_radius {
                0.0
            } else {
                parameter(range, entropy)
            });
        }
        if let Some(range) = ranges.get(own) {
            list.extend((0..self.masters).map(|_| parameter(range, entropy)));
        }
        list
    }

    /// One change of the patch.
    pub fn change(&mut self, harness: &Harness, entropy: &mut Entropy) {
        let any = entropy.below(harness.elements.len());
        match entropy.below(10) {
            // another facet has other sizes: see `Facets::new`
            0 => self.elements[1] = Some(any),
            1 => self.elements[2] = Some(any),
            2 => self.swap_lower(harness, entropy),
            3 => self.elements[entropy.below(3)] = None,
            4 => self.reach = entropy.strange(self.reach),
            5 => {
                // what is refused whatever the arrays are
                let which = entropy.below(3);
                self.counts[which] = match which {
                    2 => entropy.pick(&[0, -1, i32::MIN]),
                    _ => entropy.pick(&[0, -1, i32::MIN, i32::MAX, 1 << 30]),
                };
            }
            6 => self.struct_size = entropy.pick(&[0, 4, 8, 55, 57, PATCH_IN_0_1, 184, u32::MAX]),
            7 => self.null = Some(entropy.below(2)),
            _ => self.change_connectivity(entropy),
        }
    }

    /// Edges and vertices of other facets, without sides, of the other dimension.
    fn swap_lower(&mut self, harness: &Harness, entropy: &mut Entropy) {
        let others = [
            "PointLine2",
            "PointLine2Oriented",
            "PointLine3Oriented",
            "PointBezierCurve2Oriented",
            "PointPoint",
            "PointPointOriented",
            "PointPointOriented2d",
            "PointPoint2d",
        ];
        let name = entropy.pick(&others);
        let at = harness.elements.iter().position(|e| e.name == name);
        self.elements[1 + entropy.below(2)] = at;
    }

    /// Invalid nodes, one node twice, facets reversed, the same facet twice.
    fn change_connectivity(&mut self, entropy: &mut Entropy) {
        let list = &mut self.connectivity;
        if list.is_empty() {
            return;
        }
        let (at, other) = (entropy.below(list.len()), entropy.below(list.len()));
        let nodes = list.len() / self.count;
        match entropy.below(6) {
            0 => list[at] = entropy.pick(&[-1, i32::MIN, i32::MAX, self.masters as i32]),
            1 => list[at] = list[other],
            2 => list.swap(at, other),
            3 => list.fill(0),
            4 => list[at / nodes * nodes..][..nodes].reverse(),
            _ => {
                let (from, to) = (at / nodes * nodes, other / nodes * nodes);
                list.copy_within(from..from + nodes, to);
            }
        }
    }
}

/// Nodes of `count` facets side by side, those in one place only once.
fn mesh(element: &Element, count: usize) -> (Vec<i32>, Vec<[f64; 3]>) {
    let (mut connectivity, mut nodes) = (Vec::new(), Vec::<[f64; 3]>::new());
    for facet in 0..count {
        for a in 0..element.masters() {
            let position = in_place(
                element,
                facet,
                template(element, a, element.masters(), false, false),
            );
            let same = |node: &[f64; 3]| {
                let pairs = node.iter().zip(position);
                pairs.map(|(x, y)| (x - y).abs()).sum::<f64>() < 1e-9
            };
            let at = nodes.iter().position(same).unwrap_or_else(|| {
                nodes.push(position);
                nodes.len() - 1
            });
            connectivity.push(at as i32);
        }
    }
    if nodes.is_empty() {
        // a rigid master has no nodes, a patch needs one
        nodes.push([0.0; 3]);
    }
    (connectivity, nodes)
}

/// Where a facet's node lies: facets fill a grid of three columns, curves a line.
fn in_place(element: &Element, facet: usize, [x, y, z]: [f64; 3]) -> [f64; 3] {
    let (column, row) = ((facet % 3) as f64, (facet / 3) as f64);
    if element.info.projected == 1 {
        [x + 2.0 * facet as f64, y, z]
    } else if element.name.contains("Tri") {
        // two in a cell, the second half a turn round
        let (cell, half) = ((facet / 2) as f64, facet % 2 == 1);
        let (x, y) = if half { (1.0 - x, 1.0 - y) } else { (x, y) };
        [x + cell, y, z]
    } else {
        [x + 2.0 * column, y + 2.0 * row, z]
    }
}
