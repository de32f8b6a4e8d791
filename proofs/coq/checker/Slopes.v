(** Intervals that know what a quantity does near U = 0 (src/verify/wings/law/slope.hpp): what is divided by U, or by
    U^2, must be small with U, and be seen to be. A quantity x is a jet of exact real numbers: its value at U, and a
    value x0 and a slope x1 at 0, which do not depend on U. So (x - x0)/U and ((x - x0)/U - x1)/U are numbers, and can
    be enclosed.

    jet, at_U, at_0, slope_0         == x, x0, x1
    rise_of, bend_of                 == (x - x0)/U, ((x - x0)/U - x1)/U
    jadd, jneg, jsub, jmul, jinv, jdiv, jsqr, jsqrt, jscale, jshift == sums and so on, by the rules of derivatives
    jline, jcurve                    == a + b U; a + c U^2, where c may depend on U
    nan, nan_in, mul_nan             == an interval that encloses everything, as what is divided by 0 is
    slope, encl                      == five intervals; they enclose x0, x1, (x - x0)/U, ((x - x0)/U - x1)/U and x
    add, neg, sub, mul, inv, div, sqr, root, scale, shift, line,
      curve and add_encl to curve_encl == the same operations on slopes; they enclose, whatever the numbers
    values, tight                    == what is known of x; the same slope with all that is known in each part *)
From Coq Require Import Reals ZArith Lra.
From Interval Require Import Real.Xreal Float.Basic Float.Sig Interval.Interval Interval.Float Interval.Float_full.
From Dumbbell Require Import Enclosure.
Local Open Scope R_scope.

Record jet := { at_U : R; at_0 : R; slope_0 : R }.
Definition jadd x y := {| at_U := at_U x + at_U y; at_0 := at_0 x + at_0 y; slope_0 := slope_0 x + slope_0 y |}.
Definition jneg x := {| at_U := - at_U x; at_0 := - at_0 x; slope_0 := - slope_0 x |}.
Definition jsub x y := {| at_U := at_U x - at_U y; at_0 := at_0 x - at_0 y; slope_0 := slope_0 x - slope_0 y |}.
Definition jmul x y := {| at_U := at_U x * at_U y; at_0 := at_0 x * at_0 y;
  slope_0 := at_0 x * slope_0 y + slope_0 x * at_0 y |}.
Definition jinv x := {| at_U := / at_U x; at_0 := / at_0 x; slope_0 := - (slope_0 x * (/ at_0 x * / at_0 x)) |}.
Definition jdiv x y := jmul x (jinv y).
Definition jsqr x := {| at_U := at_U x * at_U x; at_0 := at_0 x * at_0 x; slope_0 := 2 * at_0 x * slope_0 x |}.
Definition jsqrt x := {| at_U := sqrt (at_U x); at_0 := sqrt (at_0 x);
  slope_0 := slope_0 x / (sqrt (at_0 x) + sqrt (at_0 x)) |}.
Definition jscale x k := {| at_U := at_U x * k; at_0 := at_0 x * k; slope_0 := slope_0 x * k |}.
Definition jshift x k := {| at_U := at_U x + k; at_0 := at_0 x + k; slope_0 := slope_0 x |}.
Definition jline U a b := {| at_U := a + U * b; at_0 := a; slope_0 := b |}.
Definition jcurve U a c := {| at_U := a + U * U * c; at_0 := a; slope_0 := 0 |}.
Definition rise_of U x := (at_U x - at_0 x) / U.
Definition bend_of U x := (rise_of U x - slope_0 x) / U.

Module Slopes (F : FloatOps with Definition sensible_format := true).
Module Export X := Enclosure F.

Definition nan i := contains (I.convert i) Xnan.
Lemma nan_in i x : nan i -> inI x i.
Proof. exact (nan_all i x). Qed.
Lemma nai_nan : nan I.nai.
Proof. unfold nan. now rewrite I.nai_correct. Qed.

Record slope := { zero : I.type; first : I.type; rise : I.type; bend : I.type; whole : I.type }.
Definition nothing := {| zero := I.nai; first := I.nai; rise := I.nai; bend := I.nai; whole := I.nai |}.
Definition encl U (x : jet) (s : slope) := inI (at_0 x) (zero s) /\ inI (slope_0 x) (first s) /\
  inI (rise_of U x) (rise s) /\ inI (bend_of U x) (bend s) /\ inI (at_U x) (whole s).

