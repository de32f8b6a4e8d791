(** Symmetries of motions (mirror, turning by 2 k pi, reversal) as relations, and the normal position of a collision of the
    light mass: on the wall R, psi = pi/2 + e with 0 < e <= pi/2. *)
From Coq Require Import Reals Lra Lia List FunctionalExtensionality.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics Ray Flight Collisions Follow HeavyTotal.
Local Open Scope R_scope.

Section Sym.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.
Notation r := (r_of P).
Notation yh := (yhat_of P).

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
  exists (minus_v v'). split; [apply reverse_before; now rewrite Ropp_involutive|]. unfold reverse. rewrite Ropp_involutive.
  assert (A1 := arm1_pos P HP). assert (EA := r_arms P HP).
  destruct HL as [[H0 [l0 [_ [_ [_ [Er En]]]]]]|[H0 [l0 [_ [_ [_ [Er En]]]]]]]; [left | right]; (split; [exact H0|]).
  - unfold slope1 in *. rewrite sin_psi in *. unfold w1, u_of, v_of in *; simpl.
    assert (K : 0 < arm1 P * (vy v' / arm1 P - - cos (angle (p T)) * om v')) by (apply Rmult_lt_0_compat; lra).
    replace (arm1 P * (vy v' / arm1 P - - cos (angle (p T)) * om v')) with (vy v' + arm1 P * cos (angle (p T)) * om v') in K by (field; lra). lra.
  - unfold slope2 in *. rewrite sin_psi in *. unfold w2, u_of, v_of in *; simpl. rewrite EA.
    assert (K : 0 < arm1 P * (vy v' / arm1 P - - r * - cos (angle (p T)) * om v')) by (apply Rmult_lt_0_compat; lra).
    replace (arm1 P * (vy v' / arm1 P - - r * - cos (angle (p T)) * om v')) with (vy v' - r * arm1 P * cos (angle (p T)) * om v') in K by (field; lra). lra.
Qed.
Lemma collision_unreverse p T : motion P p -> collision P (reverse p) T -> collision P p (- T).
Proof. intros Hm Hc. rewrite <- (reverse_reverse p). apply collision_reverse; [now apply reverse_motion | exact Hc]. Qed.
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
  - intros t v H. destruct (A6 t v H) as [w [H1 E1]]. destruct (B6 t w H1) as [w' [H2 E2]]. exists w'. split; [exact H2 | congruence].
  - intros t v H. destruct (A5 t v H) as [w [H1 E1]]. destruct (B5 t w H1) as [w' [H2 E2]]. exists w'. split; [exact H2 | congruence].
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
  - destruct Hb as [e [He Hb]]. exists e. split; [exact He|]. intros s Hs. destruct (Hb s Hs) as [B1 B2]. simpl in *. split; lra.
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
Proof. intros S [l [H1 [H2 H3]]]. exists l. split; [exact H1|]. split; [exact H2|]. intros s Hs. destruct (H3 s Hs). split; [assumption | now apply (same_collision _ _ S)]. Qed.
Lemma same_at_most p q n : same p q -> at_most P q n -> at_most P p n.
Proof. intros S H l Hnd Hl. apply H; [assumption|]. intros t Ht. apply (same_collision _ _ S), Hl, Ht. Qed.

(** The normal position. *)
Definition on_R (p : R -> pos) T e := psi_of (p T) = PI/2 + e /\ 0 < e <= PI/2 /\ yh (p T) = sin e.
Lemma normal_right p T : motion P p -> no_heavy P p -> collision P p T -> 0 <= psi_of (p T) <= PI -> exists e, on_R p T e.
Proof.
  intros Hm Hn Hc Hp. assert (R0 := r_pos P HP). assert (A1 := arm1_pos P HP).
  assert (H2 : 0 < y2 P (p T)). { destruct (above2 P p Hm T) as [|E]; [assumption|]. exfalso. now apply (Hn T Hc). }
  assert (H1 : y1 P (p T) = 0). { destruct Hc as [v [_ [[H _]|[H _]]]]; [exact H | lra]. }
  assert (C := contact1 P HP p T H1). destruct (L0_heights P (p T) HP) as [_ E2]. rewrite E2, C in H2. fold r in H2. unfold r_of in *.
  assert (Cn : cos (psi_of (p T)) < 0).
  { apply Rnot_le_lt. intros K. assert (0 <= m1 P / m2 P * cos (psi_of (p T))) by (apply Rmult_le_pos; lra).
    assert (arm1 P * (- cos (psi_of (p T)) - m1 P / m2 P * cos (psi_of (p T))) <= 0); [|lra].
    assert (0 <= arm1 P * (cos (psi_of (p T)) + m1 P / m2 P * cos (psi_of (p T)))) by (apply Rmult_le_pos; lra). lra. }
  assert (K : PI/2 < psi_of (p T)). { apply Rnot_le_lt. intros K. assert (0 <= cos (psi_of (p T))) by (apply cos_ge_0; lra). lra. }
  exists (psi_of (p T) - PI/2). split; [ring|]. split; [lra|]. rewrite C, sin_minus, cos_PI2, sin_PI2. ring.
Qed.
Theorem normal_position p T : motion P p -> no_heavy P p -> collision P p T -> exists q e, same p q /\ on_R q T e.
Proof.
  assert (HPI : 0 < PI) by apply PI_RGT_0.
  assert (Pos : forall p, motion P p -> no_heavy P p -> collision P p T -> 0 <= psi_of (p T) -> exists q e, same p q /\ on_R q T e).
  { clear p. intros p Hm Hn Hc Hp. destruct (nfloor_ex (psi_of (p T)) Hp) as [n Hf].
    destruct (whole_turns n (psi_of (p T))) as [k Hk].
    { assert (1 < PI/2) by exact PI2_1. assert (0 <= INR n) by apply pos_INR. assert (INR n * 1 <= INR n * PI) by (apply Rmult_le_compat_l; lra). lra. }
    assert (S := same_turn k p). set (q := turn k p) in *. assert (Eq : psi_of (q T) = psi_of (p T) - 2 * INR k * PI) by (unfold psi_of, q; simpl; ring).
    assert (Hq := same_motion _ _ S Hm). assert (Nq := same_no_heavy _ _ S Hn). assert (Cq := same_collision _ _ S T Hc).
    destruct (Rle_or_lt 0 (psi_of (q T))) as [K|K].
    - destruct (normal_right q T Hq Nq Cq ltac:(lra)) as [e He]. now exists q, e.
    - assert (S2 := same_mirror q). destruct (normal_right (mirror q) T) as [e He].
      + now apply mirror_motion. + now apply (same_no_heavy _ _ S2). + now apply collision_mirror. + rewrite psi_mirror; lra.
      + exists (mirror q), e. split; [now apply same_trans with q | exact He]. }
  intros Hm Hn Hc. destruct (Rle_or_lt 0 (psi_of (p T))) as [K|K]; [now apply Pos|].
  assert (S := same_mirror p). destruct (Pos (mirror p)) as [q [e [S2 He]]].
  - now apply mirror_motion. - now apply (same_no_heavy _ _ S). - now apply collision_mirror. - rewrite psi_mirror; lra.
  - exists q, e. split; [now apply same_trans with (mirror p) | exact He].
Qed.
End Sym.
