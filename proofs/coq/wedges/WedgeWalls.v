(** The walls of the two wedges are concave graphs with slopes between -1 and 1; the hump is below its tangent at the
    corner, and agrees with it up to there.

    straight_concave, hump_concave   == both wedges have such walls
    hump_below_straight, hump_corner == the hump is below its tangent at the corner, and agrees with it up to there *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Ray Wedge WedgeFlights.
Local Open Scope R_scope.

Lemma straight_concave : concave_wall straight.
Proof.
  split; simpl; intros; try lra. assert (0 <= d * d) by apply Rle_0_sqr. lra.
Qed.

(** The three parts of the hump, seen from the corner. *)
Lemma hump_parts x : let z := x - PI/2 in
  (z <= 0 /\ rise hump x = z /\ slope hump x = 1) \/
  (0 <= z <= PI /\ rise hump x = sin z /\ slope hump x = cos z) \/
  (PI <= z /\ rise hump x = PI - z /\ slope hump x = -1).
Proof.
  intros z. assert (HPI : 0 < PI) by apply PI_RGT_0.
  assert (S : sin z = - cos x) by (unfold z; rewrite sin_minus, sin_PI2, cos_PI2; ring).
  assert (C : cos z = sin x) by (unfold z; rewrite cos_minus, sin_PI2, cos_PI2; ring).
  simpl. destruct (Rle_dec x (PI/2)); [left; unfold z; repeat split; lra|].
  destruct (Rle_dec x (3*(PI/2))); [right; left | right; right]; unfold z in *; repeat split; lra.
Qed.
Lemma hump_corner x : x <= PI/2 -> rise hump x = x - PI/2 /\ slope hump x = 1.
Proof. intros H. simpl. destruct (Rle_dec x (PI/2)); [split; lra | contradiction]. Qed.

Lemma one_minus_cos z : 0 <= z -> 1 - cos z <= 2 * z.
Proof.
  intros Hz. destruct (Rle_or_lt z 2) as [L|L].
  - assert (K := cos_shift 0 z). rewrite cos_0, sin_0, Rplus_0_l in K. apply Rabs_le_between in K.
    assert (z * z <= 2 * z) by (apply Rmult_le_compat_r; lra). lra.
  - destruct (COS_bound z). lra.
Qed.
(** Where the hump goes over into its tangent at the corner. *)
Lemma near_first_end z y : 0 <= z -> y <= 0 -> sin z + cos z * (y - z) - (y - z) * (y - z) <= y.
Proof.
  intros Hz Hy. assert (K := sin_shift z (- z)). replace (z + - z) with 0 in K by ring. rewrite sin_0 in K.
  apply Rabs_le_between in K. assert (O := one_minus_cos z Hz).
  assert (- y * (1 - cos z) <= - y * (2 * z)) by (apply Rmult_le_compat_l; lra).
  assert (0 <= y * y) by apply Rle_0_sqr. lra.
Qed.
Lemma near_first_end_back z y : z <= 0 -> 0 <= y -> y - (y - z) * (y - z) <= sin y.
Proof.
  intros Hz Hy. assert (K := sin_shift 0 y). rewrite sin_0, cos_0, Rplus_0_l in K. apply Rabs_le_between in K.
  assert (y * y <= (y - z) * (y - z)) by (apply Rmult_le_compat; lra). lra.
Qed.

Lemma hump_below_tangent x d : rise hump (x + d) <= rise hump x + slope hump x * d.
Proof.
  assert (HPI : 0 < PI) by apply PI_RGT_0.
  destruct (hump_parts x) as [[H1 [-> ->]]|[[H1 [-> ->]]|[H1 [-> ->]]]];
    destruct (hump_parts (x + d)) as [[H2 [-> _]]|[[H2 [-> _]]|[H2 [-> _]]]];
    replace (x + d - PI/2) with (x - PI/2 + d) in * by ring; set (z := x - PI/2) in *; try lra.
  - assert (K := sin_below_tangent 0 (z + d) ltac:(lra) ltac:(lra)). rewrite sin_0, cos_0 in K. lra.
  - assert (K := sin_below_tangent z 0 ltac:(lra) ltac:(lra)). rewrite sin_0 in K. destruct (COS_bound z).
    assert (- (z + d) * cos z <= - (z + d) * 1) by (apply Rmult_le_compat_l; lra). lra.
  - assert (K := sin_below_tangent z (z + d) ltac:(lra) ltac:(lra)). lra.
  - assert (K := sin_below_tangent z PI ltac:(lra) ltac:(lra)). rewrite sin_PI in K. destruct (COS_bound z).
    assert ((z + d - PI) * -1 <= (z + d - PI) * cos z) by (apply Rmult_le_compat_l; lra). lra.
  - assert (K := sin_below_tangent PI (z + d) ltac:(lra) ltac:(lra)). rewrite sin_PI, cos_PI in K. lra.
Qed.
Lemma hump_near_tangent x d : rise hump x + slope hump x * d - d * d <= rise hump (x + d).
Proof.
  assert (HPI := PI2_1). assert (0 <= d * d) by apply Rle_0_sqr.
  destruct (hump_parts x) as [[H1 [-> ->]]|[[H1 [-> ->]]|[H1 [-> ->]]]];
    destruct (hump_parts (x + d)) as [[H2 [-> _]]|[[H2 [-> _]]|[H2 [-> _]]]];
    replace (x + d - PI/2) with (x - PI/2 + d) in * by ring; set (z := x - PI/2) in *; try lra.
  - assert (K := near_first_end_back z (z + d) H1 ltac:(lra)). replace (z + d - z) with d in K by ring. lra.
  - assert (2 * d <= d * d) by (apply Rmult_le_compat_r; lra). lra.
  - assert (K := near_first_end z (z + d) ltac:(lra) H2). replace (z + d - z) with d in K by ring. lra.
  - assert (K := sin_shift z d). apply Rabs_le_between in K. lra.
  - assert (K := near_first_end (PI - z) (PI - (z + d)) ltac:(lra) ltac:(lra)). rewrite sin_PI_x in K.
    replace (PI - (z + d) - (PI - z)) with (- d) in K by ring. rewrite cos_minus, cos_PI, sin_PI in K. lra.
  - assert (2 * - d <= - d * - d) by (apply Rmult_le_compat_r; lra). lra.
  - assert (K := near_first_end_back (PI - z) (PI - (z + d)) ltac:(lra) ltac:(lra)). rewrite sin_PI_x in K.
    replace (PI - (z + d) - (PI - z)) with (- d) in K by ring. lra.
Qed.
Lemma hump_concave : concave_wall hump.
Proof.
  assert (HPI : 0 < PI) by apply PI_RGT_0. split.
  - intros x. destruct (hump_parts x) as [[_ [_ ->]]|[[_ [_ ->]]|[_ [_ ->]]]]; [lra | apply COS_bound | lra].
  - exact hump_below_tangent.
  - exact hump_near_tangent.
  - intros x Hx. destruct (hump_corner (- x)) as [-> _]; [lra|].
    destruct (hump_parts x) as [[_ [-> _]]|[[H [-> _]]|[_ [-> _]]]]; try lra.
    assert (0 <= sin (x - PI/2)) by (apply sin_ge_0; lra). lra.
Qed.
Lemma hump_below_straight x : rise hump x <= x - PI/2.
Proof.
  assert (HPI : 0 < PI) by apply PI_RGT_0. assert (K := hump_below_tangent 0 x). rewrite Rplus_0_l in K.
  destruct (hump_corner 0) as [E1 E2]; [lra|]. rewrite E1, E2 in K. lra.
Qed.
