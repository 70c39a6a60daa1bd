//! Several integrals over the same domain, with what is known of their errors.

/// Several integrals over the same domain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Integral<const N: usize> {
    /// The integrals.
    pub(crate) value: [f64; N],
    /// How far each may be off.
    pub(crate) error: [f64; N],
    /// The integrals of the absolute values: what errors are held against.
    pub(crate) size: [f64; N],
}

impl<const N: usize> Default for Integral<N> {
    fn default() -> Self {
        Integral { value: [0.0; N], error: [0.0; N], size: [0.0; N] }
    }
}

/// Rounding of a sum, as a part of the integral of the absolute value.
pub(crate) const ROUNDING: f64 = 4e-15;

impl<const N: usize> Integral<N> {
    /// A value of integrands that is exact but for rounding.
    pub(crate) fn of(value: [f64; N]) -> Self {
        Integral { value, error: [0.0; N], size: value.map(f64::abs) }
    }

    pub(crate) fn add(&mut self, other: &Integral<N>) {
        for i in 0..N {
            self.value[i] += other.value[i];
            self.error[i] += other.error[i];
            self.size[i] += other.size[i];
        }
    }

    /// With the rounding of a sum.
    pub(crate) fn rounded(mut self) -> Self {
        for (error, size) in self.error.iter_mut().zip(self.size) {
            *error += ROUNDING * size;
        }
        self
    }

    pub(crate) fn scaled(&self, factor: f64) -> Self {
        let all = |numbers: [f64; N]| numbers.map(|x| factor * x);
        Integral { value: all(self.value), error: all(self.error), size: all(self.size) }
    }
}
