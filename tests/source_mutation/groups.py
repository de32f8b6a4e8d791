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

ADIABATIC = below(
    "verify",
    "adiabatic adiabatic_attained adiabatic_bounce adiabatic_claim adiabatic_class adiabatic_run",
    "adiabatic:adiabatic adiabatic_bounce:adiabatic_run adiabatic_check:adiabatic_run "
    "adiabatic_claim:adiabatic_claim adiabatic_contact:adiabatic_run adiabatic_potential:adiabatic_class "
    "arcsine:adiabatic_run")

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
    "adiabatic": Group(
        files=ADIABATIC,
        left_out=frozenset({"describe", "show", "counted", "log", "note"}),
        texts=frozenset({"verify/adiabatic_claim.cpp"}),
        targets=("dumbbell-verify", "test_verify", "mutation"),
        programs=("tests/verify/test_verify",),
        replays=(("{build}/tests/mutation/mutation", "--replay", "{tree}/tests/false_claims/manifest.tsv"),)),
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
    "batch": Group(  # but for aim.hpp, which guesses
        files=below("batch", "count", "count_lanes:count_plain lower_step:count_plain pack:count_plain "
                    "query:count_plain sine:count_plain step:count_plain upper_step:count_plain"),
        left_out=frozenset({"rough_sin_cos"}),
        targets=("test_batch",),
        programs=("tests/batch/test_batch",)),
    "prove": Group(
        files=below("prove", "adiabatic adiabatic_attained adiabatic_box adiabatic_branch adiabatic_classes "
                    "adiabatic_cover adiabatic_hypotheses adiabatic_printed adiabatic_search certify cover "
                    "critical critical_confirm critical_range full_leaf initial_leaf initial_state law leaf "
                    "piece piece_store section staircase subdivide trace traced_value turning_leaf wedge_leaf "
                    "wedge_witness witness witness_orbit witness_start",
                    "adiabatic_box:adiabatic_box growing_tree:cover initial_state:initial_state "
                    "leaf_judges:leaf piece_store:piece_store subdivide:subdivide"),
        left_out=frozenset(),
        targets=("test_prove",),
        programs=("tests/prove/test_prove",)),
    "certificate": Group(
        files=below("certificate", "adiabatic_reader adiabatic_writer any_reader atomic_file certificate "
                    "folder_lock initial_reader initial_writer lines names reader writer",
                    "descriptor:atomic_file lines:lines"),
        left_out=frozenset(),
        targets=("test_certificate",),
        programs=("tests/certificate/test_certificate",),
        texts=frozenset(f"certificate/{name}.cpp" for name in (
            "writer", "adiabatic_writer", "initial_writer", "names"))),
    "cluster": Group(
        files=below("cluster", "adiabatic_case adiabatic_kind campaign campaign_folder campaign_status "
                    "collisions_kind critical_kind journal judges kind last_line local_engine merge order "
                    "password plan sealed_lines verified_kind verifier_program work_queue_engine "
                    "work_queue_manager worker_commands", "sealed_lines:sealed_lines"),
        left_out=frozenset(),
        targets=("test_cluster", "test_work_queue", "dumbbell-verify"),
        programs=("tests/cluster/test_cluster", "tests/cluster/test_work_queue")),
    "audit": Group(  # but for the report, which the tests of the command read
        files=below("audit", "audit claimed_range leaf_boxes tiling"),
        left_out=frozenset(),
        targets=("test_audit",),
        programs=("tests/audit/test_audit",)),
}
