//! Which places of the grid of the curved side are one vertex, and where that is.

use std::collections::HashMap;

use glam::DVec3;

use super::weaver::Weaver;

/// The place of a vertex in the grid: places that fall on one line of a rod are one vertex.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Spot {
    Own(usize, usize),
    /// What is thin all round; the number is 1 plus that of the plane in which an edge is, 0 within.
    Core(usize),
    /// Of the rod along an axis: so far from its tip by lines.
    Rod(usize, usize),
}

impl Weaver {
    /// The vertex of each place of the grid.
    pub(super) fn vertices(&mut self, at: &[Vec<DVec3>], n: usize, m: usize) -> Vec<Vec<u32>> {
        let least = self.least;
        // Beyond twice as much a place is as far from the rod as that is thick.
        let thin = |at: DVec3| [0, 1, 2].map(|axis| at[axis] < 2.0 * least);
        let inner = || (1..n).flat_map(|i| (1..m).map(move |j| (i, j)));
        // From where on the lines round a corner of the grid go through what is thin all round.
        let mut cores = [usize::MAX; 2];
        for (i, j) in inner().filter(|(i, j)| thin(at[*i][*j]) == [true; 3]) {
            let round = [(n - i).max(m - j), (n - i).max(j)];
            cores = [0, 1].map(|k| cores[k].min(round[k]));
        }
        let is_inner = |i: usize, j: usize| 0 < i && i < n && 0 < j && j < m;
        let spot = |i: usize, j: usize| {
            let [x, y, z] = thin(at[i][j]);
            let plane = if i == n { 2 } else { usize::from(j == m) };
            match (i, j) {
                (0, _) => Spot::Own(0, 0),
                (i, j) if i == n && (j == 0 || j == m) => Spot::Own(i, j),
                _ if !is_inner(i, j) && x && y && z => Spot::Core(1 + plane),
                _ if !is_inner(i, j) => Spot::Own(i, j),
                _ => match [x, y, z] {
                    [true, true, true] => Spot::Core(0),
                    [true, true, false] => Spot::Rod(2, i),
                    [false, true, true] => {
                        let round = (n - i).max(m - j);
                        if round >= cores[0] { Spot::Core(0) } else { Spot::Rod(0, round) }
                    }
                    [true, false, true] => {
                        let round = (n - i).max(j);
                        if round >= cores[1] { Spot::Core(0) } else { Spot::Rod(1, round) }
                    }
                    _ => Spot::Own(i, j),
                },
            }
        };
        let mut known: HashMap<Spot, u32> = HashMap::new();
        let mut vertices = vec![vec![0u32; m + 1]; n + 1];
        for (i, row) in at.iter().enumerate() {
            let mut before: Option<(DVec3, u32)> = None;
            for (j, own) in row.iter().enumerate() {
                let is_tip = i == 0 || (i == n && (j == 0 || j == m));
                // In which planes it is.
                let within = [j == 0, j == m, i == n];
                let kept: [f64; 3] = core::array::from_fn(|axis| match within[axis] || is_tip {
                    true => own[axis],
                    false => own[axis].max(least),
                });
                let place = DVec3::from_array(kept);
                self.is_lifted |= place != *own;
                let spot = spot(i, j);
                // Round a needle at the first tip the places of a row are closer and closer.
                let is_own = spot == Spot::Own(i, j) && is_inner(i, j);
                let is_near = |last: DVec3| {
                    let step = last.distance(place);
                    // Within a blade it is of no matter where its places are: all that is round it is as thin.
                    let is_in_blade = |axis: usize| {
                        let round = at[i - 1..=i + 1].iter().flat_map(|row| &row[j - 1..=j + 1]);
                        round.into_iter().all(|at| thin(*at)[axis])
                    };
                    let gap = || own.distance(at[i - 1][j]).min(own.distance(at[i + 1][j]));
                    step < 0.5 * least || ((0..3).any(is_in_blade) && step < 0.125 * gap())
                };
                if let Some((_, vertex)) = before.filter(|(last, _)| is_own && is_near(*last)) {
                    vertices[i][j] = vertex;
                    continue;
                }
                let vertex = *known.entry(spot).or_insert_with(|| {
                    self.places.push(place);
                    self.places.len() as u32 - 1
                });
                before = is_own.then_some((place, vertex));
                // Of all that fall on one place of a rod that which is furthest from its tip.
                let there = &mut self.places[vertex as usize];
                *there = there.min(place);
                vertices[i][j] = vertex;
            }
        }
        vertices
    }
}
