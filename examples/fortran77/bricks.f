C     bricks.f - bricks.c in Fortran 77, through CTE_F77_* alone.
C
C     An upper brick is pushed onto a lower one; four contact elements
C     PointQuad4 join the upper brick's lower nodes (slaves) to the
C     lower brick's top face (master). Newton with the element's
C     tangent. The host has four rows per node, as one with temperatures
C     would: the element writes -f and K into the rows of a map, and
C     reads displacements of leading dimension 4. bricks.c and bricks.f90
C     are the twins.
C
C     Reference: the same problem in six independent finite-element
C     programs. Units: any consistent set. Parameters of PointQuad4 in
C     order: eps_n, r0, orientation; the rest stays zero, the default.
      PROGRAM BRIC77
      INTEGER NSTEP, NIT
      PARAMETER (NSTEP = 5, NIT = 20)
      DOUBLE PRECISION X(3,16), U(48), KE(48,48), HOLD(16,4), HNEW(16,4)
      DOUBLE PRECISION RES(NIT), F(48)
      INTEGER I, ISTEP, N
      LOGICAL OK, START, QUADR, COMPAR
      IF (.NOT. START(X, U, KE, HOLD)) STOP 1
      OK = .TRUE.
C     The push of the top face in equal steps, -0.05 [length] in all,
C     compared with the reference, then a slide that warps the facet.
C     Each step begins with the upper brick moved along rigidly.
      DO 30 ISTEP = 1, NSTEP + 1
        DO 10 I = 25, 48, 3
          IF (ISTEP .LE. NSTEP) THEN
            U(I+2) = U(I+2) - 0.05D0/NSTEP
          ELSE
            U(I) = U(I) + 0.2D0
            U(I+1) = U(I+1) + 0.1D0
          END IF
   10   CONTINUE
        CALL NEWTON(X, U, KE, HOLD, HNEW, ISTEP, NIT, RES, N, F)
        CALL COPY(64, HNEW, HOLD)
        IF (.NOT. QUADR(NIT, RES, N)) OK = .FALSE.
        IF (ISTEP .EQ. NSTEP) THEN
          IF (.NOT. COMPAR(U, F)) OK = .FALSE.
        END IF
   30 CONTINUE
      IF (.NOT. OK) THEN
        WRITE (*, '(A)') 'FAIL bricks'
        STOP 1
      END IF
      WRITE (*, '(A)') 'PASS bricks'
      END

C     Coordinates, elastic stiffness and the first history.
      LOGICAL FUNCTION START(X, U, KE, HOLD)
      DOUBLE PRECISION X(3,16), U(48), KE(48,48), HOLD(16,4)
      INTEGER C, I, CODE
      INCLUDE 'contact_elements.inc'
      INTEGER ISIZES(0:CTE_F77_SIZES-1)
      START = .FALSE.
      CALL CTE_F77_INFO(CTE_POINT_QUAD4, 0, ISIZES, CODE)
      IF (CODE .NE. CTE_SUCCESS .OR. ISIZES(CTE_F77_SIZE_UNKNOWNS)
     1    .NE. 15 .OR. ISIZES(CTE_F77_SIZE_PARAMETERS) .NE. 3
     2    .OR. ISIZES(CTE_F77_SIZE_HISTORY) .GT. 16
     3    .OR. ISIZES(CTE_F77_SIZE_POINTS) .NE. 1
     4    .OR. ISIZES(CTE_F77_SIZE_SYMMETRIC) .NE. 1
     5    .OR. ISIZES(CTE_F77_SIZE_WORKSPACE) .NE. 0) THEN
        WRITE (*, '(A,13I6)') 'FAIL sizes of PointQuad4', ISIZES
        RETURN
      END IF
      DO 10 C = 1, 4
        DO 5 I = 1, 16
          HOLD(I,C) = 0.0D0
    5   CONTINUE
        CALL CTE_F77_HISTORY_INIT(CTE_POINT_QUAD4, HOLD(1,C), CODE)
        IF (CODE .NE. 0) RETURN
   10 CONTINUE
      DO 20 I = 1, 48
        U(I) = 0.0D0
   20 CONTINUE
      CALL COORDS(X)
      CALL STIFF(X, KE)
      START = .TRUE.
      END

