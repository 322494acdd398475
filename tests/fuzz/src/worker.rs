//! A process that makes calls until it is through, or dies.

use std::fs::OpenOptions;
use std::io::Write;
use std::path::Path;

use crate::entropy::Entropy;
use crate::harness::Harness;
use crate::interface::Interface;
use crate::ledger::Ledger;
use crate::parent::Options;
use crate::sabotage::sabotaged;

/// Which calls a worker makes: every `step`-th from `first`, below `end`.
#[derive(Clone, Copy, Debug)]
pub struct Share {
    /// The first call.
    pub first: u64,
    /// From call to call.
    pub step: u64,
    /// Behind the last one.
    pub end: u64,
}

/// Makes the calls of a share; each finding is a line of standard output, the call and what was found.
pub fn work(options: &Options, share: Share, ledger: &Path, verbose: bool) -> Result<(), String> {
    let file = OpenOptions::new().read(true).write(true).open(ledger);
    let file = file.map_err(|error| format!("{}: {error}", ledger.display()))?;
    let ledger = Ledger::shared(&file).map_err(|error| format!("no ledger: {error}"))?;
    let mut interface = Interface::load(&options.library)?;
    if let Some(sabotage) = options.sabotage {
        interface = sabotaged(interface, sabotage);
    }
    let mut harness = Harness::new(interface, &options.element, ledger)?;
    harness.verbose = verbose;
    let input = match &options.input {
        Some(path) => {
            let bytes = std::fs::read(path);
            Some(bytes.map_err(|error| format!("{}: {error}", path.display()))?)
        }
        None => None,
    };
    let mut call = share.first;
    while call < share.end {
        harness.begin(call);
        let mut entropy = match &input {
            Some(bytes) => Entropy::of_bytes(bytes),
            None => Entropy::of_call(options.seed, call),
        };
        if let Err(what) = harness.case(&mut entropy) {
            let mut output = std::io::stdout().lock();
            let line = writeln!(output, "{call}\t{what}").and_then(|()| output.flush());
            line.map_err(|error| format!("nobody listens: {error}"))?;
        }
        call += share.step;
    }
    Ok(())
}
