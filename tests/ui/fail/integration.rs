//! Rules that are missing, unknown, of the wrong form or too large.
contact_elements::contact_elements! {
    element Missing { slave: Quad4; master: Quad4; normal: Penalty; }
    element Unknown { slave: Quad4 at gaus(2, 2); master: Quad4; normal: Penalty; }
    element OneNumber { slave: Quad4 at gauss(2); master: Quad4; normal: Penalty; }
    element TooMany { slave: Tri3 at gauss(99); master: Quad4; normal: Penalty; }
    element OfPoint { slave: point at gauss(2); master: Quad4; normal: Penalty; }
}

fn main() {}
