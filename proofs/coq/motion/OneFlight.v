(** One flight: out of a state from which no mass goes down through the floor, the free flight goes on for ever, or it
    comes to a collision, or to a corner (both masses on the floor). L0, claim.md (trajectory).

    above_floor, corner == a state of the floor or above; both masses on the floor
    leaves, hits        == no mass goes down through the floor; a mass comes in
    one_flight          == what comes of a free flight *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics RealInduction Existence.
Local Open Scope R_scope.

(** Heights along a flight. *)
Definition height_at (h v A a w t : R) := h + v * t + A * sin (a + w * t).
Lemma sin_lipschitz x y : Rabs (sin y - sin x) <= Rabs (y - x).
Proof.
  destruct (MVT_gen sin x y cos) as [t [Ht E]]. { intros; auto_derive; [easy|ring]. } { intros; reg. }
  rewrite E, Rabs_mult. assert (Rabs (cos t) <= 1) by (apply Rabs_le, COS_bound).
  assert (0 <= Rabs (y - x)) by apply Rabs_pos.
  assert (Rabs (cos t) * Rabs (y - x) <= 1 * Rabs (y - x)) by (apply Rmult_le_compat_r; assumption). lra.
Qed.
Lemma height_at_lipschitz h v A a w t t' : 0 <= A ->
  Rabs (height_at h v A a w t' - height_at h v A a w t) <= (Rabs v + A * Rabs w) * Rabs (t' - t).
Proof.
  intros HA. unfold height_at.
  replace (h + v * t' + A * sin (a + w * t') - (h + v * t + A * sin (a + w * t)))
    with (v * (t' - t) + A * (sin (a + w * t') - sin (a + w * t))) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _). rewrite !Rabs_mult, (Rabs_pos_eq A HA).
  assert (S := sin_lipschitz (a + w * t) (a + w * t')).
  replace (a + w * t' - (a + w * t)) with (w * (t' - t)) in S by ring. rewrite Rabs_mult in S.
  assert (A * Rabs (sin (a + w * t') - sin (a + w * t)) <= A * (Rabs w * Rabs (t' - t)))
    by (now apply Rmult_le_compat_l). lra.
Qed.
Lemma height_at_open h v A a w m : 0 <= A -> 0 < height_at h v A a w m ->
  exists d, 0 < d /\ forall t, m - d <= t <= m + d -> 0 < height_at h v A a w t.
Proof.
  intros HA HY. set (K := Rabs v + A * Rabs w). assert (HK : 0 <= K).
  { unfold K. assert (0 <= Rabs v) by apply Rabs_pos.
    assert (0 <= A * Rabs w) by (apply Rmult_le_pos; [lra | apply Rabs_pos]). lra. }
  set (d := height_at h v A a w m / (K + 1) / 2).
  assert (Hd : 0 < d) by (unfold d; apply Rdiv_lt_0_compat; [apply Rdiv_lt_0_compat; lra | lra]).
  assert (Ed : d * (2 * (K + 1)) = height_at h v A a w m) by (unfold d; field; lra).
  exists d. split; [exact Hd|]. intros t Ht. assert (L := height_at_lipschitz h v A a w m t HA). fold K in L.
  assert (Rabs (t - m) <= d) by (apply Rabs_le; lra).
  assert (K * Rabs (t - m) <= K * d) by (now apply Rmult_le_compat_l). apply Rabs_le_between in L. lra.
Qed.
Lemma height_at_closed h v A a w m : 0 <= A -> 0 < m -> (forall t, 0 <= t < m -> 0 <= height_at h v A a w t) ->
  0 <= height_at h v A a w m.
Proof.
  intros HA Hm H. apply Rnot_lt_le. intros L. destruct (height_at_open (- h) (- v) A (a + PI) w m HA) as [d [Hd K]].
  { unfold height_at in *. replace (a + PI + w * m) with (a + w * m + PI) by ring. rewrite neg_sin. lra. }
  set (t := Rmax 0 (m - d)). assert (T1 : 0 <= t) by apply Rmax_l. assert (T2 : m - d <= t) by apply Rmax_r.
  assert (T3 : t < m) by (apply Rmax_lub_lt; lra).
  specialize (K t ltac:(lra)). specialize (H t ltac:(lra)). unfold height_at in *.
  replace (a + PI + w * t) with (a + w * t + PI) in K by ring. rewrite neg_sin in K. lra.
Qed.
Lemma height_at_touch h v A a w m : 0 < A -> height_at h v A a w m = 0 -> 0 < h + v * m ->
  0 <= v + A * cos (a + w * m) * w ->
  exists d, 0 < d /\ forall t, m <= t <= m + d -> 0 <= height_at h v A a w t.
Proof.
  intros HA HY Hh Hw. assert (HS : 0 < height_at 0 0 1 (a + PI) w m).
  { unfold height_at in *. replace (a + PI + w * m) with (a + w * m + PI) by ring. rewrite neg_sin.
    apply Rmult_lt_reg_l with A; lra. }
  destruct (height_at_open 0 0 1 (a + PI) w m ltac:(lra) HS) as [d [Hd K]]. exists d. split; [exact Hd|]. intros t Ht.
  assert (Neg : forall s, m <= s <= m + d -> sin (a + w * s) < 0).
  { intros s Hs. specialize (K s ltac:(lra)). unfold height_at in K.
    replace (a + PI + w * s) with (a + w * s + PI) in K by ring. rewrite neg_sin in K. lra. }
  destruct (MVT_gen (height_at h v A a w) m t (fun s => v + A * cos (a + w * s) * w)) as [x [Hx E]].
  { intros; unfold height_at; auto_derive; [easy|ring]. } { intros; unfold height_at; reg. }
  rewrite Rmin_left, Rmax_right in Hx by lra.
  destruct (MVT_gen (fun s => v + A * cos (a + w * s) * w) m x (fun s => - (A * sin (a + w * s) * w * w)))
    as [y [Hy F]].
  { intros; auto_derive; [easy|ring]. } { intros; reg. }
  rewrite Rmin_left, Rmax_right in Hy by lra. assert (N := Neg y ltac:(lra)).
  assert (0 <= A * - sin (a + w * y)) by (apply Rmult_le_pos; lra). assert (0 <= w * w) by apply Rle_0_sqr.
  assert (0 <= A * - sin (a + w * y) * (w * w) * (x - m)) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra | lra]).
  assert (D : 0 <= v + A * cos (a + w * x) * w) by lra.
  assert (0 <= (v + A * cos (a + w * x) * w) * (t - m)) by (apply Rmult_le_pos; lra). lra.
