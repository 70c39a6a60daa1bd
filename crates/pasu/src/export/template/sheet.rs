//! All that a template shows of one part.

use glam::{DVec2, DVec3};

use super::drawing::{Anchor, Drawing, Pen};
use super::frame::Frame;
use super::layout::{GAP, LINE, TEXT, extent, points};
use super::levels::{Farness, Levels};
use super::ruler::Ruler;
use super::section::section;
use super::stand::{Plane, Stand};
use super::strip::{Strip, between, length, straight};
use crate::export::contents::Body;
use crate::export::shading::point;
use crate::face::FaceKind;

/// Room for the ruler to the left and the heights to the right.
const RULER: f64 = 14.0;
const HEIGHTS: f64 = 62.0;
/// How far a straight strip reaches below the lowest point of the rim.
const STRIP: f64 = 20.0;
/// Room for a word at the end of a plane.
const WORD: f64 = 14.0;
/// Room for a fraction of the way round the strip.
const FRACTION: f64 = 7.0;
/// How far from the strip that is written.
const WRITTEN: f64 = 5.0;
/// How far lines of planes go beyond the rim.
const BEYOND: f64 = 4.0;

/// All that there is of one part; returns its size.
pub(super) fn sheet(
    drawing: &mut Drawing,
    ruler: &Ruler,
    at: DVec2,
    index: usize,
    body: &Body,
    stand: &Stand,
) -> DVec2 {
    let frame = stand.frame.raised(stand.levels.foot);
    drawing.text(at + DVec2::new(0.0, TEXT), TEXT, Anchor::Start, &body.name);
    let mut size = DVec2::new(0.0, LINE + 2.0);
    let mut piece = |drawing: &mut Drawing, draw: &mut dyn FnMut(&mut Drawing, DVec2) -> DVec2| {
        let top = at + DVec2::new(0.0, size.y);
        let drawn = draw(drawing, top);
        drawing.cover(top, top + drawn);
        size = DVec2::new(size.x.max(drawn.x), size.y + drawn.y + GAP);
    };
    drawing.cover(at, at + DVec2::new(HEIGHTS, LINE + 2.0));
    for (number, plane) in stand.planes.iter().enumerate() {
        let id = format!("section-{}{}", index + 1, ["", "-lowest"][number.min(1)]);
        let mut draw = |drawing: &mut Drawing, top: DVec2| {
            let mut top = top;
            let caption = !plane.through.is_empty();
            if caption {
                let text = format!("Section through {}", plane.through);
                drawing.text(top + DVec2::new(0.0, TEXT), TEXT, Anchor::Start, &text);
                top.y += LINE;
            }
            let size = elevation(drawing, ruler, top, &id, body, &frame.towards(plane.towards), stand);
            size + DVec2::new(0.0, if caption { LINE } else { 0.0 })
        };
        piece(drawing, &mut draw);
    }
    if !stand.rim.is_empty() {
        piece(drawing, &mut |drawing, top| from_above(drawing, ruler, top, index, stand));
        piece(drawing, &mut |drawing, top| unrolled(drawing, ruler, top, index, stand, &frame));
    }
    DVec2::new(size.x, size.y - GAP)
}

