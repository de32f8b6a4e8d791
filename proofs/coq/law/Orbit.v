(** The orbit of a critical ratio (Theorem 2 (c), L43, the first contact of L44): a sequence of contacts that ends with
    a tangent flight. The corner orbit starts at its virtual contact 0, the top orbit at its contact 1.

    corner_start, top_start == where they start
    orbit             == its contacts (u i, al i), i = 0, ..., n, and the point y of tangency
    orbit_of_critical == every critical ratio q_c(N), N >= 4, has one, with eps = q^(-1/2)
    arcsine           == r <= x <= 1.000001 r where sin x = r is small
    top_first         == J - pi/2 is in [0.2145, 0.2147] eps^2 at the first contact of the top orbit
    first_invariant   == pi/2 <= J <= pi/2 + 0.2147 eps^2 at the first contact of either
    step_at           == the step from contact i, by the angle of its flight
    invariant_falls   == J falls along the orbit
    contacts_fall     == u falls along the orbit; al grows *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Dumbbell Require Import Trigonometry Ray Orbits CriticalRatios Tangency LeftLimit LawStatement Sines Angles Falls.
Local Open Scope R_scope.

Definition corner_start (eps u al : R) := u = PI/2 /\ al = 0.
Definition top_start eps u al := exists x, 0 < x < PI/2 /\ sin x = eps * eps /\ u = PI/2 - x /\ al = beta eps u.
Record orbit (eps : R) (N n : nat) (u al : nat -> R) (y : R) : Prop := {
  orbit_steps : sequence eps u al n;
  orbit_end : last eps (u n) (al n) y;
  orbit_start : (N = (2 * n + 4)%nat /\ corner_start eps (u O) (al O)) \/
    (N = (2 * n + 5)%nat /\ top_start eps (u O) (al O)) }.

Lemma eps_of q : 1 <= q -> 0 < / sqrt q <= 1 /\ / sqrt q * / sqrt q = / q.
Proof.
  intros Hq. assert (S : 1 <= sqrt q) by (rewrite <- sqrt_1; apply sqrt_le_1; lra). split; [split|].
  - apply Rinv_0_lt_compat; lra.
  - rewrite <- Rinv_1. apply Rinv_le_contravar; lra.
  - rewrite <- Rinv_mult, sqrt_sqrt by lra. reflexivity.
Qed.
Lemma eps_below_peak eps : 0 < eps <= 1 -> 0 < atan eps < PI/2 /\ beta eps (PI/2) = atan eps.
Proof.
  intros He. destruct (atan_bound eps). unfold beta. rewrite sin_PI2, Rdiv_1. split; [|reflexivity]. split; [|lra].
  rewrite <- atan_0. apply atan_increasing. lra.
Qed.

Theorem orbit_of_critical N q : (4 <= N)%nat -> critical N q -> exists n u al y, orbit (/ sqrt q) N n u al y.
Proof.
  intros HN Hc. assert (Hq : 1 <= q) by apply Hc. destruct (eps_of q Hq) as [He E]. set (eps := / sqrt q) in *.
  assert (HPI := PI2_1). destruct (odd_or_even N ltac:(lia)) as [k [->| ->]].
  - apply (theorem_2c_odd q k Hq) in Hc. destruct Hc as [a [b [HS HT]]]. destruct k as [|k]; [lia|].
    destruct HS as [x [Hx [HD HS]]]. rewrite <- E in *. destruct Hx as [X1 [X2 X3]]. assert (W := cos_pos x X1).
    assert (Z : 0 = eps * tan 0) by (rewrite tan_0; ring). rewrite Z in HD at 2. rewrite Z in HS.
    destruct (turned eps (cos x) 0 ltac:(lra) W ltac:(lra) HD) as [T1 T2]. rewrite T2 in HS.
    replace (atan (eps / cos x)) with (beta eps (PI/2 - x)) in T1, HS by (unfold beta; now rewrite Rtrigo1.sin_shift).
    assert (B : 0 < beta eps (PI/2 - x)) by (apply beta_pos; [lra | rewrite Rtrigo1.sin_shift; exact W]).
    destruct (contacts_of_state eps k a b He x _ X1 T1 ltac:(lra) HS) as [u [al [U0 [A0 [S [HU [HA [HB [->
      ->]]]]]]]]].
    destruct (last_of_tangent eps u al k He HU HA HB HT) as [y L]. exists k, u, al, y.
    constructor; [exact S | exact L|].
    right. split; [lia|]. exists x. split; [|split; [lra | split; [exact U0 | rewrite A0, U0; ring]]].
    split; [|lra]. destruct (Rle_lt_or_eq_dec 0 x) as [P|X0]; [lra | exact P|]. exfalso. rewrite <- X0, sin_0 in X2.
    assert (0 < eps * eps) by (apply Rmult_lt_0_compat; lra). lra.
  - apply (theorem_2c_even q k Hq) in Hc. destruct Hc as [a [b [HS HT]]]. rewrite <- E in *.
    destruct (eps_below_peak eps He) as [A1 A2]. replace (PI/2) with (PI/2 - 0) in A2 by ring.
    assert (K : eps * tan (atan eps) = eps * eps) by (now rewrite tan_atan).
    replace (PI * (eps * eps)) with (sin 0 + eps * tan (atan eps) * (0 + PI)) in HS by (rewrite K, sin_0; ring).
    rewrite <- K in HS at 2.
    destruct (contacts_of_state eps k a b He 0 _ ltac:(lra) (proj2 A1) ltac:(lra) HS) as
      [u [al [U0 [A0 [S [HU [HA [HB [-> ->]]]]]]]]].
    destruct (last_of_tangent eps u al k He HU HA HB HT) as [y L]. exists k, u, al, y.
    constructor; [exact S | exact L|].
    left. split; [lia|]. split; [lra | rewrite A0, U0; lra].
Qed.

(** The first contact of the top orbit. *)
Lemma root_between t c : 0 <= t <= 1 -> 0 < c -> c * c * (1 + t) = 1 -> 1 - t / 2 <= c <= 1 - t / 2 + t * t / 2.
Proof.
  intros Ht Hc E. assert (T2 : 0 <= t * t) by (apply Rmult_le_pos; lra).
  assert (T3 : 0 <= t * t * t) by (apply Rmult_le_pos; lra).
  assert (t * t * t <= t * t * 1) by (apply Rmult_le_compat_l; lra).
  assert (T4 : 0 <= t * t * t * t) by (apply Rmult_le_pos; lra).
  assert (T5 : 0 <= t * t * t * t * t) by (apply Rmult_le_pos; lra).
  assert (t * t * t * t <= t * t * t * 1) by (apply Rmult_le_compat_l; lra). split.
  - apply Rnot_lt_le. intros K. assert (c * c < (1 - t / 2) * (1 - t / 2)) by (apply Rmult_le_0_lt_compat; lra).
    assert (c * c * (1 + t) < (1 - t / 2) * (1 - t / 2) * (1 + t)) by (apply Rmult_lt_compat_r; lra). lra.
  - apply Rnot_lt_le. intros K. set (p := 1 - t / 2 + t * t / 2) in *.
    assert (p * p < c * c) by (apply Rmult_le_0_lt_compat; unfold p in *; lra).
    assert (p * p * (1 + t) < c * c * (1 + t)) by (apply Rmult_lt_compat_r; lra). unfold p in *. lra.
Qed.
Lemma arcsine x r : 0 < x < PI/2 -> sin x = r -> r <= 1/1000000 -> r <= x <= 1.000001 * r.
Proof.
  assert (V : 0.09 <= sin 0.1) by interval. intros Hx E Hr. assert (A : sin x < x) by (apply sin_lt_x; lra).
  assert (B : x < 0.1).
  { apply Rnot_le_lt. intros K. assert (sin 0.1 <= sin x) by (apply sin_incr_1; lra).
    lra. }
  assert (C := sine_below x ltac:(lra)).
  assert (x * x <= 0.1 * 0.1) by (apply Rmult_le_compat; lra).
  assert (x * x * x <= 0.1 * 0.1 * x) by (apply Rmult_le_compat_r; lra).
  assert (X2 : x <= 2 * r) by lra. assert (x * x <= 2 / 1000000 * (2 / 1000000)) by (apply Rmult_le_compat; lra).
  assert (x * x * x <= 2 / 1000000 * (2 / 1000000) * x) by (apply Rmult_le_compat_r; lra). lra.
Qed.
Lemma top_first eps u al : 0 < eps <= 1/1000 -> top_start eps u al ->
  PI/2 + 0.2145 * (eps * eps) <= invariant u al <= PI/2 + 0.2147 * (eps * eps).
Proof.
  intros He [x [Hx [Sx [-> ->]]]]. set (r := eps * eps) in *.
  assert (R0 : 0 < r) by (apply Rmult_lt_0_compat; lra).
  assert (R1 : r <= 1/1000 * (1/1000)) by (apply Rmult_le_compat; lra).
  destruct (arcsine x r Hx Sx ltac:(lra)) as [X1 X2]. unfold invariant. set (c := cos (beta eps (PI/2 - x))).
  assert (W : 0 < cos x) by (apply cos_gt_0; lra).
  assert (B := beta_pos eps (PI/2 - x) ltac:(lra) ltac:(rewrite Rtrigo1.sin_shift; exact W)).
  assert (C : 0 < c) by (apply cos_gt_0; lra). set (t := r / (1 - r * r)).
  assert (RR : 0 <= r * r <= 1/1000000 * r) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (E2 : cos x * cos x = 1 - r * r) by (assert (K := sin2_cos2 x); unfold Rsqr in K; rewrite Sx in K; lra).
  assert (Ec : c * c * (1 + t) = 1).
  { assert (K := sin2_cos2 (beta eps (PI/2 - x))). unfold Rsqr in K. fold c in K.
    assert (S : sin (beta eps (PI/2 - x)) = eps / cos x * c)
      by (unfold c, beta; rewrite Rtrigo1.sin_shift; apply sin_of_atan).
    rewrite S in K. rewrite <- K at 2. unfold t. rewrite <- E2. unfold r. field. lra. }
  assert (T1 : r <= t <= 1.00001 * r).
  { assert (P : t * (1 - r * r) = r) by (unfold t; field; lra). assert (0 < t) by (apply Rdiv_lt_0_compat; lra).
    assert (t * (r * r) <= t * (1/1000000)) by (apply Rmult_le_compat_l; lra).
    assert (0 <= t * (r * r)) by (apply Rmult_le_pos; lra). lra. }
  destruct (root_between t c ltac:(lra) C Ec) as [C1 C2]. assert (P1 : 3.14159 < PI < 3.14160) by (split; interval).
  assert (TT : 0 <= t * t <= 0.00001 * t) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (XT : 0 <= x * t <= 0.00001 * t) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  replace (PI - (PI/2 - x)) with (PI/2 + x) by field.
  assert (L : (PI/2 + x) * (1 - t / 2) <= (PI/2 + x) * c) by (apply Rmult_le_compat_l; lra).
  assert (M : (PI/2 + x) * c <= (PI/2 + x) * (1 - t / 2 + t * t / 2)) by (apply Rmult_le_compat_l; lra).
  assert (PT : 3.14159 * t <= PI * t <= 3.14160 * t) by (split; apply Rmult_le_compat_r; lra).
  assert (N : (PI/2 + x) * (t * t / 2) <= 2 * (t * t / 2)) by (apply Rmult_le_compat_r; lra). split; lra.
Qed.
Lemma first_invariant eps N n u al y : eps <= 1/1000 -> orbit eps N n u al y ->
  PI/2 <= invariant (u O) (al O) <= PI/2 + 0.2147 * (eps * eps).
Proof.
  intros He [_ [H0 _ _ _ _] [[_ [-> ->]]|[_ H]]].
  - unfold invariant. rewrite cos_0. assert (0 <= eps * eps) by apply Rle_0_sqr. lra.
  - assert (T := top_first eps _ _ ltac:(lra) H). assert (0 <= eps * eps) by apply Rle_0_sqr. lra.
Qed.

(** Along an orbit. *)
Section Along.
Variables (eps : R) (u al : nat -> R) (n : nat).
Hypothesis H : sequence eps u al n.
Lemma step_at i : (i < n)%nat -> let th := al i + beta eps (u i) in
  0 < eps <= 1 /\ 0 < u (S i) < u i /\ u i <= PI/2 /\ 0 <= th < PI/2 /\
  cos (u (S i)) - cos (u i) = eps * tan th * (2 * PI - u i - u (S i)) /\
  al i = th - beta eps (u i) /\ al (S i) = th + beta eps (u (S i)) /\ al i < al (S i) /\ al (S i) < PI/2.
Proof.
  intros Hi. destruct (H i Hi) as [A [B1 B2] [C1 C2] D E]. cbv zeta. assert (HPI := PI2_1).
  assert (S1 : 0 < sin (u i)) by (apply sin_gt_0; lra). assert (S2 : 0 < sin (u (S i))) by (apply sin_gt_0; lra).
  assert (Q1 := beta_pos eps _ (proj1 A) S1). assert (Q2 := beta_pos eps _ (proj1 A) S2).
  repeat split; try exact E; lra.
Qed.
Lemma invariant_falls i j : (i <= j <= n)%nat -> invariant (u j) (al j) <= invariant (u i) (al i).
Proof.
  intros [Hij Hj]. induction j as [|j IH]; [replace i with O by lia; lra|].
  destruct (Nat.eq_dec i (S j)) as [->|]; [lra|]. specialize (IH ltac:(lia) ltac:(lia)).
  destruct (step_at j ltac:(lia)) as [A [B [C [D [E [F [G [_ K]]]]]]]].
  assert (L := L44_falls eps (u j) (u (S j)) _ (proj1 A) B C D E ltac:(lra)). rewrite <- F, <- G in L. lra.
Qed.
Lemma contacts_fall i j : (i <= j <= n)%nat -> u j <= u i /\ al i <= al j.
Proof.
  intros [Hij Hj]. induction j as [|j IH]; [replace i with O by lia; lra|].
  destruct (Nat.eq_dec i (S j)) as [->|]; [lra|]. specialize (IH ltac:(lia) ltac:(lia)).
  destruct (step_at j ltac:(lia)) as [A [B [C [D [E [F [G [K _]]]]]]]]. lra.
Qed.
End Along.
