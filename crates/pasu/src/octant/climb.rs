//! A power of a share that climbs from 0 to 1.
//!
//! A point of the curve `x^a + y^b = 1` is told by the share `p` of `x^a`, of which `x = p^(1/a)` and `y = (1 - p)^(1/b)` have infinite derivatives at the ends. With `p = s^k / (s^k + (1 - s)^l)` they have none: at `s = 0`
//! `x` goes as `s^(k/a)` and `y` as `1 - s^k / b`, and both `k` and `k/a` are 1, or 2 and more.

/// `(s^k / (s^k + (1 - s)^l))^g`, or the same of one minus that share.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Climb {
    /// Of the rising one: a falling one is a rising one of `1 - s`.
    k: f64,
    l: f64,
    g: f64,
    /// `k g`, to the bit where it is 1 or 2.
    m: f64,
    is_falling: bool,
}

/// The least power of `s` with which what has these exponents has bounded second derivatives: it and its quotient by each of them are 1, or 2 and more.
pub(super) fn power(exponents: &[f64]) -> f64 {
    let is_smooth = |k: f64| k == 1.0 || k >= 2.0;
    let is_enough = |k: f64| is_smooth(k) && exponents.iter().all(|exponent| is_smooth(quotient(k, *exponent)));
    let largest = exponents.iter().fold(1.0f64, |most, exponent| most.max(*exponent));
    let tried = exponents.iter().flat_map(|exponent| [*exponent, 2.0 * exponent]).chain([1.0, 2.0]);
    tried.filter(|k| is_enough(*k)).fold(2.0 * largest, f64::min)
}

/// `k / exponent`, to the bit where it is 1 or 2.
fn quotient(k: f64, exponent: f64) -> f64 {
    if k == exponent {
        1.0
    } else if k == 2.0 * exponent {
        2.0
    } else {
        k / exponent
    }
}

/// A share of the exponent 1, of which these are the powers at either end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Share {
    pub(super) k: f64,
    pub(super) l: f64,
}

impl Share {
    /// `p^(1/exponent)`.
    pub(super) fn rising(self, exponent: f64) -> Climb {
        let Share { k, l } = self;
        Climb { k, l, g: 1.0 / exponent, m: quotient(k, exponent), is_falling: false }
    }

    /// `(1 - p)^(1/exponent)`.
    pub(super) fn falling(self, exponent: f64) -> Climb {
        let Share { k: l, l: k } = self;
        Climb { k, l, g: 1.0 / exponent, m: quotient(k, exponent), is_falling: true }
    }

    /// The logarithms of the share and of what is left, at an end those of the next place that there is.
    pub(super) fn logarithms(self, s: f64) -> [f64; 2] {
        let [ls, lt] = [s, 1.0 - s].map(|x| libm::log(x.max(NEXT)));
        let (rising, falling) = (self.k * ls, self.l * lt);
        let sum = log_sum(rising, falling);
        [rising - sum, falling - sum]
    }

    /// How many waves resolve it: it climbs most where it is a half.
    pub(super) fn waves(self) -> f64 {
        0.5 + 0.25 * (self.k + self.l)
    }
}

/// The place next to an end.
const NEXT: f64 = 1e-300;

/// The logarithms of `s` and `t = 1 - s`, of the smaller one to all its digits.
fn shares(s: f64, t: f64) -> [f64; 2] {
    if s < t { [libm::log(s), libm::log1p(-s)] } else { [libm::log1p(-t), libm::log(t)] }
}

/// `log(exp a + exp b)`.
fn log_sum(a: f64, b: f64) -> f64 {
    let (least, greatest) = if a < b { (a, b) } else { (b, a) };
    if greatest == f64::NEG_INFINITY { greatest } else { greatest + libm::log1p(libm::exp(least - greatest)) }
}

/// A bound is larger than what it bounds by more than rounding.
const ROUNDING: f64 = 1.0 + 1e-12;

