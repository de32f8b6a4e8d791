(** L10: descending rays (r c, r lambda), lambda < 0, have fewer collisions at greater r. The first hit moves to the
    right as r grows; seen as a function of the hit t, r is sin t / (c - a t), a = - lambda, and 1 / kappa' falls along
    it. After the first hit L5 (d) does the rest.

    L10_descending_rays == a descending ray has as many collisions at a smaller r *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Ray.
Local Open Scope R_scope.

(** The polynomial inequality E >= 0. *)
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

Section Descending.
Variables c a : R.
Hypothesis Ha : 0 < a <= 1.

(** The ratio at which the ray hits at t; 1 / kappa' there, and its derivative. *)
Definition ratio_at t := sin t / (c - a*t).
Definition inverse_slope t := slope_den (cos t) (- (ratio_at t * a)) (ratio_at t) / L10_num (cos t) (ratio_at t) a.
Definition inverse_slope' t := - ratio_at t * L10_sign (cos t) (ratio_at t) a /
  (sin t * (L10_num (cos t) (ratio_at t) a * L10_num (cos t) (ratio_at t) a)).

Lemma L10_num_pos w r : 0 < w <= 1 -> 0 < r -> 0 < L10_num w r a.
Proof.
  intros Hw Hr. unfold L10_num. apply Rmult_lt_0_compat; [assumption|].
  assert (0 < r * a) by (apply Rmult_lt_0_compat; lra).
  assert (a * (w * w) <= 1 * (w * 1)).
  { apply Rmult_le_compat; try lra; [apply Rmult_le_pos; lra | apply Rmult_le_compat; lra]. } lra.
Qed.
Lemma L10_slope_num w r : slope_num w (r * - a) r = L10_num w r a.
Proof. unfold slope_num, L10_num. ring. Qed.

Lemma L10_derive t : 0 < c - a * t -> 0 < sin t -> 0 < cos t <= 1 -> is_derive inverse_slope t (inverse_slope' t).
Proof.
  intros H1 H2 H0. assert (H7 : 0 < ratio_at t) by (apply Rdiv_lt_0_compat; assumption).
  assert (H4 := L10_num_pos (cos t) (ratio_at t) H0 H7). assert (H5 := Rgt_not_eq _ _ H4).
  assert (HE : cos t * cos t = 1 - sin t * sin t) by (generalize (sin2_cos2 t); unfold Rsqr; lra).
  unfold inverse_slope, inverse_slope', ratio_at, slope_den, L10_num, L10_sign in *. auto_derive.
  - change (c + - (a * t)) with (c - a * t). unfold Rdiv, Rminus in H5. repeat split; try exact H5; lra.
  - set (g := c - a * t) in *. replace (c + - (a * t)) with g in * by (unfold g; ring).
    set (w := cos t) in *. set (S := sin t) in *. clearbody w g S.
    assert (H8 : 2 * w * g - a * (w * w) * g + S * a <> 0).
    { intros Z. replace (S / g * (2 * w - a * (w * w) + S / g * a)) with
        (S / g * (2 * w * g - a * (w * w) * g + S * a) / g) in H4 by (field; lra). rewrite Z in H4.
      unfold Rdiv in H4. rewrite Rmult_0_r, Rmult_0_l in H4. lra. }
    replace (1 - w * w) with (S * S) by lra. clear HE H4 H5. field. repeat split; try lra.
    all: intros Z; apply H8; rewrite <- Z; ring.
Qed.

(** Along the hits from x0 to x the ratio grows from r0 to r, and 1 / kappa' falls. *)
Lemma ratio_between x0 x t : 0 < x0 -> x < PI/2 -> 0 < c - a * x -> x0 <= t <= x ->
  0 < c - a * t /\ 0 < sin t /\ 0 < cos t <= 1 /\ 0 < ratio_at t <= ratio_at x.
Proof.
  intros H0 Hx Hg Ht. assert (a * t <= a * x) by (apply Rmult_le_compat_l; lra).
  assert (0 < sin t) by (apply sin_gt_0; lra). assert (sin t <= sin x) by (apply sin_mono; lra).
  split; [lra|]. split; [assumption|]. split; [split; [apply cos_pos; lra | apply COS_bound]|].
  split; [apply Rdiv_lt_0_compat; lra|]. apply frac_le; [lra | lra|].
  assert (0 <= sin t * (a * x - a * t)) by (apply Rmult_le_pos; lra).
  assert (0 <= (sin x - sin t) * (c - a * t)) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma inverse_slope_falls x0 x : 0 < x0 -> x0 <= x -> x < PI/2 -> 0 < c - a * x -> ratio_at x <= 1 ->
  inverse_slope x <= inverse_slope x0.
Proof.
  intros H0 H01 Hx Hg Hr. assert (B := fun t => ratio_between x0 x t H0 Hx Hg).
  destruct (MVT_gen inverse_slope x0 x inverse_slope') as [t [Ht E]]; rewrite Rmin_left, Rmax_right in * by lra.
  { intros t Ht. destruct (B t ltac:(lra)) as [T1 [T2 [T3 _]]]. now apply L10_derive. }
  { intros t Ht. destruct (B t ltac:(lra)) as [T1 [T2 [T3 _]]]. apply derivable_continuous_pt. eexists.
    apply is_derive_Reals. now apply L10_derive. }
  destruct (B t Ht) as [T1 [T2 [T3 T4]]]. assert (Q := L10_num_pos (cos t) (ratio_at t) T3 ltac:(lra)).
  assert (S : 0 <= L10_sign (cos t) (ratio_at t) a) by (apply L10_polynomial; lra).
  assert (0 < sin t * (L10_num (cos t) (ratio_at t) a * L10_num (cos t) (ratio_at t) a))
    by (apply Rmult_lt_0_compat; [exact T2 | exact (Rmult_lt_0_compat _ _ Q Q)]).
  assert (0 <= - inverse_slope' t * (x - x0)); [|lra]. apply Rmult_le_pos; [|lra].
  unfold inverse_slope'. replace (- (- ratio_at t * L10_sign (cos t) (ratio_at t) a /
    (sin t * (L10_num (cos t) (ratio_at t) a * L10_num (cos t) (ratio_at t) a)))) with
    (ratio_at t * L10_sign (cos t) (ratio_at t) a /
    (sin t * (L10_num (cos t) (ratio_at t) a * L10_num (cos t) (ratio_at t) a))) by (field; lra).
  apply Rmult_le_pos; [apply Rmult_le_pos; lra | left; now apply Rinv_0_lt_compat].
Qed.
(** At the corner, t = 0, every ratio hits; there 1 / kappa' falls, too. *)
Lemma inverse_slope_at_corner r0 r : 0 < r0 -> r0 <= r -> r <= 1 ->
  slope_den 1 (r * - a) r / L10_num 1 r a <= slope_den 1 (r0 * - a) r0 / L10_num 1 r0 a.
Proof.
  intros H0 H01 H1. apply frac_le; [apply L10_num_pos; lra | apply L10_num_pos; lra|]. unfold slope_den, L10_num.
  replace ((1 * 1 - 2 * (r0 * - a) * 1 - r0) * (r * (2 * 1 - a * (1 * 1) + r * a)) -
    (1 * 1 - 2 * (r * - a) * 1 - r) * (r0 * (2 * 1 - a * (1 * 1) + r0 * a)))
    with ((r - r0) * ((2 - a) + a * (r + r0) + r * r0 * a * (2 * a - 1))) by ring.
  apply Rmult_le_pos; [lra|]. assert (0 <= r * r0) by (apply Rmult_le_pos; lra). assert (r * r0 <= r) by nra. nra.
Qed.
End Descending.

Lemma hit_ratio c a r x : hit (r*c) (r * - a) x -> sin x = r * (c - a * x).
Proof. intros [_ [H _]]. lra. Qed.
Lemma L10_first_hit c lam r r0 x : -1 <= lam < 0 -> 0 <= c -> 0 < r0 -> r0 < r -> r <= 1 -> hit (r*c) (r*lam) x ->
  exists x0, hit (r0*c) (r0*lam) x0 /\ x0 <= x.
Proof.
  intros Hl Hc Hr0 Hr Hr1 [Hx [Hs Hk]]. assert (Wx := cos_pos _ Hx).
  assert (0 <= sin x) by (apply sin_ge_0; lra). assert (Hg : 0 <= c + lam * x) by (apply Rmult_le_reg_l with r; lra).
  destruct (Req_dec (sin x) 0) as [Z|Z].
  - exists x. assert (c + lam * x = 0) by (apply Rmult_eq_reg_l with r; lra). repeat split; try lra; nra.
  - apply hit_exists; [apply Rmult_le_pos; lra | lra |].
    assert (0 < c + lam * x) by (apply Rmult_lt_reg_l with r; lra).
    assert (r0 * (c + lam * x) < r * (c + lam * x)) by (apply Rmult_lt_compat_r; lra). lra.
Qed.
Lemma hit_at_corner c a r x : 0 < r -> 0 < a -> hit (r*c) (r * - a) x -> c = 0 -> x = 0.
Proof.
  intros Hr Ha [Hx [Hs _]] ->. destruct (Rle_lt_or_eq_dec 0 x) as [P|P]; [lra | | auto]. exfalso.
  assert (0 < sin x) by (apply sin_gt_0; lra). assert (0 < r * (a * x)) by (repeat apply Rmult_lt_0_compat; lra). lra.
Qed.
Lemma L10_inverse_slopes c a r r0 x x0 : 0 < a <= 1 -> 0 <= c -> 0 < r0 -> r0 < r -> r <= 1 ->
  hit (r*c) (r * - a) x -> hit (r0*c) (r0 * - a) x0 -> x0 <= x ->
  slope_den (cos x) (r * - a) r / L10_num (cos x) r a <= slope_den (cos x0) (r0 * - a) r0 / L10_num (cos x0) r0 a.
Proof.
  intros Ha Hc Hr0 Hr Hr1 Hh Hh0 Hxx. assert (E := hit_ratio c a r x Hh).
  assert (E0 := hit_ratio c a r0 x0 Hh0). destruct (Rle_lt_or_eq_dec 0 c Hc) as [P|<-].
  - destruct Hh as [Hx _], Hh0 as [Hx0 _].
    assert (X0 : 0 < x0).
    { destruct (Rle_lt_or_eq_dec 0 x0) as [|Z]; [lra | assumption |]. rewrite <- Z, sin_0 in E0.
      assert (0 < r0 * c) by (apply Rmult_lt_0_compat; lra). lra. }
    assert (G : 0 < c - a * x)
      by (apply Rmult_lt_reg_l with r; [lra|]; assert (0 < sin x) by (apply sin_gt_0; lra); lra).
    assert (a * x0 <= a * x) by (apply Rmult_le_compat_l; lra).
    assert (R : ratio_at c a x = r) by (unfold ratio_at; rewrite E; field; lra).
    assert (R0 : ratio_at c a x0 = r0) by (unfold ratio_at; rewrite E0; field; lra).
    assert (K := inverse_slope_falls c a Ha x0 x X0 Hxx ltac:(lra) G ltac:(lra)). unfold inverse_slope in K.
    rewrite R, R0 in K. replace (r * - a) with (- (r * a)) by ring. replace (r0 * - a) with (- (r0 * a)) by ring.
    exact K.
  - rewrite (hit_at_corner 0 a r x), (hit_at_corner 0 a r0 x0), cos_0 by (try assumption; lra).
    apply inverse_slope_at_corner; lra.
Qed.
Lemma L10_step c lam r r0 x : -1 <= lam < 0 -> 0 <= c -> 0 < r0 -> r0 <= r -> r <= 1 -> hit (r*c) (r*lam) x ->
  exists x0, hit (r0*c) (r0*lam) x0 /\ x0 <= x /\ (0 < slope_den (cos x) (r*lam) r ->
  0 < slope_den (cos x0) (r0*lam) r0 /\ next_slope (cos x0) (r0*lam) r0 <= next_slope (cos x) (r*lam) r).
Proof.
  intros Hl Hc Hr0 Hr Hr1 Hh. destruct (Req_dec r0 r) as [->|Hne]. { exists x. repeat split; try apply Hh; lra. }
  destruct (L10_first_hit c lam r r0 x) as [x0 [Hh0 Hxx]]; try assumption; try lra.
  exists x0. split; [exact Hh0|]. split; [exact Hxx|]. intros HD. set (a := - lam).
  replace lam with (- a) in * by (unfold a; ring). assert (Ha : 0 < a <= 1) by lra.
  assert (K := L10_inverse_slopes c a r r0 x x0 Ha Hc Hr0 ltac:(lra) Hr1 Hh Hh0 Hxx).
  assert (W : 0 < cos x <= 1) by (split; [apply cos_pos; apply Hh | apply COS_bound]).
  assert (W0 : 0 < cos x0 <= 1) by (split; [apply cos_pos; apply Hh0 | apply COS_bound]).
  assert (Q := L10_num_pos a Ha (cos x) r W ltac:(lra)). assert (Q0 := L10_num_pos a Ha (cos x0) r0 W0 Hr0).
  assert (0 < slope_den (cos x) (r * - a) r / L10_num (cos x) r a) by (now apply Rdiv_lt_0_compat).
  assert (D0 : 0 < slope_den (cos x0) (r0 * - a) r0).
  { apply Rmult_lt_reg_r with (/ L10_num (cos x0) r0 a); [now apply Rinv_0_lt_compat|]. rewrite Rmult_0_l.
    unfold Rdiv in *. lra. }
  split; [exact D0|]. unfold next_slope.
  rewrite !L10_slope_num, <- (Rinv_div (slope_den _ _ r0)), <- (Rinv_div (slope_den _ _ r)).
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
