! interface_walk.f90 - every element of the library: description, unknowns, parameters, lookup, evaluation.
module interface_walk
  use, intrinsic :: iso_c_binding, only: c_associated, c_loc, c_ptr
  use contact_elements
  use client_support
  implicit none
  private
  public :: interface_walk_run

  integer, parameter :: nslave = 3, states = 6
  integer(i4), parameter :: all_requests = CTE_RESIDUAL + CTE_TANGENT + CTE_HISTORY + CTE_OUTPUT + CTE_ENERGY &
    + CTE_FREEZE_STATE + CTE_SYMMETRISE + CTE_PROJECTION_GIVEN + CTE_SCREEN + CTE_CSR_BY_BLOCKS
  type(bench), save, target :: b, alone

contains

  ! Anchor and slip path: with friction, whose tangent has no symmetry.
  pure function has_slip(info) result(slip)
    type(cte_info), intent(in) :: info
    logical :: slip
    slip = info%history/info%points >= 2 + 2*info%projected .and. info%projected > 0 .and. info%symmetric == 0
  end function has_slip

  ! Entries per point without a multiplier: status and projection; with friction anchor and slip path too.
  pure function plain_history(info) result(entries)
    type(cte_info), intent(in) :: info
    integer :: entries
    entries = 1 + info%projected + merge(info%projected + 1_i4, 0_i4, has_slip(info))
  end function plain_history

  ! Edges of solids keep a normal.
  function keeps_side(any_bench) result(keeps)
    type(bench), intent(in) :: any_bench
    logical :: keeps
    keeps = client_contains(cte_string(any_bench%info%name), 'Edges')
  end function keeps_side

  ! Entries per point, with five more for rolling of two curves, three more of edges, a multiplier where there is none
  ! among the unknowns. Else 0.
  function history_of_point(any_bench) result(entries)
    type(bench), intent(in) :: any_bench
    integer :: entries, plain
    entries = any_bench%info%history/any_bench%info%points
    plain = plain_history(any_bench%info)
    if (keeps_side(any_bench)) plain = plain + 3
    if (entries == plain) return
    if (has_slip(any_bench%info) .and. any_bench%info%projected == 2 .and. entries >= plain + 5) &
      plain = plain + 5 ! rolling of two curves
    if (entries == plain) return
    if (entries /= plain + 1 .or. bench_multipliers(any_bench) /= 0) entries = 0
  end function history_of_point

  ! The numbers of the description agree with each other.
  function description_sound(any_bench) result(pass)
    type(bench), intent(in) :: any_bench
    type(cte_info) :: info
    logical :: pass, interpolated
    integer :: positions, multipliers
    info = any_bench%info
    interpolated = info%slave_nodes == 0
    multipliers = bench_multipliers(any_bench)
    positions = merge(nslave, int(info%slave_nodes), interpolated) + info%master_nodes
    pass = any(info%dimension == [2, 3]) .and. info%unknowns == positions*info%dimension + multipliers &
      .and. any(multipliers == [0, int(info%points)])
    pass = pass .and. info%nodes_maximum == merge(0_i4, info%nodes_minimum, interpolated) &
      .and. info%points >= 1 .and. info%projected >= 0 .and. info%projected <= 2 &
      .and. mod(info%history, info%points) == 0 .and. history_of_point(any_bench) > 0
    pass = pass .and. iand(info%requests, CTE_RESIDUAL) /= 0 .and. iand(info%requests, not(all_requests)) == 0 &
      .and. any(info%symmetric == [0, 1]) .and. info%operations > 0 .and. info%workspace >= 0
    pass = pass .and. info%formulation /= 0 .and. len(cte_string(info%name)) > 0 &
      .and. c_associated(info%documentation)
  end function description_sound

  ! A displacement or a change of a tangent vector that the dimension knows; a multiplier where one is expected.
  function kind_sound(kind, is_multiplier) result(pass)
    integer(i4), intent(in) :: kind
    logical, intent(in) :: is_multiplier
    logical :: pass
    pass = kind >= CTE_UNKNOWN_UX .and. kind <= CTE_UNKNOWN_TZ &
      .and. (b%info%dimension == 3 .or. all(kind /= [CTE_UNKNOWN_UZ, CTE_UNKNOWN_TZ]))
    if (is_multiplier) pass = kind == CTE_UNKNOWN_MULTIPLIER
  end function kind_sound

  ! Every unknown has its place and its kind; multipliers come last, one per node, in order.
  function unknowns_sound() result(pass)
    logical :: pass
    integer(i4) :: node, kind, i
    logical :: seen(0:room_nodes - 1, CTE_UNKNOWN_UX:CTE_UNKNOWN_MULTIPLIER)
    seen = .false.
    do i = 0, b%info%unknowns - 1
      pass = cte_element_unknown(b%element, b%a%nnode, i, node, kind) == CTE_SUCCESS
      pass = pass .and. node == (bench_position(b, i + 1) - 1)/b%info%dimension .and. node < room_nodes &
        .and. kind_sound(kind, bench_is_multiplier(b, i + 1))
      if (pass) pass = .not. seen(node, kind)
      if (.not. pass) return
      seen(node, kind) = .true.
    end do
    pass = cte_element_unknown(b%element, b%a%nnode, b%info%unknowns, node, kind) == CTE_ERROR_INDEX
  end function unknowns_sound

  ! Names, units and ranges; the plain values of the bench lie inside them.
  function parameters_sound() result(pass)
    logical :: pass
    type(c_ptr) :: name, unit
    real(dp) :: lower, upper
    integer(i4) :: i, closed, bad
    do i = 0, b%info%parameters - 1
      lower = 1
      upper = 0
      closed = -1
      pass = cte_element_parameter(b%element, i, name, unit, lower, upper, closed) == CTE_SUCCESS
      if (pass) pass = len(cte_string(name)) > 0 .and. len(cte_string(unit)) > 0 .and. lower < upper &
        .and. iand(closed, not(3_i4)) == 0
      if (pass) pass = bench_parameter(b, cte_string(name)) == i
      if (.not. pass) return
    end do
    pass = cte_element_check_parameters(b%element, b%parameters, b%info%parameters, bad) == CTE_SUCCESS
  end function parameters_sound

  ! By name, with blanks behind it, cut by its length.
  function lookup_sound(element_index) result(pass)
    integer(i4), intent(in) :: element_index
    logical :: pass
    character(len=200) :: padded
    integer(i4) :: found
    padded = cte_string(b%info%name)
    found = -1
    pass = cte_element_find(padded, len(padded), found) == CTE_SUCCESS
    pass = pass .and. found == element_index
    found = -1
    if (pass) pass = cte_element_find(padded, len_trim(padded), found) == CTE_SUCCESS
    pass = pass .and. found == element_index
    if (pass) pass = c_associated(cte_element_get(element_index), b%element)
  end function lookup_sound

  ! Initial history: open, projection and anchor at the centre, no slip, no multiplier.
  function history_sound() result(pass)
    logical :: pass
    integer :: entries, plain, p, first, point
    entries = history_of_point(b)
    plain = plain_history(b%info)
    p = b%info%projected
    pass = .true.
    do point = 0, b%info%points - 1
      first = point*entries + 1
      pass = pass .and. nint(b%history_accepted(first + CTE_HISTORY_STATUS)) == CTE_STATUS_OPEN
      if (entries > plain) pass = pass .and. abs(b%history_accepted(first + plain)) <= 0
      first = first + CTE_HISTORY_PROJECTION
      if (has_slip(b%info)) pass = pass .and. abs(b%history_accepted(first + 2*p)) <= 0 &
        .and. client_same(b%history_accepted(first:first + p - 1), b%history_accepted(first + p:first + 2*p - 1))
    end do
  end function history_sound

  ! Outputs full of signalling NaN: they are written, never read.
  subroutine poison(any_bench)
    type(bench), intent(inout) :: any_bench
    integer :: i
    call client_special(2, any_bench%out%energy(1))
    do i = 1, size(any_bench%out%f)
      call client_special(2, any_bench%out%f(i))
    end do
    do i = 1, size(any_bench%out%k)
      call client_special(2, any_bench%out%k(i))
    end do
    do i = 1, size(any_bench%out%history_trial)
      call client_special(2, any_bench%out%history_trial(i))
    end do
    do i = 1, size(any_bench%out%output)
      call client_special(2, any_bench%out%output(i))
    end do
  end subroutine poison

  ! The same state with one request bit; the struct with the outputs is the copy's own.
  function evaluate_alone(request) result(code)
    integer(i4), intent(in) :: request
    integer(i4) :: code
    alone%element = b%element
    alone%info = b%info
    alone%a = b%a
    alone%a%request = request
    alone%a%f = c_loc(alone%out%f)
    alone%a%k = c_loc(alone%out%k)
    call poison(alone)
    code = bench_evaluate(alone)
  end function evaluate_alone

  ! Random nodes, random multipliers, most of which press.
  subroutine randomise()
    real(dp) :: value
    integer :: i
    do i = 1, b%info%unknowns
      call client_random(value)
      if (bench_is_multiplier(b, i)) then
        b%u(bench_position(b, i)) = 0.25_dp - value
      else
        b%x(i) = value
      end if
    end do
  end subroutine randomise

  ! Residual alone: the bits of the joint call. Tangent alone: the same to rounding.
  function evaluation_sound() result(pass)
    logical :: pass
    integer(i4) :: code
    integer :: state, n
    n = b%info%unknowns
    do state = 1, states
      call randomise()
      call poison(b)
      code = bench_evaluate(b)
      pass = any(code == [CTE_SUCCESS, CTE_CUT_BACK])
      if (pass) pass = evaluate_alone(CTE_RESIDUAL) == code
      pass = pass .and. alone%a%status == b%a%status
      if (pass .and. code == CTE_SUCCESS) pass = client_same(alone%out%f(:n), b%out%f(:n))
      if (.not. pass) return
      if (iand(b%info%requests, CTE_TANGENT) == 0) cycle
      pass = evaluate_alone(CTE_TANGENT) == code
      if (pass .and. code == CTE_SUCCESS) pass = client_near(alone%out%k(:n*n), b%out%k(:n*n), 1e-13_dp)
      if (.not. pass) return
    end do
  end function evaluation_sound

  ! An all-zero history begins as the initial one does.
  function zeros_sound() result(pass)
    logical :: pass
    integer(i4) :: code
    integer :: state, n
    n = b%info%unknowns
    pass = .true.
    do state = 1, states
      call randomise()
      call poison(b)
      code = bench_evaluate(b)
      alone = b
      alone%history_accepted = 0
      alone%a%history_accepted = c_loc(alone%history_accepted)
      alone%a%request = CTE_RESIDUAL
      alone%a%f = c_loc(alone%out%f)
      call poison(alone)
      pass = bench_evaluate(alone) == code .and. pass
      pass = pass .and. alone%a%status == b%a%status
      if (pass .and. code == CTE_SUCCESS) pass = client_same(alone%out%f(:n), b%out%f(:n))
      if (.not. pass) return
    end do
  end function zeros_sound

  ! Bits that the element does not offer are refused.
  function refusal_sound() result(pass)
    logical :: pass
    integer(i4) :: wanted
    integer :: bit
    pass = .true.
    wanted = b%a%request
    do bit = 0, 9
      if (btest(b%info%requests, bit)) cycle
      b%a%request = ibset(wanted, bit)
      pass = bench_evaluate(b) == CTE_ERROR_REQUEST .and. pass
      pass = pass .and. b%a%error_argument == CTE_ARGUMENT_REQUEST
    end do
  end function refusal_sound

  subroutine check(pass, what)
    logical, intent(in) :: pass
    character(len=*), intent(in) :: what
    call client_check(pass, cte_string(b%info%name)//': '//what)
  end subroutine check

  subroutine interface_walk_run()
    integer(i4) :: i, count
    count = cte_element_count()
    call client_check(count > 0, 'there are elements')
    do i = 0, count - 1
      if (.not. bench_index(b, i, nslave)) then
        call client_check(.false., client_text('layout of element', int(i, i8)))
        cycle
      end if
      call check(description_sound(b), 'description')
      call check(unknowns_sound(), 'unknowns')
      call check(parameters_sound(), 'parameters')
      call check(lookup_sound(i), 'lookup by name')
      call check(history_sound(), 'initial history')
      call check(evaluation_sound(), 'residual alone, tangent alone, both')
      call check(zeros_sound(), 'history of zeros')
      call check(refusal_sound(), 'bits not offered')
    end do
  end subroutine interface_walk_run

end module interface_walk
