(** What is decided without a certificate (checker/Decide.v) is true, for every real mass ratio of the range: by
    Theorem 1, as counts of one orbit, and by Theorem 2 (a), as N grows with q; or by Theorem 3 (c), which bounds N.

    decided_by_orbits, found_true, found_false == what is computed of a claim is true
    reaches_sound, answers_ok                == N(q) >= n or not, as one orbit says
    says, in_range                           == what a claim says, of which ratios *)
From Coq Require Import Reals ZArith NArith Bool Lra Lia.
From Dumbbell Require Import Physics Maximum EqualMasses Range Orbits ExactMaximum Monotone ExplicitBounds.
From Dumbbell Require Import Certificate Leaves TwoOrbits Doubles Multiple Check Decide.
Local Open Scope R_scope.

Lemma one_le q : ratio_le one q = true -> 1 <= ratio_value q.
Proof. intros H. apply ratio_le_ok in H. unfold ratio_value in H at 1. simpl in H. lra. Qed.

(** The counts of an orbit are those of the exact one, with any kind of numbers. *)
Lemma at_most_with_sound w o n q : 1 <= ratio_value q -> at_most_with w o n q = true ->
  forall m, collides o m (/ ratio_value q) -> (m <= n)%nat.
Proof.
  intros Hq. destruct w as [|b]; cbn [at_most_with].
  - exact (D.orbit_at_most_sound p53 Doubles.G doubles eq_refl q Hq o n).
  - set (p := precision b). exact (M.orbit_at_most_sound p (Multiple.G p) (M.Z.mkconsts p) eq_refl q Hq o n).
Qed.
Lemma at_least_with_sound w o n q : 1 <= ratio_value q -> at_least_with w o n q = true ->
  collides o n (/ ratio_value q).
Proof.
  intros Hq. destruct w as [|b]; cbn [at_least_with].
  - exact (D.orbit_at_least_sound p53 Doubles.G doubles eq_refl q Hq o n).
  - set (p := precision b). exact (M.orbit_at_least_sound p (Multiple.G p) (M.Z.mkconsts p) eq_refl q Hq o n).
Qed.

(** N(q) >= n is a question about one orbit. *)
Lemma one_orbit q n : 1 <= q -> (1 <= n)%N ->
  N_at_least q (N.to_nat n) <-> collides (orbit_for n) (N.to_nat (collisions_for n)) (/ q).
Proof.
  intros Hq Hn. unfold orbit_for, collisions_for, collides, first_height, first_slope.
  assert (E := N.div2_odd (N.pred n)).
  assert (P : N.odd (N.pred n) = N.even n) by (rewrite <- N.even_succ, N.succ_pred by lia; reflexivity).
  rewrite P in E. destruct (N.even n); cbn [N.b2n] in E.
  - replace (N.to_nat n) with (2 + 2 * N.to_nat (N.div2 (N.pred n)))%nat by lia. now apply even_by_corner.
  - replace (N.to_nat n) with (1 + 2 * N.to_nat (N.div2 (N.pred n)))%nat by lia. now apply odd_by_top.
Qed.
Lemma at_least_two q n : 1 <= q -> (n <= 2)%nat -> N_at_least q n.
Proof.
  intros Hq Hn. destruct (proj2 (even_by_corner q 0 Hq) I) as [m [Hm L]]. exists m. split; [exact Hm | lia].
Qed.
Lemma fuel_is k : (k <= most_steps)%N -> fuel k = N.to_nat k.
Proof. intros H. unfold fuel. now rewrite N.min_l. Qed.

