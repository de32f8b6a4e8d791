(** The normal position of a collision of the light mass: seen from a suitable side it is on the wall R, at psi = pi/2 +
    e with 0 < e <= pi/2 (the "up to the mirror and whole turns" of L9). *)
From Coq Require Import Reals Lra Lia List FunctionalExtensionality.
From Dumbbell Require Import Physics Flight Collisions Symmetry.
Local Open Scope R_scope.

Section NormalPosition.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.
Notation r := (r_of P).
Notation yh := (yhat_of P).

(** The normal position. *)
Definition on_R (p : R -> pos) T e := psi_of (p T) = PI/2 + e /\ 0 < e <= PI/2 /\ yh (p T) = sin e.
Lemma normal_right p T : motion P p -> no_heavy P p -> collision P p T -> 0 <= psi_of (p T) <= PI ->
  exists e, on_R p T e.
Proof.
  intros Hm Hn Hc Hp. assert (R0 := r_pos P HP). assert (A1 := arm1_pos P HP).
  assert (H2 : 0 < y2 P (p T)). { destruct (above2 P p Hm T) as [|E]; [assumption|]. exfalso. now apply (Hn T Hc). }
  assert (H1 : y1 P (p T) = 0). { destruct Hc as [v [_ [[H _]|[H _]]]]; [exact H | lra]. }
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
Theorem normal_position p T : motion P p -> no_heavy P p -> collision P p T -> exists q e, same P p q /\ on_R q T e.
Proof.
  assert (HPI : 0 < PI) by apply PI_RGT_0.
  assert (Pos : forall p, motion P p -> no_heavy P p -> collision P p T -> 0 <= psi_of (p T) ->
    exists q e, same P p q /\ on_R q T e).
  { clear p. intros p Hm Hn Hc Hp. destruct (whole_turns _ Hp) as [k Hk].
    assert (S := same_turn P k p). set (q := turn k p) in *.
    assert (Eq : psi_of (q T) = psi_of (p T) - 2 * INR k * PI) by (unfold psi_of, q; simpl; ring).
    assert (Hq := same_motion P _ _ S Hm). assert (Nq := same_no_heavy P _ _ S Hn).
    assert (Cq := same_collision P _ _ S T Hc).
    destruct (Rle_or_lt 0 (psi_of (q T))) as [K|K].
    - destruct (normal_right q T Hq Nq Cq ltac:(lra)) as [e He]. now exists q, e.
    - assert (S2 := same_mirror P q). destruct (normal_right (mirror q) T) as [e He].
      + now apply mirror_motion. + now apply (same_no_heavy P _ _ S2). + now apply collision_mirror.
        + rewrite psi_mirror; lra.
      + exists (mirror q), e. split; [now apply same_trans with q | exact He]. }
  intros Hm Hn Hc. destruct (Rle_or_lt 0 (psi_of (p T))) as [K|K]; [now apply Pos|].
  assert (S := same_mirror P p). destruct (Pos (mirror p)) as [q [e [S2 He]]].
  - now apply mirror_motion. - now apply (same_no_heavy P _ _ S). - now apply collision_mirror.
    - rewrite psi_mirror; lra.
  - exists q, e. split; [now apply same_trans with (mirror p) | exact He].
Qed.
End NormalPosition.
