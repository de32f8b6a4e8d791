(** The moments and integrals of the end on slopes (law/EndSlopes.v has the definitions): they enclose.

    moment_sin_above == the integral of y sin y, to one term more
    slices_in        == a mean over the slices of t encloses an integral
    integral_H_encl, integral_H2_in == the integrals of EndIntegrals.v
    far_in           == G3 and G4 *)
From Coq Require Import Reals ZArith Lra List.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Real.Xreal Float.Basic Float.Sig Interval.Interval Interval.Float Interval.Float_full.
From Dumbbell Require Import Signs Quotients Sines PiValue Clock Midpoint Defect Slopes Terms EndTerms EndAtZero EndShare
  EndIntegrals EndSlopes.
Local Open Scope R_scope.

Lemma moment_sin_above d : 0 <= d -> moment_sin d 1 <= d^3 / 3 - d^5 / 30 + d^7 / 840.
Proof.
  intros Hd. assert (S : is_RInt (fun y => y^1 * sin y) 0 d (moment_sin d 1)).
  { apply (RInt_correct (V := R_CompleteNormedModule)), (ex_RInt_continuous (V := R_CompleteNormedModule)).
    intros y _. apply (ex_derive_continuous (fun y => y^1 * sin y)). auto_derive. easy. }
  assert (P : is_RInt (fun y => y^2 - y^4 / 6 + y^6 / 120) 0 d (d^3 / 3 - d^5 / 30 + d^7 / 840)).
  { replace (d^3 / 3 - d^5 / 30 + d^7 / 840) with (minus (d^3 / 3 - d^5 / 30 + d^7 / 840) (0^3 / 3 - 0^5 / 30 + 0^7 / 840))
      by (unfold minus, plus, opp; simpl; field).
    apply (is_RInt_derive (fun y => y^3 / 3 - y^5 / 30 + y^7 / 840) (fun y => y^2 - y^4 / 6 + y^6 / 120)).
    - intros y _. auto_derive; [easy | simpl; field].
    - intros y _. apply (ex_derive_continuous (fun y => y^2 - y^4 / 6 + y^6 / 120)). auto_derive. easy. }
  refine (is_RInt_le _ _ 0 d _ _ Hd S P _). intros y Hy. assert (A := sine_above y ltac:(lra)).
  replace (y^2 - y^4 / 6 + y^6 / 120) with (y * (y - y^3 / 6 + y^5 / 120)) by field. rewrite pow_1. pos.
Qed.

Module EndMoments (F : FloatOps with Definition sensible_format := true).
Module Export E := EndSlopes F.
Ltac real := match goal with |- ?a = ?b => change (@eq R a b) end.
Section S.
Variable p : F.precision.
Variable part : I.type.
Variable d : R.
Hypothesis Hd : 0 < d <= 0.09.
Hypothesis Hp : inI d part.
Let u := 2 * d.
Lemma slices_in (field : slope -> I.type) f h g n : (0 < n)%nat -> (forall t, 0 <= t <= 1 -> continuous h t) ->
  (forall t, 0 <= t <= 1 -> h t = t * g t) ->
  (forall t i, 0 <= t <= 1 -> inI t i -> let k := I.mul2 p i in
    inI (g t) (field (f (sinc_slope p part (I.sqr p k)) (line p part (pi_i p) (I.neg k))))) ->
  inI (RInt h 0 1) (mean_of p field (slices p part n f)).
Proof.
  intros Hn Hc Hg Hf. unfold mean_of, slices. rewrite map_map.
  exact (mean_in p h g (fun i => let k := I.mul2 p i in field (f (sinc_slope p part (I.sqr p k)) (line p part (pi_i p) (I.neg k))))
    Hc Hg Hf n Hn).
Qed.
Lemma way_encl t i : 0 <= t <= 1 -> inI t i -> let k := I.mul2 p i in
  encl d (sinc_jet d (2 * t)) (sinc_slope p part (I.sqr p k)) /\
  encl d (jline d PI (- (2 * t))) (line p part (pi_i p) (I.neg k)).
