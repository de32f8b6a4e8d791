(** A step of the layer, and what the rule of LayerRule.v says of it, exactly (L49 and L50 of law.md).

    layer_step        == a step with the hypotheses of the condition [layer]
    layer_facts       == where its numbers lie
    nodes_of          == nodes and weights of n parts
    J_value           == the rule's J is J
    k_value           == k = 2 k1/eps^, k1 = tau/u^2
    way_value, mean_value == g1 and mu
    first_value, second_value == E1/d^3 and E2/d^3
    defect_value      == D = D0(T) Rr *)
From Coq Require Import Reals ZArith Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Quotients PiValue LawStatement Angles Falls Ends Sizes Cubes Clock Midpoint Defect
  Differences Comparison Slopes Calculus
  LayerRule LayerValues NodeRule LayerIntegrals LayerRests LayerPlace.
Local Open Scope R_scope.

Definition layer_step eps u al u' al' := step eps u al u' al' /\ eps <= 1/1000 /\ middle u u' <= 9/10 /\
  half u u' <= middle u u' / 5 /\ PI/2 - 1/100 <= middle_invariant eps u al u' <= PI/2 + 1/20 /\
  PI/2 - 5.3 * eps^2 / u^3 <= invariant u al <= PI/2 + eps^2 / 4.
Definition nodes_of n := map (fun i => (part_node n i, part_weight n i)) (upto 0 (Z.to_nat n)).
Lemma nodes_sum n (f : R -> jet) (g : R -> R) U rho u :
  (forall t, 0 < t < 1 -> at_U (f ((1 + rho) * t)) = g (u * t)) -> (0 < n)%Z ->
  at_U (sum_nodes (exact U) rho f (nodes_of n)) = sum_of n g u.
Proof.
  intros Hf Hn. unfold nodes_of, sum_of.
  assert (Hall : forall i, In i (upto 0 (Z.to_nat n)) -> (0 <= i < n)%Z).
  { intros i Hin. unfold upto in Hin. apply in_map_iff in Hin. destruct Hin as [k [<- Hk]]. apply in_seq in Hk. lia. }
  revert Hall. generalize (upto 0 (Z.to_nat n)). intros t. induction t as [|i t IH]; intros Hall; [cbn; ring|].
  specialize (IH ltac:(intros k Hk; apply Hall; now right)). cbn [map fold_right].
  set (l := map _ t) in *.
  change (at_U (jadd (jscale (f ((1 + rho) * part_node n i)) (part_weight n i)) (sum_nodes (exact U) rho f l)) =
    g (u * part_node n i) * part_weight n i + fold_right (fun i s =>
      g (u * part_node n i) * part_weight n i + s) 0 t).
  cbn [jadd jscale at_U]. rewrite IH. f_equal. f_equal. apply Hf. assert (Hi := Hall i ltac:(now left)).
  unfold part_node.
  assert (P : (0 < 3 * n * (2 * i + 1))%Z) by nia. split; [apply Rdiv_lt_0_compat; apply IZR_lt; nia|].
  apply Rmult_lt_reg_r with (IZR (3 * n * (2 * i + 1))); [now apply IZR_lt|]. unfold Rdiv.
  rewrite Rmult_assoc, Rinv_l by (apply IZR_lt in P; lra).
  rewrite Rmult_1_r, Rmult_1_l. apply IZR_lt. nia.
Qed.

Ltac facts K := destruct K as
  [F_eps F_u F_u2 F_th F_flight F_U F_d F_rho F_rU F_uU F_uU' F_al F_before F_after F_J F_J' F_Q F_e].
Section State.
Variables eps u al u' al' : R.
Hypothesis HL : layer_step eps u al u' al'.
Let U := middle u u'.
Let d := half u u'.
Let rho := d / U.
Let th := al + beta eps u.
Let Q := middle_invariant eps u al u'.
Let J := invariant u al.
Let J' := invariant u' al'.
Let e := eps / (d * U).

