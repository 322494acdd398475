//! The expression graph: immutable, hash-consed nodes with simplifying constructors.
//!
//! A node is never modified after it was made; equal expressions are one node, so common
//! subexpressions are shared by construction. The constructors remove what vanishes identically
//! (`0·x`, `x + 0`, `x·1`, constants of constants): that is how a flat facet loses its curvature.

use std::collections::HashMap;

/// Handle of a node within its [`Graph`]; operands always have smaller handles.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct NodeId(pub u32);

/// Index of a [`Term`](super::Term) in its program.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct TermId(pub u16);

/// One operation on `f64`.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Node {
    /// A constant, by its bits.
    Constant(u64),
    /// Entry of the program's input array.
    Input(u32),
    /// −a
    Negate(NodeId),
    /// a + b
    Add(NodeId, NodeId),
    /// a − b
    Subtract(NodeId, NodeId),
    /// a·b
    Multiply(NodeId, NodeId),
    /// a/b
    Divide(NodeId, NodeId),
    /// Function of one argument.
    Unary(Unary, NodeId),
    /// Function of two arguments.
    Binary(Binary, NodeId, NodeId),
    /// The value itself, marked as the coefficient of one term of a linearisation: the handle by
    /// which the mutation test drops, doubles or flips that term. Emitted code passes it through.
    Term(NodeId, TermId),
}

/// Elementary functions of one argument.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Unary {
    /// √a
    Sqrt,
    /// sin a
    Sin,
    /// cos a
    Cos,
    /// tan a
    Tan,
    /// eᵃ
    Exp,
    /// natural logarithm
    Ln,
}

/// Elementary functions of two arguments.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Binary {
    /// aᵇ
    Pow,
    /// angle of the point (b, a)
    Atan2,
}

/// Append-only store of nodes.
#[derive(Clone, Default, Debug)]
pub struct Graph {
    nodes: Vec<Node>,
    known: HashMap<Node, NodeId>,
}

impl Graph {
    /// An empty graph.
    pub fn new() -> Self {
        Self::default()
    }

    /// All nodes in order of creation (operands first).
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// The node behind a handle.
    pub fn node(&self, id: NodeId) -> Node {
        self.nodes[id.0 as usize]
    }

