(** N(q) >= n or not, by the law (L56 of law.md), for n >= 903: the place C sqrt q - (n - 2) of a mass ratio is on one
    side of what Theorem A leaves open about the critical ratio of n. With so many bits that the place is known to the
    share of a step that is left open. What is found is proved in law/DecidedByLaw.v.

    partial_sum             == a partial sum of the series for C (law/GrowthSeries.v)
    correction              == c0, from a sum of cubes (law/CubesTail.v) and a share of what is left of them
    side                    == what Theorem A says of delta, with a number for c0 and the sign of the error
    law_reaches             == N(q) >= n or not, by the law
    either, outcome, by_law == by the law or one orbit; of a claim: it holds, fails at this ratio, or is not decided *)
From Coq Require Import ZArith NArith.
From Interval Require Import Float.Specific_ops Float.Specific_bigint.
From Dumbbell Require Import Certificate Multiple Decide.
Module C := M.Z.

Section Numbers.
Variable p : BigFloat.precision.
Definition whole (z : Z) : I.type := I.fromZ p z.
Definition fraction (a b : Z) : I.type := I.div p (whole a) (whole b).
Definition value (q : ratio) : I.type := fraction (Zpos (num q)) (Zpos (den q)).
Definition root_3 : I.type := I.sqrt p (whole 3).
Definition half_pi : I.type := I.div p (I.pi p) (whole 2).

(** From the term i of the sine, the integral i, its next increment and the sum up to i, to the sum up to i + k. *)
Fixpoint sum_from (k : nat) (i : Z) (square term secants power sum : I.type) : I.type :=
  match k with
  | O => sum
  | S k =>
    let term := I.neg (I.div p (I.mul p term square) (whole ((2 * i + 2) * (2 * i + 3)))) in
    let secants := I.div p (I.add p power (I.mul p (whole (2 * i + 1)) secants)) (whole (2 * i + 2)) in
    sum_from k (i + 1) square term secants (I.mul p (whole 4) power) (I.add p sum (I.mul p term secants))
  end.
Definition partial_sum (k : nat) : I.type :=
  let first := I.ln p (I.add p (whole 2) root_3) in
  sum_from k 0 (I.mul p half_pi half_pi) half_pi first (I.mul2 p root_3) (I.mul p half_pi first).

(** From the root of i + 1 and the sum of the cubes up to i, to the sum up to i + k; then c0. *)
Fixpoint cubes_from (k : nat) (i : Z) (root sum : I.type) : I.type :=
  match k with
  | O => sum
  | S k => let next := I.sqrt p (whole (i + 2)) in let step := I.sub p next root in
           cubes_from k (i + 1) next (I.add p sum (I.mul p step (I.mul p step step)))
  end.
Definition cubes (m : nat) : I.type := cubes_from m 0 (whole 1) (whole 1).
Definition correction (m : nat) (sum share : I.type) : I.type :=
  let rest := I.inv p (I.mul p (whole 4) (I.sqrt p (whole (Z.of_nat m + 1)))) in
  let twice_k0 := I.div p (whole 2)
    (I.mul p (I.mul p (whole 3) (I.mul p root_3 (I.sqrt p root_3))) (I.sqrt p (I.pi p))) in
  I.mul p twice_k0 (I.add p sum (I.mul p rest share)).
Definition least_share (m : nat) : I.type := I.sub p (whole 1) (fraction 1 (16 * ((Z.of_nat m + 1) * (Z.of_nat m +
  1)))).

Definition side (sign : Z) (c0 : I.type) (even : bool) (q : ratio) : I.type :=
  let inverse := I.inv p (I.sqrt p (value q)) in let s := I.sqrt p inverse in
  let kappa := I.div p (whole 5) (I.mul p (I.mul p (whole 36) root_3) (I.pi p)) in
  let error := I.add p (fraction 72 1000) (I.mul p (fraction 26 10) s) in
  let constant := I.sub p (fraction (if even then 497 else 380) 1000) (I.mul p (whole sign) error) in
  I.sub p (I.mul p c0 s)
    (I.mul p inverse (I.add p (I.mul p kappa (I.ln p (value q))) constant)).
End Numbers.

(** The place, with as many bits as the root has, half as many again for the correction, and some for rounding. *)
Definition law_bits (q : ratio) : N := (3 * N.size (Npos (num q)) / 4 + 64)%N.
Definition place (p : BigFloat.precision) (k : nat) (q : ratio) (n : N) : I.type :=
  I.sub p (I.mul p (partial_sum p k) (I.sqrt p (value p q))) (whole p (Z.of_N n - 2)).
Definition reaches_with (p few : BigFloat.precision) (k m : nat) (q : ratio) (n : N) : option bool :=
  if (n <? 903)%N then None else
  let sum := cubes few m in
  let side sign share := side few sign (correction few m sum share) (N.even n) q in
  if C.pos (I.sub p (place p (2 * k + 1) q n) (side 1%Z (whole few 1))) then Some true else
  if C.nonneg (I.sub p (side (-1)%Z (least_share few m)) (place p (2 * (k + 1)) q n)) then Some false else None.
(** So many terms of the series are enough for the bits; a thousand cubes give c0 to nine decimals. *)
Definition law_reaches (q : ratio) : N -> option bool :=
  reaches_with (precision (law_bits q)) (precision 64) (N.to_nat (law_bits q / 24 + 10)) (N.to_nat 1000) q.

(** Of claims. *)
Definition either (q : ratio) (n : N) : option bool :=
  match law_reaches q n with Some b => Some b | None => option_map snd (decide q n) end.
Inductive outcome := Holds | Fails (q : ratio) (n : N) (reached : bool) | Unknown.
Definition tried (q : ratio) (n : N) (wanted : bool) : outcome :=
  match either q n with Some b => if Bool.eqb b wanted then Holds else Fails q n b | None => Unknown end.
Definition by_law (c : claim) : outcome :=
  if negb (proper_range c) then Unknown else
  match match claimed_most c with None => Holds | Some n => tried (claimed_to c) (N.succ n) false end with
  | Holds => match claimed_least c with None => Holds | Some n => tried (claimed_from c) n true end
  | other => other
  end.
