//! Rolling of pairs that do not roll, and laws that do not fit it.
contact_elements::contact_elements! {
    tangential law Axes(p, s; a, b) { stiffness = [a, b]; bound = [p, p]; }
    element Point { slave: point; master: Hermite; normal: Penalty; tangential: Coulomb; rolling: RollingResistance; }
    element Smooth { slave: Hermite; master: Hermite; normal: Penalty; rolling: RollingResistance; gap: distance; }
    element Edges { slave: Hermite; master: Hermite; normal: Penalty; tangential: Coulomb; rolling: RollingResistance; gap: signed; }
    element Wire { slave: Hermite; master: Circle placed; normal: Penalty; tangential: Coulomb; rolling: RollingResistance; gap: distance; }
    element Straight { slave: Line2; master: Hermite; normal: Penalty; tangential: Coulomb; rolling: RollingResistance; gap: distance; }
    element Rational { slave: RationalCurve2; master: Hermite; normal: Penalty; tangential: Coulomb; rolling: RollingResistance; gap: distance; }
    element Plane { slave: Hermite; master: Hermite; normal: Penalty; tangential: Coulomb; rolling: RollingResistance; gap: distance; linearisation: tangent_plane; }
    element Ellipse { slave: Hermite; master: Hermite; normal: Penalty; tangential: Coulomb; rolling: Axes; gap: distance; }
    element Same { slave: Hermite; master: Hermite; normal: Penalty; tangential: Coulomb; rolling: Coulomb; gap: distance; }
    element Wrong { slave: Hermite; master: Hermite; normal: Penalty; tangential: Coulomb; rolling: Penalty; gap: distance; }
    element Alone { slave: Hermite; master: Hermite; normal: Penalty; tangential: Coulomb; director: given; gap: distance; }
    element Word { slave: Line2; master: Line2; normal: Penalty; tangential: Coulomb; rolling: RollingResistance; director: gven; gap: distance; }
}

fn main() {}
