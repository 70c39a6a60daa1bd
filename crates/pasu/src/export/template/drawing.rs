//! The marks of a drawing, in millimetres from its upper left corner, in layers that can be shown by themselves.

use glam::DVec2;

use super::letters;
use super::ruler::Ruler;
use crate::export::numbers::rounded;
use crate::export::xml::escaped;

/// Decimal places of a coordinate: a micrometre.
const PLACES: usize = 3;

/// A drawing that grows; the text of an SVG without its frame.
#[derive(Default)]
pub(super) struct Drawing {
    layers: [String; 3],
    pieces: Vec<(DVec2, DVec2)>,
    right: f64,
}

/// What is drawn, from the lowest up.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Layer {
    Grid,
    /// The clay, and what is cut out.
    Outline,
    /// Texts, and the marks that they are of.
    Text,
}

impl Layer {
    pub(super) const ALL: [Layer; 3] = [Layer::Grid, Layer::Outline, Layer::Text];

    /// The name by which it is found in the file.
    pub(super) fn id(self) -> &'static str {
        match self {
            Layer::Grid => "grid",
            Layer::Outline => "outline",
            Layer::Text => "text",
        }
    }

    /// The beginning of a group that programs which know layers (Inkscape) show as one.
    pub(super) fn open(self) -> String {
        let label = match self {
            Layer::Grid => "Grid",
            Layer::Outline => "Outline",
            Layer::Text => "Text",
        };
        format!("<g id=\"{}\" inkscape:groupmode=\"layer\" inkscape:label=\"{label}\">\n", self.id())
    }
}

/// How a line is drawn.
#[derive(Clone, Copy)]
pub(super) enum Pen {
    /// The edge of the clay.
    Outline,
    /// The bar by which a print is checked: as an outline, and no clay.
    Bar,
    /// A ruler, a mark, a leader.
    Mark,
    /// Lines of the grid, some darker.
    Grid { is_dark: bool },
    /// Dashes and dots.
    Axis,
}

impl Pen {
    fn layer(self) -> Layer {
        match self {
            Pen::Outline => Layer::Outline,
            Pen::Grid { .. } => Layer::Grid,
            Pen::Bar | Pen::Mark | Pen::Axis => Layer::Text,
        }
    }

    pub(super) fn attributes(self) -> &'static str {
        match self {
            Pen::Outline | Pen::Bar => r##"stroke="#000" stroke-width="0.25" stroke-linejoin="round""##,
            Pen::Mark => r##"stroke="#000" stroke-width="0.15""##,
            Pen::Grid { is_dark: false } => r##"stroke="#d5dde4" stroke-width="0.1""##,
            Pen::Grid { is_dark: true } => r##"stroke="#a3b3c0" stroke-width="0.15""##,
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
        let line = line(pen, from, to);
        self.layer(pen.layer()).push_str(&line);
    }

    /// A line by which something is found.
    pub(super) fn named_line(&mut self, id: &str, pen: Pen, from: DVec2, to: DVec2) {
        let line = line(pen, from, to).replacen("<line ", &format!("<line id=\"{id}\" "), 1);
        self.layer(pen.layer()).push_str(&line);
    }

    /// A line through points.
    pub(super) fn open_line(&mut self, pen: Pen, points: &[DVec2]) {
        let line = format!("<path d=\"{}\" fill=\"none\" {}/>\n", path(points), pen.attributes());
        self.layer(pen.layer()).push_str(&line);
    }

    /// A line through points and back to the first. With a name to find it by.
    pub(super) fn closed_line(&mut self, id: &str, points: &[DVec2]) {
        let pen = Pen::Outline;
        let line = format!("<path id=\"{id}\" d=\"{}Z\" fill=\"none\" {}/>\n", path(points), pen.attributes());
        self.layer(pen.layer()).push_str(&line);
    }

