! interface_batch.f90 - batches in every layout against single calls, bit for bit.
!
! A strip of facets with one slave point above each; some are closed, some open, one is outside.
module interface_batch
  use, intrinsic :: iso_c_binding, only: c_associated, c_loc, c_null_ptr
  use contact_elements
  use client_support
  implicit none
  private
  public :: interface_batch_run

  integer, parameter :: contacts = 7
  integer, parameter :: n = 15                      ! unknowns of an element
  integer, parameter :: strip_nodes = 2*(contacts + 1) ! nodes of the facets
  integer, parameter :: nodes = strip_nodes + contacts ! and the slaves
  integer, parameter :: rows = 3*nodes
  integer, parameter :: history = 3
  integer(i4), parameter :: request = CTE_RESIDUAL + CTE_TANGENT + CTE_HISTORY + CTE_OUTPUT + CTE_ENERGY

  type :: results
    real(dp) :: f(n, contacts), k(n*n, contacts)
    real(dp) :: history_trial(history, contacts), output(CTE_OUTPUT_SIZE, contacts), energy(contacts)
    integer(i4) :: status(contacts), code(contacts)
  end type results

  type(bench), save, target :: b
  type(cte_batch), save :: batch
  type(results), save, target :: single, many
  real(dp), save, target :: x(3, 0:nodes - 1), u(3, 0:nodes - 1), history_accepted(history, contacts)
  integer(i4), save, target :: connectivity(5, contacts)
  real(dp), save, target :: workspace(room_workspace)

