(** L50 (b) and L57 (b) of law.md: value and slope at U = 0 of what the rule of LayerRule.v computes,
  for every rho and
    every q, where Q = pi/2 + rho^2 U q. Only the sum over the nodes is known of an integral, and that is enough.

    starts          == an exact jet's value and slope at 0
    H0, e0          == H and G at U = 0
    node_sum        == of the weights, and with the nodes: 1/2 and 1/3
    start_sizes     == of the sizes of a step
    start_both, start_of_H == of (mu - 2 (1 + rho) g1)/(1 - rho), from the integrals, and by L50
    start_half      == B/(2 eps^)^(1/2) starts with 1
    L57b            == Rr starts with 1 - U (5/(3 pi) + rho^2/(3 pi) (12 q - 1/(1 - rho)))
    start_place     == y/U starts with 1 *)
From Coq Require Import Reals Lra List.
From Dumbbell Require Import LawStatement Comparison Slopes Calculus LayerRule LayerValues.
Local Open Scope R_scope.

Definition starts (x : jet) a b := at_0 x = a /\ slope_0 x = b.
Definition H0 := 8 / (3 * sqrt 3 * PI^2).
Definition e0 := / (sqrt 3 * PI).
Lemma root3 : sqrt 3 * sqrt 3 = 3 /\ 0 < sqrt 3 /\ 0 < sqrt 3 * PI /\ 0 < PI.
Proof.
  assert (P := PI_RGT_0). destruct root_three as [A B]. repeat split; try assumption. now apply Rmult_lt_0_compat.
Qed.
Lemma sqrt34 : sqrt (3/4) = sqrt 3 / 2.
Proof. rewrite sqrt_div_alt by lra. replace 4 with (2 * 2) by ring. now rewrite sqrt_square by lra. Qed.
Ltac use := cbn; repeat match goal with
  | K : starts ?x _ _ |- context [at_0 ?x] => rewrite (proj1 K) | K : starts ?x _ _ |- context [slope_0 ?x] =>
    rewrite (proj2 K) end.
Ltac by_field T := field_simplify_eq; [ring [T] | repeat split; try assumption; lra].