Proof.
  intros Ht Hi k. assert (K : inI (2 * t) k) by now apply mul2_in. split.
  - apply sinc_encl; [exact Hd | exact Hp | lra | now apply X.sqr_in].
  - apply line_encl; [lra | exact Hp | apply pi_in | now apply neg_in].
Qed.
Lemma jet_H_encl q qi t i : inI q qi -> 0 <= t <= 1 -> inI t i -> let k := I.mul2 p i in
  encl d (jet_H d q t) (weight_H _ (slopes p part) (sinc_slope p part (I.sqr p k)) (line p part (pi_i p) (I.neg k))
    (quarter_line p part qi)).
Proof.
  intros Hq Ht Hi k. destruct (way_encl t i Ht Hi) as [A B]. fold k in A, B. assert (HN : d <> 0) by lra.
  assert (C := quarter_encl p part d Hd Hp q qi Hq). unfold jet_H, along, weight_H. cbv zeta. enclose.
Qed.
Lemma jet_H2_encl q qi t i : inI q qi -> 0 <= t <= 1 -> inI t i -> let k := I.mul2 p i in
  encl d (jet_H2 d q t) (weight_H2 _ (slopes p part) (sinc_slope p part (I.sqr p k)) (line p part (pi_i p) (I.neg k))
    (quarter_line p part qi)).
Proof.
  intros Hq Ht Hi k. destruct (way_encl t i Ht Hi) as [A B]. fold k in A, B. assert (HN : d <> 0) by lra.
  assert (C := quarter_encl p part d Hd Hp q qi Hq). unfold jet_H2, along, weight_H2. cbv zeta. enclose.
Qed.
Theorem integral_H_encl n q qi : (0 < n)%nat -> inI q qi -> 0 < PI/2 + d * q < PI - u ->
  encl d {| at_U := tau_J u (PI/2 + d * q) / (u * u); at_0 := H_at_0 / 2; slope_0 := H_at_0 * (q + 2) / PI |}
    (integral_H p part n qi).
Proof.
  intros Hn Hq HJ. assert (P := PI_RGT_0). assert (D : 0 < d) by lra.
  assert (C : forall t, 0 <= t <= 1 -> continuous (integrand H u (PI/2 + d * q)) t).
  { intros t Ht. apply (integrand_continuous d q D HJ H t Ht). intros F HF. exact (proj1 (smooth d q HJ F HF)). }
  assert (V := integrand_H d q D HJ). fold u in V. assert (HB := H_base d q).
  unfold encl, integral_H, rise_of, bend_of, rise_of. cbn [zero first rise bend whole at_U at_0 slope_0].
  split; [apply H_at_0_in|]. split.
  { apply div_in; [|apply pi_in]. apply mul_in; [apply double_H_in | apply add_in; [exact Hq | apply fromZ_in]]. }
  split; [|split].
  - assert (I0 := H_rise d q D HJ). fold u in I0. rewrite <- I0. apply (slices_in rise _ _ (fun t => rise_of d (jet_H d q t))); [exact Hn | | |].
    + intros t Ht. apply continuous_raised; [exact D | now apply C].
    + intros t Ht. unfold raised. rewrite (V t Ht). unfold rise_of. rewrite (proj1 (HB t)). real. field. lra.
    + intros t i Ht Hi. apply (jet_H_encl q qi t i Hq Ht Hi).
  - assert (I0 := H_bend d q D HJ). fold u in I0. rewrite <- I0. apply (slices_in bend _ _ (fun t => bend_of d (jet_H d q t))); [exact Hn | | |].
    + intros t Ht. apply continuous_bent; [exact D | now apply C].
    + intros t Ht. unfold bent, raised. rewrite (V t Ht). unfold bend_of, rise_of. rewrite (proj1 (HB t)), (proj2 (HB t)).
      real. field. lra.
    + intros t i Ht Hi. apply (jet_H_encl q qi t i Hq Ht Hi).
  - assert (I0 := tau_J_mean d q D HJ). fold u in I0. rewrite <- I0. apply (slices_in whole _ _ (fun t => at_U (jet_H d q t))); [exact Hn | exact C | exact V |].
    intros t i Ht Hi. apply (jet_H_encl q qi t i Hq Ht Hi).