Lemma far_above_ok q n : 1 <= ratio_value q -> (2 < n)%N -> far_above q n = true -> ~ N_at_least (ratio_value q) (N.to_nat n).
Proof.
  unfold far_above. intros Hq Hn H [m [Hm L]]. apply N.leb_le in H. assert (B := theorem_3c _ m Hq Hm). apply le_INR in L.
  set (d := (n - 2)%N) in *. assert (E : INR (N.to_nat n) = 2 + IZR (Z.of_N d)).
  { replace (N.to_nat n) with (2 + N.to_nat d)%nat by lia. rewrite plus_INR, INR_IZR_INZ, INR_IZR_INZ, N_nat_Z. reflexivity. }
  assert (D : 0 <= IZR (Z.of_N d)) by (apply IZR_le; lia). set (x := IZR (Z.of_N d)) in *.
  assert (K : 4 * ratio_value q <= 3 * (x * x)).
  { unfold ratio_value. assert (P : 0 < IZR (Zpos (den q))) by (apply IZR_lt; easy).
    assert (Z1 : (4 * Zpos (num q) <= 3 * Zpos (den q) * (Z.of_N d * Z.of_N d))%Z) by lia.
    apply IZR_le in Z1. rewrite !mult_IZR in Z1. fold x in Z1. apply Rmult_le_reg_r with (IZR (Zpos (den q))); [exact P|].
    replace (4 * (IZR (Zpos (num q)) / IZR (Zpos (den q))) * IZR (Zpos (den q))) with (4 * IZR (Zpos (num q))) by (field; lra).
    lra. }
  assert (HPI := PI2_3_2). assert (S : sqrt (ratio_value q / PI) <= x / 2); [|lra].
  rewrite <- (sqrt_square (x / 2)) by lra. apply sqrt_le_1_alt. apply Rmult_le_reg_r with PI; [lra|].
  unfold Rdiv at 1. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
  assert (3 * (x / 2 * (x / 2)) <= PI * (x / 2 * (x / 2))) by (apply Rmult_le_compat_r; [apply Rle_0_sqr | lra]). lra.
Qed.

Theorem reaches_sound w q n yes : 1 <= ratio_value q -> reaches w q n = Some yes ->
  yes = true <-> N_at_least (ratio_value q) (N.to_nat n).
Proof.
  intros Hq. unfold reaches. destruct (N.leb_spec n 2) as [L|L].
  { intros H. injection H; intros <-. split; [|easy]. intros _. apply at_least_two; [exact Hq | lia]. }
  destruct (ratio_eq q one) eqn:E; cbn [orb].
  { intros H. injection H; intros <-. split; [easy|]. intros [m [Hm Hnm]]. exfalso. apply ratio_eq_ok in E.
    assert (E1 : ratio_value q = 1) by (rewrite E; unfold ratio_value; simpl; lra). rewrite E1 in Hm.
    assert (m = 2%nat) by (apply (N_unique 1); [lra | exact Hm | exact L7_equal_masses]). lia. }
  destruct (far_above q n) eqn:FA.
  { intros H. injection H; intros <-. split; [easy|]. intros K. now apply far_above_ok in K. }
  destruct (N.ltb_spec most_steps (collisions_for n)) as [F|F]; [easy|].
  assert (K : (1 <= collisions_for n)%N).
  { unfold collisions_for. assert (E2 := N.div2_odd (N.pred n)). destruct (N.odd (N.pred n)); cbn [N.b2n] in E2; lia. }
  assert (O := one_orbit (ratio_value q) n Hq ltac:(lia)). rewrite !fuel_is by lia.
  destruct (at_least_with w _ _ q) eqn:A.
  { intros H. injection H; intros <-. split; [|easy]. intros _. apply O, (at_least_with_sound w); assumption. }
  destruct (at_most_with w _ _ q) eqn:B; [|easy]. intros H. injection H; intros <-. split; [easy|]. intros Hn. exfalso.
  apply O in Hn. apply (at_most_with_sound w _ _ q Hq B) in Hn. lia.
Qed.

(** One end of the range is enough for each bound. *)
Lemma below_the_end q b n : 1 <= q <= b -> ~ N_at_least b (S n) -> upper_bound q n.
Proof.
  intros Hq H. destruct (N_exists q ltac:(lra)) as [m [Hm _]]. destruct (N_exists b ltac:(lra)) as [k [Hk _]].
  assert (M := N_monotone q b m k ltac:(lra) ltac:(lra) Hm Hk). apply upper_le with m; [|apply Hm].
  apply Nat.nlt_ge. intros L. apply H. exists k. split; [exact Hk | lia].
Qed.
Lemma above_the_end q a n : 1 <= a <= q -> N_at_least a n -> lower_bound q n.
Proof.
  intros Hq [k [Hk L]]. destruct (N_exists q ltac:(lra)) as [m [Hm _]].
  assert (M := N_monotone a q k m ltac:(lra) ltac:(lra) Hk Hm). apply lower_le with m; [lia | apply Hm].
Qed.

(** What a claim says: each bound that it has holds at every real mass ratio of its range. *)
Definition in_range (c : claim) (q : R) := ratio_value (claimed_from c) <= q <= ratio_value (claimed_to c).
Definition says (c : claim) := forall q, in_range c q ->
  (forall n, claimed_most c = Some n -> upper_bound q (N.to_nat n)) /\
  (forall n, claimed_least c = Some n -> lower_bound q (N.to_nat n)).

