//! The surface of water in a pot, as triangles.

use glam::DVec2;

use super::fill::Level;
use super::outside::polygon_area;

/// A level surface: the polygons that the water's edge goes round, cut into triangles.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Pool {
    pub(crate) points: Vec<DVec2>,
    /// Anticlockwise from above.
    pub(crate) triangles: Vec<[u32; 3]>,
}

/// One end of a piece of the water's edge: a piece in the making joins roots of neighbouring columns.
type Strand = Vec<DVec2>;

impl Pool {
    pub(crate) fn new(level: &Level) -> Pool {
        let loops = edges(level);
        let depth = |i: usize| {
            let Some(&point) = loops[i].first() else { return 0 };
            (0..loops.len()).filter(|&j| j != i && contains(&loops[j], point)).count()
        };
        let depths: Vec<usize> = (0..loops.len()).map(depth).collect();
        let mut pool = Pool::default();
        for (i, outline) in loops.iter().enumerate().filter(|(i, _)| depths[*i].is_multiple_of(2)) {
            let mut points = outline.clone();
            let mut holes: Vec<u32> = Vec::new();
            for (j, hole) in loops.iter().enumerate() {
                if depths[j] == depths[i] + 1 && hole.first().is_some_and(|&point| contains(outline, point)) {
                    holes.push(points.len() as u32);
                    points.extend(hole);
                }
            }
            let mut indices: Vec<u32> = Vec::new();
            earcut::Earcut::new().earcut(points.iter().map(|p| p.to_array()), &holes, &mut indices);
            let base = pool.points.len() as u32;
            for triangle in indices.as_chunks::<3>().0 {
                let [a, b, c] = triangle.map(|index| points[index as usize]);
                let [i, j, k] = triangle.map(|index| index + base);
                pool.triangles.push(if (b - a).perp_dot(c - a) < 0.0 { [i, k, j] } else { [i, j, k] });
            }
            pool.points.extend(points);
        }
        pool
    }

    /// Adds its points, at their level, and its triangles to those of others.
    pub(crate) fn add(&self, level: f64, positions: &mut Vec<f32>, indices: &mut Vec<u32>) {
        let base = (positions.len() / 3) as u32;
        positions.extend(self.points.iter().flat_map(|p| [p.x as f32, p.y as f32, level as f32]));
        indices.extend(self.triangles.iter().flatten().map(|index| base + index));
    }
}

/// The closed curves in which the level meets the inside.
///
/// Each column meets it in an even number of places, or an odd one where the middle of the floor is under water. From one column to the next they go on in their order; where
/// two appear or disappear they are joined: there the edge turns back.
fn edges(level: &Level) -> Vec<Vec<DVec2>> {
    let columns: Vec<Vec<DVec2>> = level.columns.iter().map(|(column, wet)| level.roots(column, wet)).collect();
    let mut loops: Vec<Strand> = Vec::new();
    // Strands that are not closed, by number; `open` has one number for each root of the column that was reached.
    let mut strands: Vec<Option<Strand>> = Vec::new();
    let mut open: Vec<usize> = Vec::new();
    // Which strand and which of its ends a root of the first column is.
    let mut first: Vec<usize> = Vec::new();
    let mut joins: Vec<[(usize, bool); 2]> = Vec::new();
    for (index, roots) in columns.iter().enumerate() {
        if index == 0 {
            for root in roots {
                strands.push(Some(vec![*root]));
                open.push(strands.len() - 1);
            }
            first.clone_from(&open);
            continue;
        }
        while open.len() > roots.len() {
            // Of those that end here the closest pair is joined.
            let ends: Vec<DVec2> = open.iter().map(|&s| last(&strands, s)).collect();
            let Some(pair) = closest(&ends) else { break };
            joins.push([(open[pair], true), (open[pair + 1], true)]);
            open.drain(pair..pair + 2);
        }
        let mut new = roots.clone();
        let mut places: Vec<usize> = (0..roots.len()).collect();
        let mut begun = Vec::new();
        while new.len() > open.len() {
            let Some(pair) = closest(&new) else { break };
            begun.push((places[pair], places[pair + 1]));
            new.drain(pair..pair + 2);
            places.drain(pair..pair + 2);
        }
        let mut next = vec![usize::MAX; roots.len()];
        for (&place, &strand) in places.iter().zip(&open) {
            if let Some(Some(points)) = strands.get_mut(strand) {
                points.push(roots[place]);
            }
            next[place] = strand;
        }
        for (p, q) in begun {
            strands.push(Some(vec![roots[p]]));
            strands.push(Some(vec![roots[q]]));
            let n = strands.len();
            joins.push([(n - 2, false), (n - 1, false)]);
            (next[p], next[q]) = (n - 2, n - 1);
        }
        next.retain(|strand| *strand != usize::MAX);
        open = next;
    }
    // Once round, what is open goes on where the first column began.
    while open.len() > first.len() {
        let ends: Vec<DVec2> = open.iter().map(|&s| last(&strands, s)).collect();
        let Some(pair) = closest(&ends) else { break };
        joins.push([(open[pair], true), (open[pair + 1], true)]);
        open.drain(pair..pair + 2);
    }
    while first.len() > open.len() {
        let starts: Vec<DVec2> =
            first.iter().map(|&s| strands[s].as_ref().map_or(DVec2::ZERO, |strand| strand[0])).collect();
        let Some(pair) = closest(&starts) else { break };
        joins.push([(first[pair], false), (first[pair + 1], false)]);
        first.drain(pair..pair + 2);
    }
    joins.extend(open.iter().zip(&first).map(|(&end, &start)| [(end, true), (start, false)]));
    // Walk from strand to strand.
    let other = |end: (usize, bool)| {
        joins.iter().find_map(|&[x, y]| {
            if x == end {
                Some(y)
            } else if y == end {
                Some(x)
            } else {
                None
            }
        })
    };
    for start in 0..strands.len() {
        let (mut at, mut is_forward) = (start, true);
        let mut points: Strand = Vec::new();
        while let Some(strand) = strands[at].take() {
            points.extend(if is_forward { strand } else { strand.into_iter().rev().collect() });
            let Some((next, is_end)) = other((at, is_forward)) else { break };
            (at, is_forward) = (next, !is_end);
        }
        points.dedup();
        if points.first() == points.last() {
            points.pop();
        }
        if points.len() >= 3 && polygon_area(&points).is_finite() {
            loops.push(points);
        }
    }
    loops
}

fn last(strands: &[Option<Strand>], strand: usize) -> DVec2 {
    strands.get(strand).and_then(|strand| strand.as_ref()?.last().copied()).unwrap_or_default()
}

/// The first of the two neighbours in a list that are closest.
fn closest(points: &[DVec2]) -> Option<usize> {
    let gap = |i: usize| points[i].distance_squared(points[i + 1]);
    (0..points.len().saturating_sub(1)).min_by(|&i, &j| gap(i).total_cmp(&gap(j)))
}

/// Whether a polygon goes round a point.
fn contains(polygon: &[DVec2], point: DVec2) -> bool {
    let mut is_inside = false;
    for (i, p) in polygon.iter().enumerate() {
        let q = polygon[(i + 1) % polygon.len()];
        if (p.y > point.y) != (q.y > point.y) && point.x < p.x + (point.y - p.y) / (q.y - p.y) * (q.x - p.x) {
            is_inside = !is_inside;
        }
    }
    is_inside
}
