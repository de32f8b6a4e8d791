(** Integrals of x f(x) by one value of f on each part: the node stands where x has its mean, so that only the second
    derivative is left.

    cut, upto              == i/n; the whole numbers from 0 on
    chain                  == an integral over n parts is the sum of the integrals over them
    part_node, part_weight, part_spread == node, weight and half of what is left of x^2, of part i of n
    tangent_below          == Taylor's formula: f is above its tangent by l (x - m)^2/2, if f'' >= l
    node_rule              == so is the integral of x f above its weight times f(m)
    nodes_below            == the same over n parts
    weighted_below         == the integral of x f is at least l times that of x, if f >= l *)
From Coq Require Import Reals ZArith Lra Lia List.
From Coquelicot Require Import Coquelicot.
Import ListNotations.
Local Open Scope R_scope.

Definition cut (n i : Z) := IZR i / IZR n.
Definition upto j n := map Z.of_nat (seq j n).
Lemma cut_next n i : (0 < n)%Z -> cut n (i + 1) = cut n i + / IZR n.
Proof. intros Hn. unfold cut. rewrite plus_IZR. assert (0 < IZR n) by (now apply IZR_lt). field. lra. Qed.

Section Chain.
Variables (phi : R -> R) (u : R) (n : Z).
Hypothesis Hu : 0 < u.
Hypothesis Hn : (0 < n)%Z.
Hypothesis I : forall a b, 0 <= a -> a <= b <= u -> ex_RInt phi a b.
Let at_ i := u * cut n i.
Lemma cuts_range i : (0 <= i <= n)%Z -> 0 <= at_ i <= u.
Proof.
  intros [H1 H2]. apply IZR_le in H1. apply IZR_le in H2. assert (N : 0 < IZR n) by (now apply IZR_lt).
  unfold at_, cut.
  assert (0 <= IZR i / IZR n <= 1).
  { split; [apply Rmult_le_pos; [exact H1 | left; now apply Rinv_0_lt_compat]|].
    apply Rmult_le_reg_r with (IZR n); [exact N|]. replace (IZR i / IZR n * IZR n) with (IZR i) by (field; lra). lra.
    }
  split; [apply Rmult_le_pos; lra|]. replace u with (u * 1) at 2 by ring. apply Rmult_le_compat_l; lra.
Qed.
Lemma cuts_step i : at_ i < at_ (i + 1).
Proof.
  unfold at_. rewrite (cut_next n i Hn). assert (0 < / IZR n) by (apply Rinv_0_lt_compat; now apply IZR_lt).
  assert (0 < u * / IZR n) by (now apply Rmult_lt_0_compat). lra.
Qed.
Lemma chain : forall k j, (Z.of_nat (j + k) <= n)%Z ->
  RInt phi (at_ (Z.of_nat j)) (at_ (Z.of_nat (j + k))) =
  fold_right (fun i s => RInt phi (at_ i) (at_ (i + 1)) + s) 0 (upto j k).
Proof.
  induction k as [|k IH]; intros j Hj; [rewrite Nat.add_0_r, RInt_point; reflexivity|].
  unfold upto. cbn [seq map fold_right]. assert (E := IH (S j) ltac:(lia)).
  replace (S j + k)%nat with (j + S k)%nat in E by lia. unfold upto in E. rewrite <- E.
  replace (Z.of_nat (S j)) with (Z.of_nat j + 1)%Z by lia.
  assert (R0 := cuts_range (Z.of_nat j) ltac:(lia)). assert (R1 := cuts_range (Z.of_nat j + 1) ltac:(lia)).
  assert (R2 := cuts_range (Z.of_nat (j + S k)) ltac:(lia)). assert (S1 := cuts_step (Z.of_nat j)).
  assert (S2 : at_ (Z.of_nat j + 1) <= at_ (Z.of_nat (j + S k))).
  { apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat;
    now apply IZR_lt | apply IZR_le; lia]. }
  symmetry. apply (RInt_Chasles phi); apply I; lra.
Qed.
End Chain.

