//! A template on sheets of paper that every printer has: cut into pieces that overlap, with marks by which they are put together.

use std::collections::BTreeSet;

use glam::DVec2;

use super::drawing::{Anchor, Drawing, Layer, Pen, line, number, written};
use super::layout::TEXT;
use super::letters;
use super::page::head;
use crate::error::{Code, Error, Result};
use crate::export::contents::Notes;

/// What no printer can print on, round a sheet, millimetres.
const BORDER: f64 = 10.0;
/// By how much neighbouring pieces overlap.
const OVERLAP: f64 = 10.0;
/// How far a mark reaches from its middle, and the radius of its circle.
const MARK: f64 = 4.0;
const CIRCLE: f64 = 1.5;
/// Nobody puts together more sheets; they bound the file, too.
const MOST_SHEETS: usize = 200;
/// Letters of a title on a sheet, of which wide ones count twice.
const LETTERS: usize = 48;
/// Browsers put the sheets of one drawing on pages of a whole number of pixels, of which an inch has 96.
const PIXEL: f64 = 25.4 / 96.0;

/// A size of paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::export) enum Paper {
    /// 210 by 297 mm.
    A4,
    /// 8.5 by 11 inches.
    Letter,
}

impl Paper {
    fn name(self) -> &'static str {
        match self {
            Paper::A4 => "A4",
            Paper::Letter => "letter",
        }
    }

    /// Millimetres.
    fn size(self) -> DVec2 {
        match self {
            Paper::A4 => DVec2::new(210.0, 297.0),
            Paper::Letter => DVec2::new(215.9, 279.4),
        }
    }

    /// How much of a drawing a sheet shows.
    fn frame(self) -> DVec2 {
        self.size() - DVec2::splat(2.0 * BORDER)
    }

    /// From a piece to the next.
    fn step(self) -> DVec2 {
        self.frame() - DVec2::splat(OVERLAP)
    }

    /// From a sheet to the next below it.
    fn pitch(self) -> f64 {
        libm::ceil(self.size().y / PIXEL - 1e-6) * PIXEL
    }

    /// The rows and columns of the pieces on which there is something, row by row.
    fn pieces(self, drawing: &Drawing) -> Result<BTreeSet<(u32, u32)>> {
        let step = self.step();
        let mut pieces = BTreeSet::new();
        for (low, high) in drawing.pieces() {
            let first = (*low / step).floor().max(DVec2::ZERO);
            // What is within the overlap is on the piece before.
            let last = (((*high - DVec2::splat(OVERLAP)) / step).ceil() - DVec2::ONE).max(first);
            for row in first.y as u32..=last.y as u32 {
                for column in first.x as u32..=last.x as u32 {
                    pieces.insert((row, column));
                    if pieces.len() > MOST_SHEETS {
                        let message = format!(
                            "a template is drawn at true scale: expected one on at most {MOST_SHEETS} sheets of {} paper, found more",
                            self.name()
                        );
                        return Err(Error::new(Code::TooLarge, "format", message).with("greatest", MOST_SHEETS));
                    }
                }
            }
        }
        Ok(pieces)
    }

    /// The sheets one below the other, each of them a page for programs that know pages (Inkscape, and browsers when they print).
    ///
    /// # Errors
    /// `too-large` for more than 200 sheets.
    pub(super) fn sheets(self, notes: &Notes, drawing: &Drawing) -> Result<Vec<u8>> {
        let pieces = self.pieces(drawing)?;
        let (size, frame, step) = (self.size(), self.frame(), self.step());
        let top = |sheet: usize| self.pitch() * sheet as f64;
        let mut text = head(notes, DVec2::new(size.x, top(pieces.len())));
        let [width, height] = size.to_array().map(number);
        text.push_str(&format!("<style>@page{{size:{width}mm {height}mm;margin:0}}</style>\n<sodipodi:namedview>\n"));
        for (sheet, (row, column)) in pieces.iter().enumerate() {
            text.push_str(&format!(
                "<inkscape:page x=\"0\" y=\"{}\" width=\"{width}\" height=\"{height}\" id=\"sheet-{}\" inkscape:label=\"{}\"/>\n",
                number(top(sheet)),
                sheet + 1,
                place(*row, *column)
            ));
        }
        text.push_str("</sodipodi:namedview>\n<defs>\n");
        for layer in Layer::ALL {
            text.push_str(&format!("<g id=\"whole-{}\">\n{}</g>\n", layer.id(), drawing.drawn(layer)));
        }
        let [frame_width, frame_height] = frame.to_array().map(number);
        text.push_str(&format!(
            "<clipPath id=\"frame\"><rect width=\"{frame_width}\" height=\"{frame_height}\"/></clipPath>\n<g id=\"marks\">\n<rect width=\"{frame_width}\" height=\"{frame_height}\" fill=\"none\" {}/>\n{}</g>\n</defs>\n",
            Pen::Mark.attributes(),
            marks(frame)
        ));
        for layer in Layer::ALL {
            text.push_str(&layer.open());
            for (sheet, (row, column)) in pieces.iter().enumerate() {
                let from = -step * DVec2::new(f64::from(*column), f64::from(*row));
                let [x, y] = from.to_array().map(number);
                text.push_str(&format!(
                    "<g transform=\"translate({} {})\">\n<g clip-path=\"url(#frame)\"><use href=\"#whole-{}\" x=\"{x}\" y=\"{y}\"/></g>\n",
                    number(BORDER),
                    number(top(sheet) + BORDER),
                    layer.id()
                ));
                if layer == Layer::Text {
                    text.push_str("<use href=\"#marks\"/>\n");
                    // Last: where letters are wider than most, the end of it may be beyond the paper, and nothing else.
                    let title = letters::beginning(&notes.title, LETTERS);
                    let told = format!(
                        "Sheet {} of {}, {}; lay cross on cross: {title}",
                        sheet + 1,
                        pieces.len(),
                        place(*row, *column)
                    );
                    // Between the frame and what is not printed.
                    text.push_str(&written(DVec2::new(0.0, frame.y + TEXT + 0.5), TEXT, Anchor::Start, &told));
                }
                text.push_str("</g>\n");
            }
            text.push_str("</g>\n");
        }
        text.push_str("</svg>\n");
        Ok(text.into_bytes())
    }
}

