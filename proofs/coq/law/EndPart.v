(** Condition (C11) of law.md on a part of d = u/2, computed, and that it is enough (src/verify/wings/law/end.cpp).

    narrow, refine   == kh from its equation; q = (Q - pi/2)/d from J - Q = d A
    beyond           == eps > 1/1000 on the whole part
    part_holds       == (C11) on a part that begins at [least]
    facts, values_are == what is known of the last contact, in these terms
    narrow_in, refine_in, not_beyond == kh and q are where they are looked for
    parts_in         == the formulas' parts enclose
    part_sound       == (C11) at a last contact of the part *)
From Coq Require Import Reals ZArith Lra List Bool.
From Interval Require Import Real.Xreal Float.Basic Float.Sig Interval.Interval Interval.Float Interval.Float_full.
From Dumbbell Require Import Signs Quotients PiValue LawStatement Angles Clock Midpoint Comparison Ends Defect Slopes
  Terms EndTerms
  EndAtZero EndContact EndShare EndSlopes EndMoments.
Local Open Scope R_scope.

Module EndPart (F : FloatOps with Definition sensible_format := true).
Module Export M := EndMoments F.
Section S.
Variable p : F.precision.
Notation "a + b" := (I.add p a b) : interval_scope.
Notation "a - b" := (I.sub p a b) : interval_scope.
Notation "a * b" := (I.mul p a b) : interval_scope.
Notation "a / b" := (I.div p a b) : interval_scope.
Delimit Scope interval_scope with i.
Notation num := (I.fromZ p).
Notation sq := (I.sqr p).

Section Part.
Variable part : I.type.
Definition first_kh := I.join I.zero (num 1 / num 2)%i.
Definition first_q := I.join (num (-1) / num 10)%i (num 6 / num 10)%i.
Fixpoint narrow (n : nat) : I.type :=
  match n with
  | O => first_kh
  | S n => let kh := narrow n in
    I.meet kh ((sq (whole (sinc_slope p part (num 1))) + d2 p part * lift_i p part kh) / (pi_i p - part))%i
  end.
Definition drift (epsh : I.type) : I.type :=
  (I.join (I.neg (num 53 / num 80 * sq epsh)) (part * d2 p part * sq epsh / num 4))%i.
Definition contact_and_flight (kh q : I.type) := let i := contact_slopes p part kh q in (i, flight_of _ (slopes p
  part) i).
Fixpoint refine (n : nat) (kh : I.type) : I.type :=
  match n with
  | O => first_q
  | S n => let q := refine n kh in let '(i, f) := contact_and_flight kh q in
    I.meet q (drift (values p part (tepsh _ f)) - values p part (offset_of _ (slopes p part) i f))%i
  end.
Definition turn (q : I.type) : I.type :=
  I.neg (I.sqrt p (I.sqrt p (num 3)) * (num 16 * q + num 7) / (num 36 * (pi_i p * I.sqrt p (pi_i p))))%i.
Definition beyond (kh : I.type) : bool := let '(_, f) := contact_and_flight kh first_q in
  above_zero (d2 p part * values p part (tepsh _ f) - num 1 / num 1000)%i.
Definition part_holds (least : I.type) (n1 n2 : nat) : bool :=
  let kh := narrow 4 in beyond kh ||
  (let q := refine 3 kh in let '(i, f) := contact_and_flight kh q in let A := offset_of _ (slopes p part) i f in
   let m := moment_slopes p part n1 n2 kh q (I.join q (q + values p part A)%i) in
   let surplus := ((turn q + part * bend (share_slope p part i f A m)) / I.sqrt p (values p part (tepsh _ f)) +
     num 1657 / num 10000)%i in
   let slack := (num 3 / num 1000 + least / num 2)%i in
   above_zero (slack + surplus)%i && above_zero (slack - surplus)%i).

(* ---------- soundness ---------- *)
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
Let kappa := sin y.
Hypothesis HQ : PI/2 - 0.1 * d <= Q <= PI/2 + 0.6 * d.
Hypothesis HJ : PI/2 - 5.3 * eps^2 / u^3 <= J <= PI/2 + eps^2 / 4.
Hypothesis Hp : inI d part.
Let l := r / (2 * d^2) / (d * d).
Let q := (Q - PI/2) / d.
Let kh := kappa / (d * d).
Let ab := 2 * r / (kappa * kappa).
Let epsh := eps / (d * d).

