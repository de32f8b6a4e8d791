(** The end of an orbit as formulas in d = u/2 (L52 of law.md): with y the point of tangency, kappa = sin y = d^2 kh,
    eps = d^2 epsh, J - Q = d A. They are evaluated on jets, at d = 0, and on slopes.

    contact, flight == what is known of the last contact; kh, cos th, sin th and epsh of the flight after it
    flight_of       == these, computed
    offset_of       == A
    bends_of        == G1 and G2 at (F, Q)
    moments         == the moments of L49 and the integrals g1, g2
    share_of        == (T - 1)/sqrt eps
    weight_H, weight_H2 == the integrands of g1 and g2, without t, at pi - 2 d t *)
From Coq Require Import ZArith.
From Dumbbell Require Import Terms.

Section Formulas.
Variable T : Type.
Variable o : ops T.
Notation "a + b" := (o_add T o a b) : term_scope.
Notation "a - b" := (o_sub T o a b) : term_scope.
Notation "a * b" := (o_mul T o a b) : term_scope.
Notation "a / b" := (o_div T o a b) : term_scope.
Delimit Scope term_scope with t.
Notation num := (o_num T o).
Notation sqr := (o_sqr T o).
Notation root := (o_root T o).

(** F, Q and d; sinc d, sinc 2 d, cos d; r/(2 d^2), where r = cos y + y sin y - 1. *)
Record contact := { tF : T; tQ : T; td : T; twave : T; tdouble : T; tcos : T; tlift : T }.
Record flight := { tkh : T; tcosine : T; tsine : T; tepsh : T }.
Definition flight_of (i : contact) : flight :=
  let kh := ((sqr (twave i) + tlift i) / tF i)%t in let cosine := (tQ i / tF i)%t in
  let sine := root (num 1 - sqr cosine)%t in
  {| tkh := kh; tcosine := cosine; tsine := sine; tepsh := (kh * cosine / sine)%t |}.
Definition offset_of (i : contact) (f : flight) : T :=
  let b := (tepsh f / (num 2 * tdouble i))%t in let db := (td i * b)%t in let c := (num 1 / root (num 1 + sqr db))%t
    in
  (c * tcosine f * (twave i / (num 2 * tcos i) - num 1 + tlift i / (num 2 * tdouble i)) -
   tQ i * td i * sqr (b * c) / (num 1 + c) - tsine f * db * c)%t.
Definition bends_of (F Q : T) : T * T :=
  let R := (sqr F - sqr Q)%t in let r1 := (num 1 / root R)%t in let f := (num 1 / F)%t in
  let r3 := (r1 / R)%t in let r5 := (r3 / R)%t in
  (Q * (num 0 - (sqr f * r1 + r3)), Q * (num 2 * (f * sqr f) * r1 + f * r3 + num 3 * F * r5))%t.

(** 2 r/kappa^2; the moments over d^3, the far ones with G4/12 and G3/6; g1, g2. *)
Record moments := { tabove : T; tI2 : T; tI4 : T; tJ1 : T; tJ3 : T; tg1 : T; tg2 : T }.
Definition share_of (i : contact) (f : flight) (A : T) (G : T * T) (m : moments) : T :=
  let me := (td i * twave i * (snd G * tI2 m + tI4 m) - num 2 * tcos i * (fst G * tJ1 m + tJ3 m) +
    num 4 * tg1 m * A + num 2 * (td i * tg2 m) * sqr A)%t in
  let s := root (tepsh f) in
  (me / (num 2 * tepsh f * s) - td i * tkh f * tabove m / (num 4 * tF i * s))%t.

Definition weight_H (wave F Q : T) : T := let R := (sqr F - sqr Q)%t in (wave * (F / (R * root R)))%t.
Definition weight_H2 (wave F X : T) : T :=
  let R := (sqr F - sqr X)%t in (wave * (num 3 * X * F / (sqr R * root R)))%t.
End Formulas.
