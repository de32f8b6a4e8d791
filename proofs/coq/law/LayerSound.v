(** What the checker says of a leaf of the layer is true (the conditions (C6) and (C7) of law.md).

    mean_in                     == a mean of what an interval encloses is enclosed
    constants_in                == the constants enclose what they stand for
    offset_in                   == q is in its enclosure
    sizes_in, refined_in        == the rule's sizes and q are enclosed
    beyond_leaf_sound           == a leaf beyond 1/1000 has no step *)
From Coq Require Import Reals ZArith Lra Lia List Bool.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Real.Xreal Float.Basic Float.Sig Interval.Interval Interval.Float Interval.Float_full.
From Dumbbell Require Import Quotients LawStatement Falls Ends Sizes Cubes Clock Midpoint Defect Differences
  Comparison Slopes Calculus LayerRule
  LayerRelated LayerValues LayerStart NodeRule LayerIntegrals LayerRests LayerPlace LayerState LayerLeaf.
Import ListNotations.
Local Open Scope R_scope.

Lemma share_of w A k : 0 < A -> 0 < k -> A * (1 - k) <= w <= A -> exists t, 0 <= t <= 1 /\ w = A * (1 - k * t).
Proof.
  intros HA Hk H. exists ((A - w) / (A * k)). assert (W : 0 < A * k) by (now apply Rmult_lt_0_compat). split; [|field;
    lra].
  split; [apply quotient_at_least | apply quotient_at_most]; lra.
Qed.
Definition h0 := 8 / (3 * sqrt 3 * PI^3).
Lemma whole_way : fold_right (fun i s => part_weight 8 i + s) 0 (upto 0 8) = 1 / 2.
Proof. change (upto 0 8) with [0; 1; 2; 3; 4; 5; 6; 7]%Z. unfold part_weight. cbn. lra. Qed.
Lemma half_way : node_sum (nodes_of 12) (fun _ => 1) = 1 / 2 /\ node_sum (nodes_of 12) (fun n => n) = 1 / 3.
Proof.
  unfold nodes_of. change (upto 0 (Z.to_nat 12)) with [0; 1; 2; 3; 4; 5; 6; 7; 8; 9; 10; 11]%Z.
  unfold node_sum, part_weight, part_node. cbn. split; lra.
Qed.

Module LayerSound (F : FloatOps with Definition sensible_format := true).
Module Export M := LayerLeaf F.
Lemma mean_in D g v i : mean D g v -> (forall x, D x -> inI (g x) i) -> inI v i.
Proof.
  intros [L1 L2] H. unfold inI in *. destruct (I.convert i) as [|lo up]; [exact Logic.I|]. simpl in *.
  split; [destruct lo as [|l]; [exact Logic.I | apply L1] | destruct up as [|l]; [exact Logic.I | apply L2]];
    intros x Hx; now destruct (H x Hx).
Qed.
Lemma between_in x y z i : inI x i -> inI y i -> x <= z <= y -> inI z i.
Proof. intros Hx Hy Hz. exact (contains_connected _ x y Hx Hy z Hz). Qed.

Section Sound.
Variable p : F.precision.
Notation frac a b := (I.div p (I.fromZ p a) (I.fromZ p b)).
Let c := make_constants p 12 8.
Lemma Z_in z : inI (IZR z) (I.fromZ p z).
Proof. exact (I.fromZ_correct p z). Qed.
Lemma frac_in a b : inI (IZR a / IZR b) (frac a b).
Proof. apply div_in; apply Z_in. Qed.
Lemma join_in x y z i j : inI x i -> inI y j -> x <= z <= y -> inI z (I.join i j).
Proof.
  intros Hx Hy Hz. apply (between_in x y); [| |exact Hz]; apply I.join_correct; [left; exact Hx | right; exact Hy].
Qed.
Lemma pi_in : inI PI (t_pi (c_table c)).
Proof. exact (I.pi_correct p). Qed.
Lemma nonneg_true x i : nonneg i = true -> inI x i -> 0 <= x.
Proof.
  intros H Hx. unfold nonneg in H. assert (K := I.sign_large_correct i). destruct (I.sign_large i); try discriminate.
  - assert (E := K _ Hx). injection E as E. lra.
  - destruct (K _ Hx) as [_ K2]. exact K2.
Qed.

