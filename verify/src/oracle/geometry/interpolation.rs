//! Geometries interpolated from nodes: `ρ(z) = Σ_A N_A(z) x_A`.

use std::sync::Arc;

use super::polynomials::{
    MAX_DEGREE, area_coordinates, bernstein, hermite, lagrange, triangle_quadratic,
};
use super::region::Region;
use crate::oracle::number::{Base, Number, ShapeEvaluator};

/// Most nodes that one side of a pair can have.
pub const MAX_NODES: usize = 27;

/// A family of shape functions.
///
/// Node order: corners first (counter-clockwise), then mid-sides in the same order, then the
/// centre. Bezier surfaces: first parameter fastest.
#[derive(Debug, Clone)]
pub enum Shape {
    /// A single node, no parameter.
    Point,
    /// Straight line on [-1, 1].
    Line2,
    /// Quadratic line on [-1, 1], nodes at -1, 1, 0.
    Line3,
    /// Cubic on [-1, 1] by P0, T0, P1, T1, where T = dρ/dξ is a direction, not a position.
    Hermite,
    /// Bezier curve of degree 1 to 4 on [0, 1].
    BezierCurve(usize),
    /// Linear triangle.
    Tri3,
    /// Quadratic triangle.
    Tri6,
    /// Bilinear facet on [-1, 1]².
    Quad4,
    /// Biquadratic facet on [-1, 1]².
    Quad9,
    /// Tensor-product Bezier surface of degree 1 to 4 on [0, 1]².
    BezierSurface(usize),
    /// Anything else.
    Declared(Arc<dyn ShapeEvaluator>),
}

impl Shape {
    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        match self {
            Self::Point => 1,
            Self::Line2 => 2,
            Self::Line3 | Self::Tri3 => 3,
            Self::Hermite | Self::Quad4 => 4,
            Self::Tri6 => 6,
            Self::Quad9 => 9,
            Self::BezierCurve(degree) => degree + 1,
            Self::BezierSurface(degree) => (degree + 1) * (degree + 1),
            Self::Declared(shape) => shape.node_count(),
        }
    }

    /// Number of parameters.
    pub fn parameters(&self) -> usize {
        match self {
            Self::Point => 0,
            Self::Line2 | Self::Line3 | Self::Hermite | Self::BezierCurve(_) => 1,
            Self::Tri3 | Self::Tri6 | Self::Quad4 | Self::Quad9 | Self::BezierSurface(_) => 2,
            Self::Declared(shape) => shape.parameter_count(),
        }
    }

    /// Range of the parameters.
    pub fn region(&self) -> Region {
        match self {
            Self::Point => Region::FREE,
            Self::Line2 | Self::Line3 | Self::Hermite => Region::interval(-1.0, 1.0),
            Self::BezierCurve(_) => Region::interval(0.0, 1.0),
            Self::Tri3 | Self::Tri6 => Region::TRIANGLE,
            Self::Quad4 | Self::Quad9 => Region::square(-1.0, 1.0),
            Self::BezierSurface(_) => Region::square(0.0, 1.0),
            Self::Declared(shape) => shape.parameter_region(),
        }
    }

    /// Whether a node is a position and not a direction.
    pub fn is_position(&self, node: usize) -> bool {
        match self {
            Self::Hermite => node.is_multiple_of(2),
            Self::Declared(shape) => shape.node_is_position(node),
            _ => true,
        }
    }

    /// What makes the shape unusable, if anything.
    pub fn defect(&self) -> Option<String> {
        match self {
            Self::BezierCurve(degree) | Self::BezierSurface(degree)
                if !(1..=MAX_DEGREE).contains(degree) =>
            {
                Some(format!(
                    "Bezier degree {degree} is not within 1 to {MAX_DEGREE}"
                ))
            }
            Self::Declared(shape) if shape.node_count() == 0 || shape.node_count() > MAX_NODES => {
                Some(format!(
                    "{} nodes are not within 1 to {MAX_NODES}",
                    shape.node_count()
                ))
            }
            Self::Declared(shape) if !(1..=2).contains(&shape.parameter_count()) => Some(format!(
                "{} parameters are neither 1 nor 2",
                shape.parameter_count()
            )),
            _ => None,
        }
    }

    /// Polynomial shape functions at `z`, into the first [`Self::nodes`] entries of `out`.
    #[inline]
    fn row<D: Number>(&self, z: [D; 2], out: &mut [D]) {
        match self {
            Self::Point => out[0] = D::one(),
            Self::Line2 => out[..2].copy_from_slice(&lagrange([-1.0, 1.0], z[0])),
            Self::Line3 => out[..3].copy_from_slice(&lagrange([-1.0, 1.0, 0.0], z[0])),
            Self::Hermite => out[..4].copy_from_slice(&hermite(z[0])),
            Self::BezierCurve(degree) => {
                out[..=*degree].copy_from_slice(&bernstein(*degree, z[0])[..=*degree]);
            }
            Self::Tri3 => out[..3].copy_from_slice(&area_coordinates(z)),
            Self::Tri6 => triangle_quadratic(z, &mut out[..6]),
            Self::Quad4 => {
                let ends = [-1.0, 1.0];
                tensor(&lagrange(ends, z[0]), &lagrange(ends, z[1]), &CORNERS, out);
            }
            Self::Quad9 => {
                let points = [-1.0, 1.0, 0.0];
                tensor(
                    &lagrange(points, z[0]),
                    &lagrange(points, z[1]),
                    &BIQUADRATIC,
                    out,
                );
            }
            Self::BezierSurface(degree) => {
                let (first, second) = (bernstein(*degree, z[0]), bernstein(*degree, z[1]));
                for j in 0..=*degree {
                    for i in 0..=*degree {
                        out[i + (degree + 1) * j] = first[i] * second[j];
                    }
                }
            }
            Self::Declared(shape) => D::shape_row(&**shape, z, out),
        }
    }
}

