(** L17, L18, the upper bounds: in a wedge whose walls are concave graphs with slopes between -1 and 1 every motion has
    at most ceil(pi/gamma) collisions. The walls are hit in turn, and each collision but the first and the last turns
    the velocity by twice the angle of the wall with the vertical, which is at least gamma/2.

    wedge_at_most == at most N collisions, if pi/gamma <= N
    gamma_range   == 0 < gamma < pi *)
From Coq Require Import Reals Lra Lia List.
From Dumbbell Require Import Wedge WedgeFlights PublishedBound.
Import ListNotations.
Local Open Scope R_scope.

(** The angle, in the metric, of a wall of slope w with the vertical. *)
Definition wall_angle q w := PI/2 - atan (w * sqrt q).
Lemma wall_angle_bounds q w : 0 < q -> w <= 1 -> gamma q / 2 <= wall_angle q w /\ 0 < wall_angle q w < PI.
Proof.
  intros Hq Hw. assert (0 < sqrt q) by (now apply sqrt_lt_R0). destruct (atan_bound (w * sqrt q)).
  assert (w * sqrt q <= 1 * sqrt q) by (apply Rmult_le_compat_r; lra). rewrite Rmult_1_l in *.
  assert (atan (w * sqrt q) <= atan (sqrt q)) by (now apply atan_mono). unfold wall_angle, gamma. lra.
Qed.
Lemma gamma_range q : 0 < q -> 0 < gamma q < PI.
Proof.
  intros Hq. assert (0 < sqrt q) by (now apply sqrt_lt_R0). destruct (atan_bound (sqrt q)).
  assert (atan 0 < atan (sqrt q)) by (now apply atan_increasing). rewrite atan_0 in *. unfold gamma. lra.
Qed.

