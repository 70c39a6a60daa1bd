//! The closed form of a blend.

use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::fading::fading;
use super::function::Function;
use super::ripple::{Asked, Ripple};
use super::section::{Product, products};
use super::sines;
use crate::design::{Blend, Method, Section};
use crate::error::{Code, Error, Result};
use crate::mode::{Equation, ModeData, Order, Unsolvable};
use crate::numeric::cubic;
use crate::patch::SurfaceJet;

/// `x(u, v, w)` over the unit cube, with `w` from one section to the other (ZY04): `a x_uuuu + b x_vvvv + c x_wwww = 0` with positions and tangents given at `w = 0` and `w = 1`.
///
/// Heights and their tangents are the same all over a section, so that `z` is a cubic in `w` whatever the method: what follows is said of `x` and `y`.
#[derive(Debug)]
pub(crate) struct Volume {
    pub(super) terms: Vec<Term>,
    /// Different functions of `u`, of `v` and of `w`.
    pub(super) functions: [Vec<Function>; 3],
    pub(super) z: Function,
    ripple: Option<Ripple>,
    weights: [f64; 3],
}

/// `by f(u) g(v) h(w)` in `x` and `y`, by the numbers of the functions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Term {
    pub(super) by: DVec2,
    pub(super) of: [usize; 3],
    /// The number of the section that it is of.
    pub(super) end: usize,
}

/// What a volume has at one `w`.
pub(crate) struct Layer<'a> {
    volume: &'a Volume,
    functions: Vec<[f64; 5]>,
    z: [f64; 5],
    ripple: Vec<[DVec2; 5]>,
}

/// What it has at one `u` or one `v`.
pub(crate) struct Place {
    functions: Vec<[f64; 5]>,
    sines: [Vec<f64>; 5],
}

impl Volume {
    /// Solves a blend. `path` is where the shape stands in its design, for the error.
    ///
    /// # Errors
    /// `out-of-range` for the method `exact` of sections that have no closed form, `overflow` where the solution leaves the range of doubles.
    pub(crate) fn solve(blend: &Blend, path: &str) -> Result<Volume> {
        let Blend { start, end, weights, .. } = blend;
        let both = [start, end];
        let sections = both.map(|section| products(&section.form));
        let tapers = both.map(|section| section.taper);
        let z = Function::Cubic(cubic::through(both.map(|section| section.z), both.map(|section| section.dz)));
        let mut volume =
            Volume { terms: Vec::new(), functions: Default::default(), z, ripple: None, weights: *weights };
        let asked = Asked { sections: [&sections[0], &sections[1]], tapers, weights: *weights };
        let [l, m, n] = blend.terms.map(|term| term as usize);
        let solved = match blend.method() {
            Method::Exact => {
                return volume.with_modes(both, &sections).map_err(|why| match why {
                    Inexact::NoClosedForm(index) => both[index].form.no_closed_form().at(format!("{path}.method")),
                    Inexact::Unsolvable(why) => unsolvable(why, path),
                });
            }
            Method::Modal => asked.modal([l, m]),
            Method::Collocation => asked.collocation([l, m, n]),
        };
        volume.ripple = solved.map_err(|why| unsolvable(why, path))?;
        for (index, products) in sections.iter().enumerate() {
            let along = volume.number(2, Function::Cubic(fading(index == 1, tapers[index])));
            products.iter().for_each(|product| volume.add(product, along, index));
        }
        volume.finite(path)
    }

