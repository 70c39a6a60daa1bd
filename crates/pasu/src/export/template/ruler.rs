//! Lengths on paper, in the unit of the design, as a person writes them.

use crate::design::Unit;
use crate::export::numbers::rounded;

/// A unit of length on a ruler.
#[derive(Clone, Copy)]
pub(super) struct Ruler {
    /// Millimetres of a unit.
    pub(super) unit: f64,
    /// Its name, and that of many.
    pub(super) name: &'static str,
    pub(super) plural: &'static str,
    /// Decimal places of a length: a tenth of a millimetre, or a hundredth of an inch.
    places: usize,
    /// Millimetres between lines of the grid, and how many of them are between two dark ones.
    pub(super) grid: f64,
    pub(super) dark: i64,
    /// Millimetres between ticks; every second one is long.
    pub(super) tick: f64,
    /// How many ticks are between two with numbers, and what a number counts: units.
    pub(super) numbered: i64,
    pub(super) count: i64,
    /// Millimetres of the bar by which a print is checked, in so many equal steps.
    pub(super) bar: f64,
    pub(super) steps: u32,
}

impl Ruler {
    pub(super) fn of(unit: Unit) -> Ruler {
        let metric = Ruler {
            unit: unit.millimetres(),
            name: unit.name(),
            plural: "millimetres",
            places: 1,
            grid: 10.0,
            dark: 5,
            tick: 5.0,
            numbered: 2,
            count: 10,
            bar: 100.0,
            steps: 10,
        };
        match unit {
            Unit::Mm => metric,
            Unit::Cm => Ruler { plural: "centimetres", places: 2, count: 1, ..metric },
            Unit::In => Ruler {
                plural: "inches",
                places: 2,
                grid: 12.7,
                dark: 2,
                tick: 6.35,
                numbered: 4,
                count: 1,
                bar: 101.6,
                steps: 8,
                ..metric
            },
        }
    }

    /// A length given in millimetres as a person writes it: `12.35`, `100`, `0`.
    pub(super) fn number(&self, millimetres: f64) -> String {
        rounded(millimetres / self.unit, self.places)
    }

    /// The same with its unit.
    pub(super) fn length(&self, millimetres: f64) -> String {
        format!("{} {}", self.number(millimetres), self.name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_are_written_as_a_person_does() {
        for (unit, millimetres, text) in [
            (Unit::Mm, 99.999_999_99, "100 mm"),
            (Unit::Mm, 12.34, "12.3 mm"),
            (Unit::Cm, 123.45, "12.35 cm"),
            (Unit::Cm, 120.0, "12 cm"),
            (Unit::Cm, -0.01, "0 cm"),
            (Unit::Cm, -35.0, "-3.5 cm"),
            (Unit::In, 101.6, "4 in"),
            (Unit::In, 30.0, "1.18 in"),
        ] {
            assert_eq!(Ruler::of(unit).length(millimetres), text);
        }
    }

    #[test]
    fn grids_ticks_and_bars_are_whole_in_their_unit() {
        for unit in [Unit::Mm, Unit::Cm, Unit::In] {
            let ruler = Ruler::of(unit);
            let numbered = ruler.tick * ruler.numbered as f64;
            assert!((numbered - ruler.unit * ruler.count as f64).abs() < 1e-12);
            assert!(!ruler.length(ruler.bar).contains('.') && ruler.grid * ruler.dark as f64 % ruler.unit < 1e-9);
        }
    }
}
