! client_support.f90 - one contact on a bench: what bad_input.f90 and interface.f90 share.
!
! A bench holds an element, its arguments and every array they point to, in a state that evaluates without
! complaint; a test changes one thing. client_support.c is the twin.
module client_support
  use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_int32_t, c_int64_t, c_loc, &
    c_null_char, c_null_ptr, c_ptr
  use, intrinsic :: iso_fortran_env, only: output_unit
  use contact_elements
  implicit none
  private
  public :: bench, bench_outputs, bench_index, bench_open, bench_parameter, bench_set, bench_canary
  public :: bench_multipliers, bench_position, bench_is_multiplier
  public :: bench_untouched, bench_evaluate, client_check, client_text, client_random, client_special
  public :: client_same, client_near, client_contains, client_message, canary, dp, i4, i8

  integer, parameter :: dp = c_double, i4 = c_int32_t, i8 = c_int64_t
  integer, parameter, public :: room_nodes = 64, room_unknowns = 3*room_nodes, room_parameters = 64
  integer, parameter, public :: room_points = 64, room_workspace = 2**18
  integer, parameter, public :: room_history = 8*room_points ! with friction and a multiplier 3 + 2*2 per point

  ! Failures so far, of all checks.
  integer, public :: client_failures = 0

  ! The pattern in outputs before a call, compared bit for bit.
  integer(i8), parameter :: pattern = int(z'5a5a5a5a5a5a5a5a', i8)

  ! Values made without arithmetic.
  integer, parameter, public :: client_specials = 5
  character(len=14), parameter, public :: client_special_name(client_specials) = [character(len=14) :: &
    'NaN', 'signalling NaN', '+infinity', '-infinity', '1e300']

  ! The arrays an evaluation writes.
  type :: bench_outputs
    real(dp) :: f(room_unknowns)
    real(dp) :: k(room_unknowns*room_unknowns)
    real(dp) :: history_trial(room_history)
    real(dp) :: output(room_points*CTE_OUTPUT_SIZE)
    real(dp) :: energy(1)
  end type bench_outputs

  type :: bench
    type(c_ptr) :: element
    type(cte_info) :: info
    type(cte_arguments) :: a
    real(dp) :: x(room_unknowns), u(room_unknowns)
    real(dp) :: parameters(room_parameters)
    real(dp) :: history_accepted(room_history)
    real(dp) :: row(room_nodes + 1) ! interpolated slaves: [1, 0, ...], weight 1
    type(bench_outputs) :: out
    real(dp) :: workspace(room_workspace)
  end type bench

