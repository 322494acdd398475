//! Sums over the contact points of a pair.

use num_dual::{Dual64, HyperDual64};

use super::couplings;
use super::friction::Friction;
use super::locate::locate;
use super::point::{HyperPoint, PointSolution, Seed, Sweep};
use super::report::{Evaluation, PointReport, PointStatus};
use super::state::{State, validate};
use crate::oracle::angle;
use crate::oracle::error::OracleError;
use crate::oracle::history::FrictionHistory;
use crate::oracle::kinematics::{Frame, Nodes};
use crate::oracle::multiplier::Enforced;
use crate::oracle::pair::{Measure, Pair, Slave};

/// What is computed in addition to the residual.
enum Wanted<'s> {
    Residual,
    Tangent,
    Products(&'s [Vec<f64>]),
}

/// Residual and full tangent.
pub fn evaluate(pair: &Pair, state: &State<'_>) -> Result<Evaluation, OracleError> {
    accumulate(pair, state, &Wanted::Tangent)
}

/// Residual only; the tangent stays empty.
pub fn residual(pair: &Pair, state: &State<'_>) -> Result<Evaluation, OracleError> {
    accumulate(pair, state, &Wanted::Residual)
}

/// Residual and the tangent times each of `directions`.
pub fn tangent_times(
    pair: &Pair,
    state: &State<'_>,
    directions: &[Vec<f64>],
) -> Result<Evaluation, OracleError> {
    for direction in directions {
        if direction.len() != pair.unknowns() {
            let (expected, found) = (pair.unknowns(), direction.len());
            return Err(OracleError::Length {
                what: "direction",
                expected,
                found,
            });
        }
    }
    accumulate(pair, state, &Wanted::Products(directions))
}

/// Total energy `Σ w J W(g)`, plus the energy of the tangential springs; NaN if the law has no energy.
pub fn energy(pair: &Pair, state: &State<'_>) -> Result<f64, OracleError> {
    validate(pair, state)?;
    let mut total = 0.0;
    for q in 0..pair.points() {
        let (frame, _, report) = locate(pair, state, q)?;
        total += energy_of(&frame, &report);
    }
    Ok(total)
}

/// The contact points alone.
pub fn reports(pair: &Pair, state: &State<'_>) -> Result<Vec<PointReport>, OracleError> {
    validate(pair, state)?;
    (0..pair.points())
        .map(|q| locate(pair, state, q).map(|(_, _, report)| report))
        .collect()
}

fn energy_of(frame: &Frame<'_>, report: &PointReport) -> f64 {
    if frame.pair.multipliers.are_unknown() {
        let held = report.friction.map_or(0.0, |friction| friction.energy);
        return frame.weight * (couplings::potential(frame, report) + held);
    }
    if report.status != PointStatus::Closed {
        return 0.0;
    }
    let energy = frame.enforced.energy(HyperDual64::from_re(report.gap));
    let measure: f64 = if moves(frame.pair) {
        frame.measure(&frame.nodes.slave)
    } else {
        1.0
    };
    let held = report.friction.map_or(0.0, |friction| friction.energy);
    let here = frame.relative(&frame.nodes, report.zeta);
    let factor = angle::factor(frame, &frame.nodes, &here);
    frame.weight * measure * (factor * energy.map_or(f64::NAN, |energy| energy.re) + held)
}

/// Whether the measure depends on the unknowns.
fn moves(pair: &Pair) -> bool {
    matches!(
        pair.slave,
        Slave::Fixed {
            measure: Measure::Current,
            ..
        }
    )
}

