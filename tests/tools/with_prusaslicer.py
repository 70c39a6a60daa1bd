"""PrusaSlicer: STL and 3MF are manifold without repair and of the right size, and what is sliced stays so."""

import re
import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import specimens
import triangles
from specimens import Specimen, equal, near

PROGRAM = "prusa-slicer"

# Lines of `--info` that are only there when something was repaired or had to be.
REPAIRS = (
    "open_edges",
    "degenerate_facets",
    "edges_fixed",
    "facets_removed",
    "facets_reversed",
    "backwards_edges",
)

# Millimetres. Large enough for every specimen; the pot stands in the middle.
BED = 600
EXTRUSION = 1.0
LAYER = 0.6

OPTIONS = (
    f"--bed-shape=0x0,{BED}x0,{BED}x{BED},0x{BED}",
    f"--center={BED // 2},{BED // 2}",
    f"--max-print-height={BED}",
    "--nozzle-diameter=1",
    f"--extrusion-width={EXTRUSION}",
    f"--first-layer-extrusion-width={EXTRUSION}",
    f"--external-perimeter-extrusion-width={EXTRUSION}",
    f"--layer-height={LAYER}",
    f"--first-layer-height={LAYER}",
    "--skirts=0",
    "--fill-density=0",
    "--no-ensure-vertical-shell-thickness",
    # The wider generator and the search for a hidden seam take five times as long.
    "--perimeter-generator=classic",
    "--seam-position=rear",
)
HOLLOW = ("--perimeters=1", "--top-solid-layers=1", "--bottom-solid-layers=1")
VASE = ("--spiral-vase", "--perimeters=1", "--top-solid-layers=0", "--bottom-solid-layers=1")


def judge(specimen: Specimen) -> Iterator[str]:
    """What PrusaSlicer says of each file, and where it would lay the clay or plastic."""
    for kind in ("stl", "3mf"):
        if kind in specimen.files:
            for fault in judge_file(specimen, specimen.files[kind]):
                yield f"{kind}: {fault}"
    if specimen.slice:
        # What is made for vase mode is sliced from every file that a slicer reads.
        for kind in ("stl", "3mf") if specimen.product == "solid" else ("stl",):
            if kind in specimen.files:
                for fault in judge_sliced(specimen, specimen.files[kind]):
                    yield f"G-code: {fault} (from {kind})"


def judge_file(specimen: Specimen, path: Path) -> Iterator[str]:
    """What it tells of one file."""
    # One section for each object, under the name of the file.
    sections = run("--info", str(path)).split(f"[{path.name}]")[1:]
    told = [dict(re.findall(r"^(\w+) = +(\S+)$", section, re.MULTILINE)) for section in sections]
    for one in told:
        yield from equal("manifold", one.get("manifold"), "yes")
        for repair in REPAIRS:
            yield from equal(repair, one.get(repair), None)
    yield from equal("number of triangles", sum(int(one["number_of_facets"]) for one in told), specimen.triangles)
    # Its volume is summed in single precision.
    volume = sum(float(one["volume"]) for one in told)
    yield from near("volume", volume, specimen.mesh_volume, 1e-3 * specimen.mesh_volume)
    for axis, expected in zip("xyz", specimen.size, strict=True):
        found = max(float(one[f"max_{axis}"]) for one in told) - min(float(one[f"min_{axis}"]) for one in told)
        yield from near(f"size along {axis}", found, expected, 2 * specimen.bound + 1e-5 * expected + 1e-6)


def judge_sliced(specimen: Specimen, model: Path) -> Iterator[str]:
    """The middle of the outermost strand runs half its width within the surface; the last layer ends near the top."""
    product = VASE if specimen.product == "solid" else HOLLOW
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "sliced.gcode"
        run(*OPTIONS, *product, "--export-gcode", f"--output={path}", str(model))
        least, most = extents(path.read_text(encoding="utf-8", errors="replace"))
    for index, axis in enumerate("xy"):
        found = most[index] - least[index] + EXTRUSION
        yield from near(f"width along {axis}", found, specimen.size[index], 0.5 * EXTRUSION + 2 * specimen.bound)
    yield from near("height", most[2], specimen.size[2], LAYER + 2 * specimen.bound)


def extents(gcode: str) -> tuple[list[float], list[float]]:
    """The smallest and largest coordinates of all moves that lay material."""
    at = [0.0, 0.0, 0.0]
    least, most = [float("inf")] * 3, [float("-inf")] * 3
    extruded = 0.0
    for line in gcode.splitlines():
        words = dict(re.findall(r"([GXYZE])(-?[\d.]+)", line.split(";")[0]))
        if words.get("G") == "92":
            extruded = float(words.get("E", extruded))
        if words.get("G") not in ("0", "1"):
            continue
        before = list(at)
        for index, axis in enumerate("XYZ"):
            at[index] = float(words.get(axis, at[index]))
        end = float(words.get("E", extruded))
        if end > extruded and at[:2] != before[:2]:
            for index in range(3):
                least[index] = min(least[index], before[index], at[index])
                most[index] = max(most[index], before[index], at[index])
        extruded = end
    return least, most


def run(*arguments: str) -> str:
    """Runs it without a screen and returns what it prints."""
    command = [shutil.which(PROGRAM) or PROGRAM, "--loglevel=1", *arguments]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"it ended with {done.returncode}: {done.stdout[-300:]} {done.stderr[-300:]}")
    return done.stdout


def sliced_at_another_size(specimen: Specimen, folder: Path) -> Specimen:
    """Only the G-code can tell: the files are as they were, and another width is expected of what is sliced."""
    large = triangles.a_hundredth_too_large(specimen, folder)
    return replace(large, size=tuple(0.9 * width for width in specimen.size), slice=True)


if __name__ == "__main__":
    specimens.main(
        "PrusaSlicer",
        judge,
        {
            triangles.without_a_triangle: "stl: manifold is no",
            triangles.inside_out: "stl: facets_reversed",
            triangles.a_hundredth_too_large: "stl: size along z",
            sliced_at_another_size: "G-code: width along x",
        },
        wanted=lambda specimen: "stl" in specimen.files,
    )
