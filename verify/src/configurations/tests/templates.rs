//! One pair of every kind.

use std::sync::Arc;

use num_dual::DualNum;

use crate::oracle::geometry::{Interpolation, Placement, RigidDistance, RigidParametric, Shape};
use crate::oracle::law::{Activity, DeclaredLaw, Law};
use crate::oracle::multiplier::Multipliers;
use crate::oracle::pair::{Axis, Tangential};
use crate::oracle::pair::{GapKind, IntegrationPoint, Master, Measure, Pair, Row, Slave};
use crate::oracle::tangential::{DeclaredTangential, TangentialLaw};

const SPATIAL: Placement = Placement::Spatial {
    origin: [0.0; 3],
    quaternion: [1.0, 0.0, 0.0, 0.0],
};
const PLANAR: Placement = Placement::Planar {
    origin: [0.0; 2],
    direction: [1.0, 0.0],
};

fn shape(shape: Shape) -> Master {
    Master::Shape(Interpolation::new(shape))
}

fn rational(shape: Shape) -> Interpolation {
    let weights = vec![1.0; shape.nodes()];
    Interpolation::rational(shape, weights)
}

fn fixed(shape: Shape, points: &[[f64; 2]], measure: Measure) -> Slave {
    let points = points
        .iter()
        .map(|&eta| IntegrationPoint { eta, weight: 0.75 })
        .collect();
    Slave::Fixed {
        geometry: Interpolation::new(shape),
        points,
        measure,
    }
}

fn pair(dimension: usize, slave: Slave, master: Master, gap: GapKind) -> Pair {
    let law = Law::Penalty { eps_n: 100.0 };
    Pair {
        dimension,
        slave,
        master,
        gap,
        orientation: 1.0,
        r0: 0.0,
        law,
        tangential: None,
        angle: None,
        multipliers: Multipliers::None,
    }
}

