//! The small version of `contact-verify projections`.

use super::representatives;
use crate::proof::global::{Extent, Global, prove};
use crate::subject::built_in;

#[test]
fn every_geometry_answers_and_every_answer_is_one() {
    let subjects = built_in().unwrap_or_else(|unknown| panic!("{unknown}"));
    let subjects = representatives(&subjects);
    // 21 of the 27 geometries, since nothing is projected on the others, and 7 pairs of curves
    assert_eq!(subjects.len(), 28);
    let extent = Extent {
        first: 0,
        families: 6,
        family: 8,
        compared: 16,
        seed: 1,
    };
    let mut all = Global::default();
    for subject in subjects {
        let Some(global) = prove(subject, extent) else {
            panic!("{}: nothing projected", subject.name());
        };
        let wrong = &global.finding.failures;
        assert!(wrong.is_empty(), "{}: {wrong:?}", subject.name());
        let warm = &global.warm.iterations;
        assert!(warm.mean() <= 5.0, "{}: {warm:?}", subject.name());
        all = all.merge(global);
    }
    assert!(all.features.iter().all(|&count| count > 0), "{all:?}");
    assert!(all.cold.outcomes[0] > 0 && all.cold.outcomes[1] > 0);
}
