(** The two orbits whose counts give the maximum (theorem.md, Theorem 1, L21): the horizontal ray (r, 0) over the
    top of the bridge, with k0 collisions, and the ray (pi r, r) out of a corner along the bridge's tangent, with
    k1. Both counts exist, and k1 <= k0 <= 1 + k1.

    top_orbit q n, corner_orbit q n == n is k0, is k1: the orbit's number of collisions
    orbits_exist, L21_counts        == both exist; k1 <= k0 <= 1 + k1
    exactly, exactly_max            == the ray has n collisions and no more
    inv_ratio                       == 0 < 1/q <= 1 *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Ray FewHits.
Local Open Scope R_scope.

(** The ray (c, k) has n collisions, and no more: G(c, k, r) = n. *)
Definition exactly (r : R) (n : nat) (c k : R) := coll r n c k /\ ~ coll r (S n) c k.
Definition top_orbit (q : R) (n : nat) := exactly (/ q) n (/ q) 0.
Definition corner_orbit (q : R) (n : nat) := exactly (/ q) n (PI * / q) (/ q).

Lemma exactly_max r n c k : exactly r n c k -> forall m, coll r m c k -> (m <= n)%nat.
Proof.
  intros [_ H] m Hm. destruct (Nat.le_gt_cases m n) as [|L]; [assumption|exfalso]. apply H. now apply coll_le with m.
Qed.
Lemma exactly_unique r m n c k : exactly r m c k -> exactly r n c k -> m = n.
Proof.
  intros Hm Hn. assert (A := exactly_max r n c k Hn m (proj1 Hm)).
  assert (B := exactly_max r m c k Hm n (proj1 Hn)). lia.
Qed.
Lemma exactly_exists r c k : 0 < r -> 0 <= k -> exists n, exactly r n c k.
Proof.
  intros Hr Hk. destruct (L5f_bounded r Hr) as [M HM].
  assert (G : forall m, ~ coll r m c k -> exists n, exactly r n c k).
  { induction m as [|m IH]; intros Hm; [exfalso; apply Hm; exact I|].
    destruct (Classical_Prop.classic (coll r m c k)) as [K|K]; [exists m; now split | now apply IH]. }
  apply (G (S M)). intros H. specialize (HM (S M) c k Hk H). lia.
Qed.
Lemma exactly_from_max r n c k : 0 < r -> 0 <= k -> coll r n c k -> (forall m, coll r m c k -> (m <= n)%nat) ->
  exactly r n c k.
Proof. intros Hr Hk H Hm. split; [exact H|]. intros K. apply Hm in K. lia. Qed.

Lemma inv_ratio q : 1 <= q -> 0 < / q <= 1.
Proof. intros Hq. split; [apply Rinv_0_lt_compat; lra|]. rewrite <- Rinv_1. apply Rinv_le_contravar; lra. Qed.
Theorem orbits_exist q : 1 <= q -> exists k0 k1, top_orbit q k0 /\ corner_orbit q k1.
Proof.
  intros Hq. destruct (inv_ratio q Hq) as [R0 R1]. destruct (exactly_exists (/ q) (/ q) 0 R0 ltac:(lra)) as [k0 H0].
  destruct (exactly_exists (/ q) (PI * / q) (/ q) R0 ltac:(lra)) as [k1 H1]. exists k0, k1. now split.
Qed.

(** L40 (a): the ray (0, -r) collides at once, at the corner, and goes on as the corner orbit. *)
Lemma descending_ray_first r : 0 < r -> hit 0 (- r) 0 /\ slope_den (cos 0) (- r) r = 1 + r /\
  next_slope (cos 0) (- r) r = r.
Proof.
  intros Hr. assert (HPI : 0 < PI) by apply PI_RGT_0. unfold hit, next_slope, slope_den, slope_num.
  rewrite sin_0, cos_0.
  repeat split; try lra; field; lra.
Qed.
Lemma L40_one_more r n : 0 < r -> coll r n (PI * r) r -> coll r (S n) 0 (- r).
Proof.
  intros Hr H. destruct (descending_ray_first r Hr) as [A [B C]]. exists 0. split; [exact A|right]. rewrite B, C.
  split; [lra|]. cbv zeta.
  replace (sin 0 + r * (0 + PI)) with (PI * r) by (rewrite sin_0; ring). exact H.
Qed.
Lemma L40_one_less r n : 0 < r -> coll r (S n) 0 (- r) -> coll r n (PI * r) r.
Proof.
  intros Hr [x [[Hx [Hs _]] H]]. assert (HPI : 0 < PI) by apply PI_RGT_0. destruct H as [->|[_ H]]; [exact I|].
  assert (E : x = 0).
  { destruct (Rle_lt_or_eq_dec 0 x) as [P|P]; [lra | | auto]. exfalso. assert (0 < sin x)
    by (apply sin_gt_0; lra). nra. }
  subst x. destruct (descending_ray_first r Hr) as [_ [_ C]]. rewrite C in H. cbv zeta in H.
  replace (sin 0 + r * (0 + PI)) with (PI * r) in H by (rewrite sin_0; ring). exact H.
Qed.

(** L21, the two ends of it: k1 <= k0 <= 1 + k1. *)
Lemma corner_above_top r n : 0 < r <= 1 -> coll r n (PI * r) r -> coll r n r 0.
Proof. intros Hr H. assert (HPI := PI2_1). apply (coll_mono n) with (8 := H); try lra. nra. Qed.
Lemma top_above_descending r n : 0 < r <= 1 -> coll r (S n) r 0 -> coll r n (PI * r) r.
Proof. intros Hr H. apply L40_one_less; [lra|]. apply (coll_mono (S n)) with (8 := H); lra. Qed.
Theorem L21_counts q k0 k1 : 1 <= q -> top_orbit q k0 -> corner_orbit q k1 -> k0 = k1 \/ k0 = S k1.
Proof.
  intros Hq H0 H1. assert (Hr := inv_ratio q Hq).
  assert (A : (k1 <= k0)%nat) by (apply (exactly_max _ _ _ _ H0), corner_above_top; [exact Hr | apply H1]).
  assert (B : (k0 <= S k1)%nat); [|lia]. destruct k0 as [|n]; [lia|].
  apply le_n_S, (exactly_max _ _ _ _ H1), top_above_descending; [exact Hr | apply H0].
Qed.
