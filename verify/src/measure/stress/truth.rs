//! Residual and tangent in octuple precision: slowly, from the definitions.
//!
//! ζ solves `f_i = r·r_,i = 0`; its derivatives follow from those of f. The residual is
//! `N δg + T_i δζ^i`, and each column of the tangent is its derivative in dual numbers.

use contact_elements::runtime::Status;
use num_dual::{Dual, DualNum};
use num_traits::{Signed, Zero};

use super::friction::{is_known, traction};
use super::kinematics::{Kinematics, Point, Twice};
use crate::oracle::history::{Accepted, FrictionHistory};
use crate::oracle::law::Law;
use crate::oracle::multiplier::Multipliers;
use crate::oracle::octuple::Octuple;
use crate::oracle::pair::{GapKind, Measure, Pair, Slave};
use crate::oracle::vector::dot;

/// A state of a pair in octuple precision.
#[derive(Clone, Debug)]
pub struct State<'a> {
    /// The pair.
    pub pair: &'a Pair,
    /// All nodes, slave's first.
    pub nodes: Vec<[Octuple; 3]>,
    /// A start near the projection of every point.
    pub start: &'a [[f64; 2]],
    /// What every point remembers; empty without friction.
    pub friction: &'a [FrictionHistory],
    /// The projected parameters are moved by these shares of themselves, after the projection.
    pub nudge: [f64; 2],
}

/// What is true of a state.
#[derive(Clone, Debug)]
pub struct Truth {
    /// Status of the element.
    pub status: Status,
    /// Residual, slave's nodes first.
    pub residual: Vec<Octuple>,
    /// Tangent by rows.
    pub tangent: Vec<Octuple>,
    /// Projected parameters of every point; NaN for a point without parameters.
    pub zeta: Vec<[f64; 2]>,
    /// How far the worst point is from having no unique projection, see `Foot`.
    pub margin: f64,
}

/// A stationary point of the distance.
#[derive(Clone, Copy, Debug)]
struct Foot {
    z: [Octuple; 2],
    /// det F / det a (F / a), or sin θ between the tangents where that is smaller: elements may refuse an
    /// answer where one of them is below 1e-13.
    margin: f64,
}

/// Whether a pair is one of those known here.
pub fn is_supported(pair: &Pair) -> bool {
    let friction = pair.tangential.as_ref();
    matches!(pair.law, Law::Penalty { .. })
        && pair.multipliers == Multipliers::None
        && pair.angle.is_none()
        && friction
            .is_none_or(|own| is_known(&own.law) && own.rolling.is_none() && !own.tangent_plane)
}

/// Evaluates a state; `None` for a pair that is not [supported](is_supported).
pub fn evaluate(state: &State<'_>) -> Option<Truth> {
    if !is_supported(state.pair) {
        return None;
    }
    let unknowns = state.pair.unknowns();
    let mut truth = Truth {
        status: Status::Open,
        residual: vec![Octuple::zero(); unknowns],
        tangent: vec![Octuple::zero(); unknowns * unknowns],
        zeta: vec![],
        margin: f64::INFINITY,
    };
    for q in 0..state.pair.points() {
        let status = state.add(q, &mut truth)?;
        if status.rank() > truth.status.rank() {
            truth.status = status;
        }
    }
    Some(truth)
}

/// Projected parameters of point `q`, where they are found.
pub fn foot(state: &State<'_>, q: usize) -> Option<[Octuple; 2]> {
    let foot = state.project(&Point::new(state.pair, q), state.start(q))?;
    Some(foot.z)
}

