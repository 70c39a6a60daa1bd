//! Which edges a network has, and which goes on as which.

use std::collections::HashMap;

/// The places in a frame of the three points of each side, in the order of the parameter that runs along it: `u = 0`, `u = 1`, `v = 0`, `v = 1`.
const SIDES: [[usize; 3]; 4] = [[0, 7, 6], [2, 3, 4], [0, 1, 2], [6, 5, 4]];

/// An edge, and whether what has it runs against it.
pub(super) type Link = (usize, bool);

/// The edges of a network.
pub(super) struct Edges {
    /// First vertex, middle and last.
    pub(super) points: Vec<[usize; 3]>,
    /// For each patch the edges of its sides.
    pub(super) of_patch: Vec<[Link; 4]>,
    /// For each edge the patches along it, each with the number of its side.
    pub(super) patches: Vec<Vec<(usize, usize)>>,
    /// For each vertex the edges that end there.
    ends: HashMap<usize, Vec<usize>>,
}

/// Edges one after the other, and whether the last goes on as the first.
pub(super) struct Chain {
    pub(super) links: Vec<Link>,
    pub(super) is_round: bool,
}

impl Edges {
    pub(super) fn of(frames: &[[usize; 8]]) -> Edges {
        let mut known = HashMap::new();
        let mut edges = Edges { points: Vec::new(), of_patch: Vec::new(), patches: Vec::new(), ends: HashMap::new() };
        for (patch, frame) in frames.iter().enumerate() {
            let mut sides = [(0, false); 4];
            for (side, places) in SIDES.into_iter().enumerate() {
                let [from, middle, to] = places.map(|place| frame[place]);
                let edge = *known.entry((from.min(to), middle, from.max(to))).or_insert_with(|| {
                    edges.points.push([from, middle, to]);
                    edges.patches.push(Vec::new());
                    edges.points.len() - 1
                });
                if edges.patches[edge].is_empty() {
                    [from, to].iter().for_each(|end| edges.ends.entry(*end).or_default().push(edge));
                }
                edges.patches[edge].push((patch, side));
                sides[side] = (edge, edges.points[edge][0] != from);
            }
            edges.of_patch.push(sides);
        }
        edges
    }

    pub(super) fn len(&self) -> usize {
        self.points.len()
    }

    /// The vertex at which a link begins.
    pub(super) fn start(&self, (edge, is_against): Link) -> usize {
        self.points[edge][if is_against { 2 } else { 0 }]
    }

    /// The vertex at which a link ends.
    pub(super) fn end(&self, (edge, is_against): Link) -> usize {
        self.start((edge, !is_against))
    }

    pub(super) fn is_free(&self, edge: usize) -> bool {
        self.patches[edge].len() == 1
    }

    /// Whether surfaces go straight on through a vertex: four patches lie round it, or two on a rim.
    pub(super) fn is_regular(&self, vertex: usize) -> bool {
        let ends = &self.ends[&vertex];
        let is_on_rim = ends.iter().any(|edge| self.is_free(*edge));
        ends.len() == if is_on_rim { 3 } else { 4 }
    }

    /// What a link goes on as: the one other edge at its end with which it has no patch in common.
    fn next(&self, link: Link) -> Option<Link> {
        let vertex = self.end(link);
        let apart = |one: usize| {
            let of = |edge: usize| self.patches[edge].iter().map(|(patch, _)| *patch);
            let others = self.ends[&vertex].iter().copied().filter(move |other| *other != one);
            let mut apart = others.filter(|other| of(*other).all(|patch| of(one).all(|own| own != patch)));
            apart.next().filter(|_| apart.next().is_none())
        };
        let next = apart(link.0).filter(|next| apart(*next) == Some(link.0))?;
        Some((next, self.points[next][0] != vertex))
    }

    /// All edges, each in one chain, as far as it goes straight on: through vertices round which four patches lie, and along rims between two patches.
    pub(super) fn chains(&self) -> Vec<Chain> {
        let mut is_done = vec![false; self.len()];
        let mut chains = Vec::new();
        for start in 0..self.len() {
            if is_done[start] {
                continue;
            }
            // Back to where the chain begins, or all round.
            let mut first = (start, true);
            let mut is_round = false;
            while let Some(next) = self.next(first) {
                if next.0 == start {
                    is_round = true;
                    first = (start, true);
                    break;
                }
                first = next;
            }
            let mut links = vec![(first.0, !first.1)];
            while let Some(next) = self.next(links[links.len() - 1]).filter(|next| next.0 != links[0].0) {
                links.push(next);
            }
            links.iter().for_each(|(edge, _)| is_done[*edge] = true);
            chains.push(Chain { links, is_round });
        }
        chains
    }

    /// Lengths and middles (each of 0 to 1 in the direction of its edge), the same for all edges of a strip: of edges that lie opposite each other in a patch, their means.
    pub(super) fn even(&self, lengths: &[f64], middles: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let (mut even_lengths, mut even_middles) = (vec![0.0; self.len()], vec![0.5; self.len()]);
        let mut is_done = vec![false; self.len()];
        for start in 0..self.len() {
            if is_done[start] {
                continue;
            }
            is_done[start] = true;
            let mut strip = vec![(start, false)];
            let mut next = 0;
            while let Some((edge, is_turned)) = strip.get(next).copied() {
                next += 1;
                for (patch, side) in &self.patches[edge] {
                    let sides = &self.of_patch[*patch];
                    let (other, is_against) = sides[side ^ 1];
                    if !is_done[other] {
                        is_done[other] = true;
                        strip.push((other, is_turned ^ sides[*side].1 ^ is_against));
                    }
                }
            }
            let n = strip.len() as f64;
            let length = strip.iter().map(|(edge, _)| lengths[*edge]).sum::<f64>() / n;
            let turned = |is_turned: bool, middle: f64| if is_turned { 1.0 - middle } else { middle };
            let middle = strip.iter().map(|(edge, is_turned)| turned(*is_turned, middles[*edge])).sum::<f64>() / n;
            for (edge, is_turned) in strip {
                (even_lengths[edge], even_middles[edge]) = (length, turned(is_turned, middle));
            }
        }
        (even_lengths, even_middles)
    }
}
