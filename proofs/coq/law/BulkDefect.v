(** Condition (C9) of law.md: the defect of a step of the bulk, for every eps <= 1/1000. No certificate says so: L51
    gives M as a function of th, Q and J', of eps and of numbers near 1, and coq-interval encloses that.

    rate, width == p and w of (C9)
    share_of    == M, with errors e of P, z of Taylor's formula by the angle, and r of the sine of J'/cos th
    share_is    == D = (eps/2) M (al' - al)
    share_near  == M is within the width of (C9)
    C9          == (C9) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Dumbbell Require Import Quotients Trigonometry PiValue LawStatement Start Angles Falls Windows BulkSines
  BulkParts BulkFalls ClockAngle ClockFall.
Local Open Scope R_scope.

Definition rate t := - (1/3) + 0.94 * t^2 - 1.035 * t^4 + 2.107 * t^8.
Definition width t := 0.006 + 0.75 * t^8.

Definition share_of th Q J eps e z r N := let S := sine_U th Q in let K := cosine_U th Q in let t := tilt th Q in
  let h := turn_1 N / sine_1 S K t eps N in let h' := turn_2 N / sine_2 S K t eps N in
  let a := after th Q S K t eps N / cos th in
  (gained S K t eps N + slope2 J th * ((h^3 + h'^3) / 6) + z * (bend th * (eps * ((h^4 + h'^4) / 24))) -
    (loss_integral (th - eps * h) + e) * fall th Q S K t eps N) / turning S t eps N +
  slope1 J th * (K * t * slow N / both_sines S t eps) - K * a + r * (eps * a)^2.