impl State<'_> {
    fn start(&self, q: usize) -> [f64; 2] {
        self.start
            .get(q)
            .or(self.start.first())
            .copied()
            .unwrap_or_default()
    }

    /// Adds point `q`; gives its status.
    fn add(&self, q: usize, truth: &mut Truth) -> Option<Status> {
        let point = Point::new(self.pair, q);
        let Some(mut foot) = self.project(&point, self.start(q)) else {
            truth.margin = 0.0;
            truth.zeta.push([f64::NAN; 2]);
            return Some(Status::NotConverged);
        };
        truth.zeta.push(foot.z.map(Octuple::to_f64));
        truth.margin = truth.margin.min(foot.margin);
        if foot.margin <= 0.0 {
            return Some(Status::NotUnique);
        }
        for i in 0..2 {
            foot.z[i] += foot.z[i] * self.nudge[i];
        }
        let plain = self.force(q, &point, &self.nodes, foot.z)?;
        let z = foot.z.map(Octuple::to_f64);
        if !self.pair.region().contains(z, self.pair.parameters()) {
            return Some(Status::Outside);
        }
        if plain.status == Status::Open {
            return Some(Status::Open);
        }
        let unknowns = truth.residual.len();
        let mut nodes = lifted(&self.nodes);
        for j in 0..unknowns {
            let (node, c) = (j / self.pair.dimension, j % self.pair.dimension);
            truth.residual[j] += plain.residual[j];
            nodes[node][c].eps = Octuple::from(1.0);
            let z = [0, 1].map(|i| Dual::new(foot.z[i], plain.zeta[i][j]));
            let moved = self.force(q, &point, &nodes, z)?;
            for (i, entry) in moved.residual.iter().enumerate() {
                truth.tangent[unknowns * i + j] += entry.eps;
            }
            nodes[node][c].eps = Octuple::zero();
        }
        Some(plain.status)
    }

    /// Newton's method for f = 0, with a for F where F is indefinite and steps halved until r·r falls.
    fn project(&self, point: &Point<'_>, start: [f64; 2]) -> Option<Foot> {
        let p = self.pair.parameters();
        let mut z = start.map(Octuple::from);
        let at = |z| point.at(&self.nodes, z);
        let square = |k: &Kinematics<Octuple>| dot(k.r, k.r);
        let mut here = at(z);
        for _ in 0..STEPS {
            if p == 0 {
                return Some(self.foot(&here, z));
            }
            let (f, metric) = (matrix(&here), metric(&here));
            let inverse = invert(&f, p).or_else(|| invert(&metric, p))?;
            let slope = here.b.map(|b| dot(here.r, b));
            let step = [0, 1].map(|i| -(inverse[i][0] * slope[0] + inverse[i][1] * slope[1]));
            let extent = |i: usize| self.pair.region().extent(i);
            let size = (0..p).fold(Octuple::zero(), |m, i| m.max(step[i].abs() / extent(i)));
            let mut share = if size > 0.5 {
                Octuple::from(0.5) / size
            } else {
                Octuple::from(1.0)
            };
            let moved = |share| [z[0] + step[0] * share, z[1] + step[1] * share];
            let mut next = at(moved(share));
            while size > NEAR && square(&next) > square(&here) && share > 1e-30 {
                share *= 0.5;
                next = at(moved(share));
            }
            z = moved(share);
            here = next;
            if size < SETTLED {
                return Some(self.foot(&here, z));
            }
            if !z.iter().all(|z| z.is_finite() && z.abs() < 1e12) {
                return None;
            }
        }
        None
    }

    /// Judges a stationary point.
    fn foot(&self, k: &Kinematics<Octuple>, z: [Octuple; 2]) -> Foot {
        let p = self.pair.parameters();
        let (f, a) = (matrix(k), metric(k));
        let det = |m: &[[Octuple; 2]; 2]| match p {
            0 => Octuple::from(1.0),
            1 => m[0][0],
            _ => m[0][0] * m[1][1] - m[0][1] * m[1][0],
        };
        let mut margin = (det(&f) / det(&a)).to_f64();
        if f[0][0] <= 0.0 && p > 0 {
            margin = 0.0;
        }
        if p == 2 {
            margin = margin.min((det(&a) / (a[0][0] * a[1][1])).sqrt().to_f64());
        }
        let by_distance = self.pair.gap != GapKind::Signed;
        if by_distance && dot(k.r, k.r).is_zero() {
            margin = 0.0;
        }
        Foot {
            z,
            margin: if margin.is_nan() { 0.0 } else { margin },
        }
    }

    /// Residual of one point at given projected parameters.
    fn force<D: Twice>(
        &self,
        q: usize,
        point: &Point<'_>,
        x: &[[D; 3]],
        z: [D; 2],
    ) -> Option<Force<D>> {
        let Law::Penalty { eps_n } = self.pair.law else {
            return None;
        };
        let k = point.at(x, z);
        let (length, n) = point.distance(&k);
        let gap = length - self.pair.r0;
        let normal = gap * eps_n;
        let zeta = parameter_gradients(&k, self.pair);
        let weight = self.weight(point, x);
        let mut status = if gap.plain() < 0.0 {
            Status::Closed
        } else {
            Status::Open
        };
        let mut pull = [D::zero(); 2];
        if let (Some(law), Status::Closed) = (&self.pair.tangential, status) {
            let remembered = self.friction.get(q)?;
            if remembered.status == Accepted::Open {
                return None;
            }
            let since = [0, 1].map(|i| z[i] - remembered.anchor[i]);
            let slip = [0, 1, 2].map(|c| k.b[0][c] * since[0] + k.b[1][c] * since[1]);
            let found = traction(law, point, x, &k, n, slip, -normal)?;
            status = if found.slips {
                Status::Slip
            } else {
                Status::Stick
            };
            pull = k.b.map(|b| dot(b, found.vector));
        }
        let entry = |j: usize| {
            let (node, c) = (j / self.pair.dimension, j % self.pair.dimension);
            let tangential = zeta[0][j] * pull[0] + zeta[1][j] * pull[1];
            weight * (normal * n[c] * k.row[node] + tangential)
        };
        let residual = (0..self.pair.unknowns()).map(entry).collect();
        Some(Force {
            status,
            residual,
            zeta,
        })
    }

    /// Weight times measure; the measure of the reference configuration is a constant.
    fn weight<D: Twice>(&self, point: &Point<'_>, x: &[[D; 3]]) -> D {
        let weight = D::from(point.weight);
        match self.pair.slave {
            Slave::Fixed {
                measure: Measure::Reference,
                ..
            } => weight * D::constant(point.measure(&self.nodes)),
            Slave::Fixed {
                measure: Measure::Current,
                ..
            } => weight * point.measure(x),
            _ => weight,
        }
    }
}

