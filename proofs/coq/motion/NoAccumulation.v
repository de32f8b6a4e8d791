(** Collisions cannot accumulate: a path that obeys the law at each time of (0, T) flies freely just before T. So that
    `motion` asks for a velocity before and after each time excludes no trajectory but those into a corner. *)
From Coq Require Import Reals Lra Lia.
From Dumbbell Require Import Statement Flight Symmetry Existence OneFlight EveryState Determinism.
Local Open Scope R_scope.

Section NoAcc.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.
Hypothesis Hr1 : r_of P <= 1.

(** Free just before T. *)
Definition free_just_before (p : R -> pos) T := exists e s1 u, 0 < e /\ forall t, T - e <= t < T ->
  p t = line s1 u (t - T).
Lemma before_free_just_before p q t0 T u : t0 < T -> (forall t, t0 <= t < T -> p t = q t) -> before q T u ->
  free_just_before p T.
Proof.
  intros HT H [e [He B]]. exists (Rmin e (T - t0)), (q T), u. assert (D1 : Rmin e (T - t0) <= e) by apply Rmin_l.
  assert (D2 : Rmin e (T - t0) <= T - t0) by apply Rmin_r.
  split; [apply Rmin_pos; lra|]. intros t Ht. rewrite (H t ltac:(lra)). destruct (B t ltac:(lra)) as [B1 B2].
  apply pos_eq; simpl; assumption.
Qed.
Theorem no_accumulation s v p T : above_floor P s -> leaves P s v -> p 0 = s -> after p 0 v -> 0 < T ->
  (forall t, 0 < t < T -> lawful P p t) -> free_just_before p T.
Proof.
  intros Hs Hl E0 Ha HT Hg.
  destruct (every_state P HP Hr1 s v Hs Hl) as [[q [F0 [Fa Fg]]]|[T2 [q [u [HT2 [F0 [Fa [Fg [Fb Fc]]]]]]]]].
  - assert (A := agree P HP p q 0 T v Hg ltac:(intros t Ht; apply Fg; lra) ltac:(congruence) Ha Fa).
    destruct (Fg T HT) as [_ [_ [_ [w [_ [Hb _]]]]]]. exact (before_free_just_before p q 0 T w HT A Hb).
  - destruct (Rlt_or_le T2 T) as [L|L].
    + exfalso. assert (A := agree P HP p q 0 T2 v ltac:(intros t Ht; apply Hg; lra) Fg ltac:(congruence) Ha Fa).
      destruct (Hg T2 ltac:(lra)) as [_ [_ [Rg [w [_ [Hb _]]]]]]. destruct (agree_at p q 0 T2 w u HT2 A Hb Fb) as [E _].
      apply Rg. rewrite E. exact Fc.
    + assert (A := agree P HP p q 0 T v Hg ltac:(intros t Ht; apply Fg; lra) ltac:(congruence) Ha Fa).
      destruct (Rle_lt_or_eq_dec _ _ L) as [K|K].
      * destruct (Fg T ltac:(lra)) as [_ [_ [_ [w [_ [Hb _]]]]]]. exact (before_free_just_before p q 0 T w HT A Hb).
      * apply (before_free_just_before p q 0 T u HT A). now rewrite K.
Qed.
End NoAcc.
