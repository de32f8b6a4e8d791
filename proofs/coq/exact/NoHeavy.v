(** L24: a motion in which the heavy mass never hits the floor has at most 1 + k0 + k1 collisions. Out of a turning
    collision a ray to the left passes over the top of the bridge, so that it is at least the top orbit; and of two
    such rays one has a slope of at least r (L23), so that it is at least the corner orbit.

    L24_no_heavy                == at most 1 + k0 + k1 collisions
    above_bridge, clears_bridge == such a motion is above the bridge, at all times and along its rays *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics Ray Chart Flight Collisions Symmetry NormalPosition Follow SteepRays HeavyTotal.
From Dumbbell Require Import TurningCollision LightTotal Orbits.
Local Open Scope R_scope.

Section NoHeavy.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.
Hypothesis Hr1 : r_of P <= 1.
Notation r := (r_of P).
Notation yh := (yhat_of P).

Lemma above_bridge p t : motion P p -> r * cos (psi_of (p t)) <= yh (p t).
Proof.
  intros Hm. assert (A := above2 P p Hm t). assert (A1 := arm1_pos P HP). destruct (L0_heights P (p t) HP) as [_ E].
  rewrite E in A. apply Rmult_le_reg_l with (arm1 P); [exact A1|]. unfold r_of in *. lra.
Qed.

(** A ray that never hits the bridge is nowhere below it. *)
Lemma clears_bridge p T v c k z : motion P p -> ray P p T v c k -> - (PI/2) <= z < psi_of (p T) ->
  r * cos z <= yh (p T) + k * (psi_of (p T) - z).
Proof.
  intros Hm HR Hz. assert (Hu := ray_left _ _ _ _ _ _ HR). assert (Hs := ray_slope _ _ _ _ _ _ HR).
  assert (Ha := ray_after _ _ _ _ _ _ HR). set (d := (psi_of (p T) - z) / - u_of v).
  assert (Ed : - u_of v * d = psi_of (p T) - z) by (unfold d; field; lra).
  assert (D0 : 0 < d) by (apply Rdiv_lt_0_compat; lra).
  assert (Free : forall t, T < t < T + d -> ~ collision P p t).
  { intros t Ht Hc. destruct (first_collision P HP p T t Hm ltac:(lra) Hc) as [t1 [H1 [Hc1 Hf]]].
    destruct (next_hit P HP Hr1 p T v c k t1 Hm HR ltac:(lra) Hc1 Hf) as [x [X0 [_ [Hp _]]]].
    assert (L := straight_flight P HP p T t1 v Hm Ha ltac:(lra) Hf t1 ltac:(lra)).
    destruct (on_line_coords P HP _ _ _ _ L) as [E _].
    assert (- u_of v * (t1 - T) < - u_of v * d) by (apply Rmult_lt_compat_l; lra). lra. }
  assert (L := straight_flight P HP p T (T + d) v Hm Ha ltac:(lra) Free (T + d) ltac:(lra)).
  destruct (on_line_coords P HP _ _ _ _ L) as [E1 E2]. replace (T + d - T) with d in * by ring.
  assert (F := above_bridge p (T + d) Hm). replace (psi_of (p (T + d))) with z in F by lra.
  rewrite E2, <- Hs in F. replace (k * - u_of v * d) with (k * (- u_of v * d)) in F by ring. rewrite Ed in F. exact F.
Qed.

Variables k0 k1 : nat.
Hypothesis H0 : forall n, coll r n r 0 -> (n <= k0)%nat.
Hypothesis H1 : forall n, coll r n (PI * r) r -> (n <= k1)%nat.

(** Out of a contact with R, ascending: at most k0 later collisions, and at most k1 if the slope is r or more. *)
Theorem L24_ray p T e v n : motion P p -> no_heavy P p -> on_R P p T e -> after p T v -> 0 <= v_of P v ->
  0 < v_of P v - cos e * u_of v -> later P p T n ->
  (n <= k0)%nat /\ (0 <= u_of v \/ r * - u_of v <= v_of P v -> (n <= k1)%nat).
Proof.
  intros Hm Hn HR Ha Hv HN Hl. assert (R0 := r_pos P HP). assert (HPI := PI2_1).
  destruct (Rle_or_lt 0 (u_of v)) as [Hu|Hu].
  { rewrite (L1b_right_no_later P HP Hr1 p T v e n Hm Ha HR Hu HN Hl). split; [lia | intros; lia]. }
  set (k := v_of P v / - u_of v). assert (Hs : k * - u_of v = v_of P v) by (unfold k; field; lra).
  assert (Hk : 0 <= k) by (apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; lra]).
  assert (RX := light_ray P p T v k e Ha HR Hn Hu Hk Hs). destruct HR as [Hp [He Hy]].
  assert (B := clears_bridge p T v _ k 0 Hm RX ltac:(lra)). rewrite cos_0, Hp, Hy in B.
  assert (S0 : 0 < sin e) by (apply sin_gt_0; lra). assert (K1 : 0 <= k * (PI/2)) by (apply Rmult_le_pos; lra).
  assert (K2 : 0 <= k * e) by (apply Rmult_le_pos; lra).
  assert (C := follow_ray P HP Hr1 n p T v _ k Hm RX ltac:(lra) ltac:(lra) Hl). split.
  - apply H0. apply (coll_mono n) with (8 := C); lra.
  - intros [H|H]; [lra|]. assert (Hkr : r <= k) by (apply Rmult_le_reg_r with (- u_of v); lra).
    assert (PI * r <= PI * k) by (apply Rmult_le_compat_l; lra).
    assert (0 < PI * r) by (apply Rmult_lt_0_compat; lra).
    apply H1. apply (coll_mono n) with (8 := C); lra.
