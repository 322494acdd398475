//! Two elastic cylinders pressed together and sheared: sliding edges round a sticking middle.
//!
//! The bodies are half planes: strips of constant stress and the logarithmic kernel, the same for normal and
//! tangential stress. The contact law of each strip is an element.

use crate::linear::newton;
use crate::pair::{Pair, State};
use crate::vector::list;

const PRESSING: f64 = 10.0;
const SHEARING: f64 = 0.93616;
const RADIUS: f64 = 4.0;
const MODULUS: f64 = 109.89010989010989;
const MU: f64 = 0.2;
const HALF_WIDTH: f64 = 0.68077837383659538;
const STRIPS: usize = 121;
const EPS: f64 = 1e6;

struct Cylinders {
    width: f64,
    /// Middles of the strips.
    at: Vec<f64>,
    pairs: Vec<Pair>,
}

impl Cylinders {
    fn new() -> Self {
        let width = 2.2 * HALF_WIDTH / STRIPS as f64;
        let at = (0..STRIPS).map(|i| width * (i as f64 + 0.5) - 1.1 * HALF_WIDTH);
        let given = [("eps_n", EPS), ("eps_t", EPS), ("mu", MU)];
        Self {
            width,
            at: at.collect(),
            pairs: vec![Pair::new("PointPlaneCoulomb", &given); STRIPS],
        }
    }

    /// Displacement of strip i by a unit force on strip j, but for a constant.
    fn compliance(&self, i: usize, j: usize) -> f64 {
        let h = 0.5 * self.width;
        let d = self.at[i] - self.at[j];
        let primitive = |y: f64| y * y.abs().ln() - y;
        let integral = primitive(d + h) - primitive(d - h);
        -2.0 / (std::f64::consts::PI * MODULUS) * integral / self.width
    }

    /// Solves y_i = free_i + shift − Σ C_ij f_j(y_j) with Σ f = `total`: f component `component` of the
    /// elements' residuals at `place`.
    fn solve(
        &self,
        start: f64,
        total: f64,
        component: usize,
        free: impl Fn(usize) -> f64,
        place: impl Fn(usize, f64) -> [f64; 3],
    ) -> Vec<State> {
        let n = STRIPS;
        let state = |y: &[f64], i: usize| self.pairs[i].at(&place(i, y[i]));
        let mut unknowns: Vec<f64> = (0..n).map(|i| free(i) + start).collect();
        unknowns.push(start);
        let found = newton(unknowns, 1e-11, |y| {
            let mut residual = vec![0.0; n + 1];
            let mut rows = vec![vec![0.0; n + 1]; n + 1];
            let states: Vec<_> = (0..n).map(|i| state(y, i)).collect();
            for i in 0..n {
                residual[i] = y[i] - free(i) - y[n];
                rows[i][i] = 1.0;
                rows[i][n] = -1.0;
                for (j, state) in states.iter().enumerate() {
                    let c = self.compliance(i, j);
                    residual[i] += c * state.residual[component];
                    rows[i][j] += c * state.k(component, component);
                }
                residual[n] += states[i].residual[component];
                rows[n][i] = states[i].k(component, component);
            }
            residual[n] -= total;
            (residual, rows)
        });
        let y = found.expect("an equilibrium");
        (0..n).map(|i| state(&y, i)).collect()
    }
}

/// Pressure and shear stress over the contact, at the places of the closed form. Strips of 1/55 of the half
/// width smear the edges of contact and of sticking.
#[test]
fn cylinders_slide_at_the_edges_of_contact() {
    let known = [
        (0.0, 0.50622893418304044),
        (0.3, 0.54082336526078363),
        (0.6, 0.72074162178372025),
        (0.7, 0.95271398716338672),
        (0.8, 1.1221621546757067),
        (0.9, 0.81523190508287729),
        (0.95, 0.58399170081901849),
    ];
    let (peak_pressure, peak) = (9.3513512889642223, 1.2795710627664752);
    let mut model = Cylinders::new();
    let at = model.at.clone();
    let pressed = model.solve(
        -0.06,
        -PRESSING,
        2,
        |i| at[i] * at[i] / (2.0 * RADIUS),
        |_, z| [0.0, 0.0, z],
    );
    let depth: Vec<f64> = pressed.iter().map(|state| state.point(0).gap).collect();
    for (pair, state) in model.pairs.iter_mut().zip(&pressed) {
        pair.history.clone_from(&state.history);
    }
    let sheared = model.solve(0.0, SHEARING, 0, |_| 0.0, |i, x| [x, 0.0, depth[i]]);
    let stress = |states: &[State], component: usize, x: f64| {
        let s = x * HALF_WIDTH / model.width + 0.5 * STRIPS as f64 - 0.5;
        let (i, share) = (s.floor() as usize, s.fract());
        let at = |i: usize| states[i].residual[component] / model.width;
        at(i) + share * (at(i + 1) - at(i))
    };
    let pressure = -stress(&pressed, 2, 0.0) / peak_pressure - 1.0;
    let errors = known.map(|(x, q)| (stress(&sheared, 0, x) - q) / peak);
    println!(
        "cylinders: largest pressure {pressure:.1e}, shear stress over its peak {}",
        list(&errors)
    );
    assert!(pressure.abs() < 1e-3);
    assert!(errors.iter().all(|error| error.abs() < 1e-2));
}
