//! A section as a sum of products of a function of `u` and one of `v`.

use glam::DVec2;

use super::function::Function;
use crate::design::{Form, Harmonic};

/// `by f(u) g(v)`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Product {
    pub(super) by: DVec2,
    pub(super) u: Function,
    pub(super) v: Function,
}

/// What adds up to the positions `(x, y)` of a section.
pub(super) fn products(form: &Form) -> Vec<Product> {
    let product = |x: f64, y: f64, u: Function, v: Function| Product { by: DVec2::new(x, y), u, v };
    match form {
        Form::Rectangle([rx, ry]) => rectangle([-rx, -ry]),
        Form::RectangleReversed([rx, ry]) => rectangle([*rx, *ry]),
        Form::Disc([rx, ry]) => vec![
            product(*rx, 0.0, Function::X, Function::Sine(2.0)),
            product(0.0, *ry, Function::X, Function::Cosine(2.0)),
        ],
        Form::DiscInSquare([rx, ry]) => vec![
            product(*rx, 0.0, Function::MIDDLE, Function::ONE),
            product(0.0, *ry, Function::HalfRound, Function::MIDDLE),
        ],
        Form::Outline { x, y } => {
            let axes = [(DVec2::X, x), (DVec2::Y, y)];
            axes.into_iter()
                .flat_map(|(axis, series)| series.iter().flat_map(move |wave| harmonic(axis, wave)))
                .collect()
        }
    }
}

fn rectangle([x, y]: [f64; 2]) -> Vec<Product> {
    vec![
        Product { by: DVec2::new(x, 0.0), u: Function::MIDDLE, v: Function::ONE },
        Product { by: DVec2::new(0.0, y), u: Function::ONE, v: Function::MIDDLE },
    ]
}

/// The mean stays where it is, and `u` draws all else towards it.
fn harmonic(axis: DVec2, &Harmonic { n, cos, sin }: &Harmonic) -> Vec<Product> {
    if n == 0.0 {
        return vec![Product { by: axis * cos, u: Function::ONE, v: Function::ONE }];
    }
    let waves = [(cos, Function::Cosine(2.0 * n)), (sin, Function::Sine(2.0 * n))];
    let waves = waves.into_iter().filter(|(by, _)| *by != 0.0);
    waves.map(|(by, v)| Product { by: axis * by, u: Function::X, v }).collect()
}

/// The Fourier series of one coordinate of a closed section.
pub(super) fn series(form: &Form, axis: usize) -> Vec<Harmonic> {
    match form {
        Form::Outline { x, y } => [x, y][axis].clone(),
        Form::Disc([x, y]) => match axis {
            0 => vec![Harmonic { n: 1.0, cos: 0.0, sin: *x }],
            _ => vec![Harmonic { n: 1.0, cos: *y, sin: 0.0 }],
        },
        _ => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::TAU;

    use super::*;

    fn at(form: &Form, u: f64, v: f64) -> [f64; 2] {
        let value = |function: &Function, x: f64| function.jet::<1>(x)[0];
        products(form).iter().map(|p| p.by * value(&p.u, u) * value(&p.v, v)).sum::<DVec2>().to_array()
    }

    #[test]
    fn every_form_is_what_the_paper_says() {
        let radius = [2.0, 3.0];
        let wave = |n: f64, cos: f64, sin: f64| Harmonic { n, cos, sin };
        let outline = Form::Outline {
            x: vec![wave(0.0, 5.0, 0.0), wave(1.0, 0.0, 2.0), wave(3.0, 0.1, 0.2)],
            y: vec![wave(1.0, 3.0, -0.5)],
        };
        for (u, v) in [(0.0, 0.0), (1.0, 1.0), (0.2, 0.7), (0.9, 0.4), (0.5, 0.25)] {
            let (s, c) = (TAU * v).sin_cos();
            let (s3, c3) = (3.0 * TAU * v).sin_cos();
            let half = 2.0 * u - 1.0;
            for (form, expected) in [
                (Form::Rectangle(radius), [2.0 * (1.0 - 2.0 * u), 3.0 * (1.0 - 2.0 * v)]),
                (Form::RectangleReversed(radius), [2.0 * half, 3.0 * (2.0 * v - 1.0)]),
                (Form::Disc(radius), [2.0 * u * s, 3.0 * u * c]),
                (Form::DiscInSquare(radius), [2.0 * half, 3.0 * (2.0 * v - 1.0) * (1.0 - half * half).sqrt()]),
                (outline.clone(), [5.0 + u * (2.0 * s + 0.1 * c3 + 0.2 * s3), u * (3.0 * c - 0.5 * s)]),
            ] {
                for (found, expected) in at(&form, u, v).into_iter().zip(expected) {
                    assert!((found - expected).abs() < 1e-14, "{form:?} at {u}, {v}: {found}, not {expected}");
                }
            }
        }
    }
}
