(** L15 (i), and the whole: the charts of all collision states bound every motion. The first collision is, up to the
    mirror and whole turns, a state of the chart contact or departure, or has none after it.

    full_upper == bounds in the charts contact and departure bound every motion *)
From Coq Require Import Reals Lra Lia List.
From Dumbbell Require Import Statement Physics Ray Chart Flight Collisions Symmetry NormalPosition BridgeChart
  SteepRays TurningCollision Forward FollowFlight.
Import ListNotations.
Local Open Scope R_scope.

Section FullTotal.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.
Hypothesis Hr1 : r_of P <= 1.
Notation r := (r_of P).
Notation yh := (yhat_of P).

(** A list of collisions, not empty, has a first one. *)
Lemma all_later p l : NoDup l -> (forall t, In t l -> collision P p t) -> exists T, later P p T (length l).
Proof.
  intros Hnd Hc. assert (B : exists T, forall t, In t l -> T < t).
  { clear Hnd Hc. induction l as [|s l [T HT]]; [exists 0; intros t [] |].
    exists (Rmin T s - 1). assert (M1 := Rmin_l T s). assert (M2 := Rmin_r T s).
    intros t [<-|Ht]; [lra | specialize (HT t Ht); lra]. }
  destruct B as [T HT]. exists T, l. split; [exact Hnd|]. split; [reflexivity|]. intros t Ht. split; auto.
Qed.

(** A contact with the bridge, to the left. *)
Lemma contact_left U p T v t n : contact_bound r U -> motion P p -> after p T v -> psi_of (p T) = PI/2 - t ->
  0 < t < PI -> yh (p T) = r * sin t -> u_of v < 0 -> 0 < v_of P v + r * cos t * u_of v -> later P p T n ->
  (1 + n <= U)%nat.
Proof.
  intros HB Hm Ha Hp Ht Hy Hu Hn Hl.
  destruct (contact_follow P HP Hr1 p T v t n Hm Ha Hp Ht Hy Hu Hn Hl) as [eta [He [_ G]]]. now apply (HB t eta n).
Qed.
Lemma first_is_heavy U p T n : contact_bound r U -> motion P p -> collision P p T -> y2 P (p T) = 0 -> (1 <= U)%nat ->
  later P p T n -> (1 + n <= U)%nat.
Proof.
  intros HB Hm0 Hc0 H20 HU Hl0. assert (HPI : 0 < PI) by apply PI_RGT_0.
  destruct (heavy_normal_position P HP p T Hm0 H20) as [q [e [S [Hp He]]]].
  assert (Hm := same_motion _ _ _ S Hm0). assert (Hc := same_collision _ _ _ S T Hc0).
  assert (H2 : y2 P (q T) = 0) by (now rewrite (same_y2 _ _ _ S)). assert (Hl := same_later _ _ _ T n S Hl0).
  assert (Hy := contact2 P HP q T H2). assert (Hy' : yh (q T) = r * sin e).
  { rewrite Hy, Hp, cos_minus, cos_PI2, sin_PI2. ring. }
  destruct (heavy_reflection P HP q T e Hm Hc H2 Hp) as [v [v' [Hb [Ha [l [Hj [_ [_ [Er En]]]]]]]]].
  assert (Hup : 0 < v_of P v' + r * cos e * u_of v') by lra.
  destruct (Rtotal_order (u_of v') 0) as [K|[K|K]].
  - apply (contact_left U q T v' e n); try assumption. lra.
  - assert (n = O); [|lia]. apply (L3_steep_no_later P HP Hr1 q T v' n Hm Ha); [|exact Hl].
    rewrite K in *. rewrite Rabs_R0. lra.
  - apply (contact_left U (mirror q) T (mirror_v v') (PI - e) n HB); try lra.
    + now apply mirror_motion.
    + now apply mirror_after.
    + rewrite psi_mirror, Hp. field.
    + rewrite sin_PI_x. exact Hy'.
    + unfold u_of in *; simpl; lra.
    + rewrite cos_mirror. unfold u_of, v_of in *; simpl; lra.
    + now apply later_mirror.
Qed.

(** A collision with R, to the left. *)
Lemma first_is_light U p T n : departure_bound r U -> motion P p -> collision P p T -> y1 P (p T) = 0 ->
  (1 <= U)%nat -> later P p T n -> (1 + n <= U)%nat.
Proof.
  intros HB Hm0 Hc0 H10 HU Hl0. assert (A1 := arm1_pos P HP).
  destruct (cell_position P p T) as [q [S Hcell]].
  assert (Hm := same_motion _ _ _ S Hm0). assert (Hc := same_collision _ _ _ S T Hc0).
  assert (Hl := same_later _ _ _ T n S Hl0).
  assert (N2 : y2 P (q T) <> 0) by (rewrite (same_y2 _ _ _ S); intros H2; apply (regular P p Hm0 T); now split).
  assert (H1 : y1 P (q T) = 0) by (destruct Hc as [w [_ [[H _]|[H _]]]]; [exact H | contradiction]).
  destruct (light_right P HP q T Hm H1 Hcell) as [e HR]. assert (HR' := HR). destruct HR' as [Hp [He Hy]].
  destruct (collision_law P HP q T Hm Hc) as [v [v' [Hb [Ha [[_ HL]|[H2 _]]]]]];
    [|contradiction].
  unfold slope1 in HL. rewrite Hp, sin_plus, sin_PI2, cos_PI2 in HL. destruct HL as [l [_ [_ [_ [Er En]]]]].
  assert (Hup : 0 < v_of P v' - cos e * u_of v') by lra.
  destruct (Rlt_or_le (u_of v') 0) as [K|K].
  - set (k := v_of P v' / - u_of v'). assert (Ek : k * - u_of v' = v_of P v') by (unfold k; field; lra).
    assert (Hk : - cos e < k) by (apply Rmult_lt_reg_r with (- u_of v'); lra).
    apply (HB e (k + cos e) n He); [lra|]. replace (k + cos e - cos e) with k by ring.
    apply (L15_follow P HP Hr1 n q T v' e k Hm); [split; assumption | exact Hl].
  - assert (n = O); [|lia]. exact (L1b_right_no_later P HP Hr1 q T v' e n Hm Ha HR K Hup Hl).
Qed.

(** L15: every motion. *)
Theorem full_bounds_motion U p : contact_bound r U -> departure_bound r U -> motion P p -> at_most P p U.
Proof.
  intros HB HD Hm. assert (HPI : 0 < PI) by apply PI_RGT_0.
  assert (HU : (1 <= U)%nat) by (apply (HB (PI/2) 1 O); [lra | lra | exact I]).
  intros l Hnd Hc. destruct (all_later p l Hnd Hc) as [T0 HT]. destruct (length l) as [|n]; [lia|].
  destruct (later_next P HP p T0 n Hm HT) as [T [_ [HcT [_ Hl]]]].
  assert (K := HcT). destruct K as [v [_ [[H _]|[H _]]]].
  - now apply (first_is_light U p T n).
  - now apply (first_is_heavy U p T n).
Qed.
End FullTotal.

Theorem full_upper q n : 1 <= q -> contact_bound (/ q) n -> departure_bound (/ q) n -> upper_bound q n.
Proof.
  intros Hq HB HD P p HP Hqq Hm.
  assert (E : / q = r_of P) by (unfold r_of; destruct HP as [? [? ?]]; rewrite <- Hqq; field; lra).
  rewrite E in HB, HD. apply full_bounds_motion; try assumption. rewrite <- E, <- Rinv_1. apply Rinv_le_contravar; lra.
Qed.
