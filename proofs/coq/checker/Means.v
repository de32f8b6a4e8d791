(** Integrals of t f(t) over [0, 1] from what encloses f on slices of it: a weighted mean of intervals.

    slice, weight   == [i/n, (i + 1)/n]; the integral of t over it
    mean            == the sum of weights times values
    bounded_in      == what obeys all bounds of some numbers of an interval is in it
    mean_in         == the mean encloses the integral of h, h t = t f(t) *)
From Coq Require Import Reals ZArith Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Real.Xreal Float.Basic Float.Sig Interval.Interval Interval.Float Interval.Float_full.
From Dumbbell Require Import Signs Quotients Slopes Terms.
Local Open Scope R_scope.

Module Means (F : FloatOps with Definition sensible_format := true).
Module Export Y := Terms F.
Section S.
Variable p : F.precision.
Definition frac (a b : Z) : I.type := I.div p (I.fromZ p a) (I.fromZ p b).
Definition slice (n i : nat) : I.type := I.join (frac (Z.of_nat i) (Z.of_nat n)) (frac (Z.of_nat i + 1) (Z.of_nat n)).
Definition weight (n i : nat) : I.type := frac (2 * Z.of_nat i + 1) (2 * Z.of_nat n * Z.of_nat n).
Definition mean (l : list (I.type * I.type)) : I.type :=
  fold_right (fun part sum => I.add p (I.mul p (fst part) (snd part)) sum) I.zero l.

Lemma frac_in a b : inI (IZR a / IZR b) (frac a b).
Proof. apply div_in; apply fromZ_in. Qed.
Lemma join_in a b x i j : inI a i -> inI b j -> a <= x <= b -> inI x (I.join i j).
Proof.
  intros Hi Hj H. apply (contains_connected (I.convert (I.join i j)) a b); [| |exact H]; apply I.join_correct; [now
    left | now right].
Qed.
Lemma bounded_in (P : R -> Prop) m i : (forall x, P x -> inI x i) -> (exists x, P x) ->
  (forall a, (forall x, P x -> a <= x) -> a <= m) -> (forall b, (forall x, P x -> x <= b) -> m <= b) -> inI m i.
Proof.
  unfold inI. intros H [x0 X0] L U. destruct (I.convert i) as [|l u]; [easy|]. simpl in *. split.
  - destruct l as [|l]; [easy|]. apply L. intros x Hx. apply (H x Hx).
  - destruct u as [|u]; [easy|]. apply U. intros x Hx. apply (H x Hx).
Qed.

Section Function.
Variables (h f : R -> R) (value : I.type -> I.type).
Hypothesis Hh : forall t, 0 <= t <= 1 -> continuous h t.
Hypothesis Hf : forall t, 0 <= t <= 1 -> h t = t * f t.
Hypothesis Hv : forall t i, 0 <= t <= 1 -> inI t i -> inI (f t) (value i).
Lemma h_integrable a b : 0 <= a -> a <= b <= 1 -> ex_RInt h a b.
Proof.
  intros Ha Hb. apply (ex_RInt_continuous (V := R_CompleteNormedModule)). rewrite Rmin_left, Rmax_right by lra.
  intros t Ht. apply Hh. lra.
Qed.
Lemma linear_integral c a b : is_RInt (fun t => t * c) a b (c * ((b * b - a * a) / 2)).
Proof.
  replace (c * ((b * b - a * a) / 2)) with (minus (c * (b * b) / 2) (c * (a * a) / 2))
    by (unfold minus, plus, opp; simpl; field).
  apply (is_RInt_derive (fun t => c * (t * t) / 2) (fun t => t * c)).
  - intros t _. auto_derive; [easy | field].
  - intros t _. apply (ex_derive_continuous (fun t => t * c)). auto_derive. easy.
Qed.
Lemma slice_in a b w i : 0 <= a < b -> b <= 1 -> (forall t, a <= t <= b -> inI t i) -> inI ((b * b - a * a) / 2) w ->
  inI (RInt h a b) (I.mul p w (value i)).
