(** What (C6) and (C7) say of the defect D of a step of the layer (L57 (a) of law.md). With Delta, y of the step:

    scale            == h = y Delta, which is (c/2) s
    scale_value      == decimals of c/2
    L57a_product     == k0 s h = eps/(3 sqrt 3); so D0(T) y = eps Delta^2/(3 sqrt 3)
    place_range      == h <= 0.0739, y^2 <= 1.334
    layer_powers     == 0 < D <= D0(T), and the two bounds without a quotient *)
From Coq Require Import Reals Lra.
From Interval Require Import Tactic.
From Dumbbell Require Import LawStatement Differences Cubes Comparison.
Local Open Scope R_scope.

Definition scale eps := sqrt (4 * sqrt 3 * PI) / 2 * sqrt eps.
Lemma scale_value : 2.3326 <= sqrt (4 * sqrt 3 * PI) / 2 <= 2.3327.
Proof. split; interval. Qed.
Lemma L57a_product eps : 0 < eps -> step_constant * sqrt eps * scale eps = eps / (3 * sqrt 3).
Proof.
  intros He. assert (P := PI_RGT_0). destruct root_three as [S3 _]. assert (E := sqrt_sqrt eps ltac:(lra)).
  unfold scale. rewrite step_constant_is. rewrite !sqrt_mult_alt by lra.
  replace (sqrt 4) with 2 by (replace 4 with (2 * 2) by ring; now rewrite sqrt_square by lra).
  assert (0 < sqrt PI) by (now apply sqrt_lt_R0). assert (0 < sqrt (sqrt 3)) by (now apply sqrt_lt_R0).
  rewrite <- E at 3. field. repeat split; lra.
Qed.

Section Place.
Variables eps T D : R.
Hypothesis He : 0 < eps <= 1/1000.
Hypothesis HT : 1 < T <= 0.06125 / eps.
Let z := step_constant * sqrt eps.
Let h := scale eps.
Let d := difference T.
Let y := place eps T.
Let g := 5 / (3 * PI).

Lemma place_range : 0 < d <= 1 /\ 0 < y /\ y * d = h /\ 0 < h <= 0.0739 /\ y * y <= 1.334.
Proof.
  assert (F := difference_falls 1 T ltac:(lra)). rewrite difference_one in F. fold d in F.
  destruct scale_value as [C1 C2]. set (c := sqrt (4 * sqrt 3 * PI) / 2) in *.
  assert (S0 : 0 < sqrt eps) by (apply sqrt_lt_R0; lra). assert (S2 := sqrt_sqrt eps ltac:(lra)).
  assert (S1 : sqrt eps <= 0.03163) by (apply Rle_trans with (sqrt (1/1000)); [apply sqrt_le_1; lra | interval]).
  assert (H0 : 0 < h) by (apply Rmult_lt_0_compat; [fold c; lra | exact S0]).
  assert (H1 : h <= 2.3327 * 0.03163) by (apply Rmult_le_compat; fold c; lra).
  assert (Y : y * d = h) by (unfold y, place; fold d; fold (scale eps); fold h; field; lra).
  assert (Y0 : 0 < y) by (apply Rdiv_lt_0_compat; [exact H0 | fold d; lra]). repeat split; try lra.
  destruct (root_step T ltac:(lra)) as [R P]. fold d in R.
  assert (R1 : sqrt (T - 1) <= sqrt T) by (apply sqrt_le_1; lra). assert (R2 := sqrt_sqrt T ltac:(lra)).
  assert (Y2 : y = h * (sqrt T + sqrt (T - 1))).
  { rewrite <- Y, R. field. lra. }
  assert (Y3 : y <= h * (2 * sqrt T)) by (rewrite Y2; apply Rmult_le_compat_l; lra).
  apply Rle_trans with (h * (2 * sqrt T) * (h * (2 * sqrt T))); [apply Rmult_le_compat; lra|].
  replace (h * (2 * sqrt T) * (h * (2 * sqrt T))) with (c * c * (4 * (sqrt eps * sqrt eps * (sqrt T * sqrt T))))
    by (unfold h, scale; fold c; ring).
  rewrite R2, S2. assert (ET : eps * T <= 0.06125).
  { apply Rle_trans with (eps * (0.06125 / eps)); [apply Rmult_le_compat_l; lra | right; field; lra]. }
  assert (0 <= eps * T) by (apply Rmult_le_pos; lra).
  apply Rle_trans with (2.3327 * 2.3327 * (4 * 0.06125)); [|lra].
  apply Rmult_le_compat; [apply Rle_0_sqr | lra | apply Rmult_le_compat; lra | lra].
