(** The defect of a step (L49 of law.md) and what the clock shows at the end (L52): the error of the midpoint rule, and
    what the contacts gain, because J is not Q.

    tau_J, tau_JJ == the derivatives of tau by J
    gain_between  == tau (u, J) - tau (u, Q) = A tau_J + A^2 tau_JJ/2, tau_JJ between its values at J and at Q
    L49_defect    == 2 eps D = E1 + E2
    L49_between   == and bounds of it
    L52_end       == 2 eps e_end = - eps r/(kappa F) + E1 + the gain at the last contact *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Sines LawStatement Angles Falls Clock Midpoint Ends.
Local Open Scope R_scope.

Definition tau_J u Q : R := RInt (fun x => sin x * H (PI - x) Q) 0 u.
Definition tau_JJ u Q : R := RInt (fun x => sin x * H2 (PI - x) Q) 0 u.

Lemma H2_mono F J J' : 0 < J -> J <= J' < F -> 0 <= H2 F J <= H2 F J'.
Proof.
  intros H0 H. destruct (radicand F J ltac:(lra)) as [A1 A2]. destruct (radicand F J' ltac:(lra)) as [B1 B2].
  unfold H2, root.
  assert (J * J <= J' * J') by (apply Rmult_le_compat; lra).
  assert (S : sqrt (F * F - J' * J') ^ 5 <= sqrt (F * F - J * J) ^ 5)
    by (apply pow_incr; split; [lra | apply sqrt_le_1_alt; lra]).
  assert (P : 0 < sqrt (F * F - J' * J') ^ 5) by (apply pow_lt; lra).
  assert (N : 0 <= 3 * J * F) by (apply Rmult_le_pos; lra).
  split; [apply Rmult_le_pos; [exact N | left; apply Rinv_0_lt_compat; lra]|].
  apply Rmult_le_compat; [exact N | left; apply Rinv_0_lt_compat; lra | apply Rmult_le_compat_r;
    lra | apply Rinv_le_contravar; lra].
Qed.
(** Taylor's formula in J. *)
Lemma gain_at F J Q : 0 < J -> J <= Q < F ->
  G F Q + (J - Q) * H F Q + (J - Q)^2 / 2 * H2 F J <= G F J <= G F Q + (J - Q) * H F Q + (J - Q)^2 / 2 * H2 F Q.
Proof.
  intros HJ HQ. assert (K : forall e c, (forall t, 0 <= t <= Q - J -> 0 <= e * (c - H2 F (Q - t))) ->
    0 <= e * (G F Q - H F Q * (Q - J) + c * (Q - J)^2 / 2 - G F (Q - (Q - J)))).
  { intros e c Hc. assert (D : forall (f f' : R -> R -> R), (forall F J, 0 < J < F ->
      is_derive (fun J => f F J) J (f' F J)) ->
      forall t, 0 <= t <= Q - J -> is_derive (fun t => f F (Q - t)) t (- f' F (Q - t))).
    { intros f f' Df t Ht. replace (- f' F (Q - t)) with (scal (-1) (f' F (Q - t)))
        by (unfold scal; simpl; unfold mult; simpl; ring).
      apply (is_derive_comp (fun J => f F J) (fun t => Q - t)); [apply Df; lra | auto_derive; [easy | ring]]. }
    assert (K1 : forall t, 0 <= t <= Q - J -> 0 <= e * (- H F Q + c * t - - H F (Q - t))).
    { apply (grows _ (fun t => e * (c - H2 F (Q - t)))); [|exact Hc | rewrite Rminus_0_r; ring].
      intros t Ht. apply combine; [auto_derive; [easy | ring] | apply negated; now apply (D H H2 H_derive_J)]. }
    apply (grows (fun t => e * (G F Q - H F Q * t + c * t^2 / 2 - G F (Q - t))) (fun t => e * (- H F Q + c * t - - H F
      (Q - t))) (Q - J));
      [|exact K1 | rewrite Rminus_0_r; field | lra].
    intros t Ht. apply combine; [auto_derive; [easy | field] | now apply (D G H G_derive_J)]. }
  assert (L := K (-1) (H2 F J) ltac:(intros t Ht; destruct (H2_mono F J (Q - t) HJ ltac:(lra)); lra)).
  assert (M := K 1 (H2 F Q) ltac:(intros t Ht; destruct (H2_mono F (Q - t) Q ltac:(lra) ltac:(lra)); lra)).
  replace (Q - (Q - J)) with J in L, M by ring. replace ((J - Q)^2) with ((Q - J)^2) by ring. split; lra.
Qed.
Lemma weight_integrable (f : R -> R -> R) u Q : 0 <= u -> 0 < Q < PI - u ->
  (forall F, Q < F -> ex_derive (fun F => f F Q) F) -> ex_RInt (fun x => sin x * f (PI - x) Q) 0 u.
Proof.
  intros Hu HQ Hf. apply (ex_RInt_continuous (V := R_CompleteNormedModule)). rewrite Rmin_left, Rmax_right by lra.
  intros x Hx.
  apply (continuous_mult sin (fun x => f (PI - x) Q)); [apply continuous_sin|].
  apply (continuous_comp (fun x => PI - x) (fun F => f F Q)); [|apply (ex_derive_continuous (fun F => f F Q)), Hf;
    lra].
  apply (continuous_minus (fun _ => PI) (fun x => x)); [apply continuous_const | apply continuous_id].
Qed.
Lemma H_smooth Q F : 0 < Q < F -> ex_derive (fun F => H F Q) F /\ ex_derive (fun F => H2 F Q) F.
Proof.
  intros HF. destruct (radicand F Q HF) as [A B]. unfold H, H2, root.
  split; auto_derive; replace (F * F + - (Q * Q)) with (F * F - Q * Q) by ring; repeat split; try lra;
    repeat apply Rmult_integral_contrapositive_currified; lra.
Qed.
Theorem gain_between u J Q : 0 <= u <= PI -> 0 < J -> J <= Q < PI - u ->
  (J - Q) * tau_J u Q + (J - Q)^2 / 2 * tau_JJ u J <= tau u J - tau u Q <= (J - Q) * tau_J u Q + (J - Q)^2 / 2 *
    tau_JJ u Q.
Proof.
  intros Hu HJ HQ. assert (I : forall j, J <= j <= Q -> ex_RInt (fun x => sin x * H2 (PI - x) j) 0 u).
  { intros j Hj. apply weight_integrable; [lra | lra |]. intros F HF. exact (proj2 (H_smooth j F ltac:(lra))). }
  assert (I1 : ex_RInt (fun x => sin x * H (PI - x) Q) 0 u).
  { apply weight_integrable; [lra | lra |]. intros F HF. exact (proj1 (H_smooth Q F ltac:(lra))). }
  assert (I0 : forall j, J <= j <= Q -> ex_RInt (fun x => sin x * G (PI - x) j) 0 u)
    by (intros j Hj; apply (tau_integrable j 0 u u); lra).
  assert (S : forall j, J <= j <= Q -> is_RInt (fun x => sin x * G (PI - x) Q + (J - Q) * (sin x * H (PI - x) Q) +
    (J - Q)^2 / 2 * (sin x * H2 (PI - x) j)) 0 u (tau u Q + (J - Q) * tau_J u Q + (J - Q)^2 / 2 * tau_JJ u j)).
  { intros j Hj. apply (is_RInt_plus (V := R_NormedModule)).
    - apply (is_RInt_plus (V := R_NormedModule)).
      + apply (RInt_correct (V := R_CompleteNormedModule)), I0. lra.
      + apply (is_RInt_scal (V := R_NormedModule)), (RInt_correct (V := R_CompleteNormedModule)), I1.
    - apply (is_RInt_scal (V := R_NormedModule)), (RInt_correct (V := R_CompleteNormedModule)), I, Hj. }
  assert (T : is_RInt (fun x => sin x * G (PI - x) J) 0 u (tau u J))
    by (apply (RInt_correct (V := R_CompleteNormedModule)), I0; lra).
  assert (L := is_RInt_le _ _ 0 u _ _ (proj1 Hu) (S J ltac:(lra)) T).
  assert (M := is_RInt_le _ _ 0 u _ _ (proj1 Hu) T (S Q ltac:(lra))).
  cbv beta in L, M. split.
  - assert (X : tau u Q + (J - Q) * tau_J u Q + (J - Q)^2 / 2 * tau_JJ u J <= tau u J); [|lra]. apply L. intros x Hx.
    destruct (gain_at (PI - x) J Q HJ ltac:(lra)) as [A _].
    assert (B := Rmult_le_compat_l (sin x) _ _ ltac:(apply sin_ge_0; lra) A). lra.
  - assert (X : tau u J <= tau u Q + (J - Q) * tau_J u Q + (J - Q)^2 / 2 * tau_JJ u Q); [|lra]. apply M. intros x Hx.
    destruct (gain_at (PI - x) J Q HJ ltac:(lra)) as [_ A].
    assert (B := Rmult_le_compat_l (sin x) _ _ ltac:(apply sin_ge_0; lra) A). lra.
Qed.

(** G at the flight's own angle, and the midpoint rule. *)
Lemma G_of_angle F th : 0 < F -> 0 < th < PI/2 -> G F (F * cos th) = cos th / (F * sin th).
Proof.
  intros HF Hth. assert (C : 0 < cos th) by (apply cos_gt_0; lra). assert (S : 0 < sin th) by (apply sin_gt_0; lra).
  unfold G.
  replace (F * F - F * cos th * (F * cos th)) with (F * sin th * (F * sin th))
    by (assert (K := sin2_cos2 th); unfold Rsqr in K;
      replace (F * sin th * (F * sin th)) with (F * F * (sin th * sin th)) by ring;
      replace (sin th * sin th) with (1 - cos th * cos th) by lra; ring).
  rewrite sqrt_square by (apply Rmult_le_pos; lra). field. lra.
Qed.
Lemma midpoint_is U d Q : 0 < d <= U -> U <= PI/2 -> 0 < Q < PI - U - d ->
  midpoint_error U d Q = tau (U + d) Q - tau (U - d) Q - G (PI - U) Q * (cos (U - d) - cos (U + d)).
Proof.
  intros Hd HU HQ. assert (I := fun a b Ha Hb => tau_integrable Q a b (U + d) ltac:(lra) Ha Hb).
  assert (C : RInt (fun x => sin x * G (PI - x) Q) 0 (U - d) + RInt (fun x => sin x * G (PI - x) Q) (U - d) (U + d) =
    RInt (fun x => sin x * G (PI - x) Q) 0 (U + d)).
  { apply (RInt_Chasles (fun x => sin x * G (PI - x) Q) 0 (U - d) (U + d)); apply I; lra. }
  assert (S : is_RInt (fun x => G (PI - U) Q * sin x) (U - d) (U + d) (G (PI - U) Q * (- cos (U + d) - - cos (U -
    d)))).
  { apply (is_RInt_scal (V := R_NormedModule) sin). apply (is_RInt_derive (fun x => - cos x) sin).
    - intros x _. auto_derive; [easy | ring]. - intros x _. apply continuous_sin. }
  assert (T : is_RInt (fun x => sin x * G (PI - x) Q) (U - d) (U + d) (tau (U + d) Q - tau (U - d) Q)).
  { replace (tau (U + d) Q - tau (U - d) Q) with (RInt (fun x => sin x * G (PI - x) Q) (U - d) (U + d))
      by (unfold tau; lra).
    apply (RInt_correct (V := R_CompleteNormedModule)), I; lra. }
  unfold midpoint_error. apply is_RInt_unique. assert (M := is_RInt_minus (V := R_NormedModule) _ _ _ _ _ _ T S).
  replace (tau (U + d) Q - tau (U - d) Q - G (PI - U) Q * (cos (U - d) - cos (U + d))) with
    (minus (tau (U + d) Q - tau (U - d) Q) (G (PI - U) Q * (- cos (U + d) - - cos (U - d))))
      by (unfold minus, plus, opp; simpl; ring).
  refine (is_RInt_ext _ _ _ _ _ _ M). intros x _. unfold minus, plus, opp; simpl.
  match goal with |- ?a = ?b => change (@eq R a b) end. ring.
Qed.

(** L49: 2 eps D = E1 + E2. *)
Theorem L49_defect eps u al u' al' : step eps u al u' al' -> 0 < al ->
  let Q := middle_invariant eps u al u' in Q < PI - u ->
  2 * eps * defect eps u al u' al' = midpoint_error (middle u u') (half u u') Q +
    ((tau u (invariant u al) - tau u Q) - (tau u' (invariant u' al') - tau u' Q)).
Proof.
  intros [A [B1 B2] [C1 C2] D E] Ha Q HQ. assert (P := PI2_1). set (th := al + beta eps u) in *.
  assert (S1 := beta_pos eps u (proj1 A) ltac:(apply sin_gt_0; lra)).
  assert (S2 := beta_pos eps u' (proj1 A) ltac:(apply sin_gt_0; lra)).
  assert (Et : th = al + beta eps u) by reflexivity. assert (Hth : 0 < th < PI/2) by lra.
  assert (C : 0 < cos th) by (apply cos_gt_0; lra). assert (S : 0 < sin th) by (apply sin_gt_0; lra).
  set (U := middle u u') in *. set (d := half u u') in *.
  assert (Eu : u = U + d /\ u' = U - d) by (unfold U, d, middle, half; lra).
  assert (F0 : 0 < PI - U) by (unfold U, middle; lra).
  assert (Q0 : 0 < Q) by (apply Rmult_lt_0_compat; [exact F0 | exact C]).
  assert (M := midpoint_is U d Q ltac:(lra) ltac:(lra) ltac:(lra)). rewrite <- (proj1 Eu), <- (proj2 Eu) in M.
  rewrite M.
  assert (K : G (PI - U) Q * (cos u' - cos u) = 2 * eps).
  { unfold Q, middle_invariant. fold U th. rewrite (G_of_angle _ _ F0 Hth), E. unfold tan.
    replace (2 * PI - u - u') with (2 * (PI - U)) by (unfold U, middle; field).
    field. repeat split; lra. }
  rewrite K. unfold defect, clock. rewrite (L45a_clock u al), (L45a_clock u' al') by lra. field. lra.
Qed.
(** And between which bounds. *)
Theorem L49_between eps u al u' al' c3 C3 c4 C4 : step eps u al u' al' -> 0 < al ->
  let Q := middle_invariant eps u al u' in let U := middle u u' in let d := half u u' in let F := PI - U in
  let A := invariant u al - Q in let A' := invariant u' al' - Q in Q < PI - u ->
  (forall z, F - d <= z <= F + d -> c3 <= G3 z Q <= C3) -> (forall z, F - d <= z <= F + d -> c4 <= G4 z Q <= C4) ->
  let m a3 a4 := sin U * (G2 F Q * moment_cos d 2 + a4 * moment_cos d 4 / 12) -
    cos U * (2 * G1 F Q * moment_sin d 1 + a3 * moment_sin d 3 / 3) in
  let first := (A - A') * tau_J u Q + A' * (tau_J u Q - tau_J u' Q) in
  m C3 c4 + first + (A^2 * tau_JJ u (invariant u al) - A'^2 * tau_JJ u' Q) / 2 <= 2 * eps * defect eps u al u' al' <=
  m c3 C4 + first + (A^2 * tau_JJ u Q - A'^2 * tau_JJ u' (invariant u' al')) / 2.
Proof.
  intros H Ha Q U d F A A' HQ B3 B4 m first. assert (E := L49_defect eps u al u' al' H Ha HQ). cbv zeta in E.
  fold Q U d in E.
  destruct H as [He [B1 B2] [C1 C2] D HE]. assert (P := PI2_1). set (th := al + beta eps u) in *.
  assert (Et : th = al + beta eps u) by reflexivity.
  assert (S1 := beta_pos eps u (proj1 He) ltac:(apply sin_gt_0; lra)).
  assert (S2 := beta_pos eps u' (proj1 He) ltac:(apply sin_gt_0; lra)).
  assert (L := L44_before eps u u' th (proj1 He) B1 B2 ltac:(lra) HE).
  assert (L' := L44_after eps u u' th (proj1 He) B1 B2 ltac:(lra) HE).
  replace (th - beta eps u) with al in L by lra. replace (th + beta eps u') with al' in L' by lra.
  change (invariant u al <= Q) in L. change (invariant u' al' <= Q) in L'.
  assert (Eu : u = U + d /\ u' = U - d) by (unfold U, d, middle, half; lra).
  assert (J0 : 0 < invariant u al) by (apply Rmult_lt_0_compat; [lra | apply cos_gt_0; lra]).
  assert (J0' : 0 < invariant u' al') by (apply Rmult_lt_0_compat; [lra | apply cos_gt_0; lra]).
  assert (M := midpoint_between U d Q ltac:(lra) ltac:(lra) ltac:(lra) c3 C3 c4 C4 B3 B4). cbv zeta in M. fold F in M.
  assert (K := gain_between u (invariant u al) Q ltac:(lra) J0 ltac:(lra)).
  assert (K' := gain_between u' (invariant u' al') Q ltac:(lra) J0' ltac:(lra)). fold A in K. fold A' in K'.
  unfold m, first. rewrite E. split; lra.
Qed.
(** L52, with y for the point of tangency: kappa = sin y, r = cos y + y sin y - 1. *)
Theorem L52_end eps u al y : last eps u al y -> 0 < al ->
  let F := PI - u / 2 in let Q := F * cos (al + beta eps u) in Q < PI - u ->
  2 * eps * (clock eps u al - 1) = - (eps * (cos y + y * sin y - 1) / (sin y * F)) + midpoint_error (u / 2) (u / 2) Q
    +
    (tau u (invariant u al) - tau u Q).
Proof.
  intros H Ha F Q HQ. destruct (last_step eps u al y H) as [A [B [C0 [D [Hth [E [K [I L]]]]]]]]. assert (P := PI2_1).
  set (th := al + beta eps u) in *. assert (C : 0 < cos th) by (apply cos_gt_0; lra).
  assert (S : 0 < sin th) by (apply sin_gt_0; lra).
  assert (F0 : 0 < F) by (unfold F; lra). assert (Q0 : 0 < Q) by (apply Rmult_lt_0_compat; assumption).
  assert (M := midpoint_is (u / 2) (u / 2) Q ltac:(lra) ltac:(lra) ltac:(lra)). fold F in M.
  replace (u / 2 + u / 2) with u in M by field. replace (u / 2 - u / 2) with 0 in M by ring.
  assert (T0 : tau 0 Q = 0) by (unfold tau; now rewrite RInt_point). rewrite T0, cos_0 in M. rewrite M.
  assert (Sy : 0 < sin y) by (apply sin_gt_0; lra).
  assert (Ce : eps = sin y * cos th / sin th) by (rewrite <- K; unfold tan; field; lra).
  assert (N : G F Q * (1 - cos u) = 2 * eps - eps * (cos y + y * sin y - 1) / (sin y * F)).
  { unfold Q. rewrite (G_of_angle F th F0 Hth).
    assert (X : cos u = cos y - sin y * (2 * F - y)) by (rewrite K in E; unfold F; lra).
    rewrite X, Ce. field. repeat split; lra. }
  rewrite N. unfold clock. rewrite (L45a_clock u al) by lra. field. repeat split; lra.
Qed.
