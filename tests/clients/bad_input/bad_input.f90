! bad_input.f90 - every kind of bad input to one evaluation, floating-point traps on.
!
! Each case spoils one thing of a sound call and checks: the return code, the argument named, that
! cte_element_message names it too, and that no bit of the caller's arrays has changed. bad_calls.f90 and
! bad_batches.f90 do the same for the other functions. bad_input.c is the twin.
! Compile with -ffpe-trap=invalid,zero,overflow.
program bad_input
  use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
  use, intrinsic :: iso_c_binding, only: c_loc, c_null_ptr, c_sizeof
  use contact_elements
  use client_support
  use bad_calls, only: bad_calls_run
  use bad_fortran77, only: bad_fortran77_run
  use bad_batches, only: bad_batches_run
  use bad_maps, only: bad_maps_run
  use bad_states, only: bad_states_run
  use bad_friction, only: bad_friction_run
  use bad_multipliers, only: bad_multipliers_run
  use bad_project, only: bad_project_run
  use bad_patch, only: bad_patch_run
  implicit none
  type(bench), save, target :: b
  call null_pointers()
  call struct_sizes()
  call counts()
  call workspace()
  call parameters()
  call not_finite()
  call strides()
  call degenerate_facets()
  call degenerate_distances()
  call scales()
  call every_element()
  call bad_calls_run()
  call bad_fortran77_run()
  call bad_batches_run()
  call bad_maps_run()
  call bad_states_run()
  call bad_friction_run()
  call bad_multipliers_run()
  call bad_project_run()
  call bad_patch_run()
  print '(2a,i0,a)', merge('PASS', 'FAIL', client_failures == 0), ' bad_input, ', client_failures, ' failures'
  if (client_failures /= 0) stop 1

