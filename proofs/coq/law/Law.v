(** The law for every mass ratio: Theorem B of law.md, from the conditions (C1) to (C11), which LawStatement.v states.

    late_delta == 0 < delta_N < c0 q^(-1/4) <= 0.007 for N >= 903
    law        == the law, and its second half *)
From Coq Require Import Reals Lra Lia.
From Dumbbell Require Import CriticalRatios LawStatement Cubes TheoremB TheoremA.
Local Open Scope R_scope.

Lemma late_delta N q : steps -> layer -> bulk -> end_of_orbit -> (903 <= N)%nat -> critical N q ->
  0 < delta N q < law_constant * quarter q /\ law_constant * quarter q <= 0.007.
Proof.
  intros HS HL HB HE HN Hc. destruct (theorem_A N q HS HL HB HE HN Hc) as [_ A]. split; [exact A|].
  destruct (A_positive q (late_enough N q HS HN Hc)) as [_ Q]. destruct c0_value as [C1 C2].
  assert (Q0 : 0 < quarter q) by (apply Rinv_0_lt_compat, sqrt_lt_R0, sqrt_lt_R0; destruct Hc; lra).
  apply Rle_trans with (0.22 * 0.0318); [apply Rmult_le_compat|]; lra.
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