Qed.

Section Step.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.
Definition above_floor (s : pos) := 0 < height s /\ 0 <= y1 P s /\ 0 <= y2 P s.
Definition leaves s v := (y1 P s = 0 -> 0 <= w1 P s v) /\ (y2 P s = 0 -> 0 <= w2 P s v).
Definition hits s v := (y1 P s = 0 /\ w1 P s v < 0) \/ (y2 P s = 0 /\ w2 P s v < 0).
Definition corner (s : pos) := y1 P s = 0 /\ y2 P s = 0.

Lemma line_y2 s v t : y2 P (line s v t) = height_at (height s) (vy v) (arm2 P) (angle s + PI) (om v) t.
Proof. unfold y2, height_at, line; simpl. replace (angle s + PI + om v * t) with (angle s + om v * t + PI) by ring.
rewrite neg_sin. ring. Qed.
Lemma line_height s v t : height (line s v t) = height_at (height s) (vy v) 0 0 0 t.
Proof. unfold height_at, line; simpl. ring. Qed.

Lemma above_floor_next s v m : above_floor (line s v m) -> leaves (line s v m) v ->
  exists d, 0 < d /\ forall t, m <= t <= m + d -> above_floor (line s v t).
Proof.
  intros [H0 [H1 H2]] [L1 L2]. assert (A1 := arm1_pos P HP). assert (A2 := arm2_pos P HP).
  destruct (height_at_open (height s) (vy v) 0 0 0 m ltac:(lra)) as [d0 [D0 K0]]. { now rewrite <- line_height. }
  assert (N1 : exists d, 0 < d /\ forall t, m <= t <= m + d -> 0 <= y1 P (line s v t)).
  { destruct (Rle_lt_or_eq_dec _ _ H1) as [K|K].
    - destruct (height_at_open (height s) (vy v) (arm1 P) (angle s) (om v) m ltac:(lra) K) as [d [Hd Q]]. exists d.
      split; [exact Hd|]. intros t Ht. left. apply Q. lra.
    - destruct (height_at_touch (height s) (vy v) (arm1 P) (angle s) (om v) m A1 (eq_sym K) H0 (L1 (eq_sym K)))
        as [d [Hd Q]]. exists d. split; [exact Hd | exact Q]. }
  assert (N2 : exists d, 0 < d /\ forall t, m <= t <= m + d -> 0 <= y2 P (line s v t)).
  { rewrite line_y2 in H2, L2. destruct (Rle_lt_or_eq_dec _ _ H2) as [K|K].
    - destruct (height_at_open _ _ _ _ _ m (Rlt_le _ _ A2) K) as [d [Hd Q]]. exists d. split; [exact Hd|]. intros t Ht.
      rewrite line_y2. left. apply Q. lra.
    - destruct (height_at_touch (height s) (vy v) (arm2 P) (angle s + PI) (om v) m A2 (eq_sym K) H0) as [d [Hd Q]].
      + specialize (L2 (eq_sym K)). unfold w2 in L2. simpl in L2.
        replace (angle s + PI + om v * m) with (angle s + om v * m + PI) by ring. rewrite neg_cos. lra.
      + exists d. split; [exact Hd|]. intros t Ht. rewrite line_y2. now apply Q. }
  destruct N1 as [d1 [D1 K1]]. destruct N2 as [d2 [D2 K2]]. set (d := Rmin d0 (Rmin d1 d2)).
  assert (E0 : d <= d0) by apply Rmin_l. assert (E1 : d <= Rmin d1 d2) by apply Rmin_r.
  assert (E2 : Rmin d1 d2 <= d1) by apply Rmin_l. assert (E3 : Rmin d1 d2 <= d2) by apply Rmin_r.
  exists d. split; [unfold d; repeat apply Rmin_pos; assumption|]. intros t Ht.
  split; [rewrite line_height; apply K0; lra|]. split; [apply K1; lra | apply K2; lra].
