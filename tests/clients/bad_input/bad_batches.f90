! bad_batches.f90 - bad input to batches; see bad_input.f90.
module bad_batches
  use, intrinsic :: iso_c_binding, only: c_associated, c_loc, c_null_ptr, c_sizeof
  use contact_elements
  use client_support
  implicit none
  private
  public :: bad_batches_run

  integer, parameter :: contacts = 2, nodes = 6, rows = 3*nodes, unknowns = 15, entries = rows*rows

  ! The arrays a batch writes.
  type :: batch_outputs
    real(dp) :: f(contacts*unknowns), k(contacts*unknowns**2)
    real(dp) :: history_trial(contacts*room_history), output(contacts*CTE_OUTPUT_SIZE), energy(contacts)
    real(dp) :: global_f(rows), csr_values(entries)
    integer(i4) :: status(contacts), code(contacts)
  end type batch_outputs

  type(bench), save, target :: b
  type(cte_batch), save :: batch
  type(batch_outputs), save, target :: out
  type(batch_outputs), save :: before_out
  real(dp), save, target :: x(rows), u(rows), history_accepted(contacts*room_history)
  integer(i4), save, target :: connectivity(contacts*5), column(entries)
  integer(i8), save, target :: row_start(rows + 1), map(contacts*unknowns**2)

