//! What the checks found, for a page, a file and a program.

use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};

use super::remedy::Remedy;
use crate::answer::answers;
#[cfg(feature = "typescript")]
use crate::answer::{Answer, Field, declare};
use crate::design::to_json;
use crate::error::Args;
use crate::solid::Product;

/// How much a finding matters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
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

answers! {
    /// One thing that a check found.
    pub struct Finding as "Finding" {
        /// A stable kebab-case word: `fitted-foot` and `fitted-drain` where a ring or a drain is not the one that was asked for, `thinned`, `too-thin`, `thin-base`, `overhang`, `ceiling`, `overlap`, `same-place`, `folded` and `few-terms` of the inside of a blend, `tolerance-too-fine` where the mesh does not keep the tolerance that was asked for, or the code of the error that refuses the part.
        pub code: &'static str,
        /// How much it matters.
        pub severity: Severity,
        /// The part that it is about.
        pub part: usize,
        /// What of the design it is about, such as `parts[0].wall.foot`, or `tolerance` of the making; `None` where that is no single field.
        pub path: Option<String>,
        /// One sentence in a potter's words.
        pub message: String,
        /// What the sentence names, as [`Error::args`](crate::Error::args) has it: with the code it takes no more to say it in another language. Lengths are in the unit of the design; those whose names end in `Mm` are in millimetres of what is made, angles in degrees.
        pub args: Args,
        /// Where, in model units after placement.
        pub at: Option<[f64; 3]>,
        /// Of a part that is refused the nearest change of the wall that was found to help, and of a ring or drain that was fitted the wall that is made; `None` where there is none.
        pub remedy: Option<Remedy>,
    }

    /// What the checks counted on the mesh of one part, on the coordinates that a file holds.
    #[derive(Copy)]
    pub struct MeshReport as "MeshReport" {
        /// The part.
        pub part: usize,
        /// Number of vertices.
        pub vertices: usize,
        /// Number of triangles.
        pub triangles: usize,
        /// Whether every edge is shared by two triangles that pass it in opposite directions, and the triangles at each vertex are one fan.
        pub closed: bool,
        /// Number of handles: 0 for a cup, 1 for a tube or a pot with a drain. It is `None` where the mesh is not closed.
        pub genus: Option<usize>,
        /// Number of triangles without area.
        pub degenerate: usize,
        /// Number of pairs of triangles that cross or touch where they should not.
        pub crossings: usize,
        /// The largest distance between the triangles and the true faces, in model units: a bound for the surface of the design, an estimate for the other faces.
        pub bound: f64,
        /// The share of the wall that is thinner than asked for, from 0 to 1.
        pub thinned: f64,
        /// The thinnest the wall is, in model units; `None` for a solid.
        pub thinnest: Option<f64>,
    }

    /// What the checks counted on the one solid that the parts of an object are, where they were to be joined (`Making::union`).
    pub struct UnionReport as "UnionReport" {
        /// The parts that it is of, in the order in which a file has them.
        pub parts: Vec<usize>,
        /// Number of vertices.
        pub vertices: usize,
        /// Number of triangles. In a file with colours, a part whose glaze ends at a line has a few more.
        pub triangles: usize,
        /// How many bodies it is: more than 1 where parts do not touch.
        pub bodies: usize,
        /// Number of handles of all its bodies.
        pub genus: usize,
        /// The largest distance between its triangles and the true faces of its parts, in model units: the largest `bound` of these, and how far they are moved where their surfaces cannot be told apart otherwise.
        pub bound: f64,
    }
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
    /// One entry per object whose parts were to be joined and could be.
    pub unions: Vec<UnionReport>,
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

    /// The number of triangles of all parts, each for itself.
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

    /// `{ ok, product, triangles, vertices, findings, meshes, unions }`, on one line. What there is not is null.
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
}

/// As [`Report::to_json`].
impl Serialize for Report {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut report = serializer.serialize_struct("Report", 7)?;
        report.serialize_field("ok", &self.is_ok())?;
        report.serialize_field("product", &self.product)?;
        report.serialize_field("triangles", &self.triangles())?;
        report.serialize_field("vertices", &self.vertices())?;
        report.serialize_field("findings", &self.findings)?;
        report.serialize_field("meshes", &self.meshes)?;
        report.serialize_field("unions", &self.unions)?;
        report.end()
    }
}

#[cfg(feature = "typescript")]
crate::answer::known_as!(Severity, r#""error" | "warning" | "note""#);

#[cfg(feature = "typescript")]
impl Answer for Report {
    fn type_name() -> String {
        "Report".to_owned()
    }

    fn declare(text: &mut String) {
        let field = |name, about, type_name| Field { name, about, type_name, is_flat: false };
        let fields = [
            field("ok", &["Whether nothing was found that keeps the design from being made."][..], bool::type_name()),
            field("product", &["What was to be made."], Product::type_name()),
            field("triangles", &["The number of triangles of all parts."], usize::type_name()),
            field("vertices", &["The number of vertices of all parts."], usize::type_name()),
            field("findings", &["What was found, errors first."], Vec::<Finding>::type_name()),
            field("meshes", &["One entry per part that could be meshed."], Vec::<MeshReport>::type_name()),
            field(
                "unions",
                &["One entry per object whose parts were to be joined and could be."],
                Vec::<UnionReport>::type_name(),
            ),
        ];
        declare(text, "Report", &["The verdict on a design: can it be made, and what was found."], &fields);
    }
}