Qed.

(** L23: not both rays at a turning collision have slopes below r. *)
Theorem L23_one_steep w u v u' v' : 0 <= w <= 1 -> reflects P w u v u' v' ->
  0 <= u' \/ r * - u' <= v' \/ 0 <= - u \/ r * u <= - v.
Proof.
  intros Hw [l [Hl [Eu [Ev _]]]]. assert (R0 := r_pos P HP). destruct (Rle_or_lt (r * - u') v') as [|A]; [tauto|].
  right; right; right. assert (0 <= r * (l * (1 - w))) by (apply Rmult_le_pos; [lra | apply Rmult_le_pos; lra]).
  assert (E1 : r * u' = r * u - r * (l * w)) by (rewrite Eu; ring). lra.
Qed.

Theorem L24_turning_on_R p T e l : motion P p -> no_heavy P p -> turning P p T -> on_R P p T e ->
  NoDup l -> (forall t, In t l -> collision P p t) -> (length l <= 1 + k0 + k1)%nat.
Proof.
  intros Hm Hn [Hc [v [v' [Hb [Ha [Hv Hv']]]]]] HR Hnd Hl. assert (A1 := arm1_pos P HP). assert (HPI := PI2_1).
  destruct (count_split P HP p T l Hm Hnd Hl) as [a [b [La [Lb Hab]]]].
  destruct (collision_law_on_R P HP p T e Hm Hn Hc HR) as [w [w' [Hb' [Ha' HL]]]].
  assert (w = v) by (apply before_unique with p T; assumption).
  assert (w' = v') by (apply after_unique with p T; assumption).
  subst w w'. assert (I0 : 0 <= / arm1 P) by (left; now apply Rinv_0_lt_compat).
  assert (V1 : 0 <= v_of P v') by (unfold v_of, Rdiv; apply Rmult_le_pos; lra).
  assert (V2 : 0 <= - v_of P v).
  { unfold v_of, Rdiv. assert (0 <= - vy v * / arm1 P) by (apply Rmult_le_pos; lra). lra. }
  assert (Hq := reverse_motion P p Hm). assert (Nq := no_heavy_reverse P HP p Hm Hn).
  assert (Haq : after (reverse p) (- T) (minus_v v)) by (apply reverse_after; now rewrite Ropp_involutive).
  assert (HRq : on_R P (reverse p) (- T) e) by (unfold on_R, reverse; rewrite Ropp_involutive; exact HR).
  assert (Eu : u_of (minus_v v) = - u_of v) by reflexivity. assert (Ev := v_of_minus P HP v).
  assert (HL' := HL). destruct HL' as [j [Hj [Ju [Jv [Jr Jn]]]]].
  destruct (L24_ray p T e v' a Hm Hn HR Ha V1 ltac:(lra) La) as [X1 X2].
  destruct (L24_ray (reverse p) (- T) e (minus_v v) b Hq Nq HRq Haq ltac:(lra) ltac:(rewrite Eu, Ev;
    lra) Lb) as [Y1 Y2].
  rewrite Eu, Ev in Y2. assert (W : 0 <= cos e <= 1) by (apply cos_range; destruct HR as [_ [He _]]; lra).
  destruct (L23_one_steep _ _ _ _ _ W HL) as [H|[H|[H|H]]].
  - assert (a <= k1)%nat by tauto. lia.
  - assert (a <= k1)%nat by tauto. lia.
  - assert (b <= k1)%nat by tauto. lia.
  - assert (b <= k1)%nat by (apply Y2; right; lra). lia.
Qed.

Theorem L24_no_heavy p : motion P p -> no_heavy P p -> at_most P p (1 + k0 + k1).
Proof.
  intros Hm Hn [|T l] Hnd Hl; [simpl; lia|].
  destruct (L2c_turning_exists P HP Hr1 p T Hm Hn (Hl T (or_introl eq_refl))) as [t Ht].
  destruct (normal_position P HP p t Hm Hn (proj1 Ht)) as [q [e [S HR]]].
  apply (same_at_most P p q _ S); [|exact Hnd | exact Hl].
  intros l' Hnd' Hl'. apply (L24_turning_on_R q t e l'); try assumption.
  - exact (same_motion P _ _ S Hm).
  - exact (same_no_heavy P _ _ S Hn).
  - destruct Ht as [Hct [v [v' [Hb [Ha Hv]]]]]. split; [now apply (same_collision P _ _ S)|].
    destruct (same_before P _ _ S t v Hb) as [w [Hb2 E1]]. destruct (same_after P _ _ S t v' Ha) as [w' [Ha2 E2]].
    exists w, w'. rewrite E1, E2. repeat split; try assumption; apply Hv.
Qed.
End NoHeavy.
