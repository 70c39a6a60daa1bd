//! The tables of fields of what is not all numbers, as TypeScript is told of them; a test compares them with the types that are read.

use super::fields::Need;

/// One field.
pub(super) struct Entry {
    pub(super) name: &'static str,
    pub(super) need: Need,
    /// Its type as TypeScript writes it.
    pub(super) typescript: &'static str,
    /// What it means.
    pub(super) about: &'static str,
}

const fn required(name: &'static str, typescript: &'static str, about: &'static str) -> Entry {
    Entry { name, need: Need::Required, typescript, about }
}

const fn optional(name: &'static str, typescript: &'static str, about: &'static str) -> Entry {
    Entry { name, need: Need::Optional, typescript, about }
}

pub(super) const DESIGN: &[Entry] = &[
    required("pasu", "1", "The version of the format."),
    optional("title", "string", "At most 200 characters of plain text."),
    optional("unit", "Unit", "What 1 means; centimetres when left out."),
    required("parts", "readonly Part[]", "1 to 500 parts."),
];

pub(super) const PART: &[Entry] = &[
    optional("name", "string", "A name that no other part has."),
    optional("object", "number", "The discrete object that it is glued into; 0 when left out."),
    required("shape", "Shape", "Its surface, before placement."),
    optional("place", "Placement", "Where it stands."),
    optional("wall", "Wall", "The wall that makes its surface a pot."),
    optional("look", "Look", "Its clay and glaze."),
    optional("joints", "Joints", "By which numbers of its placement it can be moved."),
];

pub(super) const JOINTS: &[Entry] = &[
    optional("x", "Joint", "Of the shift along x."),
    optional("y", "Joint", "Of the shift along y."),
    optional("z", "Joint", "Of the shift along z."),
    optional("turn", "Joint", "Of the turn about an axis of the scene through where the origin of the shape stands."),
];

pub(super) const JOINT: &[Entry] = &[
    optional("label", "string", "What it is called: at most 200 characters of plain text."),
    required(
        "limits",
        "readonly [number, number]",
        "From where to where it goes: coordinates of the shift, or radians, of which no more than a whole turn either way. The placement may have a number outside them.",
    ),
    optional(
        "axis",
        "readonly [number, number, number]",
        "The axis that a turn is about, in the coordinates of the scene; upright when left out. Only a turn has one.",
    ),
    optional("glued", "boolean", "Whether all that is glued to the part goes along; false when left out."),
];

/// A scene as a tree.
pub(super) const TREE: &[Entry] = &[
    required("pasu", "1", "The version of the format."),
    optional("title", "string", "At most 200 characters of plain text."),
    optional("unit", "Unit", "What 1 means; centimetres when left out."),
    required("tree", "TreeNode", "1 to 500 leaves; unions nest at most 24 deep."),
];

pub(super) const LEAF: &[Entry] = &[
    optional("name", "string", "A name that no other leaf has."),
    required("shape", "Shape", "Its surface, before placement."),
    optional(
        "scale",
        "readonly [number, number, number]",
        "Factors along x, y and z, before turning. Not 0. Only leaves scale.",
    ),
    optional("wall", "Wall", "The wall that makes its surface a pot."),
    optional("look", "Look", "Its clay and glaze."),
    optional("joints", "Joints", "By which numbers of its placement it can be moved, in the coordinates of the scene."),
    optional("place", "Motion", PLACE),
];

pub(super) const CONNECTED: &[Entry] = &[
    required("connected", "readonly (TreeLeaf | ConnectedUnion)[]", "2 or more, of which the first is not moved."),
    optional("place", "Motion", PLACE),
];

pub(super) const UNCONNECTED: &[Entry] = &[
    required("unconnected", "readonly TreeNode[]", "2 or more, of which the first is not moved."),
    optional("place", "Motion", PLACE),
];

const PLACE: &str =
    "Where it stands, seen from the first member of the union that it is in; of the root, where the whole stands.";

pub(super) const BOUNDARY_VALUE: &[Entry] = &[
    required("kind", "\"boundary-value\"", "Any Fourier boundary data."),
    required("span", "number | \"2pi\"", "The length of the interval of v round the axis."),
    optional(
        "rings",
        "readonly Ring[]",
        "Curves between the two ends that it passes through, in ascending u inside (0, 1), at most 64.",
    ),
    required("x", "Component", "The equation and the data of x."),
    required("y", "Component", "The equation and the data of y."),
    required("z", "Component", "The equation and the data of z, the axis of a pot."),
];

/// A pot through rings.
pub(super) const RINGS_KIND: &[Entry] = &[
    required("kind", "\"rings\"", "A pot by the radius and the height of its rings."),
    optional(
        "a",
        "number",
        "The smoothing parameter: how strongly the wall is drawn towards a round tube; 1 when left out.",
    ),
    required("rings", "readonly Hoop[]", "2 to 66 rings from the foot, at u = 0, to the rim, at u = 1."),
    optional("foot", "Slopes", "The slopes at the foot; without them it is free."),
    optional("rim", "Slopes", "The slopes at the rim; without them it is free."),
];

