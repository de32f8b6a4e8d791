(** What it means that a certificate knows N(q) in a range but in gaps, and that this is so of accepted pieces from
    which Check.known_but_in_gaps finds it.

    known, known_but_in == the certificate says what N(q) is; it does so in a range, but in these gaps
    known_as_asked      == it does so but in gaps as they were asked for; gaps_sound: that is so *)
From Coq Require Import Reals ZArith NArith List Lra Lia Bool.
From Dumbbell Require Import Statement Certificate Gaps Check Scaling Maximum Piece Range.
Import ListNotations.
Local Open Scope R_scope.

(** N(q) is n, and the pieces of q say so. *)
Definition known (l : list piece) (q : R) (n : N) := N_star q (N.to_nat n) /\
  (exists P w, In P l /\ in_piece P q /\ bound P = Some (n, w)) /\
  (exists P, In P l /\ in_piece P q /\ attained P = n).
(** The gaps are stretches [x, y] of [lo, hi]. Outside of them the pieces say what N(q) is; it does not change between
    two ratios with no gap between them. Everywhere it is one of two neighbouring numbers. *)
Record known_but_in (gaps : list (R * R)) (l : list piece) (lo hi : R) : Prop := {
  inside : forall x y, In (x, y) gaps -> lo <= x /\ x < y /\ y <= hi;
  outside : forall q q', lo <= q -> q <= q' -> q' <= hi -> (forall x y, In (x, y) gaps -> y < q \/ q' < x) ->
    exists n, known l q n /\ known l q' n;
  neighbours : forall q, lo <= q <= hi -> exists n, lower_bound q n /\ upper_bound q (S n) }.

(** What was asked of the gaps in [lo, hi]: their relative width is at most n/e, and they are so many, or fewer. *)
Definition known_as_asked (d : demand) (l : list piece) (lo hi : R) := asks_of_gaps d = true ->
  exists gaps, known_but_in gaps l lo hi /\
    (forall n e, asked_gap d = Some (n, e) -> forall x y, In (x, y) gaps -> y - x <= IZR (Z.of_N n) / IZR (Zpos e) * x) /\
    (forall n, asked_gaps d = Some n -> (length gaps <= N.to_nat n)%nat).

Section Pieces.
Variable l : list piece.
Hypothesis sound : forall P, In P l -> forall q, in_piece P q -> 1 <= q /\
  (forall U w, bound P = Some (U, w) -> upper_bound q (N.to_nat U)) /\ lower_bound q (N.to_nat (attained P)).

Lemma both_known P Q q w n : In P l -> In Q l -> in_piece P q -> in_piece Q q -> bound P = Some (n, w) -> attained Q = n ->
  known l q n.
Proof.
  intros HP HQ Pq Qq B A. split; [|split; [now exists P, w | now exists Q]].
  destruct (sound P HP q Pq) as [_ [U _]]. destruct (sound Q HQ q Qq) as [_ [_ L]]. rewrite A in L.
  split; [now apply (U n w) | exact L].
Qed.
Lemma known_unique q m n : known l q m -> known l q n -> m = n.
Proof.
  intros [H [[P [_ [HP [Pq _]]]] _]] [K _]. destruct (sound P HP q Pq) as [Q _].
  apply N2Nat.inj, (N_unique q); [lra | exact H | exact K].
Qed.

Lemma divides_ok a b P : In P l -> divides a b P = true -> ratio_value (from P) <= ratio_value b /\
  ratio_value a <= ratio_value (to P) /\ exists n, forall q, in_piece P q -> known l q n.
Proof.
  unfold divides. intros HP H. apply andb_prop in H; destruct H as [H _]. apply andb_prop in H; destruct H as [H E].
  destruct (concerns_ok a b P H) as [A B]. split; [exact A|]. split; [exact B|]. unfold is_exact in E.
  destruct (bound P) as [[U w]|] eqn:F; [|discriminate]. apply N.eqb_eq in E. exists U. intros q Hq.
  now apply (both_known P P q w U).
Qed.

Lemma gaps_inside b k : incl k l -> forall a s, In s (gaps a b k) -> ratio_value a <= ratio_value (fst s) /\
  ratio_value (fst s) < ratio_value (snd s) /\ ratio_value (snd s) <= ratio_value b.
Proof.
  induction k as [|P k IH]; intros I a s H; simpl in H.
  - apply stretch_in in H. destruct H as [-> H]. simpl. lra.
  - apply incl_cons_inv in I. destruct I as [HP I]. destruct (divides a b P) eqn:D; [|now apply IH].
    destruct (divides_ok a b P HP D) as [A [B _]]. apply in_app_or in H. destruct H as [H|H].
    + apply stretch_in in H. destruct H as [-> H]. simpl. lra.
    + apply (IH I) in H. lra.
Qed.

