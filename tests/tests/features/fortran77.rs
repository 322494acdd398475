//! What the Fortran 77 door checks on its own: here the leading dimension of K.

use contact_elements::abi::fortran;
use contact_elements::{code, request};
use contact_library::PointPoint2d;

/// Two discs of radius 1 at distance 1.5: return code and residual.
fn evaluate_discs(request: u32, ldk: i32) -> (i32, [f64; 4]) {
    let (x, parameters) = ([0.0, 0.0, 1.5, 0.0], [10.0, 2.0]);
    let (mut f, mut k, mut history) = ([0.0; 4], [0.0; 16], [0.0]);
    let (mut state, mut result) = ([-1; 4], -1);
    let (index, nodes, request, count) = (0, 2, request as i32, 2);
    let nothing = std::ptr::null_mut::<f64>();
    let addresses = fortran::Addresses {
        request: &request,
        nnode: &nodes,
        x: x.as_ptr(),
        ldx: &2,
        u: nothing,
        ldu: &0,
        parameters: parameters.as_ptr(),
        parameter_count: &count,
        history_accepted: nothing,
        history_trial: history.as_mut_ptr(),
        mapped: &0,
        map: std::ptr::null(),
        f_scale: &1.0,
        k_scale: &1.0,
        f: f.as_mut_ptr(),
        k: k.as_mut_ptr(),
        ldk: &ldk,
        output: nothing,
        energy: nothing,
        workspace: nothing,
        workspace_size: &0,
    };
    // SAFETY: every array has the shape that the header gives.
    unsafe {
        fortran::evaluate(
            &[PointPoint2d::DESCRIPTOR],
            &index,
            &0,
            nothing,
            addresses,
            state.as_mut_ptr(),
            &raw mut result,
        );
    }
    assert!(state.iter().all(|&entry| entry >= 0), "{state:?}");
    (result, f)
}

#[test]
fn the_leading_dimension_matters_only_with_a_tangent() {
    let with_tangent = request::RESIDUAL | request::TANGENT;
    let (result, expected) = evaluate_discs(with_tangent, 4);
    assert_eq!(result, code::SUCCESS);
    assert!(expected[0] != 0.0);
    for ldk in [-1, 0, 1, 3] {
        assert_eq!(evaluate_discs(with_tangent, ldk).0, code::STRIDE);
        let residual_only = evaluate_discs(request::RESIDUAL, ldk);
        assert_eq!(residual_only, (code::SUCCESS, expected));
    }
}
