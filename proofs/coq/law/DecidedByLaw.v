(** What is decided by the law (checker/ByLaw.v) is true, by L56 of law.md, for every real mass ratio of a claim's range.

    law_tells                 == N(q) >= n or not, as the law says
    by_law_true, by_law_false == what is found of a claim is so *)
From Coq Require Import Reals ZArith NArith Bool Lra Lia.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Real.Xreal Interval.Interval Float.Specific_ops Float.Specific_bigint.
From Dumbbell Require Import Statement Maximum ExactMaximum LawStatement Cubes CubesTail TheoremA AtRatio.
From Dumbbell Require Import Certificate Multiple Decide ByLaw Decided GrowthSeries.
Local Open Scope R_scope.
Module X := C.Y.X.

Section Enclosed.
Variable p : BigFloat.precision.
Lemma whole_in z : X.inI (IZR z) (whole p z).
Proof. exact (I.fromZ_correct p z). Qed.
Lemma fraction_in a b : X.inI (IZR a / IZR b) (fraction p a b).
Proof. apply X.div_in; apply whole_in. Qed.
Lemma value_in q : X.inI (ratio_value q) (value p q).
Proof. apply fraction_in. Qed.
Lemma ln_in x i : 0 < x -> X.inI x i -> X.inI (ln x) (I.ln p i).
Proof.
  intros Hx H. generalize (I.ln_correct p i (Xreal x) H). simpl. unfold Xln'.
  destruct (is_positive_spec x); [easy | lra].
Qed.
Lemma root_3_in : X.inI (sqrt 3) (root_3 p).
Proof. apply X.sqrt_in, whole_in. Qed.
Lemma half_pi_in : X.inI (PI / 2) (half_pi p).
Proof. apply X.div_in; [exact (I.pi_correct p) | apply whole_in]. Qed.

Lemma next_term i : sine_term (S i) = - (sine_term i * (PI / 2 * (PI / 2)) / IZR ((2 * Z.of_nat i + 2) * (2 *
  Z.of_nat i + 3))).
Proof.
  unfold sine_term. replace (2 * S i + 1)%nat with (S (S (2 * i + 1))) by lia. rewrite !fact_simpl, !mult_INR.
  rewrite mult_IZR, !plus_IZR, !mult_IZR, <- INR_IZR_INZ, !S_INR, plus_INR, mult_INR. cbn [pow].
  assert (F := INR_fact_neq_0 (2 * i + 1)). assert (N0 := pos_INR i). simpl (INR 2). simpl (INR 1). field.
  repeat split; lra.
Qed.
Lemma next_secants i : secants (S i) = (2 * 4 ^ i * sqrt 3 + IZR (2 * Z.of_nat i + 1) * secants i) / IZR (2 *
  Z.of_nat i + 2).
Proof.
  cbn [secants]. rewrite !plus_IZR, !mult_IZR, <- INR_IZR_INZ, !plus_INR, !mult_INR. simpl (INR 2). simpl (INR 1).
  reflexivity.
Qed.
Lemma sum_from_in square k : X.inI (PI / 2 * (PI / 2)) square -> forall i term sec power sum,
  X.inI (sine_term i) term -> X.inI (secants i) sec -> X.inI (2 * 4 ^ i * sqrt 3) power -> X.inI (growth_sum i) sum ->
  X.inI (growth_sum (i + k)) (sum_from p k (Z.of_nat i) square term sec power sum).
Proof.
  intros Hs. induction k as [|k IH]; intros i term sec power sum Ht Hc Hp Hsum; cbn [sum_from]; [now rewrite
    Nat.add_0_r|].
  replace (i + S k)%nat with (S i + k)%nat by lia. replace (Z.of_nat i + 1)%Z with (Z.of_nat (S i)) by lia.
  assert (T : X.inI (sine_term (S i)) (I.neg (I.div p (I.mul p term square)
    (whole p ((2 * Z.of_nat i + 2) * (2 * Z.of_nat i + 3)))))).
  { rewrite next_term. apply X.neg_in, X.div_in; [now apply X.mul_in | apply whole_in]. }
  assert (K : X.inI (secants (S i)) (I.div p (I.add p power (I.mul p (whole p (2 * Z.of_nat i + 1)) sec))
    (whole p (2 * Z.of_nat i + 2)))).
  { rewrite next_secants. apply X.div_in; [|apply whole_in]. apply X.add_in; [exact Hp|].
  apply X.mul_in; [apply whole_in | exact Hc]. }
  apply IH; [exact T | exact K | |].
  - replace (2 * 4 ^ S i * sqrt 3) with (4 * (2 * 4 ^ i * sqrt 3)) by (simpl; ring).
  apply X.mul_in; [apply whole_in | exact Hp].
  - unfold growth_sum. cbn [sum_f_R0]. apply X.add_in; [exact Hsum | now apply X.mul_in].
