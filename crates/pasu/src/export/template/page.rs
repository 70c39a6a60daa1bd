//! The frame of a template: what the file says of itself, and its layers.

use glam::DVec2;

use super::drawing::{Drawing, Layer, number};
use crate::export::contents::Notes;
use crate::export::xml::escaped;

/// One page as large as the drawing.
pub(super) fn whole(notes: &Notes, drawing: &Drawing, size: DVec2) -> Vec<u8> {
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
pub(super) fn head(notes: &Notes, size: DVec2) -> String {
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
