(* Claims decided without a certificate, by two orbits, and where those are too long, by the law: what is found is proved in
   exact/Decided.v and law/DecidedByLaw.v. *)
open Convert

let claim (lo, hi) most least = { C.claimed_from = lo; claimed_to = hi; claimed_most = most; claimed_least = least }
let settle range most least = C.settle (claim range most least)

let bits v w =
  let of_numbers = function C.Machine_doubles -> C.Npos (C.XI (C.XO (C.XI (C.XO (C.XI C.XH))))) | C.Bits b -> b in
  decimal (C.N.max (of_numbers v) (of_numbers w))

let refuted q n reached =
  Printf.sprintf "s REJECTED code=false N(q) is %s %s at q = %s" (if reached then "at least" else "less than") (decimal n)
    (Demand.ratio_text q)

(* What no orbit decides within its budget. *)
let examine_by_law (o : Demand.t) range =
  let d = o.asked in
  match C.by_law (claim range d.C.asked_most d.C.asked_least) with
  | C.Holds ->
    Option.iter (fun folder -> Coq_term.write_claim folder range d.C.asked_most d.C.asked_least Coq_term.By_law) o.term;
    "s VERIFIED scene=dumbbell by=law" ^ Demand.text d
  | C.Fails (q, n, reached) -> raise (Ended (1, refuted q n reached))
  | C.Unknown -> raise (Ended (4, "s LIMIT an orbit with more than a million collisions, or more bits than the budget allows; too near \
a step for the law, or one of the first 900"))

(* The verdict on the demand alone. *)
let examine (o : Demand.t) =
  let d = o.asked in
  let range = Option.get d.C.asked_range in
  match settle range d.C.asked_most d.C.asked_least with
  | C.True_by (v, w) ->
    Option.iter (fun folder -> Coq_term.write_claim folder range d.C.asked_most d.C.asked_least (Coq_term.By_orbits (v, w))) o.term;
    Printf.sprintf "s VERIFIED scene=dumbbell by=orbits bits=%s%s" (bits v w) (Demand.text d)
  | C.False_at (q, n, reached) -> raise (Ended (1, refuted q n reached))
  | C.Not_decided -> examine_by_law o range

(* Beside the verdict on a file: does what it proves need the file? *)
let remark range most least =
  match settle range most least with
  | C.True_by _ -> "a theorem without a file, too: two orbits prove the same bounds"
  | C.Not_decided -> "the orbits do not decide these bounds within their budget"
  | C.False_at (q, n, reached) -> raise (Ended (1, refuted q n reached ^ ", against this file: please report it"))
