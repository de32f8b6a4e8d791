(** Where the orbit ends (L47 of law.md), and its layer (L48). The tangent flight is treated as a step to the point y of
    tangency, which has the flight equation of a step.

    small_root      == decimals of sqrt eps
    tangent_at_most, tangent_at_least == tan from cos
    last_step, last_flat == the tangent flight as a step; y is small
    L47a_last       == u_b >= 4.42 sqrt eps
    L47b_beta       == at every contact tan beta <= 0.00717, 5.3 eps^2/u^3 <= 0.00195
    L47c_last       == u_b <= 0.18 if J_b >= pi/2 - 0.002
    L48_short       == in the layer d <= U/5, u <= 1.08 *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Dumbbell Require Import Quotients Sines PiValue LawStatement Angles Falls Orbit.
Local Open Scope R_scope.

Lemma sine_values : 0.2376 <= sin 0.24 /\ 0.389 <= sin 0.4 /\ 0.1395 <= sin 0.14 /\ cos 0.24 <= 0.9714 /\
  cos 0.18 <= 0.9839.
Proof. repeat split; interval. Qed.

(** The tangent flight as a step: Q, and J <= Q. *)
Section Last.
Variables eps u al y : R.
Hypothesis H : last eps u al y.
Let th := al + beta eps u.

Lemma last_step : 0 < eps /\ 0 < y < u /\ u <= PI/2 /\ 0 < beta eps u /\ 0 < th < PI/2 /\
  cos y - cos u = eps * tan th * (2 * PI - u - y) /\ eps * tan th = sin y /\ al = th - beta eps u /\ 0 <= al.
Proof.
  destruct H as [A [B1 B2] [C1 C2] D E]. fold th in C2, D. assert (HPI := PI2_1).
  assert (B := beta_pos eps u (proj1 A) ltac:(apply sin_gt_0; lra)). unfold th in *. rewrite D. repeat split; try lra.
Qed.
(** J <= Q, where Q = (pi - (u + y)/2) cos th. *)
Lemma last_invariant : invariant u al <= (PI - middle u y) * cos th.
Proof.
  destruct last_step as [A [B [C [D [E [F [G [I K]]]]]]]].
  assert (L := L44_before eps u y th A B C ltac:(lra) F). now rewrite <- I in L.
Qed.
(** tan y (3 pi/2 - y) <= 1. *)
Lemma last_flat : y <= 0.24.
Proof.
  destruct last_step as [A [B [C [D [E [F [G _]]]]]]]. assert (P := pi_value). rewrite G in F.
  assert (Cu : 0 <= cos u) by (apply cos_ge_0; lra). apply Rnot_lt_le. intros K.
  destruct sine_values as [V [V' [_ [W _]]]].
  assert (S : sin 0.24 <= sin y) by (apply sin_incr_1; lra).
  assert (L : cos y <= cos 0.24) by (apply cos_decr_1; lra).
  destruct (Rle_dec y 0.4) as [Y|Y].
  - assert (0.2376 * 4.3 <= sin y * (2 * PI - u - y)) by (apply Rmult_le_compat; lra). lra.
  - assert (S2 : sin 0.4 <= sin y) by (apply sin_incr_1; lra).
    assert (0.389 * 3.1 <= sin y * (2 * PI - u - y)) by (apply Rmult_le_compat; lra). lra.
Qed.
End Last.

(** tan th from cos th. *)
Lemma tangent_at_most th c t : 0 < th < PI/2 -> 0 <= c <= cos th -> 0 <= t -> 1 <= c * c * (1 + t * t) -> tan th <= t.
Proof.
  intros H Hc Ht E. destruct (tangent_square th H) as [A [B D]]. apply Rnot_lt_le. intros K.
  assert (t * t < tan th * tan th) by (apply Rmult_le_0_lt_compat; lra).
  assert (c * c <= cos th * cos th) by (apply Rmult_le_compat; lra).
  assert (0 < cos th * cos th) by (now apply Rmult_lt_0_compat).
  assert (c * c * (1 + t * t) <= cos th * cos th * (1 + t * t))
    by (apply Rmult_le_compat_r; [assert (0 <= t * t) by apply Rle_0_sqr|]; lra).
  assert (cos th * cos th * (1 + t * t) < cos th * cos th * (1 + tan th * tan th)) by (apply Rmult_lt_compat_l; lra).
  lra.
Qed.
Lemma tangent_at_least th c t : 0 < th < PI/2 -> cos th <= c -> 0 <= t -> c * c * (1 + t * t) <= 1 -> t <= tan th.
Proof.
  intros H Hc Ht E. destruct (tangent_square th H) as [A [B D]]. apply Rnot_lt_le. intros K.
  assert (tan th * tan th < t * t) by (apply Rmult_le_0_lt_compat; lra).
  assert (cos th * cos th <= c * c) by (apply Rmult_le_compat; lra).
  assert (0 < cos th * cos th) by (now apply Rmult_lt_0_compat).
  assert (c * c * (1 + t * t) >= cos th * cos th * (1 + t * t))
    by (apply Rle_ge, Rmult_le_compat_r; [assert (0 <= t * t) by apply Rle_0_sqr|]; lra).
  assert (cos th * cos th * (1 + tan th * tan th) < cos th * cos th * (1 + t * t)) by (apply Rmult_lt_compat_l; lra).
  lra.
Qed.
Lemma small_root eps : 0 < eps <= 1/1000 -> 0 < sqrt eps <= 0.03163 /\ sqrt eps * sqrt eps = eps.
Proof.
  intros H. split; [split; [apply sqrt_lt_R0; lra|] | apply sqrt_sqrt; lra].
  apply Rle_trans with (sqrt (1/1000)); [apply sqrt_le_1; lra | interval].
Qed.

(** L47 (a). *)
Lemma far_or_not eps u al y : eps <= 1/1000 -> last eps u al y -> invariant u al <= PI/2 + eps^2 / 4 ->
  0.14 <= u \/ 4.46 * sqrt eps <= u.
Proof.
  intros He H HJ. destruct (Rle_dec 0.14 u) as [U|U]; [now left|right].
  destruct (last_step eps u al y H) as [A [B [C [D [E [F [G [I K]]]]]]]]. assert (P := pi_value).
  assert (Y := last_flat eps u al y H). set (th := al + beta eps u) in *. rewrite G in F.
  assert (E2 : eps^2 <= 0.000001) by (apply Rle_trans with ((1/1000)^2); [apply pow_incr; lra | lra]).
  assert (C1 : cos al <= 0.52333).
  { apply Rmult_le_reg_l with (PI - u); [lra|]. apply Rle_trans with (1 := HJ).
    apply Rle_trans with ((PI - 0.14) * 0.52333); [lra | apply Rmult_le_compat_r; lra]. }
  assert (C2 : cos th <= cos al) by (apply cos_decr_1; lra).
  assert (T := tangent_at_least th 0.52333 1.628 E ltac:(lra) ltac:(lra) ltac:(lra)).
  assert (S : 1.628 * eps <= sin y) by (rewrite <- G, (Rmult_comm eps); apply Rmult_le_compat_r; lra).
  assert (Cu := cosine_below u ltac:(lra)). destruct (COS_bound y) as [_ Cy].
  assert (U2 : u * u <= 0.14 * 0.14) by (apply Rmult_le_compat; lra).
  assert (Sy : sin y * 5.9 <= sin y * (2 * PI - u - y)) by (apply Rmult_le_compat_l; lra).
  assert (Sl := sine_below y ltac:(lra)). assert (Y2 : y * y <= 0.24 * 0.24) by (apply Rmult_le_compat; lra).
  assert (Y3 : y * y * y <= 0.24 * 0.24 * y) by (apply Rmult_le_compat_r; lra).
  assert (Y4 : y <= 0.01) by lra.
  assert (Q : 1.628 * eps * 6.13 <= sin y * (2 * PI - u - y)) by (apply Rmult_le_compat; lra).
  destruct (small_root eps ltac:(lra)) as [S0 S1]. apply Rsqr_incr_0_var; [unfold Rsqr | lra].
  replace (4.46 * sqrt eps * (4.46 * sqrt eps)) with (4.46 * 4.46 * (sqrt eps * sqrt eps)) by ring. rewrite S1. lra.
Qed.
Theorem L47a_last eps u al y : eps <= 1/1000 -> last eps u al y -> invariant u al <= PI/2 + eps^2 / 4 ->
  4.42 * sqrt eps <= u.
Proof.
  intros He H HJ. destruct (last_step eps u al y H) as [A _]. destruct (small_root eps ltac:(lra)) as [S0 S1].
  destruct (far_or_not eps u al y He H HJ); lra.
Qed.
(** L47 (b): at the last contact, and so at every contact before it. *)
Theorem L47b_beta eps u al y v : eps <= 1/1000 -> last eps u al y -> invariant u al <= PI/2 + eps^2 / 4 ->
  u <= v <= PI/2 ->
  eps / sin v <= 0.00717 /\ 5.3 * eps^2 / v^3 <= 0.00195.
Proof.
  intros He H HJ Hv. destruct (last_step eps u al y H) as [A [B _]]. destruct (small_root eps ltac:(lra)) as [S0 S1].
  assert (P := pi_value). set (s := sqrt eps) in *. assert (V := L47a_last eps u al y He H HJ). fold s in V.
  assert (Su : 0 < sin u) by (apply sin_gt_0; lra). assert (Sv : sin u <= sin v) by (apply sin_incr_1; lra). split.
  - apply Rmult_le_reg_r with (sin v); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    assert (K : eps <= 0.00717 * sin u); [|lra]. assert (F := far_or_not eps u al y He H HJ). fold s in F.
    destruct sine_values as [_ [_ [S14 _]]].
    destruct (Rle_dec 0.14 u) as [U|U]; [assert (sin 0.14 <= sin u) by (apply sin_incr_1; lra); lra|].
    destruct F as [F|F]; [lra|]. assert (Sl := sine_below u ltac:(lra)).
    assert (u * u <= 0.14 * 0.14) by (apply Rmult_le_compat; lra).
    assert (u * u * u <= 0.14 * 0.14 * u) by (apply Rmult_le_compat_r; lra).
    assert (s * s <= 0.03163 * s) by (apply Rmult_le_compat_r; lra). lra.
  - assert (V3 : (4.42 * s) ^ 3 <= v ^ 3) by (apply pow_incr; lra).
    assert (P3 : 0 < (4.42 * s) ^ 3) by (apply pow_lt; lra).
    apply Rmult_le_reg_r with (v ^ 3); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    assert (K : 5.3 * eps ^ 2 <= 0.00195 * (4.42 * s) ^ 3); [|lra]. rewrite <- S1.
    replace (5.3 * (s * s) ^ 2) with (s * s * s * (5.3 * s)) by ring.
    replace (0.00195 * (4.42 * s) ^ 3) with (s * s * s * (0.00195 * 4.42 ^ 3)) by ring.
    apply Rmult_le_compat_l; [repeat apply Rmult_le_pos; lra | lra].
Qed.
(** L47 (c). *)
Theorem L47c_last eps u al y : eps <= 1/1000 -> last eps u al y -> PI/2 - 0.002 <= invariant u al -> u <= 0.18.
Proof.
  intros He H HJ. apply Rnot_lt_le. intros U. destruct (last_step eps u al y H) as [A [B [C [D [E [F [G [I K]]]]]]]].
  assert (P := pi_value). assert (Y := last_flat eps u al y H). assert (L := last_invariant eps u al y H).
  set (th := al + beta eps u) in *. rewrite G in F. destruct (tangent_square th E) as [C0 [T0 _]].
  assert (C1 : 0.514 <= cos th).
  { apply Rmult_le_reg_l with (PI - middle u y); [unfold middle; lra|]. apply Rle_trans with (2 := L).
    apply Rle_trans with (2 := HJ).
    apply Rle_trans with ((PI - 0.09) * 0.514); [apply Rmult_le_compat_r; unfold middle; lra | lra]. }
  assert (T := tangent_at_most th 0.514 1.67 E ltac:(lra) ltac:(lra) ltac:(lra)).
  assert (S : sin y <= 1/1000 * 1.67) by (rewrite <- G; apply Rmult_le_compat; lra).
  assert (Sl := sine_below y ltac:(lra)). assert (Y2 : y * y <= 0.24 * 0.24) by (apply Rmult_le_compat; lra).
  assert (Y3 : y * y * y <= 0.24 * 0.24 * y) by (apply Rmult_le_compat_r; lra).
  assert (Y4 : y <= 0.01) by lra. assert (Cy := cosine_below y ltac:(lra)).
  assert (y * y <= 0.01 * 0.01) by (apply Rmult_le_compat; lra).
  destruct sine_values as [_ [_ [_ [_ V]]]]. assert (W : cos u <= cos 0.18) by (apply cos_decr_1; lra).
  assert (Q : sin y * (2 * PI - u - y) <= 1/1000 * 1.67 * 6.3)
    by (apply Rmult_le_compat; try lra; apply sin_ge_0; lra). lra.
Qed.

(** L48: the height grows by more at each flight than at the one before. *)
Section Layer.
Variables (eps : R) (u al : nat -> R) (n : nat) (y : R).
Hypothesis HS : sequence eps u al n.
Hypothesis HL : last eps (u n) (al n) y.
Lemma rise_next i : (i < n)%nat -> cos (u (S i)) - cos (u i) <= 1 - cos (u (S i)).
Proof.
  intros Hi. destruct (step_at eps u al n HS i Hi) as [A [B [C [D [E [F [G [K M]]]]]]]].
  set (th := al i + beta eps (u i)) in *.
  assert (P := pi_value). assert (Su : 0 < sin (u (S i))) by (apply sin_gt_0; lra).
  assert (Q := beta_pos eps _ (proj1 A) Su).
  assert (N : exists v, 0 < v < u (S i) /\ al (S i) + beta eps (u (S i)) < PI/2 /\
    cos v - cos (u (S i)) = eps * tan (al (S i) + beta eps (u (S i))) * (2 * PI - u (S i) - v)).
  { destruct (Nat.eq_dec (S i) n) as [Z|Z].
    - rewrite Z. exists y. destruct (last_step eps (u n) (al n) y HL) as [A' [B' [_ [_ [E' [F' _]]]]]].
      repeat split; try apply B'; [apply E' | exact F'].
    - exists (u (S (S i))). destruct (step_at eps u al n HS (S i) ltac:(lia)) as [_ [B' [_ [D' [E' _]]]]].
      repeat split; try apply B'; [apply D' | exact E']. }
  destruct N as [v [V1 [V2 V3]]]. destruct (COS_bound v) as [_ V4]. rewrite E.
  assert (T : tan th < tan (al (S i) + beta eps (u (S i)))) by (apply tan_increasing; unfold th in *; lra).
  assert (T0 : 0 <= tan th) by (destruct (Req_dec th 0) as [->|]; [rewrite tan_0; lra | left; apply tan_gt_0; lra]).
  assert (R : eps * tan th * (2 * PI - u i - u (S i)) <= eps * tan (al (S i) + beta eps (u (S i))) * (2 * PI - u (S i)
    - v)).
  { apply Rmult_le_compat; [apply Rmult_le_pos; lra | lra | apply Rmult_le_compat_l; lra | lra]. }
  lra.
Qed.
Theorem L48_short i : (i < n)%nat -> middle (u i) (u (S i)) <= 9/10 ->
  half (u i) (u (S i)) <= middle (u i) (u (S i)) / 5 /\ u i <= 1.08.
Proof.
  intros Hi HU. assert (R := rise_next i Hi). destruct (step_at eps u al n HS i Hi) as [_ [B [C _]]].
  unfold middle, half in *.
  set (w := u i / 2). set (w' := u (S i) / 2). assert (E : u i = 2 * w) by (unfold w; field).
  assert (E' : u (S i) = 2 * w') by (unfold w'; field).
  rewrite E, E' in *. rewrite !cos_2a_sin in R. assert (S1 := sine_square w' ltac:(lra)).
  assert (S2 := sine_below w ltac:(lra)).
  assert (P := pi_value). assert (W2 : 0 <= w * w) by (apply Rmult_le_pos; lra).
  assert (K : forall m t, 0 <= m < 6 -> 0 < t -> w * w <= m -> 1.41422 <= t * (1 - m / 6) -> w <= t * w').
  { intros m t M0 T0 M T.
    assert (X1 : w * (1 - m / 6) <= sin w)
      by (apply Rle_trans with (2 := S2); assert (w * w * w <= m * w) by (apply Rmult_le_compat_r; lra); lra).
    assert (X2 : 0 <= sin w) by (apply sin_ge_0; lra).
    assert (X3 : sin w <= 1.41422 * w').
    { apply Rsqr_incr_0_var; unfold Rsqr; [|lra]. assert (0 <= w' * w') by (apply Rmult_le_pos; lra). lra. }
    assert (X4 : t * (w * (1 - m / 6)) <= t * (1.41422 * w')) by (apply Rmult_le_compat_l; lra).
    assert (X5 : w * 1.41422 <= w * (t * (1 - m / 6))) by (apply Rmult_le_compat_l; lra). lra. }
  assert (A1 : w * w <= 0.81) by (apply Rle_trans with (0.9 * 0.9); [apply Rmult_le_compat |]; lra).
  assert (K1 := K 0.81 1.636 ltac:(lra) ltac:(lra) A1 ltac:(lra)).
  assert (A2 : w * w <= 0.313) by (apply Rle_trans with (0.559 * 0.559); [apply Rmult_le_compat |]; lra).
  assert (K2 := K 0.313 1.493 ltac:(lra) ltac:(lra) A2 ltac:(lra)). lra.
Qed.
End Layer.
