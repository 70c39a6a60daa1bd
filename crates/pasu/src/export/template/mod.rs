//! A template at true scale as SVG: the sections of each part with their heights, the rim from above and unrolled; on one page as large as that, or on sheets of paper.

mod drawing;
mod frame;
mod paper;
mod ruler;
mod section;
mod sheet;
mod stand;
mod strip;

use glam::{DVec2, DVec3};

use self::drawing::{Anchor, Drawing, Layer, Pen, fixed, number};
pub(super) use self::frame::Frame;
pub(super) use self::paper::Paper;
use self::ruler::Ruler;
use self::sheet::sheet;
pub(super) use self::stand::Stand;
use super::contents::{Body, Notes, PROGRAM};
use super::numbers::short;
use super::shading::point;
use super::xml::escaped;
use crate::error::Result;

/// Free space round the drawing and between its pieces, millimetres.
const MARGIN: f64 = 12.0;
const GAP: f64 = 10.0;
/// Sizes of letters.
const TITLE: f64 = 5.0;
const TEXT: f64 = 3.0;
/// Heights of lines.
const LINE: f64 = 4.2;

/// The largest distance, along a side of the paper, of anything that a template shows from where its part stands, in millimetres: beyond ten metres nobody prints at true scale, and the lines of the grid alone would be a large file.
pub(super) const LARGEST: f64 = 10_000.0;

/// How far what is shown of a part reaches from where it stands, along a side of the paper; of a rim that is longer than a circle so large, the radius of a circle as long.
pub(super) fn reach(body: &Body, stand: &Stand) -> f64 {
    let seen = points(body).chain(stand.rim.iter().copied());
    let far = seen.fold(0.0, |most: f64, point| most.max((point - stand.frame.origin).length()));
    let last = stand.rim.last().copied();
    let mut before = last.unwrap_or_default();
    let mut round = 0.0;
    for point in &stand.rim {
        round += (*point - before).length();
        before = *point;
    }
    far.max(round / core::f64::consts::TAU)
}

/// The drawing, one unit a millimetre, on a page as large as that, or on sheets of paper. Heights are counted from the lowest point of each part along its axis.
///
/// # Errors
/// `too-large` for more sheets than anybody puts together.
pub(super) fn write(notes: &Notes, bodies: &[Body], stands: &[Stand], paper: Option<Paper>) -> Result<Vec<u8>> {
    let ruler = Ruler::of(notes.unit);
    let mut drawing = Drawing::default();
    let mut pen = DVec2::new(MARGIN, MARGIN + TITLE);
    drawing.text(pen, TITLE, Anchor::Start, &notes.title);
    for line in [
        format!("{}. Lengths in {}, true to scale; check the bar when printed.", scale(notes, &ruler), ruler.plural),
        format!("{PROGRAM}, {}; checks: {}", notes.fingerprint, notes.verdict),
    ] {
        pen.y += LINE + 0.6;
        drawing.text(pen, TEXT, Anchor::Start, &line);
    }
    pen.y += LINE;
    let mut width = bar(&mut drawing, &ruler, pen) - MARGIN;
    pen.y += 9.0;
    drawing.cover(DVec2::splat(MARGIN), DVec2::new(drawing.right().max(MARGIN + width), pen.y));
    pen.y += GAP;
    for (index, (body, stand)) in bodies.iter().zip(stands).enumerate() {
        let size = sheet(&mut drawing, &ruler, pen, index, body, stand);
        width = width.max(size.x);
        pen.y += size.y + GAP;
    }
    width = width.max(drawing.right() - MARGIN);
    let size = DVec2::new(width + 2.0 * MARGIN, pen.y - GAP + MARGIN);
    match paper {
        None => Ok(whole(notes, &drawing, size)),
        Some(paper) => paper.sheets(notes, &drawing),
    }
}

/// How large the pot is on paper, in words.
fn scale(notes: &Notes, ruler: &Ruler) -> String {
    let factor = fixed(notes.millimetres / ruler.unit, 4);
    match factor.as_str() {
        "1" => "As large as designed".to_owned(),
        // So small that four places say nothing.
        "0" => format!("{} times as large as designed", short(notes.millimetres / ruler.unit)),
        _ => format!("{factor} times as large as designed"),
    }
}

/// One page as large as the drawing.
fn whole(notes: &Notes, drawing: &Drawing, size: DVec2) -> Vec<u8> {
    let mut text = head(notes, size);
    for layer in Layer::ALL {
        text.push_str(&layer.open());
        text.push_str(drawing.drawn(layer));
        text.push_str("</g>\n");
    }
    text.push_str("</svg>\n");
    text.into_bytes()
}

/// The beginning of a file of this size in millimetres, white.
fn head(notes: &Notes, size: DVec2) -> String {
    let [width, height] = size.to_array().map(number);
    let mut metadata = String::new();
    for (name, text) in notes.list() {
        metadata.push_str(&format!("<pasu:{name}>{}</pasu:{name}>\n", escaped(&text)));
    }
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" xmlns:sodipodi=\"http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd\" width=\"{width}mm\" height=\"{height}mm\" viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\">\n<title>{}</title>\n<metadata>\n<pasu:design xmlns:pasu=\"https://github.com/pasu-vase/pasu/svg/1\">\n{metadata}</pasu:design>\n</metadata>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
        escaped(&notes.title),
    )
}

/// Draws the bar and returns where it ends.
fn bar(drawing: &mut Drawing, ruler: &Ruler, at: DVec2) -> f64 {
    let Ruler { bar, steps, .. } = *ruler;
    let from = at + DVec2::new(0.0, 3.0);
    drawing.named_line("bar", Pen::Bar, from, from + DVec2::new(bar, 0.0));
    for step in 0..=steps {
        let x = bar / f64::from(steps) * f64::from(step);
        let length = if step == 0 || 2 * step == steps || step == steps { 2.5 } else { 1.5 };
        drawing.line(Pen::Mark, from + DVec2::new(x, 0.0), from + DVec2::new(x, length));
    }
    drawing.text(from + DVec2::new(bar + 2.0, 1.0), TEXT, Anchor::Start, &ruler.length(bar));
    from.x + bar + 16.0
}

fn points<'a>(body: &'a Body) -> impl Iterator<Item = DVec3> + 'a {
    (0..body.positions.len() as u32 / 3).map(|vertex| point(body, vertex))
}

/// The corners of the least box round points.
fn extent(points: impl Iterator<Item = DVec2>) -> (DVec2, DVec2) {
    points.fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), point| (low.min(point), high.max(point)))
}
