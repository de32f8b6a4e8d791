(** L43 (c) and L44 of law.md: J = (pi - u) cos al falls at every step, for every mass ratio; the middle invariant Q is
    above it. For the windows of L53 also by how much: |X| <= d^2 cot U.

    sines, middle_range, signs == the signs of a flight's U, d, of its sines and cosines
    seven               == sin d sin U = eps tan th (pi - U), (7)
    before_is, after_is == J and J' in terms of X, X', beta, beta'
    L44_before, L44_after, L44_falls == J <= Q, J' <= Q, J' < J
    L53_gap             == Q - J <= cos th d^2 cot U + Q beta^2/2 + d sin th beta, (16) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import LawStatement Sines Angles.
Local Open Scope R_scope.

(** A flight from u to u' at the angle th, whatever follows. *)
Section Flight.
Variables eps u u' th : R.
Hypothesis Heps : 0 < eps.
Hypothesis Hu : 0 < u' < u.
Hypothesis Hu2 : u <= PI/2.
Hypothesis Hth : 0 <= th < PI/2.
Hypothesis HE : cos u' - cos u = eps * tan th * (2 * PI - u - u').

Let b := beta eps u.
Let b' := beta eps u'.
Let U := middle u u'.
Let d := half u u'.
Let F := PI - U.
Let Q := F * cos th.
Let X := sin d * sin U / sin u - d.
Let X' := d - sin d * sin U / sin u'.

Lemma sines : 0 < sin u' < sin u.
Proof. assert (P := PI2_1). split; [apply sin_gt_0; lra | apply sin_increasing_1; lra]. Qed.
Lemma betas : 0 < b < PI/2 /\ 0 < b' < PI/2 /\ b < b'.
Proof.
  destruct sines as [S1 S2]. split; [apply beta_pos; lra|]. split; [apply beta_pos; lra|]. apply atan_increasing.
  apply Rmult_lt_compat_l; [exact Heps | apply Rinv_lt_contravar; [apply Rmult_lt_0_compat|]; lra].
Qed.
Lemma middle_range : 0 < U < PI/2 /\ 0 < d < PI/4 /\ u = U + d /\ u' = U - d.
Proof. unfold U, d, middle, half. lra. Qed.
Lemma sine_u : sin u = sin U * cos d + cos U * sin d /\ sin u' = sin U * cos d - cos U * sin d.
Proof. destruct middle_range as [_ [_ [E E']]]. rewrite E, E' at 1. now rewrite sin_plus, sin_minus. Qed.
(** (7). *)
Lemma seven : sin d * sin U = eps * tan th * F.
Proof. exact (L43b eps u u' (tan th) HE). Qed.

(** F sin th sin beta = c cos th (sin d sin U/sin u), and the same at u'. *)
Lemma lever v : 0 < sin v -> F * (sin th * sin (beta eps v)) = cos (beta eps v) * cos th * (sin d * sin U / sin v).
Proof.
  intros Hv. assert (C : 0 < cos th) by (apply cos_gt_0; lra). rewrite seven. unfold beta.
  rewrite sin_of_atan. unfold tan. field. lra.
Qed.
Theorem before_is : invariant u (th - b) = cos b * cos th * (F + X) - d * sin th * sin b.
Proof.
  destruct sines as [S1 S2]. assert (E := lever u ltac:(lra)). fold b in E. unfold invariant, X. rewrite cos_minus.
  replace (PI - u) with (F - d) by (unfold F, d, U, middle, half; field).
  replace ((F - d) * (cos th * cos b + sin th * sin b)) with
    ((F - d) * (cos b * cos th) + F * (sin th * sin b) - d * sin th * sin b) by ring. rewrite E. ring.
Qed.
Theorem after_is : invariant u' (th + b') = cos b' * cos th * (F + X') - d * sin th * sin b'.
Proof.
  destruct sines as [S1 S2]. assert (E := lever u' ltac:(lra)). fold b' in E. unfold invariant, X'. rewrite cos_plus.
  replace (PI - u') with (F + d) by (unfold F, d, U, middle, half; field).
  replace ((F + d) * (cos th * cos b' - sin th * sin b')) with
    ((F + d) * (cos b' * cos th) - F * (sin th * sin b') - d * sin th * sin b') by ring. rewrite E. ring.
Qed.

(** Signs. *)
Lemma signs : 0 < sin d /\ 0 < cos d /\ 0 < sin U <= 1 /\ 0 < cos U /\ d * cos d < sin d /\ sin d < d /\ 0 < cos th /\
  0 <= sin th /\ 0 < cos b /\ 0 < cos b' /\ 0 < F.
Proof.
  destruct middle_range as [HU [Hd _]]. destruct betas as [B1 [B2 _]]. assert (P := PI2_1).
  destruct (SIN_bound U) as [_ S1].
  repeat split; try (apply sin_gt_0; lra); try (apply cos_gt_0; lra); try (apply sin_ge_0; lra); try exact S1.
  - apply tangent_above; lra. - apply sin_lt_x; lra. - unfold F, U, middle in *. lra.
Qed.
Lemma X_is : - (X * sin u) = d * cos U * sin d - sin U * (sin d - d * cos d).
Proof. destruct sines. destruct sine_u as [E _]. unfold X. rewrite E. field. rewrite <- E. lra. Qed.
Lemma X_neg : X <= 0.
Proof.
  destruct sines as [S1 S2]. destruct signs as [D1 [D2 [U1 [U2 [T [L _]]]]]].
  destruct middle_range as [HU [Hd [E _]]].
  assert (P := PI2_1). assert (C := sin2_cos2 d). unfold Rsqr in C.
  (* cos U sin (pi/2 - d) >= sin U cos (pi/2 - d) *)
  assert (K : sin U * sin d <= cos U * cos d).
  { assert (H : 0 <= cos (U + d)) by (apply cos_ge_0; lra). rewrite cos_plus in H. lra. }
  (* (sin d - d cos d) cos d <= d sin^2 d, as sin 2d <= 2 d *)
  assert (G : (sin d - d * cos d) * cos d <= d * (sin d * sin d)).
  { assert (H : sin (2 * d) < 2 * d) by (apply sin_lt_x; lra). rewrite sin_2a in H.
    replace (d * (sin d * sin d)) with (d - d * (cos d * cos d))
      by (replace (sin d * sin d) with (1 - cos d * cos d) by lra; ring).
    lra. }
  assert (W : sin U * (sin d - d * cos d) <= d * cos U * sin d).
  { apply Rmult_le_reg_r with (cos d * sin d); [now apply Rmult_lt_0_compat|].
    replace (sin U * (sin d - d * cos d) * (cos d * sin d))
      with ((sin U * sin d) * ((sin d - d * cos d) * cos d)) by ring.
    replace (d * cos U * sin d * (cos d * sin d)) with ((cos U * cos d) * (d * (sin d * sin d))) by ring.
    apply Rmult_le_compat; try assumption; apply Rmult_le_pos; lra. }
  assert (E2 := X_is). apply Rmult_le_reg_r with (sin u); lra.
Qed.
Lemma X'_neg : X' <= 0.
Proof.
  destruct sines as [S1 S2]. destruct signs as [D1 [D2 [U1 [U2 [T [L _]]]]]]. destruct middle_range as [_ [Hd _]].
  destruct sine_u as [_ E]. assert (E2 : X' * sin u' = - (sin U * (sin d - d * cos d) + d * cos U * sin d))
    by (unfold X'; rewrite E; field; rewrite <- E; lra).
  assert (0 < sin U * (sin d - d * cos d)) by (apply Rmult_lt_0_compat; lra).
  assert (0 < d * cos U * sin d) by (repeat apply Rmult_lt_0_compat; lra). apply Rmult_le_reg_r with (sin u'); lra.
Qed.

(** A <= 0 and A' <= 0. *)
Theorem L44_before : invariant u (th - b) <= Q.
Proof.
  rewrite before_is. destruct signs as [D1 [D2 [U1 [U2 [T [L [C [S [Cb [_ HF]]]]]]]]]]. assert (HX := X_neg).
  destruct middle_range as [_ [Hd _]]. destruct betas as [B _]. assert (0 < sin b) by (apply sin_gt_0; lra).
  assert (0 <= d * sin th * sin b) by (repeat apply Rmult_le_pos; lra). destruct (COS_bound b) as [_ C1].
  assert (cos b * cos th * X <= 0) by (assert (0 <= cos b * cos th * - X) by (repeat apply Rmult_le_pos; lra); lra).
  assert (cos b * (cos th * F) <= 1 * (cos th * F)) by (apply Rmult_le_compat_r; [apply Rmult_le_pos|]; lra).
  unfold Q. lra.
Qed.
Theorem L44_after : invariant u' (th + b') <= Q.
Proof.
  rewrite after_is. destruct signs as [D1 [D2 [U1 [U2 [T [L [C [S [_ [Cb HF]]]]]]]]]]. assert (HX := X'_neg).
  destruct middle_range as [_ [Hd _]]. destruct betas as [_ [B _]]. assert (0 < sin b') by (apply sin_gt_0; lra).
  assert (0 <= d * sin th * sin b') by (repeat apply Rmult_le_pos; lra). destruct (COS_bound b') as [_ C1].
  assert (cos b' * cos th * X' <= 0) by (assert (0 <= cos b' * cos th * - X')
    by (repeat apply Rmult_le_pos; lra); lra).
  assert (cos b' * (cos th * F) <= 1 * (cos th * F)) by (apply Rmult_le_compat_r; [apply Rmult_le_pos|]; lra).
  unfold Q. lra.
Qed.
(** (16). *)
Theorem L53_gap : Q - invariant u (th - b) <= cos th * (d * d * cos U / sin U) + Q * (b * b) / 2 + d * sin th * b.
Proof.
  rewrite before_is. destruct sines as [S1 S2]. destruct signs as [D1 [D2 [U1 [U2 [T [L [C [S [Cb [_ HF]]]]]]]]]].
  destruct middle_range as [HU [Hd [E _]]]. destruct betas as [B _]. assert (P := PI2_1).
  assert (SU : sin U < sin u) by (apply sin_increasing_1; lra).
  assert (HX : - X <= d * d * cos U / sin U).
  { assert (0 <= d * cos U * (d - sin d)) by (repeat apply Rmult_le_pos; lra).
    assert (0 <= sin U * (sin d - d * cos d)) by (apply Rmult_le_pos; lra). assert (E2 := X_is).
    assert (N : 0 <= d * d * cos U) by (repeat apply Rmult_le_pos; lra).
    apply Rle_trans with (d * d * cos U / sin u).
    - apply Rmult_le_reg_r with (sin u); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
    - apply Rmult_le_compat_l; [exact N | apply Rinv_le_contravar; lra]. }
  assert (Hc := cosine_below b ltac:(lra)).
  assert (Hs : sin b <= b) by (left; apply sin_lt_x; lra). destruct (COS_bound b) as [_ C1]. assert (XN := X_neg).
  assert (Q0 : 0 < Q) by (now apply Rmult_lt_0_compat).
  assert (A1 : d * sin th * sin b <= d * sin th * b) by (apply Rmult_le_compat_l; [apply Rmult_le_pos|]; lra).
  assert (A0 : cos b * cos th <= 1 * cos th) by (apply Rmult_le_compat_r; lra).
  assert (A2 : cos b * cos th * - X <= 1 * cos th * - X) by (apply Rmult_le_compat_r; lra).
  assert (A3 : cos th * - X <= cos th * (d * d * cos U / sin U)) by (apply Rmult_le_compat_l; lra).
  assert (A4 : Q * (1 - cos b) <= Q * (b * b / 2)) by (apply Rmult_le_compat_l; lra). unfold Q in *. lra.
Qed.

Lemma X_falls : X' < X.
Proof.
  destruct sines as [S1 S2]. destruct signs as [D1 [D2 [U1 [U2 [T [L _]]]]]]. destruct middle_range as [HU [Hd _]].
  destruct sine_u as [Eu Eu']. assert (K := sin2_cos2 U). assert (M := sin2_cos2 d). unfold Rsqr in *.
  assert (Y : sin u * sin u' = sin U * sin U - sin d * sin d).
  { rewrite Eu, Eu'. replace ((sin U * cos d + cos U * sin d) * (sin U * cos d - cos U * sin d)) with
      (sin U * sin U * (cos d * cos d) - cos U * cos U * (sin d * sin d)) by ring.
    replace (cos d * cos d) with (1 - sin d * sin d) by lra. replace (cos U * cos U) with (1 - sin U * sin U) by lra.
    ring. }
  assert (P : 0 < sin u * sin u') by (apply Rmult_lt_0_compat; lra).
  assert (N : X - X' = 2 * (d * (sin d * sin d) - (d - sin d * cos d) * (sin U * sin U)) / (sin u * sin u')).
  { unfold X, X'. transitivity (sin d * sin U * (sin u + sin u') / (sin u * sin u') - 2 * d); [field; lra|].
    replace (sin u + sin u') with (2 * sin U * cos d) by (rewrite Eu, Eu'; ring). rewrite Y. field. rewrite <- Y. lra.
    }
  assert (SU : 0 <= sin U * sin U <= 1) by (assert (0 <= cos U * cos U) by apply Rle_0_sqr; split;
    [apply Rle_0_sqr | lra]).
  assert (W : d * (cos d * cos d) < sin d * cos d) by (rewrite <- Rmult_assoc; now apply Rmult_lt_compat_r).
  assert (V : 0 <= d - sin d * cos d) by (destruct (COS_bound d); assert (sin d * cos d <= sin d * 1)
    by (apply Rmult_le_compat_l; lra); lra).
  assert (G : (d - sin d * cos d) * (sin U * sin U) <= (d - sin d * cos d) * 1) by (apply Rmult_le_compat_l; lra).
  assert (E : d * (sin d * sin d) = d - d * (cos d * cos d))
    by (replace (sin d * sin d) with (1 - cos d * cos d) by lra; ring).
  assert (0 < X - X'); [|lra]. rewrite N. apply Rdiv_lt_0_compat; lra.
Qed.
(** J falls, if the rod is not turned beyond the upright by the contact at u'. *)
Theorem L44_falls : th + b' < PI/2 -> invariant u' (th + b') < invariant u (th - b).
Proof.
  intros Hal. rewrite before_is, after_is. destruct sines as [S1 S2]. destruct betas as [B1 [B2 B3]].
  destruct signs as [D1 [D2 [U1 [U2 [T [L [C [S [Cb [Cb' HF]]]]]]]]]]. destruct middle_range as [HU [Hd _]].
  assert (P := PI2_1).
  assert (Cc : cos b' < cos b) by (apply cos_decreasing_1; lra).
  assert (Ss : sin b < sin b') by (apply sin_increasing_1; lra).
  assert (K : 0 < cos (th + b')) by (apply cos_gt_0; lra). rewrite cos_plus in K. assert (HX := X_falls).
  assert (HF' : 0 < F + X').
  { assert (E := lever u' ltac:(lra)). fold b' in E.
    assert (CC : 0 < cos b' * cos th) by (now apply Rmult_lt_0_compat).
    assert (0 < F * (cos th * cos b' - sin th * sin b')) by (apply Rmult_lt_0_compat; lra).
    apply Rmult_lt_reg_l with (cos b' * cos th); [exact CC|]. unfold X'.
    assert (0 <= cos b' * cos th * d) by (apply Rmult_le_pos; lra). lra. }
  assert (A : 0 < cos b * (X - X') + (cos b - cos b') * (F + X'))
    by (apply Rplus_lt_0_compat; apply Rmult_lt_0_compat; lra).
  assert (0 < cos th * (cos b * (X - X') + (cos b - cos b') * (F + X'))) by (now apply Rmult_lt_0_compat).
  assert (0 <= d * sin th * (sin b' - sin b)) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra | lra]). lra.
Qed.
End Flight.
