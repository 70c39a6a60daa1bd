/** The equation of a pot, what is given at its edges, and its closed form. */

import { phrases, plural } from "../../language";

/** What a kind of number does to the clay. Numbers of the named families have words of their own. */
const HELPS = {
  a: "How strongly the wall is drawn towards a round tube: near 0 it bends as freely as it can, far above it clings to its rings.",
  s: "Keeps the wall straight along the profile. It may not be 0.",
  t: "Draws the wall in towards the axis between its ends, the more the faster a wave goes round.",
  w: "Holds the wall back from swelling and from sinking in, above all the fast waves round the pot.",
  n: "How many waves go round the pot.",
  start: "Where the wall begins: so much of this wave there is at u = 0.",
  end: "Where the wall ends: so much of this wave there is at u = 1.",
  start_u: "How the wall leaves the edge at u = 0.",
  end_u: "How the wall arrives at the edge at u = 1.",
  rings: "So much of this wave there is on the ring, through which the wall passes.",
  force: "Pushes the wall between its ends.",
  u: "How far along the wall the ring is, from 0 to 1: the nearer two rings are, the more steeply the wall turns between them.",
  mean: "How wide the ring is, or how high it lies, all round.",
  cos: "How far this wave swings out on the ring, or up, from where the wall begins.",
  sin: "How far this wave swings out on the ring, or up, a quarter of a wave further round.",
  span: "How far v runs until the wall has gone round.",
} as const;

export type Help = keyof typeof HELPS;

export const equation = phrases("equation", {
  lead: "This pot is the exact solution of an equation, and every number in it is one of the pot. Point at a number to see where it is on the pot and what it does.",
  network:
    "A network of patches has no closed form between two edges: each patch solves a₁ Xᵤᵤ + a₂ Xᵥᵥ = 0 as nearly as its eight points leave it free to be, and what pushes it is added.",
  octant: "An octant solves no differential equation: it is all points with x^a + y^b + z^c of 1 or less.",
  blend:
    "A blend is a solid: between its two sections x, y and z solve a x_uuuu + b x_vvvv + c x_wwww = 0, with positions and tangents given at both.",
  digits: (count: number) =>
    plural(count, {
      one: "Numbers are rounded to one digit here; what is copied has all of them.",
      other: `Numbers are rounded to ${count} digits here; what is copied has all of them.`,
    }),
  copy: "Copy as LaTeX",
  copied: "LaTeX copied",
  notCopied: "Your browser did not let the page copy it. Copy it from here:",
  latex: "LaTeX",
  pde: "The equation",
  pdeLead: "It decides how the wall runs between what is given.",
  edges: "What is given",
  edgesLead: "u runs along the profile, v round the pot.",
  ringsLead:
    "At a ring the wall and its first two derivatives in u run on; at a corner it may turn, and the second is 0. A coordinate of second order has a corner at every ring.",
  numbers: "The numbers",
  closed: "Closed form",
  closedLead: "Each coordinate is a sum of waves round the pot. What stands before a wave is a function of u:",
  where: "They are made of",
  whereLead: "H has the value 1 at its own end and K the slope 1; at the other end both have neither value nor slope.",
  unsolved: (why: string) => `This equation has no solution. ${why}`,
  open: "Its closed form takes more digits than a number has, so it is left as it is given.",
  order: "The order",
  at: (u: string) => `At u = ${u}`,
  atSharp: (u: string) => `At u = ${u}, with a corner`,
  foot: (u: string) => `At the foot, u = ${u}`,
  rim: (u: string) => `At the rim, u = ${u}`,
  more: (count: number) => plural(count, { one: "and 1 more", other: `and ${count} more` }),
  fewer: "Show fewer",
  formulas: {
    pde: "The differential equation",
    sum: (axis: string) => `${axis} as a sum of waves`,
    mode: (index: number) => `Function q ${index}`,
    system: "What the functions are made of",
  },
  keys: "Arrow keys go from number to number, Enter goes to its field.",
  /** A number among the numbers of the pot: its symbol where it has one, its name, what it does. */
  named: (name: string, help: string) => `${name}: ${help}`,
  valued: (name: string, value: string) => `${name} = ${value}`,
  madeOf: (names: string) => `Made of ${names}.`,
  helps: HELPS satisfies Readonly<Record<Help, string>>,
  names: {
    smoothing: "Smoothing a",
    wave: (number: number, what: string) => `Wave ${number} of ${what}`,
    frequency: (number: number, what: string) => `Frequency of wave ${number} of ${what}`,
    footSlope: (what: string) => `${what}, slope at the foot`,
    rimSlope: (what: string) => `${what}, slope at the rim`,
    ringValue: (ring: number, of: string) => `Value at ring ${ring}, ${of}`,
    ringPlace: (ring: number) => `Place of ring ${ring}`,
    force: (of: string) => `Force, ${of}`,
    datum: (wave: string, n: string, axis: string) => `${wave} ${n} of ${axis}`,
  },
  /** The roots of a function, and what they do to the wall. */
  roots: {
    line: "Both roots are 0: it runs straight.",
    real: (r: string) => `Two real roots, ±${r}: between its ends it is drawn towards 0.`,
    swing: (r: string) => `Two imaginary roots, ±${r}i: it swings.`,
    cubic: "All four roots are 0: a cubic, which bends as little as it can.",
    doubleReal: (r: string) => `Real roots ±${r}, each twice: between its ends it is drawn towards 0.`,
    doubleSwing: (r: string) => `Imaginary roots ±${r}i, each twice: it swings, and more and more widely.`,
    twoReal: (r: string, s: string) => `Four real roots, ±${r} and ±${s}: between its ends it is drawn towards 0.`,
    realAndNone: (r: string) => `Real roots ±${r}, and 0 twice: straight but for its ends.`,
    realAndSwing: (r: string, s: string) =>
      `Real roots ±${r}, imaginary ones ±${s}i: it swings, and bends near its ends.`,
    swingAndNone: (r: string) => `Imaginary roots ±${r}i, and 0 twice: it swings about a straight line.`,
    twoSwings: (r: string, s: string) => `Four imaginary roots, ±${r}i and ±${s}i: two swings at once.`,
    complex: (s: string, d: string) => `Complex roots ±${s} ± ${d}i: it swings and dies away from its ends.`,
  },
});
