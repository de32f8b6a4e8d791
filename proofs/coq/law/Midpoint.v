(** The first part of the defect of a step (L49 of law.md), the error of the midpoint rule, by Taylor's formula at each
    point, so that no derivative stands under an integral.

    root              == sqrt (F^2 - J^2)
    G1, G2, G3, G4    == the derivatives of G by F
    H, H2             == the derivatives of G by J (G_derive_J, H_derive_J)
    combine, negated  == derivatives of e (p - f) and of - f
    even, odd         == f (F + y) + f (F - y) and f (F - y) - f (F + y)
    moment_cos, moment_sin == the integrals of y^n cos y and of y^n sin y
    midpoint_error    == E1
    moments_between   == I2, I4, J1, J3
    midpoint_between  == E1 = m1 d^3, with bounds of G3 and G4 for G3* and G4* *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Sines Clock.
Local Open Scope R_scope.

Definition root F J := sqrt (F * F - J * J).   (* R^(1/2) of law.md *)
Definition G1 F J := - J * (/ (F^2 * root F J) + / root F J ^ 3).
Definition G2 F J := J * (2 / (F^3 * root F J) + / (F * root F J ^ 3) + 3 * F / root F J ^ 5).
Definition G3 F J := - J * (6 / (F^4 * root F J) + 3 / (F^2 * root F J ^ 3) + 15 * F^2 / root F J ^ 7).
Definition G4 F J := J * (24 / (F^5 * root F J) + 12 / (F^3 * root F J ^ 3) + 9 / (F * root F J ^ 5) -
  30 * F / root F J ^ 7 + 105 * F^3 / root F J ^ 9).
Definition H F J := F / root F J ^ 3.
Definition H2 F J := 3 * J * F / root F J ^ 5.

Section Derivatives.
Variables F J : R.
Hypothesis HF : 0 < J < F.
Ltac by_rules :=
  let A := fresh in let B := fresh in destruct (radicand F J HF) as [A B]; auto_derive;
  [ replace (F * F + - (J * J)) with (F * F - J * J) by ring; repeat split; try lra;
    repeat (apply Rmult_integral_contrapositive; split); try (apply pow_nonzero); lra
  | replace (F * F + - (J * J)) with (F * F - J * J) by ring; set (s := sqrt (F * F - J * J)) in *; field; lra ].
Lemma G_derive : is_derive (fun F => G F J) F (G1 F J).
Proof. unfold G, G1, root. by_rules. Qed.
Lemma G1_derive : is_derive (fun F => G1 F J) F (G2 F J).
Proof. unfold G1, G2, root. by_rules. Qed.
Lemma G2_derive : is_derive (fun F => G2 F J) F (G3 F J).
Proof. unfold G2, G3, root. by_rules. Qed.
Lemma G3_derive : is_derive (fun F => G3 F J) F (G4 F J).
Proof. unfold G3, G4, root. by_rules. Qed.
Lemma G_derive_J : is_derive (fun J => G F J) J (H F J).
Proof.
  replace (H F J) with (/ (F * root F J) + J * J / (F * root F J ^ 3)); [unfold G, root; by_rules|]. unfold H, root.
  destruct (radicand F J HF) as [A B]. set (s := sqrt (F * F - J * J)) in *.
  replace (J * J) with (F * F - s * s) by (unfold s; rewrite sqrt_sqrt; lra). field. lra.
Qed.
Lemma H_derive_J : is_derive (fun J => H F J) J (H2 F J).
Proof. unfold H, H2, root. by_rules. Qed.
End Derivatives.

Section Taylor.
Variables F Q d : R.
Hypothesis HQ : 0 < Q < F - d.
Hypothesis Hd : 0 <= d.
Lemma plus_derive f f' t : (forall F J, 0 < J < F -> is_derive (fun F => f F J) F (f' F J)) -> 0 <= t <= d ->
  is_derive (fun y => f (F + y) Q) t (f' (F + t) Q) /\ is_derive (fun y => f (F - y) Q) t (- f' (F - t) Q).
Proof.
  intros D Ht. split.
  - replace (f' (F + t) Q) with (scal 1 (f' (F + t) Q)) by (unfold scal; simpl; unfold mult; simpl; ring).
    apply (is_derive_comp (fun F => f F Q) (fun y => F + y)); [apply D; lra | auto_derive; [easy | ring]].
  - replace (- f' (F - t) Q) with (scal (-1) (f' (F - t) Q)) by (unfold scal; simpl; unfold mult; simpl; ring).
    apply (is_derive_comp (fun F => f F Q) (fun y => F - y)); [apply D; lra | auto_derive; [easy | ring]].
