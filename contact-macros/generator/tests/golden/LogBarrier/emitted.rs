/**Logarithmic barrier, active at g < d, defined at g > 0 only: W = -kappa (g - d)^2 ln(g/d), N = dW/dg.
It keeps bodies apart: W grows without bound as g goes to zero; N and its derivative vanish at g = d. kappa: force per length; d: the gap at which the barrier begins.*/
#[derive(Clone, Copy, Debug)]
pub struct LogBarrier;
#[allow(non_snake_case, clippy::all)]
mod _law_logbarrier {
    use super::LogBarrier;
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
    /// 24 operations, 3 inputs, 3 outputs.
    #[allow(clippy::all, unused_variables, unused_doc_comments)]
    #[inline(always)]
    fn law<T: ::contact_elements::runtime::Real>(i: &[T; 3]) -> [T; 3] {
        let [gap, kappa, d] = *i;
        let t3 = gap - d;
        let t4 = kappa * t3;
        let t7 = T::constant(1.0) / d;
        let t8 = gap * t7;
        let t9 = T::ln(t8);
        let t10 = T::constant(2.0) * t9;
        let t11 = T::constant(1.0) / gap;
        let t12 = t3 * t11;
        let t13 = t10 + t12;
        let t14 = t4 * t13;
        // [eq:normal-force]
        let traction = -t14;
        let t16 = T::constant(1.0) / t8;
        let t17 = t7 * t16;
        let t18 = T::constant(2.0) * t17;
        let t19 = T::constant(1.0) - t12;
        let t20 = t11 * t19;
        let t21 = t18 + t20;
        let t22 = kappa * t13;
        let t23 = t4 * t21;
        let t24 = t22 + t23;
        // [eq:law-slope]
        let slope = -t24;
        let t28 = t3 * t4;
        let t29 = t9 * t28;
        // [eq:energy]
        let energy = -t29;
        [traction, slope, energy]
    }
    /// 1 operations, 3 inputs, 1 outputs.
    #[allow(clippy::all, unused_variables, unused_doc_comments)]
    #[inline(always)]
    fn active<T: ::contact_elements::runtime::Real>(i: &[T; 3]) -> [T; 1] {
        let [gap, kappa, d] = *i;
        let active = d - gap;
        [active]
    }
    /// 0 operations, 3 inputs, 1 outputs.
    #[allow(clippy::all, unused_variables, unused_doc_comments)]
    #[inline(always)]
    fn valid<T: ::contact_elements::runtime::Real>(i: &[T; 3]) -> [T; 1] {
        let [gap, kappa, d] = *i;
        [gap]
    }
    #[allow(unused_variables)]
    impl runtime::NormalLaw for LogBarrier {
        const PARAMETERS: usize = 2;
        const ENERGY: bool = true;
        const CLOSES_BELOW: bool = true;
        #[inline(always)]
        fn active<T: runtime::Real>(gap: T, parameters: &[T]) -> T {
            let Some(parameters) = parameters.first_chunk::<2>() else {
                return T::constant(-1.0)
            };
            active(&[gap, parameters[0], parameters[1]])[0]
        }
        #[inline(always)]
        fn valid<T: runtime::Real>(gap: T, parameters: &[T]) -> T {
            let Some(parameters) = parameters.first_chunk::<2>() else {
                return T::constant(-1.0)
            };
            valid(&[gap, parameters[0], parameters[1]])[0]
        }
        #[inline(always)]
        fn evaluate<T: runtime::Real>(gap: T, parameters: &[T]) -> runtime::Traction<T> {
            let Some(parameters) = parameters.first_chunk::<2>() else {
                let zero = T::constant(0.0);
                return runtime::Traction {
                    traction: zero,
                    slope: zero,
                    energy: zero,
                };
            };
            let [traction, slope, energy] = law(&[gap, parameters[0], parameters[1]]);
            runtime::Traction {
                traction,
                slope,
                energy: energy,
            }
        }
    }
    impl LogBarrier {
        /// The programs of this law, for verification.
        pub const PROGRAMS: LawPrograms = LawPrograms {
            name: "LogBarrier",
            law: Table {
                name: "law",
                inputs: &["gap", "kappa", "d"],
                operations: &[
                    Operation::Input(0),
                    Operation::Input(1),
                    Operation::Input(2),
                    Operation::Subtract(0, 2),
                    Operation::Multiply(1, 3),
                    Operation::Constant(2.0),
                    Operation::Constant(1.0),
                    Operation::Divide(6, 2),
                    Operation::Multiply(0, 7),
                    Operation::Ln(8),
                    Operation::Multiply(5, 9),
                    Operation::Divide(6, 0),
                    Operation::Multiply(3, 11),
                    Operation::Add(10, 12),
                    Operation::Multiply(4, 13),
                    Operation::Negate(14),
                    Operation::Divide(6, 8),
                    Operation::Multiply(7, 16),
                    Operation::Multiply(5, 17),
                    Operation::Subtract(6, 12),
                    Operation::Multiply(11, 19),
                    Operation::Add(18, 20),
                    Operation::Multiply(1, 13),
                    Operation::Multiply(4, 21),
                    Operation::Add(22, 23),
                    Operation::Negate(24),
                    Operation::Term(15, 0),
                    Operation::Term(25, 1),
                    Operation::Multiply(3, 4),
                    Operation::Multiply(9, 28),
                    Operation::Negate(29),
                    Operation::Term(30, 2),
                ],
                outputs: &[("traction", 26), ("slope", 27), ("energy", 31)],
                terms: &[
                    Term {
                        tag: "normal-force",
                        present: true,
                        reason: "",
                    },
                    Term {
                        tag: "law-slope",
                        present: true,
                        reason: "",
                    },
                    Term {
                        tag: "energy",
                        present: true,
                        reason: "",
                    },
                ],
                cost: 24,
                compiled: |inputs, outputs| {
                    if let Some(inputs) = inputs.first_chunk() {
                        for (to, from) in outputs.iter_mut().zip(law(inputs)) {
                            *to = from;
                        }
                    }
                },
            },
            active: Table {
                name: "active",
                inputs: &["gap", "kappa", "d"],
                operations: &[
                    Operation::Input(0),
                    Operation::Input(2),
                    Operation::Subtract(1, 0),
                ],
                outputs: &[("active", 2)],
                terms: &[],
                cost: 1,
                compiled: |inputs, outputs| {
                    if let Some(inputs) = inputs.first_chunk() {
                        for (to, from) in outputs.iter_mut().zip(active(inputs)) {
                            *to = from;
                        }
                    }
                },
            },
            valid: Some(Table {
                name: "valid",
                inputs: &["gap", "kappa", "d"],
                operations: &[Operation::Input(0)],
                outputs: &[("valid", 0)],
                terms: &[],
                cost: 0,
                compiled: |inputs, outputs| {
                    if let Some(inputs) = inputs.first_chunk() {
                        for (to, from) in outputs.iter_mut().zip(valid(inputs)) {
                            *to = from;
                        }
                    }
                },
            }),
        };
    }
}
