(** What the checker of a leaf encloses besides the rule's formulas: the second order in J,
  what cancels in the integrals,
    and what Taylor leaves of E1.

    second_start, second_at == a part of tau_JJ, at U = 0 and at U
    second_in    == tau_JJ's rise is enclosed
    unit_of      == so are numbers of [0, 1]
    both_in      == (mu - 2 (1 + rho) g1)/(1 - rho) is, with its start as it is known from L50
    moment_in    == so are the rests of I2 and J1
    middle_in    == and of E1 *)
From Coq Require Import Reals ZArith Lra Lia List Bool.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Real.Xreal Float.Basic Float.Sig Interval.Interval Interval.Float Interval.Float_full.
From Dumbbell Require Import Quotients PiValue LawStatement Falls Ends Sizes Cubes Clock Midpoint Defect Differences
  Comparison Slopes Calculus LayerRule
  LayerRelated LayerValues LayerStart NodeRule LayerIntegrals LayerRests LayerPlace LayerState LayerLeaf
  LayerSound.
Import ListNotations.
Local Open Scope R_scope.

Lemma second_start U k x1 : at_0 (second_order (exact U) k (jline U (PI / 2) x1)) = 2 * h0.
Proof.
  destruct root3 as [T [T0 [T1 P]]]. destruct (start_radicand U k (jline U (PI / 2) x1) x1 ltac:(split;
    reflexivity)) as [K1 K2].
  unfold second_order, s_H2. cbn [s_sinc exact s_mul s_inv s_line s_root s_sub s_sqr s_scale n_neg n_pi n_Z].
  set (R := jsub _ _) in *. destruct K1 as [K1 _], K2 as [K2 _].
  cbn [jmul jinv jsqrt jsqr jscale s_curve jcurve jline at_0]. change (sqrt (at_0 R)) with (at_0 (jsqrt R)).
  rewrite K1, K2. unfold h0.
  cbn. field. lra.
Qed.
Lemma second_at U x x1 : 0 < U -> 0 < x -> let X := PI / 2 + U * x1 in 0 < X < PI - x ->
  at_U (second_order (exact U) (x / U) (jline U (PI / 2) x1)) = kernel (fun F => H2 F X) x.
Proof.
  intros HU Hx X HX. unfold second_order, s_H2.
  rewrite sinc_jet by (replace (x / U * U) with x by (field; lra); exact Hx).
  cbn [s_mul s_inv s_line s_root s_sub s_sqr s_scale exact jmul jinv jline jsqrt jsub jsqr jscale at_U n_neg n_pi
    n_Z].
  fold X. replace (PI + U * - (x / U)) with (PI - x) by (field; lra). replace (x / U * U) with x by (field; lra).
  unfold kernel, H2, root. destruct (radicand (PI - x) X HX) as [A B]. assert (S := sqrt_sqrt _ (Rlt_le _ _ A)).
  set (r := sqrt _) in *. rewrite <- S. field. lra.
Qed.
Lemma tau_JJ_ready u j : 0 <= u -> 0 < j < PI - u -> forall a b, 0 <= a -> a <= b <= u -> ex_RInt (fun x =>
  sin x * H2 (PI - x) j) a b.
Proof.
  intros Hu Hj x y Hx Hy. apply (ex_RInt_Chasles_2 (V := R_CompleteNormedModule) (fun x =>
    sin x * H2 (PI - x) j) 0 x y ltac:(lra)).
  apply weight_integrable; [lra | lra |]. intros F HF. exact (proj2 (H_smooth j F ltac:(lra))).
Qed.

