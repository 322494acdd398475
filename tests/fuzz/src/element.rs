//! What the interface tells of its elements.

use std::ffi::CStr;

use contact_elements::Registered;
use contact_elements::abi::Info;

use crate::interface::Interface;

/// First kinds of unknowns, `CTE_UNKNOWN_TX` and `CTE_UNKNOWN_MULTIPLIER`.
const TANGENT_VECTOR: i32 = 4;
const MULTIPLIER: i32 = 7;

/// An element as a host knows it.
#[derive(Clone, Debug)]
pub struct Element {
    /// Its index.
    pub index: i32,
    /// Its name.
    pub name: String,
    /// The opaque pointer.
    pub pointer: *const Registered,
    /// `cte_info` of the smallest call.
    pub info: Info,
    /// Parameters in order.
    pub parameters: Vec<Range>,
    /// Per node of the smallest call: whether it is a tangent vector.
    pub vectors: Vec<bool>,
    /// Nodes of multipliers.
    pub multipliers: usize,
}

/// A parameter.
#[derive(Clone, Debug)]
pub struct Range {
    /// Name.
    pub name: String,
    /// Bounds.
    pub lower: f64,
    /// Bounds.
    pub upper: f64,
    /// Whether they belong to the range.
    pub closed: bool,
}

impl Element {
    /// All elements of a library.
    pub fn all(interface: &Interface) -> Result<Vec<Self>, String> {
        // SAFETY: no arguments.
        let count = unsafe { (interface.table.element_count)() };
        (0..count)
            .map(|index| Self::new(interface, index))
            .collect()
    }

    fn new(interface: &Interface, index: i32) -> Result<Self, String> {
        let table = &interface.table;
        // SAFETY: any index may be asked for.
        let pointer = unsafe { (table.element_get)(index) };
        if pointer.is_null() {
            return Err(format!("element {index} is null"));
        }
        let info = info(interface, pointer, 0)?;
        // SAFETY: a static, zero-terminated text.
        let name = unsafe { text(info.name) };
        let parameters = (0..info.parameters)
            .map(|parameter| range(interface, pointer, parameter))
            .collect::<Result<_, _>>()?;
        let mut vectors = vec![false; info.nodes_minimum as usize];
        let mut multipliers = 0;
        for unknown in 0..info.unknowns {
            let (mut node, mut kind) = (0, 0);
            // SAFETY: both outputs are integers.
            let code =
                unsafe { (table.element_unknown)(pointer, 0, unknown, &mut node, &mut kind) };
            if code != 0 {
                return Err(format!("{name}: unknown {unknown} has no kind: {code}"));
            }
            multipliers += usize::from(kind == MULTIPLIER);
            vectors[node as usize] |= (TANGENT_VECTOR..MULTIPLIER).contains(&kind);
        }
        Ok(Self {
            index,
            name,
            pointer,
            info,
            parameters,
            vectors,
            multipliers,
        })
    }

    /// True where the slave row comes in the call.
    pub fn interpolated(&self) -> bool {
        self.info.nodes_maximum == 0
    }

    /// Space dimension.
    pub fn dimension(&self) -> usize {
        self.info.dimension as usize
    }

    /// Slave nodes of the smallest call.
    pub fn slaves(&self) -> usize {
        (self.info.slave_nodes as usize).max(1)
    }

    /// Master nodes.
    pub fn masters(&self) -> usize {
        self.info.master_nodes as usize
    }

    /// Nodes of a call with this many slave nodes.
    pub fn nodes(&self, nslave: usize) -> usize {
        nslave + self.masters() + self.multipliers
    }

    /// Unknowns of a call with this many nodes.
    pub fn unknowns(&self, nodes: usize) -> usize {
        (nodes - self.multipliers) * self.dimension() + self.multipliers
    }

    /// Doubles of history.
    pub fn history(&self) -> usize {
        self.info.history as usize
    }

    /// Contact points.
    pub fn points(&self) -> usize {
        self.info.points as usize
    }

    /// Doubles of history of one contact point.
    pub fn point_history(&self) -> usize {
        self.history() / self.points()
    }
}

/// `cte_element_info` of a valid call.
pub(crate) fn info(
    interface: &Interface,
    element: *const Registered,
    nnode: i32,
) -> Result<Info, String> {
    let mut info = Info::EMPTY;
    // SAFETY: the struct begins with its size.
    match unsafe { (interface.table.element_info)(element, nnode, &mut info) } {
        0 => Ok(info),
        code => Err(format!("no description with {nnode} nodes: {code}")),
    }
}

fn range(interface: &Interface, element: *const Registered, index: i32) -> Result<Range, String> {
    let (mut name, mut unit) = (std::ptr::null(), std::ptr::null());
    let (mut lower, mut upper, mut closed) = (0.0, 0.0, 0);
    // SAFETY: every output has its type.
    unsafe {
        let code = (interface.table.element_parameter)(
            element,
            index,
            &mut name,
            &mut unit,
            &mut lower,
            &mut upper,
            &mut closed,
        );
        if code != 0 || text(unit).is_empty() {
            return Err(format!("parameter {index} is not described: {code}"));
        }
        Ok(Range {
            name: text(name),
            lower,
            upper,
            closed: closed != 0,
        })
    }
}

/// A text of the library; empty for null.
///
/// # Safety
/// `text` is null or zero-terminated.
pub unsafe fn text(text: *const u8) -> String {
    if text.is_null() {
        return String::new();
    }
    // SAFETY: promised by the caller.
    let text = unsafe { CStr::from_ptr(text.cast()) };
    text.to_string_lossy().into_owned()
}
