(** The integrals of the end (L52 of law.md) as means along the way, t in [0, 1], of jets in d = u/2: what these are at
    d = 0, and their rise and bend, are means, too.

    sinc_jet        == sinc (k d) as a jet
    along           == a formula of sinc (2 d t), of F = pi - 2 d t and of J = pi/2 + q d
    jet_H, jet_H2   == the integrands of tau_J/u^2 and tau_JJ/u^2, without t
    H_base, H2_base == what they are at d = 0
    integrand       == sin (u t)/u f (pi - u t, J); integrand_H, integrand_H2: it is t times such a jet
    tau_J_mean, tau_JJ_mean == tau_J/u^2 and tau_JJ/u^2 are its integrals
    H_rise, H_bend, H2_rise == so are the rise and the bend of the one, the rise of the other *)
From Coq Require Import Reals ZArith Lra.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Signs PiValue Tails LawStatement Clock Midpoint Defect Slopes Terms EndTerms EndAtZero.
Local Open Scope R_scope.

Definition sinc_jet d k := jcurve d 1 (- (k * k / 6 * tail_sin (k * d))).
Lemma sinc_value d k : 0 < d -> at_U (sinc_jet d k) * (k * d) = sin (k * d).
Proof. intros Hd. unfold sinc_jet, jcurve. cbn [at_U]. rewrite sin_tail. field. Qed.
Definition along (f : jet -> jet -> jet) d t := f (sinc_jet d (2 * t)) (jline d PI (- (2 * t))).
Definition jet_H d q := along (fun w F => weight_H jet (jets d) w F (jline d (PI/2) q)) d.
Definition jet_H2 d q := along (fun w F => weight_H2 jet (jets d) w F (jline d (PI/2) q)) d.

Lemma base_root : sqrt (PI * PI - PI / 2 * (PI / 2)) = sqrt 3 / 2 * PI.
Proof.
  assert (P := PI_RGT_0). replace (PI * PI - PI / 2 * (PI / 2)) with (3/4 * (PI * PI)) by field.
  rewrite sqrt_mult_alt, sqrt_square, sqrt34 by lra. ring.
Qed.
Lemma H_base d q t : at_0 (jet_H d q t) = H_at_0 /\ slope_0 (jet_H d q t) = H_at_0 * (2 * q + 6 * t) / PI.
Proof.
  destruct root3 as [T [T0 T1]]. assert (P := PI_RGT_0).
  unfold jet_H, along, weight_H, H_at_0. cbv zeta.
  cbn [jets o_num o_add o_sub o_mul o_div o_sqr o_root jadd jsub jmul jdiv jinv jsqr jsqrt jline sinc_jet jcurve at_0
    slope_0].
  rewrite base_root. replace (PI * PI - PI / 2 * (PI / 2)) with (3/4 * (PI * PI)) by field.
  split; (field_simplify_eq; [ring [T] | repeat split; lra]).
Qed.
Lemma H2_base d q t : at_0 (jet_H2 d q t) = 2 * H_at_0 / PI.
Proof.
  destruct root3 as [T [T0 T1]]. assert (P := PI_RGT_0).
  unfold jet_H2, along, weight_H2, H_at_0. cbv zeta.
  cbn [jets o_num o_add o_sub o_mul o_div o_sqr o_root jadd jsub jmul jdiv jinv jsqr jsqrt jline sinc_jet jcurve
    at_0].
  rewrite base_root. replace (PI * PI - PI / 2 * (PI / 2)) with (3/4 * (PI * PI)) by field.
  field_simplify_eq; [ring [T] | repeat split; lra].
Qed.

Definition integrand (f : R -> R -> R) u J t := sin (u * t) / u * f (PI - u * t) J.
Section Way.
Variables d q : R.
Hypothesis Hd : 0 < d.
Let u := 2 * d.
Let J := PI/2 + d * q.
Hypothesis HJ : 0 < J < PI - u.
Lemma way t : 0 <= t <= 1 -> 0 <= u * t <= u /\ 0 < J < PI - u * t.
Proof. intros Ht. assert (0 <= u * t <= u * 1) by (unfold u in *; split; pos). lra. Qed.
Lemma sine_on_way t : sin (u * t) / u = t * at_U (sinc_jet d (2 * t)).
Proof.
  replace (u * t) with (2 * t * d) by (unfold u; ring). rewrite <- sinc_value by exact Hd. unfold u. field. lra.
Qed.
Lemma integrand_H t : 0 <= t <= 1 -> integrand H u J t = t * at_U (jet_H d q t).
Proof.
  intros Ht. destruct (way t Ht) as [_ K]. destruct (radicand _ _ K) as [R1 R2]. unfold integrand. rewrite
    sine_on_way.
  unfold jet_H, along, weight_H. cbv zeta.
  cbn [jets o_num o_add o_sub o_mul o_div o_sqr o_root jadd jsub jmul jdiv jinv jsqr jsqrt jline at_U].
  fold J. replace (PI + d * - (2 * t)) with (PI - u * t) by (unfold u; ring). unfold H, root.
  set (F := PI - u * t) in *. set (s := sqrt (F * F - J * J)) in *.
  assert (E : F * F - J * J = s * s) by (unfold s; rewrite sqrt_sqrt; lra). rewrite E. field. lra.
