//! Moments about the two curves of a closed point ([eq:rolling-residual], [eq:rolling-tangent]).
//!
//! `R_M = M_c dφ_c`, `K_M = dM_c ⊗ dφ_c + M_c d²φ_c`: `dφ` and `d²φ` are parts of the angles over the hyper-dual
//! projection.

use num_dual::{Dual64, HyperDual64};

use super::point::PointSolution;
use super::report::{FrictionReport, PointReport, PointStatus, RollingReport};
use crate::oracle::history::{Accepted, FrictionHistory};
use crate::oracle::kinematics::Frame;
use crate::oracle::pair::Rolling;
use crate::oracle::rolling::{Moment, angles};

fn rolling<'a>(frame: &Frame<'a>) -> Option<&'a Rolling> {
    frame.pair.tangential.as_ref()?.rolling.as_ref()
}

/// Moments of a closed point, without derivatives. A curve without reference direction makes it degenerate.
pub(super) fn judge(
    frame: &Frame<'_>,
    accepted: Option<&FrictionHistory>,
    friction: &mut FrictionReport,
    report: &mut PointReport,
) {
    let Some(rolling) = rolling(frame) else {
        return;
    };
    let found = angles(frame, &frame.nodes, report.zeta, rolling.directors);
    let Some(angle) = found.filter(|angle| angle.iter().all(|angle| angle.is_finite())) else {
        report.status = PointStatus::Degenerate;
        return;
    };
    let pressure = Dual64::from_re(-report.force);
    let moments = [0, 1].map(|c| {
        let from = accepted.map_or((angle[c], 0.0), |h| {
            (h.rolling.anchor[c], h.rolling.path[c])
        });
        rolling.moment(Dual64::from_re(angle[c]), pressure, from, None)
    });
    friction.energy += moments[0].energy + moments[1].energy;
    friction.history.rolling.anchor = moments.map(|moment: Moment| moment.next.0);
    friction.history.rolling.path = moments.map(|moment| moment.next.1);
    friction.rolling = Some(RollingReport {
        angle,
        moment: moments.map(|moment| moment.value.re),
        regime: moments.map(|moment| moment.regime),
        utilisation: moments.map(|moment| moment.utilisation),
        turned: moments.map(|moment| moment.turned),
    });
}

/// The moments of a closed point with their derivatives.
#[derive(Debug)]
pub(super) struct Moments {
    value: [f64; 2],
    /// dM_c, one entry per unknown.
    gradient: Vec<[f64; 2]>,
    /// dφ_c, one entry per unknown.
    angle_gradient: Vec<[f64; 2]>,
}

impl Moments {
    /// Zeros for a point without rolling.
    pub(super) fn new(
        point: &PointSolution<'_>,
        history: Option<&FrictionHistory>,
    ) -> Option<Self> {
        let rolling = rolling(&point.frame)?;
        let report = point.report.friction?.rolling?;
        let accepted = history.filter(|history| history.status != Accepted::Open);
        let law = point.frame.enforced;
        let slope = |i: usize| {
            let Some(history) = accepted else {
                return [0.0; 2]; // the anchor moves with the point
            };
            let gap = Dual64::new(point.report.gap, point.gap_gradient[i]);
            [0, 1].map(|c| {
                let angle = Dual64::new(report.angle[c], point.angle_gradient[i][c]);
                let from = (history.rolling.anchor[c], history.rolling.path[c]);
                let regime = Some(report.regime[c]);
                rolling
                    .moment(angle, -law.force(gap), from, regime)
                    .value
                    .eps
            })
        };
        Some(Self {
            value: report.moment,
            gradient: (0..point.gap_gradient.len()).map(slope).collect(),
            angle_gradient: point.angle_gradient.clone(),
        })
    }

    /// `M_c dφ_c` along unknown `i`.
    pub(super) fn first(&self, i: usize) -> f64 {
        let [m, da] = [self.value, self.angle_gradient[i]];
        m[0] * da[0] + m[1] * da[1]
    }

    /// dM_c along unknown `j`.
    pub(super) fn slope(&self, j: usize) -> [f64; 2] {
        self.gradient[j]
    }

    /// See [`super::friction::Friction::along_angles`].
    pub(super) fn along(&self, slope: [f64; 2], angles: [HyperDual64; 2]) -> Dual64 {
        let term = |c: usize| {
            Dual64::new(self.value[c], slope[c]) * Dual64::new(angles[c].eps1, angles[c].eps1eps2)
        };
        term(0) + term(1)
    }
}
