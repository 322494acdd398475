! interface_multipliers.f90 - multipliers that are unknowns: a separate node behind the others, with one unknown.
!
! A point at (0.2, -0.1, g) over the square [-1,1]^2, whose normal is z and whose parameters are x and y: residual and
! tangent are written down by hand. N = multiplier + eps_n g.
module interface_multipliers
  use, intrinsic :: iso_c_binding, only: c_loc, c_null_ptr
  use contact_elements
  use client_support
  implicit none
  private
  public :: interface_multipliers_run

  integer, parameter :: n = 16, lambda = 16, nodes = 5, ld = 20 ! unknowns, the last; nodes with positions; host's rows
  real(dp), parameter :: eps_n = 100.0_dp, eps_t = 100.0_dp, mu = 0.25_dp, at(2) = [0.2_dp, -0.1_dp]
  character(len=*), parameter :: element = 'PointQuad4Multiplier'
  type(bench), save, target :: b

contains

  ! An open history, depth and multiplier.
  subroutine opened(name, gap, multiplier)
    character(len=*), intent(in) :: name
    real(dp), intent(in) :: gap, multiplier
    integer :: i
    call bench_open(b, name)
    b%x(:3*nodes) = [real(dp) :: at, gap, -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]
    do i = 1, 3
      call client_special(2, b%x(3*nodes + i)) ! not looked at
    end do
    b%u(lambda) = multiplier
  end subroutine opened

  function evaluated(status) result(pass)
    integer(i4), intent(in) :: status
    logical :: pass
    call bench_canary(b)
    pass = bench_evaluate(b) == CTE_SUCCESS
    pass = pass .and. b%a%status == status .and. nint(b%out%output(1)) == status &
      .and. nint(b%out%history_trial(1)) == status
  end function evaluated

  ! Entry of the output, counted from 0.
  function output(entry) result(value)
    integer(i4), intent(in) :: entry
    real(dp) :: value
    value = b%out%output(entry + 1)
  end function output

  function tangent() result(k)
    real(dp) :: k(n, n)
    k = transpose(reshape(b%out%k(:n*n), [n, n]))
  end function tangent

  ! s_A and s_A,i of slave and corners: + on the slave, - the shape function on the master.
  subroutine rows(s, ds)
    real(dp), intent(out) :: s(nodes), ds(nodes, 2)
    real(dp), parameter :: corner(2, 4) = reshape([real(dp) :: -1, -1, 1, -1, 1, 1, -1, 1], [2, 4])
    real(dp) :: along(4), across(4)
    along = 1 + corner(1, :)*at(1)
    across = 1 + corner(2, :)*at(2)
    s = [1.0_dp, -along*across/4]
    ds(:, 1) = [0.0_dp, -corner(1, :)*across/4]
    ds(:, 2) = [0.0_dp, -along*corner(2, :)/4]
  end subroutine rows

  ! R = N s_A n and g; K = eps_n s_A s_B n n + N times the second variation of the gap, n s_A beside it.
  subroutine closed_by_hand(gap, multiplier, f, k)
    real(dp), intent(in) :: gap, multiplier
    real(dp), intent(out) :: f(n), k(n, n)
    real(dp) :: s(nodes), ds(nodes, 2), traction
    integer :: a, c, row, column
    traction = multiplier + eps_n*gap
    call rows(s, ds)
    f = 0
    k = 0
    f(lambda) = gap
    do a = 1, nodes
      row = 3*a - 2
      f(row + 2) = traction*s(a)
      k(row + 2, lambda) = s(a)
      k(lambda, row + 2) = s(a)
      do c = 1, nodes
        column = 3*c - 2
        k(row + 2, column + 2) = eps_n*s(a)*s(c) - traction*gap*dot_product(ds(a, :), ds(c, :))
        k(row:row + 1, column + 2) = traction*s(a)*ds(c, :)
        k(row + 2, column:column + 1) = traction*ds(a, :)*s(c)
      end do
    end do
  end subroutine closed_by_hand

  function is_closed_by_hand(gap, multiplier) result(pass)
    real(dp), intent(in) :: gap, multiplier
    logical :: pass
    real(dp) :: f(n), k(n, n), found(n, n)
    call closed_by_hand(gap, multiplier, f, k)
    found = tangent()
    pass = client_near(b%out%f(:n), f, 1e-14_dp) .and. abs(found(lambda, lambda)) <= 0 .and. b%a%closed_points == 1 &
      .and. client_near(reshape(found, [n*n]), reshape(k, [n*n]), 1e-14_dp)
  end function is_closed_by_hand

  ! -multiplier/eps_n and -1/eps_n, all else zero.
  function open_by_hand(multiplier) result(pass)
    real(dp), intent(in) :: multiplier
    logical :: pass
    real(dp) :: f(n), k(n*n)
    f = 0
    k = 0
    f(n) = -multiplier/eps_n
    k(n*n) = -1/eps_n
    pass = abs(output(CTE_OUTPUT_NORMAL_TRACTION)) <= 0 .and. b%a%closed_points == 0 &
      .and. all((abs(f) <= 0) .eqv. (abs(b%out%f(:n)) <= 0)) .and. all((abs(k) <= 0) .eqv. (abs(b%out%k(:n*n)) <= 0)) &
      .and. client_near(b%out%f(:n), f, 1e-15_dp) .and. client_near(b%out%k(:n*n), k, 1e-15_dp) &
      .and. abs(b%out%energy(1) + multiplier**2/(2*eps_n)) < 1e-16_dp
  end function open_by_hand

  subroutine described()
    integer(i4) :: node, kind
    logical :: pass
    call opened(element, -0.05_dp, -3.0_dp)
    call client_check(b%info%nodes_minimum == nodes + 1 .and. b%info%nodes_maximum == nodes + 1 &
      .and. b%info%slave_nodes == 1 .and. b%info%master_nodes == 4 .and. b%info%unknowns == n &
      .and. b%info%history == 3 .and. b%info%symmetric == 1, &
      'multiplier: one node and one unknown more, the history of a plain element')
    node = -1
    kind = -1
    pass = cte_element_unknown(b%element, 0, lambda - 1, node, kind) == CTE_SUCCESS
    pass = pass .and. node == nodes .and. kind == CTE_UNKNOWN_MULTIPLIER
    if (pass) pass = cte_element_unknown(b%element, 0, lambda, node, kind) == CTE_ERROR_INDEX
    call client_check(pass, 'multiplier: the last unknown, on the last node')
  end subroutine described

  subroutine is_closed()
    logical :: pass
    call opened(element, -0.05_dp, -3.0_dp)
    pass = evaluated(CTE_STATUS_CLOSED)
    call client_check(pass .and. is_closed_by_hand(-0.05_dp, -3.0_dp), 'multiplier, closed: f and K by hand')
    call client_check(abs(output(CTE_OUTPUT_NORMAL_TRACTION) + 8) < 1e-14_dp &
      .and. abs(output(CTE_OUTPUT_GAP) + 0.05_dp) < 1e-16_dp .and. abs(output(CTE_OUTPUT_WEIGHT) - 1) <= 0 &
      .and. abs(b%out%energy(1) - (64 - 9)/(2*eps_n)) < 1e-15_dp, &
      'multiplier, closed: N = multiplier + eps_n g, energy = (N^2 - multiplier^2)/(2 eps_n)')
    call opened(element, 0.02_dp, -3.0_dp)
    pass = evaluated(CTE_STATUS_CLOSED)
    call client_check(pass .and. is_closed_by_hand(0.02_dp, -3.0_dp), 'multiplier, a gap held closed by the multiplier')
  end subroutine is_closed

  subroutine is_open()
    logical :: pass
    call opened(element, -0.02_dp, 3.0_dp)
    pass = evaluated(CTE_STATUS_OPEN)
    call client_check(pass .and. open_by_hand(3.0_dp), 'multiplier, a depth opened by the multiplier')
    call opened(element, 0.05_dp, -3.0_dp)
    pass = evaluated(CTE_STATUS_OPEN)
    call client_check(pass .and. open_by_hand(-3.0_dp), &
      'multiplier, open: f = -multiplier/eps_n, K = -1/eps_n, all else zero')
    call opened(element, -0.05_dp, -3.0_dp)
    b%x(1) = 1.5_dp
    pass = evaluated(CTE_STATUS_OUTSIDE)
    call client_check(pass .and. open_by_hand(-3.0_dp), 'multiplier, outside: as open')
    b%a%u = c_null_ptr
    b%x(1) = at(1)
    pass = evaluated(CTE_STATUS_CLOSED)
    call client_check(pass .and. is_closed_by_hand(-0.05_dp, 0.0_dp), 'multiplier, u null: no multiplier')
  end subroutine is_open

  ! At N = 0: just closed, just open, and both states at the switch itself.
  subroutine continuous()
    real(dp), parameter :: gap(2) = [0.05_dp, -0.05_dp], step = 1e-9_dp
    real(dp) :: closed(n), zero
    logical :: pass
    integer :: i
    do i = 1, 2
      zero = -eps_n*gap(i)
      call opened(element, gap(i), zero - step)
      pass = evaluated(CTE_STATUS_CLOSED)
      closed = b%out%f(:n)
      b%u(lambda) = zero + step
      pass = evaluated(CTE_STATUS_OPEN) .and. pass
      call client_check(pass .and. all(abs(closed - b%out%f(:n)) < 1.1_dp*step) &
        .and. abs(b%out%f(lambda) - gap(i)) < step, client_text('multiplier, f is continuous at N = 0:', i - 1_i8))
    end do
  end subroutine continuous

  subroutine frozen()
    logical :: pass
    call opened(element, 0.05_dp, -3.0_dp)
    b%a%request = ior(b%a%request, CTE_FREEZE_STATE)
    b%history_accepted(1) = CTE_STATUS_CLOSED
    pass = evaluated(CTE_STATUS_CLOSED)
    call client_check(pass .and. is_closed_by_hand(0.05_dp, -3.0_dp), &
      'multiplier, CTE_FREEZE_STATE: closed in spite of N > 0')
    call opened(element, -0.05_dp, -3.0_dp)
    b%a%request = ior(b%a%request, CTE_FREEZE_STATE)
    pass = evaluated(CTE_STATUS_OPEN)
    call client_check(pass .and. open_by_hand(-3.0_dp), 'multiplier, CTE_FREEZE_STATE: open in spite of N < 0')
  end subroutine frozen

  ! A host with four rows per node: the multiplier is the fourth of the slave. Column-major, scaled.
  subroutine mapped(gap, status, what)
    real(dp), intent(in) :: gap
    integer(i4), intent(in) :: status
    character(len=*), intent(in) :: what
    integer(i4), target :: map(n)
    real(dp), target :: host_f(0:ld - 1), host_k(0:ld - 1, 0:ld - 1)
    real(dp) :: f(n), k(n, n), rest(ld)
    logical :: pass
    integer :: i, c
    call opened(element, gap, -3.0_dp)
    pass = evaluated(status)
    f = b%out%f(:n)
    k = tangent()
    map = [((4*i + c, c=0, 2), i=0, nodes - 1), 3]
    host_f = canary()
    host_k = canary()
    b%a%unknown_map = c_loc(map)
    b%a%f = c_loc(host_f)
    b%a%k = c_loc(host_k)
    b%a%k_row_stride = 1
    b%a%k_col_stride = ld
    b%a%f_scale = -1
    b%a%k_scale = -0.5_dp
    pass = evaluated(status) .and. pass
    pass = pass .and. all(abs(host_f(map) + f) <= 0) .and. all(abs(host_k(map, map) + 0.5_dp*k) <= 0)
    rest = canary()
    do i = 7, ld - 1, 4 ! the masters have no fourth row
      pass = pass .and. client_same(host_k(i, :), rest) .and. client_same(host_k(:, i), rest) &
        .and. client_same(host_f(i:i), rest(:1))
    end do
    call client_check(pass, what)
  end subroutine mapped

  ! Slip of 0.05 at N = -8: |T| = mu |N| = 2 along (0.6, -0.8), which grows with the multiplier.
  subroutine friction()
    real(dp) :: k(n, n)
    logical :: pass
    call opened('PointQuad4CoulombMultiplier', -0.05_dp, -3.0_dp)
    call bench_set(b, 'eps_t', eps_t)
    call bench_set(b, 'mu', mu)
    pass = evaluated(CTE_STATUS_STICK)
    pass = pass .and. b%info%history == 6 .and. b%info%symmetric == 0
    b%history_accepted(:6) = b%out%history_trial(:6)
    b%u(:2) = [0.03_dp, -0.04_dp]
    pass = evaluated(CTE_STATUS_SLIP) .and. pass
    k = tangent()
    call client_check(pass .and. client_near(b%out%f(:3), [1.2_dp, -1.6_dp, -8.0_dp], 1e-14_dp) &
      .and. abs(b%out%f(lambda) + 0.05_dp) < 1e-16_dp, 'multiplier with friction: the bound is mu |N|')
    call client_check(client_near(k(:3, lambda), [-0.15_dp, 0.2_dp, 1.0_dp], 1e-14_dp) &
      .and. client_near(k(lambda, :3), [0.0_dp, 0.0_dp, 1.0_dp], 1e-14_dp) .and. abs(k(lambda, lambda)) <= 0, &
      'multiplier with friction: the column has the bound''s change, the row has not')
  end subroutine friction

  ! Four points of a parallel square of area 1: each has its multiplier, in order; the third is pulled open.
  subroutine several()
    integer, parameter :: first = 25, all_unknowns = 28
    real(dp), parameter :: multiplier(4) = [-1.0_dp, -2.0_dp, 20.0_dp, -4.0_dp], weight = 0.25_dp
    logical, parameter :: open(4) = [.false., .false., .true., .false.]
    real(dp), parameter :: corner(12) = [real(dp) :: -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]
    real(dp) :: k(all_unknowns, all_unknowns), traction
    integer(i4) :: e
    integer :: q, row
    logical :: pass
    pass = cte_element_find('Quad4Quad4Multiplier', 20, e) == CTE_SUCCESS
    if (pass) pass = bench_index(b, e, 0_i4)
    pass = pass .and. b%info%unknowns == all_unknowns .and. b%info%nodes_minimum == 12
    b%x(:24) = [corner/2, corner]
    b%x(3:12:3) = -0.05_dp
    do q = 1, 4
      b%u(bench_position(b, first - 1 + q)) = multiplier(q)
    end do
    pass = bench_evaluate(b) == CTE_SUCCESS .and. pass
    pass = pass .and. b%a%closed_points == 3 .and. b%a%status == CTE_STATUS_CLOSED
    k = transpose(reshape(b%out%k(:all_unknowns**2), [all_unknowns, all_unknowns]))
    do q = 1, 4
      row = first - 1 + q
      pass = pass .and. abs(b%out%f(row) - weight*merge(-0.2_dp, -0.05_dp, open(q))) < 1e-16_dp &
        .and. abs(k(row, row) + merge(weight/eps_n, 0.0_dp, open(q))) < 1e-17_dp &
        .and. abs(sum(k(3:12:3, row)) - merge(0.0_dp, weight, open(q))) < 1e-15_dp
    end do
    traction = sum(weight*(multiplier - 5), mask=.not. open)
    call client_check(pass .and. abs(sum(b%out%f(3:12:3)) - traction) < 1e-14_dp, &
      'multiplier, four points: each its own, in order')
  end subroutine several

  ! Two slave nodes that share the point, weight 2.
  subroutine interpolated()
    integer, parameter :: last = 19
    real(dp) :: point(3*nodes), k(last, last)
    integer(i4) :: e, node, kind
    logical :: pass
    call opened(element, -0.05_dp, -3.0_dp)
    point = b%x(:3*nodes)
    pass = cte_element_find('InterpolatedQuad4Multiplier', 27, e) == CTE_SUCCESS
    if (pass) pass = bench_index(b, e, 2_i4)
    if (pass) pass = cte_element_unknown(b%element, 7, last - 1, node, kind) == CTE_SUCCESS
    pass = pass .and. b%info%unknowns == last .and. b%a%nnode == 7 .and. node == 6 .and. kind == CTE_UNKNOWN_MULTIPLIER
    b%x(:18) = [point(:3), point]
    b%row(:3) = [0.5_dp, 0.5_dp, 2.0_dp]
    b%u(last) = -3
    pass = bench_evaluate(b) == CTE_SUCCESS .and. pass
    k = transpose(reshape(b%out%k(:last**2), [last, last]))
    call client_check(pass .and. b%a%status == CTE_STATUS_CLOSED .and. abs(b%out%f(last) + 0.1_dp) < 1e-16_dp &
      .and. all(abs(b%out%f([3, 6]) + 8) < 1e-14_dp) .and. abs(k(3, last) - 1) < 1e-15_dp &
      .and. abs(k(last, 6) - 1) < 1e-15_dp, 'multiplier, interpolated: behind slave and master nodes, times the weight')
  end subroutine interpolated

  subroutine interface_multipliers_run()
    call described()
    call is_closed()
    call is_open()
    call continuous()
    call frozen()
    call mapped(-0.05_dp, CTE_STATUS_CLOSED, 'multiplier, closed: host rows, column-major, scales')
    call mapped(0.05_dp, CTE_STATUS_OPEN, 'multiplier, open: host rows, column-major, scales')
    call friction()
    call several()
    call interpolated()
  end subroutine interface_multipliers_run

end module interface_multipliers
