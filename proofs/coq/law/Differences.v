(** The difference Delta = sqrt T - sqrt (T - 1) of LawStatement.v, for T from n to n + x, and its sums (L55 of law.md):
    with t = 1/(n (n - 1)), whose sum from n = 2 on is 1, every loss is at most a multiple of t.

    root_step         == Delta = 1/(sqrt T + sqrt (T - 1))
    difference_falls, difference_one == Delta falls, from 1 at T = 1
    roots_of_n        == 1/(sqrt n sqrt (n - 1)) is the root of t
    square_below      == Delta^2 is at most a quarter of it
    cube_raised, square_raised == what the powers of Delta lose at most from n to n + x
    fourth_power      == Delta^4 <= t/16
    logarithm         == Delta^2 is (ln n - ln (n - 1))/4, but for 0.0038 t: that is artanh (Delta^2) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Dumbbell Require Import LawStatement.
Local Open Scope R_scope.

Lemma root_step a : 1 <= a -> difference a = / (sqrt a + sqrt (a - 1)) /\ 0 < sqrt a + sqrt (a - 1).
Proof.
  intros Ha. unfold difference. assert (0 < sqrt a) by (apply sqrt_lt_R0; lra).
  assert (0 <= sqrt (a - 1)) by apply sqrt_pos.
  split; [|lra]. apply Rmult_eq_reg_r with (sqrt a + sqrt (a - 1)); [|lra]. rewrite Rinv_l by lra.
  assert (E1 := sqrt_sqrt a ltac:(lra)). assert (E2 := sqrt_sqrt (a - 1) ltac:(lra)). lra.
Qed.
Lemma difference_falls a b : 1 <= a <= b -> 0 < difference b <= difference a.
Proof.
  intros H. destruct (root_step a ltac:(lra)) as [-> P]. destruct (root_step b ltac:(lra)) as [-> Q].
  assert (sqrt a <= sqrt b) by (apply sqrt_le_1; lra).
  assert (sqrt (a - 1) <= sqrt (b - 1)) by (apply sqrt_le_1; lra).
  split; [apply Rinv_0_lt_compat; lra | apply Rinv_le_contravar; lra].
Qed.
Lemma difference_one : difference 1 = 1.
Proof. unfold difference. replace (1 - 1) with 0 by ring. rewrite sqrt_0, sqrt_1. ring. Qed.
Lemma difference_two : difference 2 <= 0.4143.
Proof. unfold difference. replace (2 - 1) with 1 by ring. rewrite sqrt_1. interval. Qed.

(** sqrt (n + x) <= sqrt n (1 + x/(2 n)). *)
Lemma sqrt_raised n x : 0 < n -> 0 <= x -> sqrt (n + x) <= sqrt n + x / (2 * sqrt n).
Proof.
  intros Hn Hx. assert (S := sqrt_lt_R0 n Hn). assert (Q := sqrt_sqrt n ltac:(lra)).
  assert (P : 0 <= x / (2 * sqrt n)) by (apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; lra]).
  rewrite <- (sqrt_square (sqrt n + x / (2 * sqrt n))) by lra. apply sqrt_le_1_alt.
  replace ((sqrt n + x / (2 * sqrt n)) * (sqrt n + x / (2 * sqrt n))) with
    (sqrt n * sqrt n + x + x / (2 * sqrt n) * (x / (2 * sqrt n))) by (field; lra).
  assert (0 <= x / (2 * sqrt n) * (x / (2 * sqrt n))) by now apply Rmult_le_pos. lra.
