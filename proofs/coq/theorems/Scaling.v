(** Only the mass ratio matters: a motion of one dumbbell, scaled, is one of every other dumbbell of its ratio (claim.md
    has length 1). There is a dumbbell of every ratio.

    only_ratio               == a motion with n collisions of one dumbbell: so has every dumbbell of its ratio
    unit_dumbbell, unit_real == a dumbbell of the ratio q
    at_least_le              == at least n: at least m <= n *)
From Coq Require Import Reals Lra Lia List.
From Dumbbell Require Import Physics.
Local Open Scope R_scope.

(** A dumbbell of each ratio. *)
Definition unit_dumbbell q := {| m1 := 1; m2 := q; ell := 1 |}.
Lemma unit_real q : 0 < q -> real_dumbbell (unit_dumbbell q) /\ m2 (unit_dumbbell q) / m1 (unit_dumbbell q) = q.
Proof. intros Hq. unfold real_dumbbell, unit_dumbbell; simpl. split; [lra | field]. Qed.
Section Scale.
Variables P Q : dumbbell.
Hypothesis HP : real_dumbbell P.
Hypothesis HQ : real_dumbbell Q.
Hypothesis HR : m2 P / m1 P = m2 Q / m1 Q.
Definition factor := ell Q / ell P.
Notation f := factor.
Lemma factor_pos : 0 < f. Proof. destruct HP as [? [? ?]], HQ as [? [? ?]]. now apply Rdiv_lt_0_compat. Qed.
Lemma ratios : m2 P * m1 Q = m2 Q * m1 P.
Proof.
  destruct HP as [? [? ?]], HQ as [? [? ?]]. replace (m2 P * m1 Q) with (m2 P / m1 P * (m1 P * m1 Q)) by (field; lra).
  rewrite HR. field. lra.
Qed.
Lemma scale_arms : arm1 Q = f * arm1 P /\ arm2 Q = f * arm2 P.
Proof.
  assert (E := ratios). destruct HP as [? [? ?]], HQ as [? [? ?]].
  assert (K : forall a b, a * (m1 P + m2 P) = b * (m1 Q + m2 Q) ->
    ell Q * (a / (m1 Q + m2 Q)) = f * (ell P * (b / (m1 P + m2 P)))).
  { intros a b Hab.
    replace (a / (m1 Q + m2 Q)) with (a * (m1 P + m2 P) / ((m1 Q + m2 Q) * (m1 P + m2 P))) by (field; lra).
    rewrite Hab. unfold f. field. lra. }
  unfold arm1, arm2, mass. split; apply K; lra.
