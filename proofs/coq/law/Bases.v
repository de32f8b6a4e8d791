(** What the theorems rest on that `prove --kernel` prints: a claim decided by two orbits, a claim decided by the law, and
    a certificate that is checked in parts, say what they say. One theorem, so that what it rests on is asked once, and
    of a printed theorem only what it adds.

    bases, bases_hold == what is computed of a claim, or of a certificate's parts, is true *)
From Coq Require Import NArith List.
From Dumbbell Require Import Certificate Check Decide ByLaw Verdict Decided DecidedByLaw.

Definition orbits_decide := forall v w c, holds v w c = true -> says c.
Definition law_decides := forall c, by_law c = Holds -> says c.
Definition parts_decide := forall d c, joined (range_from c) (pieces c) (range_to c) = true -> pieces c <> nil ->
  faultless (pieces c) = true -> unproved d c = None -> proved d c.
Definition bases := orbits_decide /\ law_decides /\ parts_decide.

Theorem bases_hold : bases.
Proof.
  split; [exact decided_by_orbits | split; [exact by_law_true|]].
  intros d c A B C D. exact (fault_none true d c (all_parts d c A B C D)).
Qed.
