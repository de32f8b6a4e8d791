(** The future of a ray: G <= F, the converse of Follow.v. Out of a state that is a ray (StartRay.v) there is a half
    motion for all later times with as many collisions as the ray has (L4). Built flight by flight, by induction on the
    bound of L5 (f); behind the peak of a hump nothing is met again (L1 (b)).

    future          == a half motion out of a state
    ray_future      == out of a ray, with all of the ray's collisions
    over, over_free == a point behind the left corner and above the hump there is in free flight *)
From Coq Require Import Reals Lra Lia List FinFun.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics Ray FewHits Flight Collisions Symmetry Existence StartRay.
Local Open Scope R_scope.

Section Future.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.
Hypothesis Hr1 : r_of P <= 1.
Notation r := (r_of P).
Notation yh := (yhat_of P).

(** What lies above the floor curve left of the corner, psi = - pi/2 - X. *)
Definition over (X y : R) := 0 < y /\ sin X <= y /\ - r * sin X <= y.
Lemma over_free s X : psi_of s = - (PI/2) - X -> over X (yh s) -> free P s.
Proof. intros E [A [B C]]. unfold free. rewrite E, cos_left. repeat split; lra. Qed.
Lemma over_low X y : 0 <= X <= PI/2 -> 0 < y -> sin X <= y -> over X y.
Proof.
  intros HX Hy Hs. assert (R0 := r_pos P HP).
  assert (0 <= sin X) by (apply sin_ge_0; assert (0 < PI) by apply PI_RGT_0; lra).
  assert (0 <= r * sin X) by (apply Rmult_le_pos; lra). repeat split; lra.
Qed.
Lemma over_high X y : 1 <= y -> over X y.
Proof.
  intros Hy. assert (R0 := r_pos P HP). assert (B := SIN_bound X).
  assert (r * - sin X <= r * 1) by (apply Rmult_le_compat_l; lra).
  repeat split; lra.
Qed.
Lemma over_miss c k X : 0 < c -> 0 <= k \/ c + k * (PI/2) < 1 -> ~ (exists x, hit c k x) -> 0 <= X ->
  over X (c + k * X).
