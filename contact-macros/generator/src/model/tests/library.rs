//! The built-in text against formulas written down again.

use std::collections::HashMap;

use crate::model::{Body, Bound, Geometry, Model};

/// Values of `exprs` at a point with parameters.
fn values(geometry: &Geometry, point: &[f64], parameters: &[(&str, f64)]) -> Vec<f64> {
    let mut known: HashMap<String, f64> = parameters
        .iter()
        .map(|(name, value)| (name.to_string(), *value))
        .collect();
    for (name, value) in geometry.coordinates.iter().zip(point) {
        known.insert(name.to_string(), *value);
    }
    for (name, value) in &geometry.bindings {
        let value = value.evaluate(&|name| known.get(&name.to_string()).copied());
        known.insert(name.to_string(), value);
    }
    let exprs = match &geometry.body {
        Body::Shape { functions, .. } => functions.clone(),
        Body::Rigid { position, .. } => position.clone(),
        Body::Distance { value } => vec![value.clone()],
    };
    exprs
        .iter()
        .map(|x| x.evaluate(&|name| known.get(&name.to_string()).copied()))
        .collect()
}

fn close(a: &[f64], b: &[f64]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-14)
}

fn find(name: &str) -> std::rc::Rc<Geometry> {
    let model = Model::library();
    model
        .geometries
        .iter()
        .find(|geometry| geometry.name == name)
        .unwrap()
        .clone()
}

#[test]
fn the_library_is_complete() {
    let model = Model::library();
    let names: Vec<String> = model
        .geometries
        .iter()
        .map(|g| g.name.to_string())
        .collect();
    let expected = "Line2 Line3 Hermite BezierCurve2 BezierCurve3 RationalCurve2 RationalCurve3 \
                    Tri3 Tri6 Quad4 Quad9 BezierSurface2 RationalSurface2 Plane Cylinder Sphere \
                    Cone Torus Circle Helix Circle2d PlaneDistance CylinderDistance SphereDistance \
                    ConeDistance TorusDistance CircleDistance2d";
    assert_eq!(names.join(" "), expected);
    let laws: Vec<String> = model.laws.iter().map(|law| law.name.to_string()).collect();
    assert_eq!(laws.join(" "), "Penalty PowerLaw LogBarrier");
    assert!(
        model
            .geometries
            .iter()
            .all(|geometry| geometry.built_in && !geometry.docs.is_empty())
    );
    let laws: Vec<String> = model
        .tangential_laws
        .iter()
        .map(|law| law.name.to_string())
        .collect();
    let expected =
        "Coulomb Stick CoulombOrthotropic CoulombAdhesive CoulombStaticKinetic RollingResistance";
    assert_eq!(laws.join(" "), expected);
    assert!(
        model
            .tangential_laws
            .iter()
            .all(|law| law.built_in && !law.docs.is_empty())
    );
    assert!(
        model
            .laws
            .iter()
            .all(|law| law.built_in && !law.docs.is_empty())
    );
}

#[test]
fn lagrange_functions_are_one_at_their_own_node() {
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let middles = [[0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, 0.0]];
    let quad9: Vec<Vec<f64>> = corners.iter().chain(&middles).map(|x| x.to_vec()).collect();
    let tri6: Vec<Vec<f64>> = [
        [0.0, 0.0],
        [1.0, 0.0],
        [0.0, 1.0],
        [0.5, 0.0],
        [0.5, 0.5],
        [0.0, 0.5],
    ]
    .iter()
    .map(|x| x.to_vec())
    .collect();
    let cases = [
        ("Line2", vec![vec![-1.0], vec![1.0]]),
        ("Line3", vec![vec![-1.0], vec![1.0], vec![0.0]]),
        ("Tri3", tri6[..3].to_vec()),
        ("Tri6", tri6),
        ("Quad4", quad9[..4].to_vec()),
        ("Quad9", quad9),
    ];
    for (name, nodes) in cases {
        let geometry = find(name);
        for (index, node) in nodes.iter().enumerate() {
            let mut unit = vec![0.0; nodes.len()];
            unit[index] = 1.0;
            assert!(
                close(&values(&geometry, node, &[]), &unit),
                "{name} at node {index}"
            );
        }
    }
}

