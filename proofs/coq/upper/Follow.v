(** F <= G: L1 (b), L4 and L6 (c) for the dumbbell. A flight to the left that clears what lies before the left wall has
    at most as many later collisions as its ray. (That the ray has as many: RayFuture.v.)

    ray P p t v c k          == at the time t the motion flies as the ray (c, k)
    follow_ray               == it has at most the ray's collisions from then on
    next_hit, reflects_hit   == its next collision is the ray's; the velocity after it
    L1b_no_return, past_peak == behind the peak of the hump nothing is met again *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics Ray Flight Collisions Symmetry StartRay.
Import ListNotations.
Local Open Scope R_scope.

Section Follow.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.
Hypothesis Hr1 : r_of P <= 1.
Notation r := (r_of P).
Notation yh := (yhat_of P).
(** L1 (b): from the wall L, not to the right: no later collision. *)
Theorem L1b_no_return p t1 v x : motion P p -> after p t1 v -> psi_of (p t1) = - (PI/2) - x -> 0 <= x <= PI/2 ->
  yh (p t1) = sin x ->
  u_of v <= 0 -> 0 < v_of P v + cos x * u_of v -> forall T, t1 < T -> ~ collision P p T.
Proof.
  intros Hm Ha Hpsi Hx Hy Hu Hn T HT Hc. assert (HPI : 0 < PI) by apply PI_RGT_0. assert (R0 := r_pos P HP).
  destruct (first_collision P HP p t1 T Hm HT Hc) as [t2 [H2 [Hc2 Hf]]].
  assert (L := straight_flight P HP p t1 t2 v Hm Ha ltac:(lra) Hf t2 ltac:(lra)).
  destruct (on_line_coords P HP _ _ _ _ L) as [E1 E2].
  set (X := x - u_of v * (t2 - t1)). assert (EX : psi_of (p t2) = - (PI/2) - X) by (rewrite E1, Hpsi; unfold X; ring).
  assert (X1 : x <= X). { unfold X. assert (0 <= - u_of v * (t2 - t1)) by (apply Rmult_le_pos; lra). lra. }
  assert (Hh : sin x + cos x * (X - x) < yh (p t2)).
  { rewrite E2, Hy. unfold X. assert (0 < (v_of P v + cos x * u_of v) * (t2 - t1)) by (apply Rmult_lt_0_compat; lra).
    lra. }
  assert (W : 0 <= cos x) by (apply cos_ge_0; lra).
  destruct (collision_law P HP p t2 Hm Hc2) as [va [vb [_ [_ [[C _]|[C _]]]]]].
  - apply (contact1 P HP) in C. rewrite EX, cos_left in C. destruct (Rle_or_lt X PI) as [K|K].
    + assert (Tg := sin_below_tangent x X ltac:(lra) ltac:(lra)). lra.
    + assert (Tg := sin_below_tangent x (PI/2) ltac:(lra) ltac:(lra)). rewrite sin_PI2 in Tg.
      assert ((PI/2 - x) * cos x <= (X - x) * cos x) by (apply Rmult_le_compat_r; lra). destruct (SIN_bound X). lra.
  - apply (contact2 P HP) in C. rewrite EX, cos_left in C. destruct (Rle_or_lt X PI) as [K|K].
    + assert (Tg := sin_below_tangent x X ltac:(lra) ltac:(lra)). assert (0 <= sin X) by (apply sin_ge_0; lra).
      assert (0 <= r * sin X) by (apply Rmult_le_pos; lra). lra.
    + assert (Tg := sin_below_tangent x (PI/2) ltac:(lra) ltac:(lra)). rewrite sin_PI2 in Tg.
      assert ((PI/2 - x) * cos x <= (X - x) * cos x) by (apply Rmult_le_compat_r; lra).
      destruct (SIN_bound X). assert (r * - sin X <= r * 1) by (apply Rmult_le_compat_l; lra). lra.
Qed.

(** A ray to the left, over the left corner at height c, with slope k. It clears the bridge, or the
    bridge is never hit. *)
Record ray (p : R -> pos) (t0 : R) (v : vel) (c k : R) : Prop := {
  ray_after : after p t0 v; ray_left : u_of v < 0; ray_slope : k * - u_of v = v_of P v;
  ray_height : c = yh (p t0) + k * (psi_of (p t0) + PI/2); ray_start : - (PI/2) < psi_of (p t0);
  ray_clear : forall z, - (PI/2) <= z < psi_of (p t0) -> - cos z < yh (p t0) + k * (psi_of (p t0) - z) /\
    (r * cos z < yh (p t0) + k * (psi_of (p t0) - z) \/ no_heavy P p);
  ray_below : 0 <= k \/ c + k * (PI/2) < 1 }.

Lemma start_ray_ray p t0 v c k : start_ray P (p t0) v c k -> after p t0 v -> ray p t0 v c k.
Proof.
  intros [Hu Hs Hc Hst Hcl Hb] Ha. split; try assumption. intros z Hz. destruct (Hcl z Hz) as [A B].
  split; [exact A | now left].
Qed.

(** An ascending flight does not collide where it is at least 1 high: only the peaks are as high, and they are flat. *)
Lemma high_no_collision p t v : motion P p -> before p t v -> 0 <= v_of P v -> 1 <= yh (p t) -> ~ collision P p t.
Proof.
  intros Hm Hb Hv Hh Hc. assert (R0 := r_pos P HP). destruct (collision_law P HP p t Hm Hc) as [w [w' [Wb [_ HL]]]].
  assert (w = v) by (apply before_unique with p t; assumption). subst w.
  assert (Flat : sin (psi_of (p t)) = 0 -> False).
  { intros Z. destruct HL as [[_ [l [_ [_ [_ [_ Hn]]]]]]|[_ [l [_ [_ [_ [_ Hn]]]]]]];
      [unfold slope1 in Hn | unfold slope2 in Hn]; rewrite Z in Hn; lra. }
  assert (Peak : cos (psi_of (p t)) * cos (psi_of (p t)) = 1 -> False).
  { intros E. apply Flat. assert (SC := sin2_cos2 (psi_of (p t))). unfold Rsqr in SC.
    assert (Z : sin (psi_of (p t)) * sin (psi_of (p t)) = 0) by lra. apply Rmult_integral in Z. tauto. }
  destruct (COS_bound (psi_of (p t))) as [B1 B2].
  destruct HL as [[C _]|[C _]]; [apply (contact1 P HP) in C | apply (contact2 P HP) in C]; apply Peak.
  - replace (cos (psi_of (p t))) with (-1) by lra. ring.
  - destruct (Rle_or_lt (cos (psi_of (p t))) 0) as [K|K].
    + assert (0 <= r * - cos (psi_of (p t))) by (apply Rmult_le_pos; lra). lra.
    + assert (r * cos (psi_of (p t)) <= 1 * cos (psi_of (p t))) by (apply Rmult_le_compat_r; lra).
      replace (cos (psi_of (p t))) with 1 by lra. ring.
Qed.
(** A flight to the left that passes the peak psi = - pi, and ascends if it was at least 1 high there, does not collide
    behind it. *)
Lemma past_peak p t0 v k t1 : motion P p -> u_of v < 0 -> k * - u_of v = v_of P v -> - PI <= psi_of (p t0) ->
  (1 <= yh (p t0) + k * (psi_of (p t0) + PI) -> 0 <= k) -> (forall s, t0 <= s <= t1 -> on_line p t0 v s) ->
  psi_of (p t1) <= - PI -> t0 < t1 -> ~ collision P p t1.
Proof.
  intros Hm Hu Hs Hst Hup Ln Hpast H01.
  destruct (on_line_coords P HP _ _ _ _ (Ln t1 ltac:(lra))) as [E1 E2].
  set (d := (psi_of (p t0) + PI) / - u_of v). assert (Hd : - u_of v * d = psi_of (p t0) + PI) by (unfold d; field; lra).
  assert (D0 : 0 <= d) by (unfold d; apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; lra]).
  assert (D1 : d <= t1 - t0) by (apply Rmult_le_reg_l with (- u_of v); lra).
  destruct (on_line_coords P HP _ _ _ _ (Ln (t0 + d) ltac:(lra))) as [F1 F2].
  replace (t0 + d - t0) with d in F1, F2 by ring. assert (Fl := floor1 P HP p (t0 + d) Hm).
  replace (psi_of (p (t0 + d))) with (- PI) in Fl by lra. rewrite cos_neg, cos_PI in Fl.
  assert (Fy : yh (p (t0 + d)) = yh (p t0) + k * (psi_of (p t0) + PI)).
  { rewrite F2, <- Hs. replace (k * - u_of v * d) with (k * (- u_of v * d)) by ring. rewrite Hd. ring. }
  assert (Hk : 0 <= k) by (apply Hup; lra).
  assert (Hv : 0 <= v_of P v) by (rewrite <- Hs; apply Rmult_le_pos; lra).
  assert (v_of P v * d <= v_of P v * (t1 - t0)) by (apply Rmult_le_compat_l; lra).
  apply (high_no_collision p t1 v Hm); [|exact Hv | lra].
  destruct (Ln t1 ltac:(lra)) as [Q1 Q2]. exists (t1 - t0). split; [lra|]. intros s Hs'.
  destruct (Ln s ltac:(lra)). split; lra.
Qed.

(** L4 (a) for the motion. *)
Theorem next_hit p t0 v c k t1 : motion P p -> ray p t0 v c k -> t0 < t1 -> collision P p t1 ->
  (forall t, t0 < t < t1 -> ~ collision P p t) ->
  exists x, 0 < x /\ hit c k x /\ psi_of (p t1) = - (PI/2) - x /\ yh (p t1) = sin x /\
  exists v', after p t1 v' /\ reflects P (- cos x) (u_of v) (v_of P v) (u_of v') (v_of P v').
Proof.
  intros Hm HR H01 Hc Hf. assert (HPI : 0 < PI) by apply PI_RGT_0. assert (R0 := r_pos P HP).
  assert (Ln := straight_flight P HP p t0 t1 v Hm (ray_after _ _ _ _ _ HR) H01 Hf).
  destruct (on_line_coords P HP _ _ _ _ (Ln t1 ltac:(lra))) as [E1 E2].
  destruct (collision_law P HP p t1 Hm Hc) as [va [v' [Hb [Ha' HL]]]].
  destruct (on_line_until p t0 t1 v va H01) as [-> _]; [intros s Hs; apply Ln; lra | exact Hb |].
  set (X := - (PI/2) - psi_of (p t1)). assert (EX : psi_of (p t1) = - (PI/2) - X) by (unfold X; ring).
  destruct (Rle_or_lt (PI/2) X) as [K2|K2].
  { exfalso. destruct HR as [_ Hu Hs Hc0 Hst _ Hbl]. apply (past_peak p t0 v k t1); try assumption; [lra | | lra].
    intros K. replace (k * (psi_of (p t0) + PI)) with (k * (psi_of (p t0) + PI/2) + k * (PI/2)) in K by field.
    destruct Hbl; lra. }
  destruct HR as [_ Hu Hs Hc0 Hst Hcl _].
  assert (EY : yh (p t1) = c + k * X). { rewrite E2, Hc0, <- Hs. unfold X. rewrite E1. ring. }
  assert (Hpos : 0 < - u_of v * (t1 - t0)) by (apply Rmult_lt_0_compat; lra).
  destruct (Rle_or_lt X 0) as [K|K].
  { exfalso. destruct (Hcl (psi_of (p t1)) ltac:(lra)) as [K1 K3].
    assert (EZ : yh (p t0) + k * (psi_of (p t0) - psi_of (p t1)) = yh (p t1)) by (rewrite EY, Hc0, EX; ring).
    destruct HL as [[C _]|[C _]]; [apply (contact1 P HP) in C; lra|].
    destruct K3 as [K3|K3]; [apply (contact2 P HP) in C; lra | exact (K3 t1 Hc C)]. }
  destruct HL as [[C HR]|[C HR]].
  - apply (contact1 P HP) in C. rewrite EX, cos_left in C. exists X. split; [exact K|].
    unfold slope1 in HR. rewrite EX, sin_left in HR. split; [|split; [exact EX | split; [lra | now exists v']]].
    split; [lra|]. split; [lra|]. destruct HR as [l [_ [_ [_ [_ Hn]]]]]. rewrite <- Hs in Hn.
    apply Rmult_lt_reg_r with (- u_of v); lra.
  - exfalso. apply (contact2 P HP) in C. rewrite EX, cos_left in C. assert (F := floor1 P HP p t1 Hm).
    rewrite EX, cos_left in F. assert (0 < sin X) by (apply sin_gt_0; lra).
    assert (0 < r * sin X) by (now apply Rmult_lt_0_compat). lra.
Qed.

(** F <= G: what a flight does later, its ray does. *)
Lemma reflects_hit p t1 v v' c k x : hit c k x -> u_of v < 0 -> k * - u_of v = v_of P v ->
  reflects P (- cos x) (u_of v) (v_of P v) (u_of v') (v_of P v') -> after p t1 v' -> motion P p ->
  psi_of (p t1) = - (PI/2) - x -> yh (p t1) = sin x -> 0 < x ->
  (exists T, t1 < T /\ collision P p T) ->
  0 < slope_den (cos x) k r /\ 0 < u_of v' /\ next_slope (cos x) k r * u_of v' = v_of P v'.
Proof.
  intros Hx Hu Hs HR Ha' Hm Hpsi Hy Hx0 [T [HT HcT]]. assert (R0 := r_pos P HP). destruct Hx as [X1 [X2 X3]].
  destruct (reflected_velocity P HP x k v v' Hu Hs HR) as [Bu [Bv Bn]].
  assert (Q : 0 < cos x * cos x + r) by (assert (0 <= cos x * cos x) by apply Rle_0_sqr; lra).
  assert (HD : 0 < slope_den (cos x) k r).
  { apply Rnot_le_lt. intros K. apply (L1b_no_return p t1 v' x Hm Ha' Hpsi ltac:(lra) Hy) with (T := T); try assumption.
    rewrite Bu. assert (0 <= - u_of v * (- slope_den (cos x) k r * / (cos x * cos x + r))).
    { apply Rmult_le_pos; [lra|]. apply Rmult_le_pos; [lra | left; now apply Rinv_0_lt_compat]. }
    unfold Rdiv. lra. }
  split; [exact HD|]. split.
  - rewrite Bu. apply Rmult_lt_0_compat; [lra | now apply Rdiv_lt_0_compat].
  - rewrite Bu, Bv. unfold next_slope. field. lra.
Qed.
Theorem follow_ray n : forall p t0 v c k, motion P p -> ray p t0 v c k -> 0 <= c -> - r <= k -> later P p t0 n ->
  coll r n c k.
Proof.
  induction n as [|n IH]; [easy|]. intros p t0 v c k Hm Hray Hc Hk Hl. assert (R0 := r_pos P HP).
  destruct (later_next P HP p t0 n Hm Hl) as [t1 [H01 [Hc1 [Hf Hl1]]]].
  destruct (next_hit p t0 v c k t1 Hm Hray H01 Hc1 Hf) as [x [Hx0 [Hx [Hpsi [Hy [v' [Ha' HR]]]]]]].
  exists x. split; [exact Hx|]. destruct n as [|n]; [now left|right].
  destruct (later_next P HP p t1 n Hm Hl1) as [t2 [H12 [Hc2 _]]].
  destruct (reflects_hit p t1 v v' c k x) as [HD [Hup Hkk]]; try assumption.
  { exact (ray_left _ _ _ _ _ Hray). } { exact (ray_slope _ _ _ _ _ Hray). } { now exists t2. }
  split; [exact HD|]. destruct (next_domain c k r x R0 Hk Hx HD) as [Q1 Q2]. set (k' := next_slope (cos x) k r) in *.
  simpl. apply (IH (mirror p) t1 (mirror_v v')); try lra.
  - now apply mirror_motion.
  - apply start_ray_ray; [|now apply mirror_after]. destruct Hx as [X1 _].
    apply (next_start_ray P HP (p t1)); try assumption. lra.
  - now apply later_mirror.
Qed.
Corollary follow_start n p t0 v c k : motion P p -> start_ray P (p t0) v c k -> after p t0 v -> - r <= k ->
  later P p t0 n -> coll r n c k.
Proof.
  intros Hm S Ha Hk. apply (follow_ray n p t0 v c k Hm); [now apply start_ray_ray | | exact Hk]. left.
  exact (start_ray_height_pos P _ _ _ _ S).
Qed.
End Follow.
