//! A function that the language does not have, and one with too few arguments.
contact_elements::contact_elements! {
    /// A rigid bowl.
    rigid surface Bowl(u, v; depth: "length" in (0, inf)) {
        rho = [u, v, depth*log(1 + u*u + v*v)];
    }
    /// Hertz.
    normal law Hertz(g; k: "force/length^1.5" in (0, inf)) {
        N = -k*pow(-g);
    }
}

fn main() {}
