//! Geometries of the wrong dimension.
contact_elements::contact_elements! {
    element Flat { dimension: 2; slave: point; master: Quad4; normal: Penalty; }
    element Disc { slave: point; master: Circle2d placed; normal: Penalty; }
    element Four { dimension: 4; slave: point; master: Line2; normal: Penalty; }
}

fn main() {}
