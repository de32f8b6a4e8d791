(** Whether one of the two orbits of Theorem 1 (exact/Orbits.v) collides n times, at one mass ratio: computed with
    intervals from one end of an enclosure of r = 1/q, that it is so and that it is not. Generic in the numbers.

    orbit, collides                          == the top orbit or the corner orbit; it has n collisions at a given r
    orbit_at_most, orbit_at_least            == computed: at most, at least n, at a given ratio
    orbit_at_most_sound, orbit_at_least_sound == and it is so *)
From Coq Require Import Reals ZArith NArith Lra Lia List Bool.
From Interval Require Import Real.Xreal Float.Basic Float.Sig Interval.Interval Interval.Float Interval.Float_full.
From Dumbbell Require Import Ray Certificate FullLeaves.
Local Open Scope R_scope.

(** The horizontal ray over the top of the bridge, and the ray out of a corner along the bridge's tangent. *)
Inductive orbit := Top | Corner.
Definition first_height o r := match o with Top => r | Corner => PI * r end.
Definition first_slope o r := match o with Top => 0 | Corner => r end.
Definition collides o n r := coll r n (first_height o r) (first_slope o r).

Module TwoOrbits (F : FloatOps with Definition sensible_format := true).
Include FullLeaves F.
Import Z.

Section S.
Variable p : F.precision.
Variable G : guesses.
Variable T : consts.

Definition orbit_ratio (q : ratio) : I.type := I.div p (I.fromZ p (Zpos (den q))) (I.fromZ p (Zpos (num q))).
Definition orbit_height o (r : I.type) : I.type := match o with Top => r | Corner => I.mul p (pi_ T) r end.
Definition orbit_slope o (r : I.type) : I.type := match o with Top => I.zero | Corner => r end.
Definition orbit_at_most o (n : nat) (q : ratio) : bool :=
  let r := low (orbit_ratio q) in nonneg r && at_most p G T n r (low (orbit_height o r)) (orbit_slope o r) (first_guess G).
Definition orbit_at_least o (n : nat) (q : ratio) : bool :=
  let r := up (orbit_ratio q) in
  nonneg (I.sub p (unit_ T) r) && at_least p G T n r (up (orbit_height o r)) (orbit_slope o r) (first_guess G).

(* ---------- soundness ---------- *)
Hypothesis HT : T = mkconsts p.
Variable q : ratio.
Hypothesis Hq : 1 <= ratio_value q.
Notation r := (/ ratio_value q).

Lemma orbit_ratio_range : 0 < r <= 1.
Proof. split; [apply Rinv_0_lt_compat; lra|]. rewrite <- Rinv_1. apply Rinv_le_contravar; lra. Qed.
Lemma orbit_ratio_in : inI r (orbit_ratio q).
Proof.
  replace r with (IZR (Zpos (den q)) / IZR (Zpos (num q))).
  - apply div_in; apply fromZ_in.
  - unfold ratio_value. assert (0 < IZR (Zpos (den q))) by now apply IZR_lt.
    assert (0 < IZR (Zpos (num q))) by now apply IZR_lt. field. lra.
Qed.
Lemma orbit_height_in o x xi : inI x xi -> inI (first_height o x) (orbit_height o xi).
Proof. intros H. destruct o; [exact H|]. apply mul_in; [exact (pi_in p T HT) | exact H]. Qed.
Lemma orbit_slope_in o x xi : inI x xi -> inI (first_slope o x) (orbit_slope o xi).
Proof. intros H. destruct o; [exact zero_in | exact H]. Qed.
Lemma orbit_mono o x y : x <= y -> first_height o x <= first_height o y /\ first_slope o x <= first_slope o y.
Proof.
  intros H. assert (0 < PI) by apply PI_RGT_0. destruct o; simpl; split; try lra. apply Rmult_le_compat_l; lra.
Qed.
Lemma orbit_nonneg o x : 0 <= x -> 0 <= first_height o x /\ 0 <= first_slope o x.
Proof.
  intros H. assert (0 < PI) by apply PI_RGT_0. destruct o; simpl; split; try lra. apply Rmult_le_pos; lra.
Qed.

Theorem orbit_at_most_sound o n : orbit_at_most o n q = true -> forall m, collides o m r -> (m <= n)%nat.
Proof.
  unfold orbit_at_most. intros H m Hm. apply andb_prop in H. destruct H as [H0 H]. assert (R := orbit_ratio_range).
  destruct (low_ok _ _ orbit_ratio_in) as [x [Hx L]]. assert (P := nonneg_ok _ _ H0 Hx).
  destruct (low_ok _ _ (orbit_height_in o x _ Hx)) as [c [Hc Lc]].
  destruct (orbit_mono o _ _ L) as [M1 M2]. destruct (orbit_nonneg o r ltac:(lra)) as [P1 P2].
  apply (at_most_sound p G T HT n _ _ _ _ H x c (first_slope o x) Hx Hc (orbit_slope_in o x _ Hx)) with (2 := Hm).
  unfold below. repeat split; lra.
Qed.
Theorem orbit_at_least_sound o n : orbit_at_least o n q = true -> collides o n r.
Proof.
  unfold orbit_at_least. intros H. apply andb_prop in H. destruct H as [H0 H]. assert (R := orbit_ratio_range).
  destruct (up_ok _ _ orbit_ratio_in) as [x [Hx L]].
  assert (P := nonneg_ok _ _ H0 (sub_in p _ _ _ _ (unit_in p T HT) Hx)).
  destruct (up_ok _ _ (orbit_height_in o x _ Hx)) as [c [Hc Lc]].
  destruct (orbit_mono o _ _ L) as [M1 M2]. destruct (orbit_nonneg o r ltac:(lra)) as [P1 P2].
  apply (at_least_sound p G T HT n _ _ _ _ H x c (first_slope o x) Hx Hc (orbit_slope_in o x _ Hx)).
  unfold above. repeat split; lra.
Qed.
End S.
End TwoOrbits.
