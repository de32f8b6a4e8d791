(** The exact map (L31 (a), L43 (a) and (b) of law.md): with eps = sqrt r and the slope eps tan th of a flight, the
    angle th grows by 2 beta at each contact. A state of a ray is a sequence of contacts; a flight that is tangent to
    the hump ends it.

    sin_of_atan, beta_pos == sin (atan x) = x cos (atan x); 0 < beta < pi/2
    turned                == a contact turns the flight by 2 beta
    sequence              == each of the first n contacts is a step from the next one
    last_slope, last_height == of the flight that leaves contact n: its slope, its height over the peak
    contacts_of_state     == the contacts of a ray that has them
    last_of_tangent       == a tangent flight
    L43b                  == sin d sin U = eps tan th (pi - U) *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Trigonometry Ray Tangency LawStatement Sines.
Local Open Scope R_scope.

Lemma sin_of_atan x : sin (atan x) = x * cos (atan x).
Proof.
  assert (C : 0 < cos (atan x)) by (destruct (atan_bound x); apply cos_gt_0; lra).
  assert (E := tan_atan x). unfold tan in E. rewrite <- E at 2. field. lra.
Qed.
Lemma double_angle t : cos (2 * atan t) = (1 - t * t) / (1 + t * t) /\ sin (2 * atan t) = 2 * t / (1 + t * t).
Proof.
  assert (P : 0 < 1 + t * t) by (assert (0 <= t * t) by apply Rle_0_sqr; lra). assert (S := sin_of_atan t).
  assert (Q : cos (atan t) * cos (atan t) = / (1 + t * t)).
  { assert (K := sin2_cos2 (atan t)). unfold Rsqr in K. rewrite S in K.
    apply Rmult_eq_reg_r with (1 + t * t); [|lra]. rewrite Rinv_l by lra. apply eq_trans with (2 := K). ring. }
  rewrite cos_2a, sin_2a, S. split.
  - replace (cos (atan t) * cos (atan t) - t * cos (atan t) * (t * cos (atan t))) with
      (cos (atan t) * cos (atan t) * (1 - t * t)) by ring. rewrite Q. field. lra.
  - replace (2 * (t * cos (atan t)) * cos (atan t)) with (2 * t * (cos (atan t) * cos (atan t))) by ring.
    rewrite Q. field. lra.
Qed.
Lemma beta_pos eps u : 0 < eps -> 0 < sin u -> 0 < beta eps u < PI/2.
Proof.
  intros He Hs. unfold beta. destruct (atan_bound (eps / sin u)). split; [|lra]. rewrite <- atan_0.
  apply atan_increasing. now apply Rdiv_lt_0_compat.
Qed.

(** L31 (a): a contact at the height sin x, where the hump has the slope w = cos x. *)
Lemma turned eps w th : 0 < eps -> 0 < w -> 0 <= th < PI/2 -> 0 < slope_den w (eps * tan th) (eps * eps) ->
  let th' := th + 2 * atan (eps / w) in
  th' < PI/2 /\ next_slope w (eps * tan th) (eps * eps) = eps * tan th'.
Proof.
  intros He Hw Hth HD th'. assert (C : 0 < cos th) by (apply cos_gt_0; lra).
  assert (H2 : 0 <= eps * eps) by apply Rle_0_sqr. assert (W2 : 0 < w * w) by now apply Rmult_lt_0_compat.
  assert (S : sin th = tan th * cos th) by (unfold tan; field; lra). destruct (double_angle (eps / w)) as [E1 E2].
  assert (D : 1 + eps / w * (eps / w) = (w * w + eps * eps) / (w * w)) by (field; lra).
  assert (B : 0 < atan (eps / w) < PI/2).
  { destruct (atan_bound (eps / w)). split; [|lra]. rewrite <- atan_0. apply atan_increasing.
    now apply Rdiv_lt_0_compat. }
  assert (P : 0 < w * w + eps * eps) by lra. set (k := eps * tan th) in *.
  assert (Ec : cos th' = cos th * slope_den w k (eps * eps) / (w * w + eps * eps))
    by (unfold th'; rewrite cos_plus, E1, E2, D, S; unfold slope_den, k; field; lra).
  assert (Es : sin th' * eps = cos th * slope_num w k (eps * eps) / (w * w + eps * eps))
    by (unfold th'; rewrite sin_plus, E1, E2, D, S; unfold slope_num, k; field; lra).
  assert (C' : 0 < cos th') by (rewrite Ec; apply Rdiv_lt_0_compat; [now apply Rmult_lt_0_compat | lra]).
  assert (L : th' < PI/2).
  { apply Rnot_le_lt. intros K. assert (cos th' <= 0); [|lra]. apply cos_le_0; [exact K | unfold th'; lra]. }
  split; [exact L|]. unfold next_slope, tan.
  replace (eps * (sin th' / cos th')) with (sin th' * eps / cos th') by (field; lra).
  rewrite Es, Ec. field. repeat split; lra.
Qed.

(** The contacts of the ray that leaves the contact at x with the angle th. *)
Definition sequence eps (u al : nat -> R) n := forall i, (i < n)%nat -> step eps (u i) (al i) (u (S i)) (al (S i)).
Definition last_slope eps (u al : nat -> R) n := eps * tan (al n + beta eps (u n)).
Definition last_height eps (u al : nat -> R) n := cos (u n) + last_slope eps u al n * (3 * (PI/2) - u n).

Lemma contacts_of_state eps n a b : 0 < eps <= 1 -> forall x th, 0 <= x < PI/2 -> th < PI/2 ->
  beta eps (PI/2 - x) <= th ->
  state (eps * eps) n (sin x + eps * tan th * (x + PI)) (eps * tan th) a b ->
  exists u al, u O = PI/2 - x /\ al O = th - beta eps (u O) /\ sequence eps u al n /\ 0 < u n <= PI/2 /\
    0 <= al n /\ al n + beta eps (u n) < PI/2 /\ a = last_height eps u al n /\ b = last_slope eps u al n.
Proof.
  intros He. unfold last_height, last_slope. induction n as [|n IH]; intros x th Hx Hth Hb H.
  - destruct H as [-> ->]. exists (fun _ => PI/2 - x), (fun _ => th - beta eps (PI/2 - x)).
    replace (th - beta eps (PI/2 - x) + beta eps (PI/2 - x)) with th by ring. rewrite Rtrigo1.cos_shift.
    split; [reflexivity|]. split; [reflexivity|]. split; [intros i Hi; lia|]. repeat split; try lra.
  - destruct H as [x' [Hx' [HD H]]]. assert (HPI := PI2_1). assert (W := cos_pos x' (proj1 Hx')).
    assert (W0 := cos_pos x Hx).
    assert (B0 : 0 < beta eps (PI/2 - x)) by (apply beta_pos; [lra | rewrite Rtrigo1.sin_shift; exact W0]).
    destruct (turned eps (cos x') th ltac:(lra) W ltac:(lra) HD) as [T1 T2].
    replace (atan (eps / cos x')) with (beta eps (PI/2 - x')) in T1, T2
      by (unfold beta; now rewrite Rtrigo1.sin_shift).
    assert (B1 : 0 < beta eps (PI/2 - x')) by (apply beta_pos; [lra | rewrite Rtrigo1.sin_shift; exact W]).
    set (th' := th + 2 * beta eps (PI/2 - x')) in *. rewrite T2 in H.
    destruct (IH x' th' (proj1 Hx') T1 ltac:(unfold th'; lra) H) as [u [al [U0 [A0 [HS [HU [HA [HB E]]]]]]]].
    exists (fun i => match i with O => PI/2 - x | S j => u j end),
      (fun i => match i with O => th - beta eps (PI/2 - x) | S j => al j end).
    split; [reflexivity|]. split; [reflexivity|]. split; [|repeat split; try lra; apply E].
    intros [|i] Hi; [|apply HS; lia]. rewrite U0, A0, U0. destruct Hx' as [X1 [X2 X3]].
    assert (K : 0 < tan th) by (apply tan_gt_0; lra).
    assert (P : 0 < eps * tan th) by (apply Rmult_lt_0_compat; lra).
    assert (L : x < x').
    { apply Rnot_le_lt. intros L. assert (sin x' <= sin x) by (apply sin_incr_1; lra).
      assert (0 < eps * tan th * (x + PI + x')) by (apply Rmult_lt_0_compat; lra). lra. }
    constructor.
    + exact He.
    + lra.
    + unfold th' in *. lra.
    + unfold th'. lra.
    + replace (th - beta eps (PI / 2 - x) + beta eps (PI / 2 - x)) with th by ring. rewrite !Rtrigo1.cos_shift.
      rewrite X2. field.
Qed.

Lemma last_of_tangent eps u al n : 0 < eps <= 1 -> 0 < u n <= PI/2 -> 0 <= al n -> al n + beta eps (u n) < PI/2 ->
  tangent (last_height eps u al n) (last_slope eps u al n) -> exists y, last eps (u n) (al n) y.
Proof.
  unfold last_height, last_slope. intros He Hu Ha Hb [[x [Hx E]] HT]. set (th := al n + beta eps (u n)) in *.
  assert (HPI := PI2_1). assert (Su : 0 < sin (u n)) by (apply sin_gt_0; lra).
  assert (B := beta_pos eps (u n) ltac:(lra) Su).
  assert (T0 : 0 < th) by (unfold th; lra). assert (K : 0 < tan th) by (apply tan_gt_0; lra).
  assert (P : 0 < eps * tan th) by (apply Rmult_lt_0_compat; lra).
  set (k := eps * tan th) in *. set (c := cos (u n) + k * (3 * (PI/2) - u n)) in *.
  assert (C : 0 < c). { assert (0 <= cos (u n)) by (apply cos_ge_0; lra).
    assert (0 < k * (3 * (PI/2) - u n)) by (apply Rmult_lt_0_compat; lra). unfold c. lra. }
  assert (X0 : 0 < x). { destruct (Rle_lt_or_eq_dec 0 x) as [|Z]; [lra | assumption|]. rewrite <- Z, sin_0 in E. lra.
  }
  assert (X1 : x < PI/2).
  { destruct (Rle_lt_or_eq_dec x (PI/2)) as [|Z]; [lra | assumption|]. exfalso. subst x. rewrite sin_PI2 in E.
    set (h := Rmin k 1). assert (h <= k) by apply Rmin_l. assert (h <= 1) by apply Rmin_r.
    assert (Ph : 0 < h) by (apply Rmin_glb_lt; lra). specialize (HT (PI/2 - h) ltac:(lra)).
    rewrite Rtrigo1.sin_shift in HT.
    assert (h * h <= k * h) by (apply Rmult_le_compat_r; lra).
    assert (Q := cosine_below h ltac:(lra)).
    assert (0 < h * h) by (now apply Rmult_lt_0_compat). lra. }
  assert (S : cos x = k).
  { assert (pr : derivable_pt (fun t => sin t - k * t) x) by reg.
    assert (Z : derive_pt (fun t => sin t - k * t) x pr = 0).
    { apply (deriv_maximum _ 0 (PI/2)); try assumption. intros t Y0 Y1. specialize (HT t ltac:(lra)). lra. }
    assert (D : derivable_pt_lim (fun t => sin t - k * t) x (cos x - k))
      by (apply is_derive_Reals; auto_derive; [easy | ring]).
    rewrite (derive_pt_eq_0 _ _ _ pr D) in Z. lra. }
  exists (PI/2 - x). assert (F : cos (PI/2 - x) - cos (u n) = sin (PI/2 - x) * (2 * PI - u n - (PI/2 - x))).
  { rewrite Rtrigo1.cos_shift, Rtrigo1.sin_shift, S, E. unfold c. field. }
  constructor; [exact He | | now split | rewrite Rtrigo1.sin_shift; symmetry; exact S | exact F].
  split; [|lra]. split; [lra|]. apply Rnot_le_lt. intros L.
  assert (cos (PI/2 - x) <= cos (u n)) by (apply cos_decr_1; lra).
  assert (0 < sin (PI/2 - x) * (2 * PI - u n - (PI/2 - x)))
    by (apply Rmult_lt_0_compat; [rewrite Rtrigo1.sin_shift |]; lra). lra.
Qed.

(** L43 (b). *)
Lemma L43b eps u u' t : cos u' - cos u = eps * t * (2 * PI - u - u') ->
  sin (half u u') * sin (middle u u') = eps * t * (PI - middle u u').
Proof.
  unfold half, middle. intros H. set (U := (u + u') / 2) in *. set (d := (u - u') / 2) in *.
  replace u with (U + d) in H by (unfold U, d; field). replace u' with (U - d) in H by (unfold U, d; field).
  rewrite cos_minus, cos_plus in H. lra.
Qed.
