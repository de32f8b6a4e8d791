(** What the steps and Theorem A say of one mass ratio (L56 of law.md),
  and Theorem 4 of theorem.md: N/sqrt q tends to C.

    L56_early  == 3 <= N <= 902: the enclosed critical ratio decides
    L56_late   == N >= 903: two inequalities decide
    growth_law == N*(q)/sqrt q tends to C *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Statement Maximum ExactMaximum CriticalRatios LawStatement Cubes TheoremB TheoremA Law.
Local Open Scope R_scope.

(** N*(q) >= N above the critical ratio, N*(q) < N up to it. *)
Lemma by_critical N q c n : critical N c -> 1 <= q -> N_star q n -> (c < q -> (N <= n)%nat) /\ (q <= c ->
  (n < N)%nat).
Proof.
  intros [Hc H] Hq Hn. split.
  - intros L. destruct (proj2 (H q Hq) L) as [m [Hm M]]. now rewrite (N_unique q n m ltac:(lra) Hn Hm).
  - intros L. destruct (Nat.le_gt_cases N n) as [K|K]; [|exact K]. exfalso.
    assert (c < q); [|lra]. apply (H q Hq). now exists n.
Qed.
Theorem L56_early N a b q n : (3 <= N)%nat -> 1 <= a -> 1 <= b -> (forall n, N_star a n -> (n < N)%nat) ->
  (forall n, N_star b n -> (N <= n)%nat) -> 1 <= q -> N_star q n -> (b <= q -> (N <= n)%nat) /\ (q <= a ->
    (n < N)%nat).
Proof.
  intros HN Ha Hb A B Hq Hn. destruct (theorem_2b N HN) as [c [Hc _]].
  destruct (critical_between N c a b Hc Ha Hb A B) as [L1 L2]. destruct (by_critical N q c n Hc Hq Hn) as [X Y].
  split; intros K; [apply X | apply Y]; lra.
Qed.

(** C sqrt x - c0 x^(-1/4) grows faster than the last terms of Theorem A fall. *)
Definition late (N : nat) (k : R -> R) x := growth * sqrt x - (INR N - 2) - law_constant * quarter x + k x.
Lemma late_grows N k x y : 1 <= x -> x < y -> k x - k y <= 0.8 * (sqrt y - sqrt x) -> late N k x < late N k y.
Proof.
  intros Hx Hxy Hk. unfold late. destruct (law_mono x y ltac:(lra) ltac:(lra)) as [_ B].
  destruct growth_value as [G _]. assert (S : sqrt x < sqrt y) by (apply sqrt_lt_1; lra).
  assert (0.885 * (sqrt y - sqrt x) <= growth * (sqrt y - sqrt x)) by (apply Rmult_le_compat_r; lra). lra.
Qed.
Lemma inverse_roots x y : 1 <= x -> x < y -> 1 <= sqrt x < sqrt y /\ / sqrt x - / sqrt y <= (sqrt y - sqrt x) / x.
Proof.
  intros Hx Hy. assert (A : 1 <= sqrt x) by (rewrite <- sqrt_1; apply sqrt_le_1; lra).
  assert (B : sqrt x < sqrt y) by (apply sqrt_lt_1; lra). split; [lra|].
  replace (/ sqrt x - / sqrt y) with ((sqrt y - sqrt x) / (sqrt x * sqrt y)) by (field; lra).
  apply Rmult_le_compat_l; [lra|]. apply Rinv_le_contravar; [lra|]. rewrite <- (sqrt_sqrt x) at 1 by lra.
  apply Rmult_le_compat_l; lra.
Qed.
Lemma first_term x y : 1 <= x -> x < y -> 0.16 * / sqrt x - 0.16 * / sqrt y <= 0.8 * (sqrt y - sqrt x).
Proof.
  intros Hx Hy. destruct (inverse_roots x y Hx Hy) as [A B].
  assert ((sqrt y - sqrt x) / x <= (sqrt y - sqrt x) / 1)
    by (apply Rmult_le_compat_l; [|apply Rinv_le_contravar]; lra). lra.
Qed.
Lemma second_term x y : 1 <= x -> x < y ->
  (0.063 * ln x + 0.7) * / sqrt x - (0.063 * ln y + 0.7) * / sqrt y <= 0.8 * (sqrt y - sqrt x).
Proof.
  intros Hx Hy. destruct (inverse_roots x y Hx Hy) as [A B]. set (g := sqrt y - sqrt x) in *.
  assert (L0 : 0 <= ln x) by (rewrite <- ln_1; apply ln_le; lra).
  assert (L1 : ln x < ln y) by (apply ln_increasing; lra).
  assert (L2 : ln x <= x).
  { assert (H := exp_ineq1_le (x - 1)). apply ln_le in H; [|lra]. rewrite ln_exp in H.
    replace (1 + (x - 1)) with x in H by ring. lra. }
  assert (Y : 0 < / sqrt y) by (apply Rinv_0_lt_compat; lra). assert (X : 0 < / x <= 1) by (split;
    [apply Rinv_0_lt_compat; lra | rewrite <- Rinv_1; apply Rinv_le_contravar; lra]).
  assert (M1 : ln x * (/ sqrt x - / sqrt y) <= ln x * (g / x)) by (apply Rmult_le_compat_l; lra).
  assert (M2 : ln x * (g / x) <= g).
  { replace (ln x * (g / x)) with (g * (ln x * / x)) by (unfold Rdiv; ring).
    assert (K : ln x * / x <= x * / x) by (apply Rmult_le_compat_r; lra).
    rewrite Rinv_r in K by lra. assert (g * (ln x * / x) <= g * 1) by (apply Rmult_le_compat_l; unfold g; lra). lra. }
  assert (M3 : g / x <= g / 1) by (apply Rmult_le_compat_l; [unfold g; lra | rewrite Rinv_1; lra]).
  assert (M4 : ln x * / sqrt y <= ln y * / sqrt y) by (apply Rmult_le_compat_r; lra). unfold g in *. lra.
Qed.
Theorem L56_late N q n : steps -> layer -> bulk -> end_of_orbit -> (903 <= N)%nat -> 1 <= q -> N_star q n ->
  (law_constant * quarter q - 0.16 * / sqrt q < delta N q -> (N <= n)%nat) /\
  (delta N q <= law_constant * quarter q - (0.063 * ln q + 0.7) * / sqrt q -> (n < N)%nat).
Proof.
  intros HS HL HB HE HN Hq Hn. destruct (theorem_2b N ltac:(lia)) as [c [Hc _]]. assert (C1 := proj1 Hc).
  destruct (theorem_A N c HS HL HB HE HN Hc) as [[A B] _]. destruct (by_critical N q c n Hc Hq Hn) as [X Y].
  unfold delta in *. split; intros K.
  - apply X. apply Rnot_le_lt. intros L.
    assert (Z : late N (fun x => 0.16 * / sqrt x) q <= late N (fun x => 0.16 * / sqrt x) c).
    { destruct (Req_dec q c) as [->|]; [lra|]. left. apply late_grows; [exact Hq | lra |]. apply first_term; lra. }
    unfold late in Z. lra.
  - apply Y. apply Rnot_lt_le. intros L.
    assert (Z : late N (fun x => (0.063 * ln x + 0.7) * / sqrt x) c < late N (fun x => (0.063 * ln x + 0.7) * / sqrt
      x) q).
    { apply late_grows; [exact C1 | exact L |]. apply second_term; lra. }
    unfold late in Z. lra.
Qed.

Theorem growth_law : steps -> layer -> bulk -> end_of_orbit ->
  forall e, 0 < e -> exists q0, forall q N, q0 <= q -> N_star q N -> Rabs (INR N / sqrt q - growth) <= e.
Proof.
  intros HS HL HB HE e He. destruct (law HS HL HB HE) as [_ H]. set (r := 2.115 / e).
  assert (R0 : 0 < r) by (apply Rdiv_lt_0_compat; lra). exists ((r + 1) * (r + 1)). intros q N Hq HN.
  assert (S : r + 1 <= sqrt q) by (rewrite <- (sqrt_square (r + 1)) by lra; apply sqrt_le_1_alt; exact Hq).
  assert (Q : 1 <= q) by (apply Rle_trans with (2 := Hq); apply Rle_trans with (1 * 1); [lra | apply Rmult_le_compat;
    lra]).
  specialize (H q N Q HN). replace (INR N / sqrt q - growth) with ((INR N - growth * sqrt q) / sqrt q)
    by (field; lra).
  assert (K : 2.115 / sqrt q <= e).
  { apply Rmult_le_reg_r with (sqrt q); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    apply Rle_trans with (e * r); [unfold r; right; field; lra | apply Rmult_le_compat_l; lra]. }
  assert (I : 0 < / sqrt q) by (apply Rinv_0_lt_compat; lra). apply Rle_trans with (2 := K). unfold Rdiv.
  assert (P : 0 <= (INR N - growth * sqrt q) * / sqrt q) by (apply Rmult_le_pos; lra). rewrite Rabs_pos_eq by exact P.
  apply Rmult_le_compat_r; lra.
Qed.
