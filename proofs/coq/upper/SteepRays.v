(** L3 and L8 (c): a steep flight has no later collision; a flight to the nearer side of the bridge has at most those of
    the bridge's tangent; so every contact with the bridge is bounded by the chart bridge.

    L3_steep_no_later == a steep flight has no later collision
    L8_bridge_contact == before and after any contact with the bridge together at most U collisions *)
From Coq Require Import Reals Lra Lia List.
From Dumbbell Require Import Physics Ray Chart Flight Collisions Symmetry StartRay Follow BridgeChart.
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
  destruct (bridge_start_ray P HP Hr1 (p t0) v k Hu Ek ltac:(lra) Hy Hn) as [RX KX].
  assert (Sp : sin (psi_of (p t0)) = - cos e) by (rewrite Hp, sin_neg, sin_minus, sin_PI2, cos_PI2; ring).
  assert (Cp : cos (psi_of (p t0)) = sin e) by (rewrite Hp, cos_neg, cos_minus, sin_PI2, cos_PI2; ring).
  assert (Gb := follow_start P HP Hr1 b p t0 v _ k Hm RX Ha KX Hl). rewrite Cp, Hp in Gb. rewrite Sp in Hn.
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

(** The chart's rays out of a contact at psi = pi/2 - e: to the left, below the slope at which L3 rules out collisions.
    *)
Definition in_chart e v := u_of v < 0 /\ v_of P v < - u_of v * (1 + r * cos e).

(** L8 (c): a flight out of a contact at psi = pi/2 - e that is none of these is steep, or goes right; then the mirrored
    tangent bounds it. *)
Lemma L8c_outside_chart U f t e w n : bridge_bound r U -> motion P f -> after f t w -> y2 P (f t) = 0 ->
  psi_of (f t) = PI/2 - e -> 0 < e <= PI/2 -> 0 < v_of P w + r * cos e * u_of w -> ~ in_chart e w -> later P f t n ->
  n = O \/ (v_of P w < u_of w /\ (1 + n <= U)%nat).
Proof.
  intros HB Hf Ha H2 Hpsi He Hn Hout Hl. assert (R0 := r_pos P HP). assert (HPI : 0 < PI) by apply PI_RGT_0.
  destruct (cos_range e ltac:(lra)) as [W0 W1]. assert (Hrs : 0 <= r * cos e) by (apply Rmult_le_pos; lra).
  destruct (Rle_or_lt (Rabs (u_of w)) (v_of P w)) as [K|K]; [left; now apply (L3_steep_no_later f t w) | right].
  assert (Hu : 0 < u_of w).
  { apply Rnot_le_lt. intros L. rewrite Rabs_left1 in K by exact L.
    destruct (Rle_lt_or_eq_dec _ _ L) as [L'|L']; [|rewrite L' in *; lra]. apply Hout. split; [exact L'|].
    assert (0 <= - u_of w * (r * cos e)) by (apply Rmult_le_pos; lra). lra. }
  split; [now rewrite Rabs_pos_eq in K by lra|].
  assert (Ep : psi_of (mirror f t) = - (PI/2 - e)) by (rewrite psi_mirror, Hpsi; reflexivity).
  apply (tangent_bound U (mirror f) t e (mirror_v w) n HB); try assumption.
  - now apply mirror_motion.
  - now apply mirror_after.
  - rewrite Ep, cos_neg, <- Hpsi. exact (contact2 P HP f t H2).
  - unfold u_of in *; simpl; lra.
  - rewrite Ep, sin_neg, sin_minus, sin_PI2, cos_PI2. unfold u_of, v_of in *; simpl. lra.
  - now apply later_mirror.
Qed.

(** L8: all contacts with the bridge. If neither X nor sigma X is in the chart, one of them is steep. *)
Theorem L8_bridge_contact U p T e a b : bridge_bound r U -> (1 <= U)%nat -> motion P p -> collision P p T ->
  y2 P (p T) = 0 -> psi_of (p T) = PI/2 - e -> 0 < e <= PI/2 -> later P p T a -> later P (reverse p) (- T) b ->
  (1 + a + b <= U)%nat.
Proof.
  intros HB HU Hm Hc H2 Hpsi He La Lb. assert (R0 := r_pos P HP). destruct (cos_range e ltac:(lra)) as [W0 W1].
  destruct (heavy_reflection P HP p T e Hm Hc H2 Hpsi) as [v [v' [Hb [Ha [l [Hl [Eu [Ev [Er En]]]]]]]]].
  set (q := reverse p). assert (Hq : motion P q) by (now apply reverse_motion).
  assert (Hcq : collision P q (- T)) by (now apply (collision_reverse P HP)).
  assert (Haq : after q (- T) (minus_v v)) by (apply reverse_after; now rewrite Ropp_involutive).
  assert (Hqp : q (- T) = p T) by (unfold q, reverse; now rewrite Ropp_involutive).
  assert (Euq : u_of (minus_v v) = - u_of v) by reflexivity. assert (Evq := v_of_minus P HP v).
  destruct (Classical_Prop.classic (in_chart e v')) as [[X1 X2]|X].
  { now apply (L8_bridge_left P HP Hr1 U p T e v' a b). }
  destruct (Classical_Prop.classic (in_chart e (minus_v v))) as [[S1 S2]|S].
  { assert (K : (1 + b + a <= U)%nat); [|lia].
    apply (L8_bridge_left P HP Hr1 U q (- T) e (minus_v v) b a); try assumption; rewrite ?Hqp; try assumption.
    unfold q. rewrite reverse_reverse, Ropp_involutive. exact La. }
  destruct (L8c_outside_chart U p T e v' a HB Hm Ha H2 Hpsi He) as [->|[XA XB]]; try assumption; [lra | |];
    destruct (L8c_outside_chart U q (- T) e (minus_v v) b HB Hq Haq) as [->|[SA SB]]; rewrite ?Hqp, ?Euq, ?Evq;
    try assumption; try lra; try lia.
  exfalso. rewrite Euq, Evq in SA. assert (l * r < l * (r * cos e)) by lra.
  assert (l * (r * cos e) <= l * (r * 1)) by (repeat (apply Rmult_le_compat_l; [lra|]); lra). lra.
Qed.
End Bridge2.
