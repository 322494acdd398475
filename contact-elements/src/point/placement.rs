//! Where a rigid geometry stands: origin and rotation from its own frame to the global one.

use crate::arithmetic::sqrt;

/// global = origin + rotation · local. [eq:placement]
#[derive(Clone, Copy, Debug)]
pub struct Placement<const D: usize> {
    /// Origin of the geometry's frame [length].
    pub origin: [f64; D],
    /// Columns: the local axes in the global frame.
    pub rotation: [[f64; D]; D],
}

impl<const D: usize> Placement<D> {
    /// The geometry's own frame.
    #[inline(always)]
    pub fn identity() -> Self {
        let mut rotation = [[0.0; D]; D];
        for k in 0..D {
            rotation[k][k] = 1.0;
        }
        Self {
            origin: [0.0; D],
            rotation,
        }
    }

    /// 3D: origin_x origin_y origin_z, quaternion w x y z (of any length); 2D: origin_x origin_y and the
    /// direction (c, s) of the local first axis. All zero stands for no rotation.
    #[inline(always)]
    pub fn from_parameters(parameters: &[f64]) -> Self {
        let mut placement = Self::identity();
        for (origin, &value) in placement.origin.iter_mut().zip(parameters) {
            *origin = value;
        }
        let rotation = parameters.get(D..).unwrap_or(&[]);
        if D == 3 {
            if let Some(&[w, x, y, z]) = rotation.first_chunk::<4>() {
                placement.rotate_by_quaternion([w, x, y, z]);
            }
        } else if let Some(&[c, s]) = rotation.first_chunk::<2>() {
            placement.rotate_to_direction(c, s);
        }
        placement
    }

    #[inline(always)]
    fn rotate_by_quaternion(&mut self, [w, x, y, z]: [f64; 4]) {
        let square = w * w + x * x + y * y + z * z;
        if square < 1e-60 {
            return;
        }
        let f = 2.0 / square;
        let rotation = [
            [
                1.0 - f * (y * y + z * z),
                f * (x * y - w * z),
                f * (x * z + w * y),
            ],
            [
                f * (x * y + w * z),
                1.0 - f * (x * x + z * z),
                f * (y * z - w * x),
            ],
            [
                f * (x * z - w * y),
                f * (y * z + w * x),
                1.0 - f * (x * x + y * y),
            ],
        ];
        for (row, values) in self.rotation.iter_mut().zip(rotation) {
            for (entry, value) in row.iter_mut().zip(values) {
                *entry = value;
            }
        }
    }

    #[inline(always)]
    fn rotate_to_direction(&mut self, c: f64, s: f64) {
        let square = c * c + s * s;
        if square < 1e-60 {
            return;
        }
        let f = 1.0 / sqrt(square);
        let rotation = [[c * f, -s * f], [s * f, c * f]];
        for (row, values) in self.rotation.iter_mut().zip(rotation) {
            for (entry, value) in row.iter_mut().zip(values) {
                *entry = value;
            }
        }
    }

    /// Rotationᵀ · v
    #[inline(always)]
    pub fn vector_to_local(&self, v: &[f64; D]) -> [f64; D] {
        let mut local = [0.0; D];
        for k in 0..D {
            for l in 0..D {
                local[l] += self.rotation[k][l] * v[k];
            }
        }
        local
    }

    /// Rotation · v
    #[inline(always)]
    pub fn vector_to_global(&self, v: &[f64; D]) -> [f64; D] {
        let mut global = [0.0; D];
        for k in 0..D {
            for l in 0..D {
                global[k] += self.rotation[k][l] * v[l];
            }
        }
        global
    }

    /// Rotation · m · rotationᵀ
    #[inline(always)]
    pub fn tensor_to_global(&self, m: &[[f64; D]; D]) -> [[f64; D]; D] {
        let mut half = [[0.0; D]; D];
        for k in 0..D {
            half[k] = self.vector_to_global(&m[k]);
        }
        let mut global = [[0.0; D]; D];
        for l in 0..D {
            let mut column = [0.0; D];
            for k in 0..D {
                column[k] = half[k][l];
            }
            let column = self.vector_to_global(&column);
            for k in 0..D {
                global[k][l] = column[k];
            }
        }
        global
    }
}
