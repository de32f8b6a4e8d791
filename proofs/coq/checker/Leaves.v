(** What a leaf and a witness of a certificate must satisfy (docs/reference/format.md, sections 3.3 to 3.6), computed
    with intervals, and that it is enough: L8 (a), (b), L9, L10 and L11 over a whole box. Generic in the numbers.

    most_steps, fuel                         == the most collisions that are counted; a hint as a number of steps
    bridge_holds, light_holds                == what a leaf of the two charts says of a point
    check_reason, check_contact, above_corner == a leaf, a witness is right, computed
    check_bridge_sound, check_light_sound, check_contact_sound == and what it says is so, all over its box *)
From Coq Require Import Reals ZArith NArith Lra Lia List Bool.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core.Raux Core.Zaux.
From Interval Require Import Real.Xreal Float.Basic Float.Sig Interval.Interval Interval.Float Interval.Float_full.
From Dumbbell Require Import Trigonometry Ray Chart Enclosure SineCosine Count Certificate FloatBoxes.
Local Open Scope R_scope.

(** The slope is steep (r eta >= 1, or r lambda) on the whole box, exactly. *)
Definition too_steep (b : box) : bool := (high_end (box_q b) * Zpos (part (box_slope b)) <=? low_end (box_slope b) *
  Zpos (part (box_q b)))%Z.
Lemma too_steep_sound b e y q : too_steep b = true -> in_box e y q b -> 1 <= q -> / q * y < 1 -> False.
Proof.
  unfold too_steep, in_box, in_span. intros H [_ [Hy Hq]] Hq1 Hlt. apply Z.leb_le, IZR_le in H. rewrite !mult_IZR in H.
  assert (A : 0 < IZR (Zpos (part (box_q b)))) by now apply IZR_lt. assert (B : 0 < IZR (Zpos (part (box_slope b))))
    by now apply IZR_lt.
  set (a := IZR (Zpos (part (box_q b)))) in *. set (c := IZR (Zpos (part (box_slope b)))) in *.
  assert (K : IZR (high_end (box_q b)) / a <= IZR (low_end (box_slope b)) / c).
  { apply Rmult_le_reg_r with (a * c); [now apply Rmult_lt_0_compat|]. replace (IZR (high_end (box_q b)) / a * (a * c))
    with (IZR (high_end (box_q b)) * c) by (field; lra).
    replace (IZR (low_end (box_slope b)) / c * (a * c)) with (IZR (low_end (box_slope b)) * a) by (field; lra).
      exact H. }
  assert (Y : y < q); [|lra]. apply Rmult_lt_reg_l with (/ q); [apply Rinv_0_lt_compat; lra|].
    rewrite (Rinv_l q) by lra. exact Hlt.
Qed.

(** A hint as the number of steps to try; no ray of a file that is read collides more often than [most_steps]. *)
Definition most_steps : N := 1000000.
Definition fuel (n : N) : nat := N.to_nat (N.min n most_steps).
Lemma fuel_le n : (N.of_nat (fuel n) <= n)%N. Proof. unfold fuel. rewrite N2Nat.id. apply N.le_min_l. Qed.

(** L8 and L9 at one point of a chart: at most U collisions. *)
Definition bridge_holds U e eta r := 0 < e <= PI/2 -> 0 <= eta -> 0 < r <= 1 -> r * eta < 1 -> forall a b,
  coll r a (r * cX e eta) (r * lamX e eta) -> coll r b (r * cS e eta r) (r * lamS e eta r) -> (1 + a + b <= U)%nat.
Definition light_holds U e lam r := 0 < e <= PI/2 -> 0 <= lam -> 0 < r <= 1 -> r * lam < 1 -> forall a b,
  0 <= 2 * cos e + r * lam - lam * (cos e * cos e) ->
  above_bridge r e (r * lam) -> (0 < mu_den (cos e) lam r -> above_bridge r e (r * mu (cos e) lam r)) ->
  coll r a (cL e (r * lam)) (r * lam) ->
  (0 < mu_den (cos e) lam r -> coll r b (cL e (r * mu (cos e) lam r)) (r * mu (cos e) lam r)) ->
  (mu_den (cos e) lam r <= 0 -> b = O) -> (1 + a + b <= U)%nat.

Module Leaves (F : FloatOps with Definition sensible_format := true).
Module Export Z := Count F.
Module Export B := FloatBoxes F.

Section S.
Variable p : F.precision.
Variable G : guesses.
Variable T : consts.
Notation S := I.singleton.
Notation round_box := (round_box p).

Definition le1 (f : F.type) : bool := F.real f && match F.cmp f (F.fromZ 1) with Xlt | Xeq => true | _ => false end.
Definition proper (b : fbox) : bool := nonneg (S (e0 b)) && nonneg (S (y0 b)) && pos (S (r0 b)) && le1 (r1 b).
Definition cut (e : F.type) : I.type := if nonneg (I.sub p (quarter T) (S e)) then S e else up (quarter T).
Definition XI (e y r : I.type) : I.type * I.type :=
  let '(s, w) := sc p G T e in let lam := I.add p w y in
  (I.mul p r (I.add p s (I.mul p lam (I.sub p (pi_ T) e))), I.mul p r lam).
