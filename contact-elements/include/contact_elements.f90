! contact_elements.f90 - the Fortran side of contact_elements.h, shipped as source: compile it with the
! host's own compiler. The same names, the same layout; units, signs, shapes and failures are in the headers.
!
!   Indices      from 0, as in C: elements, nodes, unknowns, parameters, unknown_map and connectivity.
!   Memory       a fresh variable of a type below begins as by the header's initialisers: its size, scales of 1, zeros.
!                arguments = cte_arguments() begins again.
!   Arrays       x, u, f, k, ... are addresses: arguments%x = c_loc(x), with x a target.
!                x(dimension, nodes) is the header's [node][component].
!   Tangent      column-major k(ld, ld): k_row_stride = 1, k_col_stride = ld.
!   Unsigned     request bits, versions and the formulation hash arrive as signed integers of the same bits.
!   Text         const char * arrives as type(c_ptr); cte_string makes a Fortran string of it.
!   Null         an address that may be null is in a type, or in the procedures of cte_api_table; the
!                interfaces below take their scalar outputs by reference.
module contact_elements
  use, intrinsic :: iso_c_binding, only: c_char, c_double, c_int32_t, c_int64_t, c_ptr, c_funptr, &
    c_null_ptr, c_null_funptr, c_null_char, c_associated, c_f_pointer
  implicit none
  public
  private :: c_char, c_double, c_int32_t, c_int64_t, c_ptr, c_funptr
  private :: c_null_ptr, c_null_funptr, c_null_char, c_associated, c_f_pointer
  integer, parameter, private :: i4 = c_int32_t, i8 = c_int64_t, dp = c_double

  integer(i4), parameter :: CTE_VERSION_MAJOR = 1, CTE_VERSION_MINOR = 0
  integer(i4), parameter :: CTE_ABI_VERSION_COMPILED = ior(ishft(CTE_VERSION_MAJOR, 16), CTE_VERSION_MINOR)

  ! Return codes
  integer(i4), parameter :: CTE_SUCCESS = 0, CTE_CUT_BACK = 1
  integer(i4), parameter :: CTE_ERROR_NULL = -1, CTE_ERROR_STRUCT_SIZE = -2, CTE_ERROR_NODE_COUNT = -3
  integer(i4), parameter :: CTE_ERROR_PARAMETER = -4, CTE_ERROR_REQUEST = -5, CTE_ERROR_WORKSPACE = -6
  integer(i4), parameter :: CTE_ERROR_NOT_FINITE = -7, CTE_ERROR_INDEX = -8, CTE_ERROR_NAME = -9
  integer(i4), parameter :: CTE_ERROR_VERSION = -10, CTE_ERROR_STRIDE = -11, CTE_ERROR_HISTORY = -12
  integer(i4), parameter :: CTE_ERROR_ELEMENT = -13

  ! Arguments named by errors
  integer(i4), parameter :: CTE_ARGUMENT_NONE = 0, CTE_ARGUMENT_STRUCT_SIZE = 1, CTE_ARGUMENT_REQUEST = 2
  integer(i4), parameter :: CTE_ARGUMENT_NNODE = 3, CTE_ARGUMENT_NSLAVE = 4, CTE_ARGUMENT_X = 5
  integer(i4), parameter :: CTE_ARGUMENT_U = 6, CTE_ARGUMENT_PARAMETERS = 7, CTE_ARGUMENT_HISTORY_ACCEPTED = 8
  integer(i4), parameter :: CTE_ARGUMENT_HISTORY_TRIAL = 9, CTE_ARGUMENT_SLAVE_ROW = 10, CTE_ARGUMENT_F = 11
  integer(i4), parameter :: CTE_ARGUMENT_K = 12, CTE_ARGUMENT_K_STRIDE = 13, CTE_ARGUMENT_UNKNOWN_MAP = 14
  integer(i4), parameter :: CTE_ARGUMENT_SCALE = 15, CTE_ARGUMENT_OUTPUT = 16, CTE_ARGUMENT_ENERGY = 17
  integer(i4), parameter :: CTE_ARGUMENT_WORKSPACE = 18, CTE_ARGUMENT_ELEMENT = 19, CTE_ARGUMENT_INFO = 20
  integer(i4), parameter :: CTE_ARGUMENT_ELEMENT_NAME = 21, CTE_ARGUMENT_BATCH = 22
  integer(i4), parameter :: CTE_ARGUMENT_CONNECTIVITY = 23, CTE_ARGUMENT_CSR = 24, CTE_ARGUMENT_STATUS = 25
  integer(i4), parameter :: CTE_ARGUMENT_FROM = 26, CTE_ARGUMENT_FROM_OUTPUT = 27
  integer(i4), parameter :: CTE_ARGUMENT_FROM_HISTORY = 28, CTE_ARGUMENT_TO = 29
  integer(i4), parameter :: CTE_ARGUMENT_TO_OUTPUT = 30, CTE_ARGUMENT_TO_HISTORY = 31
  integer(i4), parameter :: CTE_ARGUMENT_REACH = 32, CTE_ARGUMENT_RESULT = 33
  integer(i4), parameter :: CTE_ARGUMENT_PATCH = 34, CTE_ARGUMENT_FACETS = 35, CTE_ARGUMENT_FACET = 36
  integer(i4), parameter :: CTE_ARGUMENT_EDGE = 37, CTE_ARGUMENT_VERTEX = 38
  integer(i4), parameter :: CTE_ARGUMENT_THREADS = 39

  ! Request bits
  integer(i4), parameter :: CTE_RESIDUAL = 1, CTE_TANGENT = 2, CTE_HISTORY = 4, CTE_OUTPUT = 8
  integer(i4), parameter :: CTE_ENERGY = 16, CTE_FREEZE_STATE = 32, CTE_SYMMETRISE = 64
  integer(i4), parameter :: CTE_PROJECTION_GIVEN = 128, CTE_SCREEN = 256, CTE_CSR_BY_BLOCKS = 512

  ! Status of a contact point
  integer(i4), parameter :: CTE_STATUS_OPEN = 0, CTE_STATUS_CLOSED = 1, CTE_STATUS_STICK = 2
  integer(i4), parameter :: CTE_STATUS_SLIP = 3, CTE_STATUS_OUTSIDE = 4
  integer(i4), parameter :: CTE_STATUS_NOT_CONVERGED = 5, CTE_STATUS_NOT_UNIQUE = 6
  integer(i4), parameter :: CTE_STATUS_DEGENERATE = 7, CTE_STATUS_LAW = 8

  ! Kinds of unknowns
  integer(i4), parameter :: CTE_UNKNOWN_UX = 1, CTE_UNKNOWN_UY = 2, CTE_UNKNOWN_UZ = 3
  integer(i4), parameter :: CTE_UNKNOWN_TX = 4, CTE_UNKNOWN_TY = 5, CTE_UNKNOWN_TZ = 6
  integer(i4), parameter :: CTE_UNKNOWN_MULTIPLIER = 7

  ! Output of one contact point, entries from 0: output(entry, point) needs output(0:CTE_OUTPUT_SIZE-1, *)
  integer(i4), parameter :: CTE_OUTPUT_STATUS = 0, CTE_OUTPUT_GAP = 1, CTE_OUTPUT_NORMAL_TRACTION = 2
  integer(i4), parameter :: CTE_OUTPUT_WEIGHT = 3, CTE_OUTPUT_PROJECTION = 4, CTE_OUTPUT_NORMAL = 6
  integer(i4), parameter :: CTE_OUTPUT_ITERATIONS = 9, CTE_OUTPUT_FEATURE = 10
  integer(i4), parameter :: CTE_OUTPUT_TANGENTIAL_TRACTION = 11, CTE_OUTPUT_TANGENTS = 13
  integer(i4), parameter :: CTE_OUTPUT_ANGLES = 19, CTE_OUTPUT_MOMENTS = 21, CTE_OUTPUT_SIZE = 23

  ! History of one contact point, entries from 0: status, projection, with friction anchor and slip path, with
  ! rolling the anchors and paths of both angles and the regime; of edges the normal; a multiplier last
  integer(i4), parameter :: CTE_HISTORY_STATUS = 0, CTE_HISTORY_PROJECTION = 1

  ! Verdict of a global projection
  integer(i4), parameter :: CTE_VERDICT_INSIDE = 0, CTE_VERDICT_BOUNDARY = 1, CTE_VERDICT_NOT_UNIQUE = 2
  integer(i4), parameter :: CTE_VERDICT_BEYOND = 3, CTE_VERDICT_UNDECIDED = 4

  ! What an element is
  type, bind(c) :: cte_info
    integer(c_int32_t) :: struct_size = 88
    integer(c_int32_t) :: dimension = 0
    integer(c_int32_t) :: nodes_minimum = 0
    integer(c_int32_t) :: nodes_maximum = 0
    integer(c_int32_t) :: slave_nodes = 0
    integer(c_int32_t) :: master_nodes = 0
    integer(c_int32_t) :: unknowns = 0
    integer(c_int32_t) :: parameters = 0
    integer(c_int32_t) :: history = 0
    integer(c_int32_t) :: points = 0
    integer(c_int32_t) :: projected = 0
    integer(c_int32_t) :: requests = 0
    integer(c_int32_t) :: symmetric = 0
    integer(c_int32_t) :: operations = 0
    integer(c_int64_t) :: workspace = 0
    integer(c_int64_t) :: formulation = 0
    type(c_ptr) :: name = c_null_ptr
    type(c_ptr) :: documentation = c_null_ptr
  end type cte_info

  ! One evaluation
  type, bind(c) :: cte_arguments
    ! what every call sets
    integer(c_int32_t) :: struct_size = 224
    integer(c_int32_t) :: request = 0
    integer(c_int32_t) :: nnode = 0
    integer(c_int32_t) :: parameter_count = 0
    type(c_ptr) :: x = c_null_ptr
    type(c_ptr) :: u = c_null_ptr
    type(c_ptr) :: parameters = c_null_ptr
    type(c_ptr) :: history_accepted = c_null_ptr
    type(c_ptr) :: history_trial = c_null_ptr
    type(c_ptr) :: f = c_null_ptr
    type(c_ptr) :: k = c_null_ptr
    type(c_ptr) :: output = c_null_ptr
    type(c_ptr) :: energy = c_null_ptr
    ! what some calls set
    real(c_double) :: f_scale = 1
    real(c_double) :: k_scale = 1
    integer(c_int64_t) :: k_row_stride = 0
    integer(c_int64_t) :: k_col_stride = 0
    type(c_ptr) :: unknown_map = c_null_ptr
    integer(c_int64_t) :: x_node_stride = 0
    integer(c_int64_t) :: u_node_stride = 0
    type(c_ptr) :: slave_row = c_null_ptr
    type(c_ptr) :: workspace = c_null_ptr
    integer(c_int64_t) :: workspace_size = 0
    integer(c_int32_t) :: nslave = 0
    integer(c_int32_t) :: padding = 0
    type(c_ptr) :: u_old = c_null_ptr
    type(c_ptr) :: v = c_null_ptr
    real(c_double) :: dt = 0
    ! what every call writes
    real(c_double) :: dt_ratio = 0
    integer(c_int32_t) :: status = 0
    integer(c_int32_t) :: closed_points = 0
    integer(c_int32_t) :: error_argument = 0
    integer(c_int32_t) :: error_index = 0
  end type cte_arguments

  ! Many contacts of one element
  type, bind(c) :: cte_batch
    ! what every call sets
    integer(c_int32_t) :: struct_size = 272
    integer(c_int32_t) :: request = 0
    integer(c_int32_t) :: parameter_count = 0
    integer(c_int32_t) :: nslave = 0
    type(c_ptr) :: x = c_null_ptr
    type(c_ptr) :: u = c_null_ptr
    type(c_ptr) :: parameters = c_null_ptr
    type(c_ptr) :: history_accepted = c_null_ptr
    type(c_ptr) :: history_trial = c_null_ptr
    type(c_ptr) :: status = c_null_ptr
    type(c_ptr) :: code = c_null_ptr
    ! gathered from and added to the host's global arrays
    type(c_ptr) :: connectivity = c_null_ptr
    integer(c_int64_t) :: global_nodes = 0
    type(c_ptr) :: global_f = c_null_ptr
    type(c_ptr) :: csr_values = c_null_ptr
    type(c_ptr) :: csr_map = c_null_ptr
    ! contact by contact
    type(c_ptr) :: f = c_null_ptr
    type(c_ptr) :: k = c_null_ptr
    type(c_ptr) :: output = c_null_ptr
    type(c_ptr) :: energy = c_null_ptr
    ! what some calls set
    real(c_double) :: f_scale = 1
    real(c_double) :: k_scale = 1
    integer(c_int64_t) :: x_element_stride = 0
    integer(c_int64_t) :: x_node_stride = 0
    integer(c_int64_t) :: x_component_stride = 0
    integer(c_int64_t) :: u_element_stride = 0
    integer(c_int64_t) :: u_node_stride = 0
    integer(c_int64_t) :: u_component_stride = 0
    integer(c_int64_t) :: parameter_element_stride = 0
    integer(c_int64_t) :: f_element_stride = 0
    integer(c_int64_t) :: k_element_stride = 0
    type(c_ptr) :: slave_row = c_null_ptr
    type(c_ptr) :: workspace = c_null_ptr
    integer(c_int64_t) :: workspace_size = 0
    ! what every call writes
    integer(c_int64_t) :: failed = 0
    integer(c_int32_t) :: error_argument = 0
    integer(c_int32_t) :: error_index = 0
  end type cte_batch

  ! A global projection of one contact point
  type, bind(c) :: cte_projection
    real(c_double) :: zeta(2) = 0
    real(c_double) :: distance = 0
    real(c_double) :: definiteness = 0
    integer(c_int32_t) :: verdict = 0
    integer(c_int32_t) :: feature = 0
    integer(c_int32_t) :: boxes = 0
    integer(c_int32_t) :: steps = 0
  end type cte_projection

  ! Facets that share edges and vertices
  type, bind(c) :: cte_patch
    integer(c_int32_t) :: struct_size = 56
    integer(c_int32_t) :: slave_points = 0
    integer(c_int32_t) :: master_nodes = 0
    integer(c_int32_t) :: facets = 0
    type(c_ptr) :: facet = c_null_ptr
    type(c_ptr) :: connectivity = c_null_ptr
    type(c_ptr) :: edge = c_null_ptr
    type(c_ptr) :: vertex = c_null_ptr
    real(c_double) :: reach = 0
  end type cte_patch

  ! The functions below in one table; c_f_procpointer makes procedure pointers of the entries
  type, bind(c) :: cte_api_table
    integer(c_int32_t) :: struct_size = 192
    integer(c_int32_t) :: version = 0
    type(c_funptr) :: element_count = c_null_funptr
    type(c_funptr) :: element_get = c_null_funptr
    type(c_funptr) :: element_find = c_null_funptr
    type(c_funptr) :: element_info = c_null_funptr
    type(c_funptr) :: element_unknown = c_null_funptr
    type(c_funptr) :: element_parameter = c_null_funptr
    type(c_funptr) :: element_check_parameters = c_null_funptr
    type(c_funptr) :: element_history_init = c_null_funptr
    type(c_funptr) :: element_evaluate = c_null_funptr
    type(c_funptr) :: element_batch_workspace = c_null_funptr
    type(c_funptr) :: element_evaluate_batch = c_null_funptr
    type(c_funptr) :: csr_map = c_null_funptr
    type(c_funptr) :: code_message = c_null_funptr
    type(c_funptr) :: status_message = c_null_funptr
    type(c_funptr) :: argument_name = c_null_funptr
    type(c_funptr) :: element_message = c_null_funptr
    type(c_funptr) :: history_transfer = c_null_funptr
    type(c_funptr) :: history_augment = c_null_funptr
    type(c_funptr) :: element_project = c_null_funptr
    type(c_funptr) :: patch_info = c_null_funptr
    type(c_funptr) :: patch_evaluate = c_null_funptr
    type(c_funptr) :: element_evaluate_batch_threads = c_null_funptr
    type(c_funptr) :: csr_blocks = c_null_funptr
  end type cte_api_table

  interface
    function cte_abi_version() bind(c, name='cte_abi_version') result(version)
      import :: i4
      integer(i4) :: version
    end function cte_abi_version

    function cte_element_count() bind(c, name='cte_element_count') result(count)
      import :: i4
      integer(i4) :: count
    end function cte_element_count

    ! const cte_element *: an opaque address, c_null_ptr outside 0 .. count-1
    function cte_element_get(index) bind(c, name='cte_element_get') result(element)
      import :: i4, c_ptr
      integer(i4), value :: index
      type(c_ptr) :: element
    end function cte_element_get

    function cte_element_find(name, length, index) bind(c, name='cte_element_find') result(code)
      import :: i4, c_char
      character(kind=c_char), intent(in) :: name(*)
      integer(i4), value :: length
      integer(i4), intent(inout) :: index
      integer(i4) :: code
    end function cte_element_find

    function cte_element_info(element, nnode, info) bind(c, name='cte_element_info') result(code)
      import :: i4, c_ptr, cte_info
      type(c_ptr), value :: element
      integer(i4), value :: nnode
      type(cte_info), intent(inout) :: info
      integer(i4) :: code
    end function cte_element_info

    function cte_element_unknown(element, nnode, index, node, kind) &
        bind(c, name='cte_element_unknown') result(code)
      import :: i4, c_ptr
      type(c_ptr), value :: element
      integer(i4), value :: nnode, index
      integer(i4), intent(inout) :: node, kind
      integer(i4) :: code
    end function cte_element_unknown

    function cte_element_parameter(element, index, name, unit, lower, upper, closed) &
        bind(c, name='cte_element_parameter') result(code)
      import :: i4, dp, c_ptr
      type(c_ptr), value :: element
      integer(i4), value :: index
      type(c_ptr), intent(inout) :: name, unit
      real(dp), intent(inout) :: lower, upper
      integer(i4), intent(inout) :: closed
      integer(i4) :: code
    end function cte_element_parameter

    function cte_element_check_parameters(element, parameters, count, index) &
        bind(c, name='cte_element_check_parameters') result(code)
      import :: i4, dp, c_ptr
      type(c_ptr), value :: element
      real(dp), intent(in) :: parameters(*)
      integer(i4), value :: count
      integer(i4), intent(inout) :: index
      integer(i4) :: code
    end function cte_element_check_parameters

    function cte_element_history_init(element, history) &
        bind(c, name='cte_element_history_init') result(code)
      import :: i4, dp, c_ptr
      type(c_ptr), value :: element
      real(dp), intent(inout) :: history(*)
      integer(i4) :: code
    end function cte_element_history_init

    function cte_history_transfer(from, from_output, from_history, to, to_output, to_history, argument) &
        bind(c, name='cte_history_transfer') result(code)
      import :: i4, dp, c_ptr
      type(c_ptr), value :: from, to
      real(dp), intent(in) :: from_output(*), from_history(*), to_output(*)
      real(dp), intent(inout) :: to_history(*)
      integer(i4), intent(inout) :: argument
      integer(i4) :: code
    end function cte_history_transfer

    function cte_history_augment(element, trial, accepted, argument) bind(c, name='cte_history_augment') result(code)
      import :: i4, dp, c_ptr
      type(c_ptr), value :: element
      real(dp), intent(in) :: trial(*)
      real(dp), intent(inout) :: accepted(*)
      integer(i4), intent(inout) :: argument
      integer(i4) :: code
    end function cte_history_augment

    ! result: one entry per contact point; history: c_null_ptr, or the address of the element's history
    function cte_element_project(element, arguments, reach, result, history) &
        bind(c, name='cte_element_project') result(code)
      import :: i4, dp, c_ptr, cte_arguments, cte_projection
      type(c_ptr), value :: element, history
      type(cte_arguments), intent(inout) :: arguments
      real(dp), value :: reach
      type(cte_projection), intent(inout) :: result(*)
      integer(i4) :: code
    end function cte_element_project

    function cte_patch_info(patch, info, argument) bind(c, name='cte_patch_info') result(code)
      import :: i4, cte_patch, cte_info
      type(cte_patch), intent(in) :: patch
      type(cte_info), intent(inout) :: info
      integer(i4), intent(out) :: argument
      integer(i4) :: code
    end function cte_patch_info

    function cte_patch_evaluate(patch, arguments) bind(c, name='cte_patch_evaluate') result(code)
      import :: i4, cte_patch, cte_arguments
      type(cte_patch), intent(in) :: patch
      type(cte_arguments), intent(inout) :: arguments
      integer(i4) :: code
    end function cte_patch_evaluate

    function cte_element_evaluate(element, arguments) bind(c, name='cte_element_evaluate') result(code)
      import :: i4, c_ptr, cte_arguments
      type(c_ptr), value :: element
      type(cte_arguments), intent(inout) :: arguments
      integer(i4) :: code
    end function cte_element_evaluate

    function cte_element_batch_workspace(element, nslave) &
        bind(c, name='cte_element_batch_workspace') result(doubles)
      import :: i4, i8, c_ptr
      type(c_ptr), value :: element
      integer(i4), value :: nslave
      integer(i8) :: doubles
    end function cte_element_batch_workspace

    function cte_element_evaluate_batch(element, n, batch) &
        bind(c, name='cte_element_evaluate_batch') result(code)
      import :: i4, i8, c_ptr, cte_batch
      type(c_ptr), value :: element
      integer(i8), value :: n
      type(cte_batch), intent(inout) :: batch
      integer(i4) :: code
    end function cte_element_evaluate_batch

    function cte_element_evaluate_batch_threads(element, n, batch, threads) &
        bind(c, name='cte_element_evaluate_batch_threads') result(code)
      import :: i4, i8, c_ptr, cte_batch
      type(c_ptr), value :: element
      integer(i8), value :: n
      type(cte_batch), intent(inout) :: batch
      integer(i4), value :: threads
      integer(i4) :: code
    end function cte_element_evaluate_batch_threads

    function cte_csr_map(element, n, nslave, connectivity, rows, row_start, column, map) &
        bind(c, name='cte_csr_map') result(code)
      import :: i4, i8, c_ptr
      type(c_ptr), value :: element
      integer(i8), value :: n, rows
      integer(i4), value :: nslave
      integer(i4), intent(in) :: connectivity(*), column(*)
      integer(i8), intent(in) :: row_start(*)
      integer(i8), intent(inout) :: map(*)
      integer(i4) :: code
    end function cte_csr_map

    function cte_csr_blocks(element, n, nslave, connectivity, rows, row_start, column, map) &
        bind(c, name='cte_csr_blocks') result(code)
      import :: i4, i8, c_ptr
      type(c_ptr), value :: element
      integer(i8), value :: n, rows
      integer(i4), value :: nslave
      integer(i4), intent(in) :: connectivity(*), column(*)
      integer(i8), intent(in) :: row_start(*)
      integer(i8), intent(inout) :: map(*)
      integer(i4) :: code
    end function cte_csr_blocks

    function cte_code_message(code) bind(c, name='cte_code_message') result(text)
      import :: i4, c_ptr
      integer(i4), value :: code
      type(c_ptr) :: text
    end function cte_code_message

    function cte_status_message(status) bind(c, name='cte_status_message') result(text)
      import :: i4, c_ptr
      integer(i4), value :: status
      type(c_ptr) :: text
    end function cte_status_message

    function cte_argument_name(argument) bind(c, name='cte_argument_name') result(text)
      import :: i4, c_ptr
      integer(i4), value :: argument
      type(c_ptr) :: text
    end function cte_argument_name

    function cte_element_message(element, arguments, code, text, size) &
        bind(c, name='cte_element_message') result(length)
      import :: i4, c_char, c_ptr, cte_arguments
      type(c_ptr), value :: element
      type(cte_arguments), intent(in) :: arguments
      integer(i4), value :: code, size
      character(kind=c_char), intent(inout) :: text(*)
      integer(i4) :: length
    end function cte_element_message

    function cte_api(major, table) bind(c, name='cte_api') result(code)
      import :: i4, cte_api_table
      integer(i4), value :: major
      type(cte_api_table), intent(inout) :: table
      integer(i4) :: code
    end function cte_api

    ! The Fortran 77 entries, for hosts that want their arguments checked; shapes in contact_elements_f77.h
    subroutine cte_f77_find(name, length, element, code) bind(c, name='cte_f77_find_')
      import :: i4
      integer(i4), intent(in) :: name(*), length
      integer(i4), intent(inout) :: element, code
    end subroutine cte_f77_find

    subroutine cte_f77_info(element, nnode, sizes, code) bind(c, name='cte_f77_info_')
      import :: i4
      integer(i4), intent(in) :: element, nnode
      integer(i4), intent(inout) :: sizes(*), code
    end subroutine cte_f77_info

    subroutine cte_f77_message(element, code, state, text, size, length) bind(c, name='cte_f77_message_')
      import :: i4
      integer(i4), intent(in) :: element, code, state(*), size
      integer(i4), intent(inout) :: text(*), length
    end subroutine cte_f77_message

    subroutine cte_f77_evaluate(element, request, nnode, nslave, x, ldx, u, ldu, parameters, &
        parameter_count, history_accepted, history_trial, slave_row, mapped, map, f_scale, k_scale, f, k, &
        ldk, output, energy, workspace, workspace_size, state, code) bind(c, name='cte_f77_evaluate_')
      import :: i4, dp
      integer(i4), intent(in) :: element, request, nnode, nslave, ldx, ldu, parameter_count, mapped, map(*), ldk
      integer(i4), intent(in) :: workspace_size
      real(dp), intent(in) :: x(*), u(*), parameters(*), history_accepted(*), slave_row(*), f_scale, k_scale
      real(dp), intent(inout) :: history_trial(*), f(*), k(ldk, *), output(*), energy, workspace(*)
      integer(i4), intent(inout) :: state(*), code
    end subroutine cte_f77_evaluate

    subroutine cte_f77_project(element, nnode, nslave, x, ldx, u, ldu, parameters, parameter_count, &
        slave_row, reach, result, history, state, code) bind(c, name='cte_f77_project_')
      import :: i4, dp
      integer(i4), intent(in) :: element, nnode, nslave, ldx, ldu, parameter_count
      real(dp), intent(in) :: x(*), u(*), parameters(*), slave_row(*), reach
      real(dp), intent(inout) :: result(*), history(*)
      integer(i4), intent(inout) :: state(*), code
    end subroutine cte_f77_project

    subroutine cte_f77_patch_info(numbers, connectivity, reach, sizes, argument, code) &
        bind(c, name='cte_f77_patch_info_')
      import :: i4, dp
      integer(i4), intent(in) :: numbers(*), connectivity(*)
      real(dp), intent(in) :: reach
      integer(i4), intent(inout) :: sizes(*), argument, code
    end subroutine cte_f77_patch_info

    subroutine cte_f77_patch_evaluate(numbers, connectivity, reach, request, nnode, x, ldx, u, ldu, &
        parameters, parameter_count, history_accepted, history_trial, mapped, map, f_scale, k_scale, f, k, &
        ldk, output, energy, workspace, workspace_size, state, code) bind(c, name='cte_f77_patch_evaluate_')
      import :: i4, dp
      integer(i4), intent(in) :: numbers(*), connectivity(*), request, nnode, ldx, ldu, parameter_count, mapped, map(*)
      integer(i4), intent(in) :: ldk, workspace_size
      real(dp), intent(in) :: reach, x(*), u(*), parameters(*), history_accepted(*), f_scale, k_scale
      real(dp), intent(inout) :: history_trial(*), f(*), k(ldk, *), output(*), energy, workspace(*)
      integer(i4), intent(inout) :: state(*), code
    end subroutine cte_f77_patch_evaluate

    subroutine cte_f77_batch(element, n, request, nslave, global_nodes, connectivity, x, ldx, u, ldu, &
        parameters, parameter_count, ldp, history_accepted, history_trial, slave_row, into, f_scale, &
        k_scale, f, k, global_f, csr_values, csr_map, output, energy, statuses, codes, workspace, &
        workspace_size, state, code) bind(c, name='cte_f77_batch_')
      import :: i4, i8, dp
      integer(i4), intent(in) :: element, n, request, nslave, global_nodes, connectivity(*), ldx, ldu
      integer(i4), intent(in) :: parameter_count, ldp, into, workspace_size
      real(dp), intent(in) :: x(*), u(*), parameters(*), history_accepted(*), slave_row(*), f_scale, k_scale
      integer(i8), intent(in) :: csr_map(*)
      real(dp), intent(inout) :: history_trial(*), f(*), k(*), global_f(*), csr_values(*), output(*), energy(*)
      real(dp), intent(inout) :: workspace(*)
      integer(i4), intent(inout) :: statuses(*), codes(*), state(*), code
    end subroutine cte_f77_batch

    subroutine cte_f77_csr_map(element, n, nslave, connectivity, rows, row_start, column, map, code) &
        bind(c, name='cte_f77_csr_map_')
      import :: i4, i8
      integer(i4), intent(in) :: element, n, nslave, connectivity(*), rows, column(*)
      integer(i8), intent(in) :: row_start(*)
      integer(i8), intent(inout) :: map(*)
      integer(i4), intent(inout) :: code
    end subroutine cte_f77_csr_map

    subroutine cte_f77_csr_blocks(element, n, nslave, connectivity, rows, row_start, column, map, code) &
        bind(c, name='cte_f77_csr_blocks_')
      import :: i4, i8
      integer(i4), intent(in) :: element, n, nslave, connectivity(*), rows, column(*)
      integer(i8), intent(in) :: row_start(*)
      integer(i8), intent(inout) :: map(*)
      integer(i4), intent(inout) :: code
    end subroutine cte_f77_csr_blocks

    subroutine cte_f77_history_init(element, history, code) bind(c, name='cte_f77_history_init_')
      import :: i4, dp
      integer(i4), intent(in) :: element
      real(dp), intent(inout) :: history(*)
      integer(i4), intent(inout) :: code
    end subroutine cte_f77_history_init

    subroutine cte_f77_history_transfer(from, from_output, from_history, to, to_output, to_history, &
        argument, code) bind(c, name='cte_f77_history_transfer_')
      import :: i4, dp
      integer(i4), intent(in) :: from, to
      real(dp), intent(in) :: from_output(*), from_history(*), to_output(*)
      real(dp), intent(inout) :: to_history(*)
      integer(i4), intent(inout) :: argument, code
    end subroutine cte_f77_history_transfer

    subroutine cte_f77_history_augment(element, trial, accepted, argument, code) &
        bind(c, name='cte_f77_history_augment_')
      import :: i4, dp
      integer(i4), intent(in) :: element
      real(dp), intent(in) :: trial(*)
      real(dp), intent(inout) :: accepted(*)
      integer(i4), intent(inout) :: argument, code
    end subroutine cte_f77_history_augment
  end interface

contains

  ! The zero-terminated text at an address as a Fortran string; empty for c_null_ptr.
  function cte_string(address) result(text)
    type(c_ptr), intent(in) :: address
    character(len=:), allocatable :: text
    integer, parameter :: longest = 65536 ! characters looked at
    character(kind=c_char), pointer :: letters(:)
    integer :: i, length
    length = 0
    if (c_associated(address)) then
      call c_f_pointer(address, letters, [longest])
      do while (length < longest)
        if (letters(length + 1) == c_null_char) exit
        length = length + 1
      end do
    end if
    allocate (character(len=length) :: text)
    do i = 1, length
      text(i:i) = letters(i)
    end do
  end function cte_string

end module contact_elements
