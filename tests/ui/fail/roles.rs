//! Geometries and laws in places where they cannot be.
contact_elements::contact_elements! {
    element RigidSlave { slave: Sphere; master: Quad4; normal: Penalty; }
    element LawAsMaster { slave: point; master: Penalty; normal: Penalty; }
    element SurfaceAsLaw { slave: point; master: Quad4; normal: Quad9; }
    element PlacedFacet { slave: point; master: Quad4 placed; normal: Penalty; }
}

fn main() {}
