#!/usr/bin/env python3
"""assumptions_test.py PROJECT: what `./run prove` does not believe. The check of what the proof rests on (proofs/coq/assumptions) takes the
project's own sources, and refuses Coq files that assume something, and what Coq says where something was assumed. Needs no Coq."""

import importlib.machinery
import importlib.util
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
PROJECT = Path(sys.argv[1])
del sys.argv[1:2]
CHECK = PROJECT / "proofs/coq/assumptions"
LOADER = importlib.machinery.SourceFileLoader("assumptions", str(CHECK))
assumptions = importlib.util.module_from_spec(importlib.util.spec_from_loader("assumptions", LOADER))
LOADER.exec_module(assumptions)

GOOD_SOURCE = """(** A comment (* with another, Admitted. *), and "a string *) Axiom." in it. *)
From Coq Require Import Reals Floats.FloatAxioms.
Section S.
Variable x : R.
Hypothesis Hx : 0 < x.
Lemma positive : 0 < x. Proof. assert (Cd := Hx). exact Cd. Qed.
End S.
Module Count (F : FloatOps with Definition sensible_format := true).
Module Export Y := Fast F.
Section S. Variables (a b : R). Context (c : R). Notation r := (a + b). Local Notation k x := (c + x).
End S.
End Count.
Definition admitted' := "Axiom false : False.". Definition Admitted' := 1. Lemma axiom : True. Proof. easy. Qed.
"""
BAD_SOURCES = [
    "Lemma bad' : False. Proof. Admitted.", "Lemma bad : False.\nProof.\n  - Admitted.", "Lemma bad : False.\nAdmitted.",
    "Lemma bad : False. Proof. (* no *)Admitted.", "Lemma bad : False. Proof. admit. Qed.", "Lemma bad : False. Proof. try (give_up). Qed.",
    "Admit Obligations.", "Axiom bad : False.", "  Axioms bad worse : False.", "#[local] Axiom bad : False.",
    "#[local]\nAxiom\nbad : False.", "Local Axiom bad : False.", "Parameter bad : False.", "Local Parameters bad : False.",
    "Conjecture bad : False.", "#[global] Conjectures bad : False.", "Lemma a : True. Proof. easy. Qed. Axiom bad : False.",
    "Hypothesis bad : False.", "  Hypothesis bad : False.", "Variable bad : False.", "Local Variables bad : False.",
    "#[local] Hypotheses bad : False.", "Context (bad : False).", "Section S.\nEnd S.\nHypothesis bad : False.",
    "Section S. Lemma a : True. Proof. easy. Qed. End S. Variable bad : False.",
    "Module M. Hypothesis bad : False. End M.",
    "Module Type M. Variable bad : False. End M.", "Declare Module N : M.", "Section S.\nEnd T.", "End S.", "Time Section S.", "Module.",
    "Module M (F : T with Definition x := 1). Variable bad : False. End M.", "Section S. Time End S. Variable bad : False.",
    "Unset Guard Checking.", "#[local] Unset Guard Checking.", "Local Unset  Guard\n Checking.", "Unset Positivity Checking.",
    "Unset Universe Checking.", "#[bypass_check(guard)] Fixpoint bad (n : nat) : False := bad n.",
    "#[bypass_check(universes)] Definition bad := Type.", "#[bypass_check(positivity)] Inductive bad := C (f : bad -> False).",
    "Primitive bad := #int63_add.", 'Load "bad".', 'Declare ML Module "bad".', "(* a comment that does not end",
    '(* a string in it "*) Axiom bad : False.', 'Definition a := "no end.', '(* (* *) "*)" *) Axiom bad : False.',
    # What would be extracted is not what was proved, or a sentence does not mean what it says.
    'Extract Constant ratio_le => "fun _ _ -> true".', '#[local] Extract Inlined Constant ratio_le => "fun _ _ -> true".',
    'Extract Inductive bool => "int" ["0" "1"].', "Extraction Inline ratio_le.", "From Coq Require Import ExtrOcamlZBigInt.",
    "From Coq Require Import Reals ExtrOcamlBasic.", "Require Extraction.", "From Bad Require Import Reals.", "Require Import Bad.",
    'Notation "x < y" := True.', 'Section S. Notation "x < y" := (y < x). End S.', "Notation upper_bound := True.", "Local Notation PI := 3.",
    'Infix "<" := bad.', 'Reserved Notation "x < y".', "Coercion bad : nat >-> R.", "Canonical Structure bad := b.", "Arguments bad _%Z.",
    "Bind Scope Z_scope with N.", 'Add LoadPath "bad" as Bad.', 'Add ML Path "bad".', 'Cd "bad".', 'Time Cd "bad".', '#[local] Cd "bad".',
    '- Cd "bad".', 'Redirect "bad" Print bad.', "Drop.", "Register bad as core.bool.type.", "Set Definitional UIP.", "From Dumbbell.a.b Require Bad.",
    "Implicit Types x : Z.", 'Tactic Notation "exact" := admit_it.', "Delimit Scope Z_scope with R.",
]
GOOD_HEADLINES = """From Coq Require Import Reals.
From Dumbbell.statement Require Import Statement.
From Dumbbell.theorems Require Maximum.
Local Open Scope R_scope.
Theorem N_exists : forall q : R, 1 <= q ->
  exists n : nat, N_star q n.
Proof. exact Maximum.N_exists. Qed.
"""
BAD_HEADLINES = ["From Dumbbell.corners Require Import Stretch.", "From Dumbbell.statement Require Export Statement.", "From Dumbbell Require Maximum.",
                 "Import Stretch.", "Local Open Scope Z_scope.", "Definition upper_bound (q : R) (n : nat) := True.", "Section S. End S.",
                 "Module M. End M.", "From Coq Require Import ZArith.", "Theorem a : True. Proof. auto. Qed."]

