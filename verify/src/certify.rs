//! All evidence for a list of elements: the built-in library, or a user's own.

use std::collections::BTreeMap;
use std::ops::Not;

use indicatif::{ProgressBar, ProgressStyle};

use crate::certificate::{Certificate, ElementCertificate};
use crate::configurations::Wanted;
use crate::proof::coverage::{self, Seen};
use crate::proof::{
    edges, global, invariance, mutation, random, reference, sequences, sides, slopes, tables,
};
use crate::subject::Subject;

/// States of global projection per element.
const PROJECTIONS: u64 = 60;

/// How much is tried.
#[derive(Clone, Copy, Debug)]
pub struct Extent {
    /// Random states per element and status.
    pub states: u64,
    /// Seed of the states.
    pub seed: u64,
    /// True for the whole built-in library: reference cases, edge cases and coverage are judged too.
    pub library: bool,
}

/// Proves `subjects`. `sizes` holds the bytes of emitted source by element name, where known.
pub fn certify(
    subjects: &[Subject],
    extent: &Extent,
    sizes: &BTreeMap<String, usize>,
) -> Certificate {
    let bar = ProgressBar::new(subjects.len() as u64);
    let template = "{bar:30} {pos}/{len} {msg} [{elapsed}, {eta} left]";
    if let Ok(style) = ProgressStyle::with_template(template) {
        bar.set_style(style);
    }
    let mut seen = Seen::default();
    let mut elements = Vec::new();
    for subject in subjects {
        bar.set_message(subject.name());
        let size = sizes.get(subject.name()).copied().unwrap_or(0);
        let element = one(subject, extent, size);
        for (_, random) in element.random() {
            seen.statuses.extend(random.statuses.keys());
            seen.features.extend(random.features.keys());
        }
        elements.push(element);
        bar.inc(1);
    }
    bar.finish_and_clear();
    let mut certificate = Certificate {
        version: env!("CARGO_PKG_VERSION"),
        seed: extent.seed,
        states: extent.states,
        elements,
        tables: tables::prove(subjects, extent.seed),
        edges: Default::default(),
        reference: Default::default(),
        reference_cases: vec![],
        coverage: Default::default(),
    };
    if extent.library {
        (certificate.reference, certificate.reference_cases) = reference::prove(subjects);
        certificate.edges = edges::prove(subjects, &mut seen);
        certificate.coverage = coverage::prove(subjects, &mut seen);
    }
    certificate
}

fn one(subject: &Subject, extent: &Extent, source_bytes: usize) -> ElementCertificate {
    let seed = extent.seed;
    let has_friction = subject.template.tangential.is_some();
    let try_status = |wanted| random::prove(subject, wanted, extent.states, seed);
    ElementCertificate {
        name: subject.name().to_string(),
        unknowns: subject.template.unknowns(),
        operations: subject.description.descriptor.operations,
        source_bytes,
        closed: has_friction
            .not()
            .then(|| try_status(Wanted::Closed))
            .flatten(),
        stick: try_status(Wanted::Stick),
        slip: try_status(Wanted::Slip),
        open: try_status(Wanted::Open),
        outside: try_status(Wanted::Outside),
        sequences: has_friction.then(|| sequences::prove(subject, seed)),
        invariance: invariance::prove(subject, seed),
        global: global::prove(
            subject,
            global::Extent {
                first: 0,
                families: PROJECTIONS,
                family: 1,
                compared: 1,
                seed,
            },
        ),
        sides: sides::prove(subject, seed),
        slopes: subject
            .description
            .tangent_plane
            .then(|| slopes::prove(subject, seed, None)),
        mutants: mutation::prove(subject, seed),
    }
}
