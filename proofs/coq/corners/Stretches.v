(** Motions on stretches of time: they are local, may be reversed and shifted, and are determined by their state at
    one time of the stretch. L40 (a): one that runs into a corner is, backwards, the half motion of `FromCorner.v`.

    motion_reverse, motion_shift, within_reverse, within_near == stretches reversed, shifted; paths that agree on them
    motion_everywhere == a motion is one on (-oo, +oo)
    state_within, determined_within == the state at a time of the stretch; it determines the motion there
    into_corner == L40 (a): what runs into a corner is, backwards, a half motion out of it *)
From Coq Require Import Reals Lra List FinFun.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics Ray Flight Symmetry Existence OneFlight.
From Dumbbell Require Import Determinism HalfMotion FromCorner Stretch.
Local Open Scope R_scope.

(* ---------- stretches ---------- *)
Lemma within_open a b t : within a b t -> exists d, 0 < d /\ forall s, t - d <= s <= t + d -> within a b s.
Proof.
  assert (A : Rbar_lt a t -> exists d, 0 < d /\ forall s, t - d <= s -> Rbar_lt a s).
  { destruct a as [a| |]; simpl; intros H; [exists ((t - a) / 2) | contradiction | exists 1]; (split; [lra|]);
      intros; [lra | exact I]. }
  assert (B : Rbar_lt t b -> exists d, 0 < d /\ forall s, s <= t + d -> Rbar_lt s b).
  { destruct b as [b| |]; simpl; intros H; [exists ((b - t) / 2) | exists 1 | contradiction]; (split; [lra|]);
      intros; [lra | exact I]. }
  intros [HA HB]. destruct (A HA) as [d1 [D1 H1]]. destruct (B HB) as [d2 [D2 H2]].
  assert (M1 : Rmin d1 d2 <= d1) by apply Rmin_l. assert (M2 : Rmin d1 d2 <= d2) by apply Rmin_r.
  exists (Rmin d1 d2). split; [now apply Rmin_pos|]. intros s Hs. split; [apply H1 | apply H2]; lra.
Qed.
Lemma within_between a b t1 t2 t : within a b t1 -> within a b t2 -> t1 <= t <= t2 -> within a b t.
Proof.
  intros [A _] [_ B] Ht. split; [destruct a as [a| |] | destruct b as [b| |]]; simpl in *; try lra; try assumption;
    try exact I.
Qed.
Lemma within_reverse a b t : within a b t -> within (Rbar_opp b) (Rbar_opp a) (- t).
Proof. intros [A B]. split; [destruct b as [b| |] | destruct a as [a| |]]; simpl in *; try lra; try assumption;
  try exact I. Qed.
Lemma within_unreverse a b t : within (Rbar_opp b) (Rbar_opp a) t -> within a b (- t).
Proof. intros H. apply within_reverse in H. now rewrite !Rbar_opp_involutive in H. Qed.
Lemma within_shift a b (c t : R) : within (Rbar_plus a c) (Rbar_plus b c) t <-> within a b (t - c).
Proof. unfold within. destruct a as [a| |], b as [b| |]; simpl; split; intros [A B]; split; try lra; try assumption;
  exact I. Qed.

(** A motion for all times is one on the stretch (-oo, +oo). *)
Lemma motion_everywhere P p : motion P p <-> motion_within P m_infty p_infty p.
Proof.
  split.
  - intros Hm t _. repeat split; [apply Hm | apply Hm | apply (regular P p Hm t) | apply (law P p Hm t)].
  - intros H. split; intros t; destruct (H t (conj I I)) as [A [B [C D]]]; assumption.
Qed.

Section Stretches.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.

Lemma within_near a b p q t : (forall s, within a b s -> p s = q s) -> within a b t -> near p q t.
Proof. intros H Ht. destruct (within_open a b t Ht) as [d [Hd K]]. exists d. split; [exact Hd|]. intros s Hs.
apply H, K, Hs. Qed.
Lemma within_equal a b p q : (forall t, within a b t -> p t = q t) -> motion_within P a b p -> motion_within P a b q.
Proof. intros E Hm t Ht. apply (near_lawful P p); [now apply within_near with a b | now apply Hm]. Qed.
Lemma motion_reverse a b p : motion_within P a b p -> motion_within P (Rbar_opp b) (Rbar_opp a) (reverse p).
Proof. intros Hm t Ht. apply (reverse_lawful P), Hm. now apply within_unreverse. Qed.
Lemma motion_shift a b (c : R) p : motion_within P a b p -> motion_within P (Rbar_plus a c) (Rbar_plus b c) (shift c p).
Proof. intros Hm t Ht. apply (shift_lawful P), Hm. now apply within_shift. Qed.

