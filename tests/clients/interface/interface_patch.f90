! interface_patch.f90 - cte_patch_evaluate: slave points over the corner of a box, three unit squares.
!
! The body surrounds the corner: the floor z = 0 and the walls x = 0 and y = 0 have their normals towards +z, +x and +y,
! the free space is x, y, z > 0. A point inside the body beyond an edge or the vertex is as deep as it is far from it.
module interface_patch
  use, intrinsic :: iso_c_binding, only: c_loc, c_null_ptr, c_ptr
  use contact_elements
  use client_support
  implicit none
  private
  public :: interface_patch_run

  integer, parameter :: points = 4, masters = 7, n = 3*(points + masters), per_point = 5
  ! Floor, wall x = 0, wall y = 0; master node 0 is the corner.
  integer(i4), target :: facets(12) = [0, 1, 4, 2, 0, 2, 6, 3, 0, 3, 5, 1]
  real(dp), parameter :: master_nodes(3*masters) = [real(dp) :: 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 0, 1, 0, 1, &
    0, 1, 1]
  ! Through the floor, beyond the edge along x, beyond the vertex, and free.
  real(dp), parameter :: slave_points(3*points) = [0.5_dp, 0.5_dp, -0.1_dp, 0.5_dp, -0.03_dp, -0.04_dp, -0.02_dp, &
    -0.01_dp, -0.02_dp, 0.4_dp, 0.4_dp, 0.4_dp]
  real(dp), parameter :: depth(points) = [0.1_dp, 0.05_dp, 0.03_dp, -0.4_dp]

  real(dp), save, target :: x(n), parameters(3), f(n), k(n, n), output(CTE_OUTPUT_SIZE, points)
  real(dp), save, target :: history(per_point, points), energy(1), workspace(64)
  type(cte_patch), save :: patch
  type(cte_arguments), save :: a

