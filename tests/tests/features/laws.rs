//! Normal laws: with and without an energy, conditions of both directions, every function.
contact_elements::contact_elements! {
    /// The shortest law.
    normal law Linear(g; k: "force/length" in (0, inf)) { N = k*g; }
    /// Both conditions, bindings and an energy.
    normal law Barrier(g; kappa: "force/length" in (0, inf), d: "length" in (0, inf)) {
        let s = g - d;
        active = g < d;
        valid = g > 0;
        N = -kappa*s*(2*ln(g/d) + s/g);
        W = -kappa*s*s*ln(g/d);
    }
    /// Closed range, power.
    normal law Power(g; k: "force/length^m" in (0, inf), m: "1" in [1, 10]) {
        N = -k*pow(-g, m);
        W = k*pow(-g, m + 1)/(m + 1);
    }
    /// Every other function of the language, numbers of every form.
    normal law Odd(g; k: "force" in (0, inf), l: "length" in (0, inf)) {
        let s = -g/l;
        valid = g > -0.5*l;
        N = -k*(exp(s) - 1 + 1e-3*sin(s) + 0.5*(1 - cos(s)) + tan(s)/2. + sqrt(1 + s) - 1 + atan2(s, 1));
    }
}

#[test]
fn all_are_there() {
    assert_eq!(LAWS.len(), 4);
}
