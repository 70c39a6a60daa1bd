//! Measures as JSON.

use serde::{Serialize, Serializer};

use super::capacity::Capacity;
use super::curvature::{CurvatureRange, Located};
use super::measures::{Body, Centre, Measures, Overhang, PartMeasures, ThicknessRange};
use super::quantity::Quantity;
use super::standing::{Footprint, Tipping};
use crate::design::{Value, to_json};
use crate::face::FaceKind;

/// `docs/measures.md` names every field with its unit.
impl Serialize for Measures {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.value().serialize(serializer)
    }
}

impl Measures {
    fn value(&self) -> Value {
        let mut fields = vec![field("unit", text(self.unit.name())), field("product", text(self.product.name()))];
        fields.extend(body(&self.whole));
        fields.push(field("parts", Value::List(self.parts.iter().map(part).collect())));
        Value::Record(fields)
    }

    /// As JSON text; `docs/measures.md` names every field with its unit.
    ///
    /// ```
    /// // A cylinder of radius 3 and height 4, with a wall of 0.5 and a base of 1.
    /// # let cup = pasu::Design::parse(
    /// #     r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 },
    /// #     "wall": { "thickness": 0.5, "base": 1 } }] }"#,
    /// # )?;
    /// let measures = pasu::measure(&cup, &pasu::MeasureOptions::default())?;
    /// assert!(measures.to_json().starts_with(r#"{"unit":"cm","product":"pot","height":{"value":4,"#));
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn to_json(&self) -> String {
        to_json(self)
    }
}

fn field(name: &str, value: Value) -> (String, Value) {
    (name.to_owned(), value)
}

fn text(text: &str) -> Value {
    Value::Text(text.to_owned())
}

/// JSON has no infinity; nothing that is not finite is let out.
fn number(x: f64) -> Value {
    if x.is_finite() { Value::Number(x) } else { Value::Null }
}

fn numbers(list: &[f64]) -> Value {
    Value::List(list.iter().map(|x| number(*x)).collect())
}

fn quantity(quantity: &Quantity) -> Value {
    Value::Record(vec![field("value", number(quantity.value)), field("error", number(quantity.error))])
}

fn record(fields: Vec<(&str, Value)>) -> Value {
    Value::Record(fields.into_iter().map(|(name, value)| field(name, value)).collect())
}

fn or_null<T>(value: Option<&T>, write: impl Fn(&T) -> Value) -> Value {
    value.map_or(Value::Null, write)
}

fn body(body: &Body) -> Vec<(String, Value)> {
    let width = record(vec![
        ("least", quantity(&body.width.least)),
        ("greatest", quantity(&body.width.greatest)),
        ("leastDirection", number(body.width.least_direction)),
        ("greatestDirection", number(body.width.greatest_direction)),
    ]);
    let clay = or_null(body.clay.as_ref(), |clay| {
        record(vec![("area", quantity(&clay.area)), ("volume", quantity(&clay.volume)), ("mass", quantity(&clay.mass))])
    });
    let both = |empty: Value, full: Value| record(vec![("empty", empty), ("full", full)]);
    vec![
        field("height", quantity(&body.height)),
        field("bottom", number(body.bottom)),
        field("top", number(body.top)),
        field("width", width),
        field("area", quantity(&body.area)),
        field("clay", clay),
        field("capacity", or_null(body.capacity.as_ref(), capacity)),
        field("centre", both(or_null(body.centre_empty.as_ref(), centre), or_null(body.centre_full.as_ref(), centre))),
        field("footprint", or_null(body.footprint.as_ref(), footprint)),
        field(
            "tipping",
            both(or_null(body.tipping_empty.as_ref(), tipping), or_null(body.tipping_full.as_ref(), tipping)),
        ),
    ]
}

fn capacity(capacity: &Capacity) -> Value {
    let fill = or_null(capacity.fill.as_ref(), |(level, volume)| {
        record(vec![("level", number(*level)), ("volume", quantity(volume))])
    });
    record(vec![
        ("brim", quantity(&capacity.brim)),
        ("spill", record(vec![("level", quantity(&capacity.spill_level)), ("at", numbers(&capacity.spill_at))])),
        ("floor", number(capacity.floor)),
        ("fill", fill),
        ("stopped", Value::Bool(capacity.is_stopped)),
    ])
}

fn centre(centre: &Centre) -> Value {
    record(vec![("at", numbers(&centre.at)), ("error", number(centre.error))])
}

fn footprint(footprint: &Footprint) -> Value {
    record(vec![
        ("level", number(footprint.level)),
        ("area", quantity(&footprint.area)),
        ("hullArea", quantity(&footprint.hull_area)),
        ("hull", Value::List(footprint.hull.iter().map(|point| numbers(point)).collect())),
    ])
}

fn tipping(tipping: &Tipping) -> Value {
    record(vec![
        ("degrees", number(tipping.degrees)),
        ("error", number(tipping.error)),
        ("toward", number(tipping.toward)),
    ])
}

fn part(part: &PartMeasures) -> Value {
    let words = |words: &Option<String>| words.as_ref().map_or(Value::Null, |words| text(words));
    let mut fields = vec![
        field("part", Value::Number(part.part as f64)),
        field("name", words(&part.name)),
        field("isPot", Value::Bool(part.reason.is_none())),
        field("reason", words(&part.reason)),
        field("capacityReason", words(&part.capacity_reason)),
    ];
    fields.extend(body(&part.body));
    let curvature = record(vec![("mean", range(&part.curvature.mean)), ("gaussian", range(&part.curvature.gaussian))]);
    fields.extend([
        field("thickness", or_null(part.thickness.as_ref(), thickness)),
        field("overhang", or_null(part.overhang.as_ref(), overhang)),
        field("overhangInside", or_null(part.overhang_inside.as_ref(), overhang)),
        field("curvature", curvature),
    ]);
    Value::Record(fields)
}

fn thickness(thickness: &ThicknessRange) -> Value {
    let (least, at) = thickness.least;
    let at = at.map_or(Value::Null, |at| numbers(&at));
    let [of_least, of_greatest, of_share] = thickness.errors;
    record(vec![
        ("asked", number(thickness.asked)),
        ("least", record(vec![("value", number(least)), ("error", number(of_least)), ("at", at)])),
        ("greatest", number(thickness.greatest)),
        ("greatestError", number(of_greatest)),
        ("thinned", number(thickness.thinned)),
        ("thinnedError", number(of_share)),
    ])
}

fn overhang(overhang: &Overhang) -> Value {
    let face = match overhang.face {
        FaceKind::Rim => "rim",
        FaceKind::Lining => "lining",
        _ => "outer",
    };
    record(vec![
        ("degrees", number(overhang.degrees)),
        ("error", number(overhang.error)),
        ("at", numbers(&overhang.at)),
        ("face", text(face)),
    ])
}

fn range(range: &CurvatureRange) -> Value {
    record(vec![
        ("least", or_null(range.least.as_ref(), located)),
        ("greatest", or_null(range.greatest.as_ref(), located)),
    ])
}

fn located(located: &Located) -> Value {
    record(vec![("value", number(located.value)), ("error", number(located.error)), ("at", numbers(&located.at))])
}
