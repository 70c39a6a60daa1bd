//! From a design to the bytes of a file.

use std::sync::Arc;

use glam::DVec3;

use super::coats::{Coated, Covering, coated, uncoated};
use super::contents::{Body, Notes};
#[cfg(feature = "patchwork")]
use super::joined::joined;
use super::template::{Frame, Paper, Stand};
use super::{Format, glb, obj, ply, step, stl, template, three_mf};
use crate::design::{Design, plain};
use crate::error::{Code, Error, Result};
use crate::face::Face;
#[cfg(feature = "patchwork")]
use crate::join::Unions;
use crate::make::{Finished, Making, Report, Severity, Size, make, verdict};
use crate::solid::Pot;
use crate::solution::{Placed, Solution};
use crate::watch;
use crate::weave::SolidMesh;

/// STEP surfaces keep this part of the size of each part as their tolerance, or the tolerance asked for if that is less: a micrometre on a pot of 10 cm.
const STEP_TOLERANCE: f64 = 1e-5;
/// The share of the time that making takes, as against putting it down in a file.
const MAKING: f64 = 0.7;
/// No file reaches 4 GB: its lengths would not fit.
const MOST_TRIANGLES: usize = 20_000_000;

/// The bytes of a file of what is made of a design: the same for the same design and making, on every machine and every day, in whichever order the parts of the design stand.
///
/// Every file is in millimetres as [`Making::scale`] tells, but GLB, whose unit is the metre, and says what it was made from and how: the link, the [fingerprint](crate::fingerprint()),
/// the version of Pasu, the verdict of the [checks](crate::check()) and the making; an STL file has room for a short link only. [`open`](super::open) finds the link again,
/// [`provenance`](super::provenance()) link and making. `docs/files.md` says which format holds what.
///
/// - The mesh formats hold the very numbers of [`solid`](crate::solid()) that were checked.
/// - STEP holds one closed solid per part, whose faces are cubic B-splines within a hundred-thousandth of its size of the exact faces, or within the tolerance asked for if that is less; how far they are off at most is in its header.
/// - SVG is a template at true scale, on one page or on sheets of paper.
///
/// - With [`Making::union`] the parts of one object are one closed solid, the union of their triangles. It passes the checks that every part passes.
///
/// # Errors
/// As [`solid`](crate::solid()); `crosses-itself` for parts that cannot be joined, and `out-of-range` for a format without triangles in which they are to be; `too-large` beyond 20 million triangles, for a template that reaches further than 10 m, and for one that takes more than 200 sheets. A design with warnings is written all the same; the verdict is in the file.
///
/// ```
/// // A cylinder of radius 3 and height 4, with a wall of 0.5 and a base of 1.
/// # let cup = pasu::Design::parse(
/// #     r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 },
/// #     "wall": { "thickness": 0.5, "base": 1 } }] }"#,
/// # )?;
/// use pasu::{Format, Making, Size};
///
/// let making = Making { size: Some(Size::Height(120.0)), shrinkage: 10.0, ..Making::default() };
/// let bytes = pasu::write(&cup, Format::Stl, &making)?;
/// // 80 bytes of title, a count, 50 bytes for each triangle.
/// assert_eq!((bytes.len() - 84) % 50, 0);
/// # Ok::<(), pasu::Error>(())
/// ```
pub fn write(design: &Design, format: Format, making: &Making) -> Result<Vec<u8>> {
    Solution::of(design).write(format, making)
}

impl Solution {
    /// As [`write()`].
    ///
    /// # Errors
    /// As [`write()`].
    pub fn write(&self, format: Format, making: &Making) -> Result<Vec<u8>> {
        written(self, format, making)
    }
}

