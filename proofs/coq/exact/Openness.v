(** L20: a count never drops suddenly. A ray with n collisions keeps them when c, k and r are raised a little; by L5
    (d) so does every ray below the raised one, so that {G >= n} is open. One parameter t moves everything: the
    point at which the raised ray is below the wall is x + t.

    share                     == the part of a raise by which the point of collision may move
    L20_raise                 == a ray with n collisions keeps them when c, k, r are raised a little
    positive_near, close_near == what continuity says near 0 *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Ray.
Local Open Scope R_scope.

Lemma positive_near f : continuity_pt f 0 -> 0 < f 0 -> exists d, 0 < d /\ forall t, 0 <= t < d -> 0 < f t.
Proof.
  intros Hf H0. destruct (Hf (f 0) H0) as [d [Hd H]]. exists d. split; [exact Hd|]. intros t Ht.
  destruct (Req_dec t 0) as [->|Hn]; [exact H0|]. assert (K : Rabs (f t - f 0) < f 0).
  { apply H. split; [split; [exact I | lra]|]. unfold dist; simpl. unfold R_dist. rewrite Rminus_0_r, Rabs_pos_eq;
      lra. }
  apply Rabs_def2 in K. lra.
Qed.
Lemma close_near f e : continuity_pt f 0 -> 0 < e -> exists d, 0 < d /\ forall t, 0 <= t < d -> f t < f 0 + e.
Proof.
  intros Hf He. destruct (positive_near (fun t => f 0 + e - f t)) as [d [Hd H]]; [|lra|].
  - apply continuity_pt_minus; [apply continuity_pt_const; now intros x y | exact Hf].
  - exists d. split; [exact Hd|]. intros t Ht. specialize (H t Ht). lra.
Qed.

(** The raised ray collides at x + t at the latest. *)
Definition share (k x : R) := (cos x - k) / (4 * (1 + PI)).
Lemma raised_hit c k x : 0 <= c -> hit c k x -> 0 < share k x /\ exists d, 0 < d /\ forall t, 0 < t < d ->
  x + t < PI/2 /\ k + share k x * t < cos (x + t) /\
  exists y, hit (c + share k x * t) (k + share k x * t) y /\ y <= x + t.
Proof.
  intros Hc [Hx [Hs Hk]]. assert (HPI := PI2_1). set (p := share k x).
  assert (Hp : 0 < p) by (apply Rdiv_lt_0_compat; lra). assert (Ep : 4 * (p * (1 + PI)) = cos x - k)
    by (unfold p, share; field; lra).
  split; [exact Hp|]. destruct (positive_near (fun t => cos (x + t) - k - p * (1 + PI) - p * t)) as [d [Hd H]].
  { reg. } { rewrite Rplus_0_r. lra. }
  exists (Rmin d (PI/2 - x)). split; [apply Rmin_glb_lt; lra|]. intros t [Ht0 Ht].
  assert (Ht1 : t < d) by (apply Rlt_le_trans with (1 := Ht), Rmin_l). assert (Ht2 : t < PI/2 - x)
    by (apply Rlt_le_trans with (1 := Ht), Rmin_r).
  specialize (H t ltac:(lra)). assert (Hq : 0 < p * (1 + PI)) by (apply Rmult_lt_0_compat; lra).
  split; [lra|]. split; [lra|].
  apply hit_exists; [assert (0 < p * t) by (apply Rmult_lt_0_compat; lra); lra | lra|].
  assert (T := sin_below_tangent (x + t) x ltac:(lra) ltac:(lra)).
  assert (K : 0 < t * (cos (x + t) - k - p * (1 + PI))) by (apply Rmult_lt_0_compat; [lra|]; assert (0 < p * t)
    by (apply Rmult_lt_0_compat; lra); lra).
  assert (0 <= p * t * (PI - (x + t))) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra | lra]). lra.
Qed.

(** L20, with room to spare in c, k and r. *)
Theorem L20_raise n : forall c k r, 0 <= c -> 0 < r -> - r <= k -> coll r n c k ->
  exists e, 0 < e /\ forall c' k' r', 0 <= c' <= c + e -> - r' <= k' <= k + e -> 0 < r' <= r + e -> r' <= 1 ->
    coll r' n c' k'.
