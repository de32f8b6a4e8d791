(** L40 (a) for motions that pass through a corner, whatever velocity they leave it with: no other corner before or
    after it, and at most N(q) - 2 collisions besides; a dumbbell at rest in a corner stays there.

    only_corner       == a motion that is not at rest meets one corner at most
    corner_counts_two == besides a corner it has at most N(q) - 2 collisions
    through_few       == in all at most N(q) *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics Flight Symmetry Existence RealInduction OneFlight Determinism.
From Dumbbell Require Import HalfMotion FromCorner Stretch Stretches WholeMotion CollisionCount.
Local Open Scope R_scope.

Lemma filter_split (f : R -> bool) l : length l = (length (filter f l) + length (filter (fun x => negb (f x)) l))%nat.
Proof. induction l as [|x l IH]; simpl; [reflexivity|]. destruct (f x); simpl; lia. Qed.

Section Through.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.

Lemma no_energy v : energy P v = 0 -> vy v = 0 /\ om v = 0.
Proof.
  intros E. unfold energy in E. assert (M := mass_pos P HP). assert (I0 := inertia_pos P HP).
  assert (A : 0 <= mass P * (vy v * vy v)) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]).
  assert (B : 0 <= inertia P * (om v * om v)) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]).
  assert (Z : mass P * (vy v * vy v) = 0) by lra. assert (Z2 : inertia P * (om v * om v) = 0) by lra.
  apply Rmult_integral in Z. apply Rmult_integral in Z2. destruct Z as [Z|Z]; [lra|]. destruct Z2 as [Z2|Z2]; [lra|].
  apply Rmult_integral in Z. apply Rmult_integral in Z2. tauto.
Qed.
Lemma energy_rest v : vy v = 0 -> om v = 0 -> energy P v = 0.
Proof. intros A B. unfold energy. rewrite A, B. field. Qed.
Lemma energy_nonneg v : 0 <= energy P v.
Proof.
  unfold energy. assert (M := mass_pos P HP). assert (I0 := inertia_pos P HP).
  assert (0 <= mass P * (vy v * vy v)) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]).
  assert (0 <= inertia P * (om v * om v)) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]). lra.
Qed.

