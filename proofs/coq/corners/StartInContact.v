(** A watch that begins at a contact. The stretches of Stretch.v are open: a collision at their very beginning is none of
    theirs. Here it counts, too: out of the state before it there is a motion backwards, for a while at least, and with
    it the watch is part of a longer stretch. *)
From Coq Require Import Reals List Lra Lia.
From Coquelicot Require Import Rbar.
From Dumbbell Require Import Physics Flight Symmetry Existence OneFlight EveryState Determinism Exchange.
From Dumbbell Require Import Stretch Stretches WholeMotion AnyMotion.
Local Open Scope R_scope.

(** From the time 0 on the path p is watched, before which the velocity is v: no mass is below the floor, not both are on
    it, and one that is there came down to it, or along it; then the law holds, at 0 and until b. *)
Definition watched_from_0 P b p v := motion_within P 0 b p /\
  0 <= y1 P (p 0) /\ 0 <= y2 P (p 0) /\ ~ (y1 P (p 0) = 0 /\ y2 P (p 0) = 0) /\
  (y1 P (p 0) = 0 -> w1 P (p 0) v <= 0) /\ (y2 P (p 0) = 0 -> w2 P (p 0) v <= 0) /\
  exists v', after p 0 v' /\
    (v' = v \/ (y1 P (p 0) = 0 /\ push1 P (p 0) v v') \/ (y2 P (p 0) = 0 /\ push2 P (p 0) v v')).
Definition collides_at_once P (p : R -> pos) v :=
  (y1 P (p 0) = 0 /\ w1 P (p 0) v < 0) \/ (y2 P (p 0) = 0 /\ w2 P (p 0) v < 0).

Lemma off_the_corner P s : real_dumbbell P -> 0 <= y1 P s -> 0 <= y2 P s -> ~ (y1 P s = 0 /\ y2 P s = 0) ->
  above_floor P s.
Proof.
  intros HP H1 H2 H3. apply (lawful_above_floor P HP (fun _ => s) 0). repeat (split; [assumption|]).
  exists {| vy := 0; om := 0 |}, {| vy := 0; om := 0 |}.
  split; [|split; [|now left]]; exists 1; (split; [lra|]); intros t _; simpl; lra.
Qed.
Lemma goes_on P s v : real_dumbbell P -> 0 <= y1 P s -> 0 <= y2 P s -> ~ (y1 P s = 0 /\ y2 P s = 0) -> leaves P s v ->
  exists c p, Rbar_lt 0 c /\ p 0 = s /\ after p 0 v /\ motion_within P 0 c p.
Proof.
  intros HP H1 H2 H3 [L1 L2]. destruct (one_naming P HP) as [Hr|Hr].
  - destruct (outcome_stretch P HP Hr s v) as [c [p [A [B [C [D _]]]]]]; [now apply off_the_corner | now split|].
    now exists c, p.
  - set (Q := swap_dumbbell P) in *. set (s' := {| height := height s; angle := angle s - PI |}).
    assert (Es : swap_state s' = s) by (apply pos_eq; simpl; ring).
    destruct (swap_y Q (fun _ => s') 0) as [Y1 Y2]. destruct (swap_w Q (fun _ => s') 0 v) as [W1 W2].
    change (swap (fun _ => s') 0) with (swap_state s') in *. unfold Q in Y1, Y2, W1, W2. rewrite swap_twice, Es in Y1, Y2, W1, W2.
    destruct (outcome_stretch Q (swap_real P HP) Hr s' v) as [c [p [A [B [C [D _]]]]]].
    + apply off_the_corner; [now apply swap_real | unfold Q; lra.. | unfold Q; intros [K1 K2]; apply H3; split; lra].
    + split; intros K; unfold Q in *; rewrite <- ?W1, <- ?W2; [apply L2 | apply L1]; lra.
    + exists c, (swap p). split; [exact A|]. split; [rewrite <- Es, <- B; reflexivity|].
      split; [now apply swap_after|]. intros t Ht. rewrite <- (swap_twice P). now apply swap_obeys, D.
Qed.

Theorem contact_at_most P b p v U l : real_dumbbell P -> upper_bound (m2 P / m1 P) U -> Rbar_lt 0 b ->
  watched_from_0 P b p v -> collides_at_once P p v ->
  NoDup l -> (forall t, In t l -> within 0 b t /\ collision P p t) -> (1 + length l <= U)%nat.
Proof.
  intros HP HU Hb [Hm [Y1 [Y2 [Rg [V1 [V2 [v' [Ha HL]]]]]]]] Hc Hnd Hl.
  destruct (goes_on P (p 0) (minus_v v) HP Y1 Y2 Rg) as [c [pS [Hc0 [S0 [Sa Sm]]]]].
  { split; intros K; [specialize (V1 K) | specialize (V2 K)]; unfold w1, w2 in *; simpl; lra. }
  set (g := glue 0 (reverse pS) p). assert (E0 : reverse pS 0 = p 0) by (unfold reverse; now rewrite Ropp_0).
  assert (Eg : g 0 = p 0) by (unfold g; now rewrite glue_at).
  assert (Bg : before g 0 v).
  { apply glue_before. replace v with (minus_v (minus_v v)) by (apply vel_eq; simpl; ring). apply reverse_before.
    now rewrite Ropp_0. }
  assert (Z : Finite 0 = Rbar_opp 0) by (simpl; now rewrite Ropp_0).
  assert (Cg : Rbar_lt (Rbar_opp c) 0) by (rewrite Z; now apply Rbar_opp_lt).
  apply (stretch_at_most P (Rbar_opp c) b g U HP HU) with (l := 0 :: l).
  - intros t [A B]. destruct (Rtotal_order t 0) as [L|[->|L]].
    + apply (near_lawful P (reverse pS)); [now apply glue_left|]. apply reverse_lawful, Sm.
      rewrite Z, <- (Rbar_opp_involutive c). apply within_reverse. split; [exact A | exact L].
    + unfold obeys. rewrite Eg. repeat (split; [assumption|]). exists v, v'. split; [exact Bg|].
      split; [apply glue_after; [now rewrite E0 | exact Ha] | exact HL].
    + apply (near_lawful P (shift 0 p)); [now apply glue_right|]. apply shift_lawful, Hm. rewrite Rminus_0_r.
      split; [exact L | exact B].
  - constructor; [|exact Hnd]. intros K. destruct (Hl 0 K) as [[A _] _]. simpl in A. lra.
  - intros t [<-|Ht].
    + split; [now split|]. exists v. rewrite Eg. now split.
    + destruct (Hl t Ht) as [[A B] C]. split; [split; [now apply Rbar_lt_trans with 0 | exact B]|].
      apply near_collision with (shift 0 p); [now apply glue_right|]. apply shift_collision. now rewrite Rminus_0_r.
Qed.