Proof.
  induction n as [|n IH]; intros c k r Hc Hr Hk H; [exists 1; split; [lra | easy]|].
  destruct H as [x [Hx Hn]]. destruct (raised_hit c k x Hc Hx) as [Hp [d [Hd Hh]]]. set (p := share k x) in *.
  assert (Hx' := Hx). destruct Hx' as [Hx0 [_ Hkx]].
  assert (Hpt : forall t, 0 < t -> 0 < p * t) by (intros t Ht; now apply Rmult_lt_0_compat).
  destruct (Nat.eq_dec n 0) as [->|Hn0].
  - exists (p * (d / 2)). split; [apply Hpt; lra|]. intros c' k' r' C K Rr R1.
    destruct (Hh (d / 2) ltac:(lra)) as [_ [_ [y [Hy _]]]].
    destruct (flight_mono c' k' (c + p * (d / 2)) (k + p * (d / 2)) y) as [z [Hz _]]; try lra; [exact Hy|].
    exists z. split; [exact Hz | now left].
  - destruct Hn as [Hn|[HD Hn]]; [contradiction|]. cbv zeta in Hn.
  destruct (next_domain c k r x Hr Hk Hx HD) as [Q1 Q2]. cbv zeta in Q1, Q2.
    assert (Q3 : - r <= next_slope (cos x) k r) by lra. destruct (IH _ _ r Q2 Hr Q3 Hn) as [e [He IHe]]. clear Q3.
    set (Dt := fun t => slope_den (cos (x + t)) (k + p * t) (r + p * t)).
    set (Kt := fun t => next_slope (cos (x + t)) (k + p * t) (r + p * t)).
    set (Ct := fun t => sin (x + t) + Kt t * (x + t + PI)).
    assert (D0 : 0 < Dt 0) by (unfold Dt; rewrite Rmult_0_r, !Rplus_0_r; exact HD).
    assert (CD : continuity_pt Dt 0) by (unfold Dt, slope_den; reg).
    assert (CN : continuity_pt (fun t => slope_num (cos (x + t)) (k + p * t) (r + p * t)) 0)
      by (unfold slope_num; reg).
    assert (CK : continuity_pt Kt 0).
    { change Kt with (div_fct (fun t => slope_num (cos (x + t)) (k + p * t) (r + p * t)) Dt).
      apply continuity_pt_div; [exact CN | exact CD | lra]. }
    assert (CC : continuity_pt Ct 0).
    { unfold Ct. apply (continuity_pt_plus (fun t => sin (x + t)) (fun t => Kt t * (x + t + PI))); [reg|].
      apply (continuity_pt_mult Kt (fun t => x + t + PI)); [exact CK | reg]. }
    assert (K0 : Kt 0 = next_slope (cos x) k r) by (unfold Kt; now rewrite Rmult_0_r, !Rplus_0_r).
    assert (C0 : Ct 0 = sin x + next_slope (cos x) k r * (x + PI))
      by (unfold Ct; rewrite K0, !Rplus_0_r; reflexivity).
    destruct (positive_near Dt CD D0) as [d1 [Hd1 N1]]. destruct (close_near Kt e CK He) as [d2 [Hd2 N2]].
    destruct (close_near Ct e CC He) as [d3 [Hd3 N3]].
    set (t := Rmin (Rmin d d1) (Rmin (Rmin d2 d3) (e / p)) / 2).
    assert (Hep : 0 < e / p) by (now apply Rdiv_lt_0_compat).
    assert (M : 0 < Rmin (Rmin d d1) (Rmin (Rmin d2 d3) (e / p))) by (repeat apply Rmin_glb_lt; assumption).
    assert (Ht : 0 < t) by (unfold t; lra).
    assert (T1 : t < d) by (unfold t in *; assert (U1 := Rmin_l (Rmin d d1) (Rmin (Rmin d2 d3) (e / p)));
      assert (U2 := Rmin_l d d1); lra).
    assert (T2 : t < d1) by (unfold t in *; assert (U1 := Rmin_l (Rmin d d1) (Rmin (Rmin d2 d3) (e / p)));
      assert (U2 := Rmin_r d d1); lra).
    assert (U3 := Rmin_r (Rmin d d1) (Rmin (Rmin d2 d3) (e / p))). assert (U4 := Rmin_l (Rmin d2 d3) (e / p)).
    assert (U5 := Rmin_r (Rmin d2 d3) (e / p)).
    assert (T3 : t < d2) by (unfold t in *; assert (U2 := Rmin_l d2 d3); lra).
    assert (T4 : t < d3) by (unfold t in *; assert (U2 := Rmin_r d2 d3); lra).
    assert (T5 : p * t <= e).
    { assert (p * t <= p * (e / p)) by (apply Rmult_le_compat_l; unfold t in *; lra).
      replace (p * (e / p)) with e in H by (field; lra). exact H. }
    exists (p * t). split; [now apply Hpt|]. intros c' k' r' C K Rr R1. assert (Pt := Hpt t Ht).
    destruct (Hh t ltac:(lra)) as [Xt [Kx [y [Hy Hyt]]]].
    destruct (flight_mono c' k' (c + p * t) (k + p * t) y) as [z [Hz Hzy]]; try lra; [exact Hy|].
    exists z. split; [exact Hz|right]. assert (Hz' := Hz). destruct Hz' as [Z0 [_ Z1]].
    specialize (N1 t ltac:(lra)). specialize (N2 t ltac:(lra)). specialize (N3 t ltac:(lra)). unfold Dt in N1.
    assert (Wt : 0 < cos (x + t)) by (apply cos_pos; lra). assert (Wz : cos (x + t) <= cos z)
      by (apply cos_mono; lra).
    destruct (reflect_mono (cos z) (cos (x + t)) k' (k + p * t) r' (r + p * t)) as [D1 K1]; try lra.
    split; [exact D1|]. cbv zeta. destruct (next_domain c' k' r' z) as [Q3 Q4]; try lra; [exact Hz|].
    cbv zeta in Q3, Q4.
    assert (HPI := PI2_1).
    fold (Kt t) in K1. assert (CH : sin z + next_slope (cos z) k' r' * (z + PI) <= Ct t)
      by (unfold Ct; apply height_mono; lra).
    apply IHe; lra.
Qed.
