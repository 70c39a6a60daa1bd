// What is measured in Node and in Chromium: groups of contenders that take turns.

import { agree } from "./agreement.mjs";
import {
  CLOSED_FORM,
  contenders,
  HAND_TUNED,
  MIRRORED,
  PARAMETRIC_GEOMETRY,
  PLAIN_LOOPS,
} from "./contenders/index.mjs";
import { firstModes, pots, withEveryWave, withOneEquation, withRings } from "./designs.mjs";
import { takeTurns } from "./rounds.mjs";

/** Modes in each component. */
const MODES = [1, 4, 8];

/** How many times slower than Pasu a contender is to be at least, for each number of modes. */
const SLOWER = {
  [HAND_TUNED]: [3, 4, 5.5],
  [MIRRORED]: [3, 4, 5.5],
  [PLAIN_LOOPS]: [8, 13, 16],
  [CLOSED_FORM]: [60, 115, 170],
  [PARAMETRIC_GEOMETRY]: [160, 270, 380],
};

/** How many times slower than Pasu mirrored columns are to be at least where components have cosines and sines, and Pasu than where they have only one of the two at most. */
const OF_MIRRORED = 3;
const OF_APART = 1.96;
const APART = "Pasu, cosines and sines apart";
const OF_EASIER = { against: APART, at_most: OF_APART, note: `the ratio is to ${APART}, those below to this row` };

/** How many times slower than `memory.fill` Pasu is to be at most. */
const OF_FILL = [2.5, 4, 5];
const TURNED_OF_FILL = 1.5;

/** How many times longer than sampling `mesh()` is to take at most, for 512 x 512 cells into new arrays. */
const MESH_OF_SAMPLING = 4;

/** How many microseconds solving 64 modes in each component is to take at most. */
const SOLVING = 50;

/** The same through 64 rings, in milliseconds; and how many times longer than through 8: there are 65 stretches between rings and ends, and 9. */
const THROUGH_RINGS = 3;
const PER_RING = 65 / 9;

/** How many microseconds a pull is to take at most, of a pot of 8 rings with 16 modes in each component. */
const PULLING = 500;

/** How many parts are asked where they are, and how many milliseconds an answer is to take at most. */
const ASKED = 500;
const ANSWER = 1;

/** How many milliseconds solving and sampling a network of 10,000 patches within a thousandth of its size is to take at most. */
const NETWORK = 100;

/**
 * Measures and yields one group after the other.
 *
 * `bench` is the module of crates/bench-wasm and `pasu` the package, both loaded; `vase` and `turned` are the designs.
 */
export async function* groups({ bench, pasu, vase, turned }, { quick }) {
  const rounds = quick ? 3 : 15;
  for (const [index, modes] of MODES.entries()) yield await kernel(bench, firstModes(vase, modes), index, rounds);
  yield await everyWave(bench, withEveryWave(firstModes(vase, 4)), firstModes(vase, 4), rounds);
  yield await memory(bench, vase, turned, 2 * rounds + 1);
  yield await solving(bench, vase, 2 * rounds + 1);
  yield await rings(bench, vase, 2 * rounds + 1);
  yield await pulling(bench, pasu, withRings(firstModes(vase, 16), 8), 2 * rounds + 1);
  yield await asking(pasu, 20 * rounds);
  yield await networks(bench, rounds);
  yield await baseline(bench, firstModes(vase, 8), 2 * rounds + 1);
  for (const side of [65, 129, 257, 513]) yield await whole(bench, pasu, firstModes(vase, 4), side, rounds);
}

/** Sampling, against what else JavaScript could do. */
async function kernel(bench, design, index, rounds) {
  const targets = Object.fromEntries(Object.entries(SLOWER).map(([name, slower]) => [name, slower[index]]));
  return await sampling(`K = ${MODES[index]}`, bench, design, contenders, targets, rounds);
}

/** The same where every component has cosines and sines, and nothing can be left out; against as many modes, of which each component has one kind. */
async function everyWave(bench, design, apart, rounds) {
  const fast = (...grid) =>
    contenders(...grid).filter(({ name }) => [HAND_TUNED, MIRRORED, PLAIN_LOOPS].includes(name));
  const targets = { [MIRRORED]: OF_MIRRORED };
  return await sampling("K = 4 of cosines and as many of sines", bench, design, fast, targets, rounds, apart);
}

