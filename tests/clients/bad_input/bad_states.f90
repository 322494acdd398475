! bad_states.f90 - states without a normal or an area, sizes beyond any memory, batches with one bad contact;
! see bad_input.f90.
module bad_states
  use, intrinsic :: iso_c_binding, only: c_associated, c_f_procpointer, c_loc, c_null_ptr, c_ptr
  use contact_elements
  use client_support
  implicit none
  private
  public :: bad_states_run

  integer, parameter :: contacts = 3, n = 15
  integer(i4), parameter :: untouched = -77
  integer(i8), parameter :: far = huge(0_i8)
  type(bench), save, target :: b
  type(cte_batch), save :: batch
  real(dp), save, target :: x(n, contacts), f(n, contacts), k(n*n, contacts)
  integer(i4), save, target :: status(contacts), code(contacts)

  ! Functions with every address by value.
  abstract interface
    function message_call(element, arguments, code, text, size) bind(c) result(length)
      import :: i4, c_ptr
      type(c_ptr), value :: element, arguments, text
      integer(i4), value :: code, size
      integer(i4) :: length
    end function message_call
    function evaluate_call(element, arguments) bind(c) result(code)
      import :: i4, c_ptr
      type(c_ptr), value :: element, arguments
      integer(i4) :: code
    end function evaluate_call
  end interface
  type(cte_api_table), save :: api

