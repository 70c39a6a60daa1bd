//! A pot of rings in a readable link: `rings?r=3,6,1.6,2.2&z=0,6,15,20&u=.35,.7`.
//!
//! `r` and `z` are lists from the foot to the rim; waves stand behind the mean that they go about, `6~3:.5:-.2` for `n`, the cosine and the sine. `u` are the places between foot and rim, evenly spaced when left
//! out; `sharp` the numbers of the rings with a corner, 0 the foot; `foot` and `rim` the slopes of radius and height there.

use super::pot::{Hoop, Rings, Series, Slopes};
use crate::design::number::{parse, plain, rounded, shortest};
use crate::design::refusal::{refused, shortened};
use crate::design::value::Value;
use crate::error::{Code, Error, Result};

/// What stands before `=`.
pub(super) const NAMES: &[&str] = &["r", "z", "u", "sharp", "foot", "rim", "a"];

/// What differs from [`Rings::start`].
#[inline]
pub(super) fn write(pot: &Rings) -> Vec<String> {
    let start = Rings::start();
    let mut query = Vec::new();
    let list = |series: Vec<&Series>| series.into_iter().map(written).collect::<Vec<String>>().join(",");
    let of = |pot: &Rings, series: fn(&Hoop) -> &Series| list(pot.rings.iter().map(series).collect());
    let (r, z) = (of(pot, |hoop| &hoop.r), of(pot, |hoop| &hoop.z));
    let has_other_rings = r != of(&start, |hoop| &hoop.r) || z != of(&start, |hoop| &hoop.z);
    if has_other_rings {
        query.extend([format!("r={r}"), format!("z={z}")]);
    }
    let places: Vec<f64> = inner(&pot.rings).iter().map(|hoop| hoop.u).collect();
    let usual =
        if has_other_rings { even(pot.rings.len()) } else { inner(&start.rings).iter().map(|hoop| hoop.u).collect() };
    if places != usual {
        query.push(format!("u={}", places.iter().map(|u| shortest(*u)).collect::<Vec<String>>().join(",")));
    }
    let sharp = pot.rings.iter().enumerate().filter(|(_, hoop)| hoop.sharp).map(|(index, _)| index.to_string());
    let sharp: Vec<String> = sharp.collect();
    if !sharp.is_empty() {
        query.push(format!("sharp={}", sharp.join(",")));
    }
    for (name, slopes) in [("foot", &pot.foot), ("rim", &pot.rim)] {
        if let Some(Slopes { r, z }) = slopes {
            query.push(format!("{name}={}", list(vec![r, z])));
        }
    }
    if pot.a != start.a {
        query.push(format!("a={}", shortest(pot.a)));
    }
    query
}

#[inline]
fn written(series: &Series) -> String {
    let waves = series.waves.iter().map(|wave| {
        let sine = if wave.sin == 0.0 { String::new() } else { format!(":{}", shortest(wave.sin)) };
        format!("~{}:{}{sine}", shortest(wave.n), shortest(wave.cos))
    });
    shortest(series.mean) + &waves.collect::<String>()
}

/// Those between foot and rim.
#[inline]
fn inner(rings: &[Hoop]) -> &[Hoop] {
    match rings {
        [_, inner @ .., _] => inner,
        _ => &[],
    }
}

/// Where so many rings are that are evenly spaced, without foot and rim.
#[inline]
fn even(n: usize) -> Vec<f64> {
    (1..n.saturating_sub(1)).map(|i| rounded(i as f64 / (n - 1) as f64)).collect()
}

