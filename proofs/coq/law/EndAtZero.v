(** L58 of law.md, and what L52 says of d = 0: the value and the slope of (T - 1)/sqrt eps at d = 0, by the rules of
    derivatives from the formulas of EndTerms.v.

    H_at_0          == H(pi, pi/2)
    contact_0, moments_0 == what the formulas are made of, at d = 0, where Q = pi/2 + q d
    by_root         == proves an equation of numbers made with T = sqrt 3
    L58             == the value is k0, the slope - 3^(1/4) (16 q + 7)/(36 pi^(3/2)) *)
From Coq Require Import Reals ZArith Lra.
From Dumbbell Require Import Terms EndTerms.
Local Open Scope R_scope.

Definition H_at_0 := 8 / (3 * sqrt 3 * (PI * PI)).
Definition contact_0 q : contact dual := {| tF := Dual PI (-1); tQ := Dual (PI/2) q; td := Dual 0 1;
  twave := Dual 1 0; tdouble := Dual 1 0; tcos := Dual 1 0; tlift := Dual 0 0 |}.
(** g2 is multiplied by d: its slope does not matter. *)
Definition moments_0 q s : moments dual := {| tabove := Dual 1 0; tI2 := Dual (1/3) 0; tI4 := Dual 0 0;
  tJ1 := Dual (1/3) 0; tJ3 := Dual 0 0; tg1 := Dual (H_at_0 / 2) (H_at_0 * (q + 2) / PI); tg2 := Dual (H_at_0 / PI) s
    |}.

Section AtZero.
Variables q s : R.
Let P := PI_RGT_0.
Let f := flight_of dual duals (contact_0 q).
Let A := offset_of dual duals (contact_0 q) f.
Let G := bends_of dual duals (Dual PI (-1)) (Dual (PI/2) q).

Lemma root3 : sqrt 3 * sqrt 3 = 3 /\ 0 < sqrt 3 /\ 0 < sqrt 3 * PI.
Proof.
  assert (0 < sqrt 3) by (apply sqrt_lt_R0; lra). repeat split; [apply sqrt_sqrt; lra | assumption |].
  apply Rmult_lt_0_compat; [assumption | exact P].
Qed.
Ltac by_root T := first [field; lra | field_simplify_eq; [ring [T] | repeat split; lra]].
Lemma sqrt34 : sqrt (3/4) = sqrt 3 / 2.
Proof. rewrite sqrt_div_alt by lra. replace 4 with (2 * 2) by ring. now rewrite sqrt_square by lra. Qed.

Lemma cosine_0 : tcosine dual f = Dual (1/2) ((1/2 + q) / PI).
Proof. apply dual_is; simpl; field; lra. Qed.
Lemma sine_0 : tsine dual f = Dual (sqrt 3 / 2) (- (1/2 + q) / (PI * sqrt 3)).
Proof.
  destruct root3 as [T [T0 T1]].
  change (tsine dual f) with (dsqrt (dsub (Dual 1 0) (dsqr (tcosine dual f)))). rewrite cosine_0.
  apply dual_is; simpl; replace (1 - 1/2 * (1/2)) with (3/4) by field; rewrite sqrt34; [reflexivity | field; lra].
Qed.
Lemma kh_0 : tkh dual f = Dual (/ PI) (/ (PI * PI)).
Proof. apply dual_is; simpl; field; lra. Qed.
Lemma epsh_0 : tepsh dual f = Dual (/ (sqrt 3 * PI)) ((7 + 8 * q) / (3 * sqrt 3 * PI^2)).
Proof.
  destruct root3 as [T [T0 T1]]. change (tepsh dual f) with (ddiv (dmul (tkh dual f) (tcosine dual f)) (tsine dual
    f)).
  rewrite kh_0, cosine_0, sine_0. apply dual_is; simpl; by_root T.
Qed.
Lemma c_0 b : ddiv (Dual 1 0) (dsqrt (dadd (Dual 1 0) (dsqr (dmul (Dual 0 1) b)))) = Dual 1 0.
Proof.
  destruct b as [x y]. unfold ddiv, dinv, dsqrt; cbn -[sqrt]. replace (1 + 0 * x * (0 * x)) with 1 by ring.
  rewrite sqrt_1. apply dual_is; cbn; field.
Qed.
Lemma A_0 : A = Dual (- / 4) (- (24 * q + 25) / (48 * PI)).
Proof.
  destruct root3 as [T [T0 T1]]. unfold A, offset_of. cbn [duals o_num o_add o_sub o_mul o_div o_sqr o_root contact_0
    td tdouble].
  rewrite c_0, cosine_0, sine_0, epsh_0. apply dual_is; simpl; by_root T.
Qed.