Qed.
Lemma partial_sum_in k : X.inI (growth_sum k) (partial_sum p k).
Proof.
  assert (S3 := sqrt_lt_R0 3 ltac:(lra)).
  assert (L : X.inI (secants 0) (I.ln p (I.add p (whole p 2) (root_3 p)))).
  { apply ln_in; [lra|]. apply X.add_in; [apply whole_in | apply root_3_in]. }
  assert (T : sine_term 0 = PI / 2) by (unfold sine_term; simpl; field).
  change k with (0 + k)%nat at 1. apply (sum_from_in _ k (X.mul_in p _ _ _ _ half_pi_in half_pi_in) 0).
  - rewrite T. exact half_pi_in.
  - exact L.
  - simpl pow. rewrite Rmult_1_r. apply X.mul2_in, root_3_in.
  - unfold growth_sum. cbn [sum_f_R0]. rewrite T. apply X.mul_in; [exact half_pi_in | exact L].
Qed.

(** Two numbers beside c0. *)
Lemma cubes_from_in k : forall i root sum, X.inI (sqrt (INR (S i))) root -> X.inI (sum_n cube i) sum ->
  X.inI (sum_n cube (i + k)) (cubes_from p k (Z.of_nat i) root sum).
Proof.
  induction k as [|k IH]; intros i root sum Hr Hs; cbn [cubes_from]; [now rewrite Nat.add_0_r|].
  replace (i + S k)%nat with (S i + k)%nat by lia. replace (Z.of_nat i + 1)%Z with (Z.of_nat (S i)) by lia.
  assert (R : X.inI (sqrt (INR (S (S i)))) (I.sqrt p (whole p (Z.of_nat i + 2)))).
  { replace (INR (S (S i))) with (IZR (Z.of_nat i + 2)) by (rewrite INR_IZR_INZ; f_equal; lia).
  apply X.sqrt_in, whole_in. }
  apply IH; [exact R|]. rewrite sum_Sn. apply X.add_in; [exact Hs|]. unfold cube.
  replace ((sqrt (INR (S (S i))) - sqrt (INR (S i))) ^ 3) with ((sqrt (INR (S (S i))) - sqrt (INR (S i))) *
    ((sqrt (INR (S (S i))) - sqrt (INR (S i))) * (sqrt (INR (S (S i))) - sqrt (INR (S i))))) by ring.
  repeat apply X.mul_in; now apply X.sub_in.
Qed.
Lemma cubes_in m : X.inI (sum_n cube m) (cubes p m).
Proof.
  apply (cubes_from_in m 0).
  - simpl. rewrite sqrt_1. apply whole_in.
  - rewrite sum_O. unfold cube. simpl INR. rewrite sqrt_0, sqrt_1. replace ((1 - 0) ^ 3) with 1 by ring. apply whole_in.
Qed.
Definition correction_at (m : nat) (t : R) := 2 * step_constant * (sum_n cube m + rest m * t).
Lemma correction_in m sum t i : X.inI (sum_n cube m) sum -> X.inI t i -> X.inI (correction_at m t) (correction p m
  sum i).