Lemma facts : 0 < d <= 0.09 /\ 0 < eps /\ 0 < kappa /\ 2 * (kappa * F) = 2 * (sin d * sin d) + r /\ 0 < J <= Q /\ Q <
  PI - u /\
  u = 2 * d /\ kappa * kappa / 2 <= r <= kappa * kappa / 2 * (1 + kappa * kappa) /\ y <= 0.18.
Proof.
  destruct (last_facts eps u al y H Heps Hu HQ (proj2 HJ)) as [D [E0 [Y [Sy [_ [_ [_ [_ [N [J0 [Q0 _]]]]]]]]]]].
  assert (T := tangent_rise y ltac:(lra)). assert (Eu : u = 2 * d) by (unfold d; field).
  split; [exact D|]. split; [exact E0|]. split; [exact Sy|]. split; [exact N|]. split; [exact J0|]. split; [exact
    Q0|].
  split; [exact Eu|]. split; [exact T | lra].
Qed.
(** 1 <= 2 r/kappa^2 <= 1 + kappa^2. *)
Lemma ab_range : 1 <= ab <= 1 + d * d * kh * (d * d * kh).
Proof.
  destruct facts as [D [_ [K [_ [_ [_ [_ [[R1 R2] _]]]]]]]]. assert (K2 : 0 < kappa * kappa) by pos.
  replace (d * d * kh) with kappa by (unfold kh; field; lra). unfold ab.
  split; [apply quotient_at_least | apply quotient_at_most]; lra.
Qed.
Lemma lift_in khi : inI kh khi -> inI l (lift_i p part khi).
Proof.
  intros Hk. destruct facts as [D [_ [K [_ [_ [_ [_ [_ _]]]]]]]]. assert (A := ab_range).
  replace l with (kh * kh / 4 * ab) by (unfold l, kh, ab; field; lra). unfold lift_i.
  apply mul_in; [apply div_in; [now apply X.sqr_in | apply fromZ_in]|].
  apply (join_in 1 (1 + d * d * kh * (d * d * kh))); [apply fromZ_in | | exact A].
  apply add_in; [apply fromZ_in|]. apply X.sqr_in, mul_in; [now apply d2_in | exact Hk].
Qed.
Lemma kh_first : inI kh first_kh.
Proof.
  destruct facts as [D [_ [K [N [_ [_ [_ [[R1 R2] Y]]]]]]]]. assert (P := pi_value). assert (DD : 0 < d * d) by pos.
  apply (join_in 0 (1/2)); [exact zero_in | apply div_in; apply fromZ_in|]. unfold kh.
  split; [apply quotient_at_least; lra | apply quotient_at_most; [lra|]].
  assert (S2 := Sines.sine_square d ltac:(lra)). assert (Ky : kappa <= 1) by (apply SIN_bound).
  assert (K1 : kappa * kappa <= 1 * kappa) by pos. assert (K3 : kappa * kappa * kappa <= 1 * 1 * kappa).
  { repeat apply Rmult_le_compat; pos. }
  assert (K4 : kappa * kappa * (kappa * kappa) <= kappa * 1) by (replace (kappa * kappa * (kappa * kappa)) with
    (kappa * (kappa * kappa * kappa)) by ring; apply Rmult_le_compat_l; lra).
  assert (F1 : kappa * 3 <= kappa * F) by (apply Rmult_le_compat_l; unfold F; lra). lra.
Qed.
Lemma narrow_in n : inI kh (narrow n).
Proof.
  destruct facts as [D [_ [K [N _]]]]. assert (P := pi_value). induction n as [|n IH]; [exact kh_first|]. cbn
    [narrow].
  apply meet_in; [exact IH|]. assert (F0 : 0 < F) by (unfold F; lra).
  replace kh with (((sin d / d) * (sin d / d) + d * d * l) / (PI - d)).
  - apply div_in; [|apply sub_in; [apply pi_in | exact Hp]]. apply add_in; [|apply mul_in; [now apply d2_in | now
    apply lift_in]].
    apply X.sqr_in. assert (E := sinc_encl p part d D Hp 1 (num 1) ltac:(lra)). replace (1 * 1) with 1 in E by ring.
    specialize (E (fromZ_in p 1)). replace (sin d / d) with (at_U (EndIntegrals.sinc_jet d 1)); [apply E|].
    assert (V := EndIntegrals.sinc_value d 1 ltac:(lra)). rewrite Rmult_1_l in V. rewrite <- V. field. lra.
  - unfold kh, l. fold F. replace kappa with ((sin d * sin d + r / 2) / F) by (replace r with (2 * (kappa * F) - 2 *
    (sin d * sin d)) by lra; field; lra).
    field. lra.