/// Where a piece belongs.
fn place(row: u32, column: u32) -> String {
    format!("row {}, column {}", row + 1, column + 1)
}

/// Crosses in circles in the middle of the overlaps, so that those of neighbours fall on one another.
fn marks(frame: DVec2) -> String {
    let mut marks = String::new();
    let middle = 0.5 * OVERLAP;
    for y in [middle, frame.y - middle] {
        for x in [middle, frame.x - middle] {
            let at = DVec2::new(x, y);
            for arm in [DVec2::new(MARK, 0.0), DVec2::new(0.0, MARK)] {
                marks.push_str(&line(Pen::Mark, at - arm, at + arm));
            }
            marks.push_str(&format!(
                "<circle cx=\"{}\" cy=\"{}\" r=\"{CIRCLE}\" fill=\"none\" {}/>\n",
                number(x),
                number(y),
                Pen::Mark.attributes()
            ));
        }
    }
    marks
}

#[cfg(test)]
mod tests {
    use super::*;

    fn covered(pieces: &[(f64, f64, f64, f64)]) -> Drawing {
        let mut drawing = Drawing::default();
        for (x, y, right, lower) in pieces {
            drawing.cover(DVec2::new(*x, *y), DVec2::new(*right, *lower));
        }
        drawing
    }

    #[test]
    fn everything_is_on_a_sheet_and_no_sheet_is_empty() {
        for paper in [Paper::A4, Paper::Letter] {
            let (frame, step) = (paper.frame(), paper.step());
            let cases = [
                (vec![(12.0, 12.0, frame.x, frame.y)], vec![(0, 0)]),
                (vec![(12.0, 12.0, frame.x + 0.1, frame.y)], vec![(0, 0), (0, 1)]),
                (
                    vec![(12.0, 12.0, 50.0, 50.0), (12.0, 2.0 * step.y + 20.0, 2.0 * step.x, 2.0 * step.y + 30.0)],
                    vec![(0, 0), (2, 0), (2, 1)],
                ),
            ];
            for (pieces, expected) in cases {
                let found: Vec<(u32, u32)> = paper.pieces(&covered(&pieces)).unwrap().into_iter().collect();
                assert_eq!(found, expected, "{paper:?}");
                for (x, y, right, lower) in pieces {
                    for corner in [(x, y), (right, y), (x, lower), (right, lower)] {
                        let is_shown = |(row, column): &(u32, u32)| {
                            let from = step * DVec2::new(f64::from(*column), f64::from(*row));
                            let at = DVec2::new(corner.0, corner.1) - from;
                            at.min_element() >= 0.0 && at.x <= frame.x && at.y <= frame.y
                        };
                        assert!(found.iter().any(is_shown), "{paper:?} {corner:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn more_sheets_than_anybody_wants_are_refused() {
        let wide = covered(&[(0.0, 0.0, 60_000.0, 20_000.0)]);
        assert_eq!(Paper::A4.pieces(&wide).unwrap_err().code(), Code::TooLarge);
    }

    #[test]
    fn marks_of_neighbours_fall_on_one_another() {
        for paper in [Paper::A4, Paper::Letter] {
            let middle = 0.5 * OVERLAP;
            let last = paper.frame() - DVec2::splat(middle);
            assert!((last - (paper.step() + DVec2::splat(middle))).length() < 1e-9);
        }
    }
}