/// Position of each node in the one-dimensional point lists, `(first, second)`.
const CORNERS: [(usize, usize); 4] = [(0, 0), (1, 0), (1, 1), (0, 1)];
const BIQUADRATIC: [(usize, usize); 9] = [
    (0, 0),
    (1, 0),
    (1, 1),
    (0, 1),
    (2, 0),
    (1, 2),
    (2, 1),
    (0, 2),
    (2, 2),
];

#[inline]
fn tensor<D: Number>(first: &[D], second: &[D], order: &[(usize, usize)], out: &mut [D]) {
    for (entry, &(i, j)) in out.iter_mut().zip(order) {
        *entry = first[i] * second[j];
    }
}

/// A shape, and the weights that make it rational if there are any.
#[derive(Debug, Clone)]
pub struct Interpolation {
    /// The polynomial shape functions.
    pub shape: Shape,
    /// One positive weight per node: `N_A w_A / Σ N_B w_B`.
    pub weights: Option<Vec<f64>>,
}

impl Interpolation {
    /// Polynomial interpolation.
    pub fn new(shape: Shape) -> Self {
        Self {
            shape,
            weights: None,
        }
    }

    /// Rational interpolation.
    pub fn rational(shape: Shape, weights: Vec<f64>) -> Self {
        Self {
            shape,
            weights: Some(weights),
        }
    }

    /// Shape functions at `z`, into the first `nodes` entries of `out`.
    #[inline]
    pub fn row<D: Number>(&self, z: [D; 2], out: &mut [D]) {
        self.shape.row(z, out);
        if let Some(weights) = &self.weights {
            let mut total = D::zero();
            for (entry, &weight) in out.iter_mut().zip(weights) {
                *entry *= weight;
                total += *entry;
            }
            let factor = total.recip();
            for entry in out.iter_mut().take(weights.len()) {
                *entry *= factor;
            }
        }
    }

    /// Position and the derivatives with respect to the parameters, which come from nested duals.
    #[inline]
    pub fn evaluate<D: Base>(&self, z: [D; 2], nodes: &[[D; 3]]) -> ([D; 3], [[D; 3]; 2]) {
        match self.shape.nodes() {
            0..=4 => self.evaluate_within::<D, 4>(z, nodes),
            5..=9 => self.evaluate_within::<D, 9>(z, nodes),
            _ => self.evaluate_within::<D, MAX_NODES>(z, nodes),
        }
    }

    #[inline]
    fn evaluate_within<D: Base, const N: usize>(
        &self,
        z: [D; 2],
        nodes: &[[D; 3]],
    ) -> ([D; 3], [[D; 3]; 2]) {
        let (mut value, mut slopes) = ([D::zero(); 3], [[D::zero(); 3]; 2]);
        let count = self.shape.nodes();
        let mut row = [D::nest(D::zero(), D::zero()); N];
        for k in 0..self.shape.parameters().max(1) {
            let seed = |i: usize| D::nest(z[i], if i == k { D::one() } else { D::zero() });
            self.row([seed(0), seed(1)], &mut row);
            for (&entry, node) in row.iter().zip(&nodes[..count]) {
                let (shape, slope) = D::parts(entry);
                for c in 0..3 {
                    if k == 0 {
                        value[c] += shape * node[c];
                    }
                    slopes[k][c] += slope * node[c];
                }
            }
        }
        (value, slopes)
    }
}
