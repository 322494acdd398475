//! `export` stands once, before all items.
contact_elements::contact_elements! {
    element PointFacet { slave: point; master: Quad4; normal: Penalty; }
    export plant;
}

fn main() {}
