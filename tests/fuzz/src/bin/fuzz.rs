//! `cargo run --release -p contact-fuzz --bin fuzz -- --calls 10000000`: see `docs/fuzzing.md`.

use std::path::PathBuf;
use std::process::{Command, ExitCode};
use std::time::Duration;

use clap::Parser;
use contact_fuzz::parent::{Finding, Options, replay, run};
use contact_fuzz::sabotage::Sabotage;
use contact_fuzz::worker::{Share, work};

/// Arbitrary bit patterns through the C interface of the shared library.
#[derive(Parser)]
struct Arguments {
    /// Calls to make
    #[arg(long, default_value_t = 100_000)]
    calls: u64,
    /// Begins the stream of every call
    #[arg(long, default_value_t = 20150)]
    seed: u64,
    /// Only elements whose name contains this text
    #[arg(long, default_value = "")]
    element: String,
    /// Makes one call alone, after its inputs are printed
    #[arg(long)]
    call: Option<u64>,
    /// Makes the call that a file of coverage-guided fuzzing stands for, alone
    #[arg(long, conflicts_with = "call")]
    input: Option<PathBuf>,
    /// Number of processes; 0 means one per processor
    #[arg(long, default_value_t = 0)]
    jobs: u64,
    /// Longest time that a call may take, in seconds
    #[arg(long, default_value_t = 30.0)]
    limit: f64,
    /// Findings that end the run
    #[arg(long, default_value_t = 20)]
    enough: usize,
    /// The shared library; built if not given
    #[arg(long)]
    library: Option<PathBuf>,
    /// A library that is bad on purpose
    #[arg(long, hide = true)]
    sabotage: Option<Sabotage>,
    /// First call, step, end: what a worker does
    #[arg(long, hide = true, num_args = 3)]
    worker: Option<Vec<u64>>,
    /// Where a worker keeps its counters
    #[arg(long, hide = true)]
    ledger: Option<PathBuf>,
    /// A worker prints inputs
    #[arg(long, hide = true)]
    verbose: bool,
}

fn main() -> ExitCode {
    match go(&Arguments::parse()) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("fuzz: {error}");
            ExitCode::from(2)
        }
    }
}

/// True where nothing was found.
fn go(arguments: &Arguments) -> Result<bool, String> {
    let options = options(arguments)?;
    if let (Some(share), Some(ledger)) = (&arguments.worker, &arguments.ledger) {
        let &[first, step, end] = share.as_slice() else {
            return Err("a share has three numbers".to_string());
        };
        let share = Share { first, step, end };
        return work(&options, share, ledger, arguments.verbose).map(|()| true);
    }
    if let Some(call) = arguments.call.or(arguments.input.as_ref().map(|_| 0)) {
        let found = replay(&options, call)?;
        match &found {
            Some(Finding { what, .. }) => println!("found: {what}"),
            None => println!("nothing found"),
        }
        return Ok(found.is_none());
    }
    let summary = run(&options)?;
    println!("{}", summary.text());
    for Finding { call, what } in &summary.findings {
        println!("\nfound: {what}\n  {}", reproduction(arguments, *call));
    }
    Ok(summary.findings.is_empty())
}

/// The command that makes a call again.
fn reproduction(arguments: &Arguments, call: u64) -> String {
    let filter = match arguments.element.as_str() {
        "" => String::new(),
        text => format!(" --element {text}"),
    };
    let seed = arguments.seed;
    format!("cargo run --release -p contact-fuzz --bin fuzz -- --seed {seed} --call {call}{filter}")
}

fn options(arguments: &Arguments) -> Result<Options, String> {
    let program = std::env::current_exe().map_err(|error| error.to_string())?;
    let processors = std::thread::available_parallelism().map_or(1, |count| count.get() as u64);
    let library = match &arguments.library {
        Some(library) => library.clone(),
        None => build(&program)?,
    };
    Ok(Options {
        program,
        library,
        seed: arguments.seed,
        input: arguments.input.clone(),
        calls: arguments.calls,
        element: arguments.element.clone(),
        jobs: if arguments.jobs == 0 {
            processors
        } else {
            arguments.jobs
        },
        limit: Duration::from_secs_f64(arguments.limit),
        enough: arguments.enough,
        sabotage: arguments.sabotage,
        progress: true,
    })
}

/// Builds the shared library, which then stands beside this program.
fn build(program: &std::path::Path) -> Result<PathBuf, String> {
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
    match built {
        Ok(status) if status.success() => {}
        Ok(status) => return Err(format!("the library was not built: {status}")),
        Err(error) => return Err(format!("no cargo: {error}")),
    }
    let folder = program.parent().ok_or("a program without a folder")?;
    Ok(folder.join("libcontact_elements.so"))
}
