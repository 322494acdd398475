//! Every kind of law and field, every form of a parameter, every function.
contact_elements::contact_elements! {
    /// Doc comments stay with their item.
    normal law Plain(g; eps) { N = eps*g; }
    normal law Ranged(g; a: "force/length" in (0, inf), b in [-1, 1], c: "length" in [0, 1e3], e: "1" in (-inf, 2.5)) {
        let scale = 1 + b*b + e*e;
        N = a*g*scale*(1 + c*c);
        W = a*g*g*scale*(1 + c*c)/2;
    }
    normal law Barrier(g; kappa: "force/length" in (0, inf), d: "length" in (0, inf)) {
        active = g < d;
        valid = g > 0;
        N = -kappa*(2*(g - d)*ln(g/d) + (g - d)*(g - d)/g);
    }
    normal law Functions(g; p: "force" in (0, inf), s: "length" in (0, inf)) {
        let x = g/s;
        N = p*(sin(x) + tan(x/2) + atan2(x, 1 + cos(x)) + (1 - exp(-x)) - sqrt(1 + x*x) + pow(1 + x*x, 0.5) + pow(x, 3));
    }
    tangential law Glue(p, s; eps_t: "force/length" in (0, inf)) { stiffness = eps_t; }
    tangential law Rubber(p, s; eps_t: "force/length" in (0, inf), mu: "1" in [0, inf]) {
        stiffness = eps_t;
        let limit = mu*p;
        bound = limit*(1 + exp(-s));
    }
    tangential law Grain(p, s; e_1: "force/length" in (0, inf), e_2: "force/length" in (0, inf), m: "1" in (0, inf)) {
        stiffness = [e_1, e_2];
        bound = [m*p, 2*m*p];
    }
    element PointPlain { slave: point; master: Quad4; normal: Plain; }
    element PointRanged { slave: point; master: Quad4; normal: Ranged; }
    element PointBarrier { slave: point; master: Quad4; normal: Barrier; }
    element PointFunctions { slave: point; master: Quad4; normal: Functions; }
    element PointGlue { slave: point; master: Quad4; normal: Plain; tangential: Glue; }
    element PointRubber { slave: point; master: Quad4; normal: Plain; tangential: Rubber; }
    element PointGrain { slave: point; master: Quad4; normal: Plain; tangential: Grain; axis: convected; }
}

fn main() {}
