(** The integrals of the layer (L49 and L50 of law.md) by nodes: tau, tau_J and the step's part of tau_J, of which the rule
    of LayerRule.v knows a sum over nodes and the second derivative.

    kernel_derive          == the derivatives of sinc x g(pi - x)
    way_between            == the integral of sin x g(pi - x) from 0 to u, with a lower or an upper bound of the second one
    step_between           == the same from u' to u, with one node
    tau_rest, tau_J_rest, step_rest == what is left of tau/u^2, tau_J/u^2 and mu
    tau_rest_mean, tau_J_rest_mean, step_rest_mean == it is a mean of half the second derivative *)
From Coq Require Import Reals ZArith Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Tails LawStatement Clock Midpoint Defect Sizes Calculus LayerRule NodeRule.
Local Open Scope R_scope.

Definition wave_slope x := (x * cos x - sin x) / x^2.
Section Kernel.
Variables (g g1 g2 : R -> R) (U : R).
Definition kernel x := sinc x * g (PI - x).
Definition kernel1 x := wave_slope x * g (PI - x) - sinc x * g1 (PI - x).
Definition kernel2 x := n_second (exact U) x (g (PI - x)) (g1 (PI - x)) (g2 (PI - x)).
Lemma shifted (f : R -> R) f' x : is_derive f (PI - x) f' -> is_derive (fun x => f (PI - x)) x (- f').
Proof.
  intros D. replace (- f') with (scal (-1) f') by (unfold scal; simpl; unfold mult; simpl; ring).
  apply (is_derive_comp f (fun x => PI - x)); [exact D | auto_derive; [easy | ring]].
Qed.
Theorem kernel_derive x : 0 < x -> is_derive g (PI - x) (g1 (PI - x)) -> is_derive g1 (PI - x) (g2 (PI - x)) ->
  is_derive kernel x (kernel1 x) /\ is_derive kernel1 x (kernel2 x).
Proof.
  intros Hx D1 D2. assert (G1 := shifted _ _ _ D1). assert (G2 := shifted _ _ _ D2).
  assert (S : is_derive sinc x (wave_slope x)) by (unfold sinc, wave_slope; auto_derive; [lra | field; lra]).
  assert (S' : is_derive wave_slope x (- (sin x / x) - 2 * wave_slope x / x)).
  { unfold wave_slope. auto_derive; [repeat apply Rmult_integral_contrapositive_currified; lra | field; lra]. }
  assert (C : forall n m : R_AbsRing, mult n m = mult m n) by (intros; apply Rmult_comm). split.
  - assert (K := is_derive_mult sinc (fun x => g (PI - x)) x _ _ S G1 C).
    match type of K with is_derive _ _ ?v => replace (kernel1 x) with v; [exact K|] end.
    unfold kernel1, Hierarchy.plus, mult; simpl; ring.
  - assert (K := is_derive_minus _ _ x _ _ (is_derive_mult wave_slope (fun x => g (PI - x)) x _ _ S' G1 C)
      (is_derive_mult sinc (fun x => g1 (PI - x)) x _ _ S G2 C)).
    match type of K with is_derive _ _ ?v => replace (kernel2 x) with v; [exact K|] end.
    unfold kernel2, n_second, n_tau, Hierarchy.minus, Hierarchy.plus, opp, mult. cbn -[sinc sin cos]. unfold wave_slope, sinc.
    assert (E1 := sin_tail x). assert (E2 := cos_tail x). set (s := tail_sin x) in *. set (c := tail_cos x) in *.
    rewrite E1, E2. field. lra.
Qed.
End Kernel.
Lemma weight_is g x : x * kernel g x = sin x * g (PI - x).
Proof.
  unfold kernel, sinc. destruct (Req_dec x 0) as [->|N]; [rewrite sin_0; ring | field; exact N].
Qed.
Lemma kernel_integral g a b : RInt (fun x => x * kernel g x) a b = RInt (fun x => sin x * g (PI - x)) a b.
Proof. apply RInt_ext. intros x _. apply weight_is. Qed.
Lemma kernel_integrable g a b : ex_RInt (fun x => sin x * g (PI - x)) a b -> ex_RInt (fun x => x * kernel g x) a b.
Proof. apply ex_RInt_ext. intros x _. symmetry. apply weight_is. Qed.

(** The derivatives of H by F. *)
Definition H1 F Q := / root F Q ^ 3 - 3 * F^2 / root F Q ^ 5.
Definition H11 F Q := 15 * F^3 / root F Q ^ 7 - 9 * F / root F Q ^ 5.
Lemma H_derive F Q : 0 < Q < F -> is_derive (fun F => H F Q) F (H1 F Q) /\ is_derive (fun F => H1 F Q) F (H11 F Q).
Proof.
  intros HF. destruct (radicand F Q HF) as [A B]. unfold H, H1, H11, root.
  split; auto_derive; replace (F * F + - (Q * Q)) with (F * F - Q * Q) by ring;
    [repeat split; try lra; repeat apply Rmult_integral_contrapositive_currified; lra | set (s := sqrt (F * F - Q * Q)) in *; field; lra
    | repeat split; try lra; repeat apply Rmult_integral_contrapositive_currified; lra | set (s := sqrt (F * F - Q * Q)) in *; field; lra].
Qed.
(** The rule's kernels are these. *)
Lemma kernels_are U F Q : 0 < Q < F -> let C := exact U in
  n_G C F Q = G F Q /\ n_G1 C F Q = G1 F Q /\ n_G2 C F Q = G2 F Q /\ n_G3 C F Q = G3 F Q /\ n_G4 C F Q = G4 F Q /\
  n_H C F Q = H F Q /\ n_H1 C F Q = H1 F Q /\ n_H11 C F Q = H11 F Q.
Proof.
  intros HF C. destruct (radicand F Q HF) as [A B].
  unfold n_G, n_G1, n_G2, n_G3, n_G4, n_H, n_H1, n_H11, n_root, G, G1, G2, G3, G4, H, H1, H11, root. cbn -[pow].
  set (s := sqrt (F * F - Q * Q)) in *. repeat split; field; lra.
Qed.
