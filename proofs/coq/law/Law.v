(** The law for every mass ratio: Theorem B of law.md, from the conditions (C1) to (C11), which LawStatement.v states.

    late_delta == 0 < delta_N < c0 q^(-1/4) <= 0.007 for N >= 903
    law        == the law, and its second half *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import CriticalRatios LawStatement Cubes TheoremB TheoremA.
Local Open Scope R_scope.

Lemma late_delta N q : steps -> layer -> bulk -> end_of_orbit -> (903 <= N)%nat -> critical N q ->
  0 < delta N q < law_constant * quarter q /\ law_constant * quarter q <= 0.007.
Proof.
  intros HS HL HB HE HN Hc. assert (Hq := late_enough N q HS HN Hc). assert (A := theorem_A N q HS HL HB HE HN Hc).
  unfold law_with_logarithm in A. cbv zeta in A. rewrite quarter_square in A by lra. apply Rabs_le_between in A.
  destruct (A_positive q Hq) as [P Q]. assert (K : 0.378 <= constant_of N <= 0.496)
    by (unfold constant_of; destruct (Nat.even N); lra).
  assert (S : 1000 <= sqrt q) by (rewrite <- (sqrt_square 1000) by lra; apply sqrt_le_1; lra).
  assert (I : 0 < / sqrt q) by (apply Rinv_0_lt_compat; lra).
  assert (Q0 : 0 < quarter q) by (apply Rinv_0_lt_compat, sqrt_lt_R0; lra). destruct c0_value as [C1 C2].
  assert (L : 0 <= ln q) by (rewrite <- ln_1; apply ln_le; lra).
  assert (G : 0 <= log_constant * / sqrt q * ln q).
  { assert (0 <= log_constant * / sqrt q) by (apply Rmult_le_pos; [destruct log_constant_value|]; lra).
    apply Rmult_le_pos; lra. }
  assert (K1 : 0.378 * / sqrt q <= constant_of N * / sqrt q <= 0.496 * / sqrt q)
    by (split; apply Rmult_le_compat_r; lra).
  assert (K2 : quarter q * / sqrt q <= 0.032 * / sqrt q) by (apply Rmult_le_compat_r; lra). split; [lra|].
  apply Rle_trans with (0.22 * 0.0318); [apply Rmult_le_compat; try lra|lra].
  apply Rle_trans with (/ 31.5); [|lra]. apply Rinv_le_contravar; [lra|].
  rewrite <- (sqrt_square 31.5) by lra. apply sqrt_le_1; lra.
Qed.

Theorem law : steps -> layer -> bulk -> end_of_orbit -> the_law /\ law_everywhere.
Proof.
  intros HS HL HB HE. split.
  - apply law_from_delta. intros N q HN Hc. destruct (Nat.le_gt_cases N 902) as [K|K].
    + now apply (steps_delta N q HS ltac:(lia) Hc).
    + now apply (late_delta N q HS HL HB HE).
  - apply everywhere_from_delta. intros N q HN Hc. destruct (Nat.le_gt_cases N 902) as [K|K].
    + now apply (steps_delta N q HS ltac:(lia) Hc).
    + destruct (late_delta N q HS HL HB HE ltac:(lia) Hc). lra.
Qed.
