(** First windows (L53 of law.md): where the middle invariant Q of a step, or of the tangent flight, is.

    near_half_pi    == the window of the bulk
    beta_above      == 0 < beta <= eps/sin u
    L53a_layer      == in the layer Q is in pi/2 + [-0.01, 0.05]
    L53b_bulk       == in the bulk Q is in pi/2 + [-1, 3] 10^-5, th < 0.7944, d < 0.00293, beta <= 0.0013
    L53c_end        == at the end Q is in pi/2 + d [-0.1, 0.6]
    last_half_step  == the step from the bulk into the layer is short, too *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Dumbbell Require Import PiValue LawStatement Sines Angles Falls Orbit Ends.
Local Open Scope R_scope.

Definition near_half_pi J := PI/2 - 1/100000 <= J <= PI/2 + 3/100000.
Lemma window_values : 0.7833 <= sin 0.9 /\ cos 0.9 <= 0.6217 /\ 0.7814 <= sin 0.897 /\ 0.679 <= sin 0.747 /\
  cos 0.7944 < 0.70074.
Proof. repeat split; interval. Qed.

Lemma beta_above eps u : 0 < eps -> 0 < sin u -> 0 < beta eps u <= eps / sin u.
Proof.
  intros He Hs. assert (B := beta_pos eps u He Hs). split; [apply B|]. unfold beta in *. set (x := eps / sin u) in *.
  assert (X : 0 < x) by (now apply Rdiv_lt_0_compat).
  destruct (MVT_cor2 atan (fun t => / (1 + t ^ 2)) 0 x) as [s [E _]]; [exact X | intros t _;
    apply derivable_pt_lim_atan |].
  rewrite atan_0 in E. assert (0 <= s ^ 2) by apply pow2_ge_0.
  assert (/ (1 + s ^ 2) <= / 1) by (apply Rinv_le_contravar; lra).
  assert (/ (1 + s ^ 2) * (x - 0) <= / 1 * (x - 0)) by (apply Rmult_le_compat_r; lra). lra.
Qed.
(** d^2 cot U <= d^2/U. *)
Lemma cot_above d U : 0 < U < PI/2 -> 0 <= d -> d * d * cos U / sin U <= d * d / U.
Proof.
  intros HU Hd. assert (T := tangent_above U HU). assert (S : 0 < sin U) by (apply sin_gt_0; lra).
  assert (D : 0 <= d * d) by (now apply Rmult_le_pos).
  apply Rmult_le_reg_r with (U * sin U); [apply Rmult_lt_0_compat; lra|].
  replace (d * d * cos U / sin U * (U * sin U)) with (d * d * (U * cos U)) by (field; lra).
  replace (d * d / U * (U * sin U)) with (d * d * sin U) by (field; lra). apply Rmult_le_compat_l; lra.
Qed.

(** One flight, as in Falls: the gap Q - J in terms of d, U and beta. *)
Section Gap.
Variables eps u u' th : R.
Hypothesis Heps : 0 < eps <= 1/1000.
Hypothesis Hu : 0 < u' < u.
Hypothesis Hu2 : u <= PI/2.
Hypothesis Hth : 0 <= th < PI/2.
Hypothesis HE : cos u' - cos u = eps * tan th * (2 * PI - u - u').
Let U := middle u u'.
Let d := half u u'.
Let b := beta eps u.
Let J := invariant u (th - b).
Let Q := (PI - U) * cos th.

