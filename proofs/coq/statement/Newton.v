(** That the statement's [push] is Newton's law for two point masses and a rod.

    The masses have the velocities (a1, b1), (a2, b2), horizontal and vertical; the rod has the direction (cos th, sin
    th), from mass 2 to mass 1. At an instant the floor gives the masses the vertical impulses J1, J2 (one of which is
    0), and the massless rod gives them opposite impulses along itself, K and - K. Then the centre of mass keeps its
    horizontal velocity, and the others change as [push] says; and each such change is made by a K. The energy of the
    two masses is that of [energy] and of the horizontal motion.

    newton == Newton's law at an impulse of the floor and of the rod; vel_of: the statement's velocity
    newton_push1, newton_push2, push1_newton, push2_newton == it makes the pushes of the statement, and all of them
    kinetic_energy == the masses' energy is the statement's, and that of the horizontal motion *)
From Coq Require Import Reals Lra.
From Dumbbell Require Import Physics.
Local Open Scope R_scope.

Section Newton.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.

(** The velocity of the centre of mass, and the rate at which the rod turns. *)
Definition vx_of (a1 a2 : R) := (m1 P * a1 + m2 P * a2) / mass P.
Definition vel_of th (a1 b1 a2 b2 : R) :=
  {| vy := (m1 P * b1 + m2 P * b2) / mass P; om := ((b1 - b2) * cos th - (a1 - a2) * sin th) / ell P |}.
(** The rod keeps its length. *)
Definition rigid th (a1 b1 a2 b2 : R) := (a1 - a2) * cos th + (b1 - b2) * sin th = 0.
Definition kinetic (a1 b1 a2 b2 : R) := (m1 P * (a1 * a1 + b1 * b1) + m2 P * (a2 * a2 + b2 * b2)) / 2.

(** The heights of the masses: a rod of length ell about the centre of mass. *)
Theorem rod_of_length s : y1 P s - y2 P s = ell P * sin (angle s) /\
  m1 P * y1 P s + m2 P * y2 P s = mass P * height s.
Proof.
  assert (M := mass_pos P HP). unfold y1, y2, arm1, arm2, mass in *. destruct HP as [? [? ?]]. split; field; lra.
Qed.

(** The vertical velocities of the masses are w1 and w2. *)
Theorem vertical_velocities s a1 b1 a2 b2 : rigid (angle s) a1 b1 a2 b2 ->
  let v := vel_of (angle s) a1 b1 a2 b2 in w1 P s v = b1 /\ w2 P s v = b2.
Proof.
  intros Hr v. unfold rigid in Hr. assert (M := mass_pos P HP). unfold v, w1, w2, vel_of, arm1, arm2, mass in *; simpl.
  destruct HP as [P1 [P2 P3]]. set (c := cos (angle s)) in *. set (S := sin (angle s)) in *.
  assert (HS : S * S = 1 - c * c) by (generalize (sin2_cos2 (angle s)); unfold Rsqr, c, S; lra).
  assert (E : ((b1 - b2) * c - (a1 - a2) * S) * c = b1 - b2).
  { replace (((b1 - b2) * c - (a1 - a2) * S) * c) with ((b1 - b2) * (c * c) - S * ((a1 - a2) * c)) by ring.
    replace ((a1 - a2) * c) with (- ((b1 - b2) * S)) by lra.
    replace (c * c) with (1 - S * S) by lra. ring. }
  set (d := (b1 - b2) * c - (a1 - a2) * S) in *. split; (apply Rmult_eq_reg_r with (m1 P + m2 P); [|lra]).
  - replace (((m1 P * b1 + m2 P * b2) / (m1 P + m2 P) + ell P * (m2 P / (m1 P + m2 P)) * c * (d / ell P)) *
      (m1 P + m2 P)) with (m1 P * b1 + m2 P * b2 + m2 P * (d * c)) by (field; lra). rewrite E. ring.
  - replace (((m1 P * b1 + m2 P * b2) / (m1 P + m2 P) - ell P * (m1 P / (m1 P + m2 P)) * c * (d / ell P)) *
      (m1 P + m2 P)) with (m1 P * b1 + m2 P * b2 - m1 P * (d * c)) by (field; lra). rewrite E. ring.
Qed.

