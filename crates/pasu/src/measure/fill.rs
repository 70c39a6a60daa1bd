//! How much water stands in a pot: `int (h - z)` over what is wet, split where the water's edge is.

use core::f64::consts::TAU;

use glam::{DVec2, DVec3};

use super::accuracy::Accuracy;
use super::column::{Column, Inside, LEVEL, Link, Wet};
use super::integral::between;
use super::moments::{Moments, element};
use super::panels;
use super::quantity::Quantity;
use super::trimmed::of_column;
use crate::face::{FaceJet, Seams, ascending};
use crate::numeric::integral::Integral;
use crate::numeric::trapezoid::round;
use crate::numeric::{adaptive, bisection, trapezoid};
use crate::watch;

/// Water up to a level.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Filling {
    pub(crate) moments: Moments,
    /// Of the water's surface.
    pub(crate) area: Quantity,
}

/// Halvings of a gap between two columns until the change between them is located: the integral of a column is continuous there, so that what is left is far below rounding.
const HALVINGS: usize = 24;

/// What is wet of the columns of a pot at one level.
pub(crate) struct Level<'a> {
    inside: &'a Inside<'a>,
    pub(crate) z: f64,
    /// Columns in ascending `v`, with those on either side of each change.
    pub(crate) columns: Vec<(Column, Vec<Wet>)>,
    /// Where the water's edge goes from one face to another or turns back, in ascending order.
    pub(crate) breaks: Vec<f64>,
}

/// What of a column's wet stretches must change without a break: which faces, and how they end.
fn is_alike(one: &[Wet], other: &[Wet]) -> bool {
    one.len() == other.len() && one.iter().zip(other).all(|(x, y)| x.link == y.link && x.is_cut == y.is_cut)
}

