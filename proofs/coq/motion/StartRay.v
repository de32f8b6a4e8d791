(** A state in flight to the left as a ray (c, k) over the left corner: what starts above everything that lies before
    the left wall (L4); out of a contact with the bridge, L6; out of a bounce off a light wall, L4 (b), L6 (b).

    start_ray P s v c k              == the state flies as the ray (c, k)
    bridge_start_ray, next_start_ray == so it does out of a contact with the bridge, and after a collision
    mirror_pos                       == a position in the mirror *)
From Coq Require Import Reals Lra.
From Dumbbell Require Import Physics Ray Flight Symmetry.
Local Open Scope R_scope.

Section StartRay.
Variable P : dumbbell.
Hypothesis HP : real_dumbbell P.
Hypothesis Hr1 : r_of P <= 1.
Notation r := (r_of P).
Notation yh := (yhat_of P).

(** A ray to the left, over the left corner at the height c, with slope k; it clears what lies before that corner. *)
Record start_ray (s0 : pos) (v : vel) (c k : R) : Prop := {
  sr_left : u_of v < 0; sr_slope : k * - u_of v = v_of P v;
  sr_height : c = yh s0 + k * (psi_of s0 + PI/2); sr_start : - (PI/2) < psi_of s0;
  sr_clear : forall z, - (PI/2) <= z < psi_of s0 ->
    - cos z < yh s0 + k * (psi_of s0 - z) /\ r * cos z < yh s0 + k * (psi_of s0 - z);
  sr_below : 0 <= k \/ c + k * (PI/2) < 1 }.
Lemma start_ray_height_pos s0 v c k : start_ray s0 v c k -> 0 < c.
Proof.
  intros [_ _ Hc Hs Hcl _]. assert (HPI : 0 < PI) by apply PI_RGT_0. destruct (Hcl (- (PI/2)) ltac:(lra)) as [_ K].
  rewrite cos_neg, cos_PI2 in K. rewrite Hc. lra.
Qed.

(** L6: out of a contact with the bridge to the left. *)
Theorem bridge_start_ray s0 v k : u_of v < 0 -> k * - u_of v = v_of P v ->
  - (PI/2) < psi_of s0 < PI/2 -> yh s0 = r * cos (psi_of s0) -> 0 < v_of P v + r * sin (psi_of s0) * u_of v ->
  start_ray s0 v (r * cos (psi_of s0) + k * (psi_of s0 + PI/2)) k /\ - r <= k.