    /// Each product of a section solved as the mode problem that it is: the fourth derivative along `u` vanishes, and that round `v` is `k^4` times it.
    fn with_modes(
        mut self,
        both: [&Section; 2],
        sections: &[Vec<Product>; 2],
    ) -> core::result::Result<Volume, Inexact> {
        let [_, b, c] = self.weights;
        // Which frequency has which equation, and which function of w for either section.
        let mut known: Vec<(u64, Arc<Equation>, [Option<usize>; 2])> = Vec::new();
        for (index, products) in sections.iter().enumerate() {
            let taper = both[index].taper;
            let straight = self.number(2, Function::Cubic(fading(index == 1, taper)));
            for product in products {
                let half_turns = match (&product.u, &product.v) {
                    (Function::Cubic(_), Function::Cubic(_)) => {
                        self.add(product, straight, index);
                        continue;
                    }
                    (Function::Cubic(_), Function::Cosine(m) | Function::Sine(m)) => *m,
                    _ => return Err(Inexact::NoClosedForm(index)),
                };
                let place = match known.binary_search_by(|(bits, ..)| bits.cmp(&half_turns.to_bits())) {
                    Ok(place) => place,
                    Err(place) => {
                        let equation = Equation::new(Order::Fourth, c, 0.0, b, core::f64::consts::PI * half_turns);
                        let equation = Arc::new(equation.map_err(Inexact::Unsolvable)?);
                        known.insert(place, (half_turns.to_bits(), equation, [None; 2]));
                        place
                    }
                };
                let (_, equation, numbers) = &mut known[place];
                let number = match numbers[index] {
                    Some(number) => number,
                    None => {
                        let mut data = ModeData { start: 0.0, start_u: 0.0, end: 0.0, end_u: 0.0, force: &[] };
                        match index {
                            0 => (data.start, data.start_u) = (1.0, taper),
                            _ => (data.end, data.end_u) = (1.0, taper),
                        }
                        let solution = equation.solve(&data).map_err(Inexact::Unsolvable)?;
                        let functions = &mut self.functions[2];
                        functions.push(Function::Mode(Arc::clone(equation), solution));
                        numbers[index] = Some(functions.len() - 1);
                        functions.len() - 1
                    }
                };
                self.add(product, number, index);
            }
        }
        Ok(self)
    }

    fn add(&mut self, product: &Product, along: usize, end: usize) {
        let of = [self.number(0, product.u.clone()), self.number(1, product.v.clone()), along];
        self.terms.push(Term { by: product.by, of, end });
    }

    /// The number of a function of one parameter.
    fn number(&mut self, parameter: usize, function: Function) -> usize {
        let functions = &mut self.functions[parameter];
        functions.iter().position(|known| *known == function).unwrap_or_else(|| {
            functions.push(function);
            functions.len() - 1
        })
    }

    /// Refuses a volume whose corners leave the range of numbers.
    fn finite(self, path: &str) -> Result<Volume> {
        let places = [0.0, 1.0, 0.5].map(|w| self.layer(w));
        let [along, across] = [0, 1].map(|parameter| self.place(parameter, 0.5));
        match places.iter().all(|layer| layer.partial(&along, &across, [0, 0, 0]).is_finite()) {
            true => Ok(self),
            false => Err(unsolvable(Unsolvable::Overflow, path)),
        }
    }

