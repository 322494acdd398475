! bad_patch.f90 - bad input to cte_patch_info and cte_patch_evaluate; see bad_input.f90.
module bad_patch
  use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
  use, intrinsic :: iso_c_binding, only: c_f_procpointer, c_loc, c_null_ptr, c_ptr
  use contact_elements
  use client_support
  implicit none
  private
  public :: bad_patch_run

  integer, parameter :: points = 2, n = 3*(points + 4), per_point = 5
  integer(i4), parameter :: kept_value = -77, null = CTE_ERROR_NULL, no_count = CTE_ERROR_NODE_COUNT
  integer(i4), parameter :: no_number = CTE_ERROR_NOT_FINITE, no_element = CTE_ERROR_ELEMENT
  integer(i4), save, target :: facet(4)
  real(dp), save, target :: x(n), u(n), parameters(3), history_accepted(per_point*points), workspace(6*points)
  real(dp), save, target :: f(n), k(n*n), output(points*CTE_OUTPUT_SIZE), history_trial(per_point*points), energy(1)
  type(cte_patch), save, target :: patch
  type(cte_arguments), save, target :: a

  ! The functions with every address by value.
  abstract interface
    function evaluate_call(patch, arguments) bind(c) result(code)
      import :: i4, c_ptr
      type(c_ptr), value :: patch, arguments
      integer(i4) :: code
    end function evaluate_call
    function info_call(patch, info, argument) bind(c) result(code)
      import :: i4, c_ptr
      type(c_ptr), value :: patch, info, argument
      integer(i4) :: code
    end function info_call
  end interface

