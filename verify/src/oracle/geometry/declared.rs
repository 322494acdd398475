//! Geometries that a user declares at run time, to have their own elements proven.
//!
//! Implement one of the generic traits ([`DeclaredShape`], [`DeclaredSurface`],
//! [`DeclaredDistance`]); the evaluator traits, which the oracle stores behind a pointer, follow
//! by themselves.
//!
//! ```
//! use contact_verify::oracle::geometry::{DeclaredSurface, Region, RigidParametric};
//! use contact_verify::oracle::number::Number;
//! use std::sync::Arc;
//!
//! #[derive(Debug)]
//! struct Paraboloid;
//! impl DeclaredSurface for Paraboloid {
//!     fn parameters(&self) -> usize { 2 }
//!     fn region(&self) -> Region { Region::FREE }
//!     fn window(&self) -> [[f64; 2]; 2] { [[-1.0, 1.0]; 2] }
//!     fn point<D: Number>(&self, z: [D; 2]) -> [D; 3] {
//!         [z[0], z[1], (z[0] * z[0] + z[1] * z[1]) * 0.2]
//!     }
//! }
//! let master = RigidParametric::Declared(Arc::new(Paraboloid));
//! assert_eq!(master.point([1.0, 0.0])[2], 0.2);
//! ```

use std::fmt::Debug;

use num_dual::{Dual, Dual64, HyperDual64};

use super::region::Region;
use crate::oracle::number::{
    DistanceEvaluator, Number, ShapeEvaluator, SurfaceEvaluator, for_every_number,
};
use crate::oracle::octuple::Octuple;

/// A geometry interpolated from nodes, written once for all numbers.
pub trait DeclaredShape: Debug + Send + Sync {
    /// Number of nodes, at most [`super::MAX_NODES`].
    fn nodes(&self) -> usize;
    /// Number of parameters: 1 (curve) or 2 (surface).
    fn parameters(&self) -> usize;
    /// Range of the parameters.
    fn region(&self) -> Region;
    /// Whether a node is a position (moves with a translation) and not a direction.
    fn is_position(&self, node: usize) -> bool {
        let _ = node;
        true
    }
    /// Nodes of a typical geometry about two units long, curves along x, surfaces near z = 0:
    /// random states start from it.
    fn typical_nodes(&self) -> Vec<[f64; 3]>;
    /// Writes the shape functions at `z` into the first [`Self::nodes`] entries of `out`.
    fn row<D: Number>(&self, z: [D; 2], out: &mut [D]);
}

/// A rigid curve or surface `ρ(z)` in its own frame, written once for all numbers.
pub trait DeclaredSurface: Debug + Send + Sync {
    /// Number of parameters: 1 (curve) or 2 (surface).
    fn parameters(&self) -> usize;
    /// Range of the parameters.
    fn region(&self) -> Region;
    /// Parameters from which random states and searches for a start are drawn.
    fn window(&self) -> [[f64; 2]; 2];
    /// Position (length).
    fn point<D: Number>(&self, z: [D; 2]) -> [D; 3];
}

/// A rigid body given by a signed distance, positive outside, written once for all numbers.
pub trait DeclaredDistance: Debug + Send + Sync {
    /// Distance (length) of the point `x` in the body's own frame.
    fn distance<D: Number>(&self, x: [D; 3]) -> D;
}

macro_rules! evaluators {
    ($($type:ty, $row:ident, $point:ident, $distance:ident;)*) => {
        impl<T: DeclaredShape> ShapeEvaluator for T {
            fn node_count(&self) -> usize {
                self.nodes()
            }
            fn parameter_count(&self) -> usize {
                self.parameters()
            }
            fn parameter_region(&self) -> Region {
                self.region()
            }
            fn node_is_position(&self, node: usize) -> bool {
                self.is_position(node)
            }
            fn node_template(&self) -> Vec<[f64; 3]> {
                self.typical_nodes()
            }
            $(fn $row(&self, z: [$type; 2], out: &mut [$type]) {
                self.row(z, out);
            })*
        }
        impl<T: DeclaredSurface> SurfaceEvaluator for T {
            fn parameter_count(&self) -> usize {
                self.parameters()
            }
            fn parameter_region(&self) -> Region {
                self.region()
            }
            fn parameter_window(&self) -> [[f64; 2]; 2] {
                self.window()
            }
            $(fn $point(&self, z: [$type; 2]) -> [$type; 3] {
                self.point(z)
            })*
        }
        impl<T: DeclaredDistance> DistanceEvaluator for T {
            $(fn $distance(&self, x: [$type; 3]) -> $type {
                self.distance(x)
            })*
        }
    };
}
for_every_number!(evaluators);