(** sigma X with eta' at r, times r'. *)
Definition SI (e y r r' : I.type) : I.type * I.type :=
  let '(s, w) := sc p G T e in let t := I.add p (unit_ T) (I.mul p r (I.sqr p w)) in
  let lam := I.sub p (I.div p (I.mul p y t) (I.add p t (I.mul2 p (I.mul p (I.mul p r w) y)))) w in
  (I.mul p r' (I.add p s (I.mul p lam e)), I.mul p r' lam).

Definition leaf_bridge (U : N) (b : fbox) (na nb : N) : bool :=
  (1 + na + nb <=? U)%N && proper b &&
  let e := cut (e1 b) in nonneg (I.sub p (pi_ T) e) &&
  (let '(c, k) := XI e (S (y0 b)) (S (r0 b)) in at_most p G T (fuel na) (S (r0 b)) (low c) (low k) (first_guess G)) &&
  (let '(c, k) := SI (S (e0 b)) (S (y0 b)) (S (r1 b)) (S (r0 b)) in at_most p G T (fuel nb) (S (r0 b)) (low c) (low k)
    (first_guess G)).
Definition beyond_peak (b : fbox) : bool := pos (I.sub p (S (e0 b)) (quarter T)).
Definition dI (w rl r : I.type) := I.sub p (I.add p (I.sqr p w) (I.mul2 p (I.mul p rl w))) r.
Definition leaf_light (U : N) (b : fbox) (na nb : N) : bool :=
  (1 + na + nb <=? U)%N && proper b &&
  let e := S (e0 b) in let '(s, w) := sc p G T e in let r := S (r0 b) in
  (let k := I.mul p r (S (y0 b)) in at_most p G T (fuel na) r (low (I.add p s (I.mul p k (I.add p (pi_ T) e)))) (low k)
    (first_guess G)) &&
  (if nonneg (I.neg (dI w (I.mul p (S (r1 b)) (S (y1 b))) r)) then true else
   let rl := I.mul p r (S (y1 b)) in let D := dI w rl r in
   pos D && let k := low0 (I.mul p r (I.div p (I.sub p (I.add p (I.mul2 p w) rl) (I.mul p (S (y1 b)) (I.sqr p w))) D))
     in
   at_most p G T (fuel nb) r (low (I.add p s (I.mul p k (I.add p (pi_ T) e)))) k (first_guess G)).
Definition descends (b : fbox) : bool :=
  proper b && pos (I.sub p (quarter T) (S (e1 b))) &&
   let '(_, w) := sc p G T (S (e1 b)) in
   pos (I.sub p (I.mul p (S (y0 b)) (I.sub p (I.sqr p w) (S (r1 b)))) (I.mul2 p w)).

(** L9 (c): a ray from the wall R whose slope is at most r [slope] meets the bridge, for every e of the box. *)
Definition meets (b : fbox) (slope : I.type) : bool :=
  let e := S (e1 b) in let t := S (near_top G slope) in let '(s, _) := sc p G T e in let '(h, _) := sc p G T t in
  proper b && pos (I.sub p (quarter T) e) && pos t && pos (I.sub p (pi_ T) t) &&
  pos (I.sub p h (I.add p (I.div p s (S (r0 b))) (I.mul p slope (I.add p e t)))).
Definition meets_reversed (b : fbox) : bool :=
  let '(_, w) := sc p G T (S (e1 b)) in let r := S (r1 b) in
  proper b && pos (I.sub p (quarter T) (S (e1 b))) && pos (dI w (I.mul p (S (r0 b)) (S (y0 b))) r) &&
  (let rl := I.mul p r (S (y0 b)) in
   meets b (up0 (I.div p (I.sub p (I.add p (I.mul2 p w) rl) (I.mul p (S (y0 b)) (I.sqr p w))) (dI w rl r)))).

Definition enough (Vn na nb : N) : bool := ((Vn <=? 1 + na + nb) && (na <=? most_steps) && (nb <=? most_steps))%N.
Definition check_witness (r0 r1 e y : F.type) (na nb Vn : N) : bool :=
  enough Vn na nb && pos (S e) && pos (I.sub p (quarter T) (S e)) && pos (S y) && pos (S r0) && le1 r1 &&
  (let '(_, w) := sc p G T (S e) in pos (I.sub p (unit_ T) (I.mul p (S r1) (I.add p w (S y))))) &&
  (let '(c, k) := XI (S e) (S y) (S r1) in at_least p G T (fuel na) (S r1) (up c) (up k) (first_guess G)) &&
  (let '(c, k) := SI (S e) (S y) (S r0) (S r1) in at_least p G T (fuel nb) (S r1) (up c) (up k) (first_guess G)).

(* ---------- soundness ---------- *)
Hypothesis HT : T = mkconsts p.
Let piI := pi_in p T HT. Let quI := quarter_in p T HT. Let unI := unit_in p T HT.
Lemma vin f : inI (V f) (S f). Proof. exact (single_in f). Qed.

Lemma one_real : F.toX (F.fromZ 1) = Xreal 1.
Proof. now rewrite F.fromZ_correct. Qed.
Lemma le1_ok f : le1 f = true -> V f <= 1.
Proof.
  unfold le1, V. intros H. apply andb_prop in H; destruct H as [H1 H2].
  assert (K1 := F.classify_correct f). rewrite H1 in K1.
  assert (K2 := F.classify_correct (F.fromZ 1)). rewrite F.real_correct, one_real in K2.
  rewrite F.cmp_correct in H2. rewrite F.real_correct in H1.
  destruct (F.classify f); try discriminate K1. destruct (F.classify (F.fromZ 1)); try discriminate K2.
  rewrite one_real in H2. destruct (F.toX f) as [|x]; [discriminate|]. simpl in H2 |- *.
  destruct (Raux.Rcompare_spec x 1); try lra; discriminate.
Qed.
Lemma proper_ok b : proper b = true -> 0 <= V (e0 b) /\ 0 <= V (y0 b) /\ 0 < V (r0 b) /\ V (r1 b) <= 1.
Proof.
  unfold proper. intros H. apply andb_prop in H; destruct H as [H H4]. apply andb_prop in H; destruct H as [H H3].
    apply andb_prop in H; destruct H as [H1 H2].
  assert (A := nonneg_ok _ _ H1 (vin _)). assert (B := nonneg_ok _ _ H2 (vin _)). assert (C := pos_ok _ _ H3 (vin _)).
  assert (D := le1_ok _ H4). lra.
Qed.
Lemma XI_in e y r ei yi ri : inI e ei -> inI y yi -> inI r ri -> inI (r * cX e y) (fst (XI ei yi ri)) /\
  inI (r * lamX e y) (snd (XI ei yi ri)).
Proof.
  intros He Hy Hr. unfold XI. destruct (sc_ok p G T HT e ei He) as [Hs Hw]. destruct (sc p G T ei) as [s w].
    simpl in *. unfold cX, lamX.
  split; apply mul_in; try assumption; [|now apply add_in]. apply add_in; [assumption|].
    apply mul_in; [now apply add_in | now apply sub_in].
Qed.
Lemma SI_in e y r r' ei yi ri ri' : inI e ei -> inI y yi -> inI r ri -> inI r' ri' ->
  inI (r' * cS e y r) (fst (SI ei yi ri ri')) /\ inI (r' * lamS e y r) (snd (SI ei yi ri ri')).
Proof.
  intros He Hy Hr Hr'. unfold SI. destruct (sc_ok p G T HT e ei He) as [Hs Hw]. destruct (sc p G T ei) as [s w].
    simpl in *.
  assert (Ht : inI (1 + r * (cos e * cos e)) (I.add p (unit_ T) (I.mul p ri (I.sqr p w)))) by (apply add_in;
    [exact unI | apply mul_in; [assumption | now apply sqr_in]]).
  assert (Hl : inI (lamS e y r) (I.sub p (I.div p (I.mul p yi (I.add p (unit_ T) (I.mul p ri (I.sqr p w)))) (I.add p
    (I.add p (unit_ T) (I.mul p ri (I.sqr p w))) (I.mul2 p (I.mul p (I.mul p ri w) yi)))) w)).
  { unfold lamS, eta_reversed. apply sub_in; [|assumption]. apply div_in; [now apply mul_in|].
    apply add_in; [assumption|]. apply mul2_in. apply mul_in; [now apply mul_in | assumption]. }
  split; apply mul_in; try assumption. unfold cS. apply add_in; [assumption | now apply mul_in].
Qed.
Lemma cut_ok f e : e <= V f -> e <= PI/2 -> exists x, inI x (cut f) /\ e <= x.
Proof. intros H1 H2. unfold cut. destruct (nonneg _). - exists (V f). split; [apply vin | assumption].
  - destruct (up_ok _ _ quI) as [x [A B]]. exists x. split; [exact A | lra]. Qed.

(** From the ray at (r0 c, r0 lam) to (r c, r lam): L5 (d) or L10. *)
Lemma any_slope n c lam r r' : -1 <= lam -> 0 <= c -> 0 < r -> r <= r' -> r' <= 1 -> coll r' n (r'*c) (r'*lam) ->
  coll r n (r*c) (r*lam).
Proof.
  intros Hl Hc Hr Hr' H1 H. destruct (Rlt_or_le lam 0).
  - now apply L10_descending_rays with r'.
  - apply (coll_mono n) with (8 := H); try assumption; try (apply Rmult_le_compat_r; lra); try (apply Rmult_le_pos;
    lra).
    assert (0 <= r * lam) by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma leaf_bridge_sound U b na nb : leaf_bridge U b na nb = true -> forall e y r, inside b e y r ->
  bridge_holds (N.to_nat U) e y r.
Proof.
  unfold leaf_bridge. intros H e y r [He [Hy Hr]] He' Hy' Hr' Hlt a c Ha Hc.
  apply andb_prop in H; destruct H as [H H3]. apply andb_prop in H; destruct H as [HU Hp]. apply N.leb_le in HU.
  apply andb_prop in H3; destruct H3 as [H3 H5]. apply andb_prop in H3; destruct H3 as [H3 H4].
  destruct (proper_ok b Hp) as [P1 [P2 [P3 P4]]]. assert (HPI : 0 < PI) by apply PI_RGT_0.
  destruct (cut_ok (e1 b) e ltac:(lra) ltac:(lra)) as [ex [E1 E2]].
  assert (E3 := nonneg_ok _ _ H3 (sub_in p _ _ _ _ piI E1)).
  destruct (XI_in _ _ _ _ _ _ E1 (vin (y0 b)) (vin (r0 b))) as [X1 X2].
  destruct (XI (cut (e1 b)) (S (y0 b)) (S (r0 b))) as [ci ki]. simpl in X1, X2.
  destruct (low_ok _ _ X1) as [c1 [C1 C2]]. destruct (low_ok _ _ X2) as [k1 [K1 K2]].
  destruct (cos_range e ltac:(lra)) as [W1 W2].
  assert (Aa : (a <= fuel na)%nat).
  { apply (at_most_sound p G T HT (fuel na) _ _ _ _ H4 (V (r0 b)) c1 k1 (vin _) C1 K1 r (r * cX e y) (r * lamX e y));
    [|exact Ha].
    assert (M1 := cX_mono e ex y (V (y0 b)) ltac:(lra) E2 ltac:(lra) ltac:(lra) P2).
    assert (M2 := lamX_mono e ex y (V (y0 b)) ltac:(lra) E2 ltac:(lra) ltac:(lra)).
    assert (N1 : 0 <= lamX e y) by (unfold lamX; lra).
    assert (N2 : 0 <= cX e y). { unfold cX. assert (0 <= sin e) by (apply sin_ge_0; lra).
      assert (0 <= lamX e y * (PI - e)) by (apply Rmult_le_pos; lra). lra. }
    assert (V (r0 b) * cX ex (V (y0 b)) <= r * cX e y). { apply Rle_trans with (V (r0 b) * cX e y);
      [apply Rmult_le_compat_l; lra | apply Rmult_le_compat_r; lra]. }
    assert (V (r0 b) * lamX ex (V (y0 b)) <= r * lamX e y). { apply Rle_trans with (V (r0 b) * lamX e y);
      [apply Rmult_le_compat_l; lra | apply Rmult_le_compat_r; lra]. }
    assert (0 <= r * cX e y) by (apply Rmult_le_pos; lra). assert (0 <= r * lamX e y) by (apply Rmult_le_pos; lra).
    repeat split; lra. }
  destruct (SI_in _ _ _ _ _ _ _ _ (vin (e0 b)) (vin (y0 b)) (vin (r1 b)) (vin (r0 b))) as [Y1 Y2].
  destruct (SI (S (e0 b)) (S (y0 b)) (S (r1 b)) (S (r0 b))) as [ci' ki']. simpl in Y1, Y2.
  destruct (low_ok _ _ Y1) as [c2 [C3 C4]]. destruct (low_ok _ _ Y2) as [k2 [K3 K4]].
  assert (L1 := lamS_mono e (V (e0 b)) y (V (y0 b)) r (V (r1 b)) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)
    ltac:(lra) ltac:(lra) ltac:(lra)).
  assert (L2 := cS_mono e (V (e0 b)) y (V (y0 b)) r (V (r1 b)) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)
    ltac:(lra) ltac:(lra) ltac:(lra)).
  assert (L3 := lamS_ge (V (e0 b)) (V (y0 b)) (V (r1 b)) ltac:(lra) ltac:(lra) ltac:(lra)).
  assert (L4 := cS_ge (V (e0 b)) (V (y0 b)) (V (r1 b)) ltac:(lra) ltac:(lra) ltac:(lra)).
  set (lm := lamS (V (e0 b)) (V (y0 b)) (V (r1 b))) in *. set (cc := cS (V (e0 b)) (V (y0 b)) (V (r1 b))) in *.
  assert (Bb : (c <= fuel nb)%nat).
  { apply (at_most_sound p G T HT (fuel nb) _ _ _ _ H5 (V (r0 b)) c2 k2 (vin _) C3 K3 (V (r0 b)) (V (r0 b) * cc) (V (r0
    b) * lm)).
    - assert (0 <= V (r0 b) * cc) by (apply Rmult_le_pos; lra). assert (V (r0 b) * (-1) <= V (r0 b) * lm) by (apply
      Rmult_le_compat_l; lra). repeat split; lra.
    - apply any_slope with r; try lra. 
      apply (coll_mono c) with (8 := Hc); try lra; try (apply Rmult_le_compat_l; lra).
      + apply Rmult_le_pos; lra. + assert (r * (-1) <= r * lm) by (apply Rmult_le_compat_l; lra). lra. }
  assert (FA := fuel_le na). assert (FB := fuel_le nb). lia.
Qed.

Lemma beyond_peak_sound b e y r : beyond_peak b = true -> inside b e y r -> PI/2 < e.
Proof. unfold beyond_peak. intros H [He _]. assert (A := pos_ok _ _ H (sub_in p _ _ _ _ (vin _) quI)). lra. Qed.
Lemma dI_in w lam r r' wi rli ri : inI w wi -> inI (r' * lam) rli -> inI r ri -> inI (w*w + 2*(r'*lam*w) - r) (dI wi
  rli ri).
Proof. intros. unfold dI. apply sub_in; [|assumption]. apply add_in; [now apply sqr_in | apply mul2_in;
  now apply mul_in]. Qed.

Lemma leaf_light_sound U b na nb : leaf_light U b na nb = true -> forall e y r, inside b e y r ->
  light_holds (N.to_nat U) e y r.
Proof.
  unfold leaf_light. intros H e y r [He [Hy Hr]] He' Hy' Hr' Hlt a c HP _ _ Ha Hc Hc0.
  apply andb_prop in H; destruct H as [H H3]. apply andb_prop in H; destruct H as [HU Hp]. apply N.leb_le in HU.
  destruct (proper_ok b Hp) as [P1 [P2 [P3 P4]]]. assert (HPI : 0 < PI) by apply PI_RGT_0.
  destruct (sc_ok p G T HT _ _ (vin (e0 b))) as [Hs Hw]. destruct (sc p G T (S (e0 b))) as [s w]. simpl in Hs, Hw.
  apply andb_prop in H3; destruct H3 as [H4 H5].
  assert (Sm : sin (V (e0 b)) <= sin e) by (apply sin_mono; lra). assert (Cm : cos e <= cos (V (e0 b))) by (apply
    cos_mono; lra).
  assert (S0 : 0 <= sin e) by (apply sin_ge_0; lra). destruct (cos_range e ltac:(lra)) as [W1 W2].
  assert (Y0 : 0 <= r * y) by (apply Rmult_le_pos; lra). assert (Y1 : V (r0 b) * V (y0 b) <= r * y) by (apply mul_mono;
    lra).
  assert (Aa : (a <= fuel na)%nat).
  { assert (KI := mul_in p _ _ _ _ (vin (r0 b)) (vin (y0 b))).
    destruct (low_ok _ _ KI) as [k1 [K1 K2]].
    destruct (low_ok _ _ (add_in p _ _ _ _ Hs (mul_in p _ _ _ _ KI (add_in p _ _ _ _ piI (vin (e0 b)))))) as [c1 [C1
      C2]].
    apply (at_most_sound p G T HT (fuel na) _ _ _ _ H4 (V (r0 b)) c1 k1 (vin _) C1 K1 r (cL e (r*y)) (r*y));
      [|exact Ha].
    assert (V (r0 b) * V (y0 b) * (PI + V (e0 b)) <= r * y * (PI + e)) by (apply mul_mono; lra).
    assert (0 <= r * y * (PI + e)) by (apply Rmult_le_pos; lra). unfold cL. repeat split; lra. }
  assert (Bb : (c <= fuel nb)%nat).
  { destruct (Rle_or_lt (mu_den (cos e) y r) 0) as [D|D]. { rewrite (Hc0 D). lia. }
    destruct (nonneg (I.neg (dI w (I.mul p (S (r1 b)) (S (y1 b))) (S (r0 b))))) eqn:E1.
    { assert (A := nonneg_ok _ _ E1 (neg_in _ _ (dI_in _ _ _ _ _ _ _ Hw (mul_in p _ _ _ _ (vin (r1 b)) (vin (y1 b)))
      (vin (r0 b))))).
      assert (B := mu_den_upper (cos e) (cos (V (e0 b))) y (V (y1 b)) r (V (r0 b)) (V (r1 b)) ltac:(lra) ltac:(lra)
        ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)). lra. }
    apply andb_prop in H5; destruct H5 as [H5 H6].
    assert (RL := mul_in p _ _ _ _ (vin (r0 b)) (vin (y1 b))).
    assert (DIn := dI_in _ _ _ _ _ _ _ Hw RL (vin (r0 b))). assert (D0 := pos_ok _ _ H5 DIn).
    assert (M := mu_mono (cos e) (cos (V (e0 b))) y (V (y1 b)) r (V (r0 b)) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)
      ltac:(lra) ltac:(lra)).
    assert (Hor : 0 < r * y \/ 0 < cos e). { destruct (Rle_lt_or_eq_dec 0 (cos e) W1) as [|Z]; [now right | left].
      unfold mu_den in D. rewrite <- Z in D. lra. }
    specialize (M Hor D D0).
    assert (MU : 0 <= mu (cos e) y r) by (unfold mu; apply Rmult_le_pos; [exact HP | left; now apply Rinv_0_lt_compat]).
    assert (MR : 0 <= r * mu (cos e) y r) by (apply Rmult_le_pos; lra).
    assert (KI : inI (V (r0 b) * mu (cos (V (e0 b))) (V (y1 b)) (V (r0 b)))
      (I.mul p (S (r0 b)) (I.div p (I.sub p (I.add p (I.mul2 p w) (I.mul p (S (r0 b)) (S (y1 b)))) (I.mul p (S (y1 b))
        (I.sqr p w))) (dI w (I.mul p (S (r0 b)) (S (y1 b))) (S (r0 b)))))).
    { apply mul_in; [apply vin|]. unfold mu. apply div_in; [|exact DIn]. apply sub_in; [apply add_in;
      [now apply mul2_in | exact RL] | apply mul_in; [apply vin | now apply sqr_in]]. }
    destruct (low0_ok _ _ KI (r * mu (cos e) y r)) as [k1 [K1 K2]]; [|exact MR|].
    { destruct (Rle_or_lt 0 (mu (cos (V (e0 b))) (V (y1 b)) (V (r0 b)))) as [Q|Q].
      - apply Rle_trans with (V (r0 b) * mu (cos e) y r); [apply Rmult_le_compat_l; lra | apply Rmult_le_compat_r; lra].
      - assert (V (r0 b) * mu (cos (V (e0 b))) (V (y1 b)) (V (r0 b)) <= V (r0 b) * 0) by (apply Rmult_le_compat_l;
        lra). lra. }
    destruct (low_ok _ _ (add_in p _ _ _ _ Hs (mul_in p _ _ _ _ K1 (add_in p _ _ _ _ piI (vin (e0 b)))))) as [c1 [C1
      C2]].
    apply (at_most_sound p G T HT (fuel nb) _ _ _ _ H6 (V (r0 b)) c1 k1 (vin _) C1 K1 r (cL e (r * mu (cos e) y r)) (r
      * mu (cos e) y r)); [|now apply Hc].
    assert (k1 * (PI + V (e0 b)) <= r * mu (cos e) y r * (PI + e)) by (apply mul_mono; lra).
    assert (0 <= r * mu (cos e) y r * (PI + e)) by (apply Rmult_le_pos; lra). unfold cL. repeat split; lra. }
  assert (FA := fuel_le na). assert (FB := fuel_le nb). lia.
