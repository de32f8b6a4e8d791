(** L3 for whole futures, and the parts of L8 (c): a steep ray has no later collision; a ray to the nearer wall is
    bounded by the tangent. *)
From Coq Require Import Reals Lra Lia List.
From Dumbbell Require Import Physics Ray Chart Flight Collisions Symmetry Follow BridgeChart.
Local Open Scope R_scope.

Section Bridge2.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.
Hypothesis Hr1 : r_of P <= 1.
Notation r := (r_of P).
Notation yh := (yhat_of P).

(** L3: for ever. *)
Theorem L3_steep_no_later p t0 v n : motion P p -> after p t0 v -> Rabs (u_of v) <= v_of P v -> later P p t0 n -> n = O.
Proof.
  intros Hm Ha Hs Hl. destruct n as [|n]; [reflexivity|exfalso].
  destruct (later_next P HP p t0 n Hm Hl) as [t1 [H1 [Hc [Hf _]]]].
  assert (L := straight_flight P HP p t0 t1 v Hm Ha H1 Hf).
  apply (L3_steep_no_collision P HP p t1 v Hr1 Hm); [|exact Hs|exact Hc].
  destruct (L t1 ltac:(lra)) as [Q1 Q2]. exists (t1 - t0). split; [lra|]. intros s Hs'.
  destruct (L s ltac:(lra)). split; lra.
Qed.

(** The ray out of a contact at psi = -(pi/2 - e) to the left. *)
Theorem tangent_bound U p t0 e v b : bridge_bound r U -> motion P p -> after p t0 v -> psi_of (p t0) = - (PI/2 - e) ->
  0 < e <= PI/2 ->
  yh (p t0) = r * cos (psi_of (p t0)) -> u_of v < 0 -> 0 < v_of P v + r * sin (psi_of (p t0)) * u_of v ->
  later P p t0 b -> (1 + b <= U)%nat.
Proof.
  intros HB Hm Ha Hp He Hy Hu Hn Hl. assert (R0 := r_pos P HP). assert (HPI : 0 < PI) by apply PI_RGT_0.
  set (k := v_of P v / - u_of v). assert (Ek : k * - u_of v = v_of P v) by (unfold k; field; lra).
  assert (B := bridge_ray P HP Hr1 p t0 v k Hm Ha Hu Ek ltac:(lra) Hy Hn). simpl in B.
  assert (Sp : sin (psi_of (p t0)) = - cos e) by (rewrite Hp, sin_neg, sin_minus, sin_PI2, cos_PI2; ring).
  assert (Cp : cos (psi_of (p t0)) = sin e) by (rewrite Hp, cos_neg, cos_minus, sin_PI2, cos_PI2; ring).
  destruct B as [RX [CX KX]].
  assert (Gb := follow_ray P HP Hr1 b p t0 v _ k Hm RX CX KX Hl). rewrite Cp, Hp in Gb. rewrite Sp in Hn.
  assert (Hk : r * - cos e < k). { apply Rmult_lt_reg_r with (- u_of v); lra. }
  assert (E0 : lamS e 0 r = - cos e) by (unfold lamS, eta_reversed, Rdiv; ring).
  assert (C0 : cS e 0 r = sin e - cos e * e) by (unfold cS; rewrite E0; ring).
  apply (HB e 0 O b He); try lra. { exact I. }
  apply (coll_mono b) with (8 := Gb); try lra.
  - apply Rmult_le_pos; [lra | apply cS_ge; lra].
  - rewrite C0. assert (r * - cos e * e <= k * e) by (apply Rmult_le_compat_r; lra). lra.
  - rewrite E0. destruct (COS_bound e). assert (r * -1 <= r * - cos e) by (apply Rmult_le_compat_l; lra). lra.
  - rewrite E0. lra.
Qed.

(** L8 (c), all cases but that of L8_bridge_left: no ray to the left, or a steep one. *)
Theorem L8c_bridge_other U p T e v' a b : bridge_bound r U -> (1 <= U)%nat -> motion P p -> collision P p T ->
  y2 P (p T) = 0 ->
  psi_of (p T) = PI/2 - e -> 0 < e <= PI/2 -> after p T v' ->
  0 <= u_of v' \/ - u_of v' * (1 + r * cos e) <= v_of P v' ->
  later P p T a -> later P (reverse p) (- T) b -> (1 + a + b <= U)%nat.
