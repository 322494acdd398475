//! An entry is missing, one is misspelt, one stands twice.
contact_elements::contact_elements! {
    element NoLaw { slave: point; master: Quad4; }
    element Misspelt { slave: point; mastr: Quad4; normal: Penalty; }
    element Twice { slave: point; master: Quad4; normal: Penalty; normal: PowerLaw; }
}

fn main() {}
