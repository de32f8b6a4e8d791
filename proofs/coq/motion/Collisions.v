(** Collisions of a motion: each changes the velocity by the law (1) of L0, there is a first one after any time, and n +
    1 later ones are one and n later than that.

    collision_law                      == at a collision the velocity is reflected by law (1)
    first_collision, no_collision_soon == there is a first one after any time, and none for a while
    later p t n                        == there are n collisions after the time t; later_next: one, and n - 1 after it
    no_heavy                           == the heavy mass never hits the floor
    after_unique                       == there is one velocity after a time *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics RealInduction LaterTimes Ray Flight.
Import ListNotations.
Local Open Scope R_scope.

Section Events.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.

Lemma after_unique p t v v' : after p t v -> after p t v' -> v = v'.
Proof.
  intros [e [He H]] [e' [He' H']]. set (d := Rmin e e'). assert (0 < d) by (apply Rmin_pos; assumption).
  assert (d <= e) by apply Rmin_l. assert (d <= e') by apply Rmin_r.
  destruct (H (t + d) ltac:(lra)) as [A B]. destruct (H' (t + d) ltac:(lra)) as [A' B'].
  symmetry. apply vel_eq; apply Rmult_eq_reg_r with d; lra.
Qed.

(** A point that moves down through height 0 is below it soon. *)
Lemma goes_below h a vy om A : h + A * sin a = 0 -> 0 < A -> vy + A * cos a * om < 0 -> forall eps, 0 < eps ->
  exists s, 0 < s <= eps /\ h + vy * s + A * sin (a + om * s) < 0.
Proof.
  intros H0 HA Hw eps He. set (w := vy + A * cos a * om) in *. set (k := A * (om * om) + 1).
  assert (Hk : 0 < k). { unfold k. assert (0 <= A * (om * om)) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]). lra. }
  assert (Hd : 0 < - w / k) by (apply Rdiv_lt_0_compat; lra).
  set (s := Rmin eps (- w / k)). assert (S1 : 0 < s) by (apply Rmin_pos; assumption).
  assert (S2 : s <= eps) by apply Rmin_l. assert (S3 : s <= - w / k) by apply Rmin_r.
  exists s. split; [lra|]. assert (B := sin_shift a (om * s)). apply Rabs_le_between in B.
  assert (S4 : s * k <= - w). { replace (- w) with (- w / k * k) by (field; lra). apply Rmult_le_compat_r; lra. }
  assert (S5 : s * (s * k) <= s * - w) by (apply Rmult_le_compat_l; lra).
  assert (A * sin (a + om * s) <= A * (sin a + om * s * cos a + om * s * (om * s))) by (apply Rmult_le_compat_l; lra).
  unfold w, k in *. assert (0 < s * s) by (apply Rmult_lt_0_compat; assumption). nra.
Qed.

Theorem collision_changes_velocity p t v : motion P p -> before p t v -> after p t v -> ~ collision P p t.
Proof.
  intros Hm Hb [e [He Ha]] [v0 [Hb0 H]]. assert (v0 = v) by (apply before_unique with p t; assumption). subst v0.
  destruct H as [[H0 Hw]|[H0 Hw]].
  - destruct (goes_below (height (p t)) (angle (p t)) (vy v) (om v) (arm1 P) H0 (arm1_pos P HP) Hw e He) as [s [Hs Hn]].
    destruct (Ha (t + s) ltac:(lra)) as [E1 E2]. replace (t + s - t) with s in * by ring.
    assert (K := above1 P p Hm (t + s)). unfold y1 in K. rewrite E1, E2 in K. lra.
  - destruct (goes_below (height (p t)) (angle (p t) + PI) (vy v) (om v) (arm2 P)) with (eps := e) as [s [Hs Hn]];
      try assumption.
    { rewrite neg_sin. unfold y2 in H0. lra. } { exact (arm2_pos P HP). } { rewrite neg_cos. unfold w2 in Hw. lra. }
    destruct (Ha (t + s) ltac:(lra)) as [E1 E2]. replace (t + s - t) with s in * by ring.
    assert (K := above2 P p Hm (t + s)). unfold y2 in K. rewrite E1, E2 in K.
    replace (angle (p t) + PI + om v * s) with (angle (p t) + om v * s + PI) in Hn by ring. rewrite neg_sin in Hn. lra.
Qed.

Lemma inside_flight p t0 v e t : 0 < e -> (forall s, t0 <= s <= t0 + e -> on_line p t0 v s) -> t0 < t < t0 + e ->
  before p t v /\ after p t v.
Proof.
  intros He H Ht. destruct (H t ltac:(lra)) as [A B]. split.
  - exists (t - t0). split; [lra|]. intros s Hs. destruct (H s ltac:(lra)). split; lra.
  - exists (t0 + e - t). split; [lra|]. intros s Hs. destruct (H s ltac:(lra)). split; lra.
Qed.
Lemma no_collision_soon p t0 v : motion P p -> after p t0 v -> exists e, 0 < e /\ forall t, t0 < t < t0 + e ->
  ~ collision P p t.
Proof.
  intros Hm [e [He Ha]]. exists e. split; [exact He|]. intros t Ht.
  destruct (inside_flight p t0 v e t He Ha Ht) as [A B]. now apply collision_changes_velocity with v.
Qed.

Theorem first_collision p t0 T : motion P p -> t0 < T -> collision P p T ->
  exists t1, t0 < t1 <= T /\ collision P p t1 /\ forall t, t0 < t < t1 -> ~ collision P p t.
Proof.
  intros Hm HT HcT. apply Classical_Prop.NNPP. intros No.
  assert (K : forall s, t0 <= s <= T -> s = t0 \/ ~ collision P p s); [|destruct (K T); [lra | lra | contradiction]].
  apply real_induction; [now left | |].
  - intros m M _. destruct (law P p Hm m) as [_ [v [_ [Ha _]]]].
    destruct (no_collision_soon p m v Hm Ha) as [e [He Hn]].
    exists (e / 2). split; [lra|]. intros s Hs. right. apply Hn. lra.
  - intros m M Hm0. right. intros Hc. apply No. exists m. split; [exact M|]. split; [exact Hc|].
    intros t Ht. destruct (Hm0 t ltac:(lra)); [lra | assumption].
Qed.

(** After a collision: the law (1) at that wall. *)
Theorem collision_law p t : motion P p -> collision P p t -> exists v v', before p t v /\ after p t v' /\
  ((y1 P (p t) = 0 /\ reflects P (slope1 (p t)) (u_of v) (v_of P v) (u_of v') (v_of P v')) \/
   (y2 P (p t) = 0 /\ reflects P (slope2 P (p t)) (u_of v) (v_of P v) (u_of v') (v_of P v'))).
Proof.
  intros Hm Hc. destruct (law P p Hm t) as [v [v' [Hb [Ha H]]]]. exists v, v'. split; [exact Hb|]. split; [exact Ha|].
  assert (Hne : v' <> v). { intros ->. exact (collision_changes_velocity p t v Hm Hb Ha Hc). }
  destruct H as [H|[[H0 H]|[H0 H]]]; [contradiction| |].
  - left. split; [exact H0|]. destruct (L0_reflection1 P HP _ _ _ H); [contradiction | assumption].
  - right. split; [exact H0|]. destruct (L0_reflection2 P HP _ _ _ H); [contradiction | assumption].
Qed.

(** At least n collisions after t0; and no collision with the heavy mass. *)
Definition later p := later_times (collision P p).

Lemma later_next p t0 n : motion P p -> later p t0 (S n) ->
  exists t1, t0 < t1 /\ collision P p t1 /\ (forall t, t0 < t < t1 -> ~ collision P p t) /\ later p t1 n.
Proof.
  intros Hm. apply later_times_next. intros T. now apply first_collision.
Qed.
Definition no_heavy p := forall t, collision P p t -> y2 P (p t) <> 0.
Lemma later_0 p t : later p t 0.
Proof. exists nil. repeat split; [constructor | contradiction | contradiction]. Qed.
End Events.
