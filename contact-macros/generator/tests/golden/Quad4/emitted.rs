///Bilinear quadrilateral, xi, eta in [-1, 1]: N_A = (1 + xi_A xi)(1 + eta_A eta)/4.
#[derive(Clone, Copy, Debug)]
pub struct Quad4;
#[allow(non_snake_case, clippy::all)]
mod _geometry_quad4 {
    use super::Quad4;
    #[allow(unused_imports)]
    use ::contact_elements::ElementDescription;
    #[allow(unused_imports)]
    use ::contact_elements::table::{
        AngleDescription, AxisDescription, ElementPrograms, GeometryPrograms,
        LawPrograms, MasterDescription, Operation, RollingDescription, SlaveDescription,
        Table, TangentialLawPrograms, Term,
    };
    #[allow(unused_imports)]
    use ::contact_elements::runtime;
    /// 22 operations, 2 inputs, 24 outputs.
    #[allow(clippy::all, unused_variables, unused_doc_comments)]
    #[inline(always)]
    fn rows<T: ::contact_elements::runtime::Real>(i: &[T; 2]) -> [T; 24] {
        let [xi, eta] = *i;
        let t3 = T::constant(1.0) - xi;
        let t4 = T::constant(1.0) - eta;
        let t5 = t3 * t4;
        let n_0_0 = t5 * T::constant(0.25);
        let t8 = xi + T::constant(1.0);
        let t9 = t4 * t8;
        let n_0_1 = T::constant(0.25) * t9;
        let t11 = eta + T::constant(1.0);
        let t12 = t8 * t11;
        let n_0_2 = T::constant(0.25) * t12;
        let t14 = t3 * t11;
        let n_0_3 = T::constant(0.25) * t14;
        let t17 = eta - T::constant(1.0);
        let d1_0_0 = T::constant(0.25) * t17;
        let d1_0_1 = t4 * T::constant(0.25);
        let d1_0_2 = T::constant(0.25) * t11;
        let d1_0_3 = -d1_0_2;
        let t22 = xi - T::constant(1.0);
        let d1_1_0 = T::constant(0.25) * t22;
        let d1_1_2 = T::constant(0.25) * t8;
        let d1_1_1 = -d1_1_2;
        let d1_1_3 = t3 * T::constant(0.25);
        [
            n_0_0,
            n_0_1,
            n_0_2,
            n_0_3,
            d1_0_0,
            d1_0_1,
            d1_0_2,
            d1_0_3,
            d1_1_0,
            d1_1_1,
            d1_1_2,
            d1_1_3,
            T::constant(0.0),
            T::constant(0.0),
            T::constant(0.0),
            T::constant(0.0),
            T::constant(0.25),
            T::constant((-0.25)),
            T::constant(0.25),
            T::constant((-0.25)),
            T::constant(0.0),
            T::constant(0.0),
            T::constant(0.0),
            T::constant(0.0),
        ]
    }
    /// 0 operations, 2 inputs, 16 outputs.
    #[allow(clippy::all, unused_variables, unused_doc_comments)]
    #[inline(always)]
    fn rows_third<T: ::contact_elements::runtime::Real>(i: &[T; 2]) -> [T; 16] {
        let [xi, eta] = *i;
        [
            T::constant(0.0),
            T::constant(0.0),
            T::constant(0.0),
            T::constant(0.0),
            T::constant(0.0),
            T::constant(0.0),
            T::constant(0.0),
            T::constant(0.0),
            T::constant(0.0),
            T::constant(0.0),
            T::constant(0.0),
            T::constant(0.0),
            T::constant(0.0),
            T::constant(0.0),
            T::constant(0.0),
            T::constant(0.0),
        ]
    }
    impl runtime::Shape<2, 3, 4> for Quad4 {
        const DOMAIN: runtime::Domain = runtime::Domain::Rectangle(
            [-1.0, -1.0],
            [1.0, 1.0],
        );
        const AFFINE: bool = false;
        const WEIGHTS: usize = 0;
        const VECTORS: [bool; 4] = [false, false, false, false];
        const CURVED: [bool; 3] = [false, true, false];
        #[inline(always)]
        #[allow(unused_variables)]
        fn rows<T: runtime::Real>(
            zeta: &[T; 2],
            weights: &[T],
        ) -> runtime::ShapeRows<2, 3, 4, T> {
            let zero = T::constant(0.0);
            let Some(weights) = weights.first_chunk::<0>() else {
                return runtime::ShapeRows {
                    n: [zero; 4],
                    d1: [[zero; 4]; 2],
                    d2: [[zero; 4]; 3],
                };
            };
            let o = rows(&[zeta[0], zeta[1]]);
            runtime::ShapeRows {
                n: [o[0], o[1], o[2], o[3]],
                d1: [[o[4], o[5], o[6], o[7]], [o[8], o[9], o[10], o[11]]],
                d2: [
                    [o[12], o[13], o[14], o[15]],
                    [o[16], o[17], o[18], o[19]],
                    [o[20], o[21], o[22], o[23]],
                ],
            }
        }
        #[inline(always)]
        #[allow(unused_variables)]
        fn third(zeta: &[f64; 2], weights: &[f64]) -> [[f64; 4]; 4] {
            let Some(weights) = weights.first_chunk::<0>() else {
                return [[0.0; 4]; 4];
            };
            let o = rows_third(&[zeta[0], zeta[1]]);
            [
                [o[0], o[1], o[2], o[3]],
                [o[4], o[5], o[6], o[7]],
                [o[8], o[9], o[10], o[11]],
                [o[12], o[13], o[14], o[15]],
            ]
        }
    }
    impl Quad4 {
        /// The programs of this geometry, for verification and for the search over its domain.
        pub const PROGRAMS: &'static GeometryPrograms = {
            static PROGRAMS: GeometryPrograms = GeometryPrograms {
                name: "Quad4",
                values: Table {
                    name: "rows",
                    inputs: &["xi", "eta"],
                    operations: &[
                        Operation::Input(0),
                        Operation::Input(1),
                        Operation::Constant(1.0),
                        Operation::Subtract(2, 0),
                        Operation::Subtract(2, 1),
                        Operation::Multiply(3, 4),
                        Operation::Constant(0.25),
                        Operation::Multiply(5, 6),
                        Operation::Add(0, 2),
                        Operation::Multiply(4, 8),
                        Operation::Multiply(6, 9),
                        Operation::Add(1, 2),
                        Operation::Multiply(8, 11),
                        Operation::Multiply(6, 12),
                        Operation::Multiply(3, 11),
                        Operation::Multiply(6, 14),
                        Operation::Constant(0.0),
                        Operation::Subtract(1, 2),
                        Operation::Multiply(6, 17),
                        Operation::Multiply(4, 6),
                        Operation::Multiply(6, 11),
                        Operation::Negate(20),
                        Operation::Subtract(0, 2),
                        Operation::Multiply(6, 22),
                        Operation::Multiply(6, 8),
                        Operation::Negate(24),
                        Operation::Multiply(3, 6),
                        Operation::Constant((-0.25)),
                    ],
                    outputs: &[
                        ("n_0_0", 7),
                        ("n_0_1", 10),
                        ("n_0_2", 13),
                        ("n_0_3", 15),
                        ("d1_0_0", 18),
                        ("d1_0_1", 19),
                        ("d1_0_2", 20),
                        ("d1_0_3", 21),
                        ("d1_1_0", 23),
                        ("d1_1_1", 25),
                        ("d1_1_2", 24),
                        ("d1_1_3", 26),
                        ("d2_0_0", 16),
                        ("d2_0_1", 16),
                        ("d2_0_2", 16),
                        ("d2_0_3", 16),
                        ("d2_1_0", 6),
                        ("d2_1_1", 27),
                        ("d2_1_2", 6),
                        ("d2_1_3", 27),
                        ("d2_2_0", 16),
                        ("d2_2_1", 16),
                        ("d2_2_2", 16),
                        ("d2_2_3", 16),
                    ],
                    terms: &[],
                    cost: 22,
                    compiled: |inputs, outputs| {
                        if let Some(inputs) = inputs.first_chunk() {
                            for (to, from) in outputs.iter_mut().zip(rows(inputs)) {
                                *to = from;
                            }
                        }
                    },
                },
                third: Some(Table {
                    name: "rows_third",
                    inputs: &["xi", "eta"],
                    operations: &[Operation::Constant(0.0)],
                    outputs: &[
                        ("d3_0_0", 0),
                        ("d3_0_1", 0),
                        ("d3_0_2", 0),
                        ("d3_0_3", 0),
                        ("d3_1_0", 0),
                        ("d3_1_1", 0),
                        ("d3_1_2", 0),
                        ("d3_1_3", 0),
                        ("d3_2_0", 0),
                        ("d3_2_1", 0),
                        ("d3_2_2", 0),
                        ("d3_2_3", 0),
                        ("d3_3_0", 0),
                        ("d3_3_1", 0),
                        ("d3_3_2", 0),
                        ("d3_3_3", 0),
                    ],
                    terms: &[],
                    cost: 0,
                    compiled: |inputs, outputs| {
                        if let Some(inputs) = inputs.first_chunk() {
                            for (to, from) in outputs.iter_mut().zip(rows_third(inputs))
                            {
                                *to = from;
                            }
                        }
                    },
                }),
                projection: None,
            };
            &PROGRAMS
        };
    }
}
