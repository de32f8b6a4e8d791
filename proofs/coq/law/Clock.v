(** The clock (L45 of law.md): T = S(J, al)/(2 eps), regular at al = 0; for al > 0 also tau(u, J)/(2 eps).

    G, tau                  == as in law.md
    radicand                == F^2 - J^2 > 0, for 0 < J < F
    G_continuous, tau_integrable == so G and the integrand of tau are regular
    L45a_clock              == S(J, al) = tau(u, J)
    tau_mono                == L45 (b): tau increases with u and J
    L45c_below, L45c_u      == L45 (c): u <= 4.6724 sqrt (eps T)
    L45d_above, L45d_below  == L45 (d): the clock at u = 0.9042 and u = 0.897 *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Dumbbell Require Import LawStatement Sines.
Local Open Scope R_scope.

Definition G (F J : R) := J / (F * sqrt (F * F - J * J)).
Definition tau (u J : R) : R := RInt (fun x => sin x * G (PI - x) J) 0 u.

Lemma radicand F J : 0 < J < F -> 0 < F * F - J * J /\ 0 < sqrt (F * F - J * J).
Proof.
  intros H. assert (0 < F * F - J * J) by (assert (J * J < F * F) by (apply Rmult_le_0_lt_compat; lra); lra).
  split; [assumption | now apply sqrt_lt_R0].
Qed.
Lemma G_pos F J : 0 < J < F -> 0 < G F J.
Proof. intros H. destruct (radicand F J H). apply Rdiv_lt_0_compat; [|apply Rmult_lt_0_compat]; lra. Qed.
Lemma G_mono F J J' : 0 < J -> J <= J' < F -> G F J <= G F J'.
Proof.
  intros H0 H. destruct (radicand F J ltac:(lra)) as [A1 A2]. destruct (radicand F J' ltac:(lra)) as [B1 B2].
  unfold G, Rdiv.
  assert (J * J <= J' * J') by (apply Rmult_le_compat; lra).
  assert (S : sqrt (F * F - J' * J') <= sqrt (F * F - J * J)) by (apply sqrt_le_1_alt; lra).
  assert (F * sqrt (F * F - J' * J') <= F * sqrt (F * F - J * J)) by (apply Rmult_le_compat_l; lra).
  assert (0 < F * sqrt (F * F - J' * J')) by (apply Rmult_lt_0_compat; lra).
  apply Rmult_le_compat; try lra; [left; apply Rinv_0_lt_compat; lra | apply Rinv_le_contravar; lra].
Qed.
Lemma ratio_bounds J x u : 0 < J < PI - u -> 0 <= x <= u -> 0 < J / (PI - x) < 1.
Proof.
  intros HJ Hx. split; [apply Rdiv_lt_0_compat; lra|]. apply Rmult_lt_reg_r with (PI - x); [lra|].
  unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
Qed.
Lemma angle_derivative J x u : 0 < J < PI - u -> 0 <= x <= u ->
  is_derive (fun x => acos (J / (PI - x))) x (- G (PI - x) J).
Proof.
  intros HJ Hx. assert (B := ratio_bounds J x u HJ Hx). set (y := J / (PI - x)) in *.
  assert (D : is_derive (fun x => J / (PI - x)) x (J / ((PI - x) * (PI - x)))) by (auto_derive; [lra | field; lra]).
  assert (A : is_derive acos y (- 1 / sqrt (1 - Rsqr y))) by (apply is_derive_Reals;
    exact (derive_pt_eq_1 _ _ _ (derivable_pt_acos y ltac:(lra)) (derive_pt_acos y ltac:(lra)))).
  assert (C := is_derive_comp acos (fun x => J / (PI - x)) x _ _ A D).
  replace (- G (PI - x) J) with (scal (J / ((PI - x) * (PI - x))) (- 1 / sqrt (1 - Rsqr y))); [exact C|].
  unfold scal; simpl; unfold mult; simpl. unfold G. destruct (radicand (PI - x) J ltac:(lra)) as [P Q].
  assert (E : sqrt (1 - Rsqr y) = sqrt ((PI - x) * (PI - x) - J * J) / (PI - x)).
  { replace (1 - Rsqr y) with (((PI - x) * (PI - x) - J * J) / ((PI - x) * (PI - x))) by (unfold y, Rsqr; field; lra).
    rewrite sqrt_div_alt by (apply Rmult_lt_0_compat; lra). now rewrite sqrt_square by lra. }
  rewrite E. field. lra.
Qed.
Lemma G_continuous J x u : 0 < J < PI - u -> 0 <= x <= u -> continuous (fun x => G (PI - x) J) x.
Proof.
  intros HJ Hx. destruct (radicand (PI - x) J ltac:(lra)) as [P Q].
  apply (ex_derive_continuous (fun x => G (PI - x) J)). unfold G. auto_derive.
  replace ((PI + - x) * (PI + - x) + - (J * J)) with ((PI - x) * (PI - x) - J * J) by ring.
  repeat split; try lra. apply Rmult_integral_contrapositive; split; lra.
Qed.
Lemma tau_integrable J u v w : 0 < J < PI - w -> 0 <= u -> u <= v <= w -> ex_RInt (fun x => sin x * G (PI - x) J) u v.
Proof.
  intros HJ Hu Hv. apply (ex_RInt_continuous (V := R_CompleteNormedModule)). rewrite Rmin_left, Rmax_right by lra.
  intros x Hx. apply (continuous_mult sin (fun x => G (PI - x) J));
    [apply continuous_sin | apply (G_continuous J x w); lra].
Qed.

Theorem L45a_clock u al : 0 <= u -> 0 < al < PI/2 -> u < PI ->
  clock_integral (invariant u al) al = tau u (invariant u al).
Proof.
  intros Hu Ha Hpi. set (J := invariant u al). assert (C0 : 0 < cos al < 1).
  { split; [apply cos_gt_0; lra|]. rewrite <- cos_0. apply cos_decreasing_1; lra. }
  assert (HJ : 0 < J < PI - u).
  { unfold J, invariant. split; [apply Rmult_lt_0_compat; lra|].
    assert ((PI - u) * cos al < (PI - u) * 1) by (apply Rmult_lt_compat_l; lra). lra. }
  assert (Eal : acos (J / (PI - u)) = al).
  { replace (J / (PI - u)) with (cos al) by (unfold J, invariant; field; lra). apply acos_cos. lra. }
  set (g := fun x => acos (J / (PI - x))). set (f := fun a => sin (J / cos a)).
  assert (C := RInt_comp f g (fun x => - G (PI - x) J) 0 u). rewrite Rmin_left, Rmax_right in C by exact Hu.
  unfold tau, clock_integral. replace (acos (J / PI)) with (g 0) by (unfold g; now rewrite Rminus_0_r).
  replace al with (g u) at 1 by exact Eal. fold f. symmetry. rewrite <- (opp_RInt_swap f (g 0) (g u)).
  - rewrite <- C.
    + rewrite <- RInt_opp.
      * apply RInt_ext. rewrite Rmin_left, Rmax_right by exact Hu. intros x Hx. unfold opp, scal; simpl.
        unfold mult; simpl.
        assert (B := ratio_bounds J x u HJ ltac:(lra)). unfold f, g. rewrite cos_acos by lra.
        replace (J / (J / (PI - x))) with (PI - x) by (field; lra). rewrite <- sin_PI_x. ring.
      * apply (ex_RInt_continuous (V := R_CompleteNormedModule)). rewrite Rmin_left, Rmax_right by exact Hu.
        intros x Hx.
        assert (B := ratio_bounds J x u HJ Hx).
        apply continuous_mult; [apply (continuous_opp (fun x => G (PI - x) J)); now apply (G_continuous J x u)|].
        assert (Cg : continuous g x) by (apply (ex_derive_continuous g x); eexists;
          now apply (angle_derivative J x u)).
        assert (Cf : continuous f (g x)) by (apply (ex_derive_continuous f (g x)); unfold f, g; auto_derive;
          rewrite cos_acos by lra; lra).
        exact (continuous_comp g f x Cg Cf).
    + intros x Hx. assert (B := ratio_bounds J x u HJ Hx). apply (ex_derive_continuous f (g x)). unfold f, g.
      auto_derive.
      rewrite cos_acos by lra. lra.
    + intros x Hx. split; [now apply (angle_derivative J x u) | apply (continuous_opp (fun x => G (PI - x) J));
        now apply (G_continuous J x u)].
  - assert (Q : forall x, 0 <= x <= u -> 0 < g x < PI/2).
    { intros x Hx. assert (B := ratio_bounds J x u HJ Hx). unfold g.
      destruct (acos_bound_lt (J / (PI - x)) ltac:(lra)).
      split; [assumption|]. apply Rnot_le_lt. intros K. assert (E := cos_acos (J / (PI - x)) ltac:(lra)).
      assert (cos (acos (J / (PI - x))) <= 0) by (apply cos_le_0; lra). lra. }
    assert (Q0 := Q 0 ltac:(lra)). assert (Q1 := Q u ltac:(lra)).
    apply (ex_RInt_continuous (V := R_CompleteNormedModule)). intros a A. apply (ex_derive_continuous f a). unfold f.
    auto_derive.
    assert (0 < cos a); [|lra]. apply cos_gt_0; destruct A as [A1 A2].
    + assert (0 < Rmin (g 0) (g u)) by (apply Rmin_glb_lt; lra). lra.
    + assert (Rmax (g 0) (g u) < PI/2) by (apply Rmax_lub_lt; lra). lra.
Qed.

(** L45 (b). *)
Theorem tau_mono u v J J' : 0 <= u <= v -> 0 < J -> J <= J' < PI - v -> tau u J <= tau v J'.
Proof.
  intros Hu HJ HJJ. apply Rle_trans with (tau u J').
  - apply RInt_le; [lra | now apply (tau_integrable J 0 u v); lra | now apply (tau_integrable J' 0 u v); lra |].
    intros x Hx. apply Rmult_le_compat_l; [apply sin_ge_0; lra | apply G_mono; lra].
  - unfold tau. rewrite <- (RInt_Chasles (fun x => sin x * G (PI - x) J') 0 u v).
    + assert (0 <= RInt (fun x => sin x * G (PI - x) J') u v); [|unfold plus; simpl; lra].
      apply RInt_ge_0; [lra | apply (tau_integrable J' u v v); lra |]. intros x Hx.
      apply Rmult_le_pos; [apply sin_ge_0; lra | left; apply G_pos; lra].
    + apply (tau_integrable J' 0 u v); lra.
    + apply (tau_integrable J' u v v); lra.
Qed.

(** L45 (c). *)
Lemma integrand_below x J : 0 <= x <= 0.91 -> 0 < J < PI - x -> x * G PI J <= sin x * G (PI - x) J.
Proof.
  intros Hx HJ. set (F := PI - x) in *. assert (P : 3.14 < PI < 3.15) by (split; interval).
  destruct (radicand F J HJ) as [A1 A2]. destruct (radicand PI J ltac:(unfold F in *; lra)) as [B1 B2].
  set (a := sqrt (F * F - J * J)) in *. set (b := sqrt (PI * PI - J * J)) in *.
  assert (H : PI * a <= F * b).
  { rewrite <- (sqrt_square PI), <- (sqrt_square F) by (unfold F; lra). unfold a, b.
    rewrite <- !sqrt_mult_alt by apply Rle_0_sqr.
    apply sqrt_le_1_alt. assert (F * F <= PI * PI) by (apply Rmult_le_compat; unfold F in *; lra).
    assert (0 <= (PI * PI - F * F) * (J * J)) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]). lra. }
  assert (S : x * (F * F) <= sin x * (PI * PI)).
  { assert (L := sine_below x ltac:(lra)). assert (0 <= x * x) by (apply Rmult_le_pos; lra).
    assert (x * x <= 0.91 * x) by (apply Rmult_le_compat_r; lra).
    apply Rle_trans with ((x - x * x * x / 6) * (PI * PI)); [|apply Rmult_le_compat_r; [apply Rmult_le_pos|]; lra].
    replace ((x - x * x * x / 6) * (PI * PI)) with (x * ((1 - x * x / 6) * (PI * PI))) by field.
    apply Rmult_le_compat_l; [lra|]. unfold F.
    assert (PI * PI <= 10) by interval. assert (x * x * (PI * PI) <= x * x * 10) by (apply Rmult_le_compat_l; lra).
    assert (x * 3.14 <= x * PI) by (apply Rmult_le_compat_l; lra). lra. }
  unfold G. fold a b. assert (FP : 0 < F) by (unfold F; lra).
  assert (FF : 0 < F * F) by (now apply Rmult_lt_0_compat).
  assert (PB : 0 < PI * b) by (apply Rmult_lt_0_compat; lra).
  apply Rmult_le_reg_r with (PI * b * (F * F) * a); [apply Rmult_lt_0_compat;
    [now apply Rmult_lt_0_compat | exact A2]|].
  replace (x * (J / (PI * b)) * (PI * b * (F * F) * a)) with (x * (F * F) * (J * a)) by (field; lra).
  replace (sin x * (J / (F * a)) * (PI * b * (F * F) * a)) with (sin x * PI * (J * (F * b))) by (field; lra).
  assert (S0 : 0 <= sin x) by (apply sin_ge_0; unfold F in *; lra).
  apply Rle_trans with (sin x * (PI * PI) * (J * a)); [apply Rmult_le_compat_r; [apply Rmult_le_pos; lra | exact S]|].
  replace (sin x * (PI * PI) * (J * a)) with (sin x * PI * (J * (PI * a))) by ring.
  apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | apply Rmult_le_compat_l; lra].
Qed.
Theorem L45c_below u J : 0 <= u <= 0.91 -> 0 < J < PI - u -> G PI J * (u * u / 2) <= tau u J.
Proof.
  intros Hu HJ. assert (I : is_RInt (fun x => x * G PI J) 0 u (G PI J * (u * u / 2))).
  { replace (G PI J * (u * u / 2)) with (minus (G PI J * (u * u / 2)) (G PI J * (0 * 0 / 2)))
      by (unfold minus, plus, opp; simpl; field).
    apply (is_RInt_derive (fun x => G PI J * (x * x / 2)) (fun x => x * G PI J)).
    - intros x _. auto_derive; [easy | field].
    - intros x _. apply (ex_derive_continuous (fun x => x * G PI J)). auto_derive. easy. }
  rewrite <- (is_RInt_unique _ _ _ _ I).
  apply RInt_le; [lra | eexists; exact I | apply (tau_integrable J 0 u u); lra|].
  intros x Hx. apply integrand_below; lra.
Qed.
Theorem L45c_u u J t : 0 <= u <= 0.91 -> PI/2 - 0.002 <= J < PI - u -> tau u J = 2 * t -> u <= 4.6724 * sqrt t.
Proof.
  intros Hu HJ Et. assert (P : 3.14 < PI < 3.15) by (split; interval). assert (L := L45c_below u J Hu ltac:(lra)).
  rewrite Et in L.
  assert (M := G_mono PI (PI/2 - 0.002) J ltac:(lra) ltac:(lra)).
  assert (V : 4 / (4.6724 * 4.6724) <= G PI (PI/2 - 0.002)) by (unfold G; interval).
  assert (U2 : 0 <= u * u) by (apply Rmult_le_pos; lra).
  assert (K : 4 / (4.6724 * 4.6724) * (u * u / 2) <= G PI J * (u * u / 2)) by (apply Rmult_le_compat_r; lra).
  assert (T0 : 0 <= t) by lra. assert (S := sqrt_pos t). assert (Q := sqrt_sqrt t T0).
  apply Rsqr_incr_0_var; [unfold Rsqr | lra].
  replace (4.6724 * sqrt t * (4.6724 * sqrt t)) with (4.6724 * 4.6724 * (sqrt t * sqrt t)) by ring. lra.
Qed.

(** L45 (d). *)
Lemma clock_values : tau 0.9042 (PI/2 + 3/10000000) <= 0.1225 /\ 0.1190 <= tau 0.897 (PI/2 - 0.002).
Proof. unfold tau, G. split; integral. Qed.
Theorem L45d_above u J : 0 <= u <= 0.9042 -> 0 < J <= PI/2 + 3/10000000 -> tau u J <= 0.1225.
Proof.
  intros Hu HJ. assert (P : 3.14 < PI < 3.15) by (split; interval). destruct clock_values as [A _].
  apply Rle_trans with (2 := A). apply tau_mono; lra.
Qed.
Theorem L45d_below u J : 0.897 <= u -> PI/2 - 0.002 <= J < PI - u -> 0.1190 <= tau u J.
Proof.
  intros Hu HJ. assert (P : 3.14 < PI < 3.15) by (split; interval). destruct clock_values as [_ A].
  apply Rle_trans with (1 := A). apply tau_mono; lra.
Qed.
