//! Contact of two curves weighted by their angle: R = w N δg + W w' δq. [eq:angle-energy] [eq:angle-residual]
//!
//! q = sin²θ of the tangents u (slave) and v (master), each as long as its parameter makes it:
//!
//! ```text
//! q  = |τ_1×τ_2|² = 1 − c² ,   c = τ_1·τ_2 ,   τ_1 = u/|u| , τ_2 = v/|v|
//! δc = a_1·Du/|u| + a_2·Dv/|v| ,   a_1 = (τ_1×τ_2)×τ_1 = τ_2 − c τ_1 ,   a_2 = τ_2×(τ_1×τ_2) = τ_1 − c τ_2
//! Du = δr_,1 + r_,11 δζ¹ ,   δq = −2c δc
//! ```
//!
//! Regular at any angle: parallel, anti-parallel and crossing tangents alike.

use super::Kinematics;
use super::motion::Motion;
use crate::ir::{Graph, NodeId, Program, Unary, Vector};
use crate::model::Angle;

/// What is known of the two curves when the code is made.
#[derive(Clone, Debug)]
pub struct Bends {
    /// Space dimension and projected parameters of the pair.
    pub kinematics: Kinematics,
    /// Whether the third derivatives of slave and master can be non-zero.
    pub third: [bool; 2],
}

pub(super) const NO_CURVATURE: &str = "no projected curve has a second derivative";

/// u, v, θ_low, θ_high → x, dx/dq: where q = sin²θ lies in the window, 0 where the weight vanishes, 1 where it is
/// one. [eq:angle-window]
pub fn position_program(angle: Angle) -> Program {
    let mut program = Program::new("angle_position");
    let [u, v] = ["u", "v"].map(|name| program.input_vector(name, 3));
    let (low, high) = (program.input("angle_low"), program.input("angle_high"));
    let graph = &mut program.graph;
    let one = graph.constant(1.0);
    let [first, last] = [&u, &v].map(|tangent| {
        let length = tangent.norm(graph);
        let inverse = graph.divide(one, length);
        tangent.scale(graph, inverse)
    });
    let across = first.cross(graph, &last);
    let square = across.dot(graph, &across);
    let mut sine_of = |a: NodeId| graph.unary(Unary::Sin, a);
    let sines = [sine_of(low), sine_of(high)];
    // sin²θ_high − sin²θ_low, without cancellation
    let (apart, together) = (graph.subtract(high, low), graph.add(high, low));
    let (apart, together) = (
        graph.unary(Unary::Sin, apart),
        graph.unary(Unary::Sin, together),
    );
    let width = graph.multiply(apart, together);
    let rate = graph.divide(one, width);
    let limits = sines.map(|sine| graph.multiply(sine, sine));
    let (inside, rate) = match angle {
        Angle::Large => (graph.subtract(square, limits[0]), rate),
        Angle::Small => (graph.subtract(limits[1], square), graph.negate(rate)),
    };
    let position = graph.divide(inside, width);
    program.output("position", position);
    program.output("rate", rate);
    program
}

/// x in [0, 1], dx/dq → w = x³ (10 − 15 x + 6 x²), w' = dw/dq, w''. [eq:angle-weight]
pub fn weight_program() -> Program {
    let mut program = Program::new("angle_weight");
    let (x, rate) = (program.input("position"), program.input("rate"));
    let graph = &mut program.graph;
    let number = |graph: &mut Graph, value: f64| graph.constant(value);
    let (one, two) = (number(graph, 1.0), number(graph, 2.0));
    let (six, ten, fifteen) = (number(graph, 6.0), number(graph, 10.0), number(graph, 15.0));
    let (thirty, sixty) = (number(graph, 30.0), number(graph, 60.0));
    let square = graph.multiply(x, x);
    let inner = graph.multiply(six, x);
    let inner = graph.subtract(inner, fifteen);
    let inner = graph.multiply(x, inner);
    let inner = graph.add(inner, ten);
    let cube = graph.multiply(square, x);
    let weight = graph.multiply(cube, inner);
    // 30 x² (1 − x)² and 60 x (1 − x) (1 − 2x)
    let rest = graph.subtract(one, x);
    let both = graph.multiply(x, rest);
    let slope = graph.multiply(both, both);
    let slope = graph.multiply(thirty, slope);
    let slope = graph.multiply(slope, rate);
    let double = graph.multiply(two, x);
    let middle = graph.subtract(one, double);
    let curvature = graph.multiply(both, middle);
    let curvature = graph.multiply(sixty, curvature);
    let squared = graph.multiply(rate, rate);
    let curvature = graph.multiply(curvature, squared);
    let weight = program.term("angle-weight", weight, "");
    let slope = program.term("angle-slope", slope, "");
    let curvature = program.term("angle-curvature", curvature, "");
    program.output("weight", weight);
    program.output("slope", slope);
    program.output("curvature", curvature);
    program.settle_terms();
    program
}

