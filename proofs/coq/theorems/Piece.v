(** From a certificate to the physics: a piece in which the checker finds no fault bounds the number of collisions of
  every motion of
    every dumbbell whose mass ratio lies in the piece, and such a motion with that many collisions exists (the Theorem
      of lemmas.md). *)
From Coq Require Import Reals ZArith NArith List Lra Lia Bool.
From Dumbbell Require Import Physics Ray Chart Certificate Leaves Doubles Multiple Check LightTotal WitnessMotion
  EqualMasses Scaling Maximum.
Local Open Scope R_scope.

Section Piece.
Variable P : piece.
Let root := root_box (from P) (to P).
Lemma leaf_sound U light b why : leaf_holds (more_bits P) U light b why = true -> forall e y q, in_box e y q b ->
  1 <= q -> (if light then light_holds else bridge_holds) (N.to_nat U) e y (/ q).
Proof.
  unfold leaf_holds, more_bits. intros H. destruct (Doubles.check_reason U light b why) eqn:E.
  - destruct light; [exact (D.check_light_sound p53 Doubles.G doubles eq_refl U b why E) | exact (D.check_bridge_sound
    p53 Doubles.G doubles eq_refl U b why E)].
  - destruct (bits P <=? 53)%N; [discriminate|]. set (p := precision (bits P)) in *.
    destruct light; [exact (M.check_light_sound p (Multiple.G p) (consts p) eq_refl U b why H) | exact
      (M.check_bridge_sound p (Multiple.G p) (consts p) eq_refl U b why H)].
Qed.
Lemma contact_sound V b w : contact_holds (more_bits P) V b w = true -> forall e y q, in_box e y q b ->
  bridge_witness (/ q) (N.to_nat V).
Proof.
  unfold contact_holds, more_bits. intros H. destruct (Doubles.check_contact V b w) eqn:E.
  - exact (D.check_contact_sound p53 Doubles.G doubles eq_refl V b w E).
  - destruct (bits P <=? 53)%N; [discriminate|]. set (p := precision (bits P)) in *.
    exact (M.check_contact_sound p (Multiple.G p) (consts p) eq_refl V b w H).
Qed.

Definition in_piece (q : R) := ratio_value (from P) <= q <= ratio_value (to P).
Lemma one_value : ratio_value one = 1. Proof. unfold ratio_value; simpl; lra. Qed.

Lemma cover_sound U c : cover_fault P U c = None -> forall q, 1 <= q -> in_piece q -> upper_bound q (N.to_nat U).
Proof.
  unfold cover_fault. intros H q Hq Hin. destruct (U <? attained P)%N; [discriminate|]. destruct c as [|tb tl].
  - destruct (ratio_eq (from P) one && ratio_eq (to P) one && (2 <=? U)%N) eqn:E; [|discriminate].
    apply andb_prop in E; destruct E as [E E3]. apply andb_prop in E; destruct E as [E1 E2]. apply N.leb_le in E3.
    apply ratio_eq_ok in E1, E2. rewrite one_value in E1, E2. unfold in_piece in Hin. assert (q = 1) by lra. subst q.
    intros D p HD Hr Hm l Hl Hc. assert (K := proj1 L7_equal_masses D p HD Hr Hm l Hl Hc). lia.
  - destruct (wide_enough (to P)) eqn:Ew; [|discriminate]. simpl in H.
    destruct (check_tree (leaf_holds (more_bits P) U false) _ tb) eqn:Eb; [|discriminate].
    destruct (check_tree (leaf_holds (more_bits P) U true) _ tl) eqn:El; [|discriminate].
    assert (R3 : 0 < / q <= 1). { split; [apply Rinv_0_lt_compat; lra|]. rewrite <- Rinv_1. apply Rinv_le_contravar;
      lra. }
    apply charts_upper; [exact Hq | |].
    + intros e eta a b He Heta Hlt Ha Hb. assert (K := in_root (from P) (to P) e eta q Ew He Heta Hin Hlt).
      refine (check_tree_sound (leaf_holds (more_bits P) U false) (fun e y q => 1 <= q ->
        bridge_holds (N.to_nat U) e y (/ q)) _ tb _ Eb e eta q K Hq He Heta R3 Hlt a b Ha Hb).
      intros b0 why HL e' y' q' Hin' Hq'. exact (leaf_sound U false b0 why HL e' y' q' Hin' Hq').
    + intros e lam a b He Hlam Hlt HP HX HS Ha Hb Hb0. assert (K := in_root (from P) (to P) e lam q Ew He Hlam Hin Hlt).
      refine (check_tree_sound (leaf_holds (more_bits P) U true) (fun e y q => 1 <= q ->
        light_holds (N.to_nat U) e y (/ q)) _ tl _ El e lam q K Hq He Hlam R3 Hlt a b HP HX HS Ha Hb Hb0).
      intros b0 why HL e' y' q' Hin' Hq'. exact (leaf_sound U true b0 why HL e' y' q' Hin' Hq').
