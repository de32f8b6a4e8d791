(** The clock's integrand W (L45 of law.md) over a step of the bulk (L51): its derivatives by the angle, and its
    integral about the flight's angle.

    slope1, slope2, slope3 == the derivatives of W by the angle
    W_between  == W is integrable
    bend       == a bound of slope3 near the angle th
    W_about    == the integral of W over a step, from W, slope1, slope2 at its angle *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Dumbbell Require Import PiValue Taylor LawStatement Start Windows BulkSines.
Local Open Scope R_scope.

Definition slope1 J a := let y := J / cos a in cos y * y * tan a.
Definition slope2 J a := let y := J / cos a in cos y * y * (2 * (tan a)^2 + 1) - sin y * (y * tan a)^2.
Definition slope3 J a := let y := J / cos a in
  cos y * y * tan a * (5 + 6 * (tan a)^2 - (y * tan a)^2) - 3 * sin y * y^2 * tan a * (1 + 2 * (tan a)^2).

Lemma cosine_positive a : -1 < a < 1.1 -> 0 < cos a.
Proof. intros Ha. assert (P := PI2_1). assert (Q := pi_value). apply cos_gt_0; lra. Qed.
(** y = J/cos a and T = tan a have the derivatives y T and 1 + T^2. *)
Lemma slopes_by (y T : R -> R) a : is_derive y a (y a * T a) -> is_derive T a (1 + T a ^ 2) ->
  is_derive (fun a => sin (y a)) a (cos (y a) * y a * T a) /\
  is_derive (fun a => cos (y a) * y a * T a) a (cos (y a) * y a * (2 * T a ^ 2 + 1) - sin (y a) * (y a * T a)^2) /\
  is_derive (fun a => cos (y a) * y a * (2 * T a ^ 2 + 1) - sin (y a) * (y a * T a)^2) a
    (cos (y a) * y a * T a * (5 + 6 * T a ^ 2 - (y a * T a)^2) - 3 * sin (y a) * y a ^ 2 * T a * (1 + 2 * T a ^ 2)).
Proof.
  intros Hy HT. assert (Ey : ex_derive y a) by (eexists; exact Hy).
  assert (ET : ex_derive T a) by (eexists; exact HT).
  assert (Dy := is_derive_unique _ _ _ Hy). assert (DT := is_derive_unique _ _ _ HT).
  split; [|split]; auto_derive; try (repeat split; assumption);
    change (fun x => y x) with y; change (fun x => T x) with T; rewrite ?Dy, ?DT; ring.
Qed.
Lemma slopes J a : -1 < a < 1.1 ->
  is_derive (W J) a (slope1 J a) /\ is_derive (slope1 J) a (slope2 J a) /\ is_derive (slope2 J) a (slope3 J a).
Proof.
  intros Ha. assert (C := cosine_positive a Ha). apply (slopes_by (fun a => J / cos a) tan).
  - auto_derive; [lra|]. unfold tan. field. lra.
  - unfold tan. auto_derive; [lra|]. field. lra.
Qed.
Lemma W_between J x z : -1 < x < 1.1 -> -1 < z < 1.1 -> ex_RInt (W J) x z.
Proof. exact (integrable_between (W J) (slope1 J) (slope2 J) (slope3 J) (-1) 1.1 (slopes J) x z). Qed.

(** The third derivative near the angle of a flight of the bulk. *)
Definition bend t := 18 + 250 * t^8.
Lemma bend_bounds J th z : near_half_pi J -> 0 <= th <= 0.7944 -> -0.0014 <= z <= 0.0014 ->
  - bend th <= slope3 J (th + z) <= bend th.
Proof.
  intros HJ Ht Hz. assert (D := decimals J HJ). clear HJ.
  assert (P : 0 < bend th) by (unfold bend; assert (0 <= th^8) by (apply pow_le; lra); lra).
  assert (B : -1 <= slope3 J (th + z) / bend th <= 1).
  { unfold slope3, bend. cbv zeta. split; interval with (i_bisect th, i_autodiff th). }
  assert (E : slope3 J (th + z) = slope3 J (th + z) / bend th * bend th) by (field; lra). rewrite E. clear E.
  assert (-1 * bend th <= slope3 J (th + z) / bend th * bend th <= 1 * bend th); [|lra].
  split; apply Rmult_le_compat_r; lra.
Qed.

Theorem W_about J th b b' : near_half_pi J -> 0 <= th <= 0.7944 -> 0 <= b <= 0.0014 -> 0 <= b' <= 0.0014 ->
  exists z, -1 <= z <= 1 /\ RInt (W J) (th - b) (th + b') = W J th * (b + b') + slope1 J th * ((b'^2 - b^2) / 2) +
    slope2 J th * ((b^3 + b'^3) / 6) + z * (bend th * ((b^4 + b'^4) / 24)).
Proof.
  intros HJ Ht Hb Hb'. apply (integral_about (W J) (slope1 J) (slope2 J) (slope3 J) (-1) 1.1 (slopes J) th);
    [lra | lra | lra |].
  intros y Hy. replace y with (th + (y - th)) by ring. apply bend_bounds; [exact HJ | exact Ht | lra].
Qed.
