(** The checker as an OCaml program. The constants of the real numbers stand in terms that are never run. *)
From Coq Require Import ZArith NArith List String.
From Dumbbell Require Import Certificate Gaps Check Text Reader Decide ByLaw.
Require Extraction.
From Coq Require Import ExtrOcamlBasic ExtrOCamlInt63 ExtrOCamlFloats.
Extract Constant ClassicalDedekindReals.sig_forall_dec => "fun _ -> assert false".
Extract Constant ClassicalDedekindReals.sig_not_dec => "fun _ -> assert false".
Extraction "checker.ml" judge greatest least says_heavy_once how_many is_gap is_open ratio_text dyadic_text decimal
  natural ratio_of ratio_le lowest_terms settle by_law.
