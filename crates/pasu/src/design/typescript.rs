//! The TypeScript declarations of the design document, from the tables by which it is read.

use super::conversion::{Conversion, Loss, VaseOrder};
use super::declarations::{alternatives, interface, numbers, union};
use super::fields::Fields;
use super::handles::{End, Handle, HandleId, Handles, Restraint, Step};
use super::look::{Clay, Glaze};
use super::motion::Motion;
use super::placement::Placement;
use super::shape::KINDS;
use super::tables::{CONNECTED, DESIGN, JOINT, JOINTS, LEAF, LINING, LOOK, PART, TREE, UNCONNECTED, WALL};
use super::unit::Unit;
use super::wall::{RimForm, Side};
use crate::answer::Answer;

/// The declarations of everything that a design document may hold, as the text of a `.d.ts` module.
///
/// `Design` fits what [`Design::parse`](crate::Design::parse) accepts and the canonical document that it gives back.
///
/// ```
/// assert!(pasu::typescript().contains("export interface Design {"));
/// ```
pub fn typescript() -> String {
    let mut text = String::from("// Generated from the field tables of the Rust crate `pasu`. Do not edit.\n");
    interface(&mut text, "Design", "A design: what a person has chosen.", DESIGN);
    interface(&mut text, "Part", "One placed surface of a design.", PART);
    union(&mut text, "Unit", "The unit of length.", Unit::NAMES);
    let kinds: Vec<String> = KINDS.iter().map(|kind| kind.type_name.to_owned()).collect();
    alternatives(&mut text, "Shape", "A surface.", &kinds);
    for kind in KINDS {
        (kind.typescript)(kind.name, &mut text);
    }
    numbers(&mut text, "Placement", "Scaled, then turned, then moved.", None, Placement::FIELDS);
    interface(
        &mut text,
        "Lining",
        "A lining of its own: a surface like the outside with fewer waves round it, so far inside that the wall is nowhere thinner than its thickness.",
        LINING,
    );
    interface(&mut text, "Wall", "The clay between the surface and the lining, in model units after placement.", WALL);
    union(&mut text, "Side", "Where the clay of a wall goes: inwards, or outwards.", Side::NAMES);
    union(&mut text, "RimForm", "How a wall ends at an opening: cut square, or half a circle.", RimForm::NAMES);
    interface(&mut text, "Look", "What a part is made of and covered with.", LOOK);
    union(&mut text, "GlazeName", "A glaze.", Glaze::NAMES);
    union(&mut text, "ClayName", "A clay body.", Clay::NAMES);
    interface(&mut text, "Joints", "By which numbers of its placement a part can be moved.", JOINTS);
    interface(&mut text, "Joint", "How far one number of a placement goes.", JOINT);
    interface(&mut text, "Tree", "A scene as a tree of its unions.", TREE);
    let nodes = ["TreeLeaf", "ConnectedUnion", "UnconnectedUnion"].map(str::to_owned);
    alternatives(&mut text, "TreeNode", "A solid or a union of solids.", &nodes);
    interface(&mut text, "TreeLeaf", "A solid: a part without its place.", LEAF);
    interface(&mut text, "ConnectedUnion", "Leaves and connected unions, glued into one object.", CONNECTED);
    interface(&mut text, "UnconnectedUnion", "Objects, apart from each other.", UNCONNECTED);
    numbers(&mut text, "Motion", "Turned, then moved.", None, Motion::FIELDS);
    text.push_str("\n/** A colour of one's own, `#rrggbb`: of sRGB. */\nexport type Colour = `#${string}`;\n");
    union(
        &mut text,
        "VaseOrder",
        "An order of the equation for which Zhang and You (2001) have a vase.",
        VaseOrder::NAMES,
    );
    Conversion::declare(&mut text);
    union(&mut text, "Loss", "What a vase has to leave behind in another order.", Loss::NAMES);
    Handles::declare(&mut text);
    union(&mut text, "End", "An end of the profile: u = 0, or u = 1.", End::NAMES);
    Handle::declare(&mut text);
    union(&mut text, "HandleId", "A point of the profile that can be dragged.", HandleId::NAMES);
    union(&mut text, "Restraint", "Why a handle does not move, or moves one way only.", Restraint::NAMES);
    Step::declare(&mut text);
    text
}

#[cfg(test)]
mod tests {
    use serde::de::DeserializeOwned;

    use super::*;
    use crate::design::boundary_value::{BoundaryValue, Component};
    use crate::design::ring::Ring;
    use crate::design::rings::{Hoop, Rings, Series, Slopes, Wave};
    use crate::design::tables::{
        BLEND, BOUNDARY_VALUE, Entry, FORCE, FOURTH, FRAME_PATCH, HARMONIC, HOOP, OCTANT, OUTLINE_SECTION, RING,
        RINGS_KIND, SECOND, SECTION, SERIES, SLOPES, VERTEX_FRAME, WAVE,
    };
    use crate::design::{
        Blend, Force, FramePatch, Harmonic, Joint, Joints, Lining, Look, Octant, Part, Section, Value, VertexFrame,
        Wall, reader,
    };

    /// The fields that a type is read from, as its refusal of another says.
    fn fields<T: DeserializeOwned>(tag: Option<(&str, Value)>) -> String {
        let mut given = vec![("?".to_owned(), Value::Bool(true))];
        given.extend(tag.map(|(name, value)| (name.to_owned(), value)));
        let error = reader::read::<T>(&Value::Record(given)).err().unwrap();
        error.message().split_once("expected one of ").unwrap().1.to_owned()
    }

    fn check<T: DeserializeOwned>(table: &[Entry], tag: Option<(&str, Value)>) {
        let names: Vec<&str> = table.iter().map(|entry| entry.name).collect();
        assert_eq!(fields::<T>(tag), names.join(", "));
    }

    #[test]
    fn what_is_declared_is_what_is_read() {
        check::<Part>(PART, None);
        check::<Wall>(WALL, None);
        check::<Lining>(LINING, None);
        check::<Look>(LOOK, None);
        check::<Joints>(JOINTS, None);
        check::<Joint>(JOINT, None);
        check::<BoundaryValue>(&BOUNDARY_VALUE[1..], None);
        check::<Ring>(RING, None);
        check::<Rings>(&RINGS_KIND[1..], None);
        check::<Hoop>(HOOP, None);
        check::<Slopes>(SLOPES, None);
        check::<Series>(SERIES, None);
        check::<Wave>(WAVE, None);
        check::<VertexFrame>(&VERTEX_FRAME[1..], None);
        check::<FramePatch>(FRAME_PATCH, None);
        check::<Force>(FORCE, None);
        check::<Blend>(&BLEND[1..], None);
        check::<Octant>(&OCTANT[1..], None);
        check::<Harmonic>(HARMONIC, None);
        check::<Section>(SECTION, Some(("form", Value::Text("disc".into()))));
        check::<Section>(OUTLINE_SECTION, Some(("form", Value::Text("outline".into()))));
        check::<Component>(SECOND, Some(("order", Value::Number(2.0))));
        check::<Component>(FOURTH, Some(("order", Value::Number(4.0))));
    }
}
