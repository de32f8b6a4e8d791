(** How a certificate is written in lines (docs/reference/format.md, sections 1 to 3): [file_text c sha256] are its
  lines. This is the relation between a file and what it says; Reader.v only looks for the c. *)
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
  | Outside => "outside"
  | Meets => "meets"
  | Meets_reversed => "meets-reversed"
  end.
(** [slope] is the name of the second axis: eta in the chart bridge, lambda in the chart light. *)
Definition axis_text (slope : string) (a : axis) : string := match a with axis_e => "e" | axis_slope =>
  slope | axis_q => "q" end.
Fixpoint tree_text (slope : string) (t : tree) (rest : list string) : list string :=
  match t with
  | Leaf why => reason_text why :: rest
  | Split a lower upper => ("split " ++ axis_text slope a) :: tree_text slope lower (tree_text slope upper rest)
  end.
Definition cover_text (c : cover) (rest : list string) : list string :=
  match c with
  | Equal_masses => "equal-masses" :: rest
  | Charts bridge light => "chart bridge" :: tree_text "eta" bridge ("chart light" :: tree_text "lambda" light rest)
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
Record totals := { splits : N; counts : N; outsides : N; meetings : N; meetings_reversed : N; equals : N;
  witnesses : N; opens : N }.
Fixpoint tree_totals (t : tree) (s : totals) : totals :=
  match t with
  | Leaf (Count _ _) => {| splits := splits s; counts := N.succ (counts s); outsides := outsides s; meetings :=
    meetings s;
      meetings_reversed := meetings_reversed s; equals := equals s; witnesses := witnesses s; opens := opens s |}
  | Leaf Outside => {| splits := splits s; counts := counts s; outsides := N.succ (outsides s); meetings := meetings s;
      meetings_reversed := meetings_reversed s; equals := equals s; witnesses := witnesses s; opens := opens s |}
  | Leaf Meets => {| splits := splits s; counts := counts s; outsides := outsides s; meetings := N.succ (meetings s);
      meetings_reversed := meetings_reversed s; equals := equals s; witnesses := witnesses s; opens := opens s |}
  | Leaf Meets_reversed => {| splits := splits s; counts := counts s; outsides := outsides s; meetings := meetings s;
      meetings_reversed := N.succ (meetings_reversed s); equals := equals s; witnesses := witnesses s; opens :=
        opens s |}
  | Split _ l u => let s := tree_totals u (tree_totals l s) in
      {| splits := N.succ (splits s); counts := counts s; outsides := outsides s; meetings := meetings s;
         meetings_reversed := meetings_reversed s; equals := equals s; witnesses := witnesses s; opens := opens s |}
  end.
Definition piece_totals (s : totals) (P : piece) : totals :=
  let s := match bound P with Some (_, Charts b l) => tree_totals l (tree_totals b s) | _ => s end in
  {| splits := splits s; counts := counts s; outsides := outsides s; meetings := meetings s; meetings_reversed :=
    meetings_reversed s;
     equals := match bound P with Some (_, Equal_masses) => N.succ (equals s) | _ => equals s end;
     witnesses := match witness P with Some _ => N.succ (witnesses s) | None => witnesses s end;
     opens := match bound P with None => N.succ (opens s) | Some _ => opens s end |}.
Definition no_lines : totals := {| splits := 0; counts := 0; outsides := 0; meetings := 0; meetings_reversed :=
  0; equals := 0; witnesses := 0; opens := 0 |}.
Definition totals_text (s : totals) : list string :=
  ["total split " ++ decimal (splits s); "total count " ++ decimal (counts s); "total outside " ++ decimal (outsides s);
   "total meets " ++ decimal (meetings s); "total meets-reversed " ++ decimal (meetings_reversed s);
   "total equal-masses " ++ decimal (equals s); "total witness " ++ decimal (witnesses s);
     "total open " ++ decimal (opens s)].

Definition certificate_text (c : certificate) : list string :=
  "dumbbell-certificate 1" :: ("generator " ++ program c ++ " " ++ program_version c) :: "lemmas 1" :: "scene dumbbell"
    ::
  "section turning" :: "claim collisions" :: ("ratio " ++ ratio_text (range_from c) ++ " " ++ ratio_text (range_to c))
    ::
  ("pieces " ++ decimal (N.of_nat (List.length (pieces c)))) ::
  fold_right piece_text (totals_text (fold_left piece_totals (pieces c) no_lines)) (pieces c).
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
Definition short (n : N) : bool := (n <? 10 ^ 18)%N.
Definition ratio_canonical (x : ratio) : bool :=
  (Pos.gcd (num x) (den x) =? 1)%positive && (String.length (decimal (Npos (num x))) <=? 2100)%nat &&
    (String.length (decimal (Npos (den x))) <=? 2100)%nat.
Definition dyadic_canonical (x : dyadic) : bool :=
  (if (odd_part x =? 0)%N then (exponent x =? 0)%Z else N.odd (odd_part x)) &&
  (String.length (decimal (odd_part x)) <=? 1250)%nat && (Z.abs (exponent x) <=? 4096)%Z.
Definition contact_canonical (w : contact) : bool :=
  dyadic_canonical (contact_e w) && dyadic_canonical (contact_eta w) && short (after_X w) && short (after_reversed w).
(** At most 400 splits of each axis above a node. *)
Fixpoint tree_canonical (e slope q : nat) (t : tree) : bool :=
  match t with
  | Leaf (Count a b) => short a && short b
  | Leaf _ => true
  | Split axis_e l u => match e with O => false | S e => tree_canonical e slope q l && tree_canonical e slope q u end
  | Split axis_slope l u => match slope with O => false | S slope => tree_canonical e slope q l &&
    tree_canonical e slope q u end
  | Split axis_q l u => match q with O => false | S q => tree_canonical e slope q l && tree_canonical e slope q u end
  end.
Definition piece_canonical (P : piece) : bool :=
  ratio_canonical (from P) && ratio_canonical (to P) && (53 <=? bits P)%N && (bits P <=? 4096)%N &&
    short (attained P) &&
  match bound P with
  | Some (U, Charts b l) => short U && tree_canonical 400 400 400 b && tree_canonical 400 400 400 l
  | Some (U, Equal_masses) => short U
  | None => true
  end && match witness P with Some w => contact_canonical w && negb (attained P =? 0)%N | None => true end.
Definition canonical (c : certificate) : bool :=
  is_word false (program c) && is_word true (program_version c) && ratio_canonical (range_from c) &&
    ratio_canonical (range_to c) &&
  forallb piece_canonical (pieces c).
