//! Binary numbers to decimal digits and back, exactly, by whole numbers of any length.
//!
//! The standard library does the same faster, with tables and with special ways for the common cases that come to 20 kB (gzip) of the
//! WebAssembly module. A design has few numbers and is read once; the tests compare every result with the standard library's.

use core::cmp::Ordering;

/// `digits * 10^power`, the digits without leading and trailing zeros.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Decimal {
    /// From 0 to 9 each; none for zero.
    pub(super) digits: Vec<u8>,
    pub(super) power: i32,
}

/// More digits than these decide nothing but whether something follows: halfway between two numbers lie at most 767.
const MOST_DIGITS: usize = 800;

/// Nine digits at a time.
const BILLION: u32 = 1_000_000_000;

impl Decimal {
    /// The fewest digits that read back as `x`, and of those the nearest to it. Of the sign nothing is kept; `x` is finite.
    pub(super) fn shortest(x: f64) -> Decimal {
        let (mantissa, exponent) = parts(x);
        if mantissa == 0 {
            return Decimal { digits: Vec::new(), power: 0 };
        }
        // Whatever lies between the neighbours' middles reads as `x`; below a power of two numbers lie twice as close.
        let is_power = mantissa == 1 << 52 && exponent > LEAST_EXPONENT;
        let at = |quarters: u64| exact(quarters, exponent - 2);
        let low = at(4 * mantissa - if is_power { 1 } else { 2 });
        let high = at(4 * mantissa + 2);
        let middle = at(4 * mantissa);
        let length = high.len();
        let [low, middle] = [low, middle].map(|digits| [vec![0; length - digits.len()], digits].concat());
        let is_even = mantissa % 2 == 0;
        let mut n = 1;
        loop {
            let down = &middle[..n];
            let up = next(down);
            let fits_down = match down.cmp(&low[..n]) {
                Ordering::Equal => is_even && low[n..].iter().all(|digit| *digit == 0),
                order => order.is_gt(),
            };
            let fits_up = up.as_deref().is_some_and(|up| match up.cmp(&high[..n]) {
                Ordering::Equal => is_even || high[n..].iter().any(|digit| *digit != 0),
                order => order.is_lt(),
            });
            let digits = match (fits_down, fits_up) {
                (true, true) if middle.get(n).is_none_or(|digit| *digit < 5) => down.to_vec(),
                (true, false) => down.to_vec(),
                (_, true) => up.unwrap_or_default(),
                // At full length `down` is the number itself.
                (false, false) => {
                    n += 1;
                    continue;
                }
            };
            return Decimal { digits, power: (length - n) as i32 + (exponent - 2).min(0) }.trimmed();
        }
    }

    /// `x` rounded to a number of significant digits, or with `places` to a number of digits after the point; ties to even. `x` is finite.
    pub(super) fn rounded(x: f64, n_digits: usize, places: Option<usize>) -> Decimal {
        let (mantissa, exponent) = parts(x);
        let digits = exact(mantissa, exponent);
        let power = exponent.min(0);
        let n = match places {
            None => n_digits as i32,
            Some(places) => digits.len() as i32 + power + places as i32,
        };
        let Ok(n) = usize::try_from(n) else { return Decimal { digits: Vec::new(), power: 0 } };
        if n >= digits.len() {
            return Decimal { digits, power }.trimmed();
        }
        let (kept, rest) = digits.split_at(n);
        let is_odd = kept.last().is_some_and(|digit| digit % 2 == 1);
        let is_up = match rest[0].cmp(&5) {
            Ordering::Equal => is_odd || rest[1..].iter().any(|digit| *digit != 0),
            order => order.is_gt(),
        };
        // What rounds up to one more digit is a power of ten.
        let kept = if is_up { next(kept).unwrap_or_else(|| [vec![1], vec![0; n]].concat()) } else { kept.to_vec() };
        Decimal { digits: kept, power: power + rest.len() as i32 }.trimmed()
    }

