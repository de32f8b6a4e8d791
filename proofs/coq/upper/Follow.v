(** L1 (b), L4, L6 (c) for the physical dumbbell: a flight to the left that clears what lies before the left wall has as
    many later collisions as its ray: F <= G. *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics Ray Flight Collisions.
Import ListNotations.
Local Open Scope R_scope.

Section Follow.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.
Hypothesis Hr1 : r_of P <= 1.
Notation r := (r_of P).
Definition later p t0 n := exists l, NoDup l /\ length l = n /\ forall t, In t l -> t0 < t /\ collision P p t.

Lemma later_next p t0 n : motion P p -> later p t0 (S n) -> exists t1, t0 < t1 /\ collision P p t1 /\ (forall t, t0 < t < t1 -> ~ collision P p t) /\ later p t1 n.
Proof.
  intros Hm [l [Hnd [Hl Hc]]]. destruct l as [|T l']; [discriminate|].
  destruct (Hc T (or_introl eq_refl)) as [HT HcT]. destruct (first_collision P HP p t0 T Hm HT HcT) as [t1 [H1 [H2 H3]]].
  exists t1. split; [lra|]. split; [exact H2|]. split; [exact H3|].
  assert (Hge : forall t, In t (T :: l') -> t1 <= t).
  { intros t Ht. destruct (Rle_or_lt t1 t) as [|K]; [assumption|]. destruct (Hc t Ht). exfalso. apply (H3 t); [lra | assumption]. }
  destruct (in_dec Req_EM_T t1 (T :: l')) as [Hin|Hin].
  - apply in_split in Hin. destruct Hin as [a [b E]]. rewrite E in *. exists (a ++ b).
    split; [now apply NoDup_remove_1 in Hnd|]. split. { rewrite app_length in *. simpl in Hl. lia. }
    intros t Ht. assert (Ht' : In t (a ++ t1 :: b)) by (apply in_app_iff in Ht; apply in_app_iff; destruct Ht; [now left | right; now right]).
    split; [|now apply Hc]. assert (t1 <> t) by (intros <-; apply NoDup_remove_2 in Hnd; contradiction). specialize (Hge t Ht'). lra.
  - exists l'. inversion Hnd; subst. split; [assumption|]. split; [now injection Hl|].
    intros t Ht. assert (Ht' : In t (T :: l')) by now right. split; [|now apply Hc].
    assert (t1 <> t) by (intros <-; contradiction). specialize (Hge t Ht'). lra.
Qed.

Notation yh := (yhat_of P).
Lemma on_line_coords (p : R -> pos) t0 v s : on_line p t0 v s -> psi_of (p s) = psi_of (p t0) + u_of v * (s - t0) /\ yh (p s) = yh (p t0) + v_of P v * (s - t0).
Proof. intros [A B]. assert (A1 := arm1_pos P HP). unfold psi_of, yhat_of, u_of, v_of. rewrite A, B. split; [ring | field; lra]. Qed.
Lemma floor1 (p : R -> pos) t : motion P p -> - cos (psi_of (p t)) <= yh (p t).
Proof. intros Hm. assert (A := above1 P p Hm t). assert (A1 := arm1_pos P HP). destruct (L0_heights P (p t) HP) as [E _]. rewrite E in A.
  assert (0 <= yh (p t) + cos (psi_of (p t))) by (apply Rmult_le_reg_l with (arm1 P); lra). lra. Qed.
Lemma contact1 (p : R -> pos) t : y1 P (p t) = 0 -> yh (p t) = - cos (psi_of (p t)).
Proof. intros A. assert (A1 := arm1_pos P HP). destruct (L0_heights P (p t) HP) as [E _]. rewrite E in A. apply Rmult_integral in A. lra. Qed.
Lemma contact2 (p : R -> pos) t : y2 P (p t) = 0 -> yh (p t) = r * cos (psi_of (p t)).
Proof. intros A. assert (A1 := arm1_pos P HP). destruct (L0_heights P (p t) HP) as [_ E]. rewrite E in A. apply Rmult_integral in A. unfold r_of. lra. Qed.
Lemma cos_left X : cos (- (PI/2) - X) = - sin X.
Proof. rewrite cos_minus, cos_neg, sin_neg, cos_PI2, sin_PI2. ring. Qed.
Lemma sin_left X : sin (- (PI/2) - X) = - cos X.
Proof. rewrite sin_minus, cos_neg, sin_neg, cos_PI2, sin_PI2. ring. Qed.

(** L1 (b): from the wall L, not to the right: no later collision. *)
Theorem L1b_no_return p t1 v x : motion P p -> after p t1 v -> psi_of (p t1) = - (PI/2) - x -> 0 <= x <= PI/2 -> yh (p t1) = sin x ->
  u_of v <= 0 -> 0 < v_of P v + cos x * u_of v -> forall T, t1 < T -> ~ collision P p T.
Proof.
  intros Hm Ha Hpsi Hx Hy Hu Hn T HT Hc. assert (HPI : 0 < PI) by apply PI_RGT_0. assert (R0 := r_pos P HP).
  destruct (first_collision P HP p t1 T Hm HT Hc) as [t2 [H2 [Hc2 Hf]]].
  assert (L := straight_flight P HP p t1 t2 v Hm Ha ltac:(lra) Hf t2 ltac:(lra)). destruct (on_line_coords _ _ _ _ L) as [E1 E2].
  set (X := x - u_of v * (t2 - t1)). assert (EX : psi_of (p t2) = - (PI/2) - X) by (rewrite E1, Hpsi; unfold X; ring).
  assert (X1 : x <= X). { unfold X. assert (0 <= - u_of v * (t2 - t1)) by (apply Rmult_le_pos; lra). lra. }
  assert (Hh : sin x + cos x * (X - x) < yh (p t2)).
  { rewrite E2, Hy. unfold X. assert (0 < (v_of P v + cos x * u_of v) * (t2 - t1)) by (apply Rmult_lt_0_compat; lra). lra. }
  assert (W : 0 <= cos x) by (apply cos_ge_0; lra).
  destruct (collision_law P HP p t2 Hm Hc2) as [va [vb [_ [_ [[C _]|[C _]]]]]].
  - apply contact1 in C. rewrite EX, cos_left in C. destruct (Rle_or_lt X PI) as [K|K].
    + assert (Tg := sin_below_tangent x X ltac:(lra) ltac:(lra)). lra.
    + assert (Tg := sin_below_tangent x (PI/2) ltac:(lra) ltac:(lra)). rewrite sin_PI2 in Tg. assert ((PI/2 - x) * cos x <= (X - x) * cos x) by (apply Rmult_le_compat_r; lra). destruct (SIN_bound X). lra.
  - apply contact2 in C. rewrite EX, cos_left in C. destruct (Rle_or_lt X PI) as [K|K].
    + assert (Tg := sin_below_tangent x X ltac:(lra) ltac:(lra)). assert (0 <= sin X) by (apply sin_ge_0; lra). assert (0 <= r * sin X) by (apply Rmult_le_pos; lra). lra.
    + assert (Tg := sin_below_tangent x (PI/2) ltac:(lra) ltac:(lra)). rewrite sin_PI2 in Tg. assert ((PI/2 - x) * cos x <= (X - x) * cos x) by (apply Rmult_le_compat_r; lra).
      destruct (SIN_bound X). assert (r * - sin X <= r * 1) by (apply Rmult_le_compat_l; lra). lra.
Qed.

(** No collision is with the heavy mass. *)
Definition no_heavy p := forall t, collision P p t -> y2 P (p t) <> 0.

(** A ray to the left, over the left corner at height c, with slope k. It clears the bridge, or the bridge is never hit. *)
Record ray (p : R -> pos) (t0 : R) (v : vel) (c k : R) : Prop := {
  ray_after : after p t0 v; ray_left : u_of v < 0; ray_slope : k * - u_of v = v_of P v;
  ray_height : c = yh (p t0) + k * (psi_of (p t0) + PI/2); ray_start : - (PI/2) < psi_of (p t0);
  ray_clear : forall z, - (PI/2) <= z < psi_of (p t0) -> - cos z < yh (p t0) + k * (psi_of (p t0) - z) /\
    (r * cos z < yh (p t0) + k * (psi_of (p t0) - z) \/ no_heavy p);
  ray_below : 0 <= k \/ c + k * (PI/2) < 1 }.

(** L4 (a) for the motion. *)
Theorem next_hit p t0 v c k t1 : motion P p -> ray p t0 v c k -> t0 < t1 -> collision P p t1 -> (forall t, t0 < t < t1 -> ~ collision P p t) ->
  exists x, 0 < x /\ hit c k x /\ psi_of (p t1) = - (PI/2) - x /\ yh (p t1) = sin x /\
  exists v', after p t1 v' /\ reflects P (- cos x) (u_of v) (v_of P v) (u_of v') (v_of P v').
Proof.
  intros Hm [Ha Hu Hs Hc0 Hst Hcl Hbl] H01 Hc Hf. assert (HPI : 0 < PI) by apply PI_RGT_0. assert (R0 := r_pos P HP).
  assert (Ln := straight_flight P HP p t0 t1 v Hm Ha H01 Hf). destruct (on_line_coords _ _ _ _ (Ln t1 ltac:(lra))) as [E1 E2].
  destruct (collision_law P HP p t1 Hm Hc) as [va [v' [Hb [Ha' HL]]]].
  assert (va = v).
  { apply before_unique with p t1; [exact Hb|]. destruct (Ln t1 ltac:(lra)) as [Q1 Q2]. exists (t1 - t0). split; [lra|]. intros s Hs'. destruct (Ln s ltac:(lra)). split; lra. }
  subst va. set (X := - (PI/2) - psi_of (p t1)). assert (EX : psi_of (p t1) = - (PI/2) - X) by (unfold X; ring).
  assert (EY : yh (p t1) = c + k * X). { rewrite E2, Hc0, <- Hs. unfold X. rewrite E1. ring. }
  assert (Hup : - u_of v * (t1 - t0) = psi_of (p t0) + PI/2 + X) by (unfold X; rewrite E1; ring).
  assert (Hpos : 0 < - u_of v * (t1 - t0)) by (apply Rmult_lt_0_compat; lra).
  destruct (Rle_or_lt X 0) as [K|K].
  { exfalso. destruct (Hcl (psi_of (p t1)) ltac:(lra)) as [K1 K2].
    assert (EZ : yh (p t0) + k * (psi_of (p t0) - psi_of (p t1)) = yh (p t1)) by (rewrite EY, Hc0, EX; ring).
    destruct HL as [[C _]|[C _]]; [apply contact1 in C; lra|]. destruct K2 as [K2|K2]; [apply contact2 in C; lra | exact (K2 t1 Hc C)]. }
  destruct (Rlt_or_le X (PI/2)) as [K2|K2].
  - destruct HL as [[C HR]|[C HR]].
    + apply contact1 in C. rewrite EX, cos_left in C. exists X. split; [exact K|].
      assert (HR' := HR). unfold slope1 in HR'. rewrite EX, sin_left in HR'.
      split; [|split; [exact EX | split; [lra|]]].
      * split; [lra|]. split; [lra|]. destruct HR' as [l [_ [_ [_ [_ Hn]]]]]. rewrite <- Hs in Hn.
        assert ((cos X - k) * - u_of v > 0) by lra. apply Rmult_lt_reg_r with (- u_of v); lra.
      * exists v'. split; assumption.
    + exfalso. apply contact2 in C. rewrite EX, cos_left in C. assert (F := floor1 p t1 Hm). rewrite EX, cos_left in F.
      assert (0 < sin X) by (apply sin_gt_0; lra). assert (0 < r * sin X) by (now apply Rmult_lt_0_compat). lra.
  - exfalso.
    (* at the peak psi = -pi the flight is at least 1 high *)
    set (tp := t0 + (psi_of (p t0) + PI) / - u_of v).
    assert (Htp : tp - t0 = (psi_of (p t0) + PI) / - u_of v) by (unfold tp; ring).
    assert (Htp2 : - u_of v * (tp - t0) = psi_of (p t0) + PI) by (rewrite Htp; field; lra).
    assert (T1 : t0 <= tp). { assert (0 <= (psi_of (p t0) + PI) / - u_of v) by (apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; lra]). lra. }
    assert (T2 : tp <= t1). { apply Rmult_le_reg_l with (- u_of v); [lra|]. lra. }
    destruct (on_line_coords _ _ _ _ (Ln tp ltac:(lra))) as [F1 F2].
    assert (Fp : psi_of (p tp) = - PI) by (rewrite F1; lra). assert (Fl := floor1 p tp Hm). rewrite Fp, cos_neg, cos_PI in Fl.
    assert (Fy : yh (p tp) = c + k * (PI/2)). { rewrite F2, Hc0, <- Hs. replace (k * - u_of v * (tp - t0)) with (k * (- u_of v * (tp - t0))) by ring. rewrite Htp2. field. }
    assert (Hk : 0 <= k) by (destruct Hbl; lra).
    assert (Hhigh : 1 <= yh (p t1)). { rewrite EY. assert (k * (PI/2) <= k * X) by (apply Rmult_le_compat_l; lra). lra. }
    assert (Hv : 0 <= v_of P v) by (rewrite <- Hs; apply Rmult_le_pos; lra).
    assert (Flat : sin (psi_of (p t1)) = 0 -> False).
    { intros Z. destruct HL as [[_ [l [_ [_ [_ [_ Hn]]]]]]|[_ [l [_ [_ [_ [_ Hn]]]]]]]; [unfold slope1 in Hn | unfold slope2 in Hn]; rewrite Z in Hn; lra. }
    assert (SC := sin2_cos2 (psi_of (p t1))). unfold Rsqr in SC. destruct (COS_bound (psi_of (p t1))) as [B1 B2].
    destruct HL as [[C _]|[C _]]; [apply contact1 in C | apply contact2 in C]; apply Flat.
    + assert (cos (psi_of (p t1)) = -1) by lra. assert (sin (psi_of (p t1)) * sin (psi_of (p t1)) = 0) by nra. apply Rmult_integral in H0. tauto.
    + assert (r * cos (psi_of (p t1)) <= 1 * cos (psi_of (p t1)) \/ cos (psi_of (p t1)) <= 0). { destruct (Rle_or_lt (cos (psi_of (p t1))) 0); [now right | left; apply Rmult_le_compat_r; lra]. }
      destruct H as [H|H]; [|assert (0 <= r * - cos (psi_of (p t1))) by (apply Rmult_le_pos; lra); lra].
      assert (cos (psi_of (p t1)) = 1) by lra. assert (sin (psi_of (p t1)) * sin (psi_of (p t1)) = 0) by nra. apply Rmult_integral in H1. tauto.
Qed.

(** F <= G: what a flight does later, its ray does. *)
Lemma psi_mirror (p : R -> pos) t : psi_of (mirror p t) = - psi_of (p t).
Proof. unfold psi_of, mirror; simpl. lra. Qed.
Lemma collision_mirror p t : collision P p t -> collision P (mirror p) t.
Proof.
  intros [v [Hb H]]. exists (mirror_v v). split; [now apply mirror_before|]. unfold y1, y2, w1, w2, mirror in *; simpl. rewrite sin_mirror, cos_mirror.
  destruct H as [[A B]|[A B]]; [left | right]; (split; [lra|]); lra.
Qed.
Theorem follow_ray n : forall p t0 v c k, motion P p -> ray p t0 v c k -> 0 <= c -> - r <= k -> later p t0 n -> coll r n c k.
Proof.
  induction n as [|n IH]; [easy|]. intros p t0 v c k Hm Hray Hc Hk Hl. assert (HPI : 0 < PI) by apply PI_RGT_0. assert (R0 := r_pos P HP).
  destruct (later_next p t0 n Hm Hl) as [t1 [H01 [Hc1 [Hf Hl1]]]].
  destruct (next_hit p t0 v c k t1 Hm Hray H01 Hc1 Hf) as [x [Hx0 [Hx [Hpsi [Hy [v' [Ha' HR]]]]]]].
  exists x. split; [exact Hx|]. destruct n as [|n]; [now left|right].
  assert (Hxx := Hx). destruct Hxx as [X1 [X2 X3]]. assert (W := cos_pos x X1).
  assert (Hu := ray_left _ _ _ _ _ Hray). assert (Hs := ray_slope _ _ _ _ _ Hray).
  (* speed 1 towards the wall, mirrored *)
  set (g := - u_of v) in *. assert (Hg : 0 < g) by (unfold g; lra).
  destruct HR as [l [Hl0 [Hu' [Hv' [Hrev Hin]]]]].
  assert (Hw2 : 0 < cos x * cos x + r) by (assert (0 < cos x * cos x) by (now apply Rmult_lt_0_compat); lra).
  assert (El : l = 2 * g * (cos x - k) / (cos x * cos x + r)).
  { apply Rmult_eq_reg_r with (cos x * cos x + r); [|lra]. replace (2 * g * (cos x - k) / (cos x * cos x + r) * (cos x * cos x + r)) with (2 * g * (cos x - k)) by (field; lra).
    rewrite Hu', Hv', <- Hs in Hrev. unfold g in *. lra. }
  assert (Eu : u_of v' = g * slope_den (cos x) k r / (cos x * cos x + r)). { rewrite Hu', El. replace (u_of v) with (- g) by (unfold g; ring). unfold slope_den. field. lra. }
  assert (Ev : v_of P v' = g * slope_num (cos x) k r / (cos x * cos x + r)). { rewrite Hv', El, <- Hs. unfold slope_num. field. lra. }
  assert (HD : 0 < slope_den (cos x) k r).
  { destruct (Rlt_or_le 0 (slope_den (cos x) k r)) as [|K]; [assumption|exfalso].
    destruct (later_next p t1 n Hm Hl1) as [t2 [H12 [Hc2 _]]].
    apply (L1b_no_return p t1 v' x Hm Ha' Hpsi ltac:(lra) Hy) with (T := t2); try assumption.
    - rewrite Eu. assert (0 <= g * - slope_den (cos x) k r * / (cos x * cos x + r)) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra | left; now apply Rinv_0_lt_compat]). unfold Rdiv. lra.
    - lra. }
  split; [exact HD|]. destruct (next_domain c k r x R0 Hk Hx HD) as [Q1 Q2]. set (k' := next_slope (cos x) k r) in *.
  assert (Sx : 0 < sin x) by (apply sin_gt_0; lra).
  assert (Hup : 0 < u_of v'). { rewrite Eu. apply Rdiv_lt_0_compat; [now apply Rmult_lt_0_compat | assumption]. }
  assert (Hkk : k' * u_of v' = v_of P v'). { rewrite Eu, Ev. unfold k', next_slope. field. lra. }
  simpl. apply (IH (mirror p) t1 (mirror_v v')); try lra.
  - now apply mirror_motion.
  - assert (EP : psi_of (mirror p t1) = PI/2 + x) by (rewrite psi_mirror, Hpsi; lra).
    assert (EYm : yh (mirror p t1) = sin x) by exact Hy.
    split; rewrite ?EP, ?EYm.
    + now apply mirror_after.
    + unfold u_of, mirror_v in *; simpl. lra.
    + unfold u_of, v_of, mirror_v in *; simpl. lra.
    + lra.
    + lra.
    + intros z Hz. destruct (Rle_or_lt z (PI/2)) as [Kz|Kz].
      * assert (Hk2 : r * (PI/2 + x - z) <= k' * (PI/2 + x - z)) by (apply Rmult_le_compat_r; lra).
        assert (0 <= cos z) by (apply cos_ge_0; lra).
        assert (cos z <= PI/2 - z). { replace (cos z) with (sin (PI/2 - z)) by (rewrite sin_minus, cos_PI2, sin_PI2; ring). destruct (Req_dec z (PI/2)) as [->|]; [replace (PI/2 - PI/2) with 0 by ring; rewrite sin_0; lra | left; apply sin_lt_x; lra]. }
        assert (r * cos z <= r * (PI/2 - z)) by (apply Rmult_le_compat_l; lra). assert (0 <= r * x) by (apply Rmult_le_pos; lra). 
        assert (0 <= r * (PI/2 + x - z)) by (apply Rmult_le_pos; lra). split; [lra | left; lra].
      * set (z' := z - PI/2). assert (Ez : z = PI/2 + z') by (unfold z'; ring). assert (Hz' : 0 < z' < x) by (unfold z'; lra).
        assert (Cz : cos z = - sin z') by (rewrite Ez, cos_plus, cos_PI2, sin_PI2; ring). rewrite Cz.
        assert (sin z' <= sin x) by (apply sin_mono; lra). assert (0 < sin z') by (apply sin_gt_0; lra).
        assert (0 < k' * (PI/2 + x - z)) by (apply Rmult_lt_0_compat; lra). assert (0 <= r * sin z') by (apply Rmult_le_pos; lra). split; [lra | left; lra].
    + left. lra.
  - destruct Hl1 as [ls [N1 [N2 N3]]]. exists ls. split; [exact N1|]. split; [exact N2|]. intros t Ht. destruct (N3 t Ht). split; [assumption | now apply collision_mirror].
Qed.
End Follow.