Proof.
  intros Hs Ht. assert (S3 := sqrt_lt_R0 3 ltac:(lra)). assert (S4 := sqrt_lt_R0 _ S3).
  assert (SP := sqrt_lt_R0 PI PI_RGT_0).
  assert (M : 0 < sqrt (INR (S m))) by (apply sqrt_lt_R0, lt_0_INR; lia).
  unfold correction_at, correction. apply X.mul_in.
  - rewrite step_constant_is. apply X.div_in; [apply whole_in|].
    apply X.mul_in; [apply X.mul_in; [apply whole_in | apply X.mul_in; [|apply X.sqrt_in]; apply root_3_in] | apply
      X.sqrt_in; exact (I.pi_correct p)].
  - apply X.add_in; [exact Hs|]. apply X.mul_in; [|exact Ht]. unfold rest. apply X.inv_in; [lra|].
    apply X.mul_in; [apply whole_in|]. apply X.sqrt_in.
    replace (INR (S m)) with (IZR (Z.of_nat m + 1)) by (rewrite INR_IZR_INZ; f_equal; lia). apply whole_in.
Qed.
Lemma least_share_in m : X.inI (share m) (least_share p m).
Proof.
  unfold share, least_share. apply X.sub_in; [apply whole_in|].
  replace (/ (16 * (INR (S m) * INR (S m)))) with (IZR 1 / IZR (16 * ((Z.of_nat m + 1) * (Z.of_nat m + 1)))); [apply
    fraction_in|].
  rewrite !mult_IZR, plus_IZR, <- INR_IZR_INZ, S_INR. unfold Rdiv. ring.
Qed.

(** What a side encloses. *)
Definition side_at (sign c0 : R) (n : N) (q : R) := let s := quarter q in
  c0 * s - s^2 * (log_constant * ln q + (constant_of (N.to_nat n) - sign * (0.072 + 2.6 * s))).
Lemma side_in sign c0 i n q : 1 <= ratio_value q -> X.inI c0 i ->
  X.inI (side_at (IZR sign) c0 n (ratio_value q)) (side p sign i (N.even n) q).
Proof.
  intros Hq Hi. set (x := ratio_value q) in *. assert (S0 : 0 < sqrt x) by (apply sqrt_lt_R0; lra).
  assert (S3 := sqrt_lt_R0 3 ltac:(lra)).
  assert (I2 : X.inI (quarter x ^ 2) (I.inv p (I.sqrt p (value p q)))).
  { rewrite quarter_square by lra. apply X.inv_in; [lra | apply X.sqrt_in, value_in]. }
  assert (I1 : X.inI (quarter x) (I.sqrt p (I.inv p (I.sqrt p (value p q))))).
  { replace (quarter x) with (sqrt (quarter x ^ 2)) by (apply sqrt_pow2; left; apply Rinv_0_lt_compat, sqrt_lt_R0, S0).
    apply X.sqrt_in, I2. }
  unfold side_at, side. apply X.sub_in; [apply X.mul_in; [exact Hi | exact I1]|].
  apply X.mul_in; [exact I2|]. apply X.add_in.
  - apply X.mul_in; [|apply ln_in; [lra | apply value_in]]. unfold log_constant. apply X.div_in; [apply whole_in|].
    apply X.mul_in; [apply X.mul_in; [apply whole_in | apply root_3_in] | exact (I.pi_correct p)].
  - apply X.sub_in.
    + replace (constant_of (N.to_nat n)) with (IZR (if N.even n then 497 else 380) / IZR 1000); [apply fraction_in|].
      unfold constant_of. replace (Nat.even (N.to_nat n)) with (N.even n); [destruct (N.even n); lra|].
      apply eq_iff_eq_true. rewrite N.even_spec, Nat.even_spec.
      split; intros [m E]; [exists (N.to_nat m) | exists (N.of_nat m)]; lia.
    + apply X.mul_in; [apply whole_in|]. apply X.add_in.
      * replace 0.072 with (IZR 72 / IZR 1000) by lra. apply fraction_in.
      * replace 2.6 with (IZR 26 / IZR 10) by lra. apply X.mul_in; [apply fraction_in | exact I1].
Qed.
End Enclosed.
Lemma correction_between m : correction_at m (share m) <= law_constant <= correction_at m 1.
Proof.
  unfold correction_at, law_constant. destruct (tail_close m) as [A B]. rewrite Rmult_1_r.
  assert (K : 0 < step_constant).
  { rewrite step_constant_is. assert (S3 := sqrt_lt_R0 3 ltac:(lra)). assert (S4 := sqrt_lt_R0 _ S3).
    assert (SP := sqrt_lt_R0 PI PI_RGT_0). apply Rinv_0_lt_compat. repeat apply Rmult_lt_0_compat; lra. }
  split; apply Rmult_le_compat_l; lra.
