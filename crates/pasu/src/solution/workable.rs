//! What is too fine to be measured or made, though it can be drawn.

use std::sync::Arc;

use super::placed::Placed;
use super::whole::Solution;
use crate::design::{Part, RATE, SWING, Shape, WAVES, plain};
use crate::error::{Code, Error, Result};
use crate::surface::Surface;

impl Solution {
    /// One part, solved, placed, and no finer than what is measured and made: searches and sums look at every wave of it several times.
    ///
    /// # Errors
    /// As [`Solution::part`]; `too-large` where a number of waves, or the rate at which a mode changes along the profile, is beyond its limit.
    pub(crate) fn workable(&self, index: usize) -> Result<&Arc<Placed>> {
        let placed = self.part(index)?;
        if let (Some(surface), (_, part)) = (placed.solved().fourier(), self.existing(index)?) {
            few_waves(part, surface, index)?;
            slow_enough(part, surface, index)?;
        }
        #[cfg(feature = "patchwork")]
        if placed.solved().volume().is_some() {
            refuse_waves(self.existing(index)?.1, index, |_| true)?;
            calm_enough(placed, index)?;
        }
        Ok(placed)
    }

    /// Refuses a design of which a part is not [workable](Solution::workable).
    ///
    /// # Errors
    /// As [`Solution::workable`].
    pub(crate) fn all_workable(&self) -> Result<()> {
        (0..self.n_parts()).try_for_each(|index| self.workable(index).map(drop))
    }
}

fn few_waves(part: &Part, surface: &Surface, index: usize) -> Result<()> {
    // What a document gives and the surface does not have, petals of no depth, does no harm.
    // Waves of a radius are those of x and y with one more and one less.
    refuse_waves(part, index, |n| [n - 1.0, n, n + 1.0].iter().any(|n| surface.distinct().contains(n)))
}

/// Refuses a number of waves that is used and beyond the limit.
fn refuse_waves(part: &Part, index: usize, is_used: impl Fn(f64) -> bool) -> Result<()> {
    match part.shape.waves().into_iter().find(|(_, n)| n.abs() > WAVES && is_used(*n)) {
        None => Ok(()),
        Some((place, n)) => {
            let message = format!(
                "expected at most {} waves round a pot that is measured or made, found {}; it can only be drawn",
                plain(WAVES),
                plain(n)
            );
            let error = Error::new(Code::TooLarge, format!("parts[{index}].shape.{place}"), message);
            Err(error.with("greatest", WAVES).with("found", n))
        }
    }
}

fn slow_enough(part: &Part, surface: &Surface, index: usize) -> Result<()> {
    let Some(problem) = part.shape.problem() else { return Ok(()) };
    for ((name, component), terms) in ["x", "y", "z"].into_iter().zip(problem.components()).zip(surface.components()) {
        for term in terms {
            let (rate, swing) = (term.beam.largest_rate(), term.beam.swing());
            let (found, greatest, what) = if !(swing <= SWING) {
                (swing, SWING, "swings")
            } else if !(rate <= RATE) {
                (rate, RATE, "changes")
            } else {
                continue;
            };
            let told = [("n", term.n), ("s", component.s), ("t", component.t), ("w", component.w)];
            let [n, s, t, w] = told.map(|(_, number)| plain(number));
            let message = format!(
                "component {name}, mode n = {n} {what} too fast along the profile to be measured or made: with s = {s}, t = {t}, w = {w} its rate is {}, \
                 expected at most {}; it can only be drawn",
                plain(libm::round(found)),
                plain(greatest)
            );
            let path = match &part.shape {
                Shape::BoundaryValue(_) => format!("parts[{index}].shape.{name}"),
                _ => format!("parts[{index}].shape"),
            };
            let error = Error::new(Code::TooLarge, path, message).with("component", name);
            let error = told.into_iter().fold(error, |error, (name, number)| error.with(name, number));
            return Err(error.with("greatest", greatest).with("found", found));
        }
    }
    Ok(())
}

/// Refuses a blend whose weights let a wave fall off from a section faster than searches and sums follow.
#[cfg(feature = "patchwork")]
fn calm_enough(placed: &Placed, index: usize) -> Result<()> {
    let solved = placed.solved();
    let rates = (0..solved.n_patches()).flat_map(|patch| solved.patch(patch).breaks().map(|breaks| breaks.rate));
    let found = rates.fold(0.0, f64::max);
    if found <= RATE {
        return Ok(());
    }
    let message = format!(
        "with these weights a wave falls off from its section at a rate of {}, expected at most {}: it can only be drawn",
        plain(libm::round(found)),
        plain(RATE)
    );
    let error = Error::new(Code::TooLarge, format!("parts[{index}].shape.weights"), message).with("what", "weights");
    Err(error.with("greatest", RATE).with("found", found))
}