Qed.
(** artanh v = v + v^3/3 + ... *)
Lemma artanh_between v : 0 <= v <= 0.18 -> 0 <= (ln (1 + v) - ln (1 - v)) / 2 - v <= 0.35 * v ^ 3.
Proof.
  intros [[Hv|<-] H]; [|replace (1 + 0) with 1 by ring; replace (1 - 0) with 1 by ring; rewrite ln_1; lra].
  assert (K : forall t, 0 <= t <= 0.18 -> t * t <= 0.18 * 0.18 /\ 0 <= / (1 - t * t) - 1 <= 1.05 * t ^ 2).
  { intros t Ht. assert (t * t <= 0.18 * 0.18) by (apply Rmult_le_compat; lra).
    assert (0 <= t * t) by (apply Rmult_le_pos; lra). split; [assumption|].
    replace (/ (1 - t * t) - 1) with (t * t * / (1 - t * t)) by (field; lra).
    assert (0 < / (1 - t * t) <= 1.05).
    { split; [apply Rinv_0_lt_compat; lra|]. apply Rmult_le_reg_r with (1 - t * t); [lra|]. rewrite Rinv_l; lra. }
    split; [apply Rmult_le_pos; lra|]. replace (1.05 * t ^ 2) with (t * t * 1.05) by ring.
    apply Rmult_le_compat_l; lra. }
  split.
  - destruct (MVT_cor2 (fun t => (ln (1 + t) - ln (1 - t)) / 2 - t) (fun t => / (1 - t * t) - 1) 0 v Hv) as [s [E Hs]].
    { intros t Ht. destruct (K t ltac:(lra)) as [T _]. apply is_derive_Reals. auto_derive; [lra|].
      field. repeat split; lra. }
    replace (1 + 0) with 1 in E by ring. replace (1 - 0) with 1 in E by ring. rewrite ln_1 in E.
    destruct (K s ltac:(lra)) as [_ [K1 _]].
    assert (0 <= (/ (1 - s * s) - 1) * (v - 0)) by (apply Rmult_le_pos; lra). lra.
  - destruct (MVT_cor2 (fun t => 7/20 * t ^ 3 - ((ln (1 + t) - ln (1 - t)) / 2 - t))
      (fun t => 21/20 * t ^ 2 - (/ (1 - t * t) - 1)) 0 v Hv) as [s [E Hs]].
    { intros t Ht. destruct (K t ltac:(lra)) as [T _]. apply is_derive_Reals. auto_derive; [lra|].
      field. repeat split; lra. }
    replace (1 + 0) with 1 in E by ring. replace (1 - 0) with 1 in E by ring. rewrite ln_1 in E.
    destruct (K s ltac:(lra)) as [_ [_ K2]].
    assert (0 <= (21/20 * s ^ 2 - (/ (1 - s * s) - 1)) * (v - 0)) by (apply Rmult_le_pos; lra). lra.
Qed.

Section Beside.
Variable n : R.
Hypothesis Hn : 2 <= n.
Let a := sqrt n.
Let b := sqrt (n - 1).
Let t := / (n * (n - 1)).
Let w := / (a * b).                                                    (* the root of t *)

Lemma roots_of_n : 1.4 <= a /\ 1 <= b < a /\ 0 < w <= 1 /\ w * w = t /\ 0 < t.
Proof.
  assert (A : 1.4 <= a) by (apply Rle_trans with (sqrt 2); [interval | apply sqrt_le_1; lra]).
  assert (B : 1 <= b) by (rewrite <- sqrt_1; apply sqrt_le_1; lra). assert (L : b < a) by (apply sqrt_lt_1; lra).
  assert (P : 1 * 1 <= a * b) by (apply Rmult_le_compat; lra).
  assert (W : 0 < w <= 1) by (split; [apply Rinv_0_lt_compat | rewrite <- Rinv_1; apply Rinv_le_contravar]; lra).
  assert (E : w * w = t).
  { unfold w, t. rewrite <- Rinv_mult. f_equal. replace (a * b * (a * b)) with (a * a * (b * b)) by ring.
    unfold a, b. rewrite !sqrt_sqrt by lra. reflexivity. }
  repeat split; try lra. rewrite <- E. apply Rmult_lt_0_compat; lra.
