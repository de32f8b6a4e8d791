(** That [motion] and [collision] say what a physicist means. In flight a mass moves at w1 (w2). A collision is the same
    as a jump of the velocity, and turns the vertical velocity of the mass; a tangential contact does nothing. The
    energy is the same at all times. There is a dumbbell of each ratio, and a motion with a collision that needs no
    theory: the upright rod that bounces once. (Newton.v: the floor's push is Newton's law for two masses and a rod.) *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Signs Physics RealInduction Flight Collisions Scaling Existence.
Import ListNotations.
Local Open Scope R_scope.

(** There are dumbbells of the ratios q > 0, and of no others. *)
Theorem ratios_exist q : 0 < q <-> exists P, real_dumbbell P /\ m2 P / m1 P = q.
Proof.
  split.
  - intros Hq. exists (unit_dumbbell q). now apply unit_real.
  - intros [P [[H1 [H2 _]] <-]]. pos.
Qed.

Section Sanity.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.

(** w1, w2 are the derivatives of the heights of the masses along a flight. *)
Theorem w1_is_derivative s v t : is_derive (fun x => y1 P (line s v x)) t (w1 P (line s v t) v).
Proof. unfold y1, w1, line; simpl. auto_derive; [easy | ring]. Qed.
Theorem w2_is_derivative s v t : is_derive (fun x => y2 P (line s v x)) t (w2 P (line s v t) v).
Proof. unfold y2, w2, line; simpl. auto_derive; [easy | ring]. Qed.

(** A collision is a jump of the velocity. *)
Theorem collision_is_jump p t v v' : motion P p -> before p t v -> after p t v' -> (collision P p t <-> v' <> v).
Proof.
  intros Hm Hb Ha. split.
  - intros Hc ->. exact (collision_changes_velocity P HP p t v Hm Hb Ha Hc).
  - intros Hne. apply Classical_Prop.NNPP. intros Hn. apply Hne.
    destruct (no_collision_no_change P HP p t Hm Hn) as [w [Wb Wa]].
    transitivity w; [apply after_unique with p t | apply before_unique with p t]; assumption.
Qed.

(** The mass that comes in leaves with the opposite vertical velocity. *)
Theorem collision_turns p t v v' : motion P p -> collision P p t -> before p t v -> after p t v' ->
  (y1 P (p t) = 0 /\ w1 P (p t) v' = - w1 P (p t) v /\ w1 P (p t) v < 0) \/
  (y2 P (p t) = 0 /\ w2 P (p t) v' = - w2 P (p t) v /\ w2 P (p t) v < 0).
Proof.
  intros Hm Hc Hb Ha. destruct (law P p Hm t) as [w [w' [Wb [Wa H]]]].
  assert (w = v) by (apply before_unique with p t; assumption). subst w.
  assert (w' = v') by (apply after_unique with p t; assumption). subst w'.
  assert (N := proj1 (collision_is_jump p t v v' Hm Hb Ha) Hc).
  destruct H as [H|[[H0 H]|[H0 H]]]; [contradiction | left | right]; (split; [exact H0|]);
    destruct (push_cases P HP _ _ _ H) as [|[E [j [_ [_ [_ L]]]]]]; try contradiction; unfold w1, w2; lra.
Qed.

(** The energy is the same at all times. *)
Theorem energy_kept p t1 v1 t2 v2 : motion P p -> after p t1 v1 -> after p t2 v2 -> t1 <= t2 ->
  energy P v2 = energy P v1.
Proof.
  intros Hm H1 H2 Ht.
  assert (Jump : forall t v v', before p t v -> after p t v' -> energy P v' = energy P v).
  { intros t v v' Hb Ha. destruct (law P p Hm t) as [w [w' [Wb [Wa H]]]].
    assert (w = v) by (apply before_unique with p t; assumption). subst w.
    assert (w' = v') by (apply after_unique with p t; assumption). subst w'.
    destruct H as [->|[[_ [J [_ [_ [_ E]]]]]|[_ [J [_ [_ [_ E]]]]]]]; [reflexivity | exact E | exact E]. }
  refine (real_induction (fun t => forall v, after p t v -> energy P v = energy P v1) t1 t2 _ _ _ t2 _ v2 H2);
    [| | |lra].
  - intros v Hv. now rewrite (after_unique p t1 v v1 Hv H1).
  - intros m M Hb. destruct (law P p Hm m) as [_ [w [_ [Wa _]]]]. assert (Ew := Hb m ltac:(lra) w Wa).
    destruct Wa as [e [He Hl]]. exists (e / 2). split; [lra|]. intros s Hs v Hv.
    destruct (inside_flight p m w e s He Hl ltac:(lra)) as [_ Ws].
    now rewrite (after_unique p s v w Hv Ws).
  - intros m M Hb v Hv. destruct (law P p Hm m) as [w [_ [Wb _]]]. rewrite (Jump m w v Wb Hv).
    destruct Wb as [e [He Hl]]. set (d := Rmin e (m - t1)). assert (D1 : d <= e) by apply Rmin_l.
    assert (D2 : d <= m - t1) by apply Rmin_r. assert (D3 : 0 < d) by (apply Rmin_pos; lra).
    apply (Hb (m - d / 2)); [lra|]. exists (d / 2). split; [lra|]. intros s Hs.
    destruct (Hl s ltac:(lra)) as [A B]. destruct (Hl (m - d / 2) ltac:(lra)) as [A' B']. rewrite A, B, A', B'.
    split; ring.
Qed.

(** The upright rod, mass 2 below, falls and rises without turning: one collision, at the time 0. *)
Definition bouncing t := {| height := arm2 P + Rabs t; angle := PI / 2 |}.
Definition at_speed c := {| vy := c; om := 0 |}.
Lemma bouncing_before t : before bouncing t (at_speed (if Rle_dec t 0 then -1 else 1)).
Proof.
  destruct (Rle_dec t 0) as [L|L]; [exists 1 | exists t]; (split; [lra|]); intros s Hs; simpl; (split; [|ring]).
  - rewrite !Rabs_left1 by lra. ring.
  - rewrite !Rabs_pos_eq by lra. ring.
Qed.
Lemma bouncing_after t : after bouncing t (at_speed (if Rlt_dec t 0 then -1 else 1)).
Proof.
  destruct (Rlt_dec t 0) as [L|L]; [exists (- t) | exists 1]; (split; [lra|]); intros s Hs; simpl; (split; [|ring]).
  - rewrite !Rabs_left1 by lra. ring.
  - rewrite !Rabs_pos_eq by lra. ring.
Qed.
Lemma bouncing_heights t : y1 P (bouncing t) = arm1 P + arm2 P + Rabs t /\ y2 P (bouncing t) = Rabs t.
Proof. unfold y1, y2, bouncing; simpl. rewrite sin_PI2. split; ring. Qed.
Theorem bouncing_motion : motion P bouncing.
Proof.
  assert (A1 := arm1_pos P HP). assert (A2 := arm2_pos P HP).
  split; intros t; destruct (bouncing_heights t) as [E1 E2]; rewrite ?E1, ?E2; assert (0 <= Rabs t) by pos.
  - lra.
  - lra.
  - lra.
  - eexists. eexists. split; [apply bouncing_before|]. split; [apply bouncing_after|].
    destruct (Rtotal_order t 0) as [L|[->|L]].
    + left. destruct (Rle_dec t 0), (Rlt_dec t 0); try lra; reflexivity.
    + right. right. split; [apply Rabs_R0|]. destruct (Rle_dec 0 0), (Rlt_dec 0 0); try lra.
      unfold push2, bouncing; simpl. rewrite cos_PI2. exists (2 * mass P). assert (M := mass_pos P HP).
      unfold energy; simpl. repeat split; try lra; ring.
    + left. destruct (Rle_dec t 0), (Rlt_dec t 0); try lra; reflexivity.
Qed.
Theorem bouncing_once : at_least P bouncing 1 /\ at_most P bouncing 1.
Proof.
  assert (A1 := arm1_pos P HP). assert (A2 := arm2_pos P HP). split.
  - exists [0]. split; [now repeat constructor|]. split; [reflexivity|]. intros t [<-|[]].
    exists (at_speed (-1)). split.
    + assert (B := bouncing_before 0). destruct (Rle_dec 0 0); [exact B | lra].
    + right. split; [destruct (bouncing_heights 0) as [_ ->]; apply Rabs_R0|]. unfold w2, bouncing; simpl. lra.
  - intros l Hnd Hl. assert (Z : forall t, In t l -> t = 0).
    { intros t Ht. destruct (Hl t Ht) as [v [_ H]]. destruct (bouncing_heights t) as [E1 E2]. rewrite E1, E2 in H.
      assert (0 <= Rabs t) by pos. destruct H as [[H _]|[H _]]; [lra|].
      destruct (Req_dec t 0) as [|N]; [assumption | apply Rabs_no_R0 in N; lra]. }
    destruct l as [|a [|b l]]; simpl; try lia. exfalso. apply NoDup_cons_iff in Hnd. destruct Hnd as [Hn _]. apply Hn.
    rewrite (Z a), (Z b) by (simpl; tauto). now left.
Qed.
End Sanity.
