//! Integrals over a face whose derivatives jump along lines: short rules of Gauss on every panel between the lines, where the integrand is smooth.

use core::f64::consts::TAU;

use super::accuracy::Accuracy;
use crate::face::{Face, FaceJet, Seams, ascending};
use crate::numeric::gauss_legendre::{FOUR, Rule, THREE, TWO, spread};
use crate::numeric::integral::{Integral, ROUNDING};
use crate::solution::Columns;

/// A panel is cut until the highest harmonic turns by no more than this over it, in radians.
const TURN: f64 = 0.6;

/// The most places at which an integrand is taken.
const MOST_PLACES: usize = 3_000_000;

/// What a rule is held against: one with a node less.
fn rules(accuracy: &Accuracy) -> [Rule; 2] {
    if accuracy.seamed < 1e-6 { [FOUR, THREE] } else { [THREE, TWO] }
}

/// Into how many pieces the widest gap between ascending places is cut at first.
fn splits(breaks: &[f64], accuracy: &Accuracy) -> usize {
    let widest = breaks.windows(2).fold(0.0f64, |widest, pair| widest.max(pair[1] - pair[0]));
    libm::ceil(accuracy.highest * widest / TURN).max(1.0) as usize
}

/// The places once round and the first again.
pub(crate) fn once_round(places: &[f64]) -> Vec<f64> {
    let first = places.first().copied().unwrap_or(0.0);
    let mut all = places.to_vec();
    if all.is_empty() {
        all.push(first);
    }
    all.push(first + TAU);
    all
}

/// The rows between two knots, with what they add up to.
struct Band<const N: usize> {
    from: f64,
    to: f64,
    splits: usize,
    integral: Integral<N>,
    of_rule: [f64; N],
}

/// Columns for a number of pieces: those of the rule and those of the shorter one, with their weights.
struct Fan {
    splits: usize,
    columns: [(Columns, Vec<f64>); 2],
}

/// Integrates between two rows, from one seam to the next; bands with the largest error are cut finer until the whole is accurate enough or has taken enough.
pub(crate) fn between_rows<const N: usize>(
    face: &dyn Face,
    seams: &Seams,
    (from, to): (f64, f64),
    accuracy: &Accuracy,
    integrand: impl Fn(&FaceJet) -> [f64; N],
) -> Integral<N> {
    let rules = rules(accuracy);
    let breaks = once_round(&seams.round);
    let mut fans: Vec<Fan> = Vec::new();
    let mut taken = 0;
    let mut walk = face.straight_walk();
    let mut band = |from: f64, to: f64, splits: usize| {
        if !fans.iter().any(|fan| fan.splits == splits) {
            let columns = rules.map(|rule| {
                let (places, weights) = spread(&breaks, splits, rule);
                (face.columns(places), weights)
            });
            fans.push(Fan { splits, columns });
        }
        let mut sums = [[0.0; N]; 2];
        let mut size = [0.0; N];
        if let Some(fan) = fans.iter().find(|fan| fan.splits == splits) {
            for ((rule, (places, weights)), sum) in rules.iter().zip(&fan.columns).zip(&mut sums) {
                taken += rule.len() * weights.len();
                for &(node, weight) in *rule {
                    let s = from + node * (to - from);
                    let mut row = [0.0; N];
                    let mut row_size = [0.0; N];
                    for (column, share) in weights.iter().enumerate() {
                        let value = integrand(&walk.jet_at(s, places, column));
                        for i in 0..N {
                            row[i] += share * value[i];
                            row_size[i] += share * value[i].abs();
                        }
                    }
                    for i in 0..N {
                        sum[i] += weight * (to - from) * row[i];
                        if rule.len() == rules[0].len() {
                            size[i] += weight * (to - from) * row_size[i];
                        }
                    }
                }
            }
        }
        let [value, shorter] = sums;
        let of_rule = core::array::from_fn(|i| above_rounding((value[i] - shorter[i]).abs(), size[i]));
        (Band { from, to, splits, integral: Integral { value, error: [0.0; N], size }, of_rule }, taken)
    };
    let rows: Vec<f64> = core::iter::once(from)
        .chain(seams.along.iter().copied().filter(|s| from < *s && *s < to))
        .chain([to])
        .collect();
    let splits = splits(&breaks, accuracy);
    let mut bands: Vec<Band<N>> = rows.windows(2).map(|pair| band(pair[0], pair[1], splits).0).collect();
    loop {
        let mut total = Integral::<N>::default();
        for band in &bands {
            total.add(&Integral { error: band.of_rule, ..band.integral });
        }
        let excess = |band: &Band<N>| {
            (0..N).fold(0.0f64, |most, i| most.max(band.of_rule[i] / (accuracy.seamed * total.size[i])))
        };
        let is_done = (0..N).all(|i| total.error[i] <= accuracy.seamed * total.size[i]);
        let worst = (0..bands.len()).max_by(|&i, &j| excess(&bands[i]).total_cmp(&excess(&bands[j])).then(j.cmp(&i)));
        let Some(worst) = worst.filter(|_| !is_done) else { return total.rounded() };
        let Band { from, to, splits, .. } = bands[worst];
        let middle = 0.5 * (from + to);
        let (lower, _) = band(from, middle, 2 * splits);
        let (upper, taken) = band(middle, to, 2 * splits);
        bands[worst] = lower;
        bands.push(upper);
        if taken > MOST_PLACES {
            let mut total = Integral::<N>::default();
            for band in &bands {
                total.add(&Integral { error: band.of_rule, ..band.integral });
            }
            return total.rounded();
        }
    }
}

