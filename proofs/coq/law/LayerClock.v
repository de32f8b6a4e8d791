(** Condition (C5) of law.md: at every step of the layer the clock shows more than 1. No certificate says so: with
    eps <= 0.2253 d U near the peak, or u >= 0.2, L45 (c) bounds the clock from below.

    G_value == G(pi, J) at the least J
    C5      == T > 1 *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Dumbbell Require Import Quotients Sines PiValue LawStatement Angles Falls Ends Clock.
Local Open Scope R_scope.

Lemma G_value : 0.181 <= G PI (PI/2 - 0.01).
Proof. unfold G. interval. Qed.
Theorem C5 eps u al u' al' : step eps u al u' al' -> eps <= 1/1000 -> let U := middle u u' in U <= 9/10 ->
  half u u' <= U / 5 -> PI/2 - 1/100 <= middle_invariant eps u al u' <= PI/2 + 1/20 ->
  PI/2 - 5.3 * eps^2 / u^3 <= invariant u al <= PI/2 + eps^2 / 4 -> 1 < clock eps u al.
Proof.
  intros [A [B1 B2] [C1 C2] D E] He U HU Hd HQ HJ. assert (P := pi_value). set (J := invariant u al) in *.
  set (d := half u u') in *.
  assert (S1 := beta_pos eps u (proj1 A) ltac:(apply sin_gt_0; lra)).
  assert (S2 := beta_pos eps u' (proj1 A) ltac:(apply sin_gt_0; lra)). set (th := al + beta eps u) in *.
  assert (Hth : 0 < th < PI/2) by (unfold th in *; lra). assert (Eu : u = U + d) by (unfold U, d, middle, half; lra).
  assert (U0 : 0 < U) by (unfold U, middle; lra). assert (d0 : 0 < d) by (unfold d, half; lra).
  assert (u3 : 0 < u^3) by (apply pow_lt; lra). assert (e2 : 0 < eps^2 <= 1/1000 * (1/1000)).
  { split; [apply pow_lt; lra|]. replace (eps^2) with (eps * eps) by ring. apply Rmult_le_compat; lra. }
  assert (Z := seven eps u u' th E). fold U d in Z. unfold middle_invariant in HQ. fold U th in HQ.
  (* eps, and J from below *)
  assert (K : 0.2 <= u \/ eps <= 0.2253 * (d * U)).
  { destruct (Rle_dec 0.2 u) as [L|L]; [now left|right]. apply Rnot_le_lt in L.
    assert (C : cos th <= 0.5514).
    { apply Rmult_le_reg_l with (PI - U); [lra|]. apply Rle_trans with (1 := proj2 HQ).
      apply Rle_trans with (2.9415 * 0.5514); [lra | apply Rmult_le_compat_r; lra]. }
    assert (T := tangent_at_least th 0.5514 1.51 Hth C ltac:(lra) ltac:(lra)).
    assert (sd : 0 <= sin d <= d) by (split; [apply sin_ge_0; lra | left; apply sin_lt_x; lra]).
    assert (sU : 0 <= sin U <= U) by (split; [apply sin_ge_0; lra | left; apply sin_lt_x; lra]).
    assert (X : sin d * sin U <= d * U) by (apply Rmult_le_compat; lra).
    assert (Y : eps * (1.51 * 2.94) <= eps * (tan th * (PI - U))) by (apply Rmult_le_compat_l; [lra | apply
      Rmult_le_compat; lra]).
    lra. }
  assert (dU : 0 <= (U - 5 * d) * (U - d / 5)) by (apply Rmult_le_pos; lra).
  assert (uu : 7.2 * (d * U) <= u * u) by (rewrite Eu; lra). assert (dU0 : 0 < d * U) by (now apply
    Rmult_lt_0_compat).
  assert (J0 : PI/2 - 0.01 <= J).
  { assert (X : 5.3 * eps^2 / u^3 <= 0.01); [|lra]. apply quotient_at_most; [exact u3|]. destruct K as [K|K].
    - assert (0.2^3 <= u^3) by (apply pow_incr; lra). lra.
    - destruct (Rle_dec 0.2 u) as [L|L]; [assert (0.2^3 <= u^3) by (apply pow_incr; lra); lra|]. apply Rnot_le_lt in
      L.
      assert (X : eps <= 0.0313 * (u * u)) by lra.
      assert (X2 : eps * eps <= 0.0313 * (u * u) * (0.0313 * (u * u))) by (apply Rmult_le_compat; lra).
      assert (X3 : u * u^3 <= 0.2 * u^3) by (apply Rmult_le_compat_r; lra).
      replace (0.0313 * (u * u) * (0.0313 * (u * u))) with (0.0313 * 0.0313 * (u * u^3)) in X2 by ring.
      replace (eps^2) with (eps * eps) by ring. lra. }
  assert (J1 : J <= 1.571) by lra.
  (* the clock is tau *)
  assert (al0 : 0 < al).
  { destruct C1 as [C1|C1]; [exact C1|]. exfalso. unfold J, invariant in J1. rewrite <- C1, cos_0 in J1. lra. }
  assert (alr : 0 < al < PI/2) by (unfold th in Hth; lra).
  assert (Ec : clock eps u al = tau u J / (2 * eps)) by (unfold clock; fold J; unfold J; rewrite L45a_clock by lra;
    reflexivity).
  assert (G0 : 0.181 <= G PI J) by (apply Rle_trans with (1 := G_value), G_mono; lra).
  rewrite Ec. apply Rmult_lt_reg_r with (2 * eps); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_l,
    Rmult_1_r by lra.
  assert (L : forall v, 0 < v <= 0.2 -> v <= u -> 0.0905 * (v * v) <= tau u J).
  { intros v Hv Hvu. apply Rle_trans with (tau v J); [|apply tau_mono; lra].
    apply Rle_trans with (2 := L45c_below v J ltac:(lra) ltac:(lra)).
    assert (0 <= v * v) by (apply Rmult_le_pos; lra).
    assert (0.181 * (v * v / 2) <= G PI J * (v * v / 2)) by (apply Rmult_le_compat_r; lra). lra. }
  destruct (Rle_dec 0.2 u) as [V|V].
  - assert (X := L 0.2 ltac:(lra) V). lra.
  - apply Rnot_le_lt in V. assert (X := L u ltac:(lra) ltac:(lra)). destruct K as [K|K]; lra.
Qed.
