(** From a certificate to the physics: an accepted piece bounds the number of collisions of every motion of every
    dumbbell whose mass ratio lies in the piece, and such a motion with that many collisions exists. Nothing is
    Admitted. *)
From Coq Require Import Reals ZArith List Lra.
From Dumbbell Require Import Physics LightTotal WitnessMotion Doubles.
Local Open Scope R_scope.

(** A piece of a certificate (Theorem of lemmas.md). *)
Theorem piece_sound P : check P = true ->
  forall q, IZR (TP.An P) / IZR (TP.Ad P) <= q <= IZR (TP.Bn P) / IZR (TP.Bd P) ->
  upper_bound q (TP.U P) /\ lower_bound q (TP.Vn P).
Proof.
  intros H q Hq. destruct (check_sound P H q Hq) as [A [B [C D]]].
  split; [now apply charts_upper | now apply charts_lower].
Qed.

(** A chain of pieces: for every q in a piece the piece says what N(q) is. *)
Definition all_checked (l : list TP.piece) := forallb check l.
Theorem chain_sound l : all_checked l = true -> forall P, In P l -> forall q,
  IZR (TP.An P) / IZR (TP.Ad P) <= q <= IZR (TP.Bn P) / IZR (TP.Bd P) ->
  upper_bound q (TP.U P) /\ lower_bound q (TP.Vn P).
Proof. intros H P HP. apply piece_sound. unfold all_checked in H. rewrite forallb_forall in H. now apply H. Qed.

Corollary N_of_10 : N_star 10 4.
Proof. apply (piece_sound q10 q10_ok). simpl. lra. Qed.
