(** L16 with intervals: all states of a box together, each formula evaluated over them
    (docs/reference/format-sections.md, section 2). Only the least root of sin x = c + k x is bounded by those for the
    ends of c and k. Generic in the numbers.

    plain_ray, plain_ray_sound       == computed: the rays of a box have at most n collisions; and it is so
    plain_follow, plain_follow_sound == the same of the states after a collision *)
From Coq Require Import Reals ZArith Lra Lia List Bool.
From Interval Require Import Real.Xreal Float.Basic Float.Sig Interval.Interval Interval.Float Interval.Float_full.
From Dumbbell Require Import Ray Chart Forward BoundingRays FewHits ForwardCount.
Local Open Scope R_scope.

Module PlainCount (F : FloatOps with Definition sensible_format := true).
Include ForwardCount F.
Import Z.

Section S.
Variable p : F.precision.
Variable G : guesses.
Variable T : consts.
Notation pt := I.singleton.
Notation "a + b" := (I.add p a b) : interval_scope.
Notation "a - b" := (I.sub p a b) : interval_scope.
Notation "a * b" := (I.mul p a b) : interval_scope.
Notation "a / b" := (I.div p a b) : interval_scope.
Delimit Scope interval_scope with i.

(** Of a number that is not negative; of a slope below 1. *)
Definition not_negative (i : I.type) : I.type := if nonneg i then i else I.join I.zero (up i).
Definition to_one (k : I.type) : I.type := I.meet k (I.join (low k) (unit_ T)).
(** A slope n / d, where d > 0; it matters below 1 only. *)
Definition quotient (n d : I.type) : option I.type :=
  if pos d then Some (n / d)%i else
  if pos (low n) then let k := (low n / up d)%i in Some (if nonneg (k - unit_ T)%i then k else I.join k (unit_ T))
  else None.

(** Where the rays (c, k) collide: corner distance, its sine and cosine; a guess for the next time. *)
Definition place (c k : I.type) (z zh : F.type) : I.type * I.type * I.type * F.type :=
  let '(x, s, w) := earliest p G T (low c) (low k) z in
  let zh := behind_root G (up c) (up k) zh in let x1 := pt zh in
  let '(s1, w1) := sc p G T x1 in
  let from := I.join (low0 k) w in
  if nonneg x1 && nonneg (quarter T - x1)%i && pos (s1 - (up c + up k * x1))%i
  then (I.join x x1, I.join s s1, I.meet (I.join w1 w) from, zh)
  else (I.join x (quarter T), I.join s (unit_ T), from, first_guess G).

(** The slope after a collision with the wall, if any ray returns from it. *)
Inductive reflection := Undecided | Nothing_returns | Returns (k : I.type).
Definition reflected (r k w : I.type) : reflection :=
  let ww := I.sqr p w in
  let d := I.meet (DI p w k r) (w * (w - I.mul2 p k) - r)%i in
  if nonneg (I.neg d) then Nothing_returns else
  match quotient (I.meet (k * ww + r * (I.mul2 p w - k)) (k * (ww - r) + I.mul2 p (r * w)))%i d with
  | None => Undecided
  | Some k' =>
    let a := ((w - r / w) * half T)%i in let q := (a - k)%i in
    Returns (if pos w && pos q
             then I.meet (I.meet k' ((I.sqr p a + r) / q - a)%i) (k + (r + I.sqr p k) / q)%i else k')
  end.
Definition missed (c k : I.type) : bool := misses p G T (low c) (low k).
(** At most n later collisions of all rays (c, k). *)
Fixpoint plain_ray (n : nat) (r c k : I.type) (z zh : F.type) : bool :=
  if nonneg (k - unit_ T)%i then true else
  let k := to_one k in
  if missed c k then true else
  match n with
  | O => false
  | S m =>
    let z := near_root G (low c) (low k) z in
    let '(x, s, w, zh) := place c k z zh in
    match reflected r k w with
    | Undecided => false
    | Nothing_returns => true
    | Returns k' => plain_ray m r (not_negative (s + k' * (x + pi_ T))%i) k' z zh
    end
  end.

