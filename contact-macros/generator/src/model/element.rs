//! Checks of elements.

use std::rc::Rc;

use super::angle::Others;
use super::entries::Entries;
use super::law_entries::{check_parameters, normal, tangential_law};
use super::pair::{Side, check_pair, master, slave};
use super::registry::Registry;
use super::types::{
    Angle, Axis, Element, Enforcement, Gap, Law, Linearisation, Master, Measure, Reference,
    Rolling, Slave, Tangential, TangentialLaw,
};
use crate::diagnostics::Mistakes;
use crate::syntax::ElementItem;

/// The element an item describes; `None` after a mistake.
pub(super) fn element(
    item: &ElementItem,
    registry: &Registry,
    mistakes: &mut Mistakes,
) -> Option<Element> {
    let before = mistakes.count();
    let entries = Entries::new(item, mistakes);
    let dimension = entries.dimension(mistakes);
    let named = Named::new(&entries, registry, mistakes);
    let pair = match (dimension, &named.slave, &named.master) {
        (Some(dimension), Some(slave), Some(master))
            if check_pair(dimension, slave, master, mistakes) =>
        {
            Some((dimension, &slave.what, &master.what))
        }
        _ => None,
    };
    named.check_parameters(mistakes);
    let chosen = Chosen::new(&entries, &named, pair, mistakes);
    if mistakes.count() > before || !item.complete {
        return None;
    }
    named.with(chosen?, dimension?, item)
}

/// What the entries that name something stand for; `None` after a mistake, and where there is no entry.
struct Named {
    slave: Option<Side<Slave>>,
    master: Option<Side<Master>>,
    law: Option<Side<Rc<Law>>>,
    tangential: Option<Side<Rc<TangentialLaw>>>,
    rolling: Option<Side<Rc<TangentialLaw>>>,
}

impl Named {
    fn new(entries: &Entries<'_>, registry: &Registry, mistakes: &mut Mistakes) -> Self {
        let slave = entries
            .require("slave", "slave: point;", mistakes)
            .and_then(|entry| slave(entry, registry, mistakes));
        let master = entries
            .require("master", "master: Quad4;", mistakes)
            .and_then(|entry| master(entry, registry, mistakes));
        let law = entries
            .require("normal", "normal: Penalty;", mistakes)
            .and_then(|entry| normal(entry, registry, mistakes));
        let mut tangential = |key: &str| {
            let entry = entries.get(key)?;
            tangential_law(entry, key, registry, mistakes)
        };
        Self {
            slave,
            master,
            law,
            tangential: tangential("tangential"),
            rolling: tangential("rolling"),
        }
    }

    fn check_parameters(&self, mistakes: &mut Mistakes) {
        let laws = [self.tangential.as_ref(), self.rolling.as_ref()];
        check_parameters(self.master.as_ref(), self.law.as_ref(), laws, mistakes);
    }

    /// The element with the choices made for it.
    fn with(self, chosen: Chosen, dimension: usize, item: &ElementItem) -> Option<Element> {
        Some(Element {
            name: item.name.clone(),
            docs: item.docs.clone(),
            declaration: item.to_string(),
            dimension,
            slave: self.slave?.what,
            master: self.master?.what,
            law: self.law?.what,
            tangential: self.tangential.map(|law| Tangential {
                law: law.what,
                axis: chosen.axis,
            }),
            enforcement: chosen.enforcement,
            rolling: self.rolling.map(|law| Rolling {
                law: law.what,
                reference: chosen.reference,
            }),
            angle: chosen.angle,
            gap: chosen.gap,
            linearisation: chosen.linearisation,
            measure: chosen.measure,
            residual_only: chosen.residual_only,
            lanes: chosen.lanes,
        })
    }
}

/// The choices of the other entries.
struct Chosen {
    axis: Option<Axis>,
    enforcement: Enforcement,
    gap: Gap,
    linearisation: Linearisation,
    measure: Measure,
    reference: Reference,
    angle: Option<Angle>,
    residual_only: bool,
    lanes: bool,
}

impl Chosen {
    /// Reads every entry before it gives up, so that all mistakes are found; `None` after one.
    fn new(
        entries: &Entries<'_>,
        named: &Named,
        pair: Option<(usize, &Slave, &Master)>,
        mistakes: &mut Mistakes,
    ) -> Option<Self> {
        let rolling = named.rolling.as_ref();
        let axis = entries.axis(named.tangential.as_ref(), pair, mistakes);
        let enforcement = entries.enforcement(named.law.as_ref(), mistakes);
        let gap = entries.gap(pair, mistakes);
        let linearisation = entries.linearisation(named.master.as_ref(), mistakes);
        let measure = entries.measure(named.slave.as_ref(), enforcement, mistakes);
        let reference = entries.reference(rolling, pair, mistakes);
        let linearised = linearisation.as_ref().map(|chosen| chosen.what);
        let choices = (gap, linearised, enforcement);
        entries.check_rolling(rolling, choices, mistakes);
        let others = Others {
            pair,
            law: named.law.as_ref(),
            choices,
            measure,
        };
        let angle = entries.angle(&others, mistakes);
        let residual_only = entries.outputs(linearisation.as_ref(), mistakes);
        let lanes = entries.batch(pair, (gap, enforcement), mistakes);
        Some(Self {
            axis,
            enforcement: enforcement?,
            gap: gap?,
            linearisation: linearised?,
            measure: measure?,
            reference: reference?,
            angle,
            residual_only: residual_only?,
            lanes: lanes?,
        })
    }
}