Qed.
Definition scale_pos (s : pos) := {| height := f * height s; angle := angle s |}.
Definition scale_v (v : vel) := {| vy := f * vy v; om := om v |}.
Definition scale (p : R -> pos) t := scale_pos (p t).
Lemma scale_y s : y1 Q (scale_pos s) = f * y1 P s /\ y2 Q (scale_pos s) = f * y2 P s.
Proof. destruct scale_arms as [E1 E2]. unfold y1, y2, scale_pos; simpl. rewrite E1, E2. split; ring. Qed.
Lemma scale_w s v : w1 Q (scale_pos s) (scale_v v) = f * w1 P s v /\ w2 Q (scale_pos s) (scale_v v) = f * w2 P s v.
Proof. destruct scale_arms as [E1 E2]. unfold w1, w2, scale_pos; simpl. rewrite E1, E2. split; ring. Qed.
Lemma scale_before p t v : before p t v -> before (scale p) t (scale_v v).
Proof. intros [e [He H]]. exists e. split; [exact He|]. intros s Hs. destruct (H s Hs) as [A B]. simpl. rewrite A, B.
split; ring. Qed.
Lemma scale_after p t v : after p t v -> after (scale p) t (scale_v v).
Proof. intros [e [He H]]. exists e. split; [exact He|]. intros s Hs. destruct (H s Hs) as [A B]. simpl. rewrite A, B.
split; ring. Qed.
Lemma scale_push l v v' : push P l v v' -> push Q (f * l) (scale_v v) (scale_v v').
Proof.
  intros [J [HJ [A [B C]]]]. assert (MP := mass_pos P HP). assert (MQ := mass_pos Q HQ). assert (F := factor_pos).
  destruct scale_arms as [E1 E2].
  assert (EI : inertia Q = mass Q / mass P * (f * f) * inertia P)
    by (rewrite (inertia_eq Q HQ), (inertia_eq P HP), E1, E2; field; lra).
  exists (mass Q / mass P * f * J). assert (K : 0 < mass Q / mass P) by (now apply Rdiv_lt_0_compat). simpl.
  repeat split.
  - apply Rmult_le_pos; [apply Rmult_le_pos; lra | exact HJ].
  - rewrite <- A. field. lra.
  - rewrite EI.
    replace (mass Q / mass P * (f * f) * inertia P * (om v' - om v))
      with (mass Q / mass P * (f * f) * (inertia P * (om v' - om v))) by ring. rewrite B. ring.
  - unfold energy in *. simpl. rewrite EI.
    replace (mass Q * (f * vy v' * (f * vy v')) + mass Q / mass P * (f * f) * inertia P * (om v' * om v'))
      with (mass Q / mass P * (f * f) * (mass P * (vy v' * vy v') + inertia P * (om v' * om v'))) by (field; lra).
    replace (mass P * (vy v' * vy v') + inertia P * (om v' * om v'))
      with (mass P * (vy v * vy v) + inertia P * (om v * om v)) by lra. field. lra.
Qed.
Theorem scale_motion p : motion P p -> motion Q (scale p).
Proof.
  intros Hm. assert (F := factor_pos). destruct scale_arms as [E1 E2].
  split; intros t; destruct (scale_y (p t)) as [Y1 Y2]; unfold scale.
  - rewrite Y1. apply Rmult_le_pos; [lra | apply Hm].
  - rewrite Y2. apply Rmult_le_pos; [lra | apply Hm].
  - rewrite Y1, Y2. intros [A B]. apply (regular P p Hm t). split; apply Rmult_eq_reg_l with f; lra.
  - destruct (law P p Hm t) as [v [v' [Hb [Ha H]]]]. exists (scale_v v), (scale_v v'). split; [now apply scale_before|].
    split; [now apply scale_after|].
    rewrite Y1, Y2. unfold push1, push2. simpl. rewrite E1, E2.
    destruct H as [->|[[H0 H]|[H0 H]]]; [now left | right; left | right; right]; (split; [rewrite H0; ring|]).
    + replace (f * arm1 P * cos (angle (p t))) with (f * (arm1 P * cos (angle (p t)))) by ring. now apply scale_push.
    + replace (- (f * arm2 P * cos (angle (p t)))) with (f * - (arm2 P * cos (angle (p t)))) by ring.
      now apply scale_push.
Qed.
Lemma scale_collision p t : collision P p t -> collision Q (scale p) t.
Proof.
  intros [v [Hb H]]. assert (F := factor_pos). exists (scale_v v). split; [now apply scale_before|].
  destruct (scale_y (p t)) as [Y1 Y2]. destruct (scale_w (p t) v) as [W1 W2].
  unfold scale. rewrite Y1, Y2, W1, W2. destruct H as [[A B]|[A B]]; [left | right]; (split; [rewrite A; ring|]).
  - assert (0 < f * - w1 P (p t) v) by (apply Rmult_lt_0_compat; lra). lra.
  - assert (0 < f * - w2 P (p t) v) by (apply Rmult_lt_0_compat; lra). lra.
Qed.
End Scale.
Theorem only_ratio q P p n : real_dumbbell P -> m2 P / m1 P = q -> motion P p -> at_least P p n -> lower_bound q n.
Proof.
  intros HP Hq Hm [l [A [B C]]] Q HQ Hqq. assert (E : m2 P / m1 P = m2 Q / m1 Q) by congruence. exists (scale P Q p).
  split; [now apply scale_motion|].
  exists l. split; [exact A|]. split; [exact B|]. intros t Ht. apply scale_collision; auto.
Qed.

(** Fewer collisions than there are. *)
Lemma at_least_le P p m n : (m <= n)%nat -> at_least P p n -> at_least P p m.
Proof.
  intros Hm [l [H1 [H2 H3]]]. exists (firstn m l). split; [|split].
  - rewrite <- (firstn_skipn m l) in H1. clear - H1. induction (firstn m l) as [|x s IH]; [constructor|]. simpl in H1.
    apply NoDup_cons_iff in H1. destruct H1 as [A B].
    constructor; [intros K; apply A, in_app_iff; now left | now apply IH].
  - rewrite firstn_length. lia.
  - intros t Ht. apply H3. rewrite <- (firstn_skipn m l). apply in_app_iff. now left.
Qed.
