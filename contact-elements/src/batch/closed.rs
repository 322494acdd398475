//! Second pass over a block in lanes: law and coefficients of the closed contacts, packed into full lanes.

use crate::batch::block::{Block, Column, MOST_PARAMETERS, ROOM, Records, load_lanes};
use crate::batch::point::orientation;
use crate::element::receiver::Wanted;
use crate::element::traits::Element;
use crate::lanes::Wide;
use crate::point::law::{LARGEST_VALUE, NormalLaw};
use crate::point::values::{Coefficients, Gap, Vectors};

/// Second pass: law and coefficients of the closed contacts of the block, packed into full lanes.
#[inline(always)]
pub(crate) fn load<
    E: Element<D, P, H>,
    T: Wide,
    const D: usize,
    const P: usize,
    const H: usize,
    const N: usize,
>(
    block: &mut Block<D, P, H, N>,
    records: &mut Records<N>,
    wanted: &Wanted,
) {
    let mut slots = [0u8; ROOM + 8];
    let (mut left, mut count) = (block.closed, 0);
    while left != 0 {
        if let Some(to) = slots.get_mut(count) {
            *to = left.trailing_zeros() as u8;
        }
        (left, count) = (left & (left - 1), count + 1);
    }
    // lanes beyond the last repeat its numbers
    let last = slots.get(count.wrapping_sub(1)).copied().unwrap_or(0);
    for slot in slots.iter_mut().skip(count).take(8) {
        *slot = last;
    }
    for rank in (0..count).step_by(T::WIDTH) {
        let own = slots.get(rank..).and_then(|slots| slots.first_chunk::<8>());
        let Some(slots) = own else { return };
        if !coefficients::<E, T, D, P, H, N>(block, records, rank, slots, wanted) {
            give_up(block, slots.get(..T::WIDTH).unwrap_or(&[]));
        }
    }
}

/// The values of the contacts in some slots, side by side.
#[inline(always)]
fn pack<T: Wide, const K: usize>(columns: &[Column; K], slots: &[u8; 8]) -> [T; K] {
    let first = usize::from(slots[0]).min(ROOM - T::WIDTH);
    let own = slots.iter().take(T::WIDTH);
    if own
        .enumerate()
        .all(|(lane, &slot)| usize::from(slot) == first + lane)
    {
        // loops: from_fn of many values is not inlined, and then passes the lanes through memory
        let mut lanes = [T::constant(0.0); K];
        for (to, column) in lanes.iter_mut().zip(columns) {
            *to = load_lanes(column, first);
        }
        return lanes;
    }
    let mut packed = [[0.0; 8]; K];
    for (to, column) in packed.iter_mut().zip(columns) {
        for (to, &slot) in to.iter_mut().zip(slots).take(T::WIDTH) {
            *to = column.at(usize::from(slot));
        }
    }
    let mut lanes = [T::constant(0.0); K];
    for (to, from) in lanes.iter_mut().zip(&packed) {
        *to = T::load(from);
    }
    lanes
}

/// The records of some closed contacts; false where one of them leaves the common path.
// long: a list of steps on the same lanes, which all decide whether the group stays on the common path
#[inline(always)]
fn coefficients<
    E: Element<D, P, H>,
    T: Wide,
    const D: usize,
    const P: usize,
    const H: usize,
    const N: usize,
