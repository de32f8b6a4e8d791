(** Reads a certificate, line by line. Nothing is believed of it: what was read is written again (Text.v) and compared
  with the file, so
    that this reader can only refuse.

    natural, ratio_of == a number, a fraction, from its text
    judge, answer     == the verdict on the lines of a file
    verified_text     == what is Verified is a certificate whose text these lines are, and has no fault *)
From Coq Require Import ZArith NArith List Bool String Ascii DecimalString DecimalN.
From Dumbbell Require Import Certificate Leaves Doubles Check Text.
Import ListNotations.
Local Open Scope string_scope.

(** What was read and the lines that follow, or the lines from the one that is wrong. *)
Inductive reading A := Read (x : A) (rest : list string) | Wrong (rest : list string).
Arguments Read {A}. Arguments Wrong {A}.
Definition bind {A B} (r : reading A) (f : A -> list string -> reading B) : reading B :=
  match r with Read x rest => f x rest | Wrong rest => Wrong rest end.
Notation "'let*' ( x , rest ) := r 'in' f" := (bind r (fun x rest => f)) (at level 200, x name, rest name).

(** The parts of a string between occurrences of a character. *)
Fixpoint split_at (mark : ascii) (s : string) : list string :=
  match s with
  | EmptyString => [EmptyString]
  | String c s => if Ascii.eqb c mark then EmptyString :: split_at mark s
                  else match split_at mark s with w :: l => String c w :: l | [] => [String c EmptyString] end
  end.
Definition natural (s : string) : option N := option_map N.of_uint (NilZero.uint_of_string s).
Definition integer (s : string) : option Z :=
  match s with
  | String "-" s => option_map (fun n => (- Z.of_N n)%Z) (natural s)
  | _ => option_map Z.of_N (natural s)
  end.
Definition positive_number (s : string) : option positive := match natural s with Some (Npos p) => Some p | _ =>
  None end.
Definition ratio_of (s : string) : option ratio :=
  match split_at "/" s with
  | [a; b] => match positive_number a, positive_number b with Some a, Some b => Some {| num := a; den := b |} | _, _ =>
    None end
  | _ => None
  end.
Definition dyadic_of (s : string) : option dyadic :=
  match split_at "b" s with
  | [a; b] => match natural a, integer b with Some a, Some b => Some {| odd_part := a; exponent := b |} | _, _ =>
    None end
  | _ => None
  end.

(** The next line as what [f] makes of its fields. *)
Definition line {A} (f : list string -> option A) (t : list string) : reading A :=
  match t with
  | [] => Wrong []
  | l :: rest => match f (split_at " " l) with Some x => Read x rest | None => Wrong t end
  end.
Definition value {A} (keyword : string) (f : string -> option A) : list string -> reading A :=
  line (fun w => match w with [k; v] => if k =? keyword then f v else None | _ => None end).
Definition two_ratios (keyword : string) : list string -> reading (ratio * ratio) :=
  line (fun w => match w with
    | [k; a; b] => if k =? keyword then match ratio_of a, ratio_of b with Some a, Some b => Some (a, b) | _, _ =>
      None end else None
    | _ => None end).

Inductive node := Ends (why : reason) | Halved (a : axis).
(** [hint] is what `count` with one hint is. *)
Definition node_of (hint : N -> reason) (c : chart) (w : list string) : option node :=
  match w with
  | ["count"; a; b] => match natural a, natural b with Some a, Some b => Some (Ends (Count a b)) | _, _ => None end
  | ["count"; a] => option_map (fun a => Ends (hint a)) (natural a)
  | ["outside"] => Some (Ends Outside)
  | ["meets"] => Some (Ends Meets)
  | ["meets-reversed"] => Some (Ends Meets_reversed)
  | ["once"] => Some (Ends Once)
  | ["split"; a] => option_map Halved (find (fun x => a =? axis_text c x) [axis_e; axis_slope; axis_q])
  | _ => None
  end.
