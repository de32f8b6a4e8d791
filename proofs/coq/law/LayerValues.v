(** What the rule of LayerRule.v computes of a step is what Sizes.v says of it.

    sinc_jet, cos_jet     == the jets of sinc (k U) and cos (k U)
    take                  == [take x] names the next thing of a formula
    step_values           == eps^, (1 - rho^2) a, a_A,
      a_p and (a_p + (1 + rho) a/2)/U are values at U of the rule's jets *)
From Coq Require Import Reals Lra.
From Dumbbell Require Import Tails LawStatement Angles Falls Sizes Slopes Calculus LayerRule.
Local Open Scope R_scope.

Lemma sinc_jet U k : 0 < k * U -> s_sinc (exact U) k = {| at_U := sinc (k * U); at_0 := 1; slope_0 := 0 |}.
Proof.
  intros Hk. unfold s_sinc. cbn. unfold jcurve. f_equal. unfold sinc. rewrite (sin_tail (k * U)). field.
  split; intros E; rewrite E in Hk; lra.
Qed.
Lemma cos_jet U k : s_cos (exact U) k = {| at_U := cos (k * U); at_0 := 1; slope_0 := 0 |}.
Proof. unfold s_cos. cbn. unfold jcurve. f_equal. rewrite (cos_tail (k * U)). field. Qed.
Lemma flat_root x : at_0 x = 0 -> let y := jinv (jsqrt (jshift (jsqr x) 1)) in at_0 y = 1 /\ slope_0 y = 0.
Proof.
  intros E. cbn. rewrite E. replace (0 * 0 + 1) with 1 by ring. rewrite sqrt_1. split; field.
Qed.

Ltac take y := match goal with |- ?P (let x := ?a in @?f x) => pose (y := a); change (P (f y)); cbv beta end.

Section Values.
Variables eps u u' th : R.
Hypothesis Heps : 0 < eps.
Hypothesis Hu : 0 < u' < u.
Hypothesis Hu2 : u <= PI/2.
Hypothesis Hth : 0 < th < PI/2.
Hypothesis HE : cos u' - cos u = eps * tan th * (2 * PI - u - u').
Let U := middle u u'.
Let d := half u u'.
Let rho := d / U.
Let Q := (PI - U) * cos th.
Variable Qj : jet.
Hypothesis HQ : at_U Qj = Q.
Let C := exact U.

Definition values_are (s : sizes C) :=
  at_U (z_sin_U C s) = sin U /\ at_U (z_cos_U C s) = cos U /\ z_F C s = jline U PI (-1) /\ z_Q C s = Qj /\
  at_U (z_ehat C s) = eps / (d * U) /\ at_U (z_change C s) = size eps u u' th * (1 - rho * rho) /\
  at_U (z_first C s) = size_before eps u u' th /\ at_U (z_last C s) = size_after eps u u' th /\
  U * at_U (z_apart C s) = size_after eps u u' th + size eps u u' th * (1 + rho) / 2.

Lemma tau_value x : x <> 0 -> tail_cos x / 2 - tail_sin x / 6 = (sin x - x * cos x) / x^3.
Proof. intros Hx. rewrite (sin_tail x) at 1. rewrite (cos_tail x) at 1. field. exact Hx. Qed.
Lemma cosine_of_beta v : 0 < sin v -> cos (beta eps v) = / sqrt (eps / sin v * (eps / sin v) + 1).
Proof. intros Hv. unfold beta. rewrite cos_atan. unfold Rsqr. rewrite (Rplus_comm 1). unfold Rdiv. ring. Qed.

