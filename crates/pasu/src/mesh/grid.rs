//! The triangles of a grid of vertices, which depend on its size alone.

/// Appends two triangles per cell of a `rows x columns` grid whose first vertex is number `base`.
///
/// With `outward` as `X_u x X_v` points, a cell is walked `u` first, then `v`; otherwise the other way round.
pub(super) fn append_triangles(indices: &mut Vec<u32>, base: u32, rows: u32, columns: u32, outward: bool) {
    let (first, n_cells) = (indices.len(), (rows as usize - 1) * (columns as usize - 1));
    indices.resize(first + 6 * n_cells, 0);
    let mut cells = indices[first..].as_chunks_mut::<6>().0.chunks_exact_mut(columns as usize - 1);
    for i in 0..rows - 1 {
        let Some(cells) = cells.next() else { break };
        for (j, cell) in (0..columns - 1).zip(cells) {
            let a = base + i * columns + j;
            let (b, c, d) = (a + columns, a + columns + 1, a + 1);
            *cell = if outward { [a, b, c, a, c, d] } else { [a, c, b, a, d, c] };
        }
    }
}

/// The same for one of several patches: where two of them have both sides of a corner in common, no triangle is cut off there that the other has too. For that the diagonals of the cells at all four corners run through these,
/// unless a cell is at two of them.
pub(super) fn append_patch(indices: &mut Vec<u32>, base: u32, rows: u32, columns: u32, outward: bool) {
    let first = indices.len();
    append_triangles(indices, base, rows, columns, outward);
    if rows < 3 || columns < 3 {
        return;
    }
    for (i, j) in [(rows - 2, 0), (0, columns - 2)] {
        let a = base + i * columns + j;
        let (b, c, d) = (a + columns, a + columns + 1, a + 1);
        let from = first + 6 * (i * (columns - 1) + j) as usize;
        let turned = if outward { [a, b, d, b, c, d] } else { [a, d, b, b, d, c] };
        if let Some(cell) = indices.get_mut(from..from + 6) {
            cell.copy_from_slice(&turned);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn diagonals_of_a_patch_run_through_its_corners() {
        for outward in [true, false] {
            let mut indices = vec![9];
            append_patch(&mut indices, 20, 4, 3, outward);
            assert_eq!(indices.len(), 1 + 6 * 3 * 2);
            // The vertices of the corners, each of which two triangles have.
            for corner in [20, 22, 29, 31] {
                assert_eq!(indices[1..].iter().filter(|vertex| **vertex == corner).count(), 2, "{corner}");
            }
            let mut edges: Vec<[u32; 2]> =
                indices[1..].chunks_exact(3).flat_map(|t| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]]).collect();
            edges.sort_unstable();
            let n = edges.len();
            edges.dedup();
            assert_eq!(edges.len(), n, "no edge is passed twice the same way");
        }
    }

    #[test]
    fn one_cell_both_ways() {
        let mut indices = Vec::new();
        append_triangles(&mut indices, 7, 2, 2, true);
        assert_eq!(indices, [7, 9, 10, 7, 10, 8]);
        indices.clear();
        append_triangles(&mut indices, 0, 2, 2, false);
        assert_eq!(indices, [0, 3, 2, 0, 1, 3]);
    }
}
