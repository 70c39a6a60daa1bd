//! What the checks found, for a page, a file and a program.

use serde::{Serialize, Serializer};

use crate::design::{Value, to_json};
use crate::solid::Product;

/// How much a finding matters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Severity {
    /// It cannot be made.
    Error,
    /// It can be made, but differs from what was asked for.
    Warning,
    /// Worth knowing.
    Note,
}

impl Severity {
    /// The word by which it is known: `error`, `warning` or `note`.
    ///
    /// ```
    /// assert_eq!(pasu::Severity::Warning.name(), "warning");
    /// ```
    pub fn name(self) -> &'static str {
        match self {
            Severity::Error => "error",
            Severity::Warning => "warning",
            Severity::Note => "note",
        }
    }
}

/// One thing that a check found.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Finding {
    /// A stable kebab-case word: `thinned`, `tolerance-too-fine` where the mesh does not keep the tolerance that was asked for, or the code of the [`Error`](crate::Error) that refuses the part.
    pub code: &'static str,
    /// How much it matters.
    pub severity: Severity,
    /// The part that it is about.
    pub part: usize,
    /// One sentence in a potter's words.
    pub message: String,
    /// Where, in model units after placement.
    pub at: Option<[f64; 3]>,
}

/// What the checks counted on the mesh of one part, on the coordinates that a file holds.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct MeshReport {
    /// The part.
    pub part: usize,
    /// Number of vertices.
    pub vertices: usize,
    /// Number of triangles.
    pub triangles: usize,
    /// Whether every edge is shared by two triangles that pass it in opposite directions, and the triangles at each vertex are one fan.
    pub closed: bool,
    /// Number of handles: 0 for a cup, 1 for a tube or a pot with a drain. `None` where the mesh is not closed.
    pub genus: Option<usize>,
    /// Number of triangles without area.
    pub degenerate: usize,
    /// Number of pairs of triangles that cross or touch where they should not.
    pub crossings: usize,
    /// The largest distance between the triangles and the true faces, in model units: an estimate, as [`SolidMesh::bound`](crate::SolidMesh).
    pub bound: f64,
    /// The share of the wall that is thinner than asked for, from 0 to 1.
    pub thinned: f64,
    /// The thinnest the wall is, in model units; `None` for a solid.
    pub thinnest: Option<f64>,
}

/// The verdict on a design: can it be made, and what was found.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Report {
    /// What was to be made.
    pub product: Product,
    /// What was found, errors first.
    pub findings: Vec<Finding>,
    /// One entry per part that could be meshed.
    pub meshes: Vec<MeshReport>,
}

impl Report {
    /// Whether nothing was found that keeps the design from being made.
    ///
    /// ```
    /// // A cylinder of radius 3 and height 4, with a wall of 0.5 and a base of 1.
    /// # let cup = pasu::Design::parse(
    /// #     r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 },
    /// #     "wall": { "thickness": 0.5, "base": 1 } }] }"#,
    /// # )?;
    /// let report = pasu::check(&cup, &pasu::Making::default())?;
    /// assert!(report.is_ok());
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn is_ok(&self) -> bool {
        self.findings.iter().all(|finding| finding.severity != Severity::Error)
    }

    /// The number of triangles of all parts.
    ///
    /// ```
    /// // A cylinder of radius 3 and height 4, with a wall of 0.5 and a base of 1.
    /// # let cup = pasu::Design::parse(
    /// #     r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 },
    /// #     "wall": { "thickness": 0.5, "base": 1 } }] }"#,
    /// # )?;
    /// let report = pasu::check(&cup, &pasu::Making::default())?;
    /// assert_eq!(report.triangles(), report.meshes[0].triangles);
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn triangles(&self) -> usize {
        self.meshes.iter().map(|mesh| mesh.triangles).sum()
    }

    /// The number of vertices of all parts.
    ///
    /// ```
    /// // A cylinder of radius 3 and height 4, with a wall of 0.5 and a base of 1.
    /// # let cup = pasu::Design::parse(
    /// #     r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 },
    /// #     "wall": { "thickness": 0.5, "base": 1 } }] }"#,
    /// # )?;
    /// let report = pasu::check(&cup, &pasu::Making::default())?;
    /// // A cup has no handle: V - E + F = 2, and E = 3 F / 2.
    /// assert_eq!(2 * report.vertices() - report.triangles(), 4);
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn vertices(&self) -> usize {
        self.meshes.iter().map(|mesh| mesh.vertices).sum()
    }

    /// `{ ok, product, triangles, vertices, findings: [{ code, severity, part, message, at? }], meshes: [{ part, vertices, triangles, closed, genus?, degenerate, crossings,
    /// bound, thinned, thinnest? }] }`, on one line.
    ///
    /// ```
    /// // A cylinder of radius 3 and height 4, with a wall of 0.5 and a base of 1.
    /// # let cup = pasu::Design::parse(
    /// #     r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 },
    /// #     "wall": { "thickness": 0.5, "base": 1 } }] }"#,
    /// # )?;
    /// let report = pasu::check(&cup, &pasu::Making::default())?;
    /// assert!(report.to_json().starts_with(r#"{"ok":true,"product":"pot","#));
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn to_json(&self) -> String {
        to_json(self)
    }

    fn value(&self) -> Value {
        Value::Record(vec![
            entry("ok", Value::Bool(self.is_ok())),
            entry("product", text(self.product.name())),
            entry("triangles", count(self.triangles())),
            entry("vertices", count(self.vertices())),
            entry("findings", Value::List(self.findings.iter().map(Finding::value).collect())),
            entry("meshes", Value::List(self.meshes.iter().map(MeshReport::value).collect())),
        ])
    }
}

/// As [`Report::to_json`].
impl Serialize for Report {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.value().serialize(serializer)
    }
}

impl Finding {
    fn value(&self) -> Value {
        let mut fields = vec![
            entry("code", text(self.code)),
            entry("severity", text(self.severity.name())),
            entry("part", count(self.part)),
            entry("message", text(&self.message)),
        ];
        if let Some(at) = self.at {
            fields.push(entry("at", Value::List(at.map(Value::Number).to_vec())));
        }
        Value::Record(fields)
    }
}

impl MeshReport {
    fn value(&self) -> Value {
        let mut fields = vec![
            entry("part", count(self.part)),
            entry("vertices", count(self.vertices)),
            entry("triangles", count(self.triangles)),
            entry("closed", Value::Bool(self.closed)),
        ];
        fields.extend(self.genus.map(|genus| entry("genus", count(genus))));
        fields.extend([
            entry("degenerate", count(self.degenerate)),
            entry("crossings", count(self.crossings)),
            entry("bound", Value::Number(self.bound)),
            entry("thinned", Value::Number(self.thinned)),
        ]);
        fields.extend(self.thinnest.map(|thinnest| entry("thinnest", Value::Number(thinnest))));
        Value::Record(fields)
    }
}

fn entry(name: &str, value: Value) -> (String, Value) {
    (name.to_owned(), value)
}

fn text(text: &str) -> Value {
    Value::Text(text.to_owned())
}

fn count(count: usize) -> Value {
    Value::Number(count as f64)
}
