//! Relative position r of a pair and its derivatives: at a point, and over a box of parameters.

use super::interval::{Interval, Scratch, evaluate};
use crate::table::Table;

/// Components of a vector; the third is 0 in 2D.
pub(super) type Vector = [f64; 3];
/// Most inputs of a geometry: parameters of the projection, weights or parameters of its own.
const MOST_INPUTS: usize = 64;
/// Most outputs: values, first and second derivatives.
const MOST_OUTPUTS: usize = 512;

/// One side of a pair, in the frame of the search.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Side<'a> {
    /// One point that stays.
    Fixed(Vector),
    /// Shape functions and nodes.
    Shape {
        /// Values, first and second derivatives of the shape functions.
        program: &'a Table,
        /// Positions, tangent vectors.
        nodes: &'a [Vector],
        /// Weights of a rational geometry.
        weights: &'a [f64],
        /// Its parameters: 1 or 2.
        p: usize,
    },
    /// A rigid position.
    Rigid {
        /// Position, first and second derivatives.
        program: &'a Table,
        /// Its run-time parameters.
        parameters: &'a [f64],
        /// Its parameters: 1 or 2.
        p: usize,
        /// Components of the position.
        d: usize,
    },
}

/// r, r_,i and r_,11 r_,12 r_,22, or those of one side.
#[derive(Clone, Copy, Debug)]
pub(super) struct Local<T> {
    pub(super) r: [T; 3],
    pub(super) b: [[T; 3]; 2],
    pub(super) second: [[T; 3]; 3],
}

/// Sums from which positions are computed.
pub(super) trait Number: Copy {
    const ZERO: Self;
    fn plus(self, other: Self) -> Self;
    fn minus(self, other: Self) -> Self;
    fn times(self, factor: f64) -> Self;
}

impl Number for f64 {
    const ZERO: Self = 0.0;
    fn plus(self, other: Self) -> Self {
        self + other
    }
    fn minus(self, other: Self) -> Self {
        self - other
    }
    fn times(self, factor: f64) -> Self {
        self * factor
    }
}

impl Number for Interval {
    const ZERO: Self = Interval::ZERO;
    fn plus(self, other: Self) -> Self {
        self.add(other)
    }
    fn minus(self, other: Self) -> Self {
        self.subtract(other)
    }
    fn times(self, factor: f64) -> Self {
        Interval::times(self, factor)
    }
}

impl<T: Number> Local<T> {
    const ZERO: Self = Self {
        r: [T::ZERO; 3],
        b: [[T::ZERO; 3]; 2],
        second: [[T::ZERO; 3]; 3],
    };

    /// The nine vectors in the order of a program's outputs: value, p first, p(p+1)/2 second derivatives.
    fn slots(&mut self, p: usize) -> impl Iterator<Item = &mut [T; 3]> {
        let [first, mixed, last] = &mut self.second;
        let [b1, b2] = &mut self.b;
        let list = match p {
            1 => [Some(&mut self.r), Some(b1), Some(first), None, None, None],
            _ => [
                Some(&mut self.r),
                Some(b1),
                Some(b2),
                Some(first),
                Some(mixed),
                Some(last),
            ],
        };
        list.into_iter().flatten()
    }
}

