(** Condition (C8) of law.md: how much J falls at a step of the layer, for every eps. No certificate says so: by (8) and (7)
    J - J' is at most 2 d eps^2/U^4 times a function of U and Q, and coq-interval bounds that.

    sine_share, thin      == U <= sin U [sine_share]; sin^2 U - sin^2 d >= sin^2 U [thin]
    layer_rate            == the function; layer_rate_at_most: it is at most 15.9
    places, square_of_s   == the signs; sin^2 d and F sin th tan th from (7)
    C8_bound, C8          == (C8), of a flight and of a step *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Dumbbell Require Import Signs Quotients Sines PiValue LawStatement Angles Falls Sizes.
Local Open Scope R_scope.

Definition sine_share U := / (1 - U^2 / 6).
Definition thin U := 1 - sine_share U ^ 2 / 25.
Definition layer_rate U Q := let F := PI - U in let R := F^2 - Q^2 in let S0 := U * (1 - U^2 / 6) in
  F / Q * R * (1 - 2/3 * (1 - U^2 / 125) * S0^2) * (sine_share U ^ 4 / thin U) + Q * U * cos U * (sine_share U ^ 3 /
    thin U ^ 2) +
  R / Q * U * cos U * (sine_share U ^ 3 / thin U).
Lemma layer_rate_at_most U Q : 0 <= U <= 9/10 -> PI/2 - 1/100 <= Q <= PI/2 + 1/20 -> layer_rate U Q <= 15.9.
Proof.
  intros HU HQ. assert (P := pi_digits).
  assert (HQ' : 1.5607 <= Q <= 1.6208) by lra. clear HQ P. unfold layer_rate, thin, sine_share. cbv zeta.
  interval with (i_bisect U, i_bisect Q, i_depth 16).
Qed.

Section Step.
Variables eps u u' th : R.
Hypothesis Heps : 0 < eps.
Hypothesis Hu : 0 < u' < u.
Hypothesis Hu2 : u <= PI/2.
Hypothesis Hth : 0 <= th < PI/2.
Hypothesis HE : cos u' - cos u = eps * tan th * (2 * PI - u - u').
Let b := beta eps u.
Let b' := beta eps u'.
Let U := middle u u'.
Let d := half u u'.
Let F := PI - U.
Let Q := F * cos th.
Let s := sin d.
Let S := sin U.
Let K := cos U.
Let W := S * S - s * s.
Let R2 := F^2 - Q^2.
Hypothesis HU : U <= 9/10.
Hypothesis Hd : d <= U / 5.
Hypothesis HQ : PI/2 - 1/100 <= Q <= PI/2 + 1/20.

Lemma places : 0 < U /\ 0 < s <= d /\ 0 < d /\ U * (1 - U^2 / 6) <= S <= U /\ S <= 1 /\ 0 < K /\ 0 < thin U /\ 1 <=
  sine_share U /\
  thin U * (S * S) <= W /\ U <= sine_share U * S /\ 0 < Q /\ 0 < R2 /\ 0 < F.
Proof.
  assert (P := pi_value). destruct (middle_range u u' Hu Hu2) as [[U0 _] [[D0 D1] _]]. fold U in U0. fold d in D0, D1.
  destruct (signs eps u u' th Heps Hu Hu2 Hth) as [s0 [_ [[S0 S1] [K0 [_ [sd _]]]]]]. fold U in S0, S1, K0. fold d in
    s0, sd.
  fold S in S0, S1. fold K in K0. fold s in s0, sd.
  assert (SU : S <= U) by (left; apply sin_lt_x; exact U0). assert (B := sine_below U ltac:(lra)). fold S in B.
  assert (U2 : 0 <= U^2 <= 0.81) by (split; [apply pow2_ge_0 | replace 0.81 with (0.9^2) by lra; apply pow_incr;
    lra]).
  assert (k1 : 0 < 1 - U^2 / 6 <= 1) by lra. assert (k2 : sine_share U * (1 - U^2 / 6) = 1) by (unfold sine_share;
    field; lra).
  assert (k0 : 0 < sine_share U) by (apply Rinv_0_lt_compat; lra).
  assert (k3 : 1 <= sine_share U <= 1.157).
  { split; unfold sine_share; [rewrite <- Rinv_1; apply Rinv_le_contravar; lra|]. apply Rmult_le_reg_r with (1 - U^2
    / 6); [lra|].
    rewrite Rinv_l by lra. lra. }
  assert (k4 : sine_share U ^ 2 <= 1.157^2) by (apply pow_incr; lra).
  assert (T : 0 < thin U) by (unfold thin; lra). assert (L : U * (1 - U^2 / 6) <= S) by lra.
  assert (UK : U <= sine_share U * S).
  { apply Rle_trans with (sine_share U * (U * (1 - U^2 / 6))); [|apply Rmult_le_compat_l; lra].
    replace (sine_share U * (U * (1 - U^2 / 6))) with (U * (sine_share U * (1 - U^2 / 6))) by ring. rewrite k2. lra. }
  assert (V : thin U * (S * S) <= W).
  { unfold thin, W. assert (s * s <= U / 5 * (U / 5)) by (apply Rmult_le_compat; lra).
    assert (U * U <= sine_share U * S * (sine_share U * S)) by (apply Rmult_le_compat; lra). lra. }
  assert (F0 : 0 < F) by (unfold F; lra). assert (Q0 : 0 < Q) by lra.
  assert (R0 : 0 < R2). { unfold R2. assert (Q * Q < F * F) by (apply Rmult_le_0_lt_compat; unfold F in *; lra).
    simpl. lra. }
  repeat split; lra.
Qed.
Lemma square_of_s : s^2 = eps^2 * (R2 * F^2 / (S^2 * Q^2)) /\ F * sin th * tan th = R2 / Q.
Proof.
  destruct places as [U0 [s0 [d0 [SU [S1 [K0 [T [k [V [UK [Q0 [R0 F0]]]]]]]]]]]]. assert (Sp : 0 < S) by
    (apply Rlt_le_trans with (2 := proj1 SU); apply Rmult_lt_0_compat; [lra|];
     assert (U^2 <= 0.9^2) by (apply pow_incr; lra); lra).
  assert (C : 0 < cos th) by (apply cos_gt_0; lra). assert (Z := seven eps u u' th HE). fold U d in Z. fold s S F in
    Z.
  assert (E := sin2_cos2 th). unfold Rsqr in E.
  assert (T2 : tan th ^ 2 = R2 / Q^2) by (unfold R2, Q, tan; replace (F^2 - (F * cos th)^2) with (F^2 * (sin th * sin
    th))
    by (replace (sin th * sin th) with (1 - cos th * cos th) by lra; ring); field; lra).
  split.
  - replace (s^2) with ((s * S)^2 / S^2) by (field; lra). rewrite Z.
    replace ((eps * tan th * F)^2) with (eps^2 * F^2 * tan th^2) by ring. rewrite T2. field. lra.
  - unfold R2, Q, tan. replace (F^2 - (F * cos th)^2) with (F^2 * (sin th * sin th))
      by (replace (sin th * sin th) with (1 - cos th * cos th) by lra; ring). field. lra.
Qed.

Theorem C8_bound : invariant u (th - b) - invariant u' (th + b') <= 15.9 * (2 * d) * eps^2 / U^4.
Proof.
  destruct places as [U0 [[s0 sd] [d0 [[SL SU] [S1 [K0 [T [k [V [UK [Q0 [R0 F0]]]]]]]]]]]].
  destruct square_of_s as [Es Ef]. assert (P := pi_value).
  assert (U2 : 0 <= U^2 <= 0.81) by (split; [apply pow2_ge_0 | replace 0.81 with (0.9^2) by lra; apply pow_incr;
    lra]).
  assert (Sp : 0 < S) by (apply Rlt_le_trans with (2 := SL); apply Rmult_lt_0_compat; lra).
  assert (SS : 0 < S * S <= 1 * 1) by (split; [apply Rmult_lt_0_compat | apply Rmult_le_compat]; lra).
  assert (TS : 0 < thin U * (S * S)) by (apply Rmult_lt_0_compat; lra). assert (WP : 0 < W) by lra.
  assert (C : 0 < cos th) by (apply cos_gt_0; lra). assert (Sn : 0 <= sin th) by (apply sin_ge_0; lra).
  assert (E0 := L43c_fall eps u u' th Hu Hu2 Hth HE). fold b b' in E0. fold U d in E0. fold F in E0. fold Q in E0.
  assert (XN := X'_neg eps u u' th Heps Hu Hu2 Hth). cbv zeta in XN. fold U d in XN.
  assert (XF := X_falls eps u u' th Heps Hu Hu2 Hth). cbv zeta in XF. fold U d in XF.
  destruct (betas eps u u' Heps Hu Hu2) as [B1 [B2 B3]]. fold b b' in B1, B2, B3.
  assert (Cb : 0 < cos b <= 1) by (split; [apply cos_gt_0; lra | apply COS_bound]).
  assert (Cb' : 0 < cos b' <= 1) by (split; [apply cos_gt_0; lra | apply COS_bound]).
  assert (Cc : cos b' <= cos b) by (apply cos_decr_1; lra).
  assert (Cd : 0 < cos d <= 1) by (split; [apply cos_gt_0; lra | apply COS_bound]).
  assert (e2 : 0 < eps^2) by (now apply pow_lt).
  destruct (sine_products u u') as [Wu [Su _]]. fold U d in Wu, Su. fold S s in Wu, Su. fold W in Wu.
  destruct (sines u u' Hu Hu2) as [N1 N2].
  (* X - X' *)
  assert (EX := L43c_X u u' Hu Hu2). fold U d in EX. fold S s in EX. fold W in EX.
  assert (Y := sine_above (2 * d) ltac:(lra)).
  assert (s2 : 0 < s^2) by (now apply pow_lt). assert (d2 : s^2 <= d^2) by (apply pow_incr; lra).
  assert (d2' : d^2 <= U^2 / 25) by (replace (U^2 / 25) with ((U / 5)^2) by field; apply pow_incr; lra).
  set (g := 1 - 2/3 * (1 - d^2 / 5) * S^2).
  assert (X1 : (sin d * sin U / sin u - d) - (d - sin d * sin U / sin u') <= d * s^2 * (2 * g) / W).
  { fold s S. rewrite EX. unfold Rdiv at 1. apply Rmult_le_compat_r; [left; now apply Rinv_0_lt_compat|].
    replace ((2 * d)^3) with (8 * (d * d^2)) in Y by ring. replace ((2 * d)^5) with (32 * (d * d^2 * d^2)) in Y by
      ring.
    assert (A : 4/3 * (d * d^2) * (1 - d^2 / 5) <= 2 * d - sin (2 * d)) by lra.
    assert (A' : 4/3 * (d * s^2) * (1 - d^2 / 5) <= 4/3 * (d * d^2) * (1 - d^2 / 5)).
    { apply Rmult_le_compat_r; [lra|]. apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_l; lra. }
    assert (A2 := Rmult_le_compat_r (S * S) _ _ ltac:(lra) (Rle_trans _ _ _ A' A)).
    unfold g. replace (d * s^2 * (2 * (1 - 2/3 * (1 - d^2 / 5) * S^2))) with
      (2 * d * (s * s) - 4/3 * (d * s^2) * (1 - d^2 / 5) * (S * S)) by field. lra. }
  assert (g0 : 0 <= g) by (unfold g; replace (S^2) with (S * S) by ring;
    assert ((1 - d^2 / 5) * (S * S) <= 1 * 1) by (apply Rmult_le_compat; lra); lra).
  assert (T1 : cos th * (cos b * ((sin d * sin U / sin u - d) - (d - sin d * sin U / sin u')) + (d - sin d * sin U /
    sin u') *
    (cos b - cos b')) <= 2 * d * eps^2 * (F / Q * R2 * g / (W * S^2))).
  { apply Rle_trans with (cos th * (d * s^2 * (2 * g) / W)).
    - apply Rmult_le_compat_l; [lra|].
      set (X := sin d * sin U / sin u - d) in *. set (X' := d - sin d * sin U / sin u') in *.
      assert (cos b * (X - X') <= 1 * (X - X')) by (apply Rmult_le_compat_r; lra).
      assert (0 <= - X' * (cos b - cos b')) by (apply Rmult_le_pos; lra). lra.
    - right. rewrite Es. replace (cos th) with (Q / F) by (unfold Q; field; lra). field. repeat split; lra. }
  (* c - c' *)
  assert (EC := L43c_cos eps u u' Heps Hu Hu2). fold b b' in EC. fold U d in EC. rewrite Wu in EC.
  rewrite (sin_2a U) in EC. fold S K in EC.
  assert (S2d : 0 <= sin (2 * d) <= 2 * d) by (split; [apply sin_ge_0; lra | left; apply sin_lt_x; lra]).
  assert (H2 := cosines_share _ _ Cb Cb').
  assert (SK : 0 < S * K) by (now apply Rmult_lt_0_compat). assert (W2 : 0 < W^2) by (now apply pow_lt).
  assert (T2 : Q * (cos b - cos b') <= 2 * d * eps^2 * (Q * S * K / W^2)).
  { rewrite EC. apply Rle_trans with (Q * (1/2 * eps^2 * (2 * S * K * (2 * d)) / W^2)).
    - apply Rmult_le_compat_l; [lra|]. unfold Rdiv at 1 4. apply Rmult_le_compat_r; [left; now apply
      Rinv_0_lt_compat|].
      apply Rmult_le_compat.
      + apply Rmult_le_pos; [|lra]. apply Rle_mult_inv_pos; [|lra]. apply Rmult_le_pos; apply pow2_ge_0.
      + apply Rmult_le_pos; lra.
      + apply Rmult_le_compat_r; lra.
      + apply Rmult_le_compat_l; lra.
    - right. field. lra. }
  (* sin b' - sin b *)
  assert (EN := L43c_sin eps u u' Heps Hu Hu2). fold b b' in EN. fold U d in EN. rewrite Wu in EN.
  rewrite (sin_2a U), (sin_2a d) in EN. fold S K s in EN.
  assert (V1 := divided_by_share (sin u) (cos b) ltac:(lra) Cb). assert (V2 := divided_by_share (sin u') (cos b')
    ltac:(lra) Cb').
  assert (SC : 0 < S * cos d) by (apply Rmult_lt_0_compat; lra).
  assert (DP : 2 * S * cos d <= sin u / cos b + sin u' / cos b') by lra.
  assert (T3 : - (d * sin th * (sin b - sin b')) <= 2 * d * eps^2 * (R2 / Q * K / (W * S))).
  { assert (Z := seven eps u u' th HE). fold U d in Z. fold s S F in Z.
    assert (N : sin b' - sin b <= 2 * eps * K * s / W).
    { replace (sin b' - sin b) with (eps * (2 * S * K * (2 * s * cos d)) * cos b * cos b' / (W * (sin u / cos b + sin
      u' / cos b')))
        by lra.
      apply quotient_at_most; [apply Rmult_lt_0_compat; lra|].
      assert (CC : 0 < cos b * cos b' <= 1 * 1) by (split; [apply Rmult_lt_0_compat | apply Rmult_le_compat]; lra).
      assert (M : 0 <= 2 * eps * K * s) by (repeat apply Rmult_le_pos; lra).
      apply Rle_trans with (2 * eps * K * s * (2 * S * cos d) * 1).
      - replace (eps * (2 * S * K * (2 * s * cos d)) * cos b * cos b') with (2 * eps * K * s * (2 * S * cos d) * (cos
        b * cos b')) by ring.
        apply Rmult_le_compat_l; [apply Rmult_le_pos|]; lra.
      - rewrite Rmult_1_r. replace (2 * eps * K * s / W * (W * (sin u / cos b + sin u' / cos b')))
          with (2 * eps * K * s * (sin u / cos b + sin u' / cos b')) by (field; lra). apply Rmult_le_compat_l; lra. }
    assert (D := Rmult_le_compat_l (d * sin th) _ _ ltac:(apply Rmult_le_pos; lra) N).
    apply Rle_trans with (d * sin th * (2 * eps * K * s / W)); [lra|]. right. rewrite <- Ef.
    replace s with (eps * tan th * F / S) by (rewrite <- Z; field; lra). field. lra. }
  (* together *)
  assert (k3 : 0 < U^3) by (now apply pow_lt). assert (k4 : 0 < U^4) by (now apply pow_lt).
  assert (kS : U^3 <= sine_share U ^ 3 * S^3) by (rewrite <- Rpow_mult_distr; apply pow_incr; lra).
  assert (kS4 : U^4 <= sine_share U ^ 4 * S^4) by (rewrite <- Rpow_mult_distr; apply pow_incr; lra).
  assert (RL := layer_rate_at_most U Q ltac:(lra) HQ).
  assert (S3 : 0 < S^3) by (now apply pow_lt). assert (S4 : 0 < S^4) by (now apply pow_lt).
  assert (Fq : 0 < F / Q * R2) by (apply Rmult_lt_0_compat; [apply Rdiv_lt_0_compat|]; lra).
  assert (Rq : 0 < R2 / Q * K) by (apply Rmult_lt_0_compat; [apply Rdiv_lt_0_compat|]; lra).
  assert (QK : 0 < Q * K) by (now apply Rmult_lt_0_compat). assert (T2p : 0 < thin U ^ 2) by (now apply pow_lt).
  assert (G1 : F / Q * R2 * g / (W * S^2) <= F / Q * R2 * (1 - 2/3 * (1 - U^2 / 125) * (U * (1 - U^2 / 6))^2) *
    (sine_share U ^ 4 / thin U) / U^4).
  { assert (gg : g <= 1 - 2/3 * (1 - U^2 / 125) * (U * (1 - U^2 / 6))^2).
    { unfold g. assert (0 <= U * (1 - U^2 / 6)) by (apply Rmult_le_pos; lra).
      assert ((U * (1 - U^2 / 6))^2 <= S^2) by (apply pow_incr; lra).
      assert ((1 - U^2 / 125) * (U * (1 - U^2 / 6))^2 <= (1 - d^2 / 5) * S^2)
        by (apply Rmult_le_compat; [lra | apply pow2_ge_0 | lra | lra]). lra. }
    apply Rle_trans with (F / Q * R2 * (1 - 2/3 * (1 - U^2 / 125) * (U * (1 - U^2 / 6))^2) / (W * S^2)).
    - unfold Rdiv at 1 3. apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; apply Rmult_lt_0_compat; [lra | now
      apply pow_lt]|].
      apply Rmult_le_compat_l; lra.
    - set (h := 1 - 2/3 * (1 - U^2 / 125) * (U * (1 - U^2 / 6))^2) in *.
      assert (0 <= F / Q * R2 * h) by (apply Rmult_le_pos; lra).
      replace (F / Q * R2 * h * (sine_share U ^ 4 / thin U) / U^4) with (F / Q * R2 * h * (sine_share U ^ 4 / (thin U
        * U^4))) by (field; lra).
      unfold Rdiv at 1. apply Rmult_le_compat_l; [assumption|].
      apply Rle_trans with (/ (thin U * S^4)).
      + apply Rinv_le_contravar; [apply Rmult_lt_0_compat; lra|]. replace (thin U * S^4) with (thin U * (S * S) *
        S^2) by ring.
        apply Rmult_le_compat_r; [apply pow2_ge_0 | lra].
      + apply quotient_at_least; [apply Rmult_lt_0_compat; lra|].
        replace (/ (thin U * S^4) * (thin U * U^4)) with (U^4 / S^4) by (field; lra). apply quotient_at_most; lra. }
  assert (G2 : Q * S * K / W^2 <= Q * U * K * (sine_share U ^ 3 / thin U ^ 2) / U^4).
  { apply Rle_trans with (Q * K / (thin U ^ 2 * S^3)).
    - apply quotient_at_most; [exact W2|]. replace (Q * K / (thin U ^ 2 * S^3) * W^2) with (Q * S * K * (W^2 / (thin
      U * (S * S))^2))
        by (field; lra).
      assert (1 <= W^2 / (thin U * (S * S))^2) by (apply quotient_at_least; [now apply pow_lt | rewrite Rmult_1_l;
        apply pow_incr; lra]).
      rewrite <- (Rmult_1_r (Q * S * K)) at 1. apply Rmult_le_compat_l; [|assumption].
      apply Rmult_le_pos; [apply Rmult_le_pos|]; lra.
    - replace (Q * U * K * (sine_share U ^ 3 / thin U ^ 2) / U^4) with (Q * K / thin U ^ 2 * (sine_share U ^ 3 /
      U^3)) by (field; lra).
      replace (Q * K / (thin U ^ 2 * S^3)) with (Q * K / thin U ^ 2 * / S^3) by (field; lra).
      apply Rmult_le_compat_l; [apply Rle_mult_inv_pos; lra|].
      apply quotient_at_least; [lra|]. replace (/ S^3 * U^3) with (U^3 / S^3) by (field; lra). apply
        quotient_at_most; lra. }
  assert (G3 : R2 / Q * K / (W * S) <= R2 / Q * U * K * (sine_share U ^ 3 / thin U) / U^4).
  { apply Rle_trans with (R2 / Q * K / (thin U * S^3)).
    - unfold Rdiv at 1 3. apply Rmult_le_compat_l; [lra|]. apply Rinv_le_contravar; [apply Rmult_lt_0_compat; lra|].
      replace (thin U * S^3) with (thin U * (S * S) * S) by ring. apply Rmult_le_compat_r; lra.
    - replace (R2 / Q * U * K * (sine_share U ^ 3 / thin U) / U^4) with (R2 / Q * K / thin U * (sine_share U ^ 3 /
      U^3)) by (field; lra).
      replace (R2 / Q * K / (thin U * S^3)) with (R2 / Q * K / thin U * / S^3) by (field; lra).
      apply Rmult_le_compat_l; [apply Rle_mult_inv_pos; lra|].
      apply quotient_at_least; [lra|]. replace (/ S^3 * U^3) with (U^3 / S^3) by (field; lra). apply
        quotient_at_most; lra. }
  rewrite E0. assert (DE : 0 <= 2 * d * eps^2) by (repeat apply Rmult_le_pos; lra).
  assert (H := Rmult_le_compat_l _ _ _ DE (Rplus_le_compat _ _ _ _ (Rplus_le_compat _ _ _ _ G1 G2) G3)).
  apply Rle_trans with (2 * d * eps^2 * (layer_rate U Q / U^4)).
  - unfold layer_rate. cbv zeta. fold F K. fold R2. lra.
  - replace (15.9 * (2 * d) * eps^2 / U^4) with (2 * d * eps^2 * (15.9 / U^4)) by (field; lra).
    apply Rmult_le_compat_l; [exact DE|]. unfold Rdiv. apply Rmult_le_compat_r; [left; now apply Rinv_0_lt_compat |
      exact RL].
Qed.
End Step.

Theorem C8 eps u al u' al' : step eps u al u' al' -> let U := middle u u' in U <= 9/10 -> half u u' <= U / 5 ->
  PI/2 - 1/100 <= middle_invariant eps u al u' <= PI/2 + 1/20 ->
  invariant u al - invariant u' al' <= 15.9 * (2 * half u u') * eps^2 / U^4.
Proof.
  intros [A [B1 B2] [C1 C2] D E] U HU Hd HQ. assert (P := PI2_1).
  assert (S1 := beta_pos eps u (proj1 A) ltac:(apply sin_gt_0; lra)).
  assert (S2 := beta_pos eps u' (proj1 A) ltac:(apply sin_gt_0; lra)).
  assert (G := C8_bound eps u u' (al + beta eps u) (proj1 A) B1 B2 ltac:(lra) E HU Hd HQ).
  replace (al + beta eps u - beta eps u) with al in G by ring.
  replace (al + beta eps u + beta eps u') with al' in G by lra. exact G.
Qed.
