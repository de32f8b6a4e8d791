(** (C1) to (C4) of law.md hold, the conditions about the critical ratios up to N = 902: inequalities of
    C sqrt q - (N - 2) at ratios on either side of q_c(N). At each N two ratios are made from the inequalities, and one
    orbit at each of them, in doubles, shows that N(q) is less than N at the one, and not at the other.

    steps_hold == the conditions `steps` *)
From Coq Require Import Reals Lra Lia ZArith NArith List Bool.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Dumbbell Require Import Statement Maximum Certificate Decide ExactMaximum Decided LawStatement Cubes.
Local Open Scope R_scope.

Lemma growth_digits : 8855951/10000000 < growth < 8855952/10000000.
Proof. unfold growth. split; integral with (i_relwidth 28, i_fuel 500, i_degree 12). Qed.
Lemma law_constant_digits : 2046/10000 < law_constant.
Proof.
  assert (S : 1.241 < Series cube).
  { assert (H := tail_above 8). apply Rlt_le_trans with (2 := H). rewrite !sum_Sn, sum_O. change plus with Rplus.
    unfold cube. simpl INR. rewrite sqrt_0, sqrt_1. interval. }
  assert (K : 0.0825 < step_constant) by (unfold step_constant, Rpower; interval). unfold law_constant.
  apply Rlt_trans with (2 * 0.0825 * 1.241); [lra|]. apply Rmult_gt_0_lt_compat; lra.
Qed.

Lemma root_above c x a : 0 < c -> 0 <= x -> 0 <= a -> x * x < c * c * a -> x < c * sqrt a.
Proof.
  intros Hc Hx Ha H. apply Rnot_le_lt. intros L. rewrite <- (sqrt_sqrt a Ha) in H. assert (P := sqrt_pos a).
  assert (c * sqrt a * (c * sqrt a) <= x * x) by (apply Rmult_le_compat; try apply Rmult_le_pos; lra). lra.
Qed.
Lemma root_below c y b : 0 < c -> 0 <= y -> 0 <= b -> c * c * b <= y * y -> c * sqrt b <= y.
Proof.
  intros Hc Hy Hb H. apply Rnot_lt_le. intros L. rewrite <- (sqrt_sqrt b Hb) in H.
  assert (y * y < c * sqrt b * (c * sqrt b)) by (apply Rmult_le_0_lt_compat; lra). lra.
Qed.
Lemma quarter_above t b : 0 < t -> 0 < b -> t * t * (t * t) * b <= 1 -> t <= quarter b.
Proof.
  intros Ht Hb H. assert (S := sqrt_lt_R0 b Hb). set (s := sqrt (sqrt b)). assert (P : 0 < s) by (now apply sqrt_lt_R0).
  assert (E : s * s * (s * s) = b) by (unfold s; now rewrite !sqrt_sqrt by lra).
  unfold quarter. fold s. apply Rmult_le_reg_r with s; [exact P|]. rewrite Rinv_l by lra. apply Rnot_lt_le. intros L.
  assert (1 * 1 < t * s * (t * s)) by (apply Rmult_le_0_lt_compat; lra).
  assert (1 * 1 * (1 * 1) < t * s * (t * s) * (t * s * (t * s))) by (apply Rmult_le_0_lt_compat; lra).
  rewrite <- E in H. lra.
Qed.

(** All in millionths: between which values C sqrt q is to be, the two ratios, and something below q^(-1/4). How they
    are found does not matter: [right] computes what is needed of them. *)
Local Open Scope Z_scope.
Definition thin (N : Z) : Z := Z.sqrt (8855951 * 10^11 / ((N - 2) * 1000000 + 20000)).
Definition least (N : Z) : Z := (N - 2) * 1000000 + if N <? 9 then -115000 else 0.
Definition most (N : Z) : Z := (N - 2) * 1000000 + if N <? 9 then 20000 else Z.min 20000 (2046 * thin N / 10000).
Definition lower_ratio (N : Z) : Z := Z.max 1000000 (least N * least N * 10^8 / (8855951 * 8855951) + 1).
Definition upper_ratio (N : Z) : Z := most N * most N * 10^8 / (8855952 * 8855952).

Definition millionths (a : Z) : ratio := {| num := Z.to_pos a; den := 1000000 |}.
Definition good (N m x y a b t : Z) : bool :=
  (0 <=? x) && (m - 115000 <=? x) && (x * x * 100000000 <? 8855951 * 8855951 * a) &&
  (0 <=? y) && (y <=? m + 20000) && (8855952 * 8855952 * b <=? y * y * 100000000) &&
  ((N <? 9) || (m <=? x) && (0 <? t) && (t * t * (t * t) * b <=? 10^30) && ((y - m) * 10000 <=? 2046 * t)).
