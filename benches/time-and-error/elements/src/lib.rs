//! Elements of the benchmark that the library does not have: larger facets, rules of integration, one detour.

contact_elements::contact_elements! {
    /// Bicubic quadrilateral, xi, eta in [-1, 1], nodes at -1, -1/3, 1/3, 1 with xi fastest.
    surface Quad16(xi, eta) in square {
        let p = 9*xi*xi - 1;
        let q = 9*(xi*xi - 1);
        let r = 9*eta*eta - 1;
        let s = 9*(eta*eta - 1);
        let a0 = p*(1 - xi)/16;
        let a1 = q*(3*xi - 1)/16;
        let a2 = -q*(3*xi + 1)/16;
        let a3 = p*(1 + xi)/16;
        let b0 = r*(1 - eta)/16;
        let b1 = s*(3*eta - 1)/16;
        let b2 = -s*(3*eta + 1)/16;
        let b3 = r*(1 + eta)/16;
        N = [
            a0*b0, a1*b0, a2*b0, a3*b0,
            a0*b1, a1*b1, a2*b1, a3*b1,
            a0*b2, a1*b2, a2*b2, a3*b2,
            a0*b3, a1*b3, a2*b3, a3*b3,
        ];
    }

    /// Biquartic quadrilateral, xi, eta in [-1, 1], nodes at -1, -1/2, 0, 1/2, 1 with xi fastest.
    surface Quad25(xi, eta) in square {
        let p = xi*(4*xi*xi - 1)/6;
        let q = 4*xi*(1 - xi*xi)/3;
        let r = eta*(4*eta*eta - 1)/6;
        let s = 4*eta*(1 - eta*eta)/3;
        let a0 = p*(xi - 1);
        let a1 = q*(2*xi - 1);
        let a2 = (4*xi*xi - 1)*(xi*xi - 1);
        let a3 = q*(2*xi + 1);
        let a4 = p*(xi + 1);
        let b0 = r*(eta - 1);
        let b1 = s*(2*eta - 1);
        let b2 = (4*eta*eta - 1)*(eta*eta - 1);
        let b3 = s*(2*eta + 1);
        let b4 = r*(eta + 1);
        N = [
            a0*b0, a1*b0, a2*b0, a3*b0, a4*b0,
            a0*b1, a1*b1, a2*b1, a3*b1, a4*b1,
            a0*b2, a1*b2, a2*b2, a3*b2, a4*b2,
            a0*b3, a1*b3, a2*b3, a3*b3, a4*b3,
            a0*b4, a1*b4, a2*b4, a3*b4, a4*b4,
        ];
    }

    /// Rigid cylinder about the z axis without a projection in closed form.
    rigid surface CylinderByNewton(u, v; radius: "length" in (0, inf)) {
        rho = [radius*cos(u), radius*sin(u), v];
    }

    /// Point against a bicubic facet.
    element PointQuad16 { slave: point; master: Quad16; normal: Penalty; }
    /// Point against a biquartic facet.
    element PointQuad25 { slave: point; master: Quad25; normal: Penalty; }
    /// One point of a straight edge on a biquartic facet with a multiplier as unknown: 82 unknowns.
    element Line2Quad25Multiplier { slave: Line2 at given; master: Quad25; normal: Penalty; enforcement: multiplier; }
    /// Point against a placed rigid cylinder, projected by Newton's method.
    element PointCylinderByNewton { slave: point; master: CylinderByNewton placed; normal: Penalty; }

    /// Bilinear facet with 1 x 1 points on a placed rigid sphere.
    element Quad4Sphere1 { slave: Quad4 at gauss(1, 1); master: SphereDistance placed; normal: Penalty; }
    /// Bilinear facet with 2 x 2 points on a placed rigid sphere.
    element Quad4Sphere2 { slave: Quad4 at gauss(2, 2); master: SphereDistance placed; normal: Penalty; }
    /// Bilinear facet with 3 x 3 points on a placed rigid sphere.
    element Quad4Sphere3 { slave: Quad4 at gauss(3, 3); master: SphereDistance placed; normal: Penalty; }
    /// Bilinear facet with 4 x 4 points on a placed rigid sphere.
    element Quad4Sphere4 { slave: Quad4 at gauss(4, 4); master: SphereDistance placed; normal: Penalty; }
    /// Bilinear facet with 5 x 5 points on a placed rigid sphere.
    element Quad4Sphere5 { slave: Quad4 at gauss(5, 5); master: SphereDistance placed; normal: Penalty; }
    /// Bilinear facet with 6 x 6 points on a placed rigid sphere.
    element Quad4Sphere6 { slave: Quad4 at gauss(6, 6); master: SphereDistance placed; normal: Penalty; }
    /// Bilinear facet with 8 x 8 points on a placed rigid sphere.
    element Quad4Sphere8 { slave: Quad4 at gauss(8, 8); master: SphereDistance placed; normal: Penalty; }
    /// Bilinear facet with 10 x 10 points on a placed rigid sphere.
    element Quad4Sphere10 { slave: Quad4 at gauss(10, 10); master: SphereDistance placed; normal: Penalty; }
    /// Bilinear facet with 1 x 1 points on a placed rigid cylinder.
    element Quad4Cylinder1 { slave: Quad4 at gauss(1, 1); master: CylinderDistance placed; normal: Penalty; }
    /// Bilinear facet with 2 x 2 points on a placed rigid cylinder.
    element Quad4Cylinder2 { slave: Quad4 at gauss(2, 2); master: CylinderDistance placed; normal: Penalty; }
    /// Bilinear facet with 3 x 3 points on a placed rigid cylinder.
    element Quad4Cylinder3 { slave: Quad4 at gauss(3, 3); master: CylinderDistance placed; normal: Penalty; }
    /// Bilinear facet with 4 x 4 points on a placed rigid cylinder.
    element Quad4Cylinder4 { slave: Quad4 at gauss(4, 4); master: CylinderDistance placed; normal: Penalty; }
    /// Bilinear facet with 5 x 5 points on a placed rigid cylinder.
    element Quad4Cylinder5 { slave: Quad4 at gauss(5, 5); master: CylinderDistance placed; normal: Penalty; }
    /// Bilinear facet with 6 x 6 points on a placed rigid cylinder.
    element Quad4Cylinder6 { slave: Quad4 at gauss(6, 6); master: CylinderDistance placed; normal: Penalty; }
    /// Bilinear facet with 8 x 8 points on a placed rigid cylinder.
    element Quad4Cylinder8 { slave: Quad4 at gauss(8, 8); master: CylinderDistance placed; normal: Penalty; }
    /// Bilinear facet with 10 x 10 points on a placed rigid cylinder.
    element Quad4Cylinder10 { slave: Quad4 at gauss(10, 10); master: CylinderDistance placed; normal: Penalty; }
}