>(
    block: &Block<D, P, H, N>,
    records: &mut Records<N>,
    rank: usize,
    slots: &[u8; 8],
    wanted: &Wanted,
) -> bool {
    let rank = rank.min(ROOM - T::WIDTH);
    let zero = T::constant(0.0);
    let mut parameters = [zero; MOST_PARAMETERS];
    for (i, to) in parameters.iter_mut().enumerate().take(E::LAYOUT.count) {
        *to = pack(&[block.parameters[i]], slots)[0];
    }
    let [distance, own] = pack(&[block.distance, block.gap], slots);
    let gap = Gap::<D, T> {
        n: pack(&block.n, slots),
        distance,
        gap: own,
    };
    if T::bits(zero.below(E::Law::valid(gap.gap, &parameters))) != T::all() {
        return false;
    }
    let law = E::Law::evaluate(gap.gap, &parameters);
    let most = T::constant(LARGEST_VALUE);
    let mut finite = law.traction.abs().at_most(most)
        & law.slope.abs().at_most(most)
        & law.energy.abs().at_most(most);
    store_some(law.traction, &mut records.traction, rank);
    store_some(law.energy, &mut records.energy, rank);
    let s: [T; N] = pack(&block.s, slots);
    let mut c = Coefficients::default();
    let mut ds = [[zero; N]; P];
    if wanted.tangent {
        let mut vectors = Vectors::<D, P, H, T>::default();
        for i in 0..P {
            vectors.b[i] = pack(&block.b[i], slots);
            ds[i] = pack(&block.ds[i], slots);
        }
        for h in 0..H {
            vectors.second[h] = pack(&block.second[h], slots);
        }
        for k in 0..D {
            for i in 0..P {
                finite = finite & vectors.b[i][k].is_finite();
            }
            for h in 0..H {
                finite = finite & vectors.second[h][k].is_finite();
            }
        }
        let orientation = orientation(&E::LAYOUT, &parameters);
        c = E::tangent(&vectors, &gap, &law, &parameters, orientation);
    }
    if T::bits(finite) != T::all() {
        return false;
    }
    let tangent = wanted.tangent.then_some(&c);
    deal::<T, D, P, N>(records, rank, &gap.n, tangent, (&s, &ds));
    true
}

#[inline(always)]
fn store_some<T: Wide>(value: T, to: &mut [f64; ROOM], rank: usize) {
    // whole lanes: ranks begin at multiples of the width
    value.store(to.get_mut(rank..).unwrap_or(&mut []));
}

/// Writes the records of some contacts.
#[inline(always)]
fn deal<T: Wide, const D: usize, const P: usize, const N: usize>(
    records: &mut Records<N>,
    rank: usize,
    n: &[T; D],
    tangent: Option<&Coefficients<D, P, T>>,
    (s, ds): (&[T; N], &[[T; N]; P]),
) {
    let zero = T::constant(0.0);
    let vector = |v: &[T; D]| core::array::from_fn(|k| if k < D { v[k] } else { zero });
    records.deal_vector(rank, 0, vector(n));
    let Some(c) = tangent else {
        for a in 0..N {
            records.deal_node(rank, 2 * a, [s[a], zero, zero, zero]);
        }
        return;
    };
    for k in 0..D {
        records.deal_vector(rank, 1 + k, vector(&c.p[k]));
    }
    for j in 0..P {
        records.deal_vector(rank, 1 + D + j, vector(&c.left[j]));
    }
    for a in 0..N {
        let own: [T; P] = core::array::from_fn(|i| ds[i][a]);
        let mut values = [zero; 8];
        values[0] = s[a];
        for i in 0..P {
            values[1 + i] = own[i];
            values[6 + i] = turned(&own, |j| c.s[i][j]);
        }
        for k in 0..D {
            values[3 + k] = turned(&own, |j| c.right[j][k]);
        }
        let [first @ .., e, f, g, h] = values;
        records.deal_node(rank, 2 * a, first);
        records.deal_node(rank, 2 * a + 1, [e, f, g, h]);
    }
}

/// Σ_j s_A,j turn_j
#[inline(always)]
fn turned<T: Wide, const P: usize>(ds: &[T; P], turn: impl Fn(usize) -> T) -> T {
    let mut sum = ds[0] * turn(0);
    for j in 1..P {
        sum = sum + ds[j] * turn(j);
    }
    sum
}

/// Leaves some contacts to the kernel of a single call.
#[cold]
#[inline(never)]
fn give_up<const D: usize, const P: usize, const H: usize, const N: usize>(
    block: &mut Block<D, P, H, N>,
    slots: &[u8],
) {
    for &slot in slots {
        block.good &= !(1 << slot);
    }
}
