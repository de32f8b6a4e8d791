(** What a certificate of the section `turning` or `full` is, once it is read (docs/reference/format.md, sections 2 and
    3; format-sections.md, sections 1 and 2), with the exact boxes of its trees. Nothing here is about rays or floating
    point: Text.v says how a certificate is written in lines, Leaves.v and FullLeaves.v what a leaf must satisfy.

    ratio, ratio_value, ratio_le, ratio_eq == a positive fraction, its value, and comparisons of two
    dyadic, span, box == a number m/2^n, a stretch of an axis between two, a box in three axes; in_box: a point is in it
    certificate, piece, cover, tree, reason, contact == what a file says: pieces, trees, why a leaf holds, a witness
    check_tree == each leaf of a tree holds in its box; check_tree_sound: then the whole box is covered
    chart_box, wide_enough == a chart's root box over a range of ratios, and that it holds the whole chart *)
From Coq Require Import Reals ZArith NArith Lra Lia List Bool String.
From Dumbbell Require Import Signs.
Local Open Scope R_scope.

Record ratio := { num : positive; den : positive }.
Definition ratio_value (x : ratio) : R := IZR (Zpos (num x)) / IZR (Zpos (den x)).
Definition ratio_le (x y : ratio) : bool := (num x * den y <=? num y * den x)%positive.
Definition ratio_eq (x y : ratio) : bool := (num x * den y =? num y * den x)%positive.

(** The number odd * 2^exponent. *)
Record dyadic := { odd_part : N; exponent : Z }.

Inductive axis := axis_e | axis_slope | axis_q.
(** [Forward] and [Plain] are `count` with one hint, the latter with `lemmas minimal`. *)
Inductive reason := Count (a b : N) | Forward (a : N) | Plain (a : N) | Outside | Meets | Meets_reversed | Once.
Inductive chart := Bridge | Light | Contact | Departure | Again.
Inductive tree := Leaf (why : reason) | Split (halved : axis) (lower upper : tree).
Inductive cover := Equal_masses | Charts (bridge light : tree) | Full_charts (contact departure again : tree).
Record contact := { contact_e : dyadic; contact_eta : dyadic; after_X : N; after_reversed : N }.
(** For each mass ratio in [from, to]: at most the number in [bound] of collisions, if there is one;
  some motion has [attained],
    which the witness shows unless it is 0. *)
Record piece := { from : ratio; to : ratio; bits : N; bound : option (N * cover); attained : N;
  witness : option contact }.
(** [full_minimal] is the section full with `lemmas minimal`. *)
Inductive section := turning | full | full_minimal.
Record certificate := { program : string; program_version : string; about : section; range_from : ratio;
  range_to : ratio; pieces : list piece }.

Lemma ratio_cross x y : ratio_value x * (IZR (Zpos (den x)) * IZR (Zpos (den y))) = IZR (Zpos (num x * den y)) /\
  ratio_value y * (IZR (Zpos (den x)) * IZR (Zpos (den y))) = IZR (Zpos (num y * den x)).
Proof.
  unfold ratio_value. rewrite !Pos2Z.inj_mul, !mult_IZR. assert (0 < IZR (Zpos (den x))) by pos.
  assert (0 < IZR (Zpos (den y))) by pos. split; field; lra.
Qed.
Lemma ratio_le_ok x y : ratio_le x y = true -> ratio_value x <= ratio_value y.
Proof.
  unfold ratio_le. intros H. apply Pos.leb_le in H. destruct (ratio_cross x y) as [A B].
  assert (0 < IZR (Zpos (den x)) * IZR (Zpos (den y))) by pos.
  apply Rmult_le_reg_r with (IZR (Zpos (den x)) * IZR (Zpos (den y))); [assumption|]. rewrite A, B. now apply IZR_le.
Qed.
Lemma ratio_le_not x y : ratio_le x y = false -> ratio_value y < ratio_value x.
Proof.
  unfold ratio_le. intros H. apply Pos.leb_gt in H. destruct (ratio_cross x y) as [A B].
  assert (0 < IZR (Zpos (den x)) * IZR (Zpos (den y))) by pos.
  apply Rmult_lt_reg_r with (IZR (Zpos (den x)) * IZR (Zpos (den y))); [assumption|]. rewrite A, B. now apply IZR_lt.
Qed.
Lemma ratio_eq_ok x y : ratio_eq x y = true -> ratio_value x = ratio_value y.
Proof.
  unfold ratio_eq. intros H. apply Pos.eqb_eq in H. apply Rle_antisym; apply ratio_le_ok; unfold ratio_le; rewrite H;
    apply Pos.leb_refl.
Qed.

(** An interval with rational ends: [low / part, high / part]. *)
Record span := { low_end : Z; high_end : Z; part : positive }.
Definition in_span (x : R) (s : span) := IZR (low_end s) / IZR (Zpos (part s)) <= x <= IZR (high_end s) / IZR (Zpos
  (part s)).
Definition lower_half (s : span) := {| low_end := 2 * low_end s; high_end := low_end s + high_end s; part :=
  2 * part s |}.
Definition upper_half (s : span) := {| low_end := low_end s + high_end s; high_end := 2 * high_end s; part :=
  2 * part s |}.
Lemma halves x s : in_span x s -> in_span x (lower_half s) \/ in_span x (upper_half s).
Proof.
  unfold in_span, lower_half, upper_half; cbn [low_end high_end part]. intros H.
  change (Zpos (2 * part s)) with (2 * Zpos (part s))%Z. rewrite plus_IZR, !mult_IZR.
  assert (P : 0 < IZR (Zpos (part s))) by pos. set (d := IZR (Zpos (part s))) in *. set (l := IZR (low_end s)) in *.
  set (h := IZR (high_end s)) in *. replace (2 * l / (2 * d)) with (l / d) by (field; lra).
  replace (2 * h / (2 * d)) with (h / d) by (field; lra).
  destruct (Rle_or_lt x ((l + h) / (2 * d))); [left | right]; lra.
Qed.

(** Corner distance, slope (eta or lambda) and mass ratio. *)
Record box := { box_e : span; box_slope : span; box_q : span }.
Definition in_box e y q b := in_span e (box_e b) /\ in_span y (box_slope b) /\ in_span q (box_q b).
Definition box_half (half : span -> span) (a : axis) (b : box) : box :=
  match a with
  | axis_e => {| box_e := half (box_e b); box_slope := box_slope b; box_q := box_q b |}
  | axis_slope => {| box_e := box_e b; box_slope := half (box_slope b); box_q := box_q b |}
  | axis_q => {| box_e := box_e b; box_slope := box_slope b; box_q := half (box_q b) |}
  end.
Definition splittable (a : axis) (b : box) : bool :=
  let s := match a with axis_e => box_e b | axis_slope => box_slope b | axis_q => box_q b end in (low_end s <? high_end
    s)%Z.
Fixpoint check_tree (leaf : box -> reason -> bool) (b : box) (t : tree) : bool :=
  match t with
  | Leaf why => leaf b why
  | Split a l u => if splittable a b then if check_tree leaf (box_half lower_half a b) l
                   then check_tree leaf (box_half upper_half a b) u else false else false
  end.
Lemma check_tree_sound leaf (Q : R -> R -> R -> Prop) :
  (forall b why, leaf b why = true -> forall e y q, in_box e y q b -> Q e y q) ->
  forall t b, check_tree leaf b t = true -> forall e y q, in_box e y q b -> Q e y q.
Proof.
  intros HL. induction t as [why|a l IHl u IHu]; simpl; intros b H e y q Hin; [now apply HL with (1 := H)|].
  destruct (splittable a b); [|discriminate]. destruct (check_tree leaf _ l) eqn:E; [|discriminate].
  assert (K : in_box e y q (box_half lower_half a b) \/ in_box e y q (box_half upper_half a b)).
  { destruct Hin as [A [B C]]. destruct a; unfold in_box; simpl; [destruct (halves _ _ A) | destruct (halves _ _ B) |
    destruct (halves _ _ C)]; tauto. }
  destruct K as [K|K]; [now apply IHl with (1 := E) | now apply IHu with (1 := H)].
Qed.

(** The root boxes: e in [0, 2], t in [0, 4]; eta or lambda in [0, 2^k] with 2^k >= to, or to + 1, or in [0, 2]; q in
    [from, to]. *)
Definition least_power (x : ratio) : Z :=
  let k := Z.log2_up (Zpos (num x) / Zpos (den x)) in let y := (2 ^ k)%Z in if (Zpos (num x) <=? y * Zpos (den x))%Z
    then y else (2 * y)%Z.
Definition root_box (e slope : Z) (a b : ratio) : box :=
  {| box_e := {| low_end := 0; high_end := e; part := 1 |};
     box_slope := {| low_end := 0; high_end := slope; part := 1 |};
     box_q := {| low_end := Zpos (num a * den b); high_end := Zpos (num b * den a); part := den a * den b |} |}.
Definition one_more (x : ratio) : ratio := {| num := num x + den x; den := den x |}.
Definition chart_box (c : chart) (a b : ratio) : box :=
  match c with
  | Bridge | Light => root_box 2 (least_power b) a b
  | Contact | Again => root_box 4 (least_power (one_more b)) a b
  | Departure => root_box 2 2 a b
  end.
Definition wide_enough (b : ratio) : bool := (Zpos (num b) <=? least_power b * Zpos (den b))%Z.
Lemma wide_enough_ok b : wide_enough b = true -> ratio_value b <= IZR (least_power b).
Proof.
  unfold wide_enough, ratio_value. intros H. apply Z.leb_le, IZR_le in H. rewrite mult_IZR in H.
  assert (B : 0 < IZR (Zpos (den b))) by pos. apply Rmult_le_reg_r with (IZR (Zpos (den b))); [exact B|]. unfold Rdiv.
  rewrite Rmult_assoc, Rinv_l by lra. lra.
Qed.
Lemma one_more_ok x : ratio_value (one_more x) = ratio_value x + 1.
Proof.
  unfold ratio_value, one_more; cbn [num den]. rewrite Pos2Z.inj_add, plus_IZR.
  assert (0 < IZR (Zpos (den x))) by pos. field. lra.
Qed.
Lemma in_root a b e y q e1 y1 : 0 <= e <= IZR e1 -> 0 <= y <= IZR y1 -> ratio_value a <= q <= ratio_value b ->
  in_box e y q (root_box e1 y1 a b).
Proof.
  intros He Hy Hq. unfold in_box, in_span; simpl box_e; simpl box_slope; simpl box_q; simpl low_end; simpl high_end.
  simpl part. split; [lra|]. split; [lra|].
  destruct (ratio_cross a b) as [E1 E2].
  assert (D : 0 < IZR (Zpos (den a)) * IZR (Zpos (den b))) by pos. rewrite <- E1, <- E2, Pos2Z.inj_mul, mult_IZR.
  set (d := IZR (Zpos (den a)) * IZR (Zpos (den b))) in *.
  replace (ratio_value a * d / d) with (ratio_value a) by (field; lra).
  replace (ratio_value b * d / d) with (ratio_value b) by (field; lra). exact Hq.
Qed.

(** For the command line, which takes other spellings of a ratio than a file has. *)
Definition lowest_terms (x : ratio) : ratio :=
  let d := Pos.gcd (num x) (den x) in
  {| num := Z.to_pos (Zpos (num x) / Zpos d); den := Z.to_pos (Zpos (den x) / Zpos d) |}.
