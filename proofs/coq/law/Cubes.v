(** The sum of the cubes (sqrt n - sqrt (n - 1))^3 (L55 of law.md).

    cube_is                 == a cube is that of the difference
    cubes_converge          == their sum converges
    tail_above, tail_below  == L55 (c): what is left of the sum after M + 1 terms
    sum_below_series        == no partial sum exceeds it
    Series_value, k0_value  == decimals of it and of k0 *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Dumbbell Require Import LawStatement Differences.
Local Open Scope R_scope.

Lemma cube_is n : cube n = difference (INR (S n)) ^ 3.
Proof. unfold cube, difference. now replace (INR (S n) - 1) with (INR n) by (rewrite S_INR; ring). Qed.

(** L55 (c): a cube beside a difference of two inverse roots, below and above. *)
Lemma cube_above n : / (4 * sqrt (INR (S n))) - / (4 * sqrt (INR (S (S n)))) <= cube n.
Proof.
  unfold cube. assert (P0 := pos_INR n). rewrite !S_INR. set (x := INR n) in *.
  destruct (root_step (x + 1) ltac:(lra)) as [E P]. unfold difference in E.
  replace (x + 1 - 1) with x in * by ring. rewrite E.
  set (a := sqrt x) in *. set (b := sqrt (x + 1)) in *. set (c := sqrt (x + 1 + 1)).
  assert (A : 0 <= a) by apply sqrt_pos. assert (B : 0 < b) by (apply sqrt_lt_R0; lra).
  assert (C : b < c) by (apply sqrt_lt_1; lra). assert (AB : a < b) by (apply sqrt_lt_1; lra).
  assert (Ec : c * c - b * b = 1) by (unfold b, c; rewrite !sqrt_sqrt by lra; ring).
  assert (L : / (4 * b) - / (4 * c) = / (4 * (b * c * (b + c)))).
  { replace (/ (4 * b) - / (4 * c)) with ((c * c - b * b) / (4 * (b * c * (b + c)))) by (field; lra). rewrite Ec.
    field. lra. }
  rewrite L, pow_inv by lra. apply Rinv_le_contravar; [apply pow_lt; lra|].
  assert ((a + b) ^ 3 <= (b + b) ^ 3) by (apply pow_incr; lra).
  assert (b * b * b <= b * b * c) by (apply Rmult_le_compat_l; [apply Rlt_le, Rmult_lt_0_compat|]; lra).
  assert (b * b * c <= b * c * c)
    by (replace (b * b * c) with (b * c * b) by ring; apply Rmult_le_compat_l; [apply Rlt_le, Rmult_lt_0_compat|];
      lra).
  simpl in *. lra.
Qed.
Lemma cube_below n : cube (S (S n)) <= / (4 * sqrt (INR (S n))) - / (4 * sqrt (INR (S (S n)))).
Proof.
  unfold cube. assert (P0 := pos_INR n). rewrite !S_INR. set (x := INR n) in *.
  destruct (root_step (x + 1 + 1 + 1) ltac:(lra)) as [E P]. unfold difference in E.
  replace (x + 1 + 1 + 1 - 1) with (x + 1 + 1) in * by ring.
  rewrite E.
  set (a := sqrt (x + 1)) in *. set (b := sqrt (x + 1 + 1)) in *. set (c := sqrt (x + 1 + 1 + 1)) in *.
  assert (A : 0 < a) by (apply sqrt_lt_R0; lra). assert (AB : a < b) by (apply sqrt_lt_1; lra).
  assert (BC : b < c) by (apply sqrt_lt_1; lra).
  assert (Ea : b * b - a * a = 1) by (unfold a, b; rewrite !sqrt_sqrt by lra; ring).
  assert (L : / (4 * a) - / (4 * b) = / (4 * (a * b * (a + b)))).
  { replace (/ (4 * a) - / (4 * b)) with ((b * b - a * a) / (4 * (a * b * (a + b)))) by (field; lra). rewrite Ea.
    field. lra. }
  rewrite L, pow_inv by lra. apply Rinv_le_contravar; [repeat apply Rmult_lt_0_compat; lra|].
  assert ((b + b) ^ 3 <= (c + b) ^ 3) by (apply pow_incr; lra).
  assert (a * b * (a + b) <= b * b * (b + b))
    by (apply Rmult_le_compat; try lra; [apply Rmult_le_pos; lra | apply Rmult_le_compat_r; lra]).
  simpl in *. lra.
Qed.
Lemma cube_pos n : 0 <= cube n.
Proof.
  unfold cube. apply pow_le. assert (sqrt (INR n) <= sqrt (INR (S n))); [|lra]. apply sqrt_le_1; try apply pos_INR.
  rewrite S_INR. lra.
Qed.
Lemma sums_between M n : sum_n cube M + / (4 * sqrt (INR (S (S M)))) - / (4 * sqrt (INR (S (S (M + n))))) <=
  sum_n cube (M + n) /\
  ((1 <= M)%nat -> sum_n cube (M + n) <= sum_n cube M + / (4 * sqrt (INR M)) - / (4 * sqrt (INR (M + n)))).
Proof.
  induction n as [|n [IH1 IH2]]; [rewrite Nat.add_0_r; split; intros; lra|]. rewrite Nat.add_succ_r, sum_Sn.
  change plus with Rplus. split.
  - assert (A := cube_above (S (M + n))). lra.
  - intros HM. specialize (IH2 HM). destruct M as [|M]; [lia|]. simpl Nat.add in *. assert (A := cube_below (M + n)).
    lra.
Qed.
Lemma inverse_roots_vanish M : is_lim_seq (fun n => / (4 * sqrt (INR (S (M + n))))) 0.
Proof.
  apply (is_lim_seq_le_le (fun _ => 0) _ (fun n => / sqrt (INR (S n)))).
  - intros n. assert (P : 0 < sqrt (INR (S n))) by (apply sqrt_lt_R0, lt_0_INR; lia).
    assert (Q : sqrt (INR (S n)) <= sqrt (INR (S (M + n))))
      by (apply sqrt_le_1; try apply pos_INR; apply le_INR; lia).
    split; [left; apply Rinv_0_lt_compat; lra | apply Rinv_le_contravar; lra].
  - apply is_lim_seq_const.
  - apply (is_lim_seq_inv (fun n => sqrt (INR (S n))) p_infty); [|discriminate].
    apply filterlim_comp with (G := Rbar_locally p_infty); [|apply filterlim_sqrt_p].
    apply (is_lim_seq_incr_1 INR). apply is_lim_seq_INR.
Qed.
Lemma cubes_converge : ex_series cube.
Proof.
  assert (B : ex_finite_lim_seq (sum_n cube)).
  { apply (ex_finite_lim_seq_incr _ (sum_n cube 1 + / (4 * sqrt (INR 1)))).
    - intros n. rewrite sum_Sn. change plus with Rplus. assert (H := cube_pos (S n)). lra.
    - intros n. destruct (sums_between 1 n) as [_ H]. specialize (H (le_n _)).
      assert (K : sum_n cube n <= sum_n cube (1 + n)) by (simpl; rewrite sum_Sn; change plus with Rplus;
        assert (H0 := cube_pos (S n)); lra).
      assert (0 < / (4 * sqrt (INR (1 + n)))) by (apply Rinv_0_lt_compat, Rmult_lt_0_compat;
        [lra | apply sqrt_lt_R0, lt_0_INR; lia]).
      lra. }
  destruct B as [l Hl]. now exists l.
Qed.
Lemma sums_to_series M : is_lim_seq (fun n => sum_n cube (M + n)) (Series cube).
Proof.
  apply is_lim_seq_ext with (fun n => sum_n cube (n + M)); [intros n; f_equal; lia|].
  apply (is_lim_seq_incr_n (sum_n cube)). exact (Series_correct _ cubes_converge).
Qed.
Theorem tail_above M : sum_n cube M + / (4 * sqrt (INR (S (S M)))) <= Series cube.
Proof.
  assert (K := is_lim_seq_le _ _ _ _ (fun n => proj1 (sums_between M n))
    (is_lim_seq_minus' _ _ _ _ (is_lim_seq_const _) (inverse_roots_vanish (S M))) (sums_to_series M)).
  change (sum_n cube M + / (4 * sqrt (INR (S (S M)))) - 0 <= Series cube) in K. lra.
Qed.
Theorem tail_below M : (1 <= M)%nat -> Series cube <= sum_n cube M + / (4 * sqrt (INR M)).
Proof.
  intros HM. destruct M as [|M]; [lia|].
  assert (K := is_lim_seq_le _ _ _ _ (fun n => proj2 (sums_between (S M) n) HM)
    (sums_to_series (S M)) (is_lim_seq_minus' _ _ _ _ (is_lim_seq_const _) (inverse_roots_vanish M))).
  change (Series cube <= sum_n cube (S M) + / (4 * sqrt (INR (S M))) - 0) in K. lra.
Qed.
Lemma sum_below_series M : sum_n cube M <= Series cube.
Proof.
  assert (H := tail_above M). assert (0 < / (4 * sqrt (INR (S (S M))))); [|lra].
  apply Rinv_0_lt_compat, Rmult_lt_0_compat; [lra | apply sqrt_lt_R0, lt_0_INR; lia].
Qed.

Lemma k0_value : 0.0825 <= step_constant <= 0.0826.
Proof. unfold step_constant, Rpower. split; interval. Qed.
Lemma Series_value : 1.07 <= Series cube <= 1.33.
Proof.
  assert (H := tail_below 1 (le_n _)). assert (K := sum_below_series 1). rewrite sum_Sn, sum_O in H, K.
  change plus with Rplus in *. unfold cube in *. simpl INR in *. split.
  - apply Rle_trans with (2 := K). rewrite sqrt_0, sqrt_1. interval.
  - apply Rle_trans with (1 := H). rewrite sqrt_0, sqrt_1. interval.
Qed.