    /// The nearest number, ties to even; infinity beyond the largest.
    pub(super) fn nearest(mut self) -> f64 {
        if self.digits.len() <= 15 && self.power.unsigned_abs() <= 22 {
            // Both are whole numbers that a double holds exactly, so that the one operation rounds once.
            let whole = self.digits.iter().fold(0.0, |sum, digit| 10.0 * sum + f64::from(*digit));
            let power = (0..self.power.unsigned_abs()).fold(1.0, |power, _| 10.0 * power);
            return if self.power < 0 { whole / power } else { whole * power };
        }
        if let Some(rest) = self.digits.get(MOST_DIGITS..).filter(|rest| !rest.is_empty()) {
            self.power = self.power.saturating_add(rest.len() as i32 - 1);
            let any = rest.iter().any(|digit| *digit != 0);
            self.digits.truncate(MOST_DIGITS);
            self.digits.push(any.into());
        }
        let mut decimal = self.trimmed();
        match (decimal.digits.len() as i32).saturating_add(decimal.power) {
            _ if decimal.digits.is_empty() => return 0.0,
            ..-330 => return 0.0,
            311.. => return f64::INFINITY,
            _ => {}
        }
        let mut whole = Whole::default();
        for nine in decimal.digits.chunks(9) {
            let number = nine.iter().fold(0, |number, digit| 10 * number + u32::from(*digit));
            whole.multiply_add(10_u32.pow(nine.len() as u32), number);
        }
        while decimal.power > 0 {
            let step = decimal.power.unsigned_abs().min(9);
            whole.multiply_add(10_u32.pow(step), 0);
            decimal.power -= step as i32;
        }
        // As many binary places as leave more than 64 bits after the division; 10^3 < 2^10.
        let places = decimal.power.unsigned_abs() * 10 / 3 + 96;
        whole.shift(places);
        let mut is_inexact = false;
        while decimal.power < 0 {
            let step = decimal.power.unsigned_abs().min(9);
            is_inexact |= whole.divide(10_u32.pow(step)) != 0;
            decimal.power += step as i32;
        }
        whole.nearest(places, is_inexact)
    }

    fn trimmed(mut self) -> Decimal {
        while self.digits.last() == Some(&0) {
            self.digits.pop();
            self.power = self.power.saturating_add(1);
        }
        let n_leading = self.digits.iter().take_while(|digit| **digit == 0).count();
        self.digits.drain(..n_leading);
        self
    }
}

/// Reads a number as people and programs write it: `12`, `-.5`, `1.`, `2.5e-3`, and what is none but called so, `inf` and `nan`.
pub(crate) fn parse(text: &str) -> Option<f64> {
    let (sign, unsigned) = match text.as_bytes() {
        [b'-', rest @ ..] => (-1.0, rest),
        [b'+', rest @ ..] => (1.0, rest),
        rest => (1.0, rest),
    };
    if [&b"inf"[..], b"infinity"].iter().any(|name| unsigned.eq_ignore_ascii_case(name)) {
        return Some(sign * f64::INFINITY);
    }
    if unsigned.eq_ignore_ascii_case(b"nan") {
        return Some(f64::NAN);
    }
    let end = unsigned.iter().position(|byte| matches!(byte, b'e' | b'E')).unwrap_or(unsigned.len());
    let (mantissa, exponent) = unsigned.split_at(end);
    let mut decimal = Decimal { digits: Vec::new(), power: 0 };
    let mut has_point = false;
    for byte in mantissa {
        match byte {
            b'0'..=b'9' => {
                decimal.digits.push(byte - b'0');
                decimal.power -= i32::from(has_point);
            }
            b'.' if !has_point => has_point = true,
            _ => return None,
        }
    }
    if decimal.digits.is_empty() {
        return None;
    }
    if let [_, exponent @ ..] = exponent {
        let (is_negative, digits) = match exponent {
            [b'-', rest @ ..] => (true, rest),
            [b'+', rest @ ..] => (false, rest),
            rest => (false, rest),
        };
        if digits.is_empty() || !digits.iter().all(u8::is_ascii_digit) {
            return None;
        }
        let size = digits.iter().fold(0_i32, |sum, byte| sum.saturating_mul(10).saturating_add(i32::from(byte - b'0')));
        decimal.power = decimal.power.saturating_add(if is_negative { -size } else { size });
    }
    Some(sign * decimal.nearest())
}

/// The exponent of the numbers next to zero.
const LEAST_EXPONENT: i32 = -1074;

