! bad_calls.f90 - bad input to lookup, description, history, messages, the table and the Fortran 77 entries;
! see bad_input.f90. Null addresses go through the procedures of cte_api_table.
module bad_calls
  use, intrinsic :: iso_c_binding, only: c_associated, c_f_procpointer, c_loc, c_null_char, c_null_ptr, &
    c_ptr, c_sizeof
  use contact_elements
  use client_support
  implicit none
  private
  public :: bad_calls_run

  integer(i4), parameter :: untouched = -77 ! what an output holds before the call
  type(bench), save, target :: b
  type(cte_api_table), save :: api

  ! The functions of the table that take addresses, every address by value.
  abstract interface
    function find_call(name, length, index) bind(c) result(code)
      import :: i4, c_ptr
      type(c_ptr), value :: name, index
      integer(i4), value :: length
      integer(i4) :: code
    end function find_call
    function info_call(element, nnode, info) bind(c) result(code)
      import :: i4, c_ptr
      type(c_ptr), value :: element, info
      integer(i4), value :: nnode
      integer(i4) :: code
    end function info_call
    function unknown_call(element, nnode, index, node, kind) bind(c) result(code)
      import :: i4, c_ptr
      type(c_ptr), value :: element, node, kind
      integer(i4), value :: nnode, index
      integer(i4) :: code
    end function unknown_call
    function parameter_call(element, index, name, unit, lower, upper, closed) bind(c) result(code)
      import :: i4, c_ptr
      type(c_ptr), value :: element, name, unit, lower, upper, closed
      integer(i4), value :: index
      integer(i4) :: code
    end function parameter_call
    function check_call(element, parameters, count, index) bind(c) result(code)
      import :: i4, c_ptr
      type(c_ptr), value :: element, parameters, index
      integer(i4), value :: count
      integer(i4) :: code
    end function check_call
    function evaluate_call(element, arguments) bind(c) result(code)
      import :: i4, c_ptr
      type(c_ptr), value :: element, arguments
      integer(i4) :: code
    end function evaluate_call
    function batch_call(element, n, batch) bind(c) result(code)
      import :: i4, i8, c_ptr
      type(c_ptr), value :: element, batch
      integer(i8), value :: n
      integer(i4) :: code
    end function batch_call
    function message_call(element, arguments, code, text, size) bind(c) result(length)
      import :: i4, c_ptr
      type(c_ptr), value :: element, arguments, text
      integer(i4), value :: code, size
      integer(i4) :: length
    end function message_call
  end interface