Qed.

Variable khi : I.type.
Hypothesis Hk : inI kh khi.
Let i := contact_jets d q l.
Let f := flight_of jet (jets d) i.
Let A := offset_of jet (jets d) i f.
Lemma parts_in qi : inI q qi -> let '(s, g) := contact_and_flight khi qi in contact_encl d i s /\ flight_encl d f g /\
  encl d A (offset_of _ (slopes p part) s g).
Proof.
  intros Hq. destruct facts as [D _]. unfold contact_and_flight.
  assert (C := contact_jets_encl p part d D Hp q qi l khi Hq (lift_in khi Hk)).
  assert (G := flight_of_encl p part d D Hp i _ C). split; [exact C|]. split; [exact G|]. exact (offset_encl p part d
    D Hp i _ f _ C G).
Qed.
Lemma values_are : at_U (tepsh jet f) = epsh /\ at_U A = (J - Q) / d.
Proof.
  destruct (flight_values eps u al y H Heps Hu HQ (proj2 HJ)) as [_ [_ [_ V]]].
  split; [exact V | exact (offset_value eps u al y H Heps Hu HQ (proj2 HJ))].
Qed.
Lemma drift_in e : inI epsh e -> inI ((J - PI/2) / d) (drift e).
Proof.
  intros He. destruct facts as [D [E0 [_ [_ [_ [_ [Eu _]]]]]]]. unfold drift.
  apply (join_in (- (53 / 80 * (epsh * epsh))) (d * (d * d) * (epsh * epsh) / 4)).
  - apply neg_in, mul_in; [apply div_in; apply fromZ_in | now apply X.sqr_in].
  - apply div_in; [|apply fromZ_in]. apply mul_in; [apply mul_in; [exact Hp | now apply d2_in] | now apply X.sqr_in].
  - split; [apply quotient_at_least | apply quotient_at_most]; try lra.
    + replace (- (53 / 80 * (epsh * epsh)) * d) with (- (53 / 10 * (eps^2 / u^3)))
        by (rewrite Eu; unfold epsh; field; lra). lra.
    + replace (d * (d * d) * (epsh * epsh) / 4 * d) with (eps^2 / 4) by (unfold epsh; field; lra). lra.
Qed.
Lemma q_first : inI q first_q.
Proof.
  destruct facts as [D _]. apply (join_in (-1/10) (6/10)); [apply div_in; apply fromZ_in | apply div_in; apply
    fromZ_in|].
  unfold q. split; [apply quotient_at_least | apply quotient_at_most]; lra.
Qed.
Lemma refine_in n : inI q (refine n khi).
Proof.
  destruct facts as [D _]. induction n as [|n IH]; [exact q_first|]. cbn [refine]. assert (K := parts_in _ IH).
  destruct (contact_and_flight khi (refine n khi)) as [s g]. destruct K as [_ [[_ _ _ K1] K2]]. apply meet_in; [exact
    IH|].
  destruct values_are as [V1 V2]. replace q with ((J - PI/2) / d - at_U A) by (rewrite V2; unfold q; field; lra).
  apply sub_in.
  - apply drift_in. rewrite <- V1. apply (values_in p d ltac:(lra)); assumption.
  - apply (values_in p d ltac:(lra)); assumption.
Qed.

Lemma turn_in qi : inI q qi -> inI (- (sqrt (sqrt 3) * (16 * q + 7) / (36 * (PI * sqrt PI)))) (turn qi).
Proof.
  intros Hq. assert (PP := pi_in p). apply neg_in, div_in.
  - apply mul_in; [apply X.sqrt_in, X.sqrt_in, fromZ_in|]. apply add_in; [apply mul_in; [apply fromZ_in | exact Hq] |
    apply fromZ_in].
  - apply mul_in; [apply fromZ_in|]. apply mul_in; [exact PP | now apply X.sqrt_in].
