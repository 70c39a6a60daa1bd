//! Places and lengths as messages have them.

use glam::DVec3;

use crate::design::plain;

/// A point as people read it, to four digits of its largest coordinate.
pub(crate) fn place(at: DVec3) -> String {
    let largest = at.abs().max_element();
    let [x, y, z] = at.to_array().map(|x| rounded(x, largest));
    format!("({x}, {y}, {z})")
}

/// A length as people read it, to four digits.
pub(crate) fn short(x: f64) -> String {
    rounded(x, x.abs())
}

/// A number with so many digits.
pub(crate) fn significant(x: f64, digits: u32) -> f64 {
    nearest(x, x.abs(), digits)
}

/// A number to the fourth digit of another.
fn rounded(x: f64, size: f64) -> String {
    plain(nearest(x, size, 4))
}

/// The number nearest to one that ends at a digit of another.
fn nearest(x: f64, size: f64, digits: u32) -> f64 {
    if !(size > 0.0 && size.is_finite()) {
        return x;
    }
    let digits = f64::from(digits) - 1.0 - libm::floor(libm::log10(size));
    let power = libm::pow(10.0, digits.clamp(-300.0, 300.0));
    // Dividing by a power of ten, and not multiplying by a tenth of one, gives the nearest double; adding 0 takes the sign of -0.
    libm::round(x * power) / power + 0.0
}
