//! Whether a closed section bounds an area: its outline must not run through itself.

use core::f64::consts::PI;

use glam::{DVec2, DVec3};

use super::section::{products, series};
use crate::design::{Form, Harmonic, Section, plain};
use crate::error::{Code, Error, Result};
use crate::surface::{Turns, of_turns};

/// The most waves of an outline that is drawn. Up to here every wave is looked at.
pub(super) const DRAWN_WAVES: f64 = 1024.0;

/// Points on an outline for each wave of its highest harmonic, and how many there are at least.
const PER_WAVE: usize = 12;
const LEAST_POINTS: usize = 96;

/// Where the first point lies between two of equal spacing: symmetrical outlines would else run through themselves at points, where nothing crosses.
const OFFSET: f64 = 0.382;

/// An area counts as none when it is this small beside the square of the extent.
const NO_AREA: f64 = 1e-12;

/// Sections beyond this are too large: areas would leave the range of numbers.
const LARGEST: f64 = 1e150;

/// The outline of a section as a closed polygon.
#[derive(Debug)]
pub(super) struct Polygon {
    points: Vec<DVec2>,
}

impl Polygon {
    /// Points of the border of a section: [`PER_WAVE`] for each wave, for at most [`DRAWN_WAVES`].
    pub(super) fn of(form: &Form) -> Polygon {
        let points = match form {
            Form::Disc(_) | Form::Outline { .. } => round([0, 1].map(|axis| series(form, axis))),
            // Once round the square.
            _ => {
                let products = products(form);
                let at = |u: f64, v: f64| -> DVec2 {
                    products.iter().map(|p| p.by * (p.u.jet::<1>(u)[0] * p.v.jet::<1>(v)[0])).sum()
                };
                let side = LEAST_POINTS / 4;
                let along = |i: usize| 0.5 - 0.5 * libm::cos(PI * i as f64 / side as f64);
                let border = |side: usize, t: f64| match side {
                    0 => at(t, 0.0),
                    1 => at(1.0, t),
                    2 => at(1.0 - t, 1.0),
                    _ => at(0.0, 1.0 - t),
                };
                let mut points: Vec<DVec2> = (0..4 * side).map(|i| border(i / side, along(i % side))).collect();
                points.dedup();
                points
            }
        };
        Polygon { points }
    }

    fn edges(&self) -> impl Iterator<Item = [DVec2; 2]> + '_ {
        let next = self.points.iter().skip(1).chain(self.points.first());
        self.points.iter().zip(next).map(|(from, to)| [*from, *to])
    }

    fn area(&self) -> f64 {
        0.5 * self.edges().map(|[from, to]| from.perp_dot(to)).sum::<f64>()
    }

    pub(super) fn extent(&self) -> f64 {
        let (low, high) = self.bounds();
        (high - low).max_element()
    }

    fn bounds(&self) -> (DVec2, DVec2) {
        let start = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        self.points.iter().fold(start, |(low, high), point| (low.min(*point), high.max(*point)))
    }

    /// A place where two edges that are not neighbours cross, of the first edge and the other.
    fn crossing(&self) -> Option<DVec2> {
        let n = self.points.len();
        let edges: Vec<[DVec2; 2]> = self.edges().collect();
        // Swept along x: only edges whose intervals meet are compared.
        let mut order: Vec<usize> = (0..n).collect();
        let low = |edge: usize| edges[edge][0].x.min(edges[edge][1].x);
        let high = |edge: usize| edges[edge][0].x.max(edges[edge][1].x);
        order.sort_by(|one, other| low(*one).total_cmp(&low(*other)));
        let mut open: Vec<usize> = Vec::new();
        for edge in order {
            open.retain(|other| high(*other) >= low(edge));
            for other in &open {
                let apart = edge.abs_diff(*other);
                if apart > 1
                    && apart < n - 1
                    && do_meet(edges[edge], edges[*other])
                    && do_cross(edges[edge], edges[*other])
                {
                    return Some(0.5 * (edges[edge][0] + edges[edge][1]));
                }
            }
            open.push(edge);
        }
        None
    }

    /// Whether a point is inside, by how often a ray from it leaves.
    fn holds(&self, point: DVec2) -> bool {
        let leaves = |[from, to]: &[DVec2; 2]| {
            (from.y > point.y) != (to.y > point.y)
                && point.x < from.x + (to.x - from.x) * (point.y - from.y) / (to.y - from.y)
        };
        self.edges().filter(leaves).count() % 2 == 1
    }

    /// A point that both areas have; `None` where they are apart.
    fn overlap(&self, other: &Polygon) -> Option<DVec2> {
        let ((low, high), (other_low, other_high)) = (self.bounds(), other.bounds());
        if low.cmpgt(other_high).any() || other_low.cmpgt(high).any() {
            return None;
        }
        let of_one = self.points.iter().find(|point| other.holds(**point));
        of_one.or_else(|| other.points.iter().find(|point| self.holds(**point))).copied()
    }
}