contains

  subroutine lay_out()
    integer :: i, c, e, side
    do i = 0, nodes - 1
      do c = 1, 3
        call client_random(u(c, i))
        u(c, i) = 0.02_dp*(u(c, i) - 0.5_dp)
      end do
    end do
    do e = 0, contacts
      do side = 0, 1
        x(:, 2*e + side) = [real(dp) :: e, side, 0]
      end do
    end do
    do e = 0, contacts - 1
      connectivity(:, e + 1) = [strip_nodes + e, 2*e, 2*e + 2, 2*e + 3, 2*e + 1]
      x(1, strip_nodes + e) = e + merge(1.5_dp, 0.4_dp, e == 5)
      x(2, strip_nodes + e) = 0.6_dp
      x(3, strip_nodes + e) = merge(0.1_dp, -0.05_dp, mod(e, 3) == 2)
      if (cte_element_history_init(b%element, history_accepted(:, e + 1)) /= CTE_SUCCESS) return
    end do
  end subroutine lay_out

  ! Every contact by itself, from its own dense arrays.
  function single_calls() result(pass)
    logical :: pass
    integer :: e
    pass = .true.
    do e = 1, contacts
      b%x(:n) = reshape(x(:, connectivity(:, e)), [n])
      b%u(:n) = reshape(u(:, connectivity(:, e)), [n])
      b%a%history_accepted = c_loc(history_accepted(1, e))
      b%a%f = c_loc(single%f(1, e))
      b%a%k = c_loc(single%k(1, e))
      b%a%history_trial = c_loc(single%history_trial(1, e))
      b%a%output = c_loc(single%output(1, e))
      b%a%energy = c_loc(single%energy(e))
      pass = bench_evaluate(b) == CTE_SUCCESS .and. pass
      single%status(e) = b%a%status
      single%code(e) = CTE_SUCCESS
    end do
    pass = pass .and. single%status(1) == CTE_STATUS_CLOSED .and. single%status(3) == CTE_STATUS_OPEN &
      .and. single%status(6) == CTE_STATUS_OUTSIDE
  end function single_calls

  ! One call has no scatter map: the bit that says which changes nothing.
  subroutine one_call()
    logical :: pass
    b%a%request = b%a%request + CTE_CSR_BY_BLOCKS
    b%a%f = c_loc(many%f(1, contacts))
    b%a%k = c_loc(many%k(1, contacts))
    pass = bench_evaluate(b) == CTE_SUCCESS
    pass = pass .and. client_same(many%f(:, contacts), single%f(:, contacts)) &
      .and. client_same(many%k(:, contacts), single%k(:, contacts))
    call client_check(pass, 'CTE_CSR_BY_BLOCKS has no effect on one call')
  end subroutine one_call

  subroutine fresh()
    type(cte_batch) :: zero
    batch = zero
    many%f = canary()
    many%k = canary()
    many%history_trial = canary()
    many%output = canary()
    many%energy = canary()
    many%status = -77
    many%code = -77
    batch%request = request
    batch%parameter_count = b%info%parameters
    batch%x = c_loc(x)
    batch%u = c_loc(u)
    batch%connectivity = c_loc(connectivity)
    batch%global_nodes = nodes
    batch%parameters = c_loc(b%parameters)
    batch%history_accepted = c_loc(history_accepted)
    batch%history_trial = c_loc(many%history_trial)
    batch%f = c_loc(many%f)
    batch%k = c_loc(many%k)
    batch%output = c_loc(many%output)
    batch%energy = c_loc(many%energy)
    batch%status = c_loc(many%status)
    batch%code = c_loc(many%code)
    batch%workspace = c_loc(workspace)
    batch%workspace_size = cte_element_batch_workspace(b%element, 0)
  end subroutine fresh

  function evaluated() result(pass)
    logical :: pass
    pass = batch%workspace_size <= room_workspace
    if (pass) pass = cte_element_evaluate_batch(b%element, int(contacts, i8), batch) == CTE_SUCCESS
    pass = pass .and. batch%failed == 0 .and. batch%error_argument == CTE_ARGUMENT_NONE
  end function evaluated

  ! The whole batch has the bits of the single calls.
  function same_results() result(pass)
    logical :: pass
    pass = evaluated()
    pass = pass .and. all(transfer(many, [0_i8]) == transfer(single, [0_i8]))
  end function same_results

  subroutine gathered()
    real(dp), target :: by_component(0:nodes - 1, 3, 2)
    integer(i4) :: threads
    logical :: pass
    call fresh()
    call client_check(same_results(), 'batch: gathered by connectivity')
    do threads = 0, 2
      call fresh()
      pass = cte_element_evaluate_batch_threads(b%element, int(contacts, i8), batch, threads) == CTE_SUCCESS
      pass = pass .and. batch%failed == 0 .and. all(transfer(many, [0_i8]) == transfer(single, [0_i8]))
      call client_check(pass, 'batch: by threads')
    end do
    call fresh()
    by_component(:, :, 1) = transpose(x)
    by_component(:, :, 2) = transpose(u)
    batch%x_node_stride = 1
    batch%u_node_stride = 1
    batch%x_component_stride = nodes
    batch%u_component_stride = nodes
    batch%x = c_loc(by_component)
    batch%u = c_loc(by_component(0, 1, 2))
    call client_check(same_results(), 'batch: gathered, components apart')
  end subroutine gathered

  ! Dense [element][node][component], then the element index fastest.
  subroutine arrays()
    real(dp), save, target :: dense(3, 5, contacts, 2), fastest(contacts, 3, 5, 2)
    integer :: e, a
    do e = 1, contacts
      do a = 1, 5
        dense(:, a, e, 1) = x(:, connectivity(a, e))
        dense(:, a, e, 2) = u(:, connectivity(a, e))
        fastest(e, :, a, :) = dense(:, a, e, :)
      end do
    end do
    call fresh()
    batch%connectivity = c_null_ptr
    batch%x = c_loc(dense)
    batch%u = c_loc(dense(1, 1, 1, 2))
    call client_check(same_results(), 'batch: dense arrays')
    call fresh()
    batch%connectivity = c_null_ptr
    batch%x = c_loc(fastest)
    batch%u = c_loc(fastest(1, 1, 1, 2))
    batch%x_element_stride = 1
    batch%u_element_stride = 1
    batch%x_node_stride = 3*contacts
    batch%u_node_stride = 3*contacts
    batch%x_component_stride = contacts
    batch%u_component_stride = contacts
    call client_check(same_results(), 'batch: element index fastest')
  end subroutine arrays

  ! Every contact its own penalty: a factor 2 in every other one, which is exact.
  subroutine own_parameters()
    real(dp), save, target :: parameters(room_parameters, contacts)
    integer :: eps_n
    logical :: pass
    eps_n = bench_parameter(b, 'eps_n') + 1
    call fresh()
    parameters = spread(b%parameters, 2, contacts)
    parameters(eps_n, 2::2) = 2*parameters(eps_n, 2::2)
    batch%parameters = c_loc(parameters)
    batch%parameter_element_stride = room_parameters
    pass = evaluated()
    many%f(:, 2::2) = many%f(:, 2::2)/2
    many%k(:, 2::2) = many%k(:, 2::2)/2
    many%output(CTE_OUTPUT_NORMAL_TRACTION + 1, 2::2) = many%output(CTE_OUTPUT_NORMAL_TRACTION + 1, 2::2)/2
    many%energy(2::2) = many%energy(2::2)/2
    call client_check(pass .and. all(transfer(many, [0_i8]) == transfer(single, [0_i8])), 'batch: own parameters')
  end subroutine own_parameters

  ! Room between the outputs of two elements, scaled.
  subroutine spaced()
    real(dp), save, target :: f(n + 2, contacts), k(n*n + 3, contacts)
    logical :: pass
    call fresh()
    batch%f = c_loc(f)
    batch%k = c_loc(k)
    batch%f_element_stride = n + 2
    batch%k_element_stride = n*n + 3
    batch%f_scale = -1
    batch%k_scale = -0.5_dp
    f = canary()
    k = canary()
    pass = evaluated()
    pass = pass .and. all(abs(f(:n, :) + single%f) <= 0) .and. all(abs(k(:n*n, :) + 0.5_dp*single%k) <= 0)
    pass = pass .and. client_same(f(n + 2, :), spread(canary(), 1, contacts)) &
      .and. client_same(k(n*n + 3, :), spread(canary(), 1, contacts))
    call client_check(pass, 'batch: output strides, f_scale -1, k_scale -1/2')
    batch%f_scale = 0
    batch%k_scale = 0
    pass = evaluated()
    call client_check(pass .and. all(abs(f(:n, :)) <= 0) .and. all(abs(k(:n*n, :)) <= 0), 'batch: scales of 0 give zeros')
  end subroutine spaced

  ! Pattern of all contacts: [rows][...] sorted; rows, columns and positions from 0.
  subroutine pattern(row_start, column)
    integer(i8), intent(out) :: row_start(0:rows)
    integer(i4), intent(out) :: column(0:rows*rows - 1)
    logical :: together(0:nodes - 1, 0:nodes - 1)
    integer :: e, row, col
    integer(i8) :: entries
    together = .false.
    do e = 1, contacts
      together(connectivity(:, e), connectivity(:, e)) = .true.
    end do
    entries = 0
    column = 0
    do row = 0, rows - 1
      row_start(row) = entries
      do col = 0, rows - 1
        if (.not. together(row/3, col/3)) cycle
        column(entries) = col
        entries = entries + 1
      end do
    end do
    row_start(rows) = entries
  end subroutine pattern

  ! The same sums by hand, element after element.
  subroutine assemble(global_f, global_k)
    real(dp), intent(inout) :: global_f(0:rows - 1), global_k(0:rows - 1, 0:rows - 1)
    integer :: e, a, c, row(n)
    do e = 1, contacts
      row = [((3*connectivity(a, e) + c, c=0, 2), a=1, 5)]
      global_f(row) = global_f(row) + single%f(:, e)
      global_k(row, row) = global_k(row, row) + transpose(reshape(single%k(:, e), [n, n]))
    end do
  end subroutine assemble

  ! The first entry of each block and the distance of its rows give every place of the map.
  function same_places(map, blocks) result(pass)
    integer(i8), intent(in) :: map(0:n - 1, 0:n - 1, contacts), blocks(0:5, 0:4, contacts)
    logical :: pass
    integer :: e, a, i, j
    pass = .true.
    do e = 1, contacts
      do a = 0, 4
        do i = 0, 2
          do j = 0, 2
            pass = pass .and. all(map(j::3, 3*a + i, e) == blocks(:4, a, e) + i*blocks(5, a, e) + j)
          end do
        end do
      end do
    end do
  end function same_places

  ! The batch into values of the host, which are to be those of global_k and the first column of global_f.
  function scatters(row_start, column, global_f, global_k) result(pass)
    integer(i8), intent(in) :: row_start(0:rows)
    integer(i4), intent(in) :: column(0:rows*rows - 1)
    real(dp), intent(inout), target :: global_f(0:rows - 1, 2)
    real(dp), intent(in) :: global_k(0:rows - 1, 0:rows - 1)
    logical :: pass
    real(dp), save, target :: values(0:rows*rows - 1)
    integer :: row
    global_f(:, 2) = 1
    values = 2
    batch%f = c_null_ptr
    batch%k = c_null_ptr
    batch%global_f = c_loc(global_f(0, 2))
    batch%csr_values = c_loc(values)
    pass = evaluated()
    pass = pass .and. client_same(global_f(:, 1), global_f(:, 2))
    do row = 0, rows - 1
      associate (first => row_start(row), last => row_start(row + 1) - 1)
        pass = pass .and. client_same(values(first:last), global_k(row, column(first:last)))
      end associate
    end do
  end function scatters

  subroutine other_outputs()
    call client_check(all(transfer(many%history_trial, [0_i8]) == transfer(single%history_trial, [0_i8])) &
      .and. all(transfer(many%output, [0_i8]) == transfer(single%output, [0_i8])) &
      .and. client_same(many%energy, single%energy), 'batch: scattered, the other outputs')
  end subroutine other_outputs

  ! Into values of the host, by either map.
  subroutine scattered()
    real(dp), save, target :: global_f(0:rows - 1, 2)
    real(dp), save :: global_k(0:rows - 1, 0:rows - 1)
    integer(i8), save :: row_start(0:rows)
    integer(i8), save, target :: map(n*n*contacts), blocks(6*5*contacts)
    integer(i4), save :: column(0:rows*rows - 1)
    logical :: pass
    call pattern(row_start, column)
    pass = cte_csr_map(b%element, int(contacts, i8), 0, connectivity, int(rows, i8), row_start, column, map) &
      == CTE_SUCCESS
    call client_check(pass, 'csr_map')
    pass = cte_csr_blocks(b%element, int(contacts, i8), 0, connectivity, int(rows, i8), row_start, column, blocks) &
      == CTE_SUCCESS .and. pass
    if (pass) pass = same_places(map, blocks)
    call client_check(pass, 'csr_blocks: the places of csr_map')
    if (.not. pass) return
    global_f = 1 ! what the host has already
    global_k = 2
    call assemble(global_f(:, 1), global_k)
    call fresh()
    batch%csr_map = c_loc(map)
    call client_check(scatters(row_start, column, global_f, global_k), 'batch: scattered into vector and CSR matrix')
    call other_outputs()
    call fresh()
    batch%csr_map = c_loc(blocks)
    batch%request = batch%request + CTE_CSR_BY_BLOCKS
    call client_check(scatters(row_start, column, global_f, global_k), 'batch: scattered by blocks of nodes')
    call other_outputs()
  end subroutine scattered

  ! One contact that cannot be evaluated leaves the others valid.
  subroutine one_failure()
    real(dp), save, target :: dense(3, 5, contacts), shift(3, 5, contacts)
    integer(i4) :: code
    integer :: e, a
    logical :: pass
    call fresh()
    do e = 1, contacts
      dense(:, :, e) = x(:, connectivity(:, e))
      shift(:, :, e) = u(:, connectivity(:, e))
    end do
    do a = 2, 5 ! the facet of contact 1 shrinks to a point
      dense(:, a, 2) = dense(:, 2, 2)
      shift(:, a, 2) = shift(:, 2, 2)
    end do
    batch%connectivity = c_null_ptr
    batch%x = c_loc(dense)
    batch%u = c_loc(shift)
    code = cte_element_evaluate_batch(b%element, int(contacts, i8), batch)
    pass = code == CTE_CUT_BACK .and. batch%failed == 1 .and. many%code(2) == CTE_CUT_BACK &
      .and. any(many%status(2) == [CTE_STATUS_DEGENERATE, CTE_STATUS_NOT_UNIQUE])
    do e = 1, contacts
      if (e == 2) cycle
      pass = pass .and. many%code(e) == CTE_SUCCESS .and. many%status(e) == single%status(e) &
        .and. client_same(many%f(:, e), single%f(:, e)) .and. client_same(many%k(:, e), single%k(:, e)) &
        .and. client_same(many%history_trial(:, e), single%history_trial(:, e))
    end do
    call client_check(pass, 'batch: one contact fails, the others are valid')
  end subroutine one_failure

  subroutine interface_batch_run()
    logical :: pass
    call bench_open(b, 'PointQuad4')
    if (.not. c_associated(b%element)) return
    call lay_out()
    pass = single_calls()
    call client_check(pass .and. b%info%history == history, 'batch: the single calls')
    call one_call()
    call gathered()
    call arrays()
    call own_parameters()
    call spaced()
    call scattered()
    call one_failure()
    call fresh()
    pass = cte_element_evaluate_batch(b%element, 0_i8, batch) == CTE_SUCCESS
    call client_check(pass .and. batch%failed == 0, 'batch: no contacts')
  end subroutine interface_batch_run

end module interface_batch
