(** The theorems of README.md's table again, each proved by its namesake. Nothing of this proof is taken in by its short
    name but the statement, and no word or notation is added (`assumptions` sees to that): what is not of Statement.v or
    of Coq's real numbers has the name of its file before it. So no other file can change what a sentence here says. *)
From Coq Require Import Reals.
From Dumbbell.statement Require Import Statement.
From Dumbbell.corners Require AnyMotion ForEver StartInContact.
From Dumbbell.checker Require ByLaw.
From Dumbbell.exact Require CriticalRatios Decided ExactMaximum ExplicitBounds HeavyOnce LeftLimit
  Monotone NoHeavy OpenSet PublishedBound Tangency WhereEqual.
From Dumbbell.full Require FollowFlight FullTotal.
From Dumbbell.law Require Bases DecidedByLaw Falls FirstSteps GrowthSeries Law LawStatement Orbit.
From Dumbbell.lower Require WitnessMotion.
From Dumbbell.motion Require Determinism EveryState NoAccumulation.
From Dumbbell.statement Require FreeFlight Newton Paper.
From Dumbbell.theorems Require EqualMasses Exchange Maximum Piece Sanity Scaling Verdict.
From Dumbbell.upper Require AtMostOnce LightTotal.
From Dumbbell.wedges Require WedgeMaximum WedgeSanity.
Local Open Scope R_scope.

Theorem N_exists : forall q : R, 1 <= q -> exists n : nat, N_star q n /\ INR n < q + 5.
Proof. exact Maximum.N_exists. Qed.
Theorem N_unique : forall (q : R) (m n : nat), 0 < q -> N_star q m -> N_star q n -> m = n.
Proof. exact Maximum.N_unique. Qed.
Theorem only_ratio : forall (q : R) (P : dumbbell) (p : R -> pos) (n : nat), real_dumbbell P -> m2 P / m1 P = q ->
  motion P p -> at_least P p n -> lower_bound q n.
Proof. exact Scaling.only_ratio. Qed.
Theorem N_inverse : forall (q : R) (n : nat), 0 < q -> N_star q n -> N_star (/ q) n.
Proof. exact Exchange.N_inverse. Qed.
Theorem L7_equal_masses : N_star 1 2.
Proof. exact EqualMasses.L7_equal_masses. Qed.
Theorem full_upper : forall (q : R) (n : nat), 1 <= q -> Forward.contact_bound (/ q) n -> Forward.departure_bound (/
  q) n -> upper_bound q n.
Proof. exact FullTotal.full_upper. Qed.
Theorem L15_follow : forall P : dumbbell, real_dumbbell P -> Flight.r_of P <= 1 -> forall (n : nat) (p : R -> pos) (t0
  : R) (v : vel) (x k : R), motion P p -> FollowFlight.leaves_R P p t0 v x k -> Collisions.later P p t0 n ->
  Forward.forward (Flight.r_of P) n x k.
Proof. exact FollowFlight.L15_follow. Qed.
Theorem L16_contact_slope : forall P : dumbbell, real_dumbbell P -> forall t u v u' v' k : R, Flight.reflects P (-
  (Flight.r_of P * cos t)) u v u' v' -> u < 0 -> k * - u = v -> u' < 0 -> 0 < Forward.contact_den (cos t) k
  (Flight.r_of P) /\ v' / - u' * Forward.contact_den (cos t) k (Flight.r_of P) = Forward.contact_num (cos t) k
  (Flight.r_of P).
Proof. exact FollowFlight.L16_contact_slope. Qed.
Theorem charts_upper : forall (q : R) (n : nat), 1 <= q -> Chart.bridge_bound (/ q) n -> Chart.light_bound (/ q) n ->
  upper_bound q n.
Proof. exact LightTotal.charts_upper. Qed.
Theorem charts_lower : forall (q : R) (n : nat), 1 <= q -> Chart.bridge_witness (/ q) n -> lower_bound q n.
Proof. exact WitnessMotion.charts_lower. Qed.
Theorem piece_sound : forall (P : Certificate.piece) (again : bool), Check.piece_fault again P = None -> forall q : R,
  Piece.in_piece P q -> 1 <= q /\
  (forall (U : N) (c : Certificate.cover), Certificate.bound P = Some (U, c) -> upper_bound q (N.to_nat U))
  /\ lower_bound q (N.to_nat (Certificate.attained P)).
Proof. exact Piece.piece_sound. Qed.
Theorem verdict_sound : forall (t : list String.string) (sha256 : String.string) (d : Check.demand) (c :
  Certificate.certificate), Reader.judge t sha256 d = Reader.Verified c -> t = Text.file_text c sha256 /\
  Verdict.proved d c.
Proof. exact Verdict.verdict_sound. Qed.
Theorem all_parts : forall (d : Check.demand) (c : Certificate.certificate), Check.joined (Certificate.range_from c)
  (Certificate.pieces c) (Certificate.range_to c) = true -> Certificate.pieces c <> nil -> Verdict.faultless
  (Certificate.pieces c) = true -> Check.unproved d c = None -> Check.certificate_fault true d c = None.
Proof. exact Verdict.all_parts. Qed.
Theorem N_of_10 : N_star 10 4.
Proof. exact Verdict.N_of_10. Qed.
Theorem decided_by_orbits : forall (v w : Decide.numbers) (c : Decide.claim), Decide.holds v w c = true ->
  Decided.says c.
Proof. exact Decided.decided_by_orbits. Qed.
Theorem bases_hold : Bases.bases.
Proof. exact Bases.bases_hold. Qed.
Theorem found_true : forall (c : Decide.claim) (v w : Decide.numbers), Decide.settle c = Decide.True_by v w ->
  Decided.says c.
Proof. exact Decided.found_true. Qed.
Theorem found_false : forall (c : Decide.claim) (q : Certificate.ratio) (n : N) (reached : bool), Decide.settle c =
  Decide.False_at q n reached -> Decided.in_range c (Certificate.ratio_value q) /\ (if reached then
  ExactMaximum.N_at_least (Certificate.ratio_value q) (N.to_nat n) /\ (exists m : N, Decide.claimed_most c = Some m /\
  (m < n)%N) else Decide.claimed_least c = Some n /\ ~ ExactMaximum.N_at_least (Certificate.ratio_value q) (N.to_nat
  n)).
Proof. exact Decided.found_false. Qed.
Theorem N_is_2_k0_k1 : forall (q : R) (k0 k1 : nat), 1 <= q -> Orbits.top_orbit q k0 -> Orbits.corner_orbit q k1 ->
  N_star q (2 + k0 + k1).
Proof. exact ExactMaximum.N_is_2_k0_k1. Qed.
Theorem theorem_1 : forall q : R, 1 <= q -> exists k0 k1 : nat, Orbits.top_orbit q k0 /\ Orbits.corner_orbit q k1 /\
  (k0 = k1 \/ k0 = S k1) /\ (forall n : nat, N_star q n <-> n = (2 + k0 + k1)%nat).
Proof. exact ExactMaximum.theorem_1. Qed.
Theorem theorem_1b : forall (q : R) (n : nat) (P : dumbbell) (p : R -> pos), 1 <= q -> N_star q n -> real_dumbbell P
  -> m2 P / m1 P = q -> motion P p -> at_least P p n -> exists ! T : R, collision P p T /\ y2 P (p T) = 0.
Proof. exact HeavyOnce.theorem_1b. Qed.
Theorem theorem_1c_open : forall (q : R) (n : nat) (e eta : R), 1 <= q -> 0 < e < PI / 2 -> 0 < eta ->
  OpenSet.contact_with q e eta n -> exists d : R, 0 < d /\ (forall e' eta' : R, e - d < e' < e + d -> eta - d < eta' <
  eta + d -> OpenSet.contact_with q e' eta' n).
Proof. exact OpenSet.theorem_1c_open. Qed.
Theorem theorem_1c_not_empty : forall (q : R) (n : nat), 1 <= q -> N_star q n -> exists e eta : R, 0 < e < PI / 2 /\ 0
  < eta /\ OpenSet.contact_with q e eta n.
Proof. exact OpenSet.theorem_1c_not_empty. Qed.
Theorem L6c_heavy_at_most_once : forall P : dumbbell, real_dumbbell P -> Flight.r_of P <= 1 -> forall (p : R -> pos)
  (T T' : R), motion P p -> collision P p T -> y2 P (p T) = 0 -> collision P p T' -> y2 P (p T') = 0 -> T = T'.
Proof. exact AtMostOnce.L6c_heavy_at_most_once. Qed.
Theorem L24_no_heavy : forall P : dumbbell, real_dumbbell P -> Flight.r_of P <= 1 -> forall k0 k1 : nat, (forall n :
  nat, Ray.coll (Flight.r_of P) n (Flight.r_of P) 0 -> (n <= k0)%nat) -> (forall n : nat, Ray.coll (Flight.r_of P) n
  (PI * Flight.r_of P) (Flight.r_of P) -> (n <= k1)%nat) -> forall p : R -> pos, motion P p -> Collisions.no_heavy P p
  -> at_most P p (1 + k0 + k1).
Proof. exact NoHeavy.L24_no_heavy. Qed.
Theorem N_monotone : forall (q q' : R) (n n' : nat), 1 <= q -> q <= q' -> N_star q n -> N_star q' n' -> (n <= n')%nat.
Proof. exact Monotone.N_monotone. Qed.
Theorem N_unbounded : forall N : nat, exists q0 : R, 1 <= q0 /\ (forall q : R, q0 <= q -> ExactMaximum.N_at_least q
  N).
Proof. exact Monotone.N_unbounded. Qed.
Theorem theorem_2b : forall N : nat, (3 <= N)%nat -> exists ! qc : R, CriticalRatios.critical N qc.
Proof. exact CriticalRatios.theorem_2b. Qed.
Theorem N_at_critical : forall (N : nat) (qc : R), (3 <= N)%nat -> CriticalRatios.critical N qc -> N_star qc (N - 1).
Proof. exact CriticalRatios.N_at_critical. Qed.
Theorem critical_increasing : forall (N : nat) (a b : R), (3 <= N)%nat -> CriticalRatios.critical N a ->
  CriticalRatios.critical (S N) b -> a < b.
Proof. exact CriticalRatios.critical_increasing. Qed.
Theorem theorem_2c_odd : forall (q : R) (k : nat), 1 <= q -> CriticalRatios.critical (1 + 2 * S k) q <-> (exists a b :
  R, Tangency.state (/ q) k (/ q) 0 a b /\ Tangency.tangent a b).
Proof. exact LeftLimit.theorem_2c_odd. Qed.
Theorem theorem_2c_even : forall (q : R) (k : nat), 1 <= q -> CriticalRatios.critical (2 + 2 * S k) q <-> (exists a b
  : R, Tangency.state (/ q) k (PI * / q) (/ q) a b /\ Tangency.tangent a b).
Proof. exact LeftLimit.theorem_2c_even. Qed.
Theorem critical_3 : CriticalRatios.critical 3 1.
Proof. exact CriticalRatios.critical_3. Qed.
Theorem critical_4 : forall x : R, PI < x < 3 * (PI / 2) -> tan x = x -> CriticalRatios.critical 4 (sqrt (1 + x * x)).
Proof. exact Tangency.critical_4. Qed.
Theorem theorem_3a : forall (q : R) (n m : nat), 1 <= q -> N_star q n -> PublishedBound.is_ceiling (PI /
  PublishedBound.gamma q) m -> (n <= m)%nat.
Proof. exact PublishedBound.theorem_3a. Qed.
Theorem published_bound_never_attained : forall (q : R) (m : nat), 1 <= q -> PublishedBound.is_ceiling (PI /
  PublishedBound.gamma q) m -> ~ N_star q (m + 1).
Proof. exact PublishedBound.published_bound_never_attained. Qed.
Theorem theorem_3b : forall (q : R) (n : nat) (qc : R), 1 <= q -> N_star q n -> CriticalRatios.critical 4 qc ->
  PublishedBound.is_ceiling (PI / PublishedBound.gamma q) n <-> q <= 3 \/ qc < q <= 3 + 2 * sqrt 2.
Proof. exact WhereEqual.theorem_3b. Qed.
Theorem theorem_3c : forall (q : R) (n : nat), 1 <= q -> N_star q n -> INR n < 2 + 2 * sqrt (q / PI).
Proof. exact ExplicitBounds.theorem_3c. Qed.
Theorem L17_straight_wedge : forall (q : R) (N : nat), 0 < q -> PublishedBound.is_ceiling (PI / PublishedBound.gamma
  q) N -> Wedge.greatest Wedge.straight q N.
Proof. exact WedgeMaximum.L17_straight_wedge. Qed.
Theorem L18_hybrid_wedge : forall (q : R) (N : nat), 0 < q -> PublishedBound.is_ceiling (PI / PublishedBound.gamma q)
  N -> Wedge.greatest Wedge.hump q N.
Proof. exact WedgeMaximum.L18_hybrid_wedge. Qed.
Theorem L18_same_maximum : forall (q : R) (N : nat), 0 < q -> Wedge.greatest Wedge.straight q N <-> Wedge.greatest
  Wedge.hump q N.
Proof. exact WedgeMaximum.L18_same_maximum. Qed.
Theorem dumbbell_at_most_hybrid : forall (q : R) (n N : nat), 1 <= q -> N_star q n -> Wedge.greatest Wedge.hump q N ->
  (n <= N)%nat.
Proof. exact WedgeMaximum.dumbbell_at_most_hybrid. Qed.
Theorem push_is_law_1 : forall (q w : R) (v v' : Wedge.point), 0 < q -> Wedge.yhat v < w * Wedge.psi v -> v' <> v ->
  Wedge.push q w v v' <-> v' = WedgeSanity.law_1 (/ q) w v.
Proof. exact WedgeSanity.push_is_law_1. Qed.
Theorem gamma_is_the_angle : forall q : R, 0 < q -> let a := {| Wedge.psi := 1; Wedge.yhat := 1 |} in let b := {|
  Wedge.psi := -1; Wedge.yhat := 1 |} in WedgeSanity.dot q a b = cos (PublishedBound.gamma q) * (sqrt (WedgeSanity.dot
  q a a) * sqrt (WedgeSanity.dot q b b)).
Proof. exact WedgeSanity.gamma_is_the_angle. Qed.
Theorem stretch_at_most : forall (P : dumbbell) (a b : Rbar.Rbar) (p : R -> pos) (U : nat), real_dumbbell P ->
  upper_bound (m2 P / m1 P) U -> Stretch.motion_within P a b p -> Stretch.at_most_within P a b p U.
Proof. exact AnyMotion.stretch_at_most. Qed.
Theorem contact_at_most : forall (P : dumbbell) (b : Rbar.Rbar) (p : R -> pos) (v : vel) (U : nat) (l : list R),
  real_dumbbell P -> upper_bound (m2 P / m1 P) U -> Rbar.Rbar_lt (Rbar.Finite 0) b -> StartInContact.watched_from_0 P
  b p v -> StartInContact.collides_at_once P p v -> List.NoDup l -> (forall t : R, List.In t l -> Stretch.within
  (Rbar.Finite 0) b t /\ collision P p t) -> (1 + length l <= U)%nat.
Proof. exact StartInContact.contact_at_most. Qed.
Theorem corner_at_most : forall (P : dumbbell) (a b : Rbar.Rbar) (p : R -> pos) (U : nat) (l : list R), real_dumbbell
  P -> upper_bound (m2 P / m1 P) U -> Rbar.Rbar_lt a b -> Stretch.motion_within P a b p -> Stretch.ends_in_corner P p
  b \/ Stretch.begins_in_corner P p a -> List.NoDup l -> (forall t : R, List.In t l -> Stretch.within a b t /\
  collision P p t) -> (2 + 2 * length l <= U)%nat.
Proof. exact AnyMotion.corner_at_most. Qed.
Theorem corner_counts_as_two : forall (P : dumbbell) (a b : Rbar.Rbar) (p : R -> pos) (T : R) (v : vel) (U : nat) (l :
  list R), real_dumbbell P -> upper_bound (m2 P / m1 P) U -> Stretch.motion_through P a b p -> Stretch.within a b T ->
  Stretch.both_down P (p T) -> before p T v -> 0 < energy P v -> (forall t : R, Stretch.within a b t -> t <> T ->
  Stretch.obeys P p t) /\ (List.NoDup l -> (forall t : R, List.In t l -> Stretch.within a b t /\ t <> T /\ collision P
  p t) -> (2 + length l <= U)%nat).
Proof. exact AnyMotion.corner_counts_as_two. Qed.
Theorem through_at_most : forall (P : dumbbell) (a b : Rbar.Rbar) (p : R -> pos) (U : nat), real_dumbbell P ->
  upper_bound (m2 P / m1 P) U -> Stretch.motion_through P a b p -> Stretch.at_most_within P a b p U.
Proof. exact AnyMotion.through_at_most. Qed.
Theorem whole_motion : forall (P : dumbbell) (s : pos) (v : vel), real_dumbbell P -> 0 < y1 P s -> 0 < y2 P s ->
  exists (a b : Rbar.Rbar) (p : R -> pos), Stretch.within a b 0 /\ Stretch.whole P a b p /\ p 0 = s /\ before p 0 v /\
  after p 0 v /\ (a = Rbar.m_infty \/ b = Rbar.p_infty) /\ (forall (a' b' : Rbar.Rbar) (p' : R -> pos), Stretch.within
  a' b' 0 -> Stretch.motion_within P a' b' p' -> p' 0 = s -> after p' 0 v -> Rbar.Rbar_le a a' /\ Rbar.Rbar_le b' b /\
  (forall t : R, Stretch.within a' b' t -> p' t = p t)) /\ (forall U : nat, upper_bound (m2 P / m1 P) U ->
  Stretch.at_most_within P a b p U).
Proof. exact AnyMotion.whole_motion. Qed.
Theorem no_accumulation_at_end : forall (P : dumbbell) (a : Rbar.Rbar) (T : R) (p : R -> pos), real_dumbbell P ->
  Rbar.Rbar_lt a (Rbar.Finite T) -> Stretch.motion_within P a (Rbar.Finite T) p -> exists s : pos, Stretch.flies_to p
  T s.
Proof. exact AnyMotion.no_accumulation_at_end. Qed.
Theorem state_for_ever : forall (P : dumbbell) (s : pos) (v : vel), real_dumbbell P -> 0 < y1 P s -> 0 < y2 P s ->
  exists p : R -> pos, Stretch.motion_through P Rbar.m_infty Rbar.p_infty p /\ p 0 = s /\ before p 0 v /\ after p 0 v
  /\ (forall U : nat, upper_bound (m2 P / m1 P) U -> at_most P p U).
Proof. exact ForEver.state_for_ever. Qed.
Theorem corner_is_reached : forall P : dumbbell, real_dumbbell P -> exists p : R -> pos, Stretch.motion_within P
  Rbar.m_infty (Rbar.Finite 0) p /\ Stretch.ends_in_corner P p (Rbar.Finite 0).
Proof. exact ForEver.corner_is_reached. Qed.
Theorem every_flight : forall P : dumbbell, real_dumbbell P -> Flight.r_of P <= 1 -> forall (s : pos) (v : vel), 0 <
  y1 P s -> 0 < y2 P s -> (exists p : R -> pos, motion P p /\ p 0 = s /\ before p 0 v /\ after p 0 v) \/
  EveryState.runs_into_corner P s v \/ EveryState.runs_into_corner P s (Symmetry.minus_v v).
Proof. exact EveryState.every_flight. Qed.
Theorem no_accumulation : forall P : dumbbell, real_dumbbell P -> Flight.r_of P <= 1 -> forall (s : pos) (v : vel) (p
  : R -> pos) (T : R), OneFlight.above_floor P s -> OneFlight.leaves P s v -> p 0 = s -> after p 0 v -> 0 < T ->
  (forall t : R, 0 < t < T -> Existence.lawful P p t) -> NoAccumulation.free_just_before p T.
Proof. exact NoAccumulation.no_accumulation. Qed.
Theorem determined : forall P : dumbbell, real_dumbbell P -> forall (p q : R -> pos) (t0 : R) (v : vel), motion P p ->
  motion P q -> p t0 = q t0 -> after p t0 v -> after q t0 v -> forall t : R, t0 <= t -> p t = q t.
Proof. exact Determinism.determined. Qed.
Theorem newton_push1 : forall P : dumbbell, real_dumbbell P -> forall (s : pos) (a1 b1 a2 b2 a1' b1' a2' b2' J : R), 0
  <= J -> Newton.newton P (angle s) a1 b1 a2 b2 a1' b1' a2' b2' J 0 -> Newton.rigid (angle s) a1 b1 a2 b2 ->
  Newton.rigid (angle s) a1' b1' a2' b2' -> Newton.kinetic P a1' b1' a2' b2' = Newton.kinetic P a1 b1 a2 b2 -> push1 P
  s (Newton.vel_of P (angle s) a1 b1 a2 b2) (Newton.vel_of P (angle s) a1' b1' a2' b2').
Proof. exact Newton.newton_push1. Qed.
Theorem newton_push2 : forall P : dumbbell, real_dumbbell P -> forall (s : pos) (a1 b1 a2 b2 a1' b1' a2' b2' J : R), 0
  <= J -> Newton.newton P (angle s) a1 b1 a2 b2 a1' b1' a2' b2' 0 J -> Newton.rigid (angle s) a1 b1 a2 b2 ->
  Newton.rigid (angle s) a1' b1' a2' b2' -> Newton.kinetic P a1' b1' a2' b2' = Newton.kinetic P a1 b1 a2 b2 -> push2 P
  s (Newton.vel_of P (angle s) a1 b1 a2 b2) (Newton.vel_of P (angle s) a1' b1' a2' b2').
Proof. exact Newton.newton_push2. Qed.
Theorem push1_newton : forall P : dumbbell, real_dumbbell P -> forall (s : pos) (v v' : vel), push1 P s v v' -> exists
  J : R, 0 <= J /\ Newton.moves_by P s v v' J 0.
Proof. exact Newton.push1_newton. Qed.
Theorem push2_newton : forall P : dumbbell, real_dumbbell P -> forall (s : pos) (v v' : vel), push2 P s v v' -> exists
  J : R, 0 <= J /\ Newton.moves_by P s v v' 0 J.
Proof. exact Newton.push2_newton. Qed.
Theorem kinetic_energy : forall P : dumbbell, real_dumbbell P -> forall th a1 b1 a2 b2 : R, Newton.rigid th a1 b1 a2
  b2 -> Newton.kinetic P a1 b1 a2 b2 = mass P * (Newton.vx_of P a1 a2 * Newton.vx_of P a1 a2) / 2 + energy P
  (Newton.vel_of P th a1 b1 a2 b2).
Proof. exact Newton.kinetic_energy. Qed.
Theorem free_flight : forall P : dumbbell, real_dumbbell P -> forall (lo hi : R) (x1 z1 x2 z2 a1 b1 a2 b2 th rate
  force : R -> R), (forall t : R, FreeFlight.inside lo hi t -> FreeFlight.newton_in_flight P x1 z1 x2 z2 a1 b1 a2 b2
  th rate force t) -> forall t : R, FreeFlight.inside lo hi t -> before (FreeFlight.place P z1 z2 th) t
  (FreeFlight.speed P a1 b1 a2 b2 th t) /\ after (FreeFlight.place P z1 z2 th) t (FreeFlight.speed P a1 b1 a2 b2 th
  t).
Proof. exact FreeFlight.free_flight. Qed.
Theorem push_is_law_4 : forall P : dumbbell, real_dumbbell P -> ell P = 1 -> forall (s : pos) (v v' : vel), w1 P s v <
  0 -> v' <> v -> push1 P s v v' <-> v' = Paper.law_4 P (angle s) v.
Proof. exact Paper.push_is_law_4. Qed.
Theorem boundary_2a : forall P : dumbbell, real_dumbbell P -> ell P = 1 -> forall (s : pos) (Y : R), height s = sqrt
  (inertia P / mass P) * Y -> y1 P s = 0 <-> Y = - sqrt (Paper.beta2 P / Paper.beta1 P) * sin (angle s).
Proof. exact Paper.boundary_2a. Qed.
Theorem boundary_2b : forall P : dumbbell, real_dumbbell P -> ell P = 1 -> forall (s : pos) (Y : R), height s = sqrt
  (inertia P / mass P) * Y -> y2 P s = 0 <-> Y = sqrt (Paper.beta1 P / Paper.beta2 P) * sin (angle s).
Proof. exact Paper.boundary_2b. Qed.
Theorem boundary_2c : forall P : dumbbell, real_dumbbell P -> ell P = 1 -> forall (s : pos) (Y : R), height s = sqrt
  (inertia P / mass P) * Y -> 0 <= y1 P s /\ 0 <= y2 P s <-> Rmax (- sqrt (Paper.beta2 P / Paper.beta1 P) * sin (angle
  s)) (sqrt (Paper.beta1 P / Paper.beta2 P) * sin (angle s)) <= Y.
Proof. exact Paper.boundary_2c. Qed.
Theorem ratios_exist : forall q : R, 0 < q <-> (exists P : dumbbell, real_dumbbell P /\ m2 P / m1 P = q).
Proof. exact Sanity.ratios_exist. Qed.
Theorem collision_is_jump : forall P : dumbbell, real_dumbbell P -> forall (p : R -> pos) (t : R) (v v' : vel), motion
  P p -> before p t v -> after p t v' -> collision P p t <-> v' <> v.
Proof. exact Sanity.collision_is_jump. Qed.
Theorem collision_turns : forall P : dumbbell, real_dumbbell P -> forall (p : R -> pos) (t : R) (v v' : vel), motion P
  p -> collision P p t -> before p t v -> after p t v' -> y1 P (p t) = 0 /\ w1 P (p t) v' = - w1 P (p t) v /\ w1 P (p
  t) v < 0 \/ y2 P (p t) = 0 /\ w2 P (p t) v' = - w2 P (p t) v /\ w2 P (p t) v < 0.
Proof. exact Sanity.collision_turns. Qed.
Theorem energy_kept : forall (P : dumbbell) (p : R -> pos) (t1 : R) (v1 : vel) (t2 : R) (v2 : vel), motion P p ->
  after p t1 v1 -> after p t2 v2 -> t1 <= t2 -> energy P v2 = energy P v1.
Proof. exact Sanity.energy_kept. Qed.
Theorem bouncing_once : forall P : dumbbell, real_dumbbell P -> at_least P (Sanity.bouncing P) 1 /\ at_most P
  (Sanity.bouncing P) 1.
Proof. exact Sanity.bouncing_once. Qed.
Theorem law : LawStatement.the_law /\ LawStatement.law_everywhere.
Proof. exact Law.law. Qed.
Theorem theorem_A : forall (N : nat) (q : R), (903 <= N)%nat -> CriticalRatios.critical N q -> LawStatement.law_with_logarithm N q /\
  0 < LawStatement.delta N q < LawStatement.law_constant * LawStatement.quarter q.
Proof. exact Law.theorem_A. Qed.
Theorem steps_hold : LawStatement.steps.
Proof. exact FirstSteps.steps_hold. Qed.
Theorem growth_between : forall n : nat, GrowthSeries.growth_sum (2 * n + 1) <= LawStatement.growth <=
  GrowthSeries.growth_sum (2 * (n + 1)).
Proof. exact GrowthSeries.growth_between. Qed.
Theorem by_law_true : forall c : Decide.claim,
  ByLaw.by_law c = ByLaw.Holds -> Decided.says c.
Proof. exact DecidedByLaw.by_law_true. Qed.
Theorem by_law_false : forall (c : Decide.claim)
  (q : Certificate.ratio) (n : N) (reached : bool), ByLaw.by_law c = ByLaw.Fails q n reached -> Decided.in_range c
  (Certificate.ratio_value q) /\ (if reached then ExactMaximum.N_at_least (Certificate.ratio_value q) (N.to_nat n) /\
  (exists m : N, Decide.claimed_most c = Some m /\ (m < n)%N) else Decide.claimed_least c = Some n /\ ~
  ExactMaximum.N_at_least (Certificate.ratio_value q) (N.to_nat n)).
Proof. exact DecidedByLaw.by_law_false. Qed.
Theorem orbit_of_critical : forall (N : nat) (q : R), (4 <= N)%nat -> CriticalRatios.critical N q -> exists (n : nat)
  (u al : nat -> R) (y : R), Orbit.orbit (/ sqrt q) N n u al y.
Proof. exact Orbit.orbit_of_critical. Qed.
Theorem L44_falls : forall eps u u' th : R, 0 < eps -> 0 < u' < u -> u <= PI / 2 -> 0 <= th < PI / 2 -> cos u' - cos u
  = eps * tan th * (2 * PI - u - u') -> th + LawStatement.beta eps u' < PI / 2 -> LawStatement.invariant u' (th +
  LawStatement.beta eps u') < LawStatement.invariant u (th - LawStatement.beta eps u).
Proof. exact Falls.L44_falls. Qed.