#[test]
fn hermite_interpolates_points_and_tangents() {
    let hermite = find("Hermite");
    let Body::Shape { vectors, .. } = &hermite.body else {
        panic!()
    };
    assert_eq!(*vectors, [1, 3]);
    assert!(close(
        &values(&hermite, &[-1.0], &[]),
        &[1.0, 0.0, 0.0, 0.0]
    ));
    assert!(close(&values(&hermite, &[1.0], &[]), &[0.0, 0.0, 1.0, 0.0]));
    let x = 0.3f64;
    let expected = [
        (1.0 - x).powi(2) * (2.0 + x) / 4.0,
        (1.0 - x).powi(2) * (1.0 + x) / 4.0,
        (1.0 + x).powi(2) * (2.0 - x) / 4.0,
        -(1.0 + x).powi(2) * (1.0 - x) / 4.0,
    ];
    assert!(close(&values(&hermite, &[x], &[]), &expected));
}

#[test]
fn bernstein_polynomials_run_through_the_first_coordinate_fastest() {
    let basis = |n: usize, t: f64| -> Vec<f64> {
        let binomial = [[1.0, 2.0, 1.0, 0.0], [1.0, 3.0, 3.0, 1.0]][n - 2];
        (0..=n)
            .map(|i| binomial[i] * t.powi(i as i32) * (1.0 - t).powi((n - i) as i32))
            .collect()
    };
    for (name, degree) in [
        ("BezierCurve2", 2),
        ("RationalCurve2", 2),
        ("BezierCurve3", 3),
        ("RationalCurve3", 3),
    ] {
        assert!(
            close(&values(&find(name), &[0.3], &[]), &basis(degree, 0.3)),
            "{name}"
        );
    }
    let (u, v) = (basis(2, 0.3), basis(2, 0.8));
    let product: Vec<f64> = v
        .iter()
        .flat_map(|b| u.iter().map(move |a| a * b))
        .collect();
    for (name, rational) in [("BezierSurface2", false), ("RationalSurface2", true)] {
        let surface = find(name);
        assert!(
            close(&values(&surface, &[0.3, 0.8], &[]), &product),
            "{name}"
        );
        assert!(matches!(surface.body, Body::Shape { rational: r, .. } if r == rational));
    }
}

/// Parameters of every rigid geometry.
const PARAMETERS: [(&str, f64); 5] = [
    ("radius", 1.3),
    ("rise", 0.4),
    ("major", 2.0),
    ("minor", 0.6),
    ("half_angle", 0.5),
];

#[test]
fn distances_vanish_on_the_surfaces_and_normals_point_outwards() {
    for name in ["Plane", "Cylinder", "Sphere", "Cone", "Torus"] {
        let (surface, distance) = (find(name), find(&format!("{name}Distance")));
        for point in [[0.4, 0.7], [2.5, 1.1], [-1.2, 0.2]] {
            let at = |u: f64, v: f64| values(&surface, &[u, v], &PARAMETERS);
            let (x, h) = (at(point[0], point[1]), 1e-5);
            assert!(
                values(&distance, &x, &PARAMETERS)[0].abs() < 1e-12,
                "{name}"
            );
            let slope = |plus: Vec<f64>, minus: Vec<f64>| -> Vec<f64> {
                plus.iter()
                    .zip(&minus)
                    .map(|(a, b)| (a - b) / (2.0 * h))
                    .collect()
            };
            let a = slope(at(point[0] + h, point[1]), at(point[0] - h, point[1]));
            let b = slope(at(point[0], point[1] + h), at(point[0], point[1] - h));
            let normal = [
                a[1] * b[2] - a[2] * b[1],
                a[2] * b[0] - a[0] * b[2],
                a[0] * b[1] - a[1] * b[0],
            ];
            let length = normal.iter().map(|n| n * n).sum::<f64>().sqrt();
            let outside: Vec<f64> = x
                .iter()
                .zip(normal)
                .map(|(x, n)| x + 0.1 * n / length)
                .collect();
            let gap = values(&distance, &outside, &PARAMETERS)[0];
            assert!((gap - 0.1).abs() < 1e-8, "{name}: {gap}");
        }
    }
}

