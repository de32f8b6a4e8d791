(** Claims about N(q) decided without a certificate: N(q) >= n is a question about one orbit at one mass ratio
    (Theorem 1), and N grows with q (Theorem 2), so that a range needs one end for each bound. In double precision
    first, then with more and more bits, within a budget. The answers are proved in exact/Decided.v.

    numbers                == doubles, or so many bits
    far_above              == n is so great that N(q) < n without an orbit (Theorem 3 (c))
    reaches, decide        == N(q) >= n or not, by one orbit, with given numbers; with the first that tell
    claim, finding, settle == bounds on a range of ratios; that they are true, false, or not decided
    holds                  == the same with given numbers, for the kernel *)
From Coq Require Import ZArith NArith List Bool.
From Dumbbell Require Import Certificate Leaves TwoOrbits Doubles Multiple Check.
Import ListNotations.
Local Open Scope N_scope.

(** Which numbers are calculated with. *)
Inductive numbers := Machine_doubles | Bits (b : N).
Definition at_most_with w := match w with Machine_doubles => Doubles.orbit_at_most | Bits b => Multiple.orbit_at_most b end.
Definition at_least_with w := match w with Machine_doubles => Doubles.orbit_at_least | Bits b => Multiple.orbit_at_least b end.

(** N(q) >= n for n = 1 + 2 k if the top orbit collides k times, for n = 2 + 2 k if the corner orbit does. *)
Definition orbit_for (n : N) : orbit := if N.even n then Corner else Top.
Definition collisions_for (n : N) : N := N.div2 (N.pred n).

(** 2 + 2 sqrt(q/pi) <= n, as pi > 3; for n > 2. *)
Definition far_above (q : ratio) (n : N) : bool := 4 * Npos (num q) <=? 3 * Npos (den q) * ((n - 2) * (n - 2)).

(** N(q) >= n, or not; None: these numbers do not tell. Two collisions there always are, and at q = 1 no more. *)
Definition reaches (w : numbers) (q : ratio) (n : N) : option bool :=
  if n <=? 2 then Some true else if ratio_eq q one || far_above q n then Some false else
  let k := collisions_for n in
  if most_steps <? k then None else
  if at_least_with w (orbit_for n) (fuel k) q then Some true else
  if at_most_with w (orbit_for n) (fuel (N.pred k)) q then Some false else None.

(** The budget: a million collisions in double precision; with b bits as many fewer as b/16 has squared. *)
Definition affordable (n : N) (w : numbers) : bool :=
  match w with Machine_doubles => true | Bits b => collisions_for n * (b * b) <=? 256 * most_steps end.
Definition attempts (n : N) : list numbers :=
  filter (affordable n) [Machine_doubles; Bits 128; Bits 256; Bits 512; Bits 1024; Bits 2048].
Fixpoint first_answer (l : list numbers) (q : ratio) (n : N) : option (numbers * bool) :=
  match l with
  | [] => None
  | w :: l => match reaches w q n with Some yes => Some (w, yes) | None => first_answer l q n end
  end.
Definition decide (q : ratio) (n : N) : option (numbers * bool) := first_answer (attempts n) q n.

(** A claim about every mass ratio of a range, and what is found: it is true, by these numbers; it is false, as N(q) >= n
    at this ratio, or is not. *)
Record claim := { claimed_from : ratio; claimed_to : ratio; claimed_most : option N; claimed_least : option N }.
Inductive finding := True_by (for_most for_least : numbers) | False_at (q : ratio) (n : N) (reached : bool) | Not_decided.
Definition settle_least (c : claim) (for_most : numbers) : finding :=
  match claimed_least c with
  | None => True_by for_most Machine_doubles
  | Some n => match decide (claimed_from c) n with
              | Some (w, true) => True_by for_most w
              | Some (_, false) => False_at (claimed_from c) n false
              | None => Not_decided
              end
  end.
Definition proper_range (c : claim) : bool := ratio_le one (claimed_from c) && ratio_le (claimed_from c) (claimed_to c).
Definition settle (c : claim) : finding :=
  if negb (proper_range c) then Not_decided else
  match claimed_most c with
  | None => settle_least c Machine_doubles
  | Some n => match decide (claimed_to c) (N.succ n) with
              | Some (w, false) => settle_least c w
              | Some (_, true) => False_at (claimed_to c) (N.succ n) true
              | None => Not_decided
              end
  end.

(** For the kernel, which is told which numbers are enough. *)
Definition answers (w : numbers) (q : ratio) (n : N) (yes : bool) : bool :=
  match reaches w q n with Some b => eqb b yes | None => false end.
Definition holds (for_most for_least : numbers) (c : claim) : bool :=
  proper_range c &&
  match claimed_most c with None => true | Some n => answers for_most (claimed_to c) (N.succ n) false end &&
  match claimed_least c with None => true | Some n => answers for_least (claimed_from c) n true end.
