//! The triangles of an octant that thins out, on a grid of its curved side.

use glam::{DVec2, DVec3};

use super::flat_side::{FlatSide, OnAxis, OnEdge, strips};
use super::weaver::{Triangle, Weaver};

impl Weaver {
    /// The mesh on a grid of the curved side; `None` of one of less than three rows or columns.
    pub(super) fn woven(grid: &[Vec<DVec3>], stretch: DVec3, least: f64) -> Option<Weaver> {
        let (n, m) = (grid.len() - 1, grid.first()?.len() - 1);
        if n < 2 || m < 2 {
            return None;
        }
        let mut weaver = Weaver { places: Vec::new(), triangles: Vec::new(), is_lifted: false, least };
        let vertices = weaver.vertices(grid, n, m);
        weaver.curved(&vertices, n, m);
        // From the tip of the second axis to that of the first: the edge, and whether a triangle that goes round from the first axis to the second is seen from inside.
        let edges = [
            (1, [1, 2], true, (0..=n).map(|i| (i, 0)).collect::<Vec<_>>()),
            (2, [0, 2], false, (0..=n).map(|i| (i, m)).collect()),
            (3, [0, 1], true, (0..=m).map(|j| (n, j)).collect()),
        ];
        let chains: Vec<Vec<OnEdge>> = edges
            .iter()
            .map(|(_, [to, from], _, all)| {
                let mut chain: Vec<OnEdge> = Vec::new();
                for (i, j) in all {
                    let vertex = vertices[*i][*j];
                    let place = weaver.places[vertex as usize];
                    if chain.last().is_none_or(|last| last.vertex != vertex) {
                        chain.push(OnEdge { vertex, at: DVec2::new(place[*to], place[*from]) });
                    }
                }
                chain
            })
            .collect();
        if chains.iter().any(|chain| chain.len() < 3) {
            return None;
        }
        let origin = weaver.vertex(DVec3::ZERO);
        // Each axis has the places of the strips on both of its sides.
        let axes = [0, 1, 2].map(|axis| {
            let mut places: Vec<f64> = Vec::new();
            for ((_, [to, from], ..), chain) in edges.iter().zip(&chains) {
                let last = chain.len() - 1;
                if *to == axis {
                    places.extend(chain[strips(chain)[1].max(1)..last].iter().map(|own| own.at.x));
                } else if *from == axis {
                    places.extend(chain[1..(strips(chain)[0] + 1).min(last)].iter().map(|own| own.at.y));
                }
            }
            places.sort_by(f64::total_cmp);
            let mut kept: Vec<OnAxis> = vec![OnAxis { vertex: origin, at: 0.0 }];
            for at in places {
                if at - kept[kept.len() - 1].at >= least && stretch[axis] - at >= least {
                    let mut place = DVec3::ZERO;
                    place[axis] = at;
                    kept.push(OnAxis { vertex: weaver.vertex(place), at });
                }
            }
            kept
        });
        for ((patch, [to, from], is_inward, _), chain) in edges.iter().zip(&chains) {
            let last = chain.len() - 1;
            let [before, after] = strips(chain).map(|k| k.clamp(1, last - 1));
            let mut flat = FlatSide { weaver: &mut weaver, patch: *patch, is_inward: *is_inward };
            flat.strip(&axes[*to], &chain[after..]);
            for k in before..after {
                flat.add([origin, chain[k + 1].vertex, chain[k].vertex]);
            }
            flat.is_inward = !is_inward;
            let backwards: Vec<OnEdge> = chain[..=before]
                .iter()
                .rev()
                .map(|own| OnEdge { at: DVec2::new(own.at.y, own.at.x), ..*own })
                .collect();
            flat.strip(&axes[*from], &backwards);
        }
        Some(weaver)
    }

    fn curved(&mut self, vertices: &[Vec<u32>], n: usize, m: usize) {
        for i in 0..n {
            for j in 0..m {
                let [a, b, c, d] = [vertices[i][j], vertices[i + 1][j], vertices[i + 1][j + 1], vertices[i][j + 1]];
                // The diagonals at all four corners of the grid run through these.
                let is_turned = (i + 1 == n && j == 0) || (i == 0 && j + 1 == m);
                let both = if is_turned { [[a, d, b], [b, d, c]] } else { [[a, c, b], [a, d, c]] };
                self.triangles.extend(both.map(|corners| Triangle { corners, patch: 0 }));
            }
        }
        self.triangles.retain(|Triangle { corners: [a, b, c], .. }| a != b && b != c && c != a);
    }
}
