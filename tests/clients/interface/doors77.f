C     doors77.f - the Fortran 77 entries one by one, against values that
C     are known. The model: a unit square facet z = 0, counter-clockwise
C     seen from above, and slave points near it. eps_n = 1000, r0 = 0.
      PROGRAM DOOR77
      LOGICAL NAMES, REASON, NEARBY, PATCH, BATCH, CARRY, OK
      INTEGER I
      OK = .TRUE.
      DO 10 I = 1, 6
        IF (I .EQ. 1) CALL SAY(NAMES(), 'find and info', OK)
        IF (I .EQ. 2) CALL SAY(REASON(), 'place and text', OK)
        IF (I .EQ. 3) CALL SAY(NEARBY(), 'project', OK)
        IF (I .EQ. 4) CALL SAY(PATCH(), 'patch', OK)
        IF (I .EQ. 5) CALL SAY(BATCH(), 'batch and scatter', OK)
        IF (I .EQ. 6) CALL SAY(CARRY(), 'histories', OK)
   10 CONTINUE
      IF (.NOT. OK) STOP 1
      WRITE (*, '(A)') 'PASS doors77'
      END

      SUBROUTINE SAY(PASS, WHAT, OK)
      LOGICAL PASS, OK
      CHARACTER*(*) WHAT
      IF (PASS) WRITE (*, '(2A)') 'PASS ', WHAT
      IF (.NOT. PASS) WRITE (*, '(2A)') 'FAIL ', WHAT
      OK = OK .AND. PASS
      END

C     Codes of the characters of a text.
      SUBROUTINE LETTER(TEXT, CODES)
      CHARACTER*(*) TEXT
      INTEGER CODES(*), I
      DO 10 I = 1, LEN(TEXT)
        CODES(I) = ICHAR(TEXT(I:I))
   10 CONTINUE
      END

C     Where two numbers differ by rounding at most.
      LOGICAL FUNCTION SAME(A, B)
      DOUBLE PRECISION A, B
      SAME = ABS(A - B) .LE. 1.0D-12*(1.0D0 + ABS(B))
      END

C     Slave point (PX, PY, PZ), then the facet, in X(4,5).
      SUBROUTINE FACET(PX, PY, PZ, X)
      DOUBLE PRECISION PX, PY, PZ, X(4,5), SQUARE(3,4)
      INTEGER A, I
      DATA SQUARE /0,0,0, 1,0,0, 1,1,0, 0,1,0/
      X(1,1) = PX
      X(2,1) = PY
      X(3,1) = PZ
      X(4,1) = 0.0D0
      DO 20 A = 1, 4
        DO 10 I = 1, 3
          X(I,A+1) = SQUARE(I,A)
   10   CONTINUE
        X(4,A+1) = 0.0D0
   20 CONTINUE
      END

C     A name that an element has, with blanks behind it, and one that no
C     element has.
      LOGICAL FUNCTION NAMES()
      INCLUDE 'contact_elements.inc'
      INTEGER CODES(20), E, CODE, ISIZES(0:CTE_F77_SIZES-1)
      CALL LETTER('InterpolatedQuad4   ', CODES)
      CALL CTE_F77_FIND(CODES, 20, E, CODE)
      NAMES = CODE .EQ. CTE_SUCCESS .AND. E .EQ. CTE_INTERPOLATED_QUAD4
      CALL CTE_F77_INFO(E, 7, ISIZES, CODE)
      NAMES = NAMES .AND. CODE .EQ. CTE_SUCCESS
     1    .AND. ISIZES(CTE_F77_SIZE_DIMENSION) .EQ. 3
     2    .AND. ISIZES(CTE_F77_SIZE_NODES_MINIMUM) .EQ. 5
     3    .AND. ISIZES(CTE_F77_SIZE_NODES_MAXIMUM) .EQ. 0
     4    .AND. ISIZES(CTE_F77_SIZE_SLAVE_NODES) .EQ. 0
     5    .AND. ISIZES(CTE_F77_SIZE_MASTER_NODES) .EQ. 4
     6    .AND. ISIZES(CTE_F77_SIZE_UNKNOWNS) .EQ. 21
     7    .AND. ISIZES(CTE_F77_SIZE_WORKSPACE) .GT. 0
      CALL LETTER('InterpolatedQuad5', CODES)
      CALL CTE_F77_FIND(CODES, 17, E, CODE)
      NAMES = NAMES .AND. CODE .EQ. CTE_ERROR_NAME
     1    .AND. E .EQ. CTE_INTERPOLATED_QUAD4
      END

