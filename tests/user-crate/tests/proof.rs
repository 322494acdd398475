//! The elements of this crate proven like the built-in ones: against an oracle that is given each geometry and
//! law once more, as plain functions without a derivative.

use std::collections::BTreeMap;
use std::sync::Arc;

use contact_elements::ElementDescription;
use contact_elements::table::{SlaveDescription};
use contact_verify::certify::{Extent, certify};
use contact_verify::oracle::geometry::{
    DeclaredDistance, DeclaredShape, DeclaredSurface, Interpolation, Placement, Region,
    RigidDistance, RigidParametric, Shape,
};
use contact_verify::oracle::law::{Activity, DeclaredLaw, Law};
use contact_verify::oracle::number::Number;
use contact_verify::oracle::multiplier::Multipliers;
use contact_verify::oracle::pair::{
    GapKind, IntegrationPoint, Master, Measure, Pair, Rolling, Row, Slave, Tangential,
};
use contact_verify::oracle::tangential::{DeclaredTangential, TangentialLaw};
use contact_verify::progress::Progress;
use contact_verify::subject::Subject;
use num_dual::DualNum;

/// `WheelTread` with radius, conicity and hollow.
#[derive(Debug)]
struct WheelTread([f64; 3]);

impl DeclaredSurface for WheelTread {
    fn parameters(&self) -> usize {
        2
    }
    fn region(&self) -> Region {
        Region::FREE
    }
    fn window(&self) -> [[f64; 2]; 2] {
        [[-1.0, 1.0], [-0.5, 0.5]]
    }
    fn point<D: Number>(&self, [u, v]: [D; 2]) -> [D; 3] {
        let [radius, conicity, hollow] = self.0;
        let s = v * v * hollow - v * conicity + radius;
        [s * u.sin(), v, s * u.cos()]
    }
}

/// `RailHead` with its crown.
#[derive(Debug)]
struct RailHead(f64);

impl DeclaredDistance for RailHead {
    fn distance<D: Number>(&self, [_, y, z]: [D; 3]) -> D {
        let height = z + self.0;
        (y * y + height * height).sqrt() - self.0
    }
}

/// `Quad8`, from its corners and the middles of its sides: N = product of what vanishes at the other nodes.
#[derive(Debug)]
struct Quad8;

const NODES: [[f64; 2]; 8] = [
    [-1.0, -1.0],
    [1.0, -1.0],
    [1.0, 1.0],
    [-1.0, 1.0],
    [0.0, -1.0],
    [1.0, 0.0],
    [0.0, 1.0],
    [-1.0, 0.0],
];

impl DeclaredShape for Quad8 {
    fn nodes(&self) -> usize {
        NODES.len()
    }
    fn parameters(&self) -> usize {
        2
    }
    fn region(&self) -> Region {
        Region::square(-1.0, 1.0)
    }
    fn typical_nodes(&self) -> Vec<[f64; 3]> {
        NODES.iter().map(|&[x, y]| [x, y, 0.1 * x * y]).collect()
    }
    fn row<D: Number>(&self, [xi, eta]: [D; 2], out: &mut [D]) {
        for (n, [x, y]) in out.iter_mut().zip(NODES) {
            *n = if x == 0.0 {
                (-(xi * xi) + 1.0) * (eta * y + 1.0) * 0.5
            } else if y == 0.0 {
                (xi * x + 1.0) * (-(eta * eta) + 1.0) * 0.5
            } else {
                (xi * x + 1.0) * (eta * y + 1.0) * (xi * x + eta * y - 1.0) * 0.25
            };
        }
    }
}

/// `Softened` with p and c.
#[derive(Debug)]
struct Softened([f64; 2]);

impl DeclaredLaw for Softened {
    fn activity(&self, g: f64) -> Activity {
        let c = self.0[1];
        if g >= c {
            Activity::Inactive
        } else if g > -20.0 * c {
            Activity::Active
        } else {
            Activity::Infeasible
        }
    }
    fn force<D: DualNum<Primitive = f64> + Copy>(&self, g: D) -> D {
        let [p, c] = self.0;
        let s = -g / c + 1.0;
        s * s * (s + 3.0) * (s - 1.0).exp() * (-0.25 * p)
    }
    fn energy<D: DualNum<Primitive = f64> + Copy>(&self, g: D) -> Option<D> {
        let [p, c] = self.0;
        let s = -g / c + 1.0;
        Some(s * s * s * (s - 1.0).exp() * (0.25 * p * c))
    }
}

/// `Worn` with k, m, q and d.
#[derive(Debug)]
struct Worn([f64; 4]);

impl DeclaredTangential for Worn {
    fn orthotropic(&self) -> bool {
        false
    }
    fn stiffness(&self) -> [f64; 2] {
        [self.0[0]; 2]
    }
    fn bound<D: DualNum<Primitive = f64> + Copy>(&self, p: D, slip: D) -> Option<[D; 2]> {
        let [_, m, q, d] = self.0;
        let falling = (-slip / d).exp() + 1.0;
        Some([falling * p * (0.5 * m) / (p / q + 1.0); 2])
    }
}

/// `Grip` with r, lever and turn.
#[derive(Debug)]
struct Grip([f64; 3]);

