(** From the motion to flights: between two collisions the dumbbell moves uniformly. In the coordinates (psi, yhat) of
    L0: the reflection law (1) at the two walls, L2 (a), L3 for the motion, contacts.

    r_of, u_of, v_of                         == r = arm2/arm1, psi', yhat'
    on_line, straight_flight                 == between collisions the motion is a straight line
    reflects, L0_reflection1, L0_reflection2 == law (1); a push is law (1), at the slopes slope1 and slope2 of the walls
    floor1, contact1, contact2               == the walls in the coordinates psi, yhat
    L3_steep_no_collision                    == L3 *)
From Coq Require Import Reals Lra.
From Dumbbell Require Import Physics RealInduction.
Local Open Scope R_scope.

Section Flight.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.

Lemma before_unique p t v v' : before p t v -> before p t v' -> v = v'.
Proof.
  intros [e [He H]] [e' [He' H']]. set (d := Rmin e e'). assert (0 < d) by (apply Rmin_pos; assumption).
  assert (d <= e) by apply Rmin_l. assert (d <= e') by apply Rmin_r.
  destruct (H (t - d) ltac:(lra)) as [A B]. destruct (H' (t - d) ltac:(lra)) as [A' B'].
  symmetry. apply vel_eq; apply Rmult_eq_reg_r with d; lra.
Qed.

(** Where there is no collision, the velocity does not change. *)
Lemma no_collision_no_change p t : motion P p -> ~ collision P p t -> exists v, before p t v /\ after p t v.
Proof.
  intros Hm Hn. destruct (law P p Hm t) as [v [v' [Hb [Ha H]]]]. exists v. split; [exact Hb|].
  destruct H as [->|[[H0 Hp]|[H0 Hp]]]; [exact Ha| |].
  - destruct (push_cases P HP _ _ _ Hp) as [->|[_ [j [_ [_ [_ Hw]]]]]]; [exact Ha|]. exfalso. apply Hn. exists v.
    split; [exact Hb|]. left. split; [exact H0|]. unfold w1. lra.
  - destruct (push_cases P HP _ _ _ Hp) as [->|[_ [j [_ [_ [_ Hw]]]]]]; [exact Ha|]. exfalso. apply Hn. exists v.
    split; [exact Hb|]. right. split; [exact H0|]. unfold w2. lra.
Qed.

Definition on_line (p : R -> pos) t0 v s :=
  height (p s) = height (p t0) + vy v * (s - t0) /\ angle (p s) = angle (p t0) + om v * (s - t0).

(** A path that is on the line up to m is on it at m, and comes in with its velocity. *)
Lemma on_line_until p t1 m v w : t1 < m -> (forall s, t1 <= s < m -> on_line p t1 v s) -> before p m w ->
  w = v /\ on_line p t1 v m.
Proof.
  intros Hm H [d [Hd Hb]]. set (d' := Rmin d (m - t1)). assert (D1 : 0 < d') by (apply Rmin_pos; lra).
  assert (D2 : d' <= d) by apply Rmin_l. assert (D3 : d' <= m - t1) by apply Rmin_r.
  destruct (Hb (m - d') ltac:(lra)) as [A1 A2]. destruct (Hb (m - d'/2) ltac:(lra)) as [B1 B2].
  destruct (H (m - d') ltac:(lra)) as [C1 C2]. destruct (H (m - d'/2) ltac:(lra)) as [F1 F2].
  assert (V1 : vy w = vy v) by (apply Rmult_eq_reg_r with (d'/2); lra).
  assert (V2 : om w = om v) by (apply Rmult_eq_reg_r with (d'/2); lra).
  split; [now apply vel_eq|]. split; [rewrite V1 in A1 | rewrite V2 in A2]; lra.
Qed.
Theorem straight_flight p t1 t2 v : motion P p -> after p t1 v -> t1 < t2 ->
  (forall t, t1 < t < t2 -> ~ collision P p t) -> forall s, t1 <= s <= t2 -> on_line p t1 v s.
Proof.
  intros Hm Ha H12 Hfree. apply real_induction.
  - split; ring.
  - intros m M Hm0. assert (Hat : after p m v).
    { destruct (Req_dec m t1) as [->|N]; [exact Ha|].
      destruct (no_collision_no_change p m Hm) as [w [Wb Wa]]; [apply Hfree; lra|].
      destruct (on_line_until p t1 m v w) as [<- _]; try assumption; [lra|]. intros s Hs. apply Hm0. lra. }
    destruct Hat as [d [Hd K]]. exists d. split; [exact Hd|]. intros s Hs. destruct (K s ltac:(lra)) as [G1 G2].
    destruct (Hm0 m ltac:(lra)) as [T1 T2]. split; lra.
  - intros m M Hm0. destruct (law P p Hm m) as [w [_ [Wb _]]].
    now destruct (on_line_until p t1 m v w ltac:(lra) Hm0 Wb).
Qed.

(** L0 (1): the coordinates psi, yhat; u = d psi/dt, v = d yhat/dt; r = m1/m2; a wall of slope t. *)
Definition r_of := m1 P / m2 P.
Definition u_of (v : vel) := om v.
Definition v_of (v : vel) := vy v / arm1 P.
Definition slope1 (s : pos) := sin (psi_of s).
Definition slope2 (s : pos) := - r_of * sin (psi_of s).
Definition reflects (t u v u' v' : R) := exists l, 0 < l /\ u' = u + l * (- t) /\ v' = v + l * r_of /\
  v' - t * u' = - (v - t * u) /\ v - t * u < 0.
Lemma r_arms : arm2 P = r_of * arm1 P.
Proof. destruct HP as [? [? ?]]. assert (0 < mass P) by (apply mass_pos; exact HP). unfold r_of, arm1, arm2.
field. lra. Qed.
Lemma sin_psi s : sin (psi_of s) = - cos (angle s).
Proof. unfold psi_of. rewrite sin_minus, cos_PI2, sin_PI2. ring. Qed.
Lemma r_pos : 0 < r_of.
Proof. destruct HP as [? [? ?]]. now apply Rdiv_lt_0_compat. Qed.
Theorem L0_reflection1 s v v' : push1 P s v v' -> v' = v \/ reflects (slope1 s) (u_of v) (v_of v) (u_of v') (v_of v').
Proof.
  intros H. destruct (push_cases P HP _ _ _ H) as [->|[Hr [j [Hj [Hv [Ho Hw]]]]]]; [now left|right].
  assert (A1 := arm1_pos P HP). assert (R0 := r_pos). assert (E := r_arms). unfold reflects, slope1, u_of, v_of.
  rewrite sin_psi.
  exists (j / arm2 P). rewrite E in *. assert (0 < r_of * arm1 P) by (now apply Rmult_lt_0_compat). repeat split.
  - apply Rdiv_lt_0_compat; assumption.
  - rewrite Ho. field. lra.
  - rewrite Hv. field. lra.
  - apply Rmult_eq_reg_l with (arm1 P); [|lra].
    replace (arm1 P * (vy v' / arm1 P - - cos (angle s) * om v')) with (vy v' + arm1 P * cos (angle s) * om v')
      by (field; lra).
    rewrite Hr. field. lra.
  - apply Rmult_lt_reg_l with (arm1 P); [assumption|].
    replace (arm1 P * (vy v / arm1 P - - cos (angle s) * om v)) with (vy v + arm1 P * cos (angle s) * om v)
      by (field; lra). lra.
Qed.
Theorem L0_reflection2 s v v' : push2 P s v v' -> v' = v \/ reflects (slope2 s) (u_of v) (v_of v) (u_of v') (v_of v').
Proof.
  intros H. destruct (push_cases P HP _ _ _ H) as [->|[Hr [j [Hj [Hv [Ho Hw]]]]]]; [now left|right].
  assert (A1 := arm1_pos P HP). assert (R0 := r_pos). assert (E := r_arms). unfold reflects, slope2, u_of, v_of.
  rewrite sin_psi.
  exists (j / arm2 P). rewrite E in *. assert (0 < r_of * arm1 P) by (now apply Rmult_lt_0_compat). repeat split.
  - apply Rdiv_lt_0_compat; assumption.
  - rewrite Ho. field. lra.
  - rewrite Hv. field. lra.
  - apply Rmult_eq_reg_l with (arm1 P); [|lra].
    replace (arm1 P * (vy v' / arm1 P - - r_of * - cos (angle s) * om v'))
      with (vy v' + - (r_of * arm1 P * cos (angle s)) * om v') by (field; lra).
    rewrite Hr. field. lra.
  - apply Rmult_lt_reg_l with (arm1 P); [assumption|].
    replace (arm1 P * (vy v / arm1 P - - r_of * - cos (angle s) * om v))
      with (vy v + - (r_of * arm1 P * cos (angle s)) * om v) by (field; lra). lra.
Qed.

(** L2 (a). *)
Lemma L2a_v_grows t u v u' v' : reflects t u v u' v' -> v < v'.
Proof. intros [l [Hl [_ [Hv _]]]]. assert (0 < l * r_of) by (apply Rmult_lt_0_compat; [assumption | exact r_pos]).
lra. Qed.

(** L3: a collision needs v < t u, |t| <= 1; so none of a steep ascending flight. *)
Theorem L3_steep_no_collision p t v : r_of <= 1 -> motion P p -> before p t v -> Rabs (u_of v) <= v_of v ->
  ~ collision P p t.
Proof.
  intros Hr Hm Hb Hs [v0 [Hb0 H]]. assert (v0 = v) by (apply before_unique with p t; assumption). subst v0.
  assert (A1 := arm1_pos P HP). assert (E := r_arms). assert (R0 := r_pos). unfold u_of, v_of in Hs.
  assert (K : forall x, -1 <= x <= 1 -> 0 <= vy v / arm1 P + x * om v).
  { intros x Hx. assert (Rabs (x * om v) <= Rabs (om v)).
    { rewrite Rabs_mult. assert (Rabs x <= 1) by (apply Rabs_le; lra). assert (0 <= Rabs (om v)) by apply Rabs_pos.
      assert (Rabs x * Rabs (om v) <= 1 * Rabs (om v)) by (apply Rmult_le_compat_r; assumption). lra. }
    assert (- Rabs (x * om v) <= x * om v). { unfold Rabs. destruct Rcase_abs; lra. } lra. }
  assert (C := COS_bound (angle (p t))).
  destruct H as [[_ H]|[_ H]].
  - unfold w1 in H. assert (K1 := K (cos (angle (p t))) C).
    assert (0 <= arm1 P * (vy v / arm1 P + cos (angle (p t)) * om v)) by (apply Rmult_le_pos; lra).
    replace (arm1 P * (vy v / arm1 P + cos (angle (p t)) * om v)) with (vy v + arm1 P * cos (angle (p t)) * om v) in *
      by (field; lra). lra.
  - unfold w2 in H. assert (Hx : -1 <= - (r_of * cos (angle (p t))) <= 1).
    { assert (r_of * cos (angle (p t)) <= r_of * 1) by (apply Rmult_le_compat_l; lra).
      assert (r_of * -1 <= r_of * cos (angle (p t))) by (apply Rmult_le_compat_l; lra). lra. }
    assert (K1 := K _ Hx).
    assert (0 <= arm1 P * (vy v / arm1 P + - (r_of * cos (angle (p t))) * om v)) by (apply Rmult_le_pos; lra).
    rewrite E in H.
    replace (arm1 P * (vy v / arm1 P + - (r_of * cos (angle (p t))) * om v))
      with (vy v - r_of * arm1 P * cos (angle (p t)) * om v) in * by (field; lra). lra.
Qed.

(** Contacts in the coordinates; psi = - pi/2 - X is X beyond the left corner. *)
Lemma on_line_coords (p : R -> pos) t0 v s : on_line p t0 v s ->
  psi_of (p s) = psi_of (p t0) + u_of v * (s - t0) /\ yhat_of P (p s) = yhat_of P (p t0) + v_of v * (s - t0).
Proof. intros [A B]. assert (A1 := arm1_pos P HP). unfold psi_of, yhat_of, u_of, v_of. rewrite A, B.
split; [ring | field; lra]. Qed.
Lemma floor1 (p : R -> pos) t : motion P p -> - cos (psi_of (p t)) <= yhat_of P (p t).
Proof. intros Hm. assert (A := above1 P p Hm t). assert (A1 := arm1_pos P HP).
destruct (L0_heights P (p t) HP) as [E _]. rewrite E in A.
  assert (0 <= yhat_of P (p t) + cos (psi_of (p t))) by (apply Rmult_le_reg_l with (arm1 P); lra). lra. Qed.
Lemma contact1 (p : R -> pos) t : y1 P (p t) = 0 -> yhat_of P (p t) = - cos (psi_of (p t)).
Proof. intros A. assert (A1 := arm1_pos P HP). destruct (L0_heights P (p t) HP) as [E _]. rewrite E in A.
apply Rmult_integral in A. lra. Qed.
Lemma contact2 (p : R -> pos) t : y2 P (p t) = 0 -> yhat_of P (p t) = r_of * cos (psi_of (p t)).
Proof. intros A. assert (A1 := arm1_pos P HP). destruct (L0_heights P (p t) HP) as [_ E]. rewrite E in A.
apply Rmult_integral in A. unfold r_of. lra. Qed.
Lemma cos_left X : cos (- (PI/2) - X) = - sin X.
Proof. rewrite cos_minus, cos_neg, sin_neg, cos_PI2, sin_PI2. ring. Qed.
Lemma sin_left X : sin (- (PI/2) - X) = - cos X.
Proof. rewrite sin_minus, cos_neg, sin_neg, cos_PI2, sin_PI2. ring. Qed.
End Flight.

