///Point against a bilinear facet.
#[derive(Clone, Copy, Debug)]
pub struct PointQuad4;
/// ```text
/// element PointQuad4 { slave: point; master: Quad4; normal: Penalty; batch: lanes; }
///
/// pair          3 dimensions, slave of 1 node, master of 4 nodes
/// projection    2 parameters, by Newton's method
/// gap           signed, along the normal
/// tangent       exact at any gap
/// normal law    Penalty, by itself
/// operations    gap 44, tangent 170, law 3; in all 217
/// left out      complement of tangent: codimension one: no direction is left over
/// ```
#[allow(non_snake_case, unused_variables, clippy::all)]
mod _element_pointquad4 {
    use super::*;
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
    /// 44 operations, 11 inputs, 5 outputs.
    #[allow(clippy::all, unused_variables, unused_doc_comments)]
    #[inline(always)]
    fn gap<T: ::contact_elements::runtime::Real>(i: &[T; 11]) -> [T; 5] {
        let [r_0, r_1, r_2, b_0_0, b_0_1, b_0_2, b_1_0, b_1_1, b_1_2, orientation, r0] = *i;
        let t11 = b_0_0 * b_0_0;
        let t12 = b_0_1 * b_0_1;
        let t13 = t11 + t12;
        let t14 = b_0_2 * b_0_2;
        let t15 = t13 + t14;
        let t16 = b_0_0 * b_1_0;
        let t17 = b_0_1 * b_1_1;
        let t18 = t16 + t17;
        let t19 = b_0_2 * b_1_2;
        let t20 = t18 + t19;
        let t21 = b_0_0 * t20;
        let t22 = b_0_1 * t20;
        let t23 = b_0_2 * t20;
        let t24 = b_1_0 * t15;
        let t25 = b_1_1 * t15;
        let t26 = b_1_2 * t15;
        let t27 = t24 - t21;
        let t28 = t25 - t22;
        let t29 = t26 - t23;
        let t30 = b_0_1 * t29;
        let t31 = b_0_2 * t28;
        let t32 = t30 - t31;
        let t33 = b_0_2 * t27;
        let t34 = b_0_0 * t29;
        let t35 = t33 - t34;
        let t36 = b_0_0 * t28;
        let t37 = b_0_1 * t27;
        let t38 = t36 - t37;
        let t39 = t32 * t32;
        let t40 = t35 * t35;
        let t41 = t39 + t40;
        let t42 = t38 * t38;
        let t43 = t41 + t42;
        let t44 = T::sqrt(t43);
        let t45 = orientation / t44;
        let n_0 = t32 * t45;
        let n_1 = t35 * t45;
        let n_2 = t38 * t45;
        let t49 = r_0 * n_0;
        let t50 = r_1 * n_1;
        let t51 = t49 + t50;
        let t52 = r_2 * n_2;
        let distance = t51 + t52;
        let gap = distance - r0;
        [n_0, n_1, n_2, distance, gap]
    }
    /// 170 operations, 21 inputs, 25 outputs.
    #[allow(clippy::all, unused_variables, unused_doc_comments)]
    #[inline(always)]
    fn tangent<T: ::contact_elements::runtime::Real>(i: &[T; 21]) -> [T; 25] {
        let [n_0, n_1, n_2, distance, b_0_0, b_0_1, b_0_2, b_1_0, b_1_1, b_1_2, r_0_0,
        r_0_1, r_0_2, r_1_0, r_1_1, r_1_2, r_2_0, r_2_1, r_2_2, traction, slope] = *i;
        let t15 = n_0 * r_1_0;
        let t16 = n_1 * r_1_1;
        let t17 = t15 + t16;
        let t18 = n_2 * r_1_2;
        let t19 = t17 + t18;
        let t20 = -t19;
        let t21 = b_0_0 * b_0_0;
        let t22 = b_0_1 * b_0_1;
        let t23 = t21 + t22;
        let t24 = b_0_2 * b_0_2;
        let t25 = t23 + t24;
        let t26 = b_0_0 * b_1_0;
        let t27 = b_0_1 * b_1_1;
        let t28 = t26 + t27;
        let t29 = b_0_2 * b_1_2;
        let t30 = t28 + t29;
        let t32 = T::constant(1.0) / t25;
        let t33 = t30 * t32;
        let t34 = b_0_0 * t33;
        let t35 = b_0_1 * t33;
        let t36 = b_0_2 * t33;
        let t37 = b_1_0 - t34;
        let t38 = b_1_1 - t35;
        let t39 = b_1_2 - t36;
        let t40 = t37 * t37;
        let t41 = t38 * t38;
        let t42 = t40 + t41;
        let t43 = t39 * t39;
        let t44 = t42 + t43;
        let t45 = t20 - t19;
        let t46 = t33 * t45;
        // [eq:F-curvature]
        let t48 = t46 * distance;
        let t49 = t44 + t48;
        let t50 = t19 * distance;
        let t51 = t25 * t49;
        let t52 = t50 * t50;
        let t53 = t51 - t52;
        let t54 = T::constant(1.0) / t53;
        let t55 = t49 * t54;
        let t56 = t50 * t54;
        let t57 = t25 * t54;
        let t59 = n_0 * n_0;
        // [eq:12-main]
        let t60 = slope * t59;
        let t61 = n_0 * n_1;
        let t62 = slope * t61;
        let t63 = n_0 * n_2;
        let t64 = slope * t63;
        let t65 = n_1 * n_1;
        let t66 = slope * t65;
        let t67 = n_1 * n_2;
        let t68 = slope * t67;
        let t69 = n_2 * n_2;
        let t70 = slope * t69;
        let t71 = -traction;
        // [eq:13-curvature]
        let t73 = t32 * t71;
        let t74 = t19 * t56;
        let t75 = t73 * t74;
        let t76 = t19 * t57;
        let t77 = t73 * t76;
        let t78 = t71 / t44;
        let t79 = t46 * t57;
        let t80 = t74 - t79;
        let t81 = t78 * t80;
        let t82 = b_0_0 * t75;
        let t83 = b_0_1 * t75;
        let t84 = b_0_2 * t75;
        let t85 = t37 * t77;
        let t86 = t38 * t77;
        let t87 = t39 * t77;
        let t88 = t82 - t85;
        let t89 = t83 - t86;
        let t90 = t84 - t87;
        let t91 = b_0_0 * t77;
        let t92 = b_0_1 * t77;
        let t93 = b_0_2 * t77;
        let t94 = t37 * t81;
        let t95 = t38 * t81;
        let t96 = t39 * t81;
        let t97 = t94 - t91;
        let t98 = t95 - t92;
        let t99 = t96 - t93;
        let t100 = b_0_0 * t88;
        let t101 = t37 * t97;
        let t102 = t100 + t101;
        let t103 = b_0_0 * t89;
        let t104 = t37 * t98;
        let t105 = t103 + t104;
        let t106 = b_0_0 * t90;
        let t107 = t37 * t99;
        let t108 = t106 + t107;
        let t109 = b_0_1 * t89;
        let t110 = t38 * t98;
        let t111 = t109 + t110;
        let t112 = b_0_1 * t90;
        let t113 = t38 * t99;
        let t114 = t112 + t113;
        let t115 = b_0_2 * t90;
        let t116 = t39 * t99;
        let t117 = t115 + t116;
        let p_0_0 = t60 + t102;
        let p_0_1 = t62 + t105;
        let p_0_2 = t64 + t108;
        let p_1_1 = t66 + t111;
        let p_1_2 = t68 + t114;
        let p_2_2 = t70 + t117;
        // [eq:13-rotational-right]
        let t125 = t55 * t71;
        let t126 = b_0_0 * t125;
        let t127 = b_0_1 * t125;
        let t128 = b_0_2 * t125;
        let t129 = t56 * t71;
        let t130 = t37 * t129;
        let t131 = t38 * t129;
        let t132 = t39 * t129;
        let t133 = t126 - t130;
        let t134 = t127 - t131;
        let t135 = t128 - t132;
        let t136 = b_0_0 * t129;
        let t137 = b_0_1 * t129;
        let t138 = b_0_2 * t129;
        let t139 = t57 * t71;
        let t140 = t37 * t139;
        let t141 = t38 * t139;
        let t142 = t39 * t139;
        let right_1_0 = t140 - t136;
        let right_1_1 = t141 - t137;
        let right_1_2 = t142 - t138;
        let t146 = t33 * right_1_0;
        let t147 = t33 * right_1_1;
        let t148 = t33 * right_1_2;
        let right_0_0 = t133 - t146;
        let right_0_1 = t134 - t147;
        let right_0_2 = t135 - t148;
        // [eq:13-rotational-left]
        let t153 = t55 * t71;
        let t154 = b_0_0 * t153;
        let t155 = b_0_1 * t153;
        let t156 = b_0_2 * t153;
        let t157 = t56 * t71;
        let t158 = t37 * t157;
        let t159 = t38 * t157;
        let t160 = t39 * t157;
        let t161 = t154 - t158;
        let t162 = t155 - t159;
        let t163 = t156 - t160;
        let t164 = b_0_0 * t157;
        let t165 = b_0_1 * t157;
        let t166 = b_0_2 * t157;
        let t167 = t57 * t71;
        let t168 = t37 * t167;
        let t169 = t38 * t167;
        let t170 = t39 * t167;
        let left_1_0 = t168 - t164;
        let left_1_1 = t169 - t165;
        let left_1_2 = t170 - t166;
        let t174 = t33 * left_1_0;
        let t175 = t33 * left_1_1;
        let t176 = t33 * left_1_2;
        let left_0_0 = t161 - t174;
        let left_0_1 = t162 - t175;
        let left_0_2 = t163 - t176;
        let t180 = distance * traction;
        let t181 = -t180;
        // [eq:quadratic-rotation]
        let t183 = t55 * t181;
        let t184 = t56 * t181;
        let t185 = -t184;
        let s_1_1 = t57 * t181;
        let t187 = t33 * s_1_1;
        let s_0_1 = t185 - t187;
        let t189 = s_0_1 - t184;
        let t190 = t33 * t189;
        let s_0_0 = t183 - t190;
        [
            p_0_0,
            p_0_1,
            p_0_2,
            p_0_1,
            p_1_1,
            p_1_2,
            p_0_2,
            p_1_2,
            p_2_2,
            right_0_0,
            right_0_1,
            right_0_2,
            right_1_0,
            right_1_1,
            right_1_2,
            left_0_0,
            left_0_1,
            left_0_2,
            left_1_0,
            left_1_1,
            left_1_2,
            s_0_0,
            s_0_1,
            s_0_1,
            s_1_1,
        ]
    }
    impl runtime::Element<3, 2, 3> for PointQuad4 {
        type Law = ::contact_elements::laws::Penalty;
        type Tangential = runtime::Frictionless;
        const LAYOUT: runtime::Layout = runtime::Layout {
            tangential: 1,
            r0: 1,
            orientation: Some(2),
            geometry: 3,
            master_weights: 3,
            slave_weights: 3,
            point: 3,
            axis: None,
            placement: None,
            count: 3,
        };
        const SEARCH: runtime::Search = runtime::Search::Newton;
        const MOVING: bool = true;
        const CURVED: [bool; 3] = [false, true, false];
        const SIGNED: bool = true;
        const CURRENT: bool = false;
        const ENFORCEMENT: runtime::Enforcement = runtime::Enforcement::Penalty;
        const SLAVE_NODES: usize = 1;
        const MASTER_NODES: usize = 4;
        const SLAVE_AXIS: bool = false;
        const PERIODS: [f64; 2] = [0.0, 0.0];
        const DOMAINS: [runtime::Domain; 2] = [
            runtime::Domain::Rectangle([-1.0, -1.0], [1.0, 1.0]),
            runtime::Domain::Unbounded,
        ];
        const TWO_CURVES: bool = false;
        const PARALLEL: runtime::Status = runtime::Status::Degenerate;
        #[inline(always)]
        fn slave<T: runtime::Real>(point: usize, parameters: &[T], s: &mut [T]) {
            if let Some(s) = s.first_mut() {
                *s = T::constant(1.0);
            }
        }
        #[inline(always)]
        fn kinematics<T: runtime::Real>(
            x: &[[T; 3]],
            zeta: &[T; 2],
            parameters: &[T],
            rows: &mut runtime::Rows<'_, 2, T>,
        ) -> runtime::Vectors<3, 2, 3, T> {
            let weights = parameters.get(3..).unwrap_or(&[]);
            runtime::onto_shape::<
                ::contact_elements::geometry::Quad4,
                3,
                2,
                3,
                4,
                T,
            >(x, zeta, weights, rows)
        }
        #[inline(always)]
        fn closed_projection(x: &[f64; 3], parameters: &[f64]) -> [f64; 2] {
            [0.0; 2]
        }
        #[inline(always)]
        fn gap<T: runtime::Real>(
            vectors: &runtime::Vectors<3, 2, 3, T>,
            parameters: &[T],
            orientation: T,
        ) -> runtime::Gap<3, T> {
            let r0 = parameters.get(1).copied().unwrap_or(T::constant(0.0));
            let o = gap(
                &[
                    vectors.r[0],
                    vectors.r[1],
                    vectors.r[2],
                    vectors.b[0][0],
                    vectors.b[0][1],
                    vectors.b[0][2],
                    vectors.b[1][0],
                    vectors.b[1][1],
                    vectors.b[1][2],
                    orientation,
                    r0,
                ],
            );
            runtime::Gap {
                n: [o[0], o[1], o[2]],
                distance: o[3],
                gap: o[4],
            }
        }
        #[inline(always)]
        fn tangent<T: runtime::Real>(
            vectors: &runtime::Vectors<3, 2, 3, T>,
            gap: &runtime::Gap<3, T>,
            traction: &runtime::Traction<T>,
            parameters: &[T],
            orientation: T,
        ) -> runtime::Coefficients<3, 2, T> {
            let o = tangent(
                &[
                    gap.n[0],
                    gap.n[1],
                    gap.n[2],
                    gap.distance,
                    vectors.b[0][0],
                    vectors.b[0][1],
                    vectors.b[0][2],
                    vectors.b[1][0],
                    vectors.b[1][1],
                    vectors.b[1][2],
                    vectors.second[0][0],
                    vectors.second[0][1],
                    vectors.second[0][2],
                    vectors.second[1][0],
                    vectors.second[1][1],
                    vectors.second[1][2],
                    vectors.second[2][0],
                    vectors.second[2][1],
                    vectors.second[2][2],
                    traction.traction,
                    traction.slope,
                ],
            );
            runtime::Coefficients {
                p: [[o[0], o[1], o[2]], [o[3], o[4], o[5]], [o[6], o[7], o[8]]],
                right: [[o[9], o[10], o[11]], [o[12], o[13], o[14]]],
                left: [[o[15], o[16], o[17]], [o[18], o[19], o[20]]],
                s: [[o[21], o[22]], [o[23], o[24]]],
            }
        }
        #[inline(always)]
        fn measure(
            point: usize,
            reference: &[[f64; 3]],
            x: &[[f64; 3]],
            parameters: &[f64],
            variation: &mut [f64],
        ) -> runtime::Measure<3> {
            runtime::Measure::default()
        }
    }
    fn lanes(run: &mut ::contact_elements::Run<'_>, width: runtime::Width) {
        runtime::evaluate_batch::<
            PointQuad4,
            _,
            3,
            2,
            3,
            5,
        >(run, width, &[false, false, false, false, false])
    }
    fn screen(
        run: &::contact_elements::Run<'_>,
        place: (usize, usize),
        bounds: &mut [f64; runtime::SCREENED],
    ) -> u32 {
        runtime::screen::<
            PointQuad4,
            _,
            3,
            2,
            3,
            5,
        >(run, place, &[false, false, false, false, false], bounds)
    }
    fn kernel(
        call: &runtime::Call<'_>,
        nodes: &runtime::Nodes<'_>,
        memory: &mut [f64],
        target: &mut ::contact_elements::Target<'_>,
    ) -> Result<runtime::Summary, runtime::InputError> {
        runtime::fixed::<
            PointQuad4,
            _,
            3,
            2,
            3,
            5,
            1,
            16,
        >(call, nodes, &[false, false, false, false, false], target)
    }
    impl PointQuad4 {
        /// This element with its kernels.
        pub const DESCRIPTOR: &'static ::contact_elements::Registered = {
            static DESCRIPTOR: ::contact_elements::Registered = ::contact_elements::Registered {
                descriptor: ::contact_elements::Descriptor {
                    name: "PointQuad4\0",
                    documentation: "Point against a bilinear facet.\0",
                    dimension: 3,
                    slave_nodes: 1,
                    master_nodes: 4,
                    interpolated: false,
                    points: 1,
                    projected: 2,
                    parameters: &[
                        ::contact_elements::Parameter {
                            name: "eps_n\0",
                            unit: "force/length\0",
                            lower: 0.0,
                            upper: f64::INFINITY,
                            closed: false,
                        },
                        ::contact_elements::Parameter {
                            name: "r0\0",
                            unit: "length\0",
                            lower: f64::NEG_INFINITY,
                            upper: f64::INFINITY,
                            closed: true,
                        },
                        ::contact_elements::Parameter {
                            name: "orientation\0",
                            unit: "1\0",
                            lower: -1.0,
                            upper: 1.0,
                            closed: true,
                        },
                    ],
                    friction: false,
                    enforcement: runtime::Enforcement::Penalty,
                    rolling: false,
                    angle: None,
                    keeps_side: <PointQuad4 as runtime::Element<3, 2, 3>>::KEEPS_SIDE,
                    symmetric: true,
                    tangent: true,
                    energy: false
                        || <<PointQuad4 as runtime::Element<
                            3,
                            2,
                            3,
                        >>::Law as runtime::NormalLaw>::ENERGY,
                    operations: 217,
                    formulation: 3164916558504491066,
                    vectors: &[false, false, false, false, false],
                    centre: <PointQuad4 as runtime::Element<3, 2, 3>>::START,
                    slave: SlaveDescription::Point,
                    master: MasterDescription::Shape(
                        ::contact_elements::geometry::Quad4::PROGRAMS,
                    ),
                    layout: runtime::Layout {
                        tangential: 1,
                        r0: 1,
                        orientation: Some(2),
                        geometry: 3,
                        master_weights: 3,
                        slave_weights: 3,
                        point: 3,
                        axis: None,
                        placement: None,
                        count: 3,
                    },
                    domains: <PointQuad4 as runtime::Element<3, 2, 3>>::DOMAINS,
                    periods: <PointQuad4 as runtime::Element<3, 2, 3>>::PERIODS,
                    extents: <PointQuad4 as runtime::Element<3, 2, 3>>::EXTENTS,
                },
                kernel,
                lanes: Some(lanes),
                screen: if runtime::is_screened::<PointQuad4, 3, 2, 3, 5>() {
                    Some(screen)
                } else {
                    None
                },
            };
            &DESCRIPTOR
        };
    }
    impl PointQuad4 {
        /// The programs of this element, for verification.
        pub const PROGRAMS: ElementPrograms = ElementPrograms {
            gap: Table {
                name: "gap",
                inputs: &[
                    "r_0",
                    "r_1",
                    "r_2",
                    "b_0_0",
                    "b_0_1",
                    "b_0_2",
                    "b_1_0",
                    "b_1_1",
                    "b_1_2",
                    "orientation",
                    "r0",
                ],
                operations: &[
                    Operation::Input(0),
                    Operation::Input(1),
                    Operation::Input(2),
                    Operation::Input(3),
                    Operation::Input(4),
                    Operation::Input(5),
                    Operation::Input(6),
                    Operation::Input(7),
                    Operation::Input(8),
                    Operation::Input(9),
                    Operation::Input(10),
                    Operation::Multiply(3, 3),
                    Operation::Multiply(4, 4),
                    Operation::Add(11, 12),
                    Operation::Multiply(5, 5),
                    Operation::Add(13, 14),
                    Operation::Multiply(3, 6),
                    Operation::Multiply(4, 7),
                    Operation::Add(16, 17),
                    Operation::Multiply(5, 8),
                    Operation::Add(18, 19),
                    Operation::Multiply(3, 20),
                    Operation::Multiply(4, 20),
                    Operation::Multiply(5, 20),
                    Operation::Multiply(6, 15),
                    Operation::Multiply(7, 15),
                    Operation::Multiply(8, 15),
                    Operation::Subtract(24, 21),
                    Operation::Subtract(25, 22),
                    Operation::Subtract(26, 23),
                    Operation::Multiply(4, 29),
                    Operation::Multiply(5, 28),
                    Operation::Subtract(30, 31),
                    Operation::Multiply(5, 27),
                    Operation::Multiply(3, 29),
                    Operation::Subtract(33, 34),
                    Operation::Multiply(3, 28),
                    Operation::Multiply(4, 27),
                    Operation::Subtract(36, 37),
                    Operation::Multiply(32, 32),
                    Operation::Multiply(35, 35),
                    Operation::Add(39, 40),
                    Operation::Multiply(38, 38),
                    Operation::Add(41, 42),
                    Operation::Sqrt(43),
                    Operation::Divide(9, 44),
                    Operation::Multiply(32, 45),
                    Operation::Multiply(35, 45),
                    Operation::Multiply(38, 45),
                    Operation::Multiply(0, 46),
                    Operation::Multiply(1, 47),
                    Operation::Add(49, 50),
                    Operation::Multiply(2, 48),
                    Operation::Add(51, 52),
                    Operation::Subtract(53, 10),
                ],
                outputs: &[
                    ("n_0", 46),
                    ("n_1", 47),
                    ("n_2", 48),
                    ("distance", 53),
                    ("gap", 54),
                ],
                terms: &[],
                cost: 44,
                compiled: |inputs, outputs| {
                    if let Some(inputs) = inputs.first_chunk() {
                        for (to, from) in outputs.iter_mut().zip(gap(inputs)) {
                            *to = from;
                        }
                    }
                },
            },
            tangent: Some(Table {
                name: "tangent",
                inputs: &[
                    "n_0",
                    "n_1",
                    "n_2",
                    "distance",
                    "b_0_0",
                    "b_0_1",
                    "b_0_2",
                    "b_1_0",
                    "b_1_1",
                    "b_1_2",
                    "r_0_0",
                    "r_0_1",
                    "r_0_2",
                    "r_1_0",
                    "r_1_1",
                    "r_1_2",
                    "r_2_0",
                    "r_2_1",
                    "r_2_2",
                    "traction",
                    "slope",
                ],
                operations: &[
                    Operation::Input(0),
                    Operation::Input(1),
                    Operation::Input(2),
                    Operation::Input(3),
                    Operation::Input(4),
                    Operation::Input(5),
                    Operation::Input(6),
                    Operation::Input(7),
                    Operation::Input(8),
                    Operation::Input(9),
                    Operation::Input(13),
                    Operation::Input(14),
                    Operation::Input(15),
                    Operation::Input(19),
                    Operation::Input(20),
                    Operation::Multiply(0, 10),
                    Operation::Multiply(1, 11),
                    Operation::Add(15, 16),
                    Operation::Multiply(2, 12),
                    Operation::Add(17, 18),
                    Operation::Negate(19),
                    Operation::Multiply(4, 4),
                    Operation::Multiply(5, 5),
                    Operation::Add(21, 22),
                    Operation::Multiply(6, 6),
                    Operation::Add(23, 24),
                    Operation::Multiply(4, 7),
                    Operation::Multiply(5, 8),
                    Operation::Add(26, 27),
                    Operation::Multiply(6, 9),
                    Operation::Add(28, 29),
                    Operation::Constant(1.0),
                    Operation::Divide(31, 25),
                    Operation::Multiply(30, 32),
                    Operation::Multiply(4, 33),
                    Operation::Multiply(5, 33),
                    Operation::Multiply(6, 33),
                    Operation::Subtract(7, 34),
                    Operation::Subtract(8, 35),
                    Operation::Subtract(9, 36),
                    Operation::Multiply(37, 37),
                    Operation::Multiply(38, 38),
                    Operation::Add(40, 41),
                    Operation::Multiply(39, 39),
                    Operation::Add(42, 43),
                    Operation::Subtract(20, 19),
                    Operation::Multiply(33, 45),
                    Operation::Term(3, 0),
                    Operation::Multiply(46, 47),
                    Operation::Add(44, 48),
                    Operation::Multiply(19, 47),
                    Operation::Multiply(25, 49),
                    Operation::Multiply(50, 50),
                    Operation::Subtract(51, 52),
                    Operation::Divide(31, 53),
                    Operation::Multiply(49, 54),
                    Operation::Multiply(50, 54),
                    Operation::Multiply(25, 54),
                    Operation::Term(14, 1),
                    Operation::Multiply(0, 0),
                    Operation::Multiply(58, 59),
                    Operation::Multiply(0, 1),
                    Operation::Multiply(58, 61),
                    Operation::Multiply(0, 2),
                    Operation::Multiply(58, 63),
                    Operation::Multiply(1, 1),
                    Operation::Multiply(58, 65),
                    Operation::Multiply(1, 2),
                    Operation::Multiply(58, 67),
                    Operation::Multiply(2, 2),
                    Operation::Multiply(58, 69),
                    Operation::Negate(13),
                    Operation::Term(71, 2),
                    Operation::Multiply(32, 72),
                    Operation::Multiply(19, 56),
                    Operation::Multiply(73, 74),
                    Operation::Multiply(19, 57),
                    Operation::Multiply(73, 76),
                    Operation::Divide(72, 44),
                    Operation::Multiply(46, 57),
                    Operation::Subtract(74, 79),
                    Operation::Multiply(78, 80),
                    Operation::Multiply(4, 75),
                    Operation::Multiply(5, 75),
                    Operation::Multiply(6, 75),
                    Operation::Multiply(37, 77),
                    Operation::Multiply(38, 77),
                    Operation::Multiply(39, 77),
                    Operation::Subtract(82, 85),
                    Operation::Subtract(83, 86),
                    Operation::Subtract(84, 87),
                    Operation::Multiply(4, 77),
                    Operation::Multiply(5, 77),
                    Operation::Multiply(6, 77),
                    Operation::Multiply(37, 81),
                    Operation::Multiply(38, 81),
                    Operation::Multiply(39, 81),
                    Operation::Subtract(94, 91),
                    Operation::Subtract(95, 92),
                    Operation::Subtract(96, 93),
                    Operation::Multiply(4, 88),
                    Operation::Multiply(37, 97),
                    Operation::Add(100, 101),
                    Operation::Multiply(4, 89),
                    Operation::Multiply(37, 98),
                    Operation::Add(103, 104),
                    Operation::Multiply(4, 90),
                    Operation::Multiply(37, 99),
                    Operation::Add(106, 107),
                    Operation::Multiply(5, 89),
                    Operation::Multiply(38, 98),
                    Operation::Add(109, 110),
                    Operation::Multiply(5, 90),
                    Operation::Multiply(38, 99),
                    Operation::Add(112, 113),
                    Operation::Multiply(6, 90),
                    Operation::Multiply(39, 99),
                    Operation::Add(115, 116),
                    Operation::Add(60, 102),
                    Operation::Add(62, 105),
                    Operation::Add(64, 108),
                    Operation::Add(66, 111),
                    Operation::Add(68, 114),
                    Operation::Add(70, 117),
                    Operation::Term(71, 4),
                    Operation::Multiply(55, 124),
                    Operation::Multiply(4, 125),
                    Operation::Multiply(5, 125),
                    Operation::Multiply(6, 125),
                    Operation::Multiply(56, 124),
                    Operation::Multiply(37, 129),
                    Operation::Multiply(38, 129),
                    Operation::Multiply(39, 129),
                    Operation::Subtract(126, 130),
                    Operation::Subtract(127, 131),
                    Operation::Subtract(128, 132),
                    Operation::Multiply(4, 129),
                    Operation::Multiply(5, 129),
                    Operation::Multiply(6, 129),
                    Operation::Multiply(57, 124),
                    Operation::Multiply(37, 139),
                    Operation::Multiply(38, 139),
                    Operation::Multiply(39, 139),
                    Operation::Subtract(140, 136),
                    Operation::Subtract(141, 137),
                    Operation::Subtract(142, 138),
                    Operation::Multiply(33, 143),
                    Operation::Multiply(33, 144),
                    Operation::Multiply(33, 145),
                    Operation::Subtract(133, 146),
                    Operation::Subtract(134, 147),
                    Operation::Subtract(135, 148),
                    Operation::Term(71, 5),
                    Operation::Multiply(55, 152),
                    Operation::Multiply(4, 153),
                    Operation::Multiply(5, 153),
                    Operation::Multiply(6, 153),
                    Operation::Multiply(56, 152),
                    Operation::Multiply(37, 157),
                    Operation::Multiply(38, 157),
                    Operation::Multiply(39, 157),
                    Operation::Subtract(154, 158),
                    Operation::Subtract(155, 159),
                    Operation::Subtract(156, 160),
                    Operation::Multiply(4, 157),
                    Operation::Multiply(5, 157),
                    Operation::Multiply(6, 157),
                    Operation::Multiply(57, 152),
                    Operation::Multiply(37, 167),
                    Operation::Multiply(38, 167),
                    Operation::Multiply(39, 167),
                    Operation::Subtract(168, 164),
                    Operation::Subtract(169, 165),
                    Operation::Subtract(170, 166),
                    Operation::Multiply(33, 171),
                    Operation::Multiply(33, 172),
                    Operation::Multiply(33, 173),
                    Operation::Subtract(161, 174),
                    Operation::Subtract(162, 175),
                    Operation::Subtract(163, 176),
                    Operation::Multiply(3, 13),
                    Operation::Negate(180),
                    Operation::Term(181, 6),
                    Operation::Multiply(55, 182),
                    Operation::Multiply(56, 182),
                    Operation::Negate(184),
                    Operation::Multiply(57, 182),
                    Operation::Multiply(33, 186),
                    Operation::Subtract(185, 187),
                    Operation::Subtract(188, 184),
                    Operation::Multiply(33, 189),
                    Operation::Subtract(183, 190),
                ],
                outputs: &[
                    ("p_0_0", 118),
                    ("p_0_1", 119),
                    ("p_0_2", 120),
                    ("p_1_0", 119),
                    ("p_1_1", 121),
                    ("p_1_2", 122),
                    ("p_2_0", 120),
                    ("p_2_1", 122),
                    ("p_2_2", 123),
                    ("right_0_0", 149),
                    ("right_0_1", 150),
                    ("right_0_2", 151),
                    ("right_1_0", 143),
                    ("right_1_1", 144),
                    ("right_1_2", 145),
                    ("left_0_0", 177),
                    ("left_0_1", 178),
                    ("left_0_2", 179),
                    ("left_1_0", 171),
                    ("left_1_1", 172),
                    ("left_1_2", 173),
                    ("s_0_0", 191),
                    ("s_0_1", 188),
                    ("s_1_0", 188),
                    ("s_1_1", 186),
                ],
                terms: &[
                    Term {
                        tag: "F-curvature",
                        present: true,
                        reason: "",
                    },
                    Term {
                        tag: "12-main",
                        present: true,
                        reason: "",
                    },
                    Term {
                        tag: "13-curvature",
                        present: true,
                        reason: "",
                    },
                    Term {
                        tag: "complement",
                        present: false,
                        reason: "codimension one: no direction is left over",
                    },
                    Term {
                        tag: "13-rotational-right",
                        present: true,
                        reason: "",
                    },
                    Term {
                        tag: "13-rotational-left",
                        present: true,
                        reason: "",
                    },
                    Term {
                        tag: "quadratic-rotation",
                        present: true,
                        reason: "",
                    },
                ],
                cost: 170,
                compiled: |inputs, outputs| {
                    if let Some(inputs) = inputs.first_chunk() {
                        for (to, from) in outputs.iter_mut().zip(tangent(inputs)) {
                            *to = from;
                        }
                    }
                },
            }),
            measure: None,
            frame: None,
            tangential_residual: None,
            tangential_tangent: None,
        };
        /// What was declared, for verification.
        pub const DESCRIPTION: ElementDescription = ElementDescription {
            name: "PointQuad4",
            descriptor: PointQuad4::DESCRIPTOR,
            programs: &PointQuad4::PROGRAMS,
            slave: SlaveDescription::Point,
            master: MasterDescription::Shape(
                ::contact_elements::geometry::Quad4::PROGRAMS,
            ),
            law: &::contact_elements::laws::Penalty::PROGRAMS,
            tangential: None,
            axis: AxisDescription::None,
            rolling: None,
            angle: None,
            placed: false,
            signed: true,
            tangent_plane: false,
            current: false,
            moving: true,
            layout: runtime::Layout {
                tangential: 1,
                r0: 1,
                orientation: Some(2),
                geometry: 3,
                master_weights: 3,
                slave_weights: 3,
                point: 3,
                axis: None,
                placement: None,
                count: 3,
            },
        };
    }
}