Qed.
Lemma not_beyond : beyond khi = false.
Proof.
  destruct facts as [D _]. unfold beyond. assert (K := parts_in _ q_first). destruct (contact_and_flight khi first_q)
    as [s g].
  destruct K as [_ [[_ _ _ K1] _]]. apply not_true_is_false. intros B. destruct values_are as [V1 _].
  assert (L := values_in p d ltac:(lra) _ _ _ Hp K1). rewrite V1 in L.
  assert (W := above_zero_true _ _ B (sub_in p _ _ _ _ (mul_in p _ _ _ _ (d2_in p part d Hp) L)
    (div_in p _ _ _ _ (fromZ_in p 1) (fromZ_in p 1000)))).
  replace (d * d * epsh) with eps in W by (unfold epsh; field; lra). lra.
Qed.
End Part.

Theorem part_sound part n1 n2 least lo eps u al y : part_holds part least n1 n2 = true -> (0 < n1)%nat /\ (0 <
  n2)%nat ->
  last eps u al y -> eps <= 1/1000 -> u <= 0.18 ->
  PI/2 - 0.1 * (u / 2) <= (PI - u / 2) * cos (al + beta eps u) <= PI/2 + 0.6 * (u / 2) ->
  PI/2 - 5.3 * eps^2 / u^3 <= invariant u al <= PI/2 + eps^2 / 4 ->
  inI (u / 2) part -> inI lo least -> lo <= u / 2 ->
  Rabs (clock eps u al - 1 - step_constant * sqrt eps + 0.1657 * eps) <= (0.003 + 0.5 * (u / 2)) * eps.
