//! The Rust code of the documentation, word for word: `tests/tests/source/doc_links.rs` compares it with `docs/`.
//!
//! Run: `cargo run --release -p contact-library --example documented`

/// `README.md`
mod readme {
    contact_elements::contact_elements! {
        /// Penalty that stiffens with depth.
        normal law Stiff(g; eps_n: "force/length" in (0, inf), h: "length" in (0, inf)) { N = eps_n*g*(1 + g*g/(h*h)); }
        /// A point against a bilinear facet.
        element PointStiff { slave: point; master: Quad4; normal: Stiff; }
    }
}

/// `docs/declare.md`
mod declare {
    contact_elements::contact_elements! {
        /// Bilinear facet, xi, eta in [-1, 1].
        surface Facet(xi, eta) in square {
            N = [(1 - xi)*(1 - eta)/4, (1 + xi)*(1 - eta)/4, (1 + xi)*(1 + eta)/4, (1 - xi)*(1 + eta)/4];
        }
        /// Linear penalty.
        normal law Spring(g; eps_n: "force/length" in (0, inf)) { N = eps_n*g; W = eps_n*g*g/2; }
        /// A point against a facet.
        element PointFacet { slave: point; master: Facet; normal: Spring; }
    }
}

/// `docs/how-to/add-a-geometry.md`
mod add_a_geometry {
    contact_elements::contact_elements! {
        /// Serendipity facet with eight nodes, xi, eta in [-1, 1]: corners, then the middles of the sides.
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
        /// A point against it.
        element PointQuad8 { slave: point; master: Quad8; normal: Penalty; }
        /// It on itself, integrated.
        element Quad8Quad8 { slave: Quad8 at gauss(3, 3); master: Quad8; normal: Penalty; }
    }
}

/// `docs/how-to/add-a-geometry.md`
mod add_a_geometry_2 {
    contact_elements::contact_elements! {
        /// Rigid paraboloid z = -c (x^2 + y^2), the body below; c: curvature.
        rigid surface Paraboloid(u, v; c: "1/length" in (0, inf)) { rho = [u, v, -c*(u*u + v*v)]; }
        /// A point on a placed paraboloid.
        element PointParaboloid { slave: point; master: Paraboloid placed; normal: Penalty; }
    }
}

/// `docs/how-to/add-a-law.md`
mod add_a_law {
    contact_elements::contact_elements! {
        /// Soft contact of a rough surface: N = -p exp(-g/s) for g < 8 s. p: pressure at g = 0; s: roughness.
        normal law Rough(g; p: "force/length^2" in (0, inf), s: "length" in (0, inf)) {
            active = g < 8*s;
            N = -p*exp(-g/s);
            W = p*s*exp(-g/s);
        }
        /// Bilinear facets with it; p is a force per area because the slave is integrated.
        element Quad4Quad4Rough { slave: Quad4 at gauss(2, 2); master: Quad4; normal: Rough; }
    }
}

/// `docs/how-to/add-a-pair.md`
mod add_a_pair {
    contact_elements::contact_elements! {
        export rods;
        /// Quadratic beam against cubic Hermite beam; r0 = sum of the radii.
        element Line3HermiteBeams { slave: Line3; master: Hermite; gap: distance; normal: Penalty; }
        /// A rope of quadratic elements on a placed torus, three points each.
        element Line3Torus { slave: Line3 at gauss(3); master: Torus placed; normal: Penalty; }
    }
}

/// `docs/how-to/lower-levels.md`
fn lower_levels() {
    use contact_elements::runtime::{Element, Traction, Vectors};
    use contact_library::PointQuad4;

    // A flat patch at z = 0 with unit tangents, the slave point 0.05 below: b = -d rho, r = slave - master.
    let vectors = Vectors::<3, 2, 3> {
        r: [0.0, 0.0, -0.05],
        b: [[-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]],
        second: [[0.0; 3]; 3],
    };
    let parameters = [1000.0, 0.0, 1.0]; // eps_n, r0, orientation
    let gap = PointQuad4::gap(&vectors, &parameters, 1.0);
    assert_eq!((gap.n, gap.gap), ([0.0, 0.0, 1.0], -0.05));
    let traction = Traction {
        traction: 1000.0 * gap.gap,
        slope: 1000.0,
        energy: 0.0,
    };
    let coefficients = PointQuad4::tangent(&vectors, &gap, &traction, &parameters, 1.0);
    assert_eq!(coefficients.p[2][2], 1000.0);
}

fn main() {
    lower_levels();
    println!("the documented code compiles and its assertions hold");
}