Qed.
Lemma integrand_H2 t : 0 <= t <= 1 -> integrand H2 u J t = t * at_U (jet_H2 d q t).
Proof.
  intros Ht. destruct (way t Ht) as [_ K]. destruct (radicand _ _ K) as [R1 R2]. unfold integrand. rewrite
    sine_on_way.
  unfold jet_H2, along, weight_H2. cbv zeta.
  cbn [jets o_num o_add o_sub o_mul o_div o_sqr o_root jadd jsub jmul jdiv jinv jsqr jsqrt jline at_U].
  fold J. replace (PI + d * - (2 * t)) with (PI - u * t) by (unfold u; ring). replace (3 + d * 0) with 3 by ring.
  unfold H2, root. set (F := PI - u * t) in *. set (s := sqrt (F * F - J * J)) in *.
  assert (E : F * F - J * J = s * s) by (unfold s; rewrite sqrt_sqrt; lra). rewrite E. field. lra.
Qed.

Lemma integrand_continuous f t : 0 <= t <= 1 -> (forall F, J < F -> ex_derive (fun F => f F J) F) -> continuous
  (integrand f u J) t.
Proof.
  intros Ht Hf. destruct (way t Ht) as [_ K]. apply (continuous_mult (fun t => sin (u * t) / u) (fun t => f (PI - u *
    t) J)).
  - apply (ex_derive_continuous (fun t => sin (u * t) / u)). auto_derive. unfold u. lra.
  - apply (continuous_comp (fun t => PI - u * t) (fun F => f F J)).
    + apply (ex_derive_continuous (fun t => PI - u * t)). auto_derive. easy.
    + apply (ex_derive_continuous (fun F => f F J)), Hf. lra.
Qed.
Lemma weighed f : (forall F, J < F -> ex_derive (fun F => f F J) F) ->
  is_RInt (integrand f u J) 0 1 (RInt (fun x => sin x * f (PI - x) J) 0 u / (u * u)).
Proof.
  intros Hf. assert (U0 : 0 < u) by (unfold u; lra).
  assert (I : is_RInt (fun x => sin x * f (PI - x) J) 0 u (RInt (fun x => sin x * f (PI - x) J) 0 u))
    by (apply (RInt_correct (V := R_CompleteNormedModule)), weight_integrable; [lra | exact HJ | exact Hf]).
  set (X := RInt (fun x => sin x * f (PI - x) J) 0 u) in *.
  assert (C : is_RInt (fun t => scal u (sin (u * t + 0) * f (PI - (u * t + 0)) J)) 0 1 X).
  { apply (is_RInt_comp_lin (fun x => sin x * f (PI - x) J) u 0 0 1). rewrite Rmult_0_r, Rmult_1_r, !Rplus_0_r. exact
    I. }
  replace (X / (u * u)) with (scal (/ (u * u)) X) by (unfold scal; simpl; unfold mult; simpl; field; lra).
  refine (is_RInt_ext _ _ _ _ _ _ (is_RInt_scal _ _ _ (/ (u * u)) _ C)). intros t _. rewrite Rplus_0_r.
  unfold integrand, scal; simpl; unfold mult; simpl. field. lra.
Qed.
Lemma smooth F : J < F -> ex_derive (fun F => H F J) F /\ ex_derive (fun F => H2 F J) F.
Proof. intros HF. apply H_smooth. lra. Qed.
Theorem tau_J_mean : RInt (integrand H u J) 0 1 = tau_J u J / (u * u).
Proof. apply is_RInt_unique, (weighed H). intros F HF. exact (proj1 (smooth F HF)). Qed.
Theorem tau_JJ_mean : RInt (integrand H2 u J) 0 1 = tau_JJ u J / (u * u).
Proof. apply is_RInt_unique, (weighed H2). intros F HF. exact (proj2 (smooth F HF)). Qed.

(** (g - a t)/d and ((g - a t)/d - (b t + c t^2))/d. *)
Definition raised (g : R -> R) a t := (g t - a * t) / d.
Definition bent (g : R -> R) a b c t := (raised g a t - (b * t + c * (t * t))) / d.
Lemma raised_integral g a X : is_RInt g 0 1 X -> is_RInt (raised g a) 0 1 ((X - a / 2) / d).
Proof.
  intros I. assert (L : is_RInt (fun t => a * t) 0 1 (a / 2)).
  { replace (a / 2) with (minus (a * (1 * 1) / 2) (a * (0 * 0) / 2)) by (unfold minus, plus, opp; simpl; field).
    apply (is_RInt_derive (fun t => a * (t * t) / 2) (fun t => a * t)).
    - intros t _. auto_derive; [easy | field].
    - intros t _. apply (ex_derive_continuous (fun t => a * t)). auto_derive. easy. }
  replace ((X - a / 2) / d) with (scal (/ d) (minus X (a / 2)))
    by (unfold scal, minus, plus, opp; simpl; unfold mult; simpl; field; lra).
  refine (is_RInt_ext _ _ _ _ _ _ (is_RInt_scal _ _ _ (/ d) _ (is_RInt_minus _ _ _ _ _ _ I L))). intros t _.
  unfold raised, scal, minus, plus, opp; simpl; unfold mult; simpl. field. lra.
