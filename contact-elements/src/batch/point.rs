//! First pass over a block in lanes: projection, gap, open or closed.

use crate::batch::block::{Block, Column, MOST_PARAMETERS, ROOM, load_lanes, store_lanes};
use crate::batch::newton::project;
use crate::element::receiver::Wanted;
use crate::element::traits::{Element, Layout};
use crate::lanes::Wide;
use crate::point::history::FARTHEST_PROJECTION;
use crate::point::law::NormalLaw;
use crate::point::values::{Gap, Rows, Vectors};

#[inline(always)]
pub(crate) fn orientation<T: Wide>(layout: &Layout, parameters: &[T]) -> T {
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

/// Inputs of the lanes from `group` on; a lane that cannot be evaluated repeats those of one that can.
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
// long: a list of steps, each of which narrows the same mask
#[inline(always)]
pub(crate) fn classify<
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
