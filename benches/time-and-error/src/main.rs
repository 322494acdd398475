//! `contact-time-and-error`: all benchmarks, as text, CSV, SVG and one page.

use std::path::PathBuf;
use std::process::ExitCode;

use clap::Parser;
use contact_time_and_error::timing::Effort;
use contact_time_and_error::{Failure, SECTIONS, report, skipping};

/// Run time against error of the contact elements, and what skipping work saves.
#[derive(Parser)]
struct Options {
    /// Folder for tables, diagrams and the page.
    #[arg(default_value = "target/benchmarks")]
    folder: PathBuf,
    /// Few rounds and states: seconds, for a look.
    #[arg(long)]
    quick: bool,
    /// Only benchmarks whose name contains the text.
    #[arg(long)]
    only: Option<String>,
    /// Build the C libraries whose sizes are compared.
    #[arg(long)]
    libraries: bool,
    /// Count instructions of the table of skipping by callgrind.
    #[arg(long)]
    instructions: bool,
    /// Evaluate a row of that table once.
    #[arg(long, hide = true)]
    count_row: Option<usize>,
}

fn main() -> ExitCode {
    match run(&Options::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("{failure}");
            ExitCode::FAILURE
        }
    }
}

fn run(options: &Options) -> Result<(), Failure> {
    if let Some(row) = options.count_row {
        return skipping::count_row(row);
    }
    let effort = Effort {
        build: options.libraries,
        instructions: options.instructions,
        ..if options.quick {
            Effort::QUICK
        } else {
            Effort::FULL
        }
    };
    std::fs::create_dir_all(&options.folder)?;
    let mut sections = vec![];
    for (name, make) in SECTIONS {
        if options
            .only
            .as_ref()
            .is_some_and(|only| !name.contains(only))
        {
            continue;
        }
        eprintln!("{name}");
        for section in make(&effort)? {
            println!("\n## {}\n\n{}", section.title, section.table());
            sections.push(section);
        }
    }
    let about = format!(
        "{}. Medians of {} rounds in turns; quartiles in the columns beside them. Only ratios within one run count.",
        processor(),
        effort.rounds
    );
    report::write(&sections, &about, &options.folder)?;
    println!("\n{about}\nWritten to {}", options.folder.display());
    Ok(())
}

/// Name of the processor, where the system tells.
fn processor() -> String {
    let text = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = text.lines().find(|line| line.starts_with("model name"));
    let name = name.and_then(|line| line.split_once(':'));
    name.map_or("unknown processor".into(), |(_, name)| name.trim().into())
}
