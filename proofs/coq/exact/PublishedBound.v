(** Theorem 3 (a): N(q) <= ceil(pi/gamma) for every q >= 1, gamma = pi - 2 atan(sqrt q), so that the published bound
    ceil(pi/gamma) + 1 is attained at no q; with L28 (in the form kappa < 1/pi) and L31.

    gamma          == pi - 2 atan (sqrt q), the angle of the wedge
    is_ceiling x m == m is the least whole number not below x
    N_times_gamma  == (N(q) - 1) gamma < pi
    theorem_3a     == N(q) <= ceil (pi/gamma) *)
From Coq Require Import Reals Machin Lra Lia.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics Ray Orbits ExactMaximum.
Local Open Scope R_scope.

(** The angle of the published bound; gamma = 2 atan h with h = 1/sqrt q. *)
Definition gamma (q : R) := PI - 2 * atan (sqrt q).
Definition is_ceiling (x : R) (m : nat) := INR m - 1 < x <= INR m.

Lemma gamma_half q : 1 <= q -> gamma q = 2 * atan (sqrt (/ q)).
Proof.
  intros Hq. assert (S : 0 < sqrt q) by (apply sqrt_lt_R0; lra). unfold gamma.
  rewrite sqrt_inv, (atan_inv (sqrt q) S). field.
Qed.

(** L28: an ascending flight with c >= pi k that collides has k < 1/pi. *)
Lemma L28_flat c k x : 0 <= k -> PI * k <= c -> hit c k x -> PI * k < 1.
Proof.
  intros Hk Hc [Hx [Hs _]]. assert (HPI := PI2_1). assert (0 <= k * x) by (apply Rmult_le_pos; lra).
  assert (sin x < 1); [|lra]. rewrite <- sin_PI2. apply sin_increasing_1; lra.
Qed.

Lemma atan_nonneg x : 0 <= x -> 0 <= atan x < PI/2.
Proof.
  intros H. destruct (atan_bound x). split; [|lra]. destruct (Rle_lt_or_eq_dec 0 x H) as [P|<-];
    [|rewrite atan_0; lra].
  rewrite <- atan_0. left. now apply atan_increasing.
Qed.
Lemma atan_mono x y : x <= y -> atan x <= atan y.
Proof. intros [H|<-]; [left; now apply atan_increasing | apply Rle_refl]. Qed.
Lemma atan_sum a b : 0 <= a -> 0 <= b -> a * b < 1 -> atan a + atan b = atan ((a + b) / (1 - a * b)).
Proof.
  intros Ha Hb Hab. set (s := (a + b) / (1 - a * b)).
  assert (Hs : 0 <= s) by (apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; lra]).
  assert (A := atan_nonneg a Ha). assert (B := atan_nonneg b Hb). assert (S := atan_nonneg s Hs).
  assert (Haa : 0 <= a * a) by apply Rle_0_sqr.
  assert (E : atan_sub s a = b) by (unfold atan_sub, s; field; split; lra).
  symmetry. rewrite <- E. apply atan_sub_correct; rewrite ?E; try lra.
  assert (0 <= s * a) by (apply Rmult_le_pos; lra). lra.
Qed.

(** L31 (a), by the addition theorem at w = 1: a collision turns the slope's angle atan(k/h) by gamma at least. *)
Lemma L31_turn w k r : 0 < w <= 1 -> 0 < r < 1 -> 0 <= k -> 0 < slope_den w k r -> 2 * k < 1 - r ->
  atan (k / sqrt r) + 2 * atan (sqrt r) <= atan (next_slope w k r / sqrt r).
Proof.
  intros Hw Hr Hk HD Hk1. assert (H0 : 0 < sqrt r) by (apply sqrt_lt_R0; lra). assert (HH : sqrt r * sqrt r = r)
    by (apply sqrt_sqrt; lra).
  set (h := sqrt r) in *. assert (H1 : h < 1) by nra. assert (HPI := PI2_1).
  assert (Kw : k < w) by (apply slope_below_wall with r; lra).
  destruct (next_slope_anti_w 1 w k r) as [D1 K1]; try lra.
  assert (T : 2 * atan h = atan (2 * h / (1 - r))).
  { replace (2 * atan h) with (atan h + atan h) by ring. rewrite atan_sum by lra. rewrite HH. f_equal. field. lra. }
  assert (Ek : 0 <= k / h) by (apply Rmult_le_pos; [lra | left; now apply Rinv_0_lt_compat]).
  assert (ET : 0 <= 2 * h / (1 - r)) by (apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; lra]).
  rewrite T, atan_sum; try assumption.
  - apply atan_mono. replace ((k / h + 2 * h / (1 - r)) / (1 - k / h * (2 * h / (1 - r)))) with (next_slope 1 k r / h).
    + unfold Rdiv. apply Rmult_le_compat_r; [left; now apply Rinv_0_lt_compat | exact K1].
    + unfold next_slope, slope_num, slope_den. rewrite <- HH in *. field. repeat split; nra.
  - replace (k / h * (2 * h / (1 - r))) with (2 * k / (1 - r)) by (field; lra).
    apply Rmult_lt_reg_r with (1 - r); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
