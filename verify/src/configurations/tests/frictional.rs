//! Friction: states stick or slip as requested, and the oracle's friction obeys mechanics.

use super::largest;
use super::templates::frictional;
use crate::configurations::{Configuration, GenerateError, Generator, Wanted};
use crate::oracle::history::Accepted;
use crate::oracle::kinematics::Frame;
use crate::oracle::pair::{Master, Slave};
use crate::oracle::solve::{self, PointStatus, State};
use crate::oracle::tangential::TangentialLaw;
use crate::oracle::tangential::return_map::Regime;
use crate::oracle::vector::{add, dot, norm, scale, sub};

fn each(count: u64, mut check: impl FnMut(&str, &Configuration)) {
    for (name, template) in frictional() {
        for wanted in [Wanted::Stick, Wanted::Slip] {
            let generator = Generator::new(template.clone(), 23);
            for index in 0..count {
                match generator.generate(wanted, index) {
                    Ok(configuration) => check(name, &configuration),
                    Err(GenerateError::NeverSlips) if name.ends_with("stick") => {}
                    Err(error) => panic!("{name} {wanted:?} {index}: {error}"),
                }
            }
        }
    }
}

#[test]
fn all_kinds_of_loading_occur() {
    let mut seen = [false; 9];
    each(60, |name, configuration| {
        for point in &configuration.points {
            let Some(friction) = point.friction else {
                assert_ne!(point.status, PointStatus::Closed, "{name}");
                continue;
            };
            let (used, size) = (friction.utilisation, configuration.size);
            let slips = friction.regime == Regime::Slip;
            assert_eq!(slips, used > 1.0, "{name}");
            let kinds = [
                slips && used < 1.0 + 1e-6,
                !slips && used > 1.0 - 1e-6,
                slips && used > 1.5,
                !slips && friction.distance == 0.0,
                !slips && friction.distance > 0.0 && friction.distance < 1e-9 * size,
                slips && friction.history.slip > 0.0,
                !slips && friction.history.slip > 0.0,
                configuration
                    .friction
                    .iter()
                    .any(|h| h.status == Accepted::Open),
                !slips && used > 0.1 && used < 0.9,
            ];
            for (seen, now) in seen.iter_mut().zip(kinds) {
                *seen |= now;
            }
        }
    });
    assert_eq!(seen, [true; 9]);
}

#[test]
fn frictional_tangents_are_differences_of_the_residual() {
    each(12, |name, configuration| {
        let pair = &configuration.pair;
        let unknowns = pair.unknowns();
        let found = solve::evaluate(pair, &configuration.state()).unwrap();
        let margin = |friction: &solve::FrictionReport| (friction.utilisation - 1.0).abs();
        let mut points = configuration
            .points
            .iter()
            .filter_map(|point| point.friction);
        if points.any(|friction| margin(&friction) < 1e-2) {
            return; // a difference would cross the switch
        }
        let h = 1e-6 * configuration.size;
        for j in 0..unknowns {
            let residual = |step: f64| {
                let mut displacement = configuration.displacement.clone();
                displacement[j] += step;
                let state = State {
                    displacement: &displacement,
                    ..configuration.state()
                };
                solve::residual(pair, &state).unwrap().residual
            };
            for (i, (p, m)) in residual(h).iter().zip(&residual(-h)).enumerate() {
                let error = ((p - m) / (2.0 * h) - found.tangent[unknowns * i + j]).abs();
                let error = error / largest(&found.tangent);
                assert!(error < 2e-5, "{name}: tangent {i} {j} off by {error:e}");
            }
        }
    });
}

#[test]
fn friction_balances_forces_and_moments() {
    each(10, |name, configuration| {
        let pair = &configuration.pair;
        if pair.master_nodes() == 0 {
            return;
        }
        let found = solve::residual(pair, &configuration.state())
            .unwrap()
            .residual;
        let x = configuration.positions();
        let d = pair.dimension;
        let read = |values: &[f64], node: usize| {
            std::array::from_fn(|c| if c < d { values[d * node + c] } else { 0.0 })
        };
        let (mut force, mut moment) = ([0.0; 3], [0.0; 3]);
        for node in 0..pair.slave_nodes() + pair.master_nodes() {
            let is_position = match node.checked_sub(pair.slave_nodes()) {
                None => pair.slave_is_position(node),
                Some(master) => pair.master_is_position(master),
            };
            let (x, r) = (read(&x, node), read(&found, node));
            moment = add(moment, crate::oracle::vector::cross(x, r));
            if is_position {
                force = add(force, r);
            }
        }
        let scale = largest(&found);
        let (force, moment) = (largest(&force) / scale, largest(&moment) / scale);
        assert!(
            force < 1e-12 && moment < 1e-11,
            "{name}: {force:e} {moment:e}"
        );
    });
}

