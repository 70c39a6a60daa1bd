// Contenders that take turns, so that whatever else the machine does meets all of them alike.

/** A batch of one contender lasts at least so long, in milliseconds: much longer than a step of the browser's clock. */
const BATCH = 20;
/** How long each contender runs before it counts, in milliseconds, so that its code has been compiled for speed. */
const WARM_UP = 400;

/**
 * Lets all contenders take so many turns and returns, for each, the milliseconds of doing its work once, in every round.
 *
 * A contender is `{ name, run(times) }`; one that `litters` has its garbage collected before the next one's turn, where the engine lets itself be asked.
 */
export async function takeTurns(contenders, rounds, warmth = WARM_UP) {
  const batches = contenders.map((contender) => {
    const times = warmUp(contender, warmth);
    tidyUp(contender);
    return { ...contender, times, samples: [] };
  });
  for (let round = 0; round < rounds; round++) {
    for (let turn = 0; turn < batches.length; turn++) {
      // Nobody always runs after the same neighbour's leavings in the cache.
      const batch = batches[(turn + round) % batches.length];
      await pause();
      const start = performance.now();
      batch.run(batch.times);
      batch.samples.push((performance.now() - start) / batch.times);
      tidyUp(batch);
    }
  }
  return batches.map(({ samples }) => samples);
}

/** Runs a contender until it is warm; returns how many times make a batch. */
function warmUp({ run }, warmth) {
  const start = performance.now();
  let times = 1;
  let enough = 1;
  for (let turn = 0; turn < 3 || performance.now() - start < warmth; turn++) {
    const before = performance.now();
    run(times);
    const taken = performance.now() - before;
    if (taken < BATCH) times *= 2;
    enough = Math.max(1, Math.ceil((times * BATCH) / Math.max(taken, 1e-3)));
    if (taken >= BATCH) times = Math.max(1, Math.min(times, enough));
  }
  return Math.min(enough, times * 2);
}

function tidyUp({ litters }) {
  if (litters) globalThis.gc?.();
}

/** Lets the browser do its own work between the turns. */
function pause() {
  return new Promise((resolve) => setTimeout(resolve));
}
