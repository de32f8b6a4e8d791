(** Formulas that are evaluated in three ways: on jets of exact numbers (Slopes.v), on what these are at U = 0, and on
    slopes, which enclose the jets. A formula is a function of the operations.

    ops             == numbers, sums, products, quotients, squares, roots
    jets, duals     == on jets; on pairs, the value and the slope at U = 0
    base            == a jet as a pair: it commutes with all operations
    dual_is         == a pair is its two parts
    Terms.slopes    == on slopes
    enclose         == proves that a formula on slopes encloses the same one on jets *)
From Coq Require Import Reals ZArith Lra.
From Interval Require Import Float.Basic Float.Sig.
From Dumbbell Require Import Slopes.
Local Open Scope R_scope.

Record ops (T : Type) := { o_num : Z -> T; o_add : T -> T -> T; o_sub : T -> T -> T; o_mul : T -> T -> T;
  o_div : T -> T -> T; o_sqr : T -> T; o_root : T -> T }.

Definition jets (U : R) : ops jet := {| o_num := fun z => jline U (IZR z) 0; o_add := jadd; o_sub := jsub;
  o_mul := jmul; o_div := jdiv; o_sqr := jsqr; o_root := jsqrt |}.

Record dual := Dual { value : R; slope : R }.
Definition dadd x y := Dual (value x + value y) (slope x + slope y).
Definition dsub x y := Dual (value x - value y) (slope x - slope y).
Definition dmul x y := Dual (value x * value y) (value x * slope y + slope x * value y).
Definition dinv x := Dual (/ value x) (- (slope x * (/ value x * / value x))).
Definition ddiv x y := dmul x (dinv y).
Definition dsqr x := Dual (value x * value x) (2 * value x * slope x).
Definition dsqrt x := Dual (sqrt (value x)) (slope x / (sqrt (value x) + sqrt (value x))).
Definition duals : ops dual := {| o_num := fun z => Dual (IZR z) 0; o_add := dadd; o_sub := dsub; o_mul := dmul;
  o_div := ddiv; o_sqr := dsqr; o_root := dsqrt |}.
Definition base (x : jet) := Dual (at_0 x) (slope_0 x).
Lemma dual_is x a b : value x = a -> slope x = b -> x = Dual a b.
Proof. destruct x; simpl. now intros -> ->. Qed.

Module Terms (F : FloatOps with Definition sensible_format := true).
Module Export S := Slopes F.
Definition slopes (p : F.precision) (U : I.type) : ops S.slope :=
  {| o_num := fun z => line p U (I.fromZ p z) I.zero; o_add := add p; o_sub := sub p; o_mul := mul p; o_div := div p;
     o_sqr := sqr p; o_root := root p |}.

Ltac enclose := cbn [o_num o_add o_sub o_mul o_div o_sqr o_root jets slopes]; repeat
  match goal with
  | |- _ => assumption
  | |- encl _ (jadd _ _) _ => apply add_encl
  | |- encl _ (jsub _ _) _ => apply sub_encl
  | |- encl _ (jmul _ _) _ => apply mul_encl
  | |- encl _ (jdiv _ _) _ => apply div_encl
  | |- encl _ (jsqr _) _ => apply sqr_encl
  | |- encl _ (jsqrt _) _ => apply root_encl
  | |- encl _ (jline _ (IZR _) 0) _ => apply line_encl; [|assumption|apply fromZ_in|apply zero_in]
  end.
End Terms.