Qed.

(** L31 (b), for q >= pi: then k < 1/pi < (1 - r)/2, that is, the angle is below pi/2 - gamma. *)
Lemma flat_slope c k r x : 0 < r -> PI * r <= 1 -> 0 <= k -> PI * k <= c -> hit c k x -> r < 1 /\ 2 * k < 1 - r.
Proof.
  intros Hr Hr1 Hk Hc Hx. assert (HPI := PI2_3_2). assert (F := L28_flat c k x Hk Hc Hx).
  assert (3 * r < PI * r) by (apply Rmult_lt_compat_r; lra).
  assert (3 * k <= PI * k) by (apply Rmult_le_compat_r; lra). lra.
Qed.
Lemma flat_angle c k r x : 0 < r -> PI * r <= 1 -> 0 <= k -> PI * k <= c -> hit c k x ->
  atan (k / sqrt r) + 2 * atan (sqrt r) < PI/2.
Proof.
  intros Hr Hr1 Hk Hc Hx. destruct (flat_slope c k r x Hr Hr1 Hk Hc Hx) as [R1 K1].
  assert (H0 : 0 < sqrt r) by (apply sqrt_lt_R0; lra). assert (HH : sqrt r * sqrt r = r) by (apply sqrt_sqrt; lra).
  set (h := sqrt r) in *. assert (H1 : h < 1) by nra.
  assert (Ek : 0 <= k / h) by (apply Rmult_le_pos; [lra | left; now apply Rinv_0_lt_compat]).
  assert (ET : 0 <= 2 * h / (1 - r)) by (apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; lra]).
  replace (2 * atan h) with (atan (2 * h / (1 - r))).
  - rewrite atan_sum; try assumption; [apply atan_bound|].
    replace (k / h * (2 * h / (1 - r))) with (2 * k / (1 - r)) by (field; lra).
    apply Rmult_lt_reg_r with (1 - r); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
  - replace (2 * atan h) with (atan h + atan h) by ring. rewrite atan_sum by lra. rewrite HH. f_equal. field. lra.
Qed.

(** Each collision needs the angle to be below pi/2 - gamma; so n of them from the angle of k take n gamma. *)
Theorem angle_budget n : forall c k r, 0 < r -> PI * r <= 1 -> 0 <= k -> PI * k <= c -> coll r (S n) c k ->
  atan (k / sqrt r) + 2 * atan (sqrt r) * INR (S n) < PI/2.
