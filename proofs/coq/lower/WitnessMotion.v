(** L11: out of a contact with the bridge in the chart bridge (L8 (3) read backwards; L6 (a), (c)) there is a motion for
    all times with at least the collisions of the two rays; so a witness proves a lower bound.

    bridge_motion == a point of the chart bridge is a motion with the collisions of its two rays
    charts_lower  == so a witness is a lower bound *)
From Coq Require Import Reals Lra Lia List FinFun.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics Ray Chart Flight Collisions Symmetry Existence StartRay BridgeRays RayFuture.
Local Open Scope R_scope.

Section Lower.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.
Hypothesis Hr1 : r_of P <= 1.
Notation r := (r_of P).
Notation yh := (yhat_of P).

(** A past and a future of a contact with the heavy mass. *)
Lemma NoDup_apart (l1 l2 : list R) : NoDup l1 -> NoDup l2 -> (forall x, In x l1 -> ~ In x l2) -> NoDup (l1 ++ l2).
Proof.
  induction l1 as [|x l IH]; intros H1 H2 H; [exact H2|]. apply NoDup_cons_iff in H1. destruct H1 as [H0 H1].
  simpl. constructor.
  - intros K. apply in_app_iff in K. destruct K as [K|K]; [contradiction|]. apply (H x); [now left | exact K].
  - apply IH; try assumption. intros y Hy. apply H. now right.
Qed.
Theorem join_at_heavy_contact s0 v v' pX pS a b : free P s0 -> y2 P s0 = 0 -> w2 P s0 v < 0 -> push2 P s0 v v' ->
  future P s0 v' pX -> future P s0 (minus_v v) pS -> later P pX 0 a -> later P pS 0 b ->
  exists p, motion P p /\ at_least P p (1 + a + b).
