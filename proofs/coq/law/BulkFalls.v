(** Condition (C10) of law.md: how much J falls at a step of the bulk, for every eps <= 1/1000. No certificate says
    so: L51 gives Lambda in numbers near 1, and coq-interval encloses that.

    unfold_parts == the parts of a step for coq-interval
    rates        == what coq-interval says of Lambda
    C10          == (C10) *)
From Coq Require Import Reals Lra.
From Interval Require Import Tactic.
From Dumbbell Require Import LawStatement Angles Windows BulkSines BulkParts.
Local Open Scope R_scope.

Ltac unfold_parts := unfold gained, fall, after, moved, less_cos, more_sin, turning, both_sines, sine_1, sine_2, tilt,
  sine_U, cosine_U, far; cbn -[pow].
Lemma rates th Q eps N : near_half_pi Q -> 0 <= eps <= 1/1000 -> 0 <= th -> near_one N ->
  let S := sine_U th Q in let K := cosine_U th Q in let t := tilt th Q in
  let Lambda := fall th Q S K t eps N / turning S t eps N in
  (th <= 0.6 -> Lambda <= 2.1) /\ (0.6 <= th <= 0.7 -> Lambda <= 6.2) /\ (0.7 <= th <= 0.7944 -> Lambda <= 22.7).
Proof.
  intros HQ Heps Hth HN. cbv zeta. apply decimals in HQ. destruct N as [c1 c2 c3 c4 c5 c6 c7 c8 c9 c10 c11 c12 c13].
  unfold near_one, nearly in HN. cbn -[pow] in HN.
  destruct HN as [[H1 [H2 [H3 H4]]] [[H5 [H6 [H7 H8]]] [H9 [H10 [H11 [H12 H13]]]]]].
  unfold_parts. split; [|split]; intros H; interval with (i_bisect th, i_autodiff th, i_depth 14).
Qed.

Theorem C10 eps u al u' al' : step eps u al u' al' -> eps <= 1/1000 ->
  near_half_pi (middle_invariant eps u al u') ->
  let th := al + beta eps u in
  let Lambda hi := invariant u al - invariant u' al' <= hi * (eps^2 * (al' - al)) in
  (th <= 0.6 -> Lambda 2.1) /\ (0.6 <= th <= 0.7 -> Lambda 6.2) /\ (0.7 <= th <= 0.7944 -> Lambda 22.7).
Proof.
  intros [A [B1 B2] [C1 C2] D E] He HQ th Lambda. assert (P := PI2_1).
  assert (S1 := beta_pos eps u (proj1 A) ltac:(apply sin_gt_0; lra)).
  assert (S2 := beta_pos eps u' (proj1 A) ltac:(apply sin_gt_0; lra)).
  assert (Ea : al = th - beta eps u) by (unfold th; ring). assert (Ea' : al' = th + beta eps u') by (unfold th; lra).
  unfold middle_invariant in HQ. fold th in HQ, E. set (Q := (PI - middle u u') * cos th) in *.
  set (N := shares_of eps u u').
  assert (Er : forall hi, 0 <= th <= 0.7944 ->
    fall th Q (sine_U th Q) (cosine_U th Q) (tilt th Q) eps N / turning (sine_U th Q) (tilt th Q) eps N <= hi ->
    Lambda hi).
  { intros hi Ht Hr. assert (F := fall_is eps u u' th ltac:(lra) B1 B2 Ht E HQ).
    destruct (turns_are eps u u' th ltac:(lra) B1 B2 Ht E HQ) as [_ [_ T]]. cbv zeta in F, T. fold Q N in F, T.
    set (f := fall _ _ _ _ _ _ _) in *. set (B := turning _ _ _ _) in *.
    assert (B0 : 0 < B) by (apply Rmult_lt_reg_l with eps; lra).
    unfold Lambda. rewrite Ea, Ea', F. replace (th + beta eps u' - (th - beta eps u)) with (eps * B) by lra.
    replace (eps^3 * f) with (f / B * (eps^2 * (eps * B))) by (field; lra).
    apply Rmult_le_compat_r; [|exact Hr]. apply Rmult_le_pos; [apply pow2_ge_0 | apply Rmult_le_pos; lra]. }
  assert (R : 0 <= th <= 0.7944 -> near_one N)
    by (intros Ht; apply (shares_near eps u u' th); try assumption; lra).
  assert (T0 : 0 <= th) by (unfold th; lra).
  split; [|split]; intros H; apply Er; try lra; apply (rates th Q eps _ HQ ltac:(lra) T0 (R ltac:(lra))); exact H.
Qed.
