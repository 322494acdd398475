//! Geometries: every kind, every domain, every entry.
contact_elements::contact_elements! {
    /// Straight segment on [-1, 1].
    curve Segment(xi) in line { N = [(1 - xi)/2, (1 + xi)/2]; }
    /// The same on [0, 1].
    curve UnitSegment(t) in unit_line { N = [1 - t, t]; }
    /// The same on [2, 4], with bindings that build on each other.
    curve KnotSpan(t) in interval(2, 4) {
        let s = (t - 2)/2;
        let r = 1 - s;
        N = [r, s];
    }
    /// Cubic Hermite curve: controls 1 and 3 are tangents.
    curve Cubic(xi) in line {
        let a = 1 - xi;
        let b = 1 + xi;
        N = [a*a*(2 + xi)/4, a*a*b/4, b*b*(2 - xi)/4, -b*b*a/4];
        vectors = [1, 3];
    }
    /// An arc, exact with its weights.
    curve Arc(t) in unit_line rational { N = [(1 - t)*(1 - t), 2*t*(1 - t), t*t]; }
    /// Flat triangle.
    surface Triangle(xi, eta) in triangle { N = [1 - xi - eta, xi, eta]; }
    /// Bilinear facet on [-1, 1]^2.
    surface Facet(xi, eta) in square {
        N = [(1 - xi)*(1 - eta)/4, (1 + xi)*(1 - eta)/4, (1 + xi)*(1 + eta)/4, (1 - xi)*(1 + eta)/4];
    }
    /// The same on [0, 1]^2, rational.
    surface Patch(u, v) in unit_square rational { N = [(1 - u)*(1 - v), u*(1 - v), (1 - u)*v, u*v]; }
    /// The same on [0, 2] x [1, 2].
    surface Span(u, v) in rectangle(0, 2, 1, 2) {
        N = [(2 - u)*(2 - v)/2, u*(2 - v)/2, u*(v - 1)/2, (2 - u)*(v - 1)/2];
    }

    /// Without parameters, with its closed projection.
    rigid surface Floor(u, v) { rho = [u, v, 0]; projection(x, y, z) = [x, y]; }
    /// Parameters with and without units and ranges; the projection is found by iteration.
    rigid surface Saddle(u, v; a: "1/length", b) { rho = [u, v, a*u*u - b*v*v]; }
    /// Half of a bowl.
    rigid surface Bowl(u, v; depth: "length" in (0, inf)) in rectangle(-inf, inf, 0, 2.5) {
        rho = [u, v, depth*(exp(-u*u) + sin(v)*tan(v/10))];
    }
    /// A wire in 3D.
    rigid curve Wire(u; pitch: "length" in [0, 1]) { rho = [cos(u), sin(u), pitch*u]; }
    /// A curve in 2D, bounded.
    rigid curve Notch(u) in interval(-1, 2) { rho = [u, u*u*u/3]; }
    /// Distance in 3D.
    rigid distance Capsule(x, y, z; radius: "length" in (0, inf)) {
        let s = x*x + y*y;
        d = sqrt(s) - radius;
    }
    /// Distance in 2D.
    rigid distance Disc(x, y; radius: "length" in (0, inf)) { d = sqrt(x*x + y*y) - radius; }
}

#[test]
fn all_are_there() {
    assert_eq!(GEOMETRIES.len(), 16);
}
