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


def below(folder, sources, headers=""):
    """The files of a folder: sources, and headers as `name:source that shows it`."""
    shown = {f"{name}.cpp": f"{name}.cpp" for name in sources.split()}
    shown.update((f"{name}.hpp", f"{unit}.cpp") for name, unit in (x.split(":") for x in headers.split()))
    return {f"{folder}/{file}": f"{folder}/{unit}" for file, unit in shown.items()}


# What is not here has no decision in it (declarations, headers of a few constants), or shows people how far
# the verifier is (progress.cpp).
VERIFIER = {
    # the numbers
    **below("verify", "machine/arithmetic machine/work",
            "core/number:core/turning core/interval:core/turning core/big:core/turning functions/angle:wings/starts/leaf "
            "machine/meter:machine/work"),
    # the leaves
    **below("verify", "core/turning macro/leaps sections/body sections/full wings/starts/leaf",
            "core/ray:core/turning core/section:core/turning sections/bridge:sections/full sections/flights:sections/body "
            "wings/starts/flight:wings/starts/leaf wings/starts/ray:wings/starts/leaf "
            "wings/starts/reflection:wings/starts/leaf"),
    # the files and their claims
    **below("verify", "core/certificate core/claim wings/starts/grammar wings/starts/claim program/verify",
            "core/proofs:core/certificate core/text:core/certificate core/tree:core/certificate core/reader:core/certificate "
            "core/settings:core/certificate core/claim:program/verify input/bytes:program/verify "
            "wings/starts/grammar:wings/starts/grammar  "
            "wings/starts/zero:wings/starts/grammar"),
    # the program: what was asked, and what the verdict and the exit code say
    **below("verify/program", "options option_table claim_options claim_list "
            "examine main summary json escape", "arguments:options"),
}

ADIABATIC = below(
    "verify",
    "wings/adiabatic/grammar wings/adiabatic/attained wings/adiabatic/bounce wings/adiabatic/claim wings/adiabatic/class "
    "wings/adiabatic/bounces",
    "wings/adiabatic/grammar:wings/adiabatic/grammar wings/adiabatic/bounce:wings/adiabatic/bounces "
    "wings/adiabatic/check:wings/adiabatic/bounces  "
    "wings/adiabatic/claim:wings/adiabatic/claim wings/adiabatic/contact:wings/adiabatic/bounces "
    "wings/adiabatic/potential:wings/adiabatic/class  "
    "wings/adiabatic/arcsine:wings/adiabatic/bounces")

