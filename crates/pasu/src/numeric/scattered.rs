//! Places in a table for numbers that are asked for again and again.

use std::hash::{BuildHasherDefault, Hasher};

/// Bits of which all go by all of those given (G. L. Steele, D. Lea, C. H. Flood, *Fast splittable pseudorandom number generators*, 2014): those of even places differ in a few high ones only.
pub(crate) fn scattered(bits: u64) -> u64 {
    let mut mixed = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    mixed ^ (mixed >> 31)
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
