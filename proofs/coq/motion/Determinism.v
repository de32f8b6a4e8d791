(** Determinism: two paths that obey the law on a stretch of time and have the same state at its beginning agree on it;
    so a motion is determined for all later times by its state.

    agree, agree_at == two paths with one state at a time agree later, as long as both obey the law
    must_turn       == a mass that touches the floor does not go on downwards *)
From Coq Require Import Reals Lra.
From Dumbbell Require Import Physics RealInduction Flight Collisions Symmetry Existence.
Local Open Scope R_scope.

Section Determinism.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.

(** The floor's push is determined. *)
Lemma push_determined l v v1 v2 : push P l v v1 -> push P l v v2 -> v1 <> v -> v2 <> v -> v1 = v2.
Proof.
  intros H1 H2 N1 N2. destruct (push_cases P HP _ _ _ H1) as [|[A1 [j1 [J1 [B1 [C1 _]]]]]]; [contradiction|].
  destruct (push_cases P HP _ _ _ H2) as [|[A2 [j2 [J2 [B2 [C2 _]]]]]]; [contradiction|].
  assert (K1 := arm1_pos P HP). assert (K2 := arm2_pos P HP).
  set (g := l / (arm1 P * arm2 P)) in *. rewrite B1, C1 in A1. rewrite B2, C2 in A2.
  assert (S : 0 < 1 + l * g). { unfold g.
    replace (l * (l / (arm1 P * arm2 P))) with (l * l * / (arm1 P * arm2 P)) by (field; lra).
    assert (0 <= l * l * / (arm1 P * arm2 P))
      by (apply Rmult_le_pos; [apply Rle_0_sqr | left; apply Rinv_0_lt_compat; now apply Rmult_lt_0_compat]). lra. }
  assert (j1 = j2) by (apply Rmult_eq_reg_r with (1 + l * g); lra). subst j2. apply vel_eq; congruence.
Qed.
Lemma line_same p q t v s : p t = q t -> on_line p t v s -> on_line q t v s -> p s = q s.
Proof. intros E [A B] [C D]. apply pos_eq; [rewrite A, C, E | rewrite B, D, E]; reflexivity. Qed.

(** A mass that goes down at the floor is turned. *)
Lemma must_turn p t e v : 0 < e -> (forall s, t < s < t + e -> lawful P p s) -> after p t v ->
  (y1 P (p t) = 0 -> 0 <= w1 P (p t) v) /\ (y2 P (p t) = 0 -> 0 <= w2 P (p t) v).
Proof.
  intros He Hg [d [Hd Ha]]. set (d' := Rmin d (e / 2)). assert (D0 : 0 < d') by (apply Rmin_pos; lra).
  assert (D1 : d' <= d) by apply Rmin_l. assert (D2 : d' <= e / 2) by apply Rmin_r.
  split; intros H0; apply Rnot_lt_le; intros Hw.
  - destruct (goes_below (height (p t)) (angle (p t)) (vy v) (om v) (arm1 P) H0 (arm1_pos P HP) Hw d' D0)
      as [s [Hs Hn]].
    destruct (Ha (t + s) ltac:(lra)) as [E1 E2]. replace (t + s - t) with s in * by ring.
    destruct (Hg (t + s) ltac:(lra)) as [K _]. unfold y1 in K. rewrite E1, E2 in K. lra.
  - destruct (goes_below (height (p t)) (angle (p t) + PI) (vy v) (om v) (arm2 P)) with (eps := d') as [s [Hs Hn]];
      try assumption.
    { rewrite neg_sin. unfold y2 in H0. lra. } { exact (arm2_pos P HP). } { rewrite neg_cos. unfold w2 in Hw. lra. }
    destruct (Ha (t + s) ltac:(lra)) as [E1 E2]. replace (t + s - t) with s in * by ring.
    destruct (Hg (t + s) ltac:(lra)) as [_ [K _]]. unfold y2 in K. rewrite E1, E2 in K.
    replace (angle (p t) + PI + om v * s) with (angle (p t) + om v * s + PI) in Hn by ring. rewrite neg_sin in Hn. lra.
Qed.
(** The velocity after a time is determined by the state before it. *)
Lemma turn_determined p q t e v v1 v2 : 0 < e -> (forall s, t <= s < t + e -> lawful P p s) ->
  (forall s, t <= s < t + e -> lawful P q s) -> p t = q t ->
  before p t v -> before q t v -> after p t v1 -> after q t v2 -> v1 = v2.
Proof.
  intros He Gp Gq E Bp Bq Ap Aq.
  assert (Cases : forall f w, (forall s, t <= s < t + e -> lawful P f s) -> before f t v -> after f t w -> f t = p t ->
    w = v \/ (w <> v /\
      ((y1 P (p t) = 0 /\ push1 P (p t) v w /\ w1 P (p t) v < 0) \/
      (y2 P (p t) = 0 /\ push2 P (p t) v w /\ w2 P (p t) v < 0)))).
  { intros f w Gf Bf Af Ef. destruct (Gf t ltac:(lra)) as [_ [_ [_ [u [u' [Hb [Ha H]]]]]]].
    assert (u = v) by (apply before_unique with f t; assumption).
    assert (u' = w) by (apply after_unique with f t; assumption). subst u u'. rewrite Ef in H.
    destruct H as [->|[[H0 H]|[H0 H]]]; [now left | |].
    - destruct (push_cases P HP _ _ _ H) as [->|[_ [j [_ [_ [_ Hw]]]]]]; [now left|].
      destruct (Classical_Prop.classic (w = v)) as [|N]; [now left | right].
      split; [exact N|]. left. split; [exact H0|]. split; [exact H|]. unfold w1. lra.
    - destruct (push_cases P HP _ _ _ H) as [->|[_ [j [_ [_ [_ Hw]]]]]]; [now left|].
      destruct (Classical_Prop.classic (w = v)) as [|N]; [now left | right].
      split; [exact N|]. right. split; [exact H0|]. split; [exact H|]. unfold w2. lra. }
  assert (Free : forall f, (forall s, t <= s < t + e -> lawful P f s) -> after f t v -> f t = p t ->
    ~ (y1 P (p t) = 0 /\ w1 P (p t) v < 0) /\ ~ (y2 P (p t) = 0 /\ w2 P (p t) v < 0)).
  { intros f Gf Af Ef. destruct (must_turn f t e v He) as [M1 M2]; [intros s Hs; apply Gf; lra | exact Af|].
    rewrite Ef in M1, M2.
    split; intros [K1 K2]; [specialize (M1 K1) | specialize (M2 K1)]; lra. }
  assert (Rg : ~ (y1 P (p t) = 0 /\ y2 P (p t) = 0)) by (destruct (Gp t ltac:(lra)) as [_ [_ [K _]]]; exact K).
  destruct (Cases p v1 Gp Bp Ap eq_refl) as [->|[N1 C1]]; destruct (Cases q v2 Gq Bq Aq (eq_sym E)) as [->|[N2 C2]].
  - reflexivity.
  - exfalso. destruct (Free p Gp Ap eq_refl). tauto.
  - exfalso. destruct (Free q Gq Aq (eq_sym E)). tauto.
  - destruct C1 as [[A1 [B1 _]]|[A1 [B1 _]]]; destruct C2 as [[A2 [B2 _]]|[A2 [B2 _]]];
      try (exfalso; apply Rg; now split);
    apply push_determined with (1 := B1); assumption.
Qed.

(** Two paths that agree before a time, and fly freely there, agree at it. *)
Lemma agree_at p q t0 m vp vq : t0 < m -> (forall t, t0 <= t < m -> p t = q t) -> before p m vp -> before q m vq ->
  p m = q m /\ vp = vq.
Proof.
  intros Hm Hbelow [e [He B]] [e' [He' B']]. set (d := Rmin (Rmin e e') (m - t0)).
  assert (D1 : 0 < d) by (repeat apply Rmin_pos; lra). assert (D2 : d <= m - t0) by apply Rmin_r.
  assert (D3 : d <= Rmin e e') by apply Rmin_l. assert (D4 : Rmin e e' <= e) by apply Rmin_l.
  assert (D5 : Rmin e e' <= e') by apply Rmin_r.
  destruct (B (m - d) ltac:(lra)) as [X1 X2]. destruct (B (m - d / 2) ltac:(lra)) as [X3 X4].
  destruct (B' (m - d) ltac:(lra)) as [Y1 Y2]. destruct (B' (m - d / 2) ltac:(lra)) as [Y3 Y4].
  rewrite <- (Hbelow (m - d)) in Y1, Y2 by lra. rewrite <- (Hbelow (m - d / 2)) in Y3, Y4 by lra.
  assert (V1 : vy vp = vy vq) by (apply Rmult_eq_reg_r with (d / 2); lra).
  assert (V2 : om vp = om vq) by (apply Rmult_eq_reg_r with (d / 2); lra).
  split; [apply pos_eq; [rewrite V1 in X1 | rewrite V2 in X2]; lra | now apply vel_eq].
Qed.
Theorem agree p q t0 T v : (forall t, t0 < t < T -> lawful P p t) -> (forall t, t0 < t < T -> lawful P q t) ->
  p t0 = q t0 -> after p t0 v -> after q t0 v ->
  forall t, t0 <= t < T -> p t = q t.
Proof.
  intros Gp Gq E0 Ap Aq T' HT.
  assert (Both : forall m, t0 < m < T -> (forall t, t0 <= t < m -> p t = q t) ->
    p m = q m /\ exists w, after p m w /\ after q m w).
  { intros m M Hb. destruct (Gp m M) as [_ [_ [_ [vp [vp' [Bp [Ap' _]]]]]]].
    destruct (Gq m M) as [_ [_ [_ [vq [vq' [Bq [Aq' _]]]]]]].
    destruct (agree_at p q t0 m vp vq ltac:(lra) Hb Bp Bq) as [Em <-]. split; [exact Em|]. exists vp'.
    split; [exact Ap'|]. replace vp' with vq'; [exact Aq'|].
    apply (turn_determined q p m (T - m) vp); try assumption; try lra; try easy; intros s Hs;
      [apply Gq | apply Gp]; lra. }
  apply (real_induction (fun t => p t = q t) t0 T' E0); [| |lra].
  - intros m M Hb. assert (A : exists w, after p m w /\ after q m w).
    { destruct (Req_dec m t0) as [->|N]; [now exists v|]. apply Both; [lra|]. intros t Ht. apply Hb. lra. }
    destruct A as [w [[e [He A]] [e' [He' A']]]]. exists (Rmin e e'). split; [now apply Rmin_pos|].
    assert (D1 : Rmin e e' <= e) by apply Rmin_l. assert (D2 : Rmin e e' <= e') by apply Rmin_r.
    intros t Ht. apply line_same with m w; [apply Hb; lra | apply A; lra | apply A'; lra].
  - intros m M Hb. apply Both; [lra | exact Hb].
Qed.
Lemma motion_lawful p t : motion P p -> lawful P p t.
Proof. intros Hm. repeat split; apply Hm. Qed.
Theorem determined p q t0 v : motion P p -> motion P q -> p t0 = q t0 -> after p t0 v -> after q t0 v ->
  forall t, t0 <= t -> p t = q t.
Proof.
  intros Hp Hq E Ap Aq t Ht. apply (agree p q t0 (t + 1) v); try assumption; try lra; intros s _;
    now apply motion_lawful.
Qed.
End Determinism.
