(** What a leaf of the section full must satisfy (docs/reference/format-sections.md, sections 1 and 2), computed with
    intervals, and that it is enough: L15, or L16, over a whole box. Generic in the numbers.

    chart_holds                  == what a chart's leaf says of a point (e, y, r): at most U collisions
    check_leaf, check_leaf_sound == a leaf of any chart is right; then it holds all over its box *)
From Coq Require Import Reals ZArith NArith Lra Lia List Bool.
From Interval Require Import Real.Xreal Float.Basic Float.Sig Interval.Interval Interval.Float Interval.Float_full.
From Dumbbell Require Import Ray Chart Forward Certificate Leaves PlainCount.
Local Open Scope R_scope.

(** L15 at one point of a chart: at most U collisions. *)
Definition contact_holds U t eta r := 0 < t < PI -> 0 < eta -> 0 < r <= 1 -> forall a,
  coll r a (r * cX t eta) (r * lamX t eta) -> (1 + a <= U)%nat.
Definition departure_holds U e eta r := 0 < e <= PI/2 -> 0 < eta -> 0 < r <= 1 -> forall a,
  forward r a e (eta - cos e) -> (1 + a <= U)%nat.
(** Of the chart again nothing is to be shown: that the heavy mass hits the floor at most once is true of all q >= 1,
    by L6 (c). *)
Definition chart_holds (c : chart) :=
  match c with
  | Bridge => bridge_holds
  | Light => light_holds
  | Contact => contact_holds
  | Departure => departure_holds
  | Again => fun _ _ _ _ => True
  end.

Module FullLeaves (F : FloatOps with Definition sensible_format := true).
Include PlainCount F.
Import Z.
Import B.

Section S.
Variable p : F.precision.
Variable G : guesses.
Variable T : consts.
Notation pt := I.singleton.
Notation turn := (turn p G T).
Notation at_most_contact := (at_most_contact p G T).
Notation follow := (follow p G T).

