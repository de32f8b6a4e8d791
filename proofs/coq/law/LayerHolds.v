(** (C6) and (C7), the defect in the layer, from its cover (law.md, "What the certificate proves").

    layer_holds == at every step of the layer D is between the bounds of L57 *)
From Coq Require Import Reals ZArith Lra.
From Dumbbell Require Import Quotients LawStatement Falls Ends LayerState LayerBounds LayerTree LayerPart1 LayerPart2
  LayerPart3 LayerPart4
  LayerPart5 LayerPart6 LayerPart7 LayerPart8.
Local Open Scope R_scope.

Lemma whole_layer : holds 0 65536 0 65536.
Proof.
  apply (split_U 32768).
  - apply (split_U 16384).
    + apply (split_U 8192); [exact part1|]. apply (split_rho 32768); [|exact part4].
      apply (split_U 12288); [exact part2 | exact part3].
    + apply (split_U 24576); [exact part5 | exact part6].
  - apply (split_U 49152); [exact part7 | exact part8].
Qed.
Theorem layer_holds eps u al u' al' : step eps u al u' al' -> eps <= 1/1000 ->
  let U := middle u u' in U <= 9/10 -> half u u' <= U / 5 ->
  PI/2 - 1/100 <= middle_invariant eps u al u' <= PI/2 + 1/20 ->
  PI/2 - 5.3 * eps^2 / u^3 <= invariant u al <= PI/2 + eps^2 / 4 ->
  let T := clock eps u al in let y := place eps T in let Delta := difference T in
  comparison eps T * (1 - y * (5 / (3 * PI) + 0.125 * y + 0.45 * Delta^2)) <= defect eps u al u' al' <=
    comparison eps T * (1 - y * (5 / (3 * PI) - 0.155 * y - 0.43 * Delta^2)).
Proof.
  intros HS He U HU Hd HQ HJ. apply whole_layer. split; [exact (conj HS (conj He (conj HU (conj Hd (conj HQ HJ)))))|].
  destruct HS as [_ [B1 B2] _ _ _]. fold U in HU, Hd |- *. set (d := half u u') in *.
  assert (U0 : 0 < U) by (unfold U, middle; lra).
  assert (d0 : 0 < d) by (unfold d, half; lra). split; [split; lra|].
  assert (R : 0 <= d / U <= 1/5) by (split; [apply quotient_at_least | apply quotient_at_most]; lra). split; lra.
Qed.
