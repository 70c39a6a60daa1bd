//! Numbers as documents and links hold them: twelve significant digits, one way of writing each.

/// The nearest number of twelve significant decimal digits; negative zero becomes zero.
///
/// Twelve digits are a hundred times finer than any result of the solver is promised, and coarse enough that sums and
/// products that differ only in their last bits (`0.1 + 0.2`) are written alike. Idempotent.
pub(crate) fn rounded(x: f64) -> f64 {
    rounded_by_doubles(x).unwrap_or_else(|| rounded_to(x, 12))
}

/// The nearest number of so many significant decimal digits, at least one; negative zero becomes zero.
pub(crate) fn rounded_to(x: f64, digits: usize) -> f64 {
    reread(&format!("{x:.*e}", digits - 1))
}

/// The same for numbers of everyday size, a hundred times as fast: a document is read anew at every step of a drag.
///
/// `x 10^k` is off by no more than an ulp, 1e-4 here, so that its nearest whole number is known unless it lies near the middle between two. That number and the power of ten
/// are both exact in a double, and division rounds to the nearest.
fn rounded_by_doubles(x: f64) -> Option<f64> {
    const LEAST: f64 = 1e11;
    let size = x.abs();
    if size == 0.0 {
        return Some(0.0);
    }
    if !(1e-10..1e11).contains(&size) {
        return None;
    }
    let mut power = 10.0;
    while size * power < LEAST {
        power *= 10.0;
    }
    let scaled = size * power;
    let whole = libm::round(scaled);
    // Next to a power of ten the number of digits is not known for certain, but what is as good as the power itself is rounded to it either way.
    let is_clear = scaled > LEAST * 1.001 && whole < 9.99e11 || (scaled - LEAST).abs() < 1e-3;
    let is_sure = is_clear && (scaled - whole).abs() < 0.49;
    is_sure.then(|| (whole / power).copysign(x))
}

/// Twelve decimal places: for the components of unit vectors, where noise next to 1 must become 0.
pub(crate) fn rounded_in_unit(x: f64) -> f64 {
    reread(&format!("{x:.12}"))
}

/// The number that was written, zero without a sign.
fn reread(text: &str) -> f64 {
    // What the standard library writes is JSON, but for what is not finite.
    parse(text).map_or(f64::NAN, |x| if x == 0.0 { 0.0 } else { x })
}

/// Reads a number as people and programs write it: `12`, `+3`, `-.5`, `1.`, `2.5e-3`, and what is none but called so, `inf` and `NaN`.
///
/// The digits are read by `serde_json`, whose tables the module has anyway: those of the standard library would come on top. So they are first brought into
/// the form that JSON has for them, which wants a digit on either side of a point, and no sign or zero before the first that counts.
pub(crate) fn parse(text: &str) -> Option<f64> {
    let (is_negative, unsigned) = match text.strip_prefix(['-', '+']) {
        Some(rest) => (text.starts_with('-'), rest),
        None => (false, text),
    };
    let size = if ["inf", "infinity"].iter().any(|name| unsigned.eq_ignore_ascii_case(name)) {
        f64::INFINITY
    } else if unsigned.eq_ignore_ascii_case("nan") {
        f64::NAN
    } else {
        let end = unsigned.find(['e', 'E']).unwrap_or(unsigned.len());
        let (mantissa, exponent) = unsigned.split_at(end);
        let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let are_digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
        if whole.is_empty() && part.is_empty() || !are_digits(whole) || !are_digits(part) {
            return None;
        }
        let json = format!("{:0>1}.{part:0<1}{exponent}", whole.trim_start_matches('0'));
        match serde_json::from_str(&json) {
            Ok(size) => size,
            // Of what has the form of a number only one that is too large is refused.
            Err(_) if serde_json::from_str::<f64>(&format!("0.0{exponent}")).is_ok() => f64::INFINITY,
            Err(_) => return None,
        }
    };
    Some(if is_negative { -size } else { size })
}

/// The shortest decimal digits that read back as `x`, and the power of ten of the last of them: `x = digits * 10^power`.
struct Written {
    negative: bool,
    digits: String,
    power: i32,
}

impl Written {
    /// `None` when `x` is not finite.
    fn new(x: f64) -> Option<Written> {
        if !x.is_finite() {
            return None;
        }
        // `1.25e-7`
        let text = format!("{:e}", x.abs());
        let (mantissa, exponent) = text.split_once('e')?;
        let digits = mantissa.replace('.', "");
        let power = exponent.parse::<i32>().ok()? - (digits.len() as i32 - 1);
        Some(Written { negative: x < 0.0, digits, power })
    }

    fn sign(&self) -> &'static str {
        if self.negative { "-" } else { "" }
    }

    /// Without an exponent; `zero` is what stands before a leading point.
    fn plain(&self, zero: &str) -> String {
        let (sign, digits) = (self.sign(), &self.digits);
        if self.power >= 0 {
            return format!("{sign}{digits}{}", "0".repeat(self.power as usize));
        }
        let places = self.power.unsigned_abs() as usize;
        match digits.len().checked_sub(places) {
            Some(0) | None => format!("{sign}{zero}.{}{digits}", "0".repeat(places - digits.len())),
            Some(point) => format!("{sign}{}.{}", &digits[..point], &digits[point..]),
        }
    }
}

/// The numbers that so many things have, in words.
pub(crate) fn numbers_of(n: usize) -> String {
    match n {
        0 => "of which there is none".into(),
        1 => "only 0".into(),
        _ => format!("0 to {}", n - 1),
    }
}