/** Sampling of a design, against what contenders make of it and, if there is one, sampling of another design. */
async function sampling(what, bench, design, contendersOf, targets, rounds, apart) {
  const side = 513;
  const subject = new bench.Subject(JSON.stringify(design));
  const easier = apart && new bench.Subject(JSON.stringify(apart));
  subject.show(side, side);
  const { positions, normals } = subject;
  const others = contendersOf(design, side, side);
  for (const other of others) {
    other.run();
    agree(other, { positions, normals });
  }
  const samples = await takeTurns(
    [
      { run: (times) => subject.sample(side, side, times) },
      { run: (times) => subject.solve(times) },
      ...others.map((other) => ({ ...other, run: (times) => repeat(other.run, times) })),
      ...(easier ? [{ run: (times) => easier.sample(side, side, times) }] : []),
    ],
    rounds,
  );
  subject.free();
  easier?.free();
  const perVertex = 1e6 / side ** 2;
  const rows = others.map(({ name }, other) => {
    const row = { name, samples: scaled(samples[other + 2], perVertex), against: "Pasu" };
    return name in targets ? { ...row, at_least: targets[name] } : row;
  });
  return {
    group: `Kernel, ${side - 1} x ${side - 1} cells, ${what}`,
    unit: "ns per vertex",
    rows: [
      { name: "Pasu", samples: scaled(samples[0], perVertex), ...(easier && OF_EASIER) },
      { name: "Pasu, of which solving", samples: scaled(samples[1], perVertex) },
      ...rows,
      ...(easier ? [{ name: APART, samples: scaled(samples.at(-1), perVertex) }] : []),
    ],
  };
}

/**
 * Sampling, against filling the memory that it writes: three numbers of four bytes each for position and normal.
 *
 * Both go to two blocks in turn: what is written stays in no cache, as in a page that hands one mesh over while it computes the next. In the same block again and
 * again, filling is twice as fast where a machine's last cache holds all of it, and where it does not it is not: the ratio would be one of caches.
 */
async function memory(bench, vase, turned, rounds) {
  const side = 1025;
  const inTurns = (make) => {
    const two = [make(), make()];
    let next = 0;
    return { two, other: () => two[next++ % 2] };
  };
  const blocks = inTurns(() => new bench.Memory(24 * side ** 2));
  const designs = [...MODES.map((modes) => firstModes(vase, modes)), turned];
  const names = [...MODES.map((modes) => `Pasu, K = ${modes}`), "Pasu, turned"];
  const subjects = designs.map((design) => inTurns(() => new bench.Subject(JSON.stringify(design))));
  const samples = await takeTurns(
    [
      { run: (times) => repeat(() => blocks.other().fill(1), times) },
      ...subjects.map(({ other }) => ({ run: (times) => repeat(() => other().sample(side, side, 1), times) })),
      { run: (times) => blocks.two[0].fill(times) },
    ],
    rounds,
  );
  for (const used of [blocks, ...subjects].flatMap(({ two }) => two)) used.free();
  const perVertex = 1e6 / side ** 2;
  const limits = [...OF_FILL, TURNED_OF_FILL];
  return {
    group: `Memory, ${side - 1} x ${side - 1} cells, 24 bytes a vertex`,
    unit: "ns per vertex",
    rows: [
      { name: FILL, samples: scaled(samples[0], perVertex) },
      ...names.map((name, index) => ({
        name,
        samples: scaled(samples[index + 1], perVertex),
        against: FILL,
        at_most: limits[index],
      })),
      { name: `${FILL}, the same block again`, samples: scaled(samples.at(-1), perVertex) },
    ],
  };
}

const FILL = "memory.fill";

/** Solving alone, of a design whose components share an equation and of one whose components do not. */
async function solving(bench, vase, rounds) {
  const text = JSON.stringify(vase);
  const subject = new bench.Subject(text);
  const alike = new bench.Subject(JSON.stringify(withOneEquation(vase)));
  const numerical = new bench.Baseline(text, 128, 256);
  const note = `128 x 256 points, error ${checkedError(numerical).toExponential(1)}`;
  const samples = await takeTurns(
    [subject, alike, numerical].map((solver) => ({ run: (times) => solver.solve(times) })),
    rounds,
  );
  for (const used of [subject, alike, numerical]) used.free();
  const [each, one, baseline] = samples.map((list) => scaled(list, 1e3));
  return {
    group: "Solving 64 modes per component",
    unit: "us",
    rows: [
      { name: "Pasu, an equation for each component", samples: each, median_at_most: SOLVING },
      { name: "Pasu, one equation for all", samples: one, median_at_most: SOLVING },
      {
        name: "finite differences, FFT and bands",
        samples: baseline,
        against: "Pasu, an equation for each component",
        note,
      },
    ],
  };
}

