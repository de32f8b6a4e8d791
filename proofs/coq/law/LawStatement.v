(** Statement: the law for every mass ratio (Theorems A and B of law.md), and conditions it is proved from (law.md, "What
    the certificate proves"): inequalities about single steps and about the first 902 ratios, none about an orbit. They
    are theorems, too: steps_hold, layer_holds and end_holds. Definitions only.

    growth, step_constant, law_constant == C, k0, c0
    cube, quarter           == (sqrt (n + 1) - sqrt n)^3; q^(-1/4)
    from_nine               == q is at least q_c(9)
    the_law                 == Theorem B: N = 2 + floor (C sqrt q), or less by a share c0 q^(-1/4) of a step
    law_everywhere          == its second half: 0.980 <= N - C sqrt q <= 2.115
    delta, log_constant, constant_of == delta_N at q = q_c(N), kappa, k_N
    law_with_logarithm      == Theorem A, of N and q = q_c(N)
    beta, invariant, clock  == beta, J, T of a contact at u from the peak, at the mid angle al
    clock_integral          == S
    step, last              == from a contact to the next one; from the last contact along the tangent flight
    middle, half, middle_invariant, defect == U, d, Q, D of a step
    difference, comparison, place == Delta, D0, y of a T (L57)
    steps, layer_defect, end_of_orbit == the conditions (C1) to (C4), (C6) and (C7), (C11) *)
From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Statement.
Local Open Scope R_scope.

Definition growth : R := RInt (fun a => sin (PI / 2 / cos a)) 0 (PI / 3).
Definition cube (n : nat) := (sqrt (INR (S n)) - sqrt (INR n)) ^ 3.
Definition step_constant := Rpower 3 (- (7 / 4)) * / sqrt PI.
Definition law_constant := 2 * step_constant * Series cube.   (* L55 (a): 12 |zeta(-1/2)| k0 *)
Definition quarter q := / sqrt (sqrt q).                      (* q^(-1/4) *)

(** q is at least the critical ratio q_c(9): every greater ratio has nine collisions. *)
Definition from_nine q := 1 <= q /\ forall p n, q < p -> N_star p n -> (9 <= n)%nat.
Definition the_law := forall q N, from_nine q -> N_star q N ->
  (2 + Int_part (growth * sqrt q - law_constant * quarter q) <= Z.of_nat N)%Z /\
  (Z.of_nat N <= 2 + Int_part (growth * sqrt q))%Z.
Definition law_everywhere := forall q N, 1 <= q -> N_star q N -> 0.980 <= INR N - growth * sqrt q <= 2.115.

(** Theorem A, where q is the critical ratio q_c(N). *)
Definition delta N q := growth * sqrt q - (INR N - 2).
Definition log_constant := 5 / (36 * sqrt 3 * PI).
Definition constant_of (N : nat) := if Nat.even N then 0.497 else 0.38.
Definition law_with_logarithm N q := let s := quarter q in
  Rabs (delta N q - (law_constant * s - log_constant * s^2 * ln q - constant_of N * s^2)) <= (0.072 + 2.6 * s) * s^2.

(** Contacts: eps = q^(-1/2); u is the distance of a contact from the peak, whose height is cos u; al is half the sum of
    the angles of the flights before and after it (L43), beta half their difference. *)
Definition beta eps u := atan (eps / sin u).
Definition invariant u al := (PI - u) * cos al.
Definition clock_integral J x : R := RInt (fun a => sin (J / cos a)) x (acos (J / PI)).
Definition clock eps u al : R := clock_integral (invariant u al) al / (2 * eps).

Record step (eps u al u' al' : R) : Prop := {
  eps_range : 0 < eps <= 1;
  contacts : 0 < u' < u /\ u <= PI/2;
  angles : 0 <= al /\ al' < PI/2;
  one_flight : al + beta eps u = al' - beta eps u';
  flight : cos u' - cos u = eps * tan (al + beta eps u) * (2 * PI - u - u') }.
(** The flight from the last contact is tangent to the hump, at y. *)
Record last (eps u al y : R) : Prop := {
  last_eps : 0 < eps <= 1;
  last_contact : 0 < y < u /\ u <= PI/2;
  last_angle : 0 <= al /\ al + beta eps u < PI/2;
  tangency : eps * tan (al + beta eps u) = sin y;
  last_flight : cos y - cos u = sin y * (2 * PI - u - y) }.

(** Of a step: U, d, the angle theta of its flight, Q, the defect D; the comparison function D0, and beside it Delta and
    y of L57. *)
Definition middle u u' := (u + u') / 2.
Definition half u u' := (u - u') / 2.
Definition middle_invariant eps u al u' := (PI - middle u u') * cos (al + beta eps u).
Definition defect eps u al u' al' := clock eps u al - 1 - clock eps u' al'.
Definition difference T := sqrt T - sqrt (T - 1).
Definition comparison eps T := step_constant * sqrt eps * difference T ^ 3.
Definition place eps T := sqrt (4 * sqrt 3 * PI) / 2 * sqrt eps / difference T.

(** (C1) to (C4): ratios a and b on either side of the critical ratio q_c(N), near to it. *)
Definition steps := forall N, (3 <= N <= 902)%nat -> exists a b, 1 <= a /\ 1 <= b /\
  (forall n, N_star a n -> (n < N)%nat) /\ (forall n, N_star b n -> (N <= n)%nat) /\
  ((9 <= N)%nat -> INR N - 2 < growth * sqrt a /\ growth * sqrt b - (INR N - 2) < law_constant * quarter b) /\
  -0.115 <= growth * sqrt a - (INR N - 2) /\ growth * sqrt b - (INR N - 2) <= 0.020.

(** (C6) and (C7): where U < 9/10, and d/U <= 1/5. That T > 1 there, (C5), and how J falls, (C8), is proved in LayerClock.v
    and LayerFalls.v. *)
Definition layer_defect := forall eps u al u' al', step eps u al u' al' -> eps <= 1/1000 ->
  let U := middle u u' in U <= 9/10 -> half u u' <= U / 5 ->
  PI/2 - 1/100 <= middle_invariant eps u al u' <= PI/2 + 1/20 ->
  PI/2 - 5.3 * eps^2 / u^3 <= invariant u al <= PI/2 + eps^2 / 4 ->
  let T := clock eps u al in let y := place eps T in let Delta := difference T in
  comparison eps T * (1 - y * (5 / (3 * PI) + 0.125 * y + 0.45 * Delta^2)) <= defect eps u al u' al' <=
    comparison eps T * (1 - y * (5 / (3 * PI) - 0.155 * y - 0.43 * Delta^2)).

(** (C11): what the clock shows at the last contact, beside k0 s. *)
Definition end_of_orbit := forall eps u al y, last eps u al y -> eps <= 1/1000 -> u <= 0.18 ->
  PI/2 - 0.1 * (u / 2) <= (PI - u / 2) * cos (al + beta eps u) <= PI/2 + 0.6 * (u / 2) ->
  PI/2 - 5.3 * eps^2 / u^3 <= invariant u al <= PI/2 + eps^2 / 4 ->
  Rabs (clock eps u al - 1 - step_constant * sqrt eps + 0.1657 * eps) <= (0.003 + 0.5 * (u / 2)) * eps.
