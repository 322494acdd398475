//! Whether the description of a pair is consistent.

use super::error::OracleError;
use super::geometry::{Interpolation, MAX_NODES};
use super::pair::{
    Angle, Axis, GapKind, IntegrationPoint, Master, Pair, Rolling, Row, Slave, Tangential,
};

impl Pair {
    /// Checks that the description is consistent.
    pub fn validate(&self) -> Result<(), OracleError> {
        let fail = |reason: String| Err(OracleError::Pair(reason));
        if !(2..=3).contains(&self.dimension) {
            return fail(format!("dimension {} is neither 2 nor 3", self.dimension));
        }
        if self.slave_nodes() > MAX_NODES || self.master_nodes() > MAX_NODES {
            return fail(format!("more than {MAX_NODES} nodes on one side"));
        }
        if self.orientation.abs() != 1.0 || !self.r0.is_finite() {
            return fail("orientation must be +1 or -1 and r0 finite".into());
        }
        let codimension = self.dimension as isize - self.parameters() as isize;
        let by_distance = matches!(self.master, Master::Distance { .. });
        if codimension < 1 || (by_distance && self.slave_parameters() > 0) {
            return fail("more projected parameters than the dimension allows".into());
        }
        match self.gap {
            GapKind::Signed if codimension != 1 && !by_distance => {
                return fail("a signed gap needs codimension one".into());
            }
            GapKind::Distance | GapKind::Oriented if by_distance => {
                return fail("a rigid distance has a sign".into());
            }
            _ => {}
        }
        self.law.defect().map_or(Ok(()), fail)?;
        let tangential = self.tangential.as_ref().and_then(|law| law.defect(self));
        tangential.map_or(Ok(()), |defect| fail(defect.into()))?;
        let angle = self.angle.and_then(|angle| angle.defect(self));
        angle.map_or(Ok(()), |defect| fail(defect.into()))?;
        self.placement()
            .defect()
            .map_or(Ok(()), |d| fail(d.into()))?;
        if let Master::Shape(geometry) = &self.master {
            check(geometry)?;
        }
        self.validate_slave()
    }

    fn validate_slave(&self) -> Result<(), OracleError> {
        let fail = |reason: &str| Err(OracleError::Pair(reason.into()));
        match &self.slave {
            Slave::Point => Ok(()),
            Slave::Curve(geometry) => {
                check(geometry)?;
                if geometry.shape.parameters() != 1 {
                    return fail("a slave whose parameter is projected must be a curve");
                }
                Ok(())
            }
            Slave::Fixed {
                geometry, points, ..
            } => {
                check(geometry)?;
                if geometry.shape.parameters() >= self.dimension {
                    return fail("the slave has more parameters than the dimension allows");
                }
                let finite = |p: &IntegrationPoint| {
                    p.weight.is_finite() && p.eta.iter().all(|v| v.is_finite())
                };
                if !points.iter().all(finite) {
                    return fail("integration point not finite");
                }
                Ok(())
            }
            Slave::Rows { rows, positions } => {
                let finite = |r: &Row| {
                    r.weight.is_finite()
                        && r.shape.len() == positions.len()
                        && r.shape.iter().all(|v| v.is_finite())
                };
                if positions.is_empty() || !rows.iter().all(finite) {
                    return fail("rows must be finite and as long as the list of nodes");
                }
                Ok(())
            }
        }
    }
}

fn check(geometry: &Interpolation) -> Result<(), OracleError> {
    if let Some(reason) = geometry.shape.defect() {
        return Err(OracleError::Pair(reason));
    }
    let Some(weights) = &geometry.weights else {
        return Ok(());
    };
    if weights.len() != geometry.shape.nodes() {
        return Err(OracleError::Length {
            what: "weights",
            expected: geometry.shape.nodes(),
            found: weights.len(),
        });
    }
    if weights.iter().all(|w| w.is_finite() && *w > 0.0) {
        Ok(())
    } else {
        Err(OracleError::Pair("weights must be positive".into()))
    }
}

impl Tangential {
    /// Why it does not fit a pair, if it does not.
    pub fn defect(&self, pair: &Pair) -> Option<&'static str> {
        if pair.parameters() == 0 {
            return Some("friction needs a projected parameter");
        }
        if self.law.orthotropic() != self.axis.is_some() {
            return Some("an axis is needed for two stiffnesses, and only for those");
        }
        if self.axis.is_some() && pair.parameters() != 2 {
            return Some("two stiffnesses need two projected parameters");
        }
        match self.axis {
            Some(Axis::Convected(w)) if !w.iter().all(|w| w.is_finite()) || w == [0.0; 2] => {
                return Some("a convected axis must be finite and not zero");
            }
            Some(Axis::SlaveCurve) if !has_slave_curve(pair) => {
                return Some("the axis along the slave needs an integrated curve");
            }
            _ => {}
        }
        if let Some(defect) = self.rolling.as_ref().and_then(|own| own.defect(pair)) {
            return Some(defect);
        }
        self.law.defect()
    }
}

/// Whether the slave is a curve with integration points.
fn has_slave_curve(pair: &Pair) -> bool {
    matches!(&pair.slave, Slave::Fixed { geometry, .. } if geometry.shape.parameters() == 1)
}

impl Rolling {
    /// Why it does not fit a pair, if it does not.
    fn defect(&self, pair: &Pair) -> Option<&'static str> {
        let curves = matches!(
            (&pair.slave, &pair.master),
            (Slave::Curve(_), Master::Shape(_))
        );
        if !curves || pair.gap != GapKind::Distance {
            return Some("rolling needs two curves at a distance");
        }
        if self.law.orthotropic() {
            return Some("an angle has no axes");
        }
        self.law.defect()
    }
}

impl Angle {
    /// What makes the window unusable, if anything.
    fn defect(&self, pair: &Pair) -> Option<&'static str> {
        let [low, high] = self.window;
        if !(0.0 <= low && low < high && high <= std::f64::consts::FRAC_PI_2) {
            return Some("a window of angles lies between 0 and a right angle and has a width");
        }
        let is_curve = match &pair.slave {
            Slave::Curve(_) => true,
            Slave::Fixed { geometry, .. } => geometry.shape.parameters() == 1,
            Slave::Point | Slave::Rows { .. } => false,
        };
        let fits = is_curve && pair.master_parameters() == 1 && pair.dimension == 3;
        (!fits).then_some("an angle needs two curves in space")
    }
}