C     A parameter outside its range: where it is, and the message. Then
C     the same call with all numbers right: -f in the rows of a map.
      LOGICAL FUNCTION REASON()
      INCLUDE 'contact_elements.inc'
      INTEGER ISTATE(0:CTE_F77_STATES-1), ITEXT(200), LENGTH, CODE, I
      INTEGER MAP(15), IREQ
      PARAMETER (IREQ = CTE_RESIDUAL + CTE_TANGENT + CTE_OUTPUT)
      DOUBLE PRECISION X(4,5), PAR(3), F(0:29), S(0:29,0:29), ENERGY
      DOUBLE PRECISION OUT(0:CTE_OUTPUT_SIZE-1), HIST(3), W
      CHARACTER*200 TEXT
      LOGICAL SAME
      CALL FACET(0.25D0, 0.5D0, -0.05D0, X)
      PAR(1) = -1.0D0
      PAR(2) = 0.0D0
      PAR(3) = 1.0D0
      DO 10 I = 1, 15
        MAP(I) = 2*I - 1
   10 CONTINUE
      DO 20 I = 1, 3
        HIST(I) = 0.0D0
   20 CONTINUE
      CALL CTE_F77_EVALUATE(CTE_POINT_QUAD4, IREQ, 0, 0, X, 4, X, 4,
     1    PAR, 3, HIST, HIST, W, 1, MAP, -1.0D0, 2.0D0, F, S, 30, OUT,
     2    ENERGY, W, 0, ISTATE, CODE)
      REASON = CODE .EQ. CTE_ERROR_PARAMETER .AND.
     1    ISTATE(CTE_F77_STATE_ARGUMENT) .EQ. CTE_ARGUMENT_PARAMETERS
     2    .AND. ISTATE(CTE_F77_STATE_INDEX) .EQ. 0
      CALL CTE_F77_MESSAGE(CTE_POINT_QUAD4, CODE, ISTATE, ITEXT, 200,
     1    LENGTH)
      DO 30 I = 1, 200
        TEXT(I:I) = CHAR(ITEXT(I))
   30 CONTINUE
      WRITE (*, '(A)') TEXT(1:LENGTH)
      REASON = REASON .AND. INDEX(TEXT, 'PointQuad4') .EQ. 1 .AND.
     1    INDEX(TEXT, 'eps_n') .GT. 0 .AND. TEXT(LENGTH+1:) .EQ. ' '
      PAR(1) = 1000.0D0
C     Twice x is the position: displacements are as large as x.
      CALL CTE_F77_EVALUATE(CTE_POINT_QUAD4, IREQ, 0, 0, X, 4, X, 4,
     1    PAR, 3, HIST, HIST, W, 1, MAP, -1.0D0, 2.0D0, F, S, 30, OUT,
     2    ENERGY, W, 0, ISTATE, CODE)
      REASON = REASON .AND. CODE .EQ. CTE_SUCCESS
     1    .AND. ISTATE(CTE_F77_STATE_STATUS) .EQ. CTE_STATUS_CLOSED
     2    .AND. ISTATE(CTE_F77_STATE_CLOSED) .EQ. 1
     3    .AND. SAME(OUT(CTE_OUTPUT_GAP), -0.1D0)
     4    .AND. SAME(F(5), 100.0D0) .AND. SAME(S(5,5), 2000.0D0)
      END

