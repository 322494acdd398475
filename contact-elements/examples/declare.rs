//! Declares a geometry, a law and an element, evaluates the element and prints R and K.
//!
//! Run: `cargo run --release -p contact-elements --example declare`

use contact_elements::{Error, Evaluation, Status, evaluate};

/// What this program declares. Any module will do; the items become types in it.
mod pairs {
    contact_elements::contact_elements! {
        /// Quadrilateral with eight nodes, xi, eta in [-1, 1]: corners, then the middles of the sides.
        surface Quad8(xi, eta) in square {
            let a = 1 - xi;
            let b = 1 + xi;
            let c = 1 - eta;
            let d = 1 + eta;
            N = [
                a*c*(-1 - xi - eta)/4, b*c*(-1 + xi - eta)/4,
                b*d*(-1 + xi + eta)/4, a*d*(-1 - xi + eta)/4,
                a*b*c/2, b*c*d/2, a*b*d/2, a*c*d/2,
            ];
        }

        /// Penalty that stiffens with depth: N = eps_n g (1 + (g/h)^2), active at g < 0.
        normal law Stiffening(g; eps_n: "force/length" in (0, inf), h: "length" in (0, inf)) {
            let t = g/h;
            N = eps_n*g*(1 + t*t);
            W = eps_n*g*g*(1/2 + t*t/4);
        }

        /// A point against a facet with eight nodes.
        element PointQuad8 { slave: point; master: Quad8; normal: Stiffening; }
    }
}

fn main() -> Result<(), Error> {
    let element = pairs::PointQuad8::DESCRIPTOR;
    println!("parameters of {}:", text(element.name));
    for parameter in element.parameters {
        println!("  {} [{}]", text(parameter.name), text(parameter.unit));
    }
    println!("operations of the point programs: {}", element.operations);

    // The slave point below a facet whose sides bulge upwards by 0.05.
    let x: [f64; 27] = [
        0.1, -0.2, 0.05, // slave
        -1.0, -1.0, 0.0, 1.0, -1.0, 0.0, 1.0, 1.0, 0.0, -1.0, 1.0, 0.0, // corners
        0.0, -1.0, 0.05, 1.0, 0.0, 0.05, 0.0, 1.0, 0.05, -1.0, 0.0, 0.05, // middles
    ];
    let (mut residual, mut tangent) = ([0.0; 27], [0.0; 27 * 27]);
    let summary = evaluate(
        element,
        &mut Evaluation {
            x: &x,
            parameters: &[1.0e3, 0.1, 0.0, 1.0], // eps_n, h, r0, orientation
            residual: &mut residual,
            tangent: &mut tangent,
            ..Evaluation::default()
        },
    )?;
    assert_eq!(summary.status, Status::Closed);

    println!("R, force on each node:");
    for node in residual.chunks(3) {
        println!("  {:12.6} {:12.6} {:12.6}", node[0], node[1], node[2]);
    }
    println!("K, rows of the slave point, columns of the slave point:");
    for row in tangent.chunks(27).take(3) {
        println!("  {:12.4} {:12.4} {:12.4}", row[0], row[1], row[2]);
    }
    let sum: f64 = residual.iter().skip(2).step_by(3).sum();
    let largest = residual.iter().fold(0.0_f64, |most, r| most.max(r.abs()));
    println!("sum of the z forces / largest force: {:.1e}", sum / largest);
    assert!(sum.abs() < 1e-14 * largest);
    Ok(())
}

/// Names in a descriptor end with a zero byte, for C.
fn text(name: &str) -> &str {
    name.trim_end_matches('\0')
}
