//! Ropes on rigid surfaces: the largest load that friction holds, node by node.
//!
//! A node of a rope of straight segments is pulled by the tensions on both sides. The rope lies on the
//! surface with half its thickness: r0 = p/eps_n, so that the node itself is on the surface.

use contact_elements::runtime::Status;

use crate::linear::bisect;
use crate::pair::Pair;
use crate::vector::{Vector, add, difference, dot, length, list, scaled, subtract, unit};

/// The node is on the surface whatever the stiffnesses: these let the pressure be the gap.
const EPS_N: f64 = 1.0;
const EPS_T: f64 = 1.0;

/// A curve on a surface.
struct Rope {
    surface: Pair,
    /// Point of the curve at a share of its length.
    curve: Box<dyn Fn(f64) -> Vector>,
}

impl Rope {
    /// Whether the node at `x` with the load of the rope can rest: friction on the element's bound or within.
    fn rests(&self, x: Vector, load: Vector) -> bool {
        let mut pair = self.surface.clone();
        pair.set("r0", 1e-9);
        let touching = pair.at(&x).point(0);
        let pressure = -dot(load, touching.normal);
        if pressure <= 0.0 {
            return false;
        }
        pair.set("r0", pressure / EPS_N);
        // the anchor that gives the tangential part of the load by sticking: dζ^i = −a^ij b_j·F/e
        let [b, c] = touching.b;
        assert!(dot(b, c).abs() < 1e-12 * length(b) * length(c));
        let [xi, eta] = touching.zeta;
        let moved = [b, c].map(|b| -dot(b, load) / (dot(b, b) * EPS_T));
        pair.history = vec![2.0, xi, eta, xi - moved[0], eta - moved[1], 0.0];
        let state = pair.at(&x);
        let rests = state.status() == Status::Stick;
        // then the contact carries the load
        assert!(!rests || difference(&state.residual, &load) < 1e-14);
        rests
    }

    /// Largest load over holding force of `nodes` nodes; `None` where not even equal tensions rest.
    fn limit(&self, nodes: usize) -> Option<f64> {
        let mut tension = 1.0;
        for k in 0..nodes {
            let at = |k: f64| (self.curve)((k + 0.5) / nodes as f64);
            let k = k as f64;
            let (before, x, after) = (at(k - 1.0), at(k), at(k + 1.0));
            let (from, to) = (unit(subtract(before, x)), unit(subtract(after, x)));
            let load = |ratio: f64| add(from, scaled(ratio, to));
            if !self.rests(x, load(1.0)) {
                return None;
            }
            tension *= bisect(1.0, 4.0, |ratio| self.rests(x, load(ratio))).0;
        }
        Some(tension)
    }
}

fn cylinder(mu: f64, radius: f64) -> Pair {
    let given = [
        ("eps_n", EPS_N),
        ("eps_t", EPS_T),
        ("mu", mu),
        ("radius", radius),
    ];
    Pair::new("PointCylinderCoulomb", &given)
}

/// `turns` round a cylinder of radius 1 on a helix at `angle` from the circumference.
fn helix(mu: f64, angle: f64, turns: f64) -> Rope {
    let rise = angle.tan();
    Rope {
        surface: cylinder(mu, 1.0),
        curve: Box::new(move |s| {
            let t = std::f64::consts::TAU * turns * s + 0.3;
            [t.cos(), t.sin(), rise * t]
        }),
    }
}

