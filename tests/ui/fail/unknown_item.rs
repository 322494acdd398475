//! An item that starts with a word of another language.
contact_elements::contact_elements! {
    distance Ball(x, y, z; radius: "length" in (0, inf)) {
        d = sqrt(x*x + y*y + z*z) - radius;
    }
}

fn main() {}
