(** The end on slopes (src/verify/wings/law/end.cpp): the formulas of EndTerms.v with intervals, over a part of d =
    u/2. They enclose the jets of EndShare.v.

    sinc_slope, quarter_line == sinc (k d), and pi/2 + q d
    contact_slopes           == the last contact, from enclosures of kh and q
    integral_H, integral_H2  == the integrals of EndIntegrals.v
    far_3, far_4, moment_slopes == G3 and G4; all moments
    share_slope              == (T - 1)/sqrt eps
    first_tails              == sine and cosine to two terms
    sinc_encl, contact_jets_encl, flight_of_encl, offset_encl, share_encl == they enclose *)
From Coq Require Import Reals ZArith Lra List.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Real.Xreal Float.Basic Float.Sig Interval.Interval Interval.Float Interval.Float_full.
From Dumbbell Require Import Signs Tails PiValue Clock Midpoint Defect Slopes Terms Means EndTerms EndAtZero
  EndContact EndShare
  EndIntegrals.
Local Open Scope R_scope.

Module EndSlopes (F : FloatOps with Definition sensible_format := true).
Module Export M := Means F.
Section S.
Variable p : F.precision.
Notation "a + b" := (I.add p a b) : interval_scope.
Notation "a - b" := (I.sub p a b) : interval_scope.
Notation "a * b" := (I.mul p a b) : interval_scope.
Notation "a / b" := (I.div p a b) : interval_scope.
Delimit Scope interval_scope with i.
Notation num := (I.fromZ p).
Notation sq := (I.sqr p).
Definition pi_i := I.pi p.
Definition zero_to_one := I.join I.zero (num 1).
Definition half_H := (num 4 / (num 3 * I.sqrt p (num 3) * sq pi_i))%i.   (* H(pi, pi/2)/2 *)

Section Part.
Variable part : I.type.   (* of d *)
Definition d2 := sq part.
(** tail_sin x = 1 - x^2/20 b. *)
Definition sinc_slope (k2 : I.type) : slope :=
  curve p part (num 1) (I.neg (k2 / num 6 * (num 1 - k2 * d2 / num 20 * zero_to_one)))%i.
Definition quarter_line (q : I.type) : slope := line p part (pi_i / num 2)%i q.
Definition lift_i (kh : I.type) := (sq kh / num 4 * I.join (num 1) (num 1 + sq (d2 * kh)))%i.
Definition contact_slopes (kh q : I.type) : contact slope :=
  {| tF := line p part pi_i (num (-1)); tQ := quarter_line q; td := line p part I.zero (num 1);
     twave := sinc_slope (num 1); tdouble := sinc_slope (num 4);
     tcos := curve p part (num 1) (I.neg (num 1 / num 2 * (num 1 - d2 / num 12 * zero_to_one)))%i;
     tlift := curve p part I.zero (lift_i kh) |}.
Definition slices (n : nat) (f : slope -> slope -> slope) : list (I.type * slope) :=
  map (fun i => let k := I.mul2 p (slice p n i) in (weight p n i, f (sinc_slope (sq k)) (line p part pi_i (I.neg
    k)))) (seq 0 n).
Definition mean_of (field : slope -> I.type) (l : list (I.type * slope)) := mean p (map (fun s => (fst s, field (snd
  s))) l).
Definition integral_H (n : nat) (q : I.type) : slope :=
  let l := slices n (fun w F => weight_H _ (slopes p part) w F (quarter_line q)) in
  {| zero := half_H; first := I.mul2 p half_H * (q + num 2) / pi_i; rise := mean_of rise l; bend := mean_of bend l;
     whole := mean_of whole l |}%i.
Definition integral_H2 (n : nat) (q : I.type) : slope :=
  let l := slices n (fun w F => weight_H2 _ (slopes p part) w F (quarter_line q)) in let r := mean_of rise l in
  {| zero := I.mul2 p half_H / pi_i; first := r; rise := r; bend := I.zero; whole := mean_of whole l |}%i.

(** G3 and G4 of Midpoint.v. *)
Definition far_3 (F Q : I.type) := let r := I.sqrt p (sq F - sq Q)%i in let r3 := (r * sq r)%i in
  (I.neg Q * (num 6 / (sq (sq F) * r) + num 3 / (sq F * r3) + num 15 * sq F / (r * sq r3)))%i.
Definition far_4 (F Q : I.type) := let r := I.sqrt p (sq F - sq Q)%i in let r3 := (r * sq r)%i in
  (Q * (num 24 / (F * sq (sq F) * r) + num 12 / (F * sq F * r3) + num 9 / (F * (r * sq (sq r))) - num 30 * F / (r *
    sq r3) +
        num 105 * (F * sq F) / (r * sq (sq (sq r)))))%i.