(* ---------- symmetry ---------- *)
Lemma through_reverse a b p : motion_through P a b p -> motion_through P (Rbar_opp b) (Rbar_opp a) (reverse p).
Proof.
  intros Hm t Ht. destruct (Hm (- t) (within_unreverse a b t Ht)) as [H|[C [v [v' [Hb [Ha E]]]]]].
  - left. now apply (reverse_lawful P).
  - right. split; [exact C|]. exists (minus_v v'), (minus_v v). split; [now apply reverse_before|].
    split; [now apply reverse_after|]. unfold energy in *. simpl. lra.
Qed.
Lemma through_above a b p t : motion_through P a b p -> within a b t -> 0 <= y1 P (p t) /\ 0 <= y2 P (p t).
Proof. intros Hm Ht. destruct (Hm t Ht) as [[A [B _]]|[[A B] _]]; lra. Qed.
Lemma through_before a b p t : motion_through P a b p -> within a b t -> exists v, before p t v.
Proof. intros Hm Ht. destruct (Hm t Ht) as [[_ [_ [_ [v [v' [Hb _]]]]]]|[_ [v [v' [Hb _]]]]]; now exists v. Qed.

(* ---------- a flight out of a corner has no other corner for a while ---------- *)
Lemma sin_small x : 0 < Rabs x < PI -> sin x <> 0.
Proof.
  intros Hx. unfold Rabs in Hx. destruct (Rcase_abs x) as [L|L].
  - assert (0 < sin (- x)) by (apply sin_gt_0; lra). rewrite sin_neg in H. lra.
  - assert (0 < sin x) by (apply sin_gt_0; lra). lra.
Qed.
Lemma line_off_corner s v e t : both_down P s -> 0 < energy P v ->
  (forall t', 0 < t' < e -> 0 <= y1 P (line s v t') /\ 0 <= y2 P (line s v t')) -> 0 < t < e ->
    ~ both_down P (line s v t).
Proof.
  intros Hs Hv Hab Ht Hc. destruct (corner_flat P HP s Hs) as [H0 S0].
  destruct (corner_flat P HP _ Hc) as [H1 _]. simpl in H1. rewrite H0, Rplus_0_l in H1.
  apply Rmult_integral in H1. assert (V : vy v = 0) by (destruct H1; lra).
  destruct (Req_dec (om v) 0) as [O|O]; [rewrite (energy_rest v V O) in Hv; lra|].
  assert (HO : 0 < Rabs (om v)) by (now apply Rabs_pos_lt). set (x := Rmin (t / 2) (/ Rabs (om v))).
  assert (X0 : 0 < x) by (apply Rmin_pos; [lra | now apply Rinv_0_lt_compat]).
  assert (X1 : x <= t / 2) by apply Rmin_l. assert (X2 : x <= / Rabs (om v)) by apply Rmin_r.
  destruct (Hab x ltac:(lra)) as [A B].
  assert (Fl : both_down P (line s v x)) by (apply (flat_corner P HP); [simpl; rewrite H0, V;
    ring | exact A | exact B]).
  destruct (corner_flat P HP _ Fl) as [_ S1]. simpl in S1. rewrite sin_plus, S0, Rmult_0_l, Rplus_0_l in S1.
  apply Rmult_integral in S1. assert (SC := sin2_cos2 (angle s)). unfold Rsqr in SC. rewrite S0 in SC.
  destruct S1 as [S1|S1]; [rewrite S1 in SC; lra|]. apply (sin_small (om v * x)) with (2 := S1).
  rewrite Rabs_mult, (Rabs_pos_eq x) by lra. assert (Rabs (om v) * x <= 1).
  { replace 1 with (Rabs (om v) * / Rabs (om v)) by (field; lra). apply Rmult_le_compat_l; lra. }
  assert (1 < PI/2) by exact PI2_1. split; [now apply Rmult_lt_0_compat | lra].
Qed.
Lemma obeys_off_corner p m : obeys P p m -> exists d, 0 < d /\ forall t, m < t <= m + d -> ~ both_down P (p t).
Proof.
  intros Hm. destruct (lawful_above_floor P HP p m Hm) as [H0 _]. destruct Hm as [_ [_ [_ [_ [v [_ [Ha _]]]]]]].
  destruct Ha as [e [He Ha]]. set (k := Rabs (vy v) + 1).
  assert (Hk : 0 < k) by (unfold k; assert (K := Rabs_pos (vy v)); lra).
  set (d := height (p m) / k / 2).
  assert (Hd : 0 < d) by (unfold d; apply Rdiv_lt_0_compat; [now apply Rdiv_lt_0_compat | lra]).
  assert (Ed : k * d = height (p m) / 2) by (unfold d; field; lra).
  assert (D1 : Rmin e d <= e) by apply Rmin_l. assert (D2 : Rmin e d <= d) by apply Rmin_r.
  exists (Rmin e d). split; [now apply Rmin_pos|]. intros t Ht Hc. destruct (corner_flat P HP _ Hc) as [Hz _].
  destruct (Ha t ltac:(lra)) as [E _]. rewrite E in Hz.
  assert (N : - Rabs (vy v) <= vy v) by (unfold Rabs; destruct Rcase_abs; lra).
  assert (- Rabs (vy v) * (t - m) <= vy v * (t - m)) by (apply Rmult_le_compat_r; lra).
  assert (Rabs (vy v) * (t - m) <= Rabs (vy v) * d) by (apply Rmult_le_compat_l; [apply Rabs_pos | lra]).
  unfold k in Ed. lra.
Qed.

(* ---------- at rest in a corner ---------- *)
Lemma rest_after a b p T v : motion_through P a b p -> within a b T -> both_down P (p T) -> before p T v ->
  energy P v = 0 ->
  forall t, within a b t -> T <= t -> p t = p T.
Proof.
  intros Hm HT Hc Hb Hv t Ht L. set (z := {| vy := 0; om := 0 |}).
  assert (Ez : forall w, energy P w = 0 -> w = z) by (intros w Hw; destruct (no_energy w Hw); now apply vel_eq).
  assert (In : forall m, T <= m <= t -> within a b m) by (intros m H; now apply (within_between a b T t)).
  assert (Const : forall m, before (fun _ => p T) m z) by (intros m; exists 1; split; [lra|]; intros s _; simpl;
    split; ring).
  assert (At : forall m w, T < m -> (forall s, T <= s < m -> p s = p T) -> before p m w -> p m = p T /\ w = z).
  { intros m w Hlt Hbelow Hw. exact (agree_at p (fun _ => p T) T m w z Hlt Hbelow Hw (Const m)). }
  apply (real_induction (fun s => p s = p T) T t eq_refl); [| |lra].
  - intros m Hmt Hs. assert (Em : p m = p T) by (apply Hs; lra).
    destruct (Hm m (In m ltac:(lra))) as [[_ [_ [Rg _]]]|[_ [w [w' [Bw [Aw E]]]]]]; [rewrite Em in Rg; now exfalso|].
    assert (W : w = z).
    { destruct (Req_dec m T) as [->|N]; [apply Ez; now rewrite (before_unique p T w v Bw Hb)|].
      apply (At m w); [lra | intros s Hs'; apply Hs; lra | exact Bw]. }
    subst w. rewrite (energy_rest z eq_refl eq_refl) in E. apply Ez in E. subst w'. destruct Aw as [e [He A]].
    exists e. split; [exact He|]. intros s Hs'. destruct (A s ltac:(lra)) as [A1 A2]. rewrite <- Em.
    apply pos_eq; [rewrite A1 | rewrite A2]; simpl; ring.
  - intros m Hmt Hs. destruct (through_before a b p m Hm (In m ltac:(lra))) as [w Bw].
    apply (At m w); [lra | exact Hs | exact Bw].
Qed.
Lemma rest_always a b p T v : motion_through P a b p -> within a b T -> both_down P (p T) -> before p T v ->
  energy P v = 0 ->
  forall t, within a b t -> p t = p T.
Proof.
  intros Hm HT Hc Hb Hv t Ht. destruct (Rle_or_lt T t) as [L|L]; [now apply (rest_after a b p T v)|].
  destruct (Hm T HT) as [[_ [_ [Rg _]]]|[_ [w [w' [Bw [Aw E]]]]]]; [contradiction|].
  rewrite (before_unique p T w v Bw Hb), Hv in E.
  rewrite <- (reverse_at p t), <- (reverse_at p T).
  apply (rest_after (Rbar_opp b) (Rbar_opp a) (reverse p) (- T) (minus_v w')); rewrite ?reverse_at; try lra.
  - now apply through_reverse. - now apply within_reverse. - exact Hc.
  - apply reverse_before. now rewrite Ropp_involutive. - unfold energy in *; simpl. lra. - now apply within_reverse.
Qed.
Lemma rest_no_collision a b p T v t : motion_through P a b p -> within a b T -> both_down P (p T) -> before p T v ->
  energy P v = 0 -> within a b t -> ~ collision P p t.
Proof.
  intros Hm HT Hc Hb Hv Ht [w [Bw H]]. assert (K := rest_always a b p T v Hm HT Hc Hb Hv).
  assert (Ew : w = {| vy := 0; om := 0 |}).
  { apply before_unique with p t; [exact Bw|]. apply (near_before (fun _ => p T)).
    - apply within_near with a b; [intros s Hs; symmetry; now apply K | exact Ht].
    - exists 1. split; [lra|]. intros s _. simpl. split; ring. }
  subst w. unfold w1, w2 in H. simpl in H. lra.
Qed.

(* ---------- not at rest: no other corner ---------- *)
Hypothesis Hr1 : r_of P <= 1.
Notation r := (r_of P).
Lemma after_corner a b p T v : motion_through P a b p -> within a b T -> both_down P (p T) -> after p T v ->
  0 < energy P v ->
  motion_within P T b p.
Proof.
  intros Hm HT Hc Ha Hv t [Ht1 Ht2]. simpl in Ht1.
  assert (Ht : within a b t) by (split; [destruct HT as [A _]; eapply Rbar_lt_trans;
    [exact A | exact Ht1] | exact Ht2]).
  assert (In : forall m, T <= m <= t -> within a b m) by (intros m H; now apply (within_between a b T t)).
  assert (Off : forall m, T <= m <= t -> ~ both_down P (p m) -> obeys P p m).
  { intros m H N. destruct (Hm m (In m H)) as [K|[K _]]; [exact K | contradiction]. }
  assert (G : t = T \/ obeys P p t); [|destruct G; [lra | assumption]].
  apply (real_induction (fun s => s = T \/ obeys P p s) T t (or_introl eq_refl)); [| |lra].
  - intros m Hmt Hs.
    assert (D : exists d, 0 < d /\ forall s, m < s <= m + d -> s <= t -> ~ both_down P (p s)).
    { destruct (Hs m ltac:(lra)) as [->|Hob].
      - destruct Ha as [e [He Ha]]. set (e' := Rmin e (t - T)). assert (E1 : e' <= e) by apply Rmin_l.
        assert (E2 : e' <= t - T) by apply Rmin_r. assert (E0 : 0 < e') by (apply Rmin_pos; lra).
        assert (Hl : forall s, 0 < s < e' -> line (p T) v s = p (T + s)).
        { intros s Hs'. destruct (Ha (T + s) ltac:(lra)) as [A B]. apply pos_eq; simpl; [rewrite A | rewrite B]; ring. }
        exists (e' / 2). split; [lra|]. intros s Hs' _. replace s with (T + (s - T)) by ring. rewrite <- Hl by lra.
        apply (line_off_corner (p T) v e' (s - T) Hc Hv); [|lra]. intros x Hx. rewrite Hl by exact Hx.
        apply (through_above a b p (T + x) Hm), In. lra.
      - destruct (obeys_off_corner p m Hob) as [d [Hd K]]. exists d. split; [exact Hd|]. intros s Hs' _. now apply K. }
    destruct D as [d [Hd D]]. exists (Rmin d (t - m)). assert (D1 : Rmin d (t - m) <= d) by apply Rmin_l.
    assert (D2 : Rmin d (t - m) <= t - m) by apply Rmin_r. split; [apply Rmin_pos; lra|].
    intros s Hs'. right. apply Off; [lra | apply D; lra].
  - intros m Hmt Hs. right. apply Off; [lra|]. intros Hcm.
    destruct (through_before a b p m Hm (In m ltac:(lra))) as [w Bw].
    assert (Hw : whole P T m p).
    { split; [|split; right].
      - intros s [A B]. simpl in A, B. destruct (Hs s ltac:(lra)) as [->|K]; [lra | exact K].
      - exists m, (p m). split; [reflexivity|]. split; [exact Hcm | now apply flies_to_before with w].
      - exists T, (p T). split; [reflexivity|]. split; [exact Hc|]. destruct Ha as [e [He Ha]]. exists v, e.
        split; [exact He|]. intros s Hs'. apply Ha. lra. }
    destruct (one_corner P HP Hr1 T m p) as [K|K]; [simpl; lra | exact Hw | discriminate | discriminate].
Qed.

(** The two halves. *)
Lemma begins_after p T v : both_down P (p T) -> after p T v -> begins_in_corner P p T.
Proof.
  intros Hc [e [He Ha]]. exists T, (p T). split; [reflexivity|]. split; [exact Hc|]. exists v, e. split; [exact He|].
  intros s Hs. apply Ha. lra.
Qed.
Theorem only_corner a b p T v : motion_through P a b p -> within a b T -> both_down P (p T) -> before p T v ->
  0 < energy P v -> motion_within P a T p /\ motion_within P T b p /\ ends_in_corner P p T /\ begins_in_corner P p T.
Proof.
  intros Hm HT Hc Hb Hv. destruct (Hm T HT) as [[_ [_ [Rg _]]]|[_ [w [w' [Bw [Aw E]]]]]]; [contradiction|].
  assert (w = v) by (now apply before_unique with p T). subst w. split; [|split; [|split]].
  - assert (K := after_corner (Rbar_opp b) (Rbar_opp a) (reverse p) (- T) (minus_v v)). rewrite reverse_at in K.
    assert (K' : motion_within P (- T) (Rbar_opp a) (reverse p)).
    { apply K; [now apply through_reverse | now apply within_reverse | exact Hc | |].
      - apply reverse_after. now rewrite Ropp_involutive.
      - unfold energy in *. simpl. lra. }
    apply motion_reverse in K'. rewrite reverse_reverse, Rbar_opp_involutive in K'. simpl in K'.
    now rewrite Ropp_involutive in K'.
  - apply (after_corner a b p T w' Hm HT Hc Aw). lra.
  - exists T, (p T). split; [reflexivity|]. split; [exact Hc | now apply flies_to_before with v].
  - now apply begins_after with w'.
Qed.

(* ---------- the number of collisions ---------- *)
Variable U : nat.
Hypothesis HU : forall p, motion P p -> at_most P p U.
Theorem corner_counts_two a b p T v l : motion_through P a b p -> within a b T -> both_down P (p T) -> before p T v ->
  0 < energy P v -> NoDup l -> (forall t, In t l -> within a b t /\ t <> T /\ collision P p t) ->
    (2 + length l <= U)%nat.
Proof.
  intros Hm HT Hc Hb Hv Hnd Hl. destruct (only_corner a b p T v Hm HT Hc Hb Hv) as [M1 [M2 [E1 E2]]].
  set (f := fun t => if Rlt_dec t T then true else false). rewrite (filter_split f l), Nat.add_assoc.
  apply (corner_bound P HP Hr1 U HU).
  - apply (into_corner_coll P HP Hr1 a T p); [apply HT | exact M1 | exact E1 | now apply NoDup_filter|].
    intros t Ht. apply filter_In in Ht. destruct Ht as [Ht F]. destruct (Hl t Ht) as [[W1 W2] [_ C]].
    unfold f in F. destruct (Rlt_dec t T); [|discriminate]. split; [now split | exact C].
  - apply (out_of_corner_coll P HP Hr1 T b p); [apply HT | exact M2 | exact E2 | now apply NoDup_filter|].
    intros t Ht. apply filter_In in Ht. destruct Ht as [Ht F]. destruct (Hl t Ht) as [[W1 W2] [N C]].
    unfold f in F. destruct (Rlt_dec t T); [discriminate|]. split; [split; [simpl; lra | exact W2] | exact C].
Qed.
Theorem through_few a b p : motion_through P a b p -> at_most_within P a b p U.
Proof.
  intros Hm l Hnd Hl. destruct (Classical_Prop.classic (exists T, within a b T /\
    both_down P (p T))) as [[T [HT Hc]]|N].
  - destruct (through_before a b p T Hm HT) as [v Hb]. destruct (energy_nonneg v) as [Hv|Hv].
    + assert (K := remove_length T l Hnd).
      assert (K2 := corner_counts_two a b p T v (remove Req_EM_T T l) Hm HT Hc Hb Hv (NoDup_remove_R T l Hnd)).
      assert (2 + length (remove Req_EM_T T l) <= U)%nat; [|lia]. apply K2. intros t Ht. apply in_remove in Ht.
      destruct Ht as [Ht Nt]. destruct (Hl t Ht) as [W C]. now repeat split; [apply W | apply W | |].
    + destruct l as [|t l]; [simpl; lia|]. exfalso. destruct (Hl t (or_introl eq_refl)) as [W C].
      exact (rest_no_collision a b p T v t Hm HT Hc Hb (eq_sym Hv) W C).
  - apply (stretch_few P HP Hr1 U HU a b p); [|exact Hnd | exact Hl]. intros t Ht.
    destruct (Hm t Ht) as [K|[K _]]; [exact K|]. exfalso. apply N. now exists t.
Qed.
End Through.
