! interface_entries.f90 - the same evaluation through cte_api_table and through the Fortran 77 entries.
module interface_entries
  use, intrinsic :: iso_c_binding, only: c_associated, c_f_procpointer, c_null_ptr, c_ptr, c_sizeof
  use contact_elements
  use client_support
  implicit none
  private
  public :: interface_entries_run

  integer, parameter :: n = 15, ldk = 20
  type(bench), save, target :: b, reference

  ! Entries called with null addresses.
  abstract interface
    function batch_call(element, count, batch) bind(c) result(code)
      import :: i4, i8, c_ptr
      type(c_ptr), value :: element, batch
      integer(i8), value :: count
      integer(i4) :: code
    end function batch_call
    function threads_call(element, count, batch, threads) bind(c) result(code)
      import :: i4, i8, c_ptr
      type(c_ptr), value :: element, batch
      integer(i8), value :: count
      integer(i4), value :: threads
      integer(i4) :: code
    end function threads_call
    function map_call(element, count, nslave, connectivity, rows, row_start, column, map) bind(c) result(code)
      import :: i4, i8, c_ptr
      type(c_ptr), value :: element, connectivity, row_start, column, map
      integer(i8), value :: count, rows
      integer(i4), value :: nslave
      integer(i4) :: code
    end function map_call
  end interface

