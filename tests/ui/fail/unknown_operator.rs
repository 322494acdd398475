//! A power written as in other languages.
contact_elements::contact_elements! {
    /// Quadratic stiffening.
    normal law Stiffening(g; k: "force/length^2" in (0, inf)) {
        N = -k*g^2;
    }
}

fn main() {}
