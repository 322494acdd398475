//! The types of a declaration as written.

use std::fmt;

use proc_macro2::Span;
use syn::{Ident, LitStr};

/// A sequence of items, with the mistakes that were found while reading it.
///
/// Reading never stops at a mistake: it goes on with the next statement or item.
#[derive(Debug, Clone)]
pub struct File {
    /// The items that could be read, in order.
    pub items: Vec<Item>,
    /// Names of items that could not be read: mentioning them is no further mistake.
    pub broken: Vec<Ident>,
    /// What could not be read.
    pub mistakes: Vec<syn::Error>,
}

/// One declaration.
#[derive(Debug, Clone)]
pub enum Item {
    /// A curve, a surface or a distance function.
    Geometry(GeometryItem),
    /// A normal law.
    Law(LawItem),
    /// A tangential law.
    TangentialLaw(LawItem),
    /// A contact element.
    Element(ElementItem),
}

/// The kinds of geometries.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GeometryKind {
    /// `surface`.
    Surface,
    /// `curve`.
    Curve,
    /// `rigid surface`.
    RigidSurface,
    /// `rigid curve`.
    RigidCurve,
    /// `rigid distance`.
    Distance,
}

/// `surface Name(xi, eta) in square { .. }` and its kin.
#[derive(Debug, Clone)]
pub struct GeometryItem {
    /// The doc comment.
    pub docs: String,
    /// The kind.
    pub kind: GeometryKind,
    /// The name.
    pub name: Ident,
    /// Coordinates and parameters.
    pub head: Head,
    /// What follows `in`.
    pub domain: Option<Domain>,
    /// The word `rational`.
    pub rational: Option<Ident>,
    /// The block.
    pub body: Body,
}

/// `normal law Name(g; ..) { .. }` or `tangential law Name(pressure, slip; ..) { .. }`.
#[derive(Debug, Clone)]
pub struct LawItem {
    /// The doc comment.
    pub docs: String,
    /// The name.
    pub name: Ident,
    /// Gap, or pressure and slip, and parameters.
    pub head: Head,
    /// The block.
    pub body: Body,
}

/// `element Name { .. }`.
#[derive(Debug, Clone)]
pub struct ElementItem {
    /// The doc comment.
    pub docs: String,
    /// The name.
    pub name: Ident,
    /// The entries that could be read.
    pub entries: Vec<Entry>,
    /// Whether all entries could be read.
    pub complete: bool,
}

impl fmt::Display for ElementItem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "element {} {{", self.name)?;
        for entry in &self.entries {
            write!(f, " {entry};")?;
        }
        write!(f, " }}")
    }
}

/// `(coordinates; parameters)`.
#[derive(Debug, Clone)]
pub struct Head {
    /// The names before the semicolon.
    pub coordinates: Vec<Ident>,
    /// The parameters after it.
    pub parameters: Vec<Parameter>,
}

/// `name: "unit" in (lower, upper)`.
#[derive(Debug, Clone)]
pub struct Parameter {
    /// The name.
    pub name: Ident,
    /// The unit.
    pub unit: Option<LitStr>,
    /// The bounds, and whether they belong to the range.
    pub range: Option<([Bound; 2], bool)>,
}

/// A number, possibly infinite, possibly negated.
#[derive(Debug, Clone, Copy)]
pub struct Bound {
    /// The value.
    pub value: f64,
    /// Where it stands.
    pub span: Span,
}

/// `name` or `name(bounds)`.
#[derive(Debug, Clone)]
pub struct Domain {
    /// The name.
    pub name: Ident,
    /// The bounds, if there are brackets.
    pub bounds: Vec<Bound>,
}

/// The block of a geometry or law.
#[derive(Debug, Clone)]
pub struct Body {
    /// The statements that could be read.
    pub statements: Vec<Statement>,
    /// Whether all statements could be read.
    pub complete: bool,
}

/// One statement of a block.
#[derive(Debug, Clone)]
pub enum Statement {
    /// `let name = value;`.
    Let(Ident, Expr),
    /// `name = value;`.
    Field(Field),
}

