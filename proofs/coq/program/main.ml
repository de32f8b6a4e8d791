(* The command line of the extracted checker. Trusted is only that it gives the checker the lines of the file and the demand of the
   user, and prints what the checker answers; what a file says, and whether it is proved, is decided in the extracted code. *)
module C = Checker

exception Failure_of_file of int * string (* exit code, the verdict line *)

(* Between OCaml's strings and numbers and those of the extracted code. *)
let ascii = Array.init 256 (fun n ->
    let bit k = n land (1 lsl k) <> 0 in
    C.Ascii (bit 0, bit 1, bit 2, bit 3, bit 4, bit 5, bit 6, bit 7))
let to_coq s =
  let rec go i l = if i < 0 then l else go (i - 1) (C.String (ascii.(Char.code s.[i]), l)) in
  go (String.length s - 1) C.EmptyString
let of_coq s =
  let b = Buffer.create 80 in
  let rec go = function
    | C.EmptyString -> Buffer.contents b
    | C.String (C.Ascii (b0, b1, b2, b3, b4, b5, b6, b7), l) ->
      let code = List.fold_right (fun bit n -> 2 * n + Bool.to_int bit) [b0; b1; b2; b3; b4; b5; b6; b7] 0 in
      Buffer.add_char b (Char.chr code); go l
  in
  go s
let rec int_of_nat = function C.O -> 0 | C.S n -> 1 + int_of_nat n
let decimal n = of_coq (C.decimal n)

(* A number of a claim: at most 18 digits, as dumbbell-verify reads it. *)
let usage message = raise (Failure_of_file (2, message))
let is_digits s = s <> "" && String.for_all (fun c -> '0' <= c && c <= '9') s
let number option s =
  let fits = is_digits s && String.length s <= 18 && (s.[0] <> '0' || s = "0") in
  match if fits then C.natural (to_coq s) else None with
  | Some n -> n
  | None -> usage (option ^ " needs a number from 0 to 999999999999999999, not `" ^ s ^ "`")

(* P/Q, or a decimal with an exponent, as a fraction in lowest terms. *)
let ratio s =
  let bad () = usage ("not a mass ratio: `" ^ s ^ "`") in
  let strip s = (* without leading zeros *)
    let rec from i = if i < String.length s - 1 && s.[i] = '0' then from (i + 1) else String.sub s i (String.length s - i) in from 0 in
  let fraction a b = match C.ratio_of (to_coq (strip a ^ "/" ^ strip b)) with Some r -> C.lowest_terms r | None -> bad () in
  if String.length s > 1000 then bad ();
  match String.split_on_char '/' s with
  | [a; b] when is_digits a && is_digits b -> fraction a b
  | [_] ->
    let mantissa, exponent = match String.split_on_char 'e' (String.lowercase_ascii s) with
      | [m] -> m, 0
      | [m; e] ->
        let digits = if e <> "" && (e.[0] = '+' || e.[0] = '-') then String.sub e 1 (String.length e - 1) else e in
        if not (is_digits digits && String.length (strip digits) <= 4 && int_of_string (strip digits) <= 1000) then bad ();
        m, (if e.[0] = '-' then -1 else 1) * int_of_string (strip digits)
      | _ -> bad () in
    let whole, part = match String.split_on_char '.' mantissa with [w] -> w, "" | [w; p] when is_digits p -> w, p | _ -> bad () in
    if not (is_digits whole) then bad ();
    let shift = exponent - String.length part in
    fraction (whole ^ part ^ String.make (max 0 shift) '0') ("1" ^ String.make (max 0 (- shift)) '0')
  | _ -> bad ()
let inverse r = { C.num = r.C.den; C.den = r.C.num }
let one = { C.num = C.XH; C.den = C.XH }
let ratios s =
  let lo, hi = match String.split_on_char ':' s with
    | [a] -> let r = ratio a in r, r
    | [a; b] -> ratio a, ratio b
    | _ -> usage ("not LO:HI: `" ^ s ^ "`") in
  if not (C.ratio_le lo hi) then usage ("LO:HI needs LO <= HI: " ^ s);
  if C.ratio_le one lo then lo, hi
  else if C.ratio_le hi one then inverse hi, inverse lo
  else usage ("a range across 1: split it at 1: " ^ s)

(* The bytes of a file, or what gzip makes of them. *)
let contents path =
  let unreadable why = raise (Failure_of_file (2, "s UNREADABLE " ^ why)) in
  let bytes = try
      let channel = open_in_bin path in
      Fun.protect ~finally:(fun () -> close_in channel) (fun () -> really_input_string channel (in_channel_length channel))
    with Sys_error why -> unreadable why | End_of_file -> unreadable "it became shorter" in
  if String.length bytes >= 2 && String.sub bytes 0 2 = "\x1f\x8b" then begin
    let channel = Unix.open_process_in ("gzip -dcq < " ^ Filename.quote path) in
    let b = Buffer.create 65536 in
    (try while true do Buffer.add_channel b channel 1 done with End_of_file -> ());
    let length = Buffer.length b and at k = Char.code bytes.[String.length bytes - 4 + k] in
    let one_member = String.length bytes > 18 && at 0 lor (at 1 lsl 8) lor (at 2 lsl 16) lor (at 3 lsl 24) = length land 0xffffffff in
    if Unix.close_process_in channel <> Unix.WEXITED 0 || not one_member then
      raise (Failure_of_file (1, "s REJECTED code=gzip the compressed file is damaged, or not one gzip member"));
    Buffer.contents b
  end else bytes

(* SHA-256 of a text by sha256sum. *)
let sha256 text =
  let out_channel, input = let inp, out = Unix.open_process "sha256sum" in out, inp in
  output_string out_channel text; close_out out_channel;
  let line = try input_line input with End_of_file -> "" in
  if Unix.close_process (input, out_channel) <> Unix.WEXITED 0 || String.length line < 64 then
    raise (Failure_of_file (4, "s LIMIT sha256sum does not run"));
  String.sub line 0 64

let verdict demand path =
  let text = contents path in
  let n = String.length text in
  let reject why = raise (Failure_of_file (1, "s REJECTED " ^ why)) in
  if n = 0 || text.[n - 1] <> '\n' then reject "code=truncated the text ends too early, or without a line feed";
  let start = match String.rindex_from_opt text (max 0 (n - 2)) '\n' with Some k -> k + 1 | None -> 0 in
  let digest = sha256 (String.sub text 0 start) in
  let lines = String.split_on_char '\n' (String.sub text 0 (n - 1)) in
  let place k = match int_of_nat k with 0 -> "" | k -> Printf.sprintf "line=%d " k in
  match C.judge (List.map to_coq lines) (to_coq digest) demand with
  | C.Verified c ->
    let l = c.C.pieces and ratio r = of_coq (C.ratio_text r) in
    Printf.sprintf "s VERIFIED scene=dumbbell ratio=%s:%s upper=%s lower=%s gaps=%s open=%s sha256=%s"
      (ratio c.C.range_from) (ratio c.C.range_to) (match C.greatest l with Some u -> decimal u | None -> "none") (decimal (C.least l))
      (decimal (C.how_many C.is_gap l)) (decimal (C.how_many C.is_open l)) digest
  | C.Rejected (k, why) -> reject (place k ^ of_coq why)
  | C.Unsupported (k, why) -> raise (Failure_of_file (3, "s UNSUPPORTED " ^ place k ^ of_coq why))
  | C.Limit why -> raise (Failure_of_file (4, "s LIMIT " ^ of_coq why))

let examine demand path =
  try 0, verdict demand path with
  | Failure_of_file (code, line) -> code, line
  | Stack_overflow | Out_of_memory -> 4, "s LIMIT out of memory"

type options = { mutable files : string list; mutable range : (C.ratio * C.ratio) option; mutable most : C.n option; mutable least : C.n option }

(* --name VALUE or --name=VALUE; after -- only files. *)
let parse words =
  let o = { files = []; range = None; most = None; least = None } and seen = Hashtbl.create 8 in
  let rec go = function
    | [] -> ()
    | "--" :: files -> o.files <- List.rev_append files o.files
    | word :: rest when String.length word > 1 && word.[0] = '-' ->
      let name, rest = match String.index_opt word '=' with
        | Some k -> String.sub word 0 k, String.sub word (k + 1) (String.length word - k - 1) :: rest
        | None -> word, rest in
      if not (List.mem name ["--ratio"; "--max"; "--min"; "--exactly"]) then
        usage ("unknown option " ^ name ^ "; known are --ratio, --max, --min, --exactly and --kernel");
      if Hashtbl.mem seen name then usage (name ^ " is given twice");
      Hashtbl.add seen name ();
      if Hashtbl.mem seen "--exactly" && (Hashtbl.mem seen "--max" || Hashtbl.mem seen "--min") then
        usage "--exactly N is --max N and --min N: give it without them";
      (match rest with
       | [] -> usage ("no value behind " ^ name)
       | value :: rest ->
         (match name with
          | "--ratio" -> o.range <- Some (ratios value)
          | "--max" -> o.most <- Some (number name value)
          | "--min" -> o.least <- Some (number name value)
          | _ -> let n = Some (number name value) in o.most <- n; o.least <- n);
         go rest)
    | file :: rest -> o.files <- file :: o.files; go rest in
  go words;
  if o.files = [] then usage "no FILE";
  o

(* Of several exit codes the first of 1, 4, 3, 2, 0. *)
let worse a b = let rank c = match c with 1 -> 4 | 4 -> 3 | 3 -> 2 | 2 -> 1 | _ -> 0 in if rank a >= rank b then a else b

let () =
  let code = try
      let o = parse (List.tl (Array.to_list Sys.argv)) in
      let demand = { C.asked_range = o.range; C.asked_most = o.most; C.asked_least = o.least } in
      let files = List.rev o.files in
      List.fold_left (fun code file ->
          let one, line = examine demand file in
          print_endline (if List.length files > 1 then line ^ " file=" ^ file else line);
          worse code one) 0 files
    with Failure_of_file (code, message) -> prerr_endline ("prove: " ^ message); code in
  exit code
