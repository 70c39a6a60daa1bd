//! The tables of the document as modules of TypeScript, for a page on which it is edited: what is edited, what holds of it whoever looks at it, and what it is made of.

use super::blend::{BlendSlider, MOST_TERMS, Method, SECTION_SLIDERS, TERMS, WEIGHT_SLIDERS};
use super::ceramics::{OWN_CLAY, OWN_GLAZE, OWN_OPACITY};
use super::described::Family;
use super::fields::{Dimension, Field, Need};
use super::limits::{CHARACTERS, FORCE, MODES, PARTS, PATCHES, RINGS};
use super::look::{Clay, Glaze};
use super::number::plain;
use super::quantity::Size;
use super::shape::KINDS;
use super::slider::{Group, Slider, Which};
use super::tables::{Entry, FOURTH_DATUM, SECOND_DATUM};
use super::text::write as to_json;
use super::unit::Unit;
use super::wall::{RimForm, SLIDERS, Side};

/// What a person can change of a document, as the text of a module of TypeScript: of each family the numbers in the order in which they are shown, with symbol, group, dimension, range and
/// step, and what it starts from; the numbers of a wall, and of a harmonic. Labels are not among them.
///
/// ```
/// assert!(pasu::typescript_of_sliders().contains(r#"key: "n-1", path: ["n", 1], symbol: "n_2", group: "wall", dimension: "waves""#));
/// ```
pub fn typescript_of_sliders() -> String {
    let mut text = generated();
    let groups = list(Group::ALL.iter().map(|(_, name)| quoted(name)));
    constant(&mut text, "What of a pot a number is about, in the order in which they are shown.", "GROUPS", &groups);
    let families = families().map(|(kind, family)| (quoted(kind), of_family(kind, &family)));
    constant(
        &mut text,
        "The numbers of the named families, and what each starts from.",
        "FAMILIES",
        &record(families, 0),
    );
    let data = [("2", SECOND_DATUM), ("4", FOURTH_DATUM)].map(|(order, table)| (order.to_owned(), numbers(table)));
    constant(
        &mut text,
        "What can be prescribed of a harmonic, by the order of its component.",
        "DATA",
        &record(data, 0),
    );
    let wall = SLIDERS
        .iter()
        .map(|(field, which, most)| format!("{{ {}, most: {} }}", place(field, *which).remove(0), plain(*most)));
    constant(
        &mut text,
        "The numbers of a wall. All are lengths, from 0 to so much of the size of the pot.",
        "WALL",
        &lines(wall, 0),
    );
    text
}

/// What a person can change of a blend, as the text of a module that is fetched when there is one: the numbers of a section and of the equation with symbol, dimension, range and step, the
/// terms that hold where none are given and the most of them, the methods, and the most harmonics of an outline.
///
/// ```
/// assert!(pasu::typescript_of_blends().contains(r#"key: "taper", path: ["taper"], symbol: "κ", dimension: "one""#));
/// ```
pub fn typescript_of_blends() -> String {
    let mut text = generated();
    constant(&mut text, "The numbers of a section.", "SECTION", &lines(SECTION_SLIDERS.iter().map(of_blend_slider), 0));
    let weights = lines(WEIGHT_SLIDERS.iter().map(of_blend_slider), 0);
    constant(&mut text, "The weights of the equation, 1 where none are given.", "WEIGHTS", &weights);
    let counts = [("usual", TERMS), ("most", MOST_TERMS)];
    let counts = counts.map(|(name, terms)| (name.to_owned(), list(terms.iter().map(u32::to_string))));
    constant(
        &mut text,
        "Terms along u, v and w: those that hold where none are given, and the most.",
        "TERMS",
        &record(counts, 0),
    );
    let methods = list(Method::NAMES.iter().map(|name| quoted(name)));
    constant(&mut text, "How the equation can be solved.", "METHODS", &methods);
    text
}

