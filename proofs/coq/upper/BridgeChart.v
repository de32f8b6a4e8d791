(** L8, the main case, for the dumbbell: a contact with the bridge out of which the dumbbell goes left, with a
    slope below that of the chart's edge, is a point (e, eta) of the chart bridge; the two rays have at least
    its collisions.

    heavy_reflection == the velocities at a contact with the bridge
    L8_bridge_left   == before and after it together at most U collisions, if it goes left and is not steep *)
From Coq Require Import Reals Lra Lia List.
From Dumbbell Require Import Physics Chart Flight Collisions Symmetry BridgeRays Follow.
Local Open Scope R_scope.

Section Bridge.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.
Hypothesis Hr1 : r_of P <= 1.
Notation r := (r_of P).
Notation yh := (yhat_of P).

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
  intros HB Hm Hc H2 Hpsi He Ha Hu Hlt La Lb. assert (R0 := r_pos P HP).
  destruct (heavy_reflection p T e Hm Hc H2 Hpsi) as [v [v1 [Hb [Ha1 HR]]]].
  assert (v1 = v') by (apply after_unique with p T; assumption). subst v1.
  set (eta := v_of P v' / - u_of v' / r - cos e).
  assert (Es : r * lamX e eta * - u_of v' = v_of P v') by (unfold lamX, eta; field; lra).
  destruct (bridge_slopes P HP e eta _ _ _ _ He HR Hu Es) as [Heta [Hin ES]].
  assert (Ey : yh (p T) = r * sin e) by (rewrite (contact2 P HP p T H2), Hpsi, cos_top; reflexivity).
  (* X *)
  destruct (bridge_out_X P HP Hr1 (p T) v' e eta He Heta Hpsi Ey Hu Es) as [RX KX].
  assert (Ga := follow_start P HP Hr1 a p T v' _ _ Hm RX Ha KX La).
  (* sigma X: mirrored and reversed *)
  set (p' := mirror (reverse p)). assert (Hm' : motion P p') by (apply mirror_motion, reverse_motion; assumption).
  set (v2 := mirror_v (minus_v v)).
  assert (Ha2 : after p' (- T) v2) by (apply mirror_after, reverse_after; now rewrite Ropp_involutive).
  assert (Eu2 : u_of v2 = u_of v) by (unfold v2, u_of; simpl; ring).
  assert (Ev2 : v_of P v2 = - v_of P v) by exact (v_of_minus P HP v).
  assert (Hpsi2 : psi_of (p' (- T)) = - (PI/2 - e))
    by (unfold p'; rewrite psi_mirror; unfold reverse; rewrite Ropp_involutive; lra).
  assert (Ey2 : yh (p' (- T)) = r * sin e)
    by (rewrite <- Ey; unfold p', reverse, yhat_of; simpl; now rewrite Ropp_involutive).
  destruct (bridge_out_S P HP Hr1 (p' (- T)) v2 e eta He Heta Hpsi2 Ey2) as [RS KS]; [lra | now rewrite Eu2, Ev2|].
  assert (Gb := follow_start P HP Hr1 b p' (- T) v2 _ _ Hm' RS Ha2 KS (later_mirror P _ _ _ Lb)).
  apply (HB e eta a b He); try assumption; [lra|].
  assert (r * lamX e eta < 1 + r * cos e) by (apply Rmult_lt_reg_r with (- u_of v'); lra). unfold lamX in *. lra.
Qed.
End Bridge.
