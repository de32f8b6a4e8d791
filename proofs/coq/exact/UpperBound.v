(** At most 2 + k0 + k1 collisions: L22 with a contact on the bridge, L24 without one.

    at_most_2_k0_k1 == at most 2 + k0 + k1 *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics Ray Chart Flight Collisions HeavyTotal Orbits NoHeavy.
Local Open Scope R_scope.

Section Upper.
Variable r : R.
Hypothesis Hr : 0 < r <= 1.
Variables k0 k1 : nat.
Hypothesis H0 : forall n, coll r n r 0 -> (n <= k0)%nat.
Hypothesis H1 : forall n, coll r n (PI * r) r -> (n <= k1)%nat.

(** L22: X is at least (r, 0), sigma X is at least (0, -r). *)
Theorem L22_bridge : bridge_bound r (2 + k0 + k1).
Proof.
  intros e eta a b He Heta _ Ca Cb. assert (HPI : 0 < PI) by apply PI_RGT_0.
  assert (A : (a <= k0)%nat).
  { apply H0. assert (X1 := cX_mono e (PI/2) eta 0 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
    assert (X2 := lamX_mono e (PI/2) eta 0 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
    assert (E1 : cX (PI/2) 0 = 1) by (unfold cX, lamX; rewrite sin_PI2, cos_PI2; ring).
    assert (E2 : lamX (PI/2) 0 = 0) by (unfold lamX; rewrite cos_PI2; ring). rewrite E1 in X1. rewrite E2 in X2.
    apply (coll_mono a) with (8 := Ca); try lra; nra. }
  assert (B : (b <= S k1)%nat).
  { destruct b as [|b]; [lia|]. apply le_n_S, H1, L40_one_less; [lra|].
    assert (S1 := cS_ge e eta r ltac:(lra) Heta Hr). assert (S2 := lamS_ge e eta r ltac:(lra) Heta Hr).
    apply (coll_mono (S b)) with (8 := Cb); try lra; nra. }
  lia.
Qed.
End Upper.

Theorem at_most_2_k0_k1 q k0 k1 : 1 <= q -> top_orbit q k0 -> corner_orbit q k1 -> upper_bound q (2 + k0 + k1).
Proof.
  intros Hq T C P p HP Hqq Hm. assert (Hr := inv_ratio q Hq). assert (HT := exactly_max _ _ _ _ T).
  assert (HC := exactly_max _ _ _ _ C).
  assert (E : / q = r_of P) by (unfold r_of; destruct HP as [? [? ?]]; rewrite <- Hqq; field; lra).
  rewrite E in HT, HC, Hr. destruct (Classical_Prop.classic (no_heavy P p)) as [Hn|Hn].
  - intros l Hnd Hl. assert (K := L24_no_heavy P HP (proj2 Hr) k0 k1 HT HC p Hm Hn l Hnd Hl). lia.
  - apply Classical_Pred_Type.not_all_ex_not in Hn. destruct Hn as [t Hn]. apply Classical_Prop.imply_to_and in Hn.
    destruct Hn as [Hc H2]. apply (heavy_total P HP (proj2 Hr) _ p t (L22_bridge _ Hr k0 k1 HT HC));
      [lia | exact Hm | exact Hc |].
    now apply Classical_Prop.NNPP.
Qed.
