//! The part of a patch that belongs to one facet: its parameters and its nodes.

use super::checked::Checked;
use crate::codes::argument;
use crate::descriptor::Descriptor;
use crate::element::gather::Nodes;
use crate::error::Error;
use crate::search::Gathered;

/// Parameters of a facet: the patch's, with the weights of its own nodes.
pub(crate) struct Values {
    list: [f64; Self::MOST],
    count: usize,
}

impl Values {
    const MOST: usize = 64;

    /// The parameters of a facet.
    pub(crate) fn of_facet(checked: &Checked<'_>, facet: usize) -> Self {
        let layout = &checked.facet.layout;
        let mut values = Self {
            list: [0.0; Self::MOST],
            count: checked.facet.parameters.len().min(Self::MOST),
        };
        let own = checked.values.iter().take(layout.master_weights);
        for (to, &value) in values.list.iter_mut().zip(own) {
            *to = value;
        }
        let weights = values.list.iter_mut().skip(layout.master_weights);
        for (to, &node) in weights.zip(checked.of_facet(facet)) {
            *to = checked.weight(node);
        }
        values
    }

    /// Turns the facet's parameters into those of an edge or vertex: its side, and the weights of its own nodes.
    pub(crate) fn make_lower(
        &mut self,
        checked: &Checked<'_>,
        lower: &Descriptor,
        side: f64,
        nodes: impl Iterator<Item = i32>,
    ) {
        let layout = &lower.layout;
        let r0 = checked.values.get(checked.facet.layout.r0);
        if let (Some(to), Some(&r0)) = (self.list.get_mut(layout.r0), r0) {
            *to = r0;
        }
        if let Some(to) = layout.orientation.and_then(|at| self.list.get_mut(at)) {
            *to = side;
        }
        let weights = self.list.iter_mut().skip(layout.master_weights);
        for (to, node) in weights.zip(nodes) {
            *to = checked.weight(node);
        }
        self.count = lower.parameters.len().min(Self::MOST);
    }

    pub(crate) fn slice(&self) -> &[f64] {
        self.list.get(..self.count).unwrap_or(&[])
    }
}

/// A slave point and a facet, for the search.
pub(crate) fn gather<'g>(
    checked: &'g Checked<'_>,
    slave: usize,
    facet: usize,
    values: &'g Values,
) -> Result<Gathered<'g>, Error> {
    let missing = Error::missing(argument::X);
    let list = checked.list(slave, checked.of_facet(facet).iter().copied());
    let count = 1 + checked.facet.master_nodes;
    let nodes = Nodes {
        connectivity: list.get(..count),
        count,
        ..checked.nodes.ok_or(missing)?
    };
    Gathered::new(checked.facet, &nodes, values.slice(), &[])
}
