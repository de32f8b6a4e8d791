(** The rule of a leaf of the layer (src/verify/wings/law/layer.cpp and kernel.hpp, L49, L50 and L57 of law.md), for
    any calculus: with jets it is exact, with slopes it encloses. The numbers e1, ..., called rests, are what is left
    of integrals.

    n_tau                          == (sin x - x cos x)/x^3
    n_root, n_G, n_G1, ..., n_G4, n_H, n_H1, n_H11 == kernels and their derivatives by F, of numbers
    n_second, n_second_G, n_second_H == the second derivative of sinc x g(pi - x)
    s_G, s_H, s_H2                 == kernels of jets
    sizes, sizes_of                == U, d, F, Q, eps^, (1 - rho^2) a, a_A, a_p, and (a_p + (1 + rho) a/2)/U
    node_G, node_H, sum_nodes      == sinc g at a node; the sum over the nodes of the way from 0 to u
    k_of, half_of                  == 2 k1/eps^ and B/(2 eps^)^(1/2)
    way_of, mean_of, both_of       == g1, mu, (mu - 2 (1 + rho) g1)/(1 - rho)
    ratio_of                       == Rr
    place_of                       == y/U
    n_excess                       == what (1 - Rr)/y - 5/(3 pi) is: rho times the first and U times the second
    second_order                   == sinc H2 on a part of the way *)
From Coq Require Import ZArith List.
From Dumbbell Require Import Calculus.
Import ListNotations.

Section Formulas.
Variable C : calculus.
Notation num := (num C).
Notation jet := (jet_of C).
Notation "a + b" := (n_add C a b) : num_scope.
Notation "a - b" := (n_sub C a b) : num_scope.
Notation "a * b" := (n_mul C a b) : num_scope.
Notation "a / b" := (n_div C a b) : num_scope.
Notation "- a" := (n_neg C a) : num_scope.
Notation "a + b" := (s_add C a b) : jet_scope.
Notation "a - b" := (s_sub C a b) : jet_scope.
Notation "a * b" := (s_mul C a b) : jet_scope.
Notation "- a" := (s_neg C a) : jet_scope.
Delimit Scope num_scope with n.
Delimit Scope jet_scope with j.
Notation "# z" := (n_Z C z) (at level 0, z at level 0).
Notation sq := (n_sqr C).
Notation pi := (n_pi C).
Notation line := (s_line C).
Notation curve := (s_curve C).
Notation inv := (s_inv C).
Notation root := (s_root C).
Notation scale := (s_scale C).
Notation shift := (s_shift C).
Notation sqr := (s_sqr C).
Notation sinc := (s_sinc C).
Notation U := (n_U C).