#[test]
fn the_left_normal_of_the_disc_points_outwards() {
    let at = |u: f64| values(&find("Circle2d"), &[u], &PARAMETERS);
    let (x, h) = (at(0.7), 1e-6);
    let slope: Vec<f64> = at(0.7 + h)
        .iter()
        .zip(at(0.7 - h))
        .map(|(a, b)| a - b)
        .collect();
    assert!(-slope[1] * x[0] + slope[0] * x[1] > 0.0);
    assert!(values(&find("CircleDistance2d"), &x, &PARAMETERS)[0].abs() < 1e-14);
}

#[test]
fn wires_are_where_they_should_be() {
    let (u, radius, rise) = (0.7f64, 1.3, 0.4);
    let helix = [radius * u.cos(), radius * u.sin(), rise * u];
    assert!(close(&values(&find("Helix"), &[u], &PARAMETERS), &helix));
    assert!(close(
        &values(&find("Circle"), &[u], &PARAMETERS),
        &[helix[0], helix[1], 0.0]
    ));
}

#[test]
fn laws_have_the_tractions_of_the_books() {
    let model = Model::library();
    let parameters = [("eps_n", 7.0), ("m", 2.5), ("kappa", 3.0), ("d", 0.8)];
    let ln = (0.3f64 / 0.8).ln();
    let barrier = -3.0 * (2.0 * (0.3 - 0.8) * ln + (0.3f64 - 0.8).powi(2) / 0.3);
    let cases = [
        ("Penalty", -0.3, 7.0 * -0.3),
        ("PowerLaw", -0.3, -7.0 * 0.3f64.powf(2.5)),
        ("LogBarrier", 0.3, barrier),
    ];
    for (name, gap, expected) in cases {
        let law = model.laws.iter().find(|law| law.name == name).unwrap();
        let mut known: HashMap<String, f64> = parameters
            .iter()
            .map(|(name, value)| (name.to_string(), *value))
            .collect();
        known.insert(law.gap.to_string(), gap);
        for (name, value) in &law.bindings {
            let value = value.evaluate(&|name| known.get(&name.to_string()).copied());
            known.insert(name.to_string(), value);
        }
        let traction = law
            .traction
            .evaluate(&|name| known.get(&name.to_string()).copied());
        assert!(
            (traction - expected).abs() < 1e-13 && traction < 0.0,
            "{name}: {traction}"
        );
        let starts_at_zero = matches!(&law.active, Bound::Below(limit)
            if limit.evaluate(&|_| None) == 0.0);
        assert_eq!(starts_at_zero, name != "LogBarrier");
        assert_eq!(law.valid.is_some(), name != "Penalty");
    }
}

#[test]
fn tangential_laws_have_the_bounds_of_the_books() {
    let model = Model::library();
    let parameters = [
        ("eps_t", 7.0),
        ("eps_1", 7.0),
        ("eps_2", 5.0),
        ("mu", 0.3),
        ("mu_1", 0.3),
        ("mu_2", 0.2),
        ("mu_s", 0.4),
        ("mu_k", 0.1),
        ("c", 0.6),
        ("decay", 0.8),
    ];
    let (pressure, slip) = (11.0, 0.5);
    let falling = pressure * (0.1 + 0.3 * f64::exp(-slip / 0.8));
    let cases: [(&str, &[f64], &[f64]); 5] = [
        ("Coulomb", &[7.0], &[0.3 * pressure]),
        ("Stick", &[7.0], &[]),
        (
            "CoulombOrthotropic",
            &[7.0, 5.0],
            &[0.3 * pressure, 0.2 * pressure],
        ),
        ("CoulombAdhesive", &[7.0], &[0.6 + 0.3 * pressure]),
        ("CoulombStaticKinetic", &[7.0], &[falling]),
    ];
    for (name, stiffness, bound) in cases {
        let laws = &model.tangential_laws;
        let law = laws.iter().find(|law| law.name == name).unwrap();
        let value = |name: &syn::Ident| match name {
            name if *name == law.pressure => Some(pressure),
            name if *name == law.slip => Some(slip),
            name => parameters
                .iter()
                .find(|(known, _)| name == known)
                .map(|(_, value)| *value),
        };
        let values = |exprs: &[crate::model::Expr]| -> Vec<f64> {
            exprs.iter().map(|expr| expr.evaluate(&value)).collect()
        };
        assert!(close(&values(&law.stiffness), stiffness), "{name}");
        assert!(close(&values(&law.bound), bound), "{name}");
    }
}
