! interface_project.f90 - cte_element_project: the closest point of the whole domain, found without a start.
!
! Mostly over the unit square, whose parameters are 2 x - 1 and 2 y - 1: closest points are written down by hand. The
! trough z = x^2 over [-1,1]^2 has two feet for a point above its middle.
module interface_project
  use, intrinsic :: iso_c_binding, only: c_f_procpointer, c_loc, c_null_ptr, c_ptr
  use contact_elements
  use client_support
  implicit none
  private
  public :: interface_project_run

  integer(i4), parameter :: inside = CTE_VERDICT_INSIDE, boundary = CTE_VERDICT_BOUNDARY
  real(dp), parameter :: square(12) = [real(dp) :: 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]
  real(dp), parameter :: half = 0.5_dp, none(3) = 0
  type(bench), save, target :: b
  type(cte_projection), save :: found(4)

contains

  subroutine opened(name, nslave)
    character(len=*), intent(in) :: name
    integer(i4), intent(in) :: nslave
    integer(i4) :: element_index
    logical :: pass
    element_index = -1
    pass = cte_element_find(name, len(name), element_index) == CTE_SUCCESS
    if (pass) pass = bench_index(b, element_index, nslave)
    if (.not. pass) call client_check(.false., name)
  end subroutine opened

  ! A point over the unit square, its displacement zero.
  subroutine point(name, at)
    character(len=*), intent(in) :: name
    real(dp), intent(in) :: at(3)
    call opened(name, 0)
    b%x(:15) = [at, square]
  end subroutine point

  ! Results filled with a pattern, then the projection.
  function projected(reach, history) result(pass)
    real(dp), intent(in) :: reach
    type(c_ptr), intent(in) :: history
    logical :: pass
    found = cte_projection([canary(), canary()], canary(), canary(), -1, -1, -1, -1)
    pass = cte_element_project(b%element, b%a, reach, found, history) == CTE_SUCCESS
    pass = pass .and. b%a%error_argument == CTE_ARGUMENT_NONE .and. b%a%error_index == 0
  end function projected

  ! foot: both parameters, then the distance.
  pure function is(p, verdict, feature, foot) result(pass)
    type(cte_projection), intent(in) :: p
    integer(i4), intent(in) :: verdict
    integer, intent(in) :: feature
    real(dp), intent(in) :: foot(3)
    logical :: pass
    pass = p%verdict == verdict .and. p%feature == feature .and. all(abs([p%zeta, p%distance] - foot) < 1e-12_dp)
  end function is

  pure function same(a, other) result(pass)
    type(cte_projection), intent(in) :: a, other
    logical :: pass
    pass = all(transfer(a, [0_i8]) == transfer(other, [0_i8]))
  end function same

  ! Beyond a feature the foot is on it; the way there is 0.3, 0.4 or 1.2 along the axes.
  subroutine on_a_square()
    real(dp), parameter :: edge(4, 4) = reshape([real(dp) :: 0.25_dp, -0.3_dp, -0.5_dp, -1, 1.3_dp, 0.75_dp, 1, &
      0.5_dp, 0.75_dp, 1.3_dp, 0.5_dp, 1, -0.3_dp, 0.25_dp, -1, -0.5_dp], [4, 4])
    real(dp), parameter :: vertex(4, 4) = reshape([real(dp) :: -0.3_dp, -0.4_dp, -1, -1, 1.3_dp, -0.4_dp, 1, -1, &
      1.3_dp, 1.4_dp, 1, 1, -0.3_dp, 1.4_dp, -1, 1], [4, 4])
    logical :: pass
    integer :: i
    call point('PointQuad4', [0.25_dp, 0.75_dp, 0.5_dp])
    pass = projected(0.0_dp, c_null_ptr)
    call client_check(pass .and. is(found(1), inside, 0, [-half, half, half]), 'project: inside')
    call client_check(abs(found(1)%definiteness - 1) < 1e-12_dp .and. found(1)%boxes > 0 .and. found(1)%steps >= 0, &
      'project: definiteness 1 on a plane')
    call point('PointQuad4', [0.25_dp, 0.75_dp, -0.5_dp])
    pass = projected(0.0_dp, c_null_ptr)
    call client_check(pass .and. is(found(1), inside, 0, [-half, half, half]), 'project: from below')
    do i = 1, 4
      call point('PointQuad4', [edge(:2, i), 0.4_dp])
      pass = projected(0.0_dp, c_null_ptr)
      call client_check(pass .and. is(found(1), boundary, i, [edge(3:, i), half]), &
        client_text('project: beyond edge', i - 1_i8))
    end do
    do i = 1, 4
      call point('PointQuad4', [vertex(:2, i), 1.2_dp])
      pass = projected(0.0_dp, c_null_ptr)
      call client_check(pass .and. is(found(1), boundary, 4 + i, [vertex(3:, i), 1.3_dp]), &
        client_text('project: beyond vertex', i - 1_i8))
    end do
  end subroutine on_a_square

  ! Nothing farther is looked for; a closed projection is found all the same.
  subroutine reaches()
    type(cte_projection) :: without
    logical :: pass
    call point('PointQuad4', [0.25_dp, 0.75_dp, 0.5_dp])
    pass = projected(0.0_dp, c_null_ptr)
    without = found(1)
    pass = projected(0.6_dp, c_null_ptr) .and. pass
    call client_check(pass .and. is(found(1), inside, 0, [-half, half, half]) &
      .and. client_same(found(1)%zeta, without%zeta), 'project: within the reach')
    pass = projected(0.4_dp, c_null_ptr)
    call client_check(pass .and. is(found(1), CTE_VERDICT_BEYOND, 0, none) .and. abs(found(1)%definiteness) <= 0, &
      'project: beyond the reach')
    call bench_open(b, 'PointCylinder')
    b%x(1) = 2 ! 1 from the wall of radius 1
    pass = projected(0.0_dp, c_null_ptr)
    call client_check(pass .and. found(1)%verdict == inside .and. abs(found(1)%distance - 1) < 1e-12_dp &
      .and. found(1)%boxes == 0, 'project: a closed projection needs no boxes')
    pass = projected(half, c_null_ptr)
    call client_check(pass .and. found(1)%verdict == CTE_VERDICT_BEYOND .and. abs(found(1)%distance - 1) < 1e-12_dp, &
      'project: a closed projection beyond the reach')
  end subroutine reaches

  ! Where nothing is projected: x is 0.1 within the wall, 0.9 from the axis; the points are 0.1 apart.
  subroutine nothing_projected()
    logical :: pass
    call bench_open(b, 'PointPoint')
    pass = projected(0.0_dp, c_null_ptr)
    call client_check(pass .and. is(found(1), inside, 0, none), 'project: a point has nothing to project')
    call bench_open(b, 'PointCylinderDistance')
    pass = projected(0.0_dp, c_null_ptr)
    call client_check(pass .and. is(found(1), inside, 0, none), 'project: a distance function has nothing to project')
    pass = projected(half, c_null_ptr)
    call client_check(pass .and. is(found(1), inside, 0, none), 'project: a distance function within the reach')
  end subroutine nothing_projected

  ! The history is the initial one at the foot, from which an evaluation has little to do.
  subroutine histories()
    real(dp) :: initial(6)
    logical :: pass
    integer :: at
    call bench_open(b, 'PointQuad4Coulomb')
    pass = cte_element_history_init(b%element, initial) == CTE_SUCCESS
    call bench_canary(b)
    pass = projected(0.0_dp, c_loc(b%history_accepted)) .and. pass
    initial(2:5) = [found(1)%zeta, found(1)%zeta]
    call client_check(pass .and. client_same(b%history_accepted(:6), initial), 'project: projection and anchor of the history')
    call client_check(bench_untouched(b), 'project: nothing else is written')
    pass = bench_evaluate(b) == CTE_SUCCESS
    at = CTE_OUTPUT_PROJECTION + 1
    pass = pass .and. b%a%status == CTE_STATUS_STICK &
      .and. client_near(b%out%output(at:at + 1), found(1)%zeta, 1e-12_dp) &
      .and. abs(abs(b%out%output(CTE_OUTPUT_GAP + 1)) - found(1)%distance) < 1e-12_dp
    call client_check(pass .and. b%out%output(CTE_OUTPUT_ITERATIONS + 1) <= 3, &
      'project: at most 3 iterations from there')
  end subroutine histories

  ! Four points of a facet that lies half beside the other: the evaluation knows the same features.
  subroutine four_points()
    real(dp), target :: history(3, 4)
    real(dp) :: output(0:CTE_OUTPUT_SIZE - 1, 4), foot(3)
    logical :: pass, beyond
    integer :: i, points_inside
    call opened('Quad4Quad4', 0)
    b%x(:12) = square
    b%x(1:12:3) = square(1:12:3) + half
    b%x(3:12:3) = 0.3_dp
    b%x(13:24) = square
    b%a%history_accepted = c_null_ptr
    pass = projected(0.0_dp, c_loc(history))
    pass = bench_evaluate(b) == CTE_SUCCESS .and. pass
    pass = pass .and. b%info%points == 4
    output = reshape(b%out%output(:4*CTE_OUTPUT_SIZE), shape(output))
    points_inside = 0
    do i = 1, 4
      beyond = output(CTE_OUTPUT_FEATURE, i) > 0
      foot = [output(CTE_OUTPUT_PROJECTION:CTE_OUTPUT_PROJECTION + 1, i), 0.3_dp]
      if (beyond) then
        foot(1) = 1
        foot(3) = sqrt(0.09_dp + (half/sqrt(3.0_dp))**2) ! from the edge x = 1
      else
        points_inside = points_inside + 1
      end if
      pass = pass .and. is(found(i), merge(boundary, inside, beyond), merge(2, 0, beyond), foot) &
        .and. client_same(history(2:, i), found(i)%zeta) .and. abs(history(1, i)) <= 0
    end do
    call client_check(pass .and. points_inside == 2, 'project: four points, two beyond the edge')
  end subroutine four_points

  ! 3/4 of one node and 1/4 of another; and a row that does not sum to one.
  subroutine interpolated()
    logical :: pass
    call opened('InterpolatedQuad4', 2)
    b%x(:6) = [0.0_dp, 0.5_dp, 0.3_dp, 1.0_dp, 0.5_dp, 0.3_dp]
    b%x(7:18) = square
    b%row(:3) = [0.75_dp, 0.25_dp, 2.0_dp]
    pass = projected(0.0_dp, c_null_ptr)
    call client_check(pass .and. is(found(1), inside, 0, [-half, 0.0_dp, 0.3_dp]), 'project: interpolated slave')
    b%row(1) = 0.25_dp
    pass = projected(0.0_dp, c_null_ptr)
    call client_check(pass .and. is(found(1), inside, 0, [-half, -half, 0.15_dp]), &
      'project: a row that does not sum to one')
  end subroutine interpolated

  ! Neither x nor u of the multiplier's node is read.
  subroutine multiplier()
    real(dp), target :: history(3)
    logical :: pass
    integer :: i
    call point('PointQuad4Multiplier', [0.25_dp, 0.75_dp, 0.5_dp])
    do i = 16, 18
      call client_special(2, b%x(i))
    end do
    pass = projected(0.0_dp, c_loc(history))
    call client_check(pass .and. is(found(1), inside, 0, [-half, half, half]) &
      .and. client_same(history(2:), found(1)%zeta) .and. abs(history(1)) <= 0, &
      'project: x of a multiplier''s node is not looked at')
  end subroutine multiplier

  ! Other layouts of the same numbers give the same bits; what stands between the nodes is not read.
  subroutine layouts()
    real(dp), target :: x(5, 5), u(4, 5)
    type(cte_projection) :: dense
    type(cte_api_table) :: api
    procedure(cte_element_project), pointer :: element_project
    logical :: pass
    integer :: a, i
    call bench_open(b, 'PointQuad4')
    b%u(:15) = [(0.01_dp*i, i=0, 14)]
    pass = projected(0.0_dp, c_null_ptr)
    dense = found(1)
    pass = cte_api(CTE_VERSION_MAJOR, api) == CTE_SUCCESS .and. pass
    call c_f_procpointer(api%element_project, element_project)
    found(1)%distance = canary()
    pass = element_project(b%element, b%a, 0.0_dp, found, c_null_ptr) == CTE_SUCCESS .and. pass
    call client_check(pass .and. same(found(1), dense), 'table: element_project')
    do a = 1, 5
      do i = 1, 5
        call client_special(2, x(i, a))
        if (i < 5) call client_special(2, u(i, a))
      end do
      x(:3, a) = b%x(3*a - 2:3*a)
      u(:3, a) = b%u(3*a - 2:3*a)
    end do
    b%a%x = c_loc(x)
    b%a%u = c_loc(u)
    b%a%x_node_stride = 5
    b%a%u_node_stride = 4
    pass = projected(0.0_dp, c_null_ptr)
    call client_check(pass .and. same(found(1), dense), 'project: strides')
  end subroutine layouts

  subroutine displacements()
    type(cte_projection) :: zero
    logical :: pass
    call point('PointQuad4', [0.25_dp, 0.75_dp, 0.5_dp])
    pass = projected(0.0_dp, c_null_ptr)
    zero = found(1)
    b%a%u = c_null_ptr
    b%a%nnode = 5
    b%a%request = 0
    pass = projected(0.0_dp, c_null_ptr) .and. pass
    call client_check(pass .and. same(found(1), zero), 'project: u null, no request')
    b%x(1:15:3) = b%x(1:15:3) - 0.125_dp ! exact
    b%u(1:15:3) = 0.125_dp
    b%a%u = c_loc(b%u)
    pass = projected(0.0_dp, c_null_ptr)
    call client_check(pass .and. same(found(1), zero), 'project: x + u is the position')
  end subroutine displacements

  ! A point at (x, 0.2, 1) above the trough z = x^2; nodes: corners, middles of edges, centre.
  subroutine trough(x)
    real(dp), intent(in) :: x
    real(dp), parameter :: at(2, 9) = reshape([real(dp) :: -1, -1, 1, -1, 1, 1, -1, 1, 0, -1, 1, 0, 0, 1, -1, &
      0, 0, 0], [2, 9])
    integer :: a
    call opened('PointQuad9', 0)
    b%x(:3) = [x, 0.2_dp, 1.0_dp]
    do a = 1, 9
      b%x(3*a + 1:3*a + 3) = [at(:, a), at(1, a)**2]
    end do
  end subroutine trough

  ! The feet are where 2 z^3 - z - x = 0; of the three the middle one is the farthest.
  subroutine troughs()
    real(dp), parameter :: side(2) = [0.05_dp, -0.05_dp]
    real(dp) :: z
    logical :: pass
    integer :: i, at
    call trough(0.0_dp)
    pass = projected(0.0_dp, c_null_ptr)
    call client_check(pass .and. found(1)%verdict == CTE_VERDICT_NOT_UNIQUE &
      .and. abs(abs(found(1)%zeta(1)) - sqrt(half)) < 1e-7_dp .and. abs(found(1)%zeta(2) - 0.2_dp) < 1e-7_dp &
      .and. abs(found(1)%distance - sqrt(0.75_dp)) < 1e-9_dp, 'project: two feet in a trough')
    at = CTE_OUTPUT_PROJECTION + 1
    do i = 1, 2
      call trough(side(i))
      pass = projected(0.0_dp, c_loc(b%history_accepted))
      z = found(1)%zeta(1)
      call client_check(pass .and. found(1)%verdict == inside .and. z*side(i) > 0 &
        .and. abs(2*z**3 - z - side(i)) < 1e-12_dp .and. abs(found(1)%zeta(2) - 0.2_dp) < 1e-12_dp, &
        client_text('project: the nearer foot in a trough', i - 1_i8))
      call client_check(abs(found(1)%definiteness - (6*z**2 - 1)/(1 + 4*z**2)) < 1e-12_dp, &
        client_text('project: definiteness in a trough', i - 1_i8))
      pass = bench_evaluate(b) == CTE_SUCCESS
      call client_check(pass .and. b%out%output(CTE_OUTPUT_ITERATIONS + 1) <= 3 &
        .and. client_near(b%out%output(at:at + 1), found(1)%zeta, 1e-12_dp), &
        client_text('project: an evaluation stays at the nearer foot', i - 1_i8))
    end do
  end subroutine troughs

  subroutine interface_project_run()
    call on_a_square()
    call reaches()
    call nothing_projected()
    call histories()
    call four_points()
    call interpolated()
    call multiplier()
    call layouts()
    call displacements()
    call troughs()
  end subroutine interface_project_run

end module interface_project
