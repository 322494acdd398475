//! Generates everything, proves it, prints the certificate and where the libraries and headers lie.
#![forbid(unsafe_code)]

mod artefacts;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Args, Parser, Subcommand};
use contact_verify::certify::{Extent, certify};
use contact_verify::measure::projections::{self, Length};
use contact_verify::measure::stress;
use contact_verify::pages;
use contact_verify::progress::Progress;
use contact_verify::subject::{self, Subject};

/// Generates the contact elements, builds the C library and proves every element.
#[derive(Parser)]
#[command(version, args_conflicts_with_subcommands = true)]
struct Options {
    #[command(subcommand)]
    command: Option<Command>,
    /// Random states per element and status; the recorded hardest states come on top.
    #[arg(long, default_value_t = 1_000)]
    states: u64,
    /// The long run: 100000 states per element and status.
    #[arg(long)]
    long: bool,
    /// Seed of the random states.
    #[arg(long, default_value_t = 20_150)]
    seed: u64,
    /// Only elements whose name contains this text; the coverage of the whole is then not judged.
    #[arg(long, default_value = "")]
    element: String,
    /// Folder for libraries, headers, generated sources and the certificate.
    #[arg(long, default_value = "target/contact-elements")]
    output: PathBuf,
    /// Write the states with the largest errors to this file, as `verify/data/hardest_states.csv`.
    #[arg(long, value_name = "FILE")]
    hardest: Option<PathBuf>,
    /// Do not build the C library.
    #[arg(long)]
    no_library: bool,
}

#[derive(Subcommand)]
enum Command {
    /// Measures numerical stability: one parameter at a time is driven to its extreme.
    Stress(StressOptions),
    /// Measures iterations and outcomes of projections, globally, from the centre and from a neighbouring state.
    Projections(ProjectionOptions),
}

#[derive(Args)]
struct ProjectionOptions {
    /// Random states per element.
    #[arg(long, default_value_t = 10_000)]
    states: u64,
    /// Seed of the random states.
    #[arg(long, default_value_t = 20_150)]
    seed: u64,
    /// Longest time of one element, in seconds.
    #[arg(long, default_value_t = f64::INFINITY)]
    seconds: f64,
    /// All elements whose name contains this text; otherwise one of each geometry and pair of curves.
    #[arg(long)]
    element: Option<String>,
    /// Folder for `projections.csv`.
    #[arg(long, default_value = "target/contact-elements")]
    output: PathBuf,
}

#[derive(Args)]
struct StressOptions {
    /// Folder for curves, diagrams and `index.html`.
    #[arg(long, default_value = "target/contact-elements/stress")]
    output: PathBuf,
    /// Only elements whose name contains this text.
    #[arg(long, default_value = "")]
    element: String,
    /// Values of the parameter per sweep.
    #[arg(long, default_value_t = 21, value_parser = clap::value_parser!(u16).range(2..))]
    points: u16,
    /// A few values per sweep only: seconds instead of minutes.
    #[arg(long, conflicts_with = "points")]
    quick: bool,
}

fn main() -> ExitCode {
    let options = Options::parse();
    let outcome = match &options.command {
        Some(Command::Stress(stress)) => run_stress(stress),
        Some(Command::Projections(projections)) => run_projections(projections),
        None => run(&options),
    };
    match outcome {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("contact-verify: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(options: &Options) -> Result<bool, Box<dyn std::error::Error>> {
    let mut progress = Progress::default();
    let output = &options.output;
    let sizes = progress.stage("emitted sources", || artefacts::generated_sources(output))?;
    let artefacts = if options.no_library {
        None
    } else {
        Some(progress.stage("C library", || artefacts::c_library(output))?)
    };
    let subjects = subjects(&options.element)?;
    let certificate = certify(
        &mut progress,
        &subjects,
        &Extent {
            states: if options.long {
                100_000
            } else {
                options.states
            },
            seed: options.seed,
            library: options.element.is_empty(),
        },
        &sizes,
    );
    println!("{}", certificate.to_short_text());
    std::fs::create_dir_all(output)?;
    std::fs::write(output.join("certificate.txt"), certificate.to_text())?;
    let json = serde_json::to_string_pretty(&certificate)?;
    std::fs::write(output.join("certificate.json"), json)?;
    if let Some(file) = &options.hardest {
        std::fs::write(file, certificate.hardest().to_csv())?;
    }
    let page = pages::write(&certificate, &artefacts::quotes()?, output)?;
    println!("certificate        {}", page.display());
    if let Some(artefacts) = artefacts {
        print!("{artefacts}");
    }
    Ok(certificate.failed() == 0)
}

fn run_stress(options: &StressOptions) -> Result<bool, Box<dyn std::error::Error>> {
    let subjects = subjects(&options.element)?;
    let extent = if options.quick {
        stress::Extent::QUICK
    } else {
        stress::Extent::of(options.points)
    };
    let report = stress::report::run(&subjects, extent, &options.output)?;
    println!("{report}");
    Ok(report.passed())
}

fn run_projections(options: &ProjectionOptions) -> Result<bool, Box<dyn std::error::Error>> {
    let subjects = subjects(options.element.as_deref().unwrap_or_default())?;
    let chosen = match options.element {
        Some(_) => subjects.iter().collect(),
        None => projections::representatives(&subjects),
    };
    let length = Length {
        states: options.states,
        seconds: options.seconds,
    };
    let failed = projections::run(&chosen, length, options.seed, &options.output)?;
    Ok(failed == 0)
}

/// The built-in elements whose name contains a text.
fn subjects(text: &str) -> Result<Vec<Subject>, Box<dyn std::error::Error>> {
    let mut subjects = subject::built_in().map_err(|unknown| unknown.to_string())?;
    subjects.retain(|subject| subject.name().contains(text));
    if subjects.is_empty() {
        return Err(format!("no element's name contains `{text}`").into());
    }
    Ok(subjects)
}
