! bad_maps.f90 - bad input to both scatter maps, and patterns that only one of them takes; see bad_input.f90.
module bad_maps
  use, intrinsic :: iso_c_binding, only: c_associated, c_f_procpointer, c_funptr, c_loc, c_null_ptr, c_ptr
  use contact_elements
  use client_support
  implicit none
  private
  public :: bad_maps_run

  integer, parameter :: contacts = 2
  integer, parameter :: rows = 18 ! of six nodes
  integer, parameter :: n = 15    ! unknowns of an element, of five nodes
  integer, parameter :: entries = rows*rows, room = contacts*16*16
  integer, parameter :: map_size(2) = [n*n, 5*6] ! of the map of one contact
  integer(i8), parameter :: untouched = -77

  ! Both functions with every address by value.
  abstract interface
    function map_call(element, n, nslave, connectivity, rows, row_start, column, map) bind(c) result(code)
      import :: i4, i8, c_ptr
      type(c_ptr), value :: element, connectivity, row_start, column, map
      integer(i8), value :: n, rows
      integer(i4), value :: nslave
      integer(i4) :: code
    end function map_call
  end interface

  type(bench), save, target :: b
  integer, save :: which ! of both functions
  procedure(map_call), pointer, save :: make
  integer(i4), save, target :: connectivity(0:contacts*5 - 1), column(0:2*entries - 1)
  integer(i8), save, target :: row_start(0:rows), map(0:room - 1)

