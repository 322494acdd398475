//! Parameters: a name that elements keep for themselves, an empty range, a unit with a space.
contact_elements::contact_elements! {
    normal law Soft(g;
        r0: "length",
        k: "force/length" in (1, 0),
        c: "force per length"
    ) {
        N = (k + c)*g;
    }
}

fn main() {}
