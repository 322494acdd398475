//! What one evaluation is called with: a valid call in which single things are replaced.

use contact_elements::abi::Arguments;

use crate::check::{ARGUMENTS_IN_0_1, is_refused};
use crate::element::Element;
use crate::entropy::Entropy;
use crate::memory::Edge;
use crate::state::{State, change_list};

/// Request bits.
pub mod request {
    /// `CTE_RESIDUAL`.
    pub const RESIDUAL: u32 = 1;
    /// `CTE_TANGENT`.
    pub const TANGENT: u32 = 2;
    /// `CTE_HISTORY`.
    pub const HISTORY: u32 = 4;
    /// `CTE_OUTPUT`.
    pub const OUTPUT: u32 = 8;
    /// `CTE_ENERGY`.
    pub const ENERGY: u32 = 16;
    /// `CTE_FREEZE_STATE`.
    pub const FREEZE_STATE: u32 = 32;
    /// `CTE_PROJECTION_GIVEN`.
    pub const PROJECTION_GIVEN: u32 = 128;
    /// `CTE_SCREEN`.
    pub const SCREEN: u32 = 256;
    /// `CTE_CSR_BY_BLOCKS`.
    pub const CSR_BY_BLOCKS: u32 = 512;
}

/// Arrays and pointers that can be null.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Array {
    /// Reference coordinates.
    X,
    /// Parameters.
    Parameters,
    /// Row of an interpolated slave.
    Row,
    /// Residual.
    F,
    /// Tangent.
    K,
    /// Trial history.
    New,
    /// Output.
    Output,
    /// Energy.
    Energy,
    /// Workspace.
    Workspace,
    /// The element.
    Element,
    /// The struct.
    Arguments,
}

const ARRAYS: [Array; 11] = [
    Array::X,
    Array::Parameters,
    Array::Row,
    Array::F,
    Array::K,
    Array::New,
    Array::Output,
    Array::Energy,
    Array::Workspace,
    Array::Element,
    Array::Arguments,
];

/// Inputs of one evaluation.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Index among all elements.
    pub element: usize,
    /// Whether the element's own symbol is called.
    pub symbol: bool,
    /// Values.
    pub state: State,
    /// Whether `u` is not null.
    pub displaced: bool,
    /// Accepted history; `None` for null.
    pub old: Option<Vec<f64>>,
    /// Request bits.
    pub request: u32,
    /// As passed to the library.
    pub nnode: i32,
    /// As passed to the library.
    pub nslave: i32,
    /// As passed to the library.
    pub parameter_count: i32,
    /// Strides of x and u.
    pub strides: [i64; 2],
    /// What is null.
    pub null: Option<Array>,
    /// Whether pointers that are not needed point to nowhere.
    pub dangling: bool,
    /// Whether the histories are one array.
    pub aliased: bool,
    /// Map of unknowns.
    pub map: Option<Vec<i32>>,
    /// Strides of K.
    pub k_strides: [i64; 2],
    /// Scales of f and K.
    pub scales: [f64; 2],
    /// Doubles of workspace less than needed; negative: more.
    pub short: i64,
    /// `struct_size`; 0: as large as the struct.
    pub struct_size: u32,
    /// What stands in fields that are not used.
    pub unused: u64,
    /// Where arrays lie.
    pub edge: Edge,
}

impl Plan {
    /// A call that the interface accepts.
    pub fn new(element: &Element, state: State, entropy: &mut Entropy) -> Self {
        let unknowns = element.unknowns(state.nodes);
        let offered = element.info.requests;
        let wanted = match entropy.below(4) {
            0 => entropy.bits() as u32 & offered,
            1 => offered & 0x1f & entropy.bits() as u32,
            _ => offered & 0x1f,
        };
        Self {
            element: element.index as usize,
            symbol: entropy.chance(1, 2),
            displaced: entropy.chance(3, 4),
            old: None,
            request: wanted,
            nnode: entropy.pick(&[0, state.nodes as i32]),
            nslave: match element.interpolated() {
                true => state.nslave as i32,
                false => entropy.pick(&[0, state.nslave as i32]),
            },
            parameter_count: element.info.parameters,
            strides: [0; 2].map(|_| stride(element.dimension() as i64, entropy)),
            null: None,
            dangling: entropy.chance(1, 2),
            aliased: entropy.chance(1, 8),
            map: entropy.chance(1, 3).then(|| spread(unknowns, entropy)),
            k_strides: [0; 2],
            scales: [0; 2].map(|_| entropy.pick(&[0.0, 1.0, -1.0, 0.5])),
            short: -(entropy.below(3) as i64),
            struct_size: 0,
            unused: entropy.bits(),
            edge: entropy.pick(&[Edge::End, Edge::Start]),
            state,
        }
        .with_k_strides(unknowns, entropy)
    }