/// Integrates columns that are given for several `v` at once, between ascending places that go once round; the columns come by the rule that is handed over. Twice as many are taken until
/// that is accurate enough, as a part of the size or of `at_least`, whichever is larger.
pub(crate) fn over_columns<const N: usize>(
    breaks: &[f64],
    accuracy: &Accuracy,
    at_least: [f64; N],
    mut at: impl FnMut(&[f64], Cut) -> Vec<Integral<N>>,
) -> Integral<N> {
    let mut splits = splits(breaks, accuracy);
    let mut pieces = 1;
    loop {
        let mut total = Integral::<N>::default();
        // By how much the two rules differ, and the root of the sum of its squares gap by gap: what cancels once round may do so by chance.
        let (mut difference, mut squares) = ([0.0f64; N], [0.0f64; N]);
        let [longer, shorter] = rules(accuracy).map(|rule| {
            let (places, weights) = spread(breaks, splits, rule);
            let columns = at(&places, Cut { rule, pieces });
            let share = splits * rule.len();
            let gaps = columns.chunks(share).zip(weights.chunks(share));
            gaps.map(|(columns, weights)| {
                let mut gap = Integral::<N>::default();
                for (column, weight) in columns.iter().zip(weights) {
                    gap.add(&column.scaled(*weight));
                }
                gap
            })
            .collect::<Vec<_>>()
        });
        for (one, other) in longer.iter().zip(&shorter) {
            total.add(one);
            for i in 0..N {
                let gap = one.value[i] - other.value[i];
                difference[i] += gap;
                squares[i] += gap * gap;
            }
        }
        let of_rule: [f64; N] =
            core::array::from_fn(|i| above_rounding(difference[i].abs().max(libm::sqrt(squares[i])), total.size[i]));
        let is_done = (0..N).all(|i| of_rule[i] <= accuracy.seamed * total.size[i].max(at_least[i]));
        splits *= 2;
        pieces *= 2;
        if is_done || splits * breaks.len() > MOST_COLUMNS {
            for (error, of_rule) in total.error.iter_mut().zip(of_rule) {
                *error += of_rule;
            }
            return total.rounded();
        }
    }
}

/// The most pieces of the way round.
const MOST_COLUMNS: usize = 4096;

/// How a column is integrated: a rule, and in how many pieces from one seam to the next.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Cut {
    rule: Rule,
    pieces: usize,
}

/// The integral along one column between two rows, from seam to seam; negative where it runs down.
pub(crate) fn column<const N: usize>(
    seams: &Seams,
    (from, to): (f64, f64),
    Cut { rule, pieces }: Cut,
    mut at: impl FnMut(f64) -> [f64; N],
) -> Integral<N> {
    let (low, high, sign) = if from <= to { (from, to, 1.0) } else { (to, from, -1.0) };
    let mut total = Integral::default();
    let mut below = low;
    let inner = seams.along.iter().copied().filter(|s| low < *s && *s < high);
    for above in inner.chain([high]) {
        let width = (above - below) / pieces as f64;
        for piece in 0..pieces {
            for &(node, weight) in rule {
                let value = at(below + (piece as f64 + node) * width);
                total.add(&Integral::of(value).scaled(weight * width));
            }
        }
        below = above;
    }
    total.value = total.value.map(|value| sign * value);
    total
}