/// A named pair.
type Named = (&'static str, Pair);

/// One pair of every kind.
pub(crate) fn templates() -> Vec<Named> {
    let mut list = point_pairs();
    list.extend(curve_pairs());
    list.extend(integrated_pairs());
    list.extend(rigid_pairs());
    list.extend(law_pairs());
    list.extend(frictional());
    list
}

/// Pairs with friction: one of every law, axis and kind of geometry.
pub(crate) fn frictional() -> Vec<Named> {
    let mut list = isotropic();
    list.extend(orthotropic());
    list
}

fn with(tangential: &Tangential, pair: &Pair) -> Pair {
    Pair {
        tangential: Some(tangential.clone()),
        ..pair.clone()
    }
}

fn onto(master: Master) -> Pair {
    pair(3, Slave::Point, master, GapKind::Signed)
}

fn torus() -> Pair {
    let (major, minor) = (2.0, 0.5);
    onto(Master::Parametric {
        surface: RigidParametric::Torus { major, minor },
        placement: SPATIAL,
    })
}

fn beams() -> Pair {
    let master = shape(Shape::Hermite);
    pair(3, curve(Shape::Line3), master, GapKind::Distance)
}

fn rope(master: Shape, measure: Measure) -> Pair {
    let slave = fixed(Shape::Hermite, &LENGTH, measure);
    pair(3, slave, shape(master), GapKind::Signed)
}

fn isotropic() -> Vec<Named> {
    use GapKind::{Distance, Signed};
    let (eps_t, mu, cohesion) = (100.0, 0.3, 1.0);
    let (mu_s, mu_k, decay) = (0.5, 0.3, 0.1);
    let coulomb = Tangential::isotropic(TangentialLaw::Coulomb { eps_t, mu });
    let adhesive = Tangential::isotropic(TangentialLaw::Adhesive {
        eps_t,
        mu,
        cohesion,
    });
    let weakening = Tangential::isotropic(TangentialLaw::StaticKinetic {
        eps_t,
        mu_s,
        mu_k,
        decay,
    });
    let tied = Tangential::isotropic(TangentialLaw::Stick { eps_t });
    let declared = Tangential::isotropic(TangentialLaw::Declared(Arc::new(Hardening)));
    let flat = pair(2, Slave::Point, shape(Shape::Line3), Signed);
    let beam = pair(3, Slave::Point, shape(Shape::Hermite), Distance);
    let facet = onto(shape(Shape::Quad4));
    let patch = onto(shape(Shape::Tri6));
    let edges = pair(3, curve(Shape::Line3), shape(Shape::Line3), Signed);
    let rope = rope(Shape::Quad9, Measure::Reference);
    vec![
        ("line3-2d-coulomb", with(&coulomb, &flat)),
        ("line3-2d-weakening", with(&weakening, &flat)),
        ("hermite-coulomb", with(&coulomb, &beam)),
        ("quad4-coulomb", with(&coulomb, &facet)),
        ("quad4-stick", with(&tied, &facet)),
        ("quad4-hardening", with(&declared, &facet)),
        ("tri6-adhesive", with(&adhesive, &patch)),
        ("tri6-weakening", with(&weakening, &patch)),
        ("hermite-beams-coulomb", with(&coulomb, &beams())),
        ("line3-edges-weakening", with(&weakening, &edges)),
        ("hermite-quad9-coulomb", with(&coulomb, &rope)),
        ("torus-coulomb", with(&coulomb, &torus())),
    ]
}

fn orthotropic() -> Vec<Named> {
    let ellipse = TangentialLaw::Orthotropic {
        eps_t: [100.0, 80.0],
        mu: [0.3, 0.5],
    };
    let convected = Tangential::orthotropic(ellipse.clone(), Axis::Convected([1.0, 0.5]));
    let along = Tangential::orthotropic(ellipse, Axis::SlaveCurve);
    let area = fixed(Shape::Quad4, &AREA, Measure::Current);
    let facet = onto(shape(Shape::Quad4));
    let mortar = pair(3, area, shape(Shape::Quad4), GapKind::Signed);
    let still = rope(Shape::Quad9, Measure::Reference);
    let moving = rope(Shape::Tri6, Measure::Current);
    vec![
        ("quad4-convected", with(&convected, &facet)),
        ("hermite-beams-convected", with(&convected, &beams())),
        ("hermite-quad9-along", with(&along, &still)),
        ("hermite-tri6-along-current", with(&along, &moving)),
        ("quad4-quad4-convected-current", with(&convected, &mortar)),
        ("torus-convected", with(&convected, &torus())),
    ]
}

/// A bound that grows with the path.
#[derive(Debug)]
struct Hardening;

impl DeclaredTangential for Hardening {
    fn orthotropic(&self) -> bool {
        false
    }
    fn stiffness(&self) -> [f64; 2] {
        [60.0, f64::NAN]
    }
    fn bound<D: DualNum<Primitive = f64> + Copy>(&self, pressure: D, slip: D) -> Option<[D; 2]> {
        Some([pressure * (slip * 0.5 + 0.2), pressure])
    }
}

fn point_pairs() -> Vec<Named> {
    use GapKind::{Distance, Signed};
    let point = |dimension, master, gap| pair(dimension, Slave::Point, master, gap);
    let facet = |geometry| point(3, shape(geometry), Signed);
    let arc = Master::Shape(rational(Shape::BezierCurve(3)));
    let patch = Master::Shape(rational(Shape::BezierSurface(2)));
    vec![
        ("point-point", point(3, Master::Point, Distance)),
        ("point-point-2d", point(2, Master::Point, Distance)),
        ("point-line3", point(3, shape(Shape::Line3), Distance)),
        ("point-rational3", point(3, arc, Distance)),
        ("point-hermite-2d", point(2, shape(Shape::Hermite), Signed)),
        ("point-tri3", facet(Shape::Tri3)),
        ("point-tri6", facet(Shape::Tri6)),
        ("point-quad4", facet(Shape::Quad4)),
        ("point-quad9", facet(Shape::Quad9)),
        ("point-rational2", point(3, patch, Signed)),
    ]
}

fn curve(shape: Shape) -> Slave {
    Slave::Curve(Interpolation::new(shape))
}

fn curve_pairs() -> Vec<Named> {
    use GapKind::{Distance, Signed};
    use Shape::{Hermite, Line2};
    let edges = pair(3, curve(Hermite), shape(Hermite), Signed);
    let beams = pair(3, curve(Line2), shape(Line2), Distance);
    vec![("hermite-hermite-edges", edges), ("line2-beams", beams)]
}

const AREA: [[f64; 2]; 4] = [[-0.6, -0.6], [0.6, -0.6], [0.6, 0.6], [-0.6, 0.6]];
const LENGTH: [[f64; 2]; 2] = [[-0.6, 0.0], [0.6, 0.0]];

fn integrated_pairs() -> Vec<Named> {
    use GapKind::{Distance, Signed};
    use Measure::{Current, Reference, Unit};
    use Shape::{Hermite, Line2, Line3, Quad4, Quad9, Tri3, Tri6};
    let line = fixed(Line3, &LENGTH, Reference);
    let rope = fixed(Hermite, &[[0.2, 0.0]], Unit);
    let area = fixed(Quad4, &AREA, Reference);
    let single = fixed(Tri6, &[[0.2, 0.3]], Reference);
    let moving = fixed(Quad4, &AREA, Current);
    let planar = fixed(Line2, &LENGTH, Current);
    vec![
        ("line3-line3-line", pair(3, line, shape(Line3), Distance)),
        ("hermite-quad4", pair(3, rope, shape(Quad4), Signed)),
        ("quad4-quad4", pair(3, area, shape(Quad4), Signed)),
        ("tri6-quad9", pair(3, single, shape(Quad9), Signed)),
        ("quad4-tri3-current", pair(3, moving, shape(Tri3), Signed)),
        ("line2-2d-current", pair(2, planar, shape(Line2), Signed)),
    ]
}

fn rows() -> Slave {
    let row = |shape: &[f64]| Row {
        shape: shape.to_vec(),
        weight: 0.5,
    };
    Slave::Rows {
        rows: vec![row(&[0.7, 0.3, 0.4]), row(&[0.2, 0.8, -0.4])],
        positions: vec![true, true, false],
    }
}

fn rigid_pairs() -> Vec<Named> {
    use GapKind::{Distance, Signed};
    let (radius, alpha, major, minor) = (1.0, 0.5, 2.0, 0.5);
    let parametric = |surface, placement| Master::Parametric { surface, placement };
    let distance = |body, placement| Master::Distance { body, placement };
    let mut list = vec![];
    for surface in [
        RigidParametric::Plane,
        RigidParametric::Cylinder { radius },
        RigidParametric::Sphere { radius },
        RigidParametric::Cone { alpha },
        RigidParametric::Torus { major, minor },
    ] {
        let master = parametric(surface, SPATIAL);
        list.push(("point-surface", pair(3, Slave::Point, master, Signed)));
    }
    for body in [
        RigidDistance::Cylinder { radius },
        RigidDistance::Sphere { radius },
        RigidDistance::Cone { alpha },
        RigidDistance::Torus { major, minor },
    ] {
        let slave = fixed(Shape::Quad4, &AREA, Measure::Reference);
        let master = distance(body, SPATIAL);
        list.push(("quad4-body", pair(3, slave, master, Signed)));
    }
    let pitch_over_2pi = 0.3;
    let helix = RigidParametric::Helix {
        radius,
        pitch_over_2pi,
    };
    let helix = parametric(helix, SPATIAL);
    let ring = parametric(RigidParametric::Circle { radius }, PLANAR);
    let disc = distance(RigidDistance::Circle { radius }, PLANAR);
    let plane = distance(RigidDistance::Plane, SPATIAL);
    list.push((
        "point-helix",
        pair(3, Slave::Point, helix.clone(), Distance),
    ));
    list.push(("line2-helix", pair(3, curve(Shape::Line2), helix, Distance)));
    list.push(("rows-ring-2d", pair(2, rows(), ring, Signed)));
    list.push(("point-disc-2d", pair(2, Slave::Point, disc, Signed)));
    list.push(("rows-plane", pair(3, rows(), plane, Signed)));
    list
}

fn law_pairs() -> Vec<Named> {
    let mut power = pair(3, Slave::Point, shape(Shape::Quad4), GapKind::Signed);
    power.law = Law::Power {
        eps_n: 1.0,
        exponent: 1.5,
    };
    let mut barrier = pair(
        3,
        curve(Shape::Line3),
        shape(Shape::Line3),
        GapKind::Distance,
    );
    barrier.law = Law::Barrier {
        kappa: 1.0,
        distance: 0.1,
    };
    let mut declared = pair(3, curve(Shape::Line3), shape(Shape::Line2), GapKind::Signed);
    declared.law = Law::Declared(Arc::new(Cubic));
    vec![
        ("point-quad4-power", power),
        ("line3-line3-barrier", barrier),
        ("line3-line2-declared", declared),
    ]
}

/// A law that knows its force only.
#[derive(Debug)]
struct Cubic;

impl DeclaredLaw for Cubic {
    fn activity(&self, g: f64) -> Activity {
        if g < 0.0 {
            Activity::Active
        } else {
            Activity::Inactive
        }
    }
    fn force<D: DualNum<Primitive = f64> + Copy>(&self, g: D) -> D {
        g * g * g * 50.0 + g * 3.0
    }
}
