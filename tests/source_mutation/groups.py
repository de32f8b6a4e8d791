"""What is mutated, in which functions it makes no sense, and which tests must notice."""
from dataclasses import dataclass


@dataclass(frozen=True)
class Group:
    files: dict          # file -> translation unit that shows it (both below src/)
    left_out: frozenset  # functions whose results promise nothing, or are for people
    targets: tuple       # what to build
    suites: tuple        # commands (below the build folder) that must fail, in this order


VERIFIER = "verify"
GROUPS = {
    VERIFIER: Group(
        files={f"verify/{name}": f"verify/{unit}" for name, unit in {
            "number.hpp": "turning.cpp", "interval.hpp": "turning.cpp", "angle.hpp": "initial_leaf.cpp",
            "big.hpp": "turning.cpp", "precision.hpp": "turning.cpp", "ray.hpp": "turning.cpp",
            "bridge.hpp": "full.cpp", "section.hpp": "turning.cpp", "turning.cpp": "turning.cpp",
            "full.cpp": "full.cpp", "minimal.cpp": "minimal.cpp", "wedge.cpp": "wedge.cpp",
            "initial_flight.hpp": "initial_leaf.cpp", "initial_ray.hpp": "initial_leaf.cpp",
            "initial_reflection.hpp": "initial_leaf.cpp", "initial_leaf.cpp": "initial_leaf.cpp",
            "initial.cpp": "initial.cpp", "initial_claim.cpp": "initial_claim.cpp",
            "collisions.cpp": "collisions.cpp", "compare.cpp": "compare.cpp",
            "certificate.cpp": "certificate.cpp", "text.hpp": "certificate.cpp",
            "reader.hpp": "certificate.cpp"}.items()},
        left_out=frozenset({"guess_root", "guess_top", "guess_slope", "guess_sin_cos", "guess_tolerance",
                            "top_over", "terms", "describe", "show", "counted", "sqrt"}),
        targets=("dumbbell-verify", "test_verify"),
        suites=(("tests/verify/test_verify", "--abort"),)),
    "interval": Group(
        files={"arith/interval.hpp": "arith/elementary.cpp", "arith/rounding.hpp": "arith/elementary.cpp",
               "arith/elementary.cpp": "arith/elementary.cpp",
               "arith/big_interval.cpp": "arith/big_interval.cpp",
               "arith/big_interval.hpp": "arith/big_interval.cpp"},
        left_out=frozenset({"approximate"}),
        targets=("test_arith",),
        suites=(("tests/arith/test_arith", "--abort"),)),
    "step": Group(
        files={"model/reflection.hpp": "model/orbit.cpp", "model/contact.hpp": "model/orbit.cpp",
               "model/chart.hpp": "model/orbit.cpp", "model/count.hpp": "prove/witness.cpp",
               "model/ray.hpp": "model/orbit.cpp"},
        left_out=frozenset(),
        targets=("test_model", "test_prove"),
        suites=(("tests/model/test_model", "--abort"), ("tests/prove/test_prove", "--abort"))),
}
