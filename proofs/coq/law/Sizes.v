(** What J loses at a step, nothing singular (L43 (c) and L49 (11) of law.md): J - J' = a d^3/U^2.

    sinc            == sin x/x
    cosines_share   == c^2 c'^2/(c + c') <= 1/2
    L43c_fall       == (8): J - J' from X - X', c - c' and the sines of beta
    L43c_X, L43c_cos, L43c_sin == these differences in closed form
    size_x, size_c, size_s, size == x^, k_c, k_s, a
    size_x1, size_after, size_before == X_1, a_p, a_A
    L49_size        == J - J' = a d^3/U^2
    L49_after, L49_before == A' = a_p d^2/U, A = a_A d^2/U *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Signs Quotients LawStatement Sines Angles Falls.
Local Open Scope R_scope.

Definition sinc x := sin x / x.

(** c and sin beta at a contact of the height cos v: V = sin v/c has V^2 = sin^2 v + eps^2. *)
Lemma beta_parts eps v : 0 < eps -> 0 < sin v -> let c := cos (beta eps v) in
  0 < c /\ sin (beta eps v) = eps / sin v * c /\ c * c * (sin v * sin v + eps * eps) = sin v * sin v.
Proof.
  intros He Hv c. assert (B := beta_pos eps v He Hv). assert (C : 0 < c) by (apply cos_gt_0; lra).
  assert (S : sin (beta eps v) = eps / sin v * c) by apply sin_of_atan. split; [exact C|]. split; [exact S|].
  assert (K := sin2_cos2 (beta eps v)). unfold Rsqr in K. rewrite S in K. fold c in K.
  replace (sin v * sin v) with (sin v * sin v * (eps / sin v * c * (eps / sin v * c) + c * c)) at 2
    by (rewrite K; ring).
  field. lra.
Qed.

