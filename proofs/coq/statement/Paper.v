(** That the statement is the source paper's: its collision law (4) of the mass m1, and its boundaries (2a) to (2c) of
    the floor. The paper has a rod of length 1, and measures the height in units of sqrt (inertia / mass). *)
From Coq Require Import Reals Lra.
From Dumbbell Require Import Signs Physics.
Local Open Scope R_scope.

Section Paper.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.
Hypothesis Hl : ell P = 1.
Definition beta1 := m1 P / mass P.
Definition beta2 := m2 P / mass P.
Lemma betas : 0 < beta1 /\ 0 < beta2 /\ beta1 + beta2 = 1 /\ arm1 P = beta2 /\ arm2 P = beta1.
Proof.
  assert (M := mass_pos P HP). unfold beta1, beta2, arm1, arm2, mass in *. destruct HP as [H1 [H2 _]]. rewrite Hl.
  repeat split; try pos; field; lra.
Qed.

(** (4): the velocity after a collision of m1. *)
Definition law_4 phi v := let D := beta1 + beta2 * (cos phi * cos phi) in
  {| vy := vy v * (-1 + 2 * beta2 * (cos phi * cos phi) / D) - om v * (2 * beta1 * beta2 * cos phi / D);
     om := om v * (1 - 2 * beta2 * (cos phi * cos phi) / D) - vy v * (2 * cos phi / D) |}.
Theorem push_is_law_4 s v v' : w1 P s v < 0 -> v' <> v -> (push1 P s v v' <-> v' = law_4 (angle s) v).
Proof.
  intros Hw Hn. destruct betas as [B1 [B2 [_ [A1 A2]]]]. assert (M := mass_pos P HP). assert (I := inertia_eq P HP).
  unfold w1 in Hw. unfold law_4. rewrite A1 in Hw. set (c := cos (angle s)) in *.
  assert (C : 0 <= beta2 * (c * c)) by pos. assert (D : 0 < beta1 + beta2 * (c * c)) by lra. split.
  - intros H. destruct (push_cases P HP _ _ _ H) as [K|[K [j [_ [Jv [Jo _]]]]]]; [contradiction|].
    rewrite A1, A2 in *. fold c in K, Jo. rewrite Jv, Jo in K.
    assert (E : j = - 2 * beta1 * (vy v + beta2 * c * om v) / (beta1 + beta2 * (c * c))).
    { apply Rmult_eq_reg_r with ((beta1 + beta2 * (c * c)) / beta1).
      - transitivity (vy v + j + beta2 * c * (om v + j * (beta2 * c / (beta2 * beta1))) - (vy v + beta2 * c * om v));
          [field; lra|]. rewrite K. field. lra.
      - apply Rgt_not_eq, Rdiv_lt_0_compat; lra. }
    apply vel_eq; simpl; [rewrite Jv | rewrite Jo]; rewrite E; field; lra.
  - intros ->. unfold push1, push, energy. simpl. rewrite I, A1, A2. fold c.
    exists (mass P * (2 * beta1 * - (vy v + beta2 * c * om v) / (beta1 + beta2 * (c * c)))).
    split; [|split; [|split]]; [|field; lra..].
    apply Rmult_le_pos; [lra|]. left. apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra.
Qed.

(** The height in the paper's units. *)
Variable s : pos.
Variable Y : R.
Hypothesis HY : height s = sqrt (inertia P / mass P) * Y.
Lemma heights_in_units : exists u, 0 < u /\ y1 P s = u * (Y - - sqrt (beta2 / beta1) * sin (angle s)) /\
  y2 P s = u * (Y - sqrt (beta1 / beta2) * sin (angle s)).
Proof.
  destruct betas as [B1 [B2 [_ [A1 A2]]]]. assert (M := mass_pos P HP). exists (sqrt beta1 * sqrt beta2).
  assert (R1 : 0 < sqrt beta1) by pos. assert (R2 : 0 < sqrt beta2) by pos. assert (S1 := sqrt_sqrt beta1 ltac:(lra)).
  assert (S2 := sqrt_sqrt beta2 ltac:(lra)). unfold y1, y2. rewrite HY, (inertia_eq P HP), A1, A2.
  replace (mass P * (beta2 * beta1) / mass P) with (beta1 * beta2) by (field; lra).
  rewrite sqrt_mult, !sqrt_div_alt by lra. set (x := sqrt beta1) in *. set (y := sqrt beta2) in *. rewrite <- S1, <- S2.
  split; [pos|]. split; field; lra.
Qed.
(** (2a): where m1 touches the floor. (2b): where m2 does. *)
Theorem boundary_2a : y1 P s = 0 <-> Y = - sqrt (beta2 / beta1) * sin (angle s).
Proof.
  destruct heights_in_units as [u [U [E _]]]. rewrite E. split; [|intros ->; ring].
  intros H. apply Rmult_integral in H. lra.
Qed.
Theorem boundary_2b : y2 P s = 0 <-> Y = sqrt (beta1 / beta2) * sin (angle s).
Proof.
  destruct heights_in_units as [u [U [_ E]]]. rewrite E. split; [|intros ->; ring].
  intros H. apply Rmult_integral in H. lra.
Qed.
(** (2c): no mass is below the floor. *)
Theorem boundary_2c : 0 <= y1 P s /\ 0 <= y2 P s <->
  Rmax (- sqrt (beta2 / beta1) * sin (angle s)) (sqrt (beta1 / beta2) * sin (angle s)) <= Y.
Proof.
  destruct heights_in_units as [u [U [E1 E2]]]. rewrite E1, E2. split.
  - intros [L1 L2]. apply Rmax_lub; apply Rnot_lt_le; intros K.
    + assert (0 < u * (- sqrt (beta2 / beta1) * sin (angle s) - Y)) by pos. lra.
    + assert (0 < u * (sqrt (beta1 / beta2) * sin (angle s) - Y)) by pos. lra.
  - intros L. assert (K1 := Rle_trans _ _ _ (Rmax_l _ _) L). assert (K2 := Rle_trans _ _ _ (Rmax_r _ _) L). split; pos.
Qed.
End Paper.
