//! A declaration as written, with the place of everything in it.
//!
//! Nothing here knows what a name means or which entries an item has: that is the task of
//! [`crate::model`]. Keeping the two apart lets one build report mistakes of both kinds, and keeps
//! every message at the token that caused it.
//!
//! ```text
//! file       = item*
//! item       = doc* kind Name [head] [in domain] [rational] { statement* }     geometry or law
//!            | doc* element Name { entry* }
//! kind       = surface | curve | rigid surface | rigid curve | rigid distance
//!            | normal law | tangential law
//! head       = ( name,* [; parameter,*] )
//! parameter  = name [: "unit"] [in (bound, bound) | in [bound, bound]]
//! domain     = name [(bound,*)]
//! bound      = [-] number | [-] inf
//! statement  = let name = expression; | name [(name,*)] = value;
//! value      = expression [< expression | > expression] | [expression,*]
//! entry      = name : word [at rule] [placed];
//! rule       = name [(integer,*)]
//! expression = + - * / unary-minus, parentheses, numbers, names, name(expression,*)
//! ```

mod body;
mod expression;
mod head;
mod item;
mod parse;
#[cfg(test)]
mod tests;
mod token;

pub use item::{
    BinaryOperator, Body, Bound, Comparison, Domain, ElementItem, Entry, Expr, Field, File,
    GeometryItem, GeometryKind, Head, Item, LawItem, Parameter, Relation, Rule, Statement, Value,
    Word,
};
