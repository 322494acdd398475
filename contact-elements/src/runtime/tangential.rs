//! Second pass of tangential contact: residual and tangent of one sticking or sliding point.
//!
//! ```text
//! R_(A,k)      = s_A f_k + s_A,i g_i n_k                                  [eq:tangential-residual]
//! K_(A,k)(B,l) = Z_q(A,k) G_q(B,l) − P_q(A,k) Z_q(B,l)
//!                + (s_A σ_B + σ_A s_B) δ_kl ,   σ_A = cross_i s_A,i       [eq:tangential-contraction]
//! ```

use super::receiver::Receiver;
use super::values::Rows;

/// Coefficients of the tangential residual.
#[derive(Clone, Copy, Debug)]
pub struct TangentialForce<const D: usize, const P: usize> {
    /// Multiplies s_A.
    pub force: [f64; D],
    /// Multiplies s_A,i n.
    pub turn: [f64; P],
}

/// A linear form over the unknowns.
#[derive(Clone, Copy, Debug)]
pub struct Form<const D: usize, const P: usize, const H: usize> {
    /// Multiplies s_A.
    pub position: [f64; D],
    /// Multiplies s_A,i.
    pub turning: [[f64; D]; P],
    /// Multiplies s_A,ij n.
    pub bending: [f64; H],
    /// Multiplies the row of the slave's tangent.
    pub slave: [f64; D],
}

/// Coefficients of the tangential tangent.
#[derive(Clone, Copy, Debug)]
pub struct TangentialCoefficients<const D: usize, const P: usize, const H: usize> {
    /// Z_q
    pub z: [Form<D, P, H>; P],
    /// P_q
    pub p: [Form<D, P, H>; P],
    /// G_q
    pub g: [Form<D, P, H>; P],
    /// Factors of s_A,i in σ_A.
    pub cross: [f64; P],
}

impl<const D: usize, const P: usize, const H: usize> Default for Form<D, P, H> {
    #[inline(always)]
    fn default() -> Self {
        Self {
            position: [0.0; D],
            turning: [[0.0; D]; P],
            bending: [0.0; H],
            slave: [0.0; D],
        }
    }
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
        Self {
            z: [Form::default(); P],
            p: [Form::default(); P],
            g: [Form::default(); P],
            cross: [0.0; P],
        }
    }
}

