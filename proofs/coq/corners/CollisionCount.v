(** How many collisions a motion on a stretch of time has: none more than N(q); up to a corner at most (N(q) - 2)/2,
    by L40 (a), 2 + 2 k1 <= N(q).

    stretch_few                          == a motion on a stretch has at most N(q) collisions
    into_corner_coll, out_of_corner_coll == up to a corner, or after one, no more than the corner orbit
    corner_bound                         == 2 + k1 + k1 <= N(q) *)
From Coq Require Import Reals Lra Lia List FinFun.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics Ray Flight Symmetry Existence Orbits Attained.
From Dumbbell Require Import Stretch Stretches WholeMotion.
Local Open Scope R_scope.

Section Count.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.
Hypothesis Hr1 : r_of P <= 1.
Notation r := (r_of P).

(** The collisions up to a corner, and those after one. *)
Theorem into_corner_coll a b p l : Rbar_lt a b -> motion_within P a b p -> ends_in_corner P p b -> NoDup l ->
  (forall t, In t l -> within a b t /\ collision P p t) -> coll r (length l) (PI * r) r.
Proof.
  intros Hab Hm [T [s [-> [C F]]]] Hnd Hl. destruct (into_corner P HP Hr1 a T s p Hm Hab C F) as [q [E [_ Hc]]].
  apply Hc; [exact Hnd|]. intros t Ht. destruct (Hl t Ht) as [[W1 W2] Ct]. split; [now split|].
  apply near_collision with p; [now apply within_near with a T | exact Ct].
Qed.
Lemma reversed_list a b p l : motion_within P a b p -> NoDup l ->
  (forall t, In t l -> within a b t /\ collision P p t) -> NoDup (map Ropp l) /\
  forall t, In t (map Ropp l) -> within (Rbar_opp b) (Rbar_opp a) t /\ collision P (reverse p) t.
Proof.
  intros Hm Hnd Hl. split; [apply Injective_map_NoDup; [intros x y E; lra | exact Hnd]|].
  intros t Ht. apply in_map_iff in Ht. destruct Ht as [t' [<- Ht']]. destruct (Hl t' Ht') as [W C].
  split; [now apply within_reverse | now apply (collision_turned P HP a b)].
Qed.
Theorem out_of_corner_coll a b p l : Rbar_lt a b -> motion_within P a b p -> begins_in_corner P p a -> NoDup l ->
  (forall t, In t l -> within a b t /\ collision P p t) -> coll r (length l) (PI * r) r.
Proof.
  intros Hab Hm Hb Hnd Hl. rewrite <- (map_length Ropp). destruct (reversed_list a b p l Hm Hnd Hl) as [N L].
  apply (into_corner_coll (Rbar_opp b) (Rbar_opp a) (reverse p)); try assumption.
  - now apply Rbar_opp_lt. - now apply motion_reverse. - now apply ends_reverse.
Qed.

Variable U : nat.
Hypothesis HU : forall p, motion P p -> at_most P p U.
(** L40 (a): 2 + 2 k1 <= N(q), from the lower half of Theorem 1. *)
Lemma corner_bound a b : coll r a (PI * r) r -> coll r b (PI * r) r -> (2 + a + b <= U)%nat.
Proof.
  intros Ca Cb. set (q := m2 P / m1 P). assert (Er : / q = r) by (unfold q, r_of; destruct HP as [? [? ?]]; field; lra).
  assert (R0 := r_pos P HP). assert (Hq : 1 <= q).
  { rewrite <- (Rinv_inv q), Er, <- Rinv_1. apply Rinv_le_contravar; lra. }
  destruct (orbits_exist q Hq) as [k0 [k1 [T C]]]. assert (L := L21_counts q k0 k1 Hq T C).
  destruct (at_least_2_k0_k1 q k0 k1 Hq T C P HP eq_refl) as [p [Hm [l [A [B D]]]]].
  assert (K := HU p Hm l A D). unfold corner_orbit in C. rewrite Er in C.
  assert (Ka := exactly_max _ _ _ _ C a Ca). assert (Kb := exactly_max _ _ _ _ C b Cb). lia.
Qed.

Theorem whole_few a b p : Rbar_lt a b -> whole P a b p -> at_most_within P a b p U.
Proof.
  intros Hab [Hm [[->|He] Hb]] l Hnd Hl; [destruct Hb as [->|Hb]|].
  - apply motion_everywhere in Hm. apply (HU p Hm l Hnd). intros t Ht. now apply Hl.
  - assert (K := corner_bound _ 0 (out_of_corner_coll a p_infty p l Hab Hm Hb Hnd Hl) I). lia.
  - assert (K := corner_bound _ 0 (into_corner_coll a b p l Hab Hm He Hnd Hl) I). lia.
Qed.
Theorem stretch_few a b p : motion_within P a b p -> at_most_within P a b p U.
Proof.
  intros Hm [|t0 l] Hnd Hl; [simpl; lia|]. destruct (Hl t0 (or_introl eq_refl)) as [H0 _].
  destruct (whole_around P HP Hr1 a b p t0 Hm H0) as [a' [b' [q [Hq [A [B E]]]]]].
  assert (H0' := within_sub a' b' a b t0 A B H0). apply (whole_few a' b' q (within_ends _ _ _ H0') Hq (t0 :: l) Hnd).
  intros t Ht. destruct (Hl t Ht) as [W C]. split; [now apply within_sub with a b|].
  apply near_collision with p; [now apply within_near with a b | exact C].
Qed.
End Count.
