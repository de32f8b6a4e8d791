(** The proof of Theorem A in terms of its steps: if the clock T falls by 1 + D at each step of the layer, D lies
    between D0 T (1 - 1.3 U) and D0 T, and T is 1 + e at the end, then e + the sum of D is the sum of the comparison
    function, up to a tail and a logarithm.

    sandwich_above == the upper half
    sandwich_below == the lower half *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import LawStatement Cubes.
Local Open Scope R_scope.

Section Sandwich.
Variables (T D : nat -> R) (m : nat) (e z : R).
Hypothesis He : 0 < e.
Hypothesis Hz : 0 <= z.
Hypothesis Hend : T O = 1 + e.                                            (* steps are counted from the end *)
Hypothesis Hstep : forall j, (j < m)%nat -> T (S j) = T j + 1 + D j.
Hypothesis HD : forall j, (j < m)%nat -> 0 < D j <= D0 z (T (S j)).

Lemma clock_above j : (j <= m)%nat -> INR j + 1 < T j.
Proof.
  induction j as [|j IH]; intros Hj; [rewrite Hend; simpl; lra|].
  rewrite (Hstep j Hj), S_INR. destruct (HD j Hj). assert (K := IH ltac:(lia)). lra.
Qed.
Theorem sandwich_above j : (j <= m)%nat -> T j - (INR j + 1) <= e + z * (sum_n cube j - 1).
Proof.
  induction j as [|j IH]; intros Hj.
  - rewrite Hend, sum_O. unfold cube. simpl. rewrite sqrt_1, sqrt_0. lra.
  - rewrite (Hstep j Hj), sum_Sn, S_INR. change plus with Rplus. destruct (HD j Hj) as [_ U].
    assert (K := IH ltac:(lia)).
    assert (A := clock_above (S j) Hj). rewrite S_INR in A. assert (P := pos_INR j).
    assert (M := D0_falls z (INR (S (S j))) (T (S j)) Hz ltac:(rewrite !S_INR; lra)). rewrite D0_at in M. lra.
Qed.

Variables (U : nat -> R) (v x : R).
Hypothesis Hv : 0 <= v.
Hypothesis Hsum : e + z * (Series cube - 1) <= x.
Hypothesis HL : forall j, (j < m)%nat -> D0 z (T (S j)) * (1 - 1.3 * U j) <= D j.
Hypothesis HU : forall j, (j < m)%nat -> U j <= v * (sqrt (T (S j)) + sqrt (T (S j) - 1)).

(** D0 U is at most z v (sqrt T - sqrt (T - 1))^2. *)
Lemma slope_lost j : (j < m)%nat -> D0 z (T (S j)) * U j <= z * v / (4 * INR (S j)).
Proof.
  intros Hj. assert (A := clock_above (S j) Hj). assert (P := pos_INR j). rewrite S_INR in *. set (t := T (S j)) in *.
  destruct (root_step t ltac:(lra)) as [E Q]. apply Rle_trans with (D0 z t * (v * (sqrt t + sqrt (t - 1)))).
  - apply Rmult_le_compat_l; [apply (D0_falls z 1 t Hz); lra | exact (HU j Hj)].
  - unfold D0. rewrite E.
    replace (z * (/ (sqrt t + sqrt (t - 1))) ^ 3 * (v * (sqrt t + sqrt (t - 1)))) with
      (z * v * / ((sqrt t + sqrt (t - 1)) * (sqrt t + sqrt (t - 1)))) by (field; lra).
    unfold Rdiv. apply Rmult_le_compat_l; [now apply Rmult_le_pos|]. apply Rinv_le_contravar; [lra|].
    assert (S1 : sqrt (t - 1) <= sqrt t) by (apply sqrt_le_1; lra). assert (S0 := sqrt_pos (t - 1)).
    assert (S2 := sqrt_sqrt (t - 1) ltac:(lra)).
    assert (sqrt (t - 1) * sqrt (t - 1) <= sqrt t * sqrt (t - 1)) by (now apply Rmult_le_compat_r).
    assert (S3 := sqrt_sqrt t ltac:(lra)). lra.
Qed.
Definition log_sum (j : nat) := match j with O => 0 | S _ => 1 + ln (INR j) end.
Lemma log_sum_grows j : log_sum j + / INR (S j) <= log_sum (S j).
Proof.
  destruct j as [|j]; [simpl; rewrite ln_1; lra|]. unfold log_sum. assert (P := pos_INR j).
  rewrite (S_INR (S j)). set (n := INR (S j)). assert (N : 0 < n) by (unfold n; rewrite S_INR; lra).
  assert (L : - ln (1 + - / (n + 1)) >= / (n + 1)).
  { assert (0 < / (n + 1) < 1) by (split; [apply Rinv_0_lt_compat; lra | rewrite <- Rinv_1; apply Rinv_lt_contravar;
      lra]).
    assert (K := exp_ineq1_le (- / (n + 1))). apply ln_le in K; [|lra]. rewrite ln_exp in K. lra. }
  replace (1 + - / (n + 1)) with (n * / (n + 1)) in L by (field; lra). rewrite ln_mult, ln_Rinv in L; try lra.
  apply Rinv_0_lt_compat. lra.
Qed.
Theorem sandwich_below j : (j <= m)%nat ->
  z * (sum_n cube j - 1) * (1 - 1.08 * x) - 1.3 * (z * v / 4) * log_sum j <= T j - (INR j + 1) - e.
Proof.
  induction j as [|j IH]; intros Hj.
  - rewrite Hend, sum_O. unfold cube. simpl. rewrite sqrt_1, sqrt_0. lra.
  - rewrite (Hstep j Hj), sum_Sn, S_INR. change plus with Rplus. specialize (IH ltac:(lia)). assert (P := pos_INR j).
    assert (A := clock_above (S j) Hj). assert (B := sandwich_above (S j) Hj). rewrite S_INR in A, B.
    assert (Bs := sum_below_series (S j)).
    assert (z * (sum_n cube (S j) - 1) <= z * (Series cube - 1)) by (apply Rmult_le_compat_l; lra).
    assert (W := slope_lost j Hj). assert (L := HL j Hj).
    assert (V := D0_raised z (INR (S (S j))) (T (S j) - INR (S (S j))) Hz ltac:(rewrite !S_INR;
      lra) ltac:(rewrite !S_INR; lra)).
    replace (INR (S (S j)) + (T (S j) - INR (S (S j)))) with (T (S j)) in V by ring. rewrite D0_at in V.
    assert (C := cube_pos (S j)). assert (Zc : 0 <= z * cube (S j)) by (now apply Rmult_le_pos).
    assert (Q : z * cube (S j) * (1 - 1.08 * x) <= z * cube (S j) * (1 - 1.08 * (T (S j) - INR (S (S j))))).
    { apply Rmult_le_compat_l; [exact Zc|]. rewrite !S_INR. lra. }
    assert (G := log_sum_grows j). assert (ZV : 0 <= 1.3 * (z * v / 4)) by (assert (0 <= z * v)
      by (now apply Rmult_le_pos); lra).
    assert (G' := Rmult_le_compat_l _ _ _ ZV G). replace (z * v / (4 * INR (S j))) with (z * v / 4 * / INR (S j)) in W
      by (field; apply not_0_INR; lia). lra.
Qed.
End Sandwich.
