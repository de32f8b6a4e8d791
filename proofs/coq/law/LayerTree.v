(** The cover of the layer, in doubles: a tree of boxes of U and rho, as bits, whose leaves are checked.
A box has whole
    numbers, of which 65536 are 9/10 in U and 1/5 in rho.

    next        == the next bit of some words, each from its low end
    holds       == (C6) and (C7), at every step of a box
    covered     == the words cover a box: 00 is a leaf with a slope, 01 one beyond eps = 1/1000, 10 a box halved in U,
      11 in rho
    covered_holds == then (C6) and (C7) hold there
    split_U, split_rho == they hold on a box if they do on both halves *)
From Coq Require Import Reals ZArith Lra Bool List.
From Interval Require Import Float.Basic Float.Sig Float.Primitive_ops Interval.Float.
From Dumbbell Require Import Quotients LawStatement Ends LayerState LayerLeaf LayerSound LayerBounds.
Local Open Scope R_scope.

Module D := LayerBounds PrimitiveFloat.
Import D.
Definition p53 : PrimitiveFloat.precision := PrimitiveFloat.PtoP 53.
Definition layer_constants := Eval vm_compute in make_constants p53 12 8.
Lemma layer_constants_are : layer_constants = make_constants p53 12 8.
Proof. vm_cast_no_check (eq_refl layer_constants). Qed.

Definition side a c l m := I.join (I.div p53 (I.fromZ p53 (a * l)) (I.fromZ p53 m)) (I.div p53 (I.fromZ p53 (c * l))
  (I.fromZ p53 m)).
Definition side_U a c := side a c 9 655360.
Definition side_rho a c := side a c 1 327680.
Definition unit_box a c d e eps w al w' al' := layer_step eps w al w' al' /\
  IZR a <= middle w w' * (655360 / 9) <= IZR c /\ IZR d <= half w w' / middle w w' * 327680 <= IZR e.
