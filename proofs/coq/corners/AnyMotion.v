(** The theorems about motions on any stretch of time, and into corners: no motion has more than N(q) collisions;
    every state in flight has one whole motion. L40, and what `proofs/claim.md` says of corners. *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics Ray Chart Flight Collisions Symmetry Existence OneFlight WitnessMotion Exchange.
From Dumbbell Require Import Stretch Stretches WholeMotion.
Local Open Scope R_scope.

(* ---------- ratios below 1: the masses exchanged ---------- *)
Section Exchange.
Variable P : dumbbell.
Notation Q := (swap_dumbbell P).
Lemma swap_obeys p t : obeys P p t -> obeys Q (swap p) t.
Proof.
  intros [A [B [C [v [v' [D [E F]]]]]]]. unfold obeys. destruct (swap_y P p t) as [-> ->].
  split; [exact B|]. split; [exact A|]. split; [now intros [K1 K2]; apply C|].
  exists v, v'. split; [now apply swap_before|]. split; [now apply swap_after|].
  unfold push1, push2. destruct (swap_arms P) as [-> ->].
  replace (cos (angle (swap p t))) with (- cos (angle (p t))) by (simpl; now rewrite neg_cos).
  destruct F as [->|[[H0 H]|[H0 H]]]; [now left | right; right | right; left]; (split; [exact H0|]);
    apply (swap_push P) with (2 := H); ring.
Qed.
Definition swap_state (s : pos) := {| height := height s; angle := angle s + PI |}.
Lemma swap_down s : both_down P s -> both_down Q (swap_state s).
Proof. intros [A B]. destruct (swap_y P (fun _ => s) 0) as [E1 E2]. split; [now rewrite <- B | now rewrite <- A]. Qed.
Lemma swap_flies_to p T s : flies_to p T s -> flies_to (swap p) T (swap_state s).
Proof.
  intros [v [e [He H]]]. exists v, e. split; [exact He|]. intros t Ht. destruct (H t Ht) as [A B]. simpl.
  rewrite A, B. split; ring.
Qed.
Lemma swap_flies_from p T s : flies_from p T s -> flies_from (swap p) T (swap_state s).
Proof.
  intros [v [e [He H]]]. exists v, e. split; [exact He|]. intros t Ht. destruct (H t Ht) as [A B]. simpl.
  rewrite A, B. split; ring.
Qed.
Lemma swap_whole a b p : whole P a b p -> whole Q a b (swap p).
Proof.
  intros [Hm [E B]]. split; [intros t Ht; now apply swap_obeys, Hm|]. split.
  - destruct E as [->|[T [s [-> [C F]]]]]; [now left | right]. exists T, (swap_state s). split; [reflexivity|].
    split; [now apply swap_down | now apply swap_flies_to].
  - destruct B as [->|[T [s [-> [C F]]]]]; [now left | right]. exists T, (swap_state s). split; [reflexivity|].
    split; [now apply swap_down | now apply swap_flies_from].
Qed.
Lemma swap_upper U : real_dumbbell P -> upper_bound (m2 P / m1 P) U -> upper_bound (m2 Q / m1 Q) U.
Proof.
  intros HP H R p HR E Hm l Hnd Hl. apply (H (swap_dumbbell R) (swap p)) with (4 := Hnd).
  - now apply swap_real. - apply swap_ratio; [exact HR | destruct HP as [? [? ?]]; now apply Rdiv_lt_0_compat|].
    rewrite E. simpl. destruct HP as [? [? ?]]. field. lra.
  - now apply swap_motion. - intros t Ht. now apply swap_collision, Hl.
Qed.
End Exchange.
Lemma swap_twice P : swap_dumbbell (swap_dumbbell P) = P.
Proof. now destruct P. Qed.
(** What holds for one of the two namings of the masses. *)
Lemma one_naming P : real_dumbbell P -> r_of P <= 1 \/ r_of (swap_dumbbell P) <= 1.
Proof.
  intros [H1 [H2 _]]. unfold r_of. simpl. destruct (Rle_or_lt (m1 P) (m2 P)) as [L|L]; [left | right];
    (apply Rmult_le_reg_r with (Rmax (m1 P) (m2 P)); [apply Rlt_le_trans with (1 := H1), Rmax_l|]).
  - rewrite Rmax_right by exact L. replace (m1 P / m2 P * m2 P) with (m1 P) by (field; lra). lra.
  - rewrite Rmax_left by lra. replace (m2 P / m1 P * m1 P) with (m2 P) by (field; lra). lra.
Qed.

(* ---------- the number of collisions ---------- *)
Section Count.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.
Hypothesis Hr1 : r_of P <= 1.
Variable U : nat.
Hypothesis HU : forall p, motion P p -> at_most P p U.
Notation r := (r_of P).

(** L40 (a), in part: 1 + 2 k1 <= N. The contact with the middle of the bridge, e = pi/2, eta = 1. *)
Lemma corner_bound a b : coll r a (r * PI) r -> coll r b (r * PI) r -> (1 + a + b <= U)%nat.
Proof.
  intros Ca Cb. assert (HPI : 0 < PI) by apply PI_RGT_0. assert (R0 := r_pos P HP). assert (P2 := PI2_1).
  assert (K : forall n c k, coll r n (r * PI) r -> 0 <= c <= PI -> -1 <= k <= 1 -> coll r n (r * c) (r * k)).
  { intros n c k H Hc Hk. assert (r * c <= r * PI) by (apply Rmult_le_compat_l; lra).
    assert (0 <= r * c) by (apply Rmult_le_pos; lra).
    assert (r * k <= r * 1) by (apply Rmult_le_compat_l; lra).
    assert (r * -1 <= r * k) by (apply Rmult_le_compat_l; lra).
    apply (coll_mono n) with (8 := H); lra. }
  destruct (bridge_motion P HP Hr1 (PI/2) 1 a b ltac:(lra) ltac:(lra)) as [p [Hm [l [A [B C]]]]].
  - apply K; [exact Ca | |]; unfold cX, lamX; rewrite cos_PI2, ?sin_PI2; lra.
  - assert (E : eta_reversed 1 (cos (PI/2)) r = 1) by (unfold eta_reversed; rewrite cos_PI2; field).
    apply K; [exact Cb | |]; unfold cS, lamS; rewrite E, cos_PI2, ?sin_PI2; lra.
  - rewrite <- B. now apply (HU p Hm l).
Qed.

Lemma ends_few a b p : Rbar_lt a b -> motion_within P a b p -> ends_in_corner P p b -> at_most_within P a b p U.
Proof.
  intros Hab Hm [T [s [-> [C F]]]] l Hnd Hl. destruct (into_corner P HP Hr1 a T s p Hm Hab C F) as [q [E [_ Hc]]].
  assert (K := corner_bound (length l) 0). enough (1 + length l + 0 <= U)%nat by lia. apply K; [|exact I].
  apply Hc; [exact Hnd|].
  intros t Ht. destruct (Hl t Ht) as [[W1 W2] Ct]. split; [now split|].
  apply near_collision with p; [now apply within_near with a T | exact Ct].
Qed.
Lemma reverse_at_most a b p : motion_within P a b p -> at_most_within P (Rbar_opp b) (Rbar_opp a) (reverse p) U ->
  at_most_within P a b p U.
Proof.
  intros Hm H l Hnd Hl. rewrite <- (map_length Ropp). apply H.
  - apply FinFun.Injective_map_NoDup; [intros x y E; lra | exact Hnd].
  - intros t Ht. apply in_map_iff in Ht. destruct Ht as [t' [<- Ht']]. destruct (Hl t' Ht') as [W C].
    split; [now apply within_reverse | now apply (collision_turned P HP a b)].
Qed.
Lemma whole_few a b p : Rbar_lt a b -> whole P a b p -> at_most_within P a b p U.
Proof.
  intros Hab [Hm [[->|He] Hb]]; [|now apply ends_few]. destruct Hb as [->|Hb].
  - apply motion_everywhere in Hm. intros l Hnd Hl. apply (HU p Hm l Hnd). intros t Ht. now apply Hl.
  - apply reverse_at_most; [exact Hm|].
    apply ends_few; [now apply Rbar_opp_lt | now apply motion_reverse | now apply ends_reverse].
Qed.
Theorem stretch_few a b p : motion_within P a b p -> at_most_within P a b p U.
Proof.
  intros Hm [|t0 l] Hnd Hl; [simpl; lia|]. destruct (Hl t0 (or_introl eq_refl)) as [H0 _].
  destruct (whole_around P HP Hr1 a b p t0 Hm H0) as [a' [b' [q [Hq [A [B E]]]]]].
  assert (H0' := within_sub a' b' a b t0 A B H0). apply (whole_few a' b' q (within_ends _ _ _ H0') Hq (t0 :: l) Hnd).
  intros t Ht. destruct (Hl t Ht) as [W C]. split; [now apply within_sub with a b|].
  apply near_collision with p; [now apply within_near with a b | exact C].
Qed.
End Count.

(** **Every motion on a stretch of time**, bounded or not, whether or not it comes out of a corner or runs into one,
    has at most N(q) collisions. *)
Theorem stretch_at_most P a b p U : real_dumbbell P -> upper_bound (m2 P / m1 P) U -> motion_within P a b p ->
  at_most_within P a b p U.
Proof.
  intros HP HU Hm. destruct (one_naming P HP) as [Hr|Hr].
  - apply (stretch_few P HP Hr U); [|exact Hm]. intros f Hf. now apply (HU P f).
  - intros l Hnd Hl. assert (HQ := swap_real P HP).
    apply (stretch_few _ HQ Hr U) with (a := a) (b := b) (p := swap p); [| | exact Hnd |].
    + intros f Hf. now apply (swap_upper P U HP HU _ f).
    + intros t Ht. now apply swap_obeys, Hm.
    + intros t Ht. destruct (Hl t Ht). split; [assumption | now apply swap_collision].
Qed.

(** **Collisions do not accumulate**: what obeys the law at each time of (a, T) flies freely just before T, and
    arrives somewhere. (Backwards the same holds just after a, by reversal.) *)
Theorem no_accumulation_at_end P a (T : R) p : real_dumbbell P -> Rbar_lt a T -> motion_within P a T p ->
  exists s, flies_to p T s.
Proof.
  intros HP Ha Hm. destruct (one_naming P HP) as [Hr|Hr]; [now apply (settles_at_end P HP Hr a)|].
  destruct (settles_at_end _ (swap_real P HP) Hr a T (swap p) Ha) as [s [v [e [He H]]]]; [intros t Ht;
    now apply swap_obeys, Hm|].
  exists {| height := height s; angle := angle s - PI |}, v, e. split; [exact He|]. intros t Ht.
  destruct (H t Ht) as [A B].
  simpl in *. split; lra.
Qed.
Theorem no_accumulation_at_beginning P (T : R) b p : real_dumbbell P -> Rbar_lt T b -> motion_within P T b p ->
  exists s, flies_from p T s.
Proof.
  intros HP Hb Hm. destruct (no_accumulation_at_end P (Rbar_opp b) (- T) (reverse p) HP) as [s F].
  - now apply (Rbar_opp_lt b T). - now apply motion_reverse in Hm.
  - exists s. apply flies_from_reverse in F. now rewrite reverse_reverse, Ropp_involutive in F.
Qed.

(** **Every state in flight has one whole motion**: it lasts for ever, or until it runs into a corner, and so it does
    backwards, but it has a corner at one end at most; it contains every motion on a stretch that has this state at
    the time 0; it has at most N(q) collisions. *)
Theorem whole_motion P s v : real_dumbbell P -> 0 < y1 P s -> 0 < y2 P s ->
  exists a b p, within a b 0 /\ whole P a b p /\ p 0 = s /\ before p 0 v /\ after p 0 v /\
    (a = m_infty \/ b = p_infty) /\
    (forall a' b' p', within a' b' 0 -> motion_within P a' b' p' -> p' 0 = s -> after p' 0 v ->
      Rbar_le a a' /\ Rbar_le b' b /\ forall t, within a' b' t -> p' t = p t) /\
    (forall U, upper_bound (m2 P / m1 P) U -> at_most_within P a b p U).
Proof.
  intros HP H1 H2.
  assert (Ex : exists a b p, within a b 0 /\ whole P a b p /\ p 0 = s /\ before p 0 v /\ after p 0 v /\
    (a = m_infty \/ b = p_infty)).
  { assert (G : forall P s v, real_dumbbell P -> r_of P <= 1 -> 0 < y1 P s -> 0 < y2 P s ->
      exists a b p, within a b 0 /\ whole P a b p /\ p 0 = s /\ before p 0 v /\ after p 0 v /\
        (a = m_infty \/ b = p_infty)).
    { clear P s v HP H1 H2. intros P s v HP Hr H1 H2. assert (A1 := arm1_pos P HP). assert (A2 := arm2_pos P HP).
      destruct (whole_exists P HP Hr s v v) as [a [b [p [H0 [Hw [E [Hb Ha]]]]]]]; try (split; lra).
      - split; [|lra]. unfold y1, y2 in *. apply Rmult_lt_reg_l with (arm1 P + arm2 P); [lra|].
        assert (0 < arm2 P * (height s + arm1 P * sin (angle s))) by (apply Rmult_lt_0_compat; lra).
        assert (0 < arm1 P * (height s - arm2 P * sin (angle s))) by (apply Rmult_lt_0_compat; lra). lra.
      - now left.
      - exists a, b, p. repeat (split; [assumption|]).
        apply (one_corner P HP Hr a b p); [now apply within_ends with 0 | exact Hw]. }
    destruct (one_naming P HP) as [Hr|Hr]; [now apply G|]. set (s' := {| height := height s; angle := angle s - PI |}).
    assert (Es : swap_state s' = s) by (apply pos_eq; simpl; ring).
    destruct (swap_y (swap_dumbbell P) (fun _ => s') 0) as [Y1 Y2]. rewrite swap_twice in Y1, Y2.
    change (swap (fun _ => s') 0) with (swap_state s') in Y1, Y2. rewrite Es in Y1, Y2.
    destruct (G (swap_dumbbell P) s' v (swap_real P HP) Hr) as [a [b [p [H0 [Hw [E [Hb [Ha Hc]]]]]]]]; [lra | lra |].
    exists a, b, (swap p). split; [exact H0|]. split; [rewrite <- (swap_twice P); now apply swap_whole|].
    split; [rewrite <- Es, <- E; reflexivity|]. split; [now apply swap_before|].
    split; [now apply swap_after | exact Hc]. }
  destruct Ex as [a [b [p [H0 [Hw [E [Hb [Ha Hc]]]]]]]]. exists a, b, p. repeat (split; [assumption|]). split.
  - intros a' b' p' H0' Hm' E' Ha'. destruct (Hm' 0 H0') as [_ [_ [_ [w [w' [Bw [Aw HL]]]]]]].
    assert (w' = v) by (apply after_unique with p' 0; assumption). subst w'. rewrite E' in HL.
    assert (w = v) by (destruct HL as [->|[[K _]|[K _]]]; [reflexivity | lra | lra]). subst w.
    destruct (whole_contains P HP a b p a' b' p' 0 v v) as [A [B C]]; try assumption; [congruence|].
    split; [exact A|]. split; [exact B|]. intros t Ht. symmetry. now apply C.
  - intros U HU. apply stretch_at_most; [exact HP | exact HU | apply Hw].
Qed.
