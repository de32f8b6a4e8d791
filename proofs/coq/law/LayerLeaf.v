(** A leaf of the layer: steps of middle U <= 9/10 and half-length rho U, for all U and rho of two intervals.

    constants              == what is computed once: nodes, weights, their spread, the parts of the second order
    refined                == an enclosure of q = (Q - pi/2)/(rho^2 U)
    slope_leaf             == (C6) and (C7) hold on the leaf
    beyond_leaf            == no step of the leaf has eps <= 1/1000 *)
From Coq Require Import ZArith List Bool.
From Interval Require Import Real.Xreal Float.Basic Float.Sig Interval.Interval Interval.Float Interval.Float_full.
From Dumbbell Require Import Calculus LayerRule NodeRule.
Import ListNotations.

Module LayerLeaf (F : FloatOps with Definition sensible_format := true).
Module Export K := Calculus F.
Section Leaf.
Variable p : F.precision.
Notation "a + b" := (I.add p a b). Notation "a - b" := (I.sub p a b). Notation "a * b" := (I.mul p a b).
Notation "a / b" := (I.div p a b). Notation "- a" := (I.neg a).
Notation "# z" := (I.fromZ p z) (at level 0, z at level 0).
Notation frac a b := (I.div p (I.fromZ p a) (I.fromZ p b)).

Record constants := { c_table : table; c_nodes : list (I.type * I.type); c_spread : I.type;
  c_parts : list (I.type * I.type); c_half_pi : I.type; c_crude : I.type; c_h0 : I.type }.
(** Of n equal parts of [0, 1]: the mean node of each, its weight, and n^4 times what is left of t^2/2. *)
Definition node_of_part (n i : Z) := (frac (2 * (3 * i * i + 3 * i + 1)) (3 * n * (2 * i + 1)),
  frac (2 * i + 1) (2 * n * n))%Z.
Definition spread_of_part (n : Z) (i : Z) := frac (6 * i * i + 6 * i + 1) (72 * (2 * i + 1) * n * n * n * n)%Z.
Definition make_constants (n m : nat) : constants :=
  let t := make_table p in let n' := Z.of_nat n in let m' := Z.of_nat m in let half := t_pi t / #2 in {|
  c_table := t; c_nodes := map (node_of_part n') (upto 0 n); c_spread := fold_right (fun i s =>
    spread_of_part n' i + s) I.zero (upto 0 n);
  c_parts := map (fun i => (I.join (frac i m') (frac (i + 1) m'), frac (2 * i + 1) (2 * m' * m')))%Z (upto 0 m);
  c_half_pi := half; c_crude := half + I.join (frac (-1) 100) (frac 1 20);
  c_h0 := #8 / (#3 * I.sqrt p (#3) * (t_pi t * I.sqr p (t_pi t))) |}.

Variable c : constants.
Variable U rho : I.type.
Notation T := (c_table c).
Notation C := (enclosing p T U).
Notation plus := (plus C rho).

Definition offset (s : sizes C) := let e2 := I.sqr p (values p U (z_ehat C s)) in
  I.join (- (frac 53 10 * e2 / (plus * I.sqr p plus))) (U * I.sqr p U * e2 * frac 1 4) - values p U (z_first C s).
Definition crude := sizes_of C rho (line p U (c_crude c) I.zero).
Definition sizes_at q := sizes_of C rho (line p U (c_half_pi c) (I.sqr p rho * q)).
Fixpoint refined (n : nat) (q : I.type) := match n with O => q | S n =>
  refined n (I.meet q (offset (sizes_at q))) end.

Definition both_anchored (Q x : slope) : slope :=
  let R := shift p (neg (sqr p Q)) (I.sqr p (t_pi T)) in let r3 := inv p (mul p R (root p R)) in
  let at0 := scale p r3 (t_pi T) in
  let turn := sub p (scale p (mul p r3 (inv p R)) (#3 * I.sqr p (t_pi T))) r3 in
  {| zero := zero at0; first := first at0 + frac 4 3 * zero turn; rise := rise x; bend := bend x; whole := whole x |}.
Definition rise_of_second (k x1 : I.type) : I.type := let X := line p U (c_half_pi c) x1 in
  fold_right (fun '(t, w) s => rise (second_order C (k * t) X) * w + s) I.zero (c_parts c).
Definition nonneg (i : I.type) := match I.sign_large i with Xgt | Xeq => true | _ => false end.

Definition slope_leaf : bool :=
  let q := refined 2 (offset crude) in let s := sizes_at q in let Q := z_Q C s in let Q_at := values p U Q in
  let x := t_unit T * (plus * U) in let r2 := I.sqr p rho in let d := rho * U in let d2 := I.sqr p d in
  let k := k_of C rho (c_nodes c) s (c_spread c * n_second_G C x (values p U (J_of C rho s))) in
  let half := half_of C rho k in
  let way := way_of C rho (c_nodes c) Q (c_spread c * n_second_H C x Q_at) in
  let mean := mean_of C rho Q (n_second_H C (U + I.join (- d) d) Q_at * (r2 * (frac 1 3 - r2 / #9))) in
  let both := both_anchored Q (both_of C rho mean way) in
  let F := t_pi T - U in let far := I.join (F - d) (F + d) in
  let e0 := whole (z_sin_U C s) * (r2 / #5 * (#1 - d2 * frac 1 2 * t_unit T) * n_G4 C far Q_at / #12)
    - whole (z_cos_U C s) * (r2 / #5 * (#1 - d2 * frac 1 6 * t_unit T) * n_G3 C far Q_at / #3) in
  let m1 := first_part C s (- (r2 / #10 * t_unit T)) (- (r2 / #30 * t_unit T)) e0 in
  let A := values p U (z_first C s) in let A' := values p U (z_last C s) in
  let h := line p U (c_h0 c) (rise_of_second plus (r2 * (q + I.join I.zero A))) in
  let h' := line p U (c_h0 c) (rise_of_second (minus C rho) (r2 * (q + I.join I.zero A'))) in
  let m := add p m1 (second_part C rho s mean both h h') in
  let ratio := ratio_of C s m half in let v := place_of C s half in let v_at := values p U v in
  let '(by_rho, by_U) := n_excess C rho q (bend ratio) (rise v) v_at in
  let D2 := #1 / I.sqr p (values p U half) in
  let bounded a b (sign : I.type -> I.type) :=
    let x := sign (by_rho - b * D2) in let y := sign (by_U - a * v_at) in
    (nonneg x && nonneg y) || nonneg (rho * x + U * y) in
  nonneg (values p U (below_of C rho k)) && bounded (frac (-31) 200) (frac (-43) 100) (fun x => x)
  && bounded (frac 1 8) (frac 9 20) I.neg.
Definition beyond_leaf : bool := above_zero (rho * I.sqr p U * values p U (z_ehat C crude) - frac 1 1000).
End Leaf.
End LayerLeaf.