Lemma proper_ok c : proper_range c = true -> 1 <= ratio_value (claimed_from c) <= ratio_value (claimed_to c).
Proof.
  unfold proper_range. intros H. apply andb_prop in H. destruct H. split; [now apply one_le | now apply ratio_le_ok].
Qed.
Lemma answers_ok w q n yes : 1 <= ratio_value q -> answers w q n yes = true ->
  yes = true <-> N_at_least (ratio_value q) (N.to_nat n).
Proof.
  unfold answers. intros Hq H. destruct (reaches w q n) as [b|] eqn:E; [|easy]. apply eqb_prop in H. subst b.
  now apply (reaches_sound w).
Qed.
Theorem decided_by_orbits v w c : holds v w c = true -> says c.
Proof.
  unfold holds. intros H q [Q1 Q2]. apply andb_prop in H. destruct H as [H L]. apply andb_prop in H. destruct H as [H U].
  apply proper_ok in H. split; intros n E; rewrite E in *.
  - apply below_the_end with (ratio_value (claimed_to c)); [lra|]. apply answers_ok in U; [|lra].
    rewrite N2Nat.inj_succ in U. intros K. now apply U in K.
  - apply above_the_end with (ratio_value (claimed_from c)); [lra|]. apply answers_ok in L; [|lra]. now apply L.
Qed.

(** The extracted search answers nothing else: what it finds true is so, and what it finds false breaks the claim. *)
Lemma decide_ok q n w yes : decide q n = Some (w, yes) -> answers w q n yes = true.
Proof.
  unfold decide. induction (attempts n) as [|x l IH]; simpl; [easy|]. destruct (reaches x q n) as [b|] eqn:E; [|exact IH].
  intros H. injection H; intros -> ->. unfold answers. rewrite E. apply eqb_reflx.
Qed.
Theorem found_true c v w : settle c = True_by v w -> says c.
Proof.
  intros H. apply (decided_by_orbits v w). revert H. unfold settle, settle_least, holds.
  destruct (proper_range c); [|easy]. cbn [negb andb].
  destruct (claimed_most c) as [m|]; [destruct (decide _ (N.succ m)) as [[x [|]]|] eqn:E1; try easy; apply decide_ok in E1|];
    (destruct (claimed_least c) as [k|]; [destruct (decide _ k) as [[y [|]]|] eqn:E2; try easy; apply decide_ok in E2|]);
    intros H; injection H; intros; subst; now rewrite ?E1, ?E2.
Qed.
Theorem found_false c q n reached : settle c = False_at q n reached -> in_range c (ratio_value q) /\
  if reached then N_at_least (ratio_value q) (N.to_nat n) /\ exists m, claimed_most c = Some m /\ (m < n)%N
  else claimed_least c = Some n /\ ~ N_at_least (ratio_value q) (N.to_nat n).
Proof.
  unfold settle, settle_least. destruct (proper_range c) eqn:P; [|easy]. apply proper_ok in P. cbn [negb]. unfold in_range.
  assert (K : forall x, match claimed_least c with None => True_by x Machine_doubles | Some n =>
    match decide (claimed_from c) n with Some (w, true) => True_by x w | Some (_, false) => False_at (claimed_from c) n false
      | None => Not_decided end end = False_at q n reached ->
    q = claimed_from c /\ reached = false /\ claimed_least c = Some n /\ ~ N_at_least (ratio_value q) (N.to_nat n)).
  { intros x. destruct (claimed_least c) as [k|]; [|easy]. destruct (decide _ k) as [[y [|]]|] eqn:E; try easy.
    intros H. injection H; intros; subst. apply decide_ok, answers_ok in E; [|lra]. repeat split; try easy.
    intros N. now apply E in N. }
  destruct (claimed_most c) as [m|].
  - destruct (decide _ (N.succ m)) as [[x [|]]|] eqn:E1; try easy.
    + intros H. injection H; intros; subst. apply decide_ok, answers_ok in E1; [|lra]. split; [lra|]. split; [now apply E1|].
      exists m. split; [easy | lia].
    + intros H. destruct (K _ H) as [-> [-> [A B]]]. split; [lra | now split].
  - intros H. destruct (K _ H) as [-> [-> [A B]]]. split; [lra | now split].
Qed.
