(** A certificate of a range: accepted pieces that join without a hole say what N(q) is for every q of the range,
  and prove what was
    asked of them.

    demand_sound, summary_sound == what was asked, and what the file says, is true of every ratio of the range
    asked_of_pieces             == what was asked, as the checker finds it of the pieces
    parts, covered_sound        == what it is to be accepted; a range that is covered by good pieces
    upper_le, lower_le          == weaker bounds *)
From Coq Require Import Reals ZArith NArith List Lra Lia Bool.
From Dumbbell Require Import Physics Certificate Check Scaling Maximum Piece.
Import ListNotations.
Local Open Scope R_scope.

Lemma upper_le q m n : (m <= n)%nat -> upper_bound q m -> upper_bound q n.
Proof. intros H U P p HP Hq Hm l Hl Hc. specialize (U P p HP Hq Hm l Hl Hc). lia. Qed.
Lemma lower_le q m n : (m <= n)%nat -> lower_bound q n -> lower_bound q m.
Proof. intros H L P HP Hq. destruct (L P HP Hq) as [p [Hp Hl]]. exists p. split; [exact Hp|].
  now apply at_least_le with n. Qed.

(** Between lo and hi each q lies in one of the pieces that are good. *)
Definition cover_of (good : piece -> bool) (l : list piece) (q : R) := exists P, In P l /\ good P = true /\
  in_piece P q.

Lemma arrive_sound good a l : forall before reached,
  (forall x, reached = Some x -> forall q, ratio_value a <= q <= ratio_value x -> cover_of good before q) ->
  forall x, fold_left (arrive good a) l reached = Some x -> forall q, ratio_value a <= q <= ratio_value x ->
    cover_of good (before ++ l) q.
Proof.
  induction l as [|P l IH]; intros before reached HB x H q Hq; simpl in H.
  - rewrite app_nil_r. now apply (HB x).
  - change (P :: l) with ([P] ++ l). rewrite app_assoc. apply (IH (before ++ [P])%list (arrive good a reached P)) with
    (x := x); [|exact H|exact Hq].
    clear x H q Hq IH. intros x Hx q Hq. unfold arrive in Hx.
    assert (Old : forall y, reached = Some y -> ratio_value a <= q <= ratio_value y -> cover_of good (before ++ [P]) q).
    { intros y Hy Hqy. destruct (HB y Hy q Hqy) as [Q [Q1 Q2]]. exists Q. split; [apply in_app_iff;
      now left | exact Q2]. }
    assert (New : good P = true -> ratio_value (from P) <= q <= ratio_value (to P) -> cover_of good (before ++ [P]) q).
    { intros G Hp. exists P. split; [apply in_app_iff; right; now left|]. now split. }
    destruct (good P) eqn:G; simpl in Hx; [|now apply (Old x)].
    destruct reached as [y|].
    + destruct (ratio_le (from P) y) eqn:E; [|now apply (Old x)]. injection Hx; intros <-. apply ratio_le_ok in E.
      destruct (Rle_or_lt q (ratio_value y)); [apply (Old y); [reflexivity | lra] | apply New; [reflexivity | lra]].
    + destruct (ratio_le (from P) a && ratio_le a (to P)) eqn:E; [|discriminate]. apply andb_prop in E;
      destruct E as [E1 E2].
      injection Hx; intros <-. apply ratio_le_ok in E1. apply New; [reflexivity | lra].
Qed.
Lemma covered_sound good a b l : covered good a b l = true -> forall q, ratio_value a <= q <= ratio_value b ->
  cover_of good l q.
Proof.
  unfold covered. intros H q Hq. destruct (fold_left (arrive good a) l None) as [x|] eqn:E; [|discriminate].
    apply ratio_le_ok in H.
  apply (arrive_sound good a l [] None) with (x := x); [discriminate | exact E | lra].
Qed.

Lemma first_fault_none again l : forall n, first_fault again n l = None -> forall P, In P l -> piece_fault again P = None.
Proof.
  induction l as [|Q l IH]; intros n H P HP; simpl in *; [easy|]. destruct (piece_fault again Q) eqn:E; [discriminate|].
  destruct HP as [<-|HP]; [exact E | now apply IH with (n + 1)%N].
