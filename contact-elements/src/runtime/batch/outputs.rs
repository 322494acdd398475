//! Outputs of a block, contact after contact: sums into shared arrays come out in the order of a single call.
//!
//! Rows of K by the rules of [`contract`](crate::runtime::contract), lanes across the unknowns of one contact.

use super::Contacts;
use super::block::Points;
use super::wide::{Quad, Wide};
use crate::runtime::enforcement::remembered;
use crate::runtime::receiver::{Receiver, Report, Wanted};
use crate::runtime::rolling::Rolling;
use crate::runtime::values::Status;

/// Most unknowns of an element that is evaluated in lanes.
pub(super) const MOST_UNKNOWNS: usize = 40;

/// Length of a row with room for whole lanes.
const ROW: usize = MOST_UNKNOWNS + 8;

/// Writes the outputs of all contacts of the block.
#[inline(always)]
pub(super) fn write<C: Contacts, T: Wide, const D: usize, const P: usize>(
    points: &Points<'_>,
    contacts: &mut C,
    (first, length): (usize, usize),
    scratch: &mut Scratch<D, P>,
) {
    let wanted = contacts.wanted();
    let reports = contacts.reports();
    let unknowns = points.s.len() * D;
    for slot in 0..length {
        let contact = first + slot;
        let has = |bits: u32| bits >> slot & 1 != 0;
        if !has(points.good) {
            contacts.evaluate_alone(contact);
            continue;
        }
        let mut receiver = contacts.receiver(contact);
        let (status, energy) = if has(points.closed) {
            closed::<C::Receiver, T, D, P>(points, slot, &wanted, scratch, &mut receiver);
            (Status::Closed, 1.0 * (points.energy.at(slot) + 0.0))
        } else {
            receiver.open(unknowns);
            let status = if has(points.inside) {
                Status::Open
            } else {
                Status::Outside
            };
            (status, 0.0)
        };
        if reports {
            receiver.report(0, &report(points, slot, status));
        }
        receiver.energy(energy);
        contacts.settle(contact, status);
    }
}

/// Most nodes.
const NODES: usize = MOST_UNKNOWNS / 2;

/// What the rows of one contact are made of.
pub struct Scratch<const D: usize, const P: usize> {
    u: [[f64; ROW]; D],
    g: [[f64; ROW]; P],
    /// s_A and s_A,j
    factors: [[f64; 3]; NODES],
    /// K, where it does not go to its place at once.
    matrix: [f64; MOST_UNKNOWNS * MOST_UNKNOWNS],
}

impl<const D: usize, const P: usize> Scratch<D, P> {
    #[inline(always)]
    pub(super) fn new() -> Self {
        Self {
            u: [[0.0; ROW]; D],
            g: [[0.0; ROW]; P],
            factors: [[0.0; 3]; NODES],
            matrix: [0.0; MOST_UNKNOWNS * MOST_UNKNOWNS],
        }
    }
}

/// Residual and tangent of a closed contact.
#[inline(always)]
fn closed<R: Receiver, T: Wide, const D: usize, const P: usize>(
    points: &Points<'_>,
    slot: usize,
    wanted: &Wanted,
    scratch: &mut Scratch<D, P>,
    receiver: &mut R,
) {
    let unknowns = points.s.len() * D;
    if wanted.residual {
        let mut forces = [0.0; ROW];
        let pull = T::Quad::same(points.traction.at(slot));
        let force = pull * points.vector::<T::Quad, D>(points.n, 0, slot);
        for (a, s) in points.s.iter().enumerate() {
            let s = T::Quad::same(s.at(slot));
            (s * force).store(forces.get_mut(a * D..).unwrap_or(&mut []));
        }
        receiver.forces(forces.get(..unknowns).unwrap_or(&[]), D);
    }
    if !wanted.tangent {
        return;
    }
    factors::<T::Quad, D, P>(points, slot, scratch);
    let n = core::array::from_fn(|k| points.n.get(k).map_or(0.0, |column| column.at(slot)));
    let nodes = points.s.len();
    if let Some(to) = receiver.rows() {
        rows::<T, D, P>(scratch, nodes, &n, to);
        return;
    }
    let mut matrix = scratch.matrix;
    let to = matrix.get_mut(..unknowns * unknowns).unwrap_or(&mut []);
    rows::<T, D, P>(scratch, nodes, &n, to);
    for (unknown, row) in to.chunks_exact(unknowns.max(1)).enumerate() {
        receiver.row(unknown, row, true);
    }
}

