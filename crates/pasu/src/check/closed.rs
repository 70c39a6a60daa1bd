//! Whether triangles bound a body: closed, oriented, and like a surface at every vertex.

use crate::watch;

/// What closed triangles are like as a whole.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Topology {
    /// `V - E + F`: 2 for a ball or a cup, 0 for a ring, a tube or a cup with a drain.
    pub(crate) euler: i64,
    /// How many bodies, each connected by its edges.
    pub(crate) n_components: usize,
}

impl Topology {
    /// The number of handles of all components together.
    pub(crate) fn genus(&self) -> usize {
        ((2 * self.n_components as i64 - self.euler) / 2).max(0) as usize
    }
}

/// The topology of triangles over `n_vertices` vertices.
///
/// # Errors
/// A vertex where they are not closed: at an edge that two triangles do not share in opposite directions, at a vertex round which the triangles are more than one fan, or that no
/// triangle uses.
pub(crate) fn closed(triangles: &[[u32; 3]], n_vertices: usize) -> Result<Topology, u32> {
    // Every edge as a triangle passes it, by where it begins: where it ends, with the corner across from it.
    if let Some(vertex) = triangles.iter().flatten().find(|vertex| **vertex as usize >= n_vertices) {
        return Err(*vertex);
    }
    let mut first = vec![0usize; n_vertices + 1];
    for vertex in triangles.iter().flatten() {
        first[*vertex as usize + 1] += 1;
    }
    for vertex in 0..n_vertices {
        first[vertex + 1] += first[vertex];
    }
    let mut edges = vec![(0u32, 0u32); 3 * triangles.len()];
    let mut free = first.clone();
    for &[a, b, c] in triangles {
        watch::work(5);
        for (from, to, across) in [(a, b, c), (b, c, a), (c, a, b)] {
            let slot = &mut free[from as usize];
            edges[*slot] = (to, across);
            *slot += 1;
        }
    }
    for vertex in 0..n_vertices {
        watch::work(5);
        let fan = &mut edges[first[vertex]..first[vertex + 1]];
        fan.sort_unstable();
        if fan.windows(2).any(|pair| pair[0].0 == pair[1].0) {
            return Err(vertex as u32);
        }
    }
    let leads =
        |from: usize, to: u32| edges[first[from]..first[from + 1]].binary_search_by(|edge| edge.0.cmp(&to)).is_ok();
    for vertex in 0..n_vertices {
        watch::work(20);
        let is_closed = |(to, _): &(u32, u32)| *to as usize != vertex && leads(*to as usize, vertex as u32);
        let fan = &edges[first[vertex]..first[vertex + 1]];
        if !fan.iter().all(is_closed) {
            return Err(vertex as u32);
        }
    }
    for vertex in 0..n_vertices {
        watch::work(10);
        let fan = &edges[first[vertex]..first[vertex + 1]];
        let Some(start) = fan.first() else { return Err(vertex as u32) };
        // From one triangle at the vertex to the next, over their common edge.
        let (mut n, mut corner) = (0, start.0);
        loop {
            let Some(edge) = fan.binary_search_by(|edge| edge.0.cmp(&corner)).ok().map(|i| fan[i]) else {
                return Err(vertex as u32);
            };
            corner = edge.1;
            n += 1;
            if corner == start.0 || n > fan.len() {
                break;
            }
        }
        if n != fan.len() {
            return Err(vertex as u32);
        }
    }
    let n_components = components(triangles, n_vertices);
    let euler = n_vertices as i64 - edges.len() as i64 / 2 + triangles.len() as i64;
    Ok(Topology { euler, n_components })
}

/// The number of sets of vertices that triangles connect.
fn components(triangles: &[[u32; 3]], n_vertices: usize) -> usize {
    let mut parent: Vec<u32> = (0..n_vertices as u32).collect();
    fn root(parent: &mut [u32], mut vertex: u32) -> u32 {
        while parent[vertex as usize] != vertex {
            parent[vertex as usize] = parent[parent[vertex as usize] as usize];
            vertex = parent[vertex as usize];
        }
        vertex
    }
    let mut n = n_vertices;
    for [a, b, c] in triangles {
        for other in [b, c] {
            let (x, y) = (root(&mut parent, *a), root(&mut parent, *other));
            if x != y {
                parent[y as usize] = x;
                n -= 1;
            }
        }
    }
    n
}

#[cfg(test)]
mod tests {
    use super::*;

    const TETRAHEDRON: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];

    #[test]
    fn a_tetrahedron_is_closed() {
        let topology = closed(&TETRAHEDRON, 4).unwrap();
        assert_eq!((topology.euler, topology.n_components, topology.genus()), (2, 1, 0));
    }

    #[test]
    fn a_torus_has_a_handle() {
        let (n, m) = (5u32, 4u32);
        let at = |i: u32, j: u32| (i % n) * m + j % m;
        let triangles: Vec<[u32; 3]> = (0..n)
            .flat_map(|i| (0..m).map(move |j| (i, j)))
            .flat_map(|(i, j)| [[at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)]])
            .collect();
        let topology = closed(&triangles, 20).unwrap();
        assert_eq!((topology.euler, topology.genus()), (0, 1));
    }

    #[test]
    fn what_is_not_closed_is_found() {
        // A hole, a triangle turned round, a vertex that nothing uses, two bodies that share one vertex.
        assert!(closed(&TETRAHEDRON[..3], 4).is_err());
        assert!(closed(&[[0, 1, 2], [0, 1, 3], [1, 2, 3], [2, 0, 3]], 4).is_err());
        assert_eq!(closed(&TETRAHEDRON, 5), Err(4));
        let twin = TETRAHEDRON.map(|triangle| triangle.map(|v| if v == 0 { 0 } else { v + 3 }));
        assert_eq!(closed(&[TETRAHEDRON, twin].concat(), 7), Err(0));
        let apart = TETRAHEDRON.map(|triangle| triangle.map(|v| v + 4));
        assert_eq!(closed(&[TETRAHEDRON, apart].concat(), 8).unwrap().n_components, 2);
    }
}
