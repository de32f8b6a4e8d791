(** The statement: what a dumbbell, a motion, a collision and the bounds on their number are. Definitions only, to be
    read beside proofs/claim.md.

    Two point masses at the ends of a rigid massless rod, in a vertical plane, above a flat, frictionless, elastic floor
    at height 0; no gravity. The horizontal motion of the centre of mass is uniform and left out.

    dumbbell, pos, vel               == two masses and a rod; its height and angle; their velocities
    y1, y2, w1, w2, energy           == heights and vertical velocities of the masses, kinetic energy
    push, push1, push2               == what the floor does to a velocity, by an impulse on a mass
    motion, before, after            == a path that obeys the law; its velocity just before, just after a time
    collision, at_most, at_least     == a mass comes in; so many times and no more; so many times
    upper_bound, lower_bound, N_star == for all dumbbells of a ratio; N_star q N: N(q) = N *)
From Coq Require Import Reals List.
Local Open Scope R_scope.

Record dumbbell := { m1 : R; m2 : R; ell : R }.   (* the masses; the length of the rod *)
Definition real_dumbbell (P : dumbbell) := 0 < m1 P /\ 0 < m2 P /\ 0 < ell P.
Record pos := { height : R; angle : R }.   (* of the centre of mass; of the rod, from mass 2 to 1, to the horizontal *)
Record vel := { vy : R; om : R }.          (* their derivatives *)

Definition mass P := m1 P + m2 P.
Definition arm1 P := ell P * (m2 P / mass P).   (* distance of mass 1 from the centre of mass *)
Definition arm2 P := ell P * (m1 P / mass P).
Definition inertia P := m1 P * (arm1 P * arm1 P) + m2 P * (arm2 P * arm2 P).
Definition y1 P (s : pos) := height s + arm1 P * sin (angle s).   (* height of mass 1 *)
Definition y2 P (s : pos) := height s - arm2 P * sin (angle s).
Definition w1 P (s : pos) (v : vel) := vy v + arm1 P * cos (angle s) * om v.   (* its vertical velocity, d y1 / dt *)
Definition w2 P (s : pos) (v : vel) := vy v - arm2 P * cos (angle s) * om v.
Definition energy P (v : vel) := (mass P * (vy v * vy v) + inertia P * (om v * om v)) / 2.

(** The floor pushes a mass with a vertical impulse J >= 0 (no friction), whose lever is the horizontal distance of the
    mass from the centre of mass; the energy is kept (elastic). *)
Definition push P (lever : R) (v v' : vel) := exists J, 0 <= J /\
  mass P * (vy v' - vy v) = J /\ inertia P * (om v' - om v) = J * lever /\ energy P v' = energy P v.
Definition push1 P (s : pos) := push P (arm1 P * cos (angle s)).
Definition push2 P (s : pos) := push P (- (arm2 P * cos (angle s))).

(** The velocity just before and just after the time t: there the path is uniform for a while. *)
Definition before (p : R -> pos) t v := exists eps, 0 < eps /\ forall s, t - eps <= s <= t ->
  height (p s) = height (p t) + vy v * (s - t) /\ angle (p s) = angle (p t) + om v * (s - t).
Definition after (p : R -> pos) t v := exists eps, 0 < eps /\ forall s, t <= s <= t + eps ->
  height (p s) = height (p t) + vy v * (s - t) /\ angle (p s) = angle (p t) + om v * (s - t).

(** A regular motion, for all times: never below the floor, never both masses on it; free, but for pushes of the
    floor on a mass that touches it. *)
Record motion (P : dumbbell) (p : R -> pos) : Prop := {
  above1 : forall t, 0 <= y1 P (p t);
  above2 : forall t, 0 <= y2 P (p t);
  regular : forall t, ~ (y1 P (p t) = 0 /\ y2 P (p t) = 0);
  law : forall t, exists v v', before p t v /\ after p t v' /\
    (v' = v \/ (y1 P (p t) = 0 /\ push1 P (p t) v v') \/ (y2 P (p t) = 0 /\ push2 P (p t) v v')) }.

(** A collision: a mass touches the floor and comes in with a negative vertical velocity. *)
Definition collision P (p : R -> pos) t := exists v, before p t v /\
  ((y1 P (p t) = 0 /\ w1 P (p t) v < 0) \/ (y2 P (p t) = 0 /\ w2 P (p t) v < 0)).

(** Their number: of times t that are all different, at which there is a collision. *)
Definition at_most P p (N : nat) := forall l, NoDup l -> (forall t, In t l -> collision P p t) -> (length l <= N)%nat.
Definition at_least P p (N : nat) := exists l, NoDup l /\ length l = N /\ forall t, In t l -> collision P p t.

(** N_star q N: N is the greatest number of collisions of a motion of a dumbbell with the mass ratio q. *)
Definition upper_bound (q : R) (N : nat) := forall P p, real_dumbbell P -> m2 P / m1 P = q -> motion P p ->
  at_most P p N.
Definition lower_bound (q : R) (N : nat) := forall P, real_dumbbell P -> m2 P / m1 P = q ->
  exists p, motion P p /\ at_least P p N.
Definition N_star q N := upper_bound q N /\ lower_bound q N.