(** The part of a box up to the chart's end. *)
Definition until (stop : I.type) (e : F.type) : I.type := if nonneg (I.sub p stop (pt e)) then pt e else stop.
Definition leaf_contact (U : N) (b : fbox) (n : N) : bool :=
  (1 + n <=? U)%N && proper b &&
  let t := until (pi_ T) (e1 b) in at_most_contact (fuel n) (pt (r0 b)) t (pt (y0 b)).
Definition leaf_departure (U : N) (b : fbox) (n : N) : bool :=
  (1 + n <=? U)%N && proper b &&
  let x0 := pt (e0 b) in let '(s0, w0) := sc p G T x0 in
  let x1 := until (quarter T) (e1 b) in
  let '(s1, w1) := sc p G T x1 in
  follow (fuel n) (pt (r0 b)) (pt (r1 b)) {| corner := x0; sine := low s0; slope := low (I.sub p (pt (y0 b)) w0) |}
    {| corner := x1; sine := up s1; slope := up (I.sub p (pt (y1 b)) w1) |} (first_guess G) (first_guess G).
(** The same by L16. *)
Definition leaf_plain_contact (U : N) (b : fbox) (n : N) : bool :=
  (1 + n <=? U)%N && proper b &&
  let t := I.join (pt (e0 b)) (until (pi_ T) (e1 b)) in let r := I.join (pt (r0 b)) (pt (r1 b)) in
  let lam := I.add p (I.cos p t) (I.join (pt (y0 b)) (pt (y1 b))) in
  let c := I.mul p r (I.add p (I.sin p t) (I.mul p lam (not_negative (I.sub p (pi_ T) t)))) in
  plain_ray p G T (fuel n) r (not_negative c) (I.mul p r lam) (first_guess G) (first_guess G).
Definition leaf_plain_departure (U : N) (b : fbox) (n : N) : bool :=
  (1 + n <=? U)%N && proper b &&
  let x := I.join (pt (e0 b)) (until (quarter T) (e1 b)) in
  plain_follow p G T (fuel n) (pt (r0 b)) (pt (r1 b)) (I.join (pt (r0 b)) (pt (r1 b)))
    {| corner := x; sine := I.sin p x; slope := I.sub p (I.join (pt (y0 b)) (pt (y1 b))) (I.cos p x) |}
    (first_guess G) (first_guess G).
Definition steep_departure (b : fbox) : bool :=
  proper b && let '(_, w) := sc p G T (pt (e0 b)) in nonneg (I.sub p (I.sub p (pt (y0 b)) w) (unit_ T)).

(** L19, the leaf `once`: the format demands it, no theorem needs it. *)
Definition leaf_once (b : fbox) : bool :=
  let t := until (pi_ T) (e1 b) in
  let '(_, w) := turn t in let lam := low (I.add p w (pt (y0 b))) in
  let k := low (I.mul p (pt (if nonneg lam then r0 b else r1 b)) lam) in
  if nonneg (I.sub p k (unit_ T)) then proper b else
  let root := I.add p k (I.sqrt p (I.add p (I.sqr p k) (pt (r0 b)))) in
  let near := pt (I.lower (I.mul p root (I.sub p (unit_ T) (tiny p T)))) in
  let excluded := nonneg (I.sub p (pt (r0 b)) (I.sub p (I.sqr p near) (I.mul2 p (I.mul p k near)))) in
  let z := if nonneg near && excluded then near else I.zero in
  let f := I.sub p (I.mul p z (I.add p z (I.mul2 p (pt (r0 b))))) (pt (r1 b)) in
  proper b && (nonneg f || nonneg (I.add p (I.mul p (I.add p (I.fromZ p 2) (pt (y1 b))) f)
    (I.mul p (I.add p z (pt (r0 b))) (half T)))).

(** A leaf of any chart, in a piece with at most [U] collisions. *)
Definition beyond_pi (b : fbox) : bool := pos (I.sub p (pt (e0 b)) (pi_ T)).
Definition less_one (b : box) : box :=
  let s := box_slope b in
  {| box_e := box_e b; box_q := box_q b;
     box_slope := {| low_end := low_end s - Zpos (part s); high_end := high_end s - Zpos (part s); part := part s |} |}.
Definition check_leaf (U : N) (c : chart) (b : box) (why : reason) : bool :=
  let f := round_box p b in
  let holds := boxed f b && (1 <=? U)%N in
  match c, why with
  | Bridge, _ => check_reason p G T U false b why
  | Light, _ => check_reason p G T U true b why
  | Contact, Forward n => holds && leaf_contact U f n
  | Contact, Plain n => holds && leaf_plain_contact U f n
  | (Contact | Again), Outside => holds && (beyond_pi f || too_steep (less_one b))
  | Departure, Forward n =>
      holds && F.real (I.lower (quarter T)) && F.real (e0 f) && leaf_departure U (capped T f) n
  | Departure, Plain n =>
      holds && F.real (I.lower (quarter T)) && F.real (e0 f) && leaf_plain_departure U (capped T f) n
  | Departure, Outside => holds && (beyond_peak p T f || steep_departure f)
  | Again, Once => holds && leaf_once f
  | _, _ => false
  end.

(* ---------- soundness ---------- *)
Hypothesis HT : T = mkconsts p.
Let piI := pi_in p T HT.
Let quI := quarter_in p T HT.
Let unI := unit_in p T HT.

Lemma until_ok stop i f e : inI stop i -> e <= V f -> e <= stop -> exists x, inI x (until i f) /\ e <= x <= stop.
Proof.
  intros Hi H1 H2. unfold until. destruct (nonneg _) eqn:E; [|exists stop; split; [exact Hi | lra]].
  exists (V f). assert (K := nonneg_ok _ _ E (sub_in p _ _ _ _ Hi (vin f))). split; [apply vin | lra].
Qed.
Lemma leaf_contact_sound U b n : leaf_contact U b n = true -> forall t y r, inside b t y r ->
  contact_holds (N.to_nat U) t y r.
Proof.
  unfold leaf_contact. intros H t y r [Ht [Hy Hr]] Ht' Hy' Hr' a Ha.
  apply andb_prop in H; destruct H as [H H3]. apply andb_prop in H; destruct H as [HU Hp]. apply N.leb_le in HU.
  destruct (proper_ok b Hp) as [P1 [P2 [P3 P4]]].
  destruct (until_ok PI (pi_ T) (e1 b) t piI ltac:(lra) ltac:(lra)) as [t0 [A1 A2]].
  assert (K := at_most_contact_sound p G T HT _ _ _ _ H3 (V (r0 b)) t0 (V (y0 b)) (vin _) A1 (vin _) r t y a ltac:(lra)
    ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) Ha). assert (FA := fuel_le n). lia.