fn written(solution: &Solution, format: Format, making: &Making) -> Result<Vec<u8>> {
    let design = solution.design();
    if making.union {
        refuse_union(format)?;
    }
    solution.all_workable()?;
    let millimetres = making.scale_of(solution)?.millimetres;
    let mut made = Vec::with_capacity(solution.n_parts());
    // In the order of links: a file is that of its link, however the parts of the design were ordered.
    let made_of = solution.parts_of(making.product);
    let wanted: Vec<usize> = design.arranged(true).into_iter().filter(|part| made_of.contains(part)).collect();
    for (index, &part) in wanted.iter().enumerate() {
        // A shape without foot and rim has no wall; STEP takes its patches as they are, also where they do not close.
        let solved = solution.part(part)?.solved();
        let is_body = solved.wall().is_some() || solved.is_closed() || solution.has_shell(part, making.product)?;
        if format != Format::Step || is_body {
            let one = || make(solution, part, making, millimetres);
            made.push(watch::between(0.0, MAKING, || watch::share(index, wanted.len(), one))?);
        }
    }
    let n_triangles = made.iter().map(|made| made.mesh.n_triangles()).sum::<usize>();
    if n_triangles > MOST_TRIANGLES {
        let message = format!(
            "expected at most {MOST_TRIANGLES} triangles in a file, found {n_triangles}; a larger tolerance takes fewer"
        );
        let error = Error::new(Code::TooLarge, "tolerance", message).with("greatest", MOST_TRIANGLES);
        return Err(error.with("found", n_triangles));
    }
    let notes = Notes {
        title: design.title().map_or_else(|| format!("Pasu {}", making.product.name()), str::to_owned),
        link: design.link(),
        fingerprint: solution.fingerprint()?,
        verdict: told(&verdict(design, making, millimetres, Vec::new(), &made)),
        millimetres,
        making: *making,
        unit: design.unit(),
    };
    let bodies: Vec<Body> = made.iter().map(|made| coated_body(design, &notes.title, &made.mesh, format)).collect();
    let bodies = if making.union { joined_bodies(solution, &notes, &made, bodies)? } else { bodies };
    match format {
        Format::Stl => Ok(stl::write(&notes, &bodies)),
        Format::ThreeMf => Ok(three_mf::write(&notes, &bodies)),
        Format::Glb => Ok(glb::write(&notes, &bodies)),
        Format::Obj => Ok(obj::write(&notes, &bodies)),
        Format::ObjZip => Ok(obj::package(&notes, &bodies)),
        Format::Ply => Ok(ply::write(&notes, &bodies)),
        Format::Step => {
            let asked = making.tolerance.unwrap_or(f64::INFINITY) * millimetres;
            let mut parts = Vec::with_capacity(solution.n_parts());
            let bodied: Vec<Arc<Placed>> =
                wanted.iter().map(|part| solution.patched(*part, making.product)).collect::<Result<_>>()?;
            for (&part, placed) in wanted.iter().zip(&bodied) {
                let (boundary, size) =
                    match made.iter().map(Arc::as_ref).zip(&bodies).find(|(made, _)| made.mesh.part == part) {
                        Some((Finished { pot: Some(pot), .. }, body)) => {
                            let faces = pot.faces().iter().map(|face| face as &dyn Face);
                            (step::Boundary::Faces(faces.collect()), size(body))
                        }
                        _ => (step::Boundary::Patches(placed), millimetres * extent(placed)),
                    };
                parts.push(step::Part {
                    name: named(design, &notes.title, part),
                    look: design.parts()[part].look,
                    boundary,
                    tolerance: asked.min(STEP_TOLERANCE * size),
                    path: placed.own_path(),
                });
            }
            step::write(&notes, &parts, millimetres)
        }
        Format::Svg => drawing(&notes, &bodies, &made, None),
        Format::SvgA4 => drawing(&notes, &bodies, &made, Some(Paper::A4)),
        Format::SvgLetter => drawing(&notes, &bodies, &made, Some(Paper::Letter)),
    }
}

/// A template of what was made.
fn drawing(notes: &Notes, bodies: &[Body], made: &[Arc<Finished>], paper: Option<Paper>) -> Result<Vec<u8>> {
    let standing = |made: &Arc<Finished>| match &made.pot {
        Some(pot) => Ok(stand(pot, notes.millimetres)),
        None => {
            let message =
                "a template is of a pot with foot and rim, and this part has neither: expected another format";
            Err(Error::new(Code::UnsupportedShape, made.path("shape"), message).with("what", "no-template"))
        }
    };
    let stands = made.iter().map(standing).collect::<Result<Vec<Stand>>>()?;
    for ((body, stand), made) in bodies.iter().zip(&stands).zip(made) {
        on_paper(&notes.making, made.mesh.part, template::reach(body, stand))?;
    }
    template::write(notes, bodies, &stands, paper)
}

/// Refuses a template that is larger than paper comes.
fn on_paper(making: &Making, part: usize, reach: f64) -> Result<()> {
    if reach <= template::LARGEST {
        return Ok(());
    }
    let path = match making.size {
        Some(Size::Height(_)) => "size.height".to_owned(),
        Some(Size::Width(_)) => "size.width".to_owned(),
        Some(Size::Capacity(_)) => "size.capacity".to_owned(),
        None => format!("parts[{part}]"),
    };
    let message = format!(
        "a template is drawn at true scale: expected a part that reaches no more than {} mm from its foot, found {}",
        plain(template::LARGEST),
        plain(libm::round(reach))
    );
    Err(Error::new(Code::TooLarge, path, message).with("greatest", template::LARGEST).with("found", reach))
}

/// One part as files have it that have no colours, or one for each part.
pub(super) fn body<'a>(design: &Design, title: &str, mesh: &'a SolidMesh) -> Body<'a> {
    covered(design, title, mesh.part, uncoated(mesh))
}

/// One part as files of a format have it.
fn coated_body<'a>(design: &Design, title: &str, mesh: &'a SolidMesh, format: Format) -> Body<'a> {
    match format {
        Format::ThreeMf | Format::Glb | Format::Obj | Format::ObjZip | Format::Ply => {
            covered(design, title, mesh.part, coated(mesh, design.parts()[mesh.part].look))
        }
        _ => body(design, title, mesh),
    }
}