/// A section with its axis, a grid, a ruler and heights.
fn elevation(
    drawing: &mut Drawing,
    ruler: &Ruler,
    at: DVec2,
    id: &str,
    body: &Body,
    frame: &Frame,
    stand: &Stand,
) -> DVec2 {
    let outlines = section(body, frame);
    let corners = outlines.iter().flatten().copied().chain(points(body).map(|p| DVec2::new(0.0, frame.height(p))));
    let (low, high) = extent(corners);
    let top = at + DVec2::new(RULER, LINE);
    // The axis is where x is 0; heights grow upwards.
    let place = |p: DVec2| DVec2::new(top.x + p.x - low.x, top.y + high.y - p.y);
    let (upper, lower) = (place(DVec2::new(low.x, high.y)), place(DVec2::new(high.x, 0.0)));
    drawing.grid(ruler, place(DVec2::ZERO), upper, lower);
    let placed: Vec<Vec<DVec2>> = outlines.iter().map(|line| line.iter().map(|p| place(*p)).collect()).collect();
    drawing.area(id, &placed);
    drawing.line(Pen::Axis, place(DVec2::new(0.0, high.y + 4.0)), place(DVec2::new(0.0, -4.0)));

    let x = upper.x - 2.0;
    drawing.line(Pen::Mark, DVec2::new(x, upper.y), DVec2::new(x, lower.y));
    for tick in 0..=libm::floor(high.y / ruler.tick) as i64 {
        let y = lower.y - ruler.tick * tick as f64;
        let length = if tick % 2 == 0 { 2.5 } else { 1.2 };
        drawing.line(Pen::Mark, DVec2::new(x - length, y), DVec2::new(x, y));
        if tick % ruler.numbered == 0 {
            let number = ruler.count * (tick / ruler.numbered);
            drawing.text(DVec2::new(x - 3.2, y + 1.0), TEXT, Anchor::End, &number.to_string());
        }
    }

    let mut free = upper.y - LINE;
    for (height, text) in heights(ruler, body, frame, stand) {
        let y = lower.y - height;
        free = y.max(free + LINE);
        let from = DVec2::new(lower.x + 1.0, y);
        drawing.open_line(Pen::Mark, &[from, from + DVec2::new(2.0, 0.0), DVec2::new(lower.x + 6.0, free)]);
        drawing.text(DVec2::new(lower.x + 7.0, free + 1.0), TEXT, Anchor::Start, &text);
    }
    DVec2::new(RULER + high.x - low.x + HEIGHTS, (LINE + high.y + 5.0).max(free - at.y + LINE))
}

