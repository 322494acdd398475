//! The result: what was proven of every element, and of all of them together.

mod text;

use contact_elements::ElementDescription;
use contact_elements::table::{GeometryPrograms, MasterDescription, SlaveDescription, Table};
use serde::Serialize;

use crate::progress::Stage;
use crate::proof::Finding;
use crate::proof::global::Global;
use crate::proof::hardest::Hardest;
use crate::proof::invariance::Invariance;
use crate::proof::mutation::Mutants;
use crate::proof::random::{Random, RandomStates};
use crate::proof::reference::CaseResult;
use crate::proof::sequences::Sequences;
use crate::proof::slopes::Slopes;
use crate::proof::statistics::Reached;
use crate::subject::Subject;

/// What was proven of one element.
#[derive(Clone, Debug, Serialize)]
pub struct ElementCertificate {
    /// Name.
    pub name: String,
    /// Unknowns of a call.
    pub unknowns: usize,
    /// Arithmetic operations of the point programs.
    pub operations: usize,
    /// Bytes of the emitted Rust source.
    pub source_bytes: usize,
    /// False for elements that give a residual only.
    pub has_tangent: bool,
    /// Programs of the element, with the operations of each.
    pub programs: Vec<ProgramCost>,
    /// Random states.
    #[serde(flatten)]
    pub random: RandomStates,
    /// Sequences of steps; with friction.
    pub sequences: Option<Sequences>,
    /// Symmetry, balance, motion, units.
    pub invariance: Invariance,
    /// Global projection, where something is projected.
    pub global: Option<Global>,
    /// The side of edges.
    pub sides: Option<Finding>,
    /// Error orders of tangent-plane elements.
    pub slopes: Option<Slopes>,
    /// Mutation of the terms.
    pub mutants: Mutants,
}

/// Operations of one program.
#[derive(Clone, Debug, Serialize)]
pub struct ProgramCost {
    /// Whose program it is: the element, or the name of a geometry or law.
    pub owner: &'static str,
    /// Name of the program.
    pub program: &'static str,
    /// Arithmetic operations of one call.
    pub operations: usize,
}

impl ElementCertificate {
    /// The certificate of an element with its random states; the other kinds of evidence are still missing.
    pub fn new(subject: &Subject, source_bytes: usize, random: RandomStates) -> Self {
        let descriptor = subject.description.descriptor;
        Self {
            name: subject.name().to_string(),
            unknowns: subject.template.unknowns(),
            operations: descriptor.operations,
            source_bytes,
            has_tangent: descriptor.tangent,
            programs: programs(subject),
            random,
            sequences: None,
            invariance: Invariance::default(),
            global: None,
            sides: None,
            slopes: None,
            mutants: Mutants::default(),
        }
    }

    /// What was found beside the random states.
    fn others(&self) -> impl Iterator<Item = &Finding> {
        let slopes = self.slopes.as_ref().map(|slopes| &slopes.finding);
        let sequences = self.sequences.as_ref().map(|s| &s.finding);
        let always = [&self.invariance.finding, &self.mutants.unchanged];
        let global = self.global.as_ref().map(|global| &global.finding);
        let optional = slopes
            .into_iter()
            .chain(sequences)
            .chain(global)
            .chain(&self.sides);
        optional.chain(always)
    }

    /// Failures of all kinds.
    pub fn failed(&self) -> u64 {
        let random: u64 = self.random.iter().map(|(_, r)| r.finding.failed).sum();
        let others: u64 = self.others().map(|finding| finding.failed).sum();
        random + others + self.mutants.survivors.len() as u64
    }

    /// The first failures of every kind in words.
    pub fn failures(&self) -> Vec<String> {
        let mut lines: Vec<String> = self.mutants.survivors.clone();
        for (what, random) in self.random.iter() {
            let failures = random.finding.failures.iter();
            lines.extend(failures.map(|failure| format!("{what}: {failure}")));
        }
        lines.extend(self.others().flat_map(|finding| finding.failures.clone()));
        lines
    }

    /// Random states tried.
    pub fn states(&self) -> u64 {
        self.random.iter().map(|(_, r)| r.finding.tried).sum()
    }

    /// Random states with load, and those built to lie outside, some points of which carry load too.
    fn loaded(&self) -> impl Iterator<Item = (&'static str, &Random)> {
        self.random.iter().filter(|(what, _)| *what != "open")
    }

    /// Largest error of residual, tangent and energy over all states with load.
    pub fn worst(&self) -> (f64, f64, f64) {
        let mut worst = (0.0_f64, 0.0_f64, 0.0_f64);
        for (_, random) in self.loaded() {
            worst.0 = worst.0.max(random.residual.error);
            worst.1 = worst.1.max(random.tangent.error);
            worst.2 = worst.2.max(random.energy.error);
        }
        worst
    }

    /// Largest error of the tangent in words: tangent-plane elements are judged by the order of the error instead.
    pub fn tangent_error(&self) -> String {
        match (&self.slopes, self.has_tangent) {
            (Some(_), _) => "orders".to_string(),
            (None, true) => format!("{:.1e}", self.worst().1),
            (None, false) => "none".to_string(),
        }
    }

