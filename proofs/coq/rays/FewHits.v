(** L4 (a): the hit of a ray is unique. L5 (f): slopes grow by 2 r at least from hit to hit, and a ray of slope 1 hits
    nothing, so that a ray has few hits.

    hit_unique                               == a ray has one first hit
    L5f_bounded, L5f_bounded_below_zero, L5f_few_both == so many collisions and no more, as slopes grow by 2 r *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Ray.
Local Open Scope R_scope.

(** L4 (a): the hit is unique. *)
Lemma hit_unique c k x x' : hit c k x -> hit c k x' -> x = x'.
Proof.
  assert (G : forall x x', hit c k x -> hit c k x' -> x < x' -> False).
  { clear x x'. intros x x' [H1 [H2 H3]] [K1 [K2 K3]] L. assert (HPI : 0 < PI) by apply PI_RGT_0.
    assert (T := sin_below_tangent x' x ltac:(lra) ltac:(lra)).
    assert (0 < (x' - x) * (cos x' - k)) by (apply Rmult_lt_0_compat; lra). lra. }
  intros H K. destruct (Rtotal_order x x') as [L|[L|L]];
    [exfalso; now apply (G x x') | exact L | exfalso; now apply (G x' x)].
Qed.

(** L5 (f): slopes k, k + 2 r, ... below 1. *)
Lemma L5f_slopes_grow r n : 0 < r -> forall c k, 0 <= k -> coll r (S n) c k -> k + 2 * r * INR n < 1.
Proof.
  intros Hr. induction n as [|n IH]; intros c k Hk [x [[Hx [_ Hkx]] H]]; destruct (COS_bound x).
  - simpl INR. lra.
  - destruct H as [H|[HD H]]; [discriminate|]. assert (W := cos_pos x Hx).
    assert (G := next_slope_grows (cos x) k r ltac:(lra) Hr HD). assert (G0 : 0 <= next_slope (cos x) k r) by lra.
    specialize (IH _ _ G0 H). rewrite S_INR. lra.
Qed.
Theorem L5f_bounded r : 0 < r -> exists M, forall n c k, 0 <= k -> coll r n c k -> (n <= M)%nat.
Proof.
  intros Hr. assert (H0 : 0 <= / (2 * r)) by (left; apply Rinv_0_lt_compat; lra).
  destruct (nfloor_ex (/ (2 * r)) H0) as [m Hm]. exists (S m). intros [|n] c k Hk H; [lia|].
  assert (F := L5f_slopes_grow r n Hr c k Hk H). assert (E : 2 * r * / (2 * r) = 1) by (field; lra).
  assert (INR n < INR m + 1).
  { apply Rmult_lt_reg_l with (2 * r); [lra|].
    assert (2 * r * / (2 * r) < 2 * r * (INR m + 1)) by (apply Rmult_lt_compat_l; lra). lra. }
  rewrite <- S_INR in H1. apply INR_lt in H1. lia.
Qed.
Theorem L5f_bounded_below_zero r : 0 < r -> exists M, forall n c k, - r <= k -> coll r n c k -> (n <= M)%nat.
Proof.
  intros Hr. destruct (L5f_bounded r Hr) as [M HM]. exists (S M). intros [|n] c k Hk H; [lia|].
  destruct H as [x [Hx [->|[HD H]]]]; [lia|].
  destruct (next_domain c k r x Hr Hk Hx HD) as [Q1 _]. assert (n <= M)%nat; [|lia].
  apply (HM n _ _ ltac:(assert (0 <= next_slope (cos x) k r) by lra; eassumption) H).
Qed.

Lemma L5f_few_hits r n : 0 < r <= 1 -> forall c k, - r <= k -> coll r n c k -> 2 * r * INR n < 1 + 4 * r.
Proof.
  intros Hr c k Hk H. destruct (Rle_or_lt 0 k) as [K|K].
  - destruct n as [|n]; [simpl INR; lra|]. assert (F := L5f_slopes_grow r n ltac:(lra) c k K H). rewrite S_INR. lra.
  - destruct n as [|[|n]]; [simpl INR; lra | simpl INR; lra|]. destruct H as [x [Hx [H|[HD H]]]]; [discriminate|].
    destruct (next_domain c k r x ltac:(lra) Hk Hx HD) as [Q _].
    assert (F := L5f_slopes_grow r n ltac:(lra) _ _ ltac:(assert (0 <= next_slope (cos x) k r) by lra; eassumption) H).
    rewrite !S_INR. lra.
Qed.
Lemma L5f_few_both r a b n ca ka cb kb : 0 < r <= 1 -> / r + 4 <= INR n -> - r <= ka -> - r <= kb -> coll r a ca ka ->
  coll r b cb kb -> (1 + a + b <= n)%nat.
Proof.
  intros Hr Hn Ha Hb Ca Cb. assert (A := L5f_few_hits r a Hr ca ka Ha Ca).
  assert (B := L5f_few_hits r b Hr cb kb Hb Cb).
  assert (K : INR (1 + a + b) < INR (n + 1)).
  { rewrite !plus_INR. simpl (INR 1). assert (2 * r * (/ r + 4) <= 2 * r * INR n) by (apply Rmult_le_compat_l; lra).
    replace (2 * r * (/ r + 4)) with (2 + 8 * r) in H by (field; lra). apply Rmult_lt_reg_l with (2 * r); lra. }
  apply INR_lt in K. lia.
Qed.
