(** The symmetries of L0: the mirror, reversal of time (sigma), whole turns of the rod; as a relation `same`: the same
    motion seen from another side. A motion and its image have the same collisions.

    mirror, reverse, turn                    == paths in the mirror, backwards in time, turned by whole turns
    mirror_motion, reverse_motion, collision_mirror, collision_reverse == motions and collisions remain what they are
    same, same_at_most, same_later           == the same motion seen from another side; it has the same collisions *)
From Coq Require Import Reals Lra Lia List FunctionalExtensionality.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics Flight Collisions.
Local Open Scope R_scope.

Section Symmetry.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.
Notation r := (r_of P).
Notation yh := (yhat_of P).

(** Mirror: phi -> pi - phi. *)
Definition mirror (p : R -> pos) t := {| height := height (p t); angle := PI - angle (p t) |}.
Definition mirror_v v := {| vy := vy v; om := - om v |}.
Lemma sin_mirror x : sin (PI - x) = sin x. Proof. now rewrite sin_PI_x. Qed.
Lemma cos_mirror x : cos (PI - x) = - cos x. Proof. rewrite cos_minus, cos_PI, sin_PI. ring. Qed.
Lemma mirror_before p t v : before p t v -> before (mirror p) t (mirror_v v).
Proof. intros [e [He H]]. exists e. split; [exact He|]. intros s Hs. destruct (H s Hs). unfold mirror; simpl.
split; lra. Qed.
Lemma mirror_after p t v : after p t v -> after (mirror p) t (mirror_v v).
Proof. intros [e [He H]]. exists e. split; [exact He|]. intros s Hs. destruct (H s Hs). unfold mirror; simpl.
split; lra. Qed.
Lemma mirror_push l v v' : push P l v v' -> push P (- l) (mirror_v v) (mirror_v v').
Proof. intros [J [A [B [C D]]]]. exists J. unfold energy in *. simpl. repeat split; try lra. Qed.
Theorem mirror_motion p : motion P p -> motion P (mirror p).
Proof.
  intros Hm. split.
  - intros t. generalize (above1 P p Hm t). unfold y1, mirror; simpl. now rewrite sin_mirror.
  - intros t. generalize (above2 P p Hm t). unfold y2, mirror; simpl. now rewrite sin_mirror.
  - intros t. generalize (regular P p Hm t). unfold y1, y2, mirror; simpl. now rewrite sin_mirror.
  - intros t. destruct (law P p Hm t) as [v [v' [Hb [Ha H]]]]. exists (mirror_v v), (mirror_v v').
    split; [now apply mirror_before|]. split; [now apply mirror_after|].
    destruct H as [->|[[H0 H]|[H0 H]]]; [now left | right; left | right; right];
      (split; [revert H0; unfold y1, y2, mirror; simpl; now rewrite sin_mirror|]).
    + unfold push1 in *. unfold mirror at 1; simpl. rewrite cos_mirror.
      replace (arm1 P * - cos (angle (p t))) with (- (arm1 P * cos (angle (p t)))) by ring. now apply mirror_push.
    + unfold push2 in *. unfold mirror at 1; simpl. rewrite cos_mirror.
      replace (- (arm2 P * - cos (angle (p t)))) with (- - (arm2 P * cos (angle (p t)))) by ring. now apply mirror_push.
Qed.

(** Reversal of time. *)
Definition reverse (p : R -> pos) t := p (- t).
Definition minus_v v := {| vy := - vy v; om := - om v |}.
Lemma reverse_before p t v : after p (- t) v -> before (reverse p) t (minus_v v).
Proof. intros [e [He H]]. exists e. split; [exact He|]. intros s Hs. unfold reverse. destruct (H (- s) ltac:(lra)).
simpl. split; lra. Qed.
Lemma reverse_after p t v : before p (- t) v -> after (reverse p) t (minus_v v).
Proof. intros [e [He H]]. exists e. split; [exact He|]. intros s Hs. unfold reverse. destruct (H (- s) ltac:(lra)).
simpl. split; lra. Qed.
Lemma reverse_push l v v' : push P l v v' -> push P l (minus_v v') (minus_v v).
Proof. intros [J [A [B [C D]]]]. exists J. unfold energy in *. simpl. repeat split; try lra. Qed.
Theorem reverse_motion p : motion P p -> motion P (reverse p).
Proof.
  intros Hm. split; try (intros t; apply Hm).
  intros t. destruct (law P p Hm (- t)) as [v [v' [Hb [Ha H]]]]. exists (minus_v v'), (minus_v v).
  split; [now apply reverse_before|]. split; [now apply reverse_after|].
  destruct H as [->|[[H0 H]|[H0 H]]]; [now left | right; left | right; right]; (split; [exact H0|]);
    now apply reverse_push.
Qed.

(** Turning by 2 k pi. *)
Definition turn (k : nat) (p : R -> pos) t := {| height := height (p t); angle := angle (p t) - 2 * INR k * PI |}.
Lemma sin_turn k p t : sin (angle (turn k p t)) = sin (angle (p t)).
Proof. simpl. rewrite <- (sin_period (angle (p t) - 2 * INR k * PI) k). f_equal. ring. Qed.
Lemma cos_turn k p t : cos (angle (turn k p t)) = cos (angle (p t)).
Proof. simpl. rewrite <- (cos_period (angle (p t) - 2 * INR k * PI) k). f_equal. ring. Qed.
Lemma turn_before k p t v : before p t v -> before (turn k p) t v.
Proof. intros [e [He H]]. exists e. split; [exact He|]. intros s Hs. destruct (H s Hs). simpl. split; lra. Qed.
Lemma turn_after k p t v : after p t v -> after (turn k p) t v.
Proof. intros [e [He H]]. exists e. split; [exact He|]. intros s Hs. destruct (H s Hs). simpl. split; lra. Qed.
Theorem turn_motion k p : motion P p -> motion P (turn k p).
Proof.
  intros Hm. split.
  - intros t. unfold y1. rewrite sin_turn. apply Hm.
  - intros t. unfold y2. rewrite sin_turn. apply Hm.
  - intros t. unfold y1, y2. rewrite sin_turn. apply Hm.
  - intros t. destruct (law P p Hm t) as [v [v' [Hb [Ha H]]]]. exists v, v'. split; [now apply turn_before|].
    split; [now apply turn_after|].
    unfold push1, push2, y1, y2. rewrite sin_turn, cos_turn. exact H.
Qed.
Lemma collision_turn k p t : collision P p t -> collision P (turn k p) t.
Proof. intros [v [Hb H]]. exists v. split; [now apply turn_before|]. unfold y1, y2, w1, w2. rewrite sin_turn, cos_turn.
exact H. Qed.
Lemma whole_turns_up_to n : forall x, 0 <= x <= PI + 2 * INR n * PI -> exists k, - PI <= x - 2 * INR k * PI <= PI.
Proof.
  assert (HPI : 0 < PI) by apply PI_RGT_0. induction n as [|n IH]; intros x Hx.
  - exists O. simpl in *. lra.
  - destruct (Rle_or_lt x (PI + 2 * INR n * PI)); [apply IH; lra|]. exists (S n). rewrite S_INR in *. lra.
Qed.
Lemma whole_turns x : 0 <= x -> exists k, - PI <= x - 2 * INR k * PI <= PI.
Proof.
  intros Hx. destruct (nfloor_ex x Hx) as [n Hn]. apply (whole_turns_up_to n).
  assert (1 < PI/2) by exact PI2_1. assert (0 <= INR n) by apply pos_INR.
  assert (INR n * 1 <= INR n * PI) by (apply Rmult_le_compat_l; lra). lra.
Qed.

Lemma psi_mirror (p : R -> pos) t : psi_of (mirror p t) = - psi_of (p t).
Proof. unfold psi_of, mirror; simpl. lra. Qed.
Lemma collision_mirror p t : collision P p t -> collision P (mirror p) t.
Proof.
  intros [v [Hb H]]. exists (mirror_v v). split; [now apply mirror_before|]. unfold y1, y2, w1, w2, mirror in *; simpl.
  rewrite sin_mirror, cos_mirror.
  destruct H as [[A B]|[A B]]; [left | right]; (split; [lra|]); lra.
Qed.
Lemma pos_eq a b : height a = height b -> angle a = angle b -> a = b.
Proof. destruct a, b; simpl; congruence. Qed.
Lemma mirror_mirror p : mirror (mirror p) = p.
Proof. apply functional_extensionality. intros t. apply pos_eq; simpl; ring. Qed.
Lemma reverse_reverse p : reverse (reverse p) = p.
Proof. apply functional_extensionality. intros t. unfold reverse. now rewrite Ropp_involutive. Qed.
Lemma y2_mirror p t : y2 P (mirror p t) = y2 P (p t).
Proof. unfold y2, mirror; simpl. now rewrite sin_mirror. Qed.

(** A collision of the motion is one of the reversed motion. *)
Lemma v_of_minus v : v_of P (minus_v v) = - v_of P v.
Proof. unfold v_of, minus_v; simpl. field. assert (A := arm1_pos P HP); lra. Qed.
Theorem collision_reverse p T : motion P p -> collision P p T -> collision P (reverse p) (- T).
Proof.
  intros Hm Hc. destruct (collision_law P HP p T Hm Hc) as [v [v' [Hb [Ha HL]]]].
  exists (minus_v v'). split; [apply reverse_before; now rewrite Ropp_involutive|]. unfold reverse.
  rewrite Ropp_involutive.
  assert (A1 := arm1_pos P HP). assert (EA := r_arms P HP).
  destruct HL as [[H0 [l0 [_ [_ [_ [Er En]]]]]]|[H0 [l0 [_ [_ [_ [Er En]]]]]]]; [left | right]; (split; [exact H0|]).
  - unfold slope1 in *. rewrite sin_psi in *. unfold w1, u_of, v_of in *; simpl.
    assert (K : 0 < arm1 P * (vy v' / arm1 P - - cos (angle (p T)) * om v')) by (apply Rmult_lt_0_compat; lra).
    replace (arm1 P * (vy v' / arm1 P - - cos (angle (p T)) * om v')) with (vy v' + arm1 P * cos (angle (p T)) * om v')
      in K by (field; lra). lra.
  - unfold slope2 in *. rewrite sin_psi in *. unfold w2, u_of, v_of in *; simpl. rewrite EA.
    assert (K : 0 < arm1 P * (vy v' / arm1 P - - r * - cos (angle (p T)) * om v')) by (apply Rmult_lt_0_compat; lra).
    replace (arm1 P * (vy v' / arm1 P - - r * - cos (angle (p T)) * om v'))
      with (vy v' - r * arm1 P * cos (angle (p T)) * om v') in K by (field; lra). lra.
Qed.
Lemma collision_unreverse p T : motion P p -> collision P (reverse p) T -> collision P p (- T).
Proof. intros Hm Hc. rewrite <- (reverse_reverse p). apply collision_reverse; [now apply reverse_motion | exact Hc].
Qed.
Lemma no_heavy_reverse p : motion P p -> no_heavy P p -> no_heavy P (reverse p).
Proof. intros Hm Hn t Hc. exact (Hn (- t) (collision_unreverse p t Hm Hc)). Qed.

(** p and q are the same motion seen from another side. *)
Record same (p q : R -> pos) : Prop := {
  same_motion : motion P p -> motion P q;
  same_collision : forall t, collision P p t -> collision P q t;
  same_collision_back : forall t, collision P q t -> collision P p t;
  same_y2 : forall t, y2 P (q t) = y2 P (p t);
  same_before : forall t v, before p t v -> exists w, before q t w /\ vy w = vy v;
  same_after : forall t v, after p t v -> exists w, after q t w /\ vy w = vy v }.
Lemma same_trans p q s : same p q -> same q s -> same p s.
Proof.
  intros [A1 A2 A3 A4 A6 A5] [B1 B2 B3 B4 B6 B5]. split; auto.
  - intros t. now rewrite B4.
  - intros t v H. destruct (A6 t v H) as [w [H1 E1]]. destruct (B6 t w H1) as [w' [H2 E2]]. exists w'.
    split; [exact H2 | congruence].
  - intros t v H. destruct (A5 t v H) as [w [H1 E1]]. destruct (B5 t w H1) as [w' [H2 E2]]. exists w'.
    split; [exact H2 | congruence].
Qed.
Lemma same_mirror p : same p (mirror p).
Proof.
  split.
  - apply mirror_motion.
  - intros t. apply collision_mirror.
  - intros t H. rewrite <- (mirror_mirror p). now apply collision_mirror.
  - intros t. apply y2_mirror.
  - intros t v H. exists (mirror_v v). split; [now apply mirror_before | reflexivity].
  - intros t v H. exists (mirror_v v). split; [now apply mirror_after | reflexivity].
Qed.
Lemma collision_unturn k p t : collision P (turn k p) t -> collision P p t.
Proof.
  intros [v [Hb H]]. exists v. split.
  - destruct Hb as [e [He Hb]]. exists e. split; [exact He|]. intros s Hs. destruct (Hb s Hs) as [B1 B2].
    simpl in *. split; lra.
  - unfold y1, y2, w1, w2 in *. rewrite sin_turn, cos_turn in H. exact H.
Qed.
Lemma same_turn k p : same p (turn k p).
Proof.
  split.
  - apply turn_motion.
  - intros t. apply collision_turn.
  - intros t. apply collision_unturn.
  - intros t. unfold y2. now rewrite sin_turn.
  - intros t v H. exists v. split; [now apply turn_before | reflexivity].
  - intros t v H. exists v. split; [now apply turn_after | reflexivity].
Qed.
Lemma same_no_heavy p q : same p q -> no_heavy P p -> no_heavy P q.
Proof. intros S Hn t Hc. rewrite (same_y2 _ _ S). apply Hn. now apply (same_collision_back _ _ S). Qed.
Lemma same_later p q t n : same p q -> later P p t n -> later P q t n.
Proof. intros S [l [H1 [H2 H3]]]. exists l. split; [exact H1|]. split; [exact H2|]. intros s Hs. destruct (H3 s Hs).
split; [assumption | now apply (same_collision _ _ S)]. Qed.
Lemma same_at_most p q n : same p q -> at_most P q n -> at_most P p n.
Proof. intros S H l Hnd Hl. apply H; [assumption|]. intros t Ht. apply (same_collision _ _ S), Hl, Ht. Qed.
Lemma later_mirror p t n : later P p t n -> later P (mirror p) t n.
Proof. apply same_later, same_mirror. Qed.
End Symmetry.
