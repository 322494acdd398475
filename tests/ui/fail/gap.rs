//! Two curves: which gap? A facet: its gap has a sign.
contact_elements::contact_elements! {
    element Beams { slave: Hermite; master: Hermite; normal: Penalty; }
    element Facet { slave: point; master: Quad4; normal: Penalty; gap: distance; }
}

fn main() {}
