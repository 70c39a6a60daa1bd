"""Binary STL: reading its triangles, and damaging it on purpose."""

from __future__ import annotations

from pathlib import Path

import numpy

from specimens import Specimen

RECORD = numpy.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
HEADER = 84


def read(path: Path) -> numpy.ndarray:
    """The records of a file."""
    data = path.read_bytes()
    count = int.from_bytes(data[80:84], "little")
    if len(data) != HEADER + count * RECORD.itemsize:
        raise ValueError(f"{path.name} has {len(data)} bytes, not those of {count} triangles")
    return numpy.frombuffer(data, RECORD, count, HEADER)


def welded(path: Path) -> tuple[numpy.ndarray, numpy.ndarray]:
    """Points and triangles; corners are one point where their numbers are the same to the bit, and only there."""
    corners = read(path)["corners"].reshape(-1, 3)
    points, index = numpy.unique(corners, axis=0, return_inverse=True)
    return points, index.reshape(-1, 3).astype(numpy.uint32)


def without_a_triangle(specimen: Specimen, folder: Path) -> Specimen:
    """A hole of one triangle."""
    return written(specimen, folder, read(specimen.files["stl"])[:-1], "without a triangle")


def inside_out(specimen: Specimen, folder: Path) -> Specimen:
    """Every triangle the other way round."""
    records = read(specimen.files["stl"]).copy()
    records["corners"] = records["corners"][:, ::-1]
    return written(specimen, folder, records, "inside out")


def a_hundredth_too_large(specimen: Specimen, folder: Path) -> Specimen:
    """The right form in the wrong size."""
    records = read(specimen.files["stl"]).copy()
    records["corners"] *= numpy.float32(1.01)
    return written(specimen, folder, records, "a hundredth too large")


def written(specimen: Specimen, folder: Path, records: numpy.ndarray, damage: str) -> Specimen:
    """A specimen whose STL holds these records."""
    path = folder / f"{damage.replace(' ', '-')}.stl"
    path.write_bytes(b"damaged".ljust(80) + len(records).to_bytes(4, "little") + records.tobytes())
    return specimen.with_file("stl", path, damage)
