! The Fortran code that evaluates the DATA of an exported model. Lines of !@ begin the parts
! that auto.c writes; this heading is not written.
!
!    W(h)    Omega^power cos|sin(k Omega t) of harmonic h; WS, WC its derivatives by U(2n+1), U(2n+2)
!    G(:,h)  f - D v - K u - Q u u of harmonic h
!
! With z = cos + i sin, d(z^k) = k z^(k-1) dz gives WS and WC.
!
! SPDX-License-Identifier: GPL-3.0-or-later
!@ auto_head
!   U(1..N) u   U(N+1..2N) du/dt   U(2N+1) sin(Omega t)   U(2N+2) cos(Omega t)
!   PAR(1) Omega   PAR(11) period; all scaled. PAR(2), PAR(3) factors of load and damping
! Lists: D, K, Q, C are the model's; EF, ED, EK, EQ the harmonics' f, D, K, Q
! (last index: harmonic). T: products of U(TI(4,I)), U(TI(5,I)), ..., TI(3,I) of them, in
! equation TI(1,I), of harmonic TI(2,I) unless that is 0.
! HK, HS, HP, HL: multiple of Omega, sine or not, powers of Omega and of the load.
SUBROUTINE FUNC(NDIM,U,ICP,PAR,IJAC,F,DFDU,DFDP)
  IMPLICIT NONE
  INTEGER, INTENT(IN) :: NDIM, ICP(*), IJAC
  DOUBLE PRECISION, INTENT(IN) :: U(NDIM), PAR(*)
  DOUBLE PRECISION, INTENT(OUT) :: F(NDIM)
  DOUBLE PRECISION, INTENT(INOUT) :: DFDU(NDIM,NDIM), DFDP(NDIM,*)
