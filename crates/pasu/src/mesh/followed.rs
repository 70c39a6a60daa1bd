//! The mesh of a network of patches after that of the same network with its points elsewhere: only what moved is sampled again.

use core::ops::Range;
use std::sync::Arc;

use super::contract::{Mesh, MeshOptions};
use super::grids::Grids;
use super::patches::PatchGrids;
use super::seams::{Corners, Seams};
use super::sewn::firsts;
use crate::error::Result;
use crate::patch::Lines;
use crate::solution::{Placed, Solution};

/// What a mesh of a network was made of.
///
/// Normals are kept as they were before they were smoothed: those of an edge are the mean of two patches, of which only one may have changed.
#[derive(Debug)]
pub(super) struct Followed {
    options: MeshOptions,
    placed: Arc<Placed>,
    lines: Vec<Lines>,
    firsts: Vec<usize>,
    /// Once something moved.
    corners: Option<Corners>,
    normals: Vec<[f32; 3]>,
}

impl Followed {
    /// What there is to follow of a mesh that is about to be filled; `None` of what is no single network of patches on rows and columns that were given: on others the lines are another question with every movement.
    pub(super) fn of(solution: &Solution, options: &MeshOptions, grids: &[Grids]) -> Option<Followed> {
        let is_given = options.tolerance.is_none() && options.rows.is_some() && options.columns.is_some();
        let [Grids::Patches(grids)] = grids else { return None };
        let placed = solution.part(0).ok().filter(|_| is_given)?;
        placed.solved().frame()?;
        let lines = grids.lines().to_vec();
        let firsts = firsts(&lines);
        Some(Followed {
            options: *options,
            placed: Arc::clone(placed),
            lines,
            firsts,
            corners: None,
            normals: Vec::new(),
        })
    }

    /// Where normals go as they are before they are smoothed.
    pub(super) fn normals_mut(&mut self) -> &mut Vec<[f32; 3]> {
        &mut self.normals
    }

    /// Samples what is elsewhere than before, and says which vertices may be, ascending. Every bit is that of a mesh that is sampled as a whole. `None` where it has to be.
    ///
    /// # Errors
    /// As [`PatchGrids::fill`]; the mesh is of no use then.
    pub(super) fn follow(
        &mut self,
        solution: &Solution,
        options: &MeshOptions,
        mesh: &mut Mesh,
    ) -> Result<Option<Vec<Range<usize>>>> {
        if *options != self.options || solution.n_parts() != 1 {
            return Ok(None);
        }
        let placed = Arc::clone(solution.part(0)?);
        let (Some(before), Some(now)) = (self.placed.solved().frame(), placed.solved().frame()) else {
            return Ok(None);
        };
        let is_there = (placed.matrix(), placed.shift()) == (self.placed.matrix(), self.placed.shift());
        let Some(changed) = now.changed_since(before).filter(|_| is_there) else { return Ok(None) };
        let (positions, normals) = (mesh.positions.as_chunks_mut::<3>().0, mesh.normals.as_chunks_mut::<3>().0);
        let grids = PatchGrids::of(&placed, core::mem::take(&mut self.lines));
        let filled = grids.fill_patches(changed.iter().copied(), &self.firsts, positions, &mut self.normals);
        self.lines = grids.into_lines();
        filled?;
        let patches = placed.solved().patches();
        let corners = &*self.corners.get_or_insert_with(|| Corners::of(&patches));
        let seams = Seams { patches: &patches, lines: &self.lines, firsts: &self.firsts };
        seams.close_some(&changed, corners, positions);
        let written = seams.smooth_some(&changed, corners, &self.normals, normals, now.crease());
        self.placed = Arc::clone(&placed);
        Ok(Some(self.joined(&written)))
    }

