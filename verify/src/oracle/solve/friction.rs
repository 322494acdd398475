//! Friction at a closed contact point ([eq:tangential-residual], [eq:tangential-tangent]).
//!
//! `R_T = T_i dζ^i`, `K_T = dT_i ⊗ dζ^i + T_i d²ζ^i`: `dζ` and `d²ζ` are parts of the hyper-dual
//! projection, `dT_i` the dual part of the traction at the dual projection.

use num_dual::{Dual64, HyperDual64};

use super::point::PointSolution;
use super::report::{FrictionReport, PointReport, PointStatus};
use super::rolling::{self, Moments};
use crate::oracle::error::OracleError;
use crate::oracle::history::{Accepted, FrictionHistory, RollingHistory};
use crate::oracle::kinematics::{Frame, Nodes};
use crate::oracle::pair::{Axis, Tangential};
use crate::oracle::tangential::return_map::{Loading, Regime, traction, utilisation};
use crate::oracle::vector::{constant, cross, dot, scale, sub, unit};

/// Below this fraction of its length a direction has no part in the tangent plane.
const NO_AXIS: f64 = 1e-14;

/// Unit axes of the tangent plane; `None` where the direction of the first one vanishes.
fn axes(
    frame: &Frame<'_>,
    nodes: &Nodes<Dual64>,
    zeta: [Dual64; 2],
    axis: Option<Axis>,
) -> Option<[[Dual64; 3]; 2]> {
    let relative = frame.relative(nodes, zeta);
    let normal = frame.normal(&relative);
    let direction = match axis {
        None => relative.tangents[0],
        Some(Axis::Convected(w)) => {
            [0, 1, 2].map(|c| relative.tangents[0][c] * w[0] + relative.tangents[1][c] * w[1])
        }
        Some(Axis::SlaveCurve) => frame.slave_tangent(&nodes.slave, 0),
    };
    let within = sub(direction, scale(normal, dot(direction, normal)));
    let (whole, part) = (dot(direction, direction).re, dot(within, within).re);
    if part.sqrt() <= NO_AXIS * whole.sqrt() {
        return None;
    }
    let first = unit(within);
    Some([first, cross(normal, first)])
}

/// The loading of a point with its derivative; `None` without axes. `multiplier_slope` is the derivative of the
/// multiplier.
fn loading(
    frame: &Frame<'_>,
    nodes: &Nodes<Dual64>,
    zeta: [Dual64; 2],
    history: &FrictionHistory,
    multiplier_slope: f64,
) -> Option<Loading> {
    let tangential = frame.pair.tangential.as_ref()?;
    let relative = frame.relative(nodes, zeta);
    let mut slip = constant([0.0; 3]);
    for i in 0..frame.parameters {
        let moved = zeta[i] - history.anchor[i];
        for c in 0..3 {
            slip[c] += relative.tangents[i][c] * moved;
        }
    }
    Some(Loading {
        slip,
        axes: axes(frame, nodes, zeta, tangential.axis)?,
        pressure: -(frame.enforced.force(frame.gap(&relative))
            + Dual64::new(0.0, multiplier_slope)),
        path: history.slip,
    })
}

/// The state from which the point continues: the accepted one or, where contact begins, an anchor under the point.
fn remembered(history: Option<&FrictionHistory>, zeta: [f64; 2]) -> FrictionHistory {
    match history {
        Some(history) if history.status != Accepted::Open => *history,
        _ => FrictionHistory {
            status: Accepted::Stick,
            anchor: zeta,
            slip: 0.0,
            rolling: RollingHistory::default(),
        },
    }
}

/// Friction of a closed point, without derivatives. A vanishing axis makes the point degenerate.
pub(super) fn judge(
    frame: &Frame<'_>,
    history: Option<&FrictionHistory>,
    report: &mut PointReport,
) {
    let Some(tangential) = &frame.pair.tangential else {
        return;
    };
    if report.status != PointStatus::Closed {
        return;
    }
    let (nodes, zeta) = (
        Nodes::lifted(&frame.nodes),
        report.zeta.map(Dual64::from_re),
    );
    let accepted = history.filter(|history| history.status != Accepted::Open);
    let history = remembered(history, report.zeta);
    let Some(loading) = loading(frame, &nodes, zeta, &history, 0.0) else {
        report.status = PointStatus::Degenerate;
        return;
    };
    let mut friction = describe(frame, tangential, &loading, &history, report.zeta);
    rolling::judge(frame, accepted, &mut friction, report);
    report.friction = Some(friction);
}

