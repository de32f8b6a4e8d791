(** C as a series that converges like that of the sine (beside L46 of law.md). Its terms are integrals of odd powers of
    the secant up to pi/3, where the secant is 2 and the tangent sqrt 3: numbers that come from ln(2 + sqrt 3) by a
    recursion. As the sine is between two partial sums, so is C.

    secants, sine_term == the integral of the power 2 n + 1 of the secant from 0 to pi/3; a term of the sine of pi/2
    growth_sum         == a partial sum of the series
    growth_between     == C is between two of them *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import LawStatement.
Local Open Scope R_scope.

(** An integral of the power 2 n + 1 of the secant. *)
Fixpoint primitive (n : nat) (a : R) : R :=
  match n with
  | O => ln (/ cos a + tan a)
  | S m => (/ cos a ^ (2 * m + 1) * tan a + INR (2 * m + 1) * primitive m a) / INR (2 * m + 2)
  end.
Fixpoint secants (n : nat) : R :=
  match n with
  | O => ln (2 + sqrt 3)
  | S m => (2 * 4 ^ m * sqrt 3 + INR (2 * m + 1) * secants m) / INR (2 * m + 2)
  end.
Definition sine_term (n : nat) : R := (-1) ^ n * ((PI / 2) ^ (2 * n + 1) / INR (fact (2 * n + 1))).
Definition growth_sum (n : nat) : R := sum_f_R0 (fun i => sine_term i * secants i) n.

Lemma below_third a : 0 <= a <= PI / 3 -> / 2 <= cos a <= 1 /\ 0 <= sin a.
Proof.
  intros Ha. assert (P := PI_RGT_0). split; [split|].
  - replace (/ 2) with (cos (PI / 3)) by (rewrite cos_PI3; field). apply cos_decr_1; lra.
  - apply COS_bound.
  - apply sin_ge_0; lra.
Qed.

Lemma primitive_derives n : forall a, 0 <= a <= PI / 3 -> is_derive (primitive n) a (/ cos a ^ (2 * n + 1)).
Proof.
  induction n as [|n IH]; intros a Ha; destruct (below_third a Ha) as [[C0 C1] S0];
    assert (I : 1 <= / cos a) by (rewrite <- Rinv_1; apply Rinv_le_contravar; lra);
    assert (SC := sin2_cos2 a); unfold Rsqr in SC.
  - simpl. unfold tan. auto_derive.
    + split; [lra|]. split; [lra|]. split; [|easy]. assert (0 <= sin a * / cos a) by (apply Rmult_le_pos; lra). lra.
    + field_simplify_eq; [|split; [lra|]]; nra.
  - cbn [primitive]. set (k := (2 * n + 1)%nat).
    assert (K : 0 < INR (2 * n + 2)) by (apply lt_0_INR; lia).
    assert (T : is_derive (fun a => / cos a ^ k * tan a) a
      (INR (2 * n + 2) * / cos a ^ (2 * S n + 1) - INR k * / cos a ^ k)).
    { unfold tan. assert (Z : cos a ^ k <> 0) by (apply pow_nonzero; lra).
    auto_derive; [repeat split; first [exact Z | lra | exact I]|].
      replace (2 * S n + 1)%nat with (S (S k)) by (unfold k; lia).
      replace (2 * n + 2)%nat with (S k) by (unfold k; lia).
      replace k with (S (pred k)) in Z |- * by (unfold k; lia). set (j := pred k) in *. cbn [pred].
      rewrite !S_INR. cbn [pow] in Z |- *. assert (Z1 : cos a ^ j <> 0) by (intros E; apply Z; rewrite E; ring).
      assert (E : sin a * sin a = 1 - cos a * cos a) by lra.
      field_simplify_eq; [|repeat split; first [exact Z1 | lra]].
      replace (sin a ^ 2) with (1 - cos a * cos a) by (simpl; lra). ring. }
    assert (D := IH a Ha). fold k in D.
    evar_last.
    + apply (is_derive_ext (fun a => / INR (2 * n + 2) * (/ cos a ^ k * tan a + INR k * primitive n a))).
      { intros t. match goal with |- @eq _ ?x ?y => change (@eq R x y) end. unfold Rdiv. ring. }
      apply is_derive_scal. apply (is_derive_plus (V := R_NormedModule)); [exact T|].
      apply (is_derive_scal (primitive n)). exact D.
    + change (/ INR (2 * n + 2) * ((INR (2 * n + 2) * / cos a ^ (2 * S n + 1) - INR k * / cos a ^ k) +
        INR k * / cos a ^ k) = / cos a ^ (2 * S n + 1)).
      generalize (/ cos a ^ (2 * S n + 1)) (INR k * / cos a ^ k). intros X Y. field. lra.
Qed.

Lemma primitive_0 n : primitive n 0 = 0.
Proof.
  induction n as [|n IH]; cbn [primitive]; rewrite ?IH, cos_0, tan_0; [replace (/ 1 + 0) with 1 by field; apply ln_1|].
  unfold Rdiv. ring.
Qed.
Lemma primitive_third n : primitive n (PI / 3) = secants n.
Proof.
  induction n as [|n IH]; cbn [primitive secants]; rewrite ?IH, cos_PI3, tan_PI3.
  - do 2 f_equal. field.
  - replace (/ (1 / 2) ^ (2 * n + 1)) with (2 * 4 ^ n); [reflexivity|].
    rewrite pow_add, pow_mult. replace ((1 / 2) ^ 2) with (/ 4) by field. rewrite pow_inv.
    field. apply pow_nonzero. lra.
Qed.
Lemma secants_integral n : is_RInt (fun a => / cos a ^ (2 * n + 1)) 0 (PI / 3) (secants n).
Proof.
  assert (P := PI_RGT_0). rewrite <- (primitive_third n). replace (primitive n (PI / 3)) with
    (minus (primitive n (PI / 3)) (primitive n 0)) by (rewrite primitive_0; unfold minus, plus, opp; simpl; ring).
  apply (is_RInt_derive (V := R_CompleteNormedModule)); intros a; rewrite Rmin_left, Rmax_right by lra; intros Ha.
  - now apply primitive_derives.
  - destruct (below_third a Ha). apply (ex_derive_continuous (fun a => / cos a ^ (2 * n + 1))).
    auto_derive. apply pow_nonzero. lra.
Qed.

(** The partial sum of the sine of (pi/2)/cos a, and its integral. *)
Lemma sum_integral n : is_RInt (fun a => sin_approx (PI / 2 / cos a) n) 0 (PI / 3) (growth_sum n).
Proof.
  assert (P := PI_RGT_0).
  assert (One : forall i, is_RInt (fun a => sin_term (PI / 2 / cos a) i) 0 (PI / 3) (sine_term i * secants i)).
  { intros i. apply (is_RInt_ext (fun a => scal (sine_term i) (/ cos a ^ (2 * i + 1)))).
    - intros a. rewrite Rmin_left, Rmax_right by lra. intros Ha. destruct (below_third a ltac:(lra)) as [[C0 _] _].
      set (k := (2 * i + 1)%nat).
      change ((-1) ^ i * ((PI / 2) ^ k / INR (fact k)) * / cos a ^ k = (-1) ^ i * ((PI / 2 * / cos a) ^ k / INR (fact
        k))).
      rewrite Rpow_mult_distr, pow_inv. unfold Rdiv. ring.
    - apply (is_RInt_scal (V := R_NormedModule)). apply secants_integral. }
  induction n as [|n IH]; unfold sin_approx, growth_sum; cbn [sum_f_R0]; [apply One|].
  apply (is_RInt_plus (V := R_NormedModule)); [exact IH | apply One].
Qed.

Theorem growth_between n : growth_sum (2 * n + 1) <= growth <= growth_sum (2 * (n + 1)).
Proof.
  assert (P := PI_RGT_0).
  assert (B : forall a, 0 < a < PI / 3 -> sin_approx (PI / 2 / cos a) (2 * n + 1) <= sin (PI / 2 / cos a) <=
    sin_approx (PI / 2 / cos a) (2 * (n + 1))).
  { intros a Ha. destruct (below_third a ltac:(lra)) as [[C0 C1] _].
    assert (I : 1 <= / cos a <= 2).
    { split; [rewrite <- Rinv_1; apply Rinv_le_contravar; lra|]. replace 2 with (/ / 2) by field.
      apply Rinv_le_contravar; lra. }
    unfold Rdiv at 1 3 5. apply sin_bound.
    - apply Rmult_le_pos; lra.
    - apply Rle_trans with (PI * / 2 * 2); [apply Rmult_le_compat_l; lra | lra]. }
  assert (G : is_RInt (fun a => sin (PI / 2 / cos a)) 0 (PI / 3) growth).
  { unfold growth. apply (RInt_correct (V := R_CompleteNormedModule)).
    apply (ex_RInt_continuous (V := R_CompleteNormedModule)). rewrite Rmin_left, Rmax_right by lra.
    intros a Ha. destruct (below_third a Ha). apply (ex_derive_continuous (fun a => sin (PI / 2 / cos a))).
    auto_derive. lra. }
  assert (P0 : 0 <= PI / 3) by lra. split; eapply is_RInt_le; try exact P0.
  - apply sum_integral.
  - exact G.
  - intros a Ha. now apply B.
  - exact G.
  - apply sum_integral.
  - intros a Ha. now apply B.
Qed.
