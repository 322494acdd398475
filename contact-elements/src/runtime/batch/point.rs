//! The points of a block in lanes.

use super::block::{Block, Column, MOST_PARAMETERS, ROOM, Records};
use super::newton::project;
use super::wide::Wide;
use crate::runtime::classify::LARGEST;
use crate::runtime::element::{Element, Layout};
use crate::runtime::kernel::FARTHEST_PROJECTION;
use crate::runtime::receiver::Wanted;
use crate::runtime::shape::NormalLaw;
use crate::runtime::values::{Coefficients, Gap, Rows, Vectors};

/// Lanes from `group` on.
#[inline(always)]
fn load_lanes<T: Wide>(column: &Column, group: usize) -> T {
    T::load(column.0.get(group..).unwrap_or(&[]))
}

#[inline(always)]
fn store_lanes<T: Wide>(value: T, column: &mut Column, group: usize) {
    value.store(column.0.get_mut(group..).unwrap_or(&mut []));
}

#[inline(always)]
fn orientation<T: Wide>(layout: &Layout, parameters: &[T]) -> T {
    let one = T::constant(1.0);
    match layout.orientation.and_then(|at| parameters.get(at)) {
        Some(&value) => T::select(value.below(T::constant(0.0)), -one, one),
        None => one,
    }
}

/// Inputs of the lanes.
struct Start<T: Wide, const D: usize, const P: usize, const N: usize> {
    x: [[T; D]; N],
    zeta: [T; P],
    parameters: [T; MOST_PARAMETERS],
    /// One bit per lane that can be evaluated.
    good: u32,
}

/// Inputs of the lanes from `group` on; a lane that cannot be evaluated takes those of one that can.
#[inline(always)]
fn start<
    E: Element<D, P, H>,
    T: Wide,
    const D: usize,
    const P: usize,
    const H: usize,
    const N: usize,
>(
    block: &Block<D, P, H, N>,
    group: usize,
) -> Start<T, D, P, N> {
    let lanes = |column: &Column| load_lanes::<T>(column, group);
    let mut start = Start {
        x: block.x.each_ref().map(|node| node.each_ref().map(lanes)),
        zeta: block.zeta.each_ref().map(lanes),
        parameters: block.parameters.each_ref().map(lanes),
        good: block.good >> group & T::all(),
    };
    let mut possible = T::mask(start.good);
    for i in 0..P {
        let farthest = T::constant(FARTHEST_PROJECTION * E::extent(i));
        let away = start.zeta[i] - T::constant(E::centre()[i]);
        possible = possible & away.abs().at_most(farthest);
    }
    start.good = T::bits(possible);
    if start.good != 0 && start.good != T::all() {
        let repair = Repair::<T>::new(start.good);
        start.x = start.x.map(|node| node.map(|value| repair.apply(value)));
        start.zeta = start.zeta.map(|value| repair.apply(value));
        start.parameters = start.parameters.map(|value| repair.apply(value));
    }
    start
}

/// First pass over the lanes from `group` on: projection, gap, open or closed.
#[inline(always)]
pub(super) fn classify<
    E: Element<D, P, H>,
    T: Wide,
    const D: usize,
    const P: usize,
    const H: usize,
    const N: usize,
>(
    block: &mut Block<D, P, H, N>,
    group: usize,
    wanted: &Wanted,
) {
    // never larger: said so that the compiler asks for no bound further on
    let group = group.min(ROOM - T::WIDTH);
    let own = T::all() << group;
    let Start {
        x,
        zeta,
        parameters,
        mut good,
    } = start::<E, T, D, P, H, N>(block, group);
    block.good &= !own;
    if good == 0 {
        return;
    }
    let zero = T::constant(0.0);
    let (mut s, mut ds) = ([zero; N], [[zero; N]; P]);
    let mut rows = Rows {
        s: &mut s[..],
        ds: ds.each_mut().map(|row| row.as_mut_slice()),
    };
    E::slave(0, &parameters, rows.s);
    let (given, mask) = (wanted.projection_given, T::mask(good));
    let found = project::<E, T, D, P, H>(&x, zeta, given, &parameters, &mut rows, mask);
    let mut vectors = found.vectors;
    let mut still = found.good;
    if !E::SIGNED {
        still = still & !is_zero(&vectors.r, largest(&x));
    }
    good &= T::bits(still);
    if good == 0 {
        return;
    }
    if good != T::all() {
        // a lane that is given up must not divide by zero further on
        let repair = Repair::<T>::new(good);
        vectors.r = vectors.r.map(|value| repair.apply(value));
        vectors.b = vectors.b.map(|b| b.map(|value| repair.apply(value)));
    }
    let gap = E::gap(&vectors, &parameters, orientation(&E::LAYOUT, &parameters));
    good &= T::bits(
        gap.n
            .iter()
            .fold(gap.gap.is_finite(), |all, n| all & n.is_finite()),
    );
    let inside = T::bits(contains::<E, T, D, P, H>(&found.zeta)) & good;
    let acts = if wanted.freeze {
        is_load::<T>(load_lanes(&block.frozen, group))
    } else {
        zero.below(E::Law::active(gap.gap, &parameters))
    };
    let closed = T::bits(acts) & inside;
    block.good |= good << group;
    block.inside |= inside << group;
    block.closed |= closed << group;
    store_projection(block, group, &found.zeta, found.iterations);
    store_point(block, group, &vectors, &gap);
    if closed != 0 {
        store_rows(block, group, &s, &ds);
    }
}

