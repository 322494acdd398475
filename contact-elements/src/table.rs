//! The programs of an element as constant tables: what a verifier interprets, and what global projection and patches
//! evaluate.
//!
//! The kernels read no table: they call the compiled functions.

/// One operation; operands are positions of earlier operations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Operation {
    /// A constant.
    Constant(f64),
    /// Entry of the input array.
    Input(u16),
    /// −a
    Negate(u16),
    /// a + b
    Add(u16, u16),
    /// a − b
    Subtract(u16, u16),
    /// a·b
    Multiply(u16, u16),
    /// a/b
    Divide(u16, u16),
    /// √a
    Sqrt(u16),
    /// sin a
    Sin(u16),
    /// cos a
    Cos(u16),
    /// tan a
    Tan(u16),
    /// eᵃ
    Exp(u16),
    /// ln a
    Ln(u16),
    /// aᵇ
    Pow(u16, u16),
    /// angle of (b, a)
    Atan2(u16, u16),
    /// a itself, the coefficient of the term with this number.
    Term(u16, u16),
}

/// One term of a linearisation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Term {
    /// Equation tag of the documentation.
    pub tag: &'static str,
    /// False where it vanishes identically and was left out.
    pub present: bool,
    /// Why it was left out; empty where present.
    pub reason: &'static str,
}

/// A straight-line program with the compiled function that it must agree with bit for bit.
#[derive(Clone, Copy, Debug)]
pub struct Table {
    /// Name of the emitted function.
    pub name: &'static str,
    /// Names of the inputs.
    pub inputs: &'static [&'static str],
    /// The operations in order.
    pub operations: &'static [Operation],
    /// Names and positions of the outputs.
    pub outputs: &'static [(&'static str, u16)],
    /// Terms of the linearisation.
    pub terms: &'static [Term],
    /// Arithmetic operations per call.
    pub cost: usize,
    /// The emitted function: inputs, outputs.
    pub compiled: fn(&[f64], &mut [f64]),
}

/// The programs of a geometry.
#[derive(Clone, Copy, Debug)]
pub struct GeometryPrograms {
    /// Name in the declaration.
    pub name: &'static str,
    /// Shape rows, rigid position or distance with their derivatives to second order.
    pub values: Table,
    /// Third derivatives; `None` for distance functions.
    pub third: Option<Table>,
    /// Closed projection.
    pub projection: Option<Table>,
}

/// The programs of a normal law.
#[derive(Clone, Copy, Debug)]
pub struct LawPrograms {
    /// Name in the declaration.
    pub name: &'static str,
    /// g, parameters → N, N', W.
    pub law: Table,
    /// Positive where the law acts.
    pub active: Table,
    /// Positive where the law is defined; `None` if it is defined everywhere.
    pub valid: Option<Table>,
}

/// The programs of a tangential law.
#[derive(Clone, Copy, Debug)]
pub struct TangentialLawPrograms {
    /// Name in the declaration.
    pub name: &'static str,
    /// True for two axes.
    pub orthotropic: bool,
    /// Pressure, slip, parameters → stiffness, bound and its slopes.
    pub friction: Table,
    /// Force beyond the bound; `None` for a law that always sticks.
    pub sliding: Option<Table>,
}

/// First axis of an orthotropic tangential law.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AxisDescription {
    /// The law has no axis.
    None,
    /// Along wⁱ b_i, w given at run time.
    Convected,
    /// Along the slave curve.
    Slave,
}

/// Moments about two curves as declared, with their programs.
#[derive(Clone, Copy, Debug)]
pub struct RollingDescription {
    /// The law of either moment.
    pub law: &'static TangentialLawPrograms,
    /// Where its parameters and the directors begin.
    pub layout: crate::point::motion::RollingLayout,
    /// Angles about both curves.
    pub angle: Table,
    /// Coefficients of the residual.
    pub residual: Table,
    /// Coefficients of the tangent; `None` for residual-only elements.
    pub tangent: Option<Table>,
}

/// Weight by the angle of two curves as declared, with its programs.
#[derive(Clone, Copy, Debug)]
pub struct AngleDescription {
    /// True where the contact acts at small angles, false where at large ones.
    pub small: bool,
    /// Where `angle_low` stands in the parameters; `angle_high` follows.
    pub window: usize,
    /// Position in the window, and its rate.
    pub position: Table,
    /// w, w', w''.
    pub weight: Table,
    /// Form of the residual.
    pub residual: Table,
    /// Pairs of forms of the tangent; `None` for residual-only elements.
    pub tangent: Option<Table>,
}

/// The programs of an element.
#[derive(Clone, Copy, Debug)]
pub struct ElementPrograms {
    /// r, b_i → n, L, g.
    pub gap: Table,
    /// Coefficients of the tangent; `None` for residual-only elements.
    pub tangent: Option<Table>,
    /// Jacobian of the slave.
    pub measure: Option<Table>,
    /// Orthonormal frame and slip, with friction.
    pub frame: Option<Table>,
    /// Coefficients of the tangential residual, with friction.
    pub tangential_residual: Option<Table>,
    /// Coefficients of the tangential tangent, with friction.
    pub tangential_tangent: Option<Table>,
}

/// Slave of an element as declared.
#[derive(Clone, Copy, Debug)]
pub enum SlaveDescription {
    /// One node.
    Point,
    /// Row given in the call.
    Interpolated,
    /// A curve whose parameter is projected too.
    Projected(&'static GeometryPrograms),
    /// Integration points: parameters and weight.
    Integrated(&'static GeometryPrograms, &'static [([f64; 2], f64)]),
    /// One point given by parameters.
    Given(&'static GeometryPrograms),
}

/// Master of an element as declared.
#[derive(Clone, Copy, Debug)]
pub enum MasterDescription {
    /// One node.
    Point,
    /// Curve or surface by shape functions.
    Shape(&'static GeometryPrograms),
    /// Rigid curve or surface.
    Rigid(&'static GeometryPrograms),
    /// Rigid distance function.
    Distance(&'static GeometryPrograms),
}
