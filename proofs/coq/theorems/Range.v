(** A certificate of a range: accepted pieces that join without a hole say what N(q) is for every q of the range. *)
From Coq Require Import Reals ZArith List Lra Lia Bool.
From Dumbbell Require Import Physics Scaling Doubles Maximum Piece.
Import ListNotations.
Local Open Scope R_scope.

Definition piece_lo (P : TP.piece) := IZR (TP.An P) / IZR (TP.Ad P).
Definition piece_hi (P : TP.piece) := IZR (TP.Bn P) / IZR (TP.Bd P).
Definition inside (P : TP.piece) q := piece_lo P <= q <= piece_hi P.

(** Each piece begins where the one before it ends; all denominators are positive. *)
Fixpoint joined (P : TP.piece) (l : list TP.piece) : bool :=
  ((0 <? TP.Bd P) && match l
    with [] => true | Q :: l' => (0 <? TP.Ad Q) && (TP.Bn P * TP.Ad Q =? TP.An Q * TP.Bd P) && joined Q l' end)%Z.
Definition range_ok (A B : Z) (l : list TP.piece) : bool :=
  match l with [] => false | P :: l' => ((0 <? TP.Ad P) && (TP.An P =? A * TP.Ad P) && joined P l' &&
    (TP.Bn (last l' P) =? B * TP.Bd (last l' P)))%Z end.

Lemma last_cons (l : list TP.piece) : forall P Q, last (Q :: l) P = last l Q.
Proof. induction l as [|R l IH]; intros P Q; [reflexivity|]. change (last (R :: l) P = last (R :: l) Q).
now rewrite !IH. Qed.
Lemma joined_covers l : forall P q, joined P l = true -> piece_lo P <= q <= piece_hi (last l P) ->
  exists Q, In Q (P :: l) /\ inside Q q.
Proof.
  induction l as [|Q l IH]; intros P q H Hq; simpl in H.
  - exists P. split; [now left | exact Hq].
  - apply andb_prop in H. destruct H as [H1 H]. apply andb_prop in H. destruct H as [H H2]. apply andb_prop in H.
    destruct H as [H3 H4].
    apply Z.ltb_lt in H1. apply Z.ltb_lt in H3. apply Z.eqb_eq in H4. apply IZR_lt in H1. apply IZR_lt in H3.
    assert (E : piece_hi P = piece_lo Q). { unfold piece_hi, piece_lo. apply (f_equal IZR) in H4.
      rewrite !mult_IZR in H4. apply Rmult_eq_reg_r with (IZR (TP.Bd P) * IZR (TP.Ad Q));
        [|apply Rmult_integral_contrapositive_currified; lra].
      replace (IZR (TP.Bn P) / IZR (TP.Bd P) * (IZR (TP.Bd P) * IZR (TP.Ad Q))) with (IZR (TP.Bn P) * IZR (TP.Ad Q))
        by (field; lra). rewrite H4. field. lra. }
    destruct (Rle_or_lt q (piece_hi P)) as [K|K].
    + exists P. split; [now left|]. split; [apply Hq | exact K].
    + destruct (IH Q q H2) as [S [S1 S2]].
      * split; [lra|]. rewrite <- (last_cons l P Q). apply Hq.
      * exists S. split; [now right | exact S2].
Qed.
Lemma last_joined l : forall P, joined P l = true -> (0 < TP.Bd (last l P))%Z.
Proof.
  induction l as [|Q l IH]; intros P H; simpl in H; apply andb_prop in H; destruct H as [H1 H].
  - now apply Z.ltb_lt in H1.
  - apply andb_prop in H. destruct H as [_ H]. rewrite last_cons. now apply IH.
Qed.

(** What a certificate of [A, B] says about q: bounds U and V, which are N(q) where they agree. *)
Definition certifies (l : list TP.piece) q := exists P, In P l /\ inside P q /\ upper_bound q (TP.U P) /\
  lower_bound q (TP.Vn P).
Theorem range_sound A B l : forallb check l = true -> range_ok A B l = true -> forall q, IZR A <= q <= IZR B ->
  certifies l q.
Proof.
  intros Hc Hr q Hq. destruct l as [|P l]; [discriminate|]. unfold range_ok in Hr.
  apply andb_prop in Hr. destruct Hr as [Hr H4]. apply andb_prop in Hr. destruct Hr as [Hr H3]. apply andb_prop in Hr.
  destruct Hr as [H1 H2].
  apply Z.ltb_lt in H1. apply Z.eqb_eq in H2. apply Z.eqb_eq in H4. assert (H5 := last_joined l P H3).
  apply IZR_lt in H1. apply IZR_lt in H5.
  destruct (joined_covers l P q H3) as [Q [Q1 Q2]].
  - unfold piece_lo, piece_hi. rewrite H2, H4, !mult_IZR.
    replace (IZR A * IZR (TP.Ad P) / IZR (TP.Ad P)) with (IZR A) by (field; lra).
    replace (IZR B * IZR (TP.Bd (last l P)) / IZR (TP.Bd (last l P))) with (IZR B) by (field; lra). exact Hq.
  - exists Q. split; [exact Q1|]. split; [exact Q2|]. exact (chain_sound (P :: l) Hc Q Q1 q Q2).
Qed.
Theorem exact_sound l : forallb check l = true -> forall P q, In P l -> inside P q -> TP.U P = TP.Vn P ->
  N_star q (TP.U P).
Proof. intros Hc P q HP Hq E. destruct (chain_sound l Hc P HP q Hq) as [A B]. split; [exact A | now rewrite E]. Qed.

(** With Maximum.v: N(q) exists and lies between the two bounds of its piece, which differ by one at most. *)
Definition gaps_at_most_one (l : list TP.piece) := forallb (fun P => TP.U P <=? S (TP.Vn P))%nat l.
Theorem range_N A B l : forallb check l = true -> range_ok A B l = true -> gaps_at_most_one l = true ->
  forall q, IZR A <= q <= IZR B ->
  exists P n, In P l /\ inside P q /\ N_star q n /\ (TP.Vn P <= n <= TP.U P)%nat /\ (TP.U P <= TP.Vn P + 1)%nat.
Proof.
  intros Hc Hr Hl q Hq. destruct (range_sound A B l Hc Hr q Hq) as [P [H1 [H2 [H3 H4]]]].
  assert (Hk : check P = true) by (rewrite forallb_forall in Hc; now apply Hc).
  destruct (check_sound P Hk q H2) as [Q1 _].
  destruct (N_exists q Q1) as [n [[NU NL] _]]. exists P, n. split; [exact H1|]. split; [exact H2|]. split; [now split|].
  destruct (unit_real q ltac:(lra)) as [D1 D2]. split; [split|].
  - destruct (H4 _ D1 D2) as [p [Hm [s [A1 [A2 A3]]]]]. rewrite <- A2. exact (NU _ p D1 D2 Hm s A1 A3).
  - destruct (NL _ D1 D2) as [p [Hm [s [A1 [A2 A3]]]]]. rewrite <- A2. exact (H3 _ p D1 D2 Hm s A1 A3).
  - unfold gaps_at_most_one in Hl. rewrite forallb_forall in Hl. specialize (Hl P H1). apply Nat.leb_le in Hl. lia.
Qed.
