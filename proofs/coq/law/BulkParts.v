(** A step of the bulk in numbers near 1 (L43 (c) and L51 of law.md): each power of eps stands before what is bounded, so
    that coq-interval encloses it for all eps at once.

    shares, near_one == the numbers near 1, and their ranges
    sine_1, sine_2   == sin u and sin u' of a step
    turned           == (al' - al)/eps
    after, fall      == (J' - Q)/eps^2 and (J - J')/eps^3
    gained           == (sin U (al' - al) - 2 eps)/eps^3
    shares_of        == the numbers near 1 of a step; shares_near_one == they are near 1
    turns_are, turns_differ, gained_is, after_is_after, fall_is == what these parts stand for *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Quotients Sines Arctangent PiValue LawStatement Angles Falls Sizes BulkFalls.
Local Open Scope R_scope.

(** cos d; d/sin d; (sin d - d cos d)/sin^3 d; (2 d - sin 2 d)/(4 d^3/3); beta/tan beta and 3 (tan beta - beta)/tan^3 beta
    and cos beta, at u and at u'; (beta' - beta)/(tan beta' - tan beta). *)
Record shares := { cosine : R; arc : R; bow : R; chord : R; turn_1 : R; turn_2 : R; rest_1 : R; rest_2 : R;
  cos_1 : R; cos_2 : R; slow : R }.
Definition nearly (x : R) := 0.99999 <= x <= 1.
Definition near_one N := (nearly (cosine N) /\ 1 <= arc N <= 1.0001 /\ 0 <= bow N <= 0.51 /\ 0.9999 <= chord N <= 1) /\
  (nearly (turn_1 N) /\ nearly (turn_2 N) /\ nearly (rest_1 N) /\ nearly (rest_2 N)) /\
  (nearly (cos_1 N) /\ nearly (cos_2 N) /\ nearly (slow N)).

(** S and K are the sine and the cosine of U, t is sin d/eps. *)
Section Values.
Variables (th Q S K t eps : R) (N : shares).
Definition sine_1 := S * cosine N + K * (eps * t).
Definition sine_2 := S * cosine N - K * (eps * t).
Definition turned := turn_1 N / sine_1 + turn_2 N / sine_2.
Definition gained := S * (t^2 / (1 + cosine N)) * (1 / sine_1 + 1 / sine_2) + 2 * (K * t)^2 / (sine_1 * sine_2) -
  S * (rest_1 N / sine_1^3 + rest_2 N / sine_2^3) / 3.
Definition moved := - (S * eps * t^3 * bow N + K * t^2 * arc N) / sine_2.   (* X'/eps^2 *)
Definition after := cos_2 N * cos th * moved - Q * ((cos_2 N)^2 / ((1 + cos_2 N) * sine_2^2)) -
  t * arc N * sin th * (cos_2 N / sine_2).
Definition doubles := 4 * S * K * cosine N * t.   (* sin 2U sin 2d/eps *)
Definition less_cos := (cos_1 N)^2 * (cos_2 N)^2 / (cos_1 N + cos_2 N) * doubles / (sine_1 * sine_2)^2.
Definition more_sin := doubles * cos_1 N * cos_2 N / (sine_1 * sine_2 * (sine_1 / cos_1 N + sine_2 / cos_2 N)).
Definition fall := cos th * (cos_1 N * ((2 * t^3 * arc N - 4/3 * (t * arc N)^3 * chord N * S^2) / (sine_1 * sine_2)) +
  eps^2 * moved * less_cos) + Q * less_cos + t * arc N * sin th * more_sin.
End Values.

Definition shares_of eps u u' := {| cosine := cos (half u u'); arc := half u u' / sin (half u u');
  bow := (sin (half u u') - half u u' * cos (half u u')) / sin (half u u') ^ 3;
  chord := (2 * half u u' - sin (2 * half u u')) / (4/3 * half u u' ^ 3);
  turn_1 := beta eps u * sin u / eps; turn_2 := beta eps u' * sin u' / eps;
  rest_1 := 3 * (eps / sin u - beta eps u) / (eps / sin u)^3;
  rest_2 := 3 * (eps / sin u' - beta eps u') / (eps / sin u')^3;
  cos_1 := cos (beta eps u); cos_2 := cos (beta eps u');
  slow := (beta eps u' - beta eps u) / (eps / sin u' - eps / sin u) |}.

Section Step.
Variables eps u u' th : R.
Hypothesis Heps : 0 < eps <= 1/1000.
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
Let S := sin U.
Let K := cos U.
Let t := tan th * F / S.
Hypothesis Hs : sin d <= 0.003.
Hypothesis HS : 0.78 <= S.

Let N := shares_of eps u u'.

Lemma t_is : sin d = eps * t.
Proof.
  assert (Z := seven eps u u' th HE). fold U d S F in Z. unfold t. apply Rmult_eq_reg_r with S; [|lra]. rewrite Z.
  field. lra.
Qed.
Lemma sines_are : sin u = sine_1 S K t eps N /\ sin u' = sine_2 S K t eps N /\ 0.776 <= sin u' < sin u.
Proof.
  destruct (sine_u u u' th Hu Hu2 Hth) as [E E']. fold U d S K in E, E'.
  destruct (small u u' Hu Hu2 Hs HS) as [s0 [_ [_ [_ [C _]]]]]. fold d in s0, C.
  destruct (sines u u' Hu Hu2) as [_ L]. unfold sine_1, sine_2, N, shares_of, cosine; fold b b' d. rewrite <- t_is.
  split; [exact E|]. split; [exact E'|]. split; [|exact L]. rewrite E'. destruct (COS_bound U) as [_ K1]. fold K in K1.
  assert (S * 0.99999 <= S * cos d) by (apply Rmult_le_compat_l; lra).
  assert (K * sin d <= 1 * sin d) by (apply Rmult_le_compat_r; lra). lra.
Qed.
Lemma turns_near v : 0.776 <= sin v -> let x := eps / sin v in 0 < x <= 0.0013 /\ nearly (beta eps v * sin v / eps) /\
  nearly (3 * (x - beta eps v) / x^3) /\ nearly (cos (beta eps v)) /\ 0 < beta eps v <= 0.0013.
Proof.
  intros Hv x. assert (X : 0 < x <= 0.0013) by (split; [apply Rdiv_lt_0_compat | apply quotient_at_most]; lra).
  assert (A := arctangent_near x ltac:(lra)). unfold beta. fold x. assert (B : 0 < atan x).
  { rewrite <- atan_0. apply atan_increasing. lra. }
  assert (x2 : x * x <= 0.0013 * 0.0013) by (apply Rmult_le_compat; lra). assert (0 < x * x) by (apply Rmult_lt_0_compat; lra).
  assert (x3 : 0 < x^3) by (apply pow_lt; lra).
  assert (E3 : x^3 <= 0.0013 * 0.0013 * x) by (replace (x^3) with (x * x * x) by ring; apply Rmult_le_compat_r; lra).
  assert (E5 : x^5 <= 0.0013 * 0.0013 * x^3) by (replace (x^5) with (x * x * x^3) by ring; apply Rmult_le_compat_r; lra).
  assert (C := cosine_below (atan x) ltac:(lra)). destruct (COS_bound (atan x)).
  assert (atan x * atan x <= 0.0013 * 0.0013) by (apply Rmult_le_compat; lra).
  split; [exact X|]. split; [|split; [|unfold nearly; repeat split; lra]].
  - replace (atan x * sin v / eps) with (atan x / x) by (unfold x; field; lra).
    split; [apply quotient_at_least | apply quotient_at_most]; lra.
  - split; [apply quotient_at_least | apply quotient_at_most]; lra.
Qed.
Theorem shares_near_one : near_one N.
Proof.
  destruct (small u u' Hu Hu2 Hs HS) as [s0 [[D0 D1] [D2 [_ C]]]]. fold d in s0, D0, D1, D2, C.
  destruct sines_are as [_ [_ [L1 L2]]].
  destruct (turns_near u ltac:(lra)) as [X [T [R [B _]]]]. destruct (turns_near u' ltac:(lra)) as [X' [T' [R' [B' _]]]].
  cbv zeta in R, R'. assert (s3 : 0 < sin d ^ 3) by (apply pow_lt; lra). assert (d3 : 0 < d^3) by (apply pow_lt; lra).
  assert (P := pi_value). unfold near_one, N, shares_of. cbn -[pow]. fold d b b'. split; [|split; [tauto | split; [exact B | split; [exact B'|]]]].
  - split; [exact C|]. split; [split; [apply quotient_at_least | apply quotient_at_most]; lra|]. split.
    + split; [apply Rle_mult_inv_pos; [assert (H := tangent_above d ltac:(lra))|]; lra|]. apply quotient_at_most; [lra|].
      assert (H := cosine_below d ltac:(lra)). assert (sin d <= d) by lra.
      assert (d * (1 - d * d / 2) <= d * cos d) by (apply Rmult_le_compat_l; lra).
      assert (I : d^3 <= (1.0001 * sin d)^3) by (apply pow_incr; lra). rewrite Rpow_mult_distr in I.
      assert (1.0001^3 * sin d ^ 3 <= 1.001 * sin d ^ 3) by (apply Rmult_le_compat_r; lra).
      lra.
    + assert (H := sine_above (2 * d) ltac:(lra)). assert (G := sine_below (2 * d) ltac:(lra)).
      assert (dd : d * d <= 0.0031 * 0.0031) by (apply Rmult_le_compat; lra).
      assert (d^5 <= 0.00001 * d^3) by (replace (d^5) with (d * d * d^3) by ring; apply Rmult_le_compat_r; lra).
      replace ((2 * d)^3) with (8 * d^3) in H by ring. replace ((2 * d)^5) with (32 * d^5) in H by ring.
      split; [apply quotient_at_least | apply quotient_at_most]; lra.
  - assert (Y : eps / sin u < eps / sin u')
      by (apply Rmult_lt_compat_l; [lra | apply Rinv_lt_contravar; [apply Rmult_lt_0_compat|]; lra]).
    assert (A := arctangent_rise (eps / sin u) (eps / sin u') ltac:(lra)).
    change (atan (eps / sin u')) with b' in A. change (atan (eps / sin u)) with b in A.
    assert (x2 : (eps / sin u')^2 <= 0.0013^2) by (apply pow_incr; lra).
    assert (I : (eps / sin u' - eps / sin u) * (1 - 0.0013^2) <= (eps / sin u' - eps / sin u) * (1 - (eps / sin u')^2))
      by (apply Rmult_le_compat_l; lra).
    split; [apply quotient_at_least | apply quotient_at_most]; lra.
Qed.

(** What they stand for. *)
Lemma turns_are : b = eps * (turn_1 N / sine_1 S K t eps N) /\ b' = eps * (turn_2 N / sine_2 S K t eps N) /\
  b + b' = eps * turned S K t eps N.
Proof.
  destruct sines_are as [E [E' [L1 L2]]]. unfold turned. rewrite <- E, <- E'. unfold N, shares_of, turn_1, turn_2; fold b b' d.
  repeat split; field; lra.
Qed.
Lemma turns_differ : b' - b = eps^2 * (2 * K * t * slow N / (sine_1 S K t eps N * sine_2 S K t eps N)).
Proof.
  destruct sines_are as [E [E' [L1 L2]]]. assert (D : sin u - sin u' = 2 * K * (eps * t))
    by (rewrite E, E'; unfold sine_1, sine_2; ring).
  rewrite <- E, <- E'. replace (2 * K * t) with ((sin u - sin u') / eps) by (rewrite D; field; lra).
  unfold N, shares_of, slow; fold b b' d. assert (0 < eps * (sin u - sin u')) by (apply Rmult_lt_0_compat; lra). field. repeat split; lra.
Qed.
Lemma gained_is : S * (b + b') - 2 * eps = eps^3 * gained S K t eps N.
Proof.
  destruct sines_are as [E [E' [L1 L2]]]. destruct (small u u' Hu Hu2 Hs HS) as [s0 [_ [_ [_ C]]]]. fold d in s0, C.
  assert (B : b = eps / sin u - (eps / sin u)^3 * rest_1 N / 3) by (unfold N, shares_of, rest_1; fold b b' d; field; repeat split; lra).
  assert (B' : b' = eps / sin u' - (eps / sin u')^3 * rest_2 N / 3) by (unfold N, shares_of, rest_2; fold b b' d; field; repeat split; lra).
  assert (T : t^2 / (1 + cosine N) = (1 - cosine N) / eps^2).
  { unfold N, shares_of, cosine; fold b b' d. assert (P := sin2_cos2 d). unfold Rsqr in P. rewrite t_is in P.
    apply Rmult_eq_reg_r with (eps^2 * (1 + cos d));
      [|apply Rmult_integral_contrapositive_currified; [apply pow_nonzero|]; lra].
    transitivity (1 - cos d * cos d); [|field; lra]. transitivity (eps * t * (eps * t)); [field; lra | lra]. }
  unfold gained. rewrite T, <- E, <- E'. rewrite B, B' at 1.
  assert (Z : S * (1 / sin u + 1 / sin u') - 2 =
    S * (1 - cosine N) * (1 / sin u + 1 / sin u') + eps^2 * (2 * (K * t)^2 / (sin u * sin u'))).
  { assert (A : sin u + sin u' = 2 * S * cosine N) by (rewrite E, E'; unfold sine_1, sine_2; ring).
    assert (M : sin u * sin u' = (S * cosine N)^2 - (K * (eps * t))^2) by (rewrite E, E'; unfold sine_1, sine_2; ring).
    apply Rmult_eq_reg_r with (sin u * sin u'); [|apply Rmult_integral_contrapositive_currified; lra].
    transitivity (S * (sin u + sin u') - 2 * (sin u * sin u')); [field; lra|].
    transitivity (S * (1 - cosine N) * (sin u + sin u') + 2 * (K * (eps * t))^2); [|field; lra].
    rewrite A, M. ring. }
  transitivity (eps * (S * (1 / sin u + 1 / sin u') - 2) - eps^3 * (S * (rest_1 N / sin u ^ 3 + rest_2 N / sin u' ^ 3) / 3));
    [field; lra|].
  rewrite Z. field. lra.
Qed.
Lemma moved_is : d - sin d * S / sin u' = eps^2 * moved S K t eps N.
Proof.
  destruct sines_are as [E [E' [L1 L2]]]. destruct (small u u' Hu Hu2 Hs HS) as [s0 _]. fold d in s0.
  assert (T : t = sin d / eps) by (rewrite t_is; field; lra). unfold moved. rewrite <- E'.
  assert (A : d * sin u' - sin d * S = d * (S * cos d - K * sin d) - sin d * S)
    by (rewrite E'; unfold sine_2, N, shares_of, cosine; fold b b' d; rewrite t_is; ring).
  transitivity ((d * sin u' - sin d * S) / sin u'); [field; lra|]. rewrite A. unfold N, shares_of, bow, arc; fold b b' d. rewrite T. field. lra.
Qed.
Lemma after_is_after : invariant u' (th + b') - Q = eps^2 * after th Q S K t eps N.
Proof.
  destruct sines_are as [E [E' [L1 L2]]]. destruct (small u u' Hu Hu2 Hs HS) as [s0 _]. fold d in s0.
  destruct (beta_parts eps u' (proj1 Heps) ltac:(lra)) as [C [B W]]. fold b' in C, B, W.
  assert (G : d = eps * (t * arc N)) by (unfold N, shares_of, arc; fold b b' d; rewrite <- Rmult_assoc, <- t_is; field; lra).
  assert (K1 : 1 - cos b' = eps^2 * ((cos b')^2 / ((1 + cos b') * sin u' ^ 2))).
  { apply Rmult_eq_reg_r with ((1 + cos b') * sin u' ^ 2);
      [|apply Rmult_integral_contrapositive_currified; [|apply pow_nonzero]; lra].
    transitivity (sin u' * sin u' - cos b' * cos b' * (sin u' * sin u')); [ring|].
    transitivity (cos b' * cos b' * (eps * eps)); [lra | field; lra]. }
  assert (A := after_is eps u u' th Hu Hu2 Hth HE). fold b' U d S F in A. rewrite A.
  assert (M := moved_is). unfold after. rewrite <- E'. change (cos_2 N) with (cos b').
  transitivity (cos b' * cos th * (d - sin d * S / sin u') - Q * (1 - cos b') - d * sin th * sin b'); [unfold Q; ring|].
  rewrite M, K1, B, G. field. lra.
Qed.
Theorem fall_is : invariant u (th - b) - invariant u' (th + b') = eps^3 * fall th Q S K t eps N.
Proof.
  destruct sines_are as [E [E' [L1 L2]]]. destruct (small u u' Hu Hu2 Hs HS) as [s0 [[D0 _] _]]. fold d in s0, D0.
  destruct (beta_parts eps u (proj1 Heps) ltac:(lra)) as [C _]. fold b in C.
  destruct (beta_parts eps u' (proj1 Heps) ltac:(lra)) as [C' _]. fold b' in C'.
  assert (G : d = eps * (t * arc N)) by (unfold N, shares_of, arc; fold b b' d; rewrite <- Rmult_assoc, <- t_is; field; lra).
  assert (H : 2 * d - sin (2 * d) = 4/3 * d^3 * chord N) by (unfold N, shares_of, chord; fold b b' d; field; lra).
  assert (DD : sin (2 * U) * sin (2 * d) = eps * doubles S K t N)
    by (rewrite !sin_2a; fold S K; rewrite t_is; unfold doubles, N, shares_of, cosine; fold b b' d; ring).
  assert (X := L43c_X u u' Hu Hu2). fold U d S in X.
  assert (W := proj1 (sine_products u u')). fold U d S in W. rewrite <- W, H in X.
  assert (Y := L43c_cos eps u u' (proj1 Heps) Hu Hu2). fold b b' U d in Y. rewrite DD in Y.
  assert (Z := L43c_sin eps u u' (proj1 Heps) Hu Hu2). fold b b' U d in Z. rewrite DD in Z.
  assert (A := L43c_fall eps u u' th Hu Hu2 Hth HE). fold b b' U d S F Q in A. rewrite A, X, Y, Z, moved_is.
  unfold fall, less_cos, more_sin. rewrite <- E, <- E'. change (cos_1 N) with (cos b). change (cos_2 N) with (cos b').
  set (m := moved S K t eps N). set (D2 := doubles S K t N). set (g := arc N) in *. set (j := chord N).
  rewrite t_is. rewrite G. set (c := cos b) in *. set (c' := cos b') in *. field.
  assert (0 < sin u * c') by (apply Rmult_lt_0_compat; lra). assert (0 < sin u' * c) by (apply Rmult_lt_0_compat; lra).
  repeat split; lra.
Qed.
End Step.
