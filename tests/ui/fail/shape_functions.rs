//! A sign in the last shape function of a facet is wrong.
contact_elements::contact_elements! {
    /// Bilinear facet.
    surface Facet(xi, eta) in square {
        N = [
            (1 - xi)*(1 - eta)/4,
            (1 + xi)*(1 - eta)/4,
            (1 + xi)*(1 + eta)/4,
            (1 - xi)*(1 - eta)/4,
        ];
    }
}

fn main() {}
