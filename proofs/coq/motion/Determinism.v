(** Two more sanity theorems: exchanging the masses (q and 1/q), and determinism: a motion is determined for all later times by its state. *)
From Coq Require Import Reals Lra Lia List.
From Dumbbell Require Import Physics Ray Flight Collisions Symmetry.
Local Open Scope R_scope.

(* ---------- the masses exchanged, the rod turned by pi ---------- *)
Definition swap_dumbbell P := {| m1 := m2 P; m2 := m1 P; ell := ell P |}.
Definition swap (p : R -> pos) t := {| height := height (p t); angle := angle (p t) + PI |}.
Section Swap.
Variable P : dumbbell.
Notation Q := (swap_dumbbell P).
Lemma swap_mass : mass Q = mass P.
Proof. unfold mass; simpl. ring. Qed.
Lemma swap_arms : arm1 Q = arm2 P /\ arm2 Q = arm1 P.
Proof. unfold arm1, arm2. rewrite swap_mass. split; reflexivity. Qed.
Lemma swap_inertia : inertia Q = inertia P.
Proof. unfold inertia. destruct swap_arms as [-> ->]. simpl. ring. Qed.
Lemma swap_y p t : y1 Q (swap p t) = y2 P (p t) /\ y2 Q (swap p t) = y1 P (p t).
Proof. unfold y1, y2, swap; simpl. destruct swap_arms as [-> ->]. rewrite neg_sin. split; ring. Qed.
Lemma swap_w p t v : w1 Q (swap p t) v = w2 P (p t) v /\ w2 Q (swap p t) v = w1 P (p t) v.
Proof. unfold w1, w2, swap; simpl. destruct swap_arms as [-> ->]. rewrite neg_cos. split; ring. Qed.
Lemma swap_push l l' v v' : l' = l -> push P l v v' -> push Q l' v v'.
Proof. intros -> [J H]. exists J. unfold energy. rewrite swap_mass, swap_inertia. exact H. Qed.
Lemma swap_before p t v : before p t v -> before (swap p) t v.
Proof. intros [e [He H]]. exists e. split; [exact He|]. intros s Hs. destruct (H s Hs). simpl. split; lra. Qed.
Lemma swap_after p t v : after p t v -> after (swap p) t v.
Proof. intros [e [He H]]. exists e. split; [exact He|]. intros s Hs. destruct (H s Hs). simpl. split; lra. Qed.
Theorem swap_motion p : motion P p -> motion Q (swap p).
Proof.
  intros Hm. split; intros t; destruct (swap_y p t) as [Y1 Y2]; rewrite ?Y1, ?Y2.
  - apply Hm. - apply Hm. - intros [A B]. now apply (regular P p Hm t).
  - destruct (law P p Hm t) as [v [v' [Hb [Ha H]]]]. exists v, v'. split; [now apply swap_before|]. split; [now apply swap_after|].
    unfold push1, push2. destruct swap_arms as [-> ->]. replace (cos (angle (swap p t))) with (- cos (angle (p t))) by (simpl; now rewrite neg_cos).
    destruct H as [->|[[H0 H]|[H0 H]]]; [now left | right; right | right; left]; (split; [exact H0|]); apply swap_push with (2 := H); ring.
Qed.
Lemma swap_collision p t : collision P p t -> collision Q (swap p) t.
Proof.
  intros [v [Hb H]]. exists v. split; [now apply swap_before|]. destruct (swap_y p t) as [-> ->]. destruct (swap_w p t v) as [-> ->]. tauto.
Qed.
Lemma swap_real : real_dumbbell P -> real_dumbbell Q.
Proof. unfold real_dumbbell; simpl. tauto. Qed.
Lemma swap_ratio q : real_dumbbell P -> 0 < q -> m2 P / m1 P = / q -> m2 Q / m1 Q = q.
Proof. intros [? [? ?]] Hq E. simpl. replace (m1 P / m2 P) with (/ (m2 P / m1 P)) by (field; lra). now rewrite E, Rinv_inv. Qed.
End Swap.
Theorem N_inverse q n : 0 < q -> N_star q n -> N_star (/ q) n.
Proof.
  intros Hq [U L]. split.
  - intros P p HP E Hm l Hnd Hl. apply (U (swap_dumbbell P) (swap p) (swap_real P HP) (swap_ratio P q HP Hq E) (swap_motion P p Hm) l Hnd).
    intros t Ht. now apply swap_collision, Hl.
  - intros P HP E. destruct (L (swap_dumbbell P) (swap_real P HP) (swap_ratio P q HP Hq E)) as [p [Hm [l [A [B C]]]]].
    assert (EP : swap_dumbbell (swap_dumbbell P) = P) by (destruct P; reflexivity).
    exists (swap p). rewrite <- EP. split; [now apply swap_motion|]. exists l. split; [exact A|]. split; [exact B|]. intros t Ht. now apply swap_collision, C.
Qed.

(* ---------- determinism ---------- *)
Section Determined.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.

(** The floor's push is determined. *)
Lemma push_determined l v v1 v2 : push P l v v1 -> push P l v v2 -> v1 <> v -> v2 <> v -> v1 = v2.
Proof.
  intros H1 H2 N1 N2. destruct (push_cases P HP _ _ _ H1) as [|[A1 [j1 [J1 [B1 [C1 _]]]]]]; [contradiction|].
  destruct (push_cases P HP _ _ _ H2) as [|[A2 [j2 [J2 [B2 [C2 _]]]]]]; [contradiction|].
  assert (K1 := arm1_pos P HP). assert (K2 := arm2_pos P HP).
  set (g := l / (arm1 P * arm2 P)) in *. rewrite B1, C1 in A1. rewrite B2, C2 in A2.
  assert (S : 0 < 1 + l * g). { unfold g. replace (l * (l / (arm1 P * arm2 P))) with (l * l * / (arm1 P * arm2 P)) by (field; lra).
    assert (0 <= l * l * / (arm1 P * arm2 P)) by (apply Rmult_le_pos; [apply Rle_0_sqr | left; apply Rinv_0_lt_compat; now apply Rmult_lt_0_compat]). lra. }
  assert (j1 = j2) by (apply Rmult_eq_reg_r with (1 + l * g); lra). subst j2. apply vel_eq; congruence.
Qed.
Lemma law_determined p q t v v1 v2 : motion P p -> motion P q -> p t = q t -> before p t v -> before q t v -> after p t v1 -> after q t v2 -> v1 = v2.
Proof.
  intros Hp Hq E Bp Bq Ap Aq.
  assert (C : collision P p t <-> collision P q t).
  { split; intros [w [Hb H]].
    - assert (w = v) by (apply before_unique with p t; assumption). subst w. exists v. rewrite <- E. now split.
    - assert (w = v) by (apply before_unique with q t; assumption). subst w. exists v. rewrite E. now split. }
  destruct (Classical_Prop.classic (collision P p t)) as [K|K].
  - assert (N1 : v1 <> v) by (intros ->; exact (collision_changes_velocity P HP p t v Hp Bp Ap K)).
    assert (N2 : v2 <> v) by (intros ->; exact (collision_changes_velocity P HP q t v Hq Bq Aq (proj1 C K))).
    destruct (law P p Hp t) as [w [w' [Hb [Ha H]]]]. assert (w = v) by (apply before_unique with p t; assumption). assert (w' = v1) by (apply after_unique with p t; assumption). subst w w'.
    destruct (law P q Hq t) as [w [w' [Hb' [Ha' H']]]]. assert (w = v) by (apply before_unique with q t; assumption). assert (w' = v2) by (apply after_unique with q t; assumption). subst w w'.
    rewrite <- E in H'. assert (Rg := regular P p Hp t).
    destruct H as [?|[[H0 H]|[H0 H]]]; [contradiction| |]; (destruct H' as [?|[[H0' H']|[H0' H']]]; [contradiction| |]); try (exfalso; apply Rg; now split); now apply push_determined with (1 := H).
  - assert (K' : ~ collision P q t) by tauto.
    destruct (no_collision_no_change P HP p t Hp K) as [w [Hb Ha]]. assert (w = v) by (apply before_unique with p t; assumption). subst w.
    destruct (no_collision_no_change P HP q t Hq K') as [w [Hb' Ha']]. assert (w = v) by (apply before_unique with q t; assumption). subst w.
    transitivity v; [apply after_unique with p t; assumption | apply after_unique with q t; assumption].
Qed.
Lemma line_same p q t v s : p t = q t -> on_line p t v s -> on_line q t v s -> p s = q s.
Proof. intros E [A B] [C D]. apply pos_eq; [rewrite A, C, E | rewrite B, D, E]; reflexivity. Qed.
Theorem determined p q t0 v : motion P p -> motion P q -> p t0 = q t0 -> after p t0 v -> after q t0 v -> forall t, t0 <= t -> p t = q t.
Proof.
  intros Hp Hq E0 Ap Aq T HT. destruct (Req_dec T t0) as [->|NT]; [exact E0|].
  set (E := fun s => t0 <= s <= T /\ forall t, t0 <= t <= s -> p t = q t).
  (* agreement goes on for a while *)
  assert (Next : forall s w, E s -> s < T -> after p s w -> after q s w -> exists s', s < s' /\ E s').
  { intros s w [Hs Hs'] L [e [He A]] [e' [He' A']]. set (d := Rmin (Rmin e e') (T - s)).
    assert (D1 : 0 < d) by (repeat apply Rmin_pos; lra). assert (D2 : d <= T - s) by apply Rmin_r.
    assert (D3 : d <= Rmin e e') by apply Rmin_l. assert (D4 : Rmin e e' <= e) by apply Rmin_l. assert (D5 : Rmin e e' <= e') by apply Rmin_r.
    exists (s + d). split; [lra|]. split; [lra|]. intros t Ht. destruct (Rle_or_lt t s) as [K|K]; [apply Hs'; lra|].
    apply line_same with s w; [apply Hs'; lra | apply A; lra | apply A'; lra]. }
  assert (E00 : E t0) by (split; [lra|]; intros t Ht; now replace t with t0 by lra).
  destruct (completeness E) as [m [Hub Hlub]]. { exists T. intros s [Hs _]. lra. } { now exists t0. }
  assert (M2 : m <= T) by (apply Hlub; intros s [Hs _]; lra).
  assert (M1 : t0 < m). { destruct (Next t0 v E00 ltac:(lra) Ap Aq) as [s [S1 S2]]. specialize (Hub s S2). lra. }
  assert (Hbelow : forall t, t0 <= t < m -> p t = q t).
  { intros t Ht. assert (Hex : exists s, E s /\ t < s).
    { apply Classical_Prop.NNPP. intros K. assert (m <= t); [|lra]. apply Hlub. intros s Hs. apply Rnot_lt_le. intros L. apply K. now exists s. }
    destruct Hex as [s [[_ Hs] L]]. apply Hs. lra. }
  (* at m: the two lines before m agree on a stretch *)
  destruct (law P p Hp m) as [vp [vp' [Bp [Ap' _]]]]. destruct (law P q Hq m) as [vq [vq' [Bq [Aq' _]]]].
  assert (Em : p m = q m /\ vp = vq).
  { destruct Bp as [e [He B]]. destruct Bq as [e' [He' B']]. set (d := Rmin (Rmin e e') (m - t0)).
    assert (D1 : 0 < d) by (repeat apply Rmin_pos; lra). assert (D2 : d <= m - t0) by apply Rmin_r.
    assert (D3 : d <= Rmin e e') by apply Rmin_l. assert (D4 : Rmin e e' <= e) by apply Rmin_l. assert (D5 : Rmin e e' <= e') by apply Rmin_r.
    destruct (B (m - d) ltac:(lra)) as [X1 X2]. destruct (B (m - d / 2) ltac:(lra)) as [X3 X4].
    destruct (B' (m - d) ltac:(lra)) as [Y1 Y2]. destruct (B' (m - d / 2) ltac:(lra)) as [Y3 Y4].
    rewrite <- (Hbelow (m - d)) in Y1, Y2 by lra. rewrite <- (Hbelow (m - d / 2)) in Y3, Y4 by lra.
    assert (V1 : vy vp = vy vq) by (apply Rmult_eq_reg_r with (d / 2); lra). assert (V2 : om vp = om vq) by (apply Rmult_eq_reg_r with (d / 2); lra).
    split; [apply pos_eq; [rewrite V1 in X1 | rewrite V2 in X2]; lra | now apply vel_eq]. }
  destruct Em as [Em <-].
  assert (HEm : E m). { split; [lra|]. intros t Ht. destruct (Req_dec t m) as [->|]; [exact Em | apply Hbelow; lra]. }
  destruct (Rle_lt_or_eq_dec m T M2) as [L|L]; [exfalso | rewrite <- L; exact Em].
  assert (vp' = vq') by (apply (law_determined p q m vp); assumption). subst vq'.
  destruct (Next m vp' HEm L Ap' Aq') as [s [S1 S2]]. specialize (Hub s S2). lra.
Qed.
End Determined.
