//! A short run finds nothing, and the harness notices every kind of bad library.

use std::path::PathBuf;
use std::process::Command;
use std::sync::LazyLock;
use std::time::Duration;

use clap::ValueEnum;
use contact_fuzz::element::Element;
use contact_fuzz::interface::Interface;
use contact_fuzz::ledger::FUNCTIONS;
use contact_fuzz::numbers::NUMBERS;
use contact_fuzz::parent::{Options, Summary, replay, run};
use contact_fuzz::sabotage::Sabotage;

/// The shared library beside the program, built again.
static LIBRARY: LazyLock<PathBuf> = LazyLock::new(|| {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let built = Command::new(cargo)
        .args([
            "build",
            "--release",
            "--quiet",
            "-p",
            "contact-elements-capi",
        ])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .status();
    assert!(built.is_ok_and(|status| status.success()), "no library");
    let program = PathBuf::from(env!("CARGO_BIN_EXE_fuzz"));
    let folder = program.ancestors().nth(2).expect("the target directory");
    folder.join("release").join("libcontact_elements.so")
});

fn options(calls: u64) -> Options {
    Options {
        program: PathBuf::from(env!("CARGO_BIN_EXE_fuzz")),
        library: LIBRARY.clone(),
        seed: 20150,
        input: None,
        calls,
        element: String::new(),
        jobs: 2,
        limit: Duration::from_secs(30),
        enough: 20,
        sabotage: None,
        progress: false,
    }
}

fn ran(options: &Options) -> Summary {
    run(options).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn a_hundred_thousand_cases_find_nothing() {
    let summary = ran(&options(100_000));
    assert!(summary.findings.is_empty(), "{:#?}", summary.findings);
    assert_eq!(summary.begun(), 100_000);
    for (name, calls) in FUNCTIONS.iter().zip(summary.calls()) {
        assert!(calls > 100, "{name} was called {calls} times");
    }
    // every element, in contact; every status, every code
    let interface = Interface::load(&LIBRARY).unwrap_or_else(|error| panic!("{error}"));
    let elements = Element::all(&interface).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(summary.elements(), [elements.len(); 2]);
    for (status, name) in &NUMBERS.statuses {
        assert!(summary.status(*status) > 0, "{name} never met");
    }
    for (code, name) in &NUMBERS.codes {
        assert!(summary.code(*code) > 0, "{name} never met");
    }
}

/// What the harness says of each kind of bad library.
fn verdict(sabotage: Sabotage) -> &'static str {
    match sabotage {
        // a byte of the margin or the guard page, as the array lies
        Sabotage::WriteBehind | Sabotage::WriteBefore => "written before|written behind|signal: 11",
        Sabotage::WriteInput | Sabotage::ReadBehind => "signal: 11",
        Sabotage::WriteStruct => "an input of the struct was written",
        Sabotage::WriteUnrequested => "energy: entry 0 was written|signal: 11",
        Sabotage::WriteOnError => {
            "history_trial: entry 0 was written|history_accepted: entry 0 was written"
        }
        Sabotage::LeaveOut => "energy: entry 0 was not written",
        Sabotage::Code => "undocumented return code 77",
        Sabotage::Status => "undocumented status 99",
        Sabotage::NotFinite => "energy: entry 0 is Some(NaN)",
        Sabotage::TakeInfinity => "a value that cannot be used is taken",
        Sabotage::Forget => "not the same twice|has other bits alone",
        Sabotage::DivideByZero | Sabotage::Overflow => "signal: 8",
        Sabotage::Abort => "signal: 6",
        Sabotage::Hang => "no return within 1 s",
    }
}

#[test]
fn every_kind_of_bad_library_is_noticed() {
    for &sabotage in Sabotage::value_variants() {
        let options = Options {
            // one element: what is rare comes soon enough
            element: "PointQuad4Coulomb".to_string(),
            limit: Duration::from_secs(1),
            enough: 1,
            sabotage: Some(sabotage),
            ..options(20_000)
        };
        let summary = ran(&options);
        let expected: Vec<&str> = verdict(sabotage).split('|').collect();
        let noticed = |what: &str| expected.iter().any(|part| what.contains(part));
        let finding = summary.findings.first();
        let finding = finding.unwrap_or_else(|| panic!("{sabotage:?} was not noticed"));
        assert!(noticed(&finding.what), "{sabotage:?}: {finding:?}");
        // the call alone says the same
        let again = replay(&options, finding.call).unwrap_or_else(|error| panic!("{error}"));
        let again = again.unwrap_or_else(|| panic!("{sabotage:?}: nothing at {}", finding.call));
        assert!(noticed(&again.what), "{sabotage:?}: {again:?}");
    }
}
