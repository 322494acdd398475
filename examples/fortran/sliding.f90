! sliding.f90 - a block pressed onto another and pushed along it, with friction: stick, slip, and back.
!
! The bricks of brick_model.f90; four elements "PointQuad4Coulomb" join the upper brick's lower nodes to the lower
! brick's top face. The same steps are run with three tangents: the exact one, the one that leaves out the gap
! (of "PointQuad4CoulombTangentPlane"; the residual stays the exact one, so the solution is the same), and the
! exact one made symmetric. Printed are the residual norms, iterations and orders of convergence.
! sliding.c is the twin.
module sliding_program
  use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_int32_t, c_loc, c_null_ptr, c_ptr
  use contact_elements
  use brick_model
  implicit none
  private
  public :: sliding_run

  integer, parameter :: dp = c_double, i4 = c_int32_t
  integer, parameter :: contacts = 4, nodes = 5
  integer, parameter :: n = 3*nodes      ! unknowns of a contact
  integer, parameter :: history_size = 6 ! status, projection, anchor, slip path
  integer, parameter :: parameter_count = 5
  integer, parameter :: pressing = 2, pushing = 5, returning = 5 ! steps
  integer, parameter :: steps = pressing + pushing + returning, iterations = 60
  integer, parameter :: exact = 1, tangent_plane = 2, symmetrised = 3, variants = 3
  character(len=13), parameter :: variant_name(variants) = [character(len=13) :: &
    'exact', 'tangent plane', 'symmetrised']

  real(dp), parameter :: young = 1000.0_dp      ! [force/length^2]
  real(dp), parameter :: poisson = 0.3_dp       ! [1]
  real(dp), parameter :: friction = 0.3_dp      ! coefficient [1]
  real(dp), parameter :: stiffness = 300.0_dp   ! normal and tangential penalty [force/length]
  real(dp), parameter :: converged = 5.0e-11_dp ! norm of the residual [force]

  ! Displacement of the top face in a step [length].
  real(dp), parameter :: press(3) = [0.0_dp, 0.0_dp, -0.1_dp], push(3) = [0.05_dp, 0.025_dp, 0.0_dp]
  real(dp), parameter :: back(3) = [-0.08_dp, -0.04_dp, 0.0_dp]

  type :: contact_set
    integer :: variant = exact
    type(c_ptr) :: element = c_null_ptr, tangent_plane = c_null_ptr
    real(dp) :: parameters(parameter_count) = [stiffness, stiffness, friction, 0.0_dp, 1.0_dp] ! r0, orientation
    real(dp) :: history_accepted(history_size, contacts) = 0, history_trial(history_size, contacts) = 0
    real(dp) :: output(0:CTE_OUTPUT_SIZE - 1, contacts) = 0
    integer(i4) :: status(contacts) = 0
  end type contact_set

  type :: model
    real(dp) :: x(3, model_nodes)
    real(dp) :: u(3, model_nodes) = 0
    logical :: prescribed(model_unknowns)
    real(dp) :: elastic(model_unknowns, model_unknowns) ! constant: small strain
    real(dp) :: k(model_unknowns, model_unknowns)
    real(dp) :: f(model_unknowns)
  end type model

  ! What a run leaves behind; sliding: contacts.
  type :: record
    integer :: iterations(steps) = 0, sliding(steps) = 0
    real(dp) :: order(steps) = 0, u(3, model_nodes, steps) = 0
  end type record

