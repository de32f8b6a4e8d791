(** Every state has a motion: out of each state from which no mass goes down through the floor there is a motion for all
    later times, or one into a corner (both masses on the floor), where regular motions end. It goes flight by flight
    (OneFlight.v); by L6 the heavy mass is met at most once, and slopes grow (L5 (f)), so that the flights end. On
    paper: the definition of a trajectory in claim.md.

    outcome, every_state == a motion for all later times, or one into a corner; each state has the one or the other
    runs_into_corner     == a state whose motion ends in a corner
    every_flight         == states in flight have a motion for all times, or run into a corner *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics Ray Chart Flight Symmetry Existence StartRay RayFuture OneFlight.
Local Open Scope R_scope.

Section General.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.
Hypothesis Hr1 : r_of P <= 1.
Notation r := (r_of P).
Notation yh := (yhat_of P).

Definition runs_into_corner s v :=
  exists T p u, 0 < T /\ p 0 = s /\ after p 0 v /\ (forall t, 0 < t < T -> lawful P p t) /\ before p T u /\
  corner P (p T).
Definition outcome s v := (exists p, future P s v p) \/ runs_into_corner s v.

Lemma above_floor_free s : above_floor P s -> free P s.
Proof.
  intros [H0 [H1 H2]]. assert (A1 := arm1_pos P HP). destruct (L0_heights P s HP) as [E1 E2]. fold (r_of P) in E2.
  rewrite E1 in H1. rewrite E2 in H2.
  assert (0 < yh s) by (unfold yhat_of; now apply Rdiv_lt_0_compat).
  assert (0 <= yh s + cos (psi_of s)) by (apply Rmult_le_reg_l with (arm1 P); lra).
  assert (0 <= yh s - r * cos (psi_of s)) by (apply Rmult_le_reg_l with (arm1 P); lra).
  unfold free. repeat split; lra.
Qed.

(* ---------- symmetries of outcomes ---------- *)
Lemma outcome_mirror s v : outcome (mirror_pos s) (mirror_v v) -> outcome s v.
Proof.
  assert (Ev : mirror_v (mirror_v v) = v) by (apply vel_eq; simpl; ring).
  intros [[p F]|[T [p [u [HT [E0 [Ha [Hg [Hb Hc]]]]]]]]]; [left; exists (mirror p); now apply future_mirror | right].
  exists T, (mirror p), (mirror_v u). split; [exact HT|].
  split; [unfold mirror; rewrite E0; apply pos_eq; simpl; ring|].
  split; [rewrite <- Ev; now apply mirror_after|]. split; [intros t Ht; now apply mirror_lawful, Hg|].
  split; [now apply mirror_before|].
  destruct Hc as [C1 C2]. unfold corner, y1, y2, mirror in *; simpl. rewrite sin_mirror. now split.
Qed.
Definition turned c (s : pos) := {| height := height s; angle := angle s + c |}.
Section Turned.
Variable k : nat.
Notation c := (2 * INR k * PI).
Lemma turned_y s : y1 P (turned c s) = y1 P s /\ y2 P (turned c s) = y2 P s.
Proof. unfold y1, y2, turned; simpl. rewrite sin_period. now split. Qed.
Lemma turned_before p t v : before p t v -> before (fun t => turned c (p t)) t v.
Proof. intros [e [He H]]. exists e. split; [exact He|]. intros s Hs. destruct (H s Hs). simpl. split; lra. Qed.
Lemma turned_after p t v : after p t v -> after (fun t => turned c (p t)) t v.
Proof. intros [e [He H]]. exists e. split; [exact He|]. intros s Hs. destruct (H s Hs). simpl. split; lra. Qed.
Lemma turned_lawful p t : lawful P p t -> lawful P (fun t => turned c (p t)) t.
Proof.
  intros [A [B [C [v [v' [D [E F]]]]]]]. unfold lawful, push1, push2. destruct (turned_y (p t)) as [-> ->].
  replace (cos (angle (turned c (p t)))) with (cos (angle (p t))) by (unfold turned; simpl; now rewrite cos_period).
  repeat split; try assumption. exists v, v'. split; [now apply turned_before|].
  split; [now apply turned_after | exact F].
Qed.
Lemma outcome_turn s s' v : s = turned c s' -> outcome s' v -> outcome s v.
Proof.
  intros -> [[p [E0 [Ha Hg]]]|[T [p [u [HT [E0 [Ha [Hg [Hb Hc]]]]]]]]]; [left | right].
  - exists (fun t => turned c (p t)). split; [now rewrite E0|]. split; [now apply turned_after|]. intros t Ht.
    now apply turned_lawful, Hg.
  - exists T, (fun t => turned c (p t)), u. split; [exact HT|]. split; [now rewrite E0|].
    split; [now apply turned_after|].
    split; [intros t Ht; now apply turned_lawful, Hg|]. split; [now apply turned_before|]. unfold corner.
    destruct (turned_y (p T)) as [-> ->]. exact Hc.
Qed.
End Turned.

(** A property of states that the symmetries keep need be treated for 0 <= psi <= pi only. *)
Lemma seen_from (K : pos -> vel -> Prop) :
  (forall s v, K s v -> K (mirror_pos s) (mirror_v v)) -> (forall k s v, K (turned (2 * INR k * PI) s) v -> K s v) ->
  (forall s v, K s v -> 0 <= psi_of s <= PI -> outcome s v) -> forall s v, K s v -> outcome s v.
Proof.
  intros KM KT Main. assert (HPI : 0 < PI) by apply PI_RGT_0.
  assert (Pos : forall s v, K s v -> 0 <= psi_of s -> outcome s v).
  { intros s v Hs Hp. destruct (whole_turns _ Hp) as [k Hk].
    set (s' := {| height := height s; angle := angle s - 2 * INR k * PI |}).
    assert (Es : s = turned (2 * INR k * PI) s') by (apply pos_eq; simpl; ring).
    assert (Ep : psi_of s' = psi_of s - 2 * INR k * PI) by (unfold psi_of, s'; simpl; ring).
    apply (outcome_turn k s s' v Es). assert (K' : K s' v) by (apply (KT k); now rewrite <- Es).
    destruct (Rle_or_lt 0 (psi_of s')) as [L|L]; [apply Main; [exact K' | lra]|].
    apply outcome_mirror, Main; [now apply KM | rewrite psi_mirror_pos; lra]. }
  intros s v Hs. destruct (Rle_or_lt 0 (psi_of s)) as [L|L]; [now apply Pos|].
  apply outcome_mirror, Pos; [now apply KM | rewrite psi_mirror_pos; lra].
Qed.

(* ---------- gluing ---------- *)
Definition bounced s v v' := (y1 P s = 0 /\ push1 P s v v' /\ w1 P s v < 0 /\ v' <> v) \/
  (y2 P s = 0 /\ push2 P s v v' /\ w2 P s v < 0 /\ v' <> v).
Lemma answer s v : hits P s v -> exists v', bounced s v v'.
Proof.
  intros [[H W]|[H W]].
  - destruct (push_exists P HP (arm1 P * cos (angle s)) v W) as [v' [Q N]]. exists v'. left. repeat split; assumption.
  - destruct (push_exists P HP (- (arm2 P * cos (angle s))) v ltac:(unfold w2 in W; lra)) as [v' [Q N]]. exists v'.
    right. repeat split; assumption.
Qed.
Lemma bounced_law s v v' : bounced s v v' -> v' = v \/ (y1 P s = 0 /\ push1 P s v v') \/ (y2 P s = 0 /\ push2 P s v v').
Proof. intros [[A [B _]]|[A [B _]]]; right; [left | right]; now split. Qed.
Lemma outcome_glue s v T v' : 0 < T -> (forall t, 0 <= t < T -> above_floor P (line s v t)) ->
  above_floor P (line s v T) -> bounced (line s v T) v v' ->
  outcome (line s v T) v' -> outcome s v.
Proof.
  intros HT Hf Hok HB Ho.
  assert (G : forall p2, p2 0 = line s v T -> after p2 0 v' -> let p :=
    glue T (line s v) p2 in p 0 = s /\ after p 0 v /\ forall t, 0 < t <= T -> lawful P p t).
  { intros p2 E0 Ha p. assert (Eat : p T = line s v T) by (unfold p; now rewrite glue_at).
    split; [unfold p, glue; destruct (Rle_dec 0 T); [apply line_0 | lra]|].
    split; [apply near_after with (line s v); [now apply glue_left | apply line_after]|]. intros t Ht.
    destruct (Rlt_or_le t T) as [L|L].
    - apply near_lawful with (line s v); [now apply glue_left|]. apply (line_lawful P HP), above_floor_free, Hf. lra.
    - replace t with T by lra. destruct (free_above P HP _ (above_floor_free _ Hok)) as [A [B C]]. unfold lawful.
      rewrite Eat. repeat split; try assumption.
      exists v, v'. split; [apply glue_before, line_before|]. split; [now apply glue_after | now apply bounced_law]. }
  destruct Ho as [[p2 [E0 [Ha Hg]]]|[T2 [p2 [u [HT2 [E0 [Ha [Hg [Hb Hc]]]]]]]]]; destruct (G p2 E0 Ha) as [G1 [G2 G3]].
  - left. exists (glue T (line s v) p2). split; [exact G1|]. split; [exact G2|]. intros t Ht.
    destruct (Rle_or_lt t T) as [L|L]; [now apply G3|].
    apply near_lawful with (shift T p2); [now apply glue_right|]. apply shift_lawful, Hg. lra.
  - right. exists (T + T2), (glue T (line s v) p2), u. split; [lra|]. split; [exact G1|]. split; [exact G2|].
    split; [|split].
    + intros t Ht. destruct (Rle_or_lt t T) as [L|L]; [now apply G3|]. apply near_lawful with (shift T p2);
        [now apply glue_right|]. apply shift_lawful, Hg. lra.
    + apply near_before with (shift T p2); [apply glue_right; lra|]. apply shift_before.
      now replace (T + T2 - T) with T2 by ring.
    + rewrite <- (near_at _ _ _ (glue_right T (line s v) p2 (T + T2) ltac:(lra))). unfold shift.
      now replace (T + T2 - T) with T2 by ring.
Qed.
Lemma outcome_flight s v : above_floor P s -> leaves P s v ->
  (forall T v', 0 < T -> (forall t, 0 <= t < T -> above_floor P (line s v t)) -> above_floor P (line s v T) ->
  bounced (line s v T) v v' -> outcome (line s v T) v') -> outcome s v.
Proof.
  intros Hs Hl H. destruct (one_flight P HP s v Hs Hl) as [Hf|[T [HT [Hf [Hc|[Hok Hh]]]]]].
  - left. exists (line s v). apply (future_line P HP). intros t Ht. apply above_floor_free, Hf. lra.
  - right. exists T, (line s v), v. split; [exact HT|]. split; [apply line_0|]. split; [apply line_after|].
    split; [intros t Ht; apply (line_lawful P HP), above_floor_free, Hf; lra|]. split; [apply line_before | exact Hc].
  - destruct (answer _ _ Hh) as [v' HB]. apply (outcome_glue s v T v' HT Hf Hok HB). now apply H.
Qed.

(* ---------- out of a contact with the heavy mass ---------- *)
Definition heavy_out s v := above_floor P s /\ y2 P s = 0 /\ 0 < v_of P v - slope2 P s * u_of v.
Lemma heavy_left s v : heavy_out s v -> - (PI/2) < psi_of s < PI/2 -> u_of v <= 0 -> outcome s v.
Proof.
  intros [Hok [Hy Hn]] Hp Hu. assert (R0 := r_pos P HP). destruct (above_floor_free s Hok) as [F0 [F1 F2]].
  unfold slope2 in Hn.
  assert (Cy : yh s = r * cos (psi_of s)). { destruct (L0_heights P s HP) as [_ E]. rewrite E in Hy.
    assert (A1 := arm1_pos P HP). apply Rmult_integral in Hy. unfold r_of. lra. }
  left. destruct (Req_dec (u_of v) 0) as [Z|Z].
  - exists (line s v). apply (future_line P HP). intros t Ht. rewrite Z in Hn.
    assert (0 < v_of P v * t) by (apply Rmult_lt_0_compat; lra).
    unfold free. rewrite line_psi, (line_yh P HP), Z. replace (psi_of s + 0 * t) with (psi_of s) by ring.
    repeat split; lra.
  - set (k := v_of P v / - u_of v). assert (Ek : k * - u_of v = v_of P v) by (unfold k; field; lra).
    destruct (bridge_start_ray P HP Hr1 s v k ltac:(lra) Ek Hp Cy ltac:(lra)) as [RS KS].
    destruct (ray_future P HP Hr1 _ _ _ _ RS KS) as [p [F _]]. now exists p.
Qed.
Lemma mirror_above_floor s : above_floor P s -> above_floor P (mirror_pos s).
Proof. unfold above_floor, y1, y2; simpl. now rewrite sin_mirror. Qed.
Lemma mirror_y s : y1 P (mirror_pos s) = y1 P s /\ y2 P (mirror_pos s) = y2 P s.
Proof. unfold y1, y2; simpl. now rewrite sin_mirror. Qed.
Lemma turned_above_floor k s : above_floor P (turned (2 * INR k * PI) s) -> above_floor P s.
Proof. unfold above_floor. destruct (turned_y k s) as [-> ->]. tauto. Qed.
Lemma turned_sin k s : sin (psi_of (turned (2 * INR k * PI) s)) = sin (psi_of s).
Proof. rewrite !sin_psi. unfold turned; simpl. now rewrite cos_period. Qed.
Lemma mirror_sin s : sin (psi_of (mirror_pos s)) = - sin (psi_of s).
Proof. rewrite psi_mirror_pos. apply sin_neg. Qed.
Theorem heavy_out_outcome s v : heavy_out s v -> outcome s v.
Proof.
  revert s v. apply seen_from.
  - intros s v [A [B C]]. split; [now apply mirror_above_floor|]. destruct (mirror_y s) as [_ ->]. split; [exact B|].
    unfold slope2 in *. rewrite mirror_sin. unfold u_of, v_of in *; simpl. lra.
  - intros k s v [A [B C]]. split; [now apply turned_above_floor in A|]. destruct (turned_y k s) as [_ E].
    rewrite E in B. split; [exact B|]. unfold slope2 in *. now rewrite turned_sin in C.
  - intros s v H Hp. assert (HPI : 0 < PI) by apply PI_RGT_0. assert (R0 := r_pos P HP). destruct H as [Hok [Hy Hn]].
    destruct (above_floor_free s Hok) as [F0 [F1 F2]].
    assert (Cy : yh s = r * cos (psi_of s)). { destruct (L0_heights P s HP) as [_ E]. rewrite E in Hy.
      assert (A1 := arm1_pos P HP). apply Rmult_integral in Hy. unfold r_of. lra. }
    assert (Hp2 : psi_of s < PI/2). { apply Rnot_le_lt. intros L. assert (cos (psi_of s) <= 0) by (apply cos_le_0; lra).
      assert (0 <= r * - cos (psi_of s)) by (apply Rmult_le_pos; lra). lra. }
    destruct (Rle_or_lt (u_of v) 0) as [L|L].
    + apply heavy_left; [split; [exact Hok | now split] | lra | exact L].
    + apply outcome_mirror, heavy_left.
      * split; [now apply mirror_above_floor|]. destruct (mirror_y s) as [_ ->]. split; [exact Hy|]. unfold slope2 in *.
        rewrite mirror_sin. unfold u_of, v_of in *; simpl. lra.
      * rewrite psi_mirror_pos. lra.
      * unfold u_of in *; simpl. lra.
Qed.

(* ---------- out of a contact with the light mass ---------- *)
Definition light_out s v := above_floor P s /\ y1 P s = 0 /\ 0 < v_of P v - slope1 s * u_of v.
Lemma over_free_R s X : psi_of s = PI/2 + X -> over P X (yh s) -> free P s.
Proof.
  intros E [A [B C]]. assert (Ec : cos (PI/2 + X) = - sin X) by (rewrite cos_plus, cos_PI2, sin_PI2; ring). unfold free.
  rewrite E, Ec. repeat split; lra.
Qed.
Lemma one_contact s : above_floor P s -> y1 P s = 0 -> y2 P s <> 0.
Proof.
  intros [H0 _] H1 H2. assert (A1 := arm1_pos P HP). assert (A2 := arm2_pos P HP). unfold y1, y2 in *.
  assert (arm2 P * (height s + arm1 P * sin (angle s)) + arm1 P * (height s - arm2 P * sin (angle s)) =
    (arm1 P + arm2 P) * height s) by ring.
  rewrite H1, H2 in H. assert (0 < (arm1 P + arm2 P) * height s) by (apply Rmult_lt_0_compat; lra). lra.
Qed.
Lemma w1_slope s v : w1 P s v = arm1 P * (v_of P v - slope1 s * u_of v).
Proof. unfold w1, slope1, v_of, u_of. rewrite sin_psi. field. assert (A1 := arm1_pos P HP). lra. Qed.
Lemma bounced_out s v v' : above_floor P s -> bounced s v v' -> heavy_out s v' \/ light_out s v'.
Proof.
  intros Hok [[H [Q [W N]]]|[H [Q [W N]]]].
  - right. destruct (L0_reflection1 P HP s v v' Q) as [|[l [_ [_ [_ [Er En]]]]]]; [contradiction|]. split; [exact Hok|].
    split; [exact H | lra].
  - left. destruct (L0_reflection2 P HP s v v' Q) as [|[l [_ [_ [_ [Er En]]]]]]; [contradiction|]. split; [exact Hok|].
    split; [exact H | lra].
Qed.

(** A flight from R to the left meets the light mass's floor at the wall L only. *)
Lemma far_wall s v e T : psi_of s = PI/2 + e -> 0 < e <= PI/2 -> yh s = sin e -> 0 < v_of P v - cos e * u_of v ->
  u_of v < 0 -> 0 < T ->
  (forall t, 0 <= t < T -> above_floor P (line s v t)) -> above_floor P (line s v T) -> y1 P (line s v T) = 0 ->
  w1 P (line s v T) v < 0 ->
  exists x, 0 < x < PI/2 /\ psi_of (line s v T) = - (PI/2) - x /\ yh (line s v T) = sin x.
Proof.
  intros Hp He Hy Hn Hu HT Hf Hok H1 Hw. assert (HPI : 0 < PI) by apply PI_RGT_0. assert (A1 := arm1_pos P HP).
  destruct (cos_range e ltac:(lra)) as [W0 W1].
  set (z := psi_of (line s v T)). assert (Ez : z = PI/2 + e + u_of v * T) by (unfold z; now rewrite line_psi, Hp).
  assert (Ey : yh (line s v T) = sin e + v_of P v * T) by (now rewrite (line_yh P HP), Hy).
  assert (C := contact1 P HP (line s v) T H1). fold z in C. destruct (above_floor_free _ Hok) as [F0 _].
  assert (HuT : 0 < - u_of v * T) by (apply Rmult_lt_0_compat; lra).
  destruct (Rlt_or_le (PI/2) z) as [L1|L1].
  { exfalso. assert (Tg := sin_below_tangent e (z - PI/2) ltac:(lra) ltac:(lra)).
    rewrite sin_minus, cos_PI2, sin_PI2 in Tg.
    assert (0 < (v_of P v - cos e * u_of v) * T) by (now apply Rmult_lt_0_compat).
    replace (z - PI/2 - e) with (u_of v * T) in Tg by lra. lra. }
  destruct (Rle_or_lt (- (PI/2)) z) as [L2|L2].
  { exfalso. assert (0 <= cos z) by (apply cos_ge_0; lra). lra. }
  set (x := - (PI/2) - z). assert (Ex : z = - (PI/2) - x) by (unfold x; ring).
  assert (Yx : yh (line s v T) = sin x) by (rewrite C, Ex, cos_left; ring).
  destruct (Rlt_or_le x (PI/2)) as [L3|L3]; [exists x; repeat split; try assumption; lra | exfalso].
  set (tp := (PI/2 + e + PI) / - u_of v). assert (Htp : - u_of v * tp = PI/2 + e + PI) by (unfold tp; field; lra).
  assert (T0 : 0 < tp) by (unfold tp; apply Rdiv_lt_0_compat; lra).
  assert (T1 : tp <= T) by (apply Rmult_le_reg_l with (- u_of v); lra).
  assert (Hokp : above_floor P (line s v tp)) by (destruct (Req_dec tp T) as [->|]; [exact Hok | apply Hf; lra]).
  destruct (above_floor_free _ Hokp) as [_ [G _]]. rewrite line_psi, (line_yh P HP), Hp, Hy in G.
  replace (PI/2 + e + u_of v * tp) with (- PI) in G by lra. rewrite cos_neg, cos_PI in G.
  destruct (SIN_bound e) as [_ S1]. assert (V0 : 0 <= v_of P v). { apply Rnot_lt_le. intros K.
    assert (0 < - v_of P v * tp) by (apply Rmult_lt_0_compat; lra). lra. }
  assert (v_of P v * tp <= v_of P v * T) by (apply Rmult_le_compat_l; lra). destruct (COS_bound z) as [B1 B2].
  assert (Cz : cos z = -1) by lra.
  assert (SC := sin2_cos2 z). unfold Rsqr in SC. rewrite Cz in SC. assert (Sz : sin z = 0).
  { assert (sin z * sin z = 0) by lra. apply Rmult_integral in H0. tauto. }
  rewrite w1_slope in Hw. unfold slope1 in Hw. fold z in Hw. rewrite Sz in Hw.
  assert (0 <= arm1 P * (v_of P v - 0 * u_of v)) by (apply Rmult_le_pos; lra). lra.
Qed.

Theorem light_out_on_R N : forall s v e, above_floor P s -> psi_of s = PI/2 + e -> 0 < e <= PI/2 -> yh s = sin e ->
  0 < v_of P v - cos e * u_of v ->
  (u_of v < 0 -> - u_of v <= v_of P v + 2 * r * INR N * - u_of v) -> outcome s v.
Proof.
  assert (HPI : 0 < PI) by apply PI_RGT_0. assert (R0 := r_pos P HP). assert (A1 := arm1_pos P HP).
  induction N as [|N IH]; intros s v e Hok Hp He Hy Hn HN; destruct (cos_range e ltac:(lra)) as [W0 W1];
  (destruct (Rle_or_lt 0 (u_of v)) as [Hu|Hu];
   [left; exists (line s v); apply (future_line P HP); intros t Ht; assert (0 <= u_of v * t)
     by (apply Rmult_le_pos; lra);
    apply over_free_R with (e + u_of v * t); [rewrite line_psi, Hp; ring|]; rewrite (line_yh P HP), Hy;
    assert (0 < (v_of P v - cos e * u_of v) * t) by (apply Rmult_lt_0_compat; lra);
    destruct (Req_dec e (PI/2)) as [E|E];
    [apply (over_high P HP Hr1); rewrite E, cos_PI2 in *; rewrite sin_PI2; lra
    |apply (over_tangent P HP Hr1) with e; lra]
   |specialize (HN Hu); set (k := v_of P v / - u_of v);
     assert (Ek : k * - u_of v = v_of P v) by (unfold k; field; lra)]).
  all: assert (Hlv : leaves P s v)
    by (split; [intros _; rewrite w1_slope; unfold slope1; rewrite Hp, sin_plus, sin_PI2, cos_PI2;
    apply Rmult_le_pos; lra
    | intros K; exfalso; apply (one_contact s Hok); [|exact K]; destruct (L0_heights P s HP) as [E _];
      rewrite E, Hp, Hy, cos_plus, cos_PI2, sin_PI2; ring]).
  all: apply (outcome_flight s v Hok Hlv); intros T v' HT Hf Hok1 HB.
  all: destruct (bounced_out _ _ _ Hok1 HB) as [Hh|_]; [now apply heavy_out_outcome|].
  all: destruct HB as [[H1 [Q [W Nv]]]|[H2 [Q [W Nv]]]];
    [|destruct (L0_reflection2 P HP _ v v' Q) as [|[l [_ [_ [_ [Er En]]]]]]; [contradiction|]; apply heavy_out_outcome;
    split; [exact Hok1|]; split; [exact H2 | lra]].
  all: destruct (far_wall s v e T Hp He Hy Hn Hu HT Hf Hok1 H1 W) as [x [Hx [Px Yx]]].
  all: destruct (L0_reflection1 P HP _ v v' Q) as [|HL]; [contradiction|]; unfold slope1 in HL;
    rewrite Px, sin_left in HL.
  all: destruct (reflected_velocity P HP x k v v' Hu Ek HL) as [Bu [Bv Bn]].
  all: assert (Kx : k < cos x) by (destruct HL as [l [_ [_ [_ [_ En]]]]]; apply Rmult_lt_reg_r with (- u_of v); lra).
  all: destruct (COS_bound x) as [_ C1].
  - exfalso. simpl INR in HN. assert (k * - u_of v < 1 * - u_of v) by (apply Rmult_lt_compat_r; lra). lra.
  - apply outcome_mirror. apply (IH _ _ x).
    + now apply mirror_above_floor.
    + rewrite psi_mirror_pos, Px. ring.
    + lra.
    + exact Yx.
    + unfold u_of, v_of in *; simpl. lra.
    + intros Hu'. assert (Up : 0 < u_of v') by (unfold u_of in *; simpl in Hu'; lra).
      assert (Hq : 0 < cos x * cos x + r) by (assert (0 <= cos x * cos x) by apply Rle_0_sqr; lra).
      assert (HD : 0 < slope_den (cos x) k r).
      { rewrite Bu in Up. apply Rmult_lt_reg_l with (- u_of v * / (cos x * cos x + r));
          [apply Rmult_lt_0_compat; [lra | now apply Rinv_0_lt_compat]|]. unfold Rdiv in Up. lra. }
      assert (Wx : 0 < cos x) by (apply cos_pos; lra). assert (G := next_slope_grows (cos x) k r ltac:(lra) R0 HD).
      assert (Hkk : next_slope (cos x) k r * u_of v' = v_of P v') by (rewrite Bu, Bv; unfold next_slope; field; lra).
      assert (K1 : 1 <= k + 2 * r * INR (S N)) by (apply Rmult_le_reg_r with (- u_of v); lra). rewrite S_INR in K1.
      assert (1 * u_of v' <= (next_slope (cos x) k r + 2 * r * INR N) * u_of v') by (apply Rmult_le_compat_r; lra).
      unfold u_of, v_of in *; simpl. lra.
Qed.
Theorem light_out_outcome s v : light_out s v -> outcome s v.
Proof.
  revert s v. apply seen_from.
  - intros s v [A [B C]]. split; [now apply mirror_above_floor|]. destruct (mirror_y s) as [-> _]. split; [exact B|].
    unfold slope1 in *. rewrite mirror_sin. unfold u_of, v_of in *; simpl. lra.
  - intros k s v [A [B C]]. split; [now apply turned_above_floor in A|]. destruct (turned_y k s) as [E _].
    rewrite E in B. split; [exact B|]. unfold slope1 in *. now rewrite turned_sin in C.
  - intros s v [Hok [Hy Hn]] Hp. assert (HPI : 0 < PI) by apply PI_RGT_0. assert (R0 := r_pos P HP).
    destruct (above_floor_free s Hok) as [F0 _].
    assert (C := contact1 P HP (fun _ => s) 0 Hy). simpl in C.
    assert (K : PI/2 < psi_of s). { apply Rnot_le_lt. intros K. assert (0 <= cos (psi_of s)) by (apply cos_ge_0; lra).
      lra. }
    set (e := psi_of s - PI/2). assert (Ee : psi_of s = PI/2 + e) by (unfold e; ring).
    assert (He : 0 < e <= PI/2) by (unfold e; lra).
    destruct (cos_range e ltac:(lra)) as [W0 W1]. unfold slope1 in Hn. rewrite Ee, sin_plus, sin_PI2, cos_PI2 in Hn.
    destruct (nfloor_ex (/ r)) as [m Hm]; [left; now apply Rinv_0_lt_compat|].
    apply (light_out_on_R (S m) s v e Hok Ee He).
    + rewrite C, Ee, cos_plus, cos_PI2, sin_PI2. ring.
    + lra.
    + intros Hu. assert (1 <= r * INR (S m)). { rewrite S_INR. replace 1 with (r * / r) at 1 by (field; lra).
        apply Rmult_le_compat_l; lra. }
      assert (cos e * - u_of v <= 1 * - u_of v) by (apply Rmult_le_compat_r; lra).
      assert (1 * (2 * - u_of v) <= r * INR (S m) * (2 * - u_of v)) by (apply Rmult_le_compat_r; lra). lra.
Qed.

(** Every state. *)
Theorem every_state s v : above_floor P s -> leaves P s v -> outcome s v.
Proof.
  intros Hs Hl. apply (outcome_flight s v Hs Hl). intros T v' HT Hf Hok HB. destruct (bounced_out _ _ _ Hok HB);
    [now apply heavy_out_outcome | now apply light_out_outcome].
Qed.
(** In flight: a motion for all times, or a corner later or before. *)
Theorem every_flight s v : 0 < y1 P s -> 0 < y2 P s ->
  (exists p, motion P p /\ p 0 = s /\ before p 0 v /\ after p 0 v) \/ runs_into_corner s v \/
  runs_into_corner s (minus_v v).
Proof.
  intros H1 H2. assert (A1 := arm1_pos P HP). assert (A2 := arm2_pos P HP). assert (Hok : above_floor P s).
  { split; [|lra]. unfold y1, y2 in *. apply Rmult_lt_reg_l with (arm1 P + arm2 P); [lra|].
    assert (0 < arm2 P * (height s + arm1 P * sin (angle s))) by (apply Rmult_lt_0_compat; lra).
    assert (0 < arm1 P * (height s - arm2 P * sin (angle s))) by (apply Rmult_lt_0_compat; lra). lra. }
  assert (Hl : forall w, leaves P s w) by (intros w; split; lra).
  destruct (every_state s v Hok (Hl v)) as [[pX [X1 [X2 X3]]]|]; [|right; now left].
  destruct (every_state s (minus_v v) Hok (Hl _)) as [[pS [S1 [S2 S3]]]|]; [|right; now right]. left.
  set (p := glue 0 (reverse pS) pX). assert (E0 : reverse pS 0 = s) by (unfold reverse; now rewrite Ropp_0).
  assert (Eat : p 0 = s) by (unfold p; now rewrite glue_at).
  assert (Hb : before p 0 v).
  { apply glue_before. replace v with (minus_v (minus_v v)) by (apply vel_eq; simpl; ring). apply reverse_before.
    now rewrite Ropp_0. }
  assert (Ha : after p 0 v) by (apply glue_after; [now rewrite E0 | exact X2]).
  exists p. split; [|now repeat split]. apply lawful_motion. intros t. destruct (Rtotal_order t 0) as [L|[->|L]].
  - apply near_lawful with (reverse pS); [now apply glue_left|]. apply reverse_lawful, S3. lra.
  - unfold lawful. rewrite Eat. repeat split; try lra. exists v, v. split; [exact Hb|]. split; [exact Ha | now left].
  - apply near_lawful with (shift 0 pX); [now apply glue_right|]. apply shift_lawful, X3. lra.
Qed.
End General.
