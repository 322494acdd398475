//! Vectors and symmetric tensors of scalars, as small as a contact point needs them.

use std::array::from_fn;
use std::ops::{Add, Deref, Index, Mul, Sub};

use super::sheet::{Scalar, Sheet};

/// Largest dimension.
const MOST: usize = 3;
/// Entries of the largest symmetric tensor.
const MOST_PAIRS: usize = MOST * (MOST + 1) / 2;

/// A vector of at most three components; it derefs to the slice of them.
#[derive(Clone, Copy)]
pub struct Vector<'s> {
    components: [Scalar<'s>; MOST],
    n: usize,
}

impl<'s> Vector<'s> {
    /// The vector of `components`.
    ///
    /// # Panics
    /// There are more than three.
    pub fn new(sheet: &'s Sheet, components: impl IntoIterator<Item = Scalar<'s>>) -> Self {
        let mut result = Self {
            components: [Scalar::unset(sheet); MOST],
            n: 0,
        };
        for component in components {
            result.components[result.n] = component;
            result.n += 1;
        }
        result
    }

    fn map(self, value: impl Fn(usize) -> Scalar<'s>) -> Self {
        let mut result = self;
        (0..self.n).for_each(|k| result.components[k] = value(k));
        result
    }

    /// True where every component vanishes identically.
    pub fn vanishes(&self) -> bool {
        self.iter().all(|component| component.vanishes())
    }

    /// a·b
    pub fn dot(self, other: Self) -> Scalar<'s> {
        let sheet = self.components[0].sheet();
        sheet.sum(0..self.n, |k| self[k] * other[k])
    }

    /// a×b in three dimensions.
    pub fn cross(self, other: Self) -> Self {
        let component = |i: usize, j: usize| self[i] * other[j] - self[j] * other[i];
        self.map(|k| component((k + 1) % MOST, (k + 2) % MOST))
    }

    /// |a|
    pub fn norm(self) -> Scalar<'s> {
        self.dot(self).sqrt()
    }

    /// Changes component `k`.
    pub fn set(&mut self, k: usize, value: Scalar<'s>) {
        self.components[k] = value;
    }
}

/// Vectors on a sheet.
impl Sheet {
    /// The zero vector of dimension `n`.
    pub fn zeros(&self, n: usize) -> Vector<'_> {
        let zero = self.zero();
        Vector::new(self, (0..n).map(|_| zero))
    }

    /// Adds the inputs `name_0 … name_{n-1}`.
    pub fn input_vector(&self, name: &str, n: usize) -> Vector<'_> {
        Vector::new(self, (0..n).map(|k| self.input(format!("{name}_{k}"))))
    }

    /// The inputs `name_0 … name_{n-1}` that exist already.
    pub fn existing_vector(&self, name: &str, n: usize) -> Vector<'_> {
        let names = (0..n).map(|k| format!("{name}_{k}"));
        Vector::new(self, names.map(|name| self.existing_input(&name)))
    }

    /// Σ term(i) over `indices`, of vectors of dimension `n`
    pub fn sum_vectors<'s, I>(
        &'s self,
        n: usize,
        indices: impl IntoIterator<Item = I>,
        term: impl Fn(I) -> Vector<'s>,
    ) -> Vector<'s> {
        let sums = indices.into_iter();
        sums.fold(self.zeros(n), |sum, index| sum + term(index))
    }
}

impl<'s> Deref for Vector<'s> {
    type Target = [Scalar<'s>];
    fn deref(&self) -> &[Scalar<'s>] {
        &self.components[..self.n]
    }
}

impl Add for Vector<'_> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.map(|k| self[k] + other[k])
    }
}

impl Sub for Vector<'_> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.map(|k| self[k] - other[k])
    }
}

impl<'s> Mul<Vector<'s>> for Scalar<'s> {
    type Output = Vector<'s>;
    fn mul(self, vector: Vector<'s>) -> Vector<'s> {
        vector.map(|k| self * vector[k])
    }
}

/// A symmetric tensor of dimension 0 to 3, indexed by (i, j).
#[derive(Clone, Copy)]
pub struct Symmetric<'s> {
    /// Entries i ≤ j, row by row: 11, 12, 22 in two dimensions.
    entries: [Scalar<'s>; MOST_PAIRS],
    n: usize,
}

/// The index pairs i ≤ j of a symmetric tensor, row by row.
pub fn pairs(n: usize) -> impl Iterator<Item = (usize, usize)> + Clone {
    (0..n).flat_map(move |i| (i..n).map(move |j| (i, j)))
}

impl<'s> Symmetric<'s> {
    /// The tensor with the entries `entry(i, j)`, i ≤ j, made row by row.
    pub fn new(
        sheet: &'s Sheet,
        n: usize,
        entry: impl FnMut((usize, usize)) -> Scalar<'s>,
    ) -> Self {
        let mut made = pairs(n).map(entry);
        let unset = Scalar::unset(sheet);
        let entries = from_fn(|_| made.next().unwrap_or(unset));
        Self { entries, n }
    }

    /// The tensor of dimension 2 with the entries 11, 12, 22.
    pub fn two(sheet: &'s Sheet, first: Scalar<'s>, mixed: Scalar<'s>, last: Scalar<'s>) -> Self {
        let mut made = [first, mixed, last].into_iter();
        Self::new(sheet, 2, |_| made.next().unwrap_or(last))
    }

    /// The entries i ≤ j, row by row.
    pub fn entries(&self) -> &[Scalar<'s>] {
        &self.entries[..self.n * (self.n + 1) / 2]
    }

    /// Position of entry (i, j).
    fn position(&self, i: usize, j: usize) -> usize {
        let (i, j) = (i.min(j), i.max(j));
        i * self.n + j - i * (i + 1) / 2
    }

    /// The tensor of `value(entry)`.
    pub fn map(mut self, value: impl Fn(Scalar<'s>) -> Scalar<'s>) -> Self {
        let count = self.entries().len();
        for entry in &mut self.entries[..count] {
            *entry = value(*entry);
        }
        self
    }

    /// The inverse of a tensor of dimension 1 or 2; `one` is the constant 1.
    pub fn inverse(self, one: Scalar<'s>) -> Self {
        let mut result = self;
        match *self.entries() {
            [f11] => result.entries[0] = one / f11,
            [f11, f12, f22] => {
                let determinant = f11 * f22 - f12.square();
                let back = -f12;
                let all = [f22 / determinant, back / determinant, f11 / determinant];
                result.entries[..3].copy_from_slice(&all);
            }
            _ => {}
        }
        result
    }

    /// Σ_ij b_i t_ij b_j with vectors of dimension `d`
    pub fn sandwich(&self, sheet: &'s Sheet, b: &[Vector<'s>], d: usize) -> Self {
        let n = b.len();
        let mixed: Vec<Vector> = (0..n)
            .map(|i| sheet.sum_vectors(d, 0..n, |j| self[(i, j)] * b[j]))
            .collect();
        Self::new(sheet, d, |(k, l)| {
            sheet.sum(0..n, |i| b[i][k] * mixed[i][l])
        })
    }
}

impl<'s> Index<(usize, usize)> for Symmetric<'s> {
    type Output = Scalar<'s>;
    fn index(&self, (i, j): (usize, usize)) -> &Scalar<'s> {
        &self.entries[self.position(i, j)]
    }
}