/// `c s^es t^et D^-ed` with `t = 1 - s` and `D = s^k + t^l`; each exponent is not negative where `c` is not 0.
#[derive(Clone, Copy)]
struct Term {
    c: f64,
    es: f64,
    et: f64,
    ed: f64,
}

/// The logarithms of `s`, `t` and `D`, or bounds of them.
#[derive(Clone, Copy)]
struct Logarithms {
    s: f64,
    t: f64,
    d: f64,
}

impl Term {
    fn of(self, at: Logarithms) -> f64 {
        if self.c == 0.0 {
            return 0.0;
        }
        let times = |exponent: f64, logarithm: f64| if exponent == 0.0 { 0.0 } else { exponent * logarithm };
        self.c * libm::exp(times(self.es, at.s) + times(self.et, at.t) - self.ed * at.d)
    }

    /// The least and the greatest on an interval of these least and greatest logarithms; `c` is not negative.
    fn range(self, least: Logarithms, greatest: Logarithms) -> [f64; 2] {
        // The power of `s` is negative for `s` of a half and more, where it falls.
        let s = if self.es < 0.0 { [greatest.s, least.s] } else { [least.s, greatest.s] };
        let t = if self.et < 0.0 { [greatest.t, least.t] } else { [least.t, greatest.t] };
        [self.of(Logarithms { s: s[0], t: t[0], d: greatest.d }), self.of(Logarithms { s: s[1], t: t[1], d: least.d })]
    }

    /// The greatest alone, to the bit.
    fn greatest(self, least: Logarithms, greatest: Logarithms) -> f64 {
        let s = if self.es < 0.0 { least.s } else { greatest.s };
        let t = if self.et < 0.0 { least.t } else { greatest.t };
        self.of(Logarithms { s, t, d: least.d })
    }
}

impl Climb {
    /// Value, first and second derivative.
    pub(super) fn jet(&self, s: f64) -> [f64; 3] {
        if self.is_falling {
            let [value, first, second] = self.rising(1.0 - s, s);
            [value, 0.0 - first, second]
        } else {
            self.rising(s, 1.0 - s)
        }
    }

    /// The value alone, to the bit that of the jet.
    pub(super) fn value(&self, s: f64) -> f64 {
        let (s, t) = if self.is_falling { (1.0 - s, s) } else { (s, 1.0 - s) };
        let [ls, lt] = shares(s, t);
        self.value_at(ls, lt)
    }

    /// The value where `s` and `t` have these logarithms. At `s = 1` to the bit: there what is left is nothing.
    fn value_at(&self, s: f64, t: f64) -> f64 {
        libm::exp(-self.g * libm::log1p(libm::exp(self.l * t - self.k * s)))
    }

    fn rising(&self, s: f64, t: f64) -> [f64; 3] {
        let at = self.logarithms(s, t);
        let value = self.value_at(at.s, at.t);
        let w = self.k * t + self.l * s;
        let first = w * self.slope().of(at);
        let (up, down) = self.bends(s <= 0.5);
        let second = up.iter().map(|term| term.of(at)).sum::<f64>() - down.iter().map(|term| term.of(at)).sum::<f64>();
        // The one term that has W^2 in it stands first.
        let squared = |terms: &[Term]| terms[0].of(at) * (w * w - 1.0);
        let second = if s <= 0.5 { second - squared(&down) } else { second + squared(&up) };
        [value, first, second]
    }

    fn logarithms(&self, s: f64, t: f64) -> Logarithms {
        let [s, t] = shares(s, t);
        Logarithms { s, t, d: log_sum(self.k * s, self.l * t) }
    }

    /// The first derivative but for the factor `W = k t + l s`.
    fn slope(&self) -> Term {
        Term { c: self.g, es: self.m - 1.0, et: self.l - 1.0, ed: self.g + 1.0 }
    }

