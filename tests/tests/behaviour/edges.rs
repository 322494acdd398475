//! Sliding from facet to facet: the elastic slip goes along as a vector.

use contact_elements::{Entered, Left, Status, transfer};

use crate::pair::{Pair, Point, State};
use crate::vector::{Vector, add, difference, length, list, scaled, subtract};

const EPS_N: f64 = 1e4;
const EPS_T: f64 = 3e3;
const MU: f64 = 0.4;

fn pair(name: &str, mu: f64) -> Pair {
    Pair::new(name, &[("eps_n", EPS_N), ("eps_t", EPS_T), ("mu", mu)])
}

/// Facets side by side, a point that runs over them.
struct Row {
    facets: Vec<[Vector; 4]>,
    on: usize,
    pair: Pair,
    /// Position and state that were accepted.
    last: Option<(Vector, State)>,
    crossings: usize,
}

impl Row {
    fn new(facets: Vec<[Vector; 4]>, mu: f64) -> Self {
        Self {
            facets,
            on: 0,
            pair: pair("PointQuad4Coulomb", mu),
            last: None,
            crossings: 0,
        }
    }

    fn nodes(&self, facet: usize, x: Vector) -> Vec<f64> {
        let facet = self.facets[facet].iter().flatten();
        x.iter().chain(facet).copied().collect()
    }

    /// Moves the point to `x`, over an edge where it lies beyond; the force on the point, and the point.
    fn step(&mut self, x: Vector) -> (Vector, Point) {
        let here = self.pair.at(&self.nodes(self.on, x)).status();
        if here == Status::Outside {
            self.cross(x);
        }
        let state = self.pair.step(&self.nodes(self.on, x));
        let point = state.point(0);
        assert!(point.status.is_closed(), "{:?} at {x:?}", point.status);
        let force = [0, 1, 2].map(|k| state.residual[k]);
        self.last = Some((x, state));
        (force, point)
    }

    /// Goes on with the history of the accepted state on the facet that has `x`.
    fn cross(&mut self, x: Vector) {
        let (accepted, from) = self.last.as_ref().expect("it began inside");
        let mut fresh = self.pair.clone();
        fresh.history.clear();
        let closed = |facet: &usize| fresh.at(&self.nodes(*facet, x)).status().is_closed();
        let facet = (0..self.facets.len()).find(closed).expect("some facet");
        // the accepted position on the facet to come, a little beyond its edge
        let mut to = fresh.at(&self.nodes(facet, *accepted));
        let left = Left {
            element: self.pair.element,
            output: &from.output,
            history: &self.pair.history,
        };
        let entered = Entered {
            element: self.pair.element,
            output: &to.output,
            history: &mut to.history,
        };
        transfer(left, entered).expect("carried");
        self.pair.history = to.history;
        self.on = facet;
        self.crossings += 1;
    }
}

/// The largest difference of the force from that of a rigid plane, over the bound at `MU`, on a path to and
/// fro over the edges of coplanar facets.
fn off_the_plane(mut row: Row, mu: f64) -> f64 {
    let mut plane = pair("PointPlaneCoulomb", mu);
    let mut most: f64 = 0.0;
    for k in 0..=600 {
        let s = f64::from(k) / 600.0;
        let x = [
            1.5 - 1.2 * (9.0 * s).cos(),
            0.5 + 0.3 * (14.0 * s).sin(),
            -1e-3,
        ];
        let expected = plane.step(&x);
        let (f, point) = row.step(x);
        most = most.max(difference(&f, &expected.residual) / (MU * point.pressure));
    }
    assert_eq!(row.crossings, 6);
    most
}

