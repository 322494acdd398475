//! A surface without a domain, another on the domain of curves.
contact_elements::contact_elements! {
    surface Free(u, v) {
        N = [1 - u - v, u, v];
    }
    surface Thin(u, v) in line {
        N = [1 - u - v, u, v];
    }
}

fn main() {}