Qed.
Lemma joined_covers l : forall a b, joined a l b = true -> forall q, ratio_value a <= q < ratio_value b ->
  exists P, In P l /\ in_piece P q.
Proof.
  induction l as [|P l IH]; intros a b H q Hq; simpl in H.
  - apply ratio_eq_ok in H. lra.
  - apply andb_prop in H; destruct H as [H1 H2]. apply ratio_eq_ok in H1.
    destruct (Rle_or_lt q (ratio_value (to P))) as [K|K].
    + exists P. split; [now left|]. unfold in_piece. lra.
    + destruct (IH (to P) b H2 q ltac:(lra)) as [Q [Q1 Q2]]. exists Q. split; [now right | exact Q2].
Qed.
Lemma joined_last l : forall a b, l <> [] -> joined a l b = true -> exists P, In P l /\
  ratio_value (to P) = ratio_value b.
Proof.
  induction l as [|P l IH]; intros a b Hl H; simpl in H; [easy|]. apply andb_prop in H; destruct H as [_ H].
    destruct l as [|Q l].
  - simpl in H. apply ratio_eq_ok in H. exists P. split; [now left | exact H].
  - destruct (IH (to P) b ltac:(discriminate) H) as [R [R1 R2]]. exists R. split; [now right | exact R2].
Qed.

Section Certificate.
Variable again : bool.
Variable d : demand.
Variable c : certificate.
Hypothesis accepted : certificate_fault again d c = None.
Lemma parts : joined (range_from c) (pieces c) (range_to c) = true /\ pieces c <> [] /\ (forall P, In P (pieces c) ->
  piece_fault again P = None) /\ unproved d c = None.
Proof.
  unfold certificate_fault in accepted. destruct (joined _ _ _); [|discriminate]. simpl in accepted.
  destruct (pieces c) as [|P l] eqn:E; [discriminate|]. destruct (first_fault again 1 (P :: l)) eqn:F; [discriminate|].
  repeat split; try easy. now apply first_fault_none with (n := 1%N).
Qed.

(** Every mass ratio of the file lies in a piece, and that piece tells the truth. *)
Theorem range_sound q : ratio_value (range_from c) <= q <= ratio_value (range_to c) ->
  exists P, In P (pieces c) /\ in_piece P q /\ 1 <= q /\
    (forall U w, bound P = Some (U, w) -> upper_bound q (N.to_nat U)) /\ lower_bound q (N.to_nat (attained P)).
Proof.
  intros Hq. destruct parts as [J [Hne [Hp _]]].
  assert (K : exists P, In P (pieces c) /\ in_piece P q).
  { destruct (Rlt_or_le q (ratio_value (range_to c))) as [L|L]; [now apply joined_covers with (1 := J)|].
    destruct (joined_last _ _ _ Hne J) as [P [P1 P2]]. exists P. split; [exact P1|]. unfold in_piece.
    assert (F := Hp P P1). unfold piece_fault in F. destruct (ratio_le one (from P)); [|discriminate]. simpl in F.
    destruct (ratio_le (from P) (to P)) eqn:E; [|discriminate]. apply ratio_le_ok in E. lra. }
  destruct K as [P [P1 P2]]. exists P. split; [exact P1|]. split; [exact P2|]. exact (piece_sound P again (Hp P P1) q P2).
Qed.

Lemma asked_of_pieces a b : range_asked d c = (a, b) -> covered (fun _ => true) a b (pieces c) = true /\
  if_asked (asked_most d) (fun n => covered (at_most_in n) a b (pieces c)) = true /\
  if_asked (asked_least d) (fun n => covered (at_least_in n) a b (pieces c)) = true /\
  (asks_of_gaps d = true -> known_but_in_gaps d a b (pieces c) = true) /\ (asked_once d = true -> says_heavy_once c = true).
Proof.
  intros Hab. destruct parts as [_ [_ [_ H]]]. unfold unproved in H. rewrite Hab in H.
  repeat (apply first_of_none in H; destruct H as [?K H]). unfold unless in *.
  destruct (covered _ a b _); [|discriminate]. destruct (if_asked (asked_most d) _); [|discriminate].
  destruct (if_asked (asked_least d) _); [|discriminate]. repeat split.
  - intros A. rewrite A in *. now destruct (known_but_in_gaps d a b _).
  - intros A. rewrite A in *. now destruct (says_heavy_once c).
