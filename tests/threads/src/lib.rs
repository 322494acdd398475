//! Elements of every kind of batch: in lanes and alone, one point and several, with a workspace, with multipliers.

contact_elements::contact_elements! {
    /// Point, several contacts side by side.
    element Lanes { slave: point; master: Quad4; normal: Penalty; batch: lanes; }
    /// Point, one contact after the other.
    element Alone { slave: point; master: Quad4; normal: Penalty; tangential: Coulomb; }
    /// Four points, which add to the same entries one after another.
    element Facets { slave: Quad4 at gauss(2, 2); master: Quad4; normal: Penalty; }
    /// With an unknown behind the nodes.
    element Multiplied { slave: point; master: Quad4; normal: Penalty; enforcement: multiplier; }
    /// With a workspace.
    element Interpolated { slave: interpolated; master: Quad4; normal: Penalty; }
}
