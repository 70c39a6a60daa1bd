//! The marks of a drawing, in millimetres from its upper left corner.

use glam::DVec2;

use crate::export::numbers::push_decimal;
use crate::export::xml::escaped;

/// Decimal places of a coordinate: a micrometre.
const PLACES: usize = 3;
const POWER: f64 = 1e3;
/// The mean width of letters, of their size.
const LETTER: f64 = 0.55;

/// A drawing that grows; the text of an SVG without its frame.
#[derive(Default)]
pub(super) struct Drawing {
    text: String,
    right: f64,
}

/// How a line is drawn.
#[derive(Clone, Copy)]
pub(super) enum Pen {
    /// The edge of the clay.
    Outline,
    /// A ruler, a mark, a leader.
    Mark,
    /// Lines of the grid, every fifth darker.
    Grid { is_fifth: bool },
    /// Dashes and dots.
    Axis,
}

impl Pen {
    fn attributes(self) -> &'static str {
        match self {
            Pen::Outline => r##"stroke="#000" stroke-width="0.25" stroke-linejoin="round""##,
            Pen::Mark => r##"stroke="#000" stroke-width="0.15""##,
            Pen::Grid { is_fifth: false } => r##"stroke="#d5dde4" stroke-width="0.1""##,
            Pen::Grid { is_fifth: true } => r##"stroke="#a3b3c0" stroke-width="0.15""##,
            Pen::Axis => r##"stroke="#000" stroke-width="0.15" stroke-dasharray="6 1.5 1 1.5""##,
        }
    }
}

/// Where a text is put with respect to its place.
#[derive(Clone, Copy)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

impl Drawing {
    pub(super) fn line(&mut self, pen: Pen, from: DVec2, to: DVec2) {
        let [x1, y1, x2, y2] = [from.x, from.y, to.x, to.y].map(number);
        self.text.push_str(&format!("<line x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\" {}/>\n", pen.attributes()));
    }

    /// A line through points.
    pub(super) fn open_line(&mut self, pen: Pen, points: &[DVec2]) {
        let path = path(points);
        self.text.push_str(&format!("<path d=\"{path}\" fill=\"none\" {}/>\n", pen.attributes()));
    }

    /// What closed lines enclose, in a tint; what is enclosed twice is a hole. With a name to find it by.
    pub(super) fn area(&mut self, id: &str, outlines: &[Vec<DVec2>]) {
        let path: String = outlines.iter().map(|outline| path(outline) + "Z").collect();
        self.text.push_str(&format!(
            "<path id=\"{id}\" d=\"{path}\" fill=\"#d9c3a5\" fill-rule=\"evenodd\" {}/>\n",
            Pen::Outline.attributes()
        ));
    }

    /// How far texts that start somewhere reach to the right, roughly: who shows the drawing chooses the letters.
    pub(super) fn right(&self) -> f64 {
        self.right
    }

    pub(super) fn text(&mut self, at: DVec2, size: f64, anchor: Anchor, text: &str) {
        let anchor = match anchor {
            Anchor::Start => {
                self.right = self.right.max(at.x + LETTER * size * text.chars().count() as f64);
                "start"
            }
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        let [x, y, size] = [at.x, at.y, size].map(number);
        self.text.push_str(&format!(
            "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\" text-anchor=\"{anchor}\">{}</text>\n",
            escaped(text)
        ));
    }

    /// Lines every 10 mm between two corners, counted from `origin`.
    pub(super) fn grid(&mut self, origin: DVec2, low: DVec2, high: DVec2) {
        for is_fifth in [false, true] {
            let lines = |origin: f64, low: f64, high: f64| {
                let (first, last) = (libm::ceil((low - origin) / 10.0), libm::floor((high - origin) / 10.0));
                (first as i64..=last as i64)
                    .filter(move |index| (index % 5 == 0) == is_fifth)
                    .map(move |index| origin + 10.0 * index as f64)
            };
            for x in lines(origin.x, low.x, high.x) {
                self.line(Pen::Grid { is_fifth }, DVec2::new(x, low.y), DVec2::new(x, high.y));
            }
            for y in lines(origin.y, low.y, high.y) {
                self.line(Pen::Grid { is_fifth }, DVec2::new(low.x, y), DVec2::new(high.x, y));
            }
        }
    }

    pub(super) fn finish(self) -> String {
        self.text
    }
}

/// `M0 0L1 0L1 1`; points that fall together count once.
fn path(points: &[DVec2]) -> String {
    let mut path = String::new();
    let mut last = String::new();
    for point in points {
        let here = format!("{} {}", number(point.x), number(point.y));
        if here != last {
            path.push(if path.is_empty() { 'M' } else { 'L' });
            path.push_str(&here);
        }
        last = here;
    }
    path
}

/// A length to the micrometre: `12.345`.
pub(super) fn number(x: f64) -> String {
    fixed(x, POWER, PLACES)
}

/// A length as people read it: `12.3`.
pub(super) fn label(x: f64) -> String {
    let text = fixed(x, 10.0, 1);
    if text.contains('.') { text } else { text + ".0" }
}

fn fixed(x: f64, power: f64, places: usize) -> String {
    let whole = libm::round(x.abs() * power) as u64;
    let mut bytes = if x < 0.0 && whole > 0 { vec![b'-'] } else { Vec::new() };
    push_decimal(&mut bytes, whole, places);
    bytes.into_iter().map(char::from).collect()
}
