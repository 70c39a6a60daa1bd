//! Numbers as text of six significant digits.

/// How many bytes they take, each with one that stands between it and the next.
pub(super) fn bytes(numbers: impl IntoIterator<Item = f64>) -> usize {
    numbers.into_iter().map(|number| text(number).len() + 1).sum()
}

/// Six digits, also where the last are zeros: how round a number is says nothing of what it stands for.
fn text(number: f64) -> String {
    let scientific = format!("{number:.5e}");
    match scientific.split_once('e').and_then(|(_, power)| power.parse::<i32>().ok()) {
        Some(power @ -4..=5) => format!("{number:.*}", (5 - power) as usize),
        _ => scientific,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn six_digits_are_kept_and_no_more() {
        assert_eq!(
            [1.0 / 3.0, -2.5, 0.0, 123456.4, 1234567.0, 9.9999999, 0.0012, 1e-9].map(text),
            ["0.333333", "-2.50000", "0.00000", "123456", "1.23457e6", "10.0000", "0.00120000", "1.00000e-9"]
                .map(String::from)
        );
        assert_eq!(bytes([1.0, -2.5]), 8 + 9);
    }
}
