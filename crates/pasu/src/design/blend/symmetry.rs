//! The motions about its axis that make a blend its own image, read from its sections.
//!
//! Of the exact method each harmonic of the outline follows from its data on both sections in one way, the same for `x` and `y`, as a mode of a surface between two ends does: so they are compared as the modes of such a surface are, and nothing is solved.
//! Between sections whose `x` is odd about the middle of `u` and even about that of `v`, and whose `y` is the other way round, the sines along `u` and `v` are so too. Of what else there is, closed sections by methods that pin their seam, and closed sections against others, no motion is known.

use super::fields::{Blend, Form, Harmonic, Method, Section};
use crate::design::boundary_value::{BoundaryValue, Component, Datum, Free, Mode, Order, Span};
use crate::design::symmetry::Symmetry;

impl Blend {
    /// The turns about the axis and the mirrors in planes through it that leave it as it is.
    pub(super) fn symmetry(&self) -> Symmetry {
        let sections = [&self.start, &self.end];
        let are_closed = sections.map(|section| section.form.is_closed());
        if self.method() == Method::Exact && are_closed == [true; 2] {
            return Symmetry::of(&self.outlines());
        }
        if are_closed != [false; 2] {
            return Symmetry::NONE;
        }
        // Between bilinear sections there is nothing left for the sines, and u and v may change places.
        let is_square = |section: &&Section| match section.form {
            Form::Rectangle([x, y]) | Form::RectangleReversed([x, y]) => x == y,
            _ => false,
        };
        let fold = if sections.iter().all(is_square) { 4.0 } else { 2.0 };
        Symmetry { fold: Some(fold), mirror: Some(0.0) }
    }

    /// The outlines of both sections as the boundary data of a surface between them.
    fn outlines(&self) -> BoundaryValue {
        let [start, end] = [&self.start, &self.end].map(|section| (section, series(&section.form)));
        let datum = |one: f64, other: f64| Datum {
            start: one,
            end: other,
            start_u: start.0.taper * one,
            end_u: end.0.taper * other,
            ..Datum::default()
        };
        let component = |axis: usize| {
            let both = [&start.1[axis], &end.1[axis]];
            let mut numbers: Vec<f64> = both.iter().flat_map(|series| series.iter().map(|wave| wave.n)).collect();
            numbers.sort_by(f64::total_cmp);
            numbers.dedup();
            let modes = numbers.into_iter().map(|n| {
                let of = |series: &[Harmonic]| {
                    let waves = series.iter().filter(|wave| wave.n == n);
                    waves.fold([0.0; 2], |sum, wave| [sum[0] + wave.cos, sum[1] + wave.sin])
                };
                let [one, other] = both.map(|series| of(series));
                Mode { n, cos: datum(one[0], other[0]), sin: datum(one[1], other[1]) }
            });
            fourth(modes.collect())
        };
        // Heights are the same all round, and say nothing.
        BoundaryValue { span: Span::Tau, rings: Vec::new(), x: component(0), y: component(1), z: fourth(Vec::new()) }
    }
}

/// The equation is one for both components, and which it is makes no difference.
fn fourth(modes: Vec<Mode>) -> Component {
    Component { order: Order::Fourth, s: 1.0, t: 0.0, w: 1.0, free: Free::default(), modes }
}

/// The series of `x` and of `y` round a closed section.
fn series(form: &Form) -> [Vec<Harmonic>; 2] {
    match form {
        Form::Outline { x, y } => [x.clone(), y.clone()],
        Form::Disc([x, y]) => {
            [vec![Harmonic { n: 1.0, cos: 0.0, sin: *x }], vec![Harmonic { n: 1.0, cos: *y, sin: 0.0 }]]
        }
        Form::Rectangle(_) | Form::RectangleReversed(_) | Form::DiscInSquare(_) => [Vec::new(), Vec::new()],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::Shape;

    fn symmetry(start: &str, end: &str, more: &str) -> Symmetry {
        let section = |form: &str, z: f64| format!(r#"{{ {form}, "z": {z}, "taper": -0.1, "dz": 2 }}"#);
        let text =
            format!(r#"{{ "kind": "blend", "start": {}, "end": {}{more} }}"#, section(start, 0.0), section(end, 3.0));
        let Shape::Blend(blend) = Shape::parse(&text).unwrap() else { panic!("no blend") };
        blend.symmetry()
    }

    /// `x + iy = 2 exp(iv) + 0.3 exp(i n v)`.
    fn petals(n: i32) -> String {
        let (size, sign) = (n.abs(), f64::from(n.signum()));
        format!(
            r#""form": "outline", "x": [{{ "n": 1, "cos": 2 }}, {{ "n": {size}, "cos": 0.3 }}], "y": [{{ "n": 1, "sin": 2 }}, {{ "n": {size}, "sin": {} }}]"#,
            0.3 * sign
        )
    }

    #[test]
    fn closed_sections_have_those_of_their_petals() {
        let disc = |x: f64, y: f64| format!(r#""form": "disc", "radius": [{x}, {y}]"#);
        let round = Symmetry { fold: None, mirror: Some(0.0) };
        assert_eq!(symmetry(&disc(2.0, 2.0), &disc(1.0, 1.0), ""), round);
        let oval = symmetry(&disc(2.0, 3.0), &disc(1.0, 1.0), "");
        assert_eq!(
            (oval.fold, oval.has_mirror(0.0), oval.has_mirror(2.0), oval.has_mirror(1.0)),
            (Some(2.0), true, true, false)
        );
        let found = symmetry(&petals(-4), &petals(-4), "");
        assert_eq!((found.fold, found.has_mirror(0.0)), (Some(5.0), true));
        assert_eq!(symmetry(&petals(-4), &petals(-2), "").fold, Some(1.0));
        assert_eq!(symmetry(&petals(-5), &petals(-2), "").fold, Some(3.0));
        let turned = petals(-4).replace(r#""cos": 0.3"#, r#""sin": 0.3"#).replace(r#""sin": -0.3"#, r#""cos": 0.3"#);
        let twisted = symmetry(&petals(-4), &turned, "");
        assert_eq!((twisted.fold, twisted.mirror), (Some(5.0), None));
        // Pinned at a seam.
        assert_eq!(symmetry(&disc(2.0, 2.0), &disc(1.0, 1.0), r#", "method": "modal""#), Symmetry::NONE);
        let away = petals(-4).replace(r#""x": ["#, r#""x": [{ "n": 0, "cos": 1 }, "#);
        assert_eq!(symmetry(&away, &petals(-4), "").fold, Some(1.0));
    }

    #[test]
    fn other_sections_have_those_of_rectangles() {
        let form = |form: &str, x: f64, y: f64| format!(r#""form": "{form}", "radius": [{x}, {y}]"#);
        let of = |fold: f64| Symmetry { fold: Some(fold), mirror: Some(0.0) };
        assert_eq!(symmetry(&form("rectangle", 1.0, 2.0), &form("rectangle", 2.0, 2.0), ""), of(2.0));
        assert_eq!(symmetry(&form("rectangle", 1.0, 1.0), &form("rectangle", 2.0, 2.0), ""), of(4.0));
        assert_eq!(symmetry(&form("disc-in-square", 1.0, 1.0), &form("rectangle", 2.0, 2.0), ""), of(2.0));
        assert_eq!(symmetry(&form("disc", 1.0, 1.0), &form("rectangle", 2.0, 2.0), ""), Symmetry::NONE);
    }
}
