///Two cubic Hermite beams.
#[derive(Clone, Copy, Debug)]
pub struct HermiteHermiteBeams;
/// ```text
/// element HermiteHermiteBeams { slave: Hermite; master: Hermite; gap: distance; normal: Penalty; }
///
/// pair          3 dimensions, slave of 4 nodes, master of 4 nodes
/// projection    2 parameters, by Newton's method
/// gap           distance
/// tangent       exact at any gap
/// normal law    Penalty, by itself
/// operations    gap 11, tangent 181, law 3; in all 195
/// left out      complement of tangent: codimension one: no direction is left over
/// ```
#[allow(non_snake_case, unused_variables, clippy::all)]
mod _element_hermitehermitebeams {
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
    /// 11 operations, 11 inputs, 5 outputs.
    #[allow(clippy::all, unused_variables, unused_doc_comments)]
    #[inline(always)]
    fn gap<T: ::contact_elements::runtime::Real>(i: &[T; 11]) -> [T; 5] {
        let [r_0, r_1, r_2, b_0_0, b_0_1, b_0_2, b_1_0, b_1_1, b_1_2, orientation, r0] = *i;
        let t4 = r_0 * r_0;
        let t5 = r_1 * r_1;
        let t6 = t4 + t5;
        let t7 = r_2 * r_2;
        let t8 = t6 + t7;
        let distance = T::sqrt(t8);
        let t11 = T::constant(1.0) / distance;
        let n_0 = r_0 * t11;
        let n_1 = r_1 * t11;
        let n_2 = r_2 * t11;
        let gap = distance - r0;
        [n_0, n_1, n_2, distance, gap]
    }
    /// 181 operations, 21 inputs, 25 outputs.
    #[allow(clippy::all, unused_variables, unused_doc_comments)]
    #[inline(always)]
    fn tangent<T: ::contact_elements::runtime::Real>(i: &[T; 21]) -> [T; 25] {
        let [n_0, n_1, n_2, distance, b_0_0, b_0_1, b_0_2, b_1_0, b_1_1, b_1_2, r_0_0,
        r_0_1, r_0_2, r_1_0, r_1_1, r_1_2, r_2_0, r_2_1, r_2_2, traction, slope] = *i;
        let t18 = n_0 * r_0_0;
        let t19 = n_1 * r_0_1;
        let t20 = t18 + t19;
        let t21 = n_2 * r_0_2;
        let t22 = t20 + t21;
        let t23 = n_0 * r_2_0;
        let t24 = n_1 * r_2_1;
        let t25 = t23 + t24;
        let t26 = n_2 * r_2_2;
        let t27 = t25 + t26;
        let t28 = -t27;
        let t29 = b_0_0 * b_0_0;
        let t30 = b_0_1 * b_0_1;
        let t31 = t29 + t30;
        let t32 = b_0_2 * b_0_2;
        let t33 = t31 + t32;
        let t34 = b_0_0 * b_1_0;
        let t35 = b_0_1 * b_1_1;
        let t36 = t34 + t35;
        let t37 = b_0_2 * b_1_2;
        let t38 = t36 + t37;
        let t40 = T::constant(1.0) / t33;
        let t41 = t38 * t40;
        let t42 = b_0_0 * t41;
        let t43 = b_0_1 * t41;
        let t44 = b_0_2 * t41;
        let t45 = b_1_0 - t42;
        let t46 = b_1_1 - t43;
        let t47 = b_1_2 - t44;
        let t48 = t45 * t45;
        let t49 = t46 * t46;
        let t50 = t48 + t49;
        let t51 = t47 * t47;
        let t52 = t50 + t51;
        let t53 = t22 * t41;
        let t54 = t41 * t53;
        let t55 = t28 - t54;
        // [eq:F-curvature]
        let t57 = t22 * distance;
        let t58 = t33 + t57;
        let t59 = t55 * distance;
        let t60 = t52 - t59;
        let t61 = t53 * distance;
        let t62 = t58 * t60;
        let t63 = t61 * t61;
        let t64 = t62 - t63;
        let t65 = T::constant(1.0) / t64;
        let t66 = t60 * t65;
        let t67 = t61 * t65;
        let t68 = t58 * t65;
        let t70 = n_0 * n_0;
        // [eq:12-main]
        let t71 = slope * t70;
        let t72 = n_0 * n_1;
        let t73 = slope * t72;
        let t74 = n_0 * n_2;
        let t75 = slope * t74;
        let t76 = n_1 * n_1;
        let t77 = slope * t76;
        let t78 = n_1 * n_2;
        let t79 = slope * t78;
        let t80 = n_2 * n_2;
        let t81 = slope * t80;
        let t82 = -traction;
        // [eq:13-curvature]
        let t84 = t40 * t82;
        let t85 = t22 * t66;
        let t86 = t53 * t67;
        let t87 = t86 - t85;
        let t88 = t84 * t87;
        let t89 = t22 * t67;
        let t90 = t53 * t68;
        let t91 = t90 - t89;
        let t92 = t84 * t91;
        let t93 = t82 / t52;
        let t94 = t55 * t68;
        let t95 = t86 + t94;
        let t96 = t93 * t95;
        let t97 = b_0_0 * t88;
        let t98 = b_0_1 * t88;
        let t99 = b_0_2 * t88;
        let t100 = t45 * t92;
        let t101 = t46 * t92;
        let t102 = t47 * t92;
        let t103 = t97 + t100;
        let t104 = t98 + t101;
        let t105 = t99 + t102;
        let t106 = b_0_0 * t92;
        let t107 = b_0_1 * t92;
        let t108 = b_0_2 * t92;
        let t109 = t45 * t96;
        let t110 = t46 * t96;
        let t111 = t47 * t96;
        let t112 = t106 + t109;
        let t113 = t107 + t110;
        let t114 = t108 + t111;
        let t115 = b_0_0 * t103;
        let t116 = t45 * t112;
        let t117 = t115 + t116;
        let t118 = b_0_0 * t104;
        let t119 = t45 * t113;
        let t120 = t118 + t119;
        let t121 = b_0_0 * t105;
        let t122 = t45 * t114;
        let t123 = t121 + t122;
        let t124 = b_0_1 * t104;
        let t125 = t46 * t113;
        let t126 = t124 + t125;
        let t127 = b_0_1 * t105;
        let t128 = t46 * t114;
        let t129 = t127 + t128;
        let t130 = b_0_2 * t105;
        let t131 = t47 * t114;
        let t132 = t130 + t131;
        let p_0_0 = t71 + t117;
        let p_0_1 = t73 + t120;
        let p_0_2 = t75 + t123;
        let p_1_1 = t77 + t126;
        let p_1_2 = t79 + t129;
        let p_2_2 = t81 + t132;
        // [eq:13-rotational-right]
        let t140 = t66 * t82;
        let t141 = b_0_0 * t140;
        let t142 = b_0_1 * t140;
        let t143 = b_0_2 * t140;
        let t144 = t67 * t82;
        let t145 = t45 * t144;
        let t146 = t46 * t144;
        let t147 = t47 * t144;
        let t148 = t141 + t145;
        let t149 = t142 + t146;
        let t150 = t143 + t147;
        let t151 = b_0_0 * t144;
        let t152 = b_0_1 * t144;
        let t153 = b_0_2 * t144;
        let t154 = t68 * t82;
        let t155 = t45 * t154;
        let t156 = t46 * t154;
        let t157 = t47 * t154;
        let right_1_0 = t151 + t155;
        let right_1_1 = t152 + t156;
        let right_1_2 = t153 + t157;
        let t161 = t41 * right_1_0;
        let t162 = t41 * right_1_1;
        let t163 = t41 * right_1_2;
        let right_0_0 = t148 - t161;
        let right_0_1 = t149 - t162;
        let right_0_2 = t150 - t163;
        // [eq:13-rotational-left]
        let t168 = t66 * t82;
        let t169 = b_0_0 * t168;
        let t170 = b_0_1 * t168;
        let t171 = b_0_2 * t168;
        let t172 = t67 * t82;
        let t173 = t45 * t172;
        let t174 = t46 * t172;
        let t175 = t47 * t172;
        let t176 = t169 + t173;
        let t177 = t170 + t174;
        let t178 = t171 + t175;
        let t179 = b_0_0 * t172;
        let t180 = b_0_1 * t172;
        let t181 = b_0_2 * t172;
        let t182 = t68 * t82;
        let t183 = t45 * t182;
        let t184 = t46 * t182;
        let t185 = t47 * t182;
        let left_1_0 = t179 + t183;
        let left_1_1 = t180 + t184;
        let left_1_2 = t181 + t185;
        let t189 = t41 * left_1_0;
        let t190 = t41 * left_1_1;
        let t191 = t41 * left_1_2;
        let left_0_0 = t176 - t189;
        let left_0_1 = t177 - t190;
        let left_0_2 = t178 - t191;
        let t195 = distance * traction;
        let t196 = -t195;
        // [eq:quadratic-rotation]
        let t198 = t66 * t196;
        let t199 = t67 * t196;
        let s_1_1 = t68 * t196;
        let t201 = t41 * s_1_1;
        let s_0_1 = t199 - t201;
        let t203 = t199 + s_0_1;
        let t204 = t41 * t203;
        let s_0_0 = t198 - t204;
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
    impl runtime::Element<3, 2, 3> for HermiteHermiteBeams {
        type Law = ::contact_elements::laws::Penalty;
        type Tangential = runtime::Frictionless;
        const LAYOUT: runtime::Layout = runtime::Layout {
            tangential: 1,
            r0: 1,
            orientation: None,
            geometry: 2,
            master_weights: 2,
            slave_weights: 2,
            point: 2,
            axis: None,
            placement: None,
            count: 2,
        };
        const SEARCH: runtime::Search = runtime::Search::Newton;
        const MOVING: bool = true;
        const CURVED: [bool; 3] = [true, false, true];
        const SIGNED: bool = false;
        const CURRENT: bool = false;
        const ENFORCEMENT: runtime::Enforcement = runtime::Enforcement::Penalty;
        const SLAVE_NODES: usize = 4;
        const MASTER_NODES: usize = 4;
        const SLAVE_AXIS: bool = false;
        const PERIODS: [f64; 2] = [0.0, 0.0];
        const DOMAINS: [runtime::Domain; 2] = [
            runtime::Domain::Interval(-1.0, 1.0),
            runtime::Domain::Interval(-1.0, 1.0),
        ];
        const TWO_CURVES: bool = true;
        const PARALLEL: runtime::Status = runtime::Status::NotUnique;
        #[inline(always)]
        fn slave<T: runtime::Real>(point: usize, parameters: &[T], s: &mut [T]) {}
        #[inline(always)]
        fn kinematics<T: runtime::Real>(
            x: &[[T; 3]],
            zeta: &[T; 2],
            parameters: &[T],
            rows: &mut runtime::Rows<'_, 2, T>,
        ) -> runtime::Vectors<3, 2, 3, T> {
            let weights = (
                parameters.get(2..).unwrap_or(&[]),
                parameters.get(2..).unwrap_or(&[]),
            );
            runtime::curve_to_curve::<
                ::contact_elements::geometry::Hermite,
                ::contact_elements::geometry::Hermite,
                3,
                4,
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
    fn kernel(
        call: &runtime::Call<'_>,
        nodes: &runtime::Nodes<'_>,
        memory: &mut [f64],
        target: &mut ::contact_elements::Target<'_>,
    ) -> Result<runtime::Summary, runtime::InputError> {
        runtime::fixed::<
            HermiteHermiteBeams,
            _,
            3,
            2,
            3,
            8,
            1,
            24,
        >(call, nodes, &[false, true, false, true, false, true, false, true], target)
    }
    impl HermiteHermiteBeams {
        /// This element with its kernels.
        pub const DESCRIPTOR: &'static ::contact_elements::Registered = {
            static DESCRIPTOR: ::contact_elements::Registered = ::contact_elements::Registered {
                descriptor: ::contact_elements::Descriptor {
                    name: "HermiteHermiteBeams\0",
                    documentation: "Two cubic Hermite beams.\0",
                    dimension: 3,
                    slave_nodes: 4,
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
                            lower: 0.0,
                            upper: f64::INFINITY,
                            closed: true,
                        },
                    ],
                    friction: false,
                    enforcement: runtime::Enforcement::Penalty,
                    rolling: false,
                    angle: None,
                    keeps_side: <HermiteHermiteBeams as runtime::Element<
                        3,
                        2,
                        3,
                    >>::KEEPS_SIDE,
                    symmetric: true,
                    tangent: true,
                    energy: false
                        || <<HermiteHermiteBeams as runtime::Element<
                            3,
                            2,
                            3,
                        >>::Law as runtime::NormalLaw>::ENERGY,
                    operations: 195,
                    formulation: 17784329202446047611,
                    vectors: &[false, true, false, true, false, true, false, true],
                    centre: <HermiteHermiteBeams as runtime::Element<3, 2, 3>>::START,
                    slave: SlaveDescription::Projected(
                        ::contact_elements::geometry::Hermite::PROGRAMS,
                    ),
                    master: MasterDescription::Shape(
                        ::contact_elements::geometry::Hermite::PROGRAMS,
                    ),
                    layout: runtime::Layout {
                        tangential: 1,
                        r0: 1,
                        orientation: None,
                        geometry: 2,
                        master_weights: 2,
                        slave_weights: 2,
                        point: 2,
                        axis: None,
                        placement: None,
                        count: 2,
                    },
                    domains: <HermiteHermiteBeams as runtime::Element<3, 2, 3>>::DOMAINS,
                    periods: <HermiteHermiteBeams as runtime::Element<3, 2, 3>>::PERIODS,
                    extents: <HermiteHermiteBeams as runtime::Element<3, 2, 3>>::EXTENTS,
                },
                kernel,
                lanes: None,
                screen: None,
            };
            &DESCRIPTOR
        };
    }
    impl HermiteHermiteBeams {
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
                    Operation::Input(10),
                    Operation::Multiply(0, 0),
                    Operation::Multiply(1, 1),
                    Operation::Add(4, 5),
                    Operation::Multiply(2, 2),
                    Operation::Add(6, 7),
                    Operation::Sqrt(8),
                    Operation::Constant(1.0),
                    Operation::Divide(10, 9),
                    Operation::Multiply(0, 11),
                    Operation::Multiply(1, 11),
                    Operation::Multiply(2, 11),
                    Operation::Subtract(9, 3),
                ],
                outputs: &[
                    ("n_0", 12),
                    ("n_1", 13),
                    ("n_2", 14),
                    ("distance", 9),
                    ("gap", 15),
                ],
                terms: &[],
                cost: 11,
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
                    Operation::Input(10),
                    Operation::Input(11),
                    Operation::Input(12),
                    Operation::Input(16),
                    Operation::Input(17),
                    Operation::Input(18),
                    Operation::Input(19),
                    Operation::Input(20),
                    Operation::Multiply(0, 10),
                    Operation::Multiply(1, 11),
                    Operation::Add(18, 19),
                    Operation::Multiply(2, 12),
                    Operation::Add(20, 21),
                    Operation::Multiply(0, 13),
                    Operation::Multiply(1, 14),
                    Operation::Add(23, 24),
                    Operation::Multiply(2, 15),
                    Operation::Add(25, 26),
                    Operation::Negate(27),
                    Operation::Multiply(4, 4),
                    Operation::Multiply(5, 5),
                    Operation::Add(29, 30),
                    Operation::Multiply(6, 6),
                    Operation::Add(31, 32),
                    Operation::Multiply(4, 7),
                    Operation::Multiply(5, 8),
                    Operation::Add(34, 35),
                    Operation::Multiply(6, 9),
                    Operation::Add(36, 37),
                    Operation::Constant(1.0),
                    Operation::Divide(39, 33),
                    Operation::Multiply(38, 40),
                    Operation::Multiply(4, 41),
                    Operation::Multiply(5, 41),
                    Operation::Multiply(6, 41),
                    Operation::Subtract(7, 42),
                    Operation::Subtract(8, 43),
                    Operation::Subtract(9, 44),
                    Operation::Multiply(45, 45),
                    Operation::Multiply(46, 46),
                    Operation::Add(48, 49),
                    Operation::Multiply(47, 47),
                    Operation::Add(50, 51),
                    Operation::Multiply(22, 41),
                    Operation::Multiply(41, 53),
                    Operation::Subtract(28, 54),
                    Operation::Term(3, 0),
                    Operation::Multiply(22, 56),
                    Operation::Add(33, 57),
                    Operation::Multiply(55, 56),
                    Operation::Subtract(52, 59),
                    Operation::Multiply(53, 56),
                    Operation::Multiply(58, 60),
                    Operation::Multiply(61, 61),
                    Operation::Subtract(62, 63),
                    Operation::Divide(39, 64),
                    Operation::Multiply(60, 65),
                    Operation::Multiply(61, 65),
                    Operation::Multiply(58, 65),
                    Operation::Term(17, 1),
                    Operation::Multiply(0, 0),
                    Operation::Multiply(69, 70),
                    Operation::Multiply(0, 1),
                    Operation::Multiply(69, 72),
                    Operation::Multiply(0, 2),
                    Operation::Multiply(69, 74),
                    Operation::Multiply(1, 1),
                    Operation::Multiply(69, 76),
                    Operation::Multiply(1, 2),
                    Operation::Multiply(69, 78),
                    Operation::Multiply(2, 2),
                    Operation::Multiply(69, 80),
                    Operation::Negate(16),
                    Operation::Term(82, 2),
                    Operation::Multiply(40, 83),
                    Operation::Multiply(22, 66),
                    Operation::Multiply(53, 67),
                    Operation::Subtract(86, 85),
                    Operation::Multiply(84, 87),
                    Operation::Multiply(22, 67),
                    Operation::Multiply(53, 68),
                    Operation::Subtract(90, 89),
                    Operation::Multiply(84, 91),
                    Operation::Divide(83, 52),
                    Operation::Multiply(55, 68),
                    Operation::Add(86, 94),
                    Operation::Multiply(93, 95),
                    Operation::Multiply(4, 88),
                    Operation::Multiply(5, 88),
                    Operation::Multiply(6, 88),
                    Operation::Multiply(45, 92),
                    Operation::Multiply(46, 92),
                    Operation::Multiply(47, 92),
                    Operation::Add(97, 100),
                    Operation::Add(98, 101),
                    Operation::Add(99, 102),
                    Operation::Multiply(4, 92),
                    Operation::Multiply(5, 92),
                    Operation::Multiply(6, 92),
                    Operation::Multiply(45, 96),
                    Operation::Multiply(46, 96),
                    Operation::Multiply(47, 96),
                    Operation::Add(106, 109),
                    Operation::Add(107, 110),
                    Operation::Add(108, 111),
                    Operation::Multiply(4, 103),
                    Operation::Multiply(45, 112),
                    Operation::Add(115, 116),
                    Operation::Multiply(4, 104),
                    Operation::Multiply(45, 113),
                    Operation::Add(118, 119),
                    Operation::Multiply(4, 105),
                    Operation::Multiply(45, 114),
                    Operation::Add(121, 122),
                    Operation::Multiply(5, 104),
                    Operation::Multiply(46, 113),
                    Operation::Add(124, 125),
                    Operation::Multiply(5, 105),
                    Operation::Multiply(46, 114),
                    Operation::Add(127, 128),
                    Operation::Multiply(6, 105),
                    Operation::Multiply(47, 114),
                    Operation::Add(130, 131),
                    Operation::Add(71, 117),
                    Operation::Add(73, 120),
                    Operation::Add(75, 123),
                    Operation::Add(77, 126),
                    Operation::Add(79, 129),
                    Operation::Add(81, 132),
                    Operation::Term(82, 4),
                    Operation::Multiply(66, 139),
                    Operation::Multiply(4, 140),
                    Operation::Multiply(5, 140),
                    Operation::Multiply(6, 140),
                    Operation::Multiply(67, 139),
                    Operation::Multiply(45, 144),
                    Operation::Multiply(46, 144),
                    Operation::Multiply(47, 144),
                    Operation::Add(141, 145),
                    Operation::Add(142, 146),
                    Operation::Add(143, 147),
                    Operation::Multiply(4, 144),
                    Operation::Multiply(5, 144),
                    Operation::Multiply(6, 144),
                    Operation::Multiply(68, 139),
                    Operation::Multiply(45, 154),
                    Operation::Multiply(46, 154),
                    Operation::Multiply(47, 154),
                    Operation::Add(151, 155),
                    Operation::Add(152, 156),
                    Operation::Add(153, 157),
                    Operation::Multiply(41, 158),
                    Operation::Multiply(41, 159),
                    Operation::Multiply(41, 160),
                    Operation::Subtract(148, 161),
                    Operation::Subtract(149, 162),
                    Operation::Subtract(150, 163),
                    Operation::Term(82, 5),
                    Operation::Multiply(66, 167),
                    Operation::Multiply(4, 168),
                    Operation::Multiply(5, 168),
                    Operation::Multiply(6, 168),
                    Operation::Multiply(67, 167),
                    Operation::Multiply(45, 172),
                    Operation::Multiply(46, 172),
                    Operation::Multiply(47, 172),
                    Operation::Add(169, 173),
                    Operation::Add(170, 174),
                    Operation::Add(171, 175),
                    Operation::Multiply(4, 172),
                    Operation::Multiply(5, 172),
                    Operation::Multiply(6, 172),
                    Operation::Multiply(68, 167),
                    Operation::Multiply(45, 182),
                    Operation::Multiply(46, 182),
                    Operation::Multiply(47, 182),
                    Operation::Add(179, 183),
                    Operation::Add(180, 184),
                    Operation::Add(181, 185),
                    Operation::Multiply(41, 186),
                    Operation::Multiply(41, 187),
                    Operation::Multiply(41, 188),
                    Operation::Subtract(176, 189),
                    Operation::Subtract(177, 190),
                    Operation::Subtract(178, 191),
                    Operation::Multiply(3, 16),
                    Operation::Negate(195),
                    Operation::Term(196, 6),
                    Operation::Multiply(66, 197),
                    Operation::Multiply(67, 197),
                    Operation::Multiply(68, 197),
                    Operation::Multiply(41, 200),
                    Operation::Subtract(199, 201),
                    Operation::Add(199, 202),
                    Operation::Multiply(41, 203),
                    Operation::Subtract(198, 204),
                ],
                outputs: &[
                    ("p_0_0", 133),
                    ("p_0_1", 134),
                    ("p_0_2", 135),
                    ("p_1_0", 134),
                    ("p_1_1", 136),
                    ("p_1_2", 137),
                    ("p_2_0", 135),
                    ("p_2_1", 137),
                    ("p_2_2", 138),
                    ("right_0_0", 164),
                    ("right_0_1", 165),
                    ("right_0_2", 166),
                    ("right_1_0", 158),
                    ("right_1_1", 159),
                    ("right_1_2", 160),
                    ("left_0_0", 192),
                    ("left_0_1", 193),
                    ("left_0_2", 194),
                    ("left_1_0", 186),
                    ("left_1_1", 187),
                    ("left_1_2", 188),
                    ("s_0_0", 205),
                    ("s_0_1", 202),
                    ("s_1_0", 202),
                    ("s_1_1", 200),
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
                cost: 181,
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
            name: "HermiteHermiteBeams",
            descriptor: HermiteHermiteBeams::DESCRIPTOR,
            programs: &HermiteHermiteBeams::PROGRAMS,
            slave: SlaveDescription::Projected(
                ::contact_elements::geometry::Hermite::PROGRAMS,
            ),
            master: MasterDescription::Shape(
                ::contact_elements::geometry::Hermite::PROGRAMS,
            ),
            law: &::contact_elements::laws::Penalty::PROGRAMS,
            tangential: None,
            axis: AxisDescription::None,
            rolling: None,
            angle: None,
            placed: false,
            signed: false,
            tangent_plane: false,
            current: false,
            moving: true,
            layout: runtime::Layout {
                tangential: 1,
                r0: 1,
                orientation: None,
                geometry: 2,
                master_weights: 2,
                slave_weights: 2,
                point: 2,
                axis: None,
                placement: None,
                count: 2,
            },
        };
    }
}
