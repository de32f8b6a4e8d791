(** The layer in Theorem A, in terms of its steps: if the clock T falls by 1 + D at each, D lies between the bounds that
    (C6) and (C7) give (z = k0 s, y = h/Delta, g = 5/(3 pi)), and T is 1 + e at the end, then e + the sum of D is the
    sum of the comparison function, a logarithm, and small terms, with P = 1 - 1/(j + 1), the sum of all 1/(n (n - 1)).

    clock_above       == T > j + 1 at j steps from the end
    sandwich_above    == T <= j + 1 + e + the sum of the cubes
    logarithm_above   == what is lost by the logarithm, at least
    logarithm_below   == at most *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import LawStatement Differences Cubes.
Local Open Scope R_scope.

Section Sandwich.
Variables (T D : nat -> R) (m : nat) (e z : R).
Hypothesis He : 0 < e.
Hypothesis Hz : 0 <= z.
Hypothesis Hend : T O = 1 + e.                                            (* steps are counted from the end *)
Hypothesis Hstep : forall j, (j < m)%nat -> T (S j) = T j + 1 + D j.
Let Delta j := difference (T (S j)).
Hypothesis HD : forall j, (j < m)%nat -> 0 < D j <= z * Delta j ^ 3.

Lemma clock_above j : (j <= m)%nat -> INR j + 1 < T j.
Proof.
  induction j as [|j IH]; intros Hj; [rewrite Hend; simpl; lra|].
  rewrite (Hstep j Hj), S_INR. destruct (HD j Hj). assert (K := IH ltac:(lia)). lra.
Qed.
Lemma below_integer j : (j < m)%nat -> 2 <= INR (S (S j)) < T (S j) /\ 0 < Delta j <= difference (INR (S (S j))).
Proof.
  intros Hj. assert (A := clock_above (S j) Hj). assert (P := pos_INR j). rewrite S_INR in A. rewrite !S_INR.
  split; [lra|]. apply difference_falls. lra.
Qed.
Theorem sandwich_above j : (j <= m)%nat -> T j - (INR j + 1) <= e + z * (sum_n cube j - 1).
Proof.
  induction j as [|j IH]; intros Hj.
  - rewrite Hend, sum_O. unfold cube. simpl. rewrite sqrt_1, sqrt_0. lra.
  - rewrite (Hstep j Hj), sum_Sn, S_INR. change plus with Rplus. destruct (HD j Hj) as [_ U].
    assert (K := IH ltac:(lia)). destruct (below_integer j Hj) as [_ A]. rewrite cube_is.
    assert (M : z * Delta j ^ 3 <= z * difference (INR (S (S j))) ^ 3)
      by (apply Rmult_le_compat_l; [exact Hz | apply pow_incr; lra]). lra.
Qed.

Variables (h g x : R).
Hypothesis Hh : 0 <= h.
Hypothesis Hg : 0 <= g.
Hypothesis Hsum : e + z * (Series cube - 1) <= x <= 1.
Hypothesis HU : forall j, (j < m)%nat -> let d := Delta j in
  D j <= z * (d^3 - h * (g * d^2 - 0.155 * h * d - 0.43 * d^4)).
Hypothesis HL : forall j, (j < m)%nat -> let d := Delta j in
  z * (d^3 - h * (g * d^2 + 0.125 * h * d + 0.45 * d^4)) <= D j.
Let P j := 1 - / INR (S j).

(** What a step has: its Delta beside that of the integer n below its T. *)
Lemma beside j : (j < m)%nat -> let n := INR (S (S j)) in let d := Delta j in let t := P (S j) - P j in
  0 < d <= sqrt n - sqrt (INR (S j)) /\ 0 < t /\ cube (S j) - 0.156 * x * t <= d^3 <= cube (S j) /\
  (ln n - ln (INR (S j))) / 4 - (0.0038 + x / 4) * t <= d^2 <= (ln n - ln (INR (S j))) / 4 /\ d^4 <= t / 16.
Proof.
  intros Hj n d t. destruct (below_integer j Hj) as [A B]. fold d n in B. fold n in A.
  assert (En : INR (S j) = n - 1) by (unfold n; rewrite (S_INR (S j)); ring).
  assert (Et : t = / (n * (n - 1))) by (unfold t, P; fold n; rewrite En; field; lra).
  assert (Hx : 0 <= T (S j) - n <= x).
  { assert (W := sandwich_above (S j) Hj). assert (Bs := sum_below_series (S j)).
    assert (z * (sum_n cube (S j) - 1) <= z * (Series cube - 1)) by (apply Rmult_le_compat_l; lra).
    unfold n. unfold n in A. rewrite (S_INR (S j)) in *. lra. }
  destruct (roots_of_n n ltac:(lra)) as [_ [_ [_ [_ T0]]]]. destruct (square_below n ltac:(lra)) as [D0 _].
  assert (C := cube_raised n ltac:(lra) (T (S j) - n) ltac:(lra)).
  assert (Sq := square_raised n ltac:(lra) (T (S j) - n) ltac:(lra)).
  replace (n + (T (S j) - n)) with (T (S j)) in C, Sq by ring. fold (Delta j) in C, Sq. fold d in C, Sq.
  assert (F := fourth_power n ltac:(lra)). assert (L := logarithm n ltac:(lra)). rewrite <- Et in C, Sq, F, L, T0.
  assert (X : (T (S j) - n) * t <= x * t) by (apply Rmult_le_compat_r; lra).
  assert (d ^ 2 <= difference n ^ 2) by (apply pow_incr; lra).
  assert (d ^ 4 <= difference n ^ 4) by (apply pow_incr; lra).
  assert (d ^ 3 <= difference n ^ 3) by (apply pow_incr; lra). rewrite cube_is. fold n. rewrite En.
  unfold difference in B. repeat split; lra.
Qed.
Lemma at_zero : P O = 0 /\ ln (INR 1) = 0 /\ sqrt (INR 1) = 1 /\ sum_n cube 0 = 1.
Proof.
  unfold P. rewrite sum_O. unfold cube. simpl. rewrite Rinv_1, ln_1, sqrt_1, sqrt_0. repeat split; ring.
Qed.
(** What both inductions say of a step: its defect, by `bound`, and what is beside it, as `beside` has it, times what it counts. *)
Ltac one_step j Hj bound :=
  rewrite (Hstep j Hj), sum_Sn, (S_INR j); change plus with Rplus; assert (Bound := bound); cbv zeta in Bound;
  destruct (beside j Hj) as [A1 [A2 [A3 [A4 A5]]]]; set (d := Delta j) in *; set (t := P (S j) - P j) in *;
  assert (ZH : 0 <= z * h) by (now apply Rmult_le_pos); assert (ZG : 0 <= z * h * g) by (now apply Rmult_le_pos);
  assert (ZZ : 0 <= z * h^2) by (apply Rmult_le_pos; [exact Hz | apply pow2_ge_0]);
  assert (M3 := Rmult_le_compat_l _ _ _ ZZ (proj2 A1)); assert (M4 := Rmult_le_compat_l _ _ _ ZH A5);
  replace (P (S j)) with (P j + t) by (unfold t; ring).
Theorem logarithm_above j : (j <= m)%nat -> T j - (INR j + 1) - e <= z * (sum_n cube j - 1) -
  z * h * g * (ln (INR (S j)) / 4 - (0.0038 + x / 4) * P j) + 0.155 * (z * h^2) * (sqrt (INR (S j)) - 1) +
  0.43 * (z * h) / 16 * P j.
Proof.
  destruct at_zero as [Z1 [Z2 [Z3 Z4]]].
  induction j as [|j IH]; intros Hj; [rewrite Hend, Z1, Z2, Z3, Z4; simpl; lra|]. specialize (IH ltac:(lia)).
  one_step j Hj (HU j Hj).
  assert (M1 := Rmult_le_compat_l z _ _ Hz (proj2 A3)). assert (M2 := Rmult_le_compat_l _ _ _ ZG (proj1 A4)).
  lra.
Qed.
Theorem logarithm_below j : (j <= m)%nat -> z * (sum_n cube j - 1) - 0.156 * (z * x) * P j -
  z * h * g * (ln (INR (S j)) / 4) - 0.125 * (z * h^2) * (sqrt (INR (S j)) - 1) - 0.45 * (z * h) / 16 * P j <=
  T j - (INR j + 1) - e.
Proof.
  destruct at_zero as [Z1 [Z2 [Z3 Z4]]].
  induction j as [|j IH]; intros Hj; [rewrite Hend, Z1, Z2, Z3, Z4; simpl; lra|]. specialize (IH ltac:(lia)).
  one_step j Hj (HL j Hj).
  assert (M1 := Rmult_le_compat_l z _ _ Hz (proj1 A3)). assert (M2 := Rmult_le_compat_l _ _ _ ZG (proj2 A4)).
  lra.
Qed.
End Sandwich.
