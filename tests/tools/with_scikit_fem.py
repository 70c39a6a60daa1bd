"""scikit-fem: Laplace's equation on the hexahedra, with a formula on the border, has the formula inside."""

from collections.abc import Iterator
from itertools import pairwise

import meshio
import numpy
import skfem
from skfem.helpers import dot, grad
from skfem.io.meshio import from_meshio

import cells
import specimens
from specimens import Cells, Specimen, near


def flat(x: numpy.ndarray) -> numpy.ndarray:
    """What trilinear cells hold exactly, whatever they look like."""
    return 2 * x[0] - x[1] + 3 * x[2] + 1


def wavy(x: numpy.ndarray) -> numpy.ndarray:
    """Harmonic, and no polynomial: coordinates are in parts of the size of the solid."""
    return numpy.exp(1.5 * x[0]) * numpy.sin(1.2 * x[1]) * numpy.cos(0.9 * x[2])


@skfem.BilinearForm
def laplace(u, v, _):
    """The weak form."""
    return dot(grad(u), grad(v))


@skfem.Functional
def squared(w):
    """Of the difference from the formula, which is that of the corners between them."""
    return (w["found"] - wavy(w.x)) ** 2


def judge(specimen: Specimen) -> Iterator[str]:
    """A field that is exact, and one that comes nearer with the square of the size of the cells."""
    errors = []
    for each in specimen.cells:
        if each.shape != "hexahedron":
            continue
        basis = basis_of(each)
        found = solved(basis, flat)
        yield from near(
            f"{each.fineness}: a linear field is off by", float(numpy.abs(found - flat(basis.doflocs)).max()), 0, 1e-9
        )
        found = solved(basis, wavy)
        volume = skfem.Functional(lambda w: 1.0 + 0.0 * w.x[0]).assemble(basis)
        errors.append(float((squared.assemble(basis, found=basis.interpolate(found)) / volume) ** 0.5))
    for coarse, fine in pairwise(errors):
        # Of the second order a quarter is left; the block amid a round solid is no refinement of the coarser one.
        yield from near("error of the finer cells in parts of that of the coarser", fine / coarse, 0.25, 0.08)
        yield from near("error of the finer cells", fine, 0, 2e-3)


def basis_of(each: Cells) -> skfem.CellBasis:
    """Trilinear functions on the cells of the file, which is scaled to the size of 1."""
    mesh = from_meshio(meshio.read(each.files["vtu"]))
    size = float(numpy.ptp(mesh.p, axis=1).max())
    mesh = type(mesh)(mesh.p / size, mesh.t)
    return skfem.CellBasis(mesh, skfem.ElementHex1(), intorder=4)


def solved(basis: skfem.CellBasis, formula) -> numpy.ndarray:
    """Laplace's equation with the formula on the border."""
    border = basis.get_dofs()
    values = formula(basis.doflocs)
    return skfem.solve(*skfem.condense(laplace.assemble(basis), x=values, D=border))


if __name__ == "__main__":
    specimens.main(
        "scikit-fem",
        judge,
        {cells.with_cells_folded: "0: a linear field is off by"},
        wanted=lambda specimen: any(each.shape == "hexahedron" for each in specimen.cells),
    )
