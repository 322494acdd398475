//! Names that nobody declared, one of them nearly right.
contact_elements::contact_elements! {
    element NodeFacet { slave: point; master: Quad5; normal: Penalty; }
    element NodeGround { slave: point; master: Plane placed; normal: Penality; }
}

fn main() {}