/// One ring of such a pot.
pub(super) const HOOP: &[Entry] = &[
    required("u", "number", "Where it is along the profile, beyond the one before it."),
    required("r", "Series", "Its radius."),
    required("z", "Series", "Its height."),
    optional("sharp", "boolean", "Whether the profile has a corner there; false when left out."),
];

pub(super) const SLOPES: &[Entry] =
    &[required("r", "Series", "Of the radius."), required("z", "Series", "Of the height.")];

pub(super) const SERIES: &[Entry] = &[
    required("mean", "number", "The mean round the axis."),
    optional("waves", "readonly Wave[]", "What goes up and down about it."),
];

pub(super) const WAVE: &[Entry] = &[
    required("n", "number", "How often it goes up and down round the axis: whole, and 1 or more."),
    optional("cos", "number", "How far as cos(n v); 0 when left out."),
    optional("sin", "number", "How far as sin(n v); 0 when left out."),
];

/// A network of vertex-frames.
pub(super) const VERTEX_FRAME: &[Entry] = &[
    required("kind", "\"vertex-frame\"", "Four-sided patches through a network of points."),
    required("vertices", "readonly (readonly [number, number, number])[]", "The points, at most 800,000."),
    required("patches", "readonly FramePatch[]", "1 to 100,000 patches."),
    optional(
        "rule",
        "\"global\" | { readonly seed: number }",
        "How the cubic terms of the edges are decided: by all patches of a strip, or by the first from a patch on; global when left out.",
    ),
    optional("continuity", "\"C0\"", "How smoothly patches meet; C0 when left out."),
    optional(
        "crease",
        "number",
        "Edges at which the surface turns by less than this angle are drawn as if it were smooth, in radians; 0.5 when left out. Not less than 0.",
    ),
];

/// One patch of a network.
pub(super) const FRAME_PATCH: &[Entry] = &[
    required(
        "frame",
        "readonly [number, number, number, number, number, number, number, number]",
        "The numbers of eight vertices: corners and middles of the edges in turn, from (u, v) = (0, 0) by way of (1, 0).",
    ),
    optional("a1", "readonly [number, number, number]", "Shape control parameters of X_uu; 1 when left out."),
    optional("a2", "readonly [number, number, number]", "Shape control parameters of X_vv; 1 when left out."),
    optional("forces", "readonly Force[]", "Sculpting forces, which add up; at most 64."),
];

/// What sculpts a patch.
pub(super) const FORCE: &[Entry] = &[
    required("f0", "readonly [number, number, number]", "How strong it is."),
    optional("u", "readonly [number, number]", "From where to where along u, ascending; 0 to 1 when left out."),
    optional("v", "readonly [number, number]", "From where to where along v, ascending; 0 to 1 when left out."),
    optional("falloff", "Falloff", "How it falls off towards the rim of that rectangle; sine when left out."),
];

/// An octant of a supersphere.
pub(super) const OCTANT: &[Entry] = &[
    required(
        "kind",
        "\"octant\"",
        "The octant x^a + y^b + z^c <= 1 of a supersphere, where no coordinate is negative.",
    ),
    required("exponents", "readonly [number, number, number]", "a, b and c. 0.05 to 50."),
];

/// A solid between two sections.
pub(super) const BLEND: &[Entry] = &[
    required("kind", "\"blend\"", "A solid that flows from one section into another."),
    required("start", "Section", "The section at w = 0."),
    required("end", "Section", "The section at w = 1."),
    optional(
        "method",
        "Method",
        "How it is solved; exact between two closed sections when left out, and modal between others.",
    ),
    optional(
        "terms",
        "readonly [number, number, number]",
        "How many terms along u, v and w: at most 256, 256 and 64; 4, 4, 3 when left out.",
    ),
    optional(
        "weights",
        "readonly [number, number, number]",
        "The weights of the three directions, above 0; 1 when left out.",
    ),
];

const LEVEL: Entry = required("z", "number", "Its height.");
const TAPER: Entry = required("taper", "number", "Its tangents in x and y, in parts of the position.");
const DZ: Entry = required("dz", "number", "Its tangents in z.");

/// A section of one of the forms of ZY04.
pub(super) const SECTION: &[Entry] = &[
    required(
        "form",
        "\"rectangle\" | \"rectangle-reversed\" | \"disc\" | \"disc-in-square\"",
        "What it is bounded by, and how u and v run over it.",
    ),
    required("radius", "readonly [number, number]", "Half its width and half its depth, above 0."),
    LEVEL,
    TAPER,
    DZ,
];

