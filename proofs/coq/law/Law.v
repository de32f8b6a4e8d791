(** The law for every mass ratio: Theorems A and B of law.md.

    theorem_A  == delta_N for N >= 903, with its logarithm
    late_delta == 0 < delta_N < c0 q^(-1/4) <= 0.007 for N >= 903
    law        == the law, and its second half *)
From Coq Require Import Reals Lra Lia.
From Dumbbell Require Import CriticalRatios LawStatement Cubes TheoremB TheoremA FirstSteps LayerHolds EndHolds.
Local Open Scope R_scope.

Theorem theorem_A N q : (903 <= N)%nat -> critical N q ->
  law_with_logarithm N q /\ 0 < delta N q < law_constant * quarter q.
Proof. exact (TheoremA.theorem_A N q steps_hold layer_holds end_holds). Qed.

Lemma late_delta N q : (903 <= N)%nat -> critical N q ->
  0 < delta N q < law_constant * quarter q /\ law_constant * quarter q <= 0.007.
Proof.
  intros HN Hc. destruct (theorem_A N q HN Hc) as [_ A]. split; [exact A|].
  destruct (A_positive q (late_enough N q steps_hold HN Hc)) as [_ Q]. destruct c0_value as [C1 C2].
  assert (Q0 : 0 < quarter q) by (apply Rinv_0_lt_compat, sqrt_lt_R0, sqrt_lt_R0; destruct Hc; lra).
  apply Rle_trans with (0.22 * 0.0318); [apply Rmult_le_compat|]; lra.
Qed.

Theorem law : the_law /\ law_everywhere.
Proof.
  split.
  - apply law_from_delta. intros N q HN Hc. destruct (Nat.le_gt_cases N 902) as [K|K].
    + now apply (steps_delta N q steps_hold ltac:(lia) Hc).
    + now apply (late_delta N q).
  - apply everywhere_from_delta. intros N q HN Hc. destruct (Nat.le_gt_cases N 902) as [K|K].
    + now apply (steps_delta N q steps_hold ltac:(lia) Hc).
    + destruct (late_delta N q ltac:(lia) Hc). lra.
Qed.