contains

  function named(name) result(element)
    character(len=*), intent(in) :: name
    type(c_ptr) :: element
    integer(i4) :: at
    at = -1
    if (cte_element_find(name, len(name), at) /= CTE_SUCCESS) call client_check(.false., name)
    element = cte_element_get(at)
  end function named

  subroutine lay_out()
    patch = cte_patch()
    patch%slave_points = points
    patch%master_nodes = masters
    patch%facets = 3
    patch%facet = named('PointQuad4')
    patch%edge = named('PointLine2Oriented')
    patch%vertex = named('PointPointOriented')
    patch%connectivity = c_loc(facets)
    x = [slave_points, master_nodes]
    parameters = [1000.0_dp, 0.0_dp, 1.0_dp] ! eps_n, r0, orientation
    a = cte_arguments()
    a%request = CTE_RESIDUAL + CTE_TANGENT + CTE_OUTPUT + CTE_HISTORY + CTE_ENERGY
    a%x = c_loc(x)
    a%parameters = c_loc(parameters)
    a%parameter_count = 3
    a%f = c_loc(f)
    a%k = c_loc(k)
    a%output = c_loc(output)
    a%history_trial = c_loc(history)
    a%energy = c_loc(energy)
    a%workspace = c_loc(workspace)
    a%workspace_size = 64
  end subroutine lay_out

  function evaluated() result(pass)
    logical :: pass
    pass = cte_patch_evaluate(patch, a) == CTE_SUCCESS
  end function evaluated

  subroutine sizes()
    type(cte_info) :: info
    integer(i4) :: argument
    logical :: pass
    pass = cte_patch_info(patch, info, argument) == CTE_SUCCESS
    pass = pass .and. argument == CTE_ARGUMENT_NONE
    pass = pass .and. info%dimension == 3 .and. info%unknowns == n .and. info%points == points &
      .and. info%parameters == 3 .and. info%history == points*per_point .and. info%workspace <= 64 &
      .and. info%symmetric == 1 .and. info%nodes_minimum == points + masters
    call client_check(pass, 'patch: sizes')
  end subroutine sizes

  ! Depth, force and place of every point; what is in balance.
  subroutine forces()
    real(dp), parameter :: facet(points) = 1, feature(points) = [real(dp) :: 0, 1, 5, 0]
    real(dp) :: stored
    logical :: pass
    integer :: i
    pass = evaluated()
    call client_check(pass .and. a%status == CTE_STATUS_CLOSED .and. a%closed_points == 3, &
      'patch: three points are closed')
    stored = 0
    do i = 1, points
      call client_check(abs(output(CTE_OUTPUT_GAP + 1, i) + depth(i)) < 1e-14_dp, &
        client_text('patch: gap of point', i - 1_i8))
      if (depth(i) > 0) then
        call client_check(abs(norm2(f(3*i - 2:3*i)) - 1000*depth(i)) < 1e-11_dp, &
          client_text('patch: force of point', i - 1_i8))
        call client_check(abs(history(2, i) - facet(i)) <= 0 .and. abs(history(3, i) - feature(i)) <= 0, &
          client_text('patch: place of point', i - 1_i8))
        stored = stored + 500*depth(i)**2
      else
        call client_check(abs(f(3*i - 2)) <= 0 .and. abs(history(1, i)) <= 0, &
          client_text('patch: no force of point', i - 1_i8))
      end if
    end do
    call client_check(abs(energy(1) - stored) < 1e-12_dp, 'patch: energy')
    call client_check(all(abs([(sum(f(i:n:3)), i=1, 3)]) < 1e-11_dp), 'patch: balance')
    call client_check(all(abs(k - transpose(k)) < 1e-10_dp), 'patch: symmetric')
  end subroutine forces

  ! Residual alone gives the same bits; map, scale and column-major storage put them elsewhere.
  subroutine layouts()
    real(dp), save, target :: apart(2*n), wide(2*n, 2*n), single(n)
    real(dp) :: whole(n)
    integer(i4), target :: map(n)
    logical :: pass
    integer :: i
    call lay_out()
    pass = evaluated()
    whole = f
    a%request = CTE_RESIDUAL
    a%f = c_loc(single)
    pass = evaluated() .and. pass
    call client_check(pass .and. client_same(single, whole), 'patch: residual alone')
    call lay_out()
    map = [(2*i - 1, i=1, n)]
    a%unknown_map = c_loc(map)
    a%f = c_loc(apart)
    a%k = c_loc(wide)
    a%k_row_stride = 1
    a%k_col_stride = 2*n
    a%f_scale = -1
    a%k_scale = 2
    pass = evaluated()
    ! k of before was row-major
    pass = pass .and. all(abs(apart(2:2*n:2) + f) <= 0) .and. all(abs(apart(1:2*n:2)) <= 0) &
      .and. all(abs(wide(2:2*n:2, 2:2*n:2) - 2*transpose(k)) <= 0)
    call client_check(pass, 'patch: map, strides and scales')
  end subroutine layouts

  ! Without lower pairs the points beyond are outside; beyond the reach there is nothing.
  subroutine without()
    logical :: pass
    call lay_out()
    patch%edge = c_null_ptr
    patch%vertex = c_null_ptr
    pass = evaluated()
    call client_check(pass .and. a%closed_points == 1 .and. abs(output(1, 2) - CTE_STATUS_OUTSIDE) <= 0, &
      'patch: facets alone')
    call lay_out()
    patch%reach = 0.04_dp
    pass = evaluated()
    call client_check(pass .and. a%closed_points == 1 .and. abs(output(1, 1) - CTE_STATUS_OUTSIDE) <= 0, &
      'patch: beyond the reach')
  end subroutine without

  ! The same arrays as history, and a state that stays closed.
  subroutine histories()
    real(dp) :: first(n)
    logical :: pass
    call lay_out()
    history = 0
    a%history_accepted = c_loc(history)
    pass = evaluated()
    first = f
    pass = evaluated() .and. pass
    call client_check(pass .and. client_same(first, f), 'patch: history in place')
    x(3) = 0.1_dp ! above the floor now
    a%request = CTE_RESIDUAL + CTE_FREEZE_STATE
    pass = evaluated()
    call client_check(pass .and. a%closed_points == 3 .and. abs(f(3) - 100) < 1e-11_dp, 'patch: frozen')
  end subroutine histories

  subroutine interface_patch_run()
    call lay_out()
    call sizes()
    call forces()
    call layouts()
    call without()
    call histories()
  end subroutine interface_patch_run

end module interface_patch