Qed.
Lemma flat_corner s : height s = 0 -> 0 <= y1 P s -> 0 <= y2 P s -> corner s.
Proof.
  intros H0 H1 H2. assert (A1 := arm1_pos P HP). assert (A2 := arm2_pos P HP). unfold corner, y1, y2 in *.
  rewrite H0 in *.
  assert (S : sin (angle s) = 0).
  { apply Rle_antisym; [apply Rmult_le_reg_l with (arm2 P); lra | apply Rmult_le_reg_l with (arm1 P); lra]. }
  rewrite S. split; ring.
Qed.

Lemma above_floor_limit s v m : 0 < m -> (forall t, 0 <= t < m -> above_floor (line s v t)) ->
  above_floor (line s v m) \/ corner (line s v m).
Proof.
  intros M0 Hb. assert (A1 := arm1_pos P HP). assert (A2 := arm2_pos P HP).
  assert (C1 : 0 <= y1 P (line s v m)).
  { apply (height_at_closed (height s) (vy v) (arm1 P) (angle s) (om v)); [lra | exact M0|]. intros t Ht.
    apply (Hb t Ht). }
  assert (C2 : 0 <= y2 P (line s v m)).
  { rewrite line_y2. apply height_at_closed; [lra | exact M0|]. intros t Ht. rewrite <- line_y2. apply (Hb t Ht). }
  assert (C0 : 0 <= height (line s v m)).
  { rewrite line_height. apply height_at_closed; [lra | exact M0|]. intros t Ht. rewrite <- line_height. left.
    apply (Hb t Ht). }
  destruct (Rle_lt_or_eq_dec _ _ C0) as [K0|K0]; [left | right; now apply flat_corner]. split; [exact K0 | now split].
Qed.
Theorem one_flight s v : above_floor s -> leaves s v -> (forall t, 0 <= t -> above_floor (line s v t)) \/
  exists T, 0 < T /\ (forall t, 0 <= t < T -> above_floor (line s v t)) /\
  (corner (line s v T) \/ (above_floor (line s v T) /\ hits (line s v T) v)).
Proof.
  intros Hs Hl. apply Classical_Prop.NNPP. intros No. apply No. left. intros B HB.
  apply (real_induction (fun t => above_floor (line s v t)) 0 B); [now rewrite line_0 | | |lra].
  - intros m M Hb. destruct (above_floor_next s v m (Hb m ltac:(lra))) as [d [Hd K]].
    + destruct (Req_dec m 0) as [->|N]; [now rewrite line_0|].
      split; intros Z; apply Rnot_lt_le; intros L; apply No; right; exists m; (split; [lra|]);
        (split; [intros t Ht; apply Hb; lra|]); right; (split; [apply Hb; lra|]); [left | right]; now split.
    + exists d. split; [exact Hd|]. intros t Ht. apply K. lra.
  - intros m M Hb. destruct (above_floor_limit s v m ltac:(lra) Hb) as [K|K]; [exact K|]. exfalso. apply No. right.
    exists m. split; [lra|]. split; [exact Hb | now left].
Qed.
End Step.