/// What holds of a document whoever looks at it, as the text of another module: what may be left out, which numbers count waves, how long the interval round the axis is; units, the colours by
/// which glazes and clays are chosen, and the limits of a design.
///
/// ```
/// assert!(pasu::typescript_of_tables().contains("cm: 10,"));
/// ```
pub fn typescript_of_tables() -> String {
    let mut text = generated();
    let shapes = families().map(|(kind, family)| (quoted(kind), of_shape(&family)));
    constant(
        &mut text,
        "Of the named families: what holds of a number that is left out, the numbers that count waves, and the interval round the axis.",
        "SHAPES",
        &record(shapes, 0),
    );
    let units = Unit::ALL.iter().map(|unit| (unit.name().to_owned(), plain(unit.millimetres())));
    constant(&mut text, "Millimetres in each unit.", "UNITS", &record(units, 0));
    let glazes = Glaze::ALL.iter().map(|glaze| (quoted_if_needed(glaze.name()), swatch(glaze.swatch())));
    constant(&mut text, "The colours by which glazes are chosen.", "GLAZES", &record(glazes, 0));
    let clays = Clay::ALL.iter().map(|clay| (clay.name().to_owned(), swatch(clay.body().swatch)));
    constant(&mut text, "The colours by which clays are chosen.", "CLAYS", &record(clays, 0));
    let defaults = [
        ("unit", Unit::NAMES[0]),
        ("glaze", Glaze::NAMES[0]),
        ("clay", Clay::NAMES[0]),
        ("side", Side::NAMES[0]),
        ("rim", RimForm::NAMES[0]),
    ];
    let defaults = defaults.map(|(field, name)| (field.to_owned(), quoted(name)));
    constant(&mut text, "What holds where a name is left out.", "DEFAULTS", &record(defaults, 0));
    let limits = [
        ("parts", PARTS),
        ("modes", MODES),
        ("force", FORCE),
        ("rings", RINGS),
        ("patches", PATCHES),
        ("characters", CHARACTERS),
    ];
    let limits = limits.map(|(name, most)| (name.to_owned(), most.to_string()));
    constant(
        &mut text,
        "The most of a design: parts, modes of all parts, coefficients of a force, rings between the two ends, patches of a network, characters of a title or name.",
        "LIMITS",
        &record(limits, 0),
    );
    text
}

/// Glazes and clays as light sees them, as the text of a module for what draws and knows no document.
///
/// ```
/// assert!(pasu::typescript_of_materials().contains("stoneware: { colour: [0.4, 0.29, 0.195], roughness: 0.78 },"));
/// ```
pub fn typescript_of_materials() -> String {
    let mut text = generated();
    let glazes = Glaze::ALL.iter().map(|glaze| (quoted_if_needed(glaze.name()), of_glaze(*glaze)));
    constant(&mut text, "Layers of glaze, in linear colours; bare clay has none.", "LAYERS", &record(glazes, 0));
    let clays = Clay::ALL.iter().map(|clay| (clay.name().to_owned(), of_clay(*clay)));
    constant(&mut text, "Fired clay bodies, in linear colours.", "BODIES", &record(clays, 0));
    let own = [
        ("opacity".to_owned(), plain(OWN_OPACITY)),
        ("glaze".to_owned(), plain(OWN_GLAZE)),
        ("clay".to_owned(), plain(OWN_CLAY)),
    ];
    constant(
        &mut text,
        "What is of a colour of one's own: how opaque such a glaze is, and how rough glaze and clay are.",
        "OWN",
        &record(own, 0),
    );
    text
}

fn generated() -> String {
    String::from(
        "// Generated from the tables of the Rust crate `pasu` by `PASU_BLESS=1 cargo test -p pasu --features typescript`. Do not edit.\n",
    )
}

fn families() -> impl Iterator<Item = (&'static str, Family)> {
    KINDS.iter().filter_map(|kind| Some((kind.name, kind.family?)))
}

fn constant(text: &mut String, about: &str, name: &str, value: &str) {
    text.push_str(&format!("\n/** {about} */\nexport const {name} = {value} as const;\n"));
}

fn of_family(kind: &str, family: &Family) -> String {
    let sliders = (family.sliders)();
    let fields = sliders.iter().flat_map(|slider| {
        let field = family.fields.iter().find(|field| field.name == slider.field);
        field.map_or_else(Vec::new, |field| of_slider(slider, field))
    });
    let kind = format!("kind: {}", quoted(kind));
    let reset: Vec<String> = [kind].into_iter().chain(started(family, Need::Required)).collect();
    let parts = [("fields", lines(fields, 2)), ("reset", format!("{{ {} }}", reset.join(", ")))];
    record(parts.map(|(name, value)| (name.to_owned(), value)), 1)
}

