//! A whole library with a mistake in every item: one build shows all of them.
contact_elements::contact_elements! {
    export plant;

    /// Serendipity facet of a conveyor belt.
    surface Belt(xi, eta) in squar {
        N = [(1 - xi)*(1 - eta)/4, (1 + xi)*(1 - eta)/4, (1 + xi)*(1 + eta)/4, (1 - xi)*(1 + eta)/4];
    }

    /// Roller under the belt; its ends are rounded.
    rigid distance Roller(x, y, z; radius: "length" in (0, inf)) {
        d = sqrt(x*x + y*y) - raduis;
    }

    /// Rubber lining.
    normal law Rubber(g; k: "force/length" in (0, inf), e: "1" in [1, 3]) {
        N = -k*pow(-g, e);
        W = k*pow(-g, e + 1);
    }

    element PointPlate { slave: point; master: Quad44; normal: Penalty; }
    element PlateBall { slave: Quad4 at gauss(2); master: SphereDistance placed; normal: Penalty; }
    element PlateHelix { slave: point; master: Quad9; normal: Penalty; mesure: current; }
}

fn main() {}
