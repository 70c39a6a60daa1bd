//! Integrals over a face whose columns begin, or end, each at a place of its own: the rows that all columns have are integrated together, and what is left of each column by itself.

use core::f64::consts::TAU;

use super::accuracy::Accuracy;
use super::integral::between;
use crate::face::{Face, FaceJet, FaceWalk};
use crate::numeric::integral::{Integral, ROUNDING};
use crate::numeric::trapezoid::round;
use crate::numeric::{adaptive, trapezoid};

/// What is left of columns is looked at in no more places than this in one turn, but in as many columns as the face asks for at first.
const MOST_PLACES: usize = 1 << 18;

/// Places of the rule on one interval of a column.
const OF_AN_INTERVAL: usize = 21;

/// The most intervals into which what is left of a column is halved.
const MOST_INTERVALS: usize = 8;

/// Where the columns of a face are, in the coordinate `s` of [`Face::straight`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Reach {
    /// The least and the greatest place at which one begins.
    begins: [f64; 2],
    /// The same of where they end.
    ends: [f64; 2],
}

impl Reach {
    /// Seen at the columns of a turn.
    pub(crate) fn of(face: &dyn Face, n_columns: usize) -> Reach {
        let nothing = [f64::INFINITY, f64::NEG_INFINITY];
        round(n_columns).fold(Reach { begins: nothing, ends: nothing }, |reach, v| {
            let (begin, end) = stretch(face, v);
            let with = |[least, most]: [f64; 2], s: f64| [least.min(s), most.max(s)];
            Reach { begins: with(reach.begins, begin), ends: with(reach.ends, end) }
        })
    }

    /// Whether `s` is `a` itself.
    pub(crate) fn is_whole(&self, face: &dyn Face) -> bool {
        *self == Reach { begins: [0.0; 2], ends: [1.0; 2] } && face.straight(0.0, 0.0) == 0.0
    }

    /// The rows that all of these columns have: where there are none, one row to which all of them are led.
    fn common(&self) -> (f64, f64) {
        let (first, last) = (self.begins[1], self.ends[0]);
        if first < last { (first, last) } else { (0.5 * (first + last), 0.5 * (first + last)) }
    }

    /// Whether anything is left of a column.
    fn is_ragged(&self) -> bool {
        self.begins[0] < self.begins[1] || self.ends[0] < self.ends[1]
    }
}

/// From where to where a column is, ascending.
fn stretch(face: &dyn Face, v: f64) -> (f64, f64) {
    let (from, to) = (face.straight(0.0, v), face.straight(1.0, v));
    (from.min(to), from.max(to))
}

/// Integrates over the whole of a face that is closed round `v`, with respect to `ds dv`.
///
/// A row of the rectangle is the same for all columns, so that what it takes is formed once, and derivatives jump at the same rows in all of them. A column that begins a little above that rectangle has what is too much taken off again.
pub(crate) fn over<const N: usize>(
    face: &dyn Face,
    reach: &Reach,
    accuracy: &Accuracy,
    integrand: impl Fn(&FaceJet) -> [f64; N],
) -> Integral<N> {
    let (first, last) = reach.common();
    let mut walk = face.straight_walk();
    let mut total = Integral::default();
    if first < last {
        total = between((first, last), accuracy, |s, v| integrand(&walk.jet(s, v)));
    }
    if !reach.is_ragged() {
        return total;
    }
    let at_least = total.size.map(|size| size / TAU);
    let allowed = |size: &[f64; N]| core::array::from_fn(|i| accuracy.relative * size[i].max(total.size[i]));
    let n_intervals = accuracy.knots.len() + 2;
    let most = accuracy.most_columns.min(MOST_PLACES / (OF_AN_INTERVAL * n_intervals));
    let rest = trapezoid::integrate(accuracy.columns, most, ROUNDING, allowed, |n| {
        let mut sum = Integral::default();
        for v in round(n) {
            let (from, to) = stretch(face, v);
            for ends in [(from, first), (last, to)] {
                sum.add(&of_column(walk.as_mut(), ends, v, accuracy, at_least, &integrand));
            }
        }
        sum
    });
    total.add(&rest);
    total
}

/// The integral along a column between two rows; negative where it runs down.
pub(crate) fn of_column<const N: usize>(
    walk: &mut dyn FaceWalk,
    (from, to): (f64, f64),
    v: f64,
    accuracy: &Accuracy,
    at_least: [f64; N],
    integrand: impl Fn(&FaceJet) -> [f64; N],
) -> Integral<N> {
    if from == to {
        return Integral::default();
    }
    let breaks = accuracy.breaks_of_a_part(from.min(to), from.max(to));
    let mut part = adaptive::integrate(&breaks, 0.1 * accuracy.relative, at_least, MOST_INTERVALS, |s| {
        Integral::of(integrand(&walk.jet(s, v)))
    });
    if from > to {
        part.value = part.value.map(|value| -value);
    }
    part
}

#[cfg(test)]
mod tests {
    use core::cell::Cell;

    use super::*;
    use crate::design::Design;
    use crate::face::FaceKind;
    use crate::solid::{Pot, Product};

    /// The lining of a pot of five rings with petals begins where the floor cuts it: at another place in every column.
    #[test]
    fn rows_that_all_columns_have_are_integrated_together() {
        let ring = |(index, r): (usize, f64)| {
            let waves = format!(r#"[{{ "n": 7, "cos": {}, "sin": {} }}]"#, 0.06 * r, 0.01 * index as f64);
            format!(
                r#"{{ "u": {}, "r": {{ "mean": {r}, "waves": {waves} }}, "z": {{ "mean": {}, "waves": {waves} }} }}"#,
                0.25 * index as f64,
                2.5 * index as f64
            )
        };
        let rings: Vec<String> = [3.0, 4.5, 4.0, 2.5, 3.0].into_iter().enumerate().map(ring).collect();
        let shape = format!(r#"{{ "kind": "rings", "rings": [{}] }}"#, rings.join(", "));
        let text = format!(
            r#"{{ "pasu": 1, "parts": [{{ "shape": {shape}, "wall": {{ "thickness": 0.3, "base": 0.5 }} }}] }}"#
        );
        let pot = Pot::new(&Design::parse(&text).unwrap(), 0, Product::Pot).unwrap();
        assert!(pot.thinned().is_none());
        let lining = pot.faces().iter().find(|face| face.kind() == FaceKind::Lining).unwrap();
        let accuracy = Accuracy::new(1e-9, 8.0).broken(vec![0.25, 0.5, 0.75]);
        let reach = Reach::of(lining, accuracy.columns);
        assert!(reach.is_ragged() && !reach.is_whole(lining), "{reach:?}");
        let n_places = Cell::new(0);
        let integrand = |jet: &FaceJet| {
            n_places.set(n_places.get() + 1);
            let element = jet.da.cross(jet.dv);
            [element.length(), jet.position.dot(element)]
        };
        let together = over(lining, &reach, &accuracy, integrand);
        let n_together = n_places.take();
        let mut walk = lining.walk();
        let apart = between((0.0, 1.0), &accuracy, |a, v| integrand(&walk.jet(a, v)));
        for i in 0..2 {
            let off = (together.value[i] - apart.value[i]).abs();
            assert!(off <= together.error[i] + apart.error[i], "{together:?} {apart:?}");
            assert!(together.error[i] <= 2e-9 * together.size[i], "{together:?}");
        }
        // Column by column in coordinates of its own every ring is a kink that each column has elsewhere.
        assert!(3 * n_together < n_places.get(), "{n_together} of {}", n_places.get());
    }
}