Qed.
Lemma descends_sound b e y r : descends b = true -> inside b e y r -> 0 < e <= PI/2 -> 0 < r <= 1 -> 0 <= y ->
  0 <= 2 * cos e + r * y - y * (cos e * cos e) -> False.
Proof.
  unfold descends. intros H Hin He' Hr' Hy0 HP.
  destruct Hin as [He [Hy Hr]]. apply andb_prop in H; destruct H as [H H3]. apply andb_prop in H; destruct H as [Hp H2].
  destruct (proper_ok b Hp) as [P1 [P2 [P3 P4]]].
  assert (A := pos_ok _ _ H2 (sub_in p _ _ _ _ quI (vin _))).
  destruct (sc_ok p G T HT _ _ (vin (e1 b))) as [Hs Hw]. destruct (sc p G T (S (e1 b))) as [s w]. simpl in Hw.
  assert (B := pos_ok _ _ H3 (sub_in p _ _ _ _ (mul_in p _ _ _ _ (vin (y0 b)) (sub_in p _ _ _ _ (sqr_in p _ _ Hw) (vin
    (r1 b)))) (mul2_in p _ _ Hw))).
  assert (W1 : 0 < cos (V (e1 b))) by (apply cos_pos; lra). assert (W2 : cos (V (e1 b)) <= cos e) by (apply cos_mono;
    lra).
  set (w1 := cos (V (e1 b))) in *. set (u := cos e) in *.
  assert (Q1 : 0 < w1 * w1 - V (r1 b)). { destruct (Rlt_or_le 0 (w1*w1 - V (r1 b))) as [|Q]; [assumption|].
    assert (V (y0 b) * (w1*w1 - V (r1 b)) <= 0) by (assert (0 <= V (y0 b) * - (w1*w1 - V (r1 b))) by (apply
    Rmult_le_pos; lra); lra). lra. }
  assert (Q2 : (w1 * w1 - V (r1 b)) * u <= (u * u - r) * w1).
  { assert (0 <= u * w1 * (u - w1)) by (repeat apply Rmult_le_pos; lra).
    assert (r * w1 <= V (r1 b) * u) by (apply mul_mono; lra). lra. }
  assert (Q3 : V (y0 b) * ((w1 * w1 - V (r1 b)) * u) <= y * ((u * u - r) * w1)). { apply mul_mono; try lra.
    apply Rmult_le_pos; lra. }
  assert (Q4 : 2 * w1 * u < V (y0 b) * (w1 * w1 - V (r1 b)) * u) by (apply Rmult_lt_compat_r; lra).
  assert (Q5 : w1 * (2 * u) < w1 * (y * (u * u - r))) by lra. apply Rmult_lt_reg_l in Q5; lra.
