(** Times at which something happens, with a first one after any time: n + 1 after t0 are one, and n after that.

    later_times C t n == there are n times after t at which C holds
    later_times_next  == if there is a first one after any time: one, and n - 1 after it *)
From Coq Require Import Reals Lra Lia List.
Import ListNotations.
Local Open Scope R_scope.

Definition later_times (C : R -> Prop) t0 n :=
  exists l, NoDup l /\ length l = n /\ forall t, In t l -> t0 < t /\ C t.

Lemma later_times_next (C : R -> Prop) t0 n :
  (forall T, t0 < T -> C T -> exists t1, t0 < t1 <= T /\ C t1 /\ forall t, t0 < t < t1 -> ~ C t) ->
  later_times C t0 (S n) ->
  exists t1, t0 < t1 /\ C t1 /\ (forall t, t0 < t < t1 -> ~ C t) /\ later_times C t1 n.
Proof.
  intros First [l [Hnd [Hl Hc]]]. destruct l as [|T l']; [discriminate|].
  destruct (Hc T (or_introl eq_refl)) as [HT HcT]. destruct (First T HT HcT) as [t1 [H1 [H2 H3]]].
  exists t1. split; [lra|]. split; [exact H2|]. split; [exact H3|].
  assert (Hge : forall t, In t (T :: l') -> t1 <= t).
  { intros t Ht. destruct (Rle_or_lt t1 t) as [|K]; [assumption|]. destruct (Hc t Ht). exfalso.
    apply (H3 t); [lra | assumption]. }
  destruct (in_dec Req_EM_T t1 (T :: l')) as [Hin|Hin].
  - apply in_split in Hin. destruct Hin as [a [b E]]. rewrite E in *. exists (a ++ b).
    split; [now apply NoDup_remove_1 in Hnd|]. split. { rewrite app_length in *. simpl in Hl. lia. }
    intros t Ht.
    assert (Ht' : In t (a ++ t1 :: b))
      by (apply in_app_iff in Ht; apply in_app_iff; destruct Ht; [now left | right; now right]).
    split; [|now apply Hc]. assert (t1 <> t) by (intros <-; apply NoDup_remove_2 in Hnd; contradiction).
    specialize (Hge t Ht'). lra.
  - exists l'. inversion Hnd; subst. split; [assumption|]. split; [now injection Hl|].
    intros t Ht. assert (Ht' : In t (T :: l')) by now right. split; [|now apply Hc].
    assert (t1 <> t) by (intros <-; contradiction). specialize (Hge t Ht'). lra.
Qed.
