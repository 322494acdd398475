//! Angles of pairs that do not have one, and entries that exclude an angle.
contact_elements::contact_elements! {
    normal law Bare(g; eps) { N = eps*g; }
    normal law Shifted(g; eps) { N = eps*g; W = eps*g*g/2 + 1; }
    element Point { slave: point; master: Hermite; normal: Penalty; angle: large; }
    element Surface { slave: Line2 at gauss(2); master: Quad4; normal: Penalty; angle: small; }
    element Wire { slave: Hermite; master: Circle placed; normal: Penalty; gap: distance; angle: large; }
    element Flat { dimension: 2; slave: Line2 at gauss(2); master: Line2; normal: Penalty; angle: small; }
    element Any { slave: interpolated; master: Hermite; normal: Penalty; angle: small; }
    element Edges { slave: Line2; master: Line2; normal: Penalty; gap: signed; angle: large; }
    element Friction { slave: Line2; master: Line2; normal: Penalty; tangential: Coulomb; gap: distance; angle: large; }
    element Multiplier { slave: Line2; master: Line2; normal: Penalty; enforcement: augmented; gap: distance; angle: large; }
    element Current { slave: Line2 at gauss(2); master: Line2; normal: Penalty; measure: current; angle: small; }
    element Plane { slave: Line2; master: Line2; normal: Penalty; linearisation: tangent_plane; gap: distance; angle: large; }
    element Force { slave: Line2; master: Line2; normal: Bare; gap: distance; angle: large; }
    element Jump { slave: Line2; master: Line2; normal: Shifted; gap: distance; angle: large; }
    element Word { slave: Line2; master: Line2; normal: Penalty; gap: distance; angle: steep; }
    element Twice { slave: Line2; master: Line2; normal: Penalty; gap: distance; angle: large; angle: small; }
}

fn main() {}
