(** What is left of sine and cosine after their first terms, without a singularity at 0.

    tail_sin, tail_cos     == t with sin x = x (1 - x^2/6 t) and with cos x = 1 - x^2/2 t
    sin_tail, cos_tail     == that they are so
    tail_sin_is, tail_cos_is == three more terms of their series, b in [0, 1] for all others *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Sines.
Local Open Scope R_scope.

Lemma rises (f f' : R -> R) : (forall y, is_derive f y (f' y)) -> (forall y, 0 <= y -> 0 <= f' y) -> f 0 = 0 ->
  forall y, 0 <= y -> 0 <= f y.
Proof.
  intros D P Z y [Hy|<-]; [|rewrite Z; lra].
  destruct (MVT_cor2 f f' 0 y Hy) as [t [E Ht]]; [intros t _; apply is_derive_Reals, D|]. rewrite Z in E.
  assert (0 <= f' t * (y - 0)) by (apply Rmult_le_pos; [apply P; lra | lra]). lra.
Qed.

Definition cos4 x := 1 - x^2 / 2 + x^4 / 24.
Definition sin5 x := x - x^3 / 6 + x^5 / 120.
Definition cos6 x := cos4 x - x^6 / 720.
Definition sin7 x := sin5 x - x^7 / 5040.
Definition cos8 x := cos6 x + x^8 / 40320.
Definition sin9 x := sin7 x + x^9 / 362880.
Ltac by_rise f' := unfold sin9, sin7, sin5, cos8, cos6, cos4; apply (rises _ f');
  [intros t; auto_derive; [easy | simpl; unfold sin7, sin5, cos8, cos6, cos4; field] | | simpl;
    rewrite ?sin_0, ?cos_0; field].
Lemma taylor x : 0 <= x -> sin7 x <= sin x <= sin9 x /\ cos6 x <= cos x <= cos8 x.
Proof.
  intros Hx.
  assert (C4 : forall y, 0 <= y -> 0 <= cos4 y - cos y).
  { by_rise (fun y => - y + y^3 / 6 + sin y). intros y Hy. assert (K := sine_below y Hy). simpl. lra. }
  assert (S5 : forall y, 0 <= y -> 0 <= sin5 y - sin y) by (by_rise (fun y => cos4 y - cos y); exact C4).
  assert (C6 : forall y, 0 <= y -> 0 <= cos y - cos6 y)
    by (by_rise (fun y => sin5 y - sin y); exact S5).
  assert (S7 : forall y, 0 <= y -> 0 <= sin y - sin7 y)
    by (by_rise (fun y => cos y - cos6 y); exact C6).
  assert (C8 : forall y, 0 <= y -> 0 <= cos8 y - cos y)
    by (by_rise (fun y => sin y - sin7 y); exact S7).
  assert (S9 : forall y, 0 <= y -> 0 <= sin9 y - sin y)
    by (by_rise (fun y => cos8 y - cos y); exact C8).
  assert (A := C6 x Hx). assert (B := C8 x Hx). assert (C := S7 x Hx). assert (D := S9 x Hx). lra.
Qed.

Definition tail_sin x := if Req_EM_T x 0 then 1 else 6 * (x - sin x) / x^3.
Definition tail_cos x := if Req_EM_T x 0 then 1 else 2 * (1 - cos x) / x^2.
Lemma sin_tail x : sin x = x * (1 - x^2 / 6 * tail_sin x).
Proof. unfold tail_sin. destruct (Req_EM_T x 0) as [->|N]; [rewrite sin_0; ring | field; exact N]. Qed.
Lemma cos_tail x : cos x = 1 - x^2 / 2 * tail_cos x.
Proof. unfold tail_cos. destruct (Req_EM_T x 0) as [->|N]; [rewrite cos_0; field | field; exact N]. Qed.
Lemma tails_even x : tail_sin (- x) = tail_sin x /\ tail_cos (- x) = tail_cos x.
Proof.
  unfold tail_sin, tail_cos. rewrite sin_neg, cos_neg. destruct (Req_EM_T (- x) 0), (Req_EM_T x 0); try lra.
  split; field; lra.
Qed.

(** A number between a polynomial and the next one: the last bracket is in [0, 1]. *)
Lemma last_bracket t p w : 0 < w -> 0 <= t - p <= w -> exists b, 0 <= b <= 1 /\ t = p + w * b.
Proof.
  intros Hw H. exists ((t - p) / w). split; [|field; lra]. split.
  - apply Rmult_le_pos; [lra | left; now apply Rinv_0_lt_compat].
  - apply Rmult_le_reg_r with w; [exact Hw|]. replace ((t - p) / w * w) with (t - p) by (field; lra). lra.
Qed.
Ltac by_parity x tail_is := destruct (Rle_dec 0 x) as [L|L];
  [now apply tail_is | destruct (tails_even x) as [E1 E2]; rewrite <- ?E1, <- ?E2;
    replace (x^2) with ((- x)^2) by ring;
    apply tail_is; lra].
Theorem tail_sin_is x : exists b, 0 <= b <= 1 /\ tail_sin x = 1 - x^2 / 20 * (1 - x^2 / 42 * (1 - x^2 / 72 * b)).
Proof.
  assert (K : forall x, 0 <= x -> exists b, 0 <= b <= 1 /\
    tail_sin x = 1 - x^2 / 20 * (1 - x^2 / 42 * (1 - x^2 / 72 * b))); [clear x; intros x Hx|by_parity x K].
  unfold tail_sin. destruct (Req_EM_T x 0) as [->|N]; [exists 0; split; [lra | field]|].
  destruct (taylor x Hx) as [S _]. unfold sin7, sin9, sin7, sin5 in S. assert (P : 0 < x^3) by (apply pow_lt; lra).
  destruct (last_bracket (sin x) (x - x^3 / 6 + x^5 / 120 - x^7 / 5040) (x^9 / 362880)) as [b [B E]].
  { assert (0 < x^9) by (apply pow_lt; lra). lra. } { lra. }
  exists b. split; [lra|]. rewrite E. field. exact N.
Qed.
Theorem tail_cos_is x : exists b, 0 <= b <= 1 /\ tail_cos x = 1 - x^2 / 12 * (1 - x^2 / 30 * (1 - x^2 / 56 * b)).
Proof.
  assert (K : forall x, 0 <= x -> exists b, 0 <= b <= 1 /\
    tail_cos x = 1 - x^2 / 12 * (1 - x^2 / 30 * (1 - x^2 / 56 * b))); [clear x; intros x Hx|by_parity x K].
  unfold tail_cos. destruct (Req_EM_T x 0) as [->|N]; [exists 0; split; [lra | field]|].
  destruct (taylor x Hx) as [_ S]. unfold cos8, cos6, cos4 in S.
  destruct (last_bracket (cos x) (1 - x^2 / 2 + x^4 / 24 - x^6 / 720) (x^8 / 40320)) as [b [B E]].
  { assert (0 < x^8) by (apply pow_lt; lra). lra. } { lra. }
  exists b. split; [lra|]. rewrite E. field. exact N.
Qed.
