! interface_multiplier_batch.f90 - a batch of elements with multipliers as unknowns against single calls, bit for bit.
!
! A strip of facets with one slave above each, and a node for the multiplier of each, of which the host's system has
! one row: the other two are in no pattern.
module interface_multiplier_batch
  use, intrinsic :: iso_c_binding, only: c_associated, c_loc, c_null_ptr
  use contact_elements
  use client_support
  implicit none
  private
  public :: interface_multiplier_batch_run

  integer, parameter :: contacts = 7
  integer, parameter :: n = 16, per = 6                ! unknowns and nodes of an element
  integer, parameter :: slaves = 2*(contacts + 1)      ! first node of the slaves, behind those of the facets
  integer, parameter :: multipliers = slaves + contacts ! first node of the multipliers
  integer, parameter :: nodes = multipliers + contacts, rows = 3*nodes
  integer, parameter :: history = 3

  type :: results
    real(dp) :: f(n, contacts), k(n*n, contacts)
    real(dp) :: history_trial(history, contacts), output(CTE_OUTPUT_SIZE, contacts), energy(contacts)
    integer(i4) :: status(contacts), code(contacts)
  end type results

  type(bench), save, target :: b
  type(cte_batch), save :: batch
  type(results), save, target :: single, many
  real(dp), save, target :: x(3, 0:nodes - 1), u(3, 0:nodes - 1), history_accepted(history, contacts)
  integer(i4), save, target :: connectivity(per, contacts)