C     One contact element. CON: its nodes, slave first, then the facet
C     counter-clockwise seen from above. P: -f [force], S: K
C     [force/length], both in rows of four per node.
      SUBROUTINE CONTAC(X, U, CON, HOLD, HNEW, P, S, CODE)
      INTEGER CON(5), CODE
      DOUBLE PRECISION X(3,16), U(3,16), HOLD(16), HNEW(16), P(20)
      DOUBLE PRECISION S(20,20), XL(3,5), UL(4,5), PAR(3), ENERGY, WORK
      INTEGER A, I, MAP(15), IREQ
      INCLUDE 'contact_elements.inc'
      INTEGER ISTATE(0:CTE_F77_STATES-1)
      DOUBLE PRECISION OUT(0:CTE_OUTPUT_SIZE-1)
      PARAMETER (IREQ = CTE_RESIDUAL + CTE_TANGENT + CTE_HISTORY)
C     eps_n, r0, orientation
      DATA PAR /1.0D4, 0.0D0, 1.0D0/
      DO 30 A = 1, 5
        UL(4,A) = 0.0D0
        DO 20 I = 1, 3
          XL(I,A) = X(I,CON(A))
          UL(I,A) = U(I,CON(A))
          MAP(3*A-3+I) = 4*A - 5 + I
   20   CONTINUE
   30 CONTINUE
      CALL CTE_F77_EVALUATE(CTE_POINT_QUAD4, IREQ, 5, 0, XL, 3, UL, 4,
     1    PAR, 3, HOLD, HNEW, WORK, 1, MAP, -1.0D0, 1.0D0, P, S, 20,
     2    OUT, ENERGY, WORK, 0, ISTATE, CODE)
      IF (CODE .NE. CTE_SUCCESS) CALL REASON(ISTATE, CODE)
      END

C     Says why a contact element failed.
      SUBROUTINE REASON(ISTATE, CODE)
      INTEGER CODE, LENGTH, I
      INCLUDE 'contact_elements.inc'
      INTEGER ISTATE(0:CTE_F77_STATES-1), ITEXT(120)
      CALL CTE_F77_MESSAGE(CTE_POINT_QUAD4, CODE, ISTATE, ITEXT, 120,
     1    LENGTH)
      WRITE (*, '(121A)') 'FAIL ', (CHAR(ITEXT(I)), I = 1, 120)
      END

C     Internal force F and tangent K of bricks and contacts at U.
      SUBROUTINE ASSEMB(X, U, KE, HOLD, HNEW, F, K, CODE)
      DOUBLE PRECISION X(3,16), U(48), KE(48,48), HOLD(16,4), HNEW(16,4)
      DOUBLE PRECISION F(48), K(48,48)
      INTEGER CODE, C, I, J, ROW(20), CON(5)
      DOUBLE PRECISION P(20), S(20,20)
      CALL COPY(48*48, KE, K)
      DO 20 I = 1, 48
        F(I) = 0.0D0
        DO 10 J = 1, 48
          F(I) = F(I) + KE(I,J)*U(J)
   10   CONTINUE
   20 CONTINUE
      DO 60 C = 1, 4
        CON(1) = 8 + C
        DO 30 I = 2, 5
          CON(I) = 3 + I
   30   CONTINUE
        CALL CONTAC(X, U, CON, HOLD(1,C), HNEW(1,C), P, S, CODE)
        IF (CODE .NE. 0) RETURN
C       Row of the model for each row of the host's element; 0: none.
        DO 40 I = 1, 5
          DO 35 J = 1, 3
            ROW(4*I-4+J) = 3*CON(I) - 3 + J
   35     CONTINUE
          ROW(4*I) = 0
   40   CONTINUE
        DO 55 J = 1, 20
          IF (ROW(J) .EQ. 0) GO TO 55
          F(ROW(J)) = F(ROW(J)) - P(J)
          DO 50 I = 1, 20
            IF (ROW(I) .EQ. 0) GO TO 50
            K(ROW(I),ROW(J)) = K(ROW(I),ROW(J)) + S(I,J)
   50     CONTINUE
   55   CONTINUE
   60 CONTINUE
      END