/// A section within a closed curve.
pub(super) const OUTLINE_SECTION: &[Entry] = &[
    required("form", "\"outline\"", "A closed curve, which u draws together towards its mean."),
    required("x", "readonly Harmonic[]", "The Fourier series of x."),
    required("y", "readonly Harmonic[]", "The Fourier series of y."),
    LEVEL,
    TAPER,
    DZ,
];

/// One harmonic of such a curve.
pub(super) const HARMONIC: &[Entry] = &[
    required("n", "number", "How often it goes up and down round the curve: whole, 0 for the mean."),
    optional("cos", "number", "How far as cos(2 pi n v); 0 when left out."),
    optional("sin", "number", "How far as sin(2 pi n v); 0 when left out."),
];

const S: Entry = required("s", "number", "Shape control parameter of the highest u derivative; not 0.");
const START: Entry = optional("start", "number", "Value at u = 0.");
const END: Entry = optional("end", "number", "Value at u = 1.");
const FORCE_ENTRY: Entry =
    optional("force", "readonly number[]", "Sculpting force in ascending powers of u, at most 512 coefficients.");

const RINGS_ENTRY: Entry =
    optional("rings", "readonly number[]", "Values at the rings, one for each; 0 at all of them when left out.");

/// A curve between the two ends.
pub(super) const RING: &[Entry] = &[
    required("u", "number", "Where it is, inside (0, 1)."),
    optional(
        "sharp",
        "boolean",
        "Whether the profile has a corner there; false when left out. A component of order 2 has one at every ring.",
    ),
];

/// A component of order 2: `s X_uu + t X_vv = p`.
pub(super) const SECOND: &[Entry] = &[
    required("order", "2", "The order of the equation s X_uu + t X_vv = p."),
    S,
    required("t", "number", "Shape control parameter of the v derivative."),
    required("modes", "readonly Mode<SecondOrderDatum>[]", "The Fourier sum of boundary data and force."),
];

/// A component of order 4: `s X_uuuu + t X_uuvv + w X_vvvv = p`.
pub(super) const FOURTH: &[Entry] = &[
    required("order", "4", "The order of the equation s X_uuuu + t X_uuvv + w X_vvvv = p."),
    S,
    required("t", "number", "Shape control parameter of the mixed derivative."),
    required("w", "number", "Shape control parameter of the fourth v derivative."),
    optional(
        "free",
        "\"start\" | \"end\" | \"both\"",
        "Ends whose slopes are not given: the second derivative in u is 0 there instead. No end when left out.",
    ),
    required("modes", "readonly Mode<FourthOrderDatum>[]", "The Fourier sum of boundary data and force."),
];

pub(super) const MODE: &[Entry] = &[
    required("n", "number", "How often it goes round; the surface closes when it is whole."),
    optional("cos", "Datum", "The data of cos(2 pi n v / span)."),
    optional("sin", "Datum", "The data of sin(2 pi n v / span)."),
];

/// What a mode of order 2 is given; what is left out is 0.
pub(super) const SECOND_DATUM: &[Entry] = &[START, END, RINGS_ENTRY, FORCE_ENTRY];

/// What a mode of order 4 is given; what is left out is 0.
pub(super) const FOURTH_DATUM: &[Entry] = &[
    START,
    END,
    optional("start_u", "number", "Slope in u at u = 0."),
    optional("end_u", "number", "Slope in u at u = 1."),
    RINGS_ENTRY,
    FORCE_ENTRY,
];

pub(super) const WALL: &[Entry] = &[
    required("thickness", "number", "The thickness of the wall along the normal. Greater than 0."),
    required("base", "number", "The thickness of the base; 0 for a pot without one. Not less than 0."),
    optional("side", "Side", "Which way the clay goes from the surface; inside when left out."),
    optional("rim", "RimForm", "How the wall ends at an opening; flat when left out."),
    optional(
        "foot",
        "readonly [number, number]",
        "Width and height of a ring under the base; none when left out. Greater than 0.",
    ),
    optional("drain", "number", "The diameter of a round hole through the base; 0 when left out. Not less than 0."),
    optional("lining", "Lining", "An inside that does not follow the outside; where it is left out, it does."),
];

pub(super) const LINING: &[Entry] = &[optional(
    "waves",
    "number",
    "The most waves round it that the inside keeps of those of the outside; 0, for a round one, when left out. A whole number from 0 to 128.",
)];

pub(super) const LOOK: &[Entry] = &[
    optional("glaze", "GlazeName | Colour", "What covers the part; celadon when left out."),
    optional("inside", "GlazeName | Colour", "What covers it inside; as outside when left out."),
    optional(
        "line",
        "number",
        "Where the glaze of the outside ends, as a share of its height: below it the clay is bare. 0 to 1; 0 when left out.",
    ),
    optional("clay", "ClayName | Colour", "What the part is made of; stoneware when left out."),
];
