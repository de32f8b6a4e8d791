(** A step of the bulk in numbers near 1 (L43 (c) and L51 of law.md): each power of eps stands apart from what is
    bounded, so that coq-interval encloses that for all eps at once.

    shares, near_one == the numbers near 1, and their ranges
    shares_of        == those of a step; shares_near == they are near 1
    sine_1, sine_2, both_sines == sin u, sin u', their product
    turning          == (al' - al)/eps
    gained           == (sin U (al' - al) - 2 eps)/eps^3
    after, fall      == (J' - Q)/eps^2 and (J - J')/eps^3
    turns_near       == beta of a contact, and what is near 1 there
    sines_are, turns_are, turns_differ, gained_is, after_is_after, fall_is == they are so *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Quotients Sines Arctangent PiValue LawStatement Angles Falls Sizes Windows BulkSines.
Local Open Scope R_scope.

(** cos d; d/sin d; (sin d - d cos d)/sin^3 d; (2 d - sin 2 d)/(4 d^3/3); at u and at u' beta/tan beta,
    3 (tan beta - beta)/tan^3 beta and cos beta; (beta' - beta)/(tan beta' - tan beta), (beta + beta')/(tan beta +
    tan beta'); (sin u/cos beta + sin u'/cos beta')/(sin u + sin u'). *)
Record shares := { cosine : R; arc : R; bow : R; chord : R; turn_1 : R; turn_2 : R; rest_1 : R; rest_2 : R;
  cos_1 : R; cos_2 : R; slow : R; slowly : R; wide : R }.
Definition nearly (x : R) := 0.99999 <= x <= 1.
Definition near_one N := (nearly (cosine N) /\ 1 <= arc N <= 1.00001 /\ 0 <= bow N <= 0.51 /\ nearly (chord N)) /\
  (nearly (turn_1 N) /\ nearly (turn_2 N) /\ nearly (rest_1 N) /\ nearly (rest_2 N)) /\
  (nearly (cos_1 N) /\ nearly (cos_2 N) /\ nearly (slow N) /\ nearly (slowly N) /\ 1 <= wide N <= 1.00002).
Definition shares_of eps u u' := {| cosine := cos (half u u'); arc := half u u' / sin (half u u');
  bow := (sin (half u u') - half u u' * cos (half u u')) / sin (half u u') ^ 3;
  chord := (2 * half u u' - sin (2 * half u u')) / (4/3 * half u u' ^ 3);
  turn_1 := beta eps u * sin u / eps; turn_2 := beta eps u' * sin u' / eps;
  rest_1 := 3 * (eps / sin u - beta eps u) / (eps / sin u)^3;
  rest_2 := 3 * (eps / sin u' - beta eps u') / (eps / sin u')^3;
  cos_1 := cos (beta eps u); cos_2 := cos (beta eps u');
  slow := (beta eps u' - beta eps u) / (eps / sin u' - eps / sin u);
  slowly := (beta eps u + beta eps u') / (eps / sin u + eps / sin u');
  wide := (sin u / cos (beta eps u) + sin u' / cos (beta eps u')) / (sin u + sin u') |}.

(** S and K are the sine and the cosine of U, t is sin d/eps. *)
Section Values.
Variables (th Q S K t eps : R) (N : shares).
Definition sine_1 := S * cosine N + K * (eps * t).
Definition sine_2 := S * cosine N - K * (eps * t).
Definition both_sines := S^2 - (eps * t)^2.
Definition turning := slowly N * (2 * S * cosine N / both_sines).
Definition gained := S * (t^2 / (1 + cosine N)) * (2 * S * cosine N / both_sines) + 2 * (K * t)^2 / both_sines -
  S * (rest_1 N / sine_1^3 + rest_2 N / sine_2^3) / 3.
Definition moved := - (S * eps * t^3 * bow N + K * t^2 * arc N) / sine_2.   (* X'/eps^2 *)
Definition after := cos_2 N * cos th * moved - Q * ((cos_2 N)^2 / ((1 + cos_2 N) * sine_2^2)) -
  t * arc N * sin th * (cos_2 N / sine_2).
Definition less_cos := (cos_1 N)^2 * (cos_2 N)^2 / (cos_1 N + cos_2 N) * (4 * S * K * cosine N * t) / both_sines^2.
Definition more_sin := 2 * K * t * cos_1 N * cos_2 N / (both_sines * wide N).
Definition fall := cos th * (cos_1 N * ((2 * t^3 * arc N - 4/3 * (t * arc N)^3 * chord N * S^2) / both_sines) +
  eps^2 * moved * less_cos) + Q * less_cos + t * arc N * sin th * more_sin.
End Values.

Lemma turns_near eps w : 0 < eps <= 1/1000 -> 0.776 <= sin w -> let x := eps / sin w in let B := beta eps w in
  0 < x <= 0.0013 /\ nearly (B * sin w / eps) /\ nearly (3 * (x - B) / x^3) /\ nearly (cos B) /\ 0 < B <= 0.0013 /\
  0.99999 * x <= B <= x.
Proof.
  intros Heps Hv x B. assert (X : 0 < x <= 0.0013) by (split; [apply Rdiv_lt_0_compat | apply quotient_at_most]; lra).
  assert (A := arctangent_near x ltac:(lra)). change (atan x) with B in A. assert (B0 : 0 < B).
  { unfold B, beta. rewrite <- atan_0. apply atan_increasing. unfold x in X. lra. }
  assert (x2 : x * x <= 0.0013 * 0.0013) by (apply Rmult_le_compat; lra).
  assert (0 < x * x) by (apply Rmult_lt_0_compat; lra). assert (x3 : 0 < x^3) by (apply pow_lt; lra).
  assert (E3 : x^3 <= 0.0013 * 0.0013 * x) by (replace (x^3) with (x * x * x) by ring; apply Rmult_le_compat_r; lra).
  assert (E5 : x^5 <= 0.0013 * 0.0013 * x^3)
    by (replace (x^5) with (x * x * x^3) by ring; apply Rmult_le_compat_r; lra).
  assert (C := cosine_below B ltac:(lra)). destruct (COS_bound B).
  assert (B * B <= 0.0013 * 0.0013) by (apply Rmult_le_compat; lra).
  split; [exact X|]. split; [|split; [|unfold nearly; repeat split; lra]].
  - replace (B * sin w / eps) with (B / x) by (unfold x; field; lra).
    split; [apply quotient_at_least | apply quotient_at_most]; lra.
  - split; [apply quotient_at_least | apply quotient_at_most]; lra.
Qed.

Section Step.
Variables eps u u' th : R.
Hypothesis Heps : 0 < eps <= 1/1000.
Hypothesis Hu : 0 < u' < u.
Hypothesis Hu2 : u <= PI/2.
Hypothesis Hth : 0 <= th <= 0.7944.
Hypothesis HE : cos u' - cos u = eps * tan th * (2 * PI - u - u').
Let b := beta eps u.
Let b' := beta eps u'.
Let U := middle u u'.
Let d := half u u'.
Let Q := (PI - U) * cos th.
Hypothesis HQ : near_half_pi Q.
Let S := sine_U th Q.
Let K := cosine_U th Q.
Let t := tilt th Q.
Let N := shares_of eps u u'.
Let v := sine_1 S K t eps N.
Let v' := sine_2 S K t eps N.

Lemma flight : S = sin U /\ K = cos U /\ sin d = eps * t.
Proof. apply flight_is; assumption. Qed.
Lemma t_is : sin d = eps * t.
Proof. apply flight. Qed.
Lemma small_d : 0 < sin d /\ sin d <= d <= 1.00001 * sin d /\ d <= 0.0031 /\ 0.99999 <= cos d <= 1.
Proof. apply (small eps u u' th); assumption. Qed.
Lemma sines_are : sin u = v /\ sin u' = v' /\ sin u * sin u' = both_sines S t eps /\ sin u + sin u' = 2 * S * cos d /\
  0.776 <= sin u' < sin u.
Proof.
  destruct flight as [ES [EK _]].
  destruct (sine_u u u' th Hu Hu2 ltac:(assert (P := pi_value); lra)) as [E E']. fold U d in E, E'.
  destruct (sine_products u u') as [M [A _]]. fold U d in M, A. rewrite <- ES in *. rewrite <- EK in *.
  rewrite t_is in *.
  assert (R : sin d <= 0.003 /\ 0.78 <= sin U) by (apply (bulk_sines eps u u' th); assumption).
  rewrite <- ES, t_is in R. destruct R as [Hs HS].
  destruct small_d as [s0 [_ [_ C]]]. rewrite t_is in s0. destruct (sines u u' Hu Hu2) as [_ L].
  split; [exact E|]. split; [exact E'|]. split; [rewrite M; unfold both_sines; ring|]. split; [exact A|].
  split; [|exact L]. rewrite E'. destruct (COS_bound U) as [_ K1]. rewrite <- EK in K1.
  assert (S * 0.99999 <= S * cos d) by (apply Rmult_le_compat_l; lra).
  assert (K * (eps * t) <= 1 * (eps * t)) by (apply Rmult_le_compat_r; lra). lra.
Qed.
Theorem shares_near : near_one N.
Proof.
  destruct small_d as [s0 [[D0 D1] [D2 C]]]. destruct sines_are as [_ [_ [_ [_ [L1 L2]]]]].
  destruct (turns_near eps u Heps ltac:(lra)) as [X [T [R [B [_ Y]]]]].
  destruct (turns_near eps u' Heps ltac:(lra)) as [X' [T' [R' [B' [_ Y']]]]].
  assert (s3 : 0 < sin d ^ 3) by (apply pow_lt; lra). assert (d3 : 0 < d^3) by (apply pow_lt; lra).
  assert (P := pi_value). unfold near_one, N, shares_of. cbn -[pow]. fold d.
  split; [|split; [tauto | split; [exact B | split; [exact B'|]]]].
  - split; [exact C|]. split; [split; [apply quotient_at_least | apply quotient_at_most]; lra|]. split.
    + split; [apply Rle_mult_inv_pos; [assert (H := tangent_above d ltac:(lra))|]; lra|].
      apply quotient_at_most; [lra|].
      assert (H := cosine_below d ltac:(lra)).
      assert (d * (1 - d * d / 2) <= d * cos d) by (apply Rmult_le_compat_l; lra).
      assert (I : d^3 <= (1.00001 * sin d)^3) by (apply pow_incr; lra). rewrite Rpow_mult_distr in I.
      assert (1.00001^3 * sin d ^ 3 <= 1.001 * sin d ^ 3) by (apply Rmult_le_compat_r; lra). lra.
    + assert (H := sine_above (2 * d) ltac:(lra)). assert (G := sine_below (2 * d) ltac:(lra)).
      assert (dd : d * d <= 0.0031 * 0.0031) by (apply Rmult_le_compat; lra).
      assert (d^5 <= 0.0031 * 0.0031 * d^3)
        by (replace (d^5) with (d * d * d^3) by ring; apply Rmult_le_compat_r; lra).
      replace ((2 * d)^3) with (8 * d^3) in H by ring. replace ((2 * d)^5) with (32 * d^5) in H by ring.
      split; [apply quotient_at_least | apply quotient_at_most]; lra.
  - set (x := eps / sin u) in *. set (x' := eps / sin u') in *. assert (Z : x < x')
      by (apply Rmult_lt_compat_l; [lra | apply Rinv_lt_contravar; [apply Rmult_lt_0_compat|]; lra]).
    assert (A := arctangent_rise x x' ltac:(lra)). change (atan x') with b' in A. change (atan x) with b in A.
    assert (x2 : x'^2 <= 0.0013^2) by (apply pow_incr; lra).
    assert (I : (x' - x) * (1 - 0.0013^2) <= (x' - x) * (1 - x'^2)) by (apply Rmult_le_compat_l; lra).
    fold b b' in Y, Y', B, B' |- *. split; [split; [apply quotient_at_least | apply quotient_at_most]; lra|].
    split; [split; [apply quotient_at_least | apply quotient_at_most]; lra|].
    assert (V : forall y c, 0 < y -> nearly c -> y <= y / c <= 1.00002 * y).
    { intros y c Hy Hc. unfold nearly in Hc. split; [apply divided_by_share; lra | apply quotient_at_most; [lra|]].
      assert (1.00002 * y * 0.99999 <= 1.00002 * y * c) by (apply Rmult_le_compat_l; lra). lra. }
    assert (V1 := V (sin u) _ ltac:(lra) B). assert (V2 := V (sin u') _ ltac:(lra) B').
    split; [apply quotient_at_least | apply quotient_at_most]; lra.
Qed.

(** What they stand for. *)
Ltac numbers := unfold N, shares_of; cbn [cosine arc bow chord turn_1 turn_2 rest_1 rest_2 cos_1 cos_2 slow slowly
  wide]; fold b b' d.
Lemma turns_are : b = eps * (turn_1 N / v) /\ b' = eps * (turn_2 N / v') /\ b + b' = eps * turning S t eps N.
Proof.
  destruct sines_are as [E [E' [M [A [L1 L2]]]]]. unfold turning. rewrite <- E, <- E', <- M.
  change (cosine N) with (cos d). rewrite <- A. numbers.
  assert (0 < eps * (sin u + sin u')) by (apply Rmult_lt_0_compat; lra). repeat split; field; repeat split; lra.
Qed.
Lemma turns_differ : b' - b = eps^2 * (2 * K * t * slow N / both_sines S t eps).
Proof.
  destruct sines_are as [E [E' [M [_ [L1 L2]]]]]. assert (D : sin u - sin u' = 2 * K * (eps * t))
    by (rewrite E, E'; unfold v, v', sine_1, sine_2; ring).
  rewrite <- M. replace (2 * K * t) with ((sin u - sin u') / eps) by (rewrite D; field; lra). numbers.
  assert (0 < eps * (sin u - sin u')) by (apply Rmult_lt_0_compat; lra). field. repeat split; lra.
Qed.
Lemma gained_is : S * (b + b') - 2 * eps = eps^3 * gained S K t eps N.
Proof.
  destruct sines_are as [E [E' [M [A [L1 L2]]]]]. destruct small_d as [_ [_ [_ C]]].
  assert (B : b = eps / sin u - (eps / sin u)^3 * rest_1 N / 3) by (numbers; field; repeat split; lra).
  assert (B' : b' = eps / sin u' - (eps / sin u')^3 * rest_2 N / 3) by (numbers; field; repeat split; lra).
  assert (T : t^2 / (1 + cos d) = (1 - cos d) / eps^2).
  { assert (P := sin2_cos2 d). unfold Rsqr in P. rewrite t_is in P. apply Rmult_eq_reg_r with (eps^2 * (1 + cos d));
      [|apply Rmult_integral_contrapositive_currified; [apply pow_nonzero|]; lra].
    transitivity (1 - cos d * cos d); [|field; lra]. transitivity (eps * t * (eps * t)); [field; lra | lra]. }
  assert (M2 : sin u * sin u' = (S * cos d)^2 - (K * (eps * t))^2).
  { rewrite E, E'. unfold v, v', sine_1, sine_2. change (cosine N) with (cos d). ring. }
  unfold gained. fold v v'. change (cosine N) with (cos d). rewrite T, <- E, <- E', <- M, <- A. rewrite B, B' at 1.
  assert (Z : S * (1 / sin u + 1 / sin u') - 2 =
    S * (1 - cos d) * ((sin u + sin u') / (sin u * sin u')) + eps^2 * (2 * (K * t)^2 / (sin u * sin u'))).
  { apply Rmult_eq_reg_r with (sin u * sin u'); [|apply Rmult_integral_contrapositive_currified; lra].
    transitivity (S * (sin u + sin u') - 2 * (sin u * sin u')); [field; lra|].
    transitivity (S * (1 - cos d) * (sin u + sin u') + 2 * (K * (eps * t))^2); [|field; lra]. rewrite A, M2. ring. }
  transitivity (eps * (S * (1 / sin u + 1 / sin u') - 2) - eps^3 * (S * (rest_1 N / sin u ^ 3 +
    rest_2 N / sin u' ^ 3) / 3)); [field; lra|].
  rewrite Z. field. lra.
Qed.
Lemma moved_is : d - sin d * S / sin u' = eps^2 * moved S K t eps N.
Proof.
  destruct sines_are as [_ [E' [_ [_ [L1 L2]]]]]. destruct small_d as [s0 _].
  assert (T : t = sin d / eps) by (rewrite t_is; field; lra). unfold moved. fold v'. rewrite <- E'.
  assert (A : d * sin u' - sin d * S = d * (S * cos d - K * sin d) - sin d * S)
    by (rewrite E'; unfold v', sine_2; rewrite t_is; numbers; ring).
  transitivity ((d * sin u' - sin d * S) / sin u'); [field; lra|]. rewrite A. numbers. rewrite T. field. lra.
Qed.
Lemma arc_is : d = eps * (t * arc N).
Proof. destruct small_d as [s0 _]. numbers. rewrite <- Rmult_assoc, <- t_is. field. lra. Qed.
Lemma after_is_after : invariant u' (th + b') - Q = eps^2 * after th Q S K t eps N.
Proof.
  assert (P := pi_value). destruct sines_are as [_ [E' [_ [_ [L1 L2]]]]]. destruct flight as [ES _].
  destruct (beta_parts eps u' (proj1 Heps) ltac:(lra)) as [C [B W]]. fold b' in C, B, W.
  assert (K1 : 1 - cos b' = eps^2 * ((cos b')^2 / ((1 + cos b') * sin u' ^ 2))).
  { apply Rmult_eq_reg_r with ((1 + cos b') * sin u' ^ 2);
      [|apply Rmult_integral_contrapositive_currified; [|apply pow_nonzero]; lra].
    transitivity (sin u' * sin u' - cos b' * cos b' * (sin u' * sin u')); [ring|].
    transitivity (cos b' * cos b' * (eps * eps)); [lra | field; lra]. }
  assert (A := after_is eps u u' th Hu Hu2 ltac:(lra) HE). fold b' U d in A. rewrite <- ES in A. rewrite A.
  unfold after. fold v'. rewrite <- E'. change (cos_2 N) with (cos b').
  transitivity (cos b' * cos th * (d - sin d * S / sin u') - Q * (1 - cos b') - d * sin th * sin b');
    [unfold Q; ring|].
  rewrite moved_is, K1, B, arc_is. field. lra.
Qed.
Theorem fall_is : invariant u (th - b) - invariant u' (th + b') = eps^3 * fall th Q S K t eps N.
Proof.
  assert (P := pi_value). destruct sines_are as [_ [_ [M [A [L1 L2]]]]]. destruct small_d as [s0 [[D0 _] [_ C]]].
  destruct flight as [ES [EK _]].
  destruct (beta_parts eps u (proj1 Heps) ltac:(lra)) as [Cb _]. fold b in Cb.
  destruct (beta_parts eps u' (proj1 Heps) ltac:(lra)) as [Cb' _]. fold b' in Cb'.
  assert (H : 2 * d - sin (2 * d) = 4/3 * d^3 * chord N) by (numbers; field; lra).
  assert (DD : sin (2 * U) * sin (2 * d) = (sin u + sin u') * (2 * K * (eps * t)))
    by (rewrite !sin_2a, <- ES, <- EK, t_is, A; ring).
  assert (X := L43c_X u u' Hu Hu2). fold U d in X. assert (W := proj1 (sine_products u u')). fold U d in W.
  rewrite <- W, H, <- ES in X.
  assert (Y := L43c_cos eps u u' (proj1 Heps) Hu Hu2). fold b b' U d in Y. rewrite DD in Y.
  assert (Z := L43c_sin eps u u' (proj1 Heps) Hu Hu2). fold b b' U d in Z. rewrite DD in Z.
  assert (L := L43c_fall eps u u' th Hu Hu2 ltac:(lra) HE). fold b b' U d in L. rewrite <- ES in L. fold Q in L.
  rewrite L, X, Y, Z, moved_is. unfold fall, less_cos, more_sin. rewrite <- M.
  replace (4 * S * K * cosine N * t) with ((sin u + sin u') * (2 * K * t))
    by (rewrite A; change (cosine N) with (cos d); ring).
  replace (wide N) with ((sin u / cos b + sin u' / cos b') / (sin u + sin u')) by (numbers; reflexivity).
  change (cos_1 N) with (cos b). change (cos_2 N) with (cos b'). set (m := moved S K t eps N). set (j := chord N).
  assert (G := arc_is). set (g := arc N) in *. rewrite t_is, G. set (c := cos b) in *. set (c' := cos b') in *. field.
  assert (0 < sin u * c') by (apply Rmult_lt_0_compat; lra).
  assert (0 < sin u' * c) by (apply Rmult_lt_0_compat; lra).
  repeat split; lra.
Qed.
End Step.
