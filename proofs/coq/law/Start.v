(** The clock at the first contact (L46 of law.md).

    corner_clock == T_0 = C/(2 eps) on the corner orbit
    W            == sin (J/cos a)
    growth_lost  == what the integral C loses as J rises from pi/2
    top_clock    == C/(2 eps) - 1/2 - T_1 is in [0.0580, 0.0590] eps on the top orbit *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Dumbbell Require Import PiValue Quotients Trigonometry Ray LawStatement Sines Angles Orbit Ends Windows.
Local Open Scope R_scope.

Lemma third : acos (PI / 2 / PI) = PI / 3.
Proof.
  assert (P := pi_value). replace (PI / 2 / PI) with (1 / 2) by (field; lra). rewrite <- cos_PI3. apply acos_cos. lra.
Qed.
Theorem corner_clock eps u al : 0 < eps -> corner_start eps u al -> clock eps u al = growth / (2 * eps).
Proof.
  intros He [-> ->]. unfold clock, clock_integral, invariant. rewrite cos_0, Rmult_1_r.
  replace (PI - PI / 2) with (PI / 2) by field. now rewrite third.
Qed.

(** W J a = sin (J/cos a), for a in [0, pi/3]. *)
Definition W J a := sin (J / cos a).
Lemma cos_third a : 0 <= a <= PI/3 -> 1/2 <= cos a <= 1.
Proof.
  intros Ha. assert (P := pi_value). split; [rewrite <- cos_PI3; apply cos_decr_1; lra | apply COS_bound].
Qed.
Lemma W_integrable J x z : 0 <= x <= z -> z <= PI/3 -> ex_RInt (W J) x z.
Proof.
  intros Hx Hz. apply (ex_RInt_continuous (V := R_CompleteNormedModule)). rewrite Rmin_left, Rmax_right by lra.
  intros a Ha. apply (ex_derive_continuous (W J) a). unfold W. auto_derive. destruct (cos_third a); lra.
Qed.
Definition slope_of_growth : R := RInt (fun a => - cos (PI / 2 / cos a) / cos a) 0 (PI / 3).
Lemma slope_value : 0.5493 <= slope_of_growth <= 0.5494.
Proof. unfold slope_of_growth. split; integral. Qed.
Lemma slope_integrable : ex_RInt (fun a => - cos (PI / 2 / cos a) / cos a) 0 (PI / 3).
Proof.
  assert (P := pi_value). apply (ex_RInt_continuous (V := R_CompleteNormedModule)).
  rewrite Rmin_left, Rmax_right by lra.
  intros a Ha. apply (ex_derive_continuous (fun a => - cos (PI / 2 / cos a) / cos a) a). auto_derive.
  destruct (cos_third a); lra.
Qed.

Section Top.
Variables J b : R.
Hypothesis HJ : PI/2 <= J <= PI/2 + 1/1000000.
Hypothesis Hb : 0 <= b <= 0.0013.
Let A := acos (J / PI).
Let h := J - PI/2.

Lemma upper_end : 1 <= A <= PI/3 /\ PI * cos A = J.
Proof.
  assert (P := pi_value). assert (R : 1/2 <= J / PI <= 0.51).
  { split; [apply quotient_at_least | apply quotient_at_most]; lra. }
  assert (C : cos A = J / PI) by (apply cos_acos; lra). destruct (acos_bound (J / PI)) as [B1 B2]. fold A in B1, B2.
  assert (V : 0.54 <= cos 1) by interval. split; [split|rewrite C; field; lra].
  - apply Rnot_lt_le. intros K. assert (cos 1 <= cos A) by (apply cos_decr_1; lra). lra.
  - apply Rnot_lt_le. intros K. assert (cos A < cos (PI/3)) by (apply cos_decreasing_1; lra). rewrite cos_PI3 in *.
    lra.
Qed.
(** What the whole integral loses as J rises from pi/2. *)
Lemma growth_lost : h * slope_of_growth - 4.2 * (h * h) <= growth - RInt (W J) 0 (PI/3) <=
  h * slope_of_growth + 4.2 * (h * h).
Proof.
  assert (P := pi_value). assert (h0 : 0 <= h) by (unfold h; lra).
  set (f := fun k a => h * (- cos (PI / 2 / cos a) / cos a) + k * (h * h)).
  assert (F : forall k, is_RInt (f k) 0 (PI/3) (h * slope_of_growth + PI/3 * (k * (h * h)))).
  { intros k. apply (is_RInt_plus (fun a => h * (- cos (PI / 2 / cos a) / cos a)) (fun _ => k * (h * h))).
    - apply (is_RInt_scal (fun a => - cos (PI / 2 / cos a) / cos a)).
      exact (RInt_correct (V := R_CompleteNormedModule) _ _ _ slope_integrable).
    - replace (PI/3 * (k * (h * h))) with ((PI/3 - 0) * (k * (h * h))) by ring.
      apply (is_RInt_const 0 (PI/3) (k * (h * h))). }
  assert (I := fun K => W_integrable K 0 (PI/3) ltac:(lra) ltac:(lra)).
  assert (M : is_RInt (fun a => W (PI/2) a - W J a) 0 (PI/3) (growth - RInt (W J) 0 (PI/3))).
  { apply (is_RInt_minus (W (PI/2)) (W J)); [exact (RInt_correct (V := R_CompleteNormedModule) _ _ _ (I (PI/2)))
      | exact (RInt_correct (V := R_CompleteNormedModule) _ _ _ (I J))]. }
  assert (K : forall a, 0 < a < PI/3 -> f (-4) a <= W (PI/2) a - W J a <= f 4 a).
  { intros a Ha. destruct (cos_third a ltac:(lra)) as [B1 B2]. unfold f, W.
    set (y := PI / 2 / cos a). set (dd := h / cos a).
    assert (D0 : 0 <= dd) by (apply Rmult_le_pos; [exact h0 | left; apply Rinv_0_lt_compat; lra]).
    assert (D1 : dd <= 2 * h). { apply quotient_at_most; [lra|].
      apply Rle_trans with (2 * h * (1/2)); [lra | apply Rmult_le_compat_l; lra]. }
    assert (D2 : dd * dd <= 2 * h * (2 * h)) by (apply Rmult_le_compat; lra).
    replace (J / cos a) with (y + dd) by (unfold y, dd, h; field; lra).
    assert (Sh := sin_near y dd). apply Rabs_le_between in Sh.
    replace (h * (- cos y / cos a)) with (- (dd * cos y)) by (unfold dd; field; lra). lra. }
  assert (L := is_RInt_le _ _ 0 (PI/3) _ _ ltac:(lra) (F (-4)) M (fun a Ha => proj1 (K a Ha))).
  assert (U := is_RInt_le _ _ 0 (PI/3) _ _ ltac:(lra) M (F 4) (fun a Ha => proj2 (K a Ha))).
  assert (0 <= h * h) by apply Rle_0_sqr.
  assert (PI/3 * (h * h) <= 1.05 * (h * h)) by (apply Rmult_le_compat_r; lra). lra.
Qed.
(** What the clock has, from both sides. *)
Lemma from_above : growth - clock_integral J b <= h * slope_of_growth + 4.2 * (h * h) + b.
Proof.
  assert (P := pi_value). destruct upper_end as [[A1 A2] EA]. unfold clock_integral. fold (W J). fold A.
  assert (C1 : RInt (W J) b (PI/3) <= RInt (W J) b A).
  { rewrite <- (RInt_Chasles (W J) b A (PI/3)); [|apply W_integrable; lra | apply W_integrable; lra].
    assert (RInt (W J) A (PI/3) <= 0); [|unfold plus; simpl; lra].
    apply Rle_trans with (RInt (fun _ => 0) A (PI/3)); [|rewrite RInt_const; unfold scal; simpl; unfold mult; simpl;
      lra].
    apply RInt_le; [lra | apply W_integrable; lra | apply ex_RInt_const|]. intros a Ha. unfold W.
    destruct (cos_third a ltac:(lra)) as [B1 B2].
    assert (B3 : cos a <= cos A) by (apply cos_decr_1; lra).
    apply sin_le_0; [apply quotient_at_least | apply quotient_at_most]; try lra.
    - rewrite <- EA. apply Rmult_le_compat_l; lra.
    - apply Rle_trans with (2 * PI * (1/2)); [lra | apply Rmult_le_compat_l; lra]. }
  assert (C2 : RInt (W J) 0 b + RInt (W J) b (PI/3) = RInt (W J) 0 (PI/3)).
  { apply (RInt_Chasles (W J) 0 b (PI/3)); apply W_integrable; lra. }
  assert (C3 : RInt (W J) 0 b <= b).
  { apply Rle_trans with (RInt (fun _ => 1) 0 b); [|rewrite RInt_const; unfold scal; simpl; unfold mult; simpl; lra].
    apply RInt_le; [lra | apply W_integrable; lra | apply ex_RInt_const|]. intros a _. apply SIN_bound. }
  assert (C4 := growth_lost). lra.
Qed.
Lemma from_below w : (forall a, 0 <= a <= b -> w <= W J a) ->
  h * slope_of_growth - 4.2 * (h * h) - 0.002 * h + w * b <= growth - clock_integral J b.
Proof.
  intros Hw. assert (P := pi_value). destruct upper_end as [[A1 A2] EA]. unfold clock_integral. fold (W J). fold A.
  assert (h0 : 0 <= h) by (unfold h; lra).
  assert (A3 : PI/3 - 0.001 <= A).
  { apply Rnot_lt_le. intros K. assert (V : 0.5008 <= cos (PI/3 - 0.001)) by interval.
    assert (cos (PI/3 - 0.001) <= cos A) by (apply cos_decr_1; lra).
    assert (PI * 0.5008 <= PI * cos A) by (apply Rmult_le_compat_l; lra). lra. }
  assert (C1 : - 0.002 * h <= RInt (W J) A (PI/3)).
  { apply Rle_trans with (RInt (fun _ => - 2 * h) A (PI/3)).
    - rewrite RInt_const; unfold scal; simpl; unfold mult; simpl.
      assert ((PI/3 - A) * h <= 0.001 * h) by (apply Rmult_le_compat_r; lra). lra.
    - apply RInt_le; [lra | apply ex_RInt_const | apply W_integrable; lra|]. intros a Ha. unfold W.
      destruct (cos_third a ltac:(lra)) as [B1 B2]. assert (B3 : cos a <= cos A) by (apply cos_decr_1; lra).
      assert (L : PI <= J / cos a).
      { apply quotient_at_least; [lra|]. rewrite <- EA. apply Rmult_le_compat_l; lra. }
      assert (U : J / cos a <= PI + 2 * h).
      { apply quotient_at_most; [lra|]. unfold h. apply Rle_trans with ((PI + 2 * (J - PI/2)) * (1/2)); [lra|].
        apply Rmult_le_compat_l; lra. }
      replace (J / cos a) with (J / cos a - PI + PI) by ring. rewrite neg_sin.
      assert (sin (J / cos a - PI) <= J / cos a - PI); [|lra].
      destruct L as [L|<-]; [left; apply sin_lt_x; lra | replace (PI - PI) with 0 by ring; rewrite sin_0; lra]. }
  assert (C2 : RInt (W J) 0 b + RInt (W J) b A = RInt (W J) 0 A)
    by (apply (RInt_Chasles (W J) 0 b A); apply W_integrable; lra).
  assert (C3 : RInt (W J) 0 A + RInt (W J) A (PI/3) = RInt (W J) 0 (PI/3))
    by (apply (RInt_Chasles (W J) 0 A (PI/3)); apply W_integrable; lra).
  assert (C4 : w * b <= RInt (W J) 0 b).
  { apply Rle_trans with (RInt (fun _ => w) 0 b); [rewrite RInt_const; unfold scal; simpl; unfold mult; simpl; lra|].
    apply RInt_le; [lra | apply ex_RInt_const | apply W_integrable; lra|]. intros a Ha. apply Hw. lra. }
  assert (C5 := growth_lost). lra.
Qed.
End Top.

Theorem top_clock eps u al : 0 < eps <= 1/1000 -> top_start eps u al ->
  0.0580 * eps <= growth / (2 * eps) - 1/2 - clock eps u al <= 0.0590 * eps.
Proof.
  intros He H. assert (HJ := top_first eps u al He H). destruct H as [x [Hx [Sx [Eu ->]]]]. assert (P := pi_value).
  assert (E2 : 0 < eps * eps <= 1/1000 * eps) by (split; [apply Rmult_lt_0_compat | apply Rmult_le_compat_r]; lra).
  assert (E3 : 0 < eps * eps * eps <= 1/1000 * (eps * eps))
    by (split; [apply Rmult_lt_0_compat; lra | rewrite Rmult_comm; apply Rmult_le_compat_r; lra]).
  assert (E4 : 0 < eps * eps * (eps * eps) <= 1/1000000 * (eps * eps))
    by (split; [apply Rmult_lt_0_compat | apply Rmult_le_compat_r]; lra).
  destruct (arcsine x _ Hx Sx ltac:(lra)) as [X1 X2]. assert (Cx := cosine_below x ltac:(lra)).
  destruct (COS_bound x) as [_ Cx1].
  assert (XX : x * x <= 1.1 * (eps * eps * (eps * eps))).
  { apply Rle_trans with (1.000001 * (eps * eps) * (1.000001 * (eps * eps))); [apply Rmult_le_compat; lra | lra]. }
  set (b := beta eps u) in *. assert (Su : sin u = cos x) by (rewrite Eu; apply Rtrigo1.sin_shift).
  assert (B := beta_above eps u ltac:(lra) ltac:(lra)). fold b in B. rewrite Su in B.
  assert (B1 : b <= eps + 0.000001 * (eps * eps)).
  { apply Rle_trans with (1 := proj2 B). apply quotient_at_most; [lra|].
    assert ((eps + 0.000001 * (eps * eps)) * (1 - 0.6 * (eps * eps * (eps * eps))) <= (eps + 0.000001 * (eps * eps)) *
      cos x)
      by (apply Rmult_le_compat_l; lra).
    assert (eps * (eps * eps * (eps * eps)) <= eps * (1/1000000 * (eps * eps))) by (apply Rmult_le_compat_l; lra).
    assert (eps * eps * (eps * eps * (eps * eps)) <= eps * eps * (1/1000000 * (eps * eps)))
      by (apply Rmult_le_compat_l; lra). lra. }
  assert (B2 : eps - eps * eps * eps <= b).
  { apply Rle_trans with (1 := arctangent_below eps ltac:(lra)). unfold b, beta. rewrite Su.
    destruct (Req_dec (cos x) 1) as [Z|Z]; [rewrite Z, Rdiv_1; lra|]. left. apply atan_increasing.
    apply Rmult_lt_reg_r with (cos x); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    assert (eps * cos x < eps * 1) by (apply Rmult_lt_compat_l; lra). lra. }
  set (J := invariant u b) in *. assert (HJ2 : PI/2 <= J <= PI/2 + 1/1000000) by lra.
  assert (U := from_above J b HJ2 ltac:(lra)). destruct slope_value as [V0 V].
  assert (G1 : (J - PI/2) * slope_of_growth <= 0.2147 * (eps * eps) * 0.5494).
  { apply Rle_trans with ((J - PI/2) * 0.5494); [apply Rmult_le_compat_l; lra | apply Rmult_le_compat_r; lra]. }
  assert (G2 : (J - PI/2) * (J - PI/2) <= 0.2147 * (eps * eps) * (0.2147 * (eps * eps)))
    by (apply Rmult_le_compat; lra).
  assert (G3 : 0.2145 * (eps * eps) * 0.5493 <= (J - PI/2) * slope_of_growth) by (apply Rmult_le_compat; lra).
  assert (L : (J - PI/2) * slope_of_growth - 4.2 * ((J - PI/2) * (J - PI/2)) - 0.002 * (J - PI/2) +
    (1 - 0.00001 * (eps * eps)) * b <= growth - clock_integral J b).
  { apply from_below; [exact HJ2 | lra |]. intros a Ha. unfold W. assert (Ca := cosine_below a ltac:(lra)).
    destruct (COS_bound a) as [_ Ca1].
    assert (aa : a * a <= 1.1 * (eps * eps)).
    { apply Rle_trans with (1.01 * eps * (1.01 * eps)); [apply Rmult_le_compat; lra | lra]. }
    assert (Y : PI/2 <= J / cos a <= PI/2 + 1.3 * (eps * eps)).
    { split; [apply quotient_at_least | apply quotient_at_most]; try lra.
      - apply Rle_trans with (PI/2 * 1); [apply Rmult_le_compat_l; lra | lra].
      - apply Rle_trans with ((PI/2 + 1.3 * (eps * eps)) * (1 - 0.55 * (eps * eps))); [|apply Rmult_le_compat_l; lra].
        assert (PI * (eps * eps) <= 3.1416 * (eps * eps)) by (apply Rmult_le_compat_r; lra). lra. }
    replace (J / cos a) with (PI/2 + (J / cos a - PI/2)) by ring. rewrite <- cos_sin.
    assert (Cy := cosine_below (J / cos a - PI/2) ltac:(lra)).
    assert ((J / cos a - PI/2) * (J / cos a - PI/2) <= 1.3 * (eps * eps) * (1.3 * (eps * eps)))
      by (apply Rmult_le_compat; lra). lra. }
  assert (L2 : eps * eps * b <= eps * eps * 0.0013) by (apply Rmult_le_compat_l; lra).
  assert (EC : growth / (2 * eps) - 1/2 - clock eps u b = (growth - clock_integral J b - eps) / (2 * eps))
    by (unfold clock; fold J; field; lra).
  rewrite EC. split; apply Rmult_le_reg_r with (2 * eps); try lra;
    replace ((growth - clock_integral J b - eps) / (2 * eps) * (2 * eps)) with (growth - clock_integral J b - eps)
      by (field; lra).
  - lra.
  - lra.
Qed.
