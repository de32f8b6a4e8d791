(** The rule of LayerRule.v in two calculi that go together: its results go together.

    sizes_related, nodes_related == what that means for the sizes of a step, and for nodes and weights
    r_G3, r_G4, r_second_G, r_second_H, r_sizes, r_J, r_k, r_below, r_half, r_way, r_mean, r_both, r_first_part,
    r_second_part, r_ratio, r_place, r_second_order, r_node_G, r_node_H == each formula's *)
From Coq Require Import ZArith List.
From Dumbbell Require Import Calculus LayerRule.

Section Related.
Variables A B : calculus.
Variable N : num A -> num B -> Prop.
Variable S : jet_of A -> jet_of B -> Prop.
Hypothesis H : related A B N S.

Ltac one := match goal with
  | |- N (n_Z _ _) _ => apply (r_Z _ _ _ _ H) | |- N (n_pi _) _ => apply (r_pi _ _ _ _ H) | |- N (n_U _) _ =>
    apply (r_U _ _ _ _ H)
  | |- N (n_add _ _ _) _ => apply (r_nadd _ _ _ _ H) | |- N (n_sub _ _ _) _ => apply (r_nsub _ _ _ _ H)
  | |- N (n_mul _ _ _) _ => apply (r_nmul _ _ _ _ H) | |- N (n_div _ _ _) _ => apply (r_ndiv _ _ _ _ H)
  | |- N (n_neg _ _) _ => apply (r_nneg _ _ _ _ H) | |- N (n_sqr _ _) _ => apply (r_nsqr _ _ _ _ H)
  | |- N (n_sqrt _ _) _ => apply (r_nsqrt _ _ _ _ H) | |- N (n_tail_sin _ _) _ => apply (r_tail_sin _ _ _ _ H)
  | |- N (n_tail_cos _ _) _ => apply (r_tail_cos _ _ _ _ H)
  | |- N (s_bend _ _) _ => apply (r_bend _ _ _ _ H) | |- N (s_rise _ _) _ => apply (r_rise _ _ _ _ H)
  | |- N (s_values _ _) _ => apply (r_values _ _ _ _ H)
  | |- S (s_add _ _ _) _ => apply (r_add _ _ _ _ H) | |- S (s_sub _ _ _) _ => apply (r_sub _ _ _ _ H)
  | |- S (s_mul _ _ _) _ => apply (r_mul _ _ _ _ H) | |- S (s_inv _ _) _ => apply (r_inv _ _ _ _ H)
  | |- S (s_neg _ _) _ => apply (r_neg _ _ _ _ H) | |- S (s_sqr _ _) _ => apply (r_sqr _ _ _ _ H)
  | |- S (s_root _ _) _ => apply (r_root _ _ _ _ H) | |- S (s_scale _ _ _) _ => apply (r_scale _ _ _ _ H)
  | |- S (s_shift _ _ _) _ => apply (r_shift _ _ _ _ H) | |- S (s_line _ _ _) _ => apply (r_line _ _ _ _ H)
  | |- S (s_curve _ _ _) _ => apply (r_curve _ _ _ _ H) | |- S (s_tight _ _) _ => apply (r_tight _ _ _ _ H)
  | |- S (s_sinc _ _) _ => unfold s_sinc | |- S (s_cos _ _) _ => unfold s_cos end.
Ltac rel := repeat (assumption || one).
(** A name stands for two things that go together. *)
Ltac name := match goal with
  | |- ?R (let x := ?a in @?f x) (let y := ?b in @?g y) =>
    let K := fresh "K" in let x := fresh "x" in let y := fresh "y" in
    first [assert (K : N a b) by rel | assert (K : S a b) by rel];
    change (R (f a) (g b)); revert K; generalize a b; intros x y K; cbv beta end.
Ltac all := repeat name; rel.

Variables rho : num A.
Variable rho' : num B.
Hypothesis Hrho : N rho rho'.
(* [unfold] would put what is named into its places. *)
Ltac shares := cbv beta delta [plus minus product n_tau n_root s_root_of].

Lemma r_G3 F Q f q : N F f -> N Q q -> N (n_G3 A F Q) (n_G3 B f q).
Proof. intros. cbv beta delta [n_G3]. shares. all. Qed.
Lemma r_G4 F Q f q : N F f -> N Q q -> N (n_G4 A F Q) (n_G4 B f q).
Proof. intros. cbv beta delta [n_G4]. shares. all. Qed.
Lemma r_second x g g1 g2 x' g' g1' g2' : N x x' -> N g g' -> N g1 g1' -> N g2 g2' ->
  N (n_second A x g g1 g2) (n_second B x' g' g1' g2').
Proof. intros. cbv beta delta [n_second]. shares. all. Qed.
Lemma r_second_G x J x' J' : N x x' -> N J J' -> N (n_second_G A x J) (n_second_G B x' J').
Proof. intros. cbv beta delta [n_second_G]. name. apply r_second;
  [assumption | cbv beta delta [n_G] | cbv beta delta [n_G1] | cbv beta delta [n_G2]]; shares; all. Qed.
Lemma r_second_H x J x' J' : N x x' -> N J J' -> N (n_second_H A x J) (n_second_H B x' J').
Proof. intros. cbv beta delta [n_second_H]. name. apply r_second;
  [assumption | cbv beta delta [n_H] | cbv beta delta [n_H1] | cbv beta delta [n_H11]]; shares; all. Qed.

Definition sizes_related (s : sizes A) (s' :
  sizes B) := S (z_sin_U _ s) (z_sin_U _ s') /\ S (z_cos_U _ s) (z_cos_U _ s') /\
  S (z_F _ s) (z_F _ s') /\ S (z_Q _ s) (z_Q _ s') /\ S (z_ehat _ s) (z_ehat _ s') /\ S (z_change _ s) (z_change _ s')
    /\
  S (z_first _ s) (z_first _ s') /\ S (z_last _ s) (z_last _ s') /\ S (z_apart _ s) (z_apart _ s').
Lemma r_sizes Q Q' : S Q Q' -> sizes_related (sizes_of A rho Q) (sizes_of B rho' Q').
Proof. intros. cbv beta delta [sizes_of]. shares. repeat name. cbv beta delta [sizes_related]. cbn. repeat split; rel.
Qed.

Definition nodes_related (l : list (num A * num A)) (l' : list (num B * num B)) :=
  Forall2 (fun x y => N (fst x) (fst y) /\ N (snd x) (snd y)) l l'.
Lemma r_sum f f' l l' : (forall k k', N k k' -> S (f k) (f' k')) -> nodes_related l l' ->
  S (sum_nodes A rho f l) (sum_nodes B rho' f' l').
Proof.
  intros Hf Hl. cbv beta delta [sum_nodes plus]. induction Hl as [|[n w] [n' w'] l l' [K1 K2] Hl IH];
    cbn [fold_right fst snd] in *; rel.
  apply Hf. rel.
Qed.
Lemma r_node_G J J' k k' : S J J' -> N k k' -> S (node_G A J k) (node_G B J' k').
Proof. intros. cbv beta delta [node_G s_G]. shares. rel. Qed.
Lemma r_node_H J J' k k' : S J J' -> N k k' -> S (node_H A J k) (node_H B J' k').
Proof. intros. cbv beta delta [node_H s_H]. rel. all. Qed.
Lemma r_second_order X X' k k' : S X X' -> N k k' -> S (second_order A k X) (second_order B k' X').
Proof. intros. cbv beta delta [second_order s_H2]. rel. all. Qed.

Variable nodes : list (num A * num A).
Variable nodes' : list (num B * num B).
Hypothesis Hnodes : nodes_related nodes nodes'.
Lemma r_J s s' : sizes_related s s' -> S (J_of A rho s) (J_of B rho' s').
Proof. intros (?&?&?&?&?&?&?&?&?). unfold J_of. rel. Qed.
Lemma r_k s s' e e' : sizes_related s s' -> N e e' -> S (k_of A rho nodes s e) (k_of B rho' nodes' s' e').
Proof.
  intros Hs He. assert (HJ := r_J s s' Hs). destruct Hs as (?&?&?&?&?&?&?&?&?). cbv beta delta [k_of]. rel;
    [|cbv beta delta [plus]; rel].
  apply r_sum; [intros; now apply r_node_G | exact Hnodes].
Qed.
Lemma r_below k k' : S k k' -> S (below_of A rho k) (below_of B rho' k').
Proof. intros. cbv beta delta [below_of]. shares. rel. Qed.
Lemma r_half k k' : S k k' -> S (half_of A rho k) (half_of B rho' k').
Proof. intros K. assert (X := r_below k k' K). cbv beta delta [half_of]. shares. rel. Qed.
Lemma r_way Q Q' e e' : S Q Q' -> N e e' -> S (way_of A rho nodes Q e) (way_of B rho' nodes' Q' e').
Proof.
  intros. cbv beta delta [way_of]. rel; [|cbv beta delta [plus]; rel]. apply r_sum; [intros;
    now apply r_node_H | exact Hnodes].
Qed.
Lemma r_mean Q Q' e e' : S Q Q' -> N e e' -> S (mean_of A rho Q e) (mean_of B rho' Q' e').
Proof. intros. cbv beta delta [mean_of]. rel. apply r_node_H; rel. Qed.
Lemma r_both m m' w w' : S m m' -> S w w' -> S (both_of A rho m w) (both_of B rho' m' w').
Proof. intros. cbv beta delta [both_of]. shares. rel. Qed.
Lemma r_first_part s s' a b c a' b' c' : sizes_related s s' -> N a a' -> N b b' -> N c c' ->
  S (first_part A s a b c) (first_part B s' a' b' c').
Proof. intros (?&?&?&?&?&?&?&?&?). intros. cbv beta delta [first_part]. all. Qed.
Lemma r_second_part s s' m b h k m' b' h' k' : sizes_related s s' -> S m m' -> S b b' -> S h h' -> S k k' ->
  S (second_part A rho s m b h k) (second_part B rho' s' m' b' h' k').
Proof. intros (?&?&?&?&?&?&?&?&?). intros. cbv beta delta [second_part]. shares. rel. Qed.
Lemma r_ratio s s' m m' h h' : sizes_related s s' -> S m m' -> S h h' -> S (ratio_of A s m h) (ratio_of B s' m' h').
Proof. intros (?&?&?&?&?&?&?&?&?). intros. cbv beta delta [ratio_of n_k0]. all. Qed.
Lemma r_place s s' h h' : sizes_related s s' -> S h h' -> S (place_of A s h) (place_of B s' h').
Proof. intros (?&?&?&?&?&?&?&?&?). intros. cbv beta delta [place_of]. rel. Qed.
End Related.
