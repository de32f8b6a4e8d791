(** Sine and cosine faster than the library's: Taylor's polynomial by Horner's rule, in intervals, on [-0.8, 0.8]; Count.v
    doubles the angle up to twice that.

    tab, mktab == the polynomial's coefficients as intervals
    sinT, cosT, sinT_in, cosT_in == sine and cosine of intervals within [-0.8, 0.8]; they enclose *)
From Coq Require Import Reals ZArith Lra List Bool.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Real.Xreal Float.Basic Float.Sig Interval.Interval Interval.Float Interval.Float_full
  Tactic.
From Dumbbell Require Import Enclosure.
Import ListNotations.
Local Open Scope R_scope.

Fixpoint hornerR (cs : list R) (y : R) : R :=
  match cs with nil => 0 | c :: cs' => c - y * hornerR cs' y end.
Definition sinZ : list Z := [1; 6; 120; 5040; 362880; 39916800; 6227020800; 1307674368000; 355687428096000]%Z.
Definition cosZ : list Z := [1; 2; 24; 720; 40320; 3628800; 479001600; 87178291200; 20922789888000; 6402373705728000]%Z.
Definition cR (l : list Z) : list R := map (fun z => / IZR z) l.

Lemma sin_tay x : -0.8 <= x <= 0.8 -> - / IZR (2^60) <= sin x - x * hornerR (cR sinZ) (x*x) <= / IZR (2^60).
Proof. intros H. cbv [cR sinZ map hornerR]. change (2^60)%Z with 1152921504606846976%Z.
  split; interval with (i_taylor x, i_degree 22, i_prec 110). Qed.
Lemma cos_tay x : -0.8 <= x <= 0.8 -> - / IZR (2^60) <= cos x - hornerR (cR cosZ) (x*x) <= / IZR (2^60).
Proof. intros H. cbv [cR cosZ map hornerR]. change (2^60)%Z with 1152921504606846976%Z.
  split; interval with (i_taylor x, i_degree 22, i_prec 110). Qed.

Module Fast (F : FloatOps with Definition sensible_format := true).
Module Import X := Enclosure F.
Section S.
Variable p : F.precision.
Definition co (l : list Z) : list I.type := map (fun z => I.inv p (I.fromZ p z)) l.
Definition err : I.type := let e := I.inv p (I.fromZ p (2^60)) in I.join (I.neg e) e.
Definition dom : I.type := I.div p (I.fromZ p 19) (I.fromZ p 24).
Record tab := { tS : list I.type; tC : list I.type; tE : I.type; tD : I.type }.
Definition mktab : tab := {| tS := co sinZ; tC := co cosZ; tE := err; tD := dom |}.

Fixpoint hornerI (cs : list I.type) (y : I.type) : I.type :=
  match cs with
  | nil => I.zero
  | c :: nil => c
  | c :: cs' => I.sub p c (I.mul p y (hornerI cs' y)) end.
Definition sinT (t : tab) x := I.add p (I.mul p x (hornerI (tS t) (I.sqr p x))) (tE t).
Definition cosT (t : tab) x := I.add p (hornerI (tC t) (I.sqr p x)) (tE t).
Definition indom (t : tab) i := match I.sign_large (I.sub p i (tD t)), I.sign_large (I.add p i (tD t)) with
  | (Xlt|Xeq), (Xgt|Xeq) => true | _, _ => false end.

Lemma coefficient_in z : z <> 0%Z -> inI (/ IZR z) (I.inv p (I.fromZ p z)).
Proof. intros Hz. apply inv_in; [now apply IZR_neq | apply fromZ_in]. Qed.
Lemma pm_in v y e : inI v e -> - v <= y <= v -> inI y (I.join (I.neg e) e).
Proof.
  intros Hv Hy. apply (contains_connected (I.convert (I.join (I.neg e) e)) (-v) v); [| |exact Hy].
  - apply I.join_correct. left. exact (neg_in _ _ Hv).
  - apply I.join_correct. now right.
Qed.
Lemma err_in y : - / IZR (2^60) <= y <= / IZR (2^60) -> inI y err.
Proof. intros H. apply pm_in with (2 := H). now apply coefficient_in. Qed.
Lemma horner_in l y yi : List.Forall (fun z => z <> 0%Z) l -> inI y yi -> inI (hornerR (cR l) y) (hornerI (co l) yi).
Proof.
  intros Hl Hy. induction l as [|z l IH].
  - exact zero_in.
  - inversion Hl; subst. destruct l as [|z' l].
    + simpl. replace (/ IZR z - y * 0) with (/ IZR z) by ring. now apply coefficient_in.
    + change (inI (/ IZR z - y * hornerR (cR (z'::l)) y)
        (I.sub p (I.inv p (I.fromZ p z)) (I.mul p yi (hornerI (co (z'::l)) yi)))).
      apply sub_in; [now apply coefficient_in | apply mul_in; [exact Hy | now apply IH]].
Qed.
Lemma sinT_in x i : -0.8 <= x <= 0.8 -> inI x i -> inI (sin x) (sinT mktab i).
Proof.
  intros Hd Hx. replace (sin x) with (x * hornerR (cR sinZ) (x*x) + (sin x - x * hornerR (cR sinZ) (x*x))) by ring.
  apply add_in. apply mul_in; [exact Hx|]. apply horner_in; [repeat constructor; discriminate | now apply sqr_in].
  now apply err_in, sin_tay.
Qed.
Lemma cosT_in x i : -0.8 <= x <= 0.8 -> inI x i -> inI (cos x) (cosT mktab i).
Proof.
  intros Hd Hx. replace (cos x) with (hornerR (cR cosZ) (x*x) + (cos x - hornerR (cR cosZ) (x*x))) by ring.
  apply add_in. apply horner_in; [repeat constructor; discriminate | now apply sqr_in].
  now apply err_in, cos_tay.
Qed.
Lemma indom_ok i x : indom mktab i = true -> inI x i -> -0.8 <= x <= 0.8.
Proof.
  unfold indom. simpl tD. intros H Hx.
  assert (H34 : inI (19/24) dom) by (apply div_in; exact (I.fromZ_correct p _)).
  generalize (sub_in p _ _ _ _ Hx H34) (add_in p _ _ _ _ Hx H34).
  generalize (I.sign_large_correct (I.sub p i dom)) (I.sign_large_correct (I.add p i dom)).
  unfold inI. 
  destruct (I.sign_large (I.sub p i dom)); destruct (I.sign_large (I.add p i dom)); try discriminate H;
  intros A B C D; specialize (A _ C); specialize (B _ D); simpl in A, B; 
  repeat match goal with H : _ /\ _ |- _ => destruct H | H : Xreal _ = Xreal 0 |- _ => injection H; clear H;
    intro H end; lra.
Qed.
End S.
End Fast.