fn of_shape(family: &Family) -> String {
    let defaults = started(family, Need::Optional);
    let defaults = if defaults.is_empty() { "{}".to_owned() } else { format!("{{ {} }}", defaults.join(", ")) };
    let counts = family.fields.iter().filter(|field| field.dimension == Dimension::Waves);
    let waves = list(counts.flat_map(|field| match field.size {
        Size::One => vec![format!("[\"{}\"]", field.name)],
        Size::List(length) => (0..length).map(|index| format!("[\"{}\", {index}]", field.name)).collect(),
    }));
    let span = to_json(&(family.span)());
    format!("{{ defaults: {defaults}, waves: {waves}, span: {span} }}")
}

/// The fields that have to be there, or that may be left out, with what a link starts from.
fn started(family: &Family, need: Need) -> Vec<String> {
    let fields = family.fields.iter().zip((family.start)()).filter(|(field, _)| field.need == need);
    fields.map(|(field, start)| format!("{}: {}", field.name, written(field.size, &start))).collect()
}

fn measures(dimension: Dimension) -> &'static str {
    match dimension {
        Dimension::One => "one",
        Dimension::Length => "length",
        Dimension::Waves => "waves",
        Dimension::Angle => "angle",
    }
}

fn of_blend_slider(slider: &BlendSlider) -> String {
    let [least, most] = slider.range.map(plain);
    format!(
        "{{ {}, symbol: {}, dimension: {}, min: {least}, max: {most}, step: {} }}",
        place(slider.field, slider.which).remove(0),
        quoted(slider.symbol),
        quoted(measures(slider.dimension)),
        plain(slider.step),
    )
}

/// One number, or those for `x` and for `y`.
fn of_slider(slider: &Slider, field: &Field) -> Vec<String> {
    let [least, most] = slider.range.map(plain);
    let dimension = measures(field.dimension);
    let places = place(slider.field, slider.which).into_iter().zip(["_x", "_y"]);
    places
        .map(|(place, axis)| {
            let (axis, pair) = match slider.which {
                Which::Both => (axis, format!(", pair: {}", quoted(slider.field))),
                Which::Only | Which::At(_) => ("", String::new()),
            };
            format!(
                "{{ {place}, symbol: {}, group: {}, dimension: {}, min: {least}, max: {most}, step: {}{pair} }}",
                quoted(&format!("{}{axis}", slider.symbol)),
                quoted(slider.group.name()),
                quoted(dimension),
                plain(slider.step),
            )
        })
        .collect()
}

/// A name by which labels are found, and the way to the number inside its record.
fn place(field: &str, which: Which) -> Vec<String> {
    let at = |index: usize| format!("key: \"{field}-{index}\", path: [\"{field}\", {index}]");
    match which {
        Which::Only => vec![format!("key: \"{field}\", path: [\"{field}\"]")],
        Which::At(index) => vec![at(index)],
        Which::Both => vec![at(0), at(1)],
    }
}

fn of_glaze(glaze: Glaze) -> String {
    glaze.layer().map_or("null".to_owned(), |layer| {
        format!(
            "{{ tint: {}, body: {}, opacity: {}, roughness: {} }}",
            triple(layer.tint),
            triple(layer.body),
            plain(layer.opacity),
            plain(layer.roughness),
        )
    })
}

fn of_clay(clay: Clay) -> String {
    let body = clay.body();
    format!("{{ colour: {}, roughness: {} }}", triple(body.colour), plain(body.roughness))
}

fn swatch(colour: u32) -> String {
    format!("\"#{colour:06x}\"")
}

fn triple(numbers: [f64; 3]) -> String {
    list(numbers.into_iter().map(plain))
}

/// The entries of a table that are numbers.
fn numbers(table: &[Entry]) -> String {
    list(table.iter().filter(|entry| entry.typescript == "number").map(|entry| quoted(entry.name)))
}

fn written(size: Size, numbers: &[f64]) -> String {
    match (size, numbers) {
        (Size::One, [number]) => plain(*number),
        (_, numbers) => list(numbers.iter().copied().map(plain)),
    }
}

fn quoted(text: &str) -> String {
    format!("{text:?}")
}

fn quoted_if_needed(name: &str) -> String {
    if name.contains('-') { quoted(name) } else { name.to_owned() }
}

fn list(items: impl IntoIterator<Item = String>) -> String {
    format!("[{}]", items.into_iter().collect::<Vec<String>>().join(", "))
}

