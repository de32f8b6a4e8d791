(** A motion in which the heavy mass hits the floor has at most U collisions: the first half of charts_upper, complete.
    *)
From Coq Require Import Reals Lra Lia List FinFun.
From Dumbbell Require Import Physics Chart Flight Collisions Symmetry BridgeChart SteepRays.
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
  intros HB HU. assert (HPI : 0 < PI) by apply PI_RGT_0. assert (R0 := r_pos P HP).
  (* with psi in [0, pi/2) *)
  assert (Main : forall p, motion P p -> collision P p T -> y2 P (p T) = 0 -> 0 <= psi_of (p T) < PI/2 ->
    at_most P p U).
  { clear p. intros p Hm Hc H2 Hp l Hnd Hl. destruct (count_split p T l Hm Hnd Hl) as [a [b [La [Lb Hn]]]].
    destruct (law P p Hm T) as [_ [v' [_ [Ha _]]]]. set (e := PI/2 - psi_of (p T)).
    assert (Ep : psi_of (p T) = PI/2 - e) by (unfold e; ring).
    destruct (Rlt_or_le (u_of v') 0) as [K|K].
    - destruct (Rlt_or_le (v_of P v') (- u_of v' * (1 + r * cos e))) as [K2|K2].
      + assert (Q := L8_bridge_left P HP Hr1 U p T e v' a b HB Hm Hc H2 Ep ltac:(unfold e; lra) Ha K K2 La Lb). lia.
      + assert (Q :=
          L8c_bridge_other P HP Hr1 U p T e v' a b HB HU Hm Hc H2 Ep ltac:(unfold e; lra) Ha (or_intror K2) La Lb). lia.
    - assert (Q :=
        L8c_bridge_other P HP Hr1 U p T e v' a b HB HU Hm Hc H2 Ep ltac:(unfold e; lra) Ha (or_introl K) La Lb). lia. }
  assert (Mirror : forall f, at_most P (mirror f) U -> at_most P f U).
  { intros f H l Hnd Hl. apply H; [assumption|]. intros t Ht. now apply collision_mirror, Hl. }
  assert (M2 : forall f, y2 P (f T) = 0 -> y2 P (mirror f T) = 0)
    by (intros f; unfold y2, mirror; simpl; now rewrite sin_mirror).
  (* with psi >= 0 *)
  assert (Pos : forall p, motion P p -> collision P p T -> y2 P (p T) = 0 -> 0 <= psi_of (p T) -> at_most P p U).
  { clear p. intros p Hm Hc H2 Hp. destruct (whole_turns _ Hp) as [k Hk].
    assert (Turn : at_most P (turn k p) U -> at_most P p U).
    { intros H l Hnd Hl. apply H; [assumption|]. intros t Ht. now apply collision_turn, Hl. }
    apply Turn. set (q := turn k p). assert (Hq : motion P q) by (now apply turn_motion).
    assert (Cq : collision P q T) by (now apply collision_turn).
    assert (Eq : psi_of (q T) = psi_of (p T) - 2 * INR k * PI) by (unfold psi_of, q; simpl; ring).
    assert (H2q : y2 P (q T) = 0) by (unfold y2, q; rewrite sin_turn; exact H2).
    assert (C2 := contact2 P HP q T H2q). assert (F1 := floor1 P HP q T Hq).
    assert (Cp : 0 < cos (psi_of (q T))).
    { destruct (Rtotal_order 0 (cos (psi_of (q T)))) as [|[E|E]]; [assumption| |].
      - exfalso. apply (regular P q Hq T). split; [|exact H2q]. destruct (L0_heights P (q T) HP) as [E1 _].
        rewrite E1, C2, <- E. ring.
      - exfalso. assert (0 < r * - cos (psi_of (q T))) by (apply Rmult_lt_0_compat; lra). lra. }
    assert (Hq2 : - (PI/2) < psi_of (q T) < PI/2).
    { split; apply Rnot_le_lt; intros K.
      - assert (cos (- psi_of (q T)) <= 0) by (apply cos_le_0; lra). rewrite cos_neg in H. lra.
      - assert (cos (psi_of (q T)) <= 0) by (apply cos_le_0; lra). lra. }
    destruct (Rle_or_lt 0 (psi_of (q T))) as [K|K]; [apply Main; try assumption; lra|].
    apply Mirror, Main; [now apply mirror_motion | now apply collision_mirror | now apply M2 | rewrite psi_mirror; lra].
    }
  intros Hm Hc H2. destruct (Rle_or_lt 0 (psi_of (p T))) as [K|K]; [now apply Pos|].
  apply Mirror, Pos; [now apply mirror_motion | now apply collision_mirror | now apply M2 | rewrite psi_mirror; lra].
Qed.
End Total.