contains

  function named(name) result(element)
    character(len=*), intent(in) :: name
    type(c_ptr) :: element
    integer(i4) :: at
    at = -1
    if (cte_element_find(name, len(name), at) /= CTE_SUCCESS) call client_check(.false., name)
    element = cte_element_get(at)
  end function named

  ! Two points below a unit square.
  subroutine lay_out()
    integer :: i
    patch = cte_patch()
    patch%slave_points = points
    patch%master_nodes = 4
    patch%facets = 1
    patch%facet = named('PointQuad4')
    patch%edge = named('PointLine2Oriented')
    patch%vertex = named('PointPointOriented')
    patch%connectivity = c_loc(facet)
    facet = [(i, i=0, 3)]
    x = [0.25_dp, 0.25_dp, -0.1_dp, 1.5_dp, 0.5_dp, -0.1_dp, [real(dp) :: 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]]
    u = 0
    history_accepted = 0
    parameters = [1000.0_dp, 0.0_dp, 1.0_dp]
    a = cte_arguments()
    a%request = CTE_RESIDUAL + CTE_TANGENT + CTE_OUTPUT + CTE_HISTORY + CTE_ENERGY
    a%x = c_loc(x)
    a%u = c_loc(u)
    a%parameters = c_loc(parameters)
    a%parameter_count = 3
    a%history_accepted = c_loc(history_accepted)
    a%f = c_loc(f)
    a%k = c_loc(k)
    a%output = c_loc(output)
    a%history_trial = c_loc(history_trial)
    a%energy = c_loc(energy)
    a%workspace = c_loc(workspace)
    a%workspace_size = 6*points
  end subroutine lay_out

  function blank(values) result(pass)
    real(dp), intent(in) :: values(:)
    logical :: pass
    integer :: i
    pass = client_same(values, [(canary(), i=1, size(values))])
  end function blank

  ! The caller's fault, nothing written; entry from 0.
  subroutine expect(what, code, argument, entry)
    character(len=*), intent(in) :: what
    integer(i4), intent(in) :: code, argument
    integer, intent(in) :: entry
    integer(i4) :: given
    logical :: pass
    f = canary()
    k = canary()
    output = canary()
    history_trial = canary()
    energy = canary()
    a%error_argument = kept_value
    a%error_index = kept_value
    given = cte_patch_evaluate(patch, a)
    pass = given == code .and. a%error_argument == argument .and. a%error_index == entry .and. blank(f) &
      .and. blank(k) .and. blank(output) .and. blank(history_trial) .and. blank(energy)
    if (.not. pass) print '(6(a,i0))', '     code ', given, ' wanted ', code, ', argument ', a%error_argument, &
      ' wanted ', argument, ', index ', a%error_index, ' wanted ', entry
    call client_check(pass, what)
    call lay_out()
  end subroutine expect

  subroutine null_pointers()
    type(cte_api_table) :: api
    procedure(evaluate_call), pointer :: evaluate
    logical :: pass
    pass = cte_api(CTE_VERSION_MAJOR, api) == CTE_SUCCESS
    call c_f_procpointer(api%patch_evaluate, evaluate)
    pass = evaluate(c_loc(patch), c_null_ptr) == null .and. pass
    call client_check(pass, 'patch: arguments null')
    pass = evaluate(c_null_ptr, c_loc(a)) == null
    call client_check(pass .and. a%error_argument == CTE_ARGUMENT_PATCH, 'patch: null')
    patch%facet = c_null_ptr
    call expect('patch: facet null', null, CTE_ARGUMENT_FACET, 0)
    patch%connectivity = c_null_ptr
    call expect('patch: connectivity null', null, CTE_ARGUMENT_CONNECTIVITY, 0)
    a%x = c_null_ptr
    call expect('patch: x null', null, CTE_ARGUMENT_X, 0)
    a%parameters = c_null_ptr
    call expect('patch: parameters null', null, CTE_ARGUMENT_PARAMETERS, 0)
    a%workspace = c_null_ptr
    call expect('patch: workspace null', null, CTE_ARGUMENT_WORKSPACE, 0)
    a%f = c_null_ptr
    call expect('patch: f null', null, CTE_ARGUMENT_F, 0)
    a%history_accepted = c_null_ptr
    a%request = ior(a%request, CTE_FREEZE_STATE)
    call expect('patch: frozen without history', null, CTE_ARGUMENT_HISTORY_ACCEPTED, 0)
  end subroutine null_pointers

  subroutine counts()
    patch%struct_size = 8
    call expect('patch: struct_size', CTE_ERROR_STRUCT_SIZE, CTE_ARGUMENT_PATCH, 0)
    patch%struct_size = 120
    call expect('patch: struct_size of interface 0.1', CTE_ERROR_STRUCT_SIZE, CTE_ARGUMENT_PATCH, 0)
    patch%slave_points = 0
    call expect('patch: no slave points', no_count, CTE_ARGUMENT_NSLAVE, 0)
    patch%master_nodes = -1
    call expect('patch: no master nodes', no_count, CTE_ARGUMENT_NNODE, 0)
    patch%facets = 0
    call expect('patch: no facets', no_count, CTE_ARGUMENT_FACETS, 0)
    patch%slave_points = huge(1_i4)
    call expect('patch: too many unknowns', no_count, CTE_ARGUMENT_NNODE, 0)
    a%nnode = 5
    call expect('patch: nnode', no_count, CTE_ARGUMENT_NNODE, 0)
    facet(3) = 4
    call expect('patch: no such node', CTE_ERROR_INDEX, CTE_ARGUMENT_CONNECTIVITY, 2)
    facet(4) = -1
    call expect('patch: negative node', CTE_ERROR_INDEX, CTE_ARGUMENT_CONNECTIVITY, 3)
    a%workspace_size = 6*points - 1
    call expect('patch: small workspace', CTE_ERROR_WORKSPACE, CTE_ARGUMENT_WORKSPACE, 0)
    a%request = ior(a%request, CTE_PROJECTION_GIVEN)
    call expect('patch: no projection can be given', CTE_ERROR_REQUEST, CTE_ARGUMENT_REQUEST, 7)
    a%k_row_stride = -1
    call expect('patch: stride', CTE_ERROR_STRIDE, CTE_ARGUMENT_K_STRIDE, 0)
  end subroutine counts

  subroutine elements()
    patch%facet = named('PointQuad4Coulomb')
    call expect('patch: friction', no_element, CTE_ARGUMENT_FACET, 0)
    patch%facet = named('Quad4Quad4')
    call expect('patch: no point as slave', no_element, CTE_ARGUMENT_FACET, 0)
    patch%edge = named('PointLine2')
    call expect('patch: an edge without sides', no_element, CTE_ARGUMENT_EDGE, 0)
    patch%edge = named('PointLine3Oriented')
    call expect('patch: the edge of another facet', no_element, CTE_ARGUMENT_EDGE, 0)
    patch%vertex = named('PointPoint')
    call expect('patch: a vertex without sides', no_element, CTE_ARGUMENT_VERTEX, 0)
    patch%vertex = named('PointPointOriented2d')
    call expect('patch: a vertex of the plane', no_element, CTE_ARGUMENT_VERTEX, 0)
  end subroutine elements

  subroutine numbers()
    integer :: special
    do special = 1, client_specials
      call client_special(special, x(5))
      call expect(client_text('patch: no number in x', special - 1_i8), no_number, CTE_ARGUMENT_X, 1)
      call client_special(special, u(18))
      call expect(client_text('patch: no number in u', special - 1_i8), no_number, CTE_ARGUMENT_U, 5)
      call client_special(special, parameters(2))
      call expect(client_text('patch: no number in parameters', special - 1_i8), no_number, CTE_ARGUMENT_PARAMETERS, 1)
      call client_special(special, history_accepted(8))
      call expect(client_text('patch: no number in history_accepted', special - 1_i8), no_number, CTE_ARGUMENT_HISTORY_ACCEPTED, 7)
    end do
    parameters(1) = 0
    call expect('patch: eps_n', CTE_ERROR_PARAMETER, CTE_ARGUMENT_PARAMETERS, 0)
    a%parameter_count = 2
    call expect('patch: too few parameters', CTE_ERROR_PARAMETER, CTE_ARGUMENT_PARAMETERS, 2)
    history_accepted(6) = 17
    call expect('patch: no status', CTE_ERROR_HISTORY, CTE_ARGUMENT_HISTORY_ACCEPTED, 5)
    history_accepted(7) = 2
    call expect('patch: no such facet', CTE_ERROR_HISTORY, CTE_ARGUMENT_HISTORY_ACCEPTED, 6)
    patch%reach = -1
    call expect('patch: negative reach', no_number, CTE_ARGUMENT_REACH, 0)
  end subroutine numbers

  ! All nodes in one place: a facet without an area has no normal.
  subroutine degenerate()
    integer(i4) :: code
    logical :: pass
    x(7:) = 0
    code = cte_patch_evaluate(patch, a)
    pass = code == CTE_SUCCESS .or. code == CTE_CUT_BACK
    if (code == CTE_SUCCESS) pass = all(ieee_is_finite(f))
    call client_check(pass, 'patch: a facet without an area')
    call lay_out()
  end subroutine degenerate

  subroutine info()
    type(cte_info), target :: sizes
    type(cte_api_table) :: api
    procedure(info_call), pointer :: patch_info
    integer(i4), target :: argument
    logical :: pass
    pass = cte_api(CTE_VERSION_MAJOR, api) == CTE_SUCCESS
    call c_f_procpointer(api%patch_info, patch_info)
    pass = patch_info(c_loc(patch), c_null_ptr, c_loc(argument)) == null .and. pass
    call client_check(pass .and. argument == CTE_ARGUMENT_INFO, 'patch: info null')
    sizes%struct_size = 8
    pass = patch_info(c_loc(patch), c_loc(sizes), c_loc(argument)) == CTE_ERROR_STRUCT_SIZE
    call client_check(pass .and. argument == CTE_ARGUMENT_INFO, 'patch: info''s struct_size')
    sizes%struct_size = 152
    pass = patch_info(c_loc(patch), c_loc(sizes), c_loc(argument)) == CTE_ERROR_STRUCT_SIZE
    call client_check(pass .and. argument == CTE_ARGUMENT_INFO, 'patch: info''s struct_size of interface 0.1')
    sizes = cte_info()
    patch%facets = 0
    pass = patch_info(c_loc(patch), c_loc(sizes), c_loc(argument)) == no_count
    pass = pass .and. argument == CTE_ARGUMENT_FACETS
    pass = patch_info(c_null_ptr, c_loc(sizes), c_null_ptr) == null .and. pass
    call client_check(pass, 'patch: info of no patch')
  end subroutine info

  subroutine bad_patch_run()
    call lay_out()
    call null_pointers()
    call counts()
    call elements()
    call numbers()
    call degenerate()
    call info()
  end subroutine bad_patch_run

end module bad_patch
