! bad_fortran77.f90 - the Fortran 77 entries with a null address in the place of every argument: a code, and the
! name of the argument where the entry has one to give; see bad_input.f90.
module bad_fortran77
  use, intrinsic :: iso_c_binding, only: c_loc, c_null_ptr, c_ptr
  use contact_elements
  use client_support
  implicit none
  private
  public :: bad_fortran77_run

  integer, parameter :: n = 15
  integer(i4), parameter :: untouched_value = -77
  integer(i4), parameter :: accepted = -1 ! null is allowed there, or not looked at
  integer(i4), parameter :: unseen = -2   ! the code itself
  integer, parameter :: state_argument = 3, size_unknowns = 6, size_points = 9 ! from 1
  type(bench), save, target :: b

  ! One contact of InterpolatedQuad4 with one slave node.
  integer(i4), save, target :: element, request, code, found, zero = 0, one = 1, nslave = 1, nodes = 5, unknowns = n
  integer(i4), save, target :: room, into = 2, statuses, codes, length = 10
  integer(i4), save, target :: map(n), sizes(13), state(4)
  integer(i4), save, target :: patch(6), facet(4) = [0, 1, 2, 3], contact(5) = [0, 1, 2, 3, 4]
  integer(i4), save, target :: name(10), column(n*n)
  integer(i8), save, target :: place(n*n), new_place(n*n), row_start(n + 1)
  real(dp), save, target :: factor = 1, reach = 0, sum_f(n), sum_k(n*n)

  ! The entries with every address by value.
  interface
    subroutine evaluate_at( &
        a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23, &
        a24, a25) &
        bind(c, name='cte_f77_evaluate_')
      import :: c_ptr
      type(c_ptr), value :: &
        a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23, &
        a24, a25
    end subroutine evaluate_at

    subroutine project_at( &
        a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14) &
        bind(c, name='cte_f77_project_')
      import :: c_ptr
      type(c_ptr), value :: &
        a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14
    end subroutine project_at

    subroutine patch_info_at( &
        a0, a1, a2, a3, a4, a5) &
        bind(c, name='cte_f77_patch_info_')
      import :: c_ptr
      type(c_ptr), value :: &
        a0, a1, a2, a3, a4, a5
    end subroutine patch_info_at

    subroutine patch_evaluate_at( &
        a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23, &
        a24, a25) &
        bind(c, name='cte_f77_patch_evaluate_')
      import :: c_ptr
      type(c_ptr), value :: &
        a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23, &
        a24, a25
    end subroutine patch_evaluate_at

    subroutine batch_at( &
        a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23, &
        a24, a25, a26, a27, a28, a29, a30, a31) &
        bind(c, name='cte_f77_batch_')
      import :: c_ptr
      type(c_ptr), value :: &
        a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23, &
        a24, a25, a26, a27, a28, a29, a30, a31
    end subroutine batch_at

    subroutine find_at( &
        a0, a1, a2, a3) &
        bind(c, name='cte_f77_find_')
      import :: c_ptr
      type(c_ptr), value :: &
        a0, a1, a2, a3
    end subroutine find_at

    subroutine info_at( &
        a0, a1, a2, a3) &
        bind(c, name='cte_f77_info_')
      import :: c_ptr
      type(c_ptr), value :: &
        a0, a1, a2, a3
    end subroutine info_at

    subroutine csr_map_at( &
        a0, a1, a2, a3, a4, a5, a6, a7, a8) &
        bind(c, name='cte_f77_csr_map_')
      import :: c_ptr
      type(c_ptr), value :: &
        a0, a1, a2, a3, a4, a5, a6, a7, a8
    end subroutine csr_map_at

    subroutine csr_blocks_at( &
        a0, a1, a2, a3, a4, a5, a6, a7, a8) &
        bind(c, name='cte_f77_csr_blocks_')
      import :: c_ptr
      type(c_ptr), value :: &
        a0, a1, a2, a3, a4, a5, a6, a7, a8
    end subroutine csr_blocks_at
  end interface

