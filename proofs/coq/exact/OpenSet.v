(** Theorem 1 (c): the contacts with the bridge that belong to motions with N(q) collisions are a set that is not
    empty and open, in the chart of L8: corner distance e in (0, pi/2), steepness eta > 0 above the tangent. *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Trigonometry Physics Ray Chart Orbits Openness Attained ExactMaximum.
Local Open Scope R_scope.

(** The two rays of a contact (L8 (3)) have n - 1 collisions together, at least. *)
Definition contact_with (q e eta : R) (n : nat) := exists a b, (n <= 1 + a + b)%nat /\
  coll (/ q) a (/ q * cX e eta) (/ q * lamX e eta) /\ coll (/ q) b (/ q * cS e eta (/ q)) (/ q * lamS e eta (/ q)).

Section Near.
Variables r e eta : R.
Hypothesis Hr : 0 < r <= 1.
Hypothesis He : 0 < e < PI/2.
Hypothesis Heta : 0 < eta.

Lemma moved_continuous : continuity_pt (fun t => r * cX (e - t) (eta + t)) 0 /\
  continuity_pt (fun t => r * lamX (e - t) (eta + t)) 0 /\
  continuity_pt (fun t => r * cS (e + t) (eta + t) r) 0 /\ continuity_pt (fun t => r * lamS (e + t) (eta + t) r) 0.
Proof.
  destruct (cos_range e ltac:(lra)) as [W0 W1].
  assert (H : 0 < 1 + r * (cos (e + 0) * cos (e + 0)) + 2 * (r * cos (e + 0) * (eta + 0))).
  { rewrite !Rplus_0_r. assert (0 <= r * (cos e * cos e)) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]).
    assert (0 <= r * cos e * eta) by (repeat apply Rmult_le_pos; lra). lra. }
  unfold cX, lamX, cS, lamS, eta_reversed. repeat split; reg; lra.
Qed.
Theorem near_contact a b : coll r a (r * cX e eta) (r * lamX e eta) -> coll r b (r * cS e eta r) (r * lamS e eta r) ->
  exists d, 0 < d /\ forall e' eta', e - d < e' < e + d -> eta - d < eta' < eta + d ->
  coll r a (r * cX e' eta') (r * lamX e' eta') /\ coll r b (r * cS e' eta' r) (r * lamS e' eta' r).
Proof.
  intros Ca Cb. assert (HPI := PI2_1). destruct moved_continuous as [C1 [C2 [C3 C4]]].
  assert (X0 : forall f h, 0 < f < PI/2 -> 0 <= h -> 0 <= r * cX f h /\ 0 <= r * lamX f h).
  { intros f h Hf Hh. destruct (cos_range f ltac:(lra)) as [F0 F1]. assert (0 <= sin f) by (apply sin_ge_0; lra).
    assert (0 <= (cos f + h) * (PI - f)) by (apply Rmult_le_pos; lra). unfold cX, lamX.
    split; apply Rmult_le_pos; lra. }
  assert (S0 : forall f h, 0 < f < PI/2 -> 0 <= h -> 0 <= r * cS f h r /\ - r <= r * lamS f h r).
  { intros f h Hf Hh. assert (A := cS_ge f h r ltac:(lra) Hh Hr). assert (B := lamS_ge f h r ltac:(lra) Hh Hr).
    assert (r * -1 <= r * lamS f h r) by (apply Rmult_le_compat_l; lra). split; [apply Rmult_le_pos|]; lra. }
  destruct (X0 e eta He ltac:(lra)) as [XA XB]. destruct (S0 e eta He ltac:(lra)) as [SA SB].
  assert (XC : - r <= r * lamX e eta) by lra. assert (R0 := proj1 Hr).
  destruct (L20_raise a _ _ r XA R0 XC Ca) as [ea [Ha Na]].
  destruct (L20_raise b _ _ r SA R0 SB Cb) as [eb [Hb Nb]].
  set (m := Rmin ea eb). assert (M : 0 < m) by (now apply Rmin_glb_lt).
  assert (M1 : m <= ea) by apply Rmin_l. assert (M2 : m <= eb) by apply Rmin_r.
  set (l := Rmin (Rmin e (PI/2 - e)) eta). assert (L0 : 0 < l) by (repeat apply Rmin_glb_lt; lra).
  assert (L1 : l <= Rmin e (PI/2 - e)) by apply Rmin_l. assert (L2 : l <= eta) by apply Rmin_r.
  assert (L3 := Rmin_l e (PI/2 - e)). assert (L4 := Rmin_r e (PI/2 - e)).
  destruct (four_near _ _ _ _ m l C1 C2 C3 C4 M L0) as [t [Ht [T1 [T2 [T3 T4]]]]].
  rewrite !Rplus_0_r, !Rminus_0_r in *. exists t. split; [lra|]. intros e' h He' Hh.
  destruct (X0 e' h ltac:(lra) ltac:(lra)) as [P1 P2]. destruct (S0 e' h ltac:(lra) ltac:(lra)) as [P3 P4].
  assert (Q1 : r * cX e' h <= r * cX (e - t) (eta + t)) by (apply Rmult_le_compat_l; [lra | apply cX_mono; lra]).
  assert (Q2 : r * lamX e' h <= r * lamX (e - t) (eta + t)) by (apply Rmult_le_compat_l; [lra | apply lamX_mono;
    lra]).
  assert (Q3 : r * cS e' h r <= r * cS (e + t) (eta + t) r) by (apply Rmult_le_compat_l; [lra | apply cS_mono; lra]).
  assert (Q4 : r * lamS e' h r <= r * lamS (e + t) (eta + t) r) by (apply Rmult_le_compat_l; [lra | apply lamS_mono;
    lra]).
  split; [apply Na | apply Nb]; lra.
Qed.
End Near.

Theorem theorem_1c_open q n e eta : 1 <= q -> 0 < e < PI/2 -> 0 < eta -> contact_with q e eta n ->
  exists d, 0 < d /\ forall e' eta', e - d < e' < e + d -> eta - d < eta' < eta + d -> contact_with q e' eta' n.
Proof.
  intros Hq He Heta [a [b [Hn [Ca Cb]]]].
  destruct (near_contact (/ q) e eta (inv_ratio q Hq) He Heta a b Ca Cb) as [d [Hd H]].
  exists d. split; [exact Hd|]. intros e' h He' Hh. exists a, b. split; [exact Hn | now apply H].
Qed.
Theorem theorem_1c_not_empty q n : 1 <= q -> N_star q n -> exists e eta, 0 < e < PI/2 /\ 0 < eta /\
  contact_with q e eta n.
Proof.
  intros Hq Hn. destruct (theorem_1 q Hq) as [k0 [k1 [T [C [_ HN]]]]]. apply HN in Hn. subst n.
  destruct (maximum_witness q k0 k1 Hq T C) as [e [eta [a [b [He [Heta [_ [Ca [Cb L]]]]]]]]].
  exists e, eta. split; [exact He|]. split; [exact Heta|]. now exists a, b.
Qed.
