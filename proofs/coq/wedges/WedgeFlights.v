(** In a wedge whose walls are concave graphs: a collision changes the velocity by law (1) of L0, there is a first one
    after any time, and up to it the point flies uniformly.

    concave_wall                       == what is asked of a wall
    collision_law, flight              == law (1) at a collision; up to it the point moves uniformly
    first_collision, later, later_next == as in Collisions.v *)
From Coq Require Import Reals Lra Lia List.
From Dumbbell Require Import RealInduction LaterTimes Wedge.
Import ListNotations.
Local Open Scope R_scope.

(** What the proofs need of a wall. *)
Record concave_wall (W : wall) : Prop := {
  slope_bound : forall x, -1 <= slope W x <= 1;
  below_tangent : forall x d, rise W (x + d) <= rise W x + slope W x * d;
  near_tangent : forall x d, rise W x + slope W x * d - d * d <= rise W (x + d);
  rises : forall x, 0 <= x -> rise W (- x) <= rise W x }.

Lemma point_eq a b : psi a = psi b -> yhat a = yhat b -> a = b.
Proof. destruct a, b; simpl; congruence. Qed.
Lemma side_square s : side s -> s * s = 1.
Proof. intros [->| ->]; ring. Qed.

(** Along the line with velocity v from p t0. *)
Definition on_line (p : R -> point) t0 v t :=
  psi (p t) = psi (p t0) + psi v * (t - t0) /\ yhat (p t) = yhat (p t0) + yhat v * (t - t0).