contains

  ! Cut back as degenerate, nothing written.
  function degenerate() result(pass)
    logical :: pass
    integer(i4) :: found
    call bench_canary(b)
    found = bench_evaluate(b)
    pass = found == CTE_CUT_BACK .and. b%a%status == CTE_STATUS_DEGENERATE .and. b%a%dt_ratio == 0.5_dp &
      .and. b%a%error_index == 0 .and. b%a%closed_points == 0 .and. bench_untouched(b)
  end function degenerate

  ! All nodes on the axis, in the centre, at the apex: no distance function but a plane's has a gradient.
  subroutine axes()
    integer(i4) :: e
    character(len=:), allocatable :: name
    do e = 0, cte_element_count() - 1
      if (.not. bench_index(b, e, 2)) cycle
      name = cte_string(b%info%name)
      if (.not. client_contains(name, 'Distance')) cycle
      if (client_contains(name, 'Plane')) then
        call client_check(bench_evaluate(b) == CTE_SUCCESS, name)
      else
        call client_check(degenerate(), name)
      end if
    end do
  end subroutine axes

  ! Slaves without length or area whose measure moves.
  subroutine no_area()
    character(len=21), parameter :: name(4) = [character(len=21) :: 'Line2Quad4Current', 'Quad4Quad4Current', &
      'Quad4CylinderCurrent', 'Line2Line2In2dCurrent']
    real(dp), parameter :: facet(3, 4) = reshape([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]*1.0_dp, [3, 4])
    integer(i4) :: element_index
    integer :: i, a, d, slaves
    logical :: pass
    do i = 1, 4
      pass = cte_element_find(name(i), len_trim(name(i)), element_index) == CTE_SUCCESS
      if (pass) pass = bench_index(b, element_index, 0)
      if (pass) then
        d = b%info%dimension
        slaves = b%info%slave_nodes
        do a = 0, slaves - 1
          b%x(a*d + 1:a*d + d) = 0.4_dp
          b%x(a*d + d) = -0.1_dp
        end do
        do a = 0, b%info%master_nodes - 1
          b%x((slaves + a)*d + 1:(slaves + a)*d + d) = facet(:d, a + 1)
        end do
        pass = degenerate()
      end if
      call client_check(pass, trim(name(i)))
    end do
  end subroutine no_area

  ! A projection that ends where a tangent vanishes: no normal, and no trap.
  subroutine folds()
    real(dp), parameter :: curve(8) = [-0.35775198312476275_dp, -0.15996433375403285_dp, 0.0_dp, 0.0_dp, 1.0_dp, &
      0.0_dp, 0.0_dp, 0.0_dp]
    real(dp), parameter :: facet(15) = [0.32448022570461044_dp, 0.8389384679496289_dp, 0.5141999583691359_dp, &
      -0.9860729075968265_dp, -1.1488143572583795_dp, -0.06259793927893043_dp, &
      0.892480515409261_dp, -1.0349531116895379_dp, 0.09425299530848862_dp, &
      -0.9860729075968265_dp, -1.1488143572583795_dp, -0.06259793927893043_dp, &
      -0.8702644775621593_dp, 0.8918195568025112_dp, 0.11188382990658284_dp]
    character(len=14), parameter :: name(0:1) = [character(len=14) :: 'PointLine3In2d', 'PointQuad4']
    integer(i4) :: element_index
    integer :: i
    logical :: pass
    do i = 0, 1
      pass = cte_element_find(name(i), len_trim(name(i)), element_index) == CTE_SUCCESS
      if (pass) pass = bench_index(b, element_index, 0)
      if (i == 0) b%x(:8) = curve
      if (i == 1) b%x(:15) = facet
      b%a%history_accepted = c_null_ptr
      if (pass) pass = degenerate()
      call client_check(pass, client_text('a fold', int(i, i8)))
    end do
  end subroutine folds

  ! Forces of a power law that are finite, but too large for a tangent: refused, and no trap.
  subroutine huge_forces()
    integer(i4) :: found
    integer :: i
    logical :: pass
    do i = 0, 1
      call bench_open(b, 'PointQuad4PowerLaw')
      if (.not. c_associated(b%element)) return
      b%parameters(2) = 7.7_dp
      b%parameters(3) = merge(1e30_dp, 1e9_dp, i == 0)
      call bench_canary(b)
      found = bench_evaluate(b)
      if (i == 0) then
        pass = found == CTE_CUT_BACK .and. b%a%status == CTE_STATUS_LAW .and. bench_untouched(b)
      else
        pass = found == CTE_SUCCESS .and. b%a%status == CTE_STATUS_CLOSED
      end if
      call client_check(pass, client_text('huge forces', int(i, i8)))
    end do
  end subroutine huge_forces

  subroutine counts()
    integer(i4), parameter :: many(3) = [huge(0_i4), 2_i4**30, (2_i4**30 - 1)/3 - 3]
    type(cte_info) :: info
    integer(i4) :: found
    integer :: i
    do i = 1, 3
      call bench_open(b, 'InterpolatedQuad4')
      found = cte_element_info(b%element, many(i) + merge(0, 4, i == 1), info)
      call client_check(found == CTE_ERROR_NODE_COUNT, client_text('info of too many nodes', int(many(i), i8)))
      call client_check(cte_element_batch_workspace(b%element, many(i)) == CTE_ERROR_NODE_COUNT, &
        client_text('batch workspace of too many slave nodes', int(many(i), i8)))
      call bench_canary(b)
      b%a%nslave = many(i)
      b%a%nnode = 0
      found = bench_evaluate(b)
      call client_check(found == CTE_ERROR_NODE_COUNT .and. b%a%error_argument == CTE_ARGUMENT_NSLAVE &
        .and. bench_untouched(b), client_text('too many slave nodes', int(many(i), i8)))
    end do
    found = cte_element_info(b%element, many(3) + 3, info)
    call client_check(found == CTE_SUCCESS .and. info%unknowns == 3*(many(3) + 3) &
      .and. info%workspace > info%unknowns, 'info of as many nodes as possible')
    call client_check(cte_element_batch_workspace(c_null_ptr, 0) == CTE_ERROR_NULL, &
      'batch workspace of element null')
  end subroutine counts

  ! Evaluates: refused for its strides, untouched.
  subroutine expect_stride(what, argument)
    character(len=*), intent(in) :: what
    integer(i4), intent(in) :: argument
    integer(i4) :: found
    found = bench_evaluate(b)
    call client_check(found == CTE_ERROR_STRIDE .and. b%a%error_argument == argument .and. bench_untouched(b), what)
  end subroutine expect_stride

  subroutine strides()
    call bench_open(b, 'PointQuad4')
    call bench_canary(b)
    b%a%x_node_stride = far
    call expect_stride('x_node_stride beyond any memory', CTE_ARGUMENT_X)
    b%a%x_node_stride = 2
    call expect_stride('x_node_stride 2', CTE_ARGUMENT_X)
    b%a%x_node_stride = 0
    b%a%u_node_stride = ishft(far, -3)
    call expect_stride('u_node_stride beyond any memory', CTE_ARGUMENT_U)
    b%a%u_node_stride = 0
    b%a%k_row_stride = far
    b%a%k_col_stride = 1
    call expect_stride('k_row_stride beyond any memory', CTE_ARGUMENT_K_STRIDE)
  end subroutine strides

  ! The scalars say what was wrong, whatever is wrong.
  subroutine scalars()
    type(c_ptr) :: element
    integer(i4) :: found
    call bench_open(b, 'PointQuad4')
    element = b%element
    b%element = c_null_ptr
    b%a%dt_ratio = 7
    b%a%status = untouched
    b%a%closed_points = untouched
    b%a%error_argument = untouched
    b%a%error_index = untouched
    found = bench_evaluate(b)
    call client_check(found == CTE_ERROR_NULL .and. b%a%dt_ratio == 1 .and. b%a%status == CTE_STATUS_OPEN &
      .and. b%a%closed_points == 0 .and. b%a%error_argument == CTE_ARGUMENT_ELEMENT .and. b%a%error_index == 0, &
      'element null: the scalars')
    b%element = element
    call client_check(client_contains(client_message(b, CTE_ERROR_NULL), &
      cte_string(cte_argument_name(CTE_ARGUMENT_ELEMENT))), 'element null: the text')
    call client_special(1, b%u(8))
    found = bench_evaluate(b)
    call client_check(found == CTE_ERROR_NOT_FINITE .and. b%a%error_index == 2, 'u: the index is the node')
    b%u(8) = 0
    call client_special(1, b%x(15))
    found = bench_evaluate(b)
    call client_check(found == CTE_ERROR_NOT_FINITE .and. b%a%error_index == 4, 'x: the index is the node')
  end subroutine scalars

  ! A struct of 8 bytes: nothing beyond them may be read (a memory checker looks at this).
  subroutine short_struct()
    integer(i4), allocatable, target :: a(:)
    character(len=256), target :: text
    procedure(evaluate_call), pointer :: evaluate
    procedure(message_call), pointer :: message
    integer(i4) :: found, length
    call c_f_procpointer(api%element_evaluate, evaluate)
    call c_f_procpointer(api%element_message, message)
    allocate (a(2), source=[8_i4, 0_i4])
    text = ''
    found = evaluate(b%element, c_loc(a))
    length = message(b%element, c_loc(a), CTE_ERROR_STRUCT_SIZE, c_loc(text), len(text))
    call client_check(found == CTE_ERROR_STRUCT_SIZE .and. length > 0 .and. client_contains(text, 'struct_size'), &
      'message with a short struct')
  end subroutine short_struct

  subroutine fresh()
    type(cte_batch) :: zero
    batch = zero
    x = spread(b%x(:n), 2, contacts)
    f = canary()
    k = canary()
    status = untouched
    code = untouched
    batch%request = CTE_RESIDUAL + CTE_TANGENT
    batch%parameter_count = b%info%parameters
    batch%x = c_loc(x)
    batch%parameters = c_loc(b%parameters)
    batch%f = c_loc(f)
    batch%k = c_loc(k)
    batch%status = c_loc(status)
    batch%code = c_loc(code)
  end subroutine fresh

  ! Refuses `count` contacts, touching nothing.
  subroutine refuse(what, count, wanted, argument)
    character(len=*), intent(in) :: what
    integer(i8), intent(in) :: count
    integer(i4), intent(in) :: wanted, argument
    integer(i4) :: found
    logical :: pass
    found = cte_element_evaluate_batch(b%element, count, batch)
    pass = found == wanted .and. batch%error_argument == argument .and. batch%failed == 0 &
      .and. status(1) == untouched .and. code(1) == untouched
    call client_check(pass, what)
    if (.not. pass) print '(4(a,i0))', '     code ', found, ' wanted ', wanted, ', argument ', &
      batch%error_argument, ' wanted ', argument
  end subroutine refuse

  subroutine batch_sizes()
    integer(i8), parameter :: all_contacts = contacts
    call fresh()
    call refuse('batch: contacts beyond any memory', far, CTE_ERROR_STRIDE, CTE_ARGUMENT_X)
    call refuse('batch: -1 contacts', -1_i8, CTE_ERROR_INDEX, CTE_ARGUMENT_BATCH)
    call fresh()
    batch%f_element_stride = far
    call refuse('batch: f stride beyond any memory', all_contacts, CTE_ERROR_STRIDE, CTE_ARGUMENT_F)
    call fresh()
    batch%k_element_stride = ishft(far, -1)
    call refuse('batch: k stride beyond any memory', all_contacts, CTE_ERROR_STRIDE, CTE_ARGUMENT_K_STRIDE)
    call fresh()
    batch%parameter_element_stride = b%info%parameters - 1
    call refuse('batch: parameters overlap', all_contacts, CTE_ERROR_STRIDE, CTE_ARGUMENT_PARAMETERS)
    call fresh()
    batch%x_node_stride = far
    batch%x_component_stride = far
    batch%x_element_stride = far
    call refuse('batch: x strides beyond any memory', all_contacts, CTE_ERROR_STRIDE, CTE_ARGUMENT_X)
    call fresh()
    batch%x_node_stride = 3
    call refuse('batch: x strides half given', all_contacts, CTE_ERROR_STRIDE, CTE_ARGUMENT_X)
    call fresh()
    batch%x_element_stride = n - 1
    call refuse('batch: x overlaps', all_contacts, CTE_ERROR_STRIDE, CTE_ARGUMENT_X)
  end subroutine batch_sizes

  ! The second contact is the first to fail; its slots stay as they were.
  subroutine batch_failures()
    integer(i4) :: found
    logical :: same
    integer :: e
    call fresh()
    call client_special(1, x(5, 2))
    call client_special(1, x(1, 3))
    found = cte_element_evaluate_batch(b%element, int(contacts, i8), batch)
    call client_check(found == CTE_CUT_BACK .and. batch%failed == 2 .and. batch%error_argument == CTE_ARGUMENT_X &
      .and. batch%error_index == 1, 'batch: the first failing contact')
    call client_check(all(code == [CTE_SUCCESS, CTE_ERROR_NOT_FINITE, CTE_ERROR_NOT_FINITE]) &
      .and. status(1) == CTE_STATUS_CLOSED, 'batch: a code for each')
    same = .not. (client_same(f(:1, 1), [canary()]) .or. client_same(k(:1, 1), [canary()]))
    do e = 2, contacts
      same = same .and. client_same(f(:, e), spread(canary(), 1, n)) .and. client_same(k(:, e), spread(canary(), 1, n*n))
    end do
    call client_check(same, 'batch: slots of failing contacts untouched')
    batch%x = c_null_ptr
    batch%parameters = c_null_ptr
    batch%status = c_null_ptr
    found = cte_element_evaluate_batch(b%element, 0_i8, batch)
    call client_check(found == CTE_SUCCESS .and. batch%failed == 0, 'batch: no contacts, no arrays')
    batch%error_argument = untouched
    found = cte_element_evaluate_batch(c_null_ptr, 0_i8, batch)
    call client_check(found == CTE_ERROR_NULL .and. batch%error_argument == CTE_ARGUMENT_ELEMENT, &
      'batch: element null is named')
  end subroutine batch_failures

  subroutine bad_states_run()
    if (cte_api(CTE_VERSION_MAJOR, api) /= CTE_SUCCESS) then
      call client_check(.false., 'cte_api')
      return
    end if
    call axes()
    call no_area()
    call folds()
    call huge_forces()
    call counts()
    call strides()
    call scalars()
    call bench_open(b, 'PointQuad4')
    if (.not. c_associated(b%element)) return
    call short_struct()
    call batch_sizes()
    call batch_failures()
  end subroutine bad_states_run

end module bad_states
