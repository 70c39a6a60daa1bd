"""Manifold: every mesh is a closed oriented 2-manifold of the right volume."""

from collections.abc import Iterator

from manifold3d import Error, Manifold, Mesh

import specimens
import triangles
from specimens import Specimen, equal, near


def judge(specimen: Specimen) -> Iterator[str]:
    """Status, count of triangles and of bodies, volume and area."""
    points, corners = triangles.welded(specimen.files["stl"])
    solid = Manifold(Mesh(vert_properties=points, tri_verts=corners))
    yield from equal("status", solid.status(), Error.NoError)
    yield from equal("number of triangles", solid.num_tri(), specimen.triangles)
    yield from near("volume", solid.volume(), specimen.mesh_volume, 1e-5 * specimen.mesh_volume)
    yield from near("area", solid.surface_area(), specimen.mesh_area, 1e-5 * specimen.mesh_area)
    # A layer as thick as the triangles may be off, on both sides of the wall.
    layer = specimen.mesh_area * specimen.bound
    yield from near(
        "volume", solid.volume(), specimen.clay_volume, layer + specimen.clay_error + 1e-6 * specimen.clay_volume
    )
    yield from equal("number of bodies", len(solid.decompose()), specimen.parts)


if __name__ == "__main__":
    specimens.main(
        "Manifold",
        judge,
        {
            triangles.without_a_triangle: "status is Error.NotManifold",
            triangles.inside_out: "volume is -",
            triangles.a_hundredth_too_large: "volume",
        },
        wanted=lambda specimen: "stl" in specimen.files,
    )