Qed.
(** The bounds that were asked for are proved. *)
Theorem demand_sound a b : range_asked d c = (a, b) -> forall q, ratio_value a <= q <= ratio_value b ->
  1 <= q /\ (forall n, asked_most d = Some n -> upper_bound q (N.to_nat n)) /\ (forall n, asked_least d = Some n ->
    lower_bound q (N.to_nat n)).
Proof.
  intros Hab q Hq. destruct (asked_of_pieces a b Hab) as [C0 [C1 [C2 _]]]. destruct parts as [_ [_ [Hp _]]].
  assert (One : forall good, covered good a b (pieces c) = true -> exists P, good P = true /\ 1 <= q /\
    (forall U w, bound P = Some (U, w) -> upper_bound q (N.to_nat U)) /\ lower_bound q (N.to_nat (attained P))).
  { intros good C. destruct (covered_sound _ _ _ _ C q Hq) as [P [P1 [P2 P3]]]. exists P. split; [exact P2|].
    exact (piece_sound P again (Hp P P1) q P3). }
  destruct (One _ C0) as [_ [_ [Q1 _]]]. split; [exact Q1|]. split.
  - intros n K. rewrite K in C1. destruct (One _ C1) as [P [P2 [_ [U _]]]]. unfold at_most_in in P2.
    destruct (bound P) as [[u w]|]; [|discriminate]. apply N.leb_le in P2.
    apply upper_le with (N.to_nat u); [lia | now apply U with w].
  - intros n K. rewrite K in C2. destruct (One _ C2) as [P [P2 [_ [_ L]]]]. unfold at_least_in in P2. apply N.leb_le in P2.
    apply lower_le with (N.to_nat (attained P)); [lia | exact L].
Qed.

Lemma greatest_ge l : forall u U, fold_left (fun u P => match u, bound P with Some u, Some (v, _) =>
  Some (N.max u v) | _, _ => None end) l u = Some U ->
  (exists u0, u = Some u0 /\ (u0 <= U)%N) /\ forall P, In P l -> exists V w, bound P = Some (V, w) /\ (V <= U)%N.
Proof.
  induction l as [|P l IH]; intros u U H; simpl in H.
  - split; [|easy]. exists U. split; [exact H | lia].
  - apply IH in H. destruct H as [[u0 [E1 E2]] HL]. destruct u as [u|]; [|discriminate].
    destruct (bound P) as [[V w]|] eqn:EB; [|discriminate].
    injection E1; intros <-. split; [exists u; split; [easy | lia]|]. intros Q [<-|HQ]; [|now apply HL]. exists V, w.
      split; [exact EB | lia].
Qed.
Lemma least_fold l : forall v, (fold_left (fun v Q => N.min v (attained Q)) l v <= v)%N /\ forall P, In P l ->
  (fold_left (fun v Q => N.min v (attained Q)) l v <= attained P)%N.
Proof.
  induction l as [|P l IH]; intros v; simpl; [split; [lia | easy]|]. destruct (IH (N.min v (attained P))) as [A B].
    split; [lia|].
  intros Q [<-|HQ]; [lia | now apply B].
Qed.
Lemma least_le l P : In P l -> (least l <= attained P)%N.
Proof. destruct l as [|Q l]; [easy|]. unfold least. destruct (least_fold l (attained Q)) as [A B].
  intros [<-|H]; [exact A | now apply B]. Qed.

(** The numbers of the verdict line hold for every mass ratio of the file. *)
Theorem summary_sound q : ratio_value (range_from c) <= q <= ratio_value (range_to c) ->
  (forall U, greatest (pieces c) = Some U -> upper_bound q (N.to_nat U)) /\ lower_bound q (N.to_nat (least (pieces c))).
Proof.
  intros Hq. destruct (range_sound q Hq) as [P [P1 [P2 [_ [PU PL]]]]]. split.
  - intros U H. destruct (greatest_ge _ _ _ H) as [_ HL]. destruct (HL P P1) as [V [w [EB LE]]].
    apply upper_le with (N.to_nat V); [lia | now apply PU with w].
  - apply lower_le with (N.to_nat (attained P)); [|exact PL]. assert (K := least_le _ _ P1). lia.
Qed.
End Certificate.