contains

  subroutine call_at(door, p)
    character(len=*), intent(in) :: door
    type(c_ptr), intent(in) :: p(:)
    select case (door)
    case ('evaluate')
      call evaluate_at( &
        p(1), p(2), p(3), p(4), p(5), p(6), p(7), p(8), p(9), p(10), p(11), p(12), p(13), p(14), p(15), p(16), p(17), &
        p(18), p(19), p(20), p(21), p(22), p(23), p(24), p(25), p(26))
    case ('project')
      call project_at( &
        p(1), p(2), p(3), p(4), p(5), p(6), p(7), p(8), p(9), p(10), p(11), p(12), p(13), p(14), p(15))
    case ('patch_info')
      call patch_info_at( &
        p(1), p(2), p(3), p(4), p(5), p(6))
    case ('patch_evaluate')
      call patch_evaluate_at( &
        p(1), p(2), p(3), p(4), p(5), p(6), p(7), p(8), p(9), p(10), p(11), p(12), p(13), p(14), p(15), p(16), p(17), &
        p(18), p(19), p(20), p(21), p(22), p(23), p(24), p(25), p(26))
    case ('batch')
      call batch_at( &
        p(1), p(2), p(3), p(4), p(5), p(6), p(7), p(8), p(9), p(10), p(11), p(12), p(13), p(14), p(15), p(16), p(17), &
        p(18), p(19), p(20), p(21), p(22), p(23), p(24), p(25), p(26), p(27), p(28), p(29), p(30), p(31), p(32))
    case ('find')
      call find_at( &
        p(1), p(2), p(3), p(4))
    case ('info')
      call info_at( &
        p(1), p(2), p(3), p(4))
    case ('csr_map')
      call csr_map_at( &
        p(1), p(2), p(3), p(4), p(5), p(6), p(7), p(8), p(9))
    case ('csr_blocks')
      call csr_blocks_at( &
        p(1), p(2), p(3), p(4), p(5), p(6), p(7), p(8), p(9))
    end select
  end subroutine call_at

  ! Nothing of the caller's arrays has changed.
  function untouched() result(pass)
    logical :: pass
    pass = bench_untouched(b) .and. found == untouched_value .and. all(abs(sum_f) <= 0) .and. all(abs(sum_k) <= 0) &
      .and. all(new_place == untouched_value)
  end function untouched

  subroutine fresh()
    call bench_canary(b)
    code = untouched_value
    found = untouched_value
    state = untouched_value
    new_place = untouched_value
    sum_f = 0
    sum_k = 0
  end subroutine fresh

  ! Each of the addresses null in turn.
  subroutine nulls(door, p, expected)
    character(len=*), intent(in) :: door
    type(c_ptr), intent(in) :: p(:)
    integer(i4), intent(in) :: expected(:)
    type(c_ptr) :: q(size(p))
    logical :: pass
    integer :: i
    do i = 1, size(p)
      q = p
      q(i) = c_null_ptr
      call fresh()
      call call_at(door, q)
      select case (expected(i))
      case (accepted)
        pass = code == CTE_SUCCESS
      case (unseen)
        pass = code == untouched_value
      case default
        pass = code == CTE_ERROR_NULL .and. untouched() &
          .and. (expected(i) == CTE_ARGUMENT_NONE .or. state(state_argument) == expected(i))
      end select
      call client_check(pass, client_text('F77 '//door, i - 1_i8))
    end do
  end subroutine nulls

  subroutine evaluate_nulls()
    call nulls('evaluate', [ &
      c_loc(element), c_loc(request), c_loc(zero), c_loc(nslave), c_loc(b%x), c_loc(zero), c_loc(b%u), c_loc(zero), &
      c_loc(b%parameters), c_loc(b%info%parameters), c_loc(b%history_accepted), c_loc(b%out%history_trial), &
      c_loc(b%row), c_loc(one), c_loc(map), c_loc(factor), c_loc(factor), c_loc(b%out%f), c_loc(b%out%k), &
      c_loc(unknowns), c_loc(b%out%output), c_loc(b%out%energy), c_loc(b%workspace), c_loc(room), c_loc(state), &
      c_loc(code)], [ &
      CTE_ARGUMENT_ELEMENT, CTE_ARGUMENT_REQUEST, CTE_ARGUMENT_NNODE, CTE_ARGUMENT_NSLAVE, CTE_ARGUMENT_X, &
      CTE_ARGUMENT_X, accepted, CTE_ARGUMENT_U, CTE_ARGUMENT_PARAMETERS, CTE_ARGUMENT_PARAMETERS, accepted, &
      CTE_ARGUMENT_HISTORY_TRIAL, CTE_ARGUMENT_SLAVE_ROW, CTE_ARGUMENT_UNKNOWN_MAP, CTE_ARGUMENT_UNKNOWN_MAP, &
      CTE_ARGUMENT_SCALE, CTE_ARGUMENT_SCALE, CTE_ARGUMENT_F, CTE_ARGUMENT_K, CTE_ARGUMENT_K_STRIDE, &
      CTE_ARGUMENT_OUTPUT, CTE_ARGUMENT_ENERGY, CTE_ARGUMENT_WORKSPACE, CTE_ARGUMENT_WORKSPACE, accepted, unseen])
  end subroutine evaluate_nulls

  subroutine project_nulls()
    call nulls('project', [ &
      c_loc(element), c_loc(zero), c_loc(nslave), c_loc(b%x), c_loc(zero), c_loc(b%u), c_loc(zero), &
      c_loc(b%parameters), c_loc(b%info%parameters), c_loc(b%row), c_loc(reach), c_loc(b%out%output), &
      c_loc(b%out%history_trial), c_loc(state), c_loc(code)], [ &
      CTE_ARGUMENT_ELEMENT, CTE_ARGUMENT_NNODE, CTE_ARGUMENT_NSLAVE, CTE_ARGUMENT_X, CTE_ARGUMENT_X, accepted, &
      CTE_ARGUMENT_U, CTE_ARGUMENT_PARAMETERS, CTE_ARGUMENT_PARAMETERS, CTE_ARGUMENT_SLAVE_ROW, CTE_ARGUMENT_REACH, &
      CTE_ARGUMENT_RESULT, accepted, accepted, unseen])
  end subroutine project_nulls

  subroutine patch_info_nulls()
    call nulls('patch_info', [ &
      c_loc(patch), c_loc(facet), c_loc(reach), c_loc(sizes), c_loc(state(state_argument)), c_loc(code)], [ &
      CTE_ARGUMENT_PATCH, CTE_ARGUMENT_CONNECTIVITY, CTE_ARGUMENT_REACH, CTE_ARGUMENT_INFO, accepted, unseen])
  end subroutine patch_info_nulls

  subroutine patch_evaluate_nulls()
    call nulls('patch_evaluate', [ &
      c_loc(patch), c_loc(facet), c_loc(reach), c_loc(request), c_loc(zero), c_loc(b%x), c_loc(zero), c_loc(b%u), &
      c_loc(zero), c_loc(b%parameters), c_loc(b%info%parameters), c_loc(b%history_accepted), &
      c_loc(b%out%history_trial), c_loc(one), c_loc(map), c_loc(factor), c_loc(factor), c_loc(b%out%f), &
      c_loc(b%out%k), c_loc(unknowns), c_loc(b%out%output), c_loc(b%out%energy), c_loc(b%workspace), c_loc(room), &
      c_loc(state), c_loc(code)], [ &
      CTE_ARGUMENT_PATCH, CTE_ARGUMENT_CONNECTIVITY, CTE_ARGUMENT_REACH, CTE_ARGUMENT_REQUEST, CTE_ARGUMENT_NNODE, &
      CTE_ARGUMENT_X, CTE_ARGUMENT_X, accepted, CTE_ARGUMENT_U, CTE_ARGUMENT_PARAMETERS, CTE_ARGUMENT_PARAMETERS, &
      accepted, CTE_ARGUMENT_HISTORY_TRIAL, CTE_ARGUMENT_UNKNOWN_MAP, CTE_ARGUMENT_UNKNOWN_MAP, CTE_ARGUMENT_SCALE, &
      CTE_ARGUMENT_SCALE, CTE_ARGUMENT_F, CTE_ARGUMENT_K, CTE_ARGUMENT_K_STRIDE, CTE_ARGUMENT_OUTPUT, &
      CTE_ARGUMENT_ENERGY, CTE_ARGUMENT_WORKSPACE, CTE_ARGUMENT_WORKSPACE, accepted, unseen])
  end subroutine patch_evaluate_nulls

  subroutine batch_nulls()
    call nulls('batch', [ &
      c_loc(element), c_loc(one), c_loc(request), c_loc(nslave), c_loc(nodes), c_loc(contact), c_loc(b%x), &
      c_loc(zero), c_loc(b%u), c_loc(zero), c_loc(b%parameters), c_loc(b%info%parameters), c_loc(zero), &
      c_loc(b%history_accepted), c_loc(b%out%history_trial), c_loc(b%row), c_loc(into), c_loc(factor), c_loc(factor), &
      c_loc(b%out%f), c_loc(b%out%k), c_loc(sum_f), c_loc(sum_k), c_loc(place), c_loc(b%out%output), &
      c_loc(b%out%energy), c_loc(statuses), c_loc(codes), c_loc(b%workspace), c_loc(room), c_loc(state), c_loc(code)], [ &
      CTE_ARGUMENT_ELEMENT, CTE_ARGUMENT_BATCH, CTE_ARGUMENT_REQUEST, CTE_ARGUMENT_NSLAVE, CTE_ARGUMENT_CONNECTIVITY, &
      CTE_ARGUMENT_CONNECTIVITY, CTE_ARGUMENT_X, CTE_ARGUMENT_X, accepted, CTE_ARGUMENT_U, CTE_ARGUMENT_PARAMETERS, &
      CTE_ARGUMENT_PARAMETERS, CTE_ARGUMENT_PARAMETERS, accepted, CTE_ARGUMENT_HISTORY_TRIAL, CTE_ARGUMENT_SLAVE_ROW, &
      CTE_ARGUMENT_REQUEST, CTE_ARGUMENT_SCALE, CTE_ARGUMENT_SCALE, accepted, accepted, CTE_ARGUMENT_F, &
      CTE_ARGUMENT_K, CTE_ARGUMENT_CSR, CTE_ARGUMENT_OUTPUT, CTE_ARGUMENT_ENERGY, CTE_ARGUMENT_STATUS, accepted, &
      CTE_ARGUMENT_WORKSPACE, CTE_ARGUMENT_WORKSPACE, accepted, unseen])
  end subroutine batch_nulls

  subroutine find_nulls()
    call nulls('find', [ &
      c_loc(name), c_loc(length), c_loc(found), c_loc(code)], [ &
      CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE, unseen])
  end subroutine find_nulls

  subroutine info_nulls()
    call nulls('info', [ &
      c_loc(element), c_loc(zero), c_loc(sizes), c_loc(code)], [ &
      CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE, unseen])
  end subroutine info_nulls

  subroutine csr_map_nulls()
    call nulls('csr_map', [ &
      c_loc(element), c_loc(one), c_loc(nslave), c_loc(contact), c_loc(unknowns), c_loc(row_start), c_loc(column), &
      c_loc(new_place), c_loc(code)], [ &
      CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE, &
      CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE, unseen])
  end subroutine csr_map_nulls

  subroutine csr_blocks_nulls()
    call nulls('csr_blocks', [ &
      c_loc(element), c_loc(one), c_loc(nslave), c_loc(contact), c_loc(unknowns), c_loc(row_start), c_loc(column), &
      c_loc(new_place), c_loc(code)], [ &
      CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE, &
      CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE, unseen])
  end subroutine csr_blocks_nulls

  ! An index that no element has, in every place that takes one.
  subroutine indices()
    integer(i4) :: wrong, argument
    wrong = cte_element_count()
    argument = untouched_value
    call fresh()
    patch(5) = wrong
    call cte_f77_patch_info(patch, facet, reach, sizes, argument, code)
    call client_check(code == CTE_ERROR_INDEX .and. argument == CTE_ARGUMENT_EDGE .and. sizes(size_points) == -1, &
      'F77 patch_info, edge')
    patch(5) = -1
    patch(4) = -1
    call cte_f77_patch_info(patch, facet, reach, sizes, argument, code)
    call client_check(code == CTE_ERROR_INDEX .and. argument == CTE_ARGUMENT_FACET, 'F77 patch_info, facet')
    call cte_f77_info(wrong, zero, sizes, code)
    call client_check(code == CTE_ERROR_INDEX .and. sizes(size_unknowns) == -1, 'F77 info, element')
    call cte_f77_csr_map(wrong, one, nslave, contact, unknowns, row_start, column, new_place, code)
    call client_check(code == CTE_ERROR_INDEX .and. untouched(), 'F77 csr_map, element')
    name(1) = 400
    call cte_f77_find(name, length, found, code)
    call client_check(code == CTE_ERROR_NAME .and. found == untouched_value, 'F77 find, no character')
    length = -1
    call cte_f77_find(name, length, found, code)
    call client_check(code == CTE_ERROR_NAME .and. found == untouched_value, 'F77 find, length')
  end subroutine indices

  ! Messages take anything.
  subroutine messages()
    integer(i4) :: text(8), needed
    needed = untouched_value
    code = CTE_ERROR_NULL
    text = untouched_value
    state(state_argument) = CTE_ARGUMENT_NONE
    call cte_f77_message(-5_i4, code, state, text, 8_i4, needed)
    call client_check(needed > 8 .and. text(1) == iachar('a') .and. text(8) == iachar('r'), 'F77 message cut')
    text(1) = untouched_value
    call cte_f77_message(element, code, state, text, -1_i4, needed)
    call client_check(text(1) == untouched_value .and. needed > 8, 'F77 message of size -1')
  end subroutine messages

  subroutine bad_fortran77_run()
    character(len=*), parameter :: facet_name = 'PointQuad4', own_name = 'InterpolatedQuad4'
    integer :: i
    call bench_open(b, own_name)
    if (cte_element_find(own_name, len(own_name), element) /= CTE_SUCCESS) return
    request = CTE_RESIDUAL + CTE_TANGENT + CTE_HISTORY + CTE_OUTPUT + CTE_ENERGY
    room = int(b%info%workspace, i4)
    map = [(i, i=0, n - 1)]
    row_start = [(n*i, i=0, n)]
    place = [(i, i=0, n*n - 1)]
    column = [(mod(i, n), i=0, n*n - 1)]
    name = [(iachar(facet_name(i:i)), i=1, 10)]
    call evaluate_nulls()
    call project_nulls()
    call batch_nulls()
    call find_nulls()
    call info_nulls()
    call csr_map_nulls()
    call csr_blocks_nulls()
    ! a slave point and a facet: the same nodes
    patch = [1, 4, 1, 0, -1, -1]
    if (cte_element_find(facet_name, len(facet_name), patch(4)) /= CTE_SUCCESS) return
    call patch_info_nulls()
    call patch_evaluate_nulls()
    call indices()
    call messages()
  end subroutine bad_fortran77_run

end module bad_fortran77