Definition right (N : Z) : bool :=
  let a := lower_ratio N in let b := upper_ratio N in
  good N ((N - 2) * 1000000) (least N) (most N) a b (thin N) && (1000000 <=? a) && (1000000 <=? b) &&
  answers Machine_doubles (millionths a) (Z.to_N N) false && answers Machine_doubles (millionths b) (Z.to_N N) true.
Lemma all_right : forallb (fun k => right (Z.of_nat k)) (seq 3 900) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Local Open Scope R_scope.
Lemma millionths_value a : (1000000 <= a)%Z ->
  1 <= ratio_value (millionths a) /\ ratio_value (millionths a) = IZR a / 1000000.
Proof.
  intros H. assert (E : ratio_value (millionths a) = IZR a / 1000000).
  { unfold ratio_value; simpl. now rewrite Z2Pos.id by lia. }
  rewrite E. apply IZR_le in H. split; lra.
Qed.
Ltac in_reals H := repeat rewrite ?plus_IZR, ?minus_IZR, ?mult_IZR in H; rewrite <- ?INR_IZR_INZ in H.
(** What is computed in millionths says of the ratios a and b. *)
Lemma good_ok N x y a b t : good (Z.of_nat N) ((Z.of_nat N - 2) * 1000000) x y a b t = true ->
  (1000000 <= a)%Z -> (1000000 <= b)%Z ->
  let A := IZR a / 1000000 in let B := IZR b / 1000000 in
  ((9 <= N)%nat -> INR N - 2 < growth * sqrt A /\ growth * sqrt B - (INR N - 2) < law_constant * quarter B) /\
  -0.115 <= growth * sqrt A - (INR N - 2) /\ growth * sqrt B - (INR N - 2) <= 0.020.
Proof.
  intros H HA HB A B. unfold good in H. rewrite !andb_true_iff, !Z.leb_le, Z.ltb_lt in H.
  destruct H as [[[[[[X0 X1] X2] Y0] Y1] Y2] Z1].
  apply IZR_le in X0, X1, Y0, Y1, Y2, HA, HB. apply IZR_lt in X2.
  in_reals X1. in_reals X2. in_reals Y1. in_reals Y2.
  destruct growth_digits as [G1 G2]. assert (G : 0 < growth) by lra. assert (L := law_constant_digits).
  assert (PA := sqrt_pos A). assert (PB := sqrt_pos B).
  assert (R1 : IZR x / 1000000 < 8855951/10000000 * sqrt A) by (apply root_above; unfold A; lra).
  assert (R2 : 8855952/10000000 * sqrt B <= IZR y / 1000000) by (apply root_below; unfold B; lra).
  assert (S1 : 8855951/10000000 * sqrt A <= growth * sqrt A) by (apply Rmult_le_compat_r; lra).
  assert (S2 : growth * sqrt B <= 8855952/10000000 * sqrt B) by (apply Rmult_le_compat_r; lra).
  split; [|lra]. intros H9. destruct (Z.ltb_spec (Z.of_nat N) 9) as [K|_]; [lia|]. cbn [orb] in Z1.
  rewrite !andb_true_iff, !Z.leb_le, Z.ltb_lt in Z1. destruct Z1 as [[[M1 T0] T1] T2].
  change (10^30)%Z with (1000000 * 1000000 * (1000000 * 1000000) * 1000000)%Z in T1.
  apply IZR_le in M1, T1, T2. apply IZR_lt in T0. in_reals M1. in_reals T1. in_reals T2.
  split; [lra|]. assert (Q : IZR t / 1000000 <= quarter B) by (apply quarter_above; unfold B; lra).
  assert (2046/10000 * (IZR t / 1000000) <= 2046/10000 * quarter B) by (apply Rmult_le_compat_l; lra).
  assert (2046/10000 * quarter B < law_constant * quarter B) by (apply Rmult_lt_compat_r; lra). lra.
Qed.

Theorem steps_hold : steps.
Proof.
  intros N HN. assert (H := proj1 (forallb_forall _ _) all_right N ltac:(apply in_seq; lia)). unfold right in H.
  rewrite !andb_true_iff, !Z.leb_le in H. destruct H as [[[[G A1] B1] A2] B2].
  destruct (good_ok N _ _ _ _ _ G A1 B1) as [C1 C2]. destruct (millionths_value _ A1) as [A3 A4].
  destruct (millionths_value _ B1) as [B3 B4]. apply answers_ok in A2; [|exact A3]. apply answers_ok in B2; [|exact B3].
  rewrite Z_N_nat, Nat2Z.id in A2, B2. rewrite A4 in A2, A3. rewrite B4 in B2, B3.
  eexists; eexists. split; [exact A3|]. split; [exact B3|]. split; [|split; [|now split]].
  - intros n Hn. apply Nat.nle_gt. intros L. enough (false = true) by easy. apply A2. now exists n.
  - intros n Hn. destruct (proj1 B2 eq_refl) as [m [Hm L]].
    now rewrite (N_unique _ n m (Rlt_le_trans _ _ _ Rlt_0_1 B3) Hn Hm).
Qed.