contains

  ! Prints "PASS what" or "FAIL what" and counts.
  subroutine client_check(pass, what)
    logical, intent(in) :: pass
    character(len=*), intent(in) :: what
    print '(3a)', merge('PASS', 'FAIL', pass), ' ', what
    flush (output_unit) ! a trap must not swallow what came before
    if (.not. pass) client_failures = client_failures + 1
  end subroutine client_check

  ! Name and number in one text.
  function client_text(what, number) result(text)
    character(len=*), intent(in) :: what
    integer(i8), intent(in) :: number
    character(len=:), allocatable :: text
    character(len=24) :: digits
    write (digits, '(i0)') number
    text = what//' '//trim(digits)
  end function client_text

  ! Deterministic numbers in [0,1): the same sequence in C and Fortran.
  subroutine client_random(value)
    real(dp), intent(out) :: value
    integer(i8), save :: state = 1
    state = mod(state*1103515245_i8 + 12345_i8, 2147483648_i8)
    value = real(state, dp)/2147483648.0_dp
  end subroutine client_random

  ! A quiet NaN, a signalling NaN, +infinity, -infinity, 1e300: number 1..5.
  subroutine client_special(number, value)
    integer, intent(in) :: number
    real(dp), intent(inout) :: value
    integer(i8), parameter :: bits(client_specials) = [9221120237041090560_i8, 9219994337134247936_i8, &
      9218868437227405312_i8, -4503599627370496_i8, 9094988921128908188_i8]
    value = transfer(bits(number), value)
  end subroutine client_special

  ! Both arrays are equal bit for bit.
  pure function client_same(a, b) result(same)
    real(dp), intent(in) :: a(:), b(:)
    logical :: same
    same = all(transfer(a, [0_i8]) == transfer(b, [0_i8]))
  end function client_same

  ! Both arrays are equal to a tolerance relative to the largest entry of b.
  pure function client_near(a, b, tolerance) result(near)
    real(dp), intent(in) :: a(:), b(:), tolerance
    logical :: near
    near = maxval(abs(a - b)) <= tolerance*maxval(abs(b))
  end function client_near

  pure function client_contains(text, word) result(contained)
    character(len=*), intent(in) :: text, word
    logical :: contained
    contained = index(text, word) > 0
  end function client_contains

  ! cte_element_message as a Fortran string of at most 255 characters.
  function client_message(b, code) result(text)
    type(bench), intent(in) :: b
    integer(i4), intent(in) :: code
    character(len=:), allocatable :: text
    character(len=256) :: room
    integer(i4) :: length
    room = c_null_char
    length = cte_element_message(b%element, b%a, code, room, len(room))
    text = room(:max(0, scan(room, c_null_char) - 1))
    if (length < len(text)) text = ''
  end function client_message

  ! A value inside the parameter's range: 100 for the penalty, 1/4 for coefficients of friction, 1 for the first
  ! component of an axis and for the upper end of a window of angles, else the first of 0, 1, 1/2 that fits.
  pure function plain_value(name, lower, upper, closed) result(value)
    character(len=*), intent(in) :: name
    real(dp), intent(in) :: lower, upper
    integer(i4), intent(in) :: closed
    real(dp) :: value
    real(dp), parameter :: candidate(3) = [0.0_dp, 1.0_dp, 0.5_dp]
    logical :: above, below
    integer :: i
    value = 100 ! [force/length]
    if (name == 'eps_n') return
    value = 0.25_dp
    if (index(name, 'mu') == 1) return
    value = 1
    if (name == 'axis_1' .or. name == 'angle_high') return
    do i = 1, 3
      value = candidate(i)
      above = value > lower .or. (btest(closed, 0) .and. value >= lower)
      below = value < upper .or. (btest(closed, 1) .and. value <= upper)
      if (above .and. below) return
    end do
    value = lower + (upper - lower)/2
  end function plain_value

  function plain_parameters(b) result(pass)
    type(bench), intent(inout) :: b
    logical :: pass
    type(c_ptr) :: name, unit
    real(dp) :: lower, upper
    integer(i4) :: i, closed
    pass = .true.
    do i = 0, b%info%parameters - 1
      pass = cte_element_parameter(b%element, i, name, unit, lower, upper, closed) == CTE_SUCCESS
      if (.not. pass) return
      b%parameters(i + 1) = plain_value(cte_string(name), lower, upper, closed)
    end do
  end function plain_parameters

  subroutine fill_arguments(b, nslave)
    type(bench), intent(inout), target :: b
    integer(i4), intent(in) :: nslave
    b%a%request = iand(b%info%requests, CTE_RESIDUAL + CTE_TANGENT + CTE_HISTORY + CTE_OUTPUT + CTE_ENERGY)
    b%a%nslave = nslave
    b%a%nnode = merge(nslave + b%info%nodes_minimum - 1, 0_i4, nslave > 0)
    b%a%x = c_loc(b%x)
    b%a%u = c_loc(b%u)
    b%a%parameters = c_loc(b%parameters)
    b%a%parameter_count = b%info%parameters
    b%a%history_accepted = c_loc(b%history_accepted)
    b%a%history_trial = c_loc(b%out%history_trial)
    if (nslave > 0) b%a%slave_row = c_loc(b%row)
    b%a%f = c_loc(b%out%f)
    b%a%k = c_loc(b%out%k)
    b%a%output = c_loc(b%out%output)
    b%a%energy = c_loc(b%out%energy)
    b%a%workspace = c_loc(b%workspace)
    b%a%workspace_size = b%info%workspace
  end subroutine fill_arguments

  subroutine clear(b)
    type(bench), intent(inout) :: b
    type(cte_info) :: fresh_info
    type(cte_arguments) :: fresh_arguments
    b%element = c_null_ptr
    b%info = fresh_info
    b%a = fresh_arguments
    b%x = 0
    b%u = 0
    b%parameters = 0
    b%history_accepted = 0
    b%row = 0
    b%workspace = 0
  end subroutine clear

  ! Lays out element number element_index with a plain state: parameters inside their ranges, no
  ! displacement, all coordinates zero, everything requested that is offered. False when the element cannot
  ! be laid out.
  function bench_index(b, element_index, wanted_nslave) result(pass)
    type(bench), intent(inout), target :: b
    integer(i4), intent(in) :: element_index, wanted_nslave
    logical :: pass
    integer(i4) :: nslave
    call clear(b)
    b%element = cte_element_get(element_index)
    pass = c_associated(b%element)
    if (pass) pass = cte_element_info(b%element, 0, b%info) == CTE_SUCCESS
    if (.not. pass) return
    nslave = merge(wanted_nslave, 0_i4, b%info%slave_nodes == 0)
    if (nslave > 0) pass = cte_element_info(b%element, nslave + b%info%nodes_minimum - 1, b%info) == CTE_SUCCESS
    if (.not. pass) return
    pass = b%info%unknowns <= room_unknowns .and. b%info%parameters <= room_parameters &
      .and. b%info%history <= room_history .and. b%info%points <= room_points &
      .and. b%info%workspace <= room_workspace
    if (pass) pass = plain_parameters(b)
    if (pass) pass = cte_element_history_init(b%element, b%history_accepted) == CTE_SUCCESS
    b%row(1) = 1
    b%row(nslave + 1) = 1
    call fill_arguments(b, nslave)
  end function bench_index

  ! Nodes of multipliers, behind all others.
  pure function bench_multipliers(b) result(multipliers)
    type(bench), intent(in) :: b
    integer :: multipliers
    multipliers = b%info%nodes_minimum - max(1_i4, b%info%slave_nodes) - b%info%master_nodes
  end function bench_multipliers

  ! Unknown number `unknown` from 1 is a multiplier.
  pure function bench_is_multiplier(b, unknown) result(is_multiplier)
    type(bench), intent(in) :: b
    integer, intent(in) :: unknown
    logical :: is_multiplier
    is_multiplier = unknown > b%info%unknowns - bench_multipliers(b)
  end function bench_is_multiplier

  ! Position from 1 of an unknown from 1 in x and u, which have room for every component of every node.
  pure function bench_position(b, unknown) result(position)
    type(bench), intent(in) :: b
    integer, intent(in) :: unknown
    integer :: position, first
    first = b%info%unknowns - bench_multipliers(b) + 1
    position = unknown
    if (bench_is_multiplier(b, unknown)) position = first + (unknown - first)*b%info%dimension
  end function bench_position

  ! Index from 0 of a named parameter, -1 if it does not exist.
  function bench_parameter(b, name) result(found)
    type(bench), intent(in) :: b
    character(len=*), intent(in) :: name
    integer(i4) :: found
    type(c_ptr) :: text, unit
    real(dp) :: lower, upper
    integer(i4) :: closed
    do found = 0, b%info%parameters - 1
      if (cte_element_parameter(b%element, found, text, unit, lower, upper, closed) /= CTE_SUCCESS) cycle
      if (cte_string(text) == name) return
    end do
    found = -1
  end function bench_parameter

  subroutine bench_set(b, name, value)
    type(bench), intent(inout) :: b
    character(len=*), intent(in) :: name
    real(dp), intent(in) :: value
    integer(i4) :: i
    i = bench_parameter(b, name)
    if (i >= 0) b%parameters(i + 1) = value
    if (i < 0) call client_check(.false., name)
  end subroutine bench_set

  ! Closed by about 0.1 [length]; slave first.
  subroutine place(b, name)
    type(bench), intent(inout) :: b
    character(len=*), intent(in) :: name
    if (client_contains(name, 'Quad4')) then
      b%x(:15) = [real(dp) :: 0.55_dp, 0.4_dp, 0.9_dp, 0, 0, 1, 1, 0, 1.02_dp, 1, 1, 0.99_dp, 0, 1, 1.03_dp]
    else if (client_contains(name, 'Line2')) then
      b%x(:9) = [real(dp) :: 0.5_dp, 0.1_dp, 0, 0, 0, 0, 1, 0, 0]
    else if (client_contains(name, 'Cylinder')) then
      b%x(:3) = [real(dp) :: 0.9_dp, 0, 0.3_dp]
    else
      b%x(:6) = [real(dp) :: 0.1_dp, 0, 0, 0, 0, 0]
    end if
    if (client_contains(name, 'Cylinder')) then
      call bench_set(b, 'radius', 1.0_dp)
    else if (.not. client_contains(name, 'Quad4')) then
      call bench_set(b, 'r0', 0.2_dp) ! sum of the radii [length]
    end if
  end subroutine place

  ! The same by name for the elements with a known closed state: PointQuad4, InterpolatedQuad4, PointLine2,
  ! PointPoint, PointCylinder, PointCylinderDistance, with friction on Quad4, Line2, Cylinder, with multipliers
  ! (zero) on Quad4. Failure is counted.
  subroutine bench_open(b, name)
    type(bench), intent(inout), target :: b
    character(len=*), intent(in) :: name
    integer(i4) :: element_index
    logical :: pass
    element_index = -1
    pass = cte_element_find(name, len(name), element_index) == CTE_SUCCESS
    if (pass) pass = bench_index(b, element_index, 1)
    if (pass) pass = b%info%dimension == 3
    if (pass) call place(b, name)
    if (.not. pass) call client_check(.false., name)
  end subroutine bench_open

  pure function canary() result(value)
    real(dp) :: value
    value = transfer(pattern, value)
  end function canary

  ! Fills the outputs with the pattern; tells whether every bit of it is still there.
  subroutine bench_canary(b)
    type(bench), intent(inout) :: b
    b%out%f = canary()
    b%out%k = canary()
    b%out%history_trial = canary()
    b%out%output = canary()
    b%out%energy = canary()
  end subroutine bench_canary

  function bench_untouched(b) result(untouched)
    type(bench), intent(in) :: b
    logical :: untouched
    untouched = all(transfer(b%out%f, [pattern]) == pattern) .and. all(transfer(b%out%k, [pattern]) == pattern) &
      .and. all(transfer(b%out%history_trial, [pattern]) == pattern) &
      .and. all(transfer(b%out%output, [pattern]) == pattern) &
      .and. all(transfer(b%out%energy, [pattern]) == pattern)
  end function bench_untouched

  function bench_evaluate(b) result(code)
    type(bench), intent(inout), target :: b
    integer(i4) :: code
    code = cte_element_evaluate(b%element, b%a)
  end function bench_evaluate

end module client_support
