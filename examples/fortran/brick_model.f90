! brick_model.f90 - the finite-element program around the contact elements of bricks.f90.
!
! Two 8-node bricks, small strain, linear elastic, 2x2x2 Gauss points, dense storage. Nothing in here
! knows about contact. Units: any consistent set. Nodes and unknowns are counted from 1; unknown
! 3*(node - 1) + component. brick_model.c is the twin.
! Formulas: any text on finite elements, e.g. Hughes, The Finite Element Method, sections 3.3 (trilinear
! brick), 3.8 (Gauss rule), 3.10 (B matrix).
module brick_model
  use, intrinsic :: iso_c_binding, only: dp => c_double
  implicit none
  private
  public :: brick_nodes, model_nodes, model_unknowns
  public :: brick_model_coordinates, brick_model_stiffness, brick_model_prescribed
  public :: brick_model_residual, brick_model_correct

  integer, parameter :: brick_nodes = 8 ! bottom four counter-clockwise seen from above, then the top four
  integer, parameter :: brick_unknowns = 3*brick_nodes
  integer, parameter :: model_nodes = 2*brick_nodes ! lower brick, then upper brick
  integer, parameter :: model_unknowns = 3*model_nodes

  ! Corners of the parent cube [-1,1]^3 in node order.
  real(dp), parameter :: corner(3, brick_nodes) = reshape([real(dp) :: &
    -1, -1, -1, 1, -1, -1, 1, 1, -1, -1, 1, -1, -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1], [3, brick_nodes])

