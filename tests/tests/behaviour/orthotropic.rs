//! Orthotropic friction on a plane: the traction on the ellipse, the slip along its normal.

use contact_elements::runtime::Status;

use crate::linear::newton;
use crate::pair::Pair;
use crate::vector::{degrees, difference, list, relative};

const EPS_N: f64 = 1e4;

fn plane(eps: [f64; 2], mu: [f64; 2], axis: [f64; 2]) -> Pair {
    let given = [
        ("eps_n", EPS_N),
        ("eps_1", eps[0]),
        ("eps_2", eps[1]),
        ("mu_1", mu[0]),
        ("mu_2", mu[1]),
        ("axis_1", axis[0]),
        ("axis_2", axis[1]),
    ];
    Pair::new("PointPlaneOrthotropic", &given)
}

/// Height at which the normal force is `force`.
fn height(force: f64) -> f64 {
    -force / EPS_N
}

/// Trial force, coefficients, normal force, result, and its derivatives: by the trial force, by N.
struct Mapped {
    trial: [f64; 2],
    mu: [f64; 2],
    normal: f64,
    t: [f64; 2],
    by_trial: [[f64; 2]; 2],
    by_normal: [f64; 2],
}

/// Exact results of the return to the ellipse at stiffnesses of 1000.
const MAPPED: [Mapped; 3] = [
    Mapped {
        trial: [3.0, 4.0],
        mu: [0.5, 0.5],
        normal: 8.0,
        t: [2.4, 3.2],
        by_trial: [[0.512, -0.384], [-0.384, 0.288]],
        by_normal: [0.3, 0.4],
    },
    Mapped {
        trial: [3.0, 4.0],
        mu: [0.3, 0.5],
        normal: 6.0,
        t: [1.0651116448415227, 2.4184115448086685],
        by_trial: [
            [0.1889623734308, -0.2311733464633],
            [-0.2311733464633, 0.2828135313120],
        ],
        by_normal: [0.2371529850671, 0.3301129098251],
    },
    Mapped {
        trial: [0.5, 0.2],
        mu: [0.3, 0.5],
        normal: 6.0,
        t: [0.5, 0.2],
        by_trial: [[1.0, 0.0], [0.0, 1.0]],
        by_normal: [0.0, 0.0],
    },
];

/// Force, slip path, new anchor and tangent of single points of the return map. 1e-12: digits of the
/// derivatives' answers (13); forces to 1e-13.
#[test]
fn returns_to_the_ellipse() {
    const EPS: f64 = 1000.0;
    let mut most = [0.0_f64; 2];
    for case in MAPPED {
        let mut pair = plane([EPS, EPS], case.mu, [1.0, 0.0]);
        let z = height(case.normal);
        pair.step(&[0.0, 0.0, z]);
        let slip = case.trial.map(|t| t / EPS);
        let state = pair.step(&[slip[0], slip[1], z]);
        most[0] = most[0].max(difference(&state.residual[..2], &case.t));
        let lost = [0, 1].map(|q| slip[q] - case.t[q] / EPS);
        assert!((pair.path() - lost[0].hypot(lost[1])).abs() < 1e-15);
        assert!(difference(pair.anchor(), &lost) < 1e-15);
        for q in 0..2 {
            let row = [state.k(q, 0) / EPS, state.k(q, 1) / EPS];
            most[1] = most[1].max(difference(&row, &case.by_trial[q]));
            let by_normal = -state.k(q, 2) / EPS_N;
            most[1] = most[1].max((by_normal - case.by_normal[q]).abs());
        }
    }
    println!(
        "ellipse: force {:.1e}, derivatives {:.1e}",
        most[0], most[1]
    );
    assert!(most[0] < 1e-13 * 8.0 && most[1] < 1e-12);
}

/// The point is drawn 30 times the elastic range in one direction: the force is the point of the ellipse
/// whose normal is that direction, t_q = μ_q² d_q N/|μ d|, whatever the stiffnesses and the axes.
#[test]
fn a_driven_point_feels_the_force_of_the_ellipse() {
    // direction of slip, coefficients, N, force along and across the first axis
    let known = (30.0_f64, [0.5, 0.2], 10.0);
    let expected = [4.8717735184622318, 0.45003516037040956];
    let mut most: f64 = 0.0;
    for eps in [[1e3, 1e3], [1e3, 4e3], [5e3, 1e3]] {
        for turn in [0.0_f64, 0.7, 2.5] {
            let (s, c) = turn.sin_cos();
            let mut pair = plane(eps, known.1, [3.0 * c, 3.0 * s]);
            let z = height(known.2);
            let direction = known.0.to_radians() + turn;
            let mut at = [0.0, 0.0, z];
            pair.step(&at);
            for _ in 0..400 {
                at[0] += 1e-3 * direction.cos();
                at[1] += 1e-3 * direction.sin();
                pair.step(&at);
            }
            let f = pair.at(&at).residual;
            let along = [c * f[0] + s * f[1], c * f[1] - s * f[0]];
            most = most.max(relative(&along, &expected));
        }
    }
    println!("ellipse: steady force of a driven point {most:.1e}, at 5.2778° to a slip at 30°");
    // the distance to the steady state shrinks by a factor in every step until it vanishes
    assert!(most < 1e-12);
}

