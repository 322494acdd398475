//! A coordinate is misspelt.
contact_elements::contact_elements! {
    /// Straight segment, t in [0, 1].
    curve Segment(t) in unit_line {
        N = [1 - t, tt];
    }
}

fn main() {}
