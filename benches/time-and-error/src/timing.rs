//! Times of several contenders, taken in turns: load that comes and goes meets all of them.

use std::time::Instant;

/// How much is measured.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// Rounds; in each of them every contender has its turn.
    pub rounds: usize,
    /// Least time of a turn in nanoseconds.
    pub turn: f64,
    /// Random states.
    pub states: u64,
    /// Builds the libraries whose size is compared.
    pub build: bool,
    /// Counts instructions beside the time.
    pub instructions: bool,
}

impl Effort {
    /// Minutes.
    pub const FULL: Self = Self {
        rounds: 41,
        turn: 5e5,
        states: 120,
        build: false,
        instructions: false,
    };
    /// Seconds.
    pub const QUICK: Self = Self {
        rounds: 7,
        turn: 2e5,
        states: 20,
        build: false,
        instructions: false,
    };
}

/// Something whose time is taken.
pub struct Contender<'a> {
    name: String,
    evaluations: usize,
    pass: Box<dyn FnMut() + 'a>,
}

impl<'a> Contender<'a> {
    /// `pass` makes so many evaluations.
    pub fn new(name: impl Into<String>, evaluations: usize, pass: impl FnMut() + 'a) -> Self {
        Self {
            name: name.into(),
            evaluations,
            pass: Box::new(pass),
        }
    }

    /// Nanoseconds of so many passes.
    fn time(&mut self, passes: usize) -> f64 {
        let start = Instant::now();
        for _ in 0..passes {
            (self.pass)();
        }
        start.elapsed().as_secs_f64() * 1e9
    }

    /// One pass.
    pub fn once(&mut self) {
        (self.pass)();
    }

    /// Passes that fill a turn; warms up.
    fn passes(&mut self, turn: f64) -> usize {
        let mut passes = 1;
        while self.time(passes) < turn && passes < 1 << 24 {
            passes *= 2;
        }
        passes
    }
}

/// Median and quartiles.
#[derive(Clone, Copy, Debug)]
pub struct Spread {
    /// Median.
    pub median: f64,
    /// Lower quartile.
    pub low: f64,
    /// Upper quartile.
    pub high: f64,
}

impl Spread {
    /// Spread of a list that is not empty.
    pub fn of(mut values: Vec<f64>) -> Self {
        values.sort_by(f64::total_cmp);
        let at = |share: usize| values[(values.len() - 1) * share / 4];
        Self {
            median: at(2),
            low: at(1),
            high: at(3),
        }
    }
}

/// Times of all contenders.
pub struct Timing {
    names: Vec<String>,
    /// Nanoseconds per evaluation, by contender and round.
    rounds: Vec<Vec<f64>>,
}

impl Timing {
    /// Nanoseconds per evaluation.
    pub fn time(&self, name: &str) -> Spread {
        Spread::of(self.rounds_of(name).to_vec())
    }

    /// Times of one over those of another in the same round.
    pub fn ratio(&self, name: &str, reference: &str) -> Spread {
        let both = self.rounds_of(name).iter().zip(self.rounds_of(reference));
        Spread::of(both.map(|(time, reference)| time / reference).collect())
    }

    /// Least time of one over that of another: what a quiet machine would show, as far as a turn was quiet.
    pub fn ratio_of_least(&self, name: &str, reference: &str) -> f64 {
        let least = |name| {
            self.rounds_of(name)
                .iter()
                .copied()
                .fold(f64::INFINITY, f64::min)
        };
        least(name) / least(reference)
    }

    fn rounds_of(&self, name: &str) -> &[f64] {
        let found = self.names.iter().position(|known| known == name);
        &self.rounds[found.unwrap_or_else(|| panic!("nobody is called {name}"))]
    }
}

/// Times all contenders in turns.
pub fn in_turns(mut contenders: Vec<Contender<'_>>, effort: &Effort) -> Timing {
    let turn = effort.turn;
    let passes: Vec<usize> = contenders.iter_mut().map(|c| c.passes(turn)).collect();
    let mut rounds = vec![vec![]; contenders.len()];
    for _ in 0..effort.rounds {
        for ((contender, passes), rounds) in contenders.iter_mut().zip(&passes).zip(&mut rounds) {
            let evaluations = passes * contender.evaluations;
            rounds.push(contender.time(*passes) / evaluations as f64);
        }
    }
    Timing {
        names: contenders.into_iter().map(|c| c.name).collect(),
        rounds,
    }
}
