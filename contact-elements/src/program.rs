//! The programs of an element as constant tables: what a verifier interprets.
//!
//! Nothing in the kernels reads them, so a linker leaves them out of a library that only evaluates.

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
pub struct Program {
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
    pub values: Program,
    /// Third derivatives (none for distance functions).
    pub third: Option<Program>,
    /// Closed projection.
    pub projection: Option<Program>,
}

/// The programs of a normal law.
#[derive(Clone, Copy, Debug)]
pub struct LawPrograms {
    /// Name in the declaration.
    pub name: &'static str,
    /// g, parameters → N, N', W.
    pub law: Program,
    /// Positive where the law acts.
    pub active: Program,
    /// Positive where the law is defined; none: everywhere.
    pub valid: Option<Program>,
}

/// The programs of a tangential law.
#[derive(Clone, Copy, Debug)]
pub struct TangentialLawPrograms {
    /// Name in the declaration.
    pub name: &'static str,
    /// True for two axes.
    pub orthotropic: bool,
    /// Pressure, slip, parameters → stiffness, bound and its slopes.
    pub friction: Program,
    /// Force beyond the bound; none for a law that sticks always.
    pub sliding: Option<Program>,
}

/// First axis of an orthotropic tangential law.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AxisDescription {
    /// The law has none.
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
    pub layout: crate::runtime::RollingLayout,
    /// Angles about both curves.
    pub angle: Program,
    /// Coefficients of the residual.
    pub residual: Program,
    /// Coefficients of the tangent; none for residual-only elements.
    pub tangent: Option<Program>,
}

/// Weight by the angle of two curves as declared, with its programs.
#[derive(Clone, Copy, Debug)]
pub struct AngleDescription {
    /// True where the contact acts at small angles, false where at large ones.
    pub small: bool,
    /// Where `angle_low` stands in the parameters; `angle_high` follows.
    pub window: usize,
    /// Position in the window, and its rate.
    pub position: Program,
    /// w, w', w''.
    pub weight: Program,
    /// Form of the residual.
    pub residual: Program,
    /// Pairs of forms of the tangent; none for residual-only elements.
    pub tangent: Option<Program>,
}

/// The programs of an element.
#[derive(Clone, Copy, Debug)]
pub struct ElementPrograms {
    /// r, b_i → n, L, g.
    pub gap: Program,
    /// Coefficients of the tangent; none for residual-only elements.
    pub tangent: Option<Program>,
    /// Jacobian of the slave.
    pub measure: Option<Program>,
    /// Orthonormal frame and slip, with friction.
    pub frame: Option<Program>,
    /// Coefficients of the tangential residual, with friction.
    pub tangential_residual: Option<Program>,
    /// Coefficients of the tangential tangent, with friction.
    pub tangential_tangent: Option<Program>,
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

/// An element as declared, with its programs.
#[derive(Clone, Copy, Debug)]
pub struct ElementDescription {
    /// Name.
    pub name: &'static str,
    /// What the C interface knows.
    pub descriptor: &'static crate::abi::Descriptor,
    /// Its own programs.
    pub programs: &'static ElementPrograms,
    /// Slave.
    pub slave: SlaveDescription,
    /// Master.
    pub master: MasterDescription,
    /// Normal law.
    pub law: &'static LawPrograms,
    /// Tangential law; none: frictionless.
    pub tangential: Option<&'static TangentialLawPrograms>,
    /// First axis of an orthotropic tangential law.
    pub axis: AxisDescription,
    /// Moments about two curves; none: they roll freely.
    pub rolling: Option<&'static RollingDescription>,
    /// Weight by the angle of two curves; none: any angle.
    pub angle: Option<&'static AngleDescription>,
    /// True where a rigid geometry is placed by parameters.
    pub placed: bool,
    /// True for a gap with a sign.
    pub signed: bool,
    /// True for the linearisation on the tangent plane.
    pub tangent_plane: bool,
    /// True for the current measure.
    pub current: bool,
    /// False where no unknown turns the tangents.
    pub moving: bool,
    /// Parameter list.
    pub layout: crate::runtime::Layout,
}