Lemma cosines_share c c' : 0 < c <= 1 -> 0 < c' <= 1 -> c^2 * c'^2 / (c + c') <= 1/2.
Proof.
  intros H H'. apply quotient_at_most; [lra|]. assert (c * c' * (c * c') <= 1 * (c * c'))
    by (apply Rmult_le_compat_r; [pos | apply Rle_trans with (1 * 1); [pos | lra]]).
  assert (c * c' <= c * 1) by pos. assert (c * c' <= 1 * c') by pos.
  replace (c^2 * c'^2) with (c * c' * (c * c')) by ring. lra.
Qed.

Section Sizes.
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
Let Q := (PI - U) * cos th.
Let c := cos b.
Let c' := cos b'.
Let X := sin d * sin U / sin u - d.
Let X' := d - sin d * sin U / sin u'.

Theorem L43c_fall : invariant u (th - b) - invariant u' (th + b') =
  cos th * (c * (X - X') + X' * (c - c')) + Q * (c - c') - d * sin th * (sin b - sin b').
Proof.
  unfold c, c', X, X', Q, b, b', d, U.
  rewrite (before_is eps u u' th Hu Hu2 Hth HE), (after_is eps u u' th Hu Hu2 Hth HE). ring.
Qed.

Lemma sine_products : sin u * sin u' = sin U * sin U - sin d * sin d /\ sin u + sin u' = 2 * sin U * cos d /\
  sin u * sin u - sin u' * sin u' = sin (2 * U) * sin (2 * d).
Proof.
  assert (E : sin u = sin U * cos d + cos U * sin d)
    by (rewrite <- sin_plus; f_equal; unfold U, d, middle, half; field).
  assert (E' : sin u' = sin U * cos d - cos U * sin d)
    by (rewrite <- sin_minus; f_equal; unfold U, d, middle, half; field).
  assert (K := sin2_cos2 U). assert (M := sin2_cos2 d). unfold Rsqr in *. rewrite E, E', !sin_2a.
  repeat split; try ring.
  replace ((sin U * cos d + cos U * sin d) * (sin U * cos d - cos U * sin d)) with
    (sin U * sin U * (cos d * cos d) - cos U * cos U * (sin d * sin d)) by ring.
  replace (cos d * cos d) with (1 - sin d * sin d) by lra. replace (cos U * cos U) with (1 - sin U * sin U) by lra.
  ring.
Qed.
Theorem L43c_X : X - X' = (2 * d * (sin d * sin d) - (2 * d - sin (2 * d)) * (sin U * sin U)) / (sin U * sin U - sin d
  * sin d).
Proof.
  destruct (sines u u' Hu Hu2) as [S1 S2]. destruct sine_products as [Y [Z _]]. rewrite <- Y.
  assert (P : 0 < sin u * sin u') by (apply Rmult_lt_0_compat; lra). unfold X, X'.
  transitivity (sin d * sin U * (sin u + sin u') / (sin u * sin u') - 2 * d); [field; lra|]. rewrite Z, sin_2a.
  transitivity ((sin d * sin U * (2 * sin U * cos d) - 2 * d * (sin u * sin u')) / (sin u * sin u')); [field; lra|].
  apply (f_equal (fun t => t / (sin u * sin u'))). rewrite Y. ring.
Qed.
Theorem L43c_cos : c - c' = c^2 * c'^2 / (c + c') * eps^2 * (sin (2 * U) * sin (2 * d)) / (sin u * sin u')^2.
Proof.
  destruct (sines u u' Hu Hu2) as [S1 S2]. destruct sine_products as [_ [_ <-]].
  destruct (beta_parts eps u Heps ltac:(lra)) as [C [_ E]]. destruct (beta_parts eps u' Heps S1) as [C' [_ E']].
  fold b c in C, E. fold b' c' in C', E'. set (S := sin u) in *. set (S' := sin u') in *.
  assert (K : c^2 * c'^2 * eps^2 * (S * S - S' * S') = (c^2 - c'^2) * (S * S')^2).
  { assert (W : c * c * (eps * eps) = S * S * (1 - c * c)) by lra.
    assert (W' : c' * c' * (eps * eps) = S' * S' * (1 - c' * c')) by lra.
    replace (c^2 * c'^2 * eps^2 * (S * S - S' * S'))
      with (c * c * (S * S) * (c' * c' * (eps * eps)) - c' * c' * (S' * S') * (c * c * (eps * eps))) by ring.
    rewrite W, W'. ring. }
  apply Rmult_eq_reg_r with ((c + c') * (S * S')^2);
    [|apply Rmult_integral_contrapositive_currified;
      [lra | apply pow_nonzero, Rmult_integral_contrapositive_currified; lra]].
  transitivity ((c^2 - c'^2) * (S * S')^2); [ring|]. rewrite <- K. field. repeat split; lra.
Qed.
Theorem L43c_sin : sin b - sin b' = - (eps * (sin (2 * U) * sin (2 * d)) * c * c') / (sin u * sin u' * (sin u / c +
  sin u' / c')).
Proof.
  destruct (sines u u' Hu Hu2) as [S1 S2]. destruct sine_products as [_ [_ <-]].
  destruct (beta_parts eps u Heps ltac:(lra)) as [C [B E]]. destruct (beta_parts eps u' Heps S1) as [C' [B' E']].
  fold b in B. fold b' in B'. fold b c in C, B, E. fold b' c' in C', B', E'. rewrite B, B'. set (S := sin u) in *.
  set (S' := sin u') in *.
  assert (V : 0 < S / c) by (apply Rdiv_lt_0_compat; lra). assert (V' : 0 < S' / c') by (apply Rdiv_lt_0_compat; lra).
  (* V^2 - V'^2 = S^2 - S'^2 *)
  assert (K : S / c * (S / c) - S' / c' * (S' / c') = S * S - S' * S').
  { replace (S / c * (S / c)) with (S * S / (c * c)) by (field; lra).
    replace (S' / c' * (S' / c')) with (S' * S' / (c' * c')) by (field; lra).
    rewrite <- E at 1. rewrite <- E' at 1. field. lra. }
  rewrite <- K. set (v := S / c) in *. set (v' := S' / c') in *. replace S with (v * c) by (unfold v; field; lra).
  replace S' with (v' * c') by (unfold v'; field; lra). field. repeat split; lra.
Qed.

Let rho := d / U.
Let e := eps / (d * U).   (* eps^ *)
Definition size_x := 2 * ((sinc d / sinc U)^2 - (2 * d - sin (2 * d)) / (2 * d^3) * U^2) / (1 - (sin d / sin U)^2).
Definition size_c := c^2 * c'^2 / (c + c') * (4 * e^2 * sinc (2 * U) * sinc (2 * d)) / ((1 - rho^2)^2 * sinc u ^ 2 *
  sinc u' ^ 2).
Definition size_s := 4 * e * sinc (2 * U) * sinc (2 * d) * c * c' /
  ((1 - rho^2) * sinc u * sinc u' * ((1 + rho) * sinc u / c + (1 - rho) * sinc u' / c')).
Definition size := cos th * (c * size_x + X' * size_c * U) + Q * size_c * U + sin th * size_s * U.

Theorem L49_size : invariant u (th - b) - invariant u' (th + b') = size * d^3 / U^2.
Proof.
  destruct (sines u u' Hu Hu2) as [S1 S2]. destruct (middle_range u u' Hu Hu2) as [HU [Hd [Eu Eu']]].
  fold U in HU, Eu, Eu'. fold d in Hd, Eu, Eu'. assert (P := PI2_1).
  destruct (beta_parts eps u Heps ltac:(lra)) as [C _]. destruct (beta_parts eps u' Heps S1) as [C' _]. fold b c in C.
  fold b' c' in C'.
  assert (Ds : 0 < sin d) by (apply sin_gt_0; lra). assert (Us : 0 < sin U) by (apply sin_gt_0; lra).
  assert (ud : 0 < U - d) by lra.
  assert (sdU : sin d < sin U) by (apply sin_increasing_1; lra).
  assert (W : 0 < sin U * sin U - sin d * sin d) by (assert (sin d * sin d < sin U * sin U)
    by (apply Rmult_le_0_lt_compat; lra); lra).
  assert (W2 : 0 < U * U - d * d) by (assert (d * d < U * U) by (apply Rmult_le_0_lt_compat; lra); lra).
  assert (X1 : X - X' = size_x * d^3 / U^2) by (rewrite L43c_X; unfold size_x, sinc; field; repeat split; lra).
  assert (X2 : c - c' = size_c * d^3 / U).
  { rewrite L43c_cos. unfold size_c, sinc, e, rho. set (S := sin u) in *. set (S' := sin u') in *. rewrite Eu, Eu'.
    field. repeat split; lra. }
  assert (X3 : sin b - sin b' = - (size_s * d^2 / U)).
  { rewrite L43c_sin. unfold size_s, sinc, e, rho. set (S := sin u) in *. set (S' := sin u') in *. rewrite Eu, Eu'.
    field.
    assert (0 < S * c') by (apply Rmult_lt_0_compat; lra). assert (0 < S' * c) by (apply Rmult_lt_0_compat; lra).
    repeat split; lra. }
  rewrite L43c_fall, X1, X2, X3. unfold size. field. lra.
Qed.
(** A' = a_p d^2/U and A = a_A d^2/U. *)
Let t' := eps / (d * sin u').   (* b' of law.md: tan beta' = d b' *)
Definition size_x1 := - (cos U * sinc d + sin U * ((sin d - d * cos d) / d^2)) / ((1 - rho) * sinc u').
Definition size_after := c' * cos th * size_x1 - Q * U * (t'^2 * c'^2 / (1 + c')) - sin th * U * t' * c'.
Definition size_before := size_after + rho * size.
Theorem L49_after : invariant u' (th + b') - Q = size_after * d^2 / U.
Proof.
  destruct (sines u u' Hu Hu2) as [S1 S2]. destruct (middle_range u u' Hu Hu2) as [HU [Hd [Eu Eu']]].
  fold U in HU, Eu, Eu'. fold d in Hd, Eu, Eu'. assert (ud : 0 < U - d) by lra.
  destruct (beta_parts eps u' Heps S1) as [C' [B' E']]. fold b' in B'. fold b' c' in C', B', E'.
  assert (X1 : X' = size_x1 * d^2 / U).
  { unfold X', size_x1, sinc, rho. assert (Y : sin u' = sin U * cos d - cos U * sin d)
      by (rewrite <- sin_minus; now f_equal).
    set (S' := sin u') in *. transitivity ((d * S' - sin d * sin U) / S'); [field; lra|]. rewrite Eu'.
    transitivity ((d * (sin U * cos d - cos U * sin d) - sin d * sin U) / S'); [now rewrite <- Y | field;
      repeat split; lra]. }
  assert (K : 1 - c' = (d * t')^2 * c'^2 / (1 + c')).
  { assert (Z : d * t' = eps / sin u') by (unfold t'; field; lra). rewrite Z. set (S' := sin u') in *.
    apply Rmult_eq_reg_r with ((1 + c') * (S' * S')); [|apply Rmult_integral_contrapositive_currified;
      [lra | apply Rmult_integral_contrapositive_currified; lra]].
    transitivity (S' * S' - c' * c' * (S' * S')); [ring|]. transitivity (c' * c' * (eps * eps)); [lra|]. field. lra. }
  assert (L : sin b' = d * t' * c') by (rewrite B'; unfold t'; field; lra).
  assert (A : invariant u' (th + b') - Q = c' * cos th * X' - Q * (1 - c') - d * sin th * sin b').
  { unfold c', X', Q, b', d, U. rewrite (after_is eps u u' th Hu Hu2 Hth HE). ring. }
  rewrite A, L, K, X1. unfold size_after. field. lra.
Qed.
Theorem L49_before : invariant u (th - b) - Q = size_before * d^2 / U.
Proof.
  destruct (middle_range u u' Hu Hu2) as [HU [Hd _]]. fold U in HU. fold d in Hd.
  replace (invariant u (th - b) - Q) with ((invariant u (th - b) - invariant u' (th + b')) + (invariant u' (th + b') -
    Q)) by ring.
  rewrite L49_size, L49_after. unfold size_before, rho. field. lra.
Qed.
End Sizes.
