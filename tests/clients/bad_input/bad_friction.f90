! bad_friction.f90 - bad input to frictional elements and to cte_history_transfer; see bad_input.f90.
module bad_friction
  use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
  use, intrinsic :: iso_c_binding, only: c_f_procpointer, c_loc, c_null_ptr, c_ptr
  use contact_elements
  use client_support
  implicit none
  private
  public :: bad_friction_run

  integer, parameter :: history_size = 6, anchor_at = 4, path_at = 6 ! entries from 1
  integer(i4), parameter :: untouched = -77
  character(len=*), parameter :: facet = 'PointQuad4Coulomb'
  type(bench), save, target :: b, next

  ! The function with every address by value.
  abstract interface
    function transfer_call(from, from_output, from_history, to, to_output, to_history, argument) bind(c) &
        result(code)
      import :: i4, c_ptr
      type(c_ptr), value :: from, from_output, from_history, to, to_output, to_history, argument
      integer(i4) :: code
    end function transfer_call
  end interface

contains

  ! The caller's fault, nothing written; entry from 0.
  subroutine expect(what, code, argument, entry)
    character(len=*), intent(in) :: what
    integer(i4), intent(in) :: code, argument
    integer, intent(in) :: entry
    integer(i4) :: found
    logical :: pass
    call bench_canary(b)
    found = bench_evaluate(b)
    pass = found == code .and. b%a%error_argument == argument .and. b%a%error_index == entry .and. bench_untouched(b) &
      .and. client_contains(client_message(b, found), cte_string(cte_argument_name(argument)))
    call client_check(pass, what)
    if (.not. pass) print '(5(a,i0))', '     code ', found, ' wanted ', code, ', argument ', b%a%error_argument, &
      ', index ', b%a%error_index, ' wanted ', entry
  end subroutine expect

  ! Cut back as degenerate, nothing written.
  subroutine expect_degenerate(what)
    character(len=*), intent(in) :: what
    integer(i4) :: found
    call bench_canary(b)
    found = bench_evaluate(b)
    call client_check(found == CTE_CUT_BACK .and. b%a%status == CTE_STATUS_DEGENERATE .and. b%a%dt_ratio == 0.5_dp &
      .and. b%a%closed_points == 0 .and. bench_untouched(b), what)
  end subroutine expect_degenerate

  ! A result with finite numbers, or a code and untouched arrays; no trap.
  function clean() result(pass)
    logical :: pass
    integer :: n
    call bench_canary(b)
    n = b%info%unknowns
    if (bench_evaluate(b) == CTE_SUCCESS) then
      pass = all(ieee_is_finite(b%out%f(:n))) .and. all(ieee_is_finite(b%out%k(:n*n))) &
        .and. all(ieee_is_finite(b%out%history_trial(:b%info%history))) .and. ieee_is_finite(b%out%energy(1)) &
        .and. all(ieee_is_finite(b%out%output(:b%info%points*CTE_OUTPUT_SIZE)))
    else
      pass = bench_untouched(b)
    end if
  end function clean

  ! Clean with this status.
  function clean_as(status) result(pass)
    integer(i4), intent(in) :: status
    logical :: pass
    pass = clean()
    pass = pass .and. b%a%status == status
  end function clean_as

  ! A bench whose accepted point sticks.
  function accepted(any_bench, name) result(pass)
    type(bench), intent(inout), target :: any_bench
    character(len=*), intent(in) :: name
    logical :: pass
    call bench_open(any_bench, name)
    pass = bench_evaluate(any_bench) == CTE_SUCCESS
    any_bench%history_accepted(:any_bench%info%history) = any_bench%out%history_trial(:any_bench%info%history)
  end function accepted

  subroutine parameters()
    character(len=5), parameter :: name(6) = [character(len=5) :: 'eps_t', 'mu', 'eps_1', 'eps_2', 'mu_1', 'mu_2']
    integer :: i, entry
    integer(i4) :: found
    do i = 1, 6
      if (i <= 2) call bench_open(b, facet)
      if (i > 2) call bench_open(b, 'PointQuad4Orthotropic')
      entry = bench_parameter(b, trim(name(i)))
      b%parameters(entry + 1) = -0.5_dp
      call expect(client_text('friction, negative parameter', i - 1_i8), CTE_ERROR_PARAMETER, &
        CTE_ARGUMENT_PARAMETERS, entry)
      call client_special(mod(i - 1, client_specials) + 1, b%parameters(entry + 1))
      call expect(client_text('friction, no number as parameter', i - 1_i8), CTE_ERROR_NOT_FINITE, &
        CTE_ARGUMENT_PARAMETERS, entry)
    end do
    call bench_open(b, 'PointQuad4Orthotropic')
    b%parameters(bench_parameter(b, 'eps_1') + 1) = 1e20_dp
    b%parameters(bench_parameter(b, 'eps_2') + 1) = 1e-300_dp
    call bench_canary(b)
    found = bench_evaluate(b)
    call client_check(found == CTE_CUT_BACK .and. b%a%status == CTE_STATUS_LAW .and. bench_untouched(b), &
      'friction, stiffnesses whose quotient is NaN')
    call bench_open(b, 'PointQuad4Orthotropic')
    b%parameters(bench_parameter(b, 'eps_n') + 1) = 1e-190_dp
    b%history_accepted(1) = CTE_STATUS_STICK
    b%history_accepted(4) = b%history_accepted(2) + 0.25_dp
    found = bench_evaluate(b)
    call client_check(found == CTE_SUCCESS .and. b%a%status == CTE_STATUS_SLIP, 'friction, next to no pressure')
  end subroutine parameters

  subroutine not_finite()
    real(dp) :: kept
    integer :: entry, special
    if (.not. accepted(b, facet)) call client_check(.false., 'an accepted contact with friction')
    do entry = 0, history_size - 1
      kept = b%history_accepted(entry + 1)
      do special = 1, client_specials
        call client_special(special, b%history_accepted(entry + 1))
        call expect(client_text('friction, no number in the history, entry', int(entry, i8)), CTE_ERROR_NOT_FINITE, &
          CTE_ARGUMENT_HISTORY_ACCEPTED, entry)
      end do
      b%history_accepted(entry + 1) = kept
    end do
  end subroutine not_finite

  subroutine histories()
    real(dp), parameter :: no_status(4) = [-1.0_dp, 9.0_dp, 2.5_dp, 1e30_dp]
    real(dp) :: kept
    integer :: i
    kept = b%history_accepted(1)
    do i = 1, 4
      b%history_accepted(1) = no_status(i)
      call expect(client_text('history: no status', i - 1_i8), CTE_ERROR_HISTORY, CTE_ARGUMENT_HISTORY_ACCEPTED, 0)
    end do
    b%history_accepted(1) = kept
    b%history_accepted(path_at) = -1e-300_dp
    call expect('history: negative slip path', CTE_ERROR_HISTORY, CTE_ARGUMENT_HISTORY_ACCEPTED, path_at - 1)
    b%history_accepted(path_at) = 0
    do i = 0, 1
      kept = b%history_accepted(anchor_at + i)
      b%history_accepted(anchor_at + i) = merge(1e5_dp, -1e5_dp, i == 0)
      call expect(client_text('history: an anchor far outside', int(i, i8)), CTE_ERROR_HISTORY, &
        CTE_ARGUMENT_HISTORY_ACCEPTED, anchor_at - 1 + i)
      b%history_accepted(anchor_at + i) = 1000 ! 500 facets away
      call client_check(clean_as(CTE_STATUS_SLIP), client_text('history: an anchor outside', int(i, i8)))
      b%history_accepted(anchor_at + i) = kept
    end do
    if (accepted(b, 'PointQuad4')) b%history_accepted(1) = 9
    call client_check(clean(), 'without friction any number is a status: it is open')
    b%history_accepted(2) = -1e30_dp
    call expect('history: a projection far outside', CTE_ERROR_HISTORY, CTE_ARGUMENT_HISTORY_ACCEPTED, 1)
  end subroutine histories

  ! Two contacts, the second with a bad history: it fails alone.
  subroutine in_a_batch()
    real(dp), save, target :: x(15, 2), f(15, 2), history(history_size, 2)
    integer(i4), save, target :: status(2), code(2)
    type(cte_batch) :: batch
    integer(i4) :: found
    if (.not. accepted(b, facet)) return
    f = canary()
    x = spread(b%x(:15), 2, 2)
    history = spread(b%history_accepted(:history_size), 2, 2)
    history(path_at, 2) = -1
    batch%request = CTE_RESIDUAL
    batch%parameter_count = b%info%parameters
    batch%x = c_loc(x)
    batch%parameters = c_loc(b%parameters)
    batch%history_accepted = c_loc(history)
    batch%f = c_loc(f)
    batch%status = c_loc(status)
    batch%code = c_loc(code)
    found = cte_element_evaluate_batch(b%element, 2_i8, batch)
    call client_check(found == CTE_CUT_BACK .and. batch%failed == 1 &
      .and. batch%error_argument == CTE_ARGUMENT_HISTORY_ACCEPTED .and. batch%error_index == 1 &
      .and. code(1) == CTE_SUCCESS .and. code(2) == CTE_ERROR_HISTORY .and. client_same(f(:1, 2), [canary()]), &
      'batch: a bad history fails alone')
  end subroutine in_a_batch

  ! An orthotropic law without an axis, and a rope that stands on the surface.
  subroutine axes()
    integer, parameter :: place(2, 9) = reshape([-1, -1, 1, -1, 1, 1, -1, 1, 0, -1, 1, 0, 0, 1, -1, 0, 0, 0], [2, 9])
    integer(i4) :: e
    integer :: a
    logical :: pass
    call bench_open(b, 'PointQuad4Orthotropic')
    call client_check(clean_as(CTE_STATUS_STICK), 'an axis along the first parameter')
    call bench_set(b, 'axis_1', 0.0_dp)
    call expect_degenerate('axis_1 = axis_2 = 0')
    call bench_set(b, 'axis_2', 1e-300_dp)
    call client_check(clean(), 'an axis of length 1e-300')
    pass = cte_element_find('Line2CylinderOrthotropic', 24, e) == CTE_SUCCESS
    if (pass) pass = bench_index(b, e, 0_i4)
    call bench_set(b, 'radius', 1.0_dp)
    b%x(:6) = [0.9_dp, 0.0_dp, 0.0_dp, 0.5_dp, 0.0_dp, 0.0_dp]
    call expect_degenerate('a rope along the normal of a cylinder')
    pass = cte_element_find('Line2Quad9OrthotropicAtPoint', 28, e) == CTE_SUCCESS
    if (pass) pass = bench_index(b, e, 0_i4)
    b%x(3) = -0.3_dp ! the line from (0, 0, -0.3) to (0, 0, -0.1)
    b%x(6) = -0.1_dp
    do a = 1, 9
      b%x(4 + 3*a:5 + 3*a) = place(:, a)
    end do
    call expect_degenerate('a rope along the normal of a facet')
    b%x(4) = 0.2_dp
    call client_check(clean_as(CTE_STATUS_STICK), 'a rope that leans')
  end subroutine axes

  ! Lengths from far below the least allowed to the largest, with a history that is remembered.
  subroutine scales()
    real(dp), parameter :: scale(6) = [1e-300_dp, 1e-160_dp, 1e-30_dp, 1e-12_dp, 1e12_dp, 1e29_dp]
    character(len=24), parameter :: name(4) = [character(len=24) :: facet, 'PointQuad4Orthotropic', &
      'InterpolatedQuad4Coulomb', 'PointCylinderCoulomb']
    logical :: pass
    integer :: e, i
    do e = 1, 4
      pass = .true.
      do i = 1, 6
        pass = accepted(b, trim(name(e))) .and. pass
        b%x = b%x*scale(i)
        b%history_accepted(anchor_at) = b%history_accepted(anchor_at) + 0.3_dp
        pass = clean() .and. pass
      end do
      call client_check(pass, trim(name(e)))
    end do
  end subroutine scales

  ! A call of cte_history_transfer that must not write.
  function refused(code, argument) result(pass)
    integer(i4), intent(in) :: code, argument
    logical :: pass
    real(dp) :: before(history_size)
    integer(i4) :: found, named
    before = next%out%history_trial(:history_size)
    named = untouched
    found = cte_history_transfer(b%element, b%out%output, b%out%history_trial, next%element, next%out%output, &
      next%out%history_trial, named)
    pass = found == code .and. named == argument .and. client_same(before, next%out%history_trial(:history_size))
    if (.not. pass) print '(4(a,i0))', '     code ', found, ' wanted ', code, ', argument ', named, ' wanted ', argument
  end function refused

  ! From a sliding point to the same point of the same facet.
  subroutine sound(from, to)
    character(len=*), intent(in) :: from, to
    logical :: pass
    pass = accepted(b, from)
    b%u(1) = 0.05_dp
    pass = bench_evaluate(b) == CTE_SUCCESS .and. pass
    call bench_open(next, to)
    next%u(1) = 0.05_dp
    pass = bench_evaluate(next) == CTE_SUCCESS .and. pass
    if (.not. pass) call client_check(.false., 'a sound transfer')
  end subroutine sound

  subroutine transfer_null()
    integer(i4), target :: named(6)
    type(cte_api_table) :: api
    procedure(transfer_call), pointer :: carry
    type(c_ptr) :: p(6), q(6)
    real(dp) :: kept
    logical :: pass
    integer :: i
    pass = cte_api(CTE_VERSION_MAJOR, api) == CTE_SUCCESS
    call c_f_procpointer(api%history_transfer, carry)
    call sound(facet, facet)
    kept = next%out%history_trial(anchor_at)
    p = [b%element, c_loc(b%out%output), c_loc(b%out%history_trial), next%element, c_loc(b%out%output), &
      c_loc(next%out%history_trial)]
    do i = 1, 6
      q = p
      q(i) = c_null_ptr
      pass = carry(q(1), q(2), q(3), q(4), q(5), q(6), c_loc(named(i))) == CTE_ERROR_NULL .and. pass
      pass = pass .and. named(i) == CTE_ARGUMENT_FROM + i - 1
    end do
    call client_check(pass .and. client_same([kept], next%out%history_trial(anchor_at:anchor_at)), &
      'transfer: each pointer null')
    pass = carry(c_null_ptr, p(2), p(3), c_null_ptr, p(5), p(6), c_null_ptr) == CTE_ERROR_NULL
    call client_check(pass, 'transfer: argument null')
  end subroutine transfer_null

  subroutine transfer_not_finite()
    integer(i4), parameter :: name(4) = [CTE_ARGUMENT_FROM_OUTPUT, CTE_ARGUMENT_FROM_HISTORY, &
      CTE_ARGUMENT_TO_OUTPUT, CTE_ARGUMENT_TO_HISTORY]
    integer :: i, entry, special
    logical :: pass
    do i = 1, 4
      pass = .true.
      do entry = 1, merge(int(CTE_OUTPUT_SIZE), history_size, mod(i, 2) == 1)
        call sound(facet, facet)
        special = mod(entry - 1, client_specials) + 1
        if (i == 1) call client_special(special, b%out%output(entry))
        if (i == 2) call client_special(special, b%out%history_trial(entry))
        if (i == 3) call client_special(special, next%out%output(entry))
        if (i == 4) call client_special(special, next%out%history_trial(entry))
        pass = refused(CTE_ERROR_NOT_FINITE, name(i)) .and. pass
      end do
      call client_check(pass, client_text('transfer: no number in array', i - 1_i8))
    end do
  end subroutine transfer_not_finite

  subroutine transfer_histories()
    integer :: at
    call sound(facet, facet)
    b%out%history_trial(1) = 2.5_dp
    call client_check(refused(CTE_ERROR_HISTORY, CTE_ARGUMENT_FROM_HISTORY), 'transfer: no status')
    call sound(facet, facet)
    b%out%history_trial(path_at) = -1
    call client_check(refused(CTE_ERROR_HISTORY, CTE_ARGUMENT_FROM_HISTORY), 'transfer: negative slip path')
    call sound(facet, facet)
    at = CTE_OUTPUT_PROJECTION + 1
    b%out%output(at) = b%out%output(at) + 0.01_dp
    call client_check(refused(CTE_ERROR_HISTORY, CTE_ARGUMENT_FROM_HISTORY), 'transfer: output of another state')
    call sound(facet, facet)
    next%out%history_trial(3) = next%out%history_trial(3) - 0.01_dp
    call client_check(refused(CTE_ERROR_HISTORY, CTE_ARGUMENT_TO_HISTORY), 'transfer: new history of another state')
  end subroutine transfer_histories

  subroutine transfer_elements()
    integer(i4) :: e, code, named
    logical :: pass
    call sound('PointQuad4', facet)
    call client_check(refused(CTE_ERROR_ELEMENT, CTE_ARGUMENT_FROM), 'transfer: from an element without friction')
    call sound(facet, 'PointQuad4')
    call client_check(refused(CTE_ERROR_ELEMENT, CTE_ARGUMENT_TO), 'transfer: to an element without friction')
    pass = cte_element_find('PointLine2Coulomb2d', 19, e) == CTE_SUCCESS
    call sound(facet, facet)
    if (pass) pass = bench_index(next, e, 0_i4)
    call client_check(refused(CTE_ERROR_ELEMENT, CTE_ARGUMENT_TO) .and. pass, 'transfer: from 3D to 2D')
    code = untouched
    named = untouched
    e = cte_element_count()
    call cte_f77_history_transfer(e, b%out%output, b%out%history_trial, e, next%out%output, next%out%history_trial, named, code)
    call client_check(code == CTE_ERROR_INDEX .and. named == CTE_ARGUMENT_FROM, 'F77 transfer, element out of range')
  end subroutine transfer_elements

  ! Outputs that no facet has.
  subroutine transfer_planes()
    integer, parameter :: normal = CTE_OUTPUT_NORMAL + 1, tangents = CTE_OUTPUT_TANGENTS + 1
    call sound(facet, facet)
    b%out%output(tangents:tangents + 2) = 0
    call client_check(refused(CTE_CUT_BACK, CTE_ARGUMENT_FROM_OUTPUT), 'transfer: a tangent of length zero')
    call sound(facet, facet)
    next%out%output(tangents + 3:tangents + 5) = next%out%output(tangents:tangents + 2)
    call client_check(refused(CTE_CUT_BACK, CTE_ARGUMENT_TO_OUTPUT), 'transfer: parallel tangents')
    call sound(facet, facet)
    next%out%output(normal:normal + 2) = 2*next%out%output(normal:normal + 2)
    call client_check(refused(CTE_CUT_BACK, CTE_ARGUMENT_TO_OUTPUT), 'transfer: no unit normal')
    call sound(facet, facet)
    next%out%output(normal:normal + 2) = -b%out%output(normal:normal + 2)
    call client_check(refused(CTE_CUT_BACK, CTE_ARGUMENT_TO_OUTPUT), 'transfer: opposite normals')
    call sound(facet, facet)
    next%out%output(tangents:tangents + 5) = 1e-29_dp*next%out%output(tangents:tangents + 5)
    b%out%output(tangents:tangents + 5) = [real(dp) :: 0, 1e29_dp, 0, 1e29_dp, 0, 0]
    b%out%history_trial(anchor_at) = -900
    call client_check(refused(CTE_CUT_BACK, CTE_ARGUMENT_TO_OUTPUT), 'transfer: an anchor beyond 1e30')
    b%out%history_trial(anchor_at) = -1e29_dp
    call client_check(refused(CTE_ERROR_HISTORY, CTE_ARGUMENT_FROM_HISTORY), 'transfer: from an anchor far outside')
  end subroutine transfer_planes

  subroutine bad_friction_run()
    call parameters()
    call not_finite()
    call histories()
    call in_a_batch()
    call axes()
    call scales()
    call transfer_null()
    call transfer_not_finite()
    call transfer_histories()
    call transfer_elements()
    call transfer_planes()
  end subroutine bad_friction_run

end module bad_friction
