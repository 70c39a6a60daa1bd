//! What it takes to store a model as patches of the equation, as NURBS patches and as polygons that are as near to one ground truth: Table 1 of W22, of our own models.
//!
//! What each is and how it is counted is in `docs/frames.md`.

mod chart;
mod curve;
mod edges;
mod fit;
mod model;
mod numbers;
mod point;
mod spline;
mod truth;

use pasu::Result;

use self::chart::Layout;
use self::fit::{Fit, Kind};
use self::model::Model;
use self::numbers::bytes;
use self::truth::Truth;

/// The models of the gallery that are networks; a test of the page holds the file against it.
const MODELS: &str = include_str!("../../../../tests/bench/networks.json");

/// Degrees of NURBS patches.
const DEGREES: [usize; 2] = [2, 3];

/// Spans of a NURBS patch along a side of a frame that are tried, from the least storage on. What is below 1 goes over several frames.
const SPANS: [f64; 19] =
    [0.0625, 0.125, 0.1875, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0, 1.25, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0];

/// By what part the cells of polygons along a side of a frame are smaller than those tried before.
const FINER: f64 = 1.06;

/// The most of them.
const FINEST: f64 = 100.0;

/// The text of a weight, with what stands after it.
const WEIGHT: usize = "1.00000 ".len();

/// One way to store a model.
#[derive(Debug, Clone, PartialEq)]
pub struct Stored {
    /// Which.
    pub way: Way,
    /// How many patches, or triangles.
    pub pieces: usize,
    /// Vertices or control points.
    pub points: usize,
    /// Coordinates, weights and parameters.
    pub numbers: usize,
    /// These as text of six significant digits, with what stands between them.
    pub bytes: usize,
    /// The root of the mean square of its distance from the ground truth, as a part of the diagonal of the bounding box.
    pub rms: f64,
}

/// The ways to store a model.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Way {
    /// Through the points of its frames, as it is.
    Equation,
    /// A NURBS patch for each frame, of a degree, with spans along a side.
    OnFrames(usize, f64),
    /// NURBS patches that go over as many frames as the network allows.
    Large(usize, f64),
    /// Polygons with their corners on the truth, with cells along a side of a frame.
    OnTruth(f64),
    /// Polygons by least squares.
    Between(f64),
}

impl Stored {
    /// How many bytes are weights, all of which are 1.
    pub fn weights(&self) -> usize {
        match self.way {
            Way::OnFrames(..) | Way::Large(..) => WEIGHT * self.points,
            _ => 0,
        }
    }
}

/// A model stored in each way.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// The name of the model in the gallery.
    pub name: String,
    /// As patches of the equation.
    pub equation: Stored,
    /// What is as near in every other way, and takes the least of what was tried.
    pub others: Vec<Stored>,
}

/// By how much the hills of the ground truth are fuller than those of sines that a force makes, with what is said of it.
const HILLS: [(f64, &str); 3] = [(0.0, "hills of sines"), (0.3, "fuller hills"), (-0.3, "sharper hills")];

/// Every model in its order; one with forces against each kind of [`HILLS`].
///
/// # Errors
/// When a model is no design.
pub fn comparisons() -> Result<Vec<Comparison>> {
    let mut found = Vec::new();
    for mut model in Model::all(MODELS)? {
        if !model.is_sculpted() {
            found.push(compare(&model)?);
            continue;
        }
        for (fuller, said) in HILLS {
            model.fuller = fuller;
            let compared = compare(&model)?;
            found.push(Comparison { name: format!("{}, {said}", compared.name), ..compared });
        }
    }
    Ok(found)
}

fn compare(model: &Model) -> Result<Comparison> {
    let truth = Truth::of(model)?;
    let (points, parameters) = (model.used_points(), model.parameters());
    let equation = Stored {
        way: Way::Equation,
        pieces: model.frames.len(),
        points: points.len(),
        numbers: 3 * points.len() + parameters.len(),
        bytes: bytes(points.iter().flatten().chain(&parameters).copied()),
        rms: truth.rms(&mut |patch, at| model.points(patch, at))?,
    };
    let near = Near {
        each: Layout::of_each(&truth.edges),
        largest: Layout::of_largest(&truth.edges),
        truth: &truth,
        rms: equation.rms,
    };
    let others = [
        near.splines(&near.each, Way::OnFrames)?,
        near.splines(&near.largest, Way::Large)?,
        near.polygons(Kind::OnTruth, Way::OnTruth)?,
        near.polygons(Kind::Between, Way::Between)?,
    ];
    Ok(Comparison { name: model.name.clone(), equation, others: others.into_iter().flatten().collect() })
}

