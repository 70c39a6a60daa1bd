//! Places in a table for numbers that are asked for again and again.

use std::hash::{BuildHasherDefault, Hasher};

/// Bits of which all go by all of those given (D. E. Knuth, *The Art of Computer Programming*, section 6.4: multiplication by the golden section).
pub(crate) fn scattered(bits: u64) -> u64 {
    let product = bits.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    product ^ (product >> 32)
}

/// For maps whose keys are the bits of numbers: keys that nobody chooses to be in each other's way.
pub(crate) type Scatter = BuildHasherDefault<Scattered>;

/// The bits that were written last, [scattered].
#[derive(Debug, Default)]
pub(crate) struct Scattered(u64);

impl Hasher for Scattered {
    fn finish(&self) -> u64 {
        self.0
    }

    fn write(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.write_u64(u64::from(*byte));
        }
    }

    fn write_u64(&mut self, bits: u64) {
        self.0 = scattered(self.0 ^ bits);
    }
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::*;

    #[test]
    fn neighbours_are_scattered_by_both_ends_of_their_bits() {
        let hashes: Vec<u64> = (0..4096).map(|i| scattered((f64::from(i) / 4096.0).to_bits())).collect();
        for shift in [0, 52] {
            let places: HashSet<u64> = hashes.iter().map(|hash| (hash >> shift) & 0xfff).collect();
            // As many as of random numbers: about two thirds of all.
            assert!(places.len() > 2200, "{shift}: {}", places.len());
        }
    }
}
