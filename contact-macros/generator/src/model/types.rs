//! The types of a checked declaration.

use std::rc::Rc;

use syn::Ident;

use super::expression::Expr;

/// Everything declared in one invocation, checked.
#[derive(Debug, Clone, Default)]
pub struct Model {
    /// Deformable and rigid geometries, in the order of their declaration.
    pub geometries: Vec<Rc<Geometry>>,
    /// Normal laws, in the order of their declaration.
    pub laws: Vec<Rc<Law>>,
    /// Tangential laws, in the order of their declaration.
    pub tangential_laws: Vec<Rc<TangentialLaw>>,
    /// Elements, in the order of their declaration.
    pub elements: Vec<Element>,
}

/// A curve, a surface or a distance function.
#[derive(Debug, Clone)]
pub struct Geometry {
    /// The name in the declaration.
    pub name: Ident,
    /// The doc comment, one line per line of the comment.
    pub docs: String,
    /// Parameters of the curve (1) or surface (2); the point (2 or 3) of a distance function.
    pub coordinates: Vec<Ident>,
    /// Run-time parameters (rigid geometries only).
    pub parameters: Vec<Parameter>,
    /// The range of the coordinates.
    pub domain: Domain,
    /// `let` bindings in order; each may use the coordinates, the parameters and earlier bindings.
    pub bindings: Vec<(Ident, Expr)>,
    /// What the geometry is.
    pub body: Body,
    /// Whether the declaration belongs to the library.
    pub built_in: bool,
}

impl Geometry {
    /// Nodes of a shape; a rigid geometry has none.
    pub fn nodes(&self) -> usize {
        match &self.body {
            Body::Shape { functions, .. } => functions.len(),
            _ => 0,
        }
    }

    /// Whether run-time weights apply to its shape functions.
    pub fn is_rational(&self) -> bool {
        matches!(self.body, Body::Shape { rational: true, .. })
    }
}

/// What a geometry is made of.
#[derive(Debug, Clone)]
pub enum Body {
    /// Interpolated between controls: `rho = sum_A N_A x_A`.
    Shape {
        /// One shape function per control.
        functions: Vec<Expr>,
        /// Ascending indices of the controls that are tangent vectors, not positions.
        vectors: Vec<usize>,
        /// Whether run-time weights apply: `N_A = w_A B_A / sum_B w_B B_B`.
        rational: bool,
    },
    /// A given position `rho(coordinates; parameters)`.
    Rigid {
        /// The 2 or 3 components of the position.
        position: Vec<Expr>,
        /// The closest point in closed form, if one was given.
        projection: Option<ClosedProjection>,
    },
    /// A given signed distance `d(x, y[, z]; parameters)`, positive outside.
    Distance {
        /// The distance.
        value: Expr,
    },
}

/// The closest point in closed form: coordinates of the geometry from a point in space.
#[derive(Debug, Clone)]
pub struct ClosedProjection {
    /// The names of the point's components, as many as the position has.
    pub coordinates: Vec<Ident>,
    /// One value per coordinate of the geometry; may use the point and the parameters (no bindings).
    pub values: Vec<Expr>,
}

/// A run-time parameter.
#[derive(Debug, Clone)]
pub struct Parameter {
    /// The name in the declaration.
    pub name: Ident,
    /// The unit, such as `force/length`; `1` if none was given.
    pub unit: String,
    /// Least admissible value, or negative infinity.
    pub lower: f64,
    /// Greatest admissible value, or infinity.
    pub upper: f64,
    /// Whether the bounds themselves are admissible.
    pub closed: bool,
}

/// The range of the coordinates of a geometry.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Domain {
    /// No bounds.
    Unbounded,
    /// One coordinate between two bounds. Of a rigid geometry, a bound may be infinite.
    Interval(f64, f64),
    /// Two coordinates between lower and upper bounds. Of a rigid geometry, a bound may be infinite.
    Rectangle([f64; 2], [f64; 2]),
    /// Two coordinates, each at least 0, with a sum of at most 1.
    Triangle,
}

/// A normal law `N(g; parameters)`, negative in contact.
#[derive(Debug, Clone)]
pub struct Law {
    /// The name in the declaration.
    pub name: Ident,
    /// The doc comment.
    pub docs: String,
    /// The name of the gap.
    pub gap: Ident,
    /// Run-time parameters.
    pub parameters: Vec<Parameter>,
    /// `let` bindings in order; each may use the gap, the parameters and earlier bindings.
    pub bindings: Vec<(Ident, Expr)>,
    /// The gaps at which there is contact.
    pub active: Bound,
    /// The gaps at which the law is defined; `None` for all gaps.
    pub valid: Option<Bound>,
    /// N.
    pub traction: Expr,
    /// W with `N = dW/dg`, if given.
    pub energy: Option<Expr>,
    /// Whether the declaration belongs to the library.
    pub built_in: bool,
}

/// A half line of gaps; the expression uses parameters only.
#[derive(Debug, Clone)]
pub enum Bound {
    /// `g < e`.
    Below(Expr),
    /// `g > e`.
    Above(Expr),
}