/// What is to be as near a truth as told.
struct Near<'a> {
    truth: &'a Truth<'a>,
    each: Layout,
    largest: Layout,
    rms: f64,
}

impl Near<'_> {
    /// What is stored in a way, unless it is not near enough.
    fn stored(&self, way: Way, layout: &Layout) -> Result<Option<Stored>> {
        let (kind, spans) = match way {
            Way::OnFrames(degree, spans) | Way::Large(degree, spans) => (Kind::Spline(degree), spans),
            Way::OnTruth(spans) => (Kind::OnTruth, spans),
            Way::Between(spans) => (Kind::Between, spans),
            Way::Equation => return Ok(None),
        };
        let fitted = Fit { kind, spans }.over(self.truth, layout)?;
        let rms = fitted.rms()?;
        let points = fitted.points();
        let mut stored = Stored {
            way,
            pieces: fitted.pieces(),
            points: points.len(),
            numbers: 3 * points.len(),
            bytes: bytes(points.iter().flatten().copied()),
            rms,
        };
        if let Kind::Spline(_) = kind {
            stored.numbers += points.len();
            stored.bytes += stored.weights();
        }
        Ok((rms <= self.rms).then_some(stored))
    }

    /// The first of each degree that is as near, the smaller of these.
    fn splines(&self, layout: &Layout, way: fn(usize, f64) -> Way) -> Result<Option<Stored>> {
        let mut best = None;
        // A patch on one frame has whole spans.
        let is_each = layout.charts.len() == self.truth.model.frames.len();
        for degree in DEGREES {
            for spans in SPANS.into_iter().filter(|spans| !is_each || spans.fract() == 0.0) {
                if let Some(found) = self.stored(way(degree, spans), layout)? {
                    best = smaller(best, found);
                    break;
                }
            }
        }
        Ok(best)
    }

    /// The first that are as near: over large charts, where as many cells as one likes are along a side, or on frames.
    fn polygons(&self, kind: Kind, way: fn(f64) -> Way) -> Result<Option<Stored>> {
        let mut best = None;
        for layout in [&self.each, &self.largest] {
            let is_each = layout.charts.len() == self.truth.model.frames.len();
            // An error falls with the square of the fineness: a little below where it may do, and on from there.
            let coarse = Fit { kind, spans: 2.0 }.over(self.truth, layout)?.rms()?;
            let mut fineness = 0.7 * 2.0 * (coarse / self.rms).sqrt();
            while fineness <= FINEST {
                let cells = if is_each { fineness.ceil() } else { fineness };
                if let Some(found) = self.stored(way(cells), layout)? {
                    best = smaller(best, found);
                    break;
                }
                fineness = FINER * if is_each { cells } else { fineness };
            }
        }
        Ok(best)
    }
}

fn smaller(best: Option<Stored>, other: Stored) -> Option<Stored> {
    Some(best.filter(|best| best.bytes <= other.bytes).unwrap_or(other))
}

