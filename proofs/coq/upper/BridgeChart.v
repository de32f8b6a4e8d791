(** L8, the main case, for the dumbbell: a contact with the bridge out of which the dumbbell goes left, with a
    slope below that of the chart's edge, is a point (e, eta) of the chart bridge; the two rays have at least
    its collisions. *)
From Coq Require Import Reals Lra Lia List.
From Dumbbell Require Import Physics Chart Flight Collisions Symmetry StartRay Follow.
Local Open Scope R_scope.

Section Bridge.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.
Hypothesis Hr1 : r_of P <= 1.
Notation r := (r_of P).
Notation yh := (yhat_of P).

(** L6: out of a contact with the bridge to the left. *)
Theorem bridge_ray p t0 v k : motion P p -> after p t0 v -> u_of v < 0 -> k * - u_of v = v_of P v ->
  - (PI/2) < psi_of (p t0) < PI/2 -> yh (p t0) = r * cos (psi_of (p t0)) ->
    0 < v_of P v + r * sin (psi_of (p t0)) * u_of v ->
  let c := r * cos (psi_of (p t0)) + k * (psi_of (p t0) + PI/2) in ray P p t0 v c k /\ 0 <= c /\ - r <= k.
Proof.
  intros _ Ha Hu Hs Hp Hy Hn c. destruct (bridge_start_ray P HP Hr1 (p t0) v k Hu Hs Hp Hy Hn) as [S K].
  split; [now apply start_ray_ray|]. split; [left; exact (start_ray_height_pos P _ _ _ _ S) | exact K].
Qed.

(** A collision with the bridge at psi = pi/2 - e: the two velocities. *)
Lemma heavy_reflection p T e : motion P p -> collision P p T -> y2 P (p T) = 0 -> psi_of (p T) = PI/2 - e ->
  exists v v', before p T v /\ after p T v' /\
  reflects P (- (r * cos e)) (u_of v) (v_of P v) (u_of v') (v_of P v').