C     Newton iterations; RES: norms of the residual [force], N: their
C     number, 0 on failure. The first and the last 12 unknowns are
C     prescribed: the bottom face z = 0 and the top face z = 1.5.
      SUBROUTINE NEWTON(X, U, KE, HOLD, HNEW, ISTEP, NIT, RES, N, F)
      INTEGER ISTEP, NIT, N, IT, I, J, CODE
      DOUBLE PRECISION X(3,16), U(48), KE(48,48), HOLD(16,4), HNEW(16,4)
      DOUBLE PRECISION RES(NIT), K(48,48), F(48), B(48), DONE
      PARAMETER (DONE = 5.0D-11)
      N = 0
      DO 60 IT = 1, NIT
        CALL ASSEMB(X, U, KE, HOLD, HNEW, F, K, CODE)
        IF (CODE .NE. 0) RETURN
        RES(IT) = 0.0D0
        DO 20 I = 1, 48
          B(I) = -F(I)
          IF (I .LE. 12 .OR. I .GT. 36) THEN
            B(I) = 0.0D0
            DO 10 J = 1, 48
              K(I,J) = 0.0D0
   10       CONTINUE
            K(I,I) = 1.0D0
          END IF
          RES(IT) = RES(IT) + B(I)**2
   20   CONTINUE
        RES(IT) = SQRT(RES(IT))
        WRITE (*, '(A,I2,A,I3,A,E10.3)') 'step', ISTEP, ' iteration',
     1      IT - 1, ' residual', RES(IT)
        IF (RES(IT) .LT. DONE) THEN
          N = IT
          RETURN
        END IF
        CALL SOLVE(48, K, B, CODE)
        IF (CODE .NE. 0) RETURN
        DO 30 I = 1, 48
          U(I) = U(I) + B(I)
   30   CONTINUE
   60 CONTINUE
      END

C     Quadratic: each residual is less than its predecessor's square
C     times a constant [1/force], up to rounding.
      LOGICAL FUNCTION QUADR(NIT, RES, N)
      INTEGER NIT, N, IT
      DOUBLE PRECISION RES(NIT), CONST, ROUND
      PARAMETER (CONST = 2.0D0, ROUND = 5.0D-11)
      QUADR = N .GT. 0
      DO 10 IT = 2, N
        IF (RES(IT) .GT. CONST*RES(IT-1)**2 + ROUND) QUADR = .FALSE.
   10 CONTINUE
      IF (QUADR) WRITE (*, '(A,I3)') 'PASS quadratic, iterations', N
      IF (.NOT. QUADR) WRITE (*, '(A,I3)') 'FAIL quadratic', N
      END

C     Ten digits; the reference itself is rounded to the digits given.
C     Reaction z at (0,0,0), displacement of (0,0,1), u_z of
C     (0.25,0.25,1).
      LOGICAL FUNCTION COMPAR(U, F)
      DOUBLE PRECISION U(48), F(48), V(5), REF(5)
      INTEGER I
      DATA REF /4.53720508167D0, -3.5390199637D-3, -3.5390199637D-3,
     1    -1.6515426497D-2, -1.6969147005D-2/
      V(1) = F(3)
      V(2) = U(13)
      V(3) = U(14)
      V(4) = U(15)
      V(5) = U(27)
      COMPAR = .TRUE.
      DO 10 I = 1, 5
        IF (ABS(V(I) - REF(I)) .LE. 1.0D-10*ABS(REF(I))) THEN
          WRITE (*, '(A,I2,2E20.11)') 'PASS reference', I, V(I), REF(I)
        ELSE
          WRITE (*, '(A,I2,2E20.11)') 'FAIL reference', I, V(I), REF(I)
          COMPAR = .FALSE.
        END IF
   10 CONTINUE
      END

C     Corner A of the parent cube [-1,1]**3, component I.
      DOUBLE PRECISION FUNCTION CORNER(I, A)
      INTEGER I, A, ISGN(3,8)
      DATA ISGN /-1,-1,-1, 1,-1,-1, 1,1,-1, -1,1,-1,
     1           -1,-1,1, 1,-1,1, 1,1,1, -1,1,1/
      CORNER = ISGN(I,A)
      END

C     Coordinates [length]: lower brick [0,1]**3, upper brick
C     [0.25,0.75]**2 x [1,1.5].
      SUBROUTINE COORDS(X)
      DOUBLE PRECISION X(3,16), CORNER, LOW(3)
      INTEGER A, I
      DATA LOW /0.25D0, 0.25D0, 1.0D0/
      DO 20 A = 1, 8
        DO 10 I = 1, 3
          X(I,A) = (1.0D0 + CORNER(I,A))/2.0D0
          X(I,A+8) = LOW(I) + (1.0D0 + CORNER(I,A))/4.0D0
   10   CONTINUE
   20 CONTINUE
      END

C     Gradients G(i,a) = dN_a/dx_i [1/length] of a brick whose edges are
C     parallel to the axes, of length H, at the parent point P.
      SUBROUTINE SHPGRD(H, P, G)
      DOUBLE PRECISION H, P(3), G(3,8), CORNER
      INTEGER A, I, J, L
      DO 20 A = 1, 8
        DO 10 I = 1, 3
          J = MOD(I, 3) + 1
          L = MOD(J, 3) + 1
          G(I,A) = CORNER(I,A)*(1.0D0 + CORNER(J,A)*P(J))
     1        *(1.0D0 + CORNER(L,A)*P(L))/(4.0D0*H)
   10   CONTINUE
   20 CONTINUE
      END

