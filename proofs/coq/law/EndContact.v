(** The last contact in the terms of EndTerms.v (L52 of law.md): as jets of exact numbers these are what they stand for.

    tangent_rise     == kappa^2/2 <= r <= kappa^2 (1 + kappa^2)/2, where kappa = sin y, r = cos y + y sin y - 1
    contact_jets     == F, Q, d and so on as jets in d
    last_facts       == the signs at the last contact; 2 kappa F = 2 sin^2 d + r, (9)
    flight_values    == kh = kappa/d^2, cos th, sin th, epsh = eps/d^2
    offset_value     == A = (J - Q)/d, (10) *)
From Coq Require Import Reals ZArith Lra.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Signs Quotients Sines PiValue LawStatement Angles Ends Slopes Terms EndTerms.
Local Open Scope R_scope.

Definition tangent_r y := cos y + y * sin y - 1.
Lemma tangent_rise y : 0 <= y <= 0.24 -> sin y * sin y / 2 <= tangent_r y <= sin y * sin y / 2 * (1 + sin y * sin y).
Proof.
  assert (P := pi_value). intros Hy. unfold tangent_r.
  assert (S : forall t, 0 <= t <= 0.24 -> 0 <= cos t /\ 0.99 * t <= sin t <= t /\ t - sin t <= t * t * t / 6).
  { intros t Ht. assert (L := sine_below t ltac:(lra)). assert (t * t <= 0.24 * 0.24) by pos.
    assert (t * t * t <= 0.24 * 0.24 * t) by pos. split; [apply cos_ge_0; lra|]. split; [|lra].
    split; [lra|]. destruct (proj1 Ht) as [K|<-]; [left; now apply sin_lt_x | rewrite sin_0; lra]. }
  split.
  - assert (0 <= cos y + y * sin y - 1 - sin y * sin y / 2); [|lra].
    apply (grows (fun t => cos t + t * sin t - 1 - sin t * sin t / 2) (fun t => cos t * (t - sin t)) 0.24); [| |
      |lra].
    + intros t _. auto_derive; [easy | field].
    + intros t Ht. destruct (S t Ht) as [A [B C]]. pos.
    + rewrite cos_0, sin_0. field.
  - assert (0 <= sin y * sin y / 2 * (1 + sin y * sin y) - (cos y + y * sin y - 1)); [|lra].
    apply (grows (fun t => sin t * sin t / 2 * (1 + sin t * sin t) - (cos t + t * sin t - 1))
      (fun t => cos t * (sin t + 2 * (sin t * sin t * sin t) - t)) 0.24); [| | |lra].
    + intros t _. auto_derive; [easy | field].
    + intros t Ht. destruct (S t Ht) as [A [B C]].
      assert (0.99 * t * (0.99 * t) * (0.99 * t) <= sin t * sin t * sin t) by (repeat apply Rmult_le_compat; pos).
      assert (0 <= t * t * t) by pos. pos.
    + rewrite cos_0, sin_0. field.
Qed.

Definition contact_jets d q l : contact jet := {| tF := jline d PI (-1); tQ := jline d (PI/2) q; td := jline d 0 1;
  twave := jcurve d 1 ((sin d / d - 1) / (d * d)); tdouble := jcurve d 1 ((sin (2 * d) / (2 * d) - 1) / (d * d));
  tcos := jcurve d 1 ((cos d - 1) / (d * d)); tlift := jcurve d 0 l |}.

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
Let b := beta eps u.
Hypothesis HQ : PI/2 - 0.1 * d <= Q <= PI/2 + 0.6 * d.
Hypothesis HJ : J <= PI/2 + eps^2 / 4.

Lemma last_facts : 0 < d <= 0.09 /\ 0 < eps /\ 0 < y <= 0.18 /\ 0 < sin y /\ 0 < cos th /\ 0 < sin th /\ 0 < al /\
  eps * sin th = sin y * cos th /\ 2 * (sin y * F) = 2 * (sin d * sin d) + r /\ 0 < J <= Q /\ Q < PI - u /\ 0 < F.
