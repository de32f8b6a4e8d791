(** L8 (a), (b), L9 (a), (b): the rays of the two charts, and how they change with e, eta, lambda and the ratio.
    What a cover has to show (`bridge_bound`, `light_bound`), and what a witness is.

    lamX, cX, lamS, cS                       == the rays X and sigma X of the chart bridge, but for a factor r
    cL, mu                                   == the rays of the chart light
    bridge_bound, light_bound                == all points of a chart have at most U collisions
    bridge_witness                           == a point of the chart bridge has at least V
    cX_mono, lamX_mono, cS_mono, lamS_mono, mu_mono == how the rays change with e, eta, lambda and r *)
From Coq Require Import Reals Lra Lia.
From Dumbbell Require Import Ray.
From Dumbbell Require Export Descending.
Local Open Scope R_scope.

(** Chart bridge, in units of r (L8 (3)). *)
Definition eta_reversed (eta s r : R) := eta * (1 + r*(s*s)) / (1 + r*(s*s) + 2*(r*s*eta)).
Definition lamX (e eta : R) := cos e + eta.
Definition cX (e eta : R) := sin e + lamX e eta * (PI - e).
Definition lamS (e eta r : R) := eta_reversed eta (cos e) r - cos e.
Definition cS (e eta r : R) := sin e + lamS e eta r * e.
(** Chart light (L9). *)
Definition cL (e k : R) := sin e + k * (PI + e).
Definition mu_den (w lam r : R) := w*w + 2*(r*lam*w) - r.
Definition mu (w lam r : R) := (2*w + r*lam - lam*(w*w)) / mu_den w lam r.

(** What a cover of one mass ratio is to show, and a witness. *)
Definition bridge_bound r U := forall e eta a b, 0 < e <= PI/2 -> 0 <= eta -> r * eta < 1 ->
  coll r a (r * cX e eta) (r * lamX e eta) -> coll r b (r * cS e eta r) (r * lamS e eta r) -> (1 + a + b <= U)%nat.
(** A ray from the wall R at corner distance e does not go below the bridge (L9 (c)); and what makes this so of X and
  sigma X. *)
Definition above_bridge r e k := forall t, 0 < t < PI -> r * sin t <= sin e + k * (e + t).
Definition light_bound r U := forall e lam a b, 0 < e <= PI/2 -> 0 <= lam -> r * lam < 1 ->
  0 <= 2 * cos e + r * lam - lam * (cos e * cos e) ->
  above_bridge r e (r * lam) -> (0 < mu_den (cos e) lam r -> above_bridge r e (r * mu (cos e) lam r)) ->
  coll r a (cL e (r * lam)) (r * lam) ->
  (0 < mu_den (cos e) lam r -> coll r b (cL e (r * mu (cos e) lam r)) (r * mu (cos e) lam r)) ->
  (mu_den (cos e) lam r <= 0 -> b = O) -> (1 + a + b <= U)%nat.
Definition bridge_witness r V := exists e eta a b, 0 < e < PI/2 /\ 0 < eta /\ r * lamX e eta < 1 /\
  coll r a (r * cX e eta) (r * lamX e eta) /\ coll r b (r * cS e eta r) (r * lamS e eta r) /\ (V <= 1 + a + b)%nat.

Lemma cos_range e : 0 <= e <= PI/2 -> 0 <= cos e <= 1.
Proof. intros. split; [apply cos_ge_0; assert (0 < PI) by apply PI_RGT_0; lra | apply COS_bound]. Qed.

(** L8 (a). *)
Lemma tangent_at_pi e e1 : 0 <= e -> e <= e1 -> e1 <= PI -> sin e1 + cos e1 * (PI - e1) <= sin e + cos e * (PI - e).
Proof. intros. assert (T := sin_below_tangent e e1 ltac:(lra) ltac:(lra)).
assert (cos e1 <= cos e) by (apply cos_decr_1; lra).
  assert (cos e1 * (PI - e1) <= cos e * (PI - e1)) by (apply Rmult_le_compat_r; lra). lra. Qed.
Lemma cX_mono e e1 eta eta0 : 0 <= e -> e <= e1 -> e1 <= PI -> eta0 <= eta -> 0 <= eta0 -> cX e1 eta0 <= cX e eta.
Proof. intros. unfold cX, lamX. assert (A := tangent_at_pi e e1 ltac:(lra) ltac:(lra) ltac:(lra)).
  assert (eta0 * (PI - e1) <= eta * (PI - e)) by (apply mul_mono; lra). lra. Qed.
