(** L8 complete: a motion in which the heavy mass hits the floor has at most as many collisions as the chart bridge
    allows. The collisions are counted before and after that one.

    heavy_total == at most U collisions
    count_split == the collisions before and after a time *)
From Coq Require Import Reals Lra Lia List FinFun.
From Dumbbell Require Import Statement Chart Flight Collisions Symmetry NormalPosition SteepRays.
Local Open Scope R_scope.

Section Total.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.
Hypothesis Hr1 : r_of P <= 1.
Notation r := (r_of P).

(** Counting around one time. *)
Lemma count_split p T l : motion P p -> NoDup l -> (forall t, In t l -> collision P p t) ->
  exists a b, later P p T a /\ later P (reverse p) (- T) b /\ (length l <= 1 + a + b)%nat.
Proof.
  intros Hm. induction l as [|t l IH]; intros Hnd Hc.
  - exists O, O. split; [|split; [|simpl; lia]]; exists nil; (split; [constructor|]);
      (split; [reflexivity|]); intros t [].
  - set (f := fun s => if Rlt_dec T s then true else false). set (g := fun s => if Rlt_dec s T then true else false).
    clear IH.
    exists (length (filter f (t :: l))), (length (filter g (t :: l))). split; [|split].
    + exists (filter f (t :: l)). split; [now apply NoDup_filter|]. split; [reflexivity|]. intros s Hs.
      apply filter_In in Hs. destruct Hs as [S1 S2]. unfold f in S2. destruct (Rlt_dec T s) as [Hlt|]; [|discriminate].
      split; [assumption | now apply Hc].
    + exists (map Ropp (filter g (t :: l))). split; [|split; [apply map_length|]].
      { apply Injective_map_NoDup; [intros x y E; lra | now apply NoDup_filter]. }
      intros s Hs. apply in_map_iff in Hs. destruct Hs as [s' [<- Hs]]. apply filter_In in Hs. destruct Hs as [S1 S2].
      unfold g in S2. destruct (Rlt_dec s' T) as [Hlt|]; [|discriminate]. split; [lra|].
      apply (collision_reverse P HP); [exact Hm | now apply Hc].
    + assert (G : forall m, NoDup m ->
        (length m <= length (filter f m) + length (filter g m) + (if in_dec Req_EM_T T m then 1 else 0))%nat).
      { induction m as [|s m IHm]; intros Hd; [simpl; lia|]. apply NoDup_cons_iff in Hd. destruct Hd as [Hni Hd].
        specialize (IHm Hd). cbn [filter length].
        destruct (in_dec Req_EM_T T (s :: m)) as [I2|I2]; destruct (in_dec Req_EM_T T m) as [I1|I1];
          unfold f at 1, g at 1;
        destruct (Rlt_dec T s) as [Q1|Q1]; destruct (Rlt_dec s T) as [Q2|Q2]; cbn [length]; try lia; try lra.
        all: try (exfalso; apply I2; now right). all: try (exfalso; apply I2; left; lra).
        all: exfalso; assert (Es : s = T) by lra; rewrite Es in Hni; contradiction. }
      specialize (G _ Hnd). destruct (in_dec Req_EM_T T (t :: l)); lia.
Qed.

Theorem heavy_total U p T : bridge_bound r U -> (1 <= U)%nat -> motion P p -> collision P p T -> y2 P (p T) = 0 ->
  at_most P p U.
Proof.
  intros HB HU Hm Hc H2. destruct (heavy_normal_position P HP p T Hm H2) as [q [e [S [Ep He]]]].
  apply (same_at_most P p q U S). assert (Hq := same_motion _ _ _ S Hm). intros l Hnd Hl.
  destruct (count_split q T l Hq Hnd Hl) as [a [b [La [Lb Hn]]]]. apply Nat.le_trans with (1 := Hn).
  apply (L8_bridge_contact P HP Hr1 U q T e); try assumption; [now apply (same_collision _ _ _ S)|].
  now rewrite (same_y2 _ _ _ S).
Qed.
End Total.
