(** Statement: motions on a stretch of time, and their ends. `Statement.v` speaks of motions for all times that never
    have both masses on the floor. Here a path need obey the law only at the times of an open stretch (a, b), where a
    and b are times or infinite; what it is outside is not looked at. So a motion may begin in a corner (both masses
    on the floor), end in one, or simply be watched for a while. The theorems are in `AnyMotion.v`; on paper they are
    L40.

    within, obeys, motion_within             == a time is in (a, b); the law at a time; a motion at the times of (a, b)
    at_most_within                           == at most N collisions in (a, b)
    flies_to, flies_from                     == flies freely just before T, just after T, and to or from that state
    both_down, ends_in_corner, begins_in_corner == both masses on the floor, at one end of the stretch
    whole                                    == a motion on (a, b) that goes on until it meets a corner, if at all
    motion_through                           == a motion that may pass through corners *)
From Coq Require Import Reals List.
From Coquelicot Require Import Rbar.
From Dumbbell Require Import Statement.
Local Open Scope R_scope.

(** The time t is in the stretch (a, b). *)
Definition within (a b : Rbar) (t : R) := Rbar_lt a (Finite t) /\ Rbar_lt (Finite t) b.

(** What `motion` demands, at one time: no mass below the floor, not both on it; a velocity before and one after, and
    they are the same unless the floor pushes a mass that touches it. *)
Definition obeys (P : dumbbell) (p : R -> pos) (t : R) := 0 <= y1 P (p t) /\ 0 <= y2 P (p t) /\
  ~ (y1 P (p t) = 0 /\ y2 P (p t) = 0) /\
  exists v v', before p t v /\ after p t v' /\
    (v' = v \/ (y1 P (p t) = 0 /\ push1 P (p t) v v') \/ (y2 P (p t) = 0 /\ push2 P (p t) v v')).

(** A motion on the stretch (a, b), and its number of collisions there. *)
Definition motion_within P a b p := forall t, within a b t -> obeys P p t.
Definition at_most_within P a b p (N : nat) :=
  forall l, NoDup l -> (forall t, In t l -> within a b t /\ collision P p t) -> (length l <= N)%nat.

(** Just before the time T the dumbbell flies uniformly, and it arrives at the position s at T; just after T, and it
    comes from s. (That the path has the position s at T itself is not asked for: T is not in the stretch.) *)
Definition flies_to (p : R -> pos) T s := exists v e, 0 < e /\ forall t, T - e < t < T ->
  height (p t) = height s + vy v * (t - T) /\ angle (p t) = angle s + om v * (t - T).
Definition flies_from (p : R -> pos) T s := exists v e, 0 < e /\ forall t, T < t < T + e ->
  height (p t) = height s + vy v * (t - T) /\ angle (p t) = angle s + om v * (t - T).

(** It runs into a corner at the end b of the stretch; it comes out of one at its beginning a. *)
Definition both_down P s := y1 P s = 0 /\ y2 P s = 0.
Definition ends_in_corner P p (b : Rbar) := exists T s, b = Finite T /\ both_down P s /\ flies_to p T s.
Definition begins_in_corner P p (a : Rbar) := exists T s, a = Finite T /\ both_down P s /\ flies_from p T s.

(** A whole motion: it lasts for ever, or until it runs into a corner; and the same backwards. *)
Definition whole P a b p := motion_within P a b p /\
  (b = p_infty \/ ends_in_corner P p b) /\ (a = m_infty \/ begins_in_corner P p a).

(** A motion that may pass through corners, too. There the law does not say which way it goes on: it has a velocity
    before and one after, of the same energy, and that is all. (At rest in a corner the energy is 0.) *)
Definition turns_in_corner P p t := both_down P (p t) /\
  exists v v', before p t v /\ after p t v' /\ energy P v' = energy P v.
Definition motion_through P a b p := forall t, within a b t -> obeys P p t \/ turns_in_corner P p t.
