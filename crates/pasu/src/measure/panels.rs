//! Integrals over a face whose derivatives jump along lines: short rules of Gauss on every panel between the lines, where the integrand is smooth.

use core::f64::consts::TAU;

use super::accuracy::{Accuracy, SEAMED};
use crate::face::{Face, FaceJet, Seams, ascending};
use crate::numeric::gauss_legendre::{FOUR, Rule, THREE, TWO, spread};
use crate::numeric::integral::{Integral, ROUNDING};
use crate::solution::Columns;
use crate::watch;

/// A panel is cut until the highest harmonic turns by no more than this over it, in radians.
const TURN: f64 = 0.6;

/// The most places of a wall's side at which an integrand is taken, and as much time on any other face. Where there are more at first, several cells are one panel however rough they are, and the rules differ by what they miss of that.
const MOST_PLACES: usize = 2_100_000;

/// The same where more is asked than [`measure`](crate::measure()) asks at most, and nobody waits.
const PATIENT_PLACES: usize = 3_000_000;

fn most_places(accuracy: &Accuracy) -> usize {
    if is_patient(accuracy) { PATIENT_PLACES } else { MOST_PLACES }
}

/// What a rule is held against: one with a node less.
fn rules(accuracy: &Accuracy) -> [Rule; 2] {
    if accuracy.seamed < 1e-6 { [FOUR, THREE] } else { [THREE, TWO] }
}

/// At most `2^TOGETHER` cells between neighbouring seams are one panel at first, along and round, where second derivatives hardly jump from one to the next.
const TOGETHER: i32 = 4;

/// The fewest panels along a face at first.
const ALONG: usize = 24;

/// How finely gaps are cut: into `2^level` pieces, or `2^-level` together where that is negative.
type Level = i32;

/// The level at which the highest harmonic turns by no more than [`TURN`] over any piece; no coarser than some gaps together.
fn first_level(breaks: &[f64], accuracy: &Accuracy) -> Level {
    let widest = breaks.windows(2).fold(0.0f64, |widest, pair| widest.max(pair[1] - pair[0]));
    let mut level = 0;
    while accuracy.highest * widest > TURN * libm::exp2(f64::from(level)) && level < 10 {
        level += 1;
    }
    while 2.0 * accuracy.highest * widest <= TURN * libm::exp2(f64::from(level)) && level > -TOGETHER {
        level -= 1;
    }
    level
}

/// The level at which there are still a few panels along a face.
fn level_along(seams: &Seams) -> Level {
    let mut level = 0;
    while level > -TOGETHER && seams.along.len() >> (1 - level) >= ALONG {
        level -= 1;
    }
    level
}

/// Ascending places, of which some are left out or new ones put between two.
fn at_level(breaks: &[f64], level: Level) -> Vec<f64> {
    let Some(last) = breaks.last() else { return Vec::new() };
    if level <= 0 {
        let together = 1usize << (-level).min(30);
        return breaks[..breaks.len() - 1].iter().copied().step_by(together).chain([*last]).collect();
    }
    let pieces = 1usize << level.min(30);
    let inner = breaks.windows(2).flat_map(|pair| {
        let width = (pair[1] - pair[0]) / pieces as f64;
        let from = pair[0];
        (0..pieces).map(move |i| from + i as f64 * width)
    });
    inner.chain([*last]).collect()
}

/// The rows of panels at first: as many cells together as is allowed, but those that are rough by themselves.
fn first_rows(seams: &Seams, rows: &[f64]) -> Vec<f64> {
    let together = 1usize << (-level_along(seams)).clamp(0, 30);
    let is_rough = |s: f64| {
        let i = seams.along.partition_point(|along| *along <= s).saturating_sub(1);
        (0..seams.round.len()).any(|j| seams.is_rough(i, j))
    };
    let mut kept = Vec::with_capacity(rows.len());
    let (mut n, mut was_rough) = (0, true);
    for pair in rows.windows(2) {
        let is_rough = is_rough(0.5 * (pair[0] + pair[1]));
        if is_rough || was_rough || n >= together {
            kept.push(pair[0]);
            n = 0;
        }
        n += 1;
        was_rough = is_rough;
    }
    kept.extend(rows.last());
    kept
}

