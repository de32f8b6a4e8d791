(** The defect beside the comparison function (L50 of law.md).

    roots            == B
    ratio            == Rr, (13), with m = 2 eps D/d^3
    L50a_late        == T >= 1 if and only if (1 + rho)^2 k1 >= 2 rho eps^
    L50a_ratio       == D = D0 T Rr
    root_three       == sqrt 3 sqrt 3 = 3
    step_constant_is == k0 = 3^(-7/4) pi^(-1/2) in square roots
    L50b_first, L50b_second == m1 and m2 at U = 0, from the values there of G1, H, a, a_p, g1, mu
    L50b_constant    == with their sum m0 and eps^ = 1/(sqrt 3 pi), Rr = 1: this fixes k0 *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import LawStatement Differences Cubes Clock Midpoint.
Local Open Scope R_scope.

(** The place in the layer: U, rho, eps^ and k1 = tau/u^2; B is the sum of two roots. *)
Definition roots rho e k1 := (1 + rho) * sqrt k1 + sqrt ((1 + rho)^2 * k1 - 2 * rho * e).
Definition ratio m rho e k1 := m * roots rho e k1 ^ 3 / (4 * sqrt 2 * step_constant * e^3).   (* 4 sqrt 2 = 2^(5/2) *)

Section Place.
Variables U rho e k1 : R.
Hypothesis HU : 0 < U.
Hypothesis Hr : 0 < rho.
Hypothesis He : 0 < e.
Hypothesis Hk : 0 < k1.
Let eps := rho * U^2 * e.
Let u := (1 + rho) * U.
Let T := u^2 * k1 / (2 * eps).

Lemma time_is : T = (1 + rho)^2 * k1 / (2 * rho * e).
Proof. unfold T, u, eps. field. lra. Qed.
Theorem L50a_late : 1 <= T <-> 2 * rho * e <= (1 + rho)^2 * k1.
Proof.
  rewrite time_is. assert (W : 0 < 2 * rho * e) by (apply Rmult_lt_0_compat; lra). set (x := (1 + rho)^2 * k1).
  split; intros K.
  - apply Rmult_le_compat_r with (r := 2 * rho * e) in K; [|lra].
    replace (x / (2 * rho * e) * (2 * rho * e)) with x in K by (field; lra). lra.
  - apply Rmult_le_reg_r with (2 * rho * e); [exact W|].
    replace (x / (2 * rho * e) * (2 * rho * e)) with x by (field; lra). lra.
Qed.
Theorem L50a_ratio m D : 1 <= T -> 2 * eps * D = m * (rho * U)^3 -> D = comparison eps T * ratio m rho e k1.
Proof.
  intros HT HD. assert (W : 0 < 2 * rho * e) by (apply Rmult_lt_0_compat; lra). assert (L := proj1 L50a_late HT).
  destruct k0_value as [K _]. assert (S2 : 0 < sqrt 2) by (apply sqrt_lt_R0; lra).
  assert (Q2 := sqrt_sqrt 2 ltac:(lra)).
  set (w := sqrt (2 * rho * e)). assert (W0 : 0 < w) by (apply sqrt_lt_R0; exact W).
  assert (Ww : w * w = 2 * rho * e) by (apply sqrt_sqrt; lra).
  set (B := roots rho e k1). assert (B0 : 0 < B).
  { unfold B, roots. assert (0 < sqrt k1) by (apply sqrt_lt_R0; lra).
    assert (0 < (1 + rho) * sqrt k1) by (apply Rmult_lt_0_compat; lra).
    assert (0 <= sqrt ((1 + rho)^2 * k1 - 2 * rho * e)) by apply sqrt_pos. lra. }
  assert (E1 : sqrt T = (1 + rho) * sqrt k1 / w).
  { rewrite time_is, sqrt_div_alt by exact W. fold w. f_equal. rewrite sqrt_mult_alt by apply pow2_ge_0. f_equal.
    rewrite sqrt_pow2; lra. }
  assert (E2 : sqrt (T - 1) = sqrt ((1 + rho)^2 * k1 - 2 * rho * e) / w).
  { rewrite time_is. replace ((1 + rho)^2 * k1 / (2 * rho * e) - 1)
      with (((1 + rho)^2 * k1 - 2 * rho * e) / (2 * rho * e)) by (field; lra).
    now rewrite sqrt_div_alt by exact W. }
  assert (E3 : sqrt T + sqrt (T - 1) = B / w) by (rewrite E1, E2; unfold B, roots; field; lra).
  assert (E4 : sqrt eps = w * U / sqrt 2).
  { replace eps with (2 * rho * e / 2 * U^2) by (unfold eps; field). rewrite sqrt_mult_alt by lra.
    rewrite sqrt_pow2 by lra.
    rewrite sqrt_div_alt by lra. fold w. field. lra. }
  assert (C : comparison eps T = step_constant * (w * U / sqrt 2) * (w / B)^3).
  { unfold comparison. destruct (root_step T HT) as [-> _]. rewrite E3, E4.
    replace (/ (B / w)) with (w / B) by (field; lra). reflexivity. }
  assert (V : 0 < U * U) by (now apply Rmult_lt_0_compat).
  assert (X : D = m * rho^2 * U / (2 * e)) by (apply Rmult_eq_reg_l with (2 * eps); [rewrite HD; unfold eps; field;
    lra |
    unfold eps; apply Rgt_not_eq; assert (0 < rho * U^2 * e) by (repeat apply Rmult_lt_0_compat; lra); lra]).
  rewrite C, X. unfold ratio. fold B.
  replace (step_constant * (w * U / sqrt 2) * (w / B)^3 * (m * B^3 / (4 * sqrt 2 * step_constant * e^3))) with
    (m * U * (w * w)^2 / (4 * (sqrt 2 * sqrt 2) * e^3)) by (field; repeat split; lra). rewrite Ww, Q2. field. lra.
Qed.
End Place.

(** At U = 0, where F = pi and Q = pi/2. *)
Lemma root_value : root PI (PI / 2) = sqrt 3 * (PI / 2).
Proof.
  assert (P := PI_RGT_0). unfold root. replace (PI * PI - PI / 2 * (PI / 2)) with (3 * (PI / 2)^2) by field.
  rewrite sqrt_mult_alt by lra. now rewrite sqrt_pow2 by lra.
Qed.
Lemma root_three : 0 < sqrt 3 /\ sqrt 3 * sqrt 3 = 3.
Proof. split; [apply sqrt_lt_R0; lra | apply sqrt_sqrt; lra]. Qed.
Lemma step_constant_is : step_constant = / (3 * sqrt 3 * sqrt (sqrt 3) * sqrt PI).
Proof.
  assert (P := PI_RGT_0). destruct root_three as [S Q]. assert (SP : 0 < sqrt PI) by (now apply sqrt_lt_R0).
  set (f := sqrt (sqrt 3)). assert (F : 0 < f) by (now apply sqrt_lt_R0).
  unfold step_constant. rewrite Rpower_Ropp. replace (7 / 4) with (1 + / 2 + / 2 * / 2) by field.
  rewrite !Rpower_plus, <- Rpower_mult, Rpower_1, !Rpower_sqrt by (try apply exp_pos; lra). fold f. field.
  repeat split; lra.
Qed.
Theorem L50b_first : - (2 / 3) * G1 PI (PI / 2) = 14 / (9 * sqrt 3 * PI^2) /\
  H PI (PI / 2) = 8 / (3 * sqrt 3 * PI^2) /\
  G PI (PI / 2) = / (sqrt 3 * PI).
Proof.
  assert (P := PI_RGT_0). destruct root_three as [S Q].
  assert (C : sqrt 3 ^ 3 = 3 * sqrt 3) by (simpl; rewrite Rmult_1_r, Q; ring).
  assert (E : (sqrt 3 * (PI / 2)) ^ 3 = 3 * sqrt 3 * (PI / 2)^3) by (rewrite Rpow_mult_distr, C; ring).
  unfold G1, H, G. fold (root PI (PI / 2)). rewrite root_value, E. repeat split; field; lra.
Qed.
Theorem L50b_second rho : 0 <= rho < 1 -> let h := H PI (PI / 2) in
  (1 + rho)^2 * (h / 2) * (1 / (1 - rho^2)) + 2 * h * (- 1 / (2 * (1 - rho))) = - (h / 2).
Proof. intros Hr h. field. assert (0 < (1 - rho) * (1 + rho)) by (apply Rmult_lt_0_compat; lra). split; lra. Qed.
Theorem L50b_constant rho : 0 <= rho <= 1/5 -> let e := G PI (PI / 2) in
  ratio (- (2 / 3) * G1 PI (PI / 2) - H PI (PI / 2) / 2) rho e (e / 2) = 1.
Proof.
  intros Hr. cbv zeta. assert (P := PI_RGT_0). destruct root_three as [S Q]. destruct L50b_first as [-> [-> ->]].
  set (e := / (sqrt 3 * PI)). assert (E0 : 0 < sqrt 3 * PI) by (apply Rmult_lt_0_compat; lra).
  assert (E : 0 < e) by (now apply Rinv_0_lt_compat).
  unfold ratio, roots. replace ((1 + rho)^2 * (e / 2) - 2 * rho * e) with ((1 - rho)^2 * (e / 2)) by field.
  rewrite sqrt_mult_alt by apply pow2_ge_0. rewrite sqrt_pow2 by lra. set (h := sqrt (e / 2)).
  assert (Hh : h * h = e / 2) by (apply sqrt_sqrt; lra). replace ((1 + rho) * h + (1 - rho) * h) with (2 * h) by ring.
  assert (S2 : 0 < sqrt 2) by (apply sqrt_lt_R0; lra). assert (Q2 := sqrt_sqrt 2 ltac:(lra)).
  assert (SP : 0 < sqrt PI) by (now apply sqrt_lt_R0). assert (QP := sqrt_sqrt PI ltac:(lra)).
  set (f := sqrt (sqrt 3)). assert (F : 0 < f) by (now apply sqrt_lt_R0).
  assert (QF : f * f = sqrt 3) by (apply sqrt_sqrt; lra).
  assert (H1 : h = / (sqrt 2 * f * sqrt PI)).
  { unfold h. replace (e / 2) with (/ (2 * (sqrt 3 * PI))) by (unfold e; field; lra).
    rewrite sqrt_inv, sqrt_mult_alt, sqrt_mult_alt by lra. f_equal. unfold f. ring. }
  rewrite step_constant_is. fold f. replace ((2 * h)^3) with (8 * (h * h) * h) by ring. rewrite Hh, H1. unfold e.
  replace (PI^2) with (PI * PI) by ring. replace ((/ (sqrt 3 * PI))^3) with (/ (3 * sqrt 3 * PI^3))
    by (rewrite pow_inv, Rpow_mult_distr; replace (sqrt 3 ^ 3) with (sqrt 3 * sqrt 3 * sqrt 3) by ring;
      now rewrite Q).
  transitivity (3 * (14 / 9 - 4 / 3) * 3 / (sqrt 2 * sqrt 2)); [|rewrite Q2; field].
  field_simplify_eq; [|repeat split; lra]. replace (sqrt 3 ^ 2) with 3 by (simpl; lra). ring.
Qed.
