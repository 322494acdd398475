//! Tangential laws: stiffness and bound as declared, and the force beyond the bound. [eq:trial]
//! [eq:return-map] [eq:ellipse]
//!
//! Components along the orthonormal axes d_1, d_2 of the frame; one of them where p = 1.

use crate::ir::{Program, Scalar, Sheet, Vector};
use crate::linearise::shared::lower::Scope;
use crate::model::TangentialLaw;

/// p, slip, parameters → e_q, and with a bound B_q, ∂B_q/∂p, ∂B_q/∂slip. [eq:trial] [eq:bound]
pub fn friction_program(law: &TangentialLaw) -> Program {
    let sheet = Sheet::new("friction");
    let mut scope = Scope::new(&sheet);
    scope.inputs([&law.pressure, &law.slip]);
    scope.inputs(law.parameters.iter().map(|parameter| &parameter.name));
    scope.bind(&law.bindings);
    let stiffness = scope.lower_all(&law.stiffness);
    let bound = scope.lower_all(&law.bound);
    let by = |input: usize| -> Vec<Scalar> {
        let slopes = bound.iter().map(|bound| bound.derivative(input));
        slopes.collect()
    };
    let (by_pressure, by_slip) = (by(0), by(1));
    let none = "the bound does not depend on it";
    for (name, tag, values) in [
        ("stiffness", "trial-stiffness", &stiffness),
        ("bound", "bound-value", &bound),
        ("by_pressure", "bound-by-pressure", &by_pressure),
        ("by_slip", "bound-by-slip", &by_slip),
    ] {
        sheet.outputs(name, &sheet.terms(tag, values, none));
    }
    drop(scope);
    sheet.finish()
}

/// Inputs of the sliding programs.
struct Sliding<'s> {
    slip: Vector<'s>,
    stiffness: Vector<'s>,
    bound: Vector<'s>,
    by_pressure: Vector<'s>,
    by_slip: Vector<'s>,
}

impl<'s> Sliding<'s> {
    fn new(sheet: &'s Sheet, axes: usize) -> Self {
        Self {
            slip: sheet.input_vector("s", 2),
            stiffness: sheet.input_vector("stiffness", axes),
            bound: sheet.input_vector("bound", axes),
            by_pressure: sheet.input_vector("by_pressure", axes),
            by_slip: sheet.input_vector("by_slip", axes),
        }
    }
}

/// Beyond the bound: s_q, e_q, B_q and its slopes (and γ of the ellipse) → t_q, ∂t_q/∂s_r, ∂t_q/∂p.
pub fn sliding_program(law: &TangentialLaw) -> Program {
    let sheet = Sheet::new("sliding");
    let slid = match law.stiffness.len() {
        1 => isotropic(&sheet),
        _ => orthotropic(&sheet),
    };
    sheet.outputs("t", &slid.traction);
    for (q, row) in slid.stiffness.iter().enumerate() {
        sheet.outputs(&format!("c_{q}"), row);
    }
    sheet.outputs("h", &slid.by_pressure);
    sheet.finish()
}

/// Two components along the axes.
type Pair<'s> = [Scalar<'s>; 2];

/// The force beyond the bound and its derivatives.
struct Slid<'s> {
    /// t_q
    traction: Pair<'s>,
    /// ∂t_q/∂s_r
    stiffness: [Pair<'s>; 2],
    /// ∂t_q/∂p
    by_pressure: Pair<'s>,
}

/// t = B u with u = s/|s|. [eq:return-map]
fn isotropic(sheet: &Sheet) -> Slid<'_> {
    let Sliding {
        slip,
        bound,
        by_slip,
        by_pressure,
        ..
    } = Sliding::new(sheet, 1);
    let length = slip.norm();
    let u = [slip[0] / length, slip[1] / length];
    let b = sheet.term("sliding-traction", bound[0], "");
    let traction = u.map(|u| b * u);
    let ratio = sheet.term("sliding-direction", bound[0] / length, "");
    let softening = sheet.term("sliding-path", by_slip[0], "");
    let pressure = sheet.term("sliding-pressure", by_pressure[0], "");
    // I − u⊗u = u'⊗u' with u' = (−u_2, u_1): nothing cancels
    let across = [-u[1], u[0]];
    Slid {
        traction,
        stiffness: [0, 1]
            .map(|q| [0, 1].map(|r| ratio * (across[q] * across[r]) + softening * (u[q] * u[r]))),
        by_pressure: u.map(|u| pressure * u),
    }
}