    fn with_k_strides(mut self, unknowns: usize, entropy: &mut Entropy) -> Self {
        let rows = self.rows(unknowns) as i64;
        let pad = entropy.below(4) as i64;
        self.k_strides = match entropy.below(8) {
            0 => [rows + pad, 1],
            1 => [1, rows + pad],
            2 => [2 * rows + pad, 2],
            3 => [3, 3 * rows + pad],
            _ => [0, 0],
        };
        self
    }

    /// Whether the library must refuse the struct for its size.
    pub fn has_no_struct(&self) -> bool {
        self.struct_size != 0 && is_refused::<Arguments>(self.struct_size, ARGUMENTS_IN_0_1)
    }

    /// Host rows that f and K have.
    pub fn rows(&self, unknowns: usize) -> usize {
        let last = self.map.iter().flatten().copied().max();
        last.map_or(unknowns, |last| usize::try_from(last + 1).unwrap_or(0))
    }

    /// Strides of K with the default filled in; `None` where the interface must refuse them.
    pub fn k_layout(&self, unknowns: usize) -> Option<[usize; 2]> {
        let rows = self.rows(unknowns);
        let [row, column] = self.k_strides;
        if row == 0 && column == 0 {
            return Some([rows, 1]);
        }
        // nothing that the plan makes lies between: refused, or small; a single entry has no distance to another
        let fits = |stride: i64| match rows {
            0 | 1 if stride > 0 => Some(1),
            _ => (1..1 << 16).contains(&stride).then_some(stride as usize),
        };
        Some([fits(row)?, fits(column)?])
    }

    /// One change of the call itself.
    pub fn change(&mut self, element: &Element, entropy: &mut Entropy) {
        const WRONG: [i64; 6] = [-1, i64::MIN, i64::MAX, 1 << 61, 1, -3];
        match entropy.below(14) {
            0 => self.null = Some(entropy.pick(&ARRAYS)),
            1 => self.request ^= 1 << entropy.below(32),
            2 => self.request = entropy.bits() as u32,
            3 => self.nnode = entropy.strange_i32(self.nnode),
            4 if element.interpolated() => {
                self.nslave = entropy.pick(&[0, -1, i32::MIN, i32::MAX, 1 << 30, (1 << 30) - 1]);
            }
            4 => self.nslave = entropy.strange_i32(self.nslave),
            5 => self.parameter_count = entropy.strange_i32(self.parameter_count),
            6 => {
                let which = entropy.below(2);
                self.strides[which] = entropy.pick(&WRONG);
            }
            7 => {
                let which = entropy.below(2);
                self.k_strides[which] = entropy.pick(&WRONG);
            }
            8 => {
                let unknowns = element.unknowns(self.state.nodes);
                let map = self
                    .map
                    .get_or_insert_with(|| (0..unknowns as i32).collect());
                let at = entropy.below(map.len());
                // a row twice is not checked: the numbers mean nothing, the memory is the same
                map[at] = entropy.pick(&[-1, i32::MIN, 0]);
            }
            9 => {
                let which = entropy.below(2);
                self.scales[which] = entropy.strange(1.0);
            }
            10 => self.short = entropy.pick(&[1, 2, i64::MAX, -1000]),
            11 => {
                self.struct_size =
                    entropy.pick(&[1, 4, 8, 223, 225, ARGUMENTS_IN_0_1, 376, u32::MAX])
            }
            _ => {
                if let Some(old) = &mut self.old {
                    change_list(old, entropy.chance(1, 8), entropy);
                }
            }
        }
    }
}

/// From node to node.
fn stride(d: i64, entropy: &mut Entropy) -> i64 {
    match entropy.below(8) {
        0 => d,
        1 => d + 1,
        2 => d + entropy.below(6) as i64,
        3 => 300,
        _ => 0,
    }
}

/// Different rows in any order, with gaps.
fn spread(unknowns: usize, entropy: &mut Entropy) -> Vec<i32> {
    let gap = 1 + entropy.below(2);
    let mut map: Vec<i32> = (0..unknowns).map(|i| (i * gap) as i32).collect();
    for i in (1..unknowns).rev() {
        map.swap(i, entropy.below(i + 1));
    }
    map
}
