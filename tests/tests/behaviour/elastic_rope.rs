//! An elastic rope on a cylinder whose one end is pulled harder: it slides near that end and sticks beyond.

use contact_elements::runtime::Status;

use crate::linear::newton;
use crate::pair::Pair;
use crate::vector::list;

const MU: f64 = 0.2;
const HOLD: f64 = 1.0;
const LOAD: f64 = 1.6;
/// Strains of 1e-4: the closed form is that of small ones.
const EA: f64 = 1e4;
/// Elastic parts of 1e-10, beside displacements of 6e-5.
const EPS: f64 = 1e8;
const ARC: f64 = 3.0;

/// A rope of straight segments round a disc of radius 1, nodes at the middles of `count` equal arcs.
struct Model {
    nodes: Vec<[f64; 2]>,
    pairs: Vec<Pair>,
    /// Directions out of both ends.
    ends: [[f64; 2]; 2],
    rest_length: f64,
}

fn model(count: usize) -> Model {
    let h = ARC / count as f64;
    let place = |k: f64| [((k + 0.5) * h).cos(), ((k + 0.5) * h).sin()];
    let nodes: Vec<_> = (0..count).map(|k| place(k as f64)).collect();
    let direction = |from: f64, to: f64| {
        let (a, b) = (place(from), place(to));
        let length = (b[0] - a[0]).hypot(b[1] - a[1]);
        [(b[0] - a[0]) / length, (b[1] - a[1]) / length]
    };
    let last = (count - 1) as f64;
    let pressure = 2.0 * HOLD * (0.5 * h).sin();
    let given = [
        ("eps_n", EPS),
        ("eps_t", EPS),
        ("mu", MU),
        ("radius", 1.0),
        // nodes on the circle carry the initial tension
        ("r0", pressure / EPS),
    ];
    let mut pairs = vec![Pair::new("PointCircleCoulomb2d", &given); count];
    for (pair, x) in pairs.iter_mut().zip(&nodes) {
        pair.step(x);
    }
    Model {
        nodes,
        pairs,
        ends: [direction(0.0, -1.0), direction(last, last + 1.0)],
        rest_length: 2.0 * (0.5 * h).sin() / (1.0 + HOLD / EA),
    }
}

impl Model {
    /// Residual and derivative with the tensions HOLD and `load` at the ends.
    fn system(&self, x: &[f64], load: f64) -> (Vec<f64>, Vec<Vec<f64>>) {
        let n = x.len();
        let mut residual = vec![0.0; n];
        let mut rows = vec![vec![0.0; n]; n];
        for (k, pair) in self.pairs.iter().enumerate() {
            let state = pair.at(&x[2 * k..2 * k + 2]);
            for i in 0..2 {
                residual[2 * k + i] += state.residual[i];
                for j in 0..2 {
                    rows[2 * k + i][2 * k + j] += state.k(i, j);
                }
            }
        }
        for k in 0..self.pairs.len() - 1 {
            self.segment(k, x, &mut residual, &mut rows);
        }
        for i in 0..2 {
            residual[i] -= load * self.ends[0][i];
            residual[n - 2 + i] -= HOLD * self.ends[1][i];
        }
        (residual, rows)
    }

    /// Tension of the segment behind node k, EA times its strain, and its direction and length.
    fn tension(&self, k: usize, x: &[f64]) -> (f64, [f64; 2], f64) {
        let d = [x[2 * k + 2] - x[2 * k], x[2 * k + 3] - x[2 * k + 1]];
        let length = d[0].hypot(d[1]);
        let tension = EA * (length / self.rest_length - 1.0);
        (tension, d.map(|d| d / length), length)
    }

    fn segment(&self, k: usize, x: &[f64], residual: &mut [f64], rows: &mut [Vec<f64>]) {
        let (tension, d, length) = self.tension(k, x);
        for i in 0..2 {
            residual[2 * k + i] -= tension * d[i];
            residual[2 * k + 2 + i] += tension * d[i];
            for j in 0..2 {
                let same = if i == j { 1.0 } else { 0.0 };
                let value = (EA / self.rest_length - tension / length) * d[i] * d[j]
                    + tension / length * same;
                rows[2 * k + i][2 * k + j] += value;
                rows[2 * k + 2 + i][2 * k + 2 + j] += value;
                rows[2 * k + i][2 * k + 2 + j] -= value;
                rows[2 * k + 2 + i][2 * k + j] -= value;
            }
        }
    }

    /// Positions after the load was raised in `steps`.
    fn pulled(&mut self, steps: u32) -> Vec<f64> {
        let mut x = self.nodes.concat();
        for step in 1..=steps {
            let load = HOLD + (LOAD - HOLD) * f64::from(step) / f64::from(steps);
            // forces carry rounding of coordinates times the stiffness, 1e-8
            x = newton(x, 1e-7, |x| self.system(x, load)).expect("a rest");
            for (pair, x) in self.pairs.iter_mut().zip(x.chunks(2)) {
                pair.step(x);
            }
        }
        x
    }
}

/// T = T_load exp(−μφ) down to T_hold: slip angle ln(T_load/T_hold)/μ, pull (T_load − T_hold)/μ − T_hold φ_s
/// over EA. The slip angle to one node; the pull converges with the square of the segments until the
/// strain of 1e-4 shows.
#[test]
fn an_elastic_rope_slides_from_the_pulled_end() {
    let (slip_angle, pull) = (2.3500181462286778, 0.64998185377132223);
    let mut errors = vec![];
    for count in [15_usize, 30, 60] {
        let h = ARC / count as f64;
        let mut model = model(count);
        let x = model.pulled(8);
        let states = model
            .pairs
            .iter()
            .zip(x.chunks(2))
            .map(|(pair, x)| pair.at(x));
        let sliding = states.filter(|state| state.residual_is_at_bound()).count();
        assert!(
            (sliding as f64 * h - slip_angle).abs() <= 1.5 * h,
            "{sliding} nodes of {h}"
        );
        // displacement of the first node towards the end, and the half segment before it
        let moved = [0, 1].map(|i| (x[i] - model.nodes[0][i]) * model.ends[0][i]);
        let end = (moved[0] + moved[1]) * EA + (LOAD - HOLD) * 0.5 * h;
        errors.push(end / pull - 1.0);
    }
    println!(
        "elastic rope: pull of 15, 30, 60 nodes, relative error {}",
        list(&errors)
    );
    assert!(errors[2].abs() < 2e-3);
    assert!(errors[0].abs() > 3.0 * errors[1].abs());
}

impl crate::pair::State {
    /// Sliding, or resting where it slid.
    fn residual_is_at_bound(&self) -> bool {
        let point = self.point(0);
        point.status == Status::Slip || point.friction() > (1.0 - 1e-6) * MU * point.pressure
    }
}
