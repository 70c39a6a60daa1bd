//! Numbers as text: the fewest decimal places that read back as the number.

use crate::design::plain;
use crate::solid::significant;

/// A number for people, with at most eight digits that count: 100 for what rounding has left at 99.999999999.
pub(super) fn short(x: f64) -> String {
    plain(significant(x, 8))
}

/// The most decimal places of [`rounded`].
const MOST_PLACES: usize = 4;

/// A number rounded to at most four decimal places, without zeros at its end.
pub(super) fn rounded(x: f64, places: usize) -> String {
    let places = places.min(MOST_PLACES);
    let whole = libm::round(x.abs() * POWERS[places]) as u64;
    let mut bytes = if x < 0.0 && whole > 0 { vec![b'-'] } else { Vec::new() };
    push_decimal(&mut bytes, whole, places);
    bytes.into_iter().map(char::from).collect()
}

/// Powers of ten whose product with a `f32` is exact in a double: 24 bits and `5^12 < 2^28` make 52.
const POWERS: [f64; 13] = [1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12];

/// Writes `x` with the fewest decimal places that read back as `x`; negative zero as 0. `x` is finite.
///
/// With `k` places the nearest decimal is `n / 10^k`, `n = round(x 10^k)`, and it reads back when it is less than half a unit in the last place away from `x`. All of that is exact
/// in doubles up to twelve places, which every number of at least a thousandth has; smaller ones are written with all their digits.
pub(super) fn push_f32(into: &mut Vec<u8>, x: f32) {
    let size = f64::from(x.abs());
    let bits = x.to_bits();
    let exponent = u64::from((bits >> 23) & 0xff).max(1);
    // Half the distance to the nearer neighbour: below a power of two numbers lie twice as close.
    let halvings = if bits & 0x7f_ffff == 0 { 2 } else { 1 };
    let half = f64::from_bits((exponent + 1023 - 150 - halvings) << 52);
    for (places, power) in POWERS.iter().enumerate() {
        let scaled = size * power;
        if scaled > 4e15 {
            break;
        }
        let whole = (scaled + 0.5) as u64;
        if (whole as f64 - scaled).abs() < half * power {
            if x < 0.0 && whole > 0 {
                into.push(b'-');
            }
            push_decimal(into, whole, places);
            return;
        }
    }
    into.extend_from_slice(plain(f64::from(x)).as_bytes());
}

/// Writes `digits / 10^places` without zeros at its end.
pub(super) fn push_decimal(into: &mut Vec<u8>, digits: u64, places: usize) {
    let (mut digits, mut places) = (digits, places);
    while places > 0 && digits.is_multiple_of(10) {
        digits /= 10;
        places -= 1;
    }
    let mut text = [b'0'; 32];
    let mut at = text.len();
    let mut written = 0;
    while digits > 0 || written <= places {
        if written == places && places > 0 {
            at -= 1;
            text[at] = b'.';
        }
        at -= 1;
        text[at] = b'0' + (digits % 10) as u8;
        digits /= 10;
        written += 1;
    }
    into.extend_from_slice(&text[at..]);
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn written(x: f32) -> String {
        let mut into = Vec::new();
        push_f32(&mut into, x);
        String::from_utf8(into).unwrap()
    }

    #[test]
    fn everyday_numbers_are_short() {
        let cases = [
            (0.0, "0"),
            (-0.0, "0"),
            (1.0, "1"),
            (-0.5, "-0.5"),
            (0.1, "0.1"),
            (100.0, "100"),
            (12.34, "12.34"),
            (-0.001, "-0.001"),
            (16777216.0, "16777216"),
            (0.3, "0.3"),
        ];
        for (x, text) in cases {
            assert_eq!(written(x), text);
        }
    }

    #[test]
    fn numbers_for_people_have_no_dust() {
        for (x, text) in
            [(99.999_999_999_9, "100"), (10.0 / 0.88, "11.363636"), (25.4, "25.4"), (0.0, "0"), (0.1 + 0.2, "0.3")]
        {
            assert_eq!(short(x), text);
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4096))]

        #[test]
        fn every_number_reads_back(bits in any::<u32>(), everyday in -1000.0f32..1000.0) {
            for x in [f32::from_bits(bits), everyday] {
                prop_assume!(x.is_finite());
                prop_assert_eq!(written(x).parse::<f32>().unwrap(), x, "{}", written(x));
            }
            prop_assert!(written(everyday).len() <= 14);
        }
    }
}
