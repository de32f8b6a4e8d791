(** L29: a count ends in a tangency. If rays below (c, k), arbitrarily near and at ratios arbitrarily near below r,
    have n collisions, then (c, k) has n, or a flight of it is tangent to the hump. With Tangency.v this gives
    Theorem 2 (c).

    theorem_2c_odd, theorem_2c_even == a ratio is critical if and only if a flight of an orbit is tangent to the hump *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics Ray FewHits Maximum Orbits Openness ExactMaximum Monotone CriticalRatios Tangency.
Local Open Scope R_scope.

Definition near_below c k r n := forall e, 0 < e -> exists c' k' r', c - e <= c' <= c /\ 0 <= c' /\
  k - e <= k' <= k /\ 0 <= k' /\
  r - e <= r' <= r /\ 0 < r' /\ coll r' n c' k'.

Lemma cos_steps x y : x <= y -> cos x - cos y <= y - x.
Proof.
  intros H. destruct (MVT_gen cos x y (fun t => - sin t)) as [t [_ E]].
  { intros; auto_derive; [easy|ring]. } { intros; reg. }
  destruct (SIN_bound t) as [_ B]. assert (sin t * (y - x) <= 1 * (y - x)) by (apply Rmult_le_compat_r; lra). lra.
Qed.
Lemma sin_steps x y : x <= y -> sin y - sin x <= y - x.
Proof.
  intros H. destruct (MVT_gen sin x y cos) as [t [_ E]]. { intros; auto_derive; [easy|ring]. } { intros; reg. }
  destruct (COS_bound t) as [_ B]. assert (cos t * (y - x) <= 1 * (y - x)) by (apply Rmult_le_compat_r; lra). lra.
Qed.

(** One flight: a hit, or a tangency. *)
Lemma hit_or_tangent c k r n : 0 <= c -> near_below c k r (S n) -> (exists x, hit c k x) \/ tangent c k.
Proof.
  intros Hc HN. assert (HPI := PI2_1). assert (HPI4 := PI_4).
  destruct (continuity_ab_maj (fun x => sin x - k * x) 0 (PI/2)) as [x [Hmax Hx]]; [lra | intros; reg |].
  destruct (Rtotal_order (sin x) (c + k * x)) as [L|[E|G]].
  - exfalso. set (m := c + k * x - sin x).
  destruct (HN (m / 4) ltac:(unfold m; lra)) as [c' [k' [r' [C [_ [K [_ [_ [_ H]]]]]]]]].
    destruct H as [y [[Y1 [Y2 _]] _]]. specialize (Hmax y ltac:(lra)).
    assert (0 <= (k' - (k - m / 4)) * y) by (apply Rmult_le_pos; lra). assert (m / 4 * y <= m / 4 * 2)
      by (apply Rmult_le_compat_l; unfold m in *; lra).
    unfold m in *. lra.
  - right. split; [exists x; split; [lra | exact E]|]. intros y Hy. specialize (Hmax y Hy). lra.
  - left. destruct (hit_exists c k x Hc ltac:(lra) ltac:(lra)) as [y [Hy _]]. now exists y.
Qed.

Section Step.
Variables c k r x : R.
Hypothesis Hr : 0 < r <= 1.
Hypothesis Hx : hit c k x.
Variable n : nat.
Hypothesis HN : near_below c k r (S (S n)).
Let w := cos x.
Let B := 3 / (w - k).
Let D e := slope_den (w + B * e) (k - e) (r - e).
Let K e := next_slope (w + B * e) (k - e) (r - e).
Let C e := sin x - B * e + K e * (x - B * e + PI).

(** What a ray near below does at its first collision. *)
Lemma neighbour e : 0 < e <= r -> exists y k' r', 0 <= y <= x /\ x - y <= B * e /\ k - e <= k' <= k /\ 0 <= k' /\
  r - e <= r' <= r /\ 0 < r' /\
  k' < cos y /\ 0 < slope_den (cos y) k' r' /\ 0 < D e /\ K e <= next_slope (cos y) k' r' < 1 /\
  coll r' (S n) (sin y + next_slope (cos y) k' r' * (y + PI)) (next_slope (cos y) k' r').
Proof.
  intros He. assert (HPI := PI2_1). assert (HPI4 := PI_4).
  destruct (HN e ltac:(lra)) as [c' [k' [r' [C1 [C2 [K1 [K2 [R1 [R2 H]]]]]]]]].
  destruct H as [y [Hy [H|[HD H]]]]; [discriminate|]. cbv zeta in H.
  destruct (flight_mono c' k' c k x) as [y' [Hy' L]]; try lra; [exact Hx|].
  assert (y' = y) by (now apply (hit_unique c' k')). subst y'. assert (X := Hx). assert (Y := Hy).
  destruct X as [X1 [X2 X3]], Y as [Y1 [Y2 Y3]]. fold w in X3.
  assert (T := sin_below_tangent x y ltac:(lra) ltac:(lra)). fold w in T.
  assert (0 <= (e - (k - k')) * y) by (apply Rmult_le_pos; lra).
  assert (e * y <= e * 2) by (apply Rmult_le_compat_l; lra).
  assert (HB : x - y <= B * e).
  { apply Rmult_le_reg_r with (w - k); [lra|]. replace (B * e * (w - k)) with (3 * e)
    by (unfold B; field; lra). lra. }
  assert (Z := cos_steps y x L). fold w in Z.
  destruct (reflect_mono (w + B * e) (cos y) (k - e) k' (r - e) r') as [D1 S1]; try lra.
  exists y, k', r'. repeat split; try assumption; try lra.
  destruct H as [z [[_ [_ Z3]] _]]. destruct (COS_bound z). lra.
Qed.

Lemma limit_turns_back : 0 < slope_den w k r.
Proof.
  apply Rnot_le_lt. intros HD0. destruct Hx as [X1 [X2 X3]]. assert (W := cos_pos _ X1). fold w in W, X3.
  destruct (positive_near (fun e => (r - e) * w - D e)) as [d [Hd H]].
  { unfold D, slope_den. reg. } { unfold D. rewrite Rmult_0_r, Rplus_0_r, !Rminus_0_r. assert (0 < r * w)
    by (apply Rmult_lt_0_compat; lra). lra. }
  set (e := Rmin (d / 2) r). assert (E1 := Rmin_l (d / 2) r). assert (E2 := Rmin_r (d / 2) r).
  assert (E0 : 0 < e) by (apply Rmin_glb_lt; lra). fold e in E1, E2. specialize (H e ltac:(lra)).
  destruct (neighbour e ltac:(lra)) as [y [k' [r' [Y1 [Y2 [K1 [K0 [R1 [R2 [K2 [HD [HDe [[S1 S2] _]]]]]]]]]]]]].
  assert (Cy : w <= cos y) by (apply cos_mono; lra). destruct (COS_bound y) as [_ W1].
  assert (P : slope_num (cos y) k' r' < slope_den (cos y) k' r').
  { apply Rmult_lt_reg_r with (/ slope_den (cos y) k' r'); [now apply Rinv_0_lt_compat|]. rewrite Rinv_r
    by lra. exact S2. }
  assert (Q : r' * cos y <= slope_num (cos y) k' r').
  { unfold slope_num. assert (0 <= r' * (cos y - k')) by (apply Rmult_le_pos; lra).
    assert (0 <= k' * (cos y * cos y)) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]). lra. }
  assert (R3 : (r - e) * w <= r' * cos y) by (apply Rmult_le_compat; lra).
  assert (G : slope_den (cos y) k' r' <= D e); [|lra]. assert (Z := cos_steps y x ltac:(lra)). fold w in Z.
  unfold D, slope_den. set (v := w + B * e). assert (V : cos y <= v) by (unfold v; lra).
  assert (0 <= (v - cos y) * ((v - k') + (cos y - k'))) by (apply Rmult_le_pos; lra).
  assert (0 <= (k' - (k - e)) * v) by (apply Rmult_le_pos; lra). lra.
Qed.

(** The next ray is near below the next state. *)
Lemma next_near_below : near_below (sin x + next_slope w k r * (x + PI)) (next_slope w k r) r (S n).
Proof.
  intros e He. assert (HD0 := limit_turns_back). assert (HPI := PI2_1). assert (X := Hx). destruct X as [X1 [X2 X3]].
  assert (W := cos_pos _ X1). fold w in W, X3. assert (D0 : D 0 = slope_den w k r)
    by (unfold D; now rewrite Rmult_0_r, Rplus_0_r, !Rminus_0_r).
  assert (K0 : K 0 = next_slope w k r) by (unfold K; now rewrite Rmult_0_r, Rplus_0_r, !Rminus_0_r).
  assert (C0 : C 0 = sin x + next_slope w k r * (x + PI)) by (unfold C; rewrite K0, Rmult_0_r; ring).
  assert (CK : continuity_pt K 0).
  { change K with (div_fct (fun e => slope_num (w + B * e) (k - e) (r - e)) D).
    apply continuity_pt_div; [unfold slope_num; reg | unfold D, slope_den; reg | lra]. }
  assert (CC : continuity_pt C 0).
  { unfold C. apply (continuity_pt_plus (fun e => sin x - B * e) (fun e => K e * (x - B * e + PI))); [reg|].
    apply (continuity_pt_mult K (fun e => x - B * e + PI)); [exact CK | reg]. }
  destruct (close_near (fun t => - K t) e) as [d1 [Hd1 N1]]; [now apply continuity_pt_opp | exact He|].
  destruct (close_near (fun t => - C t) e) as [d2 [Hd2 N2]]; [now apply continuity_pt_opp | exact He|].
  assert (B0 : 0 < B) by (apply Rdiv_lt_0_compat; lra). assert (B1 : 0 < / B) by (now apply Rinv_0_lt_compat).
  set (t := Rmin (Rmin (d1 / 2) (d2 / 2)) (Rmin (Rmin e r) (/ B))).
  assert (T0 : 0 < t) by (repeat apply Rmin_glb_lt; lra).
  assert (U1 : t <= Rmin (d1 / 2) (d2 / 2)) by apply Rmin_l. assert (U2 : t <= Rmin (Rmin e r) (/ B)) by apply Rmin_r.
  assert (V1 := Rmin_l (d1 / 2) (d2 / 2)). assert (V2 := Rmin_r (d1 / 2) (d2 / 2)).
  assert (V3 := Rmin_l (Rmin e r) (/ B)).
  assert (V4 := Rmin_r (Rmin e r) (/ B)). assert (V5 := Rmin_l e r). assert (V6 := Rmin_r e r).
  assert (Bt : 0 < B * t <= 1).
  { split; [now apply Rmult_lt_0_compat|]. replace 1 with (B * / B) by (field; lra). apply Rmult_le_compat_l; lra. }
  specialize (N1 t ltac:(lra)). specialize (N2 t ltac:(lra)). cbv beta in N1, N2. rewrite K0 in N1. rewrite C0 in N2.
  destruct (neighbour t ltac:(lra)) as [y [k' [r' [Y1 [Y2 [K1 [Kp [R1 [R2 [K2 [HD [HDe [[S1 S2] H]]]]]]]]]]]]].
  assert (Cy : w <= cos y) by (apply cos_mono; lra). destruct (COS_bound y) as [_ W1].
  set (k1 := next_slope (cos y) k' r') in *.
  assert (G := next_slope_grows (cos y) k' r' ltac:(lra) R2 HD). fold k1 in G.
  destruct (reflect_mono (cos y) w k' k r' r) as [_ S3]; try lra. fold k1 in S3.
  assert (Sy := sin_steps y x ltac:(lra)). assert (S0 : 0 <= sin y) by (apply sin_ge_0; lra).
  assert (P0 : 0 <= k1 * (y + PI)) by (apply Rmult_le_pos; lra).
  assert (Lo : K t * (x - B * t + PI) <= k1 * (y + PI)) by (apply mul_mono; lra).
  assert (Hi : sin y + k1 * (y + PI) <= sin x + next_slope w k r * (x + PI)) by (apply height_mono; lra).
  exists (sin y + k1 * (y + PI)), k1, r'. unfold C in N2. repeat split; try lra. exact H.
Qed.
End Step.

Theorem L29_hits_or_tangent n : forall c k r, 0 <= c -> 0 <= k -> 0 < r <= 1 -> near_below c k r (S n) ->
  coll r (S n) c k \/ exists m a b, (m <= n)%nat /\ state r m c k a b /\ tangent a b.
Proof.
  induction n as [|n IH]; intros c k r Hc Hk Hr HN; destruct (hit_or_tangent c k r _ Hc HN) as [[x Hx]|HT].
  - left. exists x. split; [exact Hx | now left].
  - right. exists O, c, k. split; [lia|]. now split.
  - assert (HD := limit_turns_back c k r x Hr Hx n HN). assert (NB := next_near_below c k r x Hr Hx n HN).
    destruct (next_domain c k r x ltac:(lra) ltac:(lra) Hx HD) as [Q1 Q2]. cbv zeta in Q1, Q2.
    assert (Q3 : 0 <= next_slope (cos x) k r) by lra.
    destruct (IH _ _ r Q2 Q3 Hr NB) as [H|[m [a [b [Hm [H HT]]]]]].
    + left. exists x. split; [exact Hx|right]. now split.
    + right. exists (S m), a, b. split; [lia|]. split; [|exact HT]. exists x. now split.
  - right. exists O, c, k. split; [lia|]. now split.
Qed.

(** Theorem 2 (c): the critical ratios are the ratios at which a flight of an orbit is tangent to the hump. *)
Lemma orbit_near_below c s r n : 0 < r <= 1 -> 0 <= c <= 4 -> 0 <= s <= 1 ->
  (forall r', 0 < r' < r -> coll r' n (c * r') (s * r')) -> near_below (c * r) (s * r) r n.
Proof.
  intros Hr Hc Hs H e He. set (d := Rmin (e / 4) (r / 2)). assert (D1 : d <= e / 4) by apply Rmin_l.
  assert (D2 : d <= r / 2) by apply Rmin_r. assert (D0 : 0 < d) by (apply Rmin_glb_lt; lra).
  assert (0 <= c * d) by (apply Rmult_le_pos; lra). assert (c * d <= 4 * d) by (apply Rmult_le_compat_r; lra).
  assert (0 <= s * d) by (apply Rmult_le_pos; lra). assert (s * d <= 1 * d) by (apply Rmult_le_compat_r; lra).
  assert (0 <= c * (r - d)) by (apply Rmult_le_pos; lra). assert (0 <= s * (r - d)) by (apply Rmult_le_pos; lra).
  exists (c * (r - d)), (s * (r - d)), (r - d). repeat split; try lra. apply H. lra.
Qed.
Lemma tangent_at_critical N k c s q : 0 <= c <= 4 -> 0 <= s <= 1 -> critical N q ->
  (forall p, 1 <= p -> (N_at_least p N <-> coll (/ p) (S k) (c * / p) (s * / p))) ->
  exists m a b, (m <= k)%nat /\ state (/ q) m (c * / q) (s * / q) a b /\ tangent a b.
Proof.
  intros Hc Hs [Hq HQ] HN. assert (Hr := inv_ratio q Hq).
  assert (C0 : 0 <= c * / q) by (apply Rmult_le_pos; lra). assert (S0 : 0 <= s * / q) by (apply Rmult_le_pos; lra).
  destruct (L29_hits_or_tangent k (c * / q) (s * / q) (/ q) C0 S0 Hr) as [H|H]; [| |exact H].
  - apply orbit_near_below; try assumption. intros r' Hr'. rewrite <- (Rinv_inv r').
    assert (L : q < / r') by (rewrite <- (Rinv_inv q); apply Rinv_lt_contravar; [apply Rmult_lt_0_compat|]; lra).
    assert (L1 : 1 <= / r') by lra. exact (proj1 (HN _ L1) (proj2 (HQ _ L1) L)).
  - exfalso. apply (HN q Hq) in H. apply (HQ q Hq) in H. lra.
Qed.
Lemma same_critical M N q : (3 <= M)%nat -> (3 <= N)%nat -> critical M q -> critical N q -> M = N.
Proof.
  intros HM HN A B. assert (HA := N_at_critical M q HM A). assert (HB := N_at_critical N q HN B).
  assert (E := N_unique q _ _ ltac:(destruct A; lra) HA HB). lia.
Qed.
Theorem theorem_2c_odd q k : 1 <= q -> critical (1 + 2 * S k) q <-> exists a b, state (/ q) k (/ q) 0 a b /\
  tangent a b.
Proof.
  intros Hq. split; [|now apply tangent_top_critical]. intros H.
  destruct (tangent_at_critical _ k 1 0 q ltac:(lra) ltac:(lra) H) as [m [a [b [Hm [HS HT]]]]].
  - intros p Hp. rewrite Rmult_1_l, Rmult_0_l. exact (odd_by_top p (S k) Hp).
  - rewrite Rmult_1_l, Rmult_0_l in HS. assert (E : m = k).
    { assert (M : critical (1 + 2 * S m) q) by (apply tangent_top_critical; [exact Hq | exists a, b; now split]).
      assert (E := same_critical (1 + 2 * S m) (1 + 2 * S k) q ltac:(lia) ltac:(lia) M H). lia. }
    subst m. exists a, b. now split.
Qed.
Theorem theorem_2c_even q k : 1 <= q -> critical (2 + 2 * S k) q <-> exists a b, state (/ q) k (PI * / q) (/ q) a b /\
  tangent a b.
Proof.
  assert (HPI := PI2_1). assert (HPI4 := PI_4). intros Hq. split; [|now apply tangent_corner_critical]. intros H.
  destruct (tangent_at_critical _ k PI 1 q ltac:(lra) ltac:(lra) H) as [m [a [b [Hm [HS HT]]]]].
  - intros p Hp. rewrite Rmult_1_l. exact (even_by_corner p (S k) Hp).
  - rewrite Rmult_1_l in HS. assert (E : m = k).
    { assert (M : critical (2 + 2 * S m) q) by (apply tangent_corner_critical; [exact Hq | exists a, b; now split]).
      assert (E := same_critical (2 + 2 * S m) (2 + 2 * S k) q ltac:(lia) ltac:(lia) M H). lia. }
    subst m. exists a, b. now split.
Qed.
