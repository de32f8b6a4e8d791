(** Sine, cosine and arctangent, beside what Coq's library has.

    cos_pos, cos_range, sin_small == their signs
    cos_left, sin_left, cos_right, cos_mirror == at right angles, and seen in the mirror
    cos_mono, sin_mono  == they are monotone on [0, pi/2]
    sin_below_tangent   == L12 (a), (c): the sine is below its tangents
    sin_lipschitz, cos_lipschitz == they change no faster than the angle
    sin_near, cos_near  == L12 (d), with d^2 for d^2/2
    atan_nonneg, atan_mono, atan_moves, atan_parts, atan_sum == the arctangent: sign, growth, sine, sum
    whole_turns         == an angle but for whole turns
    PI_above_3_1, PI_below_3_22 == decimals, by no machine number *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Signs.
Local Open Scope R_scope.

Lemma unit_circle x : sin x * sin x + cos x * cos x = 1.
Proof. exact (sin2_cos2 x). Qed.
Lemma cos_pos x : 0 <= x < PI/2 -> 0 < cos x.
Proof. intros. apply cos_gt_0; lra. Qed.
Lemma cos_range e : 0 <= e <= PI/2 -> 0 <= cos e <= 1.
Proof. intros. split; [apply cos_ge_0; lra | apply COS_bound]. Qed.
Lemma sin_small x : 0 < Rabs x < PI -> sin x <> 0.
Proof.
  intros Hx. unfold Rabs in Hx. destruct (Rcase_abs x) as [L|L].
  - assert (0 < sin (- x)) by (apply sin_gt_0; lra). rewrite sin_neg in H. lra.
  - assert (0 < sin x) by (apply sin_gt_0; lra). lra.
Qed.
Lemma cos_left x : cos (- (PI/2) - x) = - sin x.
Proof. rewrite cos_minus, cos_neg, sin_neg, cos_PI2, sin_PI2. ring. Qed.
Lemma sin_left x : sin (- (PI/2) - x) = - cos x.
Proof. rewrite sin_minus, cos_neg, sin_neg, cos_PI2, sin_PI2. ring. Qed.
Lemma cos_right x : cos (PI/2 + x) = - sin x.
Proof. rewrite cos_plus, cos_PI2, sin_PI2. ring. Qed.
Lemma cos_mirror x : cos (PI - x) = - cos x.
Proof. rewrite cos_minus, cos_PI, sin_PI. ring. Qed.
Lemma whole_turns x : 0 <= x -> exists k, - PI <= x - 2 * INR k * PI <= PI.
Proof.
  intros Hx. assert (HPI := PI2_1). destruct (nfloor_ex x Hx) as [n Hn]. assert (N : x <= PI + 2 * INR n * PI).
  { assert (INR n * 1 <= INR n * PI) by (assert (P := pos_INR n); pos). lra. }
  clear Hn. induction n as [|n IH]; [exists O; simpl in *; lra|].
  destruct (Rle_or_lt x (PI + 2 * INR n * PI)); [now apply IH|]. exists (S n). rewrite S_INR in *. lra.
Qed.

Lemma cos_mono x y : 0 <= x -> x <= y -> y <= PI/2 -> cos y <= cos x.
Proof. intros. assert (HPI := PI_RGT_0). apply cos_decr_1; lra. Qed.
Lemma sin_mono x y : 0 <= x -> x <= y -> y <= PI/2 -> sin x <= sin y.
Proof. intros. assert (HPI := PI_RGT_0). apply sin_incr_1; lra. Qed.
Lemma sin_below_tangent z x : 0 <= z <= PI -> 0 <= x <= PI -> sin x <= sin z + (x - z) * cos z.
Proof.
  intros Hz Hx. destruct (MVT_gen sin z x cos) as [t [Ht E]].
  { intros; auto_derive; [easy|ring]. } { intros; reg. }
  assert ((cos t - cos z) * (x - z) <= 0); [|lra].
  unfold Rmin, Rmax in Ht. destruct (Rle_dec z x).
  - assert (cos t <= cos z) by (apply cos_decr_1; lra). nra.
  - assert (cos z <= cos t) by (apply cos_decr_1; lra). nra.
Qed.

Lemma at_most_the_way a d : Rabs a <= 1 -> Rabs (a * d) <= Rabs d.
Proof. intros. assert (Rabs a * Rabs d <= 1 * Rabs d) by (assert (P := Rabs_pos d); pos). rewrite Rabs_mult. lra. Qed.
Lemma sin_lipschitz x y : Rabs (sin y - sin x) <= Rabs (y - x).
Proof.
  destruct (MVT_gen sin x y cos) as [t [_ E]]. { intros; auto_derive; [easy|ring]. } { intros; reg. }
  rewrite E. apply at_most_the_way, Rabs_le, COS_bound.
Qed.
Lemma cos_lipschitz x y : Rabs (cos y - cos x) <= Rabs (y - x).
Proof.
  destruct (MVT_gen cos x y (fun t => - sin t)) as [t [_ E]]. { intros; auto_derive; [easy|ring]. } { intros; reg. }
  rewrite E. apply at_most_the_way. rewrite Rabs_Ropp. apply Rabs_le, SIN_bound.
Qed.
Lemma between z d t a : Rmin z (z + d) <= t <= Rmax z (z + d) -> Rabs a <= Rabs (t - z) -> Rabs (a * d) <= d * d.
Proof.
  intros Ht Ha. rewrite Rabs_mult.
  replace (d * d) with (Rabs d * Rabs d) by (rewrite <- Rabs_mult; apply Rabs_pos_eq; pos).
  apply Rmult_le_compat_r; [pos|]. apply Rle_trans with (1 := Ha).
  unfold Rmin, Rmax in Ht. destruct (Rle_dec z (z + d)); unfold Rabs; repeat destruct Rcase_abs; lra.
Qed.
Lemma sin_near z d : Rabs (sin (z + d) - (sin z + d * cos z)) <= d * d.
Proof.
  destruct (MVT_gen sin z (z + d) cos) as [t [Ht E]]. { intros; auto_derive; [easy|ring]. } { intros; reg. }
  replace (sin (z + d) - (sin z + d * cos z)) with ((cos t - cos z) * d) by lra.
  apply between with (1 := Ht), cos_lipschitz.
Qed.
Lemma cos_near z d : Rabs (cos (z + d) - (cos z - d * sin z)) <= d * d.
Proof.
  destruct (MVT_gen cos z (z + d) (fun y => - sin y)) as [t [Ht E]]. { intros; auto_derive; [easy|ring]. }
  { intros; reg. }
  replace (cos (z + d) - (cos z - d * sin z)) with (- ((sin t - sin z) * d)) by lra. rewrite Rabs_Ropp.
  apply between with (1 := Ht), sin_lipschitz.
Qed.

Lemma atan_mono x y : x <= y -> atan x <= atan y.
Proof. intros [H|<-]; [left; now apply atan_increasing | apply Rle_refl]. Qed.
Lemma atan_nonneg x : 0 <= x -> 0 <= atan x < PI/2.
Proof. intros H. rewrite <- atan_0 at 1. split; [now apply atan_mono | apply atan_bound]. Qed.
Lemma atan_moves s t : s <= t -> atan s <= atan t <= atan s + (t - s).
Proof.
  intros H. split; [now apply atan_mono|].
  destruct (MVT_gen atan s t (fun x => / (1 + x ^ 2))) as [c [_ E]].
  { intros. apply is_derive_Reals. apply derivable_pt_lim_atan. }
  { intros. apply derivable_continuous_pt, derivable_pt_atan. }
  assert (P := pow2_ge_0 c). assert (L : / (1 + c ^ 2) <= / 1) by (apply Rinv_le_contravar; lra). rewrite Rinv_1 in L.
  assert (/ (1 + c ^ 2) * (t - s) <= 1 * (t - s)) by pos. lra.
Qed.
Lemma atan_parts z : 0 < cos (atan z) /\ z * cos (atan z) = sin (atan z).
Proof.
  destruct (atan_bound z). assert (C : 0 < cos (atan z)) by (apply cos_gt_0; lra). split; [exact C|].
  rewrite <- (tan_atan z) at 1. unfold tan. field. lra.
Qed.
Lemma atan_sum a b : 0 <= a -> 0 <= b -> a * b < 1 -> atan a + atan b = atan ((a + b) / (1 - a * b)).
Proof.
  intros Ha Hb Hab. set (s := (a + b) / (1 - a * b)). assert (Hs : 0 <= s) by (unfold s; pos).
  assert (A := atan_nonneg a Ha). assert (B := atan_nonneg b Hb). assert (S := atan_nonneg s Hs).
  assert (Haa : 0 <= a * a) by pos. assert (E : atan_sub s a = b) by (unfold atan_sub, s; field; split; lra).
  symmetry. rewrite <- E. apply atan_sub_correct; rewrite ?E; try lra. assert (0 <= s * a) by pos. lra.
Qed.

Lemma PI_above_3_1 : 31/10 < PI.
Proof.
  assert (HPI := PI2_1). set (a := PI/12). assert (A0 : 0 < a) by (unfold a; lra).
  assert (S : sin a < a) by (now apply sin_lt_x). assert (S0 : 0 < sin a) by (apply sin_gt_0; unfold a; lra).
  assert (C2 := cos_2a_sin a). replace (2 * a) with (PI/6) in C2 by (unfold a; field). rewrite cos_PI6 in C2.
  assert (R3 := sqrt_sqrt 3 ltac:(lra)). assert (P3 := sqrt_pos 3). assert (L3 : sqrt 3 < 17321/10000) by nra.
  assert (Q : sin a * sin a < a * a) by nra. assert (K : 66975/1000000 < a * a) by lra. unfold a in K. nra.
Qed.
(** pi/12 <= tan (pi/12) = 1/(2 + sqrt 3). *)
Lemma PI_below_3_22 : PI < 322/100.
Proof.
  assert (HPI := PI2_1). set (a := PI/12). assert (T := sin_below_tangent a 0 ltac:(unfold a; lra) ltac:(lra)).
  rewrite sin_0 in T. assert (C := cos_gt_0 a ltac:(unfold a; lra) ltac:(unfold a; lra)).
  assert (S2 := sin_2a a). assert (C2 := cos_2a_cos a). replace (2 * a) with (PI/6) in S2, C2 by (unfold a; field).
  rewrite sin_PI6 in S2. rewrite cos_PI6 in C2. assert (R3 := sqrt_sqrt 3 ltac:(lra)). assert (P3 := sqrt_pos 3).
  assert (L3 : 173/100 < sqrt 3) by nra.
  assert (K : a * (cos a * cos a) <= sin a * cos a) by (rewrite <- Rmult_assoc; pos).
  replace (cos a * cos a) with ((2 + sqrt 3) / 4) in K by lra. unfold a in *. nra.
Qed.