AXIOM = "Classical_Prop.classic : forall P : Prop, P \\/ ~ P\n"
# What Coq prints of all that axioms.txt lists.
BESIDE = "Axioms:\n" + "".join(".".join(entry.split(" : ")[0].split(".")[-2:]) + "\n  : " + entry.split(" : ", 1)[1] + "\n"
                               for kind, entry in assumptions.listed_axioms() if kind != "coqchk")
BAD_BESIDE = [BESIDE.replace("Classical_Prop.", "Logic.Classical_Prop."), BESIDE + "bad : False\n", BESIDE.replace(": Set", ": Prop"), ""]
GOOD_SAID = ["Closed under the global context\n", "Axioms:\n" + AXIOM,
             "Axioms:\nClassicalDedekindReals.sig_forall_dec :\n  forall P : nat -> Prop,\n  (forall n : nat, {P n} + {~ P n}) ->\n"
             "  {n : nat | ~ P n} + {forall n : nat, P n}\n" + AXIOM,
             "Axioms:\nFunctionalExtensionality.functional_extensionality_dep\n  : forall (A : Type) (B : A -> Type)\n"
             "      (f g : forall x : A, B x),\n    (forall x : A, f x = g x) -> f = g\n" + AXIOM]
COMPUTED = "Axioms:\n" + AXIOM + "PrimInt63.add : PrimInt63.int -> PrimInt63.int -> PrimInt63.int\nPrimFloat.float : Set\n"
BAD_SAID = [
    "", "\n", "Axioms:\n", "Axioms:\nbad : False\n", "Axioms:\nbad' : False\n", "Axioms:\n" + AXIOM + "Dumbbell.bad' : False\n",
    "Axioms:\nbad'\n  : False\n", "Axioms:\n" + AXIOM + "bad is assumed to be guarded.\n", "Axioms:\nbad is assumed to be positive.\n",
    "Axioms:\nClassical_Prop.classic is assumed to be guarded.\n", "Axioms:\nClassical_Prop.classic\n  is assumed to be guarded.\n",
    "Axioms:\nbad relies on an unsafe hierarchy.\n", "Axioms:\nbad relies on definitional UIP.\n", "Axioms:\nx.Classical_Prop.classic : False\n",
    "Axioms:\nClassical_Prop.classic : True\n", "Axioms:\n" + AXIOM[:-1] + " \\/ P\n", "Axioms:\nBad." + AXIOM, "Axioms:\nLogic." + AXIOM,
    "Axioms:\nClassical_Prop.classics : False\n", "Axioms:\nClassical_Propxclassic : False\n", "Axioms:\nClassical_Prop.classic\n",
    "Axioms:\nClassical_Prop.classic :\n", "Axioms:\nbad' :\n  False\n", "Axioms:\nClassical_Prop.classic :\n" + AXIOM,
    "Axioms:\nClassical_Prop.classic\n" + AXIOM, "Axioms:\nClassical_Prop.classic:False\n", AXIOM, "Axioms:\n" + AXIOM + "\nTheory:\n",
    "Section Variables:\nbad : False\nAxioms:\n" + AXIOM, "Axioms:\n" + AXIOM + "Section Variables:\nbad : False\n",
    "Theory: type_in_type is on\nAxioms:\n" + AXIOM, "Closed under the global context\nAxioms:\nbad : False\n",
    "Axioms:\n" + AXIOM + "Axioms:\n",
    "Axioms:\n  bad : False\n", "bad\n", "Error: bad was not found\n",
]

GOOD_CONTEXT = """
CONTEXT SUMMARY
===============

* Theory: Set is predicative

* Axioms:
    Coq.Numbers.Cyclic.Int63.PrimInt63.compares
    Coq.Reals.Rdefinitions.RbaseSymbolsImpl.Rquot2
    mathcomp.ssreflect.bigop.BigOp.bigop
    Coq.Logic.Classical_Prop.classic

* Constants/Inductives relying on type-in-type: <none>

* Constants/Inductives relying on unsafe (co)fixpoints: <none>

* Inductives whose positivity is assumed: <none>
""".replace("\n\n*", "\n  \n*")
CLASSIC = "    Coq.Logic.Classical_Prop.classic\n"
BAD_CONTEXTS = ["", "Error: Anomaly\n", GOOD_CONTEXT.replace("predicative", "impredicative"),
                GOOD_CONTEXT.replace("* Inductives", "Inductives"),
                GOOD_CONTEXT + "* Rewrite rules: bad\n", "Warning: bad\n" + GOOD_CONTEXT]