/// The places between which the panels of a band are, once round: as [`at_level`], but cells that are rough somewhere in the band are not taken together.
fn places_round(seams: &Seams, breaks: &[f64], (from, to): (f64, f64), level: Level) -> Vec<f64> {
    if level >= 0 {
        return at_level(breaks, level);
    }
    let together = 1usize << (-level).min(30);
    let first = seams.along.partition_point(|along| *along <= from).saturating_sub(1);
    let last = seams.along.partition_point(|along| *along < to).max(first + 1);
    let mut kept = Vec::with_capacity(breaks.len());
    let (mut n, mut was_rough) = (0, true);
    for (j, place) in breaks[..breaks.len().saturating_sub(1)].iter().enumerate() {
        let is_rough = (first..last).any(|i| seams.is_rough(i, j));
        if is_rough || was_rough || n >= together {
            kept.push(*place);
            n = 0;
        }
        n += 1;
        was_rough = is_rough;
    }
    kept.extend(breaks.last());
    kept
}

/// Where to cut what lies between two places: at the break nearest to the middle, or there if there is none.
fn cut(breaks: &[f64], from: f64, to: f64) -> f64 {
    let middle = 0.5 * (from + to);
    let above = breaks.partition_point(|place| *place < middle);
    let beside = [above.checked_sub(1), Some(above)].into_iter().flatten().filter_map(|i| breaks.get(i).copied());
    let within = beside.filter(|place| *place - from > 0.2 * (to - from) && to - *place > 0.2 * (to - from));
    within.min_by(|x, y| (x - middle).abs().total_cmp(&(y - middle).abs())).unwrap_or(middle)
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
    level: Level,
    integral: Integral<N>,
    of_rule: [f64; N],
}

/// Whether more is asked than [`measure`](crate::measure()) asks at most: then as many places are taken as it takes.
fn is_patient(accuracy: &Accuracy) -> bool {
    accuracy.seamed < SEAMED
}

/// A place of a column that is sought by itself takes so many times as long as one of a row,
const ALONE: usize = 2;

/// and to find where such a column begins takes as long as so many.
const BEGINNING: usize = 40;

/// How many cells each way are one panel at first, a power of two, where all of them by themselves would be too many.
fn together_at_first(n_panels: usize, accuracy: &Accuracy, cost: usize) -> usize {
    let places = n_panels.saturating_mul(places_of_a_panel(&rules(accuracy))).saturating_mul(cost);
    let mut together = 1usize;
    while !is_patient(accuracy) && places / (together * together) > MOST_PLACES {
        together *= 2;
    }
    together
}

/// The places of both rules.
fn places_of_a_panel(rules: &[Rule; 2]) -> usize {
    rules.iter().map(|rule| rule.len() * rule.len()).sum()
}

