(** A leaf that passes [slope_leaf] has the conditions (C6) and (C7) at each of its steps.

    layer_bounds                == (C6) and (C7) of one step
    slope_leaf_sound            == the leaf's bounds are those of the law *)
From Coq Require Import Reals ZArith Lra Lia List Bool.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Real.Xreal Float.Basic Float.Sig Interval.Interval Interval.Float Interval.Float_full.
From Dumbbell Require Import Quotients PiValue LawStatement Falls Ends Sizes Cubes Clock Midpoint Defect Differences
  Comparison Slopes Calculus LayerRule
  LayerRelated LayerValues LayerStart NodeRule LayerIntegrals LayerRests LayerPlace LayerState LayerLeaf
  LayerSound LayerPieces.
Import ListNotations.
Local Open Scope R_scope.

Definition layer_bounds eps u al u' al' := let T := clock eps u al in let y := place eps T in
  let Delta := difference T in
  comparison eps T * (1 - y * (5 / (3 * PI) + 0.125 * y + 0.45 * Delta^2)) <= defect eps u al u' al' <=
    comparison eps T * (1 - y * (5 / (3 * PI) - 0.155 * y - 0.43 * Delta^2)).

Module LayerBounds (F : FloatOps with Definition sensible_format := true).
Module Export O := LayerPieces F.
Definition implies (P : Prop) (b : bool) := b = true -> P.
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
Let J := invariant u al.
Let J' := invariant u' al'.
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

Theorem slope_leaf_sound : slope_leaf p c Ui ri = true -> layer_bounds eps u al u' al'.
Proof.
  change (implies (layer_bounds eps u al u' al') (slope_leaf p c Ui ri)). cbv beta delta [slope_leaf].
  facts (layer_facts _ _ _ _ _ HL). fold U d Q J J' in F_U, F_d, F_J, F_J', F_Q, F_rU, F_rho, F_uU, F_uU'.
  fold rho in F_rU, F_rho.
  assert (P := pi_value). assert (AQ := at_Q eps u al u' al' HL). fold U d rho Q q Qj in AQ.
  destruct (constants_in p) as (Kn & Ks & Kh & Kc & K0). fold c in Kn, Ks, Kh, Kc, K0.
  assert (Z := Z_in p). assert (Fr := frac_in p). assert (HP := pi_in p). fold c in HP.
  fold C'.
  take qi. assert (Hq : inI q qi).
  { apply (refined_in p eps u al u' al' HL Ui ri HU Hr). apply (offset_in p eps u al u' al' HL Ui ri HU Hr (jline U Q
    0));
      [unfold Q; apply (at_crude eps u al u') | apply (crude_related p eps u al u' al' HL Ui ri HU Hr)]. }
  clearbody qi.
  take si. set (s := sizes_of C rho Qj).
  assert (Hs : sizes_related C C' (encl U) s si) by (apply (sizes_in p eps u al u' al' HL Ui ri HU Hr); exact Hq).
  clearbody si.
  assert (HsK := Hs). destruct HsK as (Ss & Sc & SF & SQ & Se & Sch & Sf & Sl & Sa).
  take Qi. assert (HQi : encl U Qj Qi) by exact SQ.
  take Qat. assert (HQat : inI Q Qat) by (rewrite <- AQ; exact (values_in p U Hne _ _ _ HU HQi)). clearbody Qat.
  assert (Hplus : inI (1 + rho) (plus C' ri)) by (apply (add_in p); [apply Z | exact Hr]).
  assert (Hminus : inI (1 - rho) (minus C' ri)) by (apply (sub_in p); [apply Z | exact Hr]).
  assert (Eu : (1 + rho) * U = u) by lra. assert (Eu' : (1 - rho) * U = u') by lra.
  take xi. assert (Hx : forall x, 0 < x < u -> inI x xi).
  { intros x Hx. replace x with (x / u * ((1 + rho) * U)) by (rewrite Eu; field; lra). apply mul_in.
    - apply (unit_of p). split; [apply quotient_at_least | apply quotient_at_most]; lra.
    - apply mul_in; [exact Hplus | exact HU]. }
  clearbody xi.
  take r2. assert (Hr2 : inI (rho * rho) r2) by (now apply sqr_in). clearbody r2.
  take di. assert (Hd : inI d di) by (rewrite <- F_rU; now apply mul_in). clearbody di.
  take d2i. assert (Hd2 : inI (d * d) d2i) by (now apply sqr_in). clearbody d2i.
  assert (Kk : forall g g1 g2 x, kernel2 g g1 g2 U x = n_second C x (g (PI - x)) (g1 (PI - x)) (g2 (PI - x)))
    by reflexivity.
  take ki. set (k := k_of C rho nodes s (tau_rest u al 12)).
  assert (Hk : encl U k ki).
  { apply (r_k C C' inI (encl U) rel rho ri Hr nodes (c_nodes c) Kn); [exact Hs|]. apply mul_in; [exact Ks|].
    apply (mean_in _ _ _ _ (way_rest_mean (fun F => G F J) (fun F => G1 F J) (fun F => G2 F J) U u ltac:(lra)
      ltac:(intros x Hx'; split; [apply (G_derive (PI - x) J) | apply (G1_derive (PI - x) J)]; lra)
      ltac:(intros x y Hx' Hy; apply (tau_integrable J x y u); lra) 12 ltac:(lia))).
    intros x Hx'. rewrite Kk. destruct (kernels_are U (PI - x) J ltac:(lra)) as (E1 & E2 & E3 & _).
    rewrite <- E1, <- E2, <- E3. change (inI (n_second_G C x J) (n_second_G C' xi (values p Ui (J_of C' ri si)))).
    apply (r_second_G C C' inI (encl U) rel); [now apply Hx|].
    assert (JV := J_value _ _ _ _ _ HL Qj AQ). fold U d rho C s J in JV. rewrite <- JV.
    apply (values_in p U Hne); [exact HU | now apply (r_J C C' inI (encl U) rel rho ri Hr)]. }
  clearbody ki.
  take hfi. set (hf := half_of C rho k). assert (Hhf : encl U hf hfi)
    by (now apply (r_half C C' inI (encl U) rel rho ri Hr)). clearbody hfi.
  assert (DH : forall x, 0 < x < u -> is_derive (fun F => H F Q) (PI - x) (H1 (PI - x) Q) /\ is_derive (fun F =>
    H1 F Q) (PI - x) (H11 (PI - x) Q))
    by (intros x Hx'; apply (H_derive (PI - x) Q); lra).
  assert (RH : forall a b, 0 <= a -> a <= b <= u -> ex_RInt (fun x => sin x * H (PI - x) Q) a b)
    by (intros a b Ha Hb; apply (H_ready u); lra).
  assert (KH : forall x, 0 < x < u -> kernel2 (fun F => H F Q) (fun F => H1 F Q) (fun F =>
    H11 F Q) U x = n_second_H C x Q).
  { intros x Hx'. rewrite Kk. destruct (kernels_are U (PI - x) Q ltac:(lra)) as (_ & _ & _ & _ & _ & E1 & E2 & E3).
    rewrite <- E1, <- E2, <- E3. reflexivity. }
  take wayi. set (way := way_of C rho nodes Qj (tau_J_rest eps u al u' 12)).
  assert (Hway : encl U way wayi).
  { apply (r_way C C' inI (encl U) rel rho ri Hr nodes (c_nodes c) Kn); [exact HQi|]. apply mul_in; [exact Ks|].
    apply (mean_in _ _ _ _ (way_rest_mean (fun F => H F Q) (fun F => H1 F Q) (fun F =>
      H11 F Q) U u ltac:(lra) DH RH 12 ltac:(lia))).
    intros x Hx'. rewrite (KH x Hx'). apply (r_second_H C C' inI (encl U) rel); [now apply Hx | exact HQat]. }
  clearbody wayi.
  take meani. set (mean := mean_of C rho Qj (mean_rest eps u al u')).
  assert (Hmean : encl U mean meani).
  { apply (r_mean C C' inI (encl U) rel rho ri Hr); [exact HQi|].
    apply mul_in.
    - apply (mean_in _ _ _ _ (step_rest_mean (fun F => H F Q) (fun F => H1 F Q) (fun F =>
      H11 F Q) U u DH RH d ltac:(lra) F_uU)).
      intros x Hx'. rewrite KH by lra. apply (r_second_H C C' inI (encl U) rel); [|exact HQat].
      replace x with (U + (x - U)) by ring. apply (add_in p); [exact HU|]. apply (join_in (- d) d);
        [now apply neg_in | exact Hd | lra].
    - change (inI (rho^2 * (1 / 3 - rho^2 / 9)) (I.mul p r2 (I.sub p (frac 1 3) (I.div p r2 (I.fromZ p 9))))).
      replace (rho^2) with (rho * rho) by ring. apply mul_in; [exact Hr2|]. apply sub_in; [apply Fr | apply div_in;
        [exact Hr2 | apply Z]]. }
  clearbody meani.
  take bothi. set (both := both_of C rho mean way).
  assert (Hboth : encl U both bothi) by exact (both_in p eps u al u' al' HL Ui ri HU Hr Qi meani wayi HQi Hmean Hway).
  clearbody bothi.
  take Fi. assert (HF : inI (PI - U) Fi) by (apply (sub_in p); [exact HP | exact HU]). clearbody Fi.
  take fari. assert (Hfar : forall z, PI - U - d <= z <= PI - U + d -> inI z fari).
  { intros z Hz. apply (join_in (PI - U - d) (PI - U + d)); [now apply sub_in | now apply (add_in p) | exact Hz]. }
  clearbody fari.
  destruct (sizes_are _ _ _ _ _ HL Qj AQ) as (Vs & Vc & _). fold U d rho C s in Vs, Vc.
  destruct Ss as (_ & _ & _ & _ & Ss). destruct Sc as (_ & _ & _ & _ & Sc). fold s in Ss, Sc. rewrite Vs in Ss.
  rewrite Vc in Sc.
  take e0i. assert (He0 : inI (middle_rest U d Q) e0i)
    by exact (middle_in p eps u al u' al' HL Ui HU r2 Hr2 d2i Qat fari _ _ Hd2 HQat Hfar Ss Sc).
  clearbody e0i.
  destruct (moment_rests U d ltac:(lra) ltac:(lra)) as [Mc Ms].
  assert (Hm := moment_in p eps u al u' al' HL r2 Hr2).
  take m1i. set (m1 := first_part C s (e_cos u u') (e_sin u u') (e_mid eps u al u')).
  assert (Hm1 : encl U m1 m1i).
  { apply (r_first_part C C' inI (encl U) rel); [exact Hs | apply Hm; [lia | exact Mc] | apply Hm;
    [lia | exact Ms] | exact He0]. }
  clearbody m1i.
  destruct (falls_are _ _ _ _ _ HL) as [Fa Fb]. fold U d rho Q J J' in Fa, Fb.
  destruct (sizes_are _ _ _ _ _ HL Qj AQ) as (_ & _ & _ & _ & _ & _ & Vf & Vl & _). fold U d rho C s in Vf, Vl.
  set (aA := size_after eps u u' (al + beta eps u) + rho * size eps u u' (al + beta eps u)) in *.
  set (ap := size_after eps u u' (al + beta eps u)) in *.
  take Ai. assert (HA : inI aA Ai) by (rewrite <- Vf; exact (values_in p U Hne _ _ _ HU Sf)). clearbody Ai.
  take A'i. assert (HA' : inI ap A'i) by (rewrite <- Vl; exact (values_in p U Hne _ _ _ HU Sl)). clearbody A'i.
  assert (U0 : 0 < U) by lra.
  assert (Q1 : Q = PI / 2 + U * (rho * rho * (q + 0))) by (rewrite <- AQ; unfold Qj; cbn; ring).
  assert (J1 : J = PI / 2 + U * (rho * rho * (q + aA))) by (replace J with (Q + aA * d^2 / U) by lra;
    rewrite Q1, <- F_rU; field; lra).
  assert (J1' : J' = PI / 2 + U * (rho * rho * (q + ap))) by (replace J' with (Q + ap * d^2 / U) by lra;
    rewrite Q1, <- F_rU; field; lra).
  destruct (gain_is u J Q ltac:(lra) ltac:(lra) ltac:(lra)) as (h & Gh & Bh).
  destruct (gain_is u' J' Q ltac:(lra) ltac:(lra) ltac:(lra)) as (h' & Gh' & Bh').
  assert (Hx1 : forall x A, inI x A -> inI (rho * rho * (q + 0)) (I.mul p r2 (I.add p qi (I.join I.zero A))) /\
    inI (rho * rho * (q + x)) (I.mul p r2 (I.add p qi (I.join I.zero A)))).
  { intros x A HxA. split; (apply mul_in; [exact Hr2|]); (apply (add_in p); [exact Hq|]); apply I.join_correct; [left;
    apply zero_in | right; exact HxA]. }
  assert (Mid : forall x y z i, inI ((x - h0) / U) i -> inI ((y - h0) / U) i -> x <= z <= y -> inI ((z - h0) / U) i).
  { intros x y z i Hx' Hy Hz. apply (between_in _ _ _ _ Hx' Hy). assert (0 < / U) by (now apply Rinv_0_lt_compat).
    split; (apply Rmult_le_compat_r; lra). }
  take hi. assert (Hh : encl U (jline U h0 ((h - h0) / U)) hi).
  { apply (line_encl p U Hne); [exact HU | exact K0|]. destruct (Hx1 aA Ai HA) as [X1 X2].
    assert (SQ' := second_in p U Ui U0 HU u (1 + rho) (plus C' ri) _ _ ltac:(lra) Eu Hplus X1 ltac:(rewrite <- Q1;
      lra)).
    assert (SJ := second_in p U Ui U0 HU u (1 + rho) (plus C' ri) _ _ ltac:(lra) Eu Hplus X2 ltac:(rewrite <- J1;
      lra)).
    rewrite <- Q1 in SQ'. rewrite <- J1 in SJ. exact (Mid _ _ _ _ SJ SQ' Bh). }
  clearbody hi.
  take h'i. assert (Hh' : encl U (jline U h0 ((h' - h0) / U)) h'i).
  { apply (line_encl p U Hne); [exact HU | exact K0|]. destruct (Hx1 ap A'i HA') as [X1 X2].
    assert (SQ' := second_in p U Ui U0 HU u' (1 - rho) (minus C' ri) _ _ ltac:(lra) Eu' Hminus X1 ltac:(rewrite <- Q1;
      lra)).
    assert (SJ := second_in p U Ui U0 HU u' (1 - rho) (minus C' ri) _ _ ltac:(lra) Eu' Hminus X2 ltac:(rewrite <- J1';
      lra)).
    rewrite <- Q1 in SQ'. rewrite <- J1' in SJ. exact (Mid _ _ _ _ SJ SQ' Bh'). }
  clearbody h'i.
  set (hj := jline U h0 ((h - h0) / U)) in *. set (hj' := jline U h0 ((h' - h0) / U)) in *.
  take mi. set (m := jadd m1 (second_part C rho s mean both hj hj')).
  assert (Hmm : encl U m mi).
  { apply (add_encl p U Hne); [exact Hm1|]. now apply (r_second_part C C' inI (encl U) rel rho ri Hr). }
  clearbody mi.
  take ratioi. set (ratio := ratio_of C s m hf).
  assert (Hratio : encl U ratio ratioi) by (now apply (r_ratio C C' inI (encl U) rel)). clearbody ratioi.
  take vi. set (v := place_of C s hf). assert (Hv : encl U v vi) by (now apply (r_place C C' inI (encl U) rel)).
  clearbody vi.
  take vati. assert (Hvat : inI (at_U v) vati) by exact (values_in p U Hne _ _ _ HU Hv). clearbody vati.
  (* (1 - Rr)/y - 5/(3 pi) is rho X + U Y *)
  set (X := rho * ((12 * q - 1 / (1 - rho)) / (3 * PI)) / at_U v).
  set (Y := - (bend_of U ratio + 5 / (3 * PI) * rise_of U v) / at_U v).
  set (x := n_excess C' ri qi (bend ratioi) (rise vi) vati).
  assert (HX : inI X (fst x) /\ inI Y (snd x)).
  { destruct Hratio as (_ & _ & _ & Rb & _). destruct Hv as (_ & _ & Vr & _).
    assert (P3 : inI (3 * PI) (I.mul p (I.fromZ p 3) (t_pi (c_table c)))) by (apply mul_in; [apply Z | exact HP]).
    split; (apply div_in; [|exact Hvat]).
    - apply mul_in; [exact Hr | apply div_in; [apply sub_in; [apply mul_in; [apply Z | exact Hq]|] | exact P3]].
      apply div_in; [apply Z | apply sub_in; [apply Z | exact Hr]].
    - apply neg_in, (add_in p); [exact Rb|]. apply mul_in; [apply div_in; [apply Z | exact P3] | exact Vr]. }
  destruct x as [xi' yi]. cbn [fst snd] in HX. destruct HX as [HX HY]. cbv beta iota.
  set (D2 := 1 / (at_U hf * at_U hf)).
  take D2i. assert (HD2 : inI D2 D2i) by (apply div_in; [apply Z | apply (sqr_in p),
    (values_in p U Hne _ _ _ HU Hhf)]). clearbody D2i.
  assert (Test : forall X Y x y, (nonneg x && nonneg y ||
    nonneg (I.add p (I.mul p ri x) (I.mul p Ui y)))%bool = true ->
    inI X x -> inI Y y -> 0 <= rho * X + U * Y).
  { intros X' Y' x y H HX' HY'. apply orb_prop in H. destruct H as [H|H].
    - apply andb_prop in H. destruct H as [H1 H2']. assert (A := nonneg_true _ _ H1 HX').
      assert (B := nonneg_true _ _ H2' HY').
      assert (0 <= rho * X') by (apply Rmult_le_pos; lra). assert (0 <= U * Y') by (apply Rmult_le_pos; lra). lra.
    - apply (nonneg_true _ _ H). apply (add_in p); now apply mul_in. }
  cbv zeta beta. intros H. apply andb_prop in H. destruct H as [H Hi]. apply andb_prop in H. destruct H as [Hb Lo].
  assert (L' : 0 <= rho * (X - -43 / 100 * D2) + U * (Y - -31 / 200 * at_U v)).
  { apply (Test _ _ _ _ Lo); [apply sub_in; [exact HX | apply mul_in; [apply Fr | exact HD2]]
    | apply sub_in; [exact HY | apply mul_in; [apply Fr | exact Hvat]]]. }
  assert (G' : 0 <= rho * - (X - 9 / 20 * D2) + U * - (Y - 1 / 8 * at_U v)).
  { apply (Test _ _ _ _ Hi); apply neg_in; [apply sub_in; [exact HX | apply mul_in; [apply Fr | exact HD2]]
    | apply sub_in; [exact HY | apply mul_in; [apply Fr | exact Hvat]]]. }
  clear Test.
  assert (HB : 0 <= at_U (below_of C rho k)).
  { apply (nonneg_true _ _ Hb). apply (values_in p U Hne); [exact HU|].
    now apply (r_below C C' inI (encl U) rel rho ri Hr). }
  destruct (defect_value _ _ _ _ _ HL Qj AQ 12 ltac:(lia) hj hj' h h' ltac:(unfold hj; cbn; field;
    lra) ltac:(unfold hj'; cbn; field; lra) Gh Gh' HB)
    as (T1 & Hf0 & ED & EP & EDl).
  change (0 < at_U hf) in Hf0. change (defect eps u al u' al' = comparison eps (clock eps u al) * at_U ratio) in ED.
  change (place eps (clock eps u al) = U * at_U v) in EP. change (difference (clock eps u al) ^ 2 = rho / (at_U hf *
    at_U hf)) in EDl.
  set (T := clock eps u al) in *.
  destruct (L57b U rho q F_rho nodes half_way s (start_sizes U rho q F_rho ltac:(lra)) (e_cos u u') (e_sin u u')
    (e_mid eps u al u')
    (mean_rest eps u al u') (tau_J_rest eps u al u' 12) (tau_rest u al 12) hj hj' eq_refl) as [R0 R1].
  change (at_0 ratio = 1) in R0. change (slope_0 ratio = - (5 / (3 * PI) + rho^2 / (3 * PI) * (12 * q - / (1 - rho))))
    in R1.
  assert (V0 : at_0 v = 1)
    by exact (start_place U rho q F_rho nodes half_way s (start_sizes U rho q F_rho ltac:(lra)) (tau_rest u al 12)).
  assert (D0 : 0 < difference T) by (destruct (difference_falls T T ltac:(lra)); assumption).
  assert (SE : 0 < sqrt eps) by (now apply sqrt_lt_R0).
  assert (y0 : 0 < place eps T).
  { unfold place. destruct root3 as [_ [T0 [T3 _]]]. apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat;
    [apply Rdiv_lt_0_compat; [|lra] | exact SE] | exact D0].
    apply sqrt_lt_R0. apply Rmult_lt_0_compat; lra. }
  assert (v0 : 0 < at_U v) by (apply Rmult_lt_reg_l with U; [exact U0 | rewrite <- EP, Rmult_0_r; exact y0]).
  assert (E1 := excess_is U rho q (at_U ratio) (at_U v) (bend_of U ratio) (rise_of U v) U0 v0 ltac:(lra)
    ltac:(unfold bend_of, rise_of; rewrite R0, R1; field; repeat split; lra) ltac:(unfold rise_of; rewrite V0; field;
      lra)).
  fold X Y in E1. rewrite <- EP in E1.
  assert (c0 : 0 < comparison eps T).
  { unfold comparison. destruct k0_value. apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; lra | now apply pow_lt].
    }
  unfold layer_bounds. fold T. cbv zeta. rewrite ED, EDl. set (y := place eps T) in *.
  replace (rho / (at_U hf * at_U hf)) with (rho * D2) by (unfold D2; field; lra). rewrite EP in *. clear EP.
  set (g := 5 / (3 * PI)) in *. set (w := U * at_U v) in *.
  assert (B1 : w * (g + (rho * X + U * Y)) <= w * (g + 0.125 * w + 0.45 * (rho * D2))) by (apply Rmult_le_compat_l;
    unfold w in *; lra).
  assert (B2 : w * (g - 0.155 * w - 0.43 * (rho * D2)) <= w * (g + (rho * X + U * Y))) by (apply Rmult_le_compat_l;
    unfold w in *; lra).
  split; (apply Rmult_le_compat_l; lra).
Qed.
End Leaf.
End LayerBounds.