Qed.

Hypothesis C7 : comparison eps T * (1 - y * (5 / (3 * PI) + 0.125 * y + 0.45 * d^2)) <= D.
Hypothesis C6 : D <= comparison eps T * (1 - y * (5 / (3 * PI) - 0.155 * y - 0.43 * d^2)).
Theorem layer_powers : 0 < D <= z * d^3 /\ z * (d^3 - h * (g * d^2 + 0.125 * h * d + 0.45 * d^4)) <= D /\
  D <= z * (d^3 - h * (g * d^2 - 0.155 * h * d - 0.43 * d^4)).
Proof.
  destruct place_range as [D1 [Y0 [Y1 [H1 Y2]]]]. fold g in C6, C7.
  assert (G : 0.5305 <= g <= 0.5306) by (unfold g; split; interval).
  assert (Z0 : 0 < z).
  { destruct k0_value. apply Rmult_lt_0_compat; [lra | apply sqrt_lt_R0; lra]. }
  assert (D3 : 0 < d^3) by (apply pow_lt; lra). assert (DD : d * d <= 1 * 1) by (apply Rmult_le_compat; lra).
  assert (K : comparison eps T = z * d^3) by reflexivity. rewrite K in C6, C7.
  assert (ZD : 0 < z * d^3) by (now apply Rmult_lt_0_compat).
  assert (YG : y * g <= y * 0.5306) by (apply Rmult_le_compat_l; lra).
  assert (Q : 0 <= g - 0.155 * y - 0.43 * d^2 /\ y * (g + 0.125 * y + 0.45 * d^2) < 1).
  { replace (y * (g + 0.125 * y + 0.45 * d^2)) with (y * g + 0.125 * (y * y) + 0.45 * (y * d) * d) by ring. rewrite Y1.
    replace (d^2) with (d * d) by ring. destruct (Rle_dec 0.3 d) as [L|L].
    - assert (y * 0.3 <= y * d) by (apply Rmult_le_compat_l; lra). assert (Y : y <= 0.2464) by lra.
      assert (y * y <= 0.2464 * 0.2464) by (apply Rmult_le_compat; lra).
      assert (h * d <= 0.0739 * 1) by (apply Rmult_le_compat; lra). lra.
    - assert (Y : y <= 1.16).
      { apply Rnot_lt_le. intros B. assert (1.16 * 1.16 < y * y) by (apply Rmult_le_0_lt_compat; lra). lra. }
      assert (d * d <= 0.3 * 0.3) by (apply Rmult_le_compat; lra).
      assert (h * d <= 0.0739 * 0.3) by (apply Rmult_le_compat; lra). lra. }
  destruct Q as [Q1 Q2]. assert (0 < z * d^3 * (1 - y * (g + 0.125 * y + 0.45 * d^2))) by (apply Rmult_lt_0_compat; lra).
  assert (0 <= z * d^3 * (y * (g - 0.155 * y - 0.43 * d^2))) by (apply Rmult_le_pos; [lra | apply Rmult_le_pos; lra]).
  split; [lra|].
  assert (E : forall p r, z * (d^3 - h * (g * d^2 + p * h * d + r * d^4)) = z * d^3 * (1 - y * (g + p * y + r * d^2)))
    by (intros; rewrite <- Y1; ring).
  assert (E7 := E 0.125 0.45). assert (E6 := E (- 0.155) (- 0.43)). split; [rewrite E7; exact C7|].
  apply Rle_trans with (1 := C6). apply Rle_trans with (z * d^3 * (1 - y * (g + - 0.155 * y + - 0.43 * d^2))); [lra|].
  rewrite <- E6. lra.
Qed.
End Place.
