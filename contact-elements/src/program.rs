//! What emitted code calls: the public door to tables and descriptions. Nothing inside the crate imports through it.

pub use crate::description::ElementDescription;
pub use crate::table::{
    AngleDescription, AxisDescription, ElementPrograms, GeometryPrograms, LawPrograms,
    MasterDescription, Operation, RollingDescription, SlaveDescription, Table as Program,
    TangentialLawPrograms, Term,
};