contains

  ! Slaves in the facets, over them, one beside; multipliers of both signs. Entries that are not read are NaN.
  subroutine lay_out()
    integer :: i, c, e, node
    do e = 0, contacts
      do i = 0, 1
        x(:, 2*e + i) = [real(dp) :: e, i, 0]
      end do
    end do
    do i = 0, multipliers - 1
      do c = 1, 3
        call client_random(u(c, i))
        u(c, i) = 0.02_dp*(u(c, i) - 0.5_dp)
      end do
    end do
    do e = 0, contacts - 1
      node = multipliers + contacts - 1 - e
      connectivity(:, e + 1) = [slaves + e, 2*e, 2*e + 2, 2*e + 3, 2*e + 1, node]
      x(:, slaves + e) = [e + merge(1.5_dp, 0.4_dp, e == 5), 0.6_dp, merge(0.1_dp, -0.05_dp, mod(e, 3) == 2)]
      do c = 1, 3
        call client_special(2, x(c, node))
        call client_special(2, u(c, node))
      end do
      u(1, node) = merge(20.0_dp, -4.0_dp - e, e == 3) ! contact 3 is pulled open
      if (cte_element_history_init(b%element, history_accepted(:, e + 1)) /= CTE_SUCCESS) return
    end do
  end subroutine lay_out

  ! The nodes of a contact from a global array; assigned as integers, so that a NaN keeps its bits.
  subroutine copy(from, e, to)
    real(dp), intent(in) :: from(3, 0:nodes - 1)
    integer, intent(in) :: e
    real(dp), intent(inout) :: to(3, per)
    integer :: a
    do a = 1, per
      to(:, a) = transfer(transfer(from(:, connectivity(a, e)), [0_i8]), to(:, a))
    end do
  end subroutine copy

  ! Every contact by itself, from its own dense arrays.
  function single_calls() result(pass)
    logical :: pass
    integer(i4), parameter :: status(contacts) = [CTE_STATUS_CLOSED, CTE_STATUS_CLOSED, CTE_STATUS_OPEN, &
      CTE_STATUS_OPEN, CTE_STATUS_CLOSED, CTE_STATUS_OUTSIDE, CTE_STATUS_CLOSED]
    integer :: e
    pass = .true.
    do e = 1, contacts
      call copy(x, e, b%x(:3*per))
      call copy(u, e, b%u(:3*per))
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
    pass = pass .and. all(single%status == status)
  end function single_calls

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
    batch%request = b%a%request
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
  end subroutine fresh

  function evaluated() result(pass)
    logical :: pass
    pass = cte_element_batch_workspace(b%element, 0) == 0
    if (pass) pass = cte_element_evaluate_batch(b%element, int(contacts, i8), batch) == CTE_SUCCESS
    pass = pass .and. batch%failed == 0
  end function evaluated

  ! The whole batch has the bits of the single calls.
  function same_results() result(pass)
    logical :: pass
    pass = evaluated()
    pass = pass .and. all(transfer(many, [0_i8]) == transfer(single, [0_i8]))
  end function same_results

  subroutine arrays()
    real(dp), save, target :: dense(3, per, contacts, 2)
    integer :: e
    call fresh()
    call client_check(same_results(), 'multiplier batch: gathered by connectivity')
    do e = 1, contacts
      call copy(x, e, dense(:, :, e, 1))
      call copy(u, e, dense(:, :, e, 2))
    end do
    call fresh()
    batch%connectivity = c_null_ptr
    batch%x = c_loc(dense)
    batch%u = c_loc(dense(1, 1, 1, 2))
    call client_check(same_results(), 'multiplier batch: dense arrays')
  end subroutine arrays

  ! Rows of an element's unknowns in the host's system: node * dimension + component, of multipliers component 0.
  pure function rows_of(e) result(row)
    integer, intent(in) :: e
    integer :: row(n), a, c
    row = [((3*connectivity(a, e) + c, c=0, 2), a=1, per - 1), 3*connectivity(per, e)]
  end function rows_of

  ! Pattern of all contacts: [rows][...] sorted; rows, columns and positions from 0.
  subroutine pattern(row_start, column)
    integer(i8), intent(out) :: row_start(0:rows)
    integer(i4), intent(out) :: column(0:rows*rows - 1)
    logical :: together(0:rows - 1, 0:rows - 1)
    integer :: e, row, col
    integer(i8) :: entries
    together = .false.
    do e = 1, contacts
      together(rows_of(e), rows_of(e)) = .true.
    end do
    entries = 0
    column = 0
    do row = 0, rows - 1
      row_start(row) = entries
      do col = 0, rows - 1
        if (.not. together(row, col)) cycle
        column(entries) = col
        entries = entries + 1
      end do
    end do
    row_start(rows) = entries
  end subroutine pattern

  ! The same sums by hand, element after element.
  subroutine assemble(global_f, global_k)
    real(dp), intent(inout) :: global_f(0:rows - 1), global_k(0:rows - 1, 0:rows - 1)
    integer :: e, row(n)
    do e = 1, contacts
      row = rows_of(e)
      global_f(row) = global_f(row) + single%f(:, e)
      global_k(row, row) = global_k(row, row) + transpose(reshape(single%k(:, e), [n, n]))
    end do
  end subroutine assemble

  ! The first entry of each block and the distance of its rows give every place of the map; a multiplier has one row.
  function same_places(map, blocks) result(pass)
    integer(i8), intent(in) :: map(0:n - 1, 0:n - 1, contacts), blocks(0:per, 0:per - 1, contacts)
    logical :: pass
    integer :: e, i, j
    pass = all(blocks(per, per - 1, :) == 0)
    do e = 1, contacts
      do i = 0, n - 1
        do j = 0, n - 1
          pass = pass .and. map(j, i, e) == blocks(j/3, i/3, e) + mod(i, 3)*blocks(per, i/3, e) + mod(j, 3)
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
    pass = pass .and. all(abs(global_f(3*multipliers + 1::3, 2) - 1) <= 0) &
      .and. all(abs(global_f(3*multipliers + 2::3, 2) - 1) <= 0)
  end function scatters

  subroutine other_outputs()
    call client_check(all(transfer(many%history_trial, [0_i8]) == transfer(single%history_trial, [0_i8])) &
      .and. all(transfer(many%output, [0_i8]) == transfer(single%output, [0_i8])) &
      .and. client_same(many%energy, single%energy), 'multiplier batch: scattered, the other outputs')
  end subroutine other_outputs

  ! Into values of the host, by either map.
  subroutine scattered()
    real(dp), save, target :: global_f(0:rows - 1, 2)
    real(dp), save :: global_k(0:rows - 1, 0:rows - 1)
    integer(i8), save :: row_start(0:rows)
    integer(i8), save, target :: map(n*n*contacts), blocks((per + 1)*per*contacts)
    integer(i4), save :: column(0:rows*rows - 1)
    logical :: pass
    call pattern(row_start, column)
    pass = cte_csr_map(b%element, int(contacts, i8), 0, connectivity, int(rows, i8), row_start, column, map) &
      == CTE_SUCCESS
    pass = pass .and. row_start(3*multipliers + 2) == row_start(3*multipliers + 1)
    call client_check(pass, 'multiplier batch: csr_map with one row per multiplier')
    pass = cte_csr_blocks(b%element, int(contacts, i8), 0, connectivity, int(rows, i8), row_start, column, blocks) &
      == CTE_SUCCESS .and. pass
    if (pass) pass = same_places(map, blocks)
    call client_check(pass, 'multiplier batch: csr_blocks, the places of csr_map')
    if (.not. pass) return
    global_f = 1 ! what the host has already
    global_k = 2
    call assemble(global_f(:, 1), global_k)
    call fresh()
    batch%csr_map = c_loc(map)
    call client_check(scatters(row_start, column, global_f, global_k), &
      'multiplier batch: scattered into vector and CSR matrix')
    call other_outputs()
    call fresh()
    batch%csr_map = c_loc(blocks)
    batch%request = batch%request + CTE_CSR_BY_BLOCKS
    call client_check(scatters(row_start, column, global_f, global_k), &
      'multiplier batch: scattered by blocks of nodes')
    call other_outputs()
  end subroutine scattered

  subroutine interface_multiplier_batch_run()
    logical :: pass
    call bench_open(b, 'PointQuad4Multiplier')
    if (.not. c_associated(b%element)) return
    call lay_out()
    pass = single_calls()
    call client_check(pass .and. b%info%history == history, 'multiplier batch: the single calls')
    call arrays()
    call scattered()
  end subroutine interface_multiplier_batch_run

end module interface_multiplier_batch