Proof.
  induction n as [|n IH]; intros c k r Hr Hr1 Hk Hc [x [Hx H]].
  - simpl INR. rewrite Rmult_1_r. now apply (flat_angle c k r x).
  - destruct H as [H|[HD H]]; [discriminate|]. cbv zeta in H. assert (HPI := PI2_3_2).
    destruct (flat_slope c k r x Hr Hr1 Hk Hc Hx) as [R1 K1]. assert (X := Hx). destruct X as [X1 _].
    assert (W := cos_pos _ X1). destruct (COS_bound x) as [_ W1].
    assert (T := L31_turn (cos x) k r (conj W W1) (conj Hr R1) Hk HD K1).
    assert (G := next_slope_grows (cos x) k r ltac:(lra) Hr HD). assert (K' : 0 <= next_slope (cos x) k r) by lra.
    assert (S0 : 0 <= sin x) by (apply sin_ge_0; lra). assert (0 <= next_slope (cos x) k r * x)
      by (apply Rmult_le_pos; lra).
    assert (C' : PI * next_slope (cos x) k r <= sin x + next_slope (cos x) k r * (x + PI)) by lra.
    specialize (IH _ _ r Hr Hr1 K' C' H). rewrite S_INR. lra.
Qed.

Lemma pi_inv q : PI <= q -> PI * / q <= 1.
Proof. intros Hq. assert (HPI := PI2_3_2). replace 1 with (q * / q) by (field; lra).
apply Rmult_le_compat_r; [|exact Hq]. left; apply Rinv_0_lt_compat; lra. Qed.
Lemma top_budget q k : PI <= q -> top_orbit q k -> gamma q * INR k < PI/2.
Proof.
  intros Hq [H _]. assert (HPI := PI2_3_2). rewrite gamma_half by lra. destruct k as [|k]; [simpl INR; lra|].
  assert (R0 : 0 < / q) by (apply Rinv_0_lt_compat; lra).
  assert (B := angle_budget k (/ q) 0 (/ q) R0 (pi_inv q Hq) ltac:(lra) ltac:(lra) H).
  unfold Rdiv at 1 in B. rewrite Rmult_0_l, atan_0 in B. lra.
Qed.
Lemma corner_budget q k : PI <= q -> corner_orbit q k -> gamma q / 2 + gamma q * INR k < PI/2.
Proof.
  intros Hq [H _]. assert (HPI := PI2_3_2). rewrite gamma_half by lra.
  assert (R0 : 0 < / q) by (apply Rinv_0_lt_compat; lra).
  destruct k as [|k]; [simpl INR; assert (A := atan_bound (sqrt (/ q))); lra|].
  assert (B := angle_budget k (PI * / q) (/ q) (/ q) R0 (pi_inv q Hq) ltac:(lra) ltac:(lra) H).
  assert (S : 0 < sqrt (/ q)) by (now apply sqrt_lt_R0).
  replace (/ q / sqrt (/ q)) with (sqrt (/ q)) in B by (rewrite <- (sqrt_sqrt (/ q)) at 2 by lra; field; lra). lra.
Qed.

(** For q < pi the corner orbit does not collide, and the top orbit once at most. *)
Lemma corner_none q k : 1 <= q -> q < PI -> corner_orbit q k -> k = O.
Proof.
  intros Hq Hq2 [H _]. destruct k as [|k]; [reflexivity|exfalso]. destruct H as [x [Hx _]].
  assert (R0 : 0 < / q) by (apply Rinv_0_lt_compat; lra).
  assert (F := L28_flat (PI * / q) (/ q) x ltac:(lra) ltac:(lra) Hx).
  assert (E : q * / q = 1) by (field; lra). assert (q * / q < PI * / q) by (apply Rmult_lt_compat_r; lra). lra.
Qed.

(** pi/gamma > N(q) - 1. *)
Theorem N_times_gamma q n : 1 <= q -> N_star q n -> (INR n - 1) * gamma q < PI.
Proof.
  intros Hq Hn. assert (HPI := PI2_3_2). destruct (theorem_1 q Hq) as [k0 [k1 [T [C [K HN]]]]]. apply HN in Hn.
  subst n.
  rewrite !plus_INR. simpl (INR 2). destruct (Rle_or_lt PI q) as [L|L].
  - assert (A := top_budget q k0 L T). assert (B := corner_budget q k1 L C).
  destruct K as [->| ->]; rewrite ?S_INR in *; lra.
  - assert (k1 = O) by (now apply (corner_none q)). subst k1. destruct (inv_ratio q Hq) as [R0 R1].
    assert (S0 : 0 < sqrt (/ q)) by (now apply sqrt_lt_R0). rewrite gamma_half by exact Hq.
    destruct K as [->| ->]; simpl INR.
    + assert (A := atan_bound (sqrt (/ q))). lra.
    + assert (R2 : / q < 1).
      { destruct T as [T _]. apply coll_le with (m := 1%nat) in T; [|lia]. destruct T as [x [[Hx [Hs _]] _]].
        assert (sin x < 1) by (rewrite <- sin_PI2; apply sin_increasing_1; lra). lra. }
      assert (S1 : sqrt (/ q) < 1) by (rewrite <- sqrt_1; apply sqrt_lt_1; lra).
      assert (A := atan_increasing _ _ S1). rewrite atan_1 in A. lra.
Qed.
Theorem gamma_pos q : 1 <= q -> 0 < gamma q.
Proof.
  intros Hq. rewrite gamma_half by exact Hq. assert (R0 : 0 < / q) by (apply Rinv_0_lt_compat; lra).
  assert (S0 : 0 < sqrt (/ q)) by (now apply sqrt_lt_R0). assert (A := atan_increasing _ _ S0). rewrite atan_0 in A.
  lra.
Qed.

(** Theorem 3 (a). *)
Theorem theorem_3a q n m : 1 <= q -> N_star q n -> is_ceiling (PI / gamma q) m -> (n <= m)%nat.
Proof.
  intros Hq Hn [_ Hm]. assert (G := gamma_pos q Hq). assert (H := N_times_gamma q n Hq Hn).
  assert (K : INR n < INR (m + 1)).
  { rewrite plus_INR. simpl (INR 1). apply Rmult_lt_reg_r with (gamma q); [exact G|].
    assert (PI / gamma q * gamma q <= INR m * gamma q) by (apply Rmult_le_compat_r; lra).
    replace (PI / gamma q * gamma q) with PI in * by (field; lra). lra. }
  apply INR_lt in K. lia.
Qed.
Corollary published_bound_never_attained q m : 1 <= q -> is_ceiling (PI / gamma q) m -> ~ N_star q (m + 1).
Proof. intros Hq Hm H. assert (K := theorem_3a q _ m Hq H Hm). lia. Qed.
