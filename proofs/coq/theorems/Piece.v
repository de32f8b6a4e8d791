(** From a certificate to the physics: a piece in which the checker finds no fault bounds the number of collisions of
  every motion of
    every dumbbell whose mass ratio lies in the piece, and such a motion with that many collisions exists (the Theorem
      of lemmas.md).

    in_piece    == a mass ratio of the piece
    piece_sound == an accepted piece bounds N(q) from both sides, for every q in it *)
From Coq Require Import Reals ZArith NArith List Lra Lia Bool.
From Dumbbell Require Import Physics Ray Chart Forward Certificate FullLeaves Doubles Multiple Check
  LightTotal FullTotal WitnessMotion EqualMasses Scaling Maximum.
Local Open Scope R_scope.

Section Piece.
Variable P : piece.
Variable again : bool.
Lemma leaf_sound U c b why : leaf_holds again P U c b why = true -> forall e y q, in_box e y q b -> 1 <= q ->
  chart_holds c (N.to_nat U) e y (/ q).
Proof.
  unfold leaf_holds. intros H. destruct (Doubles.check_leaf U c b why) eqn:E.
  - exact (D.check_leaf_sound p53 Doubles.G doubles eq_refl U c b why E).
  - destruct again; [|discriminate]. set (p := precision (bits P)).
    exact (M.check_leaf_sound p (Multiple.G p) (M.Z.mkconsts p) eq_refl U c b why H).
Qed.
Lemma chart_sound U c t : chart_fault again P U c t = None -> forall e y q, in_box e y q (chart_box c (from P) (to P)) ->
  1 <= q -> chart_holds c (N.to_nat U) e y (/ q).
Proof.
  unfold chart_fault. destruct (check_tree _ _ t) eqn:E; [|discriminate]. intros _.
  refine (check_tree_sound _ (fun e y q => 1 <= q -> chart_holds c (N.to_nat U) e y (/ q)) _ t _ E).
  intros b why. exact (leaf_sound U c b why).
Qed.
Lemma contact_sound V b w : contact_holds again P V b w = true -> forall e y q, in_box e y q b ->
  bridge_witness (/ q) (N.to_nat V).
Proof.
  unfold contact_holds. intros H. apply andb_prop in H; destruct H as [_ H].
  destruct (Doubles.check_contact V b w) eqn:E.
  - exact (D.check_contact_sound p53 Doubles.G doubles eq_refl V b w E).
  - destruct again; [|discriminate]. set (p := precision (bits P)).
    exact (M.check_contact_sound p (Multiple.G p) (M.Z.mkconsts p) eq_refl V b w H).
Qed.

Definition in_piece (q : R) := ratio_value (from P) <= q <= ratio_value (to P).
Lemma one_value : ratio_value one = 1. Proof. unfold ratio_value; simpl; lra. Qed.

Lemma first_of_none a b : first_of a b = None -> a = None /\ b = None.
Proof. destruct a; [discriminate | now split]. Qed.
Lemma slope_below q y : 1 <= q -> / q * y < 1 -> y < q.
Proof.
  intros Hq H. apply Rmult_lt_reg_l with (/ q); [apply Rinv_0_lt_compat; lra|]. rewrite (Rinv_l q) by lra. exact H.