Proof.
  destruct (last_step eps u al y H) as [A [B [C [D [Hth [E [G [I K]]]]]]]]. assert (P := pi_value). fold th in Hth,
    E, G, I.
  assert (L := last_invariant eps u al y H). fold J th in L.
  assert (E2 : eps^2 <= 0.000001) by (replace 0.000001 with ((1/1000)^2) by lra; apply pow_incr; lra).
  assert (D0 : 0 < d <= 0.09) by (unfold d; lra). assert (Cs : 0 < cos th) by (apply cos_gt_0; lra).
  assert (Ss : 0 < sin th) by (apply sin_gt_0; lra). assert (Sy : 0 < sin y) by (apply sin_gt_0; lra).
  assert (al0 : 0 < al).
  { destruct K as [K|K]; [exact K|]. exfalso. unfold J, invariant in HJ. rewrite <- K, cos_0 in HJ. lra. }
  assert (J0 : 0 < J) by (apply Rmult_lt_0_compat; [lra | apply cos_gt_0; unfold th in Hth; lra]).
  assert (M : (PI - middle u y) * cos th <= Q) by (unfold Q, F, d, middle; apply Rmult_le_compat_r; lra).
  assert (T : eps * sin th = sin y * cos th) by (rewrite <- G; unfold tan; field; lra).
  assert (N : 2 * (sin y * F) = 2 * (sin d * sin d) + r).
  { rewrite G in E. replace u with (2 * d) in E by (unfold d; field). rewrite cos_2a_sin in E. unfold r, tangent_r,
    F. lra. }
  assert (JQ : J <= Q) by lra. assert (Qu : Q < PI - u) by lra. assert (F0 : 0 < F) by (unfold F; lra).
  repeat split; try assumption; lra.
Qed.

Let l := r / (2 * d^2) / (d * d).
Let q := (Q - PI/2) / d.
Let i := contact_jets d q l.
Let f := flight_of jet (jets d) i.
Lemma contact_values : at_U (tF jet i) = F /\ at_U (tQ jet i) = Q /\ at_U (td jet i) = d /\ at_U (twave jet i) = sin
  d / d /\
  at_U (tdouble jet i) = sin u / u /\ at_U (tcos jet i) = cos d /\ at_U (tlift jet i) = r / (2 * d^2).
Proof.
  destruct last_facts as [D _]. replace u with (2 * d) by (unfold d; field). unfold i, contact_jets, l, q, F. simpl.
  repeat split; field; lra.
Qed.
Theorem flight_values : at_U (tkh jet f) = sin y / (d * d) /\ at_U (tcosine jet f) = cos th /\
  at_U (tsine jet f) = sin th /\ at_U (tepsh jet f) = eps / (d * d).
Proof.
  destruct last_facts as [D [E [Y [Sy [C [S [_ [T [N [_ [_ F0]]]]]]]]]]]. destruct contact_values as [V1 [V2 [_ [V4
    [_ [_ V7]]]]]].
  assert (A1 : at_U (tkh jet f) = sin y / (d * d)).
  { change (at_U (tkh jet f)) with ((at_U (twave jet i) * at_U (twave jet i) + at_U (tlift jet i)) * / at_U (tF jet
    i)).
    rewrite V1, V4, V7. replace r with (2 * (sin y * F) - 2 * (sin d * sin d)) by lra. field. lra. }
  assert (A2 : at_U (tcosine jet f) = cos th).
  { change (at_U (tcosine jet f)) with (at_U (tQ jet i) * / at_U (tF jet i)). rewrite V1, V2. unfold Q. field. lra. }
  assert (A3 : at_U (tsine jet f) = sin th).
  { change (at_U (tsine jet f)) with (sqrt (1 + d * 0 - at_U (tcosine jet f) * at_U (tcosine jet f))). rewrite A2.
    assert (K := sin2_cos2 th). unfold Rsqr in K. replace (1 + d * 0 - cos th * cos th) with (sin th * sin th) by lra.
    apply sqrt_square. lra. }
  split; [exact A1|]. split; [exact A2|]. split; [exact A3|].
  change (at_U (tepsh jet f)) with (at_U (tkh jet f) * at_U (tcosine jet f) * / at_U (tsine jet f)). rewrite A1, A2,
    A3.
  replace eps with (sin y * cos th / sin th) by (rewrite <- T; field; lra). field. lra.
