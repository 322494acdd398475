//! Tangential laws: a stiffness of the pressure, one bound for two stiffnesses, no name for the slip.
contact_elements::contact_elements! {
    tangential law Soft(p, s; e: "force/length") { stiffness = e*p; bound = p; }
    tangential law Uneven(p, s; e: "force/length", mu) { stiffness = [e, 2*e]; bound = mu*p; }
    tangential law NoSlip(p; e: "force/length", mu) { stiffness = e; bound = mu*p; }
}

fn main() {}