(** From kh, q and (J - pi/2)/d. *)
Definition moment_slopes (n1 n2 : nat) (kh q x : I.type) : moments slope :=
  let F := (pi_i - part + I.join (I.neg part) part)%i in let Q := (pi_i / num 2 + part * q)%i in
  {| tabove := curve p part (num 1) (I.join I.zero (d2 * sq kh))%i;
     tI2 := curve p part (num 1 / num 3)%i (I.neg (num 1 / num 10 * zero_to_one))%i;
     tI4 := curve p part I.zero (I.join (num 1 - d2 / num 2) (num 1) / num 5 * far_4 F Q / num 12)%i;
     tJ1 := curve p part (num 1 / num 3)%i (I.neg (num 1 / num 30 * (num 1 - d2 / num 28 * zero_to_one)))%i;
     tJ3 := curve p part I.zero (I.join (num 1 - d2 / num 6) (num 1) / num 5 * far_3 F Q / num 6)%i;
     tg1 := integral_H n1 q; tg2 := integral_H2 n2 x |}.
Definition share_slope (i : contact slope) (f : flight slope) (A : slope) (m : moments slope) : slope :=
  let o := slopes p part in share_of slope o i f A (bends_of slope o (tF slope i) (tQ slope i)) m.

(* ---------- soundness ---------- *)
Variable d : R.
Hypothesis Hd : 0 < d <= 0.09.
Hypothesis Hp : inI d part.
Lemma not_0 : d <> 0.
Proof. lra. Qed.
Lemma pi_in : inI PI pi_i.
Proof. exact (I.pi_correct p). Qed.
Lemma d2_in : inI (d * d) d2.
Proof. now apply X.sqr_in. Qed.
Lemma unit_in b : 0 <= b <= 1 -> inI b zero_to_one.
Proof. intros H. apply (join_in 0 1); [exact zero_in | apply fromZ_in | exact H]. Qed.
Lemma H_at_0_in : inI (H_at_0 / 2) half_H.
Proof.
  destruct root3 as [T [T0 T1]]. assert (P := PI_RGT_0).
  replace (H_at_0 / 2) with (4 / (3 * sqrt 3 * (PI * PI))) by (unfold H_at_0; field; lra).
  apply div_in; [apply fromZ_in|]. apply mul_in; [apply mul_in; [apply fromZ_in | apply X.sqrt_in, fromZ_in] | apply
    X.sqr_in, pi_in].
Qed.
Lemma double_H_in : inI H_at_0 (I.mul2 p half_H).
Proof. replace H_at_0 with (2 * (H_at_0 / 2)) by field. apply mul2_in, H_at_0_in. Qed.

(** x - y b, where b is in [0, 1]. *)
Lemma first_tails x : 0 <= x <= 1 -> (exists b, 0 <= b <= 1 /\ tail_sin x = 1 - x^2 / 20 * b) /\
  (exists b, 0 <= b <= 1 /\ tail_cos x = 1 - x^2 / 12 * b).
Proof.
  intros Hx. assert (X2 : 0 <= x^2 <= 1) by (split; [apply pow2_ge_0 | replace 1 with (1^2) by ring; apply pow_incr;
    lra]).
  assert (K : forall m n b, 2 <= m -> 2 <= n -> 0 <= b <= 1 -> 0 <= 1 - x^2 / m * (1 - x^2 / n * b) <= 1).
  { intros m n b Hm Hn Hb.
    assert (W : forall k, 2 <= k -> 0 <= x^2 / k <= 1/2).
    { intros k Hk. split; [pos | apply Quotients.quotient_at_most; lra]. }
    assert (A := W m Hm). assert (B := W n Hn). assert (0 <= x^2 / n * b <= 1/2 * 1) by (split; pos).
    assert (0 <= x^2 / m * (1 - x^2 / n * b) <= 1/2 * 1) by (split; [apply Rmult_le_pos | apply Rmult_le_compat];
      lra). lra. }
  split.
  - destruct (tail_sin_is x) as [b [B E]]. eexists. split; [apply (K 42 72 b); lra | exact E].
  - destruct (tail_cos_is x) as [b [B E]]. eexists. split; [apply (K 30 56 b); lra | exact E].
Qed.
Lemma sinc_encl k k2 : 0 <= k <= 2 -> inI (k * k) k2 -> encl d (sinc_jet d k) (sinc_slope k2).
Proof.
  intros Hk H. apply curve_encl; [exact not_0 | exact Hp | apply fromZ_in|].
  assert (R : 0 <= k * d <= 1) by (split; [pos | apply Rle_trans with (2 * 0.09); [pos | lra]]).
  destruct (first_tails _ R) as [[b [B ->]] _]. replace ((k * d)^2) with (k * k * (d * d)) by ring.
  apply neg_in, mul_in; [apply div_in; [exact H | apply fromZ_in]|]. apply sub_in; [apply fromZ_in|].
  apply mul_in; [apply div_in; [apply mul_in; [exact H | exact d2_in] | apply fromZ_in] | now apply unit_in].