Qed.

Lemma meets_sound b slope m e y r : meets b slope = true -> inI m slope -> y <= m -> inside b e y r \/
  (V (e0 b) <= e <= V (e1 b) /\ V (r0 b) <= r <= V (r1 b)) -> 0 < e <= PI/2 -> 0 < r <= 1 -> 0 <= y ->
    above_bridge r e (r * y) -> False.
Proof.
  unfold meets. intros H Hm Hym Hin He Hr Hy HB.
  assert (HI : V (e0 b) <= e <= V (e1 b) /\ V (r0 b) <= r <= V (r1 b)) by (destruct Hin as [[A [_ B]]|[A B]];
    now split).
  destruct HI as [Ie Ir]. clear Hin.
  destruct (sc_ok p G T HT _ _ (vin (e1 b))) as [Hs _]. destruct (sc p G T (S (e1 b))) as [s w]. simpl in Hs.
  destruct (sc_ok p G T HT _ _ (vin (near_top G slope))) as [Hh _].
  destruct (sc p G T (S (near_top G slope))) as [h w']. simpl in Hh. set (t := V (near_top G slope)) in *.
  apply andb_prop in H; destruct H as [H H5]. apply andb_prop in H; destruct H as [H H4].
  apply andb_prop in H; destruct H as [H H3]. apply andb_prop in H; destruct H as [Hp H2].
  destruct (proper_ok b Hp) as [P1 [P2 [P3 P4]]].
  assert (A2 := pos_ok _ _ H2 (sub_in p _ _ _ _ quI (vin _))). assert (A3 := pos_ok _ _ H3 (vin _)). fold t in A3.
  assert (A4 := pos_ok _ _ H4 (sub_in p _ _ _ _ piI (vin _))). fold t in A4.
  assert (A5 := pos_ok _ _ H5 (sub_in p _ _ _ _ Hh (add_in p _ _ _ _ (div_in p _ _ _ _ Hs (vin (r0 b)))
    (mul_in p _ _ _ _ Hm (add_in p _ _ _ _ (vin (e1 b)) (vin (near_top G slope))))))). fold t in A5.
  specialize (HB t ltac:(lra)). assert (HPI : 0 < PI) by apply PI_RGT_0.
  assert (Q1 : sin e <= sin (V (e1 b))) by (apply sin_mono; lra). assert (Q2 : 0 <= sin e) by (apply sin_ge_0; lra).
  assert (Q3 : y * (e + t) <= m * (V (e1 b) + t)) by (apply mul_mono; lra).
  assert (Q4 : sin (V (e1 b)) <= r * (sin (V (e1 b)) / V (r0 b))).
  { apply Rle_trans with (V (r0 b) * (sin (V (e1 b)) / V (r0 b))); [right; field; lra|].
    apply Rmult_le_compat_r; [|lra]. apply Rmult_le_pos; [lra | left; now apply Rinv_0_lt_compat]. }
  assert (Q5 : r * (y * (e + t)) <= r * (m * (V (e1 b) + t))) by (apply Rmult_le_compat_l; lra).
  assert (Q6 : r * (sin (V (e1 b)) / V (r0 b) + m * (V (e1 b) + t)) < r * sin t) by (apply Rmult_lt_compat_l; lra).
  lra.
Qed.
Lemma meets_reversed_sound b e y r : meets_reversed b = true -> inside b e y r -> 0 < e <= PI/2 -> 0 < r <= 1 ->
  0 <= y ->
  0 <= 2 * cos e + r * y - y * (cos e * cos e) -> (0 < mu_den (cos e) y r -> above_bridge r e (r * mu (cos e) y r)) ->
    False.
Proof.
  unfold meets_reversed. intros H [Ie [Iy Ir]] He Hr Hy HP HB.
  destruct (sc_ok p G T HT _ _ (vin (e1 b))) as [_ Hw]. destruct (sc p G T (S (e1 b))) as [s w]. simpl in Hw.
  apply andb_prop in H; destruct H as [H H4]. apply andb_prop in H; destruct H as [H H3].
  apply andb_prop in H; destruct H as [Hp H2]. destruct (proper_ok b Hp) as [P1 [P2 [P3 P4]]].
  assert (A2 := pos_ok _ _ H2 (sub_in p _ _ _ _ quI (vin _))).
  assert (A3 := pos_ok _ _ H3 (dI_in _ _ _ _ _ _ _ Hw (mul_in p _ _ _ _ (vin (r0 b)) (vin (y0 b))) (vin (r1 b)))).
  assert (HPI : 0 < PI) by apply PI_RGT_0. set (w1 := cos (V (e1 b))) in *.
  assert (W1 : 0 < w1) by (apply cos_pos; lra). assert (W2 : w1 <= cos e) by (apply cos_mono; lra).
  set (l0 := V (y0 b)) in *. set (rl := V (r0 b)) in *. set (rh := V (r1 b)) in *.
  assert (L1 : rl * l0 <= rh * l0) by (apply Rmult_le_compat_r; lra).
  assert (L2 : rl * l0 <= r * y) by (apply mul_mono; lra).
  assert (D1 : 0 < mu_den w1 l0 rh).
  { unfold mu_den. assert (rl * l0 * w1 <= rh * l0 * w1) by (apply Rmult_le_compat_r; lra). lra. }
  assert (D2 : 0 < mu_den (cos e) y r).
  { unfold mu_den. assert (w1 * w1 <= cos e * cos e) by (apply Rmult_le_compat; lra).
    assert (rl * l0 * w1 <= r * y * cos e) by (apply mul_mono; try lra; apply Rmult_le_pos; lra). lra. }
  assert (M : mu (cos e) y r <= mu w1 l0 rh) by (apply mu_mono; try lra; now right).
  assert (M0 : 0 <= mu (cos e) y r) by (unfold mu; apply Rmult_le_pos; [exact HP | left; now apply Rinv_0_lt_compat]).
  assert (RH := mul_in p _ _ _ _ (vin (r1 b)) (vin (y0 b))).
  assert (DIn := dI_in _ _ _ _ _ _ _ Hw RH (vin (r1 b))).
  assert (MI : inI (mu w1 l0 rh) (I.div p (I.sub p (I.add p (I.mul2 p w) (I.mul p (S (r1 b)) (S (y0 b))))
    (I.mul p (S (y0 b)) (I.sqr p w))) (dI w (I.mul p (S (r1 b)) (S (y0 b))) (S (r1 b))))).
  { unfold mu. apply div_in; [|exact DIn]. apply sub_in; [apply add_in; [now apply mul2_in | exact RH]
      | apply mul_in; [apply vin | now apply sqr_in]]. }
  destruct (up0_ok _ _ MI) as [m [M1 M2]].
  apply (meets_sound b _ m e (mu (cos e) y r) r H4 M1); try assumption; try lra; [right; now split | exact (HB D2)].
Qed.
Lemma enough_ok Vn na nb : enough Vn na nb = true -> (N.to_nat Vn <= 1 + fuel na + fuel nb)%nat.
Proof.
  unfold enough, fuel. intros H. apply andb_prop in H; destruct H as [H H3]. apply andb_prop in H;
    destruct H as [H1 H2].
  apply N.leb_le in H1, H2, H3. rewrite !N.min_l by assumption. lia.
Qed.
Lemma check_witness_sound r0 r1 e y na nb Vn : check_witness r0 r1 e y na nb Vn = true ->
  forall r, V r0 <= r <= V r1 -> bridge_witness r (N.to_nat Vn).
Proof.
  unfold check_witness. intros H r Hr.
  apply andb_prop in H; destruct H as [H H9]. apply andb_prop in H; destruct H as [H H8]. apply andb_prop in H;
    destruct H as [H H7].
  apply andb_prop in H; destruct H as [H H6]. apply andb_prop in H; destruct H as [H H5]. apply andb_prop in H;
    destruct H as [H H4].
  apply andb_prop in H; destruct H as [H H3]. apply andb_prop in H; destruct H as [H1 H2]. apply enough_ok in H1.
  assert (A2 := pos_ok _ _ H2 (vin _)). assert (A3 := pos_ok _ _ H3 (sub_in p _ _ _ _ quI (vin _))).
    assert (A4 := pos_ok _ _ H4 (vin _)).
  assert (A5 := pos_ok _ _ H5 (vin _)). assert (A6 := le1_ok _ H6).
  destruct (sc_ok p G T HT _ _ (vin e)) as [Hs Hw]. destruct (sc p G T (S e)) as [s w] eqn:Esc. simpl in Hw.
  assert (A7 := pos_ok _ _ H7 (sub_in p _ _ _ _ unI (mul_in p _ _ _ _ (vin r1) (add_in p _ _ _ _ Hw (vin y))))).
    clear s w Esc Hs Hw H7.
  assert (HPI : 0 < PI) by apply PI_RGT_0. destruct (cos_range (V e) ltac:(lra)) as [W1 W2].
  destruct (XI_in _ _ _ _ _ _ (vin e) (vin y) (vin r1)) as [X1 X2]. destruct (XI (S e) (S y) (S r1)) as [ci ki].
    simpl in X1, X2.
  destruct (up_ok _ _ X1) as [c1 [C1 C2]]. destruct (up_ok _ _ X2) as [k1 [K1 K2]].
  destruct (SI_in _ _ _ _ _ _ _ _ (vin e) (vin y) (vin r0) (vin r1)) as [Y1 Y2].
    destruct (SI (S e) (S y) (S r0) (S r1)) as [ci' ki']. simpl in Y1, Y2.
  destruct (up_ok _ _ Y1) as [c2 [C3 C4]]. destruct (up_ok _ _ Y2) as [k2 [K3 K4]].
  assert (N1 : 0 <= lamX (V e) (V y)) by (unfold lamX; lra).
  assert (N2 : 0 <= cX (V e) (V y)). { unfold cX. assert (0 <= sin (V e)) by (apply sin_ge_0; lra).
    assert (0 <= lamX (V e) (V y) * (PI - V e)) by (apply Rmult_le_pos; lra). lra. }
  exists (V e), (V y), (fuel na), (fuel nb). split; [lra|]. split; [lra|]. split.
  { unfold lamX in *. assert (r * (cos (V e) + V y) <= V r1 * (cos (V e) + V y)) by (apply Rmult_le_compat_r; lra).
    lra. }
  split; [|split; [|exact H1]].
  - apply any_slope with (V r1); try lra.
    apply (at_least_sound p G T HT (fuel na) _ _ _ _ H8 (V r1) c1 k1 (vin _) C1 K1).
    assert (0 <= V r1 * cX (V e) (V y)) by (apply Rmult_le_pos; lra). assert (0 <= V r1 * lamX (V e) (V y)) by (apply
      Rmult_le_pos; lra). repeat split; lra.
  - assert (L3 := lamS_ge (V e) (V y) (V r0) ltac:(lra) ltac:(lra) ltac:(lra)).
    assert (L4 := cS_ge (V e) (V y) (V r0) ltac:(lra) ltac:(lra) ltac:(lra)).
    assert (L5 := lamS_ge (V e) (V y) r ltac:(lra) ltac:(lra) ltac:(lra)).
      assert (L6 := cS_ge (V e) (V y) r ltac:(lra) ltac:(lra) ltac:(lra)).
    assert (L1 := lamS_mono (V e) (V e) (V y) (V y) (V r0) r ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)
      ltac:(lra) ltac:(lra) ltac:(lra)).
    assert (L2 := cS_mono (V e) (V e) (V y) (V y) (V r0) r ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)
      ltac:(lra) ltac:(lra) ltac:(lra)).
    assert (K : coll r (fuel nb) (r * cS (V e) (V y) (V r0)) (r * lamS (V e) (V y) (V r0))).
    { apply any_slope with (V r1); try lra. apply (at_least_sound p G T HT (fuel nb) _ _ _ _ H9 (V r1) c2 k2 (vin _) C3
      K3).
      assert (0 <= V r1 * cS (V e) (V y) (V r0)) by (apply Rmult_le_pos; lra).
        assert (V r1 * (-1) <= V r1 * lamS (V e) (V y) (V r0)) by (apply Rmult_le_compat_l; lra). repeat split; lra. }
    apply (coll_mono (fuel nb)) with (8 := K); try lra; try (apply Rmult_le_compat_l; lra).
    + apply Rmult_le_pos; lra. + assert (r * (-1) <= r * lamS (V e) (V y) r) by (apply Rmult_le_compat_l; lra). lra.