impl DeclaredTangential for Grip {
    fn orthotropic(&self) -> bool {
        false
    }
    fn stiffness(&self) -> [f64; 2] {
        [self.0[0]; 2]
    }
    fn bound<D: DualNum<Primitive = f64> + Copy>(&self, p: D, angle: D) -> Option<[D; 2]> {
        let [_, lever, turn] = self.0;
        Some([((-angle / turn).exp() + 1.0) * p * (0.5 * lever); 2])
    }
}

/// Lengths about one: the random states are that large.
const WHEEL: [f64; 3] = [1.1, 0.1, 0.05];
const CROWN: f64 = 0.9;
/// p; c below most of the open gaps, which lie between 1e-3 and 0.3.
const SOFTENED: [f64; 2] = [70.0, 0.02];

/// k, m, q, d.
const WORN: [f64; 4] = [300.0, 0.4, 90.0, 0.3];

/// r, lever, turn: rolls after 0.1 to 1 rad at the pressures of most states.
const GRIP: [f64; 3] = [40.0, 0.3, 0.4];

/// An element and the pair it claims to be; of `placement`, `r0` and orientation only the kind counts.
fn subject(name: &str, slave: Slave, master: Master, law: Law, geometry: &[f64]) -> Subject {
    let description = description(name);
    Subject {
        description,
        template: Pair {
            dimension: 3,
            slave,
            master,
            gap: GapKind::Signed,
            orientation: 1.0,
            r0: 0.0,
            law,
            tangential: None,
            angle: None,
            multipliers: Multipliers::None,
        },
        law_parameters: SOFTENED.to_vec(),
        tangential_parameters: WORN.to_vec(),
        rolling_parameters: GRIP.to_vec(),
        geometry_parameters: geometry.to_vec(),
    }
}

fn description(name: &str) -> &'static ElementDescription {
    let mut all = rail::DESCRIPTIONS.iter();
    all.find(|element| element.name == name)
        .unwrap_or_else(|| panic!("no element {name}"))
}

/// A facet with the integration points of the element.
fn integrated(name: &str, shape: Shape) -> Slave {
    let SlaveDescription::Integrated(_, points) = description(name).slave else {
        panic!("{name} is not integrated");
    };
    let points = points
        .iter()
        .map(|&(eta, weight)| IntegrationPoint { eta, weight });
    Slave::Fixed {
        geometry: Interpolation::new(shape),
        points: points.collect(),
        measure: Measure::Reference,
    }
}

fn subjects() -> Vec<Subject> {
    let quad8 = || Shape::Declared(Arc::new(Quad8));
    let facet = || Master::Shape(Interpolation::new(quad8()));
    let softened = || Law::Declared(Arc::new(Softened(SOFTENED)));
    let penalty = || Law::Penalty { eps_n: 1000.0 };
    let placement = Placement::Spatial {
        origin: [0.0; 3],
        quaternion: [1.0, 0.0, 0.0, 0.0],
    };
    let wheel = Master::Parametric {
        surface: RigidParametric::Declared(Arc::new(WheelTread(WHEEL))),
        placement,
    };
    let rail = Master::Distance {
        body: RigidDistance::Declared(Arc::new(RailHead(CROWN))),
        placement,
    };
    let torus = Master::Parametric {
        surface: RigidParametric::Torus {
            major: 1.5,
            minor: 0.6,
        },
        placement,
    };
    let cell = Slave::Rows {
        rows: vec![Row {
            shape: vec![0.125, 0.5, 0.625, -0.25],
            weight: 0.75,
        }],
        positions: vec![true; 4],
    };
    let quad8_points = integrated("Quad8RailHead", quad8());
    let quad4_points = integrated("Quad4Quad8", Shape::Quad4);
    let mut worn = subject("PointQuad8Worn", Slave::Point, facet(), softened(), &[]);
    worn.template.tangential = Some(Tangential {
        law: TangentialLaw::Declared(Arc::new(Worn(WORN))),
        axis: None,
        tangent_plane: false,
        rolling: None,
    });
    let line = || Interpolation::new(Shape::Line2);
    let (first, last) = (Slave::Curve(line()), Master::Shape(line()));
    let mut wires = subject("ContactWires", first, last, penalty(), &[]);
    wires.template.gap = GapKind::Distance;
    wires.template.tangential = Some(Tangential {
        rolling: Some(Rolling {
            law: TangentialLaw::Declared(Arc::new(Grip(GRIP))),
            directors: Some([[0.0, 0.0, 1.0]; 2]),
        }),
        ..Tangential::isotropic(TangentialLaw::Coulomb {
            eps_t: 500.0,
            mu: 0.3,
        })
    });
    vec![
        subject("PointQuad8", Slave::Point, facet(), softened(), &[]),
        subject("PointWheelTread", Slave::Point, wheel, penalty(), &WHEEL),
        subject("Quad8RailHead", quad8_points, rail, softened(), &[CROWN]),
        subject("Quad4Quad8", quad4_points, facet(), penalty(), &[]),
        subject("InterpolatedTorus", cell, torus, softened(), &[]),
        worn,
        wires,
    ]
}

#[test]
fn every_element_is_exact() {
    let subjects = subjects();
    assert_eq!(subjects.len(), rail::DESCRIPTIONS.len());
    let extent = Extent {
        states: 300,
        seed: 1,
        library: false,
    };
    let certificate = certify(&mut Progress::default(), &subjects, &extent, &BTreeMap::new());
    assert_eq!(certificate.failed(), 0, "{}", certificate.to_text());
}
