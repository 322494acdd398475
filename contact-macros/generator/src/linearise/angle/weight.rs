//! Where the angle of two curves lies in the window, and the weight there. [eq:angle-window] [eq:angle-weight]

use crate::ir::{Program, Sheet};
use crate::model::Angle;

/// u, v, θ_low, θ_high → x, dx/dq: where q = sin²θ lies in the window, 0 where the weight vanishes, 1 where it is
/// one. [eq:angle-window]
pub fn position_program(angle: Angle) -> Program {
    let sheet = Sheet::new("angle_position");
    let tangents = ["u", "v"].map(|name| sheet.input_vector(name, 3));
    let (low, high) = (sheet.input("angle_low"), sheet.input("angle_high"));
    let one = sheet.one();
    let [first, last] = tangents.map(|tangent| one / tangent.norm() * tangent);
    let across = first.cross(last);
    let square = across.dot(across);
    let sines = [low.sin(), high.sin()];
    // sin²θ_high − sin²θ_low, without cancellation
    let (apart, together) = (high - low, high + low);
    let (apart, together) = (apart.sin(), together.sin());
    let width = apart * together;
    let rate = one / width;
    let limits = sines.map(|sine| sine.square());
    let (inside, rate) = match angle {
        Angle::Large => (square - limits[0], rate),
        Angle::Small => (limits[1] - square, -rate),
    };
    sheet.output("position", inside / width);
    sheet.output("rate", rate);
    sheet.finish()
}

/// x in [0, 1], dx/dq → w = x³ (10 − 15 x + 6 x²), w' = dw/dq = 30 x² (1 − x)² dx/dq,
/// w'' = 60 x (1 − x) (1 − 2x) (dx/dq)². [eq:angle-weight]
pub fn weight_program() -> Program {
    let sheet = Sheet::new("angle_weight");
    let (x, rate) = (sheet.input("position"), sheet.input("rate"));
    let [one, two, six, ten, fifteen, thirty, sixty] =
        [1.0, 2.0, 6.0, 10.0, 15.0, 30.0, 60.0].map(|value| sheet.constant(value));
    let square = x * x;
    let inner = x * (six * x - fifteen) + ten;
    let weight = square * x * inner;
    let both = x * (one - x);
    let slope = thirty * (both * both) * rate;
    let middle = one - two * x;
    let curvature = sixty * (both * middle) * (rate * rate);
    sheet.output("weight", sheet.term("angle-weight", weight, ""));
    sheet.output("slope", sheet.term("angle-slope", slope, ""));
    sheet.output("curvature", sheet.term("angle-curvature", curvature, ""));
    sheet.finish()
}