fn describe(
    frame: &Frame<'_>,
    tangential: &Tangential,
    loading: &Loading,
    history: &FrictionHistory,
    zeta: [f64; 2],
) -> FrictionReport {
    let utilisation = utilisation(&tangential.law, loading);
    let (regime, status) = if utilisation > 1.0 {
        (Regime::Slip, Accepted::Slip)
    } else {
        (Regime::Stick, Accepted::Stick)
    };
    let traction = traction(&tangential.law, loading, regime);
    let tangents = frame.relative(&frame.nodes, zeta).tangents;
    let plain = |v: [Dual64; 3]| v.map(|c| c.re);
    let (vector, elastic) = (plain(traction.vector), plain(traction.elastic));
    let axes = loading.axes.map(plain);
    let mut next = FrictionHistory { status, ..*history };
    if regime == Regime::Slip {
        let held = frame.parameters_of(zeta, elastic);
        next.anchor = [0, 1].map(|i| zeta[i] - held[i]);
        let lost = sub(plain(loading.slip), elastic);
        next.slip += dot(lost, lost).sqrt();
    }
    FrictionReport {
        regime,
        utilisation,
        distance: dot(plain(loading.slip), plain(loading.slip)).sqrt(),
        covariant: tangents.map(|b| dot(vector, b)),
        components: axes.map(|axis| dot(vector, axis)),
        axes,
        energy: traction.energy,
        rolling: None,
        history: next,
    }
}

/// The traction of a closed point with its derivatives.
#[derive(Debug)]
pub(super) struct Friction {
    /// T_i.
    covariant: [f64; 2],
    /// dT_i, one entry per unknown.
    gradient: Vec<[f64; 2]>,
    /// The `dζ^i` of the residual, one entry per unknown.
    carrier: Vec<[f64; 2]>,
    /// dT_i by the multiplier.
    by_multiplier: [f64; 2],
    /// Moments about two curves.
    rolling: Option<Moments>,
}

impl Friction {
    /// Zeros for a point without friction.
    pub(super) fn new(
        point: &PointSolution<'_>,
        history: Option<&FrictionHistory>,
    ) -> Result<Option<Self>, OracleError> {
        let (Some(tangential), Some(report)) =
            (&point.frame.pair.tangential, point.report.friction)
        else {
            return Ok(None);
        };
        let unknowns = point.zeta_gradient.len();
        let begins = history.is_none_or(|history| history.status == Accepted::Open);
        let (gradient, by_multiplier) = if begins {
            (vec![[0.0; 2]; unknowns], [0.0; 2]) // the anchor moves with the point
        } else {
            let history = remembered(history, point.root.z);
            gradient(point, tangential, &history, report.regime)
                .zip(by_multiplier(point, tangential, &history, report.regime))
                .ok_or(OracleError::NoProjection)?
        };
        let carrier = if tangential.tangent_plane {
            on_tangent_plane(point)
        } else {
            point.zeta_gradient.clone()
        };
        Ok(Some(Self {
            covariant: report.covariant,
            gradient,
            carrier,
            by_multiplier,
            rolling: Moments::new(point, history),
        }))
    }

    /// `T_i dζ^i + M_c dφ_c` along unknown `i`.
    pub(super) fn first(&self, i: usize) -> f64 {
        let [t, dz] = [self.covariant, self.carrier[i]];
        let rolling = self
            .rolling
            .as_ref()
            .map_or(0.0, |moments| moments.first(i));
        t[0] * dz[0] + t[1] * dz[1] + rolling
    }

    /// `M_c dφ_c` along the first seed of the angles, with its derivative along the second; `slope` is that of
    /// M_c.
    pub(super) fn along_angles(&self, slope: [f64; 2], angles: [HyperDual64; 2]) -> Dual64 {
        let moments = self.rolling.as_ref();
        moments.map_or(Dual64::from_re(0.0), |moments| moments.along(slope, angles))
    }

