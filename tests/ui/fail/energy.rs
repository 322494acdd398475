//! The energy lacks a factor one half.
contact_elements::contact_elements! {
    normal law Linear(g; k: "force/length" in (0, inf)) {
        N = k*g;
        W = k*g*g;
    }
}

fn main() {}
