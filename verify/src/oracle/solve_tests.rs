//! Derivatives of gap and parameters against differences; invariance under rigid motions.

use crate::configurations::{Configuration, Generator, Stream, Wanted};
use crate::oracle::geometry::{Interpolation, Placement, Shape};
use crate::oracle::law::Law;
use crate::oracle::multiplier::Multipliers;
use crate::oracle::pair::{GapKind, IntegrationPoint, Master, Measure, Pair, Slave};
use crate::oracle::solve::{self, PointSolution, Seed, Start, State, solve_point};

fn curve(shape: Shape) -> Slave {
    Slave::Curve(Interpolation::new(shape))
}

fn fixed(shape: Shape) -> Slave {
    let geometry = Interpolation::new(shape);
    let points = [[-0.4, -0.4], [0.3, -0.2]].map(|eta| IntegrationPoint { eta, weight: 1.0 });
    Slave::Fixed {
        geometry,
        points: points.to_vec(),
        measure: Measure::Reference,
    }
}

/// Pairs whose nodes all move.
fn deformable() -> Vec<Pair> {
    use GapKind::{Distance, Signed};
    let list = [
        (3, Slave::Point, Shape::Quad9, Signed),
        (3, Slave::Point, Shape::BezierCurve(3), Distance),
        (3, curve(Shape::Hermite), Shape::Line3, Distance),
        (3, curve(Shape::Line3), Shape::Hermite, Signed),
        (3, fixed(Shape::Quad4), Shape::Tri6, Signed),
        (3, fixed(Shape::Hermite), Shape::Quad4, Signed),
        (2, Slave::Point, Shape::Line3, Signed),
    ];
    let law = Law::Penalty { eps_n: 100.0 };
    let pair = |(dimension, slave, master, gap)| Pair {
        dimension,
        slave,
        master: Master::Shape(Interpolation::new(master)),
        gap,
        orientation: 1.0,
        r0: 0.0,
        law: law.clone(),
        tangential: None,
        angle: None,
        multipliers: Multipliers::None,
    };
    list.map(pair).to_vec()
}

fn closed(pair: Pair, index: u64) -> Configuration {
    Generator::new(pair, 11)
        .generate(Wanted::Closed, index)
        .unwrap()
}

/// Largest entry by magnitude.
fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0, |m, v| m.max(v.abs()))
}

/// Solution of point 0 with unknown `j` moved by `step`.
fn moved(configuration: &Configuration, j: usize, step: f64) -> PointSolution<'_> {
    let mut displacement = configuration.displacement.clone();
    displacement[j] += step;
    let state = State {
        displacement: &displacement,
        ..configuration.state()
    };
    solve_point(&configuration.pair, &state, 0).unwrap()
}

#[test]
fn hessians_are_differences_of_gradients() {
    for pair in deformable() {
        for index in 0..2 {
            let configuration = closed(pair.clone(), index);
            let Ok(point) = solve_point(&configuration.pair, &configuration.state(), 0) else {
                continue;
            };
            let n = configuration.pair.unknowns();
            let h = 1e-6 * configuration.size;
            let gap = point.gap_hessian();
            let zeta = [point.zeta_hessian(0), point.zeta_hessian(1)];
            for j in 0..n {
                let (plus, minus) = (moved(&configuration, j, h), moved(&configuration, j, -h));
                for i in 0..n {
                    let slope = (plus.gap_gradient[i] - minus.gap_gradient[i]) / (2.0 * h);
                    let error = (slope - gap[n * i + j]).abs() / largest(gap.iter().copied());
                    assert!(error < 1e-7, "gap {i} {j}: {error:e}");
                    for k in 0..configuration.pair.parameters() {
                        let (p, m) = (plus.zeta_gradient[i][k], minus.zeta_gradient[i][k]);
                        let error = ((p - m) / (2.0 * h) - zeta[k][n * i + j]).abs();
                        let error = error / largest(zeta[k].iter().copied());
                        assert!(error < 1e-7, "zeta {k} {i} {j}: {error:e}");
                    }
                }
            }
        }
    }
}

