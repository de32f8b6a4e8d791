(** Condition (C10) of law.md: how much J falls at a step of the bulk, for every eps <= 1/1000. No certificate says so: (8)
    bounds J - J' by a function of th and Q times eps^2 (al' - al), and coq-interval bounds that.

    fall_rate            == the function
    small, W_is          == the sizes and products of the sines of a step of the bulk
    fall_X, fall_cos, fall_sin == X - X', c - c' and the sines of beta, from above
    turn_below           == al' - al, from below
    rate_above           == J - J' <= 1.0014 [fall_rate] eps^2 (al' - al)
    rates, ranges        == what coq-interval says of it
    bulk_sines           == the sines of d and U at a step of the bulk
    C10                  == (C10) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Dumbbell Require Import Signs Quotients Sines PiValue LawStatement Angles Falls Sizes.
Local Open Scope R_scope.

Definition fall_rate th Q := let F := Q / cos th in let S := sin F in let K := - cos F in let t := tan th * F / S in
  cos th * t^3 * (1 - 2/3 * S^2) / S + Q * K * t / S^2 + t^2 * sin th * K / S.

Section Step.
Variables eps u u' th : R.
Hypothesis Heps : 0 < eps <= 1/1000.
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
Hypothesis Hs : s <= 0.003.
Hypothesis HS : 0.78 <= S.