Qed.
(** By the means: (a + b)^2 >= 4 a b. *)
Lemma square_below : 0 < difference n <= 0.4143 /\ difference n ^ 2 <= w / 4.
Proof.
  destruct roots_of_n as [A [B [W _]]]. assert (F := difference_falls 2 n ltac:(lra)). assert (D2 := difference_two).
  split; [lra|]. destruct (root_step n ltac:(lra)) as [-> P]. fold a b in P |- *.
  replace (w / 4) with (/ (4 * (a * b))) by (unfold w; field; lra). rewrite pow_inv.
  assert (0 < a * b) by (apply Rmult_lt_0_compat; lra). assert (0 <= (a - b) * (a - b)) by apply Rle_0_sqr.
  apply Rinv_le_contravar; [lra|]. simpl. lra.
Qed.
Lemma fourth_power : difference n ^ 4 <= t / 16.
Proof.
  destruct roots_of_n as [_ [_ [W [E _]]]]. destruct square_below as [D S].
  assert (P : 0 <= difference n ^ 2) by apply pow2_ge_0.
  replace (difference n ^ 4) with (difference n ^ 2 * difference n ^ 2) by ring. rewrite <- E.
  apply Rle_trans with (w / 4 * (w / 4)); [apply Rmult_le_compat; lra | lra].
Qed.
Lemma logarithm : difference n ^ 2 <= (ln n - ln (n - 1)) / 4 <= difference n ^ 2 + 0.0038 * t.
Proof.
  destruct roots_of_n as [A [B [W [E T]]]]. destruct square_below as [D S]. set (v := difference n ^ 2) in *.
  assert (V0 : 0 <= v) by apply pow2_ge_0.
  assert (V1 : v <= 0.1717).
  { unfold v. apply Rle_trans with (0.4143 ^ 2); [apply pow_incr|]; lra. }
  destruct (artanh_between v ltac:(lra)) as [L1 L2].
  assert (X : ln (1 + v) - ln (1 - v) = (ln n - ln (n - 1)) / 2).
  { assert (Q : n = a * a) by (unfold a; rewrite sqrt_sqrt; lra).
    assert (R : n - 1 = b * b) by (unfold b; rewrite sqrt_sqrt; lra).
    assert (LN : ln n = 2 * ln a) by (rewrite Q, ln_mult by lra; ring).
    assert (LM : ln (n - 1) = 2 * ln b) by (rewrite R, ln_mult by lra; ring).
    assert (AB : a * a - b * b = 1) by lra.
    assert (Z : v * (a + b) = a - b).
    { unfold v. destruct (root_step n ltac:(lra)) as [Y P]. fold a b in Y, P.
      assert (O : difference n * (a + b) = 1) by (rewrite Y; field; lra).
      replace (difference n ^ 2 * (a + b)) with (difference n * (difference n * (a + b))) by ring. rewrite O.
      unfold difference. fold a b. ring. }
    assert (Z2 : (1 + v) * b = (1 - v) * a) by lra.
    assert (Z3 := f_equal ln Z2). rewrite !ln_mult in Z3 by lra. lra. }
  rewrite X in L1, L2. split; [lra|].
  assert (K : v ^ 3 <= 0.1717 * (t / 16)).
  { replace (v ^ 3) with (v * difference n ^ 4) by (unfold v; ring). assert (F := fourth_power).
    apply Rmult_le_compat; [lra | apply pow_le; lra | lra | exact F]. }
  lra.
Qed.

