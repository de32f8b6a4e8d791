(** With corners, every state has a motion for all times: one that runs into a corner goes back the way it came, as
    the motions near it do (L40 (b)). So nothing in `AnyMotion.through_at_most` is empty, and no state is left out. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics Symmetry Existence.
From Dumbbell Require Import Stretch Stretches ThroughCorner AnyMotion.
Local Open Scope R_scope.

(** Until T the path p, at T in s, and then p backwards. *)
Definition back_at T s (p : R -> pos) t :=
  if Rlt_dec t T then p t else if Rlt_dec T t then shift (2 * T) (reverse p) t else s.
Section Back.
Variable P : dumbbell.
Variables (T : R) (s : pos) (p : R -> pos).
Notation f := (back_at T s p).
Lemma back_before t : t < T -> f t = p t.
Proof. intros H. unfold back_at. destruct (Rlt_dec t T); [reflexivity | lra]. Qed.
Lemma back_after t : T < t -> f t = p (2 * T - t).
Proof.
  intros H. unfold back_at. destruct (Rlt_dec t T); [lra|]. destruct (Rlt_dec T t); [|lra]. unfold shift, reverse.
  f_equal. ring.
Qed.
Lemma back_there : f T = s.
Proof. unfold back_at. destruct (Rlt_dec T T); [lra | reflexivity]. Qed.
Theorem back_motion : motion_within P m_infty T p -> both_down P s -> flies_to p T s ->
  motion_through P m_infty p_infty f.
Proof.
  intros Hm Hs [v [e [He Hf]]] t _. destruct (Rtotal_order t T) as [L|[->|L]].
  - left. apply (near_lawful P p); [|apply Hm; now split]. exists ((T - t) / 2). split; [lra|]. intros x Hx.
    symmetry. apply back_before. lra.
  - right. unfold turns_in_corner. rewrite back_there. split; [exact Hs|]. exists v, (minus_v v).
    split; [|split; [|unfold energy; simpl; lra]]; exists (e / 2); (split; [lra|]); intros x Hx; rewrite back_there;
      (destruct (Req_dec x T) as [->|N]; [rewrite back_there; split; ring|]).
    + rewrite back_before by lra. apply Hf. lra.
    + rewrite back_after by lra. destruct (Hf (2 * T - x) ltac:(lra)) as [A B]. rewrite A, B. simpl. split; ring.
  - left. apply (near_lawful P (shift (2 * T) (reverse p))).
    + exists ((t - T) / 2). split; [lra|]. intros x Hx. rewrite back_after by lra. unfold shift, reverse. f_equal. ring.
    + apply shift_lawful, reverse_lawful, Hm. split; simpl; [exact I | lra].
Qed.
End Back.

(** Until the corner it is the given motion. *)
Lemma on_for_ever P b p v : Rbar_lt 0 b -> motion_within P m_infty b p -> ends_in_corner P p b -> before p 0 v ->
  after p 0 v ->
  exists f, motion_through P m_infty p_infty f /\ f 0 = p 0 /\ before f 0 v /\ after f 0 v.
Proof.
  intros H0 Hm [T [s [-> [C F]]]] B A. simpl in H0. exists (back_at T s p). split; [now apply back_motion|].
  assert (N : near p (back_at T s p) 0) by (exists (T / 2); split; [lra|]; intros x Hx; symmetry; apply back_before;
    lra).
  split; [symmetry; now apply near_at|]. split; [now apply (near_before p) | now apply (near_after p)].
Qed.
Lemma goes_on_for_ever P s v : real_dumbbell P -> 0 < y1 P s -> 0 < y2 P s ->
  exists p, motion_through P m_infty p_infty p /\ p 0 = s /\ before p 0 v /\ after p 0 v.
Proof.
  intros HP H1 H2. destruct (whole_motion P s v HP H1 H2) as [a [b [p [H0 [[Hm [He Hb]] [E [B [A [Hc _]]]]]]]]].
  destruct He as [->|He]; [destruct Hb as [->|Hb]|].
  - exists p. split; [|now repeat split]. intros t Ht. left. now apply Hm.
  - assert (H0' := within_reverse a p_infty 0 H0). rewrite Ropp_0 in H0'. destruct H0' as [_ H0'].
    destruct (on_for_ever P (Rbar_opp a) (reverse p) (minus_v v) H0') as [f [F1 [F2 [F3 F4]]]].
    + now apply motion_reverse in Hm. + now apply ends_reverse.
    + apply reverse_before. now rewrite Ropp_0. + apply reverse_after. now rewrite Ropp_0.
    + exists (reverse f). split; [exact (through_reverse P m_infty p_infty f F1)|].
      unfold reverse at 1. rewrite Ropp_0, F2. split; [unfold reverse; now rewrite Ropp_0|].
      assert (Ev : minus_v (minus_v v) = v) by (apply vel_eq; simpl; ring). rewrite <- Ev.
      split; [apply reverse_before | apply reverse_after]; now rewrite Ropp_0.
  - destruct Hc as [->| ->]; [|destruct He as [T [s' [K _]]]; discriminate].
    rewrite <- E. apply (on_for_ever P b p v); try assumption. apply H0.
Qed.

(** **Every state in flight has a motion for all times**, through a corner if need be, of N(q) collisions at most. *)
Theorem state_for_ever P s v : real_dumbbell P -> 0 < y1 P s -> 0 < y2 P s ->
  exists p, motion_through P m_infty p_infty p /\ p 0 = s /\ before p 0 v /\ after p 0 v /\
    forall U, upper_bound (m2 P / m1 P) U -> at_most P p U.
Proof.
  intros HP H1 H2. destruct (goes_on_for_ever P s v HP H1 H2) as [p [Hm [E [B A]]]]. exists p.
  repeat (split; [assumption|]).
  intros U HU l Hnd Hl. apply (through_at_most P m_infty p_infty p U HP HU Hm l Hnd). intros t Ht.
  split; [now split | now apply Hl].
Qed.

(** There are motions into a corner: the rod is horizontal and comes down. *)
Theorem corner_is_reached P : real_dumbbell P -> exists p, motion_within P m_infty 0 p /\ ends_in_corner P p 0.
Proof.
  intros HP. set (s := {| height := 0; angle := 0 |}). set (v := {| vy := -1; om := 0 |}).
  assert (Y : forall t, y1 P (line s v t) = - t /\ y2 P (line s v t) = - t).
  { intros t. unfold y1, y2. simpl. replace (0 + 0 * t) with 0 by ring. rewrite sin_0. split; ring. }
  exists (line s v). split.
  - intros t [_ Ht]. simpl in Ht. destruct (Y t) as [E1 E2]. unfold obeys. rewrite E1, E2. repeat split; try lra.
    exists v, v. split; [apply line_before|]. split; [apply line_after | now left].
  - exists 0, s. split; [reflexivity|]. destruct (Y 0) as [E1 E2]. rewrite line_0 in E1, E2. split; [split; lra|].
    exists v, 1. split; [lra|]. intros t _. simpl. split; ring.
Qed.
