(** The computable counts: at_most (L5 (e) from below), at_least (from above), and their soundness.

    guesses, consts               == where roots are looked for, which is not trusted; enclosures of pi, 1, ...
    low, up                       == an interval's lower, upper end as a number
    low0, up0                     == the greater of it and 0
    at_most, at_least             == computed: the ray has at most, at least, n collisions
    misses, earliest              == computed: it has none; the first one is not before here
    at_most_sound, at_least_sound == L5 (e): what is computed holds for rays above, or below, the enclosed one *)
From Coq Require Import Reals ZArith Lra Lia List Bool.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Real.Xreal Float.Basic Float.Sig Interval.Interval Interval.Float Interval.Float_full.
From Dumbbell Require Import Trigonometry Ray Enclosure SineCosine.
Local Open Scope R_scope.

Module Count (F : FloatOps with Definition sensible_format := true).
Module Export Y := Fast F.
Export X.

Section S.
Variable p : F.precision.
(** Untrusted guesses: near the least root of sin z = c + k z, from the guess before; a little behind it; near acos k.
  *)
Record guesses := { near_root : I.type -> I.type -> F.type -> F.type; behind_root : I.type -> I.type -> F.type ->
  F.type;
  seems_to_hit : I.type -> I.type -> F.type -> bool; near_top : I.type -> F.type; first_guess : F.type;
  quick : bool (* the sine of SineCosine.v is good enough: its error is 2^-60 *) }.
Variable G : guesses.
Record consts := { fast : tab; pi_ : I.type; quarter : I.type; half : I.type; unit_ : I.type }.
Definition mkconsts : consts := {| fast := mktab p; pi_ := I.pi p; quarter := I.div p (I.pi p) (I.fromZ p 2);
  half := I.div p (I.fromZ p 1) (I.fromZ p 2); unit_ := I.fromZ p 1 |}.
Variable T : consts.

Definition low (i : I.type) : I.type := let l := I.lower i in if F.real l then I.singleton l else I.nai.
Definition up (i : I.type) : I.type := let u := I.upper i in if F.real u then I.singleton u else I.nai.
Definition nonneg i := match I.sign_large i with Xgt | Xeq => true | _ => false end.
Definition pos i := match I.sign_strict i with Xgt => true | _ => false end.
Definition low0 i := if nonneg i then low i else I.zero.
Definition up0 i := if nonneg (I.neg i) then I.zero else up i.
Definition sc (z : I.type) : I.type * I.type :=
  if negb (quick G) then (I.sin p z, I.cos p z) else
  if indom p (fast T) z then (sinT p (fast T) z, cosT p (fast T) z)
  else let h := I.mul p z (half T) in
    if indom p (fast T) h then
      let s := sinT p (fast T) h in let c := cosT p (fast T) h in
      (I.mul2 p (I.mul p s c), I.sub p (I.sqr p c) (I.sqr p s))
    else (I.sin p z, I.cos p z).

Definition DI (w k r : I.type) := I.sub p (I.sub p (I.sqr p w) (I.mul2 p (I.mul p k w))) r.
Definition NI (w k r : I.type) := I.sub p (I.add p (I.mul p k (I.sqr p w)) (I.mul2 p (I.mul p r w))) (I.mul p r k).

Definition misses (c k : I.type) : bool :=
  let z := I.singleton (near_top G k) in
  if nonneg z && nonneg (I.sub p (pi_ T) z) then
    let '(s, w) := sc z in pos (I.add p (I.sub p c s) (I.mul p z w)) &&
    pos (I.sub p (I.sub p (I.add p c (I.mul p k (quarter T))) s) (I.mul p (I.sub p (quarter T) z) w))
  else false.

(** A lower bound of x, sin x and an upper bound of cos x at the next collision. *)
Definition earliest (c k : I.type) (z : F.type) : I.type * I.type * I.type :=
  let zi := I.singleton z in
  let '(s, w) := sc zi in
  let q := I.sub p w k in if nonneg zi && nonneg (I.sub p (pi_ T) zi) && pos q then
    let x := low0 (I.sub p zi (I.div p (I.sub p (I.sub p s (I.mul p k zi)) c) q)) in
    let d := I.sub p x zi in let e := I.sqr p d in
    (x, low (I.sub p (I.add p s (I.mul p d w)) e), up (I.add p (I.sub p w (I.mul p d s)) e))
  else (I.zero, I.zero, unit_ T).

