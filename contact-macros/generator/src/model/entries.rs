//! The entries of an element, one method each.

use std::rc::Rc;

use proc_macro2::Span;

use super::angle::{Choices, Others, check_angle};
use super::law_entries::{WrittenAxis, check_tangential};
use super::numeric;
use super::pair::{Side, only_gap, plain};
use super::rolling::check_reference;
use super::types::{
    Angle, Axis, Enforcement, Gap, Law, Linearisation, Master, Measure, Reference, Slave,
    TangentialLaw,
};
use crate::diagnostics::{Mistakes, element as messages, names};
use crate::syntax::{self, ElementItem, Word};

/// The entries of an element, in the order of the documentation.
const ENTRIES: [&str; 15] = [
    "dimension",
    "slave",
    "master",
    "normal",
    "tangential",
    "axis",
    "rolling",
    "director",
    "angle",
    "enforcement",
    "gap",
    "linearisation",
    "measure",
    "outputs",
    "batch",
];

/// The entries of an element: known ones only, each once.
pub(super) struct Entries<'a> {
    item: &'a ElementItem,
    entries: Vec<&'a syntax::Entry>,
}

impl<'a> Entries<'a> {
    pub(super) fn new(item: &'a ElementItem, mistakes: &mut Mistakes) -> Self {
        let mut entries: Vec<&syntax::Entry> = Vec::new();
        for entry in &item.entries {
            let key = entry.key.to_string();
            if !ENTRIES.contains(&key.as_str()) {
                let message = names::unknown_entry(&key, "an element", &ENTRIES);
                mistakes.report(entry.key.span(), message);
            } else if entries.iter().any(|other| other.key == entry.key) {
                mistakes.report(entry.key.span(), names::duplicate_entry(&key));
            } else {
                entries.push(entry);
            }
        }
        Entries { item, entries }
    }

