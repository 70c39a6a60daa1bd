//! The text of an exchange structure (ISO 10303-21): strings, numbers, numbered entities.

use glam::DVec3;

use crate::design::plain;
use crate::export::numbers::push_decimal;
use crate::watch;

/// Decimal places of lengths: a picometre, a hundred times finer than CAD programs tell points apart.
const PLACES: usize = 9;
const POWER: f64 = 1e9;

/// The entities of a data section, numbered in the order in which they are added.
#[derive(Default)]
pub(super) struct Entities {
    text: Vec<u8>,
    n: usize,
}

/// The number of an entity.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) struct Id(usize);

impl std::fmt::Display for Id {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "#{}", self.0)
    }
}

impl Entities {
    /// Adds `CARTESIAN_POINT('',(0.,0.,0.))`, for example.
    pub(super) fn add(&mut self, entity: &str) -> Id {
        watch::work(5 + entity.len() as u64);
        self.n += 1;
        self.text.extend_from_slice(format!("#{}={entity};\n", self.n).as_bytes());
        Id(self.n)
    }

    /// A point, to the picometre.
    pub(super) fn point(&mut self, point: DVec3) -> Id {
        self.triple("CARTESIAN_POINT", point)
    }

    /// A direction; a unit vector.
    pub(super) fn direction(&mut self, direction: DVec3) -> Id {
        self.triple("DIRECTION", direction)
    }

    fn triple(&mut self, entity: &str, numbers: DVec3) -> Id {
        let [x, y, z] = numbers.to_array().map(length);
        self.add(&format!("{entity}('',({x},{y},{z}))"))
    }

    pub(super) fn text(self) -> Vec<u8> {
        self.text
    }
}

/// `(#1,#2,#3)`.
pub(super) fn list(ids: &[Id]) -> String {
    joined(ids.iter().map(Id::to_string))
}

/// `(1.,2.5)`.
pub(super) fn reals(numbers: &[f64]) -> String {
    joined(numbers.iter().copied().map(real))
}

/// `(4,1,4)`.
pub(super) fn integers(numbers: &[usize]) -> String {
    joined(numbers.iter().map(usize::to_string))
}

fn joined(items: impl Iterator<Item = String>) -> String {
    format!("({})", items.collect::<Vec<_>>().join(","))
}

/// What [`Entities::point`] makes of a coordinate, as a number.
pub(super) fn settled(x: f64) -> f64 {
    if is_fixed(x) { libm::round(x * POWER) / POWER } else { x }
}

fn is_fixed(x: f64) -> bool {
    x.abs() < 4e6
}

/// A length, to the picometre: `12.345`, `0.`, `-3.5`.
fn length(x: f64) -> String {
    if !is_fixed(x) {
        return real(x);
    }
    let whole = libm::round(x.abs() * POWER) as u64;
    let mut bytes = if x < 0.0 && whole > 0 { vec![b'-'] } else { Vec::new() };
    push_decimal(&mut bytes, whole, PLACES);
    if !bytes.contains(&b'.') {
        bytes.push(b'.');
    }
    bytes.into_iter().map(char::from).collect()
}

/// A number that reads back as it is: `1.`, `1.5E-7`. A real of the format has a point.
pub(super) fn real(x: f64) -> String {
    let text = plain(x);
    match (text.split_once('e'), text.contains('.')) {
        (None, true) => text,
        (None, false) => format!("{text}."),
        (Some((digits, power)), true) => format!("{digits}E{power}"),
        (Some((digits, power)), false) => format!("{digits}.E{power}"),
    }
}

/// A string with its quotes: quotes and backslashes doubled, what is not ASCII as UCS-2 (`\X2\00E9\X0\`) or UCS-4 (`\X4\0001F3FA\X0\`), as the edition of 2002 prescribes.
pub(super) fn string(text: &str) -> String {
    let mut into = "'".to_owned();
    // The number of digits of the run of encoded characters that is open.
    let mut open = 0;
    for c in text.chars() {
        let code = u32::from(c);
        let digits = match c {
            ' '..='~' => 0,
            _ if code <= 0xffff => 4,
            _ => 8,
        };
        if digits != open {
            if open > 0 {
                into.push_str("\\X0\\");
            }
            match digits {
                4 => into.push_str("\\X2\\"),
                8 => into.push_str("\\X4\\"),
                _ => {}
            }
            open = digits;
        }
        match (digits, c) {
            (0, '\'') => into.push_str("''"),
            (0, '\\') => into.push_str("\\\\"),
            (0, c) => into.push(c),
            (digits, _) => into.push_str(&format!("{code:0digits$X}")),
        }
    }
    if open > 0 {
        into.push_str("\\X0\\");
    }
    into.push('\'');
    into
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strings_hold_any_text() {
        let cases = [
            ("Vase", "'Vase'"),
            ("potter's \\ pot", "'potter''s \\\\ pot'"),
            ("café", "'caf\\X2\\00E9\\X0\\'"),
            ("éè 🏺é", "'\\X2\\00E900E8\\X0\\ \\X4\\0001F3FA\\X0\\\\X2\\00E9\\X0\\'"),
            ("a\u{7f}", "'a\\X2\\007F\\X0\\'"),
        ];
        for (text, written) in cases {
            assert_eq!(string(text), written);
        }
    }

    #[test]
    fn reals_have_a_point() {
        for (x, text) in
            [(0.0, "0."), (-0.0, "0."), (12.0, "12."), (0.1, "0.1"), (1e-9, "1.E-9"), (-2.5e300, "-2.5E+300")]
        {
            assert_eq!(real(x), text);
        }
        for (x, text) in [(0.0, "0."), (-1e-12, "0."), (12.0, "12."), (-0.125, "-0.125"), (1.0 / 3.0, "0.333333333")] {
            assert_eq!(length(x), text);
            assert_eq!(length(settled(x)), text);
        }
    }
}
