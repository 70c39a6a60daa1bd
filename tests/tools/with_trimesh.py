"""trimesh: STL, OBJ, PLY and GLB hold the same watertight mesh at the same size, OBJ with its materials and PLY the same colours."""

import tempfile
import zipfile
from collections.abc import Iterator
from pathlib import Path

import trimesh

import specimens
import triangles
from specimens import Specimen, equal, near

# What one unit of the file is in millimetres, and which axis points up.
FORMATS = {"stl": (1.0, 2), "obj": (1.0, 2), "ply": (1.0, 2), "glb": (1000.0, 1)}


def judge(specimen: Specimen) -> Iterator[str]:
    """Watertight, oriented, of the right volume, area and size, in each format."""
    for kind, (unit, up) in FORMATS.items():
        if kind in specimen.files:
            for fault in judge_file(specimen, specimen.files[kind], unit, up):
                yield f"{kind}: {fault}"
    if "ply" in specimen.files and "obj.zip" in specimen.files:
        yield from equal("colours", colours_of_ply(specimen.files["ply"]), colours_of_obj(specimen.files["obj.zip"]))


def colours_of_ply(path: Path) -> set[tuple[int, ...]]:
    """Of all vertices."""
    mesh = trimesh.load(path, force="mesh", process=False)
    return {tuple(map(int, colour[:3])) for colour in mesh.visual.vertex_colors}


def colours_of_obj(path: Path) -> set[tuple[int, ...]]:
    """Of the materials of all objects."""
    with tempfile.TemporaryDirectory() as folder:
        with zipfile.ZipFile(path) as package:
            package.extractall(folder)
        scene = trimesh.load(Path(folder) / "pasu.obj", force="scene", process=False)
    return {tuple(map(int, mesh.visual.material.diffuse[:3])) for mesh in scene.geometry.values()}


def judge_file(specimen: Specimen, path: Path, unit: float, up: int) -> Iterator[str]:
    """One file."""
    mesh = trimesh.load(path, force="mesh", process=False)
    # Corners that stand at the same place to the bit are one; nothing is moved, nothing left out.
    mesh.merge_vertices(merge_tex=True, merge_norm=True, digits_vertex=12)
    yield from equal("watertight", bool(mesh.is_watertight), True)
    yield from equal("winding consistent", bool(mesh.is_winding_consistent), True)
    yield from equal("number of triangles", len(mesh.faces), specimen.triangles)
    # A GLB is turned and scaled by its reader, in single precision for all we know.
    yield from near("volume", mesh.volume * unit**3, specimen.mesh_volume, 1e-5 * specimen.mesh_volume)
    yield from near("area", mesh.area * unit**2, specimen.mesh_area, 1e-5 * specimen.mesh_area)
    x, y, z = (float(extent) * unit for extent in mesh.extents)
    found = (x, y, z) if up == 2 else (x, z, y)
    for axis, one, expected in zip("xyz", found, specimen.size, strict=True):
        yield from near(f"size along {axis}", one, expected, 2 * specimen.bound + 1e-5 * expected)


if __name__ == "__main__":
    specimens.main(
        "trimesh",
        judge,
        {
            triangles.without_a_triangle: "stl: watertight is False",
            triangles.inside_out: "stl: volume is -",
            triangles.a_hundredth_too_large: "stl: size along z",
        },
        wanted=lambda specimen: "stl" in specimen.files,
    )
