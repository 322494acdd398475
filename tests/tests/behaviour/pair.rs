//! A contact pair that is moved through configurations, its history accepted step by step.

use contact_elements::{Evaluation, OUTPUT_SIZE, Registered, Status, Summary, evaluate};
use contact_library::ELEMENTS;

use crate::vector::{Vector, add, cross, dot, scaled, unit};

/// An element with its parameters and its accepted history.
#[derive(Clone)]
pub struct Pair {
    pub element: &'static Registered,
    pub parameters: Vec<f64>,
    /// Empty: contact begins.
    pub history: Vec<f64>,
    /// Requests beyond the outputs.
    pub bits: u32,
}

/// What an evaluation gives.
#[derive(Clone, Debug)]
pub struct State {
    pub outcome: Summary,
    /// R: what the pair does to the nodes is −R.
    pub residual: Vec<f64>,
    /// K, row by row.
    pub tangent: Vec<f64>,
    pub energy: f64,
    /// Trial history.
    pub history: Vec<f64>,
    /// Output, point after point.
    pub output: Vec<f64>,
}

/// The output of one contact point.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    pub status: Status,
    pub gap: f64,
    /// p = −N
    pub pressure: f64,
    pub zeta: [f64; 2],
    pub normal: Vector,
    /// Components along d_1 and d_2.
    pub t: [f64; 2],
    pub b: [Vector; 2],
}

impl Pair {
    /// The built-in element `name`; parameters not given are zero.
    pub fn new(name: &str, given: &[(&str, f64)]) -> Self {
        let element = ELEMENTS
            .iter()
            .find(|element| element.name.trim_end_matches('\0') == name)
            .unwrap_or_else(|| panic!("no element {name}"));
        let mut pair = Self {
            element,
            parameters: vec![0.0; element.parameters.len()],
            history: vec![],
            bits: 0,
        };
        for &(name, value) in given {
            pair.set(name, value);
        }
        pair
    }

    /// Changes a parameter.
    pub fn set(&mut self, name: &str, value: f64) {
        let names = self.element.parameters.iter();
        let at = names
            .map(|parameter| parameter.name.trim_end_matches('\0'))
            .position(|other| other == name)
            .unwrap_or_else(|| panic!("no parameter {name}"));
        self.parameters[at] = value;
    }

    /// Turns a placed rigid geometry by `angle` about the unit vector `axis`.
    pub fn place_turned(&mut self, axis: Vector, angle: f64) {
        let (s, c) = (0.5 * angle).sin_cos();
        let names = ["quaternion_x", "quaternion_y", "quaternion_z"];
        self.set("quaternion_w", c);
        for (name, component) in names.into_iter().zip(axis) {
            self.set(name, s * component);
        }
    }

    /// The state at node positions `x`, slave nodes first. Nothing is accepted.
    pub fn at(&self, x: &[f64]) -> State {
        self.moved(x, &[])
    }

    /// The state at reference positions `x` and displacements `u`.
    pub fn moved(&self, x: &[f64], u: &[f64]) -> State {
        let element = self.element;
        let unknowns = element.unknowns(x.len() / element.dimension);
        let optional = |offered: bool, size: usize| vec![0.0; if offered { size } else { 0 }];
        let mut tangent = optional(element.tangent, unknowns * unknowns);
        let mut energy = optional(element.energy, 1);
        let mut residual = vec![0.0; unknowns];
        let mut output = vec![0.0; element.points * OUTPUT_SIZE];
        let mut history = vec![0.0; element.history()];
        let result = evaluate(
            element,
            &mut Evaluation {
                x,
                u,
                parameters: &self.parameters,
                history: &self.history,
                residual: &mut residual,
                tangent: &mut tangent,
                output: &mut output,
                trial: &mut history,
                energy: &mut energy,
                bits: self.bits,
                ..Evaluation::default()
            },
        );
        let outcome = result.unwrap_or_else(|error| panic!("{error} at {x:?}"));
        State {
            outcome,
            residual,
            tangent,
            energy: energy.first().copied().unwrap_or(0.0),
            history,
            output,
        }
    }

    /// The state at node positions `x`, accepted.
    pub fn step(&mut self, x: &[f64]) -> State {
        let state = self.at(x);
        self.history.clone_from(&state.history);
        state
    }

    /// The anchor in the history of the first point.
    pub fn anchor(&self) -> &[f64] {
        let p = self.element.projected;
        &self.history[1 + p..1 + 2 * p]
    }

    /// The slip path in the history of the first point.
    pub fn path(&self) -> f64 {
        self.history[1 + 2 * self.element.projected]
    }
}

impl State {
    /// Contact point `number`.
    pub fn point(&self, number: usize) -> Point {
        let output = &self.output[number * OUTPUT_SIZE..][..OUTPUT_SIZE];
        let vector = |at: usize| [output[at], output[at + 1], output[at + 2]];
        Point {
            status: match output[0] {
                0.0 => Status::Open,
                1.0 => Status::Closed,
                2.0 => Status::Stick,
                3.0 => Status::Slip,
                4.0 => Status::Outside,
                other => panic!("status {other}"),
            },
            gap: output[1],
            pressure: -output[2],
            zeta: [output[4], output[5]],
            normal: vector(6),
            t: [output[11], output[12]],
            b: [vector(13), vector(16)],
        }
    }

    /// Status of the first point.
    pub fn status(&self) -> Status {
        self.point(0).status
    }

    /// Entries (i, j) of the tangent.
    pub fn k(&self, i: usize, j: usize) -> f64 {
        self.tangent[i * self.residual.len() + j]
    }

    /// Rows of the tangent.
    pub fn rows(&self) -> Vec<Vec<f64>> {
        let rows = self.tangent.chunks(self.residual.len());
        rows.map(<[f64]>::to_vec).collect()
    }

    /// Force and moment about the origin that the residual exerts in 3D.
    pub fn resultant(&self, x: &[f64]) -> (Vector, Vector) {
        let mut sum = ([0.0; 3], [0.0; 3]);
        for (x, f) in x.chunks(3).zip(self.residual.chunks(3)) {
            let (x, f) = ([x[0], x[1], x[2]], [f[0], f[1], f[2]]);
            sum = (add(sum.0, f), add(sum.1, cross(x, f)));
        }
        sum
    }
}

impl Point {
    /// |T|
    pub fn friction(&self) -> f64 {
        self.t[0].hypot(self.t[1])
    }

    /// T as a vector, of isotropic friction: d_1 along b_1, d_2 = n × d_1.
    pub fn traction(&self) -> Vector {
        let first = unit(self.b[0]);
        let second = cross(self.normal, first);
        add(scaled(self.t[0], first), scaled(self.t[1], second))
    }

    /// T_i = T·b_i
    pub fn covariant(&self) -> [f64; 2] {
        self.b.map(|b| dot(self.traction(), b))
    }
}
