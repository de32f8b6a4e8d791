(* Between OCaml's strings and numbers and those of the extracted code; and how a run ends early. *)
module C = Checker

(* An exit code, as of dumbbell-verify, and the line to print. *)
exception Ended of int * string

let ascii = Array.init 256 (fun n ->
    let bit k = n land (1 lsl k) <> 0 in
    C.Ascii (bit 0, bit 1, bit 2, bit 3, bit 4, bit 5, bit 6, bit 7))

let to_coq s =
  let rec from i l = if i < 0 then l else from (i - 1) (C.String (ascii.(Char.code s.[i]), l)) in
  from (String.length s - 1) C.EmptyString

let of_coq s =
  let b = Buffer.create 80 in
  let rec add = function
    | C.EmptyString -> Buffer.contents b
    | C.String (C.Ascii (b0, b1, b2, b3, b4, b5, b6, b7), rest) ->
      let bits = [b0; b1; b2; b3; b4; b5; b6; b7] in
      Buffer.add_char b (Char.chr (List.fold_right (fun bit n -> 2 * n + Bool.to_int bit) bits 0));
      add rest in
  add s

let rec int_of_nat = function C.O -> 0 | C.S n -> 1 + int_of_nat n
let decimal n = of_coq (C.decimal n)
