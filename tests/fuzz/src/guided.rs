//! Calls whose decisions are bytes: what coverage-guided fuzzing changes, and what is repeated from a file.

use std::path::Path;

use tempfile::NamedTempFile;

use crate::entropy::Entropy;
use crate::harness::{Checked, Harness};
use crate::interface::Interface;
use crate::ledger::Ledger;

/// One library that is called with bytes.
pub struct Guided {
    harness: Harness,
    /// Keeps the counters.
    _ledger: NamedTempFile,
}

impl Guided {
    /// Loads a library.
    pub fn new(library: &Path) -> Result<Self, String> {
        let file = NamedTempFile::new().map_err(|error| error.to_string())?;
        let sized = file.as_file().set_len(Ledger::SIZE);
        sized.map_err(|error| error.to_string())?;
        let ledger = Ledger::shared(file.as_file()).map_err(|error| error.to_string())?;
        let interface = Interface::load(library)?;
        Ok(Self {
            harness: Harness::new(interface, "", ledger)?,
            _ledger: file,
        })
    }

    /// Makes the calls that the bytes decide.
    pub fn case(&mut self, bytes: &[u8]) -> Checked {
        self.harness.case(&mut Entropy::of_bytes(bytes))
    }
}