    /// What all points of one `w` have in common. At a section it is that section to the bit, and nothing of the other: an edge that has collapsed there has no length at all.
    pub(crate) fn layer(&self, w: f64) -> Layer<'_> {
        let mut functions: Vec<[f64; 5]> = self.functions[2].iter().map(|function| function.jet(w)).collect();
        let section = if w == 0.0 { Some(0) } else { (w == 1.0).then_some(1) };
        if let Some(section) = section {
            for Term { of: [_, _, along], end, .. } in &self.terms {
                functions[*along][0] = if *end == section { 1.0 } else { 0.0 };
            }
        }
        Layer {
            volume: self,
            functions,
            z: self.z.jet(w),
            ripple: self.ripple.as_ref().map_or_else(Vec::new, |ripple| ripple.at(w)),
        }
    }

    /// What all points of one `u` (`parameter` 0) or one `v` (1) have in common.
    pub(crate) fn place(&self, parameter: usize, x: f64) -> Place {
        let sines = self.ripple.as_ref().map(|ripple| sines::derivatives(ripple.n[parameter], x));
        Place {
            functions: self.functions[parameter].iter().map(|function| function.jet(x)).collect(),
            sines: sines.unwrap_or_default(),
        }
    }

    /// Position at one point.
    pub(crate) fn position(&self, [u, v, w]: [f64; 3]) -> DVec3 {
        self.layer(w).partial(&self.place(0, u), &self.place(1, v), [0, 0, 0])
    }

    /// The jets in `u` and `v` at triples `(u, v, w)`, those of one `w` together.
    pub(crate) fn visit(&self, at: &[f64], mut visit: impl FnMut(&SurfaceJet)) {
        let mut layer: Option<(f64, Layer)> = None;
        for point in at.as_chunks::<3>().0 {
            let [u, v, w] = *point;
            let (_, here) = match layer.take().filter(|(known, _)| *known == w) {
                Some(known) => layer.insert(known),
                None => layer.insert((w, self.layer(w))),
            };
            let (along, across) = (self.place(0, u), self.place(1, v));
            let partial = |orders: [usize; 3]| here.partial(&along, &across, orders);
            visit(&SurfaceJet {
                position: partial([0, 0, 0]),
                du: partial([1, 0, 0]),
                dv: partial([0, 1, 0]),
                ..SurfaceJet::default()
            });
        }
    }
}

impl Layer<'_> {
    /// The derivative of these orders, each at most 4, along `u`, `v` and `w`.
    pub(crate) fn partial(&self, along: &Place, across: &Place, [i, j, k]: [usize; 3]) -> DVec3 {
        let mut sum = DVec2::ZERO;
        for Term { by, of: [f, g, h], .. } in &self.volume.terms {
            sum += *by * (along.functions[*f][i] * across.functions[*g][j] * self.functions[*h][k]);
        }
        let sum = self.with_sines(sum, along, across, [i, j, k]);
        sum.extend(if i + j == 0 { self.z[k] } else { 0.0 })
    }

    /// The same sum with what the sines add to it.
    pub(super) fn with_sines(&self, mut sum: DVec2, along: &Place, across: &Place, [i, j, k]: [usize; 3]) -> DVec2 {
        let n = across.sines[j].len();
        if n > 0 {
            for (row, sine) in self.ripple.chunks_exact(n).zip(&along.sines[i]) {
                let line: DVec2 = row.iter().zip(&across.sines[j]).map(|(q, sine)| q[k] * *sine).sum();
                sum += line * *sine;
            }
        }
        sum
    }

    /// The determinant of the first derivatives: how much room a bit of the cube takes, negative where it is turned inside out.
    pub(crate) fn jacobian(&self, along: &Place, across: &Place) -> f64 {
        let at = |orders: [usize; 3]| self.partial(along, across, orders);
        at([1, 0, 0]).cross(at([0, 1, 0])).dot(at([0, 0, 1]))
    }

    /// What the equation leaves: `a x_uuuu + b x_vvvv + c x_wwww`.
    pub(crate) fn residual(&self, along: &Place, across: &Place) -> DVec3 {
        let [a, b, c] = self.volume.weights;
        let at = |orders: [usize; 3]| self.partial(along, across, orders);
        a * at([4, 0, 0]) + b * at([0, 4, 0]) + c * at([0, 0, 4])
    }
}

/// Why a blend has no closed form harmonic by harmonic.
enum Inexact {
    /// Of the section of this number.
    NoClosedForm(usize),
    Unsolvable(Unsolvable),
}

fn unsolvable(why: Unsolvable, path: &str) -> Error {
    match why {
        Unsolvable::Overflow => {
            let message = "this blend is too large to compute: its solution leaves the range of numbers";
            Error::new(Code::Overflow, path, message)
        }
        _ => {
            let message =
                "the equations of these terms do not decide the solid; change the number of terms or the weights";
            Error::new(Code::ResonantProblem, path, message)
        }
    }
}

#[cfg(test)]
mod tests;
