#[allow(non_snake_case, non_upper_case_globals, unused_variables, clippy::all)]
mod friction {
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
    /// 55 operations, 11 inputs, 7 outputs.
    #[allow(clippy::all, unused_variables, unused_doc_comments)]
    #[inline(always)]
    pub(super) fn frame_e67ed595d8b01e9c(i: &[f64; 11]) -> [f64; 7] {
        let [n_0, n_1, n_2, b_0_0, b_0_1, b_0_2, b_1_0, b_1_1, b_1_2, moved_0, moved_1,
        ] = *i;
        let t13 = b_0_0 * b_0_0;
        let t14 = b_0_1 * b_0_1;
        let t15 = t13 + t14;
        let t16 = b_0_2 * b_0_2;
        let t17 = t15 + t16;
        let t18 = b_0_0 * b_1_0;
        let t19 = b_0_1 * b_1_1;
        let t20 = t18 + t19;
        let t21 = b_0_2 * b_1_2;
        let t22 = t20 + t21;
        let t23 = t22 / ::contact_elements::arithmetic::divisor(t17);
        let t24 = b_0_0 * t23;
        let t25 = b_0_1 * t23;
        let t26 = b_0_2 * t23;
        let t27 = b_1_0 - t24;
        let t28 = b_1_1 - t25;
        let t29 = b_1_2 - t26;
        let t30 = ::contact_elements::arithmetic::sqrt(
            ::contact_elements::arithmetic::radicand(t17),
        );
        let t31 = t27 * t27;
        let t32 = t28 * t28;
        let t33 = t31 + t32;
        let t34 = t29 * t29;
        let t35 = t33 + t34;
        let t36 = ::contact_elements::arithmetic::sqrt(
            ::contact_elements::arithmetic::radicand(t35),
        );
        let e_0_0 = 1.0 / ::contact_elements::arithmetic::divisor(t30);
        let t38 = 1.0 / ::contact_elements::arithmetic::divisor(t36);
        let t39 = b_0_0 * e_0_0;
        let t40 = b_0_1 * e_0_0;
        let t41 = b_0_2 * e_0_0;
        let t42 = t27 * t38;
        let t43 = t28 * t38;
        let t44 = t29 * t38;
        let t45 = moved_1 * t23;
        let t46 = moved_0 + t45;
        let s_0 = t30 * t46;
        let t48 = moved_1 * t36;
        let t49 = t23 * t38;
        let t50 = t40 * t44;
        let t51 = t41 * t43;
        let t52 = t50 - t51;
        let t53 = t41 * t42;
        let t54 = t39 * t44;
        let t55 = t53 - t54;
        let t56 = t39 * t43;
        let t57 = t40 * t42;
        let t58 = t56 - t57;
        let t59 = n_0 * t52;
        let t60 = n_1 * t55;
        let t61 = t59 + t60;
        let t62 = n_2 * t58;
        let t63 = t61 + t62;
        let s_1 = t48 * t63;
        let t65 = t49 * t63;
        let e_0_1 = -t65;
        let e_1_1 = t38 * t63;
        [s_0, s_1, e_0_0, e_0_1, 0.0, e_1_1, 1.0]
    }
    pub(super) const frame_e67ed595d8b01e9c_TABLE: Table = Table {
        name: "frame",
        inputs: &[
            "n_0",
            "n_1",
            "n_2",
            "b_0_0",
            "b_0_1",
            "b_0_2",
            "b_1_0",
            "b_1_1",
            "b_1_2",
            "moved_0",
            "moved_1",
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
            Operation::Constant(1.0),
            Operation::Constant(0.0),
            Operation::Multiply(3, 3),
            Operation::Multiply(4, 4),
            Operation::Add(13, 14),
            Operation::Multiply(5, 5),
            Operation::Add(15, 16),
            Operation::Multiply(3, 6),
            Operation::Multiply(4, 7),
            Operation::Add(18, 19),
            Operation::Multiply(5, 8),
            Operation::Add(20, 21),
            Operation::Divide(22, 17),
            Operation::Multiply(3, 23),
            Operation::Multiply(4, 23),
            Operation::Multiply(5, 23),
            Operation::Subtract(6, 24),
            Operation::Subtract(7, 25),
            Operation::Subtract(8, 26),
            Operation::Sqrt(17),
            Operation::Multiply(27, 27),
            Operation::Multiply(28, 28),
            Operation::Add(31, 32),
            Operation::Multiply(29, 29),
            Operation::Add(33, 34),
            Operation::Sqrt(35),
            Operation::Divide(11, 30),
            Operation::Divide(11, 36),
            Operation::Multiply(3, 37),
            Operation::Multiply(4, 37),
            Operation::Multiply(5, 37),
            Operation::Multiply(27, 38),
            Operation::Multiply(28, 38),
            Operation::Multiply(29, 38),
            Operation::Multiply(10, 23),
            Operation::Add(9, 45),
            Operation::Multiply(30, 46),
            Operation::Multiply(10, 36),
            Operation::Multiply(23, 38),
            Operation::Multiply(40, 44),
            Operation::Multiply(41, 43),
            Operation::Subtract(50, 51),
            Operation::Multiply(41, 42),
            Operation::Multiply(39, 44),
            Operation::Subtract(53, 54),
            Operation::Multiply(39, 43),
            Operation::Multiply(40, 42),
            Operation::Subtract(56, 57),
            Operation::Multiply(0, 52),
            Operation::Multiply(1, 55),
            Operation::Add(59, 60),
            Operation::Multiply(2, 58),
            Operation::Add(61, 62),
            Operation::Multiply(48, 63),
            Operation::Multiply(49, 63),
            Operation::Negate(65),
            Operation::Multiply(38, 63),
        ],
        outputs: &[
            ("s_0", 47),
            ("s_1", 64),
            ("E_0_0", 37),
            ("E_0_1", 66),
            ("E_1_0", 12),
            ("E_1_1", 67),
            ("share", 11),
        ],
        terms: &[],
        cost: 55,
        compiled: |inputs, outputs| {
            if let Some(inputs) = inputs.first_chunk() {
                for (to, from) in outputs.iter_mut().zip(frame_e67ed595d8b01e9c(inputs))
                {
                    *to = from;
                }
            }
        },
    };
    /// 84 operations, 25 inputs, 5 outputs.
    #[allow(clippy::all, unused_variables, unused_doc_comments)]
    #[inline(always)]
    pub(super) fn tangential_residual_a145a424134ed898(i: &[f64; 25]) -> [f64; 5] {
        let [n_0, n_1, n_2, distance, b_0_0, b_0_1, b_0_2, b_1_0, b_1_1, b_1_2, r_0_0,
        r_0_1, r_0_2, r_1_0, r_1_1, r_1_2, r_2_0, r_2_1, r_2_2, e_0_0, e_0_1, e_1_0,
        e_1_1, t_0, t_1] = *i;
        let t17 = b_0_0 * e_0_0;
        let t18 = b_0_1 * e_0_0;
        let t19 = b_0_2 * e_0_0;
        let t20 = b_1_0 * e_1_0;
        let t21 = b_1_1 * e_1_0;
        let t22 = b_1_2 * e_1_0;
        let t23 = t17 + t20;
        let t24 = t18 + t21;
        let t25 = t19 + t22;
        let t26 = b_0_0 * e_0_1;
        let t27 = b_0_1 * e_0_1;
        let t28 = b_0_2 * e_0_1;
        let t29 = b_1_0 * e_1_1;
        let t30 = b_1_1 * e_1_1;
        let t31 = b_1_2 * e_1_1;
        let t32 = t26 + t29;
        let t33 = t27 + t30;
        let t34 = t28 + t31;
        let t35 = e_0_0 * e_1_0;
        let t36 = t35 + t35;
        let t37 = r_1_0 * t36;
        let t38 = r_1_1 * t36;
        let t39 = r_1_2 * t36;
        let t40 = e_0_0 * e_1_1;
        let t41 = e_0_1 * e_1_0;
        let t42 = t40 + t41;
        let t43 = r_1_0 * t42;
        let t44 = r_1_1 * t42;
        let t45 = r_1_2 * t42;
        let t46 = e_0_1 * e_1_1;
        let t47 = t46 + t46;
        let t48 = r_1_0 * t47;
        let t49 = r_1_1 * t47;
        let t50 = r_1_2 * t47;
        let t52 = n_0 * t37;
        let t53 = n_1 * t38;
        let t54 = t52 + t53;
        let t55 = n_2 * t39;
        let t56 = t54 + t55;
        let t57 = distance * t56;
        let t58 = n_0 * t43;
        let t59 = n_1 * t44;
        let t60 = t58 + t59;
        let t61 = n_2 * t45;
        let t62 = t60 + t61;
        let t63 = distance * t62;
        let t64 = n_0 * t48;
        let t65 = n_1 * t49;
        let t66 = t64 + t65;
        let t67 = n_2 * t50;
        let t68 = t66 + t67;
        let t69 = distance * t68;
        let t70 = 1.0 + t57;
        let t71 = 1.0 + t69;
        let t72 = t70 * t71;
        let t73 = t63 * t63;
        let t74 = t72 - t73;
        let t75 = 1.0 / ::contact_elements::arithmetic::divisor(t74);
        let t76 = t71 * t75;
        let t77 = t63 * t75;
        let t78 = t70 * t75;
        let t81 = t76 * t_0;
        let t82 = t77 * t_1;
        let t83 = t77 * t_0;
        let t84 = t78 * t_1;
        let t85 = t82 - t81;
        let t86 = t83 - t84;
        // [eq:tangential-direct]
        let t91 = t23 * t85;
        let t92 = t24 * t85;
        let t93 = t25 * t85;
        let t94 = t32 * t86;
        let t95 = t33 * t86;
        let t96 = t34 * t86;
        let force_0 = t91 + t94;
        let force_1 = t92 + t95;
        let force_2 = t93 + t96;
        // [eq:tangential-rotation]
        let t100 = e_0_0 * t85;
        let t101 = e_0_1 * t86;
        let t102 = t100 + t101;
        let turn_0 = distance * t102;
        let t104 = e_1_0 * t85;
        let t105 = e_1_1 * t86;
        let t106 = t104 + t105;
        let turn_1 = distance * t106;
        [force_0, force_1, force_2, turn_0, turn_1]
    }
    pub(super) const tangential_residual_a145a424134ed898_TABLE: Table = Table {
        name: "tangential_residual",
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
            "E_0_0",
            "E_0_1",
            "E_1_0",
            "E_1_1",
            "t_0",
            "t_1",
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
            Operation::Input(21),
            Operation::Input(22),
            Operation::Multiply(4, 13),
            Operation::Multiply(5, 13),
            Operation::Multiply(6, 13),
            Operation::Multiply(7, 15),
            Operation::Multiply(8, 15),
            Operation::Multiply(9, 15),
            Operation::Add(17, 20),
            Operation::Add(18, 21),
            Operation::Add(19, 22),
            Operation::Multiply(4, 14),
            Operation::Multiply(5, 14),
            Operation::Multiply(6, 14),
            Operation::Multiply(7, 16),
            Operation::Multiply(8, 16),
            Operation::Multiply(9, 16),
            Operation::Add(26, 29),
            Operation::Add(27, 30),
            Operation::Add(28, 31),
            Operation::Multiply(13, 15),
            Operation::Add(35, 35),
            Operation::Multiply(10, 36),
            Operation::Multiply(11, 36),
            Operation::Multiply(12, 36),
            Operation::Multiply(13, 16),
            Operation::Multiply(14, 15),
            Operation::Add(40, 41),
            Operation::Multiply(10, 42),
            Operation::Multiply(11, 42),
            Operation::Multiply(12, 42),
            Operation::Multiply(14, 16),
            Operation::Add(46, 46),
            Operation::Multiply(10, 47),
            Operation::Multiply(11, 47),
            Operation::Multiply(12, 47),
            Operation::Constant(1.0),
            Operation::Multiply(0, 37),
            Operation::Multiply(1, 38),
            Operation::Add(52, 53),
            Operation::Multiply(2, 39),
            Operation::Add(54, 55),
            Operation::Multiply(3, 56),
            Operation::Multiply(0, 43),
            Operation::Multiply(1, 44),
            Operation::Add(58, 59),
            Operation::Multiply(2, 45),
            Operation::Add(60, 61),
            Operation::Multiply(3, 62),
            Operation::Multiply(0, 48),
            Operation::Multiply(1, 49),
            Operation::Add(64, 65),
            Operation::Multiply(2, 50),
            Operation::Add(66, 67),
            Operation::Multiply(3, 68),
            Operation::Add(51, 57),
            Operation::Add(51, 69),
            Operation::Multiply(70, 71),
            Operation::Multiply(63, 63),
            Operation::Subtract(72, 73),
            Operation::Divide(51, 74),
            Operation::Multiply(71, 75),
            Operation::Multiply(63, 75),
            Operation::Multiply(70, 75),
            Operation::Input(23),
            Operation::Input(24),
            Operation::Multiply(76, 79),
            Operation::Multiply(77, 80),
            Operation::Multiply(77, 79),
            Operation::Multiply(78, 80),
            Operation::Subtract(82, 81),
            Operation::Subtract(83, 84),
            Operation::Term(85, 0),
            Operation::Term(86, 0),
            Operation::Term(85, 1),
            Operation::Term(86, 1),
            Operation::Multiply(23, 87),
            Operation::Multiply(24, 87),
            Operation::Multiply(25, 87),
            Operation::Multiply(32, 88),
            Operation::Multiply(33, 88),
            Operation::Multiply(34, 88),
            Operation::Add(91, 94),
            Operation::Add(92, 95),
            Operation::Add(93, 96),
            Operation::Multiply(13, 89),
            Operation::Multiply(14, 90),
            Operation::Add(100, 101),
            Operation::Multiply(3, 102),
            Operation::Multiply(15, 89),
            Operation::Multiply(16, 90),
            Operation::Add(104, 105),
            Operation::Multiply(3, 106),
        ],
        outputs: &[
            ("force_0", 97),
            ("force_1", 98),
            ("force_2", 99),
            ("turn_0", 103),
            ("turn_1", 107),
        ],
        terms: &[
            Term {
                tag: "tangential-direct",
                present: true,
                reason: "",
            },
            Term {
                tag: "tangential-rotation",
                present: true,
                reason: "",
            },
        ],
        cost: 84,
        compiled: |inputs, outputs| {
            if let Some(inputs) = inputs.first_chunk() {
                for (to, from) in outputs
                    .iter_mut()
                    .zip(tangential_residual_a145a424134ed898(inputs))
                {
                    *to = from;
                }
            }
        },
    };
    /// 435 operations, 46 inputs, 60 outputs.
    #[allow(clippy::all, unused_variables, unused_doc_comments)]
    #[inline(always)]
    pub(super) fn tangential_tangent_379a45c4216c869c(i: &[f64; 46]) -> [f64; 60] {
        let [n_0, n_1, n_2, distance, b_0_0, b_0_1, b_0_2, b_1_0, b_1_1, b_1_2, r_0_0,
        r_0_1, r_0_2, r_1_0, r_1_1, r_1_2, r_2_0, r_2_1, r_2_2, e_0_0, e_0_1, e_1_0,
        e_1_1, third_0_0, third_0_1, third_0_2, third_1_0, third_1_1, third_1_2,
        third_2_0, third_2_1, third_2_2, third_3_0, third_3_1, third_3_2, s_0, s_1, t_0,
        t_1, c_0_0, c_0_1, c_1_0, c_1_1, h_0, h_1, slope] = *i;
        let t18 = b_0_0 * e_0_0;
        let t19 = b_0_1 * e_0_0;
        let t20 = b_0_2 * e_0_0;
        let t21 = b_1_0 * e_1_0;
        let t22 = b_1_1 * e_1_0;
        let t23 = b_1_2 * e_1_0;
        let t24 = t18 + t21;
        let t25 = t19 + t22;
        let t26 = t20 + t23;
        let t27 = b_0_0 * e_0_1;
        let t28 = b_0_1 * e_0_1;
        let t29 = b_0_2 * e_0_1;
        let t30 = b_1_0 * e_1_1;
        let t31 = b_1_1 * e_1_1;
        let t32 = b_1_2 * e_1_1;
        let t33 = t27 + t30;
        let t34 = t28 + t31;
        let t35 = t29 + t32;
        let t36 = e_0_0 * e_1_0;
        let t37 = t36 + t36;
        let t38 = r_1_0 * t37;
        let t39 = r_1_1 * t37;
        let t40 = r_1_2 * t37;
        let t41 = e_0_0 * e_1_1;
        let t42 = e_0_1 * e_1_0;
        let t43 = t41 + t42;
        let t44 = r_1_0 * t43;
        let t45 = r_1_1 * t43;
        let t46 = r_1_2 * t43;
        let t47 = e_0_1 * e_1_1;
        let t48 = t47 + t47;
        let t49 = r_1_0 * t48;
        let t50 = r_1_1 * t48;
        let t51 = r_1_2 * t48;
        let t53 = n_0 * t38;
        let t54 = n_1 * t39;
        let t55 = t53 + t54;
        let t56 = n_2 * t40;
        let t57 = t55 + t56;
        let t58 = distance * t57;
        let t59 = n_0 * t44;
        let t60 = n_1 * t45;
        let t61 = t59 + t60;
        let t62 = n_2 * t46;
        let t63 = t61 + t62;
        let t64 = distance * t63;
        let t65 = n_0 * t49;
        let t66 = n_1 * t50;
        let t67 = t65 + t66;
        let t68 = n_2 * t51;
        let t69 = t67 + t68;
        let t70 = distance * t69;
        let t71 = 1.0 + t58;
        let t72 = 1.0 + t70;
        let t73 = t71 * t72;
        let t74 = t64 * t64;
        let t75 = t73 - t74;
        let t76 = 1.0 / ::contact_elements::arithmetic::divisor(t75);
        let t77 = t72 * t76;
        let t78 = t64 * t76;
        let t79 = t71 * t76;
        let t91 = t77 * t_0;
        let t92 = t78 * t_1;
        let t93 = t78 * t_0;
        let t94 = t79 * t_1;
        let t95 = t92 - t91;
        let t96 = t93 - t94;
        let t97 = t24 * t77;
        let t98 = t25 * t77;
        let t99 = t26 * t77;
        let t100 = t33 * t78;
        let t101 = t34 * t78;
        let t102 = t35 * t78;
        let z_0_position_0 = t100 - t97;
        let z_0_position_1 = t101 - t98;
        let z_0_position_2 = t102 - t99;
        let t106 = distance * t77;
        let t107 = distance * t78;
        let t108 = e_0_0 * t106;
        let t109 = e_0_1 * t107;
        let z_0_turning_0 = t109 - t108;
        let t111 = e_1_0 * t106;
        let t112 = e_1_1 * t107;
        let z_0_turning_1 = t112 - t111;
        let t114 = t24 * t78;
        let t115 = t25 * t78;
        let t116 = t26 * t78;
        let t117 = t33 * t79;
        let t118 = t34 * t79;
        let t119 = t35 * t79;
        let z_1_position_0 = t114 - t117;
        let z_1_position_1 = t115 - t118;
        let z_1_position_2 = t116 - t119;
        let t123 = distance * t79;
        let t124 = e_0_0 * t107;
        let t125 = e_0_1 * t123;
        let z_1_turning_0 = t124 - t125;
        let t127 = e_1_0 * t107;
        let t128 = e_1_1 * t123;
        let z_1_turning_1 = t127 - t128;
        let t131 = t24 * t38;
        let t132 = t25 * t39;
        let t133 = t131 + t132;
        let t134 = t26 * t40;
        let t135 = t133 + t134;
        let t136 = t135 + t135;
        let t137 = t24 * t44;
        let t138 = t25 * t45;
        let t139 = t137 + t138;
        let t140 = t26 * t46;
        let t141 = t139 + t140;
        let t142 = t141 + t141;
        let t143 = t33 * t38;
        let t144 = t34 * t39;
        let t145 = t143 + t144;
        let t146 = t35 * t40;
        let t147 = t145 + t146;
        let t148 = t141 + t147;
        let t149 = t33 * t44;
        let t150 = t34 * t45;
        let t151 = t149 + t150;
        let t152 = t35 * t46;
        let t153 = t151 + t152;
        let t154 = t24 * t49;
        let t155 = t25 * t50;
        let t156 = t154 + t155;
        let t157 = t26 * t51;
        let t158 = t156 + t157;
        let t159 = t153 + t158;
        let t160 = t153 + t153;
        let t161 = t33 * t49;
        let t162 = t34 * t50;
        let t163 = t161 + t162;
        let t164 = t35 * t51;
        let t165 = t163 + t164;
        let t166 = t165 + t165;
        // [eq:Q-bending]
        let t175 = e_0_0 * t95;
        let t176 = e_0_1 * t96;
        let t177 = t175 + t176;
        let t178 = distance * t177;
        let t179 = e_1_0 * t95;
        let t180 = e_1_1 * t96;
        let t181 = t179 + t180;
        let t182 = distance * t181;
        // [eq:Q-position]
        let t183 = t38 * t95;
        let t184 = t39 * t95;
        let t185 = t40 * t95;
        let t186 = t44 * t96;
        let t187 = t45 * t96;
        let t188 = t46 * t96;
        let p_0_position_0 = t183 + t186;
        let p_0_position_1 = t184 + t187;
        let p_0_position_2 = t185 + t188;
        // [eq:Q-tangent] [eq:Q-turning]
        let t192 = t95 + t95;
        let t193 = e_1_0 * t178;
        let t194 = e_0_0 * t182;
        let p_0_bending_1 = t193 + t194;
        // [eq:Q-position]
        let t196 = t44 * t95;
        let t197 = t45 * t95;
        let t198 = t46 * t95;
        let t199 = t49 * t96;
        let t200 = t50 * t96;
        let t201 = t51 * t96;
        let p_1_position_0 = t196 + t199;
        let p_1_position_1 = t197 + t200;
        let p_1_position_2 = t198 + t201;
        // [eq:Q-tangent] [eq:Q-turning]
        let t205 = t96 + t96;
        let t206 = e_1_1 * t178;
        let t207 = e_0_1 * t182;
        let p_1_bending_1 = t206 + t207;
        // [eq:slip-metric]
        let t219 = s_0 * c_0_0;
        // [eq:traction-metric]
        let t220 = t_0 + t219;
        let t222 = t220 * 0.5;
        // [eq:slip-metric]
        let t223 = s_1 * c_0_0;
        let t224 = 0.5 * t223;
        let t225 = s_0 * c_0_1;
        // [eq:traction-metric]
        let t226 = t_1 + t225;
        let t227 = 0.5 * t226;
        let t228 = t224 + t227;
        // [eq:slip-metric]
        let t229 = s_1 * c_0_1;
        let t230 = 0.5 * t229;
        let t231 = t136 * t222;
        // [eq:slip-change]
        let t232 = c_0_0 + t231;
        let t233 = t142 * t222;
        let t234 = c_0_1 + t233;
        let t235 = 2.0 * t222;
        let t236 = t148 * t228;
        let t237 = t232 + t236;
        let t238 = t159 * t228;
        let t239 = t234 + t238;
        let t240 = t160 * t230;
        let t241 = t237 + t240;
        let t242 = t166 * t230;
        let t243 = t239 + t242;
        let t244 = 2.0 * t230;
        // [eq:slip-metric]
        let t245 = s_0 * c_1_0;
        let t246 = 0.5 * t245;
        let t247 = s_1 * c_1_0;
        // [eq:traction-metric]
        let t248 = t_0 + t247;
        let t249 = 0.5 * t248;
        // [eq:slip-metric]
        let t250 = s_0 * c_1_1;
        let t251 = 0.5 * t250;
        let t252 = t249 + t251;
        let t253 = s_1 * c_1_1;
        // [eq:traction-metric]
        let t254 = t_1 + t253;
        let t255 = 0.5 * t254;
        let t256 = t136 * t246;
        // [eq:slip-change]
        let t257 = c_1_0 + t256;
        let t258 = t142 * t246;
        let t259 = c_1_1 + t258;
        let t260 = 2.0 * t246;
        let t261 = t148 * t252;
        let t262 = t257 + t261;
        let t263 = t159 * t252;
        let t264 = t259 + t263;
        let t265 = t160 * t255;
        let t266 = t262 + t265;
        let t267 = t166 * t255;
        let t268 = t264 + t267;
        let t269 = 2.0 * t255;
        // [eq:pressure-change]
        let t272 = slope * h_0;
        let t273 = slope * h_1;
        let t274 = t192 + t235;
        // [eq:Q-turning]
        let t275 = t96 + t228;
        // [eq:Q-tangent]
        let t276 = t96 + t228;
        let t277 = t95 + t252;
        // [eq:Q-turning]
        let t278 = t95 + t252;
        let t279 = t205 + t269;
        let t282 = t135 + t136;
        // [eq:Y-second]
        let t283 = t95 * t282;
        let t284 = t141 + t148;
        let t285 = t96 * t284;
        let t286 = t283 + t285;
        let t287 = t241 + t286;
        let t288 = t95 * t284;
        let t289 = t158 + t160;
        let t290 = t96 * t289;
        let t291 = t288 + t290;
        let t292 = t243 + t291;
        let t293 = t266 + t291;
        let t294 = t95 * t289;
        let t295 = t165 + t166;
        let t296 = t96 * t295;
        let t297 = t294 + t296;
        let t298 = t268 + t297;
        // [eq:cross]
        let t301 = e_0_0 * t95;
        let t302 = e_0_1 * t96;
        let cross_0 = t301 + t302;
        let t304 = e_1_0 * t95;
        let t305 = e_1_1 * t96;
        let cross_1 = t304 + t305;
        let t307 = e_0_0 * t192;
        // [eq:Q-turning]
        let t308 = e_0_1 * t96;
        let t309 = t307 + t308;
        let t310 = t24 * t309;
        let t311 = t25 * t309;
        let t312 = t26 * t309;
        // [eq:Q-tangent]
        let t313 = e_0_0 * t96;
        let t314 = t33 * t313;
        let t315 = t34 * t313;
        let t316 = t35 * t313;
        let p_0_turning_0_0 = t310 + t314;
        let p_0_turning_0_1 = t311 + t315;
        let p_0_turning_0_2 = t312 + t316;
        let t320 = e_1_0 * t192;
        // [eq:Q-turning]
        let t321 = e_1_1 * t96;
        let t322 = t320 + t321;
        let t323 = t24 * t322;
        let t324 = t25 * t322;
        let t325 = t26 * t322;
        // [eq:Q-tangent]
        let t326 = e_1_0 * t96;
        let t327 = t33 * t326;
        let t328 = t34 * t326;
        let t329 = t35 * t326;
        let p_0_turning_1_0 = t323 + t327;
        let p_0_turning_1_1 = t324 + t328;
        let p_0_turning_1_2 = t325 + t329;
        let t333 = e_0_1 * t95;
        let t334 = t24 * t333;
        let t335 = t25 * t333;
        let t336 = t26 * t333;
        // [eq:Q-turning]
        let t337 = e_0_0 * t95;
        let t338 = e_0_1 * t205;
        let t339 = t337 + t338;
        let t340 = t33 * t339;
        let t341 = t34 * t339;
        let t342 = t35 * t339;
        let p_1_turning_0_0 = t334 + t340;
        let p_1_turning_0_1 = t335 + t341;
        let p_1_turning_0_2 = t336 + t342;
        // [eq:Q-tangent]
        let t346 = e_1_1 * t95;
        let t347 = t24 * t346;
        let t348 = t25 * t346;
        let t349 = t26 * t346;
        // [eq:Q-turning]
        let t350 = e_1_0 * t95;
        let t351 = e_1_1 * t205;
        let t352 = t350 + t351;
        let t353 = t33 * t352;
        let t354 = t34 * t352;
        let t355 = t35 * t352;
        let p_1_turning_1_0 = t347 + t353;
        let p_1_turning_1_1 = t348 + t354;
        let p_1_turning_1_2 = t349 + t355;
        let t359 = z_0_position_0 * t287;
        let t360 = z_0_position_1 * t287;
        let t361 = z_0_position_2 * t287;
        let t362 = z_1_position_0 * t292;
        let t363 = z_1_position_1 * t292;
        let t364 = z_1_position_2 * t292;
        let t365 = t359 + t362;
        let t366 = t360 + t363;
        let t367 = t361 + t364;
        let t368 = n_0 * t272;
        let t369 = n_1 * t272;
        let t370 = n_2 * t272;
        let t371 = t365 - t368;
        let t372 = t366 - t369;
        let t373 = t367 - t370;
        let g_0_position_0 = p_0_position_0 + t371;
        let g_0_position_1 = p_0_position_1 + t372;
        let g_0_position_2 = p_0_position_2 + t373;
        let t377 = e_0_0 * t274;
        let t378 = e_0_1 * t275;
        let t379 = t377 + t378;
        let t380 = t24 * t379;
        let t381 = t25 * t379;
        let t382 = t26 * t379;
        let t383 = e_0_0 * t276;
        let t384 = e_0_1 * t244;
        let t385 = t383 + t384;
        let t386 = t33 * t385;
        let t387 = t34 * t385;
        let t388 = t35 * t385;
        let t389 = t380 + t386;
        let t390 = t381 + t387;
        let t391 = t382 + t388;
        let t392 = z_0_turning_0 * t287;
        let t393 = z_1_turning_0 * t292;
        let t394 = t392 + t393;
        let t395 = n_0 * t394;
        let t396 = n_1 * t394;
        let t397 = n_2 * t394;
        let g_0_turning_0_0 = t389 + t395;
        let g_0_turning_0_1 = t390 + t396;
        let g_0_turning_0_2 = t391 + t397;
        let t401 = e_1_0 * t274;
        let t402 = e_1_1 * t275;
        let t403 = t401 + t402;
        let t404 = t24 * t403;
        let t405 = t25 * t403;
        let t406 = t26 * t403;
        let t407 = e_1_0 * t276;
        let t408 = e_1_1 * t244;
        let t409 = t407 + t408;
        let t410 = t33 * t409;
        let t411 = t34 * t409;
        let t412 = t35 * t409;
        let t413 = t404 + t410;
        let t414 = t405 + t411;
        let t415 = t406 + t412;
        let t416 = z_0_turning_1 * t287;
        let t417 = z_1_turning_1 * t292;
        let t418 = t416 + t417;
        let t419 = n_0 * t418;
        let t420 = n_1 * t418;
        let t421 = n_2 * t418;
        let g_0_turning_1_0 = t413 + t419;
        let g_0_turning_1_1 = t414 + t420;
        let g_0_turning_1_2 = t415 + t421;
        let t425 = z_0_position_0 * t293;
        let t426 = z_0_position_1 * t293;
        let t427 = z_0_position_2 * t293;
        let t428 = z_1_position_0 * t298;
        let t429 = z_1_position_1 * t298;
        let t430 = z_1_position_2 * t298;
        let t431 = t425 + t428;
        let t432 = t426 + t429;
        let t433 = t427 + t430;
        let t434 = n_0 * t273;
        let t435 = n_1 * t273;
        let t436 = n_2 * t273;
        let t437 = t431 - t434;
        let t438 = t432 - t435;
        let t439 = t433 - t436;
        let g_1_position_0 = p_1_position_0 + t437;
        let g_1_position_1 = p_1_position_1 + t438;
        let g_1_position_2 = p_1_position_2 + t439;
        let t443 = e_0_0 * t260;
        let t444 = e_0_1 * t277;
        let t445 = t443 + t444;
        let t446 = t24 * t445;
        let t447 = t25 * t445;
        let t448 = t26 * t445;
        let t449 = e_0_0 * t278;
        let t450 = e_0_1 * t279;
        let t451 = t449 + t450;
        let t452 = t33 * t451;
        let t453 = t34 * t451;
        let t454 = t35 * t451;
        let t455 = t446 + t452;
        let t456 = t447 + t453;
        let t457 = t448 + t454;
        let t458 = z_0_turning_0 * t293;
        let t459 = z_1_turning_0 * t298;
        let t460 = t458 + t459;
        let t461 = n_0 * t460;
        let t462 = n_1 * t460;
        let t463 = n_2 * t460;
        let g_1_turning_0_0 = t455 + t461;
        let g_1_turning_0_1 = t456 + t462;
        let g_1_turning_0_2 = t457 + t463;
        let t467 = e_1_0 * t260;
        let t468 = e_1_1 * t277;
        let t469 = t467 + t468;
        let t470 = t24 * t469;
        let t471 = t25 * t469;
        let t472 = t26 * t469;
        let t473 = e_1_0 * t278;
        let t474 = e_1_1 * t279;
        let t475 = t473 + t474;
        let t476 = t33 * t475;
        let t477 = t34 * t475;
        let t478 = t35 * t475;
        let t479 = t470 + t476;
        let t480 = t471 + t477;
        let t481 = t472 + t478;
        let t482 = z_0_turning_1 * t293;
        let t483 = z_1_turning_1 * t298;
        let t484 = t482 + t483;
        let t485 = n_0 * t484;
        let t486 = n_1 * t484;
        let t487 = n_2 * t484;
        let g_1_turning_1_0 = t479 + t485;
        let g_1_turning_1_1 = t480 + t486;
        let g_1_turning_1_2 = t481 + t487;
        [
            z_0_position_0,
            z_0_position_1,
            z_0_position_2,
            z_0_turning_0,
            z_0_turning_1,
            z_1_position_0,
            z_1_position_1,
            z_1_position_2,
            z_1_turning_0,
            z_1_turning_1,
            p_0_position_0,
            p_0_position_1,
            p_0_position_2,
            p_0_turning_0_0,
            p_0_turning_0_1,
            p_0_turning_0_2,
            p_0_turning_1_0,
            p_0_turning_1_1,
            p_0_turning_1_2,
            0.0,
            p_0_bending_1,
            0.0,
            p_1_position_0,
            p_1_position_1,
            p_1_position_2,
            p_1_turning_0_0,
            p_1_turning_0_1,
            p_1_turning_0_2,
            p_1_turning_1_0,
            p_1_turning_1_1,
            p_1_turning_1_2,
            0.0,
            p_1_bending_1,
            0.0,
            g_0_position_0,
            g_0_position_1,
            g_0_position_2,
            g_0_turning_0_0,
            g_0_turning_0_1,
            g_0_turning_0_2,
            g_0_turning_1_0,
            g_0_turning_1_1,
            g_0_turning_1_2,
            0.0,
            0.0,
            0.0,
            g_1_position_0,
            g_1_position_1,
            g_1_position_2,
            g_1_turning_0_0,
            g_1_turning_0_1,
            g_1_turning_0_2,
            g_1_turning_1_0,
            g_1_turning_1_1,
            g_1_turning_1_2,
            0.0,
            0.0,
            0.0,
            cross_0,
            cross_1,
        ]
    }
    pub(super) const tangential_tangent_379a45c4216c869c_TABLE: Table = Table {
        name: "tangential_tangent",
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
            "E_0_0",
            "E_0_1",
            "E_1_0",
            "E_1_1",
            "third_0_0",
            "third_0_1",
            "third_0_2",
            "third_1_0",
            "third_1_1",
            "third_1_2",
            "third_2_0",
            "third_2_1",
            "third_2_2",
            "third_3_0",
            "third_3_1",
            "third_3_2",
            "s_0",
            "s_1",
            "t_0",
            "t_1",
            "c_0_0",
            "c_0_1",
            "c_1_0",
            "c_1_1",
            "h_0",
            "h_1",
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
            Operation::Input(21),
            Operation::Input(22),
            Operation::Constant(0.0),
            Operation::Multiply(4, 13),
            Operation::Multiply(5, 13),
            Operation::Multiply(6, 13),
            Operation::Multiply(7, 15),
            Operation::Multiply(8, 15),
            Operation::Multiply(9, 15),
            Operation::Add(18, 21),
            Operation::Add(19, 22),
            Operation::Add(20, 23),
            Operation::Multiply(4, 14),
            Operation::Multiply(5, 14),
            Operation::Multiply(6, 14),
            Operation::Multiply(7, 16),
            Operation::Multiply(8, 16),
            Operation::Multiply(9, 16),
            Operation::Add(27, 30),
            Operation::Add(28, 31),
            Operation::Add(29, 32),
            Operation::Multiply(13, 15),
            Operation::Add(36, 36),
            Operation::Multiply(10, 37),
            Operation::Multiply(11, 37),
            Operation::Multiply(12, 37),
            Operation::Multiply(13, 16),
            Operation::Multiply(14, 15),
            Operation::Add(41, 42),
            Operation::Multiply(10, 43),
            Operation::Multiply(11, 43),
            Operation::Multiply(12, 43),
            Operation::Multiply(14, 16),
            Operation::Add(47, 47),
            Operation::Multiply(10, 48),
            Operation::Multiply(11, 48),
            Operation::Multiply(12, 48),
            Operation::Constant(1.0),
            Operation::Multiply(0, 38),
            Operation::Multiply(1, 39),
            Operation::Add(53, 54),
            Operation::Multiply(2, 40),
            Operation::Add(55, 56),
            Operation::Multiply(3, 57),
            Operation::Multiply(0, 44),
            Operation::Multiply(1, 45),
            Operation::Add(59, 60),
            Operation::Multiply(2, 46),
            Operation::Add(61, 62),
            Operation::Multiply(3, 63),
            Operation::Multiply(0, 49),
            Operation::Multiply(1, 50),
            Operation::Add(65, 66),
            Operation::Multiply(2, 51),
            Operation::Add(67, 68),
            Operation::Multiply(3, 69),
            Operation::Add(52, 58),
            Operation::Add(52, 70),
            Operation::Multiply(71, 72),
            Operation::Multiply(64, 64),
            Operation::Subtract(73, 74),
            Operation::Divide(52, 75),
            Operation::Multiply(72, 76),
            Operation::Multiply(64, 76),
            Operation::Multiply(71, 76),
            Operation::Input(35),
            Operation::Input(36),
            Operation::Input(37),
            Operation::Input(38),
            Operation::Input(39),
            Operation::Input(40),
            Operation::Input(41),
            Operation::Input(42),
            Operation::Input(43),
            Operation::Input(44),
            Operation::Input(45),
            Operation::Multiply(77, 82),
            Operation::Multiply(78, 83),
            Operation::Multiply(78, 82),
            Operation::Multiply(79, 83),
            Operation::Subtract(92, 91),
            Operation::Subtract(93, 94),
            Operation::Multiply(24, 77),
            Operation::Multiply(25, 77),
            Operation::Multiply(26, 77),
            Operation::Multiply(33, 78),
            Operation::Multiply(34, 78),
            Operation::Multiply(35, 78),
            Operation::Subtract(100, 97),
            Operation::Subtract(101, 98),
            Operation::Subtract(102, 99),
            Operation::Multiply(3, 77),
            Operation::Multiply(3, 78),
            Operation::Multiply(13, 106),
            Operation::Multiply(14, 107),
            Operation::Subtract(109, 108),
            Operation::Multiply(15, 106),
            Operation::Multiply(16, 107),
            Operation::Subtract(112, 111),
            Operation::Multiply(24, 78),
            Operation::Multiply(25, 78),
            Operation::Multiply(26, 78),
            Operation::Multiply(33, 79),
            Operation::Multiply(34, 79),
            Operation::Multiply(35, 79),
            Operation::Subtract(114, 117),
            Operation::Subtract(115, 118),
            Operation::Subtract(116, 119),
            Operation::Multiply(3, 79),
            Operation::Multiply(13, 107),
            Operation::Multiply(14, 123),
            Operation::Subtract(124, 125),
            Operation::Multiply(15, 107),
            Operation::Multiply(16, 123),
            Operation::Subtract(127, 128),
            Operation::Constant(2.0),
            Operation::Multiply(24, 38),
            Operation::Multiply(25, 39),
            Operation::Add(131, 132),
            Operation::Multiply(26, 40),
            Operation::Add(133, 134),
            Operation::Add(135, 135),
            Operation::Multiply(24, 44),
            Operation::Multiply(25, 45),
            Operation::Add(137, 138),
            Operation::Multiply(26, 46),
            Operation::Add(139, 140),
            Operation::Add(141, 141),
            Operation::Multiply(33, 38),
            Operation::Multiply(34, 39),
            Operation::Add(143, 144),
            Operation::Multiply(35, 40),
            Operation::Add(145, 146),
            Operation::Add(141, 147),
            Operation::Multiply(33, 44),
            Operation::Multiply(34, 45),
            Operation::Add(149, 150),
            Operation::Multiply(35, 46),
            Operation::Add(151, 152),
            Operation::Multiply(24, 49),
            Operation::Multiply(25, 50),
            Operation::Add(154, 155),
            Operation::Multiply(26, 51),
            Operation::Add(156, 157),
            Operation::Add(153, 158),
            Operation::Add(153, 153),
            Operation::Multiply(33, 49),
            Operation::Multiply(34, 50),
            Operation::Add(161, 162),
            Operation::Multiply(35, 51),
            Operation::Add(163, 164),
            Operation::Add(165, 165),
            Operation::Term(95, 0),
            Operation::Term(96, 0),
            Operation::Term(95, 1),
            Operation::Term(96, 1),
            Operation::Term(95, 2),
            Operation::Term(96, 2),
            Operation::Term(95, 3),
            Operation::Term(96, 3),
            Operation::Multiply(13, 173),
            Operation::Multiply(14, 174),
            Operation::Add(175, 176),
            Operation::Multiply(3, 177),
            Operation::Multiply(15, 173),
            Operation::Multiply(16, 174),
            Operation::Add(179, 180),
            Operation::Multiply(3, 181),
            Operation::Multiply(38, 167),
            Operation::Multiply(39, 167),
            Operation::Multiply(40, 167),
            Operation::Multiply(44, 168),
            Operation::Multiply(45, 168),
            Operation::Multiply(46, 168),
            Operation::Add(183, 186),
            Operation::Add(184, 187),
            Operation::Add(185, 188),
            Operation::Add(169, 171),
            Operation::Multiply(15, 178),
            Operation::Multiply(13, 182),
            Operation::Add(193, 194),
            Operation::Multiply(44, 167),
            Operation::Multiply(45, 167),
            Operation::Multiply(46, 167),
            Operation::Multiply(49, 168),
            Operation::Multiply(50, 168),
            Operation::Multiply(51, 168),
            Operation::Add(196, 199),
            Operation::Add(197, 200),
            Operation::Add(198, 201),
            Operation::Add(170, 172),
            Operation::Multiply(16, 178),
            Operation::Multiply(14, 182),
            Operation::Add(206, 207),
            Operation::Term(84, 4),
            Operation::Term(85, 4),
            Operation::Term(86, 4),
            Operation::Term(87, 4),
            Operation::Term(84, 5),
            Operation::Term(85, 5),
            Operation::Term(86, 5),
            Operation::Term(87, 5),
            Operation::Term(82, 6),
            Operation::Term(83, 6),
            Operation::Multiply(80, 213),
            Operation::Add(217, 219),
            Operation::Constant(0.5),
            Operation::Multiply(220, 221),
            Operation::Multiply(81, 213),
            Operation::Multiply(221, 223),
            Operation::Multiply(80, 214),
            Operation::Add(218, 225),
            Operation::Multiply(221, 226),
            Operation::Add(224, 227),
            Operation::Multiply(81, 214),
            Operation::Multiply(221, 229),
            Operation::Multiply(136, 222),
            Operation::Add(209, 231),
            Operation::Multiply(142, 222),
            Operation::Add(210, 233),
            Operation::Multiply(130, 222),
            Operation::Multiply(148, 228),
            Operation::Add(232, 236),
            Operation::Multiply(159, 228),
            Operation::Add(234, 238),
            Operation::Multiply(160, 230),
            Operation::Add(237, 240),
            Operation::Multiply(166, 230),
            Operation::Add(239, 242),
            Operation::Multiply(130, 230),
            Operation::Multiply(80, 215),
            Operation::Multiply(221, 245),
            Operation::Multiply(81, 215),
            Operation::Add(217, 247),
            Operation::Multiply(221, 248),
            Operation::Multiply(80, 216),
            Operation::Multiply(221, 250),
            Operation::Add(249, 251),
            Operation::Multiply(81, 216),
            Operation::Add(218, 253),
            Operation::Multiply(221, 254),
            Operation::Multiply(136, 246),
            Operation::Add(211, 256),
            Operation::Multiply(142, 246),
            Operation::Add(212, 258),
            Operation::Multiply(130, 246),
            Operation::Multiply(148, 252),
            Operation::Add(257, 261),
            Operation::Multiply(159, 252),
            Operation::Add(259, 263),
            Operation::Multiply(160, 255),
            Operation::Add(262, 265),
            Operation::Multiply(166, 255),
            Operation::Add(264, 267),
            Operation::Multiply(130, 255),
            Operation::Term(88, 7),
            Operation::Term(89, 7),
            Operation::Multiply(90, 270),
            Operation::Multiply(90, 271),
            Operation::Add(192, 235),
            Operation::Add(172, 228),
            Operation::Add(170, 228),
            Operation::Add(169, 252),
            Operation::Add(171, 252),
            Operation::Add(205, 269),
            Operation::Term(95, 8),
            Operation::Term(96, 8),
            Operation::Add(135, 136),
            Operation::Multiply(280, 282),
            Operation::Add(141, 148),
            Operation::Multiply(281, 284),
            Operation::Add(283, 285),
            Operation::Add(241, 286),
            Operation::Multiply(280, 284),
            Operation::Add(158, 160),
            Operation::Multiply(281, 289),
            Operation::Add(288, 290),
            Operation::Add(243, 291),
            Operation::Add(266, 291),
            Operation::Multiply(280, 289),
            Operation::Add(165, 166),
            Operation::Multiply(281, 295),
            Operation::Add(294, 296),
            Operation::Add(268, 297),
            Operation::Term(95, 10),
            Operation::Term(96, 10),
            Operation::Multiply(13, 299),
            Operation::Multiply(14, 300),
            Operation::Add(301, 302),
            Operation::Multiply(15, 299),
            Operation::Multiply(16, 300),
            Operation::Add(304, 305),
            Operation::Multiply(13, 192),
            Operation::Multiply(14, 172),
            Operation::Add(307, 308),
            Operation::Multiply(24, 309),
            Operation::Multiply(25, 309),
            Operation::Multiply(26, 309),
            Operation::Multiply(13, 170),
            Operation::Multiply(33, 313),
            Operation::Multiply(34, 313),
            Operation::Multiply(35, 313),
            Operation::Add(310, 314),
            Operation::Add(311, 315),
            Operation::Add(312, 316),
            Operation::Multiply(15, 192),
            Operation::Multiply(16, 172),
            Operation::Add(320, 321),
            Operation::Multiply(24, 322),
            Operation::Multiply(25, 322),
            Operation::Multiply(26, 322),
            Operation::Multiply(15, 170),
            Operation::Multiply(33, 326),
            Operation::Multiply(34, 326),
            Operation::Multiply(35, 326),
            Operation::Add(323, 327),
            Operation::Add(324, 328),
            Operation::Add(325, 329),
            Operation::Multiply(14, 169),
            Operation::Multiply(24, 333),
            Operation::Multiply(25, 333),
            Operation::Multiply(26, 333),
            Operation::Multiply(13, 171),
            Operation::Multiply(14, 205),
            Operation::Add(337, 338),
            Operation::Multiply(33, 339),
            Operation::Multiply(34, 339),
            Operation::Multiply(35, 339),
            Operation::Add(334, 340),
            Operation::Add(335, 341),
            Operation::Add(336, 342),
            Operation::Multiply(16, 169),
            Operation::Multiply(24, 346),
            Operation::Multiply(25, 346),
            Operation::Multiply(26, 346),
            Operation::Multiply(15, 171),
            Operation::Multiply(16, 205),
            Operation::Add(350, 351),
            Operation::Multiply(33, 352),
            Operation::Multiply(34, 352),
            Operation::Multiply(35, 352),
            Operation::Add(347, 353),
            Operation::Add(348, 354),
            Operation::Add(349, 355),
            Operation::Multiply(103, 287),
            Operation::Multiply(104, 287),
            Operation::Multiply(105, 287),
            Operation::Multiply(120, 292),
            Operation::Multiply(121, 292),
            Operation::Multiply(122, 292),
            Operation::Add(359, 362),
            Operation::Add(360, 363),
            Operation::Add(361, 364),
            Operation::Multiply(0, 272),
            Operation::Multiply(1, 272),
            Operation::Multiply(2, 272),
            Operation::Subtract(365, 368),
            Operation::Subtract(366, 369),
            Operation::Subtract(367, 370),
            Operation::Add(189, 371),
            Operation::Add(190, 372),
            Operation::Add(191, 373),
            Operation::Multiply(13, 274),
            Operation::Multiply(14, 275),
            Operation::Add(377, 378),
            Operation::Multiply(24, 379),
            Operation::Multiply(25, 379),
            Operation::Multiply(26, 379),
            Operation::Multiply(13, 276),
            Operation::Multiply(14, 244),
            Operation::Add(383, 384),
            Operation::Multiply(33, 385),
            Operation::Multiply(34, 385),
            Operation::Multiply(35, 385),
            Operation::Add(380, 386),
            Operation::Add(381, 387),
            Operation::Add(382, 388),
            Operation::Multiply(110, 287),
            Operation::Multiply(126, 292),
            Operation::Add(392, 393),
            Operation::Multiply(0, 394),
            Operation::Multiply(1, 394),
            Operation::Multiply(2, 394),
            Operation::Add(389, 395),
            Operation::Add(390, 396),
            Operation::Add(391, 397),
            Operation::Multiply(15, 274),
            Operation::Multiply(16, 275),
            Operation::Add(401, 402),
            Operation::Multiply(24, 403),
            Operation::Multiply(25, 403),
            Operation::Multiply(26, 403),
            Operation::Multiply(15, 276),
            Operation::Multiply(16, 244),
            Operation::Add(407, 408),
            Operation::Multiply(33, 409),
            Operation::Multiply(34, 409),
            Operation::Multiply(35, 409),
            Operation::Add(404, 410),
            Operation::Add(405, 411),
            Operation::Add(406, 412),
            Operation::Multiply(113, 287),
            Operation::Multiply(129, 292),
            Operation::Add(416, 417),
            Operation::Multiply(0, 418),
            Operation::Multiply(1, 418),
            Operation::Multiply(2, 418),
            Operation::Add(413, 419),
            Operation::Add(414, 420),
            Operation::Add(415, 421),
            Operation::Multiply(103, 293),
            Operation::Multiply(104, 293),
            Operation::Multiply(105, 293),
            Operation::Multiply(120, 298),
            Operation::Multiply(121, 298),
            Operation::Multiply(122, 298),
            Operation::Add(425, 428),
            Operation::Add(426, 429),
            Operation::Add(427, 430),
            Operation::Multiply(0, 273),
            Operation::Multiply(1, 273),
            Operation::Multiply(2, 273),
            Operation::Subtract(431, 434),
            Operation::Subtract(432, 435),
            Operation::Subtract(433, 436),
            Operation::Add(202, 437),
            Operation::Add(203, 438),
            Operation::Add(204, 439),
            Operation::Multiply(13, 260),
            Operation::Multiply(14, 277),
            Operation::Add(443, 444),
            Operation::Multiply(24, 445),
            Operation::Multiply(25, 445),
            Operation::Multiply(26, 445),
            Operation::Multiply(13, 278),
            Operation::Multiply(14, 279),
            Operation::Add(449, 450),
            Operation::Multiply(33, 451),
            Operation::Multiply(34, 451),
            Operation::Multiply(35, 451),
            Operation::Add(446, 452),
            Operation::Add(447, 453),
            Operation::Add(448, 454),
            Operation::Multiply(110, 293),
            Operation::Multiply(126, 298),
            Operation::Add(458, 459),
            Operation::Multiply(0, 460),
            Operation::Multiply(1, 460),
            Operation::Multiply(2, 460),
            Operation::Add(455, 461),
            Operation::Add(456, 462),
            Operation::Add(457, 463),
            Operation::Multiply(15, 260),
            Operation::Multiply(16, 277),
            Operation::Add(467, 468),
            Operation::Multiply(24, 469),
            Operation::Multiply(25, 469),
            Operation::Multiply(26, 469),
            Operation::Multiply(15, 278),
            Operation::Multiply(16, 279),
            Operation::Add(473, 474),
            Operation::Multiply(33, 475),
            Operation::Multiply(34, 475),
            Operation::Multiply(35, 475),
            Operation::Add(470, 476),
            Operation::Add(471, 477),
            Operation::Add(472, 478),
            Operation::Multiply(113, 293),
            Operation::Multiply(129, 298),
            Operation::Add(482, 483),
            Operation::Multiply(0, 484),
            Operation::Multiply(1, 484),
            Operation::Multiply(2, 484),
            Operation::Add(479, 485),
            Operation::Add(480, 486),
            Operation::Add(481, 487),
        ],
        outputs: &[
            ("z_0_position_0", 103),
            ("z_0_position_1", 104),
            ("z_0_position_2", 105),
            ("z_0_turning_0", 110),
            ("z_0_turning_1", 113),
            ("z_1_position_0", 120),
            ("z_1_position_1", 121),
            ("z_1_position_2", 122),
            ("z_1_turning_0", 126),
            ("z_1_turning_1", 129),
            ("p_0_position_0", 189),
            ("p_0_position_1", 190),
            ("p_0_position_2", 191),
            ("p_0_turning_0_0", 317),
            ("p_0_turning_0_1", 318),
            ("p_0_turning_0_2", 319),
            ("p_0_turning_1_0", 330),
            ("p_0_turning_1_1", 331),
            ("p_0_turning_1_2", 332),
            ("p_0_bending_0", 17),
            ("p_0_bending_1", 195),
            ("p_0_bending_2", 17),
            ("p_1_position_0", 202),
            ("p_1_position_1", 203),
            ("p_1_position_2", 204),
            ("p_1_turning_0_0", 343),
            ("p_1_turning_0_1", 344),
            ("p_1_turning_0_2", 345),
            ("p_1_turning_1_0", 356),
            ("p_1_turning_1_1", 357),
            ("p_1_turning_1_2", 358),
            ("p_1_bending_0", 17),
            ("p_1_bending_1", 208),
            ("p_1_bending_2", 17),
            ("g_0_position_0", 374),
            ("g_0_position_1", 375),
            ("g_0_position_2", 376),
            ("g_0_turning_0_0", 398),
            ("g_0_turning_0_1", 399),
            ("g_0_turning_0_2", 400),
            ("g_0_turning_1_0", 422),
            ("g_0_turning_1_1", 423),
            ("g_0_turning_1_2", 424),
            ("g_0_slave_0", 17),
            ("g_0_slave_1", 17),
            ("g_0_slave_2", 17),
            ("g_1_position_0", 440),
            ("g_1_position_1", 441),
            ("g_1_position_2", 442),
            ("g_1_turning_0_0", 464),
            ("g_1_turning_0_1", 465),
            ("g_1_turning_0_2", 466),
            ("g_1_turning_1_0", 488),
            ("g_1_turning_1_1", 489),
            ("g_1_turning_1_2", 490),
            ("g_1_slave_0", 17),
            ("g_1_slave_1", 17),
            ("g_1_slave_2", 17),
            ("cross_0", 303),
            ("cross_1", 306),
        ],
        terms: &[
            Term {
                tag: "Q-position",
                present: true,
                reason: "",
            },
            Term {
                tag: "Q-tangent",
                present: true,
                reason: "",
            },
            Term {
                tag: "Q-turning",
                present: true,
                reason: "",
            },
            Term {
                tag: "Q-bending",
                present: true,
                reason: "",
            },
            Term {
                tag: "slip-change",
                present: true,
                reason: "",
            },
            Term {
                tag: "slip-metric",
                present: true,
                reason: "",
            },
            Term {
                tag: "traction-metric",
                present: true,
                reason: "",
            },
            Term {
                tag: "pressure-change",
                present: true,
                reason: "",
            },
            Term {
                tag: "Y-second",
                present: true,
                reason: "",
            },
            Term {
                tag: "Y-third",
                present: false,
                reason: "no third derivative along the normal",
            },
            Term {
                tag: "cross",
                present: true,
                reason: "",
            },
        ],
        cost: 435,
        compiled: |inputs, outputs| {
            if let Some(inputs) = inputs.first_chunk() {
                for (to, from) in outputs
                    .iter_mut()
                    .zip(tangential_tangent_379a45c4216c869c(inputs))
                {
                    *to = from;
                }
            }
        },
    };
    #[inline(never)]
    pub(super) fn tangential_tangent_379a45c4216c869c_forms(
        vectors: &runtime::Vectors<3, 2, 3>,
        gap: &runtime::Gap<3>,
        frame: &runtime::Frame<2>,
        third: &[[f64; 3]; 4],
        (tangential, slope): (&runtime::Tangential, f64),
    ) -> runtime::TangentialCoefficients<3, 2, 3> {
        let o = tangential_tangent_379a45c4216c869c(
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
                frame.e[0][0],
                frame.e[0][1],
                frame.e[1][0],
                frame.e[1][1],
                third[0][0],
                third[0][1],
                third[0][2],
                third[1][0],
                third[1][1],
                third[1][2],
                third[2][0],
                third[2][1],
                third[2][2],
                third[3][0],
                third[3][1],
                third[3][2],
                frame.s[0],
                frame.s[1],
                tangential.t[0],
                tangential.t[1],
                tangential.c[0][0],
                tangential.c[0][1],
                tangential.c[1][0],
                tangential.c[1][1],
                tangential.h[0],
                tangential.h[1],
                slope,
            ],
        );
        runtime::TangentialCoefficients {
            z: [
                runtime::Variation {
                    position: [o[0], o[1], o[2]],
                    turning: [o[3], o[4]],
                },
                runtime::Variation {
                    position: [o[5], o[6], o[7]],
                    turning: [o[8], o[9]],
                },
            ],
            p: [
                runtime::SecondVariation {
                    position: [o[10], o[11], o[12]],
                    turning: [[o[13], o[14], o[15]], [o[16], o[17], o[18]]],
                    bending: [o[19], o[20], o[21]],
                },
                runtime::SecondVariation {
                    position: [o[22], o[23], o[24]],
                    turning: [[o[25], o[26], o[27]], [o[28], o[29], o[30]]],
                    bending: [o[31], o[32], o[33]],
                },
            ],
            g: [
                runtime::ForceChange {
                    position: [o[34], o[35], o[36]],
                    turning: [[o[37], o[38], o[39]], [o[40], o[41], o[42]]],
                    slave: [o[43], o[44], o[45]],
                },
                runtime::ForceChange {
                    position: [o[46], o[47], o[48]],
                    turning: [[o[49], o[50], o[51]], [o[52], o[53], o[54]]],
                    slave: [o[55], o[56], o[57]],
                },
            ],
            cross: [o[58], o[59]],
        }
    }
}
///Point against a bilinear facet, Coulomb friction.
#[derive(Clone, Copy, Debug)]
pub struct PointQuad4Coulomb;
/// ```text
/// element PointQuad4Coulomb { slave: point; master: Quad4; normal: Penalty; tangential: Coulomb; }
///
/// pair          3 dimensions, slave of 1 node, master of 4 nodes
/// projection    2 parameters, by Newton's method
/// gap           signed, along the normal
/// tangent       exact at any gap
/// normal law    Penalty, by itself
/// friction      Coulomb
/// operations    gap 44, tangent 170, frame 55, tangential_residual 84, tangential_tangent 435, law 3, friction 1, sliding 24; in all 816
/// left out      complement of tangent: codimension one: no direction is left over
/// left out      Y-third of tangential_tangent: no third derivative along the normal
/// ```
#[allow(non_snake_case, unused_variables, clippy::all)]
mod _element_pointquad4coulomb {
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
    impl runtime::Element<3, 2, 3> for PointQuad4Coulomb {
        type Law = ::contact_elements::laws::Penalty;
        type Tangential = ::contact_elements::laws::Coulomb;
        const LAYOUT: runtime::Layout = runtime::Layout {
            tangential: 1,
            r0: 3,
            orientation: Some(4),
            geometry: 5,
            master_weights: 5,
            slave_weights: 5,
            point: 5,
            axis: None,
            placement: None,
            count: 5,
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
            let weights = parameters.get(5..).unwrap_or(&[]);
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
            let r0 = parameters.get(3).copied().unwrap_or(T::constant(0.0));
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
        #[inline(always)]
        fn frame(
            point: usize,
            x: &[[f64; 3]],
            vectors: &runtime::Vectors<3, 2, 3>,
            gap: &runtime::Gap<3>,
            moved: &[f64; 2],
            parameters: &[f64],
        ) -> runtime::Frame<2> {
            let o = friction::frame_e67ed595d8b01e9c(
                &[
                    gap.n[0],
                    gap.n[1],
                    gap.n[2],
                    vectors.b[0][0],
                    vectors.b[0][1],
                    vectors.b[0][2],
                    vectors.b[1][0],
                    vectors.b[1][1],
                    vectors.b[1][2],
                    moved[0],
                    moved[1],
                ],
            );
            runtime::Frame {
                s: [o[0], o[1]],
                e: [[o[2], o[3]], [o[4], o[5]]],
                share: o[6],
            }
        }
        #[inline(always)]
        fn tangential_force(
            vectors: &runtime::Vectors<3, 2, 3>,
            gap: &runtime::Gap<3>,
            frame: &runtime::Frame<2>,
            tangential: &runtime::Tangential,
        ) -> runtime::TangentialForce<3, 2> {
            let o = friction::tangential_residual_a145a424134ed898(
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
                    frame.e[0][0],
                    frame.e[0][1],
                    frame.e[1][0],
                    frame.e[1][1],
                    tangential.t[0],
                    tangential.t[1],
                ],
            );
            runtime::TangentialForce {
                force: [o[0], o[1], o[2]],
                turn: [o[3], o[4]],
            }
        }
        #[inline(always)]
        fn higher(
            x: &[[f64; 3]],
            zeta: &[f64; 2],
            parameters: &[f64],
            second: &mut [&mut [f64]; 3],
        ) -> [[f64; 3]; 4] {
            runtime::onto_shape_higher::<
                ::contact_elements::geometry::Quad4,
                3,
                2,
                3,
                4,
            >(x, zeta, parameters.get(5..).unwrap_or(&[]), second)
        }
        #[inline(always)]
        fn tangential_tangent(
            (point, x): (usize, &[[f64; 3]]),
            vectors: &runtime::Vectors<3, 2, 3>,
            gap: &runtime::Gap<3>,
            frame: &runtime::Frame<2>,
            third: &[[f64; 3]; 4],
            (tangential, slope): (&runtime::Tangential, f64),
            parameters: &[f64],
        ) -> runtime::TangentialCoefficients<3, 2, 3> {
            friction::tangential_tangent_379a45c4216c869c_forms(
                vectors,
                gap,
                frame,
                third,
                (tangential, slope),
            )
        }
    }
    fn screen(
        run: &::contact_elements::Run<'_>,
        place: (usize, usize),
        bounds: &mut [f64; runtime::SCREENED],
    ) -> u32 {
        runtime::screen::<
            PointQuad4Coulomb,
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
            PointQuad4Coulomb,
            _,
            3,
            2,
            3,
            5,
            1,
            16,
        >(call, nodes, &[false, false, false, false, false], target)
    }
    impl PointQuad4Coulomb {
        /// This element with its kernels.
        pub const DESCRIPTOR: &'static ::contact_elements::Registered = {
            static DESCRIPTOR: ::contact_elements::Registered = ::contact_elements::Registered {
                descriptor: ::contact_elements::Descriptor {
                    name: "PointQuad4Coulomb\0",
                    documentation: "Point against a bilinear facet, Coulomb friction.\0",
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
                            name: "eps_t\0",
                            unit: "force/length\0",
                            lower: 0.0,
                            upper: f64::INFINITY,
                            closed: false,
                        },
                        ::contact_elements::Parameter {
                            name: "mu\0",
                            unit: "1\0",
                            lower: 0.0,
                            upper: f64::INFINITY,
                            closed: true,
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
                    friction: true,
                    enforcement: runtime::Enforcement::Penalty,
                    rolling: false,
                    angle: None,
                    keeps_side: <PointQuad4Coulomb as runtime::Element<
                        3,
                        2,
                        3,
                    >>::KEEPS_SIDE,
                    symmetric: false,
                    tangent: true,
                    energy: false
                        || <<PointQuad4Coulomb as runtime::Element<
                            3,
                            2,
                            3,
                        >>::Law as runtime::NormalLaw>::ENERGY,
                    operations: 816,
                    formulation: 4056436941978639093,
                    vectors: &[false, false, false, false, false],
                    centre: <PointQuad4Coulomb as runtime::Element<3, 2, 3>>::START,
                    slave: SlaveDescription::Point,
                    master: MasterDescription::Shape(
                        ::contact_elements::geometry::Quad4::PROGRAMS,
                    ),
                    layout: runtime::Layout {
                        tangential: 1,
                        r0: 3,
                        orientation: Some(4),
                        geometry: 5,
                        master_weights: 5,
                        slave_weights: 5,
                        point: 5,
                        axis: None,
                        placement: None,
                        count: 5,
                    },
                    domains: <PointQuad4Coulomb as runtime::Element<3, 2, 3>>::DOMAINS,
                    periods: <PointQuad4Coulomb as runtime::Element<3, 2, 3>>::PERIODS,
                    extents: <PointQuad4Coulomb as runtime::Element<3, 2, 3>>::EXTENTS,
                },
                kernel,
                lanes: None,
                screen: if runtime::is_screened::<PointQuad4Coulomb, 3, 2, 3, 5>() {
                    Some(screen)
                } else {
                    None
                },
            };
            &DESCRIPTOR
        };
    }
    impl PointQuad4Coulomb {
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
            frame: Some(friction::frame_e67ed595d8b01e9c_TABLE),
            tangential_residual: Some(
                friction::tangential_residual_a145a424134ed898_TABLE,
            ),
            tangential_tangent: Some(friction::tangential_tangent_379a45c4216c869c_TABLE),
        };
        /// What was declared, for verification.
        pub const DESCRIPTION: ElementDescription = ElementDescription {
            name: "PointQuad4Coulomb",
            descriptor: PointQuad4Coulomb::DESCRIPTOR,
            programs: &PointQuad4Coulomb::PROGRAMS,
            slave: SlaveDescription::Point,
            master: MasterDescription::Shape(
                ::contact_elements::geometry::Quad4::PROGRAMS,
            ),
            law: &::contact_elements::laws::Penalty::PROGRAMS,
            tangential: Some(&::contact_elements::laws::Coulomb::PROGRAMS),
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
                r0: 3,
                orientation: Some(4),
                geometry: 5,
                master_weights: 5,
                slave_weights: 5,
                point: 5,
                axis: None,
                placement: None,
                count: 5,
            },
        };
    }
}
