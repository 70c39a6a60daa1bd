"""OpenCASCADE: a STEP file is exactly one valid closed solid per part, of the right volume and size, in millimetres."""

import re
from collections.abc import Iterator
from pathlib import Path

from OCP.Bnd import Bnd_Box
from OCP.BRep import BRep_Tool
from OCP.BRepBndLib import BRepBndLib
from OCP.BRepCheck import BRepCheck_Analyzer
from OCP.BRepGProp import BRepGProp
from OCP.GProp import GProp_GProps
from OCP.IFSelect import IFSelect_ReturnStatus
from OCP.Message import Message
from OCP.STEPControl import STEPControl_Reader
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopExp import TopExp_Explorer
from OCP.TopoDS import TopoDS_Shape

import specimens
from specimens import Specimen, equal, near


def judge(specimen: Specimen) -> Iterator[str]:
    """Solids, shells, validity, volume and size."""
    reader = STEPControl_Reader()
    yield from equal("status", reader.ReadFile(str(specimen.files["step"])), IFSelect_ReturnStatus.IFSelect_RetDone)
    reader.TransferRoots()
    shape = reader.OneShape()
    solids = list(explored(shape, TopAbs_ShapeEnum.TopAbs_SOLID))
    yield from equal("number of solids", len(solids), specimen.parts)
    within = sum(count(solid, TopAbs_ShapeEnum.TopAbs_FACE) for solid in solids)
    yield from equal("number of faces outside the solids", count(shape, TopAbs_ShapeEnum.TopAbs_FACE) - within, 0)
    for solid in solids:
        yield from equal("valid", BRepCheck_Analyzer(solid).IsValid(), True)
        for shell in explored(solid, TopAbs_ShapeEnum.TopAbs_SHELL):
            yield from equal("shell closed", BRep_Tool.IsClosed_s(shell), True)
    properties = GProp_GProps()
    # Without the third argument the number of points is fixed, and too small for fluted walls.
    BRepGProp.VolumeProperties_s(shape, properties, 1e-4, False, False)
    yield from near("volume", properties.Mass(), specimen.clay_volume, 1e-3 * specimen.clay_volume)
    box = Bnd_Box()
    BRepBndLib.AddOptimal_s(shape, box, False, False)
    least, most = box.CornerMin(), box.CornerMax()
    found = (most.X() - least.X(), most.Y() - least.Y(), most.Z() - least.Z())
    for axis, one, expected in zip("xyz", found, specimen.size, strict=True):
        yield from near(f"size along {axis}", one, expected, 2 * specimen.bound + 1e-3 * expected)


def explored(shape: TopoDS_Shape, kind: TopAbs_ShapeEnum) -> Iterator[TopoDS_Shape]:
    """All shapes of a kind within a shape."""
    explorer = TopExp_Explorer(shape, kind)
    while explorer.More():
        yield explorer.Current()
        explorer.Next()


def count(shape: TopoDS_Shape, kind: TopAbs_ShapeEnum) -> int:
    """How many there are."""
    return sum(1 for _ in explored(shape, kind))


def without_a_face(specimen: Specimen, folder: Path) -> Specimen:
    """A shell that lacks the first of its faces."""
    return edited(specimen, folder, r"(CLOSED_SHELL\s*\(\s*'[^']*'\s*,\s*\(\s*)#\d+\s*,", r"\1", "without a face")


def in_metres(specimen: Specimen, folder: Path) -> Specimen:
    """The right numbers in the wrong unit."""
    return edited(specimen, folder, r"SI_UNIT\s*\(\s*\.MILLI\.\s*,\s*\.METRE\.\s*\)", "SI_UNIT($,.METRE.)", "in metres")


def edited(specimen: Specimen, folder: Path, pattern: str, by: str, damage: str) -> Specimen:
    """A specimen whose STEP file has another text in the first place that matches."""
    text, changes = re.subn(pattern, by, specimen.files["step"].read_text(encoding="ascii"), count=1)
    if changes != 1:
        raise ValueError(f"the file has no {pattern}")
    path = folder / f"{damage.replace(' ', '-')}.step"
    path.write_text(text, encoding="ascii")
    return specimen.with_file("step", path, damage)


if __name__ == "__main__":
    # It tells at length of every step of its work.
    for printer in list(Message.DefaultMessenger_s().Printers()):
        Message.DefaultMessenger_s().RemovePrinter(printer)
    specimens.main(
        "OpenCASCADE",
        judge,
        {without_a_face: "number of solids is 0", in_metres: "volume"},
        wanted=lambda specimen: "step" in specimen.files,
    )
