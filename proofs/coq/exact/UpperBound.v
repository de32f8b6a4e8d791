(** At most 2 + k0 + k1 collisions: L22 with a contact on the bridge, L24 without one. L24 is used in its weak form
    2 + 2 k1: the flatter of two rays out of a turning collision has at most the 1 + k1 collisions of the ray (0,
    0), and the steeper one at most k1; whether a ray clears the bridge need not be known. *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics Ray Chart LightTotal Orbits.
Local Open Scope R_scope.

Section Upper.
Variable r : R.
Hypothesis Hr : 0 < r <= 1.
Variables k0 k1 : nat.
Hypothesis H0 : forall n, coll r n r 0 -> (n <= k0)%nat.
Hypothesis H1 : forall n, coll r n (PI * r) r -> (n <= k1)%nat.
Hypothesis H10 : (k1 <= k0)%nat.

(** L22: X is at least (r, 0), sigma X is at least (0, -r). *)
Theorem L22_bridge : bridge_bound r (2 + k0 + k1).
Proof.
  intros e eta a b He Heta _ Ca Cb. assert (HPI : 0 < PI) by apply PI_RGT_0.
  assert (A : (a <= k0)%nat).
  { apply H0. assert (X1 := cX_mono e (PI/2) eta 0 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
    assert (X2 := lamX_mono e (PI/2) eta 0 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
    assert (E1 : cX (PI/2) 0 = 1) by (unfold cX, lamX; rewrite sin_PI2, cos_PI2; ring).
    assert (E2 : lamX (PI/2) 0 = 0) by (unfold lamX; rewrite cos_PI2; ring). rewrite E1 in X1. rewrite E2 in X2.
    apply (coll_mono a) with (8 := Ca); try lra; nra. }
  assert (B : (b <= S k1)%nat).
  { destruct b as [|b]; [lia|]. apply le_n_S, H1, L40_one_less; [lra|].
    assert (S1 := cS_ge e eta r ltac:(lra) Heta Hr). assert (S2 := lamS_ge e eta r ltac:(lra) Heta Hr).
    apply (coll_mono (S b)) with (8 := Cb); try lra; nra. }
  lia.
Qed.

(** A ray with c >= pi k and k >= r has at most k1 collisions, one with k >= 0 at most 1 + k1. *)
Lemma steep_ray_count n c k : r <= k -> PI * k <= c -> coll r n c k -> (n <= k1)%nat.
Proof.
  intros Hk Hc H. assert (HPI : 0 < PI) by apply PI_RGT_0. apply H1.
  assert (PI * r <= PI * k) by (apply Rmult_le_compat_l; lra). assert (0 < PI * r) by (apply Rmult_lt_0_compat; lra).
  apply (coll_mono n) with (8 := H); lra.
Qed.
Lemma ascending_ray_count n c k : 0 <= k -> 0 <= c -> coll r n c k -> (n <= S k1)%nat.
Proof.
  intros Hk Hc H. destruct n as [|n]; [lia|]. apply le_n_S, H1, L40_one_less; [lra|].
  apply (coll_mono (S n)) with (8 := H); lra.
Qed.

(** L23: of two rays to the left at one place, one has a slope of at least r. *)
Lemma L23_steeper w a : 0 <= w <= 1 -> 0 <= a -> 0 < slope_den w (- a) r -> r <= a \/ r <= next_slope w (- a) r.
Proof.
  intros Hw Ha HD. destruct (Rle_or_lt r a) as [|K]; [now left | right]. apply L6b_next_slope_ge_r; try lra.
  destruct (Rle_lt_or_eq_dec 0 w) as [P|<-]; [lra | lra |]. unfold slope_den in HD. lra.
Qed.

(** L24, weak form. *)
Theorem L24_light : light_bound r (2 + k0 + k1).
Proof.
  intros e lam a b He Hlam Hl HP Ca Cb Cb0. assert (HPI : 0 < PI) by apply PI_RGT_0.
  destruct (cos_range e ltac:(lra)) as [W0 W1].
  assert (S0 : 0 <= sin e) by (apply sin_ge_0; lra).
  assert (L0 : 0 <= r * lam) by (apply Rmult_le_pos; lra).
  assert (Hc : forall k, 0 <= k -> PI * k <= cL e k) by (intros k Hk; unfold cL; assert (0 <= k * e)
    by (apply Rmult_le_pos; lra); lra).
  assert (Hc0 : forall k, 0 <= k -> 0 <= cL e k) by (intros k Hk; specialize (Hc k Hk); assert (0 <= PI * k)
    by (apply Rmult_le_pos; lra); lra).
  assert (A := ascending_ray_count a _ _ L0 (Hc0 _ L0) Ca).
  destruct (Rlt_or_le 0 (mu_den (cos e) lam r)) as [HD|HD]; [|rewrite (Cb0 HD); lia].
  specialize (Cb HD). set (k := r * mu (cos e) lam r) in *.
  assert (Hk : 0 <= k). { unfold k, mu. apply Rmult_le_pos; [lra|]. apply Rmult_le_pos; [exact HP | left;
    now apply Rinv_0_lt_compat]. }
  assert (B := ascending_ray_count b _ _ Hk (Hc0 _ Hk) Cb).
  destruct (L23_steeper (cos e) (r * lam)) as [K|K]; try lra.
  - replace (slope_den (cos e) (- (r * lam)) r) with (mu_den (cos e) lam r) by (unfold slope_den, mu_den; ring).
  exact HD.
  - assert (A2 := steep_ray_count a _ _ K (Hc _ L0) Ca). lia.
  - rewrite <- mu_next_slope in K by exact HD. fold k in K. assert (B2 := steep_ray_count b _ _ K (Hc _ Hk) Cb). lia.
Qed.
End Upper.

Theorem at_most_2_k0_k1 q k0 k1 : 1 <= q -> top_orbit q k0 -> corner_orbit q k1 -> upper_bound q (2 + k0 + k1).
Proof.
  intros Hq T C. assert (Hr := inv_ratio q Hq). assert (K : (k1 <= k0)%nat)
    by (destruct (L21_counts q k0 k1 Hq T C); lia).
  assert (HT := exactly_max _ _ _ _ T). assert (HC := exactly_max _ _ _ _ C).
  apply charts_upper; [exact Hq | now apply L22_bridge | now apply L24_light].
Qed.