/// The values of an ellipse at γ.
struct Ellipse<'s> {
    /// B_q
    bound: Vector<'s>,
    /// k_q: e_q/B_q² scaled so that k_1 k_2 = 1.
    factor: Pair<'s>,
    /// 1/(1 + γ k_q)
    shrink: Pair<'s>,
    /// z_q = t_q/B_q: a point of the unit circle.
    point: Pair<'s>,
    gamma: Scalar<'s>,
    /// Σ z_q² k_q/(1 + γ k_q)
    slope: Scalar<'s>,
}

/// t_q = B_q z_q, z_q = (e_q s_q/B_q)/(1 + γ k_q), |z| = 1: the closest point in the energy norm.
/// [eq:ellipse]
fn orthotropic(sheet: &Sheet) -> Slid<'_> {
    let sliding = Sliding::new(sheet, 2);
    let Sliding {
        slip,
        stiffness,
        bound,
        ..
    } = sliding;
    let gamma = sheet.input("gamma");
    let one = sheet.one();
    let first = (stiffness[0] / stiffness[1]).sqrt() * (bound[1] / bound[0]);
    let factor = [first, one / first];
    let shrink = factor.map(|k| one / (one + gamma * k));
    let mut point = [one; 2];
    let mut slope = sheet.zero();
    for q in 0..2 {
        point[q] = stiffness[q] * slip[q] / bound[q] * shrink[q];
        slope = slope + point[q].square() * (factor[q] * shrink[q]);
    }
    let ellipse = Ellipse {
        bound,
        factor,
        shrink,
        point,
        gamma,
        slope,
    };
    on_ellipse(sheet, &sliding, &ellipse)
}

fn on_ellipse<'s>(sheet: &'s Sheet, sliding: &Sliding<'s>, ellipse: &Ellipse<'s>) -> Slid<'s> {
    let scale = sheet.terms("sliding-traction", &sliding.bound, "");
    let traction = [0, 1].map(|q| scale[q] * ellipse.point[q]);
    let elastic = sheet.terms("sliding-direction", &sliding.stiffness, "");
    let path = sheet.terms("sliding-path", &sliding.by_slip, "");
    let pressure = sheet.terms("sliding-pressure", &sliding.by_pressure, "");
    let zero = sheet.zero();
    let length = sliding.slip.norm();
    let columns = [0, 1].map(|r| {
        let unit = sliding.slip[r] / length;
        let bound_change = [0, 1].map(|q| path[q] * unit);
        let mut trial_change = [zero; 2];
        trial_change[r] = elastic[r];
        ellipse.change(trial_change, bound_change)
    });
    Slid {
        traction,
        stiffness: [0, 1].map(|q| [columns[0][q], columns[1][q]]),
        by_pressure: ellipse.change([zero; 2], [pressure[0], pressure[1]]),
    }
}

impl<'s> Ellipse<'s> {
    /// Change of t_q for changes of the trial force e_q s_q and of the bounds B_q. [eq:ellipse-slope]
    fn change(&self, trial: Pair<'s>, bound: Pair<'s>) -> Pair<'s> {
        let Self {
            factor,
            shrink,
            point,
            gamma,
            ..
        } = *self;
        let relative = [0, 1].map(|q| bound[q] / self.bound[q]);
        // dk_1/k_1 = dB_2/B_2 − dB_1/B_1 = −dk_2/k_2
        let spread = relative[1] - relative[0];
        let spreads = [spread, -spread];
        // at fixed γ: dz_q = (dt_q/B_q)/(1 + γ k_q) − z_q (dB_q/B_q + γ dk_q/(1 + γ k_q))
        let fixed = [0, 1].map(|q| {
            let first = trial[q] / self.bound[q] * shrink[q];
            let step = gamma * factor[q] * shrink[q] * spreads[q];
            first - point[q] * (relative[q] + step)
        });
        // dγ keeps the point on the circle: z·dz = 0
        let sheet = gamma.sheet();
        let step = sheet.sum(0..2, |q| point[q] * fixed[q]) / self.slope;
        [0, 1].map(|q| {
            let back = factor[q] * shrink[q] * point[q] * step;
            self.bound[q] * (fixed[q] - back) + point[q] * bound[q]
        })
    }
}
