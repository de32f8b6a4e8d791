(* A certificate as Coq terms, for the kernel: --term FOLDER writes Part1.v, Part2.v, ... of at most 200 pieces each, and Whole.v with
   the theorem, `given` what law/Bases.v proves; of a claim without a certificate only Whole.v. It is not trusted: what is proved stands
   in the theorem, which coqc prints. *)
open Convert

let pieces_a_part = 200

let integer z = match z with
  | C.Z0 -> "0"
  | C.Zpos p -> decimal (C.Npos p)
  | C.Zneg p -> "(-" ^ decimal (C.Npos p) ^ ")"
let ratio r = Printf.sprintf "(Build_ratio %s %s)" (decimal (C.Npos r.C.num)) (decimal (C.Npos r.C.den))
let dyadic d = Printf.sprintf "(Build_dyadic %s %s)" (decimal d.C.odd_part) (integer d.C.exponent)

let rec tree b = function
  | C.Leaf (C.Count (x, y)) -> Printf.bprintf b "(count %s %s)" (decimal x) (decimal y)
  | C.Leaf (C.Forward x) -> Printf.bprintf b "(Leaf (Forward %s))" (decimal x)
  | C.Leaf (C.Plain x) -> Printf.bprintf b "(Leaf (Plain %s))" (decimal x)
  | C.Leaf C.Once -> Buffer.add_string b "(Leaf Once)"
  | C.Leaf C.Outside -> Buffer.add_string b "out"
  | C.Leaf C.Meets -> Buffer.add_string b "(Leaf Meets)"
  | C.Leaf C.Meets_reversed -> Buffer.add_string b "(Leaf Meets_reversed)"
  | C.Split (axis, l, u) ->
    Buffer.add_string b (match axis with C.Axis_e -> "(half_e " | C.Axis_slope -> "(half_y " | C.Axis_q -> "(half_q ");
    tree b l;
    Buffer.add_char b ' ';
    tree b u;
    Buffer.add_char b ')'

let charts b u name trees =
  Printf.bprintf b "(Some (%s, %s" (decimal u) name;
  List.iter (fun t -> Buffer.add_char b ' '; tree b t) trees;
  Buffer.add_string b "))"

let piece b p =
  Printf.bprintf b "(Build_piece %s %s %s " (ratio p.C.from) (ratio p.C.to0) (decimal p.C.bits);
  (match p.C.bound with
   | None -> Buffer.add_string b "None"
   | Some (u, C.Equal_masses) -> Printf.bprintf b "(Some (%s, Equal_masses))" (decimal u)
   | Some (u, C.Charts (bridge, light)) -> charts b u "Charts" [bridge; light]
   | Some (u, C.Full_charts (contact, departure, again)) -> charts b u "Full_charts" [contact; departure; again]);
  Printf.bprintf b " %s " (decimal p.C.attained);
  (match p.C.witness with
   | None -> Buffer.add_string b "None"
   | Some w -> Printf.bprintf b "(Some (Build_contact %s %s %s %s))" (dyadic w.C.contact_e) (dyadic w.C.contact_eta)
                 (decimal w.C.after_X) (decimal w.C.after_reversed));
  Buffer.add_char b ')'

let rec parts l =
  let rec first n = function
    | x :: l when n > 0 -> let a, rest = first (n - 1) l in x :: a, rest
    | l -> [], l in
  if l = [] then [] else let a, rest = first pieces_a_part l in a :: parts rest

let write folder name text =
  let channel = open_out (Filename.concat folder name) in
  output_string channel text;
  close_out channel

let write_part folder k l =
  let b = Buffer.create 100000 in
  Buffer.add_string b "From Coq Require Import ZArith NArith List.\nFrom Dumbbell.checker Require Import Certificate Check.\nFrom Dumbbell.theorems Require Import Verdict.\n\
Import ListNotations.\nLocal Open Scope N_scope.\n\
Local Notation count a b := (Leaf (Count a b)).\nLocal Notation out := (Leaf Outside).\n\
Local Notation half_e := (Split axis_e).\nLocal Notation half_y := (Split axis_slope).\nLocal Notation half_q := (Split axis_q).\n\
Definition part : list piece := [\n";
  List.iteri (fun i p -> if i > 0 then Buffer.add_string b ";\n"; piece b p) l;
  Buffer.add_string b "].\nLemma part_holds : faultless part = true.\nProof. vm_cast_no_check (eq_refl true). Qed.\n";
  write folder (Printf.sprintf "Part%d.v" k) (Buffer.contents b)

let count n = decimal n ^ "%N"
let option f = function None -> "None" | Some x -> "(Some " ^ f x ^ ")"

(* What is said of every mass ratio between two, as Coq states it. *)
let fraction n d = Printf.sprintf "%s / %s" (decimal n) (decimal (C.Npos d))
let value r = fraction (C.Npos r.C.num) r.C.den
let statement (from, upto) most least once =
  let bound which = function Some n -> [Printf.sprintf "%s_bound q (N.to_nat %s)" which (count n)] | None -> [] in
  let said = bound "upper" most @ bound "lower" least @ if once then ["heavy_once q"] else [] in
  Printf.sprintf "(forall q : R, %s <= q <= %s -> %s)" (value from) (value upto)
    (if said = [] then "1 <= q" else String.concat " /\\ " said)