contains

  subroutine check(pass, what)
    logical, intent(in) :: pass
    character(len=*), intent(in) :: what
    character(len=12), parameter :: name(2) = [character(len=12) :: 'csr_map: ', 'csr_blocks: ']
    call client_check(pass, trim(name(which))//' '//what)
  end subroutine check

  ! Two slave points (nodes 0 and 1) on one facet (nodes 2 to 5). A full matrix for a pattern; rows whose bit is in
  ! `without` have no column 3, of node 1, which the first contact has no use for; those in `longer` have one more
  ! behind.
  subroutine lay_out(without, longer)
    integer, intent(in) :: without, longer
    integer :: row, col, length
    connectivity = [0, 2, 3, 4, 5, 1, 2, 3, 4, 5]
    length = 0
    do row = 0, rows - 1
      row_start(row) = length
      do col = 0, rows
        if (col == 3 .and. btest(without, row)) cycle
        if (col == rows .and. .not. btest(longer, row)) cycle
        column(length) = col
        length = length + 1
      end do
    end do
    row_start(rows) = length
    map = untouched
  end subroutine lay_out

  ! The code of one call.
  function mapped(count, nslave, rows_given) result(code)
    integer(i8), intent(in) :: count, rows_given
    integer(i4), intent(in) :: nslave
    integer(i4) :: code
    code = make(b%element, count, nslave, c_loc(connectivity), rows_given, c_loc(row_start), c_loc(column), c_loc(map))
  end function mapped

  ! The first numbers of the map are positions, all others as they were.
  function written(numbers) result(pass)
    integer, intent(in) :: numbers
    logical :: pass
    pass = all(map(:numbers - 1) >= 0) .and. all(map(:numbers - 1) < row_start(rows)) &
      .and. all(map(numbers:) == untouched)
  end function written

  ! The call is refused for its counts or its pattern.
  function wrong(count, rows_given) result(pass)
    integer(i8), intent(in) :: count, rows_given
    logical :: pass
    pass = mapped(count, 0_i4, rows_given) == CTE_ERROR_INDEX
  end function wrong

  ! The pattern is refused for both contacts, and nothing written.
  function refused() result(pass)
    logical :: pass
    pass = wrong(int(contacts, i8), int(rows, i8))
    pass = pass .and. written(0)
  end function refused

  subroutine null_pointers()
    type(c_ptr) :: p(5), q(5)
    integer(i4) :: code(5)
    integer :: i
    call lay_out(0, 0)
    p = [b%element, c_loc(connectivity), c_loc(row_start), c_loc(column), c_loc(map)]
    do i = 1, 5
      q = p
      q(i) = c_null_ptr
      code(i) = make(q(1), int(contacts, i8), 0_i4, q(2), int(rows, i8), q(3), q(4), q(5))
    end do
    call check(all(code == CTE_ERROR_NULL), 'each pointer null')
    code(1) = make(b%element, 0_i8, 0_i4, c_null_ptr, 0_i8, c_null_ptr, c_null_ptr, c_null_ptr)
    code(2) = make(c_null_ptr, 0_i8, 0_i4, c_null_ptr, 0_i8, c_null_ptr, c_null_ptr, c_null_ptr)
    call check(code(1) == CTE_SUCCESS, 'no contacts')
    call check(code(2) == CTE_ERROR_NULL, 'no contacts, element null')
    call check(written(0), 'each pointer null, map untouched')
  end subroutine null_pointers

  subroutine counts()
    integer(i8), parameter :: far = huge(0_i8), two = contacts, all_rows = rows
    logical :: pass(3)
    call lay_out(0, 0)
    call check(mapped(two, 2_i4, all_rows) == CTE_ERROR_NODE_COUNT, 'nslave')
    call check(mapped(two, -1_i4, all_rows) == CTE_ERROR_NODE_COUNT, 'nslave negative')
    pass = [wrong(far, all_rows), wrong(ishft(far, -6), all_rows), wrong(two, far)]
    call check(all(pass), 'sizes beyond any memory')
    pass(:2) = [wrong(-1_i8, all_rows), wrong(two, -1_i8)]
    call check(all(pass(:2)), 'sizes negative')
    call check(wrong(two, all_rows - 3), 'node beyond the rows')
    connectivity(7) = -1
    call check(wrong(two, all_rows), 'connectivity -1')
    connectivity(7) = huge(0_i4)
    call check(wrong(two, all_rows), 'connectivity far out')
    call check(written(0), 'counts, map untouched')
  end subroutine counts

  ! The second contact has not all it needs: nothing is written of the first one either.
  subroutine patterns()
    integer(i8), parameter :: start(4) = [-1_i8, -huge(0_i8) - 1_i8, huge(0_i8), 0_i8]
    logical :: pass
    integer :: i
    call lay_out(0, 0)
    column(entries - 1) = rows ! entry (last, last) is missing now
    call check(refused(), 'entry missing from the pattern')
    call lay_out(ibset(0, 4), 0) ! entry (4, 3) of the slave with itself
    call check(refused(), 'entry missing in the middle of a row')
    pass = .true.
    do i = 1, 4
      call lay_out(0, 0)
      row_start(4) = start(i)
      pass = refused() .and. pass
      call lay_out(0, 0)
      row_start(rows) = start(i)
      pass = refused() .and. pass
    end do
    call check(pass, 'row_start of no matrix')
  end subroutine patterns

  ! All entries are there, and blocks of the same shape in all rows of a node, or not.
  subroutine shapes()
    integer, parameter :: shape(2, 0:5) = reshape([0, 0, 7, 0, 2, 0, 1, 1, 4, 0, 0, 1], [2, 6])
    integer(i4) :: found
    logical :: taken
    integer :: i
    do i = 0, 5
      call lay_out(shape(1, i), shape(2, i))
      taken = which == 1 .or. i < 2 ! by blocks: none but rows with the same columns
      found = mapped(1_i8, 0_i4, int(rows, i8))
      call check(found == merge(CTE_SUCCESS, CTE_ERROR_INDEX, taken) &
        .and. written(merge(map_size(which), 0, taken)), client_text('shape of a node''s rows', int(i, i8)))
    end do
  end subroutine shapes

  ! Nodes of their own for two contacts; without and with the rows and columns of multipliers.
  subroutine multipliers()
    integer(i4), target :: nodes(12)
    integer(i8), target :: start(0:36)
    logical :: pass
    integer :: row, j, length
    call bench_open(b, 'PointQuad4Multiplier')
    if (.not. c_associated(b%element)) return
    map = untouched
    nodes = [(j, j=0, 11)]
    start = 0
    pass = with(nodes, start) == CTE_ERROR_INDEX
    call check(pass .and. written(0), 'no entries for multipliers')
    length = 0
    do row = 0, 35 ! of each contact 15 rows, one of the multiplier, two without entries
      start(row) = length
      if (mod(row, 18) >= 16) cycle
      column(length:length + 15) = [(merge(18, 0, row >= 18) + j, j=0, 15)]
      length = length + 16
    end do
    start(36) = length
    pass = with(nodes, start) == CTE_SUCCESS
    pass = pass .and. map(0) == 0
    if (which == 1) pass = pass .and. map(511) == 511
    if (which == 2) pass = pass .and. all(map(81:83) == [508, 511, 0])
    call check(pass, 'one row and column for each multiplier')
    map = untouched
    column(255) = 16 ! a multiplier with itself
    pass = with(nodes, start) == CTE_ERROR_INDEX
    call check(pass .and. written(0), 'a multiplier without its entry on the diagonal')
  end subroutine multipliers

  ! The code for two contacts on nodes of their own.
  function with(nodes, start) result(code)
    integer(i4), intent(in), target :: nodes(12)
    integer(i8), intent(in), target :: start(0:36)
    integer(i4) :: code
    code = make(b%element, 2_i8, 0_i4, c_loc(nodes), 36_i8, c_loc(start), c_loc(column), c_loc(map))
  end function with

  subroutine bad_maps_run()
    type(cte_api_table) :: api
    type(c_funptr) :: functions(2)
    logical :: pass
    if (cte_api(CTE_VERSION_MAJOR, api) /= CTE_SUCCESS) then
      call client_check(.false., 'cte_api')
      return
    end if
    functions = [api%csr_map, api%csr_blocks]
    do which = 1, 2
      call c_f_procpointer(functions(which), make)
      call bench_open(b, 'PointQuad4')
      if (.not. c_associated(b%element)) return
      call lay_out(0, 0)
      pass = mapped(int(contacts, i8), 0_i4, int(rows, i8)) == CTE_SUCCESS
      call check(pass .and. written(contacts*map_size(which)), 'the sound pattern')
      call null_pointers()
      call counts()
      call patterns()
      call shapes()
      call multipliers()
    end do
  end subroutine bad_maps_run

end module bad_maps
