//! All evidence for a list of elements: the built-in library, or a user's own.

use std::collections::BTreeMap;

use crate::certificate::{Certificate, ElementCertificate};
use crate::progress::Progress;
use crate::proof::coverage::{self, Seen};
use crate::proof::hardest::Hardest;
use crate::proof::random::{Choice, RandomStates};
use crate::proof::{
    edges, global, invariance, mutation, random, reference, sequences, sides, slopes, tables,
};
use crate::subject::Subject;

/// States of global projection per element.
const PROJECTIONS: u64 = 60;

/// How much is tried.
#[derive(Clone, Copy, Debug)]
pub struct Extent {
    /// Random states per element and status. The recorded hardest states come on top.
    pub states: u64,
    /// Seed of the states.
    pub seed: u64,
    /// True for the whole built-in library: reference cases, edge cases and coverage are judged too.
    pub library: bool,
}

/// Proves `subjects` and tells its progress. `sizes` holds the bytes of emitted source by element name, where known.
pub fn certify(
    progress: &mut Progress,
    subjects: &[Subject],
    extent: &Extent,
    sizes: &BTreeMap<String, usize>,
) -> Certificate {
    let elements = elements(progress, subjects, extent, sizes);
    let mut seen = Seen::default();
    for (_, random) in elements.iter().flat_map(|element| element.random.iter()) {
        seen.statuses.extend(random.statuses.keys());
        seen.features.extend(random.features.keys());
    }
    let mut certificate = Certificate {
        version: env!("CARGO_PKG_VERSION"),
        seed: extent.seed,
        states: extent.states,
        elements,
        tables: progress.stage("tables", || tables::prove(subjects, extent.seed)),
        edges: Default::default(),
        reference: Default::default(),
        reference_cases: vec![],
        coverage: Default::default(),
        stages: vec![],
    };
    if extent.library {
        (certificate.reference, certificate.reference_cases) =
            progress.stage("reference cases", || reference::prove(subjects));
        certificate.edges = progress.stage("edge cases", || edges::prove(subjects, &mut seen));
        certificate.coverage = progress.stage("coverage", || coverage::prove(subjects, &mut seen));
    }
    certificate.stages = progress.stages().to_vec();
    certificate
}

/// The stages that judge one element after the other.
fn elements(
    progress: &mut Progress,
    subjects: &[Subject],
    extent: &Extent,
    sizes: &BTreeMap<String, usize>,
) -> Vec<ElementCertificate> {
    let seed = extent.seed;
    let hardest = Hardest::of_seed(seed);
    let choice = Choice {
        states: extent.states,
        hardest: &hardest,
        seed,
    };
    let has_friction = |subject: &Subject| subject.template.tangential.is_some();
    let random = progress.each("random states", subjects, |s| random::prove(s, choice));
    let sequences = progress.each("sequences", subjects, |s| {
        has_friction(s).then(|| sequences::prove(s, seed))
    });
    let invariance = progress.each("invariance", subjects, |s| invariance::prove(s, seed));
    let global = progress.each("global projections", subjects, |s| projections(s, seed));
    let sides = progress.each("sides", subjects, |s| sides::prove(s, seed));
    let slopes = progress.each("slopes", subjects, |s| {
        let tangent_plane = s.description.tangent_plane;
        tangent_plane.then(|| slopes::prove(s, seed, None))
    });
    let mutants = progress.each("mutants", subjects, |s| mutation::prove(s, seed));
    let certificate = |(subject, random): (&Subject, RandomStates)| {
        let size = sizes.get(subject.name()).copied().unwrap_or(0);
        ElementCertificate::new(subject, size, random)
    };
    let mut elements: Vec<_> = subjects.iter().zip(random).map(certificate).collect();
    put(&mut elements, sequences, |element, found| {
        element.sequences = found
    });
    put(&mut elements, invariance, |element, found| {
        element.invariance = found
    });
    put(&mut elements, global, |element, found| {
        element.global = found
    });
    put(&mut elements, sides, |element, found| element.sides = found);
    put(&mut elements, slopes, |element, found| {
        element.slopes = found
    });
    put(&mut elements, mutants, |element, found| {
        element.mutants = found
    });
    elements
}

/// Gives every element what a stage found for it.
fn put<T>(
    elements: &mut [ElementCertificate],
    found: Vec<T>,
    set: impl Fn(&mut ElementCertificate, T),
) {
    for (element, found) in elements.iter_mut().zip(found) {
        set(element, found);
    }
}

fn projections(subject: &Subject, seed: u64) -> Option<global::Global> {
    let extent = global::Extent {
        first: 0,
        families: PROJECTIONS,
        family: 1,
        compared: 1,
        seed,
    };
    global::prove(subject, extent)
}