    /// dM_c along unknown `j`.
    pub(super) fn moment_slope(&self, j: usize) -> [f64; 2] {
        self.rolling
            .as_ref()
            .map_or([0.0; 2], |moments| moments.slope(j))
    }

    /// dM_c along a direction.
    pub(super) fn moment_slope_along(&self, direction: &[f64]) -> [f64; 2] {
        let mut sum = [0.0; 2];
        for (j, d) in direction.iter().enumerate() {
            let slope = self.moment_slope(j);
            sum[0] += slope[0] * d;
            sum[1] += slope[1] * d;
        }
        sum
    }

    /// The exact `T_k dζ^k` along the first seed of `zeta`, with its derivative along the second;
    /// `slope` is that of T_k.
    pub(super) fn along(&self, slope: [f64; 2], zeta: [HyperDual64; 2]) -> Dual64 {
        let term = |k: usize| {
            Dual64::new(self.covariant[k], slope[k]) * Dual64::new(zeta[k].eps1, zeta[k].eps1eps2)
        };
        term(0) + term(1)
    }

    /// dT_k along unknown `j`.
    pub(super) fn slope(&self, j: usize) -> [f64; 2] {
        self.gradient[j]
    }

    /// Derivative of the residual of unknown `i` by the multiplier.
    pub(super) fn coupling(&self, i: usize) -> f64 {
        let [t, dz] = [self.by_multiplier, self.carrier[i]];
        t[0] * dz[0] + t[1] * dz[1]
    }

    /// dT_k along a direction.
    pub(super) fn slope_along(&self, direction: &[f64]) -> [f64; 2] {
        let mut sum = [0.0; 2];
        for (slope, d) in self.gradient.iter().zip(direction) {
            sum[0] += slope[0] * d;
            sum[1] += slope[1] * d;
        }
        sum
    }
}

/// dT_i by one dual sweep per unknown.
fn gradient(
    point: &PointSolution<'_>,
    tangential: &Tangential,
    history: &FrictionHistory,
    regime: Regime,
) -> Option<Vec<[f64; 2]>> {
    let frame = &point.frame;
    let mut nodes = Nodes::<Dual64>::lifted(&frame.nodes);
    let mut along = |(i, dz): (usize, &[f64; 2])| {
        frame.unknown(&mut nodes, i).eps = 1.0;
        let zeta = [0, 1].map(|k| Dual64::new(point.root.z[k], dz[k]));
        let traction = traction(
            &tangential.law,
            &loading(frame, &nodes, zeta, history, 0.0)?,
            regime,
        );
        let tangents = frame.relative(&nodes, zeta).tangents;
        frame.unknown(&mut nodes, i).eps = 0.0;
        Some(tangents.map(|b| dot(traction.vector, b).eps))
    };
    point
        .zeta_gradient
        .iter()
        .enumerate()
        .map(&mut along)
        .collect()
}

/// dT_i by the multiplier, at fixed positions.
fn by_multiplier(
    point: &PointSolution<'_>,
    tangential: &Tangential,
    history: &FrictionHistory,
    regime: Regime,
) -> Option<[f64; 2]> {
    let frame = &point.frame;
    let nodes = Nodes::<Dual64>::lifted(&frame.nodes);
    let zeta = point.root.z.map(Dual64::from_re);
    let loading = loading(frame, &nodes, zeta, history, 1.0)?;
    let traction = traction(&tangential.law, &loading, regime);
    let tangents = frame.relative(&nodes, zeta).tangents;
    Some(tangents.map(|b| dot(traction.vector, b).eps))
}

/// `-a^ij b_j·dr`: `dζ^i` as if the distance were zero.
fn on_tangent_plane(point: &PointSolution<'_>) -> Vec<[f64; 2]> {
    let frame = &point.frame;
    let mut nodes = Nodes::<Dual64>::lifted(&frame.nodes);
    let fixed = point.root.z.map(Dual64::from_re);
    (0..point.zeta_gradient.len())
        .map(|i| {
            frame.unknown(&mut nodes, i).eps = 1.0;
            let moved = frame.relative(&nodes, fixed).position.map(|c| -c.eps);
            frame.unknown(&mut nodes, i).eps = 0.0;
            frame.parameters_of(point.root.z, moved)
        })
        .collect()
}