(** A tree of at most [fuel] levels. *)
Fixpoint read_tree (hint : N -> reason) (fuel : nat) (c : chart) (t : list string) : reading tree :=
  match fuel with
  | O => Wrong t
  | S fuel =>
    let* (n, t) := line (node_of hint c) t in
    match n with
    | Ends why => Read (Leaf why) t
    | Halved a =>
      let* (l, t) := read_tree hint fuel c t in let* (u, t) := read_tree hint fuel c t in Read (Split a l u) t
    end
  end.
Definition levels : nat := 1201.
Definition read_chart (hint : N -> reason) (c : chart) (t : list string) : reading tree :=
  let* (_, t) := value "chart" (fun v => if v =? chart_name c then Some tt else None) t in
  read_tree hint levels c t.
Definition read_cover (about : section) (t : list string) : reading cover :=
  match t, about with
  | "equal-masses" :: t, _ => Read Equal_masses t
  | _, turning =>
    let* (b, t) := read_chart Forward Bridge t in let* (l, t) := read_chart Forward Light t in Read (Charts b l) t
  | _, _ =>
    let chart := read_chart (match about with full_minimal => Plain | _ => Forward end) in
    let* (c, t) := chart Contact t in let* (d, t) := chart Departure t in let* (a, t) := chart Again t in
    Read (Full_charts c d a) t
  end.
Definition contact_of (w : list string) : option contact :=
  match w with
  | ["witness"; "bridge"; e; eta; a; b] =>
    match dyadic_of e, dyadic_of eta, natural a, natural b with
    | Some e, Some eta, Some a, Some b => Some {| contact_e := e; contact_eta := eta; after_X := a; after_reversed :=
      b |}
    | _, _, _, _ => None
    end
  | _ => None
  end.
Definition read_witness (v : N) (t : list string) : reading (option contact) :=
  if (v =? 0)%N then Read None t else let* (w, t) := line contact_of t in Read (Some w) t.
Definition read_piece (about : section) (t : list string) : reading piece :=
  let* (r, t) := two_ratios "piece" t in
  let* (n, t) := value "bits" natural t in
  let* (u, t) := value "upper" (fun v => if v =? "none" then Some None else option_map Some (natural v)) t in
  let* (c, t) :=
    match u with
    | None => Read None t
    | Some u => let* (c, t) := read_cover about t in Read (Some (u, c)) t
    end in
  let* (v, t) := value "lower" natural t in
  let* (w, t) := read_witness v t in
  Read {| from := fst r; to := snd r; bits := n; bound := c; attained := v; witness := w |} t.
(** Pieces as long as there are; [fuel] is the number of lines. *)
Fixpoint read_pieces (fuel : nat) (about : section) (t : list string) : reading (list piece) :=
  match fuel, t with
  | S fuel, l :: _ =>
    match split_at " " l with
    | "piece" :: _ => let* (P, t) := read_piece about t in let* (l, t) := read_pieces fuel about t in Read (P :: l) t
    | _ => Read [] t
    end
  | _, _ => Read [] t
  end.

(** A file that is about something else than the sections turning and full of the dumbbell is not wrong, but not for
    this checker. *)
Definition known {A} (keyword : string) (expected : list (string * A)) (t : list string) : reading (option A) :=
  line (fun w => match w with
    | [k; v] =>
        if negb (k =? keyword) then None else
        match find (fun x => v =? fst x) expected with
        | Some x => Some (Some (snd x))
        | None => if is_word false v || (all_chars is_digit v && negb (v =? "")) then Some None else None
        end
    | _ => None end) t.

Inductive answer := Verified (c : certificate) | Rejected (number : nat) (why : string) | Unsupported (number : nat)
  (why : string) | Limit (why : string).

Section Judge.
Variable t : list string.
Let number (rest : list string) : nat := (List.length t - List.length rest + 1)%nat.
Definition expect {A} (keyword : string) (expected : list (string * A)) (rest : list string)
    (k : A -> list string -> answer) : answer :=
  match known keyword expected rest with
  | Wrong rest => Rejected (number rest) ("expected `" ++ keyword ++ "`")
  | Read None rest => Unsupported (number rest - 1)
      ("not checked here: " ++ nth (number rest - 2) t "" ++ ", where only " ++ keyword ++ " " ++
       String.concat " or " (map fst expected) ++ " is")
  | Read (Some x) rest => k x rest
  end.
