(** How a certificate is written in lines (docs/reference/format.md, sections 1 to 3; format-sections.md, its table and
    section 1): [file_text c sha256] are its lines. This is the relation between a file and what it says;
    Reader.v only looks for the c.

    file_text               == the lines of a certificate
    ratio_text, dyadic_text == of numbers
    canonical               == its words can be read back: no second certificate has the same lines *)
From Coq Require Import ZArith NArith List Bool String Ascii DecimalString DecimalN.
From Dumbbell Require Import Certificate Check.
Import ListNotations.
Local Open Scope string_scope.

Definition ratio_text (x : ratio) : string := decimal (Npos (num x)) ++ "/" ++ decimal (Npos (den x)).
Definition integer_text (z : Z) : string := match z with Zneg p => "-" ++ decimal (Npos p) | _ =>
  decimal (Z.to_N z) end.
Definition dyadic_text (x : dyadic) : string := decimal (odd_part x) ++ "b" ++ integer_text (exponent x).

Definition reason_text (why : reason) : string :=
  match why with
  | Count a b => "count " ++ decimal a ++ " " ++ decimal b
  | Forward a | Plain a => "count " ++ decimal a
  | Outside => "outside"
  | Meets => "meets"
  | Meets_reversed => "meets-reversed"
  | Once => "once"
  end.
(** The axes of a chart; the third is q. *)
Definition axis_text (c : chart) (a : axis) : string :=
  match a with
  | axis_e => match c with Contact | Again => "t" | _ => "e" end
  | axis_slope => match c with Light => "lambda" | _ => "eta" end
  | axis_q => "q"
  end.
Fixpoint tree_text (c : chart) (t : tree) (rest : list string) : list string :=
  match t with
  | Leaf why => reason_text why :: rest
  | Split a lower upper => ("split " ++ axis_text c a) :: tree_text c lower (tree_text c upper rest)
  end.
Definition chart_text (c : chart) (t : tree) (rest : list string) : list string :=
  ("chart " ++ chart_name c) :: tree_text c t rest.
Definition cover_text (c : cover) (rest : list string) : list string :=
  match c with
  | Equal_masses => "equal-masses" :: rest
  | Charts bridge light => chart_text Bridge bridge (chart_text Light light rest)
  | Full_charts contact departure again =>
      chart_text Contact contact (chart_text Departure departure (chart_text Again again rest))
  end.
Definition witness_text (w : option contact) (rest : list string) : list string :=
  match w with
  | None => rest
  | Some w => ("witness bridge " ++ dyadic_text (contact_e w) ++ " " ++ dyadic_text (contact_eta w) ++ " " ++
               decimal (after_X w) ++ " " ++ decimal (after_reversed w)) :: rest
  end.
Definition piece_text (P : piece) (rest : list string) : list string :=
  ("piece " ++ ratio_text (from P) ++ " " ++ ratio_text (to P)) :: ("bits " ++ decimal (bits P)) ::
  match bound P with
  | None => "upper none" :: ("lower " ++ decimal (attained P)) :: witness_text (witness P) rest
  | Some (U, c) => ("upper " ++ decimal U) :: cover_text c (("lower " ++ decimal (attained P)) :: witness_text (witness
    P) rest)
  end.

(** The totals: how many lines of each kind there are. *)
Fixpoint in_tree (counts_split : bool) (leaf : reason -> bool) (t : tree) (n : N) : N :=
  match t with
  | Leaf why => if leaf why then N.succ n else n
  | Split _ l u => in_tree counts_split leaf u (in_tree counts_split leaf l (if counts_split then N.succ n else n))
  end.
Definition in_cover (counts_split : bool) (leaf : reason -> bool) (n : N) (P : piece) : N :=
  let count := in_tree counts_split leaf in
  match bound P with
  | Some (_, Charts b l) => count l (count b n)
  | Some (_, Full_charts c d a) => count a (count d (count c n))
  | _ => n
  end.
Definition total_text (name : string) (n : N) : string := "total " ++ name ++ " " ++ decimal n.
Definition totals_text (about : section) (l : list piece) : list string :=
  let leaves name leaf := total_text name (fold_left (in_cover false leaf) l 0%N) in
  let those name good := total_text name (how_many good l) in
  ([total_text "split" (fold_left (in_cover true (fun _ => false)) l 0%N);
   leaves "count" (fun why => match why with Count _ _ | Forward _ | Plain _ => true | _ => false end);
   leaves "outside" (fun why => match why with Outside => true | _ => false end);
   leaves "meets" (fun why => match why with Meets => true | _ => false end);
   leaves "meets-reversed" (fun why => match why with Meets_reversed => true | _ => false end);
   those "equal-masses" (fun P => match bound P with Some (_, Equal_masses) => true | _ => false end);
   those "witness" (fun P => match witness P with Some _ => true | None => false end)] ++
  match about with
  | turning => []
  | full | full_minimal => [leaves "once" (fun why => match why with Once => true | _ => false end)]
  end ++
  [those "open" (fun P => match bound P with None => true | Some _ => false end)])%list.

