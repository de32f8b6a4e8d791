(** L2 (c): a motion in which only the light mass hits the floor, if at all, has a turning collision, v_in <= 0 <=
    v_out. For an ascending flight has few later collisions (L5 (f)), and a descending one comes from, or runs into,
    another collision.

    turning, L2c_turning_exists   == such a collision; there is one
    light_ray, L1b_right_no_later == what leaves the wall R to the left is a ray; to the right it has no later collision
    collision_law_on_R            == the velocities at a collision there *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics FewHits Flight Collisions Symmetry NormalPosition Follow.
Local Open Scope R_scope.

Section Turning.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.
Hypothesis Hr1 : r_of P <= 1.
Notation r := (r_of P).
Notation yh := (yhat_of P).

(** The ray out of a contact with the wall R to the left. *)
Theorem light_ray p T v k e : after p T v -> on_R P p T e -> no_heavy P p -> u_of v < 0 -> 0 <= k ->
  k * - u_of v = v_of P v ->
  ray P p T v (sin e + k * (PI + e)) k.
Proof.
  intros Ha [Hp [He Hy]] Hn Hu Hk Hs. assert (HPI : 0 < PI) by apply PI_RGT_0.
  assert (Se : 0 < sin e) by (apply sin_gt_0; lra).
  split; rewrite ?Hp, ?Hy; try assumption; try lra.
  - intros z Hz. split; [|now right]. assert (K0 : 0 <= k * (PI/2 + e - z)) by (apply Rmult_le_pos; lra).
    destruct (Rle_or_lt z (PI/2)) as [Kz|Kz].
    + assert (0 <= cos z) by (apply cos_ge_0; lra). lra.
    + assert (Cz : - cos z = sin (z - PI/2)) by (rewrite sin_minus, cos_PI2, sin_PI2; ring).
      assert (sin (z - PI/2) < sin e) by (apply sin_increasing_1; lra). lra.
Qed.

(** L1 (b) at the wall R: not to the left, no later collision. *)
Theorem L1b_right_no_later p T v e n : motion P p -> after p T v -> on_R P p T e -> 0 <= u_of v ->
  0 < v_of P v - cos e * u_of v -> later P p T n -> n = O.
Proof.
  intros Hm Ha [Hp [He Hy]] Hu Hv Hl. destruct n as [|n]; [reflexivity|exfalso].
  destruct (later_next P HP p T n Hm Hl) as [t [Ht [Hc _]]].
  apply (L1b_no_return P HP Hr1 (mirror p) T (mirror_v v) e) with (T := t).
  - now apply mirror_motion.
  - now apply mirror_after.
  - rewrite psi_mirror, Hp. ring.
  - lra.
  - exact Hy.
  - unfold u_of in *; simpl; lra.
  - unfold u_of, v_of in *; simpl; lra.
  - exact Ht.
  - now apply collision_mirror.
Qed.

(** A collision on R: the two velocities. *)
Lemma collision_law_on_R p T e : motion P p -> no_heavy P p -> collision P p T -> on_R P p T e ->
  exists v v', before p T v /\ after p T v' /\
  reflects P (cos e) (u_of v) (v_of P v) (u_of v') (v_of P v').
Proof.
  intros Hm Hn Hc [Hp _]. destruct (collision_law P HP p T Hm Hc) as [v [v' [Hb [Ha [[_ H]|[H _]]]]]];
    [|exfalso; now apply (Hn T Hc)].
  exists v, v'. split; [exact Hb|]. split; [exact Ha|]. unfold slope1 in H. rewrite Hp, sin_plus, sin_PI2, cos_PI2 in H.
  now replace (1 * cos e + 0 * sin e) with (cos e) in H by ring.
Qed.

(** L5 (f) for the motion: an ascending flight out of a collision has few later ones. *)
Theorem ascending_few : exists M, forall p T v n, motion P p -> no_heavy P p -> collision P p T ->
  after p T v -> 0 <= vy v ->
  later P p T n -> (n <= M)%nat.
Proof.
  assert (R0 := r_pos P HP). assert (A1 := arm1_pos P HP). destruct (L5f_bounded r R0) as [M HM]. exists M.
  intros p0 T v0 n Hm0 Hn0 Hc0 Ha0 Hv0 Hl0.
  destruct (normal_position P HP p0 T Hm0 Hn0 Hc0) as [p [e [S HR]]].
  destruct (same_after _ _ _ S T v0 Ha0) as [v' [Ha Ev]].
  assert (Hm := same_motion _ _ _ S Hm0). assert (Hn := same_no_heavy _ _ _ S Hn0).
  assert (Hc := same_collision _ _ _ S T Hc0). assert (Hl := same_later _ _ _ T n S Hl0).
  destruct (collision_law_on_R p T e Hm Hn Hc HR) as [v [v1 [Hb [Ha1 HL]]]].
  assert (v1 = v') by (apply after_unique with p T; assumption). subst v1.
  assert (Hv : 0 <= v_of P v'). { unfold v_of. rewrite Ev. apply Rmult_le_pos; [lra | left; now apply Rinv_0_lt_compat].
    }
  destruct HL as [l [_ [_ [_ [Er En]]]]].
  destruct (Rlt_or_le (u_of v') 0) as [K|K].
  - set (k := v_of P v' / - u_of v'). assert (Ek : k * - u_of v' = v_of P v') by (unfold k; field; lra).
    assert (Hk : 0 <= k) by (unfold k; apply Rmult_le_pos; [exact Hv | left; apply Rinv_0_lt_compat; lra]).
    assert (HPI : 0 < PI) by apply PI_RGT_0. assert (He := HR). destruct He as [_ [He _]].
    assert (Se : 0 < sin e) by (apply sin_gt_0; lra). assert (0 <= k * (PI + e)) by (apply Rmult_le_pos; lra).
    apply (HM n (sin e + k * (PI + e)) k Hk). apply (follow_ray P HP Hr1 n p T v'); try assumption; try lra.
    now apply light_ray.
  - assert (n = O); [|lia]. apply (L1b_right_no_later p T v' e n Hm Ha HR K); [lra | exact Hl].
Qed.

(** A descending flight hits the floor. *)
Lemma height_pos p t : motion P p -> 0 <= height (p t).
Proof.
  intros Hm. assert (B1 := above1 P p Hm t). assert (B2 := above2 P p Hm t). assert (A1 := arm1_pos P HP).
  assert (A2 := arm2_pos P HP).
  unfold y1, y2 in *. apply Rmult_le_reg_l with (arm1 P + arm2 P); [lra|].
  assert (0 <= arm2 P * (height (p t) + arm1 P * sin (angle (p t)))) by (apply Rmult_le_pos; lra).
  assert (0 <= arm1 P * (height (p t) - arm2 P * sin (angle (p t)))) by (apply Rmult_le_pos; lra). lra.
Qed.
Theorem descending_hits p T v : motion P p -> after p T v -> vy v < 0 -> exists t, T < t /\ collision P p t.
Proof.
  intros Hm Ha Hv. apply Classical_Prop.NNPP. intros K. assert (H0 := height_pos p T Hm).
  set (d := (height (p T) + 1) / - vy v). assert (Hd : 0 < d) by (apply Rdiv_lt_0_compat; lra).
  destruct (straight_flight P HP p T (T + d) v Hm Ha ltac:(lra)) with (s := T + d) as [E _]; [|lra|].
  { intros t Ht Hc. apply K. exists t. split; [lra | exact Hc]. }
  assert (H1 := height_pos p (T + d) Hm). replace (T + d - T) with d in E by ring.
  assert (vy v * d = - (height (p T) + 1)) by (unfold d; field; lra). lra.
Qed.

(** Before a collision into which the dumbbell ascends there is another one, and it comes out of that with the same
    velocity. *)
Theorem ascending_comes_from p T v : motion P p -> before p T v -> 0 < vy v ->
  exists t, t < T /\ collision P p t /\ after p t v.
Proof.
  intros Hm Hb Hv. assert (Hq := reverse_motion P p Hm).
  assert (Ha : after (reverse p) (- T) (minus_v v)) by (apply reverse_after; now rewrite Ropp_involutive).
  destruct (descending_hits (reverse p) (- T) (minus_v v) Hq Ha) as [S [HS HcS]]; [simpl; lra|].
  destruct (first_collision P HP (reverse p) (- T) S Hq HS HcS) as [t1 [H1 [Hc1 Hf]]].
  exists (- t1). split; [lra|]. split; [now apply collision_unreverse|].
  destruct (law P p Hm (- t1)) as [_ [w [_ [Hw _]]]].
  assert (L := straight_flight P HP p (- t1) T w Hm Hw ltac:(lra)).
  assert (Hfree : forall t, - t1 < t < T -> ~ collision P p t).
  { intros t Ht Hc. apply (Hf (- t)); [lra|]. now apply collision_reverse. }
  specialize (L Hfree). assert (w = v); [|now subst w].
  apply before_unique with p T; [|exact Hb]. destruct (L T ltac:(lra)) as [Q1 Q2]. exists (T + t1). split; [lra|].
  intros s Hs. destruct (L s ltac:(lra)). split; lra.
Qed.

Definition turning p T := collision P p T /\ exists v v', before p T v /\ after p T v' /\ vy v <= 0 <= vy v'.
Lemma collision_rises p T v v' : motion P p -> collision P p T -> before p T v -> after p T v' -> vy v < vy v'.
Proof.
  intros Hm Hc Hb Ha. assert (A1 := arm1_pos P HP). destruct (collision_law P HP p T Hm Hc) as [w [w' [Hb' [Ha' H]]]].
  assert (w = v) by (apply before_unique with p T; assumption).
  assert (w' = v') by (apply after_unique with p T; assumption). subst.
  assert (L : v_of P v < v_of P v') by (destruct H as [[_ H]|[_ H]]; exact (L2a_v_grows P HP _ _ _ _ _ H)).
  unfold v_of in L. apply Rmult_lt_reg_r with (/ arm1 P); [now apply Rinv_0_lt_compat | exact L].
Qed.

(** Back from an ascending collision: a turning one, or n + 1 of them. *)
Lemma go_back p T v n : motion P p -> collision P p T -> before p T v -> 0 < vy v -> later P p T n ->
  (exists t, turning p t) \/ exists t w, collision P p t /\ before p t w /\ 0 < vy w /\ later P p t (S n).
Proof.
  intros Hm Hc Hb Hv [l [N1 [N2 N3]]]. destruct (ascending_comes_from p T v Hm Hb Hv) as [t [Ht [Hct Hat]]].
  destruct (law P p Hm t) as [w [_ [Hbw _]]]. destruct (Rle_or_lt (vy w) 0) as [K|K].
  - left. exists t. split; [exact Hct|]. exists w, v. repeat split; try assumption; lra.
  - right. exists t, w. repeat split; try assumption. exists (T :: l)%list. split; [|split].
    + constructor; [|exact N1]. intros Hi. destruct (N3 T Hi). lra.
    + simpl. now f_equal.
    + intros s [<-|Hs]; [now split|]. destruct (N3 s Hs). split; [lra | assumption].
Qed.
Lemma turning_up p T v : motion P p -> no_heavy P p -> collision P p T -> before p T v -> 0 < vy v ->
  exists t, turning p t.
Proof.
  intros Hm Hn Hc Hb Hv. destruct ascending_few as [M HM].
  assert (G : forall n, (exists t, turning p t) \/ exists t w, collision P p t /\ before p t w /\ 0 < vy w /\
    later P p t n).
  { induction n as [|n [IH|[t [w [H1 [H2 [H3 H4]]]]]]].
    - right. exists T, v. repeat split; try assumption. exists nil.
      repeat split; [constructor | contradiction | contradiction].
    - now left.
    - now apply go_back with t w. }
  destruct (G (S M)) as [H|[t [w [H1 [H2 [H3 H4]]]]]]; [exact H|exfalso].
  destruct (law P p Hm t) as [_ [w' [_ [Ha _]]]]. assert (L := collision_rises p t w w' Hm H1 H2 Ha).
  specialize (HM p t w' (S M) Hm Hn H1 Ha ltac:(lra) H4). lia.
Qed.

Lemma turning_unreverse p t : motion P p -> turning (reverse p) t -> turning p (- t).
Proof.
  intros Hm [Hc [v [v' [Hb [Ha Hv]]]]]. split; [now apply collision_unreverse|].
  exists (minus_v v'), (minus_v v). repeat split; simpl; try lra.
  - rewrite <- (reverse_reverse p). apply reverse_before. now rewrite Ropp_involutive.
  - rewrite <- (reverse_reverse p). apply reverse_after. now rewrite Ropp_involutive.
Qed.

(** L2 (c). *)
Theorem L2c_turning_exists p T : motion P p -> no_heavy P p -> collision P p T -> exists t, turning p t.
Proof.
  intros Hm Hn Hc. destruct (law P p Hm T) as [v [v' [Hb [Ha _]]]].
  destruct (Rlt_or_le 0 (vy v)) as [K|K]; [now apply (turning_up p T v)|].
  destruct (Rle_or_lt 0 (vy v')) as [K2|K2]. { exists T. split; [exact Hc|]. exists v, v'. repeat split; assumption. }
  destruct (turning_up (reverse p) (- T) (minus_v v')) as [t Ht].
  - now apply reverse_motion.
  - now apply no_heavy_reverse.
  - now apply collision_reverse.
  - apply reverse_before. now rewrite Ropp_involutive.
  - simpl. lra.
  - exists (- t). now apply turning_unreverse.
Qed.
End Turning.