contains

  ! Two slave points (nodes 0 and 1) on one facet (nodes 2 to 5), and a full matrix for a pattern.
  subroutine lay_out()
    integer :: i
    connectivity = [0, 2, 3, 4, 5, 1, 2, 3, 4, 5]
    x(4:18) = b%x(:15)
    x(:3) = b%x(:3)
    x(1) = x(1) + 0.1_dp
    u = 0
    history_accepted = 0
    row_start = [(int(i*rows, i8), i=0, rows)]
    column = [(int(mod(i, rows), i4), i=0, entries - 1)]
  end subroutine lay_out

  subroutine fresh()
    type(cte_batch) :: zero
    call lay_out()
    batch = zero
    batch%request = CTE_RESIDUAL + CTE_TANGENT + CTE_HISTORY + CTE_OUTPUT + CTE_ENERGY
    batch%parameter_count = b%info%parameters
    batch%x = c_loc(x)
    batch%u = c_loc(u)
    batch%connectivity = c_loc(connectivity)
    batch%global_nodes = nodes
    batch%parameters = c_loc(b%parameters)
    batch%history_accepted = c_loc(history_accepted)
    batch%history_trial = c_loc(out%history_trial)
    batch%f = c_loc(out%f)
    batch%k = c_loc(out%k)
    batch%global_f = c_loc(out%global_f)
    batch%csr_values = c_loc(out%csr_values)
    batch%csr_map = c_loc(map)
    batch%output = c_loc(out%output)
    batch%energy = c_loc(out%energy)
    batch%status = c_loc(out%status)
    batch%code = c_loc(out%code)
    batch%workspace = c_loc(b%workspace)
    batch%workspace_size = cte_element_batch_workspace(b%element, 0)
    out%f = canary()
    out%k = canary()
    out%history_trial = canary()
    out%output = canary()
    out%energy = canary()
    out%global_f = canary()
    out%csr_values = canary()
    out%status = -77
    out%code = -77
    before_out = out
  end subroutine fresh

  function untouched() result(same)
    logical :: same
    same = all(transfer(out, [0_i8]) == transfer(before_out, [0_i8]))
  end function untouched

  subroutine expect(what, code, argument)
    character(len=*), intent(in) :: what
    integer(i4), intent(in) :: code, argument
    integer(i4) :: found
    logical :: pass
    found = cte_element_evaluate_batch(b%element, int(contacts, i8), batch)
    pass = found == code .and. batch%error_argument == argument .and. untouched()
    call client_check(pass, what)
    if (.not. pass) print '(4(a,i0),a,l1)', '     code ', found, ' wanted ', code, ', argument ', &
      batch%error_argument, ' wanted ', argument, ', untouched: ', untouched()
  end subroutine expect

  ! The caller's fault in the last `failed` contacts: either the whole batch is refused and untouched, or
  ! those alone have the code.
  subroutine expect_of_last(what, code, argument, failed)
    character(len=*), intent(in) :: what
    integer(i4), intent(in) :: code, argument
    integer, intent(in) :: failed
    integer(i4) :: found, wanted(contacts)
    logical :: refused, alone
    found = cte_element_evaluate_batch(b%element, int(contacts, i8), batch)
    wanted = code
    wanted(:contacts - failed) = CTE_SUCCESS
    refused = found == code .and. untouched()
    alone = found == CTE_CUT_BACK .and. batch%failed == failed .and. all(out%code == wanted)
    call client_check((refused .or. alone) .and. batch%error_argument == argument, what)
  end subroutine expect_of_last

  subroutine null_pointers()
    call fresh()
    batch%x = c_null_ptr
    call expect('batch: x null', CTE_ERROR_NULL, CTE_ARGUMENT_X)
    call fresh()
    batch%parameters = c_null_ptr
    call expect('batch: parameters null', CTE_ERROR_NULL, CTE_ARGUMENT_PARAMETERS)
    call fresh()
    batch%status = c_null_ptr
    call expect('batch: status null', CTE_ERROR_NULL, CTE_ARGUMENT_STATUS)
    call fresh()
    batch%f = c_null_ptr
    batch%global_f = c_null_ptr
    call expect('batch: f and global_f null', CTE_ERROR_NULL, CTE_ARGUMENT_F)
    call fresh()
    batch%k = c_null_ptr
    batch%csr_values = c_null_ptr
    call expect('batch: k and csr_values null', CTE_ERROR_NULL, CTE_ARGUMENT_K)
    call fresh()
    batch%csr_map = c_null_ptr
    call expect('batch: csr_map null', CTE_ERROR_NULL, CTE_ARGUMENT_CSR)
    batch%request = batch%request + CTE_CSR_BY_BLOCKS
    call expect('batch: csr_map of blocks null', CTE_ERROR_NULL, CTE_ARGUMENT_CSR)
    call fresh()
    batch%history_trial = c_null_ptr
    call expect('batch: history_trial null', CTE_ERROR_NULL, CTE_ARGUMENT_HISTORY_TRIAL)
    call fresh()
    batch%output = c_null_ptr
    call expect('batch: output null', CTE_ERROR_NULL, CTE_ARGUMENT_OUTPUT)
    call fresh()
    batch%energy = c_null_ptr
    call expect('batch: energy null', CTE_ERROR_NULL, CTE_ARGUMENT_ENERGY)
  end subroutine null_pointers

  subroutine struct_sizes()
    type(cte_batch) :: before
    integer(i4) :: sizes(4), found ! the last: that of interface 0.1
    integer :: i
    sizes = [0_i4, 8_i4, int(c_sizeof(batch), i4) - 1_i4, 336_i4]
    do i = 1, 4
      call fresh()
      batch%struct_size = sizes(i)
      before = batch
      found = cte_element_evaluate_batch(b%element, int(contacts, i8), batch)
      call client_check(found == CTE_ERROR_STRUCT_SIZE .and. untouched() &
        .and. all(transfer(before, [0_i8]) == transfer(batch, [0_i8])), &
        client_text('batch: struct_size', int(sizes(i), i8)))
    end do
  end subroutine struct_sizes

  subroutine counts()
    integer(i4), parameter :: wrong_node(4) = [-1_i4, int(nodes, i4), huge(0_i4), -huge(0_i4) - 1_i4]
    integer(i4) :: found
    integer :: i
    do i = 1, 4
      call fresh()
      connectivity(8) = wrong_node(i)
      call expect(client_text('batch: connectivity', int(wrong_node(i), i8)), CTE_ERROR_INDEX, &
        CTE_ARGUMENT_CONNECTIVITY)
    end do
    call fresh()
    batch%request = ior(batch%request, 1024)
    call expect('batch: unknown request bit', CTE_ERROR_REQUEST, CTE_ARGUMENT_REQUEST)
    call fresh()
    batch%nslave = 2
    call expect('batch: nslave', CTE_ERROR_NODE_COUNT, CTE_ARGUMENT_NSLAVE)
    call fresh()
    batch%parameter_count = b%info%parameters - 1
    call expect_of_last('batch: one parameter too few', CTE_ERROR_PARAMETER, CTE_ARGUMENT_PARAMETERS, 2)
    call fresh()
    if (batch%workspace_size > 0) then
      batch%workspace_size = batch%workspace_size - 1
      call expect('batch: workspace too small', CTE_ERROR_WORKSPACE, CTE_ARGUMENT_WORKSPACE)
    end if
    call fresh()
    found = cte_element_evaluate_batch(b%element, -1_i8, batch)
    call client_check(found < 0 .and. untouched(), 'batch: -1 contacts')
    found = cte_element_evaluate_batch(c_null_ptr, int(contacts, i8), batch)
    call client_check(found == CTE_ERROR_NULL .and. untouched(), 'batch: element null')
    found = cte_element_evaluate_batch_threads(b%element, int(contacts, i8), batch, -1)
    call client_check(found == CTE_ERROR_INDEX .and. batch%error_argument == CTE_ARGUMENT_THREADS &
                      .and. untouched(), 'batch: -1 threads')
  end subroutine counts

  subroutine strides()
    call fresh()
    batch%connectivity = c_null_ptr
    batch%global_f = c_null_ptr
    batch%csr_values = c_null_ptr
    batch%x_element_stride = 15
    batch%x_node_stride = -3
    batch%x_component_stride = 1
    call expect('batch: x stride negative', CTE_ERROR_STRIDE, CTE_ARGUMENT_X)
    batch%x_node_stride = 3
    batch%u_element_stride = -15
    batch%u_node_stride = 3
    batch%u_component_stride = 1
    call expect('batch: u stride negative', CTE_ERROR_STRIDE, CTE_ARGUMENT_U)
    call fresh()
    batch%f_element_stride = unknowns - 1
    call expect('batch: f overlaps', CTE_ERROR_STRIDE, CTE_ARGUMENT_F)
    call fresh()
    batch%f_element_stride = -unknowns
    call expect('batch: f stride negative', CTE_ERROR_STRIDE, CTE_ARGUMENT_F)
    call fresh()
    batch%k_element_stride = unknowns**2 - 1
    call expect('batch: k overlaps', CTE_ERROR_STRIDE, CTE_ARGUMENT_K_STRIDE)
  end subroutine strides

  subroutine not_finite()
    integer :: special
    do special = 1, client_specials
      call fresh()
      call client_special(special, x(5)) ! node 1: the slave of the second contact
      call expect_of_last(client_text('batch: not finite in x', int(special - 1, i8)), CTE_ERROR_NOT_FINITE, &
        CTE_ARGUMENT_X, 1)
    end do
  end subroutine not_finite

  subroutine bad_batches_run()
    integer(i4) :: code
    call bench_open(b, 'PointQuad4')
    if (.not. c_associated(b%element)) return
    call lay_out()
    code = cte_csr_map(b%element, int(contacts, i8), 0, connectivity, int(rows, i8), row_start, column, map)
    call client_check(code == CTE_SUCCESS, 'csr_map of the sound batch')
    call fresh()
    call client_check(cte_element_evaluate_batch(b%element, int(contacts, i8), batch) == CTE_SUCCESS, &
      'the sound batch')
    call null_pointers()
    call struct_sizes()
    call counts()
    call strides()
    call not_finite()
  end subroutine bad_batches_run

end module bad_batches