Section Operations.
Variable p : F.precision.
Notation "a + b" := (I.add p a b) : interval_scope.
Notation "a - b" := (I.sub p a b) : interval_scope.
Notation "a * b" := (I.mul p a b) : interval_scope.
Notation "a / b" := (I.div p a b) : interval_scope.
Notation "- a" := (I.neg a) : interval_scope.
Delimit Scope interval_scope with i.

Definition add x y := {| zero := zero x + zero y; first := first x + first y; rise := rise x + rise y;
  bend := bend x + bend y; whole := whole x + whole y |}%i.
Definition neg x := {| zero := - zero x; first := - first x; rise := - rise x; bend := - bend x;
  whole := - whole x |}%i.
Definition sub x y := {| zero := zero x - zero y; first := first x - first y; rise := rise x - rise y;
  bend := bend x - bend y; whole := whole x - whole y |}%i.
Definition mul x y := {| zero := zero x * zero y; first := zero x * first y + first x * zero y;
  rise := zero x * rise y + rise x * whole y; bend := zero x * bend y + first x * rise y + bend x * whole y;
  whole := whole x * whole y |}%i.
Definition inv x := let z := I.inv p (zero x) in let w := I.inv p (whole x) in let b := (z * w)%i in
  {| zero := z; first := - (first x * I.sqr p z); rise := - (rise x * b);
     bend := (first x * rise x * z - bend x) * b; whole := w |}%i.
Definition div x y := mul x (inv y).
Definition sqr x := let s := (zero x + whole x)%i in
  {| zero := I.sqr p (zero x); first := I.mul2 p (zero x * first x); rise := rise x * s;
     bend := first x * rise x + bend x * s; whole := I.sqr p (whole x) |}%i.
Definition above_zero i := match I.sign_strict i with Xgt => true | _ => false end.
Definition root x := if (above_zero (zero x) && above_zero (whole x))%bool then
  let z := I.sqrt p (zero x) in let w := I.sqrt p (whole x) in let s := (z + w)%i in
  let f := (first x / (z + z))%i in let r := (rise x / s)%i in
  {| zero := z; first := f; rise := r; bend := (bend x - f * r) / s; whole := w |}%i else nothing.
Definition scale x k := {| zero := zero x * k; first := first x * k; rise := rise x * k; bend := bend x * k;
  whole := whole x * k |}%i.
Definition shift x k := {| zero := zero x + k; first := first x; rise := rise x; bend := bend x;
  whole := whole x + k |}%i.
Definition line U a b := {| zero := a; first := b; rise := b; bend := I.zero; whole := a + U * b |}%i.
Definition curve U a c := let r := (U * c)%i in
  {| zero := a; first := I.zero; rise := r; bend := c; whole := a + U * r |}%i.
Definition values U x := (I.meet (I.meet (whole x) (zero x + U * rise x)) (zero x + U * (first x + U * bend x)))%i.
Definition tight U x := {| zero := zero x; first := first x; rise := I.meet (rise x) (first x + U * bend x);
  bend := bend x; whole := values U x |}%i.

Lemma mul_nan j k y : inI y k -> nan j -> nan (j * k)%i /\ nan (k * j)%i.
Proof.
  intros Hk Hj. split; [exact (I.mul_correct p j k Xnan (Xreal y) Hj Hk)|].
  exact (I.mul_correct p k j (Xreal y) Xnan Hk Hj).
Qed.
(** What is divided by 0 is enclosed by an interval that encloses everything. *)
Lemma inv_in x i : inI x i -> inI (/ x) (I.inv p i) /\ (x = 0 -> nan (I.inv p i)).
Proof.
  intros H. assert (K := I.inv_correct p i (Xreal x) H). simpl in K. unfold Xinv' in K.
  destruct (Xreal.is_zero_spec x) as [Z|Z]; [split; [now apply nan_in | easy] | now split].
Qed.
Lemma above_zero_true x i : above_zero i = true -> inI x i -> 0 < x.
Proof.
  intros H Hx. unfold above_zero in H. assert (K := I.sign_strict_correct i). destruct (I.sign_strict i);
    try discriminate.
  destruct (K _ Hx) as [_ K2]. exact K2.
Qed.

Variable U : R.
Hypothesis HU : U <> 0.
Ltac show e := match goal with |- inI ?x _ => replace x with e; [|try (unfold bend_of, rise_of; simpl; field;
  lra)] end.
Ltac parts := unfold encl; cbn [zero first rise bend whole]; split; [|split; [|split; [|split]]].

Lemma add_encl x y a b : encl U x a -> encl U y b -> encl U (jadd x y) (add a b).
Proof.
  intros [A1 [A2 [A3 [A4 A5]]]] [B1 [B2 [B3 [B4 B5]]]]. parts; try (apply add_in; assumption).
  - show (rise_of U x + rise_of U y). now apply add_in.
  - show (bend_of U x + bend_of U y). now apply add_in.