Lemma before_unique p t v v' : before p t v -> before p t v' -> v = v'.
Proof.
  intros [e [He H]] [e' [He' H']]. set (d := Rmin e e'). assert (0 < d) by (apply Rmin_pos; assumption).
  assert (d <= e) by apply Rmin_l. assert (d <= e') by apply Rmin_r.
  destruct (H (t - d) ltac:(lra)) as [A B]. destruct (H' (t - d) ltac:(lra)) as [A' B'].
  symmetry. apply point_eq; apply Rmult_eq_reg_r with d; lra.
Qed.
Lemma after_unique p t v v' : after p t v -> after p t v' -> v = v'.
Proof.
  intros [e [He H]] [e' [He' H']]. set (d := Rmin e e'). assert (0 < d) by (apply Rmin_pos; assumption).
  assert (d <= e) by apply Rmin_l. assert (d <= e') by apply Rmin_r.
  destruct (H (t + d) ltac:(lra)) as [A B]. destruct (H' (t + d) ltac:(lra)) as [A' B'].
  symmetry. apply point_eq; apply Rmult_eq_reg_r with d; lra.
Qed.

(** A push that changes the velocity meets a point that comes in. *)
Lemma push_cases q w v v' : 0 < q -> push q w v v' -> v' = v \/ exists j, 0 < j /\
  psi v' = psi v - q * w * j /\ yhat v' = yhat v + j /\ j * (1 + q * (w * w)) = 2 * (w * psi v - yhat v).
Proof.
  intros Hq [j [Hj [A [U E]]]]. destruct (Req_dec j 0) as [Z|Z].
  - left. rewrite Z, ?Rmult_0_r in A. apply point_eq; lra.
  - right. exists j. split; [lra|]. split; [lra|]. split; [lra|].
    assert (A' : psi v' = psi v - q * w * j) by lra. assert (U' : yhat v' = yhat v + j) by lra.
    unfold energy in E. rewrite A', U' in E. apply Rmult_eq_reg_l with (q * j); [lra|].
    apply Rmult_integral_contrapositive. split; lra.
Qed.

Section Flights.
Variables (W : wall) (q : R).
Hypothesis HW : concave_wall W.
Hypothesis Hq : 0 < q.

(** A point that comes to a wall and goes on as before is below it soon. *)
Lemma goes_below s x u v eps : side s -> u = rise W (s * x) -> yhat v < s * slope W (s * x) * psi v -> 0 < eps ->
  exists d, 0 < d <= eps /\ u + yhat v * d < rise W (s * (x + psi v * d)).
Proof.
  intros Hs Hu Hv He. set (a := s * psi v) in *. set (g := slope W (s * x) * a - yhat v).
  assert (Hg : 0 < g) by (unfold g, a; lra).
  assert (Ha : 0 < a * a + 1) by (assert (0 <= a * a) by apply Rle_0_sqr; lra).
  assert (Hd : 0 < g / (a * a + 1)) by (now apply Rdiv_lt_0_compat).
  set (d := Rmin eps (g / (a * a + 1))). assert (D1 : 0 < d) by (now apply Rmin_pos).
  assert (D2 : d <= eps) by apply Rmin_l. assert (D3 : d <= g / (a * a + 1)) by apply Rmin_r.
  exists d. split; [lra|]. assert (N := near_tangent W HW (s * x) (a * d)).
  replace (s * (x + psi v * d)) with (s * x + a * d) by (unfold a; ring).
  assert (d * (a * a + 1) <= g).
  { replace g with (g / (a * a + 1) * (a * a + 1)) by (field; lra). apply Rmult_le_compat_r; lra. }
  assert (d * (a * a * d) < d * g) by (apply Rmult_lt_compat_l; lra). unfold g in *. lra.
Qed.
Theorem collision_changes_velocity p t v : motion W q p -> before p t v -> after p t v -> ~ collision W p t.
Proof.
  intros Hm Hb [e [He Ha]] [v0 [Hb0 [s [Hs [Ho Hw]]]]].
  assert (v0 = v) by (apply before_unique with p t; assumption). subst v0.
  destruct (goes_below s (psi (p t)) (yhat (p t)) v e Hs Ho Hw He) as [d [Hd Hn]].
  destruct (Ha (t + d) ltac:(lra)) as [E1 E2]. replace (t + d - t) with d in * by ring.
  assert (K := stays W q p Hm s (t + d) Hs). unfold above in K. rewrite E1, E2 in K. lra.
Qed.

Lemma no_collision_soon p t0 v : motion W q p -> after p t0 v -> exists e, 0 < e /\ forall t, t0 < t < t0 + e ->
  ~ collision W p t.
Proof.
  intros Hm [e [He H]]. exists e. split; [exact He|]. intros t Ht. destruct (H t ltac:(lra)) as [A B].
  apply collision_changes_velocity with v; [assumption | |].
  - exists (t - t0). split; [lra|]. intros s Hs. destruct (H s ltac:(lra)). split; lra.
  - exists (t0 + e - t). split; [lra|]. intros s Hs. destruct (H s ltac:(lra)). split; lra.
Qed.
Theorem first_collision p t0 T : motion W q p -> t0 < T -> collision W p T ->
  exists t1, t0 < t1 <= T /\ collision W p t1 /\ forall t, t0 < t < t1 -> ~ collision W p t.
Proof.
  intros Hm HT HcT. apply Classical_Prop.NNPP. intros No.
  assert (K : forall s, t0 <= s <= T -> s = t0 \/ ~ collision W p s); [|destruct (K T); [lra | lra | contradiction]].
  apply real_induction; [now left | |].
  - intros m M _. destruct (law W q p Hm m) as [_ [v [_ [Ha _]]]].
    destruct (no_collision_soon p m v Hm Ha) as [e [He Hn]].
    exists (e / 2). split; [lra|]. intros s Hs. right. apply Hn. lra.
  - intros m M Hm0. right. intros Hc. apply No. exists m. split; [exact M|]. split; [exact Hc|].
    intros t Ht. destruct (Hm0 t ltac:(lra)); [lra | assumption].
Qed.

(** Where there is no collision, the velocity does not change. *)
Lemma no_collision_keeps p t v : motion W q p -> ~ collision W p t -> before p t v -> after p t v.
Proof.
  intros Hm Hn Hb. destruct (law W q p Hm t) as [u [u' [Hb' [Ha H]]]].
  assert (u = v) by (apply before_unique with p t; assumption). subst u.
  destruct H as [->|[s [Hs [Ho H]]]]; [exact Ha|].
  destruct (push_cases q _ v u' Hq H) as [->|[j [J [_ [_ E]]]]]; [exact Ha|]. exfalso. apply Hn. exists v.
  split; [exact Hb|]. exists s. split; [exact Hs|]. split; [exact Ho|].
  assert (0 < j * (1 + q * (slope_at W s (p t) * slope_at W s (p t)))); [|lra].
  apply Rmult_lt_0_compat; [exact J|]. assert (0 <= slope_at W s (p t) * slope_at W s (p t)) by apply Rle_0_sqr.
  assert (0 <= q * (slope_at W s (p t) * slope_at W s (p t))) by (apply Rmult_le_pos; lra). lra.
Qed.

(** Up to the next collision the point flies uniformly. *)
Lemma flight p t0 t1 v : motion W q p -> t0 < t1 -> after p t0 v -> (forall t, t0 < t < t1 -> ~ collision W p t) ->
  forall t, t0 <= t <= t1 -> on_line p t0 v t.
Proof.
  intros Hm Ht [e [He Ha]] Hn. apply real_induction.
  - split; ring.
  - intros m M Hl. destruct (Req_dec m t0) as [->|N]. { exists e. split; [exact He|]. intros s Hs. apply Ha. lra. }
    assert (Hb : before p m v).
    { exists (m - t0). split; [lra|]. intros s Hs. destruct (Hl s ltac:(lra)), (Hl m ltac:(lra)). split; lra. }
    destruct (no_collision_keeps p m v Hm (Hn m ltac:(lra)) Hb) as [d [Hd Hd']]. exists d. split; [exact Hd|].
    intros s Hs. destruct (Hd' s ltac:(lra)), (Hl m ltac:(lra)). split; lra.
  - intros m M Hl. destruct (law W q p Hm m) as [u [_ [[d [Hd Hb]] _]]].
    set (a := Rmin d (m - t0)). assert (0 < a) by (apply Rmin_pos; lra). assert (a <= d) by apply Rmin_l.
    assert (a <= m - t0) by apply Rmin_r.
    destruct (Hb (m - a) ltac:(lra)) as [B1 B2], (Hb (m - a / 2) ltac:(lra)) as [C1 C2].
    destruct (Hl (m - a) ltac:(lra)) as [B3 B4], (Hl (m - a / 2) ltac:(lra)) as [C3 C4]. split; lra.
Qed.
Lemma flight_before p t0 t1 v : t0 < t1 -> (forall t, t0 <= t <= t1 -> on_line p t0 v t) -> before p t1 v.
Proof.
  intros Ht H. exists (t1 - t0). split; [lra|]. intros s Hs. destruct (H s ltac:(lra)), (H t1 ltac:(lra)). split; lra.
Qed.

(** The law (1) at the wall. *)
Theorem collision_law p t v : motion W q p -> collision W p t -> before p t v -> exists v' s j, after p t v' /\
  side s /\ on W s (p t) /\ 0 < j /\ let w := slope_at W s (p t) in
  psi v' = psi v - q * w * j /\ yhat v' = yhat v + j /\ j * (1 + q * (w * w)) = 2 * (w * psi v - yhat v).
Proof.
  intros Hm Hc Hb. destruct (law W q p Hm t) as [u [v' [Hb' [Ha H]]]].
  assert (u = v) by (apply before_unique with p t; assumption). subst u.
  assert (Hne : v' <> v) by (intros ->; exact (collision_changes_velocity p t v Hm Hb Ha Hc)).
  destruct H as [H|[s [Hs [Ho H]]]]; [contradiction|].
  destruct (push_cases q _ v v' Hq H) as [H'|[j [J [A [U E]]]]]; [contradiction|].
  exists v', s, j. repeat split; assumption.
Qed.

(** A point on one side is strictly on that side of the vertex. *)
Lemma on_side p t s : motion W q p -> side s -> on W s (p t) -> 0 < s * psi (p t).
Proof.
  intros Hm Hs Ho. apply Rnot_le_lt. intros L. assert (R := rises W HW (- (s * psi (p t))) ltac:(lra)).
  rewrite Ropp_involutive in R. assert (S' : side (- s)) by (destruct Hs as [->| ->]; [right | left]; ring).
  assert (A := stays W q p Hm (- s) t S'). unfold above, on in *.
  replace (- s * psi (p t)) with (- (s * psi (p t))) in A by ring.
  apply (regular W q p Hm t). unfold on. destruct Hs as [->| ->]; split;
    repeat match goal with |- context [?a * psi (p t)] => progress ring_simplify (a * psi (p t)) end;
    repeat match goal with H : context [rise W ?a] |- _ => progress ring_simplify a in H end; lra.
Qed.

(** At least n collisions after t0. *)
Definition later p := later_times (collision W p).
Lemma later_next p t0 n : motion W q p -> later p t0 (S n) ->
  exists t1, t0 < t1 /\ collision W p t1 /\ (forall t, t0 < t < t1 -> ~ collision W p t) /\ later p t1 n.
Proof.
  intros Hm. apply later_times_next. intros T. now apply first_collision.
Qed.
End Flights.
