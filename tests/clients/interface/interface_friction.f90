! interface_friction.f90 - friction as documented: where contact begins, stick, slip, history, freezing.
!
! A point on a flat facet, |N| = 5 at a depth of 0.05, eps_t = 50, mu = 1/4: slip begins at |T| = 1.25.
module interface_friction
  use, intrinsic :: iso_c_binding, only: c_associated, c_loc, c_null_ptr
  use contact_elements
  use client_support
  implicit none
  private
  public :: interface_friction_run

  integer, parameter :: n = 15, history_size = 6, anchor_at = 3, path_at = 5 ! entries from 0
  real(dp), parameter :: eps_n = 100.0_dp, eps_t = 50.0_dp ! [force/length]
  type(bench), save, target :: b, plain

contains

  ! An open history; the slave in the middle of the facet.
  subroutine opened(any_bench, name)
    type(bench), intent(inout), target :: any_bench
    character(len=*), intent(in) :: name
    call bench_open(any_bench, name)
    any_bench%x(:n) = [real(dp) :: 0.2_dp, -0.1_dp, -0.05_dp, -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]
  end subroutine opened

  function evaluated(status) result(pass)
    integer(i4), intent(in) :: status
    logical :: pass
    call bench_canary(b)
    pass = bench_evaluate(b) == CTE_SUCCESS
    pass = pass .and. b%a%status == status .and. nint(b%out%output(1)) == status &
      .and. nint(b%out%history_trial(1)) == status
  end function evaluated

  subroutine move(x, y)
    real(dp), intent(in) :: x, y
    b%u(:2) = [x, y]
  end subroutine move

  subroutine accept()
    b%history_accepted(:history_size) = b%out%history_trial(:history_size)
  end subroutine accept

  pure function cross(a, c) result(product)
    real(dp), intent(in) :: a(3), c(3)
    real(dp) :: product(3)
    product = [a(2)*c(3) - a(3)*c(2), a(3)*c(1) - a(1)*c(3), a(1)*c(2) - a(2)*c(1)]
  end function cross

  ! The friction on the slave, T_1 d_1 + T_2 d_2, is (x, y, 0); f holds it with the other sign.
  function friction_is(x, y) result(pass)
    real(dp), intent(in) :: x, y
    logical :: pass
    real(dp) :: t(2), b_1(3), normal(3), expected(3), found(3), on_slave(3)
    t = b%out%output(CTE_OUTPUT_TANGENTIAL_TRACTION + 1:CTE_OUTPUT_TANGENTIAL_TRACTION + 2)
    b_1 = b%out%output(CTE_OUTPUT_TANGENTS + 1:CTE_OUTPUT_TANGENTS + 3)
    b_1 = b_1/norm2(b_1)
    normal = b%out%output(CTE_OUTPUT_NORMAL + 1:CTE_OUTPUT_NORMAL + 3)
    expected = [x, y, 0.0_dp]
    found = t(1)*b_1 + t(2)*cross(normal, b_1) ! d_2 = n x d_1
    on_slave = b%out%output(CTE_OUTPUT_NORMAL_TRACTION + 1)*normal - b%out%f(:3)
    pass = client_near(found, expected, 1e-12_dp) .and. client_near(on_slave, expected, 1e-12_dp)
  end function friction_is

  function asymmetry() result(largest)
    real(dp) :: largest, k(n, n)
    k = reshape(b%out%k(:n*n), [n, n])
    largest = maxval(abs(k - transpose(k)))
  end function asymmetry

  ! Entries of the new history or of the output, counted from 0.
  function entries(values, first, number) result(part)
    real(dp), intent(in) :: values(:)
    integer, intent(in) :: first, number
    real(dp) :: part(number)
    part = values(first + 1:first + number)
  end function entries

  subroutine begins()
    real(dp) :: history(history_size), t(2)
    integer(i4) :: code
    logical :: pass
    call client_check(b%info%history == history_size .and. b%info%symmetric == 0 .and. b%info%projected == 2, &
      'friction: history of 2 + 2 P entries, no symmetry')
    call opened(plain, 'PointQuad4')
    code = bench_evaluate(plain)
    pass = evaluated(CTE_STATUS_STICK) .and. code == CTE_SUCCESS
    t = entries(b%out%output, CTE_OUTPUT_TANGENTIAL_TRACTION, 2)
    call client_check(pass .and. all(abs(t) <= 0) .and. client_near(b%out%f(:n), plain%out%f(:n), 1e-14_dp) &
      .and. client_near(b%out%k(:n*n), plain%out%k(:n*n), 1e-14_dp), &
      'friction begins: no tangential force, no tangential stiffness')
    history = b%out%history_trial(:history_size)
    call client_check(client_same(entries(history, CTE_HISTORY_PROJECTION, 2), entries(history, anchor_at, 2)) &
      .and. abs(history(path_at + 1)) <= 0 .and. client_same(entries(history, CTE_HISTORY_PROJECTION, 2), &
      entries(b%out%output, CTE_OUTPUT_PROJECTION, 2)), 'friction begins: the anchor is the projection')
    b%a%history_accepted = c_null_ptr
    pass = evaluated(CTE_STATUS_STICK)
    call client_check(pass .and. client_same(history, b%out%history_trial(:history_size)), &
      'friction begins without history_accepted too')
    b%a%history_accepted = c_loc(b%history_accepted)
    b%history_accepted(CTE_HISTORY_STATUS + 1) = CTE_STATUS_OUTSIDE
    b%history_accepted(anchor_at + 1) = 0.9_dp
    pass = evaluated(CTE_STATUS_STICK)
    call client_check(pass .and. client_same(history, b%out%history_trial(:history_size)), &
      'friction begins where the history says outside')
    t = entries(plain%out%output, CTE_OUTPUT_TANGENTIAL_TRACTION, 2)
    call client_check(plain%info%history == 3 .and. all(abs(t) <= 0) .and. client_same( &
      entries(plain%out%output, CTE_OUTPUT_TANGENTS, 6), entries(b%out%output, CTE_OUTPUT_TANGENTS, 6)), &
      'without friction: tangents in the output, no tangential force')
  end subroutine begins

  subroutine sticks()
    real(dp) :: anchor(2), new(2), expected
    logical :: pass
    call accept()
    anchor = entries(b%history_accepted, anchor_at, 2)
    call move(0.01_dp, -0.02_dp)
    pass = evaluated(CTE_STATUS_STICK)
    call client_check(pass .and. friction_is(-0.5_dp, 1.0_dp), 'stick: T = eps_t s, against the motion')
    new = entries(b%out%history_trial, CTE_HISTORY_PROJECTION, 2)
    call client_check(client_same(anchor, entries(b%out%history_trial, anchor_at, 2)) &
      .and. abs(b%out%history_trial(path_at + 1)) <= 0 .and. .not. client_same(anchor, new), 'stick: the anchor stays')
    expected = eps_n*0.05_dp*0.05_dp/2 + 1.25_dp/(2*eps_t)
    call client_check(abs(b%out%energy(1) - expected) < 1e-14_dp, 'stick: energy = W + T^2/(2 eps_t)')
  end subroutine sticks

  ! |s| = 0.05, trial force 2.5: half of the slip stays elastic, half is slid.
  subroutine slides()
    real(dp) :: first(n), apart(2)
    integer(i4) :: code
    logical :: pass
    call move(0.03_dp, -0.04_dp)
    pass = evaluated(CTE_STATUS_SLIP)
    call client_check(pass .and. friction_is(-0.75_dp, 1.0_dp), 'slip: |T| = mu |N| against the slip')
    apart = entries(b%out%history_trial, CTE_HISTORY_PROJECTION, 2) - entries(b%out%history_trial, anchor_at, 2)
    call client_check(abs(b%out%history_trial(path_at + 1) - 0.025_dp) < 1e-14_dp &
      .and. all(abs(apart - [0.015_dp, -0.02_dp]) < 1e-14_dp), &
      'slip: the anchor follows at the elastic distance, the path grows')
    call client_check(asymmetry() > 0.1_dp, 'slip: K is not symmetric')
    first = b%out%f(:n)
    pass = evaluated(CTE_STATUS_SLIP)
    call client_check(pass .and. client_same(first, b%out%f(:n)), 'no evaluation reads history_trial')
    call accept()
    call bench_canary(b)
    code = bench_evaluate(b)
    call client_check(code == CTE_SUCCESS .and. client_near(b%out%f(:n), first, 1e-13_dp) &
      .and. abs(b%out%history_trial(path_at + 1) - 0.025_dp) < 1e-14_dp, 'slip accepted: the same force at the same place')
    call move(0.02_dp, -0.04_dp)
    pass = evaluated(CTE_STATUS_STICK)
    call client_check(pass .and. friction_is(-0.25_dp, 1.0_dp), 'turned back: elastic from the bound')
  end subroutine slides

  subroutine frozen()
    logical :: pass
    call opened(b, 'PointQuad4Coulomb')
    call bench_set(b, 'eps_t', eps_t)
    pass = evaluated(CTE_STATUS_STICK)
    call accept()
    b%a%request = ior(b%a%request, CTE_FREEZE_STATE)
    call move(0.03_dp, -0.04_dp)
    pass = evaluated(CTE_STATUS_STICK)
    call client_check(pass .and. friction_is(-1.5_dp, 2.0_dp), 'CTE_FREEZE_STATE: sticks beyond the bound')
    b%history_accepted(1) = CTE_STATUS_CLOSED
    pass = evaluated(CTE_STATUS_SLIP)
    call client_check(pass .and. friction_is(-0.75_dp, 1.0_dp), 'CTE_FREEZE_STATE: closed, the law decides')
    b%history_accepted(1) = CTE_STATUS_SLIP
    call move(0.003_dp, -0.004_dp)
    pass = evaluated(CTE_STATUS_SLIP)
    call client_check(pass .and. friction_is(-0.75_dp, 1.0_dp), 'CTE_FREEZE_STATE: slides below the bound')
    b%history_accepted(1) = CTE_STATUS_OPEN
    pass = evaluated(CTE_STATUS_OPEN)
    call client_check(pass .and. abs(b%out%f(3)) <= 0, 'CTE_FREEZE_STATE: open')
  end subroutine frozen

  ! Two points of one element: the one that is remembered slides, the other one begins.
  subroutine rank_of_status()
    integer(i4) :: element_index, code
    logical :: pass
    element_index = -1
    pass = cte_element_find('Line2Line2Coulomb2d', 19, element_index) == CTE_SUCCESS
    if (pass) pass = bench_index(b, element_index, 0_i4)
    if (.not. pass) then
      call client_check(.false., 'Line2Line2Coulomb2d')
      return
    end if
    b%x(:8) = [real(dp) :: 0, -0.1_dp, 1, -0.1_dp, -1, 0, 2, 0]
    pass = evaluated(CTE_STATUS_STICK)
    pass = pass .and. b%a%closed_points == 2 .and. b%info%history == 8
    b%history_accepted(:4) = b%out%history_trial(:4)
    call bench_set(b, 'eps_t', 1000.0_dp)
    b%u(1) = 0.1_dp
    b%u(3) = 0.1_dp
    call bench_canary(b)
    code = bench_evaluate(b)
    pass = pass .and. code == CTE_SUCCESS .and. nint(b%out%history_trial(1)) == CTE_STATUS_SLIP &
      .and. nint(b%out%history_trial(5)) == CTE_STATUS_STICK .and. b%a%status == CTE_STATUS_SLIP &
      .and. b%a%closed_points == 2
    call client_check(pass, 'the status of an element: slip before stick')
  end subroutine rank_of_status

  subroutine interface_friction_run()
    call opened(b, 'PointQuad4Coulomb')
    if (.not. c_associated(b%element)) return
    call bench_set(b, 'eps_t', eps_t)
    call begins()
    call sticks()
    call slides()
    call frozen()
    call rank_of_status()
  end subroutine interface_friction_run

end module interface_friction
