//! From coordinates anywhere in memory to an evaluation: checks, scratch.

use crate::arithmetic::is_usable;
use crate::element::driver::evaluate;
use crate::element::edge_side::is_side_given;
use crate::element::gather::{Nodes, gather, multipliers, shift_of_row};
use crate::element::receiver::{Call, InputError, Receiver, Summary};
use crate::element::stage::{MOST_COLUMNS, Stage, TangentialRows, Temporaries};
use crate::element::traits::Element;
use crate::point::friction::TangentialLaw;
use crate::point::values::Rows;

/// Refuses a history that no evaluation writes, and edges of which nobody says on which side they are.
#[inline(always)]
fn check_history<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    call: &Call<'_>,
) -> Result<(), InputError> {
    match call.history {
        Some(history) => Ok(E::HISTORY_LAYOUT.check(&E::REACH, &history)?),
        None if E::KEEPS_SIDE && !is_side_given::<E, D, P, H>(call.parameters) => {
            Err(InputError::NoHistory)
        }
        None => Ok(()),
    }
}

/// Kernel of an element with N nodes and Q points; W ≥ D·N is the length of the scratch rows.
#[inline(always)]
pub fn fixed<
    E: Element<D, P, H>,
    R: Receiver,
    const D: usize,
    const P: usize,
    const H: usize,
    const N: usize,
    const Q: usize,
    const W: usize,
>(
    call: &Call<'_>,
    nodes: &Nodes<'_>,
    vectors: &[bool],
    receiver: &mut R,
) -> Result<Summary, InputError> {
    check_history::<E, D, P, H>(call)?;
    let mut x = [[0.0; D]; N];
    let mut reference = [[0.0; D]; N];
    let is_vector = |a: usize| vectors.get(a).copied().unwrap_or(false);
    gather::<E, D, P, H>(nodes, call.parameters, is_vector, &mut x, &mut reference)?;
    let mut unknown = [0.0; Q];
    if E::MULTIPLIER {
        multipliers(nodes, N, &mut unknown)?;
    }
    let mut s = [0.0; N];
    let mut ds = [[0.0; N]; P];
    let mut u = [[0.0; W]; D];
    let mut g = [[0.0; W]; P];
    let (mut h, mut row, mut variation) = ([0.0; W], [0.0; W], [0.0; W]);
    let mut second = [[0.0; N]; H];
    let mut slave = [0.0; N];
    let mut columns = [[0.0; W]; MOST_COLUMNS];
    let mut stage = Stage {
        x: &x,
        reference: &reference,
        multipliers: &unknown,
        rows: Rows {
            s: &mut s,
            ds: ds.each_mut().map(|row| row.as_mut_slice()),
        },
        temporaries: Temporaries {
            u: u.each_mut().map(|row| row.as_mut_slice()),
            g: g.each_mut().map(|row| row.as_mut_slice()),
            h: &mut h,
            row: &mut row,
        },
        variation: &mut variation,
        tangential: TangentialRows {
            second: second.each_mut().map(|row| row.as_mut_slice()),
            slave: &mut slave,
            columns: columns.as_flattened_mut(),
        },
    };
    Ok(evaluate::<E, R, D, P, H, Q>(call, &mut stage, receiver)?)
}

/// Doubles of workspace that `interpolated` needs for `n` nodes.
#[inline]
pub const fn workspace(n: usize, d: usize, p: usize, friction: bool) -> usize {
    let width = row_width(n * d, friction);
    let tangential = if friction {
        n * (p * (p + 1) / 2 + 1) + 2 * (p + d) * width
    } else {
        0
    };
    n * d + n * (1 + p) + width * (d + p + 2) + tangential
}

/// Length of a row over all unknowns; with friction a multiple of four.
const fn row_width(unknowns: usize, friction: bool) -> usize {
    if friction {
        unknowns.next_multiple_of(4)
    } else {
        unknowns
    }
}

/// Positions and scratch of an element whose slave row comes with the call.
struct Scratch<'m, const D: usize, const P: usize, const H: usize> {
    x: &'m mut [[f64; D]],
    rows: Rows<'m, P>,
    temporaries: Temporaries<'m, D, P>,
    tangential: TangentialRows<'m, H>,
}

/// The workspace as scratch for `n` nodes, all zero; `None` where it is too small.
#[inline(always)]
fn divided<const D: usize, const P: usize, const H: usize>(
    memory: &mut [f64],
    n: usize,
    friction: bool,
) -> Option<Scratch<'_, D, P, H>> {
    let mut rest = memory.get_mut(..workspace(n, D, P, friction))?;
    rest.fill(0.0);
    let mut take = |length: usize| -> &mut [f64] {
        let (head, tail) = core::mem::take(&mut rest)
            .split_at_mut_checked(length)
            .unwrap_or((&mut [], &mut []));
        rest = tail;
        head
    };
    let width = row_width(n * D, friction);
    let (nodes_more, unknowns_more) = if friction { (n, width) } else { (0, 0) };
    let (x, _) = take(n * D).as_chunks_mut::<D>();
    Some(Scratch {
        x,
        rows: Rows {
            s: take(n),
            ds: core::array::from_fn(|_| take(n)),
        },
        temporaries: Temporaries {
            u: core::array::from_fn(|_| take(width)),
            g: core::array::from_fn(|_| take(width)),
            h: take(width),
            row: take(width),
        },
        tangential: TangentialRows {
            second: core::array::from_fn(|_| take(nodes_more)),
            slave: take(nodes_more),
            columns: take(2 * (P + D) * unknowns_more),
        },
    })
}

/// Kernel of an element whose slave row comes with the call; its scratch comes from `memory`.
#[inline(always)]
pub fn interpolated<
    E: Element<D, P, H>,
    R: Receiver,
    const D: usize,
    const P: usize,
    const H: usize,
>(
    call: &Call<'_>,
    nodes: &Nodes<'_>,
    masters_vectors: &[bool],
    memory: &mut [f64],
    receiver: &mut R,
) -> Result<Summary, InputError> {
    check_history::<E, D, P, H>(call)?;
    for (index, &value) in call.slave_row.iter().enumerate() {
        if !is_usable(value) {
            return Err(InputError::SlaveRow(index));
        }
    }
    let mut unknown = [0.0; 1];
    let n = if E::MULTIPLIER {
        nodes.count.saturating_sub(1)
    } else {
        nodes.count
    };
    if E::MULTIPLIER {
        multipliers(nodes, n, &mut unknown)?;
    }
    let Scratch {
        x,
        rows,
        temporaries,
        tangential,
    } = divided(memory, n, E::Tangential::ACTIVE).ok_or(InputError::Workspace)?;
    let first_master = n.saturating_sub(E::MASTER_NODES);
    let is_vector = |a: usize| {
        let master = a.checked_sub(first_master);
        master
            .and_then(|m| masters_vectors.get(m))
            .copied()
            .unwrap_or(false)
    };
    let origin = gather::<E, D, P, H>(nodes, call.parameters, is_vector, x, &mut [])?;
    shift_of_row(call.slave_row, &origin, x);
    let mut stage = Stage {
        x,
        reference: &[],
        multipliers: &unknown,
        rows,
        temporaries,
        variation: &mut [],
        tangential,
    };
    Ok(evaluate::<E, R, D, P, H, 1>(call, &mut stage, receiver)?)
}