fn accumulate(
    pair: &Pair,
    state: &State<'_>,
    wanted: &Wanted<'_>,
) -> Result<Evaluation, OracleError> {
    validate(pair, state)?;
    let unknowns = pair.unknowns();
    let mut out = Evaluation {
        residual: vec![0.0; unknowns],
        couplings: couplings::empty(pair),
        ..Evaluation::default()
    };
    match wanted {
        Wanted::Residual => {}
        Wanted::Tangent => out.tangent = vec![0.0; unknowns * unknowns],
        Wanted::Products(directions) => out.products = vec![vec![0.0; unknowns]; directions.len()],
    }
    for q in 0..pair.points() {
        let (frame, root, mut report) = locate(pair, state, q)?;
        let energy = energy_of(&frame, &report);
        out.energy += energy;
        out.energy_size += energy.abs() + couplings::energy_size(&frame, &report);
        if let (PointStatus::Closed, Some(root)) = (report.status, root) {
            let point = PointSolution::new(frame, root, report);
            let contribution = Contribution::new(point, state.friction.get(q))?;
            report.weight = contribution.weight * contribution.measure;
            contribution.add(wanted, &mut out);
            let Contribution {
                point, friction, ..
            } = &contribution;
            couplings::closed(point, friction.as_ref(), q, &mut out.couplings);
        } else {
            couplings::open(&frame, &report, q, &mut out.couplings);
        }
        out.points.push(report);
    }
    Ok(out)
}

/// A closed contact point about to be added.
struct Contribution<'a> {
    point: PointSolution<'a>,
    law: Enforced<'a>,
    weight: f64,
    /// J (one unless the measure moves) and its gradient.
    measure: f64,
    measure_gradient: Vec<f64>,
    /// Whether the normal part is the derivative of an energy.
    from_energy: bool,
    friction: Option<Friction>,
}

impl<'a> Contribution<'a> {
    fn new(
        point: PointSolution<'a>,
        history: Option<&FrictionHistory>,
    ) -> Result<Self, OracleError> {
        let pair = point.frame.pair;
        let law = point.frame.enforced;
        let has_energy = law.energy(HyperDual64::from_re(point.report.gap)).is_some();
        let (measure, measure_gradient) = moving_measure(&point.frame);
        let from_energy = has_energy && !moves(pair);
        Ok(Self {
            law,
            weight: point.frame.weight,
            measure,
            measure_gradient,
            from_energy,
            friction: Friction::new(&point, history)?,
            point,
        })
    }

    fn add(&self, wanted: &Wanted<'_>, out: &mut Evaluation) {
        let unknowns = out.residual.len();
        let gap = self.point.report.gap;
        let force = self.point.factor * self.law.force(Dual64::from_re(gap)).re;
        let energy = self.law.energy(HyperDual64::from_re(gap));
        let energy = energy.map_or(0.0, |energy| energy.re);
        let normal = out.residual.iter_mut().zip(&self.point.gap_gradient);
        for (i, (entry, slope)) in normal.enumerate() {
            let tangential = self.friction.as_ref().map_or(0.0, |f| f.first(i));
            let turned = energy * self.point.factor_gradient[i];
            *entry += self.weight * self.measure * (force * slope + turned + tangential);
        }
        match wanted {
            Wanted::Residual => {}
            Wanted::Tangent => self.add_tangent(unknowns, &mut out.tangent),
            Wanted::Products(directions) => {
                for (direction, product) in directions.iter().zip(&mut out.products) {
                    self.add_product(direction, product);
                }
            }
        }
    }

    fn add_tangent(&self, unknowns: usize, tangent: &mut [f64]) {
        let mut sweep = self.point.sweep();
        for i in 0..unknowns {
            for j in i..unknowns {
                let jet = self.jet(&mut sweep, Seed::Unit(i), Seed::Unit(j));
                tangent[unknowns * i + j] += self.second(&jet, &Slopes::unknown(self, j));
                if i != j {
                    let swapped = self.second(&jet.swapped(), &Slopes::unknown(self, i));
                    tangent[unknowns * j + i] += swapped;
                }
            }
        }
    }

    fn add_product(&self, direction: &[f64], product: &mut [f64]) {
        let mut sweep = self.point.sweep();
        let slopes = Slopes::direction(self, direction);
        for (i, entry) in product.iter_mut().enumerate() {
            let jet = self.jet(&mut sweep, Seed::Unit(i), Seed::Along(direction));
            *entry += self.second(&jet, &slopes);
        }
    }

