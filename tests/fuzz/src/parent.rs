//! Starts workers, and finds out what became of them: a crash, a hang or a broken promise is a finding.

use std::io::{BufRead, BufReader};
use std::os::unix::process::ExitStatusExt;
use std::path::PathBuf;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::Mutex;
use std::sync::atomic::Ordering::Relaxed;
use std::thread;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};
use tempfile::NamedTempFile;

use crate::ledger::Ledger;
use crate::sabotage::Sabotage;
use crate::worker::Share;

/// From look to look.
const PAUSE: Duration = Duration::from_millis(10);

/// What is run.
#[derive(Clone, Debug)]
pub struct Options {
    /// The program that is started as worker.
    pub program: PathBuf,
    /// The shared library.
    pub library: PathBuf,
    /// Begins the stream of every call.
    pub seed: u64,
    /// A file that every call is made of instead.
    pub input: Option<PathBuf>,
    /// Calls.
    pub calls: u64,
    /// What the names of the elements contain.
    pub element: String,
    /// Workers.
    pub jobs: u64,
    /// Longest time that a call may take.
    pub limit: Duration,
    /// Findings that end the run.
    pub enough: usize,
    /// How the library misbehaves.
    pub sabotage: Option<Sabotage>,
    /// Whether a bar is drawn.
    pub progress: bool,
}

/// Something that must not be.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// The call.
    pub call: u64,
    /// What was found.
    pub what: String,
}

/// What a run ended with.
pub struct Summary {
    /// In the order of the calls.
    pub findings: Vec<Finding>,
    /// One per worker.
    pub ledgers: Vec<&'static Ledger>,
    /// Time of the run.
    pub time: Duration,
}

/// Runs all calls.
pub fn run(options: &Options) -> Result<Summary, String> {
    let started = Instant::now();
    let files: Vec<NamedTempFile> = (0..options.jobs)
        .map(|_| ledger_file())
        .collect::<Result<_, _>>()?;
    let ledgers = files
        .iter()
        .map(|file| Ledger::shared(file.as_file()).map_err(|error| error.to_string()))
        .collect::<Result<Vec<_>, _>>()?;
    let findings = Mutex::new(Vec::new());
    let outcome: Result<(), String> = thread::scope(|scope| {
        let mut guards = Vec::new();
        for (number, (file, ledger)) in files.iter().zip(&ledgers).enumerate() {
            let share = Share {
                first: number as u64,
                step: options.jobs,
                end: options.calls,
            };
            let findings = &findings;
            guards.push(scope.spawn(move || guard(options, share, file, ledger, findings)));
        }
        let bar = bar(options);
        while guards.iter().any(|guard| !guard.is_finished()) {
            bar.set_position(
                ledgers
                    .iter()
                    .map(|ledger| ledger.begun.load(Relaxed))
                    .sum(),
            );
            thread::sleep(PAUSE);
        }
        bar.finish_and_clear();
        let join = |guard: thread::ScopedJoinHandle<'_, Result<(), String>>| match guard.join() {
            Ok(outcome) => outcome,
            Err(_) => Err("a guard panicked".to_string()),
        };
        guards.into_iter().try_for_each(join)
    });
    outcome?;
    let mut findings = findings.into_inner().map_err(|error| error.to_string())?;
    findings.sort_by_key(|finding: &Finding| finding.call);
    Ok(Summary {
        findings,
        ledgers,
        time: started.elapsed(),
    })
}

fn ledger_file() -> Result<NamedTempFile, String> {
    let file = NamedTempFile::new().map_err(|error| error.to_string())?;
    let sized = file.as_file().set_len(Ledger::SIZE);
    sized.map_err(|error| error.to_string())?;
    Ok(file)
}

