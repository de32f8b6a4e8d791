(** Bounds of the arctangent.

    arctangent_near == x - x^3/3 <= atan x <= x - x^3/3 + x^5/5
    arctangent_rise == (y - x) (1 - y^2) <= atan y - atan x <= y - x *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Sines.
Local Open Scope R_scope.

Lemma arctangent_near x : 0 <= x -> x - x^3 / 3 <= atan x <= x - x^3 / 3 + x^5 / 5.
Proof.
  intros Hx. assert (P : forall y, 0 < 1 + y^2) by (intros y; assert (0 <= y^2) by apply pow2_ge_0; lra). split.
  - assert (K : 0 <= atan x - (x - x^3 / 3)); [|lra].
    apply (grows (fun y => atan y - (y - y^3 / 3)) (fun y => y^4 / (1 + y^2)) x); [| | rewrite atan_0; field | lra].
    + intros y _. assert (Y := P y). auto_derive; [easy | field; lra].
    + intros y Hy. apply Rle_mult_inv_pos; [apply pow_le; lra | apply P].
  - assert (K : 0 <= x - x^3 / 3 + x^5 / 5 - atan x); [|lra].
    apply (grows (fun y => y - y^3 / 3 + y^5 / 5 - atan y) (fun y => y^6 / (1 + y^2)) x);
      [| | rewrite atan_0; field | lra].
    + intros y _. assert (Y := P y). auto_derive; [easy | field; lra].
    + intros y Hy. apply Rle_mult_inv_pos; [apply pow_le; lra | apply P].
Qed.
Lemma arctangent_rise x y : 0 <= x < y -> (y - x) * (1 - y^2) <= atan y - atan x <= y - x.
Proof.
  intros H. destruct (MVT_cor2 atan (fun t => / (1 + t ^ 2)) x y) as [t [E Ht]];
    [lra | intros t _; apply derivable_pt_lim_atan |].
  rewrite E. assert (T : 0 <= t^2 <= y^2) by (split; [apply pow2_ge_0 | apply pow_incr; lra]).
  assert (I : 1 - y^2 <= / (1 + t^2) <= 1).
  { split; apply Rmult_le_reg_r with (1 + t^2); try lra; rewrite Rinv_l by lra; [|lra].
    assert (0 <= y^2 * t^2) by (apply Rmult_le_pos; lra). lra. }
  split; [rewrite (Rmult_comm (y - x)); apply Rmult_le_compat_r; lra|].
  apply Rle_trans with (1 * (y - x)); [apply Rmult_le_compat_r; lra | lra].
Qed.
