(** L25: contacts with the bridge near a corner, or near its top, are witnesses of 2 + k0 + k1 collisions.

    maximum_witness  == a witness of 2 + k0 + k1 collisions
    at_least_2_k0_k1 == some motion has as many
    four_near        == four continuous functions are near their values at 0 at the same t > 0 *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics Ray Chart EqualMasses WitnessMotion Orbits Openness.
Local Open Scope R_scope.

Lemma four_near f1 f2 f3 f4 e d : continuity_pt f1 0 -> continuity_pt f2 0 -> continuity_pt f3 0 ->
  continuity_pt f4 0 -> 0 < e -> 0 < d ->
  exists t, 0 < t < d /\ f1 t < f1 0 + e /\ f2 t < f2 0 + e /\ f3 t < f3 0 + e /\ f4 t < f4 0 + e.
Proof.
  intros C1 C2 C3 C4 He Hd. destruct (close_near f1 e C1 He) as [d1 [D1 N1]].
  destruct (close_near f2 e C2 He) as [d2 [D2 N2]].
  destruct (close_near f3 e C3 He) as [d3 [D3 N3]]. destruct (close_near f4 e C4 He) as [d4 [D4 N4]].
  set (m := Rmin d (Rmin (Rmin d1 d2) (Rmin d3 d4))). assert (M : 0 < m) by (repeat apply Rmin_glb_lt; assumption).
  assert (M1 : m <= d) by apply Rmin_l. assert (M2 : m <= Rmin (Rmin d1 d2) (Rmin d3 d4)) by apply Rmin_r.
  assert (U1 := Rmin_l (Rmin d1 d2) (Rmin d3 d4)). assert (U2 := Rmin_r (Rmin d1 d2) (Rmin d3 d4)).
  assert (V1 := Rmin_l d1 d2). assert (V2 := Rmin_r d1 d2). assert (V3 := Rmin_l d3 d4). assert (V4 := Rmin_r d3 d4).
  exists (m / 2). split; [lra|]. split; [apply N1; lra|]. split; [apply N2; lra|].
  split; [apply N3; lra | apply N4; lra].
Qed.

(** A contact at corner distance e (t), with eta = t. *)
Section Contact.
Variables (r : R) (e0 sg : R).
Hypothesis Hr : 0 < r < 1.
Hypothesis He0 : 0 <= e0 <= PI/2.
Hypothesis Hsg : forall t, 0 < t < 1 -> 0 < e0 + sg * t < PI/2.

Lemma contact_continuous : continuity_pt (fun t => r * cX (e0 + sg * t) t) 0 /\
  continuity_pt (fun t => r * lamX (e0 + sg * t) t) 0 /\
  continuity_pt (fun t => r * cS (e0 + sg * t) t r) 0 /\ continuity_pt (fun t => r * lamS (e0 + sg * t) t r) 0.
Proof.
  assert (H : 0 < 1 + r * (cos (e0 + sg * 0) * cos (e0 + sg * 0)) + 2 * (r * cos (e0 + sg * 0) * 0)).
  { assert (0 <= r * (cos (e0 + sg * 0) * cos (e0 + sg * 0))) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]). lra. }
  unfold cX, lamX, cS, lamS, eta_reversed. repeat split; reg; lra.
Qed.
Theorem L25_contact a b : r * cos e0 < 1 -> coll r a (r * cX e0 0) (r * lamX e0 0) ->
  coll r b (r * cS e0 0 r) (r * lamS e0 0 r) ->
  bridge_witness r (1 + a + b).
Proof.
  intros Hs Ca Cb. assert (HPI := PI2_1). destruct (cos_range e0 He0) as [W0 W1].
  assert (X1 : 0 <= cX e0 0) by (unfold cX, lamX; assert (0 <= sin e0) by (apply sin_ge_0; lra);
    assert (0 <= (cos e0 + 0) * (PI - e0)) by (apply Rmult_le_pos; lra); lra).
  assert (S1 := cS_ge e0 0 r He0 ltac:(lra) ltac:(lra)). assert (S2 := lamS_ge e0 0 r He0 ltac:(lra) ltac:(lra)).
  assert (X2 : 0 <= r * lamX e0 0) by (unfold lamX; apply Rmult_le_pos; lra).
  destruct (L20_raise a (r * cX e0 0) (r * lamX e0 0) r) as [ea [Ha Na]];
    [apply Rmult_le_pos; lra | lra | lra | exact Ca|].
  destruct (L20_raise b (r * cS e0 0 r) (r * lamS e0 0 r) r) as [eb [Hb Nb]];
    [apply Rmult_le_pos; lra | lra | nra | exact Cb|].
  set (m := Rmin (Rmin ea eb) (1 - r * cos e0)). assert (M : 0 < m) by (repeat apply Rmin_glb_lt; lra).
  assert (M1 : m <= ea) by (unfold m; apply Rle_trans with (1 := Rmin_l _ _), Rmin_l).
  assert (M2 : m <= eb) by (unfold m; apply Rle_trans with (1 := Rmin_l _ _), Rmin_r).
  assert (M3 : m <= 1 - r * cos e0) by apply Rmin_r.
  destruct contact_continuous as [C1 [C2 [C3 C4]]].
  destruct (four_near _ _ _ _ m 1 C1 C2 C3 C4 M ltac:(lra)) as [t [Ht [T1 [T2 [T3 T4]]]]].
  rewrite Rmult_0_r, Rplus_0_r in *. set (e := e0 + sg * t) in *. assert (He : 0 < e < PI/2) by (apply Hsg; exact Ht).
  destruct (cos_range e ltac:(lra)) as [V0 V1].
  assert (Y1 : 0 <= cX e t) by (unfold cX, lamX; assert (0 <= sin e) by (apply sin_ge_0; lra);
    assert (0 <= (cos e + t) * (PI - e)) by (apply Rmult_le_pos; lra); lra).
  assert (Y2 : 0 <= lamX e t) by (unfold lamX; lra).
  assert (Y3 := cS_ge e t r ltac:(lra) ltac:(lra) ltac:(lra)).
  assert (Y4 := lamS_ge e t r ltac:(lra) ltac:(lra) ltac:(lra)).
  assert (Z1 : 0 <= r * cX e t) by (apply Rmult_le_pos; lra). assert (Z2 : 0 <= r * lamX e t)
    by (apply Rmult_le_pos; lra).
  assert (Z3 : 0 <= r * cS e t r) by (apply Rmult_le_pos; lra). assert (Z4 : r * -1 <= r * lamS e t r)
    by (apply Rmult_le_compat_l; lra).
  exists e, t, a, b. split; [exact He|]. split; [lra|]. split.
  - unfold lamX in *. rewrite Rplus_0_r in T2. lra.
  - split; [apply Na; lra|]. split; [apply Nb; lra | lia].
