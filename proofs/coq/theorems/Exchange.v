(** The masses exchanged and the rod turned by pi: N(1/q) = N(q), "q < 1 is the same system with the masses renamed"
    (claim.md).

    swap, swap_dumbbell         == a path, a dumbbell with the masses renamed
    swap_motion, swap_collision == motions and collisions remain what they are
    N_inverse                   == N(1/q) = N(q) *)
From Coq Require Import Reals Lra List.
From Dumbbell Require Import Statement.
Local Open Scope R_scope.

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
  - destruct (law P p Hm t) as [v [v' [Hb [Ha H]]]]. exists v, v'. split; [now apply swap_before|].
    split; [now apply swap_after|].
    unfold push1, push2. destruct swap_arms as [-> ->].
    replace (cos (angle (swap p t))) with (- cos (angle (p t))) by (simpl; now rewrite neg_cos).
    destruct H as [->|[[H0 H]|[H0 H]]]; [now left | right; right | right; left]; (split; [exact H0|]);
      apply swap_push with (2 := H); ring.
Qed.
Lemma swap_collision p t : collision P p t -> collision Q (swap p) t.
Proof.
  intros [v [Hb H]]. exists v. split; [now apply swap_before|]. destruct (swap_y p t) as [-> ->].
  destruct (swap_w p t v) as [-> ->]. tauto.
Qed.
Lemma swap_real : real_dumbbell P -> real_dumbbell Q.
Proof. unfold real_dumbbell; simpl. tauto. Qed.
Lemma swap_ratio q : real_dumbbell P -> 0 < q -> m2 P / m1 P = / q -> m2 Q / m1 Q = q.
Proof. intros [? [? ?]] Hq E. simpl. replace (m1 P / m2 P) with (/ (m2 P / m1 P)) by (field; lra).
now rewrite E, Rinv_inv. Qed.
End Swap.
Theorem N_inverse q n : 0 < q -> N_star q n -> N_star (/ q) n.
Proof.
  intros Hq [U L]. split.
  - intros P p HP E Hm l Hnd Hl.
    apply (U (swap_dumbbell P) (swap p) (swap_real P HP) (swap_ratio P q HP Hq E) (swap_motion P p Hm) l Hnd).
    intros t Ht. now apply swap_collision, Hl.
  - intros P HP E. destruct (L (swap_dumbbell P) (swap_real P HP) (swap_ratio P q HP Hq E)) as [p [Hm [l [A [B C]]]]].
    assert (EP : swap_dumbbell (swap_dumbbell P) = P) by (destruct P; reflexivity).
    exists (swap p). rewrite <- EP. split; [now apply swap_motion|]. exists l. split; [exact A|]. split; [exact B|].
    intros t Ht. now apply swap_collision, C.
Qed.