Definition header (k : section -> list string -> answer) : answer :=
  expect "dumbbell-certificate" [("1", tt)] t (fun _ rest =>
  match rest with [] => Rejected (number rest) "the text ends too early" | _ :: rest =>
  expect "lemmas" [("1", [("turning", turning); ("full", full)]); ("minimal", [("full", full_minimal)])] rest
    (fun sections rest => expect "scene" [("dumbbell", tt)] rest (fun _ rest => expect "section" sections rest
    (fun about rest =>
  expect "claim" [("collisions", tt)] rest (fun _ rest => k about rest))))
  end).
Definition read_body (generator : string) (about : section) (rest : list string) : reading certificate :=
  let* (r, rest) := two_ratios "ratio" rest in
  let* (_, rest) := value "pieces" natural rest in
  let* (l, rest) := read_pieces (List.length t) about rest in
  match split_at " " generator with
  | [_; p; v] => Read {| program := p; program_version := v; about := about; range_from := fst r; range_to := snd r;
                         pieces := l |} rest
  | _ => Wrong (tl t)
  end.
Fixpoint first_difference (a b : list string) : option nat :=
  match a, b with
  | [], [] => None
  | x :: a, y :: b => if x =? y then option_map S (first_difference a b) else Some O
  | _, _ => Some O
  end.
(** What is not tried: nothing is said of a piece that asks for more bits, or counts further, than this; nor of a file
    with more work. Work is counted in collisions: in double precision [most_work] of them; where doubles do not certify
    a leaf, which is then done again, times the square of the bits, [most_again]. *)
Definition most_bits : N := 2048.
Definition most_work : N := 20 * most_steps.
Definition most_again : N := 500 * most_steps.
Definition far (n : N) : bool := (most_steps <? n)%N.
Definition hints_far (why : reason) : bool :=
  match why with Count a b => far a || far b | Forward a | Plain a => far a | _ => false end.
Definition steps (why : reason) : N := match why with Count a b => 1 + a + b | Forward a | Plain a => 1 + a | _ => 1 end%N.
Definition counted (w : contact) : N := (after_X w + after_reversed w)%N.
Fixpoint any_leaf (p : reason -> bool) (t : tree) : bool :=
  match t with Leaf why => p why | Split _ l u => any_leaf p l || any_leaf p u end.
(** The sum over the leaves of a tree with its boxes; over the charts of a piece, and its witness; over the pieces. *)
Fixpoint tree_work (f : box -> reason -> N) (b : box) (t : tree) : N :=
  match t with
  | Leaf why => f b why
  | Split a l u => tree_work f (box_half lower_half a b) l + tree_work f (box_half upper_half a b) u
  end%N.
Definition charts (P : piece) : list (N * chart * tree) :=
  match bound P with
  | Some (U, Charts b l) => [(U, Bridge, b); (U, Light, l)]
  | Some (U, Full_charts c d a) => [(U, Contact, c); (U, Departure, d); (U, Again, a)]
  | _ => []
  end.