/// Rows of second derivatives and of the slave's tangent, and scratch for the rows of the forms.
#[derive(Debug)]
pub struct TangentialRows<'a, const P: usize, const H: usize> {
    /// s_A,ij per node.
    pub second: [&'a mut [f64]; H],
    /// Row of the slave's tangent per node; zero on the master.
    pub slave: &'a mut [f64],
    /// σ_A per node.
    pub cross: &'a mut [f64],
    /// Z_q per unknown.
    pub z: [&'a mut [f64]; P],
    /// P_q per unknown.
    pub p: [&'a mut [f64]; P],
    /// G_q per unknown.
    pub g: [&'a mut [f64]; P],
    /// The row of K at hand.
    pub row: &'a mut [f64],
}

impl<const D: usize, const P: usize, const H: usize> TangentialCoefficients<D, P, H> {
    /// Where no unknown turns the tangents and no row but s_A is left, all of it multiplies s_A s_B:
    /// z_q ⊗ g_q − p_q ⊗ z_q.
    #[inline(always)]
    pub fn add_to(&self, p: &mut [[f64; D]; D]) {
        for q in 0..P {
            for k in 0..D {
                for l in 0..D {
                    p[k][l] += self.z[q].position[k] * self.g[q].position[l]
                        - self.p[q].position[k] * self.z[q].position[l];
                }
            }
        }
    }
}

impl<const D: usize, const P: usize, const H: usize> Form<D, P, H> {
    /// Every vector of the form turned by `turn`.
    #[inline(always)]
    pub fn turned(mut self, turn: impl Fn(&[f64; D]) -> [f64; D]) -> Self {
        self.position = turn(&self.position);
        for vector in &mut self.turning {
            *vector = turn(vector);
        }
        self.slave = turn(&self.slave);
        self
    }

    /// Writes the row over all unknowns.
    #[inline(always)]
    fn fill(
        &self,
        to: &mut [f64],
        rows: &Rows<'_, P>,
        (second, slave): (&[&mut [f64]; H], &[f64]),
        n: &[f64; D],
        moving: bool,
    ) {
        let (blocks, _) = to.as_chunks_mut::<D>();
        let nodes = blocks.iter_mut().zip(rows.s.iter().zip(slave));
        for (a, (block, (&s, &slave))) in nodes.enumerate() {
            for k in 0..D {
                block[k] = s * self.position[k] + slave * self.slave[k];
            }
            if !moving {
                continue;
            }
            let at = |row: &[f64]| row.get(a).copied().unwrap_or(0.0);
            let mut bend = 0.0;
            for h in 0..H {
                bend += at(second[h]) * self.bending[h];
            }
            for k in 0..D {
                for i in 0..P {
                    block[k] += at(rows.ds[i]) * self.turning[i][k];
                }
                block[k] += bend * n[k];
            }
        }
    }
}

/// Adds K to the receiver row by row.
///
/// * `n` – normal in the global frame. * `coefficients` – in the global frame.
/// * `weight` – of the point; multiplies everything but the measure's rows.
/// * `measure` – w t_q Z_q ⊗ ∂J/∂x: the tangential forces t_q and the rows w ∂J/∂x, where the measure moves.
/// * `moving` – false where all s_A,i vanish.
// a call, not inlined: one copy serves all elements of the same sizes
#[inline(never)]
#[allow(clippy::too_many_arguments)]
pub fn contract_tangential<R: Receiver, const D: usize, const P: usize, const H: usize>(
    rows: &Rows<'_, P>,
    n: &[f64; D],
    coefficients: &TangentialCoefficients<D, P, H>,
    weight: f64,
    (t, measure): (&[f64; P], &[f64]),
    moving: bool,
    scratch: &mut TangentialRows<'_, P, H>,
    receiver: &mut R,
) {
    for q in 0..P {
        let more = (&scratch.second, &*scratch.slave);
        coefficients.z[q].fill(scratch.z[q], rows, more, n, moving);
        coefficients.p[q].fill(scratch.p[q], rows, more, n, moving);
        coefficients.g[q].fill(scratch.g[q], rows, more, n, moving);
        for g in scratch.g[q].iter_mut() {
            *g *= weight;
        }
        for p in scratch.p[q].iter_mut() {
            *p *= weight;
        }
        for (g, &m) in scratch.g[q].iter_mut().zip(measure) {
            *g += t[q] * m;
        }
    }
    for (a, cross) in scratch.cross.iter_mut().enumerate() {
        *cross = 0.0;
        for i in 0..P {
            *cross += weight * coefficients.cross[i] * rows.ds[i].get(a).copied().unwrap_or(0.0);
        }
    }
    let unknowns = rows.s.len() * D;
    for unknown in 0..unknowns {
        row::<D, P, H>(unknown, rows.s, moving, scratch);
        let row = scratch.row.get(..unknowns).unwrap_or_default();
        receiver.row(unknown, row, false);
    }
}

/// One row of K.
#[inline(always)]
fn row<const D: usize, const P: usize, const H: usize>(
    unknown: usize,
    s: &[f64],
    moving: bool,
    scratch: &mut TangentialRows<'_, P, H>,
) {
    let at = |row: &[f64], index: usize| row.get(index).copied().unwrap_or(0.0);
    for q in 0..P {
        let (z, p) = (at(scratch.z[q], unknown), at(scratch.p[q], unknown));
        let forms = scratch.g[q].iter().zip(scratch.z[q].iter());
        for (entry, (&g_b, &z_b)) in scratch.row.iter_mut().zip(forms) {
            let value = z * g_b - p * z_b;
            *entry = if q == 0 { value } else { *entry + value };
        }
    }
    if moving {
        let (a, k) = (unknown / D, unknown % D);
        let (s_a, cross_a) = (at(s, a), at(scratch.cross, a));
        let (blocks, _) = scratch.row.as_chunks_mut::<D>();
        for (block, (&s_b, &cross_b)) in blocks.iter_mut().zip(s.iter().zip(scratch.cross.iter())) {
            block[k] += s_a * cross_b + cross_a * s_b;
        }
    }
}