Qed.
Lemma leaf_departure_sound U b n : leaf_departure U b n = true -> forall e y r, inside b e y r ->
  departure_holds (N.to_nat U) e y r.
Proof.
  unfold leaf_departure. intros H e y r [He [Hy Hr]] He' Hy' Hr' a Ha.
  apply andb_prop in H; destruct H as [H H3]. apply andb_prop in H; destruct H as [HU Hp]. apply N.leb_le in HU.
  destruct (proper_ok b Hp) as [P1 [P2 [P3 P4]]]. assert (HPI : 0 < PI) by apply PI_RGT_0.
  destruct (sc_ok p G T HT _ _ (vin (e0 b))) as [S0 W0]. destruct (sc p G T (pt (e0 b))) as [s0 w0]. simpl in S0, W0.
  set (xi := until _ _) in H3.
  destruct (until_ok (PI/2) (quarter T) (e1 b) e quI ltac:(lra) ltac:(lra)) as [x1 [X1 X2]]. fold xi in X1.
  destruct (sc_ok p G T HT _ _ X1) as [S1 W1]. destruct (sc p G T xi) as [s1 w1].
  simpl in S1, W1. assert (C0 : cos e <= cos (V (e0 b))) by (apply cos_mono; lra).
  assert (C1 : cos x1 <= cos e) by (apply cos_mono; lra).
  destruct (low_ok _ _ S0) as [s2 [S2 S3]]. destruct (low_ok _ _ (sub_in p _ _ _ _ (vin (y0 b)) W0)) as [k0 [K0 K1]].
  destruct (up_ok _ _ S1) as [s3 [S4 S5]]. destruct (up_ok _ _ (sub_in p _ _ _ _ (vin (y1 b)) W1)) as [k1 [K2 K3]].
  assert (K := follow_sound p G T HT _ _ (V (r0 b)) (V (r1 b)) r (vin _) (vin _) P3 (proj1 Hr) (proj2 Hr) P4
    _ _ _ _ _ H3 e (y - cos e)). assert (FA := fuel_le n). apply K in Ha; [lia | |].
  - exists (V (e0 b)), s2, k0. repeat split; try assumption; try apply vin; lra.
  - intros _. exists x1, s3, k1. repeat split; try assumption; lra.
Qed.
Lemma leaf_plain_contact_sound U b n : leaf_plain_contact U b n = true -> forall t y r, inside b t y r ->
  contact_holds (N.to_nat U) t y r.
