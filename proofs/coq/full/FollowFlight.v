(** L15 (ii) and (c), and a contact's slope (L16), for the motion: a flight that leaves the wall R to the left has at
    most the later collisions that `forward` counts: it meets the bridge, and then a ray out of the bridge bounds it
    (to the right it is steep), or the other wall, which it leaves as from R, seen in the mirror.

    leaves_R                   == a state at which the light mass has just left the wall R
    L15_follow, contact_follow == `forward` counts its later collisions; and those after a contact with the bridge *)
From Coq Require Import Reals Lra Lia List.
From Dumbbell Require Import Physics Ray Chart Flight Collisions Symmetry StartRay Follow BridgeChart SteepRays Forward.
Local Open Scope R_scope.

Section FollowFlight.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.
Hypothesis Hr1 : r_of P <= 1.
Notation r := (r_of P).
Notation yh := (yhat_of P).

Lemma floor2 (p : R -> pos) t : motion P p -> r * cos (psi_of (p t)) <= yh (p t).
Proof.
  intros Hm. assert (A := above2 P p Hm t). assert (A1 := arm1_pos P HP). destruct (L0_heights P (p t) HP) as [_ E].
  rewrite E in A. unfold r_of.
  assert (0 <= yh (p t) - m1 P / m2 P * cos (psi_of (p t))) by (apply Rmult_le_reg_l with (arm1 P); lra). lra.
Qed.

(** Out of a contact with the bridge at psi = pi/2 - t to the left: the rays of the chart contact, L15 (i). *)
Theorem contact_follow p T v t n : motion P p -> after p T v -> psi_of (p T) = PI/2 - t -> 0 < t < PI ->
  yh (p T) = r * sin t -> u_of v < 0 -> 0 < v_of P v + r * cos t * u_of v -> later P p T n ->
  exists eta, 0 < eta /\ r * lamX t eta = v_of P v / - u_of v /\ coll r n (r * cX t eta) (r * lamX t eta).
Proof.
  intros Hm Ha Hp Ht Hy Hu Hn Hl. assert (R0 := r_pos P HP). set (k := v_of P v / - u_of v).
  assert (Ek : k * - u_of v = v_of P v) by (unfold k; field; lra).
  assert (Hk : r * cos t < k) by (apply Rmult_lt_reg_r with (- u_of v); lra).
  assert (B := bridge_start_ray P HP Hr1 (p T) v k Hu Ek). rewrite Hp, Hy, sin_minus, cos_minus, sin_PI2, cos_PI2 in B.
  destruct B as [RX KX]; [lra | ring | lra|].
  assert (G := follow_start P HP Hr1 n p T v _ k Hm RX Ha KX Hl).
  exists (k / r - cos t). assert (E : r * lamX t (k / r - cos t) = k) by (unfold lamX; field; lra). split.
  - apply Rmult_lt_reg_l with r; [exact R0|]. replace (r * (k / r - cos t)) with (k - r * cos t) by (field; lra). lra.
  - split; [exact E|]. rewrite E.
    replace (r * cX t (k / r - cos t)) with (r * (0 * cos t + 1 * sin t) + k * (PI/2 - t + PI/2)); [exact G|].
    replace (r * cX t (k / r - cos t)) with (r * sin t + r * lamX t (k / r - cos t) * (PI - t)) by (unfold cX; ring).
    rewrite E. field.
Qed.

(** L16: its slope. *)
Lemma L16_contact_slope t u v u' v' k : reflects P (- (r * cos t)) u v u' v' -> u < 0 -> k * - u = v -> u' < 0 ->
  0 < contact_den (cos t) k r /\ v' / - u' * contact_den (cos t) k r = contact_num (cos t) k r.
