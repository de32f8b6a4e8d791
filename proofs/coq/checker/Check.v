(** The checker of a certificate: every leaf and witness in double precision, and what does not hold there with the
    piece's bits; that the pieces join; and whether together they prove what was asked. Its answer is proved in
    theorems/Verdict.v.

    leaf_holds, contact_holds, piece_fault   == a leaf, a witness, a piece is right: by doubles, or with its bits
    joined, covered                          == the pieces join; the good ones among them cover a range
    demand, unproved                         == what was asked; what of it the pieces do not prove
    certificate_fault                        == the first fault of a certificate, or None
    greatest, least, says_heavy_once, how_many == what a verdict says beside: bounds, the heavy mass, pieces of a kind *)
From Coq Require Import ZArith NArith List Bool String DecimalString DecimalN.
From Dumbbell Require Import Certificate Gaps Doubles Multiple.
Import ListNotations.
Local Open Scope string_scope.

Definition decimal (n : N) : string := NilZero.string_of_uint (N.to_uint n).
Definition one : ratio := {| num := 1; den := 1 |}.

(** [bits P] is at least 53 in a file, as many as a double has. Doubles may lose where 53 bits do not: their enclosures
    go to the next double after each operation, also where it is exact. So both are tried, in pieces of 53 bits, too:
    the bits [again], if wanted. *)
Section Again.
Variable again : bool.
Definition leaf_holds (P : piece) (U : N) (c : chart) (b : box) (why : reason) : bool :=
  if Doubles.check_leaf U c b why then true else if again then Multiple.check_leaf (bits P) U c b why else false.
Definition contact_holds (P : piece) (V : N) (b : box) (w : contact) : bool :=
  (if Doubles.above_corner b w then true else if again then Multiple.above_corner (bits P) b w else false) &&
  if Doubles.check_contact V b w then true else if again then Multiple.check_contact (bits P) V b w else false.

(** What is wrong with a piece; None: nothing. *)
Definition chart_name (c : chart) : string :=
  match c with
  | Bridge => "bridge"
  | Light => "light"
  | Contact => "contact"
  | Departure => "departure"
  | Again => "again"
  end.
Definition chart_fault (P : piece) (U : N) (c : chart) (t : tree) : option string :=
  if check_tree (leaf_holds P U c) (chart_box c (from P) (to P)) t then None
  else Some ("chart " ++ chart_name c ++ ": not certified").
Definition first_of (a b : option string) : option string := match a with Some why => Some why | None => b end.
Definition cover_fault (P : piece) (U : N) (c : cover) : option string :=
  if (U <? attained P)%N then Some "lower above upper" else
  match c with
  | Equal_masses => if ratio_eq (from P) one && ratio_eq (to P) one && (2 <=? U)%N then None else
    Some "equal-masses: not certified"
  | Charts bridge light =>
    if negb (wide_enough (to P)) then Some "its root box" else
    first_of (chart_fault P U Bridge bridge) (chart_fault P U Light light)
  | Full_charts contact departure again =>
    if negb (wide_enough (one_more (to P))) || (U =? 0)%N then Some "its root box" else
    first_of (chart_fault P U Contact contact)
      (first_of (chart_fault P U Departure departure) (chart_fault P U Again again))
  end.
Definition witness_fault (P : piece) : option string :=
  match witness P with
  | Some w => if contact_holds P (attained P) (chart_box Bridge (from P) (to P)) w then None else
    Some "witness: not certified"
  | None => if (attained P =? 0)%N then None else Some "no witness"
  end.
Definition piece_fault (P : piece) : option string :=
  if negb (ratio_le one (from P)) || negb (ratio_le (from P) (to P)) then Some "not 1 <= A <= B" else
  match match bound P with Some (U, c) => cover_fault P U c | None => None end with
  | Some why => Some why
  | None => witness_fault P
  end.
Fixpoint first_fault (number : N) (l : list piece) : option string :=
  match l with
  | [] => None
  | P :: l => match piece_fault P with Some why => Some ("piece " ++ decimal number ++ ": " ++ why) | None =>
    first_fault (number + 1) l end
  end.
End Again.

(** Each piece begins where the one before it ends. *)
Fixpoint joined (start : ratio) (l : list piece) (stop : ratio) : bool :=
  match l with [] => ratio_eq start stop | P :: l => ratio_eq start (from P) && joined (to P) l stop end.