Qed.
Lemma neg_encl x a : encl U x a -> encl U (jneg x) (neg a).
Proof.
  intros [A1 [A2 [A3 [A4 A5]]]]. parts; try (apply neg_in; assumption).
  - show (- rise_of U x). now apply neg_in.
  - show (- bend_of U x). now apply neg_in.
Qed.
Lemma sub_encl x y a b : encl U x a -> encl U y b -> encl U (jsub x y) (sub a b).
Proof.
  intros [A1 [A2 [A3 [A4 A5]]]] [B1 [B2 [B3 [B4 B5]]]]. parts; try (apply sub_in; assumption).
  - show (rise_of U x - rise_of U y). now apply sub_in.
  - show (bend_of U x - bend_of U y). now apply sub_in.
Qed.
Lemma mul_encl x y a b : encl U x a -> encl U y b -> encl U (jmul x y) (mul a b).
Proof.
  intros [A1 [A2 [A3 [A4 A5]]]] [B1 [B2 [B3 [B4 B5]]]]. parts; try (now apply mul_in).
  - apply add_in; now apply mul_in.
  - show (at_0 x * rise_of U y + rise_of U x * at_U y). apply add_in; now apply mul_in.
  - show (at_0 x * bend_of U y + slope_0 x * rise_of U y + bend_of U x * at_U y).
    apply add_in; [apply add_in|]; now apply mul_in.
