(** Theorem B of law.md from bounds of delta_N = C sqrt (q_c(N)) - (N - 2), and these for N <= 902 from the conditions
    (C1) to (C4).

    growth_value, c0_value == decimals of C and c0
    law_mono         == both sides of the law grow with q
    law_from_delta   == 0 < delta_N < c0 q^(-1/4) for N >= 9 gives the law
    everywhere_from_delta == -0.115 <= delta_N <= 0.020 for N >= 3 gives its second half
    critical_between == (C1) encloses the critical ratio
    steps_delta      == what the conditions say of N <= 902
    above_a_million  == (C2): q_c(903) > 10^6 *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Dumbbell Require Import Statement Maximum EqualMasses ExactMaximum CriticalRatios LawStatement Cubes.
Local Open Scope R_scope.

Lemma growth_value : 0.885 <= growth <= 0.886.
Proof. unfold growth. split; integral. Qed.
Lemma c0_value : 0.17 <= law_constant <= 0.22.
Proof.
  unfold law_constant. destruct k0_value as [K1 K2], Series_value as [S1 S2].
  assert (A : 0.0825 * 1.07 <= step_constant * Series cube) by (apply Rmult_le_compat; lra).
  assert (B : step_constant * Series cube <= 0.0826 * 1.33) by (apply Rmult_le_compat; lra). lra.
Qed.
Lemma quarter_falls p q : 0 < p -> p <= q -> 0 < quarter q <= quarter p.
Proof.
  intros Hp Hq. unfold quarter. assert (0 < sqrt p) by now apply sqrt_lt_R0.
  assert (sqrt p <= sqrt q) by (apply sqrt_le_1; lra). assert (0 < sqrt (sqrt p)) by now apply sqrt_lt_R0.
  assert (sqrt (sqrt p) <= sqrt (sqrt q)) by (apply sqrt_le_1; lra).
  split; [apply Rinv_0_lt_compat | apply Rinv_le_contravar]; lra.
Qed.
(** Both sides of the law grow with q. *)
Lemma law_mono a b : 0 < a -> a <= b ->
  growth * sqrt a <= growth * sqrt b /\ law_constant * quarter b <= law_constant * quarter a.
Proof.
  intros Ha Hab. destruct growth_value, c0_value, (quarter_falls a b Ha Hab).
  split; apply Rmult_le_compat_l; try lra. apply sqrt_le_1; lra.
Qed.
Lemma floor_below x n : x < IZR n + 1 -> (Int_part x <= n)%Z.
Proof. intros H. destruct (base_Int_part x) as [A _]. apply Z.lt_succ_r, lt_IZR. rewrite succ_IZR. lra. Qed.
Lemma floor_above x n : IZR n <= x -> (n <= Int_part x)%Z.
Proof. intros H. destruct (base_Int_part x) as [_ A]. apply Z.lt_succ_r, lt_IZR. rewrite succ_IZR. lra. Qed.

(** A ratio q > 1 lies above one critical ratio, of N = N(q), and not above the next. *)
Lemma between_critical q N : 1 < q -> N_star q N -> (3 <= N)%nat /\
  exists a b, critical N a /\ critical (S N) b /\ a < q <= b.
Proof.
  intros Hq HN. assert (N3 : (3 <= N)%nat).
  { destruct (proj2 (proj2 critical_3 q ltac:(lra)) Hq) as [m [Hm M]]. now rewrite (N_unique q N m ltac:(lra) HN Hm).
    }
  split; [exact N3|]. destruct (theorem_2b N N3) as [a [Ha _]]. destruct (theorem_2b (S N) ltac:(lia)) as [b [Hb _]].
  exists a, b. split; [exact Ha|]. split; [exact Hb|]. split.
  - apply (proj2 Ha); [lra | now exists N].
  - apply Rnot_lt_le. intros K. destruct (proj2 (proj2 Hb q ltac:(lra)) K) as [m [Hm M]].
    rewrite (N_unique q m N ltac:(lra) Hm HN) in M. lia.
Qed.
Lemma from_critical q q9 : critical 9 q9 -> from_nine q -> q9 <= q.
Proof.
  intros H9 [Hq H]. apply Rnot_lt_le. intros K. destruct (N_exists ((q + q9) / 2) ltac:(lra)) as [n [Hn _]].
  assert (L := H ((q + q9) / 2) n ltac:(lra) Hn). assert (q9 < (q + q9) / 2); [|lra].
  apply (proj2 H9 ((q + q9) / 2) ltac:(lra)). now exists n.
Qed.

Theorem law_from_delta :
  (forall N q, (9 <= N)%nat -> critical N q -> 0 < delta N q < law_constant * quarter q) -> the_law.
Proof.
  intros H q N From HN. destruct (theorem_2b 9 ltac:(lia)) as [q9 [H9 _]]. assert (Hq := from_critical q q9 H9 From).
  assert (Q9 : 1 <= q9) by apply H9. destruct (H 9%nat q9 (le_n _) H9) as [D9 D9']. unfold delta in D9, D9'.
  set (low := growth * sqrt q - law_constant * quarter q).
  assert (K : INR N - 2 <= growth * sqrt q /\ low < INR N - 1).
  { destruct (Rle_lt_or_eq_dec _ _ Hq) as [Lt|<-].
    - destruct (between_critical q N ltac:(lra) HN) as [N3 [a [b [Ha [Hb AB]]]]].
      assert (N9 : (9 <= N)%nat).
      { destruct (proj2 (proj2 H9 q ltac:(lra)) Lt) as [m [Hm M9]]. now rewrite (N_unique q N m ltac:(lra) HN Hm). }
      destruct (H N a N9 Ha) as [DA _]. destruct (H (S N) b ltac:(lia) Hb) as [_ DB]. assert (A1 := proj1 Ha).
      destruct (law_mono a q ltac:(lra) ltac:(lra)) as [M1 _].
      destruct (law_mono q b ltac:(lra) ltac:(lra)) as [M2 M3].
      unfold delta in DA, DB. rewrite S_INR in DB. unfold low. lra.
    - assert (E := N_unique q9 N 8 ltac:(lra) HN (N_at_critical 9 q9 ltac:(lia) H9)). subst N. unfold low.
      simpl INR in *. lra. }
  rewrite INR_IZR_INZ in K. destruct K as [K1 K2]. split.
  - assert (Int_part low <= Z.of_nat N - 2)%Z; [|lia]. apply floor_below. rewrite minus_IZR. lra.
  - assert (Z.of_nat N - 2 <= Int_part (growth * sqrt q))%Z; [|lia]. apply floor_above. rewrite minus_IZR. lra.
Qed.
Theorem everywhere_from_delta :
  (forall N q, (3 <= N)%nat -> critical N q -> -0.115 <= delta N q <= 0.020) -> law_everywhere.
Proof.
  intros H q N Hq HN. destruct growth_value. destruct (Req_dec q 1) as [->|Hne].
  - rewrite (N_unique 1 N 2 ltac:(lra) HN L7_equal_masses), sqrt_1. simpl INR. lra.
  - destruct (between_critical q N ltac:(lra) HN) as [N3 [a [b [Ha [Hb AB]]]]].
    destruct (H N a N3 Ha) as [DA _]. destruct (H (S N) b ltac:(lia) Hb) as [_ DB]. assert (A1 := proj1 Ha).
    destruct (law_mono a q ltac:(lra) ltac:(lra)) as [M1 _]. destruct (law_mono q b ltac:(lra) ltac:(lra)) as [M2 _].
    unfold delta in DA, DB. rewrite S_INR in DB. lra.
Qed.

(** (C1) encloses the critical ratio, (C3) and (C4) say where. *)
Lemma critical_between N q a b : critical N q -> 1 <= a -> 1 <= b ->
  (forall n, N_star a n -> (n < N)%nat) -> (forall n, N_star b n -> (N <= n)%nat) -> a <= q < b.
Proof.
  intros [Hq Hc] A1 B1 Ha Hb. split.
  - apply Rnot_lt_le. intros K. destruct (proj2 (Hc a A1) K) as [n [Hn L]]. specialize (Ha n Hn). lia.
  - destruct (N_exists b B1) as [n [Hn _]]. apply (Hc b B1). exists n. split; [exact Hn | now apply Hb].
Qed.
Theorem steps_delta N q : steps -> (3 <= N <= 902)%nat -> critical N q ->
  ((9 <= N)%nat -> 0 < delta N q < law_constant * quarter q) /\ -0.115 <= delta N q <= 0.020.
Proof.
  intros H HN Hc. destruct (H N HN) as [a [b [A1 [B1 [Ha [Hb [C3 C4]]]]]]].
  destruct (critical_between N q a b Hc A1 B1 Ha Hb) as [Q1 Q2]. unfold delta.
  destruct (law_mono a q ltac:(lra) Q1) as [M1 _]. destruct (law_mono q b ltac:(lra) ltac:(lra)) as [M2 M3].
  split; [intros H9; destruct (C3 H9) as [X Y]; lra | lra].
Qed.
(** (C2), which (C3) implies. *)
Theorem above_a_million q : steps -> critical 903 q -> 1000000 < q.
Proof.
  intros H Hc. destruct (theorem_2b 902 ltac:(lia)) as [p [Hp _]].
  assert (L := critical_increasing 902 p q ltac:(lia) Hp Hc).
  destruct (steps_delta 902 p H ltac:(lia) Hp) as [D _]. destruct (D ltac:(lia)) as [D1 _]. unfold delta in D1.
  destruct growth_value as [_ G]. assert (P1 := proj1 Hp). assert (S := sqrt_pos p).
  assert (E : INR 902 = 902) by (rewrite INR_IZR_INZ; reflexivity). rewrite E in D1.
  assert (growth * sqrt p <= 0.886 * sqrt p) by (apply Rmult_le_compat_r; lra).
  assert (Q : 1000 <= sqrt p) by lra. apply Rle_lt_trans with (2 := L). rewrite <- (sqrt_sqrt p) by lra.
  replace 1000000 with (1000 * 1000) by ring. apply Rmult_le_compat; lra.
Qed.