(** Do the pieces that are good for it cover [a, b]? They come in increasing order. *)
Definition arrive (good : piece -> bool) (a : ratio) (reached : option ratio) (P : piece) : option ratio :=
  if good P && match reached with Some x => ratio_le (from P) x | None => ratio_le (from P) a &&
    ratio_le a (to P) end then Some (to P) else reached.
Definition covered (good : piece -> bool) (a b : ratio) (l : list piece) : bool :=
  match fold_left (arrive good a) l None with Some x => ratio_le b x | None => false end.

(** What is asked of each mass ratio in the range (else that of the file): at most, and at least, a number of
  collisions; the greatest number itself, but in gaps of at most a relative width n/d, and in how many; and that the
  heavy mass hits the floor at most once. *)
Record demand := { asked_range : option (ratio * ratio); asked_most : option N; asked_least : option N;
  asked_gap : option (N * positive); asked_gaps : option N; asked_once : bool }.
Definition at_most_in (n : N) (P : piece) : bool := match bound P with Some (U, _) => (U <=? n)%N | None => false end.
Definition at_least_in (n : N) (P : piece) : bool := (n <=? attained P)%N.
Definition range_asked (d : demand) (c : certificate) : ratio * ratio := match asked_range d with Some r => r | None =>
  (range_from c, range_to c) end.
Definition if_asked {A} (asked : option A) (holds : A -> bool) : bool :=
  match asked with Some x => holds x | None => true end.
Definition asks_of_gaps (d : demand) : bool :=
  match asked_gap d, asked_gaps d with None, None => false | _, _ => true end.
Definition known_but_in_gaps (d : demand) (a b : ratio) (l : list piece) : bool :=
  if ratio_le b a then known_at a l else
  covered (concerns a b) a b l && forallb (fun P => negb (concerns a b P && is_open P)) l &&
  if_asked (asked_gap d) (fun w => forallb (narrow w) (gaps a b l)) &&
  if_asked (asked_gaps d) (fun n => (N.of_nat (List.length (gaps a b l)) <=? n)%N).
(** Does the file say that the heavy mass hits the floor at most once? That needs no certificate: it is true of every
    q >= 1 (AtMostOnce.L6c_heavy_at_most_once). *)
Definition says_heavy_once (c : certificate) : bool :=
  match about c with
  | turning => false
  | full | full_minimal => forallb (fun P => match bound P with Some _ => true | None => false end) (pieces c)
  end.
Definition unless (holds : bool) (why : string) : option string := if holds then None else Some why.
Definition unproved (d : demand) (c : certificate) : option string :=
  let '(a, b) := range_asked d c in
  let l := pieces c in
  first_of (unless (covered (fun _ => true) a b l) "the file does not cover the mass ratios that were asked for")
  (first_of (unless (if_asked (asked_most d) (fun n => covered (at_most_in n) a b l))
    "not proved: the greatest number of collisions that was asked for")
  (first_of (unless (if_asked (asked_least d) (fun n => covered (at_least_in n) a b l))
    "not proved: the least number of collisions that was asked for")
  (first_of (unless (negb (asks_of_gaps d) || known_but_in_gaps d a b l)
    "not proved: the greatest number itself, but in the gaps that were asked for")
  (unless (negb (asked_once d) || says_heavy_once c) "not proved: the heavy mass hits the floor at most once")))).

Definition certificate_fault (again : bool) (d : demand) (c : certificate) : option string :=
  if negb (joined (range_from c) (pieces c) (range_to c)) then Some "the pieces do not join" else
  match pieces c with [] => Some "no piece" | _ =>
    match first_fault again 1 (pieces c) with Some why => Some why | None => unproved d c end
  end.

(** What the file says: the greatest upper bound, if each piece has one, and the least lower one. *)
Definition greatest (l : list piece) : option N :=
  fold_left (fun u P => match u, bound P with Some u, Some (v, _) => Some (N.max u v) | _, _ => None end) l (Some 0%N).
Definition least (l : list piece) : N := match l with [] => 0%N | P :: l => fold_left (fun v Q =>
  N.min v (attained Q)) l (attained P) end.
Definition how_many (p : piece -> bool) (l : list piece) : N := fold_left (fun n P => if p P then N.succ n else
  n) l 0%N.
