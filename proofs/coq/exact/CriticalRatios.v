(** Theorem 2 (b) and the first half of (d): for each N >= 3 there is exactly one critical ratio q_c(N) >= 1 with
    N(q) >= N iff q > q_c(N); at it N(q_c(N)) = N - 1; they increase strictly; q_c(3) = 1.

    critical N qc                            == qc is q_c(N): N(q) >= N if and only if q > qc
    theorem_2b, critical_unique, critical_increasing == there is exactly one; they increase
    N_at_critical                            == N(q_c(N)) = N - 1 *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics Ray Maximum Orbits Openness ExactMaximum Monotone Trade.
Local Open Scope R_scope.

Definition critical (N : nat) (qc : R) := 1 <= qc /\ forall q, 1 <= q -> (N_at_least q N <-> qc < q).

(** An open initial part of (0, 1] that is not empty and does not reach 1 is an interval (0, s). *)
Lemma open_initial (Q : R -> Prop) : (exists r, 0 < r <= 1 /\ Q r) -> ~ Q 1 ->
  (forall r r', 0 < r -> r <= r' -> r' <= 1 -> Q r' -> Q r) ->
  (forall r, 0 < r < 1 -> Q r -> exists r', r < r' <= 1 /\ Q r') ->
  exists s, 0 < s <= 1 /\ forall r, 0 < r <= 1 -> (Q r <-> r < s).
Proof.
  intros [r0 [Hr0 Q0]] Q1 Hdown Hup. set (E := fun r => 0 < r <= 1 /\ Q r).
  destruct (completeness E) as [s [HU HL]]. { exists 1. intros r [Hr _]. lra. } { exists r0. now split. }
  assert (S0 : r0 <= s) by (apply HU; now split). assert (S1 : s <= 1) by (apply HL; intros r [Hr _]; lra).
  exists s. split; [lra|]. intros r Hr. split.
  - intros H. destruct (Req_dec r 1) as [->|Hn]; [contradiction|]. destruct (Hup r ltac:(lra) H) as [r' [Hr' Q']].
    assert (r' <= s) by (apply HU; split; [lra | exact Q']). lra.
  - intros H. apply Classical_Prop.NNPP. intros K. assert (s <= r); [|lra]. apply HL. intros x [Hx Qx].
    destruct (Rle_or_lt x r) as [|L]; [assumption|]. exfalso. apply K. apply (Hdown r x); try lra. exact Qx.
Qed.
Lemma critical_of_interval N (Q : R -> Prop) : (forall q, 1 <= q -> (N_at_least q N <-> Q (/ q))) ->
  (exists s, 0 < s <= 1 /\ forall r, 0 < r <= 1 -> (Q r <-> r < s)) -> exists qc, critical N qc.
Proof.
  intros HN [s [Hs H]]. exists (/ s). assert (S1 : 1 <= / s) by (rewrite <- Rinv_1; apply Rinv_le_contravar; lra).
  split; [exact S1|]. intros q Hq. rewrite (HN q Hq), (H (/ q) (inv_ratio q Hq)).
  assert (Q0 : 0 < / q) by (apply Rinv_0_lt_compat; lra). split; intros K.
  - rewrite <- (Rinv_inv q). apply Rinv_lt_contravar; [apply Rmult_lt_0_compat; lra | exact K].
  - rewrite <- (Rinv_inv s). apply Rinv_lt_contravar; [apply Rmult_lt_0_compat; lra | exact K].
Qed.

Lemma top_interval k : exists s, 0 < s <= 1 /\ forall r, 0 < r <= 1 -> (coll r (S k) r 0 <-> r < s).
Proof.
  apply open_initial.
  - destruct (L30c_corner (S k)) as [r0 [H0 H]]. exists r0. split; [exact H0|].
    apply corner_above_top; [exact H0 | apply H; lra].
  - intros H. apply EqualMasses.too_high in H; [discriminate | lra | lra].
  - intros r r' H0 H1 H2. now apply top_mono.
  - intros r Hr H. destruct (L20_raise (S k) r 0 r) as [e [He G]]; try lra; [exact H|].
    exists (Rmin 1 (r + e)). assert (M1 := Rmin_l 1 (r + e)). assert (M2 := Rmin_r 1 (r + e)).
    assert (r < Rmin 1 (r + e)) by (apply Rmin_glb_lt; lra). split; [lra|]. apply G; lra.
Qed.
Lemma corner_interval k : exists s, 0 < s <= 1 /\ forall r, 0 < r <= 1 -> (coll r (S k) (PI * r) r <-> r < s).
Proof.
  assert (HPI := PI2_1). assert (HPI4 := PI_4). apply open_initial.
  - destruct (L30c_corner (S k)) as [r0 [H0 H]]. exists r0. split; [exact H0 | apply H; lra].
  - intros H. apply steep_ray_misses in H; [discriminate | lra].
  - intros r r' H0 H1 H2. now apply corner_mono.
  - intros r Hr H. assert (P : 0 < PI * r) by (apply Rmult_lt_0_compat; lra).
    destruct (L20_raise (S k) (PI * r) r r) as [e [He G]]; try lra; [exact H|].
    exists (Rmin 1 (r + e / 4)). assert (M1 := Rmin_l 1 (r + e / 4)). assert (M2 := Rmin_r 1 (r + e / 4)).
    assert (M3 : r < Rmin 1 (r + e / 4)) by (apply Rmin_glb_lt; lra). set (m := Rmin 1 (r + e / 4)) in *.
    split; [lra|].
    assert (PI * (m - r) <= 4 * (e / 4)) by (apply mul_mono; lra).
    assert (0 < PI * (m - r)) by (apply Rmult_lt_0_compat; lra). apply G; lra.
Qed.
Lemma odd_or_even N : (3 <= N)%nat -> exists k, N = (1 + 2 * S k)%nat \/ N = (2 + 2 * S k)%nat.
Proof.
  intros H. destruct (Nat.Even_or_Odd N) as [[m ->]|[m ->]].
  - exists (m - 2)%nat. right. lia.
  - exists (m - 1)%nat. left. lia.
Qed.
Theorem critical_exists N : (3 <= N)%nat -> exists qc, critical N qc.
Proof.
  intros H. destruct (odd_or_even N H) as [k [->| ->]].
  - apply (critical_of_interval _ (fun r => coll r (S k) r 0)); [|apply top_interval].
    intros q Hq. exact (odd_by_top q (S k) Hq).
  - apply (critical_of_interval _ (fun r => coll r (S k) (PI * r) r)); [|apply corner_interval].
    intros q Hq. exact (even_by_corner q (S k) Hq).
Qed.
Theorem critical_unique N a b : critical N a -> critical N b -> a = b.
Proof.
  assert (G : forall a b, critical N a -> critical N b -> a <= b).
  { clear a b. intros a b [A HA] [B HB]. apply Rnot_lt_le. intros L. assert (L2 : b < (a + b) / 2 < a) by lra.
    assert (K := proj2 (HB ((a + b) / 2) ltac:(lra)) ltac:(lra)). apply (HA ((a + b) / 2) ltac:(lra)) in K. lra. }
  intros HA HB. apply Rle_antisym; now apply G.
Qed.

(** L26: with r increased by a fixed part of itself each orbit still has as many collisions as the one after it. *)
Lemma corner_to_top k r p : 0 < r -> r + p <= 1 -> 0 <= p -> 4 * 2 ^ k * p <= r * r ->
  coll r k (PI * r) r -> coll (r + p) k (r + p) 0.
Proof.
  intros Hr Hr1 Hp H4 H. assert (HPI := PI2_3_2). assert (P2 := pow_R1_Rle 2 k ltac:(lra)).
  assert (K : 4 * p <= r) by nra. assert (3 * r <= PI * r) by (apply Rmult_le_compat_r; lra).
  apply (trade k (r + p) 0 r r p); try lra. apply (coll_mono k) with (8 := H); lra.
Qed.
Lemma top_to_corner k r p : 0 < r -> r + p <= 1 -> 0 <= p -> 8 * 2 ^ k * p <= r * r ->
  coll r (S k) r 0 -> coll (r + p) k (PI * (r + p)) (r + p).
Proof.
  intros Hr Hr1 Hp H4 [x [Hx H]]. assert (HPI := PI2_3_2). assert (P2 := pow_R1_Rle 2 k ltac:(lra)).
  assert (K : 8 * p <= r) by nra. destruct H as [->|[HD H]]; [exact I|]. cbv zeta in H.
  destruct (next_domain r 0 r x Hr ltac:(lra) Hx HD) as [Q1 Q2]. cbv zeta in Q1, Q2. destruct Hx as [X1 [X2 X3]].
  assert (G := next_slope_grows (cos x) 0 r ltac:(destruct (COS_bound x); lra) Hr HD).
  set (k' := next_slope (cos x) 0 r) in *.
  assert (S0 : 0 <= sin x) by (apply sin_ge_0; lra). assert (0 <= PI * (r + p)) by (apply Rmult_le_pos; lra).
  assert (PI * (2 * r) <= k' * (x + PI)) by (rewrite (Rmult_comm PI); apply mul_mono; lra).
  assert (3 * (r - p) <= PI * (r - p)) by (apply Rmult_le_compat_r; lra).
  apply (trade k (PI * (r + p)) (r + p) r (r/2) p); try lra. apply (coll_mono k) with (8 := H); lra.
Qed.
(** A smaller r from which p leads to r. *)
Lemma step_back k r : 0 < r <= 1 -> exists p, 0 < p /\ 0 < r - p /\ 8 * 2 ^ k * p <= (r - p) * (r - p).
Proof.
  intros Hr. assert (P2 := pow_R1_Rle 2 k ltac:(lra)). set (t := 2 ^ k) in *. exists (r * r / (32 * t)).
  assert (E : 32 * t * (r * r / (32 * t)) = r * r) by (field; lra). set (p := r * r / (32 * t)) in *.
  assert (P0 : 0 < p) by (apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; lra | lra]).
  assert (Hrr : r * r <= r * 1) by (apply Rmult_le_compat_l; lra). assert (32 * p <= 32 * t * p) by nra.
  assert (r / 2 * (r / 2) <= (r - p) * (r - p)) by (apply Rmult_le_compat; lra). split; [exact P0|]. split; lra.
Qed.

(** N(q_c(N)) = N - 1: N grows by steps of one. *)
Lemma below_limit q p : 1 <= q -> 0 < p -> 0 < / q - p -> 1 <= / (/ q - p) /\ q < / (/ q - p) /\
  / / (/ q - p) = / q - p.
Proof.
  intros Hq Hp H. destruct (inv_ratio q Hq) as [R0 R1].
  assert (L : q < / (/ q - p)).
  { rewrite <- (Rinv_inv q) at 1. apply Rinv_lt_contravar; [apply Rmult_lt_0_compat; lra | lra]. }
  split; [lra|]. split; [exact L | apply Rinv_inv].
Qed.
Theorem critical_at_least N qc : (3 <= N)%nat -> critical N qc -> N_at_least qc (N - 1).
Proof.
  intros H [Hq Hc]. assert (Hr := inv_ratio qc Hq). destruct (odd_or_even N H) as [k [->| ->]].
  - destruct (step_back (S k) (/ qc) Hr) as [p [P0 [P1 P2]]]. destruct (below_limit qc p Hq P0 P1) as [B1 [B2 B3]].
    replace (1 + 2 * S k - 1)%nat with (2 + 2 * k)%nat by lia. apply (even_by_corner qc k Hq).
    replace (/ qc) with (/ qc - p + p) by ring. apply top_to_corner; try lra.
    + assert (Pk := pow_R1_Rle 2 k ltac:(lra)). simpl in P2. nra.
    + rewrite <- B3. apply (odd_by_top _ (S k) B1). now apply Hc.
  - destruct (step_back (S k) (/ qc) Hr) as [p [P0 [P1 P2]]]. destruct (below_limit qc p Hq P0 P1) as [B1 [B2 B3]].
    replace (2 + 2 * S k - 1)%nat with (1 + 2 * S k)%nat by lia. apply (odd_by_top qc (S k) Hq).
    replace (/ qc) with (/ qc - p + p) by ring. apply corner_to_top; try lra.
    + assert (Pk := pow_R1_Rle 2 (S k) ltac:(lra)). nra.
    + rewrite <- B3. apply (even_by_corner _ (S k) B1). now apply Hc.
Qed.
Theorem N_at_critical N qc : (3 <= N)%nat -> critical N qc -> N_star qc (N - 1).
Proof.
  intros H Hc. destruct (critical_at_least N qc H Hc) as [n [Hn L]]. destruct Hc as [Hq Hc].
  destruct (Nat.eq_dec n (N - 1)) as [<-|Hne]; [exact Hn|]. exfalso.
  assert (K : qc < qc); [|lra]. apply (Hc qc Hq). exists n. split; [exact Hn | lia].
Qed.
Theorem critical_increasing N a b : (3 <= N)%nat -> critical N a -> critical (S N) b -> a < b.
Proof.
  intros H Ha Hb. assert (K := N_at_critical (S N) b ltac:(lia) Hb). destruct Hb as [B _]. apply (proj2 Ha b B).
  exists (S N - 1)%nat. split; [exact K | lia].
Qed.

(** Theorem 2 (b). *)
Theorem theorem_2b N : (3 <= N)%nat -> exists! qc, critical N qc.
Proof.
  intros H. destruct (critical_exists N H) as [qc Hc]. exists qc. split; [exact Hc|]. intros q Hq.
  now apply (critical_unique N).
Qed.
(** Theorem 2 (d), q_c(3) = 1. *)
Theorem critical_3 : critical 3 1.
Proof.
  split; [lra|]. intros q Hq. rewrite (odd_by_top q 1 Hq). destruct (inv_ratio q Hq) as [R0 R1].
  assert (HPI := PI2_1). split.
  - intros H. destruct (Req_dec q 1) as [->|Hn]; [|lra]. rewrite Rinv_1 in H.
    apply EqualMasses.too_high in H; [discriminate | lra | lra].
  - intros L. assert (/ q < 1) by (rewrite <- Rinv_1; apply Rinv_lt_contravar; lra).
    destruct (hit_exists (/ q) 0 (PI/2)) as [x [Hx _]]; try lra; [rewrite sin_PI2; lra|].
    exists x. split; [exact Hx | now left].
Qed.
