//! What every file says of itself, and the bodies that it holds.

use std::borrow::Cow;

use super::coats::{Coat, looks, numbered};
use super::numbers::short;
use super::provenance::told;
use crate::design::{Look, Unit};
use crate::face::FaceKind;
use crate::make::Making;
use crate::watch;

/// The program that writes, with its version.
pub(super) const PROGRAM: &str = concat!("Pasu ", env!("CARGO_PKG_VERSION"));

/// One part, closed, in the very numbers of the file.
pub(super) struct Body<'a> {
    /// The name of the part, or `part 1`.
    pub(super) name: String,
    /// Clay and glaze.
    pub(super) look: Look,
    /// `x, y, z` per vertex in millimetres, one vertex per point.
    pub(super) positions: Cow<'a, [f32]>,
    /// Three vertex numbers per triangle, counter-clockwise from outside.
    pub(super) indices: Cow<'a, [u32]>,
    /// The faces in order: kind, first index, number of indices.
    pub(super) faces: Vec<(FaceKind, usize, usize)>,
    /// What each triangle is covered with, where not all are as the outside is.
    pub(super) coats: Vec<Coat>,
    /// How each triangle looks, where it was put together of several bodies; nothing else says it then.
    pub(super) plain: Vec<Look>,
}

impl Body<'_> {
    /// The looks of its triangles, each the same everywhere, the first of all that of the first triangle.
    pub(super) fn looks(&self) -> Vec<Look> {
        self.numbered().0
    }

    /// Which of [`Body::looks`] each triangle has.
    pub(super) fn look_of(&self) -> impl Fn(usize) -> usize {
        let numbers = self.numbered().1;
        move |triangle| numbers.get(triangle).copied().unwrap_or(0)
    }

    fn numbered(&self) -> (Vec<Look>, Vec<usize>) {
        if self.plain.is_empty() { looks(self.look, &self.coats) } else { numbered(self.plain.iter().copied()) }
    }

    /// The number of triangles.
    pub(super) fn n_triangles(&self) -> usize {
        self.indices.len() / 3
    }

    /// The vertices of every triangle.
    pub(super) fn triangles(&self) -> impl Iterator<Item = [u32; 3]> {
        self.indices.chunks_exact(3).map(|t| {
            watch::work(10);
            [t[0], t[1], t[2]]
        })
    }

    /// The position of a vertex.
    pub(super) fn position(&self, vertex: u32) -> [f32; 3] {
        let at = 3 * vertex as usize;
        [self.positions[at], self.positions[at + 1], self.positions[at + 2]]
    }
}

/// What a file says of itself.
pub(super) struct Notes {
    /// The title of the design; never empty.
    pub(super) title: String,
    /// The link, without `#`: ASCII without white space, quotes and brackets.
    pub(super) link: String,
    /// The fingerprint of the design.
    pub(super) fingerprint: String,
    /// The verdict of the checks, ASCII.
    pub(super) verdict: String,
    /// How many millimetres a unit of the design is in the file.
    pub(super) millimetres: f64,
    /// What was made of the design and how large.
    pub(super) making: Making,
    /// The unit of the design.
    pub(super) unit: Unit,
}

impl Notes {
    /// All but the title, as name and text; every text is ASCII without quotes and brackets.
    pub(super) fn list(&self) -> Vec<(&'static str, String)> {
        let mut list = vec![
            ("link", self.link.clone()),
            ("fingerprint", self.fingerprint.clone()),
            ("version", PROGRAM.to_owned()),
            ("checks", self.verdict.clone()),
            ("scale", format!("1 {} of the design is {} mm here", self.unit.name(), short(self.millimetres))),
        ];
        list.extend(told(&self.making, self.unit));
        list
    }

    /// The same as short lines `pasu-link: 1/bloor-wilson?a=6` for the comments of formats whose readers have short memories: a long text goes on
    /// in further lines of the same name. Titles are escaped as in JSON where they are not ASCII.
    pub(super) fn lines(&self) -> Vec<String> {
        let title = ascii(&self.title);
        let mut lines = Vec::new();
        for (name, text) in [("title", title)].into_iter().chain(self.list()) {
            let mut rest = text.as_str();
            loop {
                let (line, after) = rest.split_at(rest.len().min(LINE));
                lines.push(line_of(name) + line);
                rest = after;
                if rest.is_empty() {
                    break;
                }
            }
        }
        lines
    }
}

/// The longest text of a line: some readers of PLY hold 256 characters.
const LINE: usize = 200;

/// What begins a line that holds what is called so, or a piece of it.
pub(super) fn line_of(name: &str) -> String {
    format!("pasu-{name}: ")
}

/// Printable ASCII, everything else as `\u{e9}`.
fn ascii(text: &str) -> String {
    let mut into = String::new();
    for c in text.chars() {
        match c {
            ' '..='~' => into.push(c),
            _ => into.push_str(&format!("\\u{{{:x}}}", u32::from(c))),
        }
    }
    into
}
