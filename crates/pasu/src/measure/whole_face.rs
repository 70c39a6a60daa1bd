//! Integrals over a whole face, each kind of face by the rule that suits it.

use core::f64::consts::TAU;

use super::accuracy::Accuracy;
use super::integral::between;
use super::panels;
use super::trimmed::{self, Reach};
use crate::face::{Face, FaceJet};
use crate::numeric::adaptive;
use crate::numeric::integral::Integral;

/// Integrates over the whole face, with respect to `da dv`: the integrand brings its own area element.
pub(crate) fn over_face<const N: usize>(
    face: &dyn Face,
    accuracy: &Accuracy,
    integrand: impl Fn(&FaceJet) -> [f64; N],
) -> Integral<N> {
    match face.seams() {
        _ if !face.is_closed() => over_open(face, accuracy, integrand),
        Some(seams) => panels::over_seamed(face, &seams, accuracy, integrand),
        None => {
            let reach = Reach::of(face, accuracy.columns);
            if !reach.is_whole(face) {
                return trimmed::over(face, &reach, accuracy, integrand);
            }
            let mut walk = face.walk();
            between((0.0, 1.0), accuracy, |a, v| integrand(&walk.jet(a, v)))
        }
    }
}

/// As [`over_face`], where `v = 0` and `v = 2 pi` are two curves: Gauss-Kronrod both ways, from knot to knot.
fn over_open<const N: usize>(
    face: &dyn Face,
    accuracy: &Accuracy,
    integrand: impl Fn(&FaceJet) -> [f64; N],
) -> Integral<N> {
    let (mut rows, mut turn) = (vec![0.0, 1.0], vec![0.0, TAU]);
    if let Some(seams) = face.seams() {
        rows = seams.along;
        turn = core::iter::once(0.0).chain(seams.round.into_iter().filter(|v| *v > 0.0)).chain([TAU]).collect();
    }
    let most_panels = accuracy.most_intervals.max(2 * turn.len()).max(accuracy.highest as usize);
    let mut walk = face.walk();
    let mut largest = [0.0f64; N];
    adaptive::integrate(&rows, accuracy.relative, [0.0; N], accuracy.most_intervals.max(2 * rows.len()), |a| {
        let row = adaptive::integrate(&turn, accuracy.relative, largest, most_panels, |v| {
            Integral::of(integrand(&walk.jet(a, v)))
        });
        for (largest, size) in largest.iter_mut().zip(row.size) {
            *largest = largest.max(size);
        }
        row
    })
}
