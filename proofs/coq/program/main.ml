(* The extracted checker as a program. Trusted is that it gives the checker the lines of the file and the demand of the user, and prints
   what the checker answers; what a file says, and whether it is proved, is decided in the extracted code (theorems/Verdict.v). *)
open Convert

let ratio r = of_coq (C.ratio_text r)

(* What was demanded, as in the verdict line of dumbbell-verify. *)
let demanded d =
  let count name = function Some n -> Printf.sprintf " %s=%s" name (decimal n) | None -> "" in
  (match d.C.asked_range with Some (lo, hi) -> Printf.sprintf " demanded-ratio=%s:%s" (ratio lo) (ratio hi) | None -> "")
  ^ if d.C.asked_most <> None && d.C.asked_most = d.C.asked_least then count "exactly" d.C.asked_most
    else count "max" d.C.asked_most ^ count "min" d.C.asked_least

let claim c digest =
  let l = c.C.pieces in
  Printf.sprintf "scene=dumbbell ratio=%s:%s upper=%s lower=%s gaps=%s open=%s%s sha256=%s"
    (ratio c.C.range_from) (ratio c.C.range_to) (match C.greatest l with Some u -> decimal u | None -> "none")
    (decimal (C.least l)) (decimal (C.how_many C.is_gap l)) (decimal (C.how_many C.is_open l))
    (if C.says_heavy_once c then " heavy-at-most=1" else "") digest

(* No bound is demanded, and none is proved of all the ratios in question: whether there is one is asked of the checker, as a demand. *)
let says_nothing d c =
  let proves most least = C.unproved { d with C.asked_most = most; C.asked_least = least } c = None in
  let greatest_of_any = List.fold_left (fun n p -> match p.C.bound with Some (u, _) -> C.N.max n u | None -> n) C.N0 c.C.pieces in
  d.C.asked_most = None && d.C.asked_least = None
  && not (proves (Some greatest_of_any) None || proves None (Some (C.Npos C.XH)))

let examine (o : Demand.t) path =
  let lines, digest = Text.lines path in
  let place k = match int_of_nat k with 0 -> "" | k -> Printf.sprintf "line=%d " k in
  match C.judge (List.map to_coq lines) (to_coq digest) o.asked with
  | C.Verified c -> Option.iter (fun folder -> Coq_term.write_all folder o.asked c) o.term;
    let line = claim c digest ^ demanded o.asked in
    if says_nothing o.asked c then raise (Ended (3, "s OPEN " ^ line)) else "s VERIFIED " ^ line
  | C.Rejected (k, why) -> raise (Ended (1, "s REJECTED " ^ place k ^ of_coq why))
  | C.Unsupported (k, why) -> raise (Ended (3, "s UNSUPPORTED " ^ place k ^ of_coq why))
  | C.Limit why -> raise (Ended (4, "s LIMIT " ^ of_coq why))

let verdict o path =
  try 0, examine o path with
  | Ended (code, line) -> code, line
  | Stack_overflow | Out_of_memory -> 4, "s LIMIT out of memory"

(* Of several exit codes the first of 1, 4, 3, 2, 5, 0. *)
let worse a b =
  let rank = function 1 -> 5 | 4 -> 4 | 3 -> 3 | 2 -> 2 | 5 -> 1 | _ -> 0 in
  if rank a >= rank b then a else b

let run words =
  let o = Demand.parse [] Demand.nothing words in
  let several = List.length o.files > 1 in
  let next code file =
    let one, line = verdict o file in
    print_endline (if several then line ^ " file=" ^ file else line);
    worse code one in
  List.fold_left next 0 o.files

let () =
  exit (try run (List.tl (Array.to_list Sys.argv)) with
      | Ended (code, message) -> prerr_endline ("prove: " ^ message); code
      | Sys_error message -> prerr_endline ("prove: " ^ message); 2)