contains

  ! Evaluates the spoiled bench: the caller's fault.
  subroutine expect(what, code, argument)
    character(len=*), intent(in) :: what
    integer(i4), intent(in) :: code, argument
    character(len=:), allocatable :: text
    integer(i4) :: found
    logical :: pass
    call bench_canary(b)
    found = bench_evaluate(b)
    text = client_message(b, found)
    pass = found == code .and. b%a%error_argument == argument .and. bench_untouched(b) &
      .and. client_contains(text, cte_string(cte_argument_name(argument)))
    call client_check(pass, what)
    if (pass) return
    print '(4(a,i0),a,l1,2a)', '     code ', found, ' wanted ', code, ', argument ', b%a%error_argument, &
      ' wanted ', argument, ', untouched: ', bench_untouched(b), ', text: ', text
  end subroutine expect

  ! Evaluates a state without a projection: to be cut back, as degenerate or not unique.
  subroutine expect_degenerate(what)
    character(len=*), intent(in) :: what
    character(len=:), allocatable :: text
    integer(i4) :: found
    logical :: pass
    call bench_canary(b)
    found = bench_evaluate(b)
    text = client_message(b, found)
    pass = found == CTE_CUT_BACK .and. any(b%a%status == [CTE_STATUS_DEGENERATE, CTE_STATUS_NOT_UNIQUE]) &
      .and. b%a%dt_ratio > 0 .and. b%a%dt_ratio < 1 .and. b%a%error_index == 0 &
      .and. b%a%closed_points == 0 .and. len(text) > 0 .and. bench_untouched(b)
    call client_check(pass, what)
    if (pass) return
    print '(2(a,i0),a,es9.2,a,i0,a,l1,2a)', '     code ', found, ', status ', b%a%status, ', dt_ratio ', &
      b%a%dt_ratio, ', index ', b%a%error_index, ', untouched: ', bench_untouched(b), ', text: ', text
  end subroutine expect_degenerate

  ! All requested outputs are finite.
  function finite_outputs() result(finite)
    logical :: finite
    integer :: n
    n = b%info%unknowns
    finite = all(ieee_is_finite(b%out%f(:n))) .and. all(ieee_is_finite(b%out%history_trial(:b%info%history))) &
      .and. all(ieee_is_finite(b%out%output(:b%info%points*CTE_OUTPUT_SIZE)))
    if (iand(b%a%request, CTE_ENERGY) /= 0) finite = finite .and. ieee_is_finite(b%out%energy(1))
    if (iand(b%a%request, CTE_TANGENT) /= 0) finite = finite .and. all(ieee_is_finite(b%out%k(:n*n)))
  end function finite_outputs

  ! Extreme but not wrong: a result with finite numbers, or a code and untouched arrays. No trap.
  function clean() result(pass)
    logical :: pass
    call bench_canary(b)
    if (bench_evaluate(b) == CTE_SUCCESS) then
      pass = finite_outputs()
    else
      pass = bench_untouched(b)
    end if
  end function clean

  subroutine expect_clean(what)
    character(len=*), intent(in) :: what
    logical :: pass
    pass = clean()
    call client_check(pass, what)
    if (.not. pass) print '(a,i0)', '     status ', b%a%status
  end subroutine expect_clean

  subroutine null_pointers()
    call bench_open(b, 'PointQuad4')
    b%a%x = c_null_ptr
    call expect('x null', CTE_ERROR_NULL, CTE_ARGUMENT_X)
    call bench_open(b, 'PointQuad4')
    b%a%parameters = c_null_ptr
    call expect('parameters null', CTE_ERROR_NULL, CTE_ARGUMENT_PARAMETERS)
    call bench_open(b, 'PointQuad4')
    b%a%f = c_null_ptr
    call expect('f null with CTE_RESIDUAL', CTE_ERROR_NULL, CTE_ARGUMENT_F)
    call bench_open(b, 'PointQuad4')
    b%a%k = c_null_ptr
    call expect('k null with CTE_TANGENT', CTE_ERROR_NULL, CTE_ARGUMENT_K)
    call bench_open(b, 'PointQuad4')
    b%a%history_trial = c_null_ptr
    call expect('history_trial null with CTE_HISTORY', CTE_ERROR_NULL, CTE_ARGUMENT_HISTORY_TRIAL)
    call bench_open(b, 'PointQuad4')
    b%a%output = c_null_ptr
    call expect('output null with CTE_OUTPUT', CTE_ERROR_NULL, CTE_ARGUMENT_OUTPUT)
    call bench_open(b, 'PointQuad4')
    b%a%energy = c_null_ptr
    call expect('energy null with CTE_ENERGY', CTE_ERROR_NULL, CTE_ARGUMENT_ENERGY)
    call bench_open(b, 'PointQuad4')
    b%a%request = ior(b%a%request, CTE_PROJECTION_GIVEN)
    b%a%history_accepted = c_null_ptr
    call expect('history_accepted null with CTE_PROJECTION_GIVEN', CTE_ERROR_NULL, CTE_ARGUMENT_HISTORY_ACCEPTED)
    call bench_open(b, 'PointQuad4')
    b%a%request = ior(b%a%request, CTE_FREEZE_STATE)
    b%a%history_accepted = c_null_ptr
    call expect('history_accepted null with CTE_FREEZE_STATE', CTE_ERROR_NULL, CTE_ARGUMENT_HISTORY_ACCEPTED)
    call bench_open(b, 'InterpolatedQuad4')
    b%a%slave_row = c_null_ptr
    call expect('slave_row null', CTE_ERROR_NULL, CTE_ARGUMENT_SLAVE_ROW)
    call bench_open(b, 'PointQuad4')
    b%element = c_null_ptr
    call expect('element null', CTE_ERROR_NULL, CTE_ARGUMENT_ELEMENT)
  end subroutine null_pointers

  ! Nothing beyond the caller's struct may be written, so no scalar is.
  subroutine struct_sizes()
    integer(i4) :: sizes(4), found ! the last: that of interface 0.1
    type(cte_arguments) :: before
    character(len=:), allocatable :: text
    integer :: i
    sizes = [0_i4, 8_i4, int(c_sizeof(b%a), i4) - 1_i4, 312_i4]
    do i = 1, 4
      call bench_open(b, 'PointQuad4')
      b%a%struct_size = sizes(i)
      before = b%a
      call bench_canary(b)
      found = bench_evaluate(b)
      text = client_message(b, found)
      call client_check(found == CTE_ERROR_STRUCT_SIZE .and. bench_untouched(b) &
        .and. all(transfer(before, [0_i8]) == transfer(b%a, [0_i8])) &
        .and. client_contains(text, cte_string(cte_argument_name(CTE_ARGUMENT_STRUCT_SIZE))), &
        client_text('struct_size', int(sizes(i), i8)))
    end do
  end subroutine struct_sizes

  subroutine counts()
    integer(i4), parameter :: nnode(3) = [4, 6, -1], nslave(2) = [0, -1]
    integer(i4), parameter :: unknown(2) = [1024_i4, -huge(0_i4) - 1_i4]
    integer(i4) :: code
    integer :: i
    do i = 1, 3
      call bench_open(b, 'PointQuad4')
      b%a%nnode = nnode(i)
      call expect(client_text('nnode', int(nnode(i), i8)), CTE_ERROR_NODE_COUNT, CTE_ARGUMENT_NNODE)
    end do
    call bench_open(b, 'PointQuad4')
    b%a%nslave = 2
    call expect('nslave for an element with its own slave nodes', CTE_ERROR_NODE_COUNT, CTE_ARGUMENT_NSLAVE)
    do i = 1, 2
      call bench_open(b, 'InterpolatedQuad4')
      b%a%nslave = nslave(i)
      b%a%nnode = 0
      call expect(client_text('interpolated nslave', int(nslave(i), i8)), CTE_ERROR_NODE_COUNT, &
        CTE_ARGUMENT_NSLAVE)
    end do
    call bench_open(b, 'InterpolatedQuad4')
    call bench_canary(b)
    b%a%nslave = huge(0_i4) ! more unknowns than an integer counts
    b%a%nnode = 0
    code = bench_evaluate(b)
    call client_check(code < 0 .and. bench_untouched(b), 'interpolated nslave: the largest integer')
    do i = 1, 2
      call bench_open(b, 'PointQuad4')
      b%a%request = ior(b%a%request, unknown(i))
      call expect(client_text('unknown request bit', iand(int(unknown(i), i8), 4294967295_i8)), &
        CTE_ERROR_REQUEST, CTE_ARGUMENT_REQUEST)
    end do
  end subroutine counts

  subroutine workspace()
    call bench_open(b, 'InterpolatedQuad4')
    if (b%info%workspace == 0) return
    b%a%workspace = c_null_ptr
    call expect('workspace null', CTE_ERROR_NULL, CTE_ARGUMENT_WORKSPACE)
    call bench_open(b, 'InterpolatedQuad4')
    b%a%workspace_size = b%info%workspace - 1
    call expect('workspace too small', CTE_ERROR_WORKSPACE, CTE_ARGUMENT_WORKSPACE)
  end subroutine workspace

  subroutine parameters()
    integer(i4), parameter :: missing(3) = [0, -1, 1] ! 1: one too few
    integer :: i
    do i = 1, 3
      call bench_open(b, 'PointQuad4')
      b%a%parameter_count = merge(b%info%parameters - 1_i4, missing(i), missing(i) == 1)
      call expect(client_text('parameter_count', int(b%a%parameter_count, i8)), CTE_ERROR_PARAMETER, &
        CTE_ARGUMENT_PARAMETERS)
    end do
    call bench_open(b, 'PointQuad4')
    call bench_set(b, 'eps_n', -1.0_dp)
    call expect('eps_n negative', CTE_ERROR_PARAMETER, CTE_ARGUMENT_PARAMETERS)
    call client_check(b%a%error_index == bench_parameter(b, 'eps_n') &
      .and. client_contains(client_message(b, CTE_ERROR_PARAMETER), 'eps_n'), &
      'eps_n negative: named in index and text')
    call bench_open(b, 'PointCylinder')
    call bench_set(b, 'radius', -1.0_dp)
    call expect('radius negative', CTE_ERROR_PARAMETER, CTE_ARGUMENT_PARAMETERS)
  end subroutine parameters

  subroutine not_finite()
    character(len=16), parameter :: place(8) = [character(len=16) :: 'x', 'u', 'history_accepted', 'eps_n', &
      'slave_row', 'slave weight', 'f_scale', 'k_scale']
    integer(i4), parameter :: argument(8) = [CTE_ARGUMENT_X, CTE_ARGUMENT_U, CTE_ARGUMENT_HISTORY_ACCEPTED, &
      CTE_ARGUMENT_PARAMETERS, CTE_ARGUMENT_SLAVE_ROW, CTE_ARGUMENT_SLAVE_ROW, CTE_ARGUMENT_SCALE, &
      CTE_ARGUMENT_SCALE]
    integer :: i, special
    do i = 1, 8
      do special = 1, client_specials
        call bench_open(b, 'InterpolatedQuad4')
        if (i == 1) call client_special(special, b%x(5))
        if (i == 2) call client_special(special, b%u(6))
        if (i == 3) call client_special(special, b%history_accepted(2))
        if (i == 4) call client_special(special, b%parameters(bench_parameter(b, 'eps_n') + 1))
        if (i == 5) call client_special(special, b%row(1))
        if (i == 6) call client_special(special, b%row(2))
        if (i == 7) call client_special(special, b%a%f_scale)
        if (i == 8) call client_special(special, b%a%k_scale)
        call expect(trim(client_special_name(special))//' in '//trim(place(i)), CTE_ERROR_NOT_FINITE, argument(i))
      end do
    end do
  end subroutine not_finite

  subroutine strides()
    integer(i8), parameter :: k_stride(2, 7) = reshape([-15_i8, 1_i8, 15_i8, -1_i8, 1_i8, 1_i8, 3_i8, 1_i8, &
      1_i8, 14_i8, 0_i8, 1_i8, 1_i8, 0_i8], [2, 7])
    integer(i4), save, target :: map(15)
    integer :: i
    do i = 1, 7
      call bench_open(b, 'PointQuad4')
      b%a%k_row_stride = k_stride(1, i)
      b%a%k_col_stride = k_stride(2, i)
      call expect(client_text('k strides negative or overlapping', int(i - 1, i8)), CTE_ERROR_STRIDE, &
        CTE_ARGUMENT_K_STRIDE)
    end do
    call bench_open(b, 'PointQuad4')
    b%a%x_node_stride = -3
    call expect('x_node_stride negative', CTE_ERROR_STRIDE, CTE_ARGUMENT_X)
    call bench_open(b, 'PointQuad4')
    b%a%u_node_stride = -3
    call expect('u_node_stride negative', CTE_ERROR_STRIDE, CTE_ARGUMENT_U)
    map = [(int(i, i4), i=0, 14)]
    map(4) = -1
    call bench_open(b, 'PointQuad4')
    b%a%unknown_map = c_loc(map)
    call expect('unknown_map negative', CTE_ERROR_INDEX, CTE_ARGUMENT_UNKNOWN_MAP)
    call client_check(b%a%error_index == 3, 'unknown_map negative: entry 3')
    map(4) = 40
    b%a%k_row_stride = 15
    b%a%k_col_stride = 1
    call expect('unknown_map beyond the row stride', CTE_ERROR_STRIDE, CTE_ARGUMENT_K_STRIDE)
  end subroutine strides

  ! Copies the coordinates of node `from` to node `to`, both counted from 0.
  subroutine coincide(to, from)
    integer, intent(in) :: to, from
    b%x(3*to + 1:3*to + 3) = b%x(3*from + 1:3*from + 3)
  end subroutine coincide

  subroutine degenerate_facets()
    integer :: node
    call bench_open(b, 'PointQuad4')
    do node = 2, 4
      call coincide(node, 1)
    end do
    call expect_degenerate('facet: all nodes equal')
    do node = 1, 4
      b%x(3*node + 1:3*node + 3) = [0.3_dp*node, 0.0_dp, 1.0_dp]
    end do
    call expect_degenerate('facet: all nodes on a line')
    call bench_open(b, 'PointQuad4')
    call coincide(2, 1)
    call expect_clean('facet: neighbouring nodes coincide')
    call coincide(0, 1)
    call expect_clean('facet: the slave on the coincident nodes')
    call bench_open(b, 'PointQuad4')
    call coincide(3, 1)
    call expect_clean('facet: opposite nodes coincide')
    call coincide(4, 2)
    call expect_degenerate('facet: both pairs of opposite nodes coincide')
  end subroutine degenerate_facets

  subroutine degenerate_distances()
    call bench_open(b, 'PointCylinder')
    b%x(:3) = [0.0_dp, 0.0_dp, 0.3_dp]
    call expect_degenerate('slave on the axis of a cylinder')
    call bench_open(b, 'PointCylinderDistance')
    b%x(:3) = [0.0_dp, 0.0_dp, 0.3_dp]
    call expect_degenerate('slave on the axis of a cylinder given by its distance')
    call bench_open(b, 'PointLine2')
    b%x(:3) = [0.5_dp, 0.0_dp, 0.0_dp]
    call expect_degenerate('L = 0 against a line')
    call bench_open(b, 'PointLine2')
    call coincide(2, 1)
    call expect_degenerate('line of length zero')
    call bench_open(b, 'PointPoint')
    call coincide(0, 1)
    call expect_degenerate('L = 0 between points')
  end subroutine degenerate_distances

  ! Lengths from far below the least allowed to the largest.
  subroutine scales()
    real(dp), parameter :: scale(6) = [1e-300_dp, 1e-160_dp, 1e-30_dp, 1e-12_dp, 1e12_dp, 1e29_dp]
    character(len=17), parameter :: name(5) = [character(len=17) :: 'PointQuad4', 'InterpolatedQuad4', &
      'PointLine2', 'PointPoint', 'PointCylinder']
    integer(i8), parameter :: exponent_of(6) = [-300, -160, -30, -12, 12, 29]
    integer :: e, i
    do e = 1, 5
      do i = 1, 6
        call bench_open(b, trim(name(e)))
        b%x = b%x*scale(i)
        call expect_clean(client_text(trim(name(e))//', lengths times ten to the power', exponent_of(i)))
      end do
    end do
  end subroutine scales

  ! Every element: all nodes in one place, random nodes and multipliers of every size, a NaN in every unknown.
  subroutine every_element()
    real(dp), parameter :: scale(8) = [0.0_dp, 1e-300_dp, 1e-160_dp, 1e-30_dp, 1e-12_dp, 1.0_dp, 1e12_dp, 1e29_dp]
    real(dp) :: value
    integer(i4) :: e
    integer :: i, j, shift
    logical :: pass
    do e = 0, cte_element_count() - 1
      pass = bench_index(b, e, 2)
      if (pass) pass = clean()
      do i = 1, 8
        do shift = 0, 1
          do j = 1, b%info%unknowns
            call client_random(value)
            value = scale(i)*(value - 0.5_dp*shift)
            if (bench_is_multiplier(b, j)) then
              b%u(bench_position(b, j)) = -value
            else
              b%x(j) = value + merge(1.0_dp, 0.0_dp, i == 1)
            end if
          end do
          if (pass) pass = clean()
        end do
      end do
      do j = 1, b%info%unknowns
        call client_special(mod(j - 1, client_specials) + 1, b%u(bench_position(b, j)))
        call bench_canary(b)
        if (pass) pass = bench_evaluate(b) == CTE_ERROR_NOT_FINITE
        pass = pass .and. b%a%error_argument == CTE_ARGUMENT_U .and. bench_untouched(b)
        b%u(bench_position(b, j)) = 0
      end do
      call client_check(pass, cte_string(b%info%name))
    end do
  end subroutine every_element

end program bad_input