Fixpoint at_most (n : nat) (r c k : I.type) (z : F.type) : bool :=
  if nonneg (I.sub p k (unit_ T)) then true else
  let z' := near_root G c k z in
  if (if seems_to_hit G c k z' then match n with O => misses c k | _ => false end else misses c k) then true else
  match n with
  | O => false
  | S m =>
    let '(x, s, w) := earliest c k z' in
    let D := DI w k r in
    if nonneg (I.neg D) then true else
    let k' := low0 (I.div p (NI w k r) D) in
    at_most m r (low0 (I.add p s (I.mul p k' (I.add p x (pi_ T))))) k' z'
  end.

Fixpoint at_least (n : nat) (r c k : I.type) (z : F.type) : bool :=
  match n with
  | O => true
  | S m =>
    let z' := behind_root G c k z in
    let x := I.singleton z' in
    let '(s, w) := sc x in
    if nonneg x && nonneg (I.sub p (quarter T) x) && pos (I.sub p s (I.add p c (I.mul p k x))) then
      match m with
      | O => true
      | _ => let w := low w in let s := up s in let D := DI w k r in if pos w && pos D then
          let k' := up (I.div p (NI w k r) D) in
          at_least m r (up (I.add p s (I.mul p k' (I.add p x (pi_ T))))) k' z'
        else false
      end
    else false
  end.

(* ---------- soundness ---------- *)
Hypothesis HT : T = mkconsts.

Lemma nai_all x : inI x I.nai.
Proof. unfold inI. now rewrite I.nai_correct. Qed.
Lemma low_ok x i : inI x i -> exists x0, inI x0 (low i) /\ x0 <= x.
Proof.
  intros H. unfold low. rewrite F.real_correct. assert (L : F.toX (I.lower i) = Xlower (I.convert i)) by exact
    (I.lower_correct i (ex_intro _ x H)).
  destruct (F.toX (I.lower i)) as [|l] eqn:E.
  - exists x. split; [apply nai_all | lra].
  - exists l. split.
    + generalize (I.singleton_correct (I.lower i)). unfold I.convert_bound. rewrite E. easy.
    + unfold inI in H. try rewrite E in L. destruct (I.convert i) as [|a b]; [easy|]. simpl in L, H.
      destruct a; [easy|]. injection L; intros ->. lra.
Qed.
Lemma up_ok x i : inI x i -> exists x0, inI x0 (up i) /\ x <= x0.
Proof.
  intros H. unfold up. rewrite F.real_correct. assert (L : F.toX (I.upper i) = Xupper (I.convert i)) by exact
    (I.upper_correct i (ex_intro _ x H)).
  destruct (F.toX (I.upper i)) as [|l] eqn:E.
  - exists x. split; [apply nai_all | lra].
  - exists l. split.
    + generalize (I.singleton_correct (I.upper i)). unfold I.convert_bound. rewrite E. easy.
    + unfold inI in H. try rewrite E in L. destruct (I.convert i) as [|a b]; [easy|]. simpl in L, H.
      destruct b; [easy|]. injection L; intros ->. lra.
Qed.
Lemma nonneg_ok x i : nonneg i = true -> inI x i -> 0 <= x.
Proof.
  unfold nonneg. intros H Hx. generalize (I.sign_large_correct i). destruct (I.sign_large i); try discriminate;
    intros K; specialize (K _ Hx); simpl in K.
  - injection K. lra. - lra.
Qed.
Lemma pos_ok x i : pos i = true -> inI x i -> 0 < x.
Proof.
  unfold pos. intros H Hx. generalize (I.sign_strict_correct i). destruct (I.sign_strict i); try discriminate;
    intros K; specialize (K _ Hx); simpl in K. lra.
Qed.
Lemma low0_ok x i : inI x i -> forall y, x <= y -> 0 <= y -> exists x0, inI x0 (low0 i) /\ x0 <= y.
Proof.
  intros H y Hxy Hy. unfold low0. destruct (nonneg i).
  - destruct (low_ok x i H) as [x0 [A B]]. exists x0. split; [exact A | lra].
  - exists 0. split; [apply zero_in | exact Hy].
Qed.
Lemma low0_ok' x i : inI x i -> forall y, x <= y -> 0 <= y -> exists x0, inI x0 (low0 i) /\ 0 <= x0 <= y.
Proof.
  intros H y Hxy Hy. unfold low0. destruct (nonneg i) eqn:E.
  - unfold low. rewrite F.real_correct. assert (L : F.toX (I.lower i) = Xlower (I.convert i)) by exact (I.lower_correct
    i (ex_intro _ x H)).
    destruct (F.toX (I.lower i)) as [|l] eqn:E2.
    + exists y. split; [apply nai_all | lra].
    + exists l. split.
      * generalize (I.singleton_correct (I.lower i)). unfold I.convert_bound. rewrite E2. easy.
      * try rewrite E2 in L.
        assert (K : inI l i /\ l <= x).
        { unfold inI in *. destruct (I.convert i) as [|a b]; [easy|]. simpl in L, H |- *. destruct a; [easy|].
          injection L; intros ->. destruct b; repeat split; lra. }
        destruct K as [K1 K2]. assert (0 <= l) by (now apply nonneg_ok with (1 := E)). lra.
  - exists 0. split; [apply zero_in | lra].
Qed.
Lemma up0_ok x i : inI x i -> exists x0, inI x0 (up0 i) /\ x <= x0.
Proof.
  intros H. unfold up0. destruct (nonneg (I.neg i)) eqn:E; [|now apply up_ok].
  exists 0. split; [apply zero_in|]. assert (A := nonneg_ok _ _ E (neg_in _ _ H)). lra.
Qed.
Lemma pi_in : inI PI (pi_ T). Proof. rewrite HT. exact (I.pi_correct p). Qed.
Lemma quarter_in : inI (PI/2) (quarter T). Proof. rewrite HT. apply div_in; [exact (I.pi_correct p) | apply fromZ_in].
  Qed.
Lemma half_in : inI (1/2) (half T). Proof. rewrite HT. apply div_in; apply fromZ_in. Qed.
Lemma unit_in : inI 1 (unit_ T). Proof. rewrite HT. apply fromZ_in. Qed.
Lemma sc_ok z zi : inI z zi -> inI (sin z) (fst (sc zi)) /\ inI (cos z) (snd (sc zi)).
Proof.
  intros H. unfold sc. assert (HF : fast T = mktab p) by now rewrite HT. rewrite HF.
  destruct (negb (quick G)); [split; [now apply sin_in | now apply cos_in]|].
  destruct (indom p (mktab p) zi) eqn:E.
  { assert (Hd := indom_ok p zi z E H). split; [now apply sinT_in | now apply cosT_in]. }
  destruct (indom p (mktab p) (I.mul p zi (half T))) eqn:E2; [|split; [now apply sin_in | now apply cos_in]].
  assert (Hh : inI (z * (1/2)) (I.mul p zi (half T))) by (apply mul_in; [exact H | exact half_in]).
  assert (Hd := indom_ok p _ _ E2 Hh). assert (S := sinT_in p _ _ Hd Hh). assert (C := cosT_in p _ _ Hd Hh).
  simpl. replace z with (2 * (z * (1/2))) by field. split.
  - rewrite sin_2a. replace (2 * sin (z * (1/2)) * cos (z * (1/2))) with (2 * (sin (z * (1/2)) * cos (z * (1/2))))
    by ring.
    apply mul2_in. now apply mul_in.
  - rewrite cos_2a. apply sub_in; now apply sqr_in.
Qed.
Lemma DI_in w k r wi ki ri : inI w wi -> inI k ki -> inI r ri -> inI (slope_den w k r) (DI wi ki ri).
Proof. intros. unfold slope_den, DI. replace (2 * k * w) with (2 * (k * w)) by ring.
  apply sub_in; [apply sub_in; [now apply sqr_in | apply mul2_in; now apply mul_in] | assumption]. Qed.
Lemma NI_in w k r wi ki ri : inI w wi -> inI k ki -> inI r ri -> inI (slope_num w k r) (NI wi ki ri).
Proof. intros. unfold slope_num, NI. replace (2 * r * w) with (2 * (r * w)) by ring.
  apply sub_in; [apply add_in; [apply mul_in; [assumption | now apply sqr_in] | apply mul2_in;
    now apply mul_in] | now apply mul_in]. Qed.

Lemma misses_sound c0 k0 ci ki : misses ci ki = true -> inI c0 ci -> inI k0 ki -> forall c k, c0 <= c -> k0 <= k ->
  forall x, ~ hit c k x.
Proof.
  unfold misses. intros H Hc Hk c k Hcc Hkk.
  assert (Hz := single_in (near_top G ki)). set (z := proj_val _) in Hz. set (zi := I.singleton _) in *.
  destruct (nonneg zi && nonneg (I.sub p (pi_ T) zi)) eqn:E; [|discriminate]. apply andb_prop in E.
    destruct E as [E1 E2].
  assert (Z1 := nonneg_ok z zi E1 Hz). assert (Z2 := nonneg_ok (PI - z) _ E2 (sub_in p _ _ _ _ pi_in Hz)).
  destruct (sc_ok z zi Hz) as [Hs Hw]. destruct (sc zi) as [s w]. simpl in Hs, Hw.
  apply andb_prop in H. destruct H as [H1 H2].
  apply misses_ok with c0 k0 z; try assumption; try lra.
  - apply pos_ok with (1 := H1). apply add_in; [now apply sub_in | now apply mul_in].
  - apply pos_ok with (1 := H2). apply sub_in; [apply sub_in; [apply add_in; [assumption | apply mul_in;
    [assumption | exact quarter_in]] | assumption]
      | apply mul_in; [apply sub_in; [exact quarter_in | assumption] | assumption]].
Qed.

Lemma earliest_sound c0 k0 ci ki z : inI c0 ci -> inI k0 ki -> forall c k x, c0 <= c -> k0 <= k -> hit c k x ->
  let '(xi, si, wi) := earliest ci ki z in
  exists x_ s_ w_, inI x_ xi /\ inI s_ si /\ inI w_ wi /\ 0 <= x_ <= x /\ s_ <= sin x_ /\ cos x_ <= w_.
Proof.
  intros Hc Hk c k x Hcc Hkk Hh. unfold earliest.
  assert (Hz := single_in z). set (zr := proj_val _) in Hz. set (zi := I.singleton z) in *.
  destruct (sc_ok zr zi Hz) as [Hs Hw]. destruct (sc zi) as [s w]. simpl in Hs, Hw. simpl.
  assert (H0 : 0 <= x < PI/2) by apply Hh.
  destruct (nonneg zi && nonneg (I.sub p (pi_ T) zi) && pos (I.sub p w ki)) eqn:E.
  - apply andb_prop in E. destruct E as [E E3]. apply andb_prop in E. destruct E as [E1 E2].
    assert (Z1 := nonneg_ok zr zi E1 Hz). assert (Z2 := nonneg_ok (PI - zr) _ E2 (sub_in p _ _ _ _ pi_in Hz)).
    assert (Q := sub_in p _ _ _ _ Hw Hk). assert (Z3 := pos_ok _ _ E3 Q).
    assert (B := earliest_ok c k c0 k0 x zr Hcc Hkk Hh ltac:(lra) Z3).
    destruct (low0_ok' (zr - (sin zr - k0 * zr - c0) / (cos zr - k0))
      (I.sub p zi (I.div p (I.sub p (I.sub p s (I.mul p ki zi)) ci) (I.sub p w ki)))) with (y := x) as [x_ [X1 X2]];
        try lra.
    { apply sub_in; [assumption|]. apply div_in; [|assumption]. apply sub_in; [|assumption].
      apply sub_in; [assumption | now apply mul_in]. }
    set (xi := low0 _) in *. assert (Hd := sub_in p _ _ _ _ X1 Hz). assert (He := sqr_in p _ _ Hd).
    destruct (low_ok (sin zr + (x_ - zr) * cos zr - (x_ - zr) * (x_ - zr)) (I.sub p (I.add p s (I.mul p (I.sub p xi zi)
      w)) (I.sqr p (I.sub p xi zi)))) as [s_ [S1 S2]].
    { apply sub_in; [apply add_in; [assumption | now apply mul_in] | assumption]. }
    destruct (up_ok (cos zr - (x_ - zr) * sin zr + (x_ - zr) * (x_ - zr)) (I.add p (I.sub p w (I.mul p (I.sub p xi zi)
      s)) (I.sqr p (I.sub p xi zi)))) as [w_ [W1 W2]].
    { apply add_in; [apply sub_in; [assumption | now apply mul_in] | assumption]. }
    exists x_, s_, w_. repeat split; try assumption; try lra.
    + assert (A := sin_near zr (x_ - zr)). apply Rabs_le_between in A. replace (zr + (x_ - zr)) with x_ in A by ring.
      lra.
    + assert (A := cos_near zr (x_ - zr)). apply Rabs_le_between in A. replace (zr + (x_ - zr)) with x_ in A by ring.
      lra.
  - exists 0, 0, 1. rewrite sin_0, cos_0. repeat split; try apply zero_in; try exact unit_in; lra.
Qed.

Theorem at_most_sound n : forall ri ci ki z, at_most n ri ci ki z = true -> forall r0 c0 k0, inI r0 ri -> inI c0 ci ->
  inI k0 ki ->
  forall r c k, below r0 c0 k0 r c k -> forall m, coll r m c k -> (m <= n)%nat.
Proof.
  induction n as [|n IH]; intros ri ci ki z H r0 c0 k0 Hr Hc Hk r c k HB m Hm; simpl in H;
    destruct (nonneg (I.sub p ki (unit_ T))) eqn:E1.
  1, 3: assert (K := nonneg_ok _ _ E1 (sub_in p _ _ _ _ Hk unit_in)); assert (m = O) by (apply steep_ray_misses with (2
    := Hm); destruct HB as [? [? [? [? [? [? ?]]]]]]; lra); lia.
  - assert (M : misses ci ki = true) by (destruct (seems_to_hit G ci ki _); destruct (misses ci ki); congruence).
    destruct m as [|m]; [lia|exfalso]. destruct Hm as [x [Hx _]]. destruct HB as [? [? [? [? [? [? ?]]]]]].
      now apply (misses_sound c0 k0 ci ki M Hc Hk c k) with x.
  - destruct (if seems_to_hit G ci ki _ then false else misses ci ki) eqn:E2.
    { assert (M : misses ci ki = true) by (destruct (seems_to_hit G ci ki _); congruence).
      destruct m as [|m]; [lia|exfalso]. destruct Hm as [x [Hx _]]. destruct HB as [? [? [? [? [? [? ?]]]]]].
        now apply (misses_sound c0 k0 ci ki M Hc Hk c k) with x. }
    destruct m as [|m]; [lia|]. destruct Hm as [x [Hx Hm]]. destruct m as [|m]; [lia|].
    destruct Hm as [Hm|[HD Hm]]; [discriminate|].
    assert (HB' := HB). destruct HB' as [B1 [B2 [B3 [B4 [B5 [B6 [B7 B8]]]]]]].
    assert (ES := earliest_sound c0 k0 ci ki (near_root G ci ki z) Hc Hk c k x B5 B6 Hx).
    destruct (earliest ci ki (near_root G ci ki z)) as [[xi si] wi]. destruct ES as [x_ [s_ [w_ [X1 [S1 [W1 [X2 [S2
      W2]]]]]]]].
    assert (S3 : sin x_ <= sin x) by (apply sin_mono; destruct Hx; lra).
    assert (W3 : cos x <= cos x_) by (apply cos_mono; destruct Hx; lra).
    destruct (below_step _ _ _ _ _ _ x x_ s_ w_ HB Hx HD X2 ltac:(lra) ltac:(lra)) as [D1 [K1 [K2 K3]]].
    assert (HDI := DI_in _ _ _ _ _ _ W1 Hk Hr).
    destruct (nonneg (I.neg (DI wi ki ri))) eqn:E3.
    { assert (K := nonneg_ok _ _ E3 (neg_in _ _ HDI)). lra. }
    destruct (next_domain c k r x) as [Q1 Q2]; try assumption.
    destruct (low0_ok (next_slope w_ k0 r0) (I.div p (NI wi ki ri) (DI wi ki ri))) with (y :=
      next_slope (cos x) k r) as [k1 [A1 A2]]; try assumption.
    { apply div_in; [now apply NI_in | assumption]. }
    destruct (low0_ok (s_ + k1 * (x_ + PI)) (I.add p si (I.mul p (low0 (I.div p (NI wi ki ri) (DI wi ki ri))) (I.add p
      xi (pi_ T))))) with (y := sin x + next_slope (cos x) k r * (x + PI)) as [c1 [C1 C2]].
    { apply add_in; [assumption | apply mul_in; [assumption | apply add_in; [assumption | exact pi_in]]]. }
    { now apply K3. } { assumption. }
    assert ((S m <= n)%nat); [|lia].
    apply (IH _ _ _ _ H r0 c1 k1) with (5 := Hm); try assumption.
    repeat split; lra.
Qed.

Theorem at_least_sound n : forall ri ci ki z, at_least n ri ci ki z = true -> forall r0 c0 k0, inI r0 ri ->
  inI c0 ci -> inI k0 ki ->
  forall r c k, above r0 c0 k0 r c k -> coll r n c k.
Proof.
  induction n as [|n IH]; intros ri ci ki z H r0 c0 k0 Hr Hc Hk r c k HA; [exact I|].
  simpl in H. assert (Hx := single_in (behind_root G ci ki z)). set (x_ := proj_val _) in Hx.
    set (xi := I.singleton _) in *.
  destruct (sc_ok x_ xi Hx) as [Hs Hw]. destruct (sc xi) as [s w]. simpl in Hs, Hw.
  destruct (nonneg xi && nonneg (I.sub p (quarter T) xi) && pos (I.sub p s (I.add p ci (I.mul p ki xi)))) eqn:E;
    [|discriminate].
  apply andb_prop in E. destruct E as [E E3]. apply andb_prop in E. destruct E as [E1 E2].
  assert (Z1 := nonneg_ok _ _ E1 Hx). assert (Z2 := nonneg_ok _ _ E2 (sub_in p _ _ _ _ quarter_in Hx)).
  assert (Z3 := pos_ok _ _ E3 (sub_in p _ _ _ _ Hs (add_in p _ _ _ _ Hc (mul_in p _ _ _ _ Hk Hx)))).
  destruct (above_hit _ _ _ _ _ _ x_ HA) as [x [Hh Hxx]]; try lra.
  exists x. split; [exact Hh|]. destruct n as [|n]; [now left|right].
  destruct (pos (low w) && pos (DI (low w) ki ri)) eqn:E; [|discriminate]. apply andb_prop in E. destruct E as [E4 E5].
  destruct (low_ok _ _ Hw) as [w_ [W1 W2]]. destruct (up_ok _ _ Hs) as [s_ [S1 S2]].
  assert (W3 := pos_ok _ _ E4 W1). assert (HDI := DI_in _ _ _ _ _ _ W1 Hk Hr). assert (D3 := pos_ok _ _ E5 HDI).
  destruct (above_step _ _ _ _ _ _ x x_ s_ w_ HA Hh) as [D1 [K1 K2]]; try lra.
  split; [exact D1|]. assert (HA' := HA). destruct HA' as [B1 [B2 [B3 [B4 [B5 [B6 B7]]]]]].
  destruct (next_domain c k r x) as [Q1 Q2]; try assumption.
  destruct (up_ok (next_slope w_ k0 r0) (I.div p (NI (low w) ki ri) (DI (low w) ki ri))) as [k1 [A1 A2]].
  { apply div_in; [now apply NI_in | assumption]. }
  destruct (up_ok (s_ + k1 * (x_ + PI)) (I.add p (up s) (I.mul p (up (I.div p (NI (low w) ki ri) (DI (low w) ki ri)))
    (I.add p xi (pi_ T))))) as [c1 [C1 C2]].
  { apply add_in; [assumption | apply mul_in; [assumption | apply add_in; [assumption | exact pi_in]]]. }
  apply (IH _ _ _ _ H r0 c1 k1); try assumption.
  assert (K3 := K2 k1 ltac:(lra)). repeat split; lra.
Qed.
End S.
End Count.