/// The contact point, w', W → vectors of s_A, N^slave_A,1 and N^master_A,1 of W w' δq. [eq:angle-residual]
pub fn residual_program(bends: &Bends) -> Program {
    let mut program = Program::new("angle_residual");
    let pair = Pair::new(&mut program, bends, false);
    let slope = program.input("weight_slope");
    let energy = program.input("energy");
    let graph = &mut program.graph;
    let factor = graph.multiply(energy, slope);
    let factor = pair.by_cosine(graph, factor);
    let own = ["angle-slave", "angle-master"].map(|tag| program.term(tag, factor, ""));
    let shift = program.term("angle-shift", factor, NO_CURVATURE);
    let graph = &mut program.graph;
    let mut form = Motion::zero(graph);
    for (c, curve) in pair.curves.iter().enumerate() {
        let lever = graph.multiply(own[c], curve.inverse);
        let turned = curve.across.scale(graph, lever);
        form.turning[c] = form.turning[c].add(graph, &turned);
        let along = curve.bend(graph, &curve.second);
        let along = graph.multiply(shift, along);
        form.add_scaled(graph, along, &curve.shift);
    }
    form.output_lower(&mut program, "form");
    program.settle_terms();
    program
}

/// One curve at the contact point.
pub(super) struct Curve {
    pub(super) tau: Vector,
    /// 1/|u|
    pub(super) inverse: NodeId,
    /// a_c
    pub(super) across: Vector,
    /// r_,cc and r_,ccc where the curve is projected, else zero.
    pub(super) second: Vector,
    pub(super) third: Vector,
    /// δζ^c; zero for a fixed point of the slave.
    pub(super) shift: Motion,
}

impl Curve {
    /// a_c·v/|u|
    pub(super) fn bend(&self, graph: &mut Graph, vector: &Vector) -> NodeId {
        let along = self.across.dot(graph, vector);
        graph.multiply(along, self.inverse)
    }
}

/// Both curves, slave first.
pub(super) struct Pair {
    pub(super) n: Vector,
    /// r = L n
    pub(super) r: Vector,
    pub(super) cosine: NodeId,
    pub(super) curves: [Curve; 2],
    /// b_i of the projected parameters.
    pub(super) tangents: Vec<Vector>,
    /// m^ij, i and j over the projected parameters.
    pub(super) m: Vec<Vec<NodeId>>,
    /// Which curve a projected parameter belongs to.
    pub(super) projected: Vec<usize>,
}

/// u, v and, of the projected curves, the derivatives beyond.
struct Inputs {
    n: Vector,
    distance: NodeId,
    tangents: [Vector; 2],
    second: [Vector; 2],
    third: [Vector; 2],
}

impl Inputs {
    fn new(program: &mut Program, bends: &Bends, with_third: bool) -> Self {
        let n = program.input_vector("n", 3);
        let distance = program.input("distance");
        let tangents = ["u", "v"].map(|name| program.input_vector(name, 3));
        let first = 2 - bends.kinematics.projected();
        let mut of_projected = |name: &str, remains: [bool; 2]| {
            [0, 1].map(|c| {
                let vector = (c >= first).then(|| program.input_vector(&format!("{name}_{c}"), 3));
                match vector {
                    Some(vector) if remains[c] => vector,
                    _ => Vector::zero(&mut program.graph, 3),
                }
            })
        };
        let curved = &bends.kinematics.curved;
        let curved = match first {
            0 => [curved[0], curved[2]],
            _ => [false, curved[0]],
        };
        let second = of_projected("second", curved);
        let third = match with_third {
            true => of_projected("third", bends.third),
            false => [0, 1].map(|_| Vector::zero(&mut program.graph, 3)),
        };
        Self {
            n,
            distance,
            tangents,
            second,
            third,
        }
    }
}

