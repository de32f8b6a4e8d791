(* The lines of a certificate's file, and the SHA-256 of all but the last. *)
open Convert

let everything channel =
  let b = Buffer.create 65536 in
  (try while true do Buffer.add_channel b channel 1 done with End_of_file -> ());
  Buffer.contents b

let contents path =
  let unreadable why = raise (Ended (2, "s UNREADABLE " ^ why)) in
  let bytes =
    try
      let channel = if path = "-" then stdin else open_in_bin path in
      Fun.protect ~finally:(fun () -> close_in_noerr channel) (fun () -> everything channel)
    with Sys_error why -> unreadable why in
  if not (String.length bytes >= 2 && String.sub bytes 0 2 = "\x1f\x8b") then bytes
  else begin
    let copy = Filename.temp_file "prove" ".gz" in
    Fun.protect ~finally:(fun () -> Sys.remove copy) (fun () ->
        let channel = open_out_bin copy in
        output_string channel bytes;
        close_out channel;
        let pipe = Unix.open_process_in ("gzip -dcq < " ^ Filename.quote copy) in
        let text = everything pipe in
        let ended = Unix.close_process_in pipe in
        (* The last four bytes have the length of the last member. *)
        let last k = Char.code bytes.[String.length bytes - 4 + k] lsl (8 * k) in
        let length = if String.length bytes < 18 then -1 else last 0 lor last 1 lor last 2 lor last 3 in
        if ended <> Unix.WEXITED 0 || length <> String.length text land 0xffffffff then
          raise (Ended (1, "s REJECTED code=gzip the compressed file is damaged, or not one gzip member"));
        text)
  end

let sha256 text =
  let from_program, to_program = Unix.open_process "sha256sum" in
  output_string to_program text;
  close_out to_program;
  let line = try input_line from_program with End_of_file -> "" in
  if Unix.close_process (from_program, to_program) <> Unix.WEXITED 0 || String.length line < 64 then
    raise (Ended (4, "s LIMIT sha256sum does not run"));
  String.sub line 0 64

(* What no certificate has is refused at once, before its letters become Coq's, which take some 100 bytes each: a line over 4096 bytes,
   and a tree with more levels than the reader tries. [awaited] has the depths of the nodes that are still to come. *)
let check_shape lines =
  let refuse number why = raise (Ended (1, Printf.sprintf "s REJECTED line=%d %s" number why)) in
  let next (number, awaited) line =
    if String.length line > 4096 then refuse number "a line over 4096 bytes";
    let depth, others = match awaited with d :: l -> d, l | [] -> 0, [] in
    if not (String.starts_with ~prefix:"split " line) then number + 1, others
    else if depth >= 1200 then refuse number "a tree with too many levels"
    else number + 1, (depth + 1) :: (depth + 1) :: others in
  ignore (List.fold_left next (1, []) lines)

let lines path =
  let text = contents path in
  let n = String.length text in
  if n = 0 || text.[n - 1] <> '\n' then
    raise (Ended (1, "s REJECTED code=truncated the text ends too early, or without a line feed"));
  let last = match String.rindex_from_opt text (max 0 (n - 2)) '\n' with Some k -> k + 1 | None -> 0 in
  let lines = String.split_on_char '\n' (String.sub text 0 (n - 1)) in
  check_shape lines;
  lines, sha256 (String.sub text 0 last)