Let R0 := dsub (dsqr (Dual PI (-1))) (dsqr (Dual (PI/2) q)).
Let r1 := ddiv (Dual 1 0) (dsqrt R0).
Lemma R_0 : R0 = Dual (3 * PI^2 / 4) (- PI * (2 + q)).
Proof. apply dual_is; simpl; field. Qed.
Lemma r1_0 : r1 = Dual (2 / (sqrt 3 * PI)) (4 * (2 + q) / (3 * sqrt 3 * PI^2)).
Proof.
  destruct root3 as [T [T0 T1]]. unfold r1. rewrite R_0. assert (E : sqrt (3 * PI^2 / 4) = sqrt 3 / 2 * PI).
  { replace (3 * PI^2 / 4) with (3/4 * (PI * PI)) by field. rewrite sqrt_mult_alt, sqrt_square, sqrt34 by lra. ring. }
  apply dual_is; unfold ddiv, dinv, dsqrt; cbn -[sqrt pow]; rewrite E; by_root T.
Qed.
Lemma r3_0 : ddiv r1 R0 = Dual (8 / (3 * sqrt 3 * PI^3)) (16 * (2 + q) / (3 * sqrt 3 * PI^4)).
Proof. destruct root3 as [T [T0 T1]]. rewrite r1_0, R_0. apply dual_is; simpl; by_root T. Qed.
Lemma r5_0 : ddiv (ddiv r1 R0) R0 = Dual (32 / (9 * sqrt 3 * PI^5)) (320 * (2 + q) / (27 * sqrt 3 * PI^6)).
Proof. destruct root3 as [T [T0 T1]]. rewrite r3_0, R_0. apply dual_is; simpl; by_root T. Qed.

(** m_1 of L49, of which d sinc d G2/3 - 2 G1/3 is left. *)
Let m1_0 := dsub (dmul (dmul (Dual 0 1) (Dual 1 0)) (dadd (dmul (snd G) (Dual (1/3) 0)) (Dual 0 0)))
  (dmul (dmul (Dual 2 0) (Dual 1 0)) (dadd (dmul (fst G) (Dual (1/3) 0)) (Dual 0 0))).
Lemma m1_is : m1_0 = Dual (14 / (9 * sqrt 3 * PI^2)) ((26 + 16 * q) / (3 * sqrt 3 * PI^3)).
Proof.
  destruct root3 as [T [T0 T1]]. unfold m1_0, G, bends_of. cbn [fst snd duals o_num o_add o_sub o_mul o_div o_sqr
    o_root].
  fold R0. fold r1. rewrite r5_0, r3_0, r1_0. apply dual_is; simpl; by_root T.
Qed.
Let me_0 := dadd (dadd m1_0 (dmul (dmul (Dual 4 0) (Dual (H_at_0 / 2) (H_at_0 * (q + 2) / PI))) A))
  (dmul (dmul (Dual 2 0) (dmul (Dual 0 1) (Dual (H_at_0 / PI) s))) (dsqr A)).
Lemma me_is : me_0 = Dual (2 / (9 * sqrt 3 * PI^2)) (8 / (9 * sqrt 3 * PI^3)).
Proof.
  destruct root3 as [T [T0 T1]]. unfold me_0. rewrite m1_is, A_0. unfold H_at_0. apply dual_is; simpl; by_root T.
Qed.
Theorem L58 : share_of dual duals (contact_0 q) f A G (moments_0 q s) =
  Dual (sqrt (sqrt 3) / (9 * sqrt PI)) (- (sqrt (sqrt 3) * (16 * q + 7) / (36 * (PI * sqrt PI)))).
Proof.
  destruct root3 as [T [T0 T1]]. assert (S := sqrt_sqrt PI (Rlt_le _ _ P)). assert (S0 := sqrt_lt_R0 PI P).
  assert (f4 := sqrt_sqrt (sqrt 3) (Rlt_le _ _ T0)). assert (f0 := sqrt_lt_R0 _ T0).
  assert (E : sqrt (/ (sqrt 3 * PI)) = / (sqrt (sqrt 3) * sqrt PI)) by (rewrite sqrt_inv, sqrt_mult_alt by lra;
    reflexivity).
  assert (gh : 0 < sqrt (sqrt 3) * sqrt PI) by (now apply Rmult_lt_0_compat).
  assert (Er : dsqrt (tepsh dual f) =
    Dual (/ (sqrt (sqrt 3) * sqrt PI)) ((7 + 8 * q) / (3 * sqrt 3 * PI^2) * (sqrt (sqrt 3) * sqrt PI) / 2)).
  { rewrite epsh_0. apply dual_is; unfold dsqrt; cbn -[sqrt pow]; rewrite E; [reflexivity | field; lra]. }
  unfold share_of. cbn [duals o_num o_add o_sub o_mul o_div o_sqr o_root contact_0
    moments_0 td twave tcos tF tabove tI2 tI4 tJ1 tJ3 tg1 tg2].
  fold m1_0. fold me_0. rewrite Er, me_is, epsh_0, kh_0.
  set (g := sqrt (sqrt 3)) in *. set (h := sqrt PI) in *. rewrite <- S, <- f4. rewrite <- f4 in T.
  apply dual_is; cbn -[pow]; rewrite <- ?S; (field_simplify_eq; [ring | lra]).
Qed.
End AtZero.