C     The closest point of (0.25, 0.5, 0.3) is (-0.5, 0) of the facet.
      LOGICAL FUNCTION NEARBY()
      INCLUDE 'contact_elements.inc'
      INTEGER ISTATE(0:CTE_F77_STATES-1), CODE
      DOUBLE PRECISION X(4,5), PAR(3), P(0:CTE_F77_PROJECTIONS-1), W
      DOUBLE PRECISION U(3,5), HIST(0:2)
      LOGICAL SAME
      DATA U /15*0.0D0/, PAR /1000.0D0, 0.0D0, 1.0D0/
      CALL FACET(0.25D0, 0.5D0, 0.3D0, X)
      CALL CTE_F77_PROJECT(CTE_POINT_QUAD4, 5, 0, X, 4, U, 0, PAR, 3, W,
     1    0.0D0, P, HIST, ISTATE, CODE)
      NEARBY = CODE .EQ. CTE_SUCCESS
     1    .AND. SAME(P(CTE_F77_PROJECTION_ZETA), -0.5D0)
     2    .AND. SAME(P(CTE_F77_PROJECTION_ZETA+1), 0.0D0)
     3    .AND. SAME(P(CTE_F77_PROJECTION_DISTANCE), 0.3D0)
     4    .AND. SAME(P(CTE_F77_PROJECTION_DEFINITE), 1.0D0)
     5    .AND. NINT(P(CTE_F77_PROJECTION_VERDICT)) .EQ.
     6    CTE_VERDICT_INSIDE
     7    .AND. NINT(P(CTE_F77_PROJECTION_FEATURE)) .EQ. 0
     8    .AND. P(CTE_F77_PROJECTION_BOXES) .GE. 1.0D0
     9    .AND. SAME(HIST(CTE_HISTORY_PROJECTION), -0.5D0)
      CALL CTE_F77_PROJECT(CTE_POINT_QUAD4, 5, 0, X, 4, U, 0, PAR, 3, W,
     1    -1.0D0, P, HIST, ISTATE, CODE)
      NEARBY = NEARBY .AND. CODE .EQ. CTE_ERROR_NOT_FINITE .AND.
     1    ISTATE(CTE_F77_STATE_ARGUMENT) .EQ. CTE_ARGUMENT_REACH
      END

C     Two slave points below one facet, one of them beyond an edge that
C     the patch does not know.
      LOGICAL FUNCTION PATCH()
      INCLUDE 'contact_elements.inc'
      INTEGER IP(0:CTE_F77_PATCHES-1), CONN(4), CODE, ARGUM, I, IREQ
      INTEGER ISIZES(0:CTE_F77_SIZES-1), ISTATE(0:CTE_F77_STATES-1)
      DOUBLE PRECISION X(4,6), U(3,6), PAR(3), HIST(10), F(3,6), S(18)
      DOUBLE PRECISION OUT(0:CTE_OUTPUT_SIZE-1,2), ENERGY, WORK(12)
      LOGICAL SAME
      PARAMETER (IREQ = CTE_RESIDUAL + CTE_OUTPUT + CTE_ENERGY)
      DATA CONN /0, 1, 2, 3/, U /18*0.0D0/, HIST /10*0.0D0/
      DATA PAR /1000.0D0, 0.0D0, 1.0D0/
      CALL FACET(0.25D0, 0.5D0, -0.1D0, X(1,2))
      DO 10 I = 1, 4
        X(I,1) = X(I,2)
   10 CONTINUE
      X(1,2) = 1.5D0
      IP(CTE_F77_PATCH_SLAVE_POINTS) = 2
      IP(CTE_F77_PATCH_MASTER_NODES) = 4
      IP(CTE_F77_PATCH_FACETS) = 1
      IP(CTE_F77_PATCH_FACET) = CTE_POINT_QUAD4
      IP(CTE_F77_PATCH_EDGE) = -1
      IP(CTE_F77_PATCH_VERTEX) = -1
      CALL CTE_F77_PATCH_INFO(IP, CONN, 0.0D0, ISIZES, ARGUM, CODE)
      PATCH = CODE .EQ. CTE_SUCCESS .AND. ARGUM .EQ. CTE_ARGUMENT_NONE
     1    .AND. ISIZES(CTE_F77_SIZE_UNKNOWNS) .EQ. 18
     2    .AND. ISIZES(CTE_F77_SIZE_HISTORY) .EQ. 10
     3    .AND. ISIZES(CTE_F77_SIZE_POINTS) .EQ. 2
     4    .AND. ISIZES(CTE_F77_SIZE_WORKSPACE) .LE. 12
      CALL CTE_F77_PATCH_EVALUATE(IP, CONN, 0.0D0, IREQ, 6, X, 4, U, 3,
     1    PAR, 3, HIST, HIST, 0, CONN, 1.0D0, 1.0D0, F, S, 18, OUT,
     2    ENERGY, WORK, 12, ISTATE, CODE)
      PATCH = PATCH .AND. CODE .EQ. CTE_SUCCESS
     1    .AND. ISTATE(CTE_F77_STATE_CLOSED) .EQ. 1
     2    .AND. SAME(F(3,1), -100.0D0) .AND. SAME(ENERGY, 5.0D0)
     3    .AND. SAME(F(3,3)+F(3,4)+F(3,5)+F(3,6), 100.0D0)
     4    .AND. NINT(OUT(CTE_OUTPUT_STATUS,2)) .EQ. CTE_STATUS_OUTSIDE
      IP(CTE_F77_PATCH_VERTEX) = 100000
      CALL CTE_F77_PATCH_INFO(IP, CONN, 0.0D0, ISIZES, ARGUM, CODE)
      PATCH = PATCH .AND. CODE .EQ. CTE_ERROR_INDEX
     1    .AND. ARGUM .EQ. CTE_ARGUMENT_VERTEX
     2    .AND. ISIZES(CTE_F77_SIZE_POINTS) .EQ. -1
      END

