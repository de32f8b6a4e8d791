(** The sines of a step of the bulk, where Q is in the window of (C9) and th <= 0.7944.

    decimals         == the window in decimals, for coq-interval
    far, sine_U, cosine_U, tilt == F, sin U, cos U and sin d/eps of the flight with Q at the angle th
    flight_is        == they are so
    bulk_sines       == sin d <= 0.003, sin U >= 0.78
    small            == what follows for d and cos d *)
From Coq Require Import Reals Lra.
From Interval Require Import Tactic.
From Dumbbell Require Import Sines PiValue LawStatement Falls Windows.
Local Open Scope R_scope.

Lemma decimals J : near_half_pi J -> 1.57078 <= J <= 1.57083.
Proof. assert (P := pi_digits). unfold near_half_pi. lra. Qed.

Definition far th Q := Q / cos th.
Definition sine_U th Q := sin (far th Q).
Definition cosine_U th Q := - cos (far th Q).
Definition tilt th Q := tan th * far th Q / sine_U th Q.

Lemma ranges th Q : near_half_pi Q -> 0 <= th <= 0.7944 -> 0.78 <= sine_U th Q /\ 1/1000 * tilt th Q <= 0.003.
Proof.
  intros HQ H. apply decimals in HQ. unfold tilt, sine_U, far.
  split; interval with (i_bisect th, i_taylor th, i_depth 12).
Qed.

Section Step.
Variables eps u u' th : R.
Hypothesis Heps : 0 < eps <= 1/1000.
Hypothesis Hu : 0 < u' < u.
Hypothesis Hu2 : u <= PI/2.
Hypothesis Hth : 0 <= th <= 0.7944.
Hypothesis HE : cos u' - cos u = eps * tan th * (2 * PI - u - u').
Let U := middle u u'.
Let d := half u u'.
Let Q := (PI - U) * cos th.
Hypothesis HQ : near_half_pi Q.

Lemma flight_is : sine_U th Q = sin U /\ cosine_U th Q = cos U /\ sin d = eps * tilt th Q.
Proof.
  assert (P := PI2_1). assert (C : 0 < cos th) by (apply cos_gt_0; lra).
  assert (F : far th Q = PI - U) by (unfold far, Q; field; lra).
  assert (ES : sine_U th Q = sin U) by (unfold sine_U; rewrite F, sin_minus, sin_PI, cos_PI; ring).
  split; [exact ES|]. split; [unfold cosine_U; rewrite F, cos_minus, sin_PI, cos_PI; ring|].
  destruct (ranges th Q HQ Hth) as [R _]. assert (Z := seven eps u u' th HE). fold U d in Z.
  unfold tilt. rewrite F. apply Rmult_eq_reg_r with (sine_U th Q); [|lra]. rewrite ES at 1. rewrite Z. field. lra.
Qed.
Lemma bulk_sines : sin d <= 0.003 /\ 0.78 <= sin U.
Proof.
  destruct flight_is as [<- [_ ->]]. destruct (ranges th Q HQ Hth) as [R1 R2]. split; [|exact R1].
  destruct (Rle_dec (tilt th Q) 0) as [T|T].
  - assert (0 <= eps * - tilt th Q) by (apply Rmult_le_pos; lra). lra.
  - apply Rle_trans with (2 := R2). apply Rmult_le_compat_r; lra.
Qed.
Lemma small : 0 < sin d /\ sin d <= d <= 1.00001 * sin d /\ d <= 0.0031 /\ 0.99999 <= cos d <= 1.
Proof.
  destruct bulk_sines as [Hs _]. destruct (middle_range u u' Hu Hu2) as [_ [Hd _]]. fold d in Hd.
  assert (P := pi_value).
  assert (S0 : 0 < sin d) by (apply sin_gt_0; lra). assert (L : sin d <= d) by (left; apply sin_lt_x; lra).
  assert (B := sine_below d ltac:(lra)). assert (d * d <= 0.8 * 0.8) by (apply Rmult_le_compat; lra).
  assert (d * d * d <= 0.8 * 0.8 * d) by (apply Rmult_le_compat_r; lra). assert (d <= 0.004) by lra.
  assert (D2 : d * d <= 0.004 * 0.004) by (apply Rmult_le_compat; lra).
  assert (d * d * d <= 0.004 * 0.004 * d) by (apply Rmult_le_compat_r; lra).
  assert (C := cosine_below d ltac:(lra)). destruct (COS_bound d). repeat split; lra.
Qed.
End Step.