Variable x : R.
Hypothesis Hx : 0 <= x <= 1.
Lemma difference_raised : difference n * (1 - x * w / 2) <= difference (n + x) /\ 0 <= 1 - x * w / 2.
Proof.
  destruct roots_of_n as [A [B [W _]]]. destruct (root_step n ltac:(lra)) as [-> P].
  destruct (root_step (n + x) ltac:(lra)) as [-> Q]. replace (n + x - 1) with (n - 1 + x) in * by ring.
  fold a b in P |- *.
  assert (X1 := sqrt_raised n x ltac:(lra) ltac:(lra)). assert (X2 := sqrt_raised (n - 1) x ltac:(lra) ltac:(lra)).
  fold a in X1. fold b in X2. set (y := x * w / 2).
  assert (XW : 0 <= x * w <= 1).
  { split; [apply Rmult_le_pos; lra|]. apply Rle_trans with (1 * 1); [apply Rmult_le_compat; lra | lra]. }
  assert (E : x / (2 * a) + x / (2 * b) = y * (a + b)) by (unfold y, w; field; lra). split; [|unfold y; lra].
  apply Rle_trans with (/ ((a + b) * (1 + y))).
  - rewrite Rinv_mult. apply Rmult_le_compat_l; [left; apply Rinv_0_lt_compat; lra|].
    apply Rmult_le_reg_r with (1 + y); [unfold y; lra|]. rewrite Rinv_l by (unfold y; lra).
    assert (0 <= y * y) by apply Rle_0_sqr. lra.
  - apply Rinv_le_contravar; lra.
Qed.
Lemma square_raised : difference n ^ 2 - x / 4 * t <= difference (n + x) ^ 2.
Proof.
  destruct roots_of_n as [_ [_ [W [E _]]]]. destruct square_below as [D S]. destruct difference_raised as [R P].
  apply Rle_trans with ((difference n * (1 - x * w / 2)) ^ 2).
  - set (y := x * w) in *. assert (Y : 0 <= y) by (apply Rmult_le_pos; lra).
    replace ((difference n * (1 - y / 2)) ^ 2) with
      (difference n ^ 2 - y * difference n ^ 2 + (difference n * y / 2) ^ 2) by field.
    assert (0 <= (difference n * y / 2) ^ 2) by apply pow2_ge_0.
    assert (y * difference n ^ 2 <= y * (w / 4)) by (apply Rmult_le_compat_l; lra).
    replace (x / 4 * t) with (y * (w / 4)) by (rewrite <- E; unfold y; field). lra.
  - apply pow_incr. split; [apply Rmult_le_pos; lra | exact R].
Qed.
Lemma cube_raised : difference n ^ 3 - 0.156 * x * t <= difference (n + x) ^ 3.
Proof.
  destruct roots_of_n as [_ [_ [W [E _]]]]. destruct square_below as [D S]. destruct difference_raised as [R P].
  apply Rle_trans with ((difference n * (1 - x * w / 2)) ^ 3).
  - set (y := x * w) in *. assert (Y : 0 <= y) by (apply Rmult_le_pos; lra). set (d := difference n) in *.
    assert (D3 : 0 <= d ^ 3) by (apply pow_le; lra).
    assert (C : 1 - 3 / 2 * y <= (1 - y / 2) ^ 3).
    { assert (0 <= y * y * (6 - y)) by (apply Rmult_le_pos; [apply Rle_0_sqr | lra]).
      replace ((1 - y / 2) ^ 3) with (1 - 3 / 2 * y + y * y * (6 - y) / 8) by field. lra. }
    assert (L : d ^ 3 * (3 / 2 * y) <= 0.4143 * (w / 4) * (3 / 2 * y)).
    { apply Rmult_le_compat_r; [lra|]. replace (d ^ 3) with (d * d ^ 2) by ring.
      apply Rmult_le_compat; [lra | apply pow2_ge_0 | lra | exact S]. }
    assert (M : d ^ 3 * (1 - 3 / 2 * y) <= d ^ 3 * (1 - y / 2) ^ 3) by (apply Rmult_le_compat_l; lra).
    rewrite Rpow_mult_distr.
    assert (X : x * t = y * w) by (rewrite <- E; unfold y; ring).
    assert (0 <= y * w) by (apply Rmult_le_pos; lra). lra.
  - apply pow_incr. split; [apply Rmult_le_pos; lra | exact R].
Qed.
End Beside.
