! interface_constants.f90 - every number of the module contact_elements, and the texts that belong to them.
module interface_constants
  use, intrinsic :: iso_c_binding, only: c_associated, c_ptr
  use contact_elements
  use client_support
  implicit none
  private
  public :: interface_constants_run

  abstract interface
    function text_of(value) bind(c) result(text)
      import :: i4, c_ptr
      integer(i4), value :: value
      type(c_ptr) :: text
    end function text_of
  end interface

  ! In the order of the header.
  integer(i4), parameter :: code(15) = [CTE_SUCCESS, CTE_CUT_BACK, CTE_ERROR_NULL, CTE_ERROR_STRUCT_SIZE, &
    CTE_ERROR_NODE_COUNT, CTE_ERROR_PARAMETER, CTE_ERROR_REQUEST, CTE_ERROR_WORKSPACE, CTE_ERROR_NOT_FINITE, &
    CTE_ERROR_INDEX, CTE_ERROR_NAME, CTE_ERROR_VERSION, CTE_ERROR_STRIDE, CTE_ERROR_HISTORY, CTE_ERROR_ELEMENT]
  integer(i4), parameter :: argument(40) = [CTE_ARGUMENT_NONE, CTE_ARGUMENT_STRUCT_SIZE, CTE_ARGUMENT_REQUEST, &
    CTE_ARGUMENT_NNODE, CTE_ARGUMENT_NSLAVE, CTE_ARGUMENT_X, CTE_ARGUMENT_U, CTE_ARGUMENT_PARAMETERS, &
    CTE_ARGUMENT_HISTORY_ACCEPTED, CTE_ARGUMENT_HISTORY_TRIAL, CTE_ARGUMENT_SLAVE_ROW, CTE_ARGUMENT_F, CTE_ARGUMENT_K, &
    CTE_ARGUMENT_K_STRIDE, CTE_ARGUMENT_UNKNOWN_MAP, CTE_ARGUMENT_SCALE, CTE_ARGUMENT_OUTPUT, &
    CTE_ARGUMENT_ENERGY, CTE_ARGUMENT_WORKSPACE, CTE_ARGUMENT_ELEMENT, CTE_ARGUMENT_INFO, &
    CTE_ARGUMENT_ELEMENT_NAME, CTE_ARGUMENT_BATCH, CTE_ARGUMENT_CONNECTIVITY, CTE_ARGUMENT_CSR, &
    CTE_ARGUMENT_STATUS, CTE_ARGUMENT_FROM, CTE_ARGUMENT_FROM_OUTPUT, CTE_ARGUMENT_FROM_HISTORY, &
    CTE_ARGUMENT_TO, CTE_ARGUMENT_TO_OUTPUT, CTE_ARGUMENT_TO_HISTORY, CTE_ARGUMENT_REACH, CTE_ARGUMENT_RESULT, &
    CTE_ARGUMENT_PATCH, CTE_ARGUMENT_FACETS, CTE_ARGUMENT_FACET, CTE_ARGUMENT_EDGE, CTE_ARGUMENT_VERTEX, &
    CTE_ARGUMENT_THREADS]
  integer(i4), parameter :: status(9) = [CTE_STATUS_OPEN, CTE_STATUS_CLOSED, CTE_STATUS_STICK, &
    CTE_STATUS_SLIP, CTE_STATUS_OUTSIDE, CTE_STATUS_NOT_CONVERGED, CTE_STATUS_NOT_UNIQUE, CTE_STATUS_DEGENERATE, &
    CTE_STATUS_LAW]
  integer(i4), parameter :: request(10) = [CTE_RESIDUAL, CTE_TANGENT, CTE_HISTORY, CTE_OUTPUT, CTE_ENERGY, &
    CTE_FREEZE_STATE, CTE_SYMMETRISE, CTE_PROJECTION_GIVEN, CTE_SCREEN, CTE_CSR_BY_BLOCKS]
  integer(i4), parameter :: unknown_kind(7) = [CTE_UNKNOWN_UX, CTE_UNKNOWN_UY, CTE_UNKNOWN_UZ, CTE_UNKNOWN_TX, &
    CTE_UNKNOWN_TY, CTE_UNKNOWN_TZ, CTE_UNKNOWN_MULTIPLIER]
  integer(i4), parameter :: output(13) = [CTE_OUTPUT_STATUS, CTE_OUTPUT_GAP, CTE_OUTPUT_NORMAL_TRACTION, &
    CTE_OUTPUT_WEIGHT, CTE_OUTPUT_PROJECTION, CTE_OUTPUT_NORMAL, CTE_OUTPUT_ITERATIONS, CTE_OUTPUT_FEATURE, &
    CTE_OUTPUT_TANGENTIAL_TRACTION, CTE_OUTPUT_TANGENTS, CTE_OUTPUT_ANGLES, CTE_OUTPUT_MOMENTS, CTE_OUTPUT_SIZE]
  integer(i4), parameter :: histories(2) = [CTE_HISTORY_STATUS, CTE_HISTORY_PROJECTION]
  integer(i4), parameter :: verdict(5) = [CTE_VERDICT_INSIDE, CTE_VERDICT_BOUNDARY, CTE_VERDICT_NOT_UNIQUE, &
    CTE_VERDICT_BEYOND, CTE_VERDICT_UNDECIDED]
  integer(i4), parameter :: version(3) = [CTE_VERSION_MAJOR, CTE_VERSION_MINOR, CTE_ABI_VERSION_COMPILED]