Proof.
  intros Hf Hy Hw Hpush [X1 [X2 X3]] [S1 [S2 S3]] La Lb. set (p := glue 0 (reverse pS) pX). exists p.
  assert (E0 : reverse pS 0 = s0) by (unfold reverse; now rewrite Ropp_0).
  assert (Eat : p 0 = s0) by (unfold p; now rewrite glue_at).
  assert (Hb : before p 0 v).
  { apply glue_before. replace v with (minus_v (minus_v v)) by (apply vel_eq; simpl; ring). apply reverse_before.
    now rewrite Ropp_0. }
  assert (Ha : after p 0 v') by (apply glue_after; [now rewrite E0 | exact X2]).
  assert (Hm : motion P p).
  { apply lawful_motion. intros t. destruct (Rtotal_order t 0) as [L|[->|L]].
    - apply near_lawful with (reverse pS); [now apply glue_left|]. apply reverse_lawful, S3. lra.
    - destruct (free_above P HP s0 Hf) as [A [B C]]. unfold lawful. rewrite Eat. repeat split; try assumption.
      exists v, v'. split; [exact Hb|]. split; [exact Ha|]. right; right. now split.
    - apply near_lawful with (shift 0 pX); [now apply glue_right|]. apply shift_lawful, X3. lra. }
  split; [exact Hm|]. destruct La as [la [A1 [A2 A3]]]. destruct Lb as [lb [B1 [B2 B3]]].
  exists (0 :: la ++ map Ropp lb)%list. split; [|split].
  - constructor.
    + intros K. apply in_app_iff in K. destruct K as [K|K]; [destruct (A3 0 K); lra|]. apply in_map_iff in K.
      destruct K as [t [Et K]]. destruct (B3 t K). lra.
    + apply NoDup_apart; [exact A1 | apply Injective_map_NoDup; [intros x y E; lra | exact B1]|].
      intros t Ht K. apply in_map_iff in K. destruct K as [t' [Et K]]. destruct (B3 t' K). destruct (A3 t Ht). lra.
  - simpl. rewrite app_length, map_length. lia.
  - intros t [<-|Ht].
    + exists v. split; [exact Hb|]. right. rewrite Eat. now split.
    + apply in_app_iff in Ht. destruct Ht as [Ht|Ht].
      * destruct (A3 t Ht) as [Q1 Q2]. apply near_collision with (shift 0 pX); [now apply glue_right|].
        apply shift_collision. now rewrite Rminus_0_r.
      * apply in_map_iff in Ht. destruct Ht as [s [<- Hs]]. destruct (B3 s Hs) as [Q1 Q2].
        apply (collision_unreverse P HP p s Hm).
        apply near_collision with pS; [|exact Q2]. exists (s / 2). split; [lra|]. intros z Hz. unfold reverse, p, glue.
        destruct (Rle_dec (- z) 0); [unfold reverse; now rewrite Ropp_involutive | lra].
Qed.

(** L8 (3), L11. *)
Theorem bridge_motion e eta a b : 0 < e <= PI/2 -> 0 < eta ->
  coll r a (r * cX e eta) (r * lamX e eta) -> coll r b (r * cS e eta r) (r * lamS e eta r) ->
  exists p, motion P p /\ at_least P p (1 + a + b).
Proof.
  intros He Heta Ca Cb. assert (R0 := r_pos P HP). assert (HPI : 0 < PI) by apply PI_RGT_0.
  assert (A1 := arm1_pos P HP). assert (0 < sin e) by (apply sin_gt_0; lra).
  set (s0 := {| height := arm1 P * (r * sin e); angle := PI/2 - e + PI/2 |}).
  assert (Ep : psi_of s0 = PI/2 - e) by (unfold psi_of, s0; simpl; ring).
  assert (Ey : yh s0 = r * sin e) by (unfold yhat_of, s0; simpl; field; lra).
  assert (0 < r * sin e) by (now apply Rmult_lt_0_compat).
  assert (Hfree : free P s0) by (unfold free; rewrite Ep, Ey, cos_top; lra).
  assert (Hy : y2 P s0 = 0).
  { destruct (L0_heights P s0 HP) as [_ E]. rewrite E, Ep, Ey, cos_top. unfold r_of. ring. }
  (* out of it with the slope of X; in with what the floor answers to the reversed velocity *)
  set (v' := {| vy := arm1 P * (r * lamX e eta); om := -1 |}).
  assert (Ev : v_of P v' = r * lamX e eta) by (unfold v_of, v'; simpl; field; lra).
  assert (Es : r * lamX e eta * - u_of v' = v_of P v') by (rewrite Ev; unfold u_of; simpl; ring).
  destruct (push_exists P HP (- (arm2 P * cos (angle s0))) (minus_v v')) as [w [Hpush Hne]].
  { assert (K := sin_psi s0). rewrite Ep, sin_top in K. replace (cos (angle s0)) with (- cos e) by lra.
    rewrite (r_arms P HP). unfold v', lamX; simpl. assert (0 < r * eta) by (now apply Rmult_lt_0_compat).
    assert (0 < arm1 P * (r * eta)) by (now apply Rmult_lt_0_compat). lra. }
  change (push2 P s0 (minus_v v') w) in Hpush. assert (Emm : minus_v (minus_v v') = v') by (apply vel_eq; simpl; ring).
  destruct (L0_reflection2 P HP s0 _ w Hpush) as [|HL]; [contradiction|]. apply reflects_reverse in HL.
  unfold slope2 in HL. rewrite Ep, sin_top, <- !(v_of_minus P HP), Emm in HL.
  replace (- u_of (minus_v v')) with (u_of v') in HL by (unfold u_of; simpl; ring).
  replace (- r * cos e) with (- (r * cos e)) in HL by ring.
  destruct (bridge_slopes P HP e eta _ _ _ _ He HL ltac:(unfold u_of; simpl; lra) Es) as [_ [Hin ES]].
  (* the rays *)
  destruct (bridge_out_X P HP Hr1 s0 v' e eta He Heta Ep Ey ltac:(unfold u_of; simpl; lra) Es) as [RX KX].
  destruct (ray_future P HP Hr1 _ _ _ _ RX KX) as [pX [FX GX]].
  destruct (bridge_out_S P HP Hr1 (mirror_pos s0) (mirror_v w) e eta He Heta) as [RS KS]; try assumption.
  { rewrite psi_mirror_pos, Ep. reflexivity. }
  { change (r * lamS e eta r * - - u_of w = v_of P w). rewrite (v_of_minus P HP) in ES. lra. }
  destruct (ray_future P HP Hr1 _ _ _ _ RS KS) as [pS [FS GS]].
  (* the motion *)
  assert (Hin2 : push2 P s0 (minus_v w) v') by (rewrite <- Emm; now apply reverse_push).
  apply (join_at_heavy_contact s0 (minus_v w) v' pX (mirror pS) a b Hfree Hy).
  - destruct (push_cases P HP _ _ _ Hin2) as [E|[_ [j [_ [_ [_ Hw]]]]]]; [|unfold w2; lra]. exfalso. apply Hne.
    rewrite E. apply vel_eq; simpl; ring.
  - exact Hin2.
  - exact FX.
  - replace (minus_v (minus_v w)) with w by (apply vel_eq; simpl; ring). now apply future_mirror.
  - now apply GX.
  - now apply later_mirror, GS.
Qed.
End Lower.

Theorem charts_lower q n : 1 <= q -> bridge_witness (/ q) n -> lower_bound q n.
Proof.
  intros Hq [e [eta [a [b [He [Heta [_ [Ca [Cb Hn]]]]]]]]] P HP Hqq.
  assert (E : / q = r_of P) by (unfold r_of; destruct HP as [? [? ?]]; rewrite <- Hqq; field; lra).
  rewrite E in Ca, Cb. assert (R1 : r_of P <= 1) by (rewrite <- E, <- Rinv_1; apply Rinv_le_contravar; lra).
  destruct n as [|n].
  - destruct (bridge_motion P HP R1 e eta a b ltac:(lra) Heta Ca Cb) as [p [Hm _]]. exists p. split; [exact Hm|].
    exists nil. repeat split; [constructor | contradiction].
  - set (a' := Nat.min a n). set (b' := (n - a')%nat).
    destruct (bridge_motion P HP R1 e eta a' b' ltac:(lra) Heta) as [p [Hm Hl]].
    + apply coll_le with a; [unfold a'; lia | exact Ca].
    + apply coll_le with b; [unfold b', a'; lia | exact Cb].
    + exists p. split; [exact Hm|]. replace (S n) with (1 + a' + b')%nat by (unfold b', a'; lia). exact Hl.
Qed.
