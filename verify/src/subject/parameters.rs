//! The parameter list of an element for the numbers of an oracle's pair.

use contact_elements::table::SlaveDescription;

use super::Subject;
use crate::oracle::geometry::{Placement, RigidDistance, RigidParametric};
use crate::oracle::law::Law;
use crate::oracle::pair::Axis;
use crate::oracle::pair::{Master, Pair, Slave};
use crate::oracle::tangential::TangentialLaw;

impl Subject {
    /// The element's parameter list for a pair's numbers.
    pub fn parameters(&self, pair: &Pair) -> Vec<f64> {
        let mut list = self.parameters_of_law(&pair.law);
        if let Some(tangential) = &pair.tangential {
            let own = &self.tangential_parameters;
            list.extend(parameters_of_tangential(&tangential.law, own));
        }
        let rolling = pair
            .tangential
            .as_ref()
            .and_then(|own| own.rolling.as_ref());
        if let Some(rolling) = rolling {
            let own = &self.rolling_parameters;
            list.extend(parameters_of_tangential(&rolling.law, own));
        }
        list.push(pair.r0);
        if self.description.layout.orientation.is_some() {
            list.push(pair.orientation);
        }
        list.extend(self.parameters_of_rigid(&pair.master));
        if let Master::Shape(geometry) = &pair.master {
            list.extend(geometry.weights.iter().flatten());
        }
        if let Slave::Curve(geometry) | Slave::Fixed { geometry, .. } = &pair.slave {
            list.extend(geometry.weights.iter().flatten());
        }
        if let (
            SlaveDescription::Given(_),
            Slave::Fixed {
                geometry, points, ..
            },
        ) = (&self.description.slave, &pair.slave)
        {
            for point in points {
                list.extend(point.eta.iter().take(geometry.shape.parameters()));
                list.push(point.weight);
            }
        }
        if let Some(Axis::Convected(w)) = pair.tangential.as_ref().and_then(|law| law.axis) {
            list.extend(w);
        }
        let directors = rolling.and_then(|rolling| rolling.directors);
        list.extend(directors.iter().flatten().flatten());
        list.extend(pair.angle.iter().flat_map(|angle| angle.window));
        if self.description.placed {
            list.extend(placement_parameters(&pair.placement(), pair.dimension));
        }
        list
    }

    fn parameters_of_law(&self, law: &Law) -> Vec<f64> {
        match *law {
            Law::Penalty { eps_n } => vec![eps_n],
            Law::Power { eps_n, exponent } => vec![eps_n, exponent],
            Law::Barrier { kappa, distance } => vec![kappa, distance],
            Law::Declared(_) => self.law_parameters.clone(),
        }
    }

    fn parameters_of_rigid(&self, master: &Master) -> Vec<f64> {
        match master {
            Master::Parametric { surface, .. } => match *surface {
                RigidParametric::Cylinder { radius }
                | RigidParametric::Sphere { radius }
                | RigidParametric::Circle { radius } => vec![radius],
                RigidParametric::Cone { alpha } => vec![alpha],
                RigidParametric::Torus { major, minor } => vec![major, minor],
                RigidParametric::Helix {
                    radius,
                    pitch_over_2pi,
                } => vec![radius, pitch_over_2pi],
                RigidParametric::Declared(_) => self.geometry_parameters.clone(),
                RigidParametric::Line | RigidParametric::Plane => vec![],
            },
            Master::Distance { body, .. } => match *body {
                RigidDistance::Circle { radius }
                | RigidDistance::Cylinder { radius }
                | RigidDistance::Sphere { radius } => vec![radius],
                RigidDistance::Cone { alpha } => vec![alpha],
                RigidDistance::Torus { major, minor } => vec![major, minor],
                RigidDistance::Declared(_) => self.geometry_parameters.clone(),
                RigidDistance::Line | RigidDistance::Plane => vec![],
            },
            _ => vec![],
        }
    }

    /// Row and weight of an interpolated slave; empty otherwise.
    pub fn slave_row(&self, pair: &Pair) -> Vec<f64> {
        match (&self.description.slave, &pair.slave) {
            (SlaveDescription::Interpolated, Slave::Rows { rows, .. }) => rows
                .iter()
                .flat_map(|row| row.shape.iter().copied().chain([row.weight]))
                .collect(),
            _ => vec![],
        }
    }
}

/// Parameters of a tangential law; `own`: those of a declared one.
fn parameters_of_tangential(law: &TangentialLaw, own: &[f64]) -> Vec<f64> {
    match *law {
        TangentialLaw::Stick { eps_t } => vec![eps_t],
        TangentialLaw::Coulomb { eps_t, mu } => vec![eps_t, mu],
        TangentialLaw::Adhesive {
            eps_t,
            mu,
            cohesion,
        } => vec![eps_t, mu, cohesion],
        TangentialLaw::StaticKinetic {
            eps_t,
            mu_s,
            mu_k,
            decay,
        } => vec![eps_t, mu_s, mu_k, decay],
        TangentialLaw::Orthotropic { eps_t, mu } => [eps_t, mu].concat(),
        TangentialLaw::Declared(_) => own.to_vec(),
    }
}

fn placement_parameters(placement: &Placement, dimension: usize) -> Vec<f64> {
    match placement {
        Placement::Identity => vec![0.0; if dimension == 3 { 7 } else { 4 }],
        Placement::Spatial { origin, quaternion } => {
            origin.iter().chain(quaternion).copied().collect()
        }
        Placement::Planar { origin, direction } => {
            origin.iter().chain(direction).copied().collect()
        }
    }
}
