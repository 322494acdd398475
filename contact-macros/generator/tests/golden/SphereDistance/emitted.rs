///Distance from a ball about the origin: d = sqrt(x^2 + y^2 + z^2) - radius.
#[derive(Clone, Copy, Debug)]
pub struct SphereDistance;
#[allow(non_snake_case, clippy::all)]
mod _geometry_spheredistance {
    use super::SphereDistance;
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
    /// 19 operations, 6 inputs, 5 outputs.
    #[allow(clippy::all, unused_variables, unused_doc_comments)]
    #[inline(always)]
    fn gap<T: ::contact_elements::runtime::Real>(i: &[T; 6]) -> [T; 5] {
        let [x, y, z, radius, orientation, r0] = *i;
        let t4 = x * x;
        let t5 = y * y;
        let t6 = t4 + t5;
        let t7 = z * z;
        let t8 = t6 + t7;
        let t9 = T::sqrt(t8);
        let t10 = t9 - radius;
        let t13 = x + x;
        let t15 = T::constant(0.5) / t9;
        let t16 = t13 * t15;
        let t17 = y + y;
        let t18 = t15 * t17;
        let t19 = z + z;
        let t20 = t15 * t19;
        let n_0 = orientation * t16;
        let n_1 = orientation * t18;
        let n_2 = orientation * t20;
        let distance = t10 * orientation;
        let gap = distance - r0;
        [n_0, n_1, n_2, distance, gap]
    }
    impl runtime::Distance<3> for SphereDistance {}
    impl SphereDistance {
        /// The programs of this geometry, for verification and for the search over its domain.
        pub const PROGRAMS: &'static GeometryPrograms = {
            static PROGRAMS: GeometryPrograms = GeometryPrograms {
                name: "SphereDistance",
                values: Table {
                    name: "gap",
                    inputs: &["x", "y", "z", "radius", "orientation", "r0"],
                    operations: &[
                        Operation::Input(0),
                        Operation::Input(1),
                        Operation::Input(2),
                        Operation::Input(3),
                        Operation::Multiply(0, 0),
                        Operation::Multiply(1, 1),
                        Operation::Add(4, 5),
                        Operation::Multiply(2, 2),
                        Operation::Add(6, 7),
                        Operation::Sqrt(8),
                        Operation::Subtract(9, 3),
                        Operation::Input(4),
                        Operation::Input(5),
                        Operation::Add(0, 0),
                        Operation::Constant(0.5),
                        Operation::Divide(14, 9),
                        Operation::Multiply(13, 15),
                        Operation::Add(1, 1),
                        Operation::Multiply(15, 17),
                        Operation::Add(2, 2),
                        Operation::Multiply(15, 19),
                        Operation::Multiply(11, 16),
                        Operation::Multiply(11, 18),
                        Operation::Multiply(11, 20),
                        Operation::Multiply(10, 11),
                        Operation::Subtract(24, 12),
                    ],
                    outputs: &[
                        ("n_0", 21),
                        ("n_1", 22),
                        ("n_2", 23),
                        ("distance", 24),
                        ("gap", 25),
                    ],
                    terms: &[],
                    cost: 19,
                    compiled: |inputs, outputs| {
                        if let Some(inputs) = inputs.first_chunk() {
                            for (to, from) in outputs.iter_mut().zip(gap(inputs)) {
                                *to = from;
                            }
                        }
                    },
                },
                third: None,
                projection: None,
            };
            &PROGRAMS
        };
    }
}
