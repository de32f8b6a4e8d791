(** L8 (3) for the dumbbell: out of a contact with the bridge at psi = pi/2 - e the rays X and sigma X are those of the
    chart bridge at the point (e, eta). Used both ways: for the upper bound (L8) and for the witness (L11).

    bridge_slopes              == the slopes of the rays before and after a contact with the bridge
    bridge_out_X, bridge_out_S == out of the contact the dumbbell flies as the ray X, and backwards as sigma X *)
From Coq Require Import Reals Lra.
From Dumbbell Require Import Physics Chart Flight StartRay.
Local Open Scope R_scope.

Section BridgeRays.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.
Hypothesis Hr1 : r_of P <= 1.
Notation r := (r_of P).
Notation yh := (yhat_of P).

Lemma sin_top e : sin (PI/2 - e) = cos e.
Proof. rewrite sin_minus, sin_PI2, cos_PI2. ring. Qed.
Lemma cos_top e : cos (PI/2 - e) = sin e.
Proof. rewrite cos_minus, sin_PI2, cos_PI2. ring. Qed.
Lemma reflects_reverse t u v u' v' : reflects P t u v u' v' -> reflects P t (- u') (- v') (- u) (- v).
Proof. intros [l [Hl [Eu [Ev [Er En]]]]]. exists l. repeat split; lra. Qed.

(** If the outgoing velocity (u', v') has the slope of X, the incoming one, reversed, has that of sigma X. *)
Lemma bridge_slopes e eta u v u' v' : 0 < e <= PI/2 -> reflects P (- (r * cos e)) u v u' v' -> u' < 0 ->
  r * lamX e eta * - u' = v' -> 0 < eta /\ u < 0 /\ r * lamS e eta r * - u = - v.
Proof.
  intros He [l [Hl [Eu [Ev [Er En]]]]] Hu Es. assert (R0 := r_pos P HP). assert (HPI : 0 < PI) by apply PI_RGT_0.
  destruct (cos_range e ltac:(lra)) as [W0 W1]. assert (Hrs : 0 <= r * cos e) by (apply Rmult_le_pos; lra).
  assert (Hq : 0 < 1 + r * (cos e * cos e)).
  { assert (0 <= r * (cos e * cos e)) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]). lra. }
  assert (Hle : l * (1 + r * (cos e * cos e)) = 2 * - u' * eta).
  { apply Rmult_eq_reg_l with r; [|lra]. assert (A1 : u = u' - l * (r * cos e)) by lra.
    assert (A2 : v = v' - l * r) by lra. unfold lamX in Es. rewrite A1, A2 in Er. lra. }
  assert (Heta : 0 < eta).
  { assert (0 < l * (1 + r * (cos e * cos e))) by (now apply Rmult_lt_0_compat).
    apply Rmult_lt_reg_l with (2 * - u'); lra. }
  assert (Hl2 : 0 <= l * (r * cos e)) by (apply Rmult_le_pos; lra). split; [exact Heta|]. split; [lra|].
  assert (Hden : 0 < 1 + r * (cos e * cos e) + 2 * (r * cos e * eta))
    by (assert (0 <= r * cos e * eta) by (apply Rmult_le_pos; lra); lra).
  assert (El : l = 2 * - u' * eta / (1 + r * (cos e * cos e))).
  { apply Rmult_eq_reg_r with (1 + r * (cos e * cos e)); [rewrite Hle; field; lra | lra]. }
  replace u with (u' - l * (r * cos e)) by lra. replace v with (v' - l * r) by lra. rewrite <- Es, El.
  unfold lamS, lamX, eta_reversed. field. split; lra.
Qed.

(** X, at psi = pi/2 - e; and sigma X, mirrored, at psi = - (pi/2 - e). *)
Lemma bridge_out_X s v e eta : 0 < e <= PI/2 -> 0 < eta -> psi_of s = PI/2 - e -> yh s = r * sin e -> u_of v < 0 ->
  r * lamX e eta * - u_of v = v_of P v ->
  start_ray P s v (r * cX e eta) (r * lamX e eta) /\ - r <= r * lamX e eta.
Proof.
  intros He Heta Ep Ey Hu Es. assert (R0 := r_pos P HP). assert (HPI : 0 < PI) by apply PI_RGT_0.
  assert (B := bridge_start_ray P HP Hr1 s v (r * lamX e eta) Hu Es). rewrite Ep, Ey, sin_top, cos_top in B.
  replace (r * cX e eta) with (r * sin e + r * lamX e eta * (PI/2 - e + PI/2)) by (unfold cX; field).
  apply B; [lra | reflexivity|]. rewrite <- Es. unfold lamX. assert (0 < r * (eta * - u_of v)).
  { apply Rmult_lt_0_compat; [lra | apply Rmult_lt_0_compat; lra]. } lra.
Qed.
Lemma bridge_out_S s v e eta : 0 < e <= PI/2 -> 0 < eta -> psi_of s = - (PI/2 - e) -> yh s = r * sin e -> u_of v < 0 ->
  r * lamS e eta r * - u_of v = v_of P v ->
  start_ray P s v (r * cS e eta r) (r * lamS e eta r) /\ - r <= r * lamS e eta r.
Proof.
  intros He Heta Ep Ey Hu Es. assert (R0 := r_pos P HP). assert (HPI : 0 < PI) by apply PI_RGT_0.
  destruct (cos_range e ltac:(lra)) as [W0 W1].
  assert (0 <= r * (cos e * cos e)) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]).
  assert (0 <= r * cos e * eta) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra | lra]).
  assert (Hep : 0 < eta_reversed eta (cos e) r).
  { unfold eta_reversed. apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra. }
  assert (B := bridge_start_ray P HP Hr1 s v (r * lamS e eta r) Hu Es).
  rewrite Ep, Ey, sin_neg, cos_neg, sin_top, cos_top in B.
  replace (r * cS e eta r) with (r * sin e + r * lamS e eta r * (- (PI/2 - e) + PI/2)) by (unfold cS; ring).
  apply B; [lra | reflexivity|]. rewrite <- Es. unfold lamS.
  assert (0 < r * (eta_reversed eta (cos e) r * - u_of v)).
  { apply Rmult_lt_0_compat; [lra | apply Rmult_lt_0_compat; lra]. } lra.
Qed.
End BridgeRays.
