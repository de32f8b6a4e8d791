(** All steps of an orbit lie where the conditions speak (L54 of law.md).

    convex, lost    == three slopes that (C10) gives, and with them what J may lose up to an angle, in eps^2
    growing, area   == a bound of M that grows with the angle, and its integral
    gained, missed  == what (C9) gives up to an angle, from above and from below
    bulk_first      == the steps of the bulk come first, then those of the layer
    L54a_bulk       == J >= pi/2 - 4.13 eps^2 in the bulk, and the sum of its defects
    L54b_layer      == J >= pi/2 - 5.3 eps^2/u^3 at the contacts of the layer
    followed, L54   == what is known of the whole orbit, given the conditions *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Dumbbell Require Import PiValue LawStatement Sines Angles Falls Orbit Clock Ends Windows Place LayerClock
  LayerFalls BulkFalls BulkDefect.
Local Open Scope R_scope.

(** Three slopes, for a bound from above. *)
Definition convex p q r a := p * a + (q - p) * Rmax 0 (a - 0.5985) + (r - q) * Rmax 0 (a - 0.6985).
Lemma convex_step p q r a a' th g : p <= q <= r -> a <= a' -> a' - 0.0026 <= a -> th - 0.0013 <= a ->
  a' <= th + 0.0013 ->
  (th <= 0.6 -> g <= p * (a' - a)) -> (0.6 <= th <= 0.7 -> g <= q * (a' - a)) -> (0.7 <= th -> g <= r * (a' - a)) ->
  g <= convex p q r a' - convex p q r a.
Proof.
  intros H A D B B' H1 H2 H3. unfold convex.
  assert (M : forall k, 0 <= Rmax 0 (a' - k) - Rmax 0 (a - k) <= a' - a /\ (k <= a ->
    Rmax 0 (a' - k) - Rmax 0 (a - k) = a' - a)).
  { intros k. unfold Rmax. destruct (Rle_dec 0 (a' - k)), (Rle_dec 0 (a - k)); lra. }
  destruct (M 0.5985) as [[M1 _] M2]. destruct (M 0.6985) as [[M3 _] M4].
  set (x := Rmax 0 (a' - 0.5985) - Rmax 0 (a - 0.5985)) in *.
  set (z := Rmax 0 (a' - 0.6985) - Rmax 0 (a - 0.6985)) in *.
  assert (X : 0 <= (q - p) * x) by (apply Rmult_le_pos; lra).
  assert (Z : 0 <= (r - q) * z) by (apply Rmult_le_pos; lra).
  destruct (Rle_dec th 0.6) as [T|T]; [specialize (H1 T); unfold x, z in *; lra|].
  assert (E : x = a' - a) by (apply M2; lra). assert (X2 : (q - p) * x = (q - p) * (a' - a)) by now rewrite E.
  destruct (Rle_dec th 0.7) as [T2|T2]; [specialize (H2 ltac:(lra)); unfold x, z in *; lra|].
  assert (E2 : z = a' - a) by (apply M4; lra). assert (Z2 : (r - q) * z = (r - q) * (a' - a)) by now rewrite E2.
  specialize (H3 ltac:(lra)). unfold x, z in *. lra.
Qed.
Lemma convex_range p q r a : 0 <= p <= q -> q <= r -> 0 <= a <= 0.7957 ->
  0 <= convex p q r a <= p * 0.7957 + (q - p) * 0.1972 + (r - q) * 0.0972.
Proof.
  intros Hp Hr Ha. unfold convex.
  assert (M : forall k, k <= 0.7957 -> 0 <= Rmax 0 (a - k) <= 0.7957 - k)
    by (intros k Hk; unfold Rmax; destruct (Rle_dec 0 (a - k)); lra).
  assert (A := M 0.5985 ltac:(lra)). assert (B := M 0.6985 ltac:(lra)).
  assert (0 <= p * a) by (apply Rmult_le_pos; lra). assert (p * a <= p * 0.7957) by (apply Rmult_le_compat_l; lra).
  assert (0 <= (q - p) * Rmax 0 (a - 0.5985)) by (apply Rmult_le_pos; lra).
  assert ((q - p) * Rmax 0 (a - 0.5985) <= (q - p) * 0.1972) by (apply Rmult_le_compat_l; lra).
  assert (0 <= (r - q) * Rmax 0 (a - 0.6985)) by (apply Rmult_le_pos; lra).
  assert ((r - q) * Rmax 0 (a - 0.6985) <= (r - q) * 0.0972) by (apply Rmult_le_compat_l; lra). lra.
Qed.

(** A bound of M that grows; on a step it is that of the angle th, which lies between those of the two contacts. *)
Definition growing e c t := e + 0.94 * t^2 - 1.035 * t^4 + c * t^8.
Definition area e c a := e * a + 0.94 / 3 * a^3 - 1.035 / 5 * a^5 + c / 9 * a^9.
Lemma growing_grows e c a b : 1.357 <= c -> 0 <= a <= b -> b <= 0.8 -> growing e c a <= growing e c b.
Proof.
  intros Hc H Hb. destruct (Req_dec a b) as [->|Z]; [lra|].
  destruct (MVT_cor2 (growing e c) (fun t => t * (1.88 - 4.14 * t^2 + 8 * c * t^6)) a b) as [s [E Hs]]; [lra | |].
  { intros t _. apply is_derive_Reals. unfold growing. auto_derive; [easy | lra]. }
  assert (V : 0 <= 1.88 - 4.14 * s^2 + 8 * 1.357 * s^6).
  { assert (B : 0 <= s <= 0.8) by lra. clear -B. interval with (i_bisect s). }
  assert (W : 1.357 * s^6 <= c * s^6) by (apply Rmult_le_compat_r; [apply pow_le|]; lra).
  assert (0 <= s * (1.88 - 4.14 * s^2 + 8 * c * s^6) * (b - a)) by (repeat apply Rmult_le_pos; lra). lra.
Qed.
Lemma area_step e c a b th : 1.357 <= c -> 0 <= a < b -> b <= 0.8 -> a <= th <= b -> b - a <= 0.0026 ->
  let more := 0.0026 * (growing e c b - growing e c a) in
  area e c b - area e c a - more <= growing e c th * (b - a) <= area e c b - area e c a + more.
Proof.
  intros Hc H Hb Hth Hd more.
  destruct (MVT_cor2 (area e c) (growing e c) a b) as [s [E Hs]]; [lra | |].
  { intros t _. apply is_derive_Reals. unfold area, growing. auto_derive; [easy | lra]. }
  rewrite E. assert (A1 := growing_grows e c a th Hc ltac:(lra) ltac:(lra)).
  assert (A2 := growing_grows e c th b Hc ltac:(lra) Hb). assert (B1 := growing_grows e c a s Hc ltac:(lra)
    ltac:(lra)).
  assert (B2 := growing_grows e c s b Hc ltac:(lra) Hb). set (k := growing e c b - growing e c a) in *.
  assert (K : k * (b - a) <= k * 0.0026) by (apply Rmult_le_compat_l; unfold k; lra).
  assert (X : (growing e c th - growing e c s) * (b - a) <= k * (b - a)) by (apply Rmult_le_compat_r; unfold k; lra).
  assert (Y : (growing e c s - growing e c th) * (b - a) <= k * (b - a)) by (apply Rmult_le_compat_r; unfold k; lra).
  unfold more. lra.
Qed.
(** From above, with rate + width, and from below, with rate - width. *)
Definition gained a := area (- (1/3) + 0.006) 2.857 a + 0.0026 * growing (- (1/3) + 0.006) 2.857 a.
Definition missed a := area (- (1/3) - 0.006) 1.357 a - 0.0026 * growing (- (1/3) - 0.006) 1.357 a.
Lemma end_of_bulk : 0.7021 < cos 0.7923.
Proof. interval. Qed.
Lemma bulk_values a b : 0 <= a <= 0.0013 -> 0.7923 <= b <= 0.7957 ->
  gained b - gained a <= -0.1259 /\ -0.1602 <= missed b - missed a.
Proof.
  intros Ha Hb. assert (A : -0.0013 <= gained a /\ missed a <= 0.0009)
    by (unfold gained, missed, area, growing; split; interval).
  assert (B : gained b <= -0.1272 /\ -0.1593 <= missed b)
    by (unfold gained, missed, area, growing; split; interval with (i_bisect b, i_autodiff b)).
  lra.
Qed.

Section Orbit.
Variables (eps : R) (N n : nat) (u al : nat -> R) (y : R).
Hypothesis He : eps <= 1/1000.
Hypothesis Orb : orbit eps N n u al y.
Hypothesis Hlayer : layer_defect.
Hypothesis Hend : end_of_orbit.
Let J i := invariant (u i) (al i).
Let T i := clock eps (u i) (al i).
Let U i := middle (u i) (u (S i)).

Lemma orbit_sequence : sequence eps u al n.
Proof. apply Orb. Qed.
Lemma orbit_last : last eps (u n) (al n) y.
Proof. apply Orb. Qed.
Lemma eps_pos : 0 < eps <= 1/1000 /\ eps * eps <= 1/1000 * eps /\ 0 < eps * eps.
Proof.
  destruct orbit_last as [A _ _ _ _]. split; [lra|].
  split; [apply Rmult_le_compat_r; lra | apply Rmult_lt_0_compat; lra].
Qed.
Lemma J_below i : (i <= n)%nat -> J i <= PI/2 + eps^2 / 4.
Proof.
  intros Hi. assert (A := invariant_falls eps u al n orbit_sequence 0 i ltac:(lia)).
  assert (B := first_invariant eps N n u al y He Orb).
  destruct eps_pos as [_ [_ P]]. unfold J. simpl. lra.
Qed.
Lemma first_contact : 1.57 <= u O <= PI/2 /\ 0 <= al O <= 0.0013.
Proof.
  destruct eps_pos as [E1 [E2 E3]]. assert (P := pi_value).
  destruct Orb as [_ _ [[_ [-> ->]]|[_ [x [X1 [X2 [-> ->]]]]]]]; [lra|].
  destruct (arcsine x _ X1 X2 ltac:(lra)) as [A B]. assert (Cx := cosine_below x ltac:(lra)).
  assert (x * x <= 0.001 * 0.001) by (apply Rmult_le_compat; lra).
  destruct (beta_above eps (PI/2 - x) ltac:(lra)) as [B1 B2]; [rewrite Rtrigo1.sin_shift; lra|].
  rewrite Rtrigo1.sin_shift in B2.
  assert (eps / cos x <= 0.0013); [|lra]. apply Rmult_le_reg_r with (cos x); [lra|]. unfold Rdiv.
  rewrite Rmult_assoc, Rinv_l; lra.
Qed.
(** L47 (b) at every contact. *)
Lemma contact_beta i : (i <= n)%nat -> eps / sin (u i) <= 0.00717 /\ 5.3 * eps^2 / u i ^ 3 <= 0.00195 /\
  u n <= u i <= PI/2.
Proof.
  intros Hi. destruct (contacts_fall eps u al n orbit_sequence i n ltac:(lia)) as [A _].
  destruct (contacts_fall eps u al n orbit_sequence 0 i ltac:(lia)) as [B _]. destruct first_contact as [C _].
  destruct (L47b_beta eps (u n) (al n) y (u i) He orbit_last (J_below n (le_n n)) ltac:(lra)). lra.
Qed.

(** The steps of the bulk are the first k. *)
Lemma bulk_first : exists k, (k <= n)%nat /\ (forall i, (i < k)%nat -> 9/10 <= U i) /\ (forall i, (k <= i < n)%nat ->
  U i < 9/10).
Proof.
  assert (G : forall m, (m <= n)%nat -> exists k, (k <= m)%nat /\ (forall i, (i < k)%nat ->
    9/10 <= U i) /\ (forall i, (k <= i < m)%nat -> U i < 9/10)).
  { induction m as [|m IH]; intros Hm; [exists O; split; [lia|]; split; intros; lia|].
    destruct (IH ltac:(lia)) as [k [K1 [K2 K3]]]. destruct (Rlt_or_le (U m) (9/10)) as [L|L].
    - exists k. split; [lia|]. split; [exact K2|]. intros i Hi.
      destruct (Nat.eq_dec i m) as [->|]; [exact L | apply K3; lia].
    - exists (S m). split; [lia|]. split; [|intros; lia]. intros i Hi. destruct (Nat.eq_dec i m) as [->|]; [exact L|].
      apply Rle_trans with (1 := L). destruct (contacts_fall eps u al n orbit_sequence i m ltac:(lia)).
      destruct (contacts_fall eps u al n orbit_sequence (S i) (S m) ltac:(lia)). unfold U, middle. lra. }
  exact (G n (le_n n)).
Qed.

(** (a). *)
Definition lost := convex 2.1 6.2 22.7.
Lemma L54a_bulk k : (k <= n)%nat -> (forall i, (i < k)%nat -> 9/10 <= U i) ->
  al k <= 0.7957 /\ PI/2 - eps^2 * lost (al k) <= J k /\
  eps / 2 * (missed (al k) - missed (al O)) <= T O - T k - INR k <= eps / 2 * (gained (al k) - gained (al O)) /\
  ((0 < k)%nat -> 0.897 <= u k).
Proof.
  destruct eps_pos as [E1 [E2 E3]]. assert (P := pi_value). destruct first_contact as [F1 F2].
  assert (E4 : eps^2 = eps * eps) by ring.
  induction k as [|k IH]; intros Hk HU.
  - assert (A := first_invariant eps N n u al y He Orb). fold (J O) in A. simpl INR.
    assert (L := convex_range 2.1 6.2 22.7 (al O) ltac:(lra) ltac:(lra) ltac:(lra)).
    unfold lost. assert (0 <= eps^2 * convex 2.1 6.2 22.7 (al O)) by (apply Rmult_le_pos; lra).
    split; [lra|]. split; [lra|]. split; [lra | intros; lia].
  - destruct (IH ltac:(lia) ltac:(intros i Hi; apply HU; lia)) as [I1 [I2 [I3 _]]].
    destruct (step_at eps u al n orbit_sequence k ltac:(lia)) as [A [B [C [D [E [F [G [K M]]]]]]]].
    assert (A0 : 0 <= al k) by (destruct (contacts_fall eps u al n orbit_sequence 0 k ltac:(lia)); lra).
    set (th := al k + beta eps (u k)) in *.
    assert (L := convex_range 2.1 6.2 22.7 (al k) ltac:(lra) ltac:(lra) ltac:(lra)). fold lost in L.
    assert (L4 : eps^2 * lost (al k) <= eps^2 * 4.13) by (apply Rmult_le_compat_l; lra).
    assert (Jk := J_below k ltac:(lia)). unfold J in I2, Jk.
    assert (W := L53b_bulk eps (u k) (u (S k)) th E1 B C D E (HU k ltac:(lia))). rewrite <- F in W.
    destruct (W ltac:(lra)) as [W1 [W2 [W3 [W4 [W5 W6]]]]]. clear W.
    assert (ST := orbit_sequence k ltac:(lia)).
    assert (H0 := C9 eps (u k) (al k) (u (S k)) (al (S k)) ST He W1).
    destruct (C10 eps (u k) (al k) (u (S k)) (al (S k)) ST He W1) as [H1 [H2 H3]].
    fold th in H0, H1, H2, H3. set (dJ := invariant (u k) (al k) - invariant (u (S k)) (al (S k))) in *.
    set (DD := defect eps (u k) (al k) (u (S k)) (al (S k))) in *. set (da := al (S k) - al k) in *.
    assert (R1 : dJ <= eps^2 * (lost (al (S k)) - lost (al k))).
    { apply Rmult_le_reg_l with (/ eps^2); [apply Rinv_0_lt_compat; lra|].
      rewrite <- Rmult_assoc, Rinv_l, Rmult_1_l by lra.
      assert (Z : forall h, dJ <= h * (eps^2 * da) -> / eps^2 * dJ <= h * da).
      { intros h Hh. apply Rmult_le_reg_l with (eps^2); [lra|]. rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l by lra. lra.
        }
      unfold lost. apply (convex_step 2.1 6.2 22.7 _ _ th); try lra; intros; apply Z;
        [now apply H1 | now apply H2 | now apply H3]. }
    assert (A1 : al (S k) <= 0.7957) by lra.
    assert (L' := convex_range 2.1 6.2 22.7 (al (S k)) ltac:(lra) ltac:(lra) ltac:(lra)). fold lost in L'.
    assert (L4' : eps^2 * lost (al (S k)) <= eps^2 * 4.13) by (apply Rmult_le_compat_l; lra).
    assert (J1 : PI/2 - eps^2 * lost (al (S k)) <= J (S k)) by (unfold J, dJ in *; lra).
    assert (J2 := J_below (S k) Hk).
    assert (N1 : near_half_pi (invariant (u k) (al k))) by (unfold near_half_pi; lra).
    assert (N2 : near_half_pi (invariant (u (S k)) (al (S k)))) by (unfold near_half_pi; unfold J in J1, J2; lra).
    specialize (H0 W3 N1 N2). apply Rabs_le_between in H0.
    assert (Bp := beta_pos eps (u k) (proj1 A) ltac:(apply sin_gt_0; lra)).
    assert (Bp' := beta_pos eps (u (S k)) (proj1 A) ltac:(apply sin_gt_0; lra)).
    assert (Th : al k <= th <= al (S k)) by lra.
    destruct (area_step (- (1/3) + 0.006) 2.857 (al k) (al (S k)) th ltac:(lra) ltac:(lra) ltac:(lra) Th ltac:(lra))
      as [_ Z1].
    destruct (area_step (- (1/3) - 0.006) 1.357 (al k) (al (S k)) th ltac:(lra) ltac:(lra) ltac:(lra) Th ltac:(lra))
      as [Z2 _].
    fold da in Z1, Z2. assert (E0 : 0 <= eps / 2) by lra.
    assert (Y1 := Rmult_le_compat_l _ _ _ E0 Z1). assert (Y2 := Rmult_le_compat_l _ _ _ E0 Z2).
    assert (R2 : DD <= eps / 2 * (gained (al (S k)) - gained (al k))).
    { apply Rle_trans with (eps / 2 * (growing (- (1/3) + 0.006) 2.857 th * da)); [|unfold gained; lra].
      unfold growing. unfold rate, width in H0. lra. }
    assert (R3 : eps / 2 * (missed (al (S k)) - missed (al k)) <= DD).
    { apply Rle_trans with (eps / 2 * (growing (- (1/3) - 0.006) 1.357 th * da)); [unfold missed; lra|].
      unfold growing. unfold rate, width in H0. lra. }
    split; [exact A1|]. split; [exact J1|]. split; [|intros; exact W5]. rewrite S_INR.
    assert (ED : DD = T k - 1 - T (S k)) by reflexivity. lra.
Qed.

(** The bulk is not empty, nor is the layer; the first contact of the layer. *)
Lemma J_safe i : (i <= n)%nat -> PI/2 - 5.3 * eps^2 / u i ^ 3 <= J i -> PI/2 - 0.002 <= J i.
Proof. intros Hi H. destruct (contact_beta i Hi) as [_ [B _]]. lra. Qed.
Lemma first_of_layer k : (k <= n)%nat -> (forall i, (i < k)%nat -> 9/10 <= U i) -> (forall i, (k <= i < n)%nat ->
  U i < 9/10) ->
  (0 < k < n)%nat /\ 0.897 <= u k <= 0.9042.
Proof.
  intros Hk H1 H2. destruct first_contact as [F1 _]. assert (P := pi_value). destruct eps_pos as [E1 [E2 E3]].
  assert (E4 : eps^2 = eps * eps) by ring.
  assert (K0 : (0 < k)%nat).
  { apply Nat.neq_0_lt_0. intros ->. destruct (Nat.eq_dec n 0) as [Z|Z].
    - assert (L := orbit_last). rewrite Z in L. assert (A := first_invariant eps N n u al y He Orb).
      assert (B := L47c_last eps (u O) (al O) y He L ltac:(lra)). lra.
    - destruct (L48_short eps u al n y orbit_sequence orbit_last 0 ltac:(lia)) as [_ B]; [left; apply H2; lia | lra].
      }
  destruct (L54a_bulk k Hk H1) as [A1 [A2 [_ A3]]]. specialize (A3 K0).
  assert (A0 : 0 <= al k) by (destruct (contacts_fall eps u al n orbit_sequence 0 k ltac:(lia));
    destruct first_contact; lra).
  assert (L := convex_range 2.1 6.2 22.7 (al k) ltac:(lra) ltac:(lra) ltac:(lra)). fold lost in L.
  assert (L4 : eps^2 * lost (al k) <= eps^2 * 4.13) by (apply Rmult_le_compat_l; lra). unfold J in A2.
  assert (Kn : (k < n)%nat).
  { destruct (Nat.eq_dec k n) as [Z|]; [|lia]. rewrite Z in A2, A3, L4.
    assert (B := L47c_last eps (u n) (al n) y He orbit_last ltac:(lra)). lra. }
  split; [lia|]. split; [exact A3|].
  destruct (step_at eps u al n orbit_sequence k Kn) as [A [B [C [D [E [F [G [K M]]]]]]]].
  destruct (L48_short eps u al n y orbit_sequence orbit_last k Kn ltac:(left; apply H2; lia)) as [B1 _].
  assert (HU := H2 k ltac:(lia)). unfold U in HU.
  apply (last_half_step eps (u k) (u (S k)) _ E1 B C D E A3 B1 ltac:(lra)). rewrite <- F. lra.
Qed.

(** (b). *)
Lemma inverse_cubes V h : 0 < h < V -> 6 * h / V ^ 4 <= / (V - h) ^ 3 - / (V + h) ^ 3.
Proof.
  intros H. assert (P1 : 0 < (V - h) ^ 3) by (apply pow_lt; lra).
  assert (P2 : 0 < (V + h) ^ 3) by (apply pow_lt; lra).
  assert (E : / (V - h) ^ 3 - / (V + h) ^ 3 = (6 * V ^ 2 * h + 2 * h ^ 3) / ((V - h) ^ 3 * (V + h) ^ 3))
    by (field; lra).
  assert (V6 : (V - h) ^ 3 * (V + h) ^ 3 <= V ^ 6).
  { rewrite <- Rpow_mult_distr. replace (V ^ 6) with ((V ^ 2) ^ 3) by ring. apply pow_incr.
    split; [apply Rmult_le_pos; lra|].
    assert (0 <= h * h) by apply Rle_0_sqr. simpl. lra. }
  assert (V0 : 0 < V ^ 6) by (apply pow_lt; lra). assert (h3 : 0 < h ^ 3) by (apply pow_lt; lra). rewrite E.
  replace (6 * h / V ^ 4) with (6 * V ^ 2 * h / V ^ 6) by (field; lra).
  apply Rmult_le_compat; [|left; now apply Rinv_0_lt_compat|lra|].
  - apply Rmult_le_pos; [apply Rmult_le_pos; [lra | apply pow2_ge_0] | lra].
  - apply Rinv_le_contravar; [now apply Rmult_lt_0_compat | exact V6].
Qed.
Lemma layer_step i : (i < n)%nat -> U i < 9/10 -> PI/2 - 5.3 * eps^2 / u i ^ 3 <= J i ->
  let y := place eps (T i) in let d := difference (T i) in
  1 < T i /\ comparison eps (T i) * (1 - y * (5 / (3 * PI) + 0.125 * y + 0.45 * d^2)) <= T i - 1 - T (S i) <=
    comparison eps (T i) * (1 - y * (5 / (3 * PI) - 0.155 * y - 0.43 * d^2)) /\
  PI/2 - 5.3 * eps^2 / u (S i) ^ 3 <= J (S i).
Proof.
  intros Hi HU HJ. destruct eps_pos as [E1 [E2 E3]]. assert (E4 : eps^2 = eps * eps) by ring.
  destruct (step_at eps u al n orbit_sequence i Hi) as [A [B [C [D [E [F [G [K M]]]]]]]].
  destruct (L48_short eps u al n y orbit_sequence orbit_last i Hi ltac:(left; exact HU)) as [B1 _].
  destruct (contact_beta i ltac:(lia)) as [B2 [B3 _]]. assert (Jb := J_below i ltac:(lia)).
  assert (Js := J_safe i ltac:(lia) HJ).
  unfold U in HU. unfold J in HJ, Jb, Js.
  assert (W := L53a_layer eps (u i) (u (S i)) _ E1 B C D E ltac:(lra) B1 B2). rewrite <- F in W.
  assert (ST := orbit_sequence i Hi). specialize (W ltac:(lra)). assert (HW := conj HJ Jb).
  assert (V := C5 eps (u i) (al i) (u (S i)) (al (S i)) ST He ltac:(lra) B1 W HW).
  assert (V6 := Hlayer eps (u i) (al i) (u (S i)) (al (S i)) ST He ltac:(lra) B1 W HW).
  assert (V8 := C8 eps (u i) (al i) (u (S i)) (al (S i)) ST ltac:(lra) B1 W).
  split; [exact V|]. split; [exact V6|]. unfold J.
  assert (I := inverse_cubes (middle (u i) (u (S i))) (half (u i) (u (S i))) ltac:(unfold middle, half; lra)).
  replace (middle (u i) (u (S i)) - half (u i) (u (S i))) with (u (S i)) in I by (unfold middle, half; field).
  replace (middle (u i) (u (S i)) + half (u i) (u (S i))) with (u i) in I by (unfold middle, half; field).
  assert (I2 := Rmult_le_compat_l (5.3 * eps^2) _ _ ltac:(lra) I). unfold Rdiv in *. lra.
Qed.
Lemma L54b_layer k : (k <= n)%nat -> (forall i, (i < k)%nat -> 9/10 <= U i) -> (forall i, (k <= i < n)%nat ->
  U i < 9/10) ->
  forall j, (k <= j <= n)%nat -> PI/2 - 5.3 * eps^2 / u j ^ 3 <= J j.
Proof.
  intros Hk H1 H2. destruct (first_of_layer k Hk H1 H2) as [K0 [U1 U2]]. destruct eps_pos as [E1 [E2 E3]].
  assert (E4 : eps^2 = eps * eps) by ring.
  induction j as [|j IH]; intros Hj; [lia|].
  destruct (Nat.eq_dec k (S j)) as [Z|Z]; [|apply layer_step; [lia | apply H2; lia | apply IH; lia]].
  rewrite <- Z. destruct (L54a_bulk k Hk H1) as [A1 [A2 _]].
  assert (A0 : 0 <= al k) by (destruct (contacts_fall eps u al n orbit_sequence 0 k ltac:(lia));
    destruct first_contact; lra).
  assert (L := convex_range 2.1 6.2 22.7 (al k) ltac:(lra) ltac:(lra) ltac:(lra)). fold lost in L.
  assert (L4 : eps^2 * lost (al k) <= eps^2 * 4.13) by (apply Rmult_le_compat_l; lra).
  assert (P3 : 0 < u k ^ 3) by (apply pow_lt; lra). assert (Q3 : u k ^ 3 <= 0.91 ^ 3) by (apply pow_incr; lra).
  assert (X : eps^2 * 4.13 <= 5.3 * eps^2 / u k ^ 3).
  { apply Rmult_le_reg_r with (u k ^ 3); [exact P3|].
    replace (5.3 * eps^2 / u k ^ 3 * u k ^ 3) with (5.3 * eps^2) by (field; lra).
    assert (eps^2 * 4.13 * u k ^ 3 <= eps^2 * 4.13 * 0.91 ^ 3) by (apply Rmult_le_compat_l; lra). lra. }
  lra.
Qed.

(** What is known of the whole orbit. *)
Record followed (k : nat) : Prop := {
  followed_k : (0 < k < n)%nat;
  followed_bulk : -0.0801 * eps <= T O - T k - INR k <= -0.0629 * eps;
  followed_clock : 0.0595 / eps <= T k <= 0.06125 / eps;
  followed_layer : forall i, (k <= i < n)%nat -> let D := T i - 1 - T (S i) in let d := difference (T i) in
    let z := step_constant * sqrt eps in let h := scale eps in let g := 5 / (3 * PI) in 0 < D <= z * d^3 /\
    z * (d^3 - h * (g * d^2 + 0.125 * h * d + 0.45 * d^4)) <= D /\
    D <= z * (d^3 - h * (g * d^2 - 0.155 * h * d - 0.43 * d^4));
  followed_end : u n <= 4.6724 * sqrt (eps * T n) /\ u n <= 0.18 /\
    Rabs (T n - 1 - step_constant * sqrt eps + 0.1657 * eps) <= (0.003 + 0.5 * (u n / 2)) * eps }.
Theorem L54 : exists k, followed k.
Proof.
  destruct bulk_first as [k [Hk [H1 H2]]]. exists k. destruct (first_of_layer k Hk H1 H2) as [K0 [U1 U2]].
  destruct eps_pos as [E1 [E2 E3]]. assert (P := pi_value). assert (E4 : eps^2 = eps * eps) by ring.
  assert (HJ := L54b_layer k Hk H1 H2).
  (* the clock in its other form *)
  assert (C : forall i, (k <= i <= n)%nat ->
    0 < u i <= 0.9042 /\ PI/2 - 0.002 <= J i < PI - u i /\ tau (u i) (J i) = 2 * (eps * T i)).
  { intros i Hi. assert (Js := J_safe i ltac:(lia) (HJ i Hi)).
    destruct (contacts_fall eps u al n orbit_sequence k i ltac:(lia)) as [V1 _].
    destruct orbit_last as [_ [V2 _] _ _ _]. destruct (contact_beta i ltac:(lia)) as [_ [_ V3]].
    destruct i as [|i]; [lia|]. destruct (step_at eps u al n orbit_sequence i ltac:(lia)) as [A [B [_ [D [_ [_ [G [_
      M]]]]]]]].
    assert (Bp := beta_pos eps (u (S i)) (proj1 A) ltac:(apply sin_gt_0; lra)). assert (Ap : 0 < al (S i)) by lra.
    assert (Jl : J (S i) < PI - u (S i)).
    { unfold J, invariant. assert (cos (al (S i)) < 1) by (rewrite <- cos_0; apply cos_decreasing_1; lra).
      assert ((PI - u (S i)) * cos (al (S i)) < (PI - u (S i)) * 1) by (apply Rmult_lt_compat_l; lra). lra. }
    split; [lra|]. split; [lra|]. unfold J, T, clock. rewrite L45a_clock by lra. field. lra. }
  assert (latest : forall i, (k <= i <= n)%nat -> T i <= 0.06125 / eps).
  { intros i Hi. destruct (C i Hi) as [C1 [C2 C3]]. assert (Jb := J_below i ltac:(lia)).
    assert (D1 := L45d_above (u i) (J i) ltac:(lra) ltac:(lra)).
    apply Rmult_le_reg_r with eps; [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra. }
  constructor.
  - exact K0.
  - destruct (L54a_bulk k Hk H1) as [A1 [_ [A3 _]]]. destruct first_contact as [_ F0].
    assert (Jb := J_below k Hk).
    assert (A0 : 0.7923 <= al k).
    { apply Rnot_lt_le. intros Z. destruct (contacts_fall eps u al n orbit_sequence 0 k ltac:(lia)) as [_ A2].
      assert (V := end_of_bulk). assert (cos 0.7923 <= cos (al k)) by (apply cos_decr_1; lra).
      assert ((PI - 0.9042) * 0.7021 <= (PI - u k) * cos (al k)) by (apply Rmult_le_compat; lra).
      unfold J, invariant in Jb. lra. }
    destruct (bulk_values (al O) (al k) F0 ltac:(lra)) as [V1 V2].
    assert (eps / 2 * (gained (al k) - gained (al O)) <= eps / 2 * -0.1259) by (apply Rmult_le_compat_l; lra).
    assert (eps / 2 * -0.1602 <= eps / 2 * (missed (al k) - missed (al O))) by (apply Rmult_le_compat_l; lra). lra.
  - destruct (C k ltac:(lia)) as [C1 [C2 C3]]. assert (L := latest k ltac:(lia)).
    assert (D2 := L45d_below (u k) (J k) ltac:(lra) C2).
    split; [|exact L]. apply Rmult_le_reg_r with eps; [lra|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra.
  - intros i Hi. destruct (layer_step i ltac:(lia) (H2 i Hi) (HJ i ltac:(lia))) as [L1 [[L2 L3] _]].
    assert (L := latest i ltac:(lia)). exact (layer_powers eps (T i) _ E1 (conj L1 L) L2 L3).
  - assert (Jn := HJ n ltac:(lia)). assert (Js := J_safe n ltac:(lia) Jn). assert (Jb := J_below n ltac:(lia)).
    assert (L := L47c_last eps (u n) (al n) y He orbit_last Js). destruct (contact_beta n ltac:(lia)) as [B1 _].
    assert (V := L47a_last eps (u n) (al n) y He orbit_last Jb). destruct (small_root eps E1) as [S0 S1].
    assert (V2 : 19.5 * eps <= u n * u n).
    { rewrite <- S1. assert (4.42 * sqrt eps * (4.42 * sqrt eps) <= u n * u n) by (apply Rmult_le_compat; lra).
      assert (0 < sqrt eps * sqrt eps) by (apply Rmult_lt_0_compat; lra). lra. }
    assert (W := L53c_end eps (u n) (al n) y He orbit_last L V2 B1 (conj Jn Jb)).
    destruct (C n ltac:(lia)) as [C1 [C2 C3]]. split; [apply (L45c_u (u n) (J n)); [lra | exact C2 | exact C3]|].
    split; [exact L|]. exact (Hend eps (u n) (al n) y orbit_last He L W (conj Jn Jb)).
Qed.
End Orbit.
