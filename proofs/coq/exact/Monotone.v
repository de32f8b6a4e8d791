(** Theorem 2 (a): N does not decrease with q, and exceeds every bound; L30 (c).

    N_monotone, N_unbounded == Theorem 2 (a)
    top_mono, corner_mono   == a smaller r takes no collision from the orbits
    L30c_corner             == the corner orbit has n collisions if r is small *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics Ray Orbits ExactMaximum.
Local Open Scope R_scope.

(** A smaller r gives each orbit at least as many collisions. *)
Lemma top_mono r r' n : 0 < r -> r <= r' -> r' <= 1 -> coll r' n r' 0 -> coll r n r 0.
Proof. intros H0 H1 H2 H. apply (coll_mono n) with (8 := H); lra. Qed.
Lemma corner_mono r r' n : 0 < r -> r <= r' -> r' <= 1 -> coll r' n (PI * r') r' -> coll r n (PI * r) r.
Proof.
  intros H0 H1 H2 H. assert (HPI := PI2_1). assert (0 < PI * r) by (apply Rmult_lt_0_compat; lra).
  assert (PI * r <= PI * r') by (apply Rmult_le_compat_l; lra). apply (coll_mono n) with (8 := H); lra.
Qed.
Theorem N_monotone q q' n n' : 1 <= q -> q <= q' -> N_star q n -> N_star q' n' -> (n <= n')%nat.
Proof.
  intros Hq Hqq Hn Hn'. destruct (theorem_1 q Hq) as [k0 [k1 [T [C [_ U]]]]].
  destruct (theorem_1 q' ltac:(lra)) as [k0' [k1' [T' [C' [_ U']]]]]. apply U in Hn. apply U' in Hn'.
  destruct (inv_ratio q Hq) as [R0 R1]. destruct (inv_ratio q' ltac:(lra)) as [R0' R1'].
  assert (Hr : / q' <= / q) by (apply Rinv_le_contravar; lra).
  assert (A := exactly_max _ _ _ _ T' _ (top_mono _ _ _ R0' Hr R1 (proj1 T))).
  assert (B := exactly_max _ _ _ _ C' _ (corner_mono _ _ _ R0' Hr R1 (proj1 C))). lia.
Qed.

(** pi/12 <= tan(pi/12) = 1/(2 + sqrt 3). *)
Lemma PI_below_3_22 : PI < 322/100.
Proof.
  assert (HPI := PI2_1). set (a := PI/12). assert (T := sin_below_tangent a 0 ltac:(unfold a; lra) ltac:(lra)).
  rewrite sin_0 in T. assert (C := cos_gt_0 a ltac:(unfold a; lra) ltac:(unfold a; lra)).
  assert (S2 := sin_2a a). assert (C2 := cos_2a_cos a). replace (2 * a) with (PI/6) in S2, C2 by (unfold a; field).
  rewrite sin_PI6 in S2. rewrite cos_PI6 in C2. assert (R3 := sqrt_sqrt 3 ltac:(lra)). assert (P3 := sqrt_pos 3).
  assert (L3 : 173/100 < sqrt 3) by nra.
  assert (K : a * (cos a * cos a) <= sin a * cos a) by (rewrite <- Rmult_assoc; apply Rmult_le_compat_r; lra).
  replace (cos a * cos a) with ((2 + sqrt 3) / 4) in K by lra. unfold a in *. nra.
Qed.

(** L30 (c): while c, k and r are at most z <= 1/8, a ray collides, and then c and k are at most 23 z. *)
Lemma small_step c k r z : 0 <= c <= z -> 0 <= k <= z -> 0 < r <= z -> z <= 1/8 -> exists x, hit c k x /\
  0 < slope_den (cos x) k r /\ 0 <= next_slope (cos x) k r <= 6 * z /\
  0 <= sin x + next_slope (cos x) k r * (x + PI) <= 23 * z.