Lemma lamX_mono e e1 eta eta0 : 0 <= e -> e <= e1 -> e1 <= PI -> eta0 <= eta -> lamX e1 eta0 <= lamX e eta.
Proof. intros. unfold lamX. assert (cos e1 <= cos e) by (apply cos_decr_1; lra). lra. Qed.

(** L8 (b). *)
Lemma ep_mono eta eta0 s s0 r r1 : 0 <= eta0 -> eta0 <= eta -> 0 <= s -> s <= s0 -> s0 <= 1 -> 0 < r ->
  r <= r1 -> r1 <= 1 ->
  eta_reversed eta0 s0 r1 <= eta_reversed eta s r.
Proof.
  intros. assert (S0 : 0 <= s * s) by nra. assert (S1 : 0 <= s0 * s0) by nra.
  assert (P1 : 0 <= r * (s * s)) by (apply Rmult_le_pos; lra).
  assert (P2 : 0 <= r1 * (s0 * s0)) by (apply Rmult_le_pos; lra).
  assert (P3 : 0 <= r * s * eta) by (repeat apply Rmult_le_pos; lra).
  assert (P4 : 0 <= r1 * s0 * eta0) by (repeat apply Rmult_le_pos; lra).
  unfold eta_reversed. apply frac_le; try lra.
  replace (eta * (1 + r * (s * s)) * (1 + r1 * (s0 * s0) + 2 * (r1 * s0 * eta0)) - eta0 * (1 + r1 * (s0 * s0)) *
    (1 + r * (s * s) + 2 * (r * s * eta)))
    with ((eta - eta0) * ((1 + r * (s * s)) * (1 + r1 * (s0 * s0))) + 2 * (eta * eta0) *
      ((r1 * s0) * (1 + r * (s * s)) - (r * s) * (1 + r1 * (s0 * s0)))) by ring.
  assert (0 <= (eta - eta0) * ((1 + r * (s * s)) * (1 + r1 * (s0 * s0)))) by (repeat apply Rmult_le_pos; lra).
  assert (E : (r1 * s0) * (1 + r * (s * s)) - (r * s) * (1 + r1 * (s0 * s0)) = (r1 - r) * s0 + r *
    ((s0 - s) * (1 - r1 * (s * s0)))) by ring.
  assert (0 <= (r1 - r) * s0) by (apply Rmult_le_pos; lra).
  assert (0 <= s * s0 <= 1) by nra. assert (r1 * (s * s0) <= 1) by nra.
  assert (0 <= r * ((s0 - s) * (1 - r1 * (s * s0)))) by (apply Rmult_le_pos; [lra|]; apply Rmult_le_pos; lra).
  assert (0 <= 2 * (eta * eta0) * ((r1 * s0) * (1 + r * (s * s)) - (r * s) * (1 + r1 * (s0 * s0)))).
  { rewrite E. apply Rmult_le_pos; [|lra]. apply Rmult_le_pos; [lra|]. apply Rmult_le_pos; lra. } lra.
Qed.
Lemma lamS_mono e e0 eta eta0 r r1 : 0 <= e0 -> e0 <= e -> e <= PI/2 -> 0 <= eta0 -> eta0 <= eta -> 0 < r ->
  r <= r1 -> r1 <= 1 ->
  lamS e0 eta0 r1 <= lamS e eta r.
Proof. intros. unfold lamS. assert (cos e <= cos e0) by (apply cos_mono; lra).
  assert (A := cos_range e ltac:(lra)). assert (B := cos_range e0 ltac:(lra)).
  assert (C := ep_mono eta eta0 (cos e) (cos e0) r r1). lra. Qed.
Lemma cS_mono e e0 eta eta0 r r1 : 0 <= e0 -> e0 <= e -> e <= PI/2 -> 0 <= eta0 -> eta0 <= eta -> 0 < r ->
  r <= r1 -> r1 <= 1 ->
  cS e0 eta0 r1 <= cS e eta r.
Proof.
  intros. unfold cS, lamS. assert (C1 : cos e <= cos e0) by (apply cos_mono; lra). assert (0 < PI) by apply PI_RGT_0.
  assert (A := cos_range e ltac:(lra)). assert (B := cos_range e0 ltac:(lra)).
  assert (C :=
    ep_mono eta eta0 (cos e) (cos e0) r r1 ltac:(lra) ltac:(lra) ltac:(lra) C1 ltac:(lra) ltac:(lra)
    ltac:(lra) ltac:(lra)).
  assert (D : 0 <= eta_reversed eta0 (cos e0) r1).
  { unfold eta_reversed. assert (0 <= r1 * (cos e0 * cos e0)) by (repeat apply Rmult_le_pos; lra).
    assert (0 <= r1 * cos e0 * eta0) by (repeat apply Rmult_le_pos; lra).
    apply Rmult_le_pos; [apply Rmult_le_pos; lra | left; apply Rinv_0_lt_compat; lra]. }
  assert (T := sin_below_tangent e e0 ltac:(lra) ltac:(lra)).
  assert (e0 * cos e <= e0 * cos e0) by (apply Rmult_le_compat_l; lra).
  assert (eta_reversed eta0 (cos e0) r1 * e0 <= eta_reversed eta (cos e) r * e) by (apply mul_mono; lra). lra.
