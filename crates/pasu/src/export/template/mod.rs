//! A template at true scale as SVG: the section of each part with its heights, the rim from above and unrolled.

mod drawing;
mod frame;
mod section;

use glam::{DVec2, DVec3};

use self::drawing::{Anchor, Drawing, Pen, label, number};
pub(super) use self::frame::Frame;
use self::section::section;
use super::contents::{Body, Notes, PROGRAM};
use super::shading::point;
use super::xml::escaped;
use crate::face::FaceKind;

/// Free space round the drawing and between its pieces, millimetres.
const MARGIN: f64 = 12.0;
const GAP: f64 = 10.0;
/// Sizes of letters.
const TITLE: f64 = 5.0;
const TEXT: f64 = 3.0;
/// Heights of lines.
const LINE: f64 = 4.2;
/// Room for the ruler to the left and the heights to the right.
const RULER: f64 = 14.0;
const HEIGHTS: f64 = 62.0;
/// How far the unrolled strip reaches below the lowest point of the rim.
const STRIP: f64 = 20.0;
/// How long the bar is by which a print is checked.
const CHECK: f64 = 100.0;

/// The largest distance, along a side of the paper, of anything that a template shows from where its part stands, in millimetres: beyond ten metres nobody prints at true scale, and the lines of the grid alone would be a large file.
pub(super) const LARGEST: f64 = 10_000.0;

/// What a template shows of a part beside its body.
pub(super) struct Stand {
    pub(super) frame: Frame,
    /// The edge of the rim once round, in millimetres, the first point not repeated; empty if it is a point.
    pub(super) rim: Vec<DVec3>,
}

/// How far what is shown of a part reaches from where it stands, along a side of the paper.
pub(super) fn reach(body: &Body, stand: &Stand) -> f64 {
    let seen = points(body).chain(stand.rim.iter().copied());
    seen.fold(0.0, |most: f64, point| {
        let (above, height) = (stand.frame.above(point).abs(), stand.frame.height(point).abs());
        most.max(above.x).max(above.y).max(height)
    })
}

/// A page as large as the drawing, one unit a millimetre. Heights are counted from the lowest point of each part along its axis.
pub(super) fn write(notes: &Notes, bodies: &[Body], stands: &[Stand]) -> Vec<u8> {
    let mut drawing = Drawing::default();
    let mut pen = DVec2::new(MARGIN, MARGIN + TITLE);
    drawing.text(pen, TITLE, Anchor::Start, &notes.title);
    for line in [
        format!("{}. Lengths in millimetres, true to scale; check the bar when printed.", notes.scale),
        format!("{PROGRAM}, {}; checks: {}", notes.fingerprint, notes.verdict),
    ] {
        pen.y += LINE + 0.6;
        drawing.text(pen, TEXT, Anchor::Start, &line);
    }
    pen.y += LINE;
    let mut width = bar(&mut drawing, pen) - MARGIN;
    pen.y += 9.0 + GAP;
    for (index, (body, stand)) in bodies.iter().zip(stands).enumerate() {
        let size = sheet(&mut drawing, pen, index, body, stand);
        width = width.max(size.x);
        pen.y += size.y + GAP;
    }
    width = width.max(drawing.right() - MARGIN);
    let (width, height) = (number(width + 2.0 * MARGIN), number(pen.y - GAP + MARGIN));
    let mut metadata = String::new();
    for (name, text) in notes.list() {
        metadata.push_str(&format!("<pasu:{name}>{}</pasu:{name}>\n", escaped(&text)));
    }
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}mm\" height=\"{height}mm\" viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\">\n<title>{}</title>\n<metadata>\n<pasu:design xmlns:pasu=\"https://github.com/pasu-vase/pasu/svg/1\">\n{metadata}</pasu:design>\n</metadata>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{}</svg>\n",
        escaped(&notes.title),
        drawing.finish(),
    )
    .into_bytes()
}

/// Draws the bar and returns where it ends.
fn bar(drawing: &mut Drawing, at: DVec2) -> f64 {
    let from = at + DVec2::new(0.0, 3.0);
    drawing.line(Pen::Outline, from, from + DVec2::new(CHECK, 0.0));
    for tenth in 0..=10 {
        let x = CHECK / 10.0 * f64::from(tenth);
        let length = if tenth % 5 == 0 { 2.5 } else { 1.5 };
        drawing.line(Pen::Mark, from + DVec2::new(x, 0.0), from + DVec2::new(x, length));
    }
    drawing.text(from + DVec2::new(CHECK + 2.0, 1.0), TEXT, Anchor::Start, "100 mm");
    from.x + CHECK + 16.0
}