Proof.
  intros [l [Hl [Eu [Ev [Er _]]]]] Hu Hs Hu'. assert (R0 := r_pos P HP). set (s := cos t) in *.
  assert (S0 : 0 < 1 + r * (s * s)).
  { assert (0 <= r * (s * s)) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]). lra. }
  assert (El : l * r * (1 + r * (s * s)) = 2 * (k - r * s) * u).
  { rewrite <- Hs in *. replace (l * r * (1 + r * (s * s))) with (l * r + r * s * (l * (r * s))) by ring.
    replace (l * r) with (v' - k * - u) by lra. replace (l * (r * s)) with (u' - u) by lra. lra. }
  assert (A : - u' * (1 + r * (s * s)) = - u * contact_den s k r).
  { replace (- u' * (1 + r * (s * s))) with (- u * (1 + r * (s * s)) - s * (l * r * (1 + r * (s * s)))).
    - rewrite El. unfold contact_den. ring.
    - rewrite Eu. ring. }
  assert (B : v' * (1 + r * (s * s)) = - u * contact_num s k r).
  { replace (v' * (1 + r * (s * s))) with (k * - u * (1 + r * (s * s)) + l * r * (1 + r * (s * s))).
    - rewrite El. unfold contact_num. ring.
    - rewrite Ev, <- Hs. ring. }
  assert (D : 0 < contact_den s k r).
  { apply Rmult_lt_reg_l with (- u); [lra|]. rewrite Rmult_0_r, <- A. apply Rmult_lt_0_compat; lra. }
  split; [exact D|]. apply Rmult_eq_reg_l with (- u * - u'); [|apply Rgt_not_eq; apply Rmult_lt_0_compat; lra].
  replace (- u * - u' * (v' / - u' * contact_den s k r)) with (v' * (- u * contact_den s k r)) by (field; lra).
  rewrite <- A. replace (v' * (- u' * (1 + r * (s * s)))) with (v' * (1 + r * (s * s)) * - u') by ring.
  rewrite B. ring.
Qed.

(** L15 (c): to the right it is steep. *)
Lemma contact_right_steep t u v u' v' : reflects P (- (r * cos t)) u v u' v' -> u <= v -> 0 <= u' -> Rabs u' <= v'.
Proof.
  intros [l [Hl [Eu [Ev _]]]] Huv Hu. rewrite Rabs_pos_eq by exact Hu. assert (R0 := r_pos P HP).
  destruct (COS_bound t). assert (0 <= l * r * (1 - cos t)).
  { apply Rmult_le_pos; [left; now apply Rmult_lt_0_compat | lra]. } lra.
Qed.

(** The flight. *)
Record leaves_R (p : R -> pos) (t0 : R) (v : vel) (x k : R) : Prop := {
  lr_after : after p t0 v; lr_psi : psi_of (p t0) = PI/2 + x; lr_x : 0 < x <= PI/2; lr_y : yh (p t0) = sin x;
  lr_left : u_of v < 0; lr_slope : k * - u_of v = v_of P v; lr_up : - cos x < k }.

Lemma leaves_height p t0 v x k t1 : leaves_R p t0 v x k -> on_line p t0 v t1 -> forall t, psi_of (p t1) = PI/2 - t ->
  yh (p t1) = height_at x k t.
Proof.
  intros [_ Hp _ Hy Hu Hs _] L t Et. destruct (on_line_coords P HP _ _ _ _ L) as [E1 E2].
  rewrite E2, Hy, <- Hs. unfold height_at. rewrite Et, Hp in E1.
  replace (x + t) with (- u_of v * (t1 - t0)) by lra. ring.
Qed.

(** It does not come behind the peak of the left hump and collide there. *)
Lemma before_peak p t0 v x k t1 : motion P p -> leaves_R p t0 v x k -> t0 < t1 ->
  (forall s, t0 <= s <= t1 -> on_line p t0 v s) -> collision P p t1 -> - PI < psi_of (p t1).
Proof.
  intros Hm [Ha Hp Hx Hy Hu Hs Hup] H01 Ln Hc. apply Rnot_le_lt. intros K. assert (HPI : 0 < PI) by apply PI_RGT_0.
  apply (past_peak P HP Hr1 p t0 v k t1); try assumption; [lra|]. intros Hh. destruct (SIN_bound x).
  apply Rmult_le_reg_r with (psi_of (p t0) + PI); lra.
Qed.

(** On its way to the left wall it is never below the bridge. *)
Lemma flight_clears p t0 v x k t1 : motion P p -> leaves_R p t0 v x k ->
  (forall s, t0 <= s <= t1 -> on_line p t0 v s) -> t0 < t1 -> psi_of (p t1) <= - (PI/2) -> clears_bridge r x k.
Proof.
  intros Hm HR Ln H01 Hend t Ht. assert (HPI : 0 < PI) by apply PI_RGT_0. assert (HR0 := HR).
  destruct HR as [Ha Hp Hx Hy Hu Hs Hup]. destruct (on_line_coords P HP _ _ _ _ (Ln t1 ltac:(lra))) as [E1 _].
  set (d := (x + t) / - u_of v). assert (Hd : - u_of v * d = x + t) by (unfold d; field; lra).
  assert (D0 : 0 <= d) by (unfold d; apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; lra]).
  assert (D1 : d <= t1 - t0) by (apply Rmult_le_reg_l with (- u_of v); lra).
  assert (L := Ln (t0 + d) ltac:(lra)). destruct (on_line_coords P HP _ _ _ _ L) as [F1 _].
  replace (t0 + d - t0) with d in F1 by ring. assert (Et : psi_of (p (t0 + d)) = PI/2 - t) by lra.
  rewrite <- (leaves_height p t0 v x k _ HR0 L t Et). assert (F := floor2 p (t0 + d) Hm).
  rewrite Et, cos_minus, cos_PI2, sin_PI2 in F. lra.
Qed.

(** The next collision: with the bridge, or with the left wall. *)
Theorem next_of_flight p t0 v x k t1 : motion P p -> leaves_R p t0 v x k -> t0 < t1 -> collision P p t1 ->
  (forall t, t0 < t < t1 -> ~ collision P p t) ->
  (exists t v', y2 P (p t1) = 0 /\ psi_of (p t1) = PI/2 - t /\ meets_bridge r x k t /\ after p t1 v' /\
     reflects P (- (r * cos t)) (u_of v) (v_of P v) (u_of v') (v_of P v')) \/
  (clears_bridge r x k /\ exists y v', 0 < y /\ hit (height_at x k PI) k y /\ psi_of (p t1) = - (PI/2) - y /\
     yh (p t1) = sin y /\ after p t1 v' /\ reflects P (- cos y) (u_of v) (v_of P v) (u_of v') (v_of P v')).
Proof.
  intros Hm HR H01 Hc Hf. assert (HPI : 0 < PI) by apply PI_RGT_0. assert (R0 := r_pos P HP).
  assert (Ln := straight_flight P HP p t0 t1 v Hm (lr_after _ _ _ _ _ HR) H01 Hf).
  assert (Pk := before_peak p t0 v x k t1 Hm HR H01 Ln Hc). assert (L1 := Ln t1 ltac:(lra)).
  destruct (on_line_coords P HP _ _ _ _ L1) as [E1 _].
  destruct (collision_law P HP p t1 Hm Hc) as [va [v' [Hb [Ha' HL]]]].
  destruct (on_line_until p t0 t1 v va H01) as [-> _]; [intros s Hs; apply Ln; lra | exact Hb |].
  set (t := PI/2 - psi_of (p t1)). assert (Et : psi_of (p t1) = PI/2 - t) by (unfold t; ring).
  assert (EY := leaves_height p t0 v x k t1 HR L1 t Et). assert (HR0 := HR). destruct HR as [Ha Hp Hx Hy Hu Hs Hup].
  assert (Hpos : 0 < - u_of v * (t1 - t0)) by (apply Rmult_lt_0_compat; lra).
  assert (T1 : - x < t) by lra. assert (F1 := floor1 P HP p t1 Hm). assert (F2 := floor2 p t1 Hm).
  assert (Ec : cos (psi_of (p t1)) = sin t) by (rewrite Et, cos_minus, cos_PI2, sin_PI2; ring).
  assert (Es : sin (psi_of (p t1)) = cos t) by (rewrite Et, sin_minus, cos_PI2, sin_PI2; ring).
  rewrite Ec in F1, F2. destruct HL as [[C HL]|[C HL]].
  - right. assert (C1 := contact1 P HP p t1 C). rewrite Ec in C1. unfold slope1 in HL. rewrite Es in HL.
    assert (Neg : sin t < 0).
    { assert (K : 0 <= (1 + r) * - sin t) by lra. assert (K1 : 0 <= - sin t).
      { apply Rmult_le_reg_l with (1 + r); lra. }
      destruct (Rle_lt_or_eq_dec _ _ K1) as [|K2]; [lra|exfalso]. apply (regular P p Hm t1). split; [exact C|].
      destruct (L0_heights P (p t1) HP) as [_ E]. rewrite E, C1, Ec. replace (sin t) with 0 by lra. ring. }
    assert (T2 : PI < t).
    { apply Rnot_le_lt. intros K. destruct (Rle_or_lt 0 t) as [K0|K0].
      - assert (0 <= sin t) by (apply sin_ge_0; lra). lra.
      - assert (Tg := sin_below_tangent x (- t) ltac:(lra) ltac:(lra)). rewrite sin_neg in Tg. unfold height_at in EY.
        assert (0 < (k + cos x) * (x + t)) by (apply Rmult_lt_0_compat; lra). lra. }
    split; [apply (flight_clears p t0 v x k t1 Hm HR0 Ln H01); lra|].
    assert (Sy : sin (t - PI) = - sin t) by (rewrite sin_minus, cos_PI, sin_PI; ring).
    assert (Cy : cos (t - PI) = - cos t) by (rewrite cos_minus, cos_PI, sin_PI; ring).
    exists (t - PI), v'. split; [lra|]. rewrite Cy, Sy.
    split; [split; [lra|]|split; [lra|]; split; [lra|]; split; [exact Ha'|]; now rewrite Ropp_involutive].
    rewrite Cy, Sy. split; [unfold height_at in *; lra|]. destruct HL as [l [_ [_ [_ [_ Hn]]]]]. rewrite <- Hs in Hn.
    apply Rmult_lt_reg_r with (- u_of v); lra.
  - left. assert (C1 := contact2 P HP p t1 C). rewrite Ec in C1. unfold slope2 in HL. rewrite Es in HL.
    assert (Pos : 0 < sin t).
    { assert (K : 0 <= (1 + r) * sin t) by lra. assert (K1 : 0 <= sin t) by (apply Rmult_le_reg_l with (1 + r); lra).
      destruct (Rle_lt_or_eq_dec _ _ K1) as [|K2]; [assumption|exfalso]. apply (regular P p Hm t1). split; [|exact C].
      destruct (L0_heights P (p t1) HP) as [E _]. rewrite E, C1, Ec, <- K2. ring. }
    assert (T2 : 0 < t).
    { apply Rnot_le_lt. intros K. assert (0 <= sin (- t)) by (apply sin_ge_0; lra). rewrite sin_neg in H. lra. }
    assert (T3 : t < PI).
    { apply Rnot_le_lt. intros K. assert (0 <= sin (t - PI)) by (apply sin_ge_0; lra).
      rewrite sin_minus, cos_PI, sin_PI in H. lra. }
    replace (- r * cos t) with (- (r * cos t)) in HL by ring. exists t, v'. split; [exact C|]. split; [exact Et|].
    split; [|now split]. split; [lra|]. split; [lra|]. destruct HL as [l [_ [_ [_ [_ Hn]]]]]. rewrite <- Hs in Hn.
    apply Rmult_lt_reg_r with (- u_of v); lra.
Qed.

(** L15 (ii). *)
Theorem L15_follow n : forall p t0 v x k, motion P p -> leaves_R p t0 v x k -> later P p t0 n -> forward r n x k.
Proof.
  induction n as [|n IH]; [easy|]. intros p t0 v x k Hm HR Hl. assert (R0 := r_pos P HP).
  destruct (later_next P HP p t0 n Hm Hl) as [t1 [H01 [Hc1 [Hf Hl1]]]].
  destruct (next_of_flight p t0 v x k t1 Hm HR H01 Hc1 Hf) as [[t [v' [H2 [Hp [Hb [Ha' HL]]]]]]|
    [Hcl [y [v' [Hy0 [Hy [Hp [Hyh [Ha' HL]]]]]]]]]; destruct HR as [Ha Hpsi Hx Hyx Hu Hs Hup].
  - left. exists t. split; [exact Hb|]. destruct (Rlt_or_le (u_of v') 0) as [K|K]; [right | left].
    + destruct (contact_follow p t1 v' t n Hm Ha' Hp (proj1 Hb)) as [eta [He [El G]]]; try assumption.
      * rewrite (contact2 P HP p t1 H2), Hp, cos_minus, cos_PI2, sin_PI2. ring.
      * destruct HL as [l [_ [_ [_ [Er En]]]]]. lra.
      * destruct (L16_contact_slope t _ _ _ _ k HL Hu Hs K) as [D1 D2].
        exists eta. rewrite El. rewrite El in G. now repeat split.
    + apply (L3_steep_no_later P HP Hr1 p t1 v' n Hm Ha'); [|exact Hl1].
      apply (contact_right_steep t (u_of v) (v_of P v)); [exact HL | | exact K].
      destruct (COS_bound x). assert (-1 * - u_of v <= k * - u_of v) by (apply Rmult_le_compat_r; lra). lra.
  - right. split; [exact Hcl|]. exists y. split; [exact Hy0|]. split; [exact Hy|].
    destruct n as [|n]; [now left | right].
    destruct (later_next P HP p t1 n Hm Hl1) as [t2 [H12 [Hc2 _]]].
    destruct (reflects_hit P HP Hr1 p t1 v v' _ k y Hy Hu Hs HL Ha' Hm Hp Hyh Hy0) as [HD [Hup' Hkk]]; [now exists t2|].
    split; [exact HD|]. assert (Hy' := Hy). destruct Hy' as [Y1 [Y2 Y3]].
    apply (IH (mirror p) t1 (mirror_v v')); [now apply mirror_motion | | now apply later_mirror].
    split; rewrite ?psi_mirror, ?Hp; try lra.
    + now apply mirror_after.
    + exact Hyh.
    + unfold u_of in *; simpl; lra.
    + unfold u_of, v_of in *; simpl; lra.
    + apply next_leaves; try lra. assert (0 <= cos y * cos y) by apply Rle_0_sqr. lra.
Qed.
End FollowFlight.
