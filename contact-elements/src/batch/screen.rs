//! Which contacts are open wherever their projection lies: they need no projection.
//!
//! If a facet is linear in each parameter, so is r·(b_1×b_2), which is therefore least at a corner of the
//! domain; |b_1×b_2| is at most the product of the largest tangents. [eq:screen]

use crate::batch::block::{MOST_PARAMETERS, MOST_UNKNOWNS};
use crate::batch::compiled::BatchLanes;
use crate::batch::contacts::Contacts;
use crate::batch::point::orientation;
use crate::element::traits::Element;
#[cfg(target_arch = "x86_64")]
use crate::lanes::{Four, Width};
use crate::lanes::{Real, Wide};
use crate::point::domain::Domain;
use crate::point::law::NormalLaw;
use crate::point::projection::step::SMALLEST;
use crate::point::values::{Enforcement, Rows, Vectors, dot};

/// Contacts that are screened at once.
pub const SCREENED: usize = 32;

/// Rounding of the bound and slack of the domain, relative to the lengths that the bound is made of.
const ROUNDING: f64 = 1e-11;

/// True for elements that [`screen`] can judge: a point against a segment in 2D or a facet that is linear in
/// each parameter, a gap with a sign, a law that acts below some gap.
pub const fn is_screened<
    E: Element<D, P, H>,
    const D: usize,
    const P: usize,
    const H: usize,
    const N: usize,
>() -> bool {
    let is_pair = E::SIGNED && !E::TWO_CURVES && E::SLAVE_NODES == 1 && E::MASTER_NODES > 0;
    let is_penalty = matches!(E::ENFORCEMENT, Enforcement::Penalty);
    let is_linear = !E::CURVED[0] && !E::CURVED[2];
    let is_bounded = match E::DOMAINS[0] {
        Domain::Interval(..) | Domain::Rectangle(..) => true,
        Domain::Triangle => !E::CURVED[1],
        Domain::Unbounded => false,
    };
    let fits = N * D <= MOST_UNKNOWNS && E::LAYOUT.count <= MOST_PARAMETERS;
    let has_room = P + 1 == D && P > 0 && fits;
    is_pair && is_penalty && is_linear && is_bounded && has_room && E::Law::CLOSES_BELOW
}

/// One bit for each of at most [`SCREENED`] contacts from `first` on that is certainly open, and a lower bound of its
/// gap. No bit is set without AVX2, nor for contacts whose inputs cannot be used.
pub fn screen<
    E: Element<D, P, H>,
    C: Contacts,
    const D: usize,
    const P: usize,
    const H: usize,
    const N: usize,
>(
    contacts: &C,
    (first, count): (usize, usize),
    vectors: &[bool; N],
    bounds: &mut [f64; SCREENED],
) -> u32 {
    #[cfg(target_arch = "x86_64")]
    if Width::widest() >= Width::Four {
        #[target_feature(enable = "avx2")]
        fn four<
            E: Element<D, P, H>,
            C: Contacts,
            const D: usize,
            const P: usize,
            const H: usize,
            const N: usize,
        >(
            contacts: &C,
            place: (usize, usize),
            vectors: &[bool; N],
            bounds: &mut [f64; SCREENED],
        ) -> u32 {
            all::<E, C, Four, D, P, H, N>(contacts, place, vectors, bounds)
        }
        // SAFETY: the processor has AVX2.
        return unsafe { four::<E, C, D, P, H, N>(contacts, (first, count), vectors, bounds) };
    }
    0
}

#[inline(always)]
fn all<
    E: Element<D, P, H>,
    C: Contacts,
    T: BatchLanes,
    const D: usize,
    const P: usize,
    const H: usize,
    const N: usize,
>(
    contacts: &C,
    (first, count): (usize, usize),
    vectors: &[bool; N],
    bounds: &mut [f64; SCREENED],
) -> u32 {
    let count = count.min(SCREENED);
    let last = (first + count).saturating_sub(1);
    let mut open = 0;
    let (mut parameters, mut are_allowed) = ([T::constant(0.0); MOST_PARAMETERS], 0);
    for group in (0..count).step_by(T::WIDTH) {
        let numbers = core::array::from_fn(|lane| last.min(first + group + lane));
        if group == 0 || !contacts.have_same_parameters() {
            (parameters, are_allowed) = parameters_of(contacts, &numbers);
        }
        let mut x = [[T::constant(0.0); D]; N];
        let good = T::positions(contacts, vectors, &numbers, &mut x);
        let (bound, certain) = bound::<E, T, D, P, H>(&x, &parameters);
        if let Some(to) = bounds.get_mut(group..) {
            bound.store(to);
        }
        open |= (T::bits(certain) & good & are_allowed) << group;
    }
    // a shift by the full number of bits would leave the value unchanged
    open & (u64::MAX >> (64 - count as u32 % 64)) as u32
}