impl<'a> Level<'a> {
    /// The water's edge at a level, seen at columns of which 0 is one.
    pub(crate) fn new(inside: &'a Inside<'a>, z: f64, places: impl Iterator<Item = f64>) -> Level<'a> {
        let places = ascending(places.collect());
        let n = places.len();
        let mut even = inside.columns(&places).into_iter();
        let at = |v: f64| {
            let column = inside.column(v);
            let wet = inside.wet(&column, z);
            (column, wet)
        };
        let mut columns = Vec::with_capacity(n);
        let mut breaks = Vec::new();
        let wet = |column: Column| {
            let wet = inside.wet(&column, z);
            (column, wet)
        };
        let first = even.next().map_or_else(|| at(0.0), wet);
        let mut before = first.clone();
        for j in 1..=n {
            let after = if j == n {
                let (mut column, wet) = first.clone();
                column.turn(TAU);
                (column, wet)
            } else {
                even.next().map_or_else(|| at(TAU), wet)
            };
            columns.push(before.clone());
            // Several changes between two columns are found one after the other.
            while !is_alike(&before.1, &after.1) {
                let [from, to] = [&before, &after].map(|end| (end.0.v(), end.clone()));
                let [(below, low), (above, high)] =
                    bisection::change(from, to, HALVINGS, &at, |middle| is_alike(&middle.1, &before.1));
                breaks.push(0.5 * (below + above));
                if below > before.0.v() {
                    columns.push(low);
                }
                before = high;
                if breaks.len() > 4 * n || watch::is_stopped() {
                    break;
                }
                if before.0.v() < after.0.v() {
                    columns.push(before.clone());
                }
            }
            before = after;
        }
        Level { inside, z, columns, breaks }
    }

    /// Where a column crosses the level, from the floor to the rim, seen from above.
    pub(crate) fn roots(&self, column: &Column, wet: &[Wet]) -> Vec<DVec2> {
        let ends = wet.iter().flat_map(|wet| [(wet.is_cut[0], wet.link, wet.from), (wet.is_cut[1], wet.link, wet.to)]);
        let cut = ends.filter(|(is_cut, ..)| *is_cut);
        cut.map(|(_, link, s)| self.inside.position((link, s), column.v()).truncate()).collect()
    }

    /// For each link the rows that are wet in every column that was looked at, if each has one stretch there: they are integrated one by one, and only what is beyond them column by column.
    fn common(&self) -> Vec<Option<(f64, f64)>> {
        let stretch = |link: usize| {
            if self.seams(link).is_some() {
                return None;
            }
            let face = self.inside.links().get(link)?;
            let (mut from, mut to) = (0.0f64, 1.0f64);
            for (column, wet) in &self.columns {
                let mut here = wet.iter().filter(|wet| wet.link == link);
                let (Some(wet), None) = (here.next(), here.next()) else { return None };
                let (begin, end) = face.straight((wet.from, wet.to), column.v());
                (from, to) = (from.max(begin), to.min(end));
            }
            (to - from > LEAST_COMMON).then_some((from, to))
        };
        (0..self.inside.links().len()).map(stretch).collect()
    }

    fn seams(&self, link: usize) -> Option<&Seams> {
        self.inside.seams().get(link)?.as_ref()
    }

    /// `(h - z) n_z`, its moments about a point, and `n_z`, at one place.
    fn of_jet(&self, link: &Link, jet: &FaceJet, middle: DVec3) -> [f64; 5] {
        let up = element(link.face(), jet).z;
        let arm = jet.position - middle;
        let volume = (self.z - jet.position.z) * up;
        [volume, arm.x * volume, arm.y * volume, 0.5 * (self.z - middle.z + arm.z) * volume, up]
    }

    /// The integral over what is wet of one column beyond the common stretches. It may end before such a stretch does; what is too much there is taken off again.
    fn of_column(&self, column: &Column, rest: &Rest<'_>) -> Integral<5> {
        let v = column.v();
        let mut total = Integral::default();
        let wet = self.inside.wet(column, self.z);
        let mut stretches: Vec<(usize, f64, f64)> = Vec::with_capacity(2 * wet.len());
        for (link, common) in rest.common.iter().enumerate().filter(|(link, _)| self.seams(*link).is_none()) {
            let Some(face) = self.inside.links().get(link) else { continue };
            let here = wet.iter().filter(|wet| wet.link == link);
            let here: Vec<(f64, f64)> = here.map(|wet| face.straight((wet.from, wet.to), v)).collect();
            match (common, here.as_slice()) {
                (Some((first, last)), [(from, to)]) => {
                    stretches.extend([(link, *from, *first), (link, *last, *to)]);
                }
                (common, here) => {
                    stretches.extend(here.iter().map(|(from, to)| (link, *from, *to)));
                    stretches.extend(common.map(|(first, last)| (link, last, first)));
                }
            }
        }
        for (link, from, to) in stretches {
            let Some(link) = self.inside.links().get(link) else { continue };
            let mut walk = link.face().straight_walk();
            let integrand = |jet: &FaceJet| self.of_jet(link, jet, rest.middle);
            total.add(&of_column(walk.as_mut(), (from, to), v, rest.accuracy, rest.at_least, integrand));
        }
        let missing = wet.iter().filter(|wet| self.seams(wet.link).is_none()).map(|wet| self.missing(wet, v));
        total.value[4] += missing.sum::<f64>();
        total
    }

    /// A stretch ends a rounding below the level, which only the surface of the water can notice: what it lacks.
    fn missing(&self, wet: &Wet, v: f64) -> f64 {
        let Some(link) = self.inside.links().get(wet.link) else { return 0.0 };
        let ends = [wet.from, wet.to].into_iter().zip(wet.is_cut).filter(|(_, is_cut)| *is_cut);
        ends.map(|(s, _)| {
            let jet = link.jet(s, v);
            let missing = LEVEL * self.inside.size() / jet.da.z.abs();
            if missing < 1e-6 { missing * element(link.face(), &jet).z } else { 0.0 }
        })
        .sum()
    }

    /// The integral over what is wet of faces with seams.
    fn seamed(&self, middle: DVec3, accuracy: &Accuracy) -> Integral<5> {
        let links: Vec<(usize, &Link, &Seams)> = self
            .inside
            .links()
            .iter()
            .enumerate()
            .filter_map(|(number, link)| Some((number, link, self.seams(number)?)))
            .collect();
        let mut total = Integral::<5>::default();
        let mut breaks = self.breaks.clone();
        let mut common: Vec<Option<(f64, f64)>> = Vec::with_capacity(links.len());
        // How many cells the rest of a column goes through at most.
        let mut n_rows = 0;
        for (number, link, seams) in &links {
            breaks.extend(seams.round.iter().chain(&seams.crossings));
            // What is wet in every column.
            let mut stretches = Vec::with_capacity(self.columns.len());
            for (column, wet) in &self.columns {
                let mut here = wet.iter().filter(|wet| wet.link == *number);
                if let (Some(wet), None) = (here.next(), here.next()) {
                    stretches.push(link.straight((wet.from, wet.to), column.v()));
                }
            }
            let rows = panels::common_rows(seams, &stretches).filter(|_| stretches.len() == self.columns.len());
            if let Some(rows) = rows {
                total.add(&panels::between_rows(link.face(), seams, rows, accuracy, |jet| {
                    self.of_jet(link, jet, middle)
                }));
            }
            let of_common = rows.map_or(0, |(from, to)| panels::cells_between(seams, from, to) - 1);
            let of_column = |(column, wet): &(Column, Vec<Wet>)| -> usize {
                let here = wet.iter().filter(|wet| wet.link == *number);
                let stretches = here.map(|wet| link.straight((wet.from, wet.to), column.v()));
                stretches.map(|(from, to)| panels::cells_between(seams, from, to)).sum()
            };
            n_rows += self.columns.iter().map(of_column).max().unwrap_or(0).saturating_sub(of_common);
            common.push(rows);
        }
        if links.is_empty() {
            return total;
        }
        // The rest of each column.
        let mut at_least = total.size;
        // The water's edge has corners on the seams. Its area is only to be looked at, the volume does not notice.
        at_least[4] *= 10.0;
        let breaks = panels::once_round(&ascending(breaks));
        total.add(&panels::over_columns(&breaks, accuracy, at_least, n_rows, |places, cut| {
            let columns = self.inside.columns(places);
            let of_column = |column: &Column| {
                let (v, wet) = (column.v(), self.inside.wet(column, self.z));
                let mut sum = Integral::<5>::default();
                for ((number, link, seams), common) in links.iter().zip(&common) {
                    let mut walk = link.face().straight_walk();
                    let mut add = |from: f64, to: f64| {
                        let at = |s: f64| self.of_jet(link, &walk.jet(s, v), middle);
                        sum.add(&panels::column(seams, (from, to), cut, at));
                    };
                    let here = wet.iter().filter(|wet| wet.link == *number);
                    let stretches: Vec<(f64, f64)> =
                        here.clone().map(|wet| link.straight((wet.from, wet.to), v)).collect();
                    match (common, stretches.as_slice()) {
                        (Some((first, last)), [(from, to)]) => {
                            add(*from, *first);
                            add(*last, *to);
                        }
                        (common, stretches) => {
                            stretches.iter().for_each(|(from, to)| add(*from, *to));
                            if let Some((first, last)) = common {
                                add(*last, *first);
                            }
                        }
                    }
                    sum.value[4] += here.map(|wet| self.missing(wet, v)).sum::<f64>();
                }
                sum
            };
            columns.iter().map(of_column).collect()
        }));
        total
    }

    /// Volume, moments and surface of the water.
    pub(crate) fn filling(&self, accuracy: &Accuracy) -> Filling {
        let Some((_, first)) = self.columns.iter().find(|(_, wet)| !wet.is_empty()) else {
            return Filling::default();
        };
        let middle = self.inside.position((first[0].link, first[0].from), 0.0).with_z(self.z);
        let common = self.common();
        let mut total = self.seamed(middle, accuracy);
        let is_seamed = |link: usize| self.seams(link).is_some();
        let has_others = self.columns.iter().any(|(_, wet)| wet.iter().any(|wet| !is_seamed(wet.link)));
        for (link, stretch) in common.iter().enumerate() {
            if let Some((rows, link)) = stretch.zip(self.inside.links().get(link)) {
                let mut walk = link.face().straight_walk();
                total.add(&between(rows, accuracy, |s, v| self.of_jet(link, &walk.jet(s, v), middle)));
            }
        }
        // What columns leave is held against the whole.
        let rest = Rest { common, middle, accuracy, at_least: total.size.map(|size| size / TAU) };
        if has_others {
            total.add(&if self.breaks.is_empty() { self.smooth(&rest, accuracy) } else { self.broken(rest, accuracy) });
        }
        let [.., area] = total.value;
        // The level itself is off by rounding.
        let edge = 2.0 * LEVEL * self.inside.size() * area.abs();
        let first = |all: [f64; 5]| [all[0], all[1], all[2], all[3]];
        let mut water = Integral { value: first(total.value), error: first(total.error), size: first(total.size) };
        water.error[0] += edge;
        let span = self.inside.size();
        for i in 1..4 {
            water.error[i] += edge * span;
        }
        Filling { moments: Moments::about(middle, &water), area: Quantity::new(area, total.error[4]) }
    }

    /// The rest where all columns are alike: by the trapezoidal rule, with more columns until that changes too little.
    fn smooth(&self, rest: &Rest<'_>, accuracy: &Accuracy) -> Integral<5> {
        let allowed =
            |size: &[f64; 5]| core::array::from_fn(|i| accuracy.relative * size[i].max(TAU * rest.at_least[i]));
        trapezoid::integrate(accuracy.columns, accuracy.most_columns, 0.0, allowed, |n| {
            let mut sum = Integral::default();
            for column in self.inside.columns(&round(n).collect::<Vec<_>>()) {
                sum.add(&self.of_column(&column, rest));
            }
            sum
        })
    }

    /// The rest where columns differ: Gauss-Kronrod between the places where they change.
    fn broken(&self, mut rest: Rest<'_>, accuracy: &Accuracy) -> Integral<5> {
        let mut breaks = self.breaks.clone();
        breaks.push(self.breaks[0] + TAU);
        let at_least = rest.at_least.map(|size| TAU * size);
        adaptive::integrate(&breaks, accuracy.relative, at_least, 3 * breaks.len() + 8, |v| {
            let column = self.of_column(&self.inside.column(v), &rest);
            for i in 0..5 {
                rest.at_least[i] = rest.at_least[i].max(column.size[i]);
            }
            column
        })
    }
}

