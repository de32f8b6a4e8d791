(** L11: out of a contact with the bridge in the chart bridge (L8 (3) read backwards; L6 (a), (c)) there is a motion for
    all times with at least the collisions of the two rays; so a witness proves a lower bound. *)
From Coq Require Import Reals Lra Lia List FinFun.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics Ray Chart Flight Collisions Symmetry Existence StartRay RayFuture.
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
  assert (A1 := arm1_pos P HP). assert (EA := r_arms P HP).
  destruct (cos_range e ltac:(lra)) as [W0 W1]. assert (S0 : 0 < sin e) by (apply sin_gt_0; lra).
  set (s0 := {| height := arm1 P * (r * sin e); angle := PI/2 - e + PI/2 |}).
  assert (Ep : psi_of s0 = PI/2 - e) by (unfold psi_of, s0; simpl; ring).
  assert (Ey : yh s0 = r * sin e) by (unfold yhat_of, s0; simpl; field; lra).
  assert (Sp : sin (PI/2 - e) = cos e) by (rewrite sin_minus, sin_PI2, cos_PI2; ring).
  assert (Cp : cos (PI/2 - e) = sin e) by (rewrite cos_minus, sin_PI2, cos_PI2; ring).
  assert (Ca0 : cos (angle s0) = - cos e) by (assert (K := sin_psi s0); rewrite Ep, Sp in K; lra).
  assert (Hrs : 0 < r * sin e) by (now apply Rmult_lt_0_compat).
  assert (Hfree : free P s0) by (unfold free; rewrite Ep, Ey, Cp; lra).
  assert (Hy : y2 P s0 = 0). { destruct (L0_heights P s0 HP) as [_ E]. rewrite E, Ep, Ey, Cp. unfold r_of. ring. }
  set (k := r * lamX e eta). set (v' := {| vy := arm1 P * k; om := -1 |}).
  assert (Eu : u_of v' = -1) by reflexivity. assert (Ev : v_of P v' = k) by (unfold v_of, v'; simpl; field; lra).
  assert (Hre : 0 < r * eta) by (now apply Rmult_lt_0_compat).
  set (w := minus_v v'). assert (Hw : vy w + - (arm2 P * cos (angle s0)) * om w < 0).
  { rewrite EA, Ca0. unfold w, v', k, lamX; simpl. assert (0 < arm1 P * (r * eta)) by (now apply Rmult_lt_0_compat).
    lra. }
  destruct (push_exists P HP _ _ Hw) as [w' [Hpush Hne]]. change (push2 P s0 w w') in Hpush.
  destruct (L0_reflection2 P HP s0 w w' Hpush) as [|HL]; [contradiction|]. unfold slope2 in HL. rewrite Ep, Sp in HL.
  assert (Euw : u_of w = 1) by (unfold w, u_of; simpl; ring).
  assert (Evw : v_of P w = - k) by (unfold w; rewrite (v_of_minus P HP), Ev; reflexivity). rewrite Euw, Evw in HL.
  destruct HL as [l [Hl [Lu [Lv [Lr Ln]]]]].
  assert (Hq : 0 < 1 + r * (cos e * cos e)).
  { assert (0 <= r * (cos e * cos e)) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]). lra. }
  assert (Hrc : 0 <= r * cos e) by (apply Rmult_le_pos; lra).
  assert (Hrce : 0 <= r * cos e * eta) by (apply Rmult_le_pos; lra).
  assert (El : l = 2 * eta / (1 + r * (cos e * cos e))).
  { apply Rmult_eq_reg_r with (r * (1 + r * (cos e * cos e))); [|apply Rmult_integral_contrapositive_currified; lra].
    replace (2 * eta / (1 + r * (cos e * cos e)) * (r * (1 + r * (cos e * cos e)))) with (2 * (r * eta))
      by (field; lra).
    rewrite Lu, Lv in Lr. unfold k, lamX in Lr. lra. }
  (* X *)
  destruct (bridge_start_ray P HP Hr1 s0 v' k) as [RX KX];
    try (rewrite ?Ep, ?Ey, ?Eu, ?Ev, ?Cp, ?Sp; unfold k, lamX; lra).
  rewrite Ep, Cp in RX. destruct (ray_future P HP Hr1 _ _ _ _ RX KX) as [pX [FX GX]].
  (* sigma X, mirrored *)
  set (kS := r * lamS e eta r). assert (EuS : u_of (mirror_v w') = - u_of w') by reflexivity.
  assert (EvS : v_of P (mirror_v w') = v_of P w') by reflexivity.
  assert (Hlc : 0 <= l * (r * cos e)) by (apply Rmult_le_pos; lra).
  assert (EkS : kS * - u_of (mirror_v w') = v_of P (mirror_v w')).
  { rewrite EuS, EvS, Lu, Lv, El. unfold kS, lamS, eta_reversed, k, lamX. field. split; lra. }
  destruct (bridge_start_ray P HP Hr1 (mirror_pos s0) (mirror_v w') kS) as [RS KS];
    rewrite ?psi_mirror_pos, ?Ep, ?cos_neg, ?sin_neg, ?Cp, ?Sp; try assumption; try lra.
  { rewrite EuS, EvS, Lu, Lv. rewrite Lu, Lv in Lr. unfold k, lamX in *. lra. }
  rewrite psi_mirror_pos, Ep, cos_neg, Cp in RS. destruct (ray_future P HP Hr1 _ _ _ _ RS KS) as [pS [FS GS]].
  (* the motion *)
  apply (join_at_heavy_contact s0 (minus_v w') v' pX (mirror pS) a b Hfree Hy).
  - unfold w2. rewrite EA, Ca0. simpl.
    assert (K : 0 < arm1 P * (v_of P w' + r * cos e * u_of w')) by (apply Rmult_lt_0_compat; lra).
    unfold u_of, v_of in K.
    replace (arm1 P * (vy w' / arm1 P + r * cos e * om w')) with (vy w' + r * arm1 P * cos e * om w') in K
      by (field; lra). lra.
  - assert (E : v' = minus_v w) by (unfold w; apply vel_eq; simpl; ring). rewrite E. now apply reverse_push.
  - exact FX.
  - replace (minus_v (minus_v w')) with w' by (apply vel_eq; simpl; ring). now apply future_mirror.
  - apply GX. unfold cX in Ca. fold k in Ca.
    replace (r * (sin e + lamX e eta * (PI - e))) with (r * sin e + k * (PI / 2 - e + PI / 2)) in Ca
      by (unfold k; field). exact Ca.
  - apply later_mirror, GS. unfold cS in Cb. fold kS in Cb.
    replace (r * (sin e + lamS e eta r * e)) with (r * sin e + kS * (- (PI / 2 - e) + PI / 2)) in Cb
      by (unfold kS; ring). exact Cb.
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
