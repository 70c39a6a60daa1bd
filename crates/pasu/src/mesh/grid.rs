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

#[cfg(test)]
mod tests {
    use super::*;

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
