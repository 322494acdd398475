//! The points of a block in lanes.

use super::block::{Block, Column, MOST_PARAMETERS, ROOM};
use super::newton::project;
use super::wide::Wide;
use crate::runtime::element::{Element, Layout};
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
    let all = T::all();
    let mut good = block.good >> group & all;
    if good == 0 {
        return;
    }
    let parameters: [T; MOST_PARAMETERS] =
        core::array::from_fn(|i| load_lanes(&block.parameters[i], group));
    let mut x: [[T; D]; N] =
        core::array::from_fn(|a| core::array::from_fn(|k| load_lanes(&block.x[a][k], group)));
    let mut start: [T; P] = core::array::from_fn(|i| load_lanes(&block.zeta[i], group));
    if good != all {
        let repair = Repair::<T>::new(good);
        x = x.map(|node| node.map(|value| repair.apply(value)));
        start = start.map(|value| repair.apply(value));
    }
    let zero = T::constant(0.0);
    let mut s = [zero; N];
    let mut ds = [[zero; N]; P];
    let mut rows = Rows {
        s: &mut s[..],
        ds: ds.each_mut().map(|row| row.as_mut_slice()),
    };
    E::slave(0, &parameters, rows.s);
    let (given, mask) = (wanted.projection_given, T::mask(good));
    let found = project::<E, T, D, P, H>(&x, start, given, &parameters, &mut rows, mask);
    let mut vectors = found.vectors;
    let mut still = found.good;
    if !E::SIGNED {
        still = still & !is_zero(&vectors.r, largest(&x));
    }
    good &= T::bits(still);
    if good == 0 {
        block.good &= !(all << group);
        return;
    }
    if good != all {
        // a lane that is given up must not divide by zero further on
        let repair = Repair::<T>::new(good);
        vectors.r = vectors.r.map(|value| repair.apply(value));
        vectors.b = vectors.b.map(|b| b.map(|value| repair.apply(value)));
    }
    let gap = E::gap(&vectors, &parameters, orientation(&E::LAYOUT, &parameters));
    let mut finite = gap.gap.is_finite();
    for k in 0..D {
        finite = finite & gap.n[k].is_finite();
    }
    good &= T::bits(finite);
    let inside = T::bits(contains::<E, T, D, P, H>(&found.zeta));
    let acts = if wanted.freeze {
        let status: T = load_lanes(&block.frozen, group);
        T::constant(1.0).at_most(status) & status.at_most(T::constant(3.0))
    } else {
        zero.below(E::Law::active(gap.gap, &parameters))
    };
    let closed = T::bits(acts) & inside & good;
    block.good = block.good & !(all << group) | good << group;
    block.inside |= (inside & good) << group;
    block.closed |= closed << group;
    for i in 0..P {
        store_lanes(found.zeta[i], &mut block.zeta[i], group);
    }
    store_lanes(found.iterations, &mut block.iterations, group);
    store_point(block, group, &vectors, &gap);
    if closed != 0 {
        for a in 0..N {
            store_lanes(s[a], &mut block.s[a], group);
            for i in 0..P {
                store_lanes(ds[i][a], &mut block.ds[i][a], group);
            }
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
    wanted: &Wanted,
) {
    let mut slots = [0u8; ROOM];
    let (mut left, mut count) = (block.closed, 0);
    while left != 0 {
        if let Some(to) = slots.get_mut(count) {
            *to = left.trailing_zeros() as u8;
        }
        (left, count) = (left & (left - 1), count + 1);
    }
    // lanes beyond the last take its numbers
    let last = slots.get(count.wrapping_sub(1)).copied().unwrap_or(0);
    for slot in slots.iter_mut().skip(count) {
        *slot = last;
    }
    for group in (0..count).step_by(T::WIDTH) {
        let slots = slots.get(group..group + T::WIDTH).unwrap_or(&[]);
        coefficients::<E, T, D, P, H, N>(block, Pack::new(slots, T::WIDTH), wanted);
    }
}

/// Which contacts stand in the lanes.
#[derive(Clone, Copy)]
struct Pack<'a> {
    slots: &'a [u8],
    /// The first, where they are neighbours.
    neighbours: Option<usize>,
}

