//! Rows of K against the sum that they stand for [eq:contraction], one by one and several at a time.

use crate::element::contraction::{NormalContraction, contract};
use crate::element::receiver::{Receiver, Report, Write};
use crate::element::stage::Temporaries;
use crate::point::values::Coefficients;

const MOST: usize = 40;

/// Takes rows one by one, or offers all of its entries.
struct Matrix {
    /// Length of a row: longer where an element has multipliers.
    apart: usize,
    entries: Vec<f64>,
    is_open: bool,
}

impl Receiver for Matrix {
    fn open(&mut self, _: usize) {}
    fn force(&mut self, _: (usize, usize), _: f64, _: Write) {}
    fn rows(&mut self) -> Option<(&mut [f64], usize)> {
        self.is_open
            .then_some((self.entries.as_mut_slice(), self.apart))
    }
    fn row(&mut self, unknown: usize, row: &[f64], write: Write) {
        let to = &mut self.entries[unknown * self.apart..][..row.len()];
        for (to, &value) in to.iter_mut().zip(row) {
            *to = match write {
                Write::Replace => value,
                Write::Add => *to + value,
            };
        }
    }
    fn multiplier(&mut self, _: (usize, usize), _: f64) {}
    fn coupling(&mut self, _: usize, _: usize, _: f64) {}
    fn clear(&mut self, _: usize) {}
    fn report(&mut self, _: usize, _: &Report) {}
    fn energy(&mut self, _: f64) {}
}

/// Numbers that repeat in no hurry.
struct Numbers(f64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = (self.0 * 7.77 + 0.123) % 1.9;
        self.0 - 0.9
    }
    fn several<const N: usize>(&mut self) -> [f64; N] {
        core::array::from_fn(|_| self.next())
    }
}

struct Case<const D: usize, const P: usize> {
    s: Vec<f64>,
    ds: [Vec<f64>; P],
    n: [f64; D],
    coefficients: Coefficients<D, P>,
    measure: Vec<f64>,
    moving: bool,
}

impl<const D: usize, const P: usize> Case<D, P> {
    fn new(nodes: usize, moving: bool, measured: bool) -> Self {
        let mut numbers = Numbers(1.0);
        let mut coefficients = Coefficients::<D, P> {
            p: core::array::from_fn(|_| numbers.several()),
            ..Coefficients::default()
        };
        if moving {
            coefficients.right = core::array::from_fn(|_| numbers.several());
            coefficients.left = core::array::from_fn(|_| numbers.several());
            coefficients.s = core::array::from_fn(|_| numbers.several());
        }
        let several = |numbers: &mut Numbers, n: usize| (0..n).map(|_| numbers.next()).collect();
        Self {
            s: several(&mut numbers, nodes),
            ds: core::array::from_fn(|_| several(&mut numbers, nodes)),
            n: numbers.several(),
            coefficients,
            measure: several(&mut numbers, if measured { nodes * D } else { 0 }),
            moving,
        }
    }

    /// K of two points, the second of which adds; `spare`: places of the scratch beyond the unknowns, `more`: other
    /// unknowns.
    fn contracted(&self, spare: usize, more: usize, is_open: bool) -> Vec<f64> {
        let unknowns = self.s.len() * D;
        let width = unknowns + spare;
        let mut u: [Vec<f64>; D] = core::array::from_fn(|_| vec![0.0; width]);
        let mut g: [Vec<f64>; P] = core::array::from_fn(|_| vec![0.0; width]);
        let (mut h, mut row) = (vec![0.0; width], vec![0.0; width]);
        let mut matrix = Matrix {
            apart: unknowns + more,
            entries: vec![0.25; (unknowns + more).pow(2)],
            is_open,
        };
        for write in [Write::Replace, Write::Add] {
            contract(
                &NormalContraction {
                    s: &self.s,
                    ds: core::array::from_fn(|j| &*self.ds[j]),
                    n: &self.n,
                    coefficients: &self.coefficients,
                    measure: &self.measure,
                    moving: self.moving,
                    write,
                },
                &mut Temporaries {
                    u: u.each_mut().map(Vec::as_mut_slice),
                    g: g.each_mut().map(Vec::as_mut_slice),
                    h: &mut h,
                    row: &mut row,
                },
                &mut matrix,
            );
        }
        matrix.entries
    }

    fn expected(&self, i: usize, j: usize) -> f64 {
        let (s, ds, n, c) = (&self.s, &self.ds, &self.n, &self.coefficients);
        let (a, r, b, l) = (i / D, i % D, j / D, j % D);
        let mut entry = s[a] * s[b] * c.p[r][l];
        if let Some(m) = self.measure.get(j) {
            entry += s[a] * n[r] * m;
        }
        for e in 0..P {
            entry += s[a] * ds[e][b] * c.right[e][r] * n[l] + n[r] * ds[e][a] * s[b] * c.left[e][l];
            for f in 0..P {
                entry += ds[e][a] * ds[f][b] * c.s[e][f] * n[r] * n[l];
            }
        }
        2.0 * entry
    }
}

fn check<const D: usize, const P: usize>(nodes: usize, moving: bool, measured: bool) {
    let case = Case::<D, P>::new(nodes, moving, measured);
    let unknowns = nodes * D;
    let single = case.contracted(0, 0, false);
    for (at, &entry) in single.iter().enumerate() {
        let (i, j) = (at / unknowns, at % unknowns);
        let expected = case.expected(i, j);
        assert!(
            (entry - expected).abs() < 1e-13,
            "{D} {P} {nodes}: {i} {j}: {entry} instead of {expected}"
        );
    }
    for (spare, more) in [(0, 0), (1, 0), (3, 0), (0, 1), (1, 4)] {
        for is_open in [false, true] {
            let other = case.contracted(spare, more, is_open);
            let mut expected = vec![0.25; other.len()];
            for (to, own) in expected
                .chunks_mut(unknowns + more)
                .zip(single.chunks(unknowns))
            {
                to[..unknowns].copy_from_slice(own);
            }
            let mut same = expected.iter().zip(&other);
            assert!(
                same.all(|(a, b)| a.to_bits() == b.to_bits()),
                "{D} {P} {nodes}: {spare} spare places, {more} unknowns more, rows at once: {is_open}"
            );
        }
    }
}

#[test]
fn rows_are_the_contraction() {
    for nodes in 1..=MOST / 3 {
        for (moving, measured) in [(true, false), (true, true), (false, false), (false, true)] {
            check::<3, 2>(nodes, moving, measured);
            check::<3, 1>(nodes, moving, measured);
            check::<2, 1>(nodes, moving, measured);
        }
    }
}
