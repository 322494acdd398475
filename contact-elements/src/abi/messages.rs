//! Texts of the interface: static and zero-terminated; each says what to do.

use super::types::Arguments;
use super::versioned::is_whole;
use crate::codes::{argument, code};
use crate::messages::{argument_text, code_text, status_text};
use crate::registered::Registered;

/// What a return code means; `cte_code_message`.
pub fn code_message(value: i32) -> *const u8 {
    code_text(value).as_ptr()
}

/// What a status means; `cte_status_message`.
pub fn status_message(value: i32) -> *const u8 {
    status_text(value).as_ptr()
}

/// Name of an argument; `cte_argument_name`.
pub fn argument_name(value: i32) -> *const u8 {
    argument_text(value).as_ptr()
}

/// Collects text into a caller's buffer and counts what did not fit.
struct Writer {
    text: *mut u8,
    size: usize,
    length: usize,
}

impl Writer {
    fn push(&mut self, text: &str) {
        for byte in text.trim_end_matches('\0').bytes() {
            if self.length + 1 < self.size {
                // SAFETY: the caller gave `size` bytes.
                unsafe { *self.text.add(self.length) = byte };
            }
            self.length += 1;
        }
    }

    fn number(&mut self, value: i32) {
        let mut digits = [b'0'; 10];
        let mut rest = value.unsigned_abs();
        let mut used = 0;
        for digit in digits.iter_mut().rev() {
            *digit = b'0' + (rest % 10) as u8;
            used += 1;
            rest /= 10;
            if rest == 0 {
                break;
            }
        }
        let tail = digits.get(10 - used..).unwrap_or(&[]);
        self.push(core::str::from_utf8(tail).unwrap_or(""));
    }

    fn finish(self) -> i32 {
        if self.size > 0 {
            // SAFETY: the caller gave `size` bytes.
            unsafe { *self.text.add(self.length.min(self.size - 1)) = 0 };
        }
        self.length as i32
    }
}

/// `cte_element_message`.
///
/// # Safety
/// Pointers come from this interface, or are null; `text` has room for `size` bytes.
pub unsafe fn element_message(
    element: *const Registered,
    arguments: *const Arguments,
    value: i32,
    text: *mut u8,
    size: i32,
) -> i32 {
    let size = if text.is_null() {
        0
    } else {
        usize::try_from(size).unwrap_or(0)
    };
    let mut writer = Writer {
        text,
        size,
        length: 0,
    };
    // SAFETY: promised by the caller.
    let (element, arguments) = unsafe { (element.as_ref(), whole(arguments)) };
    if let Some(element) = element {
        writer.push(element.name);
        writer.push(": ");
    }
    if let Some(arguments) = arguments.filter(|_| value != code::SUCCESS) {
        describe_place(&mut writer, element, arguments);
    }
    writer.push(code_text(value));
    writer.finish()
}

/// The arguments, where the struct has all the fields that are read.
///
/// # Safety
/// `arguments` is null or points to a struct of the size that it begins with.
unsafe fn whole<'a>(arguments: *const Arguments) -> Option<&'a Arguments> {
    // SAFETY: every struct begins with its size.
    if arguments.is_null() || !unsafe { is_whole(arguments) } {
        return None;
    }
    // SAFETY: the caller's struct is at least as large as ours.
    unsafe { arguments.as_ref() }
}

fn describe_place(writer: &mut Writer, element: Option<&Registered>, arguments: &Arguments) {
    if arguments.error_argument == argument::NONE {
        return;
    }
    writer.push("argument `");
    writer.push(argument_text(arguments.error_argument));
    writer.push("`, entry ");
    writer.number(arguments.error_index);
    if arguments.error_argument == argument::PARAMETERS {
        let parameter = usize::try_from(arguments.error_index)
            .ok()
            .and_then(|index| element?.parameters.get(index));
        if let Some(parameter) = parameter {
            writer.push(" (");
            writer.push(parameter.name);
            writer.push(")");
        }
    }
    writer.push(": ");
}
