(** L40 (a): a motion that comes out of a corner lasts for all later times, meets no other corner, and has at most k1
    = G(pi r, r, r) collisions.

    from_corner == what leaves a corner has few later collisions, and meets no other corner
    corner_flat == in a corner the rod lies on the floor *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics Ray StartRay Flight Collisions Symmetry Existence RayFuture OneFlight EveryState.
From Dumbbell Require Import HalfMotion.
Local Open Scope R_scope.

Section FromCorner.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.
Hypothesis Hr1 : r_of P <= 1.
Notation r := (r_of P).
Notation yh := (yhat_of P).

(** A half motion out of s with at most k1 collisions. *)
Definition few_future s v := exists p, future P s v p /\ forall n, later P p 0 n -> coll r n (PI * r) r.

(* ---------- symmetries: the mirror, and turning by an angle c with sin c = 0, cos c = 1 ---------- *)
Lemma few_mirror s v : few_future (mirror_pos s) (mirror_v v) -> few_future s v.
Proof.
  intros [p [F C]]. exists (mirror p). split; [now apply future_mirror|]. intros n L. apply C.
  rewrite <- (mirror_mirror p). now apply later_mirror.
Qed.
Section Turned.
Variable c : R.
Hypothesis Sc : sin c = 0.
Hypothesis Cc : cos c = 1.
Notation T p := (fun t => turned c (p t)).
Lemma turn_sin s : sin (angle (turned c s)) = sin (angle s).
Proof. simpl. rewrite sin_plus, Sc, Cc. ring. Qed.
Lemma turn_cos s : cos (angle (turned c s)) = cos (angle s).
Proof. simpl. rewrite cos_plus, Sc, Cc. ring. Qed.
Lemma turn_before p t v : before p t v -> before (T p) t v.
Proof. intros [e [He H]]. exists e. split; [exact He|]. intros s Hs. destruct (H s Hs). simpl. split; lra. Qed.
Lemma turn_after p t v : after p t v -> after (T p) t v.
Proof. intros [e [He H]]. exists e. split; [exact He|]. intros s Hs. destruct (H s Hs). simpl. split; lra. Qed.
Lemma turn_lawful p t : lawful P p t -> lawful P (T p) t.
Proof.
  intros [A [B [C [v [v' [D [E F]]]]]]]. unfold lawful, push1, push2, y1, y2 in *. rewrite turn_sin, turn_cos.
  repeat split; try assumption. exists v, v'. split; [now apply turn_before|]. split; [now apply turn_after | exact F].
Qed.
Lemma turn_collision p t : collision P p t -> collision P (T p) t.
Proof.
  intros [v [Hb H]]. exists v. split; [now apply turn_before|]. unfold y1, y2, w1, w2 in *.
  now rewrite turn_sin, turn_cos.
Qed.
Lemma turn_future s v p : future P s v p -> future P (turned c s) v (T p).
Proof.
  intros [A [B C]]. split; [now rewrite A|]. split; [now apply turn_after|]. intros t Ht. now apply turn_lawful, C.
Qed.
Lemma turn_later p n : later P p 0 n -> later P (T p) 0 n.
Proof.
  intros [l [A [B C]]]. exists l. split; [exact A|]. split; [exact B|]. intros t Ht. destruct (C t Ht) as [D E].
  split; [exact D | now apply turn_collision].
Qed.
End Turned.
Lemma few_turn c s v : sin c = 0 -> cos c = 1 -> few_future (turned c s) v -> few_future s v.
Proof.
  intros Sc Cc [p [F C]]. assert (Sn : sin (- c) = 0) by (rewrite sin_neg; lra).
  assert (Cn : cos (- c) = 1) by (now rewrite cos_neg).
  assert (Back : forall a s', a + c = 0 -> turned a (turned c s') = s').
  { intros a s' Ha. apply pos_eq; simpl; lra. }
  exists (fun t => turned (- c) (p t)). split.
  - rewrite <- (Back (- c) s) by ring. now apply turn_future.
  - intros n L. apply C. apply later_near with (fun t => turned c (turned (- c) (p t)));
      [|now apply (turn_later c Sc Cc)].
    intros t _. apply pos_eq; simpl; ring.
Qed.

(* ---------- the first flight ---------- *)
(** K sin (A t) <= V t for small t: K A <= V. *)
Lemma slope_limit K A V e : 0 < e -> 0 <= K -> (forall t, 0 < t < e -> K * sin (A * t) <= V * t) -> K * A <= V.
Proof.
  intros He HK H. apply Rnot_lt_le. intros L. set (d := K * A - V). assert (Hd : 0 < d) by (unfold d; lra).
  set (q := K * (A * A) + 1). assert (Hq : 0 < q). { unfold q.
  assert (0 <= K * (A * A)) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]). lra. }
  set (t := Rmin (e / 2) (d / q)). assert (Hdq : 0 < d / q) by (now apply Rdiv_lt_0_compat).
  assert (T0 : 0 < t) by (apply Rmin_pos; lra). assert (T1 : t <= e / 2) by apply Rmin_l.
  assert (T2 : t <= d / q) by apply Rmin_r.
  assert (T3 : t * q <= d). { replace d with (d / q * q) by (field; lra). apply Rmult_le_compat_r; lra. }
  specialize (H t ltac:(lra)). assert (S := sin_shift 0 (A * t)). rewrite sin_0, cos_0, Rplus_0_l in S.
  apply Rabs_le_between in S.
  assert (K * (A * t - A * t * (A * t)) <= K * sin (A * t)) by (apply Rmult_le_compat_l; lra).
  assert (t * (t * q) <= t * d) by (apply Rmult_le_compat_l; lra). unfold d, q in *.
  assert (0 < t * t) by (now apply Rmult_lt_0_compat). lra.
Qed.

(** The corner psi = pi/2. *)
Definition at_corner s := height s = 0 /\ angle s = PI.
Section First.
Variables (s : pos) (u : vel) (e : R).
Hypothesis Hs : at_corner s.
Hypothesis He : 0 < e.
Hypothesis Hg : forall t, 0 < t < e -> lawful P (line s u) t.
Lemma corner_line t : psi_of (line s u t) = PI/2 + u_of u * t /\ yh (line s u t) = v_of P u * t.
Proof.
  destruct Hs as [H0 Ha]. split; [rewrite line_psi; unfold psi_of; rewrite Ha; field|].
  rewrite (line_yh P HP). unfold yhat_of. rewrite H0. unfold Rdiv. ring.
Qed.
Lemma corner_cos x : cos (PI/2 + x) = - sin x.
Proof. rewrite cos_plus, cos_PI2, sin_PI2. ring. Qed.
Lemma first_above t : 0 < t < e -> sin (u_of u * t) <= v_of P u * t /\ - r * sin (u_of u * t) <= v_of P u * t /\
  ~ (sin (u_of u * t) = 0 /\ v_of P u * t = 0).
Proof.
  intros Ht. destruct (Hg t Ht) as [A [B [C _]]]. assert (A1 := arm1_pos P HP).
  destruct (L0_heights P (line s u t) HP) as [E1 E2]. fold (r_of P) in E2. destruct (corner_line t) as [Ep Ey].
  rewrite Ep, Ey, corner_cos in E1, E2. rewrite E1 in A, C. rewrite E2 in B, C.
  assert (0 <= v_of P u * t + - sin (u_of u * t)) by (apply Rmult_le_reg_l with (arm1 P); lra).
  assert (0 <= v_of P u * t - r * - sin (u_of u * t)) by (apply Rmult_le_reg_l with (arm1 P); lra).
  split; [lra|]. split; [lra|]. intros [K1 K2]. apply C. rewrite K1, K2. split; ring.
Qed.
Lemma first_slopes : u_of u <= v_of P u /\ r * - u_of u <= v_of P u /\ 0 < v_of P u.
Proof.
  assert (R0 := r_pos P HP).
  assert (A : 1 * u_of u <= v_of P u). { apply slope_limit with e; [exact He | lra|]. intros t Ht.
  destruct (first_above t Ht). lra. }
  assert (B : r * - u_of u <= v_of P u).
  { apply slope_limit with e; [exact He | lra|]. intros t Ht. destruct (first_above t Ht) as [_ [K _]].
    replace (- u_of u * t) with (- (u_of u * t)) by ring. rewrite sin_neg. lra. }
  split; [lra|]. split; [exact B|]. apply Rnot_le_lt. intros L.
  assert (0 <= v_of P u). { destruct (Rle_or_lt 0 (u_of u)); [lra|].
  assert (0 < r * - u_of u) by (apply Rmult_lt_0_compat; lra). lra. }
  assert (Z : v_of P u = 0) by lra. assert (Zu : u_of u = 0).
  { apply Rle_antisym; [lra|]. apply Rnot_lt_le. intros N. assert (0 < r * - u_of u) by (apply Rmult_lt_0_compat; lra).
    lra. }
  destruct (first_above (e / 2) ltac:(lra)) as [_ [_ K]]. apply K. rewrite Z, Zu, !Rmult_0_l, sin_0. now split.
Qed.

(** Steep, or to the right: no collision at all (L3). *)
Lemma corner_steep : Rabs (u_of u) <= v_of P u -> few_future s u.
Proof.
  intros Hu. destruct first_slopes as [_ [_ Hv]]. assert (R0 := r_pos P HP).
  assert (Hf : forall t, 0 < t -> free P (line s u t)).
  { intros t Ht. destruct (corner_line t) as [Ep Ey]. unfold free. rewrite Ep, Ey, corner_cos.
    assert (V : 0 < v_of P u * t) by (now apply Rmult_lt_0_compat).
    assert (Rabs (u_of u) * t <= v_of P u * t) by (apply Rmult_le_compat_r; lra).
    assert (Hsin : Rabs (sin (u_of u * t)) <= Rabs (u_of u) * t).
    { assert (K := sin_lipschitz 0 (u_of u * t)). rewrite sin_0, !Rminus_0_r, Rabs_mult, (Rabs_pos_eq t) in K by lra.
      exact K. }
    apply Rabs_le_between in Hsin. split; [exact V|]. split; [lra|].
    assert (r * - sin (u_of u * t) <= r * (v_of P u * t)) by (apply Rmult_le_compat_l; lra).
    assert (r * (v_of P u * t) <= 1 * (v_of P u * t)) by (apply Rmult_le_compat_r; lra). lra. }
  exists (line s u). assert (F := future_line P HP s u Hf). split; [exact F|].
  intros n L. now rewrite (future_line_none P HP s u (line s u) n Hf F L).
Qed.

(** To the left with a slope k below 1: k >= r, the ray (pi k, k). *)
Lemma corner_left : u_of u < 0 -> few_future s u.
Proof.
  intros Hu. destruct first_slopes as [_ [Hk Hv]]. assert (R0 := r_pos P HP).
  assert (HPI : 0 < PI) by apply PI_RGT_0. assert (P2 := PI2_1).
  set (k := v_of P u / - u_of u). assert (Ek : k * - u_of u = v_of P u) by (unfold k; field; lra).
  assert (Kr : r <= k) by (apply Rmult_le_reg_r with (- u_of u); lra).
  assert (Sin : forall x, 0 < x -> sin x < x) by apply sin_lt_x.
  assert (Cos : forall z, z < PI/2 -> cos z < PI/2 - z).
  { intros z Hz. replace (cos z) with (sin (PI/2 - z)) by (rewrite sin_minus, cos_PI2, sin_PI2; ring). apply Sin. lra. }
  set (t0 := / - u_of u). assert (T0 : 0 < t0) by (apply Rinv_0_lt_compat; lra).
  assert (Et : - u_of u * t0 = 1) by (unfold t0; field; lra).
  set (s1 := line s u t0). destruct (corner_line t0) as [E1 E2]. fold s1 in E1, E2.
  assert (E1' : psi_of s1 = PI/2 - 1) by lra.
  assert (E2' : yh s1 = k) by (rewrite E2, <- Ek; replace (k * - u_of u * t0) with (k * (- u_of u * t0)) by ring;
    rewrite Et; ring).
  assert (SR : start_ray P s1 u (PI * k) k).
  { split; rewrite ?E1', ?E2'; try assumption; try lra. intros z Hz.
    assert (0 <= cos z) by (apply cos_ge_0; lra). assert (C := Cos z ltac:(lra)).
    assert (r * cos z < r * (PI/2 - z)) by (now apply Rmult_lt_compat_l).
    assert (r * (PI/2 - z) <= k * (PI/2 - z)) by (apply Rmult_le_compat_r; lra).
    assert (0 <= r * cos z) by (apply Rmult_le_pos; lra). split; lra. }
  destruct (ray_future P HP Hr1 s1 u _ _ SR ltac:(lra)) as [p1 [F1 _]].
  assert (Hf : forall t, 0 < t <= t0 -> free P (line s u t)).
  { intros t Ht. destruct (corner_line t) as [Ep Ey]. unfold free. rewrite Ep, Ey.
    assert (X0 : 0 < - u_of u * t) by (apply Rmult_lt_0_compat; lra).
    assert (X1 : - u_of u * t <= - u_of u * t0) by (apply Rmult_le_compat_l; lra).
    assert (C := Cos (PI/2 + u_of u * t) ltac:(lra)). assert (0 <= cos (PI/2 + u_of u * t)) by (apply cos_ge_0; lra).
    assert (V : v_of P u * t = k * (- u_of u * t)) by (rewrite <- Ek; ring).
    assert (0 < k * (- u_of u * t)) by (apply Rmult_lt_0_compat; lra).
    assert (r * cos (PI/2 + u_of u * t) <= r * (- u_of u * t)) by (apply Rmult_le_compat_l; lra).
    assert (r * (- u_of u * t) <= k * (- u_of u * t)) by (apply Rmult_le_compat_r; lra). repeat split; lra. }
  set (p := glue t0 (line s u) p1). destruct F1 as [G1 [G2 G3]]. exists p.
  assert (Eat : p t0 = s1) by (unfold p; now rewrite glue_at).
  assert (Good : forall t, 0 < t -> lawful P p t).
  { intros t Ht. destruct (Rtotal_order t t0) as [L|[->|L]].
    - apply near_lawful with (line s u); [now apply glue_left|]. apply (line_lawful P HP), Hf. lra.
    - destruct (free_above P HP s1 ltac:(apply Hf; lra)) as [A [B C]]. unfold lawful. rewrite Eat.
      repeat split; try assumption.
      exists u, u. split; [apply glue_before, line_before|]. split; [now apply glue_after | now left].
    - apply near_lawful with (shift t0 p1); [now apply glue_right|]. apply shift_lawful, G3. lra. }
  split.
  - split; [unfold p, glue; destruct (Rle_dec 0 t0); [apply line_0 | lra]|]. split; [|exact Good].
    apply near_after with (line s u); [now apply glue_left | apply line_after].
  - intros n L. assert (G : coll r n (PI * k) k).
    { apply (future_count P HP Hr1 n s1 u (PI * k) k p1 SR); [lra | exact (conj G1 (conj G2 G3))|].
      destruct L as [l [A [B C]]]. apply (later_from P p1 0 n (map (fun t => t - t0) l)).
      - apply FinFun.Injective_map_NoDup; [intros x y E; lra | exact A].
      - rewrite map_length. lia.
      - intros t Ht. apply in_map_iff in Ht. destruct Ht as [t' [<- Ht']]. destruct (C t' Ht') as [D E].
        destruct (Rtotal_order t' t0) as [K|[->|K]].
        + exfalso. apply (free_no_collision P HP p t' u 1 ltac:(lra)) with (4 := E); [intros x Hx; apply Good; lra | |].
          * apply near_before with (line s u); [now apply glue_left | apply line_before].
          * apply near_after with (line s u); [now apply glue_left | apply line_after].
        + exfalso. apply (free_no_collision P HP p t0 u 1 ltac:(lra)) with (4 := E); [intros x Hx; apply Good; lra | |].
          * apply glue_before, line_before.
          * now apply glue_after.
        + split; [lra|]. apply near_collision with (shift (- t0) p).
          * exists ((t' - t0) / 2). split; [lra|]. intros x Hx. unfold shift, p, glue.
            destruct (Rle_dec (x - - t0) t0); [lra|]. f_equal. ring.
          * apply shift_collision. now replace (t' - t0 - - t0) with t' by ring. }
    apply (coll_mono n) with (8 := G); try lra; [apply Rmult_le_pos; lra | apply Rmult_le_compat_l; lra].
Qed.
Lemma first_flight : few_future s u.
Proof.
  destruct (Rlt_or_le (u_of u) 0) as [L|L]; [now apply corner_left|]. destruct first_slopes as [A _].
  apply corner_steep.
  now rewrite Rabs_pos_eq.
Qed.
End First.

Lemma corner_flat s : corner P s -> height s = 0 /\ sin (angle s) = 0.
Proof.
  intros [H1 H2]. assert (A1 := arm1_pos P HP). assert (A2 := arm2_pos P HP). unfold y1, y2 in H1, H2.
  assert (S0 : sin (angle s) = 0) by (apply Rmult_eq_reg_l with (arm1 P + arm2 P); lra).
  split; [rewrite S0 in H1; lra | exact S0].
Qed.

(** Out of any corner. *)
Theorem from_corner s u e : corner P s -> 0 < e -> (forall t, 0 < t < e -> lawful P (line s u) t) -> few_future s u.
Proof.
  intros Hs He Hg. destruct (corner_flat s Hs) as [H0 S0].
  assert (Main : forall s u, height s = 0 -> sin (angle s) = 0 -> cos (angle s) = -1 ->
    (forall t, 0 < t < e -> lawful P (line s u) t) -> few_future s u).
  { clear s u Hs S0 H0 Hg. intros s u H0 S0 C0 Hg. set (c := PI - angle s).
    assert (Sc : sin c = 0) by (unfold c; rewrite sin_PI_x; exact S0).
    assert (Cc : cos c = 1) by (unfold c; rewrite cos_minus, cos_PI, sin_PI, C0; ring).
    apply (few_turn c s u Sc Cc), (first_flight (turned c s) u e); [split; [exact H0 | simpl; unfold c;
      ring] | exact He|].
    intros t Ht. apply near_lawful with (fun t => turned c (line s u t)); [|now apply (turn_lawful c Sc Cc), Hg].
    exists 1. split; [lra|]. intros x _. apply pos_eq; simpl; ring. }
  assert (SC := sin2_cos2 (angle s)). unfold Rsqr in SC. rewrite S0 in SC.
  assert (Cz : (cos (angle s) - 1) * (cos (angle s) + 1) = 0) by lra. apply Rmult_integral in Cz.
  destruct Cz as [C0|C0].
  - apply few_mirror, Main; simpl; [exact H0 | now rewrite sin_PI_x | rewrite cos_minus, cos_PI, sin_PI; lra|].
    intros t Ht. apply near_lawful with (mirror (line s u)); [|now apply mirror_lawful, Hg].
    exists 1. split; [lra|]. intros x _. apply pos_eq; simpl; ring.
  - apply Main; try assumption. lra.
Qed.
End FromCorner.
