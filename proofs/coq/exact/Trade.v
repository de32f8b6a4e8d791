(** A ray that is lower and flatter may have a larger r: a gap d in height and slope is worth a fixed part of d in
    the mass ratio, the same for all rays. It replaces the derivatives of L27 and the limits of L29 in the proof
    that the critical ratios increase strictly.

    trade == a ray that is lower and flatter by d has as many collisions at a ratio r + p *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Ray.
Local Open Scope R_scope.

(** Slopes spread: the next slope grows with the slope at a rate of at least 1. *)
Lemma slopes_spread w k k' r : 0 <= w -> 0 < r -> 0 <= k -> k <= k' -> 0 < slope_den w k' r ->
  next_slope w k r + (k' - k) <= next_slope w k' r.
Proof.
  intros Hw Hr Hk Hkk HD. destruct (next_slope_mono_k w k k' r Hw Hkk HD) as [HD0 _].
  set (A := w * w + r). assert (HA : 0 < A) by (unfold A; nra).
  assert (D1 : slope_den w k r <= A) by (unfold slope_den, A; nra). assert (D2 : slope_den w k' r <= A)
    by (unfold slope_den, A; nra).
  assert (P : 0 < slope_den w k r * slope_den w k' r) by (now apply Rmult_lt_0_compat).
  assert (E : next_slope w k' r - next_slope w k r = (k' - k) * (A * A) / (slope_den w k r * slope_den w k' r)).
  { unfold next_slope.
    replace ((k' - k) * (A * A)) with (slope_num w k' r * slope_den w k r - slope_num w k r * slope_den w k' r)
      by (unfold slope_num, slope_den, A; ring). field. split; lra. }
  assert (Q : slope_den w k r * slope_den w k' r <= A * A) by (apply Rmult_le_compat; lra).
  assert (k' - k <= (k' - k) * (A * A) / (slope_den w k r * slope_den w k' r)); [|lra].
  apply Rmult_le_reg_r with (slope_den w k r * slope_den w k' r); [exact P|].
  unfold Rdiv. rewrite (Rmult_assoc _ (/ _)), Rinv_l, Rmult_1_r by lra. apply Rmult_le_compat_l; lra.
Qed.

(** Half of a gap d in the slope is worth p <= d r / 4 in r. *)
Lemma slope_for_ratio w k r d p : 0 < w <= 1 -> 0 < r -> 0 <= k -> 0 < d -> 0 <= p -> 4 * p <= d * w -> p <= r ->
  0 < slope_den w (k + d/2) r -> 0 < slope_den w k (r + p) /\ next_slope w k (r + p) <= next_slope w (k + d/2) r.
Proof.
  intros Hw Hr Hk Hd Hp Hpd Hpr HD. set (k2 := k + d/2) in *.
  assert (E0 : slope_den w k (r + p) = slope_den w k2 r + (d * w - p)) by (unfold slope_den, k2; field).
  assert (0 < d * w) by (apply Rmult_lt_0_compat; lra). split; [lra|].
  apply frac_le; try lra.
  replace (slope_num w k2 r * slope_den w k (r + p) - slope_num w k (r + p) * slope_den w k2 r) with
    (d/2 * ((w*w + r) * (w*w + r)) - 2 * p * w * ((w - k2) * (w - k2)) - p * (d/2) * slope_den w k2 r)
    by (unfold slope_num, slope_den, k2; field).
  assert (Hk2 : 0 <= k2 < w).
  { split; [unfold k2; lra|]. apply slope_below_wall with r; lra. }
  assert (D2 : slope_den w k2 r <= w * w) by (unfold slope_den; nra).
  assert (I1 : (w - k2) * (w - k2) <= w * w) by (apply Rmult_le_compat; lra).
  assert (W2 : 0 <= w * w) by apply Rle_0_sqr.
  assert (I2 : 2 * p * w * ((w - k2) * (w - k2)) <= d/2 * (w * w * (w * w))).
  { apply Rle_trans with (2 * p * w * (w * w)); [apply Rmult_le_compat_l; [apply Rmult_le_pos|]; lra|].
    replace (2 * p * w * (w * w)) with (4 * p * (w * (w * w) / 2)) by field.
    replace (d/2 * (w * w * (w * w))) with (d * w * (w * (w * w) / 2)) by field.
    apply Rmult_le_compat_r; [|exact Hpd].
    assert (0 <= w * (w * w)) by (apply Rmult_le_pos; lra). lra. }
  assert (I3 : p * (d/2) * slope_den w k2 r <= r * (d/2) * (w * w)).
  { apply Rmult_le_compat; try lra; [apply Rmult_le_pos; lra | apply Rmult_le_compat_r; lra]. }
  replace (d/2 * ((w*w + r) * (w*w + r))) with 
    (d/2 * (w * w * (w * w)) + 2 * (r * (d/2) * (w * w)) + d/2 * (r * r)) by field.
  assert (0 <= r * (d/2) * (w * w)) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra).
  assert (0 <= d/2 * (r * r)) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]). lra.
Qed.

Theorem trade n : forall c k r d p, 0 <= c -> 0 <= k -> 0 < r -> r + p <= 1 -> 0 < d -> 0 <= p ->
  4 * 2 ^ n * p <= d * r ->
  coll r n (c + d) (k + d) -> coll (r + p) n c k.
Proof.
  induction n as [|n IH]; intros c k r d p Hc Hk Hr Hr1 Hd Hp Hpd H; [exact I|]. destruct H as [x' [Hx' Hn]].
  destruct (flight_mono c k (c + d) (k + d) x') as [x [Hx Hxx]]; try lra; [exact Hx'|]. exists x. split; [exact Hx|].
  destruct Hn as [Hn|[HD Hn]]; [now left|right]. cbv zeta in Hn. assert (HPI := PI2_1).
  assert (X := Hx). assert (X' := Hx'). destruct X as [X1 [X2 X3]], X' as [Y1 [Y2 Y3]].
  assert (W := cos_pos _ Y1). destruct (COS_bound x') as [_ W1]. destruct (COS_bound x) as [_ W0].
  assert (C : cos x' <= cos x) by (apply cos_mono; lra). set (w' := cos x') in *. set (w := cos x) in *.
  simpl in Hpd. assert (P2 := pow_R1_Rle 2 n ltac:(lra)). assert (H4 : 4 * p <= d * r) by nra.
  assert (Hwr : r <= w') by (unfold slope_den in HD; nra).
  assert (Hdr : d * r <= d * w') by (apply Rmult_le_compat_l; lra). assert (Hdw : d * r <= 1 * r)
    by (apply Rmult_le_compat_r; lra).
  destruct (next_slope_mono_k w' (k + d/2) (k + d) r) as [HD2 _]; try lra.
  destruct (slope_for_ratio w' k r d p) as [HD3 K1]; try lra.
  assert (K2 := slopes_spread w' (k + d/2) (k + d) r ltac:(lra) Hr ltac:(lra) ltac:(lra) HD).
  destruct (next_slope_anti_w w w' k (r + p)) as [HD4 K3]; try lra. split; [exact HD4|]. cbv zeta.
  destruct (next_domain c k (r + p) x ltac:(lra) ltac:(lra) Hx HD4) as [Q1 Q2]. cbv zeta in Q1, Q2. fold w in Q1, Q2.
  set (k1 := next_slope w k (r + p)) in *. set (K := next_slope w' (k + d) r) in *.
  assert (Kk : k1 + d/2 <= K) by lra.
  assert (S : sin x + (k1 + d/2) * (x + PI) <= sin x' + K * (x' + PI)) by (apply height_mono; lra).
  assert (0 <= d/2 * (x + PI - 1)) by (apply Rmult_le_pos; lra).
  apply (IH _ _ r (d/2) p); try lra. apply (coll_mono n) with (8 := Hn); lra.
Qed.
