! integers.f90 - one call with explicit kinds of integers: the same where default integers have 8 bytes.
program integers
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_loc, c_ptr
  use contact_elements
  implicit none
  integer, parameter :: i4 = c_int32_t, dp = c_double
  type(c_ptr) :: element
  type(cte_arguments) :: a
  integer(i4) :: index, code
  real(dp), target :: x(3, 5), parameters(3), f(3, 5)
  logical :: pass
  x = reshape([real(dp) :: 0, 0, -0.05_dp, -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0], [3, 5])
  parameters = [1000.0_dp, 0.0_dp, 1.0_dp] ! eps_n, r0, orientation
  pass = cte_element_find('PointQuad4', 10_i4, index) == CTE_SUCCESS
  element = cte_element_get(index)
  a%request = CTE_RESIDUAL
  a%x = c_loc(x)
  a%parameters = c_loc(parameters)
  a%parameter_count = 3
  a%f = c_loc(f)
  code = cte_element_evaluate(element, a)
  pass = pass .and. code == CTE_SUCCESS .and. a%status == CTE_STATUS_CLOSED .and. abs(f(3, 1) + 50) < 1e-12_dp
  print '(2a,3(1x,f0.1))', merge('PASS', 'FAIL', pass), ' integers: force on the slave', f(:, 1)
  if (.not. pass) stop 1
end program integers