Qed.
Theorem offset_value : at_U (offset_of jet (jets d) i f) = (J - Q) / d.
Proof.
  destruct last_facts as [D [E [Y [Sy [C [S [al0 [T [N [_ [_ F0]]]]]]]]]]].
  destruct contact_values as [V1 [V2 [V3 [V4 [V5 [V6 V7]]]]]]. destruct flight_values as [_ [A2 [A3 A4]]].
  assert (P := pi_value). assert (Su : 0 < sin u) by (apply sin_gt_0; unfold d in D; lra).
  assert (Bb := beta_pos eps u E Su). fold b in Bb. assert (Cb : 0 < cos b) by (apply cos_gt_0; lra).
  assert (Sb : sin b = eps / sin u * cos b) by apply sin_of_atan.
  assert (Ed : sin u = 2 * sin d * cos d) by (rewrite <- sin_2a; f_equal; unfold d; field).
  assert (Sd : 0 < sin d) by (apply sin_gt_0; lra). assert (Cd : 0 < cos d) by (apply cos_gt_0; lra).
  assert (u0 : 0 < u) by (unfold d in D; lra). set (t := eps / sin u) in *.
  assert (Q1 : cos b * cos b * (1 + t * t) = 1).
  { assert (K := sin2_cos2 b). unfold Rsqr in K. rewrite Sb in K. lra. }
  assert (Rt : sqrt (1 + t * t) = / cos b).
  { apply sqrt_lem_1; [assert (0 <= t * t) by pos; lra | left; now apply Rinv_0_lt_compat|].
    apply Rmult_eq_reg_r with (cos b * cos b); [|assert (0 < cos b * cos b) by pos; lra].
    rewrite (Rmult_comm (1 + t * t)), Q1. field. lra. }
  set (B := at_U (tepsh jet f) * / (2 * (sin u / u))).
  assert (B1 : d * B = t) by (unfold B, t; rewrite A4; unfold d; field; lra).
  transitivity (let c := 1 * / sqrt (1 + d * B * (d * B)) in
    c * cos th * (sin d / d * / (2 * cos d) - 1 + r / (2 * d^2) * / (2 * (sin u / u))) -
    Q * d * (B * c * (B * c)) * / (1 + c) - sin th * (d * B) * c).
  { unfold offset_of. cbn [jets o_num o_add o_sub o_mul o_div o_sqr o_root jadd jsub jmul jdiv jinv jsqr jsqrt jline
    at_U].
    rewrite V2, V3, V4, V5, V6, V7, A2, A3. fold d. replace (2 + d * 0) with 2 by ring. replace (1 + d * 0) with 1 by
      ring.
    reflexivity. }
  cbv zeta. rewrite B1, Rt. replace (1 * / / cos b) with (cos b) by (field; lra).
  assert (X : Q * d * (B * cos b * (B * cos b)) * / (1 + cos b) = Q * (1 - cos b) / d).
  { replace (Q * d * (B * cos b * (B * cos b)) * / (1 + cos b)) with (Q / d * (cos b * cos b * ((d * B) * (d * B))) /
    (1 + cos b))
      by (field; lra).
    rewrite B1. replace (cos b * cos b * (t * t)) with (1 - cos b * cos b) by lra. field. lra. }
  rewrite X.
  assert (EJ : J = (F - d) * (cos th * cos b + sin th * (t * cos b))).
  { unfold J, invariant. replace al with (th - b) by (unfold th, b; ring). rewrite cos_minus, Sb. unfold F, d.
    f_equal. field. }
  assert (ET : F * (sin th * t) = cos th * (2 * (sin d * sin d) + r) / (2 * sin u)).
  { unfold t. replace (F * (sin th * (eps / sin u))) with (F * (eps * sin th) / sin u) by (field; lra). rewrite T.
    rewrite <- N. field. lra. }
  assert (EJ2 : J = F * (cos th * cos b) - d * (cos th * cos b) + cos b * (F * (sin th * t)) - d * (sin th * t * cos
    b))
    by (rewrite EJ; ring).
  rewrite EJ2, ET, Ed. unfold Q. replace u with (2 * d) by (unfold d; field). field. repeat split; lra.
Qed.
End Last.