/// Integrates over a whole face, with respect to `da dv`.
pub(crate) fn over_seamed<const N: usize>(
    face: &dyn Face,
    seams: &Seams,
    accuracy: &Accuracy,
    integrand: impl Fn(&FaceJet) -> [f64; N],
) -> Integral<N> {
    let breaks = all_breaks(seams);
    let (mut least, mut most) = (1.0f64, 0.0f64);
    for v in &breaks {
        let begin = begins(face, *v);
        (least, most) = (least.min(begin), most.max(begin));
    }
    let Some(first) = first_row(seams, least, most) else { return Integral::default() };
    let mut total = between_rows(face, seams, (first, 1.0), accuracy, &integrand);
    if least < first {
        let at_least = total.size;
        total.add(&over_columns(&breaks, accuracy, at_least, |places, cut| {
            let mut walk = face.straight_walk();
            let mut along = |v: f64| column(seams, (begins(face, v), first), cut, |s| integrand(&walk.jet(s, v)));
            places.iter().map(|v| along(*v)).collect()
        }));
    }
    total
}

/// The least `s` of a column.
fn begins(face: &dyn Face, v: f64) -> f64 {
    face.straight(0.0, v).min(face.straight(1.0, v))
}

/// All places round a face at which derivatives jump.
pub(crate) fn all_breaks(seams: &Seams) -> Vec<f64> {
    once_round(&ascending([&seams.round[..], &seams.crossings].concat()))
}

/// Rows are one where they differ by less than this.
const SAME: f64 = 1e-11;

/// The row from which all columns are there: the first seam above where the last begins, or that place itself where all begin together.
fn first_row(seams: &Seams, least: f64, most: f64) -> Option<f64> {
    if most - least <= SAME { Some(least) } else { seams.along.iter().copied().find(|s| *s >= most) }
}

/// The rows between which all of several stretches are, from seam to seam; `None` where they have nothing in common.
pub(crate) fn common_rows(seams: &Seams, stretches: &[(f64, f64)]) -> Option<(f64, f64)> {
    let ends = |of: fn(&(f64, f64)) -> f64| {
        let all = stretches.iter().map(of);
        all.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), s| (least.min(s), most.max(s)))
    };
    let ((least, most), (low, high)) = (ends(|stretch| stretch.0), ends(|stretch| stretch.1));
    let from = first_row(seams, least, most)?;
    let to = if high - low <= SAME { low } else { seams.along.iter().rev().copied().find(|s| *s <= low)? };
    (from < to).then_some((from, to))
}

fn above_rounding(difference: f64, size: f64) -> f64 {
    if difference > ROUNDING * size { difference } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::super::moments::enclosed;
    use super::*;
    use crate::design::Design;
    use crate::face::Face;
    use crate::solid::{Pot, Product};

    /// What is stated covers what a hundred times more is found to change.
    #[test]
    fn errors_of_thinned_walls_are_honest() {
        let jar = |n1: usize, wall: &str| {
            let shape = format!(
                r#"{{ "kind": "bloor-wilson", "a": 0.01, "r": [1, 0.1, 0.1, 0.8], "R": [-3, -0.5, -0.5, 2], "h": [3, 0.3], "H": [-0.5, -0.7], "n1": {n1} }}"#
            );
            let text = format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {shape}, "wall": {{ {wall} }} }}] }}"#);
            Design::parse(&text).unwrap()
        };
        for (n1, wall) in [
            (5, r#""thickness": 0.08, "base": 0.08"#),
            (10, r#""thickness": 0.07, "base": 0.1, "rim": "rounded""#),
            (6, r#""thickness": 0.12, "base": 0.1, "side": "outside""#),
        ] {
            let pot = Pot::new(&jar(n1, wall), 0, Product::Pot).unwrap();
            assert!(pot.thinned().is_some(), "{n1}");
            let faces: Vec<&dyn Face> = pot.faces().iter().map(|piece| piece as &dyn Face).collect();
            let usual = Accuracy::new(1e-9, (n1 + 1) as f64);
            let found = [1e-6, 1e-7, 1e-9].map(|seamed| enclosed(&faces, &Accuracy { seamed, ..usual }).1);
            let [.., fine] = found;
            for coarse in &found[..2] {
                let pairs = coarse.first.iter().zip(&fine.first).chain([(&coarse.volume, &fine.volume)]);
                for (one, other) in pairs {
                    let off = (one.value - other.value).abs();
                    assert!(off <= one.error + other.error, "{n1}: {one:?} {other:?}");
                }
                assert!(coarse.volume.error < 3e-6 * coarse.volume.value, "{n1}: {coarse:?}");
            }
            assert!(fine.volume.error < 2e-8 * fine.volume.value, "{n1}: {fine:?}");
        }
    }
}