(** A kernel's radicand F^2 - Q^2, where F = pi - k U. *)
Lemma start_radicand U k J j : starts J (PI / 2) j ->
  let R := jsub (jsqr (jline U PI (- k))) (jsqr J) in starts R (3 * PI^2 / 4) (- PI * (2 * k + j)) /\
  starts (jsqrt R) (sqrt 3 * PI / 2) (- (2 * k + j) / sqrt 3).
Proof.
  intros K R. destruct root3 as [T [T0 [T1 P]]]. assert (KR : starts R (3 * PI^2 / 4) (- PI * (2 * k + j))) by (split;
    unfold R; use; field).
  split; [exact KR|]. assert (E : sqrt (3 * PI^2 / 4) = sqrt 3 * PI / 2).
  { replace (3 * PI^2 / 4) with (3/4 * (PI * PI)) by field. rewrite sqrt_mult_alt, sqrt_square, sqrt34 by lra. field.
    }
  clearbody R. split; use; rewrite ?E; [reflexivity | field; lra].
Qed.

Section Start.
Variables U rho q : R.
Hypothesis Hrho : 0 < rho <= 1/5.
Hypothesis HU : 0 < U.
Let chi := rho * rho * q.
Let C := exact U.
Let Q := jline U (PI / 2) chi.

Lemma rho_facts : 0 < 1 - rho /\ 0 < 1 + rho /\ 0 < 1 - rho * rho /\ 0 < 1 - rho^2.
Proof. assert (rho * rho <= 1/5 * (1/5)) by (apply Rmult_le_compat; lra). simpl. repeat split; lra. Qed.

Lemma start_node_G J j k : starts J (PI / 2) j -> starts (node_G C J k) e0 (7 * k / (3 * sqrt 3 * PI^2) + j * H0).
Proof.
  intros K. destruct root3 as [T [T0 [T1 P]]]. destruct (start_radicand U k J j K) as [_ KR].
  unfold node_G, s_G, s_root_of. cbn [s_sinc C exact s_mul s_inv s_line s_root s_sub s_sqr n_neg n_pi].
  set (R := jsqrt _) in *. clearbody R. split; use; unfold e0, H0; by_field T.
Qed.
Lemma start_node_H J j k : starts J (PI / 2) j -> starts (node_H C J k) H0 (H0 * (2 * j + 3 * k) / PI).
Proof.
  intros K. destruct root3 as [T [T0 [T1 P]]]. destruct (start_radicand U k J j K) as [KR KS].
  unfold node_H, s_H. cbn [s_sinc C exact s_mul s_inv s_line s_root s_sub s_sqr n_neg n_pi]. cbv zeta in *.
  set (R := jsub _ _) in *. clearbody R. set (S := jsqrt R) in *. clearbody S. split; use; unfold H0; by_field T.
Qed.

(** What the nodes and weights have to be. *)
Definition node_sum (nodes : list (R * R)) (f : R -> R) := fold_right (fun '(n, w) s => f n * w + s) 0 nodes.
Variable nodes : list (R * R).
Hypothesis half_sum : node_sum nodes (fun _ => 1) = 1/2 /\ node_sum nodes (fun n => n) = 1/3.
Lemma start_sum f a b c : (forall k, starts (f k) a (b + c * k)) ->
  starts (sum_nodes C rho f nodes) (a / 2) (b / 2 + c * (1 + rho) / 3).
Proof.
  intros Hf. destruct half_sum as [S0 S1].
  assert (E : forall l, starts (sum_nodes C rho f l) (a * node_sum l (fun _ => 1))
    (b * node_sum l (fun _ => 1) + c * (1 + rho) * node_sum l (fun n => n))).
  { induction l as [|[n w] l [I1 I2]]; [split; cbn; ring|]. destruct (Hf (plus C rho * n)) as [F1 F2].
    change (sum_nodes C rho f ((n, w) :: l)) with (jadd (jscale (f (plus C rho * n)) w) (sum_nodes C rho f l)).
    change (node_sum ((n, w) :: l) (fun _ => 1)) with (1 * w + node_sum l (fun _ => 1)).
    change (node_sum ((n, w) :: l) (fun n => n)) with (n * w + node_sum l (fun n => n)).
    change (plus C rho) with (1 + rho) in *.
    split; cbn [jadd jscale at_0 slope_0]; [rewrite F1, I1 | rewrite F2, I2]; ring. }
  destruct (E nodes) as [E1 E2]. rewrite S0, S1 in *. split; [rewrite E1 | rewrite E2]; field.
Qed.

Definition sizes_start (s : sizes C) :=
  starts (z_sin_U C s) 0 1 /\ starts (z_cos_U C s) 1 0 /\ z_F C s = jline U PI (-1) /\ z_Q C s = Q /\
  starts (z_ehat C s) e0 ((7 + 8 * chi) / (3 * sqrt 3 * PI^2)) /\
  starts (z_change C s) 1 ((2 * chi + (7 - 6 * rho^2) / (3 * (1 - rho^2))) / PI) /\
  at_0 (z_first C s) = - / (2 * (1 + rho)) /\ at_0 (z_last C s) = - / (2 * (1 - rho)) /\
  at_0 (z_apart C s) = (/ (3 * PI * (1 - rho^2)^2) + / (PI * (1 - rho^2))) * ((1 + rho) / 2) -
    (/ (12 * PI * (1 - rho)^2) + / (2 * PI * (1 - rho))).
Theorem start_sizes : sizes_start (sizes_of C rho Q).
Proof.
  destruct root3 as [T [T0 [T1 P]]]. destruct rho_facts as [m0 [p0 [r0 r2]]].
  assert (rU : 0 < rho * U) by (apply Rmult_lt_0_compat; lra).
  assert (pU : 0 < (1 + rho) * U) by (apply Rmult_lt_0_compat; lra).
  assert (mU : 0 < (1 - rho) * U) by (apply Rmult_lt_0_compat; lra).
  cbv beta delta [sizes_of plus minus product].
  change (n_mul C rho (n_U C)) with (rho * U). change (n_add C (n_Z C 1) rho) with (1 + rho).
  change (n_sub C (n_Z C 1) rho) with (1 - rho). change (n_sub C (n_Z C 1) (n_sqr C rho)) with (1 - rho * rho).
  take z. assert (Zu : starts z 0 1) by (split; reflexivity). clearbody z.
  take dj. assert (Dj : starts dj 0 rho) by (split; reflexivity). clearbody dj.
  take wd. assert (Wd : starts wd 1 0) by (split; reflexivity). clearbody wd.
  take wU. assert (WU : starts wU 1 0) by (split; reflexivity). clearbody wU.
  take wu. assert (Wu : starts wu 1 0) by (split; reflexivity). clearbody wu.
  take wu'. assert (Wu' : starts wu' 1 0) by (split; reflexivity). clearbody wu'.
  take cU. assert (CU : starts cU 1 0) by (split; reflexivity). clearbody cU.
  take sU. assert (SU : starts sU 0 1) by (split; use; ring). clearbody sU.
  take F. assert (EF : F = jline U PI (-1)) by reflexivity.
  assert (Fs : starts F PI (-1)) by (split; reflexivity). clearbody F.
  take cosine. assert (Cos : starts cosine (1/2) ((1/2 + chi) / PI)) by (split; use; field; lra). clearbody cosine.
  take sine. assert (Sin : starts sine (sqrt 3 / 2) (- (1/2 + chi) / (PI * sqrt 3))).
  { assert (E : sqrt (- (1/2 * (1/2)) + 1) = sqrt 3 / 2) by (rewrite <- sqrt34; f_equal; field).
    split; use; rewrite E; [reflexivity | field; lra]. }
  clearbody sine.
  take ehat. assert (Eh : starts ehat e0 ((7 + 8 * chi) / (3 * sqrt 3 * PI^2))) by (split; use; unfold e0;
    by_field T).
  clearbody ehat.
  take b. assert (Eb : at_0 b = e0 / (1 + rho)) by (use; field; lra). clearbody b.
  take b'. assert (Eb' : at_0 b' = e0 / (1 - rho)) by (use; field; lra). clearbody b'.
  take c. assert (Ec : starts c 1 0) by (apply (flat_root (jmul dj b)); use; ring). clearbody c.
  take c'. assert (Ec' : starts c' 1 0) by (apply (flat_root (jmul dj b')); use; ring). clearbody c'.
  take waves. assert (Wv : at_0 waves = 1 - rho * rho) by (use; ring). clearbody waves.
  take doubles. assert (Db : at_0 doubles = 4 * e0) by (use; ring). clearbody doubles.
  take kc. assert (Kc : at_0 kc = 2 * e0 * e0 / ((1 - rho * rho) * (1 - rho * rho))) by (use; rewrite Db, Wv; field;
    lra). clearbody kc.
  take ks. assert (Ks : at_0 ks = 2 * e0 / (1 - rho * rho)) by (use; rewrite Db, Wv; field; repeat split; lra).
  clearbody ks.
  take rt. assert (Rt : starts rt 1 0) by (split; use; field). clearbody rt.
  take rUn. clearbody rUn.
  take lost. assert (Ls : starts lost 0 0) by (split; reflexivity). clearbody lost.
  take fall. assert (Fl : starts fall 1 0) by (split; use; field; lra). clearbody fall.
  take fall'. assert (Fl' : starts fall' 1 0) by (split; use; field). clearbody fall'.
  take more. assert (Mr : at_0 more = / (3 * PI * (1 - rho^2)^2) + / (PI * (1 - rho^2))).
  { use. rewrite Kc, Ks. unfold e0. replace (1 - rho^2) with (1 - rho * rho) by ring. by_field T. }
  clearbody more.
  take kick. assert (Kk : at_0 kick = / (12 * PI * (1 - rho)^2) + / (2 * PI * (1 - rho))).
  { use. rewrite Eb'. unfold e0. by_field T. }
  clearbody kick.
  take cf. assert (Cf : starts cf 1 0) by (split; use; ring). clearbody cf.
  take cf'. assert (Cf' : starts cf' 1 0) by (split; use; ring). clearbody cf'.
  take change. assert (Ch : starts change 1 ((2 * chi + (7 - 6 * rho^2) / (3 * (1 - rho^2))) / PI)).
  { split; use; rewrite ?Mr; field; repeat split; try lra. }
  clearbody change.
  take lj. assert (La : at_0 lj = - / (2 * (1 - rho))) by (use; field; lra). clearbody lj.
  unfold sizes_start. cbn [z_sin_U z_cos_U z_F z_Q z_ehat z_change z_first z_last z_apart].
  repeat (split; [first [assumption | reflexivity]|]). split; [|split; [exact La|]].
  - use. rewrite La. field. repeat split; lra.
  - use. rewrite Mr, Kk. cbn. ring.
Qed.

Lemma start_mean e : starts (mean_of C rho Q e) (2 * H0) (2 * H0 * (2 * chi + 3 + rho^2) / PI).
Proof.
  destruct root3 as [T [T0 [T1 P]]]. assert (K := start_node_H Q chi (1 + rho * rho / 3) ltac:(split; reflexivity)).
  unfold mean_of. change (n_add C (n_Z C 1) (n_div C (n_sqr C rho) (n_Z C 3))) with (1 + rho * rho / 3).
  set (x := node_H C Q _) in *. clearbody x. split; use; field; lra.
Qed.
Lemma start_way e : starts (way_of C rho nodes Q e) (H0 / 2) (H0 * (chi + 1 + rho) / PI).
Proof.
  destruct root3 as [T [T0 [T1 P]]].
  assert (K := start_sum (node_H C Q) H0 (2 * chi * H0 / PI) (3 * H0 / PI)).
  assert (K' : starts (sum_nodes C rho (node_H C Q) nodes) (H0 / 2) (2 * chi * H0 / PI / 2 + 3 * H0 / PI * (1 + rho) /
    3)).
  { apply K. intros k. assert (X := start_node_H Q chi k ltac:(split; reflexivity)).
    destruct X as [X1 X2]. split; [exact X1 | rewrite X2; field; lra]. }
  unfold way_of. set (x := sum_nodes _ _ _ _) in *. clearbody x. split; use; field; lra.
