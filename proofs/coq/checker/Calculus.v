(** Formulas that are written once, and computed twice: with the jets of Slopes.v, which are exact, and with slopes,
  which
    enclose them.

    calculus              == numbers and jets with their operations;
      n_tail_sin, n_tail_cos are what Tails.v leaves of sine and
                             cosine
    s_sinc, s_cos         == of k U, for a number k
    related               == two calculi go together: what is enclosed in the one by the other stays so
    exact                 == real numbers and jets at U
    enclosing             == intervals and slopes over the numbers U
    enclosing_related     == they enclose *)
From Coq Require Import Reals ZArith Lra List.
From Interval Require Import Real.Xreal Float.Basic Float.Sig Interval.Interval Interval.Float Interval.Float_full.
From Dumbbell Require Import Tails Enclosure Slopes.
Local Open Scope R_scope.

Record calculus := {
  num : Type; jet_of : Type;
  n_Z : Z -> num; n_pi : num;
  n_add : num -> num -> num; n_sub : num -> num -> num; n_mul : num -> num -> num; n_div : num -> num -> num;
  n_neg : num -> num; n_sqr : num -> num; n_sqrt : num -> num; n_tail_sin : num -> num; n_tail_cos : num -> num;
  n_U : num;
  s_add : jet_of -> jet_of -> jet_of; s_sub : jet_of -> jet_of -> jet_of; s_mul : jet_of -> jet_of -> jet_of;
  s_inv : jet_of -> jet_of; s_neg : jet_of -> jet_of; s_sqr : jet_of -> jet_of; s_root : jet_of -> jet_of;
  s_scale : jet_of -> num -> jet_of; s_shift : jet_of -> num -> jet_of;
  s_line : num -> num -> jet_of; s_curve : num -> num -> jet_of;
  s_bend : jet_of -> num; s_rise : jet_of -> num; s_values : jet_of -> num; s_tight : jet_of -> jet_of }.

(** sinc (k U) = 1 - U^2 (k^2/6) t, cos (k U) = 1 - U^2 (k^2/2) t. *)
Definition s_sinc C (k : num C) := s_curve C (n_Z C 1)
  (n_neg C (n_mul C (n_div C (n_sqr C k) (n_Z C 6)) (n_tail_sin C (n_mul C k (n_U C))))).
Definition s_cos C (k : num C) := s_curve C (n_Z C 1)
  (n_neg C (n_mul C (n_div C (n_sqr C k) (n_Z C 2)) (n_tail_cos C (n_mul C k (n_U C))))).

Record related (A B : calculus) (N : num A -> num B -> Prop) (S : jet_of A -> jet_of B -> Prop) : Prop := {
  r_Z : forall z, N (n_Z A z) (n_Z B z); r_pi : N (n_pi A) (n_pi B); r_U : N (n_U A) (n_U B);
  r_nadd : forall x y a b, N x a -> N y b -> N (n_add A x y) (n_add B a b);
  r_nsub : forall x y a b, N x a -> N y b -> N (n_sub A x y) (n_sub B a b);
  r_nmul : forall x y a b, N x a -> N y b -> N (n_mul A x y) (n_mul B a b);
  r_ndiv : forall x y a b, N x a -> N y b -> N (n_div A x y) (n_div B a b);
  r_nneg : forall x a, N x a -> N (n_neg A x) (n_neg B a);
  r_nsqr : forall x a, N x a -> N (n_sqr A x) (n_sqr B a);
  r_nsqrt : forall x a, N x a -> N (n_sqrt A x) (n_sqrt B a);
  r_tail_sin : forall x a, N x a -> N (n_tail_sin A x) (n_tail_sin B a);
  r_tail_cos : forall x a, N x a -> N (n_tail_cos A x) (n_tail_cos B a);
  r_add : forall x y a b, S x a -> S y b -> S (s_add A x y) (s_add B a b);
  r_sub : forall x y a b, S x a -> S y b -> S (s_sub A x y) (s_sub B a b);
  r_mul : forall x y a b, S x a -> S y b -> S (s_mul A x y) (s_mul B a b);
  r_inv : forall x a, S x a -> S (s_inv A x) (s_inv B a);
  r_neg : forall x a, S x a -> S (s_neg A x) (s_neg B a);
  r_sqr : forall x a, S x a -> S (s_sqr A x) (s_sqr B a);
  r_root : forall x a, S x a -> S (s_root A x) (s_root B a);
  r_scale : forall x k a i, S x a -> N k i -> S (s_scale A x k) (s_scale B a i);
  r_shift : forall x k a i, S x a -> N k i -> S (s_shift A x k) (s_shift B a i);
  r_line : forall x k a i, N x a -> N k i -> S (s_line A x k) (s_line B a i);
  r_curve : forall x k a i, N x a -> N k i -> S (s_curve A x k) (s_curve B a i);
  r_bend : forall x a, S x a -> N (s_bend A x) (s_bend B a);
  r_rise : forall x a, S x a -> N (s_rise A x) (s_rise B a);
  r_values : forall x a, S x a -> N (s_values A x) (s_values B a);
  r_tight : forall x a, S x a -> S (s_tight A x) (s_tight B a) }.

