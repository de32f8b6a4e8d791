(** The integrals of the layer (L49 and L50 of law.md) by nodes: tau, tau_J and the step's part of tau_J,
  of which the rule
    of LayerRule.v knows a sum over nodes and the second derivative.

    kernel_derive          == the derivatives of sinc x g(pi - x)
    kernel_integral        == the integral of x times that is the one of sin x g(pi - x)
    sum_of, spread_of      == the sum over the nodes of n parts of [0, u], and their spread
    mean                   == a number is between all bounds of a function
    way_rest, step_rest    == what is left of it, over u^4 and over U^4, in units of the spread
    way_rest_mean, step_rest_mean == that is a mean of the second derivative
    way_rest_is, step_rest_is == the integrals by their nodes
    H1, H11, H_derive      == the derivatives of H by F
    kernels_are            == the rule's kernels are G, H and their derivatives
    part_rise              == (mean of sinc x g(pi - x) on a part - h)/U;
      a mean of (sinc x g(pi - x) - h)/U (part_rise_mean)
    second_is              == (integral/u^2 - h/2)/U by these *)
From Coq Require Import Reals ZArith Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Quotients Tails LawStatement Ends Clock Midpoint Defect Sizes Calculus LayerRule
  NodeRule.
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
    unfold kernel2, n_second, n_tau, Hierarchy.minus, Hierarchy.plus, opp, mult. cbn -[sinc sin cos].
    unfold wave_slope, sinc.
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
    [repeat split; try lra; repeat apply Rmult_integral_contrapositive_currified;
      lra | set (s := sqrt (F * F - Q * Q)) in *; field; lra
    | repeat split; try lra; repeat apply Rmult_integral_contrapositive_currified;
      lra | set (s := sqrt (F * F - Q * Q)) in *; field; lra].
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

(** n parts of the way from 0 to u. *)
Definition sum_of n (f : R -> R) u := fold_right (fun i s =>
  f (u * part_node n i) * part_weight n i + s) 0 (upto 0 (Z.to_nat n)).
Definition spread_of n := fold_right (fun i s => part_spread n i + s) 0 (upto 0 (Z.to_nat n)).
Lemma spread_pos n : (0 < n)%Z -> 0 < spread_of n.
Proof.
  intros Hn. unfold spread_of. replace (Z.to_nat n) with (S (Z.to_nat (n - 1))) by lia. unfold upto.
  cbn [seq map fold_right].
  assert (P : forall i, (0 <= i)%Z -> 0 < part_spread n i).
  { intros i Hi. unfold part_spread. apply Rdiv_lt_0_compat; apply IZR_lt; nia. }
  assert (Q : forall k j, 0 <= fold_right (fun i s => part_spread n i + s) 0 (map Z.of_nat (seq j k))).
  { induction k as [|k IH]; intros j; cbn [seq map fold_right]; [lra|]. assert (A := P (Z.of_nat j) ltac:(lia)).
    assert (B := IH (S j)). lra. }
  assert (A := P (Z.of_nat 0) ltac:(lia)). assert (B := Q (Z.to_nat (n - 1)) 1%nat). lra.
Qed.
(** A number v is a mean of g over the numbers that D holds of. *)
Definition mean (D : R -> Prop) (g : R -> R) v := (forall l, (forall x, D x -> l <= g x) -> l <= v) /\
  (forall l, (forall x, D x -> g x <= l) -> v <= l).

Section Rests.
Variables (g g1 g2 : R -> R) (U u : R).
Hypothesis Hu : 0 < u.
Hypothesis D : forall x, 0 < x < u -> is_derive g (PI - x) (g1 (PI - x)) /\ is_derive g1 (PI - x) (g2 (PI - x)).
Hypothesis I : forall a b, 0 <= a -> a <= b <= u -> ex_RInt (fun x => sin x * g (PI - x)) a b.
Let f := kernel g.
Let integral a b := RInt (fun x => sin x * g (PI - x)) a b.

Definition way_rest n := (integral 0 u - u^2 * sum_of n f u) / (u^4 * spread_of n).
Theorem way_rest_mean n : (0 < n)%Z -> mean (fun x => 0 < x < u) (kernel2 g g1 g2 U) (way_rest n).
Proof.
  intros Hn. assert (W : 0 < u^4 * spread_of n) by (apply Rmult_lt_0_compat;
    [now apply pow_lt | now apply spread_pos]).
  assert (D1 : forall x, 0 < x < u -> is_derive f x (kernel1 g g1 x))
    by (intros x Hx; destruct (D x Hx); now apply (kernel_derive g g1 g2 U)).
  assert (D2 : forall x, 0 < x < u -> is_derive (kernel1 g g1) x (kernel2 g g1 g2 U x))
    by (intros x Hx; destruct (D x Hx); now apply (kernel_derive g g1 g2 U)).
  assert (J : forall a b, 0 <= a -> a <= b <= u -> ex_RInt (fun x => x * f x) a b)
    by (intros a b Ha Hb; apply kernel_integrable, I; lra).
  unfold way_rest, integral. rewrite <- (kernel_integral g 0 u). fold f. split; intros l Hl.
  - assert (K := nodes_below f _ _ u l n Hu Hn D1 D2 Hl J). cbv zeta in K. fold (sum_of n f u) (spread_of n) in K.
    apply quotient_at_least; [exact W | lra].
  - assert (K := nodes_above f _ _ u l n Hu Hn D1 D2 Hl J). cbv zeta in K. fold (sum_of n f u) (spread_of n) in K.
    apply quotient_at_most; [exact W | lra].