/// Heights worth marking, from the top down.
fn heights(ruler: &Ruler, body: &Body, frame: &Frame, stand: &Stand) -> Vec<(f64, String)> {
    let of = |kinds: &[FaceKind]| -> Vec<DVec3> {
        let faces = body.faces.iter().filter(|(kind, ..)| kinds.contains(kind));
        faces.flat_map(|(_, first, count)| &body.indices[*first..first + count]).map(|v| point(body, *v)).collect()
    };
    let Levels { foot, top, farthest, nearest } = stand.levels;
    let mut marks = vec![(top - foot, "top".to_owned())];
    for (found, word) in [(farthest, "farthest from the axis"), (nearest, "nearest to the axis")] {
        if let Some(Farness { radius, height }) = found {
            marks.push((height - foot, format!("{word}: {}", ruler.number(radius))));
        }
    }
    if stand.planes.iter().any(|plane| !plane.through.is_empty()) {
        let lowest = stand.rim.iter().map(|p| frame.height(*p)).fold(f64::INFINITY, f64::min);
        marks.push((lowest, "rim at its lowest".to_owned()));
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
    marks.into_iter().map(|(height, word)| (height, format!("{} {word}", ruler.number(height)))).collect()
}

/// The rim as it is seen from above, with the planes of the sections.
fn from_above(drawing: &mut Drawing, ruler: &Ruler, at: DVec2, index: usize, stand: &Stand) -> DVec2 {
    let Stand { frame, rim, planes, .. } = stand;
    let seen: Vec<DVec2> = rim.iter().map(|p| frame.above(*p)).collect();
    let (low, high) = extent(seen.iter().copied().chain([DVec2::ZERO]));
    let caption = match planes.len() {
        1 => "Rim from above, with the plane of the section",
        _ => "Rim from above, with the planes of the sections",
    };
    drawing.text(at + DVec2::new(0.0, TEXT), TEXT, Anchor::Start, caption);
    // Between the caption and the rim there is a line for a word at the end of a plane.
    let above = LINE + LINE + 5.0;
    let top = at + DVec2::new(RULER, above);
    let place = |p: DVec2| DVec2::new(top.x + p.x - low.x, top.y + high.y - p.y);
    drawing.grid(ruler, place(DVec2::ZERO), place(DVec2::new(low.x, high.y)), place(DVec2::new(high.x, low.y)));
    let outline: Vec<DVec2> = seen.iter().map(|p| place(*p)).collect();
    drawing.closed_line(&format!("rim-{}", index + 1), &outline);
    let (from, to) = (low - DVec2::splat(BEYOND), high + DVec2::splat(BEYOND));
    let mut written = Vec::new();
    for Plane { towards, through, ends } in planes {
        // The line across the only section shows where the middle is.
        let across = through.is_empty().then_some((towards.perp(), [""; 2]));
        for (direction, ends) in [(*towards, *ends)].into_iter().chain(across) {
            let [away, near] = [-direction, direction].map(|direction| place(within(direction, from, to)));
            drawing.line(Pen::Axis, away, near);
            for (word, end) in ends.iter().zip([near, away]).filter(|(word, _)| !word.is_empty()) {
                // Towards the middle, or it would be beyond the edge of the paper.
                let anchor = if end.x > top.x + 0.5 * (high.x - low.x) { Anchor::End } else { Anchor::Start };
                let mut at = end - DVec2::new(0.0, 1.0);
                // Below what is written at about the same place: seen from the middle two ends may be close.
                while written.iter().any(|other: &DVec2| (at - other).abs().cmplt(DVec2::new(WORD, LINE)).all()) {
                    at.y += LINE;
                }
                written.push(at);
                drawing.text(at, TEXT, anchor, word);
            }
        }
    }
    let size = high - low;
    DVec2::new(RULER + size.x + 4.0, above + size.y + 4.0)
}

/// Where a ray from the middle leaves a box that holds it.
fn within(towards: DVec2, low: DVec2, high: DVec2) -> DVec2 {
    let along = |x: f64, low: f64, high: f64| match x {
        x if x > 0.0 => high / x,
        x if x < 0.0 => low / x,
        _ => f64::INFINITY,
    };
    towards * along(towards.x, low.x, high.x).min(along(towards.y, low.y, high.y))
}

/// The rim unrolled: a strip to lay round the pot whose upper edge is the rim.
fn unrolled(drawing: &mut Drawing, ruler: &Ruler, at: DVec2, index: usize, stand: &Stand, frame: &Frame) -> DVec2 {
    let Stand { rim, hem, .. } = stand;
    let fits = !hem.is_empty();
    let Strip { upper, lower } = if fits { between(rim, hem) } else { straight(rim, frame, STRIP) };
    // Without a wall to lay it round, the lower edge is as long as the rim seen from above.
    let level = || rim.iter().map(|p| frame.above(*p).extend(0.0)).collect::<Vec<_>>();
    let round = if fits { length(hem) } else { length(&level()) };
    let mut text = format!("Rim unrolled, {} once round", ruler.number(round));
    let along = length(rim);
    if ruler.number(along) != ruler.number(round) {
        text.push_str(&format!(" at its lower edge and {} along the rim", ruler.number(along)));
    }
    drawing.text(at + DVec2::new(0.0, TEXT), TEXT, Anchor::Start, &text);
    let mut top = at + DVec2::new(RULER, LINE + 2.0);
    if fits {
        let height = hem.iter().map(|p| frame.height(*p)).sum::<f64>() / hem.len() as f64;
        let text = format!("Lay the strip round the pot with its lower edge {} above the foot", ruler.number(height));
        // A line of its own: both together are wider than paper.
        drawing.text(at + DVec2::new(0.0, LINE + TEXT), TEXT, Anchor::Start, &text);
        top.y += LINE;
    }
    let (low, mut high) = extent(upper.iter().chain(&lower).copied());
    let n = rim.len();
    let quarters = [0, 1, 2, 3, 4].map(|quarter| (quarter, n * quarter / 4));
    // A strip that goes nearly round has some of its fractions above it.
    for (_, i) in quarters {
        high.y = high.y.max((lower[i] + WRITTEN * (lower[i] - upper[i]).normalize_or(-DVec2::Y)).y + TEXT);
    }
    let place = |p: DVec2| DVec2::new(top.x + p.x - low.x, top.y + high.y - p.y);
    let (left, right) = (place(DVec2::new(low.x, high.y)), place(DVec2::new(high.x, low.y)));
    drawing.grid(ruler, DVec2::new(left.x, right.y), left, right);
    let outline: Vec<DVec2> = upper.iter().chain(lower.iter().rev()).map(|p| place(*p)).collect();
    drawing.closed_line(&format!("strip-{}", index + 1), &outline);
    for (quarter, i) in quarters {
        let edge = place(lower[i]);
        let down = (edge - place(upper[i])).normalize_or(DVec2::Y);
        drawing.line(Pen::Mark, edge, edge + 2.5 * down);
        // On a small strip every other one has room, or the first alone.
        let every = [1u8, 2, 4].into_iter().find(|every| round * f64::from(*every) >= 4.0 * FRACTION).unwrap_or(5);
        if quarter % usize::from(every) == 0 {
            let text = edge + WRITTEN * down + DVec2::new(0.0, 1.0);
            drawing.text(text, TEXT, Anchor::Middle, ["0", "1/4", "1/2", "3/4", "1"][quarter]);
        }
    }
    DVec2::new(RULER + high.x - low.x + 6.0, right.y + 8.0 - at.y)
}