(** All first contacts of flights above the line h + k t come at this t or later. *)
Definition first_contact (r1 h k : I.type) : I.type :=
  let z := pt (crossing p G T 40 r1 h k F.zero) in let '(s, w) := turn p G T z in
  let q := (r1 * w - k)%i in
  if on_bridge p T z && pos q then low0 ((h - r1 * (s - z * w)) / q)%i
  else if pos (r1 - k)%i then low0 (h / (r1 - k))%i else I.zero.
(** Rays of the slope n / d, where d > 0, that leave the bridge at the height h and have [way] before them. *)
Definition one_way (m : nat) (r h n d way : I.type) : bool :=
  if nonneg (I.neg d) then true else
  match quotient n d with
  | None => false
  | Some k => plain_ray m r (not_negative (h + k * way)%i) k (first_guess G) (first_guess G)
  end.
(** Those that leave it in [t] with the slope k before; to the left, and, which no theorem needs, to the right. *)
Definition both_ways (m : nat) (r k t : I.type) : bool :=
  let w := I.cos p t in let ww := I.sqr p w in let h := (r * I.sin p t)%i in let rw := I.mul2 p (r * w)%i in
  let d := (unit_ T + I.mul2 p (w * k) - r * ww)%i in
  let n := I.meet (rw - k * (unit_ T - r * ww))%i (rw - k + k * (r * ww))%i in
  one_way m r h n d (not_negative (pi_ T - t)%i) && one_way m r h n (I.neg d) (not_negative t).
(** Is a contact with the bridge counted, if there may be one? And do all states have one? *)
Definition plain_bridge (n : nat) (r0 r1 r : I.type) (b : state) : bool * bool :=
  let k := slope b in let h := not_negative (sine b + k * corner b)%i in
  if nonneg (low k - r1)%i || above p G T r1 (low h) (low k) then (true, false) else
  let '(t, all) := last_contact p G T r0 r1 (low k) (up h) (up k) in
  (match n with O => false | S m => both_ways m r k (I.join (first_contact r1 (low h) (low k)) t) end, all).
(** At most n later collisions of all states that leave the wall R. *)
Fixpoint plain_follow (n : nat) (r0 r1 r : I.type) (b : state) (z zh : F.type) : bool :=
  if nonneg (slope b - unit_ T)%i then true else
  let k := to_one (slope b) in let b := {| corner := corner b; sine := sine b; slope := k |} in
  let '(counted, all) := plain_bridge n r0 r1 r b in
  if negb counted then false else
  if all then true else
  let c := not_negative (height p b (pi_ T)) in
  if missed c k then true else
  match n with
  | O => false
  | S m =>
    let z := near_root G (low c) (low k) z in
    let '(x, s, w, zh) := place c k z zh in
    match reflected r k w with
    | Undecided => false
    | Nothing_returns => true
    | Returns k' => plain_follow m r0 r1 r {| corner := x; sine := s; slope := k' |} z zh
    end
  end.

(* ---------- soundness ---------- *)
Hypothesis HT : T = mkconsts p.
Let piI := pi_in p T HT.
Let quI := quarter_in p T HT.
Let unI := unit_in p T HT.
Let haI := half_in p T HT.

Lemma join_between a b x i j : inI a i -> inI b j -> a <= x <= b -> inI x (I.join i j).
Proof.
  intros Ha Hb Hx. apply (contains_connected (I.convert (I.join i j)) a b); [| |exact Hx]; apply I.join_correct;
    [now left | now right].
Qed.
Lemma meet_in x i j : inI x i -> inI x j -> inI x (I.meet i j).
Proof. apply I.meet_correct. Qed.
Lemma not_negative_ok x i : inI x i -> 0 <= x -> inI x (not_negative i).
Proof.
  intros Hx H. unfold not_negative. destruct (nonneg i); [exact Hx|]. destruct (up_ok _ _ Hx) as [x1 [A B]].
  apply (join_between 0 x1); [apply zero_in | exact A | lra].
Qed.
Lemma to_one_ok k i : inI k i -> k < 1 -> inI k (to_one i).
Proof.
  intros Hk H. apply meet_in; [exact Hk|]. destruct (low_ok _ _ Hk) as [k0 [A B]].
  apply (join_between k0 1); [exact A | exact unI | lra].