/// u_k and g_j of [`contract`](crate::runtime::contract), node after node.
#[inline(always)]
fn factors<Q: Quad, const D: usize, const P: usize>(
    points: &Points<'_>,
    slot: usize,
    scratch: &mut Scratch<D, P>,
) {
    let n = points.vector::<Q, D>(points.n, 0, slot);
    let p: [Q; D] = core::array::from_fn(|k| points.vector::<Q, D>(points.p, k, slot));
    let left: [Q; P] = core::array::from_fn(|j| points.vector::<Q, D>(points.left, j, slot));
    let right_turns = points.right_turn.as_chunks::<D>().0;
    let left_turns = points.left_turn.as_chunks::<P>().0;
    let nodes = points.s.len();
    let turns = right_turns.iter().zip(left_turns);
    let owns = points.s.iter().zip(&mut scratch.factors);
    for (b, ((s, own), (right_turn, left_turn))) in owns.zip(turns).enumerate() {
        own[0] = s.at(slot);
        for j in 0..P {
            let ds = points.ds.get(j * nodes + b);
            own[1 + j] = ds.map_or(0.0, |column| column.at(slot));
        }
        let s = Q::same(own[0]);
        for k in 0..D {
            let value = s * p[k] + Q::same(right_turn[k].at(slot)) * n;
            value.store(scratch.u[k].get_mut(b * D..).unwrap_or(&mut []));
        }
        for j in 0..P {
            let value = s * left[j] + Q::same(left_turn[j].at(slot)) * n;
            value.store(scratch.g[j].get_mut(b * D..).unwrap_or(&mut []));
        }
    }
}

/// All rows, some columns at a time, the last ones first: lanes beyond the end of a row fall on the beginning of
/// the next, which is written later.
#[inline(always)]
fn rows<T: Wide, const D: usize, const P: usize>(
    scratch: &Scratch<D, P>,
    nodes: usize,
    n: &[f64; D],
    to: &mut [f64],
) {
    let unknowns = nodes * D;
    let n = n.map(T::constant);
    let Some(factors) = scratch.factors.get(..nodes) else {
        return;
    };
    for column in (0..unknowns).step_by(T::WIDTH).rev() {
        let lanes = |row: &[f64; ROW]| T::load(row.get(column..).unwrap_or(&[]));
        let u = scratch.u.each_ref().map(lanes);
        let g = scratch.g.each_ref().map(lanes);
        let mut at = column;
        for own in factors {
            let s = T::constant(own[0]);
            let mut h = T::constant(own[1]) * g[0];
            for j in 1..P {
                h = h + T::constant(own[1 + j]) * g[j];
            }
            for k in 0..D {
                put(s * u[k] + n[k] * h, to, at);
                at += unknowns;
            }
        }
    }
}

/// To the places from `at` on, as many as there are.
#[inline(always)]
fn put<T: Wide>(value: T, to: &mut [f64], at: usize) {
    match to.get_mut(at..at + T::WIDTH) {
        Some(to) => value.store(to),
        None => put_some(value, to.get_mut(at..).unwrap_or(&mut [])),
    }
}

#[cold]
#[inline(always)]
fn put_some<T: Wide>(value: T, to: &mut [f64]) {
    let mut values = [0.0; 8];
    value.store(&mut values);
    for (to, value) in to.iter_mut().zip(values) {
        *to = value;
    }
}

#[inline(never)]
fn report(points: &Points<'_>, slot: usize, status: Status) -> Report {
    let is_closed = status.is_closed();
    let traction = if is_closed {
        points.traction.at(slot)
    } else {
        0.0
    };
    let mut report = Report {
        status,
        feature: 0,
        gap: points.gap.at(slot),
        traction,
        weight: if is_closed { 1.0 } else { 0.0 },
        zeta: [0.0; 2],
        normal: [0.0; 3],
        iterations: points.iterations.at(slot) as u32,
        tangential: [0.0; 2],
        tangents: [[0.0; 3]; 2],
        anchor: [0.0; 2],
        path: 0.0,
        multiplier: remembered(traction),
        rolling: Rolling::default(),
    };
    let dimension = points.n.len().max(1);
    for (to, b) in report.tangents.iter_mut().zip(points.b.chunks(dimension)) {
        for (to, from) in to.iter_mut().zip(b) {
            *to = from.at(slot);
        }
    }
    for (to, from) in report.zeta.iter_mut().zip(points.zeta) {
        *to = from.at(slot);
    }
    for (to, from) in report.normal.iter_mut().zip(points.n) {
        *to = from.at(slot);
    }
    if status == Status::Outside {
        report.feature = (points.feature)(report.zeta);
    }
    report
}
