//! Rows and vectors of one point of an interpreted element, from the tables of its geometries.

use contact_elements::table::{GeometryPrograms, MasterDescription, SlaveDescription};

use super::assembly::Assembly;
use crate::interpret::interpret;

/// Rows and vectors of one point.
pub(super) struct Point<const D: usize, const P: usize> {
    pub(super) s: Vec<f64>,
    pub(super) ds: [Vec<f64>; P],
    pub(super) r: [f64; D],
    pub(super) b: [[f64; D]; P],
    pub(super) second: Vec<[f64; D]>,
    /// s_A,ij
    pub(super) bend: Vec<Vec<f64>>,
}

impl<const D: usize, const P: usize> Assembly<'_, D, P> {
    /// N_A and its derivatives from a geometry's table.
    fn shape(&self, geometry: &GeometryPrograms, zeta: &[f64], weights: usize) -> Vec<f64> {
        let mut inputs = zeta.to_vec();
        inputs.extend_from_slice(self.parameters.get(weights..).unwrap_or(&[]));
        interpret(&geometry.values, &inputs, None)
    }

    /// Fixed row of the slave and the slopes that its measure needs.
    pub(super) fn slave(&self, number: usize) -> (Vec<f64>, Vec<Vec<f64>>, f64) {
        let layout = &self.subject.description.layout;
        match &self.subject.description.slave {
            SlaveDescription::Point => (vec![1.0], vec![], 1.0),
            SlaveDescription::Projected(_) => (vec![], vec![], 1.0),
            SlaveDescription::Interpolated => {
                let (weight, row) = self.slave_row.split_last().expect("a row and a weight");
                (row.to_vec(), vec![], *weight)
            }
            SlaveDescription::Given(geometry) => {
                let p = parameter_count(geometry);
                let at = &self.parameters[layout.point..];
                let values = self.shape(geometry, &at[..p], layout.slave_weights);
                (values[..width(geometry, p)].to_vec(), vec![], at[p])
            }
            SlaveDescription::Integrated(geometry, points) => {
                let p = parameter_count(geometry);
                let (eta, weight) = points[number];
                let values = self.shape(geometry, &eta[..p], layout.slave_weights);
                let n = width(geometry, p);
                let slopes = (0..p).map(|i| values[n * (1 + i)..n * (2 + i)].to_vec());
                (values[..n].to_vec(), slopes.collect(), weight)
            }
        }
    }

    /// Rows and vectors at ζ.
    pub(super) fn kinematics(&self, slave: &[f64], zeta: [f64; 2]) -> Point<D, P> {
        let n = self.x.len();
        let h = P * (P + 1) / 2;
        let mut point = Point {
            s: vec![0.0; n],
            ds: std::array::from_fn(|_| vec![0.0; n]),
            r: [0.0; D],
            b: [[0.0; D]; P],
            second: vec![[0.0; D]; h],
            bend: vec![],
        };
        let mut bend: Vec<Vec<f64>> = vec![vec![0.0; n]; h];
        point.s[..slave.len()].copy_from_slice(slave);
        let layout = &self.subject.description.layout;
        let two_curves = self.slave_curve(&mut point, &mut bend, zeta);
        let own = if two_curves { &zeta[1..] } else { &zeta[..] };
        let first = usize::from(two_curves);
        match &self.subject.description.master {
            MasterDescription::Point => point.s[n - 1] = -1.0,
            MasterDescription::Distance(_) => {}
            MasterDescription::Shape(geometry) => {
                let p = P - first;
                let values = self.shape(geometry, &own[..p], layout.master_weights);
                let m = width(geometry, p);
                let block = |row: usize| values[row * m..(row + 1) * m].iter().map(|v| -v);
                fill(&mut point.s[n - m..], block(0));
                for i in 0..p {
                    fill(&mut point.ds[first + i][n - m..], block(1 + i));
                }
                for k in 0..p * (p + 1) / 2 {
                    fill(
                        &mut bend[if two_curves { 2 } else { k }][n - m..],
                        block(1 + p + k),
                    );
                }
            }
            MasterDescription::Rigid(geometry) => {
                let p = P - first;
                let values = self.shape(geometry, &own[..p], layout.geometry);
                let block = |row: usize, k: usize| -values[row * D + k];
                for k in 0..D {
                    point.r[k] = block(0, k);
                    for i in 0..p {
                        point.b[first + i][k] = block(1 + i, k);
                    }
                    for j in 0..p * (p + 1) / 2 {
                        point.second[if two_curves { 2 } else { j }][k] = block(1 + p + j, k);
                    }
                }
            }
        }
        self.add_nodes(&mut point, &bend);
        self.add_excess(&mut point, slave);
        point.bend = bend;
        point
    }

    /// N_A,1 of a curve.
    pub(super) fn slopes(&self, geometry: &GeometryPrograms, eta: f64) -> Vec<f64> {
        let weights = self.subject.description.layout.slave_weights;
        let values = self.shape(geometry, &[eta], weights);
        let n = width(geometry, 1);
        values[n..2 * n].to_vec()
    }

    /// r_,111 … in the order of the tangential program.
    pub(super) fn third(&self, zeta: [f64; 2]) -> Vec<f64> {
        let count = if P == 0 { 0 } else { 3 * P - 2 };
        let mut third = vec![[0.0; D]; count];
        let layout = &self.subject.description.layout;
        let mut first = 0;
        if let SlaveDescription::Projected(geometry) = &self.subject.description.slave {
            first = 1;
            let values = self.thirds(geometry, &zeta[..1], layout.slave_weights);
            add_rows(&mut third[0], &values, &self.x, 1.0);
        }
        let n = self.x.len();
        match &self.subject.description.master {
            MasterDescription::Shape(geometry) => {
                let own = &zeta[first..P];
                let values = self.thirds(geometry, own, layout.master_weights);
                let m = width(geometry, own.len());
                for (row, values) in values.chunks_exact(m).enumerate() {
                    let to = &mut third[if first == 1 { 3 } else { row }];
                    add_rows(to, values, &self.x[n - m..], -1.0);
                }
            }
            MasterDescription::Rigid(geometry) => {
                let values = self.thirds(geometry, &zeta[first..P], layout.geometry);
                for (row, values) in values.chunks_exact(D).enumerate() {
                    let to = &mut third[if first == 1 { 3 } else { row }];
                    for k in 0..D {
                        to[k] -= values[k];
                    }
                }
            }
            MasterDescription::Point | MasterDescription::Distance(_) => {}
        }
        third.concat()
    }

    /// s_A,111 of a slave curve and s_A,222 of a master curve.
    pub(super) fn third_rows(&self, zeta: [f64; 2]) -> [Vec<f64>; 2] {
        let layout = &self.subject.description.layout;
        let n = self.x.len();
        let mut rows = [vec![0.0; n], vec![0.0; n]];
        if let (SlaveDescription::Projected(slave), MasterDescription::Shape(master)) = (
            &self.subject.description.slave,
            &self.subject.description.master,
        ) {
            let values = self.thirds(slave, &zeta[..1], layout.slave_weights);
            fill(&mut rows[0], values.into_iter());
            let values = self.thirds(master, &zeta[1..], layout.master_weights);
            let m = values.len();
            fill(&mut rows[1][n - m..], values.into_iter().map(|v| -v));
        }
        rows
    }

    fn thirds(&self, geometry: &GeometryPrograms, zeta: &[f64], weights: usize) -> Vec<f64> {
        let mut inputs = zeta.to_vec();
        inputs.extend_from_slice(self.parameters.get(weights..).unwrap_or(&[]));
        let third = geometry.third.as_ref();
        third.map_or(vec![], |third| interpret(third, &inputs, None))
    }

    /// Rows of a slave curve whose parameter is projected too.
    fn slave_curve(&self, point: &mut Point<D, P>, bend: &mut [Vec<f64>], zeta: [f64; 2]) -> bool {
        let SlaveDescription::Projected(geometry) = &self.subject.description.slave else {
            return false;
        };
        let values = self.shape(
            geometry,
            &zeta[..1],
            self.subject.description.layout.slave_weights,
        );
        let m = width(geometry, 1);
        point.s[..m].copy_from_slice(&values[..m]);
        point.ds[0][..m].copy_from_slice(&values[m..2 * m]);
        bend[0][..m].copy_from_slice(&values[2 * m..3 * m]);
        true
    }

    /// Nodes stand relative to a placed geometry's origin; a row that does not sum to one owes it the rest.
    fn add_excess(&self, point: &mut Point<D, P>, slave: &[f64]) {
        if self.subject.description.placed && !slave.is_empty() {
            let excess = slave.iter().sum::<f64>() - 1.0;
            let origin = self.placement.vector_to_local(&self.placement.origin);
            for (r, origin) in point.r.iter_mut().zip(origin) {
                *r += excess * origin;
            }
        }
    }

    fn add_nodes(&self, point: &mut Point<D, P>, bend: &[Vec<f64>]) {
        for (a, x) in self.x.iter().enumerate() {
            for k in 0..D {
                point.r[k] += point.s[a] * x[k];
                for i in 0..P {
                    point.b[i][k] += point.ds[i][a] * x[k];
                }
                for (second, bend) in point.second.iter_mut().zip(bend) {
                    second[k] += bend[a] * x[k];
                }
            }
        }
    }
}

/// to += factor Σ row_A x_A
fn add_rows<const D: usize>(to: &mut [f64; D], row: &[f64], x: &[[f64; D]], factor: f64) {
    for (value, x) in row.iter().zip(x) {
        for k in 0..D {
            to[k] += factor * value * x[k];
        }
    }
}

/// Copies as far as both reach.
pub(super) fn fill(to: &mut [f64], from: impl Iterator<Item = f64>) {
    for (to, from) in to.iter_mut().zip(from) {
        *to = from;
    }
}

/// Number of parameters of a geometry by shape functions: its inputs that are no weights.
fn parameter_count(geometry: &GeometryPrograms) -> usize {
    let is_weight = |name: &&&str| name.starts_with("weight_");
    geometry.values.inputs.len() - geometry.values.inputs.iter().filter(is_weight).count()
}

/// Number of shape functions.
fn width(geometry: &GeometryPrograms, p: usize) -> usize {
    geometry.values.outputs.len() / (1 + p + p * (p + 1) / 2)
}
