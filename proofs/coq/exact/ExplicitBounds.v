(** L30 (a), (b) and Theorem 3 (c): k collisions of the top orbit need q > 1 + pi k (k - 1), of the corner orbit q >
    pi k^2; so N(q) < 2 + 2 sqrt(q/pi). The rates of L27 are not needed, only that slopes grow by 2 r (L5 (f)).

    L30a_top, L30b_corner == how large q is if an orbit has k + 1 collisions
    theorem_3c            == N(q) < 2 + 2 sqrt (q/pi) *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics Ray Orbits ExactMaximum CriticalRatios.
Local Open Scope R_scope.

(** The height of flight n + 1 is below 1, and above this. *)
Lemma heights_add_up n : forall c k r, 0 < r -> 0 <= k -> coll r (S n) c k ->
  c + PI * (INR n * k + r * (INR n * (INR n + 1))) < 1.
Proof.
  assert (HPI := PI2_3_2). induction n as [|n IH]; intros c k r Hr Hk [x [Hx H]]; assert (X := Hx);
    destruct X as [X1 [X2 X3]];
    assert (K0 : 0 <= k * x) by (apply Rmult_le_pos; lra).
  - simpl INR. assert (sin x < 1) by (rewrite <- sin_PI2; apply sin_increasing_1; lra). lra.
  - destruct H as [H|[HD H]]; [discriminate|]. cbv zeta in H. assert (W := cos_pos _ X1).
  destruct (COS_bound x) as [_ W1].
    assert (G := next_slope_grows (cos x) k r ltac:(lra) Hr HD). set (k' := next_slope (cos x) k r) in *.
    assert (K' : 0 <= k') by lra. specialize (IH _ k' r Hr K' H). rewrite S_INR. set (m := INR n) in *.
    assert (M : 0 <= m) by apply pos_INR. assert (0 <= k' * x) by (apply Rmult_le_pos; lra).
    assert ((m + 1) * (k + 2 * r) <= (m + 1) * k') by (apply Rmult_le_compat_l; lra).
    assert (E : PI * ((m + 1) * k + r * ((m + 1) * (m + 1 + 1))) <= PI * (k' + (m * k' + r * (m * (m + 1))))).
    { apply Rmult_le_compat_l; lra. }
    lra.
Qed.

Theorem L30a_top q k : 1 <= q -> coll (/ q) (S k) (/ q) 0 -> 1 + PI * (INR k * (INR k + 1)) < q.
Proof.
  intros Hq H. destruct (inv_ratio q Hq) as [R0 R1]. assert (HK := Rle_refl 0).
  assert (A := heights_add_up k _ _ _ R0 HK H).
  apply Rmult_lt_reg_r with (/ q); [exact R0|]. rewrite Rinv_r by lra. lra.
Qed.
Theorem L30b_corner q k : 1 <= q -> coll (/ q) (S k) (PI * / q) (/ q) -> PI * (INR (S k) * INR (S k)) < q.
Proof.
  intros Hq H. destruct (inv_ratio q Hq) as [R0 R1]. assert (HK := Rlt_le _ _ R0).
  assert (A := heights_add_up k _ _ _ R0 HK H).
  apply Rmult_lt_reg_r with (/ q); [exact R0|]. rewrite Rinv_r by lra. rewrite S_INR. lra.
Qed.
(** The same for the critical ratios. *)
Theorem critical_odd_bound k qc : critical (1 + 2 * S k) qc -> 1 + PI * (INR k * (INR k + 1)) <= qc.
Proof.
  intros [Hq Hc]. apply Rnot_lt_le. intros L. set (b := 1 + PI * (INR k * (INR k + 1))) in *.
  assert (K := proj2 (Hc b ltac:(lra)) L). apply (odd_by_top b (S k) ltac:(lra)) in K. apply L30a_top in K; [|lra].
  fold b in K. lra.
Qed.
Theorem critical_even_bound k qc : critical (2 + 2 * S k) qc -> PI * (INR (S k) * INR (S k)) <= qc.
Proof.
  intros [Hq Hc]. apply Rnot_lt_le. intros L. set (b := PI * (INR (S k) * INR (S k))) in *.
  assert (K := proj2 (Hc b ltac:(lra)) L). apply (even_by_corner b (S k) ltac:(lra)) in K.
  apply L30b_corner in K; [|lra]. fold b in K. lra.
Qed.

(** Theorem 3 (c). *)
Lemma below_sqrt x y : 0 <= x -> x * x < y -> x < sqrt y.
Proof. intros Hx H. rewrite <- (sqrt_square x Hx). apply sqrt_lt_1; nra. Qed.
Theorem theorem_3c q n : 1 <= q -> N_star q n -> INR n < 2 + 2 * sqrt (q / PI).
Proof.
  intros Hq Hn. assert (HPI := PI2_3_2). assert (HPI4 := PI_4). destruct (theorem_1 q Hq) as [k0 [k1 [T [C [K HN]]]]].
  apply HN in Hn. subst n. rewrite !plus_INR. simpl (INR 2).
  assert (S0 : 0 < sqrt (q / PI)) by (apply sqrt_lt_R0; apply Rdiv_lt_0_compat; lra).
  assert (D : forall z, PI * z < q -> z < q / PI).
  { intros z Hz. apply Rmult_lt_reg_l with PI; [lra|]. replace (PI * (q / PI)) with q by (field; lra). exact Hz. }
  destruct K as [->| ->].
  - destruct k1 as [|k]; [simpl INR; lra|]. assert (B := D _ (L30b_corner q k Hq (proj1 C))).
    assert (INR (S k) < sqrt (q / PI)) by (apply below_sqrt; [apply pos_INR | exact B]). lra.
  - assert (A := L30a_top q k1 Hq (proj1 T)). assert (P := pos_INR k1). rewrite S_INR.
    assert (INR k1 + 1/2 < sqrt (q / PI)); [|lra]. apply below_sqrt; [lra|]. apply D. nra.
Qed.
