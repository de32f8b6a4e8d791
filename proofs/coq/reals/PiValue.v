(** Decimals of pi.

    pi_value == three of them, for [lra]
    pi_digits == eight, for coq-interval *)
From Coq Require Import Reals.
From Interval Require Import Tactic.
Local Open Scope R_scope.

Lemma pi_value : 3.14159 < PI < 3.14160.
Proof. split; interval. Qed.
Lemma pi_digits : 3.14159265 <= PI <= 3.14159266.
Proof. split; interval. Qed.
