//! A hash over what is formulated: it changes when the emitted code means something else, and with nothing else.

use std::fmt::{self, Write as _};

use crate::ir::Program;

/// FNV-1a of a text that is written bit by bit.
pub struct Digest(u64);

impl Digest {
    /// The hash of nothing.
    pub fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    /// Takes in the operations, outputs and terms of a program.
    pub fn program(&mut self, program: &Program) {
        self.value(&program.inputs);
        for node in program.graph.nodes() {
            self.value(node);
        }
        self.value(&program.outputs);
        self.value(&program.terms);
    }

    /// Takes in a value by its debug text.
    pub fn value(&mut self, value: &dyn fmt::Debug) {
        // writing to a hash cannot fail
        let _ = write!(self, "{value:?};");
    }

    /// The hash of all that was taken in.
    pub fn finish(self) -> u64 {
        self.0
    }
}

impl fmt::Write for Digest {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.0 = text.bytes().fold(self.0, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
        });
        Ok(())
    }
}
