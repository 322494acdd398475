! bad_multipliers.f90 - bad input to elements with multipliers and to cte_history_augment; see bad_input.f90.
module bad_multipliers
  use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
  use, intrinsic :: iso_c_binding, only: c_f_procpointer, c_loc, c_null_ptr, c_ptr
  use contact_elements
  use client_support
  implicit none
  private
  public :: bad_multipliers_run

  integer, parameter :: n = 16, lambda = 16, history_size = 7, multiplier_at = 7 ! entries from 1
  integer(i4), parameter :: untouched = -77
  character(len=*), parameter :: element = 'PointQuad4Multiplier', frictional = 'PointQuad4CoulombAugmented'
  type(bench), save, target :: b, next
  type(cte_batch), save :: batch ! two contacts
  real(dp), save, target :: x(18, 2), u(18, 2), f(n, 2), k(n*n, 2)
  integer(i4), save, target :: status(2), code(2), connectivity(6, 2)

  ! The function with every address by value.
  abstract interface
    function augment_call(element, trial, accepted, argument) bind(c) result(code)
      import :: i4, c_ptr
      type(c_ptr), value :: element, trial, accepted, argument
      integer(i4) :: code
    end function augment_call
  end interface

contains

  ! The caller's fault, nothing written; entry from 0.
  subroutine expect(what, wanted, argument, entry)
    character(len=*), intent(in) :: what
    integer(i4), intent(in) :: wanted, argument
    integer, intent(in) :: entry
    integer(i4) :: found
    logical :: pass
    call bench_canary(b)
    found = bench_evaluate(b)
    pass = found == wanted .and. b%a%error_argument == argument .and. b%a%error_index == entry &
      .and. bench_untouched(b) .and. client_contains(client_message(b, found), cte_string(cte_argument_name(argument)))
    call client_check(pass, what)
    if (.not. pass) print '(5(a,i0))', '     code ', found, ' wanted ', wanted, ', argument ', b%a%error_argument, &
      ', index ', b%a%error_index, ' wanted ', entry
  end subroutine expect

  ! A result with finite numbers, or a code and untouched arrays; no trap.
  function clean() result(pass)
    logical :: pass
    integer :: m
    call bench_canary(b)
    m = b%info%unknowns
    if (bench_evaluate(b) == CTE_SUCCESS) then
      pass = all(ieee_is_finite(b%out%f(:m))) .and. all(ieee_is_finite(b%out%k(:m*m))) &
        .and. all(ieee_is_finite(b%out%history_trial(:b%info%history))) .and. ieee_is_finite(b%out%energy(1))
    else
      pass = bench_untouched(b)
    end if
  end function clean

  ! A call of cte_history_augment that must not write.
  function refused(wanted, argument) result(pass)
    integer(i4), intent(in) :: wanted, argument
    logical :: pass
    integer(i8) :: before(room_history)
    integer(i4) :: found, named
    before = transfer(b%history_accepted, before)
    named = untouched
    found = cte_history_augment(b%element, b%out%history_trial, b%history_accepted, named)
    pass = found == wanted .and. named == argument .and. all(before == transfer(b%history_accepted, before))
    if (.not. pass) print '(4(a,i0))', '     code ', found, ' wanted ', wanted, ', argument ', named, ' not ', argument
  end function refused

  ! Accepted and trial history of a point in contact.
  subroutine accepted(any_bench, name)
    type(bench), intent(inout), target :: any_bench
    character(len=*), intent(in) :: name
    integer :: length
    logical :: pass
    call bench_open(any_bench, name)
    pass = bench_evaluate(any_bench) == CTE_SUCCESS
    length = any_bench%info%history
    any_bench%history_accepted(:length) = any_bench%out%history_trial(:length)
    pass = bench_evaluate(any_bench) == CTE_SUCCESS .and. pass
    if (.not. pass) call client_check(.false., name)
  end subroutine accepted

  subroutine augment_null()
    integer(i4), parameter :: argument(3) = [CTE_ARGUMENT_ELEMENT, CTE_ARGUMENT_HISTORY_TRIAL, CTE_ARGUMENT_HISTORY_ACCEPTED]
    integer(i4), target :: named(3)
    type(cte_api_table) :: api
    procedure(augment_call), pointer :: augment
    type(c_ptr) :: p(3), q(3)
    real(dp) :: kept(room_history)
    logical :: pass
    integer :: i
    pass = cte_api(CTE_VERSION_MAJOR, api) == CTE_SUCCESS
    call c_f_procpointer(api%history_augment, augment)
    call accepted(b, frictional)
    kept = b%history_accepted
    p = [b%element, c_loc(b%out%history_trial), c_loc(b%history_accepted)]
    named = untouched
    do i = 1, 3
      q = p
      q(i) = c_null_ptr
      pass = augment(q(1), q(2), q(3), c_loc(named(i))) == CTE_ERROR_NULL .and. pass
    end do
    call client_check(pass .and. all(named == argument) .and. client_same(kept, b%history_accepted), &
      'augment: each pointer null')
    pass = augment(c_null_ptr, c_null_ptr, c_null_ptr, c_null_ptr) == CTE_ERROR_NULL
    call client_check(pass, 'augment: argument null')
  end subroutine augment_null

  subroutine augment_elements()
    character(len=27), parameter :: name(4) = [character(len=27) :: 'PointQuad4', 'PointQuad4Coulomb', element, &
      'PointQuad4CoulombMultiplier']
    integer(i4) :: found, named
    integer :: i
    do i = 1, 4
      call accepted(b, trim(name(i)))
      call client_check(refused(CTE_ERROR_ELEMENT, CTE_ARGUMENT_ELEMENT), &
        client_text('augment: no multiplier in the history', i - 1_i8))
    end do
    found = untouched
    named = untouched
    call cte_f77_history_augment(cte_element_count(), b%out%history_trial, b%history_accepted, named, found)
    call client_check(found == CTE_ERROR_INDEX .and. named == CTE_ARGUMENT_ELEMENT, &
      'F77 augment, element out of range')
  end subroutine augment_elements

  ! Entries that no evaluation writes, in the trial history or in the accepted one; number tells which.
  subroutine augment_values(history, argument, number)
    real(dp), intent(inout), target :: history(:) ! of b
    integer(i4), intent(in) :: argument
    integer(i8), intent(in) :: number
    real(dp), parameter :: no_status(4) = [-1.0_dp, 9.0_dp, 2.5_dp, 1e30_dp], &
      positive(4) = [1e-307_dp, 1e-300_dp, 1.0_dp, 1e30_dp]
    real(dp) :: kept
    logical :: finite, sign, status
    integer :: last, entry, i
    last = b%info%history
    finite = .true.
    sign = .true.
    status = .true.
    do entry = 1, last
      kept = history(entry)
      do i = 1, client_specials
        call client_special(i, history(entry))
        finite = refused(CTE_ERROR_NOT_FINITE, argument) .and. finite
      end do
      history(entry) = kept
    end do
    kept = history(last)
    do i = 1, 4
      history(last) = positive(i)
      sign = refused(CTE_ERROR_HISTORY, argument) .and. sign
    end do
    history(last) = kept
    do i = 1, 4
      history(1) = no_status(i)
      status = refused(CTE_ERROR_HISTORY, argument) .and. status
    end do
    call client_check(finite, client_text('augment: no number in history', number))
    call client_check(sign, client_text('augment: positive multiplier in history', number))
    call client_check(status, client_text('augment: no status in history', number))
  end subroutine augment_values

  ! The last of four points is bad: the others stay as they were.
  subroutine augment_points()
    integer(i4) :: e
    logical :: pass
    pass = cte_element_find('Quad4Quad4CoulombAugmented', 26, e) == CTE_SUCCESS
    if (pass) pass = bench_index(b, e, 0_i4)
    b%out%history_trial = b%history_accepted
    b%out%history_trial(multiplier_at:4*history_size:history_size) = [-1, -1, -1, 1]
    if (pass) pass = refused(CTE_ERROR_HISTORY, CTE_ARGUMENT_HISTORY_TRIAL)
    call client_check(pass, 'augment: the last of four points is bad')
  end subroutine augment_points

  subroutine histories(name)
    character(len=*), intent(in) :: name
    real(dp), parameter :: positive(2) = [1e-307_dp, 1.0_dp]
    integer :: i, last
    call accepted(b, name)
    last = b%info%history
    do i = 1, client_specials
      call client_special(i, b%history_accepted(last))
      call expect(client_text('history: no number as multiplier', i - 1_i8), CTE_ERROR_NOT_FINITE, &
        CTE_ARGUMENT_HISTORY_ACCEPTED, last - 1)
    end do
    do i = 1, 2
      b%history_accepted(last) = positive(i)
      call expect(client_text('history: positive multiplier', i - 1_i8), CTE_ERROR_HISTORY, CTE_ARGUMENT_HISTORY_ACCEPTED, &
        last - 1)
    end do
    b%history_accepted(last) = -0.0_dp
    call client_check(clean(), 'history: a multiplier of minus zero')
    b%history_accepted(1) = 2.5_dp
    call expect('history with a multiplier: no status', CTE_ERROR_HISTORY, CTE_ARGUMENT_HISTORY_ACCEPTED, 0)
  end subroutine histories

  ! In u of the node; x and the other components are not read.
  subroutine unknowns()
    logical :: pass
    integer :: special, i
    pass = .true.
    do special = 1, client_specials
      call bench_open(b, element)
      call client_special(special, b%u(lambda))
      call expect(client_text('no number as multiplier', special - 1_i8), CTE_ERROR_NOT_FINITE, CTE_ARGUMENT_U, 5)
      b%u(lambda) = -1
      do i = 0, 2
        call client_special(special, b%x(lambda + i))
        if (i > 0) call client_special(special, b%u(lambda + i))
      end do
      pass = clean() .and. pass
      pass = pass .and. b%a%status == CTE_STATUS_CLOSED
    end do
    call client_check(pass, 'no number in x and the rest of u of a multiplier''s node')
  end subroutine unknowns

  subroutine unknowns_of_points()
    integer(i4) :: e
    integer :: node
    if (cte_element_find('Quad4Quad4Multiplier', 20, e) /= CTE_SUCCESS) return
    if (.not. bench_index(b, e, 0_i4)) return
    do node = 8, 11
      call client_special(1, b%u(3*node + 1))
      call expect(client_text('no number as multiplier, node', node + 0_i8), CTE_ERROR_NOT_FINITE, CTE_ARGUMENT_U, node)
      b%u(3*node + 1) = 0
    end do
  end subroutine unknowns_of_points

  ! Counts, strides and maps that leave out the multiplier.
  subroutine layouts()
    integer(i8), parameter :: k_stride(2, 2) = reshape([15_i8, 1_i8, 1_i8, 15_i8], [2, 2])
    integer(i4), parameter :: nnode(2) = [5, 7]
    integer(i4), target :: map(n)
    integer :: i
    do i = 1, 2
      call bench_open(b, element)
      b%a%k_row_stride = k_stride(1, i)
      b%a%k_col_stride = k_stride(2, i)
      call expect(client_text('k strides too small for the multiplier', i - 1_i8), CTE_ERROR_STRIDE, &
        CTE_ARGUMENT_K_STRIDE, 0)
      call bench_open(b, element)
      b%a%nnode = nnode(i)
      call expect(client_text('multiplier, nnode', int(nnode(i), i8)), CTE_ERROR_NODE_COUNT, CTE_ARGUMENT_NNODE, 0)
    end do
    call bench_open(b, 'InterpolatedQuad4Multiplier')
    b%a%nnode = 5
    call expect('interpolated, no node for the multiplier', CTE_ERROR_NODE_COUNT, CTE_ARGUMENT_NNODE, 0)
    map = [(i, i=0, n - 1)]
    call bench_open(b, element)
    b%a%unknown_map = c_loc(map)
    map(lambda) = -1
    call expect('unknown_map negative for the multiplier', CTE_ERROR_INDEX, CTE_ARGUMENT_UNKNOWN_MAP, lambda - 1)
    map(lambda) = 20
    b%a%k_row_stride = 20
    b%a%k_col_stride = 1
    call expect('unknown_map beyond the row stride for the multiplier', CTE_ERROR_STRIDE, CTE_ARGUMENT_K_STRIDE, 0)
  end subroutine layouts

  ! Two contacts on nodes of their own, gathered by connectivity.
  subroutine fresh()
    type(cte_batch) :: zero
    integer :: a
    batch = zero
    f = canary()
    call bench_open(b, element)
    x = spread(b%x(:18), 2, 2)
    u = spread(b%u(:18), 2, 2)
    code = untouched
    connectivity = reshape([(a, a=0, 11)], [6, 2])
    batch%request = CTE_RESIDUAL + CTE_TANGENT
    batch%parameter_count = b%info%parameters
    batch%x = c_loc(x)
    batch%u = c_loc(u)
    batch%connectivity = c_loc(connectivity)
    batch%global_nodes = 12
    batch%parameters = c_loc(b%parameters)
    batch%f = c_loc(f)
    batch%k = c_loc(k)
    batch%status = c_loc(status)
    batch%code = c_loc(code)
  end subroutine fresh

  ! Refuses the batch, touching nothing.
  subroutine refuse(what, wanted, argument, entry)
    character(len=*), intent(in) :: what
    integer(i4), intent(in) :: wanted, argument
    integer, intent(in) :: entry
    integer(i4) :: found
    logical :: pass
    found = cte_element_evaluate_batch(b%element, 2_i8, batch)
    pass = found == wanted .and. batch%error_argument == argument .and. batch%error_index == entry &
      .and. code(1) == untouched
    call client_check(pass, what)
    if (.not. pass) print '(4(a,i0))', '     code ', found, ' wanted ', wanted, ', argument ', batch%error_argument, &
      ', index ', batch%error_index
  end subroutine refuse

  subroutine batches()
    integer(i4) :: found
    call fresh()
    batch%f_element_stride = n - 1
    call refuse('batch: f stride too small for the multiplier', CTE_ERROR_STRIDE, CTE_ARGUMENT_F, 0)
    call fresh()
    batch%k_element_stride = n*n - 1
    call refuse('batch: k stride too small for the multiplier', CTE_ERROR_STRIDE, CTE_ARGUMENT_K_STRIDE, 0)
    call fresh()
    connectivity(6, 2) = 12
    call refuse('batch: the multiplier''s node out of range', CTE_ERROR_INDEX, CTE_ARGUMENT_CONNECTIVITY, 11)
    call fresh()
    call client_special(1, u(lambda, 2))
    found = cte_element_evaluate_batch(b%element, 2_i8, batch)
    call client_check(found == CTE_CUT_BACK .and. batch%failed == 1 .and. batch%error_argument == CTE_ARGUMENT_U &
      .and. batch%error_index == 1 .and. code(1) == CTE_SUCCESS .and. code(2) == CTE_ERROR_NOT_FINITE &
      .and. client_same(f(n:, 2), [canary()]), 'batch: a bad multiplier fails alone')
  end subroutine batches

  ! Lengths and multipliers from far below the least allowed to the largest.
  subroutine scales()
    real(dp), parameter :: scale(6) = [1e-300_dp, 1e-160_dp, 1e-30_dp, 1e-12_dp, 1e12_dp, 1e29_dp]
    character(len=27), parameter :: name(5) = [character(len=27) :: element, 'PointQuad4CoulombMultiplier', &
      'InterpolatedQuad4Multiplier', 'PointQuad4Augmented', frictional]
    logical :: pass
    integer :: e, i, j
    do e = 1, 5
      pass = .true.
      do j = 1, 6
        do i = 1, 6
          call bench_open(b, trim(name(e)))
          b%x = b%x*scale(i)
          if (e <= 3) b%u(lambda) = -scale(j)
          if (e > 3) b%history_accepted(b%info%history) = -scale(j)
          pass = clean() .and. pass
          b%x(3) = 2*b%x(3) ! far over the facet
          pass = clean() .and. pass
        end do
      end do
      call client_check(pass, trim(name(e)))
    end do
  end subroutine scales

  ! From every kind of history to every other: with slip, with slip and multiplier, with multiplier, without both.
  subroutine transfers()
    character(len=27), parameter :: name(6) = [character(len=27) :: 'PointQuad4Coulomb', &
      'PointQuad4CoulombMultiplier', frictional, 'PointQuad4Augmented', 'PointQuad4', element]
    integer, parameter :: kind(6) = [0, 0, 1, 2, 3, 3]
    real(dp) :: before(history_size)
    integer(i4) :: found, named
    integer :: from, to
    do from = 1, 6
      do to = 1, 6
        if (kind(from) == kind(to) .and. kind(from) < 3) cycle
        call accepted(b, trim(name(from)))
        call accepted(next, trim(name(to)))
        before = next%out%history_trial(:history_size)
        named = untouched
        found = cte_history_transfer(b%element, b%out%output, b%out%history_trial, next%element, next%out%output, &
          next%out%history_trial, named)
        call client_check(found == CTE_ERROR_ELEMENT .and. named == merge(CTE_ARGUMENT_TO, CTE_ARGUMENT_FROM, &
          kind(from) < 3) .and. client_same(before, next%out%history_trial(:history_size)), &
          client_text('transfer to another kind of history', 10_i8*(from - 1) + to - 1))
      end do
    end do
  end subroutine transfers

  subroutine bad_multipliers_run()
    character(len=26), parameter :: name(2) = [character(len=26) :: 'PointQuad4Augmented', frictional]
    integer :: i
    call augment_null()
    call augment_elements()
    do i = 1, 2
      call accepted(b, trim(name(i)))
      call augment_values(b%out%history_trial, CTE_ARGUMENT_HISTORY_TRIAL, 0_i8)
      call accepted(b, trim(name(i)))
      call augment_values(b%history_accepted, CTE_ARGUMENT_HISTORY_ACCEPTED, 1_i8)
    end do
    call augment_points()
    call histories(trim(name(1)))
    call histories(trim(name(2)))
    call unknowns()
    call unknowns_of_points()
    call layouts()
    call batches()
    call scales()
    call transfers()
  end subroutine bad_multipliers_run

end module bad_multipliers
