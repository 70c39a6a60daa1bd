//! How a file was made, as it says itself: the words of a making, written into a file's notes and read from them.

use crate::design::{Unit, plain};
use crate::make::{Craft, Making, Size};
use crate::solid::Product;

/// What a file was made of, and how.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Provenance {
    /// The link of the design, without `#`, as [`Design::parse`](crate::Design::parse) reads it.
    pub link: String,
    /// What was made of it and how large: [`write`](super::write) makes the same file of both. `None` where the file does not say, or says what cannot be: a making of which one
    /// value was lost would be another body.
    pub making: Option<Making>,
}

const PRODUCT: &str = "product";
const SIZE: &str = "size";
const SHRINKAGE: &str = "shrinkage";
const TOLERANCE: &str = "tolerance";
const CRAFT: &str = "craft";
const UNION: &str = "union";

/// What is said of a union where there is one.
const JOINED: &str = "true";

/// A making as names and texts, all of ASCII: unit, product and shrinkage always, the others where they were given. Lengths are in the unit of the design.
pub(super) fn told(making: &Making, unit: Unit) -> Vec<(&'static str, String)> {
    let mut told = vec![("unit", unit.name().to_owned()), (PRODUCT, making.product.name().to_owned())];
    if let Some(size) = making.size {
        let (name, value) = named(size);
        told.push((SIZE, format!("{name} {}", plain(value))));
    }
    told.push((SHRINKAGE, plain(making.shrinkage)));
    told.extend(making.tolerance.map(|tolerance| (TOLERANCE, plain(tolerance))));
    told.extend(making.craft.map(|craft| (CRAFT, craft.name().to_owned())));
    told.extend(making.union.then(|| (UNION, JOINED.to_owned())));
    told
}

/// The making that is told so. `note` gives the text of a name; `None` where there is no product, or any text is not understood or out of range.
pub(super) fn making(note: impl Fn(&str) -> Option<String>) -> Option<Making> {
    let product = note(PRODUCT)?;
    let making = Making {
        product: [Product::Pot, Product::Solid].into_iter().find(|one| one.name() == product)?,
        size: read(note(SIZE), size)?,
        shrinkage: read(note(SHRINKAGE), number)?.unwrap_or_default(),
        tolerance: read(note(TOLERANCE), number)?,
        craft: read(note(CRAFT), |text| Craft::ALL.into_iter().find(|one| one.name() == text))?,
        union: read(note(UNION), |text| (text == JOINED).then_some(true))?.unwrap_or_default(),
    };
    making.is_in_range().then_some(making)
}

/// The same on one line, as short as it can be: `pot height=18 shrinkage=12`. What was left out, and a shrinkage of nothing, takes no room.
pub(super) fn line(making: &Making) -> String {
    let mut line = making.product.name().to_owned();
    let mut add = |name: &str, text: &str| line.push_str(&format!(" {name}={text}"));
    if let Some(size) = making.size {
        let (name, value) = named(size);
        add(name, &plain(value));
    }
    if making.shrinkage > 0.0 {
        add(SHRINKAGE, &plain(making.shrinkage));
    }
    if let Some(tolerance) = making.tolerance {
        add(TOLERANCE, &plain(tolerance));
    }
    if let Some(craft) = making.craft {
        add(CRAFT, craft.name());
    }
    if making.union {
        add(UNION, JOINED);
    }
    line
}

/// What such a line, or one that holds it, tells of a name.
pub(super) fn of_line(line: &str, name: &str) -> Option<String> {
    let mut words = line.split(' ');
    match name {
        PRODUCT => {
            words.find(|word| [Product::Pot, Product::Solid].iter().any(|one| one.name() == *word)).map(str::to_owned)
        }
        SIZE => {
            let (name, value) = words.filter_map(|word| word.split_once('=')).find(|(name, _)| is_size(name))?;
            Some(format!("{name} {value}"))
        }
        _ => words
            .filter_map(|word| word.split_once('='))
            .find(|(found, _)| *found == name)
            .map(|(_, text)| text.to_owned()),
    }
}

fn named(size: Size) -> (&'static str, f64) {
    match size {
        Size::Height(height) => ("height", height),
        Size::Width(width) => ("width", width),
        Size::Capacity(capacity) => ("capacity", capacity),
    }
}

fn is_size(name: &str) -> bool {
    ["height", "width", "capacity"].contains(&name)
}

/// Nothing for nothing; `None` for what is there and cannot be read.
fn read<T>(text: Option<String>, how: impl Fn(&str) -> Option<T>) -> Option<Option<T>> {
    match text {
        None => Some(None),
        Some(text) => how(&text).map(Some),
    }
}

fn size(text: &str) -> Option<Size> {
    let (name, value) = text.split_once(' ')?;
    let value = number(value)?;
    match name {
        "height" => Some(Size::Height(value)),
        "width" => Some(Size::Width(value)),
        "capacity" => Some(Size::Capacity(value)),
        _ => None,
    }
}

fn number(text: &str) -> Option<f64> {
    text.parse().ok().filter(|number: &f64| number.is_finite())
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn makings() -> impl Strategy<Value = Making> {
        let above = prop_oneof![Just(f64::MIN_POSITIVE), Just(1e300), Just(0.1 + 0.2), 1e-9..1e9];
        let size = (0..4usize, above.clone()).prop_map(|(kind, value)| {
            [None, Some(Size::Height(value)), Some(Size::Width(value)), Some(Size::Capacity(value))][kind]
        });
        let shrinkage = prop_oneof![Just(0.0), Just(12.0), 0.0..50.0];
        let craft = prop_oneof![Just(None), Just(Some(Craft::Print)), Just(Some(Craft::Clay))];
        let tolerance = prop_oneof![Just(None), above.prop_map(Some)];
        let all = (any::<bool>(), size, shrinkage, tolerance, craft, any::<bool>());
        all.prop_map(|(solid, size, shrinkage, tolerance, craft, union)| {
            let product = if solid { Product::Solid } else { Product::Pot };
            Making { product, size, shrinkage, tolerance, craft, union }
        })
    }

    proptest! {
        #[test]
        fn what_is_told_is_read(made in makings()) {
            let notes = told(&made, Unit::Cm);
            let note = |name: &str| notes.iter().find(|(found, _)| *found == name).map(|(_, text)| text.clone());
            prop_assert_eq!(making(note), Some(made));
            prop_assert!(notes.iter().all(|(_, text)| text.is_ascii() && !text.contains(['"', '\'', '<', '\\'])));
            let line = format!("Pasu 0.1.0 0123456789abcdef passed {}", line(&made));
            prop_assert_eq!(making(|name| of_line(&line, name)), Some(made));
        }

        #[test]
        fn no_text_does_harm(product in "pot|solid|.{0,4}", size in "(height|width|capacity)? ?.{0,8}", number in "[-+0-9.einfa]{0,8}|.{0,4}") {
            let note = |name: &str| Some(match name {
                PRODUCT => product.clone(),
                SIZE => size.clone(),
                CRAFT => "clay".to_owned(),
                _ => number.clone(),
            });
            if let Some(made) = making(note) {
                prop_assert!((0.0..50.0).contains(&made.shrinkage) && made.tolerance.is_some_and(|x| x > 0.0));
            }
        }
    }
}
