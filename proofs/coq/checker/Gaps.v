(** Where a certificate leaves open what N(q) is, as far as it is asked about a range of mass ratios
    (proofs/claim.md, "The verdict line"): the stretches between the pieces whose two bounds agree.

    is_gap, is_open, is_exact == the two bounds of a piece differ by one, by more (or it has one only), not at all
    concerns                  == a piece says something of a range that its neighbour does not
    gaps                      == the stretches of a range in which the number is not known; those that touch are one
    divides, stretch          == a piece ends such a stretch; one that is not empty; values: its ends
    narrow                    == a stretch is not too wide
    known_at                  == the number is known at a single ratio *)
From Coq Require Import Reals ZArith NArith Lra List Bool.
From Dumbbell Require Import Signs Certificate.
Import ListNotations.
Local Open Scope R_scope.

Definition is_gap (P : piece) : bool := match bound P with Some (U, _) => (U =? attained P + 1)%N | None => false end.
Definition is_open (P : piece) : bool := match bound P with Some (U, _) => (attained P + 1 <? U)%N | None => true end.
Definition is_exact (P : piece) : bool := match bound P with Some (U, _) => (U =? attained P)%N | None => false end.

(** It has more than an end in common with [a, b], or one of the two is a single ratio. *)
Definition concerns (a b : ratio) (P : piece) : bool :=
  if ratio_le b a || ratio_le (to P) (from P) then ratio_le (from P) b && ratio_le a (to P)
  else negb (ratio_le b (from P)) && negb (ratio_le (to P) a).
Lemma concerns_ok a b P : concerns a b P = true -> ratio_value (from P) <= ratio_value b /\
  ratio_value a <= ratio_value (to P).
Proof.
  unfold concerns. destruct (_ || _).
  - intros H. apply andb_prop in H; destruct H as [H K]. now split; apply ratio_le_ok.
  - destruct (ratio_le b (from P)) eqn:E; [discriminate|]. destruct (ratio_le (to P) a) eqn:F; [discriminate|]. intros _.
    apply ratio_le_not in E, F. lra.
Qed.

(** What is known at a single ratio divides no stretch. The pieces come in increasing order. *)
Definition divides (a b : ratio) (P : piece) : bool := concerns a b P && is_exact P && negb (ratio_le (to P) (from P)).
Definition stretch (x y : ratio) : list (ratio * ratio) := if ratio_le y x then [] else [(x, y)].
Fixpoint gaps (a b : ratio) (l : list piece) : list (ratio * ratio) :=
  match l with
  | [] => stretch a b
  | P :: l => if divides a b P then stretch a (from P) ++ gaps (to P) b l else gaps a b l
  end.
Lemma stretch_in s x y : In s (stretch x y) -> s = (x, y) /\ ratio_value x < ratio_value y.
Proof.
  unfold stretch. destruct (ratio_le y x) eqn:E; [easy|]. intros [<-|[]]. split; [reflexivity | now apply ratio_le_not].
Qed.
Lemma stretch_has x y : ratio_value x < ratio_value y -> In (x, y) (stretch x y).
Proof. unfold stretch. destruct (ratio_le y x) eqn:E; [apply ratio_le_ok in E; lra | now left]. Qed.

(** The stretch [x, y] has a relative width (y - x)/x of at most n/d. *)
Definition narrow (width : N * positive) (s : ratio * ratio) : bool :=
  let '(n, d) := width in let '(x, y) := s in
  (Z.pos (num y * den x * d) <=? Z.pos (num x * den y) * (Z.pos d + Z.of_N n))%Z.
Definition values (s : ratio * ratio) : R * R := (ratio_value (fst s), ratio_value (snd s)).
Lemma narrow_ok n d s : narrow (n, d) s = true -> let '(x, y) := values s in y - x <= IZR (Z.of_N n) / IZR (Zpos d) * x.
Proof.
  destruct s as [[p e] [p' e']]. unfold narrow, values, ratio_value; cbn [fst snd num den]. intros H. apply Z.leb_le, IZR_le in H.
  rewrite !Pos2Z.inj_mul, !mult_IZR, plus_IZR in H. assert (0 < IZR (Zpos d)) by now apply IZR_lt.
  assert (0 < IZR (Zpos e)) by now apply IZR_lt. assert (0 < IZR (Zpos e')) by now apply IZR_lt.
  apply Rmult_le_reg_r with (IZR (Zpos d) * IZR (Zpos e) * IZR (Zpos e')); [repeat apply Rmult_lt_0_compat; assumption|].
  field_simplify; lra.
Qed.

Definition known_at (a : ratio) (l : list piece) : bool :=
  let here := filter (concerns a a) l in
  existsb (fun P => match bound P with Some (U, _) => existsb (fun Q => (U =? attained Q)%N) here | None => false end) here.