/// As JavaScript writes it: `100000`, `0.000001`, `1e-7`, `1e+21`, `NaN`, `-Infinity`.
///
/// The same text as `JSON.stringify` gives, so that a document saved by a page and one written by this crate are equal.
pub(crate) fn plain(x: f64) -> String {
    let Some(decimal) = Written::new(x) else {
        return if x.is_nan() { "NaN".into() } else { format!("{}Infinity", if x < 0.0 { "-" } else { "" }) };
    };
    let leading = decimal.power + decimal.digits.len() as i32 - 1;
    if (-6..21).contains(&leading) {
        return decimal.plain("0");
    }
    let (first, rest) = decimal.digits.split_at(1);
    let point = if rest.is_empty() { "" } else { "." };
    let plus = if leading > 0 { "+" } else { "" };
    format!("{}{first}{point}{rest}e{plus}{leading}", decimal.sign())
}

/// The shortest text that reads back as `x`, for links: `.2`, `-12.5`, `1e5`, `15e-8`. `x` is finite.
pub(crate) fn shortest(x: f64) -> String {
    let Some(decimal) = Written::new(x) else { return plain(x) };
    let plain = decimal.plain("");
    if decimal.power == 0 {
        return plain;
    }
    let scientific = format!("{}{}e{}", decimal.sign(), decimal.digits, decimal.power);
    if scientific.len() < plain.len() { scientific } else { plain }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn numbers_are_written_as_javascript_does() {
        let cases = [
            (0.0, "0"),
            (-0.0, "0"),
            (1.0, "1"),
            (-0.5, "-0.5"),
            (100000.0, "100000"),
            (1e20, "100000000000000000000"),
            (1e21, "1e+21"),
            (1.5e300, "1.5e+300"),
            (0.000001, "0.000001"),
            (-1.25e-7, "-1.25e-7"),
            (123.456, "123.456"),
            (f64::MAX, "1.7976931348623157e+308"),
            (5e-324, "5e-324"),
        ];
        for (x, text) in cases {
            assert_eq!(plain(x), text);
        }
    }

    #[test]
    fn links_write_the_shorter_form() {
        let cases = [
            (0.2, ".2"),
            (-0.5, "-.5"),
            (0.0, "0"),
            (8.0, "8"),
            (1200.0, "1200"),
            (100000.0, "1e5"),
            (0.001, ".001"),
            (0.00001, "1e-5"),
            (1.5e-7, "15e-8"),
            (-3.25e20, "-325e18"),
        ];
        for (x, text) in cases {
            assert_eq!(shortest(x), text);
        }
    }

    #[test]
    fn rounding_keeps_twelve_digits() {
        assert_eq!(rounded(0.1 + 0.2), 0.3);
        let mut n_fast = 0;
        let mut bits = 0x9e37_79b9_7f4a_7c15u64;
        for i in 0..20_000u32 {
            // Any doubles, and decimals of few digits with what rounding leaves.
            bits = bits.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let few = f64::from(i % 3001)
                * [1.0, 0.1, 0.01, 1e-3, 1e5][i as usize % 5]
                * if i % 2 == 0 { 1.0 } else { -1.0 / 3.0 };
            for x in [f64::from_bits(bits), few, libm::ldexp(few, bits as i32 % 40)] {
                if let Some(fast) = rounded_by_doubles(x) {
                    n_fast += 1;
                    assert_eq!(fast.to_bits(), reread(&format!("{x:.11e}")).to_bits(), "{x:?}");
                }
            }
        }
        assert!(n_fast > 20_000, "{n_fast}");
        assert_eq!(rounded(1.0 / 3.0), 0.333333333333);
        assert_eq!(rounded(-0.0).to_bits(), 0.0f64.to_bits());
        assert!(rounded(f64::MAX).is_finite());
        assert_eq!(rounded(5e-324), 5e-324);
        assert_eq!(rounded_in_unit(1e-17), 0.0);
        assert_eq!(rounded_in_unit(-1e-17).to_bits(), 0.0f64.to_bits());
    }

    #[test]
    fn numbers_are_read_as_people_write_them() {
        let texts = [
            "0",
            "12",
            "-.5",
            "+3",
            "1.",
            "007",
            "00.50",
            "2.5e-3",
            "2.5E+3",
            "1e999",
            "-1e999",
            "0e999",
            "1e-999",
            "9e99999999999999999999",
            "inf",
            "-Infinity",
            "4.9406564584124654e-324",
            "1.7976931348623159e308",
            "0.1000000000000000055511151231257827021181583404541015626",
        ];
        for text in texts {
            assert_eq!(parse(text).map(f64::to_bits), text.parse().ok().map(f64::to_bits), "{text}");
        }
        assert!(parse("NaN").is_some_and(f64::is_nan));
        for text in ["", "-", ".", "e5", "1e", "1e+", "1,2", "1 2", "0x1", "1.2.3", "--1", "+-1", "1e5.0", "-.e1", "½"]
        {
            assert_eq!((parse(text), text.parse::<f64>().ok()), (None, None), "{text}");
        }
    }

    proptest! {
        #[test]
        fn every_number_reads_back(bits in any::<u64>()) {
            let x = f64::from_bits(bits);
            prop_assume!(x.is_finite());
            prop_assert_eq!(plain(x).parse::<f64>().unwrap(), x);
            prop_assert_eq!(shortest(x).parse::<f64>().unwrap(), x);
            let once = rounded(x);
            prop_assert_eq!(rounded(once).to_bits(), once.to_bits());
            prop_assert!((once - x).abs() <= 5.1e-12 * x.abs());
            prop_assert_eq!(serde_json::from_str::<f64>(&plain(x)).unwrap(), x);
            for text in [format!("{x:e}"), format!("{x}"), format!("{x:.11e}"), format!("{x:.30e}"), format!("{x:.900e}")] {
                prop_assert_eq!(parse(&text).map(f64::to_bits), text.parse().ok().map(f64::to_bits), "{}", text);
            }
        }
    }
}