Qed.
(** What cancels in the integrals. *)
Theorem start_both e e' :
  starts (both_of C rho (mean_of C rho Q e) (way_of C rho nodes Q e')) H0 (H0 * (2 * chi + 4) / PI).
Proof.
  destruct root3 as [T [T0 [T1 P]]]. destruct rho_facts as [m0 [p0 [r0 r2]]].
  assert (M := start_mean e). assert (W := start_way e'). set (x := mean_of _ _ _ _) in *.
  set (y := way_of _ _ _ _ _) in *.
  clearbody x y. unfold both_of, plus, minus. split; use; field; repeat split; lra.
Qed.
Definition R3 := let R := jshift (jneg (jsqr Q)) (PI * PI) in jinv (jmul R (jsqrt R)).
Definition turn := jsub (jscale (jmul R3 (jinv (jshift (jneg (jsqr Q)) (PI * PI)))) (3 * (PI * PI))) R3.
Theorem start_of_H : starts (jscale R3 PI) H0 (2 * chi * H0 / PI) /\ at_0 turn = 3 * H0 / PI.
Proof.
  destruct root3 as [T [T0 [T1 P]]]. unfold turn, R3. set (R := jshift (jneg (jsqr Q)) (PI * PI)).
  assert (KR : starts R (3 * PI^2 / 4) (- PI * chi)) by (split; unfold R; use; field). clearbody R.
  assert (E : sqrt (3 * PI^2 / 4) = sqrt 3 * PI / 2).
  { replace (3 * PI^2 / 4) with (3/4 * (PI * PI)) by field. rewrite sqrt_mult_alt, sqrt_square, sqrt34 by lra. field.
    }
  set (S := jsqrt R). assert (KS : starts S (sqrt 3 * PI / 2) (- chi / sqrt 3)).
  { unfold S. split; use; rewrite ?E; [reflexivity | field; lra]. }
  clearbody S. split; [split|]; use; unfold H0; by_field T.
Qed.

Variable s : sizes C.
Hypothesis Hs : sizes_start s.
Let kappa := (2 * (7 + 14 * rho + rho^2 + 12 * chi * (1 + rho)) / (9 * (1 + rho)) - (7 + 8 * chi) / 3) / PI.
Lemma start_k e : starts (k_of C rho nodes s e) 1 kappa.
Proof.
  destruct root3 as [T [T0 [T1 P]]]. destruct rho_facts as [m0 [p0 [r0 r2]]].
  destruct Hs as (_ & _ & _ & EQ & Eh & _ & A & _ & _).
  assert (KJ : starts (J_of C rho s) (PI / 2) (chi - rho * rho / (2 * (1 + rho)))).
  { unfold J_of. rewrite EQ. split; use; rewrite ?A; field; lra. }
  assert (K := start_sum (node_G C (J_of C rho s)) e0 ((chi - rho * rho / (2 * (1 + rho))) * H0) (7 / (3 * sqrt 3 *
    PI^2))).
  assert (K' := K ltac:(intros k; destruct (start_node_G _ _ k KJ) as [X1 X2]; split; [exact X1 | rewrite X2; field;
    lra])).
  unfold k_of. set (x := sum_nodes _ _ _ _) in *. clearbody x. unfold kappa. split; use; unfold e0, H0; by_field T.
Qed.
Theorem start_half e : starts (half_of C rho (k_of C rho nodes s e)) 1 (kappa * (1 + rho) / (2 * (1 - rho))).
Proof.
  destruct rho_facts as [m0 [p0 [r0 r2]]]. assert (K := start_k e). set (x := k_of _ _ _ _ _) in *. clearbody x.
  set (y := below_of C rho x). assert (KB : starts y 1 (kappa * ((1 + rho) / (1 - rho) * ((1 + rho) / (1 - rho)))))
    by (unfold y, below_of, plus, minus; split; use; ring).
  change (half_of C rho x) with (jshift (jscale (jadd (jscale (jshift (jsqrt x) (-1)) (1 + rho))
    (jscale (jshift (jsqrt y) (-1)) (1 - rho))) (1 / 2)) 1).
  clearbody y. assert (rx : starts (jsqrt x) 1 (kappa / 2)) by (split; use; rewrite sqrt_1; field).
  assert (ry : starts (jsqrt y) 1 (kappa * ((1 + rho) / (1 - rho) * ((1 + rho) / (1 - rho))) / 2))
    by (split; use; rewrite sqrt_1; field; lra).
  set (x' := jsqrt x) in *. set (y' := jsqrt y) in *. clearbody x' y'. split; use; field; lra.
Qed.

Lemma start_first_part a b c :
  starts (first_part C s a b c) (14 / (9 * sqrt 3 * PI^2)) ((26 + 16 * chi) / (3 * sqrt 3 * PI^3)).
Proof.
  destruct root3 as [T [T0 [T1 P]]]. destruct Hs as (Ss & Sc & EF & EQ & _).
  assert (K := start_radicand U 1 Q chi ltac:(split; reflexivity)). cbv zeta in K.
  unfold first_part. rewrite EF, EQ. cbv zeta. change (s_sub C (s_sqr C (jline U PI (-1))) (s_sqr C Q))
    with (jsub (jsqr (jline U PI (- (1)))) (jsqr Q)).
  set (R := jsub _ _) in *. destruct K as [KR KS]. change (s_root C R) with (jsqrt R). set (r := jsqrt R) in *.
  clearbody r. clearbody R.
  split; use; by_field T.
Qed.
Lemma start_second_part e e' h h' : at_0 h = at_0 h' ->
  starts (second_part C rho s (mean_of C rho Q e) (both_of C rho (mean_of C rho Q e) (way_of C rho nodes Q e')) h h')
    (- H0 / 2) (- H0 * (3 + 2 * chi) / PI).
Proof.
  intros Hh. destruct root3 as [T [T0 [T1 P]]]. destruct rho_facts as [m0 [p0 [r0 r2]]].
  destruct Hs as (_ & _ & _ & _ & _ & Ch & Af & Al & Ap).
  assert (B := start_both e e'). assert (M := start_mean e). set (x := mean_of _ _ _ e) in *.
  set (y := both_of _ _ _ _) in *. clearbody x y. unfold second_part, plus, minus.
  split; use; rewrite ?Af, ?Al, ?Ap, ?Hh; [field; lra|]. replace (1 - rho^2) with ((1 - rho) * (1 + rho)) by ring.
  simpl. field.
  repeat split; try lra.
Qed.
Theorem L57b a b c e e' f h h' : at_0 h = at_0 h' ->
  let m := jadd (first_part C s a b c)
    (second_part C rho s (mean_of C rho Q e) (both_of C rho (mean_of C rho Q e) (way_of C rho nodes Q e')) h h') in
  starts (ratio_of C s m (half_of C rho (k_of C rho nodes s f))) 1
    (- (5 / (3 * PI) + rho^2 / (3 * PI) * (12 * q - / (1 - rho)))).
Proof.
  intros Hh m. destruct root3 as [T [T0 [T1 P]]]. destruct rho_facts as [m0 [p0 [r0 r2]]].
  destruct (start_first_part a b c) as [F1 F2]. destruct (start_second_part e e' h h' Hh) as [S1 S2].
  assert (M : starts m (2 / (9 * sqrt 3 * PI^2)) (2 / (3 * sqrt 3 * PI^3))).
  { unfold m. split; cbn [jadd at_0 slope_0]; [rewrite F1, S1 | rewrite F2, S2]; unfold H0; field; lra. }
  clearbody m. assert (Hf := start_half f). set (x := half_of _ _ _) in *. clearbody x.
  destruct Hs as (_ & _ & _ & _ & Eh & _).
  assert (g0 : 0 < sqrt (sqrt 3)) by (now apply sqrt_lt_R0). assert (g2 := sqrt_sqrt (sqrt 3) (Rlt_le _ _ T0)).
  assert (w0 : 0 < sqrt PI) by (now apply sqrt_lt_R0). assert (w2 := sqrt_sqrt PI (Rlt_le _ _ P)).
  assert (E : sqrt e0 = / (sqrt (sqrt 3) * sqrt PI)) by (unfold e0; rewrite sqrt_inv, sqrt_mult_alt by lra;
    reflexivity).
  set (e1 := (7 + 8 * chi) / (3 * sqrt 3 * PI^2)) in *.
  set (r := jsqrt (z_ehat C s)). assert (Kr :
    starts r (/ (sqrt (sqrt 3) * sqrt PI)) (e1 * (sqrt (sqrt 3) * sqrt PI) / 2)).
  { unfold r. split; use; rewrite E; [reflexivity | field; lra]. }
  unfold ratio_of. change (s_root C (z_ehat C s)) with r. clearbody r.
  assert (G : 0 < sqrt (sqrt 3) * sqrt PI) by (now apply Rmult_lt_0_compat).
  unfold n_k0. set (g := sqrt (sqrt 3)) in *. set (w := sqrt PI) in *. clearbody g w.
  assert (g4 : g * g * (g * g) = 3) by (rewrite g2; exact T).
  split; use; unfold e0, e1, kappa; rewrite <- ?g2, <- ?w2; rewrite (sqrt_square g), (sqrt_square w) by lra.
  - field_simplify_eq; [ring [g4] | lra].
  - unfold chi. field_simplify_eq; [ring [g4] | repeat split; lra].
Qed.
Theorem start_place f : at_0 (place_of C s (half_of C rho (k_of C rho nodes s f))) = 1.
Proof.
  destruct root3 as [T [T0 [T1 P]]]. assert (Hf := start_half f). set (x := half_of _ _ _) in *. clearbody x.
  destruct Hs as (_ & _ & _ & _ & Eh & _). unfold place_of. use. unfold e0.
  replace (/ (sqrt 3 * PI) * (sqrt 3 * PI)) with 1 by (field; lra). rewrite sqrt_1. ring.
Qed.
End Start.
