! The Fortran code that evaluates the DATA of an exported model. Lines of !@ begin the parts
! that auto.c writes; this heading is not written.
!
!    W(h)    Omega^power load^power cos|sin(k Omega t) of harmonic h, W(0) = 1; WS, WC its derivatives by
!            U(2n+1), U(2n+2), WP and WL by Omega and the load
!    T, S    Chebyshev polynomials of PAR(1) over its range, and their derivatives
!
! With z = cos + i sin, d(z^k) = k z^(k-1) dz gives WS and WC.
!
! SPDX-License-Identifier: GPL-3.0-or-later
!@ auto_forced
!   U(1..N) u   U(N+1..2N) du/dt   U(2N+1) sin(Omega t)   U(2N+2) cos(Omega t)
!   PAR(1) Omega   PAR(11) period; all scaled. PAR(2), PAR(3) factors of load and damping
!@ auto_own
!   U(1..N) u   U(N+1..2N) du/dt, if it has accelerations   PAR(1) the parameter   PAR(11) period
!   PAR(2), PAR(3) factors of the constant forces and of damping. Units are those at the first value
!@ auto_head
! Row I: the Chebyshev sum A(:,I), times the product of U(RI(5,I)), ..., RI(4,I) of them, in equation
! RI(1,I), of harmonic RI(2,I) unless that is 0; RI(3,I): of damping.
! HK, HS, HP, HL: multiple of Omega, sine or not, powers of Omega and of the load.
SUBROUTINE FUNC(NDIM,U,ICP,PAR,IJAC,F,DFDU,DFDP)
  IMPLICIT NONE
  INTEGER, INTENT(IN) :: NDIM, ICP(*), IJAC
  DOUBLE PRECISION, INTENT(IN) :: U(NDIM), PAR(*)
  DOUBLE PRECISION, INTENT(OUT) :: F(NDIM)
  DOUBLE PRECISION, INTENT(INOUT) :: DFDU(NDIM,NDIM), DFDP(NDIM,*)
