(** A step's place in the layer, by the rule's jets (L50 (a) and L57 (a) of law.md).

    roots_by_half  == B = 2 half sqrt (eps^/2)
    ratio_by_half  == Rr = m half^3/(2 k0 eps^^(3/2))
    place_by_half  == y = U half sqrt (eps^ sqrt 3 pi), Delta^2 = rho/half^2 *)
From Coq Require Import Reals Lra.
From Dumbbell Require Import LawStatement Differences Cubes Comparison.
Local Open Scope R_scope.

Section Place.
Variables U rho e k1 : R.
Hypothesis HU : 0 < U.
Hypothesis Hr : 0 < rho < 1.
Hypothesis He : 0 < e.
Hypothesis Hk : 0 < k1.
Let k := 2 * k1 / e.
Let below := (k - 1) * ((1 + rho) / (1 - rho) * ((1 + rho) / (1 - rho))) + 1.
Let half := ((sqrt k - 1) * (1 + rho) + (sqrt below - 1) * (1 - rho)) / 2 + 1.
Let eps := rho * U^2 * e.
Let T := ((1 + rho) * U)^2 * k1 / (2 * eps).

Lemma roots_by_half : roots rho e k1 = 2 * half * (sqrt e / sqrt 2) /\ 0 < half.
Proof.
  assert (S2 : 0 < sqrt 2) by (apply sqrt_lt_R0; lra). assert (Se : 0 < sqrt e) by (now apply sqrt_lt_R0).
  assert (E : sqrt (e / 2) = sqrt e / sqrt 2) by (apply sqrt_div_alt; lra).
  assert (E1 : sqrt k1 = sqrt (e / 2) * sqrt k) by (rewrite <- sqrt_mult_alt by lra; f_equal; unfold k; field; lra).
  assert (E2 : sqrt ((1 + rho)^2 * k1 - 2 * rho * e) = sqrt (e / 2) * ((1 - rho) * sqrt below)).
  { rewrite <- (sqrt_pow2 (1 - rho)) at 1 by lra. rewrite <- !sqrt_mult_alt by (try apply pow2_ge_0; lra). f_equal.
    unfold below, k. field. lra. }
  assert (K : 0 < sqrt k) by (apply sqrt_lt_R0; unfold k; apply Rdiv_lt_0_compat; lra). assert (B := sqrt_pos below).
  unfold roots. rewrite E1, E2, E. split; [unfold half; field; lra|]. unfold half.
  assert (0 < sqrt k * (1 + rho)) by (apply Rmult_lt_0_compat; lra).
  assert (0 <= sqrt below * (1 - rho)) by (apply Rmult_le_pos; lra).
  lra.
Qed.
Lemma ratio_by_half m : ratio m rho e k1 = m * (half * (half * half)) / (e * sqrt e) / (2 * step_constant).
Proof.
  destruct roots_by_half as [R P]. destruct k0_value as [K _]. assert (S2 : 0 < sqrt 2) by (apply sqrt_lt_R0; lra).
  assert (Se : 0 < sqrt e) by (now apply sqrt_lt_R0). assert (Q2 := sqrt_sqrt 2 ltac:(lra)).
  assert (Qe := sqrt_sqrt e ltac:(lra)).
  unfold ratio. rewrite R. set (s := sqrt e) in *. set (t := sqrt 2) in *. rewrite <- Qe.
  field_simplify_eq; [|repeat split; lra]. replace (t^4) with (t * t * (t * t)) by ring. rewrite Q2. ring.