/// A list with a line for each item, at so many levels within others.
fn lines(items: impl IntoIterator<Item = String>, level: usize) -> String {
    let margin = "  ".repeat(level);
    let lines: String = items.into_iter().map(|item| format!("{margin}  {item},\n")).collect();
    format!("[\n{lines}{margin}]")
}

/// The same of an object.
fn record(entries: impl IntoIterator<Item = (String, String)>, level: usize) -> String {
    let margin = "  ".repeat(level);
    let lines: String = entries.into_iter().map(|(name, value)| format!("{margin}  {name}: {value},\n")).collect();
    format!("{{\n{lines}{margin}}}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::tables::{SECTION, WALL};

    fn count(size: Size) -> usize {
        match size {
            Size::One => 1,
            Size::List(length) => length,
        }
    }

    #[test]
    fn every_number_of_every_family_has_one_slider_that_holds_what_it_starts_from() {
        for kind in KINDS {
            let Some(family) = kind.family else { continue };
            let mut shown: Vec<(&str, usize)> = Vec::new();
            for slider in (family.sliders)() {
                let index = family.fields.iter().position(|field| field.name == slider.field).expect(slider.field);
                let indices = match slider.which {
                    Which::Only => {
                        assert_eq!(family.fields[index].size, Size::One, "{} {}", kind.name, slider.field);
                        vec![0]
                    }
                    Which::At(index) => vec![index],
                    Which::Both => vec![0, 1],
                };
                let [least, most] = slider.range;
                for at in indices {
                    let start = (family.start)()[index][at];
                    assert!((least..=most).contains(&start), "{} {}", kind.name, slider.field);
                    shown.push((slider.field, at));
                }
                assert!(slider.step > 0.0 && slider.step <= (most - least) / 3.0, "{} {}", kind.name, slider.field);
            }
            let mut all: Vec<(&str, usize)> =
                family.fields.iter().flat_map(|field| (0..count(field.size)).map(|at| (field.name, at))).collect();
            shown.sort();
            all.sort();
            assert_eq!(shown, all, "{}", kind.name);
        }
    }

    #[test]
    fn groups_stand_where_their_names_are_looked_up() {
        for (group, name) in Group::ALL {
            assert_eq!(group.name(), name);
        }
    }

    #[test]
    fn the_sliders_of_a_wall_are_numbers_of_a_wall() {
        for entry in WALL {
            let length = match entry.typescript {
                "number" => 1,
                "readonly [number, number]" => 2,
                _ => 0,
            };
            assert_eq!(SLIDERS.iter().filter(|(field, ..)| *field == entry.name).count(), length, "{}", entry.name);
        }
    }

    #[test]
    fn every_number_of_a_section_and_every_weight_has_one_slider() {
        let numbers = |table: &[Entry]| -> Vec<(&str, usize)> {
            let count = |entry: &Entry| match entry.typescript {
                "number" => 1,
                "readonly [number, number]" => 2,
                _ => 0,
            };
            table.iter().flat_map(|entry| (0..count(entry)).map(|at| (entry.name, at))).collect()
        };
        let shown = |sliders: &[BlendSlider]| -> Vec<(&str, usize)> {
            let at = |which: Which| match which {
                Which::At(index) => index,
                Which::Only | Which::Both => 0,
            };
            sliders.iter().map(|slider| (slider.field, at(slider.which))).collect()
        };
        assert_eq!(shown(&SECTION_SLIDERS), numbers(SECTION));
        assert_eq!(shown(&WEIGHT_SLIDERS), [("weights", 0), ("weights", 1), ("weights", 2)]);
        for slider in SECTION_SLIDERS.iter().chain(&WEIGHT_SLIDERS) {
            let [least, most] = slider.range;
            assert!(slider.step > 0.0 && slider.step <= (most - least) / 100.0, "{}", slider.field);
        }
        assert!(WEIGHT_SLIDERS.iter().all(|slider| slider.range[0] > 0.0 && slider.range[1] >= 1.0));
    }

    #[test]
    fn what_holds_where_a_name_is_left_out_is_its_default() {
        assert_eq!(Unit::default().name(), Unit::NAMES[0]);
        assert_eq!((Glaze::default().name(), Clay::default().name()), (Glaze::NAMES[0], Clay::NAMES[0]));
        assert_eq!((Side::default().name(), RimForm::default().name()), (Side::NAMES[0], RimForm::NAMES[0]));
    }
}