    /// Value of a constant node.
    pub fn value(&self, id: NodeId) -> Option<f64> {
        match self.node(id) {
            Node::Constant(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }

    /// True where the node is the constant `value`.
    pub fn is(&self, id: NodeId, value: f64) -> bool {
        self.value(id) == Some(value)
    }

    fn intern(&mut self, node: Node) -> NodeId {
        if let Some(&id) = self.known.get(&node) {
            return id;
        }
        let id = NodeId(u32::try_from(self.nodes.len()).expect("fewer than 2^32 nodes"));
        self.nodes.push(node);
        self.known.insert(node, id);
        id
    }

    /// The constant `value` (−0 is stored as 0).
    pub fn constant(&mut self, value: f64) -> NodeId {
        let value = if value == 0.0 { 0.0 } else { value };
        self.intern(Node::Constant(value.to_bits()))
    }

    /// The program's input number `index`.
    pub fn input(&mut self, index: usize) -> NodeId {
        self.intern(Node::Input(
            u32::try_from(index).expect("fewer than 2^32 inputs"),
        ))
    }

    /// −a
    pub fn negate(&mut self, a: NodeId) -> NodeId {
        match self.node(a) {
            Node::Constant(bits) => self.constant(-f64::from_bits(bits)),
            Node::Negate(inner) => inner,
            Node::Subtract(x, y) => self.subtract(y, x),
            _ => self.intern(Node::Negate(a)),
        }
    }

    /// a + b
    pub fn add(&mut self, a: NodeId, b: NodeId) -> NodeId {
        match (self.value(a), self.value(b)) {
            (Some(x), Some(y)) => return self.constant(x + y),
            (Some(0.0), _) => return b,
            (_, Some(0.0)) => return a,
            _ => {}
        }
        match (self.node(a), self.node(b)) {
            (_, Node::Negate(y)) => self.subtract(a, y),
            (Node::Negate(x), _) => self.subtract(b, x),
            _ => self.intern(Node::Add(a.min(b), a.max(b))),
        }
    }

    /// a − b
    pub fn subtract(&mut self, a: NodeId, b: NodeId) -> NodeId {
        match (self.value(a), self.value(b)) {
            (Some(x), Some(y)) => return self.constant(x - y),
            (Some(0.0), _) => return self.negate(b),
            (_, Some(0.0)) => return a,
            _ => {}
        }
        if a == b {
            return self.constant(0.0);
        }
        match self.node(b) {
            Node::Negate(y) => self.add(a, y),
            _ => self.intern(Node::Subtract(a, b)),
        }
    }

    /// a·b
    pub fn multiply(&mut self, a: NodeId, b: NodeId) -> NodeId {
        match (self.value(a), self.value(b)) {
            (Some(x), Some(y)) => return self.constant(x * y),
            (Some(0.0), _) | (_, Some(0.0)) => return self.constant(0.0),
            (Some(1.0), _) => return b,
            (_, Some(1.0)) => return a,
            (Some(-1.0), _) => return self.negate(b),
            (_, Some(-1.0)) => return self.negate(a),
            _ => {}
        }
        match (self.node(a), self.node(b)) {
            (Node::Negate(x), Node::Negate(y)) => self.multiply(x, y),
            (Node::Negate(x), _) => self.negated_product(x, b),
            (_, Node::Negate(y)) => self.negated_product(a, y),
            _ => self.intern(Node::Multiply(a.min(b), a.max(b))),
        }
    }

    fn negated_product(&mut self, a: NodeId, b: NodeId) -> NodeId {
        let product = self.multiply(a, b);
        self.negate(product)
    }

    /// a/b
    pub fn divide(&mut self, a: NodeId, b: NodeId) -> NodeId {
        match (self.value(a), self.value(b)) {
            (Some(x), Some(y)) if y != 0.0 => return self.constant(x / y),
            (Some(0.0), _) => return self.constant(0.0),
            (_, Some(1.0)) => return a,
            // a power of two has an exact reciprocal
            (_, Some(y)) if y != 0.0 && (1.0 / y) * y == 1.0 && is_power_of_two(y) => {
                let reciprocal = self.constant(1.0 / y);
                return self.multiply(a, reciprocal);
            }
            _ => {}
        }
        self.intern(Node::Divide(a, b))
    }

    /// Elementary function of one argument. Constants are folded only where the result is exact on
    /// every machine (square roots of squares, values at 0).
    pub fn unary(&mut self, function: Unary, a: NodeId) -> NodeId {
        if let Some(x) = self.value(a) {
            match function {
                Unary::Sqrt if x >= 0.0 => return self.constant(x.sqrt()),
                Unary::Sin | Unary::Tan if x == 0.0 => return self.constant(0.0),
                Unary::Cos | Unary::Exp if x == 0.0 => return self.constant(1.0),
                Unary::Ln if x == 1.0 => return self.constant(0.0),
                _ => {}
            }
        }
        self.intern(Node::Unary(function, a))
    }

    /// Elementary function of two arguments; small whole powers become products.
    pub fn binary(&mut self, function: Binary, a: NodeId, b: NodeId) -> NodeId {
        if let (Binary::Pow, Some(y)) = (function, self.value(b)) {
            if y == 0.0 {
                return self.constant(1.0);
            }
            if y.fract() == 0.0 && (1.0..=8.0).contains(&y) {
                return self.whole_power(a, y as u32);
            }
        }
        self.intern(Node::Binary(function, a, b))
    }

    fn whole_power(&mut self, a: NodeId, exponent: u32) -> NodeId {
        if exponent == 1 {
            return a;
        }
        let half = self.whole_power(a, exponent / 2);
        let square = self.multiply(half, half);
        if exponent.is_multiple_of(2) {
            square
        } else {
            self.multiply(square, a)
        }
    }

    /// Marks `a` as the coefficient of a term; a coefficient that vanishes identically needs no mark.
    pub fn term(&mut self, a: NodeId, term: TermId) -> NodeId {
        if self.is(a, 0.0) {
            a
        } else {
            self.intern(Node::Term(a, term))
        }
    }

    /// Rebuilds `node` with its operands taken from `map`, through the simplifying constructors.
    pub fn rebuild(&mut self, node: Node, map: impl Fn(NodeId) -> NodeId) -> NodeId {
        match node {
            Node::Constant(bits) => self.constant(f64::from_bits(bits)),
            Node::Input(index) => self.input(index as usize),
            Node::Negate(a) => self.negate(map(a)),
            Node::Add(a, b) => self.add(map(a), map(b)),
            Node::Subtract(a, b) => self.subtract(map(a), map(b)),
            Node::Multiply(a, b) => self.multiply(map(a), map(b)),
            Node::Divide(a, b) => self.divide(map(a), map(b)),
            Node::Unary(function, a) => self.unary(function, map(a)),
            Node::Binary(function, a, b) => self.binary(function, map(a), map(b)),
            Node::Term(a, term) => self.term(map(a), term),
        }
    }
}

impl Node {
    /// Operands of the node, in order.
    pub fn operands(self) -> impl Iterator<Item = NodeId> {
        let (a, b) = match self {
            Node::Constant(_) | Node::Input(_) => (None, None),
            Node::Negate(a) | Node::Unary(_, a) | Node::Term(a, _) => (Some(a), None),
            Node::Add(a, b)
            | Node::Subtract(a, b)
            | Node::Multiply(a, b)
            | Node::Divide(a, b)
            | Node::Binary(_, a, b) => (Some(a), Some(b)),
        };
        a.into_iter().chain(b)
    }

    /// True where the node costs an arithmetic operation at run time.
    pub fn is_operation(self) -> bool {
        !matches!(self, Node::Constant(_) | Node::Input(_) | Node::Term(..))
    }
}

fn is_power_of_two(value: f64) -> bool {
    value.is_normal() && value.to_bits() & ((1 << 52) - 1) == 0
}
