(** L17, L18, the lower bounds: a motion with N collisions whenever (N - 1) gamma < pi. Unfolded it is a straight line
    at the distance 1 from the vertex, (t, 1) at the time t, in the direction atan t from there. It is folded into the
    wedge and made small by the factor lam, so that it collides where the hybrid wedge agrees with the straight one.

    path, path_motion, path_at_least == the motion, with at least N collisions *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Dumbbell Require Import Wedge WedgeFlights PublishedBound WedgeUpper.
Import ListNotations.
Local Open Scope R_scope.

Lemma atan_moves s t : s <= t -> atan s <= atan t <= atan s + (t - s).
Proof.
  intros H. split; [now apply atan_mono|].
  destruct (MVT_gen atan s t (fun x => / (1 + x ^ 2))) as [c [_ E]].
  { intros. apply is_derive_Reals. apply derivable_pt_lim_atan. }
  { intros. apply derivable_continuous_pt, derivable_pt_atan. }
  assert (P := pow2_ge_0 c). assert (L : / (1 + c ^ 2) <= / 1) by (apply Rinv_le_contravar; lra). rewrite Rinv_1 in L.
  assert (/ (1 + c ^ 2) * (t - s) <= 1 * (t - s)) by (apply Rmult_le_compat_r; lra). lra.
Qed.
Lemma NoDup_times (f : nat -> R) n : forall a, (forall i j, (a <= i < j)%nat -> (j < a + n)%nat -> f i <> f j) ->
  NoDup (map f (seq a n)).
Proof.
  induction n as [|n IH]; intros a H; simpl; constructor.
  - rewrite in_map_iff. intros [j [E Hj]]. apply in_seq in Hj. apply (H a j); [lia | lia | now symmetry].
  - apply IH. intros i j Hi Hj. apply H; lia.
Qed.

Section Witness.
Variables (W : wall) (q e lam : R).
Hypothesis Hq : 0 < q.
Hypothesis below_straight : forall x, rise W x <= x - PI/2.
Hypothesis agrees : forall x, x <= PI/2 -> rise W x = x - PI/2 /\ slope W x = 1.
Notation k := (sqrt q).
Notation gam := (gamma q).
Notation g := (gamma q / 2).
Hypothesis He : 0 < e <= gam.
Hypothesis Hlam : 0 < lam.

(** Sector j of the unfolded plane begins at the angle first + j gamma; the first collision is at the angle e - pi/2. *)
Definition first := - PI/2 + e - gam.
Definition middle j := first + INR j * gam + g.
Definition sign (j : nat) := (-1)^j.
(** The line (t, 1) in sector j, folded into the wedge. *)
Definition seg j t := {| psi := lam * (sign j * (t * cos (middle j) - sin (middle j)));
                         yhat := - (PI/2) + lam * ((cos (middle j) + t * sin (middle j)) / k) |}.
Definition seg_v j := {| psi := lam * (sign j * cos (middle j)); yhat := lam * (sin (middle j) / k) |}.

Lemma k_pos : 0 < k. Proof. now apply sqrt_lt_R0. Qed.
Lemma k_square : k * k = q. Proof. apply sqrt_sqrt. lra. Qed.
Lemma half_gamma : 0 < g < PI/2 /\ 0 < sin g /\ cos g = k * sin g.
Proof.
  assert (G := gamma_range q Hq). split; [lra|]. destruct (atan_parts k) as [C E].
  replace g with (PI/2 - atan k) by (unfold gamma; field). rewrite sin_shift, cos_shift. lra.
Qed.
Lemma sign_side j : side (sign j).
Proof.
  unfold sign, side. induction j as [|j [E|E]]; simpl; [now left | right; rewrite E; ring | left; rewrite E; ring].
Qed.
Lemma sign_square j : sign j * sign j = 1. Proof. apply side_square, sign_side. Qed.

(** The angle from the middle of the sector. *)
Lemma seg_polar j t : let u := atan t - middle j in
  psi (seg j t) = lam * (sign j * (sin u / cos (atan t))) /\
  yhat (seg j t) = - (PI/2) + lam * (cos u / cos (atan t) / k).
Proof.
  intros u. destruct (atan_parts t) as [C E]. assert (K := k_pos). unfold u. rewrite sin_minus, cos_minus, <- E. simpl.
  split; field; lra.
Qed.
Lemma seg_line j s t : psi (seg j s) = psi (seg j t) + psi (seg_v j) * (s - t) /\
  yhat (seg j s) = yhat (seg j t) + yhat (seg_v j) * (s - t).
Proof. assert (K := k_pos). simpl. split; field; lra. Qed.

(** In its sector the folded line is above both walls of the straight wedge, and never at the vertex. *)
Lemma seg_above j t s : side s -> Rabs (atan t - middle j) <= g -> s * psi (seg j t) - PI/2 <= yhat (seg j t).
Proof.
  intros Hs Hu. destruct (seg_polar j t) as [-> ->]. set (u := atan t - middle j) in *. apply Rabs_le_between in Hu.
  destruct (atan_parts t) as [C _]. destruct half_gamma as [G [S E]]. assert (K := k_pos).
  assert (X : forall z, - g <= z <= g -> sin z <= cos z / k).
  { intros z Hz. assert (0 <= sin (g - z)) by (apply sin_ge_0; lra). rewrite sin_minus, E in H.
    replace (sin g * cos z - k * sin g * sin z) with (sin g * k * (cos z / k - sin z)) in H by (field; lra).
    apply Rnot_lt_le. intros L. assert (0 < sin g * k * (sin z - cos z / k)); [|lra].
    apply Rmult_lt_0_compat; [now apply Rmult_lt_0_compat | lra]. }
  assert (Y : s * sign j * sin u <= cos u / k).
  { assert (A := X u Hu). assert (B := X (- u) ltac:(lra)). rewrite sin_neg, cos_neg in B.
    destruct Hs as [->| ->], (sign_side j) as [->| ->]; lra. }
  assert (0 < lam / cos (atan t)) by (now apply Rdiv_lt_0_compat).
  assert (lam / cos (atan t) * (s * sign j * sin u) <= lam / cos (atan t) * (cos u / k))
    by (apply Rmult_le_compat_l; lra).
  replace (s * (lam * (sign j * (sin u / cos (atan t))))) with (lam / cos (atan t) * (s * sign j * sin u))
    by (field; lra).
  replace (lam * (cos u / cos (atan t) / k)) with (lam / cos (atan t) * (cos u / k)) by (field; lra). lra.
Qed.
Lemma seg_not_low j t : Rabs (atan t - middle j) <= g -> - (PI/2) < yhat (seg j t).
Proof.
  intros Hu. destruct (seg_polar j t) as [_ ->]. apply Rabs_le_between in Hu. destruct half_gamma as [G _].
  destruct (atan_parts t) as [C _]. assert (K := k_pos).
  assert (0 < cos (atan t - middle j)) by (apply cos_gt_0; lra).
  assert (0 < lam * (cos (atan t - middle j) / cos (atan t) / k)); [|lra].
  apply Rmult_lt_0_compat; [exact Hlam|]. apply Rdiv_lt_0_compat; [|exact K]. now apply Rdiv_lt_0_compat.
Qed.

(** The edge between sectors j and j + 1: there the path is on the wall sign j, and is pushed. *)
Definition edge j := first + INR (S j) * gam.
Lemma edge_middles j : edge j = middle j + g /\ edge j = middle (S j) - g.
Proof. unfold edge, middle. rewrite S_INR. split; field. Qed.
Lemma sign_S j : sign (S j) = - sign j. Proof. unfold sign. simpl. ring. Qed.
Lemma seg_agree j t : atan t = edge j -> seg j t = seg (S j) t.
Proof.
  intros E. destruct (edge_middles j) as [M1 M2]. destruct (seg_polar j t) as [A1 U1], (seg_polar (S j) t) as [A2 U2].
  apply point_eq.
  - rewrite A1, A2, sign_S. replace (atan t - middle j) with g by lra.
    replace (atan t - middle (S j)) with (- g) by lra.
    rewrite sin_neg. unfold Rdiv. ring.
  - rewrite U1, U2. replace (atan t - middle j) with g by lra. replace (atan t - middle (S j)) with (- g) by lra.
    now rewrite cos_neg.
Qed.
Lemma edge_straight j t : atan t = edge j -> yhat (seg j t) = sign j * psi (seg j t) - PI/2.
Proof.
  intros E. destruct (edge_middles j) as [M1 _]. destruct (seg_polar j t) as [-> ->].
  replace (atan t - middle j) with g by lra. destruct half_gamma as [_ [_ ->]]. assert (K := k_pos).
  destruct (atan_parts t) as [C _].
  replace (sign j * (lam * (sign j * (sin g / cos (atan t))))) with
    (sign j * sign j * (lam * (sin g / cos (atan t)))) by ring.
  rewrite sign_square. field. lra.
Qed.
Lemma edge_comes_in j t : atan t = edge j -> yhat (seg_v j) < sign j * psi (seg_v j).
Proof.
  intros E. destruct (edge_middles j) as [M1 _]. simpl. destruct half_gamma as [_ [S EG]]. assert (K := k_pos).
  destruct (atan_parts t) as [C _].
  replace (sign j * (lam * (sign j * cos (middle j)))) with (sign j * sign j * (lam * cos (middle j))) by ring.
  rewrite sign_square, Rmult_1_l. apply Rmult_lt_compat_l; [exact Hlam|].
  apply Rmult_lt_reg_r with (k * sin g); [now apply Rmult_lt_0_compat|].
  replace (sin (middle j) / k * (k * sin g)) with (sin (middle j) * sin g) by (field; lra). rewrite <- EG.
  assert (X : cos (atan t) = cos (middle j) * cos g - sin (middle j) * sin g)
    by (rewrite E, M1; apply cos_plus). lra.
Qed.
Lemma edge_push j t : atan t = edge j -> push q (sign j) (seg_v j) (seg_v (S j)).
Proof.
  intros E. destruct (edge_middles j) as [M1 M2]. destruct half_gamma as [_ [Sg EG]]. assert (K := k_pos).
  assert (Q := k_square). destruct (atan_parts t) as [C _].
  exists (lam * (2 * cos (atan t) * sin g / k)).
  assert (E1 : middle j = atan t - g) by lra. assert (E2 : middle (S j) = atan t + g) by lra. simpl.
  split; [|split; [|split]].
  - apply Rmult_le_pos; [lra|]. apply Rmult_le_pos; [|left; now apply Rinv_0_lt_compat].
    apply Rmult_le_pos; [apply Rmult_le_pos; lra | lra].
  - assert (QK : q / k = k) by (rewrite <- Q at 1; field; lra).
    replace (q * sign j * (lam * (2 * cos (atan t) * sin g / k))) with
      (q / k * (sign j * lam * 2 * cos (atan t) * sin g)) by (field; lra).
    rewrite QK, sign_S, E1, E2, cos_plus, cos_minus, EG. ring.
  - rewrite E1, E2, sin_plus, sin_minus. field. lra.
  - unfold energy. simpl. rewrite sign_S.
    assert (X : forall s m, s * s = 1 -> lam * (s * cos m) * (lam * (s * cos m)) + q *
      (lam * (sin m / k) * (lam * (sin m / k))) = lam * lam).
    { intros s m Hs. replace (lam * (s * cos m) * (lam * (s * cos m)) + q * (lam * (sin m / k) * (lam * (sin m / k))))
        with (lam * lam * (s * s * (cos m * cos m) + q / (k * k) * (sin m * sin m))) by (field; lra).
      rewrite Hs, Q. replace (q / q) with 1 by (field; lra). generalize (sin2_cos2 m). unfold Rsqr. intros P.
      replace (1 * (cos m * cos m) + 1 * (sin m * sin m)) with (sin m * sin m + cos m * cos m) by ring.
      rewrite P. ring. }
    assert (A := sign_square j). rewrite !X; [reflexivity | exact A | lra].
Qed.

(** The path: at each time in the sector of that time. *)
Lemma sector_sign t : 0 <= (atan t - first) / gam.
Proof.
  destruct (atan_bound t). apply Rmult_le_pos; [unfold first; lra|]. left. apply Rinv_0_lt_compat. lra.
Qed.
Definition sector t := proj1_sig (nfloor_ex _ (sector_sign t)).
Definition path t := seg (sector t) t.
Lemma sector_spec t : first + INR (sector t) * gam <= atan t < first + INR (S (sector t)) * gam.
Proof.
  unfold sector. destruct (nfloor_ex _ (sector_sign t)) as [n Hn]. simpl proj1_sig. rewrite S_INR.
  assert (E : atan t - first = (atan t - first) / gam * gam) by (field; lra).
  assert (INR n * gam <= (atan t - first) / gam * gam) by (apply Rmult_le_compat_r; lra).
  assert ((atan t - first) / gam * gam < (INR n + 1) * gam) by (apply Rmult_lt_compat_r; lra). lra.
Qed.
Lemma path_seg j t : first + INR j * gam <= atan t <= first + INR (S j) * gam -> path t = seg j t.
Proof.
  intros H. unfold path. assert (P := sector_spec t). set (n := sector t) in *.
  assert (A : (n < S (S j))%nat).
  { apply INR_lt. apply Rmult_lt_reg_r with gam; [lra|]. rewrite !S_INR in *. lra. }
  assert (B : (j < S n)%nat). { apply INR_lt. apply Rmult_lt_reg_r with gam; [lra|]. lra. }
  assert (D : n = j \/ n = S j) by lia. destruct D as [-> | ->]; [reflexivity|]. symmetry. apply seg_agree. unfold edge.
  lra.
Qed.
Lemma in_sector j t : first + INR j * gam <= atan t <= first + INR (S j) * gam -> Rabs (atan t - middle j) <= g.
Proof. intros H. rewrite S_INR in H. apply Rabs_le. unfold middle. lra. Qed.

Lemma path_after j t : first + INR j * gam <= atan t < first + INR (S j) * gam -> after path t (seg_v j).
Proof.
  intros H. exists (first + INR (S j) * gam - atan t). split; [lra|]. intros s Hs.
  assert (M := atan_moves t s ltac:(lra)). rewrite (path_seg j t), (path_seg j s) by lra. apply seg_line.
Qed.
Lemma path_before j t : first + INR j * gam < atan t <= first + INR (S j) * gam -> before path t (seg_v j).
Proof.
  intros H. exists (atan t - (first + INR j * gam)). split; [lra|]. intros s Hs.
  assert (M := atan_moves s t ltac:(lra)). rewrite (path_seg j t), (path_seg j s) by lra. apply seg_line.
Qed.

(** All edges are met where the walls agree with the straight wedge. *)
Hypothesis small : forall j t, atan t = edge j -> sign j * psi (seg j t) <= PI/2.

Lemma edge_on j t : atan t = edge j -> on W (sign j) (path t) /\ slope_at W (sign j) (path t) = sign j.
Proof.
  intros E. rewrite (path_seg j t) by (unfold edge in E; rewrite S_INR in *; lra). unfold on, slope_at.
  destruct (agrees _ (small j t E)) as [-> ->]. split; [now apply edge_straight | ring].
Qed.
Theorem path_motion : motion W q path.
Proof.
  assert (HS : forall t, exists j, first + INR j * gam <= atan t <= first + INR (S j) * gam).
  { intros t. exists (sector t). assert (P := sector_spec t). lra. }
  assert (Hab : forall s t, side s -> s * psi (path t) - PI/2 <= yhat (path t)).
  { intros s t Hs. destruct (HS t) as [j Hj]. rewrite (path_seg j t Hj).
    apply seg_above; [exact Hs | now apply in_sector]. }
  split.
  - intros s t Hs. unfold above. assert (A := Hab s t Hs). assert (B := below_straight (s * psi (path t))). lra.
  - intros t [O1 O2]. unfold on in *. assert (A1 := Hab 1 t ltac:(now left)).
    assert (A2 := Hab (-1) t ltac:(now right)).
    assert (B1 := below_straight (1 * psi (path t))). assert (B2 := below_straight (-1 * psi (path t))).
    destruct (HS t) as [j Hj]. assert (L := seg_not_low j t (in_sector j t Hj)). rewrite <- (path_seg j t Hj) in L. lra.
  - intros t. assert (P := sector_spec t). set (n := sector t) in *.
    destruct (Rle_lt_or_eq_dec _ _ (proj1 P)) as [L|E].
    + exists (seg_v n), (seg_v n). split; [apply path_before; lra|]. split; [now apply path_after | now left].
    + destruct n as [|j]. { exfalso. simpl INR in E. destruct (atan_bound t). unfold first in E. lra. }
      exists (seg_v j), (seg_v (S j)). split; [apply path_before; rewrite S_INR in *; lra|].
      split; [now apply path_after|]. right. exists (sign j). assert (E' : atan t = edge j) by (unfold edge; lra).
      destruct (edge_on j t E') as [O ->]. split; [apply sign_side|]. split; [exact O | now apply edge_push with t].
Qed.
Lemma edge_collision j : edge j < PI/2 -> collision W path (tan (edge j)).
Proof.
  intros H. assert (E : atan (tan (edge j)) = edge j).
  { apply atan_tan. split; [|exact H]. unfold edge, first. rewrite S_INR. assert (N := pos_INR j).
    assert (0 <= INR j * gam) by (apply Rmult_le_pos; lra). lra. }
  exists (seg_v j). split; [apply path_before; rewrite E; unfold edge; rewrite S_INR; lra|].
  exists (sign j). destruct (edge_on j _ E) as [O ->]. split; [apply sign_side|]. split; [exact O|].
  now apply edge_comes_in with (tan (edge j)).
Qed.
Theorem path_at_least N : e + (INR N - 1) * gam < PI -> at_least W path N.
Proof.
  intros HN. exists (map (fun j => tan (edge j)) (seq 0 N)).
  assert (Hr : forall j, (j < N)%nat -> - (PI/2) < edge j < PI/2).
  { intros j Hj. unfold edge, first. assert (J := pos_INR j). assert (0 <= INR j * gam) by (apply Rmult_le_pos; lra).
    assert (L : INR (S j) <= INR N) by (apply le_INR; lia).
    assert (INR (S j) * gam <= INR N * gam) by (apply Rmult_le_compat_r; lra).
    rewrite S_INR in *. lra. }
  split; [|split].
  - apply NoDup_times. intros i j Hij Hj E. assert (A := Hr i ltac:(lia)). assert (B := Hr j ltac:(lia)).
    assert (T : edge i = edge j) by (rewrite <- (atan_tan (edge i) A), <- (atan_tan (edge j) B); now rewrite E).
    assert (K : INR i < INR j) by (apply lt_INR; lia). unfold edge in T. rewrite !S_INR in T.
    assert (INR i * gam < INR j * gam) by (apply Rmult_lt_compat_r; lra). lra.
  - now rewrite map_length, seq_length.
  - intros t Ht. apply in_map_iff in Ht. destruct Ht as [j [<- Hj]]. apply in_seq in Hj. apply edge_collision, Hr. lia.
Qed.
End Witness.
