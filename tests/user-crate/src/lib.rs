//! Contact elements of a railway program: a wheel tread, a rail head, serendipity facets and a
//! softened contact law, beside geometries and laws of the built-in library.

contact_elements::contact_elements! {
    export rail;

    /// Tread of a wheel that turns about the y axis; u: angle [rad], v: along the axis [length].
    /// radius: at v = 0; conicity: loss of radius per length of the axis; hollow: wear, half the
    /// curvature of the profile.
    rigid surface WheelTread(u, v;
        radius: "length" in (0, inf),
        conicity: "1" in [-1, 1],
        hollow: "1/length" in (-inf, inf)
    ) {
        let s = radius - conicity*v + hollow*v*v;
        rho = [s*sin(u), v, s*cos(u)];
    }

    /// Head of a straight rail along x, its crown touching the plane z = 0 from below.
    rigid distance RailHead(x, y, z; crown: "length" in (0, inf)) {
        d = sqrt(y*y + (z + crown)*(z + crown)) - crown;
    }

    /// Serendipity quadrilateral, xi, eta in [-1, 1]: four corners, then the middles of the sides.
    surface Quad8(xi, eta) in square {
        let a = 1 - xi;
        let b = 1 + xi;
        let c = 1 - eta;
        let d = 1 + eta;
        N = [
            -a*c*(1 + xi + eta)/4,
            -b*c*(1 - xi + eta)/4,
            -b*d*(1 - xi - eta)/4,
            -a*d*(1 + xi - eta)/4,
            a*b*c/2,
            b*c*d/2,
            a*b*d/2,
            a*c*d/2,
        ];
    }

    /// Softened contact, active at g < c: with s = 1 - g/c, N = -p s^2 (s + 3) exp(s - 1)/4, so that
    /// N = -p at g = 0 and both N and its slope vanish at g = c. Defined down to g = -20 c.
    normal law Softened(g; p: "force" in (0, inf), c: "length" in (0, inf)) {
        let s = 1 - g/c;
        let unit = p*exp(s - 1)/4;
        active = g < c;
        valid = g > -20*c;
        N = -unit*s*s*(s + 3);
        W = unit*c*s*s*s;
    }

    /// Friction whose coefficient falls with the pressure and, from m to half of it, with the path slid:
    /// bound = m p/(1 + p/q) (1 + exp(-slip/d))/2. k: stiffness of sticking.
    tangential law Worn(pressure, slip;
        k: "force/length" in (0, inf),
        m: "1" in (0, inf),
        q: "force" in (0, inf),
        d: "length" in (0, inf)
    ) {
        let coefficient = m*(1 + exp(-slip/d))/2;
        stiffness = k;
        bound = coefficient*pressure/(1 + pressure/q);
    }

    /// Contact wires that grip one another: a moment whose bound falls from lever to half of it with the angle rolled.
    /// r: stiffness against the angle.
    tangential law Grip(pressure, angle;
        r: "force*length" in (0, inf),
        lever: "length" in (0, inf),
        turn: "rad" in (0, inf)
    ) {
        stiffness = r;
        bound = lever*pressure*(1 + exp(-angle/turn))/2;
    }

    /// Point against a serendipity facet, softened.
    element PointQuad8 { slave: point; master: Quad8; normal: Softened; }
    /// Point against a placed wheel tread.
    element PointWheelTread { slave: point; master: WheelTread placed; normal: Penalty; }
    /// Serendipity facet on a placed rail head, softened.
    element Quad8RailHead { slave: Quad8 at gauss(3, 3); master: RailHead placed; normal: Softened; }
    /// Built-in bilinear facet on a serendipity facet.
    element Quad4Quad8 { slave: Quad4 at gauss(2, 2); master: Quad8; normal: Penalty; }
    /// A point of any discretisation on a built-in torus, softened.
    element InterpolatedTorus { slave: interpolated; master: Torus placed; normal: Softened; }
    /// Point against a serendipity facet, softened, with declared friction.
    element PointQuad8Worn { slave: point; master: Quad8; normal: Softened; tangential: Worn; }
    /// Contact wires that slide on one another and grip.
    element ContactWires { slave: Line2; master: Line2; gap: distance; normal: Penalty; tangential: Coulomb; rolling: Grip; director: given; }
}
