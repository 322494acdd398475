//! Every key of an element with every value.
contact_elements::contact_elements! {
    element Solid { dimension: 3; slave: point; master: Quad4; normal: Penalty; }
    element Flat { dimension: 2; slave: point; master: Line2; normal: Penalty; gap: signed; }
    element TwoPoints { slave: point; master: point; normal: Penalty; gap: distance; }
    element TwoSides { slave: point; master: point; normal: Penalty; gap: oriented; }
    element AnyShape { slave: interpolated; master: Quad4; normal: Penalty; }
    element Beams { slave: Hermite; master: Hermite; normal: Penalty; gap: distance; }
    element Edges { slave: Line2; master: Line2; normal: Penalty; gap: signed; }
    element Wire { slave: Line3 at gauss(3); master: Torus placed; normal: Penalty; }
    element Given { slave: Quad4 at given; master: Quad4; normal: Penalty; }
    element Facets { slave: Tri3 at gauss(3); master: Plane; normal: Penalty; measure: current; }
    element Reference { slave: Quad4 at gauss(2, 2); master: Quad4; normal: Penalty; measure: reference; }
    element Sticking { slave: point; master: Quad4; normal: Penalty; tangential: Coulomb; }
    element Fibres { slave: point; master: Quad4; normal: Penalty; tangential: CoulombOrthotropic; axis: convected; }
    element Rope { slave: Hermite at gauss(3); master: Quad4; normal: Penalty; tangential: CoulombOrthotropic; axis: slave; }
    element Soft { slave: point; master: Quad4; normal: Penalty; enforcement: penalty; }
    element Uzawa { slave: point; master: Quad4; normal: Penalty; enforcement: augmented; }
    element Hard { slave: point; master: Quad4; normal: Penalty; enforcement: multiplier; }
    element Rolling {
        slave: Hermite; master: Hermite; normal: Penalty; gap: distance;
        tangential: Coulomb; rolling: RollingResistance; director: principal_normal;
    }
    element RollingStraight {
        slave: Line2; master: Line2; normal: Penalty; gap: distance;
        tangential: Coulomb; rolling: RollingResistance; director: given;
    }
    element Crossing { slave: Hermite; master: Hermite; normal: Penalty; gap: distance; angle: large; }
    element Parallel { slave: Hermite at gauss(3); master: Hermite; normal: Penalty; gap: distance; angle: small; }
    element Exact { slave: point; master: Quad4; normal: Penalty; linearisation: exact; }
    element Printed { slave: point; master: Quad4; normal: Penalty; linearisation: tangent_plane; }
    element Both { slave: point; master: Quad4; normal: Penalty; outputs: residual_and_tangent; }
    element Explicit { slave: point; master: Quad4; normal: Penalty; outputs: residual; }
    element One { slave: point; master: Quad4; normal: Penalty; batch: single; }
    element Many { slave: point; master: Quad4; normal: Penalty; batch: lanes; }
}

fn main() {}