Qed.
Lemma way_rest_is n : (0 < n)%Z -> integral 0 u / u^2 = sum_of n f u + u^2 * (spread_of n * way_rest n).
Proof. intros Hn. assert (P := spread_pos n Hn). unfold way_rest. field. lra. Qed.

(** One step, from u' to u. *)
Variable d : R.
Hypothesis HU : 0 < d < U.
Hypothesis Eu : u = U + d.
Let m := U + d^2 / (3 * U).
Definition step_rest := (integral (U - d) u - 2 * U * d * f m) / (d^3 * U * (1 / 3 - (d / U)^2 / 9)).
Lemma step_spread : 0 < d^3 * U * (1 / 3 - (d / U)^2 / 9).
Proof.
  assert (Q : 0 < d / U < 1).
  { split; [apply Rdiv_lt_0_compat; lra|]. apply Rmult_lt_reg_r with U; [lra|]. replace (d / U * U) with d by (field;
    lra). lra. }
  assert ((d / U)^2 < 1) by (replace ((d / U)^2) with (d / U * (d / U)) by ring; replace 1 with (1 * 1) by ring;
    apply Rmult_le_0_lt_compat; lra).
  apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; [apply pow_lt|]; lra | lra].
Qed.
Theorem step_rest_mean : mean (fun x => U - d < x < u) (kernel2 g g1 g2 U) step_rest.
Proof.
  assert (W := step_spread). assert (Hx : forall x, U - d < x < u -> 0 < x < u) by (intros; lra).
  assert (D1 : forall x, U - d < x < u -> is_derive f x (kernel1 g g1 x))
    by (intros x H; destruct (D x (Hx x H)); apply (kernel_derive g g1 g2 U); [lra | assumption | assumption]).
  assert (D2 : forall x, U - d < x < u -> is_derive (kernel1 g g1) x (kernel2 g g1 g2 U x))
    by (intros x H; destruct (D x (Hx x H)); apply (kernel_derive g g1 g2 U); [lra | assumption | assumption]).
  assert (J : ex_RInt (fun x => x * f x) (U - d) u) by (apply kernel_integrable, I; lra).
  assert (Q : 0 < d^2 / (3 * U) < d).
  { split; [apply Rdiv_lt_0_compat; [apply pow_lt|]; lra|]. apply Rmult_lt_reg_r with (3 * U); [lra|].
    replace (d^2 / (3 * U) * (3 * U)) with (d * d) by (field; lra).
    assert (d * d < d * (3 * U)) by (apply Rmult_lt_compat_l; lra). lra. }
  assert (M : m * ((u^2 - (U - d)^2) / 2) = (u^3 - (U - d)^3) / 3) by (rewrite Eu; unfold m; field; lra).
  assert (E : (u^2 - (U - d)^2) / 2 = 2 * U * d) by (rewrite Eu; field).
  assert (E2 : ((u^4 - (U - d)^4) / 4 - m * ((u^3 - (U - d)^3) / 3)) / 2 = d^3 * U * (1 / 3 - (d / U)^2 / 9))
    by (rewrite Eu; unfold m; field; lra).
  unfold step_rest, integral. rewrite <- (kernel_integral g (U - d) u). fold f. split; intros l Hl.
  - assert (K := node_rule f _ _ (U - d) u l m ltac:(unfold m; lra) ltac:(unfold m; lra) D1 D2 Hl J M).
    rewrite E, E2 in K.
    apply quotient_at_least; [exact W | lra].
  - assert (K := node_rule_above f _ _ (U - d) u l m ltac:(unfold m; lra) ltac:(unfold m; lra) D1 D2 Hl J M).
    rewrite E, E2 in K.
    apply quotient_at_most; [exact W | lra].
Qed.
Lemma step_rest_is : integral (U - d) u / (d * U) = 2 * f m + U^2 * (step_rest * ((d / U)^2 * (1 / 3 - (d / U)^2 /
  9))).
Proof.
  assert (W := step_spread). unfold step_rest. set (x := 1 / 3 - (d / U)^2 / 9) in *. field.
  assert (x <> 0) by (intros E; rewrite E, Rmult_0_r in W; lra). repeat split; lra.
Qed.
End Rests.

