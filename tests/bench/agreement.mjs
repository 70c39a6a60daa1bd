// Whether a contender computes what Pasu computes. Nobody is timed for computing something else.

/** The largest distance of a position, as a part of the largest coordinate: single precision is good to some 1e-7. */
const POSITIONS = 1e-6;
/** The largest distance of a component of a unit normal, and of one found by finite differences. */
const NORMALS = 1e-5;
const COARSE_NORMALS = 1e-3;

/** Refuses a contender whose positions or normals differ from the true ones. */
export function agree(contender, truth) {
  const { name, positions, normals, coarse = false } = contender;
  const size = truth.positions.reduce((largest, x) => Math.max(largest, Math.abs(x)), 0);
  check(name, "positions", largestDifference(positions, truth.positions), POSITIONS * size);
  check(name, "normals", largestDifference(normals, truth.normals), coarse ? COARSE_NORMALS : NORMALS);
}

function check(name, what, difference, allowed) {
  if (!(difference <= allowed)) throw new Error(`${name}: ${what} differ by ${difference}, more than ${allowed}`);
}

function largestDifference(found, truth) {
  if (found.length !== truth.length) return Number.POSITIVE_INFINITY;
  let largest = 0;
  for (let i = 0; i < truth.length; i++) {
    const difference = Math.abs(found[i] - truth[i]);
    if (!(difference <= largest)) largest = difference;
  }
  return largest;
}
