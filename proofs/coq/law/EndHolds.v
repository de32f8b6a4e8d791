(** Condition (C11) of law.md holds: in the processor's doubles, on 200 parts of 0 < d <= 0.09, computed by the kernel.

    parts, steps_H, steps_H2 == how many parts of d there are; slices of g1, of g2
    cell, all_parts == each part holds
    end_holds       == (C11) *)
From Coq Require Import Reals ZArith Lra Lia List Bool.
From Interval Require Import Float.Basic Float.Primitive_ops Interval.Float.
From Dumbbell Require Import Quotients LawStatement Ends EndPart.
Module P := EndPart PrimitiveFloat.
Import P.
Definition p53 : PrimitiveFloat.precision := PrimitiveFloat.PtoP 53.

Definition parts : nat := 200.
Definition steps_H : nat := 256.
Definition steps_H2 : nat := 8.
Definition edge (i : nat) : I.type := frac p53 (9 * Z.of_nat i) (100 * Z.of_nat parts).
Definition cell (i : nat) : bool := part_holds p53 (I.join (edge i) (edge (S i))) (edge i) steps_H steps_H2.
Lemma all_parts : forallb cell (seq 0 parts) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Local Open Scope R_scope.
Lemma which_part w d n : 0 <= d <= w * INR n -> (0 < n)%nat -> exists i, (i < n)%nat /\ w * INR i <= d <= w * INR (S
  i).
Proof.
  intros [D0 D1] Hn. induction n as [|n IH]; [lia|]. destruct (Rle_dec (w * INR n) d) as [L|L].
  - exists n. split; [lia | lra].
  - destruct (Nat.eq_dec n 0) as [->|N]; [simpl in L; lra|]. destruct (IH ltac:(lra) ltac:(lia)) as [i [I J]].
    exists i. split; [lia | exact J].
Qed.
Lemma edge_in i : inI (9 / 20000 * INR i) (edge i).
Proof.
  replace (9 / 20000 * INR i) with (IZR (9 * Z.of_nat i) / IZR (100 * Z.of_nat parts)); [apply frac_in|].
  rewrite mult_IZR, <- INR_IZR_INZ. simpl IZR. field.
Qed.
Theorem end_holds : end_of_orbit.
Proof.
  intros eps u al y H Heps Hu HQ HJ. destruct (last_step eps u al y H) as [_ [U _]].
  destruct (which_part (9/20000) (u / 2) parts) as [i [Hi [L1 L2]]]; [|unfold parts; lia|].
  { change (INR parts) with (INR 200). rewrite INR_IZR_INZ. simpl IZR. lra. }
  assert (C := proj1 (forallb_forall _ _) all_parts i ltac:(apply in_seq; lia)).
  apply (part_sound p53 _ steps_H steps_H2 (edge i) (9 / 20000 * INR i) eps u al y C); try assumption.
  - unfold steps_H, steps_H2. lia.
  - apply (join_in (9 / 20000 * INR i) (9 / 20000 * INR (S i))); [apply edge_in | apply edge_in | now split].
  - apply edge_in.
Qed.
