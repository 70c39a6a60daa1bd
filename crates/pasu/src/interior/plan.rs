//! How a section is cut into quadrilaterals: the same for every layer of cells.

use core::f64::consts::{FRAC_PI_4, TAU};

/// Places of a section with the quadrilaterals between them, which go round as `u` turns towards `v`.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Plan {
    /// `(u, v)`.
    pub(super) places: Vec<[f64; 2]>,
    pub(super) quads: Vec<[u32; 4]>,
}

/// How large the block in the middle of a round section is, in parts of the radius.
const CORE: f64 = 0.5;

/// How far the sides of that block are bent towards a circle.
const BULGE: f64 = 0.4;

impl Plan {
    /// Of a section that is a square in `(u, v)`.
    pub(super) fn square([n_u, n_v]: [usize; 2]) -> Plan {
        let places = (0..=n_u).flat_map(|i| (0..=n_v).map(move |j| [i as f64 / n_u as f64, j as f64 / n_v as f64]));
        let at = |i: usize, j: usize| (i * (n_v + 1) + j) as u32;
        let quads =
            (0..n_u).flat_map(|i| (0..n_v).map(move |j| [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]));
        Plan { places: places.collect(), quads: quads.collect() }
    }

    /// Of a section that closes round a pole, `u` from there and `v` turns: a block in the middle with a ring of `n_u` cells round it, of which each goes round with as many as the block has sides' cells. A pole would
    /// have cells without volume.
    pub(super) fn round([n_u, n_v]: [usize; 2]) -> Plan {
        let n = n_v.div_ceil(4);
        let mut plan = Plan::default();
        let core = |i: usize, j: usize| (i * (n + 1) + j) as u32;
        for i in 0..=n {
            for j in 0..=n {
                let [s, t] = [i, j].map(|k| (2 * k) as f64 / n as f64 - 1.0);
                plan.places.push(polar(in_block(s, t)));
            }
        }
        // The block as a plane has s to the right and t upwards, which turns as u towards v does.
        plan.quads.extend(
            (0..n).flat_map(|i| (0..n).map(move |j| [core(i, j), core(i + 1, j), core(i + 1, j + 1), core(i, j + 1)])),
        );
        // The border of the block, once round from its corner s = t = -1.
        let border: Vec<[usize; 2]> = (0..4 * n)
            .map(|k| match (k / n, k % n) {
                (0, i) => [i, 0],
                (1, j) => [n, j],
                (2, i) => [n - i, n],
                (_, j) => [0, n - j],
            })
            .collect();
        let first = plan.places.len();
        for step in 1..=n_u {
            let share = step as f64 / n_u as f64;
            for (k, [i, j]) in border.iter().enumerate() {
                let [s, t] = [*i, *j].map(|k| (2 * k) as f64 / n as f64 - 1.0);
                let inner = in_block(s, t);
                let angle = -3.0 * FRAC_PI_4 + TAU * k as f64 / (4 * n) as f64;
                let outer = [libm::cos(angle), libm::sin(angle)];
                let place = if step == n_u {
                    // On the skin itself, to the bit.
                    [1.0, turns(k as f64 / (4 * n) as f64 - 0.375)]
                } else {
                    polar([0, 1].map(|axis| inner[axis] + share * (outer[axis] - inner[axis])))
                };
                plan.places.push(place);
            }
        }
        let ring = |step: usize, k: usize| match step {
            0 => {
                let [i, j] = border[k % border.len()];
                core(i, j)
            }
            _ => (first + (step - 1) * border.len() + k % border.len()) as u32,
        };
        for step in 0..n_u {
            let quads =
                (0..border.len()).map(|k| [ring(step, k), ring(step + 1, k), ring(step + 1, k + 1), ring(step, k + 1)]);
            plan.quads.extend(quads);
        }
        plan
    }

    /// The triangles that the quadrilaterals are cut into, from the corner of the least number, so that neighbours agree.
    pub(super) fn triangles(&self) -> impl Iterator<Item = [u32; 3]> + '_ {
        self.quads.iter().flat_map(|quad| {
            let least = (0..4).min_by_key(|corner| quad[*corner]).unwrap_or(0);
            let [a, b, c, d] = [0, 1, 2, 3].map(|step| quad[(least + step) % 4]);
            [[a, b, c], [a, c, d]]
        })
    }
}

/// A point of the block in the middle, `s` and `t` from -1 to 1: a square at the very middle, and ever more of a circle towards its border.
fn in_block(s: f64, t: f64) -> [f64; 2] {
    let far = s.abs().max(t.abs());
    if far == 0.0 {
        return [0.0; 2];
    }
    let to_circle = far * core::f64::consts::SQRT_2 * 0.5 * 1.3 / libm::hypot(s, t);
    let bent = BULGE * far;
    [s, t].map(|x| CORE * ((1.0 - bent) * x + bent * x * to_circle))
}

/// `(u, v)` of a point of the unit disc.
fn polar([x, y]: [f64; 2]) -> [f64; 2] {
    [libm::hypot(x, y), turns(libm::atan2(y, x) / TAU)]
}

/// In [0, 1).
fn turns(v: f64) -> f64 {
    let v = v - libm::floor(v);
    if v < 1.0 { v } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Twice the area of a quadrilateral in the plane of the parameters of a disc.
    fn doubled_area(plan: &Plan, quad: [u32; 4]) -> f64 {
        let point = |index: u32| {
            let [u, v] = plan.places[index as usize];
            [u * (TAU * v).cos(), u * (TAU * v).sin()]
        };
        let corners = quad.map(point);
        (0..4).map(|i| (corners[i], corners[(i + 1) % 4])).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum()
    }

    #[test]
    fn a_round_plan_covers_the_disc_once_without_a_pole() {
        for counts in [[1, 4], [2, 8], [3, 13], [8, 64]] {
            let plan = Plan::round(counts);
            let areas: Vec<f64> = plan.quads.iter().map(|quad| doubled_area(&plan, *quad)).collect();
            assert!(areas.iter().all(|area| *area > 0.0), "{counts:?}");
            // The polygon of the border.
            let n = 4 * counts[1].div_ceil(4);
            let expected = n as f64 * (TAU / n as f64).sin();
            assert!((areas.iter().sum::<f64>() - expected).abs() < 1e-12, "{counts:?}");
            // Euler: every edge inside is of two quadrilaterals, turned against each other.
            let mut edges = std::collections::BTreeMap::new();
            for quad in &plan.quads {
                for side in 0..4 {
                    *edges.entry((quad[side], quad[(side + 1) % 4])).or_insert(0) += 1;
                }
            }
            assert!(edges.values().all(|count| *count == 1));
            let open = edges.keys().filter(|(a, b)| !edges.contains_key(&(*b, *a))).count();
            assert_eq!(open, n);
        }
    }

    #[test]
    fn a_square_plan_is_a_grid() {
        let plan = Plan::square([2, 3]);
        assert_eq!((plan.places.len(), plan.quads.len()), (12, 6));
        assert_eq!((plan.places[0], plan.places[11], plan.quads[0]), ([0.0, 0.0], [1.0, 1.0], [0, 4, 5, 1]));
        assert_eq!(plan.triangles().count(), 12);
    }
}
