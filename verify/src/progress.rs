//! What a run tells while it works: a bar on a terminal, and for every stage a line with its time.

use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;
use serde::Serialize;

/// Without a terminal a stage tells how far it is after this time, and again whenever it has passed.
const SILENCE: Duration = Duration::from_secs(30);

/// Time of one stage.
#[derive(Clone, Debug, Serialize)]
pub struct Stage {
    /// Name.
    pub name: String,
    /// Seconds from its beginning to its end.
    pub seconds: f64,
}

/// The stages of a run.
#[derive(Debug)]
pub struct Progress {
    start: Instant,
    stages: Vec<Stage>,
}

impl Default for Progress {
    fn default() -> Self {
        Self {
            start: Instant::now(),
            stages: vec![],
        }
    }
}

impl Progress {
    /// Does a stage in one piece.
    pub fn stage<T>(&mut self, name: &str, work: impl FnOnce() -> T) -> T {
        let begin = Instant::now();
        let result = work();
        self.finish(name, begin);
        result
    }

    /// Does a stage of many items, several at a time; the results are in the order of the items.
    pub fn each<I: Sync, T: Send>(
        &mut self,
        name: &str,
        items: &[I],
        work: impl Fn(&I) -> T + Sync,
    ) -> Vec<T> {
        let begin = Instant::now();
        let bar = bar(name, items.len() as u64);
        let told = std::sync::Mutex::new(begin);
        let one = |item: &I| {
            let result = work(item);
            bar.inc(1);
            if bar.is_hidden() {
                tell(name, &bar, &told, begin);
            }
            result
        };
        let results = items.par_iter().map(one).collect();
        bar.finish_and_clear();
        self.finish(name, begin);
        results
    }

    /// The stages done so far.
    pub fn stages(&self) -> &[Stage] {
        &self.stages
    }

    fn finish(&mut self, name: &str, begin: Instant) {
        let (seconds, all) = (begin.elapsed().as_secs_f64(), self.start.elapsed());
        eprintln!("[{:>6.1} s] {name}: {seconds:.1} s", all.as_secs_f64());
        self.stages.push(Stage {
            name: name.to_string(),
            seconds,
        });
    }
}

fn bar(name: &str, length: u64) -> ProgressBar {
    let bar = ProgressBar::new(length);
    let template = "{msg:24} {bar:30} {pos}/{len} [{elapsed}, {eta} left]";
    if let Ok(style) = ProgressStyle::with_template(template) {
        bar.set_style(style);
    }
    bar.set_message(name.to_string());
    bar
}

/// Writes a line where nothing was written for a while.
fn tell(name: &str, bar: &ProgressBar, told: &std::sync::Mutex<Instant>, begin: Instant) {
    let Ok(mut told) = told.lock() else {
        return;
    };
    if told.elapsed() >= SILENCE {
        *told = Instant::now();
        let (done, all) = (bar.position(), bar.length().unwrap_or(0));
        eprintln!(
            "{name}: {done} of {all} after {:.0} s",
            begin.elapsed().as_secs_f64()
        );
    }
}