/// Pulled by a force: it holds up to the critical force, and creeps, with a little viscosity, along the
/// normal of the ellipse beyond.
#[test]
fn a_pulled_point_creeps_along_the_normal_of_the_ellipse() {
    // direction of the force, coefficients, critical force, direction of the first slip
    let known = [
        (30.0_f64, [0.5, 0.2], 3.2879797461071458, 74.510450569186445),
        (60.0, [0.3, 0.3], 3.0, 60.0),
    ];
    let mut errors = vec![];
    for (angle, mu, critical, first) in known {
        let direction = [angle.to_radians().cos(), angle.to_radians().sin()];
        for excess in [-1e-10, 1e-4, 1e-6] {
            let force = critical * (1.0 + excess);
            let (statuses, slip) = pulled(mu, direction.map(|d| force * d));
            if excess < 0.0 {
                assert!(statuses.iter().all(|&status| status == Status::Stick));
                continue;
            }
            assert_eq!(statuses.last(), Some(&Status::Slip));
            let error = (degrees(&slip) - first).abs();
            errors.push(error);
            // the force on the ellipse differs from the pull by the viscous part: of order of the excess
            assert!(error < 500.0 * excess, "{error} degrees at {excess}");
        }
    }
    println!(
        "ellipse: direction of the first slip, degrees off at excess 1e-4, 1e-6: {}",
        list(&errors)
    );
}

/// Statuses on the way to the force, and the direction of the slip at the end.
fn pulled(mu: [f64; 2], force: [f64; 2]) -> (Vec<Status>, [f64; 2]) {
    /// Viscosity over the time step: a creep of 1e-6 per excess force of 1e-4.
    const VISCOUS: f64 = 100.0;
    let mut pair = plane([1e5, 1e5], mu, [1.0, 0.0]);
    let normal = 10.0;
    let mut x = vec![0.0, 0.0, height(normal)];
    pair.step(&x);
    let mut statuses = vec![];
    let mut creep = [0.0; 2];
    // loaded in ten steps, then held
    for step in 1..=30 {
        let share = (0.1 * f64::from(step)).min(1.0);
        let before = x.clone();
        let found = newton(x, 1e-13 * normal, |x| {
            let state = pair.at(x);
            let mut residual = state.residual.clone();
            let mut rows = state.rows();
            for q in 0..2 {
                residual[q] += VISCOUS * (x[q] - before[q]) - share * force[q];
                rows[q][q] += VISCOUS;
            }
            residual[2] += normal;
            (residual, rows)
        });
        x = found.expect("viscosity makes it regular");
        statuses.push(pair.step(&x).status());
        creep = [x[0] - before[0], x[1] - before[1]];
    }
    (statuses, creep)
}

/// Equal coefficients and stiffnesses are isotropic friction, whatever the axis: force, tangent, energy
/// and history, sticking and slipping. 1e-13: two formulas for the same numbers.
#[test]
fn equal_coefficients_are_isotropic() {
    let given = [("eps_n", EPS_N), ("eps_t", 3e3), ("mu", 0.4)];
    let mut most: f64 = 0.0;
    for step in 0..12 {
        let angle = 0.5 + 0.55 * f64::from(step);
        let axis = [2.0 * angle.cos(), 2.0 * angle.sin()];
        let mut isotropic = Pair::new("PointPlaneCoulomb", &given);
        let mut orthotropic = plane([3e3, 3e3], [0.4, 0.4], axis);
        let path = [[0.0, 0.0], [1e-4, 2e-4], [8e-4, 9e-4], [-5e-4, 1e-3]];
        for [x, y] in path {
            let at = [x, y, height(5.0)];
            let (a, b) = (isotropic.step(&at), orthotropic.step(&at));
            assert_eq!(a.outcome.status, b.outcome.status);
            most = most.max(relative(&b.residual, &a.residual));
            most = most.max(relative(&b.tangent, &a.tangent));
            most = most.max((b.energy / a.energy - 1.0).abs());
            most = most.max(difference(&b.history[3..], &a.history[3..]) / 1e-3);
        }
    }
    println!("ellipse: equal coefficients against isotropic friction {most:.1e}");
    assert!(most < 1e-13);
}
