(** The checker of leaves with more bits than a double has: the same functor over big integers.
  The guesses begin with those of
    Doubles.v, which Newton's iteration makes better; they are not trusted. *)
From Coq Require Import ZArith List Floats Bool.
From Interval Require Import Float.Basic Float.Sig Float.Primitive_ops Float.Specific_ops Float.Specific_bigint
  Interval.Float.
From Dumbbell Require Import FullLeaves Doubles.
Module BigFloat := SpecificFloat BigIntRadix2.
Module M := FullLeaves BigFloat.
Module I := M.Z.Y.X.I.

Section Guess.
Variable p : BigFloat.precision.

(** Between the two kinds of numbers; a double has the 53 leading bits. *)
Definition to_double (x : BigFloat.type) : PrimFloat.float :=
  match BigFloat.toF x with
  | Basic.Fnan => nan
  | Basic.Fzero => zero
  | Basic.Float s m e =>
    let k := (Z.max 0 (Zpos (Pos.size m) - 53))%Z in
    match Z.shiftr (Zpos m) k with Zpos m => PrimitiveFloat.fromF (Basic.Float s m (e + k)) | _ => zero end
  end.
Definition of_double (x : PrimFloat.float) : BigFloat.type := BigFloat.fromF (PrimitiveFloat.toF x).
Definition low (i : I.type) : BigFloat.type := I.lower i.
Definition one_point (i : I.type) : D.Z.Y.X.I.type := D.Z.Y.X.I.singleton (to_double (low i)).

(** Newton's iteration for f z = 0, from enclosures of f and f', until half of the digits stay; then
  one step more is enough. *)
Definition settled (old new : BigFloat.type) : bool :=
  let step := I.abs (I.sub p (I.singleton new) (I.singleton old)) in
  match I.sign_large (I.sub p (I.abs (I.singleton new)) (I.mul p step (I.power_int p (I.fromZ p 2) (Zpos (BigFloat.prec
    p) / 2 + 4)))) with
  | Xreal.Xgt | Xreal.Xeq => true
  | _ => false
  end.
Fixpoint newton (n : nat) (f f' : I.type -> I.type) (z : BigFloat.type) : BigFloat.type :=
  match n with
  | O => z
  | S m => let i := I.singleton z in let new := I.lower (I.sub p i (I.div p (f i) (f' i))) in
           if settled z new then new else newton m f f' new
  end.
Definition root_from (c k : I.type) (z : BigFloat.type) : BigFloat.type :=
  newton 100 (fun z => I.sub p (I.sub p (I.sin p z) (I.mul p k z)) c) (fun z => I.sub p (I.cos p z) k) z.
Definition near_root (c k : I.type) (z : BigFloat.type) : BigFloat.type :=
  let guess := Doubles.near_root (one_point c) (one_point k) (to_double z) in
  root_from c k (if PrimFloat.eqb guess guess then of_double guess else BigFloat.zero).
Definition tiny : I.type := I.singleton (BigFloat.fromF (Basic.Float false 1 (3 - Zpos (BigFloat.prec p)))).
(** Behind the root by what rounding leaves of the height at [z], and a few units of the last place for what it takes at
    the new place: less may not be certified, and more moves the ray. *)
Definition behind_root (c k : I.type) (z : BigFloat.type) : BigFloat.type :=
  let z := near_root c k z in let i := I.singleton z in let s := I.sin p i in let kz := I.mul p k i in
  let units := I.mul p tiny (I.add p (I.add p s (I.abs kz)) (I.abs c)) in
  let gap := I.abs (I.sub p (I.sub p s kz) c) in
  I.upper (I.add p i (I.div p (I.add p gap units) (I.sub p (I.cos p i) k))).
Definition near_top (k : I.type) : BigFloat.type :=
  let z := of_double (Doubles.near_top (one_point k)) in
  let half_turn := I.div p (I.pi p) (I.fromZ p 2) in
  let z := newton 20 (fun z => I.sub p (I.cos p z) k) (fun z => I.neg (I.sin p z)) z in
  match BigFloat.cmp z (I.lower half_turn) with Xreal.Xlt => z | _ => I.lower half_turn end.
Definition G : M.Z.guesses := {| M.Z.near_root := near_root; M.Z.behind_root := behind_root;
  M.Z.seems_to_hit := fun _ _ z => BigFloat.real z; M.Z.near_top := near_top; M.Z.first_guess := BigFloat.zero;
    M.Z.quick := false |}.
End Guess.

Definition precision (bits : N) : BigFloat.precision := BigFloat.PtoP (match bits with N0 => 53 | Npos b => b end).
Definition check_leaf (bits : N) := let p := precision bits in M.check_leaf p (G p) (M.Z.mkconsts p).
Definition check_contact (bits : N) := let p := precision bits in M.check_contact p (G p) (M.Z.mkconsts p).
Definition above_corner (bits : N) := let p := precision bits in M.above_corner p (G p) (M.Z.mkconsts p).