/// Points round two Fourier series, from [`OFFSET`] on. Angles are taken from one table, so that hundreds of waves at thousands of points take no time.
fn round(axes: [Vec<Harmonic>; 2]) -> Vec<DVec2> {
    let waves = axes.iter().flatten().map(|wave| wave.n).fold(1.0, f64::max).min(DRAWN_WAVES) as usize;
    // One more than a multiple of the waves: what goes round several times would else lie on itself, point on point, and cross itself nowhere.
    let n = waves * PER_WAVE.max(LEAST_POINTS.div_ceil(waves)) + 1;
    let mut turns = Turns::default();
    turns.divide(n);
    let mut points = vec![DVec2::ZERO; n];
    for (axis, series) in axes.iter().enumerate() {
        for Harmonic { n: waves, cos, sin } in series {
            let (c, s) = of_turns(libm::fmod(waves * OFFSET, n as f64) / n as f64);
            let (along, across) = (cos * c + sin * s, sin * c - cos * s);
            for (point, (c, s)) in points.iter_mut().zip(turns.walk(*waves)) {
                point[axis] += along * c + across * s;
            }
        }
    }
    points
}

/// Whether the intervals along y of two segments meet.
fn do_meet([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> bool {
    a.y.max(b.y) >= c.y.min(d.y) && c.y.max(d.y) >= a.y.min(b.y)
}

/// Whether two segments cross in a point that is inside both.
fn do_cross([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> bool {
    let side = |p: DVec2, q: DVec2, r: DVec2| robust::orient2d(coord(p), coord(q), coord(r));
    let (one, other) = (side(a, b, c), side(a, b, d));
    let (third, fourth) = (side(c, d, a), side(c, d, b));
    one * other < 0.0 && third * fourth < 0.0
}

fn coord(p: DVec2) -> robust::Coord<f64> {
    robust::Coord { x: p.x, y: p.y }
}

/// Refuses sections that are too large, that bound no area, that run through themselves, two that lie in each other, and two between which there is no height.
///
/// # Errors
/// `overflow`, `pinched-surface` and `crosses-itself`, with the section and the place.
pub(super) fn refuse_broken(both: [&Section; 2], polygons: &[Polygon; 2], path: &str) -> Result<()> {
    for (polygon, name) in polygons.iter().zip(["start", "end"]) {
        if !polygon.points.iter().all(|point| point.x.abs() <= LARGEST && point.y.abs() <= LARGEST) {
            let message = format!("this section is too large to compute: expected one of at most {}", plain(LARGEST));
            return Err(Error::new(Code::Overflow, format!("{path}.{name}"), message));
        }
    }
    for ((section, polygon), name) in both.into_iter().zip(polygons).zip(["start", "end"]) {
        let place = |at: DVec2| at.extend(section.z).to_array();
        let extent = polygon.extent();
        if let Some(at) = polygon.crossing() {
            let message = "the outline runs through itself: expected one that goes round an area once";
            let error = Error::new(Code::CrossesItself, format!("{path}.{name}"), message).near(place(at));
            return Err(error.with("what", "section"));
        }
        if !(polygon.area().abs() > NO_AREA * extent * extent) {
            let message = "the outline goes round no area: expected one that does";
            let error = Error::new(Code::PinchedSurface, format!("{path}.{name}"), message);
            return Err(error.with("what", "section"));
        }
    }
    let [start, end] = both;
    let extent = polygons.iter().map(Polygon::extent).fold(0.0, f64::max);
    if (start.z - end.z).abs() <= NO_AREA * extent
        && let Some(at) = polygons[0].overlap(&polygons[1])
    {
        let message = "both sections lie at the same height, one in the other: expected another height, or sections beside each other";
        let error = Error::new(Code::CrossesItself, format!("{path}.end.z"), message);
        return Err(error.near(DVec3::from((at, end.z)).to_array()).with("what", "sections"));
    }
    if [end.z - start.z, start.dz, end.dz].iter().all(|rise| rise.abs() <= NO_AREA * extent) {
        let message =
            "both sections lie at the same height, and no tangent rises from it: expected a solid that has some height";
        let error = Error::new(Code::PinchedSurface, format!("{path}.end.z"), message);
        return Err(error.with("what", "no-height"));
    }
    Ok(())
}