Qed.
Lemma bent_integral g a b c X : is_RInt g 0 1 X -> is_RInt (bent g a b c) 0 1 (((X - a / 2) / d - (b / 2 + c / 3)) /
  d).
Proof.
  intros I. assert (L : is_RInt (fun t => b * t + c * (t * t)) 0 1 (b / 2 + c / 3)).
  { replace (b / 2 + c / 3) with (minus (b * (1 * 1) / 2 + c * (1 * 1 * 1) / 3) (b * (0 * 0) / 2 + c * (0 * 0 * 0) /
    3))
      by (unfold minus, plus, opp; simpl; field).
    apply (is_RInt_derive (fun t => b * (t * t) / 2 + c * (t * t * t) / 3) (fun t => b * t + c * (t * t))).
    - intros t _. auto_derive; [easy | field].
    - intros t _. apply (ex_derive_continuous (fun t => b * t + c * (t * t))). auto_derive. easy. }
  set (Y := (X - a / 2) / d).
  replace ((Y - (b / 2 + c / 3)) / d) with (scal (/ d) (minus Y (b / 2 + c / 3)))
    by (unfold scal, minus, plus, opp; simpl; unfold mult; simpl; field; lra).
  refine (is_RInt_ext _ _ _ _ _ _ (is_RInt_scal _ _ _ (/ d) _ (is_RInt_minus _ _ _ _ _ _ (raised_integral g a X I)
    L))).
  intros t _. unfold bent, scal, minus, plus, opp; simpl; unfold mult; simpl. field. lra.
Qed.
Lemma continuous_raised g a t : continuous g t -> continuous (raised g a) t.
Proof.
  intros C. apply (continuous_ext (fun t => scal (/ d) (minus (g t) (a * t)))).
  - intros s. unfold raised, scal, minus, plus, opp; simpl; unfold mult; simpl. field. lra.
  - apply (continuous_scal_r (/ d) (fun t => minus (g t) (a * t))), (continuous_minus g (fun t => a * t)); [exact C|].
    apply (ex_derive_continuous (fun t => a * t)). auto_derive. easy.
Qed.
Lemma continuous_bent g a b c t : continuous g t -> continuous (bent g a b c) t.
Proof.
  intros C. apply (continuous_ext (fun t => scal (/ d) (minus (raised g a t) (b * t + c * (t * t))))).
  - intros s. unfold bent, scal, minus, plus, opp; simpl; unfold mult; simpl. field. lra.
  - apply (continuous_scal_r (/ d) (fun t => minus (raised g a t) (b * t + c * (t * t)))).
    apply (continuous_minus (raised g a) (fun t => b * t + c * (t * t))); [now apply continuous_raised|].
    apply (ex_derive_continuous (fun t => b * t + c * (t * t))). auto_derive. easy.
Qed.

Theorem H_rise : RInt (raised (integrand H u J) H_at_0) 0 1 = (tau_J u J / (u * u) - H_at_0 / 2) / d.
Proof. apply is_RInt_unique, raised_integral, (weighed H). intros F HF. exact (proj1 (smooth F HF)). Qed.
Theorem H_bend : RInt (bent (integrand H u J) H_at_0 (H_at_0 * (2 * q) / PI) (H_at_0 * 6 / PI)) 0 1 =
  ((tau_J u J / (u * u) - H_at_0 / 2) / d - H_at_0 * (q + 2) / PI) / d.
Proof.
  assert (P := PI_RGT_0). replace (H_at_0 * (q + 2) / PI) with (H_at_0 * (2 * q) / PI / 2 + H_at_0 * 6 / PI / 3) by
    (field; lra).
  apply is_RInt_unique, bent_integral, (weighed H). intros F HF. exact (proj1 (smooth F HF)).
Qed.
Theorem H2_rise : RInt (raised (integrand H2 u J) (2 * H_at_0 / PI)) 0 1 = (tau_JJ u J / (u * u) - H_at_0 / PI) / d.
Proof.
  assert (P := PI_RGT_0). replace (H_at_0 / PI) with (2 * H_at_0 / PI / 2) by (field; lra).
  apply is_RInt_unique, raised_integral, (weighed H2). intros F HF. exact (proj2 (smooth F HF)).
Qed.
End Way.