Theorem kinetic_energy th a1 b1 a2 b2 : rigid th a1 b1 a2 b2 ->
  kinetic a1 b1 a2 b2 = mass P * (vx_of a1 a2 * vx_of a1 a2) / 2 + energy P (vel_of th a1 b1 a2 b2).
Proof.
  intros Hr. unfold rigid in Hr. assert (M := mass_pos P HP).
  assert (E : ((b1 - b2) * cos th - (a1 - a2) * sin th) * ((b1 - b2) * cos th - (a1 - a2) * sin th) =
    (a1 - a2) * (a1 - a2) + (b1 - b2) * (b1 - b2)).
  { set (c := cos th) in *. set (S := sin th) in *.
    assert (HS : S * S + c * c = 1) by (generalize (sin2_cos2 th); unfold Rsqr, c, S; lra).
    replace (((b1 - b2) * c - (a1 - a2) * S) * ((b1 - b2) * c - (a1 - a2) * S)) with
      (((a1 - a2) * (a1 - a2) + (b1 - b2) * (b1 - b2)) * (S * S + c * c) -
      ((a1 - a2) * c + (b1 - b2) * S) * ((a1 - a2) * c + (b1 - b2) * S)) by ring. rewrite Hr, HS. ring. }
  unfold energy, kinetic, vx_of, vel_of, inertia, arm1, arm2; simpl. destruct HP as [P1 [P2 P3]].
  set (d := (b1 - b2) * cos th - (a1 - a2) * sin th) in *.
  assert (I : forall D, D = d / ell P -> (m1 P * (ell P * (m2 P / mass P) * (ell P * (m2 P / mass P))) +
    m2 P * (ell P * (m1 P / mass P) * (ell P * (m1 P / mass P)))) * (D * D) = m1 P * m2 P / mass P * (d * d)).
  { intros D ->. unfold mass in *. field. lra. }
  rewrite (I _ eq_refl), E. unfold mass in *. field. lra.
Qed.