Qed.
Theorem integral_H2_in n q qi : (0 < n)%nat -> inI q qi -> 0 < PI/2 + d * q < PI - u ->
  inI ((tau_JJ u (PI/2 + d * q) / (u * u) - H_at_0 / PI) / d) (rise (integral_H2 p part n qi)) /\
  inI (tau_JJ u (PI/2 + d * q) / (u * u)) (whole (integral_H2 p part n qi)).
Proof.
  intros Hn Hq HJ. assert (P := PI_RGT_0). assert (D : 0 < d) by lra.
  assert (C : forall t, 0 <= t <= 1 -> continuous (integrand H2 u (PI/2 + d * q)) t).
  { intros t Ht. apply (integrand_continuous d q D HJ H2 t Ht). intros F HF. exact (proj2 (smooth d q HJ F HF)). }
  assert (V := integrand_H2 d q D HJ). fold u in V. assert (HB := H2_base d q).
  unfold integral_H2. cbn [rise whole]. split.
  - assert (I0 := H2_rise d q D HJ). fold u in I0. rewrite <- I0. apply (slices_in rise _ _ (fun t => rise_of d (jet_H2 d q t))); [exact Hn | | |].
    + intros t Ht. apply continuous_raised; [exact D | now apply C].
    + intros t Ht. unfold raised. rewrite (V t Ht). unfold rise_of. rewrite (HB t). real. field. lra.
    + intros t i Ht Hi. apply (jet_H2_encl q qi t i Hq Ht Hi).
  - assert (I0 := tau_JJ_mean d q D HJ). fold u in I0. rewrite <- I0. apply (slices_in whole _ _ (fun t => at_U (jet_H2 d q t))); [exact Hn | exact C | exact V |].
    intros t i Ht Hi. apply (jet_H2_encl q qi t i Hq Ht Hi).
Qed.

(** G3 and G4. *)
Lemma far_in z Q zi Qi : inI z zi -> inI Q Qi -> inI (G3 z Q) (far_3 p zi Qi) /\ inI (G4 z Q) (far_4 p zi Qi).
Proof.
  intros Hz HQ. assert (A := X.sqr_in p _ _ Hz). assert (R0 := X.sqrt_in p _ _ (sub_in p _ _ _ _ A (X.sqr_in p _ _ HQ))).
  assert (N := fun k => fromZ_in p k). unfold G3, G4, far_3, far_4. cbv zeta. change (sqrt (z * z - Q * Q)) with (Midpoint.root z Q) in R0.
  set (r := Midpoint.root z Q) in *. set (ri := I.sqrt p (I.sub p (I.sqr p zi) (I.sqr p Qi))) in *.
  assert (R2 := X.sqr_in p _ _ R0). assert (A2 := X.sqr_in p _ _ A).
  assert (R3 := mul_in p _ _ _ _ R0 R2). assert (R6 := X.sqr_in p _ _ R3). assert (R4 := X.sqr_in p _ _ R2).
  assert (R8 := X.sqr_in p _ _ R4).
  replace (z^4) with (z * z * (z * z)) by ring. replace (z^2) with (z * z) by ring. replace (z^5) with (z * (z * z * (z * z))) by ring.
  replace (z^3) with (z * (z * z)) by ring. replace (r^3) with (r * (r * r)) by ring.
  replace (r^7) with (r * (r * (r * r) * (r * (r * r)))) by ring. replace (r^5) with (r * (r * r * (r * r))) by ring.
  replace (r^9) with (r * (r * r * (r * r) * (r * r * (r * r)))) by ring.
  split; repeat match goal with
  | |- _ => assumption
  | |- inI (IZR _) _ => apply N
  | |- inI (_ + _) _ => apply add_in
  | |- inI (_ - _) _ => apply sub_in
  | |- inI (- _) _ => apply neg_in
  | |- inI (_ * _) _ => apply mul_in
  | |- inI (_ / _) _ => apply div_in
  end.
Qed.
End S.
End EndMoments.