Lemma reverse_at p t : reverse p (- t) = p t.
Proof. unfold reverse. now rewrite Ropp_involutive. Qed.
Lemma lawful_above_floor p t : lawful P p t -> above_floor P (p t).
Proof.
  intros [H1 [H2 [H3 _]]]. split; [|now split]. assert (A1 := arm1_pos P HP). assert (A2 := arm2_pos P HP).
  apply Rnot_le_lt. intros L. apply H3. unfold y1, y2 in *.
  assert (K1 : 0 <= arm1 P * sin (angle (p t))) by lra. assert (K2 : 0 <= - (arm2 P * sin (angle (p t)))) by lra.
  assert (S : sin (angle (p t)) = 0).
  { apply Rle_antisym; [apply Rmult_le_reg_l with (arm2 P); lra | apply Rmult_le_reg_l with (arm1 P); lra]. }
  rewrite S in *. split; lra.
Qed.
(** The state at a time of the stretch: both masses go up from the floor after it, and came down to it before. *)
Lemma state_within a b p t : motion_within P a b p -> within a b t -> exists v v', before p t v /\ after p t v' /\
  above_floor P (p t) /\ leaves P (p t) v' /\ leaves P (p t) (minus_v v) /\
  (v' = v \/ (y1 P (p t) = 0 /\ push1 P (p t) v v') \/ (y2 P (p t) = 0 /\ push2 P (p t) v v')).
