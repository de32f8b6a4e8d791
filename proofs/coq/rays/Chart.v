(** L8 (a), (b), L9 (a), (b) and L10: the rays of the two charts, and how they change with e, eta, lambda and the ratio.
    What a cover has to show (`bridge_bound`, `light_bound`), and what a witness is. *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Ray.
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
Definition light_bound r U := forall e lam a b, 0 < e <= PI/2 -> 0 <= lam -> r * lam < 1 ->
  0 <= 2 * cos e + r * lam - lam * (cos e * cos e) ->
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

(** L10. The polynomial inequality E >= 0. *)
Lemma L10_polynomial w r a : 0 < w <= 1 -> 0 < r <= 1 -> 0 <= a <= 1 ->
  let p := w + r*a in let A := w*w + r in
  0 <= 2*w*(p*p*p) + 2*(1 + r*(a*a))*A*(1 - w*w) - a*(A*A)*p.
Proof.
  intros Hw Hr Ha p A.
  assert (Haw : 0 <= 1 - a * w) by nra. assert (Hp : 0 < p) by (unfold p; nra). assert (HA : 0 < A) by (unfold A; nra).
  assert (W2 : 0 <= 1 - w * w) by nra.
  assert (E1 : a * A = p - w * (1 - a * w)) by (unfold p, A; ring).
  assert (I1 : a * A <= p) by (rewrite E1; assert (0 <= w * (1 - a * w)) by (apply Rmult_le_pos; lra); lra).
  assert (E2 : (1 + r * (a*a)) * A = p * p + r * ((1 - a*w) * (1 - a*w))) by (unfold p, A; ring).
  assert (I2 : p * p <= (1 + r * (a*a)) * A)
    by (rewrite E2; assert (0 <= r * ((1 - a*w) * (1 - a*w))) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]); lra).
  assert (I3 : A <= 2 * w * p + (1 - w * w))
    by (unfold p, A; assert (0 <= w * (r * a)) by (repeat apply Rmult_le_pos; lra); nra).
  assert (J1 : a * (A * A) * p <= A * (p * p)).
  { replace (a * (A * A) * p) with (a * A * (A * p)) by ring. replace (A * (p * p)) with (p * (A * p)) by ring.
    apply Rmult_le_compat_r; [apply Rmult_le_pos; lra | exact I1]. }
  assert (J2 : A * (p * p) <= (2 * w * p + (1 - w * w)) * (p * p))
    by (apply Rmult_le_compat_r; [apply Rle_0_sqr | exact I3]).
  assert (J3 : (1 - w * w) * (p * p) <= (1 - w * w) * ((1 + r * (a*a)) * A)) by (apply Rmult_le_compat_l; lra).
  assert (0 <= (1 + r * (a*a)) * A * (1 - w * w)). { apply Rmult_le_pos; [|lra]. apply Rmult_le_pos; [|lra].
    assert (0 <= r * (a*a)) by (apply Rmult_le_pos; [lra|apply Rle_0_sqr]). lra. }
  nra.
Qed.

Definition L10_num w r a := r * (2*w - a*(w*w) + r*a).
Definition L10_sign w r a :=
  2*w*((w+r*a)*(w+r*a)*(w+r*a)) + 2*(1 + r*(a*a))*(w*w+r)*(1 - w*w) - a*((w*w+r)*(w*w+r))*(w+r*a).
Lemma L10_derive c a t : 0 < c - a * t -> 0 < sin t -> 0 < 2*cos t - a*(cos t*cos t) + sin t / (c - a*t) * a ->
  is_derive (fun u => slope_den (cos u) (- (sin u / (c - a*u) * a)) (sin u / (c - a*u)) /
  L10_num (cos u) (sin u / (c - a*u)) a) t
   (- (sin t / (c - a*t)) * L10_sign (cos t) (sin t / (c - a*t)) a /
   (sin t * (L10_num (cos t) (sin t / (c - a*t)) a * L10_num (cos t) (sin t / (c - a*t)) a))).
