//! STEP: solids of B-spline surfaces for CAD programs (ISO 10303-21, application protocol 214).

mod brep;
mod columns;
mod exchange;
mod fit;
mod narrow;
mod net;
mod patches;
mod sewn;
mod spline;

use self::exchange::{Entities, Id, list, real, string};
use super::coats::{Coat, coat_of};
use super::contents::{Notes, PROGRAM};
use super::material::{Material, srgb};
use crate::design::Look;
use crate::error::Result;
use crate::face::{Face, FaceKind};
use crate::solution::Placed;

/// One part as CAD programs have it.
pub(super) struct Part<'a> {
    pub(super) name: String,
    pub(super) look: Look,
    pub(super) boundary: Boundary<'a>,
    /// The largest distance between splines and faces that is aimed at, in millimetres.
    pub(super) tolerance: f64,
    /// For errors.
    pub(super) path: String,
}

/// What a part is bounded by.
pub(super) enum Boundary<'a> {
    /// Faces of a pot, which close.
    Faces(Vec<&'a dyn Face>),
    /// The patches of a shape that has no foot and no rim.
    Patches(&'a Placed),
}

/// What the standard calls AP214, which every CAD program reads.
const SCHEMA: &str = "AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }";
/// The same on any day: a file is what its design is.
const DATE: &str = "2000-01-01T00:00:00";
/// Points that are no farther apart are one, for programs that ask, millimetres.
const UNCERTAINTY: f64 = 1e-6;

/// An exchange structure of one `MANIFOLD_SOLID_BREP` per part, in millimetres. `millimetres` is the length of a model unit. What was reached of the tolerance is in the header.
///
/// # Errors
/// `bug` when faces do not close.
pub(super) fn write(notes: &Notes, parts: &[Part], millimetres: f64) -> Result<Vec<u8>> {
    let mut data = Entities::default();
    let mut shapes = Vec::new();
    let (mut deviation, mut bound, mut n_samples) = (0.0f64, 0.0f64, 0);
    for part in parts {
        let sewn = match &part.boundary {
            Boundary::Faces(faces) => brep::sew(&mut data, &part.name, faces, millimetres, part.tolerance, &part.path)?,
            Boundary::Patches(placed) => patches::sew(&mut data, &part.name, placed, millimetres, part.tolerance),
        };
        deviation = deviation.max(sewn.deviation);
        bound = bound.max(sewn.bound);
        n_samples += sewn.n_samples;
        shapes.push(Shape { id: sewn.shape, is_closed: sewn.is_closed, faces: sewn.faces, look: part.look });
    }
    product(&mut data, &notes.title, &shapes);
    let accuracy = format!(
        "pasu-deviation: {} mm at most from the exact surfaces at {n_samples} points compared, {} mm between them",
        rounded_up(deviation),
        rounded_up(bound)
    );
    let descriptions: Vec<String> = notes.lines().into_iter().chain([accuracy]).map(|line| string(&line)).collect();
    let mut bytes = format!(
        "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((\n{}\n),'2;1');\nFILE_NAME({},'{DATE}',(''),(''),{program},{program},'');\nFILE_SCHEMA(({}));\nENDSEC;\nDATA;\n",
        descriptions.join(",\n"),
        string(&notes.title),
        string(SCHEMA),
        program = string(PROGRAM),
    )
    .into_bytes();
    bytes.append(&mut data.text());
    bytes.extend_from_slice(b"ENDSEC;\nEND-ISO-10303-21;\n");
    Ok(bytes)
}

/// A solid, or a surface that is not closed.
struct Shape {
    id: Id,
    is_closed: bool,
    faces: Vec<(FaceKind, Id)>,
    look: Look,
}

/// The product that these are the shape of, their units and colours.
fn product(data: &mut Entities, title: &str, shapes: &[Shape]) {
    let application = data.add("APPLICATION_CONTEXT('core data for automotive mechanical design processes')");
    data.add(&format!(
        "APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,{application})"
    ));
    let context = data.add(&format!("PRODUCT_CONTEXT('',{application},'mechanical')"));
    let title = string(title);
    let product = data.add(&format!("PRODUCT({title},{title},'',({context}))"));
    data.add(&format!("PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,({product}))"));
    let formation = data.add(&format!("PRODUCT_DEFINITION_FORMATION('','',{product})"));
    let design = data.add(&format!("PRODUCT_DEFINITION_CONTEXT('part definition',{application},'design')"));
    let definition = data.add(&format!("PRODUCT_DEFINITION('design','',{formation},{design})"));
    let shape = data.add(&format!("PRODUCT_DEFINITION_SHAPE('','',{definition})"));

    let metre = data.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
    let radian = data.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
    let steradian = data.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
    let uncertainty = data.add(&format!(
        "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE({}),{metre},'distance_accuracy_value','')",
        real(UNCERTAINTY)
    ));
    let context = data.add(&format!(
        "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({uncertainty}))GLOBAL_UNIT_ASSIGNED_CONTEXT(({metre},{radian},{steradian}))REPRESENTATION_CONTEXT('','3D'))"
    ));
    let ids: Vec<Id> = shapes.iter().map(|shape| shape.id).collect();
    let origin = data.point(glam::DVec3::ZERO);
    let up = data.direction(glam::DVec3::Z);
    let across = data.direction(glam::DVec3::X);
    let placement = data.add(&format!("AXIS2_PLACEMENT_3D('',{origin},{up},{across})"));
    let items: Vec<Id> = [placement].into_iter().chain(ids).collect();
    let representation = match shapes.iter().filter(|shape| shape.is_closed).count() {
        0 => "MANIFOLD_SURFACE_SHAPE_REPRESENTATION",
        n if n == shapes.len() => "ADVANCED_BREP_SHAPE_REPRESENTATION",
        _ => "SHAPE_REPRESENTATION",
    };
    let representation = data.add(&format!("{representation}({title},{},{context})", list(&items)));
    data.add(&format!("SHAPE_DEFINITION_REPRESENTATION({shape},{representation})"));

    let styled: Vec<Id> = shapes.iter().flat_map(|shape| styled(data, shape)).collect();
    data.add(&format!("MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',{},{context})", list(&styled)));
}

/// A solid in the colour of its glaze outside, and those of its faces that are covered otherwise. A face that the glaze line runs through is as it is above.
fn styled(data: &mut Entities, Shape { id: solid, faces, look, .. }: &Shape) -> Vec<Id> {
    let outside = style(data, Coat::Outside.of(*look));
    let solid = data.add(&format!("STYLED_ITEM('',({outside}),{solid})"));
    let mut items = vec![solid];
    let mut styles: Vec<(Coat, Id)> = Vec::new();
    for (kind, face) in faces {
        let coat = coat_of(*kind, look.line > 0.0, look.line >= 1.0);
        if coat.of(*look) == Coat::Outside.of(*look) {
            continue;
        }
        let known = styles.iter().find(|(known, _)| *known == coat).map(|(_, style)| *style);
        let own = known.unwrap_or_else(|| {
            styles.push((coat, style(data, coat.of(*look))));
            styles[styles.len() - 1].1
        });
        items.push(data.add(&format!("OVER_RIDING_STYLED_ITEM('',({own}),{face},{solid})")));
    }
    items
}

/// The style of a surface in the colour of a glaze.
fn style(data: &mut Entities, look: Look) -> Id {
    let [red, green, blue] = Material::of(look).colour.map(|linear| real(f64::from(srgb(linear)) / 255.0));
    let colour = data.add(&format!("COLOUR_RGB('',{red},{green},{blue})"));
    let fill = data.add(&format!("FILL_AREA_STYLE_COLOUR('',{colour})"));
    let fill = data.add(&format!("FILL_AREA_STYLE('',({fill}))"));
    let fill = data.add(&format!("SURFACE_STYLE_FILL_AREA({fill})"));
    let side = data.add(&format!("SURFACE_SIDE_STYLE('',({fill}))"));
    let usage = data.add(&format!("SURFACE_STYLE_USAGE(.BOTH.,{side})"));
    data.add(&format!("PRESENTATION_STYLE_ASSIGNMENT(({usage}))"))
}

/// Millimetres to the nanometre, never less than they are.
fn rounded_up(length: f64) -> String {
    real(libm::ceil(length * 1e6) / 1e6)
}
