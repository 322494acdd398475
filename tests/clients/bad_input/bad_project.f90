! bad_project.f90 - bad input to cte_element_project; see bad_input.f90.
module bad_project
  use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
  use, intrinsic :: iso_c_binding, only: c_f_procpointer, c_loc, c_null_ptr, c_ptr, c_sizeof
  use contact_elements
  use client_support
  implicit none
  private
  public :: bad_project_run

  integer(i4), parameter :: no_number = CTE_ERROR_NOT_FINITE, kept_value = -77
  character(len=*), parameter :: element = 'PointQuad4'
  type(bench), save, target :: b
  type(cte_projection), save, target :: found(room_points)
  real(dp), save, target :: history(room_history)

  ! The function with every address by value.
  abstract interface
    function project_call(element, arguments, reach, result, history) bind(c) result(code)
      import :: i4, dp, c_ptr
      type(c_ptr), value :: element, arguments, result, history
      real(dp), value :: reach
      integer(i4) :: code
    end function project_call
  end interface

contains

  subroutine fill()
    found = cte_projection([canary(), canary()], canary(), canary(), kept_value, kept_value, kept_value, kept_value)
    history = canary()
    b%a%error_argument = kept_value
    b%a%error_index = kept_value
  end subroutine fill

  function untouched() result(pass)
    logical :: pass
    integer :: i
    pass = all(found%verdict == kept_value) .and. all(found%feature == kept_value) &
      .and. all(found%boxes == kept_value) .and. all(found%steps == kept_value)
    pass = pass .and. client_same(history, [(canary(), i=1, room_history)]) &
      .and. client_same(found%distance, [(canary(), i=1, room_points)]) &
      .and. client_same(found%definiteness, [(canary(), i=1, room_points)]) &
      .and. client_same(found%zeta(1), [(canary(), i=1, room_points)]) &
      .and. client_same(found%zeta(2), [(canary(), i=1, room_points)])
  end function untouched

  ! The caller's fault, nothing written; entry from 0.
  function refused(reach, code, argument, entry) result(pass)
    real(dp), intent(in) :: reach
    integer(i4), intent(in) :: code, argument
    integer, intent(in) :: entry
    logical :: pass
    integer(i4) :: given
    call fill()
    given = cte_element_project(b%element, b%a, reach, found, c_loc(history))
    pass = given == code .and. b%a%error_argument == argument .and. b%a%error_index == entry .and. untouched() &
      .and. client_contains(client_message(b, given), cte_string(cte_argument_name(argument)))
    if (.not. pass) print '(6(a,i0))', '     code ', given, ' wanted ', code, ', argument ', b%a%error_argument, &
      ' wanted ', argument, ', index ', b%a%error_index, ' wanted ', entry
  end function refused

  subroutine expect(what, code, argument, entry)
    character(len=*), intent(in) :: what
    integer(i4), intent(in) :: code, argument
    integer, intent(in) :: entry
    call client_check(refused(0.0_dp, code, argument, entry), what)
  end subroutine expect

  ! A result with finite numbers, or a code and nothing written; no trap.
  function clean() result(pass)
    logical :: pass
    integer :: n
    call fill()
    n = b%info%points
    if (cte_element_project(b%element, b%a, 0.0_dp, found, c_loc(history)) == CTE_SUCCESS) then
      pass = all(ieee_is_finite(found(:n)%zeta(1))) .and. all(ieee_is_finite(found(:n)%zeta(2))) &
        .and. all(ieee_is_finite(found(:n)%distance)) .and. all(ieee_is_finite(found(:n)%definiteness)) &
        .and. all(found(:n)%verdict >= CTE_VERDICT_INSIDE) .and. all(found(:n)%verdict <= CTE_VERDICT_UNDECIDED) &
        .and. all(ieee_is_finite(history(:b%info%history)))
      if (pass) pass = all(found(:n)%distance >= 0)
    else
      pass = b%a%error_argument /= CTE_ARGUMENT_NONE .and. untouched()
    end if
  end function clean

  subroutine null_calls()
    type(cte_api_table) :: api
    procedure(project_call), pointer :: project
    type(c_ptr) :: arguments, result, start
    logical :: pass
    pass = cte_api(CTE_VERSION_MAJOR, api) == CTE_SUCCESS
    call c_f_procpointer(api%element_project, project)
    call bench_open(b, element)
    call fill()
    arguments = c_loc(b%a)
    result = c_loc(found)
    start = c_loc(history)
    pass = project(b%element, c_null_ptr, 0.0_dp, result, start) == CTE_ERROR_NULL .and. pass
    call client_check(pass .and. untouched(), 'project: arguments null')
    pass = project(c_null_ptr, arguments, 0.0_dp, result, start) == CTE_ERROR_NULL
    call client_check(pass .and. b%a%error_argument == CTE_ARGUMENT_ELEMENT .and. b%a%error_index == 0 &
      .and. untouched(), 'project: element null')
    pass = project(b%element, arguments, 0.0_dp, c_null_ptr, start) == CTE_ERROR_NULL
    call client_check(pass .and. b%a%error_argument == CTE_ARGUMENT_RESULT .and. b%a%error_index == 0 &
      .and. untouched(), 'project: result null')
    pass = project(c_null_ptr, c_null_ptr, 0.0_dp, c_null_ptr, c_null_ptr) == CTE_ERROR_NULL
    call client_check(pass, 'project: everything null')
  end subroutine null_calls

  subroutine null_pointers()
    call bench_open(b, element)
    b%a%x = c_null_ptr
    call expect('project: x null', CTE_ERROR_NULL, CTE_ARGUMENT_X, 0)
    call bench_open(b, element)
    b%a%parameters = c_null_ptr
    call expect('project: parameters null', CTE_ERROR_NULL, CTE_ARGUMENT_PARAMETERS, 0)
    call bench_open(b, 'InterpolatedQuad4')
    b%a%slave_row = c_null_ptr
    call expect('project: slave_row null', CTE_ERROR_NULL, CTE_ARGUMENT_SLAVE_ROW, 0)
  end subroutine null_pointers

  ! Arguments that cannot be read are not written either.
  subroutine struct_sizes()
    integer(i4) :: sizes(4), given ! the last: that of interface 0.1
    integer :: i
    sizes = [0_i4, 8_i4, int(c_sizeof(b%a), i4) - 1, 312]
    call bench_open(b, element)
    do i = 1, 4
      b%a%struct_size = sizes(i)
      call fill()
      given = cte_element_project(b%element, b%a, 0.0_dp, found, c_loc(history))
      call client_check(given == CTE_ERROR_STRUCT_SIZE .and. b%a%error_argument == kept_value .and. untouched(), &
        client_text('project: struct_size', i - 1_i8))
    end do
  end subroutine struct_sizes

  subroutine reaches()
    real(dp), parameter :: below_or_above(4) = [-1.0_dp, -1e-300_dp, -1e30_dp, 1.1e30_dp]
    real(dp) :: reach
    integer(i4) :: given
    integer :: i
    call bench_open(b, element)
    do i = 1, client_specials
      if (i == 2) cycle ! signalling_reach
      call client_special(i, reach)
      call client_check(refused(reach, no_number, CTE_ARGUMENT_REACH, 0), &
        client_text('project: no number as reach', i - 1_i8))
    end do
    do i = 1, 4
      call client_check(refused(below_or_above(i), no_number, CTE_ARGUMENT_REACH, 0), &
        client_text('project: reach below 0 or above 1e30', i - 1_i8))
    end do
    call fill()
    given = cte_element_project(b%element, b%a, -0.0_dp, found, c_loc(history))
    call client_check(given == CTE_SUCCESS, 'project: a reach of minus zero')
  end subroutine reaches

  ! Each entry in turn; the index is the node of x and u, the entry of the row.
  function spoiled(values, per_index, argument) result(pass)
    real(dp), intent(inout), target :: values(:) ! of b
    integer, intent(in) :: per_index
    integer(i4), intent(in) :: argument
    logical :: pass
    real(dp) :: kept
    integer :: i, special
    pass = .true.
    do i = 1, size(values)
      kept = values(i)
      do special = 1, client_specials
        call client_special(special, values(i))
        pass = refused(0.0_dp, no_number, argument, (i - 1)/per_index) .and. pass
      end do
      values(i) = kept
    end do
  end function spoiled

  subroutine not_finite()
    character(len=17), parameter :: name(5) = [character(len=17) :: 'PointQuad4', 'PointQuad4Coulomb', 'PointLine2', &
      'PointPoint', 'InterpolatedQuad4']
    integer :: e, n, eps_n, special
    logical :: pass
    do e = 1, 5
      call bench_open(b, trim(name(e)))
      n = b%info%unknowns
      call client_check(spoiled(b%x(:n), 3, CTE_ARGUMENT_X), client_text('project: no number in x, element', e - 1_i8))
      call client_check(spoiled(b%u(:n), 3, CTE_ARGUMENT_U), client_text('project: no number in u, element', e - 1_i8))
    end do
    call client_check(spoiled(b%row(:1), 1, CTE_ARGUMENT_SLAVE_ROW), 'project: no number in slave_row')
    call bench_open(b, element)
    eps_n = bench_parameter(b, 'eps_n')
    pass = .true.
    do special = 1, client_specials
      call client_special(special, b%parameters(eps_n + 1))
      pass = refused(0.0_dp, no_number, CTE_ARGUMENT_PARAMETERS, eps_n) .and. pass
    end do
    call client_check(pass, 'project: no number as parameter')
    b%parameters(eps_n + 1) = -1
    call expect('project: parameter out of range', CTE_ERROR_PARAMETER, CTE_ARGUMENT_PARAMETERS, eps_n)
  end subroutine not_finite

  subroutine counts()
    integer(i4), parameter :: nnode(5) = [4, 6, -1, huge(1_i4), -huge(1_i4) - 1]
    integer(i8), parameter :: stride(6) = [-3_i8, 2_i8, 1_i8, huge(1_i8), -huge(1_i8) - 1, 2_i8**61]
    integer :: i
    do i = 1, 5
      call bench_open(b, element)
      b%a%nnode = nnode(i)
      call expect(client_text('project: nnode', int(nnode(i), i8)), CTE_ERROR_NODE_COUNT, CTE_ARGUMENT_NNODE, 0)
    end do
    b%a%nnode = 0
    b%a%nslave = 2
    call expect('project: nslave', CTE_ERROR_NODE_COUNT, CTE_ARGUMENT_NSLAVE, 0)
    call bench_open(b, 'InterpolatedQuad4')
    b%a%nslave = 0
    call expect('project: nslave of an interpolated slave', CTE_ERROR_NODE_COUNT, CTE_ARGUMENT_NSLAVE, 0)
    call bench_open(b, element)
    b%a%parameter_count = 0
    call expect('project: no parameters', CTE_ERROR_PARAMETER, CTE_ARGUMENT_PARAMETERS, 0)
    do i = 1, 6
      call bench_open(b, element)
      b%a%x_node_stride = stride(i)
      call expect(client_text('project: x_node_stride', i - 1_i8), CTE_ERROR_STRIDE, CTE_ARGUMENT_X, 0)
      call bench_open(b, element)
      b%a%u_node_stride = stride(i)
      call expect(client_text('project: u_node_stride', i - 1_i8), CTE_ERROR_STRIDE, CTE_ARGUMENT_U, 0)
    end do
  end subroutine counts

  subroutine random_nodes(scale, shift)
    real(dp), intent(in) :: scale, shift
    real(dp) :: value
    integer :: j
    do j = 1, b%info%unknowns - bench_multipliers(b)
      call client_random(value)
      b%x(j) = scale*(value - 0.5_dp) + shift
    end do
  end subroutine random_nodes

  ! Every element: random nodes of every size, a NaN in x.
  subroutine every_element()
    real(dp), parameter :: scale(3) = [1e-30_dp, 1.0_dp, 1e29_dp]
    integer(i4) :: e
    integer :: i
    logical :: pass
    do e = 0, cte_element_count() - 1
      pass = bench_index(b, e, 2)
      do i = 1, 3
        call random_nodes(scale(i), 0.0_dp)
        if (pass) pass = clean()
      end do
      call client_special(1, b%x(1))
      if (pass) pass = refused(0.0_dp, no_number, CTE_ARGUMENT_X, 0)
      call client_check(pass, client_text('project: element', int(e, i8)))
    end do
  end subroutine every_element

  ! All nodes in one place, or nearly: tangents of length zero.
  subroutine one_place()
    character(len=15), parameter :: name(6) = [character(len=15) :: 'PointPoint', 'PointQuad4', 'PointQuad9', &
      'PointTri3', 'Line2Line2Beams', 'PointHermite']
    integer(i4) :: element_index
    integer :: e
    logical :: pass
    do e = 1, 6
      element_index = -1
      pass = cte_element_find(trim(name(e)), len_trim(name(e)), element_index) == CTE_SUCCESS
      if (pass) pass = bench_index(b, element_index, 0)
      call random_nodes(0.0_dp, 1.0_dp)
      if (pass) pass = clean()
      call random_nodes(1e-300_dp, 0.0_dp)
      if (pass) pass = clean()
      call client_check(pass, client_text('project: all nodes in one place', e - 1_i8))
    end do
  end subroutine one_place

  ! By value: a comparison of it would trap.
  subroutine signalling_reach()
    real(dp) :: reach
    call bench_open(b, element)
    call client_special(2, reach)
    call client_check(refused(reach, no_number, CTE_ARGUMENT_REACH, 0), 'project: signalling NaN as reach')
  end subroutine signalling_reach

  subroutine bad_project_run()
    call null_calls()
    call null_pointers()
    call struct_sizes()
    call reaches()
    call not_finite()
    call counts()
    call every_element()
    call one_place()
    call signalling_reach()
  end subroutine bad_project_run

end module bad_project
