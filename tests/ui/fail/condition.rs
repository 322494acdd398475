//! Conditions of a law compare the gap, on the left, with parameters.
contact_elements::contact_elements! {
    normal law Barrier(g; kappa: "force" in (0, inf), d: "length" in (0, inf)) {
        active = d > g;
        valid = g;
        N = -kappa*(d - g)/g;
    }
}

fn main() {}