Lemma small : 0 < s /\ s <= d <= 1.0001 * s /\ d <= 0.0031 /\ 0.9999 * (S * S) <= W <= S * S /\ 0.99999 <= cos d <= 1.
Proof.
  destruct (middle_range u u' Hu Hu2) as [_ [Hd _]]. fold d in Hd. assert (P := pi_value).
  assert (S0 : 0 < s) by (apply sin_gt_0; lra). assert (L : s <= d) by (left; apply sin_lt_x; lra).
  assert (B := sine_below d ltac:(lra)). fold s in B.
  assert (d * d <= 0.8 * 0.8) by (apply Rmult_le_compat; lra).
  assert (d * d * d <= 0.8 * 0.8 * d) by (apply Rmult_le_compat_r; lra). assert (d <= 0.004) by lra.
  assert (D2 : d * d <= 0.004 * 0.004) by (apply Rmult_le_compat; lra).
  assert (d * d * d <= 0.004 * 0.004 * d) by (apply Rmult_le_compat_r; lra).
  assert (SS : 0.78 * 0.78 <= S * S) by (apply Rmult_le_compat; lra).
  assert (ss : s * s <= 0.003 * 0.003) by (apply Rmult_le_compat; lra). assert (0 <= s * s) by apply Rle_0_sqr.
  assert (C := cosine_below d ltac:(lra)). destruct (COS_bound d). unfold W. repeat split; lra.
Qed.
Lemma W_is : sin u * sin u' = W /\ sin u + sin u' = 2 * S * cos d.
Proof. destruct (sine_products u u') as [A [B _]]. now split. Qed.

(** X - X'. *)
Lemma fall_X : (sin d * sin U / sin u - d) - (d - sin d * sin U / sin u') <= 1.0012 * (s^3 * (2 - 4/3 * S^2) / S^2).
Proof.
  destruct small as [s0 [[D0 D1] [D2 [[W0 W1] _]]]]. assert (E := L43c_X u u' Hu Hu2). fold U d in E. fold S s in E.
    fold W in E. fold s S. rewrite E. clear E.
  assert (Y := sine_above (2 * d) ltac:(lra)). destruct (SIN_bound U) as [_ S1]. fold S in S1.
  assert (SS : 0 < S * S <= 1 * 1) by (split; [apply Rmult_lt_0_compat | apply Rmult_le_compat]; lra).
  assert (WP : 0 < W) by lra.
  apply quotient_at_most; [exact WP|]. assert (s3 : 0 < s^3) by (apply pow_lt; lra).
  assert (d3 : s^3 <= d^3) by (apply pow_incr; lra).
  assert (dd : d * d <= 0.0031 * 0.0031) by (apply Rmult_le_compat; lra).
  assert (d5 : d^5 <= 0.00001 * d^3)
    by (replace (d^5) with (d * d * d^3) by ring; apply Rmult_le_compat_r; [apply pow_le|]; lra).
  assert (A : 2 * d * (s * s) <= 2.0002 * s^3).
  { replace (2.0002 * s^3) with (2 * (1.0001 * s) * (s * s)) by lra. apply Rmult_le_compat_r; [apply Rle_0_sqr |
    lra]. }
  assert (B : 1.3333 * s^3 <= 2 * d - sin (2 * d)) by (replace ((2 * d)^3) with (8 * d^3) in Y by ring;
    replace ((2 * d)^5) with (32 * d^5) in Y by ring; lra).
  assert (B' := Rmult_le_compat_r (S * S) _ _ ltac:(lra) B).
  assert (Z : 1.0012 * (s^3 * (2 - 4/3 * S^2) / S^2) * W = 1.0012 * (s^3 * (2 - 4/3 * (S * S))) * (W / (S * S)))
    by (field; lra).
  rewrite Z. assert (R : 0.9999 <= W / (S * S)) by (apply quotient_at_least; lra).
  assert (N : 0 <= s^3 * (2 - 4/3 * (S * S))) by (apply Rmult_le_pos; lra).
  assert (V := Rmult_le_compat_l (1.0012 * (s^3 * (2 - 4/3 * (S * S)))) _ _ ltac:(lra) R).
  assert (T : s^3 * (S * S) <= s^3 * 1) by (apply Rmult_le_compat_l; lra).
  lra.
Qed.
Lemma cosines : 0 < cos b <= 1 /\ 0 < cos b' <= 1 /\ cos b' <= cos b.
Proof.
  destruct (betas eps u u' (proj1 Heps) Hu Hu2) as [B1 [B2 B3]]. fold b b' in B1, B2, B3.
  repeat split; try (apply cos_gt_0; lra); try apply COS_bound. apply cos_decr_1; lra.
Qed.
Lemma fall_cos : cos b - cos b' <= 1.0012 * (2 * eps^2 * K * s / S^3).
Proof.
  destruct small as [s0 [[D0 D1] [D2 [[W0 W1] _]]]]. destruct cosines as [C1 [C2 _]].
  destruct (signs eps u u' th (proj1 Heps) Hu Hu2 Hth) as [_ [_ [_ [K0 _]]]]. fold U in K0. fold K in K0.
  assert (E := L43c_cos eps u u' (proj1 Heps) Hu Hu2). fold b b' in E. fold U d in E.
  rewrite (proj1 W_is) in E. rewrite E. clear E. set (c := cos b) in *. set (c' := cos b') in *.
  assert (H := cosines_share c c' C1 C2).
  rewrite sin_2a. fold S K. assert (S2 : sin (2 * d) <= 2 * (1.0001 * s)).
  { apply Rle_trans with (2 * d); [left; apply sin_lt_x; lra | lra]. }
  assert (SP : 0 < S * S) by (apply Rmult_lt_0_compat; lra). assert (WP : 0 < W) by lra.
  assert (E2 : 0 < eps^2) by (apply pow_lt; lra).
  assert (A : c^2 * c'^2 / (c + c') * eps^2 * (2 * S * K * sin (2 * d)) <= 1/2 * eps^2 * (2 * S * K * (2 * (1.0001 *
    s)))).
  { assert (SK : 0 <= 2 * S * K) by (repeat apply Rmult_le_pos; lra).
    assert (SD : 0 <= sin (2 * d)) by (apply sin_ge_0; assert (P := pi_value); lra).
    apply Rmult_le_compat; [|now apply Rmult_le_pos | apply Rmult_le_compat_r; lra | apply Rmult_le_compat_l; lra].
    apply Rmult_le_pos; [|lra]. apply Rle_mult_inv_pos; [|lra]. apply Rmult_le_pos; apply pow2_ge_0. }
  apply quotient_at_most; [apply pow_lt; lra|]. apply Rle_trans with (1 := A).
  assert (R : 0.9998 <= W^2 / S^4).
  { replace (W^2 / S^4) with ((W / (S * S))^2) by (field; lra).
    assert (0.9999 <= W / (S * S)) by (apply quotient_at_least; lra).
    apply Rle_trans with (0.9999^2); [lra | apply pow_incr; lra]. }
  replace (1.0012 * (2 * eps^2 * K * s / S^3) * W^2) with (1.0012 * (2 * eps^2 * K * s * S) * (W^2 / S^4)) by (field;
    lra).
  assert (N : 0 <= eps^2 * K * s * S) by (repeat apply Rmult_le_pos; lra).
  apply Rle_trans with (1.0012 * (2 * eps^2 * K * s * S) * 0.9998); [lra | apply Rmult_le_compat_l; lra].
Qed.
Lemma fall_sin : sin b' - sin b <= 1.0010 * (2 * eps * K * s / S^2).
Proof.
  destruct small as [s0 [[D0 D1] [D2 [[W0 W1] [Cd Cd1]]]]]. destruct cosines as [C1 [C2 _]].
  destruct (signs eps u u' th (proj1 Heps) Hu Hu2 Hth) as [_ [_ [_ [K0 _]]]]. fold U in K0. fold K in K0.
  destruct (sines u u' Hu Hu2) as [S1 S2].
  assert (E := L43c_sin eps u u' (proj1 Heps) Hu Hu2). fold b b' in E. fold U d in E. rewrite (proj1 W_is) in E.
  rewrite (sin_2a U) in E. fold S K in E. set (c := cos b) in *. set (c' := cos b') in *.
  assert (SP : 0 < S * S) by (apply Rmult_lt_0_compat; lra). assert (WP : 0 < W) by lra.
  assert (V1 := divided_by_share (sin u) c ltac:(lra) C1). assert (V2 := divided_by_share (sin u') c' ltac:(lra) C2).
  assert (DP : 2 * S * cos d <= sin u / c + sin u' / c') by (rewrite <- (proj2 W_is); lra).
  assert (SC : 0 < S * cos d) by (apply Rmult_lt_0_compat; lra).
  assert (T : sin (2 * d) <= 2 * (1.0001 * s)).
  { apply Rle_trans with (2 * d); [left; apply sin_lt_x; lra | lra]. }
  replace (sin b' - sin b) with (eps * (2 * S * K * sin (2 * d)) * c * c' / (W * (sin u / c + sin u' / c'))) by lra.
  apply quotient_at_most; [apply Rmult_lt_0_compat; lra|].
  assert (SD : 0 <= sin (2 * d)) by (apply sin_ge_0; assert (P := pi_value); lra).
  assert (SK : 0 <= 2 * S * K) by (repeat apply Rmult_le_pos; lra).
  assert (N : 0 <= eps * (2 * S * K * sin (2 * d))) by (apply Rmult_le_pos; [lra | now apply Rmult_le_pos]).
  assert (CC : 0 < c * c' <= 1 * 1) by (split; [apply Rmult_lt_0_compat | apply Rmult_le_compat]; lra).
  apply Rle_trans with (eps * (2 * S * K * (2 * (1.0001 * s)))).
  { apply Rle_trans with (eps * (2 * S * K * sin (2 * d)) * 1).
    - rewrite Rmult_assoc. apply Rmult_le_compat_l; lra.
    - rewrite Rmult_1_r. apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_l; lra. }
  assert (M : 0 <= eps * K * s) by (repeat apply Rmult_le_pos; lra).
  apply Rle_trans with (1.0010 * (2 * eps * K * s / S^2) * (0.9999 * (S * S) * (2 * S * 0.99999))).
  - replace (1.0010 * (2 * eps * K * s / S^2) * (0.9999 * (S * S) * (2 * S * 0.99999))) with
      (1.0010 * 0.9999 * 0.99999 * (4 * (eps * K * s) * S)) by (field; lra).
    assert (0 <= eps * K * s * S) by (apply Rmult_le_pos; lra). lra.
  - apply Rmult_le_compat_l.
    + apply Rmult_le_pos; [lra|]. apply Rle_mult_inv_pos; [lra | apply pow_lt; lra].
    + apply Rmult_le_compat; [lra | lra | lra |]. apply Rle_trans with (2 := DP). apply Rmult_le_compat_l; lra.
Qed.
(** al' - al. *)
Lemma turn_below : 0.9999 * (2 * eps) <= S * (b + b').
Proof.
  destruct small as [s0 [[D0 D1] [D2 [[W0 W1] [Cd _]]]]]. destruct (sines u u' Hu Hu2) as [S1 S2].
  assert (SP : 0 < S * S) by (apply Rmult_lt_0_compat; lra). destruct (SIN_bound u) as [_ U1].
  assert (X : forall v, 0.75 <= sin v -> eps / sin v * 0.99999 <= beta eps v).
  { intros v Hv. unfold beta. assert (A := arctangent_below (eps / sin v)).
    assert (P : 0 < eps / sin v <= 0.002) by (split; [apply Rdiv_lt_0_compat | apply quotient_at_most]; lra).
    specialize (A ltac:(lra)). set (x := eps / sin v) in *.
    assert (x * x <= 0.002 * 0.002) by (apply Rmult_le_compat; lra).
    assert (x * x * x <= 0.002 * 0.002 * x) by (apply Rmult_le_compat_r; lra). lra. }
  assert (L : 0.75 <= sin u').
  { destruct (sine_u u u' th Hu Hu2 Hth) as [_ E']. fold U d in E'. fold S s in E'. rewrite E'. destruct (COS_bound
    U) as [_ K1].
    assert (S * 0.99999 <= S * cos d) by (apply Rmult_le_compat_l; lra).
    assert (cos U * s <= 1 * s) by (apply Rmult_le_compat_r; lra). lra. }
  assert (A := X u ltac:(lra)). assert (A' := X u' L). fold b in A. fold b' in A'.
  assert (E : eps / sin u + eps / sin u' = eps * (2 * S * cos d) / W).
  { rewrite <- (proj1 W_is), <- (proj2 W_is). field. lra. }
  apply Rle_trans with (S * ((eps / sin u + eps / sin u') * 0.99999)); [|apply Rmult_le_compat_l; lra].
  rewrite E. replace (S * (eps * (2 * S * cos d) / W * 0.99999)) with (0.99999 * (2 * eps) * (cos d * (S * S / W)))
    by (field; lra).
  assert (R : 1 <= S * S / W) by (apply quotient_at_least; lra).
  assert (0.99999 * 1 <= cos d * (S * S / W)) by (apply Rmult_le_compat; lra).
  apply Rle_trans with (0.99999 * (2 * eps) * (0.99999 * 1)); [lra | apply Rmult_le_compat_l; lra].
Qed.

Theorem rate_above : invariant u (th - b) - invariant u' (th + b') <= 1.0014 * fall_rate th Q * (eps^2 * (b + b')).
Proof.
  destruct small as [s0 [[D0 D1] [D2 [[W0 W1] [Cd Cd1]]]]]. destruct cosines as [C1 [C2 C3]].
  destruct (signs eps u u' th (proj1 Heps) Hu Hu2 Hth) as [_ [_ [_ [K0 [_ [_ [C [Sn [_ [_ F0]]]]]]]]]].
  fold U in K0, F0. fold K in K0. fold F in F0. assert (XN := X'_neg eps u u' th (proj1 Heps) Hu Hu2 Hth). cbv zeta
    in XN. fold U d in XN.
  assert (XF := X_falls eps u u' th (proj1 Heps) Hu Hu2 Hth). cbv zeta in XF. fold U d in XF.
  assert (E0 := L43c_fall eps u u' th Hu Hu2 Hth HE). fold b b' in E0. fold U d in E0. fold F in E0.
  fold Q in E0. rewrite E0. clear E0. assert (Q0 : 0 < Q) by (now apply Rmult_lt_0_compat).
  assert (A := fall_X). assert (B := fall_cos). assert (D := fall_sin). assert (T := turn_below).
  set (X := sin d * sin U / sin u - d) in *. set (X' := d - sin d * sin U / sin u') in *.
  set (t := tan th * F / S). assert (Es : s = eps * t).
  { assert (Z := seven eps u u' th HE). fold U d in Z. fold s S F in Z. unfold t. apply Rmult_eq_reg_r with S; [|lra].
    rewrite Z. field. lra. }
  assert (S3 : 0 < S^3) by (apply pow_lt; lra). assert (S2 : 0 < S^2) by (apply pow_lt; lra).
  assert (B1 : cos th * (cos b * (X - X') + X' * (cos b - cos b')) <= 1.0012 * (cos th * (s^3 * (2 - 4/3 * S^2) /
    S^2))).
  { apply Rle_trans with (cos th * (1.0012 * (s^3 * (2 - 4/3 * S^2) / S^2))); [|lra]. apply Rmult_le_compat_l; [lra|].
    assert (cos b * (X - X') <= 1 * (X - X')) by (apply Rmult_le_compat_r; lra).
    assert (0 <= - X' * (cos b - cos b')) by (apply Rmult_le_pos; lra). lra. }
  assert (B2 : Q * (cos b - cos b') <= 1.0012 * (Q * (2 * eps^2 * K * s / S^3)))
    by (apply Rle_trans with (Q * (1.0012 * (2 * eps^2 * K * s / S^3))); [apply Rmult_le_compat_l|]; lra).
  assert (B3 : - (d * sin th * (sin b - sin b')) <= 1.0012 * (s * sin th * (2 * eps * K * s / S^2))).
  { assert (M : 0 <= 2 * eps * K * s / S^2) by (apply Rle_mult_inv_pos; [repeat apply Rmult_le_pos; lra | lra]).
    assert (N : 0 <= d * sin th <= 1.0001 * s * sin th)
      by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
    apply Rle_trans with (d * sin th * (1.0010 * (2 * eps * K * s / S^2)));
      [assert (H := Rmult_le_compat_l (d * sin th) _ _ ltac:(lra) D); lra|].
    apply Rle_trans with (1.0001 * s * sin th * (1.0010 * (2 * eps * K * s / S^2))); [apply Rmult_le_compat_r; lra|].
    assert (0 <= s * sin th * (2 * eps * K * s / S^2)) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra). lra. }
  assert (L : fall_rate th Q = cos th * t^3 * (1 - 2/3 * S^2) / S + Q * K * t / S^2 + t^2 * sin th * K / S).
  { unfold fall_rate. cbv zeta. replace (Q / cos th) with F by (unfold Q; field; lra).
    replace (sin F) with S by (unfold F, S; rewrite sin_minus, sin_PI, cos_PI; ring).
    replace (- cos F) with K by (unfold F, K; rewrite cos_minus, sin_PI, cos_PI; ring). reflexivity. }
  assert (E : cos th * (s^3 * (2 - 4/3 * S^2) / S^2) + Q * (2 * eps^2 * K * s / S^3) + s * sin th * (2 * eps * K * s
    / S^2)
    = eps^2 * (2 * eps) / S * fall_rate th Q) by (rewrite L, Es; field; lra).
  destruct (SIN_bound U) as [_ SU]. fold S in SU.
  assert (SS : S^2 <= 1) by (apply Rle_trans with (1^2); [apply pow_incr|]; lra).
  assert (t0 : 0 <= t) by (apply Rmult_le_reg_l with eps; lra).
  assert (L0 : 0 <= fall_rate th Q).
  { rewrite L. assert (0 <= t^3) by (now apply pow_le). assert (0 <= t^2) by (now apply pow_le).
    assert (0 <= cos th * t^3 * (1 - 2/3 * S^2) / S)
      by (apply Rle_mult_inv_pos; [apply Rmult_le_pos; [apply Rmult_le_pos|]|]; lra).
    assert (0 <= Q * K * t / S^2) by (apply Rle_mult_inv_pos; [apply Rmult_le_pos; [apply Rmult_le_pos|]|]; lra).
    assert (0 <= t^2 * sin th * K / S) by (apply Rle_mult_inv_pos; [apply Rmult_le_pos; [apply Rmult_le_pos|]|]; lra).
    lra. }
  apply Rle_trans with (1.0012 * (eps^2 * (2 * eps) / S * fall_rate th Q)); [lra|].
  assert (E2 : 0 < eps^2) by (apply pow_lt; lra).
  assert (G : 2 * eps / S <= 1.00015 * (b + b')) by (apply quotient_at_most; lra).
  replace (eps^2 * (2 * eps) / S * fall_rate th Q) with (fall_rate th Q * eps^2 * (2 * eps / S)) by (field; lra).
  assert (H := Rmult_le_compat_l (fall_rate th Q * eps^2) _ _ ltac:(apply Rmult_le_pos; lra) G).
  assert (BB : 0 <= b + b') by (destruct (betas eps u u' (proj1 Heps) Hu Hu2) as [? [? _]]; unfold b, b'; lra).
  assert (0 <= fall_rate th Q * eps^2 * (b + b')) by (repeat apply Rmult_le_pos; lra).
  lra.
Qed.
End Step.

(** What coq-interval does. *)
Lemma rates th Q : near_half_pi Q -> 0 <= th ->
  (th <= 0.6 -> 1.0014 * fall_rate th Q <= 2.1) /\ (0.6 <= th <= 0.7 -> 1.0014 * fall_rate th Q <= 6.2) /\
  (0.7 <= th <= 0.7944 -> 1.0014 * fall_rate th Q <= 22.7).
Proof.
  unfold near_half_pi, fall_rate. intros HQ H0. assert (P := pi_digits).
  assert (HQ' : 1.57078 <= Q <= 1.57083) by lra. clear HQ P. cbv zeta.
  repeat split; intros H; interval with (i_bisect th, i_taylor th, i_depth 12).
Qed.
Lemma ranges th Q : near_half_pi Q -> 0 <= th <= 0.7944 -> 0.78 <= sin (Q / cos th) /\
  1/1000 * (tan th * (Q / cos th) / sin (Q / cos th)) <= 0.003.
Proof.
  unfold near_half_pi. intros HQ H. assert (P := pi_digits).
  assert (HQ' : 1.57078 <= Q <= 1.57083) by lra. clear HQ P.
  split; interval with (i_bisect th, i_taylor th, i_depth 12).
Qed.

(** A flight of the bulk has the sines that [Step] asks for. *)
Lemma bulk_sines eps u u' th : 0 < eps <= 1/1000 -> 0 < u' < u -> u <= PI/2 -> 0 <= th <= 0.7944 ->
  cos u' - cos u = eps * tan th * (2 * PI - u - u') -> near_half_pi ((PI - middle u u') * cos th) ->
  sin (half u u') <= 0.003 /\ 0.78 <= sin (middle u u').
Proof.
  intros He B1 B2 Hth E HQ. assert (P := PI2_1). set (F := PI - middle u u') in *.
  assert (C : 0 < cos th) by (apply cos_gt_0; lra). destruct (ranges th (F * cos th) HQ Hth) as [R1 R2].
  replace (F * cos th / cos th) with F in R1, R2 by (field; lra).
  assert (ES : sin F = sin (middle u u')) by (unfold F; rewrite sin_minus, sin_PI, cos_PI; ring). rewrite ES in R1, R2.
  split; [|exact R1]. assert (Z := seven eps u u' th E). fold F in Z.
  apply Rle_trans with (2 := R2). apply Rle_trans with (eps * (tan th * F / sin (middle u u'))).
  - right. apply Rmult_eq_reg_r with (sin (middle u u')); [|lra]. rewrite Z. field. lra.
  - apply Rmult_le_compat_r; [|apply He]. assert (F0 : 0 < F) by (unfold F, middle; lra).
    apply Rle_mult_inv_pos; [|lra]. apply Rmult_le_pos; [|lra].
    destruct (Req_dec th 0) as [->|]; [rewrite tan_0; lra | left; apply tan_gt_0; lra].
Qed.

Theorem C10 eps u al u' al' : step eps u al u' al' -> eps <= 1/1000 ->
  near_half_pi (middle_invariant eps u al u') ->
  let th := al + beta eps u in
  let Lambda hi := invariant u al - invariant u' al' <= hi * (eps^2 * (al' - al)) in
  (th <= 0.6 -> Lambda 2.1) /\ (0.6 <= th <= 0.7 -> Lambda 6.2) /\ (0.7 <= th <= 0.7944 -> Lambda 22.7).
Proof.
  intros [A [B1 B2] [C1 C2] D E] He HQ th Lambda. assert (P := PI2_1).
  assert (S1 := beta_pos eps u (proj1 A) ltac:(apply sin_gt_0; lra)).
  assert (S2 := beta_pos eps u' (proj1 A) ltac:(apply sin_gt_0; lra)).
  assert (Hth : 0 <= th < PI/2) by (unfold th; lra). assert (C : 0 < cos th) by (apply cos_gt_0; lra).
  unfold middle_invariant in HQ. fold th in HQ, E. set (F := PI - middle u u') in *.
  assert (Er : forall hi, th <= 0.7944 -> 1.0014 * fall_rate th (F * cos th) <= hi -> Lambda hi).
  { intros hi Ht Hr. unfold Lambda. destruct (bulk_sines eps u u' th ltac:(lra) B1 B2 ltac:(lra) E HQ) as [Sd R1].
    assert (G := rate_above eps u u' th ltac:(lra) B1 B2 Hth E Sd R1). fold F in G.
    replace (th - beta eps u) with al in G by (unfold th; ring). replace (th + beta eps u') with al' in G by (unfold
      th; lra).
    replace (beta eps u + beta eps u') with (al' - al) in G by (unfold th in *; lra).
    apply Rle_trans with (1 := G). apply Rmult_le_compat_r; [|exact Hr].
    apply Rmult_le_pos; [apply pow2_ge_0 | unfold th in *; lra]. }
  destruct (rates th (F * cos th) HQ (proj1 Hth)) as [R1 [R2 R3]].
  split; [|split]; intros H; (apply Er; [lra|]); [apply R1 | apply R2 | apply R3]; lra.
Qed.

