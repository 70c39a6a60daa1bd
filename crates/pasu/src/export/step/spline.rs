//! Cubic splines through points, as B-splines.

use glam::DVec3;

/// How a spline ends.
pub(super) enum Ends {
    /// With these derivatives, at the first and the last point.
    Slopes(DVec3, DVec3),
    /// In itself: the last point repeats the first, and so do the first two derivatives.
    Closed,
    /// With the derivatives of the cubics through its first and its last four points.
    Open,
}

/// The control points of the cubic spline with `f(nodes[i]) = points[i]`: two more than there are points, over the knots of [`knots`].
///
/// Twice continuously differentiable, off by `O(h^4)` from a smooth curve (de Boor, *A practical guide to splines*, chapter IV). `nodes` ascend; there are at least
/// two, four when closed or open. The slopes `m` at the nodes solve
/// `h_i m_(i-1) + 2 (h_(i-1) + h_i) m_i + h_(i-1) m_(i+1) = 3 (h_i d_(i-1) + h_(i-1) d_i)`, `h` the steps and `d` the divided differences, and a control point is the blossom at three nodes in a row.
pub(super) fn control_points(nodes: &[f64], points: &[DVec3], ends: &Ends) -> Vec<DVec3> {
    let slopes = match ends {
        Ends::Slopes(start, end) => slopes_between(nodes, points, *start, *end),
        Ends::Closed => closed_slopes(nodes, points),
        Ends::Open => {
            let last = nodes.len() - 1;
            let [start, end] = [[0, 1, 2, 3], [last, last - 1, last - 2, last - 3]]
                .map(|places| slope_of_cubic(places.map(|i| nodes[i]), places.map(|i| points[i])));
            slopes_between(nodes, points, start, end)
        }
    };
    let last = nodes.len() - 1;
    let mut control = Vec::with_capacity(nodes.len() + 2);
    control.push(points[0]);
    control.push(points[0] + (nodes[1] - nodes[0]) / 3.0 * slopes[0]);
    for i in 1..last {
        let (before, after) = (nodes[i] - nodes[i - 1], nodes[i + 1] - nodes[i]);
        let near = points[i] + after / 3.0 * slopes[i];
        let far = points[i + 1] - after / 3.0 * slopes[i + 1];
        control.push(near - before / after * (far - near));
    }
    control.push(points[last] - (nodes[last] - nodes[last - 1]) / 3.0 * slopes[last]);
    control.push(points[last]);
    control
}

/// The control points of the part of a spline between two nodes, as a spline of its own.
///
/// Blossoms at three nodes in a row within the part stay; at its ends stand the point there and a third of the step along its tangent.
pub(super) fn restricted(nodes: &[f64], control: &[DVec3], from: usize, to: usize) -> Vec<DVec3> {
    let last = nodes.len() - 1;
    // The same numbers whether a part begins or ends at a node, and for a closed spline at its first and at its last.
    let at = |node: usize| {
        let interval = node.min(last - 1);
        basis(nodes, interval, nodes[node])
            .into_iter()
            .enumerate()
            .fold((DVec3::ZERO, DVec3::ZERO), |sum, (r, (b, d))| {
                (sum.0 + b * control[interval + r], sum.1 + d * control[interval + r])
            })
    };
    let end = |node: usize| match node {
        0 => control[0],
        _ if node == last => control[last + 2],
        _ => at(node).0,
    };
    let mut part = vec![end(from)];
    part.push(if from == 0 { control[1] } else { end(from) + (nodes[from + 1] - nodes[from]) / 3.0 * at(from).1 });
    part.extend_from_slice(&control[from + 2..to + 1]);
    part.push(if to == last { control[last + 1] } else { end(to) - (nodes[to] - nodes[to - 1]) / 3.0 * at(to).1 });
    part.push(end(to));
    part
}

/// Each knot once, and how often it counts: four times at both ends.
pub(super) fn multiplicities(n_nodes: usize) -> Vec<usize> {
    (0..n_nodes).map(|i| if i == 0 || i + 1 == n_nodes { 4 } else { 1 }).collect()
}

