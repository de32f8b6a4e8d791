(** The whole way from the lines of a file to two masses and a floor: what it means that the checker answers
  `Verified`. *)
From Coq Require Import Reals ZArith NArith List Lra String.
From Dumbbell Require Import Physics Certificate Check Text Reader Piece Range.
Import ListNotations.
Local Open Scope R_scope.

(** What is printed after `s VERIFIED`, and what was asked. *)
Record proved (d : demand) (c : certificate) : Prop := {
  whole_range : forall q, ratio_value (range_from c) <= q <= ratio_value (range_to c) ->
    (forall U, greatest (pieces c) = Some U -> upper_bound q (N.to_nat U)) /\ lower_bound q (N.to_nat (least (pieces
      c)));
  each_piece : forall P, In P (pieces c) -> forall q, in_piece P q ->
    (forall U w, bound P = Some (U, w) -> upper_bound q (N.to_nat U)) /\ lower_bound q (N.to_nat (attained P));
  as_asked : forall q, ratio_value (fst (range_asked d c)) <= q <= ratio_value (snd (range_asked d c)) ->
    (forall n, asked_most d = Some n -> upper_bound q (N.to_nat n)) /\ (forall n, asked_least d = Some n ->
      lower_bound q (N.to_nat n)) }.

Theorem fault_none again d c : certificate_fault again d c = None -> proved d c.
Proof.
  intros H. split.
  - intros q Hq. now apply (summary_sound again d c H).
  - intros P HP q Hq. apply (piece_sound P again); [|exact Hq]. unfold certificate_fault in H. destruct (joined _ _ _);
    [|discriminate]. simpl in H.
    destruct (pieces c) as [|Q l] eqn:E; [easy|]. destruct (first_fault again 1 (Q :: l)) eqn:F; [discriminate|].
      now apply first_fault_none with (2 := HP) (n := 1%N).
  - intros q Hq. destruct (range_asked d c) as [a b] eqn:E. now apply (demand_sound again d c H a b E q Hq).
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
Definition nothing_asked : demand := {| asked_range := None; asked_most := None; asked_least := None |}.
Lemma q_10_accepted : certificate_fault true nothing_asked q_10 = None.
Proof. vm_cast_no_check (eq_refl (@None string)). Qed.
Theorem N_of_10 : N_star 10 4.
Proof.
  destruct (whole_range _ _ (fault_none _ _ _ q_10_accepted) 10) as [A B]; [unfold ratio_value; simpl; lra|].
    split; [exact (A 4%N eq_refl) | exact B].
Qed.
