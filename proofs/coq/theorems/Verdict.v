(** The whole way from the lines of a file to two masses and a floor: what it means that the checker answers
    `Verified`.

    proved, fault_none  == all that is printed, and was asked; it is true where the checker finds no fault
    faultless, all_parts == no fault in some pieces; a certificate in parts, each of which has none *)
From Coq Require Import Reals ZArith NArith List Lra String.
From Dumbbell Require Import Physics Certificate Check Text Reader Piece Range AtMostOnce KnownButInGaps.
Import ListNotations.
Local Open Scope R_scope.

(** What is printed after `s VERIFIED`, and what was asked. *)
Record proved (d : demand) (c : certificate) : Prop := {
  whole_range : forall q, ratio_value (range_from c) <= q <= ratio_value (range_to c) ->
    (forall U, greatest (pieces c) = Some U -> upper_bound q (N.to_nat U)) /\ lower_bound q (N.to_nat (least (pieces
      c))) /\ (says_heavy_once c = true -> heavy_once q);
  each_piece : forall P, In P (pieces c) -> forall q, in_piece P q ->
    (forall U w, bound P = Some (U, w) -> upper_bound q (N.to_nat U)) /\ lower_bound q (N.to_nat (attained P));
  as_asked : forall q, ratio_value (fst (range_asked d c)) <= q <= ratio_value (snd (range_asked d c)) ->
    (forall n, asked_most d = Some n -> upper_bound q (N.to_nat n)) /\ (forall n, asked_least d = Some n ->
      lower_bound q (N.to_nat n)) /\ (asked_once d = true -> heavy_once q);
  gaps_as_asked : known_as_asked d (pieces c) (ratio_value (fst (range_asked d c))) (ratio_value (snd (range_asked d c))) }.

Theorem fault_none again d c : certificate_fault again d c = None -> proved d c.
Proof.
  intros H. destruct (parts again d c H) as [_ [_ [Hp _]]].
  assert (Sound : forall P, In P (pieces c) -> forall q, in_piece P q -> _) by (intros P HP; exact (piece_sound P again (Hp P HP))).
  split.
  - intros q Hq. destruct (range_sound again d c H q Hq) as [_ [_ [_ [Q1 _]]]].
    destruct (summary_sound again d c H q Hq) as [U L]. repeat split; [exact U | exact L | intros _; now apply always_once].
  - intros P HP q Hq. apply (Sound P HP q Hq).
  - intros q Hq. destruct (range_asked d c) as [a b] eqn:E. destruct (demand_sound again d c H a b E q Hq) as [Q1 [U L]].
    repeat split; [exact U | exact L | intros _; now apply always_once].
  - destruct (range_asked d c) as [a b] eqn:E. intros A. apply gaps_sound; [exact Sound | | exact A].
    now apply (asked_of_pieces again d c H a b E).
Qed.

(** A certificate in parts, each of which the kernel has checked by itself. *)
Definition faultless (l : list piece) : bool := forallb (fun P => match piece_fault true P with None => true | Some _ =>
  false end) l.
Lemma faultless_app a b : faultless (a ++ b)%list = (faultless a && faultless b)%bool.
Proof. apply forallb_app. Qed.
Lemma faultless_first l : faultless l = true -> forall n, first_fault true n l = None.
Proof.
  induction l as [|P l IH]; intros H n; [reflexivity|]. simpl in *. apply Bool.andb_true_iff in H.
    destruct H as [H1 H2].
  destruct (piece_fault true P); [discriminate | now apply IH].
Qed.
Theorem all_parts d c : joined (range_from c) (pieces c) (range_to c) = true -> pieces c <> [] ->
  faultless (pieces c) = true ->
  unproved d c = None -> certificate_fault true d c = None.
Proof.
  intros H1 H2 H3 H4. unfold certificate_fault. rewrite H1. simpl. destruct (pieces c) as [|P l] eqn:E; [easy|].
  now rewrite (faultless_first _ H3).
Qed.

(** For any lines and any demand: if the checker accepts the lines, they are those of a certificate, and everything
  that it says of the
    mass ratios is true of two masses and a floor. *)
Theorem verdict_sound t sha256 d c : judge t sha256 d = Verified c ->
  t = file_text c sha256 /\ proved d c.
Proof.
  intros H. destruct (verified_text t sha256 d c H) as [A [_ [again B]]].
  split; [exact A | now apply (fault_none again)].
Qed.

(** certificates/q-10.dbc as a term; and, as it is nothing less, N(10) = 4. *)
Definition one_leaf a b := Leaf (Count a b).
Definition half : dyadic := {| odd_part := 1; exponent := -1 |}.
Definition ten : ratio := {| num := 10; den := 1 |}.
Definition q_10 : certificate := {| program := "dumbbell"; program_version := "0.1.0"; about := turning;
  range_from := ten; range_to := ten;
  pieces := [{| from := ten; to := ten; bits := 53; bound := Some (4%N, Charts (one_leaf 1 2) (one_leaf 1 1));
    attained := 4;
    witness := Some {| contact_e := half; contact_eta := half; after_X := 1; after_reversed := 2 |} |}] |}.
Definition nothing_asked : demand := {| asked_range := None; asked_most := None; asked_least := None;
  asked_gap := None; asked_gaps := None; asked_once := false |}.
Lemma q_10_accepted : certificate_fault true nothing_asked q_10 = None.
Proof. vm_cast_no_check (eq_refl (@None string)). Qed.
Theorem N_of_10 : N_star 10 4.
Proof.
  destruct (whole_range _ _ (fault_none _ _ _ q_10_accepted) 10) as [A [B _]]; [unfold ratio_value; simpl; lra|].
    split; [exact (A 4%N eq_refl) | exact B].
Qed.