/// Rectangles: their parameters are lengths, so the row is the plane to rounding, sliding with `MU` and
/// sticking throughout with much more, when the force grows to 800 bounds.
#[test]
fn a_row_of_rectangles_is_a_plane_to_rounding() {
    let at = |x: f64, y: f64| [x, y, 0.0];
    let ends = [0.0, 1.0, 1.7, 3.0];
    let facet = |k: usize| {
        let (a, b) = (ends[k], ends[k + 1]);
        // each facet counts its nodes from another corner
        let mut facet = [at(a, 0.0), at(b, 0.0), at(b, 1.0), at(a, 1.0)];
        facet.rotate_left(k);
        facet
    };
    let row = |mu: f64| Row::new((0..3).map(facet).collect(), mu);
    let slides = off_the_plane(row(MU), MU);
    let sticks = off_the_plane(row(1e6), 1e6);
    println!(
        "edges: rectangles, difference from a plane sliding {slides:.1e}, sticking {sticks:.1e}"
    );
    assert!(slides < 1e-12 && sticks < 1e-11);
}

/// Trapezoids: their parameters are no lengths, so b_i changes over the elastic slip, by (B/e)/facet = 1e-3.
#[test]
fn a_row_of_trapezoids_is_nearly_a_plane() {
    let lower = [0.0, 1.0, 1.7, 3.0].map(|x| [x, 0.0, 0.0]);
    let upper = [0.1, 0.9, 1.9, 3.0].map(|x| [x, 1.0, 0.0]);
    let facet = |k: usize| [lower[k], lower[k + 1], upper[k + 1], upper[k]];
    let most = off_the_plane(Row::new((0..3).map(facet).collect(), MU), MU);
    println!("edges: trapezoids, difference from a plane {most:.1e}");
    assert!(most < 2e-3);
}

/// Along a polygon of facets round a cylinder, at constant depth: |T| stays at the bound, and over an edge
/// T turns with the facet, by the angle between them.
#[test]
fn over_a_kink_the_traction_turns_with_the_facet() {
    let mut jumps = vec![];
    for count in [8_usize, 16, 32] {
        let turn = std::f64::consts::FRAC_PI_2 / count as f64;
        let (mut row, path) = polygon(count, turn);
        let mut last: Option<(Vector, usize)> = None;
        let (mut jump, mut bound): (f64, f64) = (0.0, 0.0);
        for (step, x) in path.into_iter().enumerate() {
            let (_, point) = row.step(x);
            if step > 60 {
                bound = bound.max((point.friction() / (MU * point.pressure) - 1.0).abs());
                if let Some((t, on)) = last.filter(|last| last.1 != row.on) {
                    assert_eq!(on + 1, row.on);
                    jump = jump.max(length(subtract(point.traction(), t)) / point.friction());
                }
                last = Some((point.traction(), row.on));
            }
        }
        assert_eq!(row.crossings, count - 1);
        // the bound is met in every step: |T| has no jump at all
        assert!(bound < 1e-12, "{bound}");
        assert!(jump < 1.01 * turn, "{jump} against {turn}");
        jumps.push(jump / turn);
    }
    println!(
        "edges: largest jump of T over its size and the kink {}, of |T| rounding",
        list(&jumps)
    );
}

/// `count` facets round a quarter of a cylinder of radius 1, and a path over them at depth 1e-3 that keeps
/// off the edges, where a point lies beyond both facets.
fn polygon(count: usize, turn: f64) -> (Row, Vec<Vector>) {
    let corner = |k: usize, y: f64| {
        let (s, c) = (turn * k as f64).sin_cos();
        [s, y, c]
    };
    let facet = |k: usize| {
        [
            corner(k, 0.0),
            corner(k + 1, 0.0),
            corner(k + 1, 2.0),
            corner(k, 2.0),
        ]
    };
    let facets: Vec<_> = (0..count).map(facet).collect();
    let steps = 40;
    let mut path = vec![];
    for k in 0..count {
        let across = subtract(facets[k][1], facets[k][0]);
        let normal = [
            (turn * (k as f64 + 0.5)).sin(),
            0.0,
            (turn * (k as f64 + 0.5)).cos(),
        ];
        for step in 0..steps {
            let s = (f64::from(step) + 0.5) / f64::from(steps);
            let along = (k as f64 + s) / count as f64;
            let foot = add(facets[k][0], scaled(s, across));
            path.push(add(
                add(foot, [0.0, 0.5 + along, 0.0]),
                scaled(-1e-3, normal),
            ));
        }
    }
    (Row::new(facets, MU), path)
}