/** Solving through rings: in proportion to how many there are. */
async function rings(bench, vase, rounds) {
  const designs = [withRings(vase, 64), withRings(vase, 64, 0), withRings(vase, 8), vase];
  const subjects = designs.map((design) => new bench.Subject(JSON.stringify(design)));
  const samples = await takeTurns(
    subjects.map((subject) => ({ run: (times) => subject.solve(times) })),
    rounds,
  );
  for (const used of subjects) used.free();
  return {
    group: "Solving 64 modes per component through rings",
    unit: "ms",
    rows: [
      {
        name: "64 rings",
        samples: samples[0],
        against: "8 rings",
        at_most: PER_RING,
        median_at_most: THROUGH_RINGS,
      },
      { name: "64 rings, evenly spaced", samples: samples[1] },
      { name: "8 rings", samples: samples[2] },
      { name: "none", samples: samples[3] },
    ],
  };
}

/** A pull on a ring, and where one is put first; in the module, and by the package, from a plain object to the next. */
async function pulling(bench, pasu, design, rounds) {
  const text = JSON.stringify(design);
  const places = design.parts[0].shape.rings.map(({ u }) => u);
  const [on, between] = [places[3], (places[3] + places[4]) / 2];
  const subject = new bench.Subject(text);
  const pulls = [on, between].map((u) => new bench.Pulled(text, u));
  const read = pasu.parse(design);
  const [x, y, z] = pasu.evaluate(read, 0, [on, 0.3]);
  const hand = { at: [on, 0.3], to: [x + 0.2, y, z], width: 1 };
  const samples = await takeTurns(
    [
      { run: (times) => subject.solve(times) },
      ...pulls.map((pull) => ({ run: (times) => pull.pull(times) })),
      { run: (times) => repeat(() => pasu.pull(read, 0, hand), times), litters: true },
    ],
    rounds,
  );
  for (const used of [subject, ...pulls]) used.free();
  const [solve, ring, put, whole] = samples.map((list) => scaled(list, 1e3));
  const against = "solving";
  return {
    group: "Pulling a pot of 8 rings, 16 modes per component",
    unit: "us",
    rows: [
      { name: against, samples: solve },
      { name: "pull on a ring", samples: ring, against, median_at_most: PULLING },
      { name: "pull between rings", samples: put, against, median_at_most: PULLING },
      { name: "pull() of the package", samples: whole, against },
    ],
  };
}

/**
 * A ray and a point of many pots, other ones in every turn: each sample is one answer. Of an object it takes longer to see that it is the design of before than to answer; a text is that at once, and so is what is frozen through
 * and through.
 */
async function asking(pasu, turns) {
  const design = pasu.parse(pots(ASKED));
  const text = JSON.stringify(design);
  const stand = (turn) => design.parts[(37 * turn) % ASKED].place.shift;
  const ray = (turn) => {
    const [x, y] = stand(turn);
    return { origin: [x + 3, y - 2, 60], direction: [Math.sin(turn) / 5, Math.cos(turn) / 5, -1] };
  };
  const point = (turn) => {
    const [x, y] = stand(turn);
    return [x + 3 * Math.cos(turn), y + 3 * Math.sin(turn), 4 + 3 * Math.sin(2 * turn)];
  };
  const questions = [
    ["pick, design as text", () => text, pasu.pick, ray],
    ["at, design as text", () => text, pasu.at, point],
    ["pick, design as an object", () => design, pasu.pick, ray],
    ["at, design as an object", () => design, pasu.at, point],
  ];
  const rows = questions.map(([name, source, ask, about]) => {
    // Walls are found where they are met for the first time.
    const answers = (from) =>
      Array.from({ length: turns }, (_, turn) => timed(() => ask(source(), about(from + turn))));
    for (let from = 0; from < 4 * ASKED; from += turns) answers(from);
    return { name, samples: answers(0), median_at_most: ANSWER };
  });
  return { group: `Asked where they are, ${ASKED} different pots with walls`, unit: "ms", tail: true, rows };
}

function timed(run) {
  const start = performance.now();
  run();
  return performance.now() - start;
}

