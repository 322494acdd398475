//! Sizes, names and messages.

use super::super::describe::{Registry, element_find, element_info};
use super::super::messages::element_message;
use super::super::pointers::write;
use super::super::types::{Arguments, Info};
use super::addresses::{element, value};
use crate::codes::{argument, code};

/// Numbers that `INFO` and `PATCH_INFO` write.
const SIZES: usize = 13;
/// Characters of a name that are looked at.
const LONGEST_NAME: usize = 128;
/// Characters of a message.
const LONGEST_MESSAGE: usize = 512;

/// `CTE_F77_INFO`.
///
/// # Safety
/// Every address is null or valid for the shape that the header gives.
pub unsafe fn info(
    elements: Registry<'_>,
    index: *const i32,
    nnode: *const i32,
    sizes: *mut i32,
    result: *mut i32,
) {
    let mut info = Info::EMPTY;
    // SAFETY: promised by the caller.
    unsafe {
        let asked = element(elements, index, argument::ELEMENT)
            .and_then(|element| Ok((element, value(nnode, argument::NNODE)?)));
        let code = match asked {
            Ok(_) if sizes.is_null() => code::NULL,
            Ok((element, nnode)) => element_info(element, nnode, &raw mut info),
            Err(error) => error.code,
        };
        write_sizes(sizes, code, &info);
        write(result, code);
    }
}

/// Writes the sizes, or −1 to each of them after an error.
///
/// # Safety
/// `sizes` is null or points to `SIZES` integers.
pub(super) unsafe fn write_sizes(sizes: *mut i32, code: i32, info: &Info) {
    if sizes.is_null() {
        return;
    }
    let values: [i32; SIZES] = match code {
        code::SUCCESS => [
            info.dimension,
            info.nodes_minimum,
            info.nodes_maximum,
            info.slave_nodes,
            info.master_nodes,
            info.unknowns,
            info.parameters,
            info.history,
            info.points,
            info.projected,
            info.requests as i32,
            info.symmetric,
            i32::try_from(info.workspace).unwrap_or(i32::MAX),
        ],
        _ => [-1; SIZES],
    };
    // SAFETY: promised by the caller.
    unsafe { core::ptr::copy_nonoverlapping(values.as_ptr(), sizes, SIZES) };
}

/// `CTE_F77_FIND`.
///
/// # Safety
/// `name` is null or has `length` codes of characters; the other addresses are null or valid.
pub unsafe fn find(
    elements: Registry<'_>,
    name: *const i32,
    length: *const i32,
    index: *mut i32,
    result: *mut i32,
) {
    // SAFETY: promised by the caller.
    unsafe {
        let code = match (value(length, argument::ELEMENT_NAME), name.is_null()) {
            (Ok(length), false) => {
                let length = usize::try_from(length).unwrap_or(0);
                match characters(core::slice::from_raw_parts(name, length)) {
                    Some(text) => {
                        let length = text.len() as i32;
                        element_find(elements, text.as_ptr(), length, index)
                    }
                    None => code::NAME,
                }
            }
            _ => code::NULL,
        };
        write(result, code);
    }
}

/// Characters of a name from their codes, blanks behind it; `None` where no element has such a name.
fn characters(codes: &[i32]) -> Option<[u8; LONGEST_NAME]> {
    let mut text = [b' '; LONGEST_NAME];
    for (at, &code) in codes.iter().enumerate() {
        let letter = u8::try_from(code).ok().filter(u8::is_ascii)?;
        match text.get_mut(at) {
            Some(place) => *place = letter,
            None if letter == b' ' => {}
            None => return None,
        }
    }
    Some(text)
}

/// `CTE_F77_MESSAGE`.
///
/// # Safety
/// `state` is null or has four entries; `text` is null or has room for `size` codes; the other addresses are null or
/// valid.
pub unsafe fn message(
    elements: Registry<'_>,
    index: *const i32,
    number: *const i32,
    state: *const i32,
    text: *mut i32,
    size: *const i32,
    length: *mut i32,
) {
    let mut arguments = Arguments::EMPTY;
    let mut letters = [0_u8; LONGEST_MESSAGE];
    // SAFETY: promised by the caller.
    unsafe {
        let element = element(elements, index, argument::ELEMENT).unwrap_or(core::ptr::null());
        if let Ok([_, _, name, entry]) = value(state.cast::<[i32; 4]>(), argument::STATUS) {
            (arguments.error_argument, arguments.error_index) = (name, entry);
        }
        let number = value(number, argument::STATUS).unwrap_or(code::NULL);
        let room = letters.len() as i32;
        let needed = element_message(
            element,
            &raw const arguments,
            number,
            letters.as_mut_ptr(),
            room,
        );
        write(length, needed);
        let size = usize::try_from(value(size, argument::RESULT).unwrap_or(0)).unwrap_or(0);
        if text.is_null() {
            return;
        }
        let end = letters.iter().position(|&letter| letter == 0);
        let known = letters.get(..end.unwrap_or(0)).unwrap_or(&[]);
        for at in 0..size {
            let letter = known.get(at).copied().unwrap_or(b' ');
            *text.add(at) = i32::from(letter);
        }
    }
}