(** Taylor's formula from below, at a node m. *)
Lemma tangent_below (f f1 f2 : R -> R) a b l m :
  (forall x, a < x < b -> is_derive f x (f1 x)) -> (forall x, a < x < b -> is_derive f1 x (f2 x)) ->
  (forall x, a < x < b -> l <= f2 x) -> a < m < b ->
  forall x, a < x < b -> f m + f1 m * (x - m) + l * (x - m)^2 / 2 <= f x.
Proof.
  intros D1 D2 H Hm.
  set (h := fun x => f x - (f m + f1 m * (x - m) + l * (x - m)^2 / 2)).
  set (h1 := fun x => f1 x - (f1 m + l * (x - m))).
  assert (E1 : forall x, a < x < b -> is_derive h x (h1 x)).
  { intros x Hx. apply (is_derive_minus f (fun x => f m + f1 m * (x - m) + l * (x - m)^2 / 2)); [now apply D1|].
    auto_derive; [easy | simpl; field]. }
  assert (E2 : forall x, a < x < b -> is_derive h1 x (f2 x - l)).
  { intros x Hx. apply (is_derive_minus f1 (fun x => f1 m + l * (x - m))); [now apply D2|]. auto_derive;
    [easy | simpl; field]. }
  assert (Z : h1 m = 0) by (unfold h1; ring). assert (Z' : h m = 0) by (unfold h; field).
  assert (R : forall x, m <= x < b -> 0 <= h1 x).
  { intros x [[Hx|<-] Hb]; [|rewrite Z; lra]. destruct (MVT_cor2 h1 (fun x => f2 x - l) m x Hx) as [t [E Ht]].
    { intros t Ht. apply is_derive_Reals, E2. lra. } rewrite Z in E. assert (K := H t ltac:(lra)).
    assert (0 <= (f2 t - l) * (x - m)) by (apply Rmult_le_pos; lra). lra. }
  assert (L : forall x, a < x <= m -> h1 x <= 0).
  { intros x [Ha [Hx| ->]]; [|rewrite Z; lra]. destruct (MVT_cor2 h1 (fun x => f2 x - l) x m Hx) as [t [E Ht]].
    { intros t Ht. apply is_derive_Reals, E2. lra. } rewrite Z in E. assert (K := H t ltac:(lra)).
    assert (0 <= (f2 t - l) * (m - x)) by (apply Rmult_le_pos; lra). lra. }
  intros x Hx. assert (0 <= h x); [|unfold h in *; lra]. destruct (Rtotal_order x m) as [T|[->|T]].
  - destruct (MVT_cor2 h h1 x m T) as [t [E Ht]]; [intros t Ht; apply is_derive_Reals, E1; lra|]. rewrite Z' in E.
    assert (K := L t ltac:(lra)). assert (0 <= - h1 t * (m - x)) by (apply Rmult_le_pos; lra). lra.
  - rewrite Z'. lra.
  - destruct (MVT_cor2 h h1 m x T) as [t [E Ht]]; [intros t Ht; apply is_derive_Reals, E1; lra|]. rewrite Z' in E.
    assert (K := R t ltac:(lra)). assert (0 <= h1 t * (x - m)) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma weighted_below (f : R -> R) a b l : 0 <= a < b -> ex_RInt (fun x => x * f x) a b -> (forall x, a < x < b ->
  l <= f x) ->
  l * ((b^2 - a^2) / 2) <= RInt (fun x => x * f x) a b.
Proof.
  intros Hab I H. assert (P : is_RInt (fun x => x * l) a b (l * ((b^2 - a^2) / 2))).
  { replace (l * ((b^2 - a^2) / 2)) with (minus (b^2 / 2 * l) (a^2 / 2 * l)) by (unfold minus, plus, opp; simpl;
    field).
    apply (is_RInt_derive (fun x => x^2 / 2 * l) (fun x => x * l)).
    - intros x _. auto_derive; [easy | simpl; field].
    - intros x _. apply (ex_derive_continuous (fun x => x * l)). auto_derive. easy. }
  rewrite <- (is_RInt_unique _ _ _ _ P). apply RInt_le; [lra | eexists; exact P | exact I |].
  intros x Hx. apply Rmult_le_compat_l; [lra | now apply H].
Qed.
Lemma node_rule (f f1 f2 : R -> R) a b l m : 0 <= a < m -> m < b ->
  (forall x, a < x < b -> is_derive f x (f1 x)) -> (forall x, a < x < b -> is_derive f1 x (f2 x)) ->
  (forall x, a < x < b -> l <= f2 x) -> ex_RInt (fun x => x * f x) a b -> m * ((b^2 - a^2) / 2) = (b^3 - a^3) / 3 ->
  (b^2 - a^2) / 2 * f m + l * (((b^4 - a^4) / 4 - m * ((b^3 - a^3) / 3)) / 2) <= RInt (fun x => x * f x) a b.
Proof.
  intros Ha Hb D1 D2 H I M. set (c := f1 m).
  assert (P : is_RInt (fun x => x * (f m + c * (x - m) + l * (x - m)^2 / 2)) a b
    ((b^2 - a^2) / 2 * f m + l * (((b^4 - a^4) / 4 - m * ((b^3 - a^3) / 3)) / 2))).
  { set (A := fun x => x^2 / 2 * f m + c * (x^3 / 3 - m * (x^2 / 2)) + l / 2 * (x^4 / 4 - m * (x^3 / 3) - m * (x^3 / 3
    - m * (x^2 / 2)))).
    replace ((b^2 - a^2) / 2 * f m + l * (((b^4 - a^4) / 4 - m * ((b^3 - a^3) / 3)) / 2)) with (minus (A b) (A a)).
    - apply (is_RInt_derive A).
      + intros x _. unfold A. auto_derive; [easy | simpl; field].
      + intros x _. apply (ex_derive_continuous (fun x => x * (f m + c * (x - m) + l * (x - m)^2 / 2))). auto_derive.
        easy.
    - unfold A, minus, plus, opp; simpl. simpl in M.
      assert (Z : (b * (b * (b * 1)) - a * (a * (a * 1))) / 3 - m * ((b * (b * 1) - a * (a * 1)) / 2) = 0) by lra.
      match goal with |- ?x = ?y =>
        assert (x - y = (c - l / 2 * m) * ((b * (b * (b * 1)) - a * (a * (a * 1))) / 3 - m * ((b * (b * 1) - a * (a *
        1)) / 2))) by field end.
      rewrite Z in *. lra. }
  rewrite <- (is_RInt_unique _ _ _ _ P). apply RInt_le; [lra | eexists; exact P | exact I |].
  intros x Hx. apply Rmult_le_compat_l; [lra|]. apply (tangent_below f f1 f2 a b l m); try assumption; lra.
Qed.

(** n equal parts of [0, u]. *)
Definition part_node (n i : Z) := IZR (2 * (3 * i * i + 3 * i + 1)) / IZR (3 * n * (2 * i + 1)).
Definition part_weight (n i : Z) := IZR (2 * i + 1) / IZR (2 * n * n).
Definition part_spread (n i : Z) := IZR (6 * i * i + 6 * i + 1) / IZR (72 * (2 * i + 1) * n * n * n * n).
Section Nodes.
Variables (f f1 f2 : R -> R) (u l : R) (n : Z).
Hypothesis Hu : 0 < u.
Hypothesis Hn : (0 < n)%Z.
Hypothesis D1 : forall x, 0 < x < u -> is_derive f x (f1 x).
Hypothesis D2 : forall x, 0 < x < u -> is_derive f1 x (f2 x).
Hypothesis Hl : forall x, 0 < x < u -> l <= f2 x.
Hypothesis I : forall a b, 0 <= a -> a <= b <= u -> ex_RInt (fun x => x * f x) a b.
Lemma part_below i : (0 <= i < n)%Z ->
  u^2 * (f (u * part_node n i) * part_weight n i) + l * (u^4 * part_spread n i) <=
  RInt (fun x => x * f x) (u * cut n i) (u * cut n (i + 1)).
Proof.
  intros Hi. assert (N : 0 < IZR n) by (now apply IZR_lt). assert (H0 : 0 <= IZR i) by (apply IZR_le; lia).
  assert (R0 := cuts_range u n Hu Hn i ltac:(lia)). assert (R1 := cuts_range u n Hu Hn (i + 1) ltac:(lia)).
  assert (S := cuts_step u n Hu Hn i). cbv beta in R0, R1, S.
  assert (EN : part_node n i = 2 * (3 * IZR i * IZR i + 3 * IZR i + 1) / (3 * IZR n * (2 * IZR i + 1)))
    by (unfold part_node; repeat rewrite ?mult_IZR, ?plus_IZR; reflexivity).
  assert (EW : part_weight n i = (2 * IZR i + 1) / (2 * IZR n * IZR n))
    by (unfold part_weight; repeat rewrite ?mult_IZR, ?plus_IZR; reflexivity).
  assert (ES : part_spread n i = (6 * IZR i * IZR i + 6 * IZR i + 1) / (72 * (2 * IZR i + 1) * IZR n * IZR n * IZR n *
    IZR n))
    by (unfold part_spread; repeat rewrite ?mult_IZR, ?plus_IZR; reflexivity).
  assert (EC : cut n (i + 1) = (IZR i + 1) / IZR n) by (unfold cut; now rewrite plus_IZR).
  assert (EC0 : cut n i = IZR i / IZR n) by reflexivity. rewrite EN, EW, ES, EC, EC0 in *. set (x := IZR i) in *.
  set (y := IZR n) in *.
  set (m := 2 * (3 * x * x + 3 * x + 1) / (3 * y * (2 * x + 1))) in *.
  assert (M1 : m - x / y = (3 * x + 2) / (3 * y * (2 * x + 1))) by (unfold m; field; lra).
  assert (M2 : (x + 1) / y - m = (3 * x + 1) / (3 * y * (2 * x + 1))) by (unfold m; field; lra).
  assert (W : 0 < 3 * y * (2 * x + 1)) by (repeat apply Rmult_lt_0_compat; lra).
  assert (P1 : 0 < m - x / y) by (rewrite M1; apply Rdiv_lt_0_compat; lra).
  assert (P2 : 0 < (x + 1) / y - m) by (rewrite M2; apply Rdiv_lt_0_compat; lra).
  apply Rle_trans with (2 := node_rule f f1 f2 (u * (x / y)) (u * ((x + 1) / y)) l (u * m)
    ltac:(split; [lra | apply Rmult_lt_compat_l; lra]) ltac:(apply Rmult_lt_compat_l; lra)
    ltac:(intros z Hz; apply D1; lra) ltac:(intros z Hz; apply D2; lra) ltac:(intros z Hz; apply Hl; lra)
    ltac:(apply I; lra) ltac:(unfold m; field; lra)).
  right. set (fm := f (u * m)). unfold m. field. lra.
Qed.
Theorem nodes_below : let node_sum := fold_right (fun i s =>
  f (u * part_node n i) * part_weight n i + s) 0 (upto 0 (Z.to_nat n)) in
  let spread := fold_right (fun i s => part_spread n i + s) 0 (upto 0 (Z.to_nat n)) in
  u^2 * node_sum + l * (u^4 * spread) <= RInt (fun x => x * f x) 0 u.
Proof.
  intros node_sum spread. assert (N : 0 < IZR n) by (now apply IZR_lt).
  assert (C := chain (fun x => x * f x) u n Hu Hn I (Z.to_nat n) 0 ltac:(lia)). cbn [Nat.add] in C.
  replace (u * cut n (Z.of_nat 0)) with 0 in C by (unfold cut; simpl; field; lra).
  replace (u * cut n (Z.of_nat (Z.to_nat n))) with u in C by (rewrite Z2Nat.id by lia; unfold cut; field; lra).
  rewrite C. unfold node_sum, spread.
  assert (Hall : forall i, In i (upto 0 (Z.to_nat n)) -> (0 <= i < n)%Z).
  { intros i Hin. unfold upto in Hin. apply in_map_iff in Hin. destruct Hin as [k [<- Hk]]. apply in_seq in Hk. lia. }
  clear C node_sum spread. revert Hall. generalize (upto 0 (Z.to_nat n)). intros t.
  induction t as [|i t IH]; intros Hall; cbn [fold_right]; [lra|].
  assert (A := part_below i ltac:(apply Hall; now left)). assert (B := IH ltac:(intros k Hk; apply Hall; now right)).
  lra.
Qed.
End Nodes.

(** From above, by the same of - f. *)
Lemma negated_integral (f : R -> R) a b : ex_RInt (fun x => x * f x) a b ->
  ex_RInt (fun x => x * - f x) a b /\ RInt (fun x => x * - f x) a b = - RInt (fun x => x * f x) a b.
Proof.
  intros I. assert (K : is_RInt (fun x => x * - f x) a b (- RInt (fun x => x * f x) a b)).
  { refine (is_RInt_ext _ _ _ _ _ _ (is_RInt_opp (V := R_NormedModule) _ _ _ _ (RInt_correct (V :=
    R_CompleteNormedModule) _ _ _ I))).
    intros x _. unfold opp; simpl. match goal with |- ?a = ?b => change (@eq R a b) end. ring. }
  split; [eexists; exact K | now apply is_RInt_unique].
Qed.
Lemma weighted_above (f : R -> R) a b l : 0 <= a < b -> ex_RInt (fun x => x * f x) a b -> (forall x, a < x < b ->
  f x <= l) ->
  RInt (fun x => x * f x) a b <= l * ((b^2 - a^2) / 2).
Proof.
  intros Hab I H. destruct (negated_integral f a b I) as [I' E].
  assert (K := weighted_below (fun x => - f x) a b (- l) Hab I' ltac:(intros x Hx; specialize (H x Hx); lra)). lra.
Qed.
Lemma node_rule_above (f f1 f2 : R -> R) a b l m : 0 <= a < m -> m < b ->
  (forall x, a < x < b -> is_derive f x (f1 x)) -> (forall x, a < x < b -> is_derive f1 x (f2 x)) ->
  (forall x, a < x < b -> f2 x <= l) -> ex_RInt (fun x => x * f x) a b -> m * ((b^2 - a^2) / 2) = (b^3 - a^3) / 3 ->
  RInt (fun x => x * f x) a b <= (b^2 - a^2) / 2 * f m + l * (((b^4 - a^4) / 4 - m * ((b^3 - a^3) / 3)) / 2).
Proof.
  intros Ha Hb D1 D2 H I M. destruct (negated_integral f a b I) as [I' E].
  assert (K := node_rule (fun x => - f x) (fun x => - f1 x) (fun x => - f2 x) a b (- l) m Ha Hb
    ltac:(intros x Hx; exact (is_derive_opp f x _ (D1 x Hx))) ltac:(intros x Hx;
      exact (is_derive_opp f1 x _ (D2 x Hx)))
    ltac:(intros x Hx; specialize (H x Hx); lra) I' M). cbv beta in K. lra.
Qed.
Theorem nodes_above (f f1 f2 : R -> R) u l n : 0 < u -> (0 < n)%Z ->
  (forall x, 0 < x < u -> is_derive f x (f1 x)) -> (forall x, 0 < x < u -> is_derive f1 x (f2 x)) ->
  (forall x, 0 < x < u -> f2 x <= l) -> (forall a b, 0 <= a -> a <= b <= u -> ex_RInt (fun x => x * f x) a b) ->
  let node_sum := fold_right (fun i s => f (u * part_node n i) * part_weight n i + s) 0 (upto 0 (Z.to_nat n)) in
  let spread := fold_right (fun i s => part_spread n i + s) 0 (upto 0 (Z.to_nat n)) in
  RInt (fun x => x * f x) 0 u <= u^2 * node_sum + l * (u^4 * spread).
Proof.
  intros Hu Hn D1 D2 H I node_sum spread. destruct (negated_integral f 0 u (I 0 u ltac:(lra) ltac:(lra))) as [I' E].
  assert (K := nodes_below (fun x => - f x) (fun x => - f1 x) (fun x => - f2 x) u (- l) n Hu Hn
    ltac:(intros x Hx; exact (is_derive_opp f x _ (D1 x Hx))) ltac:(intros x Hx;
      exact (is_derive_opp f1 x _ (D2 x Hx)))
    ltac:(intros x Hx; specialize (H x Hx); lra) ltac:(intros a b Ha Hb;
      exact (proj1 (negated_integral f a b (I a b Ha Hb))))).
  cbv beta zeta in K. fold spread in K.
  assert (S : fold_right (fun i s =>
    - f (u * part_node n i) * part_weight n i + s) 0 (upto 0 (Z.to_nat n)) = - node_sum).
  { unfold node_sum. generalize (upto 0 (Z.to_nat n)). intros t. induction t as [|i t IH]; cbn [fold_right];
    [|rewrite IH]; ring. }
  rewrite S, E in K. lra.
Qed.