(** Of numbers. *)
Definition n_tau x := (n_tail_cos C x / #2 - n_tail_sin C x / #6)%n.
Definition n_root (F Q : num) := n_sqrt C (sq F - sq Q)%n.
Definition n_G F Q := (Q / (F * n_root F Q))%n.
Definition n_G1 F Q := let r := n_root F Q in (- (Q * (#1 / (sq F * r) + #1 / (r * sq r))))%n.
Definition n_G2 F Q := let r := n_root F Q in let r2 := sq r in let r3 := (r * r2)%n in
  (Q * (#2 / (F * sq F * r) + #1 / (F * r3) + #3 * F / (r3 * r2)))%n.
Definition n_G3 F Q := let r := n_root F Q in let r2 := sq r in let r3 := (r * r2)%n in let F2 := sq F in
  (- (Q * (#6 / (sq F2 * r) + #3 / (F2 * r3) + #15 * F2 / (r3 * sq r2))))%n.
Definition n_G4 F Q := let r := n_root F Q in let r2 := sq r in let r3 := (r * r2)%n in let r7 := (r3 * sq r2)%n in
  let F2 := sq F in let F3 := (F * F2)%n in
  (Q * (#24 / (F2 * F3 * r) + #12 / (F3 * r3) + #9 / (F * (r3 * r2)) - #30 * F / r7 + #105 * F3 / (r7 * r2)))%n.
Definition n_H F Q := let r := n_root F Q in (F / (r * sq r))%n.
Definition n_H1 F Q := let r := n_root F Q in let r2 := sq r in let r3 := (r * r2)%n in
  (#1 / r3 - #3 * sq F / (r3 * r2))%n.
Definition n_H11 F Q := let r := n_root F Q in let r2 := sq r in let r5 := (r * sq r2)%n in
  (#15 * (F * sq F) / (r5 * r2) - #9 * F / r5)%n.
Definition n_second x g g1 g2 := let s := n_tail_sin C x in let c := n_tail_cos C x in
  let wave := (#1 - sq x / #6 * s)%n in
  ((c - s / #3 - wave) * g + #2 * (x * n_tau x) * g1 + wave * g2)%n.
Definition n_second_G x J := let F := (pi - x)%n in n_second x (n_G F J) (n_G1 F J) (n_G2 F J).
Definition n_second_H x Q := let F := (pi - x)%n in n_second x (n_H F Q) (n_H1 F Q) (n_H11 F Q).

(** Of jets. *)
Definition s_root_of F Q := root (sqr F - sqr Q)%j.
Definition s_G F Q := (Q * inv (F * s_root_of F Q))%j.
Definition s_H F Q := let R := (sqr F - sqr Q)%j in (F * inv (R * root R))%j.
Definition s_H2 F Q := let R := (sqr F - sqr Q)%j in (scale (F * Q) #3 * inv (sqr R * root R))%j.

Variable rho : num.
Definition plus := (#1 + rho)%n.
Definition minus := (#1 - rho)%n.
Definition product := (#1 - sq rho)%n.

Record sizes := { z_sin_U : jet; z_cos_U : jet; z_F : jet; z_Q : jet; z_ehat : jet; z_change : jet; z_first : jet;
  z_last : jet; z_apart : jet }.
Definition sizes_of (Q : jet) : sizes :=
  let u := line #0 #1 in let d := line #0 rho in
  let wave_d := sinc rho in let wave_U := sinc #1 in let wave_u := sinc plus in let wave_u' := sinc minus in
  let cos_U := s_cos C #1 in let sin_U := (u * wave_U)%j in let F := line pi (#(-1)) in
  let cosine := (Q * inv F)%j in let sine := root (shift (- sqr cosine)%j #1) in
  let ehat := (wave_d * wave_U * cosine * inv (sine * F))%j in
  let b := (ehat * inv (scale wave_u plus))%j in let b' := (ehat * inv (scale wave_u' minus))%j in
  let c := inv (root (shift (sqr (d * b)%j) #1)) in let c' := inv (root (shift (sqr (d * b')%j) #1)) in
  let waves := scale (wave_u * wave_u')%j product in
  let doubles := scale (ehat * (wave_U * cos_U) * (wave_d * s_cos C rho))%j #4 in
  let kc := (sqr (c * c') * inv (c + c') * doubles * ehat * inv (sqr waves))%j in
  let ks := (doubles * c * c' * inv (waves * (scale (wave_u * inv c) plus + scale (wave_u' * inv c') minus)))%j in
  let ratio := sqr (wave_d * inv wave_U)%j in let rU := (rho * U)%n in
  let lost := curve #0 (#2 / #3 * n_tail_sin C (#2 * rU))%n in
  let fall := ((ratio - lost) * inv (shift (- scale (shift ratio #(-1)) (sq rho / product)%n) #1))%j in
  let fall' := ((cos_U * wave_d + curve #0 (rho * s_values C wave_U * n_tau rU)%n) * inv wave_u')%j in
  let more := (Q * kc + sine * ks - scale (cosine * fall' * d * kc) (rho / minus)%n)%j in
  let kick := (Q * sqr (b' * c') * inv (shift c' #1) + sine * b' * c')%j in
  let cf := (c * fall)%j in let cf' := (c' * fall')%j in
  let change := (scale (cosine * cf) #2 + scale (u * more) product)%j in
  let last := (- scale (cosine * cf') (#1 / minus)%n - u * kick)%j in
  {| z_sin_U := sin_U; z_cos_U := cos_U; z_F := F; z_Q := Q; z_ehat := ehat; z_change := change;
     z_first := (last + scale change (rho / product)%n)%j; z_last := last;
     z_apart := (cosine * line #0 ((s_bend C cf - s_bend C cf') / minus)%n + scale more (plus / #2)%n - kick)%j |}.

(** sinc (k U) g(pi - k U, Q) at a node; nodes and weights are of t in [0, 1]. *)
Definition node_G J k := (sinc k * s_G (line pi (- k)%n) J)%j.
Definition node_H Q k := (sinc k * s_H (line pi (- k)%n) Q)%j.
Definition sum_nodes (f : num -> jet) (nodes : list (num * num)) : jet :=
  fold_right (fun '(n, w) s => (scale (f (plus * n)%n) w + s)%j) (line #0 #0) nodes.
Variable nodes : list (num * num).

Definition J_of (s : sizes) := (z_Q s + line #0 (sq rho) * z_first s)%j.
Definition k_of (s : sizes) (rest : num) :=
  scale ((sum_nodes (node_G (J_of s)) nodes + curve #0 (sq plus * rest)%n) * inv (z_ehat s))%j #2.
Definition below_of (k : jet) := shift (scale (shift k #(-1)) (sq (plus / minus)%n)) #1.
Definition half_of (k :
  jet) := shift (scale (scale (shift (root k) #(-1)) plus + scale (shift (root (below_of k)) #(-1)) minus)%j
  (#1 / #2)%n) #1.
Definition way_of Q (rest : num) := (sum_nodes (node_H Q) nodes + curve #0 (sq plus * rest)%n)%j.
Definition mean_of Q (rest : num) := (scale (node_H Q (#1 + sq rho / #3)%n) #2 + curve #0 rest)%j.
Definition both_of (mean way : jet) := scale (mean - scale way (plus * #2)%n)%j (#1 / minus)%n.

(** m of L49: e2, e1, e0 are the rests of the moments and of E1; h, h' the second derivatives of tau by J, over u^2.
*)
Definition first_part (s : sizes) e2 e1 e0 : jet :=
  let F := z_F s in let Q := z_Q s in let R := (sqr F - sqr Q)%j in let r1 := inv (root R) in let f := inv F in
  let r2 := inv R in let r3 := (r1 * r2)%j in let r5 := (r3 * r2)%j in
  let G1 := (- (Q * (sqr f * r1 + r3)))%j in
  let G2 := (Q * (scale (f * sqr f * r1) #2 + f * r3 + scale (F * r5) #3))%j in
  (z_sin_U s * (G2 * curve (#1 / #3)%n e2) - scale (z_cos_U s * (G1 * curve (#1 / #3)%n e1)) #2 + curve #0 e0)%j.
Definition second_part (s : sizes) (mean both h h' : jet) : jet :=
  (line #0 #1 * s_tight C mean * s_tight C (z_apart s) - scale (s_tight C (z_change s) * s_tight C both) (#1 / #2)%n
   + line #0 rho * scale (scale (sqr (z_first s) * h) (sq plus) - scale (sqr (z_last s) * h') (sq minus)) (#1 /
     #2)%n)%j.
Definition n_k0 := (#1 / (#3 * n_sqrt C #3 * n_sqrt C (n_sqrt C #3) * n_sqrt C pi))%n.
Definition ratio_of (s : sizes) (m half : jet) := let h := s_tight C half in
  scale (s_tight C m * (h * sqr h) * inv (z_ehat s * root (z_ehat s)))%j (#1 / (#2 * n_k0))%n.
Definition place_of (s : sizes) (half : jet) := (half * root (scale (z_ehat s) (n_sqrt C #3 * pi)%n))%j.
(** By L57 Rr = 1 - U (gamma + rho^2 turn) + U^2 bend, y = U v, v = 1 + U rise; Delta^2 = rho/half^2. *)
Definition n_excess (q bend rise v : num) : num * num :=
  let turn := ((#12 * q - #1 / (#1 - rho)) / (#3 * pi))%n in let gamma := (#5 / (#3 * pi))%n in
  ((rho * turn / v)%n, (- (bend + gamma * rise) / v)%n).
Definition second_order (k : num) (X : jet) := (sinc k * s_H2 (line pi (- k)%n) X)%j.
End Formulas.