Proof.
  intros H1 H2 H3. assert (H4 : L10_num (cos t) (sin t / (c - a*t)) a <> 0).
  { unfold L10_num. apply Rmult_integral_contrapositive_currified; [|lra].
    assert (0 < sin t / (c - a*t)) by (apply Rdiv_lt_0_compat; assumption). lra. }
  assert (HE : cos t * cos t = 1 - sin t * sin t) by (generalize (sin2_cos2 t); unfold Rsqr; lra).
  unfold slope_den, L10_num, L10_sign in *. auto_derive.
  - change (c + - (a * t)) with (c - a * t). unfold Rdiv, Rminus in H4. repeat split; try exact H4; lra.
  - assert (H5 : sin t / (c - a*t) * (c - a*t) = sin t) by (field; lra).
    assert (H6 : 2*cos t - a*(cos t*cos t) + sin t / (c - a*t) * a <> 0) by lra.
    set (g := c - a * t) in *. replace (c + - (a * t)) with g in * by (unfold g; ring).
    assert (H7 : 0 < sin t / g) by (apply Rdiv_lt_0_compat; assumption).
    clear H4. set (w := cos t) in *. set (S := sin t) in *. clearbody w g S.
    assert (H8 : 2 * w * g - a * (w * w) * g + S * a <> 0).
    { intros Z. apply H6. apply Rmult_eq_reg_r with g; [|lra]. rewrite Rmult_0_l, <- Z. field. lra. }
    replace (1 - w * w) with (S * S) by lra. clear HE. field. repeat split; try lra.
    all: intros Z; apply H8; rewrite <- Z; ring.
Qed.

(** L10. *)
Lemma L10_step c lam r r0 x : -1 <= lam < 0 -> 0 <= c -> 0 < r0 -> r0 <= r -> r <= 1 -> hit (r*c) (r*lam) x ->
  exists x0, hit (r0*c) (r0*lam) x0 /\ x0 <= x /\
   (0 < slope_den (cos x) (r*lam) r ->
   0 < slope_den (cos x0) (r0*lam) r0 /\ next_slope (cos x0) (r0*lam) r0 <= next_slope (cos x) (r*lam) r).