Qed.
Lemma quotient_ok n d ni di : inI n ni -> inI d di -> 0 < d -> n / d < 1 ->
  match quotient ni di with Some i => inI (n / d) i | None => True end.
Proof.
  intros Hn Hd D1 N1. unfold quotient. destruct (pos di); [now apply div_in|].
  destruct (pos (low ni)) eqn:E; [|exact I]. destruct (low_ok _ _ Hn) as [n0 [A B]].
  destruct (up_ok _ _ Hd) as [d1 [C D]]. assert (N0 := pos_ok _ _ E A).
  assert (Q : inI (n0 / d1) (low ni / up di)%i) by now apply div_in.
  assert (L : n0 / d1 <= n / d) by (apply frac_le; try lra; assert (n0 * d <= n * d1) by (apply mul_mono; lra); lra).
  destruct (nonneg _) eqn:E2; [assert (K := nonneg_ok _ _ E2 (sub_in p _ _ _ _ Q unI)); lra|].
  apply (join_between (n0 / d1) 1); [exact Q | exact unI | lra].
Qed.

Lemma place_sound ci ki z zh c k x : inI c ci -> inI k ki -> 0 <= c -> hit c k x ->
  let '(xi, si, wi, _) := place ci ki z zh in inI x xi /\ inI (sin x) si /\ inI (cos x) wi.