    #[inline]
    fn jet(&self, sweep: &mut Sweep, first: Seed<'_>, second: Seed<'_>) -> Jet {
        let HyperPoint {
            gap,
            factor,
            zeta,
            angles,
            ..
        } = self.point.hyper(sweep, first, second);
        Jet {
            gap,
            factor,
            zeta,
            angles,
        }
    }

    /// Derivative along the second seed of the residual along the first; `slopes` are derivatives
    /// along the second.
    #[inline]
    fn second(&self, jet: &Jet, slopes: &Slopes) -> f64 {
        let normal = self.normal(jet, slopes.measure);
        self.friction.as_ref().map_or(normal, |friction| {
            let along = friction.along(slopes.traction, jet.zeta)
                + friction.along_angles(slopes.moment, jet.angles);
            normal + self.weight * (along * Dual64::new(self.measure, slopes.measure)).eps
        })
    }

    #[inline]
    fn normal(&self, jet: &Jet, slope: f64) -> f64 {
        let gap = jet.gap;
        if self.from_energy {
            let energy = self.law.energy(gap);
            return self.weight * energy.map_or(f64::NAN, |energy| (energy * jet.factor).eps1eps2);
        }
        let force = self.law.force(Dual64::new(gap.re, gap.eps2));
        let along = Dual64::new(gap.eps1, gap.eps1eps2);
        self.weight * (force * along * Dual64::new(self.measure, slope)).eps
    }
}

/// Gap, factor of the energy, projected parameters and angles about two curves with derivatives along two seeds.
struct Jet {
    gap: HyperDual64,
    factor: HyperDual64,
    zeta: [HyperDual64; 2],
    angles: [HyperDual64; 2],
}

impl Jet {
    /// The seeds in the other order.
    fn swapped(&self) -> Self {
        let swap = |d: HyperDual64| HyperDual64::new(d.re, d.eps2, d.eps1, d.eps1eps2);
        Self {
            gap: swap(self.gap),
            factor: swap(self.factor),
            zeta: self.zeta.map(swap),
            angles: self.angles.map(swap),
        }
    }
}

/// Derivatives along the second of two seeds: of the measure, of T_i and of M_c.
struct Slopes {
    measure: f64,
    traction: [f64; 2],
    moment: [f64; 2],
}

impl Slopes {
    fn unknown(of: &Contribution<'_>, j: usize) -> Self {
        Self {
            measure: of.measure_gradient[j],
            traction: of.friction.as_ref().map_or([0.0; 2], |f| f.slope(j)),
            moment: of.friction.as_ref().map_or([0.0; 2], |f| f.moment_slope(j)),
        }
    }

    fn direction(of: &Contribution<'_>, direction: &[f64]) -> Self {
        let slopes = of.measure_gradient.iter().zip(direction);
        let friction = of.friction.as_ref();
        Self {
            measure: slopes.map(|(j, d)| j * d).sum(),
            traction: friction.map_or([0.0; 2], |f| f.slope_along(direction)),
            moment: friction.map_or([0.0; 2], |f| f.moment_slope_along(direction)),
        }
    }
}

/// J and its gradient where the measure moves, else one and zero.
fn moving_measure(frame: &Frame<'_>) -> (f64, Vec<f64>) {
    let mut gradient = vec![0.0; frame.pair.unknowns()];
    if !moves(frame.pair) {
        return (1.0, gradient);
    }
    let mut nodes = Nodes::<Dual64>::lifted(&frame.nodes);
    for i in 0..frame.pair.dimension * frame.pair.slave_nodes() {
        frame.unknown(&mut nodes, i).eps = 1.0;
        gradient[i] = frame.measure(&nodes.slave).eps;
        frame.unknown(&mut nodes, i).eps = 0.0;
    }
    (frame.measure(&frame.nodes.slave), gradient)
}
