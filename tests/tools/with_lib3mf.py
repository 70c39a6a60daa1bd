"""lib3mf: the reference reader of 3MF takes the file without a warning, in millimetres, at the right size."""

import re
import zipfile
from collections.abc import Iterator
from pathlib import Path

import lib3mf
import numpy

import specimens
from specimens import Specimen, equal, near

MODEL = "3D/3dmodel.model"
IDENTITY = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, 0]]


def judge(specimen: Specimen) -> Iterator[str]:
    """Warnings, unit, objects, their placement and size."""
    library = lib3mf.get_wrapper()
    model = library.CreateModel()
    reader = model.QueryReader("3mf")
    reader.SetStrictModeActive(True)
    reader.ReadFromFile(str(specimen.files["3mf"]))
    for index in range(reader.GetWarningCount()):
        yield f"warning: {reader.GetWarning(index)}"
    yield from equal("unit", model.GetUnit(), lib3mf.ModelUnit.MilliMeter)
    yield from equal("has a thumbnail", model.HasPackageThumbnailAttachment(), True)

    items = model.GetBuildItems()
    meshes = []
    while items.MoveNext():
        item = items.GetCurrent()
        fields = [list(row) for row in item.GetObjectTransform().Fields]
        yield from equal(
            "placement", [list(row) for row in zip(*fields, strict=True)] if len(fields) == 3 else fields, IDENTITY
        )
        meshes.append(model.GetMeshObjectByID(item.GetObjectResource().GetResourceID()))
    yield from equal("number of objects", len(meshes), specimen.parts)
    for mesh in meshes:
        yield from equal("valid", mesh.IsValid(), True)
        yield from equal("manifold and oriented", mesh.IsManifoldAndOriented(), True)
    yield from equal("number of triangles", sum(mesh.GetTriangleCount() for mesh in meshes), specimen.triangles)
    points = numpy.array([vertex.Coordinates for mesh in meshes for vertex in mesh.GetVertices()])
    for axis, found, expected in zip("xyz", numpy.ptp(points, axis=0), specimen.size, strict=True):
        yield from near(f"size along {axis}", float(found), expected, 2 * specimen.bound + 1e-5 * expected)


def without_a_triangle(specimen: Specimen, folder: Path) -> Specimen:
    """A hole of one triangle."""
    return edited(specimen, folder, r"<triangle [^>]*/>", "", "without a triangle")


def in_inches(specimen: Specimen, folder: Path) -> Specimen:
    """The right numbers in the wrong unit."""
    return edited(specimen, folder, 'unit="millimeter"', 'unit="inch"', "in inches")


def edited(specimen: Specimen, folder: Path, pattern: str, by: str, damage: str) -> Specimen:
    """A specimen whose 3MF has another text in the first place that matches."""
    path = folder / f"{damage.replace(' ', '-')}.3mf"
    with zipfile.ZipFile(specimen.files["3mf"]) as old, zipfile.ZipFile(path, "w") as new:
        for name in old.namelist():
            data = old.read(name)
            if name == MODEL:
                text, count = re.subn(pattern, by, data.decode("utf-8"), count=1)
                if count != 1:
                    raise ValueError(f"{MODEL} has no {pattern}")
                data = text.encode("utf-8")
            new.writestr(name, data)
    return specimen.with_file("3mf", path, damage)


if __name__ == "__main__":
    specimens.main(
        "lib3mf",
        judge,
        {without_a_triangle: "manifold and oriented is False", in_inches: "unit is"},
        wanted=lambda specimen: "3mf" in specimen.files,
    )
