//! A template at true scale as SVG: the sections of each part with their heights, the rim from above and unrolled; on one page as large as that, or on sheets of paper.

mod drawing;
mod frame;
mod layout;
mod letters;
mod levels;
mod page;
mod paper;
mod ruler;
mod section;
mod sheet;
mod stand;
mod strip;

use glam::DVec2;

use self::drawing::{Anchor, Drawing, Pen};
pub(super) use self::frame::Frame;
use self::layout::{GAP, LINE, MARGIN, TEXT, TITLE, points};
use self::page::whole;
pub(super) use self::paper::Paper;
use self::ruler::Ruler;
use self::sheet::sheet;
pub(super) use self::stand::Stand;
use super::contents::{Body, Notes, PROGRAM};
use super::numbers::{rounded, short};
use crate::error::Result;

/// The largest distance of anything that a template shows from where its part stands, in millimetres: beyond ten metres nobody prints at true scale, and the lines of the grid alone would be a large file.
pub(super) const LARGEST: f64 = 10_000.0;

/// How far what is shown of a part reaches from where it stands; of a rim that is longer than a circle so large, the radius of a circle as long.
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

/// How large the pot is on paper, in words, and for how much shrinkage: whoever finds the sheet is not to allow for that once more.
fn scale(notes: &Notes, ruler: &Ruler) -> String {
    let factor = rounded(notes.millimetres / ruler.unit, 4);
    let large = match factor.as_str() {
        "1" => "As large as designed".to_owned(),
        // So small that four places say nothing.
        "0" => format!("{} times as large as designed", short(notes.millimetres / ruler.unit)),
        _ => format!("{factor} times as large as designed"),
    };
    let shrinkage = notes.making.shrinkage;
    if shrinkage > 0.0 { format!("{large}, which allows for {} % shrinkage", short(shrinkage)) } else { large }
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
