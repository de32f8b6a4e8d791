(** Theorem 1 (b): in a motion with N(q) collisions the heavy mass hits the floor exactly once. At most once is L6
    (c), for every motion; at least once follows from L24. *)
From Coq Require Import Reals Lra Lia List.
From Dumbbell Require Import Physics Flight Collisions Orbits AtMostOnce ExactMaximum NoHeavy.
Local Open Scope R_scope.

Theorem theorem_1b q n P p : 1 <= q -> N_star q n -> real_dumbbell P -> m2 P / m1 P = q -> motion P p ->
  at_least P p n ->
  exists! T, collision P p T /\ y2 P (p T) = 0.
Proof.
  intros Hq Hn HP Hqq Hm Hl. destruct (theorem_1 q Hq) as [k0 [k1 [T [C [_ HN]]]]]. apply HN in Hn. subst n.
  assert (E : r_of P = / q) by (unfold r_of; destruct HP as [? [? ?]]; rewrite <- Hqq; field; lra).
  assert (Hr1 : r_of P <= 1) by (rewrite E; apply inv_ratio; exact Hq).
  assert (Ex : exists t, collision P p t /\ y2 P (p t) = 0).
  { apply Classical_Prop.NNPP. intros No.
    assert (Hno : no_heavy P p) by (intros t Hc Z; apply No; exists t; now split).
    destruct Hl as [l [L1 [L2 L3]]].
    assert (K : (length l <= 1 + k0 + k1)%nat); [|lia].
    apply (L24_no_heavy P HP Hr1 k0 k1) with (p := p); try assumption.
    - rewrite E. exact (exactly_max _ _ _ _ T).
    - rewrite E. exact (exactly_max _ _ _ _ C). }
  destruct Ex as [t [Hc H2]]. exists t. split; [now split|]. intros t' [Hc' H2'].
  now apply (L6c_heavy_at_most_once P HP Hr1 p).
Qed.