BAD_CONTEXTS += [GOOD_CONTEXT.replace(what + ": <none>", what + ":\n    Dumbbell.motion.Flight.bad")
                 for what in ("type-in-type", "(co)fixpoints", "is assumed")]
BAD_CONTEXTS += [GOOD_CONTEXT.replace(CLASSIC, CLASSIC + bad + "\n")
                 for bad in ("    Dumbbell.motion.Flight.bad'", "    Dumbbell.Classical_Prop.classic",
                             "    Coq.Logic.ProofIrrelevance.proof_irrelevance", "    Interval.Tactic.bad", "    Classical_Prop.classic",
                             "    Coq.Logic.Classical_Prop.classic is bad", "* Axioms:",
                             "    Coq.Logic.Classical_Prop.classic'", "    mathcomp.ssreflect.bigop.bad", "bad")]


class Assumptions(unittest.TestCase):
    def judge(self, check, good, bad):
        for text in good:
            self.assertEqual(list(check(text)), [], text)
        for text in bad:
            self.assertNotEqual(list(check(text)), [], text)

    def test_source(self):
        self.judge(assumptions.faults_of_source, [GOOD_SOURCE], BAD_SOURCES)

    def test_headlines(self):
        self.judge(lambda text: assumptions.faults_of_source(text, "Headlines.v"), [GOOD_HEADLINES],
                   [GOOD_HEADLINES + bad for bad in BAD_HEADLINES])

    def test_listed(self):
        """The sentences of sentences.txt are allowed in their file, as they stand, and nowhere else."""
        name = "checker/Extract.v"
        text = (PROJECT / "proofs/coq" / name).read_text()
        self.judge(lambda text: assumptions.faults_of_source(text, name), [text],
                   [text + 'Extract Constant ratio_le => "fun _ _ -> true".\n', text.replace("assert false", "true"),
                    text.replace("judge ", "judge (* *) ")])
        self.judge(lambda text: assumptions.faults_of_source(text, "checker/Other.v"), [], [text])

    def test_theorem(self):
        check = assumptions.faults_of_theorem
        self.judge(lambda text: check(text, BESIDE), GOOD_SAID, [*BAD_SAID, COMPUTED])
        self.judge(lambda text: check(text, BESIDE, "computed"), [*GOOD_SAID, COMPUTED], [*BAD_SAID, COMPUTED.replace("Set", "Type")])
        self.judge(lambda beside: check(COMPUTED, beside, "computed"), [BESIDE], BAD_BESIDE)

    def test_context(self):
        self.judge(assumptions.faults_of_context, [GOOD_CONTEXT], BAD_CONTEXTS)

    def accepts(self, *words):
        """What is not accepted is refused in words, and not by a crash."""
        ended = subprocess.run([CHECK, *words], capture_output=True, text=True, check=False)
        refused = ended.stderr.startswith("assumptions: ")
        self.assertEqual((ended.returncode, ended.stderr == ""), (int(refused), not refused), ended.stderr)
        return not refused

    def test_program(self):
        self.assertTrue(self.accepts("sources", PROJECT / "proofs/coq"))
        with tempfile.TemporaryDirectory() as folder:
            beside = Path(folder) / "beside"
            beside.write_text(BESIDE)
            for kind, good, bad in (("theorem", GOOD_SAID[0], COMPUTED), ("computed", COMPUTED, BAD_SAID[0]), ("context", GOOD_CONTEXT, BAD_CONTEXTS[0])):
                for text, is_good in ((good, True), (bad, False)):
                    said = Path(folder) / kind
                    said.write_text(text)
                    self.assertEqual(self.accepts(kind, *[beside] * (kind != "context"), said), is_good)

    def test_folder(self):
        """Each file is read, and all are listed, without an option besides."""
        with tempfile.TemporaryDirectory() as name:
            folder, options = Path(name), "-R . Dumbbell"

            def accepts(*listed):
                (folder / "_CoqProject").write_text("".join(line + "\n" for line in listed))
                return self.accepts("sources", folder)

            self.assertFalse(accepts(options))
            files = ["Headlines.v", "a/a.v", "b/b.v"]
            for file in files:
                (folder / file).parent.mkdir(exist_ok=True)
                (folder / file).write_text(GOOD_HEADLINES)
            self.assertTrue(accepts(options, *files))
            for listed in ([options, *files[:2]], [options, *files, "c.v"], files, ["-type-in-type", options, *files],
                           [options, "-arg -impredicative-set", *files]):
                self.assertFalse(accepts(*listed), listed)
            # The name of another file, above the rooms or in another one; and what is in no room.
            for second in ("a.v", "b/a.v", "b/Headlines.v", "c.v"):
                (folder / second).write_text(GOOD_HEADLINES)
                self.assertFalse(accepts(options, *files, second), second)
                (folder / second).unlink()
            (folder / "b/b.v").write_text(BAD_SOURCES[0])
            self.assertFalse(accepts(options, *files))


if __name__ == "__main__":
    unittest.main()
