(** L2 (c) with its number: fewer than q + 5 collisions; hence N(q) exists, and is unique (claim.md, "a maximum, not
    only a supremum"). No certificate is used.

    N_exists, N_unique == N(q) exists, below q + 5; there is only one *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Statement FewHits Chart Flight Scaling LightTotal WitnessMotion.
Local Open Scope R_scope.

Theorem L2c_below_q_plus_5 q n : 1 <= q -> q + 4 <= INR n -> upper_bound q n.
Proof.
  intros Hq Hn. assert (H1 := Rinv_0_lt_compat q ltac:(lra)).
  assert (H2 : / q <= 1) by (rewrite <- Rinv_1; apply Rinv_le_contravar; lra).
  assert (HPI : 0 < PI) by apply PI_RGT_0. assert (Hn' : / / q + 4 <= INR n) by (rewrite Rinv_inv; exact Hn).
  apply charts_upper; [exact Hq | |].
  - intros e eta a b He Heta _ Ca Cb. destruct (cos_range e ltac:(lra)) as [W0 W1].
    apply (L5f_few_both (/ q) a b n _ _ _ _ ltac:(lra) Hn') with (3 := Ca) (4 := Cb).
    + unfold lamX. assert (0 <= / q * (cos e + eta)) by (apply Rmult_le_pos; lra). lra.
    + assert (L := lamS_ge e eta (/ q) ltac:(lra) ltac:(lra) ltac:(lra)).
      assert (/ q * -1 <= / q * lamS e eta (/ q)) by (apply Rmult_le_compat_l; lra). lra.
  - intros e lam a b He Hlam _ HP _ _ Ca Cb Cb0. assert (L1 : 0 <= / q * lam) by (apply Rmult_le_pos; lra).
    destruct (Rlt_or_le 0 (mu_den (cos e) lam (/ q))) as [HD|HD].
    + apply (L5f_few_both (/ q) a b n _ _ _ _ ltac:(lra) Hn') with (3 := Ca) (4 := Cb HD); [lra|].
      assert (0 <= mu (cos e) lam (/ q))
        by (unfold mu; apply Rmult_le_pos; [exact HP | left; now apply Rinv_0_lt_compat]).
      assert (0 <= / q * mu (cos e) lam (/ q)) by (apply Rmult_le_pos; lra). lra.
    + apply (L5f_few_both (/ q) a b n (cL e (/ q * lam)) (/ q * lam) 0 0 ltac:(lra) Hn'); try lra;
        [exact Ca | rewrite (Cb0 HD); exact I].
Qed.

(* ---------- lists ---------- *)
Theorem N_unique q m n : 0 < q -> N_star q m -> N_star q n -> m = n.
Proof.
  assert (G : forall m n, 0 < q -> N_star q m -> N_star q n -> (m <= n)%nat).
  { clear m n. intros m n Hq [_ L] [U _]. destruct (unit_real q Hq) as [H1 H2].
    destruct (L _ H1 H2) as [p [Hm [l [A [B C]]]]]. rewrite <- B. exact (U _ p H1 H2 Hm l A C). }
  intros Hq H K. assert (A := G m n Hq H K). assert (B := G n m Hq K H). lia.
Qed.

(** N(q) exists. *)
Theorem N_exists q : 1 <= q -> exists n, N_star q n /\ INR n < q + 5.
Proof.
  intros Hq. assert (Up : exists m, INR m < q + 5 /\ upper_bound q m).
  { destruct (nfloor_ex (q + 4) ltac:(lra)) as [m Hm]. destruct (Req_dec (INR m) (q + 4)) as [E|E].
    - exists m. split; [lra | apply L2c_below_q_plus_5; lra].
    - exists (S m). rewrite S_INR. split; [lra | apply L2c_below_q_plus_5; [lra | rewrite S_INR; lra]]. }
  destruct Up as [m [Hm U]].
  assert (L : lower_bound q 0).
  { intros P HP Hqq. assert (HPI : 0 < PI) by apply PI_RGT_0. assert (R1 : r_of P <= 1).
    { replace (r_of P) with (/ q); [rewrite <- Rinv_1; apply Rinv_le_contravar; lra|]. unfold r_of.
      destruct HP as [? [? ?]]. rewrite <- Hqq. field. lra. }
    destruct (bridge_motion P HP R1 (PI/2) 1 O O ltac:(lra) ltac:(lra) I I) as [p [Hp Hl]]. exists p.
    split; [exact Hp|]. apply at_least_le with (2 := Hl). lia. }
  assert (G : forall k, upper_bound q k -> exists n, (n <= k)%nat /\ N_star q n).
  { induction k as [|k IH]; intros Hk.
    - exists O. split; [lia|]. now split.
    - destruct (Classical_Prop.classic (upper_bound q k)) as [K|K];
        [destruct (IH K) as [n [N1 N2]]; exists n; split; [lia | exact N2]|].
      exists (S k). split; [lia|]. split; [exact Hk|]. apply Classical_Prop.NNPP. intros NL. apply K.
      intros P p HP Hqq Hp l Hnd Hl.
      destruct (Nat.le_gt_cases (length l) k) as [|Q]; [assumption|]. exfalso. apply NL.
      apply (only_ratio q P p (S k) HP Hqq Hp).
      apply at_least_le with (length l); [lia|]. exists l. repeat split; assumption. }
  destruct (G _ U) as [n [N1 N2]]. exists n. split; [exact N2|]. apply le_INR in N1. lra.
Qed.
