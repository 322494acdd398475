//! Floating-point exceptions as a host sees them that runs with traps on.

use std::ffi::c_int;

// The environment of the C library: a host in C turns traps on by the same calls.
unsafe extern "C" {
    fn feenableexcept(exceptions: c_int) -> c_int;
    fn fedisableexcept(exceptions: c_int) -> c_int;
    fn feclearexcept(exceptions: c_int) -> c_int;
    fn fetestexcept(exceptions: c_int) -> c_int;
}

#[cfg(target_arch = "x86_64")]
const INVALID: c_int = 1;
#[cfg(target_arch = "x86_64")]
const DIVIDE_BY_ZERO: c_int = 4;
#[cfg(target_arch = "x86_64")]
const OVERFLOW: c_int = 8;
#[cfg(not(target_arch = "x86_64"))]
const INVALID: c_int = 1;
#[cfg(not(target_arch = "x86_64"))]
const DIVIDE_BY_ZERO: c_int = 2;
#[cfg(not(target_arch = "x86_64"))]
const OVERFLOW: c_int = 4;

const ALL: c_int = INVALID | DIVIDE_BY_ZERO | OVERFLOW;

/// What happens at an invalid operation, a division by zero or an overflow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Exceptions {
    /// SIGFPE.
    Trap,
    /// They are noted.
    Note,
}

impl Exceptions {
    /// Runs `call`; the exceptions that it raised.
    pub fn during<R>(self, call: impl FnOnce() -> R) -> (R, Option<String>) {
        // SAFETY: the functions change the environment of this thread only, and it is restored below.
        unsafe {
            feclearexcept(ALL);
            if self == Exceptions::Trap {
                feenableexcept(ALL);
            }
        }
        let result = call();
        // SAFETY: as above.
        let raised = unsafe {
            fedisableexcept(ALL);
            fetestexcept(ALL)
        };
        let names = [
            (INVALID, "invalid"),
            (DIVIDE_BY_ZERO, "divide-by-zero"),
            (OVERFLOW, "overflow"),
        ];
        let found = names.iter().filter(|(bit, _)| raised & bit != 0);
        let found: Vec<&str> = found.map(|(_, name)| *name).collect();
        (result, (!found.is_empty()).then(|| found.join(", ")))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::hint::black_box;

    #[test]
    fn exceptions_are_noted() {
        let quotient = || black_box(black_box(1.0) / black_box(0.0));
        let (_, raised) = Exceptions::Note.during(quotient);
        assert_eq!(raised.as_deref(), Some("divide-by-zero"));
        let (_, raised) = Exceptions::Note.during(|| black_box(1.0) / black_box(3.0));
        assert_eq!(raised, None);
    }
}