C     Two contacts that share a facet, gathered from six nodes: results
C     of each, then sums into a matrix with all 18 columns in each row.
      LOGICAL FUNCTION BATCH()
      INCLUDE 'contact_elements.inc'
      INTEGER IREQ, OWN, CODE, I, J, CONN(5,2), COLUMN(324)
      INTEGER ISTAT(2), ICODE(2), ISTATE(0:CTE_F77_STATES-1)
      INTEGER*8 ROWST(19), MAP(225,2), BLOCKS(30,2)
      DOUBLE PRECISION X(4,6), U(4,6), PAR(3), F(3,5,2), S(15,15,2)
      DOUBLE PRECISION G(3,6), A(18,18), B(18,18), OUT, ENERGY(2), W
      DOUBLE PRECISION HIST(3,2)
      LOGICAL SAME
      PARAMETER (IREQ = CTE_RESIDUAL + CTE_TANGENT + CTE_ENERGY)
      PARAMETER (OWN = CTE_F77_INTO_OWN)
      DATA CONN /0,2,3,4,5, 1,2,3,4,5/, U /24*0.0D0/, HIST /6*0.0D0/
      DATA PAR /1000.0D0, 0.0D0, 1.0D0/
      CALL FACET(0.25D0, 0.5D0, -0.2D0, X(1,2))
      DO 10 I = 1, 4
        X(I,1) = X(I,2)
   10 CONTINUE
      X(3,1) = -0.1D0
      DO 30 I = 1, 18
        ROWST(I) = 18*(I-1)
        DO 20 J = 1, 18
          COLUMN(18*(I-1)+J) = J - 1
          A(J,I) = 0.0D0
          B(J,I) = 0.0D0
   20   CONTINUE
   30 CONTINUE
      ROWST(19) = 324
      DO 50 J = 1, 6
        DO 40 I = 1, 3
          G(I,J) = 0.0D0
   40   CONTINUE
   50 CONTINUE
      CALL CTE_F77_CSR_MAP(CTE_POINT_QUAD4, 2, 0, CONN, 18, ROWST,
     1    COLUMN, MAP, CODE)
      BATCH = CODE .EQ. CTE_SUCCESS
      CALL CTE_F77_CSR_BLOCKS(CTE_POINT_QUAD4, 2, 0, CONN, 18, ROWST,
     1    COLUMN, BLOCKS, CODE)
      BATCH = BATCH .AND. CODE .EQ. CTE_SUCCESS
      CALL CTE_F77_BATCH(CTE_POINT_QUAD4, 2, IREQ, 0, 6, CONN, X, 4, U,
     1    4, PAR, 3, 0, HIST, HIST, W, OWN+CTE_F77_INTO_GLOBAL, 1.0D0,
     2    1.0D0, F, S, G, A, MAP, OUT, ENERGY, ISTAT, ICODE, W, 0,
     3    ISTATE, CODE)
      BATCH = BATCH .AND. CODE .EQ. CTE_SUCCESS
     1    .AND. ISTAT(1) .EQ. CTE_STATUS_CLOSED .AND. ICODE(2) .EQ. 0
     2    .AND. ISTATE(CTE_F77_STATE_CLOSED) .EQ. 0
     3    .AND. SAME(F(3,1,1), -100.0D0) .AND. SAME(G(3,2), -200.0D0)
     4    .AND. SAME(S(3,3,2), 1000.0D0) .AND. SAME(A(6,6), 1000.0D0)
     5    .AND. SAME(ENERGY(2), 20.0D0)
     6    .AND. SAME(G(3,3)+G(3,4)+G(3,5)+G(3,6), 300.0D0)
