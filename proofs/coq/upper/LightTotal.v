(** L9, first part, for the dumbbell: a motion in which the heavy mass never hits the floor has at most as many
    collisions as the chart light allows, counted around a turning collision. With HeavyTotal.v: the charts bound every
    motion, part (a) of the theorem of lemmas.md.

    charts_upper == bounds in the charts bridge and light bound every motion *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics Chart Flight Collisions Symmetry NormalPosition Follow SteepRays HeavyTotal
  TurningCollision.
Local Open Scope R_scope.

Section Light.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.
Hypothesis Hr1 : r_of P <= 1.
Notation r := (r_of P).
Notation yh := (yhat_of P).

(** L9 (c): a flight to the left from R that the heavy mass never interrupts stays above the bridge. *)
Lemma L9c_above_bridge p T e v k : motion P p -> no_heavy P p -> on_R P p T e -> after p T v -> u_of v < 0 ->
  k * - u_of v = v_of P v -> 0 <= k -> above_bridge r e k.
Proof.
  intros Hm Hn [Hp [He Hy]] Ha Hu Hk Hk0 t Ht. assert (HPI : 0 < PI) by apply PI_RGT_0. set (g := - u_of v) in *.
  assert (G0 : 0 < g) by (unfold g; lra). set (d := (e + t) / g). assert (D0 : 0 < d) by (apply Rdiv_lt_0_compat; lra).
  assert (Dg : g * d = e + t) by (unfold d; field; lra).
  assert (At : forall s, on_line p T v s ->
    psi_of (p s) = PI/2 + e - g * (s - T) /\ yh (p s) = sin e + k * (g * (s - T))).
  { intros s Hs. destruct (on_line_coords P HP p T v s Hs) as [A B]. rewrite A, B, Hp, Hy, <- Hk. unfold g.
    split; ring. }
  assert (Free : forall s, T < s < T + d -> ~ collision P p s).
  { intros s Hs Hc. destruct (first_collision P HP p T s Hm ltac:(lra) Hc) as [t1 [H1 [Hc1 Hf]]].
    destruct (At t1) as [A B]; [apply (straight_flight P HP p T t1 v Hm Ha); [lra | exact Hf | lra]|].
    set (z := g * (t1 - T)) in *. assert (Z : 0 < z < e + t).
    { unfold z. split; [apply Rmult_lt_0_compat; lra|]. rewrite <- Dg. apply Rmult_lt_compat_l; lra. }
    assert (Kz : 0 <= k * z) by (apply Rmult_le_pos; lra). assert (Se : 0 < sin e) by (apply sin_gt_0; lra).
    assert (Hno := Hn t1 Hc1). destruct Hc1 as [w [_ [[H0 _]|[H0 _]]]]; [|contradiction].
    apply (contact1 P HP) in H0. rewrite A, B in H0. destruct (Rle_or_lt e z) as [Q|Q].
    - assert (0 <= cos (PI/2 + e - z)) by (apply cos_ge_0; lra). lra.
    - replace (PI/2 + e - z) with (PI/2 + (e - z)) in H0 by ring. rewrite cos_plus, cos_PI2, sin_PI2 in H0.
      assert (sin (e - z) < sin e) by (apply sin_increasing_1; lra). lra. }
  destruct (At (T + d)) as [A B]; [apply (straight_flight P HP p T (T + d) v Hm Ha); [lra | exact Free | lra]|].
  replace (g * (T + d - T)) with (e + t) in A, B by (rewrite <- Dg; ring).
  assert (F := above2 P p Hm (T + d)). assert (A1 := arm1_pos P HP).
  destruct (L0_heights P (p (T + d)) HP) as [_ E]. rewrite E, A, B in F.
  replace (PI/2 + e - (e + t)) with (PI/2 - t) in F by ring. rewrite cos_minus, cos_PI2, sin_PI2 in F. unfold r_of.
  assert (0 <= sin e + k * (e + t) - m1 P / m2 P * (0 * cos t + 1 * sin t)); [|lra].
  apply Rmult_le_reg_l with (arm1 P); lra.
Qed.

(** L9: a turning collision on R whose outgoing ray X goes left with a slope below 1. *)
Theorem L9_turning_left U p T e v v' a b : light_bound r U -> motion P p -> no_heavy P p -> on_R P p T e ->
  before p T v -> after p T v' -> reflects P (cos e) (u_of v) (v_of P v) (u_of v') (v_of P v') ->
  v_of P v <= 0 <= v_of P v' -> u_of v' < 0 -> v_of P v' < - u_of v' ->
  later P p T a -> later P (reverse p) (- T) b -> (1 + a + b <= U)%nat.
Proof.
  intros HB Hm Hn HR Hb Ha [l [Hl [Eu [Ev [Er En]]]]] Hv Hu Hlt La Lb.
  assert (R0 := r_pos P HP). assert (HPI : 0 < PI) by apply PI_RGT_0. assert (HR' := HR). destruct HR' as [Hp [He Hy]].
  destruct (cos_range e ltac:(lra)) as [W0 W1]. assert (Se : 0 < sin e) by (apply sin_gt_0; lra). set (w := cos e) in *.
  set (g := - u_of v') in *. assert (G0 : 0 < g) by (unfold g; lra).
  set (k := v_of P v' / g). assert (Ek : k * g = v_of P v') by (unfold k; field; lra).
  assert (Hk : 0 <= k) by (unfold k; apply Rmult_le_pos; [lra | left; now apply Rinv_0_lt_compat]).
  assert (Hk1 : k < 1) by (apply Rmult_lt_reg_r with g; lra).
  set (lam := k / r). assert (Elam : r * lam = k) by (unfold lam; field; lra).
  assert (Hlam : 0 <= lam) by (unfold lam; apply Rmult_le_pos; [lra | left; now apply Rinv_0_lt_compat]).
  assert (Q : 0 < w * w + r) by (assert (0 <= w * w) by apply Rle_0_sqr; lra).
  assert (El : l = 2 * g * (w + k) / (w * w + r)).
  { apply Rmult_eq_reg_r with (w * w + r); [|lra].
    replace (2 * g * (w + k) / (w * w + r) * (w * w + r)) with (2 * g * (w + k)) by (field; lra).
    assert (A1 : u_of v = - g + l * w) by (unfold g; lra). assert (A2 : v_of P v = k * g - l * r) by lra.
    rewrite A1, A2, <- Ek in Er. unfold g in *. lra. }
  (* sigma X *)
  assert (Hq := reverse_motion P p Hm). assert (Nq := no_heavy_reverse P HP p Hm Hn).
  assert (Haq : after (reverse p) (- T) (minus_v v)) by (apply reverse_after; now rewrite Ropp_involutive).
  assert (HRq : on_R P (reverse p) (- T) e) by (unfold on_R, reverse; rewrite Ropp_involutive; exact HR).
  assert (Euq : u_of (minus_v v) = - u_of v) by reflexivity. assert (Evq := v_of_minus P HP v).
  assert (Du : - u_of v = - (g * (mu_den w lam r / (w * w + r)))).
  { replace (u_of v) with (- g + l * w) by (unfold g; lra). rewrite El. unfold mu_den. rewrite Elam. field. lra. }
  assert (Dv : - v_of P v = g * r * ((2 * w + r * lam - lam * (w * w)) / (w * w + r))).
  { replace (v_of P v) with (k * g - l * r) by lra. rewrite El. rewrite <- Elam at 1 2. field. lra. }
  assert (HPn : 0 <= 2 * w + r * lam - lam * (w * w)).
  { assert (K : 0 <= g * r * ((2 * w + r * lam - lam * (w * w)) / (w * w + r))) by lra.
    assert (Gr : 0 < g * r) by (now apply Rmult_lt_0_compat).
    apply Rmult_le_reg_l with (g * r); [exact Gr|]. apply Rmult_le_reg_r with (/ (w * w + r));
      [now apply Rinv_0_lt_compat|]. unfold Rdiv in K. lra. }
  apply (HB e lam a b He Hlam); rewrite ?Elam; fold w; try assumption.
  - rewrite <- Elam at 1. exact HPn.
  - now apply (L9c_above_bridge p T e v').
  - intros HD. assert (Hd : 0 < g * (mu_den w lam r / (w * w + r)))
      by (apply Rmult_lt_0_compat; [exact G0 | now apply Rdiv_lt_0_compat]).
    apply (L9c_above_bridge (reverse p) (- T) e (minus_v v)); try assumption.
    + rewrite Euq. lra.
    + rewrite Euq, Evq, Du, Dv. unfold mu. field. lra.
    + unfold mu. apply Rmult_le_pos; [lra|]. apply Rmult_le_pos; [exact HPn | left; now apply Rinv_0_lt_compat].
  - unfold cL. assert (0 <= k * (PI + e)) by (apply Rmult_le_pos; lra).
    apply (follow_ray P HP Hr1 a p T v'); try assumption; try lra. now apply light_ray.
  - intros HD. set (m := r * mu w lam r).
    assert (Hd : 0 < mu_den w lam r / (w * w + r)) by (now apply Rdiv_lt_0_compat).
    assert (Hgd : 0 < g * (mu_den w lam r / (w * w + r))) by (now apply Rmult_lt_0_compat).
    assert (Em : m * - u_of (minus_v v) = v_of P (minus_v v)). { rewrite Euq, Evq, Du, Dv. unfold m, mu. field. lra. }
    assert (Hm0 : 0 <= m). { unfold m, mu. apply Rmult_le_pos; [lra|].
      apply Rmult_le_pos; [exact HPn | left; now apply Rinv_0_lt_compat]. }
    unfold cL. assert (0 <= m * (PI + e)) by (apply Rmult_le_pos; lra).
    apply (follow_ray P HP Hr1 b (reverse p) (- T) (minus_v v)); try assumption; try lra.
    apply light_ray; try assumption. lra.
  - intros HD. assert (Hd : 0 <= g * (- mu_den w lam r * / (w * w + r))).
    { apply Rmult_le_pos; [lra|]. apply Rmult_le_pos; [lra | left; now apply Rinv_0_lt_compat]. }
    apply (L1b_right_no_later P HP Hr1 (reverse p) (- T) (minus_v v) e b Hq Haq HRq);
      [|rewrite Euq, Evq; fold w; lra | exact Lb].
    rewrite Euq, Du. unfold Rdiv. lra.
Qed.

(** Either X or its reversal is in that case, or both have no later collision. *)
Lemma none_unless_flat p T e v n : motion P p -> on_R P p T e -> after p T v -> 0 < v_of P v - cos e * u_of v ->
  later P p T n ->
  0 <= u_of v \/ - u_of v <= v_of P v -> n = O.
Proof.
  intros Hm HR Ha Hv Hl [H|H].
  - now apply (L1b_right_no_later P HP Hr1 p T v e n).
  - destruct (Rlt_or_le (u_of v) 0) as [K|K]; [|now apply (L1b_right_no_later P HP Hr1 p T v e n)].
    apply (L3_steep_no_later P HP Hr1 p T v n Hm Ha); [|exact Hl]. rewrite Rabs_left by assumption. exact H.
Qed.
Theorem L9_turning_on_R U p T e l : light_bound r U -> (1 <= U)%nat -> motion P p -> no_heavy P p -> turning P p T ->
  on_R P p T e ->
  NoDup l -> (forall t, In t l -> collision P p t) -> (length l <= U)%nat.
Proof.
  intros HB HU Hm Hn [Hc [v [v' [Hb [Ha [Hv Hv']]]]]] HR Hnd Hl. assert (A1 := arm1_pos P HP).
  destruct (count_split P HP p T l Hm Hnd Hl) as [a [b [La [Lb Hab]]]].
  destruct (collision_law_on_R P HP p T e Hm Hn Hc HR) as [w [w' [Hb' [Ha' HL]]]].
  assert (w = v) by (apply before_unique with p T; assumption).
  assert (w' = v') by (apply after_unique with p T; assumption). subst w w'.
  assert (I0 : 0 <= / arm1 P) by (left; now apply Rinv_0_lt_compat).
  assert (V : v_of P v <= 0 <= v_of P v').
  { unfold v_of, Rdiv. assert (0 <= vy v' * / arm1 P) by (apply Rmult_le_pos; lra).
    assert (0 <= - vy v * / arm1 P) by (apply Rmult_le_pos; lra). lra. }
  assert (Hq := reverse_motion P p Hm). assert (Nq := no_heavy_reverse P HP p Hm Hn).
  assert (Haq : after (reverse p) (- T) (minus_v v)) by (apply reverse_after; now rewrite Ropp_involutive).
  assert (Hbq : before (reverse p) (- T) (minus_v v')) by (apply reverse_before; now rewrite Ropp_involutive).
  assert (HRq : on_R P (reverse p) (- T) e) by (unfold on_R, reverse; rewrite Ropp_involutive; exact HR).
  assert (Eu : forall z, u_of (minus_v z) = - u_of z) by reflexivity. assert (Ev := v_of_minus P HP).
  assert (HL' := HL). destruct HL as [j [Hj [Ju [Jv [Jr Jn]]]]].
  assert (HLq : reflects P (cos e) (u_of (minus_v v')) (v_of P (minus_v v')) (u_of (minus_v v)) (v_of P (minus_v v))).
  { exists j. rewrite !Eu, !Ev. repeat split; try assumption; lra. }
  destruct (Classical_Prop.classic (u_of v' < 0 /\ v_of P v' < - u_of v')) as [[X1 X2]|X].
  - assert (Q := L9_turning_left U p T e v v' a b HB Hm Hn HR Hb Ha HL' V X1 X2 La Lb). lia.
  - assert (a = O).
    { apply (none_unless_flat p T e v' a Hm HR Ha); [lra | exact La|].
      destruct (Rlt_or_le (u_of v') 0) as [K|K]; [right | now left]. apply Rnot_lt_le. intros K2. apply X. now split. }
    destruct (Classical_Prop.classic (u_of (minus_v v) < 0 /\ v_of P (minus_v v) < - u_of (minus_v v))) as [[Y1 Y2]|Y].
    + assert (Lb0 : later P (reverse (reverse p)) (- - T) a) by (rewrite reverse_reverse, Ropp_involutive; exact La).
      assert (Q :=
        L9_turning_left U (reverse p) (- T) e (minus_v v') (minus_v v) b a HB Hq Nq HRq Hbq Haq HLq ltac:(rewrite !Ev;
        lra) Y1 Y2 Lb Lb0). lia.
    + assert (b = O).
      { apply (none_unless_flat (reverse p) (- T) e (minus_v v) b Hq HRq Haq); [rewrite Eu, Ev; lra | exact Lb|].
        destruct (Rlt_or_le (u_of (minus_v v)) 0) as [K|K]; [right | now left]. apply Rnot_lt_le. intros K2.
        apply Y. now split. }
      lia.
Qed.

Theorem light_total U p T : light_bound r U -> (1 <= U)%nat -> motion P p -> no_heavy P p -> collision P p T ->
  at_most P p U.
Proof.
  intros HB HU Hm Hn Hc. destruct (L2c_turning_exists P HP Hr1 p T Hm Hn Hc) as [t Ht].
  destruct (normal_position P HP p t Hm Hn (proj1 Ht)) as [q [e [S HR]]]. apply (same_at_most P p q U S).
  assert (Hq := same_motion _ _ _ S Hm). assert (Nq := same_no_heavy _ _ _ S Hn).
  intros l. apply (L9_turning_on_R U q t e l HB HU Hq Nq); [|exact HR].
  destruct Ht as [Hct [v [v' [Hb [Ha Hv]]]]]. split; [now apply (same_collision _ _ _ S)|].
  destruct (same_before _ _ _ S t v Hb) as [w [Hb2 E1]]. destruct (same_after _ _ _ S t v' Ha) as [w' [Ha2 E2]].
  exists w, w'. rewrite E1, E2. repeat split; try assumption; apply Hv.
Qed.

(** The charts bound every motion. *)
Theorem charts_bound_motion U p : bridge_bound r U -> light_bound r U -> motion P p -> at_most P p U.
Proof.
  intros HB HL Hm. assert (HPI : 0 < PI) by apply PI_RGT_0.
  assert (HU : (1 <= U)%nat) by (apply (HB (PI/2) 0 O O); try exact I; lra).
  destruct (Classical_Prop.classic (no_heavy P p)) as [Hn|Hn].
  - intros [|T l] Hnd Hl; [simpl; lia|]. apply (light_total U p T HL HU Hm Hn); try assumption. apply Hl. now left.
  - apply Classical_Pred_Type.not_all_ex_not in Hn. destruct Hn as [T Hn]. apply Classical_Prop.imply_to_and in Hn.
    destruct Hn as [Hc Hn].
    apply (heavy_total P HP Hr1 U p T HB HU Hm Hc). now apply Classical_Prop.NNPP.
Qed.
End Light.

Theorem charts_upper q n : 1 <= q -> bridge_bound (/ q) n -> light_bound (/ q) n -> upper_bound q n.
Proof.
  intros Hq HB HL P p HP Hqq Hm.
  assert (E : / q = r_of P) by (unfold r_of; destruct HP as [? [? ?]]; rewrite <- Hqq; field; lra).
  rewrite E in HB, HL. apply charts_bound_motion; try assumption. rewrite <- E, <- Rinv_1. apply Rinv_le_contravar; lra.
Qed.