/// All that there is of one part; returns its size.
fn sheet(drawing: &mut Drawing, at: DVec2, index: usize, body: &Body, stand: &Stand) -> DVec2 {
    let frame = &stand.frame;
    let foot = points(body).map(|p| frame.height(p)).fold(f64::INFINITY, f64::min);
    let frame = Frame { origin: frame.origin + frame.axis * foot, axis: frame.axis, across: frame.across };
    drawing.text(at + DVec2::new(0.0, TEXT), TEXT, Anchor::Start, &body.name);
    let mut size = DVec2::new(0.0, LINE + 2.0);
    let mut place = |drawn: DVec2| size = DVec2::new(size.x.max(drawn.x), size.y + drawn.y);
    place(elevation(drawing, at + DVec2::new(0.0, LINE + 2.0), index, body, &frame));
    if !stand.rim.is_empty() {
        let top = at + DVec2::new(0.0, size.y + GAP);
        let seen = from_above(drawing, top, &stand.rim, &frame);
        let unrolled = strip(drawing, top + DVec2::new(0.0, seen.y + GAP), &stand.rim, &frame);
        size = DVec2::new(size.x.max(seen.x).max(unrolled.x), size.y + 2.0 * GAP + seen.y + unrolled.y);
    }
    size
}

/// The section with its axis, a grid, a ruler and heights.
fn elevation(drawing: &mut Drawing, at: DVec2, index: usize, body: &Body, frame: &Frame) -> DVec2 {
    let outlines = section(body, frame);
    let corners = outlines.iter().flatten().copied().chain(points(body).map(|p| DVec2::new(0.0, frame.height(p))));
    let (low, high) = extent(corners);
    let top = at + DVec2::new(RULER, LINE);
    // The axis is where x is 0; heights grow upwards.
    let place = |p: DVec2| DVec2::new(top.x + p.x - low.x, top.y + high.y - p.y);
    let (upper, lower) = (place(DVec2::new(low.x, high.y)), place(DVec2::new(high.x, 0.0)));
    drawing.grid(place(DVec2::ZERO), upper, lower);
    let placed: Vec<Vec<DVec2>> = outlines.iter().map(|line| line.iter().map(|p| place(*p)).collect()).collect();
    drawing.area(&format!("section-{}", index + 1), &placed);
    drawing.line(Pen::Axis, place(DVec2::new(0.0, high.y + 4.0)), place(DVec2::new(0.0, -4.0)));

    let x = upper.x - 2.0;
    drawing.line(Pen::Mark, DVec2::new(x, upper.y), DVec2::new(x, lower.y));
    for tick in 0..=libm::floor(high.y / 5.0) as i64 {
        let y = lower.y - 5.0 * tick as f64;
        let length = if tick % 2 == 0 { 2.5 } else { 1.2 };
        drawing.line(Pen::Mark, DVec2::new(x - length, y), DVec2::new(x, y));
        if tick % 2 == 0 {
            drawing.text(DVec2::new(x - 3.2, y + 1.0), TEXT, Anchor::End, &(5 * tick).to_string());
        }
    }

    let mut free = upper.y - LINE;
    for (height, text) in heights(body, frame) {
        let y = lower.y - height;
        free = y.max(free + LINE);
        let from = DVec2::new(lower.x + 1.0, y);
        drawing.open_line(Pen::Mark, &[from, from + DVec2::new(2.0, 0.0), DVec2::new(lower.x + 6.0, free)]);
        drawing.text(DVec2::new(lower.x + 7.0, free + 1.0), TEXT, Anchor::Start, &text);
    }
    DVec2::new(RULER + high.x - low.x + HEIGHTS, (LINE + high.y + 5.0).max(free - at.y + LINE))
}

/// Heights worth marking, from the top down.
fn heights(body: &Body, frame: &Frame) -> Vec<(f64, String)> {
    let of = |kinds: &[FaceKind]| -> Vec<DVec3> {
        let faces = body.faces.iter().filter(|(kind, ..)| kinds.contains(kind));
        faces.flat_map(|(_, first, count)| &body.indices[*first..first + count]).map(|v| point(body, *v)).collect()
    };
    let mut marks = Vec::new();
    let (_, high) = extent(points(body).map(|p| frame.plan(p)));
    marks.push((high.y, "top".to_owned()));
    let outside = of(&[FaceKind::Outer]);
    let mut extremes: [Option<(f64, f64)>; 2] = [None, None];
    for p in outside {
        let (radius, height) = (frame.above(p).length(), frame.height(p));
        // To the micrometre: where a wall is upright the lowest point counts on every machine and in every mesh.
        let radius = libm::round(radius * 1e3) / 1e3;
        if extremes[0].is_none_or(|(widest, _)| radius > widest) {
            extremes[0] = Some((radius, height));
        }
        if extremes[1].is_none_or(|(narrowest, _)| radius < narrowest) {
            extremes[1] = Some((radius, height));
        }
    }
    for (extreme, word) in extremes.into_iter().zip(["farthest from the axis", "nearest to the axis"]) {
        if let Some((radius, height)) = extreme {
            marks.push((height, format!("{word}: {}", label(radius))));
        }
    }
    let mean = |list: &[DVec3]| list.iter().map(|p| frame.height(*p)).sum::<f64>() / list.len() as f64;
    for (kind, word) in [(FaceKind::Floor, "floor"), (FaceKind::Recess, "recess within the foot ring")] {
        let list = of(&[kind]);
        if !list.is_empty() {
            marks.push((mean(&list), word.to_owned()));
        }
    }
    marks.push((0.0, "foot".to_owned()));
    marks.sort_by(|a, b| b.0.total_cmp(&a.0));
    marks.into_iter().map(|(height, word)| (height, format!("{} {word}", label(height)))).collect()
}

