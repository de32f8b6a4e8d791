(** A box of floating-point numbers around an exact one, whose mass ratio q becomes r = 1/q.
  How it is found is not trusted: its ends
    are compared with the exact ones, without any rounding.

    V                == a floating-point number's value
    fbox, inside     == such a box; a point (e, y, r) is in it
    round_box, boxed == one that may hold an exact box; that it does *)
From Coq Require Import Reals ZArith NArith Lra Lia List Bool.
From Flocq Require Import Core.Zaux.
From Interval Require Import Real.Xreal Float.Basic Float.Sig.
From Dumbbell Require Import Certificate.
Local Open Scope R_scope.

Module FloatBoxes (F : FloatOps with Definition sensible_format := true).
(** The value of a float. *)
Definition V (f : F.type) : R := proj_val (F.toX f).

Record fbox := { e0 : F.type; e1 : F.type; y0 : F.type; y1 : F.type; r0 : F.type; r1 : F.type }.
Definition inside (b : fbox) (e y r : R) := V (e0 b) <= e <= V (e1 b) /\ V (y0 b) <= y <= V (y1 b) /\
  V (r0 b) <= r <= V (r1 b).

(** A float compared with the fraction n/d, exactly. *)
Definition cmp_frac (f : F.type) (n : Z) (d : positive) : option comparison :=
  match F.toF f with
  | Basic.Fnan => None
  | Basic.Fzero => Some (0 ?= n)%Z
  | Basic.Float s m e => let m := if s then Zneg m else Zpos m in
    Some match e with
    | Z0 => (m * Zpos d ?= n)%Z
    | Zpos k => (m * Z.pow_pos (radix_val F.radix) k * Zpos d ?= n)%Z
    | Zneg k => (m * Zpos d ?= n * Z.pow_pos (radix_val F.radix) k)%Z
    end
  end.
Definition below_frac f n d := match cmp_frac f n d with Some Lt | Some Eq => true | _ => false end.
Definition above_frac f n d := match cmp_frac f n d with Some Gt | Some Eq => true | _ => false end.
Lemma cmp_frac_ok f n d c : cmp_frac f n d = Some c -> match c with Lt => V f < IZR n / IZR (Zpos d) | Eq =>
  V f = IZR n / IZR (Zpos d) | Gt => IZR n / IZR (Zpos d) < V f end.
Proof.
  unfold cmp_frac, V, F.toX. assert (D : 0 < IZR (Zpos d)) by now apply IZR_lt.
  assert (K : forall x a b (w : R), 0 < w -> x * (IZR (Zpos d) * w) = IZR a -> IZR n * w = IZR b ->
    match (a ?= b)%Z with Lt => x < IZR n / IZR (Zpos d) | Eq => x = IZR n / IZR (Zpos d) | Gt =>
      IZR n / IZR (Zpos d) < x end).
  { intros x a b w Hw Ha Hb. assert (W : 0 < IZR (Zpos d) * w) by (now apply Rmult_lt_0_compat).
    assert (E : IZR n / IZR (Zpos d) * (IZR (Zpos d) * w) = IZR b) by (rewrite <- Hb; field; lra).
    destruct (Z.compare_spec a b) as [Q|Q|Q].
    - apply Rmult_eq_reg_r with (IZR (Zpos d) * w); [|lra]. rewrite Ha, E. now f_equal.
    - apply Rmult_lt_reg_r with (IZR (Zpos d) * w); [exact W|]. rewrite Ha, E. now apply IZR_lt.
    - apply Rmult_lt_reg_r with (IZR (Zpos d) * w); [exact W|]. rewrite Ha, E. now apply IZR_lt. }
  assert (P : forall k, 0 < IZR (Z.pow_pos (radix_val F.radix) k)).
  { intros k. apply IZR_lt.  apply Zpower_pos_gt_0. exact (radix_gt_0 F.radix). }
  unfold F.convert. destruct (F.toF f) as [| |s m e]; [discriminate| |]; intros H; injection H; clear H; intros <-;
    simpl.
  - apply (K 0 0%Z n 1); lra.
  - set (sm := if s then Zneg m else Zpos m). unfold FtoR. fold sm. destruct e as [|k|k].
    + apply (K _ _ _ 1); try lra. rewrite mult_IZR. ring.
    + apply (K _ _ _ 1); try lra. rewrite !mult_IZR. ring.
    + apply (K _ _ _ (IZR (Z.pow_pos (radix_val F.radix) k))); [apply P | | now rewrite mult_IZR]. rewrite mult_IZR.
      field. specialize (P k). lra.
