(** Theorem A of law.md, from the conditions: delta_N for N >= 903.

    L46       == delta_N/2 = start + T_0 - (n + 1): the sum of all defects, the end and the start
    theorem_A == c0 q^(-1/4) - (0.063 ln q + 0.7) q^(-1/2) <= delta_N <= c0 q^(-1/4) - 0.16 q^(-1/2)
    A_positive == the lower bound is positive *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Dumbbell Require Import CriticalRatios LawStatement Cubes Sandwich TheoremB Angles Orbit Ends Start AllSteps.
Local Open Scope R_scope.

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

Theorem L46 : exists start, -0.0006 * eps <= start <= 0.0590 * eps /\ delta N q = 2 * (start + (T O - (INR n + 1))).
Proof.
  destruct eps_small as [E1 [E2 _]]. unfold delta. rewrite E2. destruct Orb as [_ _ [[-> H]|[-> H]]].
  - exists 0. split; [lra|]. unfold T. rewrite (corner_clock eps) by (try exact H; lra). rewrite plus_INR, mult_INR.
    simpl INR. field. lra.
  - exists (growth / (2 * eps) - 1/2 - T O). split; [exact (top_clock eps _ _ E1 H)|]. rewrite plus_INR, mult_INR.
    simpl INR. field. lra.
Qed.

Hypothesis Hlayer : layer.
Hypothesis Hbulk : bulk.
Hypothesis Hend : end_of_orbit.

Lemma both_halves : law_constant * quarter q - (0.063 * ln q + 0.7) * eps <= delta N q <= law_constant * quarter q -
  0.16 * eps.
Proof.
  destruct eps_small as [E1 [E2 E3]]. destruct (small_root eps E1) as [S1 S2]. set (s := sqrt eps) in *.
  rewrite <- E3.
  destruct k0_value as [K1 K2]. destruct Series_value as [C1 C2].
  destruct (L54 eps N n u al y (proj2 E1) Orb Hlayer Hbulk Hend) as [k [F1 F2 F3 F4 F5 F6]].
  destruct L46 as [start [St ->]]. fold (T O) (T k) in F2. fold (T k) in F3. fold (T n) in F6. fold s in F6.
  set (z := step_constant * s) in *.
  assert (Z : 0.0825 * s <= z <= 0.0826 * s) by (unfold z; split; apply Rmult_le_compat_r; lra).
  set (m := (n - k)%nat). set (T' := fun j => T (n - j)%nat).
  set (D' := fun j => T (n - S j)%nat - 1 - T (n - j)%nat).
  set (e := T n - 1) in *.
  assert (Se : s * eps <= 0.03163 * eps) by (apply Rmult_le_compat_r; lra).
  assert (Ss : eps <= 0.03163 * s) by (rewrite <- S2; apply Rmult_le_compat_r; lra).
  assert (He : 0 < e) by lra. assert (Hz : 0 <= z) by lra.
  assert (H0 : T' O = 1 + e) by (unfold T', e; rewrite Nat.sub_0_r; ring).
  assert (HS : forall j, (j < m)%nat -> T' (S j) = T' j + 1 + D' j) by (intros j _; unfold T', D'; ring).
  assert (Hi : forall j, (j < m)%nat -> (k <= n - S j < n)%nat /\ S (n - S j) = (n - j)%nat)
    by (unfold m; intros; lia).
  assert (HD : forall j, (j < m)%nat -> 0 < D' j <= D0 z (T' (S j))).
  { intros j Hj. destruct (Hi j Hj) as [I1 I2]. destruct (F4 _ I1) as [_ [B _]]. rewrite I2 in B. exact B. }
  assert (M0 : INR n + 1 = INR k + (INR m + 1)) by (unfold m; rewrite minus_INR by lia; ring).
  assert (Tm : T' m = T k) by (unfold T', m; f_equal; lia).
  assert (A1 := clock_above T' D' m e z He H0 HS HD m (le_n m)).
  assert (A2 := sandwich_above T' D' m e z He Hz H0 HS HD m (le_n m)).
  rewrite Tm in A1, A2. assert (I : 0 < / eps) by (apply Rinv_0_lt_compat; lra). assert (I1 : 1000 <= / eps).
  { replace 1000 with (/ (1/1000)) by field. apply Rinv_le_contravar; lra. }
  assert (Bs := sum_below_series m). unfold Rdiv in F3.
  assert (Zs : z * (sum_n cube m - 1) <= z * 0.33) by (apply Rmult_le_compat_l; lra).
  assert (m1 : (1 <= m)%nat) by (unfold m; lia). assert (MP : 1 <= INR m) by (apply (le_INR 1); exact m1).
  assert (Mb : 0.0499 * / eps <= INR m <= 0.0675 * / eps) by lra.
  assert (Cc : law_constant * s = 2 * (z * Series cube)) by (unfold law_constant, z; ring). rewrite Cc.
  split.
  - (* from below *)
    set (U' := fun j => middle (u (n - S j)%nat) (u (n - j)%nat)). set (v := 2.3362 * s).
    assert (HL : forall j, (j < m)%nat -> D0 z (T' (S j)) * (1 - 1.3 * U' j) <= D' j).
    { intros j Hj. destruct (Hi j Hj) as [J1 J2]. destruct (F4 _ J1) as [_ [_ B]]. rewrite J2 in B. exact B. }
    assert (HU : forall j, (j < m)%nat -> U' j <= v * (sqrt (T' (S j)) + sqrt (T' (S j) - 1))).
    { intros j Hj. destruct (Hi j Hj) as [J1 J2]. assert (X := F5 (n - S j)%nat ltac:(lia)).
      assert (Y := F5 (n - j)%nat ltac:(lia)).
      rewrite sqrt_mult_alt in X, Y by lra. fold s in X, Y. destruct (HD j Hj) as [D1 _]. rewrite (HS j Hj) in *.
      fold (T (n - j)%nat) (T (n - S j)%nat) in *. fold (T' j) in Y. change (T (n - S j)%nat) with (T' (S j)) in X.
      rewrite (HS j Hj) in X.
      assert (R : sqrt (T' j) <= sqrt (T' j + 1 + D' j - 1)) by (apply sqrt_le_1_alt; lra).
      assert (s * sqrt (T' j) <= s * sqrt (T' j + 1 + D' j - 1)) by (apply Rmult_le_compat_l; lra).
      unfold U', middle, v. lra. }
    assert (ZC : z * (Series cube - 1) <= z * 0.33) by (apply Rmult_le_compat_l; lra).
    assert (Hv : 0 <= v) by (unfold v; lra).
    assert (B := sandwich_below T' D' m e z He Hz H0 HS HD U' v (0.11 * s) Hv ltac:(lra) HL HU m (le_n m)).
    rewrite Tm in B.
    assert (Tl := tail_below m m1). set (sg := sum_n cube m) in *.
    assert (sg1 : 0 <= sg - 1).
    { unfold sg. clear -m1. induction m as [|j IH]; [lia|]. rewrite sum_Sn. change plus with Rplus.
      assert (C := cube_pos (S j)).
      destruct j as [|j]; [rewrite sum_O; unfold cube at 1; simpl INR; rewrite sqrt_1, sqrt_0;
        lra | specialize (IH ltac:(lia)); lra]. }
    assert (Lt : z * / (4 * sqrt (INR m)) <= 0.0925 * eps).
    { assert (R : sqrt (0.0499 * / eps) <= sqrt (INR m)) by (apply sqrt_le_1_alt; lra).
      assert (R2 : 0.2233 * / s <= sqrt (INR m)).
      { apply Rle_trans with (2 := R). apply Rle_trans with (sqrt (0.2233 * / s * (0.2233 * / s)));
          [rewrite sqrt_square; [lra|]|].
        - apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; lra].
        - apply sqrt_le_1_alt. rewrite <- S2. rewrite Rinv_mult.
          assert (0 < / s * / s) by (apply Rmult_lt_0_compat; apply Rinv_0_lt_compat; lra). lra. }
      assert (Is : 0 < / s) by (apply Rinv_0_lt_compat; lra).
      apply Rle_trans with (0.0826 * s * / (4 * (0.2233 * / s))).
      - apply Rmult_le_compat; [lra | left; apply Rinv_0_lt_compat; lra | lra | apply Rinv_le_contravar; lra].
      - replace (0.0826 * s * / (4 * (0.2233 * / s))) with (0.0826 / (4 * 0.2233) * (s * s)) by (field; lra).
        rewrite S2. lra. }
    assert (P1 : z * (sg - 1) * (1.08 * (0.11 * s)) <= 0.0826 * s * 0.33 * (1.08 * (0.11 * s))).
    { apply Rmult_le_compat_r; [lra|]. apply Rmult_le_compat; lra. }
    replace (0.0826 * s * 0.33 * (1.08 * (0.11 * s))) with (0.0826 * 0.33 * 1.08 * 0.11 * (s * s)) in P1 by ring.
    rewrite S2 in P1.
    assert (P2 : z * (Series cube - / (4 * sqrt (INR m))) <= z * sg) by (apply Rmult_le_compat_l; lra).
    assert (P3 : z * v <= 0.193 * eps).
    { apply Rle_trans with (0.0826 * s * (2.3362 * s)); [unfold v; apply Rmult_le_compat_r; lra|].
      replace (0.0826 * s * (2.3362 * s)) with (0.0826 * 2.3362 * (s * s)) by ring. rewrite S2. lra. }
    assert (P4 : 0 <= log_sum m <= ln q / 2 - 1.695).
    { destruct m as [|j]; [lia|]. unfold log_sum.
      assert (L1 : 0 <= ln (INR (S j))) by (rewrite <- ln_1; apply ln_le; lra).
      split; [lra|]. assert (L2 : ln (INR (S j)) <= ln (0.0675 * / eps)) by (apply ln_le; lra).
      rewrite ln_mult in L2 by lra.
      rewrite <- E2 in L2. assert (L3 : ln (sqrt q) = ln q / 2).
      { rewrite <- (sqrt_sqrt q) at 2 by lra. rewrite ln_mult by (rewrite E2; lra). lra. }
      assert (V : ln 0.0675 <= -2.695) by interval. lra. }
    assert (P5 : 1.3 * (z * v / 4) * log_sum m <= 0.0628 * eps * (ln q / 2 - 1.695)).
    { assert (0 <= z * v) by (apply Rmult_le_pos; unfold v; lra). apply Rmult_le_compat; lra. }
    assert (Lq : 0 <= ln q) by (rewrite <- ln_1; apply ln_le; lra).
    assert (0 <= eps * ln q) by (apply Rmult_le_pos; lra).
    lra.
  - (* from above *)
    assert (Ta := tail_above m). assert (R : sqrt (INR (S (S m))) <= 0.26173 * / s).
    { apply Rle_trans with (sqrt (0.26173 * / s * (0.26173 * / s))).
      - apply sqrt_le_1_alt. rewrite !S_INR.
        replace (0.26173 * / s * (0.26173 * / s)) with (0.26173 * 0.26173 * / (s * s)) by (field; lra). rewrite S2.
        lra.
      - rewrite sqrt_square; [lra|]. apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; lra]. }
    assert (R0 : 0 < sqrt (INR (S (S m)))) by (apply sqrt_lt_R0, lt_0_INR; lia).
    assert (L : 0.0787 * eps <= z * / (4 * sqrt (INR (S (S m))))).
    { assert (Is : 0 < / s) by (apply Rinv_0_lt_compat; lra).
      apply Rle_trans with (0.0825 * s * / (4 * (0.26173 * / s))).
      - replace (0.0825 * s * / (4 * (0.26173 * / s))) with (0.0825 / (4 * 0.26173) * (s * s)) by (field; lra).
        rewrite S2. lra.
      - apply Rmult_le_compat; [lra | left; apply Rinv_0_lt_compat; lra | lra | apply Rinv_le_contravar; lra]. }
    assert (X := Rmult_le_compat_l z _ _ Hz Ta). lra.
Qed.
End OneRatio.

Theorem theorem_A N q : steps -> layer -> bulk -> end_of_orbit -> (903 <= N)%nat -> critical N q ->
  law_constant * quarter q - (0.063 * ln q + 0.7) * / sqrt q <= delta N q <= law_constant * quarter q - 0.16 * / sqrt
    q /\
  1000000 <= q.
Proof.
  intros HS HL HB HE HN Hc. assert (Hq : 1000000 <= q).
  { destruct (theorem_2b 903 ltac:(lia)) as [p [Hp _]]. assert (L := above_a_million p HS Hp).
    destruct (Nat.eq_dec N 903) as [->|Z]; [rewrite (critical_unique 903 q p Hc Hp); lra|].
    assert (p < q); [|lra]. clear -HN Z Hp Hc. assert (Q := N_at_critical N q ltac:(lia) Hc). destruct Hc as [Hq Hc].
    apply (proj2 Hp q Hq). exists (N - 1)%nat. split; [exact Q | lia]. }
  split; [|exact Hq]. destruct (orbit_of_critical N q ltac:(lia) Hc) as [n [u [al [y Orb]]]].
  exact (both_halves N q Hc Hq n u al y Orb HL HB HE).
Qed.
(** 0.063 ln q + 0.7 < c0 q^(1/4). *)
Lemma A_positive q : 1000000 <= q -> (0.063 * ln q + 0.7) * / sqrt q < law_constant * quarter q.
Proof.
  intros Hq. assert (S : 1000 <= sqrt q) by (rewrite <- (sqrt_square 1000) by lra; apply sqrt_le_1; lra).
  set (w := sqrt (sqrt q)). assert (W : 31 <= w) by (rewrite <- (sqrt_square 31) by lra; apply sqrt_le_1; lra).
  assert (E1 : sqrt q = w * w) by (unfold w; rewrite sqrt_sqrt; lra).
  assert (E2 : q = w * w * (w * w)) by (rewrite <- E1, sqrt_sqrt; lra).
  unfold quarter. fold w. rewrite E1. assert (L : ln q = 4 * ln w).
  { rewrite E2. assert (0 < w * w) by (apply Rmult_lt_0_compat; lra). rewrite ln_mult, ln_mult by lra. ring. }
  assert (T : ln w <= w / 31 + 2.44).
  { assert (H := exp_ineq1_le (w / 31 - 1)). apply ln_le in H; [|lra]. rewrite ln_exp in H.
    replace (1 + (w / 31 - 1)) with (w * / 31) in H by field. rewrite ln_mult, ln_Rinv in H by lra.
    assert (V : ln 31 <= 3.435) by interval. lra. }
  destruct c0_value as [C _]. rewrite L, Rinv_mult, <- Rmult_assoc.
  apply Rmult_lt_compat_r; [apply Rinv_0_lt_compat; lra|].
  apply Rmult_lt_reg_r with w; [lra|]. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
  assert (0.17 * w <= law_constant * w) by (apply Rmult_le_compat_r; lra). lra.
Qed.