impl<'a> Pack<'a> {
    #[inline(always)]
    fn new(slots: &'a [u8], width: usize) -> Self {
        let first = slots.first().copied().map_or(0, usize::from);
        let last = slots.last().copied().map_or(0, usize::from);
        Self {
            slots,
            neighbours: (last + 1 == first + width).then_some(first),
        }
    }

    #[inline(always)]
    fn load<T: Wide>(&self, column: &Column) -> T {
        if let Some(first) = self.neighbours {
            return load_lanes(column, first);
        }
        let mut values = [0.0; 8];
        for (value, &slot) in values.iter_mut().zip(self.slots) {
            *value = column.at(usize::from(slot));
        }
        T::load(&values)
    }

    #[inline(always)]
    fn store<T: Wide>(&self, value: T, column: &mut Column) {
        if let Some(first) = self.neighbours {
            return store_lanes(value, column, first);
        }
        let mut values = [0.0; 8];
        value.store(&mut values);
        for (&value, &slot) in values.iter().zip(self.slots) {
            column.set(usize::from(slot), value);
        }
    }
}

#[inline(always)]
fn coefficients<
    E: Element<D, P, H>,
    T: Wide,
    const D: usize,
    const P: usize,
    const H: usize,
    const N: usize,
>(
    block: &mut Block<D, P, H, N>,
    pack: Pack<'_>,
    wanted: &Wanted,
) {
    let parameters: [T; MOST_PARAMETERS] =
        core::array::from_fn(|i| pack.load(&block.parameters[i]));
    let gap = Gap::<D, T> {
        n: core::array::from_fn(|k| pack.load(&block.n[k])),
        distance: pack.load(&block.distance),
        gap: pack.load(&block.gap),
    };
    let zero = T::constant(0.0);
    let is_valid = T::bits(zero.below(E::Law::valid(gap.gap, &parameters)));
    if is_valid != T::all() {
        give_up(block, pack);
        return;
    }
    let law = E::Law::evaluate(gap.gap, &parameters);
    let mut finite = law.traction.is_finite() & law.slope.is_finite() & law.energy.is_finite();
    pack.store(law.traction, &mut block.traction);
    pack.store(law.energy, &mut block.energy);
    if wanted.tangent {
        let mut vectors = Vectors::<D, P, H, T>::default();
        for k in 0..D {
            for i in 0..P {
                vectors.b[i][k] = pack.load(&block.b[i][k]);
                finite = finite & vectors.b[i][k].is_finite();
            }
            for h in 0..H {
                vectors.second[h][k] = pack.load(&block.second[h][k]);
                finite = finite & vectors.second[h][k].is_finite();
            }
        }
        let orientation = orientation(&E::LAYOUT, &parameters);
        let c = E::tangent(&vectors, &gap, &law, &parameters, orientation);
        store_tangent(block, &pack, &c);
    }
    if T::bits(finite) != T::all() {
        give_up(block, pack);
    }
}

/// Stores what the rows of the tangent are made of: one sum per node and row of the right and of the left factors.
#[inline(always)]
fn store_tangent<T: Wide, const D: usize, const P: usize, const H: usize, const N: usize>(
    block: &mut Block<D, P, H, N>,
    pack: &Pack<'_>,
    c: &Coefficients<D, P, T>,
) {
    for k in 0..D {
        for l in 0..D {
            pack.store(c.p[k][l], &mut block.p[k][l]);
        }
        for i in 0..P {
            pack.store(c.left[i][k], &mut block.left[i][k]);
        }
    }
    if P == 0 {
        return;
    }
    for a in 0..N {
        let ds: [T; P] = core::array::from_fn(|i| pack.load(&block.ds[i][a]));
        for k in 0..D {
            pack.store(turned(&ds, |j| c.right[j][k]), &mut block.right_turn[a][k]);
        }
        for i in 0..P {
            pack.store(turned(&ds, |j| c.s[i][j]), &mut block.left_turn[a][i]);
        }
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

/// Leaves the contacts of the lanes to the kernel of one.
#[cold]
#[inline(never)]
fn give_up<const D: usize, const P: usize, const H: usize, const N: usize>(
    block: &mut Block<D, P, H, N>,
    pack: Pack<'_>,
) {
    for &slot in pack.slots {
        block.good &= !(1 << slot);
    }
}
