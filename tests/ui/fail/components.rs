//! A rigid surface that forgets its height.
contact_elements::contact_elements! {
    rigid surface Ground(u, v) {
        rho = [u, v];
    }
}

fn main() {}
