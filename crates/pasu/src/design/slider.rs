//! How a person changes the numbers of a family: their symbols, groups, ranges and steps, in the order in which they are shown.

/// What of a pot a number is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Group {
    Rim,
    Foot,
    Height,
    Wall,
    Equation,
    Force,
}

impl Group {
    /// In the order in which they are shown, with their names.
    pub(crate) const ALL: [(Group, &str); 6] = [
        (Group::Rim, "rim"),
        (Group::Foot, "foot"),
        (Group::Height, "height"),
        (Group::Wall, "wall"),
        (Group::Equation, "equation"),
        (Group::Force, "force"),
    ];

    pub(crate) fn name(self) -> &'static str {
        Group::ALL[self as usize].1
    }
}

/// Which numbers of a field.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Which {
    /// Its only one.
    Only,
    /// One of its list.
    At(usize),
    /// Those for `x` and for `y`, which are mostly the same.
    Both,
}

/// A number as a person changes it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Slider {
    pub(crate) field: &'static str,
    pub(crate) which: Which,
    /// As the papers write it; `_` lowers what follows, `'` is a prime. Of both, without `_x` and `_y`.
    pub(crate) symbol: &'static str,
    pub(crate) group: Group,
    /// Where a potter looks for it, at the size of the pots in the papers; lengths of larger pots go further.
    pub(crate) range: [f64; 2],
    pub(crate) step: f64,
}

impl Slider {
    /// Of a field of one number.
    pub(crate) const fn of(
        field: &'static str,
        symbol: &'static str,
        group: Group,
        range: [f64; 2],
        step: f64,
    ) -> Slider {
        Slider { field, which: Which::Only, symbol, group, range, step }
    }

    /// The same, of one number of a list.
    pub(crate) const fn at(self, index: usize) -> Slider {
        Slider { which: Which::At(index), ..self }
    }

    /// The same, of the numbers for `x` and for `y`.
    pub(crate) const fn both(self) -> Slider {
        Slider { which: Which::Both, ..self }
    }
}