contains

  function same_as_reference() result(same)
    logical :: same
    same = client_same(b%out%f(:n), reference%out%f(:n)) &
      .and. client_same(b%out%k(:n*n), reference%out%k(:n*n)) &
      .and. client_same(b%out%history_trial(:b%info%history), reference%out%history_trial(:b%info%history)) &
      .and. client_same(b%out%output(:CTE_OUTPUT_SIZE), reference%out%output(:CTE_OUTPUT_SIZE)) &
      .and. client_same(b%out%energy, reference%out%energy)
  end function same_as_reference

  ! Lookup through the table.
  function found_through(api, element_index) result(pass)
    type(cte_api_table), intent(in) :: api
    integer(i4), intent(in) :: element_index
    logical :: pass
    procedure(cte_element_count), pointer :: element_count
    procedure(cte_element_get), pointer :: element_get
    procedure(cte_element_find), pointer :: element_find
    procedure(cte_element_info), pointer :: element_info
    type(cte_info) :: info
    integer(i4) :: found
    call c_f_procpointer(api%element_count, element_count)
    call c_f_procpointer(api%element_get, element_get)
    call c_f_procpointer(api%element_find, element_find)
    call c_f_procpointer(api%element_info, element_info)
    found = -1
    pass = element_count() == cte_element_count()
    pass = c_associated(element_get(element_index), b%element) .and. pass
    pass = element_find('PointQuad4', 10, found) == CTE_SUCCESS .and. pass
    pass = element_info(b%element, 0, info) == CTE_SUCCESS .and. pass
    pass = pass .and. found == element_index .and. all(transfer(info, [0_i8]) == transfer(b%info, [0_i8]))
  end function found_through

  ! Description through the table.
  function described_through(api) result(pass)
    type(cte_api_table), intent(in) :: api
    logical :: pass
    procedure(cte_element_unknown), pointer :: element_unknown
    procedure(cte_element_parameter), pointer :: element_parameter
    procedure(cte_element_check_parameters), pointer :: check_parameters
    procedure(cte_element_history_init), pointer :: history_init
    procedure(cte_element_batch_workspace), pointer :: batch_workspace
    type(c_ptr) :: name, own, unit
    real(dp) :: lower, upper, history(room_history)
    integer(i4) :: node(2), kind(2), closed, bad
    call c_f_procpointer(api%element_unknown, element_unknown)
    call c_f_procpointer(api%element_parameter, element_parameter)
    call c_f_procpointer(api%element_check_parameters, check_parameters)
    call c_f_procpointer(api%element_history_init, history_init)
    call c_f_procpointer(api%element_batch_workspace, batch_workspace)
    node = [-1, -2]
    kind = [-1, -2]
    pass = element_unknown(b%element, 0, 7, node(1), kind(1)) == CTE_SUCCESS
    pass = cte_element_unknown(b%element, 0, 7, node(2), kind(2)) == CTE_SUCCESS .and. pass
    pass = pass .and. node(1) == node(2) .and. kind(1) == kind(2)
    pass = element_parameter(b%element, 1, name, unit, lower, upper, closed) == CTE_SUCCESS .and. pass
    pass = cte_element_parameter(b%element, 1, own, unit, lower, upper, closed) == CTE_SUCCESS .and. pass
    if (pass) pass = c_associated(name, own)
    pass = check_parameters(b%element, b%parameters, b%info%parameters, bad) == CTE_SUCCESS .and. pass
    pass = history_init(b%element, history) == CTE_SUCCESS .and. pass
    pass = batch_workspace(b%element, 0) == cte_element_batch_workspace(b%element, 0) .and. pass
  end function described_through

  ! Evaluation and texts through the table.
  subroutine evaluate_through(api)
    type(cte_api_table), intent(in) :: api
    procedure(cte_element_evaluate), pointer :: element_evaluate
    procedure(cte_element_message), pointer :: element_message
    procedure(cte_code_message), pointer :: code_message, status_message, argument_name
    character(len=128) :: text(2)
    integer(i4) :: code, length(2)
    logical :: pass
    call c_f_procpointer(api%element_evaluate, element_evaluate)
    call c_f_procpointer(api%element_message, element_message)
    call c_f_procpointer(api%code_message, code_message)
    call c_f_procpointer(api%status_message, status_message)
    call c_f_procpointer(api%argument_name, argument_name)
    call bench_canary(b)
    pass = element_evaluate(b%element, b%a) == CTE_SUCCESS
    call client_check(pass .and. same_as_reference(), 'table: evaluate')
    b%a%f = c_null_ptr
    text = ''
    code = element_evaluate(b%element, b%a)
    length(1) = element_message(b%element, b%a, code, text(1), len(text))
    length(2) = cte_element_message(b%element, b%a, code, text(2), len(text))
    call client_check(length(1) == length(2) .and. length(1) == len_trim(text(1)) - 1 .and. text(1) == text(2), &
      'table: message')
    pass = c_associated(code_message(code), cte_code_message(code))
    pass = c_associated(status_message(CTE_STATUS_LAW), cte_status_message(CTE_STATUS_LAW)) .and. pass
    pass = c_associated(argument_name(CTE_ARGUMENT_F), cte_argument_name(CTE_ARGUMENT_F)) .and. pass
    call client_check(pass, 'table: texts')
  end subroutine evaluate_through

  subroutine table(element_index)
    integer(i4), intent(in) :: element_index
    type(cte_api_table) :: api
    procedure(batch_call), pointer :: element_evaluate_batch
    procedure(threads_call), pointer :: element_evaluate_batch_threads
    procedure(map_call), pointer :: csr_map, csr_blocks
    logical :: pass
    pass = cte_api(CTE_VERSION_MAJOR, api) == CTE_SUCCESS
    pass = pass .and. api%version == cte_abi_version() .and. api%struct_size == c_sizeof(api)
    call client_check(pass, 'cte_api')
    if (.not. pass) return
    pass = found_through(api, element_index)
    pass = described_through(api) .and. pass
    call client_check(pass, 'table: lookup and description')
    call evaluate_through(api)
    call c_f_procpointer(api%element_evaluate_batch, element_evaluate_batch)
    call c_f_procpointer(api%element_evaluate_batch_threads, element_evaluate_batch_threads)
    call c_f_procpointer(api%csr_map, csr_map)
    call c_f_procpointer(api%csr_blocks, csr_blocks)
    pass = element_evaluate_batch(c_null_ptr, 0_i8, c_null_ptr) == CTE_ERROR_NULL
    pass = element_evaluate_batch_threads(c_null_ptr, 0_i8, c_null_ptr, 0) == CTE_ERROR_NULL .and. pass
    pass = csr_map(c_null_ptr, 0_i8, 0, c_null_ptr, 0_i8, c_null_ptr, c_null_ptr, c_null_ptr) == CTE_ERROR_NULL &
      .and. pass
    pass = csr_blocks(c_null_ptr, 0_i8, 0, c_null_ptr, 0_i8, c_null_ptr, c_null_ptr, c_null_ptr) == CTE_ERROR_NULL &
      .and. pass
    call client_check(pass, 'table: batch, csr_map and csr_blocks')
  end subroutine table

  ! One call of the Fortran 77 entry with the bench's arrays but for k; -1 where it is not closed.
  function called_77(element_index, request, k) result(code)
    integer(i4), intent(in) :: element_index, request
    real(dp), intent(inout) :: k(*)
    integer(i4) :: code, state(4)
    state = -1
    code = -1
    call bench_canary(b)
    call cte_f77_evaluate(element_index, request, 5_i4, 0_i4, b%x, 0_i4, b%u, 0_i4, b%parameters, b%info%parameters, &
      b%history_accepted, b%out%history_trial, b%row, 0_i4, [0_i4], 1.0_dp, 1.0_dp, b%out%f, k, int(ldk, i4), &
      b%out%output, b%out%energy(1), b%workspace, 0_i4, state, code)
    if (state(1) /= CTE_STATUS_CLOSED .or. state(2) /= 1) code = -1
  end function called_77

  ! K comes column-major with a leading dimension.
  subroutine evaluate_77(element_index)
    integer(i4), intent(in) :: element_index
    integer(i4), parameter :: request = CTE_RESIDUAL + CTE_TANGENT + CTE_HISTORY + CTE_OUTPUT + CTE_ENERGY
    real(dp), save :: k(ldk, n)
    logical :: pass, untouched
    k = 0
    pass = called_77(element_index, request, k) == CTE_SUCCESS
    b%out%k(:n*n) = reshape(transpose(k(:n, :)), [n*n])
    call client_check(pass .and. same_as_reference(), 'F77 evaluate')
    pass = called_77(element_index, CTE_RESIDUAL, b%out%k) == CTE_SUCCESS
    untouched = client_same(b%out%k(:1), [canary()]) .and. client_same(b%out%history_trial(:1), [canary()]) &
      .and. client_same(b%out%output(:1), [canary()]) .and. client_same(b%out%energy, [canary()])
    call client_check(pass .and. client_same(b%out%f(:n), reference%out%f(:n)) .and. untouched, &
      'F77 residual alone touches nothing else')
  end subroutine evaluate_77

  subroutine others_77(element_index)
    integer(i4), intent(in) :: element_index
    integer(i4) :: sizes(13), code
    real(dp) :: history(room_history)
    sizes = 0
    code = -1
    call cte_f77_info(element_index, 0_i4, sizes, code)
    call client_check(code == CTE_SUCCESS .and. all(sizes == [b%info%dimension, b%info%nodes_minimum, &
      b%info%nodes_maximum, b%info%slave_nodes, b%info%master_nodes, b%info%unknowns, b%info%parameters, &
      b%info%history, b%info%points, b%info%projected, b%info%requests, b%info%symmetric, &
      int(b%info%workspace, i4)]), 'F77 info')
    history = canary()
    code = -1
    call cte_f77_history_init(element_index, history, code)
    call client_check(code == CTE_SUCCESS .and. client_same(history(:b%info%history), b%history_accepted(:b%info%history)), &
      'F77 history_init')
  end subroutine others_77

  subroutine interface_entries_run()
    integer(i4) :: element_index
    call bench_open(reference, 'PointQuad4')
    call bench_open(b, 'PointQuad4')
    if (.not. c_associated(b%element)) return
    element_index = -1
    if (cte_element_find('PointQuad4', 10, element_index) /= CTE_SUCCESS) return
    if (bench_evaluate(reference) /= CTE_SUCCESS) return
    call table(element_index)
    call evaluate_77(element_index)
    call others_77(element_index)
  end subroutine interface_entries_run

end module interface_entries