Qed.

Lemma with_tells p few k mm q n yes : 1 <= ratio_value q -> reaches_with p few k mm q n = Some yes ->
  yes = true <-> N_at_least (ratio_value q) (N.to_nat n).
Proof.
  intros Hq. unfold reaches_with. destruct (N.ltb_spec n 903) as [L|L]; [easy|]. set (x := ratio_value q) in *.
  destruct (N_exists x Hq) as [m [Hm _]].
  destruct (L56_late (N.to_nat n) x m ltac:(lia) Hq Hm) as [A B]. cbv zeta in A, B.
  assert (S0 : 0 <= sqrt x) by apply sqrt_pos.
  assert (Q0 : 0 < quarter x) by (apply Rinv_0_lt_compat, sqrt_lt_R0, sqrt_lt_R0; lra).
  destruct (correction_between mm) as [C1 C2].
  set (low := correction_at mm (share mm)) in *. set (high := correction_at mm 1) in *. assert (G := growth_between k).
  assert (E : IZR (Z.of_N n - 2) = INR (N.to_nat n) - 2) by (rewrite minus_IZR, INR_IZR_INZ, N_nat_Z; reflexivity).
  assert (Place : forall j, X.inI (growth_sum j * sqrt x - (INR (N.to_nat n) - 2)) (place p j q n)).
  { intros j. rewrite <- E. apply X.sub_in; [|apply whole_in].
  apply X.mul_in; [apply partial_sum_in | apply X.sqrt_in, value_in]. }
  assert (Low : law_constant * quarter x <= high * quarter x) by (apply Rmult_le_compat_r; lra).
  assert (High : low * quarter x <= law_constant * quarter x) by (apply Rmult_le_compat_r; lra).
  unfold delta in A, B. set (r := sqrt x) in *. set (s := quarter x) in *.
  set (kappa := log_constant * s^2 * ln x) in *. set (e := constant_of (N.to_nat n)) in *.
  destruct (C.pos _) eqn:P.
  { apply (C.pos_ok (growth_sum (2 * k + 1) * r - (INR (N.to_nat n) - 2) - side_at 1 high n x)) in P;
      [|apply X.sub_in; [apply Place | apply (side_in few 1); [exact Hq | apply correction_in; [apply cubes_in |
        apply whole_in]]]].
    unfold side_at in P. fold s e in P.
    assert (Gr : growth_sum (2 * k + 1) * r <= growth * r) by (apply Rmult_le_compat_r; lra).
    intros H. injection H; intros <-. split; [|easy]. intros _. exists m. split; [exact Hm|]. apply A.
    replace (s^2 * (log_constant * ln x + (e - 1 * (0.072 + 2.6 * s)))) with
      (kappa + e * s^2 - (0.072 + 2.6 * s) * s^2) in P by (unfold kappa; ring). lra. }
  destruct (C.nonneg _) eqn:M; [|easy].
  apply (C.nonneg_ok (side_at (-1) low n x - (growth_sum (2 * (k + 1)) * r - (INR (N.to_nat n) - 2)))) in M;
    [|apply X.sub_in; [apply (side_in few (-1)); [exact Hq | apply correction_in; [apply cubes_in | apply
      least_share_in]] | apply Place]].
  unfold side_at in M. fold s e in M.
  assert (Gr : growth * r <= growth_sum (2 * (k + 1)) * r) by (apply Rmult_le_compat_r; lra).
  intros H. injection H; intros <-. split; [easy|]. intros [j [Hj J]]. exfalso.
  rewrite (N_unique x j m ltac:(lra) Hj Hm) in J. apply Nat.le_ngt in J. apply J, B.
  replace (s^2 * (log_constant * ln x + (e - -1 * (0.072 + 2.6 * s)))) with
    (kappa + e * s^2 + (0.072 + 2.6 * s) * s^2) in M by (unfold kappa; ring). lra.
