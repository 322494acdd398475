//! Where the nodes of all contacts stand, and how their positions come into lanes.

use crate::batch::contacts::{Contacts, Places};
use crate::element::gather::Nodes;
use crate::lanes::Wide;

/// Positions of some contacts relative to their first node, by the rules of one call [eq:local-origin]; one bit for
/// each contact whose coordinates can be used. The others have zeros.
///
/// Called through [`BatchLanes::positions`](crate::batch::compiled::BatchLanes::positions): compiled once for all elements of so many nodes.
#[inline(always)]
pub(crate) fn positions<C: Contacts, T: Wide, const D: usize, const N: usize>(
    contacts: &C,
    vectors: &[bool; N],
    numbers: &[usize; 8],
    x: &mut [[T; D]; N],
) -> u32 {
    let places = if vectors.contains(&true) {
        None
    } else {
        contacts.places()
    };
    let Some(places) = places else {
        let mut columns = [[[0.0; 8]; D]; N];
        let good = one_by_one(contacts, vectors, &numbers[..T::WIDTH], &mut columns);
        for (x, columns) in x.iter_mut().zip(&columns) {
            for k in 0..D {
                x[k] = T::load(&columns[k]);
            }
        }
        return good;
    };
    let mut own = [&[0; N]; 8];
    if let Some(list) = places.connectivity {
        for (own, &number) in own.iter_mut().zip(numbers).take(T::WIDTH) {
            match list.get(number * N..).and_then(<[i32]>::first_chunk) {
                Some(nodes) => *own = nodes,
                None => return 0,
            }
        }
    }
    let own = places.connectivity.map(|_| &own);
    load(x, &places.x, own, numbers);
    let mut usable = are_usable(x);
    let mut u = [[T::constant(0.0); D]; N];
    if let Some(places) = &places.u {
        load(&mut u, places, own, numbers);
        usable = usable & are_usable(&u);
    }
    let good = T::bits(usable);
    if good != T::all() {
        clear(x, usable);
        clear(&mut u, usable);
    }
    subtract_first(x);
    if places.u.is_some() {
        subtract_first(&mut u);
        for node in 0..N {
            for k in 0..D {
                x[node][k] = x[node][k] + u[node][k];
            }
        }
    }
    good
}

#[inline(always)]
fn are_usable<T: Wide, const D: usize, const N: usize>(x: &[[T; D]; N]) -> T::Mask {
    let mut usable = T::mask(T::all());
    for node in x {
        for k in 0..D {
            usable = usable & node[k].is_usable();
        }
    }
    usable
}

/// Zeros where the mask does not hold.
#[inline(always)]
fn clear<T: Wide, const D: usize, const N: usize>(x: &mut [[T; D]; N], mask: T::Mask) {
    for node in x {
        for k in 0..D {
            node[k] = T::select(mask, node[k], T::constant(0.0));
        }
    }
}

#[inline(always)]
fn subtract_first<T: Wide, const D: usize, const N: usize>(x: &mut [[T; D]; N]) {
    let first = x[0];
    for node in x {
        for k in 0..D {
            node[k] = node[k] - first[k];
        }
    }
}

/// The nodes of the contact in each lane: by its list of nodes, or one after another.
#[inline(always)]
fn load<T: Wide, const D: usize, const N: usize>(
    x: &mut [[T; D]; N],
    places: &Places<'_>,
    own: Option<&[&[i32; N]; 8]>,
    numbers: &[usize; 8],
) {
    for (node, x) in x.iter_mut().enumerate() {
        let mut starts = [0; 8];
        if let Some(own) = own {
            for (to, own) in starts.iter_mut().zip(own).take(T::WIDTH) {
                let node = own.get(node).copied().unwrap_or(-1) as u32;
                *to = (node as usize).wrapping_mul(places.node_stride);
            }
        } else {
            for (to, &number) in starts.iter_mut().zip(numbers).take(T::WIDTH) {
                *to = number * places.contact_stride + node * places.node_stride;
            }
        }
        *x = vector(places.values, &starts);
    }
}

/// D numbers of the contact in each lane; NaN for numbers that do not exist.
#[inline(always)]
fn vector<T: Wide, const D: usize>(values: &[f64], starts: &[usize; 8]) -> [T; D] {
    let mut last = 0;
    for &start in starts.iter().take(T::WIDTH) {
        last = start.max(last);
    }
    let ends;
    let mut from = [values.as_ptr(); 8];
    if values.get(last..).is_some_and(|rest| rest.len() >= 4) {
        for (from, &start) in from.iter_mut().zip(starts).take(T::WIDTH) {
            // SAFETY: four numbers begin at the last start, and none is beyond it.
            *from = unsafe { from.add(start) };
        }
    } else {
        ends = near_the_end::<D>(values, starts);
        for (from, own) in from.iter_mut().zip(&ends) {
            *from = own.as_ptr();
        }
    }
    // SAFETY: every lane has the address of four numbers.
    let numbers = unsafe { T::collect(&from) };
    let mut x = [T::constant(0.0); D];
    for (x, number) in x.iter_mut().zip(numbers) {
        *x = number;
    }
    x
}

/// Copies of D numbers each: the last ones of an array are fewer than four.
#[cold]
fn near_the_end<const D: usize>(values: &[f64], starts: &[usize; 8]) -> [[f64; 4]; 8] {
    let mut copies = [[f64::NAN; 4]; 8];
    for (copy, &start) in copies.iter_mut().zip(starts) {
        let own = values.get(start..).and_then(<[f64]>::first_chunk::<D>);
        for (to, value) in copy.iter_mut().zip(own.into_iter().flatten()) {
            *to = *value;
        }
    }
    copies
}

/// [`positions`] of nodes anywhere, contact after contact.
#[inline(never)]
fn one_by_one<C: Contacts, const D: usize, const N: usize>(
    contacts: &C,
    vectors: &[bool; N],
    numbers: &[usize],
    columns: &mut [[[f64; 8]; D]; N],
) -> u32 {
    let mut good = 0;
    for (lane, &number) in numbers.iter().enumerate() {
        if let Some(own) = position::<D, N>(&contacts.nodes(number), vectors) {
            good |= 1 << lane;
            for (column, own) in columns.iter_mut().zip(own) {
                for k in 0..D {
                    column[k][lane % 8] = own[k];
                }
            }
        }
    }
    good
}

/// Positions of one contact relative to its first node; `None` if they cannot be used.
#[inline(always)]
fn position<const D: usize, const N: usize>(
    nodes: &Nodes<'_>,
    vectors: &[bool; N],
) -> Option<[[f64; D]; N]> {
    nodes.check::<D>(N).ok()?;
    let origin = nodes.reference::<D>(0).ok()?;
    let shift = nodes.displacement::<D>(0).ok()?;
    let mut values = [[0.0; D]; N];
    for (a, value) in values.iter_mut().enumerate() {
        let position = nodes.reference::<D>(a).ok()?;
        let displacement = nodes.displacement::<D>(a).ok()?;
        for k in 0..D {
            value[k] = if vectors[a] {
                position[k] + displacement[k]
            } else if a == 0 {
                0.0
            } else if nodes.u.is_some() {
                (position[k] - origin[k]) + (displacement[k] - shift[k])
            } else {
                position[k] - origin[k]
            };
        }
    }
    Some(values)
}
