//! One contact point: projected parameters and gap as hyper-dual numbers.
//!
//! After the projection has converged in doubles, Newton steps with its constant matrix are taken
//! in dual arithmetic. The first carries the first derivatives of the parameters, exactly; they
//! are kept per unknown, so that for a pair of unknowns only the second step, in hyper-dual
//! arithmetic, remains to be done.

use num_dual::{Dual64, HyperDual64};

use super::report::PointReport;
use crate::oracle::angle;
use crate::oracle::kinematics::{Frame, Nodes, Relative};
use crate::oracle::number::Base;
use crate::oracle::projection::Root;
use crate::oracle::rolling::angles;
use crate::oracle::vector::dot;

/// A direction in the space of unknowns.
#[derive(Debug, Clone, Copy)]
pub enum Seed<'s> {
    /// One unknown.
    Unit(usize),
    /// A linear combination, one factor per unknown.
    Along(&'s [f64]),
}

/// Everything at a contact point with derivatives along two seeds: `eps1`, `eps2`, `eps1eps2`.
#[derive(Debug, Clone, Copy)]
pub struct HyperPoint {
    /// Projected parameters, slave's first.
    pub zeta: [HyperDual64; 2],
    /// Relative position and tangents.
    pub relative: Relative<HyperDual64>,
    /// Gap.
    pub gap: HyperDual64,
    /// Factor of the energy by the angle of two curves; one without.
    pub factor: HyperDual64,
    /// Angles about two curves; zero without rolling.
    pub angles: [HyperDual64; 2],
}

/// Node positions in hyper-dual numbers, reused from sweep to sweep.
#[derive(Debug, Clone)]
pub struct Sweep {
    nodes: Nodes<HyperDual64>,
}

/// A projected contact point and its derivatives.
#[derive(Debug, Clone)]
pub struct PointSolution<'a> {
    /// The point's kinematics; use it for normals of a [`HyperPoint`].
    pub frame: Frame<'a>,
    /// The projection.
    pub root: Root,
    /// Status, gap, normal.
    pub report: PointReport,
    /// Gradient of the gap, one entry per unknown.
    pub gap_gradient: Vec<f64>,
    /// Factor of the energy by the angle of two curves; one without.
    pub factor: f64,
    /// Its gradient, one entry per unknown.
    pub factor_gradient: Vec<f64>,
    /// Gradient of the projected parameters, one entry per unknown.
    pub zeta_gradient: Vec<[f64; 2]>,
    /// Gradient of the angles about two curves, one entry per unknown; zero without rolling.
    pub angle_gradient: Vec<[f64; 2]>,
}

/// `z - F⁻¹ f` with the constant matrix of the converged projection.
#[inline]
fn chord<D: Base>(frame: &Frame<'_>, root: &Root, nodes: &Nodes<D>, z: [D; 2]) -> [D; 2] {
    if frame.parameters == 0 {
        return z;
    }
    let relative = frame.relative(nodes, z);
    let f = relative.tangents.map(|b| dot(relative.position, b));
    let m = &root.inverse;
    if frame.parameters == 1 {
        return [z[0] - f[0] * m[0][0], z[1]];
    }
    [
        z[0] - f[0] * m[0][0] - f[1] * m[0][1],
        z[1] - f[0] * m[1][0] - f[1] * m[1][1],
    ]
}

