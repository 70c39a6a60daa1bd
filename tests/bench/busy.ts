// What the thread of a page does while a hand moves, by Chromium's own trace.

import type { Browser } from "playwright-core";

/** One event of Chromium's trace; times in microseconds. */
interface Traced {
  readonly name: string;
  readonly ph: string;
  readonly pid: number;
  readonly tid: number;
  readonly ts: number;
  readonly dur?: number;
  /** Of the thread's processor time. */
  readonly tdur?: number;
  readonly args?: { readonly data?: { readonly type?: string } };
}

/** For each movement of the pointer in between the processor time of the page's thread, in milliseconds, until the next; without waiting for what draws. */
async function busyWhile(browser: Browser, act: () => Promise<void>): Promise<readonly number[]> {
  const session = await browser.newBrowserCDPSession();
  const events: Traced[] = [];
  session.on("Tracing.dataCollected", ({ value }) => events.push(...(value as unknown as Traced[])));
  const over = new Promise<void>((resolve) => session.on("Tracing.tracingComplete", () => resolve()));
  await session.send("Tracing.start", {
    traceConfig: { includedCategories: ["toplevel", "devtools.timeline", "gpu"], excludedCategories: ["*"] },
  });
  await act();
  await session.send("Tracing.end");
  await over;
  await session.detach();
  const moves = events.filter(({ name, args }) => name === "EventDispatch" && args?.data?.type === "pointermove");
  const thread = moves[0];
  if (!thread) throw new Error("no movement was traced");
  const own = events.filter(({ ph, pid, tid }) => ph === "X" && pid === thread.pid && tid === thread.tid);
  const spent = (name: string, from: number, to: number) =>
    own
      .filter((each) => each.name === name && each.ts >= from && each.ts < to)
      .reduce((sum, { dur = 0, tdur = dur }) => sum + tdur / 1000, 0);
  // A task begins before the event that it tells of.
  const starts = moves.map(
    ({ ts }) =>
      own.findLast(
        (each) => each.name === "ThreadControllerImpl::RunTask" && each.ts <= ts && each.ts + (each.dur ?? 0) > ts,
      )?.ts ?? ts,
  );
  return starts.slice(0, -1).map((from, index) => {
    const to = starts[index + 1] ?? from;
    return spent("ThreadControllerImpl::RunTask", from, to) - spent("ImplementationBase::WaitForCmd", from, to);
  });
}

/**
 * For each movement of so many drags what the page's thread would take for it if it were so many times slower, in milliseconds. The page is to be one that counts no frames: to count them keeps it making them, which is work that no page of a
 * person has. What slows a thread down goes by the clock, and on a busy machine slows it down more than it should: so its processor time is taken, and multiplied.
 */
export async function busyOfDrags(
  browser: Browser,
  drags: number,
  slower: number,
  drag: () => Promise<void>,
): Promise<readonly number[]> {
  const busy: number[] = [];
  for (let turn = 0; turn < drags; turn += 1) busy.push(...(await busyWhile(browser, drag)));
  return busy.map((each) => slower * each);
}
