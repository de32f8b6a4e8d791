(** Read as an enemy: the wall's push is law (1) of L0, and gamma is the angle of the two walls of the wedge. *)
From Coq Require Import Reals Lra.
From Dumbbell Require Import Trigonometry Wedge WedgeFlights PublishedBound WedgeUpper.
Local Open Scope R_scope.

(** Law (1): with r = 1/q, N = (- w, 1) and n = (- w, r), a point that comes in, N.v < 0, is pushed to
    v' = v - 2 (N.v)/(N.n) n, and no other velocity v' is different from v. *)
Definition law_1 r w v := let Nv := yhat v - w * psi v in let Nn := w * w + r in
  {| psi := psi v - 2 * Nv / Nn * - w; yhat := yhat v - 2 * Nv / Nn * r |}.
Theorem push_is_law_1 q w v v' : 0 < q -> yhat v < w * psi v -> v' <> v ->
  (push q w v v' <-> v' = law_1 (/ q) w v).
Proof.
  intros Hq Hi Hne. assert (Q := Rinv_0_lt_compat q Hq). assert (W : 0 <= w * w) by apply Rle_0_sqr.
  assert (P : 0 <= q * (w * w)) by (apply Rmult_le_pos; lra).
  assert (E : w * w + / q = (1 + q * (w * w)) / q) by (field; lra). split.
  - intros H. destruct (push_cases q w v v' Hq H) as [K|[j [_ [A [U J]]]]]; [contradiction|].
    assert (Ej : j = 2 * (w * psi v - yhat v) / (1 + q * (w * w))) by (rewrite <- J; field; lra).
    unfold law_1. rewrite E. apply point_eq; simpl; [rewrite A | rewrite U]; rewrite Ej; field; lra.
  - intros ->. exists (2 * (w * psi v - yhat v) / (1 + q * (w * w))). unfold law_1, energy. rewrite E. simpl.
    split; [|split; [|split]]; [|field; lra | field; lra | field; lra].
    apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; lra].
Qed.

(** The walls go up from the vertex in the directions (1, 1) and (-1, 1). *)
Definition dot q v v' := psi v * psi v' + q * (yhat v * yhat v').
Theorem gamma_is_the_angle q : 0 < q -> let a := {| psi := 1; yhat := 1 |} in let b := {| psi := -1; yhat := 1 |} in
  dot q a b = cos (gamma q) * (sqrt (dot q a a) * sqrt (dot q b b)).
Proof.
  intros Hq a b. unfold dot. simpl. replace (-1 * -1) with 1 by ring. replace (1 * 1) with 1 by ring.
  rewrite sqrt_sqrt by lra. unfold gamma. destruct (atan_parts (sqrt q)) as [C E].
  assert (Q := sqrt_sqrt q ltac:(lra)). set (f := atan (sqrt q)) in *. set (k := sqrt q) in *.
  rewrite cos_minus, cos_PI, sin_PI, cos_2a, <- E. assert (P := unit_circle f). rewrite <- E in P.
  assert (X : cos f * cos f * (1 + q) = 1) by (rewrite <- Q; lra).
  replace ((-1 * (cos f * cos f - k * cos f * (k * cos f)) + 0 * sin (2 * f)) * (1 + q * 1)) with
    ((k * k - 1) * (cos f * cos f * (1 + q))) by ring. rewrite X, Q. ring.
Qed.