(** No gap of [gaps] meets [q, q']. *)
Definition clear (gaps : list (ratio * ratio)) q q' := forall s, In s gaps -> ratio_value (snd s) < q \/ q' < ratio_value (fst s).
Lemma clear_from a b q q' P k : clear (stretch a (from P) ++ gaps (to P) b k) q q' -> ratio_value a <= q <= q' ->
  ratio_value (from P) <= q /\ clear (gaps (to P) b k) q q'.
Proof.
  intros H Hq. split; [|intros s Hs; apply H, in_or_app; now right].
  destruct (Rle_or_lt (ratio_value (from P)) (ratio_value a)) as [L|L]; [lra|].
  destruct (H (a, from P)) as [K|K]; [apply in_or_app; left; now apply stretch_has | |]; simpl in K; lra.
Qed.
(** From a place where the number is known, up to the next gap. *)
Lemma known_on b q' k : incl k l -> forall a n, known l (ratio_value a) n -> ratio_value a <= q' <= ratio_value b ->
  clear (gaps a b k) (ratio_value a) q' -> known l q' n.
Proof.
  induction k as [|P k IH]; intros I a n Hn Hq H; simpl in H.
  - destruct (Rle_or_lt (ratio_value b) (ratio_value a)) as [L|L]; [replace q' with (ratio_value a) by lra; exact Hn|].
    destruct (H (a, b) (stretch_has a b L)) as [K|K]; simpl in K; lra.
  - apply incl_cons_inv in I. destruct I as [HP I]. destruct (divides a b P) eqn:D; [|now apply (IH I a)].
    destruct (divides_ok a b P HP D) as [_ [B [m Hm]]]. apply clear_from in H; [|lra]. destruct H as [A H].
    rewrite (known_unique _ _ _ Hn (Hm (ratio_value a) ltac:(unfold in_piece; lra))).
    destruct (Rle_or_lt q' (ratio_value (to P))) as [L|L]; [apply Hm; unfold in_piece; lra|].
    apply (IH I (to P)); [apply Hm; unfold in_piece; lra | lra |].
    intros s Hs. destruct (H s Hs) as [K|K]; [left; lra | now right].
Qed.
Lemma gaps_outside b q q' k : incl k l -> forall a, ratio_value a <= q <= q' -> q' <= ratio_value b ->
  ratio_value a < ratio_value b -> clear (gaps a b k) q q' -> exists n, known l q n /\ known l q' n.
Proof.
  induction k as [|P k IH]; intros I a Hq Hq' L H; simpl in H.
  - destruct (H (a, b) (stretch_has a b L)) as [K|K]; simpl in K; lra.
  - apply incl_cons_inv in I. destruct I as [HP I]. destruct (divides a b P) eqn:D; [|now apply (IH I a)].
    destruct (divides_ok a b P HP D) as [_ [B [n Hn]]]. apply clear_from in H; [|lra]. destruct H as [A H].
    destruct (Rle_or_lt q (ratio_value (to P))) as [M|M]; [|apply (IH I (to P)); try assumption; lra].
    exists n. split; [apply Hn; unfold in_piece; lra|].
    destruct (Rle_or_lt q' (ratio_value (to P))) as [K|K]; [apply Hn; unfold in_piece; lra|].
    apply (known_on b q' k I (to P)); [apply Hn; unfold in_piece; lra | lra |].
    intros s Hs. destruct (H s Hs) as [J|J]; [left; lra | now right].
Qed.

Lemma known_at_sound a : known_at a l = true -> exists n, known l (ratio_value a) n.
Proof.
  assert (Here : forall P, In P (filter (concerns a a) l) -> In P l /\ in_piece P (ratio_value a)).
  { intros P H. apply filter_In in H. destruct H as [H K]. split; [exact H | exact (concerns_ok a a P K)]. }
  unfold known_at. intros H. apply existsb_exists in H. destruct H as [P [HP H]]. destruct (bound P) as [[U w]|] eqn:B; [|discriminate].
  apply existsb_exists in H. destruct H as [Q [HQ H]]. apply N.eqb_eq in H. apply Here in HP, HQ. exists U.
  now apply (both_known P Q _ w).
Qed.

Theorem gaps_sound d a b : known_but_in_gaps d a b l = true -> known_as_asked d l (ratio_value a) (ratio_value b).
Proof.
  unfold known_but_in_gaps. intros K _. destruct (ratio_le b a) eqn:E.
  - apply ratio_le_ok in E. destruct (known_at_sound a K) as [n Hn]. exists []. split; [split|].
    + easy.
    + intros q q' A B C _. exists n. now replace q with (ratio_value a) by lra; replace q' with (ratio_value a) by lra.
    + intros q Hq. replace q with (ratio_value a) by lra. exists (N.to_nat n). destruct Hn as [[U L] _]. split; [exact L|].
      apply upper_le with (2 := U). lia.
    + split; [easy | simpl; lia].
  - apply ratio_le_not in E. apply andb_prop in K; destruct K as [K Number]. apply andb_prop in K; destruct K as [K Width].
    apply andb_prop in K; destruct K as [Cover Open]. exists (map values (gaps a b l)).
    assert (Out : forall x y, In (x, y) (map values (gaps a b l)) <-> exists s, In s (gaps a b l) /\ values s = (x, y)).
    { intros x y. rewrite in_map_iff. split; intros [s [A B]]; exists s; now split. }
    split; [split|].
    + intros x y H. apply Out in H. destruct H as [s [H V]]. injection V; intros <- <-. now apply (gaps_inside b l (incl_refl l)).
    + intros q q' A B C H. apply (gaps_outside b q q' l (incl_refl l) a); [lra | exact C | exact E |].
      intros s Hs. apply H, Out. now exists s.
    + intros q Hq. destruct (covered_sound _ _ _ _ Cover q Hq) as [P [HP [HC Pq]]].
      rewrite forallb_forall in Open. specialize (Open P HP). rewrite HC in Open. unfold is_open in Open.
      destruct (sound P HP q Pq) as [_ [U L]]. destruct (bound P) as [[u w]|]; [|discriminate].
      exists (N.to_nat (attained P)). split; [exact L|]. apply upper_le with (2 := U u w eq_refl).
      apply negb_true_iff, N.ltb_ge in Open. lia.
    + split.
      * intros n e A x y H. rewrite A in Width. simpl in Width. rewrite forallb_forall in Width.
        apply Out in H. destruct H as [s [H V]]. specialize (narrow_ok n e s (Width s H)). now rewrite V.
      * intros n A. rewrite A in Number. simpl in Number. rewrite map_length. apply N.leb_le in Number. lia.
Qed.
End Pieces.