Qed.

(** A box that begins above pi/2 is treated as if it began there (format.md, 3.3). *)
Definition capped (f : fbox) : fbox :=
  let l := I.lower (quarter T) in
  {| e0 := match F.cmp l (e0 f) with Xlt => l | _ => e0 f end; e1 := e1 f; y0 := y0 f; y1 := y1 f; r0 := r0 f; r1 :=
    r1 f |}.
Lemma capped_ok f e y r : F.real (I.lower (quarter T)) = true -> F.real (e0 f) = true -> inside f e y r ->
  inside (capped f) e y r.
Proof.
  intros R1 R2 [He [Hy Hr]]. split; [|split]; simpl; try assumption. split; [|apply He].
  assert (K := F.cmp_correct (I.lower (quarter T)) (e0 f)). destruct (F.cmp _ _); try lra.
  rewrite F.classify_correct in R1, R2. destruct (F.classify (I.lower (quarter T))) eqn:C1; try discriminate R1.
    destruct (F.classify (e0 f)) eqn:C2; try discriminate R2.
  unfold V in *. destruct (F.toX (I.lower (quarter T))) as [|a] eqn:X1; [discriminate K|].
    destruct (F.toX (e0 f)) as [|b] eqn:X2; [discriminate K|]. simpl in *.
  destruct (Raux.Rcompare_spec a b); try discriminate K. lra.