Proof.
  intros Hl Hc Hr0 Hr Hr1 [Hx [Hs Hk]]. assert (Wx := cos_pos _ Hx).
  assert (Hsx : 0 <= sin x) by (apply sin_ge_0; lra).
  assert (Hg : 0 <= c + lam * x). { apply Rmult_le_reg_l with r; lra. }
  destruct (Req_dec r0 r) as [->|Hne]. { exists x. repeat split; lra. }
  assert (Hx0 : exists x0, hit (r0*c) (r0*lam) x0 /\ x0 <= x).
  { destruct (Req_dec (sin x) 0) as [Z|Z].
    - exists x. assert (c + lam * x = 0) by (apply Rmult_eq_reg_l with r; lra). repeat split; try lra; nra.
    - apply hit_exists; [apply Rmult_le_pos; lra | lra |].
      assert (0 < c + lam * x) by (apply Rmult_lt_reg_l with r; lra).
      assert (r0 * (c + lam * x) < r * (c + lam * x)) by (apply Rmult_lt_compat_r; lra). lra. }
  destruct Hx0 as [x0 [Hh0 Hxx]]. exists x0. split; [exact Hh0|]. split; [exact Hxx|].
  intros HD. destruct Hh0 as [H0 [Hs0 Hk0]]. assert (W0 := cos_pos _ H0).
  assert (C : cos x <= cos x0) by (apply cos_mono; lra).
  set (a := - lam) in *. assert (Ha : 0 < a <= 1) by (unfold a; lra).
  destruct (COS_bound x) as [_ Wx1]. destruct (COS_bound x0) as [_ W01].
  assert (PPpos : forall w q, 0 < w <= 1 -> 0 < q -> 0 < L10_num w q a).
  { intros w q Hw Hq. unfold L10_num. apply Rmult_lt_0_compat; [assumption|].
    assert (0 < q * a) by (apply Rmult_lt_0_compat; lra).
    assert (a * (w * w) <= 1 * (w * 1)).
    { apply Rmult_le_compat; try lra; [apply Rmult_le_pos; lra | apply Rmult_le_compat; lra]. } lra. }
  assert (NNP : forall w q, slope_num w (q*lam) q = L10_num w q a) by (intros; unfold slope_num, L10_num, a; ring).
  assert (Main : slope_den (cos x) (r*lam) r / L10_num (cos x) r a <= slope_den (cos x0) (r0*lam) r0 /
    L10_num (cos x0) r0 a).
  { destruct (Req_dec (sin x0) 0) as [Z0|Z0].
    - (* x0 = 0: then c = 0, sin x = r lam x <= 0, x = 0 *)
      assert (x0 = 0). { destruct (Rle_lt_or_eq_dec 0 x0) as [P|P]; [lra| |auto].
        assert (0 < sin x0) by (apply sin_gt_0; lra). lra. }
      subst x0. rewrite sin_0 in Hs0. assert (c = 0) by (apply Rmult_eq_reg_l with r0; lra). subst c.
      assert (x = 0). { destruct (Rle_lt_or_eq_dec 0 x) as [P|P]; [lra| |auto].
        assert (0 < sin x) by (apply sin_gt_0; lra). nra. }
      subst x. rewrite cos_0 in *. unfold slope_den, L10_num.
      replace (1 * 1 - 2 * (r * lam) * 1 - r) with (1 + r * (2 * a - 1)) by (unfold a; ring).
      replace (1 * 1 - 2 * (r0 * lam) * 1 - r0) with (1 + r0 * (2 * a - 1)) by (unfold a; ring).
      assert (Q1 := PPpos 1 r ltac:(lra) ltac:(lra)). assert (Q2 := PPpos 1 r0 ltac:(lra) ltac:(lra)).
      unfold L10_num in Q1, Q2.
      apply frac_le; try assumption.
      replace ((1 + r0 * (2 * a - 1)) * (r * (2 * 1 - a * (1 * 1) + r * a)) - (1 + r * (2 * a - 1)) *
        (r0 * (2 * 1 - a * (1 * 1) + r0 * a)))
       with ((r - r0) * ((2 - a) + a * (r + r0) + r * r0 * a * (2 * a - 1))) by ring.
      apply Rmult_le_pos; [lra|]. assert (0 <= r * r0) by (apply Rmult_le_pos; lra). assert (r * r0 <= r) by nra. nra.
    - assert (S0 : 0 < sin x0) by (assert (0 <= sin x0) by (apply sin_ge_0; lra); lra).
      assert (X0 : 0 < x0). { destruct (Rle_lt_or_eq_dec 0 x0) as [P|P]; [lra|auto|]. subst x0.
        rewrite sin_0 in S0. lra. }
      assert (Sx : 0 < sin x) by (apply sin_gt_0; lra).
      assert (Gx : 0 < c - a * x). { unfold a. apply Rmult_lt_reg_l with r; lra. }
      assert (Rx : sin x / (c - a * x) = r). { apply Rmult_eq_reg_r with (c - a * x); [|lra]. unfold Rdiv.
        rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra. unfold a; lra. }
      assert (G0 : 0 < c - a * x0) by (assert (a * x0 <= a * x) by (apply Rmult_le_compat_l; lra); lra).
      assert (R0 : sin x0 / (c - a * x0) = r0). { apply Rmult_eq_reg_r with (c - a * x0); [|lra]. unfold Rdiv.
        rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra. unfold a; lra. }
      assert (Ht : forall t, x0 <= t <= x ->
        0 < c - a * t /\ 0 < sin t /\ 0 < cos t <= 1 /\ r0 <= sin t / (c - a * t) <= r).
      { intros t Ht. assert (a * t <= a * x) by (apply Rmult_le_compat_l; lra).
        assert (a * x0 <= a * t) by (apply Rmult_le_compat_l; lra).
        assert (sin x0 <= sin t) by (apply sin_mono; lra). assert (sin t <= sin x) by (apply sin_mono; lra).
        split; [lra|]. split; [lra|]. split; [split; [apply cos_pos; lra | apply COS_bound]|].
        assert (K1 : sin x0 / (c - a * x0) <= sin t / (c - a * t)) by (apply frac_le; try lra; nra).
        assert (K2 : sin t / (c - a * t) <= sin x / (c - a * x)) by (apply frac_le; try lra; nra). lra. }
      destruct (MVT_gen (fun u => slope_den (cos u) (- (sin u / (c - a*u) * a)) (sin u / (c - a*u)) /
        L10_num (cos u) (sin u / (c - a*u)) a) x0 x
        (fun t => - (sin t / (c - a*t)) * L10_sign (cos t) (sin t / (c - a*t)) a /
          (sin t * (L10_num (cos t) (sin t / (c - a*t)) a * L10_num (cos t) (sin t / (c - a*t)) a)))) as [t [Htt E]].
      { rewrite Rmin_left, Rmax_right by lra. intros t Htt. destruct (Ht t) as [T1 [T2 [T3 T4]]]; [lra|].
        apply L10_derive; try assumption. assert (Q := PPpos (cos t) (sin t / (c - a*t)) T3 ltac:(lra)).
        unfold L10_num in Q.
        apply Rmult_lt_reg_l with (sin t / (c - a*t)); lra. }
      { rewrite Rmin_left, Rmax_right by lra. intros t Htt. destruct (Ht t) as [T1 [T2 [T3 T4]]]; [lra|].
        apply derivable_continuous_pt. eexists. apply is_derive_Reals. apply L10_derive; try assumption.
        assert (Q := PPpos (cos t) (sin t / (c - a*t)) T3 ltac:(lra)). unfold L10_num in Q.
        apply Rmult_lt_reg_l with (sin t / (c - a*t)); lra. }
      rewrite Rmin_left, Rmax_right in Htt by lra. destruct (Ht t Htt) as [T1 [T2 [T3 T4]]].
      rewrite Rx, R0 in E. replace (- (r * a)) with (r * lam) in E by (unfold a; ring).
      replace (- (r0 * a)) with (r0 * lam) in E by (unfold a; ring).
      assert (Q := PPpos (cos t) (sin t / (c - a*t)) T3 ltac:(lra)).
      assert (EEpos : 0 <= L10_sign (cos t) (sin t / (c - a*t)) a) by (apply L10_polynomial; lra).
      assert (0 < sin t * (L10_num (cos t) (sin t / (c - a*t)) a * L10_num (cos t) (sin t / (c - a*t)) a))
        by (apply Rmult_lt_0_compat; [exact T2 | exact (Rmult_lt_0_compat _ _ Q Q)]).
      assert (0 <= sin t / (c - a*t) * L10_sign (cos t) (sin t / (c - a*t)) a /
        (sin t * (L10_num (cos t) (sin t / (c - a*t)) a * L10_num (cos t) (sin t / (c - a*t)) a)) * (x - x0)).
      { apply Rmult_le_pos; [|lra]. apply Rmult_le_pos; [apply Rmult_le_pos; lra | left; now apply Rinv_0_lt_compat]. }
      unfold Rdiv in *. lra. }
  assert (Q1 := PPpos (cos x) r ltac:(lra) ltac:(lra)). assert (Q2 := PPpos (cos x0) r0 ltac:(lra) ltac:(lra)).
  assert (0 < slope_den (cos x) (r*lam) r / L10_num (cos x) r a) by (now apply Rdiv_lt_0_compat).
  assert (D0 : 0 < slope_den (cos x0) (r0*lam) r0).
  { apply Rmult_lt_reg_r with (/ L10_num (cos x0) r0 a); [now apply Rinv_0_lt_compat|]. rewrite Rmult_0_l.
    unfold Rdiv in *. lra. }
  split; [exact D0|]. unfold next_slope. rewrite !NNP.
  replace (L10_num (cos x0) r0 a / slope_den (cos x0) (r0 * lam) r0)
    with (/ (slope_den (cos x0) (r0 * lam) r0 / L10_num (cos x0) r0 a)) by (field; split; lra).
  replace (L10_num (cos x) r a / slope_den (cos x) (r * lam) r)
    with (/ (slope_den (cos x) (r * lam) r / L10_num (cos x) r a)) by (field; split; lra).
  now apply Rinv_le_contravar.
Qed.
Theorem L10_descending_rays n c lam r r0 : -1 <= lam < 0 -> 0 <= c -> 0 < r0 -> r0 <= r -> r <= 1 ->
  coll r n (r*c) (r*lam) -> coll r0 n (r0*c) (r0*lam).
Proof.
  intros Hl Hc Hr0 Hr Hr1. destruct n as [|n]; [easy|]. intros [x [Hh Hn]].
  destruct (L10_step c lam r r0 x) as [x0 [Hh0 [Hxx HK]]]; try assumption.
  exists x0. split; [exact Hh0|]. destruct Hn as [Hn|[HD Hn]]; [now left|right].
  destruct (HK HD) as [D0 K0]. split; [exact D0|].
  destruct (next_domain (r0*c) (r0*lam) r0 x0) as [Q1 Q2]; try assumption; [nra|].
  apply (coll_mono n) with (8 := Hn); try lra. destruct Hh0 as [? ?], Hh as [? ?]. apply height_mono; lra.
Qed.