(* What was asked of the gaps: the end of the statement, and the beginning of its proof. *)
let about_gaps (from, upto) d =
  let width (n, e) = Printf.sprintf " /\\ (forall x y, In (x, y) gaps -> y - x <= %s * x)" (fraction n e) in
  let number n = Printf.sprintf " /\\ (List.length gaps <= N.to_nat %s)%%nat" (count n) in
  let said words = function Some x -> words x | None -> "" in
  if d.C.asked_gap = None && d.C.asked_gaps = None then "", ""
  else
    Printf.sprintf " /\\\n  exists gaps, known_but_in gaps (pieces whole) (%s) (%s)%s%s" (value from) (value upto)
      (said width d.C.asked_gap) (said number d.C.asked_gaps),
    "  split; [|destruct (gaps_as_asked _ _ (accepted B)) as [gaps [K [W L]]]; [reflexivity|]; exists gaps; repeat apply conj;\n\
    (exact K || exact (W _ _ eq_refl) || exact (L _ eq_refl))].\n"
type how = By_orbits of C.numbers * C.numbers | By_law

let write_claim folder (from, upto) most least how =
  let numbers = function C.Machine_doubles -> "Machine_doubles" | C.Bits b -> "(Bits " ^ count b ^ ")" in
  let computed, answer, used = match how with
    | By_orbits (v, w) -> Printf.sprintf "holds %s %s asked" (numbers v) (numbers w), "true", "orbits _ _ _"
    | By_law -> "by_law asked", "Holds", "law _" in
  write folder "Whole.v" (Printf.sprintf "From Coq Require Import Reals NArith.\n\
From Dumbbell.statement Require Import Statement.\nFrom Dumbbell.checker Require Import Certificate Decide ByLaw.\n\
From Dumbbell.exact Require Import Decided.\nFrom Dumbbell.law Require Import Bases.\n\
Definition asked : claim := Build_claim %s %s %s %s.\n\
Lemma accepted : %s = %s.\nProof. vm_cast_no_check (eq_refl %s). Qed.\nLocal Open Scope R_scope.\n\
Theorem given : bases -> %s.\nProof.\n\
  intros [orbits [law _]] q Hq. destruct (%s accepted q Hq) as [U V].\n\
  repeat split; (apply U || apply V); reflexivity.\nQed.\n"
    (ratio from) (ratio upto) (option count most) (option count least) computed answer answer
    (statement (from, upto) most least false) used)

let write_all folder demand c =
  let l = parts c.C.pieces in
  List.iteri (fun i part -> write_part folder (i + 1) part) l;
  let names = List.mapi (fun i _ -> Printf.sprintf "Part%d" (i + 1)) l in
  let from, upto = match demand.C.asked_range with Some r -> r | None -> c.C.range_from, c.C.range_to in
  let said, most, least = match demand.C.asked_most, demand.C.asked_least with
    | None, None -> "the file", C.greatest c.C.pieces, Some (C.least c.C.pieces)
    | most, least -> "the demand", most, least in
  let gaps, of_gaps = about_gaps (from, upto) demand in
  write folder "Whole.v" (Printf.sprintf "From Coq Require Import Reals ZArith NArith List String Lra.\n\
From Dumbbell.statement Require Import Statement.\nFrom Dumbbell.checker Require Import Certificate Check.\n\
From Dumbbell.upper Require Import AtMostOnce.\nFrom Dumbbell.theorems Require Import Piece KnownButInGaps Verdict.\n\
From Dumbbell.law Require Import Bases.\nFrom Kernel Require %s.\nImport ListNotations.\n\
Definition whole : certificate := Build_certificate \"%s\" \"%s\" %s %s %s (%s).\n\
(** As asked; what is not asked of it is what %s says. *)\n\
Definition asked : demand := Build_demand (Some (%s, %s)) %s %s %s %s %b.\n\
Lemma accepted : bases -> proved asked whole.\nProof.\n  intros [_ [_ parts]]. apply parts.\n  - vm_cast_no_check (eq_refl true).\n\
  - discriminate.\n  - unfold whole; cbn [pieces]. rewrite ?faultless_app%s. reflexivity.\n\
  - vm_cast_no_check (eq_refl (@None string)).\nQed.\nLocal Open Scope R_scope.\n\
Theorem given : bases -> %s%s.\nProof.\n  intros B.\n%s  intros q Hq.\n\
  destruct (as_asked _ _ (accepted B) q) as [U [V W]]; [exact Hq|].\n\
  repeat apply conj; (apply U || apply V || apply W); reflexivity.\nQed.\n"
    (String.concat " " names) (of_coq c.C.program) (of_coq c.C.program_version)
    (match c.C.about with C.Turning -> "turning" | C.Full -> "full" | C.Full_minimal -> "full_minimal") (ratio c.C.range_from) (ratio c.C.range_to)
    (String.concat " ++ " (List.map (fun n -> n ^ ".part") names)) said
    (ratio from) (ratio upto) (option count most) (option count least)
    (option (fun (n, e) -> Printf.sprintf "(%s, %s%%positive)" (count n) (decimal (C.Npos e))) demand.C.asked_gap)
    (option count demand.C.asked_gaps) demand.C.asked_once
    (String.concat "" (List.map (fun n -> ", " ^ n ^ ".part_holds") names))
    (statement (from, upto) most least demand.C.asked_once) gaps of_gaps)