/// The four basis functions that are not zero at `x` in the interval `[nodes[interval], nodes[interval + 1]]` and their derivatives; they belong to the control
/// points from number `interval` on (Cox and de Boor).
pub(super) fn basis(nodes: &[f64], interval: usize, x: f64) -> [(f64, f64); 4] {
    let last = nodes.len() - 1;
    let knot = |offset: isize| {
        let index = interval as isize + offset;
        nodes[index.clamp(0, last as isize) as usize]
    };
    let mut values = [1.0, 0.0, 0.0, 0.0];
    let mut lower = values;
    for degree in 1..=3usize {
        lower = values;
        let mut carried = 0.0;
        for r in 0..degree {
            let (left, right) = (knot(r as isize + 1 - degree as isize), knot(r as isize + 1));
            let part = lower[r] / (right - left);
            values[r] = carried + (right - x) * part;
            carried = (x - left) * part;
        }
        values[degree] = carried;
    }
    // The derivative of a cubic is three times a difference of quadratics over their spans.
    let span = |r: usize| knot(r as isize + 1) - knot(r as isize - 2);
    let quotient = |r: usize| if r < 3 { 3.0 * lower[r] / span(r) } else { 0.0 };
    [0, 1, 2, 3].map(|r| (values[r], if r == 0 { -quotient(0) } else { quotient(r - 1) - quotient(r) }))
}

/// The derivative at the first of four points of the cubic through them (Newton).
fn slope_of_cubic(nodes: [f64; 4], points: [DVec3; 4]) -> DVec3 {
    let mut differences = points;
    let mut slope = DVec3::ZERO;
    let mut factor = 1.0;
    for order in 1..4 {
        for i in 0..4 - order {
            differences[i] = (differences[i + 1] - differences[i]) / (nodes[i + order] - nodes[i]);
        }
        slope += factor * differences[0];
        factor *= nodes[0] - nodes[order];
    }
    slope
}

/// Solves the equations of [`control_points`] by elimination, which is stable: each diagonal outweighs the rest of its row.
fn slopes_between(nodes: &[f64], points: &[DVec3], start: DVec3, end: DVec3) -> Vec<DVec3> {
    let last = nodes.len() - 1;
    let mut slopes = vec![start; last + 1];
    slopes[last] = end;
    if last < 2 {
        return slopes;
    }
    let rows: Vec<Row> = (1..last).map(|i| Row::at(nodes, points, i - 1, i, i + 1, 0.0)).collect();
    let mut sides: Vec<DVec3> = rows.iter().map(|row| row.side).collect();
    sides[0] -= rows[0].before * start;
    sides[last - 2] -= rows[last - 2].after * end;
    let solved = eliminated(&rows, &sides);
    slopes[1..last].copy_from_slice(&solved);
    slopes
}

/// The same for a closed curve: the equation at the seam is the last row, and its unknown is taken out first (Sherman and Morrison).
fn closed_slopes(nodes: &[f64], points: &[DVec3]) -> Vec<DVec3> {
    let last = nodes.len() - 1;
    let length = nodes[last] - nodes[0];
    let seam = Row::at(nodes, points, last - 1, 0, 1, length);
    let rows: Vec<Row> = (1..last).map(|i| Row::at(nodes, points, i - 1, i, i + 1, 0.0)).collect();
    // With the slope m at the seam the others are `of_sides - m * of_seam`.
    let of_sides = eliminated(&rows, &rows.iter().map(|row| row.side).collect::<Vec<_>>());
    let mut couplings = vec![DVec3::ZERO; rows.len()];
    couplings[0] += DVec3::splat(rows[0].before);
    couplings[rows.len() - 1] += DVec3::splat(rows[rows.len() - 1].after);
    let of_seam = eliminated(&rows, &couplings);
    let n = rows.len();
    let diagonal = seam.middle - seam.before * of_seam[n - 1].x - seam.after * of_seam[0].x;
    let at_seam = (seam.side - seam.before * of_sides[n - 1] - seam.after * of_sides[0]) / diagonal;
    let mut slopes = vec![at_seam; last + 1];
    for i in 0..n {
        slopes[i + 1] = of_sides[i] - at_seam * of_seam[i];
    }
    slopes
}

/// One equation.
struct Row {
    before: f64,
    middle: f64,
    after: f64,
    side: DVec3,
}

impl Row {
    /// At node `at` between two others; `period` is added to the steps that pass the seam.
    fn at(nodes: &[f64], points: &[DVec3], before: usize, at: usize, after: usize, period: f64) -> Row {
        let wrap = if before > at { period } else { 0.0 };
        let (h, k) = (nodes[at] + wrap - nodes[before], nodes[after] - nodes[at]);
        let (left, right) = ((points[at] - points[before]) / h, (points[after] - points[at]) / k);
        Row { before: k, middle: 2.0 * (h + k), after: h, side: 3.0 * (k * left + h * right) }
    }
}

