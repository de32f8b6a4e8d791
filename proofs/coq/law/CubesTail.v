(** The sum of the cubes to nine decimals from a thousand of them (L55 (c) of law.md, sharper): what is left of it from
    the cube M on is 1/(4 sqrt M), or less by a share 1/(16 M^2) at most. So c0 is known as well as Theorem A asks up to
    q = 10^36.

    rest, share       == 1/(4 sqrt M); 1 - 1/(16 M^2)
    tail_close        == that
    step_constant_is  == k0 without a power that is no root *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import LawStatement Cubes.
Local Open Scope R_scope.

Definition rest (n : nat) := / (4 * sqrt (INR (S n))).
Definition share (n : nat) := 1 - / (16 * (INR (S n) * INR (S n))).

(** With a and b the roots of n + 1 and n + 2 a cube is 1/(a + b)^3, and the rests differ by 1/(4 a b (a + b)). *)
Lemma cube_close n : (rest n - rest (S n)) * share n <= cube (S n) <= rest n - rest (S n).
Proof.
  unfold rest, share, cube. assert (P := pos_INR n). rewrite !S_INR. set (x := INR n + 1).
  assert (X : 1 <= x) by (unfold x; lra).
  set (a := sqrt x). set (b := sqrt (x + 1)).
  assert (A : 1 <= a) by (unfold a; rewrite <- sqrt_1; apply sqrt_le_1; lra).
  assert (B : a < b) by (apply sqrt_lt_1; lra). assert (A2 : a * a = x) by (apply sqrt_sqrt; lra).
  assert (B2 : b * b = x + 1) by (apply sqrt_sqrt; lra). assert (D : (b - a) * (a + b) = 1) by lra.
  assert (E : b - a = / (a + b)) by (apply Rmult_eq_reg_r with (a + b); [rewrite D; field; lra | lra]).
  assert (K : / (4 * a) - / (4 * b) = / (a + b) * / (4 * (a * b))) by (rewrite <- E; field; lra).
  rewrite K, E, pow_inv. assert (AB : 0 < a * b) by (apply Rmult_lt_0_compat; lra).
  assert (S0 : 0 < a + b) by lra. assert (I : 0 < / (a + b)) by now apply Rinv_0_lt_compat.
  assert (Q : (a + b) * (a + b) = 4 * (a * b) + / (a + b) * / (a + b)) by (rewrite <- E; ring).
  assert (I2 : 0 <= / (a + b) * / (a + b)) by (apply Rmult_le_pos; lra).
  assert (Z : / (a + b) ^ 3 = / (a + b) * / ((a + b) * (a + b))) by (field; lra). rewrite Z. split.
  - rewrite Rmult_assoc. apply Rmult_le_compat_l; [lra|].
    apply Rmult_le_reg_l with (4 * (a * b)); [lra|]. rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l by lra.
    apply Rmult_le_reg_r with ((a + b) * (a + b)); [apply Rmult_lt_0_compat; lra|].
    rewrite (Rmult_assoc (4 * (a * b))), Rinv_l, Rmult_1_r by (apply Rgt_not_eq, Rmult_lt_0_compat; lra).
    assert (Big : 4 * x <= (a + b) * (a + b)) by (rewrite <- A2; replace (4 * (a * a)) with ((a + a) * (a + a)) by ring;
      apply Rmult_le_compat; lra).
    assert (J : / (a + b) * / (a + b) <= (a + b) * (a + b) * / (16 * (x * x))).
    { apply Rmult_le_reg_r with (16 * (x * x)); [apply Rmult_lt_0_compat; [lra | apply Rmult_lt_0_compat; lra]|].
      rewrite (Rmult_assoc ((a + b) * (a + b))), Rinv_l, Rmult_1_r by (apply Rgt_not_eq; nra).
      apply Rmult_le_reg_l with ((a + b) * (a + b)); [apply Rmult_lt_0_compat; lra|].
      replace ((a + b) * (a + b) * (/ (a + b) * / (a + b) * (16 * (x * x)))) with (4 * x * (4 * x)) by (field; lra).
      apply Rmult_le_compat; lra. }
    lra.
  - apply Rmult_le_compat_l; [lra|]. apply Rinv_le_contravar; lra.
Qed.

Lemma rests_fall n : 0 <= rest n - rest (S n).
Proof.
  unfold rest. assert (P : 0 < sqrt (INR (S n))) by (apply sqrt_lt_R0, lt_0_INR; lia).
  assert (Q : sqrt (INR (S n)) <= sqrt (INR (S (S n)))) by (apply sqrt_le_1; try apply pos_INR; apply le_INR; lia).
  assert (/ (4 * sqrt (INR (S (S n)))) <= / (4 * sqrt (INR (S n)))) by (apply Rinv_le_contravar; lra). lra.
Qed.
Lemma shares_grow m n : share m <= share (m + n).
Proof.
  unfold share. assert (A : 1 <= INR (S m)) by (rewrite S_INR; assert (P := pos_INR m); lra).
  assert (B : INR (S m) <= INR (S (m + n))) by (apply le_INR; lia).
  assert (INR (S m) * INR (S m) <= INR (S (m + n)) * INR (S (m + n))) by (apply Rmult_le_compat; lra).
  assert (0 < INR (S m) * INR (S m)) by (apply Rmult_lt_0_compat; lra).
  assert (/ (16 * (INR (S (m + n)) * INR (S (m + n)))) <= / (16 * (INR (S m) * INR (S m)))) by (apply
    Rinv_le_contravar; lra).
  lra.
Qed.
Lemma sums_close m n : sum_n cube m + (rest m - rest (m + n)) * share m <= sum_n cube (m + n) <=
  sum_n cube m + (rest m - rest (m + n)).
Proof.
  induction n as [|n IH]; [rewrite Nat.add_0_r; lra|]. rewrite Nat.add_succ_r, sum_Sn. change plus with Rplus.
  assert (C := cube_close (m + n)).
  assert (L : (rest (m + n) - rest (S (m + n))) * share m <= (rest (m + n) - rest (S (m + n))) * share (m + n)).
  { apply Rmult_le_compat_l; [apply rests_fall | apply shares_grow]. }
  lra.
Qed.
Theorem tail_close m : sum_n cube m + rest m * share m <= Series cube <= sum_n cube m + rest m.
Proof.
  assert (V : is_lim_seq (fun n => rest (m + n)) 0) by exact (inverse_roots_vanish m). split.
  - assert (K := is_lim_seq_le _ _ _ _ (fun n => proj1 (sums_close m n)) (is_lim_seq_plus' _ _ _ _ (is_lim_seq_const _)
      (is_lim_seq_mult' _ _ _ _ (is_lim_seq_minus' _ _ _ _ (is_lim_seq_const _) V) (is_lim_seq_const _)))
        (sums_to_series m)).
    change (sum_n cube m + (rest m - 0) * share m <= Series cube) in K. lra.
  - assert (K := is_lim_seq_le _ _ _ _ (fun n => proj2 (sums_close m n)) (sums_to_series m)
      (is_lim_seq_plus' _ _ _ _ (is_lim_seq_const _) (is_lim_seq_minus' _ _ _ _ (is_lim_seq_const _) V))).
    change (Series cube <= sum_n cube m + (rest m - 0)) in K. lra.
Qed.

Lemma step_constant_is : step_constant = / (3 * (sqrt 3 * sqrt (sqrt 3)) * sqrt PI).
Proof.
  unfold step_constant. assert (S3 := sqrt_lt_R0 3 ltac:(lra)). assert (P := sqrt_lt_R0 PI PI_RGT_0).
  assert (S4 := sqrt_lt_R0 _ S3). rewrite Rpower_Ropp. replace (7 / 4) with (1 + (/ 2 + / 2 * / 2)) by field.
  rewrite !Rpower_plus, Rpower_1, <- Rpower_mult, !Rpower_sqrt by lra. field. lra.
Qed.
