//! A deformable geometry gets its shape from nodes only.
contact_elements::contact_elements! {
    curve Cable(t; tension: "force") in unit_line {
        N = [1 - t, t];
    }
}

fn main() {}