Theorem step_values : values_are (sizes_of C rho Qj).
Proof.
  destruct (sines u u' Hu Hu2) as [S1 S2]. destruct (middle_range u u' Hu Hu2) as [HU [Hd [Eu Eu']]].
  fold U in HU, Eu, Eu'. fold d in Hd, Eu, Eu'. assert (P := PI2_1).
  assert (Ds : 0 < sin d) by (apply sin_gt_0; lra). assert (Us : 0 < sin U) by (apply sin_gt_0; lra).
  assert (ud : 0 < U - d) by lra. assert (Ct : 0 < cos th) by (apply cos_gt_0; lra).
  assert (St : 0 < sin th) by (apply sin_gt_0; lra).
  assert (sdU : sin d < sin U) by (apply sin_increasing_1; lra).
  assert (W : 0 < sin U * sin U - sin d * sin d) by (assert (sin d * sin d < sin U * sin U)
    by (apply Rmult_le_0_lt_compat; lra); lra).
  assert (W2 : 0 < U * U - d * d) by (assert (d * d < U * U) by (apply Rmult_le_0_lt_compat; lra); lra).
  assert (rU : rho * U = d) by (unfold rho; field; lra). assert (pU : (1 + rho) * U = u) by lra.
  assert (mU : (1 - rho) * U = u') by lra. assert (r0 : 0 < rho) by (apply Rdiv_lt_0_compat; lra).
  assert (r1 : 0 < 1 - rho) by (apply Rmult_lt_reg_r with U; lra).
  assert (Hp : 0 < (1 + rho) * (1 - rho)) by (apply Rmult_lt_0_compat; lra).
  cbv beta delta [sizes_of plus minus product].
  change (n_mul C rho (n_U C)) with (rho * U). change (n_add C (n_Z C 1) rho) with (1 + rho).
  change (n_sub C (n_Z C 1) rho) with (1 - rho). change (n_sub C (n_Z C 1) (n_sqr C rho)) with (1 - rho * rho).
  take z. assert (Zu : at_U z = U) by (cbn; ring). assert (Zu0 : at_0 z = 0) by reflexivity. clearbody z.
  take dj. assert (Dj : at_U dj = d) by (cbn; lra). assert (Dj0 : at_0 dj = 0) by reflexivity. clearbody dj.
  take wd. assert (Wd := sinc_jet U rho ltac:(lra)). fold C wd in Wd. rewrite rU in Wd. clearbody wd.
  take wU. assert (WU := sinc_jet U 1 ltac:(lra)). rewrite Rmult_1_l in WU. change (wU = {| at_U := sinc U; at_0 := 1;
    slope_0 := 0 |}) in WU. clearbody wU.
  take wu. assert (Wu := sinc_jet U (1 + rho) ltac:(lra)). rewrite pU in Wu. change (wu = {| at_U := sinc u;
    at_0 := 1; slope_0 := 0 |}) in Wu. clearbody wu.
  take wu'. assert (Wu' := sinc_jet U (1 - rho) ltac:(lra)). rewrite mU in Wu'. change (wu' = {| at_U := sinc u';
    at_0 := 1; slope_0 := 0 |}) in Wu'. clearbody wu'.
  take cU. assert (CU := cos_jet U 1). rewrite Rmult_1_l in CU. change (cU = {| at_U := cos U; at_0 := 1;
    slope_0 := 0 |}) in CU. clearbody cU.
  take sU. assert (SU : at_U sU = sin U) by (cbn; rewrite Zu, WU; cbn; unfold sinc; field; lra). clearbody sU.
  take F. assert (EF : F = jline U PI (-1)) by reflexivity. clearbody F.
  take cosine. assert (Cos : at_U cosine = cos th) by (cbn; rewrite HQ, EF; cbn; unfold Q; field; lra).
  clearbody cosine.
  take sine. assert (Sin : at_U sine = sin th).
  { cbn. rewrite Cos. rewrite <- (sqrt_square (sin th)) by lra. f_equal. assert (K := sin2_cos2 th). unfold Rsqr in K.
    lra. }
  clearbody sine.
  take ehat. assert (Eh : at_U ehat = eps / (d * U)).
  { cbn. rewrite Wd, WU, Cos, Sin, EF. cbn. assert (K := seven eps u u' th HE). fold U d in K. unfold tan in K.
    unfold sinc.
    assert (E : eps = sin d * sin U * cos th / (sin th * (PI - U))) by (rewrite K; field; repeat split; lra).
    rewrite E. field. repeat split; lra. }
  clearbody ehat.
  take b. assert (Eb : d * at_U b = eps / sin u).
  { cbn. rewrite Eh, Wu. cbn. unfold sinc. rewrite <- pU at 2. field. repeat split; lra. }
  clearbody b.
  take b'. assert (Eb' : d * at_U b' = eps / sin u').
  { cbn. rewrite Eh, Wu'. cbn. unfold sinc. rewrite <- mU at 2. field. repeat split; lra. }
  clearbody b'.
  take c. assert (Ec : at_U c = cos (beta eps u)) by (cbn; rewrite Dj, Eb; symmetry; apply cosine_of_beta; lra).
  assert (Fc := flat_root (jmul dj b) ltac:(cbn; rewrite Dj0; ring)). fold c in Fc.
  change (at_0 c = 1 /\ slope_0 c = 0) in Fc. clearbody c.
  take c'. assert (Ec' : at_U c' = cos (beta eps u')) by (cbn; rewrite Dj, Eb'; symmetry; apply cosine_of_beta; lra).
  assert (Fc' := flat_root (jmul dj b') ltac:(cbn; rewrite Dj0; ring)).
  change (at_0 c' = 1 /\ slope_0 c' = 0) in Fc'. clearbody c'.
  destruct (beta_parts eps u Heps ltac:(lra)) as [C0 _]. destruct (beta_parts eps u' Heps S1) as [C0' _].
  take waves. assert (Wv : at_U waves = sinc u * sinc u' * (1 - rho * rho)) by (cbn; rewrite Wu, Wu'; reflexivity).
  clearbody waves.
  assert (s2 : forall x, 0 < x -> sinc (2 * x) = sinc x * cos x) by (intros x Hx; unfold sinc; rewrite sin_2a; field;
    lra).
  take doubles. assert (Db : at_U doubles = 4 * (eps / (d * U)) * sinc (2 * U) * sinc (2 * d)).
  { cbn. rewrite Eh, WU, Wd, CU. cbn. rewrite (s2 U), (s2 d) by lra.
    replace (1 + U * U * - (rho * rho / 2 * tail_cos (rho * U))) with (cos d); [ring|]. rewrite <- rU, cos_tail.
    field. }
  clearbody doubles.
  assert (su : 0 < sinc u) by (apply Rdiv_lt_0_compat; lra). assert (su' : 0 < sinc u') by (apply Rdiv_lt_0_compat;
    lra).
  take kc. assert (Kc : at_U kc = size_c eps u u').
  { cbn. rewrite Ec, Ec', Db, Eh, Wv. unfold size_c. fold U d. fold rho. field. repeat split; lra. }
  clearbody kc.
  take ks. assert (Ks : at_U ks = size_s eps u u').
  { cbn. rewrite Wv, Db, Wu, Wu', Ec, Ec'. cbn. unfold size_s. fold U d. fold rho. set (x := cos (beta eps u)) in *.
    set (y := cos (beta eps u')) in *.
    assert (0 < (1 + rho) * sinc u * y) by (apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]; lra).
    assert (0 < (1 - rho) * sinc u' * x) by (apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]; lra). field.
    repeat split; lra. }
  clearbody ks.
  take ratio. assert (Rt : at_U ratio = (sinc d / sinc U)^2) by (cbn; rewrite Wd, WU; cbn; unfold Rdiv; ring).
  assert (Rt0 : at_0 ratio = 1 /\ slope_0 ratio = 0) by (cbn; rewrite Wd, WU; cbn; split; field). clearbody ratio.
  take rU'. change rU' with (rho * U). rewrite !rU. clear rU'.
  take lost. assert (Ls : at_U lost = (2 * d - sin (2 * d)) / (2 * d^3) * U^2).
  { cbn. rewrite (sin_tail (2 * d)). field. lra. }
  assert (Ls0 : at_0 lost = 0 /\ slope_0 lost = 0) by (split; reflexivity). clearbody lost.
  take fall. assert (Fl : at_U fall = size_x u u' * (1 - rho * rho) / 2).
  { cbn. rewrite Rt, Ls. unfold size_x. fold U d.
    assert (X : sin d / sin U = rho * (sinc d / sinc U)) by (unfold rho, sinc; field; repeat split; lra). rewrite X.
    set (t := sinc d / sinc U) in *.
    assert (X2 : 0 < 1 - rho * t * (rho * t)).
    { rewrite <- X. replace (1 - sin d / sin U * (sin d / sin U))
      with ((sin U * sin U - sin d * sin d) / (sin U * sin U)) by (field; lra).
      apply Rdiv_lt_0_compat; [exact W | now apply Rmult_lt_0_compat]. }
    set (w := (2 * d - sin (2 * d)) / (2 * d^3)). field. repeat split; lra. }
  assert (Fl0 : at_0 fall = 1 /\ slope_0 fall = 0).
  { destruct Rt0 as [A1 A2], Ls0 as [B1 B2]. cbn. rewrite A1, A2, B1, B2.
    split; field; try lra. }
  clearbody fall.
  take fall'. assert (Fl' : at_U fall' = - size_x1 u u' * (1 - rho)).
  { cbn. rewrite CU, WU, Wd, Wu'. cbn. rewrite (tau_value d ltac:(lra)). unfold size_x1. fold U d. fold rho.
    assert (X : sin U = U * sinc U) by (unfold sinc; field; lra). rewrite X. set (x := sin d - d * cos d).
    set (w := sinc U). set (t := sinc d). set (v := sinc u') in *. rewrite <- rU. field. repeat split; lra. }
  assert (Fl0' : at_0 fall' = 1 /\ slope_0 fall' = 0) by (cbn; rewrite CU, Wd, Wu'; cbn; split; field).
  clearbody fall'.
  take more. assert (Mr :
    at_U more = Q * size_c eps u u' + sin th * size_s eps u u' + cos th * size_x1 u u' * d * size_c eps u u' * rho).
  { cbn. rewrite HQ, Kc, Ks, Sin, Cos, Fl', Dj. field. lra. }
  clearbody more.
  assert (T' : at_U b' = eps / (d * sin u')) by (apply Rmult_eq_reg_l with d; [rewrite Eb'; field; lra | lra]).
  take kick. assert (Kk : at_U kick = Q * ((eps / (d * sin u'))^2 * (cos (beta eps u'))^2 / (1 + cos (beta eps u')))
      + sin th * (eps / (d * sin u')) * cos (beta eps u')).
  { cbn. rewrite HQ, T', Ec', Sin. field. repeat split; lra. }
  clearbody kick.
  take cf. assert (Cf : at_U cf = cos (beta eps u) * (size_x u u' * (1 - rho * rho) / 2)) by (cbn; rewrite Ec, Fl;
    reflexivity).
  assert (Cf0 : at_0 cf = 1 /\ slope_0 cf = 0).
  { destruct Fc as [A1 A2], Fl0 as [B1 B2]. cbn. rewrite A1, A2, B1, B2. split; ring. }
  clearbody cf.
  take cf'. assert (Cf' : at_U cf' = cos (beta eps u') * (- size_x1 u u' * (1 - rho))) by (cbn; rewrite Ec', Fl';
    reflexivity).
  assert (Cf0' : at_0 cf' = 1 /\ slope_0 cf' = 0).
  { destruct Fc' as [A1 A2], Fl0' as [B1 B2]. cbn. rewrite A1, A2, B1, B2. split; ring. }
  clearbody cf'.
  (* X' = X_1 d rho *)
  assert (X1 : d - sin d * sin U / sin u' = size_x1 u u' * d * rho).
  { unfold size_x1. fold U d. fold rho. assert (Y : sin u' = sin U * cos d - cos U * sin d)
      by (rewrite <- sin_minus; now f_equal).
    unfold sinc. set (S' := sin u') in *. transitivity ((d * S' - sin d * sin U) / S'); [field; lra|].
    transitivity ((d * (sin U * cos d - cos U * sin d) - sin d * sin U) / S'); [now rewrite <- Y|].
    rewrite <- mU. unfold rho. field. repeat split; lra. }
  assert (Sz : size eps u u' th = cos th * (cos (beta eps u) * size_x u u') + U * at_U more).
  { rewrite Mr. unfold size. fold U d. rewrite X1. fold Q. ring. }
  take change. assert (Ch : at_U change = size eps u u' th * (1 - rho * rho)) by (cbn; rewrite Sz, Cos, Cf, Zu;
    field).
  clearbody change.
  take lj. assert (La : at_U lj = size_after eps u u' th).
  { cbn. rewrite Cos, Cf', Zu, Kk. unfold size_after. fold U d. fold Q. field. repeat split; lra. }
  clearbody lj.
  unfold values_are. cbn [z_sin_U z_cos_U z_F z_Q z_ehat z_change z_first z_last z_apart].
  repeat split; try assumption.
  - rewrite CU. reflexivity.
  - cbn. rewrite La, Ch. unfold size_before. fold U d. fold rho. field. repeat split; lra.
  - cbn. rewrite Sz. unfold size_after. fold U d. fold Q. unfold bend_of, rise_of.
    destruct Cf0 as [-> ->], Cf0' as [-> ->].
    rewrite Cf, Cf', Cos, Kk. field. repeat split; lra.
Qed.
End Values.