impl Pair {
    /// n, L, u, v, r_,cc and, `with_third`, r_,ccc.
    pub(super) fn new(program: &mut Program, bends: &Bends, with_third: bool) -> Self {
        let Inputs {
            n,
            distance,
            tangents,
            second,
            third,
        } = Inputs::new(program, bends, with_third);
        let graph = &mut program.graph;
        let r = n.scale(graph, distance);
        let projected: Vec<usize> = (2 - bends.kinematics.projected()..2).collect();
        let m = inverse_of_f(graph, &r, &tangents, &second, &projected);
        let own: Vec<Vector> = projected.iter().map(|&c| tangents[c].clone()).collect();
        let shifts = shifts(graph, &r, &own, &m, &projected);
        let one = graph.constant(1.0);
        let [first, last] = [0, 1].map(|c| {
            let length = tangents[c].norm(graph);
            let inverse = graph.divide(one, length);
            (tangents[c].scale(graph, inverse), inverse)
        });
        let cosine = first.0.dot(graph, &last.0);
        let axis = first.0.cross(graph, &last.0);
        let across = [axis.cross(graph, &first.0), last.0.cross(graph, &axis)];
        let mut parts = [first, last].into_iter().zip(across).zip(shifts);
        let mut second = second.into_iter().zip(third);
        let curves = [0, 1].map(|_| {
            let (((tau, inverse), across), shift) = parts.next().expect("two curves");
            let (second, third) = second.next().expect("two curves");
            Curve {
                tau,
                inverse,
                across,
                second,
                third,
                shift,
            }
        });
        Self {
            n,
            r,
            cosine,
            curves,
            tangents: own,
            m,
            projected,
        }
    }

    /// −2c factor: the factor of δc where `factor` is that of δq.
    pub(super) fn by_cosine(&self, graph: &mut Graph, factor: NodeId) -> NodeId {
        let minus = graph.constant(-2.0);
        let double = graph.multiply(minus, self.cosine);
        graph.multiply(double, factor)
    }
}

/// m = F⁻¹, F_ij = a_ij + r·r_,ij with r_,12 = 0; det F from |b_1×b_2|², which keeps its digits where the tangents are
/// nearly parallel. [eq:F] [eq:det-F]
fn inverse_of_f(
    graph: &mut Graph,
    r: &Vector,
    tangents: &[Vector; 2],
    second: &[Vector; 2],
    projected: &[usize],
) -> Vec<Vec<NodeId>> {
    let one = graph.constant(1.0);
    let square = |graph: &mut Graph, c: usize| tangents[c].dot(graph, &tangents[c]);
    let bend = |graph: &mut Graph, c: usize| r.dot(graph, &second[c]);
    if let [only] = projected {
        let (a, h) = (square(graph, *only), bend(graph, *only));
        let f = graph.add(a, h);
        return vec![vec![graph.divide(one, f)]];
    }
    let (a11, a22) = (square(graph, 0), square(graph, 1));
    let (h11, h22) = (bend(graph, 0), bend(graph, 1));
    let (f11, f22) = (graph.add(a11, h11), graph.add(a22, h22));
    let f12 = tangents[0].dot(graph, &tangents[1]);
    let area = tangents[0].cross(graph, &tangents[1]);
    let area = area.dot(graph, &area);
    // det(a + h) = det a + a_11 h_22 + h_11 F_22
    let first = graph.multiply(a11, h22);
    let last = graph.multiply(h11, f22);
    let determinant = graph.add(area, first);
    let determinant = graph.add(determinant, last);
    let inverse = graph.divide(one, determinant);
    let mixed = graph.multiply(f12, inverse);
    let mixed = graph.negate(mixed);
    let (m11, m22) = (graph.multiply(f22, inverse), graph.multiply(f11, inverse));
    vec![vec![m11, mixed], vec![mixed, m22]]
}

/// δζ^i = −m^ij (b_j·δr + r·δr_,j) of both curves. [eq:variation]
fn shifts(
    graph: &mut Graph,
    r: &Vector,
    tangents: &[Vector],
    m: &[Vec<NodeId>],
    projected: &[usize],
) -> [Motion; 2] {
    [0, 1].map(|c| {
        let mut form = Motion::zero(graph);
        let Some(i) = projected.iter().position(|&owner| owner == c) else {
            return form;
        };
        for (j, &owner) in projected.iter().enumerate() {
            let minus = graph.negate(m[i][j]);
            let position = tangents[j].scale(graph, minus);
            form.position = form.position.add(graph, &position);
            form.turning[owner] = r.scale(graph, minus);
        }
        form
    })
}