Qed.
Definition even (f : R -> R -> R) y := f (F + y) Q + f (F - y) Q.
Definition odd (f : R -> R -> R) y := f (F - y) Q - f (F + y) Q.
Lemma even_derive f f' t : (forall F J, 0 < J < F -> is_derive (fun F => f F J) F (f' F J)) -> 0 <= t <= d ->
  is_derive (even f) t (- odd f' t) /\ is_derive (odd f) t (- even f' t).
Proof.
  intros D Ht. destruct (plus_derive f f' t D Ht) as [A B]. split.
  - replace (- odd f' t) with (plus (f' (F + t) Q) (- f' (F - t) Q)) by (unfold odd, plus; simpl; ring).
    exact (is_derive_plus _ _ _ _ _ A B).
  - replace (- even f' t) with (minus (- f' (F - t) Q) (f' (F + t) Q))
      by (unfold even, minus, plus, opp; simpl; ring).
    exact (is_derive_minus _ _ _ _ _ B A).
Qed.

Lemma combine (p f : R -> R) p' f' e t : is_derive p t p' -> is_derive f t f' ->
  is_derive (fun y => e * (p y - f y)) t (e * (p' - f')).
Proof. intros A B. exact (is_derive_scal _ _ e _ (is_derive_minus _ _ _ _ _ A B)). Qed.
Lemma negated (f : R -> R) f' t : is_derive f t (- f') -> is_derive (fun y => - f y) t f'.
Proof. intros A. replace f' with (- - f') by ring. exact (is_derive_opp _ _ _ A). Qed.

(** e is 1 or -1: a bound of the last derivative gives one of the function. *)
Theorem even_bound e c : (forall y, 0 <= y <= d -> 0 <= e * (2 * c - even G4 y)) -> forall y, 0 <= y <= d ->
  0 <= e * (2 * G F Q + G2 F Q * y^2 + c * y^4 / 12 - even G y).
Proof.
  intros H4.
  assert (H3 : forall y, 0 <= y <= d -> 0 <= e * (2 * c * y - - odd G3 y)).
  { apply (grows _ (fun y => e * (2 * c - even G4 y))); [|exact H4 | unfold odd; rewrite Rplus_0_r, Rminus_0_r; ring].
    intros y Hy. apply combine; [auto_derive; [easy | ring] | apply negated;
      now apply (even_derive G3 G4 y G3_derive)]. }
  assert (H2' : forall y, 0 <= y <= d -> 0 <= e * (2 * G2 F Q + c * y^2 - even G2 y)).
  { apply (grows _ (fun y => e * (2 * c * y - - odd G3 y))); [|exact H3 | unfold even; rewrite Rplus_0_r, Rminus_0_r;
      ring].
    intros y Hy. apply combine; [auto_derive; [easy | ring] | now apply (even_derive G2 G3 y G2_derive)]. }
  assert (H1 : forall y, 0 <= y <= d -> 0 <= e * (2 * G2 F Q * y + c * y^3 / 3 - - odd G1 y)).
  { apply (grows _ (fun y => e * (2 * G2 F Q + c * y^2 - even G2 y))); [|exact H2' | unfold odd;
      rewrite Rplus_0_r, Rminus_0_r; field].
    intros y Hy. apply combine; [auto_derive; [easy | field] | apply negated;
      now apply (even_derive G1 G2 y G1_derive)]. }
  apply (grows _ (fun y => e * (2 * G2 F Q * y + c * y^3 / 3 - - odd G1 y))); [|exact H1 | unfold even;
    rewrite Rplus_0_r, Rminus_0_r; field].
  intros y Hy. apply combine; [auto_derive; [easy | field] | now apply (even_derive G G1 y G_derive)].
Qed.
Theorem odd_bound e c : (forall y, 0 <= y <= d -> 0 <= e * (2 * c - even G3 y)) -> forall y, 0 <= y <= d ->
  0 <= e * (2 * G1 F Q * y + c * y^3 / 3 - - odd G y).
Proof.
  intros H3.
  assert (H2' : forall y, 0 <= y <= d -> 0 <= e * (2 * c * y - - odd G2 y)).
  { apply (grows _ (fun y => e * (2 * c - even G3 y))); [|exact H3 | unfold odd; rewrite Rplus_0_r, Rminus_0_r; ring].
    intros y Hy. apply combine; [auto_derive; [easy | ring] | apply negated;
      now apply (even_derive G2 G3 y G2_derive)]. }
  assert (H1 : forall y, 0 <= y <= d -> 0 <= e * (2 * G1 F Q + c * y^2 - even G1 y)).
  { apply (grows _ (fun y => e * (2 * c * y - - odd G2 y))); [|exact H2' | unfold even; rewrite Rplus_0_r, Rminus_0_r;
      ring].
    intros y Hy. apply combine; [auto_derive; [easy | ring] | now apply (even_derive G1 G2 y G1_derive)]. }
  apply (grows _ (fun y => e * (2 * G1 F Q + c * y^2 - even G1 y))); [|exact H1 | unfold odd;
    rewrite Rplus_0_r, Rminus_0_r; field].
  intros y Hy. apply combine; [auto_derive; [easy | field] | apply negated; now apply (even_derive G G1 y G_derive)].
Qed.
End Taylor.

(** E1: the two halves of the step taken together. *)
Definition moment_cos d n : R := RInt (fun y => y^n * cos y) 0 d.   (* I2, I4 d^-3 of law.md, with n = 2, 4 *)
Definition moment_sin d n : R := RInt (fun y => y^n * sin y) 0 d.   (* J1, J3 d^-3 of law.md, with n = 1, 3 *)
Definition midpoint_error U d Q : R := RInt (fun x => sin x * (G (PI - x) Q - G (PI - U) Q)) (U - d) (U + d).

(** The moments, as in law.md: I2, I4, J1, J3 times d^3. *)
Ltac weigh Q B k :=   (* y^k times the bounds B of sine and cosine *)
  let y := fresh "y" in let X := fresh "X" in intros y ?; assert (X := Q y k ltac:(lra));
  destruct (B y ltac:(lra)) as [[Y1 Y2] [Y3 Y4]]; assert (Z1 := Rmult_le_compat_l _ _ _ X Y1);
  assert (Z2 := Rmult_le_compat_l _ _ _ X Y2); assert (Z3 := Rmult_le_compat_l _ _ _ X Y3);
  assert (Z4 := Rmult_le_compat_l _ _ _ X Y4); simpl in *; lra.
Theorem moments_between d : 0 <= d <= PI/2 ->
  d^3 / 3 * (1 - 0.3 * d^2) <= moment_cos d 2 <= d^3 / 3 /\ d^5 / 5 * (1 - d^2 / 2) <= moment_cos d 4 <= d^5 / 5 /\
  d^3 / 3 * (1 - d^2 / 10) <= moment_sin d 1 <= d^3 / 3 /\ d^5 / 5 * (1 - d^2 / 6) <= moment_sin d 3 <= d^5 / 5.
Proof.
  intros Hd.
  assert (P : forall a n b m, is_RInt (fun y => a * y^n - b * y^m) 0 d (a * (d^(S n) / INR (S n)) - b * (d^(S m) / INR
    (S m)))).
  { intros a n b m. replace (a * (d^(S n) / INR (S n)) - b * (d^(S m) / INR (S m))) with
      (minus (a * (d^(S n) / INR (S n)) - b * (d^(S m) / INR (S m))) (a * (0^(S n) / INR (S n)) - b * (0^(S m) / INR
        (S m)))).
    - apply (is_RInt_derive (fun y => a * (y^(S n) / INR (S n)) - b * (y^(S m) / INR (S m))) (fun y => a * y^n - b *
        y^m)).
      + intros y _. auto_derive; [easy|]. assert (INR (S n) <> 0) by (now apply not_0_INR).
        assert (INR (S m) <> 0) by (now apply not_0_INR).
        change (Nat.pred (S n)) with n. change (Nat.pred (S m)) with m. field. now split.
      + intros y _. apply (ex_derive_continuous (fun y => a * y^n - b * y^m)). auto_derive. easy.
    - unfold minus, plus, opp; simpl. rewrite !Rmult_0_l. unfold Rdiv. ring. }
  assert (C : forall n, is_RInt (fun y => y^n * cos y) 0 d (moment_cos d n)).
  { intros n. apply (RInt_correct (V := R_CompleteNormedModule)).
    apply (ex_RInt_continuous (V := R_CompleteNormedModule)).
    intros y _. apply (ex_derive_continuous (fun y => y^n * cos y)). auto_derive. easy. }
  assert (S : forall n, is_RInt (fun y => y^n * sin y) 0 d (moment_sin d n)).
  { intros n. apply (RInt_correct (V := R_CompleteNormedModule)).
    apply (ex_RInt_continuous (V := R_CompleteNormedModule)).
    intros y _. apply (ex_derive_continuous (fun y => y^n * sin y)). auto_derive. easy. }
  assert (Q : forall y n, 0 <= y -> 0 <= y^n) by (intros; now apply pow_le).
  assert (B : forall y, 0 <= y -> 1 - y * y / 2 <= cos y <= 1 /\ y - y * y * y / 6 <= sin y <= y).
  { intros y Hy. split; [split; [now apply cosine_below | apply COS_bound]|]. split; [now apply sine_below|].
    destruct Hy as [Hy|<-]; [left; now apply sin_lt_x | rewrite sin_0; lra]. }
  assert (L : forall p g a n b m, is_RInt g 0 d p -> (forall y, 0 < y < d -> a * y^n - b * y^m <= g y) ->
    a * (d^(Datatypes.S n) / INR (Datatypes.S n)) - b * (d^(Datatypes.S m) / INR (Datatypes.S m)) <= p)
    by (intros p g a n b m Hg Hle; exact (is_RInt_le _ _ 0 d _ _ (proj1 Hd) (P a n b m) Hg Hle)).
  assert (U : forall p g n, is_RInt g 0 d p -> (forall y, 0 < y < d -> g y <= 1 * y^n - 0 * y^n) ->
    p <= 1 * (d^(Datatypes.S n) / INR (Datatypes.S n)) - 0 * (d^(Datatypes.S n) / INR (Datatypes.S n)))
    by (intros p g n Hg Hle; exact (is_RInt_le _ _ 0 d _ _ (proj1 Hd) Hg (P 1 n 0 n) Hle)).
  assert (D7 : 0 <= d^7) by (apply Q; lra).
  repeat split.
  - assert (H := L _ _ 1 2%nat (1/2) 4%nat (C 2%nat) ltac:(weigh Q B 2%nat)). simpl in *. lra.
  - assert (H := U _ _ 2%nat (C 2%nat) ltac:(weigh Q B 2%nat)). simpl in *. lra.
  - assert (H := L _ _ 1 4%nat (1/2) 6%nat (C 4%nat) ltac:(weigh Q B 4%nat)). simpl in *. lra.
  - assert (H := U _ _ 4%nat (C 4%nat) ltac:(weigh Q B 4%nat)). simpl in *. lra.
  - assert (H := L _ _ 1 2%nat (1/6) 4%nat (S 1%nat) ltac:(weigh Q B 1%nat)). simpl in *. lra.
  - assert (H := U _ _ 2%nat (S 1%nat) ltac:(weigh Q B 1%nat)). simpl in *. lra.
  - assert (H := L _ _ 1 4%nat (1/6) 6%nat (S 3%nat) ltac:(weigh Q B 3%nat)). simpl in *. lra.
  - assert (H := U _ _ 4%nat (S 3%nat) ltac:(weigh Q B 3%nat)). simpl in *. lra.
Qed.

Section Midpoint.
Variables U d Q : R.
Hypothesis Hd : 0 < d <= U.
Hypothesis HU : U <= PI/2.
Hypothesis HQ : 0 < Q < PI - U - d.
Let F := PI - U.
Let f x := sin x * (G (PI - x) Q - G F Q).

Lemma f_continuous x : U - d <= x <= U + d -> continuous f x.
Proof.
  intros Hx. apply (continuous_mult sin (fun x => G (PI - x) Q - G F Q)); [apply continuous_sin|].
  apply (continuous_minus (fun x => G (PI - x) Q) (fun _ => G F Q)); [|apply continuous_const].
  apply (G_continuous Q x (U + d)); [lra|]. lra.
Qed.
Lemma f_integrable a b : U - d <= a -> a <= b <= U + d -> ex_RInt f a b.
Proof.
  intros Ha Hb. apply (ex_RInt_continuous (V := R_CompleteNormedModule)). rewrite Rmin_left, Rmax_right by lra.
  intros x Hx. apply f_continuous. lra.
Qed.
Lemma midpoint_halves : is_RInt (fun y => sin U * cos y * (even F Q G y - 2 * G F Q) + cos U * sin y * odd F Q G y) 0
  d
  (midpoint_error U d Q).
Proof.
  assert (A : is_RInt (fun y => f (U + y)) 0 d (RInt f U (U + d))).
  { apply (is_RInt_ext (fun y => scal 1 (f (1 * y + U)))).
    - intros y _. unfold scal; simpl; unfold mult; simpl. rewrite !Rmult_1_l. now rewrite Rplus_comm.
    - apply (is_RInt_comp_lin f 1 U 0 d). replace (1 * 0 + U) with U by ring.
      replace (1 * d + U) with (U + d) by ring.
      apply (RInt_correct (V := R_CompleteNormedModule)), f_integrable; lra. }
  assert (B : is_RInt (fun y => f (U - y)) 0 d (RInt f (U - d) U)).
  { assert (C : is_RInt (fun y => scal (-1) (f (-1 * y + U))) 0 d (opp (RInt f (U - d) U))).
    { apply (is_RInt_comp_lin f (-1) U 0 d). replace (-1 * 0 + U) with U by ring.
      replace (-1 * d + U) with (U - d) by ring.
      apply (is_RInt_swap (V := R_NormedModule)), (RInt_correct (V := R_CompleteNormedModule)), f_integrable; lra. }
    assert (D := is_RInt_opp (V := R_NormedModule) _ _ _ _ C). rewrite opp_opp in D.
    refine (is_RInt_ext _ _ _ _ _ _ D).
    intros y _. unfold opp, scal; simpl; unfold mult; simpl. replace (-1 * y + U) with (U - y) by ring. ring. }
  assert (E : midpoint_error U d Q = plus (RInt f U (U + d)) (RInt f (U - d) U)).
  { change (RInt f (U - d) (U + d) = plus (RInt f U (U + d)) (RInt f (U - d) U)).
    rewrite <- (RInt_Chasles f (U - d) U (U + d)) by (apply f_integrable; lra). unfold plus; simpl; ring. }
  rewrite E. apply (is_RInt_ext (fun y => plus (f (U + y)) (f (U - y))));
    [|now apply (is_RInt_plus (fun y => f (U + y)) (fun y => f (U - y)))].
  intros y _. unfold plus; simpl. unfold f, even, odd. replace (PI - (U + y)) with (F - y) by (unfold F; ring).
  replace (PI - (U - y)) with (F + y) by (unfold F; ring). rewrite sin_plus, sin_minus. ring.
Qed.

Lemma moments a2 a4 b1 b3 : is_RInt (fun y => sin U * cos y * (a2 * y^2 + a4 * y^4 / 12) + cos U * sin y * (- (2 * b1
  * y + b3 * y^3 / 3))) 0 d
  (sin U * (a2 * moment_cos d 2 + a4 * moment_cos d 4 / 12) - cos U * (2 * b1 * moment_sin d 1 + b3 * moment_sin d 3 /
    3)).
Proof.
  assert (C : forall n, is_RInt (fun y => y^n * cos y) 0 d (moment_cos d n)).
  { intros n. apply (RInt_correct (V := R_CompleteNormedModule)).
    apply (ex_RInt_continuous (V := R_CompleteNormedModule)). intros y _.
    apply (ex_derive_continuous (fun y => y^n * cos y)). auto_derive. easy. }
  assert (S : forall n, is_RInt (fun y => y^n * sin y) 0 d (moment_sin d n)).
  { intros n. apply (RInt_correct (V := R_CompleteNormedModule)).
    apply (ex_RInt_continuous (V := R_CompleteNormedModule)). intros y _.
    apply (ex_derive_continuous (fun y => y^n * sin y)). auto_derive. easy. }
  assert (X := is_RInt_plus _ _ _ _ _ _
    (is_RInt_plus _ _ _ _ _ _ (is_RInt_scal _ _ _ (sin U * a2) _ (C 2%nat)) (is_RInt_scal _ _ _ (sin U * a4 / 12) _ (C
      4%nat)))
    (is_RInt_plus _ _ _ _ _ _ (is_RInt_scal _ _ _ (- (cos U * 2 * b1)) _ (S 1%nat)) (is_RInt_scal _ _ _ (- (cos U * b3
      / 3)) _ (S 3%nat)))).
  unfold plus, scal in X; simpl in X; unfold mult in X; simpl in X.
  replace (sin U * (a2 * moment_cos d 2 + a4 * moment_cos d 4 / 12) - cos U * (2 * b1 * moment_sin d 1 + b3 *
    moment_sin d 3 / 3)) with
    (sin U * a2 * moment_cos d 2 + sin U * a4 / 12 * moment_cos d 4 + (- (cos U * 2 * b1) * moment_sin d 1 + - (cos U
      * b3 / 3) * moment_sin d 3)) by field.
  refine (is_RInt_ext _ _ _ _ _ _ X). intros y _.
  match goal with |- ?a = ?b => change (@eq R a b) end. field.
Qed.

(** E1 = m1 d^3: G3 and G4 stand between c3, c4 and C3, C4. *)
Theorem midpoint_between c3 C3 c4 C4 :
  (forall z, F - d <= z <= F + d -> c3 <= G3 z Q <= C3) -> (forall z, F - d <= z <= F + d -> c4 <= G4 z Q <= C4) ->
  let m a3 a4 := sin U * (G2 F Q * moment_cos d 2 + a4 * moment_cos d 4 / 12) - cos U * (2 * G1 F Q * moment_sin d 1 +
    a3 * moment_sin d 3 / 3) in
  m C3 c4 <= midpoint_error U d Q <= m c3 C4.
Proof.
  intros B3 B4 m. assert (P := PI2_1). assert (HF : 0 < Q < F - d) by (unfold F; lra). assert (d0 : 0 <= d) by lra.
  assert (SU : 0 <= sin U) by (apply sin_ge_0; lra). assert (CU : 0 <= cos U) by (apply cos_ge_0; lra).
  assert (d1 : d <= PI/2) by lra.
  assert (E : forall e c, (forall z, F - d <= z <= F + d -> 0 <= e * (c - G4 z Q)) -> forall y, 0 <= y <= d ->
    0 <= e * (2 * G F Q + G2 F Q * y^2 + c * y^4 / 12 - even F Q G y)).
  { intros e c H. apply (even_bound F Q d HF d0). intros y Hy. unfold even. assert (A := H (F + y) ltac:(lra)).
    assert (B := H (F - y) ltac:(lra)). lra. }
  assert (O : forall e c, (forall z, F - d <= z <= F + d -> 0 <= e * (c - G3 z Q)) -> forall y, 0 <= y <= d ->
    0 <= e * (2 * G1 F Q * y + c * y^3 / 3 - - odd F Q G y)).
  { intros e c H. apply (odd_bound F Q d HF d0). intros y Hy. unfold even. assert (A := H (F + y) ltac:(lra)).
    assert (B := H (F - y) ltac:(lra)). lra. }
  split.
  - apply (is_RInt_le _ _ 0 d _ _ d0 (moments (G2 F Q) c4 (G1 F Q) C3) midpoint_halves). intros y Hy.
    assert (A := E (-1) c4 ltac:(intros z Hz; specialize (B4 z Hz); lra) y ltac:(lra)).
    assert (B := O 1 C3 ltac:(intros z Hz; specialize (B3 z Hz); lra) y ltac:(lra)).
    assert (0 <= cos y) by (apply cos_ge_0; lra). assert (0 <= sin y) by (apply sin_ge_0; lra).
    apply Rplus_le_compat; (apply Rmult_le_compat_l; [now apply Rmult_le_pos | lra]).
  - apply (is_RInt_le _ _ 0 d _ _ d0 midpoint_halves (moments (G2 F Q) C4 (G1 F Q) c3)). intros y Hy.
    assert (A := E 1 C4 ltac:(intros z Hz; specialize (B4 z Hz); lra) y ltac:(lra)).
    assert (B := O (-1) c3 ltac:(intros z Hz; specialize (B3 z Hz); lra) y ltac:(lra)).
    assert (0 <= cos y) by (apply cos_ge_0; lra). assert (0 <= sin y) by (apply sin_ge_0; lra).
    apply Rplus_le_compat; (apply Rmult_le_compat_l; [now apply Rmult_le_pos | lra]).
Qed.
End Midpoint.
