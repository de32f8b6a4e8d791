(** What the statement means: N(q) exists, is unique, is less than q + 5 (L2 (c)), depends on the ratio only, and may be read
    with the masses exchanged. No certificate is used. *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Physics Ray Chart Flight Collisions LightTotal WitnessMotion.
Local Open Scope R_scope.

(* ---------- L5 (f), L2 (c) with their numbers ---------- *)
Lemma L5f_few_hits r n : 0 < r <= 1 -> forall c k, - r <= k -> coll r n c k -> 2 * r * INR n < 1 + 4 * r.
Proof.
  intros Hr c k Hk H. destruct (Rle_or_lt 0 k) as [K|K].
  - destruct n as [|n]; [simpl INR; lra|]. assert (F := TurningCollision.L5f_slopes_grow r n ltac:(lra) c k K H). rewrite S_INR. lra.
  - destruct n as [|[|n]]; [simpl INR; lra | simpl INR; lra|]. destruct H as [x [Hx [H|[HD H]]]]; [discriminate|].
    destruct (next_domain c k r x ltac:(lra) Hk Hx HD) as [Q _].
    assert (F := TurningCollision.L5f_slopes_grow r n ltac:(lra) _ _ ltac:(assert (0 <= next_slope (cos x) k r) by lra; eassumption) H). rewrite !S_INR. lra.
Qed.
Lemma L5f_few_both r a b n ca ka cb kb : 0 < r <= 1 -> / r + 4 <= INR n -> - r <= ka -> - r <= kb -> coll r a ca ka -> coll r b cb kb -> (1 + a + b <= n)%nat.
Proof.
  intros Hr Hn Ha Hb Ca Cb. assert (A := L5f_few_hits r a Hr ca ka Ha Ca). assert (B := L5f_few_hits r b Hr cb kb Hb Cb).
  assert (K : INR (1 + a + b) < INR (n + 1)).
  { rewrite !plus_INR. simpl (INR 1). assert (2 * r * (/ r + 4) <= 2 * r * INR n) by (apply Rmult_le_compat_l; lra).
    replace (2 * r * (/ r + 4)) with (2 + 8 * r) in H by (field; lra). apply Rmult_lt_reg_l with (2 * r); lra. }
  apply INR_lt in K. lia.
Qed.
Theorem L2c_below_q_plus_5 q n : 1 <= q -> q + 4 <= INR n -> upper_bound q n.
Proof.
  intros Hq Hn. assert (H1 := Rinv_0_lt_compat q ltac:(lra)). assert (H2 : / q <= 1) by (rewrite <- Rinv_1; apply Rinv_le_contravar; lra).
  assert (HPI : 0 < PI) by apply PI_RGT_0. assert (Hn' : / / q + 4 <= INR n) by (rewrite Rinv_inv; exact Hn). apply charts_upper; [exact Hq | |].
  - intros e eta a b He Heta _ Ca Cb. destruct (cos_range e ltac:(lra)) as [W0 W1].
    apply (L5f_few_both (/ q) a b n _ _ _ _ ltac:(lra) Hn') with (3 := Ca) (4 := Cb).
    + unfold lamX. assert (0 <= / q * (cos e + eta)) by (apply Rmult_le_pos; lra). lra.
    + assert (L := lamS_ge e eta (/ q) ltac:(lra) ltac:(lra) ltac:(lra)). assert (/ q * -1 <= / q * lamS e eta (/ q)) by (apply Rmult_le_compat_l; lra). lra.
  - intros e lam a b He Hlam _ HP Ca Cb Cb0. assert (L1 : 0 <= / q * lam) by (apply Rmult_le_pos; lra).
    destruct (Rlt_or_le 0 (mu_den (cos e) lam (/ q))) as [HD|HD].
    + apply (L5f_few_both (/ q) a b n _ _ _ _ ltac:(lra) Hn') with (3 := Ca) (4 := Cb HD); [lra|].
      assert (0 <= mu (cos e) lam (/ q)) by (unfold mu; apply Rmult_le_pos; [exact HP | left; now apply Rinv_0_lt_compat]).
      assert (0 <= / q * mu (cos e) lam (/ q)) by (apply Rmult_le_pos; lra). lra.
    + apply (L5f_few_both (/ q) a b n (cL e (/ q * lam)) (/ q * lam) 0 0 ltac:(lra) Hn'); try lra; [exact Ca | rewrite (Cb0 HD); exact I].
Qed.

(* ---------- lists ---------- *)
Lemma at_least_le P p m n : (m <= n)%nat -> at_least P p n -> at_least P p m.
Proof.
  intros Hm [l [H1 [H2 H3]]]. exists (firstn m l). split; [|split].
  - rewrite <- (firstn_skipn m l) in H1. clear - H1. induction (firstn m l) as [|x s IH]; [constructor|]. simpl in H1. apply NoDup_cons_iff in H1. destruct H1 as [A B].
    constructor; [intros K; apply A, in_app_iff; now left | now apply IH].
  - rewrite firstn_length. lia.
  - intros t Ht. apply H3. rewrite <- (firstn_skipn m l). apply in_app_iff. now left.
Qed.
Definition unit_dumbbell q := {| m1 := 1; m2 := q; ell := 1 |}.
Lemma unit_real q : 0 < q -> real_dumbbell (unit_dumbbell q) /\ m2 (unit_dumbbell q) / m1 (unit_dumbbell q) = q.
Proof. intros Hq. unfold real_dumbbell, unit_dumbbell; simpl. split; [lra | field]. Qed.
Theorem N_unique q m n : 0 < q -> N_star q m -> N_star q n -> m = n.
Proof.
  assert (G : forall m n, 0 < q -> N_star q m -> N_star q n -> (m <= n)%nat).
  { clear m n. intros m n Hq [_ L] [U _]. destruct (unit_real q Hq) as [H1 H2]. destruct (L _ H1 H2) as [p [Hm [l [A [B C]]]]]. rewrite <- B. exact (U _ p H1 H2 Hm l A C). }
  intros Hq H K. assert (A := G m n Hq H K). assert (B := G n m Hq K H). lia.
Qed.

(* ---------- scaling: only the ratio matters ---------- *)
Section Scale.
Variables P Q : dumbbell.
Hypothesis HP : real_dumbbell P.
Hypothesis HQ : real_dumbbell Q.
Hypothesis HR : m2 P / m1 P = m2 Q / m1 Q.
Definition factor := ell Q / ell P.
Notation f := factor.
Lemma factor_pos : 0 < f. Proof. destruct HP as [? [? ?]], HQ as [? [? ?]]. now apply Rdiv_lt_0_compat. Qed.
Lemma ratios : m2 P * m1 Q = m2 Q * m1 P.
Proof.
  destruct HP as [? [? ?]], HQ as [? [? ?]]. replace (m2 P * m1 Q) with (m2 P / m1 P * (m1 P * m1 Q)) by (field; lra). rewrite HR. field. lra.
Qed.
Lemma scale_arms : arm1 Q = f * arm1 P /\ arm2 Q = f * arm2 P.
Proof.
  assert (E := ratios). destruct HP as [? [? ?]], HQ as [? [? ?]].
  assert (K : forall a b, a * (m1 P + m2 P) = b * (m1 Q + m2 Q) -> ell Q * (a / (m1 Q + m2 Q)) = f * (ell P * (b / (m1 P + m2 P)))).
  { intros a b Hab. replace (a / (m1 Q + m2 Q)) with (a * (m1 P + m2 P) / ((m1 Q + m2 Q) * (m1 P + m2 P))) by (field; lra).
    rewrite Hab. unfold f. field. lra. }
  unfold arm1, arm2, mass. split; apply K; lra.
Qed.
Definition scale_pos (s : pos) := {| height := f * height s; angle := angle s |}.
Definition scale_v (v : vel) := {| vy := f * vy v; om := om v |}.
Definition scale (p : R -> pos) t := scale_pos (p t).
Lemma scale_y s : y1 Q (scale_pos s) = f * y1 P s /\ y2 Q (scale_pos s) = f * y2 P s.
Proof. destruct scale_arms as [E1 E2]. unfold y1, y2, scale_pos; simpl. rewrite E1, E2. split; ring. Qed.
Lemma scale_w s v : w1 Q (scale_pos s) (scale_v v) = f * w1 P s v /\ w2 Q (scale_pos s) (scale_v v) = f * w2 P s v.
Proof. destruct scale_arms as [E1 E2]. unfold w1, w2, scale_pos; simpl. rewrite E1, E2. split; ring. Qed.
Lemma scale_before p t v : before p t v -> before (scale p) t (scale_v v).
Proof. intros [e [He H]]. exists e. split; [exact He|]. intros s Hs. destruct (H s Hs) as [A B]. simpl. rewrite A, B. split; ring. Qed.
Lemma scale_after p t v : after p t v -> after (scale p) t (scale_v v).
Proof. intros [e [He H]]. exists e. split; [exact He|]. intros s Hs. destruct (H s Hs) as [A B]. simpl. rewrite A, B. split; ring. Qed.
Lemma scale_push l v v' : push P l v v' -> push Q (f * l) (scale_v v) (scale_v v').
Proof.
  intros [J [HJ [A [B C]]]]. assert (MP := mass_pos P HP). assert (MQ := mass_pos Q HQ). assert (F := factor_pos). destruct scale_arms as [E1 E2].
  assert (EI : inertia Q = mass Q / mass P * (f * f) * inertia P) by (rewrite (inertia_eq Q HQ), (inertia_eq P HP), E1, E2; field; lra).
  exists (mass Q / mass P * f * J). assert (K : 0 < mass Q / mass P) by (now apply Rdiv_lt_0_compat). simpl. repeat split.
  - apply Rmult_le_pos; [apply Rmult_le_pos; lra | exact HJ].
  - rewrite <- A. field. lra.
  - rewrite EI. replace (mass Q / mass P * (f * f) * inertia P * (om v' - om v)) with (mass Q / mass P * (f * f) * (inertia P * (om v' - om v))) by ring. rewrite B. ring.
  - unfold energy in *. simpl. rewrite EI.
    replace (mass Q * (f * vy v' * (f * vy v')) + mass Q / mass P * (f * f) * inertia P * (om v' * om v')) with (mass Q / mass P * (f * f) * (mass P * (vy v' * vy v') + inertia P * (om v' * om v'))) by (field; lra).
    replace (mass P * (vy v' * vy v') + inertia P * (om v' * om v')) with (mass P * (vy v * vy v) + inertia P * (om v * om v)) by lra. field. lra.
Qed.
Theorem scale_motion p : motion P p -> motion Q (scale p).
Proof.
  intros Hm. assert (F := factor_pos). destruct scale_arms as [E1 E2]. split; intros t; destruct (scale_y (p t)) as [Y1 Y2]; unfold scale.
  - rewrite Y1. apply Rmult_le_pos; [lra | apply Hm].
  - rewrite Y2. apply Rmult_le_pos; [lra | apply Hm].
  - rewrite Y1, Y2. intros [A B]. apply (regular P p Hm t). split; apply Rmult_eq_reg_l with f; lra.
  - destruct (law P p Hm t) as [v [v' [Hb [Ha H]]]]. exists (scale_v v), (scale_v v'). split; [now apply scale_before|]. split; [now apply scale_after|].
    rewrite Y1, Y2. unfold push1, push2. simpl. rewrite E1, E2. destruct H as [->|[[H0 H]|[H0 H]]]; [now left | right; left | right; right]; (split; [rewrite H0; ring|]).
    + replace (f * arm1 P * cos (angle (p t))) with (f * (arm1 P * cos (angle (p t)))) by ring. now apply scale_push.
    + replace (- (f * arm2 P * cos (angle (p t)))) with (f * - (arm2 P * cos (angle (p t)))) by ring. now apply scale_push.
Qed.
Lemma scale_collision p t : collision P p t -> collision Q (scale p) t.
Proof.
  intros [v [Hb H]]. assert (F := factor_pos). exists (scale_v v). split; [now apply scale_before|]. destruct (scale_y (p t)) as [Y1 Y2]. destruct (scale_w (p t) v) as [W1 W2].
  unfold scale. rewrite Y1, Y2, W1, W2. destruct H as [[A B]|[A B]]; [left | right]; (split; [rewrite A; ring|]).
  - assert (0 < f * - w1 P (p t) v) by (apply Rmult_lt_0_compat; lra). lra.
  - assert (0 < f * - w2 P (p t) v) by (apply Rmult_lt_0_compat; lra). lra.
Qed.
End Scale.
Theorem only_ratio q P p n : real_dumbbell P -> m2 P / m1 P = q -> motion P p -> at_least P p n -> lower_bound q n.
Proof.
  intros HP Hq Hm [l [A [B C]]] Q HQ Hqq. assert (E : m2 P / m1 P = m2 Q / m1 Q) by congruence. exists (scale P Q p). split; [now apply scale_motion|].
  exists l. split; [exact A|]. split; [exact B|]. intros t Ht. apply scale_collision; auto.
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
    { replace (r_of P) with (/ q); [rewrite <- Rinv_1; apply Rinv_le_contravar; lra|]. unfold r_of. destruct HP as [? [? ?]]. rewrite <- Hqq. field. lra. }
    destruct (bridge_motion P HP R1 (PI/2) 1 O O ltac:(lra) ltac:(lra) I I) as [p [Hp Hl]]. exists p. split; [exact Hp|]. apply at_least_le with (2 := Hl). lia. }
  assert (G : forall k, upper_bound q k -> exists n, (n <= k)%nat /\ N_star q n).
  { induction k as [|k IH]; intros Hk.
    - exists O. split; [lia|]. now split.
    - destruct (Classical_Prop.classic (upper_bound q k)) as [K|K]; [destruct (IH K) as [n [N1 N2]]; exists n; split; [lia | exact N2]|].
      exists (S k). split; [lia|]. split; [exact Hk|]. apply Classical_Prop.NNPP. intros NL. apply K. intros P p HP Hqq Hp l Hnd Hl.
      destruct (Nat.le_gt_cases (length l) k) as [|Q]; [assumption|]. exfalso. apply NL. apply (only_ratio q P p (S k) HP Hqq Hp).
      apply at_least_le with (length l); [lia|]. exists l. repeat split; assumption. }
  destruct (G _ U) as [n [N1 N2]]. exists n. split; [exact N2|]. apply le_INR in N1. lra.
Qed.