Proof.
  intros Ha Hb Hi Hw. set (W := (b * b - a * a) / 2) in *.
  assert (W0 : 0 < W) by (unfold W; assert (a * a < b * b) by (apply Rmult_le_0_lt_compat; lra); lra).
  replace (RInt h a b) with (W * (RInt h a b / W)) by (field; lra). apply mul_in; [exact Hw|].
  assert (Ih := RInt_correct (V := R_CompleteNormedModule) _ _ _ (h_integrable a b ltac:(lra) ltac:(lra))).
  apply (bounded_in (fun x => exists t, a <= t <= b /\ x = f t)).
  - intros x [t [Ht ->]]. apply Hv; [lra | now apply Hi].
  - exists (f a), a. split; [lra | reflexivity].
  - intros c Hc. apply quotient_at_least; [exact W0|].
    refine (is_RInt_le _ _ a b _ _ (Rlt_le _ _ (proj2 Ha)) (linear_integral c a b) Ih _).
    intros t Ht. rewrite (Hf t) by lra. apply Rmult_le_compat_l; [lra|]. apply Hc. exists t. split; [lra |
      reflexivity].
  - intros c Hc. apply quotient_at_most; [exact W0|].
    refine (is_RInt_le _ _ a b _ _ (Rlt_le _ _ (proj2 Ha)) Ih (linear_integral c a b) _).
    intros t Ht. rewrite (Hf t) by lra. apply Rmult_le_compat_l; [lra|]. apply Hc. exists t. split; [lra |
      reflexivity].
Qed.

Lemma slices_in n k m : (0 < n)%nat -> (k + m <= n)%nat ->
  inI (RInt h (INR k / INR n) (INR (k + m) / INR n)) (mean (map (fun i => (weight n i, value (slice n i))) (seq k
    m))).
Proof.
  intros Hn. revert k. assert (N : 0 < INR n) by (now apply lt_0_INR).
  assert (At : forall k, (k <= n)%nat -> 0 <= INR k / INR n <= 1).
  { intros k Hk. split; [apply quotient_at_least; [exact N|]; rewrite Rmult_0_l; apply pos_INR|].
    apply quotient_at_most; [exact N|]. rewrite Rmult_1_l. now apply le_INR. }
  induction m as [|m IH]; intros k Hk.
  - rewrite Nat.add_0_r, RInt_point. exact zero_in.
  - assert (Up : INR k / INR n < INR (S k) / INR n).
    { unfold Rdiv. apply Rmult_lt_compat_r; [now apply Rinv_0_lt_compat | apply lt_INR; lia]. }
    assert (Up2 : INR (S k) / INR n <= INR (k + S m) / INR n).
    { unfold Rdiv. apply Rmult_le_compat_r; [left; now apply Rinv_0_lt_compat | apply le_INR; lia]. }
    assert (A := At k ltac:(lia)). assert (B := At (S k) ltac:(lia)). assert (C := At (k + S m)%nat Hk).
    rewrite <- (RInt_Chasles h (INR k / INR n) (INR (S k) / INR n) (INR (k + S m) / INR n)) by (apply h_integrable;
      lra).
    apply add_in; [|replace (k + S m)%nat with (S k + m)%nat by lia; apply IH; lia]. cbn [fst snd].
    assert (E : forall z, INR z / INR n = IZR (Z.of_nat z) / IZR (Z.of_nat n)) by (intros; now rewrite <-
      !INR_IZR_INZ).
    apply slice_in; [lra | lra | |].
    + intros t Ht. apply (join_in (INR k / INR n) (INR (S k) / INR n)); [| |exact Ht].
      * rewrite E. apply frac_in.
      * rewrite E. replace (Z.of_nat (S k)) with (Z.of_nat k + 1)%Z by lia. apply frac_in.
    + replace ((INR (S k) / INR n * (INR (S k) / INR n) - INR k / INR n * (INR k / INR n)) / 2) with
        (IZR (2 * Z.of_nat k + 1) / IZR (2 * Z.of_nat n * Z.of_nat n)); [apply frac_in|].
      rewrite plus_IZR, !mult_IZR, <- !INR_IZR_INZ, S_INR. field. lra.
Qed.
Theorem mean_in n : (0 < n)%nat ->
  inI (RInt h 0 1) (mean (map (fun i => (weight n i, value (slice n i))) (seq 0 n))).
Proof.
  intros Hn. assert (N : 0 < INR n) by (now apply lt_0_INR). assert (H := slices_in n 0 n Hn ltac:(lia)).
  replace (INR 0 / INR n) with 0 in H by (simpl; field; lra). rewrite Nat.add_0_l in H.
  replace (INR n / INR n) with 1 in H by (field; lra). exact H.
Qed.
End Function.
End S.
End Means.