contains

  function element_of(name) result(element)
    character(len=*), intent(in) :: name
    type(c_ptr) :: element
    type(cte_info) :: info
    integer(i4) :: index
    element = c_null_ptr
    if (cte_element_find(name, len(name), index) /= CTE_SUCCESS) return
    if (cte_element_info(cte_element_get(index), 0, info) /= CTE_SUCCESS) return
    if (info%unknowns == n .and. info%history == history_size .and. info%parameters == parameter_count &
      .and. info%symmetric == 0) element = cte_element_get(index)
  end function element_of

  function contact_start(contact, variant) result(pass)
    type(contact_set), intent(inout) :: contact
    integer, intent(in) :: variant
    logical :: pass
    integer :: c
    contact%variant = variant
    contact%element = element_of('PointQuad4Coulomb')
    contact%tangent_plane = element_of('PointQuad4CoulombTangentPlane')
    pass = c_associated(contact%element) .and. c_associated(contact%tangent_plane)
    do c = 1, contacts
      if (pass) pass = cte_element_history_init(contact%element, contact%history_accepted(:, c)) == CTE_SUCCESS
    end do
  end function contact_start

  ! Slave, then the facet counter-clockwise seen from above, so that its normal is +z.
  pure function nodes_of(c) result(list)
    integer, intent(in) :: c
    integer :: list(nodes)
    list = [brick_nodes + c, 5, 6, 7, 8]
  end function nodes_of

  ! Force and tangent of a contact. want_elastic: it holds to its anchor if it was in contact, whatever the bound.
  function contact_element(contact, m, c, want_elastic, f, k) result(pass)
    type(contact_set), intent(inout), target :: contact
    type(model), intent(in) :: m
    integer, intent(in) :: c
    logical, intent(in) :: want_elastic
    real(dp), intent(inout), target :: f(n), k(n, n)
    logical :: pass
    real(dp), target :: x(3, nodes), u(3, nodes), history(0:history_size - 1)
    type(cte_arguments) :: a
    integer(i4) :: code, freeze
    x = m%x(:, nodes_of(c))
    u = m%u(:, nodes_of(c))
    history = contact%history_accepted(:, c)
    freeze = 0
    if (want_elastic .and. nint(history(CTE_HISTORY_STATUS)) /= CTE_STATUS_OPEN) then
      freeze = CTE_FREEZE_STATE
      history(CTE_HISTORY_STATUS) = CTE_STATUS_STICK
    end if
    a%request = CTE_RESIDUAL + CTE_TANGENT + CTE_HISTORY + CTE_OUTPUT + freeze
    if (contact%variant == symmetrised) a%request = a%request + CTE_SYMMETRISE
    a%x = c_loc(x)
    a%u = c_loc(u)
    a%parameters = c_loc(contact%parameters)
    a%parameter_count = parameter_count
    a%history_accepted = c_loc(history)
    a%history_trial = c_loc(contact%history_trial(1, c))
    a%output = c_loc(contact%output(0, c))
    a%f = c_loc(f)
    a%k = c_loc(k)
    a%k_row_stride = 1
    a%k_col_stride = n
    code = cte_element_evaluate(contact%element, a)
    contact%status(c) = a%status
    if (code == CTE_SUCCESS .and. contact%variant == tangent_plane) then
      a%request = CTE_TANGENT + freeze
      code = cte_element_evaluate(contact%tangent_plane, a)
    end if
    pass = code == CTE_SUCCESS
    if (.not. pass) print '(a,i0,2a)', 'FAIL contact ', c, ': ', cte_string(cte_code_message(code))
  end function contact_element

  ! Internal force and tangent of bricks and contacts at m%u.
  function assemble(contact, m, elastic) result(pass)
    type(contact_set), intent(inout) :: contact
    type(model), intent(inout) :: m
    logical, intent(in) :: elastic
    logical :: pass
    real(dp) :: f(n), k(n, n)
    integer :: c, list(nodes), row(n)
    m%k = m%elastic
    m%f = matmul(m%elastic, reshape(m%u, [model_unknowns]))
    do c = 1, contacts
      pass = contact_element(contact, m, c, elastic, f, k)
      if (.not. pass) return
      list = nodes_of(c)
      row = reshape(spread(3*list - 3, 1, 3) + spread([1, 2, 3], 2, nodes), [n])
      m%f(row) = m%f(row) + f
      m%k(row, row) = m%k(row, row) + k
    end do
  end function assemble

  ! Newton iterations, the first with the elastic tangent: a step that turns back begins at the bound, where the
  ! tangent of sliding knows no way back. Prints the norms [force]. Returns their number, 0 on failure.
  function newton(contact, m) result(number)
    type(contact_set), intent(inout) :: contact
    type(model), intent(inout) :: m
    integer :: number, it
    logical :: pass
    real(dp) :: norm
    number = 0
    do it = 1, iterations
      if (.not. assemble(contact, m, it == 1)) return
      norm = brick_model_residual(m%prescribed, m%f)
      if (contact%variant /= symmetrised) write (*, '(1x,es7.1)', advance='no') norm
      if (it > 1 .and. norm < converged) then
        number = it
        return
      end if
      call brick_model_correct(m%prescribed, m%k, m%f, m%u, pass)
      if (.not. pass) return
    end do
  end function newton

  ! The residual after one iteration from `distance` off the solution [force]; -1 where a contact changes its
  ! status on the way, or something fails.
  function residual_from(contact, m, distance) result(norm)
    type(contact_set), intent(inout) :: contact
    type(model), intent(inout) :: m
    real(dp), intent(in) :: distance
    real(dp) :: norm, off(model_unknowns)
    integer(i4) :: status(contacts)
    integer :: i
    logical :: pass
    norm = -1
    status = contact%status
    off = [(distance*sin(real(i, dp)), i=1, model_unknowns)]
    where (m%prescribed) off = 0
    m%u = m%u + reshape(off, [3, model_nodes])
    if (.not. assemble(contact, m, .false.)) return
    if (any(status /= contact%status)) return
    call brick_model_correct(m%prescribed, m%k, m%f, m%u, pass)
    if (.not. pass) return
    if (.not. assemble(contact, m, .false.)) return
    if (all(status == contact%status)) norm = brick_model_residual(m%prescribed, m%f)
  end function residual_from

  ! Order of convergence at the solution: how that residual falls when the distance is halved; -1 where the branch
  ! is left. The model and the trial history stay as they are.
  function order_at(contact, m) result(order)
    type(contact_set), intent(in) :: contact
    type(model), intent(in) :: m
    real(dp) :: order, norm(2)
    type(model), save :: near
    type(contact_set) :: trial
    integer :: i
    do i = 1, 2
      trial = contact
      near = m
      norm(i) = residual_from(trial, near, 1.0e-3_dp/i)
    end do
    order = -1
    if (all(norm > 0)) order = log(norm(1)/norm(2))/log(2.0_dp)
  end function order_at

  ! Coulomb's law at the accepted state: |T| = mu |N| and a longer path where it slides, |T| <= mu |N| and the old
  ! path where it sticks. Returns the number of sliding contacts, -1 where the law is broken.
  function sliding_contacts(contact) result(count)
    type(contact_set), intent(in) :: contact
    integer :: count, c
    real(dp) :: bound, force, slid
    count = 0
    do c = 1, contacts
      bound = friction*abs(contact%output(CTE_OUTPUT_NORMAL_TRACTION, c))
      force = norm2(contact%output(CTE_OUTPUT_TANGENTIAL_TRACTION:CTE_OUTPUT_TANGENTIAL_TRACTION + 1, c))
      slid = contact%history_trial(history_size, c) - contact%history_accepted(history_size, c)
      if (contact%status(c) == CTE_STATUS_SLIP) then
        if (abs(force - bound) > 1e-12_dp*bound .or. slid <= 0) count = -contacts - 1
        count = count + 1
      else if (force > bound .or. abs(slid) > 0) then
        count = -contacts - 1
      end if
    end do
    count = max(count, -1)
  end function sliding_contacts

  ! One step: pressing moves the upper brick rigidly, so that the contact, whose gap is zero in the beginning, is
  ! closed in the first iteration; pushing moves its top face alone.
  function step(contact, m, number, r) result(pass)
    type(contact_set), intent(inout) :: contact
    type(model), intent(inout) :: m
    integer, intent(in) :: number
    type(record), intent(inout) :: r
    logical :: pass, printed
    integer :: first
    first = merge(brick_nodes + 1, model_nodes - 3, number <= pressing)
    if (number <= pressing) then
      m%u(:, first:) = m%u(:, first:) + spread(press, 2, model_nodes - first + 1)
    else if (number <= pressing + pushing) then
      m%u(:, first:) = m%u(:, first:) + spread(push, 2, model_nodes - first + 1)
    else
      m%u(:, first:) = m%u(:, first:) + spread(back, 2, model_nodes - first + 1)
    end if
    printed = contact%variant /= symmetrised
    if (printed) write (*, '(a,i2,3a)', advance='no') 'step ', number, ' ', trim(variant_name(contact%variant)), ':'
    r%iterations(number) = newton(contact, m)
    if (printed) print '(a)', ''
    r%order(number) = order_at(contact, m)
    r%sliding(number) = sliding_contacts(contact)
    r%u(:, :, number) = m%u
    contact%history_accepted = contact%history_trial ! the step is accepted
    pass = r%iterations(number) > 0 .and. r%sliding(number) >= 0
  end function step

  function run(variant, r) result(pass)
    integer, intent(in) :: variant
    type(record), intent(inout) :: r
    logical :: pass
    type(model), save :: m
    type(contact_set) :: contact
    integer :: number
    m%u = 0
    call brick_model_coordinates(m%x)
    call brick_model_prescribed(m%prescribed)
    call brick_model_stiffness(m%x, young, poisson, m%elastic)
    pass = contact_start(contact, variant)
    do number = 1, steps
      if (pass) pass = step(contact, m, number, r)
    end do
    call check(pass, trim(variant_name(variant))//' tangent: every step converged, Coulomb''s law holds')
  end function run

  subroutine check(pass, what)
    logical, intent(in) :: pass
    character(len=*), intent(in) :: what
    print '(3a)', merge('PASS', 'FAIL', pass), ' ', what
  end subroutine check

  function compare(r) result(pass)
    type(record), intent(in) :: r(variants)
    logical :: pass, each(4)
    integer :: number, turn
    print '(a)', 'step  sliding  iterations: exact, tangent plane, symmetrised  order'
    do number = 1, steps
      print '(i4,i9,i19,i15,i13,1x,3f6.2)', number, r(exact)%sliding(number), r%iterations(number), r%order(number)
    end do
    print '(a,i26,i15,i13)', 'total', sum(r(exact)%iterations), sum(r(tangent_plane)%iterations), &
      sum(r(symmetrised)%iterations)
    turn = pressing + pushing
    each(1) = all(r(exact)%order >= 1.9_dp) .and. all(r(exact)%iterations <= 8)
    call check(each(1), 'exact tangent: order at least 1.9, at most 8 iterations')
    each(2) = all(r(exact)%sliding([turn, turn + 1, steps]) == [contacts, 0, contacts])
    call check(each(2), 'slides, sticks when it is turned back, slides the other way')
    each(3) = maxval(abs(r(tangent_plane)%u - r(exact)%u)) < 1e-9_dp &
      .and. maxval(abs(r(symmetrised)%u - r(exact)%u)) < 1e-9_dp
    call check(each(3), 'the solution does not depend on the tangent')
    each(4) = sum(r(exact)%iterations) < min(sum(r(tangent_plane)%iterations), sum(r(symmetrised)%iterations))
    call check(each(4), 'the exact tangent needs the fewest iterations')
    pass = all(each)
  end function compare

  function sliding_run() result(pass)
    logical :: pass, each(variants)
    type(record), save :: records(variants)
    integer :: variant
    do variant = 1, variants
      each(variant) = run(variant, records(variant))
    end do
    pass = compare(records)
    pass = pass .and. all(each)
    call check(pass, 'sliding')
  end function sliding_run

end module sliding_program

program sliding
  use sliding_program
  implicit none
  if (.not. sliding_run()) stop 1
end program sliding