Qed.
Lemma below_ok f n d : below_frac f n d = true -> V f <= IZR n / IZR (Zpos d).
Proof. unfold below_frac. destruct (cmp_frac f n d) as [c|] eqn:E; [|discriminate]. apply cmp_frac_ok in E.
  destruct c; try discriminate; lra. Qed.
Lemma above_ok f n d : above_frac f n d = true -> IZR n / IZR (Zpos d) <= V f.
Proof. unfold above_frac. destruct (cmp_frac f n d) as [c|] eqn:E; [|discriminate]. apply cmp_frac_ok in E.
  destruct c; try discriminate; lra. Qed.

Section Rounding.
Variable p : F.precision.
(** The float next to the fraction n/d, n >= 0; not trusted: [boxed] compares. *)
Definition near_frac (up : bool) (n : Z) (d : positive) : F.type :=
  if (n =? 0)%Z then F.zero else
  let s := (Zpos (F.prec p) - 1 - (Z.log2 n - Z.log2 (Zpos d)))%Z in
  let a := if (0 <=? s)%Z then (n * 2 ^ s)%Z else n in
  let b := if (0 <=? s)%Z then Zpos d else (Zpos d * 2 ^ (- s))%Z in
  let m := (if up then - (- a / b) else a / b)%Z in
  match (if (Z.log2 m =? Zpos (F.prec p))%Z then (m / 2, 1 - s)%Z else (m, - s)%Z) with
  | (Zpos m, e) => F.fromF (Basic.Float false m e)
  | _ => F.zero
  end.
Definition round_box (b : box) : fbox :=
  let down s := near_frac false (low_end s) (part s) in let up s := near_frac true (high_end s) (part s) in
  {| e0 := down (box_e b); e1 := up (box_e b); y0 := down (box_slope b); y1 := up (box_slope b);
     r0 := near_frac false (Zpos (part (box_q b))) (Z.to_pos (high_end (box_q b)));
     r1 := near_frac true (Zpos (part (box_q b))) (Z.to_pos (low_end (box_q b))) |}.
(** Does the box of floats contain the exact one, with r = 1/q? *)
Definition boxed (f : fbox) (b : box) : bool :=
  let holds lo hi s := below_frac lo (low_end s) (part s) && above_frac hi (high_end s) (part s) in
  holds (e0 f) (e1 f) (box_e b) && holds (y0 f) (y1 f) (box_slope b) && (0 <? low_end (box_q b))%Z &&
    (0 <? high_end (box_q b))%Z &&
  below_frac (r0 f) (Zpos (part (box_q b))) (Z.to_pos (high_end (box_q b))) && above_frac (r1 f) (Zpos (part (box_q
    b))) (Z.to_pos (low_end (box_q b))).
Lemma boxed_ok f b : boxed f b = true -> forall e y q, in_box e y q b -> inside f e y (/ q).
Proof.
  unfold boxed. intros H e y q [He [Hy Hq]].
  apply andb_prop in H; destruct H as [H H6]. apply andb_prop in H; destruct H as [H H5]. apply andb_prop in H;
    destruct H as [H H4].
  apply andb_prop in H; destruct H as [H H3]. apply andb_prop in H; destruct H as [H1 H2].
  apply andb_prop in H1; destruct H1 as [A1 A2]. apply andb_prop in H2; destruct H2 as [B1 B2].
  apply below_ok in A1, B1, H5. apply above_ok in A2, B2, H6. apply Z.ltb_lt in H3, H4. unfold in_span in *.
  rewrite Z2Pos.id in H5, H6 by assumption. apply IZR_lt in H3, H4.
  assert (D : 0 < IZR (Zpos (part (box_q b)))) by now apply IZR_lt.
  assert (L : 0 < IZR (low_end (box_q b)) / IZR (Zpos (part (box_q b)))) by now apply Rdiv_lt_0_compat.
  unfold inside. split; [lra|]. split; [lra|]. split.
  - apply Rle_trans with (1 := H5). replace (IZR (Zpos (part (box_q b))) / IZR (high_end (box_q b))) with (/ (IZR
    (high_end (box_q b)) / IZR (Zpos (part (box_q b))))) by (field; lra).
    apply Rinv_le_contravar; lra.
  - apply Rle_trans with (2 := H6). replace (IZR (Zpos (part (box_q b))) / IZR (low_end (box_q b))) with (/ (IZR
    (low_end (box_q b)) / IZR (Zpos (part (box_q b))))) by (field; lra).
    apply Rinv_le_contravar; lra.
Qed.
End Rounding.
End FloatBoxes.
