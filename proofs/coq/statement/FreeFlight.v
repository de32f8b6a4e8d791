(** That between collisions a dumbbell flies uniformly, as the statement's [before] and [after] say: from Newton's law
    for two point masses on which nothing acts but the rod, along itself, with any force. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Trigonometry Physics Newton.
Local Open Scope R_scope.

(** Between the times lo and hi: the places and velocities of the masses, horizontal and vertical, the angle of the rod,
    from mass 2 to mass 1, the rate at which it turns, and its force. *)
Section Free.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.
Variables lo hi : R.
Variables x1 z1 x2 z2 a1 b1 a2 b2 th rate force : R -> R.
Definition inside t := lo < t < hi.
Record newton_in_flight (t : R) : Prop := {
  moves : is_derive x1 t (a1 t) /\ is_derive z1 t (b1 t) /\ is_derive x2 t (a2 t) /\ is_derive z2 t (b2 t);
  pushed1 : is_derive a1 t (force t * cos (th t) / m1 P) /\ is_derive b1 t (force t * sin (th t) / m1 P);
  pushed2 : is_derive a2 t (- (force t * cos (th t)) / m2 P) /\ is_derive b2 t (- (force t * sin (th t)) / m2 P);
  rod : x1 t - x2 t = ell P * cos (th t) /\ z1 t - z2 t = ell P * sin (th t);
  turns : is_derive th t (rate t) }.
Hypothesis newton : forall t, inside t -> newton_in_flight t.

Definition place t := {| height := (m1 P * z1 t + m2 P * z2 t) / mass P; angle := th t |}.
Definition speed t := vel_of P (th t) (a1 t) (b1 t) (a2 t) (b2 t).

Lemma slope (f : R -> R) t l : is_derive f t l -> Derive (fun x => f x) t = l.
Proof. exact (is_derive_unique f t l). Qed.
Lemma still (f : R -> R) : (forall t, inside t -> is_derive f t 0) -> forall s t, inside s -> inside t -> f s = f t.
Proof.
  intros H s t Hs Ht. destruct (Rtotal_order s t) as [L|[->|L]]; [|reflexivity|].
  - apply (eq_is_derive f s t); [|exact L]. intros x Hx. apply H. unfold inside in *. lra.
  - symmetry. apply (eq_is_derive f t s); [|exact L]. intros x Hx. apply H. unfold inside in *. lra.
Qed.
Lemma uniform (f : R -> R) v : (forall t, inside t -> is_derive f t v) -> forall s t, inside s -> inside t ->
  f s = f t + v * (s - t).
Proof.
  intros H s t Hs Ht. assert (E := still (fun x => f x - v * x)). simpl in E. rewrite (Rplus_comm (f t)).
  apply Rplus_eq_reg_r with (- (v * s)). transitivity (f t - v * t); [|ring]. apply E; try assumption.
  intros x Hx. auto_derive; [now exists v; apply H|]. rewrite (slope _ _ _ (H x Hx)). ring.
Qed.
Lemma same_slope (f g : R -> R) t l l' : (forall s, inside s -> f s = g s) -> inside t -> is_derive f t l -> is_derive g t l' ->
  l = l'.
Proof.
  intros E [L H] Hf Hg. rewrite <- (is_derive_unique f t l Hf). apply is_derive_unique.
  apply is_derive_ext_loc with (2 := Hg). apply (locally_interval _ t lo hi L H). intros y Y1 Y2. symmetry. apply E.
  now split.
Qed.

(** The masses stay where the statement has them, with the velocities of a rod that turns. *)
Theorem heights_of_masses t : inside t -> y1 P (place t) = z1 t /\ y2 P (place t) = z2 t.
Proof.
  intros Ht. destruct (rod t (newton t Ht)) as [_ E]. assert (M := mass_pos P HP). unfold y1, y2, place, arm1, arm2; simpl.
  assert (E1 : sin (th t) = (z1 t - z2 t) / ell P) by (rewrite E; field; destruct HP as [? [? ?]]; lra).
  rewrite E1. destruct HP as [P1 [P2 P3]]. unfold mass in *. split; field; lra.
Qed.
Lemma velocities t : inside t -> a1 t - a2 t = - (ell P * sin (th t) * rate t) /\
  b1 t - b2 t = ell P * cos (th t) * rate t.
Proof.
  intros Ht. destruct (newton t Ht) as [[X1 [Z1 [X2 Z2]]] _ _ _ O]. split.
  - apply (same_slope (fun t => x1 t - x2 t) (fun t => ell P * cos (th t)) t); [intros s Hs; apply (newton s Hs) | exact Ht | |].
    + apply (is_derive_minus (V := R_NormedModule)); assumption.
    + auto_derive; [now exists (rate t)|]. rewrite (slope _ _ _ O). ring.
  - apply (same_slope (fun t => z1 t - z2 t) (fun t => ell P * sin (th t)) t); [intros s Hs; apply (newton s Hs) | exact Ht | |].
    + apply (is_derive_minus (V := R_NormedModule)); assumption.
    + auto_derive; [now exists (rate t)|]. rewrite (slope _ _ _ O). ring.
Qed.
Lemma speed_turns t : inside t -> om (speed t) = rate t.
Proof.
  intros Ht. destruct (velocities t Ht) as [A B]. unfold speed, vel_of; simpl. rewrite A, B.
  transitivity ((sin (th t) * sin (th t) + cos (th t) * cos (th t)) * rate t); [|rewrite unit_circle; ring].
  field. destruct HP as [? [? ?]]. lra.
Qed.

(** Neither velocity changes: the rod's forces have no sum, and no moment. *)
Lemma turns_evenly s t : inside s -> inside t -> om (speed s) = om (speed t).
Proof.
  apply (still (fun t => om (speed t))). clear s t. intros t Ht. destruct (velocities t Ht) as [A B].
  destruct (newton t Ht) as [_ [A1 B1] [A2 B2] _ O]. destruct HP as [P1 [P2 P3]]. unfold speed, vel_of; simpl.
  auto_derive.
  - repeat split; eexists; eassumption.
  - rewrite (slope _ _ _ A1), (slope _ _ _ B1), (slope _ _ _ A2),
      (slope _ _ _ B2), (slope _ _ _ O).
    replace (b1 t + - b2 t) with (ell P * cos (th t) * rate t) by lra.
    replace (a1 t + - a2 t) with (- (ell P * sin (th t) * rate t)) by lra. field. lra.
Qed.
Lemma rises_evenly s t : inside s -> inside t -> vy (speed s) = vy (speed t).
Proof.
  apply (still (fun t => vy (speed t))). clear s t. intros t Ht. destruct (newton t Ht) as [_ [_ B1] [_ B2] _ _].
  destruct HP as [P1 [P2 P3]].
  unfold speed, vel_of, mass; simpl. auto_derive.
  - repeat split; eexists; eassumption.
  - rewrite (slope _ _ _ B1), (slope _ _ _ B2). field. lra.
Qed.

Theorem uniform_flight s t : inside s -> inside t ->
  height (place s) = height (place t) + vy (speed t) * (s - t) /\
  angle (place s) = angle (place t) + om (speed t) * (s - t).
Proof.
  intros Hs Ht. split; [apply (uniform (fun t => height (place t))) | apply (uniform th)]; try assumption; intros x Hx.
  - rewrite (rises_evenly t x Ht Hx). destruct (newton x Hx) as [[_ [Z1 [_ Z2]]] _ _ _ _].
    unfold place, speed, vel_of; simpl. destruct HP as [P1 [P2 P3]]. auto_derive.
    + repeat split; eexists; eassumption.
    + rewrite (slope _ _ _ Z1), (slope _ _ _ Z2). unfold mass. field. lra.
  - rewrite (turns_evenly t x Ht Hx), (speed_turns x Hx). apply (newton x Hx).
Qed.
Theorem free_flight t : inside t -> before place t (speed t) /\ after place t (speed t).
Proof.
  intros Ht. assert (Ht' := Ht). destruct Ht' as [L H].
  split; [exists ((t - lo) / 2) | exists ((hi - t) / 2)]; (split; [lra|]); intros s Hs;
    (apply uniform_flight; [unfold inside; lra | exact Ht]).
Qed.
End Free.