    /// Status and number of the state with the largest error of residual or tangent.
    pub fn worst_state(&self) -> String {
        let errors = self
            .loaded()
            .flat_map(|(what, random)| [(what, &random.residual), (what, &random.tangent)]);
        let worst = errors.max_by(|a, b| a.1.error.total_cmp(&b.1.error));
        worst.map_or(String::new(), |(what, worst)| {
            format!("{what} {}", worst.state)
        })
    }
}

/// The whole certificate.
#[derive(Clone, Debug, Serialize)]
pub struct Certificate {
    /// Version of the library.
    pub version: &'static str,
    /// Seed of the states.
    pub seed: u64,
    /// States per element and status.
    pub states: u64,
    /// One entry per element.
    pub elements: Vec<ElementCertificate>,
    /// Tables against emitted code and duals.
    pub tables: Finding,
    /// Edge cases.
    pub edges: Finding,
    /// Reference cases.
    pub reference: Finding,
    /// Reference cases, each.
    pub reference_cases: Vec<CaseResult>,
    /// Statuses, features, return codes.
    pub coverage: Finding,
    /// Time of every stage.
    pub stages: Vec<Stage>,
}

impl Certificate {
    /// Failures of all kinds.
    pub fn failed(&self) -> u64 {
        let elements: u64 = self.elements.iter().map(ElementCertificate::failed).sum();
        let whole = self.whole();
        elements + whole.iter().map(|finding| finding.failed).sum::<u64>()
    }

    /// What was judged for all elements together.
    pub fn whole(&self) -> [&Finding; 4] {
        [&self.tables, &self.edges, &self.reference, &self.coverage]
    }

    /// The states with the largest errors of every element and status.
    pub fn hardest(&self) -> Hardest {
        let mut hardest = Hardest::default();
        for element in &self.elements {
            for (status, random) in element.random.iter() {
                let worst = [
                    &random.residual,
                    &random.tangent,
                    &random.energy,
                    &random.points,
                ];
                for worst in worst.into_iter().filter(|worst| worst.error > 0.0) {
                    hardest.add(&element.name, status, worst.state);
                }
            }
        }
        hardest
    }

    /// Mutants killed and made.
    pub fn mutants(&self) -> (u64, u64) {
        let all = self.elements.iter().map(|element| &element.mutants);
        all.fold((0, 0), |(killed, made), m| {
            (killed + m.killed, made + m.made)
        })
    }

    /// Largest errors of residual and tangent.
    pub fn worst(&self) -> (f64, f64) {
        let all = self.elements.iter().map(ElementCertificate::worst);
        all.fold((0.0, 0.0), |(r, k), worst| (r.max(worst.0), k.max(worst.1)))
    }

    /// The same, with the states after which they were reached, over all elements and statuses.
    pub fn growth(&self) -> Vec<Reached> {
        let all = || {
            self.elements
                .iter()
                .flat_map(|element| element.random.iter())
        };
        let mut growth: Vec<Reached> = vec![];
        for reached in all().flat_map(|(_, random)| &random.growth) {
            match growth
                .iter_mut()
                .find(|known| known.states == reached.states)
            {
                None => growth.push(*reached),
                Some(known) => {
                    known.residual = known.residual.max(reached.residual);
                    known.tangent = known.tangent.max(reached.tangent);
                }
            }
        }
        growth
    }
}

/// The programs of an element, those of its geometries and laws among them.
fn programs(subject: &Subject) -> Vec<ProgramCost> {
    let cost = |owner: &'static str| {
        move |program: &Table| ProgramCost {
            owner,
            program: program.name,
            operations: program.cost,
        }
    };
    let own = subject.programs().into_iter();
    let mut list: Vec<ProgramCost> = own.map(cost("element")).collect();
    let element = subject.description;
    for geometry in geometries(element) {
        let third = geometry
            .third
            .as_ref()
            .filter(|_| element.tangential.is_some());
        let programs = [Some(&geometry.values), third].into_iter().flatten();
        list.extend(programs.map(cost(geometry.name)));
    }
    list.push(cost(element.law.name)(&element.law.law));
    let rolling = element.rolling.map(|rolling| rolling.law);
    for law in element.tangential.into_iter().chain(rolling) {
        let programs = [Some(&law.friction), law.sliding.as_ref()];
        list.extend(programs.into_iter().flatten().map(cost(law.name)));
    }
    list
}

/// The geometries of an element, each once.
fn geometries(element: &'static ElementDescription) -> Vec<&'static GeometryPrograms> {
    let slave = match &element.slave {
        SlaveDescription::Point | SlaveDescription::Interpolated => None,
        SlaveDescription::Projected(geometry)
        | SlaveDescription::Integrated(geometry, _)
        | SlaveDescription::Given(geometry) => Some(*geometry),
    };
    let master = match &element.master {
        MasterDescription::Point => None,
        MasterDescription::Shape(geometry)
        | MasterDescription::Rigid(geometry)
        | MasterDescription::Distance(geometry) => Some(*geometry),
    };
    let is_new =
        |geometry: &&GeometryPrograms| slave.is_none_or(|slave| slave.name != geometry.name);
    slave.into_iter().chain(master.filter(is_new)).collect()
}