Qed.

(** A leaf of the chart bridge (or light) in a piece with at most [U] collisions. *)
Definition check_reason (U : N) (light : bool) (b : box) (why : reason) : bool :=
  let f := round_box b in boxed f b &&
  match why with
  | Count na nb => F.real (I.lower (quarter T)) && F.real (e0 f) && (if light then leaf_light else
    leaf_bridge) U (capped f) na nb
  | Outside => beyond_peak f || too_steep b || (light && descends f)
  | Meets => light && meets f (S (y1 f))
  | Meets_reversed => light && meets_reversed f
  | Forward _ | Plain _ | Once => false
  end.
Lemma check_bridge_sound U b why : check_reason U false b why = true -> forall e y q, in_box e y q b -> 1 <= q ->
  bridge_holds (N.to_nat U) e y (/ q).
Proof.
  unfold check_reason. intros H e y q Hin Hq. apply andb_prop in H; destruct H as [Hb H].
    assert (Hf := boxed_ok _ _ Hb e y q Hin).
  destruct why as [na nb|n|n| | | |]; try discriminate.
  - apply andb_prop in H; destruct H as [H HL]. apply andb_prop in H; destruct H as [R1 R2].
    apply leaf_bridge_sound with (1 := HL). now apply capped_ok.
  - rewrite orb_false_r in H. intros He Hy Hr Hlt a c _ _. exfalso. apply orb_prop in H. destruct H as [H|H].
    + assert (K := beyond_peak_sound _ _ _ _ H Hf). lra.
    + exact (too_steep_sound _ _ _ _ H Hin Hq Hlt).