Proof.
  intros Hu Hs Hp Hy Hn. assert (R0 := r_pos P HP). assert (HPI : 0 < PI) by apply PI_RGT_0. set (x := psi_of s0) in *.
  assert (Hk : r * sin x < k). { apply Rmult_lt_reg_r with (- u_of v); lra. }
  assert (Hclear : forall z, - (PI/2) <= z < x -> 0 <= cos z /\ r * cos z < r * cos x + k * (x - z)).
  { intros z Hz. split; [apply cos_ge_0; lra|].
    assert (Tg := sin_below_tangent (PI/2 + x) (PI/2 + z) ltac:(lra) ltac:(lra)).
    rewrite !sin_plus, cos_plus, sin_PI2, cos_PI2 in Tg.
    assert (r * cos z <= r * (cos x + sin x * (x - z))) by (apply Rmult_le_compat_l; lra).
    assert (r * sin x * (x - z) < k * (x - z)) by (apply Rmult_lt_compat_r; lra). lra. }
  assert (SB := SIN_bound x). assert (CB := COS_bound x).
  assert (Hkr : - r <= k) by (assert (r * -1 <= r * sin x) by (apply Rmult_le_compat_l; lra); lra).
  split; [split|exact Hkr]; fold x; try assumption; try lra.
  - intros z Hz. rewrite Hy. destruct (Hclear z Hz) as [D1 D2]. assert (0 <= r * cos z) by (apply Rmult_le_pos; lra).
    split; lra.
  - destruct (Rle_or_lt 0 k) as [|K]; [now left | right]. assert (r * cos x <= r * 1) by (apply Rmult_le_compat_l; lra).
    assert (0 < - k * (x + PI)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

(** (2) of L4 (b). *)
Lemma reflected_velocity x k v v' : u_of v < 0 -> k * - u_of v = v_of P v ->
  reflects P (- cos x) (u_of v) (v_of P v) (u_of v') (v_of P v') ->
  u_of v' = - u_of v * (slope_den (cos x) k r / (cos x * cos x + r)) /\
  v_of P v' = - u_of v * (slope_num (cos x) k r / (cos x * cos x + r)) /\ 0 < v_of P v' + cos x * u_of v'.
Proof.
  intros Hu Hs [l [Hl [Eu [Ev [Er En]]]]]. assert (R0 := r_pos P HP).
  assert (0 < cos x * cos x + r) by (assert (0 <= cos x * cos x) by apply Rle_0_sqr; lra).
  assert (El : l = 2 * - u_of v * (cos x - k) / (cos x * cos x + r)).
  { apply Rmult_eq_reg_r with (cos x * cos x + r); [|lra].
    replace (2 * - u_of v * (cos x - k) / (cos x * cos x + r) * (cos x * cos x + r)) with (2 * - u_of v * (cos x - k))
      by (field; lra).
    rewrite Eu, Ev, <- Hs in Er. lra. }
  split; [|split; [|lra]].
  - rewrite Eu, El. unfold slope_den. field. lra.
  - rewrite Ev, El, <- Hs. unfold slope_num. field. lra.
Qed.

Definition mirror_pos (s : pos) := {| height := height s; angle := PI - angle s |}.
Lemma psi_mirror_pos s : psi_of (mirror_pos s) = - psi_of s.
Proof. unfold psi_of; simpl. lra. Qed.
(** After the bounce to the other wall: a ray again, mirrored. *)
Lemma next_start_ray s1 v' x k' : psi_of s1 = - (PI/2) - x -> yh s1 = sin x -> 0 < x < PI/2 -> 0 < u_of v' ->
  k' * u_of v' = v_of P v' -> r <= k' ->
  start_ray (mirror_pos s1) (mirror_v v') (sin x + k' * (x + PI)) k'.
Proof.
  intros E1 E2 Hx Hu Hs Hk. assert (HPI : 0 < PI) by apply PI_RGT_0. assert (R0 := r_pos P HP).
  assert (EP : psi_of (mirror_pos s1) = PI/2 + x) by (rewrite psi_mirror_pos, E1; ring).
  assert (EY : yh (mirror_pos s1) = sin x) by exact E2.
  assert (Sx : 0 < sin x) by (apply sin_gt_0; lra).
  split; rewrite ?EP, ?EY; try lra; try (unfold u_of, v_of in *; simpl; lra).
  intros z Hz. destruct (Rle_or_lt z (PI/2)) as [Kz|Kz].
  - assert (Hk2 : r * (PI/2 + x - z) <= k' * (PI/2 + x - z)) by (apply Rmult_le_compat_r; lra).
    assert (0 <= cos z) by (apply cos_ge_0; lra).
    assert (cos z <= PI/2 - z). { replace (cos z) with (sin (PI/2 - z)) by (rewrite sin_minus, cos_PI2, sin_PI2; ring).
      destruct (Req_dec z (PI/2)) as [->|];
        [replace (PI/2 - PI/2) with 0 by ring; rewrite sin_0; lra | left; apply sin_lt_x; lra]. }
    assert (r * cos z <= r * (PI/2 - z)) by (apply Rmult_le_compat_l; lra).
    assert (0 <= r * x) by (apply Rmult_le_pos; lra).
    assert (0 <= r * (PI/2 + x - z)) by (apply Rmult_le_pos; lra). split; lra.
  - set (z' := z - PI/2). assert (Ez : z = PI/2 + z') by (unfold z'; ring).
    assert (Hz' : 0 < z' < x) by (unfold z'; lra).
    assert (Cz : cos z = - sin z') by (rewrite Ez, cos_plus, cos_PI2, sin_PI2; ring). rewrite Cz.
    assert (sin z' <= sin x) by (apply sin_mono; lra). assert (0 < sin z') by (apply sin_gt_0; lra).
    assert (0 < k' * (PI/2 + x - z)) by (apply Rmult_lt_0_compat; lra).
    assert (0 <= r * sin z') by (apply Rmult_le_pos; lra). split; lra.
Qed.
End StartRay.