/// The rim as it is seen from above, with the plane of the section.
fn from_above(drawing: &mut Drawing, at: DVec2, rim: &[DVec3], frame: &Frame) -> DVec2 {
    let seen: Vec<DVec2> = rim.iter().map(|p| frame.above(*p)).collect();
    let (low, high) = extent(seen.iter().copied().chain([DVec2::ZERO]));
    drawing.text(at + DVec2::new(0.0, TEXT), TEXT, Anchor::Start, "Rim from above, with the plane of the section");
    let top = at + DVec2::new(RULER, LINE + 5.0);
    let place = |p: DVec2| DVec2::new(top.x + p.x - low.x, top.y + high.y - p.y);
    drawing.grid(place(DVec2::ZERO), place(DVec2::new(low.x, high.y)), place(DVec2::new(high.x, low.y)));
    let mut outline: Vec<DVec2> = seen.iter().map(|p| place(*p)).collect();
    outline.extend(outline.first().copied());
    drawing.open_line(Pen::Outline, &outline);
    drawing.line(Pen::Axis, place(DVec2::new(low.x - 4.0, 0.0)), place(DVec2::new(high.x + 4.0, 0.0)));
    drawing.line(Pen::Axis, place(DVec2::new(0.0, low.y - 4.0)), place(DVec2::new(0.0, high.y + 4.0)));
    let size = high - low;
    DVec2::new(RULER + size.x + 4.0, LINE + 5.0 + size.y + 4.0)
}

/// The rim unrolled: a strip to lay round the pot whose upper edge is the rim. Its length is that of the rim as seen from above, `STRIP` is added below.
fn strip(drawing: &mut Drawing, at: DVec2, rim: &[DVec3], frame: &Frame) -> DVec2 {
    let n = rim.len();
    let mut along = vec![0.0];
    for i in 0..n {
        let step = (frame.above(rim[(i + 1) % n]) - frame.above(rim[i])).length();
        along.push(along[i] + step);
    }
    let heights: Vec<f64> = (0..=n).map(|i| frame.height(rim[i % n])).collect();
    let low = heights.iter().copied().fold(f64::INFINITY, f64::min);
    let high = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let length = along[n];
    let text = format!(
        "Rim unrolled, {} once round; lay the strip round the pot with its lower edge {} above the foot",
        label(length),
        label(low - STRIP)
    );
    drawing.text(at + DVec2::new(0.0, TEXT), TEXT, Anchor::Start, &text);
    let top = at + DVec2::new(RULER, LINE + 2.0);
    let bottom = top.y + high - low + STRIP;
    let place = |i: usize| DVec2::new(top.x + along[i], top.y + high - heights[i]);
    drawing.grid(DVec2::new(top.x, bottom), top, DVec2::new(top.x + length, bottom));
    let mut outline: Vec<DVec2> = (0..=n).map(place).collect();
    outline.extend([DVec2::new(top.x + length, bottom), DVec2::new(top.x, bottom)]);
    outline.push(outline[0]);
    drawing.open_line(Pen::Outline, &outline);
    for quarter in 0..=4 {
        let x = top.x + along[n * quarter / 4];
        drawing.line(Pen::Mark, DVec2::new(x, bottom), DVec2::new(x, bottom + 2.5));
        drawing.text(DVec2::new(x, bottom + 6.0), TEXT, Anchor::Middle, &format!("{quarter}/4"));
    }
    DVec2::new(RULER + length + 6.0, bottom + 8.0 - at.y)
}

fn points<'a>(body: &'a Body) -> impl Iterator<Item = DVec3> + 'a {
    (0..body.positions.len() as u32 / 3).map(|vertex| point(body, vertex))
}

/// The corners of the least box round points.
fn extent(points: impl Iterator<Item = DVec2>) -> (DVec2, DVec2) {
    points.fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), point| (low.min(point), high.max(point)))
}