Lemma constants_in : Forall2 (fun x y => inI (fst x) (fst y) /\ inI (snd x) (snd y)) (nodes_of 12) (c_nodes c) /\
  inI (spread_of 12) (c_spread c) /\ inI (PI / 2) (c_half_pi c) /\
  (forall Q, PI/2 - 1/100 <= Q <= PI/2 + 1/20 -> inI Q (c_crude c)) /\ inI h0 (c_h0 c).
Proof.
  assert (HP : inI (PI / 2) (c_half_pi c)) by (apply div_in; [apply pi_in | apply Z_in]).
  split; [|split; [|split; [exact HP|split]]].
  - unfold c, make_constants, nodes_of. cbn [c_nodes]. change (upto 0 (Z.to_nat 12)) with (upto 0 12).
    generalize (upto 0 12). intros l. induction l as [|i l IH]; cbn [map]; constructor; [|exact IH]. split;
      apply frac_in.
  - unfold c, make_constants, spread_of. cbn [c_spread]. change (upto 0 (Z.to_nat 12)) with (upto 0 12).
    generalize (upto 0 12). intros l. induction l as [|i l IH]; cbn [fold_right]; [apply zero_in | apply add_in;
      [apply frac_in | exact IH]].
  - intros Q HQ. replace Q with (PI / 2 + (Q - PI / 2)) by ring. apply add_in; [exact HP|].
    apply (join_in (-1 / 100) (1 / 20)); [apply frac_in | apply frac_in | lra].
  - unfold h0. replace (PI^3) with (PI * (PI * PI)) by ring. unfold c, make_constants. cbn [c_h0].
    apply div_in; [apply Z_in|]. apply mul_in; [apply mul_in; [apply Z_in | apply (sqrt_in p), Z_in]|].
    apply mul_in; [apply pi_in | apply (sqr_in p), pi_in].
Qed.

Variables eps u al u' al' : R.
Hypothesis HL : layer_step eps u al u' al'.
Let U := middle u u'.
Let d := half u u'.
Let rho := d / U.
Let Q := middle_invariant eps u al u'.
Let J := invariant u al.
Let J' := invariant u' al'.
Let e := eps / (d * U).
Let q := (Q - PI / 2) / (rho * rho * U).
Let C := exact U.
Variables Ui ri : I.type.
Hypothesis HU : inI U Ui.
Hypothesis Hr : inI rho ri.
Let C' := enclosing p (c_table c) Ui.
Lemma U_not_0 : U <> 0.
Proof. facts (layer_facts _ _ _ _ _ HL). fold U in F_U. lra. Qed.
Lemma Hrel : related C C' inI (encl U).
Proof. apply enclosing_related; [exact U_not_0 | exact HU]. Qed.

