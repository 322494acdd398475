//! Outputs of a block, contact after contact: sums into shared arrays are taken in the order of single calls.
//!
//! Rows of K by the rules of [`contract`](crate::element::contraction::contract), lanes across the unknowns of one contact.

use crate::batch::block::{MOST_UNKNOWNS, Points, ROOM, Records, VECTORS};
use crate::batch::contacts::Contacts;
use crate::element::receiver::{Receiver, Report, Write};
use crate::element::rows::{self, Factors, NodeShare};
use crate::lanes::{Quad, Wide};
use crate::point::enforcement::remembered;
use crate::point::motion::Rolling;
use crate::point::values::Status;

/// Length of a row with room for whole lanes.
const ROW: usize = MOST_UNKNOWNS + 8;

/// Writes the outputs of all contacts of the block.
#[inline(always)]
pub(crate) fn write<C: Contacts, T: Wide, const D: usize, const P: usize, const N: usize>(
    points: &Points<'_>,
    contacts: &mut C,
    numbers: &[usize],
    records: &Records<N>,
) {
    let wanted = contacts.wanted();
    let reports = contacts.reports();
    let unknowns = N * D;
    let mut rank = 0;
    let mut scratch = Scratch::<D, P, N> {
        u: [[0.0; ROW]; D],
        g: [[0.0; ROW]; P],
        forces: [0.0; ROW],
        matrix: [[[[0.0; D]; N]; D]; N],
    };
    for (slot, &contact) in numbers.iter().enumerate() {
        let has = |bits: u32| bits >> slot & 1 != 0;
        let own = rank;
        rank += usize::from(has(points.closed));
        if !has(points.good) {
            contacts.evaluate_alone(contact);
            continue;
        }
        let mut receiver = contacts.receiver(contact);
        let mut status = Status::Outside;
        let (mut energy, mut traction) = (0.0, 0.0);
        if has(points.closed) {
            status = Status::Closed;
            traction = records.traction[own % ROOM];
            energy = 1.0 * (records.energy[own % ROOM] + 0.0);
            let vectors = &records.vectors[own % ROOM];
            let nodes = &records.nodes[own % ROOM];
            if wanted.residual {
                let forces = &mut scratch.forces;
                residual::<_, T::Quad, D, N>(nodes, &vectors[0], traction, forces, &mut receiver);
            }
            if wanted.tangent {
                tangent::<_, T, D, P, N>(nodes, vectors, &mut scratch, &mut receiver);
            }
        } else {
            receiver.open(unknowns);
            if has(points.inside) {
                status = Status::Open;
            }
        }
        if reports {
            receiver.report(0, &report(points, slot, status, traction));
        }
        receiver.energy(energy);
        drop(receiver);
        contacts.settle(contact, status);
    }
}

/// u_k and g_j of [`contract`](crate::element::contraction::contract).
struct Scratch<const D: usize, const P: usize, const N: usize> {
    u: [[f64; ROW]; D],
    g: [[f64; ROW]; P],
    forces: [f64; ROW],
    /// K, if it does not go straight to the host.
    matrix: [[[[f64; D]; N]; D]; N],
}

/// Residual of a closed contact; `forces` is scratch.
#[inline(always)]
fn residual<R: Receiver, Q: Quad, const D: usize, const N: usize>(
    nodes: &[[f64; 8]; N],
    n: &[f64; 4],
    traction: f64,
    forces: &mut [f64; ROW],
    receiver: &mut R,
) {
    let force = Q::same(traction) * Q::new(*n);
    for (a, own) in nodes.iter().enumerate() {
        let to = forces.get_mut(a * D..).unwrap_or_default();
        (Q::same(own[0]) * force).store(to);
    }
    receiver.forces(forces.get(..N * D).unwrap_or_default(), D);
}

/// Tangent of a closed contact.
#[inline(always)]
fn tangent<R: Receiver, T: Wide, const D: usize, const P: usize, const N: usize>(
    nodes: &[[f64; 8]; N],
    vectors: &[[f64; 4]; VECTORS],
    scratch: &mut Scratch<D, P, N>,
    receiver: &mut R,
) {
    let Scratch { u, g, matrix, .. } = scratch;
    rows::fill::<T::Quad, D, P>(
        nodes.iter().map(|own| NodeShare {
            s: own[0],
            right: core::array::from_fn(|k| own[3 + k]),
            turn: core::array::from_fn(|j| own[6 + j]),
        }),
        vectors[0],
        (
            core::array::from_fn(|k| vectors[1 + k]),
            core::array::from_fn(|j| vectors[1 + D + j]),
        ),
        (
            u.each_mut().map(|row| row.as_mut_slice()),
            g.each_mut().map(|row| row.as_mut_slice()),
        ),
    );
    let matrix = matrix
        .as_flattened_mut()
        .as_flattened_mut()
        .as_flattened_mut();
    let mut is_written = false;
    let to = match receiver.rows() {
        Some(to) => {
            is_written = true;
            to
        }
        None => (&mut *matrix, N * D),
    };
    let factors = Factors {
        u: u.each_ref().map(|row| row.as_slice()),
        g: g.each_ref().map(|row| row.as_slice()),
    };
    let n = core::array::from_fn(|k| vectors[0][k]);
    let nodes = nodes
        .iter()
        .map(|own| (own[0], core::array::from_fn(|j| own[1 + j])));
    let is_done = rows::write::<T, D, P>(nodes, &n, &factors, to, Write::Replace);
    debug_assert!(is_done);
    if !is_written {
        for (unknown, row) in matrix.chunks_exact(N * D).enumerate() {
            receiver.row(unknown, row, Write::Replace);
        }
    }
}

#[inline(never)]
fn report(points: &Points<'_>, slot: usize, status: Status, traction: f64) -> Report {
    let is_closed = status.is_closed();
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
