(** L4, L5 (d) for half motions: what begins as the flight of a ray (c, k), and obeys the law at all later times, has
    no more collisions than the ray: F <= G. `Follow.v` says so of motions for all times; here nothing is known of the
    past.

    future_count           == a half motion out of a ray has at most the ray's collisions
    later_from, later_near == later collisions from a list of times, and of two paths that agree *)
From Coq Require Import Reals Lra Lia List FinFun.
From Dumbbell Require Import Physics Ray StartRay Flight Collisions Symmetry Existence RayFuture Determinism.
Local Open Scope R_scope.

Section Half.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.
Hypothesis Hr1 : r_of P <= 1.
Notation r := (r_of P).

(** No collision where the velocity does not change. *)
Lemma free_no_collision p t v e : 0 < e -> (forall s, t < s < t + e -> lawful P p s) -> before p t v -> after p t v ->
  ~ collision P p t.
Proof.
  intros He Hg Hb Ha [v0 [Hb0 H]]. assert (v0 = v) by (apply before_unique with p t; assumption). subst v0.
  destruct (must_turn P HP p t e v He Hg Ha) as [M1 M2].
  destruct H as [[A B]|[A B]]; [specialize (M1 A) | specialize (M2 A)]; lra.
Qed.
Lemma line_no_collision s v t : (forall t', t < t' -> free P (line s v t')) -> ~ collision P (line s v) t.
Proof.
  intros Hf. apply free_no_collision with v 1; [lra | | apply line_before | apply line_after].
  intros t' Ht. apply (line_lawful P HP), Hf. lra.
Qed.

(** Lists of collisions. *)
Lemma later_from p t0 n l : NoDup l -> (n <= length l)%nat -> (forall t, In t l -> t0 < t /\ collision P p t) ->
  later P p t0 n.
Proof.
  intros Hnd Hn Hl. rewrite <- (firstn_skipn n l) in Hnd, Hl. exists (firstn n l). split; [|split].
  - clear - Hnd. induction (firstn n l) as [|x s IH]; [constructor|]. simpl in Hnd. apply NoDup_cons_iff in Hnd.
    destruct Hnd as [A B]. constructor; [intros K; apply A, in_app_iff; now left | now apply IH].
  - apply firstn_length_le, Hn.
  - intros t Ht. apply Hl, in_app_iff. now left.
Qed.
Lemma later_near p q t0 n : (forall t, t0 < t -> p t = q t) -> later P p t0 n -> later P q t0 n.
Proof.
  intros H [l [A [B C]]]. exists l. split; [exact A|]. split; [exact B|]. intros t Ht. destruct (C t Ht) as [D E].
  split; [exact D|].
  apply near_collision with p; [|exact E]. exists ((t - t0) / 2). split; [lra|]. intros s Hs. apply H. lra.
Qed.
Lemma remove_length (x : R) l : NoDup l -> (length l <= S (length (remove Req_EM_T x l)))%nat.
Proof.
  induction l as [|y l IH]; intros H; simpl; [lia|]. apply NoDup_cons_iff in H. destruct H as [H0 H].
  destruct (Req_EM_T x y) as [->|N]; [rewrite notin_remove by exact H0; lia | simpl; specialize (IH H); lia].
Qed.
Lemma NoDup_remove_R (x : R) l : NoDup l -> NoDup (remove Req_EM_T x l).
Proof.
  induction l as [|y l IH]; intros H; simpl; [constructor|]. apply NoDup_cons_iff in H. destruct H as [H0 H].
  destruct (Req_EM_T x y) as [|N]; [now apply IH|]. constructor; [|now apply IH].
  intros K. apply H0. now apply in_remove in K.
Qed.
(** The collisions after 0 but the first, seen from its time T on. *)
Lemma later_rest p T n : 0 <= T -> (forall t, 0 < t < T -> ~ collision P p t) -> later P p 0 (S n) ->
  later P (shift (- T) p) 0 n.
Proof.
  intros HT Hno [l [A [B C]]]. apply later_from with (map (fun t => t - T) (remove Req_EM_T T l)).
  - apply Injective_map_NoDup; [intros x y E; lra | now apply NoDup_remove_R].
  - rewrite map_length. assert (K := remove_length T l A). lia.
  - intros t Ht. apply in_map_iff in Ht. destruct Ht as [s [<- Hs]]. apply in_remove in Hs. destruct Hs as [Hs Ns].
    destruct (C s Hs) as [D E]. split.
    + apply Rnot_le_lt. intros K. apply (Hno s); [lra | exact E].
    + apply shift_collision. now replace (s - T - - T) with s by ring.
Qed.
Lemma later_none p n : (forall t, 0 < t -> ~ collision P p t) -> later P p 0 n -> n = O.
Proof.
  intros H [[|t l] [_ [E C]]]; [now rewrite <- E|]. exfalso. destruct (C t (or_introl eq_refl)) as [A B].
  now apply (H t).
Qed.

(** Determinism of half motions. *)
Lemma future_agree s v p q : future P s v p -> future P s v q -> forall t, 0 <= t -> p t = q t.
Proof.
  intros [A1 [A2 A3]] [B1 [B2 B3]] t Ht.
  apply (agree P HP p q 0 (t + 1) v); [intros u Hu; apply A3; lra | intros u Hu; apply B3;
    lra | congruence | exact A2 | exact B2 | lra].
Qed.
Lemma future_line_none s v p n : (forall t, 0 < t -> free P (line s v t)) -> future P s v p -> later P p 0 n -> n = O.
Proof.
  intros Hf F L. apply later_none with (line s v).
  - intros t Ht. apply line_no_collision. intros t' Ht'. apply Hf. lra.
  - apply later_near with (2 := L). intros t Ht. apply (future_agree s v); [exact F | now apply future_line | lra].
Qed.

(** A half motion that begins with a free flight until T, where the light mass comes down on the floor, is turned
    there. *)
Lemma turned_at s0 v T p : 0 < T -> future P s0 v p -> (forall t, 0 < t <= T -> free P (line s0 v t)) ->
  y1 P (line s0 v T) = 0 -> w1 P (line s0 v T) v < 0 ->
  exists v', push1 P (line s0 v T) v v' /\ v' <> v /\ future P (line s0 v T) v' (shift (- T) p) /\
    forall t, 0 < t < T -> ~ collision P p t.
Proof.
  intros HT [F1 [F2 F3]] Hf Hy Hw. set (s1 := line s0 v T) in *.
  assert (Ag : forall t, 0 <= t < T -> p t = line s0 v t).
  { apply (agree P HP p (line s0 v) 0 T v); [intros t Ht; apply F3;
      lra | | now rewrite line_0 | exact F2 | apply line_after].
    intros t Ht. apply (line_lawful P HP), Hf. lra. }
  destruct (F3 T HT) as [_ [_ [Rg [u [v' [Hb [Ha HL]]]]]]].
  destruct (agree_at p (line s0 v) 0 T u v HT Ag Hb (line_before s0 v T)) as [ET ->]. fold s1 in ET.
  rewrite ET in Rg, HL.
  assert (Nv : v' <> v).
  { intros ->. destruct (must_turn P HP p T 1 v ltac:(lra)) as [M _]; [intros t Ht; apply F3; lra | exact Ha|].
    rewrite ET in M. specialize (M Hy). lra. }
  destruct HL as [|[[_ Hp]|[K _]]]; [contradiction | | exfalso; apply Rg; now split].
  exists v'. split; [exact Hp|]. split; [exact Nv|]. split.
  - split; [unfold shift; replace (0 - - T) with T by ring; exact ET|]. split.
    + apply shift_after. now replace (0 - - T) with T by ring.
    + intros t Ht. apply shift_lawful, F3. lra.
  - intros t Ht. assert (N : near (line s0 v) p t).
    { exists (Rmin t (T - t) / 2). assert (Rmin t (T - t) <= t) by apply Rmin_l.
      assert (Rmin t (T - t) <= T - t) by apply Rmin_r.
      assert (0 < Rmin t (T - t)) by (apply Rmin_pos; lra). split; [lra|]. intros s Hs. symmetry. apply Ag. lra. }
    apply free_no_collision with v (T - t); [lra | intros s Hs; apply F3; lra | |].
    + apply near_before with (1 := N), line_before.
    + apply near_after with (1 := N), line_after.
Qed.

Lemma future_mirrored s v p : future P s v p -> future P (mirror_pos s) (mirror_v v) (mirror p).
Proof.
  intros F. apply (future_mirror P). replace (mirror_pos (mirror_pos s)) with s by (apply pos_eq; simpl; ring).
  now replace (mirror_v (mirror_v v)) with v by (apply vel_eq; simpl; ring).
Qed.

(** F <= G. *)
Theorem future_count n : forall s0 v c k p, start_ray P s0 v c k -> - r <= k -> future P s0 v p -> later P p 0 n ->
  coll r n c k.
Proof.
  assert (R0 := r_pos P HP). induction n as [|n IH]; [easy|]. intros s0 v c k p HR Hk F L.
  assert (Hc := start_ray_height_pos P _ _ _ _ HR).
  destruct (Classical_Prop.classic (exists x, hit c k x)) as [[x Hx]|Hmiss].
  2: { exfalso. assert (S n = O); [|discriminate]. apply (future_line_none s0 v p (S n)) with (2 := F) (3 := L).
       intros t Ht. apply (ray_free P HP s0 v c k t HR Ht). intros X HX _.
       apply (over_miss P HP Hr1); try assumption. exact (sr_below _ _ _ _ _ HR). }
  destruct (hit_state P HP s0 v c k x HR Hx) as [T [HT [E1 [E2 [Hx0 [Hf [Hy Hw]]]]]]].
  destruct (turned_at s0 v T p HT F Hf Hy Hw) as [v' [Hpush [Hne [F2 Hno]]]]. set (s1 := line s0 v T) in *.
  assert (L2 := later_rest p T n ltac:(lra) Hno L). set (p2 := shift (- T) p) in *.
  assert (Hu := sr_left _ _ _ _ _ HR). assert (Hs := sr_slope _ _ _ _ _ HR).
  destruct (L0_reflection1 P HP s1 v v' Hpush) as [|HL]; [contradiction|]. unfold slope1 in HL.
  rewrite E1, sin_left in HL.
  destruct (reflected_velocity P HP x k v v' Hu Hs HL) as [Bu [Bv Bn]].
  assert (Hq : 0 < cos x * cos x + r) by (assert (0 <= cos x * cos x) by apply Rle_0_sqr; lra).
  exists x. split; [exact Hx|]. destruct (Rlt_or_le 0 (slope_den (cos x) k r)) as [HD|HD].
  - right. split; [exact HD|]. destruct (next_domain c k r x R0 Hk Hx HD) as [Q1 Q2].
    set (k' := next_slope (cos x) k r) in *.
    assert (Hup : 0 < u_of v') by (rewrite Bu; apply Rmult_lt_0_compat; [lra | now apply Rdiv_lt_0_compat]).
    assert (Hkk : k' * u_of v' = v_of P v') by (rewrite Bu, Bv; unfold k', next_slope; field; lra).
    assert (SR := next_start_ray P HP s1 v' x k' E1 E2 Hx0 Hup Hkk Q1).
    apply (IH _ _ _ _ (mirror p2) SR); [lra | now apply future_mirrored | now apply later_mirror].
  - left. assert (Hul : u_of v' <= 0).
    { rewrite Bu. assert (0 <= - slope_den (cos x) k r * / (cos x * cos x + r)).
      { apply Rmult_le_pos; [lra | left; now apply Rinv_0_lt_compat]. }
      assert (0 <= - u_of v * (- slope_den (cos x) k r * / (cos x * cos x + r))) by (apply Rmult_le_pos; lra).
      unfold Rdiv.
      lra. }
    apply (future_line_none s1 v' p2 n) with (2 := F2) (3 := L2).
    intros t Ht. assert (0 <= - u_of v' * t) by (apply Rmult_le_pos; lra).
    apply over_free with (x - u_of v' * t); [rewrite line_psi, E1; ring|].
    apply (over_tangent P HP Hr1) with x; [exact Hx0 | lra|].
    rewrite (line_yh P HP), E2. assert (0 < (v_of P v' + cos x * u_of v') * t) by (now apply Rmult_lt_0_compat). lra.
Qed.
End Half.