Proof.
  intros Hc Hk C0 Hh. assert (HPI : 0 < PI) by apply PI_RGT_0. unfold place.
  destruct (low_ok _ _ Hc) as [c0 [C1 C2]]. destruct (low_ok _ _ Hk) as [k0 [K1 K2]].
  destruct (up_ok _ _ Hc) as [c1 [C3 C4]]. destruct (up_ok _ _ Hk) as [k1 [K3 K4]].
  assert (E := earliest_sound p G T HT c0 k0 _ _ z C1 K1 c k x C2 K2 Hh).
  destruct (earliest _ _ _ _ _ _) as [[xi si] wi]. destruct E as [x_ [s_ [w_ [A1 [A2 [A3 [A4 [A5 A6]]]]]]]].
  set (zh' := behind_root G _ _ _). assert (Hv := single_in zh'). set (v := proj_val _) in Hv.
  destruct (sc_ok p G T HT v _ Hv) as [Hs Hw]. destruct (sc p G T (pt zh')) as [s1 w1]. simpl in Hs, Hw.
  assert (Hx := proj1 Hh). assert (Hw0 := cos_pos x Hx).
  assert (S0 : s_ <= sin x) by (assert (sin x_ <= sin x) by (apply sin_mono; lra); lra).
  assert (W0 : cos x <= w_) by (assert (cos x <= cos x_) by (apply cos_mono; lra); lra).
  assert (From : inI (cos x) (I.join (low0 ki) wi)).
  { destruct (low0_ok _ _ Hk (cos x)) as [w0 [B1 B2]]; [destruct Hh as [_ [_ Hh]]; lra | lra|].
    apply (join_between w0 w_); [exact B1 | exact A3 | lra]. }
  destruct (nonneg _ && _ && _) eqn:E.
  - apply andb_prop in E. destruct E as [E E3]. apply andb_prop in E. destruct E as [E1 E2].
    assert (V1 := nonneg_ok _ _ E1 Hv). assert (V2 := nonneg_ok _ _ E2 (sub_in p _ _ _ _ quI Hv)).
    assert (V3 := pos_ok _ _ E3 (sub_in p _ _ _ _ Hs (add_in p _ _ _ _ C3 (mul_in p _ _ _ _ K3 Hv)))).
    assert (V4 : k * v <= k1 * v) by (apply Rmult_le_compat_r; lra).
    destruct (hit_exists c k v C0 ltac:(lra) ltac:(lra)) as [y [Hy Y]].
    assert (x = y) by exact (hit_unique _ _ _ _ Hh Hy). subst y.
    assert (M1 : sin x <= sin v) by (apply sin_mono; lra). assert (M2 : cos v <= cos x) by (apply cos_mono; lra).
    split; [|split; [|apply meet_in; [|exact From]]].
    + apply (join_between x_ v); [exact A1 | exact Hv | lra].
    + apply (join_between s_ (sin v)); [exact A2 | exact Hs | lra].
    + apply (join_between (cos v) w_); [exact Hw | exact A3 | lra].
  - destruct (SIN_bound x). split; [|split; [|exact From]].
    + apply (join_between x_ (PI/2)); [exact A1 | exact quI | lra].
    + apply (join_between s_ 1); [exact A2 | exact unI | lra].
Qed.

Lemma reflected_sound ri ki wi r k w : inI r ri -> inI k ki -> inI w wi -> 0 < slope_den w k r ->
  next_slope w k r < 1 ->
  match reflected ri ki wi with
  | Undecided => True | Nothing_returns => False | Returns i => inI (next_slope w k r) i
  end.
Proof.
  intros Hr Hk Hw HD H1. unfold reflected. assert (WW := sqr_in p _ _ Hw).
  set (d := I.meet _ _). assert (D : inI (slope_den w k r) d).
  { apply meet_in; [now apply DI_in|]. replace (slope_den w k r) with (w * (w - 2 * k) - r) by (unfold slope_den; ring).
    apply sub_in; [|exact Hr]. apply mul_in; [exact Hw|]. apply sub_in; [exact Hw | now apply mul2_in]. }
  destruct (nonneg (I.neg d)) eqn:E; [assert (K := nonneg_ok _ _ E (neg_in _ _ D)); lra|].
  set (n := I.meet (_ + _)%i _). assert (N : inI (slope_num w k r) n).
  { apply meet_in.
    - replace (slope_num w k r) with (k * (w * w) + r * (2 * w - k)) by (unfold slope_num; ring).
      apply add_in; [now apply mul_in|]. apply mul_in; [exact Hr|]. apply sub_in; [now apply mul2_in | exact Hk].
    - replace (slope_num w k r) with (k * (w * w - r) + 2 * (r * w)) by (unfold slope_num; ring).
      apply add_in; [apply mul_in; [exact Hk | now apply sub_in] | apply mul2_in; now apply mul_in]. }
  assert (Q := quotient_ok _ _ _ _ N D HD H1). destruct (quotient n d) as [q|]; [|exact I].
  fold (next_slope w k r) in Q. set (ai := ((wi - ri / wi) * half T)%i).
  destruct (pos wi && pos (ai - ki)%i) eqn:E2; [|exact Q]. apply andb_prop in E2. destruct E2 as [E2 E3].
  assert (W0 := pos_ok _ _ E2 Hw). set (a := (w - r / w) * (1 / 2)).
  assert (A : inI a ai) by (apply mul_in; [apply sub_in; [exact Hw | now apply div_in] | exact haI]).
  assert (AK := sub_in p _ _ _ _ A Hk). assert (P0 := pos_ok _ _ E3 AK).
  assert (F : slope_den w k r = 2 * w * (a - k)) by (unfold slope_den, a; field; lra).
  apply meet_in; [apply meet_in; [exact Q|] |].
  - replace (next_slope w k r) with ((a * a + r) / (a - k) - a).
    + apply sub_in; [|exact A]. apply div_in; [|exact AK]. apply add_in; [now apply sqr_in | exact Hr].
    + unfold next_slope. rewrite F. apply Rmult_eq_reg_r with (2 * w * (a - k)).
      * replace (((a * a + r) / (a - k) - a) * (2 * w * (a - k))) with (2 * w * (r + a * k)) by (field; lra).
        replace (slope_num w k r / (2 * w * (a - k)) * (2 * w * (a - k))) with (slope_num w k r) by (field; lra).
        unfold slope_num, a. field. lra.
      * apply Rgt_not_eq. apply Rmult_lt_0_compat; lra.
  - replace (next_slope w k r) with (k + (r + k * k) / (a - k)).
    + apply add_in; [exact Hk|]. apply div_in; [|exact AK]. apply add_in; [exact Hr | now apply sqr_in].
    + unfold next_slope. rewrite F. apply Rmult_eq_reg_r with (2 * w * (a - k)).
      * replace ((k + (r + k * k) / (a - k)) * (2 * w * (a - k))) with (2 * w * (r + a * k)) by (field; lra).
        replace (slope_num w k r / (2 * w * (a - k)) * (2 * w * (a - k))) with (slope_num w k r) by (field; lra).
        unfold slope_num, a. field. lra.
      * apply Rgt_not_eq. apply Rmult_lt_0_compat; lra.
Qed.
Lemma missed_sound ci ki c k : missed ci ki = true -> inI c ci -> inI k ki -> forall x, ~ hit c k x.
Proof.
  intros H Hc Hk. destruct (low_ok _ _ Hc) as [c0 [C1 C2]]. destruct (low_ok _ _ Hk) as [k0 [K1 K2]].
  now apply (misses_sound p G T HT c0 k0 (low ci) (low ki)).
Qed.
Lemma to_pi_in x k xi si ki : inI x xi -> inI (sin x) si -> inI k ki ->
  inI (sin x + k * (x + PI)) (si + ki * (xi + pi_ T))%i.
Proof. intros. apply add_in; [assumption|]. apply mul_in; [assumption | now apply add_in]. Qed.

Theorem plain_ray_sound n : forall ri ci ki z zh, plain_ray n ri ci ki z zh = true -> forall r c k, inI r ri ->
  inI c ci -> inI k ki -> 0 < r <= 1 -> 0 <= c -> - r <= k -> forall m, coll r m c k -> (m <= n)%nat.
Proof.
  induction n as [|n IH]; intros ri ci ki z zh H r c k Hr Hc Hk R C0 K0 m Hm; (destruct m as [|m]; [lia|]);
    assert (K1 : k < 1) by (apply Rnot_le_lt; intros K; now apply (steep_ray_misses r (S m) c k) in K);
    cbn [plain_ray] in H;
    (destruct (nonneg (ki - unit_ T)%i) eqn:E1;
      [assert (A := nonneg_ok _ _ E1 (sub_in p _ _ _ _ Hk unI)); lra|]);
    assert (Hk' := to_one_ok _ _ Hk K1); set (kj := to_one ki) in *;
    destruct Hm as [x [Hx Hn]];
    (destruct (missed ci kj) eqn:E2; [exfalso; exact (missed_sound _ _ _ _ E2 Hc Hk' x Hx)|]);
    [discriminate|]. set (z' := near_root _ _ _ _) in H.
  destruct Hn as [->|[HD Hn]]; [lia|]. apply le_n_S.
  destruct (next_domain c k r x ltac:(lra) K0 Hx HD) as [Q1 Q2]. set (k' := next_slope (cos x) k r) in *.
  assert (PS := place_sound ci kj z' zh c k x Hc Hk' C0 Hx). destruct (place ci kj z' zh) as [[[xi si] wi] zh'].
  destruct PS as [X [S W]]. destruct (Rle_or_lt 1 k') as [K2|K2].
  { apply (steep_ray_misses r m _ k' K2) in Hn. lia. }
  assert (RS := reflected_sound _ _ _ _ _ _ Hr Hk' W HD K2).
  destruct (reflected ri kj wi) as [| |ki']; [discriminate | contradiction|].
  apply (IH _ _ _ _ _ H r _ k' Hr) with (6 := Hn); try assumption; try lra.
  apply not_negative_ok; [now apply to_pi_in | exact Q2].
Qed.

Lemma first_contact_sound ri hi ki r1 h k : inI r1 ri -> inI h hi -> inI k ki -> 0 <= r1 -> forall t,
  0 <= t <= PI -> h + k * t <= r1 * sin t -> exists t0, inI t0 (first_contact ri hi ki) /\ 0 <= t0 <= t.
Proof.
  intros Hr Hh Hk R0 t Ht Hb. unfold first_contact. set (z := crossing _ _ _ _ _ _ _ _).
  assert (HPI : 0 < PI) by apply PI_RGT_0. assert (HP := PI2_1).
  assert (Tg : forall v, 0 <= v <= PI -> 0 < r1 * cos v - k ->
    (h - r1 * (sin v - v * cos v)) / (r1 * cos v - k) <= t).
  { intros v Hv Q. assert (A := sin_below_tangent v t Hv Ht).
    assert (B : r1 * sin t <= r1 * (sin v + (t - v) * cos v)) by (apply Rmult_le_compat_l; lra).
    apply Rmult_le_reg_r with (r1 * cos v - k); [exact Q|].
    unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  assert (Hv := single_in z). set (v := proj_val _) in Hv.
  destruct (turn_ok p G T HT v _ Hv) as [Hs Hw]. destruct (turn p G T (pt z)) as [s w]. simpl in Hs, Hw.
  assert (Q := sub_in p _ _ _ _ (mul_in p _ _ _ _ Hr Hw) Hk).
  destruct (on_bridge p T (pt z) && pos (ri * w - ki)%i) eqn:E.
  - apply andb_prop in E. destruct E as [E1 E2]. assert (V := on_bridge_ok p T HT v _ E1 Hv).
    apply (low0_ok' ((h - r1 * (sin v - v * cos v)) / (r1 * cos v - k)));
      [|apply Tg; [exact V | exact (pos_ok _ _ E2 Q)] | lra].
    apply div_in; [|exact Q]. apply sub_in; [exact Hh|]. apply mul_in; [exact Hr|].
    apply sub_in; [exact Hs | now apply mul_in].
  - destruct (pos (ri - ki)%i) eqn:E2; [|exists 0; split; [apply zero_in | lra]].
    assert (Q2 := sub_in p _ _ _ _ Hr Hk). assert (A := Tg 0 ltac:(lra)).
    rewrite sin_0, cos_0, Rmult_0_l, Rminus_0_r, Rmult_0_r, Rminus_0_r, Rmult_1_r in A.
    apply (low0_ok' (h / (r1 - k))); [now apply div_in | apply A; exact (pos_ok _ _ E2 Q2) | lra].
Qed.

(** Out of the bridge to the left. *)
Lemma both_ways_sound m ri ki ti r k t : both_ways m ri ki ti = true -> inI r ri -> inI k ki -> inI t ti ->
  0 < r <= 1 -> 0 <= t <= PI -> 0 < contact_den (cos t) k r -> forall eta, 0 <= eta ->
  r * lamX t eta * contact_den (cos t) k r = contact_num (cos t) k r ->
  forall a, coll r a (r * cX t eta) (r * lamX t eta) -> (a <= m)%nat.
Proof.
  intros H Hr Hk Ht R Tt HE eta He Es a Ha. apply andb_prop in H. destruct H as [H _]. cbv zeta in H.
  assert (W := cos_in p _ _ Ht). assert (Sn := sin_in p _ _ Ht). assert (WW := sqr_in p _ _ W).
  set (d := (unit_ T + _ - _)%i) in H. assert (D : inI (contact_den (cos t) k r) d).
  { apply sub_in; [apply add_in; [exact unI | apply mul2_in; now apply mul_in] | now apply mul_in]. }
  unfold one_way in H. destruct (nonneg (I.neg d)) eqn:E; [assert (K := nonneg_ok _ _ E (neg_in _ _ D)); lra|].
  set (n := I.meet _ _) in H. assert (N : inI (contact_num (cos t) k r) n).
  { assert (RW := mul2_in p _ _ (mul_in p _ _ _ _ Hr W)). assert (RWW := mul_in p _ _ _ _ Hr WW). apply meet_in.
    - apply sub_in; [exact RW|]. apply mul_in; [exact Hk | now apply sub_in].
    - replace (contact_num (cos t) k r) with (2 * (r * cos t) - k + k * (r * (cos t * cos t)))
        by (unfold contact_num; ring).
      apply add_in; [now apply sub_in | now apply mul_in]. }
  set (v := r * lamX t eta) in *. assert (V : v = contact_num (cos t) k r / contact_den (cos t) k r).
  { rewrite <- Es. field. lra. }
  destruct a as [|a]; [lia|]. assert (V1 : v < 1).
  { apply Rnot_le_lt. intros K. now apply (steep_ray_misses r (S a) (r * cX t eta) v) in K. }
  rewrite V in V1. assert (Q := quotient_ok _ _ _ _ N D HE V1). destruct (quotient n d) as [vi|]; [|discriminate].
  rewrite <- V in Q. destruct (COS_bound t).
  assert (CX : r * cX t eta = r * sin t + v * (PI - t)) by (unfold v, cX; ring).
  assert (C0 : 0 <= cX t eta).
  { assert (A := cX_mono t PI eta 0 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
    assert (cX PI 0 = 0) by (unfold cX; rewrite sin_PI; ring). lra. }
  assert (C1 : 0 <= r * cX t eta) by (apply Rmult_le_pos; lra).
  apply (plain_ray_sound m _ _ _ _ _ H r (r * cX t eta) v Hr) with (6 := Ha); try assumption.
  - apply not_negative_ok; [|exact C1]. rewrite CX. apply add_in; [now apply mul_in|]. apply mul_in; [exact Q|].
    apply not_negative_ok; [now apply sub_in | lra].
  - assert (r * -1 <= v) by (unfold v, lamX; apply Rmult_le_compat_l; lra). lra.
Qed.

Section States.
Variables (r0i r1i ri : I.type) (r0 r1 r : R).
Hypotheses (H0 : inI r0 r0i) (H1 : inI r1 r1i) (Hr : inI r ri) (R0 : 0 < r0) (Ra : r0 <= r) (Rb : r <= r1)
  (R1 : r1 <= 1).

Definition in_state (b : state) x k := inI x (corner b) /\ inI (sin x) (sine b) /\ inI k (slope b).

Lemma plain_bridge_sound n b x k : in_state b x k -> 0 <= x <= PI/2 -> - cos x <= k ->
  let '(counted, all) := plain_bridge n r0i r1i ri b in
  (counted = true -> forall t m, meets_bridge r x k t ->
     (m = O \/ exists eta, 0 < eta /\ 0 < contact_den (cos t) k r /\
        r * lamX t eta * contact_den (cos t) k r = contact_num (cos t) k r /\
        coll r m (r * cX t eta) (r * lamX t eta)) -> (S m <= n)%nat) /\
  (all = true -> ~ clears_bridge r x k).
Proof.
  intros [X [S K]] Hx Hup. assert (HPI : 0 < PI) by apply PI_RGT_0. unfold plain_bridge. set (h := not_negative _).
  assert (P0 : 0 <= sin x + k * x).
  { assert (Tg := sin_below_tangent x 0 ltac:(lra) ltac:(lra)). rewrite sin_0 in Tg.
    assert (0 <= (k + cos x) * x) by (apply Rmult_le_pos; lra). lra. }
  assert (Hh : inI (sin x + k * x) h).
  { apply not_negative_ok; [|exact P0]. apply add_in; [exact S | now apply mul_in]. }
  destruct (low_ok _ _ K) as [k0 [K1 K2]]. destruct (up_ok _ _ K) as [k1 [K3 K4]].
  destruct (up_ok _ _ Hh) as [h1 [B3 B4]]. destruct (low_ok _ _ Hh) as [h0 [B1 B2]].
  assert (L : forall t, 0 <= t -> h0 + k0 * t <= height_at x k t <= h1 + k1 * t).
  { intros t Ht. unfold height_at. assert (k0 * t <= k * t) by (apply Rmult_le_compat_r; lra).
    assert (k * t <= k1 * t) by (apply Rmult_le_compat_r; lra). lra. }
  assert (M : forall t, meets_bridge r x k t -> 0 <= t <= PI /\ h0 + k0 * t <= r1 * sin t).
  { intros t [Ht [E _]]. specialize (L t ltac:(lra)). split; [lra|]. assert (0 <= sin t) by (apply sin_ge_0; lra).
    assert (r * sin t <= r1 * sin t) by (apply Rmult_le_compat_r; lra). lra. }
  destruct (nonneg _ || above p G T r1i _ _) eqn:Ea.
  - split; [|discriminate]. intros _ t m Hm _. exfalso. destruct (M t Hm) as [M1 M2].
    apply orb_prop in Ea. destruct Ea as [Ea|Ea].
    { assert (A := nonneg_ok _ _ Ea (sub_in p _ _ _ _ K1 H1)). destruct Hm as [_ [_ Hm]]. destruct (COS_bound t).
      assert (r * cos t <= r * 1) by (apply Rmult_le_compat_l; lra). lra. }
    assert (A := above_sound p G T HT _ _ _ Ea r1 h0 k0 H1 B1 K1 ltac:(lra) t M1). lra.
  - assert (LC := last_contact_sound p G T HT r0i r1i r0 r1 r H0 H1 R0 Ra Rb _ _ _ x k k0 h1 k1 K1 B3 K3 K2
      (fun t Ht => proj2 (L t (proj1 Ht)))).
    destruct (last_contact _ _ _ _ _ _ _ _) as [ti all]. destruct LC as [[v [Hv [V Hlast]]] Hall].
    split; [|exact Hall]. intros Hn t m Hm Hc. destruct n as [|n]; [discriminate|]. apply le_n_S.
    destruct Hc as [->|[eta [He [HE [Es Hc]]]]]; [lia|]. destruct (M t Hm) as [M1 M2].
    destruct (first_contact_sound _ _ _ r1 h0 k0 H1 B1 K1 ltac:(lra) t M1 M2) as [t0 [T0 T1]].
    apply (both_ways_sound n ri (slope b) _ r k t Hn Hr K) with (6 := Es) (7 := Hc); try lra; try assumption.
    apply (join_between t0 v); [exact T0 | exact Hv | specialize (Hlast t Hm); lra].
Qed.

Theorem plain_follow_sound n : forall b z zh, plain_follow n r0i r1i ri b z zh = true -> forall x k, in_state b x k ->
  0 <= x <= PI/2 -> - cos x <= k -> forall m, forward r m x k -> (m <= n)%nat.
Proof.
  induction n as [|n IH]; intros b z zh H x k [X [S K]] Hx Hup m Hm; (destruct m as [|m]; [lia|]);
    assert (K1 : k < 1)
      by (apply Rnot_le_lt; intros L; now assert (A := forward_steep r (Datatypes.S m) x k ltac:(lra) L Hm));
    cbn [plain_follow] in H;
    (destruct (nonneg (slope b - unit_ T)%i) eqn:E1;
      [assert (A := nonneg_ok _ _ E1 (sub_in p _ _ _ _ K unI)); lra|]);
    assert (K' := to_one_ok _ _ K K1); set (ki := to_one (slope b)) in *; set (b' := {| corner := _ |}) in H;
    assert (B : in_state b' x k) by (split; [exact X | now split]);
    match type of H with context [plain_bridge ?N _ _ _ b'] => assert (HB := plain_bridge_sound N b' x k B Hx Hup) end;
    destruct (plain_bridge _ _ _ _ b') as [cd all]; destruct HB as [HB1 HB2]; destruct cd; try discriminate; simpl in H;
    (destruct Hm as [[t [Ht Hc]]|[Hcl [y [Hy0 [Hy Hn]]]]]; [exact (HB1 eq_refl t m Ht Hc)|]);
    (destruct all; [exfalso; now apply HB2|]);
    assert (P0 : 0 <= height_at x k PI)
      by (assert (P := Hcl PI ltac:(assert (0 < PI) by apply PI_RGT_0; lra)); now rewrite sin_PI, Rmult_0_r in P);
    set (ci := not_negative (height p b' (pi_ T))) in *;
    assert (C : inI (height_at x k PI) ci) by (apply not_negative_ok; [now apply to_pi_in | exact P0]);
    (destruct (missed ci ki) eqn:E2; [exfalso; exact (missed_sound _ _ _ _ E2 C K' y Hy)|]); [discriminate|].
  set (z' := near_root _ _ _ _) in H.
  destruct Hn as [->|[HD Hn]]; [lia|]. apply le_n_S. set (k' := next_slope (cos y) k r) in *.
  assert (PS := place_sound ci ki z' zh _ k y C K' P0 Hy). destruct (place ci ki z' zh) as [[[xi si] wi] zh'].
  destruct PS as [Y [Sy W]]. destruct (Rle_or_lt 1 k') as [K2|K2].
  { assert (A := forward_steep r m y k' ltac:(lra) K2 Hn). lia. }
  assert (RS := reflected_sound _ _ _ _ _ _ Hr K' W HD K2).
  destruct (reflected ri ki wi) as [| |ki']; [discriminate | contradiction|].
  destruct Hy as [Y1 [Y2 Y3]]. apply (IH _ _ _ H y k'); [split; [exact Y | now split] | lra | | exact Hn].
  left. apply next_leaves; try assumption. assert (0 <= cos y * cos y) by apply Rle_0_sqr. lra.
Qed.
End States.
End S.
End PlainCount.
