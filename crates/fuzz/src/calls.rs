//! Everything that can be asked of a design.

use pasu::{
    Craft, Design, Error, Format, Making, Map, MeasureOptions, MeshOptions, Product, Shape, Size, SketchOptions,
    Solution, open,
};
use serde_json::Value;

use crate::reading::{parsed, refusal};

/// One thing to ask.
type Ask = fn(&Solution) -> Result<(), Error>;

/// The calls by the names that an input begins with.
pub(crate) const CALLS: [(&str, Ask); 17] = [
    ("mesh", mesh),
    ("bound", bound),
    ("evaluate", evaluate),
    ("fingerprint", fingerprint),
    ("measure", measure),
    ("measure solid", measure_solid),
    ("check", check),
    ("check solid", check_solid),
    ("solid", solid),
    ("sketch", sketch),
    ("water", water),
    ("paint", paint),
    ("write mesh", write_mesh),
    ("write text", write_text),
    ("write step", write_step),
    ("write svg", write_svg),
    ("scale", scale),
];

/// A line with the name of a call, and a design; without that line, every call.
pub(crate) fn judge(input: &[u8]) -> bool {
    let text = String::from_utf8_lossy(input);
    let (name, source) = text.split_once('\n').unwrap_or(("", &text));
    let call = CALLS.iter().find(|(known, _)| *known == name);
    let Some(design) = parsed(if call.is_some() { source } else { &text }) else { return false };
    let solution = Solution::of(&design);
    let mut was_answered = false;
    for (name, ask) in CALLS.iter().filter(|known| call.is_none_or(|call| call.0 == known.0)) {
        match ask(&solution) {
            Ok(()) => was_answered = true,
            Err(error) => {
                refusal(&error);
                // Every call is of a design that is read: what is refused now has a place in it, or is an option.
                assert!(
                    !error.path().is_empty() || solution.design().parts().len() > 1 || *name == "scale",
                    "{name}: {error:?}"
                );
            }
        }
    }
    was_answered
}

fn finite<'a, N: Copy + Into<f64> + 'a>(what: &str, numbers: impl IntoIterator<Item = &'a N>) {
    for (i, number) in numbers.into_iter().enumerate() {
        let number: f64 = (*number).into();
        assert!(number.is_finite(), "{what}[{i}] is {number}");
    }
}

fn mesh(solution: &Solution) -> Result<(), Error> {
    let design = solution.design();
    for options in [MeshOptions::default(), MeshOptions { rows: Some(9), columns: Some(17), tolerance: None }] {
        let mesh = solution.mesh(&options)?;
        mesh.validate().unwrap_or_else(|wrong| panic!("{wrong}"));
        assert!(mesh.bound.is_none_or(|bound| bound.is_finite() && bound >= 0.0), "{:?}", mesh.bound);
        assert!(mesh.groups.len() == 3 * design.parts().len());
    }
    Ok(())
}

fn bound(solution: &Solution) -> Result<(), Error> {
    let bound = solution.bound(&MeshOptions { rows: Some(5), columns: Some(12), tolerance: None })?;
    assert!(bound.is_finite() && bound >= 0.0, "{bound}");
    Ok(())
}

fn evaluate(solution: &Solution) -> Result<(), Error> {
    const AT: [f64; 10] = [0.0, 0.0, 1.0, 0.1, 0.5, 0.05, 0.999_999, 0.0, 1e-9, 1e-3];
    for (part, of) in solution.design().parts().iter().enumerate() {
        let at: Vec<f64> = match of.shape {
            Shape::VertexFrame(_) => AT.chunks_exact(2).flat_map(|at| [0.0, at[0], at[1]]).collect(),
            _ => AT.to_vec(),
        };
        finite("position", &solution.evaluate(part, &at)?);
        let derivatives = solution.derivatives(part, &at)?;
        finite("du", &derivatives.du);
        finite("dv", &derivatives.dv);
    }
    Ok(())
}

fn fingerprint(solution: &Solution) -> Result<(), Error> {
    let print = solution.fingerprint()?;
    assert_eq!(Solution::of(&again(solution.design())).fingerprint().as_ref(), Ok(&print));
    Ok(())
}

/// The same design, by way of its link.
fn again(design: &Design) -> Design {
    Design::parse(&design.link()).unwrap_or_else(|error| panic!("{error}"))
}

fn measured(solution: &Solution, product: Product) -> Result<(), Error> {
    let measures = solution.measure(&MeasureOptions { product, ..MeasureOptions::default() })?;
    whole(&measures.to_json());
    Ok(())
}

fn measure(solution: &Solution) -> Result<(), Error> {
    measured(solution, Product::Pot)
}