/// Closed, stick or slip.
#[inline(always)]
fn is_load<T: Wide>(status: T) -> T::Mask {
    T::constant(1.0).at_most(status) & status.at_most(T::constant(3.0))
}

#[inline(always)]
fn store_projection<T: Wide, const D: usize, const P: usize, const H: usize, const N: usize>(
    block: &mut Block<D, P, H, N>,
    group: usize,
    zeta: &[T; P],
    iterations: T,
) {
    for i in 0..P {
        store_lanes(zeta[i], &mut block.zeta[i], group);
    }
    store_lanes(iterations, &mut block.iterations, group);
}

#[inline(always)]
fn store_rows<T: Wide, const D: usize, const P: usize, const H: usize, const N: usize>(
    block: &mut Block<D, P, H, N>,
    group: usize,
    s: &[T; N],
    ds: &[[T; N]; P],
) {
    for a in 0..N {
        store_lanes(s[a], &mut block.s[a], group);
        for i in 0..P {
            store_lanes(ds[i][a], &mut block.ds[i][a], group);
        }
    }
}

#[inline(always)]
fn store_point<T: Wide, const D: usize, const P: usize, const H: usize, const N: usize>(
    block: &mut Block<D, P, H, N>,
    group: usize,
    vectors: &Vectors<D, P, H, T>,
    gap: &Gap<D, T>,
) {
    for k in 0..D {
        for i in 0..P {
            store_lanes(vectors.b[i][k], &mut block.b[i][k], group);
        }
        for h in 0..H {
            store_lanes(vectors.second[h][k], &mut block.second[h][k], group);
        }
        store_lanes(gap.n[k], &mut block.n[k], group);
    }
    store_lanes(gap.distance, &mut block.distance, group);
    store_lanes(gap.gap, &mut block.gap, group);
}

/// Puts the number of a good lane into all that are not.
struct Repair<T: Wide> {
    mask: T::Mask,
    lane: usize,
}

impl<T: Wide> Repair<T> {
    #[inline(always)]
    fn new(good: u32) -> Self {
        Self {
            mask: T::mask(good),
            lane: good.trailing_zeros() as usize,
        }
    }

    #[inline(always)]
    fn apply(&self, value: T) -> T {
        T::select(self.mask, value, value.spread(self.lane))
    }
}

/// True where ζ lies in the domains.
#[inline(always)]
fn contains<E: Element<D, P, H>, T: Wide, const D: usize, const P: usize, const H: usize>(
    zeta: &[T; P],
) -> T::Mask {
    const SLACK: f64 = 1e-12;
    if P == 0 {
        return T::mask(T::all());
    }
    let (first, last) = (zeta[0], zeta[P - 1]);
    if E::TWO_CURVES {
        let slave = E::DOMAINS[0].contains([first, first], SLACK);
        return slave & E::DOMAINS[1].contains([last, last], SLACK);
    }
    E::DOMAINS[0].contains([first, last], SLACK)
}

#[inline(always)]
fn largest<T: Wide, const D: usize>(x: &[[T; D]]) -> T {
    let mut largest = T::constant(0.0);
    for node in x {
        for k in 0..D {
            largest = node[k].abs().larger(largest);
        }
    }
    largest
}

/// |r| is zero to rounding.
#[inline(always)]
fn is_zero<T: Wide, const D: usize>(r: &[T; D], scale: T) -> T::Mask {
    let least = (T::constant(8.0 * f64::EPSILON) * scale).larger(T::constant(1e-30));
    let mut is_zero = T::mask(T::all());
    for k in 0..D {
        is_zero = is_zero & r[k].abs().at_most(least);
    }
    is_zero
}

/// Second pass: law and coefficients of the closed contacts of the block, packed into full lanes.
#[inline(always)]
pub(super) fn load<
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
    // lanes beyond the last take its numbers
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
        return core::array::from_fn(|i| load_lanes(&columns[i], first));
    }
    let mut packed = [[0.0; 8]; K];
    for (to, column) in packed.iter_mut().zip(columns) {
        for (to, &slot) in to.iter_mut().zip(slots).take(T::WIDTH) {
            *to = column.at(usize::from(slot));
        }
    }
    core::array::from_fn(|i| T::load(&packed[i]))
}

/// The records of some closed contacts; false where one of them leaves the common path.
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
    let most = T::constant(LARGEST);
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

/// Leaves some contacts to the kernel of one.
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