    /// What the second derivative is the difference of, in the form that loses nothing near its end of the interval: of a sum `g s^(m-2) t^(l-2) D^(-g-1) { .. }` the powers of `s` are written out for `s` up to a half, those of `t` from there on.
    /// The first term of the second list, or from a half on of the first one, has a factor `W^2` besides.
    fn bends(&self, is_near_0: bool) -> ([Term; 3], [Term; 3]) {
        let Climb { k, l, g, m, .. } = *self;
        let ed = g + 1.0;
        let of = |c: f64, es: f64, et: f64| Term { c: g * c, es, et, ed };
        let nothing = Term { c: 0.0, es: 0.0, et: 0.0, ed: 0.0 };
        if is_near_0 {
            let up = [
                // Where m is 1 it is not there.
                of(k * (m - 1.0), m - 2.0, l),
                of(2.0 * m * l, m - 1.0, l - 1.0),
                of(l * (g * l + 1.0), m, l - 2.0),
            ];
            let squared = Term { c: g * ed, es: m + k - 2.0, et: l - 2.0, ed: ed + 1.0 };
            (up, [squared, nothing, nothing])
        } else {
            let squared = Term { c: g * ed, es: m - 2.0, et: 2.0 * l - 2.0, ed: ed + 1.0 };
            let down = [
                // Where l is 1 it is not there.
                of(l * (l - 1.0), m, l - 2.0),
                of(2.0 * k * l, m - 1.0, l - 1.0),
                of(k * (k + 1.0), m - 2.0, l),
            ];
            ([squared, nothing, nothing], down)
        }
    }

    /// Suprema of the value and of both derivatives.
    pub(super) fn suprema(&self, [from, to]: [f64; 2]) -> [f64; 3] {
        let mut most = [0.0f64; 3];
        for [from, to] in [[from, to.min(0.5)], [from.max(0.5), to]] {
            if from > to {
                continue;
            }
            let ends = if self.is_falling {
                [(1.0 - to, to), (1.0 - from, from)]
            } else {
                [(from, 1.0 - from), (to, 1.0 - to)]
            };
            for (most, bound) in most.iter_mut().zip(self.bounds(ends)) {
                *most = most.max(bound * ROUNDING);
            }
        }
        most
    }

