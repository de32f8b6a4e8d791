(** The normal position of a collision of the light mass: seen from a suitable side it is on the wall R, at psi = pi/2 +
    e with 0 < e <= pi/2 (the "up to the mirror and whole turns" of L9).

    on_R                                   == a contact of the light mass on the wall R, at psi = pi/2 + e
    normal_position, heavy_normal_position == any collision is one, from a suitable side; of the heavy mass, too
    cell_position                          == psi in [0, pi], seen from a suitable side *)
From Coq Require Import Reals Lra Lia List FunctionalExtensionality.
From Dumbbell Require Import Physics Flight Collisions Symmetry.
Local Open Scope R_scope.

Section NormalPosition.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.
Notation r := (r_of P).
Notation yh := (yhat_of P).

(** The normal position. *)
(** Every time of a motion, seen from a suitable side, has psi in [0, pi]. *)
Lemma cell_position p T : exists q, same P p q /\ 0 <= psi_of (q T) <= PI.
Proof.
  assert (Pos : forall p, 0 <= psi_of (p T) -> exists q, same P p q /\ 0 <= psi_of (q T) <= PI).
  { clear p. intros p Hp. destruct (whole_turns _ Hp) as [k Hk].
    assert (E : psi_of (turn k p T) = psi_of (p T) - 2 * INR k * PI) by (unfold psi_of; simpl; ring).
    assert (S := same_turn P k p). destruct (Rle_or_lt 0 (psi_of (turn k p T))) as [K|K].
    - exists (turn k p). split; [exact S | lra].
    - exists (mirror (turn k p)). split; [now apply same_trans with (turn k p); [|apply same_mirror]|].
      rewrite psi_mirror. lra. }
  destruct (Rle_or_lt 0 (psi_of (p T))) as [K|K]; [now apply Pos|].
  destruct (Pos (mirror p)) as [q [S Hq]]; [rewrite psi_mirror; lra|].
  exists q. split; [|exact Hq]. now apply same_trans with (mirror p); [apply same_mirror|].
Qed.

Definition on_R (p : R -> pos) T e := psi_of (p T) = PI/2 + e /\ 0 < e <= PI/2 /\ yh (p T) = sin e.
Lemma light_right p T : motion P p -> y1 P (p T) = 0 -> 0 <= psi_of (p T) <= PI -> exists e, on_R p T e.
Proof.
  intros Hm H1 Hp. assert (R0 := r_pos P HP). assert (A1 := arm1_pos P HP).
  assert (H2 : 0 < y2 P (p T)). { destruct (above2 P p Hm T) as [|E]; [assumption|]. exfalso.
    apply (regular P p Hm T). now split. }
  assert (C := contact1 P HP p T H1). destruct (L0_heights P (p T) HP) as [_ E2]. rewrite E2, C in H2. fold r in H2.
  unfold r_of in *.
  assert (Cn : cos (psi_of (p T)) < 0).
  { apply Rnot_le_lt. intros K. assert (0 <= m1 P / m2 P * cos (psi_of (p T))) by (apply Rmult_le_pos; lra).
    assert (arm1 P * (- cos (psi_of (p T)) - m1 P / m2 P * cos (psi_of (p T))) <= 0); [|lra].
    assert (0 <= arm1 P * (cos (psi_of (p T)) + m1 P / m2 P * cos (psi_of (p T)))) by (apply Rmult_le_pos; lra). lra. }
  assert (K : PI/2 < psi_of (p T)). { apply Rnot_le_lt. intros K.
    assert (0 <= cos (psi_of (p T))) by (apply cos_ge_0; lra). lra. }
  exists (psi_of (p T) - PI/2). split; [ring|]. split; [lra|]. rewrite C, sin_minus, cos_PI2, sin_PI2. ring.
Qed.
Lemma normal_right p T : motion P p -> no_heavy P p -> collision P p T -> 0 <= psi_of (p T) <= PI ->
  exists e, on_R p T e.
Proof.
  intros Hm Hn Hc Hp. apply (light_right p T Hm); [|exact Hp].
  destruct Hc as [v [Hb [[H _]|[H Hw]]]]; [exact H|exfalso]. apply (Hn T); [|exact H]. exists v. split; [exact Hb|].
  right. now split.
Qed.
Theorem normal_position p T : motion P p -> no_heavy P p -> collision P p T -> exists q e, same P p q /\ on_R q T e.
Proof.
  intros Hm Hn Hc. destruct (cell_position p T) as [q [S Hq]].
  destruct (normal_right q T (same_motion _ _ _ S Hm) (same_no_heavy _ _ _ S Hn) (same_collision _ _ _ S T Hc) Hq)
    as [e He].
  now exists q, e.
Qed.

(** A contact of the heavy mass, seen from a suitable side, is at psi = pi/2 - e (the "mirror" of L8). *)
Theorem heavy_normal_position p T : motion P p -> y2 P (p T) = 0 ->
  exists q e, same P p q /\ psi_of (q T) = PI/2 - e /\ 0 < e <= PI/2.
Proof.
  intros Hm H0. destruct (cell_position p T) as [q [S Hq]]. assert (R0 := r_pos P HP). assert (A1 := arm1_pos P HP).
  assert (H2 : y2 P (q T) = 0) by (now rewrite (same_y2 _ _ _ S)). assert (C := contact2 P HP q T H2).
  assert (F := floor1 P HP q T (same_motion _ _ _ S Hm)). exists q, (PI/2 - psi_of (q T)). split; [exact S|].
  split; [ring|]. assert (Hc : 0 < cos (psi_of (q T))).
  { apply Rnot_le_lt. intros K. assert (E : cos (psi_of (q T)) = 0).
    { apply Rle_antisym; [exact K|]. apply Rnot_lt_le. intros L.
      assert (0 < r * - cos (psi_of (q T))) by (apply Rmult_lt_0_compat; lra). lra. }
    apply (regular P q (same_motion _ _ _ S Hm) T). split; [|exact H2]. destruct (L0_heights P (q T) HP) as [E1 _].
    rewrite E1, C, E. ring. }
  split; [|lra]. apply Rnot_le_lt. intros K. assert (cos (psi_of (q T)) <= 0) by (apply cos_le_0; lra). lra.
Qed.
End NormalPosition.