Proof.
  intros HB HU Hm Hc H2 Hpsi He Ha Hcase La Lb. assert (R0 := r_pos P HP). assert (HPI : 0 < PI) by apply PI_RGT_0.
  assert (Se : sin (psi_of (p T)) = cos e) by (rewrite Hpsi, sin_minus, sin_PI2, cos_PI2; ring).
  destruct (cos_range e ltac:(lra)) as [W0 W1]. assert (Hrs : 0 <= r * cos e) by (apply Rmult_le_pos; lra).
  assert (Hrs1 : r * cos e <= r * 1) by (apply Rmult_le_compat_l; lra).
  destruct (collision_law P HP p T Hm Hc) as [v [v1 [Hb [Ha1 HL]]]].
  assert (v1 = v') by (apply after_unique with p T; assumption). subst v1.
  assert (HR : reflects P (- (r * cos e)) (u_of v) (v_of P v) (u_of v') (v_of P v')).
  { destruct HL as [[H1 _]|[_ HR]]; [exfalso; apply (regular P p Hm T); now split|]. unfold slope2 in HR.
    rewrite Se in HR. now replace (- r * cos e) with (- (r * cos e)) in HR by ring. }
  destruct HR as [l [Hl [Eu [Ev [Er En]]]]]. assert (Hlr : 0 < l * r) by (now apply Rmult_lt_0_compat).
  assert (Hlc : 0 <= l * (r * cos e) <= l * r). { split; [apply Rmult_le_pos; lra|]. apply Rmult_le_compat_l; lra. }
  (* the reversed incoming ray *)
  set (q := reverse p). assert (Hq : motion P q) by (now apply reverse_motion).
  assert (Haq : after q (- T) (minus_v v)) by (apply reverse_after; now rewrite Ropp_involutive).
  assert (Hqp : q (- T) = p T) by (unfold q, reverse; now rewrite Ropp_involutive).
  assert (Euq : u_of (minus_v v) = - u_of v) by reflexivity.
  assert (Evq : v_of P (minus_v v) = - v_of P v) by (unfold v_of; simpl; field; assert (A := arm1_pos P HP); lra).
  (* either ray, if it goes right and is not steep: the tangent bounds it *)
  assert (Right : forall f t w n, motion P f -> after f t w -> f t = p T -> later P f t n -> 0 <= u_of w ->
    0 < v_of P w + r * cos e * u_of w -> (1 + n <= U)%nat).
  { intros f t w n Hf Haf Hft Hlf Hw Hnw. destruct (Rle_lt_or_eq_dec 0 (u_of w) Hw) as [K|K].
    - assert (Em : mirror f t = {| height := height (p T); angle := PI - angle (p T) |})
        by (unfold mirror; now rewrite Hft).
      assert (Ep : psi_of (mirror f t) = - (PI/2 - e)) by (rewrite psi_mirror, Hft, Hpsi; reflexivity).
      apply (tangent_bound U (mirror f) t e (mirror_v w) n HB); try assumption.
      + now apply mirror_motion. + now apply mirror_after.
      + rewrite Ep, cos_neg, <- Hpsi, <- (contact2 P HP p T H2). rewrite Em. reflexivity.
      + unfold u_of in *; simpl; lra.
      + rewrite Ep, sin_neg, <- Hpsi, Se. unfold u_of, v_of in *; simpl. lra.
      + now apply later_mirror.
    - assert (n = O); [|lia]. apply (L3_steep_no_later f t w n Hf Haf); [|assumption]. rewrite <- K, Rabs_R0.
      rewrite <- K in Hnw. lra. }
  assert (HnX : 0 < v_of P v' + r * cos e * u_of v') by lra.
  assert (HnS : 0 < v_of P (minus_v v) + r * cos e * u_of (minus_v v)) by (rewrite Euq, Evq; lra).
  destruct (Rle_or_lt (Rabs (u_of v')) (v_of P v')) as [SX|SX].
  - (* X is steep *)
    assert (a = O) by (now apply (L3_steep_no_later p T v' a Hm Ha)). subst a.
    destruct (Rle_or_lt 0 (- u_of v)) as [K|K].
    + apply (Right q (- T) (minus_v v) b Hq Haq Hqp Lb); [rewrite Euq; exact K | exact HnS].
    + (* sigma X goes left: then X goes right; by reversal it is the case L8_bridge_left or steep *)
      destruct (Rle_or_lt (Rabs (- u_of v)) (- v_of P v)) as [SS|SS].
      * assert (b = O)
          by (apply (L3_steep_no_later q (- T) (minus_v v) b Hq Haq); [rewrite Euq, Evq; exact SS | exact Lb]).
        subst b. lia.
      * assert (Hcq : collision P q (- T)).
        { exists (minus_v v'). split; [apply reverse_before; now rewrite Ropp_involutive|]. right. rewrite Hqp.
          split; [exact H2|].
          unfold w2; simpl. assert (A1 := arm1_pos P HP). assert (EA := r_arms P HP).
          assert (Ec : cos (angle (p T)) = - cos e) by (rewrite <- Se, sin_psi; ring). rewrite EA, Ec.
          assert (0 < arm1 P * (v_of P v' + r * cos e * u_of v')) by (now apply Rmult_lt_0_compat).
          replace (arm1 P * (v_of P v' + r * cos e * u_of v')) with (vy v' + r * arm1 P * cos e * om v') in H
            by (unfold u_of, v_of; field; lra). lra. }
        assert (La' : later P (reverse q) (- - T) O)
          by (exists nil; repeat split; [constructor | contradiction | contradiction]).
        assert (Hx := L8_bridge_left P HP Hr1 U q (- T) e (minus_v v) b O HB Hq Hcq).
        rewrite Hqp in Hx. specialize (Hx H2 Hpsi He Haq). rewrite Euq, Evq in Hx.
        assert (Hlt : - v_of P v < - - u_of v * (1 + r * cos e)). { rewrite Rabs_left in SS by lra.
          assert (0 <= u_of v * (r * cos e)) by (apply Rmult_le_pos; lra). lra. }
        specialize (Hx ltac:(lra) Hlt Lb La'). lia.
  - (* X is not steep: then it goes right, and sigma X is steep, or goes left *)
    assert (HX0 : 0 <= u_of v').
    { destruct Hcase as [|K]; [assumption|]. destruct (Rle_or_lt 0 (u_of v')) as [|K2]; [assumption|exfalso].
      rewrite Rabs_left in SX by assumption. assert (0 <= - u_of v' * (r * cos e)) by (apply Rmult_le_pos; lra). lra. }
    rewrite Rabs_pos_eq in SX by assumption.
    destruct (Rle_or_lt 0 (- u_of v)) as [K|K].
    + assert (b = O). { apply (L3_steep_no_later q (- T) (minus_v v) b Hq Haq); [|exact Lb].
        rewrite Euq, Evq, Rabs_pos_eq by assumption. lra. } subst b.
      assert (1 + a <= U)%nat by (apply (Right p T v' a Hm Ha eq_refl La); assumption). lia.
    + (* sigma X to the left: L8_bridge_left for the reversed motion, if it is not steep *)
      destruct (Rle_or_lt (- - u_of v * (1 + r * cos e)) (- v_of P v)) as [SS|SS].
      * assert (b = O). { apply (L3_steep_no_later q (- T) (minus_v v) b Hq Haq); [|exact Lb].
          rewrite Euq, Evq, Rabs_left by lra. assert (0 <= u_of v * (r * cos e)) by (apply Rmult_le_pos; lra).
          lra. } subst b.
        assert (1 + a <= U)%nat by (apply (Right p T v' a Hm Ha eq_refl La); assumption). lia.
      * assert (Hcq : collision P q (- T)).
        { exists (minus_v v'). split; [apply reverse_before; now rewrite Ropp_involutive|]. right. rewrite Hqp.
          split; [exact H2|].
          unfold w2; simpl. assert (A1 := arm1_pos P HP). assert (EA := r_arms P HP).
          assert (Ec : cos (angle (p T)) = - cos e) by (rewrite <- Se, sin_psi; ring). rewrite EA, Ec.
          assert (0 < arm1 P * (v_of P v' + r * cos e * u_of v')) by (now apply Rmult_lt_0_compat).
          replace (arm1 P * (v_of P v' + r * cos e * u_of v')) with (vy v' + r * arm1 P * cos e * om v') in H
            by (unfold u_of, v_of; field; lra). lra. }
        assert (La' : later P (reverse q) (- - T) a).
        { rewrite Ropp_involutive. destruct La as [ls [N1 [N2 N3]]]. exists ls. split; [exact N1|]. split; [exact N2|].
          intros s Hs. destruct (N3 s Hs) as [S1 [w [S2 S3]]]. split; [assumption|].
          exists w. unfold q, reverse. rewrite Ropp_involutive. split; [|exact S3].
          destruct S2 as [d [D1 D2]]. exists d. split; [exact D1|]. intros z Hz. rewrite !Ropp_involutive.
          now apply D2. }
        assert (Hx := L8_bridge_left P HP Hr1 U q (- T) e (minus_v v) b a HB Hq Hcq).
        rewrite Hqp in Hx. specialize (Hx H2 Hpsi He Haq). rewrite Euq, Evq in Hx. specialize (Hx ltac:(lra) SS Lb La').
        lia.
Qed.
End Bridge2.
