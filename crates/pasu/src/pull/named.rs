//! A named family is pulled: the least change of its numbers.

use glam::DVec3;

use super::least_change::{Mover, least_change};
use crate::design::{Dimension, Parameter, Shape, unknown_name};
use crate::error::{Code, Error, Result};
use crate::surface::Surface;

/// Fields with one number for `x` and one for `y`: where these are equal they stay so, and a round pot stays round.
const PAIRS: [&str; 3] = ["s", "t", "w"];

/// Slopes are taken from points this many units apart.
const APART: f64 = 1e-3;

/// A vase of a named family whose point `at` is pulled.
struct Vase<'a> {
    shape: &'a Shape,
    at: [f64; 2],
    numbers: Vec<Parameter>,
    /// What changes, in its own unit.
    free: Vec<Free>,
}

/// Numbers that change together.
struct Free {
    places: Vec<usize>,
    unit: f64,
}

/// The same family with the least change of its numbers that brings the point `at` to `to`, or as near as it can be brought. Waves stay: they are whole numbers.
///
/// Changes are compared in units: lengths in the size of the vase, everything else in its own value (in 1 where that is 0).
pub(super) fn pull(shape: &Shape, at: [f64; 2], to: DVec3, keep: &[String]) -> Result<Shape> {
    let numbers = shape.parameters();
    let kept = kept(&numbers, keep)?;
    let lengths = numbers.iter().filter(|number| number.field.dimension == Dimension::Length);
    let size = lengths.fold(0.0f64, |size, number| size.max(number.value.abs()));
    let free = free(&numbers, &kept, if size > 0.0 { size } else { 1.0 });
    let vase = Vase { shape, at, numbers, free };
    let changes = least_change(&vase, vase.free.len(), to)
        .ok_or_else(|| Error::new(Code::Overflow, "", "the vase cannot be computed beside the numbers that it has"))?;
    Ok(vase.changed(&changes))
}

/// Which numbers are to stay.
fn kept(numbers: &[Parameter], keep: &[String]) -> Result<Vec<bool>> {
    let names = |number: &Parameter, word: &str| number.field.name == word || number.path() == word;
    if let Some((index, word)) =
        keep.iter().enumerate().find(|(_, word)| !numbers.iter().any(|number| names(number, word)))
    {
        let known: Vec<String> = numbers.iter().map(Parameter::path).collect();
        let known: Vec<&str> = known.iter().map(String::as_str).collect();
        return Err(unknown_name(word, &known).at(format!("keep[{index}]")));
    }
    let is_wave = |number: &Parameter| number.field.dimension == Dimension::Waves;
    Ok(numbers.iter().map(|number| is_wave(number) || keep.iter().any(|word| names(number, word))).collect())
}

/// The numbers that may change, those of a pair together.
fn free(numbers: &[Parameter], kept: &[bool], size: f64) -> Vec<Free> {
    let mut free: Vec<Free> = Vec::with_capacity(numbers.len());
    for (place, number) in numbers.iter().enumerate().filter(|(place, _)| !kept[*place]) {
        let of_pair = free.last_mut().filter(|before| {
            let other = &numbers[before.places[0]];
            PAIRS.contains(&number.field.name) && other.field.name == number.field.name && other.value == number.value
        });
        match of_pair {
            Some(before) => before.places.push(place),
            None => {
                let own = if number.value == 0.0 { 1.0 } else { number.value.abs() };
                let unit = if number.field.dimension == Dimension::Length { size } else { own };
                free.push(Free { places: vec![place], unit });
            }
        }
    }
    free
}

impl Vase<'_> {
    fn changed(&self, changes: &[f64]) -> Shape {
        let mut values: Vec<f64> = self.numbers.iter().map(|number| number.value).collect();
        for (Free { places, unit }, change) in self.free.iter().zip(changes) {
            for place in places {
                values[*place] += change * unit;
            }
        }
        self.shape.clone().with_parameters(&values)
    }
}

impl Mover for Vase<'_> {
    fn point(&self, changes: &[f64]) -> Option<DVec3> {
        let shape = self.changed(changes);
        let is_allowed = shape
            .parameters()
            .iter()
            .all(|number| number.value.is_finite() && number.field.range.contains(number.value));
        let problem = is_allowed.then(|| shape.problem()).flatten()?;
        let surface = problem.is_finite().then(|| Surface::solve(&problem, "").ok())??;
        let point = surface.at(self.at[0], self.at[1]).position;
        point.is_finite().then_some(point)
    }

    /// By central differences of the closed form. The point is a polynomial of at most the second degree in the numbers that are data, where these are exact but for rounding; in those of the
    /// equation they are off by less than `1e-6` of the slope. That does not keep the point from arriving. It turns the change by as much, and the least change is stationary: what is found is longer than it by a part of
    /// `1e-12 / 2`, far below what anybody asks of a number that is rounded to twelve digits. Derivatives of the equation's own numbers would have to be written for each of its regimes.
    fn slopes(&self, changes: &[f64]) -> Option<Vec<DVec3>> {
        let mut beside = changes.to_vec();
        let slope = |place: usize| {
            let mut moved = |by: f64| {
                beside[place] = changes[place] + by;
                let point = self.point(&beside);
                beside[place] = changes[place];
                point
            };
            Some((moved(APART)? - moved(-APART)?) / (2.0 * APART))
        };
        (0..changes.len()).map(slope).collect()
    }
}