Qed.
Hypothesis HT : 1 <= T.
Theorem place_by_half : place eps T = U * (half * sqrt (e * (sqrt 3 * PI))) /\ difference T ^ 2 = rho / (half * half).
Proof.
  destruct roots_by_half as [R P]. assert (PP := PI_RGT_0). destruct root_three as [S3 _].
  assert (W : 0 < 2 * rho * e) by (repeat apply Rmult_lt_0_compat; lra).
  assert (S2 : 0 < sqrt 2) by (apply sqrt_lt_R0; lra). assert (Q2 := sqrt_sqrt 2 ltac:(lra)).
  assert (Se : 0 < sqrt e) by (now apply sqrt_lt_R0). assert (Qe := sqrt_sqrt e ltac:(lra)).
  set (w := sqrt (2 * rho * e)). assert (W0 : 0 < w) by (now apply sqrt_lt_R0).
  assert (Ww : w * w = 2 * rho * e) by (apply sqrt_sqrt; lra).
  assert (TI : T = (1 + rho)^2 * k1 / (2 * rho * e)) by (unfold T, eps; field; lra).
  assert (B0 : 0 < roots rho e k1) by (rewrite R; apply Rmult_lt_0_compat; [lra | now apply Rdiv_lt_0_compat]).
  assert (E1 : sqrt T = (1 + rho) * sqrt k1 / w).
  { rewrite TI, sqrt_div_alt by exact W. fold w. f_equal. rewrite sqrt_mult_alt by apply pow2_ge_0. f_equal.
    rewrite sqrt_pow2; lra. }
  assert (E2 : sqrt (T - 1) = sqrt ((1 + rho)^2 * k1 - 2 * rho * e) / w).
  { rewrite TI. replace ((1 + rho)^2 * k1 / (2 * rho * e) - 1) with (((1 + rho)^2 * k1 - 2 * rho * e) / (2 * rho * e))
    by (field; lra).
    now rewrite sqrt_div_alt by exact W. }
  assert (D : difference T = w / roots rho e k1).
  { destruct (root_step T HT) as [-> _]. rewrite E1, E2. unfold roots in *. field. split; lra. }
  assert (E4 : sqrt eps = w * U / sqrt 2).
  { replace eps with (2 * rho * e / 2 * U^2) by (unfold eps; field). rewrite sqrt_mult_alt by lra.
    rewrite sqrt_pow2 by lra.
    rewrite sqrt_div_alt by lra. fold w. field. lra. }
  assert (E5 : sqrt (4 * sqrt 3 * PI) = 2 * sqrt (sqrt 3 * PI)).
  { rewrite Rmult_assoc, sqrt_mult_alt by lra. f_equal. replace 4 with (2 * 2) by ring.
    now rewrite sqrt_square by lra. }
  split.
  - unfold place. rewrite D, E4, E5, R. rewrite (sqrt_mult_alt e) by lra. set (x := sqrt (sqrt 3 * PI)).
    set (s := sqrt e) in *.
    set (t := sqrt 2) in *. field_simplify_eq; [|repeat split; lra]. replace (t^2) with (t * t) by ring. rewrite Q2.
    ring.
  - rewrite D, R. replace ((w / (2 * half * (sqrt e / sqrt 2)))^2)
    with (w * w * (sqrt 2 * sqrt 2) / (4 * (half * half) * (sqrt e * sqrt e)))
      by (field; lra). rewrite Ww, Q2, Qe. field. lra.
Qed.
End Place.

(** What a leaf of the layer is checked for, in numbers: Rr starts with 1 and with the slope of L57 (b), y/U with 1.
*)
Lemma excess_is U rho q Rr v bend rise : 0 < U -> 0 < v -> rho < 1 ->
  Rr = 1 - U * (5 / (3 * PI) + rho^2 / (3 * PI) * (12 * q - / (1 - rho))) + U * U * bend -> v = 1 + U * rise ->
  1 - Rr = U * v * (5 / (3 * PI) + (rho * (rho * ((12 * q - 1 / (1 - rho)) / (3 * PI)) / v) + U * (- (bend + 5 / (3 *
    PI) * rise) / v))).
Proof. intros HU Hv Hr -> Ev. assert (P := PI_RGT_0). rewrite Ev in *. field. repeat split; lra. Qed.
