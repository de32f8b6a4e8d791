(** Theorem A of law.md, from the conditions: delta_N for N >= 903.

    log_constant_value == decimals of kappa
    L46             == delta_N/2 = start + T_0 - (n + 1): the sum of all defects, the end and the start
    layer_and_end   == what the layer and the end give of it
    late_enough     == such a critical ratio is at least 10^6
    quarter_square  == q^(-1/4)^2 = 1/sqrt q
    enclosed        == delta_N is c0 s - kappa s^2 ln q - k_N s^2, but for (0.072 + 2.6 s) s^2, where s = q^(-1/4)
    A_positive      == the lower bound is positive
    theorem_A       == delta_N is so enclosed, and is between 0 and c0 s *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Dumbbell Require Import CriticalRatios LawStatement Differences Cubes Comparison Place Sandwich TheoremB Angles
  Orbit Ends Start AllSteps.
Local Open Scope R_scope.

Lemma log_constant_value : 0.025 <= log_constant <= 0.026.
Proof. unfold log_constant. split; interval. Qed.

Section OneRatio.
Variables (N : nat) (q : R).
Hypothesis Hc : critical N q.
Hypothesis Hq : 1000000 <= q.
Let eps := / sqrt q.

Lemma eps_small : 0 < eps <= 1/1000 /\ sqrt q = / eps /\ sqrt eps = quarter q.
Proof.
  assert (S : 1000 <= sqrt q) by (rewrite <- (sqrt_square 1000) by lra; apply sqrt_le_1; lra). split; [split|split].
  - apply Rinv_0_lt_compat; lra.
  - replace (1/1000) with (/ 1000) by field. apply Rinv_le_contravar; lra.
  - unfold eps. now rewrite Rinv_inv.
  - apply sqrt_inv.
Qed.

Variables (n : nat) (u al : nat -> R) (y : R).
Hypothesis Orb : orbit eps N n u al y.
Let T i := clock eps (u i) (al i).

Theorem L46 : exists start, delta N q = 2 * (start + (T O - (INR n + 1))) /\
  ((Nat.even N = true /\ start = 0) \/ (Nat.even N = false /\ 0.0580 * eps <= start <= 0.0590 * eps)).
Proof.
  destruct eps_small as [E1 [E2 _]]. unfold delta. rewrite E2. destruct Orb as [_ _ [[-> H]|[-> H]]].
  - exists 0. split; [|left; split; [rewrite Nat.even_add, Nat.even_mul; reflexivity | reflexivity]].
    unfold T. rewrite (corner_clock eps) by (try exact H; lra). rewrite plus_INR, mult_INR. simpl INR. field. lra.
  - exists (growth / (2 * eps) - 1/2 - T O). split; [rewrite plus_INR, mult_INR; simpl INR; field; lra|].
    right. split; [rewrite Nat.even_add, Nat.even_mul; reflexivity | exact (top_clock eps _ _ E1 H)].
Qed.

Hypothesis Hlayer : layer_defect.
Hypothesis Hend : end_of_orbit.

(** The layer and the end, T_k - (m + 1) over eps, where m = n - k, beside k0 s times the sum of all cubes. *)
Lemma layer_and_end : exists k z, 0 < sqrt eps /\ z = step_constant * sqrt eps /\
  -0.0801 * eps <= T O - T k - INR k <= -0.0629 * eps /\
  -0.2037 * eps - 1.17 * (sqrt eps * eps) <= T k - (INR n - INR k + 1) - z * Series cube +
    log_constant / 2 * ln q * eps <= -0.1503 * eps + 1.17 * (sqrt eps * eps).
Proof.
  destruct eps_small as [E1 [E2 E3]]. destruct (small_root eps E1) as [S1 S2]. set (s := sqrt eps) in *.
  destruct k0_value as [K1 K2]. destruct Series_value as [C1 C2].
  destruct (L54 eps N n u al y (proj2 E1) Orb Hlayer Hend) as [k [F1 F2 F3 F4 [F5 [F6 F7]]]].
  exists k, (step_constant * s). split; [lra|]. split; [reflexivity|]. split; [exact F2|].
  fold (T O) (T k) in F2. fold (T k) in F3. fold (T n) in F5, F7. fold s in F7. apply Rabs_le_between in F7.
  set (z := step_constant * s) in *.
  assert (Z : 0.0825 * s <= z <= 0.0826 * s) by (unfold z; split; apply Rmult_le_compat_r; lra).
  assert (Ss : eps <= 0.03163 * s) by (rewrite <- S2; apply Rmult_le_compat_r; lra).
  set (m := (n - k)%nat). set (T' := fun j => T (n - j)%nat).
  set (D' := fun j => T (n - S j)%nat - 1 - T (n - j)%nat). set (e := T n - 1) in *.
  (* the end *)
  assert (V : 0 < u n) by (destruct Orb as [_ [_ L _ _ _] _]; lra).
  assert (Ue : u n * eps <= 0.18 * eps) by (apply Rmult_le_compat_r; lra).
  assert (He : 0 < e <= z) by lra.
  assert (Un : u n <= 4.68 * s).
  { apply Rle_trans with (1 := F5). rewrite sqrt_mult_alt by lra. fold s.
    assert (R : sqrt (T n) <= 1.0015).
    { apply Rle_trans with (sqrt (1.0015 * 1.0015)); [apply sqrt_le_1_alt; unfold e in He; lra|].
      rewrite sqrt_square; lra. }
    assert (s * sqrt (T n) <= s * 1.0015) by (apply Rmult_le_compat_l; lra). lra. }
  assert (Us : u n * eps <= 4.68 * (s * eps)) by (rewrite <- Rmult_assoc; apply Rmult_le_compat_r; lra).
  assert (G7 : -0.1687 * eps - 1.17 * (s * eps) <= e - z <= -0.1627 * eps + 1.17 * (s * eps)) by lra.
  (* the steps *)
  assert (Hz : 0 <= z) by lra. assert (H0 : T' O = 1 + e) by (unfold T', e; rewrite Nat.sub_0_r; ring).
  assert (HS : forall j, (j < m)%nat -> T' (S j) = T' j + 1 + D' j) by (intros j _; unfold T', D'; ring).
  assert (Hi : forall j, (j < m)%nat -> (k <= n - S j < n)%nat /\ S (n - S j) = (n - j)%nat)
    by (unfold m; intros; lia).
  assert (HD : forall j, (j < m)%nat -> let d := difference (T' (S j)) in let g := 5 / (3 * PI) in
    0 < D' j <= z * d^3 /\ z * (d^3 - scale eps * (g * d^2 + 0.125 * scale eps * d + 0.45 * d^4)) <= D' j /\
    D' j <= z * (d^3 - scale eps * (g * d^2 - 0.155 * scale eps * d - 0.43 * d^4))).
  { intros j Hj. destruct (Hi j Hj) as [I1 I2]. assert (B := F4 _ I1). rewrite I2 in B. exact B. }
  set (h := scale eps) in *. set (g := 5 / (3 * PI)) in *.
  assert (HD0 : forall j, (j < m)%nat -> 0 < D' j <= z * difference (T' (S j)) ^ 3)
    by (intros j Hj; apply (HD j Hj)).
  assert (Tm : T' m = T k) by (unfold T', m; f_equal; lia).
  assert (M0 : INR n - INR k = INR m) by (unfold m; rewrite minus_INR by lia; ring). rewrite M0.
  assert (A1 := clock_above T' D' m e z (proj1 He) H0 HS HD0 m (le_n m)).
  assert (A2 := sandwich_above T' D' m e z (proj1 He) Hz H0 HS HD0 m (le_n m)). rewrite Tm in A1, A2.
  assert (Bs := sum_below_series m).
  assert (Zs : z * (sum_n cube m - 1) <= z * 0.33) by (apply Rmult_le_compat_l; lra).
  assert (Zc : z * (Series cube - 1) <= z * 0.33) by (apply Rmult_le_compat_l; lra). set (x := 0.11 * s) in *.
  assert (X : e + z * (Series cube - 1) <= x <= 1) by (unfold x; lra).
  assert (G0 : 0.5305 <= g <= 0.5306) by (unfold g; split; interval).
  assert (h0 : 0 <= h).
  { unfold h, scale. destruct scale_value. apply Rmult_le_pos; fold s; lra. }
  assert (B1 := logarithm_above T' D' m e z (proj1 He) Hz H0 HS HD0 h g x h0 ltac:(lra) X
    (fun j Hj => proj2 (proj2 (HD j Hj))) m (le_n m)).
  assert (B2 := logarithm_below T' D' m e z (proj1 He) Hz H0 HS HD0 h g x h0 ltac:(lra) X
    (fun j Hj => proj1 (proj2 (HD j Hj))) m (le_n m)). rewrite Tm in B1, B2.
  (* how many they are *)
  assert (I1 : 1000 <= / eps).
  { replace 1000 with (/ (1/1000)) by field. apply Rinv_le_contravar; lra. }
  unfold Rdiv in F3. assert (Mb : 0.05849 * / eps <= INR m /\ 0.05949 * / eps <= INR (S m) <= 0.06125 * / eps /\
    INR (S (S m)) <= 0.06225 * / eps) by (rewrite !S_INR; unfold x in X; lra).
  destruct Mb as [Mb1 [Mb2 Mb3]]. set (r := / s). assert (Is : 0 < r) by (apply Rinv_0_lt_compat; lra).
  assert (Rr : r * r = / eps) by (unfold r; rewrite <- Rinv_mult, S2; reflexivity).
  assert (Rt : forall p t, 0 <= p -> t <= p * p * / eps -> sqrt t <= p * r).
  { intros p t Hp Ht. rewrite <- (sqrt_square (p * r)) by (apply Rmult_le_pos; lra). apply sqrt_le_1_alt.
    replace (p * r * (p * r)) with (p * p * (r * r)) by ring. now rewrite Rr. }
  assert (Rb : forall p t, 0 <= p -> p * p * / eps <= t -> p * r <= sqrt t).
  { intros p t Hp Ht. rewrite <- (sqrt_square (p * r)) by (apply Rmult_le_pos; lra). apply sqrt_le_1_alt.
    replace (p * r * (p * r)) with (p * p * (r * r)) by ring. now rewrite Rr. }
  assert (Sm := Rt 0.2475 (INR (S m)) ltac:(lra) ltac:(lra)).
  assert (Sm1 := Rb 0.2418 (INR m) ltac:(lra) ltac:(lra)).
  assert (Sm2 := Rt 0.2496 (INR (S (S m))) ltac:(lra) ltac:(lra)).
  assert (m1 : (1 <= m)%nat) by (unfold m; lia).
  assert (Sp : 0 < sqrt (INR (S (S m)))) by (apply sqrt_lt_R0, lt_0_INR; lia).
  assert (sr : s * / r = eps) by (unfold r; rewrite Rinv_inv; exact S2).
  assert (Ta : z * sum_n cube m <= z * Series cube - 0.0826 * eps).
  { assert (W := Rmult_le_compat_l z _ _ Hz (tail_above m)).
    assert (Y : 0.0825 * s * / (4 * (0.2496 * r)) <= z * / (4 * sqrt (INR (S (S m))))).
    { apply Rmult_le_compat; [lra | left; apply Rinv_0_lt_compat; lra | lra | apply Rinv_le_contravar; lra]. }
    replace (0.0825 * s * / (4 * (0.2496 * r))) with (0.0825 / (4 * 0.2496) * (s * / r)) in Y by (field; lra).
    rewrite sr in Y. lra. }
  assert (Tb : z * Series cube - 0.0855 * eps <= z * sum_n cube m).
  { assert (W := Rmult_le_compat_l z _ _ Hz (tail_below m m1)).
    assert (Y : z * / (4 * sqrt (INR m)) <= 0.0826 * s * / (4 * (0.2418 * r))).
    { apply Rmult_le_compat; [lra | left; apply Rinv_0_lt_compat; lra | lra | apply Rinv_le_contravar; lra]. }
    replace (0.0826 * s * / (4 * (0.2418 * r))) with (0.0826 / (4 * 0.2418) * (s * / r)) in Y by (field; lra).
    rewrite sr in Y. lra. }
  assert (Lm : - ln eps - 2.822 <= ln (INR (S m)) <= - ln eps - 2.792).
  { assert (IE : 0 < / eps) by lra.
    assert (L1 : ln (0.05949 * / eps) <= ln (INR (S m))) by (apply ln_le; lra).
    assert (L2 : ln (INR (S m)) <= ln (0.06125 * / eps)) by (apply ln_le; lra).
    rewrite ln_mult, ln_Rinv in L1, L2 by lra.
    assert (V1 : -2.822 <= ln 0.05949) by interval. assert (V2 : ln 0.06125 <= -2.792) by interval. lra. }
  assert (Lq : ln q = 2 * - ln eps).
  { rewrite <- ln_Rinv by lra. rewrite <- E2. rewrite <- (sqrt_sqrt q) at 1 by lra.
    rewrite ln_mult by (rewrite E2; lra). ring. }
  (* the constants *)
  assert (ZH : z * h = eps / (3 * sqrt 3)) by (apply L57a_product; lra). destruct root_three as [S3 S33].
  assert (P := PI_RGT_0). set (c := 5 / (9 * sqrt 3 * PI)).
  assert (ZG : z * h * g = c * eps) by (rewrite ZH; unfold c, g; field; lra).
  assert (LC : log_constant = c / 4) by (unfold log_constant, c; field; lra).
  assert (Cv : 0.10209 <= c <= 0.1021) by (unfold c; split; interval).
  assert (Zv : 0.1924 * eps <= z * h <= 0.19246 * eps).
  { rewrite ZH. unfold Rdiv. rewrite (Rmult_comm eps). split; apply Rmult_le_compat_r; try lra; interval. }
  assert (Hs : z * h^2 * sqrt (INR (S m)) <= 0.1112 * eps /\ 0 <= z * h^2).
  { assert (ZZ : z * h^2 = z * h * h) by ring. rewrite ZZ.
    assert (H1 : h <= 2.3327 * s) by (apply Rmult_le_compat_r; [lra | apply scale_value]).
    assert (H2 : z * h * h <= 0.19246 * eps * (2.3327 * s)) by (apply Rmult_le_compat; lra).
    assert (H3 : 0 <= z * h * h) by (apply Rmult_le_pos; lra). split; [|exact H3].
    apply Rle_trans with (0.19246 * eps * (2.3327 * s) * (0.2475 * r)).
    - apply Rmult_le_compat; [exact H3 | apply sqrt_pos | exact H2 | exact Sm].
    - replace (0.19246 * eps * (2.3327 * s) * (0.2475 * r)) with (0.19246 * 2.3327 * 0.2475 * eps * (s * r)) by ring.
      unfold r. rewrite Rinv_r by lra. lra. }
  destruct Hs as [Hs1 Hs2].
  assert (Hs3 : 1 <= sqrt (INR (S m))) by (rewrite <- sqrt_1; apply sqrt_le_1_alt; apply (le_INR 1); lia).
  assert (Hs4 := Rmult_le_compat_l _ _ _ Hs2 Hs3).
  set (Q := 1 - / INR (S m)) in *. assert (Q01 : 0 <= Q <= 1).
  { assert (1 <= INR (S m)) by (apply (le_INR 1); lia). assert (0 < / INR (S m) <= 1).
    { split; [apply Rinv_0_lt_compat; lra | rewrite <- Rinv_1; apply Rinv_le_contravar; lra]. }
    unfold Q. lra. }
  assert (W1 : z * h * Q <= 0.19246 * eps) by (apply Rle_trans with (0.19246 * eps * 1); [apply Rmult_le_compat|]; lra).
  assert (Zx : 0 <= z * x <= 0.00909 * eps).
  { split; [apply Rmult_le_pos; lra|]. apply Rle_trans with (0.0826 * s * (0.11 * s)); [unfold x; apply Rmult_le_compat;
      lra|]. replace (0.0826 * s * (0.11 * s)) with (0.0826 * 0.11 * (s * s)) by ring. rewrite S2. lra. }
  assert (W2 : z * x * Q <= 0.00909 * eps * 1) by (apply Rmult_le_compat; lra).
  assert (W3 : c * eps * ((0.0038 + x / 4) * Q) <= 0.1021 * eps * 0.00467).
  { apply Rmult_le_compat; [apply Rmult_le_pos; lra | apply Rmult_le_pos; unfold x; lra
      | apply Rmult_le_compat_r; lra |].
    apply Rle_trans with (0.00467 * 1); [apply Rmult_le_compat; unfold x; lra | lra]. }
  assert (W4 : c * eps * 2.792 <= c * eps * (- ln eps - ln (INR (S m))) <= c * eps * 2.822).
  { assert (0 <= c * eps) by (apply Rmult_le_pos; lra). split; apply Rmult_le_compat_l; lra. }
  assert (W5 : 0.10209 * eps <= c * eps <= 0.1021 * eps) by (split; apply Rmult_le_compat_r; lra).
  rewrite ZG in B1, B2. rewrite LC, Lq. split; lra.
Qed.
Lemma both_halves : Rabs (delta N q - (law_constant * quarter q - log_constant * / sqrt q * ln q -
  constant_of N * / sqrt q)) <= (0.072 + 2.6 * quarter q) * / sqrt q.
Proof.
  destruct eps_small as [E1 [E2 E3]]. destruct layer_and_end as [k [z [S0 [Z [B L]]]]].
  destruct L46 as [start [-> H]]. fold eps. rewrite <- E3. set (s := sqrt eps) in *.
  assert (Cc : law_constant * s = 2 * (z * Series cube)) by (rewrite Z; unfold law_constant; ring). rewrite Cc.
  assert (Se : 0 < s * eps) by (apply Rmult_lt_0_compat; lra).
  apply Rabs_le. unfold constant_of. destruct H as [[-> ->]|[-> H]]; lra.
Qed.
End OneRatio.

Lemma late_enough N q : steps -> (903 <= N)%nat -> critical N q -> 1000000 <= q.
Proof.
  intros HS HN Hc. destruct (theorem_2b 903 ltac:(lia)) as [p [Hp _]]. assert (L := above_a_million p HS Hp).
  destruct (Nat.eq_dec N 903) as [->|Z]; [rewrite (critical_unique 903 q p Hc Hp); lra|].
  assert (p < q); [|lra]. assert (Q := N_at_critical N q ltac:(lia) Hc). destruct Hc as [Hq Hc].
  apply (proj2 Hp q Hq). exists (N - 1)%nat. split; [exact Q | lia].
Qed.
Lemma quarter_square q : 0 < q -> quarter q ^ 2 = / sqrt q.
Proof.
  intros Hq. unfold quarter. assert (0 < sqrt q) by (now apply sqrt_lt_R0). rewrite pow_inv. f_equal.
  apply pow2_sqrt. lra.
Qed.
Lemma enclosed N q : steps -> layer_defect -> end_of_orbit -> (903 <= N)%nat -> critical N q ->
  law_with_logarithm N q.
Proof.
  intros HS HL HE HN Hc. assert (Hq := late_enough N q HS HN Hc).
  destruct (orbit_of_critical N q ltac:(lia) Hc) as [n [u [al [y Orb]]]].
  unfold law_with_logarithm. cbv zeta. rewrite quarter_square by lra.
  exact (both_halves N q Hc Hq n u al y Orb HL HE).
Qed.
(** kappa ln q + 0.57 + 2.6 s < c0 q^(1/4). *)
Lemma A_positive q : 1000000 <= q ->
  (log_constant * ln q + 0.57 + 2.6 * quarter q) * / sqrt q < law_constant * quarter q /\ quarter q <= 0.0318.
Proof.
  intros Hq. assert (S : 1000 <= sqrt q) by (rewrite <- (sqrt_square 1000) by lra; apply sqrt_le_1; lra).
  set (w := sqrt (sqrt q)). assert (W : 31.5 <= w) by (rewrite <- (sqrt_square 31.5) by lra; apply sqrt_le_1; lra).
  assert (E1 : sqrt q = w * w) by (unfold w; rewrite sqrt_sqrt; lra).
  assert (E2 : q = w * w * (w * w)) by (rewrite <- E1, sqrt_sqrt; lra).
  assert (I : 0 < / w <= 0.0318).
  { split; [apply Rinv_0_lt_compat; lra|]. apply Rle_trans with (/ 31.5); [apply Rinv_le_contravar|]; lra. }
  unfold quarter. fold w. split; [|lra]. rewrite E1. assert (L : ln q = 4 * ln w).
  { rewrite E2. assert (0 < w * w) by (apply Rmult_lt_0_compat; lra). rewrite ln_mult, ln_mult by lra. ring. }
  assert (T : 0 <= ln w <= w / 31 + 2.44).
  { split; [rewrite <- ln_1; apply ln_le; lra|]. assert (H := exp_ineq1_le (w / 31 - 1)). apply ln_le in H; [|lra].
    rewrite ln_exp in H. replace (1 + (w / 31 - 1)) with (w * / 31) in H by field. rewrite ln_mult, ln_Rinv in H by lra.
    assert (V : ln 31 <= 3.435) by interval. lra. }
  assert (K := log_constant_value).
  assert (KL : log_constant * (4 * ln w) <= 0.026 * (4 * ln w)) by (apply Rmult_le_compat_r; lra).
  destruct c0_value as [C _]. rewrite L, Rinv_mult, <- Rmult_assoc.
  apply Rmult_lt_compat_r; [apply Rinv_0_lt_compat; lra|].
  apply Rmult_lt_reg_r with w; [lra|]. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
  assert (0.17 * w <= law_constant * w) by (apply Rmult_le_compat_r; lra). lra.
Qed.
Theorem theorem_A N q : steps -> layer_defect -> end_of_orbit -> (903 <= N)%nat -> critical N q ->
  law_with_logarithm N q /\ 0 < delta N q < law_constant * quarter q.
Proof.
  intros HS HL HE HN Hc. assert (Hq := late_enough N q HS HN Hc). assert (A := enclosed N q HS HL HE HN Hc).
  split; [exact A|]. unfold law_with_logarithm in A. cbv zeta in A. rewrite quarter_square in A by lra.
  apply Rabs_le_between in A. destruct (A_positive q Hq) as [P Q].
  assert (K : 0.38 <= constant_of N <= 0.497) by (unfold constant_of; destruct (Nat.even N); lra).
  assert (I : 0 < / sqrt q) by (apply Rinv_0_lt_compat, sqrt_lt_R0; lra).
  assert (L : 0 <= ln q) by (rewrite <- ln_1; apply ln_le; lra).
  assert (G : 0 <= log_constant * / sqrt q * ln q).
  { assert (0 <= log_constant * / sqrt q) by (apply Rmult_le_pos; [destruct log_constant_value|]; lra).
    apply Rmult_le_pos; lra. }
  assert (K1 : 0.38 * / sqrt q <= constant_of N * / sqrt q <= 0.497 * / sqrt q)
    by (split; apply Rmult_le_compat_r; lra).
  assert (K2 : quarter q * / sqrt q <= 0.0318 * / sqrt q) by (apply Rmult_le_compat_r; lra). lra.
Qed.