Module LayerPieces (F : FloatOps with Definition sensible_format := true).
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
  assert (E : (tau_JJ w X / w^2 - 2 * h0 / 2) / U = _) by exact (second_is (fun F =>
    H2 F X) U w (2 * h0) 8 U0 Hw ltac:(lia) Rd whole_way).
  replace (2 * h0 / 2) with h0 in E by field. rewrite E. unfold rise_of_second.
  assert (HX' : encl U (jline U (PI / 2) x1) (line p Ui (c_half_pi c) xi)).
  { apply (line_encl p U (Rgt_not_eq _ _ U0)); [exact HU | exact (proj1 (proj2 (proj2 (constants_in p)))) | exact Hx].
    }
  assert (Hall : forall i, In i (upto 0 8) -> (0 <= i < 8)%Z).
  { intros i Hin. unfold upto in Hin. apply in_map_iff in Hin. destruct Hin as [k [<- Hk']]. apply in_seq in Hk'. lia.
    }
  change (c_parts c) with (map (fun i => (I.join (frac i 8) (frac (i + 1) 8),
    frac (2 * i + 1) (2 * 8 * 8)))%Z (upto 0 8)).
  change (upto 0 (Z.to_nat 8)) with (upto 0 8). revert Hall. generalize (upto 0 8).
  intros l. induction l as [|i l IH]; intros Hall; cbn [map fold_right]; [apply zero_in|].
  apply add_in; [|apply IH; intros k Hk'; apply Hall; now right]. apply mul_in; [|apply frac_in].
  assert (Hi := Hall i ltac:(now left)). apply (mean_in _ _ _ _ (part_rise_mean (fun F =>
    H2 F X) U w (2 * h0) 8 U0 Hw ltac:(lia) Rd i Hi)).
  intros x Hxi. assert (C0 := cuts_range w 8 Hw ltac:(lia) i ltac:(lia)).
  assert (C1 := cuts_range w 8 Hw ltac:(lia) (i + 1) ltac:(lia)).
  cbv beta in C0, C1.
  assert (Ht : inI (x / U) (I.mul p ki (I.join (frac i 8) (frac (i + 1) 8)))).
  { replace (x / U) with (kf * (x / w)) by (rewrite <- Ew; field; split; [lra | intros E0;
    rewrite E0, Rmult_0_l in Ew; lra]).
    apply mul_in; [exact Hk|]. apply (join_in (IZR i / IZR 8) (IZR (i + 1) / IZR 8));
      [apply frac_in | apply frac_in |].
    fold (cut 8 i) (cut 8 (i + 1)). split; [apply quotient_at_least | apply quotient_at_most]; lra. }
  assert (R := r_second_order C C' inI (encl U) rel _ _ _ _ HX' Ht). destruct R as (_ & _ & R & _).
  unfold rise_of in R. unfold C in R. rewrite second_start in R. rewrite (second_at U x x1 U0 ltac:(lra)) in R;
    [exact R | fold X; lra].
Qed.
End Bounds.


Section Leaf.
Variable p : F.precision.
Notation frac a b := (I.div p (I.fromZ p a) (I.fromZ p b)).
Let c := make_constants p 12 8.
Variables eps u al u' al' : R.
Hypothesis HL : layer_step eps u al u' al'.
Let U := middle u u'.
Let d := half u u'.
Let rho := d / U.
Let Q := middle_invariant eps u al u'.
Let q := (Q - PI / 2) / (rho * rho * U).
Let C := exact U.
Variables Ui ri : I.type.
Hypothesis HU : inI U Ui.
Hypothesis Hr : inI rho ri.
Let C' := enclosing p (c_table c) Ui.
Let Hne : U <> 0 := U_not_0 eps u al u' al' HL.
Let rel : related C C' inI (encl U) := Hrel p eps u al u' al' HL Ui HU.
Let Qj := jline U (PI / 2) (rho * rho * q).
Let nodes := nodes_of 12.


Lemma unit_of t : 0 <= t <= 1 -> inI t (t_unit (c_table c)).
Proof. intros Ht. exact (unit_in p t Ht). Qed.
Lemma both_in Qi mi wi : encl U Qj Qi -> let mean := mean_of C rho Qj (mean_rest eps u al u') in
  let way := way_of C rho nodes Qj (tau_J_rest eps u al u' 12) in encl U mean mi -> encl U way wi ->
  encl U (both_of C rho mean way) (both_anchored p c Qi (both_of C' ri mi wi)).
Proof.
  intros HQi mean way Hm Hw. assert (B := r_both C C' inI (encl U) rel rho ri Hr _ _ _ _ Hm Hw).
  facts (layer_facts _ _ _ _ _ HL). fold U d in F_U, F_rho. fold rho in F_rho. assert (P := PI_RGT_0).
  assert (HP := pi_in p). fold c in HP.
  destruct (start_both U rho q F_rho nodes half_way (mean_rest eps u al u') (tau_J_rest eps u al u' 12)) as [B0 B1].
  destruct (start_of_H U rho q) as [[S0 S1] ST].
  set (Ri := shift p (neg (sqr p Qi)) (I.sqr p (t_pi (c_table c)))). set (r3 := inv p (mul p Ri (root p Ri))).
  assert (HR : encl U (jshift (jneg (jsqr Qj)) (PI * PI)) Ri)
    by (apply shift_encl; [exact Hne | apply neg_encl; [exact Hne | now apply sqr_encl] | now apply sqr_in]).
  assert (H3 : encl U (R3 U rho q) r3)
    by (apply inv_encl; [exact Hne|]; apply mul_encl; [exact Hne | exact HR | now apply root_encl]).
  assert (HT : encl U (turn U rho q)
    (sub p (scale p (mul p r3 (inv p Ri)) (I.mul p (I.fromZ p 3) (I.sqr p (t_pi (c_table c))))) r3)).
  { apply sub_encl; [exact Hne | apply scale_encl; [exact Hne | |] | exact H3].
    - apply mul_encl; [exact Hne | exact H3 | now apply inv_encl].
    - apply mul_in; [apply Z_in | now apply sqr_in]. }
  assert (HA := scale_encl p U Hne _ _ _ _ H3 HP). destruct HA as (A0 & A1 & _). destruct HT as (T0 & _).
  rewrite S0 in A0. rewrite S1 in A1. rewrite ST in T0. destruct B as (_ & _ & B2 & B3 & B4).
  split; [|split; [|split; [exact B2|split; [exact B3 | exact B4]]]].
  - replace (at_0 (both_of C rho mean way)) with H0 by (symmetry; exact B0). exact A0.
  - replace (slope_0 (both_of C rho mean way)) with (2 * (rho * rho * q) * H0 / PI + 4 / 3 * (3 * H0 / PI))
      by (transitivity (H0 * (2 * (rho * rho * q) + 4) / PI); [field; lra | symmetry; exact B1]).
    apply (add_in p); [exact A1 | apply mul_in; [apply frac_in | exact T0]].
Qed.

Variable r2 : I.type.
Hypothesis Hr2 : inI (rho * rho) r2.
Lemma moment_in w n : (0 < n)%Z -> - ((d / U)^2 / IZR n) <= w <= 0 ->
  inI w (I.neg (I.mul p (I.div p r2 (I.fromZ p n)) (t_unit (c_table c)))).
Proof.
  intros Hn Hw. apply IZR_lt in Hn. facts (layer_facts _ _ _ _ _ HL). fold U d in F_rho, F_U, F_d.
  assert (rr : 0 < (d / U)^2) by (apply pow_lt; exact (proj1 F_rho)).
  assert (A : 0 < (d / U)^2 / IZR n) by (now apply Rdiv_lt_0_compat).
  replace w with (- ((d / U)^2 / IZR n * (- w / ((d / U)^2 / IZR n)))) by (field; repeat split; lra).
  apply neg_in, mul_in.
  - change (d / U) with rho. replace (rho^2) with (rho * rho) by ring. apply div_in; [exact Hr2 | apply Z_in].
  - apply unit_of. split; [apply quotient_at_least | apply quotient_at_most]; lra.
Qed.
Variables d2i Qat fari wS wC : I.type.
Hypothesis Hd2 : inI (d * d) d2i.
Hypothesis HQat : inI Q Qat.
Hypothesis Hfar : forall z, PI - U - d <= z <= PI - U + d -> inI z fari.
Hypothesis HS : inI (sin U) wS.
Hypothesis HC : inI (cos U) wC.
Let weight k := I.mul p (I.div p r2 (I.fromZ p 5)) (I.sub p (I.fromZ p 1) (I.mul p (I.mul p d2i (frac 1 k)) (t_unit
  (c_table c)))).
Lemma weight_in w k : (0 < k)%Z -> (d / U)^2 / 5 * (1 - d^2 / IZR k) <= w <= (d / U)^2 / 5 -> inI w (weight k).
Proof.
  intros Hk Hw. apply IZR_lt in Hk. facts (layer_facts _ _ _ _ _ HL). fold U d in F_rho, F_d.
  assert (rr : 0 < (d / U)^2) by (apply pow_lt; exact (proj1 F_rho)). assert (dd : 0 < d^2) by (apply pow_lt; lra).
  destruct (share_of w ((d / U)^2 / 5) (d^2 / IZR k) ltac:(lra) ltac:(now apply Rdiv_lt_0_compat) Hw) as [t [Ht ->]].
  apply mul_in.
  - change (d / U) with rho. replace (rho^2) with (rho * rho) by ring. apply div_in; [exact Hr2 | apply Z_in].
  - apply sub_in; [apply Z_in|]. apply mul_in; [|now apply unit_of].
    replace (d^2 / IZR k) with (d * d * (1 / IZR k)) by (field; lra). apply mul_in; [exact Hd2 | apply frac_in].
Qed.
Theorem middle_in : inI (middle_rest U d Q)
  (I.sub p (I.mul p wS (I.div p (I.mul p (weight 2) (n_G4 C' fari Qat)) (I.fromZ p 12)))
    (I.mul p wC (I.div p (I.mul p (weight 6) (n_G3 C' fari Qat)) (I.fromZ p 3)))).
Proof.
  facts (layer_facts _ _ _ _ _ HL). fold U d Q in F_U, F_d, F_Q, F_J, F_uU. assert (P := PI2_1).
  destruct (weights U d ltac:(lra) ltac:(lra)) as [W4 W3].
  assert (H4 := weight_in (weight4 U d) 2 ltac:(lia) W4). assert (H3 := weight_in (weight3 U d) 6 ltac:(lia) W3).
  destruct (middle_rest_between U d Q ltac:(lra) ltac:(lra) ltac:(lra)) as (a & b & a' & b' & Hz & Hb).
  assert (K : forall a b, PI - U - d <= a <= PI - U + d -> PI - U - d <= b <= PI - U + d ->
    inI (sin U * (weight4 U d * G4 a Q / 12) - cos U * (weight3 U d * G3 b Q / 3))
      (I.sub p (I.mul p wS (I.div p (I.mul p (weight 2) (n_G4 C' fari Qat)) (I.fromZ p 12)))
        (I.mul p wC (I.div p (I.mul p (weight 6) (n_G3 C' fari Qat)) (I.fromZ p 3))))).
  { intros x y Hx Hy. destruct (kernels_are U x Q ltac:(lra)) as (_ & _ & _ & _ & E4 & _).
    destruct (kernels_are U y Q ltac:(lra)) as (_ & _ & _ & E3 & _). rewrite <- E4, <- E3.
    apply sub_in; (apply mul_in; [assumption|]); (apply div_in; [|apply Z_in]); apply mul_in;
      [exact H4 | | exact H3 |].
    - apply (r_G4 C C' inI (encl U) rel); [now apply Hfar | exact HQat].
    - apply (r_G3 C C' inI (encl U) rel); [now apply Hfar | exact HQat]. }
  refine (between_in _ _ _ _ (K a b _ _) (K a' b' _ _) Hb); apply Hz; tauto.
Qed.
End Leaf.
End LayerPieces.