Qed.
End Contact.

(** Near a corner X is nearly (pi r, r), and sigma X nearly (0, -r). *)
Theorem L25_near_corner r k1 : 0 < r < 1 -> coll r k1 (PI * r) r -> bridge_witness r (2 + k1 + k1).
Proof.
  intros Hr H. assert (HPI := PI2_1). replace (2 + k1 + k1)%nat with (1 + k1 + S k1)%nat by lia.
  apply (L25_contact r 0 1 Hr ltac:(lra)); unfold cX, lamX, cS, lamS, eta_reversed; rewrite ?sin_0, ?cos_0; try lra.
  - intros t Ht. lra.
  - replace (r * (0 + (1 + 0) * (PI - 0))) with (PI * r) by ring. replace (r * (1 + 0)) with r by ring. exact H.
  - replace (0 * (1 + r * (1 * 1)) / (1 + r * (1 * 1) + 2 * (r * 1 * 0))) with 0 by (field; lra).
    replace (r * (0 + (0 - 1) * 0)) with 0 by ring. replace (r * (0 - 1)) with (- r) by ring.
    apply L40_one_more; [lra | exact H].
Qed.
(** Near the top both are nearly (r, 0). *)
Theorem L25_near_top r k0 : 0 < r < 1 -> coll r k0 r 0 -> bridge_witness r (1 + k0 + k0).
Proof.
  intros Hr H. assert (HPI := PI2_1).
  apply (L25_contact r (PI/2) (-1) Hr ltac:(lra)); unfold cX, lamX, cS, lamS, eta_reversed;
    rewrite ?sin_PI2, ?cos_PI2; try lra.
  - intros t Ht. lra.
  - replace (r * (1 + (0 + 0) * (PI - PI / 2))) with r by ring. replace (r * (0 + 0)) with 0 by ring. exact H.
  - replace (0 * (1 + r * (0 * 0)) / (1 + r * (0 * 0) + 2 * (r * 0 * 0))) with 0 by field.
    replace (r * (1 + (0 - 0) * (PI / 2))) with r by ring. replace (r * (0 - 0)) with 0 by ring. exact H.
Qed.

(** At equal masses neither orbit collides. *)
Lemma no_orbit_at_1 k0 k1 : top_orbit 1 k0 -> corner_orbit 1 k1 -> k0 = O /\ k1 = O.
Proof.
  unfold top_orbit, corner_orbit. rewrite Rinv_1. intros T C. assert (HPI := PI2_1). split.
  - apply (too_high k0 1 0); try lra. apply T.
  - apply (steep_ray_misses 1 k1 (PI * 1) 1); [lra | apply C].
Qed.
Theorem maximum_witness q k0 k1 : 1 <= q -> top_orbit q k0 -> corner_orbit q k1 -> bridge_witness (/ q) (2 + k0 + k1).
Proof.
  intros Hq T C. destruct (Req_dec q 1) as [->|Hn].
  - destruct (no_orbit_at_1 k0 k1 T C) as [-> ->]. rewrite Rinv_1. apply equal_witness.
  - assert (Hr : 0 < / q < 1).
    { split; [apply Rinv_0_lt_compat; lra|]. rewrite <- Rinv_1. apply Rinv_lt_contravar; lra. }
    destruct (L21_counts q k0 k1 Hq T C) as [->| ->].
    + apply L25_near_corner; [exact Hr | apply C].
    + replace (2 + S k1 + k1)%nat with (1 + S k1 + S k1)%nat by lia. apply L25_near_top; [exact Hr | apply T].
Qed.
Theorem at_least_2_k0_k1 q k0 k1 : 1 <= q -> top_orbit q k0 -> corner_orbit q k1 -> lower_bound q (2 + k0 + k1).
Proof. intros Hq T C. apply charts_lower; [exact Hq | now apply maximum_witness]. Qed.