    /// The same of the rising one between two places on one side of a half.
    fn bounds(&self, [(s, t), (later, left)]: [(f64, f64); 2]) -> [f64; 3] {
        let (low, high) = (shares(s, t), shares(later, left));
        let Climb { k, l, .. } = *self;
        let bound = |s: f64, t: f64| Logarithms { s, t, d: log_sum(k * s, l * t) };
        let (least, greatest) = (bound(low[0], high[1]), bound(high[0], low[1]));
        let (one, other) = (k * t + l * s, k * left + l * later);
        let w = [one.min(other), one.max(other)];
        let first = self.slope().greatest(least, greatest);
        let is_near_0 = later <= 0.5;
        let (up, down) = self.bends(is_near_0);
        let sum = |terms: [Term; 3], is_squared: bool| {
            let mut sum = [0.0; 2];
            for (index, term) in terms.into_iter().enumerate() {
                let range = term.range(least, greatest);
                for end in 0..2 {
                    sum[end] += range[end] * if is_squared && index == 0 { w[end] * w[end] } else { 1.0 };
                }
            }
            sum
        };
        let (up, down) = (sum(up, !is_near_0), sum(down, is_near_0));
        [self.value_at(high[0], high[1]), w[1] * first, (up[1] - down[0]).max(down[1] - up[0])]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Climbs of all sorts of exponents, those at the limits and between which the powers change among them.
    fn climbs() -> Vec<Climb> {
        let exponents = [0.05, 0.3, 0.5, 0.7, 1.0, 1.3, 2.0, 3.5, 50.0];
        let mut all = Vec::new();
        for a in exponents {
            for b in exponents {
                let share = Share { k: power(&[a]), l: power(&[b]) };
                all.extend([share.rising(a), share.falling(b)]);
                let share = Share { k: power(&[a, b]), l: power(&[2.0]) };
                all.extend([share.rising(a), share.rising(b), share.falling(2.0)]);
            }
        }
        all
    }

    #[test]
    fn powers_are_the_least_that_are_smooth() {
        for (exponents, expected) in [
            (&[2.0][..], 2.0),
            (&[1.0], 1.0),
            (&[0.5], 1.0),
            (&[0.05], 1.0),
            (&[0.7], 2.0),
            (&[1.5], 3.0),
            (&[50.0], 50.0),
            (&[0.5, 3.0], 3.0),
            (&[2.0, 3.0], 6.0),
        ] {
            assert_eq!(power(exponents), expected, "{exponents:?}");
        }
    }

    #[test]
    fn derivatives_are_those_of_the_value() {
        for climb in climbs() {
            for i in 1..200 {
                let (s, h) = (f64::from(i) / 200.0, 1e-6);
                let [value, first, second] = climb.jet(s);
                assert_eq!(climb.value(s).to_bits(), value.to_bits(), "{climb:?} {s}");
                let [after, before] = [s + h, s - h].map(|s| climb.jet(s));
                let scale = climb.suprema([s - h, s + h]);
                let slope = (after[0] - before[0]) / (2.0 * h);
                assert!((first - slope).abs() <= 1e-6 * (1.0 + scale[1] + scale[2]), "{climb:?} {s}: {first} {slope}");
                let slope = (after[1] - before[1]) / (2.0 * h);
                assert!((second - slope).abs() <= 1e-4 * (1.0 + scale[2]), "{climb:?} {s}: {second} {slope}");
            }
        }
    }

    #[test]
    fn the_ends_are_met_to_the_bit() {
        for climb in climbs() {
            let ends = [0.0, 1.0].map(|s| climb.jet(s));
            assert_eq!([ends[0][0], ends[1][0]], if climb.is_falling { [1.0, 0.0] } else { [0.0, 1.0] });
            assert!(ends.iter().flatten().all(|x| x.is_finite()), "{climb:?} {ends:?}");
        }
    }

    #[test]
    fn suprema_bound_and_are_no_larger_on_smaller_intervals() {
        for climb in climbs() {
            for n in [1u32, 3, 8, 50] {
                for i in 0..n {
                    let [from, to] = [i, i + 1].map(|i| f64::from(i) / f64::from(n));
                    let bounds = climb.suprema([from, to]);
                    for j in 0..=16 {
                        let s = from + (to - from) * f64::from(j) / 16.0;
                        for (found, bound) in climb.jet(s).into_iter().zip(bounds) {
                            assert!(found.abs() <= bound, "{climb:?} {s} {found} {bound}");
                        }
                    }
                    let middle = 0.5 * (from + to);
                    for half in [[from, middle], [middle, to]] {
                        let smaller = climb.suprema(half);
                        assert!(
                            (0..3).all(|i| smaller[i] <= bounds[i] * ROUNDING),
                            "{climb:?} {half:?} {smaller:?} {bounds:?}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn suprema_come_near_to_what_they_bound() {
        for climb in climbs() {
            // What cancels is measured by the largest anywhere.
            let all = (0..=256).map(|i| climb.jet(f64::from(i) / 256.0));
            let all = all.fold([0.0f64; 3], |most, jet| core::array::from_fn(|i| most[i].max(jet[i].abs())));
            let n = 65536u32;
            for i in (0..n).step_by(331) {
                let [from, to] = [i, i + 1].map(|i| f64::from(i) / f64::from(n));
                let bounds = climb.suprema([from, to]);
                let found = (0..=4).map(|j| climb.jet(from + (to - from) * f64::from(j) / 4.0));
                let most = found.fold([0.0f64; 3], |most, jet| core::array::from_fn(|i| most[i].max(jet[i].abs())));
                for order in 0..3 {
                    let (bound, most) = (bounds[order], most[order]);
                    assert!(bound <= most + 0.25 * (1.0 + all[order]), "{climb:?} {from} {order} {bound} {most}");
                }
            }
        }
    }
}