Lemma gap g : b <= g -> J <= Q /\ Q - J <= cos th * (d * d / U) + 3.1416 * (g * g) / 2 + d * g.
Proof.
  intros Hg. assert (A := L44_before eps u u' th (proj1 Heps) Hu Hu2 Hth HE). fold b J U Q in A. split; [exact A|].
  assert (L := L53_gap eps u u' th (proj1 Heps) Hu Hu2 Hth HE). fold b J U d Q in L. assert (P := pi_value).
  destruct (signs eps u u' th (proj1 Heps) Hu Hu2 Hth) as [_ [_ [_ [_ [_ [_ [C [S _]]]]]]]].
  assert (B : 0 < b) by (apply beta_pos; [lra | apply sin_gt_0; lra]).
  assert (K := cot_above d U ltac:(unfold U, middle; lra) ltac:(unfold d, half; lra)).
  assert (K' := Rmult_le_compat_l (cos th) _ _ ltac:(lra) K). destruct (SIN_bound th) as [_ S1].
  destruct (COS_bound th) as [_ C1].
  assert (D : 0 <= d) by (unfold d, half; lra).
  assert (BB : b * b <= g * g) by (apply Rmult_le_compat; lra). assert (B2 : 0 <= b * b) by (apply Rmult_le_pos; lra).
  assert (Q1 : Q <= 3.1416) by (apply Rle_trans with (PI * 1); [apply Rmult_le_compat; unfold U, middle in *;
    lra | lra]).
  assert (Q2 : Q * (b * b) <= 3.1416 * (g * g)) by (apply Rle_trans with (3.1416 * (b * b));
    [apply Rmult_le_compat_r | apply Rmult_le_compat_l]; lra).
  assert (S2 : d * sin th * b <= d * g).
  { apply Rle_trans with (d * b); [|apply Rmult_le_compat_l; lra]. apply Rmult_le_compat_r; [lra|].
    apply Rle_trans with (d * 1); [apply Rmult_le_compat_l|]; lra. }
  lra.
Qed.

Theorem L53a_layer : U <= 9/10 -> d <= U / 5 -> eps / sin u <= 0.00717 -> PI/2 - 0.002 <= J <= PI/2 + 0.001 ->
  PI/2 - 1/100 <= Q <= PI/2 + 1/20.
Proof.
  intros HU Hd Hb HJ. assert (P := pi_value). assert (B := beta_above eps u ltac:(lra) ltac:(apply sin_gt_0; lra)).
  fold b in B.
  destruct (gap 0.00717 ltac:(lra)) as [A L]. destruct (COS_bound th) as [_ C1].
  assert (U0 : 0 < U) by (unfold U, middle; lra). assert (D0 : 0 <= d) by (unfold d, half; lra).
  assert (K : d * d / U <= 0.036).
  { apply Rmult_le_reg_r with U; [exact U0|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    assert (d * d <= U / 5 * (U / 5)) by (apply Rmult_le_compat; lra).
    assert (U * U <= 9/10 * U) by (apply Rmult_le_compat_r; lra). lra. }
  assert (K0 : 0 <= d * d / U) by (apply Rmult_le_pos; [now apply Rmult_le_pos | left; now apply Rinv_0_lt_compat]).
  assert (cos th * (d * d / U) <= 1 * (d * d / U)) by (apply Rmult_le_compat_r; lra).
  assert (d * 0.00717 <= 0.18 * 0.00717) by (apply Rmult_le_compat_r; lra). lra.
Qed.

(** sin d is small, if Q is not below pi/2 - 10^-5 and U not too small. *)
Lemma half_small c s : PI/2 - 1/100000 <= J -> 1/2 <= c -> c * (PI - U) <= PI/2 - 1/100000 -> 0 < s <= sin U ->
  c <= cos th /\ forall t, 0 <= t <= 3 -> 1 <= c * c * (1 + t * t) -> (th <> 0 ->
    tan th <= t) /\ s * sin d <= 1/1000 * t * (PI - U).
Proof.
  intros HJ Hc HcU Hs. assert (P := pi_value). assert (A := L44_before eps u u' th (proj1 Heps) Hu Hu2 Hth HE).
  fold b J U Q in A.
  assert (F : 0 < PI - U) by (unfold U, middle; lra).
  assert (C : c <= cos th) by (apply Rmult_le_reg_r with (PI - U); [exact F | unfold Q in A; lra]). split; [exact C|].
  intros t Ht E. assert (T : th <> 0 -> tan th <= t) by (intros Z; apply (tangent_at_most th c t); lra).
  split; [exact T|].
  assert (T' : tan th <= t) by (destruct (Req_dec th 0) as [->|Z]; [rewrite tan_0; lra | now apply T]).
  assert (Z := seven eps u u' th HE). fold U d in Z. assert (D : 0 <= sin d) by (apply sin_ge_0; unfold d, half; lra).
  assert (T0 : 0 <= tan th) by (destruct (Req_dec th 0) as [->|]; [rewrite tan_0; lra | left; apply tan_gt_0; lra]).
  apply Rle_trans with (sin d * sin U); [rewrite Rmult_comm; apply Rmult_le_compat_l; lra|]. rewrite Z.
  apply Rmult_le_compat_r; [lra|]. apply Rmult_le_compat; lra.
Qed.
Lemma half_from_sine x : sin d <= x -> x <= 0.01 -> d <= 1.0001 * x.
Proof.
  intros H Hx. assert (P := pi_value). assert (D : 0 <= d <= 0.8) by (unfold d, half; lra).
  assert (S := sine_below d ltac:(lra)).
  assert (d * d <= 0.8 * 0.8) by (apply Rmult_le_compat; lra).
  assert (d * d * d <= 0.8 * 0.8 * d) by (apply Rmult_le_compat_r; lra).
  assert (d <= 0.02) by lra. assert (d * d <= 0.02 * 0.02) by (apply Rmult_le_compat; lra).
  assert (d * d * d <= 0.02 * 0.02 * d) by (apply Rmult_le_compat_r; lra). lra.
Qed.
Theorem L53b_bulk : 9/10 <= U -> PI/2 - 1/100000 <= J <= PI/2 + 1/1000000 ->
  near_half_pi Q /\ d <= 0.00293 /\ th <= 0.7944 /\ b <= 0.0013 /\ 0.897 <= u' /\ beta eps u' <= 0.0013.
Proof.
  intros HU HJ. assert (P := pi_value). destruct window_values as [V1 [V2 [V3 [_ V4]]]].
  assert (U1 : U <= PI/2) by (unfold U, middle; lra).
  assert (SU : sin 0.9 <= sin U) by (apply sin_incr_1; lra).
  destruct (half_small 0.70074 0.7833 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)) as [C K].
  assert (T : th <= 0.7944). { apply Rnot_lt_le. intros Z. assert (cos th <= cos 0.7944) by (apply cos_decr_1; lra).
  lra. }
  destruct (K 1.0183 ltac:(lra) ltac:(lra)) as [_ S].
  assert (D := half_from_sine 0.002925 ltac:(lra) ltac:(lra)).
  assert (Eu : u = U + d /\ u' = U - d) by (unfold U, d, middle, half; lra).
  assert (D0 : 0 <= d) by (unfold d, half; lra).
  assert (Bb : forall v, 0.897 <= v <= PI/2 -> beta eps v <= 0.0013).
  { intros v Hv. assert (S1 : sin 0.897 <= sin v) by (apply sin_incr_1; lra).
    destruct (beta_above eps v ltac:(lra) ltac:(lra)) as [_ B].
    apply Rle_trans with (1 := B). apply Rmult_le_reg_r with (sin v); [lra|]. unfold Rdiv.
    rewrite Rmult_assoc, Rinv_l; lra. }
  assert (B1 : b <= 0.0013) by (apply Bb; lra).
  repeat split; try lra; [| |apply Bb; lra]; destruct (gap 0.0013 B1) as [A L]; [lra|].
  destruct (COS_bound th) as [_ C1]. assert (K2 : d * d / U <= 0.00293 * 0.00293 / (9/10)).
  { apply Rmult_le_compat; [now apply Rmult_le_pos | left; apply Rinv_0_lt_compat; lra | apply Rmult_le_compat;
      lra | apply Rinv_le_contravar; lra]. }
  assert (K0 : 0 <= d * d / U) by (apply Rmult_le_pos; [now apply Rmult_le_pos | left; apply Rinv_0_lt_compat; lra]).
  assert (cos th * (d * d / U) <= 1 * (d * d / U)) by (apply Rmult_le_compat_r; lra).
  assert (d * 0.0013 <= 0.00293 * 0.0013) by (apply Rmult_le_compat_r; lra). lra.
Qed.
(** The step from the last contact of the bulk. *)
Theorem last_half_step : 0.897 <= u -> d <= U / 5 -> U <= 9/10 -> PI/2 - 1/100000 <= J -> u <= 0.9042.
Proof.
  intros Hu0 Hd HU HJ. assert (P := pi_value). destruct window_values as [_ [_ [_ [V _]]]].
  assert (Eu : u = U + d) by (unfold U, d, middle, half; lra).
  assert (SU : sin 0.747 <= sin U) by (apply sin_incr_1; lra).
  destruct (half_small 0.6558 0.679 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)) as [C K].
  destruct (K 1.152 ltac:(lra) ltac:(lra)) as [_ S]. assert (D := half_from_sine 0.0041 ltac:(lra) ltac:(lra)). lra.
Qed.
End Gap.

(** The end. *)
Theorem L53c_end eps u al y : eps <= 1/1000 -> last eps u al y -> u <= 0.18 -> 19.5 * eps <= u * u ->
  eps / sin u <= 0.00717 ->
  PI/2 - 5.3 * eps^2 / u^3 <= invariant u al <= PI/2 + eps^2 / 4 ->
  PI/2 - 0.1 * (u / 2) <= (PI - u / 2) * cos (al + beta eps u) <= PI/2 + 0.6 * (u / 2).
Proof.
  intros He H Hu H19 Hb HJ. destruct (last_step eps u al y H) as [A [B [C [D [E [F [G [I K]]]]]]]].
  assert (P := pi_value).
  assert (Y := last_flat eps u al y H). set (th := al + beta eps u) in *. rewrite G in F. rewrite <- G in F.
  assert (Bb := beta_above eps u ltac:(lra) ltac:(apply sin_gt_0; lra)).
  assert (E3 : 5.3 * eps^2 / u^3 <= 0.02 * u).
  { assert (U3 : 0 < u ^ 3) by (apply pow_lt; lra). apply Rmult_le_reg_r with (u ^ 3); [exact U3|].
    unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    replace (0.02 * u * u ^ 3) with (0.02 * (u * u) ^ 2) by ring.
    assert ((19.5 * eps) ^ 2 <= (u * u) ^ 2) by (apply pow_incr; lra). assert (0 <= eps ^ 2) by apply pow2_ge_0. lra.
    }
  assert (Ee : eps ^ 2 / 4 <= 0.001 * u).
  { assert (u * u <= 0.18 * u) by (apply Rmult_le_compat_r; lra).
    assert (eps * eps <= 1/1000 * eps) by (apply Rmult_le_compat_r; lra). simpl. lra. }
  destruct (gap eps u y th ltac:(lra) B C ltac:(lra) F 0.00717 ltac:(lra)) as [L1 L2]. rewrite <- I in L1, L2.
  set (V := middle u y) in *. set (h := half u y) in *. assert (V0 : V = (u + y) / 2) by reflexivity.
  assert (h0 : h = (u - y) / 2) by reflexivity.
  set (c := cos th) in *. destruct (tangent_square th E) as [C0 [T0 _]]. fold c in C0.
  destruct (COS_bound th) as [_ C1]. fold c in C1.
  assert (Hh : h * h / V <= u / 2).
  { apply Rmult_le_reg_r with V; [lra|]. unfold Rdiv at 1. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    apply Rmult_le_compat; lra. }
  assert (X1 : c * (h * h / V) <= c * (u / 2)) by (apply Rmult_le_compat_l; lra).
  assert (X2 : c * (u / 2) <= 1 * (u / 2)) by (apply Rmult_le_compat_r; lra).
  assert (X3 : c <= 0.562).
  { apply Rmult_le_reg_l with (PI - V); [lra|]. apply Rle_trans with (1.6635); [lra|].
    apply Rle_trans with ((PI - 0.18) * 0.562); [lra | apply Rmult_le_compat_r; lra]. }
  assert (X4 : 0.49 <= c).
  { apply Rmult_le_reg_l with (PI - V); [lra|]. apply Rle_trans with (2 := L1).
    apply Rle_trans with (PI * 0.49); [apply Rmult_le_compat_r|]; lra. }
  assert (T := tangent_at_most th 0.49 1.78 E ltac:(fold c; lra) ltac:(lra) ltac:(lra)).
  assert (Sy : sin y <= 0.0165 * u).
  { rewrite <- G. assert (eps * tan th <= eps * 1.78) by (apply Rmult_le_compat_l; lra).
    assert (u * u <= 0.18 * u) by (apply Rmult_le_compat_r; lra). lra. }
  assert (Sl := sine_below y ltac:(lra)). assert (y * y <= 0.24 * 0.24) by (apply Rmult_le_compat; lra).
  assert (y * y * y <= 0.24 * 0.24 * y) by (apply Rmult_le_compat_r; lra).
  assert (Yu : y <= 0.017 * u) by lra.
  assert (X5 : c * (u / 2) <= 0.562 * (u / 2)) by (apply Rmult_le_compat_r; lra).
  assert (X6 : c * (y / 2) <= 0.562 * (y / 2)) by (apply Rmult_le_compat_r; lra).
  assert (X7 : 0 <= c * (y / 2)) by (apply Rmult_le_pos; lra).
  assert (Eq : (PI - u / 2) * c = (PI - V) * c + c * (y / 2)) by (rewrite V0; field).
  assert (Bg : beta eps u <= 0.06 * u).
  { destruct Bb as [_ Bb]. apply Rle_trans with (1 := Bb). assert (Su := sine_below u ltac:(lra)).
    assert (u * u <= 0.18 * 0.18) by (apply Rmult_le_compat; lra).
    assert (u * u * u <= 0.18 * 0.18 * u) by (apply Rmult_le_compat_r; lra).
    apply Rmult_le_reg_r with (sin u); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra.
    assert (u * (0.99 * u) <= u * sin u) by (apply Rmult_le_compat_l; lra). lra. }
  destruct (gap eps u y th ltac:(lra) B C ltac:(lra) F (beta eps u) ltac:(lra)) as [_ L3]. rewrite <- I in L3.
  fold V h c in L3.
  assert (X8 : beta eps u * beta eps u <= 0.00717 * (0.06 * u)) by (apply Rmult_le_compat; lra).
  assert (X9 : h * beta eps u <= u / 2 * 0.00717) by (apply Rmult_le_compat; lra).
  rewrite Eq. split; lra.
Qed.
