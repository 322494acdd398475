//! What a sweep is; the families of pairs that most of them take.

use crate::measure::stress::scene::{Load, Scene};

/// One parameter from harmless to extreme.
#[derive(Clone, Copy, Debug)]
pub struct Sweep {
    /// Name of its files.
    pub name: &'static str,
    /// The parameter, for axes and tables.
    pub parameter: &'static str,
    /// From harmless to extreme, spaced evenly on a logarithmic scale.
    pub range: [f64; 2],
    /// Also at zero.
    pub zero: bool,
    /// Elements, and how they are loaded.
    pub series: &'static [Series],
    /// Applies the sweep to a scene that is not yet placed; `None` where the scene has no such extreme.
    pub deform: fn(&mut Scene, f64) -> Option<()>,
}

/// A curve in the diagram of a sweep.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Series {
    /// Name of the element.
    pub element: &'static str,
    /// Load along the tangent plane.
    pub load: Load,
    /// Beyond this value, towards the extreme, the error is measured but not judged: the documented
    /// limit of the method.
    pub limit: Option<f64>,
}

impl Series {
    /// Element and load in words.
    pub fn label(&self) -> String {
        format!("{}{}", self.element, self.load)
    }

    /// Whether a value of the sweep lies beyond the limit.
    pub fn is_beyond(&self, sweep: &Sweep, value: f64) -> bool {
        let [from, to] = sweep.range;
        let beyond = |limit| {
            if from < to {
                value > limit
            } else {
                value < limit
            }
        };
        self.limit.is_some_and(beyond)
    }

    pub(super) const fn up_to(mut self, limit: f64) -> Self {
        self.limit = Some(limit);
        self
    }
}

impl Sweep {
    /// The values of the parameter, `points` of them and zero where it is among them.
    pub fn values(&self, points: usize) -> Vec<f64> {
        let [from, to] = self.range.map(f64::log10);
        let last = points.max(2) - 1;
        let at = |i: usize| {
            let share = i as f64 / last as f64;
            10f64.powf(from + share * (to - from))
        };
        let zero = self.zero.then_some(0.0);
        zero.into_iter().chain((0..=last).map(at)).collect()
    }
}

pub(super) const fn loaded(element: &'static str, load: Load) -> Series {
    Series {
        element,
        load,
        limit: None,
    }
}

pub(super) const fn normal(element: &'static str) -> Series {
    loaded(element, Load::Normal)
}

pub(super) const fn sticks(element: &'static str) -> Series {
    loaded(element, Load::Utilised(0.3))
}

pub(super) const fn slips(element: &'static str) -> Series {
    loaded(element, Load::Utilised(3.0))
}

pub(super) const fn slipped(element: &'static str) -> Series {
    loaded(element, Load::Slipped(0.02))
}

/// One of every kind of pair.
pub(super) const FAMILIES: &[Series] = &[
    normal("PointQuad4"),
    slips("PointQuad4Coulomb"),
    sticks("PointQuad9Coulomb"),
    slips("PointRationalSurface2Coulomb"),
    slips("PointHermiteCoulomb"),
    sticks("HermiteHermiteBeamsCoulomb"),
    slips("HermiteHermiteEdgesCoulomb"),
    slips("HermiteQuad4OrthotropicAtPoint"),
    slips("Quad4Quad4CoulombAtPoint"),
    normal("Quad4Quad4"),
    sticks("PointLine3Coulomb2d"),
    slips("PointCylinderCoulomb"),
    normal("PointSphereDistance"),
    normal("PointPoint"),
];
