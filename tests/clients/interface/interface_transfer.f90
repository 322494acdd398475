! interface_transfer.f90 - the elastic slip is carried along when a sliding point passes from one facet to the next.
!
! Facet A is the square [-1,1]^2. Facet B joins it at x = 1, coplanar or turned about that edge; its nodes are
! counted from another corner and it is a parallelogram, so nothing but the slip in space is common to both.
module interface_transfer
  use, intrinsic :: iso_c_binding, only: c_f_procpointer
  use contact_elements
  use client_support
  implicit none
  private
  public :: interface_transfer_run

  integer, parameter :: n = 15, history_size = 6
  real(dp), parameter :: eps_t = 50.0_dp ! [force/length]
  real(dp), parameter :: start(3) = [0.85_dp, 0.3_dp, -0.05_dp] ! of the slave [length]
  real(dp), parameter :: square(12) = [real(dp) :: -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]
  type(bench), save, target :: a, b, line ! the two facets, and a segment in the plane

contains

  subroutine facet(any_bench, nodes)
    type(bench), intent(inout), target :: any_bench
    real(dp), intent(in) :: nodes(12)
    call bench_open(any_bench, 'PointQuad4Coulomb')
    any_bench%x(:n) = [start, nodes]
    call bench_set(any_bench, 'eps_t', eps_t)
  end subroutine facet

  ! Facet A with the point accepted at start + move, sliding; false on failure.
  function slid(x, y) result(pass)
    real(dp), intent(in) :: x, y
    logical :: pass
    call facet(a, square)
    pass = bench_evaluate(a) == CTE_SUCCESS
    a%history_accepted(:history_size) = a%out%history_trial(:history_size)
    a%u(:2) = [x, y]
    pass = bench_evaluate(a) == CTE_SUCCESS .and. pass
    pass = pass .and. a%a%status == CTE_STATUS_SLIP
  end function slid

  ! Facet B, turned up by an angle, evaluated at the displacements of A with an open history.
  function neighbour(angle) result(pass)
    real(dp), intent(in) :: angle
    logical :: pass
    real(dp) :: c, s
    c = cos(angle)
    s = sin(angle)
    call facet(b, [real(dp) :: 1, 1, 0, 1, -1, 0, 1 + 3*c, -0.6_dp, 3*s, 1 + 3*c, 1.4_dp, 3*s])
    b%u(:3) = a%u(:3)
    pass = bench_evaluate(b) == CTE_SUCCESS
  end function neighbour

  function transferred(argument) result(pass)
    integer(i4), intent(inout) :: argument
    logical :: pass
    pass = cte_history_transfer(a%element, a%out%output, a%out%history_trial, b%element, b%out%output, b%out%history_trial, &
      argument) == CTE_SUCCESS
  end function transferred

  ! s = sum_i b_i (projection - anchor)^i, from output and history.
  function slip_of(any_bench) result(s)
    type(bench), intent(in) :: any_bench
    real(dp) :: s(3), tangents(6), moved(2)
    tangents = any_bench%out%output(CTE_OUTPUT_TANGENTS + 1:CTE_OUTPUT_TANGENTS + 6)
    moved = any_bench%out%history_trial(2:3) - any_bench%out%history_trial(4:5)
    s = tangents(:3)*moved(1) + tangents(4:)*moved(2)
  end function slip_of

  ! On the common edge both facets hold the point: the force before is the force after.
  subroutine on_the_edge()
    integer(i4) :: argument
    logical :: pass
    argument = -1
    pass = slid(0.15_dp, 0.05_dp)
    pass = neighbour(0.0_dp) .and. pass
    pass = transferred(argument) .and. pass
    call client_check(pass .and. argument == CTE_ARGUMENT_NONE .and. nint(b%out%history_trial(1)) == CTE_STATUS_SLIP &
      .and. client_same(b%out%history_trial(6:6), a%out%history_trial(6:6)), 'transfer: status and slip path go along')
    b%history_accepted(:history_size) = b%out%history_trial(:history_size)
    pass = bench_evaluate(b) == CTE_SUCCESS
    call client_check(pass .and. client_near(b%out%f(:3), a%out%f(:3), 1e-13_dp), &
      'transfer on the edge: the force does not jump')
  end subroutine on_the_edge

  ! The accepted point is on A, the step ends on B: the force is that of one large plane, mu |N| along the elastic
  ! slip before plus the slip of the step.
  subroutine across()
    real(dp) :: s(3), expected(3)
    integer(i4) :: argument
    logical :: pass
    pass = slid(0.12_dp, 0.05_dp)
    s = slip_of(a)
    pass = neighbour(0.0_dp) .and. pass
    pass = pass .and. b%a%status == CTE_STATUS_OUTSIDE
    pass = transferred(argument) .and. pass
    b%history_accepted(:history_size) = b%out%history_trial(:history_size)
    b%u(:2) = b%u(:2) + [0.2_dp, -0.1_dp]
    s(:2) = s(:2) - [0.2_dp, -0.1_dp] ! s is against the motion of the slave
    expected = -1.25_dp*s/norm2(s) - [0, 0, 5] ! mu |N| = 1.25, N = -5 along z
    pass = bench_evaluate(b) == CTE_SUCCESS .and. pass
    call client_check(pass .and. b%a%status == CTE_STATUS_SLIP .and. client_near(b%out%f(:3), expected, 1e-13_dp), &
      'transfer across the edge: as on one plane')
    call client_check(abs(b%out%history_trial(6) - a%out%history_trial(6) - (norm2(s) - 0.025_dp)) < 1e-13_dp, &
      'transfer across the edge: the path goes on')
  end subroutine across

  ! Turned about the y axis: the length is kept, the part along the edge too, and the rest stays in the facet.
  subroutine turned()
    real(dp), parameter :: angle(3) = [0.3_dp, -0.7_dp, 1.5_dp]
    real(dp) :: old(3), new(3), normal(3)
    integer(i4) :: argument
    logical :: pass
    integer :: i
    pass = .true.
    do i = 1, 3
      pass = slid(0.12_dp, 0.05_dp) .and. pass
      pass = neighbour(angle(i)) .and. pass
      pass = transferred(argument) .and. pass
      old = slip_of(a)
      new = slip_of(b)
      normal = b%out%output(CTE_OUTPUT_NORMAL + 1:CTE_OUTPUT_NORMAL + 3)
      pass = pass .and. abs(norm2(new)/norm2(old) - 1) < 1e-13_dp .and. abs(new(2)/old(2) - 1) < 1e-13_dp &
        .and. abs(new(1)/old(1) - cos(angle(i))) < 1e-13_dp .and. abs(dot_product(new, normal)) < 1e-15_dp
    end do
    call client_check(pass, 'transfer to a turned facet: the slip turns along, |s| is kept')
  end subroutine turned

  ! A segment of the plane evaluated with an open history; normal upwards.
  function segment(any_bench, ends, orientation) result(pass)
    type(bench), intent(inout), target :: any_bench
    real(dp), intent(in) :: ends(4), orientation
    logical :: pass
    integer(i4) :: element_index
    element_index = -1
    pass = cte_element_find('PointLine2Coulomb2d', 19, element_index) == CTE_SUCCESS
    if (pass) pass = bench_index(any_bench, element_index, 0_i4)
    if (.not. pass) return
    any_bench%x(:6) = [0.95_dp, -0.02_dp, ends]
    call bench_set(any_bench, 'eps_t', eps_t)
    call bench_set(any_bench, 'orientation', orientation)
    pass = bench_evaluate(any_bench) == CTE_SUCCESS
  end function segment

  ! In the plane: from a segment to the next one, turned up by 0.4, also one that runs backwards.
  subroutine in_the_plane()
    real(dp) :: next(4, 2), c, s, moved, b_1(2)
    integer(i4) :: argument
    logical :: pass
    integer :: i
    c = cos(0.4_dp)
    s = sin(0.4_dp)
    next = reshape([1.0_dp, 0.0_dp, 1 + c, s, 1 + c, s, 1.0_dp, 0.0_dp], [4, 2])
    pass = segment(line, [-1.0_dp, 0.0_dp, 1.0_dp, 0.0_dp], 1.0_dp)
    line%history_accepted(:4) = line%out%history_trial(:4)
    line%u(1) = 0.004_dp
    pass = bench_evaluate(line) == CTE_SUCCESS .and. pass
    pass = pass .and. line%a%status == CTE_STATUS_STICK
    do i = 1, 2
      pass = segment(b, next(:, i), merge(1.0_dp, -1.0_dp, i == 1)) .and. pass
      b%u(1) = 0.004_dp
      pass = bench_evaluate(b) == CTE_SUCCESS .and. pass
      pass = cte_history_transfer(line%element, line%out%output, line%out%history_trial, b%element, b%out%output, &
        b%out%history_trial, argument) == CTE_SUCCESS .and. pass
      moved = b%out%history_trial(2) - b%out%history_trial(3)
      b_1 = b%out%output(CTE_OUTPUT_TANGENTS + 1:CTE_OUTPUT_TANGENTS + 2)
      pass = pass .and. all(abs(b_1*moved + 0.004_dp*[c, s]) < 1e-15_dp)
    end do
    call client_check(pass, 'transfer in the plane, also to a segment that runs backwards')
  end subroutine in_the_plane

  ! Through the table and through the Fortran 77 entry; and nothing to carry.
  subroutine entries()
    real(dp) :: fresh(history_size), expected(history_size)
    integer(i4) :: element_index, argument, code
    type(cte_api_table) :: api
    procedure(cte_history_transfer), pointer :: history_transfer
    logical :: pass
    pass = cte_element_find('PointQuad4Coulomb', 17, element_index) == CTE_SUCCESS
    pass = cte_api(CTE_VERSION_MAJOR, api) == CTE_SUCCESS .and. pass
    pass = slid(0.12_dp, 0.05_dp) .and. pass
    pass = neighbour(0.3_dp) .and. pass
    fresh = b%out%history_trial(:history_size)
    pass = transferred(argument) .and. pass
    expected = b%out%history_trial(:history_size)
    b%out%history_trial(:history_size) = fresh
    call c_f_procpointer(api%history_transfer, history_transfer)
    pass = history_transfer(a%element, a%out%output, a%out%history_trial, b%element, b%out%output, b%out%history_trial, &
      argument) == CTE_SUCCESS .and. pass
    call client_check(pass .and. client_same(b%out%history_trial(:history_size), expected), 'table: history_transfer')
    b%out%history_trial(:history_size) = fresh
    code = -1
    argument = -1
    call cte_f77_history_transfer(element_index, a%out%output, a%out%history_trial, element_index, b%out%output, &
      b%out%history_trial, argument, code)
    call client_check(code == CTE_SUCCESS .and. argument == CTE_ARGUMENT_NONE &
      .and. client_same(b%out%history_trial(:history_size), expected), 'F77 history_transfer')
    b%out%history_trial(:history_size) = fresh
    a%out%history_trial(1) = CTE_STATUS_OPEN
    pass = transferred(argument)
    call client_check(pass .and. client_same(b%out%history_trial(:history_size), fresh), &
      'transfer of an open point: nothing to carry')
  end subroutine entries

  subroutine interface_transfer_run()
    call on_the_edge()
    call across()
    call turned()
    call in_the_plane()
    call entries()
  end subroutine interface_transfer_run

end module interface_transfer
