(** What else the rule of the layer does not compute: the moments, what Taylor leaves of E1,
  and tau to the second order in
    J (L49 of law.md).

    moment_rest_cos, moment_rest_sin == (I2 - 1/3)/U^2 and (J1 - 1/3)/U^2
    middle_rest          == E1/d^3 by G1 and G2, less this rest times U^2
    middle_rest_between  == it lies between values of G3 and G4
    gain_is              == tau(u, J) - tau(u, Q) with a number between tau_JJ(u, J) and tau_JJ(u, Q) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Quotients LawStatement Ends Clock Midpoint Defect.
Local Open Scope R_scope.

(** A continuous function attains its bounds. *)
Lemma attained (f : R -> R) a b : a <= b -> (forall c, a <= c <= b -> ex_derive f c) ->
  exists x y, a <= x <= b /\ a <= y <= b /\ forall c, a <= c <= b -> f x <= f c <= f y.
Proof.
  intros Hab D. assert (K : forall c, a <= c <= b -> continuity_pt f c).
  { intros c Hc. apply continuity_pt_filterlim. apply (ex_derive_continuous f c (D c Hc)). }
  destruct (continuity_ab_min f a b Hab K) as [x [X1 X2]]. destruct (continuity_ab_maj f a b Hab K) as [y [Y1 Y2]].
  exists x, y. split; [exact X2|]. split; [exact Y2|]. intros c Hc. split; [now apply X1 | now apply Y1].
Qed.
Lemma G4_smooth F Q : 0 < Q < F -> ex_derive (fun F => G4 F Q) F.
Proof.
  intros HF. destruct (radicand F Q HF) as [A B]. unfold G4, root. auto_derive.
  replace (F * F + - (Q * Q)) with (F * F - Q * Q) by ring.
  repeat split; try lra; repeat apply Rmult_integral_contrapositive_currified; lra.
Qed.

Section Middle.
Variables U d Q : R.
Hypothesis Hd : 0 < d <= U.
Hypothesis HU : U <= PI/2.
Hypothesis HQ : 0 < Q < PI - U - d.
Let F := PI - U.
Definition moment_rest_cos := (moment_cos d 2 / d^3 - 1 / 3) / U^2.
Definition moment_rest_sin := (moment_sin d 1 / d^3 - 1 / 3) / U^2.
Lemma moment_rests : - ((d / U)^2 / 10) <= moment_rest_cos <= 0 /\ - ((d / U)^2 / 30) <= moment_rest_sin <= 0.
Proof.
  destruct (moments_between d ltac:(lra)) as [[A1 A2] [_ [[B1 B2] _]]].
  assert (d3 : 0 < d^3) by (apply pow_lt; lra). assert (U2 : 0 < U^2) by (apply pow_lt; lra).
  assert (C1 := quotient_at_least (moment_cos d 2) (1 / 3 - d^2 / 10) _ d3 ltac:(lra)).
  assert (C2 := quotient_at_most (moment_cos d 2) (1 / 3) _ d3 ltac:(lra)).
  assert (S1 := quotient_at_least (moment_sin d 1) (1 / 3 - d^2 / 30) _ d3 ltac:(lra)).
  assert (S2 := quotient_at_most (moment_sin d 1) (1 / 3) _ d3 ltac:(lra)).
  assert (E : (d / U)^2 * U^2 = d^2) by (field; lra).
  unfold moment_rest_cos, moment_rest_sin. split; (split; [apply quotient_at_least | apply quotient_at_most]); lra.
Qed.
Definition middle_rest := (midpoint_error U d Q / d^3 - sin U * G2 F Q * (moment_cos d 2 / d^3) +
  2 * cos U * G1 F Q * (moment_sin d 1 / d^3)) / U^2.
Definition weight4 := moment_cos d 4 / d^3 / U^2.
Definition weight3 := moment_sin d 3 / d^3 / U^2.
Lemma weights : (d / U)^2 / 5 * (1 - d^2 / 2) <= weight4 <= (d / U)^2 / 5 /\
  (d / U)^2 / 5 * (1 - d^2 / 6) <= weight3 <= (d / U)^2 / 5.
Proof.
  destruct (moments_between d ltac:(lra)) as [_ [[A1 A2] [_ [B1 B2]]]].
  assert (d3 : 0 < d^3) by (apply pow_lt; lra). assert (U2 : 0 < U^2) by (apply pow_lt; lra).
  assert (E : (d / U)^2 * U^2 = d^2) by (field; lra).
  assert (C1 := quotient_at_least (moment_cos d 4) (d^2 / 5 * (1 - d^2 / 2)) _ d3 ltac:(lra)).
  assert (C2 := quotient_at_most (moment_cos d 4) (d^2 / 5) _ d3 ltac:(lra)).
  assert (S1 := quotient_at_least (moment_sin d 3) (d^2 / 5 * (1 - d^2 / 6)) _ d3 ltac:(lra)).
  assert (S2 := quotient_at_most (moment_sin d 3) (d^2 / 5) _ d3 ltac:(lra)).
  assert (E' : forall k, (d / U)^2 / 5 * k * U^2 = d^2 / 5 * k) by (intros; rewrite <- E; field; lra).
  assert (E1 : (d / U)^2 / 5 * U^2 = d^2 / 5) by (rewrite <- E; field; lra). unfold weight4, weight3.
  split; (split; [apply quotient_at_least | apply quotient_at_most]); try exact U2; rewrite ?E', ?E1; assumption.
Qed.
Theorem middle_rest_between : exists a b a' b', (forall z, z = a \/ z = b \/ z = a' \/ z = b' ->
  F - d <= z <= F + d) /\
  sin U * (weight4 * G4 a Q / 12) - cos U * (weight3 * G3 b Q / 3) <= middle_rest <=
  sin U * (weight4 * G4 a' Q / 12) - cos U * (weight3 * G3 b' Q / 3).
Proof.
  destruct (attained (fun z => G4 z Q) (F - d) (F + d) ltac:(lra)) as [a [a' [A [A' HA]]]].
  { intros z Hz. apply G4_smooth. unfold F in *. lra. }
  destruct (attained (fun z => G3 z Q) (F - d) (F + d) ltac:(lra)) as [b' [b [B' [B HB]]]].
  { intros z Hz. eexists. apply (G3_derive z Q). unfold F in *. lra. }
  exists a, b, a', b'. split; [intros z [->|[->|[->| ->]]]; assumption|].
  assert (M := midpoint_between U d Q Hd HU HQ _ _ _ _ HB HA). cbv zeta in M. fold F in M.
  assert (d3 : 0 < d^3) by (apply pow_lt; lra). assert (U2 : 0 < U^2) by (apply pow_lt; lra).
  assert (W : 0 < U^2 * d^3) by (now apply Rmult_lt_0_compat).
  set (m := midpoint_error U d Q) in *.
  assert (E : middle_rest * (U^2 * d^3) = m - sin U * G2 F Q * moment_cos d 2 + 2 * cos U * G1 F Q * moment_sin d 1)
    by (unfold middle_rest; fold m; field; lra).
  assert (K : forall x y, (sin U * (weight4 * x / 12) - cos U * (weight3 * y / 3)) * (U^2 * d^3) =
    sin U * (x * moment_cos d 4 / 12) - cos U * (y * moment_sin d 3 / 3)) by (intros; unfold weight4, weight3; field;
      lra).
  split; apply Rmult_le_reg_r with (1 := W); rewrite E, K; lra.
