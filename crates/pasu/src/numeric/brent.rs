//! Brent's method: the least value of a function of one variable, by golden sections and parabolas (R. P. Brent, *Algorithms for minimization without derivatives*, 1973, chapter 5).

/// The most steps: with golden sections alone 100 would leave 1e-21 of the interval.
const MOST_STEPS: usize = 100;

/// The smaller part of a golden section, `(3 - sqrt(5)) / 2`.
const GOLDEN: f64 = 0.381_966_011_250_105_1;

/// The place of the least value of a function between two ends, and the value.
///
/// Ends when the place is known to twice the `tolerance`, which is a distance and greater than 0; less than the root of the rounding of a smooth function's value is of no use. Where there are several minima one of them is found, at an end if there is
/// none between: then within twice the tolerance of it. No value is formed at the ends themselves.
pub(crate) fn least(from: f64, to: f64, tolerance: f64, mut of: impl FnMut(f64) -> f64) -> (f64, f64) {
    let (mut low, mut high) = (from, to);
    let mut x = low + GOLDEN * (high - low);
    let (mut w, mut v, mut fx) = (x, x, of(x));
    let (mut fw, mut fv) = (fx, fx);
    let (mut step, mut before) = (0.0f64, 0.0f64);
    for _ in 0..MOST_STEPS {
        let middle = 0.5 * (low + high);
        if (x - middle).abs() <= 2.0 * tolerance - 0.5 * (high - low) {
            break;
        }
        let (mut p, mut q, mut r) = (0.0, 0.0, 0.0);
        if before.abs() > tolerance {
            r = (x - w) * (fx - fv);
            q = (x - v) * (fx - fw);
            p = (x - v) * q - (x - w) * r;
            q = 2.0 * (q - r);
            if q > 0.0 {
                p = -p;
            } else {
                q = -q;
            }
            r = before;
            before = step;
        }
        if p.abs() < (0.5 * q * r).abs() && p > q * (low - x) && p < q * (high - x) {
            step = p / q;
            let u = x + step;
            if u - low < 2.0 * tolerance || high - u < 2.0 * tolerance {
                step = if x < middle { tolerance } else { -tolerance };
            }
        } else {
            before = if x < middle { high - x } else { low - x };
            step = GOLDEN * before;
        }
        let u = x + if step.abs() >= tolerance { step } else { libm::copysign(tolerance, step) };
        let fu = of(u);
        if fu <= fx {
            if u < x {
                high = x;
            } else {
                low = x;
            }
            (v, fv, w, fw, x, fx) = (w, fw, x, fx, u, fu);
        } else {
            if u < x {
                low = u;
            } else {
                high = u;
            }
            if fu <= fw || w == x {
                (v, fv, w, fw) = (w, fw, u, fu);
            } else if fu <= fv || v == x || v == w {
                (v, fv) = (u, fu);
            }
        }
    }
    (x, fx)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_parabola_and_a_kink() {
        let mut n = 0;
        let (x, value) = least(0.0, 3.0, 1e-9, |x| {
            n += 1;
            (x - 1.7).powi(2) + 4.0
        });
        assert!((x - 1.7).abs() < 1e-7 && (value - 4.0).abs() < 1e-15 && n < 30, "{x} {value} {n}");
        let (x, _) = least(0.0, 3.0, 1e-9, |x| (x - 1.7).abs());
        assert!((x - 1.7).abs() < 1e-8);
    }

    #[test]
    fn least_at_an_end() {
        let (x, value) = least(2.0, 5.0, 1e-9, |x| x * x);
        assert!((x - 2.0).abs() < 3e-9 && value == x * x, "{x}");
        let (x, _) = least(2.0, 5.0, 1e-9, |x| -x);
        assert!((x - 5.0).abs() < 3e-9, "{x}");
    }
}
