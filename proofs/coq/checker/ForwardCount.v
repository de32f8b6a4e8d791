(** L15 with intervals: the states that leave the wall R between a lowest and a highest one, followed until none can
    collide again; and the rays out of the bridge. Generic in the numbers.

    turn                 == an angle's sine and cosine
    at_most_contact      == computed: the ray out of a contact with the bridge has at most n collisions
    above, last_contact  == computed: a flight is above the bridge; where it meets it at the latest
    follow, follow_sound == computed: states between two have at most n later collisions, by L15; and it is so *)
From Coq Require Import Reals ZArith NArith Lra Lia List Bool.
From Interval Require Import Real.Xreal Float.Basic Float.Sig Interval.Interval Interval.Float Interval.Float_full.
From Dumbbell Require Import Ray Chart Forward BoundingRays FewHits Leaves.
Local Open Scope R_scope.

Module ForwardCount (F : FloatOps with Definition sensible_format := true).
Include Leaves F.
Import Z.

Section S.
Variable p : F.precision.
Variable G : guesses.
Variable T : consts.
Notation pt := I.singleton.

(** Sine and cosine on [0, pi]. *)
Definition turn (t : I.type) : I.type * I.type :=
  if pos (I.sub p t (quarter T)) then let '(s, w) := sc p G T (I.sub p (pi_ T) t) in (s, I.neg w) else sc p G T t.
Definition on_bridge (t : I.type) : bool := nonneg t && nonneg (I.sub p (pi_ T) t).

(** At most n later collisions of all rays that leave the bridge at t or before, with y or more for eta. *)
Definition at_most_contact (n : nat) (r t y : I.type) : bool :=
  let '(s, w) := turn t in let lam := I.add p w y in
  at_most p G T n r (low0 (I.mul p r (I.add p s (I.mul p lam (I.sub p (pi_ T) t))))) (low (I.mul p r lam))
    (first_guess G).

Definition tiny : I.type := I.div p (unit_ T) (I.fromZ p (2 ^ 48)).
(** Near the t with cos t = k, or near pi if k <= - 1; not trusted. *)
Definition near_slope (k : I.type) : I.type :=
  if nonneg k then pt (near_top G k) else
  pt (I.lower (if nonneg (I.add p k (unit_ T)) then I.sub p (pi_ T) (pt (near_top G (I.neg k)))
                 else I.sub p (pi_ T) tiny)).
(** The line h + k t is above the bridge: above a tangent of it. *)
Definition above (r h k : I.type) : bool :=
  let z := near_slope (I.div p k r) in let '(s, w) := turn z in
  on_bridge z && pos (I.sub p h (I.mul p r (I.sub p s (I.mul p z w)))) &&
  pos (I.sub p (I.add p h (I.mul p k (pi_ T))) (I.mul p r (I.add p s (I.mul p (I.sub p (pi_ T) z) w)))).
(** At t the line is below the bridge; at t the bridge is no steeper than k, for both r. *)
Definition below_at (r h k t : I.type) : bool :=
  let '(s, _) := turn t in on_bridge t && pos (I.sub p (I.mul p r s) (I.add p h (I.mul p k t))).
Definition flat_at (r0 r1 k t : I.type) : bool :=
  let '(_, w) := turn t in
  on_bridge t && nonneg (I.sub p k (I.mul p r0 w)) && nonneg (I.sub p k (I.mul p r1 w)).

(** The first t that is good, ever farther behind [start]; near the least root of r sin t = h + k t, by Newton's
    iteration. What they find is not trusted. *)
Fixpoint widen (n : nat) (good : I.type -> bool) (start width pad : I.type) : option I.type :=
  match n with
  | O => None
  | S n => let t := pt (I.lower (I.add p start (I.mul p width pad))) in
           if good t then Some t else widen n good start width (I.mul p pad (I.fromZ p 64))
  end.
