//! The exported interface is there in Rust too, and two libraries live side by side.
#[allow(clippy::missing_safety_doc)]
mod plant {
    contact_elements::contact_elements! {
        export plant;
        element PointFacet { slave: point; master: Quad4; normal: Penalty; }
    }
}
mod mill {
    contact_elements::contact_elements! {
        export mill;
        element PointFacet { slave: point; master: Tri3; normal: Penalty; }
        element PointRoller { slave: point; master: CylinderDistance placed; normal: Penalty; }
    }
}

unsafe extern "C" {
    safe fn plant_element_count() -> i32;
    safe fn mill_element_count() -> i32;
}

#[test]
fn all_are_there() {
    assert_eq!((plant_element_count(), mill_element_count()), (1, 2));
    assert_eq!((plant::ELEMENTS.len(), mill::ELEMENTS.len()), (1, 2));
}
