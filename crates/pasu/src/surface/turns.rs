//! Cosine and sine at equal parts of a turn.

use super::circle;

/// `(cos, sin)` of every `j / n_parts` of a turn: all that a closed surface needs, whatever its harmonics.
///
/// The second half mirrors the first, digit for digit.
#[derive(Debug, Clone, Default)]
pub(crate) struct Turns {
    parts: Vec<(f64, f64)>,
}

impl Turns {
    /// Divides the turn anew.
    pub(crate) fn divide(&mut self, n_parts: usize) {
        if self.parts.len() == n_parts {
            return;
        }
        self.parts.clear();
        self.parts.extend((0..=n_parts / 2).map(|j| circle::of_turns(j as f64 / n_parts as f64)));
        for j in self.parts.len()..n_parts {
            let (cos, sin) = self.parts[n_parts - j];
            self.parts.push((cos, -sin));
        }
    }

    /// `(cos, sin)` of `n j / n_parts` of a turn for `j = 0, 1, ..`, without end.
    pub(crate) fn walk(&self, n: f64) -> Walk<'_> {
        let n_parts = self.parts.len() as f64;
        let step = libm::fmod(n, n_parts);
        let step = if step < 0.0 { step + n_parts } else { step };
        Walk { parts: &self.parts, n, step: (n == n.trunc()).then_some(step), part: 0.0, j: 0.0 }
    }
}

/// As [`Turns::walk`].
#[derive(Debug)]
pub(crate) struct Walk<'a> {
    parts: &'a [(f64, f64)],
    n: f64,
    /// How many parts it goes on by where that is a whole number, and where it is.
    step: Option<f64>,
    part: f64,
    j: f64,
}

impl Iterator for Walk<'_> {
    type Item = (f64, f64);

    // A function of its own: tables are made in many places, and that takes next to no time.
    #[inline(never)]
    fn next(&mut self) -> Option<(f64, f64)> {
        let n_parts = self.parts.len() as f64;
        let Some(step) = self.step else {
            let here = circle::of_turns(libm::fmod(self.n * self.j, n_parts) / n_parts);
            self.j += 1.0;
            return Some(here);
        };
        let here = self.parts.get(self.part as usize).copied().unwrap_or((1.0, 0.0));
        self.part += step;
        if self.part >= n_parts {
            self.part -= n_parts;
        }
        Some(here)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn walking_goes_round() {
        for n_parts in [1, 2, 7, 60, 512] {
            let mut turns = Turns::default();
            turns.divide(n_parts);
            for n in [0.0, 1.0, -1.0, 3.0, 511.0, 1e6 + 1.0, 0.5, -2.25] {
                for (j, (cos, sin)) in (0..2 * n_parts).zip(turns.walk(n)) {
                    let angle = core::f64::consts::TAU * libm::fmod(n * j as f64, n_parts as f64) / n_parts as f64;
                    assert!(
                        (cos - angle.cos()).abs() < 1e-14 && (sin - angle.sin()).abs() < 1e-14,
                        "{n} {j} of {n_parts}"
                    );
                }
            }
        }
    }

    #[test]
    fn the_second_half_mirrors_the_first() {
        let mut turns = Turns::default();
        turns.divide(97);
        let all: Vec<(f64, f64)> = turns.walk(1.0).take(97).collect();
        for j in 1..97 {
            assert_eq!((all[97 - j].0, -all[97 - j].1), all[j]);
        }
    }
}
