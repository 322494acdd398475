//! Every kind of geometry, domain and field.
contact_elements::contact_elements! {
    export kinds;
    curve Parabola(xi) in line { N = [xi*(xi - 1)/2, 1 - xi*xi, xi*(xi + 1)/2]; }
    curve Cubic(t) in unit_line {
        let s = 1 - t;
        N = [s*s*(1 + 2*t), s*s*t, t*t*(3 - 2*t), -t*t*s];
        vectors = [1, 3];
    }
    curve Span(xi) in interval(-2, 2) { N = [(2 - xi)/4, (2 + xi)/4]; }
    curve Arc(t) in unit_line rational { N = [pow(1 - t, 2), 2*t*(1 - t), pow(t, 2)]; }
    surface Facet(xi, eta) in square {
        N = [(1 - xi)*(1 - eta)/4, (1 + xi)*(1 - eta)/4, (1 + xi)*(1 + eta)/4, (1 - xi)*(1 + eta)/4];
    }
    surface Patch(u, v) in unit_square { N = [(1 - u)*(1 - v), u*(1 - v), (1 - u)*v, u*v]; }
    surface Corner(u, v) in triangle { N = [1 - u - v, u, v]; }
    surface Strip(u, v) in rectangle(0, 2, 0, 1) { N = [(2 - u)*(1 - v)/2, u*(1 - v)/2, (2 - u)*v/2, u*v/2]; }
    rigid curve Wave(u; height: "length" in (0, inf)) { rho = [u, height*sin(u), 0]; }
    rigid curve Wave2d(u; height: "length" in (0, inf)) in interval(-inf, inf) { rho = [u, -height*cos(u)]; }
    rigid surface Dome(u, v; c: "1/length" in (0, inf)) { rho = [u, v, -c*(u*u + v*v)]; }
    rigid surface Floor(u, v) in rectangle(-1, 1, -inf, inf) {
        rho = [u, v, 0];
        projection(x, y, z) = [x, y];
    }
    rigid distance Ball(x, y, z; radius: "length" in (0, inf)) { d = sqrt(x*x + y*y + z*z) - radius; }
    rigid distance Disc(x, y; radius: "length" in (0, inf)) { d = sqrt(x*x + y*y) - radius; }
    normal law Spring(g; eps_n: "force/length" in (0, inf)) { N = eps_n*g; W = eps_n*g*g/2; }
    element PointParabola { slave: point; master: Parabola; gap: distance; normal: Spring; }
    element CubicCubic { slave: Cubic; master: Cubic; gap: distance; normal: Spring; }
    element PointSpan2d { dimension: 2; slave: point; master: Span; normal: Spring; }
    element PointArc { slave: point; master: Arc; gap: distance; normal: Spring; }
    element PointPatch { slave: point; master: Patch; normal: Spring; }
    element PointCorner { slave: point; master: Corner; normal: Spring; }
    element PointStrip { slave: point; master: Strip; normal: Spring; }
    element PointWave { slave: point; master: Wave; gap: distance; normal: Spring; }
    element PointWave2d { dimension: 2; slave: point; master: Wave2d placed; normal: Spring; }
    element PointDome { slave: point; master: Dome placed; normal: Spring; }
    element PointFloor { slave: point; master: Floor; normal: Spring; }
    element PointBall { slave: point; master: Ball placed; normal: Spring; }
    element PointDisc { dimension: 2; slave: point; master: Disc; normal: Spring; }
    element FacetFacet { slave: Facet at gauss(2, 2); master: Facet; normal: Spring; }
}

fn main() {}
