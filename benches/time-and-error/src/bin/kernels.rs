//! Micro-benchmarks of the kernels by criterion: `cargo run --release --bin kernels -- --bench FILTER`.

use contact_time_and_error::case::{Answer, Request};
use contact_time_and_error::states::Catalogue;
use contact_verify::configurations::Wanted;
use criterion::Criterion;

/// Elements of one point, of integrated facets, with friction.
const ELEMENTS: [&str; 10] = [
    "PointQuad4",
    "PointQuad9",
    "PointTri3",
    "PointPlane",
    "PointCylinder",
    "PointCylinderDistance",
    "Line2Line2Beams",
    "HermiteHermiteBeams",
    "Quad4Quad4",
    "PointQuad4Coulomb",
];

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    let all = Catalogue::new().expect("the built-in elements");
    for element in ELEMENTS {
        let cases = all.cases(element, Wanted::Closed, 1).expect("a state");
        let case = cases[0].projected().expect("its projection");
        let mut group = criterion.benchmark_group(element);
        let mut answer = Answer::of(&case);
        for (name, request) in [
            ("R", Request::RESIDUAL),
            ("R and K", Request::BOTH),
            ("R and K, projection given", Request::GIVEN),
        ] {
            group.bench_function(name, |bencher| {
                bencher.iter(|| case.evaluate(request, &mut answer));
            });
        }
        group.finish();
    }
    criterion.final_summary();
}