/// `|x| = mantissa * 2^exponent`.
fn parts(x: f64) -> (u64, i32) {
    let bits = x.to_bits();
    let (biased, fraction) = (bits >> 52 & 0x7ff, bits & ((1 << 52) - 1));
    match biased {
        0 => (fraction, LEAST_EXPONENT),
        _ => (fraction | 1 << 52, biased as i32 - 1 + LEAST_EXPONENT),
    }
}

/// The digits of `mantissa * 2^exponent`, times `10^-exponent` where the exponent is negative.
fn exact(mantissa: u64, exponent: i32) -> Vec<u8> {
    let mut whole = Whole::default();
    whole.multiply_add(1, (mantissa >> 32) as u32);
    whole.shift(32);
    whole.multiply_add(1, mantissa as u32);
    // 2^-1 is 5 * 10^-1; 5^13 < 2^32.
    let mut fives = exponent.min(0).unsigned_abs();
    while fives > 0 {
        let step = fives.min(13);
        whole.multiply_add(5_u32.pow(step), 0);
        fives -= step;
    }
    whole.shift(exponent.max(0).unsigned_abs());
    whole.digits()
}

/// The next number of as many digits; `None` after the last.
fn next(digits: &[u8]) -> Option<Vec<u8>> {
    let mut next = digits.to_vec();
    for digit in next.iter_mut().rev() {
        if *digit < 9 {
            *digit += 1;
            return Some(next);
        }
        *digit = 0;
    }
    None
}

/// A whole number, its lowest 32 bits first, without zeros at the end.
#[derive(Default)]
struct Whole(Vec<u32>);

impl Whole {
    fn multiply_add(&mut self, factor: u32, summand: u32) {
        let mut carry = summand;
        for limb in &mut self.0 {
            let product = u64::from(*limb) * u64::from(factor) + u64::from(carry);
            *limb = product as u32;
            carry = (product >> 32) as u32;
        }
        if carry != 0 {
            self.0.push(carry);
        }
    }

    /// Divides and returns the remainder.
    fn divide(&mut self, divisor: u32) -> u32 {
        let mut remainder = 0;
        for limb in self.0.iter_mut().rev() {
            let dividend = u64::from(remainder) << 32 | u64::from(*limb);
            *limb = (dividend / u64::from(divisor)) as u32;
            remainder = (dividend % u64::from(divisor)) as u32;
        }
        while self.0.last() == Some(&0) {
            self.0.pop();
        }
        remainder
    }

    /// Times a power of two.
    fn shift(&mut self, bits: u32) {
        self.multiply_add(1 << (bits % 32), 0);
        if !self.0.is_empty() {
            self.0.splice(0..0, vec![0; (bits / 32) as usize]);
        }
    }

    fn digits(mut self) -> Vec<u8> {
        let mut digits = Vec::new();
        while !self.0.is_empty() {
            let mut nine = self.divide(BILLION);
            for _ in 0..9 {
                digits.push((nine % 10) as u8);
                nine /= 10;
            }
        }
        while digits.last() == Some(&0) {
            digits.pop();
        }
        digits.reverse();
        digits
    }

