(** Every state has a whole motion, which lasts for ever or until it runs into a corner, and the same backwards; it
    contains every other motion through the state; it has a corner at one end only (L40 (a)); collisions do not
    accumulate.

    whole_exists, whole_contains, whole_around == a state has a whole motion, which contains any other through it
    settles_at_end == at the end of a stretch the motion flies freely: collisions do not accumulate
    one_corner == L40 (a): a corner at one end at most *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics Flight Symmetry Existence OneFlight EveryState.
From Dumbbell Require Import Stretch Stretches.
Local Open Scope R_scope.

Lemma within_sub a b a' b' t : Rbar_le a a' -> Rbar_le b' b -> within a' b' t -> within a b t.
Proof. intros Ha Hb [A B]. split; [eapply Rbar_le_lt_trans; eassumption | eapply Rbar_lt_le_trans; eassumption]. Qed.
Lemma within_ends a b t : within a b t -> Rbar_lt a b.
Proof. intros [A B]. eapply Rbar_lt_trans; eassumption. Qed.
Lemma within_some a b : Rbar_lt a b -> exists t, within a b t.
Proof.
  destruct a as [a| |], b as [b| |]; simpl; intros H; try contradiction.
  - exists ((a + b) / 2). split; simpl; lra. - exists (a + 1). split; simpl; [lra | exact I].
  - exists (b - 1). split; simpl; [exact I | lra]. - exists 0. now split.
Qed.

Section Whole.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.

(* ---------- ends ---------- *)
Lemma motion_sub a b a' b' p : Rbar_le a a' -> Rbar_le b' b -> motion_within P a b p -> motion_within P a' b' p.
Proof. intros Ha Hb Hm t Ht. apply Hm. now apply within_sub with a' b'. Qed.
Lemma ends_equal a b p q : Rbar_lt a b -> (forall t, within a b t -> p t = q t) -> ends_in_corner P p b ->
  ends_in_corner P q b.
Proof.
  intros Hab E [T [s [-> [C F]]]]. exists T, s. split; [reflexivity|].
  split; [exact C | now apply flies_to_equal with a p].
Qed.
Lemma begins_equal a b p q : Rbar_lt a b -> (forall t, within a b t -> p t = q t) -> begins_in_corner P p a ->
  begins_in_corner P q a.
Proof.
  intros Hab E H. rewrite <- (reverse_reverse q), <- (Rbar_opp_involutive a). apply begins_reverse.
  apply ends_equal with (Rbar_opp b) (reverse p); [now apply Rbar_opp_lt | | now apply ends_reverse].
  intros t Ht. unfold reverse. apply E. now apply within_unreverse.
Qed.
Lemma flies_to_shift c p T s : flies_to p T s -> flies_to (shift c p) (T + c) s.
Proof.
  intros [v [e [He H]]]. exists v, e. split; [exact He|]. intros t Ht. unfold shift.
  destruct (H (t - c) ltac:(lra)) as [A B]. rewrite A, B. split; ring.
Qed.
Lemma flies_from_shift c p T s : flies_from p T s -> flies_from (shift c p) (T + c) s.
Proof.
  intros [v [e [He H]]]. exists v, e. split; [exact He|]. intros t Ht. unfold shift.
  destruct (H (t - c) ltac:(lra)) as [A B]. rewrite A, B. split; ring.
Qed.
Lemma whole_shift a b (c : R) p : whole P a b p -> whole P (Rbar_plus a c) (Rbar_plus b c) (shift c p).
Proof.
  intros [Hm [E B]]. split; [now apply motion_shift|]. split.
  - destruct E as [->|[T [s [-> [C F]]]]]; [now left | right]. exists (T + c), s. split; [reflexivity|].
    split; [exact C|].
    now apply flies_to_shift.
  - destruct B as [->|[T [s [-> [C F]]]]]; [now left | right]. exists (T + c), s. split; [reflexivity|].
    split; [exact C|].
    now apply flies_from_shift.
Qed.

(** A motion that has run into a corner does not go on. *)
Lemma corner_is_last a b p a' b' q t0 v : motion_within P a b p -> ends_in_corner P p b -> within a b t0 ->
  motion_within P a' b' q -> within a' b' t0 -> p t0 = q t0 -> after p t0 v -> after q t0 v -> Rbar_le b' b.
Proof.
  intros Hp [T [s [-> [C F]]]] H0 Hq H0' E Ap Aq. apply Rbar_not_lt_le. intros L.
  destruct (within_open _ _ _ H0) as [d [Hd K]]. destruct (within_open _ _ _ H0') as [d' [Hd' K']].
  assert (M1 : Rmin d d' <= d) by apply Rmin_l. assert (M2 : Rmin d d' <= d') by apply Rmin_r.
  assert (M0 := Rmin_pos _ _ Hd Hd').
  set (a0 := Finite (t0 - Rmin d d')). assert (T0 : t0 < T) by (destruct H0 as [_ H0]; exact H0).
  assert (Q : within a' b' T) by (split; [destruct H0' as [A _]; eapply Rbar_lt_trans; [exact A | exact T0] | exact L]).
  assert (Sub : forall t, within a0 T t -> within a T t /\ within a' b' t).
  { intros t [A B]. simpl in A, B. split.
    - destruct (Rle_or_lt t t0) as [Le|Gt]; [apply K; lra|].
      split; [destruct H0 as [X _]; eapply Rbar_lt_trans; [exact X | exact Gt] | exact B].
    - destruct (Rle_or_lt t t0) as [Le|Gt]; [apply K'; lra | apply (within_between a' b' t0 T);
        [exact H0' | exact Q | lra]]. }
  assert (Ag : forall t, within t0 T t -> p t = q t).
  { intros t [A B]. simpl in A, B. apply (agree_forwards P HP a0 T p q t0 v); try assumption; try (simpl; lra).
    - intros x Hx. now apply Hp, Sub. - intros x Hx. now apply Hq, Sub. - split; simpl; lra. - split; simpl; lra. }
  assert (F1 := flies_to_equal t0 p q T s T0 Ag F). destruct (Hq T Q) as [_ [_ [Rg [w [_ [Hb _]]]]]].
  apply Rg. rewrite (flies_to_unique q T _ s (flies_to_before q T w Hb) F1). exact C.
Qed.

(** A whole motion contains every motion that has a state in common with it. *)
Theorem whole_contains a b p a' b' q t0 v v' : whole P a b p -> within a b t0 -> motion_within P a' b' q ->
  within a' b' t0 ->
  p t0 = q t0 -> before p t0 v -> before q t0 v -> after p t0 v' -> after q t0 v' ->
  Rbar_le a a' /\ Rbar_le b' b /\ forall t, within a' b' t -> p t = q t.
Proof.
  intros [Hp [He Hb]] H0 Hq H0' E Bp Bq Ap Aq.
  assert (B : Rbar_le b' b).
  { destruct He as [->|He]; [destruct b'; simpl; exact I | now apply (corner_is_last a b p a' b' q t0 v')]. }
  assert (A : Rbar_le a a').
  { destruct Hb as [->|Hb]; [destruct a'; simpl; exact I|]. apply Rbar_opp_le.
    apply (corner_is_last (Rbar_opp b) (Rbar_opp a) (reverse p) (Rbar_opp b') (Rbar_opp a') (reverse q) (- t0)
      (minus_v v));
      rewrite ?reverse_at; try assumption; try (now apply motion_reverse); try (now apply within_reverse).
    - now apply ends_reverse. - apply reverse_after. now rewrite Ropp_involutive. - apply reverse_after.
      now rewrite Ropp_involutive. }
  split; [exact A|]. split; [exact B|]. apply (determined_within P HP a' b' p q t0 v v'); try assumption.
  now apply motion_sub with a b.
Qed.

(* ---------- existence ---------- *)
Hypothesis Hr1 : r_of P <= 1.
Lemma outcome_stretch s v : above_floor P s -> leaves P s v -> exists b p, Rbar_lt 0 b /\ p 0 = s /\ after p 0 v /\
  motion_within P 0 b p /\ (b = p_infty \/ ends_in_corner P p b).
Proof.
  intros Hs Hl. destruct (every_state P HP Hr1 s v Hs Hl) as [[p [F0 [Fa Fg]]]|[T [p [u [HT [F0 [Fa [Fg [Fb Fc]]]]]]]]].
  - exists p_infty, p. split; [exact I|]. split; [exact F0|]. split; [exact Fa|]. split; [|now left]. intros t [A _].
    now apply Fg.
  - exists (Finite T), p. split; [exact HT|]. split; [exact F0|]. split; [exact Fa|].
    split; [intros t [A B]; now apply Fg|].
    right. exists T, (p T). split; [reflexivity|]. split; [exact Fc | now apply flies_to_before with u].
Qed.
Theorem whole_exists s v v' : above_floor P s -> leaves P s v' -> leaves P s (minus_v v) ->
  (v' = v \/ (y1 P s = 0 /\ push1 P s v v') \/ (y2 P s = 0 /\ push2 P s v v')) ->
  exists a b p, within a b 0 /\ whole P a b p /\ p 0 = s /\ before p 0 v /\ after p 0 v'.
Proof.
  intros Hs Lv' Lv HL. destruct (outcome_stretch s v' Hs Lv') as [b [pX [Hb [X0 [Xa [Xm Xe]]]]]].
  destruct (outcome_stretch s (minus_v v) Hs Lv) as [c [pS [Hc [S0 [Sa [Sm Se]]]]]].
  set (p := glue 0 (reverse pS) pX). assert (E0 : reverse pS 0 = s) by (unfold reverse; now rewrite Ropp_0).
  assert (Eat : p 0 = s) by (unfold p; now rewrite glue_at).
  assert (Hbp : before p 0 v).
  { apply glue_before. replace v with (minus_v (minus_v v)) by (apply vel_eq; simpl; ring). apply reverse_before.
    now rewrite Ropp_0. }
  assert (Hap : after p 0 v') by (apply glue_after; [now rewrite E0 | exact Xa]).
  assert (Z : Finite 0 = Rbar_opp 0) by (simpl; now rewrite Ropp_0).
  assert (Hc0 : Rbar_lt (Rbar_opp c) 0) by (rewrite Z; now apply Rbar_opp_lt).
  assert (EX : forall t, 0 < t -> pX t = p t) by (intros t Ht; unfold p, glue; destruct (Rle_dec t 0);
    [lra | f_equal; ring]).
  assert (ES : forall t, t < 0 -> reverse pS t = p t) by (intros t Ht; unfold p, glue; destruct (Rle_dec t 0);
    [reflexivity | lra]).
  exists (Rbar_opp c), b, p. split; [now split|]. split; [split; [|split]|now repeat split].
  - intros t [A B]. destruct (Rtotal_order t 0) as [L|[->|L]].
    + apply (near_lawful P (reverse pS)); [now apply glue_left|]. apply reverse_lawful, Sm.
      rewrite Z, <- (Rbar_opp_involutive c). apply within_reverse. split; [exact A | exact L].
    + destruct Hs as [H0 [H1 H2]]. unfold obeys. rewrite Eat. split; [exact H1|]. split; [exact H2|]. split.
      * intros [K1 K2]. apply (one_contact P HP s); [now repeat split | exact K1 | exact K2].
      * exists v, v'. now repeat split.
    + apply (near_lawful P (shift 0 pX)); [now apply glue_right|]. apply shift_lawful, Xm. rewrite Rminus_0_r.
      split; [exact L | exact B].
  - destruct Xe as [->|Xe]; [now left | right]. apply ends_equal with 0 pX; [exact Hb | | exact Xe]. intros t [A _].
    now apply EX.
  - destruct Se as [->|Se]; [now left | right].
    apply begins_equal with 0 (reverse pS); [exact Hc0 | | now apply begins_reverse].
    intros t [_ B]. now apply ES.
Qed.
(** Through each state of a motion there is a whole motion, which contains it. *)
Theorem whole_around a b p t0 : motion_within P a b p -> within a b t0 -> exists a' b' q, whole P a' b' q /\
  Rbar_le a' a /\ Rbar_le b b' /\ forall t, within a b t -> p t = q t.
Proof.
  intros Hm H0. destruct (state_within P HP a b p t0 Hm H0) as [v [v' [Bp [Ap [Hok [L1 [L2 HL]]]]]]].
  destruct (whole_exists (p t0) v v' Hok L1 L2 HL) as [c [d [q [Hcd [Hq [E0 [Bq Aq]]]]]]].
  exists (Rbar_plus c t0), (Rbar_plus d t0), (shift t0 q). assert (Hs := whole_shift c d t0 q Hq). split; [exact Hs|].
  destruct (whole_contains _ _ (shift t0 q) a b p t0 v v' Hs) as [A [B C]]; try assumption.
  - apply within_shift. now replace (t0 - t0) with 0 by ring.
  - unfold shift. now replace (t0 - t0) with 0 by ring.
  - apply shift_before. now replace (t0 - t0) with 0 by ring.
  - apply shift_after. now replace (t0 - t0) with 0 by ring.
  - split; [exact A|]. split; [exact B|]. intros t Ht. symmetry. now apply C.
Qed.

(** Collisions do not accumulate at the end of a stretch. *)
Theorem settles_at_end a (T : R) p : Rbar_lt a T -> motion_within P a T p -> exists s, flies_to p T s.
Proof.
  intros Ha Hm. destruct (within_some a T Ha) as [t0 H0].
  destruct (whole_around a T p t0 Hm H0) as [a' [b' [q [[Hq [He _]] [A [B E]]]]]].
  assert (E' : forall t, within a T t -> q t = p t) by (intros t Ht; symmetry; now apply E).
  destruct (Rbar_le_lt_or_eq_dec _ _ B) as [L|L].
  - assert (HT : within a' b' T) by (split; [eapply Rbar_le_lt_trans; eassumption | exact L]).
    destruct (Hq T HT) as [_ [_ [_ [v [_ [Hb _]]]]]]. exists (q T).
    apply flies_to_equal with a q; [exact Ha | exact E' |].
    now apply flies_to_before with v.
  - subst b'. destruct He as [He|[T' [s [ET [_ F]]]]]; [discriminate|]. injection ET as <-. exists s.
    now apply flies_to_equal with a q.
Qed.

(** L40 (a): no other corner. *)
Theorem one_corner a b p : Rbar_lt a b -> whole P a b p -> a = m_infty \/ b = p_infty.
Proof.
  intros Hab [Hm [[He|He] [Hb|Hb]]]; try (now left); try (now right). exfalso.
  destruct He as [T [s [-> [C F]]]]. destruct (into_corner P HP Hr1 a T s p Hm Hab C F) as [q [E [Hq _]]].
  destruct Hb as [A [s' [-> [C' F']]]].
  assert (B : begins_in_corner P q A).
  { apply begins_equal with T p; [exact Hab | exact E|]. exists A, s'.
    split; [reflexivity | split; [exact C' | exact F']]. }
  destruct B as [A' [s2 [EA [C2 F2]]]]. injection EA as <-.
  destruct (Hq A (conj I Hab)) as [_ [_ [Rg [w [w' [Hbw [Haw _]]]]]]]. apply Rg.
  assert (K := flies_to_reverse q A s2 F2). assert (K2 : flies_to (reverse q) (- A) (q A)).
  { rewrite <- (reverse_at q A). apply flies_to_before with (minus_v w'). apply reverse_before.
    now rewrite Ropp_involutive. }
  rewrite (flies_to_unique _ _ _ _ K2 K). exact C2.
Qed.
End Whole.
