//! The roots of the characteristic polynomial, by their squares.

use libm::hypot;

use super::order::Order;

/// The size of the fastest rate, `max |r|` over the roots of `r^2 - b` (order 2) or `r^4 - b r^2 + c` (order 4).
pub(super) fn largest_rate(order: Order, b: f64, c: f64) -> f64 {
    rate_of(roots(order, b, c), c)
}

/// The squares of the roots where they are real, the larger in size first; of order 2 the one and 0.
pub(super) fn roots(order: Order, b: f64, c: f64) -> Option<(f64, f64)> {
    match order {
        Order::Second => Some((b, 0.0)),
        Order::Fourth => squared_roots(b, c),
    }
}

/// As [`largest_rate`], of what [`roots`] found.
pub(super) fn rate_of(roots: Option<(f64, f64)>, c: f64) -> f64 {
    match roots {
        Some((z, _)) => z.abs().sqrt(),
        None => c.sqrt().sqrt(),
    }
}

/// The rate of the fastest solution that swings without falling off; 0 where none does.
pub(super) fn swing(order: Order, b: f64, c: f64) -> f64 {
    let least = match order {
        Order::Second => b,
        Order::Fourth => squared_roots(b, c).map_or(0.0, |(one, other)| one.min(other)),
    };
    (-least).max(0.0).sqrt()
}

/// The real roots of `z^2 - b z + c`, the larger in size first, or `None` when they are complex.
///
/// Neither the discriminant nor the smaller root is got by subtraction of near-equal numbers other than `b` and `2 sqrt(c)`.
pub(super) fn squared_roots(b: f64, c: f64) -> Option<(f64, f64)> {
    let discriminant_root = if c > 0.0 {
        let twice = 2.0 * c.sqrt();
        if b.abs() < twice {
            return None;
        }
        (b.abs() - twice).sqrt() * (b.abs() + twice).sqrt()
    } else {
        hypot(b, 2.0 * (-c).sqrt())
    };
    let large = 0.5 * (b.abs() + discriminant_root);
    if large == 0.0 {
        return Some((0.0, 0.0));
    }
    let large = if b < 0.0 { -large } else { large };
    Some((large, c / large))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_of_every_sign() {
        assert_eq!(squared_roots(5.0, 4.0), Some((4.0, 1.0)));
        assert_eq!(squared_roots(-5.0, 4.0), Some((-4.0, -1.0)));
        assert_eq!(squared_roots(0.0, -4.0), Some((2.0, -2.0)));
        assert_eq!(squared_roots(3.0, 0.0), Some((3.0, 0.0)));
        assert_eq!(squared_roots(0.0, 0.0), Some((0.0, 0.0)));
        assert_eq!(squared_roots(0.0, 4.0), None);
        assert_eq!(squared_roots(2.0, 1.0), Some((1.0, 1.0)));
    }
}