contains

  ! One call whose only output is an integer: its code, and the integer as it was.
  subroutine expect(what, found, code, output)
    character(len=*), intent(in) :: what
    integer(i4), intent(in) :: found, code, output
    logical :: pass
    pass = found == code .and. output == untouched
    call client_check(pass, what)
    if (.not. pass) print '(3(a,i0))', '     code ', found, ' wanted ', code, ', output ', output
  end subroutine expect

  subroutine lookup()
    character(len=13), parameter :: name(6) = [character(len=13) :: 'NoSuchElement', 'pointquad4', &
      'PointQuad', 'PointQuad4x', '    ', '']
    integer, parameter :: length(6) = [13, 10, 9, 11, 4, 0]
    character(len=10), target :: known
    integer(i4), target :: found
    integer(i4) :: code
    procedure(find_call), pointer :: find
    integer :: i
    found = untouched
    do i = 1, 6
      code = cte_element_find(name(i), length(i), found)
      call expect(client_text('unknown element name', int(i - 1, i8)), code, CTE_ERROR_NAME, found)
    end do
    code = cte_element_find('PointQuad4', -1, found)
    call expect('name of length -1', code, CTE_ERROR_NAME, found)
    call c_f_procpointer(api%element_find, find)
    known = 'PointQuad4'
    code = find(c_null_ptr, 4, c_loc(found))
    call expect('name null', code, CTE_ERROR_NULL, found)
    code = find(c_loc(known), 10, c_null_ptr)
    call expect('index of find null', code, CTE_ERROR_NULL, found)
    call client_check(.not. (c_associated(cte_element_get(-1)) .or. c_associated(cte_element_get( &
      cte_element_count())) .or. c_associated(cte_element_get(huge(0_i4))) .or. c_associated( &
      cte_element_get(-huge(0_i4) - 1))), 'element index out of range')
  end subroutine lookup

  ! The code of a call for a description, -1000 when the struct has changed.
  function described(element, nnode, info) result(code)
    type(c_ptr), intent(in) :: element
    integer(i4), intent(in) :: nnode
    type(cte_info), intent(inout) :: info
    type(cte_info) :: before
    integer(i4) :: code
    before = info
    code = cte_element_info(element, nnode, info)
    if (any(transfer(before, [0_i8]) /= transfer(info, [0_i8]))) code = -1000
  end function described

  subroutine description()
    type(cte_info) :: info
    integer(i4) :: sizes(4) ! the last: that of interface 0.1
    integer(i4), parameter :: nnode(3) = [4, 6, -1]
    procedure(info_call), pointer :: call_info
    integer :: i
    call c_f_procpointer(api%element_info, call_info)
    call client_check(call_info(b%element, 0, c_null_ptr) == CTE_ERROR_NULL, 'info null')
    sizes = [0_i4, 8_i4, int(c_sizeof(info), i4) - 1_i4, 152_i4]
    call client_check(described(c_null_ptr, 0, info) == CTE_ERROR_NULL, 'info of element null')
    do i = 1, 4
      info%struct_size = sizes(i)
      call client_check(described(b%element, 0, info) == CTE_ERROR_STRUCT_SIZE, &
        client_text('info struct_size', int(sizes(i), i8)))
    end do
    info%struct_size = sizes(3) + 1
    do i = 1, 3
      call client_check(described(b%element, nnode(i), info) == CTE_ERROR_NODE_COUNT, &
        client_text('info nnode', int(nnode(i), i8)))
    end do
  end subroutine description

  subroutine unknowns()
    integer(i4), target :: node, kind
    integer(i4) :: code
    integer(i4), parameter :: wrong(4) = [-1_i4, 15_i4, huge(0_i4), -huge(0_i4) - 1_i4]
    procedure(unknown_call), pointer :: unknown
    integer :: i
    node = untouched
    kind = untouched
    do i = 1, 4
      code = cte_element_unknown(b%element, 0, wrong(i), node, kind)
      call expect(client_text('unknown index', int(wrong(i), i8)), code, CTE_ERROR_INDEX, &
        merge(kind, node, node == untouched))
    end do
    code = cte_element_unknown(b%element, 4, 0, node, kind)
    call expect('unknown of nnode 4', code, CTE_ERROR_NODE_COUNT, node)
    code = cte_element_unknown(c_null_ptr, 0, 0, node, kind)
    call expect('unknown of element null', code, CTE_ERROR_NULL, node)
    call c_f_procpointer(api%element_unknown, unknown)
    code = unknown(b%element, 0, 0, c_null_ptr, c_loc(kind))
    call expect('unknown: node null', code, CTE_ERROR_NULL, kind)
    code = unknown(b%element, 0, 0, c_loc(node), c_null_ptr)
    call expect('unknown: kind null', code, CTE_ERROR_NULL, node)
  end subroutine unknowns

  subroutine parameters()
    integer(i4), target :: closed, bad
    integer(i4) :: code, wrong(2)
    procedure(parameter_call), pointer :: parameter_of
    procedure(check_call), pointer :: check
    integer :: i
    closed = untouched
    bad = untouched
    wrong = [-1_i4, b%info%parameters]
    call c_f_procpointer(api%element_parameter, parameter_of)
    do i = 1, 2
      code = parameter_of(b%element, wrong(i), c_null_ptr, c_null_ptr, c_null_ptr, c_null_ptr, c_loc(closed))
      call expect(client_text('parameter index', int(wrong(i), i8)), code, CTE_ERROR_INDEX, closed)
    end do
    code = parameter_of(c_null_ptr, 0, c_null_ptr, c_null_ptr, c_null_ptr, c_null_ptr, c_loc(closed))
    call expect('parameter of element null', code, CTE_ERROR_NULL, closed)
    call c_f_procpointer(api%element_check_parameters, check)
    code = check(b%element, c_null_ptr, b%info%parameters, c_loc(bad))
    call expect('check_parameters null', code, CTE_ERROR_NULL, bad)
    code = check(c_null_ptr, c_loc(b%parameters), b%info%parameters, c_loc(bad))
    call expect('check_parameters of element null', code, CTE_ERROR_NULL, bad)
    call checked_parameters()
  end subroutine parameters

  subroutine checked_parameters()
    integer(i4) :: code, bad, eps_n
    real(dp) :: history(room_history)
    procedure(evaluate_call), pointer :: history_init
    integer :: i
    bad = untouched
    code = cte_element_check_parameters(b%element, b%parameters, 0, bad)
    call client_check(code == CTE_ERROR_PARAMETER, 'check_parameters: none given')
    eps_n = bench_parameter(b, 'eps_n')
    do i = 1, client_specials
      call client_special(i, b%parameters(eps_n + 1))
      code = cte_element_check_parameters(b%element, b%parameters, b%info%parameters, bad)
      call client_check(code == CTE_ERROR_NOT_FINITE .and. bad == eps_n, &
        client_text('check_parameters: special value', int(i - 1, i8)))
    end do
    call bench_set(b, 'eps_n', -1.0_dp)
    code = cte_element_check_parameters(b%element, b%parameters, b%info%parameters, bad)
    call client_check(code == CTE_ERROR_PARAMETER .and. bad == eps_n, 'check_parameters: eps_n negative')
    call bench_set(b, 'eps_n', 100.0_dp)
    call c_f_procpointer(api%element_history_init, history_init) ! two addresses too
    call client_check(history_init(b%element, c_null_ptr) == CTE_ERROR_NULL, 'history_init null')
    call client_check(cte_element_history_init(c_null_ptr, history) == CTE_ERROR_NULL, &
      'history_init of element null')
  end subroutine checked_parameters

  subroutine messages()
    integer(i4), parameter :: odd(4) = [-999_i4, 999_i4, -huge(0_i4) - 1_i4, huge(0_i4)]
    character(len=8), target :: text
    procedure(evaluate_call), pointer :: evaluate
    procedure(batch_call), pointer :: evaluate_batch
    procedure(message_call), pointer :: message
    integer(i4) :: length(3)
    integer :: i
    do i = 1, 4
      call client_check(c_associated(cte_code_message(odd(i))) .and. c_associated(cte_status_message(odd(i))) &
        .and. c_associated(cte_argument_name(odd(i))), client_text('messages for', int(odd(i), i8)))
    end do
    call c_f_procpointer(api%element_evaluate, evaluate)
    call c_f_procpointer(api%element_evaluate_batch, evaluate_batch)
    call c_f_procpointer(api%element_message, message)
    call client_check(evaluate(b%element, c_null_ptr) == CTE_ERROR_NULL, 'arguments null')
    call client_check(evaluate_batch(b%element, 1_i8, c_null_ptr) == CTE_ERROR_NULL, 'batch null')
    text = '########'
    length(1) = message(c_null_ptr, c_null_ptr, CTE_ERROR_NULL, c_loc(text), 8)
    call client_check(length(1) > 0 .and. scan(text, c_null_char) > 0, 'message of element and arguments null')
    text = '########'
    length(1) = cte_element_message(b%element, b%a, CTE_ERROR_NULL, text, 4)
    call client_check(length(1) > 0 .and. text(4:5) == c_null_char//'#', 'message cut to size 4')
    text = '########'
    length(1) = cte_element_message(b%element, b%a, CTE_ERROR_NULL, text, 0)
    length(2) = cte_element_message(b%element, b%a, CTE_ERROR_NULL, text, -1)
    length(3) = message(b%element, c_loc(b%a), CTE_ERROR_NULL, c_null_ptr, 8)
    call client_check(all(length > 0) .and. text == '########', &
      'message of size 0, -1, text null: the length alone')
  end subroutine messages

  ! The code of a call for the table, -1000 when the table has changed.
  function tabled(major, table) result(code)
    integer(i4), intent(in) :: major
    type(cte_api_table), intent(inout) :: table
    type(cte_api_table) :: before
    integer(i4) :: code
    before = table
    code = cte_api(major, table)
    if (any(transfer(before, [0_i8]) /= transfer(table, [0_i8]))) code = -1000
  end function tabled

  subroutine tables()
    type(cte_api_table) :: table
    integer(i4) :: sizes(3)
    integer(i4), parameter :: major(3) = [0_i4, CTE_VERSION_MAJOR + 1_i4, -1_i4]
    integer :: i
    interface
      function cte_api_address(major, table) bind(c, name='cte_api') result(code)
        import :: i4, c_ptr
        integer(i4), value :: major
        type(c_ptr), value :: table
        integer(i4) :: code
      end function cte_api_address
    end interface
    call client_check(cte_api_address(CTE_VERSION_MAJOR, c_null_ptr) == CTE_ERROR_NULL, 'table null')
    sizes = [0_i4, 8_i4, int(c_sizeof(table), i4) - 1_i4]
    do i = 1, 3
      table%struct_size = sizes(i)
      call client_check(tabled(CTE_VERSION_MAJOR, table) == CTE_ERROR_STRUCT_SIZE, &
        client_text('table struct_size', int(sizes(i), i8)))
    end do
    table%struct_size = sizes(3) + 1
    do i = 1, 3
      call client_check(tabled(major(i), table) == CTE_ERROR_VERSION, &
        client_text('table of major version', iand(int(major(i), i8), 4294967295_i8)))
    end do
  end subroutine tables

  ! One call of the Fortran 77 entry with the bench's arrays.
  function evaluate_77(element, request, nnode, ldk) result(code)
    integer(i4), intent(in) :: element, request, nnode, ldk
    integer(i4) :: code, state(4)
    code = untouched
    call bench_canary(b)
    call cte_f77_evaluate(element, request, nnode, 0_i4, b%x, 0_i4, b%u, 0_i4, b%parameters, b%info%parameters, &
      b%history_accepted, b%out%history_trial, b%row, 0_i4, [0_i4], 1.0_dp, 1.0_dp, b%out%f, b%out%k, ldk, &
      b%out%output, b%out%energy(1), b%workspace, 0_i4, state, code)
    if (.not. bench_untouched(b)) code = -1000
  end function evaluate_77

  subroutine fortran_77()
    integer(i4), parameter :: request = CTE_RESIDUAL + CTE_TANGENT
    integer(i4) :: found, wrong(2), code
    real(dp) :: history(room_history)
    integer :: i
    code = cte_element_find('PointQuad4', 10, found)
    wrong = [-1_i4, cte_element_count()]
    do i = 1, 2
      call client_check(evaluate_77(wrong(i), request, 5, 15) == CTE_ERROR_INDEX, &
        client_text('F77 evaluate, element', int(wrong(i), i8)))
      code = untouched
      call cte_f77_history_init(wrong(i), history, code)
      call client_check(code == CTE_ERROR_INDEX, client_text('F77 history_init, element', int(wrong(i), i8)))
    end do
    call client_check(evaluate_77(found, 1024, 5, 15) == CTE_ERROR_REQUEST, 'F77 request 1024')
    call client_check(evaluate_77(found, request, 4, 15) == CTE_ERROR_NODE_COUNT, 'F77 nnode 4')
    call client_check(evaluate_77(found, request, 5, 14) == CTE_ERROR_STRIDE, 'F77 ldk 14')
    call client_check(evaluate_77(found, request, 5, -15) == CTE_ERROR_STRIDE, 'F77 ldk -15')
    call client_special(2, b%u(3))
    call client_check(evaluate_77(found, request, 5, 15) == CTE_ERROR_NOT_FINITE, 'F77 u NaN')
  end subroutine fortran_77

  subroutine bad_calls_run()
    if (cte_api(CTE_VERSION_MAJOR, api) /= CTE_SUCCESS) then
      call client_check(.false., 'cte_api')
      return
    end if
    call bench_open(b, 'PointQuad4')
    if (.not. c_associated(b%element)) return
    call lookup()
    call description()
    call unknowns()
    call parameters()
    call messages()
    call tables()
    call fortran_77()
  end subroutine bad_calls_run

end module bad_calls