Definition exact (U : R) : calculus := {|
  num := R; jet_of := jet; n_Z := IZR; n_pi := PI; n_add := Rplus; n_sub := Rminus; n_mul := Rmult; n_div := Rdiv;
  n_neg := Ropp; n_sqr := fun x => x * x; n_sqrt := sqrt; n_tail_sin := tail_sin; n_tail_cos := tail_cos; n_U := U;
  s_add := jadd; s_sub := jsub; s_mul := jmul; s_inv := jinv; s_neg := jneg; s_sqr := jsqr; s_root := jsqrt;
  s_scale := jscale; s_shift := jshift; s_line := jline U; s_curve := jcurve U;
  s_bend := bend_of U; s_rise := rise_of U; s_values := at_U; s_tight := fun x => x |}.

Module Calculus (F : FloatOps with Definition sensible_format := true).
Module Export L := Slopes F.
Section Enclosing.
Variable p : F.precision.
(** What is computed once: pi, [0, 1], and the factors of the tails' brackets. *)
Record table := { t_pi : I.type; t_one : I.type; t_unit : I.type; t_sin : I.type * I.type * I.type;
  t_cos : I.type * I.type * I.type }.
Definition share z := I.inv p (I.fromZ p z).
Definition make_table := {| t_pi := I.pi p; t_one := I.fromZ p 1; t_unit := I.join I.zero (I.fromZ p 1);
  t_sin := (share 20, share 42, share 72); t_cos := (share 12, share 30, share 56) |}.

Definition brackets (t : table) (c : I.type * I.type * I.type) (x : I.type) :=
  let '(c1, c2, c3) := c in let y := I.sqr p x in let o := t_one t in
  I.sub p o (I.mul p (I.mul p y c1) (I.sub p o (I.mul p (I.mul p y c2) (I.sub p o (I.mul p (I.mul p y c3) (t_unit
    t)))))).
Definition enclosing (t : table) (U : I.type) : calculus := {|
  num := I.type; jet_of := slope; n_Z := I.fromZ p; n_pi := t_pi t; n_add := I.add p; n_sub := I.sub p;
    n_mul := I.mul p;
  n_div := I.div p; n_neg := I.neg; n_sqr := I.sqr p; n_sqrt := I.sqrt p; n_tail_sin := brackets t (t_sin t);
  n_tail_cos := brackets t (t_cos t); n_U := U;
  s_add := add p; s_sub := sub p; s_mul := mul p; s_inv := inv p; s_neg := neg; s_sqr := sqr p; s_root := root p;
  s_scale := scale p; s_shift := shift p; s_line := line p U; s_curve := curve p U;
  s_bend := bend; s_rise := rise; s_values := values p U; s_tight := tight p U |}.

Lemma unit_in b : 0 <= b <= 1 -> inI b (I.join I.zero (I.fromZ p 1)).
Proof.
  intros H. apply (contains_connected (I.convert (I.join I.zero (I.fromZ p 1))) 0 1); [| |exact H].
  - apply I.join_correct. left. exact zero_in.
  - apply I.join_correct. right. exact (I.fromZ_correct p 1).
Qed.
Lemma share_in z : inI (/ IZR z) (share z).
Proof. exact (proj1 (inv_in p _ _ (I.fromZ_correct p z))). Qed.
Lemma brackets_in x i b (c1 c2 c3 : Z) : 0 <= b <= 1 -> inI x i ->
  inI (1 - x^2 / IZR c1 * (1 - x^2 / IZR c2 * (1 - x^2 / IZR c3 * b))) (brackets make_table (share c1, share c2,
    share c3) i).
Proof.
  intros Hb Hx. assert (S := sqr_in p _ _ Hx). replace (x * x) with (x^2) in S by ring. unfold brackets, Rdiv.
  assert (O : inI 1 (t_one make_table)) by exact (I.fromZ_correct p 1).
  assert (M : forall z, inI (x^2 * / IZR z) (I.mul p (I.sqr p i) (share z))) by (intros z; apply mul_in;
    [exact S | apply share_in]).
  repeat (apply sub_in; [exact O|]; apply mul_in; [apply M|]). now apply unit_in.
Qed.
Theorem enclosing_related U i : U <> 0 -> inI U i -> related (exact U) (enclosing make_table i) inI (encl U).
Proof.
  intros HU HI. constructor; cbn -[add sub mul inv neg sqr root scale shift line curve values tight brackets
    make_table];
    try (intros; eauto 2 using (add_in p), (sub_in p), (mul_in p), (div_in p), neg_in, (sqr_in p), (sqrt_in p),
      (add_encl p U),
      (sub_encl p U), (mul_encl p U), (inv_encl p U), (neg_encl U), (sqr_encl p U), (root_encl p U), (scale_encl p U),
      (shift_encl p U), (line_encl p U), (curve_encl p U), (values_in p U), (tight_encl p U); fail).
  - intros z. exact (I.fromZ_correct p z).
  - exact (I.pi_correct p).
  - intros x a Hx. destruct (tail_sin_is x) as [b [B ->]]. exact (brackets_in x a b 20 42 72 B Hx).
  - intros x a Hx. destruct (tail_cos_is x) as [b [B ->]]. exact (brackets_in x a b 12 30 56 B Hx).
  - intros x a H. exact (proj1 (proj2 (proj2 (proj2 H)))).
  - intros x a H. exact (proj1 (proj2 (proj2 H))).
Qed.
End Enclosing.
End Calculus.