Definition holds a c d e := forall eps w al w' al', unit_box a c d e eps w al w' al' -> layer_bounds eps w al w' al'.
Lemma split_U m a c d e : holds a m d e -> holds m c d e -> holds a c d e.
Proof.
  intros H1 H2 eps w al w' al' (HL & HU & Hr). destruct (Rle_dec (middle w w' * (655360 / 9)) (IZR m)) as [L|L].
  - apply H1. split; [exact HL|split; [lra | exact Hr]].
  - apply Rnot_le_lt in L. apply H2. split; [exact HL|split; [lra | exact Hr]].
Qed.
Lemma split_rho m a c d e : holds a c d m -> holds a c m e -> holds a c d e.
Proof.
  intros H1 H2 eps w al w' al' (HL & HU & Hr). destruct (Rle_dec (half w w' / middle w w' * 327680) (IZR m)) as [L|L].
  - apply H1. split; [exact HL|split; [exact HU | lra]].
  - apply Rnot_le_lt in L. apply H2. split; [exact HL|split; [exact HU | lra]].
Qed.
Lemma side_in x a c l m : 0 < IZR m -> IZR (a * l) / IZR m <= x <= IZR (c * l) / IZR m ->
  inI x (side a c l m).
Proof. intros Hm Hx. apply (join_in (IZR (a * l) / IZR m) (IZR (c * l) / IZR m));
  [apply frac_in | apply frac_in | exact Hx]. Qed.
Lemma side_U_in x a c : IZR a <= x * (655360 / 9) <= IZR c -> inI x (side_U a c).
Proof. intros H. apply side_in; [lra|]. rewrite !mult_IZR. split; [apply quotient_at_most | apply quotient_at_least];
  lra. Qed.
Lemma side_rho_in x a c : IZR a <= x * 327680 <= IZR c -> inI x (side_rho a c).
Proof. intros H. apply side_in; [lra|]. rewrite !mult_IZR. split; [apply quotient_at_most | apply quotient_at_least];
  lra. Qed.
Lemma slope_holds a c d e : slope_leaf p53 layer_constants (side_U a c) (side_rho d e) = true -> holds a c d e.
Proof.
  rewrite layer_constants_are. intros H eps w al w' al' (HL & HU & Hr).
  exact (slope_leaf_sound p53 eps w al w' al' HL (side_U a c) (side_rho d e) (side_U_in _ _ _ HU) (side_rho_in _ _ _
    Hr) H).
Qed.
Lemma beyond_holds a c d e : beyond_leaf p53 layer_constants (side_U a c) (side_rho d e) = true -> holds a c d e.
Proof.
  rewrite layer_constants_are. intros H eps w al w' al' (HL & HU & Hr). exfalso.
  exact (beyond_leaf_sound p53 eps w al w' al' HL (side_U a c) (side_rho d e) (side_U_in _ _ _ HU) (side_rho_in _
    _ _ Hr) H).
Qed.

(** For any two tests, so that nobody unfolds them. *)
Section Tests.
Variables slope beyond : Z -> Z -> Z -> Z -> bool.
Fixpoint next (words : list positive) : bool * list positive :=
  match words with
  | nil => (false, nil)
  | cons xH t => next t
  | cons (xO w) t => (false, cons w t)
  | cons (xI w) t => (true, cons w t)
  end.
(** A leaf that does not pass as a whole may pass in two halves. What the bits are is not trusted: n bounds the depth.
*)
Fixpoint covered_by (n : nat) (words : list positive) (a c d e : Z) : option (list positive) :=
  match n with
  | O => None
  | S n =>
    let '(is_split, words) := next words in let '(second, words) := next words in
    if is_split then
      if second then let m := ((d + e) / 2)%Z in
        match covered_by n words a c d m with Some words => covered_by n words a c m e | None => None end
      else let m := ((a + c) / 2)%Z in
        match covered_by n words a m d e with Some words => covered_by n words m c d e | None => None end
    else if second then if beyond a c d e then Some words else None
    else if slope a c d e then Some words else
      let m := ((d + e) / 2)%Z in if slope a c d m && slope a c m e then Some words else None
  end.
Hypothesis slope_true : forall a c d e, slope a c d e = true -> holds a c d e.
Hypothesis beyond_true : forall a c d e, beyond a c d e = true -> holds a c d e.
Lemma covered_by_holds n : forall words rest a c d e, covered_by n words a c d e = Some rest -> holds a c d e.
Proof.
  induction n as [|n IH]; intros words rest a c d e H; [discriminate|]. cbn [covered_by] in H.
  destruct (next words) as [[|] w1], (next w1) as [[|] w2].
  - destruct (covered_by n w2 a c d ((d + e) / 2)) as [w3|] eqn:E; [|discriminate].
    apply (split_rho ((d + e) / 2)); [exact (IH _ _ _ _ _ _ E) | exact (IH _ _ _ _ _ _ H)].
  - destruct (covered_by n w2 a ((a + c) / 2) d e) as [w3|] eqn:E; [|discriminate].
    apply (split_U ((a + c) / 2)); [exact (IH _ _ _ _ _ _ E) | exact (IH _ _ _ _ _ _ H)].
  - destruct (beyond a c d e) eqn:E; [now apply beyond_true | discriminate].
  - destruct (slope a c d e) eqn:E; [now apply slope_true|]. destruct (slope a c d ((d + e) / 2)) eqn:E1;
    [|discriminate].
    destruct (slope a c ((d + e) / 2) e) eqn:E2; [|discriminate]. apply (split_rho ((d + e) / 2));
      now apply slope_true.
Qed.
End Tests.
Definition covered words a c d e := match
  covered_by (fun a c d e => slope_leaf p53 layer_constants (side_U a c) (side_rho d e))
    (fun a c d e => beyond_leaf p53 layer_constants (side_U a c) (side_rho d e)) 40 words a c d e with Some _ =>
      true | None => false end.
Theorem covered_holds words a c d e : covered words a c d e = true -> holds a c d e.
Proof.
  unfold covered. assert (K := covered_by_holds _ _ slope_holds beyond_holds 40 words).
  destruct (covered_by _ _ 40 words a c d e) as [rest|] eqn:E; [|discriminate]. intros _. exact (K rest a c d e E).
Qed.
