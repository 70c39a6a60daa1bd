"""Cells of solids: reading them by meshio, judging them by formulas of our own, and damaging them on purpose."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import meshio
import numpy

from specimens import Cells, Specimen

# The corners next to each corner of a hexahedron, right-handed where it is well shaped.
NEIGHBOURS = ((1, 3, 4), (2, 0, 5), (3, 1, 6), (0, 2, 7), (7, 5, 0), (4, 6, 1), (5, 7, 2), (6, 4, 3))
GAUSS = (0.5 - 0.5 / 3**0.5, 0.5 + 0.5 / 3**0.5)


def read(path: Path, shape: str) -> tuple[numpy.ndarray, numpy.ndarray, dict]:
    """Points, corners of the cells, and what the file says of each; there must be cells of one shape alone."""
    mesh = meshio.read(path)
    kinds = {"hexahedron": "hexahedron", "tetrahedron": "tetra"}
    if [block.type for block in mesh.cells] != [kinds[shape]]:
        raise ValueError(f"{path.name} has cells {[block.type for block in mesh.cells]}, not those of a {shape}")
    return mesh.points, mesh.cells[0].data, {name: numpy.ravel(values[0]) for name, values in mesh.cell_data.items()}


def volumes(points: numpy.ndarray, corners: numpy.ndarray) -> numpy.ndarray:
    """Of every cell: of a tetrahedron the determinant, of a trilinear hexahedron two Gauss points along each way."""
    p = points[corners]
    if p.shape[1] == 4:
        return numpy.linalg.det(p[:, 1:] - p[:, :1]) / 6
    total = numpy.zeros(len(p))
    for r in GAUSS:
        for s in GAUSS:
            for t in GAUSS:
                total += numpy.linalg.det(numpy.stack([side(p, axis, (r, s, t)) for axis in range(3)], axis=1)) / 8
    return total


# Where each corner stands in the unit cube.
CUBE = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))


def side(p: numpy.ndarray, axis: int, at: tuple[float, float, float]) -> numpy.ndarray:
    """The derivative of the trilinear map along an axis."""
    sum_of = numpy.zeros((len(p), 3))
    for index, corner in enumerate(CUBE):
        weight = 1.0 if corner[axis] else -1.0
        for other in range(3):
            if other != axis:
                weight *= at[other] if corner[other] else 1 - at[other]
        sum_of += weight * p[:, index]
    return sum_of


def qualities(points: numpy.ndarray, corners: numpy.ndarray) -> numpy.ndarray:
    """The scaled Jacobian of every hexahedron, the least over its corners and its middle."""
    p = points[corners]
    edges = [
        numpy.stack([p[:, other] - p[:, corner] for other in near], axis=1) for corner, near in enumerate(NEIGHBOURS)
    ]
    edges.append(numpy.stack([side(p, axis, (0.5, 0.5, 0.5)) for axis in range(3)], axis=1))
    scaled = [numpy.linalg.det(each) / numpy.prod(numpy.linalg.norm(each, axis=2), axis=1) for each in edges]
    return numpy.min(scaled, axis=0)


def damaged(specimen: Specimen, folder: Path, damage: str, change) -> Specimen:
    """A specimen whose first cells hold something else in their `.vtu`."""
    folder.mkdir(parents=True, exist_ok=True)
    first: Cells = specimen.cells[0]
    mesh = meshio.read(first.files["vtu"])
    points, corners = mesh.points.copy(), mesh.cells[0].data.copy()
    path = folder / f"{damage.replace(' ', '-')}.vtu"
    points, corners, data = change(points, corners, {name: values[0] for name, values in mesh.cell_data.items()})
    kind = mesh.cells[0].type
    meshio.Mesh(points, [(kind, corners)], cell_data={name: [values] for name, values in data.items()}).write(path)
    spoilt = replace(first, files={**first.files, "vtu": path})
    return replace(specimen, name=f"{specimen.name} {damage}", cells=(spoilt, *specimen.cells[1:]))


def without_a_cell(specimen: Specimen, folder: Path) -> Specimen:
    """A hole of one cell."""
    return damaged(
        specimen,
        folder,
        "without a cell",
        lambda points, corners, data: (points, corners[1:], {name: values[1:] for name, values in data.items()}),
    )


def with_a_cell_turned(specimen: Specimen, folder: Path) -> Specimen:
    """One cell inside out: its two layers of corners exchanged."""

    def turn(points: numpy.ndarray, corners: numpy.ndarray, data: dict):
        corners[0] = corners[0][[4, 5, 6, 7, 0, 1, 2, 3]]
        return points, corners, data

    return damaged(specimen, folder, "with a cell turned", turn)


def with_cells_folded(specimen: Specimen, folder: Path) -> Specimen:
    """A point away from the border beyond one of its neighbours: the cells between run through each other."""

    def fold(points: numpy.ndarray, corners: numpy.ndarray, data: dict):
        middle = numpy.flatnonzero((numpy.bincount(corners.ravel())[corners] == 8).all(axis=1))[0]
        one, other = corners[middle][[0, 1]]
        points[one] += 3 * (points[other] - points[one])
        return points, corners, data

    return damaged(specimen, folder, "with cells folded", fold)


def with_a_point_moved(specimen: Specimen, folder: Path) -> Specimen:
    """Cells that stay well shaped, one point a little off."""

    def move(points: numpy.ndarray, corners: numpy.ndarray, data: dict):
        points[corners[0][0]] += 1e-3 * numpy.linalg.norm(points[corners[0][1]] - points[corners[0][0]])
        return points, corners, data

    return damaged(specimen, folder, "with a point moved", move)