Qed.
End Middle.

Theorem gain_is u J Q : 0 < u <= PI -> 0 < J -> J <= Q < PI - u -> exists h,
  tau u J - tau u Q = (J - Q) * tau_J u Q + (J - Q)^2 / 2 * (u^2 * h) /\ tau_JJ u J / u^2 <= h <= tau_JJ u Q / u^2.
Proof.
  intros Hu HJ HQ. assert (K := gain_between u J Q ltac:(lra) HJ HQ). assert (u2 : 0 < u^2) by (apply pow_lt; lra).
  destruct (Req_dec J Q) as [->|N].
  - exists (tau_JJ u Q / u^2). split; [field; lra | lra].
  - assert (A : 0 < (J - Q)^2 / 2) by (assert (0 < (Q - J)^2) by (apply pow_lt; lra);
    replace ((J - Q)^2) with ((Q - J)^2) by ring; lra).
    set (w := (J - Q)^2 / 2) in *. exists ((tau u J - tau u Q - (J - Q) * tau_J u Q) / w / u^2). split; [field; lra|].
    unfold Rdiv at 1 4. split; (apply Rmult_le_compat_r; [left; now apply Rinv_0_lt_compat|]).
    + apply quotient_at_least; lra.
    + apply quotient_at_most; lra.
Qed.