contains

  ! Reference coordinates [length]: lower brick [0,1]^3, upper brick [0.25,0.75]^2 x [1,1.5].
  subroutine brick_model_coordinates(x)
    real(dp), intent(out) :: x(3, model_nodes)
    real(dp), parameter :: low(3, 2) = reshape([real(dp) :: 0.0, 0.0, 0.0, 0.25, 0.25, 1.0], [3, 2])
    real(dp), parameter :: edge(2) = [1.0_dp, 0.5_dp]
    integer :: brick, a
    do brick = 1, 2
      do a = 1, brick_nodes
        x(:, (brick - 1)*brick_nodes + a) = low(:, brick) + edge(brick)*(1 + corner(:, a))/2
      end do
    end do
  end subroutine brick_model_coordinates

  ! True where the displacement is prescribed: the bottom face (z = 0) and the top face (z = 1.5).
  subroutine brick_model_prescribed(prescribed)
    logical, intent(out) :: prescribed(model_unknowns)
    prescribed = .false.
    prescribed(:12) = .true.
    prescribed(model_unknowns - 11:) = .true.
  end subroutine brick_model_prescribed

  ! Inverse and determinant of a 3x3 matrix.
  subroutine invert(m, inverse, determinant)
    real(dp), intent(in) :: m(3, 3)
    real(dp), intent(out) :: inverse(3, 3), determinant
    integer :: i, j, i1, i2, j1, j2
    do i = 1, 3
      do j = 1, 3
        i1 = mod(i, 3) + 1
        i2 = mod(i1, 3) + 1
        j1 = mod(j, 3) + 1
        j2 = mod(j1, 3) + 1
        inverse(j, i) = m(i1, j1)*m(i2, j2) - m(i1, j2)*m(i2, j1)
      end do
    end do
    determinant = dot_product(m(1, :), inverse(:, 1))
    inverse = inverse/determinant
  end subroutine invert

  ! dN_a/dx_i [1/length] at the parent point p, and the Jacobian determinant [length^3].
  subroutine shape_gradient(x, p, gradient, determinant)
    real(dp), intent(in) :: x(3, brick_nodes), p(3)
    real(dp), intent(out) :: gradient(3, brick_nodes), determinant
    real(dp) :: parent(3, brick_nodes), jacobian(3, 3), inverse(3, 3)
    integer :: a, i, j, k
    do a = 1, brick_nodes
      do i = 1, 3
        j = mod(i, 3) + 1
        k = mod(j, 3) + 1
        parent(i, a) = corner(i, a)*(1 + corner(j, a)*p(j))*(1 + corner(k, a)*p(k))/8
      end do
    end do
    jacobian = matmul(parent, transpose(x)) ! (i, j) = dx_j/dp_i
    call invert(jacobian, inverse, determinant)
    gradient = matmul(inverse, parent)
  end subroutine shape_gradient

  ! One Gauss point of an isotropic brick:
  ! k_(ai)(bj) += (lambda g_ai g_bj + mu g_aj g_bi + mu delta_ij g_a.g_b) dV,  g = shape gradient.
  subroutine add_point(g, lambda, mu, volume, first, k)
    real(dp), intent(in) :: g(3, brick_nodes), lambda, mu, volume
    integer, intent(in) :: first ! unknowns before this brick's
    real(dp), intent(inout) :: k(model_unknowns, model_unknowns)
    real(dp) :: term
    integer :: a, b, i, j, row, col
    do b = 1, brick_nodes
      do a = 1, brick_nodes
        do j = 1, 3
          do i = 1, 3
            term = lambda*g(i, a)*g(j, b) + mu*g(j, a)*g(i, b)
            if (i == j) term = term + mu*dot_product(g(:, a), g(:, b))
            row = first + 3*(a - 1) + i
            col = first + 3*(b - 1) + j
            k(row, col) = k(row, col) + volume*term
          end do
        end do
      end do
    end do
  end subroutine add_point

  ! Stiffness [force/length] of both bricks. young [force/length^2], poisson [1].
  subroutine brick_model_stiffness(x, young, poisson, k)
    real(dp), intent(in) :: x(3, model_nodes), young, poisson
    real(dp), intent(out) :: k(model_unknowns, model_unknowns)
    real(dp) :: g(3, brick_nodes), lambda, mu, volume
    integer :: brick, q, first
    mu = young/(2*(1 + poisson))
    lambda = young*poisson/((1 + poisson)*(1 - 2*poisson))
    k = 0
    do brick = 1, 2
      first = (brick - 1)*brick_nodes
      do q = 1, 8 ! 2-point rule in each direction, weights 1
        call shape_gradient(x(:, first + 1:first + brick_nodes), corner(:, q)/sqrt(3.0_dp), g, volume)
        call add_point(g, lambda, mu, volume, 3*first, k)
      end do
    end do
  end subroutine brick_model_stiffness

  ! Solves a x = b by Gauss elimination with partial pivoting; a is destroyed, b becomes x. singular: a
  ! pivot is zero.
  subroutine solve(a, b, singular)
    real(dp), intent(inout) :: a(model_unknowns, model_unknowns), b(model_unknowns)
    logical, intent(out) :: singular
    real(dp) :: keep(model_unknowns), kept, factor
    integer :: column, row, best
    singular = .false.
    do column = 1, model_unknowns
      best = column - 1 + maxloc(abs(a(column:, column)), 1)
      keep = a(best, :)
      a(best, :) = a(column, :)
      a(column, :) = keep
      kept = b(best)
      b(best) = b(column)
      b(column) = kept
      singular = .not. abs(a(column, column)) > 0
      if (singular) return
      do row = column + 1, model_unknowns
        factor = a(row, column)/a(column, column)
        a(row, column:) = a(row, column:) - factor*a(column, column:)
        b(row) = b(row) - factor*b(column)
      end do
    end do
    do row = model_unknowns, 1, -1
      b(row) = (b(row) - dot_product(a(row, row + 1:), b(row + 1:)))/a(row, row)
    end do
  end subroutine solve

  ! Norm of the residual f [force] over the unknowns that are not prescribed.
  pure function brick_model_residual(prescribed, f) result(norm)
    logical, intent(in) :: prescribed(model_unknowns)
    real(dp), intent(in) :: f(model_unknowns)
    real(dp) :: norm
    norm = norm2(pack(f, .not. prescribed))
  end function brick_model_residual

  ! One step of Newton's method, u = u - k^-1 f; prescribed displacements stay. k is destroyed. pass: k is regular.
  subroutine brick_model_correct(prescribed, k, f, u, pass)
    logical, intent(in) :: prescribed(model_unknowns)
    real(dp), intent(inout) :: k(model_unknowns, model_unknowns), u(3, model_nodes)
    real(dp), intent(in) :: f(model_unknowns)
    logical, intent(out) :: pass
    logical :: singular
    real(dp) :: b(model_unknowns)
    integer :: i
    b = -f
    do i = 1, model_unknowns
      if (.not. prescribed(i)) cycle
      b(i) = 0
      k(i, :) = 0
      k(i, i) = 1
    end do
    call solve(k, b, singular)
    pass = .not. singular
    if (pass) u = u + reshape(b, [3, model_nodes])
  end subroutine brick_model_correct

end module brick_model
