(** L17, L18: the greatest number of collisions in the straight wedge is ceil(pi/gamma), for every q > 0, and in the
    hybrid wedge it is the same; so the dumbbell never has more collisions than the hybrid wedge. *)
From Coq Require Import Reals Lra Lia.
From Dumbbell Require Statement.
From Dumbbell Require Import Wedge WedgeFlights PublishedBound WedgeUpper WedgeWalls WedgeWitness.
Local Open Scope R_scope.

(** A wall that is below the tangent at the corner and agrees with it up to there. *)
Section AnyWall.
Variables (W : wall) (q : R) (N : nat).
Hypothesis HW : concave_wall W.
Hypothesis below_straight : forall x, rise W x <= x - PI/2.
Hypothesis agrees : forall x, x <= PI/2 -> rise W x = x - PI/2 /\ slope W x = 1.
Hypothesis Hq : 0 < q.
Hypothesis HN : is_ceiling (PI / gamma q) N.

Lemma ceiling_times_gamma : (INR N - 1) * gamma q < PI <= INR N * gamma q.
Proof.
  assert (G := gamma_range q Hq). destruct HN as [A B]. replace PI with (PI / gamma q * gamma q) at 1 2 by (field; lra).
  split; [apply Rmult_lt_compat_r | apply Rmult_le_compat_r]; lra.
Qed.
(** All collisions of the witness are less than pi/2 from the vertex. *)
Lemma small_witness e : 0 < e < PI/2 -> e <= gamma q -> 2 * e <= PI - (INR N - 1) * gamma q -> forall j t,
  atan t = edge q e j -> sign j * psi (seg q e (sin e) j t) <= PI/2.
Proof.
  intros He Hg HD j t E. assert (G := gamma_range q Hq). assert (C := ceiling_times_gamma).
  assert (Se : 0 < sin e) by (apply sin_gt_0; lra). destruct (atan_bound t) as [A1 A2].
  destruct (edge_middles q e j) as [M _]. destruct (seg_polar q e (sin e) Hq j t) as [-> _].
  replace (atan t - middle q e j) with (gamma q / 2) by lra. unfold edge, first in E. rewrite S_INR in E.
  assert (J : (S j <= N)%nat).
  { assert (K : INR j < INR N); [|apply INR_lt in K; lia].
    apply Rmult_lt_reg_r with (gamma q); lra. }
  apply le_INR in J. rewrite S_INR in J. assert (P := pos_INR j).
  assert (INR j * gamma q <= (INR N - 1) * gamma q) by (apply Rmult_le_compat_r; lra).
  assert (0 <= INR j * gamma q) by (apply Rmult_le_pos; lra).
  assert (K : sin e <= cos (atan t)).
  { rewrite <- cos_shift. destruct (Rle_or_lt 0 (atan t)); [apply cos_decr_1; lra|].
    rewrite <- (cos_neg (atan t)). apply cos_decr_1; lra. }
  replace (sign j * (sin e * (sign j * (sin (gamma q / 2) / cos (atan t)))))
    with (sign j * sign j * (sin e * / cos (atan t) * sin (gamma q / 2))) by (field; lra).
  rewrite sign_square, Rmult_1_l. destruct (SIN_bound (gamma q / 2)) as [_ B]. assert (HPI := PI2_1).
  assert (L : sin e * / cos (atan t) <= 1).
  { replace 1 with (cos (atan t) * / cos (atan t)) by (field; lra). apply Rmult_le_compat_r; [|exact K].
    left. apply Rinv_0_lt_compat. lra. }
  assert (0 <= sin e * / cos (atan t)) by (apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; lra]).
  assert (sin e * / cos (atan t) * sin (gamma q / 2) <= sin e * / cos (atan t) * 1) by (apply Rmult_le_compat_l; lra).
  lra.