Proof.
  intros Hm Hc H2 Hpsi. destruct (collision_law P HP p T Hm Hc) as [v [v' [Hb [Ha HL]]]]. exists v, v'.
  split; [exact Hb|]. split; [exact Ha|].
  destruct HL as [[H1 _]|[_ HR]]; [exfalso; apply (regular P p Hm T); now split|]. unfold slope2 in HR.
  rewrite Hpsi, sin_minus, sin_PI2, cos_PI2 in HR.
  now replace (- r * (1 * cos e - 0 * sin e)) with (- (r * cos e)) in HR by ring.
Qed.

(** L8: a contact with the bridge whose outgoing ray X goes left with slope r (s + eta) < 1. *)
Theorem L8_bridge_left U p T e v' a b : bridge_bound r U -> motion P p -> collision P p T -> y2 P (p T) = 0 ->
  psi_of (p T) = PI/2 - e -> 0 < e <= PI/2 -> after p T v' -> u_of v' < 0 -> v_of P v' < - u_of v' * (1 + r * cos e) ->
  later P p T a -> later P (reverse p) (- T) b -> (1 + a + b <= U)%nat.
Proof.
  intros HB Hm Hc H2 Hpsi He Ha Hu Hlt La Lb. assert (R0 := r_pos P HP). assert (HPI : 0 < PI) by apply PI_RGT_0.
  assert (Se : sin (psi_of (p T)) = cos e) by (rewrite Hpsi, sin_minus, sin_PI2, cos_PI2; ring).
  assert (Ce : cos (psi_of (p T)) = sin e) by (rewrite Hpsi, cos_minus, sin_PI2, cos_PI2; ring).
  destruct (cos_range e ltac:(lra)) as [W0 W1]. assert (S0 : 0 < sin e) by (apply sin_gt_0; lra).
  destruct (heavy_reflection p T e Hm Hc H2 Hpsi) as [v [v1 [Hb [Ha1 HR]]]].
  assert (v1 = v') by (apply after_unique with p T; assumption). subst v1.
  destruct HR as [l [Hl [Eu [Ev [Er En]]]]].
  set (g := - u_of v') in *. assert (G0 : 0 < g) by (unfold g; lra).
  set (k := v_of P v' / g). assert (Ek : k * g = v_of P v') by (unfold k; field; lra).
  set (eta := k / r - cos e). assert (Eeta : k = r * (cos e + eta)) by (unfold eta; field; lra).
  assert (Hq : 0 < 1 + r * (cos e * cos e)).
  { assert (0 <= r * (cos e * cos e)) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]). lra. }
  assert (A4 : v_of P v' + r * cos e * u_of v' = r * (g * eta)) by (rewrite <- Ek, Eeta; unfold g; ring).
  assert (Hle : l * (1 + r * (cos e * cos e)) = 2 * g * eta).
  { assert (A1 : u_of v = u_of v' - l * (r * cos e)) by lra. assert (A2 : v_of P v = v_of P v' - l * r) by lra.
    assert (A3 : 2 * (v_of P v' + r * cos e * u_of v') = r * (l * (1 + r * (cos e * cos e))))
      by (rewrite A1, A2 in Er; lra).
    apply Rmult_eq_reg_l with r; lra. }
  assert (Heta : 0 < eta). { assert (0 < l * (1 + r * (cos e * cos e))) by (now apply Rmult_lt_0_compat).
    apply Rmult_lt_reg_l with (2 * g); lra. }
  (* X *)
  assert (BX := bridge_ray p T v' k Hm Ha Hu Ek ltac:(lra) (contact2 P HP p T H2)).
  rewrite Se, Ce, Hpsi in BX. destruct BX as [RX [CX KX]].
  { rewrite A4. apply Rmult_lt_0_compat; [assumption | now apply Rmult_lt_0_compat]. }
  assert (Ga := follow_ray P HP Hr1 a p T v' _ k Hm RX CX KX La).
  (* sigma X: mirrored and reversed *)
  set (p' := mirror (reverse p)). assert (Hm' : motion P p') by (apply mirror_motion, reverse_motion; assumption).
  assert (Hp' : p' (- T) = {| height := height (p T); angle := PI - angle (p T) |})
    by (unfold p', mirror, reverse; now rewrite Ropp_involutive).
  set (v2 := mirror_v (minus_v v)).
  assert (Ha2 : after p' (- T) v2) by (apply mirror_after, reverse_after; now rewrite Ropp_involutive).
  assert (Eu2 : u_of v2 = u_of v) by (unfold v2, u_of; simpl; ring).
  assert (Ev2 : v_of P v2 = - v_of P v) by (unfold v2, v_of; simpl; field; assert (A := arm1_pos P HP); lra).
  assert (Hpsi2 : psi_of (p' (- T)) = - (PI/2 - e)) by (rewrite Hp'; unfold psi_of in *; simpl; lra).
  assert (Hy2 : yh (p' (- T)) = yh (p T)) by (rewrite Hp'; reflexivity).
  assert (Hrs : 0 <= r * cos e) by (apply Rmult_le_pos; lra).
  assert (Huin : u_of v < 0). { assert (0 <= l * (r * cos e)) by (apply Rmult_le_pos; lra). unfold g in *. lra. }
  assert (Hden : 0 < 1 + r * (cos e * cos e) + 2 * (r * cos e * eta))
    by (assert (0 <= r * cos e * eta) by (apply Rmult_le_pos; lra); lra).
  assert (El : l = 2 * g * eta / (1 + r * (cos e * cos e)))
    by (apply Rmult_eq_reg_r with (1 + r * (cos e * cos e)); [rewrite Hle; field; lra | lra]).
  set (kS := r * lamS e eta r).
  assert (EkS : kS * - u_of v2 = v_of P v2).
  { rewrite Eu2, Ev2. replace (u_of v) with (- g - l * (r * cos e)) by (unfold g; lra).
    replace (v_of P v) with (k * g - l * r) by lra.
    rewrite El, Eeta. unfold kS, lamS, eta_reversed. field. split; lra. }
  assert (BS := bridge_ray p' (- T) v2 kS Hm' Ha2 ltac:(lra) EkS ltac:(lra)).
  rewrite Hy2, Hpsi2, cos_neg, sin_neg in BS. rewrite cos_minus, sin_minus, sin_PI2, cos_PI2 in BS.
  destruct BS as [RS [CS KS]].
  { rewrite (contact2 P HP p T H2), Ce. ring. } { rewrite Eu2, Ev2. lra. }
  assert (Lb' : later P p' (- T) b) by (now apply later_mirror).
  assert (Gb := follow_ray P HP Hr1 b p' (- T) v2 _ kS Hm' RS CS KS Lb').
  apply (HB e eta a b He); try lra.
  - assert (k < 1 + r * cos e) by (apply Rmult_lt_reg_r with g; [assumption|]; unfold g in *; lra).
    rewrite Eeta in H. lra.
  - unfold cX, lamX. rewrite Eeta in Ga.
    replace (r * (sin e + (cos e + eta) * (PI - e))) with (r * sin e + r * (cos e + eta) * (PI / 2 - e + PI / 2))
      by field. exact Ga.
  - unfold cS. fold kS.
    replace (r * (sin e + lamS e eta r * e)) with (r * (0 * cos e + 1 * sin e) + kS * (- (PI / 2 - e) + PI / 2))
      by (unfold kS; ring). exact Gb.
Qed.
End Bridge.
