"""Several files that prove one claim."""

from collisions import Staircase
from demand import interval_text, ratio_text
from failure import VERDICTS, Rejected


def together(files, demand):
    """What all files prove as one: the same as one file with the pieces of all, in ascending order. `files`: each name with its
    result. Raises a Failure: that of the worst file, or why they are not one."""
    name, worst = max(files, key=lambda file: list(VERDICTS).index(file[1].word))
    if worst.why:
        worst.why.args = (f"{name}: {f'line {worst.why.line}: ' if worst.why.line else ''}{worst.why}",)
        worst.why.line = 0
        raise worst.why
    chain = sorted(((name, one.proof) for name, one in files), key=lambda file: (file[1].low, file[1].high))
    (_, first), pieces = chain[0], list(chain[0][1].pieces)
    told = [piece for _, proof in chain for piece in proof.told]
    for (before, _), (name, proof) in zip(chain, chain[1:]):
        end = pieces[-1][1]
        if (proof.scene, proof.rho) != (first.scene, first.rho):
            raise Rejected(0, "chain", f"several scenes: {about(*chain[0])}, {about(name, proof)}")
        if proof.low != end:
            raise Rejected(0, "chain", f"{'a hole' if proof.low > end else 'an overlap'}: {before} ends at {ratio_text(end)}, and "
                                       f"{name} begins at {ratio_text(proof.low)}")
        pieces += proof.pieces
    whole = Staircase(first.scene, first.rho, all(proof.heavy_once for _, proof in chain), pieces, f"files={len(files)}", told)
    if not (demand["ratio"] or demand["inertia"]):
        whole.parts = [part for _, proof in chain for part in proof.whole()]
    missing = whole.missing(demand)
    if missing:
        raise Rejected(0, "claim-not-proved", missing)
    return whole


def about(name, proof):
    return f"{name} is about the scene {proof.scene}" + (f" with rho in {interval_text(*proof.rho)}" if proof.rho else "")