fn bar(options: &Options) -> ProgressBar {
    if !options.progress {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(options.calls);
    let template = "{wide_bar} {human_pos}/{human_len} calls, {per_sec}, {eta} left";
    bar.with_style(ProgressStyle::with_template(template).unwrap_or(ProgressStyle::default_bar()))
}

/// Starts a worker, and a new one behind the call in which it died, until its share is done.
fn guard(
    options: &Options,
    mut share: Share,
    file: &NamedTempFile,
    ledger: &Ledger,
    findings: &Mutex<Vec<Finding>>,
) -> Result<(), String> {
    let add = |call: u64, what: String| {
        let mut list = findings.lock().unwrap_or_else(|error| error.into_inner());
        list.push(Finding { call, what });
        list.len() >= options.enough
    };
    while share.first < share.end {
        ledger.current.store(0, Relaxed);
        let mut child = command(options, share, file)
            .stdout(Stdio::piped())
            .spawn()
            .map_err(|error| format!("{}: {error}", options.program.display()))?;
        let output = child.stdout.take().ok_or("no output")?;
        let (end, full) = thread::scope(|scope| {
            let full = |line: String| {
                let (call, what) = line.split_once('\t').unwrap_or(("0", &line));
                add(call.parse().unwrap_or(0), what.to_string())
            };
            let mut lines = BufReader::new(output).lines().map_while(Result::ok);
            let reader = scope.spawn(move || lines.any(full));
            let end = watch(&mut child, ledger, options.limit, || reader.is_finished());
            (end, reader.join().unwrap_or(true))
        });
        let current = ledger.current.load(Relaxed);
        match end? {
            End::Exit(status) if status.success() => return Ok(()),
            _ if full => return Ok(()),
            End::Exit(status) if status.signal().is_none() => {
                return Err(format!("a worker could not work: {status}"));
            }
            End::Exit(status) => {
                if add(
                    current.saturating_sub(1),
                    format!("the library ended the process: {status}"),
                ) {
                    return Ok(());
                }
            }
            End::Hang => {
                let time = options.limit.as_secs_f64();
                if add(
                    current.saturating_sub(1),
                    format!("no return within {time} s"),
                ) {
                    return Ok(());
                }
            }
        }
        share.first = current.saturating_sub(1) + share.step;
    }
    Ok(())
}

/// How a worker ended.
enum End {
    Exit(ExitStatus),
    Hang,
}

/// Waits for the end, or for a call that does not return. Somebody who no longer listens ends it too.
fn watch(
    child: &mut Child,
    ledger: &Ledger,
    limit: Duration,
    deaf: impl Fn() -> bool,
) -> Result<End, String> {
    let named = |error: std::io::Error| error.to_string();
    let (mut begun, mut since) = (ledger.begun.load(Relaxed), Instant::now());
    loop {
        if let Some(status) = child.try_wait().map_err(named)? {
            return Ok(End::Exit(status));
        }
        let now = ledger.begun.load(Relaxed);
        if now != begun {
            (begun, since) = (now, Instant::now());
        }
        let hangs = since.elapsed() > limit;
        if hangs || deaf() {
            let closed = since.elapsed() < Duration::from_millis(200);
            if !hangs && closed {
                // standard output closes a little before the process ends
                thread::sleep(PAUSE);
                continue;
            }
            child.kill().map_err(named)?;
            child.wait().map_err(named)?;
            return Ok(End::Hang);
        }
        thread::sleep(PAUSE);
    }
}

/// The command of a worker.
pub fn command(options: &Options, share: Share, ledger: &NamedTempFile) -> Command {
    let mut command = Command::new(&options.program);
    command
        .arg("--seed")
        .arg(options.seed.to_string())
        .arg("--library")
        .arg(&options.library)
        .arg("--worker")
        .args([share.first, share.step, share.end].map(|number| number.to_string()))
        .arg("--ledger")
        .arg(ledger.path());
    if !options.element.is_empty() {
        command.arg("--element").arg(&options.element);
    }
    if let Some(input) = &options.input {
        command.arg("--input").arg(input);
    }
    if let Some(sabotage) = options.sabotage {
        use clap::ValueEnum;
        if let Some(value) = sabotage.to_possible_value() {
            command.arg("--sabotage").arg(value.get_name());
        }
    }
    command
}

/// One call, its inputs printed before it is made; what was found.
pub fn replay(options: &Options, call: u64) -> Result<Option<Finding>, String> {
    let file = ledger_file()?;
    let ledger = Ledger::shared(file.as_file()).map_err(|error| error.to_string())?;
    let share = Share {
        first: call,
        step: 1,
        end: call + 1,
    };
    let mut child = command(options, share, &file)
        .arg("--verbose")
        .stdout(Stdio::piped())
        .spawn()
        .map_err(|error| error.to_string())?;
    let output = child.stdout.take().ok_or("no output")?;
    let marker = format!("{call}\t");
    let reader = thread::spawn(move || {
        let mut found = None;
        for line in BufReader::new(output).lines().map_while(Result::ok) {
            match line.strip_prefix(&marker) {
                Some(what) => found = Some(what.to_string()),
                None => println!("{line}"),
            }
        }
        found
    });
    let end = watch(&mut child, ledger, options.limit, || false)?;
    let found = reader.join().map_err(|_| "a reader panicked".to_string())?;
    let what = match end {
        End::Exit(status) if status.success() => found,
        End::Exit(status) => Some(format!("the library ended the process: {status}")),
        End::Hang => Some(format!(
            "no return within {} s",
            options.limit.as_secs_f64()
        )),
    };
    Ok(what.map(|what| Finding { call, what }))
}
