//! Elements: every kind of slave and master, every entry with every choice.
contact_elements::contact_elements! {
    /// Wavy ground of the user.
    rigid distance Ground(x, y, z; height: "length" in [0, 1]) { d = z - height; }

    element PointToPoint { slave: point; master: point; normal: Penalty; }
    element PointToFacet { slave: point; master: Quad4; normal: PowerLaw; gap: signed; linearisation: exact; }
    element PointToFacetPlane { slave: point; master: Quad4; normal: Penalty; linearisation: tangent_plane; }
    element PointToFacetForce { slave: point; master: Quad4; normal: Penalty; outputs: residual; }
    element PointToCurve { slave: point; master: Hermite; normal: Penalty; gap: distance; }
    element PointToGround { dimension: 3; slave: point; master: Ground placed; normal: LogBarrier; }
    element PointToFixedTorus { slave: point; master: Torus; normal: Penalty; }
    element FacetToFacet { slave: Quad4 at gauss(2, 2); master: Quad4; normal: Penalty; measure: reference; }
    element FacetToSphere { slave: Tri6 at gauss(6); master: Sphere placed; normal: Penalty; measure: current; }
    element FacetPointToFacet { slave: Quad4 at given; master: Quad4; normal: Penalty; }
    element CellToFacet { slave: interpolated; master: RationalSurface2; normal: Penalty; }
    element EdgeToFacet { slave: Line2 at gauss(2); master: Quad4; normal: Penalty; }
    element BeamToBeam { slave: Hermite; master: Hermite; normal: Penalty; gap: distance; }
    element EdgeToEdge { slave: Line2; master: Line2; normal: Penalty; gap: signed; }
    element FlatPointToLine { dimension: 2; slave: point; master: Line2; normal: Penalty; }
    element FlatLineToDisc { dimension: 2; slave: Line2 at gauss(2); master: Circle2d placed; normal: Penalty; }
}

#[test]
fn all_are_there() {
    assert_eq!(ELEMENTS.len(), 16);
    assert_eq!(ELEMENTS[1].name, "PointToFacet\0");
}
