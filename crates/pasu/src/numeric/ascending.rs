//! Numbers in ascending order, each once.

/// The different ones of a few numbers, the least first. Shorter than the sorts of the standard library, each of which costs the first picture 2 kB.
#[inline]
pub(crate) fn distinct(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut found = Vec::new();
    values.for_each(|value| insert(&mut found, value));
    found
}

#[inline(never)]
fn insert(found: &mut Vec<f64>, value: f64) {
    if let Err(place) = found.binary_search_by(|other| other.total_cmp(&value)) {
        found.insert(place, value);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_is_there_once() {
        assert_eq!(distinct([3.0, 1.0, 2.0, 1.0, 3.0].into_iter()), [1.0, 2.0, 3.0]);
        assert!(distinct([].into_iter()).is_empty());
    }
}
