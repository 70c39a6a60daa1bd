"""Manifold: what two bodies of a scene have in common, against what the constraints of scenes say of them."""

from __future__ import annotations

import json
import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from manifold3d import Error, Manifold, Mesh

"""Verdicts that say that two bodies have points in common which are inside of both."""
COMMON = ("interference", "within", "same-place")
"""Of all pairs, at most so many may be undecided."""
UNDECIDED = 0.02


@dataclass(frozen=True)
class Pair:
    """Two bodies of different objects. Lengths are those of the design."""

    name: str
    """The code of the first breach, or `apart`."""
    verdict: str
    """How deep a witness is beneath the surface of the other body, at least."""
    depth: float
    bodies: tuple[Manifold, Manifold]
    """How far the triangles of both are from the true faces at most, together."""
    bound: float


def judge(pair: Pair) -> Iterator[str]:
    """Closed bodies; a common volume where the verdict says so, and none where it says that there is none."""
    one, other = pair.bodies
    for body in pair.bodies:
        if body.status() != Error.NoError or not body.volume() > 0:
            yield f"a body is {body.status()}, its volume {body.volume()}"
    common = (one ^ other).volume()
    # A layer as thick as the triangles may be off.
    layer = pair.bound * min(one.surface_area(), other.surface_area())
    if pair.verdict in COMMON:
        # A ball round the witness is in both bodies; what triangles may leave of it is smaller by their distance.
        least = max(0.0, pair.depth - pair.bound)
        if not common >= 0.99 * least**3:
            yield f"common volume is {common:.3g}, expected at least {least**3:.3g}: {pair.verdict}"
        if pair.depth > pair.bound and not common > 0:
            yield f"common volume is {common:.3g}: {pair.verdict}"
    elif not pair.verdict.startswith("undecided") and not common <= layer:
        yield f"common volume is {common:.3g}, expected at most {layer:.3g}: {pair.verdict}"


def load(folder: Path) -> Iterator[Pair]:
    """The pairs of a folder."""
    held = (folder / "pairs.bin").read_bytes()

    def words(place: list[int], kind: str) -> np.ndarray:
        first, count = place
        return np.frombuffer(held, dtype=kind, count=count, offset=first).reshape(-1, 3)

    for entry in json.loads((folder / "pairs.json").read_text(encoding="utf-8")):
        meshes = entry["meshes"]
        one, other = (
            Manifold(
                Mesh(
                    vert_properties=words(mesh["positions"], "<f4").astype(np.float32),
                    tri_verts=words(mesh["indices"], "<u4").astype(np.uint32),
                )
            )
            for mesh in meshes
        )
        yield Pair(
            name=entry["name"],
            verdict=entry["verdict"],
            depth=entry["depth"],
            bodies=(one, other),
            bound=sum(mesh["bound"] for mesh in meshes),
        )


def main() -> None:
    """Judges all pairs, then some of which the opposite is said; counts as Node's test runner does."""
    passed = failed = refused = 0
    told: Counter[str] = Counter()
    for pair in load(Path(sys.argv[1])):
        told[pair.verdict] += 1
        found = list(judge(pair))
        for fault in found:
            print(f"not ok: {pair.name}: Manifold: {fault}", flush=True)
        failed += bool(found)
        passed += not found
        turned = replace(pair, verdict="interference" if pair.verdict == "apart" else "apart", depth=0.5)
        refused += bool(list(judge(turned)))
    print(", ".join(f"{count} {verdict}" for verdict, count in told.most_common()))
    total = sum(told.values())
    undecided = sum(count for code, count in told.items() if code.startswith("undecided"))
    enough = {
        "at least 900 pairs": total >= 900,
        "every verdict on many": min(told["apart"], sum(told[code] for code in COMMON)) >= 200,
        "few undecided": undecided <= UNDECIDED * total,
        # What hardly reaches into another may be taken for apart by triangles.
        "the opposite is refused of four in five": refused >= 0.8 * total,
    }
    for what, holds in enough.items():
        if not holds:
            print(f"not ok: Manifold: {what}: {total} pairs, {refused} of them refused", flush=True)
        failed += not holds
        passed += holds
    print(f"# pass {passed}\n# fail {failed}")
    sys.exit(failed > 0)


if __name__ == "__main__":
    main()
