//! A block on an inclined rigid plane: it rests while tan α ≤ μ and slides with g (sin α − μ cos α) beyond.

use contact_elements::runtime::Status;

use crate::linear::{bisect, newton};
use crate::pair::Pair;
use crate::vector::{Vector, add, difference, dot, scaled, turned};

const WEIGHT: f64 = 3.0;
const GRAVITY: f64 = 9.81;
const EPS_N: f64 = 1e5;
const EPS_T: f64 = 4e4;
/// The plane is tilted about this horizontal axis: nothing is aligned with the coordinates.
const AXIS: Vector = [0.6, 0.8, 0.0];

/// The block on a plane of angle `alpha`, contact just begun with the normal force in balance.
struct Block {
    pair: Pair,
    normal: Vector,
    /// Down the slope.
    down: Vector,
    x: Vector,
}

fn block(alpha: f64, mu: f64) -> Block {
    let given = [("eps_n", EPS_N), ("eps_t", EPS_T), ("mu", mu)];
    let mut pair = Pair::new("PointPlaneCoulomb", &given);
    pair.place_turned(AXIS, alpha);
    let normal = turned([0.0, 0.0, 1.0], AXIS, alpha);
    let down = turned([0.8, -0.6, 0.0], AXIS, alpha);
    let x = scaled(-WEIGHT * alpha.cos() / EPS_N, normal);
    pair.step(&x);
    Block {
        pair,
        normal,
        down,
        x,
    }
}

impl Block {
    /// R minus the weight: minus the force that accelerates the block.
    fn unbalanced(&self, x: &[f64]) -> Vec<f64> {
        let residual = self.pair.at(x).residual;
        let load = [0.0, 0.0, -WEIGHT];
        residual
            .iter()
            .zip(load)
            .map(|(r, load)| r - load)
            .collect()
    }

    /// A position of rest, by Newton's method; 1e-14 of the weight is rounding of three forces.
    fn rest(&self) -> Option<Vec<f64>> {
        newton(self.x.to_vec(), 1e-14 * WEIGHT, |x| {
            (self.unbalanced(x), self.pair.at(x).rows())
        })
    }
}

/// The limit angle, between the last rest and the first slide. 1e-12: the tangential force at the limit
/// is made of coordinates with errors of 1e-16 and the stiffness, relative to the weight 1e-14.
#[test]
fn rests_up_to_the_angle_of_friction() {
    let mut most: f64 = 0.0;
    for mu in [0.05, 0.2, 0.5, 1.0, 2.5] {
        let (rest, slide) = bisect(0.0, 1.5, |alpha| block(alpha, mu).rest().is_some());
        for alpha in [rest, slide] {
            most = most.max((alpha.tan() / mu - 1.0).abs());
        }
    }
    println!("incline: |tan α/μ − 1| at the limit {most:.1e}");
    assert!(most < 1e-12);
}

/// At rest the block has moved by the elastic part alone, and the contact carries the weight.
#[test]
fn rest_is_the_elastic_displacement() {
    let (alpha, mu) = (0.4_f64, 0.5);
    let block = block(alpha, mu);
    let x = block.rest().expect("tan 0.4 < 0.5");
    let elastic = WEIGHT * alpha.sin() / EPS_T;
    let expected = add(block.x, scaled(elastic, block.down));
    assert!(difference(&x, &expected) < 1e-13 * elastic);
    assert_eq!(block.pair.at(&x).status(), Status::Stick);
}

/// The force left over while sliding, at any distance; rounding of the weight's components.
#[test]
fn slides_with_the_force_left_over() {
    let mut most: f64 = 0.0;
    for (alpha, mu) in [(0.3_f64, 0.1), (0.7, 0.5), (1.2, 2.0), (0.5, 0.0)] {
        let block = block(alpha, mu);
        let expected = WEIGHT * (alpha.sin() - mu * alpha.cos());
        for distance in [1e-3, 1.0, 1e3] {
            let x = add(block.x, scaled(distance, block.down));
            let f = scaled(-1.0, block.unbalanced(&x).try_into().expect("three"));
            assert_eq!(block.pair.at(&x).status(), Status::Slip);
            most = most.max((dot(f, block.down) - expected).abs() / WEIGHT);
            // coordinates of 1e3 carry the gap with an error of 1e-13, times the penalty
            let depth = 1e-13 * distance.max(1.0) * EPS_N;
            assert!(dot(f, block.normal).abs() < depth);
            assert!((dot(f, block.down) - expected).abs() < (1.0 + mu) * depth);
        }
    }
    println!(
        "incline: unbalanced force, up to 1000 lengths away, relative to the weight {most:.1e}"
    );
}

/// The path of a block let go at the limit of its elastic part is a t²/2: the force is constant, which the
/// steps of Verlet's rule integrate exactly.
#[test]
fn accelerates_as_a_sliding_block() {
    let (alpha, mu) = (0.6_f64, 0.3);
    let mut block = block(alpha, mu);
    let mass = WEIGHT / GRAVITY;
    let elastic = mu * WEIGHT * alpha.cos() / EPS_T;
    let start = add(block.x, scaled(elastic, block.down));
    let (steps, dt) = (1000, 1e-3);
    let mut x = start;
    let mut v = [0.0; 3];
    for step in 0..steps {
        let force: Vector = block.unbalanced(&x).try_into().expect("three");
        block.pair.step(&x);
        // half a kick at the start
        let kick = if step == 0 { 0.5 * dt } else { dt };
        v = add(v, scaled(-kick / mass, force));
        x = add(x, scaled(dt, v));
    }
    let t = dt * f64::from(steps);
    let expected = 0.5 * GRAVITY * (alpha.sin() - mu * alpha.cos()) * t * t;
    let path = dot(add(x, scaled(-1.0, start)), block.down);
    println!(
        "incline: path of a sliding block against a t²/2 {:.1e}",
        path / expected - 1.0
    );
    // the normal spring keeps rounding of the gap swinging: 1e-16·eps_n/weight·μ
    assert!((path / expected - 1.0).abs() < 1e-10);
    // the path in the history lags by one step
    let last = dot(scaled(dt, v), block.down);
    assert!((block.pair.path() / (path - last) - 1.0).abs() < 1e-10);
}
