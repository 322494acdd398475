//! Coverage-guided fuzzing by libFuzzer: started by `tests/fuzz/guided`, see `docs/fuzzing.md`.
#![no_main]

use std::cell::RefCell;
use std::path::Path;
use std::process::abort;

use contact_fuzz::guided::Guided;
use libfuzzer_sys::fuzz_target;

thread_local! {
    static GUIDED: RefCell<Option<Guided>> = const { RefCell::new(None) };
}

fuzz_target!(
    init: {
        let library = std::env::var_os("CONTACT_LIBRARY").unwrap_or_default();
        match Guided::new(Path::new(&library)) {
            Ok(guided) => GUIDED.set(Some(guided)),
            Err(error) => {
                eprintln!("guided: CONTACT_LIBRARY: {error}");
                std::process::exit(2);
            }
        }
    },
    |bytes: &[u8]| {
        GUIDED.with_borrow_mut(|guided| {
            let found = guided.as_mut().map(|guided| guided.case(bytes));
            if let Some(Err(what)) = found {
                eprintln!("found: {what}");
                abort();
            }
        });
    }
);
