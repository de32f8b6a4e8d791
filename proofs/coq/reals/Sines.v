(** Bounds of sine and cosine by polynomials.

    grows           == a function is >= 0 that begins with 0 and has a derivative >= 0
    tangent_above   == d cos d < sin d
    sine_square     == sin^2 x <= x^2
    cosine_below    == 1 - x^2/2 <= cos x
    sine_below      == x - x^3/6 <= sin x
    cosine_above    == cos x <= 1 - x^2/2 + x^4/24
    sine_above      == sin x <= x - x^3/6 + x^5/120
    tangent_square  == cos^2 (1 + tan^2) = 1
    arctangent_below == x - x^3 <= atan x *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
Local Open Scope R_scope.

Lemma tangent_above d : 0 < d < PI/2 -> d * cos d < sin d.
Proof.
  intros Hd. destruct (MVT_cor2 (fun x => sin x - x * cos x) (fun x => x * sin x) 0 d) as [s [E Hs]]; [lra | |].
  { intros x _. apply is_derive_Reals. auto_derive; [easy | ring]. }
  assert (0 < s * sin s) by (apply Rmult_lt_0_compat; [lra | apply sin_gt_0; lra]).
  assert (0 < s * sin s * (d - 0)) by (apply Rmult_lt_0_compat; lra). rewrite sin_0 in E. lra.
Qed.
Lemma sine_square x : 0 <= x -> sin x * sin x <= x * x.
Proof.
  intros Hx. rewrite <- (Rabs_pos_eq (sin x * sin x)) by apply Rle_0_sqr. rewrite Rabs_mult.
  assert (L : Rabs (sin x) <= x); [|apply Rmult_le_compat; try apply Rabs_pos; exact L].
  assert (P := PI2_1). assert (U : sin x <= x)
    by (destruct Hx as [Hx|<-]; [left; now apply sin_lt_x | rewrite sin_0; lra]).
  destruct (Rle_dec x PI); [rewrite Rabs_pos_eq; [exact U | apply sin_ge_0; lra]|].
  destruct (SIN_bound x). apply Rabs_le. lra.
Qed.
Lemma cosine_below x : 0 <= x -> 1 - x * x / 2 <= cos x.
Proof.
  intros Hx. replace (cos x) with (cos (2 * (x / 2))) by (f_equal; field). rewrite cos_2a_sin.
  assert (H := sine_square (x / 2) ltac:(lra)). lra.
Qed.
Lemma sine_below x : 0 <= x -> x - x * x * x / 6 <= sin x.
Proof.
  intros [Hx|<-]; [|rewrite sin_0; lra].
  destruct (MVT_cor2 (fun t => sin t - t + t * t * t / 6) (fun t => cos t - 1 + t * t / 2) 0 x) as [s [D Hs]];
    [lra | |].
  { intros t _. apply is_derive_Reals. auto_derive; [easy | field]. } rewrite sin_0 in D.
  assert (C := cosine_below s ltac:(lra)).
  assert (0 <= (cos s - 1 + s * s / 2) * (x - 0)) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma arctangent_below x : 0 <= x -> x - x * x * x <= atan x.
Proof.
  intros [Hx|<-]; [|rewrite atan_0; lra].
  destruct (MVT_cor2 atan (fun t => / (1 + t * t)) 0 x) as [s [E Hs]]; [lra | |].
  { intros t _. replace (t * t) with (t ^ 2) by ring. apply derivable_pt_lim_atan. }
  rewrite atan_0 in E. assert (S2 : 0 <= s * s) by apply Rle_0_sqr.
  assert (S : s * s <= x * x) by (apply Rmult_le_compat; lra).
  assert (H : 1 - x * x <= / (1 + s * s)).
  { apply Rmult_le_reg_r with (1 + s * s); [lra|]. rewrite Rinv_l by lra.
    assert (0 <= x * x * (s * s)) by (apply Rmult_le_pos; lra). lra. }
  assert ((1 - x * x) * x <= / (1 + s * s) * x) by (apply Rmult_le_compat_r; lra). lra.
Qed.
(** Taylor's formula at a point, by signs: what is 0 at 0 and has a derivative >= 0 is >= 0. *)
Lemma grows (f f' : R -> R) d : (forall y, 0 <= y <= d -> is_derive f y (f' y)) -> (forall y, 0 <= y <= d ->
  0 <= f' y) -> f 0 = 0 ->
  forall y, 0 <= y <= d -> 0 <= f y.
Proof.
  intros D P Z y [[Hy|<-] Hd]; [|rewrite Z; lra].
  destruct (MVT_cor2 f f' 0 y Hy) as [t [E Ht]]; [intros t Ht; apply is_derive_Reals, D; lra|]. rewrite Z in E.
  assert (0 <= f' t * (y - 0)) by (apply Rmult_le_pos; [apply P; lra | lra]). lra.
Qed.

Lemma cosine_above x : 0 <= x -> cos x <= 1 - x^2 / 2 + x^4 / 24.
Proof.
  intros Hx. assert (H : 0 <= 1 - x^2 / 2 + x^4 / 24 - cos x); [|lra].
  apply (grows (fun y => 1 - y^2 / 2 + y^4 / 24 - cos y) (fun y => - y + y^3 / 6 + sin y) x); [| | |lra].
  - intros y _. auto_derive; [easy | field].
  - intros y Hy. assert (H := sine_below y ltac:(lra)). simpl. lra.
  - rewrite cos_0. field.
Qed.
Lemma sine_above x : 0 <= x -> sin x <= x - x^3 / 6 + x^5 / 120.
Proof.
  intros Hx. assert (H : 0 <= x - x^3 / 6 + x^5 / 120 - sin x); [|lra].
  apply (grows (fun y => y - y^3 / 6 + y^5 / 120 - sin y) (fun y => 1 - y^2 / 2 + y^4 / 24 - cos y) x); [| | |lra].
  - intros y _. auto_derive; [easy | field].
  - intros y Hy. assert (H := cosine_above y ltac:(lra)). lra.
  - rewrite sin_0. field.
Qed.

(** cos^2 (1 + tan^2) = 1. *)
Lemma tangent_square th : 0 < th < PI/2 -> 0 < cos th /\ 0 < tan th /\ cos th * cos th * (1 + tan th * tan th) = 1.
Proof.
  intros H. assert (C : 0 < cos th) by (apply cos_gt_0; lra). split; [exact C|]. split; [apply tan_gt_0; lra|].
  assert (K := sin2_cos2 th). unfold Rsqr in K. apply eq_trans with (2 := K). unfold tan. field. lra.
Qed.