/** A network of 10,000 patches, and the same with the point in its middle moved, in turn: as a whole, and with the strips through that point alone. */
async function networks(bench, rounds) {
  const ways = [
    { name: "solving and sampling", after: false, sample: true, median_at_most: NETWORK },
    { name: "solving", after: false, sample: false },
    { name: "solving, a point moved", after: true, sample: false, against: "solving", note: "396 of 10,000 patches" },
    { name: "solving and sampling, a point moved", after: true, sample: true, against: "solving and sampling" },
  ];
  const subjects = ways.map(() => new bench.Network());
  const samples = await takeTurns(
    ways.map(({ after, sample }, way) => ({ run: (times) => subjects[way].run(after, sample, times) })),
    rounds,
  );
  for (const used of subjects) used.free();
  return {
    group: "A network of 10,000 patches, within a thousandth of its size",
    unit: "ms",
    rows: ways.map(({ after: _after, sample: _sample, ...row }, way) => ({ ...row, samples: samples[way] })),
  };
}

/** How far a numerical solution is off; refuses one that solves something else. */
function checkedError(numerical) {
  const error = numerical.error();
  if (!(error < 1e-3)) throw new Error(`finite differences are off by ${error}`);
  return error;
}

/** Solving and sampling, against a numerical solution on the same grid. */
async function baseline(bench, design, rounds) {
  const side = 128;
  const text = JSON.stringify(design);
  const subject = new bench.Subject(text);
  const numerical = new bench.Baseline(text, side, side);
  const note = `error ${checkedError(numerical).toExponential(1)}`;
  const samples = await takeTurns(
    [{ run: (times) => subject.sample(side, side, times) }, { run: (times) => numerical.solve(times) }],
    rounds,
  );
  for (const used of [subject, numerical]) used.free();
  const name = "Pasu, solved and sampled with normals";
  return {
    group: `Numerical baseline, ${side} x ${side}, K = 8, order 4`,
    unit: "ms",
    rows: [
      { name, samples: samples[0] },
      { name: "finite differences, FFT and bands", samples: samples[1], against: name, note },
    ],
  };
}

/** `mesh()` of the package, from a plain object to the caller's own arrays, against sampling alone. */
async function whole(bench, pasu, design, side, rounds) {
  const options = { rows: side, columns: side };
  const subject = new bench.Subject(JSON.stringify(design));
  subject.show(side, side);
  let into = pasu.mesh(design, options);
  agree({ name: "mesh()", ...into }, subject);
  const samples = await takeTurns(
    [
      { run: (times) => subject.sample(side, side, times) },
      { run: (times) => repeat(() => pasu.mesh(design, options), times), litters: true },
      { run: (times) => repeat(() => readAll(pasu.mesh(design, options)), times), litters: true },
      {
        run: (times) =>
          repeat(() => {
            into = pasu.mesh(design, { ...options, into });
          }, times),
      },
      {
        run: (times) =>
          repeat(() => {
            into = pasu.mesh(design, { ...options, into });
            return [new Float32Array(into.positions), new Float32Array(into.normals)];
          }, times),
        litters: true,
      },
      { run: (times) => repeat(() => [into.positions, into.normals].map(filledAnew), times), litters: true },
    ],
    rounds,
  );
  subject.free();
  const name = "sampling alone";
  return {
    group: `Whole way, ${side - 1} x ${side - 1} cells, K = 4`,
    unit: "ms",
    rows: [
      { name, samples: samples[0] },
      { name: "mesh()", samples: samples[1], against: name, ...(side === 513 && { at_most: MESH_OF_SAMPLING }) },
      { name: "mesh(), all arrays read", samples: samples[2], against: name },
      { name: "mesh() into the arrays of the last", samples: samples[3], against: name },
      { name: "the same, then copied into new arrays", samples: samples[4], against: name },
      { name: "new arrays of that size, filled", samples: samples[5], against: name },
    ],
  };
}

/** What depends on the grid alone is copied when it is read. */
function readAll({ uvs, indices, groups }) {
  return uvs.length + indices.length + groups.length;
}

/** A new array of the same size, all of it written: what no way into new arrays can take less than. */
function filledAnew({ length }) {
  return new Float32Array(length).fill(1);
}

function repeat(run, times) {
  for (let i = 0; i < times; i++) run();
}

function scaled(samples, factor) {
  return samples.map((sample) => sample * factor);
}