Qed.

Lemma witness_sound : witness_fault P = None -> forall q, 1 <= q -> in_piece q -> lower_bound q (N.to_nat (attained P)).
Proof.
  unfold witness_fault. intros H q Hq Hin. destruct (witness P) as [w|].
  - destruct (contact_holds _ _ _ w) eqn:E; [|discriminate]. apply charts_lower; [exact Hq|].
    apply (contact_sound _ _ _ E 1 0 q). unfold in_piece in Hin.
    destruct (ratio_cross (from P) (to P)) as [E1 E2].
    assert (D : 0 < IZR (Zpos (den (from P))) * IZR (Zpos (den (to P)))) by (apply Rmult_lt_0_compat; now apply IZR_lt).
    unfold in_box, in_span, root_box; cbn [box_e box_slope box_q low_end high_end part]. split; [lra|]. split.
    + assert (0 <= IZR (least_power (to P))); [|lra]. apply IZR_le. unfold least_power.
      assert (0 <= 2 ^ Z.log2_up (Z.pos (num (to P)) / Z.pos (den (to P))))%Z by (apply Z.pow_nonneg; lia).
        destruct (_ <=? _)%Z; lia.
    + rewrite <- E1, <- E2, Pos2Z.inj_mul, mult_IZR. set (d := IZR (Zpos (den (from P))) * IZR (Zpos (den (to P)))) in
      *.
      replace (ratio_value (from P) * d / d) with (ratio_value (from P)) by (field; lra).
      replace (ratio_value (to P) * d / d) with (ratio_value (to P)) by (field; lra). exact Hin.
  - destruct (attained P =? 0)%N eqn:E; [|discriminate]. apply N.eqb_eq in E. rewrite E.
    destruct (N_exists q Hq) as [n [[_ L] _]]. intros D HD Hr. destruct (L D HD Hr) as [p [Hp Hl]]. exists p.
      split; [exact Hp|].
    apply at_least_le with n; [simpl; lia | exact Hl].
Qed.

(** What an accepted piece says of a mass ratio in it. *)
Theorem piece_sound : piece_fault P = None -> forall q, in_piece q ->
  1 <= q /\ (forall U c, bound P = Some (U, c) -> upper_bound q (N.to_nat U)) /\ lower_bound q (N.to_nat (attained P)).
Proof.
  unfold piece_fault. intros H q Hin. destruct (ratio_le one (from P)) eqn:E1; [|discriminate]. simpl in H.
  destruct (ratio_le (from P) (to P)) eqn:E2; [|discriminate]. simpl in H.
  apply ratio_le_ok in E1. rewrite one_value in E1. assert (Hq : 1 <= q) by (unfold in_piece in Hin; lra).
  destruct (bound P) as [[U c]|].
  - destruct (cover_fault P U c) eqn:Ec; [discriminate|]. split; [exact Hq|]. split; [|now apply witness_sound].
    intros U' c' K. injection K; intros <- <-. now apply cover_sound with c.
  - split; [exact Hq|]. split; [discriminate | now apply witness_sound].
Qed.
End Piece.
