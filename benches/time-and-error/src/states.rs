//! Random states of the built-in elements.

use contact_verify::configurations::{Configuration, Generator, Wanted};
use contact_verify::subject::{self, Subject};

use crate::Failure;
use crate::case::{Answer, Case, Request};
use crate::pairs::Law;
use crate::truth::Truth;

/// Seed of all states.
const SEED: u64 = 1;

/// The built-in elements.
pub struct Catalogue(Vec<Subject>);

impl Catalogue {
    /// All of them.
    ///
    /// # Errors
    /// Where the oracle does not know one.
    pub fn new() -> Result<Self, Failure> {
        Ok(Self(subject::built_in().map_err(|name| name.to_string())?))
    }

    /// One of them.
    ///
    /// # Errors
    /// Where there is no such element.
    pub fn get(&self, name: &str) -> Result<&Subject, Failure> {
        let found = self.0.iter().find(|subject| subject.name() == name);
        found.ok_or_else(|| format!("{name} is not a built-in element").into())
    }

    /// States of an element.
    ///
    /// # Errors
    /// No configuration has the requested status.
    pub fn configurations(
        &self,
        name: &str,
        wanted: Wanted,
        count: u64,
    ) -> Result<Vec<Configuration>, Failure> {
        let generator = Generator::new(self.get(name)?.template.clone(), SEED);
        let states = (0..count).map(|index| generator.generate(wanted, index));
        states.map(|state| state.map_err(Into::into)).collect()
    }

    /// The same as cases.
    ///
    /// # Errors
    /// No configuration has the requested status.
    pub fn cases(&self, name: &str, wanted: Wanted, count: u64) -> Result<Vec<Case>, Failure> {
        let subject = self.get(name)?;
        let states = self.configurations(name, wanted, count)?;
        let cases = states.iter().map(|state| Case::new(subject, state));
        cases.map(|case| checked(case, wanted)).collect()
    }
}

/// The case, if the element finds the requested status.
fn checked(case: Case, wanted: Wanted) -> Result<Case, Failure> {
    let mut answer = Answer::of(&case);
    let outcome = case.evaluate(Request::RESIDUAL, &mut answer);
    if outcome.is_ok_and(|summary| (summary.closed > 0) == wanted.is_closed()) {
        Ok(case)
    } else {
        Err(format!("{}: {outcome:?}", case.name()).into())
    }
}

/// A state of one of the pairs that exist by hand too.
#[derive(Clone, Debug)]
pub struct State<const N: usize> {
    /// Positions.
    pub x: [[f64; 3]; N],
    /// Start of the projection.
    pub start: [f64; 2],
    /// Numbers of the law.
    pub law: Law,
    /// Typical length.
    pub size: f64,
    /// The state for the oracle, all displacements zero.
    pub configuration: Configuration,
    /// The state for the generated element.
    pub case: Case,
    /// The same with its projection.
    pub given: Case,
    /// The state for the element linearised on the tangent plane.
    pub tangent_plane: Case,
    /// What is true.
    pub truth: Truth,
}

impl<const N: usize> State<N> {
    /// States of an element and its variant on the tangent plane.
    ///
    /// # Errors
    /// Where an element refuses a state.
    pub fn all(catalogue: &Catalogue, name: &str, count: u64) -> Result<Vec<Self>, Failure> {
        let exact = catalogue.get(name)?;
        let plane = catalogue.get(&format!("{name}TangentPlane"))?;
        let states = catalogue.configurations(name, Wanted::Closed, count)?;
        let one = |state| Self::new(exact, plane, state);
        states.into_iter().map(one).collect()
    }

    fn new(
        exact: &Subject,
        plane: &Subject,
        mut configuration: Configuration,
    ) -> Result<Self, Failure> {
        configuration.reference = configuration.positions();
        configuration.displacement.fill(0.0);
        let case = checked(Case::new(exact, &configuration), Wanted::Closed)?;
        let pair = &configuration.pair;
        let [eps_n, r0] = [case.parameters[0], case.parameters[1]];
        let mut x = [[0.0; 3]; N];
        for (node, values) in x.iter_mut().zip(case.x.chunks(3)) {
            node.copy_from_slice(values);
        }
        Ok(Self {
            x,
            start: configuration.start[0],
            law: Law {
                eps_n,
                r0,
                orientation: pair.orientation,
            },
            size: configuration.size,
            truth: Truth::new(pair, &case.x, &configuration.start)?,
            given: case.projected()?,
            tangent_plane: checked(Case::new(plane, &configuration), Wanted::Closed)?,
            case,
            configuration,
        })
    }
}