Qed.
Lemma lamS_ge e eta r : 0 <= e <= PI/2 -> 0 <= eta -> 0 < r <= 1 -> - 1 <= lamS e eta r.
Proof. intros. assert (A := cos_range e ltac:(lra)). unfold lamS. assert (D : 0 <= eta_reversed eta (cos e) r); [|lra].
  unfold eta_reversed. assert (0 <= r * (cos e * cos e)) by (repeat apply Rmult_le_pos; lra).
  assert (0 <= r * cos e * eta) by (repeat apply Rmult_le_pos; lra).
  apply Rmult_le_pos; [apply Rmult_le_pos; lra | left; apply Rinv_0_lt_compat; lra]. Qed.
Lemma cS_ge e eta r : 0 <= e <= PI/2 -> 0 <= eta -> 0 < r <= 1 -> 0 <= cS e eta r.
Proof. intros. assert (0 < PI) by apply PI_RGT_0. assert (A := cS_mono e 0 eta 0 r 1).
  assert (cS 0 0 1 = 0) by (unfold cS; rewrite sin_0; ring). lra. Qed.

(** L9 (b). *)
Lemma mu_next_slope w lam r : 0 < mu_den w lam r -> r * mu w lam r = next_slope w (- (r * lam)) r.
Proof. intros H. unfold mu, next_slope.
replace (slope_den w (-(r*lam)) r) with (mu_den w lam r) by (unfold slope_den, mu_den; ring).
  unfold slope_num. field. lra. Qed.
Lemma mu_mono w w0 lam lam1 r r0 : 0 <= w -> w <= w0 -> 0 <= lam -> lam <= lam1 -> 0 < r0 -> r0 <= r ->
  0 < r * lam \/ 0 < w ->
  0 < mu_den w lam r -> 0 < mu_den w0 lam1 r0 -> mu w0 lam1 r0 <= mu w lam r.
Proof.
  intros Hw Hww Hl Hll Hr0 Hr Hor HD HD0.
  assert (L0 : 0 <= r * lam) by (apply Rmult_le_pos; lra).
  assert (L1 : r * lam <= r * lam1) by (apply Rmult_le_compat_l; lra).
  assert (Hd : slope_den w (-(r*lam)) r = mu_den w lam r) by (unfold slope_den, mu_den; ring).
  destruct (next_slope_anti_w w0 w (-(r*lam)) r) as [A1 A2]; try lra.
  destruct (next_slope_mono_k w0 (-(r*lam1)) (-(r*lam)) r) as [B1 B2]; try lra.
  assert (E1 : 0 < mu_den w0 lam1 r) by (unfold slope_den, mu_den in *; lra).
  assert (K : mu w0 lam1 r <= mu w lam r).
  { apply Rmult_le_reg_l with r; [lra|]. rewrite !mu_next_slope by assumption. lra. }
  apply Rle_trans with (2 := K). unfold mu. apply frac_le; try assumption.
  replace ((2 * w0 + r * lam1 - lam1 * (w0 * w0)) * mu_den w0 lam1 r0 - (2 * w0 + r0 * lam1 - lam1 * (w0 * w0)) *
    mu_den w0 lam1 r)
    with ((r - r0) * (2 * w0 * ((1 - lam1 * w0) * (1 - lam1 * w0)))) by (unfold mu_den; ring).
  apply Rmult_le_pos; [lra|]. apply Rmult_le_pos; [lra | apply Rle_0_sqr].
Qed.
Lemma mu_den_upper w w0 lam lam1 r r0 r1 : 0 <= w -> w <= w0 -> 0 <= lam -> lam <= lam1 -> r0 <= r ->
  r <= r1 -> 0 <= r0 ->
  mu_den w lam r <= w0*w0 + 2*(r1*lam1*w0) - r0.
Proof. intros. unfold mu_den. assert (w * w <= w0 * w0) by nra. assert (r * lam <= r1 * lam1) by (apply mul_mono; lra).
  assert (0 <= r * lam) by (apply Rmult_le_pos; lra).
  assert (r * lam * w <= r1 * lam1 * w0) by (apply mul_mono; lra). lra. Qed.