Proof.
  unfold leaf_plain_contact. intros H t y r [Ht [Hy Hr]] Ht' Hy' Hr' a Ha. cbv zeta in H.
  apply andb_prop in H; destruct H as [H H3]. apply andb_prop in H; destruct H as [HU Hp]. apply N.leb_le in HU.
  destruct (proper_ok b Hp) as [P1 [P2 [P3 P4]]].
  destruct (until_ok PI (pi_ T) (e1 b) t piI ltac:(lra) ltac:(lra)) as [t0 [A1 A2]].
  set (ti := I.join (pt (e0 b)) _) in *. set (ri := I.join (pt (r0 b)) _) in *. set (yi := I.join (pt (y0 b)) _) in *.
  assert (TI : inI t ti) by (apply (join_between (V (e0 b)) t0); [apply vin | exact A1 | lra]).
  assert (RI : inI r ri) by (apply (join_between (V (r0 b)) (V (r1 b))); [apply vin | apply vin | lra]).
  assert (YI : inI y yi) by (apply (join_between (V (y0 b)) (V (y1 b))); [apply vin | apply vin | lra]).
  assert (LI : inI (lamX t y) (I.add p (I.cos p ti) yi)) by (apply add_in; [now apply cos_in | exact YI]).
  assert (CI : inI (r * cX t y)
    (I.mul p ri (I.add p (I.sin p ti) (I.mul p (I.add p (I.cos p ti) yi) (not_negative (I.sub p (pi_ T) ti)))))).
  { apply mul_in; [exact RI|]. apply add_in; [now apply sin_in|]. apply mul_in; [exact LI|].
    apply not_negative_ok; [now apply sub_in | lra]. }
  assert (C0 : 0 <= r * cX t y).
  { assert (A := cX_mono t PI y 0 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
    assert (cX PI 0 = 0) by (unfold cX; rewrite sin_PI; ring). apply Rmult_le_pos; lra. }
  destruct (COS_bound t). assert (K0 : r * -1 <= r * lamX t y) by (apply Rmult_le_compat_l; unfold lamX; lra).
  assert (K := plain_ray_sound p G T HT _ _ _ _ _ _ H3 r (r * cX t y) (r * lamX t y) RI
    (not_negative_ok _ _ CI C0) (mul_in p _ _ _ _ RI LI) ltac:(lra) C0 ltac:(lra) a Ha).
  assert (FA := fuel_le n). lia.
Qed.
Lemma leaf_plain_departure_sound U b n : leaf_plain_departure U b n = true -> forall e y r, inside b e y r ->
  departure_holds (N.to_nat U) e y r.
Proof.
  unfold leaf_plain_departure. intros H e y r [He [Hy Hr]] He' Hy' Hr' a Ha. cbv zeta in H.
  apply andb_prop in H; destruct H as [H H3]. apply andb_prop in H; destruct H as [HU Hp]. apply N.leb_le in HU.
  destruct (proper_ok b Hp) as [P1 [P2 [P3 P4]]].
  destruct (until_ok (PI/2) (quarter T) (e1 b) e quI ltac:(lra) ltac:(lra)) as [x1 [A1 A2]].
  set (xi := I.join (pt (e0 b)) _) in *.
  assert (XI : inI e xi) by (apply (join_between (V (e0 b)) x1); [apply vin | exact A1 | lra]).
  assert (K := plain_follow_sound p G T HT (pt (r0 b)) (pt (r1 b)) _ (V (r0 b)) (V (r1 b)) r (vin _) (vin _)
    (join_between _ _ _ _ _ (vin _) (vin _) Hr) P3 (proj1 Hr) (proj2 Hr) P4 _ _ _ _ H3 e (y - cos e)).
  assert (FA := fuel_le n). apply K in Ha; [lia | | lra | lra].
  split; [exact XI|]. split; [now apply sin_in|]. apply sub_in; [|now apply cos_in].
  exact (join_between _ _ _ _ _ (vin _) (vin _) Hy).
Qed.
Lemma steep_departure_sound b : steep_departure b = true -> forall e y r n, inside b e y r -> 0 < e <= PI/2 ->
  0 < r <= 1 -> forward r n e (y - cos e) -> n = O.
Proof.
  unfold steep_departure. intros H e y r n [He [Hy _]] He' Hr Hn. apply andb_prop in H; destruct H as [Hp H].
  destruct (proper_ok b Hp) as [P1 _]. destruct (sc_ok p G T HT _ _ (vin (e0 b))) as [_ W0].
  destruct (sc p G T (pt (e0 b))) as [s0 w0]. simpl in W0.
  assert (K := nonneg_ok _ _ H (sub_in p _ _ _ _ (sub_in p _ _ _ _ (vin (y0 b)) W0) unI)).
  assert (cos e <= cos (V (e0 b))) by (apply cos_mono; lra).
  apply (forward_steep r n e (y - cos e) Hr); [lra | exact Hn].
Qed.
Lemma less_one_ok e y q b : in_box e y q b -> in_box e (y - 1) q (less_one b).
Proof.
  intros [A [B C]]. split; [exact A|]. split; [|exact C].
  unfold in_span in *; cbn [box_slope less_one low_end high_end part].
  rewrite !minus_IZR. assert (D : 0 < IZR (Zpos (part (box_slope b)))) by now apply IZR_lt.
  set (d := IZR (Zpos (part (box_slope b)))) in *. unfold Rdiv in *. rewrite !Rmult_minus_distr_r, !Rinv_r by lra. lra.
Qed.

Theorem check_leaf_sound U c b why : check_leaf U c b why = true -> forall e y q, in_box e y q b -> 1 <= q ->
  chart_holds c (N.to_nat U) e y (/ q).
Proof.
  intros H e y q Hin Hq. destruct c.
  - exact (check_bridge_sound p G T HT U b why H e y q Hin Hq).
  - exact (check_light_sound p G T HT U b why H e y q Hin Hq).
  - unfold check_leaf in H. destruct why as [| n | n | | | |]; try discriminate;
      apply andb_prop in H; destruct H as [H HL]; apply andb_prop in H; destruct H as [Hb HU]; apply N.leb_le in HU;
      assert (Hf := boxed_ok _ _ Hb e y q Hin).
    + exact (leaf_contact_sound U _ n HL e y (/ q) Hf).
    + exact (leaf_plain_contact_sound U _ n HL e y (/ q) Hf).
    + intros Ht Hy Hr a Ha. assert (a = O); [|lia]. apply orb_prop in HL. destruct HL as [HL|HL].
      * assert (K := pos_ok _ _ HL (sub_in p _ _ _ _ (vin _) piI)). destruct Hf as [Hf _]. lra.
      * apply (steep_ray_misses (/ q) a (/ q * cX e y) (/ q * lamX e y)); [|exact Ha]. apply Rnot_lt_le. intros K.
        apply (too_steep_sound _ e (y - 1) q HL); [now apply less_one_ok | exact Hq|].
        apply Rle_lt_trans with (2 := K). apply Rmult_le_compat_l; [lra|]. unfold lamX. destruct (COS_bound e). lra.
  - unfold check_leaf in H. destruct why as [| n | n | | | |]; try discriminate.
    + apply andb_prop in H; destruct H as [H HL]. apply andb_prop in H; destruct H as [H R2].
      apply andb_prop in H; destruct H as [H R1]. apply andb_prop in H; destruct H as [Hb HU].
      assert (Hf := boxed_ok _ _ Hb e y q Hin). apply (leaf_departure_sound U _ n HL). now apply capped_ok.
    + apply andb_prop in H; destruct H as [H HL]. apply andb_prop in H; destruct H as [H R2].
      apply andb_prop in H; destruct H as [H R1]. apply andb_prop in H; destruct H as [Hb HU].
      assert (Hf := boxed_ok _ _ Hb e y q Hin). apply (leaf_plain_departure_sound U _ n HL). now apply capped_ok.
    + apply andb_prop in H; destruct H as [H HL]; apply andb_prop in H; destruct H as [Hb HU]; apply N.leb_le in HU.
      assert (Hf := boxed_ok _ _ Hb e y q Hin).
      intros He Hy Hr a Ha. assert (a = O); [|lia]. apply orb_prop in HL. destruct HL as [HL|HL].
      * assert (K := beyond_peak_sound p T HT _ _ _ _ HL Hf). lra.
      * exact (steep_departure_sound _ HL e y (/ q) a Hf He Hr Ha).
  - exact I.
Qed.
End S.
End FullLeaves.