fn measure_solid(solution: &Solution) -> Result<(), Error> {
    measured(solution, Product::Solid)
}

/// JSON has null for what is no number: a quantity never has it for its value or its error.
fn whole(json: &str) {
    fn has_hole(value: &Value) -> bool {
        match value {
            Value::Object(fields) => fields.iter().any(|(name, value)| {
                value.is_null() && matches!(name.as_str(), "value" | "error" | "degrees") || has_hole(value)
            }),
            Value::Array(items) => items.iter().any(has_hole),
            _ => false,
        }
    }
    let value: Value = serde_json::from_str(json).unwrap_or_else(|error| panic!("{error}: {json}"));
    assert!(!has_hole(&value), "{json}");
}

fn checked(solution: &Solution, making: &Making) -> Result<(), Error> {
    let report = solution.check(making)?;
    whole(&report.to_json());
    for finding in &report.findings {
        assert!(finding.message.len() > 10, "{finding:?}");
        finite("place", finding.at.iter().flatten());
    }
    Ok(())
}

fn check(solution: &Solution) -> Result<(), Error> {
    checked(solution, &Making { craft: Some(Craft::Clay), ..Making::default() })
}

fn check_solid(solution: &Solution) -> Result<(), Error> {
    checked(solution, &Making { product: Product::Solid, ..Making::default() })
}

fn solid(solution: &Solution) -> Result<(), Error> {
    for mesh in solution.solid(&Making { shrinkage: 12.5, ..Making::default() })? {
        finite("position", &mesh.positions);
        let n = mesh.positions.len() / 3;
        assert!(mesh.indices.iter().all(|&index| (index as usize) < n));
        assert!(mesh.indices.len() >= 12, "a closed mesh has four triangles at least");
    }
    Ok(())
}

fn sketch(solution: &Solution) -> Result<(), Error> {
    let sketch = solution.sketch(&SketchOptions { fill: Some(0.5), ..SketchOptions::default() })?;
    finite("position", &sketch.positions);
    finite("normal", &sketch.normals);
    let n = sketch.positions.len() / 3;
    assert!(sketch.indices.iter().all(|&index| (index as usize) < n));
    if let Some(water) = sketch.water {
        finite("water", &water.positions);
        finite("level", &[water.level]);
        finite("range", &water.range);
    }
    Ok(())
}

fn water(solution: &Solution) -> Result<(), Error> {
    let mut last = None;
    for level in [0.0, 1.0, 3.0, -1.0] {
        match solution.water(level) {
            Ok(water) => {
                finite("water", &water.positions);
                finite("measure", &[water.volume, water.error, water.area]);
                assert!(water.volume >= -water.error && water.error >= 0.0, "{} {}", water.volume, water.error);
            }
            Err(error) => last = Some(error),
        }
    }
    last.map_or(Ok(()), Err)
}

fn paint(solution: &Solution) -> Result<(), Error> {
    let options = MeshOptions { rows: Some(7), columns: Some(13), tolerance: None };
    for map in Map::ALL {
        let values = solution.paint(map, &options)?;
        assert_eq!(values.len(), solution.mesh(&options)?.n_vertices());
        finite(map.name(), &values);
    }
    Ok(())
}

/// A file, which tells the design that it is of.
fn written(solution: &Solution, format: Format, making: &Making) -> Result<(), Error> {
    let bytes = solution.write(format, making)?;
    let link = solution.design().link();
    match open(&bytes) {
        Some(found) => assert_eq!(found, link, "{}", format.name()),
        None => assert!(format == Format::Stl && link.len() > 20, "{} has no link", format.name()),
    }
    Ok(())
}

fn write_mesh(solution: &Solution) -> Result<(), Error> {
    for format in [Format::Stl, Format::ThreeMf, Format::Glb] {
        written(solution, format, &Making::default())?;
    }
    Ok(())
}

fn write_text(solution: &Solution) -> Result<(), Error> {
    for format in [Format::Obj, Format::Ply] {
        written(solution, format, &Making { product: Product::Solid, ..Making::default() })?;
    }
    Ok(())
}

fn write_step(solution: &Solution) -> Result<(), Error> {
    written(solution, Format::Step, &Making::default())
}

fn write_svg(solution: &Solution) -> Result<(), Error> {
    written(solution, Format::Svg, &Making::default())
}

fn scale(solution: &Solution) -> Result<(), Error> {
    for size in [Size::Height(120.0), Size::Width(80.0), Size::Capacity(250.0)] {
        let scale = Making { size: Some(size), ..Making::default() }.scale_of(solution)?;
        finite("scale", &[scale.size, scale.shrinkage, scale.millimetres]);
        assert!(scale.size > 0.0, "{}", scale.size);
    }
    Ok(())
}