    /// The vertices of these patches, which ascend.
    fn joined(&self, patches: &[usize]) -> Vec<Range<usize>> {
        let mut ranges: Vec<Range<usize>> = Vec::new();
        for (lines, first) in patches.iter().filter_map(|patch| self.lines.get(*patch).zip(self.firsts.get(*patch))) {
            let range = *first..first + lines.n_vertices();
            match ranges.last_mut() {
                Some(last) if last.end == range.start => last.end = range.end,
                _ => ranges.push(range),
            }
        }
        ranges
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::Design;
    use crate::mesh::Sampler;

    /// Numbers from -1 to 1 that look random.
    fn dice(seed: &mut u64) -> f64 {
        *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*seed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    /// A sheet of `m x n` patches, or one that closes after `n` of them, as it stands or reversed. Its patches lie in any of the eight ways.
    fn network(m: usize, n: usize, wrap: Option<bool>, crease: f64, seed: &mut u64) -> Design {
        let across = 2 * n + 1;
        let number = |i: usize, j: usize| match wrap {
            Some(is_reversed) if j == 2 * n => across * if is_reversed { 2 * m - i } else { i },
            _ => across * i + j,
        };
        let point = |k: usize, seed: &mut u64| {
            let (i, j) = ((k / across) as f64, (k % across) as f64 / across as f64 * 6.0);
            let radius = if wrap.is_some() { 2.0 } else { 3.0 + j };
            [libm::cos(j) * radius, libm::sin(j) * radius, i].map(|x| x + 0.3 * dice(seed))
        };
        let vertices: Vec<[f64; 3]> = (0..across * (2 * m + 1)).map(|k| point(k, seed)).collect();
        let patch = |k: usize| {
            let (i, j) = (2 * (k / n), 2 * (k % n));
            let mut frame =
                [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)].map(|(a, b)| number(i + a, j + b));
            frame.rotate_left(2 * (k % 4));
            if k % 3 == 1 {
                frame[1..].reverse();
            }
            let force = if k % 5 == 2 { r#"{"f0":[0,1,2],"u":[0.2,0.9]}"# } else { "" };
            format!(r#"{{"frame":{frame:?},"a1":[1,2,{}],"forces":[{force}]}}"#, 1 + k % 4)
        };
        let patches: Vec<String> = (0..m * n).map(patch).collect();
        let text = format!(
            r#"{{"pasu":1,"parts":[{{"shape":{{"kind":"vertex-frame","vertices":{vertices:?},"patches":[{}],"crease":{crease}}},
            "place":{{"shift":[1,2,3],"scale":[1.5,0.7,1.2]}}}}]}}"#,
            patches.join(",")
        );
        Design::parse(&text).unwrap()
    }

    #[test]
    fn a_network_that_moves_has_the_bits_of_one_that_is_sampled_as_a_whole_and_says_where_it_is_another() {
        let mut seed = 7;
        let shapes = [
            (3, 4, None),
            (2, 5, Some(false)),
            (2, 4, Some(true)),
            (2, 2, Some(false)),
            (4, 2, Some(true)),
            (1, 2, Some(false)),
            (1, 1, None),
        ];
        let options = MeshOptions { rows: Some(40), columns: Some(40), tolerance: None };
        let mut spared = 0;
        for (round, (m, n, wrap)) in shapes.into_iter().cycle().take(42).enumerate() {
            let design = network(m, n, wrap, [0.5, 0.0, 3.0][round / 7 % 3], &mut seed);
            let (mut sampler, mut solution) = (Sampler::new(), Solution::of(&design));
            let mut before = sampler.sample_solution(&solution, &options).unwrap().clone();
            assert_eq!(before, solution.mesh(&options).unwrap());
            for _ in 0..6 {
                let count = (2 * m + 1) * (2 * n + 1);
                let which = ((dice(&mut seed) + 1.0) * 0.5 * count as f64) as usize;
                let at = [dice(&mut seed), dice(&mut seed), dice(&mut seed)].map(|x| 4.0 * x);
                let moved = solution.design().with_points(0, &[(which, at)]).unwrap();
                solution = solution.after(&moved);
                let Ok(whole) = solution.mesh(&options) else { continue };
                let now = sampler.sample_solution(&solution, &options).unwrap().clone();
                assert_eq!(now, whole, "{m} x {n}, {wrap:?}");
                assert_eq!(now, crate::mesh::mesh(&moved, &options).unwrap());
                let written = sampler.written();
                assert!(written.windows(2).all(|pair| pair[0].end < pair[1].start));
                for vertex in (0..now.n_vertices()).filter(|vertex| !written.iter().any(|range| range.contains(vertex)))
                {
                    let range = 3 * vertex..3 * vertex + 3;
                    assert_eq!(now.positions[range.clone()], before.positions[range.clone()]);
                    assert_eq!(now.normals[range.clone()], before.normals[range]);
                    spared += 1;
                }
                before = now;
            }
        }
        assert!(spared > 10_000, "{spared}");
    }

    #[test]
    fn what_is_no_longer_the_same_is_sampled_as_a_whole() {
        let mut seed = 3;
        let design = network(3, 3, None, 0.5, &mut seed);
        let options = MeshOptions { rows: Some(30), columns: Some(30), tolerance: None };
        let moved = |z: f64| design.with_points(0, &[(0, [0.0, 0.0, z])]).unwrap();
        let mut sampler = Sampler::new();
        let first = Solution::of(&design);
        sampler.sample_solution(&first, &options).unwrap();
        let is_whole = |sampler: &mut Sampler, solution: &Solution, options: &MeshOptions| {
            let n = sampler.sample_solution(solution, options).unwrap().n_vertices();
            matches!(sampler.written(), [all] if *all == (0..n))
        };
        let second = first.after(&moved(0.5));
        assert!(!is_whole(&mut sampler, &second, &options));
        // Nothing moved.
        assert!(sampler.sample_solution(&second, &options).is_ok() && sampler.written().is_empty());
        assert!(is_whole(&mut sampler, &second, &MeshOptions { rows: Some(31), ..options }));
        assert!(is_whole(&mut sampler, &second, &MeshOptions { rows: None, ..options }));
        assert!(is_whole(&mut sampler, &second, &options));
        // Solved by itself.
        assert!(is_whole(&mut sampler, &Solution::of(&moved(0.25)), &options));
        let placed = Design::parse(&moved(0.5).to_json().replace("[1,2,3]", "[1,2,4]")).unwrap();
        let third = second.after(&placed);
        sampler.sample_solution(&second, &options).unwrap();
        assert!(is_whole(&mut sampler, &third, &options));
        // A point beyond single precision leaves a sampler as good as new.
        let far = third.after(&placed.with_points(0, &[(0, [1e300, 0.0, 0.0])]).unwrap());
        assert!(sampler.sample_solution(&far, &options).is_err());
        assert!(is_whole(&mut sampler, &third, &options));
    }
}
