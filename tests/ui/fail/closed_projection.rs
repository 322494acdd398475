//! The closed projection of a rigid circle mixes up sine and cosine.
contact_elements::contact_elements! {
    /// Rigid circle in the plane.
    rigid curve Shaft(u; radius: "length" in (0, inf)) {
        rho = [radius*cos(u), -radius*sin(u)];
        projection(x, y) = [atan2(-x, y)];
    }
}

fn main() {}