(** The sine and cosine of the wall's angle with the horizontal. *)
Lemma atan_parts z : 0 < cos (atan z) /\ z * cos (atan z) = sin (atan z).
Proof.
  destruct (atan_bound z). assert (C : 0 < cos (atan z)) by (apply cos_gt_0; lra). split; [exact C|].
  rewrite <- (tan_atan z) at 1. unfold tan. field. lra.
Qed.

Section Turn.
Variables (q w S a : R).
Hypothesis Hq : 0 < q.
Hypothesis HS : 0 < S.
Notation b := (wall_angle q w).
Lemma square_of_sqrt x : 0 < x -> sqrt x * sqrt x = x.
Proof. intros. apply sqrt_sqrt. lra. Qed.

(** A velocity (m, u) of size S at the angle a to the vertical comes in iff sin (a - b) > 0; its reflection has the
    angle 2 b - a. *)
Lemma comes_in m u : m = S * sin a -> sqrt q * u = S * cos a -> u < w * m -> 0 < sin (a - b).
Proof.
  intros Em Eu Hi. destruct (atan_parts (w * sqrt q)) as [C E]. set (f := atan (w * sqrt q)) in *.
  assert (K : 0 < sqrt q) by (now apply sqrt_lt_R0).
  assert (0 < S * sin (a - b)); [|apply Rmult_lt_reg_l with S; lra].
  unfold wall_angle. fold f. replace (a - (PI/2 - f)) with (- (PI/2 - (a + f))) by ring.
  rewrite sin_neg, sin_shift, cos_plus.
  replace (S * - (cos a * cos f - sin a * sin f)) with (sqrt q * cos f * (w * m - u)).
  - apply Rmult_lt_0_compat; [now apply Rmult_lt_0_compat | lra].
  - rewrite <- E, Em. replace (sqrt q * cos f * (w * (S * sin a) - u)) with
      (cos f * (w * sqrt q * (S * sin a) - sqrt q * u)) by ring. rewrite Eu. ring.
Qed.
Lemma reflects m u m' u' j : m = S * sin a -> sqrt q * u = S * cos a -> m' = m - q * w * j -> u' = u + j ->
  j * (1 + q * (w * w)) = 2 * (w * m - u) -> m' = S * sin (2 * b - a) /\ sqrt q * u' = S * cos (2 * b - a).
Proof.
  intros Em Eu Em' Eu' Ej. unfold wall_angle. destruct (atan_parts (w * sqrt q)) as [C E].
  set (f := atan (w * sqrt q)) in *. assert (Q := square_of_sqrt q Hq). set (k := sqrt q) in *.
  assert (P1 := sin2_cos2 f). unfold Rsqr in P1.
  assert (J : k * j = 2 * cos f * (sin f * m - cos f * (k * u))).
  { assert (X : cos f * cos f * (1 + q * (w * w)) = 1).
    { rewrite <- Q. replace (cos f * cos f * (1 + k * k * (w * w))) with
        (cos f * cos f + (w * k * cos f) * (w * k * cos f)) by ring. rewrite E. lra. }
    replace (k * j) with (k * (j * (cos f * cos f * (1 + q * (w * w))))) by (rewrite X; ring).
    replace (k * (j * (cos f * cos f * (1 + q * (w * w))))) with (k * cos f * cos f * (j * (1 + q * (w * w)))) by ring.
    rewrite Ej, <- E. ring. }
  assert (M : m' = m - 2 * sin f * (sin f * m - cos f * (k * u))).
  { rewrite Em', <- Q. replace (k * k * w * j) with (w * k * (k * j)) by ring. rewrite J.
    replace (w * k * (2 * cos f * (sin f * m - cos f * (k * u)))) with
      (2 * (w * k * cos f) * (sin f * m - cos f * (k * u))) by ring. rewrite E. ring. }
  replace (2 * (PI/2 - f) - a) with (PI - (a + 2 * f)) by field.
  rewrite sin_PI_x, cos_minus, cos_PI, sin_PI, sin_plus, cos_plus, sin_2a, cos_2a.
  assert (C2 : cos f * cos f = 1 - sin f * sin f) by lra.
  split.
  - rewrite M, Eu, Em, C2. ring.
  - rewrite Eu', Rmult_plus_distr_l, J, Eu, Em.
    replace (2 * cos f * (sin f * (S * sin a) - cos f * (S * cos a))) with
      (S * (2 * cos f * sin f * sin a) - 2 * S * cos a * (cos f * cos f)) by ring. rewrite C2. ring.
Qed.
End Turn.

(** Every velocity that comes in has such an angle, between b and b + pi. *)
Lemma angle_of q w m u : 0 < q -> u < w * m -> exists S a, 0 < S /\ m = S * sin a /\ sqrt q * u = S * cos a /\
  wall_angle q w < a < wall_angle q w + PI.
Proof.
  intros Hq Hi. unfold wall_angle. destruct (atan_parts (w * sqrt q)) as [C E]. set (f := atan (w * sqrt q)) in *.
  assert (K : 0 < sqrt q) by (now apply sqrt_lt_R0). set (k := sqrt q) in *.
  assert (P1 := sin2_cos2 f). unfold Rsqr in P1.
  set (I := sin f * m - cos f * (k * u)). set (T := cos f * m + sin f * (k * u)).
  assert (HI : 0 < I).
  { unfold I. rewrite <- E. replace (w * k * cos f * m - cos f * (k * u)) with (k * cos f * (w * m - u)) by ring.
    apply Rmult_lt_0_compat; [now apply Rmult_lt_0_compat | lra]. }
  destruct (atan_parts (T / I)) as [D F]. destruct (atan_bound (T / I)). set (g := atan (T / I)) in *.
  assert (F' : T = I / cos g * sin g) by (rewrite <- F; field; lra).
  assert (EI : I = I / cos g * cos g) by (field; lra).
  exists (I / cos g), (PI/2 - g + (PI/2 - f)). split; [now apply Rdiv_lt_0_compat|].
  replace (PI/2 - g + (PI/2 - f)) with (PI - (f + g)) by field.
  rewrite sin_PI_x, cos_minus, cos_PI, sin_PI, sin_plus, cos_plus. split; [|split; [|lra]].
  - replace (I / cos g * (sin f * cos g + cos f * sin g)) with
      (sin f * (I / cos g * cos g) + cos f * (I / cos g * sin g)) by ring. rewrite <- EI, <- F'. unfold I, T.
    replace (sin f * (sin f * m - cos f * (k * u)) + cos f * (cos f * m + sin f * (k * u))) with
      (m * (sin f * sin f + cos f * cos f)) by ring. rewrite P1. ring.
  - replace (I / cos g * (-1 * (cos f * cos g - sin f * sin g) + 0 * (sin f * cos g + cos f * sin g))) with
      (sin f * (I / cos g * sin g) - cos f * (I / cos g * cos g)) by ring. rewrite <- EI, <- F'. unfold I, T.
    replace (sin f * (cos f * m + sin f * (k * u)) - cos f * (sin f * m - cos f * (k * u))) with
      (k * u * (sin f * sin f + cos f * cos f)) by ring. rewrite P1. ring.
Qed.

Section Upper.
Variables (W : wall) (q : R).
Hypothesis HW : concave_wall W.
Hypothesis Hq : 0 < q.
Variable p : R -> point.
Hypothesis Hm : motion W q p.

(** Just after collision n, at the time t and on the side s: the angle a of the velocity, seen from the other side. *)
Definition after_n n t := exists s v S a, after p t v /\ side s /\ on W s (p t) /\
  slope_at W s (p t) * psi v < yhat v /\ 0 < S /\ psi v = - s * (S * sin a) /\ sqrt q * yhat v = S * cos a /\
  - PI < a < PI + gamma q / 2 - INR n * gamma q /\ (INR n - 1) * gamma q < PI.

Lemma next_angle n t s v v' j S a : after p t v' -> side s -> on W s (p t) -> 0 < j -> let w := slope_at W s (p t) in
  psi v' = psi v - q * w * j -> yhat v' = yhat v + j -> j * (1 + q * (w * w)) = 2 * (w * psi v - yhat v) ->
  0 < S -> s * psi v = S * sin a -> sqrt q * yhat v = S * cos a -> let b := wall_angle q (slope W (s * psi (p t))) in
  b - PI < a < b + PI -> (n = O \/ a < PI + gamma q / 2 - INR n * gamma q) -> after_n (Datatypes.S n) t.
Proof.
  intros Ha Hs Ho Hj w E1 E2 E3 HS Es Eu b Hb Hn. set (g := slope W (s * psi (p t))) in *.
  assert (SQ := side_square s Hs). assert (Ew : w = s * g) by reflexivity.
  assert (W2 : w * w = g * g)
    by (rewrite Ew; replace (s * g * (s * g)) with (s * s * (g * g)) by ring; rewrite SQ; ring).
  assert (Wv : forall z, w * z = g * (s * z)) by (intros z; rewrite Ew; ring).
  assert (Em' : s * psi v' = s * psi v - q * g * j).
  { rewrite E1, Ew. replace (s * (psi v - q * (s * g) * j)) with (s * psi v - s * s * (q * g * j)) by ring.
    rewrite SQ. ring. }
  assert (HD : 0 < 1 + q * (w * w)).
  { assert (0 <= q * (w * w)) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]). lra. }
  assert (Hpos : 0 < j * (1 + q * (w * w))) by (now apply Rmult_lt_0_compat).
  assert (Hin : 0 < sin (a - b))
    by (apply (comes_in q g S a Hq HS (s * psi v) (yhat v)); try assumption; rewrite <- Wv; lra).
  assert (Hab : b < a).
  { apply Rnot_le_lt. intros L. assert (sin (a - b) <= 0); [|lra]. replace (a - b) with (- (b - a)) by ring.
    rewrite sin_neg. assert (0 <= sin (b - a)) by (apply sin_ge_0; lra). lra. }
  destruct (reflects q g S a Hq (s * psi v) (yhat v) (s * psi v') (yhat v') j) as [R1 R2]; try assumption.
  { rewrite <- W2, <- Wv. exact E3. }
  assert (B := wall_angle_bounds q g Hq (proj2 (slope_bound W HW _))). fold b in B. fold b in R1, R2.
  assert (G := gamma_range q Hq).
  exists s, v', S, (a - 2 * b). repeat split; try assumption; try lra.
  - fold w. rewrite E1, E2. assert (w * (psi v - q * w * j) = w * psi v - j * (1 + q * (w * w)) + j) by ring. lra.
  - replace (sin (a - 2 * b)) with (- sin (2 * b - a)) by (rewrite <- sin_neg; f_equal; ring).
    replace (- s * (S * - sin (2 * b - a))) with (s * (S * sin (2 * b - a))) by ring. rewrite <- R1.
    replace (s * (s * psi v')) with (s * s * psi v') by ring. rewrite SQ. ring.
  - rewrite R2. f_equal. rewrite <- cos_neg. f_equal. ring.
  - rewrite S_INR. destruct Hn as [-> |Hn]; [simpl INR; lra | lra].
  - rewrite S_INR. destruct Hn as [-> |Hn]; [simpl INR; lra | lra].
Qed.

Lemma first_angle t : collision W p t -> after_n 1 t.
Proof.
  intros Hc. assert (Hb := Hc). destruct Hb as [v [Hb _]].
  destruct (collision_law W q HW Hq p t v Hm Hc Hb) as [v' [s [j [Ha [Hs [Ho [Hj [E1 [E2 E3]]]]]]]]].
  assert (HD : 0 < j * (1 + q * (slope_at W s (p t) * slope_at W s (p t)))).
  { apply Rmult_lt_0_compat; [exact Hj|]. assert (0 <= q * (slope_at W s (p t) * slope_at W s (p t)))
      by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]). lra. }
  destruct (angle_of q (slope W (s * psi (p t))) (s * psi v) (yhat v) Hq) as [S [a [HS [Em [Eu Hab]]]]].
  { replace (slope W (s * psi (p t)) * (s * psi v)) with (slope_at W s (p t) * psi v)
      by (unfold slope_at; ring). lra. }
  apply (next_angle 0 t s v v' j S a); try assumption; [|now left].
  lra.
Qed.

(** A flight leads from one wall to the other. *)
Lemma other_side t0 t1 s s1 v : t0 < t1 -> side s -> side s1 -> on W s (p t0) -> on W s1 (p t1) ->
  slope_at W s (p t0) * psi v < yhat v -> on_line p t0 v t1 -> s1 = - s.
Proof.
  intros Ht Hs Hs1 Ho Ho1 Hout [A U]. assert (E : s1 = s \/ s1 = - s).
  { destruct Hs as [->| ->], Hs1 as [->| ->]; [left | right | right | left]; lra. }
  destruct E as [->|E]; [exfalso | exact E]. unfold on in *.
  assert (B := below_tangent W HW (s * psi (p t0)) (s * psi v * (t1 - t0))).
  replace (s * psi (p t0) + s * psi v * (t1 - t0)) with (s * psi (p t1)) in B by (rewrite A; ring).
  unfold slope_at in Hout. assert (0 < (yhat v - s * slope W (s * psi (p t0)) * psi v) * (t1 - t0))
    by (apply Rmult_lt_0_compat; lra). lra.
Qed.
Lemma next_collision n t0 t1 : after_n (Datatypes.S n) t0 -> t0 < t1 -> collision W p t1 ->
  (forall t, t0 < t < t1 -> ~ collision W p t) -> after_n (Datatypes.S (Datatypes.S n)) t1.
Proof.
  intros [s [v [S [a [Ha [Hs [Ho [Hout [HS [Ev [Eu [Hr _]]]]]]]]]]]] Ht Hc Hno.
  assert (L := flight W q Hq p t0 t1 v Hm Ht Ha Hno). assert (Hb := flight_before p t0 t1 v Ht L).
  destruct (collision_law W q HW Hq p t1 v Hm Hc Hb) as [v' [s1 [j [Ha' [Hs1 [Ho1 [Hj [E1 [E2 E3]]]]]]]]].
  assert (L1 := L t1 ltac:(lra)). assert (Es := other_side t0 t1 s s1 v Ht Hs Hs1 Ho Ho1 Hout L1).
  assert (SQ := side_square s Hs).
  assert (Em : s1 * psi v = S * sin a).
  { rewrite Es, Ev. replace (- s * (- s * (S * sin a))) with (s * s * (S * sin a)) by ring. rewrite SQ. ring. }
  assert (X0 := on_side W q HW p t0 s Hm Hs Ho). assert (X1 := on_side W q HW p t1 s1 Hm Hs1 Ho1).
  destruct L1 as [A _].
  assert (Hsin : 0 < sin a).
  { assert (0 < S * sin a * (t1 - t0)).
    { rewrite <- Em. rewrite A, Es in X1. rewrite Es. lra. }
    apply Rmult_lt_reg_l with (S * (t1 - t0)); [apply Rmult_lt_0_compat; lra | lra]. }
  assert (Ha0 : 0 < a).
  { apply Rnot_le_lt. intros K. assert (0 <= sin (- a)) by (apply sin_ge_0; lra). rewrite sin_neg in *. lra. }
  assert (B := wall_angle_bounds q (slope W (s1 * psi (p t1))) Hq (proj2 (slope_bound W HW _))).
  assert (G := gamma_range q Hq). assert (N := pos_INR n). rewrite S_INR in Hr.
  assert (0 <= INR n * gamma q) by (apply Rmult_le_pos; lra).
  apply (next_angle (Datatypes.S n) t1 s1 v v' j S a); try assumption; [lra | right; rewrite S_INR; lra].
Qed.

Lemma later_bound m : forall n t, after_n (Datatypes.S n) t -> later W p t m ->
  (INR (Datatypes.S n + m) - 1) * gamma q < PI.
Proof.
  induction m as [|m IH]; intros n t Hn Hl.
  - destruct Hn as [s [v [S [a [_ [_ [_ [_ [_ [_ [_ [_ H]]]]]]]]]]]]. now rewrite Nat.add_0_r.
  - destruct (later_next W q HW p t m Hm Hl) as [t1 [H1 [H2 [H3 H4]]]].
    replace (Datatypes.S n + Datatypes.S m)%nat with (Datatypes.S (Datatypes.S n) + m)%nat by lia.
    apply IH with t1; [|exact H4]. now apply next_collision with t.
Qed.
Lemma before_all (l : list R) : exists t0, forall t, In t l -> t0 < t.
Proof.
  induction l as [|x l [t0 IH]]; [exists 0; contradiction|]. exists (Rmin t0 (x - 1)).
  assert (Rmin t0 (x - 1) <= t0) by apply Rmin_l. assert (Rmin t0 (x - 1) <= x - 1) by apply Rmin_r.
  intros t [<-|Ht]; [lra|]. specialize (IH t Ht). lra.
Qed.
Theorem angle_bound l : NoDup l -> (forall t, In t l -> collision W p t) -> (INR (length l) - 1) * gamma q < PI.
Proof.
  intros Hnd Hl. destruct (before_all l) as [t0 H0]. assert (G := gamma_range q Hq).
  destruct (length l) as [|n] eqn:E; [simpl INR; lra|].
  assert (Hlat : later W p t0 (Datatypes.S n)) by (exists l; repeat split; auto).
  destruct (later_next W q HW p t0 n Hm Hlat) as [t1 [H1 [H2 [H3 H4]]]].
  apply (later_bound n 0 t1); [now apply first_angle | exact H4].
Qed.
Theorem wedge_at_most N : PI / gamma q <= INR N -> at_most W p N.
Proof.
  intros HN l Hnd Hl. assert (B := angle_bound l Hnd Hl). assert (G := gamma_range q Hq).
  assert (K : INR (length l) < INR (N + 1)); [|apply INR_lt in K; lia].
  rewrite plus_INR. simpl (INR 1). apply Rmult_lt_reg_r with (gamma q); [lra|].
  assert (PI / gamma q * gamma q <= INR N * gamma q) by (apply Rmult_le_compat_r; lra).
  replace (PI / gamma q * gamma q) with PI in * by (field; lra). lra.
Qed.
End Upper.
