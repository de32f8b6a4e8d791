(* The command line: the files, and what they are to prove, or what is to be decided without a file, with the meaning that the options
   have for dumbbell-verify. *)
open Convert

let usage message = raise (Ended (2, message))
let first n s = String.sub s 0 (min n (String.length s))
let is_digits s = s <> "" && String.for_all (fun c -> '0' <= c && c <= '9') s

let number option s =
  let fits = is_digits s && String.length s <= 2100 && (s.[0] <> '0' || s = "0") in
  match if fits then C.natural (to_coq s) else None with
  | Some n -> n
  | None -> usage (option ^ " needs a number of at most 2100 digits, not `" ^ first 60 s ^ "`")

let without_zeros s =
  let rec from i = if i < String.length s - 1 && s.[i] = '0' then from (i + 1) else i in
  let i = from 0 in
  String.sub s i (String.length s - i)

(* P/Q, or 10^N, or a decimal, perhaps with an exponent, exactly: a numerator, perhaps 0, and a denominator. *)
let rational s =
  let bad () = usage ("not a number: `" ^ s ^ "`") in
  let fraction a b =
    let a = without_zeros a in
    match C.ratio_of (to_coq ((if a = "0" then "1" else a) ^ "/" ^ without_zeros b)) with
    | None -> bad ()
    | Some _ when a = "0" -> C.N0, C.XH
    | Some r -> let r = C.lowest_terms r in C.Npos r.C.num, r.C.den in
  let exponent_of e =
    let signed = e <> "" && (e.[0] = '+' || e.[0] = '-') in
    let digits = if signed then String.sub e 1 (String.length e - 1) else e in
    if not (is_digits digits && String.length (without_zeros digits) <= 4) then bad ();
    let n = int_of_string (without_zeros digits) in
    if n > 1000 then usage ("an exponent beyond 1000: " ^ s);
    if e.[0] = '-' then - n else n in
  if String.length s > 1000 then bad ();
  match String.split_on_char '/' s with
  | [a; b] when is_digits a && is_digits b -> fraction a b
  | [_] ->
    let decimal = if String.starts_with ~prefix:"10^" s then "1e" ^ String.sub s 3 (String.length s - 3) else s in
    let mantissa, exponent = match String.split_on_char 'e' (String.lowercase_ascii decimal) with
      | [m] -> m, 0
      | [m; e] -> m, exponent_of e
      | _ -> bad () in
    let whole, part = match String.split_on_char '.' mantissa with
      | [whole] -> whole, ""
      | [whole; part] when is_digits part -> whole, part
      | _ -> bad () in
    if not (is_digits whole) then bad ();
    let shift = exponent - String.length part in
    fraction (whole ^ part ^ String.make (max 0 shift) '0') ("1" ^ String.make (max 0 (- shift)) '0')
  | _ -> bad ()

let one = { C.num = C.XH; C.den = C.XH }
let ratio s = match rational s with
  | C.Npos num, den -> { C.num; den }
  | C.N0, _ -> usage ("not a positive ratio: `" ^ s ^ "`")
let width s = match rational s with
  | C.Npos num, den when C.ratio_le one { C.num; den } -> usage ("--gap is a width below 1, not " ^ s)
  | number -> number
let inverse r = { C.num = r.C.den; C.den = r.C.num }

(* Below 1 the masses are exchanged. *)
let ratios s =
  let lo, hi = match String.split_on_char ':' s with
    | [a] -> let r = ratio a in r, r
    | [a; b] -> ratio a, ratio b
    | _ -> usage ("not a mass ratio or LO:HI: `" ^ s ^ "`") in
  if not (C.ratio_le lo hi) then usage ("LO:HI needs LO <= HI: " ^ s)
  else if C.ratio_le one lo then lo, hi
  else if C.ratio_le hi one then inverse hi, inverse lo
  else usage ("a range across 1: split it at 1: " ^ s)

(* As in the verdict line of dumbbell-verify. *)
let ratio_text r = of_coq (C.ratio_text r)
let text d =
  let count name = function Some n -> Printf.sprintf " %s=%s" name (decimal n) | None -> "" in
  (match d.C.asked_range with Some (lo, hi) -> Printf.sprintf " demanded-ratio=%s:%s" (ratio_text lo) (ratio_text hi) | None -> "")
  ^ (if d.C.asked_most <> None && d.C.asked_most = d.C.asked_least then count "exactly" d.C.asked_most
     else count "max" d.C.asked_most ^ count "min" d.C.asked_least)
  ^ (match d.C.asked_gap with Some (n, e) -> Printf.sprintf " demanded-gap=%s/%s" (decimal n) (decimal (C.Npos e)) | None -> "")
  ^ count "demanded-gaps" d.C.asked_gaps ^ (if d.C.asked_once then " demanded-heavy-at-most=1" else "")

type t = { files : string list; term : string option; asked : C.demand }

let nothing = { files = []; term = None; asked = { C.asked_range = None; asked_most = None; asked_least = None;
                                                   asked_gap = None; asked_gaps = None; asked_once = false } }
let options = ["--ratio"; "--max"; "--min"; "--exactly"; "--gap"; "--gaps"; "--heavy-at-most"]

let rec parse seen o = function
  | [] ->
    let claimed = o.asked.C.asked_range <> None && (o.asked.C.asked_most <> None || o.asked.C.asked_least <> None) in
    if o.files = [] && (o.asked.C.asked_gap <> None || o.asked.C.asked_gaps <> None || o.asked.C.asked_once) then
      usage "--gap, --gaps and --heavy-at-most are about a certificate: name its FILE";
    if o.files = [] && not claimed then usage "no FILE, and no --ratio with a bound; see docs/4-verifying.md";
    { o with files = List.rev o.files }
  | "--" :: files -> parse seen { o with files = List.rev_append files o.files } []
  | word :: rest when String.length word > 1 && word.[0] = '-' ->
    let name, rest = match String.index_opt word '=' with
      | Some k -> String.sub word 0 k, String.sub word (k + 1) (String.length word - k - 1) :: rest
      | None -> word, rest in
    if not (List.mem name ("--term" :: options)) then
      usage ("the proved checker knows no " ^ name ^ ": leave it out, or ask dumbbell-verify; there are "
             ^ String.concat ", " options ^ " and, as the first, --kernel");
    if List.mem name seen then usage (name ^ " is given twice");
    let seen = name :: seen in
    if List.mem "--exactly" seen && (List.mem "--max" seen || List.mem "--min" seen) then
      usage "--exactly N is --max N and --min N: give it without them";
    (match rest with
     | [] -> usage ("no value after " ^ name)
     | value :: rest ->
       let n () = Some (number name value) in
       let o = match name with
         | "--ratio" -> { o with asked = { o.asked with C.asked_range = Some (ratios value) } }
         | "--max" -> { o with asked = { o.asked with C.asked_most = n () } }
         | "--min" -> { o with asked = { o.asked with C.asked_least = n () } }
         | "--exactly" -> { o with asked = { o.asked with C.asked_most = n (); C.asked_least = n () } }
         | "--gap" -> { o with asked = { o.asked with C.asked_gap = Some (width value) } }
         | "--gaps" -> { o with asked = { o.asked with C.asked_gaps = n () } }
         | "--heavy-at-most" when value = "1" -> { o with asked = { o.asked with C.asked_once = true } }
         | "--heavy-at-most" -> usage "--heavy-at-most is 1: no other number is proved"
         | _ -> { o with term = Some value } in
       parse seen o rest)
  | file :: rest -> parse seen { o with files = file :: o.files } rest
