/** The gallery: its shelves, and the title and note of each design. A design that is opened has its title in the document. */

import type { ExhibitId, Shelf } from "../../document/gallery";
import type { FIRST } from "../../document/gallery/first";
import { phrases } from "../../language";

interface Told {
  /** What its parts are called, where it has several. */
  readonly parts?: readonly string[];
  readonly title: string;
  /** What to look at, or where it was printed. */
  readonly note: string;
}

export const gallery = phrases("gallery", {
  shelves: {
    own: { title: "Our own", source: "Designs that show what the equations can do" },
    rings: { title: "Through rings", source: "Pulled, squeezed, turned and cut, each with its wall" },
    scenes: { title: "Several together", source: "Each an object of its own: select one, change it, move it" },
    blends: { title: "Between two sections", source: "From one outline into another, each with its wall" },
    networks: {
      title: "Networks of patches",
      source: "What no wheel throws, through a few points that a hand can drag",
    },
    octants: {
      title: "Octants",
      source: "Balls, boxes and stars of three exponents (Anderson, Sullivan and Baker 1988)",
    },
    "zhang-you-2004": {
      title: "Zhang and You 2004",
      source: "Blending solids with approximate analytical solution to PDE: solids, by the paper's own method",
    },
    "zhang-you": {
      title: "Zhang and You",
      source: "Surface representation using second, fourth and mixed order partial differential equations, 2001",
    },
    "ishak-ali": {
      title: "Ishak and Ali",
      source: "Parametric surface generation using partial differential equation based approach",
    },
  } satisfies Readonly<Record<Shelf["id"], { readonly title: string; readonly source: string }>>,
  /** The first one's title is known before the gallery is. */
  firstNote: "Fourth order: place and slope are both free at rim and foot, and that alone makes the shoulder.",
  exhibits: {
    "own-dint": {
      title: "Dint vase",
      note: "Bloor–Wilson: five dints in the rim, and a wall that forgets them on the way down.",
    },
    "own-moon-jar": {
      title: "Moon jar",
      note: "Fourth order: steep slopes out of the foot and into the rim round the wall into a ball.",
    },
    "own-twist": {
      title: "Twisted vase",
      note: "The six lobes of the foot come back at the rim three quarters of a wave later; the wall turns to follow.",
    },
    "own-amphora": {
      title: "Amphora",
      note: "Fourth order: the wall swells from a narrow foot to a high shoulder, then a neck opens into the lip.",
    },
    "own-tulip": {
      title: "Tulip vase",
      note: "One wave of six in the radius and one in the height, both gone before they reach the foot.",
    },
    "own-fluted": {
      title: "Fluted vase",
      note: "Twenty flutes that run up the whole wall, shallow at the foot and deeper at the lip.",
    },
    "own-melon": {
      title: "Melon jar",
      note: "Rim and foot are true circles: the eight lobes swell on the rings between them.",
    },
    "own-saddle": {
      title: "Saddle vase",
      note: "A rim that rises twice and dips twice over a round, level foot.",
    },
    "own-gourd": {
      title: "Double gourd",
      note: "Nine rings, all of them round: in at the waist, out above and below.",
    },
    "own-bowl": {
      title: "Lotus bowl",
      note: "Ten petals fade from the lip on their way down to a foot of a third of its width.",
    },
    "own-carafe": {
      title: "Carafe",
      note: "Fourth order without pull: a low belly, a long neck and a lip from four slopes.",
    },
    "own-square": {
      title: "Square foot, round mouth",
      note: "A wave of four at the foot that has died out at the mouth.",
    },
    "own-trumpet": {
      title: "Trumpet vase",
      note: "Second order: only the edges are given, and the pull of the equation makes the waist.",
    },
    "own-plum": {
      title: "Plum vase",
      note: "Fourth order: a foot that hardly spreads under a broad shoulder and a small mouth.",
    },
    "own-leaning": {
      title: "Leaning bottle",
      note: "The middle of the rim stands beside the middle of the foot, so the neck leans.",
    },
    "own-plate": {
      title: "Petal plate",
      note: "Twelve shallow petals round a plate that leaves its foot almost level.",
    },
    "own-lipped-jug": {
      title: "Lipped jug",
      note: "A finger drew the lip out while the other hand held the throat; so the rim rises as it narrows.",
    },
    "own-squeezed-bottle": {
      title: "Squeezed bottle",
      note: "Pressed flat twice before it was dry: the belly from two sides, the neck from the two between.",
    },
    "own-twisted-gourd": {
      title: "Twisted gourd",
      note: "Five lobes climb through both bellies and have gone round by a fifth when they reach the mouth.",
    },
    "own-faceted-jar": {
      title: "Faceted jar",
      note: "Eight sides, as if cut from a thick wall with a wire, that end where the neck is round again.",
    },
    "own-trefoil-jug": {
      title: "Trefoil jug",
      note: "The wine jug of the Greeks: a round lip pinched in twice pours from any of three.",
    },
    "own-bamboo": {
      title: "Bamboo vase",
      note: "Three nodes that narrow as they climb, as a stem's do.",
    },
    "own-dancing-bottle": {
      title: "Dancing bottle",
      note: "Every ring stands beside the one below, first to one side, then to the other.",
    },
    "own-shell-bowl": {
      title: "Shell bowl",
      note: "Waves of 13, 14 and 15 meet in ribs on one side and leave the other smooth.",
    },
    "own-thumbed-cup": {
      title: "Thumbed cup",
      note: "Four dents at half its height, for a thumb and the fingers, under a rim that is round.",
    },
    "own-chevron-vase": {
      title: "Chevron vase",
      note: "Twelve flutes that turn one way up to the belly and the other way above it.",
    },
    "zhang-you-1a": {
      title: "Zhang and You 2001, figure 1a",
      note: "Second order, petalled at rim and foot, with a strong waist pull.",
    },
    "zhang-you-1b": {
      title: "Zhang and You 2001, figure 1b",
      note: "Second order, petalled at rim and foot, with a gentle waist pull.",
    },
    "zhang-you-2a": {
      title: "Zhang and You 2001, figure 2a",
      note: "Second order, round, with a gentle waist pull.",
    },
    "zhang-you-2b": {
      title: "Zhang and You 2001, figure 2b",
      note: "Second order, round, with a strong waist pull.",
    },
    "zhang-you-3a": {
      title: "Zhang and You 2001, figure 3a",
      note: "Second order, pushed evenly outwards.",
    },
    "zhang-you-3b": {
      title: "Zhang and You 2001, figure 3b",
      note: "Second order, pushed outwards half as hard.",
    },
    "zhang-you-3c": {
      title: "Zhang and You 2001, figure 3c",
      note: "Second order, pushed inwards at the rim and outwards below.",
    },
    "zhang-you-3d": {
      title: "Zhang and You 2001, figure 3d",
      note: "Second order, pushed outwards at the rim and inwards at the foot.",
    },
    "zhang-you-4a": {
      title: "Zhang and You 2001, figure 4a",
      note: "Mixed order, strong waist pull, the wall dropping steeply from the rim.",
    },
    "zhang-you-4b": {
      title: "Zhang and You 2001, figure 4b",
      note: "Mixed order, strong waist pull, the wall leaving the rim level.",
    },
    "zhang-you-4c": {
      title: "Zhang and You 2001, figure 4c",
      note: "Mixed order, gentle waist pull, the wall dropping steeply from the rim.",
    },
    "zhang-you-4d": {
      title: "Zhang and You 2001, figure 4d",
      note: "Mixed order, gentle waist pull, the wall leaving the rim level.",
    },
    "zhang-you-5a": {
      title: "Zhang and You 2001, figure 5a",
      note: "Fourth order: the slopes at rim and foot are chosen (table 1, row a).",
    },
    "own-square-round-bowl": {
      title: "Square to round bowl",
      note: "A soft square foot that has forgotten its corners by the time it is a rim.",
    },
    "own-star-dish": {
      title: "Star dish",
      note: "A round foot; the five points come out of the wall only near the rim.",
    },
    "own-twisted-square": {
      title: "Twisted square vase",
      note: "The same square at both ends, the upper one turned by 75 degrees: the wall turns to follow.",
    },
    "own-petal-planter": {
      title: "Petalled planter",
      note: "An oval foot into an oval rim with eight petals, with a hole to drain.",
    },
    "own-three-sided-bottle": {
      title: "Three-sided bottle",
      note: "A triangle at the foot, a round neck, and no edge where one becomes the other.",
    },
    "own-six-sided-jar": {
      title: "Six-sided jar",
      note: "Hexagons at both ends; the belly between them is nearly round.",
    },
    "own-flower-bowl": {
      title: "Flower bowl",
      note: "Six petals in the rim that die away towards a round foot ring.",
    },
    "own-crossed-ovals": {
      title: "Crossed ovals",
      note: "Long one way at the foot, the other way at the rim.",
    },
    "zhang-you-2004-1": {
      title: "Zhang and You 2004, example 1",
      note: "From one cube into another: a square section into a rectangle, by 4 x 4 x 3 collocation points.",
    },
    "zhang-you-2004-2": {
      title: "Zhang and You 2004, example 2",
      note: "From an elliptic cylinder into a circular one. This one has a closed form too: choose Exact to compare.",
    },
    "zhang-you-2004-3": {
      title: "Zhang and You 2004, example 3",
      note: "From a cylinder into a cube: sections of different kinds, which nothing but the equation brings together.",
    },
    "own-mug": { title: "Mug with a handle", note: "A third of a litre, of one surface with its handle." },
    "own-basket": { title: "Basket with a handle", note: "An arch from rim to rim." },
    "own-spouted": { title: "Teapot with a spout", note: "Body, handle and a spout that pours." },
    "own-hat": { title: "Hat", note: "A brim that turns up at the sides." },
    "own-dress": { title: "Dress", note: "Eight folds, a waist, and cloth of four millimetres." },
    "own-face": { title: "Face", note: "Twenty patches: nose, eyes and mouth are forces." },
    "own-leaf": { title: "One patch", note: "Eight points, and the smooth surface through them." },
    "own-leaf-pushed": { title: "One patch, pushed", note: "A force on the whole of it; its edges stay." },
    "own-leaf-regions": { title: "One patch, two regions", note: "One rectangle is raised, another dented." },
    "own-octant-ball": { title: "Eighth of a ball", note: "Exponents 2, 2 and 2." },
    "own-octant-box": { title: "Soft box", note: "Exponents of 8: nearly a cube, with edges that a hand can bear." },
    "own-octant-facet": { title: "Cut corner", note: "Exponents of 1: a flat face on three axes." },
    "own-octant-hollow": { title: "Hollow corner", note: "Exponents of 0.6: it bends inwards between sharp tips." },
    "own-octant-cushion": {
      title: "Cushion",
      note: "Eight octants around one point, squarer from above than from the side.",
    },
    "own-octant-star": { title: "Star", note: "Eight hollow octants around one point: six tips." },
    "own-lidded-jar": {
      title: "Jar with a lid",
      note: "The lid is a bowl that was turned over.",
      parts: ["Jar", "Lid"],
    },
    "own-tea-set": {
      title: "Tea set",
      note: "Teapot, four cups, a jug for the milk and a plate.",
      parts: ["Teapot", "Lid", "First cup", "Second cup", "Third cup", "Fourth cup", "Jug", "Plate"],
    },
    "own-glued-mug": {
      title: "Cup with a handle glued on",
      note: "Rings and patches, two parts of one object.",
      parts: ["Cup", "Handle"],
    },
    "own-widget": {
      title: "Widget of 23 octants",
      note: "After Anderson, Sullivan and Baker 1988: two holes of four octants each, and eight round the annulus.",
    },
    "own-shelf": {
      title: "Five vases of the papers",
      note: "Figures of Zhang and You and of Ishak and Ali, side by side.",
      parts: ["Figure 1a", "Figure 3b", "Figure 5b", "Figure 5d", "Five petals"],
    },
    "zhang-you-5b": {
      title: "Zhang and You 2001, figure 5b",
      note: "Fourth order: the slopes at rim and foot are chosen (table 1, row b).",
    },
    "zhang-you-5c": {
      title: "Zhang and You 2001, figure 5c",
      note: "Fourth order: the slopes at rim and foot are chosen (table 1, row c).",
    },
    "zhang-you-5d": {
      title: "Zhang and You 2001, figure 5d",
      note: "Fourth order: the slopes at rim and foot are chosen (table 1, row d).",
    },
    "zhang-you-5e": {
      title: "Zhang and You 2001, figure 5e",
      note: "Fourth order: the slopes at rim and foot are chosen (table 1, row e).",
    },
    "ishak-ali-4-n1": {
      title: "Ishak and Ali, figure 4, n₁ = 1",
      note: "The dint vase with one dint in the rim.",
    },
    "ishak-ali-4-n2": {
      title: "Ishak and Ali, figure 4, n₁ = 2",
      note: "The dint vase with 2 dints in the rim.",
    },
    "ishak-ali-4-n3": {
      title: "Ishak and Ali, figure 4, n₁ = 3",
      note: "The dint vase with 3 dints in the rim.",
    },
    "ishak-ali-4-n5": {
      title: "Ishak and Ali, figure 4, n₁ = 5",
      note: "The dint vase with 5 dints in the rim.",
    },
    "ishak-ali-4-n10": {
      title: "Ishak and Ali, figure 4, n₁ = 10",
      note: "The dint vase with 10 dints in the rim.",
    },
    "ishak-ali-4-n15": {
      title: "Ishak and Ali, figure 4, n₁ = 15",
      note: "The dint vase with 15 dints in the rim.",
    },
    "ishak-ali-5-a1": {
      title: "Ishak and Ali, figure 5, a = 1",
      note: "The dint vase with five dints, smoothing 1.",
    },
    "ishak-ali-5-a6": {
      title: "Ishak and Ali, figure 5, a = 6",
      note: "The dint vase with five dints, smoothing 6.",
    },
    "ishak-ali-5-a9": {
      title: "Ishak and Ali, figure 5, a = 9",
      note: "The dint vase with five dints, smoothing 9.",
    },
  } satisfies Readonly<Record<Exclude<ExhibitId, (typeof FIRST)["id"]>, Told>>,
  heading: "Gallery",
  openPapers: "Open the figures of the papers",
  sizes: {
    hand: { label: (height: string) => `${height} high`, note: "A pot to use." },
    printed: { label: () => "As printed", note: "With the numbers of the paper." },
  },
});
