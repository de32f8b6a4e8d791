(** Induction over an interval of real numbers, by the least upper bound: what holds at its beginning, goes on for a
    while from wherever it has held so far, and holds at the end of each stretch on which it has held, holds on all of
    it.

    real_induction == induction over [a, b] *)
From Coq Require Import Reals Lra.
Local Open Scope R_scope.

Theorem real_induction (Q : R -> Prop) a b : Q a ->
  (forall m, a <= m < b -> (forall s, a <= s <= m -> Q s) -> exists d, 0 < d /\ forall s, m < s <= m + d -> Q s) ->
  (forall m, a < m <= b -> (forall s, a <= s < m -> Q s) -> Q m) -> forall s, a <= s <= b -> Q s.
Proof.
  intros H0 Hnext Hlim s Hs. set (E := fun x => a <= x <= b /\ forall y, a <= y <= x -> Q y).
  assert (E0 : E a) by (split; [lra|]; intros y Hy; now replace y with a by lra).
  destruct (completeness E) as [m [Hub Hlub]]. { exists b. intros x [Hx _]. lra. } { now exists a. }
  assert (M1 : a <= m) by now apply Hub. assert (M2 : m <= b) by (apply Hlub; intros x [Hx _]; lra).
  assert (Hbelow : forall y, a <= y < m -> Q y).
  { intros y Hy. apply Classical_Prop.NNPP. intros K. assert (m <= y); [|lra]. apply Hlub. intros x [_ Hx].
    apply Rnot_lt_le. intros L. apply K, Hx. lra. }
  assert (Hm : Q m). { destruct (Req_dec m a) as [->|N]; [exact H0 | apply Hlim; [lra | exact Hbelow]]. }
  assert (Hupto : forall y, a <= y <= m -> Q y).
  { intros y Hy. destruct (Req_dec y m) as [->|]; [exact Hm | apply Hbelow; lra]. }
  destruct (Rle_lt_or_eq_dec m b M2) as [L|L]; [exfalso | apply Hupto; lra].
  destruct (Hnext m (conj M1 L) Hupto) as [d [Hd K]]. set (x := Rmin (m + d) b).
  assert (X1 : x <= m + d) by apply Rmin_l. assert (X2 : x <= b) by apply Rmin_r.
  assert (X3 : m < x) by (apply Rmin_glb_lt; lra).
  assert (Ex : E x) by (split; [lra|]; intros y Hy; destruct (Rle_or_lt y m); [apply Hupto | apply K]; lra).
  specialize (Hub x Ex). lra.
Qed.
