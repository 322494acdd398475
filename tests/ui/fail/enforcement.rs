//! Multipliers that a law or a measure does not bear.
contact_elements::contact_elements! {
    element Word { slave: point; master: Quad4; normal: Penalty; enforcement: lagrange; }
    element Law { slave: point; master: Quad4; normal: PowerLaw; enforcement: augmented; }
    element Moving { slave: Quad4 at gauss(2, 2); master: Quad4; normal: Penalty; measure: current; enforcement: multiplier; }
}

fn main() {}