Proof.
  intros Hc Hk Hr Hz. assert (HPI := PI2_1). assert (HPI4 := PI_below_3_22).
  assert (C2 : 15/16 <= cos (2 * z)).
  { assert (S := cos_shift 0 (2 * z)). rewrite sin_0, cos_0, Rplus_0_l in S.
    assert (K := Rabs_maj2 (cos (2 * z) - (1 - 2 * z * 0))). nra. }
  assert (S2 : 15/8 * z <= sin (2 * z)).
  { assert (T := sin_below_tangent (2 * z) 0 ltac:(lra) ltac:(lra)). rewrite sin_0 in T. nra. }
  destruct (hit_exists c k (2 * z)) as [x [Hx Hxz]]; [lra | lra | nra |]. exists x. split; [exact Hx|].
  destruct Hx as [X1 [X2 X3]]. assert (W : 15/16 <= cos x) by (apply Rle_trans with (1 := C2), cos_mono; lra).
  destruct (COS_bound x) as [_ W1]. set (w := cos x) in *.
  assert (HD : 1/2 <= slope_den w k r) by (unfold slope_den; nra). split; [lra|].
  assert (W2 : 0 <= w * w <= 1) by nra.
  assert (HN : 0 <= slope_num w k r <= 3 * z).
  { assert (0 <= r * k) by (apply Rmult_le_pos; lra). assert (r * k <= r * w) by (apply Rmult_le_compat_l; lra).
    assert (r * w <= r * 1) by (apply Rmult_le_compat_l; lra). assert (0 <= k * (w * w)) by (apply Rmult_le_pos; lra).
    assert (0 <= r * w) by (apply Rmult_le_pos; lra).
    assert (k * (w * w) <= k * 1) by (apply Rmult_le_compat_l; lra). unfold slope_num. lra. }
  assert (HK : 0 <= next_slope w k r <= 6 * z).
  { unfold next_slope. split; [apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; lra]|].
    apply Rmult_le_reg_r with (slope_den w k r); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    nra. }
  split; [exact HK|]. set (k' := next_slope w k r) in *.
  assert (0 <= sin x) by (apply sin_ge_0; lra). assert (T := sin_below_tangent 0 x ltac:(lra) ltac:(lra)).
  rewrite sin_0, cos_0 in T. assert (0 <= k' * (x + PI)) by (apply Rmult_le_pos; lra).
  assert (k' * (x + PI) <= 6 * z * (1/4 + 322/100)) by (apply mul_mono; lra). lra.
Qed.
Theorem L30c_many_collisions n : forall c k r z, 0 <= c <= z -> 0 <= k <= z -> 0 < r <= z -> 23 ^ n * z <= 1/8 ->
  coll r (S n) c k.
Proof.
  induction n as [|n IH]; intros c k r z Hc Hk Hr Hz.
  - simpl in Hz. destruct (small_step c k r z) as [x [Hx _]]; try lra. exists x. split; [exact Hx | now left].
  - assert (P := pow_R1_Rle 23 n ltac:(lra)). simpl in Hz.
    destruct (small_step c k r z) as [x [Hx [HD [HK HC]]]]; try lra; [nra|].
    exists x. split; [exact Hx|right]. split; [exact HD|]. cbv zeta. apply (IH _ _ r (23 * z)); lra.
Qed.
Theorem L30c_corner n : exists r0, 0 < r0 <= 1 /\ forall r, 0 < r <= r0 -> coll r n (PI * r) r.
Proof.
  assert (HPI := PI2_1). assert (P := pow_R1_Rle 23 n ltac:(lra)). exists (/ (8 * (23 ^ n * PI))).
  assert (D : 1 <= 8 * (23 ^ n * PI)) by nra. split.
  - split; [apply Rinv_0_lt_compat; lra|]. rewrite <- Rinv_1. apply Rinv_le_contravar; lra.
  - intros r Hr. apply coll_le with (S n); [lia|]. assert (K : PI * r <= PI * / (8 * (23 ^ n * PI)))
    by (apply Rmult_le_compat_l; lra).
    assert (0 < PI * r) by (apply Rmult_lt_0_compat; lra).
    apply (L30c_many_collisions n _ _ r (PI * r)); try lra; try nra.
    replace (1/8) with (23 ^ n * (PI * / (8 * (23 ^ n * PI)))) by (field; split; lra). apply Rmult_le_compat_l; lra.
Qed.
Theorem N_unbounded N : exists q0, 1 <= q0 /\ forall q, q0 <= q -> N_at_least q N.
Proof.
  destruct (L30c_corner N) as [r0 [H0 H]]. exists (/ r0).
  assert (Q : 1 <= / r0) by (rewrite <- Rinv_1; apply Rinv_le_contravar; lra). split; [exact Q|].
  intros q Hq. destruct (proj2 (even_by_corner q N ltac:(lra))) as [n [Hn L]].
  - apply H. split; [apply Rinv_0_lt_compat; lra|]. rewrite <- (Rinv_inv r0). apply Rinv_le_contravar; lra.
  - exists n. split; [exact Hn | lia].
Qed.