Proof.
  intros Hc Hk Hno HX. assert (HPI : 0 < PI) by apply PI_RGT_0.
  assert (K : forall x, 0 <= x <= PI/2 -> sin x <= c + k * x).
  { intros x Hx. apply Rnot_lt_le. intros L. destruct (hit_exists c k x ltac:(lra) Hx L) as [x' [H _]]. apply Hno.
    now exists x'. }
  destruct (Rle_or_lt X (PI/2)) as [L|L].
  - apply over_low; [lra | | apply K; lra]. destruct (Req_dec X 0) as [->|]; [lra|].
    assert (0 < sin X) by (apply sin_gt_0; lra). specialize (K X ltac:(lra)). lra.
  - apply over_high. assert (K1 := K (PI/2) ltac:(lra)). rewrite sin_PI2 in K1.
    assert (Hk0 : 0 <= k) by (destruct Hk; lra).
    assert (k * (PI/2) <= k * X) by (apply Rmult_le_compat_l; lra). lra.
Qed.
Lemma over_before c k x X : 0 < c -> hit c k x -> 0 <= X <= x -> over X (c + k * X).
Proof.
  intros Hc [Hx [Hs Hk]] HX. assert (HPI : 0 < PI) by apply PI_RGT_0.
  assert (T := sin_below_tangent x X ltac:(lra) ltac:(lra)).
  assert (0 <= (x - X) * (cos x - k)) by (apply Rmult_le_pos; lra). assert (S : sin X <= c + k * X) by lra.
  apply over_low; [lra | | exact S]. destruct (Req_dec X 0) as [->|]; [lra|].
  assert (0 < sin X) by (apply sin_gt_0; lra). lra.
Qed.
(** L1 (b): behind the peak. *)
Lemma over_tangent x X y : 0 < x < PI/2 -> x <= X -> sin x + cos x * (X - x) <= y -> over X y.
Proof.
  intros Hx HX Hy. assert (HPI : 0 < PI) by apply PI_RGT_0. assert (W := cos_pos x ltac:(lra)).
  destruct (Rle_or_lt X (PI/2)) as [L|L].
  - assert (T := sin_below_tangent x X ltac:(lra) ltac:(lra)). assert (0 < sin X) by (apply sin_gt_0; lra).
    apply over_low; lra.
  - apply over_high. assert (T := sin_below_tangent x (PI/2) ltac:(lra) ltac:(lra)). rewrite sin_PI2 in T.
    assert ((PI/2 - x) * cos x <= (X - x) * cos x) by (apply Rmult_le_compat_r; lra). lra.
Qed.

(** Along the ray. *)
Lemma ray_free s0 v c k t : start_ray P s0 v c k -> 0 < t ->
  (forall X, 0 <= X -> psi_of (line s0 v t) = - (PI/2) - X -> over X (c + k * X)) -> free P (line s0 v t).
Proof.
  intros [Hu Hs Hc Hst Hcl _] Ht HX. assert (R0 := r_pos P HP). set (z := psi_of (line s0 v t)).
  assert (Ez : z = psi_of s0 + u_of v * t) by apply line_psi.
  assert (Hz : z < psi_of s0) by (assert (0 < - u_of v * t) by (apply Rmult_lt_0_compat; lra); lra).
  assert (Ey : yh (line s0 v t) = yh s0 + k * (psi_of s0 - z)) by (rewrite (line_yh P HP), <- Hs, Ez; ring).
  destruct (Rle_or_lt (- (PI/2)) z) as [L|L].
  - destruct (Hcl z ltac:(lra)) as [A B]. unfold free. fold z. rewrite Ey. repeat split; try lra.
    destruct (Rle_or_lt 0 (cos z)) as [C|C]; [|lra]. assert (0 <= r * cos z) by (apply Rmult_le_pos; lra). lra.
  - apply over_free with (- (PI/2) - z); [fold z; ring|].
    replace (yh (line s0 v t)) with (c + k * (- (PI/2) - z)) by (rewrite Ey, Hc; ring).
    apply HX; [lra | fold z; ring].
Qed.

(** The contact with the left wall. *)
Lemma hit_state s0 v c k x : start_ray P s0 v c k -> hit c k x -> exists T, 0 < T /\ let s1 := line s0 v T in
  psi_of s1 = - (PI/2) - x /\ yh s1 = sin x /\ 0 < x < PI/2 /\ (forall t, 0 < t <= T -> free P (line s0 v t)) /\
  y1 P s1 = 0 /\ w1 P s1 v < 0.
Proof.
  intros HR Hx. assert (Hc := start_ray_height_pos P _ _ _ _ HR). assert (HR' := HR).
  destruct HR' as [Hu Hs Ec Hst _ _]. assert (Hx' := Hx). destruct Hx' as [X1 [X2 X3]].
  assert (A1 := arm1_pos P HP). assert (Hx0 : 0 < x).
  { destruct (Req_dec x 0) as [->|]; [rewrite sin_0 in X2; lra | lra]. }
  set (T := (psi_of s0 + PI/2 + x) / - u_of v). exists T. assert (HT : 0 < T) by (apply Rdiv_lt_0_compat; lra).
  assert (ET : - u_of v * T = psi_of s0 + PI/2 + x) by (unfold T; field; lra). split; [exact HT|]. intros s1.
  assert (E1 : psi_of s1 = - (PI/2) - x) by (unfold s1; rewrite line_psi; lra).
  assert (E2 : yh s1 = sin x). { unfold s1. rewrite (line_yh P HP), <- Hs, X2, Ec.
    replace (k * - u_of v * T) with (k * (- u_of v * T)) by ring. rewrite ET. ring. }
  split; [exact E1|]. split; [exact E2|]. split; [lra|]. split; [|split].
  - intros t Ht. apply (ray_free s0 v c k t HR); [lra|]. intros X HX EX. apply (over_before c k x X Hc Hx).
    split; [exact HX|].
    rewrite line_psi in EX. assert (- u_of v * t <= - u_of v * T) by (apply Rmult_le_compat_l; lra). lra.
  - destruct (L0_heights P s1 HP) as [E _]. rewrite E, E1, E2, cos_left. ring.
  - unfold w1. assert (Ca : cos (angle s1) = cos x) by (assert (K := sin_psi s1); rewrite E1, sin_left in K; lra).
    rewrite Ca.
    assert (0 < arm1 P * ((cos x - k) * - u_of v)) by (apply Rmult_lt_0_compat; [lra | apply Rmult_lt_0_compat; lra]).
    replace (arm1 P * ((cos x - k) * - u_of v)) with (- (vy v + arm1 P * cos x * om v)) in H; [lra|].
    replace ((cos x - k) * - u_of v) with (cos x * - u_of v - v_of P v) by (rewrite <- Hs; ring).
    unfold u_of, v_of. field. lra.
Qed.

(** A half motion out of the state s0, v. *)
Definition future s0 v p := p 0 = s0 /\ after p 0 v /\ forall t, 0 < t -> lawful P p t.
Lemma future_line s0 v : (forall t, 0 < t -> free P (line s0 v t)) -> future s0 v (line s0 v).
Proof. intros H. split; [apply line_0|]. split; [apply line_after|]. intros t Ht. now apply (line_lawful P HP), H. Qed.
Lemma future_mirror s0 v p : future (mirror_pos s0) (mirror_v v) p -> future s0 v (mirror p).
Proof.
  intros [A [B C]]. split; [unfold mirror; rewrite A; apply pos_eq; simpl; ring|]. split.
  - replace v with (mirror_v (mirror_v v)) by (apply vel_eq; simpl; ring). now apply mirror_after.
  - intros t Ht. now apply mirror_lawful, C.
Qed.

(** A flight, a bounce off the light wall, and a future from there. *)
Lemma future_glue s0 v T v' p2 : 0 < T -> (forall t, 0 < t <= T -> free P (line s0 v t)) -> let s1 := line s0 v T in
  y1 P s1 = 0 -> w1 P s1 v < 0 -> push1 P s1 v v' -> future s1 v' p2 ->
  let p := glue T (line s0 v) p2 in future s0 v p /\ forall n, later P p2 0 n -> later P p 0 (S n).
Proof.
  intros HT Hf s1 Hy Hw Hpush [F1 [F2 F3]] p. assert (Eat : p T = s1) by (unfold p; rewrite glue_at; reflexivity).
  assert (Hb : before p T v) by (apply glue_before, line_before).
  assert (Ha : after p T v') by (apply glue_after; assumption).
  split; [split; [|split]|].
  - unfold p, glue. destruct (Rle_dec 0 T); [apply line_0 | lra].
  - apply near_after with (line s0 v); [now apply glue_left | apply line_after].
  - intros t Ht. destruct (Rtotal_order t T) as [L|[->|L]].
    + apply near_lawful with (line s0 v); [now apply glue_left|]. apply (line_lawful P HP), Hf. lra.
    + destruct (free_above P HP s1) as [A [B C]]; [apply Hf; lra|]. unfold lawful. rewrite Eat.
      repeat split; try assumption.
      exists v, v'. split; [exact Hb|]. split; [exact Ha|]. right; left. now split.
    + apply near_lawful with (shift T p2); [now apply glue_right|]. apply shift_lawful, F3. lra.
  - intros n [l [N1 [N2 N3]]]. exists (T :: map (fun t => t + T) l)%list. split; [|split].
    + constructor.
      * intros Hi. apply in_map_iff in Hi. destruct Hi as [t [Et Hi]]. destruct (N3 t Hi). lra.
      * apply Injective_map_NoDup; [intros a b E; lra | exact N1].
    + simpl. now rewrite map_length, N2.
    + intros t [<-|Hi].
      * split; [exact HT|]. exists v. split; [exact Hb|]. left. rewrite Eat. now split.
      * apply in_map_iff in Hi. destruct Hi as [t' [<- Hi]]. destruct (N3 t' Hi) as [Q1 Q2]. split; [lra|].
        apply near_collision with (shift T p2); [apply glue_right; lra|]. apply shift_collision.
        now replace (t' + T - T) with t' by ring.
Qed.

(** Every ray has a future. *)
Theorem future_exists N : forall s0 v c k, start_ray P s0 v c k -> - r <= k -> ~ coll r (S N) c k ->
  exists p, future s0 v p /\ forall n, coll r n c k -> later P p 0 n.
Proof.
  assert (R0 := r_pos P HP). induction N as [|N IH]; intros s0 v c k HR Hk Hno;
    assert (Hc := start_ray_height_pos P _ _ _ _ HR);
  (destruct (Classical_Prop.classic (exists x, hit c k x)) as [[x Hx]|Hmiss];
   [|exists (line s0 v); split;
     [apply future_line; intros t Ht; apply (ray_free s0 v c k t HR Ht); intros X HX _; apply over_miss; try assumption;
       exact (sr_below _ _ _ _ _ HR)
     |intros [|n] H; [apply later_0|]; exfalso; apply Hmiss; destruct H as [x [Hx _]]; now exists x]]).
  { exfalso. apply Hno. exists x. split; [exact Hx | now left]. }
  destruct (hit_state s0 v c k x HR Hx) as [T [HT [E1 [E2 [Hx0 [Hf [Hy Hw]]]]]]]. set (s1 := line s0 v T) in *.
  assert (Hu := sr_left _ _ _ _ _ HR). assert (Hs := sr_slope _ _ _ _ _ HR).
  destruct (push_exists P HP (arm1 P * cos (angle s1)) v Hw) as [v' [Hpush Hne]]. change (push1 P s1 v v') in Hpush.
  destruct (L0_reflection1 P HP s1 v v' Hpush) as [|HL]; [contradiction|]. unfold slope1 in HL.
  rewrite E1, sin_left in HL.
  destruct (reflected_velocity P HP x k v v' Hu Hs HL) as [Bu [Bv Bn]].
  assert (Hq : 0 < cos x * cos x + r) by (assert (0 <= cos x * cos x) by apply Rle_0_sqr; lra).
  destruct (Rlt_or_le 0 (slope_den (cos x) k r)) as [HD|HD].
  - (* it bounces to the other wall *)
    destruct (next_domain c k r x R0 Hk Hx HD) as [Q1 Q2]. set (k' := next_slope (cos x) k r) in *.
    assert (Hup : 0 < u_of v') by (rewrite Bu; apply Rmult_lt_0_compat; [lra | now apply Rdiv_lt_0_compat]).
    assert (Hkk : k' * u_of v' = v_of P v') by (rewrite Bu, Bv; unfold k', next_slope; field; lra).
    assert (SR := next_start_ray P HP s1 v' x k' E1 E2 Hx0 Hup Hkk Q1).
    destruct (IH _ _ _ _ SR ltac:(lra)) as [p3 [F3 C3]].
    { intros H. apply Hno. exists x. split; [exact Hx|]. right. split; [exact HD | exact H]. }
    destruct (future_glue s0 v T v' (mirror p3) HT Hf Hy Hw Hpush (future_mirror _ _ _ F3)) as [G1 G2].
    exists (glue T (line s0 v) (mirror p3)). split; [exact G1|]. intros [|n] H; [apply later_0|]. apply G2.
    destruct H as [x' [Hx' [->|[HD' H]]]]; [apply later_0|]. assert (x' = x) by (now apply hit_unique with c k).
    subst x'.
    now apply later_mirror, C3.
  - (* it leaves *)
    assert (Hul : u_of v' <= 0).
    { rewrite Bu.
      assert (0 <= - u_of v * (- slope_den (cos x) k r * / (cos x * cos x + r)))
        by (apply Rmult_le_pos; [lra|]; apply Rmult_le_pos; [lra | left; now apply Rinv_0_lt_compat]).
      unfold Rdiv. lra. }
    assert (F3 : future s1 v' (line s1 v')).
    { apply future_line. intros t Ht. assert (0 <= - u_of v' * t) by (apply Rmult_le_pos; lra).
      apply over_free with (x - u_of v' * t); [rewrite line_psi, E1; ring|].
      apply over_tangent with x; [exact Hx0 | lra|].
      rewrite (line_yh P HP), E2. assert (0 < (v_of P v' + cos x * u_of v') * t) by (now apply Rmult_lt_0_compat).
      lra. }
    destruct (future_glue s0 v T v' _ HT Hf Hy Hw Hpush F3) as [G1 G2]. exists (glue T (line s0 v) (line s1 v')).
    split; [exact G1|].
    intros [|n] H; [apply later_0|]. apply G2. destruct H as [x' [Hx' [->|[HD' H]]]]; [apply later_0|].
    assert (x' = x) by (now apply hit_unique with c k). subst x'. lra.
Qed.
Lemma ray_future s0 v c k : start_ray P s0 v c k -> - r <= k -> exists p, future s0 v p /\ forall n, coll r n c k ->
  later P p 0 n.
Proof.
  intros HR Hk. destruct (L5f_bounded_below_zero r (r_pos P HP)) as [M HM]. apply (future_exists M s0 v c k HR Hk).
  intros H. specialize (HM (S M) c k Hk H). lia.
Qed.
End Future.