(** The second order: the share of u^2/2 of a part is enough. *)
Section Second.
Variables (g : R -> R) (U u h : R) (n : Z).
Hypothesis HU : 0 < U.
Hypothesis Hu : 0 < u.
Hypothesis Hn : (0 < n)%Z.
Hypothesis I : forall a b, 0 <= a -> a <= b <= u -> ex_RInt (fun x => sin x * g (PI - x)) a b.
Hypothesis whole : fold_right (fun i s => part_weight n i + s) 0 (upto 0 (Z.to_nat n)) = 1 / 2.
Let integral a b := RInt (fun x => sin x * g (PI - x)) a b.
Definition part_rise i := (integral (u * cut n i) (u * cut n (i + 1)) / (u^2 * part_weight n i) - h) / U.
Lemma part_weight_pos i : (0 <= i)%Z -> 0 < part_weight n i.
Proof. intros Hi. unfold part_weight. apply Rdiv_lt_0_compat; apply IZR_lt; nia. Qed.
Lemma part_rise_mean i : (0 <= i < n)%Z ->
  mean (fun x => u * cut n i < x < u * cut n (i + 1)) (fun x => (kernel g x - h) / U) (part_rise i).
Proof.
  intros Hi. assert (R0 := cuts_range u n Hu Hn i ltac:(lia)). assert (R1 := cuts_range u n Hu Hn (i + 1) ltac:(lia)).
  assert (S := cuts_step u n Hu Hn i). cbv beta in R0, R1, S. assert (W := part_weight_pos i ltac:(lia)).
  assert (N : 0 < IZR n) by (now apply IZR_lt).
  assert (E : ((u * cut n (i + 1))^2 - (u * cut n i)^2) / 2 = u^2 * part_weight n i).
  { unfold cut, part_weight. repeat rewrite ?mult_IZR, ?plus_IZR. field. lra. }
  set (a := u * cut n i) in *. set (b := u * cut n (i + 1)) in *. set (w := u^2 * part_weight n i) in *.
  assert (W0 : 0 < w) by (apply Rmult_lt_0_compat; [apply pow_lt|]; lra).
  assert (J : ex_RInt (fun x => x * kernel g x) a b) by (apply kernel_integrable, I; lra).
  unfold part_rise, integral. fold a b w. rewrite <- (kernel_integral g a b).
  split; intros l Hl.
  - assert (K := weighted_below (kernel g) a b (l * U + h) ltac:(lra) J). rewrite E in K.
    assert (K' : (l * U + h) * w <= RInt (fun x => x * kernel g x) a b).
    { apply K. intros x Hx. assert (B := Hl x Hx). apply Rmult_le_compat_r with (r := U) in B; [|lra].
      replace ((kernel g x - h) / U * U) with (kernel g x - h) in B by (field; lra). lra. }
    apply quotient_at_least; [exact HU|]. assert (L := quotient_at_least _ _ _ W0 K'). lra.
  - assert (K := weighted_above (kernel g) a b (l * U + h) ltac:(lra) J). rewrite E in K.
    assert (K' : RInt (fun x => x * kernel g x) a b <= (l * U + h) * w).
    { apply K. intros x Hx. assert (B := Hl x Hx). apply Rmult_le_compat_r with (r := U) in B; [|lra].
      replace ((kernel g x - h) / U * U) with (kernel g x - h) in B by (field; lra). lra. }
    apply quotient_at_most; [exact HU|]. assert (L := quotient_at_most _ _ _ W0 K'). lra.
Qed.
Theorem second_is : (integral 0 u / u^2 - h / 2) / U =
  fold_right (fun i s => part_rise i * part_weight n i + s) 0 (upto 0 (Z.to_nat n)).
Proof.
  assert (N : 0 < IZR n) by (now apply IZR_lt). assert (C := chain (fun x =>
    sin x * g (PI - x)) u n Hu Hn I (Z.to_nat n) 0 ltac:(lia)).
  cbn [Nat.add] in C.
  replace (u * cut n (Z.of_nat 0)) with 0 in C by (unfold cut; simpl; field; lra).
  replace (u * cut n (Z.of_nat (Z.to_nat n))) with u in C by (rewrite Z2Nat.id by lia; unfold cut; field; lra).
  unfold integral at 1. rewrite C. replace (h / 2) with (h * (1 / 2)) by field. rewrite <- whole.
  assert (Hall : forall i, In i (upto 0 (Z.to_nat n)) -> (0 <= i < n)%Z).
  { intros i Hin. unfold upto in Hin. apply in_map_iff in Hin. destruct Hin as [k [<- Hk]]. apply in_seq in Hk. lia. }
  clear C whole. revert Hall. generalize (upto 0 (Z.to_nat n)). intros t.
  induction t as [|i t IH]; intros Hall; cbn [fold_right]; [field; lra|].
  rewrite <- IH by (intros k Hk; apply Hall; now right). assert (W := part_weight_pos i ltac:(apply Hall; now left)).
  unfold part_rise, integral. field. lra.
Qed.
End Second.