Proof.
  intros Hm Ht. destruct (Hm t Ht) as [_ [_ [_ [v [v' [Hb [Ha HL]]]]]]]. destruct (within_open a b t Ht) as [d [Hd K]].
  exists v, v'. split; [exact Hb|]. split; [exact Ha|]. split; [now apply lawful_above_floor, Hm|].
  split; [|split; [|exact HL]].
  - apply (must_turn P HP p t d v' Hd); [|exact Ha]. intros s Hs. apply Hm, K. lra.
  - assert (R := must_turn P HP (reverse p) (- t) d (minus_v v) Hd). rewrite reverse_at in R.
    apply R; [|apply reverse_after; now rewrite Ropp_involutive].
    intros s Hs. apply (reverse_lawful P), Hm, K. lra.
Qed.

(** A collision is one of the reversed path, too. *)
Lemma collision_turned a b p t : motion_within P a b p -> within a b t -> collision P p t ->
  collision P (reverse p) (- t).
Proof.
  intros Hm Ht [v [Hb H]]. destruct (state_within a b p t Hm Ht) as [v0 [v' [Hb0 [Ha [_ [[L1 L2] [_ HL]]]]]]].
  assert (v0 = v) by (apply before_unique with p t; assumption). subst v0.
  destruct (Hm t Ht) as [_ [_ [Rg _]]].
  exists (minus_v v'). split; [apply reverse_before; now rewrite Ropp_involutive|]. rewrite reverse_at.
  unfold w1, w2 in *. simpl.
  destruct H as [[Y W]|[Y W]]; [left; specialize (L1 Y) | right; specialize (L2 Y)]; (split; [exact Y|]).
  - destruct HL as [->|[[_ Q]|[Y2 _]]]; [lra | | exfalso; now apply Rg].
    destruct (push_cases P HP _ _ _ Q) as [->|[E _]]; lra.
  - destruct HL as [->|[[Y1 _]|[_ Q]]]; [lra | exfalso; now apply Rg |].
    destruct (push_cases P HP _ _ _ Q) as [->|[E _]]; lra.
Qed.

(** Determinism on a stretch. *)
Lemma agree_forwards a b p q t0 v : motion_within P a b p -> motion_within P a b q -> within a b t0 -> p t0 = q t0 ->
  after p t0 v -> after q t0 v -> forall t, within a b t -> t0 <= t -> p t = q t.
Proof.
  intros Hp Hq H0 E Ap Aq t Ht L. destruct (within_open a b t Ht) as [d [Hd K]].
  apply (agree P HP p q t0 (t + d) v); try assumption; try lra; intros s Hs.
  - apply Hp, (within_between a b t0 (t + d)); [exact H0 | apply K; lra | lra].
  - apply Hq, (within_between a b t0 (t + d)); [exact H0 | apply K; lra | lra].
Qed.
Theorem determined_within a b p q t0 v v' : motion_within P a b p -> motion_within P a b q -> within a b t0 ->
  p t0 = q t0 ->
  before p t0 v -> before q t0 v -> after p t0 v' -> after q t0 v' -> forall t, within a b t -> p t = q t.
Proof.
  intros Hp Hq H0 E Bp Bq Ap Aq t Ht. destruct (Rle_or_lt t0 t) as [L|L]; [now apply (agree_forwards a b p q t0 v')|].
  assert (G := agree_forwards (Rbar_opp b) (Rbar_opp a) (reverse p) (reverse q) (- t0) (minus_v v)).
  rewrite <- (reverse_at p t), <- (reverse_at q t). apply G; rewrite ?reverse_at; try lra.
  - now apply motion_reverse. - now apply motion_reverse. - now apply within_reverse. - exact E.
  - apply reverse_after. now rewrite Ropp_involutive. - apply reverse_after. now rewrite Ropp_involutive.
    - now apply within_reverse.
Qed.

(* ---------- ends ---------- *)
Lemma flies_to_reverse p T s : flies_from p T s -> flies_to (reverse p) (- T) s.
Proof.
  intros [v [e [He H]]]. exists (minus_v v), e. split; [exact He|]. intros t Ht. unfold reverse.
  destruct (H (- t) ltac:(lra)) as [A B]. rewrite A, B. simpl. split; ring.
Qed.
Lemma flies_from_reverse p T s : flies_to p T s -> flies_from (reverse p) (- T) s.
Proof.
  intros [v [e [He H]]]. exists (minus_v v), e. split; [exact He|]. intros t Ht. unfold reverse.
  destruct (H (- t) ltac:(lra)) as [A B]. rewrite A, B. simpl. split; ring.
Qed.
Lemma ends_reverse p a : begins_in_corner P p a -> ends_in_corner P (reverse p) (Rbar_opp a).
Proof. intros [T [s [-> [C F]]]]. exists (- T), s. split; [reflexivity|].
split; [exact C | now apply flies_to_reverse]. Qed.
Lemma begins_reverse p b : ends_in_corner P p b -> begins_in_corner P (reverse p) (Rbar_opp b).
Proof. intros [T [s [-> [C F]]]]. exists (- T), s. split; [reflexivity|].
split; [exact C | now apply flies_from_reverse]. Qed.
Lemma whole_reverse a b p : whole P a b p -> whole P (Rbar_opp b) (Rbar_opp a) (reverse p).
Proof.
  intros [Hm [E B]]. split; [now apply motion_reverse|]. split.
  - destruct B as [->|B]; [now left | right; now apply ends_reverse].
  - destruct E as [->|E]; [now left | right; now apply begins_reverse].
Qed.
Lemma flies_to_before p T v : before p T v -> flies_to p T (p T).
Proof. intros [e [He H]]. exists v, e. split; [exact He|]. intros t Ht. apply H. lra. Qed.
Lemma flies_to_equal a p q (T : R) s : Rbar_lt a T -> (forall t, within a T t -> p t = q t) -> flies_to p T s ->
  flies_to q T s.
Proof.
  intros Ha E [v [e [He H]]]. assert (K : exists d, 0 < d /\ forall t, T - d < t -> Rbar_lt a t).
  { destruct a as [a| |]; simpl in *; [exists (T - a) | contradiction | exists 1]; (split; [lra|]); intros;
      [lra | exact I]. }
  destruct K as [d [Hd K]]. exists v, (Rmin e d). assert (Rmin e d <= e) by apply Rmin_l.
  assert (Rmin e d <= d) by apply Rmin_r.
  split; [now apply Rmin_pos|]. intros t Ht. rewrite <- E; [apply H; lra|]. split; [apply K; lra | simpl; lra].
Qed.
Lemma flies_to_unique p T s s' : flies_to p T s -> flies_to p T s' -> s = s'.
Proof.
  intros [v [e [He H]]] [v' [e' [He' H']]]. set (d := Rmin e e'). assert (D : 0 < d) by (now apply Rmin_pos).
  assert (d <= e) by apply Rmin_l. assert (d <= e') by apply Rmin_r.
  destruct (H (T - d / 2) ltac:(lra)) as [A1 A2]. destruct (H (T - d / 4) ltac:(lra)) as [A3 A4].
  destruct (H' (T - d / 2) ltac:(lra)) as [B1 B2]. destruct (H' (T - d / 4) ltac:(lra)) as [B3 B4]. apply pos_eq; lra.
Qed.

(** L40 (a). *)
Hypothesis Hr1 : r_of P <= 1.
Notation r := (r_of P).
Theorem into_corner a (T : R) s p : motion_within P a T p -> Rbar_lt a T -> both_down P s -> flies_to p T s ->
  exists q, (forall t, within a T t -> p t = q t) /\ motion_within P m_infty T q /\
  forall l, NoDup l -> (forall t, In t l -> within m_infty T t /\ collision P q t) -> coll r (length l) (PI * r) r.
Proof.
  intros Hm Ha Hs [u [e [He Hf]]].
  assert (K : exists d, 0 < d /\ forall t, T - d < t -> Rbar_lt a t).
  { destruct a as [a| |]; simpl in *; [exists (T - a) | contradiction | exists 1]; (split; [lra|]); intros;
      [lra | exact I]. }
  destruct K as [d [Hd K]]. set (e' := Rmin e d). assert (E1 : e' <= e) by apply Rmin_l.
  assert (E2 : e' <= d) by apply Rmin_r.
  assert (E0 : 0 < e') by (now apply Rmin_pos). set (h0 := fun t => p (T - t)).
  assert (HT : forall t, Rbar_lt a (T - t) -> 0 < t -> lawful P h0 t).
  { intros t H1 H2. apply near_lawful with (shift T (reverse p)).
    - exists 1. split; [lra|]. intros x _. unfold shift, reverse, h0. f_equal. ring.
    - apply shift_lawful, reverse_lawful, Hm. replace (- (t - T)) with (T - t) by ring.
      split; [exact H1 | simpl; lra]. }
  assert (Hline : forall t, 0 < t < e' -> h0 t = line s (minus_v u) t).
  { intros t Ht. destruct (Hf (T - t) ltac:(lra)) as [A B].
    apply pos_eq; unfold h0; simpl; [rewrite A | rewrite B]; ring. }
  destruct (from_corner P HP Hr1 s (minus_v u) e' Hs E0) as [pf [[F1 [F2 F3]] FC]].
  { intros t Ht. apply near_lawful with h0; [|apply HT; [apply K; lra | lra]].
    exists (Rmin t (e' - t) / 2). assert (Rmin t (e' - t) <= t) by apply Rmin_l.
    assert (Rmin t (e' - t) <= e' - t) by apply Rmin_r.
    assert (0 < Rmin t (e' - t)) by (apply Rmin_pos; lra). split; [lra|]. intros x Hx. apply Hline. lra. }
  set (h := glue 0 (line s (minus_v u)) h0). assert (Eh : forall t, 0 < t -> h t = h0 t).
  { intros t Ht. unfold h, glue. destruct (Rle_dec t 0); [lra|]. f_equal. ring. }
  assert (H0 : h 0 = s) by (unfold h; rewrite glue_at; apply line_0).
  assert (A0 : after h 0 (minus_v u)).
  { exists (e' / 2). split; [lra|]. intros t Ht. rewrite H0.
    destruct (Req_dec t 0) as [->|N]; [rewrite H0; split; ring|].
    rewrite Eh, Hline by lra. simpl. split; ring. }
  assert (Agr : forall t, 0 < t -> Rbar_lt a (T - t) -> h0 t = pf t).
  { intros t Ht Hat. destruct (within_open a T (T - t)) as [w [Hw W]]; [split; [exact Hat | simpl; lra]|].
    rewrite <- Eh by exact Ht. apply (agree P HP h pf 0 (t + w) (minus_v u)); try lra; try assumption; try congruence.
    - intros x Hx. apply near_lawful with h0.
      + exists (x / 2). split; [lra|]. intros y Hy. symmetry. apply Eh. lra.
      + apply HT; [|lra]. destruct (Rle_or_lt x t) as [L|L].
        * destruct a as [a| |]; simpl in *; try lra; exact I.
        * destruct (W (T - x) ltac:(lra)) as [Wa _]. exact Wa.
    - intros x Hx. apply F3. lra. }
  exists (shift T (reverse pf)).
  assert (Eq : forall t, shift T (reverse pf) t = pf (T - t)) by (intros t; unfold shift, reverse; f_equal; ring).
  assert (Hq : motion_within P m_infty T (shift T (reverse pf))).
  { intros t [_ H2]. simpl in H2. apply (shift_lawful P), (reverse_lawful P), F3. lra. }
  split; [|split; [exact Hq|]].
  - intros t [H1 H2]. simpl in H2. rewrite Eq, <- Agr; [unfold h0; f_equal; ring | lra |].
    now replace (T - (T - t)) with t by ring.
  - intros l Hnd Hl. apply FC. apply (later_from P) with (map (fun t => T - t) l).
    + apply Injective_map_NoDup; [intros x y E; lra | exact Hnd].
    + now rewrite map_length.
    + intros t Ht. apply in_map_iff in Ht. destruct Ht as [t' [<- Ht']]. destruct (Hl t' Ht') as [[_ D] C].
      simpl in D. split; [lra|].
      assert (R := collision_turned m_infty T _ t' Hq (conj I D) C).
      apply (near_collision P (shift T (reverse (shift T (reverse pf))))).
      * exists 1. split; [lra|]. intros x _. unfold shift, reverse. f_equal. ring.
      * apply shift_collision. now replace (T - t' - T) with (- t') by ring.
Qed.
End Stretches.