Section Step.
Variables eps u u' th : R.
Hypothesis Heps : 0 < eps <= 1/1000.
Hypothesis Hu : 0 < u' < u.
Hypothesis Hu2 : u <= PI/2.
Hypothesis Hth : 0 <= th <= 0.7944.
Hypothesis HE : cos u' - cos u = eps * tan th * (2 * PI - u - u').
Let b := beta eps u.
Let b' := beta eps u'.
Let Q := (PI - middle u u') * cos th.
Let J := invariant u (th - b).
Let J' := invariant u' (th + b').
Hypothesis HQ : near_half_pi Q.
Hypothesis HJ : near_half_pi J.
Hypothesis HJ' : near_half_pi J'.
Hypothesis Hal : 0 <= th - b.
Hypothesis Hal' : th + b' < PI/2.
Let S := sine_U th Q.
Let K := cosine_U th Q.
Let t := tilt th Q.
Let N := shares_of eps u u'.

Theorem share_is : exists e z r, (-0.0005 <= e <= 0.0005 /\ -1 <= z <= 1 /\ -1 <= r <= 1) /\ near_one N /\
  0 < b + b' /\ defect eps u (th - b) u' (th + b') = share_of th Q J' eps e z r N * (eps / 2 * (b + b')).
Proof.
  assert (P := PI2_1). assert (P' := pi_value).
  assert (NN : near_one N) by (apply (shares_near eps u u' th); assumption).
  destruct (sines_are eps u u' th Heps Hu Hu2 Hth HE HQ) as [_ [_ [_ [_ [L1 L2]]]]].
  destruct (turns_near eps u Heps ltac:(lra)) as [_ [_ [_ [_ [B1 _]]]]]. fold b in B1.
  destruct (turns_near eps u' Heps ltac:(lra)) as [_ [_ [_ [_ [B2 _]]]]]. fold b' in B2.
  assert (T := turns_are eps u u' th Heps Hu Hu2 Hth HE HQ).
  assert (TD := turns_differ eps u u' th Heps Hu Hu2 Hth HE HQ).
  assert (G := gained_is eps u u' th Heps Hu Hu2 Hth HE HQ). assert (D := fall_is eps u u' th Heps Hu Hu2 Hth HE HQ).
  assert (A := after_is_after eps u u' th Heps Hu Hu2 Hth HE HQ).
  cbv zeta in T, TD, G, A, D. fold b b' Q in T, TD, G, A, D. fold S K t N J J' in T, TD, G, A, D.
  assert (JJ := L44_falls eps u u' th (proj1 Heps) Hu Hu2 ltac:(lra) HE Hal'). fold b b' in JJ. fold J J' in JJ.
  destruct (clock_falls J J' (th - b) HJ HJ' ltac:(lra) ltac:(lra)) as [e [He C]].
  destruct (W_about J' th b b' HJ' Hth ltac:(lra) ltac:(lra)) as [z [Hz W2]].
  destruct (end_near J' HJ') as [_ [A1 A2]].
  assert (Ch : RInt (W J') (th - b) (th + b') + clock_integral J' (th + b') = clock_integral J' (th - b)).
  { apply (RInt_Chasles (W J') (th - b) (th + b') (acos (J' / PI))); apply W_between; lra. }
  set (a := after th Q S K t eps N / cos th). set (x := eps^2 * a).
  assert (Cth : 0 < cos th) by (apply cos_gt_0; lra).
  assert (Jx : J' / cos th = far th Q + x).
  { unfold x, a. replace J' with (Q + eps^2 * after th Q S K t eps N) by lra. unfold far. field. lra. }
  assert (R : exists r, -1 <= r <= 1 /\ W J' th = S - K * x + r * x^2).
  { assert (B := sin_near (far th Q) x). fold (sine_U th Q) in B. fold S in B. unfold W. rewrite Jx.
    replace (cos (far th Q)) with (- K) in B by (unfold K, cosine_U; ring). apply Rabs_le_between in B.
    destruct (Req_dec x 0) as [Z|Z]; [exists 0; rewrite Z in *; split; lra|].
    assert (X : 0 < x^2) by (apply pow2_gt_0; exact Z). exists ((sin (far th Q + x) - (S - K * x)) / x^2).
    split; [split; [apply quotient_at_least | apply quotient_at_most]; lra | field; exact Z]. }
  destruct R as [r [Hr WJ]]. exists e, z, r. split; [tauto|]. split; [exact NN|]. split; [lra|].
  destruct T as [Tb [Tb' TB]]. unfold share_of. fold S K t. cbv zeta. fold a.
  set (h := turn_1 N / sine_1 S K t eps N) in *. set (h' := turn_2 N / sine_2 S K t eps N) in *.
  set (B := turning S t eps N) in *. set (q := K * t * slow N / both_sines S t eps).
  assert (BP : 0 < B) by (apply Rmult_lt_reg_l with eps; lra).
  assert (Tq : (b'^2 - b^2) / 2 = eps^3 * (B * q)).
  { replace ((b'^2 - b^2) / 2) with ((b' - b) * (b + b') / 2) by field. rewrite TD, TB.
    replace (2 * K * t * slow N / both_sines S t eps) with (2 * q) by (unfold q, Rdiv; ring). field. }
  replace (th - eps * h) with (th - b) by lra.
  assert (E : clock_integral J (th - b) - clock_integral J' (th + b') - 2 * eps =
    eps^3 * gained S K t eps N + (- K * x + r * x^2) * (eps * B) + slope1 J' th * (eps^3 * (B * q)) +
    slope2 J' th * (((eps * h)^3 + (eps * h')^3) / 6) + z * (bend th * (((eps * h)^4 + (eps * h')^4) / 24)) -
    eps^3 * fall th Q S K t eps N * (loss_integral (th - b) + e)).
  { rewrite <- G, <- D, <- Tq, <- Tb, <- Tb', <- TB. rewrite WJ in W2. lra. }
  unfold defect, clock. fold J J'. rewrite TB.
  transitivity ((clock_integral J (th - b) - clock_integral J' (th + b') - 2 * eps) / (2 * eps)); [field; lra|].
  rewrite E. unfold x. field. lra.
Qed.
End Step.

Lemma share_near th Q J eps e z r N : near_half_pi Q -> near_half_pi J -> 0 <= eps <= 1/1000 -> 0 <= th <= 0.7944 ->
  -0.0005 <= e <= 0.0005 -> -1 <= z <= 1 -> -1 <= r <= 1 -> near_one N ->
  Rabs ((share_of th Q J eps e z r N - rate th) / width th) <= 1.
Proof.
  intros HQ HJ Heps Hth He Hz Hr HN. apply decimals in HQ. apply decimals in HJ.
  destruct N as [c1 c2 c3 c4 c5 c6 c7 c8 c9 c10 c11 c12 c13]. unfold near_one, nearly in HN. cbn -[pow] in HN.
  destruct HN as [[H1 [H2 [H3 H4]]] [[H5 [H6 [H7 H8]]] [H9 [H10 [H11 [H12 H13]]]]]].
  unfold share_of, slope1, slope2, bend, loss_integral, rate, width. unfold_parts. cbv zeta.
  interval with (i_bisect th, i_autodiff th, i_depth 14).
Qed.
Theorem C9 eps u al u' al' : step eps u al u' al' -> eps <= 1/1000 ->
  near_half_pi (middle_invariant eps u al u') ->
  let th := al + beta eps u in let share := eps / 2 * (al' - al) in
  th <= 0.7944 -> near_half_pi (invariant u al) -> near_half_pi (invariant u' al') ->
  Rabs (defect eps u al u' al' - rate th * share) <= width th * share.
Proof.
  intros [A [B1 B2] [C1 C2] D E] He HQ th share Ht HJ HJ'. assert (P := PI2_1).
  assert (S1 := beta_pos eps u (proj1 A) ltac:(apply sin_gt_0; lra)).
  assert (S2 := beta_pos eps u' (proj1 A) ltac:(apply sin_gt_0; lra)).
  assert (Ea : al = th - beta eps u) by (unfold th; ring). assert (Ea' : al' = th + beta eps u') by (unfold th; lra).
  unfold middle_invariant in HQ. fold th in HQ, E. unfold share. rewrite Ea, Ea' in *.
  replace (th + beta eps u' - (th - beta eps u)) with (beta eps u + beta eps u') by ring.
  assert (Hth : 0 <= th <= 0.7944) by lra.
  destruct (share_is eps u u' th ltac:(lra) B1 B2 Hth E HQ HJ HJ' ltac:(lra) ltac:(lra)) as
    [e [z [r [[R1 [R2 R3]] [HN [HB ->]]]]]].
  assert (M := share_near th _ _ eps e z r _ HQ HJ' ltac:(lra) Hth R1 R2 R3 HN).
  set (m := share_of _ _ _ _ _ _ _ _) in *. set (y := eps / 2 * (beta eps u + beta eps u')).
  assert (Y : 0 < y) by (apply Rmult_lt_0_compat; lra).
  assert (W0 : 0 < width th) by (unfold width; assert (0 <= th^8) by (apply pow_le; lra); lra).
  replace (m * y - rate th * y) with ((m - rate th) / width th * (width th * y)) by (field; lra).
  assert (WY : 0 < width th * y) by (now apply Rmult_lt_0_compat).
  rewrite Rabs_mult, (Rabs_pos_eq (width th * y)) by lra.
  rewrite <- (Rmult_1_l (width th * y)) at 2. apply Rmult_le_compat_r; [lra | exact M].
Qed.
