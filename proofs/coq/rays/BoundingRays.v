(** L15 (a) to (c), one step of the lowest and of the highest ray: bounds of a state's x and k bound its flight, and its
    next state. A contact with the bridge comes before any T with r cos T <= k of the lowest ray, or at which the
    highest ray is below the bridge; the tangent ray at T bounds what is later.

    lower                                  == a state below another: in height and slope
    L15a_height, L15a_lowest, L15a_highest == a lower state flies lower, and is lower after a collision
    L15b_before, L15b_none, L15b_met       == before which point a contact with the bridge is, or that there is none
    L15c_contact                           == the tangent ray bounds what comes after a contact *)
From Coq Require Import Reals Lra Lia.
From Dumbbell Require Import Ray Chart Forward.
Local Open Scope R_scope.

(** Lower bounds of a state that leaves R. *)
Definition lower (x0 k0 x k : R) := 0 <= x0 <= x /\ x <= PI/2 /\ k0 <= k /\ - cos x <= k.

(** L15 (a): the height. *)
Lemma L15a_height x0 k0 x k t : lower x0 k0 x k -> 0 <= t -> height_at x0 k0 t <= height_at x k t.
Proof.
  intros [Hx [Hx2 [Hk Hup]]] Ht. assert (HPI : 0 < PI) by apply PI_RGT_0. unfold height_at.
  assert (T := sin_below_tangent x x0 ltac:(lra) ltac:(lra)).
  assert (k0 * (x0 + t) <= k * (x0 + t)) by (apply Rmult_le_compat_r; lra).
  assert (0 <= (k + cos x) * (x - x0)) by (apply Rmult_le_pos; lra). lra.
Qed.

(** L15 (a): the reflection of the lowest ray, with a lower bound y0 of the contact and an upper bound w0 of cos y0; *)
Lemma L15a_lowest r0 r k0 k y0 y w0 : 0 < r0 <= r -> 0 <= y0 <= y -> y < PI/2 -> cos y0 <= w0 -> k0 <= k ->
  k < cos y -> 0 < slope_den (cos y) k r -> lower y0 (next_slope w0 k0 r0) y (next_slope (cos y) k r).
Proof.
  intros Hr Hy Hy2 Hw Hk Hky HD. assert (W := cos_pos y ltac:(lra)).
  assert (C : cos y <= cos y0) by (apply cos_mono; lra).
  destruct (reflect_mono w0 (cos y) k0 k r0 r) as [_ K1]; try lra.
  assert (0 <= cos y * cos y) by apply Rle_0_sqr. assert (N := next_leaves (cos y) k r ltac:(lra) Hky HD).
  unfold lower. repeat split; lra.
Qed.
(** and of the highest ray, with an upper bound y1 of the contact and a lower bound w1 of cos y1. *)
Lemma L15a_highest r r1 k k1 y y1 w1 : 0 < r <= r1 -> 0 <= y <= y1 -> y1 <= PI/2 -> 0 < w1 <= cos y1 -> k <= k1 ->
  0 < slope_den w1 k1 r1 -> lower y (next_slope (cos y) k r) y1 (next_slope w1 k1 r1).
Proof.
  intros Hr Hy Hy2 Hw Hk HD. assert (C : cos y1 <= cos y) by (apply cos_mono; lra).
  assert (K := slope_below_wall w1 k1 r1 ltac:(lra) ltac:(lra) HD).
  destruct (reflect_mono (cos y) w1 k k1 r r1) as [_ K1]; try lra.
  assert (0 <= w1 * w1) by apply Rle_0_sqr. assert (N := next_leaves w1 k1 r1 ltac:(lra) K HD).
  unfold lower. repeat split; lra.
Qed.

(** L15 (b): where a contact with the bridge is. *)
Lemma L15b_before r k0 k x t T : 0 < r -> k0 <= k -> meets_bridge r x k t -> 0 <= T <= PI -> r * cos T <= k0 -> t <= T.
Proof.
  intros Hr K [Ht [_ Hk]] HT HkT. apply Rnot_lt_le. intros L.
  assert (cos t <= cos T) by (apply cos_decr_1; lra).
  assert (r * cos t <= r * cos T) by (apply Rmult_le_compat_l; lra). lra.
Qed.
(** A lowest ray that is above the bridge: no contact. *)
Lemma L15b_none r x0 k0 x k t : lower x0 k0 x k -> meets_bridge r x k t -> height_at x0 k0 t <= r * sin t.
Proof. intros HL [Ht [E _]]. rewrite <- E. apply L15a_height; [exact HL | lra]. Qed.

(** L15 (c), and (i): a ray out of the bridge at t <= T lies above that at T of a smaller eta; eta0 = 0: the tangent. *)
Lemma L15c_contact r n t eta T eta0 : 0 < r <= 1 -> 0 <= t <= T -> T <= PI -> 0 <= eta0 <= eta ->
  coll r n (r * cX t eta) (r * lamX t eta) -> coll r n (Rmax 0 (r * cX T eta0)) (r * lamX T eta0).
Proof.
  intros Hr Ht HT He H. assert (HPI : 0 < PI) by apply PI_RGT_0. destruct (COS_bound T) as [B _].
  assert (L : r * lamX T eta0 <= r * lamX t eta) by (apply Rmult_le_compat_l; [lra | apply lamX_mono; lra]).
  assert (K : r * cX T eta0 <= r * cX t eta) by (apply Rmult_le_compat_l; [lra | apply cX_mono; lra]).
  assert (B1 : - r <= r * lamX T eta0).
  { unfold lamX. assert (r * -1 <= r * (cos T + eta0)) by (apply Rmult_le_compat_l; lra). lra. }
  assert (P : 0 <= cX t eta).
  { assert (Q := cX_mono t PI eta 0 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
    assert (cX PI 0 = 0) by (unfold cX; rewrite sin_PI; ring). lra. }
  apply (coll_mono n) with (8 := H); try lra; [apply Rmax_l|].
  apply Rmax_lub; [apply Rmult_le_pos; lra | exact K].
Qed.

(** Upper bounds of a state, L15 (a): where the highest ray collides, the state does before. *)
Lemma L15a_collides_before r x k x1 k1 y1 : lower x k x1 k1 -> clears_bridge r x k -> hit (height_at x1 k1 PI) k1 y1 ->
  exists y, hit (height_at x k PI) k y /\ y <= y1.
Proof.
  intros HL Hc Hy. assert (HPI : 0 < PI) by apply PI_RGT_0. assert (K := Hc PI ltac:(lra)). rewrite sin_PI in K.
  apply (flight_mono _ _ (height_at x1 k1 PI) k1); [lra | apply L15a_height; [exact HL | lra] | apply HL | exact Hy].
Qed.
(** L15 (b): a flight that would be below the bridge, at T, has met it, at T or before. *)
Lemma L15b_met r x k T : 0 < r -> 0 <= T <= PI -> height_at x k T < r * sin T ->
  ~ clears_bridge r x k /\ forall t, meets_bridge r x k t -> t <= T.
Proof.
  intros Hr HT Hb. split.
  - intros Hc. specialize (Hc T HT). lra.
  - intros t [Ht [E Hk]]. apply Rnot_lt_le. intros L. assert (Tg := sin_below_tangent t T ltac:(lra) HT).
    assert (r * sin T <= r * (sin t + (T - t) * cos t)) by (apply Rmult_le_compat_l; lra).
    assert (0 < (r * cos t - k) * (t - T)) by (apply Rmult_lt_0_compat; lra). unfold height_at in *. lra.
Qed.