    pub(super) fn get(&self, key: &str) -> Option<&'a syntax::Entry> {
        self.entries.iter().find(|entry| entry.key == key).copied()
    }

    /// Whether an entry that is not there is missing rather than misspelt or misread.
    pub(super) fn is_whole(&self) -> bool {
        self.item.complete && self.item.entries.len() == self.entries.len()
    }

    pub(super) fn require(
        &self,
        key: &str,
        example: &str,
        mistakes: &mut Mistakes,
    ) -> Option<&'a syntax::Entry> {
        let entry = self.get(key);
        if entry.is_none() && self.is_whole() {
            let message = names::missing_entry(key, "an element", example);
            mistakes.report(self.item.name.span(), message);
        }
        entry
    }

    /// 2 or 3; `None` after a mistake.
    pub(super) fn dimension(&self, mistakes: &mut Mistakes) -> Option<usize> {
        let Some(entry) = self.get("dimension") else {
            return Some(3);
        };
        plain(entry, mistakes);
        match entry.word {
            Word::Number(dimension @ (2 | 3), _) => Some(dimension),
            _ => {
                mistakes.report(entry.word.span(), messages::wrong_dimension());
                None
            }
        }
    }

    /// One of some words, the first of which is the default; `None` after a mistake.
    pub(super) fn choice<T: Copy, const N: usize>(
        &self,
        key: &str,
        choices: [(&str, T); N],
        mistakes: &mut Mistakes,
    ) -> Option<(T, Option<Span>)> {
        let Some(entry) = self.get(key) else {
            return Some((choices[0].1, None));
        };
        plain(entry, mistakes);
        let text = match &entry.word {
            Word::Name(name) => name.to_string(),
            Word::Number(value, _) => value.to_string(),
        };
        let span = entry.word.span();
        if let Some((_, value)) = choices.iter().find(|(word, _)| *word == text) {
            return Some((*value, Some(span)));
        }
        let words = choices.map(|(word, _)| word);
        mistakes.report(span, messages::unknown_choice(key, &text, &words));
        None
    }

    /// The first axis of a tangential law with two; `None` without such a law, and after a mistake.
    pub(super) fn axis(
        &self,
        law: Option<&Side<Rc<TangentialLaw>>>,
        pair: Option<(usize, &Slave, &Master)>,
        mistakes: &mut Mistakes,
    ) -> Option<Axis> {
        let choices = [("convected", Axis::Convected), ("slave", Axis::Slave)];
        let chosen = self.choice("axis", choices, mistakes);
        let written = self.get("axis").map(|entry| WrittenAxis {
            key: entry.key.span(),
            word: chosen.and_then(|(axis, span)| Some((axis, span?))),
        });
        let whole = self.is_whole();
        if let Some(law) = law {
            check_tangential(law, written.as_ref(), pair, whole, mistakes);
        } else if let Some(written) = &written
            && self.get("tangential").is_none()
            && whole
        {
            mistakes.report(written.key, messages::axis_without_law());
        }
        written?.word.map(|(axis, _)| axis)
    }

    pub(super) fn enforcement(
        &self,
        law: Option<&Side<Rc<Law>>>,
        mistakes: &mut Mistakes,
    ) -> Option<Enforcement> {
        let choices = [
            ("penalty", Enforcement::Penalty),
            ("augmented", Enforcement::Augmented),
            ("multiplier", Enforcement::Multiplier),
        ];
        let (chosen, span) = self.choice("enforcement", choices, mistakes)?;
        if let (Some(span), Some(law), true) = (span, law, chosen != Enforcement::Penalty)
            && !numeric::is_spring(&law.what)
        {
            let message = messages::enforcement_needs_spring(&law.what.name.to_string());
            mistakes.report(span, message);
        }
        Some(chosen)
    }

    /// The directions from which the angles are measured; `None` after a mistake.
    pub(super) fn reference(
        &self,
        law: Option<&Side<Rc<TangentialLaw>>>,
        pair: Option<(usize, &Slave, &Master)>,
        mistakes: &mut Mistakes,
    ) -> Option<Reference> {
        let choices = [
            ("principal_normal", Reference::PrincipalNormal),
            ("given", Reference::Director),
        ];
        let (reference, span) = self.choice("director", choices, mistakes)?;
        match (law, span) {
            (Some(law), _) => check_reference(law, reference, pair, mistakes),
            (None, Some(span)) if self.get("rolling").is_none() && self.is_whole() => {
                mistakes.report(span, messages::director_without_rolling());
            }
            _ => {}
        }
        Some(reference)
    }

    /// The other entries on which a law of rolling depends.
    pub(super) fn check_rolling(
        &self,
        law: Option<&Side<Rc<TangentialLaw>>>,
        (gap, linearisation, enforcement): Choices,
        mistakes: &mut Mistakes,
    ) {
        let Some(law) = law else { return };
        let name = law.what.name.to_string();
        if self.get("tangential").is_none() && self.is_whole() {
            mistakes.report(law.span, messages::rolling_without_friction(&name));
        }
        if gap == Some(Gap::Signed) {
            mistakes.report(law.span, messages::rolling_of_edges(&name));
        }
        if linearisation == Some(Linearisation::TangentPlane) {
            mistakes.report(law.span, messages::rolling_on_tangent_plane(&name));
        }
        if enforcement == Some(Enforcement::Multiplier) {
            mistakes.report(law.span, messages::rolling_with_multiplier(&name));
        }
    }

    /// The angles at which the contact acts; `None` for all angles, and after a mistake.
    pub(super) fn angle(&self, others: &Others<'_>, mistakes: &mut Mistakes) -> Option<Angle> {
        self.get("angle")?;
        let choices = [("large", Angle::Large), ("small", Angle::Small)];
        let (angle, span) = self.choice("angle", choices, mistakes)?;
        let has_friction = ["tangential", "rolling"].map(|key| self.get(key).is_some());
        check_angle(others, has_friction.contains(&true), span?, mistakes);
        Some(angle)
    }

    pub(super) fn gap(
        &self,
        pair: Option<(usize, &Slave, &Master)>,
        mistakes: &mut Mistakes,
    ) -> Option<Gap> {
        let choices = [
            ("distance", Gap::Distance),
            ("signed", Gap::Signed),
            ("oriented", Gap::Oriented),
        ];
        let (chosen, span) = self.choice("gap", choices, mistakes)?;
        // A pair that cannot meet has no gap to speak of.
        let (dimension, slave, master) = pair?;
        match (only_gap(dimension, slave, master), span) {
            (None, Some(span)) if chosen == Gap::Oriented => {
                mistakes.report(span, messages::gap_not_oriented());
                None
            }
            (None, Some(_)) => Some(chosen),
            (None, None) => {
                mistakes.report(self.item.name.span(), messages::gap_missing());
                None
            }
            (Some((Gap::Distance, _)), Some(_)) if chosen == Gap::Oriented => Some(chosen),
            (Some((only, reason)), Some(span)) if only != chosen => {
                let word = |gap| match gap {
                    Gap::Signed => "signed",
                    Gap::Distance => "distance",
                    Gap::Oriented => "oriented",
                };
                let message = messages::gap_not_possible(word(chosen), word(only), reason);
                mistakes.report(span, message);
                None
            }
            (Some((only, _)), _) => Some(only),
        }
    }

    pub(super) fn linearisation(
        &self,
        master: Option<&Side<Master>>,
        mistakes: &mut Mistakes,
    ) -> Option<Side<Linearisation>> {
        let choices = [
            ("exact", Linearisation::Exact),
            ("tangent_plane", Linearisation::TangentPlane),
        ];
        let (what, span) = self.choice("linearisation", choices, mistakes)?;
        let span = span.unwrap_or_else(|| self.item.name.span());
        if what == Linearisation::TangentPlane
            && let Some(master) = master
            && master.what.projected() == 0
        {
            let name = master.what.name();
            mistakes.report(span, messages::tangent_plane_without_projection(&name));
        }
        Some(Side { what, span })
    }

    pub(super) fn measure(
        &self,
        slave: Option<&Side<Slave>>,
        enforcement: Option<Enforcement>,
        mistakes: &mut Mistakes,
    ) -> Option<Measure> {
        let choices = [
            ("reference", Measure::Reference),
            ("current", Measure::Current),
        ];
        let (measure, span) = self.choice("measure", choices, mistakes)?;
        if let (Measure::Current, Some(span), Some(slave)) = (measure, span, slave)
            && !slave.what.has_own_points()
        {
            mistakes.report(span, messages::measure_without_rule());
        }
        if let (Measure::Current, Some(span), Some(Enforcement::Multiplier)) =
            (measure, span, enforcement)
        {
            mistakes.report(span, messages::measure_of_multiplier());
        }
        Some(measure)
    }

    /// Whether a batch is evaluated in lanes; `None` after a mistake.
    pub(super) fn batch(
        &self,
        pair: Option<(usize, &Slave, &Master)>,
        (gap, enforcement): (Option<Gap>, Option<Enforcement>),
        mistakes: &mut Mistakes,
    ) -> Option<bool> {
        let choices = [("single", false), ("lanes", true)];
        let (lanes, span) = self.choice("batch", choices, mistakes)?;
        let is_plain = ["tangential", "rolling", "angle"]
            .iter()
            .all(|key| self.get(key).is_none());
        let is_pair = pair.is_none_or(|(_, slave, master)| {
            // edges take their side from the history
            let is_edge = matches!(slave, Slave::Projected(_)) && gap == Some(Gap::Signed);
            matches!(slave, Slave::Point | Slave::Projected(_))
                && matches!(master, Master::Shape(_))
                && !is_edge
        });
        let is_penalty = enforcement.is_none_or(|own| own == Enforcement::Penalty);
        if let (true, Some(span)) = (lanes, span)
            && !(is_plain && is_pair && is_penalty)
        {
            mistakes.report(span, messages::no_lanes());
        }
        Some(lanes)
    }

    pub(super) fn outputs(
        &self,
        linearisation: Option<&Side<Linearisation>>,
        mistakes: &mut Mistakes,
    ) -> Option<bool> {
        let choices = [("residual_and_tangent", false), ("residual", true)];
        let (residual_only, _) = self.choice("outputs", choices, mistakes)?;
        if let Some(Side {
            what: Linearisation::TangentPlane,
            span,
        }) = linearisation
            && residual_only
        {
            mistakes.report(*span, messages::tangent_plane_of_residual());
        }
        Some(residual_only)
    }
}