/// Parameters of some contacts; one bit for each whose are accepted.
#[inline(always)]
fn parameters_of<C: Contacts, T: Wide>(
    contacts: &C,
    numbers: &[usize; 8],
) -> ([T; MOST_PARAMETERS], u32) {
    let mut columns = [[0.0; 8]; MOST_PARAMETERS];
    let mut allowed = 0;
    for (lane, &number) in numbers.iter().enumerate().take(T::WIDTH) {
        let Some(own) = contacts.parameters(number) else {
            continue;
        };
        allowed |= 1 << lane;
        for (column, &value) in columns.iter_mut().zip(own) {
            if let Some(to) = column.get_mut(lane) {
                *to = value;
            }
        }
    }
    let mut parameters = [T::constant(0.0); MOST_PARAMETERS];
    for (to, column) in parameters.iter_mut().zip(&columns) {
        *to = T::load(column);
    }
    (parameters, allowed)
}

/// A lower bound of the gap, and where it is certain that the law does not act.
#[inline(always)]
fn bound<E: Element<D, P, H>, T: Wide, const D: usize, const P: usize, const H: usize>(
    x: &[[T; D]],
    parameters: &[T; MOST_PARAMETERS],
) -> (T, T::Mask) {
    let (zero, one) = (T::constant(0.0), T::constant(1.0));
    let (least, most, size) = extremes::<E, T, D, P, H>(x, parameters);
    let r0 = parameters.get(E::LAYOUT.r0).copied().unwrap_or(zero);
    let certain = zero.below(least) & T::constant(SMALLEST * SMALLEST).below(most);
    let distance = T::select(certain, least, zero) / T::select(certain, most, one);
    let rounding = T::constant(ROUNDING) * (size + r0.abs());
    let bound = distance - r0 - rounding;
    let acts = E::Law::active(bound, parameters);
    (bound, certain & acts.at_most(zero))
}

/// The least of r·m over the domain, m the normal's direction, the largest |m|, and the lengths that both are made of.
#[inline(always)]
fn extremes<E: Element<D, P, H>, T: Wide, const D: usize, const P: usize, const H: usize>(
    x: &[[T; D]],
    parameters: &[T; MOST_PARAMETERS],
) -> (T, T, T) {
    let zero = T::constant(0.0);
    let (mut s, mut ds) = ([zero; MOST_UNKNOWNS], [[zero; MOST_UNKNOWNS]; P]);
    let mut rows = Rows {
        s: s.get_mut(..x.len()).unwrap_or_default(),
        ds: ds
            .each_mut()
            .map(|row| row.get_mut(..x.len()).unwrap_or_default()),
    };
    E::slave(0, parameters, rows.s);
    let mut centre = [zero; P];
    for (to, value) in centre.iter_mut().zip(E::centre()) {
        *to = T::constant(value);
    }
    let vectors = E::kinematics(x, &centre, parameters, &mut rows);
    let Vectors { r, b, second } = &vectors;
    let sign = orientation(&E::LAYOUT, parameters);
    let mut size = length(r);
    if P == 1 {
        let along = r[0] * b[0][D - 1] - r[D - 1] * b[0][0];
        let first = length(&b[0]);
        let half = T::constant(0.5 * E::extent(0));
        return (sign * along, first, size + half * first);
    }
    let (a, b) = (&b[0], &b[P - 1]);
    let half = [
        T::constant(0.5 * E::extent(0)),
        T::constant(0.5 * E::extent(1)),
    ];
    let (mut first, mut last) = (length(a), length(b));
    size = size + half[0] * first + half[1] * last;
    let normal = cross(a, b);
    let mut least = sign * dot(r, &normal);
    if E::CURVED[1] {
        let c = &second[1];
        let along = half[0] * dot(r, &cross(a, c));
        let across = half[1] * dot(r, &cross(c, b));
        let turn = half[0] * half[1] * dot(c, &normal);
        let same = least - sign * turn - (along + across).abs();
        let other = least + sign * turn - (along - across).abs();
        least = same.smaller(other);
        let bend = length(c);
        first = first + half[1] * bend;
        last = last + half[0] * bend;
        size = size + half[0] * half[1] * bend;
    }
    (least, first * last, size)
}

#[inline(always)]
fn length<T: Real, const D: usize>(v: &[T; D]) -> T {
    dot(v, v).sqrt()
}

#[inline(always)]
fn cross<T: Real, const D: usize>(a: &[T; D], b: &[T; D]) -> [T; D] {
    let mut all = [T::constant(0.0); D];
    for (k, to) in all.iter_mut().enumerate() {
        let (i, j) = ((k + 1) % D, (k + 2) % D);
        *to = a[i] * b[j] - a[j] * b[i];
    }
    all
}