#[test]
fn the_new_anchor_holds_the_same_traction() {
    each(20, |name, configuration| {
        let pair = &configuration.pair;
        let next: Vec<_> = configuration
            .points
            .iter()
            .zip(&configuration.friction)
            .map(|(point, old)| point.friction.map_or(*old, |friction| friction.history))
            .collect();
        let state = State {
            friction: &next,
            ..configuration.state()
        };
        for (before, after) in configuration
            .points
            .iter()
            .zip(solve::reports(pair, &state).unwrap())
        {
            let (Some(before), Some(after)) = (before.friction, after.friction) else {
                continue;
            };
            if matches!(
                pair.tangential.as_ref().map(|t| &t.law),
                Some(TangentialLaw::StaticKinetic { .. })
            ) {
                continue; // its bound falls with the path
            }
            let scale = norm([
                before.components[0],
                before.components[1],
                1e-12 * largest(&[1.0]),
            ]);
            for q in 0..2 {
                let error = (before.components[q] - after.components[q]).abs() / scale;
                assert!(error < 1e-8 || scale < 1e-8, "{name}: {error:e}");
            }
            assert!(after.utilisation < 1.0 + 1e-8, "{name}");
        }
    });
}

#[test]
fn orthotropy_with_equal_axes_is_isotropy() {
    each(10, |name, configuration| {
        let Some(tangential) = &configuration.pair.tangential else {
            return;
        };
        let TangentialLaw::Orthotropic {
            eps_t: [eps_t, _],
            mu: [mu, _],
        } = tangential.law
        else {
            return;
        };
        let mut pairs = [configuration.pair.clone(), configuration.pair.clone()];
        let laws = [
            TangentialLaw::Orthotropic {
                eps_t: [eps_t; 2],
                mu: [mu; 2],
            },
            TangentialLaw::Coulomb { eps_t, mu },
        ];
        for (pair, law) in pairs.iter_mut().zip(laws) {
            if let Some(tangential) = &mut pair.tangential {
                tangential.axis = tangential.axis.filter(|_| law.orthotropic());
                tangential.law = law;
            }
        }
        let [one, other] =
            pairs.map(|pair| solve::evaluate(&pair, &configuration.state()).unwrap());
        let switched = one.points.iter().filter_map(|p| p.friction);
        if switched
            .into_iter()
            .any(|f| (f.utilisation - 1.0).abs() < 1e-9)
        {
            return;
        }
        for (a, b) in [
            (&one.residual, &other.residual),
            (&one.tangent, &other.tangent),
        ] {
            let difference: Vec<f64> = a.iter().zip(b).map(|(a, b)| a - b).collect();
            let error = largest(&difference) / largest(a);
            assert!(error < 1e-11, "{name}: {error:e}");
        }
    });
}

#[test]
fn the_plane_residual_is_exact_at_zero_distance() {
    for (name, template) in frictional() {
        let generator = Generator::new(template, 5);
        let Ok(configuration) = generator.generate(Wanted::Slip, 0) else {
            continue;
        };
        let mut plane = configuration.pair.clone();
        if let Some(tangential) = &mut plane.tangential {
            tangential.tangent_plane = true;
        }
        let [exact, approximate] = [&configuration.pair, &plane].map(|pair| {
            solve::residual(pair, &configuration.state())
                .unwrap()
                .residual
        });
        let difference: Vec<f64> = exact.iter().zip(&approximate).map(|(a, b)| a - b).collect();
        let error = largest(&difference) / largest(&exact);
        let moves = matches!(configuration.pair.master, Master::Shape(_))
            || matches!(configuration.pair.slave, Slave::Curve(_));
        if moves {
            assert!(error > 1e-8 && error < 1.0, "{name}: {error:e}");
        }
        let sum = |values: &[f64]| -> f64 { values.iter().sum() };
        let rest = sum(&exact) - sum(&approximate);
        if configuration.pair.master_nodes() > 0 && !name.contains("hermite") {
            assert!(
                rest.abs() < 1e-11 * largest(&exact),
                "{name}: forces balance in both"
            );
        }
    }
}

#[test]
fn axes_are_an_orthonormal_frame_of_the_tangent_plane() {
    each(5, |name, configuration| {
        for (q, point) in configuration.points.iter().enumerate() {
            let Some(friction) = point.friction else {
                continue;
            };
            let frame = Frame::new(
                &configuration.pair,
                q,
                &configuration.reference,
                &configuration.displacement,
            );
            let [first, second] = friction.axes;
            let tangents = frame.relative(&frame.nodes, point.zeta).tangents;
            for value in [
                dot(first, second),
                dot(first, point.normal),
                dot(second, point.normal),
            ] {
                assert!(value.abs() < 1e-12, "{name}: {value:e}");
            }
            let traction = add(
                scale(first, friction.components[0]),
                scale(second, friction.components[1]),
            );
            for i in 0..configuration.pair.parameters() {
                let expected = dot(traction, tangents[i]);
                let size = norm(traction) * norm(tangents[i]);
                assert!(
                    (friction.covariant[i] - expected).abs() <= 1e-12 * size,
                    "{name}"
                );
            }
            let difference = sub(first, second);
            assert!((norm(difference) - 2.0f64.sqrt()).abs() < 1e-12, "{name}");
        }
    });
}