Qed.
Lemma quarter_encl q qi : inI q qi -> encl d (jline d (PI/2) q) (quarter_line qi).
Proof. intros H. apply line_encl; [exact not_0 | exact Hp | apply div_in; [exact pi_in | apply fromZ_in] | exact H].
  Qed.

Record contact_encl (i : contact jet) (s : contact slope) : Prop := { eF : encl d (tF _ i) (tF _ s); eQ : encl d (tQ
  _ i) (tQ _ s);
  ed : encl d (td _ i) (td _ s); ewave : encl d (twave _ i) (twave _ s); edouble : encl d (tdouble _ i) (tdouble _ s);
  ecos : encl d (tcos _ i) (tcos _ s); elift : encl d (tlift _ i) (tlift _ s) }.
Record flight_encl (f : flight jet) (s : flight slope) : Prop := { ekh : encl d (tkh _ f) (tkh _ s);
  ecosine : encl d (tcosine _ f) (tcosine _ s); esine : encl d (tsine _ f) (tsine _ s); eepsh : encl d (tepsh _ f)
    (tepsh _ s) }.
Record moments_encl (m : moments jet) (s : moments slope) : Prop := { eabove : encl d (tabove _ m) (tabove _ s);
  eI2 : encl d (tI2 _ m) (tI2 _ s); eI4 : encl d (tI4 _ m) (tI4 _ s); eJ1 : encl d (tJ1 _ m) (tJ1 _ s);
  eJ3 : encl d (tJ3 _ m) (tJ3 _ s); eg1 : encl d (tg1 _ m) (tg1 _ s); eg2 : encl d (tg2 _ m) (tg2 _ s) }.

Lemma contact_jets_encl q qi l kh : inI q qi -> inI l (lift_i kh) -> contact_encl (contact_jets d q l)
  (contact_slopes kh qi).
Proof.
  assert (HN := not_0). intros Hq Hl. constructor; cbn [contact_jets contact_slopes tF tQ td twave tdouble tcos
    tlift].
  - apply line_encl; [exact HN | exact Hp | exact pi_in | apply fromZ_in].
  - now apply quarter_encl.
  - apply line_encl; [exact HN | exact Hp | exact zero_in | apply fromZ_in].
  - replace (jcurve d 1 ((sin d / d - 1) / (d * d))) with (sinc_jet d 1).
    + apply sinc_encl; [lra|]. replace (1 * 1) with 1 by ring. apply fromZ_in.
    + unfold sinc_jet. f_equal. rewrite (sin_tail d). replace (1 * d) with d by ring. field. exact HN.
  - replace (jcurve d 1 ((sin (2 * d) / (2 * d) - 1) / (d * d))) with (sinc_jet d 2).
    + apply sinc_encl; [lra|]. replace (2 * 2) with 4 by ring. apply fromZ_in.
    + unfold sinc_jet. f_equal. rewrite (sin_tail (2 * d)). field. exact HN.
  - apply curve_encl; [exact HN | exact Hp | apply fromZ_in|].
    replace ((cos d - 1) / (d * d)) with (- (1 / 2 * tail_cos d)) by (rewrite (cos_tail d); field; exact HN).
    destruct (first_tails d ltac:(lra)) as [_ [b [B ->]]]. replace (d^2) with (d * d) by ring.
    apply neg_in, mul_in; [apply div_in; apply fromZ_in|]. apply sub_in; [apply fromZ_in|].
    apply mul_in; [apply div_in; [exact d2_in | apply fromZ_in] | now apply unit_in].
  - apply curve_encl; [exact HN | exact Hp | exact zero_in | exact Hl].
Qed.
Lemma flight_of_encl i s : contact_encl i s -> flight_encl (flight_of _ (jets d) i) (flight_of _ (slopes p part) s).
Proof.
  assert (HN := not_0). intros [A1 A2 A3 A4 A5 A6 A7]. constructor; cbn [flight_of tkh tcosine tsine tepsh]; enclose.
Qed.
Lemma offset_encl i s f g : contact_encl i s -> flight_encl f g ->
  encl d (offset_of _ (jets d) i f) (offset_of _ (slopes p part) s g).
Proof.
  assert (HN := not_0). intros [A1 A2 A3 A4 A5 A6 A7] [B1 B2 B3 B4]. unfold offset_of. cbv zeta. enclose.
Qed.
Theorem share_encl i s f g A B m n : contact_encl i s -> flight_encl f g -> encl d A B -> moments_encl m n ->
  encl d (share_of _ (jets d) i f A (bends_of _ (jets d) (tF _ i) (tQ _ i)) m) (share_slope s g B n).
Proof.
  assert (HN := not_0). intros [A1 A2 A3 A4 A5 A6 A7] [B1 B2 B3 B4] HA [C1 C2 C3 C4 C5 C6 C7].
  unfold share_slope, share_of, bends_of. cbv zeta. cbn [fst snd]. enclose.
Qed.
End Part.
End S.
End EndSlopes.