impl Side<'_> {
    /// Parameters that are projected.
    pub(super) fn parameters(&self) -> usize {
        match self {
            Side::Fixed(_) => 0,
            Side::Shape { p, .. } | Side::Rigid { p, .. } => *p,
        }
    }

    fn program(&self) -> Option<(&Table, &[f64])> {
        match self {
            Side::Fixed(_) => None,
            Side::Shape {
                program, weights, ..
            } => Some((program, weights)),
            Side::Rigid {
                program,
                parameters,
                ..
            } => Some((program, parameters)),
        }
    }

    /// The position and its derivatives from the outputs of the program.
    fn collect<T: Number>(&self, output: impl Fn(usize) -> T) -> Local<T> {
        let mut local = Local::<T>::ZERO;
        match self {
            Side::Fixed(_) => {}
            Side::Shape { nodes, p, .. } => {
                for (row, slot) in local.slots(*p).enumerate() {
                    for (a, node) in nodes.iter().enumerate() {
                        let shape = output(row * nodes.len() + a);
                        for (entry, &x) in slot.iter_mut().zip(node) {
                            *entry = entry.plus(shape.times(x));
                        }
                    }
                }
            }
            Side::Rigid { p, d, .. } => {
                for (row, slot) in local.slots(*p).enumerate() {
                    for (k, entry) in slot.iter_mut().take(*d).enumerate() {
                        *entry = output(row * d + k);
                    }
                }
            }
        }
        local
    }

    /// At parameters `zeta`.
    fn at(&self, zeta: &[f64]) -> Local<f64> {
        if let Side::Fixed(x) = self {
            let mut local = Local::ZERO;
            local.r = *x;
            return local;
        }
        let Some((program, own)) = self.program() else {
            return Local::ZERO;
        };
        let (mut inputs, mut outputs) = ([0.0; MOST_INPUTS], [0.0; MOST_OUTPUTS]);
        for (input, &value) in inputs
            .iter_mut()
            .zip(zeta.iter().take(self.parameters()).chain(own))
        {
            *input = value;
        }
        let (inputs, outputs) = (
            inputs.get(..program.inputs.len()).unwrap_or_default(),
            outputs.get_mut(..program.outputs.len()).unwrap_or_default(),
        );
        (program.compiled)(inputs, outputs);
        self.collect(|index| outputs.get(index).copied().unwrap_or(0.0))
    }

    /// Over a box of parameters.
    fn over(&self, zeta: &[Interval], scratch: &mut Scratch) -> Local<Interval> {
        if let Side::Fixed(x) = self {
            let mut local = Local::ZERO;
            local.r = x.map(Interval::exactly);
            return local;
        }
        let Some((program, own)) = self.program() else {
            return Local::ZERO;
        };
        let mut inputs = [Interval::ZERO; MOST_INPUTS];
        let own = own.iter().map(|&value| Interval::exactly(value));
        for (input, value) in inputs
            .iter_mut()
            .zip(zeta.iter().take(self.parameters()).copied().chain(own))
        {
            *input = value;
        }
        evaluate(program, &inputs, scratch);
        self.collect(|index| {
            let place = program.outputs.get(index).map(|&(_, place)| place);
            let value = place.and_then(|place| scratch.get(usize::from(place)));
            value.copied().unwrap_or(Interval::ZERO)
        })
    }

    /// True where the side can be searched: its program fits.
    fn fits(&self) -> bool {
        self.program().is_none_or(|(program, own)| {
            program.operations.len() <= super::interval::MOST_OPERATIONS
                && program.outputs.len() <= MOST_OUTPUTS
                && program.inputs.len() <= MOST_INPUTS
                && own.len() + self.parameters() >= program.inputs.len()
        })
    }
}

/// Slave and master; parameters of a projected slave curve come first.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sides<'a> {
    pub(crate) slave: Side<'a>,
    pub(crate) master: Side<'a>,
}

impl Sides<'_> {
    /// Parameters that are projected.
    pub(super) fn parameters(&self) -> usize {
        self.slave.parameters() + self.master.parameters()
    }

    /// True where both can be searched.
    pub(super) fn fit(&self) -> bool {
        self.slave.fits() && self.master.fits() && self.parameters() <= 2
    }

    /// r and its derivatives at ζ.
    pub(super) fn at(&self, zeta: &[f64; 2]) -> Local<f64> {
        let (own, other) = zeta.split_at(self.slave.parameters().min(2));
        self.relative(self.slave.at(own), self.master.at(other))
    }

    /// r and r_,i at ζ.
    pub(crate) fn relative_at(&self, zeta: &[f64; 2]) -> (Vector, [Vector; 2]) {
        let local = self.at(zeta);
        (local.r, local.b)
    }

    /// Positions on slave and master.
    pub(super) fn positions(&self, zeta: &[f64; 2]) -> [Vector; 2] {
        let (own, other) = zeta.split_at(self.slave.parameters().min(2));
        [self.slave.at(own).r, self.master.at(other).r]
    }

    /// r and its derivatives over a box.
    pub(super) fn over(&self, zeta: &[Interval; 2], scratch: &mut Scratch) -> Local<Interval> {
        let (own, other) = zeta.split_at(self.slave.parameters().min(2));
        let slave = self.slave.over(own, scratch);
        self.relative(slave, self.master.over(other, scratch))
    }

    fn relative<T: Number>(&self, slave: Local<T>, master: Local<T>) -> Local<T> {
        let minus = |a: [T; 3], b: [T; 3]| core::array::from_fn(|k| a[k].minus(b[k]));
        let mut relative = Local::<T>::ZERO;
        relative.r = minus(slave.r, master.r);
        let none = [T::ZERO; 3];
        if self.slave.parameters() == 1 {
            relative.b = [slave.b[0], minus(none, master.b[0])];
            relative.second = [slave.second[0], none, minus(none, master.second[0])];
        } else {
            relative.b = master.b.map(|b| minus(none, b));
            relative.second = master.second.map(|b| minus(none, b));
        }
        relative
    }
}
