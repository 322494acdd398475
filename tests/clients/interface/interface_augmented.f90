! interface_augmented.f90 - multipliers of the history: Uzawa's iteration with known answers, entries, transfer.
!
! A point over the fixed square [-1,1]^2, held by a spring k in every direction and pressed by a load. In equilibrium
! the contact force is known: the spring does not move. A step of the iteration leaves k/(k + eps) of what is missing.
module interface_augmented
  use, intrinsic :: iso_c_binding, only: c_f_procpointer
  use contact_elements
  use client_support
  implicit none
  private
  public :: interface_augmented_run

  integer, parameter :: n = 15, steps = 40
  integer, parameter :: history_size = 7, path_at = 6, multiplier_at = 7, plain_size = 4, plain_multiplier = 4 ! from 1
  real(dp), parameter :: eps_n = 100.0_dp, eps_t = 30.0_dp, spring = 50.0_dp ! [force/length]
  character(len=*), parameter :: plain = 'PointQuad4Augmented', frictional = 'PointQuad4CoulombAugmented'
  type(bench), save, target :: a, b

contains

  ! An open history; the slave at a height over the square.
  subroutine opened(any_bench, name, height)
    type(bench), intent(inout), target :: any_bench
    character(len=*), intent(in) :: name
    real(dp), intent(in) :: height
    call bench_open(any_bench, name)
    any_bench%x(:n) = [real(dp) :: 0.2_dp, -0.1_dp, height, -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]
    if (bench_parameter(any_bench, 'eps_t') >= 0) call bench_set(any_bench, 'eps_t', eps_t)
  end subroutine opened

  ! Equilibrium of the point: spring u + f = load; only the diagonal of K counts.
  function solved(any_bench, load) result(pass)
    type(bench), intent(inout), target :: any_bench
    real(dp), intent(in) :: load(3)
    logical :: pass
    real(dp) :: missing(3)
    integer :: iteration, i
    do iteration = 1, 4
      pass = bench_evaluate(any_bench) == CTE_SUCCESS
      if (.not. pass) return
      missing = load - spring*any_bench%u(:3) - any_bench%out%f(:3)
      do i = 1, 3
        any_bench%u(i) = any_bench%u(i) + missing(i)/(spring + any_bench%out%k(i + (i - 1)*n))
      end do
    end do
    pass = maxval(abs(missing)) < 1e-13_dp
  end function solved

  function augmented(any_bench) result(pass)
    type(bench), intent(inout) :: any_bench
    logical :: pass
    integer(i4) :: argument
    argument = -1
    pass = cte_history_augment(any_bench%element, any_bench%out%history_trial, any_bench%history_accepted, argument) == CTE_SUCCESS
    pass = pass .and. argument == CTE_ARGUMENT_NONE
  end function augmented

  subroutine accept(any_bench)
    type(bench), intent(inout) :: any_bench
    integer :: length
    length = any_bench%info%history
    any_bench%history_accepted(:length) = any_bench%out%history_trial(:length)
  end subroutine accept

  ! Evaluates to this status.
  function evaluated(any_bench, status) result(pass)
    type(bench), intent(inout), target :: any_bench
    integer(i4), intent(in) :: status
    logical :: pass
    pass = bench_evaluate(any_bench) == CTE_SUCCESS
    pass = pass .and. any_bench%a%status == status
  end function evaluated

  ! One evaluation: N = multiplier + eps_n g, the multiplier of history_accepted stays.
  subroutine one_evaluation()
    real(dp) :: traction
    logical :: pass
    call opened(b, plain, -0.05_dp)
    b%history_accepted(plain_multiplier) = -3
    pass = evaluated(b, CTE_STATUS_CLOSED)
    pass = pass .and. b%info%history == plain_size .and. b%info%symmetric == 1 .and. b%info%unknowns == n &
      .and. b%info%nodes_minimum == 5
    traction = b%out%output(CTE_OUTPUT_NORMAL_TRACTION + 1)
    call client_check(pass .and. abs(b%out%f(3) + 8) < 1e-14_dp .and. abs(traction + 8) < 1e-14_dp &
      .and. abs(b%out%k(3 + 2*n) - eps_n) < 1e-13_dp .and. abs(b%out%energy(1) - 64/(2*eps_n)) < 1e-15_dp, &
      'augmented: N = multiplier + eps_n g, energy = N^2/(2 eps_n)')
    call client_check(abs(b%out%history_trial(plain_multiplier) - traction) <= 0, 'augmented: the new multiplier is N')
    b%u(3) = 0.09_dp
    pass = evaluated(b, CTE_STATUS_OPEN)
    call client_check(pass .and. abs(b%out%f(3)) <= 0 .and. abs(b%out%history_trial(plain_multiplier)) <= 0, &
      'augmented, open: no force, no multiplier')
    b%history_accepted(1) = CTE_STATUS_CLOSED
    b%a%request = ior(b%a%request, CTE_FREEZE_STATE)
    pass = evaluated(b, CTE_STATUS_CLOSED)
    call client_check(pass .and. abs(b%out%f(3) - 1) < 1e-14_dp .and. abs(b%out%history_trial(plain_multiplier)) <= 0, &
      'augmented, CTE_FREEZE_STATE: closed with N > 0, which no multiplier keeps')
  end subroutine one_evaluation

  ! Height 0.1 of the spring, load -10: the spring takes 5, the contact -5.
  subroutine normal()
    real(dp), parameter :: load(3) = [0.0_dp, 0.0_dp, -10.0_dp], exact = -5.0_dp, rate = spring/(spring + eps_n)
    real(dp) :: before, multiplier(steps)
    logical :: pass, stays
    integer :: step
    call opened(b, plain, 0.1_dp)
    pass = .true.
    stays = .true.
    before = -exact
    do step = 1, steps
      pass = solved(b, load) .and. pass
      pass = augmented(b) .and. pass
      multiplier(step) = b%history_accepted(plain_multiplier)
      pass = pass .and. abs(multiplier(step) - exact - rate*before) < 1e-12_dp
      before = multiplier(step) - exact
      stays = stays .and. nint(b%history_accepted(1)) == CTE_STATUS_OPEN
    end do
    call client_check(pass, 'Uzawa: the multiplier''s error shrinks by k/(k + eps_n)')
    call client_check(abs(before) < 1e-13_dp .and. abs(b%out%output(CTE_OUTPUT_GAP + 1)) < 1e-14_dp, &
      'Uzawa: N is the load''s, no gap')
    call client_check(stays, 'Uzawa: the status of the start of the step stays')
    call opened(a, plain, 0.1_dp)
    pass = .true.
    do step = 1, steps
      pass = solved(a, load) .and. pass
      call accept(a)
      pass = pass .and. abs(a%history_accepted(plain_multiplier) - multiplier(step)) < 1e-12_dp
    end do
    call client_check(pass .and. nint(a%history_accepted(1)) == CTE_STATUS_CLOSED, &
      'Uzawa: accepting alone makes one iteration per step')
  end subroutine normal

  ! Iterates until the gap is gone.
  function held(any_bench, load) result(pass)
    type(bench), intent(inout), target :: any_bench
    real(dp), intent(in) :: load(3)
    logical :: pass
    integer :: step
    pass = .true.
    do step = 1, steps
      pass = solved(any_bench, load) .and. pass
      pass = augmented(any_bench) .and. pass
    end do
    pass = solved(any_bench, load) .and. pass
  end function held

  ! Pressed, accepted, then pulled by less than mu |N| = 1.25: the slip of the step vanishes under the load.
  subroutine tangential()
    real(dp), parameter :: pull(3) = [0.8_dp, -0.3_dp, -10.0_dp], rate = spring/(spring + eps_t)
    real(dp) :: before(2), accepted(history_size), force(2), t(2)
    logical :: pass, path
    integer :: step
    call opened(b, frictional, 0.1_dp)
    pass = held(b, [0.0_dp, 0.0_dp, -10.0_dp])
    call accept(b)
    accepted = b%history_accepted(:history_size)
    call client_check(pass .and. b%info%history == history_size .and. nint(accepted(1)) == CTE_STATUS_STICK &
      .and. abs(accepted(multiplier_at) + 5) < 1e-13_dp, 'Uzawa with friction: pressed, N is the load''s')
    path = .true.
    before = pull(:2)/(spring + eps_t)/rate
    do step = 1, steps
      pass = solved(b, pull) .and. pass
      pass = augmented(b) .and. pass
      pass = pass .and. b%a%status == CTE_STATUS_STICK .and. all(abs(b%u(:2) - rate*before) < 1e-12_dp)
      before = b%u(:2)
      path = path .and. abs(b%history_accepted(path_at)) <= 0 .and. abs(b%out%history_trial(path_at)) <= 0
    end do
    call client_check(pass, 'Uzawa with friction: the slip of the step shrinks by k/(k + eps_t)')
    call client_check(path .and. client_same(accepted(:3), b%history_accepted(:3)), &
      'Uzawa with friction: slip path, status and projection stay')
    force = b%out%f(:2)
    call client_check(client_near(force, pull(:2), 1e-7_dp) .and. sum(abs(b%u(:2))) < 1e-8_dp, &
      'Uzawa with friction: the traction is the load''s, no slip')
    t = b%out%output(CTE_OUTPUT_TANGENTIAL_TRACTION + 1:CTE_OUTPUT_TANGENTIAL_TRACTION + 2)
    call client_check(abs(dot_product(t, t) - 0.73_dp) < 1e-7_dp, 'Uzawa with friction: |T| is the load''s')
    call accept(b)
    pass = evaluated(b, CTE_STATUS_STICK)
    call client_check(pass .and. client_near(b%out%f(:2), force, 1e-12_dp), &
      'Uzawa with friction: accepted, the same traction')
  end subroutine tangential

  ! Pulled by more than the bound, held in place: the traction stays at mu |N|, the iteration adds nothing to it.
  subroutine sliding()
    real(dp) :: elastic
    logical :: pass
    call opened(b, frictional, -0.05_dp)
    pass = bench_evaluate(b) == CTE_SUCCESS
    call accept(b)
    b%history_accepted(multiplier_at) = -5
    b%u(:3) = [0.3_dp, 0.0_dp, 0.05_dp] ! no gap
    pass = evaluated(b, CTE_STATUS_SLIP) .and. pass
    pass = pass .and. abs(b%out%f(1) - 1.25_dp) < 1e-13_dp
    elastic = b%out%history_trial(2) - b%out%history_trial(4)
    pass = augmented(b) .and. pass
    pass = evaluated(b, CTE_STATUS_SLIP) .and. pass
    call client_check(pass .and. abs(b%out%f(1) - 1.25_dp) < 1e-13_dp, &
      'Uzawa with friction, sliding: the traction stays at its bound')
    call client_check(abs(b%out%history_trial(2) - b%out%history_trial(4) - elastic) < 1e-14_dp, &
      'Uzawa with friction, sliding: the elastic slip stays')
  end subroutine sliding

  ! Two histories of four points with negative numbers but for status and slip path, and the first after the second.
  subroutine histories(trial, fresh, expected)
    real(dp), intent(out) :: trial(history_size, 4), fresh(history_size, 4), expected(history_size, 4)
    integer :: entry, point
    do point = 1, 4
      do entry = 1, history_size
        call client_random(trial(entry, point))
      end do
    end do
    trial = 0.1_dp*(trial - 1)
    fresh = 2*trial
    trial(path_at, :) = -trial(path_at, :)
    fresh(path_at, :) = trial(path_at, :)
    trial(1, :) = [CTE_STATUS_OPEN, CTE_STATUS_CLOSED, CTE_STATUS_STICK, CTE_STATUS_SLIP]
    fresh(1, :) = CTE_STATUS_STICK
    expected = fresh
    expected(multiplier_at, :) = trial(multiplier_at, :)
    expected(4:5, 3:) = expected(2:3, 3:) - (trial(2:3, 3:) - trial(4:5, 3:)) ! the others are without friction
  end subroutine histories

  ! Every point of an element of several by itself; the table and the Fortran 77 entry give the same bits.
  subroutine entries()
    real(dp) :: trial(4*history_size), fresh(4*history_size), expected(4*history_size), history(4*history_size)
    type(cte_api_table) :: api
    procedure(cte_history_augment), pointer :: history_augment
    integer(i4) :: e, argument, code
    logical :: pass
    pass = cte_api(CTE_VERSION_MAJOR, api) == CTE_SUCCESS
    pass = cte_element_find('Quad4Quad4CoulombAugmented', 26, e) == CTE_SUCCESS .and. pass
    if (pass) pass = bench_index(b, e, 0_i4)
    pass = pass .and. b%info%points == 4 .and. b%info%history == 4*history_size
    call histories(trial, fresh, expected)
    history = fresh
    pass = cte_history_augment(b%element, trial, history, argument) == CTE_SUCCESS .and. pass
    call client_check(pass .and. client_same(history, expected), 'augment: every point by itself')
    call c_f_procpointer(api%history_augment, history_augment)
    history = fresh
    argument = -1
    pass = history_augment(b%element, trial, history, argument) == CTE_SUCCESS .and. pass
    call client_check(pass .and. argument == CTE_ARGUMENT_NONE .and. client_same(history, expected), &
      'table: history_augment')
    history = fresh
    argument = -1
    code = -1
    call cte_f77_history_augment(e, trial, history, argument, code)
    call client_check(code == CTE_SUCCESS .and. argument == CTE_ARGUMENT_NONE .and. client_same(history, expected), &
      'F77 history_augment')
  end subroutine entries

  ! A point accepted with a multiplier of -6 on the edge x = 1 of the square, evaluated there without a gap.
  function on_the_edge(name, status) result(pass)
    character(len=*), intent(in) :: name
    integer(i4), intent(in) :: status
    logical :: pass
    integer :: last
    call opened(a, name, -0.02_dp)
    a%x(1) = 0.96_dp
    last = a%info%history
    pass = bench_evaluate(a) == CTE_SUCCESS
    call accept(a)
    a%history_accepted(last) = -4
    a%u(:2) = [0.04_dp, 0.003_dp]
    pass = evaluated(a, status) .and. pass
    pass = pass .and. abs(a%out%history_trial(last) + 6) < 1e-14_dp
    call accept(a)
    a%u(3) = 0.02_dp
    pass = evaluated(a, status) .and. pass
  end function on_the_edge

  ! A point on the edge x = 1 goes to the coplanar facet beyond it: the force is the same.
  subroutine transferred(name, status, what)
    character(len=*), intent(in) :: name, what
    integer(i4), intent(in) :: status
    integer(i4) :: argument
    logical :: pass
    integer :: last
    argument = -1
    pass = on_the_edge(name, status)
    last = a%info%history
    call opened(b, name, -0.02_dp)
    b%x(1) = 0.96_dp
    b%x(4:n:3) = b%x(4:n:3) + 2
    b%u(:3) = a%u(:3)
    pass = bench_evaluate(b) == CTE_SUCCESS .and. pass
    pass = cte_history_transfer(a%element, a%out%output, a%out%history_trial, b%element, b%out%output, b%out%history_trial, &
      argument) == CTE_SUCCESS .and. pass
    call client_check(pass .and. argument == CTE_ARGUMENT_NONE .and. nint(b%out%history_trial(1)) == status &
      .and. client_same(b%out%history_trial(last:last), a%out%history_trial(last:last)) &
      .and. client_same(b%out%history_trial(2:3), &
      b%out%output(CTE_OUTPUT_PROJECTION + 1:CTE_OUTPUT_PROJECTION + 2)), what)
    call accept(b)
    pass = bench_evaluate(b) == CTE_SUCCESS .and. pass
    call client_check(pass .and. client_near(b%out%f(:3), a%out%f(:3), 1e-13_dp) .and. abs(b%out%f(3) + 6) < 1e-13_dp, &
      'transfer of a multiplier: the force does not jump')
  end subroutine transferred

  subroutine interface_augmented_run()
    call one_evaluation()
    call normal()
    call tangential()
    call sliding()
    call entries()
    call transferred(plain, CTE_STATUS_CLOSED, 'transfer of a multiplier: status and multiplier go along')
    call transferred(frictional, CTE_STATUS_STICK, 'transfer of a multiplier with friction: they go along')
  end subroutine interface_augmented_run

end module interface_augmented
