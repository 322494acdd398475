//! A patch of facets as the tests ask it: one or several slave points, and the way from one place to another.

use contact_elements::{Evaluation, Patch, Registered, evaluate_patch};

pub const EPS: f64 = 1e3;

/// What a patch gives for its slave points.
pub struct Found {
    pub status: i32,
    pub closed: i32,
    pub residual: Vec<f64>,
    pub tangent: Vec<f64>,
    pub output: Vec<f64>,
    pub energy: f64,
    pub history: Vec<f64>,
}

impl Found {
    pub fn feature(&self) -> f64 {
        self.output[10]
    }

    pub fn gap(&self) -> f64 {
        self.output[1]
    }
}

/// Facets with their edges and vertices, and their nodes.
pub struct Surface {
    pub facets: Patch<'static>,
    pub nodes: Vec<f64>,
    pub parameters: Vec<f64>,
}

impl Surface {
    pub fn new(
        [facet, edge, vertex]: [Option<&'static Registered>; 3],
        nodes: Vec<f64>,
        connectivity: &'static [i32],
        r0: f64,
    ) -> Self {
        let facet = facet.expect("a facet");
        let master_nodes = nodes.len() / facet.dimension;
        let mut parameters = vec![EPS, r0];
        parameters.extend(facet.layout.orientation.map(|_| 1.0));
        Self {
            facets: Patch {
                facet,
                edge,
                vertex,
                slave_points: 1,
                master_nodes,
                connectivity,
                reach: 0.0,
            },
            nodes,
            parameters,
        }
    }

    pub fn evaluate(&self, points: &[f64], history: &[f64]) -> Found {
        let d = self.facets.facet.dimension;
        let facets = Patch {
            slave_points: points.len() / d,
            ..self.facets
        };
        let x = [points, &self.nodes].concat();
        let n = x.len();
        let sizes = facets.sizes();
        let mut found = Found {
            status: 0,
            closed: 0,
            residual: vec![f64::NAN; n],
            tangent: vec![f64::NAN; n * n],
            output: vec![f64::NAN; sizes.output],
            energy: 0.0,
            history: vec![f64::NAN; sizes.history],
        };
        let mut energy = [f64::NAN];
        let result = evaluate_patch(
            &facets,
            &mut Evaluation {
                x: &x,
                parameters: &self.parameters,
                history,
                residual: &mut found.residual,
                tangent: &mut found.tangent,
                output: &mut found.output,
                trial: &mut found.history,
                energy: &mut energy,
                workspace: &mut vec![0.0; sizes.workspace],
                ..Evaluation::default()
            },
        );
        let summary = result.unwrap_or_else(|error| panic!("{error} at {points:?}"));
        (found.status, found.energy) = (summary.status as i32, energy[0]);
        found.closed = summary.closed as i32;
        found
    }

    pub fn at(&self, point: &[f64]) -> Found {
        self.evaluate(point, &[])
    }

    /// The largest jump of the force where the pair changes on the way from `a` to `b`, relative to the largest force,
    /// and the number of changes. Between the two neighbouring points of a change nothing but rounding lies.
    pub fn jumps(&self, a: &[f64], b: &[f64]) -> (f64, usize) {
        let between =
            |t: f64| -> Vec<f64> { (a.iter().zip(b)).map(|(a, b)| a + t * (b - a)).collect() };
        let key = |found: &Found| (found.history[1] as i64, found.history[2] as i64);
        let (mut worst, mut count) = (0.0_f64, 0);
        let steps = 200;
        for step in 0..steps {
            let (mut low, mut high) = (
                f64::from(step) / f64::from(steps),
                f64::from(step + 1) / f64::from(steps),
            );
            let (first, last) = (self.at(&between(low)), self.at(&between(high)));
            if key(&first) == key(&last) {
                continue;
            }
            for _ in 0..80 {
                let middle = 0.5 * (low + high);
                if middle <= low || middle >= high {
                    break;
                }
                if key(&self.at(&between(middle))) == key(&first) {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            let (before, after) = (self.at(&between(low)), self.at(&between(high)));
            let jump = difference(&before.residual, &after.residual);
            let kind = [&before, &after].map(|found| match found.feature() as i32 {
                0 => "facet",
                1..=4 => "edge",
                _ => "vertex",
            });
            println!("{} to {}: jump of the force {jump:.1e}", kind[0], kind[1]);
            worst = worst.max(jump);
            count += 1;
        }
        (worst, count)
    }
}

/// Largest difference relative to the largest entry.
pub fn difference(a: &[f64], b: &[f64]) -> f64 {
    let top = a.iter().chain(b).fold(0.0_f64, |top, v| top.max(v.abs()));
    let worst = a
        .iter()
        .zip(b)
        .fold(0.0_f64, |w, (a, b)| w.max((a - b).abs()));
    if worst == 0.0 { 0.0 } else { worst / top }
}
