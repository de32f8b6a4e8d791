(** Taylor's formula of third order by signs, for an integral about a point.

    third_order        == p from its first three derivatives at 0, if the fourth is at most C
    integrable_between == f is integrable where it has a derivative
    integral_about     == the integral of f from x - a to x + b, from f, f', f'' at x, if f''' is at most C *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Sines.
Local Open Scope R_scope.

Lemma plus_scaled (P f : R -> R) P' f' e y : is_derive P y P' -> is_derive f y f' ->
  is_derive (fun t => P t + e * f t) y (P' + e * f').
Proof. intros HP Hf. exact (is_derive_plus P (fun t => e * f t) y P' (e * f') HP (is_derive_scal f y e f' Hf)). Qed.

Lemma third_order (p f f1 f2 f3 : R -> R) d C :
  (forall y, 0 <= y <= d -> is_derive p y (f y) /\ is_derive f y (f1 y) /\ is_derive f1 y (f2 y) /\
    is_derive f2 y (f3 y) /\ - C <= f3 y <= C) ->
  0 <= d ->
  p 0 + f 0 * d + f1 0 * d^2 / 2 + f2 0 * d^3 / 6 - C * d^4 / 24 <= p d <=
  p 0 + f 0 * d + f1 0 * d^2 / 2 + f2 0 * d^3 / 6 + C * d^4 / 24.
Proof.
  intros H Hd. assert (K : forall e, e = 1 \/ e = -1 ->
    0 <= (C * d^4 / 24 - e * (p 0 + f 0 * d + f1 0 * d^2 / 2 + f2 0 * d^3 / 6)) + e * p d).
  { intros e He.
    assert (R2 : forall y, 0 <= y <= d -> 0 <= (C * y - e * f2 0) + e * f2 y).
    { apply (grows _ (fun y => C + e * f3 y)); [| |ring].
      - intros y Hy. apply plus_scaled; [auto_derive; [easy | ring] | apply H, Hy].
      - intros y Hy. destruct (H y Hy) as [_ [_ [_ [_ B]]]]. destruct He as [-> | ->]; lra. }
    assert (R1 : forall y, 0 <= y <= d -> 0 <= (C * y^2 / 2 - e * (f1 0 + f2 0 * y)) + e * f1 y).
    { apply (grows _ (fun y => (C * y - e * f2 0) + e * f2 y)); [|exact R2 | field].
      intros y Hy. apply plus_scaled; [auto_derive; [easy | field] | apply H, Hy]. }
    assert (R0 : forall y, 0 <= y <= d -> 0 <= (C * y^3 / 6 - e * (f 0 + f1 0 * y + f2 0 * y^2 / 2)) + e * f y).
    { apply (grows _ (fun y => (C * y^2 / 2 - e * (f1 0 + f2 0 * y)) + e * f1 y)); [|exact R1 | field].
      intros y Hy. apply plus_scaled; [auto_derive; [easy | field] | apply H, Hy]. }
    apply (grows (fun y => (C * y^4 / 24 - e * (p 0 + f 0 * y + f1 0 * y^2 / 2 + f2 0 * y^3 / 6)) + e * p y)
      (fun y => (C * y^3 / 6 - e * (f 0 + f1 0 * y + f2 0 * y^2 / 2)) + e * f y) d); [|exact R0 | field | lra].
    intros y Hy. apply plus_scaled; [auto_derive; [easy | field] | apply H, Hy]. }
  assert (A := K 1 ltac:(now left)). assert (B := K (-1) ltac:(now right)). lra.
Qed.

Section Smooth.
Variables (f f1 f2 f3 : R -> R) (lo hi : R).
Hypothesis Hd : forall y, lo < y < hi -> is_derive f y (f1 y) /\ is_derive f1 y (f2 y) /\ is_derive f2 y (f3 y).
Lemma integrable_between y z : lo < y < hi -> lo < z < hi -> ex_RInt f y z.
Proof.
  intros Hy Hz. apply (ex_RInt_continuous (V := R_CompleteNormedModule)). intros t Ht.
  apply (ex_derive_continuous f t). exists (f1 t). apply Hd.
  split; [apply Rlt_le_trans with (2 := proj1 Ht), Rmin_glb_lt |
    apply Rle_lt_trans with (1 := proj2 Ht), Rmax_lub_lt]; lra.
Qed.
Variable x : R.
Hypothesis Hx : lo < x < hi.
Lemma integral_derive y : lo < y < hi -> is_derive (fun z => RInt f x z) y (f y).
Proof.
  intros Hy. apply (is_derive_RInt f (fun z => RInt f x z) x y).
  - assert (P : 0 < Rmin (y - lo) (hi - y)) by (apply Rmin_glb_lt; lra). exists (mkposreal _ P). intros z Hz.
    apply (RInt_correct (V := R_CompleteNormedModule)), integrable_between; [exact Hx|].
    unfold ball in Hz; simpl in Hz; unfold AbsRing_ball, abs, minus, plus, opp in Hz; simpl in Hz.
    apply Rabs_def2 in Hz. assert (A := Rmin_l (y - lo) (hi - y)). assert (B := Rmin_r (y - lo) (hi - y)). lra.
  - apply (ex_derive_continuous f y). exists (f1 y). now apply Hd.
Qed.
Lemma shifted (g g' : R -> R) e y : (forall t, lo < t < hi -> is_derive g t (g' t)) -> lo < x + e * y < hi ->
  is_derive (fun t => g (x + e * t)) y (e * g' (x + e * y)).
Proof.
  intros D Hy. change (e * g' (x + e * y)) with (scal e (g' (x + e * y))).
  apply (is_derive_comp g (fun t => x + e * t)); [now apply D | auto_derive; [easy | ring]].
Qed.

Variables a b C : R.
Hypothesis Ha : 0 <= a /\ lo < x - a.
Hypothesis Hb : 0 <= b /\ x + b < hi.
Hypothesis HC : forall y, x - a <= y <= x + b -> - C <= f3 y <= C.
Theorem integral_about : exists z, -1 <= z <= 1 /\
  RInt f (x - a) (x + b) = f x * (a + b) + f1 x * ((b^2 - a^2) / 2) + f2 x * ((a^3 + b^3) / 6) +
    z * (C * ((a^4 + b^4) / 24)).
Proof.
  set (I := (fun z => RInt f x z) : R -> R).
  assert (R : forall e d, e * e = 1 -> 0 <= d -> (forall y, 0 <= y <= d -> x - a <= x + e * y <= x + b) ->
    let q := f x * d + e * f1 x * d^2 / 2 + f2 x * d^3 / 6 in
    q - C * d^4 / 24 <= e * I (x + e * d) <= q + C * d^4 / 24).
  { intros e d He H0 Hr. cbv zeta.
    assert (X : x + e * 0 = x) by ring. assert (I0 : I x = 0) by (exact (RInt_point x f)).
    assert (T := third_order (fun y => e * I (x + e * y)) (fun y => f (x + e * y)) (fun y => e * f1 (x + e * y))
      (fun y => f2 (x + e * y)) (fun y => e * f3 (x + e * y)) d C). cbv beta in T. rewrite X, I0 in T.
    assert (S : forall g g' y, 0 <= y <= d -> (forall t, lo < t < hi -> is_derive g t (g' t)) ->
      is_derive (fun t => g (x + e * t)) y (e * g' (x + e * y)) /\
      is_derive (fun t => e * g (x + e * t)) y (g' (x + e * y))).
    { intros g g' y Hy D. assert (E := shifted g g' e y D ltac:(specialize (Hr y Hy); lra)). split; [exact E|].
      replace (g' (x + e * y)) with (e * (e * g' (x + e * y))) by (rewrite <- Rmult_assoc, He; ring).
      exact (is_derive_scal _ y e _ E). }
    assert (G : forall y, 0 <= y <= d -> is_derive (fun y => e * I (x + e * y)) y (f (x + e * y)) /\
      is_derive (fun y => f (x + e * y)) y (e * f1 (x + e * y)) /\
      is_derive (fun y => e * f1 (x + e * y)) y (f2 (x + e * y)) /\
      is_derive (fun y => f2 (x + e * y)) y (e * f3 (x + e * y)) /\ - C <= e * f3 (x + e * y) <= C).
    { intros y Hy. split; [apply (S I f y Hy); exact integral_derive|].
      split; [apply (S f f1 y Hy); intros t Ht; apply Hd, Ht|].
      split; [apply (S f1 f2 y Hy); intros t Ht; apply Hd, Ht|].
      split; [apply (S f2 f3 y Hy); intros t Ht; apply Hd, Ht|].
      assert (B := HC (x + e * y) (Hr y Hy)). assert (P : e = 1 \/ e = -1).
      { destruct (Rmult_integral (e - 1) (e + 1)); [lra | left; lra | right; lra]. }
      destruct P as [-> | ->]; lra. }
    specialize (T G H0). lra. }
  assert (A := R (-1) a ltac:(ring) (proj1 Ha) ltac:(intros; lra)).
  assert (B := R 1 b ltac:(ring) (proj1 Hb) ltac:(intros; lra)). cbv zeta in A, B. clear R.
  replace (x + -1 * a) with (x - a) in A by ring. replace (x + 1 * b) with (x + b) in B by ring.
  assert (E : RInt f (x - a) (x + b) = - I (x - a) + I (x + b)).
  { unfold I. assert (Y : RInt f (x - a) x + RInt f x (x + b) = RInt f (x - a) (x + b))
      by (apply (RInt_Chasles f); apply integrable_between; lra).
    assert (Z : opp (RInt f (x - a) x) = RInt f x (x - a)) by (apply opp_RInt_swap, integrable_between; lra).
    unfold opp in Z; simpl in Z. lra. }
  set (q := f x * (a + b) + f1 x * ((b^2 - a^2) / 2) + f2 x * ((a^3 + b^3) / 6)).
  set (r := C * ((a^4 + b^4) / 24)). assert (L : - r <= RInt f (x - a) (x + b) - q <= r) by (unfold q, r; lra).
  destruct (Req_dec r 0) as [Z|Z].
  - exists 0. split; lra.
  - assert (0 < r) by lra. exists ((RInt f (x - a) (x + b) - q) / r).
    assert (Y : forall v : R, v = q + (v - q) / r * r) by (intros v; field; lra). split; [|exact (Y _)].
    split; apply Rmult_le_reg_r with r; try lra; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra.
Qed.
End Smooth.