/// `name = value;` or `name(arguments) = value;`.
#[derive(Debug, Clone)]
pub struct Field {
    /// The name.
    pub name: Ident,
    /// The names in brackets.
    pub arguments: Option<Vec<Ident>>,
    /// The value.
    pub value: Value,
}

/// What stands on the right of a field.
#[derive(Debug, Clone)]
pub enum Value {
    /// One expression.
    Expr(Expr),
    /// `[a, b, ..]`.
    List(Vec<Expr>),
    /// `a < b` or `a > b`.
    Comparison(Comparison),
}

/// `left < right` or `left > right`.
#[derive(Debug, Clone)]
pub struct Comparison {
    /// What is compared.
    pub left: Expr,
    /// How.
    pub relation: Relation,
    /// With what.
    pub right: Expr,
}

/// The two comparisons of the language.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Relation {
    /// `<`.
    Less,
    /// `>`.
    Greater,
}

/// `key: word at rule placed;`.
#[derive(Debug, Clone)]
pub struct Entry {
    /// The key.
    pub key: Ident,
    /// The word or number after the colon.
    pub word: Word,
    /// What follows `at`.
    pub rule: Option<Rule>,
    /// The word `placed`.
    pub placed: Option<Ident>,
}

impl fmt::Display for Entry {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.key, self.word)?;
        if let Some(rule) = &self.rule {
            write!(f, " at {rule}")?;
        }
        match &self.placed {
            Some(word) => write!(f, " {word}"),
            None => Ok(()),
        }
    }
}

/// A name or a whole number.
#[derive(Debug, Clone)]
pub enum Word {
    /// A name.
    Name(Ident),
    /// A whole number.
    Number(usize, Span),
}

impl fmt::Display for Word {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Word::Name(name) => name.fmt(f),
            Word::Number(value, _) => value.fmt(f),
        }
    }
}

/// `gauss(2, 2)` or `given`.
#[derive(Debug, Clone)]
pub struct Rule {
    /// The name.
    pub name: Ident,
    /// The numbers in brackets, each with its place.
    pub points: Option<Vec<(usize, Span)>>,
}

impl fmt::Display for Rule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.name.fmt(f)?;
        let Some(points) = &self.points else {
            return Ok(());
        };
        let points: Vec<String> = points.iter().map(|(count, _)| count.to_string()).collect();
        write!(f, "({})", points.join(", "))
    }
}

impl GeometryKind {
    /// The words of the language, for messages.
    pub fn describe(self) -> &'static str {
        match self {
            GeometryKind::Surface => "surface",
            GeometryKind::Curve => "curve",
            GeometryKind::RigidSurface => "rigid surface",
            GeometryKind::RigidCurve => "rigid curve",
            GeometryKind::Distance => "distance function",
        }
    }
}

impl Item {
    /// The name of the item.
    pub fn name(&self) -> &Ident {
        match self {
            Item::Geometry(item) => &item.name,
            Item::Law(item) | Item::TangentialLaw(item) => &item.name,
            Item::Element(item) => &item.name,
        }
    }
}

impl Word {
    /// Where the word stands.
    pub fn span(&self) -> Span {
        match self {
            Word::Name(name) => name.span(),
            Word::Number(_, span) => *span,
        }
    }
}

/// An expression whose names have not been looked up.
#[derive(Debug, Clone)]
pub enum Expr {
    /// A literal.
    Number(f64, Span),
    /// A name.
    Name(Ident),
    /// `-x`, with the place of the sign.
    Negate(Box<Expr>, Span),
    /// `x op y`.
    Binary(BinaryOperator, Box<Expr>, Box<Expr>),
    /// `f(x, ..)`.
    Call(Ident, Vec<Expr>),
}

/// The four arithmetic operators.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BinaryOperator {
    /// `x + y`.
    Add,
    /// `x - y`.
    Subtract,
    /// `x * y`.
    Multiply,
    /// `x / y`.
    Divide,
}

impl Expr {
    /// Where the expression starts.
    pub fn span(&self) -> Span {
        match self {
            Expr::Number(_, span) | Expr::Negate(_, span) => *span,
            Expr::Name(name) | Expr::Call(name, _) => name.span(),
            Expr::Binary(_, x, _) => x.span(),
        }
    }
}
