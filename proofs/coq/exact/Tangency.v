(** Theorem 2 (c), one half, and (d): if a flight of an orbit is tangent to the hump, the ratio is critical; and
    q_c(4) = sqrt(1 + x^2), x the root of tan x = x between pi and 3 pi / 2.

    state r n c k c' k'                      == the ray (c, k) is the ray (c', k') after n collisions
    tangent c k                              == the ray touches the hump, and does not cross it
    tangent_top_critical, tangent_corner_critical == Theorem 2 (c), from a tangency to the critical ratio *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics Ray Orbits Openness ExactMaximum CriticalRatios.
Local Open Scope R_scope.

(** The ray (c, k) is in the state (c', k') after n collisions, and goes on from there. *)
Fixpoint state (r : R) (n : nat) (c k c' k' : R) : Prop :=
  match n with
  | O => c' = c /\ k' = k
  | S m => exists x, hit c k x /\ 0 < slope_den (cos x) k r /\
      state r m (sin x + next_slope (cos x) k r * (x + PI)) (next_slope (cos x) k r) c' k'
  end.
(** The flight touches the hump and is nowhere below it: its margin is 0. *)
Definition tangent (c k : R) :=
  (exists x, 0 <= x <= PI/2 /\ sin x = c + k * x) /\ (forall y, 0 <= y <= PI/2 -> sin y <= c + k * y).

Lemma state_coll r n c k c' k' : state r n c k c' k' -> coll r n c k.
Proof.
  revert c k. induction n as [|n IH]; intros c k H; [exact I|]. destruct H as [x [Hx [HD H]]].
  exists x. split; [exact Hx|right]. split; [exact HD | now apply IH].
Qed.
Lemma state_more r n m c k c' k' : state r n c k c' k' -> coll r m c' k' -> coll r (n + m) c k.
Proof.
  revert c k. induction n as [|n IH]; intros c k H Hm; simpl in H; [destruct H as [<- <-]; exact Hm|].
  destruct H as [x [Hx [HD H]]]. exists x. split; [exact Hx|right]. split; [exact HD | now apply IH].
Qed.
Lemma state_rest r n m c k c' k' : state r n c k c' k' -> (0 < m)%nat -> coll r (n + m) c k -> coll r m c' k'.
Proof.
  intros H Hm. revert c k H. induction n as [|n IH]; intros c k H Hn; simpl in H; [destruct H as [-> ->]; exact Hn|].
  destruct H as [x [Hx [HD H]]]. destruct Hn as [y [Hy Hn]]. assert (y = x) by (now apply (FewHits.hit_unique c k)).
  subst y.
  destruct Hn as [Hn|[_ Hn]]; [lia|]. now apply (IH _ _ H).
Qed.

(** A tangent flight does not collide, and every lower one does. *)
Lemma tangent_misses c k : 0 <= c -> tangent c k -> forall y, ~ hit c k y.
Proof.
  intros Hc [_ HT] y Hy. assert (HPI := PI2_1). destruct (raised_hit c k y Hc Hy) as [Hp [d [Hd H]]].
  destruct (H (d / 2) ltac:(lra)) as [_ [_ [z [[Z1 [Z2 _]] _]]]]. specialize (HT z ltac:(lra)).
  assert (P : 0 < share k y * (d / 2)) by (apply Rmult_lt_0_compat; lra).
  assert (0 <= share k y * (d / 2) * z) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma tangent_hit c k c' k' : 0 <= c' < c -> k' <= k -> tangent c k -> exists x, hit c' k' x.
Proof.
  intros Hc Hk [[x [Hx Hs]] _]. destruct (hit_exists c' k' x) as [y [Hy _]]; [lra | exact Hx | | now exists y].
  assert (k' * x <= k * x) by (apply Rmult_le_compat_r; lra). lra.
Qed.

(** L26: states stay in strict order. *)
Lemma L26_strict n : forall c k r c' k' r' a b, 0 <= c' < c -> - r' <= k' <= k -> 0 < r' <= r -> r <= 1 ->
  state r n c k a b ->
  exists a' b', state r' n c' k' a' b' /\ 0 <= a' < a /\ b' <= b.
Proof.
  induction n as [|n IH]; intros c k r c' k' r' a b Hc Hk Hr Hr1 H; simpl in H.
  - destruct H as [-> ->]. exists c', k'. simpl. repeat split; lra.
  - destruct H as [x [Hx [HD H]]]. destruct (flight_mono c' k' c k x) as [x' [Hx' Hxx]]; try lra; [exact Hx|].
    assert (X := Hx). assert (X' := Hx'). destruct X as [X1 [X2 X3]], X' as [Y1 [Y2 Y3]].
    assert (W := cos_pos _ X1). assert (C : cos x <= cos x') by (apply cos_mono; lra).
    assert (L : x' < x).
    { destruct (Rle_lt_or_eq_dec x' x Hxx) as [|E]; [assumption|]. subst x'. assert (k' * x <= k * x)
      by (apply Rmult_le_compat_r; lra). lra. }
    destruct (reflect_mono (cos x') (cos x) k' k r' r) as [D1 K1]; try lra.
    destruct (next_domain c' k' r' x') as [Q1 Q2]; try lra; [exact Hx'|]. cbv zeta in Q1, Q2. assert (HPI := PI2_1).
    assert (S : sin x' < sin x) by (apply sin_increasing_1; lra).
    assert (M : next_slope (cos x') k' r' * (x' + PI) <= next_slope (cos x) k r * (x + PI)) by (apply mul_mono; lra).
    set (k1 := next_slope (cos x') k' r') in *. set (k2 := next_slope (cos x) k r) in *.
    assert (L2 : 0 <= sin x' + k1 * (x' + PI) < sin x + k2 * (x + PI)) by lra.
    destruct (IH (sin x + k2 * (x + PI)) k2 r (sin x' + k1 * (x' + PI)) k1 r' a b L2) as [a' [b' [G1 G2]]]; try lra;
      [exact H|].
    exists a', b'. split; [|exact G2]. exists x'. now split.
Qed.

(** An orbit whose flight k + 1 is tangent at r has k + 1 collisions below r, and not at r. *)
Lemma tangent_interval r k c s : 0 < r <= 1 -> 0 < c -> 0 <= s -> (exists a b, state r k (c * r) (s * r) a b /\
  tangent a b) ->
  (forall r', 0 < r' < r -> coll r' (S k) (c * r') (s * r')) /\ ~ coll r (S k) (c * r) (s * r).
Proof.
  intros Hr Hc Hs [a [b [H HT]]]. assert (Hsr : forall t, 0 < t -> 0 < c * t /\ 0 <= s * t).
  { intros t Ht. split; [apply Rmult_lt_0_compat | apply Rmult_le_pos]; lra. }
  split.
  - intros r' Hr'. destruct (Hsr r ltac:(lra)). destruct (Hsr r' ltac:(lra)).
    assert (c * r' < c * r) by (apply Rmult_lt_compat_l; lra).
    assert (s * r' <= s * r) by (apply Rmult_le_compat_l; lra).
    destruct (L26_strict k (c * r) (s * r) r (c * r') (s * r') r' a b) as [a' [b' [G1 [G2 G3]]]]; try lra; [exact H|].
    destruct (tangent_hit a b a' b' G2 G3 HT) as [x Hx]. replace (S k) with (k + 1)%nat by lia.
    apply state_more with (1 := G1). exists x. split; [exact Hx | now left].
  - intros K. replace (S k) with (k + 1)%nat in K by lia. apply (state_rest _ _ _ _ _ _ _ H) in K; [|lia].
    destruct K as [x [Hx _]]. assert (A : 0 <= a).
    { clear - H Hr Hsr. destruct (Hsr r ltac:(lra)) as [A B]. 
      destruct (L26_strict k (c * r) (s * r) r 0 (- r) r a b) as [a' [b' [_ [G _]]]]; try lra. exact H. }
    now apply (tangent_misses a b A HT x).
Qed.

Lemma critical_from_interval N k c s q : 1 <= q -> (forall p, 1 <= p ->
  (N_at_least p N <-> coll (/ p) (S k) (c * / p) (s * / p))) ->
  (forall r r', 0 < r -> r <= r' -> r' <= 1 -> coll r' (S k) (c * r') (s * r') -> coll r (S k) (c * r) (s * r)) ->
  0 < c -> 0 <= s -> (exists a b, state (/ q) k (c * / q) (s * / q) a b /\ tangent a b) -> critical N q.
Proof.
  intros Hq HN HM Hc Hs HT. destruct (tangent_interval _ k c s (inv_ratio q Hq) Hc Hs HT) as [A B].
  split; [exact Hq|]. intros p Hp. rewrite (HN p Hp). split.
  - intros H. apply Rnot_le_lt. intros L. apply B.
  apply (HM (/ q) (/ p)); [apply inv_ratio; lra | | apply inv_ratio; lra | exact H].
    apply Rinv_le_contravar; lra.
  - intros L. apply A. split; [apply inv_ratio; lra|].
    apply Rinv_lt_contravar; [apply Rmult_lt_0_compat; lra | exact L].
Qed.
Theorem tangent_top_critical q k : 1 <= q -> (exists a b, state (/ q) k (/ q) 0 a b /\ tangent a b) ->
  critical (1 + 2 * S k) q.
Proof.
  intros Hq H. apply (critical_from_interval _ k 1 0 q Hq); try lra.
  - intros p Hp. rewrite Rmult_1_l, Rmult_0_l. exact (odd_by_top p (S k) Hp).
  - intros r r' H0 H1 H2. rewrite !Rmult_1_l, !Rmult_0_l. now apply Monotone.top_mono.
  - rewrite Rmult_1_l, Rmult_0_l. exact H.
Qed.
Theorem tangent_corner_critical q k : 1 <= q -> (exists a b, state (/ q) k (PI * / q) (/ q) a b /\ tangent a b) ->
  critical (2 + 2 * S k) q.
Proof.
  intros Hq H. assert (HPI := PI2_1). apply (critical_from_interval _ k PI 1 q Hq); try lra.
  - intros p Hp. rewrite Rmult_1_l. exact (even_by_corner p (S k) Hp).
  - intros r r' H0 H1 H2. rewrite !Rmult_1_l. now apply Monotone.corner_mono.
  - rewrite Rmult_1_l. exact H.
Qed.

(** Theorem 2 (d). *)
Theorem critical_4 x : PI < x < 3 * (PI / 2) -> tan x = x -> critical 4 (sqrt (1 + x * x)).
Proof.
  intros Hx Ht. assert (HPI := PI2_1). set (Q := sqrt (1 + x * x)).
  assert (QQ : Q * Q = 1 + x * x) by (apply sqrt_sqrt; nra).
  assert (Q1 : 1 <= Q) by (rewrite <- sqrt_1; apply sqrt_le_1; nra).
  assert (Hs : sin x < 0) by (apply sin_lt_0; lra). assert (Hc : cos x < 0) by (apply cos_lt_0; lra).
  assert (E : sin x = x * cos x) by (unfold tan in Ht; rewrite <- Ht at 2; field; lra).
  assert (S2 := sin2_cos2 x). unfold Rsqr in S2. rewrite E in S2.
  assert (C : - cos x = / Q).
  { apply Rmult_eq_reg_l with Q; [|lra]. rewrite Rinv_r by lra.
    assert (Z : (Q * - cos x - 1) * (Q * - cos x + 1) = 0).
    { replace ((Q * - cos x - 1) * (Q * - cos x + 1)) with (Q * Q * (cos x * cos x) - 1) by ring. rewrite QQ. lra. }
    apply Rmult_integral in Z. destruct Z as [Z|Z]; [lra|].
    assert (0 < Q * - cos x) by (apply Rmult_lt_0_compat; lra). lra. }
  apply (tangent_corner_critical Q 0 Q1). exists (PI * / Q), (/ Q). split; [now split|].
  assert (Es : sin (x - PI) = PI * / Q + / Q * (x - PI)).
  { rewrite sin_minus, sin_PI, cos_PI, <- C, E. ring. }
  assert (Ec : cos (x - PI) = / Q) by (rewrite cos_minus, sin_PI, cos_PI, <- C; ring).
  split; [exists (x - PI); split; [lra | exact Es]|]. intros y Hy.
  assert (T := sin_below_tangent (x - PI) y ltac:(lra) ltac:(lra)). rewrite Ec, Es in T. lra.
Qed.
