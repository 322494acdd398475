//! Friction: a law misspelt, two laws swapped, an axis missing, no projection, no slave curve.
contact_elements::contact_elements! {
    element Misspelt { slave: point; master: Quad4; normal: Penalty; tangential: Coulom; }
    element Swapped { slave: point; master: Quad4; normal: Coulomb; tangential: Penalty; }
    element NoAxis { slave: point; master: Quad4; normal: Penalty; tangential: CoulombOrthotropic; }
    element NoProjection { slave: point; master: SphereDistance; normal: Penalty; tangential: Stick; }
    element NoCurve { slave: point; master: Quad4; normal: Penalty; tangential: CoulombOrthotropic; axis: slave; }
}

fn main() {}
