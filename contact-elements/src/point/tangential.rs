//! Tangential contact of one sticking or sliding point: what its residual and tangent are made of.
//!
//! ```text
//! R_(A,k)      = s_A f_k + s_A,i g_i n_k                                  [eq:tangential-residual]
//! K_(A,k)(B,l) = Z_q(A,k) G_q(B,l) − P_q(A,k) Z_q(B,l)
//!                + (s_A σ_B + σ_A s_B) δ_kl ,   σ_A = cross_i s_A,i       [eq:tangential-contraction]
//! ```

/// Coefficients of the tangential residual.
#[derive(Clone, Copy, Debug)]
pub struct TangentialForce<const D: usize, const P: usize> {
    /// Multiplies s_A.
    pub force: [f64; D],
    /// Multiplies s_A,i n.
    pub turn: [f64; P],
}

/// Z_q: the variation of a projected parameter.
#[derive(Clone, Copy, Debug)]
pub struct Variation<const D: usize, const P: usize> {
    /// Multiplies s_A.
    pub position: [f64; D],
    /// Multiplies s_A,i n.
    pub turning: [f64; P],
}

/// −P_q: the part of the second variation apart from Z_q. G_q has the same bending.
#[derive(Clone, Copy, Debug)]
pub struct SecondVariation<const D: usize, const P: usize, const H: usize> {
    /// Multiplies s_A.
    pub position: [f64; D],
    /// Multiplies s_A,i.
    pub turning: [[f64; D]; P],
    /// Multiplies s_A,ij n.
    pub bending: [f64; H],
}

/// G_q: the change of the force, without bending.
#[derive(Clone, Copy, Debug)]
pub struct ForceChange<const D: usize, const P: usize> {
    /// Multiplies s_A.
    pub position: [f64; D],
    /// Multiplies s_A,i.
    pub turning: [[f64; D]; P],
    /// Multiplies the row of the slave's tangent.
    pub slave: [f64; D],
}

/// Coefficients of the tangential tangent.
#[derive(Clone, Copy, Debug)]
pub struct TangentialCoefficients<const D: usize, const P: usize, const H: usize> {
    /// Z_q
    pub z: [Variation<D, P>; P],
    /// −P_q
    pub p: [SecondVariation<D, P, H>; P],
    /// G_q
    pub g: [ForceChange<D, P>; P],
    /// Factors of s_A,i in σ_A.
    pub cross: [f64; P],
}

impl<const D: usize, const P: usize> Default for TangentialForce<D, P> {
    #[inline(always)]
    fn default() -> Self {
        Self {
            force: [0.0; D],
            turn: [0.0; P],
        }
    }
}

impl<const D: usize, const P: usize, const H: usize> Default for TangentialCoefficients<D, P, H> {
    #[inline(always)]
    fn default() -> Self {
        let z = Variation {
            position: [0.0; D],
            turning: [0.0; P],
        };
        let p = SecondVariation {
            position: [0.0; D],
            turning: [[0.0; D]; P],
            bending: [0.0; H],
        };
        let g = ForceChange {
            position: [0.0; D],
            turning: [[0.0; D]; P],
            slave: [0.0; D],
        };
        Self {
            z: [z; P],
            p: [p; P],
            g: [g; P],
            cross: [0.0; P],
        }
    }
}

impl<const D: usize, const P: usize, const H: usize> TangentialCoefficients<D, P, H> {
    /// Where no unknown turns the tangents and no row but s_A is left, all of it multiplies s_A s_B:
    /// z_q ⊗ g_q + p_q ⊗ z_q.
    #[inline(always)]
    pub fn joined(&self) -> [[f64; D]; D] {
        let mut sum = [[0.0; D]; D];
        for q in 0..P {
            for k in 0..D {
                for l in 0..D {
                    sum[k][l] += self.z[q].position[k] * self.g[q].position[l]
                        + self.p[q].position[k] * self.z[q].position[l];
                }
            }
        }
        sum
    }

    /// Rotates every vector.
    #[inline(always)]
    pub fn rotate(&mut self, rotated: impl Fn(&[f64; D]) -> [f64; D]) {
        for q in 0..P {
            let (z, p, g) = (&mut self.z[q], &mut self.p[q], &mut self.g[q]);
            for vector in [
                &mut z.position,
                &mut p.position,
                &mut g.position,
                &mut g.slave,
            ] {
                *vector = rotated(vector);
            }
            for vector in p.turning.iter_mut().chain(&mut g.turning) {
                *vector = rotated(vector);
            }
        }
    }

    /// Times the weight of the point: P, G and the cross term; Z stays a variation.
    #[inline(always)]
    pub fn weigh(&mut self, weight: f64) {
        let scale = |values: &mut [f64]| values.iter_mut().for_each(|value| *value *= weight);
        scale(&mut self.cross);
        for q in 0..P {
            let (p, g) = (&mut self.p[q], &mut self.g[q]);
            scale(&mut p.bending);
            for vector in [&mut p.position, &mut g.position, &mut g.slave] {
                scale(vector);
            }
            for vector in p.turning.iter_mut().chain(&mut g.turning) {
                scale(vector);
            }
        }
    }
}
