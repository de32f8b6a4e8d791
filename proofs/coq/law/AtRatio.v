(** What the steps and Theorem A say of one mass ratio (L56 of law.md), and Theorem 4 of theorem.md: N/sqrt q tends
    to C.

    L56_early  == 3 <= N <= 902: the enclosed critical ratio decides
    L56_late   == N >= 903: two inequalities decide
    growth_law == N*(q)/sqrt q tends to C *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Dumbbell Require Import Statement Maximum ExactMaximum CriticalRatios LawStatement Cubes TheoremB TheoremA Law FirstSteps
  LayerHolds EndHolds.
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

(** delta_N less a side of Theorem A, which grows from x = 5 on. *)
Definition side k t x := law_constant * quarter x - log_constant * / sqrt x * ln x - k * / sqrt x +
  t * (quarter x * / sqrt x).
Lemma inverse_roots x y : 1 <= x -> x < y -> 1 <= sqrt x < sqrt y /\ 0 < / sqrt y < / sqrt x /\
  / sqrt x - / sqrt y <= (sqrt y - sqrt x) / x.
Proof.
  intros Hx Hy. assert (A : 1 <= sqrt x) by (rewrite <- sqrt_1; apply sqrt_le_1; lra).
  assert (B : sqrt x < sqrt y) by (apply sqrt_lt_1; lra). split; [lra|].
  split; [split; [apply Rinv_0_lt_compat | apply Rinv_lt_contravar; [apply Rmult_lt_0_compat|]]; lra|].
  replace (/ sqrt x - / sqrt y) with ((sqrt y - sqrt x) / (sqrt x * sqrt y)) by (field; lra).
  apply Rmult_le_compat_l; [lra|]. apply Rinv_le_contravar; [lra|]. rewrite <- (sqrt_sqrt x) at 1 by lra.
  apply Rmult_le_compat_l; lra.
Qed.
Lemma late_grows N k t x y : 0 <= k <= 0.61 -> -2.6 <= t -> 5 <= x -> x < y ->
  delta N x - side k t x < delta N y - side k t y.
Proof.
  intros Hk Ht Hx Hxy. destruct (inverse_roots x y ltac:(lra) Hxy) as [R0 [R1 R2]].
  destruct (law_mono x y ltac:(lra) ltac:(lra)) as [_ B]. destruct growth_value as [G _]. unfold delta, side.
  set (g := sqrt y - sqrt x) in *. assert (g0 : 0 < g) by (unfold g; lra).
  assert (V : 0.885 * g <= growth * g) by (apply Rmult_le_compat_r; lra).
  assert (R3 : g / x <= g / 5) by (apply Rmult_le_compat_l; [|apply Rinv_le_contravar]; lra).
  (* the logarithm *)
  destruct log_constant_value as [K1 K2].
  assert (L0 : 0 <= ln x) by (rewrite <- ln_1; apply ln_le; lra).
  assert (L1 : ln x < ln y) by (apply ln_increasing; lra).
  assert (L2 : ln x <= x).
  { assert (H := exp_ineq1_le (x - 1)). apply ln_le in H; [|lra]. rewrite ln_exp in H.
    replace (1 + (x - 1)) with x in H by ring. lra. }
  assert (M1 : ln x * (/ sqrt x - / sqrt y) <= ln x * (g / x)) by (apply Rmult_le_compat_l; lra).
  assert (M2 : ln x * (g / x) <= g).
  { replace (ln x * (g / x)) with (g * (ln x * / x)) by (unfold Rdiv; ring).
    assert (I : 0 < / x) by (apply Rinv_0_lt_compat; lra).
    assert (K : ln x * / x <= x * / x) by (apply Rmult_le_compat_r; lra). rewrite Rinv_r in K by lra.
    assert (g * (ln x * / x) <= g * 1) by (apply Rmult_le_compat_l; lra). lra. }
  assert (M3 : ln x * / sqrt y <= ln y * / sqrt y) by (apply Rmult_le_compat_r; lra).
  assert (M4 : log_constant * (/ sqrt x * ln x - / sqrt y * ln y) <= log_constant * g)
    by (apply Rmult_le_compat_l; lra).
  assert (M5 : log_constant * g <= 0.026 * g) by (apply Rmult_le_compat_r; lra).
  (* the constant *)
  assert (C1 : k * (/ sqrt x - / sqrt y) <= 0.61 * (/ sqrt x - / sqrt y)) by (apply Rmult_le_compat_r; lra).
  (* the third power *)
  set (p := / sqrt x) in *. set (r := / sqrt y) in *. set (sx := quarter x) in *. set (sy := quarter y) in *.
  assert (Q : forall z, 5 <= z -> 0 < quarter z <= 0.67 /\ quarter z * quarter z = / sqrt z).
  { intros z Hz. assert (S5 : 0 < sqrt z) by (apply sqrt_lt_R0; lra).
    assert (W : 1.495 <= sqrt (sqrt z)).
    { apply Rle_trans with (sqrt (sqrt 5)); [interval | apply sqrt_le_1_alt, sqrt_le_1_alt; lra]. }
    unfold quarter. split; [split; [apply Rinv_0_lt_compat; lra|]|].
    - apply Rle_trans with (/ 1.495); [apply Rinv_le_contravar|]; lra.
    - rewrite <- Rinv_mult, sqrt_sqrt by lra. reflexivity. }
  destruct (Q x ltac:(lra)) as [X1 X2]. destruct (Q y ltac:(lra)) as [Y1 Y2]. fold sx p in X1, X2.
  fold sy r in Y1, Y2. assert (XY : sy < sx).
  { apply Rnot_le_lt. intros K. assert (sx * sx <= sy * sy) by (apply Rmult_le_compat; lra). lra. }
  assert (W0 : 0 <= sx * p - sy * r).
  { assert (sy * r <= sx * p) by (apply Rmult_le_compat; lra). lra. }
  assert (W1 : sx * p - sy * r <= 1.5 * 0.67 * (p - r)).
  { assert (Z : 0 <= (sx - sy) * (sx - sy) * (sx + 2 * sy)) by (apply Rmult_le_pos; [apply Rle_0_sqr | lra]).
    assert (E : sx * (p - r) <= 0.67 * (p - r)) by (apply Rmult_le_compat_r; lra).
    assert (E2 : sx * p - sy * r <= 1.5 * (sx * (p - r))).
    { rewrite <- X2, <- Y2. lra. }
    lra. }
  assert (W2 : -2.6 * (sx * p - sy * r) <= t * (sx * p - sy * r)) by (apply Rmult_le_compat_r; lra).
  replace (growth * g) with (growth * sqrt y - growth * sqrt x) in V by (unfold g; ring). lra.
Qed.
Lemma early_side k q : k <= 0.61 -> 1 <= q <= 5 -> -1 < side k 2.6 q /\ sqrt q <= 3.
Proof.
  intros Hk Hq. assert (S : 1 <= sqrt q) by (rewrite <- sqrt_1; apply sqrt_le_1; lra).
  assert (S2 := sqrt_sqrt q ltac:(lra)). assert (S3 : sqrt q <= 3).
  { apply Rnot_lt_le. intros K. assert (3 * 3 < sqrt q * sqrt q) by (apply Rmult_le_0_lt_compat; lra). lra. }
  split; [|exact S3]. assert (I : 0 < / sqrt q <= 1).
  { split; [apply Rinv_0_lt_compat; lra | rewrite <- Rinv_1; apply Rinv_le_contravar; lra]. }
  assert (Q0 : 0 < quarter q) by (apply Rinv_0_lt_compat, sqrt_lt_R0; lra). destruct c0_value as [C _].
  destruct log_constant_value as [K1 K2]. assert (L0 : 0 <= ln q) by (rewrite <- ln_1; apply ln_le; lra).
  assert (L : ln q <= 4).
  { assert (H := exp_ineq1_le (q - 1)). apply ln_le in H; [|lra]. rewrite ln_exp in H.
    replace (1 + (q - 1)) with q in H by ring. lra. }
  assert (A : 0 <= law_constant * quarter q) by (apply Rmult_le_pos; lra).
  assert (B : 0 <= quarter q * / sqrt q) by (apply Rmult_le_pos; lra).
  assert (D : log_constant * / sqrt q <= 0.026 * 1) by (apply Rmult_le_compat; lra).
  assert (D0 : 0 <= log_constant * / sqrt q) by (apply Rmult_le_pos; lra).
  assert (E : log_constant * / sqrt q * ln q <= 0.026 * 1 * 4) by (apply Rmult_le_compat; lra).
  assert (F : k * / sqrt q <= 0.61 * / sqrt q) by (apply Rmult_le_compat_r; lra). unfold side. lra.
Qed.
Theorem L56_late N q n : (903 <= N)%nat -> 1 <= q -> N_star q n ->
  let s := quarter q in let middle := law_constant * s - log_constant * s^2 * ln q - constant_of N * s^2 in
  let error := (0.072 + 2.6 * s) * s^2 in
  (middle + error < delta N q -> (N <= n)%nat) /\ (delta N q <= middle - error -> (n < N)%nat).
Proof.
  intros HN Hq Hn s middle error. destruct (theorem_2b N ltac:(lia)) as [c [Hc _]].
  assert (Hc1 := late_enough N c steps_hold HN Hc). assert (A := enclosed N c steps_hold layer_holds end_holds HN Hc).
  unfold law_with_logarithm in A. cbv zeta in A. rewrite quarter_square in A by lra. apply Rabs_le_between in A.
  destruct (by_critical N q c n Hc Hq Hn) as [X Y].
  assert (K : 0.38 <= constant_of N <= 0.497) by (unfold constant_of; destruct (Nat.even N); lra).
  set (k := constant_of N) in *. assert (S2 : s^2 = / sqrt q) by (apply quarter_square; lra).
  assert (E1 : middle + error = side (k - 0.072) 2.6 q) by (unfold middle, error, side; rewrite S2; fold s; lra).
  assert (E2 : middle - error = side (k + 0.072) (-2.6) q) by (unfold middle, error, side; rewrite S2; fold s; lra).
  assert (A1 : delta N c <= side (k - 0.072) 2.6 c) by (unfold side; lra).
  assert (A2 : side (k + 0.072) (-2.6) c <= delta N c) by (unfold side; lra).
  rewrite E1, E2. split; intros H.
  - destruct (Rle_dec q 5) as [L|L].
    + exfalso. destruct (early_side (k - 0.072) q ltac:(lra) ltac:(lra)) as [B1 B2]. destruct growth_value as [_ G].
      assert (N9 : 903 <= INR N)
        by (replace 903 with (INR 903) by (rewrite INR_IZR_INZ; reflexivity); now apply le_INR).
      assert (growth * sqrt q <= 0.886 * sqrt q) by (apply Rmult_le_compat_r; [apply sqrt_pos | lra]).
      unfold delta in H. lra.
    + apply X. apply Rnot_le_lt. intros Z. destruct (Req_dec q c) as [Eq|]; [rewrite Eq in H; lra|].
      assert (M := late_grows N (k - 0.072) 2.6 q c ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)). lra.
  - apply Y. apply Rnot_lt_le. intros Z.
    assert (M := late_grows N (k + 0.072) (-2.6) c q ltac:(lra) ltac:(lra) ltac:(lra) Z). lra.
Qed.

Theorem growth_law e : 0 < e -> exists q0, forall q N, q0 <= q -> N_star q N -> Rabs (INR N / sqrt q - growth) <= e.
Proof.
  intros He. destruct law as [_ H]. set (r := 2.115 / e).
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