Qed.
Lemma check_light_sound U b why : check_reason U true b why = true -> forall e y q, in_box e y q b -> 1 <= q ->
  light_holds (N.to_nat U) e y (/ q).
Proof.
  unfold check_reason. intros H e y q Hin Hq. apply andb_prop in H; destruct H as [Hb H].
    assert (Hf := boxed_ok _ _ Hb e y q Hin).
  destruct why as [na nb|n|n| | | |]; try discriminate.
  - apply andb_prop in H; destruct H as [H HL]. apply andb_prop in H; destruct H as [R1 R2].
    apply leaf_light_sound with (1 := HL). now apply capped_ok.
  - intros He Hy Hr Hlt a c HP _ _ _ _ _. exfalso. apply orb_prop in H. destruct H as [H|H]; [apply orb_prop in H;
    destruct H as [H|H]|].
    + assert (K := beyond_peak_sound _ _ _ _ H Hf). lra.
    + exact (too_steep_sound _ _ _ _ H Hin Hq Hlt).
    + simpl in H. exact (descends_sound _ _ _ _ H Hf He Hr Hy HP).
  - intros He Hy Hr Hlt a c HP HX _ _ _ _. exfalso.
    refine (meets_sound _ _ (V (y1 (round_box b))) e y (/ q) _ (vin _) (proj2 (proj1 (proj2 Hf))) (or_introl Hf) He Hr
      Hy HX).
    exact H.
  - intros He Hy Hr Hlt a c HP _ HS _ _ _. exfalso. exact (meets_reversed_sound _ _ _ _ H Hf He Hr Hy HP HS).
