(** A leaf that passes [slope_leaf] has the conditions (C6) and (C7) at each of its steps.

    layer_bounds                == (C6) and (C7) of one step
    H2_at_0                     == H2 at U = 0
    LayerBounds.second_in       == tau_JJ's rise is enclosed
    LayerBounds.slope_leaf_sound == the leaf's bounds are those of the law *)
From Coq Require Import Reals ZArith Lra Lia List Bool.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Real.Xreal Float.Basic Float.Sig Interval.Interval Interval.Float Interval.Float_full.
From Dumbbell Require Import LawStatement Falls Ends Sizes Cubes Clock Midpoint Defect Differences Comparison Slopes Calculus LayerRule
  LayerRelated LayerValues LayerStart NodeRule LayerIntegrals LayerRests LayerPlace LayerState LayerLeaf LayerSound.
Import ListNotations.
Local Open Scope R_scope.

Definition layer_bounds eps u al u' al' := let T := clock eps u al in let y := place eps T in let Delta := difference T in
  comparison eps T * (1 - y * (5 / (3 * PI) + 0.125 * y + 0.45 * Delta^2)) <= defect eps u al u' al' <=
    comparison eps T * (1 - y * (5 / (3 * PI) - 0.155 * y - 0.43 * Delta^2)).

Lemma second_start U k x1 : at_0 (second_order (exact U) k (jline U (PI / 2) x1)) = 2 * h0.
Proof.
  destruct root3 as [T [T0 [T1 P]]]. destruct (start_radicand U k (jline U (PI / 2) x1) x1 ltac:(split; reflexivity)) as [K1 K2].
  unfold second_order, s_H2. cbn [s_sinc exact s_mul s_inv s_line s_root s_sub s_sqr s_scale n_neg n_pi n_Z].
  set (R := jsub _ _) in *. destruct K1 as [K1 _], K2 as [K2 _].
  cbn [jmul jinv jsqrt jsqr jscale s_curve jcurve jline at_0]. change (sqrt (at_0 R)) with (at_0 (jsqrt R)). rewrite K1, K2. unfold h0.
  cbn. field. lra.
Qed.
Lemma second_at U x x1 : 0 < U -> 0 < x -> let X := PI / 2 + U * x1 in 0 < X < PI - x ->
  at_U (second_order (exact U) (x / U) (jline U (PI / 2) x1)) = kernel (fun F => H2 F X) x.
Proof.
  intros HU Hx X HX. unfold second_order, s_H2.
  rewrite sinc_jet by (replace (x / U * U) with x by (field; lra); exact Hx).
  cbn [s_mul s_inv s_line s_root s_sub s_sqr s_scale exact jmul jinv jline jsqrt jsub jsqr jscale at_U n_neg n_pi n_Z].
  fold X. replace (PI + U * - (x / U)) with (PI - x) by (field; lra). replace (x / U * U) with x by (field; lra).
  unfold kernel, H2, root. destruct (radicand (PI - x) X HX) as [A B]. assert (S := sqrt_sqrt _ (Rlt_le _ _ A)).
  set (r := sqrt _) in *. rewrite <- S. field. lra.
Qed.
Lemma tau_JJ_ready u j : 0 <= u -> 0 < j < PI - u -> forall a b, 0 <= a -> a <= b <= u -> ex_RInt (fun x => sin x * H2 (PI - x) j) a b.
Proof.
  intros Hu Hj x y Hx Hy. apply (ex_RInt_Chasles_2 (V := R_CompleteNormedModule) (fun x => sin x * H2 (PI - x) j) 0 x y ltac:(lra)).
  apply weight_integrable; [lra | lra |]. intros F HF. exact (proj2 (H_smooth j F ltac:(lra))).
Qed.

Module LayerBounds (F : FloatOps with Definition sensible_format := true).
Module Export N := LayerSound F.
Section Bounds.
Variable p : F.precision.
Notation frac a b := (I.div p (I.fromZ p a) (I.fromZ p b)).
Let c := make_constants p 12 8.
Variables U : R.
Variables Ui : I.type.
Hypothesis U0 : 0 < U.
Hypothesis HU : inI U Ui.
Let C := exact U.
Let C' := enclosing p (c_table c) Ui.
Let rel : related C C' inI (encl U) := enclosing_related p U Ui (Rgt_not_eq _ _ U0) HU.

Lemma second_in w kf ki x1 xi : 0 < w -> kf * U = w -> inI kf ki -> inI x1 xi -> 0 < PI / 2 + U * x1 < PI - w ->
  inI ((tau_JJ w (PI / 2 + U * x1) / w^2 - h0) / U) (rise_of_second p c Ui ki xi).
Proof.
  intros Hw Ew Hk Hx HX. set (X := PI / 2 + U * x1) in *.
  assert (Rd := tau_JJ_ready w X ltac:(lra) ltac:(lra)).
  assert (E : (tau_JJ w X / w^2 - 2 * h0 / 2) / U = _) by exact (second_is (fun F => H2 F X) U w (2 * h0) 8 U0 Hw ltac:(lia) Rd whole_way).
  replace (2 * h0 / 2) with h0 in E by field. rewrite E. unfold rise_of_second.
  assert (HX' : encl U (jline U (PI / 2) x1) (line p Ui (c_half_pi c) xi)).
  { apply (line_encl p U (Rgt_not_eq _ _ U0)); [exact HU | exact (proj1 (proj2 (proj2 (constants_in p)))) | exact Hx]. }
  assert (Hall : forall i, In i (upto 0 8) -> (0 <= i < 8)%Z).
  { intros i Hin. unfold upto in Hin. apply in_map_iff in Hin. destruct Hin as [k [<- Hk']]. apply in_seq in Hk'. lia. }
  change (c_parts c) with (map (fun i => (I.join (frac i 8) (frac (i + 1) 8), frac (2 * i + 1) (2 * 8 * 8)))%Z (upto 0 8)).
  change (upto 0 (Z.to_nat 8)) with (upto 0 8). revert Hall. generalize (upto 0 8).
  intros l. induction l as [|i l IH]; intros Hall; cbn [map fold_right]; [apply zero_in|].
  apply add_in; [|apply IH; intros k Hk'; apply Hall; now right]. apply mul_in; [|apply frac_in].
  assert (Hi := Hall i ltac:(now left)). apply (mean_in _ _ _ _ (part_rise_mean (fun F => H2 F X) U w (2 * h0) 8 U0 Hw ltac:(lia) Rd i Hi)).
  intros x Hxi. assert (C0 := cuts_range w 8 Hw ltac:(lia) i ltac:(lia)). assert (C1 := cuts_range w 8 Hw ltac:(lia) (i + 1) ltac:(lia)).
  cbv beta in C0, C1.
  assert (Ht : inI (x / U) (I.mul p ki (I.join (frac i 8) (frac (i + 1) 8)))).
  { replace (x / U) with (kf * (x / w)) by (rewrite <- Ew; field; split; [lra | intros E0; rewrite E0, Rmult_0_l in Ew; lra]).
    apply mul_in; [exact Hk|]. apply (join_in (IZR i / IZR 8) (IZR (i + 1) / IZR 8)); [apply frac_in | apply frac_in |].
    fold (cut 8 i) (cut 8 (i + 1)). split; [apply quotient_at_least | apply quotient_at_most]; lra. }
  assert (R := r_second_order C C' inI (encl U) rel _ _ _ _ HX' Ht). destruct R as (_ & _ & R & _).
  unfold rise_of in R. unfold C in R. rewrite second_start in R. rewrite (second_at U x x1 U0 ltac:(lra)) in R; [exact R | fold X; lra].
Qed.
End Bounds.
End LayerBounds.