/// Angles about the two curves of a pair with rolling.
#[inline]
fn rolled<D: Base>(frame: &Frame<'_>, nodes: &Nodes<D>, z: [D; 2]) -> Option<[D; 2]>
where
    D::Nested: Base,
{
    let rolling = frame.pair.tangential.as_ref()?.rolling.as_ref()?;
    angles(frame, nodes, z, rolling.directors)
}

impl<'a> PointSolution<'a> {
    /// Completes a converged projection by its first derivatives.
    pub(super) fn new(frame: Frame<'a>, root: Root, report: PointReport) -> Self {
        let unknowns = frame.pair.unknowns();
        let here = frame.relative(&frame.nodes, root.z);
        let mut solution = Self {
            factor: angle::factor(&frame, &frame.nodes, &here),
            factor_gradient: vec![0.0; unknowns],
            frame,
            root,
            report,
            gap_gradient: vec![0.0; unknowns],
            zeta_gradient: vec![[0.0; 2]; unknowns],
            angle_gradient: vec![[0.0; 2]; unknowns],
        };
        let mut nodes = Nodes::<Dual64>::lifted(&solution.frame.nodes);
        for i in 0..unknowns {
            let frame = &solution.frame;
            frame.unknown(&mut nodes, i).eps = 1.0;
            let z = chord(frame, &root, &nodes, root.z.map(Dual64::from_re));
            let relative = frame.relative(&nodes, z);
            let gap = frame.gap(&relative);
            let factor = angle::factor(frame, &nodes, &relative);
            let angles = rolled(frame, &nodes, z);
            frame.unknown(&mut nodes, i).eps = 0.0;
            solution.gap_gradient[i] = gap.eps;
            solution.factor_gradient[i] = factor.eps;
            solution.zeta_gradient[i] = z.map(|z| z.eps);
            if let Some(angles) = angles {
                solution.angle_gradient[i] = angles.map(|angle| angle.eps);
            }
        }
        solution
    }

    /// Working memory for [`Self::hyper`].
    pub fn sweep(&self) -> Sweep {
        Sweep {
            nodes: Nodes::lifted(&self.frame.nodes),
        }
    }

    /// Parameters and gap with derivatives along two seeds.
    #[inline]
    pub fn hyper(&self, sweep: &mut Sweep, first: Seed<'_>, second: Seed<'_>) -> HyperPoint {
        let nodes = &mut sweep.nodes;
        self.plant(nodes, first, |entry, d| entry.eps1 = d);
        self.plant(nodes, second, |entry, d| entry.eps2 = d);
        let (d1, d2) = (self.zeta_along(first), self.zeta_along(second));
        let z = [0, 1].map(|k| HyperDual64::new(self.root.z[k], d1[k], d2[k], 0.0));
        let zeta = chord(&self.frame, &self.root, nodes, z);
        let relative = self.frame.relative(nodes, zeta);
        let gap = self.frame.gap(&relative);
        let factor = angle::factor(&self.frame, nodes, &relative);
        let none = [HyperDual64::from_re(0.0); 2];
        let angles = rolled(&self.frame, nodes, zeta).unwrap_or(none);
        self.clear(nodes, first, |entry| entry.eps1 = 0.0);
        self.clear(nodes, second, |entry| entry.eps2 = 0.0);
        HyperPoint {
            zeta,
            relative,
            gap,
            factor,
            angles,
        }
    }

    /// Hessian of the gap, by rows.
    pub fn gap_hessian(&self) -> Vec<f64> {
        self.hessian_of(|point| point.gap.eps1eps2)
    }

    /// Hessian of projected parameter `k`, by rows.
    pub fn zeta_hessian(&self, k: usize) -> Vec<f64> {
        self.hessian_of(|point| point.zeta[k].eps1eps2)
    }

    /// Hessian of the gap times a direction.
    pub fn gap_hessian_times(&self, direction: &[f64]) -> Vec<f64> {
        let mut sweep = self.sweep();
        let mut product = |i| self.hyper(&mut sweep, Seed::Unit(i), Seed::Along(direction));
        (0..self.gap_gradient.len())
            .map(|i| product(i).gap.eps1eps2)
            .collect()
    }

    /// The symmetric matrix of a second derivative, by rows.
    fn hessian_of(&self, entry: impl Fn(&HyperPoint) -> f64) -> Vec<f64> {
        let unknowns = self.gap_gradient.len();
        let mut sweep = self.sweep();
        let mut matrix = vec![0.0; unknowns * unknowns];
        for i in 0..unknowns {
            for j in i..unknowns {
                let value = entry(&self.hyper(&mut sweep, Seed::Unit(i), Seed::Unit(j)));
                matrix[unknowns * i + j] = value;
                matrix[unknowns * j + i] = value;
            }
        }
        matrix
    }

    #[inline]
    fn plant(
        &self,
        nodes: &mut Nodes<HyperDual64>,
        seed: Seed<'_>,
        mut set: impl FnMut(&mut HyperDual64, f64),
    ) {
        match seed {
            Seed::Unit(i) => set(self.frame.unknown(nodes, i), 1.0),
            Seed::Along(direction) => {
                for (i, &d) in direction.iter().enumerate() {
                    set(self.frame.unknown(nodes, i), d);
                }
            }
        }
    }

    #[inline]
    fn clear(
        &self,
        nodes: &mut Nodes<HyperDual64>,
        seed: Seed<'_>,
        reset: impl Fn(&mut HyperDual64),
    ) {
        self.plant(nodes, seed, |entry, _| reset(entry));
    }

    /// First derivative of the parameters along a seed.
    #[inline]
    fn zeta_along(&self, seed: Seed<'_>) -> [f64; 2] {
        match seed {
            Seed::Unit(i) => self.zeta_gradient[i],
            Seed::Along(direction) => {
                let mut sum = [0.0; 2];
                for (z, d) in self.zeta_gradient.iter().zip(direction) {
                    sum[0] += z[0] * d;
                    sum[1] += z[1] * d;
                }
                sum
            }
        }
    }
}
