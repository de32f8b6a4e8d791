(** L15, the counts: the later collisions of a state that leaves the wall R, and what a cover of all first collisions
    has to show. No physics. A steep flight has no later collision; one steeper than the bridge is a ray.

    height_at                      == the height of a state's flight at an angle t
    meets_bridge, clears_bridge    == it comes down on the bridge at t; it does not
    contact_num, contact_den       == the slope after a contact with the bridge, as a fraction
    forward r n x k                == the state at x with the slope k may have n later collisions
    contact_bound, departure_bound == all points of the two charts have at most U *)
From Coq Require Import Reals Lra Lia.
From Dumbbell Require Import Ray Chart.
Local Open Scope R_scope.

(** A flight that leaves R to the left, at the corner distance x with the slope k: its height at psi = pi/2 - t. *)
Definition height_at (x k t : R) := sin x + k * (x + t).
(** It meets the bridge at t; or it is never below the bridge. *)
Definition meets_bridge (r x k t : R) := 0 < t < PI /\ height_at x k t = r * sin t /\ k < r * cos t.
Definition clears_bridge (r x k : R) := forall t, 0 <= t <= PI -> r * sin t <= height_at x k t.

(** What a contact with the bridge makes of the slope k, s being cos t: where the one is positive, a ray to the left
    leaves whose slope is the other divided by it. *)
Definition contact_den (s k r : R) := 1 + 2 * (s * k) - r * (s * s).
Definition contact_num (s k r : R) := 2 * (r * s) - k * (1 - r * (s * s)).
(** At least n collisions after it. L15 uses of a contact that the ray leaves the bridge to the left, L16 its slope. *)
Fixpoint forward (r : R) (n : nat) (x k : R) : Prop :=
  match n with
  | O => True
  | S m =>
      (exists t, meets_bridge r x k t /\
         (m = O \/ exists eta, 0 < eta /\ 0 < contact_den (cos t) k r /\
            r * lamX t eta * contact_den (cos t) k r = contact_num (cos t) k r /\
            coll r m (r * cX t eta) (r * lamX t eta))) \/
      (clears_bridge r x k /\ exists y, 0 < y /\ hit (height_at x k PI) k y /\
         (m = O \/ (0 < slope_den (cos y) k r /\ forward r m y (next_slope (cos y) k r))))
  end.

(** The charts contact and departure: what their covers have to show. *)
Definition contact_bound r U := forall t eta a, 0 < t < PI -> 0 < eta ->
  coll r a (r * cX t eta) (r * lamX t eta) -> (1 + a <= U)%nat.
Definition departure_bound r U := forall e eta a, 0 < e <= PI/2 -> 0 < eta ->
  forward r a e (eta - cos e) -> (1 + a <= U)%nat.

(** A reflection leaves the wall. *)
Lemma next_leaves w k r : 0 < w * w + r -> k < w -> 0 < slope_den w k r -> - w < next_slope w k r.
Proof.
  intros Hq Hk HD. unfold next_slope. apply Rmult_lt_reg_r with (slope_den w k r); [exact HD|].
  unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
  assert (0 < (w * w + r) * (w - k)) by (apply Rmult_lt_0_compat; lra). unfold slope_num, slope_den in *. lra.
Qed.

(** L3: no later collision. *)
Lemma forward_steep r n x k : 0 < r <= 1 -> 1 <= k -> forward r n x k -> n = O.
Proof.
  intros Hr Hk. destruct n as [|n]; [easy|]. intros [[t [[_ [_ Ht]] _]]|[_ [y [_ [[_ [_ Hy]] _]]]]].
  - destruct (COS_bound t). assert (r * cos t <= r * 1) by (apply Rmult_le_compat_l; lra). lra.
  - destruct (COS_bound y). lra.
Qed.
(** As steep as the bridge, it never meets it: it is a ray. *)
Lemma forward_is_ray r n : 0 < r <= 1 -> forall x k, 0 <= x <= PI/2 -> r <= k -> forward r n x k ->
  coll r n (height_at x k PI) k.
Proof.
  intros Hr. induction n as [|n IH]; [easy|]. intros x k Hx Hk [[t [[_ [_ Ht]] _]]|[_ [y [_ [Hy Hn]]]]].
  - destruct (COS_bound t). assert (r * cos t <= r * 1) by (apply Rmult_le_compat_l; lra). lra.
  - exists y. split; [exact Hy|]. destruct Hn as [Hn|[HD Hn]]; [now left | right]. split; [exact HD|].
    destruct (next_domain (height_at x k PI) k r y ltac:(lra) ltac:(lra) Hy HD) as [K _]. simpl.
    apply IH; [destruct Hy; lra | exact K | exact Hn].
Qed.