Qed.
Lemma inv_encl x a : encl U x a -> encl U (jinv x) (inv a).
Proof.
  intros [A1 [A2 [A3 [A4 A5]]]]. destruct (inv_in _ _ A1) as [Z Z0]. destruct (inv_in _ _ A5) as [W W0].
  assert (B := mul_in p _ _ _ _ Z W). parts; try assumption.
  - apply neg_in, mul_in; [exact A2 | now apply sqr_in].
  - destruct (Req_dec (at_0 x) 0) as [E|E]; [|destruct (Req_dec (at_U x) 0) as [E'|E']].
    + apply nan_in, (I.neg_correct _ Xnan). destruct (mul_nan _ _ _ W (Z0 E)) as [N _].
      exact (proj2 (mul_nan _ _ _ A3 N)).
    + apply nan_in, (I.neg_correct _ Xnan). destruct (mul_nan _ _ _ Z (W0 E')) as [_ N].
      exact (proj2 (mul_nan _ _ _ A3 N)).
    + show (- (rise_of U x * (/ at_0 x * / at_U x))). apply neg_in. now apply mul_in.
  - assert (K : inI (slope_0 x * rise_of U x * / at_0 x - bend_of U x) (first a * rise a * I.inv p (zero a) - bend
    a)%i).
    { apply sub_in; [|exact A4]. apply mul_in; [now apply mul_in | exact Z]. }
    destruct (Req_dec (at_0 x) 0) as [E|E]; [|destruct (Req_dec (at_U x) 0) as [E'|E']].
    + destruct (mul_nan _ _ _ W (Z0 E)) as [N _]. apply nan_in. exact (proj2 (mul_nan _ _ _ K N)).
    + destruct (mul_nan _ _ _ Z (W0 E')) as [_ N]. apply nan_in. exact (proj2 (mul_nan _ _ _ K N)).
    + show ((slope_0 x * rise_of U x * / at_0 x - bend_of U x) * (/ at_0 x * / at_U x)). now apply mul_in.
Qed.
Lemma div_encl x y a b : encl U x a -> encl U y b -> encl U (jdiv x y) (div a b).
Proof. intros. apply mul_encl; [assumption | now apply inv_encl]. Qed.
Lemma sqr_encl x a : encl U x a -> encl U (jsqr x) (sqr a).
Proof.
  intros [A1 [A2 [A3 [A4 A5]]]]. assert (S := add_in p _ _ _ _ A1 A5). parts; try (now apply sqr_in).
  - replace (slope_0 (jsqr x)) with (2 * (at_0 x * slope_0 x)) by (unfold jsqr; cbn [slope_0]; ring). apply mul2_in.
    now apply mul_in.
  - show (rise_of U x * (at_0 x + at_U x)). now apply mul_in.
  - show (slope_0 x * rise_of U x + bend_of U x * (at_0 x + at_U x)). apply add_in; now apply mul_in.
Qed.
Lemma root_encl x a : encl U x a -> encl U (jsqrt x) (root a).
Proof.
  intros [A1 [A2 [A3 [A4 A5]]]]. unfold root.
  destruct (above_zero (zero a)) eqn:P1; [destruct (above_zero (whole a)) eqn:P2|];
    [|repeat split; apply nan_in, nai_nan|repeat split; apply nan_in, nai_nan]. cbn [andb].
  assert (N0 := above_zero_true _ _ P1 A1). assert (N := above_zero_true _ _ P2 A5).
  assert (Z := sqrt_in p _ _ A1). assert (W := sqrt_in p _ _ A5).
  assert (S := add_in p _ _ _ _ Z W). assert (S2 := add_in p _ _ _ _ Z Z).
  assert (Q0 := sqrt_lt_R0 _ N0). assert (Q := sqrt_lt_R0 _ N). assert (E0 := sqrt_sqrt _ (Rlt_le _ _ N0)).
  assert (E := sqrt_sqrt _ (Rlt_le _ _ N)).
  assert (R : rise_of U (jsqrt x) = rise_of U x / (sqrt (at_0 x) + sqrt (at_U x))).
  { unfold rise_of. simpl. rewrite <- E0 at 2. rewrite <- E at 2. field. lra. }
  parts; try assumption.
  - now apply div_in.
  - rewrite R. now apply div_in.
  - show ((bend_of U x - slope_0 x / (sqrt (at_0 x) + sqrt (at_0 x)) * (rise_of U x / (sqrt (at_0 x) + sqrt (at_U
    x)))) /
      (sqrt (at_0 x) + sqrt (at_U x))).
    + apply div_in; [|exact S]. apply sub_in; [exact A4|]. apply mul_in; now apply div_in.
    + unfold bend_of at 2. rewrite R. unfold bend_of. set (s0 := sqrt (at_0 x)) in *. set (s := sqrt (at_U x)) in *.
      simpl. fold s0. assert (G3 : rise_of U x = (s * s - s0 * s0) / U) by (unfold rise_of; rewrite E, E0;
        reflexivity).
      rewrite G3. field. lra.
Qed.
Lemma scale_encl x k a i : encl U x a -> inI k i -> encl U (jscale x k) (scale a i).
Proof.
  intros [A1 [A2 [A3 [A4 A5]]]] K. parts; try (now apply mul_in).
  - show (rise_of U x * k). now apply mul_in.
  - show (bend_of U x * k). now apply mul_in.
Qed.
Lemma shift_encl x k a i : encl U x a -> inI k i -> encl U (jshift x k) (shift a i).
Proof.
  intros [A1 [A2 [A3 [A4 A5]]]] K. parts; try (now apply add_in).
  - exact A2.
  - show (rise_of U x). exact A3.
  - show (bend_of U x). exact A4.
Qed.
Lemma line_encl a b i j k : inI U i -> inI a j -> inI b k -> encl U (jline U a b) (line i j k).
Proof.
  intros HI A B. parts; try assumption.
  - show b. exact B.
  - show 0. exact zero_in.
  - apply add_in; [exact A | now apply mul_in].
Qed.
Lemma curve_encl a c i j k : inI U i -> inI a j -> inI c k -> encl U (jcurve U a c) (curve i j k).
Proof.
  intros HI A B. parts; try assumption.
  - exact zero_in.
  - show (U * c). now apply mul_in.
  - show c. exact B.
  - simpl. rewrite Rmult_assoc. apply add_in; [exact A | apply mul_in; [exact HI | now apply mul_in]].
Qed.
Lemma meet_in x i j : inI x i -> inI x j -> inI x (I.meet i j).
Proof. exact (I.meet_correct i j (Xreal x)). Qed.
Lemma values_in x a i : inI U i -> encl U x a -> inI (at_U x) (values i a).
Proof.
  intros HI [A1 [A2 [A3 [A4 A5]]]]. unfold values. apply meet_in; [apply meet_in; [exact A5|]|].
  - show (at_0 x + U * rise_of U x). apply add_in; [exact A1 | now apply mul_in].
  - show (at_0 x + U * (slope_0 x + U * bend_of U x)).
    apply add_in; [exact A1 | apply mul_in; [exact HI | apply add_in; [exact A2 | now apply mul_in]]].
Qed.
Lemma tight_encl x a i : inI U i -> encl U x a -> encl U x (tight i a).
Proof.
  intros HI A. assert (V := values_in _ _ _ HI A). destruct A as [A1 [A2 [A3 [A4 A5]]]]. parts; try assumption.
  apply meet_in; [exact A3|]. show (slope_0 x + U * bend_of U x). apply add_in; [exact A2 | now apply mul_in].
Qed.
End Operations.
End Slopes.
