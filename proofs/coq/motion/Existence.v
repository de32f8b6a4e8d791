(** What a motion is built of: the law at one time (`lawful`), paths that agree near a time, shifted, mirrored, reversed
    and glued paths, a free flight (`line`), and that the floor has an answer to every mass that comes in. The
    definition of a trajectory in claim.md; L0.

    lawful p t                        == the law at the time t; lawful_motion: everywhere, and the path is a motion
    near, near_lawful, near_collision == paths that agree near a time
    shift, glue                       == a path later; one path up to T and another from then on
    line, free                        == the free flight out of a state; a state above the floor
    push_exists                       == the floor has an answer to every mass that comes in *)
From Coq Require Import Reals Lra Lia List FunctionalExtensionality.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics Flight Symmetry.
Local Open Scope R_scope.

Section Exists.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.
Hypothesis Hr1 : r_of P <= 1.
Notation r := (r_of P).
Notation yh := (yhat_of P).

(* ---------- motions are local ---------- *)
Definition lawful (p : R -> pos) t := 0 <= y1 P (p t) /\ 0 <= y2 P (p t) /\ ~ (y1 P (p t) = 0 /\ y2 P (p t) = 0) /\
  exists v v', before p t v /\ after p t v' /\
    (v' = v \/ (y1 P (p t) = 0 /\ push1 P (p t) v v') \/ (y2 P (p t) = 0 /\ push2 P (p t) v v')).
Lemma lawful_motion p : (forall t, lawful p t) -> motion P p.
Proof. intros H. split; intros t; destruct (H t) as [A [B [C D]]]; assumption. Qed.

Definition near (p q : R -> pos) t := exists d, 0 < d /\ forall s, t - d <= s <= t + d -> p s = q s.
Lemma near_at p q t : near p q t -> p t = q t.
Proof. intros [d [Hd H]]. apply H. lra. Qed.
Lemma near_before p q t v : near p q t -> before p t v -> before q t v.
Proof.
  intros [d [Hd H]] [e [He K]]. exists (Rmin d e). assert (Rmin d e <= d) by apply Rmin_l.
  assert (Rmin d e <= e) by apply Rmin_r.
  split; [now apply Rmin_pos|]. intros s Hs. rewrite <- (H s), <- (H t) by lra. apply K. lra.
Qed.
Lemma near_after p q t v : near p q t -> after p t v -> after q t v.
Proof.
  intros [d [Hd H]] [e [He K]]. exists (Rmin d e). assert (Rmin d e <= d) by apply Rmin_l.
  assert (Rmin d e <= e) by apply Rmin_r.
  split; [now apply Rmin_pos|]. intros s Hs. rewrite <- (H s), <- (H t) by lra. apply K. lra.
Qed.
Lemma near_lawful p q t : near p q t -> lawful p t -> lawful q t.
Proof.
  intros N [A [B [C [v [v' [D [E F]]]]]]]. unfold lawful. rewrite <- (near_at p q t N). repeat split; try assumption.
  exists v, v'. split; [now apply (near_before p)|]. split; [now apply (near_after p) | exact F].
Qed.
Lemma near_collision p q t : near p q t -> collision P p t -> collision P q t.
Proof. intros N [v [A B]]. exists v. rewrite <- (near_at p q t N). split; [now apply (near_before p) | exact B]. Qed.

Definition shift T (p : R -> pos) t := p (t - T).
Lemma shift_before T p t v : before p (t - T) v -> before (shift T p) t v.
Proof. intros [e [He H]]. exists e. split; [exact He|]. intros s Hs. unfold shift.
replace (s - t) with (s - T - (t - T)) by ring. apply H. lra. Qed.
Lemma shift_after T p t v : after p (t - T) v -> after (shift T p) t v.
Proof. intros [e [He H]]. exists e. split; [exact He|]. intros s Hs. unfold shift.
replace (s - t) with (s - T - (t - T)) by ring. apply H. lra. Qed.
Lemma shift_lawful T p t : lawful p (t - T) -> lawful (shift T p) t.
Proof. intros [A [B [C [v [v' [D [E F]]]]]]]. repeat split; try assumption. exists v, v'.
split; [now apply shift_before|]. split; [now apply shift_after | exact F]. Qed.
Lemma shift_collision T p t : collision P p (t - T) -> collision P (shift T p) t.
Proof. intros [v [A B]]. exists v. split; [now apply shift_before | exact B]. Qed.

Lemma mirror_lawful p t : lawful p t -> lawful (mirror p) t.
Proof.
  intros [A [B [C [v [v' [D [E F]]]]]]]. unfold lawful, push1, push2, y1, y2 in *.
  replace (sin (angle (mirror p t))) with (sin (angle (p t))) by (unfold mirror; simpl; now rewrite sin_mirror).
  replace (cos (angle (mirror p t))) with (- cos (angle (p t))) by (unfold mirror; simpl; now rewrite cos_mirror).
  change (height (mirror p t)) with (height (p t)). repeat split; try assumption.
  exists (mirror_v v), (mirror_v v'). split; [now apply mirror_before|]. split; [now apply mirror_after|].
  destruct F as [->|[[H0 H]|[H0 H]]]; [now left | right; left | right; right]; (split; [exact H0|]).
  - replace (arm1 P * - cos (angle (p t))) with (- (arm1 P * cos (angle (p t)))) by ring. now apply mirror_push.
  - replace (- (arm2 P * - cos (angle (p t)))) with (- - (arm2 P * cos (angle (p t)))) by ring. now apply mirror_push.
Qed.
Lemma reverse_lawful p t : lawful p (- t) -> lawful (reverse p) t.
Proof.
  intros [A [B [C [v [v' [D [E F]]]]]]]. repeat split; try assumption. exists (minus_v v'), (minus_v v).
  split; [now apply reverse_before|]. split; [now apply reverse_after|].
  destruct F as [->|[[H0 H]|[H0 H]]]; [now left | right; left | right; right]; (split; [exact H0|]);
    now apply reverse_push.
Qed.

(** p1 until T, then p2, which starts at its time 0. *)
Definition glue T (p1 p2 : R -> pos) t := if Rle_dec t T then p1 t else p2 (t - T).
Lemma glue_left T p1 p2 t : t < T -> near p1 (glue T p1 p2) t.
Proof. intros Ht. exists (T - t). split; [lra|]. intros s Hs. unfold glue.
destruct (Rle_dec s T); [reflexivity | lra]. Qed.
Lemma glue_right T p1 p2 t : T < t -> near (shift T p2) (glue T p1 p2) t.
Proof. intros Ht. exists ((t - T) / 2). split; [lra|]. intros s Hs. unfold glue.
destruct (Rle_dec s T); [lra | reflexivity]. Qed.
Lemma glue_at T p1 p2 : glue T p1 p2 T = p1 T.
Proof. unfold glue. destruct (Rle_dec T T); [reflexivity | lra]. Qed.
Lemma glue_before T p1 p2 v : before p1 T v -> before (glue T p1 p2) T v.
Proof. intros [e [He H]]. exists e. split; [exact He|]. intros s Hs. rewrite glue_at. unfold glue.
destruct (Rle_dec s T); [now apply H | lra]. Qed.
Lemma glue_after T p1 p2 v : p2 0 = p1 T -> after p2 0 v -> after (glue T p1 p2) T v.
Proof.
  intros E [e [He H]]. exists e. split; [exact He|]. intros s Hs. rewrite glue_at. unfold glue.
  destruct (Rle_dec s T) as [L|L].
  - replace s with T by lra. split; ring.
  - destruct (H (s - T) ltac:(lra)) as [A B]. rewrite E in *. split; [rewrite A | rewrite B]; ring.
Qed.

(* ---------- flights ---------- *)
Definition line (s0 : pos) (v : vel) t := {| height := height s0 + vy v * t; angle := angle s0 + om v * t |}.
Lemma line_0 s0 v : line s0 v 0 = s0.
Proof. apply pos_eq; simpl; ring. Qed.
Lemma line_before s0 v t : before (line s0 v) t v.
Proof. exists 1. split; [lra|]. intros s _. simpl. split; ring. Qed.
Lemma line_after s0 v t : after (line s0 v) t v.
Proof. exists 1. split; [lra|]. intros s _. simpl. split; ring. Qed.
Lemma line_psi s0 v t : psi_of (line s0 v t) = psi_of s0 + u_of v * t.
Proof. unfold psi_of, u_of; simpl. ring. Qed.
Lemma line_yh s0 v t : yh (line s0 v t) = yh s0 + v_of P v * t.
Proof. unfold yhat_of, v_of; simpl. field. assert (A := arm1_pos P HP); lra. Qed.

(** Above the floor curve, at a positive height. *)
Definition free (s : pos) := 0 < yh s /\ - cos (psi_of s) <= yh s /\ r * cos (psi_of s) <= yh s.
Lemma free_above s : free s -> 0 <= y1 P s /\ 0 <= y2 P s /\ ~ (y1 P s = 0 /\ y2 P s = 0).
Proof.
  intros [A [B C]]. assert (A1 := arm1_pos P HP). assert (R0 := r_pos P HP). destruct (L0_heights P s HP) as [E1 E2].
  fold (r_of P) in E2.
  rewrite E1, E2. split; [apply Rmult_le_pos; lra|]. split; [apply Rmult_le_pos; lra|]. intros [K1 K2].
  apply Rmult_integral in K1. apply Rmult_integral in K2. assert (K1' : cos (psi_of s) = - yh s) by lra.
  assert (r * yh s = - yh s) by (rewrite K1' in K2; lra). assert (0 < r * yh s) by (now apply Rmult_lt_0_compat). lra.
Qed.
Lemma line_lawful s0 v t : free (line s0 v t) -> lawful (line s0 v) t.
Proof. intros H. destruct (free_above _ H) as [A [B C]]. repeat split; try assumption. exists v, v.
split; [apply line_before|]. split; [apply line_after | now left]. Qed.

(** The floor answers: a push that turns the mass. *)
Lemma push_exists lever v : vy v + lever * om v < 0 -> exists v', push P lever v v' /\ v' <> v.
Proof.
  intros Hw. assert (HM := mass_pos P HP). assert (HI := inertia_pos P HP).
  set (S := / mass P + lever * lever * / inertia P).
  assert (HS : 0 < S).
  { unfold S. assert (0 < / mass P) by (now apply Rinv_0_lt_compat).
    assert (0 <= lever * lever * / inertia P)
      by (apply Rmult_le_pos; [apply Rle_0_sqr | left; now apply Rinv_0_lt_compat]). lra. }
  set (J := - 2 * (vy v + lever * om v) / S). assert (HJ : 0 < J) by (apply Rdiv_lt_0_compat; lra).
  assert (EJ : J * S = - 2 * (vy v + lever * om v)) by (unfold J; field; lra).
  exists {| vy := vy v + J / mass P; om := om v + J * lever / inertia P |}. split.
  - exists J. simpl. repeat split; try lra; try (field; lra).
    unfold energy; simpl.
    assert (K : mass P * ((vy v + J / mass P) * (vy v + J / mass P)) + inertia P *
      ((om v + J * lever / inertia P) * (om v + J * lever / inertia P))
      = mass P * (vy v * vy v) + inertia P * (om v * om v) + J * (2 * (vy v + lever * om v) + J * S))
        by (unfold S; field; lra).
    rewrite K, EJ. field.
  - intros E. assert (E2 : vy v + J / mass P = vy v) by (now rewrite <- E at 2).
    assert (0 < J / mass P) by (now apply Rdiv_lt_0_compat). lra.
Qed.
End Exists.
