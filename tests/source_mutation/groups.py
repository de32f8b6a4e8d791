"""What is mutated, in which functions it makes no sense, and which tests must notice."""
from dataclasses import dataclass


@dataclass(frozen=True)
class Group:
    files: dict          # file -> translation unit that shows it (both below src/)
    left_out: frozenset  # functions whose results promise nothing, or are for people
    targets: tuple       # what to build
    programs: tuple      # Catch2 programs (below the build folder), whose test cases are run one by one
    prepare: tuple = ()  # commands before all tests, and
    replays: tuple = ()  # tests that are commands: of {build}, {tree}, {work}
    texts: frozenset = frozenset()  # files whose texts programs read; those of the others are messages for people


# What is not here has no decision in it: declarations, and headers of a few constants.
VERIFIER = {f"verify/{name}": f"verify/{unit}" for name, unit in {
    # the numbers
    "number.hpp": "turning.cpp", "interval.hpp": "turning.cpp", "angle.hpp": "initial_leaf.cpp",
    "big.hpp": "turning.cpp", "precision.hpp": "turning.cpp", "work.hpp": "turning.cpp",
    # the leaves
    "ray.hpp": "turning.cpp", "bridge.hpp": "full.cpp", "section.hpp": "turning.cpp",
    "turning.cpp": "turning.cpp", "full.cpp": "full.cpp", "minimal.cpp": "minimal.cpp",
    "wedge.cpp": "wedge.cpp", "initial_flight.hpp": "initial_leaf.cpp", "initial_ray.hpp": "initial_leaf.cpp",
    "initial_reflection.hpp": "initial_leaf.cpp", "initial_leaf.cpp": "initial_leaf.cpp",
    # the files and their claims
    "text.hpp": "certificate.cpp", "reader.hpp": "certificate.cpp", "certificate.cpp": "certificate.cpp",
    "certificate.hpp": "certificate.cpp", "initial.cpp": "initial.cpp", "initial.hpp": "initial.cpp",
    "initial_claim.cpp": "initial_claim.cpp", "collisions.cpp": "collisions.cpp",
    "collisions.hpp": "certificate.cpp", "compare.cpp": "compare.cpp",
    # the program: what was asked, and what the verdict and the exit code say
    "words.hpp": "options.cpp", "options.cpp": "options.cpp", "claim_options.cpp": "claim_options.cpp",
    "claim_list.cpp": "claim_list.cpp", "part_options.cpp": "part_options.cpp", "part.cpp": "part.cpp",
    "part_lines.cpp": "part_lines.cpp", "piece_sums.cpp": "piece_sums.cpp", "combine.cpp": "combine.cpp",
    "examine.cpp": "examine.cpp", "main.cpp": "main.cpp",
    "summary.cpp": "summary.cpp", "json.cpp": "json.cpp", "junit.cpp": "junit.cpp", "escape.cpp": "escape.cpp",
    "replace_file.cpp": "replace_file.cpp"}.items()}

GROUPS = {
    "verify": Group(
        files=VERIFIER,
        # Guesses, from which certified steps start; and what `--explain` and a terminal show to people.
        left_out=frozenset({"guess_root", "guess_top", "guess_slope", "guess_sin_cos", "guess_tolerance",
                            "guess_crossing", "terms", "sqrt", "describe", "show", "counted", "log", "note",
                            "block", "demand_text"}),
        texts=frozenset(f"verify/{name}" for name in (
            "summary.cpp", "json.cpp", "junit.cpp", "escape.cpp", "initial_claim.cpp", "collisions.cpp",
            "compare.cpp", "main.cpp", "part.cpp")),
        targets=("dumbbell-verify", "test_verify", "mutation"),
        programs=("tests/verify/test_verify",),
        prepare=(("{build}/tests/mutation/mutation", "--jobs", "1", "--most", "400", "--dump", "{work}/corpus",
                  "1500"),),
        replays=(("{build}/tests/mutation/mutation", "--replay", "{tree}/tests/false_claims/manifest.tsv"),
                 ("{build}/tests/mutation/mutation", "--replay", "{work}/corpus/manifest.tsv"))),
    "interval": Group(
        files={"arith/interval.hpp": "arith/elementary.cpp", "arith/rounding.hpp": "arith/elementary.cpp",
               "arith/elementary.cpp": "arith/elementary.cpp", "arith/sine_kernel.hpp": "arith/elementary.cpp",
               "arith/big_interval.cpp": "arith/big_interval.cpp",
               "arith/big_interval.hpp": "arith/big_interval.cpp"},
        left_out=frozenset({"approximate"}),
        targets=("test_arith",),
        programs=("tests/arith/test_arith",)),
    "step": Group(
        files={"model/reflection.hpp": "model/orbit.cpp", "model/contact.hpp": "model/orbit.cpp",
               "model/chart.hpp": "model/orbit.cpp", "model/count.hpp": "prove/witness.cpp",
               "model/ray.hpp": "model/orbit.cpp"},
        left_out=frozenset(),
        targets=("test_model",),
        programs=("tests/model/test_model",)),
}