#[test]
fn a_further_newton_step_changes_nothing() {
    for pair in deformable() {
        let configuration = closed(pair, 3);
        let Ok(point) = solve_point(&configuration.pair, &configuration.state(), 0) else {
            continue;
        };
        let mut sweep = point.sweep();
        let mut stream = Stream::new(5, 0, 0);
        let n = configuration.pair.unknowns();
        let direction: Vec<f64> = (0..n).map(|_| stream.uniform(-1.0, 1.0)).collect();
        let found = point.hyper(&mut sweep, Seed::Unit(1), Seed::Along(&direction));
        // stationarity holds in every part of the hyper-dual number
        let r = found.relative.position;
        for b in found
            .relative
            .tangents
            .iter()
            .take(configuration.pair.parameters())
        {
            let f = (0..3)
                .map(|c| r[c] * b[c])
                .reduce(|sum, term| sum + term)
                .unwrap();
            let scale = largest(b.iter().map(|b| b.re)) * point.frame.size;
            let curvature = largest(b.iter().map(|b| b.eps1eps2)) * point.frame.size;
            assert!(f.re.abs() < 1e-13 * scale && f.eps1.abs() < 1e-12 && f.eps2.abs() < 1e-11);
            assert!(
                f.eps1eps2.abs() < 1e-11 * (1.0 + curvature),
                "{:e}",
                f.eps1eps2
            );
        }
    }
}

/// All nodes turned about the origin and shifted.
fn rigidly_moved(configuration: &Configuration, stream: &mut Stream) -> Vec<f64> {
    let pair = &configuration.pair;
    let (shift, mut quaternion) = (stream.cube(1.0), stream.quaternion());
    if pair.dimension == 2 {
        quaternion = [quaternion[0], 0.0, 0.0, quaternion[3]];
    }
    let rotation = Placement::Spatial {
        origin: [0.0; 3],
        quaternion,
    }
    .rotation();
    let x = configuration.positions();
    let dim = pair.dimension;
    let mut moved = vec![0.0; x.len()];
    for node in 0..x.len() / dim {
        let position = match node.checked_sub(pair.slave_nodes()) {
            None => pair.slave_is_position(node),
            Some(master) => pair.master_is_position(master),
        };
        for c in 0..dim {
            let turned: f64 = (0..dim).map(|k| rotation[c][k] * x[dim * node + k]).sum();
            moved[dim * node + c] = turned + if position { shift[c] } else { 0.0 };
        }
    }
    moved
}

#[test]
fn rigid_motions_change_no_energy() {
    let mut stream = Stream::new(1, 2, 3);
    for pair in deformable() {
        for index in 0..3 {
            let configuration = closed(pair.clone(), index);
            let before = solve::energy(&configuration.pair, &configuration.state()).unwrap();
            let x = rigidly_moved(&configuration, &mut stream);
            let displacement: Vec<f64> = x
                .iter()
                .zip(&configuration.reference)
                .map(|(x, r)| x - r)
                .collect();
            let state = State {
                displacement: &displacement,
                ..configuration.state()
            };
            let after = solve::energy(&configuration.pair, &state).unwrap();
            assert!(
                (after - before).abs() < 1e-11 * before,
                "{before:e} {after:e}"
            );
        }
    }
}

#[test]
fn swapping_slave_and_master_curve_changes_nothing() {
    let law = Law::Penalty { eps_n: 10.0 };
    let make = |slave, master| Pair {
        dimension: 3,
        slave: curve(slave),
        master: Master::Shape(Interpolation::new(master)),
        gap: GapKind::Distance,
        orientation: 1.0,
        r0: 0.0,
        law: law.clone(),
        tangential: None,
        angle: None,
        multipliers: Multipliers::None,
    };
    let configuration = closed(make(Shape::Line3, Shape::Line2), 0);
    let mut swapped = make(Shape::Line2, Shape::Line3);
    (swapped.r0, swapped.law) = (configuration.pair.r0, configuration.pair.law.clone());
    let x = configuration.positions();
    let turned: Vec<f64> = x[9..].iter().chain(&x[..9]).copied().collect();
    let zeros = vec![0.0; x.len()];
    let run = |pair: &Pair, x: &[f64]| {
        let state = State {
            reference: x,
            displacement: &zeros,
            start: Start::Search,
            friction: &[],
        };
        solve::evaluate(pair, &state).unwrap()
    };
    let (one, other) = (run(&configuration.pair, &x), run(&swapped, &turned));
    let n = x.len();
    let index = |i: usize| if i < 9 { i + 6 } else { i - 9 };
    for i in 0..n {
        assert!(
            (one.residual[i] - other.residual[index(i)]).abs()
                < 1e-12 * largest(one.residual.clone())
        );
        for j in 0..n {
            let difference = one.tangent[n * i + j] - other.tangent[n * index(i) + index(j)];
            assert!(difference.abs() < 1e-12 * largest(one.tangent.clone()));
        }
    }
}