/// Rows that are wet in every column are integrated by themselves if they are at least this part of their face.
const LEAST_COMMON: f64 = 0.05;

/// How columns are integrated.
struct Rest<'a> {
    common: Vec<Option<(f64, f64)>>,
    middle: DVec3,
    accuracy: &'a Accuracy,
    at_least: [f64; 5],
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{FRAC_PI_2, PI};

    use glam::DMat3;

    use super::super::bare::Cap;
    use super::super::pool::Pool;
    use super::*;
    use crate::face::{Face, FaceJet, FaceKind, Sealed};

    /// The lining of a tilted round cup, `r(a)` and `z(a)` with their derivatives.
    struct Cup {
        profile: fn(f64) -> [[f64; 2]; 2],
        turn: DMat3,
    }

    impl Sealed for Cup {}

    impl Face for Cup {
        fn kind(&self) -> FaceKind {
            FaceKind::Lining
        }

        fn jet(&self, a: f64, v: f64) -> FaceJet {
            let [[r, z], [dr, dz]] = (self.profile)(a);
            let (s, c) = (libm::sin(v), libm::cos(v));
            FaceJet {
                position: self.turn * DVec3::new(r * c, r * s, z) + DVec3::new(3.0, -2.0, 10.0),
                da: self.turn * DVec3::new(dr * c, dr * s, dz),
                dv: self.turn * DVec3::new(-r * s, r * c, 0.0),
            }
        }

        /// Into the water: inwards and up.
        fn outward(&self) -> f64 {
            1.0
        }
    }

    const RADIUS: f64 = 1.5;
    const HEIGHT: f64 = 4.0;

    fn cylinder(a: f64) -> [[f64; 2]; 2] {
        [[RADIUS, HEIGHT * a], [0.0, HEIGHT]]
    }

    fn tilted(profile: fn(f64) -> [[f64; 2]; 2], tilt: f64) -> Cup {
        Cup { profile, turn: DMat3::from_rotation_z(0.4) * DMat3::from_rotation_y(tilt) }
    }

    fn full(cup: &Cup, below: f64) -> (f64, Filling) {
        let floor = Cap::new(cup, 0.0, 60);
        let inside = Inside::new(&[&floor, cup], cup.turn.z_axis, 1.0);
        let (level, ..) = inside.spill(&inside.even_columns());
        (level, Level::new(&inside, level - below, round(49)).filling(&Accuracy::new(1e-11, 1.0)))
    }

    fn near(found: Quantity, exact: f64) {
        assert!((found.value - exact).abs() <= 1e-10 * exact.abs().max(1.0), "{found:?} {exact}");
        assert!((found.value - exact).abs() <= found.error, "dishonest: {found:?} {exact}");
        assert!(found.error < 1e-8, "{found:?}");
    }

    #[test]
    fn an_upright_cup() {
        for below in [0.0, 1.3, 3.999] {
            let (level, water) = full(&tilted(cylinder, 0.0), below);
            let depth = HEIGHT - below;
            assert!((level - 14.0).abs() < 1e-12);
            let volume = PI * RADIUS * RADIUS * depth;
            near(water.moments.volume, volume);
            near(water.area, PI * RADIUS * RADIUS);
            let (centre, _) = water.moments.centre().unwrap();
            assert!((centre - DVec3::new(3.0, -2.0, 10.0 + 0.5 * depth)).length() < 1e-9);
        }
        assert_eq!(full(&tilted(cylinder, 0.0), 4.5).1, Filling::default());
    }

    #[test]
    fn a_tilted_cup_with_its_floor_covered() {
        for tilt in [0.1, 0.5, 0.9] {
            let (level, water) = full(&tilted(cylinder, tilt), 0.0);
            assert!((level - (10.0 + HEIGHT * tilt.cos() - RADIUS * tilt.sin())).abs() < 1e-12);
            near(water.moments.volume, PI * RADIUS * RADIUS * (HEIGHT - RADIUS * tilt.tan()));
            near(water.area, PI * RADIUS * RADIUS / tilt.cos());
        }
    }

    /// A hoof of a cylinder: the plane meets the base in a chord at `x` from its centre.
    fn ungula(tan: f64, x: f64) -> f64 {
        let half = (RADIUS * RADIUS - x * x).sqrt();
        tan * (2.0 / 3.0 * half.powi(3) - x * (RADIUS * RADIUS * (x / RADIUS).acos() - x * half))
    }

    #[test]
    fn a_hoof_of_a_cylinder() {
        for tilt in [1.0, 1.23, 1.4, 1.5] {
            for below in [0.0, 0.03] {
                let (_, water) = full(&tilted(cylinder, tilt), below);
                let edge = RADIUS - (HEIGHT - below / tilt.cos()) / tilt.tan();
                near(water.moments.volume, ungula(tilt.tan(), edge));
            }
        }
        // On its side a cup holds nothing.
        assert_eq!(full(&tilted(cylinder, FRAC_PI_2 + 0.2), 0.0).1.moments.volume.value, 0.0);
    }

    /// A ball without its cap: closed above a half.
    fn bowl(a: f64) -> [[f64; 2]; 2] {
        let t = 2.2 * a;
        [[RADIUS * t.sin(), -RADIUS * t.cos()], [2.2 * RADIUS * t.cos(), 2.2 * RADIUS * t.sin()]]
    }

    fn surface_of(level: &Level) -> f64 {
        let pool = Pool::new(level);
        pool.triangles
            .iter()
            .map(|t| {
                let [a, b, c] = t.map(|i| pool.points[i as usize]);
                let area = 0.5 * (b - a).perp_dot(c - a);
                assert!(area >= 0.0);
                area
            })
            .sum()
    }

    #[test]
    fn triangles_cover_the_water() {
        for tilt in [0.0, 0.5, 1.0, 1.23, 1.4] {
            let cup = tilted(cylinder, tilt);
            let floor = Cap::new(&cup, 0.0, 60);
            let inside = Inside::new(&[&floor, &cup], cup.turn.z_axis, 1.0);
            let (spill, ..) = inside.spill(&inside.even_columns());
            let (low, _) = inside.floor();
            for share in [0.05, 0.3, 0.7, 0.95, 1.0] {
                let level = Level::new(&inside, low + share * (spill - low), round(193));
                let (area, exact) = (surface_of(&level), level.filling(&Accuracy::new(1e-9, 1.0)).area.value);
                assert!((area - exact).abs() < 0.01 * exact, "tilt {tilt}, {share}: {area} {exact}");
            }
        }
    }

    /// A ring cake: the middle rises.
    fn ring(a: f64) -> [[f64; 2]; 2] {
        let t = PI * (a - 0.0);
        [[2.0 * a, 1.0 - libm::sin(t) + a], [2.0, -PI * libm::cos(t) + 1.0]]
    }

    #[test]
    fn a_ring_of_water_has_a_hole() {
        for tilt in [0.0, 0.1] {
            let cup = tilted(ring, tilt);
            let inside = Inside::new(&[&cup], cup.turn.z_axis, 1.0);
            for level in [10.5, 10.8] {
                let level = Level::new(&inside, level, round(49));
                assert!(level.filling(&Accuracy::new(1e-9, 1.0)).moments.volume.error < 1e-6);
                let (area, exact) = (surface_of(&level), level.filling(&Accuracy::new(1e-9, 1.0)).area.value);
                assert!((area - exact).abs() < 0.02 * exact, "tilt {tilt}: {area} {exact}");
            }
        }
    }

    #[test]
    fn a_tilted_ball() {
        for tilt in [0.0, 0.3, 0.8] {
            let cup = tilted(bowl, tilt);
            let inside = Inside::new(&[&cup], cup.turn.z_axis, 1.0);
            let (spill, ..) = inside.spill(&inside.even_columns());
            assert!((spill - 10.0 + RADIUS * (2.2f64 - tilt).cos()).abs() < 1e-12);
            assert!((inside.floor().0 - 10.0 + RADIUS).abs() < 1e-12);
            for level in [spill, 9.7, 9.0] {
                let depth = level - 10.0 + RADIUS;
                let water = Level::new(&inside, level, round(49)).filling(&Accuracy::new(1e-11, 1.0));
                near(water.moments.volume, PI * depth * depth * (RADIUS - depth / 3.0));
                near(water.area, PI * depth * (2.0 * RADIUS - depth));
            }
        }
    }
}
