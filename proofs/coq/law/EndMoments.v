(** The moments and integrals of the end on slopes (law/EndSlopes.v has the definitions): they enclose.

    moment_sin_above == the integral of y sin y, to one term more
    slices_in        == a mean over the slices of t encloses an integral
    integral_H_encl, integral_H2_in == the integrals of EndIntegrals.v
    far_in           == G3 and G4
    moments_in       == all moments of EndShare.v *)
From Coq Require Import Reals ZArith Lra List.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Real.Xreal Float.Basic Float.Sig Interval.Interval Interval.Float Interval.Float_full.
From Dumbbell Require Import Signs Quotients Sines PiValue Clock Midpoint Defect Slopes Terms EndTerms EndAtZero
  EndShare
  EndIntegrals EndSlopes.
Local Open Scope R_scope.

Lemma moment_sin_above d : 0 <= d -> moment_sin d 1 <= d^3 / 3 - d^5 / 30 + d^7 / 840.
Proof.
  intros Hd. assert (S : is_RInt (fun y => y^1 * sin y) 0 d (moment_sin d 1)).
  { apply (RInt_correct (V := R_CompleteNormedModule)), (ex_RInt_continuous (V := R_CompleteNormedModule)).
    intros y _. apply (ex_derive_continuous (fun y => y^1 * sin y)). auto_derive. easy. }
  assert (P : is_RInt (fun y => y^2 - y^4 / 6 + y^6 / 120) 0 d (d^3 / 3 - d^5 / 30 + d^7 / 840)).
  { replace (d^3 / 3 - d^5 / 30 + d^7 / 840) with (minus (d^3 / 3 - d^5 / 30 + d^7 / 840) (0^3 / 3 - 0^5 / 30 + 0^7 /
    840))
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
  exact (mean_in p h g (fun i => let k := I.mul2 p i in field (f (sinc_slope p part (I.sqr p k)) (line p part (pi_i
    p) (I.neg k))))
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
  - assert (I0 := H_rise d q D HJ). fold u in I0. rewrite <- I0. apply (slices_in rise _ _ (fun t => rise_of d (jet_H
    d q t))); [exact Hn | | |].
    + intros t Ht. apply continuous_raised; [exact D | now apply C].
    + intros t Ht. unfold raised. rewrite (V t Ht). unfold rise_of. rewrite (proj1 (HB t)). real. field. lra.
    + intros t i Ht Hi. apply (jet_H_encl q qi t i Hq Ht Hi).
  - assert (I0 := H_bend d q D HJ). fold u in I0. rewrite <- I0. apply (slices_in bend _ _ (fun t => bend_of d (jet_H
    d q t))); [exact Hn | | |].
    + intros t Ht. apply continuous_bent; [exact D | now apply C].
    + intros t Ht. unfold bent, raised. rewrite (V t Ht). unfold bend_of, rise_of. rewrite (proj1 (HB t)), (proj2 (HB
      t)).
      real. field. lra.
    + intros t i Ht Hi. apply (jet_H_encl q qi t i Hq Ht Hi).
  - assert (I0 := tau_J_mean d q D HJ). fold u in I0. rewrite <- I0. apply (slices_in whole _ _ (fun t => at_U (jet_H
    d q t))); [exact Hn | exact C | exact V |].
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
  - assert (I0 := H2_rise d q D HJ). fold u in I0. rewrite <- I0. apply (slices_in rise _ _ (fun t => rise_of d
    (jet_H2 d q t))); [exact Hn | | |].
    + intros t Ht. apply continuous_raised; [exact D | now apply C].
    + intros t Ht. unfold raised. rewrite (V t Ht). unfold rise_of. rewrite (HB t). real. field. lra.
    + intros t i Ht Hi. apply (jet_H2_encl q qi t i Hq Ht Hi).
  - assert (I0 := tau_JJ_mean d q D HJ). fold u in I0. rewrite <- I0. apply (slices_in whole _ _ (fun t => at_U
    (jet_H2 d q t))); [exact Hn | exact C | exact V |].
    intros t i Ht Hi. apply (jet_H2_encl q qi t i Hq Ht Hi).
Qed.

(** G3 and G4. *)
Lemma far_in z Q zi Qi : inI z zi -> inI Q Qi -> inI (G3 z Q) (far_3 p zi Qi) /\ inI (G4 z Q) (far_4 p zi Qi).
Proof.
  intros Hz HQ. assert (A := X.sqr_in p _ _ Hz). assert (R0 := X.sqrt_in p _ _ (sub_in p _ _ _ _ A (X.sqr_in p _ _
    HQ))).
  assert (N := fun k => fromZ_in p k). unfold G3, G4, far_3, far_4. cbv zeta. change (sqrt (z * z - Q * Q)) with
    (Midpoint.root z Q) in R0.
  set (r := Midpoint.root z Q) in *. set (ri := I.sqrt p (I.sub p (I.sqr p zi) (I.sqr p Qi))) in *.
  assert (R2 := X.sqr_in p _ _ R0). assert (A2 := X.sqr_in p _ _ A).
  assert (R3 := mul_in p _ _ _ _ R0 R2). assert (R6 := X.sqr_in p _ _ R3). assert (R4 := X.sqr_in p _ _ R2).
  assert (R8 := X.sqr_in p _ _ R4).
  replace (z^4) with (z * z * (z * z)) by ring. replace (z^2) with (z * z) by ring. replace (z^5) with (z * (z * z *
    (z * z))) by ring.
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

(** All moments at once: Q = pi/2 + q d, J = pi/2 + j d. *)
Lemma somewhere_in g a b x g_i : somewhere g a b x -> (forall z, a <= z <= b -> inI (g z) g_i) -> inI x g_i.
Proof. intros [z [z' [Z [Z' B]]]] G. exact (contains_connected (I.convert g_i) (g z) (g z') (G z Z) (G z' Z') x B).
  Qed.
Lemma share_in x lo hi w_i : inI lo w_i -> inI hi w_i -> lo <= x <= hi -> inI x w_i.
Proof. intros L U B. exact (contains_connected (I.convert w_i) lo hi L U x B). Qed.
Section Moments.
Variables (n1 n2 : nat) (khi qi xi : I.type) (q j kh ab a3 a4 s X : R).
Let F := PI - d.
Let Q := PI/2 + d * q.
Let J := PI/2 + d * j.
Hypothesis Hn : (0 < n1)%nat /\ (0 < n2)%nat.
Hypothesis HQ : 0 < Q < PI - u.
Hypothesis HJ : 0 < J < PI - u.
Hypothesis Hk : inI kh khi.
Hypothesis Hab : 1 <= ab <= 1 + d * d * kh * (d * d * kh).
Hypothesis Hq : inI q qi.
Hypothesis Hx : inI q xi /\ inI j xi.
Hypothesis H3 : somewhere (fun z => G3 z Q) (F - d) (F + d) a3.
Hypothesis H4 : somewhere (fun z => G4 z Q) (F - d) (F + d) a4.
Hypothesis Hs : 0 <= s <= 1.
Hypothesis HX : X = tau_JJ u J + s * (tau_JJ u Q - tau_JJ u J).
Let m := moment_jets d q ab (moment_cos d 2) (moment_cos d 4 * a4 / 12) (moment_sin d 1) (moment_sin d 3 * a3 / 6)
  (tau_J u Q / (u * u)) (X / (u * u)).
Lemma moments_in : moments_encl d m (moment_slopes p part n1 n2 khi qi xi).
Proof.
  assert (P := pi_value). assert (HN : d <> 0) by lra.
  assert (D2 := d2_in p part d Hp). assert (DD : 0 < d * d) by pos. assert (D3 : 0 < d^3) by pos. assert (D5 : 0 <
    d^5) by pos.
  destruct (moments_between d ltac:(lra)) as [M2 [M4 [N1 N3]]].
  assert (QI : inI Q (I.add p (I.div p (pi_i p) (I.fromZ p 2)) (I.mul p part qi))).
  { apply add_in; [apply div_in; [apply pi_in | apply fromZ_in] | now apply mul_in]. }
  assert (FI : forall z, F - d <= z <= F + d -> inI z (I.add p (I.sub p (pi_i p) part) (I.join (I.neg part) part))).
  { intros z Hz. replace z with (PI - d + (z - (PI - d))) by ring. apply add_in; [apply sub_in; [apply pi_in | exact
    Hp]|].
    apply (join_in (- d) d); [now apply neg_in | exact Hp | unfold F in Hz; lra]. }
  assert (A3 := somewhere_in _ _ _ _ _ H3 (fun z Hz => proj1 (far_in z Q _ _ (FI z Hz) QI))).
  assert (A4 := somewhere_in _ _ _ _ _ H4 (fun z Hz => proj2 (far_in z Q _ _ (FI z Hz) QI))).
  constructor; unfold m, moment_jets, moment_slopes; cbn [tabove tI2 tI4 tJ1 tJ3 tg1 tg2].
  - apply curve_encl; [exact HN | exact Hp | apply fromZ_in|].
    apply (join_in 0 (d * d * (kh * kh))); [exact zero_in | apply mul_in; [exact D2 | now apply X.sqr_in]|].
    split; [apply quotient_at_least | apply quotient_at_most]; lra.
  - apply curve_encl; [exact HN | exact Hp | apply div_in; apply fromZ_in|].
    apply (share_in _ (- (1 / 10 * 1)) (- (1 / 10 * 0))).
    1, 2: apply neg_in, mul_in; [apply div_in; apply fromZ_in | apply unit_in; lra].
    split; [apply quotient_at_least | apply quotient_at_most]; try exact DD.
    + assert (1/3 - 1/10 * (d * d) <= moment_cos d 2 / d^3); [|lra]. apply quotient_at_least; [exact D3|]. lra.
    + assert (moment_cos d 2 / d^3 <= 1/3); [|lra]. apply quotient_at_most; [exact D3|]. lra.
  - apply curve_encl; [exact HN | exact Hp | exact zero_in|].
    replace (moment_cos d 4 * a4 / 12 / d^3 / (d * d)) with (moment_cos d 4 / d^5 * 5 / 5 * a4 / 12) by (field; lra).
    apply div_in; [|apply fromZ_in]. apply mul_in; [|exact A4]. apply div_in; [|apply fromZ_in].
    apply (join_in (1 - d * d / 2) 1); [apply sub_in; [apply fromZ_in | apply div_in; [exact D2 | apply fromZ_in]] |
      apply fromZ_in|].
    replace (moment_cos d 4 / d^5 * 5) with (moment_cos d 4 * 5 / d^5) by (field; lra).
    split; [apply quotient_at_least | apply quotient_at_most]; lra.
  - apply curve_encl; [exact HN | exact Hp | apply div_in; apply fromZ_in|].
    apply (share_in _ (- (1 / 30 * (1 - d * d / 28 * 0))) (- (1 / 30 * (1 - d * d / 28 * 1)))).
    1, 2: apply neg_in, mul_in; [apply div_in; apply fromZ_in|]; apply sub_in; [apply fromZ_in|];
      apply mul_in; [apply div_in; [exact D2 | apply fromZ_in] | apply unit_in; lra].
    assert (U := moment_sin_above d ltac:(lra)).
    split; [apply quotient_at_least | apply quotient_at_most]; try exact DD.
    + assert (1/3 - 1/30 * (d * d) <= moment_sin d 1 / d^3); [|lra]. apply quotient_at_least; [exact D3|]. lra.
    + assert (moment_sin d 1 / d^3 <= 1/3 - 1/30 * (1 - d * d / 28) * (d * d)); [|lra]. apply quotient_at_most;
      [exact D3|]. lra.
  - apply curve_encl; [exact HN | exact Hp | exact zero_in|].
    replace (moment_sin d 3 * a3 / 6 / d^3 / (d * d)) with (moment_sin d 3 / d^5 * 5 / 5 * a3 / 6) by (field; lra).
    apply div_in; [|apply fromZ_in]. apply mul_in; [|exact A3]. apply div_in; [|apply fromZ_in].
    apply (join_in (1 - d * d / 6) 1); [apply sub_in; [apply fromZ_in | apply div_in; [exact D2 | apply fromZ_in]] |
      apply fromZ_in|].
    replace (moment_sin d 3 / d^5 * 5) with (moment_sin d 3 * 5 / d^5) by (field; lra).
    split; [apply quotient_at_least | apply quotient_at_most]; lra.
  - apply integral_H_encl; [apply Hn | exact Hq | exact HQ].
  - assert (R1 := integral_H2_in n2 q xi (proj2 Hn) (proj1 Hx) HQ). fold Q in R1.
    assert (R2 := integral_H2_in n2 j xi (proj2 Hn) (proj2 Hx) HJ). fold J in R2.
    assert (U0 : 0 < u) by (unfold u; lra). assert (UU : 0 < u * u) by pos. assert (H0 := H_at_0_in p). assert (PP :=
      pi_in p).
    assert (EX : X / (u * u) = (1 - s) * (tau_JJ u J / (u * u)) + s * (tau_JJ u Q / (u * u))) by (rewrite HX; field;
      lra).
    set (gJ := tau_JJ u J / (u * u)) in *. set (gQ := tau_JJ u Q / (u * u)) in *.
    assert (W : forall i gJ gQ g, inI gJ i -> inI gQ i -> g = (1 - s) * gJ + s * gQ -> inI g i).
    { intros w a b g Ha Hb ->. destruct (Rle_dec a b) as [L|L].
      - assert (0 <= s * (b - a)) by pos. assert (0 <= (1 - s) * (b - a)) by pos. apply (share_in _ a b); [exact Ha |
        exact Hb | lra].
      - assert (0 <= s * (a - b)) by pos. assert (0 <= (1 - s) * (a - b)) by pos. apply (share_in _ b a); [exact Hb |
        exact Ha | lra]. }
    assert (Rr : inI ((X / (u * u) - H_at_0 / PI) / d) (rise (integral_H2 p part n2 xi)))
      by (apply (W _ _ _ _ (proj1 R2) (proj1 R1)); rewrite EX; field; lra).
    assert (Rw : inI (X / (u * u)) (whole (integral_H2 p part n2 xi))) by (exact (W _ _ _ _ (proj2 R2) (proj2 R1)
      EX)).
    unfold encl, bend_of, rise_of. cbn [at_U at_0 slope_0]. split; [|split; [exact Rr | split; [exact Rr | split;
      [|exact Rw]]]].
    + unfold integral_H2. cbn [zero]. apply div_in; [apply double_H_in | exact PP].
    + replace (((X / (u * u) - H_at_0 / PI) / d - (X / (u * u) - H_at_0 / PI) / d) / d) with 0 by (field; lra). exact
      zero_in.
Qed.
End Moments.
End S.
End EndMoments.