!@ auto_func
  DOUBLE PRECISION :: CO(0:KH), SI(0:KH), W(NH), WS(NH), WC(NH), WP(NH), WL(NH), G(N,NH), P, R
  INTEGER :: I, H, J, L, M, O
  CO(0) = 1
  SI(0) = 0
  DO I = 1, KH
    CO(I) = CO(I-1)*U(2*N+2) - SI(I-1)*U(2*N+1)
    SI(I) = SI(I-1)*U(2*N+2) + CO(I-1)*U(2*N+1)
  END DO
  DO H = 1, NH
    L = HK(H)
    P = PAR(1)**HP(H)*PAR(2)**HL(H)
    IF (HS(H) == 1) THEN
      W(H) = P*SI(L)
      WS(H) = P*L*CO(MAX(L-1,0))
      WC(H) = P*L*SI(MAX(L-1,0))
    ELSE
      W(H) = P*CO(L)
      WS(H) = -P*L*SI(MAX(L-1,0))
      WC(H) = P*L*CO(MAX(L-1,0))
    END IF
    WP(H) = HP(H)*W(H)/PAR(1)
    WL(H) = HL(H)*W(H)/PAR(2)
  END DO
  G = 0
  DO I = 1, NEF
    G(EFI(1,I),EFI(2,I)) = EF(I)
  END DO
  DO I = 1, NED
    G(EDI(1,I),EDI(3,I)) = G(EDI(1,I),EDI(3,I)) - ED(I)*U(N+EDI(2,I))
  END DO
  DO I = 1, NEK
    G(EKI(1,I),EKI(3,I)) = G(EKI(1,I),EKI(3,I)) - EK(I)*U(EKI(2,I))
  END DO
  DO I = 1, NEQ
    J = EQI(1,I)
    H = EQI(4,I)
    G(J,H) = G(J,H) - EQ(I)*U(EQI(2,I))*U(EQI(3,I))
  END DO
  F(1:N) = U(N+1:2*N)
  F(N+1:2*N) = 0
  DO I = 1, ND
    F(N+DI(1,I)) = F(N+DI(1,I)) - PAR(3)*D(I)*U(N+DI(2,I))
  END DO
  DO I = 1, NK
    F(N+KI(1,I)) = F(N+KI(1,I)) - K(I)*U(KI(2,I))
  END DO
  DO I = 1, NQ
    F(N+QI(1,I)) = F(N+QI(1,I)) - Q(I)*U(QI(2,I))*U(QI(3,I))
  END DO
  DO I = 1, NC
    F(N+CI(1,I)) = F(N+CI(1,I)) - C(I)*U(CI(2,I))*U(CI(3,I))*U(CI(4,I))
  END DO
  DO I = 1, NT
    J = TI(1,I)
    H = TI(2,I)
    P = T(I)
    DO M = 1, TI(3,I)
      P = P*U(TI(3+M,I))
    END DO
    IF (H == 0) THEN
      F(N+J) = F(N+J) - P
    ELSE
      G(J,H) = G(J,H) - P
    END IF
  END DO
  DO H = 1, NH
    F(N+1:2*N) = F(N+1:2*N) + W(H)*G(:,H)
  END DO
  R = 1 - U(2*N+1)**2 - U(2*N+2)**2
  F(2*N+1) = U(2*N+1)*R + PAR(1)*U(2*N+2)
  F(2*N+2) = U(2*N+2)*R - PAR(1)*U(2*N+1)
  IF (IJAC == 0) RETURN
  DFDU = 0
  DO I = 1, N
    DFDU(I,N+I) = 1
  END DO
  DO I = 1, ND
    DFDU(N+DI(1,I),N+DI(2,I)) = -PAR(3)*D(I)
  END DO
  DO I = 1, NK
    DFDU(N+KI(1,I),KI(2,I)) = -K(I)
  END DO
  DO I = 1, NQ
    J = N + QI(1,I)
    L = QI(2,I)
    M = QI(3,I)
    DFDU(J,L) = DFDU(J,L) - Q(I)*U(M)
    DFDU(J,M) = DFDU(J,M) - Q(I)*U(L)
  END DO
  DO I = 1, NC
    J = N + CI(1,I)
    L = CI(2,I)
    M = CI(3,I)
    O = CI(4,I)
    DFDU(J,L) = DFDU(J,L) - C(I)*U(M)*U(O)
    DFDU(J,M) = DFDU(J,M) - C(I)*U(L)*U(O)
    DFDU(J,O) = DFDU(J,O) - C(I)*U(L)*U(M)
  END DO
  DO I = 1, NED
    J = N + EDI(1,I)
    L = N + EDI(2,I)
    DFDU(J,L) = DFDU(J,L) - W(EDI(3,I))*ED(I)
  END DO
  DO I = 1, NEK
    J = N + EKI(1,I)
    L = EKI(2,I)
    DFDU(J,L) = DFDU(J,L) - W(EKI(3,I))*EK(I)
  END DO
  DO I = 1, NEQ
    J = N + EQI(1,I)
    L = EQI(2,I)
    M = EQI(3,I)
    R = W(EQI(4,I))*EQ(I)
    DFDU(J,L) = DFDU(J,L) - R*U(M)
    DFDU(J,M) = DFDU(J,M) - R*U(L)
  END DO
  DO I = 1, NT
    R = T(I)
    IF (TI(2,I) > 0) R = R*W(TI(2,I))
    DO M = 1, TI(3,I)
      P = R
      DO O = 1, TI(3,I)
        IF (O /= M) P = P*U(TI(3+O,I))
      END DO
      J = N + TI(1,I)
      L = TI(3+M,I)
      DFDU(J,L) = DFDU(J,L) - P
    END DO
  END DO
  R = 1 - U(2*N+1)**2 - U(2*N+2)**2
  DO H = 1, NH
    DFDU(N+1:2*N,2*N+1) = DFDU(N+1:2*N,2*N+1) + WS(H)*G(:,H)
    DFDU(N+1:2*N,2*N+2) = DFDU(N+1:2*N,2*N+2) + WC(H)*G(:,H)
  END DO
  DFDU(2*N+1,2*N+1) = R - 2*U(2*N+1)**2
  DFDU(2*N+1,2*N+2) = PAR(1) - 2*U(2*N+1)*U(2*N+2)
  DFDU(2*N+2,2*N+1) = -PAR(1) - 2*U(2*N+1)*U(2*N+2)
  DFDU(2*N+2,2*N+2) = R - 2*U(2*N+2)**2
  IF (IJAC == 1) RETURN
  DFDP(1:NDIM,1:3) = 0
  DO H = 1, NH
    DFDP(N+1:2*N,1) = DFDP(N+1:2*N,1) + WP(H)*G(:,H)
    DFDP(N+1:2*N,2) = DFDP(N+1:2*N,2) + WL(H)*G(:,H)
  END DO
  DFDP(2*N+1,1) = U(2*N+2)
  DFDP(2*N+2,1) = -U(2*N+1)
  DO I = 1, ND
    DFDP(N+DI(1,I),3) = DFDP(N+DI(1,I),3) - D(I)*U(N+DI(2,I))
  END DO
END SUBROUTINE FUNC

! The first orbit, at time T of the period: a Fourier series.
SUBROUTINE STPNT(NDIM,U,PAR,T)
  IMPLICIT NONE
  INTEGER, INTENT(IN) :: NDIM
  DOUBLE PRECISION, INTENT(INOUT) :: U(NDIM), PAR(*)
  DOUBLE PRECISION, INTENT(IN) :: T
!@ auto_tail
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
END SUBROUTINE STPNT

SUBROUTINE BCND
END SUBROUTINE BCND

SUBROUTINE ICND
END SUBROUTINE ICND

SUBROUTINE FOPT
END SUBROUTINE FOPT

SUBROUTINE PVLS
END SUBROUTINE PVLS