Qed.
Lemma cover_sound U c : cover_fault again P U c = None -> forall q, 1 <= q -> in_piece q -> upper_bound q (N.to_nat U).
Proof.
  unfold cover_fault. intros H q Hq Hin. destruct (U <? attained P)%N; [discriminate|]. assert (R3 : 0 < / q <= 1).
  { split; [apply Rinv_0_lt_compat; lra|]. rewrite <- Rinv_1. apply Rinv_le_contravar; lra. }
  assert (P4 := PI_4). destruct c as [|tb tl|tc td ta].
  - destruct (ratio_eq (from P) one && ratio_eq (to P) one && (2 <=? U)%N) eqn:E; [|discriminate].
    apply andb_prop in E; destruct E as [E E3]. apply andb_prop in E; destruct E as [E1 E2]. apply N.leb_le in E3.
    apply ratio_eq_ok in E1, E2. rewrite one_value in E1, E2. unfold in_piece in Hin. assert (q = 1) by lra. subst q.
    intros D p HD Hr Hm l Hl Hc. assert (K := proj1 L7_equal_masses D p HD Hr Hm l Hl Hc). lia.
  - destruct (wide_enough (to P)) eqn:Ew; [|discriminate]. apply wide_enough_ok in Ew. simpl in H.
    apply first_of_none in H. destruct H as [Eb El]. unfold in_piece in Hin.
    apply charts_upper; [exact Hq | |].
    + intros e eta a b He Heta Hlt Ha Hb. assert (Y := slope_below q eta Hq Hlt).
      refine (chart_sound U Bridge tb Eb e eta q _ Hq He Heta R3 Hlt a b Ha Hb). apply in_root; lra.
    + intros e lam a b He Hlam Hlt HP HX HS Ha Hb Hb0. assert (Y := slope_below q lam Hq Hlt).
      refine (chart_sound U Light tl El e lam q _ Hq He Hlam R3 Hlt a b HP HX HS Ha Hb Hb0). apply in_root; lra.
  - destruct (wide_enough (one_more (to P))) eqn:Ew; [|discriminate]. apply wide_enough_ok in Ew.
    rewrite one_more_ok in Ew. destruct (U =? 0)%N eqn:E0; [discriminate|]. apply N.eqb_neq in E0. simpl in H.
    apply first_of_none in H. destruct H as [Ec H]. apply first_of_none in H. destruct H as [Ed _].
    unfold in_piece in Hin. apply full_upper; [exact Hq | |].
    + intros t eta a Ht Heta Ha. destruct (Rle_or_lt (eta - 1) (ratio_value (to P))) as [K|K].
      * refine (chart_sound U Contact tc Ec t eta q _ Hq Ht Heta R3 a Ha). apply in_root; lra.
      * assert (a = O); [|lia]. apply (steep_ray_misses (/ q) a _ (/ q * lamX t eta)) with (2 := Ha).
        apply Rnot_lt_le. intros L. apply slope_below in L; [|exact Hq]. unfold lamX in L. destruct (COS_bound t). lra.
    + intros e eta a He Heta Ha. destruct (Rle_or_lt eta 2) as [K|K].
      * refine (chart_sound U Departure td Ed e eta q _ Hq He Heta R3 a Ha). apply in_root; simpl; lra.
      * assert (a = O); [|lia]. apply (forward_steep (/ q) a e (eta - cos e) R3) with (2 := Ha).
        destruct (COS_bound e). lra.
Qed.

Lemma witness_sound : witness_fault again P = None -> forall q, 1 <= q -> in_piece q -> lower_bound q (N.to_nat (attained P)).
Proof.
  unfold witness_fault. intros H q Hq Hin. destruct (witness P) as [w|].
  - destruct (contact_holds _ _ _ _ w) eqn:E; [|discriminate]. apply charts_lower; [exact Hq|].
    apply (contact_sound _ _ _ E 1 0 q). unfold in_piece in Hin.
    apply in_root; [lra | | exact Hin]. split; [lra|]. apply IZR_le. unfold least_power.
    assert (0 <= 2 ^ Z.log2_up (Z.pos (num (to P)) / Z.pos (den (to P))))%Z by (apply Z.pow_nonneg; lia).
    destruct (_ <=? _)%Z; lia.
  - destruct (attained P =? 0)%N eqn:E; [|discriminate]. apply N.eqb_eq in E. rewrite E.
    destruct (N_exists q Hq) as [n [[_ L] _]]. intros D HD Hr. destruct (L D HD Hr) as [p [Hp Hl]]. exists p.
      split; [exact Hp|].
    apply at_least_le with n; [simpl; lia | exact Hl].
Qed.

(** What an accepted piece says of a mass ratio in it. *)
Theorem piece_sound : piece_fault again P = None -> forall q, in_piece q ->
  1 <= q /\ (forall U c, bound P = Some (U, c) -> upper_bound q (N.to_nat U)) /\ lower_bound q (N.to_nat (attained P)).
Proof.
  unfold piece_fault. intros H q Hin. destruct (ratio_le one (from P)) eqn:E1; [|discriminate]. simpl in H.
  destruct (ratio_le (from P) (to P)) eqn:E2; [|discriminate]. simpl in H.
  apply ratio_le_ok in E1. rewrite one_value in E1. assert (Hq : 1 <= q) by (unfold in_piece in Hin; lra).
  destruct (bound P) as [[U c]|].
  - destruct (cover_fault again P U c) eqn:Ec; [discriminate|]. split; [exact Hq|]. split; [|now apply witness_sound].
    intros U' c' K. injection K; intros <- <-. now apply cover_sound with c.
  - split; [exact Hq|]. split; [discriminate | now apply witness_sound].
Qed.
End Piece.