contains

  subroutine compare(what, found, expected)
    character(len=*), intent(in) :: what
    integer(i4), intent(in) :: found(:)
    integer, intent(in) :: expected(:)
    integer :: i
    do i = 1, size(found)
      if (found(i) /= expected(i)) print '(2(a,i0))', '     ', found(i), ' should be ', expected(i)
    end do
    call client_check(all(found == expected), client_text(what, size(found, kind=i8)))
  end subroutine compare

  ! Every constant of the list has a distinct text.
  subroutine texts(what, constants, text)
    character(len=*), intent(in) :: what
    integer(i4), intent(in) :: constants(:)
    procedure(text_of) :: text
    character(len=:), allocatable :: own
    logical :: pass
    integer :: i, j
    pass = .true.
    do i = 1, size(constants)
      own = cte_string(text(constants(i)))
      pass = c_associated(text(constants(i))) .and. pass
      pass = pass .and. own /= '' .and. own /= cte_string(text(9999_i4))
      do j = 1, i - 1
        pass = pass .and. own /= cte_string(text(constants(j)))
      end do
    end do
    call client_check(pass, what)
  end subroutine texts

  subroutine interface_constants_run()
    integer :: i
    call compare('return codes', code, [(i, i=0, 1), (-i, i=1, 13)])
    call texts('texts of the return codes', code, cte_code_message)
    call compare('arguments', argument, [(i, i=0, 39)])
    call texts('names of the arguments', argument, cte_argument_name)
    call client_check(cte_string(cte_argument_name(CTE_ARGUMENT_PARAMETERS)) == 'parameters', &
      'an argument''s name is the name of the field')
    call compare('statuses', status, [(i, i=0, 8)])
    call texts('texts of the statuses', status, cte_status_message)
    call compare('request bits', request, [(2**i, i=0, 9)])
    call compare('kinds of unknowns', unknown_kind, [(i, i=1, 7)])
    call compare('entries of the output', output, [0, 1, 2, 3, 4, 6, 9, 10, 11, 13, 19, 21, 23])
    call compare('entries of the history', histories, [0, 1])
    call compare('verdicts', verdict, [(i, i=0, 4)])
    call compare('version numbers', version, [1, 0, 65536])
    call client_check(ishft(cte_abi_version(), -16) == CTE_VERSION_MAJOR .and. cte_abi_version() &
      >= CTE_ABI_VERSION_COMPILED, 'the library is no older than the header')
  end subroutine interface_constants_run

end module interface_constants
