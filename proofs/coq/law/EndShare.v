(** (T - 1)/sqrt eps at the last contact as a jet in d = u/2 (L52 of law.md): its parts at d = 0 are those of L58.

    moment_jets      == the moments and integrals as jets
    share_jet        == the formula of EndTerms.v on them; share_base: its value and slope at d = 0
    between          == what lies between two values of an affine function is one
    midpoint_somewhere, gain_somewhere == E1 with values of G3 and G4, the gain with a value between those of tau_JJ
    share_value      == share_jet is (T - 1)/sqrt eps *)
From Coq Require Import Reals ZArith Lra.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Signs Quotients Sines PiValue LawStatement Angles Clock Midpoint Ends Defect Slopes Terms
  EndTerms EndAtZero EndContact.
Local Open Scope R_scope.

(** x over d^n is [c] and a rest over d^2. *)
Definition moment_jets d q ab m2 m4 n1 n3 g h : moments jet := {| tabove := jcurve d 1 ((ab - 1) / (d * d));
  tI2 := jcurve d (1/3) ((m2 / d^3 - 1/3) / (d * d)); tI4 := jcurve d 0 (m4 / d^3 / (d * d));
  tJ1 := jcurve d (1/3) ((n1 / d^3 - 1/3) / (d * d)); tJ3 := jcurve d 0 (n3 / d^3 / (d * d));
  tg1 := {| at_U := g; at_0 := H_at_0 / 2; slope_0 := H_at_0 * (q + 2) / PI |};
  tg2 := {| at_U := h; at_0 := H_at_0 / PI; slope_0 := (h - H_at_0 / PI) / d |} |}.
Definition share_jet d i m := let f := flight_of jet (jets d) i in
  share_of jet (jets d) i f (offset_of jet (jets d) i f) (bends_of jet (jets d) (tF jet i) (tQ jet i)) m.
Theorem share_base d q l ab m2 m4 n1 n3 g h : let s := share_jet d (contact_jets d q l) (moment_jets d q ab m2 m4 n1
  n3 g h) in
  at_0 s = sqrt (sqrt 3) / (9 * sqrt PI) /\ slope_0 s = - (sqrt (sqrt 3) * (16 * q + 7) / (36 * (PI * sqrt PI))).
Proof.
  intros s. assert (E : base s = Dual (sqrt (sqrt 3) / (9 * sqrt PI)) (- (sqrt (sqrt 3) * (16 * q + 7) / (36 * (PI *
    sqrt PI))))).
  { rewrite <- (L58 q ((h - H_at_0 / PI) / d)). reflexivity. }
  now injection E.
Qed.

Lemma between lo hi x : lo <= x <= hi -> exists s, 0 <= s <= 1 /\ x = lo + s * (hi - lo).
Proof.
  intros H. destruct (Req_dec lo hi) as [E|E]; [exists 0; lra|]. exists ((x - lo) / (hi - lo)). split.
  - split; [apply quotient_at_least | apply quotient_at_most]; lra.
  - field. lra.
Qed.
(** A value of f somewhere, from below and from above. *)
Definition somewhere (f : R -> R) a b x := exists z z', a <= z <= b /\ a <= z' <= b /\ f z <= x <= f z'.

Section Midpoint.
Variables d Q : R.
Hypothesis Hd : 0 < d <= 0.09.
Hypothesis HQ : 0 < Q <= 1.7.
Let F := PI - d.
Lemma extremes f : (forall z, F - d <= z <= F + d -> ex_derive f z) -> exists z z', F - d <= z <= F + d /\
  F - d <= z' <= F + d /\ forall x, F - d <= x <= F + d -> f z <= f x <= f z'.
Proof.
  intros D. assert (C : forall z, F - d <= z <= F + d -> continuity_pt f z).
  { intros z Hz. apply derivable_continuous_pt, ex_derive_Reals_0, D, Hz. }
  destruct (continuity_ab_min f (F - d) (F + d) ltac:(lra) C) as [z [A B]].
  destruct (continuity_ab_maj f (F - d) (F + d) ltac:(lra) C) as [z' [A' B']].
  exists z, z'. split; [lra|]. split; [lra|]. intros x Hx. split; [now apply A | now apply A'].
Qed.
Theorem midpoint_somewhere : exists a3 a4, somewhere (fun z => G3 z Q) (F - d) (F + d) a3 /\
  somewhere (fun z => G4 z Q) (F - d) (F + d) a4 /\
  midpoint_error d d Q = sin d * (G2 F Q * moment_cos d 2 + a4 * moment_cos d 4 / 12) -
    cos d * (2 * G1 F Q * moment_sin d 1 + a3 * moment_sin d 3 / 3).
