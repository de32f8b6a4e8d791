(** Theorem 1 (a) of theorem.md: N(q) = 2 + k0 + k1 for every q >= 1, where k0 and k1 count the collisions of two
    explicit rays (Orbits.v).

    theorem_1                  == Theorem 1 (a): N(q) = 2 + k0 + k1
    N_at_least                 == N(q) >= N, as a sentence about q and N
    odd_by_top, even_by_corner == N(q) >= 1 + 2 k if the top orbit has k collisions; 2 + 2 k by the corner orbit *)
From Coq Require Import Reals Lra Lia.
From Dumbbell Require Import Physics Ray Maximum Orbits UpperBound Attained.
Local Open Scope R_scope.

Theorem N_is_2_k0_k1 q k0 k1 : 1 <= q -> top_orbit q k0 -> corner_orbit q k1 -> N_star q (2 + k0 + k1).
Proof. intros Hq T C. split; [now apply at_most_2_k0_k1 | now apply at_least_2_k0_k1]. Qed.

(** In one sentence: the two counts exist, differ by one at most, and N(q) is 2 + k0 + k1 and nothing else. *)
Theorem theorem_1 q : 1 <= q -> exists k0 k1, top_orbit q k0 /\ corner_orbit q k1 /\ (k0 = k1 \/ k0 = S k1) /\
  forall n, N_star q n <-> n = (2 + k0 + k1)%nat.
Proof.
  intros Hq. destruct (orbits_exist q Hq) as [k0 [k1 [T C]]]. exists k0, k1. split; [exact T|]. split; [exact C|].
  split; [now apply (L21_counts q)|]. assert (H := N_is_2_k0_k1 q k0 k1 Hq T C). intros n. split.
  - intros Hn. apply (N_unique q); [lra | exact Hn | exact H].
  - intros ->. exact H.
Qed.

(** N(q) >= N, by the collisions of one orbit: the top orbit for odd N, the corner orbit for even N. *)
Definition N_at_least q N := exists n, N_star q n /\ (N <= n)%nat.
Theorem odd_by_top q k : 1 <= q -> N_at_least q (1 + 2 * k) <-> coll (/ q) k (/ q) 0.
Proof.
  intros Hq. destruct (theorem_1 q Hq) as [k0 [k1 [T [C [K HN]]]]]. split.
  - intros [n [Hn L]]. apply HN in Hn. apply coll_le with k0; [lia | apply T].
  - intros H. exists (2 + k0 + k1)%nat. split; [now apply HN|]. assert (A := exactly_max _ _ _ _ T k H). lia.
Qed.
Theorem even_by_corner q k : 1 <= q -> N_at_least q (2 + 2 * k) <-> coll (/ q) k (PI * / q) (/ q).
Proof.
  intros Hq. destruct (theorem_1 q Hq) as [k0 [k1 [T [C [K HN]]]]]. split.
  - intros [n [Hn L]]. apply HN in Hn. apply coll_le with k1; [lia | apply C].
  - intros H. exists (2 + k0 + k1)%nat. split; [now apply HN|]. assert (A := exactly_max _ _ _ _ C k H). lia.
Qed.
