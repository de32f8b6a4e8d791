(** The theorems about motions on any stretch of time, and into corners: no motion has more than N(q) collisions;
    every state in flight has one whole motion. L40, and what `proofs/claim.md` says of corners.

    stretch_at_most, through_at_most     == on any stretch of time, and through corners: at most N(q) collisions
    corner_at_most, corner_counts_as_two == up to a corner at most (N(q) - 2)/2; besides one at most N(q) - 2
    whole_motion, no_accumulation_at_end == a state's greatest motion, and where it ends
    one_naming                           == the lighter mass may be called m1 *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics Flight Collisions Symmetry Exchange.
From Dumbbell Require Import Stretch Stretches WholeMotion CollisionCount ThroughCorner.
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
Lemma swap_energy v : energy Q v = energy P v.
Proof. unfold energy. now rewrite swap_mass, swap_inertia. Qed.
Lemma swap_through a b p : motion_through P a b p -> motion_through Q a b (swap p).
Proof.
  intros Hm t Ht. destruct (Hm t Ht) as [H|[C [v [v' [Hb [Ha E]]]]]]; [left; now apply swap_obeys | right].
  split; [exact (swap_down _ C)|]. exists v, v'. split; [now apply swap_before|]. split; [now apply swap_after|].
  now rewrite !swap_energy.
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

(** An upper bound for the ratio is one for the motions of each dumbbell, in the naming for which r <= 1. *)
Lemma bound_of P U : upper_bound (m2 P / m1 P) U -> real_dumbbell P -> forall p, motion P p -> at_most P p U.
Proof. intros HU HP p Hm. now apply (HU P p). Qed.
Lemma bound_swapped P U : upper_bound (m2 P / m1 P) U -> real_dumbbell P ->
  forall p, motion (swap_dumbbell P) p -> at_most (swap_dumbbell P) p U.
Proof. intros HU HP p Hm. apply (swap_upper P U HP HU _ p); [now apply swap_real | reflexivity | exact Hm]. Qed.

(** **Every motion on a stretch of time**, bounded or not, whether or not it comes out of a corner or runs into one,
    has at most N(q) collisions; and up to a corner, or after one, it has at most (N(q) - 2)/2. *)
Theorem stretch_at_most P a b p U : real_dumbbell P -> upper_bound (m2 P / m1 P) U -> motion_within P a b p ->
  at_most_within P a b p U.
Proof.
  intros HP HU Hm. destruct (one_naming P HP) as [Hr|Hr].
  - apply (stretch_few P HP Hr U); [now apply bound_of | exact Hm].
  - intros l Hnd Hl. apply (stretch_few _ (swap_real P HP) Hr U (bound_swapped P U HU HP) a b (swap p)); [|exact Hnd|].
    + intros t Ht. now apply swap_obeys, Hm.
    + intros t Ht. destruct (Hl t Ht). split; [assumption | now apply swap_collision].
Qed.
Theorem corner_at_most P a b p U l : real_dumbbell P -> upper_bound (m2 P / m1 P) U -> Rbar_lt a b ->
  motion_within P a b p -> ends_in_corner P p b \/ begins_in_corner P p a ->
  NoDup l -> (forall t, In t l -> within a b t /\ collision P p t) -> (2 + 2 * length l <= U)%nat.
Proof.
  intros HP HU Hab Hm Hc Hnd Hl.
  assert (G : forall Q f, real_dumbbell Q -> r_of Q <= 1 -> (forall p, motion Q p -> at_most Q p U) ->
    motion_within Q a b f -> ends_in_corner Q f b \/ begins_in_corner Q f a ->
    (forall t, In t l -> within a b t /\ collision Q f t) -> (2 + 2 * length l <= U)%nat).
  { clear - Hab Hnd. intros Q f HQ Hr HU Hm Hc Hl. assert (K := corner_bound Q HQ Hr U HU (length l) (length l)).
    enough (2 + length l + length l <= U)%nat by lia.
    destruct Hc; apply K; try (now apply (into_corner_coll Q HQ Hr a b f l));
      now apply (out_of_corner_coll Q HQ Hr a b f l). }
  destruct (one_naming P HP) as [Hr|Hr]; [apply (G P p HP Hr); try assumption; now apply bound_of|].
  apply (G _ (swap p) (swap_real P HP) Hr (bound_swapped P U HU HP)).
  - intros t Ht. now apply swap_obeys, Hm.
  - destruct Hc as [[T [s [-> [C F]]]]|[T [s [-> [C F]]]]]; [left | right]; exists T, (swap_state s);
      (split; [reflexivity|]); (split; [now apply swap_down|]); [now apply swap_flies_to | now apply swap_flies_from].
  - intros t Ht. destruct (Hl t Ht). split; [assumption | now apply swap_collision].
Qed.

(** **A motion through corners**, whatever velocity it leaves them with, has at most N(q) collisions, too. If it meets
    a corner and does not lie at rest there, then it meets no other one, and the corner counts as two collisions. *)
Theorem through_at_most P a b p U : real_dumbbell P -> upper_bound (m2 P / m1 P) U -> motion_through P a b p ->
  at_most_within P a b p U.
Proof.
  intros HP HU Hm. destruct (one_naming P HP) as [Hr|Hr].
  - apply (through_few P HP Hr U); [now apply bound_of | exact Hm].
  - intros l Hnd Hl. apply (through_few _ (swap_real P HP) Hr U (bound_swapped P U HU HP) a b (swap p)); [|exact Hnd|].
    + now apply swap_through.
    + intros t Ht. destruct (Hl t Ht). split; [assumption | now apply swap_collision].
Qed.
Theorem corner_counts_as_two P a b p T v U l : real_dumbbell P -> upper_bound (m2 P / m1 P) U ->
  motion_through P a b p -> within a b T -> both_down P (p T) -> before p T v -> 0 < energy P v ->
  (forall t, within a b t -> t <> T -> obeys P p t) /\
  (NoDup l -> (forall t, In t l -> within a b t /\ t <> T /\ collision P p t) -> (2 + length l <= U)%nat).
Proof.
  intros HP HU Hm HT Hc Hb Hv.
  assert (G : forall Q f, real_dumbbell Q -> r_of Q <= 1 -> motion_through Q a b f -> both_down Q (f T) ->
    before f T v -> 0 < energy Q v -> forall t, within a b t -> t <> T -> ~ both_down Q (f t)).
  { intros Q f HQ Hr Mf Cf Bf Ef t Ht N Ct. destruct (only_corner Q HQ Hr a b f T v Mf HT Cf Bf Ef) as [M1 [M2 _]].
    destruct (Rtotal_order t T) as [L|[L|L]]; [|contradiction|].
    - destruct (M1 t) as [_ [_ [Rg _]]]; [split; [apply Ht | exact L] | now apply Rg].
    - destruct (M2 t) as [_ [_ [Rg _]]]; [split; [exact L | apply Ht] | now apply Rg]. }
  destruct (one_naming P HP) as [Hr|Hr].
  - split.
    + intros t Ht N. destruct (Hm t Ht) as [K|[K _]]; [exact K|]. exfalso. now apply (G P p HP Hr Hm Hc Hb Hv t Ht N).
    + intros Hnd Hl. now apply (corner_counts_two P HP Hr U (bound_of P U HU HP) a b p T v).
  - assert (Hv' : 0 < energy (swap_dumbbell P) v) by (now rewrite swap_energy).
    assert (Hm' := swap_through P a b p Hm). assert (Hc' := swap_down P (p T) Hc).
    assert (Hb' := swap_before p T v Hb). split.
    + intros t Ht N. destruct (Hm t Ht) as [K|[K _]]; [exact K|]. exfalso.
      apply (G _ (swap p) (swap_real P HP) Hr Hm' Hc' Hb' Hv' t Ht N). exact (swap_down P (p t) K).
    + intros Hnd Hl. apply (corner_counts_two _ (swap_real P HP) Hr U (bound_swapped P U HU HP) a b (swap p) T v);
        try assumption.
      intros t Ht. destruct (Hl t Ht) as [A [B C]]. split; [exact A|]. split; [exact B | now apply swap_collision].
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
