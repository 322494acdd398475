! bricks.f90 - a small finite-element program that calls the contact element as a legacy host would.
!
! An upper brick is pushed onto a lower one; four contact elements "PointQuad4" join the upper brick's
! lower nodes (slaves) to the lower brick's top face (master). Newton with the element's tangent.
! The host has its own layout: room for nen nodes with ndf unknowns each per element, right-hand side
! p = -f, column-major s(nst, nst). The element writes straight into p and s through unknown_map and
! strides. bricks.c and bricks.f (Fortran 77 entries) are the twins.
!
! Reference: the same problem in six independent finite-element programs.
module bricks_program
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_ptr, c_loc
  use contact_elements
  use brick_model
  implicit none
  private
  public :: bricks_run

  integer, parameter :: dp = c_double, i4 = c_int32_t
  integer, parameter :: ndm = 3            ! coordinates of a node
  integer, parameter :: ndf = 4            ! unknowns of a node in this host; the last one is not mechanical
  integer, parameter :: nen = 8            ! most nodes of an element in this host
  integer, parameter :: nst = ndf*nen      ! rows of an element matrix
  integer, parameter :: contacts = 4, contact_nodes = 5, contact_unknowns = 15
  integer, parameter :: history_room = 16, parameter_room = 16
  integer, parameter :: steps = 5          ! of the push
  integer, parameter :: iterations = 20

  real(dp), parameter :: young = 1000.0_dp ! [force/length^2]
  real(dp), parameter :: poisson = 0.3_dp  ! [1]
  real(dp), parameter :: eps_n = 1.0e4_dp  ! [force/length]
  real(dp), parameter :: push = -0.05_dp   ! u_z of the top face [length]
  real(dp), parameter :: slide(3) = [0.2_dp, 0.1_dp, 0.0_dp] ! of the top face after the push [length]
  real(dp), parameter :: converged = 5.0e-11_dp ! norm of the residual [force]

  ! Slave node, then the facet counter-clockwise seen from above, so that its normal is +z.
  integer, parameter :: contact_node(contact_nodes, contacts) = reshape( &
    [9, 5, 6, 7, 8, 10, 5, 6, 7, 8, 11, 5, 6, 7, 8, 12, 5, 6, 7, 8], [contact_nodes, contacts])

  type :: contact_set
    type(c_ptr) :: element
    type(cte_info) :: info
    real(dp) :: parameters(parameter_room) = 0
    integer(i4) :: map(contact_unknowns) = 0 ! element unknown -> row of the host's element matrix, from 0
    real(dp) :: history_accepted(history_room, contacts) = 0, history_trial(history_room, contacts) = 0
  end type contact_set

  type :: model
    real(dp) :: x(ndm, model_nodes)
    real(dp) :: u(ndm, model_nodes) = 0
    logical :: prescribed(model_unknowns)
    real(dp) :: elastic(model_unknowns, model_unknowns) ! constant: small strain
    real(dp) :: k(model_unknowns, model_unknowns)
    real(dp) :: f(model_unknowns) ! internal force, bricks and contact
  end type model

