(** Signs of products.

    pos == proves 0 < e, 0 <= e and e <> 0, where e is made by products, quotients, inverses, powers and roots of what
           [lra] knows to be so, and a b <= c d (or <) factor by factor *)
From Coq Require Import Reals Lra.
Local Open Scope R_scope.

Ltac pos :=
  match goal with
  | |- _ => assumption
  | |- _ < PI => exact PI_RGT_0
  | |- _ <= ?x * ?x => apply Rle_0_sqr
  | |- _ <= sqrt _ => apply sqrt_pos
  | |- _ <= Rabs _ => apply Rabs_pos
  | |- _ <= INR _ => apply pos_INR
  | |- _ < IZR (Zpos _) => now apply IZR_lt
  | |- 0 < _ * _ => apply Rmult_lt_0_compat; pos
  | |- 0 <= _ * _ => apply Rmult_le_pos; pos
  | |- 0 < _ / _ => apply Rdiv_lt_0_compat; pos
  | |- 0 <= _ / _ => apply Rle_mult_inv_pos; pos
  | |- 0 < / _ => apply Rinv_0_lt_compat; pos
  | |- 0 <= / _ => left; pos
  | |- 0 < sqrt _ => apply sqrt_lt_R0; pos
  | |- 0 < _ ^ _ => apply pow_lt; pos
  | |- 0 <= _ ^ _ => apply pow_le; pos
  | |- ?x * _ <= ?x * _ => apply Rmult_le_compat_l; pos
  | |- _ * ?x <= _ * ?x => apply Rmult_le_compat_r; pos
  | |- ?x * _ < ?x * _ => apply Rmult_lt_compat_l; pos
  | |- _ * ?x < _ * ?x => apply Rmult_lt_compat_r; pos
  | |- _ * _ <= _ * _ => apply Rmult_le_compat; pos
  | |- _ => lra
  end.
