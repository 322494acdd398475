//! The programs of an element.

use contact_elements::table::Table;

use super::Subject;

impl Subject {
    /// The element's own programs: without those of its geometries and laws.
    pub fn programs(&self) -> Vec<&'static Table> {
        let own = self.description.programs;
        let mut list = vec![Some(&own.gap)];
        list.extend([
            own.tangent.as_ref(),
            own.measure.as_ref(),
            own.frame.as_ref(),
            own.tangential_residual.as_ref(),
            own.tangential_tangent.as_ref(),
        ]);
        if let Some(rolling) = self.description.rolling {
            let always = [&rolling.angle, &rolling.residual];
            list.extend(always.map(Some));
            list.push(rolling.tangent.as_ref());
        }
        if let Some(angle) = self.description.angle {
            let always = [&angle.position, &angle.weight, &angle.residual];
            list.extend(always.map(Some));
            list.push(angle.tangent.as_ref());
        }
        list.into_iter().flatten().collect()
    }
}
