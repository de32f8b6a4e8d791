(** The checker of leaves with more bits than a double has: the same functor over big integers.
  The guesses begin with those of
    Doubles.v, and are made better step by step; they are not trusted.

    G, precision                            == the guesses; so many bits
    check_leaf, check_contact, above_corner == a leaf and a witness of a certificate with so many bits
    orbit_at_most, orbit_at_least           == the counts of an orbit with so many bits *)
From Coq Require Import ZArith List Floats Bool.
From Interval Require Import Float.Basic Float.Sig Float.Primitive_ops Float.Specific_ops Float.Specific_bigint
  Interval.Float.
From Dumbbell Require Import TwoOrbits Doubles.
Module BigFloat := SpecificFloat BigIntRadix2.
Module M := TwoOrbits BigFloat.
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

(** A step, which says whether it leads to a root, is repeated until half of the digits stay; then one more, which has been
    done, is enough. *)
Definition settled (old new : BigFloat.type) : bool :=
  let step := I.abs (I.sub p (I.singleton new) (I.singleton old)) in
  match I.sign_large (I.sub p (I.abs (I.singleton new)) (I.mul p step (I.power_int p (I.fromZ p 2) (Zpos (BigFloat.prec
    p) / 2 + 4)))) with
  | Xreal.Xgt | Xreal.Xeq => true
  | _ => false
  end.
Fixpoint repeated (n : nat) (step : I.type -> I.type * bool) (z : BigFloat.type) : BigFloat.type :=
  match n with
  | O => z
  | S m => let i := I.singleton z in let (width, is_root) := step i in let new := I.lower (I.add p i width) in
           if settled z new then if is_root then new else BigFloat.nan else repeated m step new
  end.
(** To the root of the parabola that touches sin z - k z - c, as a ray may graze; to its top if it has none. *)
Definition to_root (c k : I.type) (z : I.type) : I.type * bool :=
  let s := I.sin p z in let q := I.sub p (I.cos p z) k in let gap := I.sub p (I.add p c (I.mul p k z)) s in
  let square := I.sub p (I.sqr p q) (I.mul2 p (I.mul p gap s)) in
  match I.sign_large square with
  | Xreal.Xgt | Xreal.Xeq => (I.div p (I.mul2 p gap) (I.add p q (I.sqrt p square)), true)
  | _ => (I.div p q s, false)
  end.
Definition to_top (k z : I.type) : I.type * bool := (I.div p (I.sub p (I.cos p z) k) (I.sin p z), true).
Definition root_from (c k : I.type) (z : BigFloat.type) : BigFloat.type := repeated 100 (to_root c k) z.
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
  let z := repeated 20 (to_top k) z in
  match BigFloat.cmp z (I.lower half_turn) with Xreal.Xlt => z | _ => I.lower half_turn end.
Definition G : M.Z.guesses := {| M.Z.near_root := near_root; M.Z.behind_root := behind_root;
  M.Z.seems_to_hit := fun _ _ z => BigFloat.real z; M.Z.near_top := near_top; M.Z.first_guess := BigFloat.zero;
    M.Z.quick := false |}.
End Guess.

Definition precision (bits : N) : BigFloat.precision := BigFloat.PtoP (match bits with N0 => 53 | Npos b => b end).
Definition check_leaf (bits : N) := let p := precision bits in M.check_leaf p (G p) (M.Z.mkconsts p).
Definition check_contact (bits : N) := let p := precision bits in M.check_contact p (G p) (M.Z.mkconsts p).
Definition above_corner (bits : N) := let p := precision bits in M.above_corner p (G p) (M.Z.mkconsts p).
Definition orbit_at_most (bits : N) := let p := precision bits in M.orbit_at_most p (G p) (M.Z.mkconsts p).
Definition orbit_at_least (bits : N) := let p := precision bits in M.orbit_at_least p (G p) (M.Z.mkconsts p).