Proof.
  assert (P := pi_value). assert (K : forall z, F - d <= z <= F + d -> 0 < Q < z) by (unfold F; intros; lra).
  destruct (extremes (fun z => G3 z Q)) as [z3 [z3' [A [A' B]]]].
  { intros z Hz. eexists. apply G3_derive, K, Hz. }
  destruct (extremes (fun z => G4 z Q)) as [z4 [z4' [C [C' D]]]].
  { intros z Hz. destruct (radicand z Q (K z Hz)) as [R1 R2]. assert (Z := K z Hz). unfold G4, root. auto_derive.
    replace (z * z + - (Q * Q)) with (z * z - Q * Q) by ring.
    repeat split; try lra; repeat (apply Rmult_integral_contrapositive; split); try (apply pow_nonzero); lra. }
  assert (M := midpoint_between d d Q ltac:(lra) ltac:(lra) ltac:(lra) _ _ _ _ B D). cbv zeta in M. fold F in M.
  destruct (between _ _ _ M) as [s [S E]].
  exists (G3 z3' Q + s * (G3 z3 Q - G3 z3' Q)), (G4 z4 Q + s * (G4 z4' Q - G4 z4 Q)).
  assert (S3 := B z3' A'). assert (S4 := D z4 C).
  assert (0 <= s * (G3 z3' Q - G3 z3 Q)) by pos. assert (0 <= (1 - s) * (G3 z3' Q - G3 z3 Q)) by pos.
  assert (0 <= s * (G4 z4' Q - G4 z4 Q)) by pos. assert (0 <= (1 - s) * (G4 z4' Q - G4 z4 Q)) by pos.
  split; [exists z3, z3'; repeat split; lra|]. split; [exists z4, z4'; repeat split; lra|]. rewrite E. field.
Qed.
End Midpoint.
Lemma gain_somewhere u J Q : 0 <= u <= PI -> 0 < J -> J <= Q < PI - u -> exists s X, 0 <= s <= 1 /\
  X = tau_JJ u J + s * (tau_JJ u Q - tau_JJ u J) /\ tau u J - tau u Q = (J - Q) * tau_J u Q + (J - Q)^2 / 2 * X.
Proof.
  intros Hu HJ HQ. destruct (between _ _ _ (gain_between u J Q Hu HJ HQ)) as [s [S E]].
  exists s, (tau_JJ u J + s * (tau_JJ u Q - tau_JJ u J)). split; [exact S|]. split; [reflexivity|]. rewrite E. field.
Qed.

Section Last.
Variables eps u al y : R.
Hypothesis H : last eps u al y.
Hypothesis Heps : eps <= 1/1000.
Hypothesis Hu : u <= 0.18.
Let d := u / 2.
Let F := PI - d.
Let th := al + beta eps u.
Let Q := F * cos th.
Let J := invariant u al.
Let r := tangent_r y.
Hypothesis HQ : PI/2 - 0.1 * d <= Q <= PI/2 + 0.6 * d.
Hypothesis HJ : J <= PI/2 + eps^2 / 4.
Let l := r / (2 * d^2) / (d * d).
Let q := (Q - PI/2) / d.
Variables a3 a4 X : R.
Hypothesis HM : midpoint_error d d Q = sin d * (G2 F Q * moment_cos d 2 + a4 * moment_cos d 4 / 12) -
  cos d * (2 * G1 F Q * moment_sin d 1 + a3 * moment_sin d 3 / 3).
Hypothesis HX : tau u J - tau u Q = (J - Q) * tau_J u Q + (J - Q)^2 / 2 * X.
Let m := moment_jets d q (2 * r / (sin y * sin y)) (moment_cos d 2) (moment_cos d 4 * a4 / 12) (moment_sin d 1)
  (moment_sin d 3 * a3 / 6) (tau_J u Q / (u * u)) (X / (u * u)).
Lemma bends_value : let G := bends_of jet (jets d) (tF jet (contact_jets d q l)) (tQ jet (contact_jets d q l)) in
  at_U (fst G) = G1 F Q /\ at_U (snd G) = G2 F Q.
Proof.
  destruct (last_facts eps u al y H Heps Hu HQ HJ) as [D [_ [_ [_ [_ [_ [_ [_ [_ [J0 [Q0 F0]]]]]]]]]]].
  fold d in D, J0, Q0, F0. fold F th in J0, Q0, F0.
  fold Q J in J0, Q0. destruct (contact_values eps u al y H Heps Hu HQ HJ) as [V1 [V2 _]].
  fold d F th in V1, V2. fold Q in V1, V2. fold q in V1, V2. change (tangent_r y) with r in V1, V2. fold l in V1, V2.
  assert (Eu : u = 2 * d) by (unfold d; field).
  assert (QF : 0 < Q < F) by (assert (EF : F = PI - d) by reflexivity; lra). destruct (radicand F Q QF) as [R1 R2].
  unfold bends_of. cbv zeta. cbn [fst snd jets o_num o_add o_sub o_mul o_div o_sqr o_root jadd jsub jmul jdiv jinv
    jsqr jsqrt jline at_U].
  cbn [contact_jets tF tQ jline at_U] in V1, V2. cbn [contact_jets tF tQ jline at_U]. rewrite V1, V2.
  unfold G1, G2, root. set (s := sqrt (F * F - Q * Q)) in *.
  assert (E : F * F - Q * Q = s * s) by (unfold s; rewrite sqrt_sqrt; lra). rewrite E. split; field; lra.
Qed.
Theorem share_value : at_U (share_jet d (contact_jets d q l) m) = (clock eps u al - 1) / sqrt eps.
Proof.
  destruct (last_facts eps u al y H Heps Hu HQ HJ) as [D [E0 [Y [Sy [C [S [al0 [T [N [J0 [Q0 F0]]]]]]]]]]].
  fold d in D, N, J0, Q0, F0. fold F th in C, S, T, N, J0, Q0, F0. fold Q J in J0, Q0. change (tangent_r y) with r in
    N.
  destruct (contact_values eps u al y H Heps Hu HQ HJ) as [V1 [V2 [V3 [V4 [V5 [V6 V7]]]]]].
  destruct (flight_values eps u al y H Heps Hu HQ HJ) as [A1 [A2 [A3 A4]]].
  assert (A5 := offset_value eps u al y H Heps Hu HQ HJ). destruct bends_value as [B1 B2].
  fold d F th in V1, V2, V3, V4, V5, V6, V7, A1, A2, A3, A4, A5.
  fold Q J in V1, V2, V3, V4, V5, V6, V7, A1, A2, A3, A4, A5.
  fold q in V1, V2, V3, V4, V5, V6, V7, A1, A2, A3, A4, A5.
  change (tangent_r y) with r in V1, V2, V3, V4, V5, V6, V7, A1, A2, A3, A4, A5.
  fold l in V1, V2, V3, V4, V5, V6, V7, A1, A2, A3, A4, A5.
  assert (L := L52_end eps u al y H al0 ltac:(fold d F th; fold Q; lra)). cbv zeta in L. fold d F th in L.
  fold Q J in L.
  change (cos y + y * sin y - 1) with r in L. rewrite HM, HX in L.
  set (i := contact_jets d q l) in *. set (f := flight_of jet (jets d) i) in *.
  set (A := offset_of jet (jets d) i f) in *. set (G := bends_of jet (jets d) (tF jet i) (tQ jet i)) in *.
  assert (S0 : 0 < sqrt eps) by (now apply sqrt_lt_R0). assert (S2 := sqrt_sqrt eps ltac:(lra)).
  assert (Er : sqrt (at_U (tepsh jet f)) = sqrt eps / d).
  { rewrite A4. rewrite sqrt_div_alt by pos. now rewrite sqrt_square by lra. }
  transitivity ((d * (sin d / d) * (G2 F Q * (moment_cos d 2 / d^3) + moment_cos d 4 * a4 / 12 / d^3) -
    2 * cos d * (G1 F Q * (moment_sin d 1 / d^3) + moment_sin d 3 * a3 / 6 / d^3) + 4 * (tau_J u Q / (u * u)) * ((J -
      Q) / d) +
    2 * (d * (X / (u * u))) * ((J - Q) / d * ((J - Q) / d))) * / (2 * (eps / (d * d)) * (sqrt eps / d)) -
    d * (sin y / (d * d)) * (2 * r / (sin y * sin y)) * / (4 * F * (sqrt eps / d))).
  { unfold share_jet. cbv zeta. fold i f A G. unfold share_of.
    cbn [jets o_num o_add o_sub o_mul o_div o_sqr o_root jadd jsub jmul jdiv jinv jsqr jsqrt jline at_U].
    rewrite Er, A1, A4, A5, B1, B2, V1, V3, V4, V6. unfold m, moment_jets.
    cbn [tabove tI2 tI4 tJ1 tJ3 tg1 tg2 jcurve at_U]. fold d.
    replace (1 / 3 + d * d * ((moment_cos d 2 / d^3 - 1/3) / (d * d))) with (moment_cos d 2 / d^3) by (field; lra).
    replace (1 / 3 + d * d * ((moment_sin d 1 / d^3 - 1/3) / (d * d))) with (moment_sin d 1 / d^3) by (field; lra).
    replace (0 + d * d * (moment_cos d 4 * a4 / 12 / d^3 / (d * d))) with (moment_cos d 4 * a4 / 12 / d^3) by (field;
      lra).
    replace (0 + d * d * (moment_sin d 3 * a3 / 6 / d^3 / (d * d))) with (moment_sin d 3 * a3 / 6 / d^3) by (field;
      lra).
    replace (1 + d * d * ((2 * r / (sin y * sin y) - 1) / (d * d))) with (2 * r / (sin y * sin y)) by (field; lra).
    replace (2 + d * 0) with 2 by ring. replace (4 + d * 0) with 4 by ring. reflexivity. }
  replace ((clock eps u al - 1) / sqrt eps) with (2 * eps * (clock eps u al - 1) / (2 * eps * sqrt eps)) by (field;
    lra).
  rewrite L. replace u with (2 * d) by (unfold d; field). field. repeat split; lra.
Qed.
End Last.
