(** The checker of leaves with the processor's doubles. The guesses are not trusted: nothing is proved, or need be,
  about them.

    G, root                                 == the guesses, by Newton's iteration
    check_leaf, check_contact, above_corner == a leaf and a witness of a certificate in doubles
    orbit_at_most, orbit_at_least           == the counts of an orbit in doubles *)
From Coq Require Import ZArith List Floats Bool.
From Interval Require Import Float.Basic Float.Sig Float.Primitive_ops Interval.Float.
From Dumbbell Require Import TwoOrbits.
Module D := TwoOrbits PrimitiveFloat.
Definition p53 : PrimitiveFloat.precision := PrimitiveFloat.PtoP 53.

Section Guess.
Local Open Scope float_scope.
Definition ks (x : PrimFloat.float) := let z := x*x in let p :=
  (-0x1.5555555555548p-3)+z*(0x1.111111110f75ep-7+z*((-0x1.a01a019bf2621p-13)+z*(0x1.71de355f53fa9p-19+
    z*((-0x1.ae5e54bfd3f7ep-26)+z*0x1.5d8e4fcf8b1f8p-33)))) in x+(x*z)*p.
Definition kc (x : PrimFloat.float) := let z := x*x in let p :=
  0x1.555555555554bp-5+z*((-0x1.6c16c16c1504cp-10)+z*(0x1.a01a019c97a15p-16+z*((-0x1.27e4f7f91218fp-22)+
    z*(0x1.1ee9e17e9ec48p-29+z*(-0x1.8fa9a763a4de1p-37))))) in 1+((-0.5)*z+(z*z)*p).
Definition halfpi := 0x1.921fb54442d18p+0.
Definition gsc (x : PrimFloat.float) := if x <=? 0x1.9p-1 then (ks x, kc x) else let y := halfpi - x in (kc y, ks y).
Definition fl (i : D.Z.Y.X.I.type) : PrimFloat.float := match i with Ibnd l _ => l | _ => nan end.
Fixpoint root (n : nat) (c k z : PrimFloat.float) : PrimFloat.float :=
  match n with O => z | S m =>
    let '(s, w) := gsc z in
    let gap := c + k * z - s in let q := w - k in let sq := q * q - 2 * gap * s in
    if negb (0 <? q) then (if 0 <? z then root m c k 0 else nan) else
    if negb (0 <=? sq) then nan else
    let step := 2 * gap / (q + sqrt sq) in let z' := z + step in
    if negb (z' <? 2) then nan else
    if abs step <=? z' * 0x1p-30 then z' else root m c k z'
  end.
Fixpoint top (n : nat) (k z : PrimFloat.float) : PrimFloat.float :=
  match n with O => z | S m =>
    let '(s, w) := gsc z in let step := (w - k) / s in let z' := z + step in
    if abs step <=? z' * 0x1p-30 then z' else top m k z' end.
Definition clip (z : PrimFloat.float) := if z <? halfpi then (if 0 <=? z then z else 0) else halfpi.
Definition near_root (c k : D.Z.Y.X.I.type) (z : PrimFloat.float) := root 60 (fl c) (fl k) (if z <? 2 then z else 0).
Definition behind_root (c k : D.Z.Y.X.I.type) (z : PrimFloat.float) :=
  let z := near_root c k z in let '(s, w) := gsc z in
  z + ((s + abs (fl k * z) + fl c) * 0x1p-49 + 0x1p-57) / (w - fl k) + z * 0x1p-52.
Definition near_top (k : D.Z.Y.X.I.type) := let k := fl k in clip (top 60 k (sqrt (2 * (1 - k)))).
Definition G : D.Z.guesses := {| D.Z.near_root := near_root; D.Z.behind_root := behind_root;
  D.Z.seems_to_hit := fun _ _ z => z =? z; D.Z.near_top := near_top; D.Z.first_guess := 0; D.Z.quick := true |}.
End Guess.

Definition doubles : D.Z.consts := D.Z.mkconsts p53.
Definition check_leaf := D.check_leaf p53 G doubles.
Definition check_contact := D.check_contact p53 G doubles.
Definition above_corner := D.above_corner p53 G doubles.
Definition orbit_at_most := D.orbit_at_most p53 G doubles.
Definition orbit_at_least := D.orbit_at_least p53 G doubles.