Section Impulses.
Variables th a1 b1 a2 b2 a1' b1' a2' b2' J1 J2 : R.
(** Newton's law: the floor's impulses and the rod's. *)
Definition newton := exists K,
  m1 P * (a1' - a1) = K * cos th /\ m1 P * (b1' - b1) = J1 + K * sin th /\
  m2 P * (a2' - a2) = - (K * cos th) /\ m2 P * (b2' - b2) = J2 - K * sin th.
Notation v := (vel_of th a1 b1 a2 b2).
Notation v' := (vel_of th a1' b1' a2' b2').

Theorem newton_push : newton -> vx_of a1' a2' = vx_of a1 a2 /\ mass P * (vy v' - vy v) = J1 + J2 /\
  inertia P * (om v' - om v) = J1 * (arm1 P * cos th) + J2 * - (arm2 P * cos th).
Proof.
  intros [K [A1 [B1 [A2 B2]]]]. assert (M := mass_pos P HP). destruct HP as [P1 [P2 P3]].
  assert (E1 : a1' = a1 + K * cos th / m1 P) by (rewrite <- A1; field; lra).
  assert (E2 : b1' = b1 + (J1 + K * sin th) / m1 P) by (rewrite <- B1; field; lra).
  assert (E3 : a2' = a2 + - (K * cos th) / m2 P) by (rewrite <- A2; field; lra).
  assert (E4 : b2' = b2 + (J2 - K * sin th) / m2 P) by (rewrite <- B2; field; lra).
  rewrite E1, E2, E3, E4. unfold vx_of, vel_of, inertia, arm1, arm2, mass in *; simpl.
  split; [field; lra|]. split; field; lra.
Qed.
End Impulses.

(** A push on mass 1 (mass 2) of which the rod is not broken and the energy is kept is the statement's. *)
Theorem newton_push1 s a1 b1 a2 b2 a1' b1' a2' b2' J : 0 <= J -> newton (angle s) a1 b1 a2 b2 a1' b1' a2' b2' J 0 ->
  rigid (angle s) a1 b1 a2 b2 -> rigid (angle s) a1' b1' a2' b2' -> kinetic a1' b1' a2' b2' = kinetic a1 b1 a2 b2 ->
  push1 P s (vel_of (angle s) a1 b1 a2 b2) (vel_of (angle s) a1' b1' a2' b2').
Proof.
  intros HJ HN R R' HE. destruct (newton_push _ _ _ _ _ _ _ _ _ _ _ HN) as [Ex [Ey Eo]].
  rewrite (kinetic_energy (angle s)), (kinetic_energy (angle s) a1 b1), Ex in HE by assumption.
  exists J. repeat split; try assumption; lra.
Qed.
Theorem newton_push2 s a1 b1 a2 b2 a1' b1' a2' b2' J : 0 <= J -> newton (angle s) a1 b1 a2 b2 a1' b1' a2' b2' 0 J ->
  rigid (angle s) a1 b1 a2 b2 -> rigid (angle s) a1' b1' a2' b2' -> kinetic a1' b1' a2' b2' = kinetic a1 b1 a2 b2 ->
  push2 P s (vel_of (angle s) a1 b1 a2 b2) (vel_of (angle s) a1' b1' a2' b2').
Proof.
  intros HJ HN R R' HE. destruct (newton_push _ _ _ _ _ _ _ _ _ _ _ HN) as [Ex [Ey Eo]].
  rewrite (kinetic_energy (angle s)), (kinetic_energy (angle s) a1 b1), Ex in HE by assumption.
  exists J. repeat split; try assumption; lra.
Qed.

(** The other way: the masses of a dumbbell that turns at the rate om, moves up at vy and sideways at vx. *)
Definition a1_of vx (s : pos) v := vx - arm1 P * sin (angle s) * om v.
Definition a2_of vx (s : pos) v := vx + arm2 P * sin (angle s) * om v.
Definition moves_by (s : pos) v v' J1 J2 :=
  forall vx, newton (angle s) (a1_of vx s v) (w1 P s v) (a2_of vx s v) (w2 P s v)
  (a1_of vx s v') (w1 P s v') (a2_of vx s v') (w2 P s v') J1 J2.
Lemma impulses_move s v v' J1 J2 : mass P * (vy v' - vy v) = J1 + J2 ->
  inertia P * (om v' - om v) = J1 * (arm1 P * cos (angle s)) + J2 * - (arm2 P * cos (angle s)) -> moves_by s v v' J1 J2.
Proof.
  intros Ey Eo vx. assert (M := mass_pos P HP). assert (I := inertia_pos P HP).
  assert (E1 : vy v' = vy v + (J1 + J2) / mass P) by (rewrite <- Ey; field; lra).
  assert (E2 : om v' = om v + (J1 * (arm1 P * cos (angle s)) + J2 * - (arm2 P * cos (angle s))) / inertia P)
    by (rewrite <- Eo; field; lra).
  exists ((m1 P * J2 - m2 P * J1) / mass P * sin (angle s)).
  unfold a1_of, a2_of, w1, w2. rewrite E1, E2, (inertia_eq P HP). unfold arm1, arm2, mass in *.
  assert (HS : cos (angle s) * cos (angle s) = 1 - sin (angle s) * sin (angle s))
    by (generalize (sin2_cos2 (angle s)); unfold Rsqr; lra).
  set (c := cos (angle s)) in *. set (S := sin (angle s)) in *. destruct HP as [P1 [P2 P3]].
  split; [field; lra|]. split; [|split; [field; lra|]]; apply Rminus_diag_uniq.
  - transitivity ((J1 * m2 P - J2 * m1 P) / (m1 P + m2 P) * (c * c - (1 - S * S))); [field; lra | rewrite HS; ring].
  - transitivity (- ((J1 * m2 P - J2 * m1 P) / (m1 P + m2 P)) * (c * c - (1 - S * S))); [field; lra | rewrite HS; ring].
Qed.
Theorem push1_newton s v v' : push1 P s v v' -> exists J, 0 <= J /\ moves_by s v v' J 0.
Proof. intros [J [HJ [Ey [Eo _]]]]. exists J. split; [exact HJ|]. apply impulses_move; lra. Qed.
Theorem push2_newton s v v' : push2 P s v v' -> exists J, 0 <= J /\ moves_by s v v' 0 J.
Proof. intros [J [HJ [Ey [Eo _]]]]. exists J. split; [exact HJ|]. apply impulses_move; lra. Qed.
End Newton.
