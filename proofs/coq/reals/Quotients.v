(** Bounds of quotients, without the quotient.

    quotient_at_most, quotient_at_least == a/c <= b from a <= b c, and the other way round
    divided_by_share == x <= x/c for a share c of 1 *)
From Coq Require Import Reals Lra.
Local Open Scope R_scope.

Lemma quotient_at_most a b c : 0 < c -> a <= b * c -> a / c <= b.
Proof. intros Hc H. apply Rmult_le_reg_r with c; [exact Hc|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. Qed.
Lemma quotient_at_least a b c : 0 < c -> b * c <= a -> b <= a / c.
Proof. intros Hc H. apply Rmult_le_reg_r with c; [exact Hc|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. Qed.
Lemma divided_by_share x c : 0 <= x -> 0 < c <= 1 -> x <= x / c.
Proof.
  intros Hx Hc. apply quotient_at_least; [lra|]. rewrite <- (Rmult_1_r x) at 2. apply Rmult_le_compat_l; lra.
Qed.
