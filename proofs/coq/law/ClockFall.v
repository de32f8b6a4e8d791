(** What the clock's integral S loses as J falls (dS/dJ = -P in L46 and L51 of law.md): P is enclosed by a polynomial,
    for every J of the window of (C9).

    loss          == - dW/dJ at J = pi/2
    loss_integral == a polynomial near its integral from an angle to pi/3; loss_slope == minus its derivative
    end_near      == the upper end of S is near pi/3
    loss_from     == the integral up to there, within 0.00022 of the polynomial
    clock_falls   == S (J, x) - S (J', x) = - (J - J') P, P within 0.0005 of the polynomial *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Dumbbell Require Import Quotients PiValue Trigonometry LawStatement Start Windows ClockAngle.
Local Open Scope R_scope.

Definition loss a := - cos (PI / 2 / cos a) / cos a.
Definition loss_integral x := 0.54935 - 0.2629 * x^3 - 0.1347 * x^5 - 0.08123 * x^7 + 0.0151 * x^9.
Definition loss_slope x := 0.7887 * x^2 + 0.6735 * x^4 + 0.56861 * x^6 - 0.1359 * x^8.

Lemma cosine_least a : -1 < a < 1.0473 -> 0.4999 <= cos a.
Proof. intros Ha. interval. Qed.
Lemma loss_bound a : -1 < a < 1.0473 -> Rabs (loss a) <= 2.01.
Proof.
  intros Ha. assert (C := cosine_least a Ha). unfold loss, Rdiv. rewrite Rabs_mult, Rabs_Ropp.
  assert (K : Rabs (cos (PI * / 2 * / cos a)) <= 1) by (apply Rabs_le, COS_bound).
  assert (I : / cos a <= 2.01) by (replace (/ cos a) with (1 / cos a) by (field; lra); apply quotient_at_most; lra).
  assert (P : 0 < / cos a) by (apply Rinv_0_lt_compat; lra). rewrite (Rabs_pos_eq (/ cos a)) by lra.
  apply Rle_trans with (1 * 2.01); [|lra]. apply Rmult_le_compat; try lra. apply Rabs_pos.
Qed.
Lemma loss_between x z : -1 < x < 1.0473 -> -1 < z < 1.0473 -> ex_RInt loss x z.
Proof.
  intros Hx Hz. apply (ex_RInt_continuous (V := R_CompleteNormedModule)). intros a Ha.
  assert (C : 0.4999 <= cos a).
  { apply cosine_least. split; [apply Rlt_le_trans with (2 := proj1 Ha), Rmin_glb_lt |
      apply Rle_lt_trans with (1 := proj2 Ha), Rmax_lub_lt]; lra. }
  apply (ex_derive_continuous loss a). unfold loss. auto_derive. lra.
Qed.

(** The upper end. *)
Lemma end_near J : near_half_pi J -> let A := acos (J / PI) in
  PI * cos A = J /\ PI/3 - 0.00002 <= A <= PI/3 + 0.00002.
Proof.
  intros HJ A. unfold near_half_pi in HJ. assert (P := pi_digits). assert (R : 0.49999 <= J / PI <= 0.50001)
    by (split; [apply quotient_at_least | apply quotient_at_most]; lra).
  assert (C : cos A = J / PI) by (apply cos_acos; lra). destruct (acos_bound (J / PI)) as [B1 B2]. fold A in B1, B2.
  assert (V : cos (PI/3 + 0.00002) < 0.49999) by interval. assert (V' : 0.50001 < cos (PI/3 - 0.00002)) by interval.
  split; [rewrite C; field; lra|]. split; apply Rnot_lt_le; intros K.
  - assert (cos (PI/3 - 0.00002) <= cos A) by (apply cos_decr_1; lra). lra.
  - assert (cos A <= cos (PI/3 + 0.00002)) by (apply cos_decr_1; lra). lra.
Qed.

(** The polynomial's derivative is near - loss; at 0 it is near the whole integral. *)
Lemma loss_near a : 0 <= a <= 0.8 -> loss_slope a + -0.00014 <= loss a <= loss_slope a + 0.00014.
Proof.
  intros Ha. assert (B : Rabs (loss a - loss_slope a) <= 0.00014); [|apply Rabs_le_between in B; lra].
  unfold loss, loss_slope. interval with (i_bisect a, i_taylor a).
Qed.
Lemma loss_from x z : 0 <= x <= 0.8 -> PI/3 - 0.00002 <= z <= PI/3 + 0.00002 ->
  loss_integral x - 0.00022 <= RInt loss x z <= loss_integral x + 0.00022.
Proof.
  intros Hx Hz. assert (P := pi_digits).
  assert (Q : forall k, is_RInt (fun a => loss_slope a + k) 0 x (0.54935 - loss_integral x + x * k)).
  { intros k. replace (0.54935 - loss_integral x + x * k) with
      ((0.54935 - loss_integral x + x * k) - (0.54935 - loss_integral 0 + 0 * k)) by (unfold loss_integral; lra).
    apply (is_RInt_derive (fun a => 0.54935 - loss_integral a + a * k)).
    - intros a _. unfold loss_integral, loss_slope. auto_derive; [easy | lra].
    - intros a _. apply (ex_derive_continuous (fun a => loss_slope a + k) a). unfold loss_slope. auto_derive. easy. }
  assert (L : is_RInt loss 0 x (RInt loss 0 x))
    by (apply (RInt_correct (V := R_CompleteNormedModule)), loss_between; lra).
  assert (A := is_RInt_le _ _ 0 x _ _ (proj1 Hx) (Q (-0.00014)) L
    (fun a Ha => proj1 (loss_near a ltac:(lra)))).
  assert (B := is_RInt_le _ _ 0 x _ _ (proj1 Hx) L (Q 0.00014)
    (fun a Ha => proj2 (loss_near a ltac:(lra)))).
  assert (C1 : RInt loss 0 x + RInt loss x (PI/3) = slope_of_growth)
    by (apply (RInt_Chasles loss 0 x (PI/3)); apply loss_between; lra).
  assert (C2 : RInt loss x (PI/3) + RInt loss (PI/3) z = RInt loss x z)
    by (apply (RInt_Chasles loss x (PI/3) z); apply loss_between; lra).
  assert (C3 : Rabs (RInt loss (PI/3) z) <= 0.0000402).
  { destruct (Rle_dec (PI/3) z) as [Z|Z].
    - apply Rle_trans with ((z - PI/3) * 2.01); [|lra].
      apply abs_RInt_le_const; [exact Z | apply loss_between; lra | intros t Ht; apply loss_bound; lra].
    - assert (S : opp (RInt loss z (PI/3)) = RInt loss (PI/3) z) by (apply opp_RInt_swap, loss_between; lra).
      rewrite <- S. unfold opp; simpl. rewrite Rabs_Ropp. apply Rle_trans with ((PI/3 - z) * 2.01); [|lra].
      apply abs_RInt_le_const; [lra | apply loss_between; lra | intros t Ht; apply loss_bound; lra]. }
  apply Rabs_le_between in C3. assert (V := slope_value). lra.
Qed.

Section Fall.
Variables J J' x : R.
Hypothesis HJ : near_half_pi J.
Hypothesis HJ' : near_half_pi J'.
Hypothesis Hfall : J' <= J.
Hypothesis Hx : 0 <= x <= 0.8.
Let h := J - J'.
Let A := acos (J / PI).
Let A' := acos (J' / PI).

(** W itself. *)
Lemma W_falls a : 0 <= a < 1.0473 -> - h * (loss a + 0.000125) <= W J a - W J' a <= - h * (loss a - 0.000125).
Proof.
  intros Ha. assert (P := pi_digits). assert (C := cosine_least a ltac:(lra)). unfold near_half_pi in HJ, HJ'.
  assert (H0 : 0 <= h <= 0.00004) by (unfold h; lra).
  set (d := h / cos a). assert (D : 0 <= d <= 2.001 * h).
  { split; [apply Rle_mult_inv_pos; lra | apply quotient_at_most; [lra|]].
    assert (2.001 * h * 0.4999 <= 2.001 * h * cos a) by (apply Rmult_le_compat_l; lra). lra. }
  destruct (MVT_gen sin (J' / cos a) (J / cos a) cos) as [t [Ht E]].
  { intros. auto_derive; [easy | ring]. } { intros. apply continuity_pt_filterlim, continuous_sin. }
  assert (Ed : J / cos a = J' / cos a + d) by (unfold d, h; field; lra). rewrite Ed in Ht, E.
  rewrite Rmin_left, Rmax_right in Ht by lra. unfold W. rewrite Ed, E.
  assert (L : Rabs (cos t - cos (PI / 2 / cos a)) <= 0.0000622).
  { apply Rle_trans with (1 := cos_lipschitz (PI / 2 / cos a) t). apply Rabs_le.
    assert (Y : forall j, Rabs (j - PI/2) <= 0.00003 -> Rabs (j / cos a - PI / 2 / cos a) <= 0.0000602).
    { intros j Hj. replace (j / cos a - PI / 2 / cos a) with ((j - PI/2) * / cos a) by (field; lra).
      rewrite Rabs_mult, (Rabs_pos_eq (/ cos a)) by (left; apply Rinv_0_lt_compat; lra).
      apply quotient_at_most; [lra|]. assert (0.0000602 * 0.4999 <= 0.0000602 * cos a)
        by (apply Rmult_le_compat_l; lra).
      lra. }
    assert (Y1 := Y J ltac:(apply Rabs_le; lra)). assert (Y2 := Y J' ltac:(apply Rabs_le; lra)).
    apply Rabs_le_between in Y1. apply Rabs_le_between in Y2. lra. }
  apply Rabs_le_between in L. assert (El : h * loss a = - d * cos (PI / 2 / cos a)) by (unfold loss, d; field; lra).
  assert (B : - (0.0000622 * (2.001 * h)) <= (cos t - cos (PI / 2 / cos a)) * d <= 0.0000622 * (2.001 * h)).
  { apply Rabs_le_between. rewrite Rabs_mult. apply Rmult_le_compat; try apply Rabs_pos; apply Rabs_le; lra. }
  replace (cos t * (J' / cos a + d - J' / cos a)) with ((cos t - cos (PI / 2 / cos a)) * d + cos (PI / 2 / cos a) * d)
    by ring.
  lra.
Qed.
(** Beyond the upper end of J. *)
Lemma tail_small : A <= A' /\ 0 <= RInt (W J') A A' <= 0.0001 * h.
Proof.
  assert (P := pi_digits). destruct (end_near J HJ) as [E [E1 E2]]. destruct (end_near J' HJ') as [E' [E1' E2']].
  fold A in E, E1, E2. fold A' in E', E1', E2'. assert (H0 : 0 <= h) by (unfold h; lra).
  assert (L : A <= A').
  { apply Rnot_lt_le. intros K. assert (cos A < cos A') by (apply cos_decreasing_1; lra).
    assert (PI * cos A < PI * cos A') by (apply Rmult_lt_compat_l; lra). lra. }
  split; [exact L|]. assert (I : ex_RInt (W J') A A') by (apply W_between; lra).
  assert (K : forall a, A < a < A' -> 0 <= W J' a <= 2.01 * h).
  { intros a Ha. assert (C := cosine_least a ltac:(lra)). unfold W.
    assert (C1 : cos A' <= cos a) by (apply cos_decr_1; lra). assert (C2 : cos a <= cos A) by (apply cos_decr_1; lra).
    assert (Y1 : J' / cos a <= PI) by (apply quotient_at_most; [lra|]; rewrite <- E'; apply Rmult_le_compat_l; lra).
    assert (Y2 : PI <= J / cos a) by (apply quotient_at_least; [lra|]; rewrite <- E; apply Rmult_le_compat_l; lra).
    assert (Y3 : J / cos a - J' / cos a <= 2.01 * h).
    { replace (J / cos a - J' / cos a) with (h / cos a) by (unfold h; field; lra). apply quotient_at_most; [lra|].
      assert (2.01 * h * 0.4999 <= 2.01 * h * cos a) by (apply Rmult_le_compat_l; lra). lra. }
    assert (Y4 : 0 <= J' / cos a) by (apply Rle_mult_inv_pos; [unfold near_half_pi in HJ'|]; lra).
    split; [apply sin_ge_0; lra|]. rewrite <- (sin_PI_x (J' / cos a)).
    assert (S : sin (PI - J' / cos a) <= PI - J' / cos a); [|lra].
    destruct (Req_dec (PI - J' / cos a) 0) as [->|]; [rewrite sin_0; lra | left; apply sin_lt_x; lra]. }
  assert (M := RInt_le (fun _ => 0) (W J') A A' L (ex_RInt_const A A' 0) I (fun a Ha => proj1 (K a Ha))).
  assert (N := RInt_le (W J') (fun _ => 2.01 * h) A A' L I (ex_RInt_const A A' (2.01 * h))
    (fun a Ha => proj2 (K a Ha))).
  rewrite RInt_const in M, N. unfold scal in M, N; simpl in M, N; unfold mult in M, N; simpl in M, N.
  assert ((A' - A) * (2.01 * h) <= 0.00004 * (2.01 * h)) by (apply Rmult_le_compat_r; lra). lra.
Qed.

Theorem clock_falls : exists e, -0.0005 <= e <= 0.0005 /\
  clock_integral J x - clock_integral J' x = - (h * (loss_integral x + e)).
Proof.
  assert (P := pi_digits). destruct (end_near J HJ) as [_ [E1 E2]]. fold A in E1, E2.
  assert (H0 : 0 <= h) by (unfold h; lra).
  destruct (end_near J' HJ') as [_ [E1' E2']]. fold A' in E1', E2'. destruct tail_small as [_ T].
  assert (C : RInt (W J') x A + RInt (W J') A A' = RInt (W J') x A')
    by (apply (RInt_Chasles (W J') x A A'); apply W_between; lra).
  change (clock_integral J x) with (RInt (W J) x A). change (clock_integral J' x) with (RInt (W J') x A').
  assert (M : is_RInt (fun a => W J a - W J' a) x A (RInt (W J) x A - RInt (W J') x A)).
  { apply (is_RInt_minus (W J) (W J')); apply (RInt_correct (V := R_CompleteNormedModule)), W_between; lra. }
  assert (L : forall k, is_RInt (fun a => - h * (loss a + k)) x A (- h * (RInt loss x A + (A - x) * k))).
  { intros k. apply (is_RInt_scal (fun a => loss a + k)). apply (is_RInt_plus loss (fun _ => k)).
    - apply (RInt_correct (V := R_CompleteNormedModule)), loss_between; lra. - apply (is_RInt_const x A k). }
  assert (B1 := is_RInt_le _ _ x A _ _ ltac:(lra) (L 0.000125) M (fun a Ha => proj1 (W_falls a ltac:(lra)))).
  assert (B2 := is_RInt_le _ _ x A _ _ ltac:(lra) M (L (-0.000125)) ltac:(intros a Ha; destruct (W_falls a); lra)).
  assert (Q := loss_from x A Hx ltac:(lra)).
  set (D := RInt (W J) x A - RInt (W J') x A') in *. set (R := RInt loss x A) in *.
  assert (G : (A - x) * 0.000125 <= 0.00014) by lra.
  assert (K1 : h * (R + (A - x) * 0.000125) <= h * (loss_integral x + 0.0004)) by (apply Rmult_le_compat_l; lra).
  assert (K2 : h * (loss_integral x - 0.0004) <= h * (R + (A - x) * -0.000125)) by (apply Rmult_le_compat_l; lra).
  assert (F : - (h * (loss_integral x + 0.0005)) <= D <= - (h * (loss_integral x - 0.0005))) by (unfold D; lra).
  destruct (Req_dec h 0) as [Z|Z].
  - exists 0. rewrite Z in *. split; lra.
  - exists (- (D / h) - loss_integral x). split; [|field; exact Z].
    assert (h * (D / h) = D) by (field; exact Z). split; apply Rmult_le_reg_l with h; lra.
Qed.
End Fall.