    /// What closed lines enclose, in a tint; what is enclosed twice is a hole. With a name to find it by.
    pub(super) fn area(&mut self, id: &str, outlines: &[Vec<DVec2>]) {
        let path: String = outlines.iter().map(|outline| path(outline) + "Z").collect();
        let area = format!(
            "<path id=\"{id}\" d=\"{path}\" fill=\"#d9c3a5\" fill-rule=\"evenodd\" {}/>\n",
            Pen::Outline.attributes()
        );
        self.layer(Layer::Outline).push_str(&area);
    }

    /// How far texts that start somewhere reach to the right, roughly.
    pub(super) fn right(&self) -> f64 {
        self.right
    }

    pub(super) fn text(&mut self, at: DVec2, size: f64, anchor: Anchor, text: &str) {
        if let Anchor::Start = anchor {
            let right = at.x + letters::width(text, size);
            self.right = self.right.max(right);
            // A long name, too, is on some sheet to its end.
            self.cover(at - DVec2::new(0.0, size), DVec2::new(right, at.y));
        }
        let text = written(at, size, anchor, text);
        self.layer(Layer::Text).push_str(&text);
    }

    /// Lines of a grid between two corners, counted from `origin`.
    pub(super) fn grid(&mut self, ruler: &Ruler, origin: DVec2, low: DVec2, high: DVec2) {
        let Ruler { grid, dark, .. } = *ruler;
        for is_dark in [false, true] {
            let lines = |origin: f64, low: f64, high: f64| {
                let (first, last) = (libm::ceil((low - origin) / grid), libm::floor((high - origin) / grid));
                (first as i64..=last as i64)
                    .filter(move |index| (index % dark == 0) == is_dark)
                    .map(move |index| origin + grid * index as f64)
            };
            for x in lines(origin.x, low.x, high.x) {
                self.line(Pen::Grid { is_dark }, DVec2::new(x, low.y), DVec2::new(x, high.y));
            }
            for y in lines(origin.y, low.y, high.y) {
                self.line(Pen::Grid { is_dark }, DVec2::new(low.x, y), DVec2::new(high.x, y));
            }
        }
    }

    /// Says that there is something between two corners.
    pub(super) fn cover(&mut self, low: DVec2, high: DVec2) {
        self.pieces.push((low, high));
    }

    /// The corners between which there is something.
    pub(super) fn pieces(&self) -> &[(DVec2, DVec2)] {
        &self.pieces
    }

    /// What is drawn in a layer.
    pub(super) fn drawn(&self, layer: Layer) -> &str {
        &self.layers[layer as usize]
    }

    fn layer(&mut self, layer: Layer) -> &mut String {
        &mut self.layers[layer as usize]
    }
}

/// A text by itself.
pub(super) fn written(at: DVec2, size: f64, anchor: Anchor, text: &str) -> String {
    let anchor = match anchor {
        Anchor::Start => "start",
        Anchor::Middle => "middle",
        Anchor::End => "end",
    };
    let [x, y, size] = [at.x, at.y, size].map(number);
    format!("<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\" text-anchor=\"{anchor}\">{}</text>\n", escaped(text))
}

/// A straight line by itself.
pub(super) fn line(pen: Pen, from: DVec2, to: DVec2) -> String {
    let [x1, y1, x2, y2] = [from.x, from.y, to.x, to.y].map(number);
    format!("<line x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\" {}/>\n", pen.attributes())
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
    rounded(x, PLACES)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_is_something_as_far_as_a_text_reaches() {
        let mut drawing = Drawing::default();
        drawing.text(DVec2::new(12.0, 20.0), 3.0, Anchor::Start, &"m".repeat(200));
        let [(low, high)] = drawing.pieces() else { panic!("one piece") };
        assert!(
            low.x <= 12.0 && low.y <= 17.0 && high.x >= 12.0 + 300.0 && high.x == drawing.right() && high.y >= 20.0
        );
    }
}
