"""The files that are judged, what is expected of them, and how a verdict is told.

`crates/specimens` writes the files and `specimens.json`. A judge is a function of one specimen that yields a sentence
for each fault; every judge is also given damaged specimens, in which it must find the damage.
"""

from __future__ import annotations

import json
import sys
import traceback
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path


@dataclass(frozen=True)
class Template:
    """One part on paper, by its true faces. Lengths are millimetres."""

    """Width and height of each section."""
    sections: tuple[tuple[float, float], ...]
    """Of the whole part along its axis."""
    height: float
    """Area of the strip under the rim, or nothing where that is a point."""
    strip: float | None


@dataclass(frozen=True)
class Cells:
    """The inside of a solid as cells. Lengths are millimetres."""

    """`hexahedron` or `tetrahedron`."""
    shape: str
    """0 and then finer."""
    fineness: int
    """The same cells in every format."""
    files: dict[str, Path]
    points: int
    cells: int
    """The sum of the volumes of all cells."""
    volume: float
    """The scaled Jacobian of the worst cell."""
    least_quality: float


@dataclass(frozen=True)
class Specimen:
    """One product of one design. Lengths are millimetres."""

    name: str
    """`pot`, or `solid` for vase mode."""
    product: str
    files: dict[str, Path]
    parts: int
    triangles: int
    """Widths along x, y and z, by the measures of the design and the size that was asked for."""
    size: tuple[float, float, float]
    """Of the triangles, summed in double precision."""
    mesh_volume: float
    mesh_area: float
    """Of the clay, by quadrature on the closed form."""
    clay_volume: float
    """What the measures say that this may be off: more than rounding where a wall had to be thinned."""
    clay_error: float
    """How far the triangles are from the true faces at most."""
    bound: float
    """Millimetres of the unit of the design."""
    unit: float
    """Whether a slicer is to make G-code of it, which takes a second or two."""
    slice: bool
    """What the template of each part shows."""
    templates: tuple[Template, ...]
    """What is inside, where that is known: every shape and fineness."""
    cells: tuple[Cells, ...] = ()

    def with_file(self, kind: str, path: Path, damage: str) -> Specimen:
        """The same expectations of another, damaged file, which is not sliced."""
        return replace(self, name=f"{self.name} {damage}", files={**self.files, kind: path}, slice=False)


Judge = Callable[[Specimen], Iterator[str]]
Damage = Callable[[Specimen, Path], Specimen]


def near(what: str, found: float, expected: float, within: float) -> Iterator[str]:
    """A fault where the two differ by more; also where one is not a number."""
    if not abs(found - expected) <= within:
        yield f"{what} is {found:.9g}, expected {expected:.9g} within {within:.2g}"


def equal(what: str, found: object, expected: object) -> Iterator[str]:
    """A fault where the two differ."""
    if found != expected:
        yield f"{what} is {found}, expected {expected}"


def main(program: str, judge: Judge, damages: dict[Damage, str], wanted: Callable[[Specimen], bool]) -> None:
    """Judges the specimens of the folder on the command line, then damaged ones; counts as Node's test runner does.

    `damages` says with which words the fault begins that must be found.
    """
    folder = Path(sys.argv[1])
    specimens = [specimen for specimen in load(folder) if wanted(specimen)]
    scratch = folder / "damaged" / program.replace(" ", "-")
    scratch.mkdir(parents=True, exist_ok=True)
    passed = failed = 0
    # One process for each processor: what is judged takes one, and none knows of another.
    with ProcessPoolExecutor() as pool:
        all_found = list(pool.map(partial(faults, judge), specimens))
    for specimen, found in zip(specimens, all_found, strict=True):
        for fault in found:
            print(f"not ok: {specimen.name}: {program}: {fault}", flush=True)
        failed += bool(found)
        passed += not found
    for damage, words in damages.items():
        broken = damage(specimens[0], scratch)
        found = faults(judge, broken)
        right = [fault for fault in found if fault.startswith(words)]
        if right:
            passed += 1
            print(f"refused, as it must be: {broken.name}: {program}: {right[0]}", flush=True)
        else:
            failed += 1
            print(f"not ok: {broken.name}: {program}: expected a fault `{words} ..`, found {found}", flush=True)
    print(f"# pass {passed}\n# fail {failed}")
    sys.exit(failed > 0)


def faults(judge: Judge, specimen: Specimen) -> list[str]:
    """What a judge finds; that it cannot read the file at all is a fault as well."""
    try:
        return list(judge(specimen))
    except Exception as error:  # readers of files raise whatever they like
        where = traceback.extract_tb(error.__traceback__)[-1]
        return [f"{type(error).__name__} in {where.name}: {error}"]


def load(folder: Path) -> list[Specimen]:
    """The specimens of a folder."""
    listed = json.loads((folder / "specimens.json").read_text(encoding="utf-8"))
    return [read(folder, entry) for entry in listed["specimens"]]


def read(folder: Path, entry: dict) -> Specimen:
    """One entry of `specimens.json`."""
    others = ("files", "size", "link", "making", "templates", "cells")
    fields = {key: value for key, value in entry.items() if key not in others}
    files = {kind: folder / name for kind, name in entry["files"].items()}
    templates = tuple(
        Template(sections=tuple(map(tuple, part["sections"])), height=part["height"], strip=part["strip"])
        for part in entry["templates"]
    )
    cells = tuple(
        Cells(**{**each, "files": {kind: folder / name for kind, name in each["files"].items()}})
        for each in entry["cells"]
    )
    return Specimen(
        cells=cells,
        files=files,
        size=tuple(entry["size"]),
        product=entry["making"]["product"],
        templates=templates,
        **fields,
    )