Fixpoint crossing (n : nat) (r h k : I.type) (t : F.type) : F.type :=
  match n with
  | O => t
  | S n =>
    let i := pt t in let '(s, w) := turn i in
    let step := I.div p (I.sub p (I.add p h (I.mul p k i)) (I.mul p r s)) (I.sub p (I.mul p r w) k) in
    let new := I.lower (I.add p i step) in
    match F.cmp new t with Xgt => if on_bridge (pt new) then crossing n r h k new else t | _ => t end
  end.

(** Bounds of a state that leaves the wall R: corner distance, its sine, slope. *)
Record state := { corner : I.type; sine : I.type; slope : I.type }.
Definition height (b : state) (t : I.type) : I.type := I.add p (sine b) (I.mul p (slope b) (I.add p (corner b) t)).

(** Of flights of a slope >= k, below the line h + k1 t: no first contact with the bridge comes after this t; and
    whether all have one. *)
Definition last_contact (r0 r1 k h k1 : I.type) : I.type * bool :=
  let t := match widen 7 (flat_at r0 r1 k) (near_slope (I.div p k (if nonneg k then r1 else r0))) (unit_ T) tiny with
           | Some t => t
           | None => pi_ T
           end in
  let below := below_at r0 h k1 in
  let lowest := near_slope (I.div p k1 r0) in
  if below lowest then
    let root := pt (crossing 40 r0 h k1 F.zero) in
    let t' := match widen 8 below root (I.sub p (pi_ T) root) tiny with Some t' => t' | None => lowest end in
    (if pos (I.sub p t' t) then t else t', true)
  else (t, false).

(** The highest ray's next state, and a guess for its next root; (pi/2, 1) is above all that stay in play. *)
Definition highest (r : I.type) (hi : state) (z : F.type) : state * F.type :=
  let k := slope hi in let c := up (height hi (pi_ T)) in
  let z := behind_root G c k z in let x := pt z in let '(s, w) := sc p G T x in
  if nonneg x && nonneg (I.sub p (quarter T) x) && pos (I.sub p s (I.add p c (I.mul p k x))) then
    let w := low w in let D := DI p w k r in
    ({| corner := x; sine := up s;
        slope := if pos w && pos D then up (I.div p (NI p w k r) D) else unit_ T |}, z)
  else ({| corner := quarter T; sine := unit_ T; slope := unit_ T |}, first_guess G).

(** Is a contact with the bridge counted, if there may be one? And do all states have one? *)
Definition bridge_counted (n : nat) (r0 r1 : I.type) (lo hi : state) : bool * bool :=
  if above r1 (height lo I.zero) (slope lo) then (true, false) else
  let '(t, all) := last_contact r0 r1 (slope lo) (height hi I.zero) (slope hi) in
  (match n with O => false | S m => at_most_contact m r0 t I.zero end, all).
(** At most n later collisions of all states between the two. *)
Fixpoint follow (n : nat) (r0 r1 : I.type) (lo hi : state) (z zh : F.type) : bool :=
  let k := slope lo in let c := low0 (height lo (pi_ T)) in
  if nonneg (I.sub p k (unit_ T)) then true else
  if nonneg (I.sub p k r1) then at_most p G T n r0 c k z else
  let '(counted, all) := bridge_counted n r0 r1 lo hi in
  if negb counted then false else
  if all then true else
  let z' := near_root G c k z in
  if (if seems_to_hit G c k z' then match n with O => misses p G T c k | _ => false end else misses p G T c k)
  then true else
  match n with
  | O => false
  | S m =>
    let '(x, s, w) := earliest p G T c k z' in
    let D := DI p w k r0 in
    if nonneg (I.neg D) then true else
    let '(hi', zh') := highest r1 hi zh in
    follow m r0 r1 {| corner := x; sine := s; slope := low (I.div p (NI p w k r0) D) |} hi' z' zh'
  end.

(* ---------- soundness ---------- *)
Hypothesis HT : T = mkconsts p.
Let piI := pi_in p T HT.
Let quI := quarter_in p T HT.
Let unI := unit_in p T HT.

Lemma turn_ok t ti : inI t ti -> inI (sin t) (fst (turn ti)) /\ inI (cos t) (snd (turn ti)).
Proof.
  intros H. unfold turn. destruct (pos _); [|exact (sc_ok p G T HT t ti H)].
  destruct (sc_ok p G T HT _ _ (sub_in p _ _ _ _ piI H)) as [A B].
  destruct (sc p G T _) as [s w]. simpl in *. split.
  - now rewrite sin_PI_x in A.
  - rewrite cos_minus, cos_PI, sin_PI in B. replace (cos t) with (- (-1 * cos t + 0 * sin t)) by ring. now apply neg_in.
Qed.
Lemma on_bridge_ok t ti : on_bridge ti = true -> inI t ti -> 0 <= t <= PI.
Proof.
  unfold on_bridge. intros H Ht. apply andb_prop in H. destruct H as [A B]. apply (nonneg_ok t) in A; [|exact Ht].
  assert (K := nonneg_ok _ _ B (sub_in p _ _ _ _ piI Ht)). lra.
Qed.

Lemma at_most_contact_sound n ri ti yi : at_most_contact n ri ti yi = true -> forall r0 t0 y0, inI r0 ri ->
  inI t0 ti -> inI y0 yi -> forall r t y m, 0 < r0 <= r -> r <= 1 -> 0 <= t <= t0 -> t0 <= PI -> 0 <= y0 <= y ->
  coll r m (r * cX t y) (r * lamX t y) -> (m <= n)%nat.
Proof.
  unfold at_most_contact. intros H r0 t0 y0 Hr Ht Hy r t y m R R1 Tt Tp Y HC.
  assert (C := L15c_contact r m t y t0 y0 ltac:(lra) Tt Tp Y HC).
  replace (Rmax 0 (r * cX t0 y0)) with (r * Rmax 0 (cX t0 y0)) in C
    by (rewrite <- RmaxRmult by lra; now rewrite Rmult_0_r).
  destruct (COS_bound t0) as [B _]. assert (L : -1 <= lamX t0 y0) by (unfold lamX; lra).
  assert (M := Rmax_l 0 (cX t0 y0)). assert (M' := Rmax_r 0 (cX t0 y0)).
  apply (any_slope m _ _ r0 r) in C; try lra.
  destruct (turn_ok t0 ti Ht) as [Hs Hw]. destruct (turn ti) as [s w]. simpl in Hs, Hw.
  assert (Hl : inI (lamX t0 y0) (I.add p w yi)) by now apply add_in.
  assert (Hc : inI (r0 * cX t0 y0)
    (I.mul p ri (I.add p s (I.mul p (I.add p w yi) (I.sub p (pi_ T) ti))))).
  { apply mul_in; [exact Hr|]. apply add_in; [exact Hs|]. apply mul_in; [exact Hl | now apply sub_in]. }
  assert (E : r0 * cX t0 y0 <= r0 * Rmax 0 (cX t0 y0)) by (apply Rmult_le_compat_l; lra).
  assert (E' : 0 <= r0 * Rmax 0 (cX t0 y0)) by (apply Rmult_le_pos; lra).
  destruct (low0_ok _ _ Hc _ E E') as [c1 [C1 C2]].
  destruct (low_ok _ _ (mul_in p _ _ _ _ Hr Hl)) as [k1 [K1 K2]].
  apply (at_most_sound p G T HT n _ _ _ _ H r0 c1 k1 Hr C1 K1 r0 _ _) with (2 := C).
  assert (r0 * -1 <= r0 * lamX t0 y0) by (apply Rmult_le_compat_l; lra). repeat split; lra.
Qed.

Lemma near_slope_point k : exists x, inI x (near_slope k).
Proof. unfold near_slope. destruct (nonneg k); eexists; apply single_in. Qed.
Lemma above_sound ri hi ki : above ri hi ki = true -> forall r h k, inI r ri -> inI h hi -> inI k ki -> 0 <= r ->
  forall t, 0 <= t <= PI -> r * sin t < h + k * t.
Proof.
  unfold above. intros H r h k Hr Hh Hk R0 t Ht. set (zi := near_slope _) in H.
  destruct (turn zi) as [s w] eqn:Et. apply andb_prop in H. destruct H as [H H3]. apply andb_prop in H.
  destruct H as [H1 H2].
  destruct (near_slope_point (I.div p ki ri)) as [z Hz]. fold zi in Hz.
  destruct (turn_ok z zi Hz) as [Hs Hw]. rewrite Et in Hs, Hw. simpl in Hs, Hw.
  assert (Z := on_bridge_ok z zi H1 Hz).
  assert (A := pos_ok _ _ H2 (sub_in p _ _ _ _ Hh
    (mul_in p _ _ _ _ Hr (sub_in p _ _ _ _ Hs (mul_in p _ _ _ _ Hz Hw))))).
  assert (B := pos_ok _ _ H3 (sub_in p _ _ _ _ (add_in p _ _ _ _ Hh (mul_in p _ _ _ _ Hk piI))
    (mul_in p _ _ _ _ Hr (add_in p _ _ _ _ Hs (mul_in p _ _ _ _ (sub_in p _ _ _ _ piI Hz) Hw))))).
  assert (Tg := sin_below_tangent z t Z Ht). assert (HPI : 0 < PI) by apply PI_RGT_0.
  assert (r * sin t <= r * (sin z + (t - z) * cos z)) by (apply Rmult_le_compat_l; lra).
  set (a := h - r * (sin z - z * cos z)) in *. set (b := h + k * PI - r * (sin z + (PI - z) * cos z)) in *.
  assert (E : PI * (h + k * t - r * (sin z + (t - z) * cos z)) = a * (PI - t) + b * t) by (unfold a, b; ring).
  assert (0 < h + k * t - r * (sin z + (t - z) * cos z)); [|lra]. apply Rmult_lt_reg_l with PI; [exact HPI|].
  rewrite E, Rmult_0_r. destruct (Rle_lt_or_eq_dec t PI ltac:(lra)) as [K|K].
  - assert (0 < a * (PI - t)) by (apply Rmult_lt_0_compat; lra). assert (0 <= b * t) by (apply Rmult_le_pos; lra). lra.
  - assert (0 < b * t) by (apply Rmult_lt_0_compat; lra). assert (0 <= a * (PI - t)) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma below_at_sound ri hi ki ti : below_at ri hi ki ti = true -> forall r h k t, inI r ri -> inI h hi ->
  inI k ki -> inI t ti -> 0 <= t <= PI /\ h + k * t < r * sin t.
Proof.
  unfold below_at. intros H r h k t Hr Hh Hk Ht. destruct (turn_ok t ti Ht) as [Hs _].
  destruct (turn ti) as [s w]. simpl in Hs. apply andb_prop in H. destruct H as [H1 H2].
  split; [exact (on_bridge_ok t ti H1 Ht)|].
  assert (A := pos_ok _ _ H2 (sub_in p _ _ _ _ (mul_in p _ _ _ _ Hr Hs)
    (add_in p _ _ _ _ Hh (mul_in p _ _ _ _ Hk Ht)))).
  lra.
Qed.
Lemma flat_at_sound r0i r1i ki ti : flat_at r0i r1i ki ti = true -> forall r0 r1 k t, inI r0 r0i -> inI r1 r1i ->
  inI k ki -> inI t ti -> 0 <= t <= PI /\ r0 * cos t <= k /\ r1 * cos t <= k.
Proof.
  unfold flat_at. intros H r0 r1 k t H0 H1 Hk Ht. destruct (turn_ok t ti Ht) as [_ Hw].
  destruct (turn ti) as [s w]. simpl in Hw. apply andb_prop in H. destruct H as [H B]. apply andb_prop in H.
  destruct H as [A1 A2]. split; [exact (on_bridge_ok t ti A1 Ht)|].
  assert (K1 := nonneg_ok _ _ A2 (sub_in p _ _ _ _ Hk (mul_in p _ _ _ _ H0 Hw))).
  assert (K2 := nonneg_ok _ _ B (sub_in p _ _ _ _ Hk (mul_in p _ _ _ _ H1 Hw))). lra.
Qed.
Lemma widen_good n good start width : forall pad t, widen n good start width pad = Some t ->
  good t = true /\ exists x, inI x t.
Proof.
  induction n as [|n IH]; intros pad t; simpl; [discriminate|]. set (u := pt _). destruct (good u) eqn:E.
  - intros H. injection H; intros <-. split; [exact E | eexists; apply single_in].
  - apply IH.
Qed.

Section States.
Variables (r0i r1i : I.type) (r0 r1 r : R).
Hypotheses (H0 : inI r0 r0i) (H1 : inI r1 r1i) (R0 : 0 < r0) (Ra : r0 <= r) (Rb : r <= r1) (R1 : r1 <= 1).

Definition lies_above (lo : state) x k := exists x0 s0 k0, inI x0 (corner lo) /\ inI s0 (sine lo) /\
  inI k0 (slope lo) /\ lower x0 k0 x k /\ s0 <= sin x0.
Definition lies_below (hi : state) x k := exists x1 s1 k1, inI x1 (corner hi) /\ inI s1 (sine hi) /\
  inI k1 (slope hi) /\ lower x k x1 k1 /\ sin x1 <= s1.
Lemma height_in x0 s0 k0 t b ti : inI x0 (corner b) -> inI s0 (sine b) -> inI k0 (slope b) -> inI t ti ->
  inI (s0 + k0 * (x0 + t)) (height b ti).
Proof. intros. unfold height. apply add_in; [assumption|]. apply mul_in; [assumption | now apply add_in]. Qed.

Lemma last_contact_sound ki hi li x k k0 h1 k1 : inI k0 ki -> inI h1 hi -> inI k1 li -> k0 <= k ->
  (forall t, 0 <= t <= PI -> height_at x k t <= h1 + k1 * t) ->
  let '(ti, all) := last_contact r0i r1i ki hi li in
  (exists t, inI t ti /\ 0 <= t <= PI /\ forall u, meets_bridge r x k u -> u <= t) /\
  (all = true -> ~ clears_bridge r x k).
Proof.
  intros K0 X1 K1 L0 L1.
  assert (HPI : 0 < PI) by apply PI_RGT_0. unfold last_contact.
  set (t1 := match widen 7 _ _ _ _ with Some t => t | None => _ end).
  assert (A : exists t, inI t t1 /\ 0 <= t <= PI /\ forall u, meets_bridge r x k u -> u <= t).
  { unfold t1. destruct (widen 7 _ _ _ _) as [t|] eqn:E.
    - apply widen_good in E. destruct E as [E [v Hv]]. exists v. split; [exact Hv|].
      destruct (flat_at_sound _ _ _ _ E r0 r1 k0 v H0 H1 K0 Hv) as [V [V0 V1]]. split; [exact V|]. intros u Hu.
      apply (L15b_before r k0 k x u v ltac:(lra) L0 Hu V).
      destruct (Rle_or_lt 0 (cos v)).
      + assert (r * cos v <= r1 * cos v) by (apply Rmult_le_compat_r; lra). lra.
      + assert (r0 * - cos v <= r * - cos v) by (apply Rmult_le_compat_r; lra). lra.
    - exists PI. split; [exact piI|]. split; [lra|]. intros u [[_ Hu] _]. lra. }
  assert (Met : forall ti, below_at r0i hi li ti = true -> (exists v, inI v ti) ->
    (exists t, inI t ti /\ 0 <= t <= PI /\ forall u, meets_bridge r x k u -> u <= t) /\ ~ clears_bridge r x k).
  { intros ti E [v Hv]. destruct (below_at_sound _ _ _ _ E r0 h1 k1 v H0) as [V V1]; try assumption.
    assert (r0 * sin v <= r * sin v) by (apply Rmult_le_compat_r; [apply sin_ge_0; lra | lra]).
    destruct (L15b_met r x k v ltac:(lra) V) as [M1 M2]; [specialize (L1 v V); lra|].
    split; [|exact M1]. exists v. now repeat split. }
  set (lowest := near_slope _). destruct (below_at r0i _ _ lowest) eqn:Eb; [|split; [exact A | discriminate]].
  set (t' := match widen 8 _ _ _ _ with Some t => t | None => _ end).
  assert (B : below_at r0i hi li t' = true /\ exists v, inI v t').
  { unfold t'. destruct (widen 8 _ _ _ _) as [t|] eqn:E; [exact (widen_good _ _ _ _ _ _ E)|]. split; [exact Eb|].
    apply near_slope_point. }
  destruct (Met t' (proj1 B) (proj2 B)) as [M1 M2]. split; [|intros _; exact M2]. now destruct (pos _).
Qed.

Lemma bridge_counted_sound n lo hi x k : lies_above lo x k -> lies_below hi x k ->
  let '(counted, all) := bridge_counted n r0i r1i lo hi in
  (counted = true -> forall t m, meets_bridge r x k t ->
     (m = O \/ exists eta, 0 < eta /\ coll r m (r * cX t eta) (r * lamX t eta)) -> (S m <= n)%nat) /\
  (all = true -> ~ clears_bridge r x k).
Proof.
  intros HL HU. unfold bridge_counted. destruct (above r1i _ _) eqn:Ea.
  - split; [|discriminate]. intros _ t m Hm _. exfalso. destruct HL as [x0 [s0 [k0 [X0 [S0 [K0 [L0 E0]]]]]]].
    assert (Hm' := Hm). destruct Hm' as [Ht _].
    assert (A := above_sound _ _ _ Ea r1 _ k0 H1 (height_in _ _ _ _ _ _ X0 S0 K0 zero_in) K0 ltac:(lra) t ltac:(lra)).
    assert (B := L15b_none r x0 k0 x k t L0 Hm). assert (0 <= sin t) by (apply sin_ge_0; lra).
    assert (r * sin t <= r1 * sin t) by (apply Rmult_le_compat_r; lra). unfold height_at in B. lra.
  - destruct HL as [x0 [s0 [k0 [_ [_ [K0 [[_ [_ [Lk _]]] _]]]]]]].
    destruct HU as [x1 [s1 [k1 [X1 [S1 [K1 [L1 E1]]]]]]].
    assert (B : forall t, 0 <= t <= PI -> height_at x k t <= s1 + k1 * (x1 + 0) + k1 * t).
    { intros t Ht. assert (A := L15a_height x k x1 k1 t L1 ltac:(lra)). unfold height_at in A at 2. lra. }
    assert (K := last_contact_sound _ _ _ x k _ _ _ K0 (height_in _ _ _ _ _ _ X1 S1 K1 zero_in) K1 Lk B).
    destruct (last_contact _ _ _ _ _) as [ti all].
    destruct K as [[v [Hv [V Hlast]]] Hall]. split; [|exact Hall].
    intros Hn t m Hm Hc. destruct n as [|n]; [discriminate|].
    destruct Hc as [->|[eta [He Hc]]]; [lia|]. apply le_n_S.
    apply (at_most_contact_sound n _ _ _ Hn r0 v 0 H0 Hv zero_in r t eta m); try lra; [|exact Hc].
    assert (Q := Hlast t Hm). destruct Hm as [Hm _]. lra.
Qed.

Lemma highest_sound hi z x k y : lies_below hi x k -> clears_bridge r x k -> hit (height_at x k PI) k y ->
  next_slope (cos y) k r < 1 -> lies_below (fst (highest r1i hi z)) y (next_slope (cos y) k r).
Proof.
  intros [x1 [s1 [k1 [X1 [S1 [K1 [L1 E1]]]]]]] Hcl Hy Hk1. unfold highest.
  assert (HPI : 0 < PI) by apply PI_RGT_0.
  destruct (up_ok _ _ (height_in _ _ _ _ _ _ X1 S1 K1 piI)) as [c1 [C1 C2]]. set (ci := up _) in *.
  assert (Hv := single_in (behind_root G ci (slope hi) z)). set (v := proj_val _) in Hv. set (vi := pt _) in *.
  destruct (sc_ok p G T HT v vi Hv) as [Hs Hw]. destruct (sc p G T vi) as [s w]. simpl in Hs, Hw.
  assert (Y := proj1 Hy).
  destruct (nonneg vi && _ && _) eqn:E.
  - apply andb_prop in E. destruct E as [E V3]. apply andb_prop in E. destruct E as [V1 V2].
    assert (W1 := nonneg_ok _ _ V1 Hv). assert (W2 := nonneg_ok _ _ V2 (sub_in p _ _ _ _ quI Hv)).
    assert (W3 := pos_ok _ _ V3 (sub_in p _ _ _ _ Hs (add_in p _ _ _ _ C1 (mul_in p _ _ _ _ K1 Hv)))).
    assert (P0 : 0 <= height_at x1 k1 PI).
    { assert (Q := Hcl PI ltac:(lra)). rewrite sin_PI in Q. assert (A := L15a_height x k x1 k1 PI L1 ltac:(lra)). lra. }
    assert (P1 : height_at x1 k1 PI + k1 * v < sin v) by (unfold height_at; lra).
    destruct (hit_exists _ _ v P0 ltac:(lra) P1) as [y1 [Y1 Y2]].
    destruct (L15a_collides_before r x k x1 k1 y1 L1 Hcl Y1) as [y' [Y3 Y4]].
    assert (y = y') by exact (hit_unique _ _ _ _ Hy Y3). subst y'. destruct (up_ok _ _ Hs) as [s2 [S2 S3]].
    assert (Ly : 0 <= y <= v) by lra. destruct (low_ok _ _ Hw) as [w2 [W4 W5]].
    exists v, s2. destruct (pos (low w) && _) eqn:E.
    + apply andb_prop in E. destruct E as [D1 D2]. assert (W6 := pos_ok _ _ D1 W4).
      assert (HD := DI_in p _ _ _ _ _ _ W4 K1 H1). assert (D3 := pos_ok _ _ D2 HD).
      assert (A := L15a_highest r r1 k k1 y v w2 ltac:(lra) Ly ltac:(lra) ltac:(lra) (proj1 (proj2 (proj2 L1))) D3).
      destruct (up_ok (next_slope w2 k1 r1) (I.div p (NI p (low w) (slope hi) r1i) (DI p (low w) (slope hi) r1i)))
        as [k2 [K2 K3]]; [apply div_in; [now apply NI_in | exact HD]|].
      exists k2. repeat split; try assumption; destruct A as [A1 [A2 [A3 A4]]]; lra.
    + exists 1. destruct (COS_bound v). repeat split; try assumption; lra.
  - exists (PI/2), 1, 1. rewrite sin_PI2. assert (C := cos_PI2). repeat split; try assumption; lra.
Qed.

Theorem follow_sound n : forall lo hi z zh, follow n r0i r1i lo hi z zh = true -> forall x k, lies_above lo x k ->
  (k < 1 -> lies_below hi x k) -> forall m, forward r m x k -> (m <= n)%nat.
Proof.
  induction n as [n IH] using (well_founded_induction Wf_nat.lt_wf). intros lo hi z zh H x k HL HU m Hm.
  destruct m as [|m]; [lia|]. assert (HPI : 0 < PI) by apply PI_RGT_0.
  assert (HK : k < 1).
  { apply Rnot_le_lt. intros K. assert (Q := forward_steep r (S m) x k ltac:(lra) K Hm). discriminate. }
  specialize (HU HK). assert (HL' := HL). destruct HL' as [x0 [s0 [k0 [X0 [S0 [K0 [L0 E0]]]]]]].
  assert (L0' := L0). destruct L0' as [Lx [Lx2 [Lk Lu]]].
  assert (Hh : inI (s0 + k0 * (x0 + PI)) (height lo (pi_ T))) by now apply height_in.
  assert (Q := L15a_height x0 k0 x k PI L0 ltac:(lra)).
  assert (Ch : 0 <= height_at x k PI -> exists c, inI c (low0 (height lo (pi_ T))) /\ c <= height_at x k PI).
  { intros P. apply (low0_ok _ _ Hh); [unfold height_at in *; lra | exact P]. }
  assert (HB := bridge_counted_sound n lo hi x k HL HU).
  destruct n as [|n]; cbn [follow] in H; (destruct (nonneg (I.sub p (slope lo) (unit_ T))) eqn:E1;
    [assert (A := nonneg_ok _ _ E1 (sub_in p _ _ _ _ K0 unI)); lra|]);
    (destruct (nonneg (I.sub p (slope lo) r1i)) eqn:E2;
    [assert (A := nonneg_ok _ _ E2 (sub_in p _ _ _ _ K0 H1)); assert (0 <= sin x) by (apply sin_ge_0; lra);
     assert (0 <= k * (x + PI)) by (apply Rmult_le_pos; lra);
     destruct Ch as [c [C1 C2]]; [unfold height_at; lra|];
     apply (at_most_sound p G T HT _ _ _ _ _ H r0 c k0 H0 C1 K0 r (height_at x k PI) k);
     [unfold height_at in *; repeat split; lra | apply forward_is_ray; [lra | lra | lra | exact Hm]]|]);
    destruct (bridge_counted _ _ _ _ _) as [cd all]; destruct HB as [HB1 HB2]; destruct cd; try discriminate;
    simpl in H;
    (destruct Hm as [[t [Ht Hc]]|[Hcl [y [Hy0 [Hy Hn]]]]]; [apply (HB1 eq_refl t m Ht);
      destruct Hc as [Hc|[eta [He [_ [_ Hc]]]]]; [now left | right; now exists eta]|]);
    (destruct all; [exfalso; now apply HB2|]);
    assert (P0 : 0 <= height_at x k PI) by (assert (P := Hcl PI ltac:(lra)); now rewrite sin_PI, Rmult_0_r in P);
    destruct (Ch P0) as [c [C1 C2]]; set (z' := near_root _ _ _ _) in H.
  - assert (M : misses p G T (low0 (height lo (pi_ T))) (slope lo) = true)
      by (destruct (seems_to_hit _ _ _ _); destruct (misses _ _ _ _ _); congruence).
    exfalso. exact (misses_sound p G T HT c k0 _ _ M C1 K0 _ k C2 Lk y Hy).
  - destruct (if seems_to_hit _ _ _ _ then false else misses _ _ _ _ _) eqn:E3.
    { assert (M : misses p G T (low0 (height lo (pi_ T))) (slope lo) = true)
        by (destruct (seems_to_hit _ _ _ _); congruence).
      exfalso. exact (misses_sound p G T HT c k0 _ _ M C1 K0 _ k C2 Lk y Hy). }
    destruct Hn as [->|[HD Hn]]; [lia|]. apply le_n_S.
    assert (ES := earliest_sound p G T HT c k0 _ _ z' C1 K0 _ k y C2 Lk Hy).
    destruct (earliest p G T _ _ z') as [[xi si] wi]. destruct ES as [x_ [s_ [w_ [A1 [A2 [A3 [A4 [A5 A6]]]]]]]].
    assert (A := L15a_lowest r0 r k0 k x_ y w_ ltac:(lra) A4 ltac:(destruct Hy; lra) A6 Lk ltac:(destruct Hy; lra) HD).
    assert (HDI := DI_in p _ _ _ _ _ _ A3 K0 H0).
    destruct (nonneg (I.neg (DI p wi (slope lo) r0i))) eqn:E4.
    { assert (B := nonneg_ok _ _ E4 (neg_in _ _ HDI)).
      assert (Hc1 : cos y <= cos x_) by (apply cos_mono; destruct Hy; lra).
      assert (Hw0 := cos_pos y (proj1 Hy)).
      destruct (reflect_mono w_ (cos y) k0 k r0 r) as [D1 _]; try lra. destruct Hy as [_ [_ Hy]]. lra. }
    assert (HH := highest_sound hi zh x k y HU Hcl Hy). destruct (highest r1i hi zh) as [hi' zh'].
    apply (IH n ltac:(lia) _ _ _ _ H y (next_slope (cos y) k r)) with (3 := Hn); [|exact HH].
    destruct (low_ok _ _ (div_in p _ _ _ _ (NI_in p _ _ _ _ _ _ A3 K0 H0) HDI)) as [k1 [B1 B2]].
    exists x_, s_, k1. repeat split; try assumption; destruct A as [? [? [? ?]]]; unfold next_slope in *; lra.
Qed.
End States.
End S.
End ForwardCount.