!@ auto_func
  DOUBLE PRECISION :: CO(0:KH), SI(0:KH), W(0:NH), WS(0:NH), WC(0:NH), WP(0:NH), WL(0:NH)
  DOUBLE PRECISION :: T(0:DEG), S(0:DEG), X, G, P, Q, R
  INTEGER :: I, H, J, L, M, O, X1, X2
  X1 = MERGE(1, 2*N+1, OWN)
  X2 = MERGE(1, 2*N+2, OWN)
  CO(0) = 1
  SI(0) = 0
  DO I = 1, KH
    CO(I) = CO(I-1)*U(X2) - SI(I-1)*U(X1)
    SI(I) = SI(I-1)*U(X2) + CO(I-1)*U(X1)
  END DO
  W(0) = 1
  WS(0) = 0
  WC(0) = 0
  WP(0) = 0
  WL(0) = 0
  DO H = 1, NH
    L = HK(H)
    P = PAR(2)**HL(H)
    IF (HP(H) > 0) P = P*PAR(1)**HP(H)
    IF (HS(H) == 1) THEN
      W(H) = P*SI(L)
      WS(H) = P*L*CO(MAX(L-1,0))
      WC(H) = P*L*SI(MAX(L-1,0))
    ELSE
      W(H) = P*CO(L)
      WS(H) = -P*L*SI(MAX(L-1,0))
      WC(H) = P*L*CO(MAX(L-1,0))
    END IF
    WP(H) = 0
    IF (HP(H) > 0) WP(H) = HP(H)*W(H)/PAR(1)
    WL(H) = HL(H)*W(H)/PAR(2)
  END DO
  X = (2*PAR(1) - FROM - TO)/(TO - FROM)
  DO I = 0, DEG
    T(I) = 1
    S(I) = 0
    IF (I == 1) THEN
      T(I) = X
      S(I) = 2/(TO - FROM)
    ELSE IF (I > 1) THEN
      T(I) = 2*X*T(I-1) - T(I-2)
      S(I) = 4/(TO - FROM)*T(I-1) + 2*X*S(I-1) - S(I-2)
    END IF
  END DO
  F = 0
  F(1:NV) = U(N+1:N+NV)
  IF (IJAC > 0) DFDU = 0
  IF (IJAC > 1) DFDP(1:NDIM,1:3) = 0
  DO I = 1, MERGE(NV, 0, IJAC > 0)
    DFDU(I,N+I) = 1
  END DO
  DO I = 1, NR
    J = RI(1,I)
    H = RI(2,I)
    G = DOT_PRODUCT(A(:,I), T)
    R = G
    IF (RI(3,I) == 1) R = G*PAR(3)
    P = 1
    DO M = 1, RI(4,I)
      P = P*U(RI(4+M,I))
    END DO
    F(J) = F(J) + W(H)*R*P
    IF (IJAC == 0) CYCLE
    DO M = 1, RI(4,I)
      Q = W(H)*R
      DO O = 1, RI(4,I)
        IF (O /= M) Q = Q*U(RI(4+O,I))
      END DO
      L = RI(4+M,I)
      DFDU(J,L) = DFDU(J,L) + Q
    END DO
    IF (H > 0 .AND. .NOT. OWN) THEN
      DFDU(J,X1) = DFDU(J,X1) + WS(H)*R*P
      DFDU(J,X2) = DFDU(J,X2) + WC(H)*R*P
    END IF
    IF (IJAC == 1) CYCLE
    Q = DOT_PRODUCT(A(:,I), S)*P*W(H)
    IF (RI(3,I) == 1) Q = Q*PAR(3)
    DFDP(J,1) = DFDP(J,1) + WP(H)*R*P + Q
    DFDP(J,2) = DFDP(J,2) + WL(H)*R*P
    IF (RI(3,I) == 1) DFDP(J,3) = DFDP(J,3) + G*P*W(H)
  END DO
  IF (OWN) RETURN
  R = 1 - U(X1)**2 - U(X2)**2
  F(X1) = U(X1)*R + PAR(1)*U(X2)
  F(X2) = U(X2)*R - PAR(1)*U(X1)
  IF (IJAC == 0) RETURN
  DFDU(X1,X1) = R - 2*U(X1)**2
  DFDU(X1,X2) = PAR(1) - 2*U(X1)*U(X2)
  DFDU(X2,X1) = -PAR(1) - 2*U(X1)*U(X2)
  DFDU(X2,X2) = R - 2*U(X2)**2
  IF (IJAC == 1) RETURN
  DFDP(X1,1) = U(X2)
  DFDP(X2,1) = -U(X1)
END SUBROUTINE FUNC

! The first orbit at time T of the period, a Fourier series; or the first equilibrium.
SUBROUTINE STPNT(NDIM,U,PAR,T)
  IMPLICIT NONE
  INTEGER, INTENT(IN) :: NDIM
  DOUBLE PRECISION, INTENT(INOUT) :: U(NDIM), PAR(*)
  DOUBLE PRECISION, INTENT(IN) :: T
!@ auto_rest
  U = 0
  PAR(2) = 1
  PAR(3) = 1
!@ auto_orbit
  DOUBLE PRECISION :: TAU
  INTEGER :: I
  TAU = 8*ATAN(1D0)*T
  PAR(1) = OMEGA
  PAR(2) = 1
  PAR(3) = 1
  PAR(11) = 8*ATAN(1D0)/OMEGA
  U = 0
  DO I = 0, H
    U(1:N) = U(1:N) + A(I,:)*COS(I*TAU) + B(I,:)*SIN(I*TAU)
    U(N+1:2*N) = U(N+1:2*N) + OMEGA*I*(B(I,:)*COS(I*TAU) - A(I,:)*SIN(I*TAU))
  END DO
  U(2*N+1) = SIN(TAU)
  U(2*N+2) = COS(TAU)
!@ auto_tail
END SUBROUTINE STPNT

SUBROUTINE BCND
END SUBROUTINE BCND

SUBROUTINE ICND
END SUBROUTINE ICND

SUBROUTINE FOPT
END SUBROUTINE FOPT

SUBROUTINE PVLS
END SUBROUTINE PVLS