/// A circle: at each node, exactly (1 + μ tan(D/2))/(1 − μ tan(D/2)), D the turning angle; rounding of 128
/// factors.
#[test]
fn segments_round_a_cylinder_meet_the_limit_of_the_polygon() {
    let known = [
        (8, 2.6010497114471038),
        (32, 2.5684531176707676),
        (128, 2.5664647531438397),
    ];
    let continuum = 2.5663323952081353;
    let rope = helix(0.3, 0.0, 0.5);
    let mut errors = vec![];
    let mut most: f64 = 0.0;
    for (nodes, expected) in known {
        let limit = rope.limit(nodes).expect("it rests");
        most = most.max((limit / expected - 1.0).abs());
        errors.push(limit / continuum - 1.0);
    }
    let order = (errors[1] / errors[2]).log(4.0);
    println!(
        "rope: polygon limit {most:.1e}; against exp(μφ) {}, order {order:.4}",
        list(&errors)
    );
    assert!(most < 1e-12);
    assert!((order - 2.0).abs() < 0.01);
}

/// Euler and Eytelwein for other coefficients and turns: the polygon corrected by its order, from 32 and
/// 64 nodes per turn; the next order is four times 1/32⁴.
#[test]
fn the_limit_is_that_of_euler_and_eytelwein() {
    let known = [
        (0.1, 1.0, 1.8744560875853384),
        (0.2, 1.5, 6.5860619626947249),
        (0.3, 2.25, 69.487722503961397),
        (0.5, 1.0, 23.140692632779269),
    ];
    let mut most: f64 = 0.0;
    for (mu, turns, expected) in known {
        most = most.max((extrapolated(&helix(mu, 0.0, turns), turns) / expected - 1.0).abs());
    }
    println!("rope: Euler-Eytelwein, extrapolated {most:.1e}");
    assert!(most < 1e-4);
}

/// The logarithm of the limit, extrapolated from two numbers of nodes.
fn extrapolated(rope: &Rope, turns: f64) -> f64 {
    let logarithm = |per_turn: f64| {
        let nodes = (per_turn * turns) as usize;
        rope.limit(nodes).expect("it rests").ln()
    };
    let (coarse, fine) = (logarithm(32.0), logarithm(64.0));
    ((4.0 * fine - coarse) / 3.0).exp()
}

/// A helix is a geodesic: friction acts along the rope alone, exp(μ φ cos β), β its angle.
#[test]
fn a_helix_holds_by_its_polar_angle() {
    let known = [
        (0.3, 30.0_f64, 1.0, 5.1162381251275424),
        (0.2, 55.0, 2.0, 4.2272633223419385),
        (0.5, 10.0, 0.75, 10.179731154063250),
    ];
    let mut most: f64 = 0.0;
    for (mu, angle, turns, expected) in known {
        let rope = helix(mu, angle.to_radians(), turns);
        most = most.max((extrapolated(&rope, turns) / expected - 1.0).abs());
    }
    println!("rope: helix, extrapolated {most:.1e}");
    assert!(most < 1e-4);
}

/// Circles of latitude on a sphere (a torus whose tube fills it): off the equator friction must drag too,
/// ω = μ √(k_n² − k_g²/μ²), and where tan α = k_g/k_n passes μ no tension rests.
#[test]
fn circles_on_a_sphere_need_friction_across() {
    let given = [
        ("eps_n", EPS_N),
        ("eps_t", EPS_T),
        ("mu", 0.3),
        ("major", 1e-15),
        ("minor", 1.0),
    ];
    let known = [
        (90.0_f64, Some(6.5860619626947249)),
        (80.0, Some(4.4899077705743905)),
        (70.0, None),
    ];
    for (polar, expected) in known {
        let (r, z) = polar.to_radians().sin_cos();
        let rope = Rope {
            surface: Pair::new("PointTorusCoulomb", &given),
            curve: Box::new(move |s| {
                let t = std::f64::consts::TAU * s - 3.0;
                [r * t.cos(), r * t.sin(), z]
            }),
        };
        let Some(expected) = expected else {
            assert_eq!(rope.limit(64), None);
            continue;
        };
        let error = extrapolated(&rope, 1.0) / expected - 1.0;
        println!("rope: sphere at {polar}°, extrapolated {error:.1e}");
        assert!(error.abs() < 1e-4);
    }
}