Qed.
Lemma any_wall_greatest : greatest W q N.
Proof.
  assert (G := gamma_range q Hq). assert (C := ceiling_times_gamma). split.
  - intros p Hm. apply (wedge_at_most W q HW Hq p Hm). apply HN.
  - set (e := Rmin (gamma q) (PI - (INR N - 1) * gamma q) / 2).
    assert (E1 : Rmin (gamma q) (PI - (INR N - 1) * gamma q) <= gamma q) by apply Rmin_l.
    assert (E2 : Rmin (gamma q) (PI - (INR N - 1) * gamma q) <= PI - (INR N - 1) * gamma q) by apply Rmin_r.
    assert (E0 : 0 < Rmin (gamma q) (PI - (INR N - 1) * gamma q)) by (apply Rmin_pos; lra).
    assert (He : 0 < e <= gamma q) by (unfold e; lra). assert (Se : 0 < sin e) by (apply sin_gt_0; lra).
    assert (Hs := small_witness e ltac:(unfold e; lra) ltac:(lra) ltac:(unfold e; lra)).
    exists (path q e (sin e) He). split.
    + now apply path_motion.
    + apply path_at_least; try assumption. unfold e. lra.
Qed.
End AnyWall.

Theorem L17_straight_wedge q N : 0 < q -> is_ceiling (PI / gamma q) N -> greatest straight q N.
Proof.
  intros Hq HN. apply any_wall_greatest; try assumption; [exact straight_concave | | ]; simpl; intros; [|split]; lra.
Qed.
Theorem L18_hybrid_wedge q N : 0 < q -> is_ceiling (PI / gamma q) N -> greatest hump q N.
Proof.
  intros Hq HN. apply any_wall_greatest; try assumption;
    [exact hump_concave | exact hump_below_straight | exact hump_corner].
Qed.

(** There is only one greatest number; so the straight and the hybrid wedge have the same at every q > 0. *)
Lemma greatest_unique W q a b : greatest W q a -> greatest W q b -> a = b.
Proof.
  assert (H : forall a b, greatest W q a -> greatest W q b -> (b <= a)%nat).
  { intros x y [U _] [_ [p [Hm [l [H1 [<- H3]]]]]]. now apply (U p Hm). }
  intros A B. apply Nat.le_antisymm; now apply H.
Qed.
Lemma ceiling_exists x : 0 <= x -> exists N, is_ceiling x N.
Proof.
  intros Hx. unfold is_ceiling. destruct (archimed x) as [A B].
  assert (Z : (0 <= up x)%Z) by (apply le_IZR; lra). destruct (IZN _ Z) as [n E].
  rewrite E, <- INR_IZR_INZ in *. destruct (Req_dec (INR n) (x + 1)) as [Q|Q]; [|exists n; lra].
  destruct n as [|n]; [simpl in Q; lra|]. exists n. rewrite S_INR in *. lra.
Qed.
Corollary L18_same_maximum q N : 0 < q -> greatest straight q N <-> greatest hump q N.
Proof.
  intros Hq. assert (G := gamma_range q Hq).
  destruct (ceiling_exists (PI / gamma q)) as [M HM]; [left; apply Rdiv_lt_0_compat; lra|].
  assert (A := L17_straight_wedge q M Hq HM). assert (B := L18_hybrid_wedge q M Hq HM).
  split; intros H; [rewrite (greatest_unique _ _ _ _ H A) | rewrite (greatest_unique _ _ _ _ H B)]; assumption.
Qed.

(** Sharper than Lemma 4.2 of the source paper, with Theorem 3 (a): the bridge never adds to the greatest number. *)
Corollary dumbbell_at_most_hybrid q n N : 1 <= q -> Statement.N_star q n -> greatest hump q N -> (n <= N)%nat.
Proof.
  intros Hq Hn HN. assert (G := gamma_range q ltac:(lra)).
  destruct (ceiling_exists (PI / gamma q)) as [M HM]; [left; apply Rdiv_lt_0_compat; lra|].
  rewrite (greatest_unique _ _ _ _ HN (L18_hybrid_wedge q M ltac:(lra) HM)). now apply theorem_3a with q.
Qed.