Lemma offset_in Qj s' : at_U Qj = Q -> sizes_related C C' (encl U) (sizes_of C rho Qj) s' ->
  inI q (offset p c Ui ri s').
Proof.
  intros HQj Hs. facts (layer_facts _ _ _ _ _ HL). fold U d in F_U, F_d, F_rho, F_rU, F_uU. fold rho in F_rho, F_rU.
  fold U d e in F_e.
  destruct (sizes_are _ _ _ _ _ HL Qj HQj) as (_ & _ & _ & _ & Ee & _ & Ef & _).
  destruct (falls_are _ _ _ _ _ HL) as [Fa _].
  fold U d rho Q J in Fa, Ee, Ef. fold C e in Ee. fold C in Ef.
  destruct Hs as (_ & _ & _ & _ & He & _ & Hf & _). assert (Ve := values_in p U U_not_0 _ _ _ HU He).
  assert (Vf := values_in p U U_not_0 _ _ _ HU Hf).
  rewrite Ee in Ve. rewrite Ef in Vf. set (f := size_after eps u u' (al + beta eps u) + rho * size eps u u' (al + beta
    eps u)) in *.
  destruct HL as (_ & _ & _ & _ & _ & HJ). fold J in HJ.
  assert (Eeps : eps = rho * U * U * e) by (unfold e; rewrite <- F_rU; field; lra).
  assert (W : 0 < rho * rho * U) by (apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]; lra).
  assert (Eq : q = (J - PI / 2) / (rho * rho * U) - f).
  { unfold q. replace Q with (J - f * d^2 / U) by lra. rewrite <- F_rU. field. lra. }
  rewrite Eq. unfold offset. apply sub_in; [|exact Vf]. assert (E2 := sqr_in p _ _ Ve).
  assert (Hp : inI (1 + rho) (plus C' ri)) by (apply (add_in p); [apply Z_in | exact Hr]).
  assert (Eu : u = (1 + rho) * U) by (rewrite F_uU, <- F_rU; ring).
  apply (join_in (- (53 / 10 * (e * e) / ((1 + rho) * ((1 + rho) * (1 + rho))))) (U * (U * U) * (e * e) * (1 / 4))).
  - apply neg_in, div_in; [apply mul_in; [apply frac_in | exact E2] | apply mul_in; [exact Hp | now apply sqr_in]].
  - apply mul_in; [apply mul_in; [apply mul_in; [exact HU | now apply sqr_in] | exact E2] | apply frac_in].
  - split; [apply quotient_at_least | apply quotient_at_most]; try exact W.
    + replace (- (53 / 10 * (e * e) / ((1 + rho) * ((1 + rho) * (1 + rho)))) * (rho * rho * U))
      with (- (53 / 10 * eps^2 / u^3))
        by (rewrite Eeps, Eu; field; repeat split; lra). lra.
    + replace (U * (U * U) * (e * e) * (1 / 4) * (rho * rho * U)) with (eps^2 / 4) by (rewrite Eeps; field). lra.
Qed.
Let Qc := jline U Q 0.
Let Qj := jline U (PI / 2) (rho * rho * q).
Lemma at_crude : at_U Qc = Q.
Proof. unfold Qc. cbn. ring. Qed.
Lemma at_Q : at_U Qj = Q.
Proof.
  facts (layer_facts _ _ _ _ _ HL). fold U d in F_U, F_rho. fold rho in F_rho. unfold Qj, q. cbn. field. lra.
Qed.
Lemma crude_related : sizes_related C C' (encl U) (sizes_of C rho Qc) (crude p c Ui ri).
Proof.
  apply (r_sizes C C' inI (encl U) Hrel rho ri Hr). apply (line_encl p U U_not_0); [exact HU | | apply zero_in].
  destruct constants_in as (_ & _ & _ & K & _). apply K. now destruct HL as (_ & _ & _ & _ & HQ & _).
Qed.
Lemma sizes_in qi : inI q qi -> sizes_related C C' (encl U) (sizes_of C rho Qj) (sizes_at p c Ui ri qi).
Proof.
  intros Hq. apply (r_sizes C C' inI (encl U) Hrel rho ri Hr). destruct constants_in as (_ & _ & K & _).
  apply (line_encl p U U_not_0); [exact HU | exact K | apply mul_in; [now apply sqr_in | exact Hq]].
Qed.
Lemma refined_in n : forall qi, inI q qi -> inI q (refined p c Ui ri n qi).
Proof.
  induction n as [|n IH]; intros qi Hq; [exact Hq|]. apply IH. apply meet_in; [exact Hq|].
  apply (offset_in Qj); [exact at_Q | now apply sizes_in].
Qed.
Theorem beyond_leaf_sound : beyond_leaf p c Ui ri = true -> False.
Proof.
  intros H. facts (layer_facts _ _ _ _ _ HL). fold U d in F_U, F_rho, F_rU, F_e. fold rho in F_rho, F_rU.
  fold e in F_e.
  destruct crude_related as (_ & _ & _ & _ & He & _). assert (Ve := values_in p U U_not_0 _ _ _ HU He).
  destruct (sizes_are _ _ _ _ _ HL Qc at_crude) as (_ & _ & _ & _ & Ee & _). fold U d rho C in Ee. fold e in Ee.
  rewrite Ee in Ve.
  assert (K : inI (rho * (U * U) * e - 1 / 1000) (I.sub p (I.mul p (I.mul p ri (I.sqr p Ui)) (values p Ui (z_ehat C'
    (crude p c Ui ri)))) (frac 1 1000)))
    by (apply sub_in; [apply mul_in; [apply mul_in; [exact Hr | now apply sqr_in] | exact Ve] | apply frac_in]).
  assert (X := above_zero_true _ _ H K). destruct HL as (_ & Hs & _).
  assert (rho * (U * U) * e = eps) by (unfold e; rewrite <- F_rU; field; lra). lra.
Qed.
End Sound.
End LayerSound.