Qed.
Theorem law_tells q n yes : 1 <= ratio_value q -> law_reaches q n = Some yes ->
  yes = true <-> N_at_least (ratio_value q) (N.to_nat n).
Proof. apply with_tells. Qed.

Lemma tried_ok q n wanted : 1 <= ratio_value q ->
  match tried q n wanted with
  | Holds => wanted = true <-> N_at_least (ratio_value q) (N.to_nat n)
  | Fails q' n' reached => q' = q /\ n' = n /\ reached = negb wanted /\ (reached = true <-> N_at_least (ratio_value
    q) (N.to_nat n))
  | Unknown => True
  end.
Proof.
  intros Hq. unfold tried, either.
  assert (T : forall b, (if law_reaches q n then law_reaches q n else option_map snd (decide q n)) = Some b ->
    b = true <-> N_at_least (ratio_value q) (N.to_nat n)).
  { intros b. destruct (law_reaches q n) as [y|] eqn:E; [intros H; injection H; intros <-; now apply law_tells|].
    destruct (decide q n) as [[w y]|] eqn:D; [|easy]. intros H. injection H; intros <-.
    apply (answers_ok w q n y Hq). now apply decide_ok. }
  destruct (law_reaches q n) as [b|]; [|destruct (option_map snd (decide q n)) as [b|]; [|easy]];
    specialize (T b eq_refl); destruct b, wanted; cbn; now repeat split; apply T.
Qed.

Theorem by_law_true c : by_law c = Holds -> says c.
Proof.
  unfold by_law. destruct (proper_range c) eqn:P; [|easy]. apply proper_ok in P. cbn [negb]. intros H q [Q1 Q2].
  assert (Most : forall n, claimed_most c = Some n -> tried (claimed_to c) (N.succ n) false = Holds).
  { intros n E. rewrite E in H. now destruct (tried _ (N.succ n) false). }
  assert (Least : forall n, claimed_least c = Some n -> tried (claimed_from c) n true = Holds).
  { intros n E. rewrite E in H. destruct (claimed_most c); [destruct (tried _ _ false)|]; easy. }
  split; intros n E.
  - assert (T := tried_ok (claimed_to c) (N.succ n) false ltac:(lra)). rewrite (Most n E), N2Nat.inj_succ in T.
    apply below_the_end with (ratio_value (claimed_to c)); [lra|]. intros K. now apply T in K.
  - assert (T := tried_ok (claimed_from c) n true ltac:(lra)). rewrite (Least n E) in T.
    apply above_the_end with (ratio_value (claimed_from c)); [lra|]. now apply T.
Qed.
Theorem by_law_false c q n reached : by_law c = Fails q n reached -> in_range c (ratio_value q) /\
  if reached then N_at_least (ratio_value q) (N.to_nat n) /\ exists m, claimed_most c = Some m /\ (m < n)%N
  else claimed_least c = Some n /\ ~ N_at_least (ratio_value q) (N.to_nat n).
Proof.
  unfold by_law, in_range. destruct (proper_range c) eqn:P; [|easy]. apply proper_ok in P. cbn [negb].
  assert (K : match claimed_least c with None => Holds | Some n => tried (claimed_from c) n true end = Fails q n
    reached ->
    q = claimed_from c /\ reached = false /\ claimed_least c = Some n /\ ~ N_at_least (ratio_value q) (N.to_nat n)).
  { destruct (claimed_least c) as [l|]; [|easy]. assert (T := tried_ok (claimed_from c) l true ltac:(lra)).
    intros H. rewrite H in T. destruct T as [-> [-> [-> T]]]. repeat split. intros N. now apply T in N. }
  destruct (claimed_most c) as [m|].
  - assert (T := tried_ok (claimed_to c) (N.succ m) false ltac:(lra)). destruct (tried _ (N.succ m) false) eqn:E.
    + intros H. destruct (K H) as [-> [-> [A B]]]. split; [lra | now split].
    + intros H. injection H; intros; subst. destruct T as [-> [-> [-> T]]]. split; [lra|]. split; [now apply T|].
      exists m. split; [easy | lia].
    + easy.
  - intros H. destruct (K H) as [-> [-> [A B]]]. split; [lra | now split].
Qed.