Proof.
  intros Ok Hn H Heps Hu HQ HJ Hp Hlo Hlod. destruct (facts eps u al y H Heps Hu HQ HJ) as [D [E0 [K [_ [J0 [Q0 [Eu
    _]]]]]]].
  set (d := u / 2) in *. assert (Hk := narrow_in part eps u al y H Heps Hu HQ HJ Hp 4). cbv zeta in Hk.
  unfold part_holds in Ok. cbv zeta in Ok. rewrite (not_beyond part eps u al y H Heps Hu HQ HJ Hp _ Hk) in Ok.
  assert (Hq := refine_in part eps u al y H Heps Hu HQ HJ Hp _ Hk 3). cbv zeta in Hq. fold d in Hk, Hq.
  set (khi := narrow part 4) in *. set (qi := refine part 3 khi) in *. cbn [orb] in Ok.
  assert (C := parts_in part eps u al y H Heps Hu HQ HJ Hp khi Hk qi Hq). cbv zeta in C. fold d in C.
  destruct (values_are eps u al y H Heps Hu HQ HJ) as [V1 V2]. fold d in V1, V2.
  destruct (contact_and_flight part khi qi) as [s g]. destruct C as [C1 [C2 C3]]. assert (HN : d <> 0) by lra.
  set (Q := (PI - d) * cos (al + beta eps u)) in *. set (J := invariant u al) in *. set (q := (Q - PI/2) / d) in *.
  set (l := tangent_r y / (2 * d^2) / (d * d)) in *. set (i := contact_jets d q l) in *.
  set (f := flight_of jet (jets d) i) in *. set (A := offset_of jet (jets d) i f) in *.
  set (Ai := offset_of slope (slopes p part) s g) in *.
  assert (VA := values_in p d HN _ _ _ Hp C3). assert (Ve := values_in p d HN _ _ _ Hp (eepsh _ _ _ C2)).
  rewrite V2 in VA. rewrite V1 in Ve.
  assert (Hx : inI q (I.join qi (I.add p qi (values p part Ai))) /\ inI ((J - PI/2) / d) (I.join qi (I.add p qi
    (values p part Ai)))).
  { replace ((J - PI/2) / d) with (q + (J - Q) / d) by (unfold q; field; lra).
    split; apply I.join_correct; [now left | right; now apply add_in]. }
  set (xi := I.join qi (I.add p qi (values p part Ai))) in *.
  destruct (midpoint_somewhere d Q D ltac:(assert (P := pi_value); lra)) as [a3 [a4 [H3 [H4 HM]]]].
  destruct (gain_somewhere u J Q ltac:(assert (P := pi_value); lra) (proj1 J0) (conj (proj2 J0) Q0)) as [t [X0 [Ht
    [HX HG]]]].
  assert (Ej : PI/2 + d * ((J - PI/2) / d) = J) by (field; lra). assert (Eq : PI/2 + d * q = Q) by (unfold q; field;
    lra).
  assert (M := moments_in p part d D Hp n1 n2 khi qi xi q ((J - PI/2) / d) _ _ a3 a4 t X0 Hn ltac:(lra) ltac:(lra) Hk
    (ab_range eps u al y H Heps Hu HQ HJ) Hq Hx). cbv zeta in M. rewrite Ej, Eq in M. rewrite <- Eu in M.
  specialize (M H3 H4 Ht HX).
  assert (B := share_encl p part d D Hp i s f g A Ai _ _ C1 C2 C3 M).
  assert (V := share_value eps u al y H Heps Hu HQ (proj2 HJ) a3 a4 X0 HM HG). cbv zeta in V. fold d Q in V. fold q l
    in V.
  match type of B with encl _ ?x _ => set (S := x) in *; change (at_U S = (clock eps u al - 1) / sqrt eps) in V end.
  destruct (share_base d q l (2 * tangent_r y / (sin y * sin y)) (moment_cos d 2) (moment_cos d 4 * a4 / 12)
    (moment_sin d 1)
    (moment_sin d 3 * a3 / 6) (tau_J u Q / (u * u)) (X0 / (u * u))) as [S0 S1].
  change (at_0 S = sqrt (sqrt 3) / (9 * sqrt PI)) in S0.
  change (slope_0 S = - (sqrt (sqrt 3) * (16 * q + 7) / (36 * (PI * sqrt PI)))) in S1.
  assert (T := turn_in eps u al qi Hq). cbv zeta in T. fold d Q q in T. rewrite <- S1 in T.
  assert (Sb : inI (bend_of d S) (bend (share_slope p part s g Ai (moment_slopes p part n1 n2 khi qi xi)))) by apply
    B.
  set (epsh := eps / (d * d)) in *. assert (EP : 0 < epsh) by (unfold epsh; pos).
  assert (R := add_in p _ _ _ _ (div_in p _ _ _ _ (add_in p _ _ _ _ T (mul_in p _ _ _ _ Hp Sb)) (X.sqrt_in p _ _ Ve))
    (div_in p _ _ _ _ (fromZ_in p 1657) (fromZ_in p 10000))).
  assert (L := add_in p _ _ _ _ (div_in p _ _ _ _ (fromZ_in p 3) (fromZ_in p 1000)) (div_in p _ _ _ _ Hlo (fromZ_in p
    2))).
  apply andb_prop in Ok. destruct Ok as [Ok1 Ok2].
  assert (W1 := above_zero_true _ _ Ok1 (add_in p _ _ _ _ L R)). assert (W2 := above_zero_true _ _ Ok2 (sub_in p _ _
    _ _ L R)).
  assert (Sq : 0 < sqrt epsh) by (now apply sqrt_lt_R0). assert (Se := sqrt_sqrt epsh ltac:(lra)).
  assert (Er : sqrt eps = d * sqrt epsh).
  { replace eps with (d * d * epsh) by (unfold epsh; field; lra). rewrite sqrt_mult_alt, sqrt_square by pos.
    reflexivity. }
  assert (S00 : 0 < sqrt eps) by (now apply sqrt_lt_R0).
  assert (EV : clock eps u al - 1 = sqrt eps * at_U S) by (rewrite V; field; lra).
  assert (ES : at_U S = at_0 S + d * (slope_0 S + d * bend_of d S)) by (unfold bend_of, rise_of; field; lra).
  set (sg := (slope_0 S + d * bend_of d S) / sqrt epsh + 1657 / 10000) in *.
  replace (clock eps u al - 1 - step_constant * sqrt eps + 0.1657 * eps) with (sg * eps).
  - rewrite Rabs_mult, (Rabs_pos_eq eps) by lra. apply Rmult_le_compat_r; [lra|]. apply Rabs_le. lra.
  - assert (EK : step_constant = at_0 S).
    { rewrite S0, step_constant_is. destruct root3 as [T3 [T0 _]]. assert (f4 := sqrt_sqrt (sqrt 3) (Rlt_le _ _ T0)).
      assert (f0 := sqrt_lt_R0 _ T0). assert (SP := sqrt_lt_R0 PI PI_RGT_0). field_simplify_eq; [ring [f4 T3] | lra].
        }
    rewrite EV, ES, EK, Er. assert (Ee : eps = d * d * (sqrt epsh * sqrt epsh)) by (rewrite Se; unfold epsh; field;
      lra).
    rewrite Ee. unfold sg. replace 0.1657 with (1657 / 10000) by lra. set (w := sqrt epsh) in *. field. lra.
Qed.
End S.
End EndPart.
