//! A library that is bad on purpose: what the harness has to notice.

use std::hint::{black_box, spin_loop};
use std::sync::OnceLock;
use std::sync::atomic::AtomicU64;
use std::sync::atomic::Ordering::Relaxed;

use clap::ValueEnum;
use contact_elements::Registered;
use contact_elements::abi::Arguments;

use crate::check::{ARGUMENTS_IN_0_1, is_refused};
use crate::interface::Interface;
use crate::plan::request;

/// How `cte_element_evaluate` misbehaves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Sabotage {
    /// Writes one double behind `energy`.
    WriteBehind,
    /// Writes one double before `energy`.
    WriteBefore,
    /// Writes to x.
    WriteInput,
    /// Writes to a field of the struct that is an input.
    WriteStruct,
    /// Writes to an output that was not asked for.
    WriteUnrequested,
    /// Writes after an error.
    WriteOnError,
    /// Leaves an output unwritten.
    LeaveOut,
    /// Reads one double behind the parameters.
    ReadBehind,
    /// Returns a code that is not documented.
    Code,
    /// Reports a status that is not documented.
    Status,
    /// Writes NaN.
    NotFinite,
    /// Takes an infinite scale.
    TakeInfinity,
    /// Gives other numbers every time.
    Forget,
    /// Divides by zero.
    DivideByZero,
    /// Overflows, and hides it.
    Overflow,
    /// Panics, as seen from outside.
    Abort,
    /// Never returns.
    Hang,
}

type Evaluate = unsafe extern "C" fn(*const Registered, *mut Arguments) -> i32;

static GOOD: OnceLock<(Evaluate, Sabotage)> = OnceLock::new();
static CALLS: AtomicU64 = AtomicU64::new(0);

/// The interface with a bad evaluation.
pub fn sabotaged(mut interface: Interface, sabotage: Sabotage) -> Interface {
    GOOD.get_or_init(|| (interface.table.element_evaluate, sabotage));
    interface.table.element_evaluate = evaluate;
    interface.symbols.clear();
    interface
}

/// The good evaluation, and then harm.
unsafe extern "C" fn evaluate(element: *const Registered, arguments: *mut Arguments) -> i32 {
    let Some((good, sabotage)) = GOOD.get() else {
        return 0;
    };
    // SAFETY: the harness keeps the header's promises; every struct begins with its size.
    unsafe {
        let is_refused = arguments.is_null()
            || is_refused::<Arguments>(*arguments.cast::<u32>(), ARGUMENTS_IN_0_1);
        if is_refused {
            return good(element, arguments);
        }
        let scale = (*arguments).f_scale;
        if *sabotage == Sabotage::TakeInfinity && scale.is_infinite() {
            (*arguments).f_scale = 1.0;
        }
        let code = good(element, arguments);
        (*arguments).f_scale = scale;
        harm(*sabotage, &mut *arguments, code)
    }
}

/// # Safety
/// The struct is whole, and its pointers are valid where the request needs them and the code is 0.
unsafe fn harm(sabotage: Sabotage, arguments: &mut Arguments, code: i32) -> i32 {
    let wants = |bit: u32| arguments.request & bit != 0 && code == 0;
    let energy = arguments.energy;
    // SAFETY: not safe, this is the harm.
    unsafe {
        match sabotage {
            Sabotage::WriteBehind if wants(request::ENERGY) => *energy.add(1) = 0.0,
            Sabotage::WriteBefore if wants(request::ENERGY) => *energy.sub(1) = 0.0,
            Sabotage::WriteInput if code == 0 => *arguments.x.cast_mut() = 0.0,
            Sabotage::WriteStruct => arguments.padding ^= 1,
            Sabotage::WriteUnrequested
                if code == 0 && !wants(request::ENERGY) && !energy.is_null() =>
            {
                *energy = 0.0;
            }
            Sabotage::WriteOnError
                if code < 0
                    && arguments.request & request::HISTORY != 0
                    && !arguments.history_trial.is_null() =>
            {
                *arguments.history_trial = 0.0;
            }
            Sabotage::LeaveOut if wants(request::ENERGY) => {
                *energy = f64::from_bits(crate::memory::CANARY);
            }
            Sabotage::ReadBehind if code == 0 => {
                let count = arguments.parameter_count as usize;
                black_box(arguments.parameters.add(count).read_volatile());
            }
            Sabotage::Code => return 77,
            Sabotage::Status => arguments.status = 99,
            Sabotage::NotFinite if wants(request::ENERGY) => *energy = f64::NAN,
            Sabotage::Forget if wants(request::ENERGY) => {
                *energy += CALLS.fetch_add(1, Relaxed) as f64;
            }
            Sabotage::DivideByZero => {
                black_box(black_box(1.0) / black_box(0.0));
            }
            Sabotage::Overflow => {
                black_box(black_box(1e200) * black_box(1e200));
            }
            Sabotage::Abort => std::process::abort(),
            Sabotage::Hang => loop {
                spin_loop();
            },
            _ => {}
        }
    }
    code
}