C     Stiffness [force/length] of both bricks, 2x2x2 Gauss points:
C     K(ai,bj) = sum of (lambda G_ai G_bj + mu G_aj G_bi
C                        + mu delta_ij G_a.G_b) dV
C     with Young's modulus 1000 [force/length**2], Poisson's ratio 0.3.
      SUBROUTINE STIFF(X, KE)
      DOUBLE PRECISION X(3,16), KE(48,48), H, P(3), G(3,8), CORNER
      DOUBLE PRECISION YOUNG, POISS, LAMBDA, MU, VOLUME
      INTEGER BRICK, Q, I
      PARAMETER (YOUNG = 1000.0D0, POISS = 0.3D0)
      MU = YOUNG/(2.0D0*(1.0D0 + POISS))
      LAMBDA = YOUNG*POISS/((1.0D0 + POISS)*(1.0D0 - 2.0D0*POISS))
      DO 10 I = 1, 48
        DO 5 Q = 1, 48
          KE(Q,I) = 0.0D0
    5   CONTINUE
   10 CONTINUE
      DO 40 BRICK = 0, 1
        H = X(1,8*BRICK+2) - X(1,8*BRICK+1)
        VOLUME = (H/2.0D0)**3
        DO 30 Q = 1, 8
          DO 20 I = 1, 3
            P(I) = CORNER(I,Q)/SQRT(3.0D0)
   20     CONTINUE
          CALL SHPGRD(H, P, G)
          CALL ADDPT(G, LAMBDA*VOLUME, MU*VOLUME, 24*BRICK, KE)
   30   CONTINUE
   40 CONTINUE
      END

C     One Gauss point of STIFF; LAMV, MUV: moduli times volume.
      SUBROUTINE ADDPT(G, LAMV, MUV, FIRST, KE)
      DOUBLE PRECISION G(3,8), LAMV, MUV, KE(48,48), T, DOT
      INTEGER FIRST, A, B, I, J, R, C
      DO 40 A = 1, 8
        DO 30 B = 1, 8
          DOT = G(1,A)*G(1,B) + G(2,A)*G(2,B) + G(3,A)*G(3,B)
          DO 20 I = 1, 3
            DO 10 J = 1, 3
              T = LAMV*G(I,A)*G(J,B) + MUV*G(J,A)*G(I,B)
              IF (I .EQ. J) T = T + MUV*DOT
              R = FIRST + 3*A - 3 + I
              C = FIRST + 3*B - 3 + J
              KE(R,C) = KE(R,C) + T
   10       CONTINUE
   20     CONTINUE
   30   CONTINUE
   40 CONTINUE
      END

C     Solves A X = B by Gauss elimination with partial pivoting; A is
C     destroyed, B becomes X. CODE: 0, or 1 when a pivot is zero.
      SUBROUTINE SOLVE(N, A, B, CODE)
      INTEGER N, CODE, I, J, COL, BEST
      DOUBLE PRECISION A(N,N), B(N), T
      CODE = 1
      DO 50 COL = 1, N
        BEST = COL
        DO 10 I = COL + 1, N
          IF (ABS(A(I,COL)) .GT. ABS(A(BEST,COL))) BEST = I
   10   CONTINUE
        DO 20 J = 1, N
          T = A(BEST,J)
          A(BEST,J) = A(COL,J)
          A(COL,J) = T
   20   CONTINUE
        T = B(BEST)
        B(BEST) = B(COL)
        B(COL) = T
        IF (.NOT. ABS(A(COL,COL)) .GT. 0.0D0) RETURN
        DO 40 I = COL + 1, N
          T = A(I,COL)/A(COL,COL)
          DO 30 J = COL, N
            A(I,J) = A(I,J) - T*A(COL,J)
   30     CONTINUE
          B(I) = B(I) - T*B(COL)
   40   CONTINUE
   50 CONTINUE
      DO 70 I = N, 1, -1
        DO 60 J = I + 1, N
          B(I) = B(I) - A(I,J)*B(J)
   60   CONTINUE
        B(I) = B(I)/A(I,I)
   70 CONTINUE
      CODE = 0
      END

      SUBROUTINE COPY(N, FROM, TO)
      INTEGER N, I
      DOUBLE PRECISION FROM(N), TO(N)
      DO 10 I = 1, N
        TO(I) = FROM(I)
   10 CONTINUE
      END
