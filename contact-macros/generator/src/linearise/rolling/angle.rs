//! The angles about two curves. [eq:rolling-angle]

use super::curves::{SIGNS, Triad, references};
use crate::ir::{Program, Sheet};
use crate::model::Reference;

/// n, b_i, r_,ii or directors → φ_c [rad]; |w_⊥|²/|w|² and |w_⊥|/|u|, which tell how well the reference is
/// known. [eq:rolling-angle]
pub fn angle_program(reference: Reference) -> Program {
    let sheet = Sheet::new("rolling_angle");
    let n = sheet.input_vector("n", 3);
    let tangents = [0, 1].map(|c| sheet.input_vector(&format!("b_{c}"), 3));
    let references = references(&sheet, reference);
    let outputs = [0, 1].map(|c| {
        let (u, w) = (tangents[c], references[c]);
        let triad = Triad::new(u, w);
        let normal = triad.normal();
        let (sine, cosine) = (n.dot(triad.binormal), n.dot(normal));
        // σ atan2(−n·g, −n·f)
        let sine = sheet.constant(-SIGNS[c]) * sine;
        let angle = sine.atan2(-cosine);
        let width = triad.area * triad.inverse;
        let share = width.square() / w.dot(w);
        [angle, share, width * triad.inverse]
    });
    for (which, name) in ["angle", "share", "bend"].into_iter().enumerate() {
        sheet.outputs(name, &outputs.map(|values| values[which]));
    }
    sheet.finish()
}
