//! Choices that contradict each other or the pair.
contact_elements::contact_elements! {
    element Word { slave: point; master: Quad4; normal: Penalty; linearisation: tangent_plan; }
    element Measure { slave: point; master: Quad4; normal: Penalty; measure: current; }
    element Nothing { slave: point; master: SphereDistance placed; normal: Penalty; linearisation: tangent_plane; }
    element Both { slave: point; master: Quad4; normal: Penalty; linearisation: tangent_plane; outputs: residual; }
}

fn main() {}