/// A tangential law: the stiffness of sticking and the bound of the tangential force, both per axis.
#[derive(Debug, Clone)]
pub struct TangentialLaw {
    /// The name in the declaration.
    pub name: Ident,
    /// The doc comment.
    pub docs: String,
    /// The name of the pressure p = −N.
    pub pressure: Ident,
    /// The name of the slip path.
    pub slip: Ident,
    /// Run-time parameters.
    pub parameters: Vec<Parameter>,
    /// `let` bindings in order; each may use the pressure, the slip, the parameters and earlier bindings.
    pub bindings: Vec<(Ident, Expr)>,
    /// One stiffness (isotropic) or one for each axis (orthotropic); parameters only.
    pub stiffness: Vec<Expr>,
    /// As many bounds; none where the law sticks always.
    pub bound: Vec<Expr>,
    /// Whether the declaration belongs to the library.
    pub built_in: bool,
}

/// The tangential law of an element.
#[derive(Debug, Clone)]
pub struct Tangential {
    /// The law.
    pub law: Rc<TangentialLaw>,
    /// The first axis of an orthotropic law.
    pub axis: Option<Axis>,
}

/// The moments of an element about its two curves.
#[derive(Debug, Clone)]
pub struct Rolling {
    /// The law of either moment: its slip is an angle.
    pub law: Rc<TangentialLaw>,
    /// What the angles are measured from.
    pub reference: Reference,
}

/// From where the angle of the shortest distance about a curve is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reference {
    /// The curve's principal normal.
    PrincipalNormal,
    /// A direction given at run time.
    Director,
}

/// Where the first axis of an orthotropic law points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Axis {
    /// Along wⁱ b_i: convected by the master.
    Convected,
    /// Along the slave curve, projected onto the tangent plane.
    Slave,
}

/// At which angles of two curves the contact acts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Angle {
    /// Large ones: the weight rises from zero to one over the window.
    Large,
    /// Small ones: the weight falls from one to zero over the window.
    Small,
}

/// A contact element: a pair, a law and the choices made for it.
#[derive(Debug, Clone)]
pub struct Element {
    /// The name in the declaration.
    pub name: Ident,
    /// The doc comment.
    pub docs: String,
    /// The declaration as written, in one line.
    pub declaration: String,
    /// Components of a position: 2 or 3.
    pub dimension: usize,
    /// Whose points are projected.
    pub slave: Slave,
    /// What they are projected onto.
    pub master: Master,
    /// The normal law.
    pub law: Rc<Law>,
    /// Tangential law; `None` if frictionless.
    pub tangential: Option<Tangential>,
    /// How the normal law holds the bodies apart.
    pub enforcement: Enforcement,
    /// Moments about two curves; `None` if they roll freely.
    pub rolling: Option<Rolling>,
    /// The angles of two curves at which it acts; `None` for all angles.
    pub angle: Option<Angle>,
    /// How the gap is measured.
    pub gap: Gap,
    /// Which linearisation of the gap the tangent uses.
    pub linearisation: Linearisation,
    /// Where the area of an integrated slave is measured.
    pub measure: Measure,
    /// Whether the tangent is left out.
    pub residual_only: bool,
    /// Whether a batch is evaluated in lanes.
    pub lanes: bool,
}

/// The side whose points are projected.
#[derive(Debug, Clone)]
pub enum Slave {
    /// One node.
    Point,
    /// A point of a host's own approximation: the row of shape functions comes at run time.
    Interpolated,
    /// A curve whose own coordinate is projected too.
    Projected(Rc<Geometry>),
    /// A curve or surface with integration points.
    Integrated {
        /// The curve or surface.
        geometry: Rc<Geometry>,
        /// Its integration points.
        rule: Rule,
    },
}

/// Integration points of a slave.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Rule {
    /// Gauss points: per direction of an interval or rectangle, in all on a triangle.
    Gauss(Vec<usize>),
    /// One point; its coordinates and its weight are run-time parameters.
    Given,
}

/// The side that is projected onto.
#[derive(Debug, Clone)]
pub enum Master {
    /// One node.
    Point,
    /// A deformable curve or surface.
    Shape(Rc<Geometry>),
    /// A rigid curve or surface; no unknowns.
    Rigid {
        /// The curve or surface.
        geometry: Rc<Geometry>,
        /// Whether a rigid motion given at run time applies to it.
        placed: bool,
    },
    /// A distance function; nothing is projected.
    Distance {
        /// The distance function.
        geometry: Rc<Geometry>,
        /// Whether a rigid motion given at run time applies to it.
        placed: bool,
    },
}

/// How the normal law holds the bodies apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Enforcement {
    /// By itself.
    Penalty,
    /// Beside a multiplier that the history carries.
    Augmented,
    /// Beside a multiplier that is an unknown.
    Multiplier,
}

/// How the gap is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Gap {
    /// Length of the shortest connection, less `r0`; no sign of its own.
    Distance,
    /// That length with a sign that is given: negative inside a re-entrant edge or vertex.
    Oriented,
    /// Along the normal of the pair, with a sign.
    Signed,
}

/// Which linearisation of the gap the tangent uses.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Linearisation {
    /// Exact at any gap.
    Exact,
    /// On the tangent plane: exact at zero gap only.
    TangentPlane,
}

/// Where the area or length of an integrated slave is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Measure {
    /// In the reference configuration.
    Reference,
    /// In the current configuration.
    Current,
}
