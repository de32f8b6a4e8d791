(** Statement: the billiards in the source paper's straight wedge and hybrid wedge (L17, L18), in the coordinates of L0:
    there the dumbbell is a point (psi, yhat) above a floor, with a kinetic energy proportional to psi'^2 + q yhat'^2.
    Here the floor is made of two walls: one to the right, and its mirror image. Definitions only.

    point, wall, side == a point (psi, yhat) or its velocity; a wall's height and slope; right or left: 1 or -1
    straight, hump == the two wedges
    above, on, slope_at == above a wall, on it, its slope
    push, energy, motion, collision == as in the statement
    at_most, at_least, greatest == so many collisions and no more; so many; the greatest number *)
From Coq Require Import Reals List.
Local Open Scope R_scope.

Record point := { psi : R; yhat : R }.   (* a position, or a velocity *)

(** The wall to the right: its height above each psi, and its slope there. *)
Record wall := { rise : R -> R; slope : R -> R }.

(** The straight wedge: the tangent of the right hump at the corner; with its mirror image the floor |psi| - pi/2. *)
Definition straight := {| rise := fun x => x - PI/2; slope := fun _ => 1 |}.

(** The hybrid wedge: the hump - cos psi itself where that is positive, from pi/2 to 3 pi/2; its tangents below. *)
Definition hump := {|
  rise := fun x => if Rle_dec x (PI/2) then x - PI/2 else if Rle_dec x (3*(PI/2)) then - cos x else 3*(PI/2) - x;
  slope := fun x => if Rle_dec x (PI/2) then 1 else if Rle_dec x (3*(PI/2)) then sin x else - 1 |}.

(** The two walls of a wedge are its sides s = 1, to the right, and s = -1, the mirror image. *)
Definition side (s : R) := s = 1 \/ s = -1.
Definition above W s x := rise W (s * psi x) <= yhat x.
Definition on W s x := yhat x = rise W (s * psi x).
Definition slope_at W s x := s * slope W (s * psi x).

(** A wall of slope w pushes away from itself, at a right angle to the wall in the metric, and keeps the energy. *)
Definition energy q v := (psi v * psi v + q * (yhat v * yhat v)) / 2.
Definition push q w v v' := exists j, 0 <= j /\
  psi v' - psi v = - (q * w * j) /\ yhat v' - yhat v = j /\ energy q v' = energy q v.

(** The velocity just before and just after the time t: there the path is uniform for a while. *)
Definition before (p : R -> point) t v := exists eps, 0 < eps /\ forall s, t - eps <= s <= t ->
  psi (p s) = psi (p t) + psi v * (s - t) /\ yhat (p s) = yhat (p t) + yhat v * (s - t).
Definition after (p : R -> point) t v := exists eps, 0 < eps /\ forall s, t <= s <= t + eps ->
  psi (p s) = psi (p t) + psi v * (s - t) /\ yhat (p s) = yhat (p t) + yhat v * (s - t).

(** A regular motion, for all times: below neither wall, never on both; free, but for pushes of a wall. *)
Record motion W (q : R) (p : R -> point) : Prop := {
  stays : forall s t, side s -> above W s (p t);
  regular : forall t, ~ (on W 1 (p t) /\ on W (-1) (p t));
  law : forall t, exists v v', before p t v /\ after p t v' /\
    (v' = v \/ exists s, side s /\ on W s (p t) /\ push q (slope_at W s (p t)) v v') }.

(** A collision: the point comes to a wall from above, and not along it. *)
Definition collision W (p : R -> point) t := exists v, before p t v /\
  exists s, side s /\ on W s (p t) /\ yhat v < slope_at W s (p t) * psi v.

(** N is the greatest number of collisions of a motion. *)
Definition at_most W p (N : nat) := forall l, NoDup l -> (forall t, In t l -> collision W p t) -> (length l <= N)%nat.
Definition at_least W p (N : nat) := exists l, NoDup l /\ length l = N /\ forall t, In t l -> collision W p t.
Definition greatest W q N := (forall p, motion W q p -> at_most W p N) /\ (exists p, motion W q p /\ at_least W p N).