Definition sum {A} (f : A -> N) (l : list A) : N := fold_left (fun n x => (n + f x)%N) l 0%N.
Definition piece_work (f : N -> chart -> box -> reason -> N) (g : contact -> N) (P : piece) : N :=
  (sum (fun '(U, c, t) => tree_work (f U c) (chart_box c (from P) (to P)) t) (charts P) +
   match witness P with Some w => g w | None => 0 end)%N.
Definition work : piece -> N := piece_work (fun _ _ _ why => steps why) counted.
Definition squared (P : piece) : N := (bits P * bits P)%N.
Definition most_work_again (P : piece) : N := (squared P * work P)%N.
(** What is left to do again when the doubles have been tried. *)
Definition work_again (P : piece) : N :=
  let b := chart_box Bridge (from P) (to P) in
  (squared P * piece_work
    (fun U c b why => if Doubles.check_leaf U c b why then 0 else steps why)
    (fun w => if Doubles.above_corner b w && Doubles.check_contact (attained P) b w then 0 else counted w) P)%N.
Definition too_much (P : piece) : bool :=
  (most_bits <? bits P)%N || existsb (fun '(_, t) => any_leaf hints_far t) (charts P) ||
  match witness P with Some w => far (after_X w) || far (after_reversed w) | None => false end.

(** The verdict on the lines of a file: read, written again, compared, and checked.
  [sha256] is the checksum of all lines but the last. *)
Definition judge (sha256 : string) (d : demand) : answer :=
  header (fun about rest =>
  match read_body (nth 1 t "") about rest with
  | Wrong rest => Rejected (number rest) "not a line for this place"
  | Read c _ =>
    match first_difference (file_text c sha256) t with
    | Some n => Rejected (S n) "the text is not as this certificate is written"
    | None =>
      if negb (canonical c) then Rejected 0 "a value beyond its limits, or not in lowest terms" else
      if existsb too_much (pieces c) then Limit "more than 2048 bits, or a ray with more than a million collisions" else
      let beyond := Limit "more work than the budget allows" in
      let all (_ : unit) := match certificate_fault true d c with Some why => Rejected 0 why | None => Verified c end in
      if (most_work <? sum work (pieces c))%N then beyond else
      if (sum most_work_again (pieces c) <=? most_again)%N then all tt else
      match certificate_fault false d c with
      | None => Verified c
      | Some _ => if (most_again <? sum work_again (pieces c))%N then beyond else all tt
      end
    end
  end).
Lemma same_lines a : forall b, first_difference a b = None -> a = b.
Proof.
  induction a as [|x a IH]; intros [|y b] H; try discriminate; [reflexivity|]. simpl in H. destruct (x =? y) eqn:E;
    [|discriminate].
  apply String.eqb_eq in E. subst y. destruct (first_difference a b) eqn:D; [discriminate|]. now rewrite (IH b D).
Qed.

(** An accepted file is, line by line, the certificate that was judged. *)
Theorem verified_text sha256 d c : judge sha256 d = Verified c ->
  t = file_text c sha256 /\ canonical c = true /\ exists again, certificate_fault again d c = None.
Proof.
  unfold judge.
  set (K := fun about rest => match read_body (nth 1 t "") about rest with Wrong _ => _ | Read _ _ => _ end).
  assert (HK : forall about rest, K about rest = Verified c -> t = file_text c sha256 /\ canonical c = true /\
    exists again, certificate_fault again d c = None).
  { intros about rest. unfold K. destruct (read_body _ about rest) as [c' rest'|]; [|discriminate].
    destruct (first_difference _ t) eqn:E1; [discriminate|]. destruct (canonical c') eqn:E2; [|discriminate]. cbn [negb].
    destruct (existsb too_much (pieces c')); [discriminate|]. cbv beta zeta. intros H.
    enough (K2 : c' = c /\ exists again, certificate_fault again d c' = None).
    { destruct K2 as [<- K2]. apply same_lines in E1. repeat split; try assumption. now symmetry. }
    assert (All : match certificate_fault true d c' with Some why => Rejected 0 why | None => Verified c' end = Verified c ->
      c' = c /\ exists again, certificate_fault again d c' = None).
    { destruct (certificate_fault true d c') eqn:E3; [discriminate|]. intros H2. injection H2; intros <-.
      split; [reflexivity | now exists true]. }
    destruct (most_work <? _)%N; [discriminate|]. destruct (_ <=? most_again)%N; [now apply All|].
    destruct (certificate_fault false d c') eqn:E4; [destruct (most_again <? _)%N; [discriminate | now apply All]|].
    injection H; intros <-. split; [reflexivity | now exists false]. }
  assert (HE : forall A keyword (expected : list (string * A)) rest k, expect keyword expected rest k = Verified c ->
    exists x rest', k x rest' = Verified c).
  { intros A keyword expected rest k. unfold expect. destruct (known _ _ _) as [[x|] rest'|]; try discriminate. eauto. }
  unfold header. intros H. apply HE in H. destruct H as [_ [[|_ r1] H]]; [discriminate|].
  apply HE in H. destruct H as [sections [r2 H]]. apply HE in H. destruct H as [_ [r3 H]].
  apply HE in H. destruct H as [about [r4 H]]. apply HE in H. destruct H as [_ [r5 H]]. exact (HK about r5 H).
Qed.
End Judge.