    /// The nearest number to this and, where it is inexact, a little more, over `2^places`.
    fn nearest(self, places: u32, is_inexact: bool) -> f64 {
        let [lower @ .., c, b, a] = self.0.as_slice() else { return 0.0 };
        let zeros = a.leading_zeros();
        let three = u128::from(*a) << 64 | u128::from(*b) << 32 | u128::from(*c);
        let top = three << zeros;
        // The highest 64 of 96 bits, and whether anything follows them.
        let (top, rest) = ((top >> 32) as u64, top as u32);
        let is_inexact = is_inexact || rest != 0 || lower.iter().any(|limb| *limb != 0);
        // The value is `top * 2^exponent`, and as a number of 53 bits begins at `2^leading`.
        let exponent = 32 * (lower.len() as i32 + 1) - zeros as i32 - places as i32;
        let leading = exponent + 63;
        if leading > 1023 {
            return f64::INFINITY;
        }
        let n_dropped = 11 + (-1022 - leading).max(0);
        let (kept, dropped) = match n_dropped {
            ..64 => (top >> n_dropped, top << (64 - n_dropped)),
            64 => (0, top),
            _ => return 0.0,
        };
        let is_up = match dropped.cmp(&(1 << 63)) {
            Ordering::Equal => is_inexact || kept % 2 == 1,
            order => order.is_gt(),
        };
        // A carry out of the fraction goes into the exponent, as it should.
        let biased = (leading + 1022).max(0) as u64;
        f64::from_bits((biased << 52) + kept + u64::from(is_up))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// As the standard library writes numbers with an exponent.
    fn scientific(decimal: &Decimal) -> String {
        let digits: String = decimal.digits.iter().map(|digit| char::from(b'0' + digit)).collect();
        let Some((first, rest)) = digits.split_at_checked(1) else { return "0e0".into() };
        let point = if rest.is_empty() { "" } else { "." };
        format!("{first}{point}{rest}e{}", decimal.power + digits.len() as i32 - 1)
    }

    fn check(x: f64) {
        let x = x.abs();
        if x == f64::INFINITY {
            return;
        }
        assert_eq!(scientific(&Decimal::shortest(x)), format!("{x:e}"));
        let text = format!("{x:.11e}");
        assert_eq!(Decimal::rounded(x, 12, None).nearest().to_bits(), text.parse::<f64>().unwrap().to_bits(), "{text}");
        let text = format!("{x:.12}");
        assert_eq!(
            Decimal::rounded(x, 0, Some(12)).nearest().to_bits(),
            text.parse::<f64>().unwrap().to_bits(),
            "{text}"
        );
        for text in [format!("{x:e}"), format!("-{x}"), format!("{x:.11e}"), format!("{x:.30e}"), format!("{x:.900e}")]
        {
            assert_eq!(parse(&text).unwrap().to_bits(), text.parse::<f64>().unwrap().to_bits(), "{text}");
        }
    }

    #[test]
    fn powers_and_their_neighbours_are_as_the_standard_library_has_them() {
        for exponent in -1074..1024 {
            let x = libm::scalbn(1.0, exponent);
            for x in [x.next_down(), x, x.next_up()] {
                check(x);
            }
        }
        for exponent in -330..309 {
            let x: f64 = format!("1e{exponent}").parse().unwrap();
            for x in [x.next_down().abs(), x, x.next_up(), 0.5 * x, 2.5 * x] {
                check(x);
            }
        }
        for x in [0.0, f64::MAX, f64::MIN_POSITIVE, 5e-324, 0.3, 1.0 / 3.0, 123456789012.5, 123456789013.5, 0.5e-12] {
            check(x);
        }
    }

    #[test]
    fn middles_between_two_numbers_go_to_the_even_one() {
        for text in [
            "9007199254740993",
            "9007199254740993.0000000000000000000000000000000000001",
            "9007199254740995",
            "1.7976931348623158e308",
            "1.7976931348623159e308",
            "2.4703282292062327e-324",
            "2.4703282292062328e-324",
            "2.2250738585072011e-308",
        ] {
            assert_eq!(parse(text).unwrap().to_bits(), text.parse::<f64>().unwrap().to_bits(), "{text}");
        }
    }

    #[test]
    fn what_is_a_number_is_as_the_standard_library_says() {
        for text in [
            "",
            ".",
            "-",
            "+1",
            "1.",
            ".5",
            "-.5e3",
            "1e",
            "1e+",
            "e5",
            ".e5",
            "1e5.",
            "1 ",
            "1_0",
            "0x10",
            "--1",
            "inf",
            "-INFINITY",
            "NaN",
            "in",
            "1e99999999999",
            "1e-99999999999",
            "0e99999999999",
            "00012",
            "1.2.3",
            "∞",
        ] {
            let expected = text.parse::<f64>().ok();
            let found = parse(text);
            assert_eq!(found.map(|x| x.to_bits() << 1), expected.map(|x| x.to_bits() << 1), "{text:?}");
        }
    }

    proptest! {
        #[test]
        fn any_number_is_as_the_standard_library_has_it(bits in any::<u64>(), short in -1_000_000_i32..1_000_000, power in -30..30_i32) {
            let x = f64::from_bits(bits);
            prop_assume!(x.is_finite());
            check(x);
            check(format!("{short}e{power}").parse().unwrap());
        }

        #[test]
        fn any_digits_read_as_the_standard_library_reads_them(text in "[0-9]{1,25}\\.[0-9]{0,30}e-?[0-3]?[0-9]{1,2}") {
            prop_assert_eq!(parse(&text).unwrap().to_bits(), text.parse::<f64>().unwrap().to_bits());
        }
    }
}
