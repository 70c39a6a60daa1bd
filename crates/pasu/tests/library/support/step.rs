//! Splines of STEP files, read and evaluated by their definition.

use glam::DVec3;

/// The arguments of an entity, split at the commas between them.
pub(crate) fn arguments(text: &str) -> Vec<String> {
    let (mut depth, mut quoted) = (0, false);
    let mut list = vec![String::new()];
    for c in text.chars() {
        match c {
            '\'' => quoted = !quoted,
            '(' if !quoted => depth += 1,
            ')' if !quoted => depth -= 1,
            ',' if !quoted && depth == 0 => {
                list.push(String::new());
                continue;
            }
            _ => {}
        }
        list.last_mut().unwrap().push(c);
    }
    list
}

pub(crate) fn inside(list: &str) -> &str {
    list.strip_prefix('(').unwrap().strip_suffix(')').unwrap()
}

pub(crate) fn reals(list: &str) -> Vec<f64> {
    arguments(inside(list)).iter().map(|x| x.parse().unwrap()).collect()
}

/// Every knot as often as it counts.
pub(crate) fn knots(times: &str, knots: &str) -> Vec<f64> {
    let times = reals(times);
    reals(knots).into_iter().zip(times).flat_map(|(knot, times)| vec![knot; times as usize]).collect()
}

/// The value of a B-spline basis function by its definition.
pub(crate) fn basis(knots: &[f64], i: usize, degree: usize, x: f64) -> f64 {
    if degree == 0 {
        return if knots[i] <= x && x < knots[i + 1] { 1.0 } else { 0.0 };
    }
    let part =
        |from: usize, to: usize, x: f64| if knots[to] > knots[from] { x / (knots[to] - knots[from]) } else { 0.0 };
    part(i, i + degree, x - knots[i]) * basis(knots, i, degree - 1, x)
        + part(i + 1, i + degree + 1, knots[i + degree + 1] - x) * basis(knots, i + 1, degree - 1, x)
}

/// A `B_SPLINE_SURFACE_WITH_KNOTS` of third degree.
pub(crate) struct Spline {
    pub(crate) control: Vec<Vec<DVec3>>,
    pub(crate) along: Vec<f64>,
    pub(crate) round: Vec<f64>,
}

impl Spline {
    /// Reads what stands behind the opening bracket. `entity` is what a reference such as `#7` stands for.
    pub(crate) fn read<'a>(surface: &str, entity: impl Fn(&str) -> &'a str) -> Spline {
        let surface = arguments(surface.strip_suffix(')').unwrap());
        let point = |id: &String| {
            let point = entity(id).strip_prefix("CARTESIAN_POINT('',").unwrap();
            DVec3::from_slice(&reals(point.strip_suffix(')').unwrap()))
        };
        let control = arguments(inside(&surface[3]))
            .iter()
            .map(|row| arguments(inside(row)).iter().map(point).collect())
            .collect();
        Spline { control, along: knots(&surface[8], &surface[10]), round: knots(&surface[9], &surface[11]) }
    }

    pub(crate) fn at(&self, a: f64, v: f64) -> DVec3 {
        let weights = |knots: &[f64], x: f64| -> Vec<(usize, f64)> {
            let all = (0..knots.len() - 4).map(|i| (i, basis(knots, i, 3, x)));
            all.filter(|(_, weight)| *weight > 0.0).collect()
        };
        let round = weights(&self.round, v);
        let row = |i: usize| round.iter().map(|(j, weight)| *weight * self.control[i][*j]).sum::<DVec3>();
        weights(&self.along, a).into_iter().map(|(i, weight)| weight * row(i)).sum()
    }
}