Qed.

(** The witness of the piece [A, B]. That the floats are those of the file is not needed: any contact is a witness. *)
Definition near_dyadic (x : dyadic) : F.type :=
  near_frac p false (Z.of_N (odd_part x) * 2 ^ Z.max 0 (exponent x)) (Z.to_pos (2 ^ Z.max 0 (- exponent x))).
Definition check_contact (V : N) (b : box) (w : contact) : bool :=
  let f := round_box b in boxed f b && check_witness (r0 f) (r1 f) (near_dyadic (contact_e w)) (near_dyadic
    (contact_eta w)) (after_X w) (after_reversed w) V.
(** That sigma X passes above the corner, the format demands; the proof has it without. *)
Definition above_corner (b : box) (w : contact) : bool :=
  let r := S (r1 (round_box b)) in pos (fst (SI (S (near_dyadic (contact_e w))) (S (near_dyadic (contact_eta w))) r r)).
Lemma check_contact_sound V b w : check_contact V b w = true -> forall e y q, in_box e y q b ->
  bridge_witness (/ q) (N.to_nat V).
Proof.
  unfold check_contact. intros H e y q Hin. apply andb_prop in H; destruct H as [Hb H].
    destruct (boxed_ok _ _ Hb e y q Hin) as [_ [_ Hr]].
  exact (check_witness_sound _ _ _ _ _ _ _ H _ Hr).
Qed.
End S.
End Leaves.
