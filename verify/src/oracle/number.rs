//! The numbers everything is evaluated with, and the bridge to geometries known only at run time.
//!
//! [`Number`] is what a geometry or a law is evaluated with. [`Base`] adds one more level: a
//! [`Base::Nested`] number carries a derivative with respect to a parameter on top of a `Base`
//! number that already carries derivatives with respect to the unknowns.

use std::fmt::Debug;

use num_dual::{Dual, Dual64, DualNum, HyperDual64};

use super::geometry::region::Region;
use super::octuple::Octuple;

/// A number that takes doubles as constants: `f64`, [`Octuple`] or (nested) duals over either. It calls the method of an
/// evaluator that belongs to its type.
pub trait Number: DualNum<Primitive = f64> + Copy {
    /// Calls the method of a shape evaluator that belongs to this number type.
    fn shape_row(evaluator: &dyn ShapeEvaluator, z: [Self; 2], out: &mut [Self]);
    /// Calls the method of a parametric evaluator that belongs to this number type.
    fn surface_point(evaluator: &dyn SurfaceEvaluator, z: [Self; 2]) -> [Self; 3];
    /// Calls the method of a distance evaluator that belongs to this number type.
    fn distance(evaluator: &dyn DistanceEvaluator, x: [Self; 3]) -> Self;
}

/// A number for the unknowns, which can be nested once more for a derivative by a parameter.
pub trait Base: Number {
    /// `Dual<Self>`.
    type Nested: Number;
    /// `value + slope ε`.
    fn nest(value: Self, slope: Self) -> Self::Nested;
    /// `(value, slope)`.
    fn parts(nested: Self::Nested) -> (Self, Self);
}

/// Hands every number type, with the names of its methods, to a macro.
macro_rules! for_every_number {
    ($callback:ident) => {
        $callback! {
            f64, row_f64, point_f64, distance_f64;
            Dual64, row_dual, point_dual, distance_dual;
            HyperDual64, row_hyper, point_hyper, distance_hyper;
            Dual<Dual64>, row_nested_dual, point_nested_dual, distance_nested_dual;
            Dual<HyperDual64>, row_nested_hyper, point_nested_hyper, distance_nested_hyper;
            Dual<Dual<Dual64>>, row_twice_nested_dual, point_twice_nested_dual, distance_twice_nested_dual;
            Dual<Dual<HyperDual64>>, row_twice_nested_hyper, point_twice_nested_hyper, distance_twice_nested_hyper;
            Octuple, row_octuple, point_octuple, distance_octuple;
            Dual<Octuple>, row_dual_octuple, point_dual_octuple, distance_dual_octuple;
            Dual<Dual<Octuple>>, row_nested_octuple, point_nested_octuple, distance_nested_octuple;
            Dual<Dual<Dual<Octuple>>>, row_twice_nested_octuple, point_twice_nested_octuple, distance_twice_nested_octuple;
        }
    };
}
pub(super) use for_every_number;

macro_rules! numbers {
    ($($type:ty, $row:ident, $point:ident, $distance:ident;)*) => {
        /// A declared shape behind a pointer: one method per number type.
        pub trait ShapeEvaluator: Debug + Send + Sync {
            /// Number of nodes.
            fn node_count(&self) -> usize;
            /// Number of parameters.
            fn parameter_count(&self) -> usize;
            /// Range of the parameters.
            fn parameter_region(&self) -> Region;
            /// Whether a node is a position and not a direction.
            fn node_is_position(&self, node: usize) -> bool;
            /// Nodes of a typical geometry.
            fn node_template(&self) -> Vec<[f64; 3]>;
            $(
                /// Shape functions at `z`.
                fn $row(&self, z: [$type; 2], out: &mut [$type]);
            )*
        }
        /// A declared rigid curve or surface behind a pointer: one method per number type.
        pub trait SurfaceEvaluator: Debug + Send + Sync {
            /// Number of parameters.
            fn parameter_count(&self) -> usize;
            /// Range of the parameters.
            fn parameter_region(&self) -> Region;
            /// Parameters from which random states are drawn.
            fn parameter_window(&self) -> [[f64; 2]; 2];
            $(
                /// Position at `z`.
                fn $point(&self, z: [$type; 2]) -> [$type; 3];
            )*
        }
        /// A declared distance behind a pointer: one method per number type.
        pub trait DistanceEvaluator: Debug + Send + Sync {
            $(
                /// Distance of `x`.
                fn $distance(&self, x: [$type; 3]) -> $type;
            )*
        }
        $(impl Number for $type {
            #[inline]
            fn shape_row(evaluator: &dyn ShapeEvaluator, z: [Self; 2], out: &mut [Self]) {
                evaluator.$row(z, out);
            }
            #[inline]
            fn surface_point(evaluator: &dyn SurfaceEvaluator, z: [Self; 2]) -> [Self; 3] {
                evaluator.$point(z)
            }
            #[inline]
            fn distance(evaluator: &dyn DistanceEvaluator, x: [Self; 3]) -> Self {
                evaluator.$distance(x)
            }
        })*
    };
}
for_every_number!(numbers);

macro_rules! base {
    ($type:ty) => {
        impl Base for $type {
            type Nested = Dual<$type>;
            #[inline]
            fn nest(value: Self, slope: Self) -> Self::Nested {
                Dual::new(value, slope)
            }
            #[inline]
            fn parts(nested: Self::Nested) -> (Self, Self) {
                (nested.re, nested.eps)
            }
        }
    };
}
base!(f64);
base!(Dual64);
base!(HyperDual64);
base!(Dual<Dual64>);
base!(Dual<HyperDual64>);
base!(Octuple);
base!(Dual<Octuple>);
base!(Dual<Dual<Octuple>>);
