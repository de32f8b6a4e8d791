(* The extracted checker as a program. Trusted is that it gives the checker the lines of the file and the demand of the user, and prints
   what the checker answers; what a file says, and whether it is proved, is decided in the extracted code (theorems/Verdict.v). *)
open Convert

let claim c digest =
  let l = c.C.pieces in
  Printf.sprintf "scene=dumbbell ratio=%s:%s upper=%s lower=%s gaps=%s open=%s%s sha256=%s"
    (Demand.ratio_text c.C.range_from) (Demand.ratio_text c.C.range_to) (match C.greatest l with Some u -> decimal u | None -> "none")
    (decimal (C.least l)) (decimal (C.how_many C.is_gap l)) (decimal (C.how_many C.is_open l))
    (if C.says_heavy_once c then " heavy-at-most=1" else "") digest

(* No bound is demanded, and none is proved of all the ratios in question: whether there is one is asked of the checker, as a demand. *)
let says_nothing d c =
  let proves most least = C.unproved { d with C.asked_most = most; C.asked_least = least } c = None in
  let greatest_of_any = List.fold_left (fun n p -> match p.C.bound with Some (u, _) -> C.N.max n u | None -> n) C.N0 c.C.pieces in
  d.C.asked_most = None && d.C.asked_least = None
  && not (proves (Some greatest_of_any) None || proves None (Some (C.Npos C.XH)))

(* What the file proves, or was asked to, by the orbits alone. *)
let beside d c =
  let range = match d.C.asked_range with Some r -> r | None -> c.C.range_from, c.C.range_to in
  match d.C.asked_most, d.C.asked_least with
  | None, None -> Orbits.remark range (C.greatest c.C.pieces) (Some (C.least c.C.pieces))
  | most, least -> Orbits.remark range most least

let examine (o : Demand.t) path =
  let lines, digest = Text.lines path in
  let place k = match int_of_nat k with 0 -> "" | k -> Printf.sprintf "line=%d " k in
  match C.judge (List.rev (List.rev_map to_coq lines)) (to_coq digest) o.asked with
  | C.Verified c -> Option.iter (fun folder -> Coq_term.write_all folder o.asked c) o.term;
    let line = claim c digest ^ Demand.text o.asked in
    if says_nothing o.asked c then raise (Ended (3, "s OPEN " ^ line));
    prerr_endline ("prove: " ^ path ^ ": " ^ beside o.asked c);
    "s VERIFIED " ^ line
  | C.Rejected (k, why) -> raise (Ended (1, "s REJECTED " ^ place k ^ of_coq why))
  | C.Unsupported (k, why) ->
    if List.mem "claim law" lines then
      prerr_endline ("prove: " ^ path ^ ": the law is a theorem that needs no file (Law.law): --ratio Q --exactly N asks it of a mass ratio");
    raise (Ended (3, "s UNSUPPORTED " ^ place k ^ of_coq why))
  | C.Limit why -> raise (Ended (4, "s LIMIT " ^ of_coq why))

let verdict examine =
  try 0, examine () with
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
    let one, line = verdict (fun () -> examine o file) in
    print_endline (if several then line ^ " file=" ^ file else line);
    worse code one in
  if o.files <> [] then List.fold_left next 0 o.files
  else begin
    let code, line = verdict (fun () -> Orbits.examine o) in
    print_endline line;
    code
  end

let () =
  exit (try run (List.tl (Array.to_list Sys.argv)) with
      | Ended (code, message) -> prerr_endline ("prove: " ^ message); code
      | Sys_error message -> prerr_endline ("prove: " ^ message); 2)