/// Columns of a level: those of the rule and those of the shorter one, with their weights.
struct Fan {
    level: Level,
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
    let mut places_so_far = 0;
    let mut walk = face.straight_walk();
    let mut band = |from: f64, to: f64, level: Level, heeds_rough: bool| {
        // Panels of several cells are those of one band alone.
        if level < 0 || !fans.iter().any(|fan| fan.level == level) {
            let places =
                if heeds_rough { places_round(seams, &breaks, (from, to), level) } else { at_level(&breaks, level) };
            let columns = rules.map(|rule| {
                let (places, weights) = spread(&places, 1, rule);
                (face.columns(places), weights)
            });
            fans.retain(|fan| fan.level != level);
            fans.push(Fan { level, columns });
        }
        let mut sums = [[0.0; N]; 2];
        let mut size = [0.0; N];
        if let Some(fan) = fans.iter().find(|fan| fan.level == level) {
            for ((rule, (places, weights)), sum) in rules.iter().zip(&fan.columns).zip(&mut sums) {
                places_so_far += rule.len() * weights.len();
                for &(node, weight) in rule.iter().take_while(|_| !watch::is_stopped()) {
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
        (Band { from, to, level, integral: Integral { value, error: [0.0; N], size }, of_rule }, places_so_far)
    };
    let rows: Vec<f64> = core::iter::once(from)
        .chain(seams.along.iter().copied().filter(|s| from < *s && *s < to))
        .chain([to])
        .collect();
    let level = first_level(&breaks, accuracy);
    let first = first_rows(seams, &rows);
    let n_panels = first.windows(2).map(|pair| places_round(seams, &breaks, (pair[0], pair[1]), level).len()).sum();
    let together = together_at_first(n_panels, accuracy, seams.cost);
    let mut bands: Vec<Band<N>> = if together == 1 {
        first.windows(2).map(|pair| band(pair[0], pair[1], level, true).0).collect()
    } else {
        let level = level - together.ilog2() as Level;
        at_level(&rows, -(together.ilog2() as Level))
            .windows(2)
            .map(|pair| band(pair[0], pair[1], level, false).0)
            .collect()
    };
    let most = most_places(accuracy) / seams.cost;
    let mut taken = 0;
    loop {
        let mut total = Integral::<N>::default();
        for band in &bands {
            total.add(&Integral { error: band.of_rule, ..band.integral });
        }
        let excess = |band: &Band<N>| {
            (0..N).fold(0.0f64, |most, i| most.max(band.of_rule[i] / (accuracy.seamed * total.size[i])))
        };
        let is_accurate = (0..N).all(|i| total.error[i] <= accuracy.seamed * total.size[i]);
        let is_done = is_accurate || taken > most || watch::is_stopped();
        let worst = (0..bands.len()).max_by(|&i, &j| excess(&bands[i]).total_cmp(&excess(&bands[j])).then(j.cmp(&i)));
        let Some(worst) = worst.filter(|_| !is_done) else { return total.rounded() };
        let Band { from, to, level, .. } = bands[worst];
        let middle = cut(&rows, from, to);
        let (lower, _) = band(from, middle, level + 1, true);
        let (upper, so_far) = band(middle, to, level + 1, true);
        taken = so_far;
        bands[worst] = lower;
        bands.push(upper);
    }
}

/// Integrates columns that are given for several `v` at once, between ascending places that go once round; the columns come by the rule that is handed over. Gaps between two places with the
/// largest errors are halved until the whole is accurate enough, as a part of the size or of `at_least`, whichever is larger: what is not smooth there is so in few of them. `n_rows` is how many cells a
/// column goes through at most.
pub(crate) fn over_columns<const N: usize>(
    breaks: &[f64],
    accuracy: &Accuracy,
    at_least: [f64; N],
    n_rows: usize,
    mut at: impl FnMut(&[f64], Cut) -> Vec<Integral<N>>,
) -> Integral<N> {
    let rules = rules(accuracy);
    // The integrals over gaps whose columns are cut as finely as said.
    let mut over = |ends: &[(f64, f64)], level: Level| -> Vec<Gap<N>> {
        let [longer, shorter] = rules.map(|rule| {
            let nodes = ends.iter().flat_map(|(from, to)| rule.iter().map(move |(node, _)| from + node * (to - from)));
            let columns = at(&nodes.collect::<Vec<f64>>(), Cut { rule, level });
            let gaps = ends.iter().zip(columns.chunks(rule.len())).map(|((from, to), columns)| {
                let mut gap = Integral::<N>::default();
                for (column, (_, weight)) in columns.iter().zip(rule) {
                    gap.add(&column.scaled(weight * (to - from)));
                }
                gap
            });
            gaps.collect::<Vec<_>>()
        });
        let pairs = longer.into_iter().zip(shorter).zip(ends);
        pairs
            .map(|((integral, shorter), &(from, to))| {
                let of_rule = core::array::from_fn(|i| integral.value[i] - shorter.value[i]);
                Gap { from, to, level, is_along: false, integral, of_rule }
            })
            .collect()
    };
    let first = first_level(breaks, accuracy).max(0);
    let cost = ALONE * n_rows + BEGINNING;
    let n_panels = breaks.len().saturating_mul(cost) << first;
    let together = together_at_first(n_panels, accuracy, 1).ilog2() as Level;
    let places = at_level(breaks, first - together);
    let ends: Vec<(f64, f64)> = places.windows(2).map(|pair| (pair[0], pair[1])).collect();
    let mut gaps = over(&ends, -together);
    // Both the halves and the places in them are counted.
    let (mut n_taken, mut n_places) = (0, 0usize);
    let places_of_a_row = |level: Level| libm::exp2(f64::from(level)) * (cost * places_of_a_panel(&rules)) as f64;
    loop {
        let mut total = Integral::<N>::default();
        // By how much the two rules differ, and the root of the sum of its squares gap by gap: what cancels once round may do so by chance.
        let (mut difference, mut squares) = ([0.0f64; N], [0.0f64; N]);
        for gap in &gaps {
            total.add(&gap.integral);
            for i in 0..N {
                difference[i] += gap.of_rule[i];
                squares[i] += gap.of_rule[i] * gap.of_rule[i];
            }
        }
        let of_rule: [f64; N] =
            core::array::from_fn(|i| above_rounding(difference[i].abs().max(libm::sqrt(squares[i])), total.size[i]));
        let allowed: [f64; N] = core::array::from_fn(|i| accuracy.seamed * total.size[i].max(at_least[i]));
        let is_done = (0..N).all(|i| of_rule[i] <= allowed[i]);
        if is_done || n_taken > MOST_COLUMNS || n_places > most_places(accuracy) || watch::is_stopped() {
            for (error, of_rule) in total.error.iter_mut().zip(of_rule) {
                *error += of_rule;
            }
            return total.rounded();
        }
        let excess = |gap: &Gap<N>| {
            (0..N).fold(0.0f64, |most, i| {
                let off = above_rounding(gap.of_rule[i].abs(), total.size[i] / gaps.len() as f64);
                if off > 0.0 { most.max(off / allowed[i]) } else { most }
            })
        };
        let excesses: Vec<f64> = gaps.iter().map(excess).collect();
        let worst = excesses.iter().fold(0.0f64, |worst, excess| worst.max(*excess));
        if !(worst > 0.0) {
            n_taken = usize::MAX;
            continue;
        }
        // What is small beside the worst, or beside what each may add, can wait.
        let least = (WAITING * worst).max((0.5 / gaps.len() as f64).min(worst));
        // Where halves of a gap were no better than the whole, it is its columns that are to be cut more finely, and the other way round.
        let mut finer: Vec<(Level, bool, Vec<Gap<N>>)> = Vec::new();
        let mut kept = Vec::with_capacity(gaps.len());
        for (gap, excess) in gaps.into_iter().zip(excesses) {
            if excess < least {
                kept.push(gap);
                continue;
            }
            match finer.iter_mut().find(|(level, is_along, _)| (*level, *is_along) == (gap.level, gap.is_along)) {
                Some((.., group)) => group.push(gap),
                None => finer.push((gap.level, gap.is_along, vec![gap])),
            }
        }
        for (level, is_along, group) in finer {
            let ends = group.iter().flat_map(|gap| {
                let middle = cut(breaks, gap.from, gap.to);
                if is_along { vec![(gap.from, gap.to)] } else { vec![(gap.from, middle), (middle, gap.to)] }
            });
            let ends: Vec<(f64, f64)> = ends.collect();
            n_taken += ends.len();
            let share = if is_along { 1 } else { 2 };
            let level = if is_along && level < FINEST { level + 1 } else { level };
            n_places = n_places.saturating_add((ends.len() as f64 * places_of_a_row(level)) as usize);
            let mut found = over(&ends, level).into_iter();
            for before in group {
                let parts: Vec<Gap<N>> = found.by_ref().take(share).collect();
                let left = |i: usize| parts.iter().map(|part| part.of_rule[i].abs()).sum::<f64>() / allowed[i];
                let was = |i: usize| before.of_rule[i].abs() / allowed[i];
                let largest = |of: &dyn Fn(usize) -> f64| (0..N).map(of).filter(|x| x.is_finite()).fold(0.0, f64::max);
                let is_useless = largest(&left) > USELESS * largest(&was);
                kept.extend(parts.into_iter().map(|part| Gap { is_along: is_along != is_useless, ..part }));
            }
        }
        gaps = kept;
    }
}

/// The columns between two places, with what they add up to.
struct Gap<const N: usize> {
    from: f64,
    to: f64,
    level: Level,
    /// Whether its columns are to be cut more finely next, not the gap itself.
    is_along: bool,
    integral: Integral<N>,
    /// By how much the longer rule finds more.
    of_rule: [f64; N],
}

/// The most halves of gaps round, besides those that are there at first.
const MOST_COLUMNS: usize = 2048;

/// Columns are cut no more than so much more finely than at first.
const FINEST: Level = 8;

/// What leaves more than this part of an error was of no use.
const USELESS: f64 = 0.6;

/// A gap waits as long as its error is less than this part of the largest.
const WAITING: f64 = 0.1;

/// How a column is integrated: a rule, and how finely the cells that it goes through are cut, or how many of them are taken together.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Cut {
    rule: Rule,
    level: Level,
}

/// The integral along one column between two rows, from seam to seam; negative where it runs down.
pub(crate) fn column<const N: usize>(
    seams: &Seams,
    (from, to): (f64, f64),
    Cut { rule, level }: Cut,
    mut at: impl FnMut(f64) -> [f64; N],
) -> Integral<N> {
    let (low, high, sign) = if from <= to { (from, to, 1.0) } else { (to, from, -1.0) };
    let mut total = Integral::default();
    let mut below = low;
    let pieces = 1usize << level.clamp(0, 30);
    let together = 1usize << (-level).clamp(0, 30);
    let rows = seams.along.iter().copied().filter(|s| low < *s && *s < high).skip(together - 1).step_by(together);
    for above in rows.chain([high]).take_while(|_| !watch::is_stopped()) {
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
    let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for v in &breaks {
        let (begin, end) = (begins(face, *v), ends(face, *v));
        (least, most, low, high) = (least.min(begin), most.max(begin), low.min(end), high.max(end));
    }
    let rows = first_row(seams, least, most).zip(last_row(seams, low, high)).filter(|(first, last)| first < last);
    // Without rows that all columns have, every column by itself from the middle.
    let (first, last) = rows.unwrap_or((0.5 * (most + low), 0.5 * (most + low)));
    let mut total =
        if first < last { between_rows(face, seams, (first, last), accuracy, &integrand) } else { Integral::default() };
    if least < first || last < high {
        let at_least = total.size;
        let n_rows = cells_between(seams, least, first).max(cells_between(seams, last, high));
        total.add(&over_columns(&breaks, accuracy, at_least, n_rows, |places, cut| {
            let mut walk = face.straight_walk();
            let mut along = |v: f64| {
                let mut sum = Integral::default();
                // To find where a column begins takes long, and goes nowhere once all stops.
                if watch::is_stopped() {
                    return sum;
                }
                for stretch in
                    [(begins(face, v), first), (last, ends(face, v))].into_iter().filter(|(from, to)| from != to)
                {
                    sum.add(&column(seams, stretch, cut, |s| integrand(&walk.jet(s, v))));
                }
                sum
            };
            places.iter().map(|v| along(*v)).collect()
        }));
    }
    total
}

/// The least `s` of a column.
fn begins(face: &dyn Face, v: f64) -> f64 {
    face.straight(0.0, v).min(face.straight(1.0, v))
}

/// The greatest.
fn ends(face: &dyn Face, v: f64) -> f64 {
    face.straight(0.0, v).max(face.straight(1.0, v))
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

/// The last seam beneath where the first column ends, or that place itself where all end together.
fn last_row(seams: &Seams, low: f64, high: f64) -> Option<f64> {
    if high - low <= SAME { Some(high) } else { seams.along.iter().rev().copied().find(|s| *s <= low) }
}

/// How many cells a column goes through between two places.
pub(crate) fn cells_between(seams: &Seams, from: f64, to: f64) -> usize {
    let before = |s: f64| seams.along.partition_point(|along| *along < s);
    before(from).abs_diff(before(to)) + 1
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
            let found = [1e-5, 1e-6, 1e-8].map(|seamed| enclosed(&faces, &Accuracy { seamed, ..usual.clone() }).1);
            let [.., fine] = found;
            for coarse in &found[..2] {
                let pairs = coarse.first.iter().zip(&fine.first).chain([(&coarse.volume, &fine.volume)]);
                for (one, other) in pairs {
                    let off = (one.value - other.value).abs();
                    assert!(off <= one.error + other.error, "{n1}: {one:?} {other:?}");
                }
                assert!(coarse.volume.error < 3e-5 * coarse.volume.value, "{n1}: {coarse:?}");
            }
            assert!(fine.volume.error < 3e-7 * fine.volume.value, "{n1}: {fine:?}");
        }
    }
}