/// Contribution of one point.
struct Force<D> {
    status: Status,
    residual: Vec<D>,
    /// Derivatives of both projected parameters by the unknowns.
    zeta: [Vec<D>; 2],
}

/// `δζ = −F⁻¹ ∂f/∂x` with `f_i = r·r_,i`.
fn parameter_gradients<D: Twice>(k: &Kinematics<D>, pair: &Pair) -> [Vec<D>; 2] {
    let (p, d) = (pair.parameters(), pair.dimension);
    let mut gradients = [
        vec![D::zero(); pair.unknowns()],
        vec![D::zero(); pair.unknowns()],
    ];
    let Some(inverse) = (p > 0).then(|| invert(&matrix(k), p)).flatten() else {
        return gradients;
    };
    for j in 0..pair.unknowns() {
        let (node, c) = (j / d, j % d);
        let f = |i: usize| k.row[node] * k.b[i][c] + k.slopes[i][node] * k.r[c];
        for i in 0..p {
            gradients[i][j] = -(inverse[i][0] * f(0) + inverse[i][1] * f(1));
        }
    }
    gradients
}

/// `F_ij = a_ij + r·r_,ij`
fn matrix<D: Twice>(k: &Kinematics<D>) -> [[D; 2]; 2] {
    let a = metric(k);
    let bent = k.second.map(|second| dot(k.r, second));
    [
        [a[0][0] + bent[0], a[0][1] + bent[1]],
        [a[1][0] + bent[1], a[1][1] + bent[2]],
    ]
}

/// `a_ij = b_i·b_j`
fn metric<D: Twice>(k: &Kinematics<D>) -> [[D; 2]; 2] {
    [0, 1].map(|i| [0, 1].map(|j| dot(k.b[i], k.b[j])))
}

/// Inverse of a positive definite matrix of order p, padded by zeros.
fn invert<D: Twice>(m: &[[D; 2]; 2], p: usize) -> Option<[[D; 2]; 2]> {
    let zero = D::zero();
    if p == 1 {
        return (m[0][0].plain() > 0.0).then(|| [[m[0][0].recip(), zero], [zero; 2]]);
    }
    let det = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    let definite = m[0][0].plain() > 0.0 && det.plain() > 0.0;
    definite.then(|| {
        let factor = det.recip();
        [
            [m[1][1] * factor, -m[0][1] * factor],
            [-m[1][0] * factor, m[0][0] * factor],
        ]
    })
}

fn lifted(nodes: &[[Octuple; 3]]) -> Vec<[Dual<Octuple>; 3]> {
    nodes.iter().map(|node| node.map(Dual::from_re)).collect()
}

/// Newton's steps at most; the size of steps, in extents, from which on they are not halved; and of the last.
const STEPS: usize = 300;
const NEAR: f64 = 1e-10;
const SETTLED: f64 = 1e-45;

#[cfg(test)]
mod tests;
