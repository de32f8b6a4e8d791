(** L7, from the charts: N*(1) = 2. At r = 1 a ray with slope >= 0 has at most one collision, one with slope >= -1 at
    most one (the next slope is >= 1), and X of the chart bridge, sigma X of the chart light have none.

    L7_equal_masses, equal_witness == N(1) = 2, and its witness *)
From Coq Require Import Reals Lra Lia.
From Dumbbell Require Import Statement Ray Chart LightTotal WitnessMotion.
Local Open Scope R_scope.

Lemma one_at_most n c k : -1 <= k -> coll 1 n c k -> (n <= 1)%nat.
Proof.
  intros Hk H. destruct n as [|[|n]]; [lia | lia | exfalso]. destruct H as [x [Hx [H|[HD H]]]]; [discriminate|].
  destruct (next_domain c k 1 x ltac:(lra) ltac:(lra) Hx HD) as [K _].
  apply steep_ray_misses in H; [discriminate | exact K].
Qed.
Lemma too_high n c k : 0 <= k -> 1 <= c -> coll 1 n c k -> n = O.
Proof.
  intros Hk Hc H. destruct n as [|n]; [reflexivity|exfalso]. destruct H as [x [[Hx [Hs _]] _]].
  assert (0 <= k * x) by (apply Rmult_le_pos; lra). assert (sin x < 1); [|lra].
  rewrite <- sin_PI2. apply sin_increasing_1; lra.
Qed.
Theorem equal_bridge : bridge_bound 1 2.
Proof.
  intros e eta a b He Heta _ Ha Hb. assert (HPI : 0 < PI) by apply PI_RGT_0.
  destruct (cos_range e ltac:(lra)) as [W0 W1]. rewrite !Rmult_1_l in Ha, Hb.
  assert (a = O).
  { apply (too_high a (cX e eta) (lamX e eta)); [unfold lamX; lra | | exact Ha].
    assert (T := sin_below_tangent e (PI/2) ltac:(lra) ltac:(lra)). rewrite sin_PI2 in T.
    unfold cX, lamX. assert (0 <= eta * (PI - e)) by (apply Rmult_le_pos; lra).
    assert (0 <= cos e * (PI/2)) by (apply Rmult_le_pos; lra). lra. }
  assert (b <= 1)%nat; [|lia]. apply (one_at_most b (cS e eta 1) (lamS e eta 1)); [apply lamS_ge; lra | exact Hb].
Qed.
Theorem equal_light : light_bound 1 2.
Proof.
  intros e lam a b He Hlam Hl HP _ _ Ha Hb Hb0. assert (HPI : 0 < PI) by apply PI_RGT_0.
  destruct (cos_range e ltac:(lra)) as [W0 W1]. rewrite !Rmult_1_l in *.
  assert (a <= 1)%nat by (apply (one_at_most a (cL e lam) lam); [lra | exact Ha]). assert (b = O); [|lia].
  destruct (Rlt_or_le 0 (mu_den (cos e) lam 1)) as [HD|HD]; [|now apply Hb0]. specialize (Hb HD).
  refine (steep_ray_misses 1 b _ _ _ Hb).
  unfold mu. apply Rmult_le_reg_r with (mu_den (cos e) lam 1); [exact HD|]. unfold Rdiv.
  rewrite Rmult_assoc, Rinv_l, Rmult_1_l, Rmult_1_r by lra.
  unfold mu_den. assert (0 <= cos e * (1 - lam)) by (apply Rmult_le_pos; lra). assert (cos e * cos e <= 1) by nra.
  assert (0 <= lam * (1 - cos e * cos e)) by (apply Rmult_le_pos; lra). lra.
Qed.
Theorem equal_witness : bridge_witness 1 2.
Proof.
  assert (HPI : 0 < PI) by apply PI_RGT_0. exists (PI/3), (1/4), O, 1%nat. unfold lamX. rewrite cos_PI3.
  repeat split; try lra; try lia.
  rewrite !Rmult_1_l.
  assert (E : lamS (PI/3) (1/4) 1 = - (7/24)) by (unfold lamS, eta_reversed; rewrite cos_PI3; field).
  assert (C := cS_ge (PI/3) (1/4) 1 ltac:(lra) ltac:(lra) ltac:(lra)).
  destruct (hit_exists (cS (PI/3) (1/4) 1) (lamS (PI/3) (1/4) 1) (PI/2) C ltac:(lra)) as [x [Hx _]].
  { rewrite sin_PI2. unfold cS. rewrite E. destruct (SIN_bound (PI/3)). lra. }
  exists x. split; [exact Hx | now left].
Qed.
Theorem L7_equal_masses : N_star 1 2.
Proof.
  split.
  - apply charts_upper; [lra | rewrite Rinv_1; apply equal_bridge | rewrite Rinv_1; apply equal_light].
  - apply charts_lower; [lra | rewrite Rinv_1; apply equal_witness].
Qed.