contains

  ! Sets the named parameter; false when the element has none of that name.
  function set_parameter(contact, wanted, value) result(found)
    type(contact_set), intent(inout) :: contact
    character(len=*), intent(in) :: wanted
    real(dp), intent(in) :: value
    logical :: found
    type(c_ptr) :: name, unit
    real(dp) :: lower, upper
    integer(i4) :: i, closed
    found = .true.
    do i = 0, contact%info%parameters - 1
      if (cte_element_parameter(contact%element, i, name, unit, lower, upper, closed) /= CTE_SUCCESS) cycle
      if (cte_string(name) /= wanted) cycle
      contact%parameters(i + 1) = value
      return
    end do
    print '(2a)', 'FAIL no parameter ', wanted
    found = .false.
  end function set_parameter

  ! Where each element unknown stands in the host's element matrix.
  function make_map(contact) result(pass)
    type(contact_set), intent(inout) :: contact
    logical :: pass
    integer(i4) :: i, node, kind
    do i = 0, contact_unknowns - 1
      pass = cte_element_unknown(contact%element, 0, i, node, kind) == CTE_SUCCESS
      if (.not. pass) return
      contact%map(i + 1) = node*ndf + (kind - CTE_UNKNOWN_UX)
    end do
  end function make_map

  function contact_start(contact) result(pass)
    type(contact_set), intent(inout) :: contact
    logical :: pass
    character(len=*), parameter :: name = 'PointQuad4'
    integer(i4) :: index, bad
    integer :: c
    pass = cte_element_find(name, len(name), index) == CTE_SUCCESS
    if (.not. pass) return
    contact%element = cte_element_get(index)
    pass = cte_element_info(contact%element, 0, contact%info) == CTE_SUCCESS
    if (.not. pass) return
    pass = contact%info%unknowns == contact_unknowns .and. contact%info%history <= history_room &
      .and. contact%info%parameters <= parameter_room .and. contact%info%workspace == 0
    if (.not. pass) return
    pass = set_parameter(contact, 'eps_n', eps_n)
    pass = set_parameter(contact, 'r0', 0.0_dp) .and. pass
    pass = make_map(contact) .and. pass
    do c = 1, contacts
      pass = cte_element_history_init(contact%element, contact%history_accepted(:, c)) == CTE_SUCCESS .and. pass
    end do
    pass = cte_element_check_parameters(contact%element, contact%parameters, contact%info%parameters, &
      bad) == CTE_SUCCESS .and. pass
  end function contact_start

  ! One contact element in the host's own layout: p = -f, s = +K.
  function contact_element(contact, m, c, p, s) result(pass)
    type(contact_set), intent(inout), target :: contact
    type(model), intent(in) :: m
    integer, intent(in) :: c
    real(dp), intent(inout), target :: p(nst), s(nst, nst)
    logical :: pass
    real(dp), target :: xl(ndm, nen), ul(ndf, nen)
    type(cte_arguments) :: a
    character(len=256) :: text
    integer(i4) :: code, length
    xl = 0
    ul = 0
    xl(:, :contact_nodes) = m%x(:, contact_node(:, c))
    ul(:ndm, :contact_nodes) = m%u(:, contact_node(:, c))
    p = 0
    s = 0
    a%request = CTE_RESIDUAL + CTE_TANGENT + CTE_HISTORY
    a%nnode = contact_nodes
    a%x = c_loc(xl)
    a%u = c_loc(ul)
    a%x_node_stride = ndm
    a%u_node_stride = ndf
    a%parameters = c_loc(contact%parameters)
    a%parameter_count = contact%info%parameters
    a%history_accepted = c_loc(contact%history_accepted(1, c))
    a%history_trial = c_loc(contact%history_trial(1, c))
    a%f = c_loc(p)
    a%f_scale = -1
    a%k = c_loc(s)
    a%k_row_stride = 1
    a%k_col_stride = nst
    a%unknown_map = c_loc(contact%map)
    code = cte_element_evaluate(contact%element, a)
    pass = code == CTE_SUCCESS
    if (pass) return
    length = cte_element_message(contact%element, a, code, text, len(text))
    print '(a,i0,2a)', 'FAIL contact ', c, ': ', text(:min(length, len(text) - 1))
  end function contact_element

  ! Internal force and tangent of bricks and contacts at m%u.
  function assemble(contact, m) result(pass)
    type(contact_set), intent(inout) :: contact
    type(model), intent(inout) :: m
    logical :: pass
    real(dp) :: p(nst), s(nst, nst)
    integer :: c, row(contact_unknowns), local(contact_unknowns), a, i
    m%k = m%elastic
    m%f = matmul(m%elastic, reshape(m%u, [model_unknowns]))
    do c = 1, contacts
      pass = contact_element(contact, m, c, p, s)
      if (.not. pass) return
      do a = 1, contact_nodes
        do i = 1, 3
          row(3*(a - 1) + i) = 3*(contact_node(a, c) - 1) + i
          local(3*(a - 1) + i) = ndf*(a - 1) + i
        end do
      end do
      m%f(row) = m%f(row) - p(local)
      m%k(row, row) = m%k(row, row) + s(local, local)
    end do
  end function assemble

  ! Newton iterations; residual receives the norms [force]. Returns their number, 0 on failure.
  function newton(contact, m, step, residual) result(number)
    type(contact_set), intent(inout) :: contact
    type(model), intent(inout) :: m
    integer, intent(in) :: step
    real(dp), intent(out) :: residual(iterations)
    integer :: number, it
    logical :: pass
    residual = 0
    number = 0
    do it = 1, iterations
      if (.not. assemble(contact, m)) return
      residual(it) = brick_model_residual(m%prescribed, m%f)
      print '(a,i0,a,i0,a,es9.3)', 'step ', step, ' iteration ', it - 1, ' residual ', residual(it)
      if (residual(it) < converged) then
        number = it
        return
      end if
      call brick_model_correct(m%prescribed, m%k, m%f, m%u, pass)
      if (.not. pass) return
    end do
  end function newton

  ! Quadratic: each residual is less than its predecessor's square times a constant [1/force], up to
  ! rounding.
  function quadratic(residual, number) result(pass)
    real(dp), intent(in) :: residual(iterations)
    integer, intent(in) :: number
    logical :: pass
    real(dp), parameter :: constant = 2
    pass = number > 0
    if (pass) pass = all(residual(2:number) <= constant*residual(:number - 1)**2 + converged)
    print '(2a,i0,a)', verdict(pass), ' quadratic convergence, ', number, ' iterations'
  end function quadratic

  function verdict(pass) result(word)
    logical, intent(in) :: pass
    character(len=4) :: word
    word = merge('PASS', 'FAIL', pass)
  end function verdict

  ! Ten digits; the reference itself is rounded to the digits given.
  function agrees(what, value, reference) result(pass)
    character(len=*), intent(in) :: what
    real(dp), intent(in) :: value, reference
    logical :: pass
    character(len=28) :: padded
    pass = abs(value - reference) <= 1.0e-10_dp*abs(reference)
    padded = what
    print '(a,1x,a,1x,es18.11,a,es18.11)', verdict(pass), padded, value, ' reference ', reference
  end function agrees

  function compare(m) result(pass)
    type(model), intent(in) :: m
    logical :: pass, each(5)
    each(1) = agrees('reaction z at (0,0,0)', m%f(3), 4.53720508167_dp)
    each(2) = agrees('u_x of (0,0,1)', m%u(1, 5), -3.5390199637e-3_dp)
    each(3) = agrees('u_y of (0,0,1)', m%u(2, 5), -3.5390199637e-3_dp)
    each(4) = agrees('u_z of (0,0,1)', m%u(3, 5), -1.6515426497e-2_dp)
    each(5) = agrees('u_z of (0.25,0.25,1)', m%u(3, 9), -1.6969147005e-2_dp)
    pass = all(each)
  end function compare

  ! One step: the upper brick first moves along rigidly, so there is no strain and the contact, whose gap
  ! is zero in the beginning, is closed in the first iteration.
  function step(contact, m, number, move) result(pass)
    type(contact_set), intent(inout) :: contact
    type(model), intent(inout) :: m
    integer, intent(in) :: number
    real(dp), intent(in) :: move(3)
    logical :: pass
    real(dp) :: residual(iterations)
    integer :: count
    m%u(:, brick_nodes + 1:) = m%u(:, brick_nodes + 1:) + spread(move, 2, brick_nodes)
    count = newton(contact, m, number, residual)
    contact%history_accepted = contact%history_trial ! the step is accepted
    pass = quadratic(residual, count)
  end function step

  ! The push in equal steps, compared with the reference. Its facet stays flat, which makes it almost
  ! linear; the slide after it has no reference, but warps the facet and moves the slaves on it.
  function bricks_run() result(pass)
    logical :: pass
    type(contact_set) :: contact
    type(model) :: m
    logical :: each(steps + 2)
    integer :: number
    pass = contact_start(contact)
    if (.not. pass) print '(a)', 'FAIL the contact element is not as expected'
    if (.not. pass) return
    call brick_model_coordinates(m%x)
    call brick_model_prescribed(m%prescribed)
    call brick_model_stiffness(m%x, young, poisson, m%elastic)
    do number = 1, steps
      each(number) = step(contact, m, number, [0.0_dp, 0.0_dp, push/steps])
    end do
    each(steps + 1) = compare(m)
    each(steps + 2) = step(contact, m, steps + 1, slide)
    pass = all(each)
    print '(2a)', verdict(pass), ' bricks'
  end function bricks_run

end module bricks_program

program bricks
  use bricks_program
  implicit none
  if (.not. bricks_run()) stop 1
end program bricks
