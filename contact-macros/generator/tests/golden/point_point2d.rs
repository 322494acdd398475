///Two points in the plane.
#[derive(Clone, Copy, Debug)]
pub struct PointPoint2d;
#[allow(non_snake_case, unused_variables, clippy::all)]
mod _element_pointpoint2d {
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
    /// 8 operations, 4 inputs, 4 outputs.
    #[allow(clippy::all, unused_variables)]
    #[inline(always)]
    fn gap<T: ::contact_elements::runtime::Real>(i: &[T; 4usize]) -> [T; 4usize] {
        let t3 = i[0usize] * i[0usize];
        let t4 = i[1usize] * i[1usize];
        let t5 = t3 + t4;
        let t6 = T::sqrt(t5);
        let t8 = T::constant(1f64) / t6;
        let t9 = i[0usize] * t8;
        let t10 = i[1usize] * t8;
        let t11 = t6 - i[3usize];
        [t9, t10, t6, t11]
    }
    /// 15 operations, 5 inputs, 4 outputs.
    #[allow(clippy::all, unused_variables)]
    #[inline(always)]
    fn tangent<T: ::contact_elements::runtime::Real>(i: &[T; 5usize]) -> [T; 4usize] {
        let t7 = i[0usize] * i[0usize];
        let t8 = i[4usize] * t7;
        let t9 = i[0usize] * i[1usize];
        let t10 = i[4usize] * t9;
        let t11 = i[1usize] * i[1usize];
        let t12 = i[4usize] * t11;
        let t13 = i[3usize] / i[2usize];
        let t15 = T::constant(1f64) - t7;
        let t16 = t13 * t15;
        let t17 = t9 * t13;
        let t18 = T::constant(1f64) - t11;
        let t19 = t13 * t18;
        let t20 = t8 + t16;
        let t21 = t10 - t17;
        let t22 = t12 + t19;
        [t20, t21, t21, t22]
    }
    impl runtime::Element<2usize, 0usize, 0usize> for PointPoint2d {
        type Law = ::contact_elements::laws::Penalty;
        type Tangential = runtime::Frictionless;
        const LAYOUT: runtime::Layout = runtime::Layout {
            tangential: 1usize,
            r0: 1usize,
            orientation: None,
            geometry: 2usize,
            master_weights: 2usize,
            slave_weights: 2usize,
            point: 2usize,
            axis: None,
            placement: None,
            count: 2usize,
        };
        const SEARCH: runtime::Search = runtime::Search::Closed;
        const MOVING: bool = false;
        const CURVED: [bool; 3] = [false, false, false];
        const SIGNED: bool = false;
        const CURRENT: bool = false;
        const ENFORCEMENT: runtime::Enforcement = runtime::Enforcement::Penalty;
        const SLAVE_NODES: usize = 1usize;
        const MASTER_NODES: usize = 1usize;
        const SLAVE_AXIS: bool = false;
        const PERIODS: [f64; 2] = [0f64, 0f64];
        const DOMAINS: [runtime::Domain; 2] = [
            runtime::Domain::Unbounded,
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
            x: &[[T; 2usize]],
            zeta: &[T; 0usize],
            parameters: &[T],
            rows: &mut runtime::Rows<'_, 0usize, T>,
        ) -> runtime::Vectors<2usize, 0usize, 0usize, T> {
            runtime::onto_point(x, rows)
        }
        #[inline(always)]
        fn closed_projection(x: &[f64; 2usize], parameters: &[f64]) -> [f64; 0usize] {
            [0.0; 0usize]
        }
        #[inline(always)]
        fn gap<T: runtime::Real>(
            vectors: &runtime::Vectors<2usize, 0usize, 0usize, T>,
            parameters: &[T],
            orientation: T,
        ) -> runtime::Gap<2usize, T> {
            let r0 = parameters.get(1usize).copied().unwrap_or(T::constant(0.0));
            let o = gap(&[vectors.r[0usize], vectors.r[1usize], orientation, r0]);
            runtime::Gap {
                n: [o[0usize], o[1usize]],
                distance: o[2usize],
                gap: o[3usize],
            }
        }
        #[inline(always)]
        fn tangent<T: runtime::Real>(
            vectors: &runtime::Vectors<2usize, 0usize, 0usize, T>,
            gap: &runtime::Gap<2usize, T>,
            traction: &runtime::Traction<T>,
            parameters: &[T],
            orientation: T,
        ) -> runtime::Coefficients<2usize, 0usize, T> {
            let o = tangent(
                &[
                    gap.n[0usize],
                    gap.n[1usize],
                    gap.distance,
                    traction.traction,
                    traction.slope,
                ],
            );
            runtime::Coefficients {
                p: [[o[0usize], o[1usize]], [o[2usize], o[3usize]]],
                right: [],
                left: [],
                s: [],
            }
        }
        #[inline(always)]
        fn measure(
            point: usize,
            reference: &[[f64; 2usize]],
            x: &[[f64; 2usize]],
            parameters: &[f64],
            variation: &mut [f64],
        ) -> runtime::Measure<2usize> {
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
            PointPoint2d,
            _,
            2usize,
            0usize,
            0usize,
            2usize,
            1usize,
            4usize,
        >(call, nodes, &[false, false], target)
    }
    impl PointPoint2d {
        /// This element with its kernels.
        pub const DESCRIPTOR: &'static ::contact_elements::Registered = {
            static DESCRIPTOR: ::contact_elements::Registered = ::contact_elements::Registered {
                descriptor: ::contact_elements::Descriptor {
                    name: "PointPoint2d\0",
                    documentation: "Two points in the plane.\0",
                    dimension: 2usize,
                    slave_nodes: 1usize,
                    master_nodes: 1usize,
                    interpolated: false,
                    points: 1usize,
                    projected: 0usize,
                    parameters: &[
                        ::contact_elements::Parameter {
                            name: "eps_n\0",
                            unit: "force/length\0",
                            lower: 0f64,
                            upper: f64::INFINITY,
                            closed: false,
                        },
                        ::contact_elements::Parameter {
                            name: "r0\0",
                            unit: "length\0",
                            lower: 0f64,
                            upper: f64::INFINITY,
                            closed: true,
                        },
                    ],
                    friction: false,
                    enforcement: runtime::Enforcement::Penalty,
                    rolling: false,
                    angle: None,
                    keeps_side: <PointPoint2d as runtime::Element<
                        2usize,
                        0usize,
                        0usize,
                    >>::KEEPS_SIDE,
                    symmetric: true,
                    tangent: true,
                    energy: false
                        || <<PointPoint2d as runtime::Element<
                            2usize,
                            0usize,
                            0usize,
                        >>::Law as runtime::NormalLaw>::ENERGY,
                    operations: 26usize,
                    formulation: 14445853104123559365u64,
                    vectors: &[false, false],
                    centre: <PointPoint2d as runtime::Element<
                        2usize,
                        0usize,
                        0usize,
                    >>::START,
                    slave: SlaveDescription::Point,
                    master: MasterDescription::Point,
                    layout: runtime::Layout {
                        tangential: 1usize,
                        r0: 1usize,
                        orientation: None,
                        geometry: 2usize,
                        master_weights: 2usize,
                        slave_weights: 2usize,
                        point: 2usize,
                        axis: None,
                        placement: None,
                        count: 2usize,
                    },
                    domains: <PointPoint2d as runtime::Element<
                        2usize,
                        0usize,
                        0usize,
                    >>::DOMAINS,
                    periods: <PointPoint2d as runtime::Element<
                        2usize,
                        0usize,
                        0usize,
                    >>::PERIODS,
                    extents: <PointPoint2d as runtime::Element<
                        2usize,
                        0usize,
                        0usize,
                    >>::EXTENTS,
                },
                kernel,
                lanes: None,
                screen: None,
            };
            &DESCRIPTOR
        };
    }
    impl PointPoint2d {
        /// The programs of this element, for verification.
        pub const PROGRAMS: ElementPrograms = ElementPrograms {
            gap: Table {
                name: "gap",
                inputs: &["r_0", "r_1", "orientation", "r0"],
                operations: &[
                    Operation::Input(0u16),
                    Operation::Input(1u16),
                    Operation::Input(3u16),
                    Operation::Multiply(0u16, 0u16),
                    Operation::Multiply(1u16, 1u16),
                    Operation::Add(3u16, 4u16),
                    Operation::Sqrt(5u16),
                    Operation::Constant(1f64),
                    Operation::Divide(7u16, 6u16),
                    Operation::Multiply(0u16, 8u16),
                    Operation::Multiply(1u16, 8u16),
                    Operation::Subtract(6u16, 2u16),
                ],
                outputs: &[
                    ("n_0", 9u16),
                    ("n_1", 10u16),
                    ("distance", 6u16),
                    ("gap", 11u16),
                ],
                terms: &[],
                cost: 8usize,
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
                inputs: &["n_0", "n_1", "distance", "traction", "slope"],
                operations: &[
                    Operation::Input(0u16),
                    Operation::Input(1u16),
                    Operation::Input(2u16),
                    Operation::Input(3u16),
                    Operation::Input(4u16),
                    Operation::Constant(1f64),
                    Operation::Term(4u16, 1u16),
                    Operation::Multiply(0u16, 0u16),
                    Operation::Multiply(6u16, 7u16),
                    Operation::Multiply(0u16, 1u16),
                    Operation::Multiply(6u16, 9u16),
                    Operation::Multiply(1u16, 1u16),
                    Operation::Multiply(6u16, 11u16),
                    Operation::Divide(3u16, 2u16),
                    Operation::Term(13u16, 3u16),
                    Operation::Subtract(5u16, 7u16),
                    Operation::Multiply(14u16, 15u16),
                    Operation::Multiply(9u16, 14u16),
                    Operation::Subtract(5u16, 11u16),
                    Operation::Multiply(14u16, 18u16),
                    Operation::Add(8u16, 16u16),
                    Operation::Subtract(10u16, 17u16),
                    Operation::Add(12u16, 19u16),
                ],
                outputs: &[
                    ("p_0_0", 20u16),
                    ("p_0_1", 21u16),
                    ("p_1_0", 21u16),
                    ("p_1_1", 22u16),
                ],
                terms: &[
                    Term {
                        tag: "F-curvature",
                        present: false,
                        reason: "no curvature along the projection",
                    },
                    Term {
                        tag: "12-main",
                        present: true,
                        reason: "",
                    },
                    Term {
                        tag: "13-curvature",
                        present: false,
                        reason: "no curvature along the projection",
                    },
                    Term {
                        tag: "complement",
                        present: true,
                        reason: "",
                    },
                    Term {
                        tag: "13-rotational-right",
                        present: false,
                        reason: "the tangents do not rotate with any unknown",
                    },
                    Term {
                        tag: "13-rotational-left",
                        present: false,
                        reason: "the tangents do not rotate with any unknown",
                    },
                    Term {
                        tag: "quadratic-rotation",
                        present: false,
                        reason: "the tangents do not rotate with any unknown",
                    },
                ],
                cost: 15usize,
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
            name: "PointPoint2d",
            descriptor: PointPoint2d::DESCRIPTOR,
            programs: &PointPoint2d::PROGRAMS,
            slave: SlaveDescription::Point,
            master: MasterDescription::Point,
            law: &::contact_elements::laws::Penalty::PROGRAMS,
            tangential: None,
            axis: AxisDescription::None,
            rolling: None,
            angle: None,
            placed: false,
            signed: false,
            tangent_plane: false,
            current: false,
            moving: false,
            layout: runtime::Layout {
                tangential: 1usize,
                r0: 1usize,
                orientation: None,
                geometry: 2usize,
                master_weights: 2usize,
                slave_weights: 2usize,
                point: 2usize,
                axis: None,
                placement: None,
                count: 2usize,
            },
        };
    }
}
