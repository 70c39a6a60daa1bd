/** Why a pot cannot be made or holds nothing, as sentences, from the code and what is named. */

import type { Cause, Refusal, Unit } from "../document/types";
import { formatNumber } from "../number";
import { making } from "./english/making";
import { lengthWords } from "./quantities";
import { numberOf, type Statement, tellOf, textOf, whyWords } from "./refusals";

/** Digits of lengths that stand in the way. */
const LENGTH_DIGITS = 4;

/** Why something holds no water, from the cause that a measure names. */
export function dryWords(cause: Cause, message: string, unit: Unit | null): string {
  const own = cause.args.what === undefined ? dryOf(cause.code) : null;
  return own ?? whyWords({ ...cause, path: "", message }, unit);
}

function dryOf(code: string): string | null {
  return making.dry[code as keyof typeof making.dry] ?? null;
}

function fewTerms(refusal: Refusal): string | null {
  const [found, waves, least] = ["found", "waves", "least"].map((name) => numberOf(refusal, name));
  return found && waves && least ? making.fewTerms(found, waves, least) : null;
}

/** By code; null where what a refusal names is not enough, or it is not of making. */
const STATEMENTS: Readonly<Record<string, Statement>> = {
  "too-large": (refusal) => {
    const [found, greatest] = [numberOf(refusal, "found"), numberOf(refusal, "greatest")];
    if (textOf(refusal, "what") === "tolerance") return making.tooManyPoints;
    if (greatest === null || refusal.args?.rows !== undefined) return null;
    if (textOf(refusal, "what") === "triangles") return making.tooManyTriangles(greatest);
    if (textOf(refusal, "what") === "weights") return making.tooSteep;
    if (found === null || !refusal.path.includes(".shape")) return null;
    const component = textOf(refusal, "component");
    return component === null ? making.tooManyWaves(found, greatest) : making.tooFast(component);
  },
  "tolerance-too-fine": (refusal, unit) => {
    const found = lengthOf(refusal, "found", unit);
    return found === null ? null : making.tooFine(found);
  },
  "open-surface": (refusal) => {
    const said: Readonly<Record<string, string>> = {
      "no-foot": making.openSurface.noFoot,
      "not-closed": making.openSurface.notClosed,
      "free-edge": making.openSurface.freeEdge,
      "one-sided": making.openSurface.oneSided,
    };
    return said[textOf(refusal, "what") ?? ""] ?? null;
  },
  "pinched-surface": (refusal, unit) => {
    const said: Readonly<Record<string, () => string | null>> = {
      "no-area": () => ofFace(refusal, "end", making.pinched.noArea),
      waist: () => making.pinched.waist,
      shrinks: () => ofFace(refusal, "face", making.pinched.shrinks),
      corners: () => making.pinched.corners,
      section: () => making.pinched.section,
      "no-height": () => making.pinched.noHeight,
      "no-normal": () => making.thickness.noNormal,
      "thin-edge": () => making.pinched.thinEdge,
    };
    return steppedOver(refusal, unit, said[textOf(refusal, "what") ?? ""]?.() ?? null);
  },
  "crosses-itself": (refusal, unit) => {
    const said: Readonly<Record<string, () => string | null>> = {
      surface: () => making.crosses.surface,
      "surface-close": () => making.crosses.surfaceClose,
      outline: () => ofFace(refusal, "face", making.crosses.outline),
      "does-not-close": () => making.crosses.doesNotClose,
      section: () => making.crosses.section,
      sections: () => making.crosses.sections,
      edge: () => making.crosses.edge,
      region: () => making.crosses.region,
      "not-joined": () => making.crosses.notJoined,
      "pinched-joint": () => making.crosses.pinchedJoint,
      touching: () => making.thickness.touching,
    };
    return steppedOver(refusal, unit, said[textOf(refusal, "what") ?? ""]?.() ?? null);
  },
  folded: () => making.folded,
  "few-terms": fewTerms,
  "out-of-range": (refusal) => {
    const what = textOf(refusal, "what");
    if (what === "lining-outside") return making.liningOutside;
    return what === "few-terms" ? fewTerms(refusal) : null;
  },
  "no-opening": () => making.noOpening,
  "unsupported-shape": (refusal) => {
    const said: Readonly<Record<string, string>> = {
      "no-ends": making.noEnds,
      "no-template": making.noTemplate,
      closes: making.closes,
      "open-sections": making.openSections,
      "no-inside": making.noInside,
      hollow: making.hollow,
      collapsed: making.collapsed,
      "left-out": making.leftOut,
      "no-foot": making.thickness.noFoot,
      "no-lining": making.noLining,
    };
    return said[textOf(refusal, "what") ?? ""] ?? null;
  },
  "no-room": (refusal, unit) => steppedOver(refusal, unit, noRoomFor(refusal, unit)),
};

tellOf(STATEMENTS);

function noRoomFor(refusal: Refusal, unit: Unit | null): string | null {
  const said = making.noRoom;
  const length = (name: string, say: (length: string) => string) => {
    const words = lengthOf(refusal, name, unit);
    return words === null ? null : say(words);
  };
  const sentences: Readonly<Record<string, () => string | null>> = {
    "no-disc": () => ofFace(refusal, "end", said.noDisc),
    "no-base": () => said.noBase,
    "above-rim": () => said.aboveRim,
    "round-bottom": () => said.roundBottom,
    tip: () => length("base", said.tip),
    "foot-not-level": () => said.footNotLevel,
    "ring-too-wide": () => length("width", said.ringTooWide),
    "ring-fills-foot": () => length("width", said.ringFillsFoot),
    "middle-outside": () => said.middleOutside,
    "drain-too-wide": () =>
      length("drain", (drain) => length("room", (room) => said.drainTooWide(drain, room)) ?? drain),
    "bends-too-sharply": () => length("thickness", said.bendsTooSharply),
    "sharp-ring": () => length("thickness", said.sharpRing),
    "ends-in-ring": () => said.endsInRing,
    lining: () => said.lining,
    crossing: () =>
      refusal.args?.face === refusal.args?.other
        ? ofFace(refusal, "face", said.crossingItself)
        : ofFace(refusal, "face", (face) => ofFace(refusal, "other", (other) => said.crossing(face, other)) ?? face),
    close: () => ofFace(refusal, "face", said.close),
    "turned-over": () => length("thickness", making.thickness.turnedOver),
    "sharp-crease": () => length("thickness", making.thickness.sharp),
    uneven: () =>
      length("found", (found) => length("thickness", (asked) => making.thickness.uneven(found, asked)) ?? found),
  };
  const what = textOf(refusal, "what") ?? "";
  return sentences[what]?.() ?? dryOf(what);
}

/** A sentence of a side or an end of a pot; null where its name is not known. */
function ofFace(refusal: Refusal, name: string, say: (face: string) => string | null): string | null {
  const face = making.faces[(textOf(refusal, name) ?? "") as keyof typeof making.faces];
  return face === undefined ? null : say(face);
}

/** What only fine triangles run into is told with how fine they are. */
function steppedOver(refusal: Refusal, unit: Unit | null, sentence: string | null): string | null {
  const bound = lengthOf(refusal, "bound", unit);
  return sentence === null || bound === null ? sentence : making.crosses.steppedOver(sentence, bound);
}

/** A length with its unit, if it is known. */
export function lengthOf({ args }: Pick<Refusal, "args">, name: string, unit: Unit | null): string | null {
  const length = args?.[name];
  if (typeof length !== "number") return null;
  return unit === null ? formatNumber(length, LENGTH_DIGITS) : lengthWords(length, unit, LENGTH_DIGITS);
}