C     By blocks of nodes, into B alone: the same sums.
      CALL CTE_F77_BATCH(CTE_POINT_QUAD4, 2, IREQ + CTE_CSR_BY_BLOCKS,
     1    0, 6, CONN, X, 4, U, 4, PAR, 3, 0, HIST, HIST, W,
     2    CTE_F77_INTO_GLOBAL, 1.0D0, 1.0D0, F, S, G, B, BLOCKS, OUT,
     3    ENERGY, ISTAT, ICODE, W, 0, ISTATE, CODE)
      BATCH = BATCH .AND. CODE .EQ. CTE_SUCCESS
      DO 70 I = 1, 18
        DO 60 J = 1, 18
          BATCH = BATCH .AND. SAME(B(J,I), A(J,I))
   60   CONTINUE
   70 CONTINUE
C     Contact 2 has a node that is not there: the batch is refused.
      CONN(1,2) = 6
      CALL CTE_F77_BATCH(CTE_POINT_QUAD4, 2, IREQ, 0, 6, CONN, X, 4, U,
     1    4, PAR, 3, 0, HIST, HIST, W, OWN, 1.0D0, 1.0D0, F, S, G, A,
     2    MAP, OUT, ENERGY, ISTAT, ICODE, W, 0, ISTATE, CODE)
      BATCH = BATCH .AND. CODE .EQ. CTE_ERROR_INDEX .AND.
     1    ISTATE(CTE_F77_STATE_ARGUMENT) .EQ. CTE_ARGUMENT_CONNECTIVITY
     2    .AND. ISTATE(CTE_F77_STATE_INDEX) .EQ. 5
      CONN(1,2) = 1
      END

C     An all-zero history begins a step; Uzawa's step then holds N.
      LOGICAL FUNCTION CARRY()
      INCLUDE 'contact_elements.inc'
      INTEGER ISTATE(0:CTE_F77_STATES-1), ARGUM, CODE, MAP(1), I, IREQ
      DOUBLE PRECISION X(4,5), U(3,5), PAR(3), HIST(4), TRIAL(4), F(15)
      DOUBLE PRECISION S(1,1), OUT(1), ENERGY, W
      LOGICAL SAME
      PARAMETER (IREQ = CTE_RESIDUAL + CTE_HISTORY)
      DATA U /15*0.0D0/, PAR /1000.0D0, 0.0D0, 1.0D0/
      CALL FACET(0.25D0, 0.5D0, -0.1D0, X)
      DO 10 I = 1, 4
        HIST(I) = 0.0D0
   10 CONTINUE
      CALL CTE_F77_EVALUATE(CTE_POINT_QUAD4_AUGMENTED, IREQ, 5, 1, X, 4,
     1    U, 3, PAR, 3, HIST, TRIAL, W, 0, MAP, 1.0D0, 1.0D0, F, S, 15,
     2    OUT, ENERGY, W, 0, ISTATE, CODE)
      CARRY = CODE .EQ. CTE_SUCCESS .AND. SAME(F(3), -100.0D0)
      CALL CTE_F77_HISTORY_AUGMENT(CTE_POINT_QUAD4_AUGMENTED, TRIAL,
     1    HIST, ARGUM, CODE)
      CARRY = CARRY .AND. CODE .EQ. CTE_SUCCESS
     1    .AND. SAME(HIST(4), -100.0D0)
      CALL CTE_F77_HISTORY_INIT(CTE_POINT_QUAD4_AUGMENTED, HIST, CODE)
      CARRY = CARRY .AND. CODE .EQ. CTE_SUCCESS
     1    .AND. SAME(HIST(4), 0.0D0)
      CALL CTE_F77_HISTORY_AUGMENT(CTE_POINT_QUAD4, TRIAL, HIST, ARGUM,
     1    CODE)
      CARRY = CARRY .AND. CODE .EQ. CTE_ERROR_ELEMENT
     1    .AND. ARGUM .EQ. CTE_ARGUMENT_ELEMENT
      END