/// The fields of the document from names and texts of a link.
#[inline]
pub(super) fn read(given: &[(&str, &str)]) -> Result<Vec<(String, Value)>> {
    let start = Rings::start();
    let text = |name: &str| given.iter().find(|(known, _)| *known == name).map(|(_, text)| *text);
    let items = |name: &str| text(name).map(|text| text.split(',').map(str::trim).collect::<Vec<&str>>());
    let usual =
        |series: fn(&Hoop) -> &Series| start.rings.iter().map(|hoop| series_of(&written(series(hoop)))).collect();
    let lists = [("r", items("r")), ("z", items("z"))];
    let has_other_rings = lists.iter().any(|(_, list)| list.is_some());
    let [r, z]: [Vec<Value>; 2] = lists.map(|(name, list)| match list {
        Some(list) => list.into_iter().map(series_of).collect(),
        None if name == "r" => usual(|hoop| &hoop.r),
        None => usual(|hoop| &hoop.z),
    });
    let n = r.len().max(z.len());
    let places = match items("u") {
        Some(list) => list.into_iter().map(Value::spelled).collect(),
        None if has_other_rings => even(n).into_iter().map(Value::Number).collect(),
        None => inner(&start.rings).iter().map(|hoop| Value::Number(hoop.u)).collect::<Vec<Value>>(),
    };
    if places.len() + 2 != n {
        let expected = format!("{} places between foot and rim", n.saturating_sub(2));
        return Err(refused(Code::WrongType, &expected, &places.len()).at("rings"));
    }
    let (foot, rim) = (Value::Number(0.0), Value::Number(1.0));
    let mut rings: Vec<Vec<(String, Value)>> =
        [foot].into_iter().chain(places).chain([rim]).map(|u| vec![("u".to_owned(), u)]).collect();
    for (name, list) in [("r", r), ("z", z)] {
        for (ring, value) in rings.iter_mut().zip(list) {
            ring.push((name.to_owned(), value));
        }
    }
    for item in items("sharp").into_iter().flatten() {
        let index = parse(item).filter(|x| *x == x.trunc() && *x >= 0.0 && *x < n as f64);
        let Some(index) = index else {
            let expected = format!("the number of a ring, 0 to {}", plain(n as f64 - 1.0));
            return Err(refused(Code::OutOfRange, &expected, &format!("{:?}", shortened(item))).at("rings"));
        };
        rings[index as usize].push(("sharp".to_owned(), Value::Bool(true)));
    }
    let mut fields = vec![("rings".to_owned(), Value::List(rings.into_iter().map(Value::Record).collect()))];
    for name in ["foot", "rim"] {
        if let Some(list) = items(name) {
            // What is missing is refused as a missing field, what is too much by a name that slopes do not have.
            let names = ["r", "z"].into_iter().map(str::to_owned).chain((2..).map(|index| index.to_string()));
            let slopes = names.zip(list).map(|(axis, item)| (axis, series_of(item))).collect();
            fields.push((name.to_owned(), Value::Record(slopes)));
        }
    }
    fields.extend(text("a").map(|text| ("a".to_owned(), Value::spelled(text))));
    // A name that is given twice is refused as a field would be.
    let repeated =
        given.iter().enumerate().find(|(index, (name, _))| given[..*index].iter().any(|(earlier, _)| earlier == name));
    match repeated {
        Some((_, (name, _))) => Err(Error::new(Code::Duplicate, *name, "this field is given twice; expected it once")),
        None => Ok(fields),
    }
}

/// `6~3:.5:-.2`. What is not a number stays a text, which the reader of the document refuses and says where.
#[inline]
fn series_of(text: &str) -> Value {
    let mut parts = text.split('~');
    let mean = parts.next().map_or(Value::Null, Value::spelled);
    let waves = parts.map(|wave| {
        let names = ["n", "cos", "sin"].into_iter().map(str::to_owned).chain((3..).map(|index| index.to_string()));
        Value::Record(names.zip(wave.split(':')).map(|(name, text)| (name, Value::spelled(text))).collect())
    });
    let waves: Vec<Value> = waves.collect();
    let mut fields = vec![("mean".to_owned(), mean)];
    if !waves.is_empty() {
        fields.push(("waves".to_owned(), Value::List(waves)));
    }
    Value::Record(fields)
}
