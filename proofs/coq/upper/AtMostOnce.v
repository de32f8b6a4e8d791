(** L6 (c): in any motion the heavy mass hits the floor at most once, for every mass ratio of at least 1.

    L6c_heavy_at_most_once == two collisions of the heavy mass are one
    heavy_once             == that, said of every dumbbell of a mass ratio; always_once: it is so *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Trigonometry Physics Ray FewHits Flight Collisions Symmetry NormalPosition StartRay Follow.
From Dumbbell Require Import SteepRays.
Local Open Scope R_scope.

Section Once.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.
Hypothesis Hr1 : r_of P <= 1.
Notation r := (r_of P).
Notation yh := (yhat_of P).

(** L6 (c): no flight of a ray ends at the bridge. *)
Lemma ray_no_heavy n : forall p t0 v c k, motion P p -> ray P p t0 v c k -> 0 <= c -> - r <= k -> ~ later P p t0 n ->
  forall t, t0 < t -> collision P p t -> y2 P (p t) <> 0.
Proof.
  induction n as [|n IH]; intros p t0 v c k Hm HR Hc Hk Hl t Ht Hct.
  - exfalso. apply Hl. exists nil. repeat split; [constructor | contradiction | contradiction].
  - assert (R0 := r_pos P HP). destruct (first_collision P HP p t0 t Hm Ht Hct) as [t1 [H1 [Hc1 Hf]]].
    destruct (next_hit P HP Hr1 p t0 v c k t1 Hm HR ltac:(lra) Hc1 Hf) as [x [X0 [Hx [Hp [Hy [v' [Ha HL]]]]]]].
    destruct (Req_dec t t1) as [->|Hne].
    + intros Z. apply (contact2 P HP) in Z. rewrite Hp, cos_left, Hy in Z. destruct Hx as [X1 _].
      assert (0 < sin x) by (apply sin_gt_0; assert (H := PI2_1); lra).
      assert (0 <= r * sin x) by (apply Rmult_le_pos; lra). lra.
    + destruct (reflects_hit P HP Hr1 p t1 v v' c k x) as [HD [Hup Hkk]]; try assumption.
      { exact (ray_left _ _ _ _ _ _ HR). } { exact (ray_slope _ _ _ _ _ _ HR). }
      { exists t. split; [lra | exact Hct]. }
      destruct (next_domain c k r x R0 Hk Hx HD) as [Q1 Q2]. cbv zeta in Q1, Q2. rewrite <- (y2_mirror P).
      set (k' := next_slope (cos x) k r) in *. set (c' := sin x + k' * (x + PI)) in *.
      assert (RN : ray P (mirror p) t1 (mirror_v v') c' k').
      { apply start_ray_ray; [|now apply mirror_after]. destruct Hx as [X1 _].
        apply (next_start_ray P HP (p t1)); try assumption. lra. }
      apply (IH (mirror p) t1 (mirror_v v') c' k' (mirror_motion P p Hm) RN Q2); try lra;
        [|now apply collision_mirror].
      intros [l [L1 [L2 L3]]]. apply Hl. exists (t1 :: l). split; [|split; [simpl; lia|]].
      { constructor; [|exact L1]. intros K. destruct (L3 t1 K). lra. }
      intros s [<-|Hs]; [split; [lra | exact Hc1]|]. destruct (L3 s Hs) as [S1 S2]. split; [lra|].
      rewrite <- (mirror_mirror p). now apply collision_mirror.
Qed.
Lemma ray_never_heavy p t0 v c k : motion P p -> ray P p t0 v c k -> 0 <= c -> - r <= k ->
  forall t, t0 < t -> collision P p t -> y2 P (p t) <> 0.
Proof.
  intros Hm HR Hc Hk. destruct (L5f_bounded_below_zero r (r_pos P HP)) as [M HM].
  apply (ray_no_heavy (S M) p t0 v c k); try assumption. intros H.
  assert (C := follow_ray P HP Hr1 (S M) p t0 v c k Hm HR Hc Hk H). specialize (HM (S M) c k Hk C). lia.
Qed.

(** A contact with the heavy mass in the middle of the cell. *)
Lemma no_heavy_after_central p T t : motion P p -> collision P p T -> y2 P (p T) = 0 ->
  - (PI/2) < psi_of (p T) < PI/2 ->
  T < t -> collision P p t -> y2 P (p t) <> 0.
Proof.
  intros Hm Hc H2 Hp Ht Hct. assert (R0 := r_pos P HP).
  destruct (collision_law P HP p T Hm Hc) as [v [v' [Hb [Ha [[C _]|[_ HL]]]]]].
  { exfalso. apply (regular P p Hm T). now split. }
  assert (N : 0 < v_of P v' + r * sin (psi_of (p T)) * u_of v').
  { destruct HL as [l [_ [_ [_ [E1 E2]]]]]. unfold slope2 in *. lra. }
  assert (Left : forall q w, motion P q -> after q T w -> u_of w < 0 -> - (PI/2) < psi_of (q T) < PI/2 ->
    y2 P (q T) = 0 ->
    0 < v_of P w + r * sin (psi_of (q T)) * u_of w -> collision P q t -> y2 P (q t) <> 0).
  { intros q w Hq Hw Hu Hpq H2q Nq Hcq. set (k := v_of P w / - u_of w).
    assert (Hs : k * - u_of w = v_of P w) by (unfold k; field; lra).
    destruct (bridge_start_ray P HP Hr1 (q T) w k Hu Hs Hpq (contact2 P HP q T H2q) Nq) as [SX KX].
    assert (CX := Rlt_le _ _ (start_ray_height_pos P _ _ _ _ SX)). assert (RX := start_ray_ray P q T w _ k SX Hw).
    now apply (ray_never_heavy q T w _ k Hq RX CX KX t). }
  destruct (Rtotal_order (u_of v') 0) as [L|[E|G]].
  - now apply (Left p v').
  - intros _. rewrite E, Rmult_0_r, Rplus_0_r in N.
    assert (Z : 1%nat = O); [|discriminate Z]. apply (L3_steep_no_later P HP Hr1 p T v' 1%nat Hm Ha).
    + rewrite E, Rabs_R0. lra.
    + exists (t :: nil). split; [constructor; [easy | constructor]|]. split; [reflexivity|]. intros s [<-|[]].
    now split.
  - rewrite <- (y2_mirror P). assert (Eu : u_of (mirror_v v') = - u_of v') by reflexivity.
    assert (Ev : v_of P (mirror_v v') = v_of P v') by reflexivity.
    apply (Left (mirror p) (mirror_v v')); rewrite ?psi_mirror, ?sin_neg, ?Eu, ?Ev; try lra.
    + now apply mirror_motion.
    + now apply mirror_after.
    + now rewrite y2_mirror.
    + now apply collision_mirror.
Qed.

(** L6 (c): at most one contact with the heavy mass. *)
Theorem L6c_heavy_at_most_once p T T' : motion P p -> collision P p T -> y2 P (p T) = 0 -> collision P p T' ->
  y2 P (p T') = 0 -> T = T'.
Proof.
  assert (G : forall T T', motion P p -> collision P p T -> y2 P (p T) = 0 -> collision P p T' -> y2 P (p T') = 0 ->
    ~ T < T').
  { clear T T'. intros T T' Hm Hc H2 Hc' H2' Ht. destruct (heavy_normal_position P HP p T Hm H2) as [q [e [S [Ep He]]]].
    apply (no_heavy_after_central q T T'); try assumption.
    - exact (same_motion P _ _ S Hm).
    - exact (same_collision P _ _ S T Hc).
    - rewrite (same_y2 _ _ _ S). exact H2.
    - assert (HPI := PI2_1). lra.
    - exact (same_collision P _ _ S T' Hc').
    - rewrite (same_y2 _ _ _ S). exact H2'. }
  intros Hm Hc H2 Hc' H2'. destruct (Rtotal_order T T') as [L|[E|L]]; [|exact E|]; exfalso; revert L; now apply G.
Qed.
End Once.

Definition heavy_once (q : R) := forall P p T T', real_dumbbell P -> m2 P / m1 P = q -> motion P p ->
  collision P p T -> y2 P (p T) = 0 -> collision P p T' -> y2 P (p T') = 0 -> T = T'.
Theorem always_once q : 1 <= q -> heavy_once q.
Proof.
  intros Hq P p T T' HP E. apply (L6c_heavy_at_most_once P HP).
  replace (r_of P) with (/ q); [rewrite <- Rinv_1; apply Rinv_le_contravar; lra|].
  unfold r_of. destruct HP as [? [? ?]]. rewrite <- E. field. lra.
Qed.