Definition section_name (about : section) : string :=
  match about with turning => "turning" | full | full_minimal => "full" end.
Definition lemmas_name (about : section) : string := match about with full_minimal => "minimal" | _ => "1" end.
Definition certificate_text (c : certificate) : list string :=
  "dumbbell-certificate 1" :: ("generator " ++ program c ++ " " ++ program_version c)
    :: ("lemmas " ++ lemmas_name (about c)) :: "scene dumbbell" :: ("section " ++ section_name (about c))
    :: "claim collisions"
    :: ("ratio " ++ ratio_text (range_from c) ++ " " ++ ratio_text (range_to c))
    :: ("pieces " ++ decimal (N.of_nat (List.length (pieces c))))
    :: fold_right piece_text (totals_text (about c) (pieces c)) (pieces c).
(** With the last line, the checksum of all lines before it. *)
Definition file_text (c : certificate) (sha256 : string) : list string := List.app (certificate_text c) ["sha256 " ++
  sha256].

(** The limits of the lexical classes, and the forms that have one spelling only (section 1). *)
Definition is_lower (c : ascii) : bool := let n := N_of_ascii c in (97 <=? n)%N && (n <=? 122)%N.
Definition is_digit (c : ascii) : bool := let n := N_of_ascii c in (48 <=? n)%N && (n <=? 57)%N.
Fixpoint all_chars (good : ascii -> bool) (s : string) : bool := match s with EmptyString => true | String c s =>
  good c && all_chars good s end.
Definition is_word (digit_may_lead : bool) (s : string) : bool :=
  match s with EmptyString => false | String c _ => is_lower c || (digit_may_lead && is_digit c) end &&
  all_chars (fun c => is_lower c || is_digit c || Ascii.eqb c "-" || Ascii.eqb c ".")%char s &&
    (String.length s <=? 32)%nat.
(** A number of collisions has at most 2100 digits; a longer power than needed is not made. *)
Definition is_count (n : N) : bool := if (n <? 10 ^ 18)%N then true else (n <? 10 ^ 2100)%N.
Definition ratio_canonical (x : ratio) : bool :=
  (Pos.gcd (num x) (den x) =? 1)%positive && (String.length (decimal (Npos (num x))) <=? 2100)%nat &&
    (String.length (decimal (Npos (den x))) <=? 2100)%nat.
Definition dyadic_canonical (x : dyadic) : bool :=
  (if (odd_part x =? 0)%N then (exponent x =? 0)%Z else N.odd (odd_part x)) &&
  (String.length (decimal (odd_part x)) <=? 1250)%nat && (Z.abs (exponent x) <=? 4096)%Z.
Definition contact_canonical (w : contact) : bool :=
  dyadic_canonical (contact_e w) && dyadic_canonical (contact_eta w) && is_count (after_X w) && is_count (after_reversed w).
(** At most 400 splits of each axis above a node. *)
Fixpoint tree_canonical (e slope q : nat) (t : tree) : bool :=
  match t with
  | Leaf (Count a b) => is_count a && is_count b
  | Leaf (Forward a | Plain a) => is_count a
  | Leaf _ => true
  | Split axis_e l u => match e with O => false | S e => tree_canonical e slope q l && tree_canonical e slope q u end
  | Split axis_slope l u => match slope with O => false | S slope => tree_canonical e slope q l &&
    tree_canonical e slope q u end
  | Split axis_q l u => match q with O => false | S q => tree_canonical e slope q l && tree_canonical e slope q u end
  end.
Definition piece_canonical (P : piece) : bool :=
  ratio_canonical (from P) && ratio_canonical (to P) && (53 <=? bits P)%N && (bits P <=? 4096)%N &&
    is_count (attained P) &&
  match bound P with
  | Some (U, Charts b l) => is_count U && tree_canonical 400 400 400 b && tree_canonical 400 400 400 l
  | Some (U, Full_charts c d a) =>
      is_count U && tree_canonical 400 400 400 c && tree_canonical 400 400 400 d && tree_canonical 400 400 400 a
  | Some (U, Equal_masses) => is_count U
  | None => true
  end && match witness P with Some w => contact_canonical w && negb (attained P =? 0)%N | None => true end.
Definition canonical (c : certificate) : bool :=
  is_word false (program c) && is_word true (program_version c) && ratio_canonical (range_from c) &&
    ratio_canonical (range_to c) &&
  forallb piece_canonical (pieces c).