fn covered<'a>(
    design: &Design,
    title: &str,
    part: usize,
    Coated { positions, indices, faces, coats }: Coated<'a>,
) -> Body<'a> {
    let look = design.parts()[part].look;
    Body { name: named(design, title, part), look, positions, indices, faces, coats, plain: Vec::new() }
}

/// Refuses to join parts in a file that has no triangles.
fn refuse_union(format: Format) -> Result<()> {
    let message =
        format!("parts are joined as triangles: expected stl, 3mf, glb, obj, obj.zip or ply, found {}", format.name());
    match format {
        Format::Step | Format::Svg | Format::SvgA4 | Format::SvgLetter => {
            Err(Error::new(Code::OutOfRange, "union", message))
        }
        _ => Ok(()),
    }
}

/// The bodies of a file with those of one object as one.
#[cfg(feature = "patchwork")]
fn joined_bodies<'a>(
    solution: &Solution,
    Notes { title, making, millimetres, .. }: &Notes,
    made: &'a [Arc<Finished>],
    bodies: Vec<Body<'a>>,
) -> Result<Vec<Body<'a>>> {
    let design = solution.design();
    let objects: Vec<u32> = made.iter().map(|made| design.parts()[made.mesh.part].object).collect();
    let whole = |index: usize| {
        let mesh = &made[index].mesh;
        (body(design, title, mesh), Covering::of(mesh, design.parts()[mesh.part].look))
    };
    joined(&Unions::of(solution), bodies, &objects, making.tolerance.map(|tolerance| tolerance * millimetres), whole)
}

/// What joins bodies is left out of this build.
#[cfg(not(feature = "patchwork"))]
fn joined_bodies<'a>(_: &Solution, _: &Notes, _: &[Arc<Finished>], _: Vec<Body<'a>>) -> Result<Vec<Body<'a>>> {
    let message = "what joins parts is left out of this build: it takes the feature patchwork";
    Err(Error::new(Code::UnsupportedShape, "union", message).with("what", "left-out"))
}

/// What a part is called in a file.
fn named(design: &Design, title: &str, part: usize) -> String {
    design.parts()[part].name.clone().unwrap_or_else(|| match design.parts().len() {
        // Slicers show this name, and name by it what they write.
        1 => title.to_owned(),
        // Counted as the link counts them.
        _ => {
            let place = design.arranged(true).into_iter().position(|index| index == part);
            format!("part {}", place.unwrap_or(part) + 1)
        }
    })
}

/// The largest extent of the patches of a part, roughly, in model units.
fn extent(placed: &Placed) -> f64 {
    const SAMPLES: usize = 9;
    let at = |i: usize| i as f64 / (SAMPLES - 1) as f64;
    let places = (0..SAMPLES * SAMPLES).map(|k| (at(k / SAMPLES), at(k % SAMPLES)));
    let patches = placed.solved().patches();
    let points = patches.iter().flat_map(|patch| places.clone().map(|(u, v)| placed.place(&patch.jet(u, v)).position));
    let (low, high) = points.fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), p| (low.min(p), high.max(p)));
    (high - low).max_element()
}

/// The largest extent of a body.
fn size(body: &Body) -> f64 {
    let extent = |axis: usize| {
        let along = || body.positions.iter().skip(axis).step_by(3).copied();
        f64::from(along().fold(f32::NEG_INFINITY, f32::max)) - f64::from(along().fold(f32::INFINITY, f32::min))
    };
    extent(0).max(extent(1)).max(extent(2))
}

/// `passed`, `passed with warnings: thinned`. What is made has no errors, or it would have been refused.
fn told(report: &Report) -> String {
    let codes = |severity: Severity| {
        let mut codes: Vec<&str> = Vec::new();
        for finding in report.findings.iter().filter(|finding| finding.severity == severity) {
            if !codes.contains(&finding.code) {
                codes.push(finding.code);
            }
        }
        codes.sort_unstable();
        codes.join(", ")
    };
    match (codes(Severity::Error), codes(Severity::Warning)) {
        (errors, _) if !errors.is_empty() => format!("failed: {errors}"),
        (_, warnings) if !warnings.is_empty() => format!("passed with warnings: {warnings}"),
        _ => "passed".to_owned(),
    }
}

/// How a pot stands on paper.
fn stand(pot: &Pot, millimetres: f64) -> Stand {
    let axis = pot.axis();
    // Along world x, or along y for a pot that lies along x.
    let along = if axis.x.abs() < 0.9 { DVec3::X } else { DVec3::Y };
    let across = (along - along.dot(axis) * axis).normalize();
    let frame = Frame { origin: millimetres * pot.origin(), axis, across };
    Stand::new(frame, pot.faces().iter().map(|face| face as &dyn Face), millimetres)
}
