(** Theorem 3 (b): N(q) = ceil(pi/gamma) exactly for 1 <= q <= 3 and for q_c(4) < q <= 3 + 2 sqrt 2. As N(q) <=
    ceil(pi/gamma) always, the two are equal if and only if pi <= N(q) gamma. *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Trigonometry Physics Ray Maximum Orbits ExactMaximum Monotone CriticalRatios
  PublishedBound.
From Dumbbell Require Import ExplicitBounds.
Local Open Scope R_scope.

(** Multiples of the angle whose tangent is h, h^2 = r. *)
Section Angles.
Variables h r : R.
Hypothesis H0 : 0 < h.
Hypothesis HH : h * h = r.

Lemma double : r < 1 -> 2 * atan h = atan (2 * h / (1 - r)).
Proof. intros Hr. replace (2 * atan h) with (atan h + atan h) by ring. rewrite atan_sum by lra. rewrite HH. f_equal.
field. lra. Qed.
Lemma ratio_below a b c : 0 < b -> a < c * b -> a / b < c.
Proof. intros Hb H. apply Rmult_lt_reg_r with b; [exact Hb|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r;
  lra. Qed.
Lemma ratio_nonneg a b : 0 <= a -> 0 < b -> 0 <= a / b.
Proof. intros Ha Hb. apply Rmult_le_pos; [exact Ha | left; now apply Rinv_0_lt_compat]. Qed.
Lemma triple : 3 * r < 1 -> 3 * atan h = atan (h * (3 - r) / (1 - 3 * r)).
Proof.
  intros Hr. assert (R0 : 0 < r) by nra. replace (3 * atan h) with (atan h + 2 * atan h) by ring.
  rewrite double by lra.
  assert (E : h * (2 * h / (1 - r)) = 2 * r / (1 - r)) by (rewrite <- HH; field; lra).
  rewrite atan_sum; [|lra | apply ratio_nonneg; lra | rewrite E; apply ratio_below; lra].
  f_equal. rewrite E. field. lra.
Qed.
Lemma three_below : 3 * r < 1 -> 3 * atan h < PI/2.
Proof. intros Hr. rewrite triple by exact Hr. apply atan_bound. Qed.
Lemma four_below : 2 * h < 1 - r -> 4 * atan h < PI/2.
Proof.
  intros H. assert (Hr : r < 1) by lra. assert (D := double Hr).
  assert (K : 2 * h / (1 - r) < 1) by (apply ratio_below; lra). apply atan_increasing in K. rewrite atan_1 in K. lra.
Qed.
Lemma four_above : r <= 1 -> 1 - r <= 2 * h -> PI/2 <= 4 * atan h.
Proof.
  intros Hr H. destruct (Req_dec r 1) as [E|E].
  - assert (h = 1) by nra. subst h. rewrite atan_1. assert (HPI := PI2_1). lra.
  - assert (D := double ltac:(lra)). assert (K : 1 <= 2 * h / (1 - r)).
    { apply Rmult_le_reg_r with (1 - r); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
    apply atan_mono in K. rewrite atan_1 in K. lra.
Qed.
Lemma five_below : r <= 1055/10000 -> 5 * atan h < PI/2.
Proof.
  intros Hr. assert (R0 : 0 < r) by nra. assert (D := double ltac:(lra)). assert (T := triple ltac:(lra)).
  replace (5 * atan h) with (2 * atan h + 3 * atan h) by ring. rewrite D, T.
  rewrite atan_sum; [apply atan_bound | apply ratio_nonneg; lra | apply ratio_nonneg; [apply Rmult_le_pos|]; lra |].
  replace (2 * h / (1 - r) * (h * (3 - r) / (1 - 3 * r))) with (2 * r * (3 - r) / ((1 - r) * (1 - 3 * r)))
    by (rewrite <- HH in *; field; split; lra).
  apply ratio_below; nra.
Qed.
Lemma six_below : r <= 717/10000 -> 6 * atan h < PI/2.
Proof.
  intros Hr. assert (R0 : 0 < r) by nra. assert (T := triple ltac:(lra)). assert (K : h * (3 - r) / (1 - 3 * r) < 1).
  { apply ratio_below; [lra|]. assert (S : (h * (3 - r)) * (h * (3 - r)) < (1 - 3 * r) * (1 - 3 * r)).
    { replace (h * (3 - r) * (h * (3 - r))) with (r * ((3 - r) * (3 - r))) by (rewrite <- HH; ring). nra. }
    apply Rnot_le_lt. intros L. assert (0 <= h * (3 - r)) by (apply Rmult_le_pos; lra). nra. }
  apply atan_increasing in K. rewrite atan_1 in K. lra.
Qed.
Lemma seven_below : r <= 511/10000 -> 7 * atan h < PI/2.
Proof.
  intros Hr. assert (R0 : 0 < r) by nra. assert (T := triple ltac:(lra)). assert (X := six_below ltac:(lra)).
  set (S := h * (3 - r) / (1 - 3 * r)) in *. assert (S0 : 0 <= S) by (apply ratio_nonneg; [apply Rmult_le_pos|]; lra).
  assert (SS : S * S = r * ((3 - r) * (3 - r)) / ((1 - 3 * r) * (1 - 3 * r))) by (unfold S; rewrite <- HH in *;
    field; lra).
  assert (S1 : S * S < 1) by (rewrite SS; apply ratio_below; nra).
  assert (hS : h * S = r * (3 - r) / (1 - 3 * r)) by (unfold S; rewrite <- HH in *; field; lra).
  replace (7 * atan h) with (atan h + (atan S + atan S)) by lra. rewrite (atan_sum S S) by lra.
  rewrite atan_sum; [apply atan_bound | lra | apply ratio_nonneg; lra |].
  replace (h * ((S + S) / (1 - S * S))) with (2 * (h * S) / (1 - S * S)) by (field; lra). apply ratio_below; [lra|].
  rewrite hS, SS. apply Rmult_lt_reg_r with ((1 - 3 * r) * (1 - 3 * r)); [nra|].
  replace (2 * (r * (3 - r) / (1 - 3 * r)) * ((1 - 3 * r) * (1 - 3 * r))) with (2 * r * (3 - r) * (1 - 3 * r))
    by (field; lra).
  replace (1 * (1 - r * ((3 - r) * (3 - r)) / ((1 - 3 * r) * (1 - 3 * r))) * ((1 - 3 * r) * (1 - 3 * r)))
    with ((1 - 3 * r) * (1 - 3 * r) - r * ((3 - r) * (3 - r))) by (field; lra). nra.
Qed.
End Angles.

(** Second flights that are too high: by the tangents of the hump at pi/3 and pi/2. *)
Lemma second_too_high c k : 738/1000 <= c -> 211/1000 <= k -> forall x, ~ hit c k x.
Proof.
  intros Hc Hk x [Hx [Hs _]]. assert (HPI := PI_above_3_1). assert (HPI4 := PI_below_3_22).
  assert (T := sin_below_tangent (PI/3) x ltac:(lra) ltac:(lra)). rewrite sin_PI3, cos_PI3 in T.
  assert (R3 := sqrt_sqrt 3 ltac:(lra)). assert (P3 := sqrt_pos 3). assert (L3 : sqrt 3 < 17321/10000) by nra.
  assert (K : 211/1000 * x <= k * x) by (apply Rmult_le_compat_r; lra). destruct (SIN_bound x). lra.
Qed.
Lemma two_hits r c k : 0 < r -> 0 <= k -> coll r 2 c k ->
  exists c' k' x, c + PI * k' <= c' /\ k + 2 * r <= k' /\ hit c' k' x.
Proof.
  intros Hr Hk [x [[X1 [X2 X3]] [H|[HD [y [Hy _]]]]]]; [discriminate|]. assert (W := cos_pos _ X1).
  destruct (COS_bound x) as [_ W1].
  assert (G := next_slope_grows (cos x) k r ltac:(lra) Hr HD). set (k' := next_slope (cos x) k r) in *.
  exists (sin x + k' * (x + PI)), k', y. split; [|split; [exact G | exact Hy]].
  assert (0 <= k * x) by (apply Rmult_le_pos; lra). assert (0 <= k' * x) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma top_two r : 0 < r -> coll r 2 r 0 -> r <= 1055/10000.
Proof.
  intros Hr H. apply Rnot_lt_le. intros L. destruct (two_hits r r 0 Hr ltac:(lra) H) as [c [k [x [A [B Hx]]]]].
  assert (HPI := PI2_3_2). assert (3 * k <= PI * k) by (apply Rmult_le_compat_r; lra).
  apply (second_too_high c k) with x; [lra | lra | exact Hx].
Qed.
Lemma corner_two r : 0 < r -> coll r 2 (PI * r) r -> r <= 717/10000.
Proof.
  intros Hr H. apply Rnot_lt_le. intros L. destruct (two_hits r _ r Hr ltac:(lra) H) as [c [k [x [A [B Hx]]]]].
  assert (HPI := PI2_3_2). assert (3 * k <= PI * k) by (apply Rmult_le_compat_r; lra).
  assert (3 * r <= PI * r) by (apply Rmult_le_compat_r; lra).
  apply (second_too_high c k) with x; [lra | lra | exact Hx].
Qed.

(** With five collisions or more N(q) gamma < pi. *)
Lemma many_not_equal q n : 1 <= q -> N_star q n -> (5 <= n)%nat -> INR n * gamma q < PI /\ 72/10 < q.
Proof.
  intros Hq Hn L. assert (HPI := PI_above_3_1). destruct (theorem_1 q Hq) as [k0 [k1 [T [C [K HN]]]]].
  assert (En := proj1 (HN n) Hn). destruct (inv_ratio q Hq) as [R0 R1]. assert (H0 : 0 < sqrt (/ q))
    by (now apply sqrt_lt_R0).
  assert (HH : sqrt (/ q) * sqrt (/ q) = / q) by (apply sqrt_sqrt; lra). assert (Eq : q * / q = 1) by (field; lra).
  rewrite gamma_half by exact Hq. set (h := sqrt (/ q)) in *.
  assert (T2 : coll (/ q) 2 (/ q) 0) by (apply coll_le with k0; [lia | apply T]).
  assert (A := L30a_top q 1 Hq T2). simpl INR in A. split; [|lra].
  destruct (Nat.le_gt_cases 8 n) as [L8|L8].
  - assert (C3 : coll (/ q) 3 (PI * / q) (/ q)) by (apply coll_le with k1; [lia | apply C]).
    assert (B := L30b_corner q 2 Hq C3). simpl INR in B. assert (N3 := theorem_3c q n Hq Hn).
    assert (Q : 279/10 < q) by lra. set (s := sqrt (q / PI)) in *.
    assert (S0 : 0 < q / PI) by (apply Rdiv_lt_0_compat; lra).
    assert (SS : s * s = q / PI) by (apply sqrt_sqrt; lra). assert (S1 : 0 < s) by (now apply sqrt_lt_R0).
    assert (P1 : (s * h) * (s * h) = / PI).
    { replace (s * h * (s * h)) with ((s * s) * (h * h)) by ring. rewrite SS, HH. field. lra. }
    assert (P2 : / PI < / (31/10)) by (apply Rinv_lt_contravar; lra).
    assert (P3 : 0 < s * h) by (now apply Rmult_lt_0_compat). assert (P4 : s * h < 57/100) by nra.
    assert (H1 : h < 19/100) by nra. assert (AB := atan_moves 0 h ltac:(lra)). rewrite atan_0 in AB.
    assert (P := pos_INR n).
    assert (INR n * (2 * atan h) <= INR n * (2 * h)) by (apply Rmult_le_compat_l; lra).
    assert (INR n * (2 * h) <= (2 + 2 * s) * (2 * h)) by (apply Rmult_le_compat_r; lra). lra.
  - assert (Cases : n = 5%nat \/ n = 6%nat \/ n = 7%nat) by lia. destruct Cases as [E|[E|E]]; rewrite E; simpl INR.
    + assert (X := five_below h (/ q) H0 HH (top_two _ R0 T2)). lra.
    + assert (C2 : coll (/ q) 2 (PI * / q) (/ q)) by (apply coll_le with k1; [lia | apply C]).
      assert (X := six_below h (/ q) H0 HH (corner_two _ R0 C2)). lra.
    + assert (T3 : coll (/ q) 3 (/ q) 0) by (apply coll_le with k0; [lia | apply T]).
      assert (B := L30a_top q 2 Hq T3). simpl INR in B. assert (X := seven_below h (/ q) H0 HH ltac:(nra)). lra.
Qed.

Lemma three_equal q : 1 <= q -> (PI <= 3 * gamma q <-> q <= 3).
Proof.
  intros Hq. destruct (inv_ratio q Hq) as [R0 R1]. assert (H0 : 0 < sqrt (/ q)) by (now apply sqrt_lt_R0).
  assert (HH : sqrt (/ q) * sqrt (/ q) = / q) by (apply sqrt_sqrt; lra). assert (Eq : q * / q = 1) by (field; lra).
  rewrite gamma_half by exact Hq. split; intros H.
  - apply Rnot_lt_le. intros L. assert (X := three_below _ _ H0 HH ltac:(nra)). lra.
  - assert (R3 := sqrt_sqrt 3 ltac:(lra)). assert (P3 := sqrt_lt_R0 3 ltac:(lra)).
    assert (K : 1 / sqrt 3 <= sqrt (/ q)).
    { apply Rmult_le_reg_r with (sqrt 3); [exact P3|]. replace (1 / sqrt 3 * sqrt 3) with 1 by (field; lra).
      rewrite <- sqrt_mult by lra. rewrite <- sqrt_1. apply sqrt_le_1; nra. }
    rewrite <- tan_PI6 in K. apply atan_mono in K. assert (HPI := PI2_1). rewrite atan_tan in K by lra. lra.
Qed.
Lemma four_equal q : 1 <= q -> (PI <= 4 * gamma q <-> q <= 3 + 2 * sqrt 2).
Proof.
  intros Hq. destruct (inv_ratio q Hq) as [R0 R1]. assert (H0 : 0 < sqrt (/ q)) by (now apply sqrt_lt_R0).
  assert (HH : sqrt (/ q) * sqrt (/ q) = / q) by (apply sqrt_sqrt; lra). assert (Eq : q * / q = 1) by (field; lra).
  rewrite gamma_half by exact Hq. set (h := sqrt (/ q)) in *.
  assert (R2 := sqrt_sqrt 2 ltac:(lra)). assert (P2 := sqrt_lt_R0 2 ltac:(lra)).
  assert (E : q * q * ((1 - / q) * (1 - / q)) = (q - 1) * (q - 1)).
  { replace (q * q * ((1 - / q) * (1 - / q))) with ((q - q * / q) * (q - q * / q)) by ring. rewrite Eq. ring. }
  assert (E2 : q * q * (2 * h * (2 * h)) = 4 * q).
  { replace (q * q * (2 * h * (2 * h))) with (4 * q * (q * (h * h))) by ring. rewrite HH, Eq. ring. }
  assert (Q2 : 0 < q * q) by (apply Rmult_lt_0_compat; lra). split; intros H.
  - apply Rnot_lt_le. intros L. assert (K : 4 * q < (q - 1) * (q - 1)) by nra.
    assert (X : 2 * h < 1 - / q).
    { apply Rnot_le_lt. intros M. assert ((1 - / q) * (1 - / q) <= 2 * h * (2 * h)) by (apply Rmult_le_compat; lra).
      assert (q * q * ((1 - / q) * (1 - / q)) <= q * q * (2 * h * (2 * h))) by (apply Rmult_le_compat_l; lra). lra. }
    assert (Y := four_below h (/ q) H0 HH X). lra.
  - assert (X : 1 - / q <= 2 * h).
    { apply Rnot_lt_le. intros M. assert (2 * h * (2 * h) < (1 - / q) * (1 - / q)) by (apply Rmult_le_0_lt_compat;
      lra).
      assert (q * q * (2 * h * (2 * h)) < q * q * ((1 - / q) * (1 - / q))) by (apply Rmult_lt_compat_l; lra).
      assert (4 * q < (q - 1) * (q - 1)) by lra.
      assert ((q - 3) * (q - 3) <= 8); [|lra]. destruct (Rle_or_lt 3 q) as [L|L]; [|nra].
      apply Rle_trans with (2 * sqrt 2 * (2 * sqrt 2)); [apply Rmult_le_compat; lra | lra]. }
    assert (Y := four_above h (/ q) H0 HH R1 X). lra.
Qed.

Lemma equal_iff q n : 1 <= q -> N_star q n -> (is_ceiling (PI / gamma q) n <-> PI <= INR n * gamma q).
Proof.
  intros Hq Hn. assert (G := gamma_pos q Hq). assert (H := N_times_gamma q n Hq Hn).
  assert (E : PI / gamma q * gamma q = PI) by (field; lra). split.
  - intros [_ K]. apply (Rmult_le_compat_r (gamma q)) in K; lra.
  - intros K. split; apply Rmult_lt_reg_r with (gamma q) || apply Rmult_le_reg_r with (gamma q); lra.
Qed.
Theorem theorem_3b q n qc : 1 <= q -> N_star q n -> critical 4 qc ->
  (is_ceiling (PI / gamma q) n <-> q <= 3 \/ qc < q <= 3 + 2 * sqrt 2).
Proof.
  intros Hq Hn Hc. rewrite (equal_iff q n Hq Hn). assert (HPI := PI_above_3_1).
  assert (Four : (4 <= n)%nat <-> qc < q).
  { rewrite <- (proj2 Hc q Hq). split; [intros L; now exists n|]. intros [m [Hm L]].
    rewrite (N_unique q n m ltac:(lra) Hn Hm). exact L. }
  destruct (theorem_1 q Hq) as [k0 [k1 [T [C [K HN]]]]]. assert (En := proj1 (HN n) Hn).
  assert (R2 := sqrt_sqrt 2 ltac:(lra)). assert (P2 := sqrt_lt_R0 2 ltac:(lra)).
  assert (Big : (4 <= n)%nat -> 3 < q).
  { intros L. assert (C1 : coll (/ q) 1 (PI * / q) (/ q)) by (apply coll_le with k1; [lia | apply C]).
    assert (B := L30b_corner q 0 Hq C1). simpl INR in B. lra. }
  assert (Cases : n = 2%nat \/ n = 3%nat \/ n = 4%nat \/ (5 <= n)%nat) by lia.
  destruct Cases as [E|[E|[E|L]]].
  - assert (q = 1).
    { destruct (Req_dec q 1) as [|Ne]; [assumption|]. exfalso. assert (L := proj2 (proj2 critical_3 q Hq) ltac:(lra)).
      destruct L as [m [Hm L]]. rewrite (N_unique q m n ltac:(lra) Hm Hn) in L. lia. }
    subst q n. split; [intros _; left; lra | intros _]. rewrite gamma_half, Rinv_1, sqrt_1, atan_1 by lra.
    rewrite E. simpl INR. lra.
  - rewrite E in *. replace (INR 3) with 3 by (simpl; ring). rewrite three_equal by exact Hq. split; [tauto|].
    intros [H|[H _]]; [exact H|]. apply Four in H. lia.
  - rewrite E in *. replace (INR 4) with 4 by (simpl; ring). rewrite four_equal by exact Hq.
    assert (B := Big ltac:(lia)). assert (F := proj1 Four ltac:(lia)). split; [intros H; right; lra | lra].
  - destruct (many_not_equal q n Hq Hn L) as [A B]. assert (D : sqrt 2 < 15/10) by nra. lra.
Qed.
