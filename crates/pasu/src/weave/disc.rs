//! Triangles of a level disc or annulus whose outline is seen from nowhere as a whole.

use glam::DVec2;
use spade::{ConstrainedDelaunayTriangulation, HasPosition, Point2, Triangulation};

/// A point of the plan with its number in the mesh.
#[derive(Debug, Clone, Copy)]
struct Corner {
    at: Point2<f64>,
    vertex: u32,
}

impl HasPosition for Corner {
    type Scalar = f64;

    fn position(&self) -> Point2<f64> {
        self.at
    }
}

/// The triangles, anti-clockwise in the plan, between closed outlines: the constrained Delaunay triangulation, of which that is kept which an odd number of
/// outlines goes round. Every vertex is used and no edge is split, so that neighbours fit.
///
/// # Errors
/// Where outlines cross or touch: the number of a vertex beside that place.
pub(crate) fn triangles(outlines: &[Vec<(DVec2, u32)>]) -> Result<Vec<[u32; 3]>, u32> {
    let mut corners = Vec::new();
    let mut edges = Vec::new();
    for outline in outlines {
        let first = corners.len();
        corners.extend(outline.iter().map(|(at, vertex)| Corner { at: Point2::new(at.x, at.y), vertex: *vertex }));
        edges.extend((0..outline.len()).map(|i| [first + i, first + (i + 1) % outline.len()]));
    }
    let (n_corners, n_edges) = (corners.len(), edges.len());
    let numbers: Vec<u32> = corners.iter().map(|corner| corner.vertex).collect();
    let touching = touching(&corners);
    let mut conflict = None;
    let plan = ConstrainedDelaunayTriangulation::<Corner>::try_bulk_load_cdt(corners, edges, |[from, _]| {
        conflict.get_or_insert(from);
    });
    let anywhere = touching.or(conflict.map(|corner| numbers[corner])).or(numbers.first().copied()).unwrap_or(0);
    let Some(plan) = plan
        .ok()
        .filter(|plan| conflict.is_none() && plan.num_vertices() == n_corners && plan.num_constraints() == n_edges)
    else {
        return Err(anywhere);
    };
    // From outside inwards, counting the outlines that are crossed.
    let mut depth = vec![None; plan.num_all_faces()];
    let outer = plan.outer_face().fix();
    depth[outer.index()] = Some(0usize);
    let mut queue = std::collections::VecDeque::from([outer]);
    let mut neighbours = vec![Vec::new(); plan.num_all_faces()];
    for edge in plan.undirected_edges() {
        let [a, b] = [edge.as_directed(), edge.as_directed().rev()].map(|edge| edge.face().fix());
        let step = usize::from(plan.is_constraint_edge(edge.fix()));
        neighbours[a.index()].push((b, step));
        neighbours[b.index()].push((a, step));
    }
    while let Some(face) = queue.pop_front() {
        let Some(here) = depth[face.index()] else { return Err(anywhere) };
        for &(other, step) in &neighbours[face.index()] {
            if depth[other.index()].is_none() {
                depth[other.index()] = Some(here + step);
                queue.push_back(other);
            }
        }
    }
    let mut triangles = Vec::with_capacity(plan.num_inner_faces());
    for face in plan.inner_faces() {
        if depth[face.fix().index()].is_some_and(|depth| depth % 2 == 1) {
            let [a, b, c] = face.vertices().map(|vertex| vertex.data().vertex);
            // In an order that depends on nothing but the vertices.
            triangles.push([[a, b, c], [b, c, a], [c, a, b]].into_iter().min().unwrap_or([a, b, c]));
        }
    }
    triangles.sort_unstable();
    Ok(triangles)
}

/// A vertex at whose place there is another.
fn touching(corners: &[Corner]) -> Option<u32> {
    let mut places: Vec<([f64; 2], u32)> =
        corners.iter().map(|corner| ([corner.at.x, corner.at.y], corner.vertex)).collect();
    places.sort_by(|(a, _), (b, _)| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    places.array_windows().find(|[(a, _), (b, _)]| a == b).map(|[(_, vertex), _]| *vertex)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(points: &[(DVec2, u32)], triangles: &[[u32; 3]]) -> f64 {
        let at = |vertex: u32| points.iter().find(|(_, v)| *v == vertex).unwrap().0;
        triangles
            .iter()
            .map(|[a, b, c]| {
                let area = 0.5 * (at(*b) - at(*a)).perp_dot(at(*c) - at(*a));
                assert!(area > 0.0);
                area
            })
            .sum()
    }

    #[test]
    fn a_comb_with_a_hole_keeps_every_vertex() {
        // Collinear vertices among them, at which neighbours have theirs.
        let outer: Vec<(DVec2, u32)> = [(0, 0), (3, 0), (6, 0), (6, 4), (5, 4), (5, 1), (4, 1), (4, 4), (3, 4), (0, 4)]
            .iter()
            .zip(10..)
            .map(|((x, y), vertex)| (DVec2::new(f64::from(*x), f64::from(*y)), vertex))
            .collect();
        let inner: Vec<(DVec2, u32)> = [(1, 1), (1, 2), (2, 2), (2, 1)]
            .iter()
            .zip(30..)
            .map(|((x, y), vertex)| (DVec2::new(f64::from(*x), f64::from(*y)), vertex))
            .collect();
        let found = triangles(&[outer.clone(), inner.clone()]).unwrap();
        let all = [outer, inner].concat();
        assert_eq!(area(&all, &found), 24.0 - 3.0 - 1.0);
        assert_eq!(found.len(), all.len());
        for (_, vertex) in &all {
            assert!(found.iter().flatten().any(|v| v == vertex));
        }
    }

    #[test]
    fn outlines_that_cross_are_refused() {
        // An eight at the end of a long tail: the place is one of the eight, not of the tail.
        let outline = [(0, 0), (2, 2), (2, 0), (0, 2), (-100, 2), (-200, 1), (-100, 0)];
        let outline: Vec<_> =
            outline.iter().zip(10..).map(|((x, y), v)| (DVec2::new(f64::from(*x), f64::from(*y)), v)).collect();
        let vertex = triangles(&[outline]).unwrap_err();
        assert!((10..14).contains(&vertex), "{vertex}");
    }

    #[test]
    fn outlines_that_touch_are_refused_where_they_touch() {
        let two = [[(0, 0), (2, 0), (1, 1)], [(1, 1), (2, 2), (0, 2)]];
        let mut number = 0..;
        let two = two.map(|outline| {
            outline
                .iter()
                .zip(number.by_ref())
                .map(|((x, y), v)| (DVec2::new(f64::from(*x), f64::from(*y)), v))
                .collect()
        });
        assert!(triangles(&two).is_err_and(|vertex| vertex == 2 || vertex == 3));
    }
}