/// For people: of what each other way takes the patches of the equation take how much, and below it all of it.
pub fn table(comparisons: &[Comparison]) -> String {
    let mut short = vec![
        "| model | RMS | PDE: points, bytes | of NURBS on frames | of large NURBS | of polygons | by least squares |"
            .to_owned(),
        "| --- | ---: | ---: | ---: | ---: | ---: | ---: |".to_owned(),
    ];
    let mut long = vec![
        "| model | as | patches or triangles | points | numbers | bytes | RMS |".to_owned(),
        "| --- | --- | ---: | ---: | ---: | ---: | ---: |".to_owned(),
    ];
    for Comparison { name, equation, others } in comparisons {
        let percent = |bytes: usize| format!("{:.0} %", 100.0 * equation.bytes as f64 / bytes as f64);
        let part = |stored: &Stored| match stored.weights() {
            0 => percent(stored.bytes),
            weights => format!("{} ({})", percent(stored.bytes), percent(stored.bytes - weights)),
        };
        let ways: [fn(&Way) -> bool; 4] = [
            |way| matches!(way, Way::OnFrames(..)),
            |way| matches!(way, Way::Large(..)),
            |way| matches!(way, Way::OnTruth(_)),
            |way| matches!(way, Way::Between(_)),
        ];
        let parts = ways.map(|is| others.iter().find(|stored| is(&stored.way)).map_or("-".to_owned(), part));
        short.push(format!(
            "| {name} | {:.1e} | {}, {} | {} |",
            equation.rms,
            equation.points,
            equation.bytes,
            parts.join(" | ")
        ));
        for (number, stored) in std::iter::once(equation).chain(others).enumerate() {
            let way = match stored.way {
                Way::Equation => "PDE".to_owned(),
                Way::OnFrames(degree, spans) => {
                    format!("NURBS on frames, degree {degree}, spans along a frame: {spans}")
                }
                Way::Large(degree, spans) => format!("large NURBS, degree {degree}, spans along a frame: {spans}"),
                Way::OnTruth(cells) => format!("polygons, {cells:.1} along a frame"),
                Way::Between(cells) => format!("polygons by least squares, {cells:.1} along a frame"),
            };
            let Stored { pieces, points, numbers, bytes, rms, .. } = stored;
            let name = if number == 0 { name } else { "" };
            long.push(format!("| {name} | {way} | {pieces} | {points} | {numbers} | {bytes} | {rms:.1e} |"));
        }
    }
    format!("{}\n\n{}", short.join("\n"), long.join("\n"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_stored_is_as_near_as_the_patches_and_counted_by_one_rule() {
        let mut all = Model::all(MODELS).unwrap();
        assert!(all.len() >= 9);
        // A single patch, a sculpted one, and a body.
        for (name, fuller) in [("own-leaf", 0.0), ("own-leaf-pushed", -0.3), ("own-hat", 0.0)] {
            let model = all.iter_mut().find(|model| model.name == name).unwrap();
            model.fuller = fuller;
            let found = compare(model).unwrap();
            assert_eq!(found.others.len(), 4, "{name}");
            for stored in &found.others {
                assert!(stored.rms <= found.equation.rms && stored.rms > 0.1 * found.equation.rms, "{name} {stored:?}");
                let is_spline = matches!(stored.way, Way::OnFrames(..) | Way::Large(..));
                assert_eq!(stored.numbers, if is_spline { 4 } else { 3 } * stored.points);
                assert_eq!(stored.weights(), if is_spline { 8 } else { 0 } * stored.points);
                assert!(stored.bytes >= 8 * stored.numbers && stored.bytes <= 13 * stored.numbers);
            }
            let [each, largest, on, between] = found.others.try_into().unwrap();
            assert!(largest.pieces <= each.pieces && each.pieces == found.equation.pieces, "{name}");
            assert!(between.bytes < on.bytes, "{name}");
        }
    }

    #[test]
    fn the_table_says_what_part_the_patches_are_of_each_other_way() {
        let stored =
            |way, pieces, points, bytes| Stored { way, pieces, points, numbers: 3 * points, bytes, rms: 0.0015 };
        let others = vec![stored(Way::OnFrames(2, 1.0), 1, 10, 400), stored(Way::OnTruth(4.0), 32, 25, 600)];
        let comparison = Comparison { name: "a".to_owned(), equation: stored(Way::Equation, 1, 8, 200), others };
        let table = table(&[comparison]);
        assert!(table.contains("| a | 1.5e-3 | 8, 200 | 50 % (62 %) | - | 33 % | - |"), "{table}");
        assert!(table.contains("|  | polygons, 4.0 along a frame | 32 | 25 | 75 | 600 | 1.5e-3 |"), "{table}");
    }

    #[test]
    fn the_numbers_of_a_leaf_are_those_that_one_counts_by_hand() {
        let all = Model::all(MODELS).unwrap();
        let leaf = |name: &str| compare(all.iter().find(|model| model.name == name).unwrap()).unwrap().equation;
        // Eight points; with a force of three components; with two such and their rectangles.
        assert_eq!(
            [leaf("own-leaf"), leaf("own-leaf-pushed"), leaf("own-leaf-regions")].map(|leaf| leaf.numbers),
            [24, 27, 38]
        );
    }
}
