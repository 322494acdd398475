! interface_edges.f90 - edges of solids: the history keeps the side on which they were.
!
! The slave runs along y at height z, the master along x at height 0.
module interface_edges
  use, intrinsic :: iso_c_binding, only: c_null_ptr
  use contact_elements
  use client_support
  implicit none
  private
  public :: interface_edges_run

  integer, parameter :: n = 12, history_size = 6
  real(dp), parameter :: eps_n = 1000.0_dp ! [force/length]
  type(bench), save, target :: a, b ! an edge, and the next one of its chain

contains

  ! The slave at (0.9, 0, z) against the master from x to x + 2, nothing remembered.
  subroutine edges(any_bench, x, z)
    type(bench), intent(inout), target :: any_bench
    real(dp), intent(in) :: x, z
    integer(i4) :: element_index, code
    logical :: pass
    element_index = -1
    pass = cte_element_find('Line2Line2Edges', 15, element_index) == CTE_SUCCESS
    if (pass) pass = bench_index(any_bench, element_index, 0_i4)
    if (.not. pass) then
      call client_check(.false., 'Line2Line2Edges')
      return
    end if
    any_bench%x(:n) = [0.9_dp, -1.0_dp, z, 0.9_dp, 1.0_dp, z, x, 0.0_dp, 0.0_dp, x + 2, 0.0_dp, 0.0_dp]
    any_bench%u(:n) = 0
    call bench_set(any_bench, 'eps_n', eps_n)
    call bench_set(any_bench, 'r0', 0.0_dp)
    call bench_set(any_bench, 'orientation', 0.0_dp)
    code = cte_element_history_init(any_bench%element, any_bench%history_accepted)
  end subroutine edges

  ! Lifts the slave, evaluates, accepts.
  function lifted(any_bench, z) result(pass)
    type(bench), intent(inout), target :: any_bench
    real(dp), intent(in) :: z
    logical :: pass
    any_bench%u([3, 6]) = z
    pass = bench_evaluate(any_bench) == CTE_SUCCESS
    if (pass) any_bench%history_accepted(:history_size) = any_bench%out%history_trial(:history_size)
  end function lifted

  subroutine crossing()
    real(dp) :: side
    logical :: pass
    integer :: from
    do from = 0, 1
      side = merge(1.0_dp, -1.0_dp, from == 0)
      call edges(a, -1.0_dp, 0.125_dp*side)
      pass = lifted(a, 0.0_dp)
      pass = pass .and. a%info%history == history_size .and. a%a%status == CTE_STATUS_OPEN &
        .and. client_same(a%history_accepted(6:6), [side])
      call client_check(pass, client_text('edges apart, side', int(from, i8)))
      pass = lifted(a, -0.1875_dp*side)
      pass = pass .and. a%a%status == CTE_STATUS_CLOSED .and. client_same(a%out%output(2:2), [-0.0625_dp]) &
        .and. client_same([a%out%f(3) + a%out%f(6)], [-eps_n*0.0625_dp*side]) .and. client_same(a%history_accepted(6:6), [side])
      call client_check(pass, client_text('edges crossed, side', int(from, i8)))
    end do
  end subroutine crossing

  ! The crossing continues on the next segment of the chain.
  subroutine chain()
    integer(i4) :: argument
    logical :: pass
    argument = -1
    call edges(a, -1.0_dp, 0.125_dp)
    call edges(b, 1.0_dp, 0.125_dp)
    pass = lifted(a, 0.0_dp)
    pass = lifted(a, -0.1875_dp) .and. pass
    b%u([3, 6]) = -0.1875_dp
    pass = bench_evaluate(b) == CTE_SUCCESS .and. pass
    pass = pass .and. b%a%status == CTE_STATUS_OUTSIDE
    pass = cte_history_transfer(a%element, a%out%output, a%out%history_trial, b%element, b%out%output, b%out%history_trial, &
      argument) == CTE_SUCCESS .and. pass
    b%history_accepted(:history_size) = b%out%history_trial(:history_size)
    b%u([1, 4]) = 0.5_dp
    pass = bench_evaluate(b) == CTE_SUCCESS .and. pass
    pass = pass .and. argument == CTE_ARGUMENT_NONE .and. b%a%status == CTE_STATUS_CLOSED &
      .and. client_same(b%out%output(2:2), [-0.0625_dp])
    call client_check(pass, 'edges: the side goes along a chain')
  end subroutine chain

  subroutine refused()
    logical :: pass
    call edges(a, -1.0_dp, 0.125_dp)
    a%a%history_accepted = c_null_ptr
    call bench_canary(a)
    pass = bench_evaluate(a) == CTE_ERROR_NULL
    pass = pass .and. a%a%error_argument == CTE_ARGUMENT_HISTORY_ACCEPTED .and. bench_untouched(a)
    call client_check(pass, 'edges without orientation and history')
    call bench_set(a, 'orientation', 1.0_dp)
    pass = bench_evaluate(a) == CTE_SUCCESS
    call client_check(pass, 'edges with orientation, without history')
    call edges(a, -1.0_dp, 0.125_dp)
    a%history_accepted(4) = 0.5_dp
    call bench_canary(a)
    pass = bench_evaluate(a) == CTE_ERROR_HISTORY
    pass = pass .and. a%a%error_argument == CTE_ARGUMENT_HISTORY_ACCEPTED .and. a%a%error_index == 3 .and. bench_untouched(a)
    call client_check(pass, 'edges with a normal that is none')
    call edges(a, -1.0_dp, 0.125_dp)
    a%history_accepted(4) = 1
    call bench_canary(a)
    pass = bench_evaluate(a) == CTE_CUT_BACK
    pass = pass .and. a%a%status == CTE_STATUS_NOT_UNIQUE .and. bench_untouched(a)
    call client_check(pass, 'edges that turned by a right angle')
  end subroutine refused

  subroutine interface_edges_run()
    call crossing()
    call chain()
    call refused()
  end subroutine interface_edges_run

end module interface_edges