/// A tridiagonal system without the couplings beyond its ends.
fn eliminated(rows: &[Row], sides: &[DVec3]) -> Vec<DVec3> {
    let mut factors = Vec::with_capacity(rows.len());
    let mut values: Vec<DVec3> = Vec::with_capacity(rows.len());
    for (i, row) in rows.iter().enumerate() {
        let (before, value) = if i > 0 { (row.before, values[i - 1]) } else { (0.0, DVec3::ZERO) };
        let pivot = row.middle - before * factors.last().copied().unwrap_or(0.0);
        factors.push(row.after / pivot);
        values.push((sides[i] - before * value) / pivot);
    }
    for i in (0..rows.len().saturating_sub(1)).rev() {
        let next = values[i + 1];
        values[i] -= factors[i] * next;
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(nodes: &[f64], control: &[DVec3], interval: usize, x: f64) -> (DVec3, DVec3) {
        basis(nodes, interval, x).iter().enumerate().fold((DVec3::ZERO, DVec3::ZERO), |(value, slope), (r, (b, d))| {
            (value + *b * control[interval + r], slope + *d * control[interval + r])
        })
    }

    #[test]
    fn cubics_are_reproduced() {
        let cubic = |x: f64| DVec3::new(1.0 - 2.0 * x + x * x * x, x * x, 3.0 * x * x * x - x);
        let slope = |x: f64| DVec3::new(-2.0 + 3.0 * x * x, 2.0 * x, 9.0 * x * x - 1.0);
        for nodes in [vec![0.0, 1.0], vec![0.0, 0.3, 1.0], vec![0.0, 0.1, 0.15, 0.6, 1.0]] {
            let points: Vec<DVec3> = nodes.iter().map(|x| cubic(*x)).collect();
            let mut ends = vec![Ends::Slopes(slope(0.0), slope(1.0))];
            if nodes.len() > 3 {
                ends.push(Ends::Open);
            }
            for (interval, ends) in (0..nodes.len() - 1).flat_map(|i| ends.iter().map(move |ends| (i, ends))) {
                let control = control_points(&nodes, &points, ends);
                for part in [0.0, 0.25, 0.7, 1.0] {
                    let x = nodes[interval] + part * (nodes[interval + 1] - nodes[interval]);
                    let (found, found_slope) = value(&nodes, &control, interval, x);
                    assert!((found - cubic(x)).length() < 1e-14);
                    assert!((found_slope - slope(x)).length() < 1e-13);
                }
            }
        }
    }

    #[test]
    fn a_part_of_a_spline_is_that_spline() {
        let nodes = [0.0, 0.2, 0.3, 0.55, 0.8, 1.0];
        let points = nodes.map(|x| DVec3::new(x, libm::sin(7.0 * x), libm::cos(9.0 * x)));
        let control = control_points(&nodes, &points, &Ends::Slopes(DVec3::X, DVec3::Y));
        for (from, to) in [(0, 5), (0, 2), (1, 2), (1, 4), (3, 5)] {
            let part = restricted(&nodes, &control, from, to);
            assert_eq!(part.len(), to - from + 3);
            for interval in from..to {
                let x = 0.3 * nodes[interval] + 0.7 * nodes[interval + 1];
                let (whole, _) = value(&nodes, &control, interval, x);
                let (found, _) = value(&nodes[from..=to], &part, interval - from, x);
                assert!((whole - found).length() < 1e-14, "{from} {to} {interval}");
            }
        }
    }

    #[test]
    fn a_circle_closes_smoothly() {
        let tau = std::f64::consts::TAU;
        let mut errors = Vec::new();
        for n in [16usize, 32] {
            let nodes: Vec<f64> = (0..=n).map(|i| tau * i as f64 / n as f64).collect();
            let circle = |x: f64| DVec3::new(libm::cos(x), libm::sin(x), 0.0);
            let mut points: Vec<DVec3> = nodes.iter().map(|x| circle(*x)).collect();
            points[n] = points[0];
            let control = control_points(&nodes, &points, &Ends::Closed);
            let (start, start_slope) = value(&nodes, &control, 0, 0.0);
            let (end, end_slope) = value(&nodes, &control, n - 1, tau);
            assert!((start - end).length() < 1e-15 && (start_slope - end_slope).length() < 1e-13);
            let middle = nodes[3] / 2.0 + nodes[4] / 2.0;
            errors.push((value(&nodes, &control, 3, middle).0 - circle(middle)).length());
        }
        assert!(errors[0] < 1e-4 && errors[1] < errors[0] / 14.0, "{errors:?}");
    }
}
