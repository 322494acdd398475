//! A program while it is written: scalars with the operators of arithmetic, terms with their tags.
//!
//! A [`Scalar`] is a copyable handle of a node, so that a formula reads as one: `c/a * (kappa*m)`. Every operation
//! adds its node at once, in the order in which Rust evaluates the formula; the same formula gives the same program.

use std::cell::RefCell;
use std::ops::{Add, Div, Mul, Neg, Sub};

use super::{Binary, Graph, NodeId, Program, Term, TermId, Unary, differentiate};

/// A program that is being written.
pub struct Sheet {
    program: RefCell<Program>,
}

/// A value of a [`Sheet`].
#[derive(Clone, Copy)]
pub struct Scalar<'s> {
    sheet: &'s Sheet,
    id: NodeId,
}

impl Sheet {
    /// An empty sheet for the program `name`.
    pub fn new(name: &str) -> Self {
        Self {
            program: RefCell::new(Program {
                name: name.to_string(),
                ..Program::default()
            }),
        }
    }

    /// The finished program, with every term marked as present or left out.
    pub fn finish(self) -> Program {
        let mut program = self.program.into_inner();
        program.settle_terms();
        program
    }

    fn scalar(&self, node: impl FnOnce(&mut Graph) -> NodeId) -> Scalar<'_> {
        let id = node(&mut self.program.borrow_mut().graph);
        Scalar { sheet: self, id }
    }

    /// The constant `value`.
    pub fn constant(&self, value: f64) -> Scalar<'_> {
        self.scalar(|graph| graph.constant(value))
    }

    /// 0
    pub fn zero(&self) -> Scalar<'_> {
        self.constant(0.0)
    }

    /// 1
    pub fn one(&self) -> Scalar<'_> {
        self.constant(1.0)
    }

    /// Adds an input.
    pub fn input(&self, name: impl Into<String>) -> Scalar<'_> {
        let number = {
            let inputs = &mut self.program.borrow_mut().inputs;
            inputs.push(name.into());
            inputs.len() - 1
        };
        self.scalar(|graph| graph.input(number))
    }

    /// The input `name` that exists already.
    ///
    /// # Panics
    /// There is no such input.
    pub fn existing_input(&self, name: &str) -> Scalar<'_> {
        let at = {
            let inputs = &self.program.borrow().inputs;
            inputs.iter().position(|input| input == name)
        };
        let at = at.expect("an input that exists");
        self.scalar(|graph| graph.input(at))
    }

    /// Σ term(i) over `indices`
    pub fn sum<'s, I>(
        &'s self,
        indices: impl IntoIterator<Item = I>,
        term: impl Fn(I) -> Scalar<'s>,
    ) -> Scalar<'s> {
        let sums = indices.into_iter();
        sums.fold(self.zero(), |sum, index| sum + term(index))
    }

    /// Marks `coefficient` as the coefficient of the term with equation tag `tag`. Where nothing that
    /// reaches an output uses it, [`Sheet::finish`] records it as left out for `reason`.
    pub fn term<'s>(
        &'s self,
        tag: &'static str,
        coefficient: Scalar<'s>,
        reason: &str,
    ) -> Scalar<'s> {
        self.terms(tag, &[coefficient], reason)[0]
    }

    /// [`Sheet::term`] with several coefficients.
    pub fn terms<'s>(
        &'s self,
        tag: &'static str,
        coefficients: &[Scalar<'s>],
        reason: &str,
    ) -> Vec<Scalar<'s>> {
        let id = self.record(tag, true, reason);
        let mark = |coefficient: &Scalar<'s>| self.scalar(|graph| graph.term(coefficient.id, id));
        coefficients.iter().map(mark).collect()
    }

    /// Records a term that this form of the linearisation does not have.
    pub fn left_out(&self, tag: &'static str, reason: &str) {
        self.record(tag, false, reason);
    }

    fn record(&self, tag: &'static str, present: bool, reason: &str) -> TermId {
        let terms = &mut self.program.borrow_mut().terms;
        terms.push(Term {
            tag,
            present,
            reason: reason.to_string(),
        });
        TermId(u16::try_from(terms.len() - 1).expect("fewer than 65536 terms"))
    }

    /// Adds an output.
    pub fn output(&self, name: impl Into<String>, value: Scalar<'_>) {
        let outputs = &mut self.program.borrow_mut().outputs;
        outputs.push((name.into(), value.id));
    }

    /// Adds the outputs `name_0 …`.
    pub fn outputs(&self, name: &str, values: &[Scalar<'_>]) {
        for (k, &value) in values.iter().enumerate() {
            self.output(format!("{name}_{k}"), value);
        }
    }
}

impl<'s> Scalar<'s> {
    /// No value yet: fills the unused room of a vector or tensor.
    pub(super) fn unset(sheet: &'s Sheet) -> Self {
        let id = NodeId(u32::MAX);
        Self { sheet, id }
    }

    /// The sheet that it stands on.
    pub fn sheet(self) -> &'s Sheet {
        self.sheet
    }

    /// True where the value vanishes identically.
    pub fn vanishes(self) -> bool {
        self.sheet.program.borrow().graph.is(self.id, 0.0)
    }

    /// ∂self/∂(input number `input`)
    pub fn derivative(self, input: usize) -> Self {
        self.sheet
            .scalar(|graph| differentiate(graph, self.id, input))
    }

    /// An elementary function of the value.
    pub fn unary(self, function: Unary) -> Self {
        self.sheet.scalar(|graph| graph.unary(function, self.id))
    }

    /// An elementary function of two values.
    pub fn binary(self, function: Binary, other: Self) -> Self {
        self.sheet
            .scalar(|graph| graph.binary(function, self.id, other.id))
    }

    /// √a
    pub fn sqrt(self) -> Self {
        self.unary(Unary::Sqrt)
    }

    /// sin a
    pub fn sin(self) -> Self {
        self.unary(Unary::Sin)
    }

    /// The angle of the point (x, self).
    pub fn atan2(self, x: Self) -> Self {
        self.binary(Binary::Atan2, x)
    }

    /// a²
    pub fn square(self) -> Self {
        self * self
    }
}

impl Neg for Scalar<'_> {
    type Output = Self;
    fn neg(self) -> Self {
        self.sheet.scalar(|graph| graph.negate(self.id))
    }
}

/// One operator between scalars, and between a number and a scalar.
macro_rules! operator {
    ($trait:ident, $method:ident, $node:ident) => {
        impl $trait for Scalar<'_> {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                self.sheet.scalar(|graph| graph.$node(self.id, other.id))
            }
        }

        impl<'s> $trait<Scalar<'s>> for f64 {
            type Output = Scalar<'s>;
            fn $method(self, other: Scalar<'s>) -> Scalar<'s> {
                other.sheet.constant(self).$method(other)
            }
        }
    };
}

operator!(Add, add, add);
operator!(Sub, sub, subtract);
operator!(Mul, mul, multiply);
operator!(Div, div, divide);