GROUPS = {
    "verify": Group(
        files=VERIFIER,
        # Guesses, from which certified steps start; and what `--explain` and a terminal show to people.
        left_out=frozenset({"guess_crossing", "terms", "describe", "log", "note", "block", "demand_text"}),
        texts=frozenset(("verify/wings/starts/claim.cpp", "verify/core/claim.cpp", *(
            f"verify/program/{name}.cpp" for name in ("summary", "json", "escape", "main")))),
        targets=("dumbbell-verify", "test_verify", "test_verify_poor_libraries", "mutation"),
        programs=("tests/rooms/verify/test_verify", "tests/rooms/verify/test_verify_poor_libraries"),
        prepare=(("{build}/tests/attacks/mutation/mutation", "--jobs", "1", "--most", "400", "--dump", "{work}/corpus",
                  "1500"),),
        replays=(("{build}/tests/attacks/mutation/mutation", "--replay", "{tree}/tests/attacks/false_claims/manifest.tsv"),
                 ("{build}/tests/attacks/mutation/mutation", "--replay", "{work}/corpus/manifest.tsv"))),
    "adiabatic": Group(
        files=ADIABATIC,
        left_out=frozenset(),
        texts=frozenset({"verify/wings/adiabatic/claim.cpp"}),
        targets=("dumbbell-verify", "test_verify", "mutation"),
        programs=("tests/rooms/verify/test_verify",),
        replays=(("{build}/tests/attacks/mutation/mutation", "--replay", "{tree}/tests/attacks/false_claims/manifest.tsv"),)),
    "perpendicular": Group(
        files=below("verify", "sections/perpendicular sections/cells",
                    "sections/cell:sections/cells sections/valley:sections/cells"),
        left_out=frozenset(),
        targets=("dumbbell-verify", "test_verify", "mutation"),
        programs=("tests/rooms/verify/test_verify",),
        replays=(("{build}/tests/attacks/mutation/mutation", "--replay", "{tree}/tests/attacks/false_claims/manifest.tsv"),)),
    "law": Group(  # its numbers and rules
        files=below("verify", "wings/law/bulk wings/law/end wings/law/layer",
                    "wings/law/constants:wings/law/grammar wings/law/kernel:wings/law/layer wings/law/rule:wings/law/layer "
                    "wings/law/slope:wings/law/layer wings/law/steps:wings/law/grammar"),
        left_out=frozenset(),
        targets=("dumbbell-verify", "test_verify_law"),
        programs=("tests/rooms/verify/test_verify_law",)),
    "law_files": Group(
        files=below("verify", "wings/law/claim wings/law/grammar"),
        left_out=frozenset(),
        texts=frozenset({"verify/wings/law/claim.cpp"}),
        targets=("dumbbell-verify", "test_verify", "test_verify_law"),
        programs=tuple(f"tests/rooms/verify/test_{name}" for name in ("verify_law", "verify"))),
    "interval": Group(
        files={"number/interval.hpp": "number/elementary.cpp", "number/rounding.hpp": "number/elementary.cpp",
               "number/ends.hpp": "number/elementary.cpp", "number/interval.cpp": "number/interval.cpp",
               "number/elementary.cpp": "number/elementary.cpp", "number/sine_kernel.hpp": "number/elementary.cpp",
               "number/big_interval.cpp": "number/big_interval.cpp",
               "number/big_interval.hpp": "number/big_interval.cpp"},
        left_out=frozenset({"approximate"}),
        targets=("test_number", "test_interval"),
        programs=("tests/rooms/number/test_number", "tests/attacks/interval/test_interval")),
    "step": Group(
        files={"flight/reflection.hpp": "flight/orbit.cpp", "flight/contact.hpp": "flight/orbit.cpp",
               "flight/chart.hpp": "flight/orbit.cpp", "flight/count.hpp": "collisions/witness.cpp",
               "flight/ray.hpp": "flight/orbit.cpp"},
        left_out=frozenset({"add", "forget", "next", "step_from"}),  # of ContactTrend, which guesses
        targets=("test_flight", "test_flight_long"),
        programs=("tests/rooms/flight/test_flight", "tests/rooms/flight/test_flight_long")),
    "collisions": Group(
        files=below("collisions", "certificate certify chart claim cover halving leaf leaf_boxes part piece piece_store plan reader "
                    "section sections/dumbbell sections/full sections/turning step_guess witness "
                    "witness_orbit writer",
                    "piece_store:piece_store"),
        left_out=frozenset(),
        targets=("test_collisions",),
        programs=("tests/rooms/collisions/test_collisions",),
        texts=frozenset({"collisions/writer.cpp"})),
    "critical": Group(
        files=below("critical", "enclose long_orbits range"),
        left_out=frozenset(),
        targets=("test_critical",),
        programs=("tests/rooms/critical/test_critical",)),
    "starts": Group(
        files=below("wings/starts",
                    "cover/leaf air/box_state answer/reader cover/subdivide answer/trace answer/witness_start answer/writer",
                    "air/box_state:air/box_state cover/subdivide:cover/subdivide"),
        left_out=frozenset(),
        targets=("test_starts",),
        programs=("tests/rooms/wings/starts/test_starts",),
        texts=frozenset({"wings/starts/answer/writer.cpp"})),
    "invariant": Group(  # the search for adiabatic statements
        files=below("wings/adiabatic", "attained box classes cover hypotheses prove reader search writer",
                    "box:box"),
        left_out=frozenset(),
        targets=("test_adiabatic",),
        programs=("tests/rooms/wings/adiabatic/test_adiabatic",),
        texts=frozenset({"wings/adiabatic/writer.cpp"})),
    "file": Group(
        files=below("file", "atomic_file dyadic file_contents folder_lock last_line lines sealed_lines sha256 unpacked_text "
                    "verifier_program",
                    "descriptor:atomic_file lines:lines sealed_lines:sealed_lines"),
        left_out=frozenset(),
        targets=("test_file", "test_collisions", "dumbbell-verify"),
        programs=("tests/rooms/file/test_file", "tests/rooms/collisions/test_collisions"),
        texts=frozenset({"file/dyadic.cpp"})),
    "audit": Group(  # but for the report, which the tests of the command read
        files=below("wings/audit", "audit tiling"),
        left_out=frozenset(),
        targets=("test_audit",),
        programs=("tests/rooms/wings/audit/test_audit",)),
}