Record facts : Prop := {
  f_eps : 0 < eps; f_u : 0 < u' < u; f_u2 : u <= PI/2; f_th : 0 < th < PI/2;
  f_flight : cos u' - cos u = eps * tan th * (2 * PI - u - u'); f_U : 0 < U <= 9/10; f_d : 0 < d <= U / 5;
  f_rho : 0 < rho <= 1/5; f_rU : rho * U = d; f_uU : u = U + d; f_uU' : u' = U - d; f_al : 0 < al;
    f_before : th - beta eps u = al;
  f_after : th + beta eps u' = al'; f_J : 0 < J <= Q; f_J' : 0 < J' <= Q; f_Q : Q < PI - u; f_e : 0 < e }.
Lemma layer_facts : facts.
Proof.
  destruct HL as [[A [B1 B2] [C1 C2] D E] [He [HU [Hd [HQ HJ]]]]]. assert (P := pi_value).
  fold U in HU, Hd. fold d in Hd. fold Q in HQ. fold J in HJ. fold th in D, E.
  assert (Eu : u = U + d) by (unfold U, d, middle, half; field).
  assert (Eu' : u' = U - d) by (unfold U, d, middle, half; field).
  assert (U0 : 0 < U) by (unfold U, middle; lra). assert (d0 : 0 < d) by (unfold d, half; lra).
  assert (S1 := beta_pos eps u (proj1 A) ltac:(apply sin_gt_0; lra)).
  assert (S2 := beta_pos eps u' (proj1 A) ltac:(apply sin_gt_0; lra)).
  assert (Hth : 0 < th < PI/2) by (unfold th in *; lra).
  assert (L := L44_before eps u u' th (proj1 A) B1 B2 ltac:(lra) E).
  assert (L' := L44_after eps u u' th (proj1 A) B1 B2 ltac:(lra) E).
  assert (Eb : th - beta eps u = al) by (unfold th; ring). assert (Ea : th + beta eps u' = al') by lra.
  rewrite Eb in L. rewrite Ea in L'.
  change (J <= Q) in L. change (J' <= Q) in L'.
  assert (e2 : eps^2 <= 1/1000) by (replace (eps^2) with (eps * eps) by ring; apply Rle_trans with (1/1000 * 1);
    [apply Rmult_le_compat; lra | lra]).
  assert (al0 : 0 < al).
  { destruct C1 as [C1|C1]; [exact C1|]. exfalso. unfold J, invariant in HJ. rewrite <- C1, cos_0 in HJ. lra. }
  assert (J0 : 0 < J) by (apply Rmult_lt_0_compat; [lra | apply cos_gt_0; unfold th in Hth; lra]).
  assert (J0' : 0 < J') by (apply Rmult_lt_0_compat; [lra | apply cos_gt_0; lra]).
  constructor; try assumption; try (unfold rho; lra); try (split; assumption); try lra.
  - split; [apply Rdiv_lt_0_compat; lra|]. apply quotient_at_most; lra.
  - unfold rho. field. lra.
  - apply Rdiv_lt_0_compat; [exact (proj1 A) | now apply Rmult_lt_0_compat].
Qed.

(** The rule's jets at this step. *)
Let C := exact U.
Variable Qj : jet.
Hypothesis HQj : at_U Qj = Q.
Let s := sizes_of C rho Qj.
Let a := size eps u u' th.
Let ap := size_after eps u u' th.
Lemma sizes_are : at_U (z_sin_U C s) = sin U /\ at_U (z_cos_U C s) = cos U /\ z_F C s = jline U PI (-1) /\ z_Q C s =
  Qj /\
  at_U (z_ehat C s) = e /\ at_U (z_change C s) = a * (1 - rho * rho) /\ at_U (z_first C s) = ap + rho * a /\
  at_U (z_last C s) = ap /\ U * at_U (z_apart C s) = ap + a * (1 + rho) / 2.
Proof.
  facts layer_facts. assert (K := step_values eps u u' th F_eps F_u F_u2 F_th F_flight Qj HQj). exact K.
Qed.
Lemma falls_are : J - Q = (ap + rho * a) * d^2 / U /\ J' - Q = ap * d^2 / U.
Proof.
  facts layer_facts. assert (B := L49_before eps u u' th F_eps F_u F_u2 ltac:(lra) F_flight).
  assert (A := L49_after eps u u' th F_eps F_u F_u2 ltac:(lra) F_flight). rewrite F_before in B. rewrite F_after in A.
  split; [exact B | exact A].
Qed.
Lemma J_value : at_U (J_of C rho s) = J.
Proof.
  facts layer_facts. destruct sizes_are as (_ & _ & _ & EQ & _ & _ & A & _). destruct falls_are as [F _].
  unfold J_of. cbn [s_add s_mul s_line C exact jadd jmul jline at_U]. fold C. rewrite EQ, HQj, A.
  change (n_Z C 0) with 0. change (n_sqr C rho) with (rho * rho).
  replace J with (Q + (ap + rho * a) * d^2 / U) by lra.
  unfold rho. field. lra.
Qed.

(** Nodes. *)
Lemma node_G_value Jj x : 0 < x -> at_U (node_G C Jj (x / U)) = kernel (fun F => G F (at_U Jj)) x.
Proof.
  intros Hx. facts layer_facts. unfold node_G, s_G, s_root_of.
  assert (W := sinc_jet U (x / U) ltac:(replace (x / U * U) with x by (field; lra); exact Hx)). fold C in W.
  rewrite W.
  cbn [s_mul s_inv s_line s_root s_sub s_sqr C exact jmul jinv jline jsqrt jsub jsqr at_U n_neg n_pi]. fold C.
  replace (PI + U * - (x / U)) with (PI - x) by (field; lra). replace (x / U * U) with x by (field; lra). reflexivity.
Qed.
Lemma node_H_value Jj x : 0 < x -> 0 < at_U Jj < PI - x -> at_U (node_H C Jj (x / U)) = kernel (fun F =>
  H F (at_U Jj)) x.
Proof.
  intros Hx HJ. facts layer_facts. unfold node_H, s_H.
  assert (W := sinc_jet U (x / U) ltac:(replace (x / U * U) with x by (field; lra); exact Hx)). fold C in W.
  rewrite W.
  cbn [s_mul s_inv s_line s_root s_sub s_sqr C exact jmul jinv jline jsqrt jsub jsqr at_U n_neg n_pi]. fold C.
  replace (PI + U * - (x / U)) with (PI - x) by (field; lra). replace (x / U * U) with x by (field; lra).
  unfold kernel, H, root. destruct (radicand (PI - x) (at_U Jj) HJ) as [A B].
  assert (S := sqrt_sqrt _ (Rlt_le _ _ A)).
  set (r := sqrt _) in *. rewrite <- S. field. lra.
Qed.
Variable n : Z.
Hypothesis Hn : (0 < n)%Z.
Let nodes := nodes_of n.
Lemma H_ready j : 0 < j < PI - u -> forall a b, 0 <= a -> a <= b <= u -> ex_RInt (fun x => sin x * H (PI - x) j) a b.
Proof.
  intros Hj x y Hx Hy. apply (ex_RInt_Chasles_2 (V := R_CompleteNormedModule) (fun x =>
    sin x * H (PI - x) j) 0 x y ltac:(lra)).
  apply weight_integrable; [lra | lra |]. intros F HF. exact (proj1 (H_smooth j F ltac:(lra))).
Qed.
Definition tau_rest := spread_of n * way_rest (fun F => G F J) u n.
Definition tau_J_rest := spread_of n * way_rest (fun F => H F Q) u n.
Definition mean_rest := step_rest (fun F => H F Q) U u d * ((d / U)^2 * (1 / 3 - (d / U)^2 / 9)).
Lemma k_value : at_U (k_of C rho nodes s tau_rest) = 2 * (tau u J / u^2) / e.
Proof.
  facts layer_facts. destruct sizes_are as (_ & _ & _ & _ & Ee & _).
  assert (Hu : 0 < u) by lra. unfold k_of. cbn [s_scale s_mul s_add s_inv s_curve C exact jscale jmul jadd jinv jcurve
    at_U]. fold C.
  unfold nodes. rewrite (nodes_sum n _ (kernel (fun F => G F J)) U rho u); [|intros t Ht|exact Hn].
  - rewrite Ee. assert (W : tau u J / u^2 = _) by exact (way_rest_is (fun F => G F J) u Hu n Hn). rewrite W.
    unfold tau_rest. change (n_Z C 0) with 0. change (n_Z C 2) with 2.
    change (n_mul C (n_sqr C (plus C rho)) ?x) with ((1 + rho) * (1 + rho) * x).
    assert (Eu : u^2 = U * U * ((1 + rho) * (1 + rho))) by (rewrite F_uU, <- F_rU; ring). rewrite Eu.
    set (v := way_rest _ _ _). set (v' := sum_of _ _ _). cbn. field. lra.
  - assert (X := node_G_value (J_of C rho s) (u * t) ltac:(apply Rmult_lt_0_compat; lra)). rewrite J_value in X.
    rewrite <- X.
    do 2 f_equal. rewrite F_uU, <- F_rU. field. lra.
Qed.
Lemma way_value : at_U (way_of C rho nodes Qj tau_J_rest) = tau_J u Q / u^2.
Proof.
  facts layer_facts. assert (Hu : 0 < u) by lra. unfold way_of. cbn [s_add s_curve C exact jadd jcurve at_U]. fold C.
  unfold nodes. rewrite (nodes_sum n _ (kernel (fun F => H F Q)) U rho u); [|intros t Ht|exact Hn].
  - assert (W : tau_J u Q / u^2 = _) by exact (way_rest_is (fun F => H F Q) u Hu n Hn). rewrite W.
    unfold tau_J_rest. change (n_Z C 0) with 0. change (n_mul C (n_sqr C (plus C rho)) ?x)
      with ((1 + rho) * (1 + rho) * x).
    assert (Eu : u^2 = U * U * ((1 + rho) * (1 + rho))) by (rewrite F_uU, <- F_rU; ring). rewrite Eu.
    set (v := way_rest _ _ _). set (v' := sum_of _ _ _). cbn. ring.
  - assert (u * t < u * 1) by (apply Rmult_lt_compat_l; lra).
    assert (X := node_H_value Qj (u * t) ltac:(apply Rmult_lt_0_compat; lra) ltac:(rewrite HQj; lra)).
    rewrite HQj in X. rewrite <- X.
    do 2 f_equal. rewrite F_uU, <- F_rU. field. lra.
Qed.
Lemma mean_value : at_U (mean_of C rho Qj mean_rest) = (tau_J u Q - tau_J u' Q) / (d * U).
Proof.
  facts layer_facts. unfold mean_of. cbn [s_add s_curve s_scale C exact jadd jcurve jscale at_U]. fold C.
  assert (Q2 : 0 < d^2 / (3 * U) < d).
  { split; [apply Rdiv_lt_0_compat; [apply pow_lt|]; lra|]. apply Rmult_lt_reg_r with (3 * U); [lra|].
    replace (d^2 / (3 * U) * (3 * U)) with (d * d) by (field; lra).
    assert (d * d < d * (3 * U)) by (apply Rmult_lt_compat_l; lra). lra. }
  assert (X := node_H_value Qj (U + d^2 / (3 * U)) ltac:(lra) ltac:(rewrite HQj; lra)). rewrite HQj in X.
  replace (node_H C Qj (n_add C (n_Z C 1) (n_div C (n_sqr C rho) (n_Z C 3))))
    with (node_H C Qj ((U + d^2 / (3 * U)) / U))
    by (f_equal; change (n_add C (n_Z C 1) (n_div C (n_sqr C rho) (n_Z C 3))) with (1 + rho * rho / 3); unfold rho;
      field; lra).
  rewrite X. assert (W : RInt (fun x => sin x * H (PI - x) Q) (U - d) u / (d * U) = _)
    by exact (step_rest_is (fun F => H F Q) U u d ltac:(lra)). change (n_Z C 0) with 0. change (n_Z C 2) with 2.
  assert (CH : RInt (fun x => sin x * H (PI - x) Q) (U - d) u = tau_J u Q - tau_J u' Q).
  { rewrite <- F_uU'. unfold tau_J. assert (HR := H_ready Q ltac:(lra)).
    assert (K := RInt_Chasles (V := R_CompleteNormedModule) (fun x =>
      sin x * H (PI - x) Q) 0 u' u (HR 0 u' ltac:(lra) ltac:(lra)) (HR u' u ltac:(lra) ltac:(lra))).
    unfold Hierarchy.plus in K; simpl in K. lra. }
  rewrite CH in W. rewrite W. unfold mean_rest. ring.
Qed.

(** E1 and E2. *)
Definition e_cos := moment_rest_cos U d.
Definition e_sin := moment_rest_sin U d.
Definition e_mid := middle_rest U d Q.
Lemma first_value : at_U (first_part C s e_cos e_sin e_mid) = midpoint_error U d Q / d^3.
Proof.
  facts layer_facts. destruct sizes_are as (Es & Ec & EF & EQ & _).
  unfold first_part. rewrite EF, EQ. cbv zeta.
  cbn [s_add s_sub s_mul s_neg s_scale s_inv s_root s_sqr s_curve C exact jadd jsub jmul jneg jscale jinv jsqrt jsqr
    jcurve jline at_U]. fold C.
  rewrite Es, Ec, HQj. change (n_Z C 0) with 0. change (n_Z C 2) with 2. change (n_Z C 3) with 3.
  change (n_div C (n_Z C 1) 3) with (1 / 3).
  replace (PI + U * -1) with (PI - U) by ring.
  destruct (radicand (PI - U) Q ltac:(lra)) as [A B]. assert (S := sqrt_sqrt _ (Rlt_le _ _ A)).
  assert (M2 : 1 / 3 + U * U * e_cos = moment_cos d 2 / d^3) by (unfold e_cos, moment_rest_cos; field; lra).
  assert (M1 : 1 / 3 + U * U * e_sin = moment_sin d 1 / d^3) by (unfold e_sin, moment_rest_sin; field; lra).
  rewrite M1, M2. unfold e_mid, middle_rest. set (m2 := moment_cos d 2 / d^3). set (m1 := moment_sin d 1 / d^3).
  set (m := midpoint_error U d Q / d^3). unfold G1, G2, root. set (r := sqrt _) in *. rewrite <- S. field. lra.
Qed.
Lemma second_value hj hj' h h' : at_U hj = h -> at_U hj' = h' ->
  tau u J - tau u Q = (J - Q) * tau_J u Q + (J - Q)^2 / 2 * (u^2 * h) ->
  tau u' J' - tau u' Q = (J' - Q) * tau_J u' Q + (J' - Q)^2 / 2 * (u'^2 * h') ->
  let mean := mean_of C rho Qj mean_rest in let way := way_of C rho nodes Qj tau_J_rest in
  at_U (second_part C rho s mean (both_of C rho mean way) hj hj') =
    ((tau u J - tau u Q) - (tau u' J' - tau u' Q)) / d^3.
Proof.
  intros Eh Eh' T T' mean way. facts layer_facts. destruct sizes_are as (_ & _ & _ & _ & _ & Ech & Ef & El & Ea).
  assert (EW := way_value). assert (EM := mean_value). fold mean in EM. fold way in EW.
  unfold second_part, both_of, plus, minus.
  cbn [s_add s_sub s_mul s_scale s_sqr s_line s_tight C exact jadd jsub jmul jscale jsqr jline at_U n_sqr n_add n_sub
    n_div n_mul n_Z]. fold C.
  rewrite EM, EW, Ech, Ef, El, Eh, Eh'. rewrite T, T'. destruct falls_are as [-> ->].
  replace (at_U (z_apart C s)) with ((ap + a * (1 + rho) / 2) / U) by (rewrite <- Ea; field; lra).
  assert (R1 : 1 - rho <> 0) by lra.
  assert (Hu : (1 + rho) * U = u) by (rewrite F_uU, <- F_rU; ring).
  assert (Hu' : (1 - rho) * U = u') by (rewrite F_uU', <- F_rU; ring).
  set (x := tau_J u Q). set (y := tau_J u' Q). rewrite <- Hu, <- Hu', <- F_rU. field. repeat split; lra.
Qed.
Theorem defect_value hj hj' h h' : at_U hj = h -> at_U hj' = h' ->
  tau u J - tau u Q = (J - Q) * tau_J u Q + (J - Q)^2 / 2 * (u^2 * h) ->
  tau u' J' - tau u' Q = (J' - Q) * tau_J u' Q + (J' - Q)^2 / 2 * (u'^2 * h') ->
  let mean := mean_of C rho Qj mean_rest in let way := way_of C rho nodes Qj tau_J_rest in
  let k := k_of C rho nodes s tau_rest in
  let m := jadd (first_part C s e_cos e_sin e_mid) (second_part C rho s mean (both_of C rho mean way) hj hj') in
  let hf := half_of C rho k in let T := clock eps u al in
  0 <= at_U (below_of C rho k) ->
  1 <= T /\ 0 < at_U hf /\ defect eps u al u' al' = comparison eps T * at_U (ratio_of C s m hf) /\
  place eps T = U * at_U (place_of C s hf) /\ difference T ^ 2 = rho / (at_U hf * at_U hf).
Proof.
  intros Eh Eh' T0 T0' mean way k m hf T HB. facts layer_facts.
  assert (Ek := k_value). fold k in Ek. set (k1 := tau u J / u^2) in *. assert (Hu : 0 < u) by lra.
  destruct sizes_are as (_ & _ & _ & _ & Ee & _).
  assert (Alr : 0 < al < PI/2) by (assert (K := beta_pos eps u F_eps ltac:(apply sin_gt_0; lra)); unfold th in F_th;
    lra).
  assert (K1 : 0 < k1).
  { apply Rdiv_lt_0_compat; [|now apply pow_lt]. assert (X := L45c_below (u / 2) J ltac:(lra) ltac:(lra)).
    assert (M := tau_mono (u / 2) u J J ltac:(lra) ltac:(lra) ltac:(lra)).
    assert (Y := G_pos PI J ltac:(lra)). assert (0 < u / 2 * (u / 2)) by (apply Rmult_lt_0_compat; lra).
    assert (0 < G PI J * (u / 2 * (u / 2) / 2)) by (apply Rmult_lt_0_compat; lra). lra. }
  assert (Eu : (1 + rho) * U = u) by (rewrite F_uU, <- F_rU; ring).
  assert (Eeps : rho * U^2 * e = eps) by (unfold e; rewrite <- F_rU; field; lra).
  assert (Eclock : T = ((1 + rho) * U)^2 * k1 / (2 * (rho * U^2 * e))).
  { unfold T, clock. fold J. unfold J. rewrite L45a_clock by lra. fold J. rewrite Eu, Eeps. unfold k1. field. lra. }
  set (kk := 2 * k1 / e) in *.
  set (bb := (kk - 1) * ((1 + rho) / (1 - rho) * ((1 + rho) / (1 - rho))) + 1).
  assert (Eb : at_U (below_of C rho k) = bb).
  { unfold below_of, plus, minus. cbn [s_shift s_scale C exact jshift jscale at_U n_sqr n_div n_add n_sub n_Z].
    fold C. rewrite Ek. unfold bb. ring. }
  assert (Ehf : at_U hf = ((sqrt kk - 1) * (1 + rho) + (sqrt bb - 1) * (1 - rho)) / 2 + 1).
  { unfold hf, half_of, plus,
    minus. cbn [s_shift s_scale s_add s_root C exact jshift jscale jadd jsqrt at_U n_div n_add n_sub n_Z]. fold C.
    rewrite Eb, Ek. field. }
  assert (TT : 1 <= T).
  { rewrite Eclock. apply (L50a_late U rho e k1); try lra. rewrite Eb in HB. unfold bb, kk in HB.
    assert (X : 0 <= ((1 + rho)^2 * k1 - 2 * rho * e) * (2 / (e * ((1 - rho) * (1 - rho))))).
    { replace (((1 + rho)^2 * k1 - 2 * rho * e) * (2 / (e * ((1 - rho) * (1 - rho))))) with
        ((2 * k1 / e - 1) * ((1 + rho) / (1 - rho) * ((1 + rho) / (1 - rho))) + 1) by (field; lra). exact HB. }
    assert (W : 0 < 2 / (e * ((1 - rho) * (1 - rho)))) by (apply Rdiv_lt_0_compat; [lra|]; apply Rmult_lt_0_compat;
      [lra | apply Rmult_lt_0_compat; lra]).
    assert (0 <= (1 + rho)^2 * k1 - 2 * rho * e); [|lra]. apply Rmult_le_reg_r with (1 := W). lra. }
  assert (Em : at_U m * (rho * U)^3 = 2 * eps * defect eps u al u' al').
  { unfold m. cbn [jadd at_U]. rewrite first_value. unfold mean, way.
    rewrite (second_value hj hj' h h' Eh Eh' T0 T0').
    destruct HL as [S _]. rewrite (L49_defect eps u al u' al' S F_al F_Q). fold U d Q J J'. rewrite F_rU. field. lra.
    }
  split; [exact TT|]. destruct (roots_by_half rho e k1 ltac:(lra) F_e K1) as [_ HP]. fold kk in HP. fold bb in HP.
  rewrite <- Ehf in HP. split; [exact HP|].
  assert (PB := place_by_half U rho e k1 ltac:(lra) ltac:(lra) F_e K1). rewrite <- Eclock in PB. specialize (PB TT).
  rewrite Eeps in PB. fold kk in PB. fold bb in PB. rewrite <- Ehf in PB. destruct PB as [PB1 PB2].
  split; [|split; [|exact PB2]].
  - assert (X := L50a_ratio U rho e k1 ltac:(lra) ltac:(lra) F_e K1 (at_U m) (defect eps u al u' al')).
    rewrite <- Eclock, Eeps in X. rewrite (X TT ltac:(lra)). f_equal.
    rewrite (ratio_by_half rho e k1 ltac:(lra) F_e K1). fold kk. fold bb. rewrite <- Ehf.
    unfold ratio_of, n_k0. cbn [s_scale s_mul s_sqr s_inv s_root s_tight C exact jscale jmul jsqr jinv jsqrt at_U
      n_div n_mul n_sqrt n_Z n_pi]. fold C.
    rewrite Ee, step_constant_is. destruct root_three as [S3 _]. assert (P := PI_RGT_0).
    assert (0 < sqrt e) by (apply sqrt_lt_R0; lra). assert (0 < sqrt PI) by (now apply sqrt_lt_R0).
    assert (0 < sqrt (sqrt 3)) by (now apply sqrt_lt_R0).
    field. repeat split; lra.
  - rewrite PB1. f_equal. unfold place_of. cbn [s_scale s_mul s_root C exact jscale jmul jsqrt at_U n_mul n_sqrt n_Z
    n_pi]. fold C.
    now rewrite Ee.
Qed.
End State.
