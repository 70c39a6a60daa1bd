"""meshio: cells come back from every format as they are, as many as there are, and fill the solid."""

from collections.abc import Iterator

import numpy

import cells
import specimens
from specimens import Cells, Specimen, equal, near

# A polygon in the place of the outline takes so much away, at the coarser and the finer cut.
STRAIGHT = (0.04, 0.011)


def judge(specimen: Specimen) -> Iterator[str]:
    """Each shape and fineness in each format."""
    for each in specimen.cells:
        for fault in judge_cells(each, specimen.clay_volume):
            yield f"{each.shape}, {each.fineness}: {fault}"


def judge_cells(each: Cells, volume: float) -> Iterator[str]:
    """Counts, the same points and corners everywhere, volume, orientation, scaled Jacobian."""
    first = None
    for kind, path in sorted(each.files.items(), reverse=True):
        points, corners, told = cells.read(path, each.shape)
        yield from equal(f"{kind}: number of points", len(points), each.points)
        yield from equal(f"{kind}: number of cells", len(corners), each.cells)
        if first is None:
            first = points, corners
        yield from equal(f"{kind}: points as in vtu", bool(numpy.array_equal(points, first[0])), True)
        yield from equal(f"{kind}: corners as in vtu", bool(numpy.array_equal(corners, first[1])), True)
        if kind != "inp" and each.shape == "hexahedron":
            off = numpy.max(numpy.abs(told["scaled_jacobian"] - cells.qualities(points, corners)))
            yield from near(f"{kind}: scaled Jacobian is off by", float(off), 0.0, 1e-9)
    points, corners = first
    used = numpy.unique(corners)
    yield from equal("points that no cell has", len(points) - len(used), 0)
    found = cells.volumes(points, corners)
    yield from equal("cells inside out", int(numpy.sum(found <= 0)), 0)
    yield from near("volume", float(numpy.sum(found)), each.volume, 1e-9 * each.volume)
    yield from near("volume of the solid", float(numpy.sum(found)), volume, STRAIGHT[each.fineness] * volume)


if __name__ == "__main__":
    specimens.main(
        "meshio",
        judge,
        {
            cells.without_a_cell: "hexahedron, 0: vtu: number of cells",
            cells.with_a_cell_turned: "hexahedron, 0: cells inside out is 1",
            cells.with_a_point_moved: "hexahedron, 0: msh: points as in vtu is False",
        },
        wanted=lambda specimen: len(specimen.cells) > 0,
    )
