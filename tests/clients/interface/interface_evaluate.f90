! interface_evaluate.f90 - every component of cte_arguments, on PointQuad4 and InterpolatedQuad4.
module interface_evaluate
  use, intrinsic :: iso_c_binding, only: c_loc, c_null_ptr, c_sizeof
  use contact_elements
  use client_support
  implicit none
  private
  public :: interface_evaluate_run

  integer, parameter :: n = 15, ld = 24 ! unknowns of PointQuad4; leading dimension of a larger host matrix
  integer, parameter :: gap = CTE_OUTPUT_GAP + 1, traction = CTE_OUTPUT_NORMAL_TRACTION + 1
  integer, parameter :: weight = CTE_OUTPUT_WEIGHT + 1, projection = CTE_OUTPUT_PROJECTION + 1
  integer, parameter :: normal = CTE_OUTPUT_NORMAL + 1, iteration = CTE_OUTPUT_ITERATIONS + 1
  integer, parameter :: feature = CTE_OUTPUT_FEATURE + 1, point_status = CTE_OUTPUT_STATUS + 1
  real(dp), parameter :: eps_n = 100 ! of the bench [force/length]
  type(bench), save, target :: b, reference ! the reference is evaluated once, dense and row-major

contains

  ! Evaluates after the caller's change; true when it succeeds.
  function evaluated() result(pass)
    logical :: pass
    call bench_canary(b)
    pass = bench_evaluate(b) == CTE_SUCCESS
  end function evaluated

  ! Row i, column j from 0 of a dense row-major K.
  function k_of(any_bench, i, j) result(entry_of_k)
    type(bench), intent(in) :: any_bench
    integer, intent(in) :: i, j
    real(dp) :: entry_of_k
    entry_of_k = any_bench%out%k(i*n + j + 1)
  end function k_of

  function same_as_reference() result(same)
    logical :: same
    same = client_same(b%out%f(:n), reference%out%f(:n)) &
      .and. client_same(b%out%k(:n*n), reference%out%k(:n*n)) &
      .and. client_same(b%out%history_trial(:b%info%history), reference%out%history_trial(:b%info%history)) &
      .and. client_same(b%out%output(:CTE_OUTPUT_SIZE), reference%out%output(:CTE_OUTPUT_SIZE)) &
      .and. client_same(b%out%energy, reference%out%energy)
  end function same_as_reference

  ! Output, energy and scalars of a closed point against each other.
  subroutine outputs()
    real(dp) :: out(CTE_OUTPUT_SIZE), total(3), f(3, 5)
    logical :: pass
    call bench_open(reference, 'PointQuad4')
    call bench_canary(reference)
    pass = bench_evaluate(reference) == CTE_SUCCESS
    out = reference%out%output(:CTE_OUTPUT_SIZE)
    f = reshape(reference%out%f(:n), [3, 5])
    total = sum(f, 2)
    call client_check(pass .and. reference%a%status == CTE_STATUS_CLOSED .and. reference%a%closed_points == 1 &
      .and. abs(reference%a%dt_ratio - 1) <= 0 .and. reference%a%error_argument == CTE_ARGUMENT_NONE &
      .and. reference%a%error_index == 0, 'closed: status and scalars')
    call client_check(nint(out(point_status)) == CTE_STATUS_CLOSED .and. abs(out(weight) - 1) <= 0 &
      .and. abs(out(feature)) <= 0 .and. out(iteration) >= 1 &
      .and. all(abs(out(projection:projection + 1)) < 1), 'closed: output')
    call client_check(out(gap) < -0.05_dp .and. out(gap) > -0.15_dp &
      .and. abs(out(traction) - eps_n*out(gap)) < 1e-12_dp .and. out(normal + 2) > 0.9_dp &
      .and. abs(sum(out(normal:normal + 2)**2) - 1) < 1e-14_dp, &
      'closed: gap, N = eps_n g, unit normal out of the master')
    call client_check(abs(reference%out%energy(1) - eps_n*out(gap)**2/2) < 1e-14_dp, &
      'closed: energy = eps_n g^2/2')
    call client_check(all(abs(f(:, 1) - out(traction)*out(normal:normal + 2)) < 1e-12_dp) &
      .and. sum(abs(total)) < 1e-12_dp, 'closed: slave force = N n, forces in balance')
    call client_check(nint(reference%out%history_trial(1)) == CTE_STATUS_CLOSED &
      .and. client_same(reference%out%history_trial(2:3), out(projection:projection + 1)), &
      'closed: history = status, projection')
    call bench_open(b, 'PointQuad4')
    pass = evaluated()
    call client_check(pass .and. same_as_reference(), 'same input, same bits')
  end subroutine outputs

  ! Row-major, column-major, and a larger host matrix through a map.
  subroutine layouts()
    real(dp), save, target :: host_k(0:ld - 1, 0:ld - 1), host_f(0:ld - 1)
    integer(i4), save, target :: map(n)
    logical :: pass
    integer :: a, c
    real(dp) :: k(n, n)
    call bench_open(b, 'PointQuad4')
    b%a%k_row_stride = 1
    b%a%k_col_stride = n
    pass = evaluated()
    k = transpose(reshape(b%out%k(:n*n), [n, n]))
    call client_check(pass .and. client_same(reshape(k, [n*n]), reference%out%k(:n*n)), 'column-major K')
    map = [((int(ld - 1 - (4*a + c), i4), c=0, 2), a=0, 4)] ! four rows per node, in reverse
    host_k = canary()
    host_f = canary()
    call bench_open(b, 'PointQuad4')
    b%a%unknown_map = c_loc(map)
    b%a%k_row_stride = 1
    b%a%k_col_stride = ld
    b%a%k = c_loc(host_k)
    b%a%f = c_loc(host_f)
    pass = evaluated()
    k = transpose(host_k(map, map))
    call client_check(pass .and. client_same(reshape(k, [n*n]), reference%out%k(:n*n)) &
      .and. client_same(host_f(map), reference%out%f(:n)), 'K and f through unknown_map into larger arrays')
    host_k(map, map) = canary()
    host_f(map) = canary()
    call client_check(client_same(reshape(host_k, [ld*ld]), spread(canary(), 1, ld*ld)) &
      .and. client_same(host_f, spread(canary(), 1, ld)), 'the rest of the larger arrays untouched')
  end subroutine layouts

  ! Coordinates with a larger node stride; arguments that are not used.
  subroutine inputs()
    integer :: a
    logical :: pass
    call bench_open(b, 'PointQuad4')
    do a = 4, 0, -1
      b%x(7*a + 1:7*a + 3) = b%x(3*a + 1:3*a + 3)
    end do
    b%a%x_node_stride = 7
    b%a%u_node_stride = 4
    pass = evaluated()
    call client_check(pass .and. same_as_reference(), 'x_node_stride, u_node_stride')
    call bench_open(b, 'PointQuad4')
    b%a%u = c_null_ptr
    pass = evaluated()
    call client_check(pass .and. same_as_reference(), 'u null is zero')
    b%a%u_old = c_loc(b%u)
    b%a%v = c_loc(b%u)
    b%a%dt = 0.7_dp
    b%a%nnode = 5
    pass = evaluated()
    call client_check(pass .and. same_as_reference(), 'arguments that are not read yet')
    b%a%history_accepted = c_null_ptr
    pass = evaluated()
    call client_check(pass .and. same_as_reference(), 'history_accepted null starts at the centre')
    call bench_open(b, 'PointQuad4')
    b%u = b%x
    b%x = 0
    pass = evaluated()
    call client_check(pass .and. client_near(b%out%k(:n*n), reference%out%k(:n*n), 1e-13_dp) &
      .and. client_near(b%out%f(:n), reference%out%f(:n), 1e-13_dp), 'x + u is the position')
  end subroutine inputs

  subroutine scales()
    logical :: pass
    integer :: i, j
    call bench_open(b, 'PointQuad4')
    b%a%f_scale = -1
    b%a%k_scale = -0.5_dp
    pass = evaluated()
    call client_check(pass .and. all(abs(b%out%f(:n) + reference%out%f(:n)) <= 0) &
      .and. all(abs(b%out%k(:n*n) + 0.5_dp*reference%out%k(:n*n)) <= 0), 'f_scale -1, k_scale -1/2')
    b%a%f_scale = 1
    b%a%k_scale = 1
    pass = evaluated()
    call client_check(pass .and. same_as_reference(), 'scales of 1 are those of CTE_ARGUMENTS_INIT')
    b%a%f_scale = 0
    b%a%k_scale = 0
    pass = evaluated()
    call client_check(pass .and. all(abs(b%out%f(:n)) <= 0) .and. all(abs(b%out%k(:n*n)) <= 0), 'scales of 0 give zeros')
    call bench_open(b, 'PointQuad4')
    b%a%request = ior(b%a%request, CTE_SYMMETRISE)
    pass = evaluated()
    pass = pass .and. client_same(b%out%f(:n), reference%out%f(:n))
    do i = 0, n - 1
      do j = 0, n - 1
        pass = pass .and. abs(k_of(b, i, j) - 0.5_dp*(k_of(reference, i, j) + k_of(reference, j, i))) <= 0
      end do
    end do
    call client_check(pass, 'CTE_SYMMETRISE writes (K + K^T)/2')
  end subroutine scales

  subroutine history()
    logical :: pass
    integer :: h
    h = b%info%history
    call bench_open(b, 'PointQuad4')
    b%out%history_trial = b%history_accepted
    b%a%history_accepted = c_loc(b%out%history_trial)
    pass = bench_evaluate(b) == CTE_SUCCESS
    call client_check(pass .and. client_same(b%out%f(:n), reference%out%f(:n)) &
      .and. client_same(b%out%k(:n*n), reference%out%k(:n*n)) &
      .and. client_same(b%out%history_trial(:h), reference%out%history_trial(:h)), &
      'history_accepted and history_trial the same array')
    call bench_open(b, 'PointQuad4')
    b%a%request = iand(b%a%request, not(CTE_HISTORY))
    pass = evaluated()
    call client_check(pass .and. client_same(b%out%history_trial(:h), spread(canary(), 1, h)), &
      'history_trial untouched without CTE_HISTORY')
    call bench_open(b, 'PointQuad4')
    b%history_accepted(:h) = reference%out%history_trial(:h)
    b%a%request = ior(b%a%request, CTE_PROJECTION_GIVEN)
    pass = evaluated()
    call client_check(pass .and. abs(b%out%output(iteration)) <= 0 &
      .and. client_near(b%out%f(:n), reference%out%f(:n), 1e-13_dp) &
      .and. client_near(b%out%k(:n*n), reference%out%k(:n*n), 1e-13_dp), &
      'CTE_PROJECTION_GIVEN takes the projection of history_accepted')
  end subroutine history

  function nothing_written_but_zero() result(zero)
    logical :: zero
    zero = all(abs(b%out%f(:n)) <= 0) .and. all(abs(b%out%k(:n*n)) <= 0) .and. abs(b%out%energy(1)) <= 0 &
      .and. b%a%closed_points == 0
  end function nothing_written_but_zero

  ! An open evaluation with this status.
  function inactive(status) result(pass)
    integer(i4), intent(in) :: status
    logical :: pass
    pass = evaluated()
    pass = pass .and. b%a%status == status .and. nothing_written_but_zero()
  end function inactive

  subroutine contact_states()
    logical :: pass
    call bench_open(b, 'PointQuad4')
    b%x(3) = 1.2_dp ! the slave above the facet
    pass = inactive(CTE_STATUS_OPEN)
    call client_check(pass .and. b%out%output(gap) > 0.1_dp .and. nint(b%out%history_trial(1)) == CTE_STATUS_OPEN, &
      'open: zeros')
    b%a%request = ior(b%a%request, CTE_FREEZE_STATE)
    b%history_accepted(1) = CTE_STATUS_CLOSED
    pass = evaluated()
    call client_check(pass .and. b%a%status == CTE_STATUS_CLOSED .and. b%out%f(3) > 1 &
      .and. abs(b%out%output(traction) - eps_n*b%out%output(gap)) < 1e-12_dp, &
      'CTE_FREEZE_STATE: closed in spite of its gap')
    b%x(3) = 0.9_dp
    b%history_accepted(1) = CTE_STATUS_OPEN
    call client_check(inactive(CTE_STATUS_OPEN), 'CTE_FREEZE_STATE: open in spite of its gap')
    call bench_open(b, 'PointQuad4')
    b%x(1) = 1.5_dp ! beside the facet, half way along an edge
    pass = inactive(CTE_STATUS_OUTSIDE)
    call client_check(pass .and. b%out%output(feature) >= 1 .and. b%out%output(feature) <= 4, 'outside: an edge')
    b%x(2) = 1.6_dp ! off a corner
    pass = inactive(CTE_STATUS_OUTSIDE)
    call client_check(pass .and. b%out%output(feature) >= 5 .and. b%out%output(feature) <= 8, 'outside: a vertex')
  end subroutine contact_states

  ! A slave point given by its shape row: alone, weighted, and shared by two nodes.
  subroutine interpolated()
    logical :: pass
    integer(i4) :: found
    call bench_open(b, 'InterpolatedQuad4')
    pass = evaluated()
    call client_check(pass .and. client_near(b%out%f(:n), reference%out%f(:n), 1e-13_dp) &
      .and. client_near(b%out%k(:n*n), reference%out%k(:n*n), 1e-13_dp), &
      'slave_row [1], weight 1 is the point element')
    b%row(2) = 2
    pass = evaluated()
    pass = pass .and. abs(b%out%output(weight) - 2) <= 0
    call client_check(pass .and. client_near(b%out%f(:n)/2, reference%out%f(:n), 1e-13_dp), &
      'weight 2 doubles the force')
    found = -1
    pass = cte_element_find('InterpolatedQuad4', 17, found) == CTE_SUCCESS
    if (pass) pass = bench_index(b, found, 2)
    pass = pass .and. b%info%unknowns == n + 3
    b%x(:3) = reference%x(:3)
    b%x(4:n + 3) = reference%x(:n)
    b%row(:2) = 0.5_dp
    if (pass) pass = evaluated()
    b%out%f(4:6) = b%out%f(4:6) + b%out%f(:3)
    call client_check(pass .and. client_near(b%out%f(4:n + 3), reference%out%f(:n), 1e-13_dp), &
      'slave_row [1/2, 1/2] shares the force')
  end subroutine interpolated

  ! A caller compiled with a later version: its struct is longer.
  subroutine growth()
    type :: later_arguments
      type(cte_arguments) :: a
      real(dp) :: more(4)
    end type later_arguments
    type(later_arguments), target :: later
    logical :: pass
    call bench_open(b, 'PointQuad4')
    call bench_canary(b)
    later%a = b%a
    later%more = canary()
    later%a%struct_size = int(c_sizeof(later%a) + c_sizeof(later%more), i4)
    pass = cte_element_evaluate(b%element, later%a) == CTE_SUCCESS
    call client_check(pass .and. same_as_reference() &
      .and. later%a%struct_size == c_sizeof(later%a) + c_sizeof(later%more) &
      .and. client_same(later%more, spread(canary(), 1, 4)), 'a longer struct of a later header')
  end subroutine growth

  subroutine interface_evaluate_run()
    call outputs()
    call layouts()
    call inputs()
    call scales()
    call history()
    call contact_states()
    call interpolated()
    call growth()
  end subroutine interface_evaluate_run

end module interface_evaluate
